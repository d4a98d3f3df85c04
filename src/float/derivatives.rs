//! One-sided derivatives of any order in floats.

use super::accurate::InFrame;
use super::basis::{FloatBasis, Ratio, length};
use super::error::{FloatError, HIGHEST_DEGREE};
use super::machine::Kernel;
use super::pair::Pair;
use super::point::Column;
use super::real::Real;
use super::vectors::{Split, Vectors};
use crate::spline::{Side, Span};

/// c_0, …, c_D of each function: entry e holds the coefficients of ε^e of all.
pub(super) type Jets = [Column; HIGHEST_DEGREE + 1];

/// What the weights at x are made of, in any degree.
pub(super) type JetFrame = InFrame<f64, { HIGHEST_DEGREE + 1 }>;

impl<F: Real> FloatBasis<F> {
    /// The functions that live on the span at x and their derivatives up to an order of at most
    /// [`HIGHEST_DEGREE`]: row e of `values` holds the k + 1 derivatives of order e, as limits from the given side, laid out
    /// as in [`Self::values`].
    ///
    /// Derivatives are sums of terms of both signs. With M_e the sum of the absolute values of these terms
    /// (`docs/float.md` says which), every derivative v of order e comes out with an error of at most
    ///
    /// u|v| + k(e + 2)·2⁻⁹⁸·M_e,
    ///
    /// barring underflow: rounded once, unless more than 40 bits cancel. Only what is not finite is an error.
    ///
    /// ```
    /// use knotproof::float::FloatBasis;
    /// use knotproof::spline::Side;
    ///
    /// // G_1² of the paper's U4 with α = −1 has a corner at the simple knot 1.
    /// let basis = FloatBasis::new(vec![0.0, 0.0, 0.0, 1.0, 2.0, 3.0, 3.0, 3.0], 2, -1.0)?;
    /// let mut rows = [0.0; 6];
    /// basis.derivatives(1.0, Side::Left, 1, &mut rows)?;
    /// assert_eq!(rows[4], -10.0 / 9.0);
    /// basis.derivatives(1.0, Side::Right, 1, &mut rows)?;
    /// assert_eq!(rows[3], -7.0 / 9.0);
    /// # Ok::<(), knotproof::float::FloatError>(())
    /// ```
    ///
    /// # Errors
    /// [`FloatError::Point`] if x is not finite; [`FloatError::Order`] above the highest order; [`FloatError::Length`]
    /// unless there are order + 1 rows of k + 1; [`FloatError::Derivative`] for a derivative beyond the range, or for
    /// any but the values where gaps and r are so far apart (2^400, for `f32` 2^100) that the terms may be.
    pub fn derivatives(
        &self,
        x: F,
        side: Side,
        order: usize,
        values: &mut [F],
    ) -> Result<Option<Span>, FloatError> {
        if order > HIGHEST_DEGREE {
            return Err(FloatError::Order(order));
        }
        let stride = self.degree() + 1;
        length("derivatives", (order + 1) * stride, values.len())?;
        let span = self.values(x, side, &mut values[..stride])?;
        let (Some(at), true) = (span, order > 0) else {
            values[stride..].fill(F::zero());
            return Ok(span);
        };
        let frame = self.frame.as_ref().ok_or(FloatError::Derivative(1))?;
        let knots = frame.local(at, self.degree());
        let jets = self.machine.run(JetTriangle { ratio: self.ratio, x: x * frame.unit, knots, order });
        let (unit, mut factor) = (frame.unit.widen(), Pair::ONE);
        let rows = values.chunks_exact_mut(stride).zip(&jets).enumerate().skip(1);
        for (e, (row, coefficients)) in rows {
            // e!·unit^e, and nothing is rounded up to 18!.
            factor = factor.times(Split, Pair::of(small(e))).normal(Split);
            for (value, coefficient) in row.iter_mut().zip(coefficients) {
                let scaled = coefficient.times(Split, factor).normal(Split).hi;
                *value = F::nearest((0..e).fold(scaled, |scaled, _| scaled * unit));
            }
            self.blank(span, row);
            if row.iter().any(|value| !value.is_finite()) {
                return Err(FloatError::Derivative(e));
            }
        }
        Ok(span)
    }
}

