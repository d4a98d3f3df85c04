//! Floor 4: the paper's claims and their verdicts.
//!
//! A [`Claim`] is data: a [`Statement`] as printed and, where that fails, an amended one. A statement has
//! hypotheses and a conclusion, which decides one case completely, for every x. One engine ([`judge`]) runs every
//! conclusion over the paper's instances and over small cases in order of size: the first failure is the smallest
//! witness, and a statement that fails nowhere is proved at scope `instance` on the cases it was decided in.
//!
//! One file for each part of the paper holds the conclusions and the claims made of them.

mod approximation;
mod basis;
mod captions;
mod case;
use crate::language as cause;
mod claim;
mod classical;
mod closeness;
mod curve;
mod curve_ends;
mod de_boor_range;
mod definitions;
mod drawn;
mod free_weights;
mod grade;
mod hypothesis;
mod illustrated_bases;
mod illustrated_curves;
mod illustrations;
mod independence;
mod influence;
mod instances;
mod limits;
mod maximum;
mod paper;
mod proofs_steps;
mod questions;
mod reflection;
mod register;
mod regularity;
mod small_cases;
mod statement;
mod steps;
mod symmetric_curves;
mod two_maxima;
mod uses;
mod verdict;
mod weight;
mod weight_effect;

pub use crate::language::{Cause, Severity, Source};
pub use case::{BasisCase, Case, Origin, WeightCase};
pub use claim::{Claim, Form, Judged};
pub use grade::Grade;
pub use hypothesis::{Hypothesis, WeightHypothesis};
pub use illustrations::Illustration;
pub use instances::{Instance, instances, instances_named};
pub use paper::{ARXIV, PaperNumber};
pub(crate) use reflection::Reflection;
pub use register::claims;
pub use small_cases::Cases;
#[cfg(test)]
pub(crate) use statement::Outcome;
pub use statement::{Conclusion, Fault, Sharpness, Statement, judge, judge_by_degree, sharpness};
pub use uses::{USES, Use};
pub use verdict::{Judgement, Ledger, Reach, Scope, Stop, Verdict, Witness};
