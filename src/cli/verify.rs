//! The command `verify`: runs the independent checker.

use std::fmt;
use std::fs;
use std::path::{Path, PathBuf};

use rayon::prelude::*;
use serde::Serialize;

use crate::certificate::{Certificate, CertificateError, Form, Sexp, statement};
use crate::claims::claims;
use crate::report::{Baseline, Finding};

use super::error::CliError;
use super::exit::Exit;
use super::file::read;
use super::output::Output;
use super::table::{plain, right_aligned};
use super::visible::{visible, visible_path};

/// Has certificates checked by the independent checker.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLE)]
pub(super) struct Args {
    /// Certificates: folders, or files NAME.statement with NAME.proof beside them.
    #[arg(value_name = "PATH", default_value = "proofs/certs")]
    paths: Vec<PathBuf>,
}

const EXAMPLE: &str = "\
Examples:
  knotproof verify
  knotproof verify proofs/certs/T3.5.2.printed.statement --format json
The checker is a program of its own as well: cargo run --package knotproof-checker -- T.statement T.proof";

/// One certificate that was accepted.
#[derive(Debug, Serialize)]
pub(super) struct Checked {
    claim: String,
    form: String,
    verdict: String,
    scope: String,
    degrees: Vec<usize>,
    sections: usize,
    /// Goals and lemmas.
    steps: usize,
}

impl Checked {
    /// What the checker says of a certificate that was just written.
    pub(super) fn certificate(certificate: &Certificate) -> Result<Self, CertificateError> {
        Ok(certificate.check()?.into())
    }

    pub(super) fn row(&self) -> [String; 6] {
        let degrees: Vec<_> = self.degrees.iter().map(ToString::to_string).collect();
        [
            visible(&self.claim),
            visible(&self.form),
            visible(&self.verdict),
            visible(&self.scope),
            degrees.join(" "),
            self.steps.to_string(),
        ]
    }
}

impl From<knotproof_checker::Checked> for Checked {
    fn from(checked: knotproof_checker::Checked) -> Self {
        Self {
            claim: checked.claim,
            form: checked.form,
            verdict: checked.verdict,
            scope: checked.scope,
            degrees: checked.degrees,
            sections: checked.sections,
            steps: checked.goals + checked.lemmas,
        }
    }
}

/// One that was not.
#[derive(Debug, Serialize)]
struct Rejection {
    file: PathBuf,
    reason: String,
}

/// The result: its fields are the JSON.
#[derive(Debug, Serialize)]
struct Verified {
    schema: &'static str,
    checked: Vec<Checked>,
    rejected: Vec<Rejection>,
    /// Accepted, but not what the program says that the claim is in formal terms: the statement has to be read.
    unknown: Vec<PathBuf>,
}

/// Checks and prints.
pub(super) fn run(args: &Args, output: &Output) -> Result<Exit, CliError> {
    let mut files = Vec::new();
    for path in &args.paths {
        files.extend(statements(path)?);
    }
    let read: Result<Vec<_>, CliError> = files
        .into_iter()
        .map(|path| {
            let proof = read("PATH", &path.with_extension("proof"))?;
            Ok((read("PATH", &path)?, proof, path))
        })
        .collect();
    let own = own_statements()?;
    let results: Vec<_> = read?
        .into_par_iter()
        .map(|(statement, proof, path)| {
            let known =
                Sexp::parse_all(&statement).is_ok_and(|items| own.iter().any(|own| items == [own.clone()]));
            (knotproof_checker::check(&statement, &proof), known, path)
        })
        .collect();
    let mut verified = Verified {
        schema: "knotproof.verify/1",
        checked: Vec::new(),
        rejected: Vec::new(),
        unknown: Vec::new(),
    };
    for (result, known, file) in results {
        match result {
            Ok(checked) => {
                if !known {
                    verified.unknown.push(file);
                }
                verified.checked.push(checked.into());
            }
            Err(rejected) => verified.rejected.push(Rejection { file, reason: rejected.to_string() }),
        }
    }
    output.result(&verified)?;
    Ok(if verified.rejected.is_empty() { Exit::Holds } else { Exit::Refuted })
}

/// What the recorded verdicts say in formal terms.
fn own_statements() -> Result<Vec<Sexp>, CliError> {
    let recorded = Baseline::recorded().map_err(CliError::Recorded)?;
    let mut all = Vec::new();
    for claim in claims() {
        let Some(entry) = recorded.claims.iter().find(|entry| entry.id == claim.id) else { continue };
        let mut findings: Vec<(Form, &Finding)> = vec![(Form::Printed, &entry.as_printed)];
        findings.extend(entry.amended.iter().map(|finding| (Form::Amended, finding)));
        findings.extend(entry.by_degree.iter().map(|of| (Form::Degree(of.degree), &of.finding)));
        for (form, finding) in findings {
            if let Ok(Some(statement)) = statement(&claim, form, finding.witness.as_ref()) {
                all.push(statement.to_sexp());
            }
        }
    }
    Ok(all)
}

/// The statements at a path, sorted by name.
fn statements(path: &Path) -> Result<Vec<PathBuf>, CliError> {
    let unreadable =
        |error| CliError::File { argument: "PATH", action: "read", path: path.to_owned(), error };
    if !fs::metadata(path).map_err(unreadable)?.is_dir() {
        if path.extension().is_none_or(|extension| extension != "statement") {
            return Err(CliError::NoCertificate { path: path.to_owned() });
        }
        return Ok(vec![path.to_owned()]);
    }
    let mut files: Vec<PathBuf> = fs::read_dir(path)
        .map_err(unreadable)?
        .filter_map(|entry| entry.ok().map(|entry| entry.path()))
        .filter(|file| file.extension().is_some_and(|extension| extension == "statement"))
        .collect();
    files.sort();
    if files.is_empty() { Err(CliError::NoCertificate { path: path.to_owned() }) } else { Ok(files) }
}

impl fmt::Display for Verified {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut table =
            plain(["claim", "", "verdict", "scope", "degrees", "steps"].map(str::to_owned).to_vec());
        for checked in &self.checked {
            table.add_row(checked.row());
        }
        right_aligned(&mut table, 5);
        writeln!(f, "{table}\n")?;
        for Rejection { file, reason } in &self.rejected {
            writeln!(f, "Rejected: {}: {}", visible_path(file), visible(reason))?;
        }
        for file in &self.unknown {
            writeln!(
                f,
                "Accepted, but not the program's own statement of the claim: {}",
                visible_path(file)
            )?;
        }
        write!(f, "Accepted: {}; rejected: {}", self.checked.len(), self.rejected.len())
    }
}
