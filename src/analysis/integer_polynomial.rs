//! Polynomials with integer coefficients: where root isolation spends its time.

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive, Zero};

use crate::scalar::Polynomial;

use super::sign::Sign;

/// c₀ + c₁u + … + c_n uⁿ, c_n ≠ 0, with coprime integer coefficients; no coefficient at all for 0.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct IntegerPolynomial {
    coefficients: Vec<BigInt>,
}

/// 2⁶¹ − 1, a prime below which products fit into `u128`.
const PRIME: u64 = (1 << 61) - 1;

impl IntegerPolynomial {
    /// The positive multiple of p with coprime integer coefficients: the same sign everywhere.
    pub(super) fn from_rational(p: &Polynomial<BigRational>) -> Self {
        let common = p.coefficients().iter().fold(BigInt::one(), |lcm, c| lcm.lcm(c.denom()));
        Self::primitive(p.coefficients().iter().map(|c| c.numer() * (&common / c.denom())).collect())
    }

    /// The positive multiple with coprime coefficients of a polynomial that is in integers already.
    pub(super) fn from_integer(p: &Polynomial<BigInt>) -> Self {
        Self::primitive(p.coefficients().to_vec())
    }

    /// Drops leading zeros and divides by the (positive) content.
    pub(super) fn primitive(mut coefficients: Vec<BigInt>) -> Self {
        while coefficients.last().is_some_and(Zero::is_zero) {
            coefficients.pop();
        }
        let mut content = BigInt::zero();
        for c in coefficients.iter().rev() {
            content = content.gcd(c);
            if content.is_one() {
                return Self { coefficients };
            }
        }
        for c in &mut coefficients {
            *c /= &content;
        }
        Self { coefficients }
    }

    pub(super) fn coefficients(&self) -> &[BigInt] {
        &self.coefficients
    }

    pub(super) fn is_zero(&self) -> bool {
        self.coefficients.is_empty()
    }

    /// The quotient by the highest power of u that divides it: no root at 0.
    pub(super) fn without_root_at_zero(mut self) -> Self {
        let order = self.coefficients.iter().take_while(|c| c.is_zero()).count();
        self.coefficients.drain(..order);
        self
    }

    /// The sign at u = a/d for d > 0, and that of the leading coefficient for (a, d) = (1, 0), that is u = ∞:
    /// the sign of Σ c_i a^i d^(n−i), by Horner's rule.
    pub(super) fn sign_at(&self, a: &BigInt, d: &BigInt) -> Sign {
        let mut value = BigInt::zero();
        let mut power = BigInt::one();
        for c in self.coefficients.iter().rev() {
            value = value * a + c * &power;
            power *= d;
        }
        Sign::of(&value)
    }

    /// The number of sign changes in the list of coefficients, zeros left out (Descartes).
    pub(super) fn variations(coefficients: &[BigInt]) -> usize {
        let signs = coefficients.iter().filter(|c| !c.is_zero()).map(Signed::is_negative);
        let signs: Vec<bool> = signs.collect();
        signs.windows(2).filter(|pair| pair[0] != pair[1]).count()
    }

    fn derivative(&self) -> Self {
        let terms = self.coefficients.iter().enumerate().skip(1);
        Self::primitive(terms.map(|(i, c)| c * BigInt::from(i)).collect())
    }

    /// The primitive remainder of a positive or negative multiple of `self` on division by `divisor` ≠ 0.
    fn pseudo_remainder(&self, divisor: &Self) -> Self {
        let mut remainder = self.coefficients.clone();
        let Some((leading, lower)) = divisor.coefficients.split_last() else { return self.clone() };
        while remainder.len() > lower.len() {
            let Some(top) = remainder.pop() else { break };
            let common = top.gcd(leading);
            let (factor, multiple) = (&top / &common, leading / &common);
            let shift = remainder.len() - lower.len();
            for (i, c) in remainder.iter_mut().enumerate() {
                *c *= &multiple;
                if let Some(d) = i.checked_sub(shift).and_then(|i| lower.get(i)) {
                    *c -= &factor * d;
                }
            }
        }
        Self::primitive(remainder)
    }

    /// The primitive greatest common divisor with positive leading coefficient; 0 only for two zeros.
    ///
    /// Euclid's algorithm on primitive parts (Knuth, The Art of Computer Programming 2, 4.6.1 E).
    pub(super) fn gcd(&self, rhs: &Self) -> Self {
        let (mut a, mut b) = (self.clone(), rhs.clone());
        while !b.is_zero() {
            (a, b) = (b.clone(), a.pseudo_remainder(&b));
        }
        if a.coefficients.last().is_some_and(Signed::is_negative) {
            for c in &mut a.coefficients {
                *c = -std::mem::take(c);
            }
        }
        a
    }

