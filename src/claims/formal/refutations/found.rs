//! What was found: the basis of a witness, the numbers that come with it, and its values as terms.

use std::ops::RangeInclusive;

use crate::claims::formal::place::Place;
use crate::claims::verdict::Witness;
use crate::scalar::{BigRational, RationalAlgebra, parse_rational};
use crate::spline::{Basis, Index, KnotVector, Side};

/// The basis of a witness, and the numbers that come with it.
pub(super) struct Found<'a> {
    pub(super) witness: &'a Witness,
    pub(super) basis: Basis,
}

impl<'a> Found<'a> {
    pub(super) fn new(witness: &'a Witness) -> Option<Self> {
        let get = |name| text_of(witness, name);
        let knots = KnotVector::new(numbers(get("U")?)?).ok()?;
        // A statement about several indices has none of its own: the classical one does for its numbers.
        let index = get("α").map_or(Ok(Index::infinity()), str::parse).ok()?;
        let basis = Basis::new(knots, get("k")?.parse().ok()?, index).ok()?;
        Some(Self { witness, basis })
    }

    pub(super) fn text(&self, name: &str) -> Option<&'a str> {
        text_of(self.witness, name)
    }

    pub(super) fn natural(&self, name: &str) -> Option<usize> {
        self.text(name)?.parse().ok()
    }

    pub(super) fn number(&self, name: &str) -> Option<BigRational> {
        parse_rational(self.text(name)?).ok()
    }

    pub(super) fn k(&self) -> usize {
        self.basis.degree()
    }

    pub(super) fn knots(&self) -> &KnotVector {
        self.basis.knots()
    }

    /// A term at a point, from the given side. At t_m it is the limit from the left.
    pub(super) fn at(&self, x: &BigRational, side: Side, term: impl Fn(Place) -> String) -> Option<String> {
        let knots = self.knots();
        let side = if x == knots.last() { Side::Left } else { side };
        let span = knots.span_at(x, side)?;
        let (start, end) = knots.ends(span).ok()?;
        Some(if x == start {
            term(Place::start(span.index()))
        } else if x == end {
            term(Place::end(span.index()))
        } else {
            let u = (x - start).over(&(end - x))?;
            format!("(at ((u {u})) {})", term(Place::inside(span.index())))
        })
    }

    /// G_i at a point, from a side.
    pub(super) fn value(&self, x: &BigRational, side: Side, i: usize) -> Option<String> {
        self.at(x, side, |place| place.value("G", i, self.k()))
    }

    /// The derivative of G_i at a point, from a side.
    pub(super) fn slope(&self, x: &BigRational, side: Side, i: usize) -> Option<String> {
        self.at(x, side, |place| place.value("DG", i, self.k()))
    }

    /// A section with these goals for the index and the knots of the witness.
    pub(super) fn section(&self, goals: &str) -> String {
        self.section_with("", goals)
    }

    /// The same, with more than A before the goals.
    pub(super) fn section_with(&self, more: &str, goals: &str) -> String {
        self.section_over(&format!("(let r {}) {more}", self.basis.index().ratio()), goals)
    }

    /// A section with these goals for the knots of the witness, after declarations that say what r is.
    pub(super) fn section_over(&self, declarations: &str, goals: &str) -> String {
        let knots: String = self.knots().knots().iter().map(|t| format!(" {t}")).collect();
        format!("(section {declarations} (knots A 0{knots}) (goals {goals}))")
    }

    /// The span whose ends are written [a, b).
    pub(super) fn span(&self) -> Option<usize> {
        let (start, _) = self.text("span")?.trim_matches(['[', ')', ']']).split_once(", ")?;
        self.knots().span_at(&parse_rational(start).ok()?, Side::Right).map(|span| span.index())
    }
}

/// A list of numbers in parentheses.
pub(super) fn numbers(text: &str) -> Option<Vec<BigRational>> {
    let inner = text.strip_prefix('(')?.strip_suffix(')')?;
    inner.split(", ").map(|number| parse_rational(number).ok()).collect()
}

/// What a witness says under a name.
pub(super) fn text_of<'a>(witness: &'a Witness, name: &str) -> Option<&'a str> {
    witness.given.iter().find(|(known, _)| known == name).map(|(_, value)| value.as_str())
}

/// The functions of the degree that live on a span, by index.
pub(super) fn living(knots: &KnotVector, span: usize, degree: usize) -> RangeInclusive<usize> {
    span.saturating_sub(degree)..=span.min(knots.m() - degree - 1)
}

/// The term is no combination of the functions of the degree, on these knots, that live at the place.
pub(super) fn outside(knots: &KnotVector, place: Place, term: &str, degree: usize) -> String {
    let others: Vec<_> = living(knots, place.span(), degree).map(|i| place.value("G", i, degree)).collect();
    format!("(outside {place} {term} ({}))", others.join(" "))
}

/// left ≠ right, as (left − right)² > 0.
pub(super) fn differ(left: &str, right: &str) -> String {
    format!("(> (^ (- {left} {right}) 2) 0)")
}
