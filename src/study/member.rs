//! A member of any family in floats: its numbers rounded, and its weights as forms.

use std::collections::BTreeMap;

use thiserror::Error;

use crate::float::pair::Pair;
use crate::float::vectors::Split;
use crate::float::{FloatBasis, FloatError};
use crate::meaning::{MemberError, Weighting};
use crate::scalar::{BigRational, RationalAlgebra, Ring, exact_value};
use crate::spline::{Basis, FormTable, Forms, Index, Pairs, Span, triangle};

/// Why a member of a family is none in floats.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum FloatMemberError {
    /// The knots are none.
    #[error(transparent)]
    Knots(#[from] FloatError),
    /// A parameter beyond the range.
    #[error("a parameter is {0}: give one that is within the range of the floats")]
    Parameter(f64),
    /// Parameters that give no weights once they are floats.
    #[error(transparent)]
    Weights(#[from] MemberError),
}

/// A basis with the weights of a family that is not that of an index, knots and parameters in `f64`: what a program that
/// reads them has. There are no kernels for it, and no bound is proved; it is what such a program is measured by.
#[derive(Debug, Clone)]
pub struct FloatMember {
    /// For the knots: its α stands for nothing.
    basis: FloatBasis<f64>,
    weights: Weighting,
    exact: Basis<FormTable>,
    /// The coefficients to about 106 bits, each of which begins with the float nearest to it.
    forms: BTreeMap<(usize, usize, usize), Forms<Pair>>,
}

impl FloatMember {
    /// The floats nearest to the knots and to the parameters.
    ///
    /// # Errors
    /// [`FloatMemberError`], if they are no basis any more: a number rounds to infinity, all knots to one, or a parameter out of
    /// its bounds.
    pub fn nearest(basis: &Basis<Weighting>) -> Result<Self, FloatMemberError> {
        let knots = FloatBasis::nearest(&basis.with(Index::infinity()))?;
        let weights = basis.weights().map_numbers(|number| {
            let float = 0.0_f64.embed(number);
            exact_value(float).ok_or(FloatMemberError::Parameter(float))
        })?;
        let exact = knots.exact();
        let table = weights.table(exact.knots(), exact.degree())?;
        let forms = table.iter().map(|(place, forms)| (place, forms.map(Pair::nearest))).collect();
        Ok(Self { basis: knots, weights, exact: exact.with(table), forms })
    }

    /// The knots and the degree. α stands for nothing.
    #[must_use]
    pub fn knots(&self) -> &FloatBasis<f64> {
        &self.basis
    }

    /// The member, with the parameters that the floats are.
    #[must_use]
    pub fn weights(&self) -> &Weighting {
        &self.weights
    }

    /// The same basis in exact numbers.
    #[must_use]
    pub fn exact(&self) -> &Basis<FormTable> {
        &self.exact
    }

    /// rise, fall and over of the c-th weight of degree d on a span, c from 0, in plain floats; those of a weight that no
    /// function has are 0, 1 and 1.
    pub(super) fn terms(&self, span: Span, x: f64, d: usize, c: usize) -> [f64; 3] {
        let (a, b) = self.ends(span, d, c);
        let forms = self.forms(span, d, c);
        forms.map_or([0.0, 1.0, 1.0], |forms| forms.values(&(x - a), &(b - x), |c| c.hi))
    }

    /// The functions that live on the span at x in pairs of floats: nearly the exact ones.
    pub(super) fn unrounded(&self, span: Span, x: f64) -> Vec<Pair> {
        let shares = |i: usize, d: usize| {
            let c = i + d - span.index() - 1;
            let (a, b) = self.ends(span, d, c);
            let Some(forms) = self.forms(span, d, c) else { return (Pair::ZERO, Pair::ONE) };
            let [rise, fall, over] =
                forms.values(&Pair::difference(Split, x, a), &Pair::difference(Split, b, x), |c| *c);
            let share = |part: Pair| part.over(Split, over).normal(Split);
            (share(rise), share(fall))
        };
        let (degree, m) = (self.exact.degree(), self.exact.knots().m());
        triangle(&Pairs::new(&Pair::ONE, shares), span, degree, m).values().to_vec()
    }

    fn forms(&self, span: Span, d: usize, c: usize) -> Option<&Forms<Pair>> {
        let i = (span.index() + 1 + c).checked_sub(d)?;
        self.forms.get(&(span.index(), i, d))
    }

    fn ends(&self, span: Span, d: usize, c: usize) -> (f64, f64) {
        let (local, k) = (self.basis.local(span), self.basis.degree());
        (local[k - d + c], local[k + c])
    }
}

impl Pair {
    /// The pair nearest to a number, nearly.
    fn nearest(number: &BigRational) -> Self {
        let hi = 0.0_f64.embed(number);
        let rest = exact_value(hi).map_or(0.0, |exact| 0.0_f64.embed(&(number - exact)));
        Self { hi, lo: rest }
    }
}

impl Ring for Pair {
    fn zero(&self) -> Self {
        Self::ZERO
    }
    fn one(&self) -> Self {
        Self::ONE
    }
    fn plus(&self, rhs: &Self) -> Self {
        Self::plus(*self, Split, *rhs)
    }
    fn times(&self, rhs: &Self) -> Self {
        Self::times(*self, Split, *rhs).normal(Split)
    }
    fn negate(&self) -> Self {
        Self::negate(*self)
    }
}
