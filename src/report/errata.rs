//! Errata of the paper: one entry for each cause, to be sent to its authors.

use std::fmt;
use std::fmt::Write as _;

use schemars::JsonSchema;
use serde::Serialize;

use crate::language::{Cause, Form, Paper, Severity, Source};

use super::Report;
use super::markdown::plain;
use super::record::Record;
use super::summary::UNASSIGNED;

/// All that is wrong in the paper.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct Errata<'a> {
    /// `knotproof.errata/1`.
    #[schemars(extend("const" = "knotproof.errata/1"))]
    pub schema: &'static str,
    /// One entry a cause, the worst first.
    pub errata: Vec<Erratum>,
    /// What they are errata of.
    #[serde(skip)]
    pub of: &'a Paper,
}

/// What is wrong by one cause.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
pub struct Erratum {
    /// The name of the cause.
    pub cause: &'static str,
    /// The cause in words.
    pub title: &'static str,
    /// The worst severity among its claims.
    pub severity: &'static str,
    /// The claims that fail by it, in the order of the paper.
    pub claims: Vec<String>,
    /// Where the paper makes them, once each.
    pub locators: Vec<String>,
    /// Of their counterexamples the shortest; of those in degree after degree, where there are any.
    pub witness: ErratumWitness,
    /// What is true instead, claim by claim.
    pub amended: Vec<Amendment>,
}

/// A counterexample.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
pub struct ErratumWitness {
    /// To which claim.
    pub claim: String,
    /// Where the paper makes it.
    pub locator: String,
    /// `k = 1, U = (0, 0, 1, 1), …: the claim says …, but …`.
    pub text: String,
    /// A command that shows it.
    pub again: String,
}

/// A true statement in place of a false one.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
pub struct Amendment {
    /// In place of which.
    pub claim: String,
    /// Where the paper makes it.
    pub locator: String,
    /// What is true.
    pub statement: String,
    /// How far that is proved.
    pub verdict: String,
}

impl<'a> Errata<'a> {
    /// Those of the paper's statements in the report.
    #[must_use]
    pub fn of(report: &Report<'a>) -> Self {
        let refuted =
            |record: &&Record| record.source == Source::Paper && record.as_printed.finding.is_refuted();
        let refuted: Vec<&Record> = report.claims.iter().filter(refuted).collect();
        let mut causes: Vec<Option<Cause>> = Vec::new();
        for record in &refuted {
            if !causes.contains(&record.cause) {
                causes.push(record.cause);
            }
        }
        let of = |cause: &Option<Cause>| {
            let of_cause: Vec<&Record> =
                refuted.iter().copied().filter(|record| record.cause == *cause).collect();
            let worst = of_cause.iter().map(|record| record.severity).max().flatten();
            (worst, Erratum::of(report.of, *cause, worst, &of_cause))
        };
        let mut errata: Vec<_> = causes.iter().map(of).collect();
        errata.sort_by_key(|(worst, _)| std::cmp::Reverse(*worst));
        Self {
            schema: "knotproof.errata/1",
            errata: errata.into_iter().filter_map(|(_, erratum)| erratum).collect(),
            of: report.of,
        }
    }
}

impl Erratum {
    fn of(paper: &Paper, cause: Option<Cause>, worst: Option<Severity>, records: &[&Record]) -> Option<Self> {
        let witnesses = records.iter().filter_map(|record| {
            let witness = record.as_printed.finding.witness.as_ref()?;
            Some((
                record.by_degree.is_empty(),
                ErratumWitness {
                    claim: record.id.clone(),
                    locator: record.locator.clone(),
                    text: witness.to_string(),
                    again: witness.again(&record.id, Form::Printed, paper),
                },
            ))
        });
        let (_, witness) = witnesses.min_by_key(|(once, witness)| (*once, witness.text.chars().count()))?;
        let mut locators: Vec<String> = Vec::new();
        for record in records {
            if !locators.contains(&record.locator) {
                locators.push(record.locator.clone());
            }
        }
        let amended = records.iter().filter_map(|record| {
            let amended = record.amended.as_ref()?;
            Some(Amendment {
                claim: record.id.clone(),
                locator: record.locator.clone(),
                statement: amended.statement.clone(),
                verdict: amended.finding.words(),
            })
        });
        Some(Self {
            cause: cause.map_or(UNASSIGNED, Cause::name),
            title: cause.map_or(UNASSIGNED, Cause::words),
            severity: worst.map_or(UNASSIGNED, Severity::name),
            claims: records.iter().map(|record| record.id.clone()).collect(),
            locators,
            witness,
            amended: amended.collect(),
        })
    }
}

fn head(errata: &Errata<'_>) -> String {
    let (causes, claims) =
        (errata.errata.len(), errata.errata.iter().map(|one| one.claims.len()).sum::<usize>());
    let about = &errata.of.about;
    let arxiv = about.arxiv.as_ref().map(|arxiv| format!(" (arXiv {arxiv})")).unwrap_or_default();
    format!(
        "“{}”{arxiv}. {claims} {} as printed, by {causes} {}. Each has a counterexample in exact numbers; one is \
         given for each cause.",
        about.title,
        if claims == 1 { "statement fails" } else { "statements fail" },
        if causes == 1 { "cause" } else { "causes" }
    )
}

/// For the terminal and for a letter.
impl fmt::Display for Errata<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "Errata: {}", head(self))?;
        for (number, one) in (1..).zip(&self.errata) {
            writeln!(
                f,
                "\n{number}. {} ({}): {}.",
                capitalised(one.title),
                one.severity,
                one.locators.join(", ")
            )?;
            writeln!(f, "   {}: {}.", one.witness.locator, one.witness.text)?;
            writeln!(f, "   Again: {}", one.witness.again)?;
            for amendment in &one.amended {
                let Amendment { claim, locator, statement, verdict } = amendment;
                writeln!(f, "   Instead, {locator} ({claim}): {statement} [{verdict}]")?;
            }
        }
        Ok(())
    }
}

/// The errata as Markdown.
#[must_use]
pub fn errata_page(errata: &Errata<'_>) -> String {
    let mut text = format!("# Errata\n\n{}\n", plain(&head(errata)));
    for (number, one) in (1..).zip(&errata.errata) {
        // Writing to a string cannot fail.
        let _ = writeln!(
            text,
            "\n## {number}. {} ({})\n\n{}.\n\n- Counterexample to {}: {}. Again: `{}`",
            plain(&capitalised(one.title)),
            one.severity,
            plain(&one.locators.join(", ")),
            plain(&one.witness.locator),
            plain(&one.witness.text),
            one.witness.again
        );
        for amendment in &one.amended {
            let Amendment { claim, locator, statement, verdict } = amendment;
            let _ =
                writeln!(text, "- Instead, {} (`{claim}`): {} *{verdict}*", plain(locator), plain(statement));
        }
    }
    text
}

fn capitalised(text: &str) -> String {
    let mut chars = text.chars();
    // Greek letters of formulas stay as they are.
    match chars.next() {
        Some(first) if first.is_ascii() => first.to_uppercase().chain(chars).collect(),
        _ => text.to_owned(),
    }
}
