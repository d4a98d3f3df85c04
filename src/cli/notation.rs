//! How exact numbers are written: as fractions, as decimals, or as floats.

use std::borrow::Cow;
use std::cell::Cell;

use num_rational::BigRational;
use num_traits::ToPrimitive;
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::{Serialize, Serializer};

use crate::analysis::{Enclosed, settled, settled_apart};
use crate::scalar::decimal;

use super::error::CliError;

/// The arguments of commands that print numbers.
#[derive(Debug, Clone, Copy, clap::Args)]
pub(super) struct NotationArgs {
    /// Numbers as decimals with N significant digits, all of them right, in place of fractions: for spreadsheets.
    #[arg(long, value_name = "N", value_parser = crate::typed::whole_number, conflicts_with = "float")]
    digits: Option<usize>,
    /// Numbers as the nearest f64, correctly rounded, in the shortest form that reads back as it: for NumPy and the
    /// like. In JSON they are numbers, not strings.
    #[arg(long)]
    float: bool,
}

/// The most digits of a decimal.
const DIGITS_LIMIT: usize = 10_000;
/// Significant digits of an approximation beside the exact number.
const DIGITS: usize = 10;

/// How often bounds are narrowed: a number that is halfway between two floats, and not known to be, lies between them
/// however close they come.
const LOOKS: usize = 512;

/// How a number is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Notation {
    /// `1/55`, and where people look also 0.01818181818.
    Exact,
    /// `0.018182`, with so many significant digits.
    Digits(usize),
    /// `0.01818181818181818`.
    Float,
}

impl NotationArgs {
    /// The notation asked for.
    ///
    /// # Errors
    /// [`CliError::Limits`], for no digits or too many.
    pub(super) fn notation(self) -> Result<Notation, CliError> {
        match self.digits {
            Some(given) if !(1..=DIGITS_LIMIT).contains(&given) => {
                Err(CliError::Limits { argument: "--digits", given, least: 1, most: DIGITS_LIMIT })
            }
            Some(digits) => Ok(Notation::Digits(digits)),
            None => Ok(if self.float { Notation::Float } else { Notation::Exact }),
        }
    }
}

thread_local! {
    /// The traits that write values, `Display` and `Serialize`, take no arguments: the notation comes to a number by
    /// this way.
    static IN_FORCE: Cell<Notation> = const { Cell::new(Notation::Exact) };
}

impl Notation {
    /// Does `write` with numbers in this notation.
    pub(super) fn during<T>(self, write: impl FnOnce() -> T) -> T {
        let before = IN_FORCE.replace(self);
        let written = write();
        IN_FORCE.set(before);
        written
    }

    /// The one in force.
    pub(super) fn in_force() -> Self {
        IN_FORCE.get()
    }

    /// A number for scripts.
    pub(super) fn number(self, value: &BigRational) -> String {
        match self {
            Self::Exact => value.to_string(),
            _ => self.approximation(value),
        }
    }

    /// A number beside its fraction.
    pub(super) fn approximation(self, value: &BigRational) -> String {
        match self {
            Self::Exact => decimal(value, DIGITS),
            Self::Digits(digits) => decimal(value, digits),
            Self::Float => float(nearest(value)),
        }
    }

    /// A number that is known by an enclosure which can be narrowed, in digits that are settled.
    pub(super) fn settled(self, number: &mut impl Enclosed) -> Decimal {
        let Self::Float = self else { return Decimal(settled(number, self.digits())) };
        for _ in 0..LOOKS {
            let (lo, hi) = number.bounds();
            if nearest(&lo).to_bits() == nearest(&hi).to_bits() {
                return Decimal(float(nearest(&lo)));
            }
            if !number.narrow() {
                break;
            }
        }
        Decimal(settled(number, DIGITS))
    }

    /// The same of several, so that neighbours `at` and `at + 1` that differ look different. Floats are as near as
    /// they are.
    pub(super) fn settled_apart(
        self,
        numbers: &mut [impl Enclosed],
        differ: impl Fn(usize) -> bool,
    ) -> Vec<Decimal> {
        match self {
            Self::Float => numbers.iter_mut().map(|number| self.settled(number)).collect(),
            _ => settled_apart(numbers, self.digits(), differ).into_iter().map(Decimal).collect(),
        }
    }

    /// Significant digits of a decimal.
    pub(super) fn digits(self) -> usize {
        match self {
            Self::Digits(digits) => digits,
            Self::Exact | Self::Float => DIGITS,
        }
    }
}

/// An approximation with settled digits; a number in JSON where floats are asked for.
#[derive(Debug, Clone)]
pub(super) struct Decimal(pub(super) String);

impl JsonSchema for Decimal {
    fn schema_name() -> Cow<'static, str> {
        "Decimal".into()
    }
    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({
            "description": "A decimal whose digits are settled, as a string, such as \"0.5773502692\"; with --float a JSON number.",
            "type": ["number", "string"],
        })
    }
}

impl Serialize for Decimal {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match (Notation::in_force(), self.0.parse::<f64>()) {
            (Notation::Float, Ok(float)) if float.is_finite() => serializer.serialize_f64(float),
            _ => serializer.serialize_str(&self.0),
        }
    }
}

/// The nearest f64; beyond the largest one it is infinite.
pub(super) fn nearest(value: &BigRational) -> f64 {
    // `to_f64` of a rational is always `Some`: it saturates.
    value.to_f64().unwrap_or(f64::NAN)
}

/// The shortest decimal that reads back as the float.
fn float(value: f64) -> String {
    format!("{value:?}")
}
