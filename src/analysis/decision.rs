//! Signs on the whole of (0, ∞), decided exactly.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::Signed;

use crate::scalar::{Polynomial, Ring, integer, rationals_between};

use super::integer_polynomial::IntegerPolynomial;
use super::piece::Piece;
use super::roots::{IsolatedRoot, roots_of};
use super::sign::{Sign, sign_changes};

/// The signs of a function on (0, ∞): it is 0 at the roots and nowhere else, unless it is identically 0; its
/// sign is constant on the open intervals between them, of which there is one more than there are roots.
#[derive(Debug, Clone, PartialEq)]
pub struct SignPattern {
    roots: Vec<IsolatedRoot>,
    /// A point of each interval, with the sign there.
    between: Vec<(BigRational, Sign)>,
}

impl SignPattern {
    /// The roots, from left to right: those where the sign changes and those where it does not.
    #[must_use]
    pub fn roots(&self) -> &[IsolatedRoot] {
        &self.roots
    }

    /// For each interval between roots, from left to right, a simple rational u of it and the sign on it. One
    /// interval with [`Sign::Zero`] for the function 0.
    #[must_use]
    pub fn between(&self) -> &[(BigRational, Sign)] {
        &self.between
    }

    /// The roots where the sign changes, with the signs below and above.
    pub fn changes(&self) -> impl Iterator<Item = (Sign, &IsolatedRoot, Sign)> {
        let signs = self.between.windows(2).map(|pair| (pair[0].1, pair[1].1));
        signs.zip(&self.roots).filter(|((below, above), _)| below != above).map(|((b, a), r)| (b, r, a))
    }
}

/// The signs of a polynomial on (0, ∞).
///
/// ```
/// use knotproof::analysis::{Sign, sign_pattern};
/// use knotproof::scalar::{Polynomial, rational};
///
/// // (u − 1)²(u − 3): the double root changes nothing.
/// let p = Polynomial::new(rational(-3, 1), [7, -5, 1].map(|c| rational(c, 1)));
/// let pattern = sign_pattern(&p);
/// let signs: Vec<_> = pattern.between().iter().map(|(_, sign)| *sign).collect();
/// assert_eq!(signs, [Sign::Negative, Sign::Negative, Sign::Positive]);
/// assert_eq!((pattern.roots().len(), pattern.changes().count()), (2, 1));
/// ```
#[must_use]
pub fn sign_pattern(p: &Polynomial<BigRational>) -> SignPattern {
    signs_of(IntegerPolynomial::from_rational(p))
}

/// [`sign_pattern`] of a polynomial that is in integers already.
pub(super) fn signs_of(polynomial: IntegerPolynomial) -> SignPattern {
    let roots = roots_of(polynomial.clone());
    let mut between = Vec::with_capacity(roots.len() + 1);
    let mut low = integer(0);
    for root in &roots {
        let (lo, hi) = root.interval();
        between.push(simple_point(&low, &lo));
        low = hi;
    }
    between.push(if roots.is_empty() { integer(1) } else { low.floor() + integer(1) });
    let with_sign = |u: BigRational| {
        let sign = polynomial.sign_at(u.numer(), u.denom());
        (u, sign)
    };
    SignPattern { roots, between: between.into_iter().map(with_sign).collect() }
}

/// The signs of a polynomial on (0, ∞) from left to right, without repetitions; a single [`Sign::Zero`] for 0.
pub(super) fn sign_sequence(p: &IntegerPolynomial) -> Vec<Sign> {
    let Some(first) = p.coefficients().iter().map(Sign::of).find(|sign| *sign != Sign::Zero) else {
        return vec![Sign::Zero];
    };
    let mut signs = vec![first];
    if sign_changes(p.coefficients()) > 0 {
        let roots = roots_of(p.clone());
        signs.extend(roots.windows(2).map(|pair| {
            // Where two intervals share an end it is no root, and between them there is none.
            let middle = (pair[0].interval().1 + pair[1].interval().0) / BigInt::from(2);
            p.sign_at(middle.numer(), middle.denom())
        }));
        signs.extend(p.coefficients().last().map(Sign::of));
        signs.dedup();
    }
    signs
}

/// A simple rational of [low, high] that is no root: the two are ends of neighbouring isolating intervals, so
/// if they are equal they are none, and otherwise the open interval between them holds none.
fn simple_point(low: &BigRational, high: &BigRational) -> BigRational {
    rationals_between(low, high).next().unwrap_or_else(|| high.clone())
}

/// A point u in (0, ∞).
#[derive(Debug, Clone, PartialEq)]
pub enum PositivePoint {
    /// A rational one.
    Rational(BigRational),
    /// A root of a polynomial.
    Root(IsolatedRoot),
}

/// Whether a statement about all u in (0, ∞) holds.
#[derive(Debug, Clone, PartialEq)]
pub enum Decision {
    /// It does, for every u.
    Holds,
    /// It does not, and here is where: at a simple rational u if there is a rational one, else at a root.
    Fails(PositivePoint),
}

impl Decision {
    /// Does it hold?
    #[must_use]
    pub fn holds(&self) -> bool {
        *self == Self::Holds
    }

