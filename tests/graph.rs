//! Where a curve takes a value, and between which it stays: by hand, and against exact values at many points.

#![allow(clippy::unwrap_used, reason = "helpers of tests")]

use knotproof::analysis::{
    Algebraic, CurvePart, Enclosed, ExtremumKind, Graph, Location, RationalBezier, Sign, Solution,
    SolutionKind,
};
use knotproof::scalar::{BigRational, integer, rational};
use knotproof::spline::{Basis, Curve, HasWeights, KnotVector, Side};
use num_traits::Signed;
use proptest::prelude::*;

use crate::rational_bezier::any_curve;

/// A curve in one dimension.
fn line(k: usize, knots: &[i64], alpha: &str, points: &[i64]) -> Curve {
    let knots = KnotVector::new(knots.iter().map(|&t| integer(t)).collect()).unwrap();
    let basis = Basis::new(knots, k, alpha.parse().unwrap()).unwrap();
    Curve::new(basis, points.iter().map(|&d| vec![integer(d)]).collect()).unwrap()
}

fn part(curve: &Curve, from: Option<&BigRational>, to: Option<&BigRational>) -> Vec<RationalBezier> {
    let part = CurvePart::of(curve, from, to).unwrap();
    RationalBezier::pieces_on(curve, &part).collect::<Result<_, _>>().unwrap()
}

fn graph(curve: &Curve, normal: &[BigRational]) -> Graph {
    Graph::of(&part(curve, None, None), normal)
}

fn first(curve: &Curve) -> Graph {
    graph(curve, &[integer(1)])
}

fn plateau(from: i64, to: i64, closed: bool) -> Location {
    Location::Plateau { from: integer(from), to: integer(to), closed }
}

fn told(solution: &Solution) -> (Location, SolutionKind, Option<Sign>, Option<Sign>) {
    (solution.place.clone(), solution.kind, solution.before, solution.after)
}

/// Degree 0: all is plateaus and jumps.
#[test]
fn steps() {
    use Sign::{Negative, Positive};
    use SolutionKind::{Passed, Taken};
    let steps = first(&line(0, &[0, 1, 2, 3, 4], "2", &[0, 2, 2, 1]));
    let at = |value: i64| steps.solutions(&integer(value)).iter().map(told).collect::<Vec<_>>();
    assert_eq!(at(0), [(plateau(0, 1, false), Taken, None, Some(Positive))]);
    assert_eq!(at(2), [(plateau(1, 3, false), Taken, Some(Negative), Some(Negative))]);
    assert_eq!(
        at(1),
        [
            (Location::Point(integer(1)), Passed, Some(Negative), Some(Positive)),
            (plateau(3, 4, true), Taken, Some(Positive), None)
        ]
    );
    assert_eq!(at(3), []);
    let range = steps.range();
    assert_eq!(range.highest.places, [(plateau(1, 3, false), true)]);
    assert_eq!(range.lowest.value.exact(), Some(&integer(0)));
    assert_eq!(steps.jumps().len(), 2);
    // A constant has no extremum, and both bounds everywhere.
    let flat = first(&line(0, &[0, 1, 2], "2", &[5, 5]));
    assert_eq!(flat.range().lowest.places, [(plateau(0, 2, true), true)]);
    assert_eq!(flat.extrema(), []);
    assert_eq!(flat.solutions(&integer(5)).len(), 1);
}

/// A rise to a limit that is not taken, and a fall from a value that is.
#[test]
fn jumps_at_full_knots() {
    let curve = line(1, &[0, 0, 1, 1, 2, 2], "5", &[0, 3, 1, 0]);
    let graph = first(&curve);
    let at = |value: i64| graph.solutions(&integer(value)).iter().map(told).collect::<Vec<_>>();
    let one = || Location::Point(integer(1));
    assert_eq!(at(3), [(one(), SolutionKind::LimitFromLeft, Some(Sign::Negative), Some(Sign::Negative))]);
    assert_eq!(at(2).len(), 2);
    assert_eq!(at(2)[1].1, SolutionKind::Passed);
    // 1 on the way up, and again after the jump.
    assert_eq!(at(1).len(), 2);
    assert_eq!(at(1)[1], (one(), SolutionKind::Taken, Some(Sign::Positive), Some(Sign::Negative)));
    let range = graph.range();
    assert_eq!(
        (range.highest.value.exact(), &range.highest.places[..]),
        (Some(&integer(3)), &[(one(), false)][..])
    );
    let ends = [0, 2].map(|x| (Location::Point(integer(x)), true));
    assert_eq!(range.lowest.places, ends);
    assert_eq!(
        CurvePart::of(&curve, Some(&integer(2)), None).unwrap_err().to_string(),
        "2 is not in [0, 2), where the curve is"
    );
    assert_eq!(
        CurvePart::of(&curve, Some(&integer(1)), Some(&integer(3))).unwrap_err().to_string(),
        "3 is not in (1, 2], where the curve goes on"
    );
    // On a part the ends are limits from inside.
    let left = Graph::of(&part(&curve, None, Some(&integer(1))), &[integer(1)]);
    assert_eq!(
        told(&left.solutions(&integer(3))[0]),
        (one(), SolutionKind::Taken, Some(Sign::Negative), None)
    );
    assert_eq!(left.range().highest.places, [(one(), true)]);
}

