"""Where a curve takes a value, its bounds, its length; interpolation and knot insertion."""

import math
from fractions import Fraction

import numpy
import pytest
import sympy
from scipy.integrate import quad
from scipy.interpolate import BSpline, insert, make_interp_spline

from knotproof import Basis, Curve

KNOTS = "0 0 0 1 2 2 2"
POINTS = [(0, 0), (1, 2), (2, 2), (3, 0)]


@pytest.fixture
def curve():
    return Basis(KNOTS, 2, alpha=5).curve(POINTS)


def test_solutions_are_all_roots(curve):
    found = curve.solve("13/10", coordinate=1, width="1e-20")
    assert [(of.kind, of.before, of.after, of.until) for of in found] == [("taken", -1, 1, None), ("taken", 1, -1, None)]
    x = sympy.Symbol("x", real=True)
    height = sum(point[1] * G for point, G in zip(POINTS, curve.basis.to_sympy()))
    for solution in found:
        lo, hi = solution.x.interval
        assert hi - lo <= Fraction(1, 10**20) and solution.x.exact is None
        assert (curve(lo)[1] - Fraction(13, 10)) * (curve(hi)[1] - Fraction(13, 10)) < 0
        assert float(height.subs(x, sympy.Rational(lo))) == pytest.approx(1.3)
        assert float(solution.point[0]) == pytest.approx(float(curve(lo)[0])) and str(solution.point[1]) == "1.300000000"


def test_a_line_a_part_and_a_touch():
    curve = Basis(KNOTS, 2, alpha="inf").curve(POINTS)
    # 4x - 2x² on [0, 1] is largest, 2, at 1.
    (touch,) = curve.solve(2, coordinate=1)
    assert (touch.x.exact, touch.before, touch.after) == (1, -1, -1)
    assert tuple(of.exact for of in touch.point) == curve(1)
    (crossing,) = curve.solve("3/2", normal=[0, 1], start=1)
    assert crossing.x.exact == Fraction(3, 2)
    assert curve.solve(3, coordinate=1) == ()
    (end,) = curve.solve(2, coordinate=1, start=1)
    assert (end.x.exact, end.before, end.after) == (1, None, -1)


def test_functions_jumps_and_intervals():
    function = Basis("0 1 2 3", 0, alpha="inf").curve([1, 1, 3])
    (throughout,) = function.solve(1)
    assert (throughout.x.exact, throughout.until, throughout.closed, throughout.point) == (0, 2, False, None)
    (passed,) = function.solve(2)
    assert (passed.kind, passed.x.exact, passed.before, passed.after, passed.point) == ("passed", 2, -1, 1, None)
    assert function.solve(3)[0].point is None
    assert [of.exact for of in (function.range().lowest.value, function.range().highest.value)] == [1, 3]


def test_bounds_touch_the_box(curve):
    across, up = curve.bounds()
    assert (across.lowest.value.exact, across.highest.value.exact) == (0, 3)
    assert up == curve.range(coordinate=1) and [place.x.exact for place in up.lowest.places] == [0, 2]
    (highest,) = up.highest.places
    assert highest.taken and up.highest.value.exact == curve(highest.x.exact)[1] if highest.x.exact else True
    samples = curve.sample(numpy.linspace(0, 2, 1001))[:, 1]
    assert samples.max() <= float(up.highest.value) + 1e-12 and samples.max() == pytest.approx(float(up.highest.value), abs=1e-5)
    # Symmetric: both maxima are found equal.
    two = Basis("0 0 0 1 2 2 2", 2, alpha="inf").curve([0, 2, 2, 0]).range(normal=[1]).highest
    assert two.value.exact == 2 and len(two.places) == 1


def test_length_and_integral():
    circle_like = Basis("0 0 0 1 1 1", 2, alpha="inf").curve([(0, 0), (1, 2), (2, 0)])
    length = circle_like.length(width="1e-25")
    x = sympy.Symbol("x")
    exact = sympy.integrate(sympy.sqrt(4 + (4 - 8 * x) ** 2), (x, 0, 1))
    lo, hi = length.interval
    assert hi - lo <= Fraction(1, 10**25)
    assert sympy.Rational(lo) <= exact.evalf(40) <= sympy.Rational(hi) and float(length) == pytest.approx(float(exact))
    assert [of.exact for of in circle_like.integral()] == [1, Fraction(2, 3)]
    assert Basis("0 0 1 2 2", 1, alpha=5).curve([(0, 0), (3, 4), (3, 5)]).length(end=1).exact == 5
    function = Basis("0 0 0 1 2 3 3 3", 2, alpha=-1).curve([1, 0, 0, 0, 0])
    assert float(function.integral()) == pytest.approx(6 - 8 * math.log(2))
    assert function.length().exact == 1


def test_a_length_is_what_quadrature_says(curve):
    total = sum(quad(lambda x: math.hypot(*(float(c) for c in curve(Fraction(x), 1))), a, b)[0] for a, b in [(0, 1), (1, 2)])
    assert float(curve.length()) == pytest.approx(total, rel=1e-9)
    first, second = curve.length(end="1/2").interval, curve.length(start="1/2").interval
    lo, hi = curve.length().interval
    assert first[0] + second[0] <= hi and lo <= first[1] + second[1]


