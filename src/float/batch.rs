//! Values at many points: several at once, as wide as the machine is.

use std::array::from_fn;
use std::hint::select_unpredictable;

use super::basis::{FloatBasis, Frame, length};
use super::error::{FloatError, HIGHEST_DEGREE};
use super::lanes::{Accurate, Chunk, Fast, LANES, Lanewise};
use super::machine::Kernel;
use super::real::Real;
use super::vectors::Vectors;
use crate::spline::{Side, Span};

/// How values at many points are computed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum Precision {
    /// As everywhere: the exact value, rounded once and a little more.
    #[default]
    Accurate,
    /// In plain floats with one division a point: |v̂ − v| ≤ (k² + 7k)·u·v barring underflow, several times as fast.
    ///
    /// For degrees 1 to [`FAST_DEGREE`](super::FAST_DEGREE), and knots whose gaps, with r, are not so far apart that the
    /// products of k(k + 1)/2 sums could leave the range (for `f64` and degree 3: the width of the knots, their least gap
    /// and r within 2^60 of each other). Anywhere else it is the same as [`Precision::Accurate`].
    Fast,
}

/// Runs a task on the machine with the method that the precision asks for, fast or accurate. Where there is a fast one, the degree is
/// part of the type, so that loops are compiled for it: a constant does not get through to code for another instruction set.
macro_rules! by_method {
    ($basis:expr, $frame:expr, $precision:expr, |$method:ident| $task:expr) => {
        by_method!(@ $basis, $frame, $precision, $method, $task, (1 2) (2 3) (3 4) (4 5) (5 6))
    };
    (@ $basis:expr, $frame:expr, $precision:expr, $method:ident, $task:expr, $(($degree:literal $count:literal))*) => {
        match ($basis.degree(), $precision == Precision::Fast && $frame.fast) {
            $(($degree, true) => {
                let $method = Fast::<F, $degree> { ratio: $frame.ratio };
                $basis.machine.run($task)
            }
            ($degree, false) => {
                let $method = Accurate::<$count> { degree: $degree, ratio: $basis.ratio };
                $basis.machine.run($task)
            })*
            (degree, _) => {
                let $method = Accurate::<{ HIGHEST_DEGREE + 1 }> { degree, ratio: $basis.ratio };
                $basis.machine.run($task)
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
        let into = Columns { basis: self, spans, values };
        self.scattered(frame, points, precision, into);
        Ok(())
    }

    /// Hands the points, with what belongs to them, to where their values go.
    pub(super) fn scattered(
        &self,
        frame: &Frame<F>,
        points: &[F],
        precision: Precision,
        into: impl Destination<F>,
    ) {
        by_method!(self, frame, precision, |method| Scattered { basis: self, frame, method, points, into });
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
        // Away from the ends no value of the fast path can come out as 0. Written so that a NaN is not within.
        let within = |x: &F, start: F, end: F| *x >= start && *x <= end;
        let margin = self.frame.as_ref().map_or(F::infinity(), Frame::margin);
        let (inner_start, inner_end) = (start + margin, end - margin);
        let inner = points.iter().fold(true, |all, x| all & within(x, inner_start, inner_end));
        if !inner && let Some(position) = points.iter().position(|x| !within(x, start, end)) {
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
        let local = frame.local(span, self.degree());
        by_method!(self, frame, precision, |method| OneSpan {
            method,
            unit: frame.unit,
            local,
            points,
            inner,
            values: &mut *values
        });
        let existing = self.existing(span);
        values[..existing.start * count].fill(F::zero());
        values[existing.end * count..].fill(F::zero());
        Ok(())
    }
}

/// Where the values at points in any order go.
pub(super) trait Destination<F: Real> {
    /// Takes what the method makes of a chunk, whose first point is that of number `first`.
    fn take<M: Vectors, H: Lanewise<F>>(&mut self, m: M, method: &H, chunk: &mut Chunk<F>, first: usize);
}

/// k + 1 values for each point.
struct Columns<'a, F> {
    basis: &'a FloatBasis<F>,
    spans: &'a mut [Option<Span>],
    values: &'a mut [F],
}

impl<F: Real> Destination<F> for Columns<'_, F> {
    #[inline(always)]
    fn take<M: Vectors, H: Lanewise<F>>(&mut self, m: M, method: &H, chunk: &mut Chunk<F>, first: usize) {
        let (degree, stride) = (method.degree(), method.degree() + 1);
        method.values(m, chunk);
        let spans = &mut self.spans[first..][..chunk.count];
        let values = &mut self.values[first * stride..][..chunk.count * stride];
        for (l, (values, span)) in values.chunks_exact_mut(stride).zip(spans).enumerate() {
            #[expect(clippy::needless_range_loop, reason = "a loop whose end the compiler knows")]
            for c in 0..stride {
                values[c] = chunk.values[c][l];
            }
            *span = chunk.inside[l].then(|| Span::assumed(chunk.spans[l]));
            if !chunk.inside[l] || chunk.spans[l] < degree || chunk.spans[l] > self.basis.n() {
                self.basis.blank(*span, values);
            }
        }
    }
}

/// One coordinate after the other for each point of a curve.
pub(super) struct Coordinates<'a, F> {
    pub(super) dimension: usize,
    /// The coordinates of d_{−k}, …, d_{n+k}, divided by the unit, those that there are not being 0.
    pub(super) controls: &'a [F],
    pub(super) unit: F,
    pub(super) points: &'a mut [F],
}

