//! Text to a tree of brackets, and what can be asked about its nodes.

use std::hash::{Hash, Hasher};
use std::rc::Rc;

use dashu_int::IBig;

use crate::error::{Reason, Result};
use crate::poly::Poly;

/// Brackets may be nested so deep; all later recursion over the tree is bounded by this as well.
const DEPTH: usize = 80;
/// More digits than this in one number are not read.
const DIGITS: usize = 1_000;
/// A statement or a proof of more bytes than this is not read.
pub(crate) const LONGEST: usize = 4_000_000;
/// Nor longer names of claims.
const CLAIM: usize = 100;
/// Names that stand at the head of brackets and mean something there already.
const HEADS: [&str; 13] =
    ["t", "x", "w", "v", "Dw", "G", "DG", "de-boor", "at", "det", "integer", "each", "binomial"];

/// A token, or a bracket with what is in it.
#[derive(Clone)]
pub(crate) struct Node<'t> {
    line: usize,
    pub(crate) kind: Kind<'t>,
}

#[derive(Clone, PartialEq, Eq, Hash)]
pub(crate) enum Kind<'t> {
    /// Numerator and denominator, in lowest terms.
    Number(IBig, IBig),
    Name(&'t str),
    Text(&'t str),
    /// Shared: terms of a derivation are parts of many others.
    List(Rc<[Node<'t>]>),
}

/// Two nodes are equal if they are the same text, wherever that stands.
impl PartialEq for Node<'_> {
    fn eq(&self, other: &Self) -> bool {
        self.kind == other.kind
    }
}

impl Eq for Node<'_> {}

impl Hash for Node<'_> {
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.kind.hash(state);
    }
}

impl<'t> Node<'t> {
    fn derived(kind: Kind<'t>) -> Self {
        Node { line: 0, kind }
    }

    /// A name.
    pub(crate) fn name_of(name: &'t str) -> Self {
        Node::derived(Kind::Name(name))
    }

    /// A whole number.
    pub(crate) fn whole_of(value: i64) -> Self {
        Node::derived(Kind::Number(value.into(), IBig::ONE))
    }

    /// A bracket without a name in front.
    pub(crate) fn group_of(items: Vec<Node<'t>>) -> Self {
        Node::derived(Kind::List(items.into()))
    }

    /// A bracket.
    pub(crate) fn made(head: &'t str, fields: Vec<Node<'t>>) -> Self {
        Node::derived(Kind::List([Node::name_of(head)].into_iter().chain(fields).collect()))
    }

    /// With every place inside of a span at an end of it.
    pub(crate) fn at_end(&self, end: &'t str) -> Self {
        match &self.kind {
            Kind::List(items) if self.is("in") => Node::made(end, items.iter().skip(1).cloned().collect()),
            Kind::List(items) => Node::group_of(items.iter().map(|item| item.at_end(end)).collect()),
            _ => self.clone(),
        }
    }

    /// Whether it, or a part of it, is such.
    pub(crate) fn any(&self, is: &mut dyn FnMut(&Self) -> bool) -> bool {
        let inside = match &self.kind {
            Kind::List(items) => &**items,
            _ => &[],
        };
        is(self) || inside.iter().any(|item| item.any(is))
    }

    /// Whether there is no bracket in it.
    pub(crate) fn is_flat(&self) -> bool {
        match &self.kind {
            Kind::List(items) => items.iter().all(|item| !matches!(item.kind, Kind::List(_))),
            _ => true,
        }
    }

    /// Whether it is this name.
    pub(crate) fn is_word(&self, word: &str) -> bool {
        matches!(self.kind, Kind::Name(name) if name == word)
    }

    pub(crate) fn wrong<T>(&self, expected: &'static str) -> Result<T> {
        Err(Reason::Syntax { line: self.line, expected })
    }

    /// What is in a bracket, and something has to be.
    pub(crate) fn list(&self, expected: &'static str) -> Result<&[Node<'t>]> {
        match &self.kind {
            Kind::List(items) if !items.is_empty() => Ok(items),
            _ => self.wrong(expected),
        }
    }

    /// What is in a bracket that has so many elements.
    pub(crate) fn group<const N: usize>(&self, expected: &'static str) -> Result<&[Node<'t>; N]> {
        self.list(expected)?.try_into().or_else(|_| self.wrong(expected))
    }

