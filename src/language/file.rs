//! Files of claims: TOML → stanzas, every complaint with its place in the file.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use schemars::{JsonSchema, Schema, schema_for};
use serde::Deserialize;
use serde::de::IntoDeserializer;
use serde::de::value::{Error as ValueError, StrDeserializer};
use toml::Spanned;

use super::cause::{Cause, Severity};
use super::complaint::{Complaint, Fault, Origin, Place};
use super::definitions::definitions;
use super::known::{Known, nearest};
use super::sentence::Reader;
use super::syntax::{Definition, Name, Sentence};

/// A file of claims.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct File {
    /// What it is about.
    pub title: Option<String>,
    /// Its definitions, for all of its claims.
    pub definitions: Vec<Definition>,
    /// Its claims, in order.
    pub claims: Vec<Stanza>,
}

/// A claim with all that is said of it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Stanza {
    /// Its identifier.
    pub id: Name,
    /// Where the paper has it.
    pub at: String,
    /// A short name.
    pub title: String,
    /// As printed.
    pub printed: Said,
    /// The strongest true sentence known instead.
    pub amended: Option<Said>,
    /// What holds where the amended one does not apply.
    pub fails: Option<Said>,
    /// Why the printed sentence fails.
    pub cause: Option<Cause>,
    /// How bad that is, where it can't be read off the sentences.
    pub severity: Option<Severity>,
    /// How the words of the paper were read.
    pub note: Option<String>,
    /// What its proof rests on.
    pub uses: Vec<RestsOn>,
    /// Is it judged for every degree by itself as well?
    pub each_degree: bool,
    /// A file of cases that are tried after the usual ones.
    pub cases: Option<String>,
}

impl Stanza {
    /// A sentence that somebody types, with nothing else said of it.
    #[must_use]
    pub fn own(printed: Said) -> Self {
        Self {
            id: "claim".into(),
            at: String::new(),
            title: String::new(),
            printed,
            amended: None,
            fails: None,
            cause: None,
            severity: None,
            note: None,
            uses: Vec::new(),
            each_degree: false,
            cases: None,
        }
    }
}

/// A sentence, or words that no sentence can say.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Said {
    /// In the language.
    Sentence(Sentence),
    /// In words.
    Words {
        /// The words.
        words: String,
        /// Why the language can't say it.
        reason: String,
        /// As much of it as the language can say.
        core: Option<Sentence>,
    },
}

impl Said {
    /// The sentence that is decided, if there is one.
    #[must_use]
    pub fn sentence(&self) -> Option<&Sentence> {
        match self {
            Self::Sentence(sentence) => Some(sentence),
            Self::Words { core, .. } => core.as_ref(),
        }
    }
}

/// Another claim that a proof in the paper uses.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct RestsOn {
    /// That claim.
    pub id: Name,
    /// What survives where it fails as printed, and why; `None` if nothing does.
    pub survives: Option<String>,
}

/// A file of claims.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "Files of claims")]
pub(super) struct RawFile {
    /// The format of the file; 1 if nothing is said.
    #[serde(rename = "format")]
    #[schemars(extend("const" = 1))]
    _format: Option<u8>,
    /// What the file is about.
    title: Option<String>,
    /// Names for terms, for all claims of the file: "mean[i]" = "(t[i+1] + t[i+2])/2".
    #[serde(default)]
    #[schemars(with = "BTreeMap<String, String>")]
    define: BTreeMap<Spanned<String>, Spanned<String>>,
    /// The claims, in the order of the paper.
    #[serde(default)]
    #[schemars(with = "Vec<RawStanza>")]
    claim: Vec<Spanned<RawStanza>>,
}

pub(super) type Text = Spanned<String>;

