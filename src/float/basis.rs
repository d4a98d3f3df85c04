//! The basis in floats: what is prepared once, and values at one point.

use super::error::{FloatError, HIGHEST_DEGREE};
use super::fast;
use super::machine::Machine;
use super::pair::Pair;
use super::power::{exponent, power, shifted};
use super::real::Real;
use super::vectors::Split;
use crate::scalar::{BigRational, RationalAlgebra, exact_value};
use crate::spline::{Basis, Index, KnotVector, Side, Span};

/// The basis (^αG_i^k) of D3.3 in floats, `f64` or `f32`: each value is the exact one for these very floats, rounded
/// once and a little more.
///
/// With F the type of the floats and u half the distance from 1 to the next one (2⁻⁵³ or 2⁻²⁴), every value v̂ that
/// is returned for an exact value v satisfies
///
/// |v̂ − v| ≤ (1 + k·2⁻²²) u v,
///
/// for all knots, all x and all α, the one of 1 − 2⁻⁵³ and 1e300 included, barring underflow; for `f64` k·2⁻⁴⁴ takes the
/// place of k·2⁻²². That is at most 0.51 units in the last place for every degree. `docs/float.md` has the proof,
/// and what underflow means. There is no NaN and no infinity; every value lies in \[0, 1\]; 0 is returned if and only if
/// the exact value is 0 (a positive value below the range becomes the least positive float). The result is the
/// same to the bit on every machine.
///
/// On the span [t_j, t_{j+1}) the functions G_{j−k}, …, G_j live. Entry c of a list of values is G_{j−k+c}^k; it is
/// 0 where there is no such function (j − k + c < 0 or > n).
///
/// ```
/// use knotproof::float::FloatBasis;
/// use knotproof::spline::Side;
///
/// let basis = FloatBasis::new(vec![0.0, 0.0, 0.0, 1.0, 2.0, 3.0, 3.0, 3.0], 2, -1.0)?;
/// let mut values = [0.0; 3];
/// let span = basis.values(0.5, Side::Right, &mut values)?;
/// assert_eq!(span.map(|span| span.index()), Some(2));
/// assert_eq!(values, [4.0 / 9.0, 32.0 / 63.0, 1.0 / 21.0]);
///
/// // Outside [t_0, t_m] all functions are 0.
/// assert_eq!(basis.values(-1.0, Side::Right, &mut values)?, None);
/// assert_eq!(values, [0.0; 3]);
/// assert!(basis.values(f64::NAN, Side::Right, &mut values).is_err());
/// assert!(FloatBasis::new(vec![0.0, 1.0], 0, 0.5).is_err());
/// # Ok::<(), knotproof::float::FloatError>(())
/// ```
#[derive(Debug, Clone)]
pub struct FloatBasis<F> {
    degree: usize,
    alpha: F,
    /// t_0, k times, then t_0, …, t_m, then t_m, k times. A function depends on its own k + 2 knots only, so the
    /// knots that are made up change none; and every span has k knots on either side.
    padded: Vec<F>,
    pub(super) ratio: Ratio,
    /// The common unit of all differences, if there is one; no common unit is needed for values at single points.
    pub(super) frame: Option<Frame<F>>,
    pub(super) machine: Machine,
}

/// r = α/(α − 1) = p/q as a quotient that is never rounded: max(p, q) is in [2^RAISED, 2^(RAISED + 1)], so that no product with
/// a difference gets next to underflow.
#[derive(Debug, Clone, Copy)]
pub(super) struct Ratio {
    pub(super) p: f64,
    pub(super) q: Pair,
    /// p − q, exactly: a power of two with a sign, or 0 for α = ∞.
    pub(super) difference: f64,
}

/// A unit of length in which no difference of knots is small and none is large.
#[derive(Debug, Clone)]
pub(super) struct Frame<F> {
    /// The power of two that everything is multiplied by.
    pub(super) unit: F,
    /// The padded knots, multiplied by it.
    pub(super) knots: Vec<F>,
    /// r, rounded.
    pub(super) ratio: F,
    /// Are the products of the fast path within the range?
    pub(super) fast: bool,
}

/// `docs/float.md`, Range: differences up to 2^LARGEST leave so much room above, and it is needed below.
const RAISED: i32 = 300;

impl Ratio {
    /// |α| and |α − 1|, scaled alike. α is in (−∞, 0) ∪ (1, ∞], or −∞.
    fn of(alpha: f64) -> Self {
        if alpha.is_infinite() {
            return Self { p: power(RAISED), q: Pair::of(power(RAISED)), difference: 0.0 };
        }
        let q = Pair::difference(Split, alpha, 1.0);
        let (p, q, difference) = if alpha < 0.0 { (-alpha, q.negate(), -1.0) } else { (alpha, q, 1.0) };
        let e = RAISED - exponent(p.max(q.hi));
        let q = Pair { hi: shifted(q.hi, e), lo: shifted(q.lo, e) };
        Self { p: shifted(p, e), q, difference: shifted(difference, e) }
    }
}

