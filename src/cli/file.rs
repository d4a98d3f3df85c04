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

/// The most that is read of an instance file: so a device or a film given by mistake does no harm.
const LENGTH_LIMIT: u64 = 16 * 1024 * 1024;

impl InstanceFile {
    /// Reads and parses the file.
    ///
    /// # Errors
    /// [`CliError::Unreadable`], [`CliError::TooLong`] or, with line and column, [`CliError::Malformed`].
    pub(super) fn read(path: &Path) -> Result<Self, CliError> {
        let text = read(path).map_err(|error| CliError::Unreadable { path: path.to_owned(), error })?;
        let Some(text) = text else {
            return Err(CliError::TooLong { path: path.to_owned(), limit: LENGTH_LIMIT });
        };
        serde_json::from_str(&text).map_err(|error| CliError::Malformed { path: path.to_owned(), error })
    }
}

/// The text of the file; `None` if it is too long.
fn read(path: &Path) -> io::Result<Option<String>> {
    let mut bytes = Vec::new();
    File::open(path)?.take(LENGTH_LIMIT + 1).read_to_end(&mut bytes)?;
    if bytes.len() as u64 > LENGTH_LIMIT {
        return Ok(None);
    }
    let text = String::from_utf8(bytes).map_err(|error| {
        let at = error.utf8_error().valid_up_to();
        io::Error::new(io::ErrorKind::InvalidData, format!("byte {at} is not UTF-8 text"))
    })?;
    Ok(Some(text))
}
