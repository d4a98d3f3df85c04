//! The report as a page for people: one file, with all that it needs in it.
//!
//! The verdicts and the working of witnesses are exact and computed here. What the page computes itself, for its panel, and the
//! certificates that it checks, are the program too: the modules below `web/`, which `web/build.sh` compiles for WebAssembly.

mod claim;
mod embedded;
mod escape;
mod example;
mod formula;
mod panel;
mod working;

use std::collections::BTreeSet;
use std::io;

use askama::Template;
use thiserror::Error;

use super::baseline::Difference;
use super::corners::Corner;
use super::dependence::Dependency;
use super::opening::{headlines, opening};
use super::record::by_severity;
use super::{PictureError, Report, dependence_picture};

use crate::language::{About, Source};

use claim::{Figure, Row, Section, figures, row};
use embedded::{Module, certificates, modules};

/// Why there is no page: a bug of this program.
#[derive(Debug, Error)]
pub enum PageError {
    /// The template.
    #[error("the page of the report could not be written: {0}")]
    Template(#[from] askama::Error),
    /// A picture in it.
    #[error(transparent)]
    Picture(#[from] PictureError),
    /// The certificates in it.
    #[error("the certificates could not be put into the page: {0}")]
    Certificates(#[from] io::Error),
}

/// What a page is made from, besides the report.
#[derive(Debug, Clone, Copy)]
pub struct PageSource<'a> {
    /// What the verdicts were compared with, and what is not as it was there; `None` if with nothing.
    pub compared: Option<(&'a str, &'a [Difference])>,
    /// Pictures by the names of their files, as [`conjecture_page`](super::conjecture_page) gives them.
    pub pictures: &'a [(String, String)],
    /// Pictures of the paper's own instances: what is shown, and the picture.
    pub instances: &'a [(String, String)],
    /// Where the folder of certificates is, seen from the page; without it, certificates are only named.
    pub certificates: Option<&'a str>,
    /// Where the folder of the theorems is, seen from the page; without it, they are only named.
    pub theory: Option<&'a str>,
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
    modules_script: &'static str,
    worker_script: &'static str,
    /// What the panel knows of the paper, as JSON.
    panel_data: String,
    modules: Vec<Module>,
    packed_certificates: String,
    version: &'static str,
    paper: &'a About,
    title: String,
    /// What matters, in lines of HTML, one of them with a picture.
    opening: Vec<(String, Option<Figure<'a>>)>,
    drawn: &'a [(String, String)],
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
    theory: Option<&'a str>,
}

/// The page: HTML with its style and its scripts, and no reference to anything outside but certificates and theorems.
///
/// The same report gives the same bytes.
///
/// # Errors
/// [`PageError`].
pub fn page(report: &Report<'_>, source: &PageSource<'_>) -> Result<String, PageError> {
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
        modules_script: include_str!("modules.js"),
        worker_script: include_str!("worker.js"),
        panel_data: panel::json(report.of),
        modules: modules(),
        packed_certificates: certificates(report)?,
        version: env!("CARGO_PKG_VERSION"),
        paper: &report.of.about,
        title: title(&report.of.about),
        opening: lines(report, source),
        drawn: source.instances,
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
        theory: source.theory,
    };
    Ok(page.render()?)
}

fn title(about: &About) -> String {
    let subject = about.subject.clone();
    format!("Verdicts on {}", subject.unwrap_or_else(|| format!("“{}”", about.title)))
}

/// The lines of the opening; the first of the paper's own that has a picture is shown with it.
fn lines<'a>(report: &Report<'_>, source: &PageSource<'a>) -> Vec<(String, Option<Figure<'a>>)> {
    let mut pictured = headlines(report)
        .filter_map(|(claim, line)| Some((line, figures(claim, source.pictures).into_iter().next()?)));
    let (pictured, mut figure) = pictured.next().unzip();
    let line = |line: &String| {
        let own = if pictured.as_ref() == Some(line) { figure.take() } else { None };
        (formula::html(line), own)
    };
    opening(report).iter().map(line).collect()
}

/// The different words in a column, without the empty one.
fn distinct<'a>(rows: &[Row<'a>], of: impl Fn(&Row<'a>) -> &'a str) -> Vec<&'a str> {
    let words: BTreeSet<&str> = rows.iter().map(of).filter(|word| !word.is_empty()).collect();
    words.into_iter().collect()
}
