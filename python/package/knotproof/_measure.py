"""What is known of real numbers: exact bounds; and what is answered with them."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import TYPE_CHECKING, Any, Literal

from ._exact import Exact, exact

if TYPE_CHECKING:
    from ._native import Known, PlaceOf

#: The longest interval for what is not known exactly, if none is given: as on the command line.
NARROW = Fraction(1, 10**12)


@dataclass(frozen=True)
class Enclosure:
    """A real number between exact bounds: ``interval``, of two equal numbers if it is known exactly; ``digits`` are its first ones, all
    right. ``float(…)`` is the middle, rounded."""

    interval: tuple[Fraction, Fraction]
    digits: str

    @property
    def exact(self) -> Fraction | None:
        """The number, if it is known exactly."""
        lo, hi = self.interval
        return lo if lo == hi else None

    def __float__(self) -> float:
        return float(sum(self.interval) / 2)

    def __str__(self) -> str:
        return self.digits


@dataclass(frozen=True)
class Place:
    """A place ``x``; or the interval from ``x`` until ``until``, which belongs to it if it is ``closed``: ``None`` both for a point."""

    x: Enclosure
    until: Fraction | None
    closed: bool | None


@dataclass(frozen=True)
class Solution(Place):
    """A place where a function g meets a value v.

    ``kind`` is "taken" if g(x) = v; at a jump "limit-from-left" if only that is v, and "passed" if v lies between both sides.
    ``before`` and ``after`` are the signs −1, 0, 1 of g − v just before and just after, ``None`` beyond the ends: equal where it
    touches. ``point`` is that of the curve, an ``Enclosure`` for each coordinate, and for a function one; ``None`` on an
    interval and where the value is passed.
    """

    kind: Literal["taken", "limit-from-left", "passed"]
    before: int | None
    after: int | None
    point: Any


@dataclass(frozen=True)
class BoundPlace(Place):
    """A place where a function has a bound: as its value if it is ``taken``, otherwise as the limit from the left at a jump."""

    taken: bool


@dataclass(frozen=True)
class Bound:
    """An infimum or a supremum, and every place that has it, from left to right."""

    value: Enclosure
    places: tuple[BoundPlace, ...]


@dataclass(frozen=True)
class Range:
    """The infimum and the supremum of a function."""

    lowest: Bound
    highest: Bound


@dataclass(frozen=True)
class Collocation:
    """The matrix (G_i(x_j)) with a row for each place x_j and a column for each function.

    ``determinant`` is ``None`` unless there are n + 1 places: interpolation is possible if and only if it is not 0. ``misplaced``
    has each i with G_i(x_i) = 0; if there is none, the condition of Schoenberg and Whitney holds, which is necessary, and for α =
    inf sufficient. ``relation`` are c_i, not all 0, with Σ c_i G_i = 0 at every place; ``None`` if there are none.
    """

    places: tuple[Fraction, ...]
    matrix: tuple[tuple[Fraction, ...], ...]
    rank: int
    determinant: Fraction | None
    misplaced: tuple[int, ...]
    relation: tuple[Fraction, ...] | None


def known(of: Known) -> Enclosure:
    """A number as the library gives it."""
    return Enclosure(*of)


def place(of: PlaceOf) -> tuple[Enclosure, Fraction | None, bool | None]:
    """The fields of a place."""
    x, until, closed = of
    return known(x), until, closed


def positive(value: Exact, name: str) -> Fraction:
    """A width."""
    width = exact(value, name)
    if width <= 0:
        raise ValueError(f"{name}: {width} is not positive; give the longest interval wanted, such as Fraction(1, 10**9)")
    return width
