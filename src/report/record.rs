//! What is reported of a claim: the data of `report.json`.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::certificate::{Certificate, Form as CertificateForm, Statement};
use crate::claims::{Claim, Form, Judged, Sharpness, Verdict, Witness};

/// One status with all that belongs to it.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct Finding {
    /// `proved`, `refuted`, `undecided`, `not-formal` or `not-applicable`.
    pub status: String,
    /// How far a proof reaches.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub scope: Option<String>,
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
const ENGINE: &str = "engine";
const CERTIFIED: [&str; 2] = ["prover", "checker"];

impl Finding {
    /// How far a proof reaches, with the degrees: `knots, k = 0–8`.
    #[must_use]
    pub fn reach(&self) -> Option<String> {
        let scope = self.scope.clone()?;
        Some(match runs(&self.degrees) {
            degrees if degrees.is_empty() => scope,
            degrees => format!("{scope}, k = {degrees}"),
        })
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
            // A claim about the weight has no degree.
            if !self.degrees.is_empty() || self.checked_by.len() == CERTIFIED.len() {
                self.degrees.clone_from(degrees);
            }
        }
        self
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
    /// Its hypotheses, as far as the engine knows them one by one.
    #[serde(skip_serializing_if = "Vec::is_empty", default)]
    pub hypotheses: Vec<String>,
    /// The verdict.
    #[serde(flatten)]
    pub finding: Finding,
    /// On how much a proof rests.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub rests_on: Option<Grounds>,
    /// Among the cases that an amended statement excludes, in how many the printed one fails.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub sharpness: Option<Sharpness>,
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
    /// The statement as printed.
    pub statement: String,
    /// The verdict as printed.
    pub as_printed: Stated,
    /// The amended statement with its verdict, where the printed one is refuted.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub amended: Option<Stated>,
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

impl Stated {
    /// A statement and the verdict on it.
    #[must_use]
    pub fn new(form: &Form, verdict: &Verdict, certificate: Option<&Certificate>) -> Self {
        Self {
            statement: form.text().to_owned(),
            hypotheses: form.hypotheses(),
            finding: Finding::from(verdict).certified(certificate),
            rests_on: Grounds::of(verdict),
            sharpness: None,
        }
    }
}

impl Record {
    /// The record of a claim that was judged.
    #[must_use]
    pub fn new(claim: &Claim, judged: &Judged, certificates: &[Certificate]) -> Self {
        let of = |form: CertificateForm| certificates.iter().find(|found| found.statement.form == form);
        let amended = claim.amended.as_ref().zip(judged.amended.as_ref()).map(|(form, verdict)| {
            let mut stated = Stated::new(form, verdict, of(CertificateForm::Amended));
            stated.sharpness = judged.sharpness;
            stated
        });
        // A degree in which there is nothing to judge is left out.
        let said =
            judged.by_degree.iter().filter(|(_, verdict)| !matches!(verdict, Verdict::NotApplicable(_)));
        Self {
            id: claim.id.to_owned(),
            locator: claim.locator.to_owned(),
            statement: claim.printed.text().to_owned(),
            as_printed: Stated::new(&claim.printed, &judged.printed, of(CertificateForm::Printed)),
            amended,
            by_degree: said
                .map(|(degree, verdict)| DegreeFinding {
                    degree: *degree,
                    finding: Finding::from(verdict).certified(of(CertificateForm::Degree(*degree))),
                    rests_on: Grounds::of(verdict),
                })
                .collect(),
            note: claim.note.map(str::to_owned),
        }
    }
}
