//! The report as Markdown, and the page with the table of recorded verdicts.

use std::fmt::Write as _;

use crate::language::{About, Form, Paper, Source};
use crate::study::MethodRecord;

use super::baseline::{Baseline, Entry};
use super::corners::Corner;
use super::dependence::Dependency;
use super::opening::opening;
use super::record::{Grounds, Record, Stated, THEORY, TheoremRecord, by_severity};
use super::{Drift, Report};

/// `docs/verdicts.md`: one row a claim, with certificates and theorems as links.
#[must_use]
pub fn verdicts_page(baseline: &Baseline) -> String {
    let row = |entry: &Entry| {
        let amended = entry.amended.as_ref().map(super::Finding::words).unwrap_or_default();
        let certificates: Vec<_> = entry.certificates().map(certificate).collect();
        let theorems: Vec<_> = entry.theorems().map(theorem).collect();
        let (id, locator, printed) = (&entry.id, &entry.locator, entry.as_printed.words());
        let (certificates, theorems) = (certificates.join(", "), theorems.join(", "));
        format!("| `{id}` | {locator} | {printed} | {amended} | {certificates} | {theorems} |\n")
    };
    let rows: String = baseline.claims.iter().map(row).collect();
    format!(
        "{VERDICTS}\n\n| claim | where | as printed | as amended | certificates | theorems |\n|---|---|---|---|---|---|\n{rows}"
    )
}

const VERDICTS: &str = "# The verdicts\n\nWritten by `knotproof report --record` from `proofs/verdicts.json`, not by hand; a test \
holds the two together, and `knotproof report` fails if a verdict is no longer what is recorded. The witnesses are in the report. \
*degree* is said where a [theorem](../proofs/theory/README.md) that Coq has checked says so of every degree.";

fn certificate(name: &str) -> String {
    let short = name.rsplit('.').next().unwrap_or(name);
    format!("[{short}](../proofs/certs/{name}.statement)")
}

fn theorem(of: &TheoremRecord) -> String {
    let false_for = if of.status == "refuted" { format!(" ({})", of.says()) } else { String::new() };
    format!("[`{}`](../{THEORY}/{}){false_for}", of.name, of.file)
}

/// Text without a character that Markdown would take for markup.
pub(super) fn plain(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for c in text.chars() {
        if matches!(c, '|' | '_' | '*' | '<' | '>' | '[' | ']' | '`' | '\\' | '^') {
            escaped.push('\\');
        }
        escaped.push(c);
    }
    escaped
}

/// Where readers find what the text names.
struct Place<'a> {
    /// The paper.
    paper: &'a Paper,
    /// The folder of certificates.
    certificates: &'a str,
}

/// What there is to say about one statement of a claim, as the items of a list.
fn items((claim, form): (&str, Form), stated: &Stated, of: &Place<'_>) -> Vec<String> {
    let finding = &stated.finding;
    let mut items = Vec::new();
    items.extend(stated.rests_on.as_ref().map(decided));
    items.extend(finding.witness.iter().map(|witness| format!("witness: {}", plain(&witness.to_string()))));
    items.extend(
        finding.witness.iter().map(|witness| format!("again: `{}`", witness.again(claim, form, of.paper))),
    );
    items.extend(finding.reason.iter().chain(&finding.remarks).map(|text| plain(text)));
    items.extend(finding.certificate.iter().map(|name| format!("certificate: `{}/{name}`", of.certificates)));
    items.extend(finding.theorems.iter().map(|theorem| format!("theorem: {}", plain(&theorem.words()))));
    if !finding.checked_by.is_empty() {
        items.push(format!("found or checked by: {}", finding.checked_by.join(", ")));
    }
    items
}

fn decided(grounds: &Grounds) -> String {
    let Grounds { instances, small_cases, facts } = grounds;
    format!(
        "decided on {instances} instances of the paper and {small_cases} small cases, by {facts} exact decisions"
    )
}

