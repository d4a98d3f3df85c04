//! Floor 6: the triangle in floating point.
//!
//! [`FloatBasis`] computes values that are the exact ones, rounded; [`FloatCurve`] computes curves. None of that is ever part of
//! a verdict.

mod accurate;
mod basis;
mod batch;
mod curve;
mod curve_derivatives;
mod derivatives;
mod error;
mod exact_curve;
mod fast;
mod hexadecimal;
mod lanes;
mod machine;
pub(crate) mod pair;
pub(crate) mod point;
pub(crate) mod power;
mod real;
mod scaled;
pub(crate) mod vectors;

pub use basis::FloatBasis;
pub use batch::Precision;
pub use curve::FloatCurve;
pub use error::{FloatError, HIGHEST_DEGREE};
pub use fast::FAST_DEGREE;
pub use hexadecimal::hexadecimal;
pub use real::Real;
