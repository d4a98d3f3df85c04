//! What an answer about a basis begins with.

use std::fmt;

use num_rational::BigRational;
use schemars::JsonSchema;
use serde::Serialize;

use crate::spline::Basis;

use super::exact::{Exact, as_given};

/// The degree and the knots that an answer is about.
#[derive(Debug, Serialize, JsonSchema)]
pub(super) struct OnKnots {
    /// k.
    pub(super) degree: usize,
    /// t_0, …, t_m: exactly as given, as fractions in lowest terms, whatever the notation.
    #[serde(serialize_with = "as_given")]
    #[schemars(with = "Vec<String>")]
    pub(super) knots: Vec<Exact>,
    #[serde(skip)]
    label: Option<String>,
}

impl OnKnots {
    /// Those of a basis, and the name of the instance that it comes from.
    pub(super) fn of<W>(basis: &Basis<W>, label: Option<String>) -> Self {
        Self { degree: basis.degree(), knots: exact(basis.knots().knots()), label }
    }
}

/// As the head of a text.
impl fmt::Display for OnKnots {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(label) = &self.label {
            writeln!(f, "Instance {label}")?;
        }
        write!(f, "Knots {}, degree {}", tuple(&self.knots), self.degree)
    }
}

/// Numbers for JSON.
pub(super) fn exact(numbers: &[BigRational]) -> Vec<Exact> {
    numbers.iter().cloned().map(Exact).collect()
}

/// A point, or any list, for people.
pub(super) fn tuple(parts: &[impl ToString]) -> String {
    format!("({})", parts.iter().map(ToString::to_string).collect::<Vec<_>>().join(", "))
}
