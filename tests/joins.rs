//! How curves meet at knots: by hand, under maps that must not change it, and the paper's curves.

use knotproof::analysis::{Enclosed, Join, joins, settled};
use knotproof::language::paper;
use knotproof::meaning::examples;
use knotproof::report::corners;
use knotproof::scalar::{BigRational, decimal, integer, parse_rational, rational};
use knotproof::spline::{AnyWeights, Basis, Curve, CurveError, Index, KnotVector, Point};
use proptest::prelude::*;
use serde::Deserialize;

fn on<const D: usize>(degree: usize, knots: &[i64], alpha: &str, points: &[[i64; D]]) -> Curve {
    let knots = KnotVector::new(knots.iter().map(|t| integer(*t)).collect()).expect("knots");
    let basis = Basis::new(knots, degree, alpha.parse().expect("an index")).expect("enough knots");
    Curve::new(basis, points.iter().map(|point| point.map(integer).to_vec()).collect())
        .expect("enough points")
}

/// The one join of a curve.
fn join<const D: usize>(degree: usize, knots: &[i64], alpha: &str, points: &[[i64; D]]) -> Join {
    let mut joins = joins(&on(degree, knots, alpha, points));
    assert_eq!(joins.len(), 1);
    joins.remove(0)
}

fn levels(join: &Join) -> (bool, Option<bool>, Option<bool>) {
    (join.g0(), join.g1(), join.g2())
}

fn degrees(join: &Join) -> Option<String> {
    Some(settled(&mut join.angle()?, 6))
}

/// At a simple knot a classical curve of degree k has k − 1 continuous derivatives.
#[test]
fn classical_curves() {
    let knots = [0, 0, 0, 0, 1, 3, 3, 3, 3];
    let cubic = join(3, &knots, "inf", &[[0, 0], [1, 5], [2, -1], [7, 3], [8, 8]]);
    assert_eq!(levels(&cubic), (true, Some(true), Some(true)));
    assert_eq!(cubic.speed_ratio_square(), Some(integer(1)));
    assert_eq!(settled(&mut cubic.curvature_jump().expect("finite"), 6), "0");
    let quadric = join(2, &knots[1..8], "inf", &[[0, 0], [1, 5], [2, -1], [7, 3]]);
    assert_eq!(levels(&quadric), (true, Some(true), Some(false)));
    let polygon = join(1, &[0, 0, 1, 3, 3], "inf", &[[0, 0], [2, 0], [2, 5]]);
    assert_eq!(
        (levels(&polygon), degrees(&polygon).as_deref()),
        ((true, Some(false), Some(false)), Some("90.0000"))
    );
    assert_eq!(polygon.speed_ratio_square(), Some(rational(25, 16)));
}

/// Two parabolas, y = x² and y = 3x², run through with the speeds 1 and 2 at 0.
#[test]
fn curvature_and_speed_by_hand() {
    let knots = [0, 0, 0, 2, 2, 4, 4, 4];
    let parabolas = join(2, &knots, "inf", &[[-2, 4], [-1, 0], [0, 0], [2, 0], [4, 48]]);
    assert_eq!(levels(&parabolas), (true, Some(true), Some(false)));
    assert_eq!(parabolas.speed_ratio_square(), Some(integer(4)));
    let squares = [&parabolas.before, &parabolas.after].map(|branch| branch.curvature_square());
    assert_eq!(squares, [Some(integer(4)), Some(integer(36))]);
    let four = integer(4);
    assert_eq!(parabolas.curvature_jump().expect("finite").bounds(), (four.clone(), four));
    // Upside down the same curves bend to the right.
    let below = join(2, &knots, "inf", &[[-2, -4], [-1, 0], [0, 0], [2, 0], [4, -48]]);
    assert_eq!(below.before.curvature_square(), Some(integer(-4)));
    // From one into the other through a point of inflection: G¹, and as large a curvature on both sides.
    let inflection = join(2, &knots, "inf", &[[-2, 4], [-1, 0], [0, 0], [1, 0], [2, -4]]);
    assert_eq!(levels(&inflection), (true, Some(true), Some(false)));
    assert_eq!(settled(&mut inflection.curvature_jump().expect("finite"), 3), "-4.00");
}

