//! The evaluator of curves that is prepared once, against what the curve computes anew at each point.

use knotproof::meaning::examples;
use knotproof::scalar::{BigRational, integer, rational};
use knotproof::spline::{
    AnyWeights, Basis, Curve, CurveEvaluator, FormTable, Forms, HasWeights, Index, KnotVector, Point, Side,
};
use proptest::prelude::*;

/// Points, de Boor's points and derivatives at x from both sides.
fn agree<W: HasWeights>(evaluator: &mut CurveEvaluator<'_, W>, x: &BigRational) {
    let curve = evaluator.curve();
    for side in [Side::Left, Side::Right] {
        let (point, slow) = (evaluator.point(x, side), curve.point(x, side));
        assert_eq!(point, slow, "at {x}, {side}");
        // `==` of fractions multiplies out; these are in lowest terms.
        for (found, expected) in point.iter().zip(&slow) {
            assert_eq!((found.numer(), found.denom()), (expected.numer(), expected.denom()));
        }
        assert_eq!(evaluator.de_boor(x, side), curve.de_boor(x, side), "at {x}, {side}");
        assert_eq!(evaluator.jets(x, side, 2), curve.jets(x, side, 2), "at {x}, {side}");
        let derivatives = evaluator.derivatives(x, side, 2);
        assert_eq!((derivatives.len(), &derivatives[0]), (3, &slow), "at {x}, {side}");
        agree_on_tangents(evaluator, x, side, &derivatives);
    }
}

/// Where c′ ≠ 0 the direction is c′, and the vector of curvature by the usual formula.
fn agree_on_tangents<W: HasWeights>(
    evaluator: &mut CurveEvaluator<'_, W>,
    x: &BigRational,
    side: Side,
    derivatives: &[Point],
) {
    let (velocity, acceleration) = (&derivatives[1], &derivatives[2]);
    let dot = |a: &Point, b: &Point| a.iter().zip(b).map(|(a, b)| a * b).sum::<BigRational>();
    let (square, along) = (dot(velocity, velocity), dot(velocity, acceleration));
    let tangent = evaluator.tangent(x, side);
    if square == integer(0) {
        assert!(tangent.is_none_or(|tangent| tangent.order > 1));
        return;
    }
    let tangent = tangent.expect("it moves");
    let bend =
        velocity.iter().zip(acceleration).map(|(v, a)| (&square * a - &along * v) / (&square * &square));
    assert_eq!((tangent.order, &tangent.direction), (1, velocity));
    assert_eq!(tangent.curvature, Some(bend.collect()));
}

/// The knots, a point of each span, and both outsides.
fn places<W>(basis: &Basis<W>, part: &BigRational) -> Vec<BigRational> {
    let knots = basis.knots();
    let inside = knots.spans().map(|span| {
        let (start, end) = knots.ends(span).expect("a span of these knots");
        start + (end - start) * part
    });
    let outside = [knots.first() - integer(1), knots.last() + integer(1)];
    knots.knots().iter().cloned().chain(inside).chain(outside).collect()
}

