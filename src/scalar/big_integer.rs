//! Integers of any size as a ring: what fraction-free computation runs over.

use num_bigint::BigInt;
use num_traits::{One, Zero};

use super::ring::Ring;

impl Ring for BigInt {
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
    fn is_zero(&self) -> bool {
        Zero::is_zero(self)
    }
}