#[test]
fn a_knot_at_which_the_curve_jumps() {
    let knots = [0, 0, 0, 1, 1, 1, 2, 2, 2];
    let jump = join(2, &knots, "-1", &[[0, 0], [1, 0], [2, 0], [2, 1], [3, 1], [4, 1]]);
    assert_eq!((levels(&jump), degrees(&jump).as_deref()), ((false, Some(false), Some(false)), Some("0")));
    let meets = join(2, &knots, "inf", &[[0, 0], [1, 0], [2, 0], [2, 0], [3, 0], [4, 0]]);
    assert_eq!(levels(&meets), (true, Some(true), Some(true)));
}

#[test]
fn where_a_side_has_no_speed() {
    let knots = [0, 0, 0, 1, 1, 2, 2, 2];
    // Straight into the knot with speed 0, and straight on.
    let slow = join(2, &knots, "-1", &[[0, 0], [4, 2], [4, 2], [6, 3], [8, 4]]);
    assert_eq!((levels(&slow), slow.speed_ratio_square()), ((true, Some(true), Some(true)), None));
    assert_eq!(slow.before.tangent.as_ref().map(|tangent| tangent.order), Some(2));
    // Back where it came from.
    let back = join(2, &knots, "-1", &[[0, 0], [4, 2], [4, 2], [2, 1], [-2, -1]]);
    assert_eq!((back.g1(), degrees(&back).as_deref()), (Some(false), Some("180.000")));
    // It stands still behind the knot.
    let still = join(2, &knots, "-1", &[[0, 0], [4, 0], [4, 2], [4, 2], [4, 2]]);
    assert_eq!((levels(&still), still.after.tangent.is_none()), ((true, None, None), true));
    // With one point for all functions it moves where these add up to less than 1.
    let below = &joins(&on(1, &[0, 1, 2, 3], "-1", &[[1, 1], [1, 1]]))[0];
    assert!(below.before.tangent.is_some() && below.after.tangent.is_none());
    // Both curvatures are infinite.
    let points = [[3, 0], [1, 1], [0, 0], [0, 0], [0, 0], [-1, -1], [-3, 0]];
    let infinite = join(3, &[0, 0, 0, 0, 1, 1, 1, 2, 2, 2, 2], "inf", &points);
    assert_eq!((levels(&infinite), infinite.curvature_jump()), ((true, Some(true), None), None));
}

#[test]
fn space_and_line() {
    let corner = join(1, &[0, 0, 1, 2, 2], "inf", &[[0, 0, 0], [1, 1, 0], [1, 2, 1]]);
    assert_eq!(corner.angle().expect("directions").bounds().0, integer(60));
    // As curved on both sides, but in another plane.
    let knots = [0, 0, 0, 1, 1, 2, 2, 2];
    let twist = join(2, &knots, "inf", &[[-2, 1, 0], [-1, 0, 0], [0, 0, 0], [1, 0, 0], [2, 0, 1]]);
    assert_eq!(levels(&twist), (true, Some(true), Some(false)));
    assert_eq!(settled(&mut twist.curvature_jump().expect("finite"), 6), "0");
    let line = join(2, &knots, "-1", &[[0], [1], [2], [4], [5]]);
    assert_eq!(
        (levels(&line), line.speed_ratio_square()),
        ((true, Some(true), Some(true)), Some(rational(1, 4)))
    );
    let turn = join(2, &knots, "-1", &[[0], [1], [2], [1], [5]]);
    assert_eq!((turn.g1(), degrees(&turn).as_deref()), (Some(false), Some("180.000")));
}

