//! A paper as a folder of data: what it is, its files of claims, its instances, and further cases.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::{Arc, LazyLock, OnceLock};

use include_dir::{Dir, include_dir};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize, Serializer};
use toml::Spanned;

use crate::scalar::BigRational;

use super::complaint::Complaint;
use super::family::{Family, families};
use super::file::{Around, File, Outline, Reading, Stanza};
use super::known::{Known, nearest};
use super::rows::{Row, indices, rows};
use super::syntax::Name;

/// A paper with everything that is judged of it.
#[derive(Debug, Clone)]
pub struct Paper {
    /// What it is, and which version was read.
    pub about: About,
    /// Its files of claims, in its order.
    pub files: Vec<File>,
    /// Its examples, in its order.
    pub examples: Vec<Row>,
    /// Further cases, by the file that claims name.
    pub cases: BTreeMap<String, Vec<Row>>,
    /// The text of its file of windows; empty if there is none.
    pub windows: Arc<str>,
    /// Could its family be read? What is wrong with its instances is not known otherwise.
    pub has_family: bool,
    /// How a command line names it: a folder, or the name of one that comes with the program. The one that commands are about
    /// if nothing is said has none.
    pub called: Option<String>,
}

/// A paper and the version of it that was read.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, JsonSchema)]
pub struct About {
    /// The title.
    pub title: String,
    /// The authors; empty if the version that was read does not name them.
    pub authors: Vec<String>,
    /// The family of weights that its claims are about.
    #[serde(serialize_with = "by_name")]
    #[schemars(with = "String")]
    pub family: Arc<Family>,
    /// Where it is found, if not at arXiv: a book, a journal.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub source: Option<String>,
    /// The number at arXiv.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub arxiv: Option<String>,
    /// What the listing there says of its size.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub listed: Option<String>,
    /// The version that was read.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub read: Option<String>,
    /// What that version lacks.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub missing: Vec<String>,
    /// What it is close to.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub related: Option<String>,
    /// What it is about, for a title: *a class of rational B-splines*.
    #[serde(skip)]
    pub subject: Option<String>,
    /// What reports open with, where it is so.
    #[serde(skip)]
    pub headlines: Vec<Headline>,
    /// The indices that claims about weights alone are looked at with, besides the usual ones.
    #[serde(skip)]
    pub indices: Vec<Option<BigRational>>,
}

/// A line that a report opens with if a claim that is judged degree by degree is refuted.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Headline {
    /// The claim.
    pub claim: Name,
    /// The line, with `{k}` for the first degree in which it is refuted and `{known}` for what is known of all.
    pub refuted: String,
}

/// A paper: what stands in paper.toml.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "paper.toml")]
pub(super) struct RawAbout {
    /// The format of the file; 1 if nothing is said.
    #[serde(rename = "format")]
    #[schemars(extend("const" = 1))]
    _format: Option<u8>,
    /// The title.
    title: String,
    /// The authors.
    #[serde(default)]
    authors: Vec<String>,
    /// The family of weights that the claims are about: one that comes with the program, `mobius` (an index α) if nothing is
    /// said, or a file of the folder: `family.toml`.
    #[schemars(with = "Option<String>")]
    family: Option<Spanned<String>>,
    /// Where it is found, if not at arXiv.
    source: Option<String>,
    /// The number at arXiv.
    arxiv: Option<String>,
    /// What the listing there says of its size.
    listed: Option<String>,
    /// The version that was read.
    read: Option<String>,
    /// What that version lacks.
    #[serde(default)]
    missing: Vec<String>,
    /// What it is close to.
    related: Option<String>,
    /// What it is about, for a title.
    subject: Option<String>,
    /// Indices for claims about weights alone, besides the usual ones, by spaces.
    #[schemars(with = "Option<String>")]
    indices: Option<Spanned<String>>,
    /// The files of its claims, in its order: `01-basis` is `claims/01-basis.toml`.
    #[schemars(with = "Vec<String>")]
    claims: Spanned<Vec<Spanned<String>>>,
    /// What reports open with.
    #[serde(default)]
    headline: Vec<RawHeadline>,
}

/// A line that a report opens with if a claim is refuted.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct RawHeadline {
    /// A claim that is judged degree by degree.
    #[schemars(with = "String")]
    claim: Spanned<String>,
    /// The line, with `{k}` for the first degree in which it is refuted and `{known}` for what is known of all.
    refuted: String,
}

