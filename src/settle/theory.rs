//! The theorems for every degree, which Coq has checked: the rows of `proofs/theory/theorems.toml`, and which of them answer for
//! a sentence. That each of them is there and rests on no axiom is what `proofs/theory/check.sh` asks Coq.

use std::fmt;
use std::sync::LazyLock;

use serde::Deserialize;
use thiserror::Error;

use crate::certificate::Certificate;
use crate::judge::{Verdict, Witness};
use crate::language::{Binder, Claim, Form, Int, Range, Sentence, paper};

/// The degrees that a sentence or a theorem is about.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[serde(try_from = "String")]
pub enum DegreeRange {
    /// No degree occurs.
    None,
    /// From the first on, to the last if there is one.
    Degrees {
        /// The first.
        least: usize,
        /// The last.
        most: Option<usize>,
    },
}

impl DegreeRange {
    /// Those of a sentence: of a lower degree than that it says nothing, as of k = 0 in `k; q in 0..k-1`.
    #[must_use]
    pub fn of(sentence: &Sentence) -> Self {
        let degrees = |range: Self, binder: &Binder| match binder {
            Binder::Degree { least, most } => Self::Degrees { least: *least, most: *most },
            Binder::Integer(Range { from: Int::Number(from), to, .. }) => match below_degree(to) {
                Some(below) => range
                    .common(Self::Degrees { least: usize::try_from(from + below).unwrap_or(0), most: None }),
                None => range,
            },
            _ => range,
        };
        sentence.given.iter().fold(Self::None, degrees)
    }

    /// Is a degree one of them? Where none occurs, every one is.
    #[must_use]
    pub fn contains(self, k: usize) -> bool {
        match self {
            Self::None => true,
            Self::Degrees { least, most } => least <= k && most.is_none_or(|most| k <= most),
        }
    }

    /// Are all of the others among them?
    #[must_use]
    pub fn covers(self, other: Self) -> bool {
        match (self, other) {
            (Self::None, _) => true,
            (Self::Degrees { .. }, Self::None) => false,
            (Self::Degrees { least, most }, Self::Degrees { least: from, most: to }) => {
                least <= from && most.is_none_or(|most| to.is_some_and(|to| to <= most))
            }
        }
    }

    /// One degree.
    #[must_use]
    pub fn one(k: usize) -> Self {
        Self::Degrees { least: k, most: Some(k) }
    }

    /// Is it one degree?
    #[must_use]
    pub fn is_one(self) -> bool {
        matches!(self, Self::Degrees { least, most: Some(most) } if least == most)
    }

    /// Those that are among both.
    #[must_use]
    pub fn common(self, other: Self) -> Self {
        match (self, other) {
            (Self::None, range) | (range, Self::None) => range,
            (Self::Degrees { least, most }, Self::Degrees { least: from, most: to }) => {
                Self::Degrees { least: least.max(from), most: most.into_iter().chain(to).min() }
            }
        }
    }

    /// Is there none among both?
    fn is_apart_from(self, other: Self) -> bool {
        matches!(self.common(other), Self::Degrees { least, most: Some(most) } if most < least)
    }

    /// As a condition, after a comma: `for every k`, `for k ≥ 1`; empty where no degree occurs.
    #[must_use]
    pub fn words(self) -> String {
        match self {
            Self::None => String::new(),
            Self::Degrees { least: 0, most: None } => "for every k".to_owned(),
            Self::Degrees { least, most: None } => format!("for k ≥ {least}"),
            Self::Degrees { least, most: Some(most) } if least == most => format!("for k = {least}"),
            Self::Degrees { least, most: Some(most) } => format!("for {least} ≤ k ≤ {most}"),
        }
    }
}

/// As it stands in the rows.
impl fmt::Display for DegreeRange {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::None => f.write_str("none"),
            Self::Degrees { least, most: None } => write!(f, "k >= {least}"),
            Self::Degrees { least, most: Some(most) } if least == most => write!(f, "k = {least}"),
            Self::Degrees { least, most: Some(most) } => write!(f, "{least} <= k <= {most}"),
        }
    }
}

impl TryFrom<String> for DegreeRange {
    type Error = String;

    fn try_from(text: String) -> Result<Self, String> {
        let number = |text: &str| text.trim().parse::<usize>().ok();
        let range = if text == "none" {
            Some(Self::None)
        } else if let Some(least) = text.strip_prefix("k >= ") {
            number(least).map(|least| Self::Degrees { least, most: None })
        } else if let Some(k) = text.strip_prefix("k = ") {
            number(k).map(Self::one)
        } else {
            let ends = text.split_once(" <= k <= ").and_then(|(a, b)| number(a).zip(number(b)));
            ends.map(|(least, most)| Self::Degrees { least, most: Some(most) })
        };
        range.ok_or_else(|| format!("`{text}` is none of `none`, `k >= 1`, `k = 0` and `1 <= k <= 2`"))
    }
}

