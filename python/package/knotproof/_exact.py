"""What goes in: exact numbers, and whole ones."""

from __future__ import annotations

import math
import numbers
import operator
from collections.abc import Iterable, Sequence
from decimal import Decimal
from fractions import Fraction
from typing import Literal, Union

from ._native import parse

#: What is taken for a number: also the rationals of SymPy and the integers of NumPy, which are ``numbers.Rational``.
Exact = Union[int, Fraction, Decimal, str, numbers.Rational]
#: Of which side a limit is taken.
Side = Literal["left", "right"]
#: What a parameter of a family takes: a number, a list of numbers, or a list for each d.
Setting = Union[Exact, Sequence[Exact], Sequence[Sequence[Exact]]]


def exact(value: object, name: str) -> Fraction:
    """The number as a ``Fraction``; ``name`` is what it is called in complaints.

    Raises ``TypeError`` for a float and for whatever else is not exact, ``ValueError`` for a text that is no number.
    """
    if isinstance(value, bool):
        raise TypeError(f"{name}: {value} is a truth value; write the number that is meant")
    if isinstance(value, str):
        try:
            return parse(value)
        except ValueError as error:
            raise ValueError(f"{name}: {error}") from None
    if isinstance(value, Decimal):
        if not value.is_finite():
            raise ValueError(f"{name}: {value} is not a finite number")
        return Fraction(value)
    if isinstance(value, numbers.Rational):
        return Fraction(int(value.numerator), int(value.denominator))
    if isinstance(value, numbers.Real):
        raise TypeError(
            f"{name}: {value} is a float, and floats are rounded: write Fraction({value}) for the number that it is, or "
            f'"{value}" for the one that is written there'
        )
    raise TypeError(
        f"{name}: {_short(value)} is no exact number: write an int, a Fraction, a Decimal, a text such as "
        '"1/3", or a rational of SymPy'
    )


def index(value: Exact | float, name: str = "alpha") -> str | Fraction:
    """An index α: an exact number, or infinity in any of its forms, among them ``math.inf``, which is not rounded."""
    if isinstance(value, str):
        return value
    if isinstance(value, (float, Decimal)) and math.isinf(value):
        return "inf"
    # What SymPy calls oo is no number of Python's.
    if getattr(value, "is_infinite", None) is True and getattr(value, "is_extended_real", None):
        return "inf"
    return exact(value, name)


def exacts(values: object, name: str) -> list[Fraction]:
    """A list of numbers; a text has them between spaces or commas."""
    if isinstance(values, str):
        values = values.replace(",", " ").split()
    return [exact(value, f"{name}[{place}]") for place, value in enumerate(_iterable(values, name))]


def rows(values: Setting, name: str) -> list[list[Fraction]]:
    """The numbers of a parameter by rows, as the command line has them."""
    if isinstance(values, str) or not isinstance(values, Iterable):
        return [[exact(values, name)]]
    listed: list[object] = list(values)
    if listed and all(isinstance(row, Iterable) and not isinstance(row, str) for row in listed):
        return [exacts(row, f"{name}[{place}]") for place, row in enumerate(listed)]
    return [exacts(listed, name)]


def whole(value: object, name: str) -> int:
    """A whole number from 0 up."""
    if isinstance(value, bool):
        raise TypeError(f"{name}: {value} is a truth value; write the number that is meant")
    try:
        number = operator.index(value)  # type: ignore[arg-type]
    except TypeError:
        raise TypeError(f"{name}: {_short(value)} is no whole number: write an int") from None
    if number < 0:
        raise ValueError(f"{name}: {number} is negative: write a whole number from 0 up")
    return number


def is_left(side: Side) -> bool:
    """Is it the left one?"""
    if side not in ("left", "right"):
        raise ValueError(f'side: {_short(side)} is no side: write "left" or "right"')
    return side == "left"


def shown(value: Fraction) -> str:
    """A number that reads back: ``3``, ``"1/2"``."""
    return str(value) if value.denominator == 1 else f'"{value}"'


def _iterable(values: object, name: str) -> Iterable[object]:
    if not isinstance(values, Iterable):
        raise TypeError(f"{name}: {_short(values)} is no list: write several numbers, such as [0, 0, 1, 1]")
    return values


def _short(value: object) -> str:
    text = " ".join(repr(value).split())
    return text if len(text) <= 60 else f"{text[:57]}..."
