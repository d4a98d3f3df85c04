//! The two kinds of weights that a basis can have, and what is computed with either.

use crate::scalar::RationalAlgebra;

use super::basis::Basis;
use super::forms::FormTable;
use super::index::Index;
use super::knots::{Span, SpanError};
use super::triangle::{Active, de_boor, triangle};
use super::weight::PointWeights;

/// What the weights of a basis are made from.
pub trait HasWeights {
    /// Which of the two it is.
    fn kind(&self) -> WeightKind<'_>;
}

/// An index, for which there are fast kernels, or the forms of a member of any family.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum WeightKind<'a> {
    /// α.
    Index(&'a Index),
    /// A form for each weight.
    Forms(&'a FormTable),
}

/// The same, where only the run of the program tells which of the two it is.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum AnyWeights {
    /// α.
    Index(Index),
    /// A form for each weight.
    Forms(FormTable),
}

impl HasWeights for Index {
    fn kind(&self) -> WeightKind<'_> {
        WeightKind::Index(self)
    }
}

impl HasWeights for FormTable {
    fn kind(&self) -> WeightKind<'_> {
        WeightKind::Forms(self)
    }
}

impl HasWeights for AnyWeights {
    fn kind(&self) -> WeightKind<'_> {
        match self {
            Self::Index(index) => WeightKind::Index(index),
            Self::Forms(table) => WeightKind::Forms(table),
        }
    }
}

impl<W: HasWeights> Basis<W> {
    /// The functions that live on the span, at any scalar x of the closed span: a point, a jet, a variable.
    ///
    /// A variable, such as a [`RationalFunction`](crate::scalar::RationalFunction), stands for the points of the span:
    /// the result is the functions as formulas.
    ///
    /// Over exact numbers this is the reference: every operation is reduced at once, and slow. For linear weights,
    /// those of an index among them, [`Evaluator`](super::Evaluator) gives the same values and jets.
    ///
    /// # Errors
    /// [`SpanError`] for a span of another knot vector, and for a point outside of the closed span, NaN included.
    pub fn active<S: RationalAlgebra>(&self, span: Span, x: &S) -> Result<Active<S>, SpanError> {
        let (knots, k) = (self.knots(), self.degree());
        knots.ends_around(span, x)?;
        Ok(match self.weights().kind() {
            WeightKind::Index(index) => {
                triangle(&PointWeights::new(knots, x.embed(index.ratio()), x.clone()), span, k, knots.m())
            }
            WeightKind::Forms(table) => triangle(&table.at(knots, span, x), span, k, knots.m()),
        })
    }

    /// K: as quotients in x, no function on the span has a higher degree, neither above nor below: the sum of the degrees of
    /// the weights over it, N for forms and k(k + 1)/2 altogether for an index.
    #[must_use]
    pub fn quotient_degree(&self, span: Span) -> usize {
        match self.weights().kind() {
            WeightKind::Index(_) => self.degree() * (self.degree() + 1) / 2,
            WeightKind::Forms(table) => {
                let here = table.iter().filter(|((j, ..), _)| *j == span.index());
                here.map(|(_, forms)| forms.degree()).sum()
            }
        }
    }

    /// De Boor's algorithm at x of the closed span, for the control points d_{j−k}, …, d_j: see [`de_boor`].
    pub(super) fn de_boor<S: RationalAlgebra>(
        &self,
        span: Span,
        x: &S,
        points: &[Vec<S>],
    ) -> Option<Vec<Active<Vec<S>>>> {
        match self.weights().kind() {
            WeightKind::Index(index) => {
                de_boor(&PointWeights::new(self.knots(), x.embed(index.ratio()), x.clone()), span, points)
            }
            WeightKind::Forms(table) => de_boor(&table.at(self.knots(), span, x), span, points),
        }
    }
}
