//! What is reported of a claim: the data of `report.json`.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::certificate::{Certificate, Statement, Weighted};
use crate::judge::{Verdict, Witness};
use crate::language::{Cause, Claim, Form, Severity, Source};
use crate::settle::{Outcome, Settled, grade};

/// One status with all that belongs to it.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct Finding {
    /// `proved`, `refuted`, `undecided`, `not-formal` or `not-applicable`.
    #[schemars(extend("enum" = ["proved", "refuted", "undecided", "not-formal", "not-applicable"]))]
    pub status: String,
    /// How far a proof reaches: `points`, `instance`, `alpha`, `knots` or `degree`, each further than the one before.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    #[schemars(extend("enum" = ["points", "instance", "alpha", "knots", "degree"]))]
    pub scope: Option<String>,
    /// The proof is for any weights at all, not only for those of the family.
    #[serde(skip_serializing_if = "std::ops::Not::not", default)]
    pub any_weights: bool,
    /// The degrees in which it was decided.
    #[serde(skip_serializing_if = "Vec::is_empty", default)]
    pub degrees: Vec<usize>,
    /// The exact counterexample of a refutation.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub witness: Option<Witness>,
    /// The limit that was hit, or why nothing is said.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub reason: Option<String>,
    /// Figures that were computed on the way.
    #[serde(skip_serializing_if = "Vec::is_empty", default)]
    pub remarks: Vec<String>,
    /// The name of the certificate, for files in proofs/certs.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub certificate: Option<String>,
    /// Which parts of the program came to this verdict, each by its own way: `engine`, `prover`, `checker`.
    #[serde(skip_serializing_if = "Vec::is_empty", default)]
    pub checked_by: Vec<String>,
}

/// The engine that judges cases, and the two that a certificate takes.
const PROVED: &str = "proved";
const REFUTED: &str = "refuted";
const ENGINE: &str = "engine";
const CERTIFIED: [&str; 2] = ["prover", "checker"];

impl Finding {
    /// How far a proof reaches, with the degrees: `knots, for k ≤ 8`, and with `any weights` where it is for those.
    #[must_use]
    pub fn reach(&self) -> Option<String> {
        let scope = self.scope.clone()?;
        let mut reach = match degrees(&self.degrees) {
            degrees if degrees.is_empty() => scope,
            degrees => format!("{scope}, for {degrees}"),
        };
        if self.any_weights {
            reach.push_str(", any weights");
        }
        Some(reach)
    }

    /// The status with the reach of a proof: `proved (knots, for k ≤ 8)`.
    #[must_use]
    pub fn words(&self) -> String {
        match self.reach() {
            Some(reach) => format!("{} ({reach})", self.status),
            None => self.status.clone(),
        }
    }

    /// Is it `proved`?
    #[must_use]
    pub fn is_proved(&self) -> bool {
        self.status == PROVED
    }

    /// Is it `refuted`?
    #[must_use]
    pub fn is_refuted(&self) -> bool {
        self.status == REFUTED
    }

    /// What a certificate adds that the checker has accepted: it may reach further, and settle what the cases left open.
    #[must_use]
    pub fn certified(mut self, certificate: Option<&Certificate>) -> Self {
        let Some(certificate) = certificate else { return self };
        let Statement { scope, degrees, refuted, .. } = &certificate.statement;
        self.certificate = Some(certificate.name());
        self.checked_by.extend(CERTIFIED.map(str::to_owned));
        if !refuted {
            self.status = PROVED.to_owned();
            self.scope = Some(scope.name().to_owned());
            self.reason = None;
            self.any_weights = certificate.statement.weighted == Weighted::Any;
            if certificate.statement.has_degree() {
                self.degrees.clone_from(degrees);
            }
        }
        self
    }
}

/// A rising list of degrees as a condition on k: `k ≤ 8`, `2 ≤ k ≤ 8`, `k = 3`, `k = 0–3, 5`.
pub(super) fn degrees(list: &[usize]) -> String {
    match (list.first(), list.last()) {
        (Some(first), Some(last)) if first < last && last - first + 1 == list.len() => match first {
            0 => format!("k ≤ {last}"),
            _ => format!("{first} ≤ k ≤ {last}"),
        },
        (Some(_), Some(_)) => format!("k = {}", runs(list)),
        _ => String::new(),
    }
}

