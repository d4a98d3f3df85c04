"""A bug of the library is an exception, and ends no process."""

import pytest

from knotproof import Basis


def test_a_panic_is_an_exception():
    basis = Basis("0 0 1 1", 1, alpha=-1)
    # Past what Python checks.
    with pytest.raises(RuntimeError, match="internal error: .*; please report this bug"):
        basis._native.pieces(99)
    assert sum(basis.B("1/3")) == 1
