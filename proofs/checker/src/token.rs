//! Text to tokens, tokens to trees of brackets.

use crate::error::Reason;
use crate::number::Ratio;

/// Brackets may be nested so deep; all later recursion follows the tree and is bounded by this as well.
const DEPTH: usize = 80;
const BYTES: usize = 1 << 26;

pub(crate) struct Node {
    pub(crate) line: usize,
    pub(crate) kind: Kind,
}

pub(crate) enum Kind {
    Number(Ratio),
    Name(String),
    Text(String),
    List(Vec<Node>),
}

struct Token<'a> {
    line: usize,
    /// As it is written; a string with its quotation marks.
    text: &'a str,
}

fn is_space(c: char) -> bool {
    matches!(c, ' ' | '\t' | '\n' | '\r')
}

fn tokens(text: &str) -> Result<Vec<Token<'_>>, Reason> {
    if text.len() > BYTES {
        return Err(Reason::TooLarge("the file"));
    }
    let (mut rest, mut line, mut found) = (text, 1, Vec::new());
    while let Some(c) = rest.chars().next() {
        let length = match c {
            '(' | ')' => 1,
            '"' => match rest.char_indices().skip(1).find(|(_, c)| *c == '\\' || *c == '"' || c.is_control())
            {
                Some((end, '"')) => end + 1,
                _ => return Err(Reason::Syntax { line, expected: "the end of a string" }),
            },
            _ if is_space(c) => {
                line += usize::from(c == '\n');
                rest = rest.get(1..).unwrap_or_default();
                continue;
            }
            _ => rest.find(|c| is_space(c) || matches!(c, '(' | ')' | '"')).unwrap_or(rest.len()),
        };
        let (text, tail) = rest.split_at_checked(length).unwrap_or((rest, ""));
        let bracket = matches!(c, '(' | ')');
        if !bracket && !tail.chars().next().is_none_or(|c| is_space(c) || matches!(c, '(' | ')')) {
            return Err(Reason::Syntax { line, expected: "white space" });
        }
        found.push(Token { line, text });
        rest = tail;
    }
    Ok(found)
}

/// The tokens with single spaces between them and none next to the inside of a bracket.
pub(crate) fn canonical(text: &str) -> Result<String, Reason> {
    let (mut out, mut open) = (String::new(), true);
    for token in tokens(text)? {
        if !open && token.text != ")" {
            out.push(' ');
        }
        open = token.text == "(";
        out.push_str(token.text);
    }
    Ok(out)
}

pub(crate) fn is_plain_name(word: &str) -> bool {
    word.starts_with(|c: char| c.is_ascii_alphabetic())
        && word.bytes().all(|b| b.is_ascii_alphanumeric() || matches!(b, b'.' | b'-'))
}

fn atom(token: &Token<'_>) -> Result<Node, Reason> {
    let (line, word) = (token.line, token.text);
    let kind = if let Some(inside) = word.strip_prefix('"') {
        Kind::Text(inside.trim_end_matches('"').to_owned())
    } else if is_plain_name(word) || matches!(word, "+" | "-" | "*" | "/" | "^" | "=" | ">" | ">=" | "<") {
        Kind::Name(word.to_owned())
    } else if let Some(number) = Ratio::parse(word) {
        Kind::Number(number)
    } else {
        return Err(Reason::Syntax { line, expected: "a name or a number in lowest terms" });
    };
    Ok(Node { line, kind })
}

/// The one tree that the text is.
pub(crate) fn tree(text: &str) -> Result<Node, Reason> {
    let mut open: Vec<(usize, Vec<Node>)> = Vec::new();
    let mut whole: Option<Node> = None;
    for token in tokens(text)? {
        let line = token.line;
        if whole.is_some() {
            return Err(Reason::Syntax { line, expected: "the end of the file" });
        }
        let done = match token.text {
            "(" if open.len() >= DEPTH => return Err(Reason::TooLarge("the nesting")),
            "(" => {
                open.push((line, Vec::new()));
                continue;
            }
            ")" => match open.pop() {
                Some((line, inside)) => Node { line, kind: Kind::List(inside) },
                None => return Err(Reason::Syntax { line, expected: "an opening bracket" }),
            },
            _ => atom(&token)?,
        };
        match open.last_mut() {
            Some((_, inside)) => inside.push(done),
            None => whole = Some(done),
        }
    }
    match (whole, open.pop()) {
        (Some(node), None) => Ok(node),
        (_, Some((line, _))) => Err(Reason::Syntax { line, expected: "the bracket that closes this one" }),
        (None, None) => Err(Reason::Syntax { line: 1, expected: "a bracket" }),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn white_space_means_nothing_else() {
        let want = "(a (b \"c  d\" 1/2) >=)";
        for text in [want, " ( a\n(b\t\"c  d\" 1/2 ) >= ) \r\n", "(a(b \"c  d\" 1/2)>=)"] {
            assert_eq!(canonical(text).as_deref(), Ok(want));
        }
    }

    #[test]
    fn what_is_no_tree_is_rejected() {
        let deep = "(".repeat(100_000);
        let bad = [
            "",
            "(",
            ")",
            "(a))",
            "(a) b",
            "(a",
            "(\"x)",
            "(\"x\\n\")",
            "(\"x\ny\")",
            "(a\"b\")",
            "(\"a\"b)",
            "(1a)",
            "(a_b)",
            "(é)",
            "(;)",
            "(==)",
            "(01)",
            "(2/4)",
            "(-0)",
            "(a\u{a0}b)",
            deep.as_str(),
            "\u{feff}(a)",
        ];
        for text in bad {
            assert!(tree(text).is_err(), "{text}");
        }
    }

    #[test]
    fn lines_are_counted() {
        assert_eq!(
            tree("(a\n(b\n01))").err(),
            Some(Reason::Syntax { line: 3, expected: "a name or a number in lowest terms" })
        );
    }
}
