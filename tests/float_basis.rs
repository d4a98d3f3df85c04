//! Values in floats against the exact values of the same floats: the proved bound, the signs, the edges.

use knotproof::float::{FloatBasis, FloatError, Real};
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
