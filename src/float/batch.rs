//! Values at many points: several at once, as wide as the machine is.

use std::hint::select_unpredictable;

use super::accurate::Workspace;
use super::basis::{FloatBasis, Frame, Ratio, length};
use super::error::{FloatError, HIGHEST_DEGREE};
use super::fast::{self, FAST_DEGREE};
use super::machine::Kernel;
use super::pair::Products;
use super::point::lifted;
use super::real::Real;
use crate::spline::{Side, Span};

/// How values at many points are computed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum Precision {
    /// As everywhere: the exact value, rounded once and a little more.
    #[default]
    Accurate,
    /// In plain floats with one division a point: |v̂ − v| ≤ (k² + 7k)·u·v barring underflow, several times as fast.
    ///
    /// For degrees 1 to [`FAST_DEGREE`](fast::FAST_DEGREE), and knots whose gaps, with r, are not so far apart that the
    /// products of k(k + 1)/2 sums could leave the range (for `f64` and degree 3: the width of the knots, their least gap
    /// and r within 2^60 of each other). Anywhere else it is the same as [`Precision::Accurate`].
    Fast,
}

/// How many points are worked on at once.
const LANES: usize = 16;

/// Runs a task on the machine with the method that the precision asks for, fast or accurate: each method is a type of
/// its own, so that its loops are compiled for its degree.
macro_rules! by_method {
    ($basis:ident, $frame:ident, $precision:ident, |$method:ident| $task:expr) => {
        by_method!(@ $basis, $frame, $precision, $method, $task, 1 2 3 4)
    };
    (@ $basis:ident, $frame:ident, $precision:ident, $method:ident, $task:expr, $($degree:literal)*) => {
        match $basis.fast_degree($precision) {
            $(Some($degree) => {
                let $method = Fast::<F, $degree>($frame.ratio);
                $basis.machine.run($task);
            })*
            Some(_) => {
                let $method = Fast::<F, FAST_DEGREE>($frame.ratio);
                $basis.machine.run($task);
            }
            None => {
                let $method = Accurate::new($basis);
                $basis.machine.run($task);
            }
        }
    };
}

impl<F: Real> FloatBasis<F> {
    /// The values at points in any order: for each point the span, or `None` outside of [t_0, t_m], and k + 1 values as
    /// in [`Self::values`], one point after the other; limits are taken from the right.
    ///
    /// ```
    /// use knotproof::float::{FloatBasis, Precision};
    ///
    /// let basis = FloatBasis::new(vec![0.0, 0.0, 1.0, 2.0, 2.0], 1, f64::INFINITY)?;
    /// let (mut spans, mut values) = ([None; 3], [0.0; 6]);
    /// basis.values_at(&[1.25, 7.0, 0.5], Precision::Fast, &mut spans, &mut values)?;
    /// assert_eq!(spans.map(|span| span.map(|span| span.index())), [Some(2), None, Some(1)]);
    /// assert_eq!(values, [0.75, 0.25, 0.0, 0.0, 0.5, 0.5]);
    /// # Ok::<(), knotproof::float::FloatError>(())
    /// ```
    ///
    /// # Errors
    /// [`FloatError::Point`] if a point is not finite, [`FloatError::Length`] unless there is a place for each span and
    /// k + 1 for its values.
    pub fn values_at(
        &self,
        points: &[F],
        precision: Precision,
        spans: &mut [Option<Span>],
        values: &mut [F],
    ) -> Result<(), FloatError> {
        length("spans", points.len(), spans.len())?;
        length("values", points.len() * (self.degree() + 1), values.len())?;
        if let Some(x) = points.iter().find(|x| !x.is_finite()) {
            return Err(FloatError::Point(x.widen()));
        }
        let Some(frame) = &self.frame else {
            for ((x, span), values) in
                points.iter().zip(spans).zip(values.chunks_exact_mut(self.degree() + 1))
            {
                *span = self.values(*x, Side::Right, values)?;
            }
            return Ok(());
        };
        by_method!(self, frame, precision, |method| Scattered {
            basis: self,
            frame,
            method,
            points,
            spans,
            values
        });
        Ok(())
    }

