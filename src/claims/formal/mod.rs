//! The claims once more, in the formal language of certificates (`proofs/FORMAT.md`).
//!
//! A claim in words is judged by its conclusion on finitely many cases. Here is what is to be proved of it, for every
//! knot vector and every α, or for every α, or of a witness that refutes it: goals about a window on a knot vector, and the reason why they are the
//! claim. Nothing here proves anything: a prover looks for proofs of the goals, and a checker that knows neither
//! reads them.

use std::ops::RangeInclusive;

mod action;
mod approximation;
mod basis;
mod captions;
mod classical;
mod curve;
mod curve_ends;
mod definitions;
mod derivatives;
mod deviation;
mod effect;
mod example;
mod illustrated_bases;
mod illustrated_curves;
mod influence;
mod maximum;
mod place;
mod proofs_steps;
mod questions;
mod refutations;
mod single_spans;
mod symmetric_curves;
mod traces;
mod two_maxima;
mod weight;
mod weight_effect;

use super::verdict::{Scope, Witness};

/// A statement of the formal language about a claim.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Formal {
    /// How far it reaches.
    pub scope: Scope,
    /// The degrees, rising.
    pub degrees: Vec<usize>,
    /// Why the goals are the claim.
    pub because: String,
    /// The sections: windows and goals.
    pub sections: String,
}

impl Formal {
    /// A statement, with its reason put on one line.
    fn new(scope: Scope, degrees: Vec<usize>, because: &str, sections: String) -> Self {
        let because = because.split_whitespace().collect::<Vec<_>>().join(" ");
        Self { scope, degrees, because, sections }
    }

    /// A statement about every knot vector and every α.
    fn on_all_knots(degrees: RangeInclusive<usize>, because: &str, sections: &[&str]) -> Self {
        Self::new(Scope::Knots, degrees.collect(), because, sections.concat())
    }

    /// A statement about every α, on the knots of some examples.
    fn on_all_indices(degrees: &[usize], because: &str, sections: String) -> Self {
        Self::new(Scope::Alpha, degrees.to_vec(), because, sections)
    }
}

/// What is to be proved of a claim, as printed or as amended; `None` if that is not stated formally.
#[must_use]
pub fn formal(claim: &str, amended: bool) -> Option<Formal> {
    let parts = [
        classical::formal,
        weight::formal,
        weight_effect::formal,
        definitions::formal,
        basis::formal,
        derivatives::formal,
        curve::formal,
        curve_ends::formal,
        illustrated_bases::formal,
        illustrated_curves::formal,
        traces::formal,
        maximum::formal,
        deviation::formal,
        symmetric_curves::formal,
        effect::formal,
        influence::formal,
        captions::formal,
        proofs_steps::formal,
        questions::formal_for_all,
        two_maxima::formal_for_all,
        action::formal_for_all,
        approximation::formal_for_all,
    ];
    parts.iter().find_map(|part| part(claim, amended))
}

/// What is to be proved of a claim for one degree; `None` if that is not stated formally.
#[must_use]
pub fn formal_for_degree(claim: &str, degree: usize) -> Option<Formal> {
    let parts = [
        questions::formal,
        maximum::formal_for_degree,
        two_maxima::formal,
        action::formal,
        approximation::formal,
    ];
    parts.iter().find_map(|part| part(claim, degree))
}

/// What refutes a claim, with the witness that was found; `None` if that is not stated formally.
#[must_use]
pub fn refutation(claim: &str, witness: &Witness) -> Option<Formal> {
    refutations::refutation(claim, witness)
}
