//! Exact numbers in JSON.

use std::borrow::Cow;
use std::fmt;

use num_rational::BigRational;
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::Error as _;
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use serde_json::Value;

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
        // By way of `Value`: only there a JSON number keeps its text.
        let text = number_text(Value::deserialize(deserializer)?).map_err(D::Error::custom)?;
        parse_rational(&text).map(Self).map_err(D::Error::custom)
    }
}

impl JsonSchema for Exact {
    fn schema_name() -> Cow<'static, str> {
        "Number".into()
    }
    fn json_schema(_: &mut SchemaGenerator) -> Schema {
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

/// One index or several: a number or `"inf"`, or a list of those.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Indices(pub(super) Vec<Index>);

impl<'de> Deserialize<'de> for Indices {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let index = |value: Value, place: &str| -> Result<Index, D::Error> {
            let wrong = |error: &dyn fmt::Display| D::Error::custom(format!("`{place}`: {error}"));
            let text = number_text(value).map_err(|error| wrong(&error))?;
            text.parse().map_err(|error| wrong(&error))
        };
        let indices = match Value::deserialize(deserializer)? {
            Value::Array(values) => {
                let numbered = values.into_iter().enumerate();
                numbered.map(|(i, value)| index(value, &format!("alpha[{i}]"))).collect::<Result<_, _>>()?
            }
            value => vec![index(value, "alpha")?],
        };
        Ok(Self(indices))
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

/// The text of a JSON number, or of a string that should hold one.
fn number_text(value: Value) -> Result<String, String> {
    match value {
        Value::String(text) => Ok(text),
        Value::Number(number) => Ok(number.as_str().to_owned()),
        other => Err(format!("expected a number or a string with a number, and found {}", kind(&other))),
    }
}

fn kind(value: &Value) -> &'static str {
    match value {
        Value::Null => "null",
        Value::Bool(_) => "a truth value",
        Value::Number(_) => "a number",
        Value::String(_) => "a string",
        Value::Array(_) => "a list",
        Value::Object(_) => "an object",
    }
}
