//! Polynomials with whole coefficients in parameters and unknowns: added, multiplied and compared, never divided.

use std::collections::{BTreeMap, HashMap};
use std::hash::{BuildHasherDefault, Hasher};

use dashu_int::IBig;
use dashu_int::ops::BitTest;
use smallvec::SmallVec;

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

/// Exponents by variable, without zeros at the end: every monomial has one key, and the order of keys is that of the products with
/// any other one. Up to so many variables they lie in place: a product has thousands of them.
type Monomial = SmallVec<[u16; 12]>;

/// Coefficients by monomial in the order of these, none of them 0: equal polynomials are equal as data.
#[derive(Clone, Default, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Poly {
    terms: Vec<(Monomial, IBig)>,
}

/// The exponents of the monomials of a product in one word: as many bits for each variable as the largest one needs, so that words add as
/// monomials multiply.
struct Packing {
    widths: Vec<u32>,
}

impl Packing {
    /// `None` if one word is not enough.
    fn of(left: &Poly, right: &Poly) -> Result<Option<Self>> {
        let largest = |poly: &Poly| {
            let mut all = Vec::new();
            for (monomial, _) in &poly.terms {
                all.resize(all.len().max(monomial.len()), 0);
                all.iter_mut().zip(monomial).for_each(|(most, e)| *most = u32::from(*e).max(*most));
            }
            all
        };
        let (mut widths, right) = (largest(left), largest(right));
        widths.resize(widths.len().max(right.len()), 0);
        for (at, width) in widths.iter_mut().enumerate() {
            let most = *width + right.get(at).copied().unwrap_or(0);
            let most = u16::try_from(most).map_err(|_| Reason::Limits("an exponent"))?;
            *width = u16::BITS - most.leading_zeros();
        }
        let bits: u32 = widths.iter().sum();
        Ok((bits <= u64::BITS).then_some(Packing { widths }))
    }

    fn packed(&self, poly: &Poly) -> Vec<(u64, i128)> {
        let word = |monomial: &Monomial| {
            let all = monomial.iter().chain(std::iter::repeat(&0)).zip(&self.widths);
            all.fold(0, |word: u64, (e, width)| word.checked_shl(*width).unwrap_or(0) | u64::from(*e))
        };
        let number = |value: &IBig| i128::try_from(value).ok();
        poly.terms.iter().filter_map(|(monomial, value)| Some((word(monomial), number(value)?))).collect()
    }

    fn unpacked(&self, mut word: u64) -> Monomial {
        let mut monomial: Monomial = SmallVec::from_elem(0, self.widths.len());
        for (e, width) in monomial.iter_mut().zip(&self.widths).rev() {
            let rest = word.checked_shr(*width).unwrap_or(0);
            *e = u16::try_from(word - rest.checked_shl(*width).unwrap_or(0)).unwrap_or(0);
            word = rest;
        }
        while monomial.last() == Some(&0) {
            monomial.pop();
        }
        monomial
    }

    /// The product, of polynomials with coefficients so short that all sums fit.
    fn times(&self, left: &Poly, right: &Poly) -> Result<Poly> {
        let (left, right) = (self.packed(left), self.packed(right));
        let mut sums: HashMap<u64, i128, BuildHasherDefault<Spread>> = HashMap::default();
        for (a, x) in &left {
            spend(right.len() * (1 + sums.len() / 65_536))?;
            for (b, y) in &right {
                *sums.entry(a + b).or_default() += x * y;
            }
            if sums.len() > TERMS {
                return Err(Reason::Limits("a polynomial"));
            }
        }
        let mut terms: Vec<_> = sums.into_iter().filter(|(_, value)| *value != 0).collect();
        terms.sort_unstable_by_key(|(word, _)| *word);
        Ok(Poly {
            terms: terms.into_iter().map(|(word, value)| (self.unpacked(word), value.into())).collect(),
        })
    }
}

/// A hash of one word: a product with a long odd number, both halves of it.
#[derive(Default)]
struct Spread(u64);

impl Hasher for Spread {
    fn finish(&self) -> u64 {
        self.0
    }

    fn write(&mut self, bytes: &[u8]) {
        bytes.iter().for_each(|byte| self.write_u64(self.0 ^ u64::from(*byte)));
    }

    fn write_u64(&mut self, word: u64) {
        let wide = u128::from(word) * 0x9E37_79B9_7F4A_7C15;
        self.0 =
            u64::try_from(wide >> 64).unwrap_or(0) ^ u64::try_from(wide & u128::from(u64::MAX)).unwrap_or(0);
    }
}

impl Poly {
    pub(crate) fn constant(value: impl Into<IBig>) -> Self {
        Poly::of(vec![(Monomial::new(), value.into())])
    }

    pub(crate) fn variable(index: usize) -> Self {
        let mut monomial: Monomial = SmallVec::from_elem(0, index);
        monomial.push(1);
        Poly { terms: vec![(monomial, IBig::ONE)] }
    }

