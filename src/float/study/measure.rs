//! The errors of one formula at one case, against exact numbers.

use num_traits::{Signed, Zero};

use super::super::point;
use super::super::power::{exponent, power};
use super::case::Case;
use super::formula::Formula;
use crate::scalar::{BigRational, exact_value, integer, ulp};

/// What is wrong with the k + 1 values of a case. All numbers are exact.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Errors {
    /// For every function that lives on the span, by rising index: |float − exact| in units in the last place of the
    /// exact value ([`ulp`]); `None` where the float is infinite or NaN. Where the exact value is 0 or below 2⁻⁹⁰⁰, next to
    /// underflow, it is 0 here: such values count by their absolute errors and their signs.
    pub ulps: Vec<Option<BigRational>>,
    /// The largest |float − exact| of the finite ones.
    pub absolute: BigRational,
    /// |Σ floats − Σ exact values|, if all are finite. In [t_k, t_{n+1}] the exact sum is 1.
    pub sum: Option<BigRational>,
    /// How many values have not the sign of the exact one: not positive where it is, or not 0 where it is.
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
    pub fn of(formula: Formula, case: &Case) -> Self {
        let exact = Exact::of(case);
        exact.errors(&formula.values(case))
    }

    /// The largest error in units in the last place, and the function.
    #[must_use]
    pub fn worst(&self) -> Option<(&BigRational, usize)> {
        let pairs = self.ulps.iter().zip(self.first..).filter_map(|(ulp, i)| Some((ulp.as_ref()?, i)));
        pairs.max_by(|a, b| a.0.cmp(b.0))
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

/// Values below this are next to underflow: relative bounds do not hold for them.
const LEAST: i32 = -900;

impl Exact {
    pub(super) fn of(case: &Case) -> Self {
        let x = exact_value(case.x).unwrap_or_else(|| integer(0));
        let exact = case.basis.exact();
        // The knots in f64 are those of the exact basis, and so are the spans.
        let active = exact.knots().span(case.span.index()).and_then(|span| exact.active(span, &x).ok());
        let active = active.unwrap_or_else(|| unreachable!("x is a point of the closed span"));
        let offset = (active.first() + case.basis.degree()).saturating_sub(case.span.index());
        let least = exact_value(power(LEAST)).unwrap_or_else(|| integer(0));
        Self { first: active.first(), offset, values: active.values().to_vec(), least }
    }

    pub(super) fn errors(&self, floats: &[f64]) -> Errors {
        let mut found = Errors {
            ulps: Vec::with_capacity(self.values.len()),
            absolute: BigRational::zero(),
            sum: Some(BigRational::zero()),
            signs: 0,
            first: self.first,
        };
        for (exact, &float) in self.values.iter().zip(&floats[self.offset..]) {
            let right = if exact.is_zero() { float == 0.0 } else { float > 0.0 };
            found.signs += usize::from(!right);
            let Some(float) = exact_value(float) else {
                (found.sum, _) = (None, found.ulps.push(None));
                continue;
            };
            let error = float - exact;
            found.sum = found.sum.map(|sum| sum + &error);
            let error = error.abs();
            let counts = *exact >= self.least;
            found.ulps.push(Some(if counts { &error / ulp(exact) } else { BigRational::zero() }));
            found.absolute = found.absolute.max(error);
        }
        found.sum = found.sum.map(|sum| sum.abs());
        found
    }
}

/// The largest error of a formula at a case in units in the last place, nearly: against values of about 100 bits. What
/// the search for bad cases climbs by; nothing that is reported.
pub(super) fn estimate(formula: Formula, case: &Case) -> f64 {
    let exact = point::unrounded(&case.basis, case.span, case.x);
    let existing = case.basis.existing(case.span);
    let floats = formula.values(case);
    let error = |c: usize| {
        let pair = exact[c];
        if pair.hi < power(LEAST) {
            return 0.0;
        }
        let error = ((floats[c] - pair.hi) - pair.lo).abs() / power(exponent(pair.hi) - 52);
        if error.is_nan() { 0.0 } else { error }
    };
    existing.map(error).fold(0.0, f64::max)
}
