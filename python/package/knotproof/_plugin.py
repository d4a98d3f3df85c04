"""What pytest finds of this package by its entry point."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from .testing import check_basis as check


@pytest.fixture
def check_basis() -> Callable[..., None]:
    """``knotproof.testing.check_basis``: holds a function that evaluates a basis against exact values."""
    return check
