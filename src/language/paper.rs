//! A paper as a folder of data: what it is, its files of claims, its instances, and further cases.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::LazyLock;

use include_dir::{Dir, include_dir};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use toml::Spanned;

use crate::scalar::{BigRational, parse_rational};

use super::complaint::Complaint;
use super::file::{File, Reading, Stanza};
use super::known::Known;
use super::syntax::Name;

/// A paper with everything that is judged of it.
#[derive(Debug)]
pub struct Paper {
    /// What it is, and which version was read.
    pub about: About,
    /// Its files of claims, in its order.
    pub files: Vec<File>,
    /// Its examples, in its order.
    pub examples: Vec<Row>,
    /// Further cases, by the file that claims name.
    pub cases: BTreeMap<String, Vec<Row>>,
}

/// A paper and the version of it that was read.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct About {
    /// The title.
    pub title: String,
    /// The authors; empty if the version that was read does not name them.
    pub authors: Vec<String>,
    /// The number at arXiv.
    pub arxiv: String,
    /// What the listing there says of its size.
    pub listed: String,
    /// The version that was read.
    pub read: String,
    /// What that version lacks.
    pub missing: Vec<String>,
    /// What it is close to.
    pub related: String,
    /// The files of its claims, in its order.
    #[serde(skip_serializing)]
    #[schemars(skip)]
    claims: Vec<String>,
}

/// A degree on knots with indices and, for a curve, control points.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Row {
    /// Its name; a case that is only tried has none.
    pub name: Option<Name>,
    /// Where the paper shows it.
    pub figure: String,
    /// k.
    pub degree: usize,
    /// t_0, …, t_m.
    pub knots: Vec<BigRational>,
    /// The values of α; `None` is ∞.
    pub indices: Vec<Option<BigRational>>,
    /// d_0, …, d_n, for a curve.
    pub points: Option<Vec<Vec<BigRational>>>,
}

#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct RawRows {
    /// The paper's examples.
    #[serde(default)]
    instance: Vec<RawRow>,
    /// Cases that are tried after the usual ones.
    #[serde(default)]
    case: Vec<RawRow>,
}

#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct RawRow {
    /// Its name: `U4`. One name can stand for several degrees.
    name: Option<String>,
    /// Where the paper shows it.
    #[serde(default)]
    figure: String,
    /// k.
    #[serde(alias = "k")]
    degree: usize,
    /// t_0, …, t_m, by spaces.
    #[serde(alias = "U")]
    #[schemars(with = "String")]
    knots: Spanned<String>,
    /// The values of α, by spaces; `inf` for ∞.
    #[schemars(with = "String")]
    alpha: Spanned<String>,
    /// d_0, …, d_n by spaces, coordinates by commas.
    #[schemars(with = "Option<String>")]
    points: Option<Spanned<String>>,
}

/// A file of rows; what is wrong in it goes to the complaints.
fn rows(reading: &mut Reading) -> Vec<Row> {
    let Some(RawRows { instance, case }) = reading.toml::<RawRows>() else { return Vec::new() };
    let mut numbers = |text: &Spanned<String>, separator: char| -> Vec<Vec<Option<BigRational>>> {
        let mut number = |part: &str| match part.trim() {
            "inf" => None,
            part => match parse_rational(part) {
                Ok(number) => Some(number),
                Err(error) => {
                    reading.complain(text.span(), error.to_string(), "write exact numbers, such as -1/2");
                    None
                }
            },
        };
        let points = text.get_ref().split_whitespace();
        points.map(|point| point.split(separator).map(&mut number).collect()).collect()
    };
    let mut row = |raw: RawRow| {
        let flat = |lists: Vec<Vec<Option<BigRational>>>| lists.into_iter().flatten();
        Row {
            name: raw.name.as_deref().map(Name::from),
            figure: raw.figure,
            degree: raw.degree,
            knots: flat(numbers(&raw.knots, ' ')).flatten().collect(),
            indices: flat(numbers(&raw.alpha, ' ')).collect(),
            points: raw.points.map(|points| {
                numbers(&points, ',').into_iter().map(|point| point.into_iter().flatten().collect()).collect()
            }),
        }
    };
    instance.into_iter().chain(case).map(&mut row).collect()
}

