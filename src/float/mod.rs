//! Floor 6: the triangle in floating point, and how far that is from the exact values.
//!
//! [`FloatBasis`] computes values that are the exact ones, rounded. What is found here says how well a program in
//! floating point can do. It is never part of a verdict.

mod accurate;
mod basis;
mod batch;
mod curve;
mod derivatives;
mod error;
mod fast;
mod lanes;
mod machine;
mod member;
mod pair;
mod point;
mod power;
mod real;
mod scaled;
mod study;
mod vectors;

pub use basis::FloatBasis;
pub use batch::Precision;
pub use curve::FloatCurve;
pub use error::{FloatError, HIGHEST_DEGREE};
pub use fast::FAST_DEGREE;
pub use member::FloatMember;
pub use real::Real;
pub use study::{
    Effort, Errors, Extreme, Figures, Method, MethodRecord, Population, Probe, ProbeRecord, RangeRecord,
    Ulps, WorstRecord, hexadecimal, study,
};
