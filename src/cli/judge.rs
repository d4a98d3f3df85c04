//! The command `judge`: every claim of a paper, in a folder or by name.

use std::ffi::{OsStr, OsString};
use std::fmt;
use std::ops::RangeInclusive;
use std::path::{Path, PathBuf};

use schemars::{JsonSchema, schema_for};
use serde::Serialize;

use crate::language::{Claim, Form, Paper, Source};
use crate::meaning::examples_of;
use crate::report::{
    Baseline, Difference, Drift, Errata, Finding, PageSource, Record, Report, by_severity,
    dependence_picture, errata_page, figures, markdown, opening, page,
};
use crate::settle::SettleError;
use crate::typed::TypedError;

use super::atomic::{Folder, write_atomically};
use super::error::CliError;
use super::exit::Exit;
use super::file::{InstanceFile, read};
use super::output::{Output, pretty_json, stamped_json};
use super::paper::paper_of;
use super::progress::Progress;
use super::table::plain;
use super::verdict::{Tally, styled, styled_as_printed};
use super::visible::{visible, visible_path};

/// Judges every claim of a paper: as printed and, where that is refuted, as amended; with its report, if a folder is named
/// for it.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLE)]
pub(super) struct Args {
    /// The folder of the paper, as docs/your-paper.md says, or the name of one that comes with the program.
    #[arg(value_name = "FOLDER|NAME")]
    paper: OsString,
    /// Writes report.json, report.md, errata.md, index.html, a page to read in a browser, pictures of the paper's instances and
    /// its certificates into this folder, which is made if it is not there.
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Judges only this claim; may be repeated.
    #[arg(long, value_name = "CLAIM")]
    claim: Vec<String>,
    /// Judges only cases of these degrees, one or the first and the last: 2 or 1..3. Nothing is proved beyond them.
    #[arg(long, value_name = "RANGE")]
    degrees: Option<String>,
    /// Compares with the verdicts in this file, which --record has written: what counts is then that each is as it was,
    /// refuted ones included.
    #[arg(long, value_name = "FILE", conflicts_with = "degrees")]
    baseline: Option<PathBuf>,
    /// Accepts the verdicts: writes them into this file, for --baseline.
    #[arg(long, value_name = "FILE", conflicts_with_all = ["claim", "degrees", "baseline"])]
    record: Option<PathBuf>,
}

const EXAMPLE: &str = "\
Examples:
  knotproof judge classical  # exit code 1
  knotproof new my-paper && knotproof judge my-paper --out my-report  # exit code 1
  knotproof judge my-paper --claim P2 --degrees 1..3 --format json  # exit code 1
  knotproof judge my-paper --record my-paper/verdicts.json  # exit code 1
  knotproof judge my-paper --baseline my-paper/verdicts.json
Exit code 0: every claim holds as printed. Exit code 1: one is refuted, if only as printed. Exit code 3: one is undecided.
With --baseline, exit code 0: every verdict is as recorded. Exit code 1: one differs.";

const JSON: &str = "report.json";
const MARKDOWN: &str = "report.md";
const PAGE: &str = "index.html";
pub(super) const ERRATA: &str = "errata.md";
const DEPENDENCE: &str = "dependence.svg";
const SCHEMA: &str = "instance.schema.json";
/// The folder of the certificates, in that of the report.
const CERTIFICATES: &str = "certs";
/// What lies beside the page of every report.
pub(super) const BESIDE: [(&str, &str); 3] =
    [("the errata", ERRATA), ("this report as data", JSON), ("and as text", MARKDOWN)];
pub(super) const INSTANCE_SCHEMA: (&str, &str) = ("the schema of instance files", SCHEMA);

/// The result: its fields are the JSON.
#[derive(Debug, Serialize, JsonSchema)]
pub(super) struct Judged<'a> {
    /// What this object is: `knotproof.judge/1`.
    #[schemars(extend("const" = "knotproof.judge/1"))]
    schema: &'static str,
    #[serde(flatten)]
    report: Report<'a>,
    /// The verdicts that are not as recorded; left out unless they are compared with some.
    #[serde(skip_serializing_if = "Option::is_none")]
    differences: Option<Vec<Difference>>,
    #[serde(skip)]
    written: Vec<PathBuf>,
    /// The instances that there is no picture of.
    #[serde(skip)]
    undrawn: Vec<String>,
}

