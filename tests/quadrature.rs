//! Integrals and lengths: against what is known exactly, and against themselves.

#![allow(clippy::unwrap_used, reason = "helpers of tests")]

use knotproof::analysis::{CurvePart, RationalBezier, integrals, length};
use knotproof::scalar::{BigRational, integer, rational};
use knotproof::spline::{Basis, Curve, KnotVector, Side};
use num_traits::Signed;
use proptest::prelude::*;

use crate::rational_bezier::any_curve;

fn curve(k: usize, knots: &[i64], alpha: &str, points: &[[i64; 2]]) -> Curve {
    let knots = KnotVector::new(knots.iter().map(|&t| integer_of(t)).collect()).unwrap();
    let basis = Basis::new(knots, k, alpha.parse().unwrap()).unwrap();
    Curve::new(basis, points.iter().map(|point| point.map(integer_of).to_vec()).collect()).unwrap()
}

fn integer_of(value: i64) -> BigRational {
    rational(value, 1)
}

fn pieces(curve: &Curve) -> Vec<RationalBezier> {
    RationalBezier::pieces(curve).collect::<Result<_, _>>().unwrap()
}

fn width(bits: u32) -> BigRational {
    BigRational::new(1.into(), num_bigint::BigInt::from(1) << bits)
}

/// Two intervals around one number.
fn meet((a, b): &(BigRational, BigRational), (c, d): &(BigRational, BigRational)) -> bool {
    a <= d && c <= b
}

/// Chains of straight lines have the lengths of their polygons, for every α.
#[test]
fn polygons() {
    for alpha in ["inf", "-1", "5", "100/99"] {
        let chain = curve(1, &[0, 0, 1, 2, 3, 3], alpha, &[[0, 0], [3, 4], [3, 5], [15, 0]]);
        assert_eq!(length(&pieces(&chain), &rational(1, 10)), (integer(19), integer(19)));
        let diagonal = curve(1, &[0, 0, 1, 1], alpha, &[[0, 0], [1, 1]]);
        let (lo, hi) = length(&pieces(&diagonal), &width(200));
        assert!(&lo * &lo < integer(2) && integer(2) < &hi * &hi && hi - lo <= width(200));
    }
    // A jump adds nothing, and a point has no length.
    let torn = curve(1, &[0, 0, 1, 1, 2, 2], "5", &[[0, 0], [1, 0], [7, 0], [9, 0]]);
    assert_eq!(length(&pieces(&torn), &rational(1, 10)), (integer(3), integer(3)));
    let still = curve(2, &[0, 0, 0, 1, 1, 1], "5", &[[2, 3], [2, 3], [2, 3]]);
    assert_eq!(length(&pieces(&still), &rational(1, 10)), (integer(0), integer(0)));
    // In one dimension it is the variation, exactly where the turns are rational.
    let knots = KnotVector::new([0, 0, 0, 1, 1, 1].map(integer_of).to_vec()).unwrap();
    let hill = |alpha: &str| {
        let basis = Basis::new(knots.clone(), 2, alpha.parse().unwrap()).unwrap();
        Curve::new(basis, [0, 3, 0].map(|d| vec![integer_of(d)]).to_vec()).unwrap()
    };
    for alpha in ["inf", "-1", "5"] {
        assert_eq!(length(&pieces(&hill(alpha)), &rational(1, 10)), (integer(3), integer(3)));
    }
    // There and back again: a turn is no corner of the polygon alone.
    let back = curve(2, &[0, 0, 0, 1, 1, 1], "inf", &[[0, 0], [1, 0], [0, 0]]);
    let (lo, hi) = length(&pieces(&back), &width(40));
    assert!(lo <= integer(1) && integer(1) <= hi && hi - lo <= width(40));
}

/// The trace of a Bernstein curve does not depend on α, and so its length; that of a parabola is known: y = x² on [0, 1] has
/// √5/2 + asinh(2)/4.
#[test]
fn a_parabola() {
    let known = (rational(1478942857544, 1_000_000_000_000), rational(1478942857545, 1_000_000_000_000));
    let mut found = Vec::new();
    for alpha in ["inf", "-1", "5", "-1/7"] {
        let parabola = {
            let half = curve(2, &[0, 0, 0, 1, 1, 1], alpha, &[[0, 0], [1, 0], [2, 2]]);
            let points =
                half.points().iter().map(|point| point.iter().map(|c| c / integer(2)).collect()).collect();
            Curve::new(half.basis().clone(), points).unwrap()
        };
        let bounds = length(&pieces(&parabola), &width(100));
        assert!(&bounds.1 - &bounds.0 <= width(100));
        assert!(meet(&bounds, &known), "{alpha}");
        found.push(bounds);
    }
    assert!(found.windows(2).all(|pair| meet(&pair[0], &pair[1])));
}

