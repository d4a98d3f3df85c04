//! A basis, and a curve on it, as they are typed.

use serde::Deserialize;

use crate::meaning::Weighting;
use crate::scalar::{BigRational, parse_rational};
use crate::spline::{AnyWeights, Basis, Curve, CurveError, KnotError, KnotVector, Point};

use super::error::TypedError;
use super::lists::{numbers, points};
use super::member::{ChosenFamily, family_named};
use super::provenance::Provenance;
use super::whole_number::whole_number;

/// What a question is about, in the texts of its fields: those of the options of the same names.
#[derive(Debug, Clone, Default, PartialEq, Eq, Deserialize)]
#[serde(default)]
pub struct Asked {
    /// k.
    pub degree: String,
    /// U.
    pub knots: String,
    /// α, where there is no family.
    pub alpha: String,
    /// The name of a family; empty for that of an index.
    pub family: String,
    /// The settings of the family.
    pub set: Vec<String>,
    /// The control points; empty, if there is no curve.
    pub points: String,
}

/// A basis of any family with its weights, and the curve if there are control points.
#[derive(Debug)]
pub struct Case {
    /// α, or the member of another family.
    pub weights: Weighting,
    /// The basis.
    pub basis: Basis<AnyWeights>,
    /// The curve on it.
    pub curve: Option<Curve<AnyWeights>>,
}

impl Asked {
    /// The family with its settings, if one is chosen.
    ///
    /// # Errors
    /// [`TypedError`].
    pub fn family(&self) -> Result<Option<ChosenFamily>, TypedError> {
        match self.family.trim() {
            "" => Ok(None),
            name => ChosenFamily::new(family_named(name)?, &self.set).map(Some),
        }
    }

    /// What it is, checked.
    ///
    /// # Errors
    /// [`TypedError`], for the first field that is wrong.
    pub fn case(&self) -> Result<Case, TypedError> {
        let degree = value("--degree <K>", &self.degree, whole_number)?;
        let weights = match self.family()? {
            Some(chosen) => chosen.member()?,
            None => value("--alpha <A>", &self.alpha, str::parse).map(Weighting::Index)?,
        };
        let place = Provenance::option("--knots");
        let knots = knot_vector(numbers(&self.knots, &place)?, &place)?;
        let wrong = |error| TypedError::Basis { place: place.clone(), error };
        let basis = Basis::over(knots, degree, ()).map_err(wrong)?;
        let wrong = |error| TypedError::Member { argument: "--family", error };
        let basis = basis.with(weights.on_knots(basis.knots(), degree).map_err(wrong)?);
        let curve = match self.points.trim() {
            "" => None,
            text => Some(curve(&basis, &points(text)?, &Provenance::option("--points"))?),
        };
        Ok(Case { weights, basis, curve })
    }
}

/// A point x.
///
/// # Errors
/// [`TypedError::Value`].
pub fn point(text: &str) -> Result<BigRational, TypedError> {
    value("--x <X>", text, parse_rational)
}

fn value<T, E: ToString>(
    field: &'static str,
    text: &str,
    read: impl FnOnce(&str) -> Result<T, E>,
) -> Result<T, TypedError> {
    let wrong = |why: E| TypedError::Value { field, text: text.to_owned(), why: why.to_string() };
    read(text).map_err(wrong)
}

/// Knots that stand at a place.
///
/// # Errors
/// [`TypedError::Knots`], where they decrease, or are none.
pub fn knot_vector(knots: Vec<BigRational>, place: &Provenance) -> Result<KnotVector, TypedError> {
    KnotVector::new(knots).map_err(|error| {
        let place = match &error {
            KnotError::Decreasing { position, .. } => place.clone().at(*position),
            _ => place.clone(),
        };
        TypedError::Knots { place, error: Box::new(error) }
    })
}

/// The curve with control points that stand at a place.
///
/// # Errors
/// [`TypedError::Curve`], where they are no control polygon for the basis.
pub fn curve<W: Clone>(
    basis: &Basis<W>,
    points: &[Point],
    place: &Provenance,
) -> Result<Curve<W>, TypedError> {
    Curve::new(basis.clone(), points.to_vec()).map_err(|error| {
        let place = match &error {
            CurveError::Dimension { position, .. } | CurveError::Mixed { position, .. } => {
                place.clone().at(*position)
            }
            CurveError::Count { .. } | CurveError::Function { .. } | CurveError::Period { .. } => {
                place.clone()
            }
        };
        TypedError::Curve { place, error }
    })
}