    /// The number of terms.
    pub(crate) fn size(&self) -> usize {
        self.terms.len()
    }

    pub(crate) fn is_zero(&self) -> bool {
        self.terms.is_empty()
    }

    /// Of terms in any order, several of one monomial added up.
    fn of(mut terms: Vec<(Monomial, IBig)>) -> Self {
        // Rows of a product are in order each: a sort that sees that only merges them.
        terms.sort_by(|(a, _), (b, _)| a.cmp(b));
        terms.dedup_by(|(next, value), (monomial, sum)| {
            let same = next == monomial;
            if same {
                *sum += &*value;
            }
            same
        });
        terms.retain(|(_, value)| *value != IBig::ZERO);
        Poly { terms }
    }

    pub(crate) fn plus(self, other: &Self) -> Self {
        self.merged(other, |value| value.clone())
    }

    pub(crate) fn minus(self, other: &Self) -> Self {
        self.merged(other, |value| -value)
    }

    /// The sum with another one, whose coefficients become something else that is not 0.
    fn merged(self, other: &Self, of: impl Fn(&IBig) -> IBig) -> Self {
        let mut terms = Vec::with_capacity(self.terms.len() + other.terms.len());
        let mut right = other.terms.iter().peekable();
        for (monomial, value) in self.terms {
            while let Some((monomial, value)) = right.next_if(|(other, _)| *other < monomial) {
                terms.push((monomial.clone(), of(value)));
            }
            let sum = match right.next_if(|(other, _)| *other == monomial) {
                Some((_, other)) => value + of(other),
                None => value,
            };
            if sum != IBig::ZERO {
                terms.push((monomial, sum));
            }
        }
        terms.extend(right.map(|(monomial, value)| (monomial.clone(), of(value))));
        Poly { terms }
    }

    pub(crate) fn negated(&self) -> Self {
        Poly { terms: self.terms.iter().map(|(monomial, value)| (monomial.clone(), -value)).collect() }
    }

    pub(crate) fn times(&self, other: &Self) -> Result<Self> {
        let bits = |poly: &Self| poly.terms.iter().map(|(_, value)| value.bit_len()).max().unwrap_or(0);
        let bits = bits(self) + bits(other);
        if bits > BITS {
            return Err(Reason::Limits("a number"));
        }
        let rows = self.terms.len().min(other.terms.len());
        let sums_fit = bits + rows.checked_ilog2().unwrap_or(0) as usize + 1 < 127;
        let packing = if rows > 2 && sums_fit { Packing::of(self, other)? } else { None };
        let product = match packing {
            Some(packing) => packing.times(self, other)?,
            None => self.times_by_terms(other, bits)?,
        };
        keep(product.size()).map(|()| product)
    }

    fn times_by_terms(&self, other: &Self, bits: usize) -> Result<Self> {
        // In the order of the longer one, so that a product with one term is in order.
        let (short, long) = if self.size() < other.size() { (self, other) } else { (other, self) };
        if let [(monomial, value)] = short.terms.as_slice() {
            spend(long.terms.len() * (1 + bits / 64))?;
            let term = |(other, right): &(_, _)| Ok((monomial_product(other, monomial)?, value * right));
            return Ok(Poly { terms: long.terms.iter().map(term).collect::<Result<_>>()? });
        }
        let mut product = Poly::default();
        let mut terms = Vec::with_capacity(long.size());
        for (a, left) in &short.terms {
            // A long number is as much work as many short ones; in a long polynomial a term takes longer to find.
            spend(long.terms.len() * (1 + bits / 64 + product.terms.len() / 8_192))?;
            for (b, right) in &long.terms {
                terms.push((monomial_product(a, b)?, left * right));
            }
            if terms.len() > 2 * product.size().max(long.size()) {
                terms.append(&mut product.terms);
                product = Poly::of(std::mem::take(&mut terms));
            }
            if product.terms.len() > TERMS {
                return Err(Reason::Limits("a polynomial"));
            }
        }
        terms.append(&mut product.terms);
        let product = Poly::of(terms);
        if product.size() > TERMS { Err(Reason::Limits("a polynomial")) } else { Ok(product) }
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
        self.terms.iter().map(|(monomial, _)| sign(monomial)).max().unwrap_or(Sign::Nonnegative)
    }

    /// Whether only such variables occur.
    pub(crate) fn is_only_in(&self, allowed: impl Fn(usize) -> bool) -> bool {
        let only =
            |monomial: &Monomial| monomial.iter().enumerate().all(|(index, e)| *e == 0 || allowed(index));
        self.terms.iter().all(|(monomial, _)| only(monomial))
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
            // Among those with the same power the order is that of the rest.
            powers.entry(exponent).or_default().terms.push((rest, value.clone()));
        }
        powers
    }

    pub(crate) fn degree(&self, variable: usize) -> u16 {
        self.terms.iter().filter_map(|(monomial, _)| monomial.get(variable)).max().copied().unwrap_or(0)
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
