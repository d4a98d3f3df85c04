//! Intervals contain the exact result, whatever their size, and know a sign only where there is one.

#![allow(clippy::unwrap_used, reason = "helpers of tests: a failure is a failed test")]

use std::cmp::Ordering;

use knotproof::scalar::{BigRational, Interval, Polynomial, Ring, exact_value, integer, rational};
use num_bigint::BigInt;
use num_traits::Signed;
use proptest::prelude::*;

/// Is the exact number in the interval? An infinite end is none.
fn contains(interval: &Interval, value: &BigRational) -> bool {
    let below = exact_value(interval.lo()).is_none_or(|lo| lo <= *value);
    let above = exact_value(interval.hi()).is_none_or(|hi| *value <= hi);
    sound(interval) && below && above
}

/// Not empty, no NaN, and no infinite end on the wrong side.
fn sound(interval: &Interval) -> bool {
    interval.lo() <= interval.hi() && interval.lo() < f64::INFINITY && interval.hi() > f64::NEG_INFINITY
}

/// Finite floats of every kind: all exponents, subnormals, both zeros, the ends of the range.
fn float() -> impl Strategy<Value = f64> {
    let any = any::<u64>().prop_map(f64::from_bits).prop_filter("finite", |float| float.is_finite());
    let special = prop::sample::select(vec![
        0.0,
        -0.0,
        1.0,
        -1.0,
        f64::MAX,
        f64::MIN,
        f64::MIN_POSITIVE,
        5e-324,
        -5e-324,
        1e-162,
        1e154,
        f64::EPSILON,
        9_007_199_254_740_993.0,
    ]);
    prop_oneof![3 => any, 2 => special, 2 => -1e3..1e3, 1 => (0_i32..20).prop_map(f64::from)]
}

/// An interval with an exact number in it: its ends, what is between them, or a point.
fn element() -> impl Strategy<Value = (Interval, BigRational)> {
    (float(), float(), 0_i64..=4, prop::bool::weighted(0.2), prop::bool::weighted(0.1)).prop_map(
        |(a, b, quarters, point, unbounded)| {
            let (lo, hi) = if point { (a, a) } else { (a.min(b), a.max(b)) };
            let exact = |float| exact_value(float).unwrap();
            let value = exact(lo) + (exact(hi) - exact(lo)) * rational(quarters, 4);
            let (lo, hi) = match (unbounded, quarters) {
                (false, _) => (lo, hi),
                (true, 0) => (f64::NEG_INFINITY, hi),
                (true, 1) => (lo, f64::INFINITY),
                (true, _) => (f64::NEG_INFINITY, f64::INFINITY),
            };
            (Interval::new(lo, hi).unwrap(), value)
        },
    )
}

