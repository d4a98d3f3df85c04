//! Text that a user or a file supplied, made harmless for a terminal.

use std::fmt::Write;
use std::path::Path;

/// The text with everything in it that a terminal would obey, or that would not be seen, as an escape such as
/// `\u{1b}`: control characters, marks of direction, line separators, and characters without any width.
pub(super) fn visible(text: &str) -> String {
    let mut shown = String::with_capacity(text.len());
    text.chars().for_each(|c| push(&mut shown, c));
    shown
}

/// The same for the name of a file.
pub(super) fn visible_path(path: &Path) -> String {
    visible(&path.display().to_string())
}

/// The same for JSON, in which such characters stand in strings only, those below U+0020 as escapes already.
pub(super) fn visible_json(json: &str) -> String {
    let mut shown = String::with_capacity(json.len());
    for c in json.chars() {
        if c != '\n' && obeyed_or_unseen(c) {
            for unit in c.encode_utf16(&mut [0; 2]) {
                let _ = write!(shown, "\\u{unit:04x}");
            }
        } else {
            shown.push(c);
        }
    }
    shown
}

/// The same for a whole result, in which line breaks, tabs and styles are the program's own.
///
/// A style is `ESC [ … m`. What was supplied has gone through [`visible`], so none of them is in it.
pub(super) fn visible_lines(text: &str) -> String {
    let mut shown = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(c) = rest.chars().next() {
        if let Some(style) = style(rest) {
            shown.push_str(style);
            rest = &rest[style.len()..];
            continue;
        }
        match c {
            '\n' | '\t' => shown.push(c),
            _ => push(&mut shown, c),
        }
        rest = &rest[c.len_utf8()..];
    }
    shown
}

/// The style that the text begins with.
fn style(text: &str) -> Option<&str> {
    let parameters = text.strip_prefix("\u{1b}[")?;
    let length = parameters.find(|c: char| !c.is_ascii_digit() && c != ';')?;
    parameters[length..].starts_with('m').then(|| &text[..length + 3])
}

fn push(shown: &mut String, c: char) {
    if obeyed_or_unseen(c) {
        // Writing to a string does not fail.
        let _ = write!(shown, "{}", c.escape_unicode());
    } else {
        shown.push(c);
    }
}

fn obeyed_or_unseen(c: char) -> bool {
    c.is_control()
        || matches!(
            c,
            '\u{ad}' | '\u{61c}' | '\u{180e}' | '\u{200b}'..='\u{200f}' | '\u{2028}'..='\u{202e}'
                | '\u{2060}'..='\u{206f}' | '\u{feff}' | '\u{fff9}'..='\u{fffb}' | '\u{e0000}'..='\u{e007f}'
        )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_is_obeyed() {
        assert_eq!(visible("U4 é α ∞ “x”"), "U4 é α ∞ “x”");
        assert_eq!(visible("a\u{1b}[31mb\nc"), "a\\u{1b}[31mb\\u{a}c");
        for c in
            ['\u{0}', '\r', '\u{7f}', '\u{9b}', '\u{202e}', '\u{2066}', '\u{200b}', '\u{feff}', '\u{2028}']
        {
            assert_eq!(visible(&c.to_string()), c.escape_unicode().to_string());
            assert_eq!(visible_lines(&c.to_string()), c.escape_unicode().to_string());
        }
    }

    #[test]
    fn json_says_the_same() {
        let text = "a\u{1b}\u{9b}\u{202e}\u{e0041}\u{7f} é";
        let json = visible_json(&serde_json::to_string_pretty(&[text]).unwrap());
        assert!(!json.chars().any(|c| c != '\n' && obeyed_or_unseen(c)), "{json}");
        assert_eq!(crate::json::read::<Vec<String>>(&json), Ok(vec![text.to_owned()]));
    }

    #[test]
    fn a_result_keeps_its_lines_and_styles() {
        let own = "\u{1b}[1mValues\u{1b}[0m\n\tx \u{1b}[38;5;9mred\u{1b}[m";
        assert_eq!(visible_lines(own), own);
        assert_eq!(visible_lines("\u{1b}[2J\u{1b}]0;t\u{7}"), "\\u{1b}[2J\\u{1b}]0;t\\u{7}");
        assert_eq!(visible_lines("\u{1b}["), "\\u{1b}[");
    }
}
