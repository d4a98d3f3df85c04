"""For the tests of spline libraries: is a program of your own right?

    from knotproof.testing import check_basis

    def test_my_basis():
        check_basis(my_basis, rtol=1e-12)

In pytest ``check_basis`` is a fixture as well. ``pip install "knotproof[pytest]"`` installs what it needs.
"""

from __future__ import annotations

import math
import numbers
from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction
from itertools import accumulate, groupby, product
from typing import TYPE_CHECKING, Any, Literal

from ._basis import Basis
from ._exact import Exact, Side, is_left, whole

if TYPE_CHECKING:
    from hypothesis.strategies import DrawFn

__all__ = ["check_basis"]

Knots = tuple[Fraction, ...]

#: The highest multiplicity of a knot, above k.
ABOVE_DEGREE = {"k": 0, "k+1": 1, "k+2": 2}
#: Up to this degree all small knots are tried.
SMALL_DEGREE = 2


class _Differs(Exception):
    """What ``f`` gave is not what is exact; an exception that ``f`` raised is its cause."""


def check_basis(
    f: Callable[..., Any],
    *,
    degrees: Sequence[int] = range(6),
    nu: int = 0,
    side: Side = "right",
    last: Literal["left", "right", "skip"] = "left",
    domain: Literal["base", "support", "line"] = "base",
    multiplicity: Literal["k", "k+1", "k+2"] = "k+2",
    clamped: bool = False,
    spread: int = 60,
    alpha: Exact | float = "inf",
    number: Callable[[Fraction], Any] = float,
    rtol: float | None = None,
    ulp: float | None = None,
    examples: int | None = None,
) -> None:
    """Holds a function that evaluates a basis against exact values; what it gets wrong is shrunk to small knots.

    First on all small knots, the smallest first, and then on random ones: Hypothesis draws and shrinks them. Of each basis x are all
    knots, places in each span, and a random one.

    f
        ``f(knots, degree, x)`` gives (G_0(x), …, G_n(x)), all of them, in any sequence; with ``nu`` > 0 ``f(knots, degree, x, order)`` gives
        their derivatives of that order. A program for one function is ``lambda t, k, x: [g(t, k, i, x) for i in range(len(t) - k - 1)]``.
    degrees, nu
        the degrees k, and the highest order of derivatives: 0, …, nu are asked for.
    side
        of which side ``f`` takes limits at knots. With "left" the first knot of the domain is not asked for.
    last
        what ``f`` gives at the last knot of the domain, whatever ``side`` is: "left", the limit from inside, as SciPy, and at t_m ``Basis.B``; "right",
        as the recursion on half-open intervals says, at t_m that is 0; "skip", it is not asked for.
    domain
        of which x it is asked: "base", [t_k, t_{n+1}]; "support", [t_0, t_m]; "line", also outside, where all functions are 0.
    multiplicity, clamped
        the highest multiplicity of a knot; and have the end knots k + 1 copies at least?
    spread
        gaps lie between 2^−spread and 2^spread; with 0 they are 1 to 4. Up to 60.
    alpha
        the index of the basis; "inf" is polynomial B-splines.
    number
        what makes the numbers that ``f`` is given: ``float``, or ``Fraction``, or a type of yours. All numbers are exact as floats.
    rtol, ulp
        how far a float may be from the exact value: ``rtol`` times the largest value at this x, or ``ulp`` units in the last place of the value
        itself. Integers and fractions have to be equal.
    examples
        how many random bases: those of the profile of Hypothesis if it is not given.

    ``AssertionError`` names the knots, the degree, x, nu, the exact value, and what ``f`` gave or raised. ``ValueError`` for an
    argument that can't be.

    >>> check_basis(lambda t, k, x: Basis(t, k, alpha="inf").B(x), number=Fraction, domain="line", examples=20)
    """
    __tracebackhide__ = True
    try:
        from hypothesis import HealthCheck, Phase, given, settings
        from hypothesis import strategies as st
    except ImportError as error:
        raise ImportError('check_basis takes Hypothesis: pip install "knotproof[pytest]"') from error

    ks, nu = [whole(k, f"degrees[{place}]") for place, k in enumerate(degrees)], whole(nu, "nu")
    choices: dict[str, tuple[str, list[str]]] = {
        "last": (last, ["left", "right", "skip"]),
        "domain": (domain, ["base", "support", "line"]),
        "multiplicity": (multiplicity, list(ABOVE_DEGREE)),
    }
    for name, (given_name, names) in choices.items():
        if given_name not in names:
            raise ValueError(f"{name}: {given_name!r} is none of {', '.join(names)}")
    if not ks:
        raise ValueError("degrees: there are none; give some, such as range(4)")
    if clamped and multiplicity == "k":
        raise ValueError("multiplicity: clamped knots have k + 1 copies of the end knots; leave clamped away, or allow k+1")
    if not 0 <= spread <= 60:
        raise ValueError(f"spread: {spread} is not between 0 and 60")
    if rtol is not None and ulp is not None:
        raise ValueError("ulp: it takes the place of rtol; leave one of them away")
    left = is_left(side)
    above = ABOVE_DEGREE[multiplicity]

    def places(knots: Knots, k: int, drawn: Sequence[Fraction] = ()) -> Iterator[tuple[Fraction, bool | None]]:
        """Each x, and of which side limits are taken; ``None`` where it is 0 by convention."""
        base = domain == "base"
        start, end = (knots[k], knots[-k - 1]) if base else (knots[0], knots[-1])
        if start >= end:
            return
        stops = [t for t, _ in groupby(knots) if start <= t <= end]
        for x in stops:
            if x == end:
                if last != "skip":
                    yield x, True if last == "left" else None if x == knots[-1] else False
            elif x > start or not left:
                yield x, left
        for a, b in zip(stops, stops[1:]):
            # What is asked is a number that a float has.
            inside = [Fraction(float(a + (b - a) * part)) for part in (Fraction(1, 2), Fraction(1, 8), Fraction(3, 4))]
            yield from ((x, False) for x in inside if a < x < b)
        yield from ((x, False) for x in drawn if start < x < end and x not in stops)
        if domain == "line":
            yield from ((x, None) for x in (start - (end - start), end + (end - start)) if Fraction(float(x)) == x)

    def compare(knots: Knots, k: int, drawn: Sequence[Fraction] = ()) -> None:
        basis = Basis(knots, k, alpha=alpha)
        for x, of_left in places(knots, k, drawn):
            for order in range(nu + 1):
                exact = (Fraction(0),) * len(basis)
                if of_left is not None:
                    exact = basis.B(x, order, "left" if of_left else "right")
                told = _Told(basis, x, order, of_left)
                arguments = [[number(t) for t in knots], k, number(x), *([order] if nu else [])]
                try:
                    given_ = list(f(*arguments))
                except Exception as error:
                    raise _Differs(told.raised(error)) from error
                if len(given_) != len(exact):
                    raise _Differs(told.all(exact, given_, f"f gave {len(given_)} values, and there are {len(exact)} functions"))
                largest = max(map(abs, exact))
                for i, (want, got) in enumerate(zip(exact, given_)):
                    if not _agree(want, got, largest, rtol, ulp):
                        raise _Differs(told.value(exact, given_, i))

    @st.composite
    def random(draw: DrawFn) -> tuple[Knots, int, list[Fraction]]:
        k = draw(st.sampled_from(ks))
        most = max(k + above, 1)
        copies = [draw(st.integers(1, most)) for _ in range(draw(st.integers(2, 6)))]
        if clamped:
            copies[0], copies[-1] = (draw(st.integers(k + 1, most)) for _ in range(2))
        # At least so many are knots of this degree.
        copies[1:1] = [1] * (max(2 * k + 1, k + 2) - sum(copies))
        gaps = st.integers(1, 4).map(float)
        if spread:
            gaps |= st.integers(1, spread).map(lambda e: 2.0**e) | st.integers(1, spread).map(lambda e: 2.0**-e)
        knots, t = [], draw(st.sampled_from([0.0, -3.5, *([2.0**40] if spread >= 40 else [])]))
        for count in copies:
            knots += [Fraction(t)] * count
            # What is too small to be added becomes a gap to the next float.
            t = max(t + draw(gaps), math.nextafter(t, math.inf))
        at, share = draw(st.integers(0, len(knots) - 2)), Fraction(draw(st.integers(1, 63)), 64)
        x = knots[at] + (knots[at + 1] - knots[at]) * share
        return tuple(knots), k, [Fraction(float(x))]

    # Whatever is drawn is right, f may take its time, and what is told is one case.
    profile = settings(
        settings.default,
        database=None,
        deadline=None,
        phases=[Phase.generate, Phase.shrink],
        report_multiple_bugs=False,
        suppress_health_check=list(HealthCheck),
    )
    if examples is not None:
        profile = settings(profile, max_examples=whole(examples, "examples"))

    @profile
    @given(random())
    def on_random(case: tuple[Knots, int, list[Fraction]]) -> None:
        compare(*case)

    try:
        for knots, k in _small(ks, above, clamped):
            compare(knots, k)
        on_random()
    except _Differs as differs:
        failure, cause = str(differs), differs.__cause__
    else:
        return
    raise AssertionError(failure) from cause


