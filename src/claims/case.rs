//! The cases in which claims are judged: the paper's instances, and small ones in order of size.

use std::sync::OnceLock;

use crate::analysis::{Piece, Pieces, SpanPieces, coordinate_between};
pub use crate::judge::Origin;
use crate::scalar::{BigRational, Jet, integer, rationals_between};
use crate::spline::{Basis, Index, KnotVector, Side, Span, by_definition};

use super::hypothesis::{Hypothesis, WeightHypothesis};
use super::verdict::{Stop, Witness, show};

/// Something that a statement can be judged on.
pub trait Case: Sync {
    /// The conditions that a statement about such cases can ask for.
    type Hypothesis: std::fmt::Display + PartialEq + Send + Sync;
    /// Where it comes from.
    fn origin(&self) -> Origin;
    /// Is the hypothesis true here?
    fn meets(&self, hypothesis: &Self::Hypothesis) -> bool;
    /// k, where there is one.
    fn degree(&self) -> Option<usize>;
    /// How many bases or curves the case is about.
    fn instances(&self) -> usize {
        1
    }
}

/// A basis to judge claims on, with its pieces computed once and when first asked for.
#[derive(Debug)]
pub struct BasisCase {
    basis: Basis,
    origin: Origin,
    pieces: OnceLock<Pieces>,
    conjugate: OnceLock<Pieces>,
    definition: OnceLock<Vec<Vec<Piece>>>,
}

impl Case for BasisCase {
    type Hypothesis = Hypothesis;
    fn origin(&self) -> Origin {
        self.origin
    }
    fn meets(&self, hypothesis: &Hypothesis) -> bool {
        hypothesis.holds(&self.basis)
    }
    fn degree(&self) -> Option<usize> {
        Some(self.basis.degree())
    }
}

impl BasisCase {
    /// A case of the given origin.
    #[must_use]
    pub fn new(basis: Basis, origin: Origin) -> Self {
        let (pieces, conjugate, definition) = (OnceLock::new(), OnceLock::new(), OnceLock::new());
        Self { basis, origin, pieces, conjugate, definition }
    }

    /// The basis.
    #[must_use]
    pub fn basis(&self) -> &Basis {
        &self.basis
    }

    /// U.
    #[must_use]
    pub fn knots(&self) -> &KnotVector {
        self.basis.knots()
    }

    /// k.
    #[must_use]
    pub fn k(&self) -> usize {
        self.basis.degree()
    }

    /// n.
    #[must_use]
    pub fn n(&self) -> usize {
        self.basis.n()
    }

    /// The pieces of the basis.
    pub fn pieces(&self) -> &Pieces {
        self.pieces.get_or_init(|| Pieces::of(&self.basis))
    }

    /// G_i^k on the given span by the definition, over the variable u: the pieces once more, by the other way.
    pub fn definition_piece(&self, pieces: &SpanPieces, i: usize) -> Piece {
        let all = self.definition.get_or_init(|| {
            let top = |pieces: &SpanPieces| by_definition(&self.basis, pieces.span, &pieces.x).ok()?.pop();
            self.pieces().spans().iter().filter_map(top).collect()
        });
        let at = self.pieces().spans().binary_search_by_key(&pieces.span, |pieces| pieces.span);
        let piece = at.ok().and_then(|at| all.get(at)?.get(i));
        piece.cloned().unwrap_or_else(|| self.pieces().zero())
    }

    /// The basis of the conjugate index.
    #[must_use]
    pub fn conjugate_basis(&self) -> Basis {
        self.basis.with_index(self.basis.index().conjugate())
    }

    /// The pieces of the basis of the conjugate index.
    pub fn conjugate_pieces(&self) -> &Pieces {
        self.conjugate.get_or_init(|| Pieces::of(&self.conjugate_basis()))
    }

    /// All G_i^k(x) by the definition, word for word.
    #[must_use]
    pub fn values(&self, x: &BigRational, side: Side) -> Vec<BigRational> {
        definition_values(&self.basis, x, side)
    }

    /// The values and derivatives of all functions of all degrees, as jets of order 1 by the definition:
    /// entry d, i is G_i^d. `None` where the limit is taken outside of [t_0, t_m].
    #[must_use]
    pub fn jet_table(&self, x: &BigRational, side: Side, order: usize) -> Option<Vec<Vec<Jet<BigRational>>>> {
        let span = self.knots().span_at(x, side)?;
        by_definition(&self.basis, span, &Jet::variable(x.clone(), order)).ok()
    }

    /// A witness in this case; `at` names the place in it. An `x` among the places makes it one about values
    /// there, which a command can show.
    pub(super) fn witness<const N: usize>(
        &self,
        at: [(&str, String); N],
        claimed: String,
        found: String,
    ) -> Witness {
        let x = at.iter().find(|(name, _)| *name == "x").map(|(_, x)| x.clone());
        Witness { reproduce: x.map(|x| self.command(&x, "")), ..self.bare_witness(at, claimed, found) }
    }

