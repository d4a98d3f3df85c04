"""Maxima, minima, jumps and slopes."""

from fractions import Fraction

import pytest

from knotproof import Basis


def test_two_maxima_of_the_conjecture():
    shape = Basis("0 0 0 0 1 2 4 4", 3, alpha="5/2").shape(2, width="1e-12")
    assert (len(shape.maxima), len(shape.minima), shape.largest_once) == (2, 1, True)
    for extremum in shape.extrema:
        lo, hi = extremum.interval
        assert hi - lo <= Fraction(1, 10**12) and float(extremum.x) == pytest.approx(float(lo))


def test_a_maximum_in_the_middle():
    shape = Basis("0 0 0 1 1 1", 2, alpha="inf").shape(1)
    (top,) = shape.maxima
    assert (top.interval, top.value, top.x, top.height) == ((Fraction(1, 2),) * 2, (Fraction(1, 2),) * 2, "0.5000000000", "0.5000000000")
    assert [(slope.at, slope.left, slope.right) for slope in shape.slopes] == [(0, None, 2), (1, -2, None)]


def test_plateaus_and_jumps():
    shape = Basis("0 1 3", 0, alpha="inf").shape(0)
    assert shape.maxima[0].plateau and [(jump.at, jump.left, jump.right) for jump in shape.jumps] == [(1, 1, 0)]


def test_widths_are_positive():
    with pytest.raises(ValueError, match="width: 0 is not positive"):
        Basis("0 0 1 1", 1, alpha=2).shape(0, width=0)


def test_a_negative_function_has_no_shape():
    with pytest.raises(ValueError, match="family: .* negative"):
        Basis("0 0 0 0 1 1 1 1", 3, family="phillips", q=2).shape(1)
