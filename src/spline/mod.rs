//! Floor 2: indices, knot vectors, the recursion and curves, in the order of the paper's sections 2 to 4.

mod basis;
mod bernstein;
mod curve;
mod definition;
mod index;
mod knots;
mod triangle;
mod weight;

pub use basis::{Basis, BasisError};
pub use bernstein::{bernstein, binomial};
pub use curve::{Curve, CurveError, Point};
pub use definition::by_definition;
pub use index::{Index, IndexError};
pub use knots::{KnotError, KnotVector, Side, Span};
pub use triangle::{Active, de_boor, raise, triangle};
pub use weight::{FormalWeights, PointWeights, Weights, weight};
