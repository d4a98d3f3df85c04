//! What an answer about a basis begins with.

use std::fmt;

use num_rational::BigRational;
use schemars::JsonSchema;
use serde::Serialize;

use crate::spline::{Basis, Curve};

use super::exact::{Exact, as_given};

/// The degree and the knots that an answer is about, and the control points if it is about a curve.
#[derive(Debug, Serialize, JsonSchema)]
pub(super) struct OnKnots {
    /// k.
    pub(super) degree: usize,
    /// t_0, …, t_m: exactly as given, as fractions in lowest terms, whatever the notation.
    #[serde(serialize_with = "as_given")]
    #[schemars(with = "Vec<String>")]
    pub(super) knots: Vec<Exact>,
    /// The control points d_0, …, d_n that were given, each a list of coordinates: exactly as given, whatever the notation.
    #[serde(skip_serializing_if = "Option::is_none", serialize_with = "as_given")]
    #[schemars(with = "Option<Vec<Vec<String>>>")]
    points: Option<Vec<Vec<Exact>>>,
    #[serde(skip)]
    label: Option<String>,
}

impl OnKnots {
    /// Those of a basis, and the name of the instance that it comes from.
    pub(super) fn of<W>(basis: &Basis<W>, label: Option<String>) -> Self {
        Self { degree: basis.degree(), knots: exact(basis.knots().knots()), points: None, label }
    }

    /// The same with the control points of a curve on them.
    pub(super) fn with_points_of<W>(self, curve: &Curve<W>) -> Self {
        Self { points: Some(curve.points().iter().map(|point| exact(point)).collect()), ..self }
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