/// Judges, writes the files and prints.
pub(super) fn run(args: &Args, output: &Output) -> Result<Exit, CliError> {
    let paper = paper_of("FOLDER", &args.paper)?;
    let chosen = choose(Claim::of(&paper).collect(), &args.claim)?;
    let degrees = args.degrees.as_deref().map(degrees).transpose()?;
    // Whatever can be wrong with the files is found out before the work begins.
    let baseline = args.baseline.as_deref().map(read_baseline).transpose()?;
    if let Some(folder) = &args.out {
        Folder::try_out("--out", folder)?;
    }
    let progress = Progress::new(chosen.len());
    let report =
        Report::of(&paper, &chosen, degrees.as_ref(), |done, name| progress.reach(done as u64, name));
    let report = report.map_err(|error| settle_error("FOLDER", &paper, &args.paper, error))?;
    drop(progress);
    let found = Baseline::of(&report.claims);
    let partial = !args.claim.is_empty();
    let differences = baseline.map(|baseline| baseline.differences(&found, partial));
    let (written, undrawn) = (Vec::new(), Vec::new());
    let mut judged = Judged { schema: "knotproof.judge/1", report, differences, written, undrawn };
    if let Some(folder) = &args.out {
        let compared = args.baseline.as_ref().map(|path| path.display().to_string());
        (judged.written, judged.undrawn) = write(folder, &judged, &paper, compared.as_deref())?;
    }
    if let Some(file) = &args.record {
        write_atomically("--record", file, pretty_json(&found)?)?;
        judged.written.push(file.clone());
    }
    output.result(&judged)?;
    if let Some(differences) = &judged.differences {
        return Ok(if differences.is_empty() { Exit::Holds } else { Exit::Refuted });
    }
    let records = judged.report.claims.iter();
    let all: Tally = records
        .flat_map(|record| [Some(&record.as_printed), record.amended.as_ref()])
        .flatten()
        .map(|stated| &stated.finding)
        .collect();
    Ok(all.exit())
}

/// The verdicts in a file.
pub(super) fn read_baseline(path: &Path) -> Result<Baseline, CliError> {
    let text = read("--baseline", path)?;
    Baseline::parse(&text).map_err(|error| CliError::Baseline { path: path.to_owned(), error })
}

/// Verdicts beside recorded ones.
pub(super) fn compared(f: &mut fmt::Formatter<'_>, differences: &[Difference]) -> fmt::Result {
    match differences {
        [] => writeln!(f, "Every verdict is as recorded."),
        differences => {
            writeln!(f, "Not as recorded: {}", differences.len())?;
            differences.iter().try_for_each(|difference| writeln!(f, "  {difference}"))
        }
    }
}

/// Of a paper in a folder, what is wrong with its windows is no bug of the program.
#[must_use]
pub fn settle_error(argument: &'static str, paper: &Paper, folder: &OsStr, error: SettleError) -> CliError {
    match error {
        SettleError::Certificate(error) if paper.called.is_some() => CliError::Windows {
            argument,
            path: Path::new(folder).join("windows.toml"),
            error: Box::new(error),
        },
        SettleError::Member(error) => TypedError::Member { argument, error }.into(),
        error => error.into(),
    }
}

/// `2`, or `1..3`, as the language has it.
fn degrees(text: &str) -> Result<RangeInclusive<usize>, CliError> {
    let (first, last) = text.split_once("..").unwrap_or((text, text));
    match (first.trim().parse(), last.trim().parse()) {
        (Ok(first), Ok(last)) if first <= last => Ok(first..=last),
        _ => Err(CliError::Degrees(text.to_owned())),
    }
}

/// The claims of these identifiers, or all if there are none.
pub(super) fn choose<'a>(mut all: Vec<Claim<'a>>, names: &[String]) -> Result<Vec<Claim<'a>>, CliError> {
    let ids: Vec<_> = all.iter().map(Claim::id).collect();
    if let Some(name) = names.iter().find(|name| !ids.contains(&name.as_str())) {
        return Err(CliError::unknown_claim("--claim", name, &ids));
    }
    all.retain(|claim| names.is_empty() || names.iter().any(|name| name == claim.id()));
    Ok(all)
}

