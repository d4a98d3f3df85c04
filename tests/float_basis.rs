//! Values in floats against the exact values of the same floats: the proved bound, the signs, the edges.

#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests")]
#![allow(clippy::float_cmp, reason = "exact floats are expected")]
#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_precision_loss,
    reason = "small numbers, and rounding that is asked for"
)]

use knotproof::float::{FAST_DEGREE, FloatBasis, FloatError, HIGHEST_DEGREE, Precision, Real};
use knotproof::scalar::{BigRational, exact_value, integer, rational};
use knotproof::spline::{Side, Span};
use num_traits::{Float, Pow, Signed, Zero};
use proptest::prelude::*;

/// 2^e.
fn power(e: i32) -> BigRational {
    Pow::pow(rational(2, 1), e)
}

/// |float − exact| ≤ (1 + k·2^slack)·u·exact, and half the least float besides.
fn assert_close<F: Real>(float: F, exact: &BigRational, degree: usize, place: &str) {
    let digits: i32 = if std::mem::size_of::<F>() == 8 { 53 } else { 24 };
    let slack = power(if digits == 53 { -44 } else { -22 });
    let value = exact_value(float.into_f64()).unwrap_or_else(|| panic!("{place}: {float:?}"));
    assert!(!value.is_negative() && value <= integer(1), "{place}: {float:e}");
    assert_eq!(value.is_zero(), exact.is_zero(), "{place}: {float:e}");
    let error = (&value - exact).abs();
    let bound = (integer(1) + integer(degree) * slack) * power(-digits) * exact;
    let least = exact_value(F::LEAST.into_f64()).unwrap();
    assert!(error <= bound + least * integer((degree + 1) * (degree + 1)), "{place}: {float:e}");
}

trait IntoF64 {
    fn into_f64(self) -> f64;
}
impl<F: Real> IntoF64 for F {
    fn into_f64(self) -> f64 {
        self.widen()
    }
}

fn check<F: Real>(basis: &FloatBasis<F>, x: F, side: Side) {
    let degree = basis.degree();
    let mut values = vec![F::nan(); degree + 1];
    let span = basis.values(x, side, &mut values).unwrap();
    let exact = basis.exact().values(&exact_value(x.widen()).unwrap(), side);
    let place = format!("{:?} α = {:e} k = {degree} x = {x:e} {side}", basis.knots(), basis.alpha());
    let Some(span) = span else {
        assert!(exact.iter().all(Zero::is_zero), "{place}");
        assert!(values.iter().all(|v| v.is_zero()), "{place}");
        return;
    };
    for (i, exact) in exact.iter().enumerate() {
        match (i + degree).checked_sub(span.index()).filter(|c| *c <= degree) {
            Some(c) => assert_close(values[c], exact, degree, &format!("{place} G_{i}")),
            None => assert!(exact.is_zero(), "{place} G_{i}"),
        }
    }
    for (c, value) in values.iter().enumerate() {
        let exists = (span.index() + c).checked_sub(degree).is_some_and(|i| i <= basis.n());
        assert!(exists || value.is_zero(), "{place}");
    }
}

/// Knots, degree and α that are hard in one way or another.
fn edges() -> Vec<FloatBasis<f64>> {
    let knots: [&[f64]; 12] = [
        &[0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0],
        &[0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 1.0],
        &[0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 1.0, 1.0],
        &[0.0, 0.0, 1.0, 1.0, 1.0, 1.0, 2.0, 3.0],
        &[-1.0, -5e-324, 0.0, 5e-324, 1e-323, 1.0, 2.0],
        &[0.0, 0.0, 0.0, 5e-324, 5e-324, 5e-324, 5e-324],
        &[f64::MIN, f64::MIN, 0.0, 0.0, 0.0, f64::MAX, f64::MAX],
        &[f64::MIN, -1.0, 0.0, 5e-324, 1e-300, 1.0, f64::MAX],
        &[1e8, 1e8 + 1e-7, 1e8 + 2e-7, 1e8 + 3e-7, 2e8, 2e8, 3e8],
        &[1.0, 1.0 + f64::EPSILON, 1.0 + 2.0 * f64::EPSILON, 2.0, 2.0, 3.0, 5.0],
        &[1e-300, 2e-300, 3e-300, 4e-300, 5e-300, 6e-300, 7e-300],
        &[1e300, 2e300, 3e300, 4e300, 5e300, 6e300, 7e300],
    ];
    let alphas = [
        -1.0,
        2.0,
        5.0,
        f64::INFINITY,
        f64::NEG_INFINITY,
        -1e-300,
        1.0 + f64::EPSILON,
        1e300,
        -1e300,
        -5e-324,
        f64::MAX,
        f64::MIN,
        -1.0 / 3.0,
        -1e16,
        1e16,
        -1e-16,
    ];
    let bases = knots.iter().flat_map(|knots| alphas.map(|alpha| (knots.to_vec(), alpha)));
    let degrees =
        bases.flat_map(|(knots, alpha)| (0..=3).map(move |k| FloatBasis::new(knots.clone(), k, alpha)));
    degrees.map(Result::unwrap).collect()
}

