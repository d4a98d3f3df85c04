//! One line of a file of points, as CSV or as JSON.

use std::path::Path;

use num_rational::BigRational;
use serde::Deserialize;

use crate::json;
use crate::scalar::parse_rational;

use super::super::exact::Exact;
use super::super::point_error::{PointError, shortened};
use super::OneSide;

/// A point of a file.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct FilePoint {
    pub(super) x: BigRational,
    /// `None` if the line does not say.
    pub(super) side: Option<OneSide>,
}

/// How points are written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Syntax {
    /// x, or x and a side.
    Csv,
    /// A JSON value on each line.
    JsonLines,
}

impl Syntax {
    /// The form that the name of a file promises, if any.
    pub(super) fn of_file(path: &Path) -> Option<Self> {
        match path.extension()?.to_ascii_lowercase().to_str()? {
            "csv" | "txt" => Some(Self::Csv),
            "jsonl" | "ndjson" => Some(Self::JsonLines),
            _ => None,
        }
    }

    /// The form that a first line has: JSON if it begins with a brace or a bracket. Numbers and strings are read
    /// alike in both.
    pub(super) fn of_line(line: &str) -> Self {
        if line.starts_with(['{', '[']) { Self::JsonLines } else { Self::Csv }
    }
}

/// Is the line what `eval` writes before the points of an answer?
pub(super) fn is_head(line: &str) -> bool {
    #[derive(Deserialize)]
    struct Head {
        schema: String,
    }
    json::read(line).is_ok_and(|Head { schema }| schema == super::SCHEMA)
}

/// Reads a line of JSON without white space before it: a number, a string with one, or an object. Of a line of an answer
/// only the point counts.
///
/// # Errors
/// [`PointError::Json`].
pub(super) fn from_json(line: &str, answer: bool) -> Result<FilePoint, PointError> {
    #[derive(Deserialize)]
    #[serde(deny_unknown_fields)]
    struct Point {
        x: Exact,
        side: Option<OneSide>,
    }
    #[derive(Deserialize)]
    struct Answer {
        x: Exact,
        side: OneSide,
    }

    let point = if !line.starts_with('{') {
        json::read(line).map(|Exact(x)| FilePoint { x, side: None })
    } else if answer {
        json::read(line).map(|Answer { x: Exact(x), side }| FilePoint { x, side: Some(side) })
    } else {
        json::read(line).map(|Point { x: Exact(x), side }| FilePoint { x, side })
    };
    // The line of the file is known better than the line in its text.
    point.map_err(|error| PointError::Json { message: shortened(&error.message()), column: error.column() })
}

/// Reads lines of CSV. A line is a record, so an open quotation mark costs one line and not the rest of the file.
#[derive(Debug)]
pub(super) struct CsvLines {
    parser: csv_core::Reader,
    fields: Vec<u8>,
    ends: Vec<usize>,
    /// The columns that a header has promised; without one there are at most two.
    promised: Option<usize>,
}

impl CsvLines {
    /// A reader that has read nothing.
    pub(super) fn new() -> Self {
        // Not `default()`: that one has no tables, and takes every line for an empty one.
        Self { parser: csv_core::Reader::new(), fields: Vec::new(), ends: Vec::new(), promised: None }
    }

    /// The point of a line.
    ///
    /// # Errors
    /// [`PointError`].
    pub(super) fn point(&mut self, line: &str) -> Result<FilePoint, PointError> {
        let (most, promised) = (self.promised.unwrap_or(2), self.promised);
        let (x, side, count) = self.columns(line, most).map_err(|error| match (error, promised) {
            (PointError::Columns, Some(expected)) => PointError::Header { expected },
            (error, _) => error,
        })?;
        if let Some(expected) = promised.filter(|expected| *expected != count) {
            return Err(PointError::Header { expected });
        }
        let side = match side.map(str::trim) {
            None | Some("") => None,
            Some("left") => Some(OneSide::Left),
            Some("right") => Some(OneSide::Right),
            Some(other) => return Err(PointError::Side(other.to_owned())),
        };
        Ok(FilePoint { x: parse_rational(x).map_err(PointError::Number)?, side })
    }