/// A claim. What `amended` and `fails` don't say themselves is the printed one's. Its sentence is no [`RawSaid`] within: serde does not
/// flatten what refuses unknown keys and keeps places.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct RawStanza {
    /// Its identifier: letters, digits, `.`, `_`, `-`.
    #[schemars(with = "String")]
    id: Text,
    /// Where the paper has it: "Theorem 3.5 (3)".
    at: String,
    /// A short name.
    title: String,
    /// Binders: "k; U open; i in 0..n; x in [t[0], t[m]]".
    #[serde(rename = "for")]
    #[schemars(with = "Option<String>")]
    given: Option<Text>,
    /// Hypotheses.
    #[serde(rename = "if")]
    #[schemars(with = "Option<Vec<String>>")]
    assume: Option<Vec<Text>>,
    /// Conclusions.
    #[schemars(with = "Option<Vec<String>>")]
    then: Option<Spanned<Vec<Text>>>,
    /// The sentence, where the language can't say it; `then` is its formal core.
    words: Option<String>,
    /// Why the language can't say it.
    reason: Option<String>,
    /// The strongest true sentence known instead, where the printed one fails.
    #[schemars(with = "Option<RawSaid>")]
    amended: Option<Spanned<RawSaid>>,
    /// What holds where the amended one does not apply.
    #[schemars(with = "Option<RawSaid>")]
    fails: Option<Spanned<RawSaid>>,
    /// Why the printed sentence fails.
    #[schemars(with = "Option<Cause>")]
    cause: Option<Text>,
    /// How bad that is, where it can't be read off the sentences.
    #[schemars(with = "Option<Severity>")]
    severity: Option<Text>,
    /// How the words of the paper were read.
    note: Option<String>,
    /// What its proof in the paper rests on.
    #[serde(default)]
    uses: Vec<RawUse>,
    /// Judged for every degree by itself as well.
    degrees: Option<Degrees>,
    /// A file of cases that are tried after the usual ones.
    #[schemars(with = "Option<String>")]
    cases: Option<Text>,
}

/// Another sentence of a claim.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct RawSaid {
    /// Binders in place of the printed ones.
    #[serde(rename = "for")]
    #[schemars(with = "Option<String>")]
    given: Option<Text>,
    /// Hypotheses in place of the printed ones.
    #[serde(rename = "if")]
    #[schemars(with = "Option<Vec<String>>")]
    assume: Option<Vec<Text>>,
    /// Conclusions in place of the printed ones.
    #[schemars(with = "Option<Vec<String>>")]
    then: Option<Spanned<Vec<Text>>>,
    /// The sentence, where the language can't say it.
    words: Option<String>,
    /// Why the language can't say it.
    reason: Option<String>,
}

/// What a proof rests on.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct RawUse {
    /// The claim that it uses.
    #[schemars(with = "String")]
    id: Text,
    /// What survives where that fails as printed, and why; left out if nothing does.
    survives: Option<String>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
enum Degrees {
    Each,
}

/// The JSON Schema of files of claims, for editors.
#[must_use]
pub fn schema() -> Schema {
    schema_for!(RawFile)
}

/// Reads a file of claims by itself: any instance and any other claim may be named.
///
/// # Errors
/// Everything that is wrong, each with its place.
pub fn stanzas(file_name: &str, text: &str) -> Result<File, Vec<Complaint>> {
    Reading::new(file_name, text).file(Known::default(), &Around::default())
}

/// What a file may name of what is around it; without a list, anything.
#[derive(Debug, Default)]
pub(super) struct Around {
    /// The files of the folder.
    pub(super) files: Option<BTreeSet<String>>,
    /// The identifiers that files before this one have taken, with the file.
    pub(super) taken: BTreeMap<Name, String>,
    /// What each claim rests on.
    pub(super) uses: BTreeMap<Name, Vec<Name>>,
}

impl Around {
    /// Does a claim rest on another one, through whatever others?
    fn leads(&self, from: &str, to: &str) -> bool {
        let mut seen = BTreeSet::from([from]);
        let mut left = vec![from];
        while let Some(next) = left.pop() {
            if next == to {
                return true;
            }
            left.extend(
                self.uses.get(next).into_iter().flatten().map(|id| &**id).filter(|id| seen.insert(id)),
            );
        }
        false
    }
}

/// What is known of a claim before its sentences are read.
#[derive(Deserialize)]
pub(super) struct Outline {
    pub(super) id: String,
    pub(super) cases: Option<String>,
    #[serde(default)]
    pub(super) uses: Vec<OutlineUse>,
}

#[derive(Deserialize)]
pub(super) struct OutlineUse {
    pub(super) id: String,
}

#[derive(Deserialize)]
struct Outlines {
    #[serde(default)]
    claim: Vec<Outline>,
}

