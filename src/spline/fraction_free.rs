//! The recursion without a division: from numerators to numerators.

use crate::scalar::ScaleBy;

use super::factors::Factors;
use super::weight::Split;

/// The weights of D3.3 on a span times the factors by which denominators grow: the [triangle](super::triangle())
/// over them gives the numerators of the G_i^k over their [denominators](Factors::denominator).
///
/// From G_i^{d−1} to G_i^d the factors L_{a,b} with b = i + d + 1 are new, and from G_i^{d−1} to G_{i−1}^d those with
/// a = i − 1; rise and fall are the numerators of w_i^d and 1 − w_i^d. So there are sums and products only, of what is
/// positive inside the span: no gcd, no cancellation, and no number is larger than the denominator of its function.
///
/// ```
/// use knotproof::spline::{Factors, FractionFree, KnotVector, triangle};
/// use knotproof::scalar::integer;
/// use num_bigint::BigInt;
///
/// // The hat functions of (0, 1, 3, 6) on [1, 3), r = 1/2, in u: L = 1·(0 + 2u) + 2·(2 + 0u).
/// let knots = KnotVector::new([0, 1, 3, 6].map(integer).to_vec())?;
/// let span = knots.spans().nth(1).unwrap();
/// let gaps = [1, 2, 3].map(BigInt::from);
/// let ratio = [(BigInt::from(1), BigInt::from(2))];
/// let factors = Factors::in_positive_coordinate(&gaps, span.index(), 1, &ratio).unwrap();
/// assert_eq!(factors.denominator(0).collect::<Vec<_>>(), [&(BigInt::from(4), BigInt::from(2))]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct FractionFree<'a, F, S> {
    factors: &'a Factors<F>,
    one: &'a S,
}

impl<'a, F: Clone, S: ScaleBy<F>> FractionFree<'a, F, S> {
    /// The weights with these factors, in the ring that `one` is the 1 of.
    #[must_use]
    pub fn new(factors: &'a Factors<F>, one: &'a S) -> Self {
        Self { factors, one }
    }
}

impl<F: Clone, S: ScaleBy<F>> Split for FractionFree<'_, F, S> {
    type Scalar = S;

    fn one(&self) -> S {
        self.one.clone()
    }

    #[inline]
    fn set_one(&self, value: &mut S) {
        value.clone_from(self.one);
    }

    #[inline]
    fn split(&self, i: usize, d: usize, value: &mut S, own: &mut S) {
        self.own(i, d, value, own);
        self.rest(i, d, value);
    }

    #[inline]
    fn own(&self, i: usize, d: usize, value: &S, own: &mut S) {
        let j = self.factors.span().index();
        own.clone_from(value);
        own.scale_by(self.factors.for_own(j - i, i + d - j - 1));
    }

    #[inline]
    fn rest(&self, i: usize, d: usize, value: &mut S) {
        let j = self.factors.span().index();
        value.scale_by(self.factors.for_rest(j - i, i + d - j - 1));
    }
}
