//! Polynomials with coprime integer coefficients, unique up to their sign: what polynomials over the rational numbers are
//! multiples of.

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

use super::fraction::over_one_denominator;
use super::gcd::gcd;
use super::modular::{ModularPolynomial, SMALL_PRIMES, has_no_root};
use super::polynomial::Polynomial;

/// c₀ + c₁u + … + c_n uⁿ, c_n ≠ 0, with coprime integer coefficients; no coefficient at all for 0.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct IntegerPolynomial {
    coefficients: Vec<BigInt>,
}

impl IntegerPolynomial {
    /// The positive multiple of p with coprime integer coefficients: the same sign everywhere.
    pub(crate) fn from_rational(p: &Polynomial<BigRational>) -> Self {
        Self::primitive(over_one_denominator(p.coefficients()).0)
    }

    /// The positive multiple with coprime coefficients of a polynomial that is in integers already.
    pub(crate) fn from_integer(p: &Polynomial<BigInt>) -> Self {
        Self::primitive(p.coefficients().to_vec())
    }

    /// Drops leading zeros and divides by the (positive) content.
    pub(crate) fn primitive(mut coefficients: Vec<BigInt>) -> Self {
        while coefficients.last().is_some_and(Zero::is_zero) {
            coefficients.pop();
        }
        let mut content = BigInt::zero();
        for c in coefficients.iter().rev() {
            content = gcd(&content, c);
            if content.is_one() {
                return Self { coefficients };
            }
        }
        for c in &mut coefficients {
            *c /= &content;
        }
        Self { coefficients }
    }

    pub(crate) fn coefficients(&self) -> &[BigInt] {
        &self.coefficients
    }

    pub(crate) fn into_coefficients(self) -> Vec<BigInt> {
        self.coefficients
    }

    pub(crate) fn is_zero(&self) -> bool {
        self.coefficients.is_empty()
    }

    /// The quotient by the highest power of u that divides it: no root at 0.
    pub(crate) fn without_root_at_zero(mut self) -> Self {
        let order = self.coefficients.iter().take_while(|c| c.is_zero()).count();
        self.coefficients.drain(..order);
        self
    }

    /// Could it have a rational root? Not if it has none modulo one of a few small primes.
    pub(crate) fn may_have_rational_root(&self) -> bool {
        !SMALL_PRIMES.iter().any(|&prime| has_no_root(&self.coefficients, prime))
    }

    fn derivative(&self) -> Self {
        let terms = self.coefficients.iter().enumerate().skip(1);
        Self::primitive(terms.map(|(i, c)| c * BigInt::from(i)).collect())
    }

    /// Of the two numbers ±self, the one with a positive leading coefficient.
    fn with_positive_leading(mut self) -> Self {
        if self.coefficients.last().is_some_and(Signed::is_negative) {
            for c in &mut self.coefficients {
                *c = -std::mem::take(c);
            }
        }
        self
    }

    /// The primitive greatest common divisor with positive leading coefficient; 0 only for two zeros.
    ///
    /// Modulo a prime its degree is bounded at once: most have none, and where the bound is that of the shorter
    /// polynomial, it is tried as a divisor. Otherwise by Euclid's algorithm on primitive parts (Knuth, The Art of
    /// Computer Programming 2, 4.6.1 E).
    pub(crate) fn gcd(&self, rhs: &Self) -> Self {
        let (long, short) =
            if self.coefficients.len() < rhs.coefficients.len() { (rhs, self) } else { (self, rhs) };
        if short.is_zero() {
            return long.clone().with_positive_leading();
        }
        let degree = short.coefficients.len() - 1;
        let bound = match [long, short].map(|p| ModularPolynomial::of(&p.coefficients)) {
            [Some(long), Some(short)] => long.degree_of_gcd(&short),
            _ => degree,
        };
        if bound == 0 {
            return Self { coefficients: vec![BigInt::one()] };
        }
        if bound == degree && long.divided_by(short).is_some() {
            return short.clone().with_positive_leading();
        }
        let (mut a, mut b) = (long.clone(), short.clone());
        while let Some((_, _, remainder)) = pseudo_division(&a.coefficients, &b.coefficients) {
            super::spend();
            (a, b) = (b, Self::primitive(remainder));
        }
        a.with_positive_leading()
    }

