//! Powers of two: the scalings that round nothing.

/// e with 2^e ≤ |value| < 2^(e+1), for a finite value ≠ 0, subnormal ones included.
pub(crate) fn exponent(value: f64) -> i32 {
    let biased = |value: f64| i32::try_from((value.to_bits() >> 52) & 0x7ff).unwrap_or(0);
    match biased(value) {
        0 => biased(value * power(64)) - 64 - 1023,
        e => e - 1023,
    }
}

/// 2^e, for −1022 ≤ e ≤ 1023; beyond, the nearest of these.
pub(crate) fn power(e: i32) -> f64 {
    f64::from_bits(u64::from((e.clamp(-1022, 1023) + 1023).unsigned_abs()) << 52)
}

/// value·2^e, for any e; exact unless it leaves the range.
pub(super) fn shifted(value: f64, e: i32) -> f64 {
    // Three steps take the least float to the greatest. More change nothing.
    let mut left = e.clamp(-3066, 3069);
    let mut value = value;
    while left != 0 {
        let step = left.clamp(-1022, 1023);
        value *= power(step);
        left -= step;
    }
    value
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exponents_and_shifts_are_exact() {
        for (value, e) in [(1.0, 0), (1.5, 0), (-2.0, 1), (0.1, -4), (5e-324, -1074), (f64::MAX, 1023)] {
            assert_eq!(exponent(value), e);
            assert!((1.0..2.0).contains(&shifted(value, -e).abs()), "{value:e}");
            assert_eq!(shifted(shifted(value, -e), e).to_bits(), value.to_bits());
        }
        assert_eq!(shifted(f64::MAX, -2097).to_bits(), 2);
        assert_eq!(shifted(1.0, -5000).to_bits(), 0);
    }
}
