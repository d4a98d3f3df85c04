//! What a text may name besides what it binds: definitions, instances, claims.

use std::collections::{BTreeMap, BTreeSet};

use super::syntax::{Definition, Name, Pattern};

/// What a bound name stands for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    Int,
    Real,
    Index,
    Coefficients,
}

/// What of the case a text may speak of, or does.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(super) struct Subjects {
    /// k.
    pub(super) degree: bool,
    /// U, and with it m, n, t, G, w.
    pub(super) knots: bool,
    /// The control points P of an instance.
    pub(super) instance: bool,
    /// Names of `for`.
    pub(super) names: Vec<(Name, Kind)>,
}

impl Subjects {
    /// Speaks of what the other one speaks of, too.
    pub(super) fn join(&mut self, other: &Self) {
        self.degree |= other.degree;
        self.knots |= other.knots;
        self.instance |= other.instance;
        for name in &other.names {
            if !self.names.contains(name) {
                self.names.push(name.clone());
            }
        }
    }
}

/// What a text may say of the family it is about.
#[derive(Debug, Clone)]
pub(super) struct Vocabulary {
    /// Its name.
    pub(super) name: String,
    /// Its parameters with their indices.
    pub(super) parameters: Vec<(Name, Vec<Name>)>,
    /// Are its weights given by the ends of an interval, so that phi(x, a, b) has a meaning?
    pub(super) by_ends: bool,
    /// Is it the family's own file?
    pub(super) in_file: bool,
}

impl Vocabulary {
    /// `omega[i]`.
    pub(super) fn head(name: &str, of: &[Name]) -> String {
        if of.is_empty() { name.to_owned() } else { format!("{name}[{}]", of.join(",")) }
    }

    /// What it has, for a message.
    pub(super) fn has(&self) -> String {
        let heads: Vec<_> = self.parameters.iter().map(|(name, of)| Self::head(name, of)).collect();
        if heads.is_empty() { "no parameter".to_owned() } else { heads.join(", ") }
    }
}

/// What a text may name besides what it binds.
#[derive(Debug, Clone, Default)]
pub struct Known {
    /// The definitions of the file.
    pub(super) definitions: Vec<Definition>,
    /// Which others each of them names, itself or through others.
    pub(super) leads: BTreeMap<Name, BTreeSet<Name>>,
    /// What each of them speaks of, itself or through others.
    pub(super) subjects: BTreeMap<Name, Subjects>,
    /// The family that is spoken of, if that is not the one with an index.
    pub(super) family: Option<Vocabulary>,
    /// The names of the instances; without them, any name is taken.
    pub instances: Option<BTreeSet<Name>>,
    /// The identifiers of the claims; without them, any is taken.
    pub claims: Option<BTreeSet<Name>>,
}

impl Known {
    /// The definitions of the file.
    #[must_use]
    pub fn definitions(&self) -> &[Definition] {
        &self.definitions
    }

    /// Is it one of these names, or do they lead to it?
    pub(super) fn is_used(&self, name: &str, by: &BTreeSet<Name>) -> bool {
        by.contains(name)
            || by.iter().any(|user| self.leads.get(user).is_some_and(|leads| leads.contains(name)))
    }

    pub(super) fn subjects(&self, name: &str) -> Subjects {
        self.subjects.get(name).cloned().unwrap_or_default()
    }
}

impl Definition {
    /// How it is written: `b[i,q](x)`.
    #[must_use]
    pub fn head(&self) -> String {
        let indices: Vec<_> = self
            .indices
            .iter()
            .map(|index| match index {
                Pattern::Number(number) => number.to_string(),
                Pattern::Any(name) => name.to_string(),
            })
            .collect();
        let indices = if indices.is_empty() { String::new() } else { format!("[{}]", indices.join(",")) };
        let variable = self.variable.as_ref().map(|variable| format!("({variable})")).unwrap_or_default();
        format!("{}{indices}{variable}", self.name)
    }
}

/// The closest of some names, if it is close enough for a slip of the hand.
pub(super) fn nearest<'a>(name: &str, among: impl Iterator<Item = &'a str>) -> Option<&'a str> {
    let far = |other: &&str| strsim::damerau_levenshtein(&name.to_lowercase(), &other.to_lowercase());
    among
        .filter(|other| far(other) <= name.len().div_ceil(3) && other.len() > 1 && name.len() > 1)
        .min_by_key(far)
}
