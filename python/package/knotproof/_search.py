"""The search for basis functions with more than one maximum."""

from __future__ import annotations

import json
import os
from collections.abc import Iterable
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any, Literal

from . import _native
from ._basis import Basis
from ._exact import Exact, Setting, index, rows, whole


@dataclass(frozen=True)
class Finding:
    """A function with more than one local maximum: G_index of ``basis``.

    ``dip`` has bounds of how far it falls between two maxima, as a share of its largest value; ``cases`` is how many of the search
    are shrunk to it, and ``again`` the command that shows it.
    """

    basis: Basis
    index: int
    gaps: tuple[Fraction, ...]
    maxima: int
    dip: tuple[Fraction, Fraction]
    cases: int
    again: str


@dataclass(frozen=True)
class SearchState:
    """How far a search has come: ``done`` of ``total`` positions. Of ``cases`` so many have ``several`` maxima, and so many are
    ``undecided``; ``findings`` are shrunk, the smallest first, each once."""

    done: int
    total: int
    cases: int
    several: int
    undecided: int
    findings: tuple[Finding, ...] = field(repr=False)

    @property
    def complete(self) -> bool:
        """Is there nothing left to do?"""
        return self.done == self.total

    def __str__(self) -> str:
        open_ = f", {self.undecided} not decided" if self.undecided else ""
        return (
            f"{self.done} of {self.total} positions: {self.cases} cases, {self.several} with several maxima{open_}; "
            f"{len(self.findings)} found"
        )


class Search:
    """A search under way: an iterator of ``SearchState``, about five a second; who is slow misses some, but never the last one.

    The work goes on in threads of its own. Ctrl-C stops it, and so does ``stop()``. What comes out depends on what is searched only.
    """

    def __init__(self, native: _native.Searching) -> None:
        self._native = native

    @property
    def total(self) -> int:
        """How many positions there are."""
        return self._native.total

    def __iter__(self) -> Search:
        return self

    def __next__(self) -> SearchState:
        state = self._native.next()
        if state is None:
            raise StopIteration
        (done, total), (cases, several, undecided), findings = state
        return SearchState(done, total, cases, several, undecided, tuple(_finding(json.loads(text)) for text in findings))

    def run(self) -> SearchState:
        """Waits for the end: the last state. ``ValueError`` if that was given already."""
        last = None
        for last in self:  # noqa: B007: the last one is wanted
            pass
        if last is None:
            raise ValueError("the search has ended, and its last state was given: begin another one")
        return last

    def stop(self) -> None:
        """Ends it at its next look, a moment later."""
        self._native.stop()


def search(
    degree: int,
    find: Literal["several", "most", "equal", "deepest"] = "several",
    *,
    limit: int | None = None,
    limit_gap: int | None = None,
    limit_height: int | None = None,
    count: int | None = None,
    seed: int | None = None,
    spread: int | None = None,
    alpha: Exact | float | Iterable[Exact | float] = (),
    family: str | os.PathLike[str] | None = None,
    shard: str | None = None,
    **parameters: Setting,
) -> Search:
    """Searches for basis functions with more than one local maximum: counterexamples to Conjecture 3.1, each decided exactly.

    All functions up to the size ``limit`` (the sum of the gaps between the k + 2 knots plus the height of α), with no gap above
    ``limit_gap`` and no height above ``limit_height``; or ``count`` random ones of a ``seed``, whose gaps differ by factors up to
    2**``spread``, with any α or one of ``alpha``. With a ``family``, as far as ``parameters`` do not fix them, all its parameters are
    searched, too. ``shard="0/4"`` is the first of four parts.

    find
        "several": more than one maximum; "most": the largest number of them; "equal": two equal largest ones for some α;
        "deepest": the ten that fall deepest between two.

        state = search(3, limit=9).run()
        state.findings[0].basis
    """
    limits = (_count(limit, "limit"), _count(limit_gap, "limit_gap"), _count(limit_height, "limit_height"))
    sample = (_count(count, "count"), _count(seed, "seed"), _count(spread, "spread"))
    indices = [alpha] if isinstance(alpha, str) or not isinstance(alpha, Iterable) else list(alpha)
    if count is None and (indices or seed is not None or spread is not None):
        raise ValueError("count: alpha, a seed and a spread are for random cases; say how many, such as count=10000")
    if count is not None and any(limit is not None for limit in limits):
        raise ValueError("count: random cases have no limit; leave one of them away")
    if family is not None and indices:
        raise ValueError("family: it takes the place of alpha; leave one of them away")
    if family is None and parameters:
        raise ValueError(f"family: say whose parameters {', '.join(parameters)} are, such as family=\"lupas\", q=\"1/3\"")
    settings = [(parameter, rows(setting, parameter)) for parameter, setting in parameters.items()]
    of = None if family is None else (os.fspath(family), settings)
    return Search(
        _native.Searching(whole(degree, "degree"), find, limits, sample, [index(one) for one in indices], of, shard)
    )


def _count(value: int | None, name: str) -> int | None:
    return None if value is None else whole(value, name)


def _finding(record: dict[str, Any]) -> Finding:
    knots, degree, family = [Fraction(t) for t in record["knots"]], record["degree"], record.get("family")
    if family:
        basis = Basis._with(knots, degree, family["name"], family["parameters"].items())
    else:
        basis = Basis(knots, degree, alpha=_between(record))
    lo, hi = record["witness"]["dip"]
    return Finding(
        basis=basis,
        index=record["index"],
        gaps=tuple(Fraction(gap) for gap in record["gaps"]),
        maxima=record["witness"]["local_maxima"],
        dip=(Fraction(lo), Fraction(hi)),
        cases=record["cases"],
        again=record["reproduce"],
    )


def _between(record: dict[str, Any]) -> str:
    """α, or the first of the two between which both maxima are equal."""
    equal = record["witness"].get("equal")
    alpha: str = equal["alpha"][0] if equal else record["alpha"]
    return alpha