/// Touching is no crossing, and both of two equal maxima at irrational places are told.
#[test]
fn a_symmetric_curve_has_both_of_its_maxima() {
    let curve = line(3, &[0, 0, 0, 0, 1, 2, 3, 3, 3, 3], "inf", &[0, 4, 1, 1, 4, 0]);
    let range = first(&curve).range();
    assert_eq!(range.highest.places.len(), 2);
    let places: Vec<_> = range.highest.places.iter().map(|(place, _)| place.clone()).collect();
    assert!(places.iter().all(|place| matches!(place, Location::Irrational { .. })), "{places:?}");
    let touching = line(2, &[0, 0, 0, 1, 1, 1], "-1", &[1, -1, 1]);
    let solutions = first(&touching).solutions(&integer(0));
    assert_eq!(solutions.len(), 1);
    assert_eq!((solutions[0].before, solutions[0].after), (Some(Sign::Positive), Some(Sign::Positive)));
    assert_eq!(solutions[0].place, Location::Point(rational(2, 3)));
}

/// (Left, right) limits at points of all spans, their ends among them.
fn samples(curve: &Curve, normal: &[BigRational]) -> Vec<(BigRational, BigRational)> {
    let knots = curve.basis().knots();
    let value = |x: &BigRational, side| -> BigRational {
        curve.point(x, side).iter().zip(normal).map(|(c, a)| c * a).sum()
    };
    let mut all = Vec::new();
    for span in knots.spans() {
        let (a, b) = knots.ends(span).unwrap();
        for s in 0..=12 {
            let x = a + (b - a) * rational(s, 12);
            let side = if s == 12 { Side::Left } else { Side::Right };
            let value = value(&x, side);
            all.push((x, value));
        }
    }
    all
}

