//! The greatest common divisor of integers, by which every fraction comes into lowest terms.

use std::cmp::Ordering;

use num_bigint::{BigInt, BigUint};
use num_traits::{One, ToPrimitive, Zero};

use super::words::half_words;

/// gcd(a, b) ≥ 0; gcd(0, 0) = 0.
///
/// One or two words by halving, more by Lehmer's algorithm: Euclid's steps are found on the leading words, many
/// at a time, and then done at once on all the words (Lehmer 1938; Knuth, The Art of Computer Programming 2,
/// 4.5.2 L), for as long as Collins's condition holds, by which they are right (Jebelean 1993).
pub(crate) fn gcd(a: &BigInt, b: &BigInt) -> BigInt {
    magnitudes(a.magnitude(), b.magnitude()).into()
}

/// The least common multiple ≥ 0; 0 if a or b is 0.
pub(crate) fn lcm(a: &BigInt, b: &BigInt) -> BigInt {
    let (a, b) = (a.magnitude(), b.magnitude());
    if a == b || b.is_one() {
        return a.clone().into();
    }
    let common = magnitudes(a, b);
    if common.is_one() {
        (a * b).into()
    } else if common.is_zero() {
        BigInt::ZERO
    } else {
        (a / common * b).into()
    }
}

fn magnitudes(a: &BigUint, b: &BigUint) -> BigUint {
    let (a, b) = if a.bits() < b.bits() { (b, a) } else { (a, b) };
    if b.is_zero() || b.is_one() {
        return if b.is_zero() { a.clone() } else { b.clone() };
    }
    match (a.to_u128(), b.to_u64()) {
        (Some(a), Some(b)) => two_words(a, b.into()).into(),
        (_, Some(b)) => two_words((a % b).to_u128().unwrap_or(0), b.into()).into(),
        _ if a.bits() - b.bits() >= LEAD => by_words(words(b), words(&(a % b))),
        _ => by_words(words(a), words(b)),
    }
}

/// Where a is longer than b by this many bits, the first quotient is too long to be found on the leading words.
const LEAD: u64 = 30;

/// The binary algorithm (Stein 1967): odd numbers lose their difference's powers of two.
fn one_word(a: u64, b: u64) -> u64 {
    if a == 0 || b == 0 {
        return a | b;
    }
    let shift = (a | b).trailing_zeros();
    let (mut a, mut b) = (a >> a.trailing_zeros(), b >> b.trailing_zeros());
    while a != b {
        let difference = a.abs_diff(b);
        b = a.min(b);
        a = difference >> difference.trailing_zeros();
    }
    a << shift
}

/// The same on two words, for as long as it takes two.
fn two_words(a: u128, b: u128) -> u128 {
    if a == 0 || b == 0 {
        return a | b;
    }
    let (mut a, mut b) = (a, b);
    if let (Ok(a), Ok(b)) = (u64::try_from(a), u64::try_from(b)) {
        return one_word(a, b).into();
    }
    if a.leading_zeros().abs_diff(b.leading_zeros()) >= 16 {
        (a, b) = if a < b { (a, b % a) } else { (b, a % b) };
        if b == 0 {
            return a;
        }
    }
    let shift = (a | b).trailing_zeros();
    a >>= a.trailing_zeros();
    b >>= b.trailing_zeros();
    while a != b {
        if let (Ok(a), Ok(b)) = (u64::try_from(a), u64::try_from(b)) {
            return u128::from(one_word(a, b)) << shift;
        }
        let difference = a.abs_diff(b);
        b = a.min(b);
        a = difference >> difference.trailing_zeros();
    }
    a << shift
}

/// The words of a number from the lowest on, the last one not 0.
type Words = Vec<u64>;

fn words(a: &BigUint) -> Words {
    a.iter_u64_digits().collect()
}

fn number(words: &[u64]) -> BigUint {
    BigUint::new(words.iter().flat_map(|&word| half_words(word)).collect())
}

fn compare(a: &[u64], b: &[u64]) -> Ordering {
    a.len().cmp(&b.len()).then_with(|| a.iter().rev().cmp(b.iter().rev()))
}

fn by_words(mut a: Words, mut b: Words) -> BigUint {
    loop {
        if compare(&a, &b).is_lt() {
            std::mem::swap(&mut a, &mut b);
        }
        if b.is_empty() {
            return number(&a);
        }
        if a.len() <= 2 {
            let value =
                |words: &[u64]| words.iter().rev().fold(0, |value, &word| value << 64 | u128::from(word));
            return two_words(value(&a), value(&b)).into();
        }
        match euclid(leading(&a, a.len(), shift(&a)), leading(&b, a.len(), shift(&a))) {
            Some(steps) => steps.apply(&mut a, &mut b),
            None => {
                let remainder = words(&(number(&a) % number(&b)));
                a = std::mem::replace(&mut b, remainder);
            }
        }
    }
}

/// How far the highest word is from having its highest bit.
fn shift(words: &[u64]) -> u32 {
    words.last().map_or(0, |word| word.leading_zeros())
}