    /// The values at points of the one closed span [t_j, t_{j+1}], as limits in that span: row c of `values` holds
    /// G_{j−k+c}^k at all points.
    ///
    /// # Errors
    /// [`FloatError::Outside`] for a point that is not in the span, [`FloatError::Span`] for a span of other knots,
    /// [`FloatError::Length`] unless there are k + 1 rows as long as the points.
    pub fn values_on(
        &self,
        span: Span,
        points: &[F],
        precision: Precision,
        values: &mut [F],
    ) -> Result<(), FloatError> {
        let (start, end) = self.ends(span)?;
        length("values", points.len() * (self.degree() + 1), values.len())?;
        // Written so that a NaN is not in the span.
        let outside = |x: &F| !(*x >= start && *x <= end);
        if points.iter().fold(false, |any, x| any | outside(x)) {
            let position = points.iter().position(outside).unwrap_or(0);
            let (x, start, end) = (points[position].widen(), start.widen(), end.widen());
            return Err(FloatError::Outside { position, x, start, end });
        }
        let count = points.len();
        let Some(frame) = &self.frame else {
            let mut column = [F::zero(); HIGHEST_DEGREE + 1];
            for (p, x) in points.iter().enumerate() {
                self.at_point(span, *x, &mut column[..=self.degree()]);
                for (c, value) in column[..=self.degree()].iter().enumerate() {
                    values[c * count + p] = *value;
                }
            }
            return Ok(());
        };
        by_method!(self, frame, precision, |method| OneSpan {
            basis: self,
            frame,
            method,
            span,
            points,
            values
        });
        Ok(())
    }

    /// k, if there is a fast path for it and it is asked for.
    fn fast_degree(&self, precision: Precision) -> Option<usize> {
        let within_range = self.frame.as_ref().is_some_and(|frame| frame.fast);
        let degree = Some(self.degree()).filter(|k| (1..=FAST_DEGREE).contains(k));
        degree.filter(|_| precision == Precision::Fast && within_range)
    }
}

/// LANES points with their knots, and what comes of them.
struct Chunk<F> {
    x: [F; LANES],
    /// Entry i holds t_{j−k+1+i} of each point.
    knots: [[F; LANES]; 2 * HIGHEST_DEGREE],
    /// Entry c holds G_{j−k+c} of each point.
    values: [[F; LANES]; HIGHEST_DEGREE + 1],
}

impl<F: Real> Chunk<F> {
    fn new() -> Self {
        Self {
            x: [F::zero(); LANES],
            knots: [[F::zero(); LANES]; 2 * HIGHEST_DEGREE],
            values: [[F::zero(); LANES]; HIGHEST_DEGREE + 1],
        }
    }
}

/// How the values of a chunk are computed, its points and knots being in the unit of a frame.
trait Lanewise<F> {
    /// k: a constant where it is one.
    fn degree(&self) -> usize;
    fn run<M: Products>(&mut self, chunk: &mut Chunk<F>);
}

struct Accurate {
    degree: usize,
    ratio: Ratio,
    workspace: Box<Workspace<LANES>>,
}

impl Accurate {
    fn new<F: Real>(basis: &FloatBasis<F>) -> Self {
        Self { degree: basis.degree(), ratio: basis.ratio, workspace: Box::new(Workspace::new()) }
    }
}

impl<F: Real> Lanewise<F> for Accurate {
    #[inline(always)]
    fn degree(&self) -> usize {
        self.degree
    }

    #[inline(always)]
    fn run<M: Products>(&mut self, chunk: &mut Chunk<F>) {
        let Chunk { x, knots, values } = chunk;
        self.workspace.run::<M, F>(self.ratio, x, &knots[..2 * self.degree]);
        for (c, values) in values.iter_mut().enumerate().take(self.degree + 1) {
            for (l, value) in values.iter_mut().enumerate() {
                let above = c == 0 || knots[c - 1][l] < x[l];
                let below = c == self.degree || x[l] < knots[self.degree + c][l];
                *value = lifted(self.workspace.rounded(c, l), above, below);
            }
        }
    }
}

/// In degree K, with r.
struct Fast<F, const K: usize>(F);

impl<F: Real, const K: usize> Lanewise<F> for Fast<F, K> {
    #[inline(always)]
    fn degree(&self) -> usize {
        K
    }

