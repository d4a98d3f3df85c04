//! Words on the spaces that functions span: which one lies in which.

use num_traits::Signed;

use crate::analysis::{Pieces, SpanPieces, coefficient_rows, common_numerators, rank};
use crate::scalar::{BigRational, Polynomial, RationalAlgebra, Ring, integer};
use crate::spline::{Basis, KnotVector, Side};

/// Is every function of a basis a combination of those of a finer one, whose knots are its own and perhaps more?
fn contains(fine: &Basis, coarse: &Basis) -> bool {
    let rows = coefficient_rows(Pieces::of(fine).spans().iter().map(|on| {
        let span = coarse.knots().span_at(on.ends().0, Side::Right);
        let active = span.and_then(|span| coarse.active(span, &on.x).ok());
        let other = |i| active.as_ref().and_then(|active| active.get(i)).cloned().unwrap_or_else(|| on.x.zero());
        (0..=fine.n()).map(|i| on.function(i)).chain((0..=coarse.n()).map(other)).collect()
    }));
    rank(&rows[..=fine.n()]) == rank(&rows)
}

fn on_knots(basis: &Basis, knots: KnotVector, degree: usize) -> Option<Basis> {
    Basis::new(knots, degree, basis.index().clone()).ok()
}

/// Is every function a combination of those for the knots with one more?
pub(super) fn nested(basis: &Basis, knot: &BigRational) -> bool {
    let refined = on_knots(basis, basis.knots().with_knot(knot), basis.degree());
    refined.is_some_and(|refined| contains(&refined, basis))
}

/// Is every function a combination of those of the next degree on the knots of which each occurs once more?
pub(super) fn elevated(basis: &Basis) -> bool {
    let knots = basis.knots();
    let raised = knots.stop_knots().fold(knots.clone(), |raised, (t, _)| raised.with_knot(t));
    on_knots(basis, raised, basis.degree() + 1).is_some_and(|raised| contains(&raised, basis))
}

/// The least degree in which the functions on a span are rational Bézier curves with positive weights; `None` if it is higher
/// by more than a few than that of their common denominator.
pub(super) fn nurbs_degree(on: &SpanPieces) -> Option<usize> {
    /// Each of them makes more weights positive.
    const ELEVATIONS: usize = 50;
    let functions = [on.functions.values(), &[on.x.one()]].concat();
    let numerators = common_numerators(&functions);
    let least = numerators.iter().map(Polynomial::degree).max()?;
    // The numerator of 1 over the common denominator is that denominator.
    let mut denominator = numerators.last()?.clone();
    let linear = Polynomial::new(integer(1), [integer(1)]);
    // In degree N the coefficients in u are the weights times binomial coefficients; one degree more is a factor 1 + u.
    (least..least + ELEVATIONS).find(|degree| {
        let positive = denominator.degree() == *degree && denominator.coefficients().iter().all(Signed::is_positive);
        denominator = denominator.times(&linear);
        positive
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn basis(degree: usize, knots: &[usize], alpha: &str) -> Basis {
        let knots = KnotVector::new(knots.iter().map(|t| integer(*t)).collect()).unwrap();
        Basis::new(knots, degree, alpha.parse().unwrap()).unwrap()
    }

    #[test]
    fn polynomial_splines_are_nested_and_others_at_full_knots_only() {
        let cubic = |alpha| basis(3, &[0, 0, 0, 0, 1, 2, 2, 2, 3, 3, 3, 3], alpha);
        for t in [1, 2] {
            assert!(nested(&cubic("inf"), &integer(t)));
            assert_eq!(nested(&cubic("-1"), &integer(t)), t == 2);
        }
        assert!(elevated(&cubic("inf")) && !elevated(&cubic("-1")));
        assert!(elevated(&basis(1, &[0, 0, 1, 1], "-1")));
    }

    #[test]
    fn bezier_degrees() {
        let degree = |basis: &Basis| nurbs_degree(&Pieces::of(basis).spans()[0]);
        assert_eq!(degree(&basis(2, &[0, 1, 2, 3, 5, 6], "inf")), Some(2));
        assert_eq!(degree(&basis(2, &[0, 0, 0, 1, 3, 3, 3], "-1")), Some(2));
        assert_eq!(nurbs_degree(&Pieces::of(&basis(2, &[0, 1, 2, 3, 5, 6], "-1")).spans()[2]), Some(3));
    }
}
