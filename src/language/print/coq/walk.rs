//! What is bound, assumed and needed on the way to a conclusion.

use std::collections::BTreeMap;

use super::super::super::syntax::{Definition, Name, Range};
use super::number::Linear;

/// A sentence in Coq.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Proposition {
    /// What it says.
    pub says: String,
    /// That all exists that it names; `None` if the hypotheses say so themselves.
    pub defined: Option<String>,
}

/// What the theory has no term for, in words.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("no term of the theory says {0}")]
pub struct NotInCoq(pub String);

pub(super) type Text = Result<String, NotInCoq>;

pub(super) fn not_in_coq<T>(what: impl Into<String>) -> Result<T, NotInCoq> {
    Err(NotInCoq(what.into()))
}

/// One step on the way to the conclusion.
#[derive(Debug, Clone)]
pub(super) enum Step {
    /// `forall … ,`
    Bind(String),
    /// `… ->`
    Assume(String),
    /// What has to be so for the next steps to make sense.
    Need(String),
}

pub(super) struct Walk<'a> {
    pub(super) definitions: &'a [Definition],
    /// Definitions that are being put in: one within itself is a recursion.
    pub(super) open: Vec<Name>,
    pub(super) integers: BTreeMap<Name, Linear>,
    pub(super) reals: BTreeMap<Name, String>,
    /// All names of Coq that are bound.
    pub(super) names: Vec<String>,
    /// r, or that of another index.
    pub(super) ratio: String,
    pub(super) steps: Vec<Step>,
}

impl Walk<'_> {
    pub(super) fn bind(&mut self, names: String) {
        self.steps.push(Step::Bind(names));
    }

    pub(super) fn assume(&mut self, formula: String) {
        self.steps.push(Step::Assume(formula));
    }

    /// Asks for what has to be so, unless it is assumed already.
    pub(super) fn need(&mut self, formula: String) {
        let known = |step: &Step| matches!(step, Step::Assume(own) | Step::Need(own) if *own == formula);
        if !self.steps.iter().any(known) {
            self.steps.push(Step::Need(formula));
        }
    }

    /// a ≤ b as numbers of the theory; `None` where that is so whatever the names.
    pub(super) fn at_most(&self, a: &Linear, b: &Linear) -> Option<String> {
        let difference = b.clone().added(&a.negated());
        let (low, high) = difference.sides();
        (low != "0").then(|| format!("({low} <= {high})%N"))
    }

    pub(super) fn need_at_most(&mut self, a: &Linear, b: &Linear) {
        if let Some(formula) = self.at_most(a, b) {
            self.need(formula);
        }
    }

    /// Both texts, from the steps.
    pub(super) fn proposition(&self, conclusion: &str) -> Proposition {
        let mut says = String::new();
        for step in &self.steps {
            match step {
                Step::Bind(names) => says += &format!("forall {names},\n  "),
                Step::Assume(formula) => says += &format!("{formula} ->\n  "),
                Step::Need(_) => {}
            }
        }
        says += conclusion;
        let last = self.steps.iter().rposition(|step| matches!(step, Step::Need(_)));
        let defined = last.map(|last| {
            let mut text = String::new();
            let mut closing = 0;
            for (at, step) in self.steps[..=last].iter().enumerate() {
                match (step, self.steps[..=last].get(at + 1)) {
                    (Step::Bind(names), _) => text += &format!("forall {names},\n  "),
                    (Step::Assume(formula), _) => text += &format!("{formula} ->\n  "),
                    (Step::Need(formula), None) => text += formula,
                    (Step::Need(formula), Some(Step::Need(_))) => text += &format!("{formula} /\\ "),
                    (Step::Need(formula), Some(_)) => {
                        text += &format!("{formula} /\\ (");
                        closing += 1;
                    }
                }
            }
            text + &")".repeat(closing)
        });
        Proposition { says, defined }
    }

    /// A name of Coq that is not bound yet, for a name of the language.
    pub(super) fn fresh(&mut self, name: &Name) -> String {
        let mut own = name.to_string();
        while self.names.contains(&own) {
            own.push('\'');
        }
        self.names.push(own.clone());
        own
    }

    /// Forgets a real name that was bound.
    pub(super) fn unbind(&mut self, name: &Name, own: &str, before: Option<String>) {
        match before {
            Some(before) => _ = self.reals.insert(name.clone(), before),
            None => _ = self.reals.remove(name),
        }
        self.names.retain(|bound| bound != own);
    }

    /// What is made within a range of integers; what it needs, it needs for each of them.
    pub(super) fn scoped<T>(
        &mut self,
        range: &Range,
        (from, to): (&Linear, &Linear),
        make: impl FnOnce(&mut Self) -> Result<T, NotInCoq>,
    ) -> Result<(String, T), NotInCoq> {
        let name = self.fresh(&range.name);
        let own = Linear::name(&name);
        let before = self.integers.insert(range.name.clone(), own.clone());
        let ends: Vec<_> = [self.at_most(from, &own), self.at_most(&own, to)].into_iter().flatten().collect();
        let made = self.under(&format!("{name} : nat"), &ends, make)?;
        match before {
            Some(before) => _ = self.integers.insert(range.name.clone(), before),
            None => _ = self.integers.remove(&range.name),
        }
        self.names.retain(|bound| *bound != name);
        Ok((name, made))
    }

    /// The same under a name, if there is one, and assumptions: what is needed becomes one need.
    pub(super) fn under<T>(
        &mut self,
        name: &str,
        assumed: &[String],
        make: impl FnOnce(&mut Self) -> Result<T, NotInCoq>,
    ) -> Result<T, NotInCoq> {
        let outside = self.steps.len();
        self.steps.extend(assumed.iter().cloned().map(Step::Assume));
        let inside = self.steps.len();
        let made = make(self)?;
        let needs: Vec<String> = self
            .steps
            .drain(outside..)
            .skip(inside - outside)
            .map(|step| match step {
                Step::Need(formula) | Step::Assume(formula) | Step::Bind(formula) => formula,
            })
            .collect();
        if !needs.is_empty() {
            let forall = if name.is_empty() { String::new() } else { format!("forall {name}, ") };
            let assumed: String = assumed.iter().map(|one| format!("{one} -> ")).collect();
            self.need(format!("({forall}{assumed}{})", needs.join(" /\\ ")));
        }
        Ok(made)
    }
}
