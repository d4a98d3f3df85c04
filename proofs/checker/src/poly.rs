//! Polynomials with whole coefficients in parameters and unknowns: added, multiplied and compared, never divided.

use std::collections::BTreeMap;

use dashu_int::IBig;
use dashu_int::ops::BitTest;

use crate::error::Reason;
use crate::number::{Ratio, multiply, power};

/// A polynomial that takes more machine words than this is given up on.
const WORDS: usize = 1 << 25;

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
#[derive(Clone, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Poly {
    terms: BTreeMap<Monomial, IBig>,
}

impl Poly {
    pub(crate) fn zero() -> Self {
        Poly::default()
    }

    pub(crate) fn one() -> Self {
        Poly::constant(IBig::ONE)
    }

    pub(crate) fn constant(value: IBig) -> Self {
        let mut poly = Poly::zero();
        poly.insert(Monomial::new(), value);
        poly
    }

    pub(crate) fn variable(index: usize) -> Self {
        let mut monomial = vec![0; index];
        monomial.push(1);
        let mut poly = Poly::zero();
        poly.insert(monomial, IBig::ONE);
        poly
    }

    pub(crate) fn is_zero(&self) -> bool {
        self.terms.is_empty()
    }

    /// The value of a polynomial without variables.
    pub(crate) fn as_constant(&self) -> Option<IBig> {
        if self.is_zero() {
            return Some(IBig::ZERO);
        }
        if self.terms.len() == 1 { self.terms.get(&Monomial::new()).cloned() } else { None }
    }

    fn insert(&mut self, monomial: Monomial, value: IBig) {
        if value == IBig::ZERO {
            return;
        }
        match self.terms.entry(monomial) {
            std::collections::btree_map::Entry::Vacant(place) => {
                place.insert(value);
            }
            std::collections::btree_map::Entry::Occupied(mut place) => {
                *place.get_mut() += value;
                if *place.get() == IBig::ZERO {
                    place.remove();
                }
            }
        }
    }

    pub(crate) fn plus(mut self, other: &Self) -> Self {
        for (monomial, value) in &other.terms {
            self.insert(monomial.clone(), value.clone());
        }
        self
    }

    pub(crate) fn minus(self, other: &Self) -> Self {
        self.plus(&other.negated())
    }

    pub(crate) fn negated(&self) -> Self {
        Poly { terms: self.terms.iter().map(|(monomial, value)| (monomial.clone(), -value)).collect() }
    }

    pub(crate) fn scaled(&self, by: &IBig) -> Result<Self, Reason> {
        self.times(&Poly::constant(by.clone()))
    }

    pub(crate) fn times(&self, other: &Self) -> Result<Self, Reason> {
        let mut product = Poly::zero();
        let mut words = 0_usize;
        for (a, left) in &self.terms {
            for (b, right) in &other.terms {
                let value = multiply(left, right)?;
                let (before, monomial) = (product.terms.len(), monomial_product(a, b)?);
                let size = words_of(&monomial, &value);
                product.insert(monomial, value);
                words += if product.terms.len() > before { size } else { 0 };
                if words > WORDS {
                    return Err(Reason::TooLarge("a polynomial"));
                }
            }
        }
        Ok(product)
    }

    /// The polynomial, if it is within the limits: sums may have grown beyond them.
    pub(crate) fn fitting(self) -> Result<Self, Reason> {
        let words: usize = self.terms.iter().map(|(monomial, value)| words_of(monomial, value)).sum();
        if words > WORDS { Err(Reason::TooLarge("a polynomial")) } else { Ok(self) }
    }

