//! Files of cases that searches have found: TOML → degree, knots and index of each.

use num_rational::BigRational;
use schemars::JsonSchema;
use serde::Deserialize;
use toml::Spanned;

use crate::scalar::parse_rational;

use super::complaint::Complaint;
use super::file::Reading;

/// A degree on knots, with an index.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Found {
    /// k.
    pub degree: usize,
    /// U, as it is written: whether it is a knot vector is not known here.
    pub knots: Vec<BigRational>,
    /// α; `None` is ∞.
    pub alpha: Option<BigRational>,
}

/// A file of cases.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct RawFound {
    /// The cases, in the order in which they are tried.
    case: Vec<RawCase>,
}

/// A case.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct RawCase {
    /// The degree.
    k: usize,
    /// The knots: "0 0 1/2 1 1".
    #[serde(rename = "U")]
    #[schemars(with = "String")]
    knots: Spanned<String>,
    /// The index: "-1/2", or "infinity".
    #[schemars(with = "String")]
    alpha: Spanned<String>,
}

/// Reads a file of cases.
///
/// # Errors
/// Everything that is wrong, each with its place.
pub fn found(file_name: &str, text: &str) -> Result<Vec<Found>, Vec<Complaint>> {
    let mut reading = Reading::new(file_name, text);
    let raw = reading.toml::<RawFound>().map_or_else(Vec::new, |raw| raw.case);
    let mut number = |text: &Spanned<String>, number: &str| {
        let advice = "write numbers as `3`, `-1/2` or `0.4`, with spaces between knots";
        parse_rational(number).map_err(|error| reading.complain(text.span(), error.to_string(), advice)).ok()
    };
    let mut all = Vec::new();
    for RawCase { k, knots, alpha } in &raw {
        let list: Vec<_> = knots.get_ref().split_whitespace().filter_map(|t| number(knots, t)).collect();
        let infinite = alpha.get_ref() == "infinity";
        let alpha = if infinite { None } else { number(alpha, alpha.get_ref()) };
        all.push(Found { degree: *k, knots: list, alpha });
    }
    if reading.complaints.is_empty() { Ok(all) } else { Err(reading.complaints) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_papers_file_is_read_and_wrong_numbers_are_told_of() {
        let text = include_str!("../../papers/rational-bsplines/found.toml");
        let all = found("found.toml", text).unwrap();
        assert!(all.iter().any(|case| case.degree == 8) && all.iter().all(|case| case.alpha.is_some()));
        let wrong = found("wrong.toml", &text.replacen("0 0 3 5", "0 0 3 x", 1)).unwrap_err();
        assert_eq!(wrong.len(), 1);
        assert_eq!(wrong[0].place(), (7, 5));
    }
}
