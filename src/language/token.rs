//! Text → tokens. What people type from habit, `≤`, `==`, `&&`, is told what to write here.

use winnow::ascii::{digit1, multispace0};
use winnow::combinator::{alt, delimited, eof, opt};
use winnow::prelude::*;
use winnow::stream::{LocatingSlice, Location};
use winnow::token::{any, literal, one_of, take_while};

use super::complaint::{Fault, Place, fault};

/// The smallest part of a text that has a meaning.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Token<'a> {
    /// `3`, `0.4`.
    Number(&'a str),
    /// A name, and how many primes follow it.
    Name(&'a str, usize),
    /// `claim(X.linear` with the bracket: an identifier has its own alphabet.
    Claim(&'a str),
    /// A bracket, an operator, a separator.
    Sign(&'a str),
    /// Nothing follows.
    End,
}

/// A longer text is refused before any work is done on it.
const LONGEST: usize = 20_000;

/// What is written elsewhere, and here.
const HABITS: &[(&str, &str)] = &[
    ("==", "="),
    ("&&", "and"),
    ("||", "or"),
    ("...", ".."),
    ("**", "^"),
    ("<>", "!="),
    ("=<", "<="),
    ("->", "=>"),
    ("…", ".."),
    ("≤", "<="),
    ("≥", ">="),
    ("≠", "!="),
    ("·", "*"),
    ("×", "*"),
    ("÷", "/"),
    ("−", "-"),
    ("–", "-"),
    ("∈", "in"),
    ("⇒", "=>"),
    ("→", "=>"),
    ("⇔", "<=>"),
    ("∧", "and"),
    ("∨", "or"),
    ("¬", "not"),
    ("∀", "all(… : …)"),
    ("∃", "some(… : …)"),
    ("Σ", "sum(i in 0..n: …)"),
    ("∑", "sum(i in 0..n: …)"),
    ("Π", "prod(i in 0..n: …)"),
    ("∏", "prod(i in 0..n: …)"),
    ("√", "sqrt(…)"),
    ("′", "'"),
    ("α", "alpha"),
    ("β", "beta"),
    ("φ", "phi"),
    ("∞", "infinity"),
    ("²", "^2"),
    ("³", "^3"),
];

const LONG_SIGNS: [&str; 6] = ["<=>", "!=", "<=", ">=", "=>", ".."];
const SIGNS: &str = "+-*/^()[]{},;:=<>|";

/// The tokens of a text with their places; the last is [`Token::End`].
pub(super) fn tokens(text: &str) -> Result<Vec<(Token<'_>, Place)>, Fault> {
    if text.len() > LONGEST {
        return fault(
            &(0..0),
            format!("a text has at most {LONGEST} bytes"),
            "cut it into several sentences",
        );
    }
    let mut input = LocatingSlice::new(text);
    let mut all = Vec::new();
    while all.last().is_none_or(|(token, _)| *token != Token::End) {
        let at = text.len() - text[input.current_token_start()..].trim_start().len();
        let rest = &text[at..];
        let habit = HABITS.iter().find(|(wrong, _)| rest.starts_with(wrong) && !rest.starts_with("<=>"));
        if let Some((wrong, right)) = habit {
            return fault(
                &(at..at + wrong.len()),
                format!("`{wrong}` is not in the language"),
                format!("write `{right}`"),
            );
        }
        let Ok((token, place)) = token(&mut input) else {
            let length = rest.chars().next().map_or(0, char::len_utf8);
            let advice = match rest.starts_with('!') {
                true => "write `not`, or `!=` for unequal",
                false => "see the page of the language for what can be written",
            };
            return fault(
                &(at..at + length),
                format!("`{}` is not in the language", &rest[..length]),
                advice,
            );
        };
        all.push((token, place));
    }
    Ok(all)
}

fn token<'a>(input: &mut LocatingSlice<&'a str>) -> ModalResult<(Token<'a>, Place)> {
    multispace0.parse_next(input)?;
    let number = (digit1, opt(('.', digit1))).take().map(Token::Number);
    let letter = |c: char| c.is_ascii_alphanumeric() || c == '_';
    let name =
        ((one_of(|c: char| c.is_ascii_alphabetic()), take_while(0.., letter)).take(), take_while(0.., '\''))
            .map(|(name, primes): (_, &str)| Token::Name(name, primes.len()));
    let id = take_while(1.., |c: char| c.is_ascii_alphanumeric() || "._-".contains(c));
    let claim = delimited(("claim", multispace0, '(', multispace0), id, multispace0).map(Token::Claim);
    let long = alt(LONG_SIGNS.map(literal)).map(Token::Sign);
    let short = any.verify(|c| SIGNS.contains(*c)).take().map(Token::Sign);
    alt((claim, number, name, long, short, eof.value(Token::End))).with_span().parse_next(input)
}
