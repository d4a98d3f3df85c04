//! Derivatives and curves in floats against the exact ones of the same floats: the proved bounds, and the edges.

#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests")]
#![allow(clippy::float_cmp, reason = "exact floats are expected")]

use knotproof::float::{FloatBasis, FloatCurve, FloatError};
use knotproof::scalar::{BigRational, exact_value, integer, rational};
use knotproof::spline::{Curve, Side, Span};
use num_traits::{One, Pow, Signed, Zero};
use proptest::prelude::*;

fn power(e: i32) -> BigRational {
    Pow::pow(rational(2, 1), e)
}

/// The triangle over absolute values of Taylor coefficients: entry (e, c) is M_e/e! for the function c of the span.
fn majorants(basis: &FloatBasis<f64>, span: Span, x: &BigRational, order: usize) -> Vec<Vec<BigRational>> {
    let (k, r, knots) =
        (basis.degree(), basis.exact().index().ratio().clone(), basis.exact().knots().clone());
    let t = |i: usize, offset: usize| {
        let i = (i + offset).saturating_sub(k).min(knots.m());
        knots.t(i).clone()
    };
    let mut jets = vec![vec![BigRational::one()]; order + 1];
    jets[1..].iter_mut().for_each(|row| row[0] = BigRational::zero());
    for d in 1..=k {
        let mut upper = vec![vec![BigRational::zero(); d + 1]; order + 1];
        for c in 0..d {
            let (a, b) = (t(span.index() + 1 + c, k - d), t(span.index() + 1 + c, k));
            let sum = &r * (x - &a) + (&b - x);
            let (w, complement) = (&r * (x - &a) / &sum, (&b - x) / &sum);
            let (slope, bend) = (&r * (&b - &a) / (&sum * &sum), (&r - integer(1)).abs() / &sum);
            let mut series = BigRational::zero();
            for e in 0..=order {
                series = &bend * series + if e > 0 { &slope * &jets[e - 1][c] } else { integer(0) };
                upper[e][c] += &complement * &jets[e][c] + &series;
                upper[e][c + 1] += &w * &jets[e][c] + &series;
            }
        }
        jets = upper;
    }
    jets
}

fn check(basis: &FloatBasis<f64>, x: f64, side: Side, order: usize) -> Result<(), TestCaseError> {
    let (k, exact_x) = (basis.degree(), exact_value(x).unwrap());
    let mut rows = vec![f64::NAN; (order + 1) * (k + 1)];
    let span = match basis.derivatives(x, side, order, &mut rows) {
        Ok(span) => span,
        Err(FloatError::Derivative(_)) => return Ok(()),
        Err(error) => panic!("{error}"),
    };
    let Some(span) = span else {
        prop_assert!(rows.iter().all(|value| *value == 0.0));
        return Ok(());
    };
    let exact = basis.exact().jets(&exact_x, side, order);
    let majorants = majorants(basis, span, &exact_x, order);
    let mut factorial = integer(1);
    for e in 0..=order {
        factorial *= integer(e.max(1));
        for c in 0..=k {
            let value = exact_value(rows[e * (k + 1) + c]).unwrap();
            let jet = (span.index() + c).checked_sub(k).and_then(|i| exact.get(i));
            let Some(jet) = jet else {
                prop_assert!(value.is_zero());
                continue;
            };
            let exact = &jet.derivatives()[e];
            let terms = integer(k * (e + 2)) * power(-98) * &majorants[e][c] * &factorial;
            let error = (&value - exact).abs();
            prop_assert!(
                error <= exact.abs() * power(-53) + terms + power(-1000),
                "{basis:?} x = {x:e} e = {e} c = {c}"
            );
        }
    }
    Ok(())
}

#[test]
fn derivatives_at_knots_and_between() {
    for (knots, k) in [
        (vec![0.0, 0.0, 0.0, 0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 5.0, 5.0, 5.0], 3),
        (vec![0.0, 1.0, 1.5, 2.0, 3.5, 5.0, 6.0], 2),
        (vec![0.0, 0.0, 1.0, 1.0, 1.0, 2.0, 3.0], 3),
        (vec![0.0, 1.0, 2.0], 0),
    ] {
        for alpha in [-1.0, 1.2, 5.0, f64::INFINITY, -1e-20, 1.0 + f64::EPSILON, 1e300] {
            let basis = FloatBasis::new(knots.clone(), k, alpha).unwrap();
            for x in knots.iter().copied().chain([0.3, 1.75, 2.9, -1.0]) {
                check(&basis, x, Side::Right, k + 2).unwrap();
                check(&basis, x, Side::Left, k + 2).unwrap();
            }
        }
    }
}