impl<F: Real> Destination<F> for Coordinates<'_, F> {
    #[inline(always)]
    fn take<M: Vectors, H: Lanewise<F>>(&mut self, m: M, method: &H, chunk: &mut Chunk<F>, first: usize) {
        let (dimension, stride) = (self.dimension, method.degree() + 1);
        let controls: [&[F]; LANES] =
            from_fn(|l| &self.controls[chunk.spans[l] * dimension..][..stride * dimension]);
        let points = &mut self.points[first * dimension..][..chunk.count * dimension];
        let control = |l: usize, c: usize, coordinate: usize| controls[l][c * dimension + coordinate];
        let (count, inside) = (chunk.count, chunk.inside);
        method.combinations(m, chunk, dimension, control, |l, coordinate, sum| {
            if l < count {
                points[l * dimension + coordinate] = if inside[l] { sum * self.unit } else { F::zero() };
            }
        });
    }
}

/// Points in any order.
struct Scattered<'a, F, H, D> {
    basis: &'a FloatBasis<F>,
    frame: &'a Frame<F>,
    method: H,
    points: &'a [F],
    into: D,
}

impl<F: Real, H: Lanewise<F>, D: Destination<F>> Kernel for Scattered<'_, F, H, D> {
    type Output = ();

    #[inline(always)]
    fn run<M: Vectors>(self, machine: M) {
        let Self { basis, frame, method, points, mut into } = self;
        let degree = method.degree();
        let knots = basis.knots();
        let last_span = knots.partition_point(|t| *t < knots[knots.len() - 1]) - 1;
        let mut chunk = Chunk::new();
        for (at, part) in points.chunks(LANES).enumerate() {
            let mut x = [knots[last_span]; LANES];
            for (place, point) in x.iter_mut().zip(part) {
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
                let local = &frame.knots[span + 1..][..2 * degree];
                for (place, t) in chunk.knots.iter_mut().zip(local) {
                    place[l] = *t;
                }
                chunk.x[l] = x[l] * frame.unit;
                chunk.spans[l] = span;
                chunk.inside[l] = knots[0] <= x[l] && x[l] <= knots[knots.len() - 1];
            }
            chunk.count = part.len();
            into.take(machine, &method, &mut chunk, at * LANES);
        }
    }
}

/// Points of one span.
struct OneSpan<'a, F, H> {
    method: H,
    unit: F,
    /// t_{j−k+1}, …, t_{j+k} in the unit.
    local: &'a [F],
    points: &'a [F],
    /// Are all points away from the ends?
    inner: bool,
    values: &'a mut [F],
}

impl<F: Real, H: Lanewise<F>> Kernel for OneSpan<'_, F, H> {
    type Output = ();

    #[inline(always)]
    fn run<M: Vectors>(self, machine: M) {
        let Self { method, unit, local, points, inner, values } = self;
        method.on_span(machine, unit, local, points, inner, values);
    }
}

#[cfg(test)]
mod tests {
    use super::super::FloatCurve;
    use super::super::machine::Machine;
    use super::*;

    /// Clamped knots with one repeated, and one gap like no other.
    fn knots(degree: usize) -> Vec<f64> {
        let inner = [1.0, 1.5, 1.5, 1.5 + 2.0_f64.powi(-9), 4.0, 4.7, 4.9, 6.0, 9.0];
        let ends = |t| std::iter::repeat_n(t, degree + 1);
        ends(0.0).chain(inner).chain(ends(9.3)).collect()
    }

    /// The bits of all accurate results: many values, values on a span, single values, points of a curve.
    fn bits(basis: &FloatBasis<f64>, points: &[f64]) -> Vec<u64> {
        let (stride, count) = (basis.degree() + 1, points.len());
        let (mut spans, mut values) = (vec![None; count], vec![0.0; count * stride]);
        basis.values_at(points, Precision::Accurate, &mut spans, &mut values).expect("finite points");
        let mut all = values.clone();
        let mut column = vec![0.0; stride];
        for (x, span) in points.iter().zip(&spans) {
            if let Some(span) = span {
                basis.values_on(*span, &[*x], Precision::Accurate, &mut column).expect("in the span");
                all.extend(&column);
            }
            basis.values(*x, Side::Right, &mut column).expect("a finite point");
            all.extend(&column);
        }
        let alternating = [3.0, -1.7, 1e-3, 0.0, -1e5].into_iter().cycle();
        let controls = alternating.take(3 * (basis.n() + 1)).collect();
        let curve = FloatCurve::new(basis.clone(), 3, controls).expect("three for each function");
        let mut many = vec![0.0; 3 * count];
        curve.points_at(points, Precision::Accurate, &mut many).expect("finite points");
        for (x, of_many) in points.iter().zip(many.chunks(3)) {
            let mut single = [0.0; 3];
            curve.point(*x, Side::Right, &mut single).expect("a finite point");
            assert_eq!(single.map(f64::to_bits)[..], of_many.iter().map(|c| c.to_bits()).collect::<Vec<_>>());
        }
        all.extend(many);
        all.into_iter().map(f64::to_bits).collect()
    }

    /// With vectors of any width, with products by fused multiply–add or by halves: the same bits.
    #[test]
    fn no_result_depends_on_the_machine() {
        for degree in 0..=HIGHEST_DEGREE {
            for alpha in [-0.3, 1.7, f64::INFINITY, -1e-9, 1e16] {
                let knots = knots(degree);
                let mut basis = FloatBasis::new(knots.clone(), degree, alpha).expect("a basis");
                let parts = (0..41).map(|i| -0.2 + 0.241 * f64::from(i));
                let points: Vec<f64> = parts.chain(knots).collect();
                let mut results = Machine::all().into_iter().map(|machine| {
                    basis.machine = machine;
                    bits(&basis, &points)
                });
                let first = results.next();
                assert!(results.all(|other| first.as_ref() == Some(&other)), "k = {degree}, α = {alpha:e}");
            }
        }
    }
}
