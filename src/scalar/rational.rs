//! Exact rational numbers: how to read and write them, and the simplest one in an interval.

use std::collections::VecDeque;

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};
use thiserror::Error;

/// Why a text is not an exact number.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum NumberError {
    /// Nothing there.
    #[error("a number is missing here")]
    Empty,
    /// p/0.
    #[error("`{0}` divides by zero")]
    ZeroDenominator(String),
    /// ±inf or NaN where a finite number is wanted.
    #[error("`{0}` is not a finite number")]
    NotFinite(String),
    /// An exponent that would ask for more digits than any input needs.
    #[error(
        "the exponent in `{0}` is out of range: powers of ten from -400 to 400, of two from -1100 to 1100, which hold every \
         f64; write the digits out for more"
    )]
    Exponent(String),
    /// Anything else.
    #[error("`{0}` is not a number: write 3, -1/2, 0.4, 1e-3 or 0x1.8p-3")]
    Malformed(String),
}

/// The largest exponents that are read, in absolute value: enough for every `f64`, and no text of a few
/// characters can ask for hours.
const DECIMAL_LIMIT: i64 = 400;
const BINARY_LIMIT: i64 = 1100;

/// Reads an exact rational number: `3`, `-1/2`, `0.4` (that is 2/5), `1e-3`, `0x1.8p-3` (a hexadecimal float).
///
/// # Errors
/// [`NumberError`], which quotes the text and says what would be accepted.
///
/// ```
/// # use knotproof::scalar::{parse_rational, rational};
/// assert_eq!(parse_rational("0.4"), Ok(rational(2, 5)));
/// assert_eq!(parse_rational("0x1.8p-3"), Ok(rational(3, 16)));
/// assert!(parse_rational("1/0").is_err());
/// ```
pub fn parse_rational(text: &str) -> Result<BigRational, NumberError> {
    let text = text.trim();
    if text.is_empty() {
        return Err(NumberError::Empty);
    }
    let malformed = || NumberError::Malformed(text.to_owned());
    let (negative, unsigned) = match text.strip_prefix('-') {
        Some(rest) => (true, rest),
        None => (false, text.strip_prefix('+').unwrap_or(text)),
    };
    let lower = unsigned.to_ascii_lowercase();
    if ["inf", "infinity", "nan"].contains(&lower.as_str()) || lower == "∞" {
        return Err(NumberError::NotFinite(text.to_owned()));
    }
    let magnitude = if let Some((numerator, denominator)) = lower.split_once('/') {
        let read = |part: &str| digits(part, 10).filter(|_| !part.is_empty()).ok_or_else(malformed);
        let (numerator, denominator) = (read(numerator)?, read(denominator)?);
        if denominator == BigInt::ZERO {
            return Err(NumberError::ZeroDenominator(text.to_owned()));
        }
        BigRational::new(numerator, denominator)
    } else {
        let read = match lower.strip_prefix("0x") {
            Some(hex) => positional(hex, 16, 'p'),
            None => positional(&lower, 10, 'e'),
        };
        read.ok_or_else(malformed)?.map_err(|ExponentOutOfRange| NumberError::Exponent(text.to_owned()))?
    };
    Ok(if negative { -magnitude } else { magnitude })
}

struct ExponentOutOfRange;

/// `ddd.ddd` in the given base with an optional exponent: of 10 after `e`, of 2 after `p`.
fn positional(text: &str, base: u32, marker: char) -> Option<Result<BigRational, ExponentOutOfRange>> {
    let (mantissa, exponent) = match text.split_once(marker) {
        Some((mantissa, exponent)) => (mantissa, Some(exponent)),
        None => (text, None),
    };
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    if whole.is_empty() && fraction.is_empty() {
        return None;
    }
    let mantissa = digits(&format!("{whole}{fraction}"), base)?;
    let places = u32::try_from(fraction.len()).ok()?;
    let value = BigRational::new(mantissa, BigInt::from(base).pow(places));
    let Some(exponent) = exponent else { return Some(Ok(value)) };
    let unsigned = exponent.strip_prefix(['-', '+']).unwrap_or(exponent);
    if unsigned.is_empty() || !unsigned.bytes().all(|b| b.is_ascii_digit()) {
        return None;
    }
    let (radix, limit) = if marker == 'p' { (2, BINARY_LIMIT) } else { (10, DECIMAL_LIMIT) };
    let exponent = match exponent.parse::<i64>() {
        // By a range: i64::MIN has no absolute value.
        Ok(e) if (-limit..=limit).contains(&e) => i32::try_from(e).ok()?,
        _ => return Some(Err(ExponentOutOfRange)),
    };
    let radix = BigRational::from_integer(BigInt::from(radix));
    Some(Ok(value * num_traits::Pow::pow(radix, exponent)))
}

/// A string of digits, nothing else: no sign, no separator.
fn digits(text: &str, base: u32) -> Option<BigInt> {
    if !text.chars().all(|c| c.is_digit(base)) {
        return None;
    }
    if text.is_empty() { Some(BigInt::ZERO) } else { BigInt::parse_bytes(text.as_bytes(), base) }
}

/// numerator / denominator in lowest terms.
///
/// # Panics
/// If `denominator` is 0: meant for constants.
#[must_use]
pub fn rational(numerator: i64, denominator: i64) -> BigRational {
    BigRational::new(numerator.into(), denominator.into())
}

/// An integer of any type as a rational number.
///
/// ```
/// # use knotproof::scalar::{BigInt, integer, rational};
/// assert_eq!(integer(-1), rational(-1, 1));
/// assert_eq!(integer(BigInt::from(3)), integer(3_usize));
/// ```
#[must_use]
pub fn integer(value: impl Into<BigInt>) -> BigRational {
    BigRational::from_integer(value.into())
}

