"""Verdicts, and what they rest on."""

from __future__ import annotations

import json
from dataclasses import dataclass, field
from fractions import Fraction
from html import escape
from typing import TYPE_CHECKING, Any, Literal, NoReturn

if TYPE_CHECKING:
    from ._basis import Basis

Status = Literal["proved", "refuted", "undecided", "not-formal", "not-applicable"]


@dataclass(frozen=True)
class Theorem:
    """A theorem that Coq has checked."""

    name: str
    file: str
    status: Literal["proved", "refuted"]
    degrees: str


@dataclass(frozen=True)
class Witness:
    """An exact counterexample that can be checked by hand.

    ``claimed`` is what the statement says there, with numbers in the place of names, ``found`` what is so, and ``again`` the command
    that shows it. ``witness["x"]`` is a value of ``given``: an ``int`` for an index, else a ``Fraction``, or a text where it is no rational number.
    """

    given: tuple[tuple[str, int | Fraction | str], ...]
    claimed: str
    found: str
    again: str
    degree: int | None
    knots: tuple[Fraction, ...]
    alpha: str | None
    family: tuple[str, tuple[tuple[str, str], ...]] | None

    def __getitem__(self, name: str) -> int | Fraction | str:
        for own, value in self.given:
            if own == name:
                return value
        raise KeyError(f"{name!r}: there are {', '.join(own for own, _ in self.given)}")

    @property
    def basis(self) -> Basis | None:
        """The basis that it is about; ``None`` where it is about weights alone."""
        from ._basis import Basis

        if self.degree is None or not self.knots:
            return None
        if self.family is None:
            return Basis(self.knots, self.degree, alpha=self.alpha)
        name, parameters = self.family
        return Basis._with(self.knots, self.degree, name, parameters)

    def __str__(self) -> str:
        given = ", ".join(f"{name} = {value}" for name, value in self.given)
        return f"{given}: it says {self.claimed}; but {self.found}"

    def _repr_html_(self) -> str:
        rows = [*self.given, ("it says", self.claimed), ("but", self.found)]
        return f"<table>{''.join(f'<tr><th>{escape(name)}</th><td>{escape(str(value))}</td></tr>' for name, value in rows)}</table>"


@dataclass(frozen=True, repr=False)
class Verdict:
    """What a statement comes to.

    ``status`` is "proved", "refuted", "undecided", "not-formal" or "not-applicable"; ``scope`` says how far a proof reaches:
    "points", "instance", "alpha", "knots" or "degree", each further than the one before. A refutation has a ``witness``, and
    what is open a ``reason``. ``amended`` is the verdict on the amended statement, where the printed one is refuted.

    It is no truth value: "undecided" is neither true nor false. Write ``verdict.is_proved`` or ``verdict.status == "proved"``.
    """

    claim: str
    form: str
    title: str
    locator: str
    statement: str
    status: Status
    words: str
    scope: str | None
    degrees: tuple[int, ...]
    any_weights: bool
    witness: Witness | None
    reason: str | None
    remarks: tuple[str, ...]
    certificate: str | None
    checked_by: tuple[str, ...]
    theorems: tuple[Theorem, ...]
    severity: str | None
    amended: Verdict | None
    latex: str = field(compare=False)
    mathml: str = field(compare=False)

    @property
    def is_proved(self) -> bool:
        """Is it "proved"?"""
        return self.status == "proved"

    @property
    def is_refuted(self) -> bool:
        """Is it "refuted"?"""
        return self.status == "refuted"

    @property
    def is_undecided(self) -> bool:
        """Is it "undecided"?"""
        return self.status == "undecided"

    def __bool__(self) -> NoReturn:
        raise TypeError(
            f'a verdict is no truth value, as "undecided" is neither true nor false, and this one is "{self.status}": write '
            'verdict.is_proved, or verdict.status == "proved"'
        )

    def __repr__(self) -> str:
        name = f"{self.claim}: " if self.claim else ""
        form = "" if self.form == "printed" else f", {self.form}"
        more = f": {self.reason}" if self.reason else ""
        return f"<{name}{self.words}{form}{more}>"

    def __str__(self) -> str:
        lines = [f"{self.claim}: {self.words}" if self.claim else self.words, self.statement]
        if self.reason:
            lines.append(self.reason)
        if self.witness:
            lines.append(f"at {self.witness}")
        if self.amended is not None:
            lines.append(f"amended: {self.amended.words}: {self.amended.statement}")
        return "\n".join(lines)

    def _repr_latex_(self) -> str:
        return self.latex

    def _repr_html_(self) -> str:
        return f"<table>{self._row()}</table>"

    def _row(self) -> str:
        told = [f"<strong>{escape(self.words)}</strong>", self.mathml]
        told += [escape(text) for text in (self.reason, str(self.witness) if self.witness else None) if text]
        if self.amended is not None:
            told.append(f"amended: <strong>{escape(self.amended.words)}</strong> {self.amended.mathml}")
        return f'<tr><th>{escape(self.claim)}</th><td style="text-align: left">{"<br>".join(told)}</td></tr>'


