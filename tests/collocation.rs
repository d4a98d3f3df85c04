//! Interpolation, and when it is possible: the condition of Schoenberg and Whitney beside the determinant.

#![allow(clippy::unwrap_used, reason = "helpers of tests")]

use knotproof::analysis::{Collocation, InterpolationError, SiteError, determinant};
use knotproof::scalar::{BigRational, integer, rational};
use knotproof::spline::{Basis, Curve, Index, KnotVector, Side};
use num_traits::{Signed, Zero};
use proptest::prelude::*;

use crate::rational_bezier::any_curve;

fn basis(k: usize, knots: &[i64], alpha: &str) -> Basis {
    let knots = KnotVector::new(knots.iter().map(|&t| rational(t, 1)).collect()).unwrap();
    Basis::new(knots, k, alpha.parse::<Index>().unwrap()).unwrap()
}

/// Where G_i is not 0, by its support and by what it is at the ends of it.
fn is_on_support(basis: &Basis, i: usize, x: &BigRational) -> bool {
    !basis.values(x, Side::Right)[i].is_zero()
}

#[test]
fn places_that_are_none() {
    let basis = basis(2, &[0, 0, 0, 1, 2, 2, 2], "5");
    let error = |places: &[i64]| {
        Collocation::new(&basis, places.iter().map(|&x| rational(x, 1)).collect()).unwrap_err()
    };
    assert_eq!(error(&[]), SiteError::None);
    assert!(matches!(error(&[0, 0]), SiteError::Order { position: 1, .. }));
    assert!(matches!(error(&[0, 1, 3]), SiteError::Outside { position: 2, .. }));
    assert!(matches!(error(&[-1]), SiteError::Outside { position: 0, .. }));
    let two = Collocation::new(&basis, vec![integer(0), integer(1)]).unwrap();
    let points = vec![vec![integer(1)]; 2];
    assert_eq!(two.interpolate(&points), Err(InterpolationError::Places { places: 2, functions: 4 }));
    assert_eq!((two.rank(), two.determinant()), (2, None));
    assert!(two.relation().is_some());
}

/// At t_0, at t_m and at a knot of k + 1 copies the one-sided value counts.
#[test]
fn ends_and_full_knots() {
    let basis = basis(1, &[0, 0, 1, 1, 2, 2], "5");
    let at = |places: [i64; 4]| Collocation::new(&basis, places.map(|x| rational(x, 4)).to_vec()).unwrap();
    let good = at([0, 2, 4, 8]);
    assert_eq!((good.misplaced(), good.rank()), (vec![], 4));
    // G_1 ends before 1, where G_2 is 1: at 1 it is 0.
    let bad = at([0, 4, 6, 8]);
    assert_eq!((bad.misplaced(), bad.determinant()), (vec![1], Some(integer(0))));
    let message = bad.interpolate(&vec![vec![integer(1)]; 4]).unwrap_err().to_string();
    assert!(message.contains("rank 3, less than 4, as G_1 is 0 at place 1"), "{message}");
}

/// **The condition does not suffice.** On these knots, for α = 100/99, the determinant is positive at some places and negative at
/// others that meet the condition as well. The places that do, t_i < x_i < t_{i+4} and x_0 < … < x_4, are a convex set: so there are places
/// between, on the line from the ones to the others, where it is 0, and no curve takes all values there.
#[test]
fn the_condition_is_not_sufficient_for_every_index() {
    let knots = [0, 0, 0, 0, 1, 2, 2, 2, 2];
    let negative = [484, 509, 520, 521, 700].map(|x| rational(x, 500));
    let positive = [100, 300, 500, 700, 900].map(|x| rational(x, 500));
    let determinant = |alpha: &str, s: &BigRational| {
        let blend = |(a, b): (&BigRational, &BigRational)| a * s + b * (integer(1) - s);
        let places = positive.iter().zip(&negative).map(blend).collect();
        let collocation = Collocation::new(&basis(3, &knots, alpha), places).unwrap();
        assert!(collocation.misplaced().is_empty());
        collocation.determinant().unwrap()
    };
    for (alpha, sign) in [("100/99", -1), ("inf", 1)] {
        assert!(determinant(alpha, &integer(1)).is_positive());
        assert_eq!(determinant(alpha, &integer(0)).signum(), rational(sign, 1));
    }
    // As close to such places as one likes.
    let (mut low, mut high) = (integer(0), integer(1));
    for _ in 0..12 {
        let middle = (&low + &high) / integer(2);
        if determinant("100/99", &middle).is_positive() { high = middle } else { low = middle }
    }
    assert!(!determinant("100/99", &low).is_positive() && determinant("100/99", &high).is_positive());
}

fn places(curve: &Curve, numbers: &[i64]) -> Vec<BigRational> {
    let (first, last) = (curve.basis().knots().first(), curve.basis().knots().last());
    let mut numbers: Vec<_> = numbers.to_vec();
    numbers.sort_unstable();
    numbers.dedup();
    numbers.iter().map(|s| first + (last - first) * rational(*s, 24)).collect()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(150))]

    /// Rows are values, the determinant is that by the expansion, the condition is necessary, and for α = ∞ sufficient; what
    /// interpolates goes through its points, and points of a curve give that curve.
    #[test]
    fn interpolation(curve in any_curve(0..=3), numbers in prop::collection::vec(0_i64..=24, 1..10)) {
        let basis = curve.basis();
        let collocation = Collocation::new(basis, places(&curve, &numbers)).unwrap();
        for (x, row) in collocation.places().iter().zip(collocation.rows()) {
            prop_assert_eq!(row, &basis.values(x, Side::Right));
        }
        let on: Vec<_> = collocation.places().iter().map(|x| curve.point(x, Side::Right)).collect();
        if let Some(relation) = collocation.relation() {
            prop_assert!(relation.iter().any(|c| !c.is_zero()));
            for row in collocation.rows() {
                let sum: BigRational = row.iter().zip(&relation).map(|(g, c)| g * c).sum();
                prop_assert!(sum.is_zero());
            }
            prop_assert!(collocation.rank() <= basis.n());
        }
        let square = collocation.places().len() == basis.n() + 1;
        prop_assert_eq!(collocation.determinant().is_some(), square);
        let Some(value) = collocation.determinant() else { return Ok(()) };
        prop_assert_eq!(&value, &determinant(collocation.rows(), &integer(1)));
        prop_assert_eq!(value.is_zero(), collocation.rank() < basis.n() + 1);
        let misplaced = collocation.misplaced();
        let by_support: Vec<_> =
            (0..=basis.n()).filter(|i| !is_on_support(basis, *i, &collocation.places()[*i])).collect();
        prop_assert_eq!(&misplaced, &by_support);
        if !misplaced.is_empty() {
            prop_assert!(value.is_zero());
        } else if basis.index().is_infinite() {
            prop_assert!(value.is_positive());
        }
        match collocation.interpolate(&on) {
            Ok(other) => prop_assert_eq!(other.points(), curve.points()),
            Err(InterpolationError::Singular { .. }) => prop_assert!(value.is_zero()),
            Err(error) => prop_assert!(false, "{error}"),
        }
        let any: Vec<_> = (0..on.len()).map(|j| vec![integer(j * j % 5), rational(1, 3)]).collect();
        if let Ok(other) = collocation.interpolate(&any) {
            for (x, point) in collocation.places().iter().zip(&any) {
                prop_assert_eq!(&other.point(x, Side::Right), point);
            }
        }
    }
}
