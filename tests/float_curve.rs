//! Curves in floats against the exact ones of the same floats: derivatives, tangents, curvature, bounds, and the nearest points.

#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests")]
#![allow(clippy::float_cmp, reason = "exact floats are expected")]

use knotproof::analysis::{Enclosed, Surd};
use knotproof::float::{FloatBasis, FloatCurve, FloatError};
use knotproof::scalar::{BigRational, RationalAlgebra, exact_value, integer, rational};
use knotproof::spline::{CurveEvaluator, Side};
use num_traits::{Pow, Signed, Zero};
use proptest::prelude::*;

fn power(e: i32) -> BigRational {
    Pow::pow(rational(2, 1), e)
}

fn number(value: f64) -> BigRational {
    exact_value(value).unwrap()
}

fn sorted(mut knots: Vec<f64>) -> Vec<f64> {
    knots.sort_by(f64::total_cmp);
    knots
}

/// Curves in the plane with α of all sizes, and the points in [`places`].
fn curves() -> impl Strategy<Value = FloatCurve<f64>> {
    let alpha = prop_oneof![-20.0..-0.01, 1.001..20.0, Just(f64::INFINITY), Just(1.0 + f64::EPSILON)];
    let knots = prop::collection::vec(prop_oneof![-10.0..10.0, Just(1.0), Just(2.0)], 12);
    let points = prop::collection::vec(prop_oneof![-1e3..1e3, Just(0.0), Just(1.0)], 22);
    (knots, alpha, 0_usize..=5, points, -60_i32..60).prop_map(|(knots, alpha, k, points, scale)| {
        let basis = FloatBasis::new(sorted(knots), k, alpha).unwrap();
        let points = points[..(basis.n() + 1) * 2].iter().map(|d| d * 2.0_f64.powi(scale)).collect();
        FloatCurve::new(basis, 2, points).unwrap()
    })
}

fn places(curve: &FloatCurve<f64>, x: f64) -> [f64; 4] {
    let knots = curve.basis().knots();
    [x, knots[knots.len() / 2], knots[knots.len() - 1], knots[0] - 1.0]
}

