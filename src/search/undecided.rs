//! Cases that are not decided: how many there are is counted, and of the first ones it is said why.

use std::collections::BTreeMap;
use std::ops::Range;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::judge::OfFamily;

use super::members::MemberFunction;

/// Of so many the reason is kept.
const KEPT: usize = 3;

/// The first cases that are not decided, by their positions, with the reasons. How they were put together does not matter.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub(super) struct Undecided {
    first: BTreeMap<u64, UndecidedRecord>,
}

/// A case that is not decided; rational numbers are strings.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct UndecidedRecord {
    /// Its position.
    pub at: u64,
    /// The gaps between the knots of the function.
    pub gaps: Vec<String>,
    /// The family, and its parameters on the full knot vector of the function.
    pub family: OfFamily,
    /// Why it is not decided.
    pub why: String,
}

impl UndecidedRecord {
    pub(super) fn new(at: u64, function: &MemberFunction, why: String) -> Self {
        let gaps = function.gaps().iter().map(ToString::to_string).collect();
        Self { at, gaps, family: function.of_family(), why }
    }
}

impl Undecided {
    pub(super) fn add(&mut self, record: UndecidedRecord) {
        self.first.insert(record.at, record);
        while self.first.len() > KEPT && self.first.pop_last().is_some() {}
    }

    pub(super) fn merge(&mut self, other: Self) {
        other.first.into_values().for_each(|record| self.add(record));
    }

    pub(super) fn records(&self) -> impl Iterator<Item = &UndecidedRecord> {
        self.first.values()
    }

    /// Can these be the first ones of so many?
    pub(super) fn are_first_of(&self, cases: u64) -> bool {
        cases.min(KEPT as u64) == self.first.len() as u64
    }

    /// Is it the same if those at some positions are `again`?
    pub(super) fn agrees(&self, again: &Self, positions: &Range<u64>) -> bool {
        let mut joined = self.clone();
        joined.merge(again.clone());
        let again = |at: &u64| again.first.contains_key(at);
        joined == *self && self.first.keys().filter(|at| positions.contains(at)).all(again)
    }
}