/// The ends of a closed curve are compared on [t_k, t_{n+1}], whether knots are open or periodic.
#[test]
fn closed_curves() {
    let triangle = joins(&on(1, &[0, 0, 1, 2, 3, 3], "inf", &[[0, 0], [1, 0], [0, 1], [0, 0]]));
    let closing = triangle.last().expect("closed");
    assert_eq!((triangle.len(), closing.closing, degrees(closing).as_deref()), (3, true, Some("90.0000")));
    let periodic = [[0, 0], [4, 0], [4, 4], [0, 4], [0, 0], [4, 0], [4, 4]];
    for (alpha, smooth) in [("inf", true), ("-1", false)] {
        let closed = joins(&on(3, &[0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10], alpha, &periodic));
        let closing = closed.last().expect("closed");
        assert_eq!((&closing.knot, closing.closing), (&integer(7), true));
        assert_eq!((closing.g1(), closing.g2()), (Some(smooth), Some(smooth)), "{alpha}");
        // The join of any inner knot of the base spans is the same by symmetry: a quarter of a turn on.
        let inner = closed.iter().find(|join| join.knot == integer(5)).expect("a knot");
        assert_eq!(
            (inner.angle(), inner.speed_ratio_square()),
            (closing.angle(), closing.speed_ratio_square())
        );
    }
    assert!(
        joins(&on(1, &[0, 0, 1, 2, 2], "inf", &[[0, 0], [1, 0], [0, 1]])).iter().all(|join| !join.closing)
    );
}

/// The paper's figures: is the loss of regularity seen?
#[test]
fn the_paper_s_curves() {
    let find = |name: &str, alpha: &str| {
        let example = examples().iter().find(|example| &*example.name == name).expect("it is shown");
        let wanted = |weights: &knotproof::meaning::Weighting| {
            weights.index().is_some_and(|own| own.to_string() == alpha)
        };
        let (_, curve) = example.curves().find(|(weights, _)| wanted(weights)).expect("for this α");
        joins(&curve)
    };
    let sharpest = |joins: &[Join]| {
        let angles = joins.iter().filter_map(Join::angle);
        settled(&mut angles.max_by(|a, b| a.compare(b)).expect("some"), 3)
    };
    let c5 = find("C5", "-4");
    assert_eq!((c5.len(), sharpest(&c5).as_str()), (4, "0.128"));
    let s4 = find("S4", "-1/5");
    assert_eq!((s4.len(), sharpest(&s4).as_str()), (10, "0.996"));
    assert!(c5.iter().chain(&s4).all(Join::g0) && c5.iter().all(|join| join.g1() == Some(false)));
    // Speeds change to 0.28 of what they were, of all curves at knots where the classical one is smooth.
    let all =
        examples().iter().flat_map(|example| example.curves().map(move |(_, curve)| (example.degree, curve)));
    let ratios = all.flat_map(|(degree, curve)| {
        let smooth =
            joins(&curve).into_iter().filter(move |join| join.multiplicity < degree && !join.closing);
        smooth.filter_map(|join| join.speed_ratio_square())
    });
    let slowest = ratios.min().expect("some");
    assert_eq!(slowest, rational(25 * 25, 88 * 88));
    assert_eq!(decimal(&rational(25, 88), 2), "0.28");
    let classical = find("S4", "inf");
    assert!(classical.iter().all(|join| levels(join) == (true, Some(true), Some(true))));
    assert_eq!(corners(paper()).len(), 561);
}

/// The same curve run through backwards: reflected knots, 1 − α, and the points in reverse.
fn reversed(curve: &Curve) -> Curve {
    let basis = curve.basis();
    let knots = basis.knots().knots().iter().rev().map(|t| basis.knots().mirror(t)).collect();
    let knots = KnotVector::new(knots).expect("knots");
    let basis = Basis::new(knots, basis.degree(), basis.index().conjugate()).expect("enough knots");
    Curve::new(basis, curve.points().iter().rev().cloned().collect()).expect("enough points")
}

