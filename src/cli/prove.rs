//! The command `prove`: writes the certificates.

use std::borrow::Cow;
use std::collections::BTreeSet;
use std::ffi::OsString;
use std::fmt;
use std::fs;
use std::path::{Path, PathBuf};

use schemars::JsonSchema;
use serde::Serialize;

use crate::certificate::Certificate;
use crate::judge::Cases;
use crate::language::{Claim, paper};
use crate::settle::{Proving, settle_all};
use crate::typed::TypedError;

use super::atomic::Folder;
use super::error::CliError;
use super::exit::Exit;
use super::judge::{choose, settle_error};
use super::output::Output;
use super::paper::paper_of;
use super::progress::Progress;
use super::verify::Row;
use super::visible::visible_path;

/// Proves what the claims say in the formal language of proofs/FORMAT.md, has every proof checked, and writes the
/// certificates.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLE)]
pub(super) struct Args {
    /// The folder for the certificates, which is made if it is not there.
    #[arg(long, value_name = "DIR", default_value = "proofs/certs")]
    out: PathBuf,
    /// Proves the claims of this paper: a folder, or the name of one that comes with the program.
    #[arg(long, value_name = "FOLDER|NAME")]
    paper: Option<OsString>,
    /// Proves only this claim; may be repeated.
    #[arg(long, value_name = "CLAIM")]
    claim: Vec<String>,
}

const EXAMPLE: &str = "\
Examples:
  knotproof prove --out my-certificates  # takes a while
  knotproof prove --claim T3.5.2 --claim X.totalpositivity --out my-certificates --format json
The claims are judged first: a certificate of a refutation rests on the witness that was found.";

/// The result: its fields are the JSON.
#[derive(Debug, Serialize, JsonSchema)]
pub(super) struct Proved {
    /// What this object is: `knotproof.prove/1`.
    #[schemars(extend("const" = "knotproof.prove/1"))]
    schema: &'static str,
    /// The certificates, accepted by the checker.
    checked: Vec<Row>,
    /// The folder.
    written: PathBuf,
    /// Certificates in the folder that no claim has any more.
    stale: Vec<String>,
}

/// Proves, checks, writes and prints.
pub(super) fn run(args: &Args, output: &Output) -> Result<Exit, CliError> {
    let paper = match &args.paper {
        Some(name) => paper_of("--paper", name)?,
        None => Cow::Borrowed(paper()),
    };
    let chosen = choose(Claim::of(&paper).collect(), &args.claim)?;
    Folder::try_out("--out", &args.out)?;
    let progress = Progress::new(chosen.len());
    let cases = Cases::of_paper(&paper).map_err(|error| TypedError::Member { argument: "--paper", error })?;
    let settled =
        settle_all(&chosen, &cases, Proving::Everything, |done, name| progress.reach(done as u64, name));
    let settled = settled.map_err(|error| match &args.paper {
        Some(name) => settle_error("--paper", &paper, name, error),
        None => error.into(),
    })?;
    let all = settled.iter().flat_map(|(_, outcome)| outcome.all());
    let mut names = BTreeSet::new();
    // One can be of several degrees.
    let all = all.filter(|one| one.certificate.as_ref().is_some_and(|of| names.insert(of.name())));
    let (checked, proved): (Vec<_>, Vec<_>) =
        all.filter_map(|one| Some((Row::from(one.checked.clone()?), one.certificate.as_ref()?))).unzip();
    drop(progress);
    let folder = Folder::beside("--out", &args.out)?;
    for certificate in &proved {
        folder.write(&format!("{}.statement", certificate.name()), certificate.statement_text())?;
        folder.write(&format!("{}.proof", certificate.name()), certificate.proof_text())?;
    }
    folder.put_in_place()?;
    let names: Vec<_> = proved.iter().map(|certificate| Certificate::name(certificate)).collect();
    let stale = if args.claim.is_empty() { stale(&args.out, &names)? } else { Vec::new() };
    let proved = Proved { schema: "knotproof.prove/1", checked, written: args.out.clone(), stale };
    output.result_of(&paper, &proved)?;
    Ok(if proved.stale.is_empty() { Exit::Holds } else { Exit::Refuted })
}

/// The certificates in the folder that are none of these.
fn stale(folder: &Path, names: &[String]) -> Result<Vec<String>, CliError> {
    let entries = fs::read_dir(folder).map_err(|error| unwritable(folder, error))?;
    let mut stale: Vec<String> = entries
        .filter_map(|entry| {
            let name = entry.ok()?.file_name().into_string().ok()?;
            let stem = name.strip_suffix(".statement").or_else(|| name.strip_suffix(".proof"))?;
            (!names.iter().any(|known| known == stem)).then_some(name)
        })
        .collect();
    stale.sort();
    Ok(stale)
}

fn unwritable(path: &Path, error: std::io::Error) -> CliError {
    CliError::File { argument: "--out", action: "write", path: path.to_owned(), error }
}

impl fmt::Display for Proved {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{}\n", Row::table(&self.checked, "goals"))?;
        writeln!(
            f,
            "Proved and checked: {} {} ({}), in {}",
            self.checked.len(),
            if self.checked.len() == 1 { "certificate" } else { "certificates" },
            Row::kinds(&self.checked),
            visible_path(&self.written)
        )?;
        for name in &self.stale {
            writeln!(f, "Not a certificate of any claim any more: {name}")?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_no_claim_has_any_more_is_stale() {
        let folder = tempfile::tempdir().unwrap();
        for name in ["A.1.printed.statement", "A.1.printed.proof", "A.1.proof", "B.statement", "notes.txt"] {
            fs::write(folder.path().join(name), "").unwrap();
        }
        let known = ["A.1.printed".to_owned(), "C".to_owned()];
        assert_eq!(stale(folder.path(), &known).unwrap(), ["A.1.proof", "B.statement"]);
        assert!(stale(&folder.path().join("gone"), &known).is_err());
    }
}