const ABOUT: &str = "paper.toml";
const INSTANCES: &str = "instances.toml";
const WINDOWS: &str = "windows.toml";

fn claims_file(name: &str) -> String {
    format!("claims/{name}.toml")
}

fn by_name<S: Serializer>(family: &Family, to: S) -> Result<S::Ok, S::Error> {
    to.serialize_str(&family.name)
}

/// The family that a paper names: its own file, or one that comes with the program.
fn family(
    reading: &mut Reading,
    name: Option<&Spanned<String>>,
    files: &BTreeMap<String, String>,
) -> Result<Arc<Family>, Vec<Complaint>> {
    let Some(name) = name else { return Ok(Arc::default()) };
    let given = name.get_ref();
    if let Some(text) = files.get(given) {
        return Family::read(given, text).map(Arc::new);
    }
    if let Some(family) = families().iter().find(|family| family.name == *given) {
        return Ok(Arc::clone(family));
    }
    let known: Vec<_> = families().iter().map(|family| family.name.as_str()).collect();
    let advice = nearest(given, known.iter().copied()).map_or_else(
        || format!("write one of {}, or the name of a file of this folder", known.join(", ")),
        |close| format!("did you mean `{close}`?"),
    );
    reading.complain(name.span(), format!("no family is called `{given}`"), advice);
    Ok(Arc::default())
}

