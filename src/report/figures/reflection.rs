//! Reflections of the plane.

use crate::scalar::{BigRational, RationalAlgebra, integer};
use crate::spline::Point;

/// The reflection of the plane at the perpendicular bisector of two different points.
pub(crate) struct Reflection {
    middle: Point,
    normal: Point,
}

impl Reflection {
    /// At the bisector of the two; `None` if they are the same point.
    pub(crate) fn between(from: &Point, to: &Point) -> Option<Self> {
        let normal: Point = to.iter().zip(from).map(|(to, from)| to - from).collect();
        let middle = to.iter().zip(from).map(|(to, from)| (to + from) / integer(2)).collect();
        (from != to).then_some(Self { middle, normal })
    }

    /// The axis: a point of it, and a vector across.
    pub(crate) fn axis(&self) -> (&Point, &Point) {
        (&self.middle, &self.normal)
    }

    /// P − 2((P − M)·v)/(v·v) v, over any scalar.
    pub(crate) fn apply<S: RationalAlgebra>(&self, point: &[S]) -> Vec<S> {
        let square: BigRational = self.normal.iter().map(|v| v * v).sum();
        let terms = point
            .iter()
            .zip(&self.middle)
            .zip(&self.normal)
            .map(|((p, m), v)| p.minus(&p.embed(m)).times(&p.embed(&(v * integer(2) / &square))));
        let Some(factor) = terms.reduce(|sum, term| sum.plus(&term)) else { return Vec::new() };
        point.iter().zip(&self.normal).map(|(p, v)| p.minus(&factor.times(&p.embed(v)))).collect()
    }
}