    /// The name that a bracket starts with, and the fields behind it.
    pub(crate) fn headed(&self, expected: &'static str) -> Result<(&'t str, &[Node<'t>])> {
        match self.list(expected)? {
            [Node { kind: Kind::Name(head), .. }, fields @ ..] => Ok((head, fields)),
            _ => self.wrong(expected),
        }
    }

    /// The fields of a bracket that starts with this name.
    pub(crate) fn fields(&self, head: &'static str) -> Result<&[Node<'t>]> {
        match self.headed(head)? {
            (found, fields) if found == head => Ok(fields),
            _ => self.wrong(head),
        }
    }

    /// The same, if there are any.
    pub(crate) fn some(&self, head: &'static str) -> Result<&[Node<'t>]> {
        self.fields(head).and_then(|fields| if fields.is_empty() { self.wrong(head) } else { Ok(fields) })
    }

    /// The same, if there are so many.
    pub(crate) fn part<const N: usize>(&self, head: &'static str) -> Result<&[Node<'t>; N]> {
        self.fields(head)?.try_into().or_else(|_| self.wrong("another number of fields"))
    }

    pub(crate) fn is(&self, head: &'static str) -> bool {
        self.fields(head).is_ok()
    }

    /// A name that starts with a letter.
    pub(crate) fn name(&self) -> Result<&'t str> {
        match self.kind {
            Kind::Name(name) if is_plain_name(name) => Ok(name),
            _ => self.wrong("a name"),
        }
    }

    /// A name that can stand at the head of brackets.
    pub(crate) fn head(&self) -> Result<&'t str> {
        match self.name()? {
            name if HEADS.contains(&name) => self.wrong("a name that is no word of the format"),
            name => Ok(name),
        }
    }

    /// A name, and the indices that it has.
    pub(crate) fn indexed(&self) -> Result<(&'t str, &[Node<'t>])> {
        match &self.kind {
            Kind::List(items) => match &**items {
                [name, indices @ ..] if !indices.is_empty() => Ok((name.head()?, indices)),
                _ => self.wrong("a name with an index"),
            },
            _ => Ok((self.name()?, &[])),
        }
    }

    pub(crate) fn word(&self, words: &[&str], expected: &'static str) -> Result<&'t str> {
        match self.kind {
            Kind::Name(name) if words.contains(&name) => Ok(name),
            _ => self.wrong(expected),
        }
    }

    pub(crate) fn text(&self) -> Result<&'t str> {
        match self.kind {
            Kind::Text(text) if !text.trim().is_empty() => Ok(text),
            _ => self.wrong("a string that is not empty"),
        }
    }

    /// The name of a claim, in quotes.
    pub(crate) fn claim(&self) -> Result<&'t str> {
        match self.kind {
            Kind::Text(name) if is_plain_name(name) && name.len() <= CLAIM => Ok(name),
            _ => self.wrong("the name of a claim: a letter, then letters, digits, `.` and `-`"),
        }
    }

    /// A number, as two polynomials without variables; the second one is positive.
    pub(crate) fn ratio(&self) -> Result<(Poly, Poly)> {
        match &self.kind {
            Kind::Number(num, den) => Ok((Poly::constant(num.clone()), Poly::constant(den.clone()))),
            _ => self.wrong("a number"),
        }
    }

    pub(crate) fn degree(&self) -> Result<u8> {
        let degree = u8::try_from(self.whole()?).ok().filter(|degree| *degree <= 100);
        degree.map_or_else(|| self.wrong("a degree from 0 to 100"), Ok)
    }

    pub(crate) fn whole(&self) -> Result<i64> {
        let whole = match &self.kind {
            Kind::Number(num, den) if *den == IBig::ONE => i64::try_from(num).ok(),
            _ => None,
        };
        whole.map_or_else(|| self.wrong("a whole number that fits"), Ok)
    }
}

fn is_plain_name(word: &str) -> bool {
    let plain = |b: u8| b.is_ascii_alphanumeric() || matches!(b, b'.' | b'-');
    word.starts_with(|c: char| c.is_ascii_alphabetic()) && word.bytes().all(plain)
}

