//! What is searched, as data: degree, cases, and what is looked for.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use thiserror::Error;

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

/// Why there is nothing to search, or too much.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
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