#[test]
fn what_is_beyond_the_range_is_an_error() {
    let steep = FloatBasis::new(vec![0.0, 0.0, 1e-300, 1e-300], 1, -1.0).unwrap();
    let mut rows = [0.0; 6];
    assert!(matches!(steep.derivatives(0.0, Side::Right, 2, &mut rows), Err(FloatError::Derivative(_))));
    let basis = FloatBasis::new(vec![0.0, 0.0, 1.0, 1.0], 1, -1e-300).unwrap();
    assert!(matches!(basis.derivatives(0.5, Side::Right, 1, &mut rows[..4]), Err(FloatError::Derivative(1))));
    assert!(matches!(basis.derivatives(0.5, Side::Right, 99, &mut []), Err(FloatError::Order(99))));
    assert!(matches!(
        basis.derivatives(0.5, Side::Right, 1, &mut []),
        Err(FloatError::Length { needed: 4, .. })
    ));
}

fn sorted(mut knots: Vec<f64>) -> Vec<f64> {
    knots.sort_by(f64::total_cmp);
    knots
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(150))]

    #[test]
    fn derivatives_keep_the_bound(
        knots in proptest::collection::vec(-10.0..10.0, 9..13), x in -10.0..10.0, alpha in -20.0..-0.01, k in 0_usize..=4
    ) {
        let basis = FloatBasis::new(sorted(knots), k, alpha).unwrap();
        check(&basis, x, Side::Right, k + 1)?;
    }

    #[test]
    fn curves_keep_the_bound(
        knots in proptest::collection::vec(-10.0..10.0, 12), x in -10.0..10.0, alpha in 1.001..20.0, k in 0_usize..=5,
        points in proptest::collection::vec(-1e3..1e3, 66), scale in -60_i32..60
    ) {
        let basis = FloatBasis::new(sorted(knots), k, alpha).unwrap();
        let points: Vec<f64> = points[..(basis.n() + 1) * 6].iter().map(|d| d * 2.0_f64.powi(scale)).collect();
        let exact: Vec<Vec<BigRational>> =
            points.chunks(6).map(|d| d[..3].iter().map(|c| exact_value(*c).unwrap()).collect()).collect();
        let absolute: Vec<Vec<BigRational>> =
            exact.iter().map(|d| d.iter().map(Signed::abs).collect()).collect();
        let curve = FloatCurve::new(basis.clone(), 6, points).unwrap();
        let mut point = [f64::NAN; 6];
        let span = curve.point(x, Side::Right, &mut point).unwrap();
        prop_assert_eq!(span, basis.span_at(x, Side::Right).unwrap());
        let exact_x = exact_value(x).unwrap();
        let at = |points| Curve::new(basis.exact(), points).unwrap().point(&exact_x, Side::Right);
        for ((value, exact), terms) in point.iter().zip(at(exact)).zip(at(absolute)) {
            let error = (exact_value(*value).unwrap() - &exact).abs();
            prop_assert!(error <= exact.abs() * power(-53) + integer(k + 1) * power(-98) * terms);
        }
    }
}

#[test]
fn curves_of_the_largest_floats_stay_finite() {
    let basis = FloatBasis::new(vec![0.0, 0.0, 0.0, 0.3, 1.0, 1.0, 1.0], 2, -0.7).unwrap();
    let curve = FloatCurve::new(basis.clone(), 1, vec![f64::MAX; 4]).unwrap();
    let mut point = [0.0];
    for x in [0.0, 0.1, 0.3, 0.77, 1.0] {
        curve.point(x, Side::Right, &mut point).unwrap();
        assert_eq!(point, [f64::MAX]);
    }
    assert_eq!(curve.point(2.0, Side::Right, &mut point), Ok(None));
    assert!(matches!(
        FloatCurve::new(basis.clone(), 2, vec![0.0, 0.0, 0.0, f64::NAN, 0.0, 0.0, 0.0, 0.0]),
        Err(FloatError::Coordinate { position: 1, coordinate: 1, .. })
    ));
    assert!(matches!(FloatCurve::new(basis, 2, vec![0.0]), Err(FloatError::Length { needed: 8, .. })));
}
