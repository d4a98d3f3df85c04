//! Polynomials with whole coefficients in parameters and unknowns: added, multiplied and compared, never divided.

use std::collections::BTreeMap;
use std::collections::btree_map::Entry;

use dashu_int::IBig;
use dashu_int::ops::BitTest;

use crate::error::{Reason, Result};
use crate::work::{keep, spend};

/// Products with more terms than this are given up on, as sums may be some time later.
const TERMS: usize = 500_000;
/// So are coefficients of more bits: the big integers would end the program where memory does.
const BITS: usize = 1_000_000;

/// What is known of the values of a variable.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Sign {
    Real,
    Nonnegative,
    Positive,
}

/// Exponents by variable, without zeros at the end: every monomial has one key.
type Monomial = Vec<u16>;

/// Coefficients by monomial, none of them 0: equal polynomials are equal as data.
#[derive(Clone, Default, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Poly {
    terms: BTreeMap<Monomial, IBig>,
}

impl Poly {
    pub(crate) fn constant(value: impl Into<IBig>) -> Self {
        Poly { terms: [(Monomial::new(), value.into())].into() }.clean()
    }

    pub(crate) fn variable(index: usize) -> Self {
        let mut monomial = vec![0; index];
        monomial.push(1);
        Poly { terms: [(monomial, IBig::ONE)].into() }
    }

    /// The number of terms.
    pub(crate) fn size(&self) -> usize {
        self.terms.len()
    }

    pub(crate) fn is_zero(&self) -> bool {
        self.terms.is_empty()
    }

    fn clean(mut self) -> Self {
        self.terms.retain(|_, value| *value != IBig::ZERO);
        self
    }

    pub(crate) fn plus(mut self, other: &Self) -> Self {
        for (monomial, value) in &other.terms {
            match self.terms.entry(monomial.clone()) {
                Entry::Vacant(place) => {
                    place.insert(value.clone());
                }
                Entry::Occupied(mut sum) => {
                    *sum.get_mut() += value;
                    if *sum.get() == IBig::ZERO {
                        sum.remove();
                    }
                }
            }
        }
        self
    }

    pub(crate) fn minus(self, other: &Self) -> Self {
        self.plus(&other.negated())
    }

    pub(crate) fn negated(&self) -> Self {
        Poly { terms: self.terms.iter().map(|(monomial, value)| (monomial.clone(), -value)).collect() }
    }

    pub(crate) fn times(&self, other: &Self) -> Result<Self> {
        let mut product = Poly::default();
        for (a, left) in &self.terms {
            for (b, right) in &other.terms {
                let bits = left.bit_len() + right.bit_len();
                if bits > BITS {
                    return Err(Reason::Limits("a number"));
                }
                // A long number is as much work as many short ones; in a long polynomial a term takes longer to find.
                spend(1 + bits / 64 + product.terms.len() / 8_192)?;
                *product.terms.entry(monomial_product(a, b)?).or_default() += left * right;
            }
            if product.terms.len() > TERMS {
                return Err(Reason::Limits("a polynomial"));
            }
        }
        let product = product.clean();
        keep(product.size()).map(|()| product)
    }

    pub(crate) fn to_power(&self, exponent: u16) -> Result<Self> {
        (0..exponent).try_fold(Poly::constant(1), |power, _| power.times(self))
    }

    /// The sign that the coefficients show, for all values that the variables may have: real if they show none.
    pub(crate) fn sign(&self, signs: &[Sign]) -> Sign {
        let sign = |monomial: &Monomial| {
            let of = |(index, exponent): (usize, &u16)| match (exponent, signs.get(index)) {
                (0, _) => Sign::Positive,
                (_, Some(sign)) => *sign,
                (_, None) => Sign::Real,
            };
            monomial.iter().enumerate().map(of).min().unwrap_or(Sign::Positive)
        };
        // One real variable in one monomial, or one coefficient below 0, and nothing is shown.
        if self.terms.iter().any(|(monomial, value)| *value < IBig::ZERO || sign(monomial) == Sign::Real) {
            return Sign::Real;
        }
        self.terms.keys().map(sign).max().unwrap_or(Sign::Nonnegative)
    }

    /// Whether only such variables occur.
    pub(crate) fn is_only_in(&self, allowed: impl Fn(usize) -> bool) -> bool {
        let only =
            |monomial: &Monomial| monomial.iter().enumerate().all(|(index, e)| *e == 0 || allowed(index));
        self.terms.keys().all(only)
    }

    /// The coefficients of the powers of one variable, the lowest first, none of them 0.
    pub(crate) fn by_powers(&self, variable: usize) -> BTreeMap<u16, Poly> {
        let mut powers: BTreeMap<u16, Poly> = BTreeMap::new();
        for (monomial, value) in &self.terms {
            let mut rest = monomial.clone();
            let exponent = rest.get_mut(variable).map(std::mem::take).unwrap_or(0);
            while rest.last() == Some(&0) {
                rest.pop();
            }
            powers.entry(exponent).or_default().terms.insert(rest, value.clone());
        }
        powers
    }

    pub(crate) fn degree(&self, variable: usize) -> u16 {
        self.terms.keys().filter_map(|monomial| monomial.get(variable)).max().copied().unwrap_or(0)
    }

    /// With up/down in the place of one variable, times down^n; n is the degree in it, or `least` if that is more.
    pub(crate) fn substitute(&self, y: usize, (up, down): (&Self, &Self), least: u16) -> Result<Self> {
        let n = self.degree(y).max(least);
        let mut sum = Poly::default();
        for (exponent, coefficient) in self.by_powers(y) {
            let factor = up.to_power(exponent)?.times(&down.to_power(n - exponent)?)?;
            sum = sum.plus(&coefficient.times(&factor)?);
        }
        Ok(sum)
    }
}

/// Exponents are not negative: the sum of two has no new zeros at the end.
fn monomial_product(a: &Monomial, b: &Monomial) -> Result<Monomial> {
    let (long, short) = if a.len() < b.len() { (b, a) } else { (a, b) };
    let mut product = long.clone();
    for (to, from) in product.iter_mut().zip(short) {
        *to = to.checked_add(*from).ok_or(Reason::Limits("an exponent"))?;
    }
    Ok(product)
}