/// The height of p/q in lowest terms, max(|p|, q): how hard a number is to work with by hand.
#[must_use]
pub fn height(value: &BigRational) -> BigInt {
    value.numer().abs().max(value.denom().clone())
}

/// The rational of least denominator (and then of least numerator) in the open interval (low, high); `high` =
/// `None` stands for +∞. The Stern–Brocot descent, by continued fractions. `None` if the interval is empty.
fn simplest_between(low: &BigRational, high: Option<&BigRational>) -> Option<BigRational> {
    if high.is_some_and(|high| low >= high) {
        return None;
    }
    if low.is_negative() {
        if high.is_none_or(Signed::is_positive) {
            return Some(Zero::zero());
        }
        return simplest_between(&-high?.clone(), Some(&-low)).map(|value| -value);
    }
    let below = low.floor();
    let next = &below + <BigRational as One>::one();
    match high {
        Some(high) if *high <= next => {
            let above = (*low != below).then(|| (low - &below).recip());
            let tail = simplest_between(&(high - &below).recip(), above.as_ref())?;
            Some(below + tail.recip())
        }
        _ => Some(next),
    }
}

/// The rationals of the open interval (low, high), simple ones first: the simplest of all, then the simplest
/// on either side of it, and so on. Never ends for low < high; empty otherwise.
///
/// ```
/// # use knotproof::scalar::{rationals_between, rational};
/// let first: Vec<_> = rationals_between(&rational(0, 1), &rational(1, 1)).take(3).collect();
/// assert_eq!(first, [rational(1, 2), rational(1, 3), rational(2, 3)]);
/// ```
pub fn rationals_between(low: &BigRational, high: &BigRational) -> impl Iterator<Item = BigRational> + use<> {
    let mut intervals = VecDeque::from([(low.clone(), high.clone())]);
    std::iter::from_fn(move || {
        let (low, high) = intervals.pop_front()?;
        let middle = simplest_between(&low, Some(&high))?;
        intervals.push_back((low, middle.clone()));
        intervals.push_back((middle.clone(), high));
        Some(middle)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_read_exactly() {
        for (text, value) in [
            ("3", rational(3, 1)),
            ("-1/2", rational(-1, 2)),
            ("+4/6", rational(2, 3)),
            ("0.4", rational(2, 5)),
            (".5", rational(1, 2)),
            ("5.", rational(5, 1)),
            ("1e-3", rational(1, 1000)),
            ("-2.5E+1", rational(-25, 1)),
            ("0x1.8p-3", rational(3, 16)),
            ("0x.Ap1", rational(5, 4)),
            ("0x10", rational(16, 1)),
        ] {
            assert_eq!(parse_rational(text), Ok(value), "{text}");
        }
    }

    #[test]
    fn what_is_no_number_is_refused() {
        for text in [
            "abc", "-", ".", "1/2/3", "1/-2", "/2", "1/", "1e", "e3", "1e2.5", "0x", "0xg", "1 2", "--1",
            "1_0",
        ] {
            assert!(matches!(parse_rational(text), Err(NumberError::Malformed(_))), "{text}");
        }
        assert_eq!(parse_rational("  "), Err(NumberError::Empty));
        assert!(matches!(parse_rational("1/0"), Err(NumberError::ZeroDenominator(_))));
        assert!(matches!(parse_rational("-inf"), Err(NumberError::NotFinite(_))));
        assert!(matches!(parse_rational("NaN"), Err(NumberError::NotFinite(_))));
        assert!(matches!(parse_rational("1e999999999999"), Err(NumberError::Exponent(_))));
        assert!(matches!(parse_rational("1e99999999999999999999999"), Err(NumberError::Exponent(_))));
    }

    /// At the edges of every integer type that could hold it, and of the limits: no exponent overflows.
    #[test]
    fn exponents_at_every_edge() {
        let edges = [8, 16, 31, 32, 63, 64, 127, 128].map(|bits| BigInt::from(1) << bits);
        let limits = [DECIMAL_LIMIT, BINARY_LIMIT].map(BigInt::from);
        for edge in edges.into_iter().chain(limits) {
            for exponent in [-1_i8, 0, 1].into_iter().flat_map(|step| [&edge + step, -(&edge + step)]) {
                for (mantissa, base, limit) in [("1e", 10, DECIMAL_LIMIT), ("-0x1.8p", 2, BINARY_LIMIT)] {
                    let text = format!("{mantissa}{exponent}");
                    let inside = exponent.magnitude() <= BigInt::from(limit).magnitude();
                    match parse_rational(&text) {
                        Ok(value) => {
                            let unit = parse_rational(mantissa.trim_end_matches(['e', 'p'])).unwrap();
                            let power = num_traits::Pow::pow(integer(base), exponent.clone());
                            assert!(inside && value == unit * power, "{text}");
                        }
                        Err(error) => assert_eq!(error, NumberError::Exponent(text.clone()), "{text}"),
                    }
                }
            }
        }
    }

    #[test]
    fn simple_numbers_come_first_even_in_a_tiny_interval() {
        let tiny = rational(1, i64::MAX);
        let low = rational(1, 3);
        let found = rationals_between(&low, &(&low + &tiny)).next().unwrap();
        assert!(low < found && found < &low + tiny);
        assert_eq!(rationals_between(&rational(-5, 2), &rational(-1, 3)).next(), Some(rational(-1, 1)));
        assert_eq!(rationals_between(&rational(-1, 2), &rational(1, 3)).next(), Some(rational(0, 1)));
        assert_eq!(rationals_between(&rational(1, 2), &rational(1, 2)).next(), None);
    }
}