/// The format of the files of a paper and of families. It rises when a file that was right is no longer so, or means something else.
const FORMAT: i64 = 1;

#[derive(Deserialize)]
struct OfFormat {
    format: Option<Spanned<toml::Value>>,
}

/// A file that is being read, with what was wrong in it so far.
pub(super) struct Reading {
    origin: Arc<Origin>,
    pub(super) complaints: Vec<Complaint>,
}

impl Reading {
    pub(super) fn new(name: &str, text: &str) -> Self {
        let origin = Arc::new(Origin { name: name.to_owned(), text: text.to_owned() });
        Self { origin, complaints: Vec::new() }
    }

    /// The text that is read, for places in it.
    pub(super) fn origin(&self) -> Arc<Origin> {
        Arc::clone(&self.origin)
    }

    /// What the file is called.
    pub(super) fn name(&self) -> &str {
        &self.origin.name
    }

    /// What is in a file of claims, if that much can be read.
    pub(super) fn outlines(&self) -> Option<Vec<Outline>> {
        toml::from_str(&self.origin.text).map(|Outlines { claim }| claim).ok()
    }

    pub(super) fn complain(&mut self, at: Place, rule: impl Into<String>, advice: impl Into<String>) {
        let complaint = Complaint::new(&self.origin, at, rule, advice);
        // What amended sentences inherit is read again.
        if !self.complaints.contains(&complaint) {
            self.complaints.push(complaint);
        }
    }

    /// Complains of a fault inside of a string of the file.
    pub(super) fn fault(&mut self, text: &Text, fault: Fault) {
        let whole = text.span();
        // Behind the quotes; a text with escapes is underlined as a whole.
        let inside = self.origin.text.get(whole.clone()).and_then(|raw| raw.find(text.get_ref().as_str()));
        let at = match inside {
            Some(start) => whole.start + start + fault.at.start..whole.start + start + fault.at.end,
            None => whole,
        };
        self.complain(at, fault.rule, fault.advice);
    }

    pub(super) fn read<T>(&mut self, text: &Text, read: Result<T, Fault>) -> Option<T> {
        read.map_err(|fault| self.fault(text, fault)).ok()
    }

    /// The data of a TOML file.
    pub(super) fn toml<T: serde::de::DeserializeOwned>(&mut self) -> Option<T> {
        let origin = Arc::clone(&self.origin);
        // Before the rest: another format may have keys that are not known here.
        if let Ok(OfFormat { format: Some(given) }) = toml::from_str(&origin.text)
            && given.get_ref().as_integer() != Some(FORMAT)
        {
            let (given_number, version) = (&origin.text[given.span()], env!("CARGO_PKG_VERSION"));
            let rule =
                format!("this is format {given_number}, and knotproof {version} reads format {FORMAT}");
            self.complain(
                given.span(),
                rule,
                "read it with another version, or say `format = 1` and write what that has",
            );
            return None;
        }
        toml::from_str(&origin.text)
            .map_err(|error| {
                let at = error.span().unwrap_or(0..0);
                let first_line = origin.text[at.clone()].find('\n').map_or(at.end, |end| at.start + end);
                let message = error.message().lines().next().unwrap_or_default();
                self.complain(at.start..first_line, message, expected(message));
            })
            .ok()
    }

