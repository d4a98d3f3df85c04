//! Verdicts on sentences, and how far they reach.

use std::fmt;

use serde::{Deserialize, Serialize};

use super::witness::Witness;

/// How far a verdict reaches, weakest first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Scope {
    /// Finitely many exact points.
    Points,
    /// One U, k and α (one a, b, α for a weight); every x.
    Instance,
    /// Every α.
    Alpha,
    /// One k; every U and α.
    Knots,
    /// Every k.
    Degree,
}

impl Scope {
    /// All scopes, weakest first.
    pub const ALL: [Self; 5] = [Self::Points, Self::Instance, Self::Alpha, Self::Knots, Self::Degree];

    /// The name used in reports.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Points => "points",
            Self::Instance => "instance",
            Self::Alpha => "alpha",
            Self::Knots => "knots",
            Self::Degree => "degree",
        }
    }
}

impl fmt::Display for Scope {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// Where a case comes from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Origin {
    /// The engine's enumeration.
    Small,
    /// The paper's illustrations.
    Paper,
    /// Whoever runs the program.
    User,
}

/// Which cases a verdict rests on.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Reach {
    /// Instances of the paper (each U, k and α counts).
    pub instances: usize,
    /// Small cases of the engine's own.
    pub small_cases: usize,
    /// Exact decisions that were made in them.
    pub facts: usize,
    /// The degrees that occur.
    pub degrees: Vec<usize>,
    /// What was found on the way in the cases that have a name, such as certified suprema.
    #[serde(skip_serializing_if = "Vec::is_empty", default)]
    pub remarks: Vec<String>,
    /// The suprema that were compared, on instances with a name: of each kind the greatest.
    #[serde(skip_serializing_if = "Vec::is_empty", default)]
    pub found: Vec<Supremum>,
}

/// A supremum on an instance, between two decimals that are next to each other, or equal if it is one.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Supremum {
    /// The paper's name of the instance.
    pub instance: String,
    /// k.
    pub k: usize,
    /// α, or `inf`.
    pub alpha: String,
    /// Of what, with numbers in the place of names.
    pub term: String,
    /// The decimal below it.
    pub lo: String,
    /// The decimal above it.
    pub hi: String,
}

/// What is known of a sentence.
#[derive(Debug, Clone)]
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
    /// The hypotheses hold in no case: nothing is said.
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
            Self::NotApplicable(_) => "not-applicable",
        }
    }
}