fn sign_is_true(interval: &Interval, value: &BigRational) -> bool {
    interval.sign().is_none_or(|sign| sign == value.cmp(&integer(0)))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(4000))]

    #[test]
    fn operations_contain_the_exact_result((a, x) in element(), (b, y) in element()) {
        for (interval, value) in [
            (a.plus(&b), &x + &y),
            (a.minus(&b), &x - &y),
            (a.times(&b), &x * &y),
            (a.times(&a), &x * &x),
            (a.negate(), -&x),
            (a.plus(&b).times(&a.minus(&b)), (&x + &y) * (&x - &y)),
            (a.power(3), x.power(3)),
        ] {
            prop_assert!(contains(&interval, &value), "{:?} {:?}: {:?} without {}", a, b, interval, value);
            prop_assert!(sign_is_true(&interval, &value));
        }
    }

    /// Each end is a few units in the last place, or 2⁻¹⁰²¹, from the exact extreme.
    #[test]
    fn ends_are_tight((a, _) in element(), (b, _) in element()) {
        let [a_ends, b_ends] = [a, b].map(|i| [exact_value(i.lo()), exact_value(i.hi())]);
        let ([Some(p), Some(q)], [Some(r), Some(s)]) = (a_ends, b_ends) else { return Ok(()) };
        let products = [&p * &r, &p * &s, &q * &r, &q * &s];
        for (interval, lo, hi) in [
            (a.plus(&b), &p + &r, &q + &s),
            (a.times(&b), products.iter().min().unwrap().clone(), products.iter().max().unwrap().clone()),
        ] {
            let slack = |end: f64| end.abs() * (4.0 * f64::EPSILON) + 2.0 * f64::MIN_POSITIVE;
            for (end, extreme) in [(interval.lo(), lo), (interval.hi(), hi)] {
                let (Some(exact), Some(slack)) = (exact_value(end), exact_value(slack(end))) else { continue };
                if extreme.abs() > exact_value(f64::MAX).unwrap() {
                    continue;
                }
                prop_assert!((exact - extreme).abs() <= slack, "{:?} {:?}: {:?}", a, b, interval);
            }
        }
    }

    #[test]
    fn numbers_are_in_their_intervals(value in any::<i64>(), small in -(1_i64 << 53)..=1 << 53, shift in 0_usize..1200, denominator in 1_i64..) {
        let big = BigInt::from(value) << shift;
        prop_assert!(contains(&Interval::from(value), &rational(value, 1)));
        prop_assert!(contains(&Interval::from(value.unsigned_abs()), &BigRational::from(BigInt::from(value.unsigned_abs()))));
        let interval = Interval::from(&big);
        prop_assert!(contains(&interval, &BigRational::from(big.clone())), "{:?} {}", interval, big);
        prop_assert_eq!(interval.sign(), Some(big.cmp(&BigInt::ZERO)));
        for fraction in [
            BigRational::new(big.clone(), denominator.into()),
            BigRational::new(value.into(), BigInt::from(denominator) << shift),
            BigRational::new(big, BigInt::from(denominator) << (1200 - shift)),
        ] {
            let interval = Interval::from(&fraction);
            prop_assert!(contains(&interval, &fraction), "{:?} {}", interval, fraction);
        }
        // Integers that are floats are points.
        let point = Interval::new(small as f64, small as f64);
        prop_assert_eq!(Some(Interval::from(small)), point);
        prop_assert_eq!(Some(Interval::from(&BigInt::from(small))), point);
        prop_assert_eq!(Some(Interval::from(&rational(small, 1))), point);
    }

    /// What runs over any ring runs over intervals: a polynomial at a point.
    #[test]
    fn polynomials_over_intervals(coefficients in prop::collection::vec(-9_i64..=9, 1..8), u in -9_i64..=9, q in 1_i64..=9) {
        let u = rational(u, q);
        let exact = Polynomial::new(integer(0), coefficients.iter().map(|&c| rational(c, 1)));
        let bounds = Polynomial::new(Interval::from(0_u64), coefficients.iter().map(|&c| Interval::from(c)));
        prop_assert!(contains(&bounds.evaluate(&Interval::from(&u)), &exact.evaluate(&u)));
        let (exact, bounds) = (exact.power(3), bounds.power(3));
        prop_assert_eq!(exact.degree(), bounds.degree());
        for (exact, bounds) in exact.coefficients().iter().zip(bounds.coefficients()) {
            prop_assert!(contains(bounds, exact));
        }
    }
}

#[test]
fn zero_stays_exact() {
    let zero = Interval::from(0_u64);
    let line = Interval::new(f64::NEG_INFINITY, f64::INFINITY).unwrap();
    let tiny = Interval::new(5e-324, 5e-324).unwrap();
    for a in [zero, line, tiny, Interval::from(7_u64), Interval::new(-0.0, 0.0).unwrap()] {
        assert!(zero.times(&a).is_zero() && a.times(&zero).is_zero());
        assert_eq!((a.plus(&zero), zero.plus(&a), a.minus(&zero)), (a, a, a));
    }
    assert_eq!(zero.sign(), Some(Ordering::Equal));
    // A product that underflows is not 0, but no longer known to be positive; it is not negative.
    let product = tiny.times(&tiny);
    assert_eq!((product.lo(), product.is_zero(), product.sign()), (0.0, false, None));
    // a − a is not known to be 0.
    let seven = Interval::from(7_u64);
    assert_eq!(seven.minus(&seven).sign(), None);
}

#[test]
fn overflow_is_honest() {
    let huge = Interval::from(&(BigInt::from(1) << 5000_usize));
    assert_eq!((huge.lo(), huge.hi()), (f64::MAX, f64::INFINITY));
    let square = huge.times(&huge);
    assert!(1e308 < square.lo() && square.hi() == f64::INFINITY);
    assert_eq!(square.sign(), Some(Ordering::Greater));
    let difference = square.minus(&huge);
    assert_eq!((difference.lo(), difference.hi()), (f64::NEG_INFINITY, f64::INFINITY));
    assert!(sound(&difference.times(&difference)) && difference.sign().is_none());
}

#[test]
fn what_holds_no_number_is_no_interval() {
    let (inf, nan) = (f64::INFINITY, f64::NAN);
    for (lo, hi) in [(1.0, 0.0), (nan, 1.0), (0.0, nan), (inf, inf), (-inf, -inf), (inf, -inf)] {
        assert_eq!(Interval::new(lo, hi), None, "[{lo}, {hi}]");
    }
    assert!(Interval::new(-inf, inf).is_some());
}
