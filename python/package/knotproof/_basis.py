"""Bases, and their functions."""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from typing import TYPE_CHECKING, Any, Literal

from . import _native
from ._exact import Exact, Setting, Side, exact, exacts, index, is_left, rows, shown, whole
from ._measure import Collocation, positive
from ._verdict import Verdicts, read

if TYPE_CHECKING:
    import numpy
    import scipy.sparse
    import sympy

    from ._curve import Curve

#: The longest interval for what is not known exactly, if none is given.
WIDTH = Fraction(1, 2**20)
#: What stands between x and the right end of a piece that it does not belong to, or does.
BELOW_END = ("<", r"\le")


@dataclass(frozen=True)
class Family:
    """A family of weights: ``Basis(knots, degree, family=name, **parameters)``."""

    name: str
    title: str
    parameters: tuple[str, ...]


def families() -> tuple[Family, ...]:
    """The families that there are. A TOML file of your own is named by its path: see docs/language.md of the project."""
    return tuple(Family(name, title, tuple(heads)) for name, title, heads in _native.families())


@dataclass(frozen=True)
class Piece:
    """A function on one interval: numerator/denominator on [start, end), or on [start, end] if it is ``closed``.

    Both are given by their coefficients, by rising powers of x; they have no common factor.
    """

    start: Fraction
    end: Fraction
    closed: bool
    numerator: tuple[Fraction, ...]
    denominator: tuple[Fraction, ...]
    text: str = field(compare=False)
    latex: str = field(compare=False, repr=False)

    def __call__(self, x: Exact) -> Fraction:
        """Its value at x, exactly, wherever x lies."""
        x = exact(x, "x")
        above, below = (sum((c * x**e for e, c in enumerate(of)), Fraction(0)) for of in (self.numerator, self.denominator))
        return above / below

    def __str__(self) -> str:
        return f"{self.text} on [{self.start}, {self.end}{']' if self.closed else ')'}"

    def _repr_latex_(self) -> str:
        return f"${self.latex}$"


class Pieces(tuple[Piece, ...]):
    """The pieces of a function from left to right; elsewhere it is 0."""

    def __repr__(self) -> str:
        return "\n".join(str(piece) for piece in self) or "0"

    def _repr_latex_(self) -> str:
        cases = [
            rf"{piece.latex} & {piece.start} \le x {BELOW_END[piece.closed]} {piece.end}"
            for piece in self
        ]
        return r"$\begin{cases}" + r" \\ ".join([*cases, r"0 & \text{elsewhere}"]) + r"\end{cases}$"


@dataclass(frozen=True)
class Extremum:
    """A local maximum or minimum.

    ``interval`` has exact bounds of the place, equal if it is known exactly, or the ends of a plateau, and ``value`` bounds of the
    value there; ``x`` and ``height`` are their first digits, all right.
    """

    kind: Literal["maximum", "minimum"]
    interval: tuple[Fraction, Fraction]
    plateau: bool
    at_knot: bool
    value: tuple[Fraction, Fraction]
    x: str
    height: str


@dataclass(frozen=True)
class Jump:
    """A knot where a function jumps, with its limits from below and from above."""

    at: Fraction
    left: Fraction
    right: Fraction


@dataclass(frozen=True)
class Slopes:
    """The slopes of a function on both sides of a knot; ``None`` where nothing lies on that side."""

    at: Fraction
    left: Fraction | None
    right: Fraction | None


@dataclass(frozen=True)
class Shape:
    """How a function rises and falls: for every x, exactly.

    ``largest_once`` says whether the largest value is taken at one place only; ``None`` where that is not decided.
    """

    index: int
    support: tuple[Fraction, Fraction]
    extrema: tuple[Extremum, ...]
    jumps: tuple[Jump, ...]
    slopes: tuple[Slopes, ...]
    largest_once: bool | None

    @property
    def maxima(self) -> tuple[Extremum, ...]:
        """The local maxima, from left to right; a plateau is one."""
        return tuple(extremum for extremum in self.extrema if extremum.kind == "maximum")

    @property
    def minima(self) -> tuple[Extremum, ...]:
        """The local minima inside the support."""
        return tuple(extremum for extremum in self.extrema if extremum.kind == "minimum")