    #[inline(always)]
    fn run<M: Products>(&mut self, chunk: &mut Chunk<F>) {
        fast::values::<F, K, LANES>(self.0, &chunk.x, &chunk.knots, &mut chunk.values);
    }
}

/// Points in any order.
struct Scattered<'a, F, H> {
    basis: &'a FloatBasis<F>,
    frame: &'a Frame<F>,
    method: H,
    points: &'a [F],
    spans: &'a mut [Option<Span>],
    values: &'a mut [F],
}

impl<F: Real, H: Lanewise<F>> Kernel for Scattered<'_, F, H> {
    type Output = ();

    #[inline(always)]
    fn run<M: Products>(self) {
        let Self { basis, frame, mut method, points, spans, values } = self;
        let (degree, stride) = (method.degree(), method.degree() + 1);
        let knots = basis.knots();
        let last_span = knots.partition_point(|t| *t < knots[knots.len() - 1]) - 1;
        let mut chunk = Chunk::new();
        let parts = points.chunks(LANES).zip(spans.chunks_mut(LANES));
        for ((points, spans), values) in parts.zip(values.chunks_mut(LANES * stride)) {
            // Lanes without a point take a knot, and nobody looks at the result.
            let mut x = [knots[last_span]; LANES];
            for (place, point) in x.iter_mut().zip(points) {
                *place = *point;
            }
            // The last knot that is not above x, by binary search in all lanes at once: so none waits for another.
            let mut below = [0; LANES];
            let mut left = knots.len();
            while left > 1 {
                let half = left / 2;
                for l in 0..LANES {
                    let higher = knots[below[l] + half] <= x[l];
                    below[l] = select_unpredictable(higher, below[l] + half, below[l]);
                }
                left -= half;
            }
            for l in 0..LANES {
                let span = below[l].min(last_span);
                let local = &frame.knots[span + 1..=span + 2 * degree];
                for (place, t) in chunk.knots.iter_mut().zip(local) {
                    place[l] = *t;
                }
                chunk.x[l] = x[l] * frame.unit;
                below[l] = span;
            }
            method.run::<M>(&mut chunk);
            for (l, (values, span)) in values.chunks_exact_mut(stride).zip(spans).enumerate() {
                for (value, lanes) in values.iter_mut().zip(&chunk.values) {
                    *value = lanes[l];
                }
                let inside = knots[0] <= x[l] && x[l] <= knots[knots.len() - 1];
                *span = inside.then(|| Span::assumed(below[l]));
                if !inside || below[l] < degree || below[l] > basis.n() {
                    basis.blank(*span, values);
                }
            }
        }
    }
}

/// Points of one span.
struct OneSpan<'a, F, H> {
    basis: &'a FloatBasis<F>,
    frame: &'a Frame<F>,
    method: H,
    span: Span,
    points: &'a [F],
    values: &'a mut [F],
}

impl<F: Real, H: Lanewise<F>> Kernel for OneSpan<'_, F, H> {
    type Output = ();

    #[inline(always)]
    fn run<M: Products>(self) {
        let Self { basis, frame, mut method, span, points, values } = self;
        let (degree, count) = (method.degree(), points.len());
        let mut chunk = Chunk::new();
        for (place, t) in chunk.knots.iter_mut().zip(&frame.knots[span.index() + 1..]).take(2 * degree) {
            *place = [*t; LANES];
        }
        for (at, part) in points.chunks(LANES).enumerate() {
            // Lanes without a point keep the one before, or a knot.
            if part.len() < LANES {
                chunk.x = [frame.knots[span.index() + degree]; LANES];
            }
            for (place, x) in chunk.x.iter_mut().zip(part) {
                *place = *x * frame.unit;
            }
            method.run::<M>(&mut chunk);
            for c in 0..=degree {
                let row = &mut values[c * count + at * LANES..][..part.len()];
                // Whole chunks are of a length that the compiler knows.
                match row.first_chunk_mut() {
                    Some(row) => *row = chunk.values[c],
                    None => row.copy_from_slice(&chunk.values[c][..part.len()]),
                }
            }
        }
        let existing = basis.existing(span);
        values[..existing.start * count].fill(F::zero());
        values[existing.end * count..].fill(F::zero());
    }
}