fn bounds(mut number: Algebraic) -> (BigRational, BigRational) {
    number.bounds_within(&rational(1, 1 << 30))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(120))]

    /// All samples are in the range, and each bound is what the curve has at its places.
    #[test]
    fn ranges_hold_all_values_and_are_reached(curve in any_curve(0..=4)) {
        let normal: Vec<_> = [2, -1, 3].map(|a| rational(a, 2))[..curve.dimension()].to_vec();
        let graph = graph(&curve, &normal);
        let range = graph.range();
        let [(lo, _), (_, hi)] = [&range.lowest, &range.highest].map(|bound| bounds(bound.value.clone()));
        for (x, value) in samples(&curve, &normal) {
            prop_assert!(lo <= value && value <= hi, "{value} at {x}");
        }
        let mut evaluated = 0;
        for bound in [&range.lowest, &range.highest] {
            prop_assert!(!bound.places.is_empty());
            for (place, taken) in &bound.places {
                let side = if *taken { Side::Right } else { Side::Left };
                if let (Some(x), Some(value)) = (place.x().exact(), bound.value.exact()) {
                    let own: BigRational = curve.point(x, side).iter().zip(&normal).map(|(c, a)| c * a).sum();
                    prop_assert_eq!(&own, value, "at {}", x);
                    evaluated += 1;
                } else {
                    // Close by, from both sides, it is as close as the slope allows: within the bounds of a narrow interval.
                    let mut place = place.clone();
                    place.refine_to(&rational(1, 1 << 40));
                    let (at, _) = place.interval();
                    let own: BigRational = curve.point(at, Side::Right).iter().zip(&normal).map(|(c, a)| c * a).sum();
                    let (lo, hi) = bounds(bound.value.clone());
                    let near = rational(1, 1 << 20);
                    prop_assert!(lo - &near <= own && own <= hi + near);
                }
            }
        }
        // The greatest of the local maxima, the limits at jumps, and of a constant its value: another way to the same.
        let jumps = graph.jumps();
        let extrema = graph.extrema();
        let maxima = extrema.iter().filter(|e| e.kind == ExtremumKind::Maximum).map(|e| e.height());
        let limits = jumps.iter().flat_map(|jump| [&jump.left, &jump.right]).map(|limit| limit.clone().into());
        let (mut highest, mut equal) = (range.highest.value.clone(), 0);
        for mut other in maxima.chain(limits) {
            let order = other.compare(&mut highest);
            prop_assert!(order.is_some_and(|order| order.is_le()));
            equal += usize::from(order.is_some_and(|order| order.is_eq()));
        }
        let constant = range.lowest.value == range.highest.value;
        prop_assert!(equal > 0 || constant, "{evaluated}");
    }

    /// Each solution, put back, is one; and between two samples on different sides of the value there is one.
    #[test]
    fn solutions_are_all_there(curve in any_curve(0..=4), v in -6_i64..=6) {
        let value = rational(v, 3);
        let normal: Vec<_> = [1, 2, -1].map(integer_of)[..curve.dimension()].to_vec();
        let graph = graph(&curve, &normal);
        let solutions = graph.solutions(&value);
        let at = |x: &BigRational, side| -> BigRational {
            curve.point(x, side).iter().zip(&normal).map(|(c, a)| c * a).sum::<BigRational>() - &value
        };
        for solution in &solutions {
            match (&solution.place, solution.kind) {
                (Location::Point(x), SolutionKind::Taken) => {
                    prop_assert_eq!(at(x, Side::Right), integer(0));
                    let again = graph.at(solution).unwrap();
                    prop_assert_eq!(again.exact(), Some(&value));
                }
                (Location::Point(x), SolutionKind::LimitFromLeft) => {
                    prop_assert_eq!(at(x, Side::Left), integer(0));
                    prop_assert!(at(x, Side::Right) != integer(0));
                }
                (Location::Point(x), SolutionKind::Passed) => {
                    prop_assert!((at(x, Side::Left) * at(x, Side::Right)).is_negative());
                }
                (Location::Irrational { lo, hi, .. }, _) => {
                    let signs = [lo, hi].map(|x| Some(Sign::of(&at(x, Side::Right))));
                    prop_assert_eq!([solution.before, solution.after], signs);
                }
                (Location::Plateau { from, to, closed }, _) => {
                    for s in 0..4 {
                        let x = from + (to - from) * rational(s, 4);
                        prop_assert_eq!(at(&x, Side::Right), integer(0));
                    }
                    prop_assert_eq!(*closed, at(to, Side::Right) == integer(0));
                }
            }
        }
        let samples = samples(&curve, &normal);
        for pair in samples.windows(2) {
            let [(a, left), (b, right)] = pair else { unreachable!() };
            if ((left - &value) * (right - &value)).is_negative() {
                let within = |solution: &Solution| {
                    let (lo, hi) = solution.place.interval();
                    a <= hi && lo <= b
                };
                prop_assert!(solutions.iter().any(within), "between {a} and {b}");
            }
        }
        prop_assert!(solutions.windows(2).all(|pair| pair[0].place.interval().0 <= pair[1].place.interval().0));
    }

    /// A part of a curve has the solutions of the whole that lie in it.
    #[test]
    fn parts_agree_with_the_whole(curve in any_curve(1..=3), s in 1_i64..=5, t in 1_i64..=5) {
        let (first, last) = (curve.basis().knots().first(), curve.basis().knots().last());
        let from = first + (last - first) * rational(s, 12);
        let to = last - (last - first) * rational(t, 13);
        let normal = [integer(1)];
        let on_part = Graph::of(&part(&curve, Some(&from), Some(&to)), &normal);
        let value = rational(1, 7);
        let inside = |solution: &&Solution| {
            let (lo, hi) = solution.place.interval();
            &from < lo && hi < &to
        };
        let count = |graph: &Graph| graph.solutions(&value).iter().filter(inside).count();
        prop_assert_eq!(count(&on_part), count(&graph(&curve, &normal)));
    }

    /// The hodograph of each piece is the derivative of the curve.
    #[test]
    fn derivatives_of_pieces(curve in any_curve(0..=4)) {
        for piece in RationalBezier::pieces(&curve) {
            let piece = piece.unwrap();
            let slope = piece.derivative().unwrap();
            prop_assert!(slope.weights().iter().all(|weight| *weight > integer(0)));
            prop_assert!(slope.degree() <= 2 * piece.degree());
            let (from, to) = piece.ends();
            for (s, side) in [((0, 1), Side::Right), ((2, 7), Side::Right), ((1, 1), Side::Left)] {
                let x = from + (to - from) * rational(s.0, s.1);
                let by_jets: Vec<_> = curve.jets(&x, side, 1).iter().map(|jet| jet.derivatives()[1].clone()).collect();
                prop_assert_eq!(slope.point(&x), Some(by_jets));
            }
        }
    }
}

fn integer_of(value: i64) -> BigRational {
    rational(value, 1)
}

/// Weights of another kind go the same way.
#[test]
fn forms_are_taken_too() {
    use knotproof::spline::{FormTable, Forms};
    let curve = line(2, &[0, 0, 0, 1, 2, 2, 2], "3", &[0, 4, -1, 2]);
    let knots = curve.basis().knots().clone();
    let ratio = curve.basis().index().ratio().clone();
    let forms = || Forms::new(vec![integer(0), ratio.clone()], vec![integer(1), integer(0)], None).unwrap();
    let other = curve.with(FormTable::new(&knots, 2, |_, _, _| Ok::<_, ()>(forms())).unwrap());
    let range = |pieces: Vec<RationalBezier>| Graph::of(&pieces, &[integer(1)]).range();
    fn pieces<W: HasWeights>(curve: &Curve<W>) -> Vec<RationalBezier> {
        RationalBezier::pieces(curve).collect::<Result<_, _>>().unwrap()
    }
    let (own, others) = (range(pieces(&curve)), range(pieces(&other)));
    let (mut a, mut b) = (own.highest.value, others.highest.value);
    assert_eq!(a.compare(&mut b), Some(std::cmp::Ordering::Equal));
    assert!(a.bounds().0 > integer(1));
}