/// c, if the integer is k − c.
fn below_degree(of: &Int) -> Option<i64> {
    match of {
        Int::Degree => Some(0),
        Int::Minus(k, c) => match (&**k, &**c) {
            (Int::Degree, Int::Number(c)) => Some(*c),
            _ => None,
        },
        _ => None,
    }
}

/// Which part of a stanza a theorem is about.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum StanzaPart {
    /// The printed sentence.
    Printed,
    /// The amended one.
    Amended,
    /// What holds where that does not apply.
    Fails,
    /// None: it is more general, or what another rests on.
    Lemma,
}

impl StanzaPart {
    /// As the rows and the commands name it.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Printed => "printed",
            Self::Amended => "amended",
            Self::Fails => "fails",
            Self::Lemma => "lemma",
        }
    }

    /// The sentence of a stanza.
    #[must_use]
    pub fn form(self) -> Option<Form> {
        match self {
            Self::Printed => Some(Form::Printed),
            Self::Amended => Some(Form::Amended),
            Self::Fails => Some(Form::Fails),
            Self::Lemma => None,
        }
    }
}

/// What a theorem says of its sentence.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Decides {
    /// It is true.
    Proved,
    /// In each of the degrees it is false on some knots.
    Refuted,
}

/// How much of its sentence a theorem says.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Covers {
    /// All of it.
    All,
    /// Less.
    Part,
}

/// A row of `theorems.toml`.
#[derive(Debug, Clone, PartialEq, Eq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Theorem {
    /// The claim.
    pub claim: String,
    /// Which of its sentences.
    pub form: StanzaPart,
    /// Is that true, or false?
    pub verdict: Decides,
    /// Its name in Coq.
    pub name: String,
    /// The file in `proofs/theory`.
    pub file: String,
    /// For which degrees.
    pub degrees: DegreeRange,
    /// For which weights: `paper`, `any`, or what is asked of them.
    pub weights: String,
    /// How much of the sentence it says.
    pub covers: Covers,
    /// What it says, for people.
    pub says: String,
    /// What it does not say.
    pub lacks: Option<String>,
}

impl Theorem {
    /// Is it about every weight that is 0 at the left end of its interval, 1 at the right end and between inside? That is what
    /// a certificate calls any weights.
    #[must_use]
    pub fn is_for_any_weights(&self) -> bool {
        self.weights.split(", ").all(|asked| ["any", "range", "inside", "left"].contains(&asked))
    }
}

/// What Coq has checked and what a computation says of the same sentence are not the same: a bug of this program, or a row that
/// is about another sentence. There is no verdict.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[error(
    "disagreement on {claim} ({form}): by the theorem {theorem} of proofs/theory it is {says}, and the computation says: {found}"
)]
pub struct Disagreement {
    /// The claim.
    pub claim: String,
    /// Which of its sentences.
    pub form: Form,
    /// The theorem.
    pub theorem: String,
    /// What that says.
    pub says: &'static str,
    /// What was found.
    pub found: String,
}

/// Claims that no theorem says all of, by one reason.
#[derive(Debug, Clone, PartialEq, Eq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Missing {
    /// The claims.
    pub claims: Vec<String>,
    /// Why.
    pub why: String,
}

/// All theorems.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Theory {
    /// The sentences, such as `T3.5.2 printed`, of which a theorem says what is printed from the stanza: no reader has to
    /// compare.
    #[serde(default)]
    pub stanzas: Vec<String>,
    /// One for each claim that it answers for.
    #[serde(rename = "theorem", default)]
    pub theorems: Vec<Theorem>,
    /// The claims of the paper that have none.
    #[serde(default)]
    pub missing: Vec<Missing>,
}

/// Why a text is no list of theorems.
#[derive(Debug, Error)]
#[error("the rows of proofs/theory: {0}")]
pub struct TheoryError(#[from] toml::de::Error);

/// What a computation came to.
#[derive(Debug, Clone, Copy)]
pub struct Computed<'a> {
    /// On the cases.
    pub verdict: &'a Verdict,
    /// Beyond them.
    pub certificate: Option<&'a Certificate>,
}

impl Computed<'_> {
    fn witness(&self) -> Option<&Witness> {
        if let Verdict::Refuted(witness) = self.verdict { Some(witness) } else { None }
    }

    /// The degrees in which the sentence is called true; none at all for what is about weights alone.
    fn proved(&self) -> Option<&[usize]> {
        match (self.certificate, self.verdict) {
            (Some(certificate), _) if !certificate.statement.refuted => Some(&certificate.statement.degrees),
            (_, Verdict::Proved { reach, .. }) => Some(&reach.degrees),
            _ => None,
        }
    }
}

