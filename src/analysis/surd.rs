//! Square roots of rational numbers, and differences of two.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::Signed;

use crate::scalar::integer;

use super::algebraic::Enclosed;

/// s√|p| − t√|q| for rational p and q with the signs s and t: known to as many digits as are asked for.
///
/// ```
/// use knotproof::analysis::{Surd, settled};
/// use knotproof::scalar::rational;
///
/// assert_eq!(settled(&mut Surd::root(&rational(2, 1)), 12), "1.41421356237");
/// assert_eq!(settled(&mut Surd::difference(&rational(9, 4), &rational(-2, 1)), 6), "2.91421");
/// assert_eq!(settled(&mut Surd::difference(&rational(2, 1), &rational(2, 1)), 6), "0");
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Surd {
    /// What the roots are of, with their signs; not the same number twice with both signs.
    terms: Vec<BigRational>,
    bits: u64,
}

/// Bits of the first bounds.
pub(super) const FIRST_BITS: u64 = 96;

impl Surd {
    /// s√|p| with s the sign of p.
    #[must_use]
    pub fn root(signed_square: &BigRational) -> Self {
        Self { terms: vec![signed_square.clone()], bits: FIRST_BITS }
    }

    /// s√|p| − t√|q|. It is rational only if it is 0 or both roots are: digits settle wherever it is not known exactly.
    #[must_use]
    pub fn difference(p: &BigRational, q: &BigRational) -> Self {
        let terms = if p == q { Vec::new() } else { vec![p.clone(), -q] };
        Self { terms, bits: FIRST_BITS }
    }
}

impl Enclosed for Surd {
    fn bounds(&mut self) -> (BigRational, BigRational) {
        self.terms.iter().fold((integer(0), integer(0)), |(lo, hi), term| {
            let (least, most) = root(&term.abs(), self.bits);
            if term.is_negative() { (lo - most, hi - least) } else { (lo + least, hi + most) }
        })
    }

    fn narrow(&mut self) -> bool {
        self.bits *= 2;
        true
    }
}

/// √q for q ≥ 0, to 2^−bits of itself, or exactly where it is rational: from the integer part of √(numerator·denominator·4^bits).
pub(super) fn root(q: &BigRational, bits: u64) -> (BigRational, BigRational) {
    let square: BigInt = (q.numer() * q.denom()) << (2 * bits);
    let (root, below) = (square.sqrt(), q.denom() << bits);
    let lo = BigRational::new(root.clone(), below.clone());
    let hi = if &root * &root == square { lo.clone() } else { BigRational::new(root + 1, below) };
    (lo, hi)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::settled;
    use crate::scalar::{decimal, rational};

    #[test]
    fn roots_are_exact_where_they_can_be() {
        // Halfway between two decimals of six digits: settled, because it is exact.
        let half = rational(1_000_005, 1_000_000);
        let square = &half * &half;
        assert_eq!(Surd::root(&square).bounds(), (half.clone(), half.clone()));
        assert_eq!(settled(&mut Surd::root(&square), 6), decimal(&half, 6));
        assert_eq!(Surd::root(&-square).bounds().0, -half);
        assert_eq!(Surd::root(&integer(0)).bounds(), (integer(0), integer(0)));
    }

    #[test]
    fn close_roots_are_told_apart() {
        let (one, more) = (integer(1), rational(1 << 40, (1 << 40) - 1));
        // 1 − √(1 + ε) = −ε/2 + …
        let text = settled(&mut Surd::difference(&one, &more), 5);
        assert_eq!(text, "-4.5475e-13");
    }
}
