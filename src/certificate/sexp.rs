//! The syntax of statements and proofs: nested lists of tokens (`proofs/FORMAT.md`, "Tokens").

use std::fmt;

use thiserror::Error;

use crate::scalar::BigRational;

/// A token, or a list of such.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Sexp {
    /// `name`, or an operator.
    Name(String),
    /// An exact number.
    Number(BigRational),
    /// `"…"`.
    Text(String),
    /// `(…)`.
    List(Vec<Sexp>),
}

/// Brackets may be nested so deep: whatever reads, prints or drops the items goes down by recursion.
const DEPTH: usize = 80;
/// Numbers of more characters are not read.
const DIGITS: usize = 1_000;

/// Why a text is not in this syntax.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum SyntaxError {
    /// The text ends inside a list or a string.
    #[error("it ends inside a list or a string")]
    End,
    /// A `)` without its `(`.
    #[error("a `)` too many")]
    Closing,
    /// Neither a name nor a number in lowest terms nor a string of visible characters.
    #[error("`{0}` is no token")]
    Token(String),
    /// Two tokens that are not brackets, and nothing between them.
    #[error("white space is missing before `{0}`")]
    Space(String),
    /// A byte order mark before the text.
    #[error("a byte order mark stands before the text")]
    Mark,
    /// Brackets in brackets in brackets, too many.
    #[error("the nesting is beyond the limits")]
    Nesting,
    /// One item was expected.
    #[error("it has {0} items where one is expected")]
    Items(usize),
}

impl Sexp {
    /// Reads the items of a text.
    ///
    /// # Errors
    /// [`SyntaxError`].
    pub fn parse_all(text: &str) -> Result<Vec<Self>, SyntaxError> {
        if text.starts_with('\u{feff}') {
            return Err(SyntaxError::Mark);
        }
        let mut open: Vec<Vec<Self>> = vec![Vec::new()];
        let mut rest = text.trim_start_matches(is_space);
        while let Some(first) = rest.chars().next() {
            let (item, after) = match first {
                '(' if open.len() > DEPTH => return Err(SyntaxError::Nesting),
                '(' => {
                    open.push(Vec::new());
                    rest = rest[1..].trim_start_matches(is_space);
                    continue;
                }
                ')' => {
                    let list = open.pop().filter(|_| !open.is_empty()).ok_or(SyntaxError::Closing)?;
                    (Self::List(list), &rest[1..])
                }
                '"' => {
                    let (text, after) = rest[1..].split_once('"').ok_or(SyntaxError::End)?;
                    (Self::quoted(text)?, after)
                }
                _ => {
                    let end = rest.find(|c| ends_token(c) || c == '"').unwrap_or(rest.len());
                    let (token, after) = rest.split_at(end);
                    (Self::token(token)?, after)
                }
            };
            if first != ')' && !after.is_empty() && !after.starts_with(ends_token) {
                return Err(SyntaxError::Space(after.chars().take(20).collect()));
            }
            push(&mut open, item);
            rest = after.trim_start_matches(is_space);
        }
        match (open.pop(), open.is_empty()) {
            (Some(items), true) => Ok(items),
            _ => Err(SyntaxError::End),
        }
    }

    fn token(token: &str) -> Result<Self, SyntaxError> {
        let digits = token.strip_prefix('-').unwrap_or(token);
        if digits.starts_with(|c: char| c.is_ascii_digit()) {
            let number = Some(token).filter(|token| token.split('/').all(|part| part.len() <= DIGITS));
            let value = number.and_then(|token| token.parse::<BigRational>().ok());
            // Another way to write it is none.
            let value = value.filter(|value| value.to_string() == token);
            return value
                .map(Self::Number)
                .ok_or_else(|| SyntaxError::Token(token.escape_debug().to_string()));
        }
        let is_name = token.starts_with(|c: char| c.is_ascii_alphabetic())
            && token.chars().all(|c| c.is_ascii_alphanumeric() || matches!(c, '.' | '-'));
        let is_operator = matches!(
            token,
            "+" | "-" | "*" | "/" | "^" | "=" | "/=" | ">" | ">=" | "<" | "<=" | "=>" | "<=>"
        );
        if is_name || is_operator {
            Ok(Self::Name(token.to_owned()))
        } else {
            Err(SyntaxError::Token(token.escape_debug().to_string()))
        }
    }

    fn quoted(text: &str) -> Result<Self, SyntaxError> {
        let visible = |c: char| c == '\'' || c != '\\' && c.escape_debug().len() == 1;
        if text.trim().is_empty() || !text.chars().all(visible) {
            return Err(SyntaxError::Token(format!("\"{}\"", text.escape_debug())));
        }
        Ok(Self::Text(text.to_owned()))
    }

