"""Papers."""

from __future__ import annotations

import os
from collections.abc import Iterable

from . import _native
from ._exact import whole
from ._verdict import Verdict, Verdicts, read


class Judging:
    """The claims of a paper, as they are judged: an iterator of ``Verdict``, in the order of the paper.

    The work goes on in threads of its own, on all cores, whoever waits or not: ``done`` of ``total`` are judged. Ctrl-C stops it:
    claims that are under way are finished, unheard, and no other begins.
    """

    def __init__(self, native: _native.Judging) -> None:
        self._native = native
        self._given = 0

    @property
    def total(self) -> int:
        """How many claims there are."""
        return self._native.total

    @property
    def done(self) -> int:
        """How many are judged."""
        return self._native.done

    def __iter__(self) -> Judging:
        return self

    def __next__(self) -> Verdict:
        told = self._native.next()
        if told is None:
            raise StopIteration
        self._given += 1
        return read(told)

    def __len__(self) -> int:
        """How many are still to come: for bars of progress."""
        return self.total - self._given

    def verdicts(self) -> Verdicts:
        """All that are still to come."""
        return Verdicts(self)

    def stop(self) -> None:
        """Begins no further claim."""
        self._native.stop()

    def __repr__(self) -> str:
        return f"<judging: {self.done} of {self.total} claims done>"


def judge(
    paper: str | os.PathLike[str], claims: str | Iterable[str] = (), degrees: int | tuple[int, int] | None = None
) -> Judging:
    """Judges the claims of a paper: on small cases and its examples, for every x, with what is proved for good.

    ``paper`` is a folder as docs/your-paper.md of the project says, or the name of a paper that comes along, such as "classical";
    ``claims`` are the identifiers of those wanted; ``degrees`` is one, or the first and the last: then nothing is proved beyond
    them. ``ValueError`` for what is wrong in the folder, with its place.

        for verdict in judge("classical"):
            print(verdict)
    """
    chosen = [claims] if isinstance(claims, str) else list(claims)
    within: tuple[int, int] | None = None
    if isinstance(degrees, tuple):
        first, last = (whole(degree, "degrees") for degree in degrees)
        if first > last:
            raise ValueError(f"degrees: {first} is above {last}: write the first and the last one, such as (1, 3)")
        within = (first, last)
    elif degrees is not None:
        within = (whole(degrees, "degrees"),) * 2
    return Judging(_native.Judging(os.fspath(paper), chosen, within))
