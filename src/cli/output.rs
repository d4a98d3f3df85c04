//! Results to standard output, errors to standard error, as text or as JSON.

use std::borrow::Cow;
use std::fmt;
use std::io::{self, BufWriter, Write};
use std::panic::PanicHookInfo;

use anstyle::{AnsiColor, Style};
use clap::ValueEnum;
use schemars::{JsonSchema, Schema, SchemaGenerator};
use serde::Serialize;
use serde_json::{Value, json};

use crate::language::{Complaint, Paper, PaperNumber};

use super::error::CliError;
use super::notation::Notation;
use super::visible::{visible, visible_json, visible_lines};

/// How results and errors are written.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, ValueEnum)]
pub enum Format {
    /// For people.
    #[default]
    Text,
    /// For scripts: one object, with a `schema` field; numbers as strings in lowest terms.
    Json,
}

/// Where a command writes to.
///
/// Colour is taken out where the stream is no terminal and where `NO_COLOR` asks for it. A reader that closes
/// the pipe has seen enough: that is no error.
#[derive(Debug, Clone, Copy)]
pub struct Output {
    format: Format,
    notation: Notation,
    closed: bool,
}

/// A result with what made it.
#[derive(Serialize)]
pub(super) struct Stamped<T> {
    #[serde(flatten)]
    result: T,
    version: &'static str,
}

/// A result that says something of a paper, with its number.
#[derive(Serialize)]
pub(super) struct OfPaper<T> {
    #[serde(flatten)]
    result: T,
    paper: PaperNumber,
}

impl<T> Stamped<T> {
    /// By this version.
    pub(super) fn new(result: T) -> Self {
        Self { result, version: env!("CARGO_PKG_VERSION") }
    }
}

impl<T> OfPaper<T> {
    /// Of that paper.
    pub(super) fn new(paper: &Paper, result: T) -> Self {
        Self { result, paper: (&paper.about).into() }
    }
}

impl<T: fmt::Display> fmt::Display for OfPaper<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.result.fmt(f)
    }
}

impl<T: JsonSchema> JsonSchema for Stamped<T> {
    fn inline_schema() -> bool {
        true
    }
    fn schema_name() -> Cow<'static, str> {
        T::schema_name()
    }
    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let version = json!({ "description": "The version of the program.", "type": "string" });
        with_key(T::json_schema(generator), "version", version)
    }
}

impl<T: JsonSchema> JsonSchema for OfPaper<T> {
    fn inline_schema() -> bool {
        true
    }
    fn schema_name() -> Cow<'static, str> {
        T::schema_name()
    }
    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let mut paper = generator.subschema_for::<PaperNumber>();
        paper.insert("description".to_owned(), "The paper that it is about.".into());
        with_key(T::json_schema(generator), "paper", paper.into())
    }
}

/// A result as JSON: what is printed, and what is written into files.
///
/// # Errors
/// [`CliError::Output`], if it can't be written as JSON.
pub(super) fn stamped_json<T: Serialize>(result: &T) -> Result<String, CliError> {
    let text = serde_json::to_string_pretty(&Stamped::new(result)).map_err(io::Error::from)?;
    Ok(visible_json(&text))
}

/// JSON for a file that is no result.
///
/// # Errors
/// [`CliError::Output`], if it can't be written as JSON.
pub(super) fn pretty_json(value: &impl Serialize) -> Result<String, CliError> {
    Ok(serde_json::to_string_pretty(value).map_err(io::Error::from)? + "\n")
}

/// The schema of an object with one key more.
fn with_key(mut object: Schema, name: &str, of: Value) -> Schema {
    let object_fields = object.ensure_object();
    let properties = object_fields.entry("properties").or_insert_with(|| json!({}));
    if let Some(properties) = properties.as_object_mut() {
        properties.insert(name.to_owned(), of);
    }
    let required = object_fields.entry("required").or_insert_with(|| json!([]));
    if let Some(required) = required.as_array_mut() {
        required.push(name.into());
    }
    object
}

/// An error under `--format json`, on standard error.
#[derive(Serialize, JsonSchema)]
pub(super) struct ErrorReport<'a> {
    /// What this object is: `knotproof.error/1`.
    #[schemars(extend("const" = "knotproof.error/1"))]
    schema: &'static str,
    /// What is wrong.
    error: ErrorBody<'a>,
}

/// What is wrong with a request.
#[derive(Serialize, JsonSchema)]
struct ErrorBody<'a> {
    /// One line that says what, where, and what to do.
    message: &'a str,
    /// The option to blame, if there is one.
    #[serde(skip_serializing_if = "Option::is_none")]
    argument: Option<&'a str>,
    /// All that is wrong with a text in the claim language.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    complaints: Vec<Place<'a>>,
}

/// One thing that is wrong with a text.
#[derive(Serialize, JsonSchema)]
struct Place<'a> {
    /// The file, or `sentence`.
    source: &'a str,
    /// Its line, from 1.
    line: usize,
    /// The character of the line, from 1.
    column: usize,
    /// Which rule it breaks.
    rule: &'a str,
    /// What to write instead.
    advice: &'a str,
}

impl<'a> From<&'a Complaint> for Place<'a> {
    fn from(complaint: &'a Complaint) -> Self {
        let (line, column) = complaint.place();
        let (source, rule, advice) = (complaint.source(), complaint.rule(), complaint.advice());
        Self { source, line, column, rule, advice }
    }
}

impl Output {
    /// Output in the given format.
    #[must_use]
    pub fn new(format: Format) -> Self {
        Self { format, notation: Notation::Exact, closed: false }
    }

    /// The same, with numbers in a notation.
    pub(super) fn in_notation(self, notation: Notation) -> Self {
        Self { notation, ..self }
    }

