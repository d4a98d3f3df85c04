//! Certified enclosures of suprema.

use num_rational::BigRational;
use num_traits::Signed;
use thiserror::Error;

use crate::scalar::{Ring, integer, rationals_between};

use super::decision::{Decision, PositivePoint, always_nonnegative};
use super::piece::{Piece, constant};
use super::roots::count_positive_roots;

/// A point of the closed span, in its positive coordinate.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum ClosedCoordinate {
    /// u in [0, ∞).
    Finite(BigRational),
    /// u = ∞, the right end of the span: the limit.
    Infinity,
}

/// lo ≤ sup ≤ hi.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Enclosure {
    /// The value at `at`.
    pub lo: BigRational,
    /// An upper bound: hi − f ≥ 0 was decided on every piece. hi = lo if that value is the supremum.
    pub hi: BigRational,
    /// The position in the list of a piece, and the point of it where lo is taken.
    pub at: (usize, ClosedCoordinate),
}

/// Why there is no enclosure.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
pub enum SupremumError {
    /// An empty list of functions.
    #[error("the supremum over no function at all was asked for")]
    NoPiece,
    /// A tolerance ≤ 0.
    #[error("the tolerance of an enclosure must be positive")]
    Tolerance,
    /// A pole in [0, ∞].
    #[error("function {0} has a pole on the closed span")]
    Pole(usize),
}

/// An enclosure of width ≤ `tolerance` of the supremum of all the functions on [0, ∞], the ends taken as limits.
///
/// For the largest absolute value pass f and −f; for a distance pass its square. The lower end is the value
/// at an actual point. The upper end B is proved by deciding B − f ≥ 0 on (0, ∞), the way all signs are
/// decided here; where that fails, the witness raises the lower end. The values of B that are tried are the
/// simplest ones in the middle third of what is left.
///
/// # Errors
/// [`SupremumError`] for an empty list, a tolerance ≤ 0, or a pole in [0, ∞].
///
/// ```
/// use knotproof::analysis::{ClosedCoordinate, supremum};
/// use knotproof::scalar::{RationalAlgebra, RationalFunction, Ring, rational};
///
/// // 3u/(1 + u³) is largest at u = 1/∛2.
/// let u = RationalFunction::variable(&rational(1, 1));
/// let f = u.times(&u.embed(&rational(3, 1))).over(&u.power(3).plus(&u.one())).unwrap();
/// let enclosure = supremum(&[f.clone()], &rational(1, 1000))?;
/// assert!(enclosure.hi - &enclosure.lo <= rational(1, 1000));
/// // 2·2^(2/3)/2 = 1.587…
/// assert!(enclosure.lo > rational(1586, 1000));
/// assert!(matches!(enclosure.at, (0, ClosedCoordinate::Finite(u)) if f.evaluate(&u) == Some(enclosure.lo)));
/// # Ok::<(), knotproof::analysis::SupremumError>(())
/// ```
pub fn supremum(functions: &[Piece], tolerance: &BigRational) -> Result<Enclosure, SupremumError> {
    if !tolerance.is_positive() {
        return Err(SupremumError::Tolerance);
    }
    let mut best: Option<(BigRational, (usize, ClosedCoordinate))> = None;
    for (position, f) in functions.iter().enumerate() {
        for (value, u) in values_to_begin_with(f).ok_or(SupremumError::Pole(position))? {
            if best.as_ref().is_none_or(|(lo, _)| value > *lo) {
                best = Some((value, (position, u)));
            }
        }
    }
    let (lo, at) = best.ok_or(SupremumError::NoPiece)?;
    let mut enclosure = Enclosure { hi: lo.clone(), lo, at };
    for (position, f) in functions.iter().enumerate() {
        // A function that stays below what is reached already is done with one decision.
        if let Some(above) = witness_above(f, &enclosure.lo) {
            enclosure.raise(position, f, above);
            enclosure.bisect(position, f, tolerance);
        }
    }
    Ok(enclosure)
}

/// f(0), f(∞) and f(1); `None` if f has a pole in [0, ∞].
fn values_to_begin_with(f: &Piece) -> Option<[(BigRational, ClosedCoordinate); 3]> {
    if count_positive_roots(f.denominator()) > 0 {
        return None;
    }
    let at = |u: BigRational| Some((f.evaluate(&u)?, ClosedCoordinate::Finite(u)));
    let end = (f.at_infinity()?, ClosedCoordinate::Infinity);
    Some([at(integer(0))?, at(integer(1))?, end])
}

