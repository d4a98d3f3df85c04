//! The command `verify`: runs the independent checker.

use std::fmt;
use std::fs;
use std::path::{Path, PathBuf};

use comfy_table::Table;
use rayon::prelude::*;
use schemars::JsonSchema;
use serde::Serialize;

use crate::certificate::{Sexp, Statement, statement_text};
use crate::language::{Form, claims, paper};
use crate::report::{Baseline, Finding};

use super::error::CliError;
use super::exit::Exit;
use super::judge::choose;
use super::output::Output;
use super::table::{plain, right_aligned};
use super::visible::visible;

/// Has certificates checked by the independent checker.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLE)]
pub(super) struct Args {
    /// Certificates: folders, or files NAME.statement with NAME.proof beside them; without any, the folder proofs/certs.
    #[arg(value_name = "PATH")]
    paths: Vec<PathBuf>,
    /// Asks only for the certificates of this claim, as `prove --claim` writes them; may be repeated.
    #[arg(long, value_name = "CLAIM")]
    claim: Vec<String>,
    /// Accepts also statements that are not the program's own, and asks for none that is missing.
    #[arg(long, conflicts_with = "claim")]
    foreign: bool,
}

const EXAMPLE: &str = "\
A folder is a whole set: it has a certificate for every claim that is recorded as certified, or for those named by
--claim. Single files are only checked. The exit code is 1 if a certificate is rejected, if one is missing, or if what
it proves is not the program's own statement of the claim (then it has to be read; --foreign allows it).
Examples:
  knotproof verify
  knotproof verify proofs/certs/T3.5.2.printed.statement --format json
  knotproof prove --claim T3.5.2 --out mine && knotproof verify --claim T3.5.2 mine
The checker is a program of its own as well: cargo run --package knotproof-checker -- T.statement T.proof";

/// Where the recorded certificates are, in a clone.
pub(super) const RECORDED: &str = "proofs/certs";

/// One certificate that was accepted.
#[derive(Debug, Serialize, JsonSchema)]
pub(super) struct Row {
    /// The claim.
    claim: String,
    /// Which statement: `printed`, `amended` or `degree K`.
    form: String,
    /// What is proved of it.
    verdict: String,
    /// How far that reaches.
    scope: String,
    /// The degrees k.
    degrees: Vec<usize>,
    /// The parts of the proof.
    sections: usize,
    /// Goals and lemmas.
    steps: usize,
    /// How the goals come from the sentence: `derived`, none after a `point`, or `argued`.
    shown: String,
    /// It is proved for any weights at all, not only for those of the family.
    any_weights: bool,
}

impl Row {
    /// One row each, with what the last column counts.
    pub(super) fn table(rows: &[Self], counted: &str) -> Table {
        let mut table = plain(["claim", "", "verdict", "scope", "degrees", "shown", counted]);
        table.add_rows(rows.iter().map(Self::cells));
        right_aligned(&mut table, 6);
        table
    }

    /// `derived 40, point 30, argued 200; for any weights 20`.
    pub(super) fn kinds(rows: &[Self]) -> String {
        let count = |kind: &str| rows.iter().filter(|row| row.shown == kind).count();
        let kinds = ["derived", "point", "argued"].map(|kind| format!("{kind} {}", count(kind))).join(", ");
        match rows.iter().filter(|row| row.any_weights).count() {
            0 => kinds,
            any => format!("{kinds}; for any weights {any}"),
        }
    }

    fn cells(&self) -> [String; 7] {
        let degrees: Vec<_> = self.degrees.iter().map(ToString::to_string).collect();
        [
            visible(&self.claim),
            visible(&self.form),
            visible(&self.verdict),
            format!("{}{}", visible(&self.scope), if self.any_weights { ", any weights" } else { "" }),
            degrees.join(" "),
            self.shown.clone(),
            self.steps.to_string(),
        ]
    }
}

impl From<knotproof_checker::Checked> for Row {
    fn from(checked: knotproof_checker::Checked) -> Self {
        Self {
            claim: checked.claim,
            form: checked.form,
            verdict: checked.verdict,
            scope: checked.scope,
            degrees: checked.degrees,
            sections: checked.sections,
            steps: checked.goals + checked.lemmas,
            shown: checked.goals_are.to_owned(),
            any_weights: checked.any_weights,
        }
    }
}

/// One that was not.
#[derive(Debug, Serialize, JsonSchema)]
struct Rejection {
    /// The file.
    file: String,
    /// What is wrong.
    reason: String,
}

/// The result: its fields are the JSON.
#[derive(Debug, Serialize, JsonSchema)]
pub(super) struct Verified {
    /// What this object is: `knotproof.verify/1`.
    #[schemars(extend("const" = "knotproof.verify/1"))]
    schema: &'static str,
    /// The certificates that were accepted.
    checked: Vec<Row>,
    /// Those that were not.
    rejected: Vec<Rejection>,
    /// Accepted, but not what the program says that the claim is in formal terms: the statement has to be read.
    unknown: Vec<String>,
    /// The recorded certificates that are asked for and that no file is.
    missing: Vec<String>,
}

