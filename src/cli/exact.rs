//! Exact numbers in JSON.

use std::borrow::Cow;
use std::fmt;

use num_rational::BigRational;
use num_traits::Signed;
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::Error as _;
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use serde_json::value::RawValue;

use crate::json::{self, is_number, kind, number_text, raw};
use crate::scalar::parse_rational;
use crate::spline::Index;

use super::notation::{Notation, nearest};

/// A rational number: written as a string in lowest terms, read from a string or from a JSON number, which
/// counts with all its digits (0.4 is 2/5).
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Exact(pub(super) BigRational);

impl fmt::Display for Exact {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}

impl Serialize for Exact {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match Notation::in_force() {
            Notation::Float if nearest(&self.0).is_finite() => serializer.serialize_f64(nearest(&self.0)),
            notation => serializer.collect_str(&notation.number(&self.0)),
        }
    }
}

impl<'de> Deserialize<'de> for Exact {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        json::Number::deserialize(deserializer).map(|json::Number(number)| Self(number))
    }
}

impl JsonSchema for Exact {
    fn schema_name() -> Cow<'static, str> {
        "Number".into()
    }
    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        if generator.contract().is_serialize() {
            return json_schema!({
                "description": "A number: an exact one in lowest terms, as a string, such as \"3\" or \"-1/2\". With --digits N a decimal, as a string; with --float a JSON number, and beyond the largest one the string \"inf\" or \"-inf\".",
                "type": ["number", "string"],
            });
        }
        json_schema!({
            "description": "An exact number, as a JSON number or as a string: \"3\", \"-1/2\", \"0.4\" (that is 2/5), \"1e-3\", \"0x1.8p-3\".",
            "type": ["number", "string"],
        })
    }
}

/// Numbers that were given, or that enclose another: exactly, whatever the notation of results.
///
/// # Errors
/// Those of the serializer.
pub(super) fn as_given<S: Serializer>(numbers: &impl Serialize, serializer: S) -> Result<S::Ok, S::Error> {
    Notation::Exact.during(|| numbers.serialize(serializer))
}

/// A whole number ≥ 0, as JSON Schema has it: 1.0 is one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Whole(pub(super) usize);

impl<'de> Deserialize<'de> for Whole {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let raw = raw(deserializer)?;
        let text = raw.get();
        let wrong = |found: &str| {
            D::Error::custom(format!("expected a whole number from 0 up, such as 2, and found {found}"))
        };
        if !is_number(text) {
            return Err(wrong(kind(text)));
        }
        let number = parse_rational(text).map_err(D::Error::custom)?;
        if !number.is_integer() || number.is_negative() {
            return Err(wrong(text));
        }
        usize::try_from(number.numer()).map(Self).map_err(|_| D::Error::custom("the number is too large"))
    }
}

impl JsonSchema for Whole {
    fn inline_schema() -> bool {
        true
    }
    fn schema_name() -> Cow<'static, str> {
        "WholeNumber".into()
    }
    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({ "type": "integer", "minimum": 0 })
    }
}

/// One index or several: a number or `"inf"`, or a list of those.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Indices(pub(super) Vec<Index>);

impl<'de> Deserialize<'de> for Indices {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let index = |value: &RawValue, place: &str| -> Result<Index, D::Error> {
            let wrong = |error: &dyn fmt::Display| D::Error::custom(format!("`{place}`: {error}"));
            let text = number_text(value).map_err(|error| wrong(&error))?;
            text.parse().map_err(|error| wrong(&error))
        };
        let raw = raw(deserializer)?;
        if !raw.get().starts_with('[') {
            return Ok(Self(vec![index(&raw, "alpha")?]));
        }
        let values: Vec<Box<RawValue>> = json::read(raw.get()).map_err(D::Error::custom)?;
        let numbered = values.iter().enumerate();
        numbered.map(|(i, value)| index(value, &format!("alpha[{i}]"))).collect::<Result<_, _>>().map(Self)
    }
}

impl JsonSchema for Indices {
    fn schema_name() -> Cow<'static, str> {
        "Indices".into()
    }
    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let number = generator.subschema_for::<Exact>();
        json_schema!({
            "description": "An index is less than 0 or greater than 1, or \"inf\".",
            "anyOf": [number, { "type": "array", "items": number, "minItems": 1 }],
        })
    }
}