/// The largest control value of a coordinate, times what bounds the sum of all terms of a derivative of order e: each level
/// multiplies a jet by w and 1 − w with every minus a plus, in the worst place of the span.
fn majorant(
    curve: &FloatCurve<f64>,
    x: &BigRational,
    side: Side,
    coordinate: usize,
    order: usize,
) -> Vec<BigRational> {
    let basis = curve.basis().exact();
    let (knots, k, r) = (basis.knots(), basis.degree(), basis.index().ratio());
    let largest = curve.points().iter().skip(coordinate).step_by(2).map(|d| number(*d).abs()).max().unwrap();
    let j = knots.span_at(x, side).unwrap().index();
    let t = |i: isize| knots.t(usize::try_from(i.max(0)).unwrap().min(knots.m())).clone();
    let mut jets = vec![vec![integer(0); k + 1]; order + 1];
    jets[0] = vec![largest; k + 1];
    for d in (1..=k).rev() {
        for c in 0..d {
            let at =
                |offset: usize| isize::try_from(j + 1 + c + offset).unwrap() - isize::try_from(k).unwrap();
            let (a, b) = (t(at(k - d)), t(at(k)));
            let sum = r * (x - &a) + (&b - x);
            let (w, complement) = (r * (x - &a) / &sum, (&b - x) / &sum);
            let (slope, bend) = (r * (&b - &a) / (&sum * &sum), (r - integer(1)).abs() / &sum);
            let (mut previous, mut series) = (integer(0), integer(0));
            for row in &mut jets {
                series = &bend * series + &slope * previous;
                previous = &row[c] + &row[c + 1];
                row[c] = &complement * &row[c] + &w * &row[c + 1] + &series;
            }
        }
    }
    let mut factorial = integer(1);
    let scaled = jets.iter().enumerate().map(|(e, row)| {
        factorial *= integer(e.max(1));
        &row[0] * &factorial
    });
    scaled.collect()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(120))]

    #[test]
    fn derivatives_keep_the_bound(curve in curves(), x in -10.0..10.0, order in 0_usize..4) {
        let (exact, k) = (curve.exact().unwrap(), curve.basis().degree());
        let mut evaluator = CurveEvaluator::new(&exact);
        for (x, side) in places(&curve, x).into_iter().flat_map(|x| [(x, Side::Left), (x, Side::Right)]) {
            let mut rows = vec![f64::NAN; (order + 1) * 2];
            let span = match curve.derivatives(x, side, order, &mut rows) {
                Ok(span) => span,
                Err(FloatError::Derivative(_)) => continue,
                Err(error) => panic!("{error}"),
            };
            prop_assert_eq!(span, curve.basis().span_at(x, side).unwrap());
            if span.is_none() {
                prop_assert!(rows.iter().all(|value| *value == 0.0));
                continue;
            }
            let at = number(x);
            let expected = evaluator.derivatives(&at, side, order);
            for coordinate in 0..2 {
                let majorant = majorant(&curve, &at, side, coordinate, order);
                for e in 0..=order {
                    let value = number(rows[e * 2 + coordinate]);
                    let exact = &expected[e][coordinate];
                    let terms = integer(k * (e + 4)) * power(-98) * &majorant[e];
                    let error = (&value - exact).abs();
                    prop_assert!(error <= exact.abs() * power(-53) + terms + power(-900), "{curve:?} at {x:e}, order {e}");
                }
            }
        }
    }

    /// Against the exact square of the curvature, wherever few digits cancel.
    #[test]
    fn tangents_and_curvature(curve in curves(), x in -10.0..10.0) {
        let exact = curve.exact().unwrap();
        let mut evaluator = CurveEvaluator::new(&exact);
        for (x, side) in places(&curve, x).into_iter().flat_map(|x| [(x, Side::Left), (x, Side::Right)]) {
            let mut direction = [f64::NAN; 2];
            let speed = match curve.tangent(x, side, &mut direction) {
                Ok(speed) => speed,
                Err(FloatError::Derivative(_)) => continue,
                Err(error) => panic!("{error}"),
            };
            let derivatives = evaluator.derivatives(&number(x), side, 2);
            let dot = |a: usize, b: usize| -> BigRational {
                derivatives[a].iter().zip(&derivatives[b]).map(|(a, b)| a * b).sum()
            };
            let square = dot(1, 1);
            let Some(speed) = speed else {
                prop_assert!(square.is_zero() && direction == [0.0; 2], "{curve:?} at {x:e}");
                continue;
            };
            let largest = [0, 1].map(|c| majorant(&curve, &number(x), side, c, 2)).concat().into_iter().max().unwrap();
            // Is the speed more than 2⁻²⁰ of the largest term?
            if &square * power(40) < &largest * &largest {
                continue;
            }
            let near = |found: f64, mut expected: Surd, off: &BigRational| {
                let (lo, hi) = expected.bounds();
                let found = number(found);
                let slack = off + hi.abs().max(lo.abs()) * power(-50);
                lo - &slack <= found && found <= hi + slack
            };
            prop_assert!(near(speed, Surd::root(&square), &integer(0)));
            for (found, v) in direction.iter().zip(&derivatives[1]) {
                prop_assert!(near(*found, Surd::root(&(v * v.abs() / &square)), &power(-60)));
            }
            let Ok(Some(curvature)) = curve.curvature(x, side) else { continue };
            let (v, a) = (&derivatives[1], &derivatives[2]);
            let determinant = &v[0] * &a[1] - &v[1] * &a[0];
            let signed = &determinant * determinant.abs() / (&square * &square * &square);
            let off = &largest / &square * power(-50);
            prop_assert!(near(curvature, Surd::root(&signed), &off), "{curve:?} at {x:e}: {curvature:e}");
        }
    }

    #[test]
    fn error_bounds_and_nearest_points(curve in curves(), x in -10.0..10.0) {
        let exact = curve.exact().unwrap();
        let mut evaluator = CurveEvaluator::new(&exact);
        for (x, side) in places(&curve, x).into_iter().flat_map(|x| [(x, Side::Left), (x, Side::Right)]) {
            let (mut point, mut bound, mut nearest) = ([f64::NAN; 2], [f64::NAN; 2], [f64::NAN; 2]);
            curve.point(x, side, &mut point).unwrap();
            prop_assert_eq!(curve.error_bound(x, side, &mut bound), curve.nearest_point(x, side, &mut nearest));
            for (c, exact) in evaluator.point(&number(x), side).iter().enumerate() {
                prop_assert!((number(point[c]) - exact).abs() <= number(bound[c]), "{curve:?} at {x:e}");
                prop_assert_eq!(nearest[c], 0.0_f64.embed(exact), "{:?} at {:e}", curve, x);
                // No bound is far from half a unit in the last place, unless nearly all cancels.
                prop_assert!(bound[c] <= point[c].abs() * f64::EPSILON + 1e-20 * 1e3 * 2.0_f64.powi(60));
            }
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]

    /// In `f32` two roundings must not take the place of one: no neighbour is closer to the exact value.
    #[test]
    fn nearest_points_in_the_narrow_type(
        knots in prop::collection::vec(-8_i8..8, 9), alpha in 1.001_f32..9.0, x in -8.0_f32..8.0, k in 0_usize..4,
        points in prop::collection::vec(-1e3_f32..1e3, 8)
    ) {
        let mut knots = knots;
        knots.sort_unstable();
        let Ok(basis) = FloatBasis::new(knots.into_iter().map(f32::from).collect(), k, alpha) else { return Ok(()) };
        let count = basis.n() + 1;
        let curve = FloatCurve::new(basis, 1, points[..count].to_vec()).unwrap();
        let mut point = [f32::NAN];
        curve.nearest_point(x, Side::Right, &mut point).unwrap();
        let exact = &curve.exact().unwrap().point(&number(x.into()), Side::Right)[0];
        let off = |value: f32| (number(value.into()) - exact).abs();
        prop_assert!(off(point[0]) <= off(point[0].next_up()) && off(point[0]) <= off(point[0].next_down()));
    }
}

