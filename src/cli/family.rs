//! The arguments that choose a member of a family.

use std::ffi::OsString;
use std::path::Path;
use std::sync::Arc;

use crate::language::{Family, families};
use crate::meaning::{Values, Weighting};

use super::error::CliError;
use super::file::read;
use super::lists::numbers;
use super::offered::family_name;
use super::provenance::Provenance;
use super::visible::visible_path;

/// Which weights the recursion has, if not those of an index.
#[derive(Debug, Clone, Default, clap::Args)]
pub(super) struct FamilyArgs {
    /// A family of splines in place of the one with an index α: a name (`knotproof families` lists them), or a TOML file as in
    /// `knotproof schema family`.
    #[arg(long, value_name = "NAME|FILE", value_parser = family_name(), hide_possible_values = true, conflicts_with = "alpha")]
    family: Option<OsString>,
    /// A parameter of the family: q=1/3; a list omega=1,2,1/2, from i = 0 on; by i and d "rho=1,2;3", a row for each d from 1 on.
    /// May be repeated.
    #[arg(long, value_name = "NAME=VALUES", conflicts_with = "alpha", allow_hyphen_values = true)]
    set: Vec<String>,
}

/// A family, and what is set of its parameters.
#[derive(Debug, Clone)]
pub(super) struct ChosenFamily {
    pub(super) family: Arc<Family>,
    pub(super) given: Vec<(String, Values)>,
}

impl FamilyArgs {
    /// Is none chosen, and nothing set?
    pub(super) fn is_absent(&self) -> bool {
        self.family.is_none() && self.set.is_empty()
    }

    /// The family with its settings, if one is chosen; of a paper its `own`, if parameters alone are set.
    ///
    /// # Errors
    /// [`CliError`] where it is not there or not well formed, or a setting is not.
    pub(super) fn chosen(&self, own: Option<&Arc<Family>>) -> Result<Option<ChosenFamily>, CliError> {
        let family = match (&self.family, own) {
            (Some(name), _) => find(name)?,
            (None, _) if self.set.is_empty() => return Ok(None),
            (None, Some(own)) => Arc::clone(own),
            (None, None) => {
                let purpose = "say whose parameters are set, such as --family lupas --set q=1/3";
                return Err(CliError::Needed { argument: "--family", purpose });
            }
        };
        let mut given: Vec<(String, Values)> = Vec::new();
        for setting in &self.set {
            let (name, text) = setting.split_once('=').ok_or_else(|| CliError::Setting(setting.clone()))?;
            let name = name.trim().split('[').next().unwrap_or_default().trim().to_owned();
            if given.iter().any(|(other, _)| *other == name) {
                return Err(CliError::SetTwice(name));
            }
            if matches!(text.trim(), "symbolic" | "all") {
                return Err(CliError::Letter { name, value: text.trim().to_owned() });
            }
            let values = values(text, &family, &name)?;
            given.push((name, values));
        }
        Ok(Some(ChosenFamily { family, given }))
    }
}

impl ChosenFamily {
    /// The member, with a number for every parameter.
    ///
    /// # Errors
    /// [`CliError::Member`] with what is missing or wrong.
    pub(super) fn member(&self) -> Result<Weighting, CliError> {
        Weighting::of(&self.family, &self.given)
            .map_err(|error| CliError::Member { argument: "--set", error })
    }
}

/// The family of a name, or of a file.
pub(super) fn find(name: &OsString) -> Result<Arc<Family>, CliError> {
    if let Some(family) = families().iter().find(|family| name.to_str() == Some(&family.name)) {
        return Ok(Arc::clone(family));
    }
    let path = Path::new(name);
    if !path.exists() {
        let names = families().iter().map(|family| family.name.clone()).collect();
        return Err(CliError::UnknownFamily { name: path.display().to_string(), names });
    }
    let text = read("--family", path)?;
    let family = Family::read(&visible_path(path), &text);
    family.map(Arc::new).map_err(|complaints| CliError::Claim { argument: "--family", complaints })
}

fn values(text: &str, family: &Family, name: &str) -> Result<Values, CliError> {
    let place = Provenance::option("--set");
    let parts: Vec<_> = text.split(';').collect();
    let at = |at| if parts.len() > 1 { place.clone().at(at) } else { place.clone() };
    let rows = parts.iter().enumerate().map(|(row, text)| numbers(text, &at(row)));
    Ok(Values::shaped(rows.collect::<Result<_, _>>()?, family, name))
}
