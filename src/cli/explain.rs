//! The command `explain`: one claim, its verdict, and why.

use std::fmt;
use std::path::Path;

use schemars::JsonSchema;
use serde::Serialize;

use crate::certificate::{Sexp, statement};
use crate::language::{Cause, Claim, Form, Severity, claims, paper};
use crate::report::{Baseline, Finding};

use super::error::CliError;
use super::exit::Exit;
use super::output::Output;
use super::verdict::{styled, styled_as_printed};
use super::verify::RECORDED;

/// Explains a claim: what it says, what is known of it, and the idea of the proof or the counterexample.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLE)]
pub(super) struct Args {
    /// The claim, such as T3.5.3.
    #[arg(value_name = "CLAIM")]
    claim: String,
    /// Shows the formal goals too.
    #[arg(long)]
    goals: bool,
}

const EXAMPLE: &str = "\
Examples:
  knotproof explain T3.5.3
  knotproof explain X.totalpositivity --goals
The verdicts are the recorded ones; `knotproof report --claim CLAIM` judges it again.";

/// One statement of the claim.
#[derive(Debug, Serialize, JsonSchema)]
struct Part {
    /// `as printed`, `as amended` or `degree K`.
    of: String,
    #[serde(skip)]
    form: Form,
    /// It, in words and formulas.
    statement: String,
    #[serde(flatten)]
    finding: Finding,
    /// Why it is true or false.
    #[serde(skip_serializing_if = "Option::is_none")]
    idea: Option<String>,
    /// What is proved, in the language of proofs/FORMAT.md.
    #[serde(skip_serializing_if = "Option::is_none")]
    goals: Option<String>,
}

const AS_PRINTED: &str = "as printed";

/// The result: its fields are the JSON.
#[derive(Debug, Serialize, JsonSchema)]
pub(super) struct Explanation {
    /// What this object is: `knotproof.explain/1`.
    #[schemars(extend("const" = "knotproof.explain/1"))]
    schema: &'static str,
    /// The claim.
    id: &'static str,
    /// Where the paper makes it.
    locator: &'static str,
    /// A short name.
    title: &'static str,
    /// Of a refutation: how bad it is.
    #[serde(skip_serializing_if = "Option::is_none")]
    severity: Option<Severity>,
    /// Of a refutation: what stands behind it.
    #[serde(skip_serializing_if = "Option::is_none")]
    cause: Option<Cause>,
    /// The verdict on the printed statement in words.
    #[serde(skip)]
    printed: String,
    /// Its statements with their recorded verdicts.
    parts: Vec<Part>,
    /// How words were made into mathematics.
    #[serde(skip_serializing_if = "Option::is_none")]
    note: Option<&'static str>,
}

/// Looks up and prints.
pub(super) fn run(args: &Args, output: &Output) -> Result<Exit, CliError> {
    let all = claims();
    let ids: Vec<_> = all.iter().map(Claim::id).collect();
    let Some(claim) = all.iter().find(|claim| claim.id() == args.claim).copied() else {
        return Err(CliError::unknown_claim("CLAIM", &args.claim, &ids));
    };
    let recorded = Baseline::recorded().map_err(CliError::Recorded)?;
    let Some(entry) = recorded.claims.iter().find(|entry| entry.id == claim.id()) else {
        return Err(CliError::NotRecorded(claim.id()));
    };
    let mut findings = vec![(Form::Printed, &entry.as_printed)];
    findings.extend(entry.amended.iter().map(|finding| (Form::Amended, finding)));
    findings.extend(entry.by_degree.iter().map(|of| (Form::Degree(of.degree), &of.finding)));
    let mut parts: Vec<Part> = Vec::new();
    for (form, finding) in findings {
        let part = part(claim, form, finding, args.goals, &parts)?;
        parts.push(part);
    }
    let record = entry.record(claim);
    let explanation = Explanation {
        schema: "knotproof.explain/1",
        id: claim.id(),
        locator: &claim.stanza.at,
        title: &claim.stanza.title,
        severity: record.severity,
        cause: record.cause,
        printed: styled_as_printed(&record),
        parts,
        note: claim.stanza.note.as_deref(),
    };
    output.result_of(paper(), &explanation)?;
    Ok(Exit::Holds)
}

