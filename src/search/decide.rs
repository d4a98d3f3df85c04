//! The number of local maxima of a candidate: the one question that a search asks for every case.

use crate::analysis::{Monotonicity, Route};
use crate::scalar::spend;

use super::candidate::Candidate;

/// How many local maxima there are, and how that was decided.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Count {
    /// The number of local maxima; a plateau counts once.
    pub maxima: usize,
    /// What decided it.
    pub by: Means,
}

/// What decided a case. Either is a proof.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Means {
    /// Intervals around floats, of a proved relative error.
    Intervals,
    /// Exact arithmetic.
    Exact,
}

/// Numbers of cases.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Decided {
    /// Those decided by intervals.
    pub by_intervals: u64,
    /// Those decided in exact arithmetic.
    pub exactly: u64,
    /// Those with more than one local maximum.
    pub several: u64,
    /// Those that are not decided: of an index none is.
    pub undecided: u64,
}

impl Decided {
    /// All of them.
    #[must_use]
    pub fn cases(&self) -> u64 {
        self.by_intervals + self.exactly + self.undecided
    }

    /// The same of numbers that may be any.
    pub(super) fn checked_cases(&self) -> Option<u64> {
        self.by_intervals.checked_add(self.exactly)?.checked_add(self.undecided)
    }

    pub(super) fn add(&mut self, other: Self) {
        self.by_intervals += other.by_intervals;
        self.exactly += other.exactly;
        self.several += other.several;
        self.undecided += other.undecided;
    }
}

/// The number of local maxima: a continuous function that is 0 at both ends has one wherever it stops rising and
/// falls next.
///
/// ```
/// use knotproof::search::{Candidate, local_maxima};
///
/// let candidate = Candidate::new(vec![0, 1, 1, 2], (5, 3))?;
/// assert_eq!(local_maxima(&candidate).maxima, 2);
/// # Ok::<(), knotproof::search::CandidateError>(())
/// ```
#[must_use]
pub fn local_maxima(candidate: &Candidate) -> Count {
    spend();
    let function = Monotonicity::of(&candidate.local_knots());
    let by_intervals = function.spans().iter().all(|span| span.route != Route::Integers);
    let by = if by_intervals { Means::Intervals } else { Means::Exact };
    match function.local_maxima() {
        Some(maxima) => Count { maxima, by },
        None => unreachable!("a candidate is continuous"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::{Pieces, Shape};
    use crate::search::{Enumeration, Goal, Limits, Sample, Search, Space};
    use crate::spline::{Basis, KnotVector};

    /// The shape of the function in the basis on its full knots, from the pieces of the general path.
    fn by_shape(candidate: &Candidate) -> usize {
        let full = candidate.full_knots();
        let knots = KnotVector::new(full.rational()).unwrap();
        let basis = Basis::new(knots, candidate.degree(), candidate.index()).unwrap();
        Shape::of(&Pieces::of(&basis), full.index).local_maxima().count()
    }

    #[test]
    fn the_counts_are_those_of_shapes_on_full_knot_vectors() {
        let mut several = 0;
        for (degree, size, count) in [(1, 6, 20), (2, 6, 20), (3, 7, 60), (4, 6, 40)] {
            let exhaustive = Space::Exhaustive(Limits { size, gap: None, height: None });
            let random = Space::Random(Sample { count, seed: 1, spread: 9 });
            for space in [exhaustive, random] {
                let cases = Enumeration::of(&Search { degree, find: Goal::Several, space }).unwrap();
                for (_, candidate) in cases.between(0..cases.positions()) {
                    let maxima = local_maxima(&candidate).maxima;
                    assert_eq!(maxima, by_shape(&candidate), "{candidate:?}");
                    several += usize::from(maxima > 1);
                }
            }
        }
        assert!(several > 0);
        let three = Candidate::new(
            vec![798_629, 50_969, 15_552_000, 72_327, 2_424_870, 9_185_290],
            (183_588, 1_000_000),
        );
        assert_eq!(local_maxima(&three.unwrap()).maxima, 3);
    }
}
