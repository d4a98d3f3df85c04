//! What a second look finds wrong in a result.

use thiserror::Error;

use super::decide::Decided;

/// In what a result is not what comes out of the search.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum Mismatch {
    /// The numbers of cases.
    #[error(
        "it has {} cases decided by intervals, {} exactly, {} with several maxima, and not {}, {}, {}{}",
        again.by_intervals, again.exactly, again.several, recorded.by_intervals, recorded.exactly, recorded.several,
        open(*recorded, *again)
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
    #[error("it leads to the function with {function}, which no shard has found")]
    Missing {
        /// Its gaps and weights.
        function: String,
    },
    /// A finding that does not come from there.
    #[error("it does not lead to the function with {function}, which is said to be found at position {at}")]
    Invented {
        /// Its gaps and weights.
        function: String,
        /// `found_at`.
        at: u64,
    },
    /// A finding with other numbers.
    #[error(
        "of the function with {function}, the record is another one: its place, its number of cases, or its proof"
    )]
    Altered {
        /// Its gaps and weights.
        function: String,
    },
    /// Cases that are not decided.
    #[error("the first cases of it that are not decided are others, or for another reason")]
    Undecided,
}

/// The numbers of cases that are not decided, where there are any.
fn open(recorded: Decided, again: Decided) -> String {
    match (recorded.undecided, again.undecided) {
        (0, 0) => String::new(),
        (recorded, again) => format!("; {again} are not decided, and not {recorded}"),
    }
}
