//! Integers, of a fixed width or of any: what both can do beyond a ring.

use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{One, Signed};

use super::fixed::{Fixed, Width};
use super::gcd::gcd;
use super::modular::residue;
use super::ring::Ring;

/// A ring of integers.
pub(crate) trait Whole: Ring + Into<BigInt> {
    /// self/divisor rounded towards 0, for a divisor ≠ 0: exact if it divides.
    fn divided(&self, divisor: &Self) -> Self;
    /// self/divisor, if it divides.
    fn quotient(&self, divisor: &Self) -> Option<Self> {
        let quotient = self.divided(divisor);
        (quotient.times(divisor) == *self).then_some(quotient)
    }
    /// The greatest common divisor ≥ 0.
    fn common_divisor(&self, rhs: &Self) -> Self;
    /// Modulo the prime of [`may_vanish`](super::may_vanish).
    fn residue(&self) -> u64;
    /// Is this 1?
    fn is_unit(&self) -> bool;
}

impl Whole for BigInt {
    fn divided(&self, divisor: &Self) -> Self {
        self / divisor
    }
    fn common_divisor(&self, rhs: &Self) -> Self {
        gcd(self, rhs).abs()
    }
    fn residue(&self) -> u64 {
        residue(self)
    }
    fn is_unit(&self) -> bool {
        self.is_one()
    }
}

impl<W: Width> Whole for Fixed<W> {
    fn divided(&self, divisor: &Self) -> Self {
        let (dividend, divisor): (i128, i128) = (self.value().into(), divisor.value().into());
        let quotient = match (i64::try_from(dividend), i64::try_from(divisor)) {
            (Ok(a), Ok(b)) if b != -1 => i128::from(a / b),
            _ => dividend / divisor,
        };
        match W::try_from(quotient) {
            Ok(quotient) => Self::new(quotient),
            Err(_) => unreachable!("a quotient is no larger than the dividend"),
        }
    }
    fn common_divisor(&self, rhs: &Self) -> Self {
        let (a, b): (i128, i128) = (self.value().into(), rhs.value().into());
        let common = match (i64::try_from(a), i64::try_from(b)) {
            (Ok(a), Ok(b)) => i128::from(a.gcd(&b)),
            _ => a.gcd(&b),
        };
        match W::try_from(common) {
            Ok(common) => Self::new(common),
            Err(_) => unreachable!("a divisor is no larger than the number"),
        }
    }
    fn residue(&self) -> u64 {
        let value: i128 = self.value().into();
        match u64::try_from(value) {
            Ok(small) if small >> 61 == 0 => small,
            _ => residue(&(*self).into()),
        }
    }
    fn is_unit(&self) -> bool {
        self.value() == W::one()
    }
}
