//! Angles of which the squared cosine is rational, in degrees.

use std::cmp::Ordering;

use num_bigint::BigInt;
use num_rational::BigRational;

use crate::scalar::{integer, rational};

use super::algebraic::Enclosed;
use super::surd::{FIRST_BITS, root};

/// An angle from 0° to 180° in degrees, by the square of its cosine: known to as many digits as are asked for.
///
/// ```
/// use knotproof::analysis::{Angle, settled};
/// use knotproof::scalar::rational;
///
/// // Between (2, 1) and (1, 0): cos² = 4/5.
/// assert_eq!(settled(&mut Angle::new(rational(4, 5), false), 6), "26.5651");
/// assert_eq!(settled(&mut Angle::new(rational(3, 4), true), 6), "150.000");
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Angle {
    square: BigRational,
    obtuse: bool,
    bits: u64,
}

impl Angle {
    /// The angle with this square of its cosine, 0 ≤ cos² ≤ 1; `obtuse` if the cosine is negative.
    #[must_use]
    pub fn new(cosine_square: BigRational, obtuse: bool) -> Self {
        Self { square: cosine_square, obtuse, bits: FIRST_BITS }
    }

    /// cos².
    #[must_use]
    pub fn cosine_square(&self) -> &BigRational {
        &self.square
    }

    /// Is it more than a right angle?
    #[must_use]
    pub fn is_obtuse(&self) -> bool {
        self.obtuse
    }

    /// How it compares with another one.
    #[must_use]
    pub fn compare(&self, other: &Self) -> Ordering {
        let by_square = other.square.cmp(&self.square);
        let obtuse = if self.obtuse { by_square.reverse() } else { by_square };
        self.obtuse.cmp(&other.obtuse).then(obtuse)
    }

    /// Is it 0?
    #[must_use]
    pub fn is_zero(&self) -> bool {
        !self.obtuse && self.square == integer(1)
    }
}

impl Enclosed for Angle {
    /// Exact for 0°, 30°, 45°, 60°, 90° and what these leave of 180°: by Niven's theorem on the cosine 2cos² − 1 of the
    /// doubled angle, no other one with a rational cos² is a rational number of degrees.
    fn bounds(&mut self) -> (BigRational, BigRational) {
        let (lo, hi) = acute(&self.square, self.bits);
        if self.obtuse { (integer(180) - hi, integer(180) - lo) } else { (lo, hi) }
    }

    fn narrow(&mut self) -> bool {
        self.bits *= 2;
        true
    }
}

fn acute(square: &BigRational, bits: u64) -> (BigRational, BigRational) {
    for (quarters, degrees) in [(4, 0), (3, 30), (2, 45), (1, 60), (0, 90)] {
        if *square == rational(quarters, 4) {
            return (integer(degrees), integer(degrees));
        }
    }
    let rest = integer(1) - square;
    let complement = *square < rest;
    let tangent_square = if complement { square / rest } else { rest / square };
    let (mut lo, mut hi) = root(&tangent_square, bits);
    // The tangent is below 1; from 1/3 on it is brought to at most 1/2, by 45° less.
    let large = lo > rational(1, 3);
    if large {
        let less = |t: BigRational| (integer(1) - &t) / (integer(1) + t);
        (lo, hi) = (less(hi), less(lo));
    }
    let (mut lo, mut hi) = in_degrees(&lo, &hi, bits);
    for (turn, reflected) in [(45, large), (90, complement)] {
        if reflected {
            (lo, hi) = (integer(turn) - hi, integer(turn) - lo);
        }
    }
    (lo, hi)
}

