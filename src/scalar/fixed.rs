//! Integers of 64 or 128 bits, for what is known beforehand to fit.

use std::fmt::Debug;

use num_bigint::BigInt;
use num_traits::PrimInt;

use super::ring::{Ring, ScaleBy};

/// The primitive integers that a [`Fixed`] can have.
pub trait Width: PrimInt + Debug + Into<i128> + Into<BigInt> + TryFrom<i128> {
    /// The product, if it fits.
    fn product(self, rhs: Self) -> Option<Self>;
}

impl Width for i64 {
    #[inline]
    fn product(self, rhs: Self) -> Option<Self> {
        self.checked_mul(rhs)
    }
}

impl Width for i128 {
    #[inline]
    fn product(self, rhs: Self) -> Option<Self> {
        // Two factors of 64 bits, most often, are one machine instruction, and nothing to check.
        match (i64::try_from(self), i64::try_from(rhs)) {
            (Ok(a), Ok(b)) => Some(Self::from(a) * Self::from(b)),
            _ => self.checked_mul(rhs),
        }
    }
}

/// An integer of a fixed width: of 128 bits, or of 64, with its sign.
///
/// A ring only as long as all results fit: who computes with these numbers has proved before that they do. The
/// arithmetic is checked all the same, and stops the program instead of giving a wrong number.
///
/// ```
/// use knotproof::scalar::{Fixed, Ring};
///
/// let [three, four] = [3_i64, 4].map(Fixed::new);
/// assert_eq!(three.times(&four).plus(&three).value(), 15);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct Fixed<W = i128>(W);

impl<W: Width> Fixed<W> {
    /// From a primitive integer.
    #[must_use]
    #[inline]
    pub fn new(value: W) -> Self {
        Self(value)
    }

    /// As a primitive integer.
    #[must_use]
    #[inline]
    pub fn value(self) -> W {
        self.0
    }

    /// A value that is there, or the end.
    #[inline]
    fn known(value: Option<W>) -> Self {
        match value {
            Some(value) => Self(value),
            None => too_long(),
        }
    }
}

impl<W: Width> From<Fixed<W>> for BigInt {
    fn from(value: Fixed<W>) -> Self {
        value.0.into()
    }
}

impl<W: Width> Ring for Fixed<W> {
    fn certainly_negative(&self) -> bool {
        self.0 < W::zero()
    }
    fn zero(&self) -> Self {
        Self(W::zero())
    }
    fn one(&self) -> Self {
        Self(W::one())
    }
    #[inline]
    fn plus(&self, rhs: &Self) -> Self {
        Self::known(self.0.checked_add(&rhs.0))
    }
    #[inline]
    fn minus(&self, rhs: &Self) -> Self {
        Self::known(self.0.checked_sub(&rhs.0))
    }
    #[inline]
    fn times(&self, rhs: &Self) -> Self {
        Self::known(self.0.product(rhs.0))
    }
    fn negate(&self) -> Self {
        Self::known(W::zero().checked_sub(&self.0))
    }
    #[inline]
    fn is_zero(&self) -> bool {
        self.0 == W::zero()
    }
}

impl ScaleBy<u64> for Fixed {
    #[inline]
    fn scale_by<'a>(&mut self, factors: impl Iterator<Item = &'a u64>) {
        let product = |magnitude: u128, factor: &u64| match magnitude.checked_mul(u128::from(*factor)) {
            Some(product) => product,
            None => too_long(),
        };
        let magnitude = factors.fold(self.0.unsigned_abs(), product);
        match i128::try_from(magnitude) {
            Ok(magnitude) => self.0 = if self.0 < 0 { -magnitude } else { magnitude },
            Err(_) => too_long(),
        }
    }
}

#[cold]
fn too_long() -> ! {
    unreachable!("a number that does not fit, where it was proved to do so")
}
