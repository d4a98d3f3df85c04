//! Floats as text that loses nothing.

/// A finite float as a hexadecimal number, such as `0x1.8p-3` for 3/16: exact, and read back by
/// [`parse_rational`](crate::scalar::parse_rational). An infinite one is `inf`, NaN is `nan`.
///
/// ```
/// use knotproof::float::hexadecimal;
/// use knotproof::scalar::{parse_rational, rational};
///
/// assert_eq!(hexadecimal(0.1875), "0x1.8p-3");
/// assert_eq!(hexadecimal(-5e-324), "-0x0.0000000000001p-1022");
/// assert_eq!(parse_rational(&hexadecimal(0.1875))?, rational(3, 16));
/// # Ok::<(), knotproof::scalar::NumberError>(())
/// ```
#[must_use]
pub fn hexadecimal(value: f64) -> String {
    if !value.is_finite() {
        return value.to_string().to_lowercase();
    }
    let bits = value.to_bits();
    let (biased, fraction) = ((bits >> 52) & 0x7ff, bits & ((1 << 52) - 1));
    let (whole, exponent) = match (biased, fraction) {
        (0, 0) => return "0".to_owned(),
        (0, _) => (0, "-1022".to_owned()),
        _ => (1, if biased < 1023 { format!("-{}", 1023 - biased) } else { (biased - 1023).to_string() }),
    };
    let sign = if value < 0.0 { "-" } else { "" };
    let digits = format!("{fraction:013x}");
    match digits.trim_end_matches('0') {
        "" => format!("{sign}0x{whole}p{exponent}"),
        digits => format!("{sign}0x{whole}.{digits}p{exponent}"),
    }
}
