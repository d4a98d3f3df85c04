//! The cases of a search, each at a position.

use std::ops::Range;
use std::sync::Arc;

use super::candidate::Candidate;
use super::exhaustive::Exhaustive;
use super::member_cases::MemberCases;
use super::members::Members;
use super::random::Random;
use super::space::{Goal, HIGHEST_DEGREE, Search, Space, SpaceError};
use super::subject::Subject;

/// The cases of a search, in their order. Each stands at a position; shards are ranges of positions.
#[derive(Debug, Clone)]
pub enum Enumeration {
    /// In order of size.
    Exhaustive(Exhaustive),
    /// In the order of their numbers.
    Random(Random),
    /// Those of a family that has no index.
    Members(MemberCases),
}

impl Enumeration {
    /// The cases of the search.
    ///
    /// # Errors
    /// [`SpaceError`], if there is none, or if there are too many; of a family also if it can't be searched.
    ///
    /// ```
    /// use knotproof::search::{Enumeration, Goal, Limits, Search, Space};
    ///
    /// let space = Space::Exhaustive(Limits { size: 4, gap: None, height: None });
    /// let cases = Enumeration::of(&Search { degree: 2, find: Goal::Several, space })?;
    /// let (_, first) = cases.between(0..cases.positions()).next().unwrap();
    /// assert_eq!((first.gaps(), first.index().to_string()), (&[0, 1, 0][..], "-1".to_owned()));
    /// assert_eq!(cases.count(), cases.between(0..cases.positions()).count() as u64);
    /// # Ok::<(), knotproof::search::SpaceError>(())
    /// ```
    pub fn of(search: &Search) -> Result<Self, SpaceError> {
        let degree = search.degree;
        if degree == 0 || degree > HIGHEST_DEGREE {
            return Err(SpaceError::Degree(degree));
        }
        Ok(match &search.space {
            Space::Exhaustive(limits) => Self::Exhaustive(Exhaustive::new(degree, limits)?),
            Space::Random(sample) => Self::Random(Random::new(degree, sample)?),
            Space::Indices(sample) => Self::Random(Random::with_indices(degree, sample)?),
            Space::Family(_) if search.find == Goal::Equal => return Err(SpaceError::EqualOfFamily),
            Space::Family(space) => Self::Members(MemberCases::new(degree, space)?),
        })
    }

    /// The number of positions.
    #[must_use]
    pub fn positions(&self) -> u64 {
        match self {
            Self::Exhaustive(cases) => cases.positions(),
            Self::Random(cases) => cases.cases(),
            Self::Members(cases) => cases.positions(),
        }
    }

    /// The number of cases, known without going through them.
    #[must_use]
    pub fn count(&self) -> u64 {
        match self {
            Self::Exhaustive(cases) => cases.cases(),
            Self::Random(cases) => cases.cases(),
            Self::Members(cases) => cases.cases(),
        }
    }

    /// The candidates at positions in a range, with their positions; none, if the cases are of a family that has no index.
    pub fn between(&self, range: Range<u64>) -> Box<dyn Iterator<Item = (u64, Candidate)> + '_> {
        match self {
            Self::Exhaustive(cases) => Box::new(cases.between(range)),
            Self::Random(cases) => Box::new(cases.between(range)),
            Self::Members(_) => Box::new(std::iter::empty()),
        }
    }

    /// The cases at positions in a range, with their positions.
    pub fn subjects(&self, range: Range<u64>) -> Box<dyn Iterator<Item = (u64, Subject)> + '_> {
        match self {
            Self::Members(cases) => {
                Box::new(cases.between(range).map(|(at, function)| (at, Subject::Member(function))))
            }
            _ => Box::new(self.between(range).map(|(at, candidate)| (at, Subject::Index(candidate)))),
        }
    }

    /// What is set and what is free, if the cases are of a family that has no index.
    #[must_use]
    pub fn members(&self) -> Option<&Arc<Members>> {
        match self {
            Self::Members(cases) => Some(cases.members()),
            Self::Exhaustive(_) | Self::Random(_) => None,
        }
    }
}