impl<F: Real> FloatBasis<F> {
    /// Checks the numbers, and changes none. α = ±∞ is the classical case.
    ///
    /// # Errors
    /// [`FloatError`], for the first thing that is wrong: a knot that is not finite, knots that decrease, too few of them
    /// (the rule of [`Basis::new`]), α in [0, 1] or NaN, or a degree above [`HIGHEST_DEGREE`].
    pub fn new(knots: Vec<F>, degree: usize, alpha: F) -> Result<Self, FloatError> {
        if degree > HIGHEST_DEGREE {
            return Err(FloatError::Degree(degree));
        }
        if let Some(position) = knots.iter().position(|t| !t.is_finite()) {
            return Err(FloatError::Knot { position, value: knots[position].widen() });
        }
        if let Some(i) = knots.windows(2).position(|pair| pair[0] > pair[1]) {
            let (previous, value) = (knots[i].widen(), knots[i + 1].widen());
            return Err(FloatError::Decreasing { position: i + 1, previous, value });
        }
        // As for `Basis::new`, m ≥ 2k and at least one function.
        let (needed, count) = ((2 * degree).max(degree + 1) + 1, knots.len());
        if count < needed {
            return Err(FloatError::Count { degree, needed, count });
        }
        let (first, last) = (knots[0], knots[knots.len() - 1]);
        if first >= last {
            return Err(FloatError::AllEqual(first.widen()));
        }
        // A NaN is neither.
        if !(alpha < F::zero() || alpha > F::one()) {
            return Err(FloatError::Index(alpha.widen()));
        }
        let pad = |t| std::iter::repeat_n(t, degree);
        let padded: Vec<F> = pad(first).chain(knots).chain(pad(last)).collect();
        let ratio = Ratio::of(alpha.widen());
        let frame = Frame::of(&padded, degree, ratio);
        Ok(Self { degree, alpha, padded, ratio, frame, machine: Machine::best() })
    }

    /// The same basis, computed without the wide instructions that this machine may have: slower, and the same values.
    /// For comparisons.
    #[must_use]
    pub fn portable(self) -> Self {
        Self { machine: Machine::portable(), ..self }
    }

    /// k.
    #[must_use]
    pub fn degree(&self) -> usize {
        self.degree
    }

    /// α.
    #[must_use]
    pub fn alpha(&self) -> F {
        self.alpha
    }

    /// t_0, …, t_m.
    #[must_use]
    pub fn knots(&self) -> &[F] {
        &self.padded[self.degree..self.padded.len() - self.degree]
    }

    /// n, the index of the last function: m − k − 1.
    #[must_use]
    pub fn n(&self) -> usize {
        self.knots().len() - 2 - self.degree
    }

    /// The floats nearest to an exact basis: what a program is handed that reads the instance.
    ///
    /// # Errors
    /// [`FloatError`], if they are no basis any more: α rounds to 0 or 1, or a knot to infinity, or all knots to one.
    pub fn nearest(basis: &Basis) -> Result<Self, FloatError> {
        let round = |value: &BigRational| F::nearest(0.0_f64.embed(value));
        let knots = basis.knots().knots().iter().map(round).collect();
        Self::new(knots, basis.degree(), basis.index().alpha().as_ref().map_or(F::infinity(), round))
    }

    /// The same basis in exact numbers.
    #[must_use]
    pub fn exact(&self) -> Basis {
        let number = |value: F| match exact_value(value.widen()) {
            Some(number) => number,
            None => unreachable!("all numbers of a basis are finite, except α"),
        };
        let index = match self.alpha.is_infinite() {
            true => Ok(Index::infinity()),
            false => Index::from_alpha(number(self.alpha)),
        };
        let knots: Vec<BigRational> = self.knots().iter().map(|t| number(*t)).collect();
        match (index, KnotVector::new(knots)) {
            (Ok(index), Ok(knots)) => match Basis::new(knots, self.degree, index) {
                Ok(basis) => basis,
                Err(error) => unreachable!("checked when the float basis was made: {error}"),
            },
            _ => unreachable!("checked when the float basis was made"),
        }
    }

    /// The span in which the limit at x from the given side is taken, by binary search; `None` where all functions
    /// are 0. At t_m both sides give the last span.
    ///
    /// # Errors
    /// [`FloatError::Point`] if x is not finite.
    pub fn span_at(&self, x: F, side: Side) -> Result<Option<Span>, FloatError> {
        if !x.is_finite() {
            return Err(FloatError::Point(x.widen()));
        }
        Ok(self.search(x, side))
    }

