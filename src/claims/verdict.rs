//! Verdicts, and the only ways to earn one.

use std::fmt;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::analysis::{Piece, always_positive};
pub use crate::judge::{Reach, Scope};
use crate::scalar::{BigRational, ExactField, OrderedField};

/// An exact counterexample that a reader can check by hand.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct Witness {
    /// The case and the place in it, as name and exact value, in reading order: `k`, `U`, `α`, `i`, `x`, ….
    pub given: Vec<(String, String)>,
    /// What the claim says there.
    pub claimed: String,
    /// What is so.
    pub found: String,
    /// A command that computes it again, where one does.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub reproduce: Option<String>,
}

/// `k = 1, U = (0, 0, 1, 1), …: the claim says …; but …`
impl fmt::Display for Witness {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let given: Vec<_> = self.given.iter().map(|(name, value)| format!("{name} = {value}")).collect();
        write!(f, "{}: the claim says {}, but {}", given.join(", "), self.claimed, self.found)
    }
}

/// Why a conclusion was not established in a case.
#[derive(Debug, Clone, PartialEq)]
pub enum Stop {
    /// It is false, and here is where.
    Refuted(Box<Witness>),
    /// A limit was hit, named here.
    Undecided(String),
    /// Two ways of computing the same thing disagree: a bug of this program, and no verdict on anything.
    Fault(String),
}

/// What a conclusion comes to in one case: established, or stopped.
pub type Judgement = Result<(), Stop>;

/// The facts that were established on the way to a conclusion.
///
/// Every entry is a decision over an exact field. A float is none, so no computation in floats can add one:
///
/// ```compile_fail
/// # use knotproof::claims::Ledger;
/// Ledger::default().equal(&0.5_f64, &0.5_f64);
/// ```
///
/// while the same line over the rationals compiles:
///
/// ```
/// # use knotproof::claims::Ledger;
/// # use knotproof::scalar::rational;
/// assert!(Ledger::default().equal(&rational(1, 2), &rational(1, 2)));
/// ```
#[derive(Debug, Default, Clone, PartialEq, Eq)]
pub struct Ledger {
    facts: usize,
    remarks: Vec<String>,
}

impl Ledger {
    /// How many facts there are.
    #[must_use]
    pub fn facts(&self) -> usize {
        self.facts
    }

    /// Adds what was found on the way and readers will ask for: a figure, or what was left out. Of the engine's own
    /// small cases it is not kept.
    pub fn remark(&mut self, remark: String) {
        self.remarks.push(remark);
    }

    /// The remarks so far.
    #[must_use]
    pub fn remarks(&self) -> &[String] {
        &self.remarks
    }

    /// Counts the decision; one that fails ends the case, and its count with it.
    fn enter(&mut self, holds: bool) -> bool {
        self.facts += 1;
        holds
    }

    /// left = right: of numbers, or of functions as an identity.
    #[must_use]
    pub fn equal<S: ExactField>(&mut self, left: &S, right: &S) -> bool {
        self.enter(left == right)
    }

    /// left ≠ right.
    #[must_use]
    pub fn differ<S: ExactField>(&mut self, left: &S, right: &S) -> bool {
        self.enter(left != right)
    }

    /// left < right.
    #[must_use]
    pub fn less<S: ExactField + OrderedField>(&mut self, left: &S, right: &S) -> bool {
        self.enter(left < right)
    }

    /// f > 0 on the whole open span.
    #[must_use]
    pub fn positive(&mut self, f: &Piece) -> bool {
        self.enter(always_positive(f).holds())
    }

    /// Two numbers of things agree: a rank and a dimension, a count of maxima and 1.
    #[must_use]
    pub fn count(&mut self, found: usize, expected: usize) -> bool {
        self.enter(found == expected)
    }
}

/// What is known of a statement.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Verdict {
    /// True, as far as the scope says.
    Proved {
        /// How far.
        scope: Scope,
        /// In which cases.
        reach: Reach,
    },
    /// False.
    Refuted(Box<Witness>),
    /// Not settled, with the limit that was hit.
    Undecided(String),
    /// Not a mathematical statement, with the reason.
    NotFormal(String),
    /// The hypotheses do not hold here, or there is nothing to check: nothing is said.
    NotApplicable(String),
}

impl Verdict {
    /// The one-word status used in reports.
    #[must_use]
    pub fn status(&self) -> &'static str {
        match self {
            Self::Proved { .. } => "proved",
            Self::Refuted(_) => "refuted",
            Self::Undecided(_) => "undecided",
            Self::NotFormal(_) => "not-formal",
            Self::NotApplicable(_) => "not-applicable",
        }
    }

    /// The scope of a proof.
    #[must_use]
    pub fn scope(&self) -> Option<Scope> {
        match self {
            Self::Proved { scope, .. } => Some(*scope),
            _ => None,
        }
    }
}

/// Shorthand for the exact numbers in a witness.
pub(super) fn show(value: &BigRational) -> String {
    value.to_string()
}
