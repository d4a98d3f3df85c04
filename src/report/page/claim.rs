//! What the page shows of one claim.

use super::super::Report;
use super::super::figures::all;
use super::super::record::{Finding, Grounds, Record, Stated, TheoremRecord};
use super::super::summary::UNASSIGNED;
use super::example::{self, Example, example};
use super::working::{Working, function, workings};
use super::{PageSource, formula};

use crate::judge::Witness;
use crate::language::{Form, Paper, Severity};

/// One row of the table of verdicts.
pub(super) struct Row<'a> {
    pub(super) id: &'a str,
    pub(super) locator: &'a str,
    pub(super) title: &'a str,
    /// The sentence, in HTML.
    pub(super) statement: String,
    pub(super) status: &'a str,
    /// Of a refutation: its severity; empty if there is none.
    pub(super) severity: &'a str,
    pub(super) badge: String,
    pub(super) printed: String,
    pub(super) amended: String,
    pub(super) amended_status: &'a str,
    /// How far the statement that stands is proved; empty if none is.
    pub(super) scope: &'a str,
    /// What the search looks through.
    pub(super) text: String,
}

/// The classes of a badge: a refutation is red only if it is serious.
fn badge(record: &Record) -> String {
    let status = &record.as_printed.finding.status;
    if record.is_serious() { format!("{status} serious") } else { status.clone() }
}

/// The row of a claim.
pub(super) fn row(record: &Record) -> Row<'_> {
    let printed = &record.as_printed.finding;
    let amended = record.amended.as_ref().map(|stated| &stated.finding);
    let standing = amended.unwrap_or(printed);
    let amended_text = record.amended.as_ref().map_or("", |stated| stated.statement.as_str());
    let note = record.note.as_deref().unwrap_or("");
    let text = [&record.id, &record.locator, &record.title, &record.statement, amended_text, note];
    Row {
        id: &record.id,
        locator: &record.locator,
        title: &record.title,
        statement: formula::html(&record.statement),
        status: &printed.status,
        severity: record.severity.map_or("", Severity::name),
        badge: badge(record),
        printed: record.words(),
        amended: amended.map(Finding::words).unwrap_or_default(),
        amended_status: amended.map_or("", |finding| finding.status.as_str()),
        scope: standing.scope.as_deref().unwrap_or(""),
        text: text.join(" ").to_lowercase(),
    }
}

/// All about one claim.
pub(super) struct Section<'a> {
    pub(super) row: Row<'a>,
    pub(super) statement: &'a str,
    pub(super) parts: Vec<Part<'a>>,
    pub(super) degrees: Vec<OfDegree<'a>>,
    /// What stands behind a refutation, how bad it is, and why.
    pub(super) cause: Option<String>,
    pub(super) example: Option<Example>,
    pub(super) note: Option<String>,
    pub(super) figures: Vec<Figure<'a>>,
    pub(super) command: String,
}

/// A statement, as printed or as amended.
pub(super) struct Part<'a> {
    pub(super) title: &'static str,
    pub(super) badge: String,
    pub(super) verdict: String,
    pub(super) statement: String,
    pub(super) grounds: Option<String>,
    pub(super) reason: Option<String>,
    pub(super) witness: Option<Shown>,
    pub(super) remarks: &'a [String],
    pub(super) certificate: Option<Certificate<'a>>,
    pub(super) theorems: &'a [TheoremRecord],
    pub(super) checked_by: String,
}

/// A witness with its working.
pub(super) struct Shown {
    pub(super) given: Vec<(String, String)>,
    pub(super) claimed: String,
    pub(super) found: String,
    pub(super) workings: Vec<Working>,
    pub(super) command: String,
    pub(super) panel: Option<String>,
}

/// The verdict for one degree.
pub(super) struct OfDegree<'a> {
    pub(super) degree: usize,
    pub(super) status: &'a str,
    pub(super) verdict: String,
    pub(super) witness: Option<Shown>,
    pub(super) grounds: Option<String>,
    pub(super) certificate: Option<Certificate<'a>>,
    pub(super) theorems: &'a [TheoremRecord],
}

/// A certificate by its name.
pub(super) struct Certificate<'a> {
    pub(super) name: &'a str,
    pub(super) folder: Option<&'a str>,
    pub(super) steps: Option<usize>,
}

/// A picture that belongs to a claim.
pub(super) struct Figure<'a> {
    pub(super) caption: &'static str,
    pub(super) svg: &'a str,
}

/// Which picture of the page on the conjecture belongs to which claim. These and the [figures](all) are shown once each.
const FIGURES: &[(&str, &str, &str)] = &[
    (
        "Conj3.1.strong.continuous",
        "conjecture-two-maxima.svg",
        "Two local maxima, the smallest example of degree 3. Right: the part around them, with the minimum between them (open) at a knot.",
    ),
    (
        "Conj3.1.weak.continuous",
        "conjecture-left-higher.svg",
        "At the first α the left maximum is the higher one.",
    ),
    (
        "Conj3.1.weak.continuous",
        "conjecture-right-higher.svg",
        "At the second α the right maximum is the higher one: for some α between they are equal.",
    ),
    (
        "X.maxima",
        "conjecture-uniform.svg",
        "Uniform knots: the number of local maxima for every r, degree by degree.",
    ),
    ("X.maxima.most", "conjecture-degree-4.svg", "Three local maxima in degree 4."),
    ("X.maxima.most", "conjecture-degree-5.svg", "Four local maxima in degree 5."),
];