/// A rising list with its runs drawn together: `0–3, 5`.
fn runs(list: &[usize]) -> String {
    let mut runs: Vec<(usize, usize)> = Vec::new();
    for &k in list {
        match runs.last_mut() {
            Some((_, last)) if *last + 1 == k => *last = k,
            _ => runs.push((k, k)),
        }
    }
    let run = |(first, last): &(usize, usize)| {
        if first == last { first.to_string() } else { format!("{first}–{last}") }
    };
    runs.iter().map(run).collect::<Vec<_>>().join(", ")
}

/// On how much a proof rests. Kept apart from the finding: it may grow without the verdict changing.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct Grounds {
    /// Instances of the paper (each U, k and α counts).
    pub instances: usize,
    /// Small cases of the engine's own.
    pub small_cases: usize,
    /// Exact decisions, each about every x.
    pub facts: usize,
}

/// A statement with what was found about it.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct Stated {
    /// The statement in words and formulas.
    pub statement: String,
    /// The verdict.
    #[serde(flatten)]
    pub finding: Finding,
    /// On how much a proof rests.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub rests_on: Option<Grounds>,
}

/// The verdict on a question for one degree.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct DegreeFinding {
    /// k.
    pub degree: usize,
    /// The verdict.
    #[serde(flatten)]
    pub finding: Finding,
    /// On how much a proof rests.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub rests_on: Option<Grounds>,
}

/// All that is reported of a claim.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct Record {
    /// The identifier, such as `T3.5.2`.
    pub id: String,
    /// Where the paper makes the claim.
    pub locator: String,
    /// A short name.
    pub title: String,
    /// Who says it.
    pub source: Source,
    /// The statement as printed.
    pub statement: String,
    /// Of a refutation: what stands behind it; nothing if that is not known.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub cause: Option<Cause>,
    /// Of a refutation: how bad it is.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub severity: Option<Severity>,
    /// Why that bad, and whether this is derived from the statements or stated.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub severity_because: Option<String>,
    /// The verdict as printed.
    pub as_printed: Stated,
    /// The amended statement with its verdict, where the printed one is refuted.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub amended: Option<Stated>,
    /// What holds where the amended statement does not apply: proved, if that can't be weakened.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub fails: Option<Stated>,
    /// For the questions `X.…`: degree by degree.
    #[serde(skip_serializing_if = "Vec::is_empty", default)]
    pub by_degree: Vec<DegreeFinding>,
    /// How words were made into mathematics.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub note: Option<String>,
}

impl DegreeFinding {
    /// The finding alone, as it is recorded.
    #[must_use]
    pub fn without_grounds(&self) -> Self {
        Self { rests_on: None, ..self.clone() }
    }
}

impl Grounds {
    /// Those of a proof.
    fn of(verdict: &Verdict) -> Option<Self> {
        let Verdict::Proved { reach, .. } = verdict else { return None };
        Some(Self { instances: reach.instances, small_cases: reach.small_cases, facts: reach.facts })
    }
}

impl From<&Verdict> for Finding {
    fn from(verdict: &Verdict) -> Self {
        let mut finding = Self {
            status: verdict.status().to_owned(),
            scope: verdict.scope().map(|scope| scope.name().to_owned()),
            any_weights: false,
            degrees: Vec::new(),
            witness: None,
            reason: None,
            remarks: Vec::new(),
            certificate: None,
            checked_by: Vec::new(),
        };
        if matches!(verdict, Verdict::Proved { .. } | Verdict::Refuted(_)) {
            finding.checked_by.push(ENGINE.to_owned());
        }
        match verdict {
            Verdict::Proved { reach, .. } => {
                finding.degrees.clone_from(&reach.degrees);
                finding.remarks.clone_from(&reach.remarks);
            }
            Verdict::Refuted(witness) => finding.witness = Some((**witness).clone()),
            Verdict::Undecided(reason) | Verdict::NotFormal(reason) | Verdict::NotApplicable(reason) => {
                finding.reason = Some(reason.clone());
            }
        }
        finding
    }
}

impl From<&Settled> for Finding {
    fn from(settled: &Settled) -> Self {
        let finding = Self::from(&settled.verdict).certified(settled.certificate.as_ref());
        match settled.form {
            // Its certificate may be one for other degrees, too.
            Form::Degree(k) => {
                Self { degrees: finding.degrees.iter().copied().filter(|of| *of == k).collect(), ..finding }
            }
            _ => finding,
        }
    }
}

