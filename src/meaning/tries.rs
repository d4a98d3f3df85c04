//! What is tried where a sentence speaks of any numbers: control values, and numbers beside knots. It knows functions, and no
//! sentence; what is tried can refute, and proves nothing.

use crate::analysis::{NegativeMinor, determinant, negative_minor};
use crate::scalar::{BigRational, integer};
use crate::spline::{Basis, KnotVector};

use super::family::Weighting;
use super::instance::Instance;

/// Control values for a basis: constant, rising, of alternating signs, a step; and what a negative minor shows.
pub(super) fn control_values<W>(
    on: &Instance,
    weights: &Weighting,
    basis: &Basis<W>,
) -> Vec<Vec<BigRational>> {
    let n = basis.n();
    let list = |value: &dyn Fn(usize) -> BigRational| (0..=n).map(value).collect();
    let mut all: Vec<Vec<_>> = vec![
        list(&|_| integer(1)),
        list(&|i| integer(i)),
        list(&|i| signed(i, integer(1))),
        list(&|i| integer(i * i)),
    ];
    all.extend((1..=n).map(|step| list(&|i| integer(usize::from(i >= step)))));
    all.extend(minor(on, weights, basis.degree()).and_then(|minor| from_negative_minor(basis.n(), minor)));
    all
}

/// Numbers beside knots: the middles of the spans, and the knots.
pub(super) fn numbers(knots: &KnotVector) -> Vec<BigRational> {
    let middle = |pair: &[BigRational]| (&pair[0] + &pair[1]) / integer(2);
    let stops: Vec<_> = knots.stop_knots().map(|(t, _)| t.clone()).collect();
    stops.windows(2).map(middle).chain(stops.iter().cloned()).collect()
}

fn signed(i: usize, size: BigRational) -> BigRational {
    if i.is_multiple_of(2) { size } else { -size }
}

/// A negative minor of the functions of a degree, if one is found.
pub(super) fn minor(on: &Instance, weights: &Weighting, degree: usize) -> Option<NegativeMinor> {
    negative_minor(&on.any_basis_of(weights, degree)?)
}

/// From a negative minor: with f = Σ c_i G_i equal to 1, −1, 1 at its points, the c_i have the signs −, +, −, so f changes
/// its sign there twice, and twice more where the outer functions, alone near the ends of their supports, make it
/// negative. Whole numbers c_i change f by 1/2 at most.
fn from_negative_minor(n: usize, minor: NegativeMinor) -> Option<Vec<BigRational>> {
    let NegativeMinor { first, rows, value, .. } = minor;
    // All others −1: they add no change of sign to the polygon's, and no part of it lies in the line y = 0.
    let mut c = vec![-integer(1); n + 1];
    for column in 0..3 {
        // Cramer's rule.
        let mut replaced = rows.clone();
        replaced.iter_mut().enumerate().for_each(|(row, entries)| entries[column] = signed(row, integer(1)));
        c[first + column] = (determinant(&replaced, &integer(1)) / &value).round();
    }
    Some(c)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::rational;

    fn knots(knots: &[usize]) -> KnotVector {
        KnotVector::new(knots.iter().map(|t| integer(*t)).collect()).unwrap()
    }

    /// Four changes of sign of the curve, two of the polygon.
    #[test]
    fn a_negative_minor_gives_control_values() {
        let basis = Basis::new(knots(&[0, 0, 0, 0, 1, 2, 3, 3, 3, 3]), 3, "-1".parse().unwrap()).unwrap();
        let expected = [-1, -371_664, 769_061, -3_162_035, -1, -1].map(|c| rational(c, 1));
        let on = Instance::of(basis.clone());
        assert_eq!(control_values(&on, &on.weights, &basis).pop().unwrap(), expected);
    }

    #[test]
    fn numbers_are_middles_and_knots() {
        assert_eq!(
            numbers(&knots(&[0, 0, 1, 3])),
            [rational(1, 2), rational(2, 1), integer(0), integer(1), integer(3)]
        );
    }
}