    /// self/divisor, for a primitive divisor of it: the quotient is integer, by Gauss's lemma.
    fn exact_quotient(&self, divisor: &Self) -> Self {
        let mut remainder = self.coefficients.clone();
        let mut quotient = Vec::new();
        let Some((leading, lower)) = divisor.coefficients.split_last() else { return self.clone() };
        while remainder.len() > lower.len() {
            let Some(top) = remainder.pop() else { break };
            let factor = top / leading;
            let shift = remainder.len() - lower.len();
            for (i, d) in lower.iter().enumerate() {
                remainder[shift + i] -= &factor * d;
            }
            quotient.push(factor);
        }
        quotient.reverse();
        Self::primitive(quotient)
    }

    /// p/gcd(p, p′): the same roots, each simple.
    pub(super) fn square_free(self) -> Self {
        if self.is_square_free_modulo_prime() {
            return self;
        }
        let repeated = self.gcd(&self.derivative());
        if repeated.coefficients.len() <= 1 { self } else { self.exact_quotient(&repeated) }
    }

    /// A quick sufficient test: if p keeps its degree modulo a prime and has no repeated factor there, it has
    /// none over the integers, since such a factor would survive the reduction.
    fn is_square_free_modulo_prime(&self) -> bool {
        let reduce = |c: &BigInt| c.mod_floor(&PRIME.into()).to_u64().unwrap_or(0);
        let mut a: Vec<u64> = self.coefficients.iter().map(reduce).collect();
        if a.last().is_none_or(|&leading| leading == 0) {
            return false;
        }
        let mut b: Vec<u64> = (0..PRIME).zip(&a).skip(1).map(|(i, &c)| modular_product(i, c)).collect();
        while let Some(leading) = strip(&mut b) {
            let inverse = modular_power(leading, PRIME - 2);
            while a.len() >= b.len() {
                let Some(&top) = a.last() else { break };
                let factor = PRIME - modular_product(top, inverse);
                let shift = a.len() - b.len();
                for (i, &c) in b.iter().enumerate() {
                    a[shift + i] = (a[shift + i] + modular_product(factor, c)) % PRIME;
                }
                a.pop();
            }
            std::mem::swap(&mut a, &mut b);
        }
        a.len() == 1
    }
}

/// Drops leading zeros; the leading coefficient, if any is left.
fn strip(coefficients: &mut Vec<u64>) -> Option<u64> {
    while coefficients.last() == Some(&0) {
        coefficients.pop();
    }
    coefficients.last().copied()
}

fn modular_product(a: u64, b: u64) -> u64 {
    let product = u128::from(a) * u128::from(b) % u128::from(PRIME);
    match u64::try_from(product) {
        Ok(reduced) => reduced,
        Err(_) => unreachable!("a remainder modulo a prime below 2^64"),
    }
}

fn modular_power(mut base: u64, mut exponent: u64) -> u64 {
    let mut result = 1;
    while exponent > 0 {
        if exponent % 2 == 1 {
            result = modular_product(result, base);
        }
        base = modular_product(base, base);
        exponent /= 2;
    }
    result
}

#[cfg(test)]
mod tests {
    use super::*;

    fn polynomial(coefficients: &[i64]) -> IntegerPolynomial {
        IntegerPolynomial::primitive(coefficients.iter().map(|&c| c.into()).collect())
    }

    #[test]
    fn square_free_parts_lose_the_multiplicities_only() {
        // (u − 1)²(u + 2) and (u − 1)(u + 2).
        assert_eq!(polynomial(&[2, -3, 0, 1]).square_free(), polynomial(&[-2, 1, 1]));
        assert_eq!(polynomial(&[-2, 1, 1]).square_free(), polynomial(&[-2, 1, 1]));
        // Modulo 2⁶¹ − 1 this is u², with a double root; over the integers it is not.
        let tricky = IntegerPolynomial::primitive(vec![-BigInt::from(PRIME), BigInt::zero(), BigInt::one()]);
        assert!(!tricky.is_square_free_modulo_prime());
        assert_eq!(tricky.clone().square_free(), tricky);
        assert_eq!(polynomial(&[7]).square_free(), polynomial(&[1]));
        assert_eq!(polynomial(&[0, 0, 3]).square_free(), polynomial(&[0, 1]));
    }

    #[test]
    fn greatest_common_divisors() {
        // (2u + 1)(u − 3) and (2u + 1)(u + 5).
        let (p, q) = (polynomial(&[-3, -5, 2]), polynomial(&[5, 11, 2]));
        assert_eq!(p.gcd(&q), polynomial(&[1, 2]));
        assert_eq!(p.gcd(&polynomial(&[])), p);
        assert!(polynomial(&[]).gcd(&polynomial(&[0])).is_zero());
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