fn curves() -> impl Strategy<Value = Curve> {
    let gap = prop_oneof![2 => Just(0_i64), 3 => 1_i64..5];
    let (ratio, point) = ((1_i64..9, 1_i64..9), (-3_i64..4, -3_i64..4));
    let points = prop::collection::vec(point, 20);
    (1_usize..5, prop::collection::vec(gap, 4..16), ratio, points).prop_filter_map(
        "no curve",
        |(degree, gaps, (p, q), points)| {
            let knots = gaps.iter().scan(integer(0), |t, gap| {
                *t += integer(*gap);
                Some(t.clone())
            });
            let index = Index::from_ratio(rational(p, q)).ok()?;
            let basis = Basis::new(KnotVector::new(knots.collect()).ok()?, degree, index).ok()?;
            let points = points[..=basis.n()].iter().map(|(x, y)| vec![integer(*x), integer(*y)]).collect();
            Curve::new(basis, points).ok()
        },
    )
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]
    /// Backwards the angle is the same, the ratio of speeds its reciprocal, and the curvature changes its sign.
    #[test]
    fn backwards(curve in curves()) {
        let forth = joins(&curve);
        let mut back = joins(&reversed(&curve));
        let closing = back.iter().position(|join| join.closing);
        prop_assert_eq!(closing.is_some(), forth.iter().any(|join| join.closing));
        let last = closing.map(|at| back.remove(at));
        back.reverse();
        back.extend(last);
        prop_assert_eq!(forth.len(), back.len());
        for (join, other) in forth.iter().zip(&back) {
            prop_assert_eq!(levels(join), levels(other));
            prop_assert_eq!(join.angle(), other.angle());
            let reciprocal = other.speed_ratio_square().map(|ratio| ratio.recip());
            prop_assert_eq!(join.speed_ratio_square(), reciprocal);
            let negated = other.after.curvature_square().map(|square| -square);
            prop_assert_eq!(join.before.curvature_square(), negated);
        }
    }

    /// Under a similarity by the factor 10, a rotation by (3, 4)/5 among it, only curvatures change: they get a tenth. In space
    /// with a coordinate 0 they are the same without a sign.
    #[test]
    fn similar_curves(curve in curves()) {
        let map = |image: &dyn Fn(&BigRational, &BigRational) -> Point| {
            let points = curve.points().iter().map(|point| image(&point[0], &point[1])).collect();
            joins(&Curve::new(curve.basis().clone(), points).expect("as many points"))
        };
        let [six, eight] = [6, 8].map(integer);
        let turned = map(&|x, y| vec![&six * x - &eight * y, &eight * x + &six * y]);
        let lifted = map(&|x, y| vec![x.clone(), y.clone(), integer(0)]);
        for ((join, turned), lifted) in joins(&curve).iter().zip(&turned).zip(&lifted) {
            for other in [turned, lifted] {
                prop_assert_eq!(levels(join), levels(other));
                prop_assert_eq!(join.angle(), other.angle());
                prop_assert_eq!(join.speed_ratio_square(), other.speed_ratio_square());
            }
            let tenth = turned.after.curvature_square().map(|square| square * integer(100));
            prop_assert_eq!(join.after.curvature_square(), tenth);
            let unsigned = join.after.curvature_square().map(|square| if square < integer(0) { -square } else { square });
            prop_assert_eq!(unsigned, lifted.after.curvature_square());
        }
    }
}

/// With the fast kernels and with forms of the same weights.
#[test]
fn any_weights() {
    let curve = on(2, &[0, 0, 0, 1, 2, 2, 2], "5", &[[0, 0], [1, 2], [2, 2], [3, 0]]);
    let index: Index = "5".parse().expect("an index");
    assert_eq!(joins(&curve), joins(&curve.with(AnyWeights::Index(index))));
}

