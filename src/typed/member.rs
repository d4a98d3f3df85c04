//! A family, and what is set of its parameters.

use std::sync::Arc;

use crate::language::{Family, families};
use crate::meaning::{Values, Weighting};

use super::error::TypedError;
use super::lists::numbers;
use super::provenance::Provenance;

/// A family, and what is set of its parameters.
#[derive(Debug, Clone)]
pub struct ChosenFamily {
    /// The family.
    pub family: Arc<Family>,
    /// Its parameters by their names, or what it reads in their place.
    pub given: Vec<(String, Values)>,
}

/// The family of that name, of those that come with the program.
///
/// # Errors
/// [`TypedError::UnknownFamily`].
pub fn family_named(name: &str) -> Result<Arc<Family>, TypedError> {
    let found = families().iter().find(|family| family.name == name);
    found.map(Arc::clone).ok_or_else(|| {
        let names = families().iter().map(|family| family.name.clone()).collect();
        TypedError::UnknownFamily { name: name.to_owned(), names }
    })
}

impl ChosenFamily {
    /// The family with settings such as `q=1/3`, `omega=1,2,1/2` or `rho=1,2;3`.
    ///
    /// # Errors
    /// [`TypedError`] for the first setting that is not written as one.
    pub fn new(family: Arc<Family>, settings: &[String]) -> Result<Self, TypedError> {
        let mut given: Vec<(String, Values)> = Vec::new();
        for setting in settings {
            let (name, text) = setting.split_once('=').ok_or_else(|| TypedError::Setting(setting.clone()))?;
            let name = name.trim().split('[').next().unwrap_or_default().trim().to_owned();
            if given.iter().any(|(other, _)| *other == name) {
                return Err(TypedError::SetTwice(name));
            }
            if matches!(text.trim(), "symbolic" | "all") {
                return Err(TypedError::Letter { name, value: text.trim().to_owned() });
            }
            let values = values(text, &family, &name)?;
            given.push((name, values));
        }
        Ok(Self { family, given })
    }

    /// The member, with a number for every parameter.
    ///
    /// # Errors
    /// [`TypedError::Member`] with what is missing or wrong.
    pub fn member(&self) -> Result<Weighting, TypedError> {
        let wrong = |error| TypedError::Member { argument: "--set", error };
        Weighting::of(&self.family, &self.given).map_err(wrong)
    }
}

fn values(text: &str, family: &Family, name: &str) -> Result<Values, TypedError> {
    let place = Provenance::option("--set");
    let parts: Vec<_> = text.split(';').collect();
    let at = |at| if parts.len() > 1 { place.clone().at(at) } else { place.clone() };
    let rows = parts.iter().enumerate().map(|(row, text)| numbers(text, &at(row)));
    Ok(Values::shaped(rows.collect::<Result<_, _>>()?, family, name))
}
