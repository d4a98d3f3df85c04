//! A claim: a stanza with what it may name, and its sentences by their form.

use std::fmt;

use super::cause::Source;
use super::file::{Said, Stanza};
use super::paper::{Paper, paper};
use super::print::{source, text};
use super::syntax::{Binder, Definition, Sentence};

/// Which sentence of a stanza.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Form {
    /// As the paper prints it.
    Printed,
    /// As amended.
    Amended,
    /// What holds where the amended one does not apply.
    Fails,
    /// The printed one, for one degree only.
    Degree(usize),
    /// The printed one, for those degrees in which it is true.
    Degrees,
}

impl Form {
    /// The name in those of certificates and windows: `printed`, `amended`, `degree-3`, `degrees`.
    #[must_use]
    pub fn name(self) -> String {
        self.to_string().replace(' ', "-")
    }
}

impl fmt::Display for Form {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Printed => f.write_str("printed"),
            Self::Amended => f.write_str("amended"),
            Self::Fails => f.write_str("fails"),
            Self::Degree(k) => write!(f, "degree {k}"),
            Self::Degrees => f.write_str("degrees"),
        }
    }
}

/// A stanza, with what it may name.
#[derive(Debug, Clone, Copy)]
pub struct Claim<'a> {
    /// What is said.
    pub stanza: &'a Stanza,
    /// The definitions of its file.
    pub definitions: &'a [Definition],
    /// The paper that it is one of.
    pub paper: &'a Paper,
}

impl<'a> Claim<'a> {
    /// The claims of a paper, in its order; they may name each other.
    pub fn of(paper: &'a Paper) -> impl Iterator<Item = Self> {
        paper.claims().map(move |(file, stanza)| Self { stanza, definitions: &file.definitions, paper })
    }

    /// Its identifier.
    #[must_use]
    pub fn id(&self) -> &'a str {
        &self.stanza.id
    }

    /// Who says it.
    #[must_use]
    pub fn source(&self) -> Source {
        if self.id().starts_with("X.") { Source::Question } else { Source::Paper }
    }

    /// One of its sentences; those for some degrees are the printed one.
    #[must_use]
    pub fn said(&self, form: Form) -> Option<&'a Said> {
        match form {
            Form::Printed | Form::Degree(_) | Form::Degrees => Some(&self.stanza.printed),
            Form::Amended => self.stanza.amended.as_ref(),
            Form::Fails => self.stanza.fails.as_ref(),
        }
    }

    /// The sentence that is decided, if there is one.
    #[must_use]
    pub fn sentence(&self, form: Form) -> Option<&'a Sentence> {
        self.said(form).and_then(Said::sentence)
    }

    /// The form that others mean by its name: the amended one, if there is one.
    #[must_use]
    pub fn strongest(&self) -> Form {
        if self.stanza.amended.is_some() { Form::Amended } else { Form::Printed }
    }

    /// It for people, with what its names stand for: empty, if there is none.
    #[must_use]
    pub fn text(&self, form: Form) -> String {
        match self.said(form) {
            Some(Said::Sentence(sentence)) => format!("{}{}", text(sentence), self.legend(&source(sentence))),
            Some(Said::Words { words, .. }) => words.clone(),
            None => String::new(),
        }
    }

    /// ` Here C(x) = …, r = α/(α − 1).`: the definitions that a text names, themselves or through others.
    fn legend(&self, sentence: &str) -> String {
        let names = |text: &str, name: &str| {
            text.split(|c: char| !(c.is_alphanumeric() || c == '_')).any(|word| word == name)
        };
        let mut texts = vec![sentence.to_owned()];
        let mut told: Vec<&Definition> = Vec::new();
        while let Some(body) = texts.pop() {
            for definition in self.definitions {
                if names(&body, &definition.name) && !told.contains(&definition) {
                    texts.push(source(&definition.body));
                    told.push(definition);
                }
            }
        }
        let mut told: Vec<_> = self.definitions.iter().filter(|one| told.contains(one)).collect();
        told.dedup();
        let mut all: Vec<String> = told.iter().map(|definition| text(*definition)).collect();
        let says_ratio = |text: &str| names(text, "r");
        if says_ratio(sentence) || told.iter().any(|definition| says_ratio(&source(&definition.body))) {
            all.push("r = α/(α − 1)".to_owned());
        }
        if all.is_empty() { String::new() } else { format!(" Here {}.", all.join("; ")) }
    }

    /// Can it be judged on any basis or index, not only on examples of the paper?
    #[must_use]
    pub fn is_general(&self) -> bool {
        self.sentence(Form::Printed).is_some() && !self.binds(|binder| matches!(binder, Binder::Instances(_)))
    }

    /// Does it speak of knots, and not of weights alone?
    #[must_use]
    pub fn is_about_knots(&self) -> bool {
        self.binds(|binder| {
            matches!(
                binder,
                Binder::Degree { .. } | Binder::Knots(_) | Binder::Instances(_) | Binder::Gaps(_)
            )
        })
    }

    fn binds(&self, of: impl Fn(&Binder) -> bool) -> bool {
        self.sentence(Form::Printed).is_some_and(|sentence| sentence.given.iter().any(of))
    }
}

/// The claims of the paper, and then our questions.
#[must_use]
pub fn claims() -> Vec<Claim<'static>> {
    Claim::of(paper()).collect()
}
