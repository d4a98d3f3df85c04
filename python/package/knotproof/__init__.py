"""Exact B-splines, rational ones too, and verdicts about them.

    >>> from knotproof import Basis
    >>> basis = Basis("0 0 0 1 2 3 3 3", 2, alpha=-1)
    >>> basis.B("1/2")
    (Fraction(4, 9), Fraction(32, 63), Fraction(1, 21), Fraction(0, 1), Fraction(0, 1))

Numbers go in as ``int``, ``Fraction``, ``Decimal``, texts like ``"1/3"`` and rationals of SymPy, and come out as ``Fraction``; a
float is refused, as it is not the number that was meant. A verdict is "proved", "refuted" with a witness, or "undecided", and so
no ``bool``.

- ``Basis``: basis functions on knots: values, derivatives, formulas, maxima, claims;
- ``Curve``: what control points make of them: ``Basis.curve``;
- ``judge``: all claims of a paper; ``search``: counterexamples to "every basis function has one maximum";
- ``families``: the weights that there are.
"""

from ._native import __version__
from ._basis import Basis, Extremum, Family, Jump, Piece, Pieces, Shape, Slopes, families
from ._curve import Curve, Join, JoinSide, Nurbs, Tangent
from ._judge import Judging, judge
from ._measure import Bound, BoundPlace, Collocation, Enclosure, Place, Range, Solution
from ._search import Finding, Search, SearchState, search
from ._verdict import Theorem, Verdict, Verdicts, Witness

__all__ = [
    "Basis",
    "Bound",
    "BoundPlace",
    "Collocation",
    "Curve",
    "Enclosure",
    "Extremum",
    "Family",
    "Finding",
    "Join",
    "JoinSide",
    "Judging",
    "Jump",
    "Nurbs",
    "Piece",
    "Pieces",
    "Place",
    "Range",
    "Search",
    "SearchState",
    "Shape",
    "Slopes",
    "Solution",
    "Tangent",
    "Theorem",
    "Verdict",
    "Verdicts",
    "Witness",
    "__version__",
    "families",
    "judge",
    "search",
]