/// The files that every report has; `json` is the result.
pub(super) fn report_files(
    json: &impl Serialize,
    report: &Report<'_>,
    source: &PageSource<'_>,
    certificates: &str,
) -> Result<Vec<(String, String)>, CliError> {
    let mut files = vec![
        (JSON.to_owned(), stamped_json(json)? + "\n"),
        (MARKDOWN.to_owned(), markdown(report, certificates)),
        (ERRATA.to_owned(), errata_page(&Errata::of(report))),
    ];
    if !report.dependence.uses.is_empty() {
        files.push((DEPENDENCE.to_owned(), dependence_picture(report)?));
    }
    files.push((SCHEMA.to_owned(), pretty_json(&schema_for!(InstanceFile))?));
    files.push((PAGE.to_owned(), page(report, source)?));
    Ok(files)
}

/// Writes the report with the pictures of the paper's own instances and its certificates; gives the files, and the instances
/// that can't be drawn.
fn write(
    folder: &Path,
    judged: &Judged<'_>,
    paper: &Paper,
    name: Option<&str>,
) -> Result<(Vec<PathBuf>, Vec<String>), CliError> {
    let report = &judged.report;
    let (mut pictures, mut undrawn) = (Vec::new(), Vec::new());
    for example in examples_of(&paper.examples, &paper.about.family) {
        let own = figures::pictures(&example)?;
        if own.is_empty() {
            undrawn.push(format!("{}, degree {}", example.name, example.degree));
        }
        pictures.extend(own);
    }
    let drawn: Vec<_> = pictures.iter().map(|picture| (picture.title.clone(), picture.svg.clone())).collect();
    let mut beside = BESIDE.to_vec();
    beside.push(INSTANCE_SCHEMA);
    let source = PageSource {
        compared: name.zip(judged.differences.as_deref()),
        pictures: &[],
        instances: &drawn,
        certificates: (!report.certificates.is_empty()).then_some(CERTIFICATES),
        theory: None,
        beside: &beside,
    };
    let mut files = report_files(judged, report, &source, CERTIFICATES)?;
    files.extend(pictures.into_iter().map(|picture| (picture.file, picture.svg)));
    for (name, certified) in &report.certificates {
        files.push((format!("{CERTIFICATES}/{name}.statement"), certified.certificate.statement_text()));
        files.push((format!("{CERTIFICATES}/{name}.proof"), certified.certificate.proof_text()));
    }
    let fresh = Folder::beside("--out", folder)?;
    let written = files.into_iter().map(|(name, text)| fresh.write(&name, text)).collect::<Result<_, _>>()?;
    fresh.put_in_place()?;
    Ok((written, undrawn))
}

/// A report on a terminal: what matters, the tables of verdicts, and the files.
pub(super) struct Shown<'a> {
    pub(super) report: &'a Report<'a>,
    pub(super) written: &'a [PathBuf],
}

/// A row for each claim, the worst refutations first.
fn table(records: &[&Record]) -> comfy_table::Table {
    let header = ["claim", "where", "as printed", "as amended", "statement"];
    let mut table = plain(header);
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

impl fmt::Display for Shown<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for line in opening(self.report) {
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
        for path in self.written {
            writeln!(f, "Written: {}", visible_path(path))?;
        }
        Ok(())
    }
}

/// The same, with what is wrong in between, and how to see it again.
impl fmt::Display for Judged<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let about = &self.report.of.about;
        writeln!(f, "{}\n", visible(&about.to_string()))?;
        write!(f, "{}", Shown { report: &self.report, written: &self.written })?;
        for instance in &self.undrawn {
            writeln!(f, "Not drawn: {instance}: its numbers are too large for f64, or too close")?;
        }
        let mut told = |id: &str, form: Form, finding: &Finding| -> fmt::Result {
            let of = match form {
                Form::Printed => "",
                Form::Amended => ", amended",
                _ => ", where the amended sentence says nothing",
            };
            if let Some(witness) = &finding.witness {
                writeln!(f, "\n{id}{of}: {witness}")?;
                writeln!(f, "  again: {}", witness.again(id, form, self.report.of))?;
            } else if let Some(reason) = finding.reason.as_ref().filter(|_| !finding.is_proved()) {
                writeln!(f, "\n{id}{of}, {}: {reason}", finding.status)?;
            }
            Ok(())
        };
        for record in &self.report.claims {
            told(&record.id, Form::Printed, &record.as_printed.finding)?;
            for (form, stated) in [(Form::Amended, &record.amended), (Form::Fails, &record.fails)] {
                if let Some(stated) = stated {
                    told(&record.id, form, &stated.finding)?;
                }
            }
        }
        if let Some(differences) = &self.differences {
            writeln!(f)?;
            compared(f, differences)?;
        }
        Ok(())
    }
}
