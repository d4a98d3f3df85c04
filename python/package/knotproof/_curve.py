"""Curves."""

from __future__ import annotations

import os
from collections.abc import Iterable
from dataclasses import dataclass
from fractions import Fraction
from typing import TYPE_CHECKING, Any, Literal

from . import _native
from ._basis import Basis, _floats
from ._exact import Exact, Side, exact, exacts, is_left, whole
from ._measure import NARROW, Bound, BoundPlace, Enclosure, Range, Solution, known, place, positive
from ._verdict import Verdicts

if TYPE_CHECKING:
    import numpy
    import scipy.interpolate

    from ._native import BoundOf, Function, NurbsOf, Part

Point = tuple[Fraction, ...]


@dataclass(frozen=True)
class Tangent:
    """The direction of a curve, and how it bends there.

    ``order`` is that of the first derivative that is not 0, ``direction`` a vector in the direction in which the curve is run
    through, not of length 1, and ``curvature`` the vector of curvature; ``None`` if that is infinite.
    """

    order: int
    direction: Point
    curvature: Point | None


@dataclass(frozen=True)
class JoinSide:
    """One side of a join: ``direction`` is ``None`` where the curve stands still, ``curvature`` where it is infinite, too."""

    point: Point
    derivative: Point
    direction: Point | None
    curvature: Point | None


@dataclass(frozen=True)
class Join:
    """A knot inside the interval, where two pieces of a curve meet; ``closing``: where its end meets its beginning.

    ``g0``: are the points equal, ``g1``: the directions, too, ``g2``: the vectors of curvature, too; ``None`` is not defined.
    ``cos2`` is the squared cosine of the angle between the directions, ``turns_back`` whether it is more than a right one, and
    ``degrees`` its first digits; ``speed_ratio_squared`` and ``curvature_jump`` are after against before.
    """

    knot: Fraction
    multiplicity: int
    closing: bool
    g0: bool
    g1: bool | None
    g2: bool | None
    cos2: Fraction | None
    turns_back: bool | None
    degrees: str | None
    speed_ratio_squared: Fraction | None
    curvature_jump: str | None
    before: JoinSide
    after: JoinSide


@dataclass(frozen=True)
class Nurbs:
    """A NURBS curve, exactly: its degree, knots, positive weights, and control points not multiplied by them.

    ``parameter`` has for each span [a, b] the ratio λ with (x − a)/(b − x) = λ (y − a)/(b − y): at y it has the point that the
    source has at x. λ is 1, and y = x, unless it is in standard form.
    """

    degree: int
    knots: tuple[Fraction, ...]
    weights: tuple[Fraction, ...]
    points: tuple[Point, ...]
    parameter: tuple[tuple[Fraction, Fraction, Fraction], ...]

    def __call__(self, y: Exact) -> Point:
        """Its point at y, exactly: by de Boor's algorithm on weights and weighted points, at the last knot from the left."""
        x = exact(y, "y")
        knots, k = self.knots, self.degree
        if not knots[0] <= x <= knots[-1]:
            raise ValueError(f"y: {x} is not in [{knots[0]}, {knots[-1]}]")
        span = max(j for j in range(k, len(self.weights)) if knots[j] <= x and knots[j] < knots[j + 1])
        first = span - k
        net = [
            [w, *(w * c for c in point)]
            for w, point in zip(self.weights[first : span + 1], self.points[first : span + 1])
        ]
        for level in range(1, k + 1):
            for i in range(k, level - 1, -1):
                a, b = knots[first + i], knots[span + 1 + i - level]
                share = (x - a) / (b - a)
                net[i] = [(1 - share) * left + share * own for left, own in zip(net[i - 1], net[i])]
        weight, *coordinates = net[k]
        return tuple(c / weight for c in coordinates)

    def to_scipy(self) -> scipy.interpolate.BSpline:
        """SciPy's ``BSpline`` of (w c, w), in floats: the curve is all but the last coordinate, divided by the last one."""
        import numpy
        from scipy.interpolate import BSpline

        controls = [[*(float(w * c) for c in point), float(w)] for w, point in zip(self.weights, self.points)]
        return BSpline(numpy.array([float(t) for t in self.knots]), numpy.array(controls), self.degree, extrapolate=False)