impl Paper {
    /// Reads a folder: its files by their names, below it.
    ///
    /// # Errors
    /// Everything that is wrong, each with its place: in a file, between the files, or a file that nothing names.
    pub fn read(files: &BTreeMap<String, String>) -> Result<Self, Vec<Complaint>> {
        let text = |name: &str| files.get(name).map_or("", String::as_str);
        let mut about = Reading::new("paper.toml", text("paper.toml"));
        let Some(found) = about.toml::<About>() else { return Err(about.complaints) };
        let mut known: BTreeSet<String> =
            ["paper.toml", "instances.toml", "windows.toml"].map(str::to_owned).into();
        let mut complaints = Vec::new();
        let table = |name: &str, complaints: &mut Vec<Complaint>| {
            let mut reading = Reading::new(name, text(name));
            let rows = rows(&mut reading);
            complaints.append(&mut reading.complaints);
            rows
        };
        let examples = table("instances.toml", &mut complaints);
        let instances: BTreeSet<Name> = examples.iter().filter_map(|row| row.name.clone()).collect();
        let names: Vec<String> = found.claims.iter().map(|name| format!("claims/{name}.toml")).collect();
        // First by themselves, for the identifiers; then each with those of all.
        let ids = names.iter().filter_map(|name| super::stanzas(name, text(name)).ok());
        let ids: Vec<Name> = ids.flat_map(|file| file.claims.into_iter().map(|claim| claim.id)).collect();
        let claims: BTreeSet<Name> = ids.iter().cloned().collect();
        let (mut read, mut cases) = (Vec::new(), BTreeMap::new());
        for name in &names {
            let known = Known {
                instances: Some(instances.clone()),
                claims: Some(claims.clone()),
                ..Known::default()
            };
            match Reading::new(name, text(name)).file(known) {
                Ok(file) => read.push(file),
                Err(mut more) => complaints.append(&mut more),
            }
        }
        for name in read.iter().flat_map(|file| &file.claims).filter_map(|claim| claim.cases.clone()) {
            cases.entry(name).or_insert_with_key(|name| table(name, &mut complaints));
        }
        known.extend(names);
        known.extend(cases.keys().cloned());
        let twice = ids.iter().enumerate().find(|(at, id)| ids[..*at].contains(id));
        if let Some((_, id)) = twice {
            about.complain(
                0..0,
                format!("two claims have the identifier `{id}`"),
                "give one of them another",
            );
        }
        for name in known.symmetric_difference(&files.keys().cloned().collect()) {
            let (rule, advice) = match files.contains_key(name) {
                true => (format!("nothing names {name}"), "name it under `claims`, or delete it"),
                false => (format!("there is no {name}"), "write it, or name it nowhere"),
            };
            about.complain(0..0, rule, advice);
        }
        complaints.append(&mut about.complaints);
        let paper = Self { about: found, files: read, examples, cases };
        if complaints.is_empty() { Ok(paper) } else { Err(complaints) }
    }

    /// What a text may name of it.
    #[must_use]
    pub fn known(&self) -> Known {
        let instances = self.examples.iter().filter_map(|row| row.name.clone()).collect();
        let claims = self.claims().map(|(_, claim)| claim.id.clone()).collect();
        Known { instances: Some(instances), claims: Some(claims), ..Known::default() }
    }

    /// Reads a file of claims that may name each other, and what there is of the paper.
    ///
    /// # Errors
    /// Everything that is wrong, each with its place.
    pub fn stanzas(&self, file_name: &str, text: &str) -> Result<File, Vec<Complaint>> {
        self.stanzas_about(&Known::default(), file_name, text)
    }

    /// The same about the family that `about` knows.
    ///
    /// # Errors
    /// Everything that is wrong, each with its place.
    pub fn stanzas_about(&self, about: &Known, file_name: &str, text: &str) -> Result<File, Vec<Complaint>> {
        let own = Reading::new(file_name, text).file(about.clone())?.claims.into_iter().map(|claim| claim.id);
        let Known { instances, claims, .. } = self.known();
        let claims = claims.map(|claims| claims.into_iter().chain(own).collect());
        Reading::new(file_name, text).file(Known { instances, claims, ..about.clone() })
    }

    /// Its claims with their files, in its order.
    pub fn claims(&self) -> impl Iterator<Item = (&File, &Stanza)> {
        self.files.iter().flat_map(|file| file.claims.iter().map(move |claim| (file, claim)))
    }
}

/// The paper that comes with the program.
///
/// # Panics
/// If the program was built with a damaged folder, which a test rules out: with all that is wrong in it.
#[must_use]
pub fn paper() -> &'static Paper {
    static FOLDER: Dir<'_> = include_dir!("$CARGO_MANIFEST_DIR/papers/rational-bsplines");
    static PAPER: LazyLock<Paper> = LazyLock::new(|| {
        let below = FOLDER.get_dir("claims").into_iter().flat_map(Dir::files);
        let text = |file: &include_dir::File<'_>| {
            Some((file.path().to_str()?.to_owned(), file.contents_utf8()?.to_owned()))
        };
        match Paper::read(&FOLDER.files().chain(below).filter_map(text).collect()) {
            Ok(paper) => paper,
            Err(complaints) => {
                let complaints: Vec<_> = complaints.iter().map(ToString::to_string).collect();
                unreachable!("the folder of the paper is damaged:\n{}", complaints.join("\n"))
            }
        }
    });
    &PAPER
}

/// The paper, in results that say something of it.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PaperNumber {
    /// Its number at arXiv.
    pub arxiv: String,
}

impl Default for PaperNumber {
    fn default() -> Self {
        Self { arxiv: paper().about.arxiv.clone() }
    }
}
