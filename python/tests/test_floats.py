"""Arrays of floats, by SciPy's conventions."""

import numpy
import pytest
from scipy.interpolate import BSpline
from scipy.sparse import issparse

from knotproof import Basis

VECTORS = [
    (0, "0 1 2 4"),
    (1, "0 0 1 3 3"),
    (2, "0 0 0 1 2 3 3 3"),
    (2, "0 0 0 1 1 2 2 2"),
    (3, "0 0 0 0 1 1 1 2 3 3 3 3"),
    (3, "0 1 2 4 5 7 8 9 11"),
    (5, "0 0 0 0 0 0 1/3 2 3 4 4 4 4 4 4"),
]


@pytest.mark.parametrize(("degree", "knots"), VECTORS)
@pytest.mark.parametrize("random", [True, False])
def test_the_matrix_for_infinity_is_scipys(degree, knots, random):
    basis = Basis(knots, degree, alpha="inf")
    t = numpy.array([float(t) for t in basis.knots])
    start, end = (float(x) for x in basis.interval)
    if random:
        x = numpy.random.default_rng(1).uniform(start, end, 200)
    else:
        x = numpy.unique(numpy.clip(t, start, end))
    ours, theirs = basis.design_matrix(x), BSpline.design_matrix(x, t, degree)
    assert issparse(ours) and ours.format == theirs.format == "csr" and ours.shape == theirs.shape
    numpy.testing.assert_array_equal(ours.indptr, theirs.indptr)
    numpy.testing.assert_array_equal(ours.indices, theirs.indices)
    numpy.testing.assert_allclose(ours.data, theirs.data, rtol=1e-13, atol=1e-16)


@pytest.mark.parametrize("of", [{"alpha": -1}, {"alpha": "3/2"}, {"family": "lupas", "q": "1/2"}, {"family": "smoothstep"}])
def test_the_matrix_has_the_exact_values(of):
    basis = Basis("0 0 0 1/2 1 5/2 3 3 3", 2, **of)
    x = [0.0, 0.125, 0.5, 1.0, 1.75, 2.5, 3.0]
    exact = [[float(value) for value in basis.B(str(point))] for point in x]
    numpy.testing.assert_allclose(basis.design_matrix(x).toarray(), exact, rtol=3e-16, atol=0)


def test_the_end_of_the_interval_is_a_limit_from_the_left():
    # Not clamped, and a jump at t_(n+1).
    for of in ({"alpha": -1}, {"family": "lupas", "q": "1/2"}):
        basis = Basis("0 0 1 1 2 2", 1, **of)
        assert basis.interval == (0, 2)
        unclamped = Basis("0 1 2 3 4", 1, **of)
        assert unclamped.design_matrix([3.0]).toarray().tolist() == [[0, 0, 1]]


def test_ends_that_are_no_floats_are_ends_all_the_same():
    for of in ({"alpha": -1}, {"family": "lupas", "q": "1/2"}):
        basis = Basis("1/3 1/3 1/3 1 5/3 5/3 5/3", 2, **of)
        assert basis.design_matrix([1 / 3, 5 / 3]).toarray().tolist() == [[1, 0, 0, 0], [0, 0, 0, 1]]


def test_extrapolation_and_points_outside_are_refused():
    basis = Basis("0 1 2 4 5 7 8 9", 3, alpha=-1)
    with pytest.raises(ValueError, match="extrapolate: .*may have poles"):
        basis.design_matrix([4.5], extrapolate=True)
    for wrong in ([3.0], [4.5, 6.0], [numpy.nan], [numpy.inf]):
        with pytest.raises(ValueError, match=r"x: .* is not in \[t_k, t_\(n\+1\)\] = \[4.0, 5.0\]"):
            basis.design_matrix(wrong)
    with pytest.raises(ValueError, match="an array of one axis"):
        basis.design_matrix([[4.5]])


def test_nothing_gives_nothing_and_strides_do_not_matter():
    basis = Basis("0 0 0 1 1 1", 2, alpha=2)
    assert basis.design_matrix([]).shape == (0, 3)
    x = numpy.linspace(0, 1, 9)[::2]
    assert (basis.design_matrix(x) != basis.design_matrix(list(x))).nnz == 0


def test_a_degree_beyond_floats_says_so():
    basis = Basis([0] * 33 + [1] * 33, 32, alpha=-1)
    with pytest.raises(ValueError, match="the degree 32 is too high: at most 31"):
        basis.design_matrix([0.5])


def test_numpy_and_scipy_are_not_imported_for_exact_work():
    import subprocess
    import sys

    program = (
        "import sys; from knotproof import Basis; b = Basis('0 0 1 1', 1, alpha=2); b.B('1/2'); b.pieces(0); b.shape(0); "
        "b.curve([0, 1])('1/2'); print([name for name in ('numpy', 'scipy', 'sympy') if name in sys.modules])"
    )
    assert subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True).stdout == "[]\n"
