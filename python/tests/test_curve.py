"""Curves, their joins, and the same curves as NURBS."""

from fractions import Fraction

import numpy
import pytest
from scipy.interpolate import BSpline

from knotproof import Basis, Curve

POINTS = [(0, 0), (1, 2), (2, 2), (3, 0)]


@pytest.fixture
def curve():
    return Basis("0 0 0 1 2 2 2", 2, alpha=5).curve(POINTS)


def test_points_are_sums_of_functions(curve):
    for x in ["0", "1/3", "1", "2"]:
        values = curve.basis.B(x)
        sums = tuple(sum(value * point[c] for value, point in zip(values, POINTS)) for c in range(2))
        assert curve(x) == sums
        slopes = curve.basis.B(x, nu=1)
        assert curve(x, 1) == tuple(sum(value * point[c] for value, point in zip(slopes, POINTS)) for c in range(2))
    assert curve(5) == (0, 0)


def test_numbers_for_points_make_a_function():
    function = Basis("0 0 0 1 1 1", 2, alpha="inf").curve([0, "1/2", 4])
    assert function("1/2") == Fraction(5, 4) and function.points == (0, Fraction(1, 2), 4)
    assert list(function.sample([0.5])) == [1.25]


def test_wrong_points_say_what_is_wrong():
    basis = Basis("0 0 0 1 1 1", 2, alpha="inf")
    with pytest.raises(ValueError, match="points: .*takes 3 control points .*, and here are 1"):
        basis.curve([(0, 0)])
    with pytest.raises(ValueError, match="points: control point 1 has 3 coordinates and point 0 has 2"):
        basis.curve([(0, 0), (1, 1, 1), (2, 2)])
    with pytest.raises(ValueError, match="in dimension 1, 2 or 3"):
        basis.curve([(1, 2, 3, 4)] * 3)
    with pytest.raises(TypeError, match=r"points\[1\]\[0\]: 0.5 is a float"):
        basis.curve([(0, 0), (0.5, 1), (2, 2)])


def test_tangents_and_joins(curve):
    left, right = curve.tangent(1, side="left"), curve.tangent(1)
    assert left.order == right.order == 1 and left.direction == curve(1, 1, "left")
    (join,) = curve.joins()
    assert (join.knot, join.multiplicity, join.closing, join.g0, join.g1) == (1, 1, False, True, True)
    assert join.before.derivative == left.direction and join.after.derivative == right.direction
    assert join.speed_ratio_squared != 1
    assert Basis("0 0 1 1", 1, alpha=2).curve([(1, 1), (1, 1)]).tangent("1/2") is None


def test_a_corner():
    (join,) = Basis("0 0 1 2 2", 1, alpha="inf").curve([(0, 0), (1, 0), (1, 1)]).joins()
    assert (join.g0, join.g1, join.cos2, join.turns_back, join.degrees) == (True, False, 0, False, "90.00000000")


@pytest.mark.parametrize("alpha", ["inf", "5", "-1/2"])
def test_nurbs_are_the_same_curve(alpha):
    curve = Basis("0 0 0 1 2 2 2", 2, alpha=alpha).curve(POINTS)
    (nurbs,) = curve.to_nurbs()
    for x in ["0", "1/3", "1", "7/4", "2"]:
        assert nurbs(x) == curve(x)
    theirs = nurbs.to_scipy()(0.75)
    assert theirs[:-1] / theirs[-1] == pytest.approx([float(c) for c in curve("3/4")])


def test_nurbs_in_other_forms(curve):
    (raised,) = curve.to_nurbs(degree=5, start="1/2", end="3/2")
    assert raised.degree == 5 and raised.knots[0] == Fraction(1, 2) and raised(1) == curve(1)
    (standard,) = curve.to_nurbs(standard_form=True)
    (a, b, ratio) = standard.parameter[0]
    y = Fraction(1, 3)
    x = (ratio * (y - a) * b + (b - y) * a) / (ratio * (y - a) + (b - y))
    assert standard(y) == curve(x)
    assert "ISO-10303-21" in curve.nurbs_file("step")
    with pytest.raises(ValueError, match="^degree: degree 0 is not between"):
        curve.to_nurbs(degree=0)
    with pytest.raises(ValueError, match="format: `dxf` is neither geomdl nor step"):
        curve.nurbs_file("dxf")
    with pytest.raises(ValueError, match="y: 3 is not in"):
        standard(3)


def test_a_curve_that_jumps_is_several():
    basis = Basis("0 0 1 1 2 2", 1, alpha=-1)
    first, second = basis.curve([(0, 0), (1, 1), (5, 5), (4, 1)]).to_nurbs()
    assert first.knots[-1] == second.knots[0] == 1 and first(1) == (1, 1) and second(1) == (5, 5)


def test_samples_are_scipys_for_infinity_and_the_exact_ones_for_all():
    knots = "0 1 2 4 5 7 8 9"
    basis = Basis(knots, 3, alpha="inf")
    curve = basis.curve(POINTS)
    x = numpy.linspace(-1, 10, 57)
    t = numpy.array([float(t) for t in basis.knots])
    theirs = BSpline(t, numpy.array(POINTS, float), 3, extrapolate=False)(x)
    numpy.testing.assert_allclose(curve.sample(x), theirs, rtol=1e-13, atol=1e-13)
    for other in (Basis(knots, 3, alpha=-1), Basis(knots, 3, family="lupas", q="1/2")):
        ours = other.curve(POINTS).sample([4.5])[0]
        assert ours == pytest.approx([float(c) for c in other.curve(POINTS)("9/2")], rel=1e-15)
    with pytest.raises(ValueError, match="extrapolate"):
        curve.sample(x, extrapolate=True)


def test_curves_of_the_paper():
    curve = Curve.of_instance("C5", alpha=-4)
    assert curve(0) == curve.points[0] and repr(curve).startswith("<curve with control points (")
    with pytest.raises(ValueError, match="U4 has no control points"):
        Curve.of_instance("U4", alpha=2)
