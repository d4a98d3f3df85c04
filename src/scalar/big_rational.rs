//! Fractions of integers of any size as an ordered field, always in lowest terms.
//!
//! For lists of fractions, as the coefficients of polynomials are, everything is done on numerators over one denominator,
//! and each coefficient of the result is reduced once.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::Signed;

use super::fraction::{exact, fraction, over_one_denominator, product, sum};
use super::gcd::gcd;
use super::integer_polynomial::{IntegerPolynomial, pseudo_division};
use super::ring::{ExactField, Field, OrderedField, RationalAlgebra, Ring};

/// The same divided by an integer ≠ 0.
fn over_integer(list: Vec<BigInt>, divisor: &BigInt) -> Vec<BigRational> {
    list.into_iter().map(|c| fraction(c, divisor.clone())).collect()
}

impl Ring for BigRational {
    fn certainly_negative(&self) -> bool {
        num_traits::Signed::is_negative(self)
    }
    fn zero(&self) -> Self {
        num_traits::Zero::zero()
    }
    fn one(&self) -> Self {
        num_traits::One::one()
    }
    fn plus(&self, rhs: &Self) -> Self {
        sum(self, rhs, |a, b| a + b)
    }
    fn minus(&self, rhs: &Self) -> Self {
        sum(self, rhs, |a, b| a - b)
    }
    fn times(&self, rhs: &Self) -> Self {
        product((self.numer(), self.denom()), (rhs.numer(), rhs.denom()))
    }
    fn negate(&self) -> Self {
        -self
    }
    fn is_zero(&self) -> bool {
        self.numer().is_zero()
    }
    /// Powers of coprime numbers are coprime.
    fn power(&self, exponent: usize) -> Self {
        BigRational::new_raw(self.numer().power(exponent), self.denom().power(exponent))
    }
    fn product_of_polynomials(a: &[Self], b: &[Self], length: usize) -> Vec<Self> {
        let ((a, p), (b, q)) = (over_one_denominator(a), over_one_denominator(b));
        over_integer(BigInt::product_of_polynomials(&a, &b, length), &(p * q))
    }
    /// By Horner's rule on Σ c_i aⁱdⁿ⁻ⁱ, for u = a/d.
    fn value_of_polynomial(coefficients: &[Self], u: &Self) -> Self {
        let (coefficients, denominator) = over_one_denominator(coefficients);
        let (mut value, mut power) = (BigInt::ZERO, BigInt::from(1));
        let mut terms = coefficients.iter().rev();
        if let Some(leading) = terms.next() {
            value.clone_from(leading);
        }
        for c in terms {
            power *= u.denom();
            value = value * u.numer() + c * &power;
        }
        fraction(value, denominator * power)
    }
}

impl RationalAlgebra for BigRational {
    fn lies_outside(&self, low: &BigRational, high: &BigRational) -> bool {
        self < low || self > high
    }
    fn embed(&self, value: &BigRational) -> Self {
        value.clone()
    }
    fn reciprocal(&self) -> Option<Self> {
        (!self.is_zero()).then(|| self.recip())
    }
    fn over(&self, rhs: &Self) -> Option<Self> {
        let (s, t) = (rhs.denom(), rhs.numer());
        match t.is_negative() {
            _ if rhs.is_zero() => None,
            true => Some(product((self.numer(), self.denom()), (&-s, &-t))),
            false => Some(product((self.numer(), self.denom()), (s, t))),
        }
    }
    /// pt/(pt + sq) and sq/(pt + sq), for p/q and s/t: one common divisor for both.
    fn shares(&self, rhs: &Self) -> Option<(Self, Self)> {
        let ((p, q), (s, t)) = ((self.numer(), self.denom()), (rhs.numer(), rhs.denom()));
        let (own, other) = if q == t { (p.clone(), s.clone()) } else { (p * t, s * q) };
        let total = &own + &other;
        if total.is_zero() {
            return None;
        }
        let common = gcd(&own, &other);
        let common = if total.is_negative() { -common } else { common };
        let share = |part: &BigInt| BigRational::new_raw(exact(part, &common), exact(&total, &common));
        Some((share(&own), share(&other)))
    }
}

impl Field for BigRational {
    /// On the primitive part of the divisor: if that divides, no remainder on the way is a fraction, by Gauss's lemma.
    fn quotient_of_polynomials(dividend: &[Self], divisor: &[Self]) -> Option<(Vec<Self>, Vec<Self>)> {
        let ((dividend, p), (divisor, q)) = (over_one_denominator(dividend), over_one_denominator(divisor));
        let content = divisor.iter().fold(BigInt::ZERO, |content, c| gcd(&content, c));
        if content.is_zero() {
            return None;
        }
        let divisor: Vec<BigInt> = divisor.iter().map(|c| exact(c, &content)).collect();
        let (scale, quotient, remainder) = pseudo_division(&dividend, &divisor)?;
        // scale·p·(dividend) = quotient·(divisor·q/content) + remainder.
        let scale = scale * p;
        let factor = fraction(q, content * &scale);
        let quotient = quotient.into_iter().map(|c| fraction(c * factor.numer(), factor.denom().clone()));
        Some((quotient.collect(), over_integer(remainder, &scale)))
    }
    fn gcd_of_polynomials(a: &[Self], b: &[Self]) -> Vec<Self> {
        let primitive = |list: &[Self]| IntegerPolynomial::primitive(over_one_denominator(list).0);
        let common = primitive(a).gcd(&primitive(b)).into_coefficients();
        match common.last().cloned() {
            Some(leading) => over_integer(common, &leading),
            None => vec![BigRational::from_integer(BigInt::ZERO)],
        }
    }
}

