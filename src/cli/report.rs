//! The command `report`: every claim of the paper, judged and compared with the recorded verdicts.

use std::fmt;
use std::fs;
use std::path::{Path, PathBuf};

use schemars::{JsonSchema, schema_for};
use serde::Serialize;

use crate::claims::{Claim, Source, claims};
use crate::report::{
    Baseline, Difference, Drift, Errata, PageSource, Record, Report, by_severity, conjecture_page,
    dependence_picture, errata_page, figures, markdown, opening, page, verdicts_page,
};

use super::atomic::{Folder, write_atomically};
use super::error::CliError;
use super::exit::Exit;
use super::file::{InstanceFile, read};
use super::output::{OfPaper, Output, stamped_json};
use super::progress::Progress;
use super::table::plain;
use super::verdict::{Tally, styled, styled_as_printed};
use super::visible::visible_path;

/// Judges every claim of the paper on its own instances and on small cases; the main job.
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
  knotproof report --out report
  knotproof report --claim T3.5.3 --claim P3.2 --format json
  knotproof report --errata
Exit code 0: every verdict is as recorded, refuted claims included. Exit code 1: one differs.";

const JSON: &str = "report.json";
const MARKDOWN: &str = "report.md";
const PAGE: &str = "index.html";
const ERRATA: &str = "errata.md";
const ERRATA_JSON: &str = "errata.json";
const CONJECTURE: &str = "conjecture.md";
const SCHEMA: &str = "instance.schema.json";
const DEPENDENCE: &str = "dependence.svg";
/// The folder and the file of the recorded verdicts, below the current folder.
const PROOFS: &str = "proofs";
const VERDICTS: &str = "verdicts.json";
const CERTIFICATES: &str = "proofs/certs";
/// The folder of the pages that are written from the verdicts, and the one with their table.
const DOCS: &str = "docs";
const VERDICTS_PAGE: &str = "verdicts.md";

