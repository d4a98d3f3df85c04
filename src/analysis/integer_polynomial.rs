//! The sign of an integer polynomial: where root isolation spends its time.

use num_bigint::BigInt;
use num_traits::{One, Zero};

pub(super) use crate::scalar::IntegerPolynomial;

use super::sign::Sign;

impl IntegerPolynomial {
    /// The sign at u = a/d for d > 0, and that of the leading coefficient for (a, d) = (1, 0), that is u = ∞:
    /// the sign of Σ c_i a^i d^(n−i), by Horner's rule.
    pub(super) fn sign_at(&self, a: &BigInt, d: &BigInt) -> Sign {
        let mut value = BigInt::zero();
        let mut power = BigInt::one();
        for c in self.coefficients().iter().rev() {
            value = value * a + c * &power;
            power *= d;
        }
        Sign::of(&value)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn polynomial(coefficients: &[i64]) -> IntegerPolynomial {
        IntegerPolynomial::primitive(coefficients.iter().map(|&c| c.into()).collect())
    }

    #[test]
    fn signs_at_fractions_and_at_infinity() {
        let p = polynomial(&[-2, 0, 1]);
        let at = |a: i64, d: i64| p.sign_at(&a.into(), &d.into());
        assert_eq!(
            (at(7, 5), at(3, 2), at(1, 0), at(0, 1)),
            (Sign::Negative, Sign::Positive, Sign::Positive, Sign::Negative)
        );
    }
}
