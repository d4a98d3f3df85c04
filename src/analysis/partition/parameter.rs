//! What the family's t in (0, 1) stands for.

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::Signed;

use crate::analysis::algebraic::Algebraic;
use crate::analysis::piece::constant;
use crate::analysis::roots::IsolatedRoot;
use crate::scalar::{Polynomial, RationalAlgebra, RationalFunction, Ring, integer};

/// The parameter x that t stands for.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Parameter {
    /// x = t.
    Identity,
    /// x = 1/t.
    Reciprocal,
    /// x = start + t·length, length > 0.
    Affine { start: BigRational, length: BigRational },
}

impl Parameter {
    /// The interval of x for t in [lo, hi], with `None` for ∞.
    pub(super) fn interval(&self, lo: &BigRational, hi: &BigRational) -> (BigRational, Option<BigRational>) {
        match self {
            Self::Identity => (lo.clone(), Some(hi.clone())),
            Self::Reciprocal => (hi.recip(), (!lo.is_zero()).then(|| lo.recip())),
            Self::Affine { start, length } => (start + lo * length, Some(start + hi * length)),
        }
    }

    /// x for an irrational t > 0.
    pub(super) fn number(&self, t: IsolatedRoot) -> Algebraic {
        let variable = || RationalFunction::variable(&integer(1));
        let function = match self {
            Self::Identity => variable(),
            Self::Reciprocal => match variable().reciprocal() {
                Some(reciprocal) => reciprocal,
                None => unreachable!("the variable is not 0"),
            },
            Self::Affine { start, length } => {
                constant(start.clone()).plus(&variable().times(&constant(length.clone())))
            }
        };
        Algebraic::at(function, t)
    }

    /// The length of that interval, for lo > 0.
    pub(super) fn distance(&self, lo: &BigRational, hi: &BigRational) -> BigRational {
        match self {
            Self::Identity => hi - lo,
            Self::Reciprocal => (hi - lo) / (lo * hi),
            Self::Affine { length, .. } => (hi - lo) * length,
        }
    }

    /// Integer polynomials in x, lowest coefficient first, that are the given ones in t times one function > 0.
    pub(super) fn polynomials(&self, given: &[Polynomial<BigInt>]) -> Vec<Vec<BigInt>> {
        let degree = given.iter().map(Polynomial::degree).max().unwrap_or(0);
        match self {
            Self::Identity => given.iter().map(|p| p.coefficients().to_vec()).collect(),
            Self::Reciprocal => given.iter().map(|p| p.reversed(degree).coefficients().to_vec()).collect(),
            Self::Affine { start, length } => {
                let t = Polynomial::new(-(start / length), [length.recip()]);
                let substituted: Vec<_> = given.iter().map(|p| substitute(p, &t)).collect();
                integers(&substituted)
            }
        }
    }
}

/// p(t) for a polynomial t, by Horner's rule.
fn substitute(p: &Polynomial<BigInt>, t: &Polynomial<BigRational>) -> Polynomial<BigRational> {
    let coefficients = p.coefficients().iter().rev();
    coefficients.fold(t.zero(), |value, c| value.times(t).plus(&Polynomial::constant(c.clone().into())))
}

/// One positive multiple of all, with integer coefficients that have no common factor.
fn integers(polynomials: &[Polynomial<BigRational>]) -> Vec<Vec<BigInt>> {
    let all = || polynomials.iter().flat_map(|p| p.coefficients());
    let common = all().fold(BigInt::from(1), |common, c| common.lcm(c.denom()));
    let content = all().fold(BigInt::default(), |content, c| content.gcd(&(c * &common).to_integer()));
    let integer = |c: &BigRational| {
        let scaled = (c * &common).to_integer();
        if content.is_positive() { scaled / &content } else { scaled }
    };
    polynomials.iter().map(|p| p.coefficients().iter().map(integer).collect()).collect()
}
