//! The recorded verdicts, and how a run differs from them.

use std::collections::BTreeSet;
use std::fmt;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use thiserror::Error;

use crate::json::{self, JsonError};
use crate::language::{Claim, Form};

use super::record::{DegreeFinding, Finding, Record, Stated, TheoremRecord};

/// The verdicts that were recorded with the source of this program.
const RECORDED: &str = include_str!("../../proofs/verdicts.json");
const SCHEMA: &str = "knotproof.verdicts/2";

/// The verdict on one claim, without the texts around it.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Entry {
    /// The claim.
    pub id: String,
    /// Where the paper makes it.
    pub locator: String,
    /// As printed.
    pub as_printed: Finding,
    /// As amended.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub amended: Option<Finding>,
    /// For the questions: degree by degree.
    #[serde(skip_serializing_if = "Vec::is_empty", default)]
    pub by_degree: Vec<DegreeFinding>,
}

/// A set of verdicts to compare with.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Baseline {
    schema: String,
    /// One entry a claim, in the order of the paper.
    pub claims: Vec<Entry>,
}

/// What a file says that it is.
#[derive(Deserialize)]
struct Kind {
    schema: String,
}

/// Why a text is no baseline.
#[derive(Debug, Error)]
pub enum BaselineError {
    /// Not JSON, or not of the right shape; with line and column.
    #[error("{0}")]
    Malformed(#[from] JsonError),
    /// Made by another version of the program.
    #[error("its schema is `{0}`, and this program reads `{SCHEMA}`")]
    Schema(String),
}

/// One verdict that is not as recorded.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
pub struct Difference {
    /// The claim.
    pub id: String,
    /// `as printed`, `as amended`, `degree 3`, or `the claim`.
    pub of: String,
    /// What was recorded.
    pub recorded: String,
    /// What was found.
    pub found: String,
}

impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { id, of, recorded, found } = self;
        write!(f, "{id}, {of}:\n    recorded: {recorded}\n    found:    {found}")
    }
}

impl Entry {
    /// Every verdict of the entry under its name.
    fn findings(&self) -> impl Iterator<Item = (String, &Finding)> {
        let printed = std::iter::once(("as printed".to_owned(), &self.as_printed));
        let amended = self.amended.iter().map(|finding| ("as amended".to_owned(), finding));
        let degrees = self.by_degree.iter().map(|of| (format!("degree {}", of.degree), &of.finding));
        printed.chain(amended).chain(degrees)
    }

    /// The names of all certificates about the claim.
    pub fn certificates(&self) -> impl Iterator<Item = &str> {
        self.findings().filter_map(|(_, finding)| finding.certificate.as_deref())
    }

    /// The theorems about its sentences, as printed and as amended.
    pub fn theorems(&self) -> impl Iterator<Item = &TheoremRecord> {
        std::iter::once(&self.as_printed).chain(&self.amended).flat_map(|finding| &finding.theorems)
    }

    /// The record of its claim: nothing is judged, and nothing is said of grounds.
    #[must_use]
    pub fn record(&self, claim: Claim<'_>) -> Record {
        let amended = self.amended.as_ref();
        Record {
            amended: amended.map(|finding| Stated::recorded(claim, Form::Amended, finding)),
            by_degree: self.by_degree.clone(),
            ..Record::of(claim, Stated::recorded(claim, Form::Printed, &self.as_printed))
        }
    }

    fn finding(&self, name: &str) -> Option<&Finding> {
        self.findings().find(|(other, _)| other == name).map(|(_, finding)| finding)
    }
}

impl Baseline {
    /// The verdicts of a run.
    #[must_use]
    pub fn of(records: &[Record]) -> Self {
        let entry = |record: &Record| Entry {
            id: record.id.clone(),
            locator: record.locator.clone(),
            as_printed: record.as_printed.finding.clone(),
            amended: record.amended.as_ref().map(|stated| stated.finding.clone()),
            by_degree: record.by_degree.iter().map(DegreeFinding::without_grounds).collect(),
        };
        Self { schema: SCHEMA.to_owned(), claims: records.iter().map(entry).collect() }
    }

