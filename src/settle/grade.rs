//! How bad it is that a printed sentence fails: read off the two sentences where it can be, and stated elsewhere.

use std::collections::BTreeSet;

use crate::judge::Witness;
use crate::language::{Adjective, Binder, Cause, Claim, Form, Range, Sentence, Severity, source};

/// A severity, and why it is this one.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Grade {
    /// How bad.
    pub severity: Severity,
    /// Why: a sentence.
    pub because: &'static str,
}

/// How bad it is that the printed sentence fails as the witness shows; `None` if no cause is known.
///
/// What the stanza states counts; otherwise a *hypothesis* is missing if the amended sentence has all hypotheses of the
/// printed one and more, and it is a *slip* if it has the same ones, speaks of x, and the printed sentence fails at a knot or
/// an end of an interval.
#[must_use]
pub fn grade(claim: Claim<'_>, witness: &Witness) -> Option<Grade> {
    let cause = claim.stanza.cause?;
    if let Some(severity) = claim.stanza.severity {
        return Some(Grade { severity, because: "stated with the claim" });
    }
    let sentences = (claim.sentence(Form::Printed), claim.sentence(Form::Amended));
    let (true, (Some(printed), Some(amended))) = (cause.is_derived(), sentences) else {
        return Some(cause.stated());
    };
    let [printed, amended] = [printed, amended].map(hypotheses);
    Some(if printed == amended && witness.is_at_an_end() {
        Grade {
            severity: Severity::Slip,
            because: "derived: the amended statement has the same hypotheses, and differs only for x at knots or ends of intervals",
        }
    } else if printed.is_subset(&amended) && printed != amended {
        Grade {
            severity: Severity::Hypothesis,
            because: "derived: the amended statement has all hypotheses of the printed one, and one more",
        }
    } else {
        cause.stated()
    })
}

/// What a sentence assumes of the case: by its binders, and by those formulas of `if` that name nothing that `for` lets run.
fn hypotheses(sentence: &Sentence) -> BTreeSet<String> {
    let with_implied = |adjective: &Adjective| match adjective {
        Adjective::Clamped | Adjective::Bernstein => vec![*adjective, Adjective::Open],
        _ => vec![*adjective],
    };
    let (mut all, mut running) = (BTreeSet::new(), BTreeSet::new());
    for binder in &sentence.given {
        match binder {
            Binder::Knots(adjectives) => {
                all.extend(
                    adjectives.iter().flat_map(with_implied).map(|adjective| format!("{adjective:?}")),
                );
            }
            Binder::Degree { least, most } => {
                all.extend((1..=*least).map(|k| format!("k >= {k}")));
                all.extend(most.map(|most| format!("k <= {most}")));
            }
            Binder::Integer(Range { name, .. })
            | Binder::Point(name, _)
            | Binder::Real { name, .. }
            | Binder::Points(name)
            | Binder::Index(name) => _ = running.insert(&**name),
            Binder::Instances(_) | Binder::Indices(_) | Binder::Gaps(_) => {}
        }
    }
    let assumed = sentence.assume.iter().map(source);
    let names_none =
        |text: &String| !text.split(|c: char| !c.is_alphanumeric()).any(|word| running.contains(word));
    all.extend(assumed.filter(names_none));
    all
}

impl Cause {
    /// Can the severity be read off the sentences? A reading or an idea can't be.
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

    /// The severity that a cause has where none is derived.
    fn stated(self) -> Grade {
        let (severity, because) = match self {
            Self::EndPoints => (Severity::Slip, "stated: only the end points of an interval are wrong"),
            Self::IndexRange => (Severity::Slip, "stated: only the range of an index is wrong"),
            Self::OutsideInterval => {
                (Severity::Hypothesis, "stated: the amended statement asks for x in the interval")
            }
            Self::EndKnots => {
                (Severity::Hypothesis, "stated: the proofs assume end knots of multiplicity k + 1")
            }
            Self::InnerMultiplicity => (
                Severity::Hypothesis,
                "stated: the amended statement leaves out knots of multiplicity greater than k",
            ),
            Self::ProofStep => (
                Severity::Hypothesis,
                "stated: the step needs more than it says; the statement that it is to prove is true",
            ),
            Self::Picture => (Severity::Reading, "stated: a picture was read so; no proof rests on it"),
            Self::VagueWords => {
                (Severity::Reading, "stated: the words have another reading, in which they are true")
            }
            Self::Conjecture => {
                (Severity::Serious, "stated: the idea fails, and no hypothesis on the knots alone saves it")
            }
            Self::NeverSo => (Severity::Reading, "stated: it asks for more than polynomial B-splines have"),
        };
        Grade { severity, because }
    }
}
