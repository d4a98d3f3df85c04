//! The command `report`: every claim of the paper, judged and compared with the recorded verdicts.

use std::fmt;
use std::fs;
use std::path::{Path, PathBuf};

use schemars::JsonSchema;
use serde::Serialize;

use crate::language::{claims, paper};
use crate::report::{
    Baseline, Difference, Errata, PageSource, Report, THEORY, conjecture_page, errata_page, examples_in_coq,
    figures, stanzas_in_coq, verdicts_page, with_theory_tables,
};
use crate::settle::Theory;

use super::atomic::{Folder, write_atomically};
use super::error::CliError;
use super::exit::Exit;
use super::file::read;
use super::judge::{BESIDE, ERRATA, INSTANCE_SCHEMA, Shown, choose, compared, read_baseline, report_files};
use super::output::{OfPaper, Output, pretty_json, stamped_json};
use super::progress::Progress;

/// Judges every claim of the paper on its own instances and on small cases: as `judge` does with any paper, and with the floats
/// and the figures of this one; compares with the recorded verdicts.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLE)]
pub(super) struct Args {
    /// Writes report.json, report.md, errata.md and index.html, a page to read in a browser, into this folder, which is made
    /// if it is not there; if all claims are judged, also conjecture.md, the page on Conjecture 3.1, with its pictures.
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Compares with the verdicts in this file, instead of those recorded with the program.
    #[arg(long, value_name = "FILE")]
    baseline: Option<PathBuf>,
    /// Judges only this claim; may be repeated.
    #[arg(long, value_name = "CLAIM")]
    claim: Vec<String>,
    /// Prints the errata of the paper, one entry for each cause, ready to be sent: from the recorded verdicts or those of
    /// --baseline, without judging anything. With --out, errata.md and errata.json are written.
    #[arg(long, conflicts_with = "record")]
    errata: bool,
    /// Accepts the verdicts: rewrites proofs/verdicts.json, docs/conjecture.md with its pictures, and the table in
    /// docs/verdicts.md below the current folder.
    #[arg(long, conflicts_with_all = ["claim", "baseline"])]
    record: bool,
}

const EXAMPLE: &str = "\
Examples:
  knotproof report --out report  # takes a while
  knotproof report --claim T3.5.3 --claim P3.2 --format json
  knotproof report --errata
Exit code 0: every verdict is as recorded, refuted claims included. Exit code 1: one differs.";

const ERRATA_JSON: &str = "errata.json";
const CONJECTURE: &str = "conjecture.md";
/// The folder and the file of the recorded verdicts, below the current folder.
const PROOFS: &str = "proofs";
const VERDICTS: &str = "verdicts.json";
const CERTIFICATES: &str = "proofs/certs";
/// The folder of the pages that are written from the verdicts, and the one with their table.
const DOCS: &str = "docs";
const VERDICTS_PAGE: &str = "verdicts.md";
/// The page on the theorems, in their folder.
const README: &str = "README.md";
/// The claims in Coq, there as well.
const STANZAS: &str = "Stanzas.v";
/// Numbers in Coq.
const EXAMPLES: &str = "Examples.v";

/// The result: its fields are the JSON.
#[derive(Debug, Serialize, JsonSchema)]
pub(super) struct Outcome<'a> {
    /// What this object is: `knotproof.report/1`.
    #[schemars(extend("const" = "knotproof.report/1"))]
    schema: &'static str,
    #[serde(flatten)]
    report: Report<'a>,
    /// The verdicts that are not as recorded.
    differences: Vec<Difference>,
    #[serde(skip)]
    written: Vec<PathBuf>,
}

