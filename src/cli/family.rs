//! The arguments that choose a member of a family.

use std::ffi::OsString;
use std::path::Path;
use std::sync::Arc;

use crate::language::Family;
use crate::typed::{ChosenFamily, family_named};

use super::error::CliError;
use super::file::read;
use super::offered::family_name;
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
        Ok(Some(ChosenFamily::new(family, &self.set)?))
    }
}

/// The family of a name, or of a file.
///
/// # Errors
/// [`CliError::Typed`] for neither; [`CliError::Claim`] with all that is wrong in the file.
pub fn find(name: &OsString) -> Result<Arc<Family>, CliError> {
    let path = Path::new(name);
    let known = family_named(&path.display().to_string());
    if known.is_ok() || !path.exists() {
        return Ok(known?);
    }
    let text = read("--family", path)?;
    let family = Family::read(&visible_path(path), &text);
    family.map(Arc::new).map_err(|complaints| CliError::Claim { argument: "--family", complaints })
}
