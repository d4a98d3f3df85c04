"""What goes in, and what is refused."""

import math
from decimal import Decimal
from fractions import Fraction

import numpy
import pytest
import sympy

from knotproof import Basis

KNOTS = [0, 0, 0, 1, 2, 3, 3, 3]


@pytest.mark.parametrize(
    "half", [Fraction(1, 2), Decimal("0.5"), "1/2", "0.5", "0x1p-1", " 1/2 ", sympy.Rational(1, 2), sympy.S.Half]
)
def test_a_half_in_every_form_is_the_same(half):
    basis = Basis(KNOTS, 2, alpha=-1)
    values = basis.B(half)
    assert values == (Fraction(4, 9), Fraction(32, 63), Fraction(1, 21), 0, 0)
    assert all(type(value) is Fraction for value in values)


@pytest.mark.parametrize("one", [1, numpy.int64(1), sympy.Integer(1), Decimal(1), "1"])
def test_whole_numbers_of_every_kind_are_taken(one):
    assert Basis([0, 0, one, one], 1, alpha="inf").B(one) == (0, 1)


@pytest.mark.parametrize("wrong", [0.5, 1.0, numpy.float64(0.5), numpy.float32(0.5)])
def test_a_float_is_refused_with_what_to_write(wrong):
    basis = Basis(KNOTS, 2, alpha=-1)
    with pytest.raises(TypeError, match=r"Fraction\(.*\)"):
        basis.B(wrong)
    with pytest.raises(TypeError, match=r"knots\[1\].*Fraction\("):
        Basis([0, wrong, 2, 3], 1, alpha=-1)
    with pytest.raises(TypeError, match=r"alpha.*Fraction\("):
        Basis(KNOTS, 2, alpha=-wrong)


@pytest.mark.parametrize("wrong", [True, None, 1j, object(), sympy.sqrt(2), sympy.Float(1.5), sympy.Symbol("x"), [1, 2]])
def test_what_is_no_exact_number_is_refused(wrong):
    with pytest.raises(TypeError, match="x: "):
        Basis(KNOTS, 2, alpha=-1).B(wrong)


@pytest.mark.parametrize("wrong", ["", "a", "1/0", "nan", "inf", "1/2/3", Decimal("NaN"), Decimal("Infinity")])
def test_texts_that_are_no_number_are_wrong_values(wrong):
    with pytest.raises(ValueError, match="x: "):
        Basis(KNOTS, 2, alpha=-1).B(wrong)


@pytest.mark.parametrize(
    "infinity",
    ["inf", "-inf", "∞", math.inf, -math.inf, float("inf"), numpy.inf, sympy.oo, -sympy.oo, Decimal("inf")],
)
def test_infinity_is_no_rounded_number(infinity):
    assert Basis(KNOTS, 2, alpha=infinity).alpha == "inf"


@pytest.mark.parametrize("alpha", [0, 1, "1/2", Fraction(1, 3)])
def test_excluded_indices_say_why(alpha):
    with pytest.raises(ValueError, match=r"alpha: .* lies in \[0, 1\]"):
        Basis(KNOTS, 2, alpha=alpha)


@pytest.mark.parametrize("alpha", [math.nan, sympy.nan, sympy.zoo, "nan", True])
def test_no_number_is_no_index(alpha):
    with pytest.raises((TypeError, ValueError), match="alpha: "):
        Basis(KNOTS, 2, alpha=alpha)


def test_orders_and_degrees_are_whole():
    basis = Basis(KNOTS, 2, alpha=-1)
    for wrong, kind in [(1.0, TypeError), (True, TypeError), ("1", TypeError), (-1, ValueError)]:
        with pytest.raises(kind, match="nu: "):
            basis.B(1, nu=wrong)
        with pytest.raises(kind, match="degree: "):
            Basis(KNOTS, wrong, alpha=-1)
    with pytest.raises(ValueError, match="side: 'middle'"):
        basis.B(1, side="middle")


@pytest.mark.parametrize(
    ("knots", "degree", "text"),
    [
        ([], 0, "a knot vector has at least two knots"),
        ([1, 1], 0, "all 2 knots are equal to 1"),
        ([0, 2, 1], 1, "knot 2 is 1, after 2"),
        ([0, 1, 2], 2, "degree 2 needs at least 5 knots"),
        ([0, 1], 10**19 - 1, None),
    ],
)
def test_wrong_knots_say_what_is_wrong(knots, degree, text):
    with pytest.raises((ValueError, OverflowError), match=text):
        Basis(knots, degree, alpha="inf")


def test_what_is_no_list_is_refused():
    with pytest.raises(TypeError, match="knots: 3 is no list"):
        Basis(3, 1, alpha="inf")
    with pytest.raises(TypeError, match=r"family: -1 is no name; .* alpha=-1"):
        Basis(KNOTS, 2, -1)
    with pytest.raises(ValueError, match='alpha is missing.*alpha="inf"'):
        Basis(KNOTS, 2)


def test_families_say_what_they_need():
    with pytest.raises(ValueError, match="there is no family `lupa`, and no such file; there are .*lupas"):
        Basis(KNOTS, 2, family="lupa")
    with pytest.raises(ValueError, match="the family lupas needs `q`: give it, such as q=1/3"):
        Basis(KNOTS, 2, family="lupas")
    with pytest.raises(ValueError, match="`q` of the family lupas can't be -1: q > 0"):
        Basis(KNOTS, 2, family="lupas", q=-1)
    with pytest.raises(ValueError, match="the family lupas has no `p`"):
        Basis(KNOTS, 2, family="lupas", q=1, p=2)
    with pytest.raises(ValueError, match="the family classical has no `alpha`"):
        Basis(KNOTS, 2, family="classical", alpha=2)
    with pytest.raises(TypeError, match="q: .*float"):
        Basis(KNOTS, 2, family="lupas", q=0.5)
