//! Numbers as they are written in certificates: fractions of big integers.

use dashu_int::IBig;
use dashu_int::ops::BitTest;

use crate::error::Reason;

/// More digits than this in one number are not read.
const DIGITS: usize = 1_000;
/// A coefficient of more bits than this is given up on.
const BITS: usize = 1 << 20;

/// A fraction, not reduced: its value is never looked at but for its sign.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Ratio {
    pub(crate) num: IBig,
    /// Positive.
    pub(crate) den: IBig,
}

impl Ratio {
    /// `-?digits` or `-?digits/digits`, written in the one way in which it can be.
    pub(crate) fn parse(word: &str) -> Option<Self> {
        let (negative, digits) = match word.strip_prefix('-') {
            Some(rest) => (true, rest),
            None => (false, word),
        };
        let (num, den) = digits.split_once('/').unwrap_or((digits, "1"));
        let (num, den) = (natural(num)?, natural(den)?);
        let whole = !digits.contains('/');
        let zero = num == IBig::ZERO;
        let canonical = whole || (den > IBig::ONE && !zero && coprime(&num, &den));
        (canonical && !(negative && zero)).then(|| Ratio { num: if negative { -num } else { num }, den })
    }

    pub(crate) fn is_zero(&self) -> bool {
        self.num == IBig::ZERO
    }

    pub(crate) fn is_positive(&self) -> bool {
        self.num > IBig::ZERO
    }

    pub(crate) fn zero() -> Self {
        Ratio { num: IBig::ZERO, den: IBig::ONE }
    }

    /// The whole number it is, if it is one that fits.
    pub(crate) fn integer(&self) -> Option<i64> {
        if self.den == IBig::ONE { i64::try_from(&self.num).ok() } else { None }
    }

    pub(crate) fn plus(&self, other: &Self) -> Result<Self, Reason> {
        let num = multiply(&self.num, &other.den)? + multiply(&other.num, &self.den)?;
        Ok(Ratio { num, den: multiply(&self.den, &other.den)? })
    }

    pub(crate) fn minus(&self, other: &Self) -> Result<Self, Reason> {
        self.plus(&Ratio { num: -other.num.clone(), den: other.den.clone() })
    }

    pub(crate) fn times(&self, other: &Self) -> Result<Self, Reason> {
        Ok(Ratio { num: multiply(&self.num, &other.num)?, den: multiply(&self.den, &other.den)? })
    }

    /// The quotient by a number that is not 0.
    pub(crate) fn over(&self, other: &Self) -> Result<Self, Reason> {
        let inverse = Ratio { num: other.den.clone(), den: other.num.clone() };
        let Ratio { num, den } = self.times(&inverse)?;
        Ok(if den < IBig::ZERO { Ratio { num: -num, den: -den } } else { Ratio { num, den } })
    }
}

/// A product that stays within the limits: the big integers would end the program where memory does.
pub(crate) fn multiply(a: &IBig, b: &IBig) -> Result<IBig, Reason> {
    if a.bit_len() + b.bit_len() > BITS { Err(Reason::TooLarge("a number")) } else { Ok(a * b) }
}

pub(crate) fn power(a: &IBig, exponent: u16) -> Result<IBig, Reason> {
    if a.bit_len().saturating_mul(usize::from(exponent)) > BITS {
        return Err(Reason::TooLarge("a number"));
    }
    Ok(a.pow(usize::from(exponent)))
}

fn natural(digits: &str) -> Option<IBig> {
    let plain = !digits.is_empty() && digits.len() <= DIGITS && digits.bytes().all(|b| b.is_ascii_digit());
    if plain && (digits == "0" || !digits.starts_with('0')) { digits.parse().ok() } else { None }
}

/// Euclid, only to see that a number was written in lowest terms.
fn coprime(a: &IBig, b: &IBig) -> bool {
    let (mut a, mut b) = (a.clone(), b.clone());
    while b != IBig::ZERO {
        let rest = &a % &b;
        (a, b) = (b, rest);
    }
    a == IBig::ONE
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_number_can_be_written_in_one_way() {
        for good in ["0", "7", "-7", "1/2", "-3/4", "10/9", "123456789012345678901234567890"] {
            assert!(Ratio::parse(good).is_some(), "{good}");
        }
        for bad in
            ["", "-", "-0", "00", "01", "+1", "1/1", "2/4", "0/3", "1/0", "1/-2", "1/02", "1/", "/2", "1.5"]
        {
            assert!(Ratio::parse(bad).is_none(), "{bad}");
        }
        assert!(Ratio::parse(&"1".repeat(DIGITS + 1)).is_none());
    }

    #[test]
    fn fractions_are_added_and_divided() {
        let of = |word: &str| Ratio::parse(word).unwrap();
        assert!(of("1/2").plus(&of("1/3")).unwrap().minus(&of("5/6")).unwrap().is_zero());
        let quotient = of("1/2").over(&of("-1/3")).unwrap();
        assert!(quotient.den > IBig::ZERO && quotient.plus(&of("3/2")).unwrap().is_zero());
        assert_eq!((of("-4").integer(), of("1/2").integer()), (Some(-4), None));
    }

    #[test]
    fn huge_powers_are_given_up_on() {
        assert!(power(&IBig::from(3), 40).is_ok());
        let long = power(&IBig::from(2), 60_000).unwrap();
        assert!(power(&long, 60_000).is_err() && multiply(&power(&long, 17).unwrap(), &long).is_err());
    }
}
