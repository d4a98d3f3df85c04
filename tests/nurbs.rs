//! NURBS curves against the curve that they are: by the B-splines of their knots, which are the basis of α = ∞, and against
//! what is known of their knots and weights.

#![allow(clippy::unwrap_used, reason = "helpers of tests")]

use knotproof::analysis::{Nurbs, NurbsError, NurbsRequest, RationalBezier};
use knotproof::scalar::{BigInt, BigRational, integer, rational};
use knotproof::spline::{Basis, Curve, HasWeights, Index, KnotVector, Point, Side};
use proptest::prelude::*;

use crate::rational_bezier::any_curve;

fn curve(k: usize, knots: &[i64], alpha: &str, points: &[&[i64]]) -> Curve {
    let knots = KnotVector::new(knots.iter().map(|&t| integer(t)).collect()).unwrap();
    let basis = Basis::new(knots, k, alpha.parse().unwrap()).unwrap();
    Curve::new(basis, points.iter().map(|p| p.iter().map(|&c| integer(c)).collect()).collect()).unwrap()
}

fn joined<W: HasWeights>(curve: &Curve<W>, request: &NurbsRequest) -> Result<Vec<Nurbs>, NurbsError> {
    let pieces: Vec<_> = RationalBezier::pieces(curve).collect::<Result<_, _>>().unwrap();
    Nurbs::joined(curve, &pieces, request)
}

/// Each distinct number with how often it is there.
fn copies(knots: &[BigRational]) -> Vec<(BigRational, usize)> {
    knots.chunk_by(|a, b| a == b).map(|stop| (stop[0].clone(), stop.len())).collect()
}

/// Σ w_i c_i N_i(y) / Σ w_i N_i(y).
fn value(run: &Nurbs, y: &BigRational, side: Side) -> Point {
    let knots = KnotVector::new(run.knots().to_vec()).unwrap();
    let values = Basis::new(knots, run.degree(), Index::infinity()).unwrap().values(y, side);
    let (points, weights): (_, Vec<_>) = (run.points(), run.weights().collect());
    assert_eq!((points.len(), weights.len()), (values.len(), values.len()));
    let terms = || values.iter().zip(&weights).map(|(n, &w)| n * w);
    let total: BigRational = terms().sum();
    (0..points[0].len())
        .map(|c| terms().zip(&points).map(|(n, p)| n * &p[c]).sum::<BigRational>() / &total)
        .collect()
}

/// What every NURBS form is: positive weights, clamped knots, and the curve at points of each span.
fn is_the_curve<W: HasWeights>(runs: &[Nurbs], curve: &Curve<W>) {
    for run in runs {
        let copies = copies(run.knots());
        assert_eq!([&copies[0], &copies[copies.len() - 1]].map(|(_, count)| *count), [run.degree() + 1; 2]);
        assert!(copies[1..copies.len() - 1].iter().all(|(_, count)| (1..=run.degree()).contains(count)));
        assert_eq!(run.weights().next(), Some(&integer(1)));
        assert!(run.weights().all(|weight| *weight > integer(0)));
        assert!(run.pieces().all(|piece| piece.disagreement(curve).is_none()));
        let ends: Vec<_> = run.parameters().iter().map(|parameter| parameter.ends.clone()).collect();
        let stops: Vec<_> = copies.windows(2).map(|pair| [pair[0].0.clone(), pair[1].0.clone()]).collect();
        assert_eq!(ends, stops);
        for parameter in run.parameters() {
            let [a, b] = &parameter.ends;
            for (s, side) in [((0, 1), Side::Right), ((2, 7), Side::Right), ((1, 1), Side::Left)] {
                let s = rational(s.0, s.1);
                let at = &parameter.ratio * &s;
                let x = a + (b - a) * &at / (&at + integer(1) - &s);
                assert_eq!(value(run, &(a + (b - a) * &s), side), curve.point(&x, side), "x = {x}");
            }
        }
    }
}

