//! Curves in floats.

use super::accurate::combination;
use super::basis::{FloatBasis, length};
use super::batch::{Coordinates, Precision};
use super::error::FloatError;
use super::pair::Pair;
use super::point::{Column, unrounded};
use super::power::power;
use super::real::Real;
use super::vectors::Split;
use crate::spline::{Side, Span};

/// A curve G_α = Σ d_i G_i^k in floats (D3.4), in any number of coordinates.
///
/// ```
/// use knotproof::float::{FloatBasis, FloatCurve};
/// use knotproof::spline::Side;
///
/// let basis = FloatBasis::new(vec![0.0, 0.0, 0.0, 1.0, 1.0, 1.0], 2, -1.0)?;
/// let curve = FloatCurve::new(basis, 2, vec![0.0, 0.0, 9.0, 0.0, 9.0, 9.0])?;
/// let mut point = [0.0; 2];
/// curve.point(0.5, Side::Right, &mut point)?;
/// assert_eq!(point, [5.0, 1.0]);
/// # Ok::<(), knotproof::float::FloatError>(())
/// ```
#[derive(Debug, Clone)]
pub struct FloatCurve<F> {
    pub(super) basis: FloatBasis<F>,
    pub(super) dimension: usize,
    /// The coordinates of d_{−k}, …, d_{n+k}, one point after the other. Those that there are not are 0: so every span has k + 1 of
    /// them.
    padded: Vec<F>,
    /// The same divided by the unit, unless that is 1: a tiny coordinate can underflow in it.
    divided: Option<Vec<F>>,
    /// A power of two that brings the points into the range where products are safe.
    pub(super) unit: F,
}

impl<F: Real> FloatCurve<F> {
    /// The curve with n + 1 control points of so many coordinates each, one point after the other.
    ///
    /// # Errors
    /// [`FloatError::Length`] for another number of coordinates, [`FloatError::Coordinate`] for one that is not finite.
    pub fn new(basis: FloatBasis<F>, dimension: usize, points: Vec<F>) -> Result<Self, FloatError> {
        length("control points", (basis.n() + 1).saturating_mul(dimension), points.len())?;
        if let Some(at) = points.iter().position(|coordinate| !coordinate.is_finite()) {
            let (position, coordinate) = (at / dimension, at % dimension);
            return Err(FloatError::Coordinate { position, coordinate, value: points[at].widen() });
        }
        let largest = points.iter().fold(F::zero(), |largest, c| largest.max(c.abs()));
        let unit = F::nearest(if largest.widen() > power(900) { power(128) } else { 1.0 });
        let missing = std::iter::repeat_n(F::zero(), basis.degree() * dimension);
        let padded: Vec<F> = missing.clone().chain(points).chain(missing).collect();
        let divided = (unit > F::one()).then(|| padded.iter().map(|d| *d / unit).collect());
        Ok(Self { basis, dimension, padded, divided, unit })
    }

    /// The basis.
    #[must_use]
    pub fn basis(&self) -> &FloatBasis<F> {
        &self.basis
    }

    /// The number of coordinates of a point.
    #[must_use]
    pub fn dimension(&self) -> usize {
        self.dimension
    }

    /// The coordinates of d_0, then those of d_1, …
    #[must_use]
    pub fn points(&self) -> &[F] {
        let missing = self.basis.degree() * self.dimension;
        &self.padded[missing..self.padded.len() - missing]
    }

    /// The coordinates of d_{−k}, …, d_{n+k} divided by the unit, those that there are not being 0: d_{j−k} is at j.
    fn controls(&self) -> &[F] {
        self.divided.as_ref().unwrap_or(&self.padded)
    }

    /// A coordinate of d_{j−k+c}, divided by the unit, and 0 if there is no such point.
    pub(super) fn control(&self, span: Span, c: usize, coordinate: usize) -> f64 {
        self.controls()[(span.index() + c) * self.dimension + coordinate].widen()
    }

    /// A coordinate divided by the unit, before it is rounded, from the values on the span: a pair that is not normal. The control
    /// values are replaced by their images.
    pub(super) fn unrounded(
        &self,
        span: Span,
        values: &Column,
        coordinate: usize,
        image: impl Fn(f64) -> f64,
    ) -> Pair {
        let control = |c| image(self.control(span, c, coordinate));
        combination(Split, self.basis.degree(), values, control)
    }

    /// The point of the curve at x, as a limit from the given side. `None`, and zeros, outside [t_0, t_m].
    ///
    /// Each coordinate has an error of at most u|v| + (k + 1)·2⁻⁹⁸·Σ|d_i|G_i, barring underflow: it is rounded once, unless
    /// nearly all of the control points cancel.
    ///
    /// # Errors
    /// [`FloatError::Point`] if x is not finite, [`FloatError::Length`] unless there is a place for each coordinate.
    pub fn point(&self, x: F, side: Side, point: &mut [F]) -> Result<Option<Span>, FloatError> {
        length("point", self.dimension, point.len())?;
        let Some(span) = self.basis.span_at(x, side)? else {
            point.fill(F::zero());
            return Ok(None);
        };
        let values = unrounded(&self.basis, span, x);
        for (coordinate, place) in point.iter_mut().enumerate() {
            let sum = self.unrounded(span, &values, coordinate, |d| d);
            *place = F::nearest(sum.hi + sum.lo) * self.unit;
        }
        Ok(Some(span))
    }

    /// The points of the curve at many x in any order, limits from the right, one after the other; zeros outside of
    /// [t_0, t_m].
    ///
    /// With [`Precision::Accurate`] they are those of [`Self::point`]. With [`Precision::Fast`] the functions are
    /// computed as in [`FloatBasis::values_at`] and added up: then a coordinate has an error of at most
    /// (k² + 9k + 2)u·Σ|d_i|G_i.
    ///
    /// # Errors
    /// [`FloatError::Point`] if an x is not finite, [`FloatError::Length`] unless there is a place for each coordinate of
    /// each point.
    pub fn points_at(&self, xs: &[F], precision: Precision, points: &mut [F]) -> Result<(), FloatError> {
        length("points", xs.len() * self.dimension, points.len())?;
        if self.dimension == 0 {
            return Ok(());
        }
        let Some(frame) = &self.basis.frame else {
            for (x, point) in xs.iter().zip(points.chunks_exact_mut(self.dimension)) {
                self.point(*x, Side::Right, point)?;
            }
            return Ok(());
        };
        if let Some(x) = xs.iter().find(|x| !x.is_finite()) {
            return Err(FloatError::Point(x.widen()));
        }
        let Self { dimension, unit, .. } = *self;
        let into = Coordinates { dimension, controls: self.controls(), unit, points };
        self.basis.scattered(frame, xs, precision, into);
        Ok(())
    }
}
