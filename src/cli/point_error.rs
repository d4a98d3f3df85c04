//! Why a line of a file is not a point.

use thiserror::Error;

use crate::scalar::NumberError;

/// Why a line is not a point.
#[derive(Debug, Error)]
pub enum PointError {
    /// Longer than any point needs.
    #[error("the line is longer than {0} bytes, which no point needs: write one point on each line")]
    TooLong(usize),
    /// Not UTF-8.
    #[error("byte {0} of the line is not UTF-8 text: write the file in UTF-8")]
    Encoding(usize),
    /// Binary data, or UTF-16.
    #[error("byte {0} of the line is NUL: write the file as UTF-8 text")]
    Nul(usize),
    /// x is not an exact number.
    #[error("{}", shortened(.0))]
    Number(NumberError),
    /// Neither `left` nor `right`.
    #[error("the side is `{}`: write left, right, or nothing", shortened(.0))]
    Side(String),
    /// More than x and side.
    #[error("there are more than two columns: write x, or x,side (a decimal number with a point: 0.4)")]
    Columns,
    /// Not as many columns as the header names.
    #[error("the header names {expected} columns, and here are not as many")]
    Header {
        /// The columns of the header.
        expected: usize,
    },
    /// A quotation mark without its partner.
    #[error("a quotation mark is not closed: a number needs none")]
    Quote,
    /// A carriage return inside the line, as in files of old Macintoshes.
    #[error("there is a carriage return inside the line: end each line with a line feed")]
    CarriageReturn,
    /// Not the JSON of a point.
    #[error(
        "{message}, at column {column}: write a number, a string with an exact number, or {{\"x\": \"1/3\", \"side\": \"left\"}}"
    )]
    Json {
        /// What is wrong.
        message: String,
        /// Where, from 1.
        column: usize,
    },
}

/// A line may be long, and a message should not be: its beginning and its end.
pub(super) fn shortened(text: &impl ToString) -> String {
    const PART: usize = 100;
    let text: Vec<char> = text.to_string().chars().collect();
    match (text.get(..PART), text.len().checked_sub(PART)) {
        (Some(start), Some(tail)) if tail > PART => start.iter().chain(&['…']).chain(&text[tail..]).collect(),
        _ => text.iter().collect(),
    }
}
