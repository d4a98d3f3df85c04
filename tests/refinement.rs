//! Knot insertion: against Boehm's algorithm where α = ∞, and equal curves for every x elsewhere.

#![allow(clippy::unwrap_used, reason = "helpers of tests")]

use knotproof::analysis::{RationalBezier, RefinementError, refined};
use knotproof::scalar::{BigRational, integer, rational};
use knotproof::spline::{Basis, Curve, KnotVector, Point, Side};
use proptest::prelude::*;

use crate::rational_bezier::any_curve;

fn curve(k: usize, knots: &[i64], alpha: &str, points: &[i64]) -> Curve {
    let knots = KnotVector::new(knots.iter().map(|&t| rational(t, 1)).collect()).unwrap();
    let basis = Basis::new(knots, k, alpha.parse().unwrap()).unwrap();
    Curve::new(basis, points.iter().map(|&d| vec![rational(d, 1)]).collect()).unwrap()
}

/// Each piece of the one, and of the other on the same interval: equal for every x.
fn are_equal(coarse: &Curve, fine: &Curve) {
    for piece in RationalBezier::pieces(fine) {
        let piece = piece.unwrap();
        let (from, to) = piece.ends();
        for s in [(0, 1), (1, 5), (1, 2), (13, 17)] {
            let x = from + (to - from) * rational(s.0, s.1);
            assert_eq!(fine.point(&x, Side::Right), coarse.point(&x, Side::Right), "x = {x}");
        }
        assert_eq!(fine.point(to, Side::Left), coarse.point(to, Side::Left), "x = {to} from the left");
        let order = 3;
        assert_eq!(fine.jets(from, Side::Right, order), coarse.jets(from, Side::Right, order));
    }
}

/// Boehm (1980): d'_i = a_i d_i + (1 − a_i) d_{i−1}, a_i = (x − t_i)/(t_{i+k} − t_i) between 0 and 1.
fn boehm(curve: &Curve, x: &BigRational) -> Vec<Point> {
    let (knots, k) = (curve.basis().knots(), curve.basis().degree());
    let share = |i: usize| {
        if i + k <= knots.m() && knots.t(i + k) <= x {
            return integer(1);
        }
        if i > knots.m() || knots.t(i) >= x {
            return integer(0);
        }
        (x - knots.t(i)) / (knots.t(i + k) - knots.t(i))
    };
    let point = |i: usize| {
        let a = share(i);
        let zero = vec![integer(0); curve.dimension()];
        let own = curve.points().get(i).unwrap_or(&zero);
        let before = i.checked_sub(1).map_or(&zero, |before| &curve.points()[before]);
        own.iter().zip(before).map(|(d, e)| &a * d + (integer(1) - &a) * e).collect()
    };
    (0..=curve.points().len()).map(point).collect()
}

#[test]
fn what_is_in_the_space_and_what_is_not() {
    let cubic = curve(3, &[0, 0, 0, 0, 1, 2, 2, 2, 3, 3, 3, 3], "-1", &[0, 3, 1, 2, 5, 0, 1, 1]);
    // A knot of k copies can have one more: the curve is cut there.
    let cut = refined(&cubic, &[integer(2)]).unwrap();
    are_equal(&cubic, &cut);
    assert_eq!(cut.basis().knots().multiplicity(&integer(2)), 4);
    for knot in [rational(1, 1), rational(1, 2), rational(5, 2)] {
        let error = refined(&cubic, &[knot]).unwrap_err();
        assert!(matches!(error, RefinementError::NotInSpace { coordinate: 0, rank: 9 }), "{error}");
    }
    assert!(matches!(refined(&cubic, &[integer(4)]), Err(RefinementError::Outside { .. })));
    are_equal(&cubic, &refined(&cubic, &[]).unwrap());
    // For α = ∞ any knots can be inserted, many at once.
    let classical = cubic.with("inf".parse().unwrap());
    are_equal(
        &classical,
        &refined(&classical, &[rational(1, 2), rational(1, 2), integer(1), rational(5, 2)]).unwrap(),
    );
    // A constant is in every space.
    let constant = curve(2, &[0, 0, 0, 1, 1, 1], "5", &[7, 7, 7]);
    assert_eq!(refined(&constant, &[rational(1, 2)]).unwrap().points(), vec![vec![integer(7)]; 4]);
    // One coordinate of two.
    let points = [[7, 0], [7, 1], [7, 0]].map(|point| point.map(integer).to_vec()).to_vec();
    let bent = Curve::new(constant.basis().clone(), points).unwrap();
    assert!(matches!(
        refined(&bent, &[rational(1, 2)]),
        Err(RefinementError::NotInSpace { coordinate: 1, .. })
    ));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(80))]

    #[test]
    fn refined_curves_are_equal(curve in any_curve(0..=3), s in 0_i64..=12) {
        let (first, last) = (curve.basis().knots().first(), curve.basis().knots().last());
        let x = first + (last - first) * rational(s, 12);
        match refined(&curve, std::slice::from_ref(&x)) {
            Ok(fine) => are_equal(&curve, &fine),
            Err(RefinementError::NotInSpace { .. }) => prop_assert!(!curve.basis().index().is_infinite()),
            Err(error) => prop_assert!(false, "{error}"),
        }
        let classical = curve.with("inf".parse().unwrap());
        let (k, copies) = (curve.basis().degree(), curve.basis().knots().multiplicity(&x));
        if copies <= k && k > 0 {
            let fine = refined(&classical, std::slice::from_ref(&x)).unwrap();
            are_equal(&classical, &fine);
            let expected = boehm(&classical, &x);
            // Where a function is 0 everywhere, any point will do.
            for (i, point) in fine.points().iter().enumerate() {
                let (from, to) = fine.basis().support(i);
                if from < to {
                    prop_assert_eq!(point, &expected[i], "point {}", i);
                }
            }
        }
    }
}
