//! What the statements about the paper's examples have in common: an example with its terms and its sections.

use std::ops::RangeInclusive;

use crate::claims::instances::{Instance, instances_named};

use super::place::Place;

/// What the letter r means where α is not restricted.
pub(super) const ALPHA: &str = "r stands for every α of the paper; r = 1 is α = ∞.";

/// The instances of these names.
pub(super) fn all(names: &[&str]) -> Vec<Instance> {
    names.iter().flat_map(|name| instances_named(name)).collect()
}

/// Those of the instances of these names that have one of the degrees.
pub(super) fn of_degree(names: &[&str], degrees: &[usize]) -> Vec<Instance> {
    let mut instances = all(names);
    instances.retain(|instance| degrees.contains(&instance.degree));
    instances
}

/// An instance with what its goals are made of.
pub(super) struct Example<'a> {
    pub(super) instance: &'a Instance,
    pub(super) k: usize,
    pub(super) n: usize,
}

impl<'a> Example<'a> {
    pub(super) fn new(instance: &'a Instance) -> Self {
        Self { instance, k: instance.degree, n: instance.knots.m() - instance.degree - 1 }
    }

    /// The indices of the spans that are not empty.
    pub(super) fn spans(&self) -> Vec<usize> {
        self.instance.knots.spans().map(|span| span.index()).collect()
    }

    /// The functions that live on a span.
    pub(super) fn living(&self, span: usize) -> RangeInclusive<usize> {
        span.saturating_sub(self.k)..=span.min(self.n)
    }

    /// G_i at a place.
    pub(super) fn function(&self, i: usize, place: Place) -> String {
        place.value("G", i, self.k)
    }

    /// One coordinate of the curve at a place.
    pub(super) fn coordinate(&self, c: usize, place: Place) -> String {
        let points = self.instance.points.as_deref().unwrap_or_default();
        let term = |i: usize| {
            let number = points.get(i).and_then(|point| point.get(c)).cloned().unwrap_or_default();
            format!("(* {number} {})", self.function(i, place))
        };
        let terms: Vec<_> = self.living(place.span()).map(term).collect();
        format!("(+ {})", terms.join(" "))
    }

    /// A section with these goals on the knots of the instance, α unrestricted or as said.
    pub(super) fn section(&self, alpha: &str, goals: &str) -> String {
        if goals.is_empty() {
            return String::new();
        }
        let knots: Vec<_> = self.instance.knots.knots().iter().map(ToString::to_string).collect();
        // The section belongs to one degree of the statement: for any other it is not there.
        format!(
            "(section (each a {0} k) (each b k {0}) {alpha} (knots A 0 {1}) (goals {goals}))",
            self.k,
            knots.join(" ")
        )
    }
}

/// Sections for every instance, with goals made for each.
pub(super) fn sections(
    instances: &[Instance],
    alpha: &str,
    goals: impl Fn(&Example<'_>) -> String,
) -> String {
    instances.iter().map(Example::new).map(|on| on.section(alpha, &goals(&on))).collect()
}

/// A goal for every span.
pub(super) fn on_spans(goal: impl Fn(&Example<'_>, usize) -> String) -> impl Fn(&Example<'_>) -> String {
    move |on| on.spans().into_iter().map(|span| goal(on, span)).collect()
}