    /// [`Self::span_at`] for a finite x.
    #[inline]
    pub(super) fn search(&self, x: F, side: Side) -> Option<Span> {
        let knots = self.knots();
        let from_left = side == Side::Left || x == knots[knots.len() - 1];
        let below = knots.partition_point(|t| if from_left { *t < x } else { *t <= x });
        (1..knots.len()).contains(&below).then(|| Span::assumed(below - 1))
    }

    /// (t_j, t_{j+1}).
    ///
    /// # Errors
    /// [`FloatError::Span`] if the knots have no such span.
    pub fn ends(&self, span: Span) -> Result<(F, F), FloatError> {
        match self.knots().get(span.index()..span.index().saturating_add(2)) {
            Some(&[start, end]) if start < end => Ok((start, end)),
            _ => Err(FloatError::Span(span.index())),
        }
    }

    /// t_{j−k+1}, …, t_{j+k}: the knots that the functions on the span [t_j, t_{j+1}) depend on.
    #[inline]
    pub(crate) fn local(&self, span: Span) -> &[F] {
        &self.padded[span.index() + 1..=span.index() + 2 * self.degree]
    }

    /// The places c in a list of values for which G_{j−k+c} exists.
    #[inline(always)]
    pub(crate) fn existing(&self, span: Span) -> std::ops::Range<usize> {
        let missing = self.degree.saturating_sub(span.index());
        missing..(self.n() + 1 + self.degree).saturating_sub(span.index()).min(self.degree + 1)
    }

    /// Zeros for the functions that do not exist, or for all where there is no span.
    #[inline(always)]
    pub(crate) fn blank(&self, span: Option<Span>, values: &mut [F]) {
        let existing = span.map_or(0..0, |span| self.existing(span));
        values[..existing.start].fill(F::zero());
        values[existing.end..].fill(F::zero());
    }
}

/// Is the slice as long as it has to be?
pub(super) fn length(what: &'static str, needed: usize, given: usize) -> Result<(), FloatError> {
    if needed == given { Ok(()) } else { Err(FloatError::Length { what, needed, given }) }
}

/// With differences of knots between 2^−LARGEST and 2^LARGEST in a common unit, no product of two numbers that occur
/// leaves the range, and none that matters is subnormal.
const LARGEST: i32 = 400;

impl<F: Real> Frame<F> {
    /// t_{j−k+1}, …, t_{j+k} in the unit.
    #[inline(always)]
    pub(super) fn local(&self, span: Span, degree: usize) -> &[F] {
        &self.knots[span.index() + 1..=span.index() + 2 * degree]
    }

    /// So far from the ends of a span, no value of the fast path comes out as 0.
    pub(super) fn margin(&self) -> F {
        let two = F::one() + F::one();
        two * fast::least_distance::<F>() / (self.unit * self.ratio.min(F::one()))
    }

    /// The unit in which min(p, q)·(t_{j+1} − t_j) ≥ 2^RAISED for every span, if all knots are below 2^LARGEST in it.
    fn of(padded: &[F], degree: usize, ratio: Ratio) -> Option<Self> {
        let gaps = padded.windows(2).map(|pair| pair[1] - pair[0]).filter(|gap| *gap > F::zero());
        let least = gaps.fold(F::infinity(), F::min);
        let width = padded[padded.len() - 1] - padded[0];
        let largest = padded[padded.len() - 1].abs().max(padded[0].abs());
        let steepest = exponent(ratio.p.min(ratio.q.hi)) - RAISED;
        if !width.is_finite() || steepest < -LARGEST {
            return None;
        }
        // Never below 1: so the products of x and of the knots with the unit are exact.
        let unit = (-exponent(least.widen()) - steepest + 1).max(0);
        if exponent(largest.widen()) + unit > LARGEST.min(F::HIGHEST_EXPONENT) || unit > F::HIGHEST_EXPONENT {
            return None;
        }
        // p/q, to the last bit or so: q.lo is far below that.
        let exact = Pair::of(ratio.p).over(Split, ratio.q).normal(Split);
        let r = F::nearest(exact.hi);
        // No sum rise + fall of the fast path is larger, and it takes a product of so many of them.
        let sum = exponent(width.widen()) + 2 + unit + exponent(exact.hi).max(0) + 1;
        let factors = i32::try_from(degree * (degree + 1) / 2).unwrap_or(i32::MAX);
        let fast = factors.saturating_mul(sum) <= F::FAST_EXPONENT;
        let unit = F::nearest(power(unit));
        Some(Self { unit, knots: padded.iter().map(|t| *t * unit).collect(), ratio: r, fast })
    }
}