    /// A file of claims that may name these, and what is around it.
    pub(super) fn file(mut self, known: Known, around: &Around) -> Result<File, Vec<Complaint>> {
        let Some(raw) = self.toml::<RawFile>() else { return Err(self.complaints) };
        let mut heads: Vec<_> = raw.define.iter().collect();
        heads.sort_by_key(|(head, _)| head.span().start);
        let texts: Vec<_> =
            heads.iter().map(|(head, body)| (head.get_ref().clone(), body.get_ref().clone())).collect();
        let known = definitions(&texts, known).unwrap_or_else(|faults| {
            for (index, in_head, fault) in faults {
                self.fault(if in_head { heads[index].0 } else { heads[index].1 }, fault);
            }
            Known::default()
        });
        // Without its definitions, every sentence that uses them would be complained of as well.
        if !self.complaints.is_empty() {
            return Err(self.complaints);
        }
        let mut used: BTreeSet<Name> = BTreeSet::new();
        let mut ids = BTreeSet::new();
        let mut all = Vec::new();
        for raw in &raw.claim {
            let id = &raw.get_ref().id;
            if !ids.insert(id.get_ref()) {
                self.complain(id.span(), "two claims have this identifier", "give one of them another");
            }
            if let Some(file) = around.taken.get(id.get_ref().as_str()) {
                let rule = format!("{file} has a claim `{}`, too", id.get_ref());
                self.complain(id.span(), rule, "give one of them another identifier");
            }
            if let (Some(files), Some(cases)) = (&around.files, &raw.get_ref().cases)
                && !files.contains(cases.get_ref())
            {
                let rule = format!("there is no file {}", cases.get_ref());
                self.complain(cases.span(), rule, "write it, or name no `cases`");
            }
            for other in &raw.get_ref().uses {
                if around.leads(other.id.get_ref(), id.get_ref()) {
                    let rule = format!("`{}` rests on `{}`, too: a circle", other.id.get_ref(), id.get_ref());
                    self.complain(
                        other.id.span(),
                        rule,
                        "a proof that goes in a circle is none: drop one of its `uses`",
                    );
                }
            }
            all.extend(self.stanza(raw, &known, &mut used));
        }
        for ((head, _), definition) in heads.iter().zip(known.definitions()) {
            // What is wrong otherwise may be what would use it.
            if self.complaints.is_empty() && !known.is_used(&definition.name, &used) {
                self.complain(head.span(), format!("nothing uses `{}`", definition.name), "delete it");
            }
        }
        match self.complaints.is_empty() {
            true => Ok(File { title: raw.title, definitions: known.definitions, claims: all }),
            false => Err(self.complaints),
        }
    }

    fn stanza(
        &mut self,
        raw: &Spanned<RawStanza>,
        known: &Known,
        used: &mut BTreeSet<Name>,
    ) -> Option<Stanza> {
        let (place, raw) = (raw.span(), raw.get_ref());
        let strange = |c: char| !(c.is_ascii_alphanumeric() || "._-".contains(c));
        if raw.id.get_ref().is_empty() || raw.id.get_ref().contains(strange) {
            self.complain(
                raw.id.span(),
                "an identifier is made of letters, digits, `.`, `_` and `-`",
                "write it like `T3.5.3`",
            );
        }
        let before = self.complaints.len();
        let own = Part::of(&raw.given, &raw.assume, &raw.then, &raw.words, &raw.reason);
        let printed = self.said(&own, None, &place, known, used);
        let mut other = |said: &Option<Spanned<RawSaid>>| {
            let said = said.as_ref()?;
            let (at, said) = (said.span(), said.get_ref());
            let part = Part::of(&said.given, &said.assume, &said.then, &said.words, &said.reason);
            self.said(&part, Some(&own), &at, known, used)
        };
        let (amended, fails) = (other(&raw.amended), other(&raw.fails));
        let cause = self.one_of(&raw.cause, "cause");
        let severity = self.one_of(&raw.severity, "severity");
        for other in &raw.uses {
            if let Some(claims) = &known.claims
                && !claims.contains(other.id.get_ref().as_str())
            {
                let close = nearest(other.id.get_ref(), claims.iter().map(|id| &**id));
                let advice = close.map_or("name a claim of the paper".to_owned(), |close| {
                    format!("did you mean `{close}`?")
                });
                self.complain(other.id.span(), format!("no claim is called `{}`", other.id), advice);
            }
        }
        let uses = raw.uses.iter().map(|other| RestsOn {
            id: other.id.get_ref().as_str().into(),
            survives: other.survives.clone(),
        });
        if self.complaints.len() > before {
            return None;
        }
        Some(Stanza {
            id: raw.id.get_ref().as_str().into(),
            at: raw.at.clone(),
            title: raw.title.clone(),
            printed: printed?,
            amended,
            fails,
            cause,
            severity,
            note: raw.note.clone(),
            uses: uses.collect(),
            each_degree: raw.degrees.is_some(),
            cases: raw.cases.as_ref().map(|cases| cases.get_ref().clone()),
        })
    }

