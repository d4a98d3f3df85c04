//! What can be wrong with floats that are to become a basis, a point or a curve.

use thiserror::Error;

/// The highest degree of a [`FloatBasis`](super::FloatBasis): what it computes with has a fixed place, so that nothing is allocated.
pub const HIGHEST_DEGREE: usize = 31;

/// Why nothing was computed. Floats are widened to `f64` here.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum FloatError {
    /// k is too high.
    #[error(
        "the degree {0} is too high: at most {HIGHEST_DEGREE}, since the functions in f64 compute in memory of a fixed size"
    )]
    Degree(usize),
    /// Too few knots for the degree.
    #[error("degree {degree} needs at least {needed} knots (m ≥ 2k and n ≥ 0, D3.2), and here are {count}")]
    Count {
        /// k.
        degree: usize,
        /// How many it needs.
        needed: usize,
        /// m + 1.
        count: usize,
    },
    /// A knot that is infinite or not a number.
    #[error("knot {position} is {value}: knots are finite (D3.1)")]
    Knot {
        /// i, from 0.
        position: usize,
        /// t_i.
        value: f64,
    },
    /// t_{i−1} > t_i.
    #[error("knots must not decrease (D3.1), but knot {position} is {value:e}, after {previous:e}")]
    Decreasing {
        /// i, from 0.
        position: usize,
        /// t_{i−1}.
        previous: f64,
        /// t_i.
        value: f64,
    },
    /// t_0 = t_m.
    #[error("all knots are equal to {0:e}: there is no interval between them (D3.2 asks for a < b)")]
    AllEqual(f64),
    /// α in [0, 1], or not a number.
    #[error("α is {0:e}: an index is negative, greater than 1, or infinite (D2.3)")]
    Index(f64),
    /// An x that is infinite or not a number.
    #[error("x is {0}: give a finite one")]
    Point(f64),
    /// An x outside the span that all points should lie in.
    #[error(
        "point {position}, x = {x:e}, is not in the span [{start:e}, {end:e}]: leave it out, or use `values_at`"
    )]
    Outside {
        /// Its place among the points, from 0.
        position: usize,
        /// The point.
        x: f64,
        /// t_j.
        start: f64,
        /// t_{j+1}.
        end: f64,
    },
    /// A span of another knot vector.
    #[error("[t_{0}, t_{0} + 1) is no span here: take one that this basis gave")]
    Span(usize),
    /// A slice that does not have the length that the result needs.
    #[error("the slice for the {what} has {given} entries, and {needed} are needed")]
    Length {
        /// What it is for.
        what: &'static str,
        /// What it must be.
        needed: usize,
        /// What it is.
        given: usize,
    },
    /// A coordinate that is infinite or not a number.
    #[error("coordinate {coordinate} of control point {position} is {value}: coordinates are finite")]
    Coordinate {
        /// i of d_i.
        position: usize,
        /// Which coordinate, from 0.
        coordinate: usize,
        /// Its value.
        value: f64,
    },
    /// An order that is too high.
    #[error("derivatives of order {0} are too many: at most {HIGHEST_DEGREE}")]
    Order(usize),
    /// A derivative beyond the range.
    #[error("a derivative of order {0} at this x is beyond the range of the floats: ask for a lower order")]
    Derivative(usize),
}
