//! What refutes a claim, as goals about the witness that the engine found.

mod approximation;
mod basis;
mod found;
mod illustrations;
mod influence;
mod maximum;
mod proofs_steps;
mod questions;
mod sentences;
mod weight;

use crate::claims::verdict::{Scope, Witness};

use super::Formal;
use found::Found;

/// What refutes the claim: the reason and the sections.
type Refuted = Option<(&'static str, String)>;

pub(super) fn refutation(claim: &str, witness: &Witness) -> Option<Formal> {
    let found = Found::new(witness);
    let of_basis = |found| {
        let parts = [
            sentences::refutation,
            basis::refutation,
            maximum::refutation,
            illustrations::refutation,
            influence::refutation,
            proofs_steps::refutation,
            questions::refutation,
            basis::refutation,
            maximum::refutation,
            illustrations::refutation,
            questions::refutation,
            approximation::refutation,
        ];
        parts.iter().find_map(|part| part(claim, found))
    };
    // The witness of a claim about the weight alone has no basis.
    let (because, sections) =
        weight::refutation(claim, witness).or_else(|| found.as_ref().and_then(of_basis))?;
    let degree = found.as_ref().map_or(1, Found::k);
    Some(Formal::new(Scope::Instance, vec![degree], because, sections))
}