/// The highest word of `words`·2^shift on `length` words.
fn leading(words: &[u64], length: usize, shift: u32) -> u64 {
    let word = |place: usize| words.get(place).copied().unwrap_or(0);
    let (high, next) = (word(length - 1), word(length - 2));
    if shift == 0 { high } else { high << shift | next >> (64 - shift) }
}

/// Some of Euclid's steps, together: (a, b) becomes (p·a + q·b, r·a + s·b).
struct Steps {
    a: (i64, i64),
    b: (i64, i64),
}

/// The steps that are certain for all numbers a ≥ b with these leading words; `None` if not even the first is.
///
/// The quotients are right for as long as Collins's condition holds, and the cofactors are then less than 2³².
fn euclid(mut a: u64, mut b: u64) -> Option<Steps> {
    // b = ±(v·b₀ − u·a₀) for next = (u, v), and last the same for a: the signs alternate.
    let (mut before, mut last, mut next) = ((0, 0), (1, 0), (0, 1));
    let mut negative = true;
    while b >= next.1 && a - b >= last.1 + next.1 {
        let quotient = a / b;
        (a, b) = (b, a % b);
        (before, last, next) = (last, next, (last.0 + quotient * next.0, last.1 + quotient * next.1));
        negative = !negative;
    }
    // The condition was for the step before: the last one is left out.
    let signed = |cofactor: u64, negative| {
        let cofactor = i64::try_from(cofactor).ok()?;
        Some(if negative { -cofactor } else { cofactor })
    };
    let steps = Steps {
        a: (signed(before.0, negative)?, signed(before.1, !negative)?),
        b: (signed(last.0, !negative)?, signed(last.1, negative)?),
    };
    (before.1 != 0).then_some(steps)
}

impl Steps {
    fn apply(&self, a: &mut Words, b: &mut Words) {
        let ((p, q), (r, s)) = (self.a, self.b);
        b.resize(a.len(), 0);
        let (mut first, mut second) = (0_i128, 0_i128);
        for (a, b) in a.iter_mut().zip(b.iter_mut()) {
            let (x, y) = (i128::from(*a), i128::from(*b));
            first += i128::from(p) * x + i128::from(q) * y;
            second += i128::from(r) * x + i128::from(s) * y;
            (*a, *b) = (low_word(first), low_word(second));
            (first, second) = (first >> 64, second >> 64);
        }
        for words in [a, b] {
            while words.last() == Some(&0) {
                words.pop();
            }
        }
    }
}

/// The value modulo 2⁶⁴.
fn low_word(value: i128) -> u64 {
    match u64::try_from(value & i128::from(u64::MAX)) {
        Ok(word) => word,
        Err(_) => unreachable!("64 bits are left"),
    }
}

#[cfg(test)]
mod tests {
    use num_integer::Integer;
    use proptest::prelude::*;

    use super::*;

    fn agree(a: &BigInt, b: &BigInt) {
        for (a, b) in [(a, b), (b, a)] {
            assert_eq!(gcd(a, b), a.gcd(b), "{a} {b}");
            assert_eq!(lcm(a, b), a.lcm(b), "{a} {b}");
        }
    }

    #[test]
    fn numbers_at_the_edges_of_words() {
        let mut numbers = vec![BigInt::ZERO];
        for bits in [0, 1, 31, 32, 63, 64, 65, 127, 128, 129, 191, 192, 256, 1000] {
            let power = BigInt::one() << bits;
            numbers.extend([-1, 0, 1].map(|off| &power + off));
            numbers.extend([3, 5, 15].map(|factor| &power * factor));
        }
        for a in &numbers {
            for b in &numbers {
                agree(a, b);
                agree(&-a, b);
                agree(&(a * 30), &(b * 42));
            }
        }
    }

    /// All quotients are 1: as many steps as there can be.
    #[test]
    fn fibonacci_numbers() {
        let (mut a, mut b) = (BigInt::one(), BigInt::one());
        for _ in 0..2000 {
            (a, b) = (&a + &b, a);
            assert_eq!(gcd(&a, &b), BigInt::one());
        }
        let factor = (BigInt::one() << 200) - 1;
        assert_eq!(gcd(&(&a * &factor), &(&b * &factor)), factor);
    }

    fn number(words: usize) -> impl Strategy<Value = BigInt> {
        // Words of all ones and all zeros are where carries and quotients are at their extremes.
        let word = prop_oneof![any::<u32>(), Just(0), Just(u32::MAX), Just(1)];
        prop::collection::vec(word, 0..=words).prop_map(|words| BigUint::new(words).into())
    }

    proptest! {
        #[test]
        fn the_same_as_by_the_library(a in number(20), b in number(20), common in number(8)) {
            agree(&a, &b);
            agree(&(&a * &common), &(&b * &common));
            agree(&(&a * &b), &b);
        }

        #[test]
        fn of_two_words(a in any::<u128>(), b in any::<u128>(), common in any::<u64>()) {
            agree(&a.into(), &b.into());
            agree(&(BigInt::from(a) * common), &(BigInt::from(b) * common));
            agree(&a.into(), &common.into());
        }
    }
}
