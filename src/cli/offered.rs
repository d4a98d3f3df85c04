//! Arguments for which a shell offers names, though others are read too.

use std::ffi::OsStr;

use clap::builder::{OsStringValueParser, PossibleValue, StringValueParser, TypedValueParser};
use clap::{Arg, Command, Error};

use crate::language::{claims, families};
use crate::meaning::{Example, examples};

/// Reads as `parser` does, and offers the names.
#[derive(Clone)]
pub(super) struct Offered<P> {
    parser: P,
    names: fn() -> Vec<&'static str>,
}

/// The identifier of a claim.
pub(super) fn claim_name() -> Offered<StringValueParser> {
    Offered { parser: StringValueParser::new(), names: || claims().iter().map(|claim| claim.id()).collect() }
}

/// The name of an instance of the paper, or a file.
pub(super) fn instance_name() -> Offered<OsStringValueParser> {
    Offered { parser: OsStringValueParser::new(), names: || instance_names(examples()) }
}

/// The name of a family, or a file.
pub(super) fn family_name() -> Offered<OsStringValueParser> {
    let names = || families().iter().map(|family| family.name.as_str()).collect();
    Offered { parser: OsStringValueParser::new(), names }
}

/// The names of a paper's instances, once each.
pub(super) fn instance_names(examples: &[Example]) -> Vec<&str> {
    let mut names: Vec<_> = examples.iter().map(|example| &*example.name).collect();
    names.dedup();
    names
}

impl<P: TypedValueParser> TypedValueParser for Offered<P> {
    type Value = P::Value;

    fn parse_ref(&self, command: &Command, arg: Option<&Arg>, value: &OsStr) -> Result<P::Value, Error> {
        self.parser.parse_ref(command, arg, value)
    }

    fn possible_values(&self) -> Option<Box<dyn Iterator<Item = PossibleValue> + '_>> {
        Some(Box::new((self.names)().into_iter().map(PossibleValue::new)))
    }
}