fn section<'a>(record: &'a Record, of: &Place<'_>) -> String {
    let mut text = format!("### {} ({}): {}\n\n", record.id, record.locator, plain(&record.title));
    let other = |form, title, stated: &'a Option<Stated>| {
        stated.as_ref().map(|stated| (form, title, stated.finding.words(), stated))
    };
    let amended = other(Form::Amended, "As amended", &record.amended);
    let fails = other(Form::Fails, "Elsewhere", &record.fails);
    // Writing to a string cannot fail.
    let printed = (Form::Printed, "As printed", record.words(), &record.as_printed);
    for (form, title, words, stated) in std::iter::once(printed).chain(amended).chain(fails) {
        let _ = writeln!(text, "**{title}: {words}.** {}\n", plain(&stated.statement));
        for item in items((&record.id, form), stated, of) {
            let _ = writeln!(text, "- {item}");
        }
        text.push('\n');
    }
    if let Some((severity, because)) = record.severity.zip(record.severity_because.as_ref()) {
        let cause = record.cause.map_or(super::summary::UNASSIGNED, |cause| cause.words());
        let _ = writeln!(text, "Cause: {}. Severity: {}, {because}.\n", plain(cause), severity.name());
    }
    for of in &record.by_degree {
        let witness = of.finding.witness.as_ref().map(|witness| plain(&witness.to_string()));
        let detail = witness.or(of.rests_on.as_ref().map(decided)).map(|detail| format!("; {detail}"));
        let _ =
            writeln!(text, "- degree {}: {}{}", of.degree, of.finding.words(), detail.unwrap_or_default());
    }
    if !record.by_degree.is_empty() {
        text.push('\n');
    }
    if let Some(note) = &record.note {
        let _ = writeln!(text, "{}\n", plain(note));
    }
    text
}

fn drift_table(drifts: &[Drift]) -> String {
    let cells = |of: &MethodRecord| {
        let place = of.worst.as_ref().map(|worst| format!("G_{} at {}", worst.index, worst.float.x));
        let bound = of.proved();
        let bound = if bound.is_empty() { bound } else { format!(" {bound} |") };
        let (error, place) = (of.max_ulp.as_deref().unwrap_or(""), plain(&place.unwrap_or_default()));
        format!(" {error} | {place} |{bound}")
    };
    let row = |drift: &Drift| {
        let formulas: String = drift.formulas.iter().map(cells).collect();
        format!("| {} | {} | {} |{formulas}\n", drift.instance, drift.degree, drift.alpha)
    };
    let rows: String = drifts.iter().map(row).collect();
    let tried = drifts.iter().flat_map(|drift| &drift.formulas).map(|of| of.tried).max().unwrap_or(0);
    let found = format!("largest found (of {tried} tried), in ULP");
    format!(
        "| instance | k | α | the paper's formula: {found} | where | ours: {found} | where | proved to be at most |\n|---|---|---|---|---|---|---|---|\n{rows}"
    )
}

/// The table of one source, by severity, with the sentences.
fn table(report: &Report<'_>, source: Source) -> String {
    let row = |record: &Record| {
        let amended = record.amended.as_ref().map(|stated| stated.finding.words()).unwrap_or_default();
        let (id, locator, statement, words) =
            (&record.id, &record.locator, &record.statement, record.words());
        format!("| `{id}` | {} | {} | {words} | {amended} |\n", plain(locator), plain(statement))
    };
    let rows: String = by_severity(&report.claims, source).into_iter().map(row).collect();
    format!("| claim | where | statement | as printed | as amended |\n|---|---|---|---|---|\n{rows}")
}

/// What the paper says, and then what we ask, each with its counts; a source of which nothing was judged is left out.
fn verdicts(report: &Report<'_>) -> String {
    let sources = [
        ("The paper's statements", Source::Paper, &report.summary.paper),
        ("Our questions", Source::Question, &report.summary.questions),
    ];
    let section = |(title, source, counts): (&str, Source, &super::Counts)| {
        format!("## {title}\n\n{}.\n\n{}\n", counts.words(), table(report, source))
    };
    sources.into_iter().filter(|(_, _, counts)| counts.statements > 0).map(section).collect()
}

