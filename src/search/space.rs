//! What is searched, as data: degree, cases, and what is looked for.

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use thiserror::Error;

use crate::meaning::MemberError;
use crate::spline::Index;

/// A search: the same three parts always lead to the same result.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Search {
    /// k.
    pub degree: usize,
    /// What is looked for.
    pub find: Goal,
    /// Where.
    pub space: Space,
}

/// What is looked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Goal {
    /// More than one local maximum: counterexamples to `Conj3.1.strong.continuous`.
    Several,
    /// The largest number of local maxima, if it is more than one.
    Most,
    /// Two equal largest maxima: counterexamples to `Conj3.1.weak.continuous`.
    Equal,
    /// The functions that fall deepest between two maxima: the first few by the depth of that fall.
    Deepest,
}

/// The candidates among which it is looked for.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Space {
    /// All normal forms within limits, in their order.
    Exhaustive(Limits),
    /// A random sample.
    Random(Sample),
    /// A random sample of the gaps, with indices that are given.
    Indices(IndexSample),
    /// Functions of a family that has no index.
    Family(FamilySpace),
}

/// Limits on normal forms.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Limits {
    /// The largest size: the sum of the gaps plus the height of α.
    pub size: u64,
    /// The largest gap, if that is limited.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub gap: Option<u64>,
    /// The largest height of α, if that is limited.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub height: Option<u64>,
}

impl Limits {
    /// The largest size, the largest gap and the greatest height, where numbers have one, that there can be.
    ///
    /// # Errors
    /// [`SpaceError`], if nothing is left, or too much.
    pub(super) fn greatest(&self, has_numbers: bool) -> Result<(usize, u64, u64), SpaceError> {
        if self.gap == Some(0) {
            return Err(SpaceError::NoGap);
        }
        if has_numbers && self.height == Some(0) {
            return Err(SpaceError::NoHeight);
        }
        let largest = usize::try_from(self.size).ok().filter(|_| self.size <= LARGEST_SIZE);
        let largest = largest.ok_or(SpaceError::TooLarge(self.size))?;
        let within = |limit: Option<u64>| limit.unwrap_or(self.size).min(self.size);
        Ok((largest, within(self.gap), within(self.height)))
    }
}

/// A random sample: case number c depends on the degree, the spread, the seed and c only.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Sample {
    /// The number of cases.
    pub count: u64,
    /// The seed.
    pub seed: u64,
    /// Gaps differ by factors up to 2^spread.
    pub spread: u64,
}

impl IndexSample {
    /// The indices as a sample has them: in order, each once.
    #[must_use]
    pub fn names(indices: &[Index]) -> Vec<String> {
        let mut indices: Vec<_> = indices.iter().collect();
        indices.sort_by(|a, b| a.ratio().cmp(b.ratio()));
        indices.dedup();
        indices.into_iter().map(ToString::to_string).collect()
    }
}

/// A random sample in which α is one of a list.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct IndexSample {
    /// The indices, each as likely as the others.
    pub alpha: Vec<String>,
    /// The number of cases.
    pub count: u64,
    /// The seed.
    pub seed: u64,
    /// Gaps differ by factors up to 2^spread.
    pub spread: u64,
}

/// Functions of a family that has no index, on their own knots.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FamilySpace {
    /// What names the family on a command line: its name, or its file.
    pub name: String,
    /// What stands in its file.
    pub text: String,
    /// The parameters that are set, each with its numbers as behind `--set`; those by i are on the own knots of a function, from the
    /// first one on.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub set: BTreeMap<String, String>,
    /// Which of its functions.
    pub cases: MemberSpace,
}

/// The functions of a family among which it is looked for.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum MemberSpace {
    /// All within limits, in order of size: the sum of the gaps and of the height − 1 of all numbers that are free.
    Exhaustive(Limits),
    /// A random sample: gaps as for an index, and each free number within its bounds, log-spread around 1 from the nearer one.
    Random(Sample),
}