/// Knots that are often repeated, α = ∞ among the indices, control points that are often equal, in 1 to 3 coordinates.
fn curves() -> impl Strategy<Value = Curve> {
    let gap = prop_oneof![3 => Just((0_i64, 1_i64)), 4 => (1_i64..5, 1_i64..3), 1 => (1_i64 << 40..1_i64 << 50, 1_i64..99)];
    let ratio = prop_oneof![Just((1_i64, 1_i64)), (1_i64..9, 1_i64..9), (1_i64..1 << 40, 1_i64..1 << 40)];
    let coordinate = prop_oneof![3 => (-3_i64..4, Just(1_i64)), 1 => (-99_i64..99, 1_i64..50)];
    let coordinates = prop::collection::vec(coordinate, 90);
    (0_usize..6, prop::collection::vec(gap, 2..18), ratio, coordinates, 1_usize..4).prop_filter_map(
        "no curve",
        |(degree, gaps, (p, q), coordinates, dimension)| {
            let mut knots = vec![rational(-1, 3)];
            for (numerator, denominator) in gaps {
                knots.push(&knots[knots.len() - 1] + rational(numerator, denominator));
            }
            let index = Index::from_ratio(rational(p, q)).ok()?;
            let basis = Basis::new(KnotVector::new(knots).ok()?, degree, index).ok()?;
            let points = coordinates.chunks(dimension).take(basis.n() + 1);
            let points = points.map(|point| point.iter().map(|(p, q)| rational(*p, *q)).collect()).collect();
            Curve::new(basis, points).ok()
        },
    )
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]
    #[test]
    fn the_same_as_point_by_point(
        curve in curves(),
        denominator in prop_oneof![1_i64..20, 1_i64 << 20..1 << 21, 1_i64 << 55..1 << 60],
        numerator in 0_i64..i64::MAX,
    ) {
        let part = rational(numerator, denominator);
        let part = &part - part.floor();
        let mut evaluator = CurveEvaluator::new(&curve);
        for x in places(curve.basis(), &part) {
            agree(&mut evaluator, &x);
        }
    }
}

/// Some of the curves of the paper.
#[test]
fn curves_of_the_paper() {
    for example in examples().iter().filter(|example| ["C5", "S3", "S6"].contains(&&*example.name)) {
        for (_, curve) in example.curves() {
            let mut evaluator = CurveEvaluator::new(&curve);
            for x in places(curve.basis(), &rational(2, 5)) {
                agree(&mut evaluator, &x);
            }
        }
    }
}

#[test]
fn curves_of_another_family() {
    let curve = on(3, &[0, 0, 1, 1, 2, 4, 4, 5], "inf", &[[0, 1], [2, 3], [3, 0], [1, 1]]);
    // p² + pq against q² + 2pq.
    let forms =
        || Forms::new([0, 1, 1].map(integer).to_vec(), [1, 2, 0].map(integer).to_vec(), None).expect("forms");
    let table =
        FormTable::new(curve.basis().knots(), 3, |_, _, _| Ok::<_, ()>(forms())).expect("a form each");
    let curve = curve.with(AnyWeights::Forms(table));
    let mut evaluator = CurveEvaluator::new(&curve);
    for x in places(curve.basis(), &rational(1, 7)) {
        agree(&mut evaluator, &x);
    }
}

fn on(degree: usize, knots: &[i64], alpha: &str, points: &[[i64; 2]]) -> Curve {
    let knots = KnotVector::new(knots.iter().map(|t| integer(*t)).collect()).expect("knots");
    let basis = Basis::new(knots, degree, alpha.parse().expect("an index")).expect("enough knots");
    Curve::new(basis, points.iter().map(|point| point.map(integer).to_vec()).collect())
        .expect("enough points")
}

/// Degree 0 jumps from point to point and has no tangent; at t_m both sides are the limit from the left; outside all is 0.
#[test]
fn the_edges() {
    let steps = on(0, &[0, 1, 2], "-1", &[[1, 2], [3, 4]]);
    let mut evaluator = CurveEvaluator::new(&steps);
    for (x, side, expected) in [
        (0, Side::Left, [0, 0]),
        (0, Side::Right, [1, 2]),
        (1, Side::Left, [1, 2]),
        (1, Side::Right, [3, 4]),
        (2, Side::Left, [3, 4]),
        (2, Side::Right, [3, 4]),
        (3, Side::Left, [0, 0]),
    ] {
        assert_eq!(evaluator.point(&integer(x), side), expected.map(integer), "{x}, {side}");
        assert_eq!(evaluator.tangent(&integer(x), side), None);
    }
    let line = on(1, &[0, 0, 2, 2], "inf", &[[1, 1], [5, 3]]);
    let mut evaluator = CurveEvaluator::new(&line);
    for side in [Side::Left, Side::Right] {
        let end = evaluator.tangent(&integer(2), side).expect("the limit from the left");
        assert_eq!((end.order, end.direction), (1, [2, 1].map(integer).to_vec()));
        assert_eq!(end.curvature, Some(vec![integer(0); 2]));
    }
    assert_eq!(evaluator.tangent(&integer(0), Side::Left), None);
    assert_eq!(evaluator.de_boor(&integer(3), Side::Right), None);
}

