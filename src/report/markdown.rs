//! The report as Markdown, and the table of verdicts that the README shows.

use std::fmt::Write as _;

use crate::float::FormulaRecord;

use super::baseline::{Baseline, Entry};
use super::record::{Finding, Grounds, Record, Stated};
use super::{Drift, Report};

/// The table of verdicts: one row a claim. With `links`, certificates are links from the top folder of the project.
fn verdict_table(baseline: &Baseline, links: bool) -> String {
    let row = |entry: &Entry| {
        let amended = entry.amended.as_ref().map(verdict).unwrap_or_default();
        let certificates: Vec<_> = entry.certificates().map(|name| certificate(name, links)).collect();
        let (id, locator, printed) = (&entry.id, &entry.locator, verdict(&entry.as_printed));
        format!("| `{id}` | {locator} | {printed} | {amended} | {} |\n", certificates.join(", "))
    };
    let rows: String = baseline.claims.iter().map(row).collect();
    format!("| claim | where | as printed | as amended | certificates |\n|---|---|---|---|---|\n{rows}")
}

fn certificate(name: &str, links: bool) -> String {
    let short = name.rsplit('.').next().unwrap_or(name);
    if links { format!("[{short}](proofs/certs/{name}.statement)") } else { format!("`{name}`") }
}

/// The line before the table of verdicts in the README.
pub const START: &str = "<!-- verdicts: written by `knotproof report --record`, not by hand -->";
/// The line after it.
pub const END: &str = "<!-- end of verdicts -->";

/// The text with the table of verdicts between its two marks; `None` if a mark is missing.
#[must_use]
pub fn with_verdict_table(text: &str, baseline: &Baseline) -> Option<String> {
    let (before, rest) = text.split_once(START)?;
    let (_, after) = rest.split_once(END)?;
    Some(format!("{before}{START}\n\n{}\n{END}{after}", verdict_table(baseline, true)))
}

fn verdict(finding: &Finding) -> String {
    match finding.reach() {
        Some(reach) => format!("{} ({reach})", finding.status),
        None => finding.status.clone(),
    }
}

/// Text without a character that Markdown would take for markup.
fn plain(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for c in text.chars() {
        if matches!(c, '|' | '_' | '*' | '<' | '>' | '[' | ']' | '`' | '\\' | '^') {
            escaped.push('\\');
        }
        escaped.push(c);
    }
    escaped
}

/// What there is to say about one statement, as the items of a list.
fn items(stated: &Stated) -> Vec<String> {
    let finding = &stated.finding;
    let mut items = Vec::new();
    if !stated.hypotheses.is_empty() {
        items.push(format!("assuming: {}", plain(&stated.hypotheses.join("; "))));
    }
    items.extend(stated.rests_on.as_ref().map(decided));
    items.extend(finding.witness.iter().map(|witness| format!("witness: {}", plain(&witness.to_string()))));
    let command = finding.witness.as_ref().and_then(|witness| witness.reproduce.as_ref());
    items.extend(command.map(|command| format!("again: `{command}`")));
    items.extend(finding.reason.iter().chain(&finding.remarks).map(|text| plain(text)));
    items.extend(finding.certificate.iter().map(|name| format!("certificate: `proofs/certs/{name}`")));
    if !finding.checked_by.is_empty() {
        items.push(format!("found or checked by: {}", finding.checked_by.join(", ")));
    }
    items.extend(stated.sharpness.map(|sharpness| {
        format!(
            "of {} cases that the extra hypotheses exclude, the printed statement fails in {}",
            sharpness.excluded, sharpness.failing
        )
    }));
    items
}

fn decided(grounds: &Grounds) -> String {
    let Grounds { instances, small_cases, facts } = grounds;
    format!(
        "decided on {instances} instances of the paper and {small_cases} small cases, by {facts} exact decisions"
    )
}

fn section(record: &Record) -> String {
    let mut text = format!("### {} ({})\n\n", record.id, record.locator);
    let parts =
        [Some(("As printed", &record.as_printed)), record.amended.as_ref().map(|s| ("As amended", s))];
    // Writing to a string cannot fail.
    for (title, stated) in parts.into_iter().flatten() {
        let _ = writeln!(text, "**{title}: {}.** {}\n", verdict(&stated.finding), plain(&stated.statement));
        for item in items(stated) {
            let _ = writeln!(text, "- {item}");
        }
        text.push('\n');
    }
    for of in &record.by_degree {
        let witness = of.finding.witness.as_ref().map(|witness| plain(&witness.to_string()));
        let detail = witness.or(of.rests_on.as_ref().map(decided)).map(|detail| format!("; {detail}"));
        let _ =
            writeln!(text, "- degree {}: {}{}", of.degree, verdict(&of.finding), detail.unwrap_or_default());
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
    let cells = |of: &FormulaRecord| {
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

/// The whole report.
#[must_use]
pub fn markdown(report: &Report) -> String {
    let sections: String = report.claims.iter().map(section).collect();
    let table = verdict_table(&Baseline::of(&report.claims), false);
    let drifts = drift_table(&report.float);
    let paper = plain(&report.paper.to_string());
    format!(
        "# Report on the paper's claims\n\n{paper}\n\n{SCOPES}\n\n## Verdicts\n\n{table}\n## Claim by claim\n\n{sections}## f64 against exact\n\n{FLOATS}\n\n{drifts}"
    )
}

const SCOPES: &str = "Every verdict comes out of a computation in exact arithmetic. *proved (knots)* means: for \
every knot vector and every α, in the degrees k that are given; *proved (alpha)*: on the examples of the paper, for every α; \
*proved (instance)*: decided for every x, on the instances of the paper and the small cases that are counted with each \
claim. *refuted* comes with the smallest counterexample found, exact and small enough to be checked by hand. The *engine* \
decides cases one by one; the *prover* proves formal statements, and the *checker*, a program by itself, reads the \
certificates that it writes.";

const FLOATS: &str = "Knots and α rounded to `f64`, and then exact arithmetic on the same floats: the largest error that was found in \
units in the last place, which is not the largest there is, by the paper's formula and by `knotproof::float`, whose bound is proved in \
`docs/float.md`. `knotproof float --instance NAME` tries more. Nothing here enters a verdict.";
