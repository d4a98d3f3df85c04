//! The report as a page for people: one file, with all that it needs in it.
//!
//! The verdicts and the working of witnesses are exact and computed here; only the panel of the page, in `panel.js`,
//! computes in `f64`, and says so.

mod claim;
mod escape;
mod formula;
mod instances;
mod working;

use std::collections::BTreeSet;

use askama::Template;
use thiserror::Error;

use super::Report;
use super::baseline::Difference;

use claim::{Row, Section, row};

/// Why there is no page: a bug of this program.
#[derive(Debug, Error)]
#[error("the page of the report could not be written: {0}")]
pub struct PageError(#[from] askama::Error);

/// What a page is made from, besides the report.
#[derive(Debug, Clone, Copy)]
pub struct PageSource<'a> {
    /// What the verdicts were compared with, and what is not as it was there; `None` if with nothing.
    pub compared: Option<(&'a str, &'a [Difference])>,
    /// Pictures by the names of their files, as [`conjecture_page`](super::conjecture_page) gives them.
    pub pictures: &'a [(String, String)],
    /// Where the folder of certificates is, seen from the page; without it, certificates are only named.
    pub certificates: Option<&'a str>,
}

/// The template, and the fields that it shows.
#[derive(Template)]
#[template(path = "page.html")]
struct Page<'a> {
    style: &'static str,
    page_script: &'static str,
    panel_script: &'static str,
    instances: String,
    version: &'static str,
    tallies: Vec<(&'static str, usize)>,
    statuses: Vec<&'a str>,
    scopes: Vec<&'a str>,
    rows: Vec<Row<'a>>,
    sections: Vec<Section<'a>>,
    compared: Option<(&'a str, &'a [Difference])>,
}

/// The page: HTML with its style and its scripts, and no reference to anything outside but certificates.
///
/// The same report gives the same bytes.
///
/// # Errors
/// [`PageError`].
pub fn page(report: &Report, source: &PageSource<'_>) -> Result<String, PageError> {
    let rows: Vec<Row<'_>> = report.claims.iter().map(row).collect();
    let statuses = distinct(&rows, |row| row.status);
    let scopes = distinct(&rows, |row| row.scope);
    let tallies = ["proved", "refuted", "undecided", "not-formal"]
        .map(|status| (status, rows.iter().filter(|row| row.status == status).count()))
        .into_iter()
        .filter(|(_, count)| *count > 0)
        .collect();
    let page = Page {
        style: include_str!("page.css"),
        page_script: include_str!("page.js"),
        panel_script: include_str!("panel.js"),
        instances: instances::json(),
        version: env!("CARGO_PKG_VERSION"),
        tallies,
        statuses,
        scopes,
        sections: report.claims.iter().map(|record| Section::of(record, report, source)).collect(),
        rows,
        compared: source.compared,
    };
    Ok(page.render()?)
}

/// The different words in a column, without the empty one.
fn distinct<'a>(rows: &[Row<'a>], of: impl Fn(&Row<'a>) -> &'a str) -> Vec<&'a str> {
    let words: BTreeSet<&str> = rows.iter().map(of).filter(|word| !word.is_empty()).collect();
    words.into_iter().collect()
}