    /// Is the line a header: `x`, or `x,side`, or that of an answer, which begins with `x,side,G_`? Of the other columns
    /// of an answer there have to be as many in each line.
    pub(super) fn is_header(&mut self, line: &str) -> bool {
        let columns = self.columns(line, line.len() + 1);
        let columns = columns.map(|(x, side, count)| (x.trim(), side.map(str::trim), count));
        match columns {
            Ok(("x", None | Some("side"), 1 | 2)) => true,
            Ok(("x", Some("side"), count)) if line.starts_with("x,side,G_") => {
                self.promised = Some(count);
                true
            }
            _ => false,
        }
    }

    /// The first two columns of a line, or the one, and how many there are: up to `most`.
    fn columns(&mut self, line: &str, most: usize) -> Result<(&str, Option<&str>, usize), PointError> {
        if line.bytes().filter(|&byte| byte == b'"').count() % 2 == 1 {
            return Err(PointError::Quote);
        }
        self.parser.reset();
        // Unquoting makes nothing longer, and to the parser a buffer that is just long enough is full.
        self.fields.resize(line.len() + 1, 0);
        self.ends.resize(most, 0);
        let ends = &mut self.ends;
        let (mut read, mut written, mut columns) = (0, 0, 0);
        loop {
            // The parser knows the end of a record by the end of the input, and that by an empty piece.
            let (result, consumed, copied, ended) = self.parser.read_record(
                &line.as_bytes()[read..],
                &mut self.fields[written..],
                &mut ends[columns..],
            );
            (read, written, columns) = (read + consumed, written + copied, columns + ended);
            match result {
                csv_core::ReadRecordResult::InputEmpty => {}
                csv_core::ReadRecordResult::OutputFull | csv_core::ReadRecordResult::OutputEndsFull => {
                    return Err(PointError::Columns);
                }
                csv_core::ReadRecordResult::Record | csv_core::ReadRecordResult::End => break,
            }
        }
        if read < line.len() {
            return Err(PointError::CarriageReturn);
        }
        let field = |from: usize, to: usize| {
            let bytes = self.fields.get(from..to).unwrap_or_default();
            // Fields of UTF-8 text are UTF-8 text: they are cut at ASCII characters only.
            std::str::from_utf8(bytes).map_err(|error| PointError::Encoding(error.valid_up_to()))
        };
        let second = (columns >= 2).then(|| field(ends[0], ends[1])).transpose()?;
        Ok((field(0, ends[0])?, second, columns))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::{NumberError, integer, rational};

    fn csv(line: &str) -> Result<FilePoint, PointError> {
        CsvLines::new().point(line)
    }

    fn point(x: BigRational, side: Option<OneSide>) -> FilePoint {
        FilePoint { x, side }
    }

    #[test]
    fn lines_of_csv() {
        let third = || rational(1, 3);
        for line in ["1/3", " 1/3 ", "\"1/3\"", "1/3,", "1/3, ", "1/3\t,\"\""] {
            assert_eq!(csv(line).unwrap(), point(third(), None), "{line}");
        }
        for line in ["1/3,left", "\"1/3\",\"left\"", " 1/3 , left "] {
            assert_eq!(csv(line).unwrap(), point(third(), Some(OneSide::Left)), "{line}");
        }
        assert_eq!(csv("-2e-1,right").unwrap(), point(rational(-1, 5), Some(OneSide::Right)));
    }

    #[test]
    fn one_reader_reads_many_lines() {
        let mut lines = CsvLines::new();
        for (line, x) in [("1,left", 1), ("23456789", 23_456_789), ("2,", 2), ("\"3\"", 3)] {
            assert_eq!(lines.point(line).unwrap().x, integer(x), "{line}");
        }
        assert!(lines.point("\"4").is_err() && lines.point("4\r5").is_err() && lines.point("4,,").is_err());
        assert_eq!(lines.point("4").unwrap().x, integer(4), "an error leaves nothing behind");
    }

    #[test]
    fn lines_of_csv_that_are_no_points() {
        assert!(matches!(csv("1,left,").unwrap_err(), PointError::Columns));
        assert!(matches!(csv("1,2,3,4").unwrap_err(), PointError::Columns));
        assert!(matches!(csv("0,4").unwrap_err(), PointError::Side(side) if side == "4"));
        assert!(matches!(csv("1,LEFT").unwrap_err(), PointError::Side(_)));
        assert!(matches!(csv("\"1").unwrap_err(), PointError::Quote));
        assert!(matches!(csv("1\r2").unwrap_err(), PointError::CarriageReturn));
        assert!(matches!(csv(",left").unwrap_err(), PointError::Number(NumberError::Empty)));
        assert!(matches!(csv("nan").unwrap_err(), PointError::Number(NumberError::NotFinite(_))));
    }

    #[test]
    fn a_header_names_the_columns() {
        for line in ["x", " x ", "\"x\"", "x,side", "x, side"] {
            assert!(CsvLines::new().is_header(line), "{line}");
        }
        for line in ["1", "y", "side,x", "x,y", "x,side,", "x,side,y", "xx", "\"x"] {
            assert!(!CsvLines::new().is_header(line), "{line}");
        }
    }

    #[test]
    fn an_answer_is_a_file_of_points() {
        let mut lines = CsvLines::new();
        assert!(lines.is_header("x,side,G_0,G_1,curve_0"));
        assert_eq!(lines.point("1/3,left,1,0,1/2").unwrap(), point(rational(1, 3), Some(OneSide::Left)));
        for line in ["1/3,left,1,0", "1/3,left,1,0,1/2,5", "1/3"] {
            assert!(matches!(lines.point(line).unwrap_err(), PointError::Header { expected: 5 }), "{line}");
        }
        assert!(is_head(r#"{"schema":"knotproof.eval/1","degree":1}"#));
        assert!(!is_head(r#"{"schema":"knotproof.shape/1"}"#) && !is_head(r#"{"x":1}"#) && !is_head("1"));
        let answer = from_json(r#"{"x":"1/3","side":"left","values":["1"]}"#, true).unwrap();
        assert_eq!(answer, point(rational(1, 3), Some(OneSide::Left)));
        assert!(from_json(r#"{"x":"1/3","side":"left","values":["1"]}"#, false).is_err());
    }

    #[test]
    fn lines_of_json() {
        let third = || rational(1, 3);
        assert_eq!(from_json("0.1", false).unwrap(), point(rational(1, 10), None));
        assert_eq!(from_json("\"1/3\"", false).unwrap(), point(third(), None));
        assert_eq!(from_json(r#"{"x": "1/3"}"#, false).unwrap(), point(third(), None));
        assert_eq!(
            from_json(r#"{"side": "left", "x": "1/3"}"#, false).unwrap(),
            point(third(), Some(OneSide::Left))
        );
        for (line, part) in [
            ("1/3", "trailing characters, at column 2"),
            ("NaN", "expected value, at column 1"),
            ("\"nan\"", "`nan` is not a finite number"),
            ("[1]", "found a list"),
            ("null", "found null"),
            (r#"{"side": "left"}"#, "missing field `x`"),
            (r#"{"x": 1, "x": 2}"#, "duplicate field `x`"),
            (r#"{"x": 1, "y": 2}"#, "unknown field `y`"),
            (r#"{"x": 1, "side": "up"}"#, "unknown value `up`"),
            (r#"{"x": 1} 2"#, "trailing characters"),
        ] {
            let message = from_json(line, false).unwrap_err().to_string();
            assert!(message.contains(part) && !message.contains("at line"), "{line}: {message}");
        }
    }

    #[test]
    fn messages_stay_short() {
        let message = csv(&"7a".repeat(10_000)).unwrap_err().to_string();
        assert!(message.chars().count() < 250, "{message}");
        assert!(message.starts_with("`7a7a") && message.contains('…') && message.ends_with("0x1.8p-3"));
    }
}
