//! Differences that are too far apart for one exponent range: each has an exponent of its own.

use super::pair::Pair;
use super::power::{exponent, power, shifted};
use super::vectors::Vectors;

/// pair·2^exponent, with the high part in [1, 4), or 0.
#[derive(Debug, Clone, Copy)]
pub(super) struct Scaled {
    pair: Pair,
    exponent: i32,
}

impl Scaled {
    const ZERO: Self = Self { pair: Pair::ZERO, exponent: i32::MIN / 4 };

    fn of(pair: Pair, shift: i32) -> Self {
        if pair.hi <= 0.0 {
            return Self::ZERO;
        }
        let e = exponent(pair.hi);
        let pair = Pair { hi: shifted(pair.hi, -e), lo: shifted(pair.lo, -e) };
        Self { pair, exponent: e + shift }
    }

    /// a − b ≥ 0.
    pub(super) fn difference(m: impl Vectors<Vector = f64>, a: f64, b: f64) -> Self {
        // A difference of the largest floats would overflow. What a tiny one loses by this is nothing beside them.
        let shift = if a.abs().max(b.abs()) > power(1000) { 2 } else { 0 };
        Self::of(Pair::difference(m, a * power(-shift), b * power(-shift)), shift)
    }

    /// The product of two.
    pub(super) fn times(self, m: impl Vectors<Vector = f64>, rhs: Pair) -> Self {
        if self.pair.hi <= 0.0 {
            return self;
        }
        let rhs = Self::of(rhs, 0);
        Self { pair: self.pair.times(m, rhs.pair), exponent: self.exponent + rhs.exponent }
    }

    /// Both in the unit of the larger one: what underflows then underflows as a share of their sum.
    pub(super) fn in_one_unit(rise: Self, fall: Self) -> (Pair, Pair) {
        let unit = rise.exponent.max(fall.exponent);
        let inside = |term: Self| {
            let e = (term.exponent - unit).max(-2200);
            Pair { hi: shifted(term.pair.hi, e), lo: shifted(term.pair.lo, e) }
        };
        (inside(rise), inside(fall))
    }
}