    /// The verdicts recorded with the source (`proofs/verdicts.json`).
    ///
    /// # Errors
    /// [`BaselineError`], if the program was built with a damaged file.
    pub fn recorded() -> Result<Self, BaselineError> {
        Self::parse(RECORDED)
    }

    /// Reads a baseline.
    ///
    /// # Errors
    /// [`BaselineError`], with line and column where the text is malformed.
    pub fn parse(text: &str) -> Result<Self, BaselineError> {
        // The schema first: a file of another kind is not to be blamed for its fields.
        let Kind { schema } = json::read(text)?;
        if schema == SCHEMA { Ok(json::read(text)?) } else { Err(BaselineError::Schema(schema)) }
    }

    /// All verdicts of `found` that are not as recorded here. If the run was `partial`, nothing is said of the
    /// claims that it left out.
    #[must_use]
    pub fn differences(&self, found: &Self, partial: bool) -> Vec<Difference> {
        let mut differences = Vec::new();
        for entry in &self.claims {
            match found.claims.iter().find(|other| other.id == entry.id) {
                Some(other) => compare(entry, other, &mut differences),
                None if partial => {}
                None => differences.push(whole(&entry.id, "judged", "not judged")),
            }
        }
        let unknown =
            found.claims.iter().filter(|other| self.claims.iter().all(|entry| entry.id != other.id));
        differences.extend(unknown.map(|other| whole(&other.id, "not recorded", "judged")));
        differences
    }
}

fn whole(id: &str, recorded: &str, found: &str) -> Difference {
    Difference { id: id.to_owned(), of: "the claim".into(), recorded: recorded.into(), found: found.into() }
}

fn compare(recorded: &Entry, found: &Entry, differences: &mut Vec<Difference>) {
    let names: BTreeSet<String> = recorded.findings().chain(found.findings()).map(|(name, _)| name).collect();
    for of in names {
        let (before, after) = (recorded.finding(&of), found.finding(&of));
        if before != after {
            let words = |finding: Option<&Finding>| finding.map_or("nothing".to_owned(), describe);
            let (recorded_words, found) = (words(before), words(after));
            differences.push(Difference { id: recorded.id.clone(), of, recorded: recorded_words, found });
        }
    }
}

fn describe(finding: &Finding) -> String {
    let mut words = finding.status.clone();
    if let Some(scope) = &finding.scope {
        words += &format!(" ({scope})");
    }
    if !finding.degrees.is_empty() {
        words += &format!(", degrees {:?}", finding.degrees);
    }
    if let Some(witness) = &finding.witness {
        words += &format!(": {witness}");
    }
    if let Some(reason) = &finding.reason {
        words += &format!(": {reason}");
    }
    for remark in &finding.remarks {
        words += &format!("; {remark}");
    }
    for theorem in &finding.theorems {
        words += &format!("; theorem: {}", theorem.words());
    }
    words
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_kind_of_change_is_reported() {
        let recorded = Baseline::recorded().unwrap();
        assert!(recorded.differences(&recorded, false).is_empty());
        let mut changed = recorded.clone();
        changed.claims[0].as_printed.status = "undecided".into();
        let gone = changed.claims.pop().unwrap();
        let differences = recorded.differences(&changed, false);
        assert_eq!(differences.len(), 2, "{differences:?}");
        assert!(differences[0].to_string().contains("undecided"));
        assert_eq!(differences[1].id, gone.id);
        assert_eq!(recorded.differences(&changed, true).len(), 1);
        assert_eq!(changed.differences(&recorded, true).len(), 2, "a claim that was not recorded");
    }

    #[test]
    fn a_baseline_of_another_kind_is_refused() {
        assert!(matches!(Baseline::parse("{"), Err(BaselineError::Malformed(_))));
        for other in ["knotproof.verdicts/0", "knotproof.report/1"] {
            let text = format!(r#"{{"schema": "{other}", "claims": [], "float": []}}"#);
            assert!(matches!(Baseline::parse(&text), Err(BaselineError::Schema(schema)) if schema == other));
        }
    }
}