    /// The variant of that name.
    fn one_of<T: serde::de::DeserializeOwned>(&mut self, name: &Option<Text>, what: &str) -> Option<T> {
        let name = name.as_ref()?;
        let text: StrDeserializer<'_, ValueError> = name.get_ref().as_str().into_deserializer();
        T::deserialize(text)
            .map_err(|error| {
                self.complain(
                    name.span(),
                    format!("no {what} is called `{name}`"),
                    expected(&error.to_string()),
                );
            })
            .ok()
    }

    /// A sentence or words; what the part does not say itself is that of the printed one.
    fn said(
        &mut self,
        part: &Part<'_>,
        printed: Option<&Part<'_>>,
        at: &Place,
        known: &Known,
        used: &mut BTreeSet<Name>,
    ) -> Option<Said> {
        let then = match (part.then, part.words, printed) {
            // Words of its own have a core of their own, and the core of words says nothing without them.
            (None, None, Some(Part { words: None, then, .. })) => *then,
            (own, ..) => own,
        };
        let sentence = match then {
            Some(then) if then.get_ref().is_empty() => {
                self.complain(then.span(), "nothing follows", "give a conclusion");
                return None;
            }
            Some(then) => {
                let given = part.given.or(printed.and_then(|printed| printed.given));
                let assume = part.assume.or(printed.and_then(|printed| printed.assume));
                Some(self.sentence(given, assume.map_or(&[], Vec::as_slice), then.get_ref(), known, used)?)
            }
            None => None,
        };
        let first_line =
            at.start..self.origin.text[at.clone()].find('\n').map_or(at.end, |end| at.start + end);
        match (part.words, part.reason.or(printed.and_then(|printed| printed.reason)), sentence) {
            (Some(words), Some(reason), core) => {
                Some(Said::Words { words: words.clone(), reason: reason.clone(), core })
            }
            (Some(_), None, _) => {
                self.complain(
                    first_line,
                    "words need a reason",
                    "add `reason`: why can't the language say it?",
                );
                None
            }
            (None, _, Some(sentence)) => Some(Said::Sentence(sentence)),
            (None, _, None) => {
                self.complain(first_line, "nothing is said", "add `then`, or `words` and `reason`");
                None
            }
        }
    }

    fn sentence(
        &mut self,
        given: Option<&Text>,
        assume: &[Text],
        then: &[Text],
        known: &Known,
        used: &mut BTreeSet<Name>,
    ) -> Option<Sentence> {
        let mut reader = Reader::new(known);
        let given = match given {
            Some(text) => self.read(text, reader.given(text.get_ref()))?,
            None => Vec::new(),
        };
        let mut formulas = |texts: &[Text]| -> Option<Vec<_>> {
            let read: Vec<_> =
                texts.iter().map(|text| self.read(text, reader.formula(text.get_ref()))).collect();
            read.into_iter().collect()
        };
        let (assume, then) = (formulas(assume), formulas(then));
        used.extend(reader.named().definitions.into_iter().map(|(name, ..)| name));
        Some(Sentence { given, assume: assume?, then: then? })
    }
}

/// The parts of a sentence as a file has them.
struct Part<'a> {
    given: Option<&'a Text>,
    assume: Option<&'a Vec<Text>>,
    then: Option<&'a Spanned<Vec<Text>>>,
    words: Option<&'a String>,
    reason: Option<&'a String>,
}

impl<'a> Part<'a> {
    fn of(
        given: &'a Option<Text>,
        assume: &'a Option<Vec<Text>>,
        then: &'a Option<Spanned<Vec<Text>>>,
        words: &'a Option<String>,
        reason: &'a Option<String>,
    ) -> Self {
        let (given, assume, then) = (given.as_ref(), assume.as_ref(), then.as_ref());
        Self { given, assume, then, words: words.as_ref(), reason: reason.as_ref() }
    }
}

/// What to write, from a message that names in backquotes what was found and what could be.
fn expected(message: &str) -> String {
    let names: Vec<&str> = message.split('`').skip(1).step_by(2).collect();
    match names.split_first() {
        Some((found, [_, ..])) if message.starts_with("unknown") => {
            match nearest(found, names[1..].iter().copied()) {
                Some(close) => format!("did you mean `{close}`?"),
                None => format!("write one of {}", names[1..].join(", ")),
            }
        }
        Some((missing, _)) if message.starts_with("missing") => format!("add `{missing} = …`"),
        _ => "see toml.io for how TOML is written".to_owned(),
    }
}
