"""Exact values, against SciPy, SymPy and the recursion itself."""

import copy
import pickle
import random
from fractions import Fraction

import numpy
import pytest
import sympy
from scipy.interpolate import BSpline

import knotproof
from knotproof import Basis

# Simple knots, full multiplicity, more than that, knots that are not clamped, gaps far apart.
VECTORS = [
    (0, "0 1"),
    (0, "0 0 1 3 3"),
    (1, "0 0 1 3 3"),
    (1, "0 0 0 1 1 1 2 2 2"),
    (2, "0 0 0 1 2 3 3 3"),
    (2, "0 0 0 1 1 1 2 2 2"),
    (2, "0 0 0 1 1 1 1 2 2 2"),
    (3, "0 1 2 4 5 7 8 9 11"),
    (3, "-1/3 -1/3 -1/3 -1/3 0 1/1000 1000 1000 1000 1000"),
    (3, "0 0 0 0 0 1 2 2 2 2 2"),
]
ALPHAS = ["inf", "-1", "2", "-1/1000", "1001/1000"]


def weight(alpha, x, a, b):
    """D2.3 of the paper, word for word."""
    if not a <= x < b:
        return Fraction(0)
    return (x - a) / (b - a) if alpha == "inf" else alpha * (x - a) / (x + (alpha - 1) * b - alpha * a)


def recursion(basis, i, d, x):
    """D3.3, word for word: from the right, and 0 at t_m."""
    t, alpha = basis.knots, basis.alpha
    if d == 0:
        return Fraction(t[i] <= x < t[i + 1])
    own, next_ = weight(alpha, x, t[i], t[i + d]), weight(alpha, x, t[i + 1], t[i + 1 + d])
    return own * recursion(basis, i, d - 1, x) + (1 - next_) * recursion(basis, i + 1, d - 1, x)


def places(basis):
    """Knots, what lies between, and what lies outside."""
    distinct = sorted(set(basis.knots))
    between = [(3 * a + b) / 4 for a, b in zip(distinct, distinct[1:])]
    return [distinct[0] - 1, *distinct, *between, distinct[-1] + 1]


@pytest.mark.parametrize(("degree", "knots"), VECTORS)
@pytest.mark.parametrize("alpha", ALPHAS)
def test_values_are_those_of_the_recursion(degree, knots, alpha):
    basis = Basis(knots, degree, alpha=alpha)
    for x in places(basis):
        if x != basis.knots[-1]:
            assert basis.B(x) == tuple(recursion(basis, i, degree, x) for i in range(len(basis))), x


@pytest.mark.parametrize(("degree", "knots"), VECTORS)
@pytest.mark.parametrize("alpha", ALPHAS)
def test_formulas_have_the_values_and_derivatives(degree, knots, alpha):
    basis = Basis(knots, degree, alpha=alpha)
    for i in range(len(basis)):
        pieces = basis.pieces(i)
        for x in places(basis):
            own = [piece for piece in pieces if piece.start <= x < piece.end or (piece.closed and x == piece.end)]
            assert basis.B(x)[i] == (own[0](x) if own else 0)
            before = [piece for piece in pieces if piece.start < x <= piece.end]
            assert basis.B(x, side="left")[i] == (before[0](x) if before else 0)


@pytest.mark.parametrize("alpha", ALPHAS)
def test_sympy_has_the_same_functions(alpha):
    basis = Basis("0 0 0 1 2 2 2", 2, alpha=alpha)
    x = sympy.Symbol("x", real=True)
    for i, function in enumerate(basis.to_sympy()):
        assert function == basis.to_sympy(i)
        for place in ["1/7", "1", "3/2", "2", "3", "-1"]:
            value = function.subs(x, sympy.Rational(place))
            assert Fraction(int(value.p), int(value.q)) == basis.B(place)[i]
        for place in ["1/7", "3/2"]:
            slope = function.diff(x, 2).subs(x, sympy.Rational(place))
            assert Fraction(int(slope.p), int(slope.q)) == basis.B(place, nu=2)[i]


@pytest.mark.parametrize(("degree", "knots"), [(k, knots) for k, knots in VECTORS if k > 0])
def test_derivatives_for_infinity_are_those_of_scipy(degree, knots):
    basis = Basis(knots, degree, alpha="inf")
    start, end = basis.interval
    t = numpy.array([float(t) for t in basis.knots])
    for i in range(len(basis)):
        theirs = BSpline(t, numpy.eye(len(basis))[i], degree)
        for nu in range(degree + 1):
            for x in places(basis):
                if start < x < end and x not in basis.knots:
                    assert float(basis.B(x, nu=nu)[i]) == pytest.approx(float(theirs(float(x), nu=nu)), rel=1e-9, abs=1e-9)


def test_the_last_knot_is_a_limit_from_the_left_and_outside_is_zero():
    basis = Basis("0 0 0 1 2 2 2", 2, alpha=5)
    assert basis.B(2) == basis.B(2, side="left") == (0, 0, 0, 1)
    assert basis.B(0) == (1, 0, 0, 0)
    assert basis.B(0, side="left") == basis.B(-1) == basis.B(3, nu=1) == (0, 0, 0, 0)