/// A u with f(u) > bound, if there is one: `None` proves f ≤ bound on (0, ∞).
fn witness_above(f: &Piece, bound: &BigRational) -> Option<BigRational> {
    match always_nonnegative(&constant(bound.clone()).minus(f)) {
        Decision::Holds => None,
        Decision::Fails(PositivePoint::Rational(u)) => Some(u),
        Decision::Fails(PositivePoint::Root(_)) => unreachable!("where it is 0, it is not negative"),
    }
}

impl Enclosure {
    fn raise(&mut self, position: usize, f: &Piece, u: BigRational) {
        if let Some(value) = f.evaluate(&u).filter(|value| *value > self.lo) {
            self.lo = value;
            self.at = (position, ClosedCoordinate::Finite(u));
        }
    }

    /// Brings the upper bound for f to lo + tolerance. f is bounded, so the doubling ends.
    fn bisect(&mut self, position: usize, f: &Piece, tolerance: &BigRational) {
        let mut step = tolerance.clone().max(integer(1));
        let mut bound = loop {
            let candidate = self.lo.ceil() + &step;
            match witness_above(f, &candidate) {
                Some(u) => self.raise(position, f, u),
                None => break candidate,
            }
            step *= integer(2);
        };
        while &bound - &self.lo > *tolerance {
            let third = (&bound - &self.lo) / integer(3);
            let middle = rationals_between(&(&self.lo + &third), &(&bound - &third)).next();
            let Some(middle) = middle else { break };
            match witness_above(f, &middle) {
                Some(u) => self.raise(position, f, u),
                None => bound = middle,
            }
        }
        if bound > self.hi {
            self.hi = bound;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::{RationalAlgebra, RationalFunction, rational};

    fn u() -> Piece {
        RationalFunction::variable(&rational(1, 1))
    }

    #[test]
    fn suprema_at_the_ends_are_exact() {
        let total = u().plus(&u().one());
        let (falling, rising) = (u().one().over(&total).unwrap(), u().over(&total).unwrap());
        let tolerance = rational(1, 10);
        let at = |f: &Piece| supremum(std::slice::from_ref(f), &tolerance).unwrap();
        let one = integer(1);
        let expected = |u| Enclosure { lo: one.clone(), hi: one.clone(), at: (0, u) };
        assert_eq!(at(&falling), expected(ClosedCoordinate::Finite(integer(0))));
        assert_eq!(at(&rising), expected(ClosedCoordinate::Infinity));
        // A constant takes its supremum at the first point that is tried.
        assert_eq!(at(&u().one()), expected(ClosedCoordinate::Finite(integer(0))));
        assert_eq!(at(&u().zero()).hi, integer(0));
        // All values negative.
        assert_eq!(at(&falling.negate()).hi, integer(0));
        assert_eq!(at(&falling.negate().minus(&u().one())).hi, one.negate());
    }

    #[test]
    fn the_largest_of_several_functions_wins() {
        // 2u/(1 + u²) has its maximum 1 at u = 1; 4u/(4 + u²)·c has it at u = 2.
        let two = u().embed(&integer(2));
        let first = u().times(&two).over(&u().times(&u()).plus(&u().one())).unwrap();
        let second = first.scaled_argument(&rational(2, 5)).times(&u().embed(&rational(11, 10)));
        let tolerance = rational(1, 1 << 20);
        let enclosure = supremum(&[first, second.clone(), u().zero()], &tolerance).unwrap();
        assert_eq!(enclosure.at.0, 1);
        assert!(enclosure.lo <= rational(11, 10) && rational(11, 10) <= enclosure.hi);
        assert!(&enclosure.hi - &enclosure.lo <= tolerance);
        let (_, ClosedCoordinate::Finite(at)) = &enclosure.at else { panic!("an inner maximum") };
        assert_eq!(second.evaluate(at), Some(enclosure.lo));
    }

    #[test]
    fn what_has_no_enclosure_is_refused() {
        let pole = u().one().over(&u().minus(&u().one())).unwrap();
        let one = integer(1);
        assert_eq!(supremum(&[], &one), Err(SupremumError::NoPiece));
        assert_eq!(supremum(&[u().one()], &integer(0)), Err(SupremumError::Tolerance));
        assert_eq!(supremum(&[u().one(), pole], &one), Err(SupremumError::Pole(1)));
        assert_eq!(supremum(&[u()], &one), Err(SupremumError::Pole(0)));
        assert_eq!(supremum(&[u().reciprocal().unwrap()], &one), Err(SupremumError::Pole(0)));
    }
}