/// A number up to [`HIGHEST_DEGREE`] as a float.
pub(super) fn small(n: usize) -> f64 {
    u32::try_from(n).map_or(f64::INFINITY, f64::from)
}

/// The Taylor coefficients of a weight. With E = rise + fall = E₀ + (p − q)ε they are, from w_1 on, w_1 = pq(b − a)/E₀² and
/// w_{e+1} = −(p − q)/E₀·w_e: products and quotients, so nothing cancels in them.
pub(super) struct WeightJet {
    /// w_0 and 1 − w_0.
    pub(super) w: Pair,
    pub(super) complement: Pair,
    /// w_1.
    slope: Pair,
    /// −(p − q)/E₀.
    bend: Pair,
}

impl WeightJet {
    /// The weight at place c of level d, with the 2k local knots in the unit of a frame.
    #[inline(always)]
    pub(super) fn new<F: Real>(
        m: impl Vectors<Vector = f64>,
        terms: &JetFrame,
        ratio: Ratio,
        knots: &[F],
        d: usize,
        c: usize,
    ) -> Self {
        let degree = knots.len() / 2;
        let over = |a: Pair, b: Pair| a.over(m, b).normal(m);
        let (rise, fall) = terms.parts(d, c);
        let (rise, fall) = (rise.normal(m), fall.normal(m));
        let sum = rise.plus_like(m, fall).normal(m);
        let width = Pair::difference(m, knots[degree + c].widen(), knots[degree - d + c].widen());
        let slope = over(width.by(m, ratio.p).normal(m), sum).times(m, over(ratio.q, sum)).normal(m);
        let bend = over(Pair::of(-ratio.difference), sum);
        Self { w: over(rise, sum), complement: over(fall, sum), slope, bend }
    }

    /// s_e = w_1 g_{e−1} + … + w_e g_0 = w_1 g_{e−1} − (p − q)/E₀·s_{e−1}: the coefficient of w·G but for w_0 g_e.
    #[inline(always)]
    pub(super) fn series(&self, m: impl Vectors<Vector = f64>, previous: Pair, series: Pair) -> Pair {
        self.slope.times(m, previous).normal(m).plus(m, self.bend.times(m, series).normal(m))
    }
}

/// The triangle over jets x + ε, in the unit of a frame.
struct JetTriangle<'a, F> {
    ratio: Ratio,
    x: F,
    knots: &'a [F],
    order: usize,
}

impl<F: Real> Kernel for JetTriangle<'_, F> {
    type Output = Jets;

    /// A product w·G has the coefficients w_0 g_e + s_e, and (1 − w)·G has (1 − w_0) g_e − s_e.
    #[inline(always)]
    fn run<M: Vectors>(self, machine: M) -> Jets {
        let Self { ratio, x, knots, order } = self;
        let (m, degree) = (machine.single(), knots.len() / 2);
        let terms = JetFrame::new(m, ratio, degree, x.widen(), |i| knots[i].widen());
        let mut jets = [[Pair::ZERO; HIGHEST_DEGREE + 1]; HIGHEST_DEGREE + 1];
        jets[0][0] = Pair::ONE;
        for d in 1..=degree {
            let mut own = [Pair::ZERO; HIGHEST_DEGREE + 1];
            for c in 0..d {
                let weight = WeightJet::new(m, &terms, ratio, knots, d, c);
                let (mut previous, mut series) = (Pair::ZERO, Pair::ZERO);
                for (row, own) in jets.iter_mut().zip(&mut own).take(order + 1) {
                    let g = row[c];
                    series = weight.series(m, previous, series);
                    let stays = weight.complement.times(m, g).normal(m).plus(m, series.negate());
                    row[c] = own.plus(m, stays);
                    *own = weight.w.times(m, g).normal(m).plus(m, series);
                    previous = g;
                }
            }
            for (row, own) in jets.iter_mut().zip(own).take(order + 1) {
                row[d] = own;
            }
        }
        jets
    }
}