def _small(degrees: Sequence[int], above: int, clamped: bool) -> Iterator[tuple[Knots, int]]:
    """All small knots, with gaps of 0 and 1: few before many, and of as many those with few spans first."""
    for k in (k for k in degrees if k <= SMALL_DEGREE):
        least = max(2 * k + 1, k + 2)
        for count in range(least, least + 3):
            for gaps in sorted(product((0, 1), repeat=count - 1), key=sum):
                knots = tuple(Fraction(t) for t in accumulate(gaps, initial=0))
                most = max(len(list(copies)) for _, copies in groupby(knots))
                is_clamped = knots[0] == knots[k] and knots[-k - 1] == knots[-1]
                if most <= max(k + above, 1) and knots[0] < knots[-1] and (is_clamped or not clamped):
                    yield knots, k


def _agree(want: Fraction, got: Any, largest: Fraction, rtol: float | None, ulp: float | None) -> bool:
    if isinstance(got, numbers.Rational):
        return Fraction(int(got.numerator), int(got.denominator)) == want
    if not isinstance(got, numbers.Real):
        raise TypeError(f"f: {got!r} is no real number: give floats, integers or fractions")
    if rtol is None and ulp is None:
        raise ValueError("rtol is missing: f gives floats, so say how close they have to be, such as rtol=1e-12 or ulp=8")
    if not math.isfinite(got):
        return False
    allowed = Fraction(rtol) * largest if rtol is not None else Fraction(ulp or 0) * Fraction(math.ulp(float(want)))
    return abs(Fraction(float(got)) - want) <= allowed