class Verdicts(tuple[Verdict, ...]):
    """Verdicts in order; ``verdicts["T3.5.3"]`` is the one on that claim.

    Neither are they a truth value, whether there are any or not: write ``all(verdict.is_proved for verdict in verdicts)``.
    """

    def __getitem__(self, key: Any) -> Any:
        if isinstance(key, str):
            for verdict in self:
                if verdict.claim == key:
                    return verdict
            raise KeyError(f"{key!r}: there are {', '.join(verdict.claim for verdict in self)}")
        found = super().__getitem__(key)
        return Verdicts(found) if isinstance(key, slice) else found

    def __bool__(self) -> NoReturn:
        raise TypeError("verdicts are no truth value: write all(verdict.is_proved for verdict in verdicts)")

    @property
    def counts(self) -> dict[str, int]:
        """How many there are of each status."""
        counts: dict[str, int] = {}
        for verdict in self:
            counts[verdict.status] = counts.get(verdict.status, 0) + 1
        return counts

    def __repr__(self) -> str:
        width = max((len(verdict.claim) for verdict in self), default=0)
        lines = [f"  {verdict.claim:{width}}  {verdict.words}" for verdict in self]
        counts = ", ".join(f"{count} {status}" for status, count in self.counts.items())
        return "\n".join([f"<{counts or 'no verdict'}>", *lines])

    def _repr_html_(self) -> str:
        return f"<table>{''.join(verdict._row() for verdict in self)}</table>"


def read(text: str) -> Verdict:
    """The verdict in what the library writes as JSON."""
    return _verdict(json.loads(text))


def _verdict(told: dict[str, Any]) -> Verdict:
    theorems = [Theorem(of["name"], of["file"], of["status"], of["degrees"]) for of in told.get("theorems", [])]
    return Verdict(
        claim=told["claim"],
        form=told["form"],
        title=told["title"],
        locator=told["locator"],
        statement=told["statement"],
        status=told["status"],
        words=told["words"],
        scope=told.get("scope"),
        degrees=tuple(told.get("degrees", [])),
        any_weights=told.get("any_weights", False),
        witness=_witness(told),
        reason=told.get("reason"),
        remarks=tuple(told.get("remarks", [])),
        certificate=told.get("certificate"),
        checked_by=tuple(told.get("checked_by", [])),
        theorems=tuple(theorems),
        severity=told["severity"],
        amended=_verdict(told["amended"]) if told["amended"] else None,
        latex=told["latex"],
        mathml=told["mathml"] or escape(told["statement"]),
    )


def _witness(told: dict[str, Any]) -> Witness | None:
    if told["at"] is None:
        return None
    (given, found, again), witness = told["at"], told["witness"]
    family = witness.get("family")
    whole = {"k", *(bound["name"] for bound in witness["given"] if isinstance(bound["value"], int))}
    return Witness(
        given=tuple((name, int(value) if name in whole else _number(value)) for name, value in given),
        claimed=witness["claimed"],
        found=found,
        again=again,
        degree=witness.get("k"),
        knots=tuple(Fraction(t) for t in witness.get("knots", [])),
        alpha=None if family else witness["alpha"],
        family=(family["name"], tuple(sorted(family["parameters"].items()))) if family else None,
    )


def _number(text: str) -> Fraction | str:
    try:
        return Fraction(text)
    except ValueError:
        return text