/// Judges, writes the files, compares and prints.
pub(super) fn run(args: &Args, output: &Output) -> Result<Exit, CliError> {
    let chosen = choose(claims(), &args.claim)?;
    let partial = !args.claim.is_empty();
    // Whatever can be wrong with the files is found out before the work begins.
    let baseline = match &args.baseline {
        Some(path) => Some(read_baseline(path)?),
        // What is about to be replaced is not read: it may be damaged, or of an older shape.
        None if args.record => None,
        None => Some(Baseline::recorded().map_err(CliError::Recorded)?),
    };
    if args.record {
        recordable()?;
    }
    if let Some(folder) = &args.out {
        Folder::try_out("--out", folder)?;
    }
    if args.errata {
        let recorded = Baseline::recorded().map_err(CliError::Recorded)?;
        return errata(&Report::recorded(paper(), &chosen, &baseline.unwrap_or(recorded)), args, output);
    }

    let progress = Progress::new(chosen.len() + 1);
    let report = Report::of(paper(), &chosen, None, |done, name| progress.reach(done as u64, name))?;
    progress.step("f64 against exact");
    let report = report.with_float();
    drop(progress);

    let found = Baseline::of(&report.claims);
    let mut written = Vec::new();
    if args.record {
        record(&found, &mut written)?;
    }
    let differences = baseline.map(|baseline| baseline.differences(&found, partial)).unwrap_or_default();
    let mut outcome = Outcome { schema: "knotproof.report/1", report, differences, written };
    if let Some(folder) = &args.out {
        // The page on the conjecture is about claims that have to be there.
        let pictures = if partial { Vec::new() } else { conjecture_page(&found)? };
        let mut shown = pictures.clone();
        for figure in figures::all().iter().filter(|figure| figure.number.is_some()) {
            shown.push((figure.file(), figure.svg()?));
        }
        let name = match &args.baseline {
            Some(path) => path.display().to_string(),
            None => "the recorded verdicts".to_owned(),
        };
        let certificates = way(folder, CERTIFICATES);
        let theory = way(folder, THEORY);
        let mut beside = BESIDE.to_vec();
        if !partial {
            beside.push(("the page on Conjecture 3.1", CONJECTURE));
        }
        beside.push(INSTANCE_SCHEMA);
        let source = PageSource {
            compared: (!args.record).then_some((name.as_str(), outcome.differences.as_slice())),
            pictures: &shown,
            instances: &[],
            certificates: certificates.as_deref(),
            theory: theory.as_deref(),
            beside: &beside,
        };
        let mut files = report_files(&outcome, &outcome.report, &source, CERTIFICATES)?;
        files.extend(pictures);
        let folder = Folder::beside("--out", folder)?;
        for (name, text) in files {
            outcome.written.push(folder.write(&name, text)?);
        }
        folder.put_in_place()?;
    }
    output.result(&outcome)?;
    Ok(if outcome.differences.is_empty() { Exit::Holds } else { Exit::Refuted })
}

/// Writes and prints the errata.
fn errata(report: &Report<'_>, args: &Args, output: &Output) -> Result<Exit, CliError> {
    let errata = Errata::of(report);
    let page = errata_page(&errata);
    let errata = OfPaper::new(report.of, errata);
    if let Some(folder) = &args.out {
        let json = stamped_json(&errata)? + "\n";
        let folder = Folder::beside("--out", folder)?;
        for (name, text) in [(ERRATA, page), (ERRATA_JSON, json)] {
            folder.write(name, text)?;
        }
        folder.put_in_place()?;
    }
    output.result(&errata)?;
    Ok(Exit::Holds)
}

/// The way from the folder to another one of the project, if both are below the current folder.
fn way(folder: &Path, other: &str) -> Option<String> {
    let here = Path::new(".").canonicalize().ok()?;
    // It need not be there yet; the folder around it is.
    let there = folder.canonicalize().or_else(|_| {
        let around = folder.parent().filter(|around| *around != Path::new("")).unwrap_or(Path::new("."));
        Ok::<_, std::io::Error>(around.canonicalize()?.join(folder.file_name().unwrap_or_default()))
    });
    let there = there.ok()?;
    let depth = there.strip_prefix(&here).ok()?.components().count();
    Path::new(other).is_dir().then(|| "../".repeat(depth) + other)
}

/// Are the folders there where `--record` looks for them?
fn recordable() -> Result<(), CliError> {
    for folder in [PROOFS, DOCS, THEORY] {
        let folder = Path::new(folder);
        fs::read_dir(folder).map_err(|error| unwritable("--record", folder, error))?;
    }
    Ok(())
}

/// Rewrites the recorded verdicts, and the pages made from them.
fn record(found: &Baseline, written: &mut Vec<PathBuf>) -> Result<(), CliError> {
    let mut pages = conjecture_page(found)?;
    pages.push((VERDICTS_PAGE.to_owned(), verdicts_page(found)));
    write_file("--record", &Path::new(PROOFS).join(VERDICTS), &pretty_json(found)?, written)?;
    for (name, text) in pages {
        write_file("--record", &Path::new(DOCS).join(name), &text, written)?;
    }
    for (name, text) in [(STANZAS, stanzas_in_coq(&claims())), (EXAMPLES, examples_in_coq(paper()))] {
        write_file("--record", &Path::new(THEORY).join(name), &text, written)?;
    }
    let path = Path::new(THEORY).join(README);
    let page = read("--record", &path)?;
    if let Some(page) = with_theory_tables(&page, Theory::shipped(), &claims()) {
        write_file("--record", &path, &page, written)?;
    }
    Ok(())
}

fn write_file(
    argument: &'static str,
    path: &Path,
    text: &str,
    written: &mut Vec<PathBuf>,
) -> Result<(), CliError> {
    write_atomically(argument, path, text)?;
    written.push(path.to_owned());
    Ok(())
}

fn unwritable(argument: &'static str, path: &Path, error: std::io::Error) -> CliError {
    CliError::File { argument, action: "write", path: path.to_owned(), error }
}

/// What matters, the tables of verdicts, and what is not as recorded.
impl fmt::Display for Outcome<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", Shown { report: &self.report, written: &self.written })?;
        compared(f, &self.differences)
    }
}
