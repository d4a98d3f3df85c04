//! Natural numbers of any size for numerators: sums, and products with machine words.

use num_bigint::{BigInt, BigUint};

use super::ring::{Additive, ScaleBy};
use super::words::{OddWord, Words, halves};

/// A natural number, by its digits to base 2^64 from the lowest.
///
/// It can do what the recursion without a division asks for, in the memory that it has: be copied over, added to,
/// multiplied by words, and divided by them at the end. [`BigInt`] is for everything else.
#[derive(Debug, Default, PartialEq, Eq)]
pub(crate) struct Natural {
    /// Without leading zeros.
    digits: Vec<u64>,
}

impl Clone for Natural {
    fn clone(&self) -> Self {
        Self { digits: self.digits.clone() }
    }
    fn clone_from(&mut self, source: &Self) {
        self.digits.clear();
        self.digits.extend_from_slice(&source.digits);
    }
}

impl From<u128> for Natural {
    fn from(value: u128) -> Self {
        let mut number = Self::default();
        number.set(value);
        number
    }
}

impl Natural {
    /// self ← value.
    pub(crate) fn set(&mut self, value: u128) {
        let (low, high) = halves(value);
        self.digits.clear();
        self.digits.extend([low, high]);
        self.trim();
    }

    /// The digits to base 2^64, from the lowest, without leading zeros.
    pub(crate) fn digits(&self) -> &[u64] {
        &self.digits
    }

    /// As an integer for everything, by way of a list that can be used again.
    pub(crate) fn to_integer(&self, half_digits: &mut Vec<u32>) -> BigInt {
        if let [low] = self.digits[..] {
            return low.into();
        }
        half_digits.clear();
        half_digits.extend(self.digits.iter().flat_map(|digit| {
            let bytes = digit.to_le_bytes();
            [[bytes[0], bytes[1], bytes[2], bytes[3]], [bytes[4], bytes[5], bytes[6], bytes[7]]]
                .map(u32::from_le_bytes)
        }));
        BigUint::from_slice(half_digits).into()
    }

    /// self ← self·word.
    pub(crate) fn multiply(&mut self, word: u64) {
        let mut carry = 0;
        for digit in &mut self.digits {
            (*digit, carry) = halves(u128::from(*digit) * u128::from(word) + u128::from(carry));
        }
        if carry > 0 {
            self.digits.push(carry);
        } else if word == 0 {
            self.digits.clear();
        }
    }

    /// self ← self/divisor, for a divisor of self.
    pub(crate) fn divide_exactly(&mut self, divisor: &OddWord) {
        let mut borrow = 0;
        for digit in &mut self.digits {
            (*digit, borrow) = divisor.step(*digit, borrow);
        }
        debug_assert!(borrow == 0, "not a divisor");
        self.trim();
    }

    /// The exponent of 2; 0 for 0.
    pub(crate) fn trailing_zeros(&self) -> usize {
        let Some(place) = self.digits.iter().position(|digit| *digit != 0) else { return 0 };
        64 * place + self.digits[place].trailing_zeros() as usize
    }

    /// self ← self/2^shift, rounded down.
    pub(crate) fn shift_right(&mut self, shift: usize) {
        self.digits.drain(..(shift / 64).min(self.digits.len()));
        let bits = shift % 64;
        if bits > 0 {
            for place in 0..self.digits.len() {
                let above = self.digits.get(place + 1).map_or(0, |digit| digit << (64 - bits));
                self.digits[place] = self.digits[place] >> bits | above;
            }
        }
        self.trim();
    }

    fn trim(&mut self) {
        while self.digits.last() == Some(&0) {
            self.digits.pop();
        }
    }
}

impl Additive for Natural {
    fn accumulate(&mut self, rhs: &Self) {
        if self.digits.len() < rhs.digits.len() {
            self.digits.resize(rhs.digits.len(), 0);
        }
        let (low, high) = self.digits.split_at_mut(rhs.digits.len());
        let mut carry = false;
        for (digit, other) in low.iter_mut().zip(&rhs.digits) {
            let (sum, over) = digit.overflowing_add(*other);
            let (sum, over_by_carry) = sum.overflowing_add(u64::from(carry));
            (*digit, carry) = (sum, over | over_by_carry);
        }
        for digit in high {
            if !carry {
                return;
            }
            (*digit, carry) = digit.overflowing_add(1);
        }
        if carry {
            self.digits.push(1);
        }
    }
}

impl ScaleBy<u64> for Natural {
    fn scale_by<'a>(&mut self, factors: impl Iterator<Item = &'a u64>) {
        for word in Words::of(factors.copied()) {
            self.multiply(word);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn natural(value: &BigUint) -> Natural {
        Natural { digits: value.to_u64_digits() }
    }

    fn integer(value: &Natural) -> BigInt {
        value.to_integer(&mut Vec::new())
    }

    /// Digits that are often all zeros or all ones.
    fn numbers() -> impl Strategy<Value = BigUint> {
        let digit = prop_oneof![Just(0), Just(u32::MAX), Just(1), any::<u32>()];
        prop::collection::vec(digit, 0..12).prop_map(BigUint::new)
    }

    fn words() -> impl Strategy<Value = u64> {
        prop_oneof![Just(0), Just(1), Just(u64::MAX), Just(1 << 63), any::<u64>()]
    }

    proptest! {
        #[test]
        fn sums_and_products_are_those_of_integers(a in numbers(), b in numbers(), words in prop::collection::vec(words(), 0..4)) {
            let mut sum = natural(&a);
            sum.accumulate(&natural(&b));
            prop_assert_eq!(integer(&sum), BigInt::from(&a + &b));
            let mut product = natural(&a);
            product.scale_by(words.iter());
            prop_assert_eq!(integer(&product), BigInt::from(words.iter().fold(a, |product, word| product * word)));
            prop_assert!(product.digits.last() != Some(&0), "no leading zeros");
        }

        #[test]
        fn what_was_multiplied_can_be_divided(a in numbers(), word in words(), shift in 0_usize..200) {
            let odd = OddWord::new(word | 1);
            let mut number = natural(&(&a * (word | 1)));
            prop_assert_eq!(odd.residue(number.digits()) % (word | 1), 0);
            number.divide_exactly(&odd);
            prop_assert_eq!(&number, &natural(&a));
            number.shift_right(shift);
            prop_assert_eq!(integer(&number), BigInt::from(&a >> shift));
            prop_assert_eq!(natural(&a).trailing_zeros() as u64, a.trailing_zeros().unwrap_or(0));
        }
    }
}