def test_sides_differ_at_full_multiplicity_and_slopes_at_simple_knots():
    jumps = Basis("0 0 0 1 1 1 2 2 2", 2, alpha=-1)
    assert (jumps.B(1, side="left"), jumps.B(1)) == ((0, 0, 1, 0, 0, 0), (0, 0, 0, 1, 0, 0))
    corner = Basis.of_instance("U4", alpha=-1)
    slopes = [corner.B(1, nu=1, side=side)[1] for side in ("left", "right")]
    assert slopes == [Fraction(-10, 9), Fraction(-7, 9)]


def test_high_orders_of_derivatives():
    basis = Basis("0 0 1 1", 1, alpha=-1)
    # φ = x/(2 − x) = −1 + 2/(2 − x), so φ^(n)(0) = 2 n!/2^(n+1).
    assert basis.B(0, nu=20)[1] == Fraction(2 * 2432902008176640000, 2**21)


def test_other_families():
    knots = "0 0 0 1 2 2 2"
    one = Basis(knots, 2, family="lupas", q=1)
    assert one.B("1/3") == Basis(knots, 2, family="classical").B("1/3") == Basis(knots, 2, alpha="inf").B("1/3")
    lupas = Basis(knots, 2, family="lupas", q="1/2")
    assert (lupas.family, lupas.parameters, lupas.alpha) == ("lupas", {"q": "1/2"}, None)
    assert sum(lupas.B("1/3")) == 1 and lupas.pieces(1)[0]("1/3") == lupas.B("1/3")[1]
    nurbs = Basis(knots, 2, family="nurbs", omega=[1, 2, "1/2", 3])
    assert sum(nurbs.B("1/3")) == 1
    assert Basis(knots, 2, r="1/2").alpha == -1


def test_a_family_of_ones_own(tmp_path):
    file = tmp_path / "own.toml"
    file.write_text('name = "own"\ntitle = "mine"\nsource = "nowhere"\n[parameters]\nr = "r > 0"\n[weight]\nrise = "r^d*(x - a)"\nfall = "b - x"\n')
    assert Basis("0 0 1 1", 1, family=file, r=2).B("1/2") == (Fraction(1, 3), Fraction(2, 3))
    file.write_text('name = "own"\n')
    with pytest.raises(ValueError, match=r"(?s)family: .*own\.toml, line 1.*missing field `title`.*\^"):
        Basis("0 0 1 1", 1, family=file)


def test_names_of_the_paper():
    assert Basis.of_instance("U4", alpha=2) == Basis("0 0 0 1 2 3 3 3", 2, alpha=2)
    with pytest.raises(ValueError, match="`U99` is no instance of the paper .*U4"):
        Basis.of_instance("U99")
    with pytest.raises(ValueError, match="alpha: the paper shows U4 for .*: choose one"):
        Basis.of_instance("U4")
    with pytest.raises(ValueError, match="degree: .*degrees"):
        Basis.of_instance("U0", alpha=2)


def test_bases_read_back_compare_and_travel():
    bases = [
        Basis("0 0 0 1/2 1 1 1", 2, alpha="-1/2"),
        Basis("0 0 1 1", 1, alpha="inf"),
        Basis("0 0 0 1 2 2 2", 2, family="lupas", q="1/2"),
        Basis("0 0 0 1 2 2 2", 2, family="nurbs", omega=[1, 2, "1/2", 3]),
    ]
    assert repr(bases[0]) == 'Basis("0 0 0 1/2 1 1 1", 2, alpha="-1/2")'
    for basis in bases:
        for other in (eval(repr(basis)), pickle.loads(pickle.dumps(basis)), copy.copy(basis)):
            assert other == basis and hash(other) == hash(basis) and other.B("1/3") == basis.B("1/3")
    assert len(set(bases)) == len(bases) and bases[0] != "a basis"


def test_functions_are_numbered_from_0_to_n():
    basis = Basis("0 0 0 1 2 2 2", 2, alpha=-1)
    assert (len(basis), basis.n, basis.degree, basis.interval, basis.multiplicity(0)) == (4, 3, 2, (0, 2), 3)
    assert basis.support(1) == (0, 2)
    for call in (basis.pieces, basis.shape, basis.support, basis.to_sympy):
        with pytest.raises(IndexError, match="there is no function 4: the basis has the functions 0 to 3"):
            call(4)
        with pytest.raises(ValueError, match="i: -1 is negative"):
            call(-1)


def test_a_degree_that_is_too_high_for_formulas():
    basis = Basis([0] * 22 + [1] * 22, 21, alpha=-1)
    with pytest.raises(ValueError, match="degree: 21 is too high for this: at most 20"):
        basis.pieces(0)
    assert sum(basis.B("1/3")) == 1


def test_random_bases_add_up_to_one():
    drawn = random.Random(1)
    for _ in range(20):
        degree = drawn.randrange(1, 6)
        knots = sorted(Fraction(drawn.randrange(20), drawn.randrange(1, 4)) for _ in range(2 * degree + 5))
        basis = Basis(knots, degree, alpha=-drawn.randrange(1, 9))
        start, end = basis.interval
        if start < end:
            assert sum(basis.B((start + 2 * end) / 3)) == 1


def test_families_are_listed():
    families = {family.name: family for family in knotproof.families()}
    assert families["lupas"].parameters == ("q",) and "Lupaş" in families["lupas"].title