    /// A name.
    pub fn name(name: &str) -> Self {
        Self::Name(name.to_owned())
    }

    /// A whole number.
    pub fn int(value: i64) -> Self {
        Self::Number(BigRational::from_integer(value.into()))
    }

    /// `(head items…)`.
    pub fn form(head: &str, items: impl IntoIterator<Item = Self>) -> Self {
        Self::List(std::iter::once(Self::name(head)).chain(items).collect())
    }

    /// Does the name stand in it anywhere?
    #[must_use]
    pub fn mentions(&self, name: &str) -> bool {
        match self {
            Self::Name(own) => own == name,
            Self::List(parts) => parts.iter().any(|part| part.mentions(name)),
            Self::Number(_) | Self::Text(_) => false,
        }
    }

    /// The head and the items of a list that begins with a name.
    #[must_use]
    pub fn as_form(&self) -> Option<(&str, &[Self])> {
        match self {
            Self::List(items) => match items.split_first() {
                Some((Self::Name(head), rest)) => Some((head, rest)),
                _ => None,
            },
            _ => None,
        }
    }
}

fn is_space(c: char) -> bool {
    matches!(c, ' ' | '\t' | '\n' | '\r')
}

fn ends_token(c: char) -> bool {
    is_space(c) || matches!(c, '(' | ')')
}

fn push(open: &mut [Vec<Sexp>], item: Sexp) {
    if let Some(list) = open.last_mut() {
        list.push(item);
    }
}

impl fmt::Display for Sexp {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Name(name) => f.write_str(name),
            Self::Number(value) => write!(f, "{value}"),
            Self::Text(text) => write!(f, "\"{text}\""),
            Self::List(items) => {
                f.write_str("(")?;
                for (place, item) in items.iter().enumerate() {
                    write!(f, "{}{item}", if place == 0 { "" } else { " " })?;
                }
                f.write_str(")")
            }
        }
    }
}

/// Lines of at most this length, if the items allow it.
const WIDTH: usize = 110;

impl Sexp {
    /// The text over several lines: what does not fit into one is broken after the head, and each item indented.
    #[must_use]
    pub fn pretty(&self) -> String {
        let mut text = String::new();
        self.lay_out(0, &mut text);
        text.push('\n');
        text
    }

    fn lay_out(&self, indent: usize, out: &mut String) {
        let line = self.to_string();
        let Self::List(items) = self else {
            out.push_str(&line);
            return;
        };
        if indent + line.chars().count() <= WIDTH {
            out.push_str(&line);
            return;
        }
        out.push('(');
        let mut first = true;
        let mut fits_head = true;
        for item in items {
            let plain = !matches!(item, Self::List(_));
            if first {
                item.lay_out(indent + 1, out);
            } else if fits_head && plain && !matches!(item, Self::Text(_)) {
                out.push(' ');
                out.push_str(&item.to_string());
            } else {
                fits_head = false;
                out.push('\n');
                out.push_str(&" ".repeat(indent + 2));
                item.lay_out(indent + 2, out);
            }
            first = false;
        }
        out.push(')');
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn texts_are_read_and_written_alike() {
        let text = r#"(a (+ 1 -2/3 b.c-d) "two words" ())"#;
        let items = Sexp::parse_all(text).unwrap();
        assert_eq!(items.len(), 1);
        assert_eq!(items[0].to_string(), text);
        assert_eq!(Sexp::parse_all(&items[0].pretty()).unwrap(), items);
        for (bad, error) in [
            ("(a", SyntaxError::End),
            ("\"a", SyntaxError::End),
            ("a)", SyntaxError::Closing),
            ("1/0", SyntaxError::Token("1/0".into())),
            ("2/4", SyntaxError::Token("2/4".into())),
            ("-0", SyntaxError::Token("-0".into())),
            ("1\"a\"", SyntaxError::Space("\"a\"".into())),
            ("\"a\u{202e}b\"", SyntaxError::Token("\"a\\u{202e}b\"".into())),
            ("\u{feff}a", SyntaxError::Mark),
            ("α", SyntaxError::Token("α".into())),
        ] {
            assert_eq!(Sexp::parse_all(bad), Err(error));
        }
    }

    /// As deep as the checker reads and no deeper: dropping, comparing and printing are recursions too.
    #[test]
    fn brackets_are_nested_only_so_deep() {
        let deep = |depth: usize| "(- ".repeat(depth) + "u" + &")".repeat(depth);
        let deepest = Sexp::parse_all(&deep(DEPTH)).unwrap();
        assert_eq!(deepest[0].to_string(), deep(DEPTH));
        for depth in [DEPTH + 1, 1_000_000] {
            assert_eq!(Sexp::parse_all(&deep(depth)), Err(SyntaxError::Nesting));
        }
    }
}
