//! Rational Bézier pieces against the curve: by the recursion word for word, as identities of rational functions,
//! and their least degree by another route.

#![allow(clippy::unwrap_used, reason = "helpers of tests")]

use knotproof::analysis::{Pieces, RationalBezier, common_numerators, positive_coordinate};
use knotproof::scalar::{BigRational, Jet, Ring, integer, rational};
use knotproof::spline::{Basis, Curve, Index, KnotVector, Point, Side, by_definition};
use proptest::prelude::*;

fn curve(k: usize, knots: &[i64], alpha: &str, points: &[&[i64]]) -> Curve {
    let knots = KnotVector::new(knots.iter().map(|&t| rational(t, 1)).collect()).unwrap();
    let basis = Basis::new(knots, k, alpha.parse().unwrap()).unwrap();
    Curve::new(basis, points.iter().map(|p| p.iter().map(|&c| rational(c, 1)).collect()).collect()).unwrap()
}

fn pieces(curve: &Curve) -> Vec<RationalBezier> {
    RationalBezier::pieces(curve).collect::<Result<_, _>>().expect("an index has positive weights")
}

#[test]
fn a_segment_of_degree_1_has_the_weights_1_and_r() {
    // α = 5, so r = 5/4.
    let curve = curve(1, &[0, 0, 1, 3, 3], "5", &[&[0, 1], &[4, 5], &[6, 7]]);
    let found = pieces(&curve);
    for (piece, first) in found.iter().zip(0..) {
        assert_eq!(piece.weights(), [integer(1), rational(5, 4)]);
        assert_eq!(piece.points(), &curve.points()[first..=first + 1]);
    }
    assert_eq!(found.iter().map(|piece| piece.span().index()).collect::<Vec<_>>(), [1, 2]);
    assert_eq!(found[1].ends(), (&integer(1), &integer(3)));
}

#[test]
fn without_inner_knots_the_weights_are_powers_of_r_and_the_points_stay() {
    for k in 0..=5_usize {
        for alpha in ["inf", "-1", "2", "5", "-1/7", "101/100"] {
            let index: Index = alpha.parse().unwrap();
            let knots = KnotVector::bernstein(k, &rational(-1, 2), &integer(3)).unwrap();
            let points: Vec<Point> =
                (0..=k).map(|i| vec![integer(i), integer(i * i * i), integer(1 + i % 2)]).collect();
            let curve = Curve::new(Basis::new(knots, k, index.clone()).unwrap(), points.clone()).unwrap();
            let found = pieces(&curve);
            assert_eq!(found.len(), 1);
            assert_eq!(found[0].points(), points, "k = {k}, α = {alpha}");
            let powers: Vec<_> = (0..=k).map(|m| index.ratio().power(m)).collect();
            assert_eq!(found[0].weights(), powers, "k = {k}, α = {alpha}");
        }
    }
}

#[test]
fn the_least_degree_of_a_general_curve_is_that_of_the_triangular_numbers() {
    for k in 0..=5 {
        let knots = (0..2 * k + 2).map(|i| integer(i * i + i % 3)).collect();
        let basis = Basis::new(KnotVector::new(knots).unwrap(), k, "-1/7".parse().unwrap()).unwrap();
        let points = (0..=k).map(|i| vec![integer(i * 7 % 5), integer(i * i % 11)]).collect();
        let curve = Curve::new(basis, points).unwrap();
        let base = pieces(&curve).into_iter().find(|piece| piece.span().index() == k).unwrap();
        assert_eq!(base.degree(), k * (k + 1) / 2);
    }
}