    /// A rational u where it fails, if it fails at one.
    #[must_use]
    pub fn failure(self) -> Option<BigRational> {
        match self {
            Self::Fails(PositivePoint::Rational(u)) => Some(u),
            Self::Fails(PositivePoint::Root(_)) | Self::Holds => None,
        }
    }
}

/// f(u) > 0 for all u in (0, ∞)? A pole counts as a failure.
///
/// Coefficients ≥ 0 decide at once; otherwise roots are isolated. A failure where f is 0 at irrational points
/// and positive elsewhere is reported as a root.
#[must_use]
pub fn always_positive(f: &Piece) -> Decision {
    decide(f, |sign| sign == Sign::Positive)
}

/// f(u) ≥ 0 for all u in (0, ∞) where f is defined? The sign is that of numerator times denominator, so a pole
/// without a sign change does no harm.
#[must_use]
pub fn always_nonnegative(f: &Piece) -> Decision {
    decide(f, |sign| sign != Sign::Negative)
}

fn decide(f: &Piece, wanted: impl Fn(Sign) -> bool) -> Decision {
    let nonnegative = |p: &Polynomial<BigRational>| p.coefficients().iter().all(|c| !c.is_negative());
    let fast = nonnegative(f.denominator());
    if fast && nonnegative(f.numerator()) && !f.is_zero() {
        return Decision::Holds;
    }
    let pattern =
        if fast { sign_pattern(f.numerator()) } else { sign_pattern(&f.numerator().times(f.denominator())) };
    let unwanted = pattern.between.into_iter().find(|(_, sign)| !wanted(*sign));
    if let Some((u, _)) = unwanted {
        return Decision::Fails(PositivePoint::Rational(u));
    }
    if wanted(Sign::Zero) {
        return Decision::Holds;
    }
    let mut roots = pattern.roots;
    let rational = roots.iter_mut().find_map(IsolatedRoot::rational);
    match (rational, roots.into_iter().next()) {
        (Some(u), _) => Decision::Fails(PositivePoint::Rational(u)),
        (None, Some(root)) => Decision::Fails(PositivePoint::Root(root)),
        (None, None) => Decision::Holds,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::{RationalFunction, rational};

    fn polynomial(coefficients: &[i64]) -> Polynomial<BigRational> {
        let mut coefficients = coefficients.iter().map(|&c| rational(c, 1));
        Polynomial::new(coefficients.next().unwrap(), coefficients)
    }

    fn piece(numerator: &[i64], denominator: &[i64]) -> Piece {
        RationalFunction::new(&polynomial(numerator), &polynomial(denominator)).unwrap()
    }

    #[test]
    fn positivity_is_decided_both_ways() {
        // u² − u + 1 has a negative coefficient and no real root.
        assert!(always_positive(&piece(&[1, -1, 1], &[1, 1])).holds());
        assert!(always_positive(&piece(&[1, 1], &[1, -1, 1])).holds());
        let fails_at = |f: &Piece| match always_positive(f) {
            Decision::Fails(PositivePoint::Rational(u)) => Some(u),
            _ => None,
        };
        assert_eq!(fails_at(&piece(&[0], &[1])), Some(integer(1)));
        assert_eq!(fails_at(&piece(&[-5, 1], &[1])), Some(integer(1)));
        // Zero at one rational point only: 3.
        assert_eq!(fails_at(&piece(&[9, -6, 1], &[1])), Some(integer(3)));
        assert!(always_nonnegative(&piece(&[9, -6, 1], &[1])).holds());
        assert!(always_nonnegative(&piece(&[0], &[1])).holds());
        // Zero at √2 only, doubly.
        let decision = always_positive(&piece(&[4, 0, -4, 0, 1], &[1]));
        assert!(matches!(decision, Decision::Fails(PositivePoint::Root(_))));
        // Negative between 1 and 2 only.
        let Decision::Fails(PositivePoint::Rational(u)) = always_nonnegative(&piece(&[2, -3, 1], &[1]))
        else {
            panic!("(u − 1)(u − 2) is negative in between");
        };
        assert!(integer(1) < u && u < integer(2));
    }

    #[test]
    fn the_sample_points_are_simple_and_in_order() {
        let pattern = sign_pattern(&polynomial(&[-2, 5, -4, 1]).times(&polynomial(&[-2, 0, 1])));
        let points: Vec<_> = pattern.between().iter().map(|(u, _)| u.clone()).collect();
        assert!(points.windows(2).all(|pair| pair[0] < pair[1]));
        assert_eq!(points.len(), pattern.roots().len() + 1);
        assert_eq!(sign_pattern(&polynomial(&[0])).between(), [(integer(1), Sign::Zero)]);
    }

    #[test]
    fn sign_sequences_leave_out_what_does_not_change() {
        // (u − 1)²(u − 3), and −(u − 1)².
        let signs = |list: &[i64]| {
            sign_sequence(&IntegerPolynomial::primitive(list.iter().map(|&c| c.into()).collect()))
        };
        assert_eq!(signs(&[-3, 7, -5, 1]), [Sign::Negative, Sign::Positive]);
        assert_eq!(signs(&[-1, 2, -1]), [Sign::Negative]);
        assert_eq!(signs(&[0]), [Sign::Zero]);
    }
}
