//! Instance files.

use std::fs::File;
use std::io::{self, Read};
use std::path::Path;

use schemars::JsonSchema;
use serde::Deserialize;

use super::error::CliError;
use super::exact::{Exact, Indices};

/// An instance for knotproof: a degree on a knot vector, with indices and control points if there are any.
#[derive(Debug, Clone, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "knotproof instance")]
pub(super) struct InstanceFile {
    /// The degree k of the basis functions.
    pub(super) degree: usize,
    /// The knots t_0 ≤ t_1 ≤ … ≤ t_m, of any multiplicity; at least max(2k, k + 1) + 1 of them.
    pub(super) knots: Vec<Exact>,
    /// The index α, or several; `--alpha` replaces them.
    #[serde(default)]
    pub(super) alpha: Option<Indices>,
    /// The control points d_0, …, d_n of a curve, n = m − k − 1: each a list of 1 to 3 coordinates.
    #[serde(default)]
    pub(super) points: Option<Vec<Vec<Exact>>>,
}

/// The most that is read of a file: so a device or a film given by mistake does no harm.
const LENGTH_LIMIT: u64 = 16 * 1024 * 1024;

impl InstanceFile {
    /// Reads and parses the file.
    ///
    /// # Errors
    /// [`CliError::File`] or, with line and column, [`CliError::Malformed`].
    pub(super) fn read(path: &Path) -> Result<Self, CliError> {
        let text = read("--instance", path)?;
        let malformed = |error| CliError::Malformed { path: path.to_owned(), error };
        if let Some(("", list)) = text.split_once('[').map(|(before, list)| (before.trim(), list)) {
            // A list of fields without names would be taken for them, in their order.
            let before = &text[..text.len() - list.len()];
            let (line, column) =
                (before.lines().count(), before.lines().last().map_or(0, |l| l.chars().count()));
            let message = "expected an object with named fields, and found a list";
            return Err(malformed(serde::de::Error::custom(format!(
                "{message} at line {line} column {column}"
            ))));
        }
        serde_json::from_str(&text).map_err(malformed)
    }
}

/// The text of the file that the option names, without a byte order mark.
///
/// # Errors
/// [`CliError::File`], also if it is too long or no text.
pub(super) fn read(argument: &'static str, path: &Path) -> Result<String, CliError> {
    read_up_to(LENGTH_LIMIT, argument, path)
}

/// [`read`] with a limit of its own.
///
/// # Errors
/// [`CliError::File`], also if it is too long or no text.
pub(super) fn read_up_to(limit: u64, argument: &'static str, path: &Path) -> Result<String, CliError> {
    let failed = |error| CliError::File { argument, action: "read", path: path.to_owned(), error };
    let mut bytes = Vec::new();
    let file = File::open(path).map_err(failed)?;
    file.take(limit + 1).read_to_end(&mut bytes).map_err(failed)?;
    let invalid = |message: String| failed(io::Error::new(io::ErrorKind::InvalidData, message));
    if bytes.len() as u64 > limit {
        return Err(invalid(format!("it is longer than {limit} bytes, which no such file needs")));
    }
    let text = String::from_utf8(bytes)
        .map_err(|error| invalid(format!("byte {} is not UTF-8 text", error.utf8_error().valid_up_to())))?;
    Ok(text.strip_prefix('\u{feff}').map_or(text.clone(), str::to_owned))
}
