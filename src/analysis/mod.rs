//! Floor 3: from exact pieces to decisions about every x.

mod algebraic;
mod contenders;
mod crossing;
mod decision;
mod extremum;
mod formal;
mod greatest;
mod integer_polynomial;
mod linear;
mod local_knots;
mod minors;
mod monotonicity;
mod partition;
mod piece;
mod pieces;
mod profile;
mod rational_bezier;
mod roots;
mod shape;
mod sign;
mod slopes;
mod span_quotients;
mod supremum;

pub use algebraic::{Algebraic, Enclosed, decimals_around, settled, settled_apart};
pub use contenders::Attained;
pub use crossing::{Crossing, Flank, Tie};
pub use decision::{
    Decision, PositivePoint, SignPattern, Zeros, always_nonnegative, always_positive, common_positive_roots,
    sign_pattern,
};
pub use extremum::{Extremum, ExtremumKind, Jump, Location};
pub use formal::{Factored, FormalBasis, FormalFunction, FormalPiece};
pub use greatest::{Greatest, compare};
pub use linear::{coefficient_rows, common_numerators, determinant, in_span, is_combination, rank};
pub(crate) use local_knots::is_continuous;
pub use local_knots::{LocalKnots, LocalKnotsError, SpanQuotient};
pub use minors::{NegativeMinor, negative_minor};
pub use monotonicity::{Monotonicity, Route, SpanMonotonicity};
pub use partition::{FreeKnotError, Partition, PartitionEnd, PartitionEvent, RatioCell};
pub use piece::{Piece, constant};
pub use pieces::{Pieces, SpanPieces, coordinate_between, coordinate_of, positive_coordinate};
pub use rational_bezier::RationalBezier;
pub use roots::{IsolatedRoot, count_positive_roots, positive_roots};
pub use shape::Shape;
pub use sign::Sign;
pub use slopes::{KnotSlopes, knot_slopes};
pub use span_quotients::{OneDenominator, span_quotients, symbolic_quotients};
pub use supremum::{ClosedCoordinate, Enclosure, SupremumError, supremum};
