//! The elements of a bracket, read from left to right.

use crate::error::Reason;
use crate::number::Ratio;
use crate::token::{Kind, Node, is_plain_name};

/// Heads of terms and lists: a name that stands at the head of a bracket must not be one of them.
const HEADS: [&str; 13] =
    ["t", "x", "w", "v", "Dw", "G", "DG", "de-boor", "at", "det", "integer", "each", "binomial"];

pub(crate) fn wrong<T>(line: usize, expected: &'static str) -> Result<T, Reason> {
    Err(Reason::Syntax { line, expected })
}

/// The elements of a bracket, from left to right.
pub(crate) struct Fields<'a> {
    pub(crate) line: usize,
    pub(crate) rest: &'a [Node],
}

impl<'a> Fields<'a> {
    pub(crate) fn of(node: &'a Node, expected: &'static str) -> Result<Self, Reason> {
        match &node.kind {
            Kind::List(rest) => Ok(Fields { line: node.line, rest }),
            _ => wrong(node.line, expected),
        }
    }

    /// A bracket that starts with a name.
    pub(crate) fn headed(node: &'a Node, expected: &'static str) -> Result<(&'a str, Self), Reason> {
        let mut fields = Fields::of(node, expected)?;
        match &fields.next(expected)?.kind {
            Kind::Name(name) => Ok((name, fields)),
            _ => wrong(node.line, expected),
        }
    }

    /// The bracket that comes next, if it starts with this name.
    pub(crate) fn part(&mut self, head: &'static str) -> Option<Self> {
        let (first, rest) = self.rest.split_first()?;
        match Fields::headed(first, head) {
            Ok((name, fields)) if name == head => {
                self.rest = rest;
                Some(fields)
            }
            _ => None,
        }
    }

    pub(crate) fn need(&mut self, head: &'static str) -> Result<Self, Reason> {
        let line = self.rest.first().map_or(self.line, |node| node.line);
        self.part(head).map_or_else(|| wrong(line, head), Ok)
    }

    pub(crate) fn next(&mut self, expected: &'static str) -> Result<&'a Node, Reason> {
        let Some((first, rest)) = self.rest.split_first() else { return wrong(self.line, expected) };
        self.rest = rest;
        Ok(first)
    }

    pub(crate) fn end(self) -> Result<(), Reason> {
        self.rest.first().map_or(Ok(()), |node| wrong(node.line, "a closing bracket"))
    }

    /// All that is left, and something has to be.
    pub(crate) fn all<T>(
        self,
        expected: &'static str,
        read: impl Fn(&'a Node) -> Result<T, Reason>,
    ) -> Result<Vec<T>, Reason> {
        if self.rest.is_empty() { wrong(self.line, expected) } else { self.rest.iter().map(read).collect() }
    }

    /// A name that starts with a letter.
    pub(crate) fn name(&mut self) -> Result<String, Reason> {
        let node = self.next("a name")?;
        match &node.kind {
            Kind::Name(name) if is_plain_name(name) => Ok(name.clone()),
            _ => wrong(node.line, "a name"),
        }
    }

    /// A name that will stand at the head of brackets.
    pub(crate) fn head(&mut self) -> Result<String, Reason> {
        let (line, name) = (self.line, self.name()?);
        if HEADS.contains(&name.as_str()) {
            wrong(line, "a name that is no word of the format")
        } else {
            Ok(name)
        }
    }

    pub(crate) fn word(&mut self, expected: &'static str, words: &[&str]) -> Result<String, Reason> {
        let node = self.next(expected)?;
        match &node.kind {
            Kind::Name(name) if words.contains(&name.as_str()) => Ok(name.clone()),
            _ => wrong(node.line, expected),
        }
    }

    pub(crate) fn text(&mut self) -> Result<String, Reason> {
        let node = self.next("a string")?;
        match &node.kind {
            Kind::Text(text) if !text.trim().is_empty() => Ok(text.clone()),
            _ => wrong(node.line, "a string that is not empty"),
        }
    }

    pub(crate) fn number(&mut self) -> Result<Ratio, Reason> {
        number(self.next("a number")?)
    }

    pub(crate) fn integer(&mut self) -> Result<i64, Reason> {
        let line = self.line;
        self.number()?.integer().map_or_else(|| wrong(line, "a whole number"), Ok)
    }
}

pub(crate) fn number(node: &Node) -> Result<Ratio, Reason> {
    match &node.kind {
        Kind::Number(number) => Ok(number.clone()),
        _ => wrong(node.line, "a number"),
    }
}
