//! Rational numbers as rounded decimals, for readers: the rounding is exact, the text is not the number.

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{Pow, Signed, Zero};

use super::rational::integer;

/// The value to `significant` decimal digits (one at least), to nearest with ties to even: `0.333`, or
/// `3.33e-17` where plain notation would take more than four zeros behind the point, or more digits than asked for.
///
/// No float is involved: every digit is right. Trailing zeros are kept, so the text shows its precision; 0
/// alone is `0`. [`parse_rational`](super::parse_rational) reads the result back.
///
/// ```
/// # use knotproof::scalar::{decimal, rational};
/// assert_eq!(decimal(&rational(1, 3), 3), "0.333");
/// assert_eq!(decimal(&rational(-2, 1), 3), "-2.00");
/// assert_eq!(decimal(&rational(1, 3 << 50), 4), "2.961e-16");
/// ```
#[must_use]
pub fn decimal(value: &BigRational, significant: usize) -> String {
    if value.is_zero() {
        return "0".to_owned();
    }
    let places = i64::try_from(significant.max(1)).unwrap_or(i64::MAX) - 1;
    let mut exponent = decimal_exponent(value);
    let (numer, denom) = shifted(value, places - exponent);
    let mut digits = round_half_even(&numer.abs(), &denom).to_string();
    if digits.len() > significant.max(1) {
        // 9.99… has become 10.0: one digit too many, and it is a 0.
        digits.pop();
        exponent += 1;
    }
    let sign = if value.is_negative() { "-" } else { "" };
    let with_point = |digits: &str, before: usize| match digits.split_at(before) {
        (whole, "") => whole.to_owned(),
        (whole, fraction) => format!("{whole}.{fraction}"),
    };
    match usize::try_from(exponent) {
        Ok(e) if exponent <= places => format!("{sign}{}", with_point(&digits, e + 1)),
        Err(_) if exponent >= -5 => {
            let zeros = usize::try_from(-exponent).unwrap_or(0);
            format!("{sign}{}", with_point(&format!("{:0>zeros$}{digits}", ""), 1))
        }
        _ => format!("{sign}{}e{exponent}", with_point(&digits, 1)),
    }
}

/// The digits that are settled when no more is known of a number than lo ≤ number ≤ hi: its [`decimal`] to
/// `significant` digits, or to as many as all numbers of [lo, hi] have in common; `None` if that is not even one.
///
/// Rounding keeps the order, so what rounds alike at both ends rounds alike between them.
///
/// ```
/// # use knotproof::scalar::{rational, settled_digits};
/// let (lo, hi) = (rational(3141, 1000), rational(3143, 1000));
/// assert_eq!(settled_digits(&lo, &hi, 10).as_deref(), Some("3.14"));
/// assert_eq!(settled_digits(&lo, &rational(9, 1), 10), None);
/// ```
#[must_use]
pub fn settled_digits(lo: &BigRational, hi: &BigRational, significant: usize) -> Option<String> {
    (1..=significant.max(1)).rev().find_map(|digits| {
        let text = decimal(lo, digits);
        (text == decimal(hi, digits)).then_some(text)
    })
}

/// The largest number with so many significant digits that is at most the value, and the smallest one that is at least
/// it: the value twice, if it is such a number itself.
///
/// ```
/// # use knotproof::scalar::{decimal_neighbours, rational};
/// assert_eq!(decimal_neighbours(&rational(1, 3), 2), (rational(33, 100), rational(34, 100)));
/// assert_eq!(decimal_neighbours(&rational(-1, 4), 2), (rational(-1, 4), rational(-1, 4)));
/// ```
#[must_use]
pub fn decimal_neighbours(value: &BigRational, significant: usize) -> (BigRational, BigRational) {
    if value.is_zero() {
        return (value.clone(), value.clone());
    }
    let places = i64::try_from(significant.max(1)).unwrap_or(i64::MAX) - 1;
    let exponent = decimal_exponent(value) - places;
    let (numer, denom) = shifted(value, -exponent);
    let [below, above] = [numer.div_floor(&denom), numer.div_ceil(&denom)];
    let unit = power_of_ten(exponent);
    (BigRational::from_integer(below) * &unit, BigRational::from_integer(above) * unit)
}

/// e with 10^e ≤ |value| < 10^(e+1), for value ≠ 0.
fn decimal_exponent(value: &BigRational) -> i64 {
    let magnitude = value.abs();
    let bits = |n: &BigInt| i64::try_from(n.bits()).unwrap_or(i64::MAX);
    // log₁₀ 2 ≈ 0.30103 brings us next to the exponent, and comparisons settle it.
    let mut exponent = (bits(value.numer()) - bits(value.denom())).saturating_mul(30_103) / 100_000;
    while magnitude < power_of_ten(exponent) {
        exponent -= 1;
    }
    while magnitude >= power_of_ten(exponent + 1) {
        exponent += 1;
    }
    exponent
}

fn power_of_ten(exponent: i64) -> BigRational {
    integer(10).pow(BigInt::from(exponent))
}

/// value·10^e over a positive denominator, not in lowest terms: these would take longer than all the rest.
fn shifted(value: &BigRational, e: i64) -> (BigInt, BigInt) {
    let (numer, denom, power) =
        (value.numer().clone(), value.denom().clone(), BigInt::from(10).pow(e.unsigned_abs()));
    if e < 0 { (numer, denom * power) } else { (numer * power, denom) }
}

fn round_half_even(numer: &BigInt, denom: &BigInt) -> BigInt {
    let (whole, rest) = numer.div_mod_floor(denom);
    let up = match (rest * 2_u8).cmp(denom) {
        std::cmp::Ordering::Less => false,
        std::cmp::Ordering::Equal => whole.is_odd(),
        std::cmp::Ordering::Greater => true,
    };
    if up { whole + 1_u8 } else { whole }
}

#[cfg(test)]
mod tests {
    use super::super::rational::{parse_rational, rational};
    use super::*;

    #[test]
    fn digits_are_rounded_to_nearest_even() {
        for (text, significant, expected) in [
            ("0", 5, "0"),
            ("1", 1, "1"),
            ("1", 0, "1"),
            ("5/2", 1, "2"),
            ("7/2", 1, "4"),
            ("-1/8", 2, "-0.12"),
            ("999/100", 2, "10"),
            ("0.00999", 2, "0.010"),
            ("123456", 6, "123456"),
            ("123456", 3, "1.23e5"),
            ("999999", 3, "1.00e6"),
            ("0.000012345", 3, "0.0000123"),
            ("0.0000012345", 3, "1.23e-6"),
            ("1e400", 2, "1.0e400"),
            ("-1e-400", 1, "-1e-400"),
        ] {
            assert_eq!(decimal(&parse_rational(text).unwrap(), significant), expected, "{text}");
        }
    }

    #[test]
    fn the_standard_library_agrees_on_floats() {
        for float in [0.1_f64, 1.0 / 3.0, 6.02e23, 1.7e-300, 5e-324, -2.5, 9.999_999_99e9] {
            let exact = super::super::exact_value(float).unwrap();
            let ours = parse_rational(&decimal(&exact, 6)).unwrap();
            assert_eq!(ours, parse_rational(&format!("{float:.5e}")).unwrap(), "{float:e}");
        }
    }

    #[test]
    fn one_significant_digit_of_a_power_of_ten_is_a_one() {
        for e in -30..30 {
            let text = decimal(&power_of_ten(e), 1);
            assert_eq!(parse_rational(&text).unwrap(), power_of_ten(e));
            assert_eq!(decimal_exponent(&(power_of_ten(e) * rational(999, 1000))), e - 1);
        }
    }
}