impl Stated {
    /// A statement and what it came to.
    fn new(claim: Claim<'_>, settled: &Settled) -> Self {
        Self {
            statement: claim.text(settled.form),
            finding: settled.into(),
            rests_on: Grounds::of(&settled.verdict),
        }
    }

    /// The same with a verdict that was recorded.
    pub(super) fn recorded(claim: Claim<'_>, form: Form, finding: &Finding) -> Self {
        Self { statement: claim.text(form), finding: finding.clone(), rests_on: None }
    }
}

impl Record {
    /// The record of a claim that was settled.
    #[must_use]
    pub fn new(claim: Claim<'_>, outcome: &Outcome) -> Self {
        let stated = |settled: &Settled| Stated::new(claim, settled);
        let of_degree = |settled: &Settled| match settled.form {
            Form::Degree(degree) => Some(DegreeFinding {
                degree,
                finding: settled.into(),
                rests_on: Grounds::of(&settled.verdict),
            }),
            _ => None,
        };
        Self {
            amended: outcome.amended.as_ref().map(stated),
            fails: outcome.fails.as_ref().map(stated),
            by_degree: outcome.by_degree.iter().filter_map(of_degree).collect(),
            ..Self::of(claim, stated(&outcome.printed))
        }
    }

    /// With nothing but the printed sentence.
    pub(super) fn of(claim: Claim<'_>, as_printed: Stated) -> Self {
        let witness = as_printed.finding.witness.as_ref();
        let grade = witness.and_then(|witness| grade(claim, witness));
        Self {
            id: claim.id().to_owned(),
            locator: claim.stanza.at.clone(),
            title: claim.stanza.title.clone(),
            source: claim.source(),
            statement: as_printed.statement.clone(),
            cause: witness.and(claim.stanza.cause),
            severity: grade.as_ref().map(|grade| grade.severity),
            severity_because: grade.map(|grade| grade.because.to_owned()),
            as_printed,
            amended: None,
            fails: None,
            by_degree: Vec::new(),
            note: claim.stanza.note.clone(),
        }
    }

    /// The verdict as printed in words: `proved (knots, for k ≤ 8)`, `refuted (slip)`.
    #[must_use]
    pub fn words(&self) -> String {
        let finding = &self.as_printed.finding;
        match finding.is_refuted() {
            true => format!(
                "{} ({})",
                finding.status,
                self.severity.map_or("severity unassigned", Severity::name)
            ),
            false => finding.words(),
        }
    }

    /// Does the idea fail? Only that is shown in red.
    #[must_use]
    pub fn is_serious(&self) -> bool {
        self.as_printed.finding.is_refuted()
            && self.severity.is_none_or(|severity| severity == Severity::Serious)
    }

    /// Is it true as printed, or is an amended statement, and is the idea sound?
    #[must_use]
    pub fn stands(&self) -> bool {
        let amended = self.amended.as_ref().is_some_and(|stated| stated.finding.is_proved());
        self.as_printed.finding.is_proved() || (amended && !self.is_serious())
    }

    /// For tables: the worst refutation first, then what is open, then what is proved.
    fn rank(&self) -> u8 {
        match (self.as_printed.finding.status.as_str(), self.severity) {
            (REFUTED, None | Some(Severity::Serious)) => 0,
            (REFUTED, Some(Severity::Reading)) => 1,
            (REFUTED, Some(Severity::Hypothesis)) => 2,
            (REFUTED, Some(Severity::Slip)) => 3,
            (PROVED, _) => 5,
            _ => 4,
        }
    }
}

/// The records of one source for a table: by severity, and else in the order of the paper.
#[must_use]
pub fn by_severity(records: &[Record], source: Source) -> Vec<&Record> {
    let mut sorted: Vec<_> = records.iter().filter(|record| record.source == source).collect();
    sorted.sort_by_key(|record| record.rank());
    sorted
}

#[cfg(test)]
mod tests {
    use super::degrees;

    #[test]
    fn degrees_are_conditions_on_k() {
        for (list, words) in [
            (&[][..], ""),
            (&[0, 1, 2], "k ≤ 2"),
            (&[2, 3, 4], "2 ≤ k ≤ 4"),
            (&[3], "k = 3"),
            (&[0, 1, 3], "k = 0–1, 3"),
        ] {
            assert_eq!(degrees(list), words);
        }
    }
}