fn parabola<F: knotproof::float::Real>(number: fn(f32) -> F) -> FloatCurve<F> {
    let knots = [0.0, 0.0, 0.0, 2.0, 2.0, 2.0].map(number).to_vec();
    let basis = FloatBasis::new(knots, 2, number(f32::INFINITY)).unwrap();
    // (x, x²) on [0, 2].
    FloatCurve::new(basis, 2, [0.0, 0.0, 1.0, 0.0, 2.0, 4.0].map(number).to_vec()).unwrap()
}

#[test]
fn a_parabola_in_both_types() {
    let (wide, narrow) = (parabola(f64::from), parabola(|value| value));
    assert_eq!((wide.dimension(), wide.points().len(), narrow.dimension()), (2, 6, 2));
    let mut rows = [0.0; 8];
    wide.derivatives(1.0, Side::Right, 3, &mut rows).unwrap();
    assert_eq!(rows, [1.0, 1.0, 1.0, 2.0, 0.0, 2.0, 0.0, 0.0]);
    let mut direction = [0.0; 2];
    assert_eq!(wide.tangent(0.0, Side::Right, &mut direction), Ok(Some(1.0)));
    assert_eq!(direction, [1.0, 0.0]);
    assert_eq!(wide.curvature(0.0, Side::Right), Ok(Some(2.0)));
    assert_eq!(narrow.curvature(0.0, Side::Right), Ok(Some(2.0)));
    assert_eq!((wide.curvature(3.0, Side::Right), wide.curvature(0.0, Side::Left)), (Ok(None), Ok(None)));
    let mut point = [0.0_f32; 2];
    narrow.nearest_point(0.1, Side::Right, &mut point).unwrap();
    let square = f64::from(0.1_f32) * f64::from(0.1_f32);
    assert!((f64::from(point[1]) - square).abs() <= square * 2.0_f64.powi(-24));
}

/// In space κ ≥ 0, and no direction where all control points are one, which is known exactly.
#[test]
fn space_and_rest() {
    let basis = FloatBasis::new(vec![0.0, 0.0, 0.0, 1.0, 1.0, 1.0], 2, -0.7).unwrap();
    let helix =
        FloatCurve::new(basis.clone(), 3, vec![0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 2.0, 0.0, -3.0]).unwrap();
    let plane = FloatCurve::new(basis.clone(), 2, vec![0.0, 0.0, 1.0, 0.0, 2.0, -3.0]).unwrap();
    let [in_space, in_plane] = [helix.curvature(0.3, Side::Right), plane.curvature(0.3, Side::Right)]
        .map(|found| found.unwrap().unwrap());
    assert!((in_space + in_plane).abs() < 1e-14 && in_plane < 0.0);
    let rest = FloatCurve::new(basis.clone(), 2, [0.1, 0.7].repeat(3)).unwrap();
    let mut direction = [f64::NAN; 2];
    assert_eq!(rest.tangent(0.3, Side::Right, &mut direction), Ok(None));
    assert_eq!((direction, rest.curvature(0.3, Side::Right)), ([0.0; 2], Ok(None)));
    // A curve in 4 coordinates is none that is exact here; one in no coordinate has no direction.
    let many = FloatCurve::new(basis.clone(), 4, vec![1.0; 12]).unwrap();
    assert!(many.exact().is_err());
    let none = FloatCurve::new(basis, 0, Vec::new()).unwrap();
    assert_eq!(none.tangent(0.3, Side::Right, &mut []), Ok(None));
}