impl Paper {
    /// The examples of these names, one after the other.
    pub fn rows_of<'a>(&'a self, names: &[Name]) -> impl Iterator<Item = &'a Row> {
        names.iter().flat_map(|name| self.examples.iter().filter(move |row| row.name.as_ref() == Some(name)))
    }

    /// Reads a folder: its files by their names, below it.
    ///
    /// # Errors
    /// Everything that is wrong, each with its place: in a file, between the files, or a file that nothing names.
    pub fn read(files: &BTreeMap<String, String>) -> Result<Self, Vec<Complaint>> {
        let (paper, complaints) = Self::as_far_as_read(files);
        if complaints.is_empty() { Ok(paper) } else { Err(complaints) }
    }

    /// What can be read of a folder, and all that is wrong with it.
    #[must_use]
    pub fn as_far_as_read(files: &BTreeMap<String, String>) -> (Self, Vec<Complaint>) {
        let text = |name: &str| files.get(name).map_or("", String::as_str);
        let mut about = Reading::new(ABOUT, text(ABOUT));
        let raw = match files.contains_key(ABOUT) {
            true => about.toml::<RawAbout>(),
            false => {
                about.complain(0..0, "there is no paper.toml", "write one; `knotproof new FOLDER` shows how");
                None
            }
        };
        let mut complaints = Vec::new();
        let table = |name: &str, complaints: &mut Vec<Complaint>| {
            let mut reading = Reading::new(name, text(name));
            let rows = rows(&mut reading);
            complaints.append(&mut reading.complaints);
            rows
        };
        let named = raw.as_ref().and_then(|raw| raw.family.as_ref());
        let before = about.complaints.len();
        let family = family(&mut about, named, files).map_err(|mut wrong| complaints.append(&mut wrong));
        let has_family = family.is_ok() && about.complaints.len() == before && raw.is_some();
        let family = family.unwrap_or_default();
        let examples = table(INSTANCES, &mut complaints);
        // Where it is not known what is listed, whatever is there is read.
        let names: Vec<String> = match &raw {
            Some(raw) => listed(raw, files, &mut about),
            None => files.keys().filter(|name| name.starts_with("claims/")).cloned().collect(),
        };
        let outlines: Vec<_> =
            names.iter().map(|name| (name, Reading::new(name, text(name)).outlines())).collect();
        let whole = outlines.iter().all(|(_, outlines)| outlines.is_some());
        let stanzas = || {
            outlines
                .iter()
                .flat_map(|(name, outlines)| outlines.iter().flatten().map(move |one| (*name, one)))
        };
        let claims: BTreeSet<Name> = stanzas().map(|(_, one)| one.id.as_str().into()).collect();
        let uses = |one: &Outline| one.uses.iter().map(|other| other.id.as_str().into()).collect();
        let known = Known {
            instances: Some(examples.iter().filter_map(|row| row.name.clone()).collect()),
            // A file that is no TOML may have any identifier in it.
            claims: whole.then_some(claims),
            ..Known::default().about(&family)
        };
        let mut around = Around {
            files: Some(files.keys().cloned().collect()),
            taken: BTreeMap::new(),
            uses: stanzas().map(|(_, one)| (one.id.as_str().into(), uses(one))).collect(),
        };
        let mut read = Vec::new();
        for (name, outlines) in &outlines {
            match Reading::new(name, text(name)).file(known.clone(), &around) {
                Ok(file) => read.push(file),
                Err(mut more) => complaints.append(&mut more),
            }
            for one in outlines.iter().flatten() {
                around.taken.entry(one.id.as_str().into()).or_insert_with(|| (*name).clone());
            }
        }
        let mut cases = BTreeMap::new();
        for name in
            stanzas().filter_map(|(_, one)| one.cases.as_ref()).filter(|name| files.contains_key(*name))
        {
            cases.entry(name.clone()).or_insert_with_key(|name| table(name, &mut complaints));
        }
        let mut listed: BTreeSet<&str> = [ABOUT, INSTANCES, WINDOWS].into();
        listed
            .extend(names.iter().chain(cases.keys()).chain(named.map(Spanned::get_ref)).map(String::as_str));
        let about_claims = raw.as_ref().map_or(0..0, |raw| raw.claims.span());
        // A file that is no TOML may name any file.
        for name in files.keys().filter(|name| whole && !listed.contains(name.as_str())) {
            let advice = "name it under `claims` or in the `cases` of a claim, or move it away";
            about.complain(about_claims.clone(), format!("nothing names {name}"), advice);
        }
        let found = raw.map(|raw| raw.about(&mut about, family, known.claims.as_ref())).unwrap_or_default();
        about.complaints.append(&mut complaints);
        let windows = text(WINDOWS).into();
        let paper = Self { about: found, files: read, examples, cases, windows, has_family, called: None };
        (paper, about.complaints)
    }

    /// What a text may name of it.
    #[must_use]
    pub fn known(&self) -> Known {
        let instances = self.examples.iter().filter_map(|row| row.name.clone()).collect();
        let claims = self.claims().map(|(_, claim)| claim.id.clone()).collect();
        Known {
            instances: Some(instances),
            claims: Some(claims),
            ..Known::default().about(&self.about.family)
        }
    }

    /// Reads a file of claims that may name each other, and what there is of the paper.
    ///
    /// # Errors
    /// Everything that is wrong, each with its place.
    pub fn stanzas(&self, file_name: &str, text: &str) -> Result<File, Vec<Complaint>> {
        self.stanzas_about(self.known(), file_name, text)
    }

    /// The same where these names are known.
    ///
    /// # Errors
    /// Everything that is wrong, each with its place.
    pub fn stanzas_about(&self, known: Known, file_name: &str, text: &str) -> Result<File, Vec<Complaint>> {
        let own = Reading::new(file_name, text).outlines();
        let own = own.map(|own| own.into_iter().map(|one| one.id.into()));
        let claims = own.and_then(|own| Some(known.claims?.into_iter().chain(own).collect()));
        Reading::new(file_name, text).file(Known { claims, ..known }, &Around::default())
    }

    /// With a file of claims before its own.
    #[must_use]
    pub fn with(&self, file: File) -> Self {
        let files = std::iter::once(file).chain(self.files.iter().cloned()).collect();
        Self { files, ..self.clone() }
    }

    /// The command that judges one of its claims with all cases.
    #[must_use]
    pub fn judges(&self, claim: &str) -> String {
        match &self.called {
            Some(paper) => format!("knotproof judge {paper} --claim {claim}"),
            None => format!("knotproof report --claim {claim}"),
        }
    }

    /// Its claims with their files, in its order.
    pub fn claims(&self) -> impl Iterator<Item = (&File, &Stanza)> {
        self.files.iter().flat_map(|file| file.claims.iter().map(move |claim| (file, claim)))
    }
}