/// Double control points: the direction is that of a higher derivative, from the left and from the right the one in which the
/// curve is run through.
#[test]
fn where_the_speed_is_0() {
    // (1 − s²)P₂ + s²P₀ on the left of 1, P₂ on the right.
    let stops = on(2, &[0, 0, 0, 1, 1, 2, 2, 2], "inf", &[[0, 0], [4, 2], [4, 2], [4, 2], [4, 2]]);
    let mut evaluator = CurveEvaluator::new(&stops);
    let before = evaluator.tangent(&integer(1), Side::Left).expect("it moves");
    assert_eq!((before.order, before.direction), (2, [4, 2].map(integer).to_vec()));
    assert_eq!(before.curvature, Some(vec![integer(0); 2]));
    assert_eq!(evaluator.tangent(&integer(1), Side::Right), None);

    // P₃ + 3s²(P₁ − P₃) + s³(P₀ − 3P₁ + 2P₃) on the left of 1: a cusp of infinite curvature.
    let points = [[0, 0], [0, 1], [0, 0], [0, 0], [0, 0], [1, 1], [3, 0]];
    let cusp = on(3, &[0, 0, 0, 0, 1, 1, 1, 2, 2, 2, 2], "inf", &points);
    let mut evaluator = CurveEvaluator::new(&cusp);
    let before = evaluator.tangent(&integer(1), Side::Left).expect("it moves");
    assert_eq!((before.order, before.direction), (2, [0, -3].map(integer).to_vec()));
    assert_eq!(before.curvature, Some(vec![integer(0); 2]), "P₀ lies on the line");
    let after = evaluator.tangent(&integer(1), Side::Right).expect("it moves");
    assert_eq!((after.order, after.direction), (2, [3, 3].map(integer).to_vec()));
    assert_eq!(after.curvature, None);
}

/// (t², t⁴) is the parabola y = x² at its vertex, with the curvature 2 there; and so is its reverse at the other end.
#[test]
fn the_curvature_is_that_of_what_is_seen() {
    let points = [[0, 0], [0, 0], [1, 0], [3, 0], [6, 6]];
    let mut reversed = points;
    reversed.reverse();
    for (points, x, side, direction) in [(points, 0, Side::Right, 1), (reversed, 1, Side::Left, -1)] {
        let parabola = on(4, &[0, 0, 0, 0, 0, 1, 1, 1, 1, 1], "inf", &points);
        let tangent = CurveEvaluator::new(&parabola).tangent(&integer(x), side).expect("it moves");
        // Six times as large: (6t², 6t⁴).
        assert_eq!((tangent.order, tangent.direction), (2, [6 * direction, 0].map(integer).to_vec()));
        assert_eq!(tangent.curvature, Some(vec![integer(0), rational(1, 3)]));
    }
}

/// α of a type that only the run of the program tells.
#[test]
fn an_index_is_an_index_however_it_is_given() {
    let curve = on(2, &[0, 0, 0, 1, 2, 2, 2], "5", &[[0, 0], [1, 2], [2, 2], [3, 0]]);
    let any = curve.with(AnyWeights::Index("5".parse().expect("an index")));
    let (mut one, mut other) = (CurveEvaluator::new(&curve), CurveEvaluator::new(&any));
    for x in places(curve.basis(), &rational(1, 3)) {
        assert_eq!(one.point(&x, Side::Right), other.point(&x, Side::Right));
        assert_eq!(one.tangent(&x, Side::Left), other.tangent(&x, Side::Left));
    }
}
