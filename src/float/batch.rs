//! Values at many points: several at once, as wide as the machine is.

use super::accurate::{Workspace, lifted};
use super::basis::{FloatBasis, HIGHEST_DEGREE, Ratio, length};
use super::error::FloatError;
use super::fast;
use super::machine::Kernel;
use super::pair::Products;
use super::real::Real;
use crate::spline::{Side, Span};

/// How values at many points are computed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum Precision {
    /// As everywhere: the exact value, rounded once and a little more.
    #[default]
    Accurate,
    /// In plain floats with one division a point: |v̂ − v| ≤ (k² + 9k)·u·v barring underflow, several times as fast.
    ///
    /// For degrees 1 to [`FAST_DEGREE`](fast::FAST_DEGREE), and knots whose gaps, with r, are not so far apart that the
    /// products of k(k + 1)/2 sums could leave the range (for `f64` and degree 3: gaps and r within 2^160 of each
    /// other). Anywhere else it is the same as [`Precision::Accurate`].
    Fast,
}

/// How many points are worked on at once.
const LANES: usize = 16;

impl<F: Real> FloatBasis<F> {
    /// The values at points in any order: for each point the span, or `None` outside of [t_0, t_m], and k + 1 values as
    /// in [`Self::values`], one point after the other; limits are taken from the right.
    ///
    /// Points that follow each other in one span are found faster.
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
        self.machine.run(Scattered { basis: self, fast: self.is_fast(precision), points, spans, values });
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
        self.machine.run(OneSpan { basis: self, fast: self.is_fast(precision), span, points, values });
        Ok(())
    }

    fn is_fast(&self, precision: Precision) -> bool {
        let degree = (1..=fast::FAST_DEGREE).contains(&self.degree());
        precision == Precision::Fast && degree && self.frame.as_ref().is_some_and(|frame| frame.fast)
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

    /// Computes the values; x and knots are in the unit of a frame.
    #[inline(always)]
    fn run<M: Products>(&mut self, how: &mut How<F>, degree: usize) {
        let Self { x, knots, values } = self;
        let knots = &knots[..2 * degree];
        match how {
            How::Accurate(ratio, workspace) => {
                workspace.run::<M, F>(*ratio, x, knots);
                for (c, values) in values.iter_mut().enumerate().take(degree + 1) {
                    for (l, value) in values.iter_mut().enumerate() {
                        *value = workspace.rounded(c, l);
                    }
                }
            }
            How::Fast(ratio) => match degree {
                1 => fast::values::<F, 1, LANES>(*ratio, x, knots, values),
                2 => fast::values::<F, 2, LANES>(*ratio, x, knots, values),
                3 => fast::values::<F, 3, LANES>(*ratio, x, knots, values),
                4 => fast::values::<F, 4, LANES>(*ratio, x, knots, values),
                _ => fast::values::<F, 5, LANES>(*ratio, x, knots, values),
            },
        }
        for c in 0..=degree {
            for l in 0..LANES {
                let above = c == 0 || knots[c - 1][l] < x[l];
                let below = c == degree || x[l] < knots[degree + c][l];
                values[c][l] = lifted(values[c][l], above, below);
            }
        }
    }
}

/// One of the two ways, with what it needs.
enum How<F> {
    Accurate(Ratio, Box<Workspace<LANES>>),
    Fast(F),
}

impl<F: Real> How<F> {
    fn of(basis: &FloatBasis<F>, fast: bool) -> Option<Self> {
        let frame = basis.frame.as_ref()?;
        Some(if fast { Self::Fast(frame.ratio) } else { Self::Accurate(basis.ratio, Box::new(Workspace::new())) })
    }
}

/// Points in any order.
struct Scattered<'a, F> {
    basis: &'a FloatBasis<F>,
    fast: bool,
    points: &'a [F],
    spans: &'a mut [Option<Span>],
    values: &'a mut [F],
}