/// Why there is nothing to search, or too much.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum SpaceError {
    /// k is 0 or too high.
    #[error("{0} is out of range: 1 to {HIGHEST_DEGREE} (every function of degree 0 jumps)")]
    Degree(usize),
    /// No normal form within the limits.
    #[error(
        "no case has a size up to {0} within the limits: the search would be empty; the sizes of degree 1 begin with \
         3, those of all others with 2"
    )]
    Empty(u64),
    /// No gap but 0.
    #[error("a largest gap of 0 leaves no function: its knots would all be equal; allow 1 at least")]
    NoGap,
    /// No α at all.
    #[error("no α has a height of 0, so the search would be empty; allow 1 at least")]
    NoHeight,
    /// Larger than any run could be.
    #[error("{0} is too large: at most {LARGEST_SIZE}")]
    TooLarge(u64),
    /// More positions than can be numbered.
    #[error(
        "the number of cases up to size {0} is too large, 2^63 or more: lower --limit, or limit the gaps or the \
         heights further"
    )]
    TooMany(u64),
    /// A sample of nothing.
    #[error("a sample of 0 cases shows nothing: ask for 1 at least")]
    NoCase,
    /// An index that is none, or whose ratio is too long.
    #[error(
        "an α of a search is less than 0 or greater than 1, or inf, with a numerator and a denominator below 2^32"
    )]
    Index,
    /// No function of a family within the limits.
    #[error(
        "no function of the family has a size up to {0} within the limits: the search would be empty; the size is the \
         sum of the gaps and, over all numbers p/q that are free, of max(|p|, q) − 1"
    )]
    NoMember(u64),
    /// A family that can't be read.
    #[error("the family is not well formed: {0}")]
    Family(String),
    /// A family that has an index.
    #[error(
        "{0} is a family of an index: leave `--family` out, and give indices as --alpha with --count; α = inf is the \
         classical one"
    )]
    OfIndex(String),
    /// A family that is not for all knots.
    #[error(
        "the family {family} is for knots that are {knots}, and a search goes through functions on all knots: use a \
         family without `knots`"
    )]
    SpecialKnots {
        /// The family.
        family: String,
        /// The adjective.
        knots: &'static str,
    },
    /// A parameter for which no number is found.
    #[error("no number is found that `{head}` may be: its bounds are `{says}`")]
    NoNumber {
        /// The parameter.
        head: String,
        /// Its bounds.
        says: String,
    },
    /// Something else than numbers.
    #[error("{name}: {why}")]
    Setting {
        /// The name.
        name: String,
        /// What is wrong.
        why: String,
    },
    /// More numbers or fewer than the functions have.
    #[error(
        "`{head}` needs {needs} numbers on the knots of one function, from its first knot on; leave it out, if it \
         shall be searched as well"
    )]
    Numbers {
        /// The parameter.
        head: String,
        /// How many, row by row.
        needs: String,
    },
    /// Settings that the family does not have.
    #[error(transparent)]
    Member(#[from] MemberError),
    /// A goal for indices only.
    #[error(
        "two equal maxima are looked for along the index α, which this family does not have: use `several`, `most` or `deepest`"
    )]
    EqualOfFamily,
    /// Gaps that do not fit.
    #[error("{0} is out of range: 1 to {WIDEST_SPREAD}")]
    Spread(u64),
}

/// The highest degree that is searched: one case of it takes about a second in exact arithmetic.
pub const HIGHEST_DEGREE: usize = 16;
/// The largest limit on the size.
pub const LARGEST_SIZE: u64 = 1000;
/// The widest spread of a sample: sums of gaps stay far below 2^63.
pub const WIDEST_SPREAD: u64 = 40;

/// The limit on the size if nothing else is asked for: a second or so up to degree 4.
pub const DEFAULT_SIZE: u64 = 8;
/// The same for a family without an index, which has no fast kernels.
pub const DEFAULT_SIZE_OF_FAMILY: u64 = 5;
/// The spread of random cases if nothing else is asked for.
pub const DEFAULT_SPREAD: u64 = 9;