/// Bounds of arctan(t)·180/π for all t of [lo, hi], 0 ≤ lo and hi ≤ 1/2.
fn in_degrees(lo: &BigRational, hi: &BigRational, bits: u64) -> (BigRational, BigRational) {
    let fixed = |t: &BigRational| (t.numer() << bits) / t.denom();
    let (below, above) = (arctangent(&fixed(lo), bits).0, arctangent(&(fixed(hi) + 1), bits).1);
    // Machin: π/4 = 4 arctan(1/5) − arctan(1/239).
    let [fifth, machin] = [5, 239].map(|n| {
        let t = fixed(&rational(1, n));
        (arctangent(&t, bits).0, arctangent(&(t + 1), bits).1)
    });
    let (least, most) = (fifth.0 * 4 - machin.1, fifth.1 * 4 - machin.0);
    (BigRational::new(below * 45, most), BigRational::new(above * 45, least))
}

/// Bounds of arctan(t/2^bits)·2^bits, for 0 ≤ t/2^bits ≤ 1/2 and a little more.
///
/// Its series alternates and its terms fall. Every power is rounded down: it is at most 2 too small, as its error is a quarter of
/// that of the one before, at most 1/2 by the rounded square, and 1. So a term is at most 3 too small, and what is left when the
/// power has become 0 is at most 2.
fn arctangent(t: &BigInt, bits: u64) -> (BigInt, BigInt) {
    let square: BigInt = (t * t) >> bits;
    let (mut power, mut odd, mut sum) = (t.clone(), 1_u64, BigInt::ZERO);
    while power != BigInt::ZERO {
        let term = &power / odd;
        // 1, 5, 9, … are added.
        if odd % 4 == 1 {
            sum += term
        } else {
            sum -= term
        }
        power = (power * &square) >> bits;
        odd += 2;
    }
    let margin = 3 * (odd / 2) + 2;
    let below: BigInt = &sum - margin;
    (below.max(BigInt::ZERO), sum + margin)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::settled;

    /// Between (1, 0) and (along, across).
    fn angle(along: i64, across: i64) -> Angle {
        let square = along * along;
        Angle::new(rational(square, square + across * across), along < 0)
    }

    #[test]
    fn angles_are_right_in_every_octant() {
        let found = [(1, 0), (2, 1), (1, 1), (1, 2), (0, 1), (-1, 2), (-1, 1), (-2, 1), (-1, 0), (1000, 1)];
        let expected = [
            "0",
            "26.5651",
            "45.0000",
            "63.4349",
            "90.0000",
            "116.565",
            "135.000",
            "153.435",
            "180.000",
            "0.0572958",
        ];
        assert_eq!(found.map(|(along, across)| settled(&mut angle(along, across), 6)), expected);
    }

    #[test]
    fn rational_angles_are_known_exactly() {
        for (quarters, degrees) in [(4, 0), (3, 30), (2, 45), (1, 60), (0, 90)] {
            let mut sharp = Angle::new(rational(quarters, 4), false);
            assert_eq!(sharp.bounds(), (integer(degrees), integer(degrees)));
            assert_eq!(Angle::new(rational(quarters, 4), true).bounds().0, integer(180 - degrees));
        }
    }

    /// Bounds hold the number, however many bits they have: the next ones lie within.
    #[test]
    fn bounds_are_nested_and_close_in() {
        for (along, across) in [(3, 1), (3, 2), (7, 20), (-5, 4), (-1, 90), (1 << 20, 1)] {
            let mut angle = angle(along, across);
            angle.bits = 16;
            let mut outer = angle.bounds();
            for _ in 0..6 {
                assert!(angle.narrow());
                let inner = angle.bounds();
                assert!(outer.0 <= inner.0 && inner.0 < inner.1 && inner.1 <= outer.1);
                outer = inner;
            }
            assert!(&outer.1 - &outer.0 < rational(1, 1 << 60));
        }
    }

    /// To 50 digits: arctan(1/2)·180/π.
    #[test]
    fn as_many_digits_as_are_asked_for() {
        let text = settled(&mut angle(2, 1), 50);
        assert_eq!(text, "26.565051177077989351572193720453294671204214299645");
    }
}
