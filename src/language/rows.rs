//! Instances and cases of a paper: TOML → degrees on knots with indices, every number with its place.

use std::collections::BTreeMap;
use std::sync::Arc;

use num_traits::{One, Signed};
use schemars::JsonSchema;
use serde::Deserialize;
use toml::Spanned;

use crate::scalar::{BigRational, parse_rational};

use super::complaint::{Complaint, Origin, Place};
use super::file::Reading;
use super::syntax::Name;

/// A degree on knots with indices and, for a curve, control points.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Row {
    /// Its name; a case that is only tried has none.
    pub name: Option<Name>,
    /// Where the paper shows it.
    pub figure: String,
    /// k.
    pub degree: usize,
    /// t_0, …, t_m.
    pub knots: Vec<BigRational>,
    /// The values of α; `None` is ∞.
    pub indices: Vec<Option<BigRational>>,
    /// The parameters of a family without an index by their names: a row of numbers, or for parameters by degree one for each.
    pub set: Vec<(String, Vec<Vec<BigRational>>)>,
    /// d_0, …, d_n, for a curve.
    pub points: Option<Vec<Vec<BigRational>>>,
    places: Places,
}

/// Where the parts of a row stand.
#[derive(Debug, Clone, PartialEq, Eq)]
struct Places {
    origin: Arc<Origin>,
    name: Place,
    knots: Place,
    weights: Place,
    points: Place,
}

/// A part of a row that something can be wrong with.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RowPart {
    /// Its name.
    Name,
    /// `knots`.
    Knots,
    /// `alpha`, or `set`.
    Weights,
    /// `points`.
    Points,
}

impl Row {
    /// What is wrong with a part of it, with its place.
    #[must_use]
    pub fn complaint(&self, part: RowPart, rule: impl Into<String>, advice: impl Into<String>) -> Complaint {
        let Places { origin, name, knots, weights, points } = &self.places;
        let at = match part {
            RowPart::Name => name,
            RowPart::Knots => knots,
            RowPart::Weights => weights,
            RowPart::Points => points,
        };
        Complaint::new(origin, at.clone(), rule, advice)
    }
}

#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct RawRows {
    /// The format of the file; 1 if nothing is said.
    #[serde(rename = "format")]
    #[schemars(extend("const" = 1))]
    _format: Option<u8>,
    /// The paper's examples.
    #[serde(default)]
    instance: Vec<RawRow>,
    /// Cases that are tried after the usual ones.
    #[serde(default)]
    case: Vec<RawRow>,
}

#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct RawRow {
    /// Its name: `U4`. One name can stand for several degrees.
    #[schemars(with = "Option<String>")]
    name: Option<Spanned<String>>,
    /// Where the paper shows it.
    #[serde(default)]
    figure: String,
    /// k.
    #[serde(alias = "k")]
    degree: usize,
    /// t_0, …, t_m, by spaces.
    #[serde(alias = "U")]
    #[schemars(with = "String")]
    knots: Spanned<String>,
    /// The values of α, by spaces; `inf` for ∞.
    #[schemars(with = "Option<String>")]
    alpha: Option<Spanned<String>>,
    /// The parameters of another family, as behind `--set`: { q = "1/2" }, { omega = "1 2 1/2 3" }; by degrees with `;`.
    #[serde(default)]
    #[schemars(with = "BTreeMap<String, String>")]
    set: BTreeMap<String, Spanned<String>>,
    /// d_0, …, d_n by spaces, coordinates by commas.
    #[schemars(with = "Option<String>")]
    points: Option<Spanned<String>>,
}

/// An exact number.
fn number(reading: &mut Reading, at: &Place, text: &str) -> Option<BigRational> {
    let read = parse_rational(text);
    read.map_err(|error| reading.complain(at.clone(), error.to_string(), "write exact numbers, such as -1/2"))
        .ok()
}

/// Indices by spaces; ∞ is `None`.
pub(super) fn indices(reading: &mut Reading, text: &Spanned<String>) -> Vec<Option<BigRational>> {
    let index = |part| match part {
        "inf" => Some(None),
        part => {
            let alpha = number(reading, &text.span(), part)?;
            if !alpha.is_negative() && alpha <= BigRational::one() {
                reading.complain(
                    text.span(),
                    "an index is less than 0 or greater than 1",
                    "take another one",
                );
                return None;
            }
            Some(Some(alpha))
        }
    };
    text.get_ref().split_whitespace().filter_map(index).collect()
}

/// The rows of a file; what is wrong in it goes to the complaints. A row with a wrong number is none.
pub(super) fn rows(reading: &mut Reading) -> Vec<Row> {
    let Some(RawRows { instance, case, .. }) = reading.toml::<RawRows>() else { return Vec::new() };
    let mut rows = Vec::new();
    for (raw, named) in
        instance.into_iter().map(|raw| (raw, true)).chain(case.into_iter().map(|raw| (raw, false)))
    {
        let before = reading.complaints.len();
        let strange = |name: &str| {
            let letters = |c: char| c.is_ascii_alphanumeric() || c == '_';
            !name.starts_with(|c: char| c.is_ascii_alphabetic()) || !name.chars().all(letters)
        };
        match &raw.name {
            Some(name) if strange(name.get_ref()) => {
                let advice = "a letter, then letters, digits and `_`: `U4`";
                reading.complain(
                    name.span(),
                    format!("`{}` is no name of an instance", name.get_ref()),
                    advice,
                );
            }
            None if named => {
                reading.complain(raw.knots.span(), "this instance has no name", "add `name = \"U1\"`");
            }
            _ => {}
        }
        let all = |reading: &mut Reading, text: &Spanned<String>, separator: char| -> Vec<Vec<BigRational>> {
            let numbers = |point: &str| {
                point.split(separator).filter_map(|part| number(reading, &text.span(), part)).collect()
            };
            text.get_ref().split_whitespace().map(numbers).collect()
        };
        let knots = all(reading, &raw.knots, ' ').into_iter().flatten().collect();
        let alpha = raw.alpha.as_ref();
        let indices = alpha.map(|text| indices(reading, text)).unwrap_or_default();
        let set = raw.set.iter().map(|(name, text)| {
            let row = |row: &str| {
                let parts = row.split([' ', ',']).filter(|part| !part.is_empty());
                parts.filter_map(|part| number(reading, &text.span(), part)).collect()
            };
            (name.clone(), text.get_ref().split(';').map(row).collect())
        });
        let set = set.collect();
        let points = raw.points.as_ref().map(|points| all(reading, points, ','));
        let place = |text: &Option<Spanned<String>>| text.as_ref().map_or(0..0, Spanned::span);
        if reading.complaints.len() == before {
            rows.push(Row {
                places: Places {
                    origin: reading.origin(),
                    name: place(&raw.name),
                    knots: raw.knots.span(),
                    weights: alpha
                        .or(raw.set.values().next())
                        .map_or_else(|| raw.knots.span(), Spanned::span),
                    points: place(&raw.points),
                },
                name: raw.name.map(|name| Name::from(name.get_ref().as_str())),
                figure: raw.figure,
                degree: raw.degree,
                knots,
                indices,
                set,
                points,
            });
        }
    }
    rows
}
