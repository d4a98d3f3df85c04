//! The figures as they are written down: decimals, hexadecimal floats, exact numbers and commands.

use num_rational::BigRational;
use serde::Serialize;

use super::case::Case;
use super::hexadecimal::hexadecimal;
use super::{Extreme, Figures};
use crate::scalar::{decimal, exact_value};

/// The digits of an error as text: exactly, it is a fraction of hundreds of digits.
const DIGITS: usize = 6;

/// What one formula does wrong. Errors are decimals of six digits.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct FormulaRecord {
    /// The formula ([`Formula::name`](super::Formula::name)).
    pub name: &'static str,
    /// The largest error in units in the last place.
    pub max_ulp: Option<String>,
    /// Of the largest errors of the random cases, the one that 99 of 100 do not exceed.
    pub p99_ulp: String,
    /// And the one that half of them do not exceed.
    pub median_ulp: String,
    /// The largest |float − exact|.
    pub max_absolute: String,
    /// The largest |Σ floats − Σ exact values|.
    pub max_sum: String,
    /// The number of values with a wrong sign.
    pub sign_errors: usize,
    /// The number of values that are infinite or NaN.
    pub not_finite: usize,
    /// The proved bound of `max_ulp`, if there is one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub bound_ulp: Option<f64>,
    /// Where the largest error is.
    pub worst: Option<WorstRecord>,
}

/// The worst case: exactly, as hexadecimal floats, and as commands.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct WorstRecord {
    /// In exact numbers.
    #[serde(flatten)]
    pub exact: CaseRecord,
    /// i of G_i^k.
    pub index: usize,
    /// In hexadecimal floats.
    pub float: CaseRecord,
    /// Measures it again.
    pub reproduce: String,
    /// Prints the exact values.
    pub eval: String,
}

/// A case, number by number.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct CaseRecord {
    /// x.
    pub x: String,
    /// α.
    pub alpha: String,
    /// t_0, …, t_m.
    pub knots: Vec<String>,
}

impl From<&Figures> for FormulaRecord {
    fn from(figures: &Figures) -> Self {
        let text = |error: &BigRational| decimal(error, DIGITS);
        Self {
            name: figures.formula.name(),
            max_ulp: figures.worst.as_ref().map(|worst| text(&worst.error)),
            p99_ulp: text(&figures.percentile_99),
            median_ulp: text(&figures.median),
            max_absolute: text(&figures.absolute),
            max_sum: text(&figures.sum),
            sign_errors: figures.signs,
            not_finite: figures.not_finite,
            bound_ulp: figures.bound,
            worst: figures.worst.as_ref().map(WorstRecord::from),
        }
    }
}

impl From<&Extreme> for WorstRecord {
    fn from(worst: &Extreme) -> Self {
        let exact = |value| exact_value(value).map_or_else(|| "inf".to_owned(), |value| value.to_string());
        let float = CaseRecord::of(&worst.case, hexadecimal);
        let (degree, knots) = (worst.case.basis.degree(), float.knots.join(" "));
        let (alpha, x) = (&float.alpha, &float.x);
        let arguments = format!("--degree {degree} --knots \"{knots}\" --alpha {alpha} --x {x}");
        Self {
            exact: CaseRecord::of(&worst.case, exact),
            index: worst.index,
            reproduce: format!("knotproof float {arguments}"),
            eval: format!("knotproof eval {arguments}"),
            float,
        }
    }
}

impl CaseRecord {
    fn of(case: &Case, text: impl Fn(f64) -> String) -> Self {
        let knots = case.basis.knots().iter().map(|t| text(*t)).collect();
        Self { x: text(case.x), alpha: text(case.basis.alpha()), knots }
    }
}