    /// The command that shows values and derivatives at x.
    fn command(&self, x: &str, options: &str) -> String {
        let knots: Vec<_> = self.knots().knots().iter().map(show).collect();
        let (degree, knots, alpha) = (self.k(), knots.join(","), self.basis.index());
        format!(
            "knotproof eval --degree {degree} --knots {knots} --alpha {alpha} --x {x} --derivatives 1{options}"
        )
    }

    /// A witness about more than the values of this basis at one place: no single command shows it.
    pub(super) fn bare_witness<const N: usize>(
        &self,
        at: [(&str, String); N],
        claimed: String,
        found: String,
    ) -> Witness {
        let mut given = vec![
            ("k".to_owned(), self.k().to_string()),
            ("U".to_owned(), self.knots().to_string()),
            ("α".to_owned(), self.basis.index().to_string()),
        ];
        given.extend(at.iter().map(|(name, value)| ((*name).to_owned(), value.clone())));
        Witness { given, claimed, found, reproduce: None }
    }

    /// The claim is false in this case, at the given place.
    pub(super) fn refuted<const N: usize>(
        &self,
        at: [(&str, String); N],
        claimed: String,
        found: String,
    ) -> Stop {
        Stop::Refuted(Box::new(self.witness(at, claimed, found)))
    }

    /// The same, with the command that shows the limits from the left at x.
    pub(super) fn refuted_on_the_left(
        &self,
        i: usize,
        x: &BigRational,
        claimed: String,
        found: String,
    ) -> Stop {
        let at = [("i", i.to_string()), ("x", x.to_string())];
        let reproduce = Some(self.command(&x.to_string(), " --side left"));
        Stop::Refuted(Box::new(Witness { reproduce, ..self.bare_witness(at, claimed, found) }))
    }

    /// The claim is false in this case, by more than the values at one place.
    pub(super) fn refuted_at_large<const N: usize>(
        &self,
        at: [(&str, String); N],
        claimed: String,
        found: String,
    ) -> Stop {
        Stop::Refuted(Box::new(self.bare_witness(at, claimed, found)))
    }

    /// Turns "false on all of this span but for single points", as the pieces say, into a witness at one point,
    /// which `test` computes by the definition: first at the knot t_j, then at simple numbers between the knots.
    pub(super) fn locate(&self, span: Span, test: impl Fn(&BigRational) -> Option<Witness>) -> Stop {
        self.locate_at(span, None, test)
    }

    /// The same for what is false on a part of the span only, of which one point u is known.
    pub(super) fn locate_at(
        &self,
        span: Span,
        known: Option<BigRational>,
        test: impl Fn(&BigRational) -> Option<Witness>,
    ) -> Stop {
        /// A rational function has few zeros: more places than that are never needed.
        const PLACES: usize = 100;
        let (start, end) = match self.knots().ends(span) {
            Ok(ends) => ends,
            Err(error) => return Stop::Fault(error.to_string()),
        };
        let simple = std::iter::once(start.clone()).chain(rationals_between(start, end)).take(PLACES);
        let known = known.and_then(|u| coordinate_between(start, end).evaluate(&u));
        match simple.chain(known).find_map(|x| test(&x)) {
            Some(witness) => Stop::Refuted(Box::new(witness)),
            None => Stop::Fault(format!(
                "the pieces on [{start}, {end}) of k = {}, U = {}, α = {} fail a claim that holds at {PLACES} points",
                self.k(),
                self.knots(),
                self.basis.index()
            )),
        }
    }
}

/// G_0^k(x), …, G_n^k(x) by the definition, as limits from the side.
pub(super) fn definition_values(basis: &Basis, x: &BigRational, side: Side) -> Vec<BigRational> {
    let table = basis.knots().span_at(x, side).and_then(|span| by_definition(basis, span, x).ok());
    let top = table.and_then(|mut table| table.pop());
    top.unwrap_or_else(|| vec![integer(0); basis.n() + 1])
}

/// An interval [a, b] and an index, to judge statements about the weight on.
#[derive(Debug, Clone)]
pub struct WeightCase {
    /// a.
    pub a: BigRational,
    /// b.
    pub b: BigRational,
    /// α.
    pub index: Index,
    origin: Origin,
}

impl WeightCase {
    /// A case of the given origin.
    #[must_use]
    pub fn new(a: BigRational, b: BigRational, index: Index, origin: Origin) -> Self {
        Self { a, b, index, origin }
    }
}

impl Case for WeightCase {
    type Hypothesis = WeightHypothesis;
    fn origin(&self) -> Origin {
        self.origin
    }
    fn meets(&self, hypothesis: &WeightHypothesis) -> bool {
        match hypothesis {
            WeightHypothesis::FiniteIndex => !self.index.is_infinite(),
            WeightHypothesis::Proper => self.a < self.b,
        }
    }
    fn degree(&self) -> Option<usize> {
        None
    }
}