impl<F: Real> Kernel for Scattered<'_, F> {
    type Output = ();

    #[inline(always)]
    fn run<M: Products>(self) {
        let Self { basis, fast, points, spans, values } = self;
        let (degree, stride) = (basis.degree(), basis.degree() + 1);
        let mut last = None;
        for (x, span) in points.iter().zip(spans.iter_mut()) {
            *span = basis.search_from(*x, last);
            last = span.or(last);
        }
        let (Some(mut how), Some(frame)) = (How::of(basis, fast), basis.frame.as_ref()) else {
            for ((x, span), values) in points.iter().zip(spans.iter()).zip(values.chunks_exact_mut(stride)) {
                basis.values_in(*span, *x, values);
            }
            return;
        };
        // What lanes without a point compute with: any span will do, and nobody looks at the result.
        let Some(idle) = last else {
            values.fill(F::zero());
            return;
        };
        let mut chunk = Chunk::new();
        let parts = points.chunks(LANES).zip(spans.chunks(LANES));
        for ((points, spans), values) in parts.zip(values.chunks_mut(LANES * stride)) {
            for l in 0..LANES {
                let span = spans.get(l).copied().flatten();
                let first = span.unwrap_or(idle).index() + 1;
                let local = &frame.knots[first..first + 2 * degree];
                for (place, t) in chunk.knots.iter_mut().zip(local) {
                    place[l] = *t;
                }
                chunk.x[l] = match (span, points.get(l)) {
                    (Some(_), Some(x)) => *x * frame.unit,
                    _ => frame.knots[idle.index() + degree],
                };
            }
            chunk.run::<M>(&mut how, degree);
            for (l, (values, span)) in values.chunks_exact_mut(stride).zip(spans).enumerate() {
                for (c, value) in values.iter_mut().enumerate() {
                    *value = chunk.values[c][l];
                }
                basis.blank(*span, values);
            }
        }
    }
}

/// Points of one span.
struct OneSpan<'a, F> {
    basis: &'a FloatBasis<F>,
    fast: bool,
    span: Span,
    points: &'a [F],
    values: &'a mut [F],
}

impl<F: Real> Kernel for OneSpan<'_, F> {
    type Output = ();

    #[inline(always)]
    fn run<M: Products>(self) {
        let Self { basis, fast, span, points, values } = self;
        let (degree, count) = (basis.degree(), points.len());
        if count == 0 {
            return;
        }
        let (Some(mut how), Some(frame)) = (How::of(basis, fast), basis.frame.as_ref()) else {
            let mut column = [F::zero(); HIGHEST_DEGREE + 1];
            for (p, x) in points.iter().enumerate() {
                basis.values_in(Some(span), *x, &mut column[..=degree]);
                for (c, value) in column[..=degree].iter().enumerate() {
                    values[c * count + p] = *value;
                }
            }
            return;
        };
        let mut chunk = Chunk::new();
        for (place, t) in chunk.knots.iter_mut().zip(&frame.knots[span.index() + 1..]).take(2 * degree) {
            *place = [*t; LANES];
        }
        for (at, part) in points.chunks(LANES).enumerate() {
            // Lanes without a point keep the one before, or a knot.
            chunk.x[part.len()..].fill(frame.knots[span.index() + degree]);
            for (place, x) in chunk.x.iter_mut().zip(part) {
                *place = *x * frame.unit;
            }
            chunk.run::<M>(&mut how, degree);
            for (row, lanes) in values.chunks_exact_mut(count).zip(&chunk.values) {
                row[at * LANES..][..part.len()].copy_from_slice(&lanes[..part.len()]);
            }
        }
        let existing = basis.existing(span);
        values[..existing.start * count].fill(F::zero());
        values[existing.end * count..].fill(F::zero());
    }
}

impl<F: Real> FloatBasis<F> {
    /// [`Self::search`] from the right, with a guess.
    #[inline(always)]
    fn search_from(&self, x: F, guess: Option<Span>) -> Option<Span> {
        if let Some(span) = guess {
            let at = span.index();
            if let Some(&[start, end]) = self.knots().get(at..at + 2) {
                if start <= x && x < end {
                    return Some(span);
                }
            }
        }
        self.search(x, Side::Right)
    }

    /// The values in a span, or zeros.
    fn values_in(&self, span: Option<Span>, x: F, values: &mut [F]) {
        match span {
            Some(span) => super::accurate::at_point(self, span, x, values),
            None => values.fill(F::zero()),
        }
    }
}
