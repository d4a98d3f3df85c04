//! The triangle and de Boor's algorithm at one point, in pairs of floats: about 106 bits on the way, so that the one
//! rounding at the end is all there is.

use super::basis::{FloatBasis, Ratio, length};
use super::error::{FloatError, HIGHEST_DEGREE};
use super::machine::Kernel;
use super::pair::{Pair, Products};
use super::real::Real;
use super::scaled::Scaled;
use crate::spline::{Side, Span};

/// Makes positive what rounded to 0 and is not 0: a value of G_i inside its support.
///
/// G_{j−k} and G_j can have an end of their support at an end of the span, but where they do not vanish there they jump, and
/// are 1: so t_{j−k} and t_{j+k+1} need not be looked at.
#[inline(always)]
pub(super) fn lifted<F: Real>(value: F, above_start: bool, below_end: bool) -> F {
    if above_start && below_end && value < F::LEAST { F::LEAST } else { value }
}

/// Up to k + 1 numbers.
pub(crate) type Column = [Pair; HIGHEST_DEGREE + 1];

/// Where the weights at a point come from: entry (d, c) is (w_i^d, 1 − w_i^d) for i = j − d + 1 + c.
pub(super) trait Weights {
    fn shares<M: Products>(&self, d: usize, c: usize) -> (Pair, Pair);
}

/// All differences in the unit of a frame.
pub(super) struct InFrame {
    /// p(x − t_{j+1−s}) at s − 1.
    rises: [Pair; HIGHEST_DEGREE],
    /// q(t_{j+w} − x) at w − 1.
    falls: [Pair; HIGHEST_DEGREE],
}

impl InFrame {
    #[inline(always)]
    pub(super) fn new<M: Products, F: Real>(ratio: Ratio, x: F, knots: &[F]) -> Self {
        let (mut rises, mut falls) = ([Pair::ZERO; HIGHEST_DEGREE], [Pair::ZERO; HIGHEST_DEGREE]);
        let (starts, ends) = knots.split_at(knots.len() / 2);
        for (rise, start) in rises.iter_mut().zip(starts.iter().rev()) {
            *rise = Pair::difference(x.widen(), start.widen()).times::<M>(Pair::of(ratio.p));
        }
        for (fall, end) in falls.iter_mut().zip(ends) {
            *fall = Pair::difference(end.widen(), x.widen()).times::<M>(ratio.q);
        }
        Self { rises, falls }
    }

    /// The two terms of the denominator.
    #[inline(always)]
    pub(super) fn terms(&self, d: usize, c: usize) -> (Pair, Pair) {
        (self.rises[d - 1 - c], self.falls[c])
    }
}

impl Weights for InFrame {
    #[inline(always)]
    fn shares<M: Products>(&self, d: usize, c: usize) -> (Pair, Pair) {
        let (rise, fall) = self.terms(d, c);
        Pair::shares::<M>(rise, fall)
    }
}

/// The differences of knots, or p and q, are so far apart that no unit suits them all.
struct FarApart<'a, F> {
    ratio: Ratio,
    x: F,
    knots: &'a [F],
}

impl<F: Real> Weights for FarApart<'_, F> {
    #[inline(always)]
    fn shares<M: Products>(&self, d: usize, c: usize) -> (Pair, Pair) {
        let (x, degree) = (self.x.widen(), self.knots.len() / 2);
        let rise = Scaled::difference(x, self.knots[degree - d + c].widen());
        let fall = Scaled::difference(self.knots[degree + c].widen(), x);
        Scaled::shares::<M>(rise.times::<M>(Pair::of(self.ratio.p)), fall.times::<M>(self.ratio.q))
    }
}

/// What is done with the weights.
trait Task {
    type Output;
    fn run<M: Products>(self, weights: &impl Weights) -> Self::Output;
}

/// The task at a point of a span, with the weights there.
struct AtPoint<'a, F, T> {
    basis: &'a FloatBasis<F>,
    span: Span,
    x: F,
    task: T,
}

impl<F: Real, T: Task> Kernel for AtPoint<'_, F, T> {
    type Output = T::Output;

    #[inline(always)]
    fn run<M: Products>(self) -> T::Output {
        let Self { basis, span, x, task } = self;
        match &basis.frame {
            Some(frame) => {
                let knots = frame.local(span, basis.degree());
                task.run::<M>(&InFrame::new::<M, F>(basis.ratio, x * frame.unit, knots))
            }
            None => task.run::<M>(&FarApart { ratio: basis.ratio, x, knots: basis.local(span) }),
        }
    }
}

/// G_{j−k}^k, …, G_j^k by the triangle.
struct Triangle {
    degree: usize,
}

impl Task for Triangle {
    type Output = Column;

    #[inline(always)]
    fn run<M: Products>(self, weights: &impl Weights) -> Column {
        let mut values = [Pair::ZERO; HIGHEST_DEGREE + 1];
        values[0] = Pair::ONE;
        for d in 1..=self.degree {
            // Each G_i^{d−1} is split in two: the part w goes to G_i^d, the part 1 − w to G_{i−1}^d.
            let mut own = Pair::ZERO;
            for (c, place) in values.iter_mut().enumerate().take(d) {
                let (w, complement) = weights.shares::<M>(d, c);
                let value = *place;
                *place = own.plus_like(complement.times::<M>(value));
                own = w.times::<M>(value);
            }
            values[d] = own;
        }
        values
    }
}

/// One coordinate of the point of a curve by de Boor's algorithm (T4.1), from those of d_{j−k}, …, d_j:
/// d_i^{r+1} = w_i^{k−r} d_i^r + (1 − w_i^{k−r}) d_{i−1}^r.
struct DeBoor<'a> {
    degree: usize,
    /// Several coordinates: the weights are computed once.
    coordinates: &'a mut [Column],
}

impl Task for DeBoor<'_> {
    type Output = ();

    #[inline(always)]
    fn run<M: Products>(self, weights: &impl Weights) {
        for d in (1..=self.degree).rev() {
            for c in 0..d {
                let (w, complement) = weights.shares::<M>(d, c);
                for column in self.coordinates.iter_mut() {
                    column[c] = complement.times::<M>(column[c]).plus(w.times::<M>(column[c + 1]));
                }
            }
        }
    }
}

/// The functions on the span at x, a point of the closed span, before they are rounded.
pub(crate) fn unrounded<F: Real>(basis: &FloatBasis<F>, span: Span, x: F) -> Column {
    basis.machine.run(AtPoint { basis, span, x, task: Triangle { degree: basis.degree() } })
}

/// De Boor's algorithm on each of the columns, which hold a coordinate of d_{j−k}, …, d_j: the point comes out as their
/// first entries.
pub(super) fn de_boor<F: Real>(basis: &FloatBasis<F>, span: Span, x: F, coordinates: &mut [Column]) {
    basis.machine.run(AtPoint { basis, span, x, task: DeBoor { degree: basis.degree(), coordinates } });
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
            let (above, below) = (c == 0 || local[c - 1] < x, c == degree || x < local[degree + c]);
            *value = lifted(F::nearest(pair.hi), above, below);
        }
        self.blank(Some(span), values);
    }
}