/// Checks and prints.
pub(super) fn run(args: &Args, output: &Output) -> Result<Exit, CliError> {
    let chosen: Vec<_> = choose(claims(), &args.claim)?.iter().map(|claim| claim.id()).collect();
    let paths = if args.paths.is_empty() { vec![recorded()?] } else { args.paths.clone() };
    let mut files = Vec::new();
    for path in &paths {
        files.extend(statements(path)?);
    }
    let read: Result<Vec<_>, CliError> = files
        .into_iter()
        .map(|path| {
            let proof = read(&path.with_extension("proof"))?;
            Ok((read(&path)?, proof, path))
        })
        .collect();
    let own = own_statements()?;
    let results: Vec<_> = read?
        .into_par_iter()
        .map(|(statement, proof, path)| {
            let items = Sexp::parse_all(&statement).unwrap_or_default();
            let is_it = |own: &Own| match (items.as_slice(), &own.statement) {
                ([item], Some(own)) => Statement::is_said_by(own, item),
                _ => false,
            };
            let known = own.iter().position(is_it);
            (knotproof_checker::check(&statement, &proof), known, path.to_string_lossy().into_owned())
        })
        .collect();
    let whole = paths.iter().any(|path| path.is_dir()) || !args.claim.is_empty();
    let is_missing = |place: &usize| results.iter().all(|(_, known, _)| *known != Some(*place));
    let missing = (0..own.len())
        .filter(|place| whole && !args.foreign && chosen.contains(&own[*place].claim) && is_missing(place))
        .map(|place| own[place].certificate.clone())
        .collect();
    let mut verified = Verified {
        schema: "knotproof.verify/1",
        checked: Vec::new(),
        rejected: Vec::new(),
        unknown: Vec::new(),
        missing,
    };
    for (result, known, file) in results {
        match result {
            Ok(checked) => {
                if known.is_none() {
                    verified.unknown.push(file);
                }
                verified.checked.push(checked.into());
            }
            Err(rejected) => verified.rejected.push(Rejection { file, reason: rejected.to_string() }),
        }
    }
    output.result_of(paper(), &verified)?;
    let own = verified.unknown.is_empty() || args.foreign;
    let holds = verified.rejected.is_empty() && verified.missing.is_empty() && own;
    Ok(if holds { Exit::Holds } else { Exit::Refuted })
}

/// The folder of the recorded certificates, if there is one here.
fn recorded() -> Result<PathBuf, CliError> {
    let purpose = "there is no folder proofs/certs here; write certificates with `knotproof prove --out DIR`, and check \
                   them with `knotproof verify DIR`";
    let path = PathBuf::from(RECORDED);
    if path.is_dir() { Ok(path) } else { Err(CliError::Needed { argument: "PATH", purpose }) }
}

/// A file as the checker reads it.
fn read(path: &Path) -> Result<String, CliError> {
    knotproof_checker::read(path).map_err(|error| unreadable(path, error))
}

fn unreadable(path: &Path, error: std::io::Error) -> CliError {
    CliError::File { argument: "PATH", action: "read", path: path.to_owned(), error }
}

/// What the program says in formal terms, for one recorded certificate.
struct Own {
    claim: &'static str,
    certificate: String,
    /// None that any file could have, if the program does not state it any more.
    statement: Option<Sexp>,
}

/// What the recorded verdicts say in formal terms.
fn own_statements() -> Result<Vec<Own>, CliError> {
    let recorded = Baseline::recorded().map_err(CliError::Recorded)?;
    let mut all = Vec::new();
    for claim in claims() {
        let Some(entry) = recorded.claims.iter().find(|entry| entry.id == claim.id()) else { continue };
        let mut findings: Vec<(Form, &Finding)> = vec![(Form::Printed, &entry.as_printed)];
        findings.extend(entry.amended.iter().map(|finding| (Form::Amended, finding)));
        findings.extend(entry.by_degree.iter().map(|of| (Form::Degree(of.degree), &of.finding)));
        for (form, finding) in findings {
            let Some(certificate) = finding.certificate.clone() else { continue };
            // One can be of several degrees.
            if all.iter().rev().any(|own: &Own| own.certificate == certificate) {
                continue;
            }
            let statement = statement_text(claim, form, finding.witness.as_ref())?;
            all.push(Own { claim: claim.id(), certificate, statement });
        }
    }
    Ok(all)
}

/// The statements at a path, sorted by name.
fn statements(path: &Path) -> Result<Vec<PathBuf>, CliError> {
    let unreadable = |error| unreadable(path, error);
    if !fs::metadata(path).map_err(unreadable)?.is_dir() {
        if path.extension().is_none_or(|extension| extension != "statement") {
            return Err(CliError::NoCertificate { path: path.to_owned() });
        }
        return Ok(vec![path.to_owned()]);
    }
    let entries = fs::read_dir(path).and_then(|entries| entries.collect::<Result<Vec<_>, _>>());
    let mut files: Vec<PathBuf> = entries.map_err(unreadable)?.iter().map(fs::DirEntry::path).collect();
    files.retain(|file| file.extension().is_some_and(|extension| extension == "statement"));
    files.sort();
    if files.is_empty() { Err(CliError::NoCertificate { path: path.to_owned() }) } else { Ok(files) }
}

impl fmt::Display for Verified {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{}\n", Row::table(&self.checked, "steps"))?;
        for Rejection { file, reason } in &self.rejected {
            writeln!(f, "Rejected: {}: {}", visible(file), visible(reason))?;
        }
        for file in &self.unknown {
            writeln!(f, "Accepted, but not the program's own statement of the claim: {}", visible(file))?;
        }
        for name in &self.missing {
            writeln!(f, "Missing, though the claim is recorded as certified: {name}")?;
        }
        let (accepted, rejected) = (self.checked.len(), self.rejected.len());
        write!(f, "Accepted: {accepted} ({}); rejected: {rejected}", Row::kinds(&self.checked))
    }
}
