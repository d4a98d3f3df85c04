//! Decimal approximations, for reading only.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{Signed, Zero};

/// Significant digits of an approximation.
const DIGITS: i64 = 10;
/// Powers of ten that are written without an exponent.
const PLAIN: std::ops::Range<i64> = -5..DIGITS;

/// The value in decimal, rounded to 10 significant digits, halves away from 0. By way of integers, so that no
/// value is too large or too small.
pub(super) fn approximate(value: &BigRational) -> String {
    if value.is_zero() {
        return "0".to_owned();
    }
    let magnitude = value.abs();
    let mut exponent = leading_power(&magnitude);
    let mut digits = (magnitude * power_of_ten(DIGITS - 1 - exponent)).round().to_integer().to_string();
    if digits.len() as i64 > DIGITS {
        // 9.9999999999 was rounded up to 10.
        exponent += 1;
    }
    digits.truncate(digits.trim_end_matches('0').len());
    let sign = if value.is_negative() { "-" } else { "" };
    format!("{sign}{}", place_point(digits, exponent))
}

/// Digits d₀d₁d₂… as d₀.d₁d₂… · 10^exponent.
fn place_point(mut digits: String, exponent: i64) -> String {
    if !PLAIN.contains(&exponent) {
        if digits.len() > 1 {
            digits.insert(1, '.');
        }
        return format!("{digits}e{exponent}");
    }
    match usize::try_from(exponent) {
        Ok(exponent) if digits.len() > exponent + 1 => {
            digits.insert(exponent + 1, '.');
            digits
        }
        Ok(exponent) => format!("{digits:0<width$}", width = exponent + 1),
        Err(_) => {
            let zeros = usize::try_from(-exponent - 1).unwrap_or(0);
            format!("0.{}{digits}", "0".repeat(zeros))
        }
    }
}

/// The e with 10^e ≤ magnitude < 10^(e+1), for a positive magnitude.
fn leading_power(magnitude: &BigRational) -> i64 {
    let digits = |value: &BigInt| value.to_string().len() as i64;
    let guess = digits(magnitude.numer()) - digits(magnitude.denom());
    if *magnitude >= power_of_ten(guess) { guess } else { guess - 1 }
}

fn power_of_ten(exponent: i64) -> BigRational {
    let power =
        num_traits::pow(BigInt::from(10), usize::try_from(exponent.unsigned_abs()).unwrap_or(usize::MAX));
    let power = BigRational::from_integer(power);
    if exponent < 0 { power.recip() } else { power }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::parse_rational;

    #[test]
    fn values_are_rounded_to_ten_digits() {
        for (value, expected) in [
            ("0", "0"),
            ("1", "1"),
            ("-100", "-100"),
            ("2/3", "0.6666666667"),
            ("-1/3", "-0.3333333333"),
            ("1/1024", "0.0009765625"),
            ("99999999999/10", "1e10"),
            ("9999999999", "9999999999"),
            ("0.99999999999", "1"),
            ("1e-5", "0.00001"),
            ("1e-6", "1e-6"),
            ("123456789012345", "1.23456789e14"),
            ("2e400", "2e400"),
            ("-1.25e-400", "-1.25e-400"),
        ] {
            assert_eq!(approximate(&parse_rational(value).unwrap()), expected, "{value}");
        }
    }
}