#[test]
fn the_classical_index_keeps_knots_and_control_points() {
    let points: Vec<Point> = (0..9).map(|i| vec![integer(i * i % 7), integer(i % 3)]).collect();
    for knots in [&[0, 0, 0, 0, 1, 2, 2, 4, 5, 6, 6, 6, 6][..], &[0, 0, 0, 0, 1, 1, 1, 4, 5, 6, 6, 6, 6]] {
        let vector = KnotVector::new(knots.iter().map(|&t| integer(t)).collect()).unwrap();
        let curve =
            Curve::new(Basis::new(vector.clone(), 3, Index::infinity()).unwrap(), points.clone()).unwrap();
        for standard_form in [false, true] {
            let runs = joined(&curve, &NurbsRequest { standard_form, ..NurbsRequest::default() }).unwrap();
            is_the_curve(&runs, &curve);
            assert_eq!((runs.len(), runs[0].degree(), runs[0].knots()), (1, 3, vector.knots()));
            assert_eq!(runs[0].points(), points);
            assert!(runs[0].weights().all(|weight| *weight == integer(1)));
        }
        // Two degrees more: as smooth as before, with two copies more of each knot.
        let elevated = joined(&curve, &NurbsRequest { degree: Some(5), ..NurbsRequest::default() }).unwrap();
        is_the_curve(&elevated, &curve);
        let more: Vec<_> = copies(vector.knots()).into_iter().map(|(t, count)| (t, count + 2)).collect();
        assert_eq!(copies(elevated[0].knots()), more);
    }
}

/// A knot of k + 1 copies is a jump, unless the control points on both sides of it are the same.
#[test]
fn a_full_inner_knot_is_two_curves() {
    for alpha in ["inf", "-1"] {
        let request = NurbsRequest::default();
        let jumps = curve(1, &[0, 0, 1, 1, 2, 2], alpha, &[&[0], &[1], &[3], &[0]]);
        let runs = joined(&jumps, &request).unwrap();
        is_the_curve(&runs, &jumps);
        let knots: Vec<_> = runs.iter().map(|run| run.knots().to_vec()).collect();
        assert_eq!(knots, [[0, 0, 1, 1], [1, 1, 2, 2]].map(|knots| knots.map(integer).to_vec()));
        let meets = curve(1, &[0, 0, 1, 1, 2, 2], alpha, &[&[0], &[1], &[1], &[0]]);
        let runs = joined(&meets, &request).unwrap();
        is_the_curve(&runs, &meets);
        assert_eq!((runs.len(), runs[0].knots().len()), (1, 5));
    }
}

/// Degree 0, and what stands still: no program reads a NURBS curve of degree 0.
#[test]
fn the_degree_is_at_least_one() {
    let steps = curve(0, &[0, 1, 2, 3], "-1", &[&[4], &[4], &[5]]);
    let runs = joined(&steps, &NurbsRequest::default()).unwrap();
    is_the_curve(&runs, &steps);
    assert_eq!(
        runs.iter().map(|run| (run.degree(), run.knots().len())).collect::<Vec<_>>(),
        [(1, 5), (1, 4)]
    );
}

/// k = 6 and α = 100/99, so r = 100: the weights run away from piece to piece, and the standard form holds them.
#[test]
fn the_standard_form_holds_the_weights() {
    let points: Vec<Vec<i64>> = (0..13).map(|i| vec![i, i * i % 5]).collect();
    let points: Vec<&[i64]> = points.iter().map(Vec::as_slice).collect();
    let knots = [[0; 7].as_slice(), &[1, 3, 4, 8, 9, 11], &[13; 7]].concat();
    let curve = curve(6, &knots, "100/99", &points);
    let spread = |run: &Nurbs| run.weights().max().unwrap() / run.weights().min().unwrap();
    let chained = joined(&curve, &NurbsRequest::default()).unwrap();
    assert_eq!((chained.len(), chained[0].degree()), (1, 21));
    let ten = |n| integer(BigInt::from(10).pow(n));
    assert!(spread(&chained[0]) > ten(54), "{}", spread(&chained[0]));
    let request = NurbsRequest { standard_form: true, ..NurbsRequest::default() };
    let standard = joined(&curve, &request).unwrap();
    is_the_curve(&standard, &curve);
    assert!(spread(&standard[0]) < ten(15), "{}", spread(&standard[0]));
    let close = |parameter: &knotproof::analysis::SpanParameter| {
        let difference = &parameter.weight - integer(1);
        let bound = ten(18).recip();
        difference < bound && difference > -bound
    };
    assert!(standard[0].parameters().iter().all(close));
}

