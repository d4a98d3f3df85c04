//! JSON that users write: read in one place, with errors in the user's words.
//!
//! What a text says of a number is taken from the text itself (`serde_json`'s raw values), never by way of a type that
//! stands for "any value": such a type has keys of its own that turn an object into a number.

use num_rational::BigRational;
use serde::de::{DeserializeOwned, Error as _};
use serde::{Deserialize, Deserializer};
use serde_json::value::RawValue;
use thiserror::Error;

use crate::scalar::parse_rational;

/// Why a text is not the JSON that is wanted.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[error("{message} at line {line} column {column}")]
pub struct JsonError {
    message: String,
    line: usize,
    column: usize,
}

impl JsonError {
    /// What is wrong, without the place.
    #[must_use]
    pub fn message(&self) -> &str {
        &self.message
    }

    /// The column, from 1.
    #[must_use]
    pub fn column(&self) -> usize {
        self.column
    }
}

impl From<serde_json::Error> for JsonError {
    fn from(error: serde_json::Error) -> Self {
        let (line, column) = (error.line(), error.column());
        let text = error.to_string();
        let message = text.strip_suffix(&format!(" at line {line} column {column}")).unwrap_or(&text);
        Self { message: in_words(message), line, column }
    }
}

/// Reads a text as JSON.
///
/// # Errors
/// [`JsonError`], with line and column.
pub fn read<T: DeserializeOwned>(text: &str) -> Result<T, JsonError> {
    Ok(serde_json::from_str(text)?)
}

/// An exact number: a JSON number, which counts with all its digits (0.4 is 2/5), or a string that holds one.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Number(pub BigRational);

impl<'de> Deserialize<'de> for Number {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let text = number_text(&raw(deserializer)?).map_err(D::Error::custom)?;
        parse_rational(&text).map(Self).map_err(D::Error::custom)
    }
}

/// The text of a value: whatever is in it, an object stays an object.
pub(crate) fn raw<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Box<RawValue>, D::Error> {
    Box::deserialize(deserializer)
}

/// The text of a JSON number, or of a string that should hold one.
pub(crate) fn number_text(value: &RawValue) -> Result<String, String> {
    let text = value.get();
    match text.as_bytes() {
        _ if is_number(text) => Ok(text.to_owned()),
        [b'"', ..] => read(text).map_err(|error| error.message().to_owned()),
        _ => Err(format!("expected a number or a string with a number, and found {}", kind(text))),
    }
}

/// Does the text of a value begin like a number?
pub(crate) fn is_number(text: &str) -> bool {
    text.starts_with(|c: char| c == '-' || c.is_ascii_digit())
}

/// What a text of a value is, in words.
pub(crate) fn kind(text: &str) -> &'static str {
    match text.as_bytes().first() {
        Some(b'n') => "null",
        Some(b't' | b'f') => "a truth value",
        Some(b'"') => "a string",
        Some(b'[') => "a list",
        Some(b'{') => "an object",
        _ => "a number",
    }
}

/// Serde names types of the program; a user knows those of JSON.
fn in_words(message: &str) -> String {
    if let Some((kind, rest)) = message.split_once(", expected ") {
        for prefix in ["invalid type: ", "invalid value: "] {
            if let Some(found) = kind.strip_prefix(prefix) {
                return format!("expected {}, and found {}", wanted(rest), there(found));
            }
        }
        if let Some(length) = kind.strip_prefix("invalid length ") {
            return format!("expected {}, and found {length} entries", wanted(rest));
        }
        if let Some(name) = kind.strip_prefix("unknown variant ") {
            return format!("unknown value {name}, expected {rest}");
        }
    }
    match message.strip_prefix("EOF while parsing ") {
        Some(what) => format!("the text ends within {what}"),
        None => message.to_owned(),
    }
}

