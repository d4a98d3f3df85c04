//! The paper's figures by number, and ours beside them, as SVG and PNG.
//!
//! Curves are sampled in `f64` until an eye cannot tell them from what they stand for; knots, one-sided values at
//! jumps, maxima, hulls and axes come from exact numbers. No verdict rests on a picture. The same program draws
//! the same bytes every time.

mod basis;
pub(super) mod canvas;
mod catalogue;
mod curve;
mod instance;
mod labels;
mod layout;
mod limit;
mod metrics;
mod notation;
mod pen;
mod plot;
mod png;
mod reflection;
mod rising;
pub(super) mod sample;
mod slopes;
mod weight;

pub use canvas::PictureError;
pub use catalogue::{Figure, all, figure};
pub use instance::{Picture, pictures};
pub use plot::{Plot, plot};
pub use png::png;

pub(super) use basis::graph;
pub(super) use layout::{grid, knot_lines};
