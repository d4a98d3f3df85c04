//! The figures as they are written down: decimals, hexadecimal floats, exact numbers and commands.

use num_rational::BigRational;
use schemars::JsonSchema;
use serde::Serialize;

use super::probe::Probe;
use super::{Extreme, Figures, Ulps};
use crate::float::hexadecimal;
use crate::judge::OfFamily;
use crate::scalar::{RationalAlgebra, decimal, exact_value};

/// The digits of an error as text: exactly, it is a fraction of hundreds of digits.
const DIGITS: usize = 6;
/// Where the bound of the triangle is proved ([`Method::bound_applies`](super::Method::bound_applies)).
const RANGE: &str = "every r(x − a) + (b − x) is between 2^-100 and 2^100";

/// What one formula does wrong. Errors are decimals of six digits.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct MethodRecord {
    /// The formula.
    #[schemars(extend("enum" = ["paper", "ratio", "triangle", "fast", "accurate"]))]
    pub name: &'static str,
    /// How many cases were looked at: the random ones, and the steps of the search.
    pub tried: u64,
    /// The largest error in units in the last place that was found; `inf` where a result is no number.
    pub max_ulp: Option<String>,
    /// Of the largest errors of the random cases, the one that 99 of 100 do not exceed.
    pub p99_ulp: String,
    /// And the one that half of them do not exceed.
    pub median_ulp: String,
    /// The largest |float − exact|; `inf` where a result is no number.
    pub max_absolute: String,
    /// The largest |Σ floats − Σ exact values|; likewise.
    pub max_sum: String,
    /// The number of values with a wrong sign.
    pub sign_errors: usize,
    /// The number of values that are infinite or NaN.
    pub not_finite: usize,
    /// The number of values below 2⁻⁹⁰⁰, next to underflow, that the errors in ULP leave out.
    pub left_out: usize,
    /// The proved bound of `max_ulp`, if there is one that applies to all cases that were measured.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub bound_ulp: Option<f64>,
    /// The range in which a bound is proved, if some of the cases are outside.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub bound_range: Option<RangeRecord>,
    /// Where the largest error is.
    pub worst: Option<WorstRecord>,
}

/// A bound that does not apply to all cases.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct RangeRecord {
    /// What has to hold for the bound.
    pub holds_where: &'static str,
    /// The bound there.
    pub bound_ulp: f64,
    /// How many of the cases that were measured are outside of that range.
    pub outside: usize,
    /// How many were measured.
    pub measured: usize,
}

/// The worst case: exactly, as hexadecimal floats, and as commands.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct WorstRecord {
    /// In exact numbers.
    #[serde(flatten)]
    pub exact: ProbeRecord,
    /// i of G_i^k.
    pub index: usize,
    /// In hexadecimal floats.
    pub float: ProbeRecord,
    /// Measures it again.
    pub reproduce: String,
    /// Prints the exact values.
    pub eval: String,
}

/// A case, number by number.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
pub struct ProbeRecord {
    /// x.
    pub x: String,
    /// α; nothing for another family.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub alpha: Option<String>,
    /// The member of another family.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub family: Option<OfFamily>,
    /// t_0, …, t_m.
    pub knots: Vec<String>,
}

impl MethodRecord {
    /// What is proved, for readers: the bound rounded up, or where it holds and is not known to hold here.
    #[must_use]
    pub fn proved(&self) -> String {
        // To four digits behind the point, and no less than it is.
        let up = |bound: f64| ((bound * 1e4).ceil() / 1e4).to_string();
        match (self.bound_ulp, &self.bound_range) {
            (Some(bound), _) => up(bound),
            (None, Some(range)) if range.outside == range.measured => "does not apply here".to_owned(),
            (None, Some(range)) => format!("{} in its range", up(range.bound_ulp)),
            (None, None) => String::new(),
        }
    }
}

impl From<&Figures> for MethodRecord {
    fn from(figures: &Figures) -> Self {
        let text = |error: &BigRational| decimal(error, DIGITS);
        let ulps = |error: &Ulps| match error {
            Ulps::Number(error) => text(error),
            Ulps::NotFinite => "inf".to_owned(),
        };
        let absolute =
            |error: &BigRational| if figures.not_finite > 0 { "inf".to_owned() } else { text(error) };
        let range = |bound_ulp| RangeRecord {
            holds_where: RANGE,
            bound_ulp,
            outside: figures.outside,
            measured: figures.measured,
        };
        Self {
            name: figures.formula.name(),
            tried: figures.tried,
            max_ulp: figures.worst.as_ref().map(|worst| ulps(&worst.error)),
            p99_ulp: ulps(&figures.percentile_99),
            median_ulp: ulps(&figures.median),
            max_absolute: absolute(&figures.absolute),
            max_sum: absolute(&figures.sum),
            sign_errors: figures.signs,
            not_finite: figures.not_finite,
            left_out: figures.left_out,
            bound_ulp: figures.bound.filter(|_| figures.outside == 0),
            bound_range: figures.bound.filter(|_| figures.outside > 0).map(range),
            worst: figures.worst.as_ref().map(WorstRecord::from),
        }
    }
}

impl From<&Extreme> for WorstRecord {
    fn from(worst: &Extreme) -> Self {
        let exact = |value| exact_value(value).map_or_else(|| "inf".to_owned(), |value| value.to_string());
        let float = ProbeRecord::of(&worst.case, hexadecimal);
        let (degree, knots) = (worst.case.basis.degree(), float.knots.join(" "));
        let weights = match (&float.alpha, &float.family) {
            (Some(alpha), _) => format!("--alpha {alpha}"),
            (None, family) => family.as_ref().map(ToString::to_string).unwrap_or_default(),
        };
        let arguments = format!("--degree {degree} --knots \"{knots}\" {weights} --x {}", float.x);
        Self {
            exact: ProbeRecord::of(&worst.case, exact),
            index: worst.index,
            reproduce: format!("knotproof float {arguments}"),
            eval: format!("knotproof eval {arguments}"),
            float,
        }
    }
}

impl ProbeRecord {
    fn of(case: &Probe, text: impl Fn(f64) -> String) -> Self {
        let knots = case.basis.knots().iter().map(|t| text(*t)).collect();
        let family =
            case.member.as_ref().and_then(|member| member.weights().member()).map(|member| OfFamily {
                name: member.family().given.clone(),
                parameters: member
                    .named()
                    .map(|(name, values)| {
                        (name.to_string(), values.written(|number| text(0.0_f64.embed(number))))
                    })
                    .collect(),
            });
        let alpha = family.is_none().then(|| text(case.basis.alpha()));
        Self { x: text(case.x), alpha, family, knots }
    }
}
