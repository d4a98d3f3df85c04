//! What a second look finds wrong in a result.

use thiserror::Error;

use super::decide::Decided;

/// In what a result is not what comes out of the search.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum Mismatch {
    /// The numbers of cases.
    #[error(
        "it has {} cases decided by intervals, {} exactly, {} with several maxima, and not {}, {}, {}",
        again.by_intervals, again.exactly, again.several, recorded.by_intervals, recorded.exactly, recorded.several
    )]
    Counts {
        /// As the shards say.
        recorded: Decided,
        /// As computed again.
        again: Decided,
    },
    /// The digest.
    #[error("its digest is {again:016x}, and not {recorded:016x}")]
    Digest {
        /// As the shards say.
        recorded: u64,
        /// As computed again.
        again: u64,
    },
    /// A finding that is in no shard.
    #[error("it leads to the function with gaps {gaps}, α = {alpha}, which no shard has found")]
    Missing {
        /// The gaps.
        gaps: String,
        /// α.
        alpha: String,
    },
    /// A finding that does not come from there.
    #[error(
        "it does not lead to the function with gaps {gaps}, α = {alpha}, which is said to be found at position {at}"
    )]
    Invented {
        /// The gaps.
        gaps: String,
        /// α.
        alpha: String,
        /// `found_at`.
        at: u64,
    },
    /// A finding with other numbers.
    #[error(
        "of the function with gaps {gaps}, α = {alpha}, the record is another one: its place, its number of cases, or its proof"
    )]
    Altered {
        /// The gaps.
        gaps: String,
        /// α.
        alpha: String,
    },
}
