//! A function on one span.

use num_rational::BigRational;

use crate::scalar::{ExactField, RationalFunction};

/// A function on a span, in the span's positive coordinate u.
pub type Piece = RationalFunction<BigRational>;

/// The constant function.
#[must_use]
pub fn constant<S: ExactField>(value: S) -> RationalFunction<S> {
    RationalFunction::constant(value)
}