    pub(crate) fn to_power(&self, exponent: u16) -> Result<Self, Reason> {
        (0..exponent).try_fold(Poly::one(), |power, _| power.times(self))
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

    /// Whether no variable but this one occurs.
    pub(crate) fn is_only_in(&self, variable: usize) -> bool {
        let only =
            |monomial: &Monomial| monomial.iter().enumerate().all(|(index, e)| index == variable || *e == 0);
        self.terms.keys().all(only)
    }

    pub(crate) fn mentions(&self, variable: usize) -> bool {
        self.terms.keys().any(|monomial| monomial.get(variable).is_some_and(|exponent| *exponent > 0))
    }

    /// The coefficients of the powers of one variable, the lowest first, none of them 0.
    pub(crate) fn by_powers(&self, variable: usize) -> BTreeMap<u16, Poly> {
        let mut powers: BTreeMap<u16, Poly> = BTreeMap::new();
        for (monomial, value) in &self.terms {
            let mut rest = monomial.clone();
            let exponent = rest.get_mut(variable).map(std::mem::take).unwrap_or(0);
            powers.entry(exponent).or_default().insert(trimmed(rest), value.clone());
        }
        powers
    }

    /// With y = c·z/(1 + z) for one variable y, times the power of (1 + z) and of c's denominator that clears it.
    /// The new z has the place of y. As z runs over the numbers from 0 on, y runs from 0 to c, without c.
    pub(crate) fn below(&self, variable: usize, c: &Ratio) -> Result<Self, Reason> {
        let powers = self.by_powers(variable);
        let degree = powers.keys().last().copied().unwrap_or(0);
        let z = Poly::variable(variable);
        let (up, down) = (z.scaled(&c.num)?, Poly::one().plus(&z).scaled(&c.den)?);
        let mut sum = Poly::zero();
        for (exponent, coefficient) in powers {
            let factor = up.to_power(exponent)?.times(&down.to_power(degree - exponent)?)?;
            sum = sum.plus(&coefficient.times(&factor)?);
        }
        Ok(sum)
    }

    /// With y = c + z for one variable y, times the power of c's denominator that clears it.
    pub(crate) fn beyond(&self, variable: usize, c: &Ratio) -> Result<Self, Reason> {
        let powers = self.by_powers(variable);
        let degree = powers.keys().last().copied().unwrap_or(0);
        let shifted = Poly::variable(variable).scaled(&c.den)?.plus(&Poly::constant(c.num.clone()));
        let mut sum = Poly::zero();
        for (exponent, coefficient) in powers {
            let factor = shifted.to_power(exponent)?.scaled(&power(&c.den, degree - exponent)?)?;
            sum = sum.plus(&coefficient.times(&factor)?);
        }
        Ok(sum)
    }

    /// The value at a point of the only variable that may occur.
    pub(crate) fn at(&self, variable: usize, point: &Ratio) -> Result<Ratio, Reason> {
        let powers = self.by_powers(variable);
        let degree = powers.keys().last().copied().unwrap_or(0);
        let mut sum = IBig::ZERO;
        for (exponent, coefficient) in powers {
            let constant = coefficient.as_constant().ok_or(Reason::NotOnlyU)?;
            let (up, down) = (power(&point.num, exponent)?, power(&point.den, degree - exponent)?);
            sum += multiply(&constant, &multiply(&up, &down)?)?;
        }
        Ok(Ratio { num: sum, den: power(&point.den, degree)? })
    }
}

/// About what a term takes in memory.
fn words_of(monomial: &Monomial, value: &IBig) -> usize {
    value.bit_len() / 64 + monomial.len() / 4 + 8
}

fn trimmed(mut monomial: Monomial) -> Monomial {
    while monomial.last() == Some(&0) {
        monomial.pop();
    }
    monomial
}

/// Exponents are not negative: the sum of two has no new zeros at the end.
fn monomial_product(a: &Monomial, b: &Monomial) -> Result<Monomial, Reason> {
    let (long, short) = if a.len() < b.len() { (b, a) } else { (a, b) };
    let mut product = long.clone();
    for (to, from) in product.iter_mut().zip(short) {
        *to = to.checked_add(*from).ok_or(Reason::TooLarge("an exponent"))?;
    }
    Ok(product)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn number(value: i64) -> Poly {
        Poly::constant(IBig::from(value))
    }

    fn x() -> Poly {
        Poly::variable(0)
    }

    fn y() -> Poly {
        Poly::variable(2)
    }

    fn ratio(word: &str) -> Ratio {
        Ratio::parse(word).unwrap()
    }

    /// A few polynomials: zero, constants, with gaps between the variables, with both signs.
    fn samples() -> Vec<Poly> {
        let square = x().plus(&y()).to_power(2).unwrap();
        vec![
            Poly::zero(),
            number(1),
            number(-3),
            x(),
            y(),
            square.clone(),
            square.minus(&number(2)),
            x().minus(&y()),
        ]
    }

    #[test]
    fn the_laws_of_a_ring_hold() {
        for a in samples() {
            assert!(a.clone().minus(&a).is_zero() && a.times(&Poly::one()) == Ok(a.clone()));
            assert_eq!(a.times(&Poly::zero()), Ok(Poly::zero()));
            for b in samples() {
                assert_eq!(a.clone().plus(&b), b.clone().plus(&a));
                assert_eq!(a.times(&b), b.times(&a));
                for c in samples() {
                    let left = a.clone().plus(&b).times(&c).unwrap();
                    assert_eq!(left, a.times(&c).unwrap().plus(&b.times(&c).unwrap()));
                    assert_eq!(a.times(&b).unwrap().times(&c), a.times(&b.times(&c).unwrap()));
                }
            }
        }
    }

    #[test]
    fn binomial_formulas_hold_literally() {
        let sum = x().plus(&y());
        let difference = x().minus(&y());
        let squares = x().to_power(2).unwrap().minus(&y().to_power(2).unwrap());
        assert_eq!(sum.times(&difference), Ok(squares));
        let cube = sum.to_power(3).unwrap();
        // In the order of the keys: y³, x·y², x²·y, x³.
        assert!(cube.terms.values().eq(&[1, 3, 3, 1].map(IBig::from)));
        assert_eq!(cube.by_powers(0).get(&1), Some(&number(3).times(&y().to_power(2).unwrap()).unwrap()));
    }

    #[test]
    fn signs_are_read_off_only_where_they_show() {
        use Sign::{Nonnegative, Positive, Real};
        let square = x().to_power(2).unwrap();
        let cases = [
            (Poly::zero(), [Positive, Positive], Nonnegative),
            (number(1), [Real, Real], Positive),
            (number(-1), [Positive, Positive], Real),
            (x(), [Nonnegative, Real], Nonnegative),
            (x().plus(&y()), [Nonnegative, Positive], Positive),
            (x().plus(&y()), [Nonnegative, Nonnegative], Nonnegative),
            (x().plus(&number(1)), [Nonnegative, Real], Positive),
            // 1 + x vanishes at −1: a positive monomial is not enough.
            (x().plus(&number(1)), [Real, Positive], Real),
            (square.plus(&number(1)), [Real, Positive], Real),
            (x().minus(&y()), [Positive, Positive], Real),
            (x().times(&y()).unwrap(), [Positive, Nonnegative], Nonnegative),
        ];
        for (poly, [of_x, of_y], want) in cases {
            assert_eq!(poly.sign(&[of_x, Real, of_y]), want, "{poly:?}");
        }
        assert_eq!(y().sign(&[Positive]), Real);
    }

    #[test]
    fn substitutions_are_what_evaluation_says() {
        // 2x² − 3x + 5 at c·z/(1+z) and at c + z, with c = 3/2 and z = 4/7.
        let poly = number(2).times(&x()).unwrap().minus(&number(3)).times(&x()).unwrap().plus(&number(5));
        let (c, z) = (ratio("3/2"), ratio("4/7"));
        let inside = ratio("6/11");
        let scale = ratio("4").times(&ratio("121/49")).unwrap();
        let want = poly.at(0, &inside).unwrap().times(&scale).unwrap();
        assert!(poly.below(0, &c).unwrap().at(0, &z).unwrap().minus(&want).unwrap().is_zero());
        let want = poly.at(0, &ratio("29/14")).unwrap().times(&ratio("4")).unwrap();
        assert!(poly.beyond(0, &c).unwrap().at(0, &z).unwrap().minus(&want).unwrap().is_zero());
        assert_eq!(y().at(0, &z), Err(Reason::NotOnlyU));
        assert!(y().is_only_in(2) && !y().is_only_in(0) && number(1).is_only_in(0) && y().mentions(2));
    }

    #[test]
    fn what_grows_too_large_is_given_up_on() {
        let big = x().to_power(40_000).unwrap();
        assert_eq!(big.times(&big), Err(Reason::TooLarge("an exponent")));
        let wide = (0..40).fold(Poly::one(), |sum, index| sum.plus(&Poly::variable(index)));
        assert_eq!(wide.to_power(9), Err(Reason::TooLarge("a polynomial")));
    }
}
