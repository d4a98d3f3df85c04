//! The points of a file or of standard input, one after the other, in constant memory.

use std::fs::File;
use std::io::{self, BufRead, BufReader, Read};
use std::path::{Path, PathBuf};

use super::super::error::CliError;
use super::super::point_error::PointError;
use super::line::{CsvLines, FilePoint, Syntax, from_json, is_head};

/// The longest line that is read: a number of so many digits is the largest that makes sense, and a device or a
/// film given by mistake does no harm.
const LINE_LIMIT: usize = 64 * 1024;
/// The same for a line of an answer, which has the values of all functions as well.
const ANSWER_LIMIT: usize = 16 * 1024 * 1024;

/// Points as they are read.
pub(super) struct PointFile {
    /// What messages call it.
    name: PathBuf,
    input: BufReader<Box<dyn Read>>,
    /// `None` until a line has told.
    form: Option<Syntax>,
    csv: CsvLines,
    line: Vec<u8>,
    /// The number of the line, from 1.
    number: u64,
    /// Has there been a line that counts: a header or a point?
    begun: bool,
    /// Is it what `eval` has answered to another file of points?
    answer: bool,
    points: u64,
    /// Bytes read, and how many there are if that is known.
    read: u64,
    length: Option<u64>,
}

impl PointFile {
    /// The points of the file, or of standard input for `-`.
    ///
    /// # Errors
    /// [`CliError::File`].
    pub(super) fn open(path: &Path) -> Result<Self, CliError> {
        let standard_input = path == Path::new("-");
        let name = if standard_input { PathBuf::from("standard input") } else { path.to_owned() };
        let (input, length): (Box<dyn Read>, _) = if standard_input {
            (Box::new(io::stdin().lock()), None)
        } else {
            let failed = |error| unreadable(&name, error);
            let file = File::open(path).map_err(failed)?;
            let about = file.metadata().map_err(failed)?;
            (Box::new(file), about.is_file().then_some(about.len()))
        };
        Ok(Self {
            name,
            input: BufReader::new(input),
            form: Syntax::of_file(path),
            csv: CsvLines::new(),
            line: Vec::new(),
            number: 0,
            begun: false,
            answer: false,
            points: 0,
            read: 0,
            length,
        })
    }

    /// The next point; `None` at the end.
    ///
    /// # Errors
    /// [`CliError::Points`] for a line that is no point, [`CliError::NoPoint`] at the end of a file without any,
    /// and [`CliError::File`].
    pub(super) fn next(&mut self) -> Result<Option<FilePoint>, CliError> {
        while self.next_line().map_err(|error| unreadable(&self.name, error))? {
            match self.point() {
                Ok(None) => {}
                Ok(point) => {
                    self.points += 1;
                    return Ok(point);
                }
                Err(error) => {
                    let name = self.name.display().to_string();
                    return Err(CliError::Points { name, line: self.number, error });
                }
            }
        }
        if self.points == 0 {
            return Err(CliError::NoPoint { name: self.name.display().to_string() });
        }
        Ok(None)
    }

    /// How many points have been read.
    pub(super) fn points(&self) -> u64 {
        self.points
    }

    /// How many bytes have been read.
    pub(super) fn read(&self) -> u64 {
        self.read
    }

    /// How many bytes there are, of a regular file.
    pub(super) fn length(&self) -> Option<u64> {
        self.length
    }

    /// Will the next line perhaps have to be waited for?
    pub(super) fn may_block(&self) -> bool {
        self.input.buffer().is_empty()
    }

    /// Reads a line, with a byte more than the limit at most; `false` at the end.
    fn next_line(&mut self) -> io::Result<bool> {
        self.line.clear();
        let limit = u64::try_from(ANSWER_LIMIT + 1).unwrap_or(u64::MAX);
        let count = self.input.by_ref().take(limit).read_until(b'\n', &mut self.line)?;
        self.read += u64::try_from(count).unwrap_or(0);
        self.number += 1;
        Ok(count > 0)
    }

    /// The point of the line, if it has one.
    fn point(&mut self) -> Result<Option<FilePoint>, PointError> {
        let line = text(&self.line, self.number == 1)?;
        if line.is_empty() {
            return Ok(None);
        }
        let form = *self.form.get_or_insert(Syntax::of_line(line));
        if form == Syntax::Csv && line.starts_with('#') {
            return Ok(None);
        }
        let first = !std::mem::replace(&mut self.begun, true);
        let header = first
            && match form {
                Syntax::JsonLines => is_head(line),
                Syntax::Csv => self.csv.is_header(line),
            };
        self.answer |= header;
        if header {
            return Ok(None);
        }
        if !self.answer && line.len() > LINE_LIMIT {
            return Err(PointError::TooLong(LINE_LIMIT));
        }
        let point = match form {
            Syntax::JsonLines => from_json(line, self.answer)?,
            Syntax::Csv => self.csv.point(line)?,
        };
        Ok(Some(point))
    }
}

fn unreadable(name: &Path, error: io::Error) -> CliError {
    CliError::File { argument: "--points-file", action: "read", path: name.to_owned(), error }
}

/// The text of a line without white space around it, and of the first one without a byte order mark.
fn text(line: &[u8], first: bool) -> Result<&str, PointError> {
    if line.len() > ANSWER_LIMIT {
        return Err(PointError::TooLong(ANSWER_LIMIT));
    }
    if let Some(position) = line.iter().position(|&byte| byte == 0) {
        return Err(PointError::Nul(position + 1));
    }
    let text = std::str::from_utf8(line).map_err(|error| PointError::Encoding(error.valid_up_to() + 1))?;
    Ok(if first { text.strip_prefix('\u{feff}').unwrap_or(text) } else { text }.trim())
}
