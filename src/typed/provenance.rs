//! Where an input stands.

use std::fmt;
use std::path::{Path, PathBuf};

/// Where an input stands: an option, a field of an instance file, or an instance of the paper, and the
/// position in a list there, from 0.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Provenance {
    source: Source,
    /// The position in the list; then the coordinate, in a list of points.
    positions: Vec<usize>,
}

#[derive(Debug, Clone, PartialEq, Eq)]
enum Source {
    Option(&'static str),
    Field { path: PathBuf, field: &'static str },
    Paper { name: String, what: &'static str },
}

impl Provenance {
    /// The value of an option, such as `--knots`.
    #[must_use]
    pub fn option(name: &'static str) -> Self {
        Self { source: Source::Option(name), positions: Vec::new() }
    }

    /// A field of an instance file.
    #[must_use]
    pub fn field(path: &Path, field: &'static str) -> Self {
        Self { source: Source::Field { path: path.to_owned(), field }, positions: Vec::new() }
    }

    /// What an instance of the paper brings along, such as its `points`.
    #[must_use]
    pub fn paper(name: &str, what: &'static str) -> Self {
        Self { source: Source::Paper { name: name.to_owned(), what }, positions: Vec::new() }
    }

    /// The entry of the list at the given position, from 0.
    #[must_use]
    pub fn at(mut self, position: usize) -> Self {
        self.positions.push(position);
        self
    }

    /// The option that the input came in by.
    #[must_use]
    pub fn argument(&self) -> &'static str {
        match self.source {
            Source::Option(name) => name,
            Source::Field { .. } | Source::Paper { .. } => "--instance",
        }
    }
}

/// `--points, position 1, coordinate 0`, or ``file.json, `points[1][0]` ``.
impl fmt::Display for Provenance {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.source {
            Source::Field { path, field } => {
                write!(f, "{}, `{field}", path.display())?;
                for position in &self.positions {
                    write!(f, "[{position}]")?;
                }
                return f.write_str("`");
            }
            Source::Option(name) => f.write_str(name)?,
            Source::Paper { name, what } => write!(f, "--instance {name}, its {what}")?,
        }
        for (position, word) in self.positions.iter().zip(["position", "coordinate"]) {
            write!(f, ", {word} {position}")?;
        }
        Ok(())
    }
}
