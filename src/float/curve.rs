//! Curves in floats.

use super::basis::{FloatBasis, length};
use super::batch::Precision;
use super::error::{FloatError, HIGHEST_DEGREE};
use super::pair::Pair;
use super::point::de_boor;
use super::power::power;
use super::real::Real;
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
    /// The coordinates of d_0, then those of d_1, …
    pub(super) points: Vec<F>,
    /// A power of two that brings the points into the range where products are safe.
    pub(super) scale: f64,
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
        let scale = if largest.widen() > power(900) { power(-128) } else { 1.0 };
        Ok(Self { basis, dimension, points, scale })
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
        &self.points
    }

    /// The point of the curve at x, as a limit from the given side, by de Boor's algorithm. `None`, and zeros, outside
    /// [t_0, t_m].
    ///
    /// Each coordinate has an error of at most u|v| + (k + 1)·2⁻⁹⁹·Σ|d_i|G_i, barring underflow: it is rounded once, unless
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
        // A few coordinates at a time: their place is fixed, so nothing is allocated.
        const AT_ONCE: usize = 4;
        let degree = self.basis.degree();
        for (group, place) in point.chunks_mut(AT_ONCE).enumerate() {
            let mut columns = [[Pair::ZERO; HIGHEST_DEGREE + 1]; AT_ONCE];
            for c in self.basis.existing(span) {
                let i = span.index() + c - degree;
                let coordinates = &self.points[i * self.dimension + group * AT_ONCE..];
                for (column, coordinate) in columns.iter_mut().zip(coordinates).take(place.len()) {
                    column[c] = Pair::of(coordinate.widen() * self.scale);
                }
            }
            de_boor(&self.basis, span, x, &mut columns[..place.len()]);
            for (value, column) in place.iter_mut().zip(&columns) {
                *value = F::nearest(column[0].hi / self.scale);
            }
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
        if precision == Precision::Accurate {
            for (x, point) in xs.iter().zip(points.chunks_exact_mut(self.dimension)) {
                self.point(*x, Side::Right, point)?;
            }
            return Ok(());
        }
        const BLOCK: usize = 256;
        let (degree, stride) = (self.basis.degree(), self.basis.degree() + 1);
        let (mut spans, mut values) = ([None; BLOCK], [F::zero(); BLOCK * (HIGHEST_DEGREE + 1)]);
        for (xs, points) in xs.chunks(BLOCK).zip(points.chunks_mut(BLOCK * self.dimension)) {
            let (spans, values) = (&mut spans[..xs.len()], &mut values[..xs.len() * stride]);
            self.basis.values_at(xs, precision, spans, values)?;
            let columns = spans.iter().zip(values.chunks_exact(stride));
            for ((span, values), point) in columns.zip(points.chunks_exact_mut(self.dimension)) {
                let Some(span) = span else {
                    point.fill(F::zero());
                    continue;
                };
                let existing = self.basis.existing(*span);
                let first = (span.index() + existing.start - degree) * self.dimension;
                let values = &values[existing];
                let controls = &self.points[first..first + values.len() * self.dimension];
                for (coordinate, place) in point.iter_mut().enumerate() {
                    let mut at = coordinate;
                    *place = values.iter().fold(F::zero(), |sum, value| {
                        let d = controls[at];
                        at += self.dimension;
                        sum + *value * d
                    });
                }
            }
        }
        Ok(())
    }
}