/// A cusp, where the speed is 0.
#[test]
fn a_cusp_is_no_obstacle() {
    let cusp = curve(3, &[0, 0, 0, 0, 1, 1, 1, 1], "inf", &[[0, 0], [1, 1], [0, 1], [1, 0]]);
    let speed = cusp.jets(&rational(1, 2), Side::Right, 1);
    assert!(speed.iter().all(|jet| jet.derivatives()[1] == integer(0)));
    for (alpha, bits) in [("inf", 30), ("-1", 50)] {
        let bounds = length(&pieces(&cusp.with(alpha.parse().unwrap())), &width(bits));
        let coarse = length(&pieces(&cusp), &width(8));
        assert!(&bounds.1 - &bounds.0 <= width(bits));
        assert!(meet(&bounds, &coarse));
    }
}

/// Of B-splines the integral is Σ d_i (t_{i+k+1} − t_i)/(k + 1).
#[test]
fn integrals_of_polynomials_are_exact() {
    let cubic = curve(
        3,
        &[0, 0, 0, 0, 1, 1, 3, 4, 4, 4, 4],
        "inf",
        &[[0, 1], [2, 5], [-1, 3], [4, 4], [2, 0], [7, 1], [1, 1]],
    );
    let t = |i: usize| cubic.basis().knots().t(i).clone();
    for (c, bounds) in integrals(&pieces(&cubic), &rational(1, 2)).into_iter().enumerate() {
        let terms = cubic.points().iter().enumerate();
        let expected: BigRational = terms.map(|(i, d)| &d[c] * (t(i + 4) - t(i)) / integer(4)).sum();
        assert_eq!(bounds, (expected.clone(), expected));
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    /// ∫ c′ over each piece is the difference of its ends, exactly.
    #[test]
    fn integrals_of_derivatives(curve in any_curve(0..=2), bits in 4_u32..60) {
        for piece in pieces(&curve) {
            let slope = piece.derivative().unwrap();
            let (first, last) = (&piece.points()[0], &piece.points()[piece.degree()]);
            for (c, (lo, hi)) in integrals(&[slope], &width(bits)).into_iter().enumerate() {
                let exact = &last[c] - &first[c];
                prop_assert!(&hi - &lo <= width(bits));
                prop_assert!(lo <= exact && exact <= hi, "{lo} {exact} {hi}");
            }
        }
    }

    /// Narrow and wide bounds meet, two parts are the whole, and a length is no shorter than what each coordinate moves.
    #[test]
    fn lengths_agree_with_each_other(curve in any_curve(0..=2), bits in 8_u32..30, s in 1_i64..12) {
        let whole = pieces(&curve);
        let (lo, hi) = length(&whole, &width(bits));
        prop_assert!(&hi - &lo <= width(bits));
        prop_assert!(meet(&(lo.clone(), hi.clone()), &length(&whole, &width(5))));
        let (first, last) = (curve.basis().knots().first(), curve.basis().knots().last());
        let middle = first + (last - first) * rational(s, 12);
        let parts = [(None, Some(&middle)), (Some(&middle), None)].map(|(from, to)| {
            let part = CurvePart::of(&curve, from, to).unwrap();
            let pieces: Vec<_> = RationalBezier::pieces_on(&curve, &part).collect::<Result<_, _>>().unwrap();
            length(&pieces, &width(bits))
        });
        let sum = (&parts[0].0 + &parts[1].0, &parts[0].1 + &parts[1].1);
        prop_assert!(meet(&sum, &(lo.clone(), hi.clone())));
        // Each coordinate goes from its beginning to its end on every piece.
        let moved = |piece: &RationalBezier, c: usize| (&piece.points()[piece.degree()][c] - &piece.points()[0][c]).abs();
        for c in 0..curve.dimension() {
            prop_assert!(whole.iter().map(|piece| moved(piece, c)).sum::<BigRational>() <= hi);
        }
    }
}
