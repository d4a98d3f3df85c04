//! Polynomials with whole coefficients ≥ 0 of a fixed width, multiplied and divided by linear factors of one word.

use num_bigint::BigInt;

use super::fixed::Fixed;
use super::limbs::Limbs;
use super::polynomial::Polynomial;
use super::ring::{Additive, ScaleBy};
use super::words::OddWord;

/// Σ c_i u^i with 0 ≤ c_i < 2^(64·L − 1), the last one not 0, unless it is 0 itself.
///
/// Who computes with them knows a bound of the results: sums and products wrap where they do not fit.
#[derive(Debug, PartialEq, Eq)]
pub(crate) struct LongPolynomial<const L: usize> {
    coefficients: Vec<Limbs<L>>,
}

impl<const L: usize> Clone for LongPolynomial<L> {
    /// With as much room to grow.
    fn clone(&self) -> Self {
        let mut coefficients = Vec::with_capacity(self.coefficients.capacity());
        coefficients.extend_from_slice(&self.coefficients);
        Self { coefficients }
    }
    /// In the memory that is there already.
    fn clone_from(&mut self, source: &Self) {
        self.coefficients.clone_from(&source.coefficients);
    }
}

/// A product of linear factors of which the coefficients, and the sum of them, fit into one word: a polynomial is multiplied by all
/// of them in one pass.
#[derive(Debug)]
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

    /// In place: times a + bu, if that fits; if not, `false`, and nothing has changed.
    #[inline]
    fn take(&mut self, (a, b): (u64, u64)) -> bool {
        let sum = match a.checked_add(b).and_then(|sum| self.sum.checked_mul(sum)) {
            Some(sum) if self.degree < Self::MOST => sum,
            _ => return false,
        };
        self.sum = sum;
        // No coefficient is larger than the sum, and so none wraps.
        let mut below = 0_u64;
        for c in &mut self.coefficients[..=self.degree] {
            let raised = below.wrapping_mul(b);
            below = *c;
            *c = c.wrapping_mul(a).wrapping_add(raised);
        }
        if b != 0 {
            self.degree += 1;
            self.coefficients[self.degree] = below.wrapping_mul(b);
        }
        true
    }
}

/// a + bu, a and b coprime and not 0, as what may divide a polynomial.
///
/// One of a and b is odd, and so a unit modulo every power of 2: from that end the coefficients of a quotient are found one by one.
#[derive(Debug, Clone, Copy)]
pub(crate) struct LinearDivisor {
    factor: (u64, u64),
    unit: OddWord,
    other: u64,
    /// −other/unit modulo 2^128: the root, or its inverse.
    ratio: u128,
}

impl LinearDivisor {
    /// From (a, b).
    pub(crate) fn new((a, b): (u64, u64)) -> Self {
        let (unit, other) = if a % 2 == 1 { (a, b) } else { (b, a) };
        let unit = OddWord::new(unit);
        let ratio = unit.inverse_of_two_words().wrapping_mul(other.into()).wrapping_neg();
        Self { factor: (a, b), unit, other, ratio }
    }

    /// (a, b).
    pub(crate) fn factor(&self) -> (u64, u64) {
        self.factor
    }

    /// Is a the unit, by which coefficients of a quotient are found from the constant one on?
    fn begins_below(&self) -> bool {
        self.factor.0 % 2 == 1
    }
}

impl<const L: usize> LongPolynomial<L> {
    /// The polynomial 1, and room for so many coefficients, in its clones too.
    pub(crate) fn one(room: usize) -> Self {
        let mut coefficients = Vec::with_capacity(room.max(1));
        coefficients.push(Limbs::ONE);
        Self { coefficients }
    }

    /// In integers of any length.
    pub(crate) fn to_polynomial(&self) -> Polynomial<BigInt> {
        let mut all = self.coefficients.iter().map(Limbs::natural);
        Polynomial::new(all.next().unwrap_or(BigInt::ZERO), all)
    }

    /// In place: times all factors a + bu, written (a, b), a + b < 2^64.
    #[inline]
    pub(crate) fn multiply(&mut self, factors: impl Iterator<Item = (u64, u64)>) {
        let mut chunk = Chunk::one();
        for factor in factors {
            if !chunk.take(factor) {
                self.multiply_by(&chunk);
                chunk = Chunk::one();
                let fits = chunk.take(factor);
                assert!(fits, "a factor fits into a word");
            }
        }
        self.multiply_by(&chunk);
    }

