//! The triangle in pairs of floats: about 106 bits on the way, so that the one rounding at the end is all there is.

use super::basis::{FloatBasis, HIGHEST_DEGREE, Ratio};
use super::machine::Kernel;
use super::pair::{Pair, Products};
use super::power::{exponent, power, shifted};
use super::real::Real;
use crate::spline::Span;

/// N pairs, each of its own point: what a wide machine works on at once.
#[derive(Debug, Clone, Copy)]
pub(super) struct Lanes<const N: usize> {
    hi: [f64; N],
    lo: [f64; N],
}

impl<const N: usize> Lanes<N> {
    const ZERO: Self = Self { hi: [0.0; N], lo: [0.0; N] };

    #[inline(always)]
    fn get(&self, lane: usize) -> Pair {
        Pair { hi: self.hi[lane], lo: self.lo[lane] }
    }

    #[inline(always)]
    fn set(&mut self, lane: usize, value: Pair) {
        (self.hi[lane], self.lo[lane]) = (value.hi, value.lo);
    }
}

/// The place that N points need for one run of the triangle; made once for many runs.
pub(super) struct Workspace<const N: usize> {
    /// p(x − t_{j+1−s}) at s − 1.
    rises: [Lanes<N>; HIGHEST_DEGREE],
    /// q(t_{j+w} − x) at w − 1.
    falls: [Lanes<N>; HIGHEST_DEGREE],
    /// G_{j−d}^d, …, G_j^d.
    values: [Lanes<N>; HIGHEST_DEGREE + 1],
}

impl<const N: usize> Workspace<N> {
    pub(super) fn new() -> Self {
        Self {
            rises: [Lanes::ZERO; HIGHEST_DEGREE],
            falls: [Lanes::ZERO; HIGHEST_DEGREE],
            values: [Lanes::ZERO; HIGHEST_DEGREE + 1],
        }
    }

    /// The k + 1 functions at N points, each with its 2k local knots; points and knots in the unit of the frame.
    #[inline(always)]
    pub(super) fn run<M: Products, F: Real>(&mut self, ratio: Ratio, x: &[F; N], knots: &[[F; N]]) {
        let degree = knots.len() / 2;
        for s in 1..=degree {
            let (start, end) = (&knots[degree - s], &knots[degree + s - 1]);
            let (mut rises, mut falls) = (Lanes::ZERO, Lanes::ZERO);
            for l in 0..N {
                let rise = Pair::difference(x[l].widen(), start[l].widen());
                rises.set(l, rise.times::<M>(Pair::of(ratio.p)));
                let fall = Pair::difference(end[l].widen(), x[l].widen());
                falls.set(l, fall.times::<M>(ratio.q));
            }
            (self.rises[s - 1], self.falls[s - 1]) = (rises, falls);
        }
        self.values[0] = Lanes { hi: [1.0; N], lo: [0.0; N] };
        for d in 1..=degree {
            // Each G_i^{d−1} is split in two: the part w goes to G_i^d, the part 1 − w to G_{i−1}^d.
            let mut own = Lanes::ZERO;
            for c in 0..d {
                let (rises, falls, mut values) = (self.rises[d - 1 - c], self.falls[c], self.values[c]);
                for l in 0..N {
                    let (w, complement) = Pair::shares::<M>(rises.get(l), falls.get(l));
                    let value = values.get(l);
                    values.set(l, own.get(l).plus_like(complement.times::<M>(value)));
                    own.set(l, w.times::<M>(value));
                }
                self.values[c] = values;
            }
            self.values[d] = own;
        }
    }

    /// Entry c of the result, rounded.
    #[inline(always)]
    pub(super) fn rounded<F: Real>(&self, c: usize, lane: usize) -> F {
        F::nearest(self.values[c].hi[lane])
    }
}

/// Makes positive what rounded to 0 and is not 0: a value of G_i inside its support.
///
/// G_{j−k} and G_j can have an end of their support at an end of the span, but where they do not vanish there they jump, and
/// are 1: so t_{j−k} and t_{j+k+1} need not be looked at.
#[inline(always)]
pub(super) fn lifted<F: Real>(value: F, above_start: bool, below_end: bool) -> F {
    if above_start && below_end && value < F::LEAST { F::LEAST } else { value }
}

/// The functions on the span at x, a point of the closed span, before they are rounded.
pub(super) fn unrounded<F: Real>(basis: &FloatBasis<F>, span: Span, x: F) -> [Pair; HIGHEST_DEGREE + 1] {
    let local = basis.local(span);
    match &basis.frame {
        Some(frame) => {
            let knots = &frame.knots[span.index() + 1..=span.index() + local.len()];
            basis.machine.run(InFrame { ratio: basis.ratio, knots, x: x * frame.unit })
        }
        None => basis.machine.run(FarApart { ratio: basis.ratio, knots: local, x }),
    }
}

