//! Numbers and names as they are printed.

use crate::scalar::BigRational;
use crate::spline::{Index, KnotVector};

/// A number with a minus sign.
pub(super) fn number(x: &BigRational) -> String {
    x.to_string().replace('-', "−")
}

/// α, as a number or ∞.
pub(super) fn alpha(index: &Index) -> String {
    index.alpha().map_or_else(|| "∞".to_owned(), |alpha| number(&alpha))
}

/// A name with its index below the line: G₀, d₁₂.
pub(super) fn indexed(name: &str, i: usize) -> String {
    let below = |digit: char| digit.to_digit(10).and_then(|digit| char::from_u32(0x2080 + digit));
    let digits: String = i.to_string().chars().filter_map(below).collect();
    format!("{name}{digits}")
}

/// A knot vector with its repeated knots as powers would be written: (0 ×3, 1, 2, 3 ×3).
pub(super) fn knots(knots: &KnotVector) -> String {
    let stops = knots.stop_knots().map(|(t, multiplicity)| match multiplicity {
        1 => number(t),
        _ => format!("{} ×{multiplicity}", number(t)),
    });
    format!("({})", stops.collect::<Vec<_>>().join(", "))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::{integer, rational};

    #[test]
    fn as_it_is_printed() {
        assert_eq!((number(&rational(-1, 7)).as_str(), indexed("d", 13).as_str()), ("−1/7", "d₁₃"));
        assert_eq!(alpha(&Index::infinity()), "∞");
        let vector = KnotVector::new([0, 0, 1, 2, 2, 2].map(integer).to_vec()).unwrap();
        assert_eq!(knots(&vector), "(0 ×2, 1, 2 ×3)");
    }
}