/// The files of claims that are listed and there.
fn listed(raw: &RawAbout, files: &BTreeMap<String, String>, about: &mut Reading) -> Vec<String> {
    let mut names: Vec<String> = Vec::new();
    for name in raw.claims.get_ref() {
        let file = claims_file(name.get_ref());
        if names.contains(&file) {
            about.complain(name.span(), format!("`{}` is listed twice", name.get_ref()), "list it once");
        } else if files.contains_key(&file) {
            names.push(file);
        } else {
            let stem = |file: &String| Some(file.strip_prefix("claims/")?.strip_suffix(".toml")?.to_owned());
            let there: Vec<_> = files.keys().filter_map(stem).collect();
            let close = nearest(name.get_ref(), there.iter().map(String::as_str));
            let advice = match close {
                Some(close) => format!("did you mean `{close}`?"),
                None => "write it, or don't list it".to_owned(),
            };
            about.complain(name.span(), format!("there is no {file}"), advice);
        }
    }
    if raw.claims.get_ref().is_empty() {
        about.complain(
            raw.claims.span(),
            "no file of claims is listed",
            "list one: `claims = [\"01-basis\"]`",
        );
    }
    names
}

impl RawAbout {
    /// As it is kept.
    fn about(self, reading: &mut Reading, family: Arc<Family>, claims: Option<&BTreeSet<Name>>) -> About {
        let mut headlines = Vec::new();
        for RawHeadline { claim, refuted } in self.headline {
            if claims.is_some_and(|claims| !claims.contains(claim.get_ref().as_str())) {
                let rule = format!("no claim is called `{}`", claim.get_ref());
                reading.complain(claim.span(), rule, "name a claim of the paper");
            }
            headlines.push(Headline { claim: claim.get_ref().as_str().into(), refuted });
        }
        let indices = self.indices.as_ref().map(|text| {
            if family.moebius().is_none() {
                let rule = format!("the family `{}` has no index α", family.name);
                reading.complain(text.span(), rule, "leave `indices` out");
            }
            indices(reading, text)
        });
        let indices = indices.unwrap_or_default();
        About {
            family,
            title: self.title,
            authors: self.authors,
            source: self.source,
            arxiv: self.arxiv,
            listed: self.listed,
            read: self.read,
            missing: self.missing,
            related: self.related,
            subject: self.subject,
            headlines,
            indices,
        }
    }
}

/// The folders that come with the program.
static FOLDERS: Dir<'_> = include_dir!("$CARGO_MANIFEST_DIR/papers");
/// The one that commands are about if nothing is said.
const MAIN: &str = "rational-bsplines";

/// The names of the papers that come with the program.
pub fn shipped_names() -> impl Iterator<Item = &'static str> {
    FOLDERS.dirs().filter_map(|folder| folder.path().to_str())
}

/// The paper of that name that comes with the program; none if there is no such name.
///
/// # Panics
/// If the program was built with a damaged folder, which a test rules out: with all that is wrong in it.
#[must_use]
pub fn shipped(name: &str) -> Option<&'static Paper> {
    static READ: LazyLock<BTreeMap<&str, OnceLock<Paper>>> =
        LazyLock::new(|| shipped_names().map(|name| (name, OnceLock::new())).collect());
    READ.get(name).map(|paper| paper.get_or_init(|| built_in(name)))
}

fn built_in(name: &str) -> Paper {
    let text = |file: &include_dir::File<'_>| {
        let below = file.path().strip_prefix(name).ok()?;
        Some((below.to_str()?.to_owned(), file.contents_utf8()?.to_owned()))
    };
    let folder = FOLDERS.get_dir(name);
    let claims = folder.into_iter().flat_map(Dir::dirs).flat_map(Dir::files);
    let files = folder.into_iter().flat_map(Dir::files).chain(claims).filter_map(text).collect();
    match Paper::read(&files) {
        Ok(paper) => Paper { called: (name != MAIN).then(|| name.to_owned()), ..paper },
        Err(complaints) => {
            let complaints: Vec<_> = complaints.iter().map(ToString::to_string).collect();
            unreachable!("the folder of the paper is damaged:\n{}", complaints.join("\n"))
        }
    }
}

/// The paper that commands are about if nothing is said.
///
/// # Panics
/// As [`shipped`].
#[must_use]
pub fn paper() -> &'static Paper {
    shipped(MAIN).unwrap_or_else(|| unreachable!("{MAIN} comes with the program"))
}

/// The paper, in results that say something of it.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PaperNumber {
    /// Its number at arXiv.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub arxiv: Option<String>,
    /// Its title, if it has none there.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub title: Option<String>,
}

impl From<&About> for PaperNumber {
    fn from(about: &About) -> Self {
        let arxiv = about.arxiv.clone();
        Self { title: arxiv.is_none().then(|| about.title.clone()), arxiv }
    }
}

impl Default for PaperNumber {
    fn default() -> Self {
        Self::from(&paper().about)
    }
}