fn wanted(type_name: &str) -> &str {
    match type_name {
        "usize" | "u8" | "u16" | "u32" | "u64" | "u128" => "a whole number from 0 up",
        "isize" | "i8" | "i16" | "i32" | "i64" | "i128" => "a whole number",
        "f32" | "f64" => "a number",
        "a boolean" => "true or false",
        "a sequence" => "a list",
        "a map" => "an object",
        "string or map" => "a string",
        name if name.starts_with("struct ") || name.starts_with("enum ") => "an object",
        name if name.starts_with("tuple ") || name.starts_with("a tuple ") => "a list",
        name if name.ends_with(" identifier") => "a name",
        other => other,
    }
}

fn there(value: &str) -> String {
    let quoted = |rest: &str| rest.trim_matches('`').to_owned();
    match value {
        "map" => "an object".to_owned(),
        "sequence" => "a list".to_owned(),
        "unit value" | "Option value" => "null".to_owned(),
        "newtype struct" | "enum" => "a value".to_owned(),
        _ => ["integer ", "floating point ", "number ", "boolean "]
            .iter()
            .find_map(|kind| value.strip_prefix(kind))
            .map_or_else(|| value.to_owned(), quoted),
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use serde::Deserialize;

    use super::*;

    #[derive(Debug, Deserialize)]
    #[serde(deny_unknown_fields, rename_all = "lowercase")]
    #[expect(dead_code, reason = "only their errors are looked at")]
    enum Choice {
        Left,
        Pair(u8, i64),
    }

    #[derive(Debug, Deserialize)]
    #[serde(deny_unknown_fields)]
    #[expect(dead_code, reason = "only their errors are looked at")]
    struct Everything {
        natural: Option<usize>,
        integer: Option<i64>,
        float: Option<f64>,
        truth: Option<bool>,
        list: Option<Vec<u32>>,
        pair: Option<(u64, u64)>,
        map: Option<BTreeMap<String, u16>>,
        text: Option<String>,
        choice: Option<Choice>,
        inner: Option<Box<Everything>>,
    }

    /// Words that a user of JSON need not know.
    const FOREIGN: [&str; 16] = [
        "usize",
        "isize",
        "u8",
        "u16",
        "u32",
        "u64",
        "i64",
        "f64",
        "struct",
        "enum",
        "tuple",
        "variant",
        "sequence",
        "floating point",
        "Option",
        "EOF",
    ];

    /// Every kind of value in the place of every other.
    #[test]
    fn messages_are_in_the_words_of_json() {
        let fields =
            ["natural", "integer", "float", "truth", "list", "pair", "map", "text", "choice", "inner"];
        let values = [
            "1.5",
            "-1",
            "1e99",
            "18446744073709551616",
            "true",
            "null",
            "\"a\"",
            "[]",
            "[1]",
            "[\"a\"]",
            "[1,2,3]",
            "{}",
            "{\"a\":null}",
            "{\"up\":1}",
            "{\"pair\":[300,1]}",
            "[[1",
            "\"",
            "tru",
            "",
        ];
        let mut refused = 0;
        for field in fields {
            for value in values {
                for text in [format!("{{\"{field}\":{value}}}"), format!("{{\"{field}\":{value}")] {
                    let Err(error) = read::<Everything>(&text) else { continue };
                    refused += 1;
                    let message = error.to_string();
                    for word in FOREIGN {
                        assert!(
                            !message.split(' ').any(|part| part.trim_matches([',', ':']) == word),
                            "{text}: {message}"
                        );
                        assert!(!word.contains(' ') || !message.contains(word), "{text}: {message}");
                    }
                    assert!(message.contains(" at line 1 column "), "{message}");
                }
            }
        }
        assert!(refused > 250, "{refused}");
        for text in ["[]", "1", "null", "\"x\"", "{\"other\":1}"] {
            let message = read::<Everything>(text).unwrap_err().to_string();
            assert!(!message.contains("struct") && !message.contains("Everything"), "{message}");
        }
        let message = |text: &str| read::<Everything>(text).unwrap_err().message().to_owned();
        assert_eq!(message("{\"natural\":1.5}"), "expected a whole number from 0 up, and found 1.5");
        assert_eq!(message("{\"list\":{}}"), "expected a list, and found an object");
        assert_eq!(message("{\"choice\":\"up\"}"), "unknown value `up`, expected `left` or `pair`");
    }
}
