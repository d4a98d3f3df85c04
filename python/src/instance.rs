//! The paper's instances, and the families there are.

use knotproof::cli::CliError;
use knotproof::language;
use knotproof::meaning::{examples, examples_named};
use knotproof::scalar::BigRational;
use pyo3::prelude::*;

use crate::error::Wrong;

/// An instance: degree, knots, the values of α, control points.
type Instance = (usize, Vec<BigRational>, Vec<String>, Option<Vec<Vec<BigRational>>>);

/// The paper's instance of a name; of several degrees the one asked for.
#[pyfunction]
pub(crate) fn instance(name: &str, degree: Option<usize>) -> Result<Instance, Wrong> {
    let known = examples_named(name);
    if known.is_empty() {
        let mut names: Vec<_> = examples().iter().map(|example| example.name.to_string()).collect();
        names.dedup();
        return Err(Wrong::with(
            "name",
            format!("`{name}` is no instance of the paper ({})", names.join(", ")),
        ));
    }
    let place = match degree {
        _ if known.len() == 1 => Some(0),
        Some(degree) => known.iter().position(|example| example.degree == degree),
        None => None,
    };
    let Some(place) = place else {
        let degrees = known.iter().map(|example| example.degree).collect();
        return Err(CliError::Degree { argument: "degree", name: name.to_owned(), degrees }.into());
    };
    let chosen = &known[place];
    let alpha = chosen.indices().map(ToString::to_string).collect();
    Ok((degree.unwrap_or(chosen.degree), chosen.knots.knots().to_vec(), alpha, chosen.points.clone()))
}

/// Each family that comes with the program: its name, what it is, its parameters.
#[pyfunction]
pub(crate) fn families() -> Vec<(String, String, Vec<String>)> {
    let all = language::families().iter().map(|family| {
        let heads = family.parameters.iter().map(|parameter| parameter.head().to_string()).collect();
        (family.name.clone(), family.title.clone(), heads)
    });
    all.collect()
}
