//! The triangle in pairs of floats at several points at once.

use super::basis::Ratio;
use super::error::HIGHEST_DEGREE;
use super::pair::{Pair, Products};
use super::real::Real;

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