/// The result: its fields are the JSON.
#[derive(Debug, Serialize, JsonSchema)]
pub(super) struct Outcome {
    #[serde(flatten)]
    report: Report,
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
        return errata(&Report::recorded(&chosen, &baseline.unwrap_or(recorded)), args, output);
    }

    let progress = Progress::new(chosen.len() + 1);
    let report = Report::of(&chosen, |name| progress.step(name))?;
    drop(progress);

    let found = Baseline::of(&report.claims);
    let mut written = Vec::new();
    if args.record {
        record(&found, &mut written)?;
    }
    let differences = baseline.map(|baseline| baseline.differences(&found, partial)).unwrap_or_default();
    let mut outcome = Outcome { report, differences, written };
    if let Some(folder) = &args.out {
        let [json, schema] = [stamped_json(&outcome)? + "\n", pretty(&schema_for!(InstanceFile))?];
        let mut files = vec![
            (JSON.to_owned(), json),
            (MARKDOWN.to_owned(), markdown(&outcome.report)),
            (ERRATA.to_owned(), errata_page(&Errata::of(&outcome.report.claims))),
            (DEPENDENCE.to_owned(), dependence_picture(&outcome.report)?),
            (SCHEMA.to_owned(), schema),
        ];
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
        let certificates = certificates_from(folder);
        let mut beside =
            vec![("the errata", ERRATA), ("this report as data", JSON), ("and as text", MARKDOWN)];
        if !partial {
            beside.push(("the page on Conjecture 3.1", CONJECTURE));
        }
        beside.push(("the schema of instance files", SCHEMA));
        let source = PageSource {
            compared: (!args.record).then_some((name.as_str(), outcome.differences.as_slice())),
            pictures: &shown,
            certificates: certificates.as_deref(),
            beside: &beside,
        };
        files.push((PAGE.to_owned(), page(&outcome.report, &source)?));
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

/// JSON for a file.
fn pretty(value: &impl Serialize) -> Result<String, CliError> {
    Ok(serde_json::to_string_pretty(value).map_err(std::io::Error::from)? + "\n")
}

/// Writes and prints the errata.
fn errata(report: &Report, args: &Args, output: &Output) -> Result<Exit, CliError> {
    let errata = Errata::of(&report.claims);
    let page = errata_page(&errata);
    let errata = OfPaper::new(errata);
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

/// The claims of these identifiers, or all if there are none.
pub(super) fn choose(mut all: Vec<Claim>, names: &[String]) -> Result<Vec<Claim>, CliError> {
    let ids: Vec<_> = all.iter().map(|claim| claim.id).collect();
    if let Some(name) = names.iter().find(|name| !ids.contains(&name.as_str())) {
        return Err(CliError::unknown_claim("--claim", name, &ids));
    }
    all.retain(|claim| names.is_empty() || names.iter().any(|name| name == claim.id));
    Ok(all)
}

fn read_baseline(path: &Path) -> Result<Baseline, CliError> {
    let text = read("--baseline", path)?;
    Baseline::parse(&text).map_err(|error| CliError::Baseline { path: path.to_owned(), error })
}

/// The way from the folder to the certificates, if both are below the current folder.
fn certificates_from(folder: &Path) -> Option<String> {
    let here = Path::new(".").canonicalize().ok()?;
    // It need not be there yet; the folder around it is.
    let there = folder.canonicalize().or_else(|_| {
        let around = folder.parent().filter(|around| *around != Path::new("")).unwrap_or(Path::new("."));
        Ok::<_, std::io::Error>(around.canonicalize()?.join(folder.file_name().unwrap_or_default()))
    });
    let there = there.ok()?;
    let depth = there.strip_prefix(&here).ok()?.components().count();
    Path::new(CERTIFICATES).is_dir().then(|| "../".repeat(depth) + CERTIFICATES)
}

/// Are the folders there where `--record` looks for them?
fn recordable() -> Result<(), CliError> {
    for folder in [PROOFS, DOCS] {
        let folder = Path::new(folder);
        fs::read_dir(folder).map_err(|error| unwritable("--record", folder, error))?;
    }
    Ok(())
}

/// Rewrites the recorded verdicts, and the pages made from them.
fn record(found: &Baseline, written: &mut Vec<PathBuf>) -> Result<(), CliError> {
    let mut pages = conjecture_page(found)?;
    pages.push((VERDICTS_PAGE.to_owned(), verdicts_page(found)));
    write_file("--record", &Path::new(PROOFS).join(VERDICTS), &pretty(found)?, written)?;
    for (name, text) in pages {
        write_file("--record", &Path::new(DOCS).join(name), &text, written)?;
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

/// A row for each claim, the worst refutations first.
fn table(records: &[&Record]) -> comfy_table::Table {
    let header = ["claim", "where", "as printed", "as amended", "statement"];
    let mut table = plain(header.map(str::to_owned).to_vec());
    for record in records {
        let amended = record.amended.as_ref().map(|stated| styled(&stated.finding)).unwrap_or_default();
        table.add_row([
            record.id.clone(),
            record.locator.clone(),
            styled_as_printed(record),
            amended,
            record.statement.clone(),
        ]);
    }
    table
}

/// What matters, the tables of verdicts, and what is not as recorded.
impl fmt::Display for Outcome {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for line in opening(&self.report) {
            writeln!(f, "{line}")?;
        }
        let summary = &self.report.summary;
        for (title, source, counts) in [
            ("The paper", Source::Paper, &summary.paper),
            ("Our questions", Source::Question, &summary.questions),
        ] {
            if counts.statements > 0 {
                let table = table(&by_severity(&self.report.claims, source));
                writeln!(f, "\n{title}, {}\n\n{table}", counts.words())?;
            }
        }
        writeln!(f)?;
        let amended = self.report.claims.iter().filter_map(|record| record.amended.as_ref());
        let amended: Vec<_> = amended.map(|stated| &stated.finding).collect();
        if !amended.is_empty() {
            let amended: Tally = amended.into_iter().collect();
            writeln!(f, "As amended, where refuted: {amended}.")?;
        }
        for (name, title) in [("paper", "the paper's formula"), ("accurate", "ours")] {
            let found = self.report.float.iter().flat_map(|drift| {
                let of = drift.formulas.iter().find(|of| of.name == name);
                of.and_then(|of| Some((drift, of.tried, of.max_ulp.as_ref()?.parse::<f64>().ok()?)))
            });
            if let Some((drift, tried, error)) = found.max_by(|a, b| a.2.total_cmp(&b.2)) {
                let Drift { instance, degree, alpha, .. } = drift;
                writeln!(
                    f,
                    "f64 against exact, {title}: {error} ULP is the largest found (of {tried} tried on each instance), on {instance} with k = {degree}, α = {alpha}."
                )?;
            }
        }
        for path in &self.written {
            writeln!(f, "Written: {}", visible_path(path))?;
        }
        match self.differences.as_slice() {
            [] => write!(f, "Every verdict is as recorded."),
            differences => {
                writeln!(f, "Not as recorded: {}", differences.len())?;
                differences.iter().try_for_each(|difference| writeln!(f, "  {difference}"))
            }
        }
    }
}
