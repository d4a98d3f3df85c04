//! Integers modulo a power of 2^64: for results that are known to fit, whatever leads to them.

use num_bigint::{BigInt, Sign};

use super::words::{OddWord, half_words, halves};

/// An integer modulo 2^(64·L), by its digits to base 2^64 from the lowest; read as one from −2^(64·L − 1) up to
/// 2^(64·L − 1), that end left out.
///
/// Sums and products wrap. Residues are added and multiplied as integers are, so a result is right as soon as it fits
/// itself: a bound is needed for it alone, not for the numbers on the way. Without memory to ask for, and with loops of a
/// known length, this is what an inner loop wants; [`BigInt`] is for everything else.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Limbs<const L: usize>([u64; L]);

impl<const L: usize> Limbs<L> {
    /// 0.
    pub(crate) const ZERO: Self = Self([0; L]);

    /// 1.
    pub(crate) const ONE: Self = {
        let mut digits = [0; L];
        digits[0] = 1;
        Self(digits)
    };

    /// The residue of an integer.
    pub(crate) fn of(value: &BigInt) -> Self {
        // Of −m the digits of m are flipped and 1 is added: without a branch, as signs come in no order that a processor
        // could learn.
        let negative = value.sign() == Sign::Minus;
        let (flip, mut carry) = (if negative { u64::MAX } else { 0 }, negative);
        let mut magnitude = value.iter_u64_digits();
        let mut digits = [0; L];
        for digit in &mut digits {
            (*digit, carry) = (magnitude.next().unwrap_or(0) ^ flip).overflowing_add(u64::from(carry));
        }
        Self(digits)
    }

    /// self + rhs.
    #[inline(always)]
    pub(crate) fn plus(mut self, rhs: Self) -> Self {
        let mut carry = false;
        for (digit, other) in self.0.iter_mut().zip(rhs.0) {
            let (sum, over) = digit.overflowing_add(other);
            let (sum, over_by_carry) = sum.overflowing_add(u64::from(carry));
            (*digit, carry) = (sum, over | over_by_carry);
        }
        self
    }

    /// The bits that are set in one of the two.
    #[inline(always)]
    pub(crate) fn or(mut self, rhs: Self) -> Self {
        for (digit, other) in self.0.iter_mut().zip(rhs.0) {
            *digit |= other;
        }
        self
    }

    /// self + rhs·factor.
    #[inline(always)]
    pub(crate) fn plus_times(mut self, rhs: Self, factor: u64) -> Self {
        let mut carry = 0;
        for (digit, other) in self.0.iter_mut().zip(rhs.0) {
            // At most (2^64 − 1)² + 2·(2^64 − 1) = 2^128 − 1: nothing wraps here.
            let double = (u128::from(other) * u128::from(factor))
                .wrapping_add(u128::from(*digit))
                .wrapping_add(u128::from(carry));
            (*digit, carry) = halves(double);
        }
        self
    }

    /// self − rhs·factor.
    #[inline(always)]
    pub(crate) fn minus_times(mut self, rhs: Self, factor: u64) -> Self {
        let (mut carry, mut borrow) = (0, false);
        for (digit, other) in self.0.iter_mut().zip(rhs.0) {
            let double = (u128::from(other) * u128::from(factor)).wrapping_add(u128::from(carry));
            let (low, high) = halves(double);
            let (rest, under) = digit.overflowing_sub(low);
            let (rest, under_by_borrow) = rest.overflowing_sub(u64::from(borrow));
            (*digit, carry, borrow) = (rest, high, under | under_by_borrow);
        }
        self
    }

    /// The x with x·divisor = self: there is one, as the divisor is odd.
    #[inline(always)]
    pub(crate) fn over(mut self, divisor: OddWord) -> Self {
        let mut borrow = 0;
        for digit in &mut self.0 {
            (*digit, borrow) = divisor.step(*digit, borrow);
        }
        self
    }

    /// The digits, from the lowest: of a number ≥ 0 these are its own.
    #[inline(always)]
    pub(crate) fn digits(&self) -> &[u64; L] {
        &self.0
    }

    /// self·factor.
    #[inline(always)]
    pub(crate) fn times(self, factor: u64) -> Self {
        Self::ZERO.plus_times(self, factor)
    }

    /// −self.
    #[inline(always)]
    pub(crate) fn negate(mut self) -> Self {
        // −x = (2^(64·L) − 1 − x) + 1.
        let mut carry = true;
        for digit in &mut self.0 {
            (*digit, carry) = (!*digit).overflowing_add(u64::from(carry));
        }
        self
    }

    /// self·2^bits, for bits < 64.
    #[inline(always)]
    pub(crate) fn doubled(mut self, bits: u32) -> Self {
        let mut below = 0;
        for digit in &mut self.0 {
            let double = u128::from(*digit) << bits;
            let (low, high) = halves(double);
            (*digit, below) = (low | below, high);
        }
        self
    }

    /// self/2^bits for bits < 64, rounded down.
    #[inline(always)]
    pub(crate) fn halved(mut self, bits: u32) -> Self {
        let mut above = if self.is_negative() { u64::MAX } else { 0 };
        for digit in self.0.iter_mut().rev() {
            let (low, _) = halves(((u128::from(above) << 64) | u128::from(*digit)) >> bits);
            (above, *digit) = (*digit, low);
        }
        self
    }