/// The figures of a claim, out of the pictures that there are.
pub(super) fn figures<'a>(claim: &str, pictures: &'a [(String, String)]) -> Vec<Figure<'a>> {
    let found = |&(of, file, caption): &(&str, &str, &'static str)| {
        let (_, svg) = pictures.iter().find(|(name, _)| of == claim && name == file)?;
        Some(Figure { caption, svg })
    };
    let numbered =
        all().iter().filter(|figure| figure.number.is_some() && figure.claims.first() == Some(&claim));
    let drawn = numbered.filter_map(|figure| {
        let (_, svg) = pictures.iter().find(|(name, _)| *name == figure.file())?;
        Some(Figure { caption: figure.title, svg })
    });
    FIGURES.iter().filter_map(found).chain(drawn).collect()
}

fn decided(grounds: &Grounds) -> String {
    let Grounds { instances, small_cases, facts } = grounds;
    format!(
        "Decided on {instances} instances of the paper and {small_cases} small cases, by {facts} exact decisions."
    )
}

/// The state of the panel that shows the witness, for the part of the address after `#`.
fn panel_state(witness: &Witness) -> Option<String> {
    let (basis, i, x) = (witness.basis()?, function(witness), witness.number("x"));
    let knots: Vec<_> = basis.knots().knots().iter().map(ToString::to_string).collect();
    let mut state =
        format!("panel=own&degree={}&knots={}&alpha={}", basis.degree(), knots.join(","), basis.index());
    for (name, value) in [("x", x.map(|x| x.to_string())), ("function", i.map(|i| i.to_string()))] {
        if let Some(value) = value {
            state += &format!("&{name}={value}");
        }
    }
    Some(state)
}

impl Shown {
    fn of((claim, form): (&str, Form), witness: &Witness, paper: &Paper, worked: bool) -> Self {
        Self {
            given: witness.given(),
            claimed: formula::html(&witness.claimed),
            found: formula::html(&witness.found()),
            workings: if worked { workings(witness) } else { Vec::new() },
            command: witness.again(claim, form, paper),
            panel: panel_state(witness),
        }
    }
}

impl<'a> Section<'a> {
    /// Everything about the claim of the record.
    pub(super) fn of(record: &'a Record, report: &'a Report, source: &PageSource<'a>) -> Self {
        let certificate = |finding: &'a Finding| {
            let name = finding.certificate.as_deref()?;
            Some(Certificate {
                name,
                folder: source.certificates,
                steps: report.certificates.get(name).map(|of| of.steps),
            })
        };
        let part = |(form, title), badge: String, verdict: String, stated: &'a Stated| {
            let finding = &stated.finding;
            Part {
                title,
                badge,
                verdict,
                statement: formula::html(&stated.statement),
                grounds: stated.rests_on.as_ref().map(decided),
                reason: finding.reason.as_deref().map(formula::html),
                witness: finding
                    .witness
                    .as_ref()
                    .map(|witness| Shown::of((&record.id, form), witness, report.of, true)),
                remarks: &finding.remarks,
                certificate: certificate(finding),
                theorems: &finding.theorems,
                checked_by: finding.checked_by.join(", "),
            }
        };
        let mut parts =
            vec![part((Form::Printed, "As printed"), badge(record), record.words(), &record.as_printed)];
        let others =
            [((Form::Amended, "As amended"), &record.amended), ((Form::Fails, "Elsewhere"), &record.fails)];
        parts.extend(others.into_iter().filter_map(|(title, stated)| {
            let stated = stated.as_ref()?;
            Some(part(title, stated.finding.status.clone(), stated.finding.words(), stated))
        }));
        let cause = record.severity.zip(record.severity_because.as_ref()).map(|(severity, because)| {
            let cause = record.cause.map_or(UNASSIGNED, |cause| cause.words());
            formula::html(&format!("Cause: {cause}. Severity: {}, {because}.", severity.name()))
        });
        let command = match &record.as_printed.finding.witness {
            Some(witness) => witness.again(&record.id, Form::Printed, report.of),
            None => report.of.judges(&record.id),
        };
        let degrees = record
            .by_degree
            .iter()
            .map(|of| OfDegree {
                degree: of.degree,
                status: &of.finding.status,
                verdict: of.finding.words(),
                witness: of
                    .finding
                    .witness
                    .as_ref()
                    .map(|witness| Shown::of((&record.id, Form::Printed), witness, report.of, false)),
                grounds: of.rests_on.as_ref().map(decided),
                certificate: certificate(&of.finding),
                theorems: &of.finding.theorems,
            })
            .collect();
        Self {
            row: row(record),
            statement: &record.statement,
            parts,
            degrees,
            cause,
            // Another paper's claim of that name is another one.
            example: (record.id == example::CLAIM && report.of.called.is_none()).then(example).flatten(),
            note: record.note.as_deref().map(formula::html),
            figures: figures(&record.id, source.pictures),
            command,
        }
    }
}
