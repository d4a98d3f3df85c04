//! `f64` as a scalar: what a CAD program would compute with. A field up to rounding, and never an exact one.

use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive};

use super::rational::rational;
use super::ring::{Field, OrderedField, RationalAlgebra, Ring};

impl Ring for f64 {
    fn certainly_negative(&self) -> bool {
        *self < 0.0
    }
    fn zero(&self) -> Self {
        0.0
    }
    fn one(&self) -> Self {
        1.0
    }
    fn plus(&self, rhs: &Self) -> Self {
        self + rhs
    }
    fn minus(&self, rhs: &Self) -> Self {
        self - rhs
    }
    fn times(&self, rhs: &Self) -> Self {
        self * rhs
    }
    fn negate(&self) -> Self {
        -self
    }
}

impl RationalAlgebra for f64 {
    /// Of the interval with rounded ends.
    fn lies_outside(&self, low: &BigRational, high: &BigRational) -> bool {
        !(self.embed(low)..=self.embed(high)).contains(self)
    }
    /// The nearest `f64`, ties to even; ±∞ beyond its range.
    fn embed(&self, value: &BigRational) -> Self {
        // `to_f64` of a rational is always `Some`: it saturates.
        value.to_f64().unwrap_or(f64::NAN)
    }
    fn reciprocal(&self) -> Option<Self> {
        (*self != 0.0).then(|| 1.0 / self)
    }
    /// One rounding, where the product with the reciprocal would take two.
    fn over(&self, rhs: &Self) -> Option<Self> {
        (*rhs != 0.0).then(|| self / rhs)
    }
    /// Two divisions, for the same reason.
    fn shares(&self, rhs: &Self) -> Option<(Self, Self)> {
        let sum = self + rhs;
        Some((self.over(&sum)?, rhs.over(&sum)?))
    }
}

impl Field for f64 {}
impl OrderedField for f64 {}

/// The unit in the last place of `f64` at an exact value: 2^(e−52) for 2^e ≤ |value| < 2^(e+1), and never
/// less than the least positive float 2^−1074.
///
/// ```
/// # use knotproof::scalar::{rational, ulp};
/// assert_eq!(ulp(&rational(1, 1)), rational(1, 1 << 52));
/// ```
#[must_use]
pub fn ulp(value: &BigRational) -> BigRational {
    const LEAST: i32 = -1074;
    let two = || rational(2, 1);
    if value.is_zero() {
        return num_traits::Pow::pow(two(), LEAST);
    }
    // The bit lengths give the binary exponent up to one, which the comparison settles.
    let bits = |n: &num_bigint::BigInt| i64::try_from(n.bits()).unwrap_or(i64::MAX);
    let mut exponent = bits(value.numer()) - bits(value.denom());
    let power = |e: i64| -> BigRational { num_traits::Pow::pow(two(), i32::try_from(e).unwrap_or(i32::MAX)) };
    if value.abs() < power(exponent) {
        exponent -= 1;
    }
    power((exponent - 52).max(LEAST.into()))
}

/// The exact value of a finite float; `None` for infinities and NaN.
#[must_use]
pub fn exact_value(float: f64) -> Option<BigRational> {
    BigRational::from_float(float)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn embedding_rounds_to_nearest() {
        // Each value against its two neighbours, compared exactly.
        for (p, q) in [(1, 3), (2, 5), (-7, 11), (1, 1_000_003), (9_007_199_254_740_993, 1), (i64::MAX, 3)] {
            let exact = rational(p, q);
            let float = 0.0_f64.embed(&exact);
            let distance = |f: f64| (exact_value(f).unwrap() - &exact).abs();
            assert!(distance(float) <= distance(float.next_up()), "{exact}");
            assert!(distance(float) <= distance(float.next_down()), "{exact}");
        }
    }

    #[test]
    fn the_ulp_is_the_gap_to_the_next_float() {
        for float in [1.0, 1.5, 2.0, 0.1, 1e-300, 5e-324, 1e300] {
            let gap = exact_value(f64::next_up(float)).unwrap() - exact_value(float).unwrap();
            assert_eq!(ulp(&exact_value(float).unwrap()), gap, "{float:e}");
            assert_eq!(ulp(&exact_value(-float).unwrap()), gap, "-{float:e}");
        }
    }
}
