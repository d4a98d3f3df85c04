//! How bad it is that a printed statement fails: derived from the two statements where it can be, and stated elsewhere.

use std::collections::HashSet;
use std::hash::Hash;

use crate::scalar::parse_rational;

use super::cause::{Cause, Severity};
use super::claim::{Claim, Form};
use super::verdict::Witness;

/// A severity, and why it is this one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Grade {
    /// How bad.
    pub severity: Severity,
    /// Why: a sentence.
    pub because: &'static str,
}

impl Claim {
    /// How bad it is that the printed statement fails as the witness shows; `None` if no cause is known.
    ///
    /// Derived: a *hypothesis*, if the amended statement has all hypotheses of the printed one and more; a *slip*, if it
    /// has the same ones, speaks of x, and the printed statement fails at a knot or an end of the interval.
    #[must_use]
    pub fn grade(&self, witness: &Witness) -> Option<Grade> {
        let stated = stated(self.cause?);
        if !self.cause?.is_derived() {
            return Some(stated);
        }
        let Some(amended) = &self.amended else { return Some(stated) };
        Some(match added(&self.printed, amended) {
            Added::Some => Grade {
                severity: Severity::Hypothesis,
                because: "derived: the amended statement has all hypotheses of the printed one, and one more",
            },
            Added::None if at_an_end(witness) => Grade {
                severity: Severity::Slip,
                because: "derived: the amended statement has the same hypotheses, and differs only for x at knots or ends of intervals",
            },
            _ => stated,
        })
    }
}

impl Cause {
    /// Can the severity be read off the statements? A reading or an idea can't be.
    fn is_derived(self) -> bool {
        match self {
            Self::EndPoints
            | Self::EndKnots
            | Self::InnerMultiplicity
            | Self::IndexRange
            | Self::ProofStep => true,
            // It fails on whole intervals of x; that its witness is at an end of one says nothing.
            Self::OutsideInterval => false,
            Self::Picture | Self::VagueWords | Self::Conjecture | Self::NeverSo => false,
        }
    }

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

/// The severity that a cause has where none is derived.
fn stated(cause: Cause) -> Grade {
    let (severity, because) = match cause {
        Cause::EndPoints => (Severity::Slip, "stated: only the end points of an interval are wrong"),
        Cause::IndexRange => (Severity::Slip, "stated: only the range of an index is wrong"),
        Cause::OutsideInterval => {
            (Severity::Hypothesis, "stated: the amended statement asks for x in the interval")
        }
        Cause::EndKnots => {
            (Severity::Hypothesis, "stated: the proofs assume end knots of multiplicity k + 1")
        }
        Cause::InnerMultiplicity => (
            Severity::Hypothesis,
            "stated: the amended statement leaves out knots of multiplicity greater than k",
        ),
        Cause::ProofStep => (
            Severity::Hypothesis,
            "stated: the step needs more than it says; the statement that it is to prove is true",
        ),
        Cause::Picture => (Severity::Reading, "stated: a picture was read so; no proof rests on it"),
        Cause::VagueWords => {
            (Severity::Reading, "stated: the words have another reading, in which they are true")
        }
        Cause::Conjecture => {
            (Severity::Serious, "stated: the idea fails, and no hypothesis on the knots alone saves it")
        }
        Cause::NeverSo => (Severity::Reading, "stated: it asks for more than polynomial B-splines have"),
    };
    Grade { severity, because }
}

/// What the amended statement assumes beyond the printed one.
enum Added {
    None,
    Some,
    /// They can't be compared.
    Other,
}

fn added(printed: &Form, amended: &Form) -> Added {
    match (printed, amended) {
        (Form::Weight(printed), Form::Weight(amended)) => compare(&printed.hypotheses, &amended.hypotheses),
        (Form::Basis(printed), Form::Basis(amended)) => compare(&printed.hypotheses, &amended.hypotheses),
        _ => Added::Other,
    }
}

fn compare<H: Eq + Hash>(printed: &[H], amended: &[H]) -> Added {
    let [printed, amended]: [HashSet<&H>; 2] = [printed, amended].map(|list| list.iter().collect());
    match (printed == amended, printed.is_subset(&amended)) {
        (true, _) => Added::None,
        (false, true) => Added::Some,
        _ => Added::Other,
    }
}

/// Is the x of the witness one of its knots, or an end of its interval [a, b]?
fn at_an_end(witness: &Witness) -> bool {
    let given =
        |name: &str| witness.given.iter().find(|(known, _)| known == name).map(|(_, value)| value.as_str());
    let Some(x) = given("x").and_then(|x| parse_rational(x).ok()) else { return false };
    let knots = given("U").and_then(|list| list.strip_prefix('(')?.strip_suffix(')')).unwrap_or_default();
    let ends = knots.split(", ").chain(given("a")).chain(given("b"));
    ends.filter_map(|end| parse_rational(end).ok()).any(|end| end == x)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::claims::claims;

    fn witness(given: &[(&str, &str)]) -> Witness {
        let given = given.iter().map(|(name, value)| ((*name).to_owned(), (*value).to_owned())).collect();
        Witness { given, claimed: String::new(), found: String::new(), reproduce: None }
    }

    fn severity(id: &str, given: &[(&str, &str)]) -> Option<Severity> {
        let claim = claims().into_iter().find(|claim| claim.id == id).expect("the claim");
        claim.grade(&witness(given)).map(|grade| grade.severity)
    }

    #[test]
    fn what_is_derived_depends_on_the_statements_and_on_the_witness() {
        let at_knot = [("U", "(0, 0, 1, 1)"), ("x", "1")];
        let inside = [("U", "(0, 0, 1, 1)"), ("x", "1/2")];
        assert_eq!(severity("P4.1.1", &at_knot), Some(Severity::Slip));
        // One more hypothesis weighs more than where the witness is.
        assert_eq!(severity("T3.11.3a", &at_knot), Some(Severity::Hypothesis));
        assert_eq!(severity("T3.5.4", &at_knot), Some(Severity::Slip));
        assert_eq!(severity("T3.5.4", &inside), Some(Severity::Hypothesis));
        assert_eq!(severity("Conj3.1.strong", &at_knot), Some(Severity::Serious));
        assert_eq!(severity("T3.5.2", &at_knot), None, "it is true");
    }

    #[test]
    fn every_claim_with_a_cause_has_a_severity_and_no_other_has() {
        for claim in claims() {
            let grade = claim.grade(&witness(&[]));
            assert_eq!(grade.is_some(), claim.cause.is_some(), "{}", claim.id);
            assert_eq!(
                grade.is_some_and(|grade| grade.severity == Severity::Serious),
                claim.cause == Some(Cause::Conjecture),
                "{}",
                claim.id
            );
        }
    }

    #[test]
    fn names_are_those_of_the_data() {
        let name = |value: serde_json::Value| value.as_str().map(str::to_owned);
        for severity in Severity::ALL {
            assert_eq!(
                name(serde_json::to_value(severity).expect("a word")).as_deref(),
                Some(severity.name())
            );
        }
        for cause in claims().iter().filter_map(|claim| claim.cause) {
            assert_eq!(name(serde_json::to_value(cause).expect("a word")).as_deref(), Some(cause.name()));
        }
    }
}
