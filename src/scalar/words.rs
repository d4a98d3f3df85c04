//! Products of small numbers, as few machine words.

/// The product of numbers that fit into a word each, in words that hold as many of them as they can: a long number is
/// multiplied, or divided, once a word.
#[derive(Debug, Clone)]
pub(crate) struct Words<I> {
    factors: I,
    /// What no longer fitted into the word before.
    next: Option<u64>,
}

impl<I: Iterator<Item = u64>> Words<I> {
    /// The product of the factors, in their order.
    pub(crate) fn of(mut factors: I) -> Self {
        let next = factors.next();
        Self { factors, next }
    }
}

impl<I: Iterator<Item = u64>> Iterator for Words<I> {
    type Item = u64;

    #[inline]
    fn next(&mut self) -> Option<u64> {
        let mut word = self.next.take()?;
        for factor in self.factors.by_ref() {
            match word.checked_mul(factor) {
                Some(product) => word = product,
                None => {
                    self.next = Some(factor);
                    break;
                }
            }
        }
        Some(word)
    }
}

/// (low, high) of low + 2^64·high.
#[allow(clippy::cast_possible_truncation, reason = "the halves are what is asked for")]
#[inline]
pub(crate) fn halves(double: u128) -> (u64, u64) {
    (double as u64, (double >> 64) as u64)
}

/// [low, high] of low + 2^32·high.
#[allow(clippy::cast_possible_truncation, reason = "the halves are what is asked for")]
#[inline]
pub(crate) fn half_words(word: u64) -> [u32; 2] {
    [word as u32, (word >> 32) as u32]
}

/// An odd word as a divisor of long numbers, from their lowest digit (Jebelean 1993).
#[derive(Debug, Clone, Copy)]
pub(crate) struct OddWord {
    value: u64,
    /// Of the value, modulo 2^64.
    inverse: u64,
}

impl OddWord {
    /// The odd `value`.
    #[inline]
    pub(crate) fn new(value: u64) -> Self {
        debug_assert!(value % 2 == 1);
        // Right to 5 bits (3v XOR 2 is v⁻¹ modulo 32), and to twice as many after each step of Newton's.
        let mut inverse = value.wrapping_mul(3) ^ 2;
        for _ in 0..4 {
            inverse = inverse.wrapping_mul(2_u64.wrapping_sub(value.wrapping_mul(inverse)));
        }
        Self { value, inverse }
    }

    /// The word.
    #[inline]
    pub(crate) fn value(&self) -> u64 {
        self.value
    }

    /// The inverse modulo 2^128.
    #[inline]
    pub(crate) fn inverse_of_two_words(&self) -> u128 {
        let inverse = u128::from(self.inverse);
        inverse.wrapping_mul(2_u128.wrapping_sub(inverse.wrapping_mul(self.value.into())))
    }

    /// The next digit of a quotient from the next digit of the dividend, and what is then borrowed from the digit
    /// after it.
    #[inline]
    pub(crate) fn step(&self, digit: u64, borrow: u64) -> (u64, u64) {
        let (rest, below) = digit.overflowing_sub(borrow);
        let quotient = rest.wrapping_mul(self.inverse);
        let (_, high) = halves(u128::from(quotient) * u128::from(self.value));
        (quotient, high + u64::from(below))
    }

    /// A number ≤ value, and 0 or the value only if the value divides the number with these digits, that has the same
    /// greatest common divisor with the value: ± the number over a power of 2, modulo the value.
    #[inline]
    pub(crate) fn residue(&self, digits: &[u64]) -> u64 {
        digits.iter().fold(0, |borrow, digit| self.step(*digit, borrow).1)
    }

    /// A number with the same greatest common divisor with the value as a·b has, as [`residue`](Self::residue).
    #[inline]
    pub(crate) fn times(&self, a: u64, b: u64) -> u64 {
        let (low, high) = halves(u128::from(a) * u128::from(b));
        self.residue(&[low, high])
    }

    /// The greatest common divisor with a number, by halving.
    #[inline]
    pub(crate) fn gcd(&self, number: u64) -> u64 {
        let (mut odd, mut rest) = (self.value, number);
        while rest != 0 {
            rest >>= rest.trailing_zeros();
            (odd, rest) = (odd.min(rest), odd.abs_diff(rest));
        }
        odd
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use num_integer::Integer;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn residues_have_the_same_common_divisors(a in any::<u64>(), b in any::<u64>(), word in any::<u64>(), small in 0_u64..50) {
            for value in [word | 1, 2 * small + 1, u64::MAX, 1] {
                let odd = OddWord::new(value);
                prop_assert_eq!(odd.gcd(a), value.gcd(&a));
                prop_assert_eq!(odd.inverse_of_two_words().wrapping_mul(value.into()), 1);
                let expected = (u128::from(a) * u128::from(b)).gcd(&u128::from(value));
                prop_assert_eq!(u128::from(odd.gcd(odd.times(a, b))), expected);
            }
        }
    }

    #[test]
    fn a_word_is_full_when_the_next_factor_does_not_fit() {
        let words = |factors: &[u64]| Words::of(factors.iter().copied()).collect::<Vec<_>>();
        assert!(words(&[]).is_empty());
        assert_eq!(words(&[7]), [7]);
        assert_eq!(words(&[1 << 32, 1 << 31, 2, 3]), [1 << 63, 6]);
        assert_eq!(words(&[u64::MAX, 1, 2, u64::MAX]), [u64::MAX, 2, u64::MAX]);
        // 0 fits everywhere.
        assert_eq!(words(&[u64::MAX, 0, 5]), [0]);
    }
}
