//! Integers, of a fixed width or of any: what both can do beyond a ring.

use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{One, Signed};

use super::fixed::Fixed;
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

impl Whole for Fixed {
    fn divided(&self, divisor: &Self) -> Self {
        match (i64::try_from(self.value()), i64::try_from(divisor.value())) {
            (Ok(a), Ok(b)) => Self::new((a / b).into()),
            _ => Self::new(self.value() / divisor.value()),
        }
    }
    fn common_divisor(&self, rhs: &Self) -> Self {
        match (i64::try_from(self.value()), i64::try_from(rhs.value())) {
            (Ok(a), Ok(b)) => Self::new(a.gcd(&b).into()),
            _ => Self::new(self.value().gcd(&rhs.value())),
        }
    }
    fn residue(&self) -> u64 {
        match u64::try_from(self.value()) {
            Ok(small) if small >> 61 == 0 => small,
            _ => residue(&self.value().into()),
        }
    }
    fn is_unit(&self) -> bool {
        self.value() == 1
    }
}