class _Told:
    """Where something differs, in words."""

    def __init__(self, basis: Basis, x: Fraction, order: int, left: bool | None) -> None:
        self.basis, self.x, self.order, self.left = basis, x, order, left

    def value(self, exact: Sequence[Fraction], given: Sequence[Any], i: int) -> str:
        head = f"G_{i} is {_number(exact[i])}, and f gave {given[i]}"
        if self.order:
            head = f"the derivative of order {self.order} of {head}"
        return self.all(exact, given, head)

    def all(self, exact: Sequence[Fraction], given: Sequence[Any], head: str) -> str:
        rows = [("exactly", ", ".join(map(_number, exact))), ("f gave", ", ".join(map(str, given)))]
        if self.left is not None:
            side = ', side="left"' if self.left else ""
            order = f", {self.order}" if self.order else ""
            rows.append(("again", f'{self.basis!r}.B("{self.x}"{order}{side})'))
        return self._told(head, rows)

    def raised(self, error: Exception) -> str:
        return self._told(f"f raised {type(error).__name__}: {error}", [])

    def _told(self, head: str, rows: Sequence[tuple[str, str]]) -> str:
        knots, basis = self.basis.knots, self.basis
        if self.x in knots:
            side = "from the left" if self.left else "from the right"
            multiplicity = basis.multiplicity(self.x)
            where = f"{_number(self.x)}, {side} at a knot of multiplicity {multiplicity}"
        else:
            where = f"{_number(self.x)}, no knot"
        place = [("knots", f"({', '.join(map(str, knots))})"), ("degree", str(basis.degree)), ("x", where), ("nu", str(self.order))]
        return "\n".join([head, *(f"  {name:7} {text}" for name, text in [*place, *rows])])


def _number(value: Fraction) -> str:
    """Exactly, and if that says little, in digits too."""
    text = str(value)
    return text if len(text) <= 12 else f"{text} ≈ {float(value)!r}"
