//! What is reported of a claim: the data of `report.json`.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::certificate::{Certificate, Statement, Weighted};
use crate::judge::{Scope, Verdict, Witness};
use crate::language::{Cause, Claim, Form, Severity, Source};
use crate::settle::{Decides, DegreeRange, Outcome, Settled, Theorem, Theory, grade};

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
    /// The certificate is for any weights at all, not only for those of the family.
    #[serde(skip_serializing_if = "std::ops::Not::not", default)]
    pub any_weights: bool,
    /// The degrees in which it was decided case by case or by a certificate. Scope `degree` is about more: see the theorems.
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
    /// Which parts of the program came to this verdict, each by its own way: `engine`, `prover`, `checker`; and `coq`, where a
    /// theorem says the same.
    #[serde(skip_serializing_if = "Vec::is_empty", default)]
    pub checked_by: Vec<String>,
    /// The theorems of proofs/theory that say it of all degrees, or of some.
    #[serde(skip_serializing_if = "Vec::is_empty", default)]
    pub theorems: Vec<TheoremRecord>,
}

/// A theorem that Coq has checked.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct TheoremRecord {
    /// Its name in Coq.
    pub name: String,
    /// The file in proofs/theory.
    pub file: String,
    /// Does it say that the statement is true, or, in each of the degrees, false on some knots?
    #[schemars(extend("enum" = ["proved", "refuted"]))]
    pub status: String,
    /// In which degrees the statement is, according to it, true or false: `for every k`, `for k ≥ 3`; empty where no degree
    /// occurs.
    pub degrees: String,
    /// It says so of every degree that the statement is about.
    pub all_degrees: bool,
    /// It is about any weights, as a certificate may be, not only those of the family.
    #[serde(skip_serializing_if = "std::ops::Not::not", default)]
    pub any_weights: bool,
    /// What it says is printed from the stanza of the claim, so that nobody has to compare the two.
    #[serde(skip_serializing_if = "std::ops::Not::not", default)]
    pub from_stanza: bool,
}

/// The engine that judges cases, and the two that a certificate takes.
const PROVED: &str = "proved";
const REFUTED: &str = "refuted";
const ENGINE: &str = "engine";
const CERTIFIED: [&str; 2] = ["prover", "checker"];
const COQ: &str = "coq";

impl Finding {
    /// How far a proof reaches, with the degrees: `knots, for k ≤ 8`, and with `any weights` where it is for those; `degree, for
    /// every k`, and what else is known of some degrees.
    #[must_use]
    pub fn reach(&self) -> Option<String> {
        let scope = self.scope.as_deref()?;
        let proved = || self.theorems.iter().filter(|theorem| theorem.status == PROVED);
        let by_certificate = degrees(&self.degrees);
        let Some(every) = proved().filter(|theorem| theorem.all_degrees).max_by_key(|of| of.any_weights)
        else {
            let mut reach = joined(scope, &for_degrees(&by_certificate));
            if self.any_weights {
                reach.push_str(", any weights");
            }
            for some in proved() {
                reach += &format!("; {}, {}", Scope::Degree, some.degrees);
            }
            return Some(reach);
        };
        let mut reach = joined(scope, &every.degrees);
        match (every.any_weights, self.any_weights) {
            (true, _) => reach.push_str(", any weights"),
            (false, true) => reach += &format!("; any weights {}", for_degrees(&by_certificate)),
            (false, false) => {}
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

/// What is not empty, with a comma between.
fn joined(one: &str, other: &str) -> String {
    if other.is_empty() { one.to_owned() } else { format!("{one}, {other}") }
}

fn for_degrees(condition: &str) -> String {
    if condition.is_empty() { String::new() } else { format!("for {condition}") }
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
            theorems: Vec::new(),
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

/// The folder of the theorems, in the project.
pub const THEORY: &str = "proofs/theory";

impl TheoremRecord {
    /// What it says: `true for every k, any weights`, `false on some knots for k ≥ 3`.
    #[must_use]
    pub fn says(&self) -> String {
        let says = match (self.status.as_str(), self.degrees.as_str()) {
            (PROVED, "") => "true".to_owned(),
            (PROVED, degrees) => format!("true {degrees}"),
            (_, "") => "false".to_owned(),
            (_, degrees) => format!("false on some knots {degrees}"),
        };
        if self.any_weights { says + ", any weights" } else { says }
    }

    /// The same with its name and its file: `true for every k: T3_5_2_printed in proofs/theory/StatementsBasis.v`.
    #[must_use]
    pub fn words(&self) -> String {
        let printed = if self.from_stanza { ", printed from the stanza" } else { "" };
        format!("{}: {} in {THEORY}/{}{printed}", self.says(), self.name, self.file)
    }

    /// A theorem about a sentence that is about these degrees.
    fn of(theorem: &Theorem, sentence: DegreeRange) -> Self {
        Self {
            name: theorem.name.clone(),
            file: theorem.file.clone(),
            status: match theorem.verdict {
                Decides::Proved => PROVED.to_owned(),
                Decides::Refuted => REFUTED.to_owned(),
            },
            degrees: theorem.degrees.common(sentence).words(),
            all_degrees: theorem.degrees.covers(sentence),
            any_weights: theorem.is_for_any_weights(),
            // The stanza is about the weights of the paper.
            from_stanza: !theorem.is_for_any_weights()
                && Theory::shipped().is_from_stanza(&theorem.claim, theorem.form),
        }
    }
}

impl Finding {
    /// What was found of a sentence of a claim, on cases, by a certificate and by theorems.
    #[must_use]
    pub fn of(claim: Claim<'_>, settled: &Settled) -> Self {
        let finding = Self::from(&settled.verdict).certified(settled.certificate.as_ref());
        match (settled.form, claim.sentence(settled.form)) {
            (Form::Degree(k), _) => {
                // Its certificate may be one for other degrees, too.
                let degrees = finding.degrees.iter().copied().filter(|of| *of == k).collect();
                Self { degrees, ..finding }.with_theorems(&settled.theorems, DegreeRange::one(k))
            }
            (_, Some(sentence)) => finding.with_theorems(&settled.theorems, DegreeRange::of(sentence)),
            (_, None) => finding,
        }
    }

    /// With what theorems say of the sentence, which is about these degrees. That it is true they may say where nothing else
    /// does; that it is false is shown by a witness alone.
    fn with_theorems(mut self, theorems: &[&Theorem], sentence: DegreeRange) -> Self {
        self.theorems = theorems.iter().map(|theorem| TheoremRecord::of(theorem, sentence)).collect();
        if self.theorems.iter().any(|theorem| theorem.status == PROVED && theorem.all_degrees) {
            self.status = PROVED.to_owned();
            self.reason = None;
            let scope = if sentence.is_one() { Scope::Knots } else { Scope::Degree };
            self.scope = Some(scope.name().to_owned());
        }
        if self.theorems.iter().any(|theorem| theorem.status == self.status) {
            self.checked_by.push(COQ.to_owned());
        }
        self
    }
}

impl Stated {
    /// A statement and what it came to.
    fn new(claim: Claim<'_>, settled: &Settled) -> Self {
        Self {
            statement: claim.text(settled.form),
            finding: Finding::of(claim, settled),
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
                finding: Finding::of(claim, settled),
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

    /// Is the statement that stands, as printed or as amended, true of every degree?
    #[must_use]
    pub fn is_of_every_degree(&self) -> bool {
        let standing = self.amended.as_ref().unwrap_or(&self.as_printed);
        standing.finding.scope.as_deref() == Some(Scope::Degree.name())
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