/// Without inner knots the weights are powers of r: λ = 1/r is rational, and the curve is a polynomial in y.
#[test]
fn a_rational_change_of_parameter_is_exact() {
    let curve = curve(2, &[0, 0, 0, 1, 1, 1], "-1", &[&[0, 0], &[1, 2], &[2, 0]]);
    let runs = joined(&curve, &NurbsRequest { standard_form: true, ..NurbsRequest::default() }).unwrap();
    is_the_curve(&runs, &curve);
    assert_eq!((&runs[0].parameters()[0].ratio, &runs[0].parameters()[0].weight), (&integer(2), &integer(1)));
    assert!(runs[0].weights().all(|weight| *weight == integer(1)));
    assert_eq!(runs[0].points(), curve.points());
}

#[test]
fn what_there_is_not_is_refused() {
    let curve = curve(2, &[0, 0, 0, 1, 2, 2, 2], "5", &[&[0, 0], &[1, 2], &[2, 2], &[3, 0]]);
    let refused = |request: NurbsRequest| joined(&curve, &request).unwrap_err().to_string();
    let whole = NurbsRequest::default;
    assert_eq!(
        refused(NurbsRequest { degree: Some(2), ..whole() }),
        "degree 2 is not between 3, the least that all pieces have, and 300"
    );
    assert!(refused(NurbsRequest { degree: Some(301), ..whole() }).contains("degree 301"));
    for from in [-1, 2, 3] {
        let message = refused(NurbsRequest { from: Some(integer(from)), ..whole() });
        assert_eq!(message, format!("{from} is not in [0, 2), where the curve is"));
    }
    for to in [0, 1, 3] {
        let message = refused(NurbsRequest { from: Some(integer(1)), to: Some(integer(to)), ..whole() });
        assert_eq!(message, format!("{to} is not in (1, 2], where the curve goes on"));
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(150))]

    #[test]
    fn runs_are_the_curve(
        curve in any_curve(0..=3),
        more in prop_oneof![2 => Just(None), 1 => (0_usize..3).prop_map(Some)],
        standard_form in any::<bool>(),
        cut in prop_oneof![Just(None), (0_i64..30, 1_i64..30).prop_map(Some)],
    ) {
        let knots = curve.basis().knots();
        let mut request = NurbsRequest { standard_form, ..NurbsRequest::default() };
        if let Some((from, length)) = cut {
            let at = |part: i64| knots.first() + (knots.last() - knots.first()) * rational(part, 60);
            (request.from, request.to) = (Some(at(from)), Some(at(from + length)));
        }
        let least = joined(&curve, &request).unwrap();
        let degree = least[0].degree();
        request.degree = more.map(|more| degree + more);
        let runs = joined(&curve, &request).unwrap();
        is_the_curve(&runs, &curve);
        // All of what is asked for, cut where the curve jumps and nowhere else.
        let from = request.from.as_ref().unwrap_or(knots.first());
        let to = request.to.as_ref().unwrap_or(knots.last());
        prop_assert_eq!((&runs[0].knots()[0], runs[runs.len() - 1].knots().last().unwrap()), (from, to));
        let jumps: Vec<_> = runs[1..].iter().map(|run| &run.knots()[0]).collect();
        let is_jump = |t: &&BigRational| curve.point(t, Side::Left) != curve.point(t, Side::Right);
        let expected: Vec<_> = knots.inner_stop_knots().map(|(t, _)| t).filter(|t| from < *t && *t < to).filter(is_jump).collect();
        prop_assert_eq!(jumps, expected);
        for run in &runs {
            prop_assert_eq!(run.degree(), degree + more.unwrap_or(0));
            if curve.basis().index().is_infinite() && curve.basis().degree() > 0 {
                prop_assert!(run.weights().all(|weight| *weight == integer(1)));
                let raised = run.degree() - curve.basis().degree();
                for (t, count) in &copies(run.knots())[1..] {
                    let own = knots.multiplicity(t).min(curve.basis().degree()) + raised;
                    prop_assert!(t == run.knots().last().unwrap() || *count == own, "{} copies of {}", count, t);
                }
            }
        }
    }
}
