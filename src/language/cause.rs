//! Who says a statement, and why a printed one fails.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Who says it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Source {
    /// The paper.
    Paper,
    /// A question that the paper does not ask and its users will: identifiers `X.…`.
    Question,
}

/// How bad it is that a printed statement fails, mildest first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Severity {
    /// An end point of an interval, or a bound of an index.
    Slip,
    /// A hypothesis is missing from the statement, whether or not it stands in the proof.
    Hypothesis,
    /// A reading of a picture, or of a vague word.
    Reading,
    /// The idea fails.
    Serious,
}

/// What stands behind a refutation. Many statements fail by one cause.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Cause {
    /// An interval is given with the wrong end points.
    EndPoints,
    /// φ is taken outside [a, b).
    OutsideInterval,
    /// An end knot occurs more than k + 1 times.
    EndKnots,
    /// A knot inside has a multiplicity greater than k.
    InnerMultiplicity,
    /// An index runs too far.
    IndexRange,
    /// A step of a proof is wrong, while the statement that it is to prove is true.
    ProofStep,
    /// What is said of a picture is not so on the example that it shows.
    Picture,
    /// The words allow more than one reading, and in one of them it fails.
    VagueWords,
    /// What is true of polynomial B-splines fails for finite α: one maximum, which is Conjecture 3.1, and the other
    /// properties that the questions `X.…` ask for.
    Conjecture,
    /// A question of ours whose answer is no for polynomial B-splines too: nothing is lost.
    NeverSo,
}

impl Cause {
    /// The cause in words, as an author would be told.
    #[must_use]
    pub fn words(self) -> &'static str {
        match self {
            Self::EndPoints => "end points of intervals",
            Self::OutsideInterval => "φ outside of [a, b)",
            Self::EndKnots => "end knots that occur more than k + 1 times",
            Self::InnerMultiplicity => "knots inside of multiplicity greater than k",
            Self::IndexRange => "the range of an index",
            Self::ProofStep => "steps of proofs",
            Self::Picture => "readings of pictures",
            Self::VagueWords => "words with more than one reading",
            Self::Conjecture => "the conjecture, and what else holds only for α = ∞",
            Self::NeverSo => "what is not so for α = ∞ either",
        }
    }

    /// The name in JSON.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::EndPoints => "end-points",
            Self::OutsideInterval => "outside-interval",
            Self::EndKnots => "end-knots",
            Self::InnerMultiplicity => "inner-multiplicity",
            Self::IndexRange => "index-range",
            Self::ProofStep => "proof-step",
            Self::Picture => "picture",
            Self::VagueWords => "vague-words",
            Self::Conjecture => "conjecture",
            Self::NeverSo => "never-so",
        }
    }
}

impl Severity {
    /// All, mildest first.
    pub const ALL: [Self; 4] = [Self::Slip, Self::Hypothesis, Self::Reading, Self::Serious];

    /// The name in reports.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Slip => "slip",
            Self::Hypothesis => "hypothesis",
            Self::Reading => "reading",
            Self::Serious => "serious",
        }
    }
}
