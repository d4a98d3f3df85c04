//! Integers of any size as a ring: what fraction-free computation runs over.

use num_bigint::BigInt;
use num_traits::{One, Zero};

use super::ring::{Ring, ScaleBy};
use super::words::Words;

impl Ring for BigInt {
    fn certainly_negative(&self) -> bool {
        num_traits::Signed::is_negative(self)
    }
    fn zero(&self) -> Self {
        Zero::zero()
    }
    fn one(&self) -> Self {
        One::one()
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
    fn increase(&mut self, rhs: &Self) {
        *self += rhs;
    }
    fn combine(&mut self, a: &Self, other: &Self, b: &Self) {
        *self *= a;
        *self += other * b;
    }
    fn is_zero(&self) -> bool {
        Zero::is_zero(self)
    }
}

impl ScaleBy<u64> for BigInt {
    fn scale_by<'a>(&mut self, factors: impl Iterator<Item = &'a u64>) {
        for word in Words::of(factors.copied()) {
            *self *= word;
        }
    }
}

impl ScaleBy<BigInt> for BigInt {
    fn scale_by<'a>(&mut self, factors: impl Iterator<Item = &'a BigInt>) {
        for factor in factors {
            *self *= factor;
        }
    }
}
