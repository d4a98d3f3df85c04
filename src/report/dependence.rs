//! What depends on what, and whether a theorem of the paper falls: computed from the verdicts.

use schemars::JsonSchema;
use serde::Serialize;

use crate::language::{Claim, Paper, Source};

use super::record::Record;

/// What the refutations of premises do to the statements that rest on them.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
pub struct Dependence {
    /// One sentence on the theorems, propositions, corollaries and lemmas; nothing unless all of them were judged.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub sentence: Option<String>,
    /// Those of them that do not stand, amended or not, or rest on what fails.
    pub falls: Vec<String>,
    /// Each use of a claim that is refuted as printed.
    pub uses: Vec<Dependency>,
}

/// One use, with what the verdicts say of it.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
pub struct Dependency {
    /// The conclusion.
    pub claim: String,
    /// The premise.
    pub rests_on: String,
    /// What becomes of the conclusion.
    pub state: State,
    /// What survives, and why.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub why: Option<String>,
}

/// What becomes of a conclusion.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum State {
    /// The premise is true as printed.
    Intact,
    /// The premise fails as printed, and the conclusion has a proof of its own, as printed or amended.
    Survives,
    /// Neither.
    Broken,
}

impl State {
    /// The name in reports.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Intact => "intact",
            Self::Survives => "survives",
            Self::Broken => "broken",
        }
    }
}

/// What the paper proves, by the first word of its locator.
const PROVED_IN_PAPER: [&str; 4] = ["Theorem", "Proposition", "Corollary", "Lemma"];

fn is_theorem(source: Source, locator: &str) -> bool {
    source == Source::Paper && PROVED_IN_PAPER.contains(&locator.split(' ').next().unwrap_or_default())
}

impl Dependence {
    /// From the records, which may be those of a part of the claims.
    #[must_use]
    pub fn of(paper: &Paper, records: &[Record]) -> Self {
        let record = |id: &str| records.iter().find(|record| record.id == id);
        let stated: Vec<_> = Claim::of(paper).collect();
        let uses = stated.iter().flat_map(|claim| claim.stanza.uses.iter().map(|one| (claim.id(), one)));
        let uses: Vec<Dependency> = uses
            .filter_map(|(claim, one)| {
                let (conclusion, premise) = (record(claim)?, record(&one.id)?);
                let settled = |stated: &super::Stated| stated.finding.is_proved();
                let own = settled(&conclusion.as_printed) || conclusion.amended.as_ref().is_some_and(settled);
                let state = match (settled(&premise.as_printed), own && one.survives.is_some()) {
                    (true, _) => State::Intact,
                    (false, true) => State::Survives,
                    (false, false) => State::Broken,
                };
                Some(Dependency {
                    claim: claim.into(),
                    rests_on: one.id.to_string(),
                    state,
                    why: one.survives.clone(),
                })
            })
            .collect();
        let theorems: Vec<&Record> =
            records.iter().filter(|record| is_theorem(record.source, &record.locator)).collect();
        let broken = |id: &str| uses.iter().any(|one| one.claim == id && one.state == State::Broken);
        let falls: Vec<String> = theorems
            .iter()
            .filter(|record| !record.stands() || broken(&record.id))
            .map(|record| record.id.clone())
            .collect();
        let all = stated.iter().filter(|claim| is_theorem(claim.source(), &claim.stanza.at)).count();
        // Of what no case is about nothing is known.
        let judged = theorems.iter().all(|record| record.as_printed.finding.status != "not-applicable");
        let sentence = (all > 0 && theorems.len() == all && judged).then(|| sentence(&theorems, &falls));
        Self { sentence, falls, uses }
    }
}

/// `1 is`, `2 are`.
fn are(count: usize) -> String {
    format!("{count} {}", if count == 1 { "is" } else { "are" })
}

/// What is not proved for every instance is said to be so.
fn only_in_cases(theorems: &[&Record]) -> String {
    let standing = |record: &&&Record| {
        let stated = record.amended.as_ref().filter(|_| !record.as_printed.finding.is_proved());
        let scope = stated.unwrap_or(&record.as_printed).finding.scope.as_deref();
        matches!(scope, Some("points" | "instance"))
    };
    match theorems.iter().filter(standing).count() {
        0 => String::new(),
        count => format!(" Of these, {count} on the cases that were decided only: no proof reaches further."),
    }
}

fn sentence(theorems: &[&Record], falls: &[String]) -> String {
    let amended = theorems.iter().filter(|record| !record.as_printed.finding.is_proved()).count();
    let count = theorems.len();
    match falls {
        [] => format!(
            "No theorem of the paper falls: of its {count} theorems, propositions, corollaries and lemmas, {} true as printed, \
             and {} once amended.{}",
            are(count - amended),
            are(amended),
            only_in_cases(theorems)
        ),
        falls => format!(
            "Of the paper's {count} theorems, propositions, corollaries and lemmas, {} {}: {}.",
            falls.len(),
            if falls.len() == 1 { "falls" } else { "fall" },
            falls.join(", ")
        ),
    }
}