#[test]
fn from_an_exact_curve_and_back() {
    for example in knotproof::meaning::examples() {
        let Some(points) = &example.points else { continue };
        for basis in example.indices().filter_map(|index| example.basis(index)) {
            let exact = knotproof::spline::Curve::new(basis, points.clone()).unwrap();
            let float = FloatCurve::<f64>::nearest(&exact).unwrap();
            let again = FloatCurve::<f64>::nearest(&float.exact().unwrap()).unwrap();
            assert_eq!((float.points(), float.basis().knots()), (again.points(), again.basis().knots()));
        }
    }
    let basis = FloatBasis::new(vec![0.0, 1.0], 0, 2.0).unwrap().exact();
    let huge = knotproof::spline::Curve::new(basis, vec![vec![power(2000)]]).unwrap();
    assert!(matches!(FloatCurve::<f64>::nearest(&huge), Err(FloatError::Coordinate { position: 0, .. })));
}

/// Next to the middle between two floats the pair does not decide: exact arithmetic does.
#[test]
fn halfway_between_two_floats() {
    let basis = FloatBasis::new(vec![0.0, 0.0, 1.0, 1.0], 1, f64::INFINITY).unwrap();
    let curve = FloatCurve::new(basis, 1, vec![1.0, 1.0 + f64::EPSILON]).unwrap();
    let mut point = [0.0];
    // 1 + ε/2: to the even one.
    curve.nearest_point(0.5, Side::Right, &mut point).unwrap();
    assert_eq!(point, [1.0]);
    curve.nearest_point(0.5_f64.next_up(), Side::Right, &mut point).unwrap();
    assert_eq!(point, [1.0 + f64::EPSILON]);
    curve.nearest_point(0.5_f64.next_down(), Side::Right, &mut point).unwrap();
    assert_eq!(point, [1.0]);
}

/// Coordinates next to the end of the range are divided by 2¹²⁸ on the way, where tiny ones vanish: not in the points, nor in the
/// bounds.
#[test]
fn tiny_points_beside_huge_ones() {
    let (tiny, huge) = (1.3 * 2.0_f64.powi(-950), 1.9 * 2.0_f64.powi(1023));
    let basis = FloatBasis::new(vec![0.0, 0.0, 1.0, 2.0, 3.0, 3.0], 1, -1.0).unwrap();
    let curve = FloatCurve::new(basis, 1, vec![tiny, tiny, huge, huge]).unwrap();
    assert_eq!(curve.points(), [tiny, tiny, huge, huge]);
    let (mut point, mut bound, mut nearest) = ([f64::NAN], [f64::NAN], [f64::NAN]);
    for (x, expected) in [(0.5, tiny), (2.5, huge)] {
        curve.point(x, Side::Right, &mut point).unwrap();
        curve.error_bound(x, Side::Right, &mut bound).unwrap();
        curve.nearest_point(x, Side::Right, &mut nearest).unwrap();
        assert_eq!(nearest, [expected]);
        assert!((point[0] - expected).abs() <= bound[0] && bound[0] <= huge * f64::EPSILON);
    }
}

#[test]
fn what_is_wrong_is_said() {
    let curve = parabola(f64::from);
    assert!(matches!(curve.derivatives(0.0, Side::Right, 99, &mut []), Err(FloatError::Order(99))));
    assert!(matches!(
        curve.derivatives(0.0, Side::Right, 1, &mut [0.0]),
        Err(FloatError::Length { needed: 4, given: 1, .. })
    ));
    assert!(matches!(curve.tangent(f64::NAN, Side::Right, &mut [0.0; 2]), Err(FloatError::Point(_))));
    assert!(matches!(curve.tangent(0.0, Side::Right, &mut []), Err(FloatError::Length { .. })));
    assert!(matches!(curve.nearest_point(0.0, Side::Right, &mut []), Err(FloatError::Length { .. })));
    let steep = FloatBasis::new(vec![0.0, 0.0, 1.0, 1.0], 1, -1e-300).unwrap();
    let steep = FloatCurve::new(steep, 1, vec![0.0, 1.0]).unwrap();
    assert!(matches!(steep.tangent(0.5, Side::Right, &mut [0.0]), Err(FloatError::Derivative(1))));
}