impl ExactField for BigRational {}
impl OrderedField for BigRational {}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::scalar::{Polynomial, rational};

    /// Fractions with common parts in numerators and denominators, of one word and of several.
    fn number() -> impl Strategy<Value = BigRational> {
        let part = prop_oneof![
            Just(BigInt::ZERO),
            (-12_i64..=12).prop_map(BigInt::from),
            any::<i64>().prop_map(BigInt::from),
            any::<i128>().prop_map(|n| BigInt::from(n) * n),
        ];
        let denominator = part.clone().prop_filter("not 0", |n| !n.is_zero());
        (part, denominator).prop_map(|(p, q)| BigRational::new(p, q))
    }

    /// The arithmetic of the library of rational numbers itself: what the rules here have to agree with.
    #[derive(Debug, Clone, PartialEq)]
    struct Plain(BigRational);

    impl Ring for Plain {
        fn zero(&self) -> Self {
            Self(num_traits::Zero::zero())
        }
        fn one(&self) -> Self {
            Self(num_traits::One::one())
        }
        fn plus(&self, rhs: &Self) -> Self {
            Self(&self.0 + &rhs.0)
        }
        fn minus(&self, rhs: &Self) -> Self {
            Self(&self.0 - &rhs.0)
        }
        fn times(&self, rhs: &Self) -> Self {
            Self(&self.0 * &rhs.0)
        }
        fn negate(&self) -> Self {
            Self(-&self.0)
        }
    }

    impl RationalAlgebra for Plain {
        fn embed(&self, value: &BigRational) -> Self {
            Self(value.clone())
        }
        fn reciprocal(&self) -> Option<Self> {
            (!self.0.is_zero()).then(|| Self(self.0.recip()))
        }
    }

    impl Field for Plain {}

    fn plain(p: &Polynomial<BigRational>) -> Polynomial<Plain> {
        let mut c = p.coefficients().iter().cloned().map(Plain);
        Polynomial::new(c.next().unwrap(), c)
    }

    /// Numerator and denominator one by one: a fraction that is not in lowest terms would be equal otherwise.
    fn same(found: &BigRational, expected: &BigRational) {
        assert_eq!((found.numer(), found.denom()), (expected.numer(), expected.denom()));
    }

    fn same_polynomial(found: &Polynomial<BigRational>, expected: &Polynomial<Plain>) {
        assert_eq!(found.degree(), expected.degree());
        found.coefficients().iter().zip(expected.coefficients()).for_each(|(c, Plain(d))| same(c, d));
    }

    fn polynomial() -> impl Strategy<Value = Polynomial<BigRational>> {
        prop::collection::vec(number(), 1..5)
            .prop_map(|mut c| Polynomial::new(c.pop().unwrap_or_default(), c))
    }

    proptest! {
        #[test]
        fn the_same_as_by_the_library(a in number(), b in number()) {
            same(&a.plus(&b), &(&a + &b));
            same(&a.minus(&b), &(&a - &b));
            same(&a.times(&b), &(&a * &b));
            same(&a.power(3), &(&a * &a * &a));
            prop_assert_eq!(a.over(&b).is_some(), !b.is_zero());
            if let Some(quotient) = a.over(&b) {
                same(&quotient, &(&a / &b));
            }
            let total = &a + &b;
            prop_assert_eq!(a.shares(&b).is_some(), !total.is_zero());
            if let Some((own, other)) = a.shares(&b) {
                same(&own, &(&a / &total));
                same(&other, &(&b / &total));
            }
        }

        #[test]
        fn polynomials_as_by_the_generic_rules(a in polynomial(), b in polynomial(), c in polynomial(), u in number()) {
            let (x, y, z) = (plain(&a), plain(&b), plain(&c));
            same_polynomial(&a.times(&b), &x.times(&y));
            same(&a.evaluate(&u), &x.evaluate(&Plain(u.clone())).0);
            same_polynomial(&a.gcd(&b), &x.gcd(&y));
            same_polynomial(&a.times(&c).gcd(&b.times(&c)), &x.times(&z).gcd(&y.times(&z)));
            same_polynomial(&a.times(&c).gcd(&c), &x.times(&z).gcd(&z));
            same_polynomial(&a.times(&a).square_free(), &x.times(&x).square_free());
            same_polynomial(&a.monic(), &x.monic());
            for (a, b, x, y) in [(&a, &b, &x, &y), (&a.times(&b), &b, &x.times(&y), &y)] {
                prop_assert_eq!(a.divide(b).is_some(), !b.is_zero());
                if let (Some((q, r)), Some((s, t))) = (a.divide(b), x.divide(y)) {
                    same_polynomial(&q, &s);
                    same_polynomial(&r, &t);
                }
            }
        }
    }

    #[test]
    fn zeros_and_signs() {
        let (zero, half) = (rational(0, 1), rational(1, 2));
        same(&half.minus(&half), &zero);
        same(&zero.times(&half), &zero);
        same(&zero.over(&rational(-3, 7)).unwrap(), &zero);
        same(&half.over(&rational(-3, 7)).unwrap(), &rational(-7, 6));
        assert_eq!(half.over(&zero), None);
        assert_eq!(half.shares(&rational(-1, 2)), None);
        assert_eq!(rational(1, 2).shares(&rational(-2, 1)), Some((rational(-1, 3), rational(4, 3))));
        same(&zero.power(0), &rational(1, 1));
    }
}