/// One certificate can be of several of the parts.
fn part(
    claim: Claim<'_>,
    of: Form,
    finding: &Finding,
    goals: bool,
    before: &[Part],
) -> Result<Part, CliError> {
    let certificate = finding.certificate.as_ref();
    let same =
        before.iter().find(|part| certificate.is_some() && part.finding.certificate.as_ref() == certificate);
    let (idea, goals) = match (same, certificate) {
        (Some(same), _) => (same.idea.clone(), same.goals.clone()),
        (None, Some(_)) => {
            let shown = statement(claim, of, finding.witness.as_ref())?.map(|stated| stated.in_brackets());
            let (idea, sections) = shown.unzip();
            let listed = |sections: Vec<Sexp>| sections.iter().map(ToString::to_string).collect::<Vec<_>>();
            (idea, sections.filter(|_| goals).map(|sections| listed(sections).join("\n")))
        }
        (None, None) => (None, None),
    };
    Ok(Part {
        of: if let Form::Degree(_) = of { of.to_string() } else { format!("as {of}") },
        form: of,
        statement: claim.text(of),
        finding: finding.clone(),
        idea,
        goals,
    })
}

impl fmt::Display for Explanation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{} ({}): {}", self.id, self.locator, self.title)?;
        // What several degrees have in common is said once.
        let (mut said, mut why, mut shown) = ("", "", "");
        for part in &self.parts {
            let finding = &part.finding;
            let verdict = if part.of == AS_PRINTED { self.printed.clone() } else { styled(finding) };
            writeln!(f, "\n{}: {verdict}", capitalised(&part.of))?;
            if part.statement != said {
                writeln!(f, "  {}", part.statement)?;
                said = &part.statement;
            }
            if let Some(witness) = &finding.witness {
                writeln!(f, "  witness: {witness}")?;
                writeln!(f, "  again: {}", witness.again(self.id, part.form, paper()))?;
            }
            if let Some(reason) = &finding.reason {
                writeln!(f, "  {reason}")?;
            }
            if let Some(idea) = part.idea.as_ref().filter(|idea| *idea != why) {
                writeln!(f, "  why: {idea}")?;
                why = idea;
            }
            for remark in &finding.remarks {
                writeln!(f, "  {remark}")?;
            }
            if let Some(goals) = part.goals.as_ref().filter(|goals| *goals != shown) {
                shown = goals;
                writeln!(f, "  goals: {}", goals.replace('\n', "\n         "))?;
            }
            for theorem in &finding.theorems {
                writeln!(f, "  theorem: {}", theorem.words())?;
            }
            if let Some(certificate) = &finding.certificate {
                // A theorem is none of the certificate's.
                let checked_by: Vec<_> = finding.checked_by.iter().map(String::as_str).collect();
                let checked_by = checked_by.join(", ").replace(", coq", "");
                if Path::new(RECORDED).join(format!("{certificate}.statement")).is_file() {
                    let file = format!("{RECORDED}/{certificate}.statement");
                    writeln!(f, "  certificate: {file} and .proof; checked by {checked_by}")?;
                } else {
                    writeln!(
                        f,
                        "  certificate: {certificate}, checked by {checked_by}; no file of it is here:"
                    )?;
                    writeln!(f, "    knotproof prove --claim {} --out DIR writes it", self.id)?;
                }
            }
        }
        if let Some(note) = self.note {
            writeln!(f, "\nNote: {note}")?;
        }
        Ok(())
    }
}

fn capitalised(text: &str) -> String {
    let mut chars = text.chars();
    chars.next().map_or_else(String::new, |first| first.to_uppercase().chain(chars).collect())
}
