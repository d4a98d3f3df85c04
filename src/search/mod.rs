//! Floor 5: the search for counterexamples to Conjecture 3.1, over single functions: of an index in normal form, or of another family.
//!
//! A [`Search`] is data: a degree, a [`Goal`] and a [`Space`] of candidates, all within limits or a random sample. Its
//! [`Enumeration`] stand at positions, so a [`Shard`] is a range of them; a [`Portion`] is how far such a shard has come. It
//! runs in parallel, is written to text and read back at any time, and [`merge`]d with the others. Nothing but the
//! search itself has an influence on the result, to the byte.

mod audit;
mod block;
mod candidate;
mod compositions;
mod decide;
mod dip;
mod enumeration;
mod exhaustive;
mod finding;
mod member_cases;
mod members;
mod merge;
mod mismatch;
mod numbers;
mod portion;
mod random;
mod record;
mod shard;
mod shrink;
mod space;
mod subject;
mod sums;
mod undecided;

pub use audit::{Audit, AuditError, Discrepancy, Draw, audit};
pub use block::{Block, BlockRecord};
pub use candidate::{Candidate, CandidateError, FullKnots};
pub use compositions::Compositions;
pub use decide::{Count, Decided, Means, local_maxima};
pub use dip::Dip;
pub use enumeration::Enumeration;
pub use exhaustive::Exhaustive;
pub use finding::{
    DEEPEST_KEPT, EqualRecord, Evidence, ExtremumRecord, Finding, FindingError, FindingRecord, Findings,
};
pub use member_cases::MemberCases;
pub use members::{MemberFunction, Members};
pub use merge::{MergeError, merge};
pub use mismatch::Mismatch;
pub use portion::{Portion, PortionError};
pub use random::Random;
pub use record::{DecidedRecord, RecordError, SummaryRecord};
pub use shard::{Shard, ShardError};
pub use shrink::{shrink, smaller};
pub use space::{
    DEFAULT_SIZE, DEFAULT_SIZE_OF_FAMILY, DEFAULT_SPREAD, FamilySpace, Goal, HIGHEST_DEGREE, IndexSample,
    LARGEST_SIZE, Limits, MemberSpace, Sample, Search, Space, SpaceError, WIDEST_SPREAD,
};
pub use subject::Subject;
pub use undecided::UndecidedRecord;
