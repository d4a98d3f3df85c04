//! Integers of 128 bits, for what is known beforehand to fit.

use num_bigint::BigInt;

use super::ring::{Ring, ScaleBy};

/// An integer between −2^127 and 2^127 − 1.
///
/// A ring only as long as all results are in that range: who computes with these numbers has proved before that they
/// are. The arithmetic is checked all the same, and stops the program instead of giving a wrong number.
///
/// ```
/// use knotproof::scalar::{Fixed, Ring};
///
/// let [three, four] = [3, 4].map(Fixed::new);
/// assert_eq!(three.times(&four).plus(&three).value(), 15);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct Fixed(i128);

impl Fixed {
    /// The largest one: 2^127 − 1.
    pub const MAX: u128 = i128::MAX as u128;

    /// From a primitive integer.
    #[must_use]
    #[inline]
    pub fn new(value: i128) -> Self {
        Self(value)
    }

    /// As a primitive integer.
    #[must_use]
    #[inline]
    pub fn value(self) -> i128 {
        self.0
    }
}

impl TryFrom<&BigInt> for Fixed {
    type Error = num_bigint::TryFromBigIntError<()>;

    fn try_from(value: &BigInt) -> Result<Self, Self::Error> {
        i128::try_from(value).map(Self)
    }
}

impl From<Fixed> for BigInt {
    fn from(value: Fixed) -> Self {
        value.0.into()
    }
}

impl Ring for Fixed {
    fn zero(&self) -> Self {
        Self(0)
    }
    fn one(&self) -> Self {
        Self(1)
    }
    #[inline]
    fn plus(&self, rhs: &Self) -> Self {
        Self(self.0 + rhs.0)
    }
    fn minus(&self, rhs: &Self) -> Self {
        Self(self.0 - rhs.0)
    }
    #[inline]
    fn times(&self, rhs: &Self) -> Self {
        // Two factors of 64 bits, most often, are one machine instruction, and nothing to check.
        match (i64::try_from(self.0), i64::try_from(rhs.0)) {
            (Ok(a), Ok(b)) => Self(i128::from(a) * i128::from(b)),
            _ => Self(self.0 * rhs.0),
        }
    }
    fn negate(&self) -> Self {
        Self(-self.0)
    }
    fn is_zero(&self) -> bool {
        self.0 == 0
    }
}

impl ScaleBy<u64> for Fixed {
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
    unreachable!("a product of more than 127 bits, where it was proved to have no more")
}
