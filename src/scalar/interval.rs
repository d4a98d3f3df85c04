//! Intervals of floats that contain the exact value: what decides quickly, and knows when it does not.

use std::cmp::Ordering;

use num_bigint::{BigInt, BigUint, Sign};
use num_rational::BigRational;
use num_traits::ToPrimitive;

use super::ring::Ring;

/// A closed interval [lo, hi] of real numbers between two floats, possibly −∞ and ∞; never empty, never NaN.
///
/// Every operation returns an interval that contains the exact result for all elements of its operands
/// (inclusion). Its ends are computed by rounding to nearest and then moved outwards by one or two units in the last
/// place, so no rounding mode is changed; beyond the range of `f64` they are infinite or the largest float. What is known of the sign
/// of an interval is therefore true of the number that it stands for:
///
/// ```
/// use knotproof::scalar::{Interval, Ring, rational};
/// use std::cmp::Ordering;
///
/// let third = Interval::from(&rational(1, 3));
/// let difference = third.times(&Interval::from(3_u64)).minus(&Interval::from(1_u64));
/// assert_eq!(difference.sign(), None);
/// assert_eq!(difference.plus(&third).sign(), Some(Ordering::Greater));
/// ```
///
/// It is a [`Ring`] up to rounding only: `==` compares the ends, and a − a is not 0 but an interval around it. So
/// it is no [`ExactField`](super::ExactField), and no verdict can be computed with it alone:
///
/// ```compile_fail,E0277
/// fn decide<S: knotproof::scalar::ExactField>(_: S) {}
/// decide(knotproof::scalar::Interval::from(1_u64));
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Interval {
    lo: f64,
    hi: f64,
}

/// Integers up to here are floats.
const EXACT_BITS: u64 = 53;

impl Interval {
    const ZERO: Self = Self { lo: 0.0, hi: 0.0 };

    /// [lo, hi], if that contains a real number: lo ≤ hi, lo < ∞, −∞ < hi, and neither is NaN.
    #[must_use]
    pub fn new(lo: f64, hi: f64) -> Option<Self> {
        (lo <= hi && lo < f64::INFINITY && f64::NEG_INFINITY < hi).then_some(Self { lo, hi })
    }

    /// The lower end.
    #[must_use]
    pub fn lo(&self) -> f64 {
        self.lo
    }

    /// The upper end.
    #[must_use]
    pub fn hi(&self) -> f64 {
        self.hi
    }

    /// The sign of every element, as its comparison with 0; `None` if they have more than one.
    ///
    /// `Equal` is exact: it means [0, 0].
    #[must_use]
    pub fn sign(&self) -> Option<Ordering> {
        if self.lo > 0.0 {
            Some(Ordering::Greater)
        } else if self.hi < 0.0 {
            Some(Ordering::Less)
        } else {
            self.is_zero().then_some(Ordering::Equal)
        }
    }

    /// Around a result that was rounded to nearest at both ends: each moves outwards by 2⁻⁵² of itself and 2⁻¹⁰²².
    ///
    /// For a normal float x, |x|·2⁻⁵² is at least one unit in its last place, and less than two; for a subnormal
    /// one, 2⁻¹⁰²² is. So x without this margin, rounded, is at most the float below x, which is below the exact
    /// value. That is cheaper than to ask for the neighbour: there is nothing to branch on. An end that has
    /// overflowed inwards is first the largest float, which the exact value exceeds.
    #[inline]
    fn around(lo: f64, hi: f64) -> Self {
        let margin = |x: f64| x.abs() * f64::EPSILON + f64::MIN_POSITIVE;
        let (lo, hi) = (lo.min(f64::MAX), hi.max(f64::MIN));
        Self { lo: lo - margin(lo), hi: hi + margin(hi) }
    }

    /// The interval of a natural number: its first 53 bits, and one more in the last of them.
    fn of_magnitude(value: &BigUint) -> Self {
        let shift = value.bits().saturating_sub(EXACT_BITS);
        // Fits by the choice of the shift.
        let leading = |value: &BigUint| value.to_u64().map_or(f64::MAX, |bits| bits as f64);
        if shift == 0 {
            let point = leading(value);
            return Self { lo: point, hi: point };
        }
        // 2^shift, whose exponent is stored with 1023 added to it; ∞ from 2^1024 on.
        let scale = f64::from_bits((shift + 1023).min(2047) << 52);
        let leading = leading(&(value >> shift));
        // A product with a power of two is exact, unless it is ∞.
        Self { lo: (leading * scale).min(f64::MAX), hi: (leading + 1.0) * scale }
    }
}