class Curve:
    """c(x) = Σ d_i G_i(x), x in [t_0, t_m], made by ``Basis.curve(points)``.

    With numbers for control points it is a function, and its values are numbers; with lists of coordinates they are tuples.

    >>> Basis("0 0 0 1 1 1", 2, alpha="inf").curve([(0, 0), (1, 2), (2, 0)])("1/2")
    (Fraction(1, 1), Fraction(1, 1))
    """

    __slots__ = ("basis", "_native", "_plain")
    basis: Basis
    _native: _native.Curve
    _plain: bool

    def __init__(self, basis: Basis, points: Iterable[Any]) -> None:
        controls, self._plain = _points(points)
        self.basis = basis
        self._native = basis._native.curve(controls)

    @classmethod
    def of_instance(cls, name: str, degree: int | None = None, alpha: Exact | float | None = None) -> Curve:
        """The curve of the paper's instance of this name, such as "C5": see ``Basis.of_instance``."""
        basis = Basis.of_instance(name, degree, alpha)
        points = _native.instance(name, basis.degree)[3]
        if points is None:
            raise ValueError(f"name: {name} has no control points")
        return cls(basis, points)

    @property
    def points(self) -> tuple[Any, ...]:
        """d_0, …, d_n."""
        return tuple(self._own(point) for point in self._native.points)

    def __call__(self, x: Exact, nu: int = 0, side: Side = "right") -> Any:
        """c(x), or with ``nu`` its derivative of that order: exactly, as a limit from a side. At t_m it is the left one, and outside
        of [t_0, t_m] there is 0, as for ``Basis.B``."""
        return self._own(self._native.point(exact(x, "x"), whole(nu, "nu"), is_left(side)))

    def tangent(self, x: Exact, side: Side = "right") -> Tangent | None:
        """The tangent at x, exactly; ``None`` outside of [t_0, t_m], and where the curve stands still."""
        tangent = self._native.tangent(exact(x, "x"), is_left(side))
        if tangent is None:
            return None
        order, direction, curvature = tangent
        return Tangent(order, tuple(direction), None if curvature is None else tuple(curvature))

    def joins(self) -> tuple[Join, ...]:
        """How smooth it is at its knots inside [t_k, t_{n+1}], and where its end meets its beginning: exactly."""
        made = []
        for (knot, multiplicity, closing), (g0, g1, g2), angle, (speed, jump), sides in self._native.joins():
            cos2, turns_back, degrees = angle or (None, None, None)
            before, after = (JoinSide(*(None if part is None else tuple(part) for part in of)) for of in sides)  # type: ignore[arg-type]
            made.append(
                Join(knot, multiplicity, closing, g0, g1, g2, cos2, turns_back, degrees, speed, jump, before, after)
            )
        return tuple(made)

    def to_nurbs(
        self,
        degree: int | None = None,
        start: Exact | None = None,
        end: Exact | None = None,
        standard_form: bool = False,
    ) -> tuple[Nurbs, ...]:
        """The same curve as NURBS curves, exactly, one for each connected run: where it jumps, another one begins.

        ``degree`` raises the least one, ``start`` and ``end`` cut off a part, ``standard_form`` makes weight 1 at both ends of
        each piece: the same points in another ``parameter``. The result is turned back into pieces and compared with the curve for
        every x before it is given. ``ValueError`` for a degree or an end that can't be.
        """
        runs, _ = self._nurbs(degree, start, end, standard_form, None)
        return tuple(
            Nurbs(
                of,
                tuple(knots),
                tuple(weights),
                tuple(tuple(point) for point in points),
                tuple((ends[0], ends[1], ratio) for ends, ratio, _ in spans),
            )
            for of, knots, weights, points, spans in runs
        )

    def nurbs_file(
        self,
        format: Literal["step", "geomdl"],
        degree: int | None = None,
        start: Exact | None = None,
        end: Exact | None = None,
        standard_form: bool = False,
    ) -> str:
        """The same as the text of a file for CAD programs ("step") or NURBS-Python ("geomdl"), in floats, each the nearest one."""
        return self._nurbs(degree, start, end, standard_form, format)[1] or ""

    def _nurbs(
        self, degree: int | None, start: Exact | None, end: Exact | None, standard_form: bool, file: str | None
    ) -> tuple[list[NurbsOf], str | None]:
        ends = [None if x is None else exact(x, name) for x, name in ((start, "start"), (end, "end"))]
        raised = None if degree is None else whole(degree, "degree")
        return self._native.nurbs((raised, ends[0], ends[1]), standard_form, file)

    def solve(
        self,
        value: Exact = 0,
        *,
        coordinate: int | None = None,
        normal: str | Iterable[Exact] | None = None,
        start: Exact | None = None,
        end: Exact | None = None,
        width: Exact = NARROW,
    ) -> tuple[Solution, ...]:
        """Where a coordinate of c(x), counted from 0, or a·c(x) with a = ``normal``, is ``value``: every x of [t_0, t_m], or of
        [``start``, ``end``], from left to right, exactly.

        Roots are isolated, not searched for: rational ones are found as such, others lie in intervals of at most ``width`` > 0. An
        interval on which it is the value throughout is one solution. At a knot of more than k copies, where a curve may jump, a
        limit from the left that is the value, and a jump past it, are told by their ``kind``. Degrees up to 10.

        A function needs no coordinate. ``ValueError`` if a curve has none, and for a part that the curve has not.

        >>> Basis("0 0 0 1 1 1", 2, alpha="inf").curve([0, 1, 0]).solve("3/8")[0].x.exact
        Fraction(1, 4)
        """
        part, function = self._part(start, end, width), _function(coordinate, normal)
        found = self._native.solve(part, function, exact(value, "value"))
        return tuple(
            Solution(*place(where), kind, *signs, None if point is None else self._own([known(of) for of in point]))  # type: ignore[arg-type]
            for kind, where, signs, point in found
        )

    def bounds(self, start: Exact | None = None, end: Exact | None = None, width: Exact = NARROW) -> tuple[Range, ...]:
        """The bounding box: for each coordinate its ``range``."""
        return self._ranges(self._part(start, end, width), None)

    def range(
        self,
        *,
        coordinate: int | None = None,
        normal: str | Iterable[Exact] | None = None,
        start: Exact | None = None,
        end: Exact | None = None,
        width: Exact = NARROW,
    ) -> Range:
        """The infimum and the supremum of a coordinate, or of a·c(x) with a = ``normal``, and every x that has it: exactly.

        Equal values at irrational x are found equal, so that a symmetric curve has both of its highest points. Where a curve jumps,
        a bound may be a limit from the left that is not taken. Arguments and errors are those of ``solve``.
        """
        return self._ranges(self._part(start, end, width), _function(coordinate, normal))[0]

    def length(self, start: Exact | None = None, end: Exact | None = None, width: Exact = NARROW) -> Enclosure:
        """∫ |c′(x)| dx over [t_0, t_m], or [``start``, ``end``], between two exact bounds at most ``width`` > 0 apart; jumps add nothing.

        The bounds are proved, and equal where the length is known exactly. Degrees up to 10.

        >>> Basis("0 0 1 2 2", 1, alpha=5).curve([(0, 0), (3, 4), (3, 5)]).length().exact
        Fraction(6, 1)
        """
        return known(self._native.length(self._part(start, end, width)))

    def integral(self, start: Exact | None = None, end: Exact | None = None, width: Exact = NARROW) -> Any:
        """∫ c(x) dx over [t_0, t_m], or [``start``, ``end``], as ``length``: an ``Enclosure`` for each coordinate, and of a function
        one. For α = inf it is exact.
        """
        return self._own([known(of) for of in self._native.integrals(self._part(start, end, width))])

    def insert(self, at: str | Iterable[Exact]) -> Curve:
        """The same curve, for every x, on its knots and those of ``at``, each as often as it is given: exactly.

        For α = inf there always is one (Boehm's knot insertion). For another α the functions have a corner at a new knot, so there
        is one for special curves only, or where the knot has k copies already: there the curve is cut. ``ValueError`` where there
        is none, with the ranks that show it; for a knot outside of [t_0, t_m]; and for another family.

        >>> Basis("0 0 0 2 2 2", 2, alpha="inf").curve([0, 1, 0]).insert([1]).points
        (Fraction(0, 1), Fraction(1, 2), Fraction(1, 2), Fraction(0, 1))
        """
        new = exacts(at, "at")
        points = self._native.insert(new, self.basis.family)
        basis = Basis(sorted([*self.basis.knots, *new]), self.basis.degree, alpha=self.basis.alpha)
        return Curve(basis, [self._own(point) for point in points])

    def _part(self, start: Exact | None, end: Exact | None, width: Exact) -> Part:
        ends = [None if x is None else exact(x, name) for x, name in ((start, "start"), (end, "end"))]
        return ends[0], ends[1], positive(width, "width")

    def _ranges(self, part: Part, function: Function | None) -> tuple[Range, ...]:
        return tuple(Range(_bound(low), _bound(high)) for low, high in self._native.bounds(part, function))

    def sample(self, x: Any, extrapolate: bool = False) -> numpy.ndarray[Any, Any]:
        """The points at an array of floats, as SciPy's ``BSpline(…, extrapolate=False)`` gives them: an array with a row for each x,
        and of NaN for an x outside of [t_k, t_{n+1}]. How exact it is, and why ``extrapolate`` is refused, says
        ``Basis.design_matrix``."""
        if extrapolate:
            raise ValueError("extrapolate: it is refused, as by Basis.design_matrix, which says why")
        import numpy

        points = _floats(x)
        start, end = (float(t) for t in self.basis.interval)
        inside = (points >= start) & (points <= end)
        sampled = numpy.full((len(points), len(self._native.points[0])), numpy.nan)
        found = numpy.frombuffer(self._native.floats(points[inside].tobytes()), float)
        sampled[inside] = found.reshape(-1, sampled.shape[1])
        return sampled[:, 0] if self._plain else sampled

    def check(
        self, *claims: str, sentence: str | None = None, paper: str | os.PathLike[str] | None = None, classical: bool = False
    ) -> Verdicts:
        """As ``Basis.check``, and what a claim says of control points is about these."""
        return self.basis._check(self._native.points, claims, sentence, paper, classical)

    def _own(self, point: list[Any]) -> Any:
        return point[0] if self._plain else tuple(point)

    def __repr__(self) -> str:
        points = [str(point[0]) if self._plain else f"({', '.join(map(str, point))})" for point in self._native.points]
        return f"<curve with control points {', '.join(points)} on {self.basis!r}>"


def _points(points: Iterable[Any]) -> tuple[list[list[Fraction]], bool]:
    """Lists of coordinates; and are they numbers, as those of a function?"""
    listed = list(points)
    if plain := all(isinstance(point, str) or not isinstance(point, Iterable) for point in listed):
        return [[exact(value, f"points[{place}]")] for place, value in enumerate(listed)], plain
    return [exacts(point, f"points[{place}]") for place, point in enumerate(listed)], plain


def _function(coordinate: int | None, normal: str | Iterable[Exact] | None) -> Function:
    return (
        None if coordinate is None else whole(coordinate, "coordinate"),
        None if normal is None else exacts(normal, "normal"),
    )


def _bound(of: BoundOf) -> Bound:
    value, places = of
    return Bound(known(value), tuple(BoundPlace(*place(where), taken) for where, taken in places))
