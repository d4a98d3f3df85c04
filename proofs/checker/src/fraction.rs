//! Quotients of polynomials. A denominator is kept as a product of factors, each of which has been shown to be
//! positive: common denominators stay small although nothing is ever cancelled.

use std::collections::BTreeMap;

use dashu_int::IBig;

use crate::error::Reason;
use crate::number::Ratio;
use crate::poly::{Poly, Sign};

/// How often each factor occurs.
type Factors = BTreeMap<Poly, u16>;

#[derive(Clone, Debug)]
pub(crate) struct Fraction {
    pub(crate) num: Poly,
    den: Factors,
}

impl From<Poly> for Fraction {
    fn from(num: Poly) -> Self {
        Fraction { num, den: Factors::new() }
    }
}

impl Fraction {
    pub(crate) fn zero() -> Self {
        Poly::zero().into()
    }

    pub(crate) fn one() -> Self {
        Poly::one().into()
    }

    pub(crate) fn number(value: &Ratio) -> Self {
        let den = Poly::constant(value.den.clone());
        let trivial = value.den == IBig::ONE;
        Fraction {
            num: Poly::constant(value.num.clone()),
            den: if trivial { Factors::new() } else { [(den, 1)].into() },
        }
    }

    /// A quotient of polynomials, if the second one has a sign.
    pub(crate) fn new(num: Poly, den: Poly, signs: &[Sign]) -> Result<Self, Reason> {
        let negated = den.negated();
        let (num, den) = match (den.sign(signs), negated.sign(signs)) {
            (Sign::Positive, _) => (num, den),
            (_, Sign::Positive) => (num.negated(), negated),
            _ => return Err(Reason::Divisor),
        };
        let trivial = den == Poly::one() || num.is_zero();
        Ok(Fraction { num, den: if trivial { Factors::new() } else { [(den, 1)].into() } })
    }

    pub(crate) fn is_zero(&self) -> bool {
        self.num.is_zero()
    }

    /// The sign of the value: that of the numerator, as denominators are positive.
    pub(crate) fn sign(&self, signs: &[Sign]) -> Sign {
        self.num.sign(signs)
    }

    /// The value itself, if it is positive.
    pub(crate) fn positive(self, name: &str, signs: &[Sign]) -> Result<Self, Reason> {
        if self.sign(signs) == Sign::Positive { Ok(self) } else { Err(Reason::NotPositive(name.to_owned())) }
    }

    /// The denominator, multiplied out.
    pub(crate) fn denominator(&self) -> Result<Poly, Reason> {
        missing(&self.den, &Factors::new())
    }

    pub(crate) fn num_and_den(&self) -> Result<(Poly, Poly), Reason> {
        Ok((self.num.clone(), self.denominator()?))
    }

    pub(crate) fn plus(&self, other: &Self) -> Result<Self, Reason> {
        if self.is_zero() {
            return Ok(other.clone());
        }
        if other.is_zero() {
            return Ok(self.clone());
        }
        // The factors that both have are taken once.
        let mut den = self.den.clone();
        for (factor, times) in &other.den {
            let most = den.entry(factor.clone()).or_insert(0);
            *most = (*most).max(*times);
        }
        let left = self.num.times(&missing(&den, &self.den)?)?;
        let right = other.num.times(&missing(&den, &other.den)?)?;
        Ok(Fraction { num: left.plus(&right).fitting()?, den })
    }

    pub(crate) fn negated(&self) -> Self {
        Fraction { num: self.num.negated(), den: self.den.clone() }
    }

    pub(crate) fn minus(&self, other: &Self) -> Result<Self, Reason> {
        self.plus(&other.negated())
    }

    pub(crate) fn times(&self, other: &Self) -> Result<Self, Reason> {
        let num = self.num.times(&other.num)?;
        if num.is_zero() {
            return Ok(Fraction::zero());
        }
        let mut den = self.den.clone();
        for (factor, times) in &other.den {
            let sum = den.entry(factor.clone()).or_insert(0);
            *sum = sum.checked_add(*times).ok_or(Reason::TooLarge("an exponent"))?;
        }
        Ok(Fraction { num, den })
    }

    pub(crate) fn over(&self, other: &Self, signs: &[Sign]) -> Result<Self, Reason> {
        let inverse = Fraction::new(other.denominator()?, other.num.clone(), signs)?;
        self.times(&inverse)
    }

    pub(crate) fn to_power(&self, exponent: u16) -> Result<Self, Reason> {
        (0..exponent).try_fold(Fraction::one(), |power, _| power.times(self))
    }
}

/// The product of the factors in `all` that `some` lacks.
fn missing(all: &Factors, some: &Factors) -> Result<Poly, Reason> {
    let mut product = Poly::one();
    for (factor, times) in all {
        let lacking = times.saturating_sub(some.get(factor).copied().unwrap_or(0));
        for _ in 0..lacking {
            product = product.times(factor)?;
        }
    }
    Ok(product)
}

#[cfg(test)]
mod tests {
    use super::*;

    const SIGNS: [Sign; 3] = [Sign::Positive, Sign::Nonnegative, Sign::Real];

    fn variable(index: usize) -> Fraction {
        Poly::variable(index).into()
    }

    #[test]
    fn sums_and_quotients_are_those_of_fractions() {
        let (a, b) = (variable(0), variable(1));
        let sum = a.plus(&b).unwrap();
        let left = a.over(&sum, &SIGNS).unwrap();
        let right = b.over(&sum, &SIGNS).unwrap();
        let one = left.plus(&right).unwrap();
        assert!(one.minus(&Fraction::one()).unwrap().is_zero());
        // The common factor was taken once.
        assert_eq!(one.denominator(), Ok(sum.num.clone()));
        let back = left.times(&sum).unwrap().minus(&a).unwrap();
        assert!(back.is_zero() && !left.minus(&right).unwrap().is_zero());
        let half = Fraction::number(&Ratio::parse("-1/2").unwrap());
        assert!(half.plus(&half).unwrap().plus(&Fraction::one()).unwrap().is_zero());
        let eighth = half.to_power(3).unwrap().over(&half, &SIGNS).unwrap().times(&half).unwrap();
        assert!(eighth.minus(&half.to_power(3).unwrap()).unwrap().is_zero());
    }

    #[test]
    fn denominators_have_a_sign_and_it_is_plus() {
        let (a, b, real) = (variable(0), variable(1), variable(2));
        let down = a.plus(&b).unwrap().negated();
        assert_eq!(a.over(&down, &SIGNS).unwrap().denominator(), Ok(down.num.negated()));
        for bad in [Fraction::zero(), b.clone(), real.clone(), a.minus(&b).unwrap(), real.plus(&a).unwrap()] {
            assert_eq!(a.over(&bad, &SIGNS).err(), Some(Reason::Divisor));
        }
    }
}
