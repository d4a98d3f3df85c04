//! The errors of one formula at one case, against exact numbers.

use std::cmp::Ordering;

use num_traits::{Signed, Zero};

use super::super::member::MemberAt;
use super::super::point;
use super::super::power::{exponent, power};
use super::method::Method;
use super::probe::Probe;
use crate::scalar::{BigRational, exact_value, integer, ulp};

/// An error in units in the last place. What is no number is worse than every number.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub enum Ulps {
    /// So many, exactly.
    Number(BigRational),
    /// The result is infinite or NaN.
    NotFinite,
}

/// What is wrong with the k + 1 values of a case. All numbers are exact.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Errors {
    /// For every function that lives on the span, by rising index: |float − exact| in units in the last place of the
    /// exact value ([`ulp`]). Where a finite float stands for an exact value that is 0 or below 2⁻⁹⁰⁰, next to underflow, it
    /// is 0 here: such values count by their signs and their absolute errors, and by `left_out` and `beside`.
    pub ulps: Vec<Ulps>,
    /// How many exact values are not 0 and below 2⁻⁹⁰⁰.
    pub left_out: usize,
    /// The largest |float − exact| of finite floats for those, and for values that are 0.
    pub beside: BigRational,
    /// The largest |float − exact| of the finite ones.
    pub absolute: BigRational,
    /// |Σ floats − Σ exact values|, if all are finite. In [t_k, t_{n+1}] the exact sum is 1.
    pub sum: Option<BigRational>,
    /// How many values have not the sign of the exact one.
    pub signs: usize,
    /// The index of the first function of the span.
    pub first: usize,
}

impl Errors {
    /// The errors of a formula at a case.
    ///
    /// # Panics
    /// If the point of the case is not on its span, or that is none of its basis.
    #[must_use]
    pub fn of(formula: Method, case: &Probe) -> Self {
        let exact = Exact::of(case);
        exact.errors(&formula.values(case))
    }

    /// The largest error in units in the last place, and the function.
    #[must_use]
    pub fn worst(&self) -> Option<(&Ulps, usize)> {
        self.ulps.iter().zip(self.first..).max_by(|a, b| a.0.cmp(b.0))
    }

    /// How many results are infinite or NaN.
    #[must_use]
    pub fn not_finite(&self) -> usize {
        self.ulps.iter().filter(|ulps| **ulps == Ulps::NotFinite).count()
    }

    /// Is all of this within what is proved of the formula, where something is?
    pub(super) fn keep(&self, formula: Method, degree: usize) -> bool {
        let Some(bound) = formula.bound(degree).and_then(exact_value).map(Ulps::Number) else { return true };
        let beside = exact_value(power(BESIDE)).is_some_and(|most| self.beside <= most);
        let signs = self.signs == 0 || !formula.keeps_signs();
        self.worst().is_none_or(|(worst, _)| *worst <= bound) && beside && signs
    }
}

/// The exact values of a case, computed once for all formulas.
#[derive(Debug, Clone)]
pub(super) struct Exact {
    first: usize,
    /// Entry c of the floats that belongs to the first one.
    offset: usize,
    values: Vec<BigRational>,
    /// The least value that an error is measured against.
    least: BigRational,
}

/// Values below 2 to this power are next to underflow: relative bounds do not hold for them.
const LEAST: i32 = -900;
/// Every formula with a proved bound has errors of at most 2 to this power in values below 2^`LEAST`, and in those that
/// are 0: `docs/float.md`.
const BESIDE: i32 = -940;

impl Exact {
    pub(super) fn of(case: &Probe) -> Self {
        let x = exact_value(case.x).unwrap_or_else(|| integer(0));
        // The knots in f64 are those of the exact basis, and so are the spans.
        let active = case.exact(&x).unwrap_or_else(|| unreachable!("x is a point of the closed span"));
        let offset = (active.first() + case.basis.degree()).saturating_sub(case.span.index());
        let least = exact_value(power(LEAST)).unwrap_or_else(|| integer(0));
        Self { first: active.first(), offset, values: active.values().to_vec(), least }
    }

    pub(super) fn errors(&self, floats: &[f64]) -> Errors {
        let mut found = Errors {
            ulps: Vec::with_capacity(self.values.len()),
            left_out: 0,
            beside: BigRational::zero(),
            absolute: BigRational::zero(),
            sum: Some(BigRational::zero()),
            signs: 0,
            first: self.first,
        };
        for (exact, &float) in self.values.iter().zip(&floats[self.offset..]) {
            let right = match exact.cmp(&BigRational::zero()) {
                Ordering::Equal => float == 0.0,
                Ordering::Greater => float > 0.0,
                Ordering::Less => float < 0.0,
            };
            found.signs += usize::from(!right);
            let counts = exact.abs() >= self.least;
            found.left_out += usize::from(!counts && !exact.is_zero());
            let Some(float) = exact_value(float) else {
                (found.sum, _) = (None, found.ulps.push(Ulps::NotFinite));
                continue;
            };
            let error = float - exact;
            found.sum = found.sum.map(|sum| sum + &error);
            let error = error.abs();
            if counts {
                found.ulps.push(Ulps::Number(&error / ulp(exact)));
            } else {
                found.ulps.push(Ulps::Number(BigRational::zero()));
                found.beside = found.beside.max(error.clone());
            }
            found.absolute = found.absolute.max(error);
        }
        found.sum = found.sum.map(|sum| sum.abs());
        found
    }
}

/// The largest error of a formula at a case in units in the last place, nearly: against values of about 100 bits; infinite
/// where a result is no number. What the search for bad cases climbs by; nothing that is reported.
pub(super) fn estimate(formula: Method, case: &Probe) -> f64 {
    let exact = match &case.member {
        Some(member) => {
            point::by_terms(case.basis.degree(), &MemberAt { member, span: case.span, x: case.x })
        }
        None => point::unrounded(&case.basis, case.span, case.x),
    };
    let existing = case.basis.existing(case.span);
    let floats = formula.values(case);
    let error = |c: usize| {
        let pair = exact[c];
        if !floats[c].is_finite() {
            return f64::INFINITY;
        }
        if pair.hi.abs() < power(LEAST) {
            return 0.0;
        }
        ((floats[c] - pair.hi) - pair.lo).abs() / power(exponent(pair.hi) - 52)
    };
    existing.map(error).fold(0.0, f64::max)
}