#[test]
fn nothing_goes_wrong_at_the_edges() {
    for basis in edges() {
        let knots = basis.knots().to_vec();
        let mut points = knots.clone();
        points.extend(knots.iter().flat_map(|t| [t.next_up(), t.next_down()]));
        points.extend(knots.windows(2).map(|pair| pair[0] / 2.0 + pair[1] / 2.0));
        for x in points {
            if x.is_finite() {
                check(&basis, x, Side::Right);
                check(&basis, x, Side::Left);
            }
        }
    }
}

#[test]
fn what_is_no_input_is_an_error() {
    let new = |knots: &[f64], degree, alpha| FloatBasis::new(knots.to_vec(), degree, alpha).unwrap_err();
    assert!(matches!(new(&[0.0, f64::NAN, 1.0], 0, 2.0), FloatError::Knot { position: 1, .. }));
    assert!(matches!(new(&[0.0, f64::INFINITY], 0, 2.0), FloatError::Knot { position: 1, .. }));
    assert!(matches!(new(&[0.0, 1.0, 0.5], 0, 2.0), FloatError::Decreasing { position: 2, .. }));
    assert!(matches!(new(&[1.0, 1.0, 1.0], 0, 2.0), FloatError::AllEqual(_)));
    assert!(matches!(new(&[0.0, 1.0], 1, 2.0), FloatError::Count { needed: 3, count: 2, .. }));
    assert!(matches!(new(&[], 0, 2.0), FloatError::Count { count: 0, .. }));
    assert!(matches!(new(&[0.0, 1.0], 1000, 2.0), FloatError::Degree(1000)));
    for alpha in [0.0, -0.0, 0.5, 1.0, f64::NAN, 1.0 - f64::EPSILON, 5e-324] {
        assert!(matches!(new(&[0.0, 1.0], 0, alpha), FloatError::Index(_)), "{alpha}");
    }
    let basis = FloatBasis::new(vec![0.0, 1.0, 2.0], 1, 2.0).unwrap();
    for x in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        assert!(matches!(basis.values(x, Side::Right, &mut [0.0; 2]), Err(FloatError::Point(_))));
    }
    assert!(matches!(
        basis.values(0.5, Side::Right, &mut [0.0; 3]),
        Err(FloatError::Length { needed: 2, .. })
    ));
}

fn alpha() -> impl Strategy<Value = f64> {
    let near = |x: f64| (1..300).prop_map(move |e: i32| x + 2.0_f64.powi(-e));
    prop_oneof![
        (-1022..1023).prop_map(|e: i32| -(2.0_f64.powi(e))),
        any::<f64>().prop_filter("an index", |a| !a.is_nan() && !(0.0..=1.0).contains(a)),
        near(1.0).prop_filter("an index", |a| *a > 1.0),
        Just(f64::INFINITY),
        -10.0..-1e-9,
        1.000_001..10.0,
    ]
}