/// The bound k(k + 1)/2 counts different factors; that the functions need all of them is true in general, and not
/// always: on eight uniform knots with α = −1 one of six cancels, for every polygon.
#[test]
fn on_uniform_knots_a_factor_can_cancel_for_every_polygon() {
    let functions = |alpha: &str| {
        let knots = KnotVector::new((0..8).map(integer).collect()).unwrap();
        let basis = Basis::new(knots, 3, alpha.parse().unwrap()).unwrap();
        // One coordinate for each function is more than a curve has: three at a time.
        let unit = |i: usize, c: usize| integer(usize::from(i == c));
        let points = |first| (0..4).map(|i| (first..first + 3).map(|c| unit(i, c)).collect()).collect();
        [0, 1].map(|first| {
            let curve = Curve::new(basis.clone(), points(first)).unwrap();
            pieces(&curve).iter().map(RationalBezier::degree).collect::<Vec<_>>()
        })
    };
    assert_eq!(functions("-1").map(|degrees| degrees[3]), [5, 5]);
    assert_eq!(functions("2").map(|degrees| degrees[3]), [5, 5]);
    assert_eq!(functions("5").map(|degrees| degrees[3]), [6, 6]);
}

#[test]
fn where_nothing_moves_the_degree_is_0() {
    // The last span is out of reach of d_0, and the others coincide.
    let curve = curve(2, &[0, 0, 0, 1, 2, 3, 3, 3], "-1", &[&[5, 5], &[1, 2], &[1, 2], &[1, 2], &[1, 2]]);
    let found = pieces(&curve);
    assert_eq!(found.iter().map(RationalBezier::degree).collect::<Vec<_>>(), [2, 0, 0]);
    assert_eq!(
        (found[2].weights(), found[2].points()),
        (&[integer(1)][..], &[vec![integer(1), integer(2)]][..])
    );
}

#[test]
fn a_polynomial_of_lower_degree_is_found_out() {
    // α = ∞ and equidistant control points at the Greville abscissae: x ↦ 3x + 1.
    let curve = curve(2, &[0, 0, 0, 2, 4, 4, 4], "inf", &[&[1], &[4], &[10], &[13]]);
    for piece in pieces(&curve) {
        assert_eq!(piece.weights(), [integer(1), integer(1)]);
        let (from, to) = piece.ends();
        assert_eq!(piece.points(), [from, to].map(|x| vec![x * integer(3) + integer(1)]));
    }
}

#[test]
fn spans_outside_of_the_base_interval_are_pieces_too() {
    let curve = curve(2, &[0, 1, 2, 3, 4, 5], "2", &[&[1], &[1], &[1]]);
    let found = pieces(&curve);
    assert_eq!(found.len(), 5);
    let (first, base) = (&found[0], &found[2]);
    assert_eq!(first.point(&integer(0)), Some(vec![integer(0)]));
    assert!(first.point(&rational(1, 2)).unwrap()[0] < integer(1), "the functions add up to less than 1");
    assert_eq!((base.degree(), base.points()), (0, &[vec![integer(1)]][..]));
}

#[test]
fn beyond_the_span_it_is_the_same_function_and_poles_are_no_points() {
    // φ = x/(2 − x) on (0, 1): d_0 = 0, d_1 = 1.
    let curve = curve(1, &[0, 0, 1, 1], "-1", &[&[0], &[1]]);
    let piece = &pieces(&curve)[0];
    assert_eq!(piece.point(&integer(3)), Some(vec![integer(0) - integer(3)]));
    assert_eq!(piece.point(&integer(2)), None);
}