    /// self/divisor, if that is a polynomial with integer coefficients; by Gauss's lemma it is, if it has rational ones.
    fn divided_by(&self, divisor: &Self) -> Option<Self> {
        let (leading, lower) = divisor.coefficients.split_last()?;
        let mut remainder = self.coefficients.clone();
        let mut quotient = Vec::new();
        while remainder.len() > lower.len() {
            let (factor, rest) = remainder.pop()?.div_rem(leading);
            if !rest.is_zero() {
                return None;
            }
            subtract_multiple(&mut remainder, &factor, lower);
            quotient.push(factor);
        }
        quotient.reverse();
        remainder.iter().all(Zero::is_zero).then_some(Self { coefficients: quotient })
    }

    /// p/gcd(p, p′): the same roots, each simple.
    pub(crate) fn square_free(self) -> Self {
        if ModularPolynomial::of(&self.coefficients).is_some_and(|image| image.is_square_free()) {
            return self;
        }
        let repeated = self.gcd(&self.derivative());
        if repeated.coefficients.len() <= 1 { self } else { self.divided_by(&repeated).unwrap_or(self) }
    }
}

/// Subtracts factor·uˢ·`lower` with s such that both end at the same place.
fn subtract_multiple(remainder: &mut [BigInt], factor: &BigInt, lower: &[BigInt]) {
    let shift = remainder.len() - lower.len();
    for (c, d) in remainder[shift..].iter_mut().zip(lower) {
        *c -= factor * d;
    }
}

/// (scale, quotient, remainder) with scale·dividend = quotient·divisor + remainder in integers, where scale ≠ 0 grows
/// only when a quotient would be a fraction; `None` for a divisor without a leading coefficient.
pub(super) fn pseudo_division(
    dividend: &[BigInt],
    divisor: &[BigInt],
) -> Option<(BigInt, Vec<BigInt>, Vec<BigInt>)> {
    let (leading, lower) = divisor.split_last().filter(|(leading, _)| !leading.is_zero())?;
    let (mut scale, mut quotient, mut remainder) = (BigInt::one(), Vec::new(), dividend.to_vec());
    while remainder.len() > lower.len() {
        let top = remainder.pop()?;
        let (mut factor, rest) = top.div_rem(leading);
        if !rest.is_zero() {
            let common = gcd(&rest, leading);
            let multiple = leading / &common;
            for c in remainder.iter_mut().chain(&mut quotient) {
                *c *= &multiple;
            }
            scale *= multiple;
            factor = top / common;
        }
        subtract_multiple(&mut remainder, &factor, lower);
        quotient.push(factor);
    }
    quotient.reverse();
    Some((scale, quotient, remainder))
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
        let prime: BigInt = (BigInt::one() << 61) - 1;
        let tricky = IntegerPolynomial::primitive(vec![-prime.clone(), BigInt::zero(), BigInt::one()]);
        assert!(!ModularPolynomial::of(&tricky.coefficients).unwrap().is_square_free());
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
        assert_eq!(p.gcd(&polynomial(&[-1, -2])), polynomial(&[1, 2]));
        // Modulo 2⁶¹ − 1 these are both u, or of a lower degree; over the integers they are coprime.
        let prime: BigInt = (BigInt::one() << 61) - 1;
        let two = |a: BigInt, b: BigInt| IntegerPolynomial::primitive(vec![a, b]);
        assert_eq!(two(prime.clone(), BigInt::one()).gcd(&polynomial(&[0, 1])), polynomial(&[1]));
        assert_eq!(two(BigInt::one(), prime.clone()).gcd(&polynomial(&[1, 1])), polynomial(&[1]));
        let common = two(BigInt::one(), prime);
        assert_eq!(common.gcd(&common), common);
    }
}
