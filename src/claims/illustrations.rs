//! Section 5: what the paper says about its illustrations, judged on the very examples it shows.

use std::convert::Infallible;

use crate::analysis::{Enclosure, Piece, supremum};
use crate::scalar::rational;
use crate::spline::{Basis, Index};

use super::case::{BasisCase, Case, Origin};
use super::instances::{Instance, instances_named};
use super::verdict::{Judgement, Ledger, Stop, Witness};

/// One or more of the paper's instances that a statement speaks of together.
#[derive(Debug)]
pub struct Illustration {
    /// The instances, each with the indices to be looked at.
    pub instances: Vec<Instance>,
}

impl Case for Illustration {
    type Hypothesis = Infallible;

    fn origin(&self) -> Origin {
        Origin::Paper
    }
    fn meets(&self, hypothesis: &Infallible) -> bool {
        match *hypothesis {}
    }
    fn degree(&self) -> Option<usize> {
        self.instances.first().map(|instance| instance.degree)
    }
    fn instances(&self) -> usize {
        self.instances.iter().map(|instance| instance.indices.len()).sum()
    }
}

/// The instances of these names, each by itself.
pub(super) fn each(names: &[&str]) -> Vec<Illustration> {
    let instances = names.iter().flat_map(|name| instances_named(name));
    instances.map(|instance| Illustration { instances: vec![instance] }).collect()
}

/// The instances of these names, all together.
pub(super) fn together(names: &[&str]) -> Vec<Illustration> {
    vec![Illustration { instances: names.iter().flat_map(|name| instances_named(name)).collect() }]
}

/// Those of the illustrations that have the degree.
pub(super) fn of_degree(mut illustrations: Vec<Illustration>, degrees: &[usize]) -> Vec<Illustration> {
    for illustration in &mut illustrations {
        illustration.instances.retain(|instance| degrees.contains(&instance.degree));
    }
    illustrations.retain(|illustration| !illustration.instances.is_empty());
    illustrations
}

/// The same illustrations with other indices.
pub(super) fn with_indices(mut illustrations: Vec<Illustration>, indices: &[&str]) -> Vec<Illustration> {
    for illustration in &mut illustrations {
        for instance in &mut illustration.instances {
            instance.indices = indices.iter().filter_map(|text| text.parse().ok()).collect();
        }
    }
    illustrations
}

/// The basis of an instance for one index.
pub(super) fn case_of(instance: &Instance, index: &Index) -> BasisCase {
    match Basis::new(instance.knots.clone(), instance.degree, index.clone()) {
        Ok(basis) => BasisCase::new(basis, Origin::Paper),
        Err(error) => unreachable!("a test builds every instance: {error}"),
    }
}

/// Judges a conclusion about a basis for every instance and index.
pub(super) fn every_basis(
    conclusion: impl Fn(&BasisCase, &mut Ledger) -> Judgement + Send + Sync + 'static,
) -> impl Fn(&Illustration, &mut Ledger) -> Judgement + Send + Sync + 'static {
    move |illustration, ledger| {
        for instance in &illustration.instances {
            for index in &instance.indices {
                conclusion(&case_of(instance, index), ledger).map_err(|stop| named(instance, stop))?;
            }
        }
        Ok(())
    }
}

/// Puts the instance's name in front of a witness.
pub(super) fn named(instance: &Instance, stop: Stop) -> Stop {
    match stop {
        Stop::Refuted(mut witness) => {
            witness.given.insert(0, ("instance".to_owned(), instance.name.to_owned()));
            Stop::Refuted(witness)
        }
        other => other,
    }
}

/// A counterexample in an instance; `at` names the index and the place.
pub(super) fn refuted(instance: &Instance, at: &[(&str, String)], claimed: String, found: String) -> Stop {
    let mut given = vec![
        ("instance".to_owned(), instance.name.to_owned()),
        ("k".to_owned(), instance.degree.to_string()),
        ("U".to_owned(), instance.knots.to_string()),
    ];
    given.extend(at.iter().map(|(name, value)| ((*name).to_owned(), value.clone())));
    Stop::Refuted(Box::new(Witness { given, claimed, found, reproduce: None }))
}

/// A certified enclosure of the supremum of non-negative functions on closed spans, no wider than 1/1000.
pub(super) fn largest(functions: &[Piece]) -> Result<Enclosure, Stop> {
    supremum(functions, &rational(1, 1000)).map_err(|error| Stop::Fault(error.to_string()))
}

/// Does the engine refute the conclusion on the examples? For tests of deliberately false variants of claims.
#[cfg(test)]
pub(super) fn refutes(
    examples: Vec<Illustration>,
    conclusion: impl Fn(&Illustration, &mut Ledger) -> Judgement + Send + Sync + 'static,
) -> bool {
    let statement = super::statement::Statement::new("", conclusion);
    matches!(super::statement::judge(&statement, &examples), Ok(super::verdict::Verdict::Refuted(_)))
}