impl From<u64> for Interval {
    /// A point up to 2⁵³; beyond, around the nearest float.
    fn from(value: u64) -> Self {
        let nearest = value as f64;
        if value <= 1 << EXACT_BITS {
            Self { lo: nearest, hi: nearest }
        } else {
            Self::around(nearest, nearest)
        }
    }
}

impl From<i64> for Interval {
    /// A point up to ±2⁵³; beyond, around the nearest float.
    fn from(value: i64) -> Self {
        let magnitude = Self::from(value.unsigned_abs());
        if value < 0 { magnitude.negate() } else { magnitude }
    }
}

impl From<&BigInt> for Interval {
    /// A point up to ±2⁵³; beyond, 53 bits and the next number of 53 bits.
    fn from(value: &BigInt) -> Self {
        let magnitude = Self::of_magnitude(value.magnitude());
        if value.sign() == Sign::Minus { magnitude.negate() } else { magnitude }
    }
}

impl From<&BigRational> for Interval {
    /// The quotient of the intervals of numerator and denominator: wide if one of them is no float.
    fn from(value: &BigRational) -> Self {
        let [numer, denom] = [value.numer(), value.denom()].map(|n| Self::of_magnitude(n.magnitude()));
        // The denominator is ≥ 1, and no lower end is ∞: no 0/0, no ∞/∞.
        let magnitude = if value.denom().magnitude() == &BigUint::from(1_u8) || numer.is_zero() {
            numer
        } else {
            let outward = Self::around(numer.lo / denom.hi, numer.hi / denom.lo);
            Self { lo: outward.lo.max(0.0), ..outward }
        };
        if value.numer().sign() == Sign::Minus { magnitude.negate() } else { magnitude }
    }
}

impl Ring for Interval {
    fn certainly_negative(&self) -> bool {
        self.hi < 0.0
    }
    /// [0, 0].
    #[inline]
    fn zero(&self) -> Self {
        Self::ZERO
    }
    /// [1, 1].
    fn one(&self) -> Self {
        Self { lo: 1.0, hi: 1.0 }
    }
    /// Contains a + b for all a in self and b in rhs. Adding 0 is exact.
    #[inline]
    fn plus(&self, rhs: &Self) -> Self {
        if self.is_zero() {
            return *rhs;
        }
        if rhs.is_zero() {
            return *self;
        }
        // No lower end is ∞ and no upper end is −∞: there is no ∞ − ∞.
        Self::around(self.lo + rhs.lo, self.hi + rhs.hi)
    }
    /// Contains a·b for all a in self and b in rhs. The product with 0 is 0, and what is ≥ 0 stays so.
    fn times(&self, rhs: &Self) -> Self {
        if self.lo >= 0.0 && rhs.lo >= 0.0 {
            if self.hi == 0.0 || rhs.hi == 0.0 {
                return Self::ZERO;
            }
            // Lower ends are finite and upper ends not 0: there is no 0·∞.
            let outward = Self::around(self.lo * rhs.lo, self.hi * rhs.hi);
            return Self { lo: outward.lo.max(0.0), ..outward };
        }
        if self.is_zero() || rhs.is_zero() {
            return Self::ZERO;
        }
        // The extremes are products of ends. 0·∞ is NaN, which `min` and `max` pass over; it stands for 0, which
        // is then also the product of that 0 with the other end, unless the other operand is (−∞, ∞) and the
        // result all of it, by the end that is not 0.
        let of_lo = [self.lo * rhs.lo, self.lo * rhs.hi];
        let of_hi = [self.hi * rhs.lo, self.hi * rhs.hi];
        Self::around(
            of_lo[0].min(of_lo[1]).min(of_hi[0].min(of_hi[1])),
            of_lo[0].max(of_lo[1]).max(of_hi[0].max(of_hi[1])),
        )
    }
    /// Exact.
    #[inline]
    fn negate(&self) -> Self {
        Self { lo: -self.hi, hi: -self.lo }
    }
    /// Is it [0, 0], so that the number it stands for is 0?
    #[inline]
    fn is_zero(&self) -> bool {
        self.lo == 0.0 && self.hi == 0.0
    }
}
