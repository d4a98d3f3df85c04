//! What is wrong with a text: where, by which rule, and what to write instead.

use std::fmt;
use std::ops::Range;
use std::sync::Arc;

use annotate_snippets::{AnnotationKind, Group, Level, Renderer, Snippet};

/// Bytes of a text.
pub(super) type Place = Range<usize>;

/// A text and what it is called: the name of a file, or what part of a sentence it is.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct Origin {
    pub(super) name: String,
    pub(super) text: String,
}

/// What is wrong in a text that is read, before it is known where that text stands.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Fault {
    pub(super) at: Place,
    pub(super) rule: String,
    pub(super) advice: String,
}

/// For a `Result` of the reader: the fault at a place.
pub(super) fn fault<T>(at: &Place, rule: impl Into<String>, advice: impl Into<String>) -> Result<T, Fault> {
    Err(Fault { at: at.clone(), rule: rule.into(), advice: advice.into() })
}

/// A fault at a place, unless this holds.
pub(super) fn ensure(
    holds: bool,
    at: &Place,
    rule: impl Into<String>,
    advice: impl Into<String>,
) -> Result<(), Fault> {
    if holds { Ok(()) } else { fault(at, rule, advice) }
}

/// What is wrong with a text: where, by which rule, and what to write instead.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Complaint {
    origin: Arc<Origin>,
    at: Place,
    rule: String,
    advice: String,
}

impl Complaint {
    /// Of a fault in the text; `at` is where it stands in that.
    pub(super) fn new(
        origin: &Arc<Origin>,
        at: Place,
        rule: impl Into<String>,
        advice: impl Into<String>,
    ) -> Self {
        let inside = |byte: usize| {
            (0..=byte.min(origin.text.len()))
                .rev()
                .find(|byte| origin.text.is_char_boundary(*byte))
                .unwrap_or(0)
        };
        let at = inside(at.start)..inside(at.end.max(at.start));
        Self { origin: Arc::clone(origin), at, rule: rule.into(), advice: advice.into() }
    }

    /// Of a file that another room reads; without a text, of the file as a whole.
    #[must_use]
    pub fn in_file(
        (name, text): (&str, &str),
        at: Range<usize>,
        rule: impl Into<String>,
        advice: impl Into<String>,
    ) -> Self {
        Self::new(&Arc::new(Origin { name: name.to_owned(), text: text.to_owned() }), at, rule, advice)
    }

    /// The same, with the folder of the file before its name.
    #[must_use]
    pub fn below(self, folder: &str) -> Self {
        let Origin { name, text } = &*self.origin;
        let origin = Origin { name: format!("{folder}/{name}"), text: text.clone() };
        Self { origin: Arc::new(origin), ..self }
    }

    /// The file, or the part of a sentence that was given by itself.
    #[must_use]
    pub fn source(&self) -> &str {
        &self.origin.name
    }

    /// Line and column of the first character that is underlined, from 1.
    #[must_use]
    pub fn place(&self) -> (usize, usize) {
        let before = &self.origin.text[..self.at.start];
        let line = before.rfind('\n').map_or(0, |newline| newline + 1);
        (before.matches('\n').count() + 1, before[line..].chars().count() + 1)
    }

    /// What is underlined.
    #[must_use]
    pub fn underlined(&self) -> &str {
        &self.origin.text[self.at.clone()]
    }

    /// Which rule it breaks.
    #[must_use]
    pub fn rule(&self) -> &str {
        &self.rule
    }

    /// What to write instead.
    #[must_use]
    pub fn advice(&self) -> &str {
        &self.advice
    }

    /// One line: the place, the rule, and what to write instead.
    #[must_use]
    pub fn message(&self) -> String {
        let (line, column) = self.place();
        format!("{}, line {line}, column {column}: {}; {}", self.origin.name, self.rule, self.advice)
    }

    /// The line of the text with the place underlined.
    #[must_use]
    pub fn excerpt(&self) -> String {
        let place = AnnotationKind::Primary.span(self.at.clone());
        let snippet = Snippet::source(self.origin.text.as_str()).annotation(place);
        Renderer::plain().render(&[Group::with_level(Level::ERROR).element(snippet)])
    }
}

/// Two parts: the message, and below it the excerpt.
impl fmt::Display for Complaint {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}\n{}", self.message(), self.excerpt())
    }
}

impl std::error::Error for Complaint {}
