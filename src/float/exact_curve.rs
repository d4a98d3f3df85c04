//! Curves in floats and exact ones: from one to the other, and how far a point is from the exact one.

use num_traits::Signed;

use super::basis::{FloatBasis, length};
use super::curve::FloatCurve;
use super::derivatives::small;
use super::error::FloatError;
use super::pair::Pair;
use super::point::{Column, unrounded};
use super::power::power;
use super::real::Real;
use crate::scalar::{BigRational, RationalAlgebra, exact_value};
use crate::spline::{Basis, Curve, CurveError, Side, Span};

impl<F: Real> FloatCurve<F> {
    /// The floats nearest to an exact curve.
    ///
    /// # Errors
    /// Those of [`FloatBasis::nearest`], and [`FloatError::Coordinate`] for a coordinate beyond the range.
    pub fn nearest(curve: &Curve) -> Result<Self, FloatError> {
        let points = curve.points().iter().flatten().map(rounded).collect();
        Self::new(FloatBasis::nearest(curve.basis())?, curve.dimension(), points)
    }

    /// The same curve in exact numbers.
    ///
    /// # Errors
    /// [`CurveError::Dimension`] unless it is one in 1 to 3 coordinates.
    pub fn exact(&self) -> Result<Curve, CurveError> {
        let point =
            |i: usize| self.points()[i * self.dimension..][..self.dimension].iter().map(exact).collect();
        Curve::new(self.basis.exact(), (0..=self.basis.n()).map(point).collect())
    }

    /// Bounds of the errors of [`Self::point`] at the same place, one for each coordinate:
    ///
    /// u|v̂| + (k + 1)·2⁻⁹⁸·Σ|d_i|G_i, and a little more for what is rounded here and for underflow.
    ///
    /// Zeros outside of [t_0, t_m], where the points are.
    ///
    /// # Errors
    /// Those of [`Self::point`].
    pub fn error_bound(&self, x: F, side: Side, bound: &mut [F]) -> Result<Option<Span>, FloatError> {
        let span = self.point(x, side, bound)?;
        let Some(at) = span else { return Ok(None) };
        let values = unrounded(&self.basis, at, x);
        for (coordinate, place) in bound.iter_mut().enumerate() {
            let unit = F::epsilon().widen() / 2.0;
            let far = self.terms(at, &values, coordinate);
            let sum = place.widen().abs() * unit + far;
            // Rounded up, whichever way the sum and the conversion have been.
            *place = F::nearest(sum * (1.0 + 4.0 * unit)) + F::LEAST;
        }
        Ok(span)
    }

    /// The point at x as a limit from the given side, each coordinate rounded correctly: the float nearest to the exact value,
    /// of two the even one. Where the pair of floats that [`Self::point`] rounds is too close to the middle of two, exact
    /// arithmetic decides. `None`, and zeros, outside [t_0, t_m].
    ///
    /// # Errors
    /// Those of [`Self::point`].
    pub fn nearest_point(&self, x: F, side: Side, point: &mut [F]) -> Result<Option<Span>, FloatError> {
        length("point", self.dimension, point.len())?;
        let Some(span) = self.basis.span_at(x, side)? else {
            point.fill(F::zero());
            return Ok(None);
        };
        let (values, mut basis) = (unrounded(&self.basis, span, x), None);
        for (coordinate, place) in point.iter_mut().enumerate() {
            let pair = self.unrounded(span, &values, coordinate, |d| d);
            *place = match settled(pair, self.terms(span, &values, coordinate)) {
                Some(value) if self.unit == F::one() => value,
                _ => {
                    let basis = basis.get_or_insert_with(|| self.basis.exact());
                    rounded(&self.exact_coordinate(basis, span, x, coordinate))
                }
            };
        }
        Ok(Some(span))
    }

    /// A coordinate by exact arithmetic.
    fn exact_coordinate(&self, basis: &Basis, span: Span, x: F, coordinate: usize) -> BigRational {
        let own = basis.knots().span(span.index());
        let active = own.and_then(|own| basis.active(own, &exact(&x)).ok());
        let term = |(i, g): (usize, &BigRational)| g * exact(&self.points()[i * self.dimension + coordinate]);
        active.iter().flat_map(|active| active.iter()).map(term).sum()
    }

    /// How far a coordinate is from the exact value at most before it is rounded: (k + 1)·2⁻⁹⁷·Σ|d_i|G_i, twice what is proved, which
    /// covers the rounding here; and what may underflow. 0 if all control points are 0.
    fn terms(&self, span: Span, values: &Column, coordinate: usize) -> f64 {
        let point = |c: usize| span.index() + c - self.basis.degree();
        let control = |c: usize| self.points()[point(c) * self.dimension + coordinate].abs();
        let largest = self.basis.existing(span).map(control).fold(F::zero(), F::max).widen();
        if largest == 0.0 {
            return 0.0;
        }
        let (sum, unit) = (self.unrounded(span, values, coordinate, f64::abs).hi, self.unit.widen());
        small(self.basis.degree() + 1) * power(-97) * sum * unit + power(-1020) * (unit + largest)
    }
}

/// The float nearest to all numbers that are at most `margin` from the pair, if that is one.
fn settled<F: Real>(pair: Pair, margin: f64) -> Option<F> {
    let ends = [pair.hi + (pair.lo - margin), pair.hi + (pair.lo + margin)];
    // A number between them rounds to an f64 between these; to f32 the two roundings are one unless that is next to a middle.
    let [lo, hi] = if is_wide::<F>() { ends } else { [ends[0].next_down(), ends[1].next_up()] };
    let (least, most) = (F::nearest(lo), F::nearest(hi));
    (margin == 0.0 || least == most).then_some(least)
}

/// Is it `f64`?
fn is_wide<F: Real>() -> bool {
    F::LEAST.widen().to_bits() == 1
}

fn exact<F: Real>(value: &F) -> BigRational {
    match exact_value(value.widen()) {
        Some(number) => number,
        None => unreachable!("all numbers of a curve are finite"),
    }
}

/// The float nearest to a number, of two the even one.
fn rounded<F: Real>(value: &BigRational) -> F {
    let wide = 0.0_f64.embed(value);
    let Some(found) = exact_value(wide).filter(|_| !is_wide::<F>()) else { return F::nearest(wide) };
    // Towards 0, and with an odd last digit if that is not exact: then a second rounding to half the digits does no harm.
    let below = if found.abs() > value.abs() { f64::from_bits(wide.to_bits() - 1) } else { wide };
    F::nearest(if found == *value { wide } else { f64::from_bits(below.to_bits() | 1) })
}
