//! The weights that a certificate is about: rise : fall of a family, with its parameters as unknowns, or any at all.

use std::sync::Arc;

use num_traits::{Signed, Zero};

use crate::language::{Family, Name, Relation, canonical_family};
use crate::scalar::BigRational;

use super::sexp::Sexp;

/// The sign of a parameter.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Class {
    /// Any real number.
    Real,
    /// ≥ 0.
    Nonnegative,
    /// > 0.
    Positive,
}

/// Which weights a statement is about.
#[derive(Debug, Clone, PartialEq)]
pub enum Weighted {
    /// Those of all members of a family.
    Family(Arc<Family>),
    /// Any functions that rise from 0 to 1 on their interval, and are between them inside.
    Any,
}

impl Weighted {
    /// As a certificate says it: `(family …)`; or what it can't say.
    ///
    /// # Errors
    /// As [`canonical_family`].
    pub fn to_sexp(&self) -> Result<Sexp, Name> {
        match self {
            Self::Any => Ok(Sexp::form("family", [Sexp::name("any")])),
            Self::Family(family) => {
                let all = Sexp::parse_all(&canonical_family(family)?);
                all.ok().and_then(|all| all.into_iter().next()).ok_or_else(|| family.name.as_str().into())
            }
        }
    }

    /// Are they those of an index?
    pub(super) fn is_mobius(&self) -> bool {
        matches!(self, Self::Family(family) if matches!(family.moebius(), Some(Some(_))))
    }

    /// Those parameters that are one number, with their signs.
    pub(super) fn single(&self) -> Vec<(&Name, Class)> {
        let Self::Family(family) = self else { return Vec::new() };
        let single = family.parameters.iter().filter(|own| own.indices.is_empty());
        single.filter_map(|own| Some((&own.name, self.class(&own.name)?))).collect()
    }

    /// The sign of a parameter, as its bounds show it.
    pub(super) fn class(&self, name: &str) -> Option<Class> {
        let Self::Family(family) = self else { return None };
        let own = family.parameters.iter().find(|own| *own.name == *name)?;
        let of = |(relation, bound): &(Relation, BigRational)| match relation {
            Relation::Greater if !bound.is_negative() => Class::Positive,
            Relation::AtLeast | Relation::Equal if bound.is_positive() => Class::Positive,
            Relation::AtLeast | Relation::Equal if Zero::is_zero(bound) => Class::Nonnegative,
            _ => Class::Real,
        };
        Some(own.bounds.iter().map(of).max().unwrap_or(Class::Real))
    }
}
