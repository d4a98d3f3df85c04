//! Floor 2: indices, knot vectors, the recursion and curves, in the order of the paper's sections 2 to 4.

mod basis;
mod bernstein;
mod curve;
mod curve_evaluator;
mod definition;
mod evaluator;
mod factors;
mod forms;
mod fraction_free;
mod index;
mod kind;
mod knots;
mod linear_weights;
mod reducer;
mod sampler;
mod triangle;
mod weight;

pub use basis::{Basis, BasisError};
pub use bernstein::{bernstein, binomial};
pub use curve::{Curve, CurveError, Point};
pub use curve_evaluator::{CurveEvaluator, Tangent};
pub use definition::{by_definition, by_weights};
pub use evaluator::{Evaluator, Unreduced};
pub use factors::Factors;
pub use forms::{FormTable, Forms, Obligation, Pairs};
pub use fraction_free::FractionFree;
pub use index::{Index, IndexError};
pub use kind::{AnyWeights, HasWeights, WeightKind};
pub use knots::{KnotError, KnotVector, Side, Span, SpanError};
pub use sampler::Sampler;
pub use triangle::{Active, Triangle, de_boor, triangle};
pub use weight::{FormalWeights, PointWeights, Split, Weights, weight};