/// A closed curve from the knots of a period: where it begins makes no difference.
#[test]
fn a_period_can_begin_at_any_knot() {
    let points = [[0, 0], [5, 1], [6, 6], [-1, 4]].map(|point| point.map(integer).to_vec());
    for (degree, alpha) in [(0, "-1"), (1, "2"), (2, "-1"), (3, "-1/5"), (3, "inf"), (7, "5")] {
        let closed = |knots: [i64; 5], points: &[Point]| {
            let period = KnotVector::new(knots.map(integer).to_vec()).expect("knots");
            joins(
                &Curve::closed(&period, degree, alpha.parse::<Index>().expect("an index"), points)
                    .expect("a curve"),
            )
        };
        let first = closed([0, 1, 1, 3, 4], &points);
        let second = closed([1, 1, 3, 4, 5], &[&points[1..], &points[..1]].concat());
        let ends = first.iter().find(|join| join.closing);
        let inner = second.iter().find(|join| join.knot == integer(4) && !join.closing).expect("a knot");
        let Some(ends) = ends else {
            assert!(degree == 0 && !inner.g0());
            continue;
        };
        assert_eq!((levels(ends), ends.angle()), (levels(inner), inner.angle()), "degree {degree}");
        assert_eq!(ends.speed_ratio_square(), inner.speed_ratio_square());
        assert_eq!((&ends.before, &ends.after), (&inner.before, &inner.after));
        assert_eq!(ends.g1() == Some(true), alpha == "inf" || degree == 2);
    }
    let period = KnotVector::new([0, 1, 2].map(integer).to_vec()).expect("knots");
    let wrong = Curve::closed(&period, 2, Index::infinity(), &points);
    assert_eq!(wrong, Err(CurveError::Period { needed: 2, count: 4 }));
}

#[derive(Deserialize)]
struct Golden {
    source: String,
    cases: Vec<Case>,
}

#[derive(Deserialize)]
struct Case {
    degree: usize,
    knots: Vec<String>,
    alpha: String,
    points: Vec<Vec<String>>,
    joins: Vec<Found>,
}

/// One knot: the squares of the curvatures have their signs.
#[derive(Deserialize)]
struct Found {
    knot: String,
    g0: bool,
    cos2: String,
    turns_back: bool,
    speed_ratio_squared: String,
    before: String,
    after: String,
}

/// Against `tests/golden/joins.json`, which an implementation of its own wrote: see `generate_joins.py` there.
#[test]
fn another_implementation_finds_the_same_joins() {
    let golden: Golden = serde_json::from_str(include_str!("golden/joins.json")).expect("plain data");
    assert_eq!(golden.source, "tests/golden/generate_joins.py");
    assert!(golden.cases.len() >= 60);
    let number = |text: &String| parse_rational(text).expect("a number");
    for case in golden.cases {
        let knots = KnotVector::new(case.knots.iter().map(number).collect()).expect("knots");
        let basis =
            Basis::new(knots, case.degree, case.alpha.parse().expect("an index")).expect("enough knots");
        let points = case.points.iter().map(|point| point.iter().map(number).collect()).collect();
        let found = joins(&Curve::new(basis, points).expect("enough points"));
        for expected in case.joins {
            let knot = number(&expected.knot);
            let join = found.iter().find(|join| join.knot == knot && !join.closing).expect("an inner knot");
            let angle = join.angle().expect("directions");
            assert_eq!((join.g0(), angle.is_obtuse()), (expected.g0, expected.turns_back));
            assert_eq!(*angle.cosine_square(), number(&expected.cos2));
            assert_eq!(join.speed_ratio_square(), Some(number(&expected.speed_ratio_squared)));
            assert_eq!(join.before.curvature_square(), Some(number(&expected.before)));
            assert_eq!(join.after.curvature_square(), Some(number(&expected.after)));
        }
    }
}
