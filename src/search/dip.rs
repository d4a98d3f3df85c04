//! How deep a function falls between two of its maxima.

use num_rational::BigRational;

use crate::analysis::{Enclosed, Extremum, ExtremumKind, Shape, decimals_around};
use crate::scalar::integer;

use super::candidate::Candidate;

/// Bounds of the deepest dip of a function, as a share of its largest value.
///
/// At a local minimum m let L and R be the largest values of the function to its left and to its right: the function
/// falls there by min(L, R) − m. The dip is the largest of these falls over the largest value of all; with one maximum
/// there is none.
///
/// ```
/// use knotproof::search::{Candidate, Dip};
///
/// // The smallest function of degree 3 with two maxima: a dip of 10^-7 of its height.
/// let dip = Dip::of(&Candidate::new(vec![2, 1, 1, 0], (3, 5))?).expect("two maxima");
/// assert_eq!(dip.decimal(4), "1.004e-7");
/// # Ok::<(), knotproof::search::CandidateError>(())
/// ```
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Dip {
    /// A decimal of ten digits that is at most the dip.
    pub lo: BigRational,
    /// The next one, or the same if the dip is exactly that.
    pub hi: BigRational,
}

/// The digits of the bounds.
const DIGITS: usize = 10;

/// The dip as a number.
struct Fall {
    turns: Vec<Extremum>,
}

impl Dip {
    /// That of a function; `None` if it has one maximum only.
    #[must_use]
    pub fn of(candidate: &Candidate) -> Option<Self> {
        Self::of_turns(Shape::of_local(&candidate.local_knots()).into_extrema())
    }

    /// That of the function with these extrema, unless their places show already that it is less than `least`.
    pub(super) fn at_least(turns: Vec<Extremum>, least: Option<&BigRational>) -> Option<Self> {
        let (_, hi) = Fall { turns: turns.clone() }.bounds();
        if least.is_some_and(|least| hi < *least) { None } else { Self::of_turns(turns) }
    }

    /// That of the function with these extrema.
    pub(super) fn of_turns(turns: Vec<Extremum>) -> Option<Self> {
        let minimum = turns.iter().any(|turn| turn.kind == ExtremumKind::Minimum);
        let (lo, hi) = minimum.then(|| decimals_around(&mut Fall { turns }, DIGITS))?;
        Some(Self { lo, hi })
    }

    /// As a decimal of so many digits, or as many as the bounds settle.
    #[must_use]
    pub fn decimal(&self, digits: usize) -> String {
        let Self { lo, hi } = self;
        crate::analysis::settled(&mut crate::analysis::Algebraic::between(lo.clone(), hi.clone()), digits)
    }
}

impl Enclosed for Fall {
    fn bounds(&mut self) -> (BigRational, BigRational) {
        let values: Vec<_> = self.turns.iter().map(|turn| &turn.value).collect();
        let is = |at: usize, kind| self.turns[at].kind == kind;
        // The largest value from one turn to another: of their bounds the largest.
        let largest = |from: usize, to: usize| {
            let maxima = || (from..to).filter(|&at| is(at, ExtremumKind::Maximum)).map(|at| values[at]);
            let (lo, hi) = (maxima().map(|(lo, _)| lo).max(), maxima().map(|(_, hi)| hi).max());
            lo.cloned().zip(hi.cloned()).unwrap_or_else(|| (integer(0), integer(0)))
        };
        let mut deepest = (integer(0), integer(0));
        for at in (0..values.len()).filter(|&at| is(at, ExtremumKind::Minimum)) {
            let ((left_lo, left_hi), (right_lo, right_hi)) = (largest(0, at), largest(at, values.len()));
            let (lo, hi) = (left_lo.min(right_lo) - &values[at].1, left_hi.min(right_hi) - &values[at].0);
            deepest = (deepest.0.max(lo), deepest.1.max(hi));
        }
        let (top_lo, top_hi) = largest(0, values.len());
        (deepest.0 / top_hi, deepest.1 / top_lo)
    }

    fn narrow(&mut self) -> bool {
        self.turns.iter_mut().map(Extremum::narrow).filter(|narrowed| *narrowed).count() > 0
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::{Pieces, Shape};
    use crate::scalar::{decimal_neighbours, rational};
    use crate::spline::{Basis, KnotVector};

    /// By the shape on the full knot vector, whose arithmetic is another one, to a width that is far below.
    fn by_shape(candidate: &Candidate) -> (BigRational, BigRational) {
        let full = candidate.full_knots();
        let basis =
            Basis::new(KnotVector::new(full.rational()).unwrap(), candidate.degree(), candidate.index());
        let basis = basis.unwrap();
        let mut shape = Shape::of(&Pieces::of(&basis), full.index);
        shape.refine_to(&rational(1, 10).pow(40));
        let values: Vec<_> = shape.extrema().iter().map(|turn| turn.value.clone()).collect();
        // Two maxima and a minimum.
        let [left, valley, right] = &values[..] else { panic!("{values:?}") };
        let lower = if left.0 < right.0 { left } else { right };
        let higher = if left.0 < right.0 { right } else { left };
        ((&lower.0 - &valley.1) / &higher.1, (&lower.1 - &valley.0) / &higher.0)
    }

    #[test]
    fn the_dip_is_that_of_the_shape() {
        for (gaps, ratio) in
            [(&[2, 1, 1, 0][..], (3, 5)), (&[0, 5, 2, 1], (53, 100)), (&[8, 3, 3, 1, 0], (1, 4))]
        {
            let candidate = Candidate::new(gaps.to_vec(), ratio).unwrap();
            if crate::search::local_maxima(&candidate).maxima != 2 {
                continue;
            }
            let dip = Dip::of(&candidate).unwrap();
            let (lo, hi) = by_shape(&candidate);
            assert!(dip.lo <= lo && hi <= dip.hi, "{gaps:?}");
            assert_eq!(decimal_neighbours(&lo, DIGITS), (dip.lo, dip.hi), "{gaps:?}");
        }
    }

    #[test]
    fn one_maximum_has_no_dip() {
        assert_eq!(Dip::of(&Candidate::new(vec![1, 1, 1, 1], (1, 2)).unwrap()), None);
    }

    #[test]
    fn what_is_less_deep_is_left_out() {
        let candidate = Candidate::new(vec![2, 1, 1, 0], (3, 5)).unwrap();
        let dip = Dip::of(&candidate).unwrap();
        let at_least = |least: Option<&BigRational>| {
            let turns = Shape::of_local(&candidate.local_knots()).into_extrema();
            Dip::at_least(turns, least)
        };
        assert_eq!(at_least(Some(&dip.lo)), Some(dip.clone()));
        assert_eq!(at_least(None), Some(dip));
        assert_eq!(at_least(Some(&rational(1, 100))), None);
    }
}
