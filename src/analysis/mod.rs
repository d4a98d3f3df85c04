//! Floor 3: from exact pieces to decisions about every x.

mod algebraic;
mod angle;
mod collocation;
mod contenders;
mod crossing;
mod curve_part;
mod decision;
mod descartes;
mod extremum;
mod formal;
mod graph;
mod greatest;
mod homogeneous;
mod integer_polynomial;
mod joins;
mod linear;
mod local_knots;
mod minors;
mod monotonicity;
mod norm;
mod nurbs;

mod partition;
mod piece;
mod pieces;
mod profile;
mod quadrature;
mod rational_bezier;
mod refinement;
mod roots;
mod shape;
mod sign;
mod slopes;
mod span_quotients;
mod surd;

pub use algebraic::{Algebraic, Enclosed, decimals_around, settled, settled_apart};
pub use angle::Angle;
pub use collocation::{Collocation, InterpolationError, SiteError};
pub use contenders::Attained;
pub use crossing::{Crossing, Flank, Tie};
pub use curve_part::{CurvePart, CurvePartError};
pub use decision::{Decision, PositivePoint, SignPattern, always_nonnegative, always_positive, sign_pattern};
pub use descartes::{RootInterval, isolate_between};
pub use extremum::{Extremum, ExtremumKind, Jump, Location, turns_back};
pub use formal::{Factored, FormalBasis, FormalFunction, FormalPiece, Whose};
pub use graph::{Graph, GraphRange, RangeEnd, Solution, SolutionKind};
pub use greatest::{Greatest, compare};
pub use joins::{Branch, Join, joins};
pub use linear::{
    coefficient_rows, combinations, common_numerators, determinant, determinant_by_elimination, in_span,
    over_common_denominator, rank, relation, spans,
};
pub use local_knots::{LocalKnots, LocalKnotsError, SpanQuotient, is_continuous};
pub use minors::{NegativeMinor, negative_minor};
pub use monotonicity::{Monotonicity, Route, SpanMonotonicity};
pub use nurbs::{Nurbs, NurbsError, NurbsRequest, SpanParameter};
pub use partition::{FreeKnotError, Partition, PartitionEnd, PartitionEvent, RatioCell};
pub use piece::{Piece, constant};
pub use pieces::{
    Pieces, SpanPieces, coordinate_between, coordinate_of, function_quotients, positive_coordinate,
};
pub use quadrature::{integrals, length};
pub use rational_bezier::{RationalBezier, RationalBezierError};
pub use refinement::{RefinementError, refined};
pub use roots::{IsolatedRoot, count_positive_roots, count_roots_between, positive_roots};
pub use shape::Shape;
pub use sign::Sign;
pub use slopes::{KnotSlopes, knot_slopes};
pub use span_quotients::{OneDenominator, span_quotients, symbolic_quotients};
pub use surd::Surd;