    /// The same to a standard output that was closed before the program began: no result can be written.
    #[must_use]
    pub fn without_stdout(self, closed: bool) -> Self {
        Self { closed, ..self }
    }

    /// The same in another format.
    #[must_use]
    pub(super) fn in_format(self, format: Format) -> Self {
        Self { format, ..self }
    }

    /// The format asked for.
    #[must_use]
    pub fn format(&self) -> Format {
        self.format
    }

    /// Writes a result: by its `Display` as text, by its `Serialize` as JSON.
    ///
    /// # Errors
    /// [`CliError::Output`] if standard output takes no more, for any reason but a closed pipe.
    pub fn result<T: fmt::Display + Serialize>(&self, result: &T) -> Result<(), CliError> {
        self.notation.during(|| match self.format {
            Format::Text => self.write(&visible_lines(&result.to_string())),
            Format::Json => self.write(&stamped_json(result)?),
        })
    }

    /// Writes a result that says something of a paper: in JSON, with its number.
    ///
    /// # Errors
    /// Those of [`result`](Self::result).
    pub(super) fn result_of<T: fmt::Display + Serialize>(
        &self,
        paper: &Paper,
        result: &T,
    ) -> Result<(), CliError> {
        self.result(&OfPaper::new(paper, result))
    }

    /// Writes a result that is JSON in either format.
    ///
    /// # Errors
    /// [`CliError::Output`] if standard output takes no more, for any reason but a closed pipe.
    pub fn json<T: Serialize>(&self, result: &T) -> Result<(), CliError> {
        self.write(&visible_json(&serde_json::to_string_pretty(result).map_err(io::Error::from)?))
    }

    /// Writes text as it is.
    ///
    /// # Errors
    /// [`CliError::Output`] if standard output takes no more, for any reason but a closed pipe.
    pub fn text(&self, text: &str) -> Result<(), CliError> {
        self.write(text)
    }

    /// Writes a result bit by bit, as `write` produces it. What it has written before an error stays written.
    ///
    /// # Errors
    /// Those of `write`, and [`CliError::Output`] if standard output takes no more, for any reason but a closed pipe.
    pub fn stream(&self, write: impl FnOnce(&mut dyn Write) -> Result<(), CliError>) -> Result<(), CliError> {
        self.check_open()?;
        let mut stdout = BufWriter::new(anstream::stdout().lock());
        let written = write(&mut stdout);
        let flushed = stdout.flush().map_err(CliError::from);
        match written.and(flushed) {
            Err(CliError::Output(error)) if error.kind() == io::ErrorKind::BrokenPipe => Ok(()),
            result => result,
        }
    }

    fn check_open(self) -> io::Result<()> {
        if self.closed { Err(io::Error::other("standard output is closed")) } else { Ok(()) }
    }

    fn write(self, text: &str) -> Result<(), CliError> {
        self.check_open()?;
        let mut stdout = anstream::stdout().lock();
        let written = writeln!(stdout, "{}", text.trim_end()).and_then(|()| stdout.flush());
        match written {
            Err(error) if error.kind() == io::ErrorKind::BrokenPipe => Ok(()),
            other => Ok(other?),
        }
    }

    /// Writes one error message to standard error, on one line and with nothing in it that a terminal obeys.
    pub fn error(&self, message: &str, argument: Option<&str>) {
        self.say(message, argument, None, &[]);
    }

    /// Warns of something in a result that is a file, on standard error, for people; a JSON result has it itself.
    pub(super) fn warning(&self, message: &str) {
        if self.format == Format::Text {
            let yellow = Style::new().bold().fg_color(Some(AnsiColor::Yellow.into()));
            // Nobody is left to be told that standard error is closed.
            let _ = writeln!(anstream::stderr(), "{yellow}warning:{yellow:#} {}", visible(message));
        }
    }

    /// Writes why a request was not carried out: for people with the lines of a text that the message points to.
    pub(super) fn refusal(&self, error: &CliError) {
        self.say(&error.to_string(), error.argument(), error.excerpt(), error.complaints());
    }

    fn say(&self, message: &str, argument: Option<&str>, excerpt: Option<String>, complaints: &[Complaint]) {
        let text = match self.format {
            Format::Text => {
                let message = visible(message);
                let red = Style::new().bold().fg_color(Some(AnsiColor::Red.into()));
                let excerpt = excerpt.map(|lines| format!("\n{}", visible_lines(&lines))).unwrap_or_default();
                format!("{red}error:{red:#} {message}{excerpt}")
            }
            Format::Json => {
                let complaints = complaints.iter().map(Place::from).collect();
                let error = ErrorBody { message, argument, complaints };
                let report = Stamped::new(ErrorReport { schema: "knotproof.error/1", error });
                // Strings always serialise; if not, the bare message is better than none.
                visible_json(&serde_json::to_string(&report).unwrap_or_else(|_| message.to_owned()))
            }
        };
        // Nobody is left to be told that standard error is closed.
        let _ = writeln!(anstream::stderr(), "{text}");
    }

    /// Writes what a panic says, on one line. Takes the place of the panic hook.
    pub(super) fn internal_error(&self, panic: &PanicHookInfo<'_>) {
        let payload = panic.payload();
        let text = payload.downcast_ref::<&str>().copied();
        let what = text.or_else(|| payload.downcast_ref::<String>().map(String::as_str));
        let what = what.unwrap_or("no message").replace('\n', " ");
        let place = panic.location().map(|at| format!(" at {}:{}", at.file(), at.line())).unwrap_or_default();
        let message = format!("internal error{place}: {what}; please report this bug with the command line");
        self.error(&message, None);
    }
}
