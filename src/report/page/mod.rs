//! The report as a page for people: one file, with all that it needs in it.
//!
//! The verdicts and the working of witnesses are exact and computed here; only the panel of the page, in `panel.js`,
//! computes in `f64`, and says so.

mod claim;
mod escape;
mod example;
mod formula;
mod instances;
mod working;

use std::collections::BTreeSet;

use askama::Template;
use thiserror::Error;

use super::baseline::Difference;
use super::corners::Corner;
use super::dependence::Dependency;
use super::opening::{CONJECTURE, opening};
use super::record::by_severity;
use super::{PictureError, Report, dependence_picture};

use crate::language::Source;

use claim::{Figure, Row, Section, figures, row};

/// Why there is no page: a bug of this program.
#[derive(Debug, Error)]
pub enum PageError {
    /// The template.
    #[error("the page of the report could not be written: {0}")]
    Template(#[from] askama::Error),
    /// A picture in it.
    #[error(transparent)]
    Picture(#[from] PictureError),
}

/// What a page is made from, besides the report.
#[derive(Debug, Clone, Copy)]
pub struct PageSource<'a> {
    /// What the verdicts were compared with, and what is not as it was there; `None` if with nothing.
    pub compared: Option<(&'a str, &'a [Difference])>,
    /// Pictures by the names of their files, as [`conjecture_page`](super::conjecture_page) gives them.
    pub pictures: &'a [(String, String)],
    /// Where the folder of certificates is, seen from the page; without it, certificates are only named.
    pub certificates: Option<&'a str>,
    /// What there is beside the page: what it is, and the name of its file.
    pub beside: &'a [(&'a str, &'a str)],
}

/// One source of statements, with its counts and its rows.
struct Table<'a> {
    id: &'static str,
    title: &'static str,
    counts: String,
    rows: Vec<Row<'a>>,
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
    paper: &'static crate::language::About,
    /// What matters, in lines of HTML, and the picture of the conjecture.
    opening: Vec<String>,
    picture: Option<Figure<'a>>,
    count: usize,
    statuses: Vec<&'a str>,
    severities: Vec<&'a str>,
    scopes: Vec<&'a str>,
    tables: Vec<Table<'a>>,
    uses: Vec<(&'a Dependency, String)>,
    dependence: String,
    corners: &'a [Corner],
    sections: Vec<Section<'a>>,
    compared: Option<(&'a str, &'a [Difference])>,
    beside: &'a [(&'a str, &'a str)],
    certificates: Option<&'a str>,
}

/// The page: HTML with its style and its scripts, and no reference to anything outside but certificates.
///
/// The same report gives the same bytes.
///
/// # Errors
/// [`PageError`].
pub fn page(report: &Report, source: &PageSource<'_>) -> Result<String, PageError> {
    let rows: Vec<Row<'_>> = report.claims.iter().map(row).collect();
    let table = |id, title, source, counts: &super::Counts| Table {
        id,
        title,
        counts: counts.words(),
        rows: by_severity(&report.claims, source).into_iter().map(row).collect(),
    };
    let tables = [
        table("table", "The paper's statements", Source::Paper, &report.summary.paper),
        table("questions", "Our questions", Source::Question, &report.summary.questions),
    ];
    let why = |one: &'_ Dependency| formula::html(one.why.as_deref().unwrap_or_default());
    let uses = &report.dependence.uses;
    let page = Page {
        style: include_str!("page.css"),
        page_script: include_str!("page.js"),
        panel_script: include_str!("panel.js"),
        instances: instances::json(),
        version: env!("CARGO_PKG_VERSION"),
        paper: report.paper,
        opening: opening(report).iter().map(|line| formula::html(line)).collect(),
        picture: figures(CONJECTURE, source.pictures).into_iter().next(),
        count: rows.len(),
        statuses: distinct(&rows, |row| row.status),
        severities: distinct(&rows, |row| row.severity),
        scopes: distinct(&rows, |row| row.scope),
        tables: tables.into_iter().filter(|table| !table.rows.is_empty()).collect(),
        uses: uses.iter().map(|one| (one, why(one))).collect(),
        dependence: if uses.is_empty() { String::new() } else { dependence_picture(report)? },
        corners: &report.corners,
        sections: report.claims.iter().map(|record| Section::of(record, report, source)).collect(),
        compared: source.compared,
        beside: source.beside,
        certificates: source.certificates,
    };
    Ok(page.render()?)
}

/// The different words in a column, without the empty one.
fn distinct<'a>(rows: &[Row<'a>], of: impl Fn(&Row<'a>) -> &'a str) -> Vec<&'a str> {
    let words: BTreeSet<&str> = rows.iter().map(of).filter(|word| !word.is_empty()).collect();
    words.into_iter().collect()
}
