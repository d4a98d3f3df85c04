//! Quotients of polynomials. A denominator is kept as a product of factors, each of which has been shown to be
//! positive: common denominators stay small although nothing is ever cancelled.

use std::borrow::Cow;
use std::collections::BTreeMap;
use std::rc::Rc;

use crate::error::{Reason, Result};
use crate::poly::{Poly, Sign};
use crate::token::Node;
use crate::work::spend;

/// How often each factor occurs. Many fractions share them.
pub(crate) type Factors = BTreeMap<Rc<Poly>, u16>;

#[derive(Clone)]
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
    pub(crate) fn integer(value: i64) -> Self {
        Poly::constant(value).into()
    }

    pub(crate) fn number(node: &Node<'_>) -> Result<Self> {
        let (num, den) = node.ratio()?;
        Fraction::new(num, den, &[])
    }

    /// A quotient of polynomials, if the second one has a sign.
    pub(crate) fn new(num: Poly, den: Poly, signs: &[Sign]) -> Result<Self> {
        let negated = den.negated();
        match (den.sign(signs), negated.sign(signs)) {
            (Sign::Positive, _) if den == Poly::constant(1) => Ok(num.into()),
            (Sign::Positive, _) => Ok(Fraction { num, den: [(den.into(), 1)].into() }),
            (_, Sign::Positive) => Ok(Fraction { num: num.negated(), den: [(negated.into(), 1)].into() }),
            _ => Err(Reason::Divisor),
        }
    }

    /// The number of terms above and below the line, a factor counted once.
    pub(crate) fn size(&self) -> usize {
        self.num.size() + self.den.keys().map(|factor| factor.size()).sum::<usize>()
    }

    pub(crate) fn is_zero(&self) -> bool {
        self.num.is_zero()
    }

    /// The value itself, if it is positive: the numerator shows it, as denominators are positive.
    pub(crate) fn positive(self, name: &str, signs: &[Sign]) -> Result<Self> {
        self.at_least(Sign::Positive, name, signs)
    }

    /// The value itself, if it has such a sign.
    pub(crate) fn at_least(self, sign: Sign, name: &str, signs: &[Sign]) -> Result<Self> {
        if self.num.sign(signs) >= sign { Ok(self) } else { Err(Reason::NotPositive(name.to_owned())) }
    }

    /// Whether only such variables occur.
    pub(crate) fn is_only_in(&self, allowed: impl Fn(usize) -> bool) -> bool {
        self.num.is_only_in(&allowed) && self.den.keys().all(|factor| factor.is_only_in(&allowed))
    }

    /// The denominator, multiplied out.
    pub(crate) fn denominator(&self) -> Result<Poly> {
        Ok(missing(&self.den, &Factors::new())?.unwrap_or_else(|| Poly::constant(1)))
    }

    /// What this fraction adds to a common denominator.
    pub(crate) fn widen(&self, common: &mut Factors) {
        for (factor, times) in &self.den {
            // Factors that both have are taken once.
            let most = common.entry(factor.clone()).or_insert(0);
            *most = (*most).max(*times);
        }
    }

    /// The numerator over a common denominator.
    pub(crate) fn over_common(&self, common: &Factors) -> Result<Cow<'_, Poly>> {
        Ok(match missing(common, &self.den)? {
            Some(factor) => Cow::Owned(self.num.times(&factor)?),
            None => Cow::Borrowed(&self.num),
        })
    }

    pub(crate) fn plus(&self, other: &Self) -> Result<Self> {
        self.joined(other, Poly::plus)
    }

    /// The sum or the difference.
    fn joined(&self, other: &Self, of: impl Fn(Poly, &Poly) -> Poly) -> Result<Self> {
        spend(self.size() + other.size())?;
        if other.is_zero() {
            return Ok(self.clone());
        }
        if self.is_zero() {
            return Ok(Fraction { num: of(Poly::default(), &other.num), den: other.den.clone() });
        }
        let mut den = self.den.clone();
        other.widen(&mut den);
        let num = of(self.over_common(&den)?.into_owned(), &*other.over_common(&den)?);
        Ok(Fraction { num, den })
    }

    pub(crate) fn negated(&self) -> Self {
        Fraction { num: self.num.negated(), den: self.den.clone() }
    }

    pub(crate) fn minus(&self, other: &Self) -> Result<Self> {
        self.joined(other, Poly::minus)
    }

    pub(crate) fn times(&self, other: &Self) -> Result<Self> {
        spend(self.size() + other.size())?;
        let mut den = self.den.clone();
        for (factor, times) in &other.den {
            let sum = den.entry(factor.clone()).or_insert(0);
            *sum = sum.checked_add(*times).ok_or(Reason::Limits("an exponent"))?;
        }
        Ok(Fraction { num: self.num.times(&other.num)?, den })
    }

    pub(crate) fn over(&self, other: &Self, signs: &[Sign]) -> Result<Self> {
        self.times(&Fraction::new(other.denominator()?, other.num.clone(), signs)?)
    }

    pub(crate) fn to_power(&self, exponent: u16) -> Result<Self> {
        (0..exponent).try_fold(Fraction::integer(1), |power, _| power.times(self))
    }
}

/// The product of the factors in `all` that `some` lacks, if it lacks any.
fn missing(all: &Factors, some: &Factors) -> Result<Option<Poly>> {
    let mut product: Option<Poly> = None;
    for (factor, times) in all {
        let lacking = times.saturating_sub(some.get(factor).copied().unwrap_or(0));
        for _ in 0..lacking {
            product = Some(product.map_or_else(|| Ok((**factor).clone()), |product| product.times(factor))?);
        }
    }
    Ok(product)
}
