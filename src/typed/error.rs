//! What can be wrong with what somebody types.

use thiserror::Error;

use crate::json::JsonError;
use crate::meaning::MemberError;
use crate::scalar::NumberError;
use crate::spline::{BasisError, CurveError, KnotError};

use super::provenance::Provenance;

/// Why a text is no number, no list, no basis, no curve or no member of a family: one line that says where, what and what to do.
#[derive(Debug, Error)]
pub enum TypedError {
    /// An entry of a list is not a number.
    #[error("{place}: {error}")]
    Number {
        /// Where it stands.
        place: Provenance,
        /// What is wrong with it.
        error: NumberError,
    },
    /// A comma that may be a decimal point, or the end of an entry.
    #[error(
        "{place}: `{entry}` has a comma without a space after it, in a list with spaces between its entries: write a \
         decimal point, as in 1.5, or the same separator everywhere"
    )]
    DecimalComma {
        /// Where it stands.
        place: Provenance,
        /// The entry.
        entry: String,
    },
    /// The numbers are no knot vector.
    #[error("{place}: {error}")]
    Knots {
        /// Where they stand.
        place: Provenance,
        /// What is wrong with them.
        error: Box<KnotError>,
    },
    /// Too few knots for the degree.
    #[error("{place}: {error}")]
    Basis {
        /// What to change: the degree or the knots.
        place: Provenance,
        /// How many are needed.
        error: BasisError,
    },
    /// The points are no control polygon for the basis.
    #[error("{place}: {error}")]
    Curve {
        /// Where they stand.
        place: Provenance,
        /// What is wrong with them.
        error: CurveError,
    },
    /// Parentheses around points that do not match.
    #[error(
        "--points, position {position}: expected `(…)` and found `{found}`; write (0,2),(3/2,5) or 0,2 3/2,5"
    )]
    Parentheses {
        /// The point, from 0.
        position: usize,
        /// The text from there on.
        found: String,
    },
    /// `--points` looks like JSON and is not a list of lists of numbers.
    #[error("--points: {0}; write [[\"0\",\"2\"],[\"3/2\",\"5\"]]")]
    PointsJson(JsonError),
    /// A setting that is none of the family's, or weights that it does not give.
    #[error("{argument}: {error}")]
    Member {
        /// `--set`, or `--family`.
        argument: &'static str,
        /// What is wrong.
        error: MemberError,
    },
    /// A setting that is not written as one.
    #[error("--set: `{0}` has no `=`: write NAME=VALUES, such as q=1/3 or omega=1,2,1/2")]
    Setting(String),
    /// A parameter that is to stay a letter.
    #[error(
        "--set: `{name}` has to be a number, and here is `{value}`: only α can stay unknown (`knotproof formula --alpha \
         symbolic`, `knotproof shape --alpha all`); give numbers, one run for each"
    )]
    Letter {
        /// The parameter.
        name: String,
        /// What was given.
        value: String,
    },
    /// Two settings of one name.
    #[error("--set: `{0}` is set twice: give it once")]
    SetTwice(String),
    /// Neither the name of a family nor a file.
    #[error("--family: there is no family `{name}`, and no such file; there are {}", names.join(", "))]
    UnknownFamily {
        /// What was given.
        name: String,
        /// The families that come with the program.
        names: Vec<String>,
    },
    /// A text that is not a value of its field.
    #[error("invalid value '{text}' for '{field}': {why}")]
    Value {
        /// The option, and what its value is called.
        field: &'static str,
        /// What was given.
        text: String,
        /// What is wrong with it.
        why: String,
    },
}

impl TypedError {
    /// The option that has to change.
    #[must_use]
    pub fn argument(&self) -> &'static str {
        match self {
            Self::Number { place, .. }
            | Self::DecimalComma { place, .. }
            | Self::Knots { place, .. }
            | Self::Basis { place, .. }
            | Self::Curve { place, .. } => place.argument(),
            Self::Parentheses { .. } | Self::PointsJson(_) => "--points",
            Self::Member { argument, .. } => argument,
            Self::Setting(_) | Self::Letter { .. } | Self::SetTwice(_) => "--set",
            Self::UnknownFamily { .. } => "--family",
            Self::Value { field, .. } => field.split(' ').next().unwrap_or(field),
        }
    }
}