    fn multiply_by(&mut self, chunk: &Chunk) {
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

    /// Could the divisor divide? If not, it does not.
    pub(crate) fn may_be_divided(&self, divisor: &LinearDivisor) -> bool {
        // What is left of the division, up to a unit, in the two lowest digits of L: Horner's rule.
        let step = |value: u128, c: &Limbs<L>| value.wrapping_mul(divisor.ratio).wrapping_add(c.lowest_two());
        let rest = if divisor.begins_below() {
            self.coefficients.iter().fold(0, step)
        } else {
            self.coefficients.iter().rev().fold(0, step)
        };
        rest == 0
    }

    /// The quotient by a divisor: `Some(None)` if it does not divide, `None` if that can't be told in L digits.
    ///
    /// The last coefficient has to come out. Both sides of self = (a + bu)·quotient are then equal modulo 2^(64·L), and they are
    /// equal if both fit.
    pub(crate) fn divided(&self, divisor: &LinearDivisor) -> Option<Option<Self>> {
        let LinearDivisor { factor: (a, b), unit, other, .. } = *divisor;
        let from_below = divisor.begins_below();
        let n = self.coefficients.len() - 1;
        let mut quotient = vec![Limbs::ZERO; n];
        let (mut before, mut all) = (Limbs::ZERO, Limbs::ZERO);
        for step in 0..n {
            let at = if from_below { step } else { n - step };
            before = self.coefficients[at].minus_times(before, other).over(unit);
            all = all.or(before);
            quotient[if from_below { at } else { at - 1 }] = before;
        }
        let last = self.coefficients[if from_below { n } else { 0 }];
        if n == 0 || !last.minus_times(before, other).is_zero() {
            return Some(None);
        }
        // A quotient with a coefficient below 0 is none of this type.
        let length_of_sum = u64::from(128 - (u128::from(a) + u128::from(b)).leading_zeros());
        let is_here = !all.is_negative() && all.bits() + length_of_sum < 64 * L as u64;
        is_here.then_some(Some(Self { coefficients: quotient }))
    }

    /// The greatest common divisor of a word > 0 and all coefficients.
    pub(crate) fn common_divisor(&self, word: u64) -> u64 {
        let lowest = self.coefficients.iter().fold(word, |bits, c| bits | c.lowest());
        let odd = word >> word.trailing_zeros();
        let mut coefficients = self.coefficients.iter();
        let common = coefficients.try_fold(odd, |common, c| {
            let odd = OddWord::new(common);
            (common != 1).then(|| odd.gcd(odd.residue(c.digits())))
        });
        common.unwrap_or(1) << lowest.trailing_zeros()
    }

    /// In place: divided by a word > 0 that divides all coefficients.
    pub(crate) fn divide(&mut self, word: u64) {
        if word == 1 {
            return;
        }
        let twos = word.trailing_zeros();
        let odd = OddWord::new(word >> twos);
        for c in &mut self.coefficients {
            *c = c.halved(twos).over(odd);
        }
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

/// Multiplication in place by linear factors, a + bu written (a, b), a and b ≥ 0.
impl<const L: usize> ScaleBy<(Fixed<i64>, Fixed<i64>)> for LongPolynomial<L> {
    #[inline]
    fn scale_by<'a>(&mut self, factors: impl Iterator<Item = &'a (Fixed<i64>, Fixed<i64>)>) {
        self.multiply(factors.map(|(a, b)| (a.value().unsigned_abs(), b.value().unsigned_abs())));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use num_integer::Integer;
    use num_traits::ToPrimitive;
    use proptest::prelude::*;

    fn product<const L: usize>(factors: &[(u64, u64)]) -> LongPolynomial<L> {
        let mut product = LongPolynomial::one(1);
        product.multiply(factors.iter().copied());
        product
    }

    /// Ends of factors: often the same, none, powers of 2, or as long as a word with its sum can be.
    fn ends() -> impl Strategy<Value = (u64, u64)> {
        let end = || {
            prop_oneof![
                Just(0),
                Just(1),
                0_u64..4,
                1_u64..100,
                (0_u32..62).prop_map(|e| 1 << e),
                0..=u64::MAX / 2
            ]
        };
        (end(), end()).prop_filter("not 0", |(a, b)| *a > 0 || *b > 0)
    }

    /// Over so many digits as hold them the operations are those on integers of any length.
    fn agree<const L: usize>(
        factors: &[(u64, u64)],
        others: &[(u64, u64)],
        word: u64,
    ) -> Result<(), TestCaseError> {
        let mut by_integers = Polynomial::constant(BigInt::from(1));
        let big: Vec<(BigInt, BigInt)> = factors.iter().map(|(a, b)| ((*a).into(), (*b).into())).collect();
        by_integers.scale_by(big.iter());
        let sum: BigInt = by_integers.coefficients().iter().sum();
        if sum.bits() >= 64 * L as u64 {
            return Ok(());
        }
        let long = product::<L>(factors);
        prop_assert_eq!(long.to_polynomial(), by_integers.clone());

        for (a, b) in factors.iter().chain(others).filter(|(a, b)| *a > 0 && *b > 0) {
            let content = a.gcd(b);
            let divisor = LinearDivisor::new((a / content, b / content));
            // By Horner's rule at −a/b.
            let (mut value, mut power) = (BigInt::ZERO, BigInt::from(1));
            for c in by_integers.coefficients().iter().rev() {
                value = value * -BigInt::from(a / content) + c * &power;
                power *= b / content;
            }
            let divides = value == BigInt::ZERO;
            prop_assert!(!divides || long.may_be_divided(&divisor));
            match long.divided(&divisor) {
                Some(None) => prop_assert!(!divides),
                Some(Some(quotient)) => {
                    prop_assert!(divides);
                    let mut back = quotient.clone();
                    back.multiply(std::iter::once(divisor.factor()));
                    prop_assert_eq!(&back, &long);
                }
                // The quotient by one of several factors > 0 is a product of factors ≥ 0, and there is no doubt about it.
                None => prop_assert!(!factors.contains(&(*a, *b)) || sum.bits() + 64 >= 64 * L as u64),
            }
        }

        let common =
            by_integers.coefficients().iter().fold(BigInt::from(word), |common, c| common.gcd(c)).to_u64();
        prop_assert_eq!(Some(long.common_divisor(word)), common);
        let mut whole = long.clone();
        whole.multiply(std::iter::once((word >> 1 | 1, 0)));
        if (sum * word).bits() < 64 * L as u64 {
            whole.divide(word >> 1 | 1);
            prop_assert_eq!(whole, long);
        }
        Ok(())
    }

    proptest! {
        #[test]
        fn operations_are_those_on_integers(
            factors in prop::collection::vec(ends(), 0..24),
            others in prop::collection::vec(ends(), 0..4),
            word in prop_oneof![1_u64..40, (0_u32..64).prop_map(|e| 1 << e), 1..=u64::MAX],
        ) {
            agree::<1>(&factors, &others, word)?;
            agree::<2>(&factors, &others, word)?;
            agree::<5>(&factors, &others, word)?;
            agree::<12>(&factors, &others, word)?;
        }
    }

    /// 2^128 + 1 + u is 2^128 at −1: nothing in two digits, but not 0.
    #[test]
    fn what_only_seems_to_divide_does_not() {
        let mut sum = product::<3>(&[(1 << 63, 0), (1 << 63, 0), (4, 0)]);
        sum.accumulate(&product(&[(1, 1)]));
        let divisor = LinearDivisor::new((1, 1));
        assert!(sum.may_be_divided(&divisor));
        assert_eq!(sum.divided(&divisor), Some(None));
        // At −2 it is 2^128 − 1.
        assert!(!sum.may_be_divided(&LinearDivisor::new((2, 1))));
    }

    /// (2^n − 1 + u)·(1 + u): for n = 62 a product of 62 bits by 2 is no longer known to fit.
    #[test]
    fn a_quotient_that_may_not_fit_is_left_open() {
        for (bits, settled) in [(61, true), (62, false)] {
            let factors = [((1 << bits) - 1, 1), (1, 1)];
            let quotient = product::<1>(&factors).divided(&LinearDivisor::new((1, 1)));
            assert_eq!(quotient, settled.then(|| Some(product(&factors[..1]))));
        }
    }
}