/// The functions on the span at x, a point of the closed span.
pub(super) fn at_point<F: Real>(basis: &FloatBasis<F>, span: Span, x: F, values: &mut [F]) {
    let (degree, local) = (basis.degree(), basis.local(span));
    for (c, (value, pair)) in values.iter_mut().zip(unrounded(basis, span, x)).enumerate() {
        let (above, below) = (c == 0 || local[c - 1] < x, c == degree || x < local[degree + c]);
        *value = lifted(F::nearest(pair.hi), above, below);
    }
    basis.blank(Some(span), values);
}

/// One point, all differences in one unit.
struct InFrame<'a, F> {
    ratio: Ratio,
    knots: &'a [F],
    x: F,
}

impl<F: Real> Kernel for InFrame<'_, F> {
    type Output = [Pair; HIGHEST_DEGREE + 1];

    #[inline(always)]
    fn run<M: Products>(self) -> Self::Output {
        let mut knots = [[F::zero()]; 2 * HIGHEST_DEGREE];
        for (place, t) in knots.iter_mut().zip(self.knots) {
            *place = [*t];
        }
        let mut workspace = Workspace::<1>::new();
        workspace.run::<M, F>(self.ratio, &[self.x], &knots[..self.knots.len()]);
        workspace.values.map(|lanes| lanes.get(0))
    }
}

/// One point where the differences of knots, or p and q, are so far apart that no unit suits them all: every
/// difference has an exponent of its own.
struct FarApart<'a, F> {
    ratio: Ratio,
    knots: &'a [F],
    x: F,
}

/// pair·2^exponent, with the high part in [1, 4), or 0.
#[derive(Debug, Clone, Copy)]
pub(super) struct Scaled {
    pub(super) pair: Pair,
    pub(super) exponent: i32,
}

impl Scaled {
    pub(super) const ZERO: Self = Self { pair: Pair::ZERO, exponent: i32::MIN / 4 };

    fn of(pair: Pair, shift: i32) -> Self {
        if pair.hi <= 0.0 {
            return Self::ZERO;
        }
        let e = exponent(pair.hi);
        let pair = Pair { hi: shifted(pair.hi, -e), lo: shifted(pair.lo, -e) };
        Self { pair, exponent: e + shift }
    }

    /// a − b ≥ 0.
    pub(super) fn difference(a: f64, b: f64) -> Self {
        // A difference of the largest floats would overflow. What a tiny one loses by this is nothing beside them.
        let shift = if a.abs().max(b.abs()) > power(1000) { 2 } else { 0 };
        Self::of(Pair::difference(a * power(-shift), b * power(-shift)), shift)
    }

    /// The product of two.
    pub(super) fn times<M: Products>(self, rhs: Pair) -> Self {
        if self.pair.hi <= 0.0 {
            return self;
        }
        let rhs = Self::of(rhs, 0);
        Self { pair: self.pair.times::<M>(rhs.pair), exponent: self.exponent + rhs.exponent }
    }

    /// The two shares of the sum, in the unit of the larger one: what underflows then underflows as a share.
    fn shares<M: Products>(rise: Self, fall: Self) -> (Pair, Pair) {
        let unit = rise.exponent.max(fall.exponent);
        let inside = |term: Self| {
            let e = (term.exponent - unit).max(-2200);
            Pair { hi: shifted(term.pair.hi, e), lo: shifted(term.pair.lo, e) }
        };
        Pair::shares::<M>(inside(rise), inside(fall))
    }
}

impl<F: Real> Kernel for FarApart<'_, F> {
    type Output = [Pair; HIGHEST_DEGREE + 1];

    #[inline(always)]
    fn run<M: Products>(self) -> Self::Output {
        let degree = self.knots.len() / 2;
        let (x, knots) = (self.x.widen(), |i: usize| self.knots[i].widen());
        let rise = |s: usize| Scaled::difference(x, knots(degree - s)).times::<M>(Pair::of(self.ratio.p));
        let fall = |w: usize| Scaled::difference(knots(degree + w - 1), x).times::<M>(self.ratio.q);
        let mut values = [Pair::ZERO; HIGHEST_DEGREE + 1];
        values[0] = Pair::ONE;
        for d in 1..=degree {
            let mut own = Pair::ZERO;
            for c in 0..d {
                let (w, complement) = Scaled::shares::<M>(rise(d - c), fall(c + 1));
                let value = values[c];
                values[c] = own.plus_like(complement.times::<M>(value));
                own = w.times::<M>(value);
            }
            values[d] = own;
        }
        values
    }
}
