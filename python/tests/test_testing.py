"""``check_basis``: what is right passes, and what is wrong is told on small knots."""

import re
from fractions import Fraction

import numpy
import pytest
from scipy.interpolate import BSpline

from knotproof import Basis
from knotproof.testing import check_basis as checked


def own(alpha="inf", side="right"):
    return lambda t, k, x, nu=0: Basis(t, k, alpha=alpha).B(x, nu, side)


def recursion(t, k, x, begins=lambda a, b, x: a <= x < b, guard=True, tops=lambda t, k: t[-1]):
    """Cox and de Boor, as many write it; at the last knot in the last span that is not empty."""
    n = len(t) - k - 2
    x_last = x == tops(t, k)
    last_span = max(j for j in range(len(t) - 1) if t[j] < t[j + 1])

    def ratio(above, below):
        return above / below if below or not guard else 0 * above

    values = [type(x)(j == last_span if x_last else begins(t[j], t[j + 1], x)) for j in range(len(t) - 1)]
    for d in range(1, k + 1):
        values = [
            ratio((x - t[i]) * values[i], t[i + d] - t[i]) + ratio((t[i + d + 1] - x) * values[i + 1], t[i + d + 1] - t[i + 1])
            for i in range(len(values) - 1)
        ]
    assert len(values) == n + 1
    return values


def scipys(t, k, x, nu=0):
    return BSpline(numpy.array(t), numpy.eye(len(t) - k - 1), k, extrapolate=False)(x, nu)


def failure(f, **options):
    with pytest.raises(AssertionError) as caught:
        checked(f, **options)
    text = str(caught.value)
    knots = [Fraction(t) for t in re.search(r"knots +\((.*)\)", text)[1].split(", ")]
    return text, knots, int(re.search(r"degree +(\d+)", text)[1])


@pytest.mark.parametrize("alpha", ["inf", -1])
@pytest.mark.parametrize("side", ["right", "left"])
def test_this_package_is_right(alpha, side):
    checked(own(alpha, side), alpha=alpha, side=side, nu=2, domain="line", number=Fraction, examples=40)


def test_the_recursion_is_right(check_basis):
    """In fractions and in floats; the fixture is the function."""
    assert check_basis is checked
    check_basis(recursion, number=Fraction, domain="support")
    check_basis(recursion, domain="support", rtol=1e-13)
    check_basis(recursion, domain="support", clamped=True, multiplicity="k+1", spread=0, ulp=64)


def test_scipy_is_right_within_its_conventions():
    checked(scipys, multiplicity="k+1", clamped=True, nu=2, rtol=1e-10)
    checked(scipys, last="skip", nu=2, rtol=1e-10)


def test_scipy_is_0_at_a_last_knot_of_too_many_copies():
    text, knots, degree = failure(scipys, rtol=1e-12)
    assert (knots, degree) == ([0, 1, 1], 0)
    assert text.startswith("G_0 is 1, and f gave 0.0\n") and "1, from the left at a knot of multiplicity 2" in text
    assert "again   Basis(\"0 1 1\", 0, alpha=\"inf\").B(\"1\", side=\"left\")" in text
    # Of a higher degree Hypothesis finds one, and shrinks it.
    _, knots, degree = failure(scipys, rtol=1e-12, degrees=[3], clamped=True, spread=0)
    assert (knots, degree) == ([0] * 4 + [1] * 5, 3)


def test_scipy_is_0_at_the_end_of_the_interval_if_that_is_a_double_knot():
    """Unclamped knots with t_n = t_(n+1): the same fault without any knot of k + 2 copies."""
    text, knots, degree = failure(scipys, rtol=1e-12, multiplicity="k+1", degrees=[1])
    assert (knots, degree) == ([0, 0, 1, 1, 2], 1) and text.startswith("G_1 is 1, and f gave 0.0\n")


def test_the_last_knot_is_as_it_is_said():
    half_open = lambda t, k, x: recursion(t, k, x, tops=lambda t, k: None)  # noqa: E731
    checked(half_open, number=Fraction, last="right", domain="support")
    text, knots, degree = failure(half_open, number=Fraction, domain="support")
    assert (knots, degree) == ([0, 1], 0) and "f gave 0" in text


def test_a_wrong_side_at_double_knots():
    def wrong(t, k, x):
        double = list(t).count(x) == 2
        return recursion(t, k, x, (lambda a, b, x: a < x <= b) if double else (lambda a, b, x: a <= x < b))

    text, knots, degree = failure(wrong, number=Fraction, degrees=range(1, 4))
    assert degree == 1 and len(knots) <= 6 and "at a knot of multiplicity 2" in text
    x = Fraction(re.search(r"x +(\S+),", text)[1])
    assert knots.count(x) == 2


def test_no_guard_against_0_by_0():
    with pytest.raises(AssertionError, match="f raised ZeroDivisionError") as caught:
        checked(lambda t, k, x: recursion(t, k, x, guard=False), number=Fraction)
    assert isinstance(caught.value.__cause__, ZeroDivisionError)
    assert "knots   (0, 0, 1, 1)" in str(caught.value) and "degree  1" in str(caught.value)


def test_what_only_large_cases_show_is_shrunk():
    """A tolerance that takes close knots for one: by no small knots is it found, and the case is a small one."""

    def wrong(t, k, x):
        return recursion([round(at * 2**20) / 2**20 for at in t], k, x)

    text, knots, degree = failure(wrong, rtol=1e-12, degrees=range(1, 6), clamped=True, examples=300)
    assert degree == 1 and len(knots) <= 6 and min(b - a for a, b in zip(knots, knots[1:]) if a < b) < Fraction(1, 2**20), text


def test_a_wrong_derivative():
    text, knots, degree = failure(lambda t, k, x, nu: Basis(t, k, alpha="inf").B(x), number=Fraction, nu=1)
    assert (knots, degree) == ([0, 1], 0) and "the derivative of order 1 of G_0 is 0, and f gave 1" in text


def test_too_few_values():
    text, _, _ = failure(lambda t, k, x: own()(t, k, x)[:-1], number=Fraction)
    assert text.startswith("f gave 0 values, and there are 1 functions")


def test_no_number_is_wrong():
    assert "f gave nan" in failure(lambda t, k, x: [float("nan")] * (len(t) - k - 1), rtol=1e-3)[0]


@pytest.mark.parametrize(
    "wrong, text",
    [
        ({}, "rtol is missing: f gives floats"),
        ({"rtol": 1e-9, "ulp": 1}, "^ulp: it takes the place of rtol"),
        ({"last": "zero"}, "^last: 'zero' is none of left, right, skip"),
        ({"domain": "all"}, "^domain: 'all' is none of base"),
        ({"side": "both"}, "^side: 'both' is no side"),
        ({"multiplicity": "k", "clamped": True}, "^multiplicity: clamped knots have"),
        ({"spread": 61}, "^spread: 61"),
        ({"degrees": []}, "^degrees: there are none"),
        ({"nu": -1}, "^nu: -1 is negative"),
    ],
)
def test_wrong_arguments(wrong, text):
    with pytest.raises(ValueError, match=text):
        checked(scipys, **wrong)
