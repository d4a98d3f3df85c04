//! Instance files.

use std::fmt;
use std::fs::File;
use std::io::{self, Read};
use std::path::Path;

use schemars::JsonSchema;
use serde::de::{Error as _, IgnoredAny, MapAccess, Visitor};
use serde::{Deserialize, Deserializer};
use serde_json::value::RawValue;

use crate::json;

use super::error::CliError;
use super::exact::{Exact, Indices, Whole};

/// An instance for knotproof: a degree on a knot vector, with indices and control points if there are any.
///
/// A result of `knotproof eval`, `bezier`, `joins`, `solve`, `bounds`, `length`, `interpolate`, `insert`, `shape`, `check`, `formula` or
/// `search` is one too: its `schema` says that
/// it is a result, of which only these fields count, and the indices of its entries if it has none of its own.
#[derive(Debug, Clone, PartialEq, Eq, JsonSchema)]
#[schemars(
    title = "knotproof instance",
    extend("if" = { "properties": { "schema": { "pattern": RESULT_PATTERN } }, "required": ["schema"] }),
    extend("else" = { "propertyNames": { "enum": FIELDS } })
)]
pub(super) struct InstanceFile {
    /// The degree k of the basis functions.
    pub(super) degree: Whole,
    /// The knots t_0 ≤ t_1 ≤ … ≤ t_m, of any multiplicity; at least max(2k, k + 1) + 1 of them.
    pub(super) knots: Vec<Exact>,
    /// The index α, or several; `--alpha` replaces them.
    pub(super) alpha: Option<Indices>,
    /// The control points d_0, …, d_n of a curve, n = m − k − 1: each a list of 1 to 3 coordinates.
    pub(super) points: Option<Vec<Vec<Exact>>>,
}

/// The fields of an instance that is no result. `$schema` is for editors.
const FIELDS: [&str; 5] = ["$schema", "degree", "knots", "alpha", "points"];
/// What the `schema` of a result begins with.
const RESULT: &str = "knotproof.";
const RESULT_PATTERN: &str = "^knotproof\\.";

/// What is read of an entry of a result.
#[derive(Deserialize)]
struct Entry {
    alpha: Option<Box<RawValue>>,
}

impl<'de> Deserialize<'de> for InstanceFile {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_map(Fields)
    }
}

struct Fields;

impl<'de> Visitor<'de> for Fields {
    type Value = InstanceFile;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("an object with named fields")
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<InstanceFile, A::Error> {
        let (mut degree, mut knots, mut alpha, mut points) = (None, None, None, None);
        let mut seen: Vec<String> = Vec::new();
        let (mut result, mut entries) = (false, Vec::new());
        while let Some(name) = map.next_key::<String>()? {
            if seen.contains(&name) {
                return Err(A::Error::custom(format!("duplicate field `{name}`")));
            }
            match name.as_str() {
                "$schema" => drop(map.next_value::<String>()?),
                "schema" => result = map.next_value::<String>()?.starts_with(RESULT),
                "degree" => degree = Some(map.next_value()?),
                "knots" => knots = Some(map.next_value()?),
                "alpha" if result => alpha = index_of(map.next_value()?)?,
                "alpha" => alpha = map.next_value()?,
                "points" => points = map.next_value()?,
                "functions" | "properties" | "joins" | "curves" if result => {
                    entries = map.next_value::<Vec<Entry>>()?
                }
                _ if result => drop(map.next_value::<IgnoredAny>()?),
                _ => {
                    let fields = FIELDS.map(|field| format!("`{field}`")).join(", ");
                    return Err(A::Error::custom(format!(
                        "unknown field `{name}`, expected one of {fields}"
                    )));
                }
            }
            seen.push(name);
        }
        if !result && seen.iter().any(|name| name == "schema") {
            return Err(A::Error::custom(format!("the `schema` of a result begins with `{RESULT}`")));
        }
        let mut of_entries = Vec::new();
        for Entry { alpha } in entries {
            of_entries.extend(index_of(alpha)?.map_or_else(Vec::new, |indices| indices.0));
        }
        let missing = |field| move || A::Error::missing_field(field);
        Ok(InstanceFile {
            degree: degree.ok_or_else(missing("degree"))?,
            knots: knots.ok_or_else(missing("knots"))?,
            alpha: alpha.or((!of_entries.is_empty()).then_some(Indices(of_entries))),
            points,
        })
    }
}

/// The indices in a result, if it has any: one for every index has a word in their place.
fn index_of<E: serde::de::Error>(alpha: Option<Box<RawValue>>) -> Result<Option<Indices>, E> {
    match alpha.as_ref().map_or("null", |alpha| alpha.get()) {
        "null" | "\"symbolic\"" | "\"all\"" => Ok(None),
        text => json::read(text).map(Some).map_err(|error| E::custom(error.message())),
    }
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
        json::read(&text).map_err(malformed)
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
