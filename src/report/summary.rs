//! How many statements there are, and what became of them: the paper's and our questions apart.

use std::collections::BTreeMap;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::Serialize;

use crate::language::{Cause, Severity, Source};

use super::record::Record;

/// The counts of one run.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
pub struct Summary {
    /// What the paper says.
    pub paper: Counts,
    /// What we ask.
    pub questions: Counts,
}

/// The counts of one source, as printed.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub struct Counts {
    /// All of them.
    pub statements: usize,
    /// Those proved.
    pub proved: usize,
    /// Those refuted.
    pub refuted: usize,
    /// Those left open.
    pub undecided: usize,
    /// Those that are no mathematical statements.
    pub not_formal: usize,
    /// Those whose hypotheses hold nowhere.
    #[serde(skip_serializing_if = "is_zero")]
    pub not_applicable: usize,
    /// Those that are true of every degree, as printed or, where that is refuted, as amended.
    pub in_every_degree: usize,
    /// Of the refuted ones.
    pub refutations: Refutations,
}

/// The refuted statements, counted in two ways.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, JsonSchema)]
pub struct Refutations {
    /// By how bad they are; all four words are there.
    #[schemars(extend("propertyNames" = named::<Severity>()))]
    pub by_severity: BTreeMap<&'static str, usize>,
    /// By what stands behind them.
    #[schemars(extend("propertyNames" = named::<Cause>()))]
    pub by_cause: BTreeMap<&'static str, usize>,
}

/// The name of a cause or a severity that nobody has given yet.
pub(super) const UNASSIGNED: &str = "unassigned";

/// The schema of a key: a name from the list, or none given yet.
fn named<T: JsonSchema>() -> Schema {
    json_schema!({ "anyOf": [T::json_schema(&mut SchemaGenerator::default()), { "const": UNASSIGNED }] })
}

#[expect(clippy::trivially_copy_pass_by_ref, reason = "serde passes a reference")]
fn is_zero(count: &usize) -> bool {
    *count == 0
}

impl Summary {
    /// Counts the records.
    #[must_use]
    pub fn of(records: &[Record]) -> Self {
        let of = |source| Counts::of(records.iter().filter(|record| record.source == source));
        Self { paper: of(Source::Paper), questions: of(Source::Question) }
    }
}

impl Counts {
    fn of<'a>(records: impl Iterator<Item = &'a Record>) -> Self {
        let mut counts = Self::default();
        counts.refutations.by_severity = Severity::ALL.map(|severity| (severity.name(), 0)).into();
        for record in records {
            counts.statements += 1;
            *match record.as_printed.finding.status.as_str() {
                "proved" => &mut counts.proved,
                "refuted" => &mut counts.refuted,
                "undecided" => &mut counts.undecided,
                "not-formal" => &mut counts.not_formal,
                _ => &mut counts.not_applicable,
            } += 1;
            counts.in_every_degree += usize::from(record.is_of_every_degree());
            if record.as_printed.finding.is_refuted() {
                let Refutations { by_severity, by_cause } = &mut counts.refutations;
                *by_severity.entry(record.severity.map_or(UNASSIGNED, Severity::name)).or_default() += 1;
                *by_cause.entry(record.cause.map_or(UNASSIGNED, |cause| cause.name())).or_default() += 1;
            }
        }
        counts
    }

    /// `72 statements: 43 proved, 29 refuted (5 serious, 4 reading, 14 hypothesis, 6 slip)`.
    #[must_use]
    pub fn words(&self) -> String {
        let parts = [
            (self.proved, "proved".to_owned()),
            (self.refuted, format!("refuted{}", self.by_severity())),
            (self.undecided, "undecided".to_owned()),
            (self.not_formal, "not-formal".to_owned()),
            (self.not_applicable, "not-applicable".to_owned()),
        ];
        let parts: Vec<_> = parts
            .iter()
            .filter(|(count, _)| *count > 0)
            .map(|(count, words)| format!("{count} {words}"))
            .collect();
        let noun = if self.statements == 1 { "statement" } else { "statements" };
        format!("{} {noun}: {}", self.statements, parts.join(", "))
    }

    /// ` (5 serious, 4 reading, …)`, the worst first; nothing if nothing is refuted.
    fn by_severity(&self) -> String {
        let names = Severity::ALL.iter().rev().map(|severity| severity.name()).chain([UNASSIGNED]);
        let counts = names.filter_map(|name| Some((name, *self.refutations.by_severity.get(name)?)));
        let words: Vec<_> =
            counts.filter(|(_, count)| *count > 0).map(|(name, count)| format!("{count} {name}")).collect();
        if words.is_empty() { String::new() } else { format!(" ({})", words.join(", ")) }
    }
}
