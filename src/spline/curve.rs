//! Curves (D3.4).

use num_rational::BigRational;
use thiserror::Error;

use crate::scalar::{Jet, RationalAlgebra, integer};

use super::basis::Basis;
use super::index::Index;
use super::kind::HasWeights;
use super::knots::{KnotVector, Side, Span};
use super::sampler::Sampler;
use super::triangle::Active;

/// A point of R^d, 1 ≤ d ≤ 3.
pub type Point = Vec<BigRational>;

/// The curve G_α(x) = Σ d_i G_i^k(x), x in [t_0, t_m], with control points d_0..d_n in R^d, 1 ≤ d ≤ 3 (D3.4).
///
/// ```
/// use knotproof::scalar::{integer, rational};
/// use knotproof::spline::{Basis, Curve, Index, KnotVector, Side};
///
/// let knots = KnotVector::bernstein(2, &integer(0), &integer(1))?;
/// let basis = Basis::new(knots, 2, "-1".parse::<Index>()?)?;
/// let points = [[0, 0], [1, 2], [2, 0]].map(|point| point.map(integer).to_vec());
/// let curve = Curve::new(basis, points.to_vec())?;
/// let point = curve.point(&rational(1, 2), Side::Right);
/// assert_eq!(point, [rational(2, 3), rational(8, 9)]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Curve<W = Index> {
    basis: Basis<W>,
    points: Vec<Point>,
}

/// Why a list of points is no control polygon for a basis.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum CurveError {
    /// Not n + 1 points.
    #[error(
        "degree {degree} on {knots} knots takes {needed} control points (n + 1, D3.4), and here are {count}"
    )]
    Count {
        /// k.
        degree: usize,
        /// m + 1.
        knots: usize,
        /// n + 1.
        needed: usize,
        /// The number of points given.
        count: usize,
    },
    /// A point outside of R¹, R², R³.
    #[error(
        "control point {position} has {dimension} coordinates; a curve lives in dimension 1, 2 or 3 (D3.4)"
    )]
    Dimension {
        /// The index of the point, from 0.
        position: usize,
        /// Its number of coordinates.
        dimension: usize,
    },
    /// A function that the basis does not have.
    #[error("there is no control point for the function {index}: the basis has the functions 0 to {n}")]
    Function {
        /// The index of the function.
        index: usize,
        /// n.
        n: usize,
    },
    /// Not as many points as there are intervals in a period.
    #[error(
        "a closed curve takes a control point for each of the {needed} intervals of a period, and here are {count}"
    )]
    Period {
        /// m of the knots of a period.
        needed: usize,
        /// The number of points given.
        count: usize,
    },
    /// Points of different dimensions.
    #[error(
        "control point {position} has {dimension} coordinates and point 0 has {expected}: all need the same"
    )]
    Mixed {
        /// The index of the point, from 0.
        position: usize,
        /// Its number of coordinates.
        dimension: usize,
        /// The number of coordinates of point 0.
        expected: usize,
    },
}

impl<W> Curve<W> {
    /// Checks the number of the control points and their dimension.
    ///
    /// # Errors
    /// [`CurveError`], with the position of the first offence.
    pub fn new(basis: Basis<W>, points: Vec<Point>) -> Result<Self, CurveError> {
        let needed = basis.n() + 1;
        if points.len() != needed {
            let (degree, knots) = (basis.degree(), basis.knots().m() + 1);
            return Err(CurveError::Count { degree, knots, needed, count: points.len() });
        }
        let expected = points[0].len();
        for (position, point) in points.iter().enumerate() {
            let dimension = point.len();
            if !(1..=3).contains(&dimension) {
                return Err(CurveError::Dimension { position, dimension });
            }
            if dimension != expected {
                return Err(CurveError::Mixed { position, dimension, expected });
            }
        }
        Ok(Self { basis, points })
    }