    /// The lowest 64 bits.
    #[inline(always)]
    pub(crate) fn lowest(&self) -> u64 {
        self.0[0]
    }

    /// The two lowest digits, of a number ≥ 0.
    #[inline(always)]
    pub(crate) fn lowest_two(&self) -> u128 {
        let second = if L > 1 { self.0[1] } else { 0 };
        u128::from(second) << 64 | u128::from(self.0[0])
    }

    /// A number ≥ 0 as an integer of any length.
    pub(crate) fn natural(&self) -> BigInt {
        match self.0.iter().rposition(|digit| *digit != 0) {
            // These take memory for no digit, or for two and no more.
            None | Some(0) => self.0[0].into(),
            Some(1) => self.lowest_two().into(),
            Some(last) => {
                let words = self.0.map(half_words);
                BigInt::from_slice(Sign::Plus, words[..=last].as_flattened())
            }
        }
    }

    /// Is it < 0?
    #[inline(always)]
    pub(crate) fn is_negative(&self) -> bool {
        self.0[L - 1] >> 63 == 1
    }

    /// Is it 0?
    #[inline(always)]
    pub(crate) fn is_zero(&self) -> bool {
        self.0.iter().all(|digit| *digit == 0)
    }

    /// The least b ≥ 0 with |self| < 2^b.
    pub(crate) fn bits(self) -> u64 {
        let magnitude = if self.is_negative() { self.negate() } else { self };
        let digits = (0_u64..).step_by(64).zip(magnitude.0).filter(|(_, digit)| *digit != 0);
        digits.map(|(below, digit)| below + 64 - u64::from(digit.leading_zeros())).last().unwrap_or(0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use num_integer::Integer;
    use num_traits::{One, Signed};
    use proptest::prelude::*;

    impl<const L: usize> Limbs<L> {
        /// The one number with this residue that fits with its sign.
        fn value(self) -> BigInt {
            let modulus = BigInt::one() << (64 * L);
            let value = self.0.iter().rev().fold(BigInt::ZERO, |value, digit| (value << 64) + digit);
            if self.is_negative() { value - modulus } else { value }
        }
    }

    /// Up to 4 digits that are often all zeros or all ones, with either sign.
    fn numbers() -> impl Strategy<Value = BigInt> {
        let digit = prop_oneof![Just(0), Just(u32::MAX), Just(1), Just(1 << 31), any::<u32>()];
        let sign = prop_oneof![Just(Sign::Minus), Just(Sign::Plus)];
        (sign, prop::collection::vec(digit, 0..8))
            .prop_map(|(sign, digits)| BigInt::from_slice(sign, &digits))
    }

    fn words() -> impl Strategy<Value = u64> {
        prop_oneof![Just(0), Just(1), Just(u64::MAX), Just(1 << 63), any::<u64>()]
    }

    /// The one number that fits into so many digits with its sign and has this residue there.
    fn fitting(value: BigInt, digits: usize) -> BigInt {
        let modulus = BigInt::one() << (64 * digits);
        let rest = value.mod_floor(&modulus);
        if rest >= &modulus >> 1_u32 { rest - modulus } else { rest }
    }

    /// The operations in L digits against those of integers.
    fn agrees<const L: usize>(a: &BigInt, b: &BigInt, word: u64, bits: u32) {
        let [x, y] = [a, b].map(Limbs::<L>::of);
        let of = |value| fitting(value, L);
        let own = x.value();
        assert_eq!(own, of(a.clone()));
        assert_eq!(x.plus(y).value(), of(a + b));
        assert_eq!(x.or(y).value(), of(a | b));
        assert_eq!(x.plus_times(y, word).value(), of(a + b * word));
        assert_eq!(x.times(word).value(), of(a * word));
        assert_eq!(x.minus_times(y, word).value(), of(a - b * word));
        let odd = word | 1;
        assert_eq!(x.over(OddWord::new(odd)).times(odd), x);
        assert_eq!(x.negate().value(), of(-a));
        assert_eq!(x.doubled(bits).value(), of(a << bits));
        assert_eq!(x.halved(bits).value(), &own >> bits);
        assert_eq!((x.is_zero(), x.is_negative()), (own == BigInt::ZERO, own.is_negative()));
        assert_eq!(BigInt::from(x.lowest()), a.mod_floor(&(BigInt::one() << 64)));
        assert_eq!(x.bits(), own.bits());
        if !x.is_negative() {
            assert_eq!(x.natural(), own);
            assert_eq!(BigInt::from(x.lowest_two()), &own & BigInt::from(u128::MAX));
        }
    }

    proptest! {
        #[test]
        fn residues_are_added_and_multiplied_as_integers(a in numbers(), b in numbers(), word in words(), bits in 0_u32..64) {
            agrees::<1>(&a, &b, word, bits);
            agrees::<2>(&a, &b, word, bits);
            agrees::<3>(&a, &b, word, bits);
            agrees::<5>(&a, &b, word, bits);
        }
    }
}