impl Theory {
    /// Reads rows: those of `theorems.toml`, of `missing.toml`, or of both.
    ///
    /// # Errors
    /// [`TheoryError`], with the place.
    pub fn read(text: &str) -> Result<Self, TheoryError> {
        Ok(toml::from_str(text)?)
    }

    /// That of this program.
    ///
    /// # Panics
    /// If the program was built with damaged rows, which a test rules out.
    #[must_use]
    pub fn shipped() -> &'static Self {
        static READ: LazyLock<Theory> = LazyLock::new(|| {
            let text = concat!(
                include_str!("../../proofs/theory/theorems.toml"),
                "\n",
                include_str!("../../proofs/theory/missing.toml")
            );
            Theory::read(text).unwrap_or_else(|error| unreachable!("the program was built with {error}"))
        });
        &READ
    }

    /// Is there a theorem that says all of the sentence of the claim that stands, in each of its degrees?
    #[must_use]
    pub fn has_all_of(&self, claim: Claim<'_>) -> bool {
        let form = claim.strongest();
        let degrees = claim.sentence(form).map(DegreeRange::of).filter(|degrees| !degrees.is_one());
        degrees.is_some_and(|degrees| {
            let proves = |theorem: &&Theorem| theorem.verdict == Decides::Proved;
            self.about(claim, form).into_iter().filter(proves).any(|theorem| theorem.degrees.covers(degrees))
        })
    }

    /// Why no theorem says all of a claim.
    #[must_use]
    pub fn missing_because(&self, claim: &str) -> Option<&str> {
        let of = |missing: &&Missing| missing.claims.iter().any(|one| one == claim);
        self.missing.iter().find(of).map(|missing| missing.why.as_str())
    }

    /// Does a theorem say what is printed from this sentence of the claim?
    #[must_use]
    pub fn is_from_stanza(&self, claim: &str, form: StanzaPart) -> bool {
        self.stanzas.iter().any(|one| one.split_once(' ') == Some((claim, form.name())))
    }

    /// The theorems that say all of a sentence, true or false, in at least one of its degrees.
    ///
    /// Another sentence of the same name, in another paper or in a file of the user's own, has none.
    #[must_use]
    pub fn about(&self, claim: Claim<'_>, form: Form) -> Vec<&Theorem> {
        let sentence = claim.sentence(form).filter(|sentence| is_of_the_paper(claim, form, sentence));
        let Some(sentence) = sentence else { return Vec::new() };
        let (part, degrees) = match form {
            Form::Degree(k) => (Form::Printed, DegreeRange::one(k)),
            Form::Degrees => (Form::Printed, DegreeRange::of(sentence)),
            _ => (form, DegreeRange::of(sentence)),
        };
        let is_about = |theorem: &&Theorem| {
            theorem.claim == claim.id()
                && theorem.form.form() == Some(part)
                && theorem.covers == Covers::All
                && !theorem.degrees.is_apart_from(degrees)
        };
        self.theorems.iter().filter(is_about).collect()
    }
}

/// Is it the sentence that the rows are about?
fn is_of_the_paper(claim: Claim<'_>, form: Form, sentence: &Sentence) -> bool {
    let own = Claim::of(paper()).find(|own| own.id() == claim.id());
    own.is_some_and(|own| {
        let family = &claim.paper.about.family;
        own.sentence(form) == Some(sentence)
            && own.definitions == claim.definitions
            && own.paper.about.family == *family
    })
}

impl Theorem {
    /// Holds it against what was computed of its sentence.
    ///
    /// # Errors
    /// [`Disagreement`], if both can't be: it says that the sentence is true, and there is a counterexample in one of its degrees;
    /// or that it is false, and in one of its degrees the sentence was found to be true.
    pub fn agrees(&self, form: Form, computed: Computed<'_>) -> Result<(), Disagreement> {
        let contrary = match self.verdict {
            Decides::Proved => {
                let witness = computed.witness();
                let own = witness.filter(|witness| witness.k.is_none_or(|k| self.degrees.contains(k)));
                own.map(|witness| ("true", witness.to_string()))
            }
            Decides::Refuted => computed.proved().and_then(|proved| match proved {
                [] => Some(("false", "it is true".to_owned())),
                _ => {
                    let k = proved.iter().find(|k| self.degrees.contains(**k))?;
                    Some(("false", format!("for k = {k} it is true")))
                }
            }),
        };
        let Some((says, found)) = contrary else { return Ok(()) };
        let (claim, theorem) = (self.claim.clone(), self.name.clone());
        Err(Disagreement { claim, form, theorem, says, found })
    }
}