/// Small knot vectors with every kind of multiplicity, open and not, all signs of α, α near 0 and 1.
pub(crate) fn any_curve(degrees: std::ops::RangeInclusive<usize>) -> impl Strategy<Value = Curve> {
    let gap = prop_oneof![3 => Just(0_usize), 3 => Just(1), 1 => Just(2), 1 => Just(9)];
    let index = prop::sample::select(vec!["inf", "-1", "2", "5", "-1/7", "8/7", "-1/100", "101/100"]);
    let coordinate = (-4_i64..=4, 1_i64..=3).prop_map(|(p, q)| rational(p, q));
    (degrees, 0_usize..=3, any::<bool>(), 1_usize..=3).prop_flat_map(move |(k, more, open, dimension)| {
        let ends = if open { k } else { 0 };
        let inner = if open { 1 + more } else { (2 * k).max(k + 1) + more };
        let points =
            prop::collection::vec(prop::collection::vec(coordinate.clone(), dimension), inner + 2 * ends - k);
        (prop::collection::vec(gap.clone(), inner), index.clone(), points).prop_filter_map(
            "at least one span",
            move |(gaps, index, points)| {
                let gaps = [vec![0; ends], gaps, vec![0; ends]].concat();
                let sums = gaps.iter().scan(0, |t, gap| {
                    *t += gap;
                    Some(integer(*t))
                });
                let knots = KnotVector::new(std::iter::once(integer(0)).chain(sums).collect()).ok()?;
                let basis = Basis::new(knots, k, index.parse().ok()?).ok()?;
                Some(Curve::new(basis, points).unwrap())
            },
        )
    })
}

fn degree_bound(basis: &Basis) -> usize {
    let k = basis.degree();
    if basis.index().is_infinite() { k } else { k * (k + 1) / 2 }
}

/// Σ d_i G_i^k(x) on the closed span, by D3.3 word for word.
fn literally(curve: &Curve, piece: &RationalBezier, x: &BigRational) -> Point {
    let basis = curve.basis();
    let table = by_definition(basis, piece.span(), x).expect("a span of these knots");
    let terms = |c: usize| table[basis.degree()].iter().zip(curve.points()).map(move |(g, d)| g * &d[c]);
    (0..curve.dimension()).map(|c| terms(c).sum()).collect()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn pieces_are_the_curve(curve in any_curve(0..=5)) {
        let basis = curve.basis();
        let found = pieces(&curve);
        prop_assert!(found.iter().map(RationalBezier::span).eq(basis.knots().spans()));
        for piece in &found {
            prop_assert_eq!(&piece.weights()[0], &integer(1));
            prop_assert!(piece.weights().iter().all(|weight| *weight > integer(0)));
            prop_assert_eq!(piece.points().len(), piece.degree() + 1);
            prop_assert!(piece.degree() <= degree_bound(basis));
            if basis.index().is_infinite() {
                prop_assert!(piece.weights().iter().all(|weight| *weight == integer(1)));
            }
            prop_assert_eq!(piece.disagreement(&curve), None);
            let (from, to) = piece.ends();
            for s in [rational(0, 1), rational(1, 1000), rational(3, 7), rational(1, 2), rational(1, 1)] {
                let x = from + (to - from) * s;
                prop_assert_eq!(piece.point(&x), Some(literally(&curve, piece, &x)), "x = {}", x);
            }
            // The ends of the polygon are the ends of the piece.
            prop_assert_eq!(&piece.points()[0], &curve.point(from, Side::Right));
            prop_assert_eq!(&piece.points()[piece.degree()], &curve.point(to, Side::Left));
            let order = 2;
            let jets = piece.point(&Jet::variable(from.clone(), order));
            prop_assert_eq!(jets, Some(curve.jets(from, Side::Right, order)));
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(100))]

    /// De Casteljau over rational functions of u against the recursion over them; and the degree against the least
    /// common denominator of the coordinates, by Euclid.
    #[test]
    fn pieces_are_the_curve_as_identities(curve in any_curve(0..=3)) {
        let basis = curve.basis();
        let all = Pieces::of(basis);
        for piece in pieces(&curve) {
            let functions = &all.on(piece.span()).unwrap().functions;
            let mut coordinates = curve.combine(functions).expect("a span of these knots");
            let u = positive_coordinate(basis.knots(), piece.span()).expect("a span of these knots");
            prop_assert_eq!(piece.point(&u), Some(coordinates.clone()));
            coordinates.push(u.one());
            let numerators = common_numerators(&coordinates);
            let least = numerators.iter().map(|p| p.degree()).max().unwrap();
            prop_assert_eq!(piece.degree(), least);
        }
    }
}
