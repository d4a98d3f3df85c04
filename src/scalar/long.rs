//! Polynomials with whole coefficients ≥ 0 of a fixed width, multiplied and divided by linear factors of one word.

use num_bigint::{BigInt, Sign};

use super::limbs::Limbs;
use super::modular::residue_of_digits;
use super::polynomial::Polynomial;
use super::ring::{Additive, ScaleBy};
use super::words::OddWord;

/// Σ c_i u^i with 0 ≤ c_i < 2^(64·L − 1), the last one not 0, unless it is 0 itself.
///
/// Who computes with them knows a bound of the results: sums and products wrap where they do not fit.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct LongPolynomial<const L: usize> {
    coefficients: Vec<Limbs<L>>,
}

/// A product of linear factors of which the coefficients, and the sum of them, fit into one word: a polynomial is multiplied by all
/// of them in one pass.
#[derive(Debug, Clone, Copy)]
struct Chunk {
    coefficients: [u64; Self::MOST + 1],
    degree: usize,
    /// Of the coefficients: the value at u = 1.
    sum: u64,
}

impl Chunk {
    /// So many factors at most.
    const MOST: usize = 16;

    fn one() -> Self {
        let mut coefficients = [0; Self::MOST + 1];
        coefficients[0] = 1;
        Self { coefficients, degree: 0, sum: 1 }
    }

    /// Times a + bu, if that fits.
    #[inline]
    fn times(&self, (a, b): (u64, u64)) -> Option<Self> {
        if self.degree == Self::MOST {
            return None;
        }
        let sum = self.sum.checked_mul(a.checked_add(b)?)?;
        let mut product = Self { sum, ..*self };
        if b != 0 {
            product.degree += 1;
        }
        // No coefficient is larger than the sum.
        for i in (1..=product.degree).rev() {
            product.coefficients[i] = self.coefficients[i] * a + self.coefficients[i - 1] * b;
        }
        product.coefficients[0] = self.coefficients[0] * a;
        Some(product)
    }
}

impl<const L: usize> LongPolynomial<L> {
    /// The polynomial 1.
    pub(crate) fn one() -> Self {
        Self { coefficients: vec![Limbs::ONE] }
    }

    /// The coefficients modulo the prime of [`may_vanish`](super::may_vanish).
    pub(crate) fn residues(&self) -> Vec<u64> {
        self.coefficients.iter().map(|c| residue_of_digits(c.digits().iter().copied())).collect()
    }

    /// In integers of any length.
    pub(crate) fn to_polynomial(&self) -> Polynomial<BigInt> {
        let big = |c: &Limbs<L>| {
            let mut bytes = [[0; 8]; L];
            bytes.iter_mut().zip(c.digits()).for_each(|(bytes, digit)| *bytes = digit.to_le_bytes());
            BigInt::from_bytes_le(Sign::Plus, bytes.as_flattened())
        };
        let mut all = self.coefficients.iter().map(big);
        Polynomial::new(all.next().unwrap_or(BigInt::ZERO), all)
    }

    /// In place: self·chunk.
    fn multiply(&mut self, chunk: &Chunk) {
        if chunk.degree == 0 && chunk.sum == 1 {
            return;
        }
        let (length, degree) = (self.coefficients.len(), chunk.degree);
        self.coefficients.resize(length + degree, Limbs::ZERO);
        // From the last one on, so that none is overwritten that is still needed.
        for i in (0..length + degree).rev() {
            let (from, to) = ((i + 1).saturating_sub(length), degree.min(i));
            let terms = chunk.coefficients[from..=to].iter().zip(self.coefficients[..=i - from].iter().rev());
            self.coefficients[i] = terms.fold(Limbs::ZERO, |sum, (factor, c)| sum.plus_times(*c, *factor));
        }
    }

    /// The quotient by a + bu, a and b coprime and not 0: `Some(None)` if it does not divide, `None` if that can't be told in L digits.
    ///
    /// One of a and b is odd, and so a unit modulo 2^(64·L): from that end the coefficients of a quotient are found one by one, and
    /// the last one has to come out. Both sides of self = (a + bu)·quotient are then equal modulo 2^(64·L), and they are equal if
    /// both fit.
    pub(crate) fn divided(&self, (a, b): (u64, u64)) -> Option<Option<Self>> {
        let from_below = a % 2 == 1;
        let (unit, other) = if from_below { (a, b) } else { (b, a) };
        let n = self.coefficients.len() - 1;
        let mut quotient = vec![Limbs::ZERO; n];
        let (mut before, mut longest) = (Limbs::ZERO, 0);
        let unit = OddWord::new(unit);
        for step in 0..n {
            let at = if from_below { step } else { n - step };
            before = self.coefficients[at].minus_times(before, other).over(unit);
            longest = before.bits().max(longest);
            quotient[if from_below { at } else { at - 1 }] = before;
        }
        let last = self.coefficients[if from_below { n } else { 0 }];
        if n == 0 || !last.minus_times(before, other).is_zero() {
            return Some(None);
        }
        let sum = u128::from(a) + u128::from(b);
        let fits = longest + u64::from(128 - sum.leading_zeros()) < 64 * L as u64;
        // A quotient with a coefficient below 0 is none of this type.
        let is_here = fits && quotient.iter().all(|c| !c.is_negative());
        is_here.then_some(Some(Self { coefficients: quotient }))
    }
}

impl<const L: usize> Additive for LongPolynomial<L> {
    #[inline]
    fn accumulate(&mut self, rhs: &Self) {
        if self.coefficients.len() < rhs.coefficients.len() {
            self.coefficients.resize(rhs.coefficients.len(), Limbs::ZERO);
        }
        for (sum, c) in self.coefficients.iter_mut().zip(&rhs.coefficients) {
            *sum = sum.plus(*c);
        }
    }
}

/// Multiplication in place by linear factors, a + bu written (a, b), a + b < 2^64.
impl<const L: usize> ScaleBy<(u64, u64)> for LongPolynomial<L> {
    #[inline]
    fn scale_by<'a>(&mut self, factors: impl Iterator<Item = &'a (u64, u64)>) {
        let mut chunk = Chunk::one();
        for factor in factors {
            chunk = chunk.times(*factor).unwrap_or_else(|| {
                self.multiply(&chunk);
                match Chunk::one().times(*factor) {
                    Some(one) => one,
                    None => unreachable!("a factor fits into a word"),
                }
            });
        }
        self.multiply(&chunk);
    }
}
