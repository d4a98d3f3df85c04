//! A function on one span.

use num_rational::BigRational;

use crate::scalar::{ExactField, Jet, RationalFunction};
use crate::spline::Side;

/// A function on a span, in the span's positive coordinate u.
pub type Piece = RationalFunction<BigRational>;

/// The jets of all functions of a basis at a point from a side, up to an order.
pub(super) type Jets<'a> = &'a dyn Fn(&BigRational, Side, usize) -> Vec<Jet<BigRational>>;

/// The constant function.
#[must_use]
pub fn constant<S: ExactField>(value: S) -> RationalFunction<S> {
    RationalFunction::constant(value)
}