fn dependence(uses: &[Dependency]) -> String {
    let row = |one: &Dependency| {
        let (claim, premise, why) =
            (&one.claim, &one.rests_on, plain(one.why.as_deref().unwrap_or_default()));
        format!("| `{claim}` | `{premise}` | {} | {why} |\n", one.state.name())
    };
    let rows: String = uses.iter().map(row).collect();
    match uses {
        [] => String::new(),
        _ => format!(
            "## What depends on what\n\n![What rests on what that fails as printed](dependence.svg)\n\n\
             | claim | rests on | it | why |\n|---|---|---|---|\n{rows}\n"
        ),
    }
}

fn corner_table(corners: &[Corner]) -> String {
    let row = |corner: &Corner| {
        let Corner { instance, degree, alpha, knot, multiplicity, turn, .. } = corner;
        let (angle, ratio) =
            turn.as_ref().map_or(("–", "–"), |turn| (&turn.angle_degrees, &turn.speed_ratio));
        format!("| {instance} | {degree} | {alpha} | {knot} | {multiplicity} | {angle} | {ratio} |\n")
    };
    let rows: String = corners.iter().map(row).collect();
    format!(
        "| curve | k | α | knot | multiplicity | turn, degrees | speed, right over left |\n|---|---|---|---|---|---|---|\n{rows}"
    )
}

/// What was read, and what it is close to.
fn source(paper: &About) -> String {
    let related = paper.related.as_ref().map(|related| format!("\n\nRelated: {}", plain(related)));
    plain(&paper.to_string()) + &related.unwrap_or_default()
}

/// The whole report; `certificates` is the folder in which they are.
#[must_use]
pub fn markdown(report: &Report<'_>, certificates: &str) -> String {
    let of = Place { paper: report.of, certificates };
    let opening: String = opening(report).iter().map(|line| format!("- {}\n", plain(line))).collect();
    let sections: String = report.claims.iter().map(|record| section(record, &of)).collect();
    let (verdicts, source) = (verdicts(report), source(&report.of.about));
    let uses = dependence(&report.dependence.uses);
    let mut text = format!(
        "# Report on the paper's claims\n\n{opening}\n{source}\n\n{SCOPES}\n\n{verdicts}\n{uses}## Claim by claim\n\n{sections}"
    );
    if !report.corners.is_empty() {
        text += &format!("## Corners\n\n{CORNERS}\n\n{}", corner_table(&report.corners));
    }
    if !report.float.is_empty() {
        text += &format!("\n## f64 against exact\n\n{FLOATS}\n\n{}", drift_table(&report.float));
    }
    text
}

const CORNERS: &str = "At every knot inside the interval of every curve of the paper, for each α of its figures: by how much the tangent \
turns, and by what factor the speed changes. A classical curve has a continuous tangent where the multiplicity is less than k. Every \
digit is settled; exact numbers are in report.json. A dash: a one-sided derivative is 0.";

const SCOPES: &str = "Every verdict comes out of a computation in exact arithmetic. *proved (degree)* means: for every degree, \
by a theorem that Coq has checked; *proved (knots)*: for every knot vector and every α, in the degrees k that are given; *proved (alpha)*: on the examples of the paper, for every α; \
*proved (instance)*: decided for every x, on the instances of the paper and the small cases that are counted with each \
claim. *refuted* comes with the smallest counterexample found, exact and small enough to be checked by hand, and with its severity: \
*slip*, an end point or the range of an index; *hypothesis*, one is missing; *reading*, of a picture or a vague word; *serious*, the \
idea fails. The *engine* \
decides cases one by one; the *prover* proves formal statements, and the *checker*, a program by itself, reads the \
certificates that it writes; *coq* is said where a theorem says the same as they do. If two of them differ there is no report.";

const FLOATS: &str = "Knots and α rounded to `f64`, and then exact arithmetic on the same floats: the largest error that was found in \
units in the last place, which is not the largest there is, by the paper's formula and by `knotproof::float`, whose bound is proved in \
`docs/float.md`. `knotproof float --instance NAME` tries more. Nothing here enters a verdict.";