/// A few gaps, some of them 0, over a range of scales, and an x among them.
fn case(spread: i32) -> impl Strategy<Value = (Vec<f64>, f64)> {
    let gap = prop_oneof![1 => Just(0.0), 4 => (1.0..2.0, -spread..=spread).prop_map(|(m, e): (f64, i32)| m * 2.0_f64.powi(e))];
    (proptest::collection::vec(gap, 9..14), -1e3..1e3, 0.0..1.0, 0_usize..8).prop_map(
        |(gaps, start, part, at)| {
            let knots: Vec<f64> = std::iter::once(start)
                .chain(gaps.iter().scan(start, |t, gap| {
                    *t += gap;
                    Some(*t)
                }))
                .collect();
            let x = knots[at] + (knots[at + 1] - knots[at]) * part;
            (knots, x)
        },
    )
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn values_keep_the_bound((knots, x) in case(30), alpha in alpha(), degree in 0_usize..=4, left: bool) {
        prop_assume!(knots[0] < knots[knots.len() - 1]);
        let basis = FloatBasis::new(knots, degree, alpha).unwrap();
        check(&basis, x, if left { Side::Left } else { Side::Right });
    }

    #[test]
    fn f32_keeps_the_bound((knots, x) in case(12), alpha in -5.0_f32..-1e-3, degree in 0_usize..=4) {
        let knots: Vec<f32> = knots.into_iter().map(|t| t as f32).collect();
        prop_assume!(knots[0] < knots[knots.len() - 1]);
        let basis = FloatBasis::new(knots, degree, alpha).unwrap();
        check(&basis, x as f32, Side::Right);
    }
}

/// Some degrees have code of their own, and all others share one. Short numbers, so that exact values are found soon.
#[test]
fn every_degree_keeps_the_bound() {
    for degree in (0..=9).chain([16, HIGHEST_DEGREE]) {
        let gaps = [3.0, 1.0, 0.0, 7.0, 0.125, 2.0].into_iter().cycle();
        let knots: Vec<f64> = gaps
            .take(2 * degree + 4)
            .scan(-1.0, |t, gap| {
                *t += gap;
                Some(*t)
            })
            .collect();
        for alpha in [-0.3125, 3.0] {
            let basis = FloatBasis::new(knots.clone(), degree, alpha).unwrap();
            for part in [0.0, 0.3125, 0.75] {
                let x = knots[degree] + part * (knots[degree + 3] - knots[degree]);
                check(&basis, x, Side::Right);
            }
        }
    }
}

/// Many points at once give what single points give, in any order, past the ends and with functions that are missing.
#[test]
fn many_points_are_single_points() {
    for basis in edges() {
        let (first, last) = (basis.knots()[0], basis.knots()[basis.knots().len() - 1]);
        let mut points: Vec<f64> = basis.knots().to_vec();
        let parts = |i: u32| first * (1.0 - f64::from(i) / 37.0) + last * (f64::from(i) / 37.0);
        points.extend((0..37).rev().map(parts).filter(|x| x.is_finite()));
        points
            .extend([first.next_down(), last.next_up(), f64::MIN, f64::MAX].iter().filter(|x| x.is_finite()));
        let stride = basis.degree() + 1;
        for precision in [Precision::Accurate, Precision::Fast] {
            let (mut spans, mut values) = (vec![None; points.len()], vec![f64::NAN; points.len() * stride]);
            basis.values_at(&points, precision, &mut spans, &mut values).unwrap();
            for ((x, span), values) in points.iter().zip(&spans).zip(values.chunks(stride)) {
                let mut single = vec![0.0; stride];
                assert_eq!(basis.values(*x, Side::Right, &mut single).unwrap(), *span);
                let place =
                    format!("{:?} α = {:e} k = {} x = {x:e}", basis.knots(), basis.alpha(), basis.degree());
                assert_same(&single, values, precision, basis.degree(), &place);
            }
            let inside = basis.exact().knots().spans().collect::<Vec<_>>();
            for span in inside {
                let (start, end) = basis.ends(span).unwrap();
                let points: Vec<f64> =
                    (0..19).map(|i| start + (end / 18.0 - start / 18.0) * f64::from(i)).collect();
                let points: Vec<f64> = points.into_iter().map(|x| x.clamp(start, end)).collect();
                let mut rows = vec![f64::NAN; points.len() * stride];
                basis.values_on(span, &points, precision, &mut rows).unwrap();
                for (p, x) in points.iter().enumerate() {
                    let values: Vec<f64> = (0..stride).map(|c| rows[c * points.len() + p]).collect();
                    let side = if *x < end { Side::Right } else { Side::Left };
                    let mut single = vec![0.0; stride];
                    let found = basis.values(*x, side, &mut single).unwrap();
                    assert_eq!(found.map(Span::index), Some(span.index()));
                    let place = format!(
                        "{:?} α = {:e} k = {} x = {x:e}",
                        basis.knots(),
                        basis.alpha(),
                        basis.degree()
                    );
                    assert_same(&single, &values, precision, basis.degree(), &place);
                }
            }
        }
    }
}