class Basis:
    """The basis functions G_0, …, G_n of degree k on the knots t_0 ≤ … ≤ t_m, n = m − k − 1.

    G_i^0 = 1 on [t_i, t_{i+1}) and 0 elsewhere; G_i^d = w_i^d G_i^{d−1} + (1 − w_{i+1}^d) G_{i+1}^{d−1}. The weight w_i^d rises
    from 0 at t_i to 1 at t_{i+d}. With an index α it is α(x − a)/(x + (α − 1)b − αa) on [a, b); α = inf gives the polynomial
    B-splines of SciPy. Other families have other weights: ``families()``.

    knots
        a list of exact numbers, or a text of them: ``"0 0 0 1/2 1 1 1"``; at least 2k + 1 and at least k + 2, in order, not all
        equal. Any multiplicity: a function whose knots are all equal is 0, and at a knot of more than k copies functions may jump.
    degree
        k, from 0 up.
    family
        "mobius" (the one with α), another name, or the path of a file.
    alpha
        α < 0, α > 1, or infinity, be it "inf", ``math.inf``, ``-math.inf`` or ``sympy.oo``: infinity is no rounded number.
    parameters
        those of another family: a number ``q="1/2"``, a list ``omega=[1, 2, 1]``, a list for each d.

    Numbers are ``int``, ``Fraction``, ``Decimal``, texts or SymPy's rationals. ``TypeError`` for a float, ``ValueError`` for what
    is no knot vector, index or parameter.

    >>> Basis("0 0 1 1", 1, alpha=2).B("1/2")
    (Fraction(1, 3), Fraction(2, 3))
    """

    __slots__ = ("_native",)
    _native: _native.Basis

    def __init__(
        self,
        knots: str | Iterable[Exact],
        degree: int,
        family: str | os.PathLike[str] = "mobius",
        alpha: Exact | float | None = None,
        **parameters: Setting,
    ) -> None:
        if not isinstance(family, (str, os.PathLike)):
            raise TypeError(f"family: {family!r} is no name; if it is an index, write alpha={family!r}")
        name = os.fspath(family)
        if name == "mobius" and alpha is None and not parameters:
            raise ValueError(
                'alpha is missing: give the index, such as alpha=-1, or alpha="inf" for polynomial B-splines; or name another '
                "family"
            )
        if name == "mobius" and alpha is not None and parameters:
            raise ValueError(f"alpha: it says all that mobius needs; leave {', '.join(parameters)} away")
        if name != "mobius" and alpha is not None:
            # Another family may have a parameter of this name.
            parameters["alpha"], alpha = alpha, None  # type: ignore[assignment]
        settings = [(parameter, rows(setting, parameter)) for parameter, setting in parameters.items()]
        self._native = _native.Basis(
            exacts(knots, "knots"), whole(degree, "degree"), name, None if alpha is None else index(alpha), settings
        )

    @classmethod
    def of_instance(cls, name: str, degree: int | None = None, alpha: Exact | float | None = None) -> Basis:
        """The paper's instance of this name, such as "U4": its knots and, if they are not given, its degree and its α.

        Where the paper shows it for several degrees or several α, one has to be given: ``ValueError`` says which there are.
        """
        chosen, knots, indices, _ = _native.instance(name, None if degree is None else whole(degree, "degree"))
        if alpha is None:
            if len(indices) != 1:
                raise ValueError(f"alpha: the paper shows {name} for {', '.join(indices)}: choose one, such as alpha={indices[0]!r}")
            alpha = indices[0]
        return cls(knots, chosen, alpha=alpha)

    @classmethod
    def _with(cls, knots: Sequence[Fraction], degree: int, name: str, parameters: Iterable[tuple[str, str]]) -> Basis:
        """With parameters as the command line has them."""
        basis = cls.__new__(cls)
        settings = [(own, [exacts(row, own) for row in text.split(";")]) for own, text in parameters]
        basis._native = _native.Basis(list(knots), degree, name, None, settings)
        return basis

    @property
    def knots(self) -> tuple[Fraction, ...]:
        """t_0, …, t_m."""
        return tuple(self._native.knots)

    @property
    def degree(self) -> int:
        """k."""
        return self._native.degree

    @property
    def n(self) -> int:
        """The index of the last function: m − k − 1."""
        return self._native.n

    @property
    def alpha(self) -> Fraction | Literal["inf"] | None:
        """α, "inf" for infinity; ``None`` for another family."""
        alpha = self._native.alpha
        if alpha is None:
            return None
        return "inf" if alpha == "inf" else Fraction(alpha)

    @property
    def family(self) -> str:
        """The name of the family; of every index it is "mobius"."""
        member = self._native.member
        return "mobius" if member is None else member[0]

    @property
    def parameters(self) -> dict[str, str]:
        """What another family is set to."""
        member = self._native.member
        return {} if member is None else dict(member[1])

    @property
    def interval(self) -> tuple[Fraction, Fraction]:
        """[t_k, t_{n+1}], where the functions add up to 1."""
        knots = self.knots
        return knots[self.degree], knots[self.n + 1]

    def multiplicity(self, x: Exact) -> int:
        """How often x is among the knots."""
        return self._native.multiplicity(exact(x, "x"))

    def support(self, i: int) -> tuple[Fraction, Fraction]:
        """[t_i, t_{i+k+1}], outside of which G_i is 0."""
        return self._native.support(self._function(i))

    def B(self, x: Exact, nu: int = 0, side: Side = "right") -> tuple[Fraction, ...]:  # noqa: N802: as SciPy and books call it
        """(G_0(x), …, G_n(x)), or with ``nu`` their derivatives of that order: exactly, as limits from a side.

        At t_m, where the recursion says 0, every limit is the one from the left. Outside of [t_0, t_m] all are 0, as the recursion
        says, and so is the limit from the left at t_0. At a knot of more than k copies both sides differ.

        ``TypeError`` for a float; for arrays of floats there is ``design_matrix``.
        """
        return tuple(self._native.values(exact(x, "x"), whole(nu, "nu"), is_left(side)))

    def pieces(self, i: int) -> Pieces:
        """G_i as quotients of polynomials, one for each interval between knots where it is not 0. Up to degree 20."""
        pieces = self._native.pieces(self._function(i))
        made = [
            Piece(start, end, closed, tuple(above), tuple(below), _quotient(*text), rf"\frac{{{latex[0]}}}{{{latex[1]}}}")
            for (start, end), closed, (above, below), (text, latex) in pieces
        ]
        return Pieces(made)

    def to_sympy(self, i: int | None = None) -> Any:
        """G_i as a ``Piecewise`` of SymPy in the real symbol x; without ``i`` the list of all. Up to degree 20."""
        program = self._native.formula(None if i is None else self._function(i), True)
        names: dict[str, Any] = {}
        exec(program, names)  # noqa: S102: the text of knotproof formula --as sympy
        functions: dict[int, sympy.Expr] = names["G"]
        return list(functions.values()) if i is None else functions[self._function(i)]

    def to_latex(self, i: int | None = None) -> str:
        """The same in LaTeX with the package amsmath: one displayed equation a function."""
        return self._native.formula(None if i is None else self._function(i), False)

    def shape(self, i: int, width: Exact = WIDTH) -> Shape:
        """How G_i rises and falls, for every x: its maxima and minima, jumps, and slopes at knots.

        What is not rational is enclosed in an interval of at most ``width`` > 0. ``ValueError`` for a function of another family
        that is negative somewhere.
        """
        i = self._function(i)
        extrema, jumps, slopes, once = self._native.shape(i, positive(width, "width"))
        made = [
            Extremum(kind, place, plateau, at_knot, value, *digits)  # type: ignore[arg-type]
            for kind, place, plateau, at_knot, value, digits in extrema
        ]
        return Shape(
            i,
            self.support(i),
            tuple(made),
            tuple(Jump(*jump) for jump in jumps),
            tuple(Slopes(*slope) for slope in slopes),
            once,
        )

    def check(
        self, *claims: str, sentence: str | None = None, paper: str | os.PathLike[str] | None = None, classical: bool = False
    ) -> Verdicts:
        """Decides claims on this basis, for every x: the paper's, or with ``claims`` those of these identifiers.

        sentence
            one of your own in the language of docs/language.md: ``"i in 0..n; x in [t[0], t[m]] : G[i](x) <= 1"``;
        paper
            the claims of this paper, a folder or a name;
        classical
            the classical properties of B-splines; for another family than that of an index they are what is asked.

        Where a claim is refuted as printed, its verdict has that on the ``amended`` statement.
        """
        return self._check(None, claims, sentence, paper, classical)

    def _check(
        self,
        points: list[list[Fraction]] | None,
        claims: Sequence[str],
        sentence: str | None,
        paper: str | os.PathLike[str] | None,
        classical: bool,
    ) -> Verdicts:
        if sentence is not None and (claims or classical or paper is not None):
            raise ValueError("sentence: it stands alone: leave away what else is asked for")
        named = None if paper is None else os.fspath(paper)
        return Verdicts(read(text) for text in self._native.check(list(claims), sentence, named, classical, points))

    def curve(self, points: Iterable[Any]) -> Curve:
        """The curve Σ d_i G_i with control points d_0, …, d_n: numbers, or lists of up to three coordinates each."""
        from ._curve import Curve

        return Curve(self, points)

    def interpolate(self, at: str | Iterable[Exact], points: Iterable[Any]) -> Curve:
        """The curve that has these points at the places x_0 < … < x_n of ``at``, in [t_0, t_m]: exactly. Points are as for ``curve``.

        ``ValueError`` where there is not exactly one: ``collocation`` shows why; and for other numbers of places or points than n + 1.

        >>> Basis("0 0 0 1 1 1", 2, alpha="inf").interpolate("0 1/2 1", [0, 1, 0]).points
        (Fraction(0, 1), Fraction(2, 1), Fraction(0, 1))
        """
        from ._curve import Curve, _points

        through, plain = _points(points)
        controls = self._native.interpolate(exacts(at, "at"), through)
        return Curve(self, [point[0] for point in controls] if plain else controls)

    def collocation(self, at: str | Iterable[Exact]) -> Collocation:
        """The values of all functions at the places x_0 < x_1 < … of ``at``, in [t_0, t_m], as a matrix with its rank and determinant: exactly.

        Values are those from the right, at t_m from the left. ``ValueError`` for places out of order or outside.
        """
        places = exacts(at, "at")
        rows, rank, determinant, misplaced, relation = self._native.collocation(places)
        matrix = tuple(tuple(row) for row in rows)
        return Collocation(
            tuple(places), matrix, rank, determinant, tuple(misplaced), None if relation is None else tuple(relation)
        )

    def design_matrix(self, x: Any, extrapolate: bool = False) -> scipy.sparse.csr_array:
        """The values of all functions at an array of floats, as SciPy's ``BSpline.design_matrix`` gives them: a CSR array with a
        row for each x and k + 1 entries in each.

        For α = inf they are SciPy's; right limits, and at t_{n+1} left ones. Of an index the numbers of the basis are rounded to
        floats first, and then each value is the exact one, rounded once or hardly more; of another family all is exact until the
        end, and slower. Degrees up to 31.

        ``ValueError`` for an x outside of [t_k, t_{n+1}], as SciPy's, and for ``extrapolate``: outside of it functions with an index
        may have poles.
        """
        if extrapolate:
            raise ValueError(
                "extrapolate: outside of [t_k, t_(n+1)] the pieces of rational functions may have poles, so there is nothing to "
                "continue them with; leave those x away"
            )
        import numpy
        from scipy.sparse import csr_array

        points = _floats(x)
        start, end = (float(t) for t in self.interval)
        outside = ~((points >= start) & (points <= end))
        if outside.any():
            raise ValueError(f"x: {points[outside][0]} is not in [t_k, t_(n+1)] = [{start}, {end}], where the functions add up to 1")
        first, values = self._native.floats(points.tobytes())
        columns = numpy.frombuffer(first, numpy.int64)[:, None] + numpy.arange(self.degree + 1)
        offsets = numpy.arange(len(points) + 1) * (self.degree + 1)
        data = numpy.frombuffer(values, float).copy()
        return csr_array((data, columns.ravel(), offsets), shape=(len(points), self.n + 1))

    def _function(self, i: int) -> int:
        i = whole(i, "i")
        if i > self.n:
            raise IndexError(f"i: there is no function {i}: the basis has the functions 0 to {self.n}")
        return i

    def _key(self) -> tuple[Any, ...]:
        return self.knots, self.degree, self._native.alpha, self._native.member and tuple(self.parameters.items()), self.family

    def __len__(self) -> int:
        """n + 1, the number of functions."""
        return self.n + 1

    def __eq__(self, other: object) -> bool:
        return self._key() == other._key() if isinstance(other, Basis) else NotImplemented

    def __hash__(self) -> int:
        return hash(self._key())

    def __repr__(self) -> str:
        knots = " ".join(str(t) for t in self.knots)
        alpha = self.alpha
        if alpha is not None:
            of = f"alpha={shown(alpha)}" if isinstance(alpha, Fraction) else 'alpha="inf"'
        else:
            settings = [f"{name}={_setting(text)}" for name, text in self.parameters.items()]
            of = ", ".join([f'family="{self.family}"', *settings])
        return f'Basis("{knots}", {self.degree}, {of})'

    def __reduce__(self) -> tuple[Any, ...]:
        alpha = self.alpha
        if alpha is not None:
            return Basis, (self.knots, self.degree, "mobius", alpha)
        return Basis._with, (self.knots, self.degree, self.family, tuple(self.parameters.items()))


def _quotient(above: str, below: str) -> str:
    """One line: a sum gets parentheses, and below the stroke a product, too."""
    if below == "1":
        return above
    outside = [re.sub(r"\([^()]*\)", "", part) for part in (above, below)]
    above = f"({above})" if " " in outside[0] else above
    below = f"({below})" if " " in outside[1] or "*" in outside[1] else below
    return f"{above}/{below}"


def _setting(text: str) -> str:
    lists = [f"[{', '.join(shown(Fraction(value)) for value in row.split(','))}]" for row in text.split(";")]
    if len(lists) > 1:
        return f"[{', '.join(lists)}]"
    return lists[0] if "," in text else lists[0][1:-1]


def _floats(x: Any) -> numpy.ndarray[Any, Any]:
    """An array of one axis, contiguous."""
    import numpy

    points = numpy.ascontiguousarray(x, dtype=float)
    if points.ndim != 1:
        raise ValueError(f"x: an array of one axis is wanted, and this one has {points.ndim}")
    return points
