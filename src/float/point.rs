//! The triangle at one point, in pairs of floats: about 106 bits on the way, so that the one rounding at the end is all
//! there is.

use super::accurate::{InFrame, Terms, triangle};
use super::basis::{FloatBasis, Ratio, length};
use super::error::{FloatError, HIGHEST_DEGREE};
use super::machine::Kernel;
use super::pair::Pair;
use super::real::Real;
use super::scaled::Scaled;
use super::vectors::Vectors;
use crate::spline::{Side, Span};

/// G_{j−k+c} at x with a value inside of its support that rounded to 0 made positive; `knot`(i) is t_{j−k+1+i}.
///
/// G_{j−k} and G_j can have an end of their support at an end of the span, but where they do not vanish there they jump, and
/// are 1: so t_{j−k} and t_{j+k+1} need not be looked at.
#[inline(always)]
pub(super) fn lifted<F: Real>(value: F, c: usize, degree: usize, x: F, knot: impl Fn(usize) -> F) -> F {
    let inside = (c == 0 || knot(c - 1) < x) && (c == degree || x < knot(degree + c));
    if value < F::LEAST && inside { F::LEAST } else { value }
}

/// Up to k + 1 numbers.
pub(crate) type Column = [Pair; HIGHEST_DEGREE + 1];

/// The differences of knots, or p and q, are so far apart that no unit suits them all.
struct FarApart<'a, F> {
    ratio: Ratio,
    x: F,
    knots: &'a [F],
}

impl<F: Real> Terms<f64> for FarApart<'_, F> {
    #[inline(always)]
    fn terms(&self, m: impl Vectors<Vector = f64>, d: usize, c: usize) -> [Pair; 3] {
        let (x, degree) = (self.x.widen(), self.knots.len() / 2);
        let rise = Scaled::difference(m, x, self.knots[degree - d + c].widen());
        let fall = Scaled::difference(m, self.knots[degree + c].widen(), x);
        let (rise, fall) =
            Scaled::in_one_unit(rise.times(m, Pair::of(self.ratio.p)), fall.times(m, self.ratio.q));
        [rise, fall, rise.plus_like(m, fall)]
    }
}

/// The triangle at a point of a span.
struct AtPoint<'a, F> {
    basis: &'a FloatBasis<F>,
    span: Span,
    x: F,
}

impl<F: Real> AtPoint<'_, F> {
    /// For degrees below C.
    #[inline(always)]
    fn below<const C: usize>(&self, m: impl Vectors<Vector = f64>, degree: usize) -> Column {
        let Self { basis, span, x } = *self;
        let values: [_; C] = match &basis.frame {
            Some(frame) => {
                let knots = frame.local(span, degree);
                let terms = InFrame::<_, C>::new(m, basis.ratio, degree, (x * frame.unit).widen(), |i| {
                    knots[i].widen()
                });
                triangle(m, degree, &terms)
            }
            None => triangle(m, degree, &FarApart { ratio: basis.ratio, x, knots: basis.local(span) }),
        };
        let mut column = [Pair::ZERO; HIGHEST_DEGREE + 1];
        column[..C].copy_from_slice(&values);
        column
    }
}

impl<F: Real> Kernel for AtPoint<'_, F> {
    type Output = Column;

    #[inline(always)]
    fn run<M: Vectors>(self, machine: M) -> Column {
        // Degrees that are asked for all the time, compiled for themselves.
        match self.basis.degree() {
            1 => self.below::<2>(machine.single(), 1),
            2 => self.below::<3>(machine.single(), 2),
            3 => self.below::<4>(machine.single(), 3),
            degree => self.below::<{ HIGHEST_DEGREE + 1 }>(machine.single(), degree),
        }
    }
}

/// The functions on the span at x, a point of the closed span, before they are rounded.
pub(crate) fn unrounded<F: Real>(basis: &FloatBasis<F>, span: Span, x: F) -> Column {
    basis.machine.run(AtPoint { basis, span, x })
}

impl<F: Real> FloatBasis<F> {
    /// G_{j−k}^k, …, G_j^k at x, as limits from the given side, into `values`; returns the span [t_j, t_{j+1}). `None`, and
    /// zeros, outside [t_0, t_m]. At t_m both sides are the limit from the left.
    ///
    /// Allocates nothing. The bound is that of the [type](Self).
    ///
    /// # Errors
    /// [`FloatError::Point`] if x is not finite, [`FloatError::Length`] unless there are k + 1 places.
    pub fn values(&self, x: F, side: Side, values: &mut [F]) -> Result<Option<Span>, FloatError> {
        length("values", self.degree() + 1, values.len())?;
        let span = self.span_at(x, side)?;
        match span {
            Some(span) => self.at_point(span, x, values),
            None => values.fill(F::zero()),
        }
        Ok(span)
    }

    /// [`Self::values`] on a span, at a point of the closed span.
    pub(crate) fn at_point(&self, span: Span, x: F, values: &mut [F]) {
        let (degree, local) = (self.degree(), self.local(span));
        for (c, (value, pair)) in values.iter_mut().zip(unrounded(self, span, x)).enumerate() {
            *value = lifted(F::nearest(pair.hi), c, degree, x, |i| local[i]);
        }
        self.blank(Some(span), values);
    }
}
