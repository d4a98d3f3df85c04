//! What a case of a search is about: a function of an index, or of a member of another family.

use std::fmt;
use std::hash::Hasher;

use crate::analysis::{Extremum, Shape};

use super::candidate::{Candidate, FullKnots};
use super::decide::{Count, local_maxima};
use super::dip::Dip;
use super::members::MemberFunction;
use super::shrink::{shrink, shrink_member};

/// A function of a search.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub enum Subject {
    /// Of an index, in normal form.
    Index(Candidate),
    /// Of a member of another family.
    Member(MemberFunction),
}

impl Subject {
    /// The function of an index.
    #[must_use]
    pub fn candidate(&self) -> Option<&Candidate> {
        match self {
            Self::Index(candidate) => Some(candidate),
            Self::Member(_) => None,
        }
    }

    /// The function of a member of another family.
    #[must_use]
    pub fn member(&self) -> Option<&MemberFunction> {
        match self {
            Self::Index(_) => None,
            Self::Member(function) => Some(function),
        }
    }

    /// The gaps between its own knots.
    #[must_use]
    pub fn gaps(&self) -> &[u64] {
        match self {
            Self::Index(candidate) => candidate.gaps(),
            Self::Member(function) => function.gaps(),
        }
    }

    /// The full knot vector on which it is G_i^k.
    #[must_use]
    pub fn full_knots(&self) -> FullKnots {
        FullKnots::of(self.gaps())
    }

    /// How many local maxima it has.
    ///
    /// # Errors
    /// Why that is not decided, as [`MemberFunction::local_maxima`]; for an index it always is.
    pub fn local_maxima(&self) -> Result<Count, String> {
        match self {
            Self::Index(candidate) => Ok(local_maxima(candidate)),
            Self::Member(function) => function.local_maxima(),
        }
    }

    /// The number of local maxima, if it is known.
    pub(super) fn maxima(&self) -> Option<usize> {
        self.local_maxima().ok().map(|count| count.maxima)
    }

    /// Its extrema on the knots t_i = 0, …; none, if its shape is not decided.
    pub(super) fn extrema(&self) -> Vec<Extremum> {
        match self {
            Self::Index(candidate) => Shape::of_local(&candidate.local_knots()).into_extrema(),
            Self::Member(function) => function.shape().map(Shape::into_extrema).unwrap_or_default(),
        }
    }

    /// Its dip; `None` if it has one maximum only.
    #[must_use]
    pub fn dip(&self) -> Option<Dip> {
        Dip::of_turns(self.extrema())
    }

    /// A smaller one, if there is one near, of which as many maxima are known as have the property. It depends on the function and
    /// the property only.
    pub(super) fn shrunk(self, has: impl Fn(usize) -> bool) -> Self {
        match self {
            Self::Index(candidate) => Self::Index(shrink(candidate, |near| has(local_maxima(near).maxima))),
            Self::Member(function) => {
                let known = |near: &MemberFunction| near.local_maxima().is_ok_and(|count| has(count.maxima));
                Self::Member(shrink_member(function, known))
            }
        }
    }

    /// Everything that it depends on, and what came of it: for the digest of a block.
    pub(super) fn digest(&self, position: u64, maxima: u64, exactly: bool, hasher: &mut impl Hasher) {
        // A slope ratio of 0/0 is none.
        let (p, q) = self.candidate().map_or((0, 0), Candidate::ratio);
        let about = [position, p, q, maxima, u64::from(exactly)];
        about.iter().chain(self.gaps()).for_each(|number| hasher.write(&number.to_le_bytes()));
        for number in self.member().into_iter().flat_map(MemberFunction::numbers) {
            let text = number.to_string();
            hasher.write(&(text.len() as u64).to_le_bytes());
            hasher.write(text.as_bytes());
        }
    }
}

/// `gaps (2, 1, 1, 0), α = -3/2`, or with the family and its parameters.
impl fmt::Display for Subject {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let gaps: Vec<_> = self.gaps().iter().map(ToString::to_string).collect();
        write!(f, "gaps ({}), ", gaps.join(", "))?;
        match self {
            Self::Index(candidate) => write!(f, "α = {}", candidate.index()),
            Self::Member(function) => function.fmt(f),
        }
    }
}