#[test]
fn many_points_in_f32_are_single_points() {
    for degree in 0..=6 {
        let knots: Vec<f32> = (0..2 * degree + 9).map(|i| (i / 2) as f32 * 0.7).collect();
        let basis = FloatBasis::new(knots, degree, -0.3_f32).unwrap();
        let points: Vec<f32> = (0..45).map(|i| -0.3 + 0.11 * i as f32).collect();
        let (mut spans, mut values) = (vec![None; 45], vec![f32::NAN; 45 * (degree + 1)]);
        basis.values_at(&points, Precision::Accurate, &mut spans, &mut values).unwrap();
        for (x, many) in points.iter().zip(values.chunks(degree + 1)) {
            let mut single = vec![f32::NAN; degree + 1];
            basis.values(*x, Side::Right, &mut single).unwrap();
            assert_eq!(single, many, "k = {degree}, x = {x:e}");
        }
    }
}

fn assert_same(single: &[f64], values: &[f64], precision: Precision, degree: usize, place: &str) {
    let k = degree as f64;
    for (one, many) in single.iter().zip(values) {
        match precision {
            Precision::Accurate => assert_eq!(one, many, "{place}"),
            // Nothing is said of the relative error next to underflow.
            Precision::Fast => {
                let bound = (k * k + 7.0 * k + 1.0) * f64::EPSILON / 2.0 * one + 1e-270;
                assert!(
                    (one - many).abs() <= bound && (*one > 0.0) == (*many > 0.0),
                    "{place}: {one:e} {many:e}"
                );
            }
        }
    }
}

/// The fast path in both types keeps its bound against exact values.
#[test]
fn the_fast_path_keeps_its_bound() {
    let knots: Vec<f32> = [0.0, 0.1, 0.7, 0.7, 1.3, 2.0, 4.5, 5.0, 5.0, 9.0, 9.5, 20.0].to_vec();
    let wide: Vec<f64> = knots.iter().map(|t| f64::from(*t)).collect();
    for degree in 1..=FAST_DEGREE {
        fast(&FloatBasis::new(knots.clone(), degree, -0.3).unwrap(), |i| 0.33_f32 * i as f32);
        fast(&FloatBasis::new(wide.clone(), degree, 1.1).unwrap(), |i| 0.33 * f64::from(i));
    }
}

fn fast<F: Real>(basis: &FloatBasis<F>, point: impl Fn(u16) -> F) {
    let points: Vec<F> = (0..60).map(point).collect();
    let stride = basis.degree() + 1;
    let (mut spans, mut values) = (vec![None; points.len()], vec![F::zero(); points.len() * stride]);
    basis.values_at(&points, Precision::Fast, &mut spans, &mut values).unwrap();
    let k = basis.degree();
    for ((x, span), values) in points.iter().zip(spans).zip(values.chunks(stride)) {
        let exact = basis.exact().values(&exact_value(x.widen()).unwrap(), Side::Right);
        let Some(span) = span else { continue };
        for (c, value) in values.iter().enumerate() {
            let Some(exact) = (span.index() + c).checked_sub(k).and_then(|i| exact.get(i)) else { continue };
            let error = (exact_value(value.widen()).unwrap() - exact).abs();
            let digits = if std::mem::size_of::<F>() == 8 { -53 } else { -24 };
            assert!(error <= integer(k * k + 7 * k) * power(digits) * exact, "k = {k} x = {x:e}");
        }
    }
}

/// A span of another basis is refused, not computed with.
#[test]
fn spans_belong_to_their_knots() {
    let basis = FloatBasis::new(vec![0.0, 1.0, 2.0], 1, 2.0).unwrap();
    let other = FloatBasis::new((0..20).map(f64::from).collect(), 1, 2.0).unwrap();
    let span: Span = other.span_at(15.5, Side::Right).unwrap().unwrap();
    assert!(matches!(basis.ends(span), Err(FloatError::Span(15))));
    assert_eq!(other.ends(span), Ok((15.0, 16.0)));
    assert!(Float::is_finite(other.knots()[3]));
}