/// `-?digits` or `-?digits/digits`, written in the one way in which it can be.
fn number(word: &str) -> Option<Kind<'_>> {
    let (num, den) = match word.split_once('/') {
        None => (whole(word)?, IBig::ONE),
        Some((num, den)) => (whole(num)?, whole(den).filter(|den| *den > IBig::ONE)?),
    };
    // Euclid, only to see that the terms are the lowest.
    let (mut a, mut b) = (den.clone(), num.clone());
    while b != IBig::ZERO {
        (a, b) = (b.clone(), a % b);
    }
    (a == IBig::ONE || a == -IBig::ONE).then_some(Kind::Number(num, den))
}

fn whole(word: &str) -> Option<IBig> {
    let value = if word.len() > DIGITS { None } else { word.parse::<IBig>().ok() };
    value.filter(|value| value.to_string() == word)
}

fn atom(word: &str) -> Option<Kind<'_>> {
    if let Some(inside) = word.strip_prefix('"') {
        return inside.strip_suffix('"').filter(|text| text.chars().all(is_printed)).map(Kind::Text);
    }
    let name = is_plain_name(word)
        || matches!(word, "+" | "-" | "*" | "/" | "^" | "=" | ">" | ">=" | "<")
        || matches!(word, "/=" | "<=" | "=>" | "<=>");
    if name { Some(Kind::Name(word)) } else { number(word) }
}

/// Whether a reader sees the character: it is no control, no format or direction mark, no mark on another character, and
/// no space but the usual one. In a string there is no backslash either.
fn is_printed(c: char) -> bool {
    c == '\'' || c != '\\' && c.escape_debug().len() == 1
}

/// What stands between tokens, or is one.
fn is_break(c: char) -> bool {
    matches!(c, ' ' | '\t' | '\n' | '\r' | '(' | ')')
}

/// The first token, or one space, and what is behind it.
fn split_token(text: &str) -> (&str, &str) {
    let length = match text.strip_prefix('"') {
        Some(inside) => inside.split_once('"').map(|(inside, _)| inside.len() + 2),
        None if text.starts_with(is_break) => Some(1),
        None => text.find(|c| is_break(c) || c == '"'),
    };
    length.and_then(|length| text.split_at_checked(length)).unwrap_or((text, ""))
}

/// The one tree that the text is.
pub(crate) fn tree(text: &str) -> Result<Node<'_>> {
    if text.len() > LONGEST {
        return Err(Reason::Limits("the text"));
    }
    if text.starts_with('\u{feff}') {
        return Err(Reason::Syntax { line: 1, expected: "no byte order mark" });
    }
    let (mut rest, mut line) = (text, 1);
    // The brackets that are open, the whole text being the first one.
    let mut open = vec![(line, Vec::new())];
    while !rest.is_empty() {
        let wrong = |expected| Err(Reason::Syntax { line, expected });
        let (token, behind) = split_token(rest);
        rest = behind;
        let done = match token {
            " " | "\t" | "\r" | "\n" => {
                line += usize::from(token == "\n");
                continue;
            }
            "(" if open.len() > DEPTH => return Err(Reason::Limits("the nesting")),
            "(" => {
                open.push((line, Vec::new()));
                continue;
            }
            ")" => open.pop().map(|(line, inside)| Node { line, kind: Kind::List(inside.into()) }),
            _ if !rest.is_empty() && !rest.starts_with(is_break) => return wrong("white space"),
            _ => atom(token).map(|kind| Node { line, kind }),
        };
        match (done, open.last_mut()) {
            (Some(node), Some((_, outer))) => outer.push(node),
            (Some(_), None) => return wrong("an opening bracket"),
            (None, _) if token.starts_with('"') => return wrong("a string of visible characters and spaces"),
            (None, _) => return wrong("a string, a name or a number in lowest terms"),
        }
    }
    match (open.pop(), open.is_empty()) {
        (Some((_, mut whole)), true) if whole.len() == 1 => Ok(whole.swap_remove(0)),
        (_, true) => Err(Reason::Syntax { line, expected: "one bracket" }),
        (_, false) => Err(Reason::Syntax { line, expected: "a closing bracket" }),
    }
}
