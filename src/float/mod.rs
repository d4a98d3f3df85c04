//! Floor 5: the triangle in `f64` against the same triangle in exact numbers.
//!
//! What is found here says how well a program in floating point would do. It is never part of a verdict.

mod discrepancy;

pub use discrepancy::{Discrepancy, INTERIOR_POINTS, Worst, discrepancy};