    /// The closed curve of degree k with the knots of one period, (t_0, …, t_m), and m control points: on the
    /// [`periodic`](KnotVector::periodic) knots, with d_{i+m} = d_i. It is closed on the period, where the basis functions add
    /// up to 1, and its ends meet as smoothly as pieces do at inner knots.
    ///
    /// ```
    /// use knotproof::scalar::integer;
    /// use knotproof::spline::{Curve, Index, KnotVector, Side};
    ///
    /// let period = KnotVector::new([0, 1, 2, 3, 4].map(integer).to_vec())?;
    /// let points = [[0, 0], [6, 0], [6, 6], [0, 6]].map(|point| point.map(integer).to_vec());
    /// let circle_like = Curve::closed(&period, 2, Index::infinity(), &points)?;
    /// let point = |x: i64| circle_like.point(&integer(x), Side::Right);
    /// assert_eq!(point(0), [integer(3), integer(0)]);
    /// assert_eq!(point(4), point(0));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`CurveError::Period`] for another number of points, and those of [`new`](Self::new) on their dimensions.
    pub fn closed(
        period: &KnotVector,
        degree: usize,
        weights: W,
        points: &[Point],
    ) -> Result<Self, CurveError> {
        let (needed, count) = (period.m(), points.len());
        if count != needed {
            return Err(CurveError::Period { needed, count });
        }
        let basis = match Basis::over(period.periodic(degree), degree, weights) {
            Ok(basis) => basis,
            Err(error) => unreachable!("at least 2k + 2 knots: {error}"),
        };
        Self::new(basis, points.iter().cycle().take(needed + degree).cloned().collect())
    }

    /// The same knots, degree and control points with other weights.
    #[must_use]
    pub fn with<V>(&self, weights: V) -> Curve<V> {
        Curve { basis: self.basis.with(weights), points: self.points.clone() }
    }

    /// The basis.
    #[must_use]
    pub fn basis(&self) -> &Basis<W> {
        &self.basis
    }

    /// d_0, …, d_n.
    #[must_use]
    pub fn points(&self) -> &[Point] {
        &self.points
    }

    /// d_{j−k}, …, d_j, for k ≤ j ≤ n.
    pub(super) fn points_on(&self, span: Span) -> Option<&[Point]> {
        let j = span.index();
        self.points.get(j.checked_sub(self.basis.degree())?..=j)
    }

    /// d.
    #[must_use]
    pub fn dimension(&self) -> usize {
        self.points[0].len()
    }

    /// Σ d_i g_i for functions g_i over any scalar, such as the pieces of the basis on a span; no coordinates for no
    /// function.
    ///
    /// # Errors
    /// [`CurveError::Function`] for a g_i without a d_i.
    pub fn combine<S: RationalAlgebra>(&self, functions: &Active<S>) -> Result<Vec<S>, CurveError> {
        let count = self.points.len();
        if functions.first().saturating_add(functions.values().len()) > count {
            return Err(CurveError::Function { index: functions.first().max(count), n: self.basis.n() });
        }
        Ok(self.combine_unchecked(functions))
    }

    /// [`combine`](Self::combine) for functions of the basis: every one has its control point.
    pub(crate) fn combine_unchecked<S: RationalAlgebra>(&self, functions: &Active<S>) -> Vec<S> {
        let coordinate = |c: usize| {
            let terms = functions.iter().map(|(i, g)| g.times(&g.embed(&self.points[i][c])));
            terms.reduce(|sum, term| sum.plus(&term))
        };
        (0..self.dimension()).filter_map(coordinate).collect()
    }
}

impl<W: HasWeights> Curve<W> {
    /// The point of the curve at x, as a limit from the given side: Σ d_i G_i^k(x). For many points of one curve, a
    /// [`CurveEvaluator`](super::CurveEvaluator) prepares what it can once only.
    #[must_use]
    pub fn point(&self, x: &BigRational, side: Side) -> Point {
        match Sampler::new(&self.basis).values(x, side) {
            Some(active) => self.combine_unchecked(&active),
            None => vec![integer(0); self.dimension()],
        }
    }

    /// The coordinates of the curve at x as jets of the given order.
    #[must_use]
    pub fn jets(&self, x: &BigRational, side: Side, order: usize) -> Vec<Jet<BigRational>> {
        match Sampler::new(&self.basis).jets(x, side, order) {
            Some(active) => self.combine_unchecked(&active),
            None => vec![Jet::constant(integer(0), order); self.dimension()],
        }
    }

    /// All points d_i^r of de Boor's algorithm at x (T4.1), level by level: the last level is the point of
    /// the curve. `None` outside of [t_k, t_{n+1}], where the algorithm has too few control points.
    #[must_use]
    pub fn de_boor(&self, x: &BigRational, side: Side) -> Option<Vec<Active<Point>>> {
        let span = self.basis.knots().span_at(x, side)?;
        self.basis.de_boor(span, x, self.points_on(span)?)
    }
}