def test_interpolation():
    for alpha in ("inf", 5):
        basis = Basis(KNOTS, 2, alpha=alpha)
        curve = basis.interpolate("0 1/2 3/2 2", POINTS)
        assert [curve(x) for x in ("0", "1/2", "3/2", "2")] == POINTS
    theirs = make_interp_spline([0, 0.5, 1.5, 2], numpy.array(POINTS, float), 2, t=[0, 0, 0, 1, 2, 2, 2])
    ours = Basis(KNOTS, 2, alpha="inf").interpolate([0, Fraction(1, 2), "3/2", 2], POINTS)
    numpy.testing.assert_allclose(theirs.c, [[float(c) for c in point] for point in ours.points], atol=1e-12)
    assert Basis(KNOTS, 2, alpha=5).interpolate("0 1/2 3/2 2", [0, 1, 1, 0])("1/2") == 1


def test_the_matrix_says_why_there_is_none():
    basis = Basis(KNOTS, 2, alpha=5)
    matrix = basis.collocation("0 1/4 1/2 3/4")
    assert (matrix.rank, matrix.determinant, matrix.misplaced) == (3, 0, (3,))
    assert matrix.matrix == tuple(basis.B(x) for x in matrix.places)
    assert basis.curve(list(matrix.relation))("1/4") == 0
    assert sympy.Matrix(basis.collocation("0 1/2 3/2 2").matrix).det() == basis.collocation("0 1/2 3/2 2").determinant
    assert basis.collocation("0 1").determinant is None
    with pytest.raises(ValueError, match="^at: .*3"):
        basis.interpolate("0 1/4 1/2 3/4", POINTS)
    with pytest.raises(ValueError, match="^at: places must rise"):
        basis.collocation("0 0")
    with pytest.raises(ValueError, match="^at: place 1 is 3, outside"):
        basis.collocation("0 3")
    with pytest.raises(ValueError, match="^at: 2 places, and there are 4 functions"):
        basis.interpolate("0 1", [0, 1])
    with pytest.raises(ValueError, match="^points: 3 points for 4 places"):
        basis.interpolate("0 1/2 3/2 2", [0, 1, 2])
    with pytest.raises(TypeError, match=r"^at\[1\]: 0.5 is a float"):
        basis.interpolate([0, 0.5, 1.5, 2], POINTS)


def test_insertion_is_boehms():
    curve = Basis(KNOTS, 2, alpha="inf").curve(POINTS)
    finer = curve.insert("1/2 1")
    assert finer.basis.knots == (0, 0, 0, Fraction(1, 2), 1, 1, 2, 2, 2)
    assert all(finer(Fraction(x, 7)) == curve(Fraction(x, 7)) for x in range(15))
    theirs = BSpline(numpy.array([0, 0, 0, 1, 2, 2, 2.0]), numpy.array(POINTS, float), 2)
    for x in (0.5, 1):
        theirs = insert(x, theirs)
    numpy.testing.assert_allclose(theirs.c[: len(finer.points)], [[float(c) for c in point] for point in finer.points])
    function = Basis(KNOTS, 2, alpha="inf").curve([0, 1, 1, 0]).insert([1])
    assert function.points[0] == 0 and isinstance(function(1), Fraction)


def test_insertion_for_an_index():
    cut = Basis("0 0 0 1 1 2 2 2", 2, alpha=5).curve([*POINTS, (4, 0)]).insert([1])
    assert cut.basis.multiplicity(1) == 3 and cut.basis.alpha == 5
    with pytest.raises(ValueError, match="^at: the functions on these knots have the rank"):
        Basis(KNOTS, 2, alpha=5).curve(POINTS).insert(["1/2"])
    with pytest.raises(ValueError, match=r"^at: the new knot 3 is not in \[0, 2\]"):
        Basis(KNOTS, 2, alpha=5).curve(POINTS).insert([3])
    with pytest.raises(ValueError, match="^at: it is for the weights of an index only .* lupas has others"):
        Basis(KNOTS, 2, family="lupas", q="1/2").curve(POINTS).insert([1])


def test_wrong_questions_say_what_is_wrong(curve):
    with pytest.raises(ValueError, match="^coordinate is missing: a point has 2 coordinates.* by normal$"):
        curve.solve(1)
    with pytest.raises(ValueError, match="^coordinate: there is no coordinate 2: a point has 2"):
        curve.range(coordinate=2)
    with pytest.raises(ValueError, match="^normal: here are 3 numbers, and a point has 2 coordinates"):
        curve.solve(normal=[1, 2, 3])
    with pytest.raises(ValueError, match="^normal: it takes the place of a coordinate"):
        curve.solve(normal=[1, 2], coordinate=0)
    with pytest.raises(ValueError, match=r"^start: 2 is not in \[0, 2\)"):
        curve.length(start=2)
    with pytest.raises(ValueError, match=r"^end: 0 is not in \(0, 2\]"):
        curve.bounds(end=0)
    with pytest.raises(ValueError, match="^width: 0 is not positive"):
        curve.length(width=0)
    with pytest.raises(TypeError, match="^value: 0.5 is a float"):
        curve.solve(0.5, coordinate=1)
    with pytest.raises(ValueError, match="^degree: 11 is too high for this: at most 10"):
        Basis([0] * 12 + [1] * 12, 11, alpha=2).curve(range(12)).length()


def test_other_families_have_bounds_too():
    (box,) = Basis(KNOTS, 2, family="lupas", q="1/2").curve([0, 1, 1, 0]).bounds()
    assert box.lowest.value.exact == 0 and 0 < float(box.highest.value) <= 1
    assert float(Curve.of_instance("C5", alpha=-4).length(width="1e-6")) > 0
