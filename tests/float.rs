//! The floating-point study: what it measures, where that is known beforehand, and that it can be done again.

#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests")]
#![allow(clippy::float_cmp, reason = "exact floats are expected")]

use std::sync::Arc;

use knotproof::float::{FloatBasis, hexadecimal};
use knotproof::language::families;
use knotproof::meaning::{Instance, Weighting};
use knotproof::scalar::{RationalAlgebra, exact_value, integer, parse_rational, rational, ulp};
use knotproof::spline::{Basis, KnotVector, Side};
use knotproof::study::{Effort, Errors, FloatMember, Method, MethodRecord, Population, Probe, Ulps, study};
use num_traits::{Signed, Zero};
use proptest::prelude::*;

const EFFORT: Effort = Effort { seed: 3, count: 60, steps: 300 };

fn case(knots: &[f64], degree: usize, alpha: f64, x: f64) -> Probe {
    let basis = FloatBasis::new(knots.to_vec(), degree, alpha).expect("a basis");
    Probe::at(basis, x, Side::Right).expect("a point of it")
}

/// Where no operation rounds, no error is found, by any formula.
#[test]
fn without_rounding_there_is_no_error() {
    for formula in Method::ALL {
        let errors = Errors::of(formula, &case(&[0.0, 0.0, 0.0, 4.0, 4.0, 4.0], 2, f64::INFINITY, 1.0));
        assert!(errors.ulps.iter().all(|ulp| *ulp == Ulps::Number(integer(0))), "{formula:?}");
        assert!(errors.absolute.is_zero() && errors.sum == Some(integer(0)) && errors.signs == 0);
    }
}

/// G_1 = x/65 on [0, 65] with α = ∞ is one division, which rounds once: the error is known from that alone.
#[test]
fn an_error_is_measured_exactly() {
    for x in 1..65 {
        let float = f64::from(x) / 65.0;
        let exact = rational(x.into(), 65);
        let expected = (exact_value(float).unwrap() - &exact).abs();
        let errors = Errors::of(Method::Paper, &case(&[0.0, 0.0, 65.0, 65.0], 1, f64::INFINITY, x.into()));
        assert_eq!(errors.ulps[1], Ulps::Number(expected / ulp(&exact)));
    }
}

/// With α = 6/5 on knots about 10⁸ the paper's formula has lost half of its 16 digits at half of the points.
#[test]
fn the_papers_formula_loses_half_of_its_digits() {
    let knots: Vec<f64> = (0..6).map(|i| f64::from(100_000_000 + i)).collect();
    let basis = FloatBasis::new(knots, 2, 1.2).unwrap();
    let figures = study(&Population::Bases(vec![basis]), &Method::ALL, EFFORT);
    let half = Ulps::Number(integer(1 << 26));
    for of in figures {
        match of.formula {
            Method::Paper => assert!(of.median > half),
            Method::Ratio => assert!(of.median < half),
            _ => assert!(of.keeps_bound() && of.signs == 0 && of.not_finite == 0),
        }
    }
}

/// The search finds more than chance does, and every proved bound holds where it ends.
#[test]
fn the_worst_case_is_within_the_bound_and_can_be_measured_again() {
    for degree in 0..=6 {
        let figures = study(&Population::Degree(degree), &Method::ALL, EFFORT);
        assert_eq!(figures.iter().map(|of| of.formula).collect::<Vec<_>>(), Method::ALL);
        for of in &figures {
            assert!(of.keeps_bound(), "{of:?}");
            assert!(of.formula.bound(degree).is_none() || of.signs == 0 && of.not_finite == 0);
            let worst = of.worst.as_ref().unwrap();
            assert!(worst.error >= of.percentile_99 && of.percentile_99 >= of.median);
            let again = Errors::of(of.formula, &worst.case);
            assert_eq!(again.worst().unwrap(), (&worst.error, worst.index));
            // What is printed says all there is.
            let record = MethodRecord::from(of).worst.unwrap();
            let float = |text: &String| match text.as_str() {
                "inf" => f64::INFINITY,
                text => 0.0_f64.embed(&parse_rational(text).unwrap()),
            };
            for texts in [&record.float, &record.exact] {
                let knots: Vec<f64> = texts.knots.iter().map(float).collect();
                let case = case(&knots, degree, float(texts.alpha.as_ref().unwrap()), float(&texts.x));
                assert_eq!(Errors::of(of.formula, &case), again);
            }
        }
        let ours = figures.last().unwrap();
        // The bound is as good as reached.
        assert!(degree == 0 || ours.worst.as_ref().unwrap().error > Ulps::Number(rational(49, 100)));
        let other = study(&Population::Degree(degree), &Method::ALL, EFFORT);
        assert_eq!(format!("{other:?}"), format!("{figures:?}"), "the result depends on the seed only");
    }
}

/// What one case shows of each formula: the figures of a study of it alone.
/// What a member is measured against are the values of its definition, by the terms of its file.
#[test]
fn members_are_measured_against_their_definition() {
    let family = families().iter().find(|family| family.name == "smoothstep").expect("it is there");
    let weights = Weighting::of(family, &[]).expect("it has no parameters");
    let knots = KnotVector::new([0, 0, 0, 1, 3, 3, 3].map(integer).to_vec()).expect("knots");
    let basis = Basis::over(knots, 2, weights.clone()).expect("knots enough");
    let member = Arc::new(FloatMember::nearest(&basis).expect("numbers that are floats"));
    let on = Instance::on(basis).expect("any knots").by_definition();
    for x in [0.0, 0.1, 0.75, 1.0, 2.9, 3.0] {
        let case = Probe::of_member(&member, x, Side::Right).expect("a point");
        for formula in Method::OF_MEMBERS {
            let errors = Errors::of(formula, &case);
            let floats = formula.values(&case);
            let off = |(c, float): (usize, &f64)| {
                let i = (case.span.index() + c).checked_sub(2).expect("all of them exist");
                let exact = on.value(&weights, (i, 2), &exact_value(x).expect("finite"), Side::Right, 0);
                (exact_value(*float).expect("finite") - exact).abs()
            };
            let largest = floats.iter().enumerate().map(off).max().expect("three values");
            assert_eq!((errors.absolute, errors.ulps.len()), (largest, 3), "{x}, {formula:?}");
        }
        // α stands for nothing.
        assert!(Method::Accurate.values(&case).iter().all(|value| value.is_nan()));
    }
}

fn alone(case: &Probe) -> Vec<knotproof::study::Figures> {
    study(&Population::Cases(vec![case.clone()]), &Method::ALL, EFFORT)
}

/// The paper's formula has 0/0 where α(b − a) is rounded away; the others lose their numbers where a sum of differences
/// overflows, or its reciprocal.
#[test]
fn what_is_no_number_is_worse_than_any_bound() {
    let mut seen = [0; 5];
    for (knots, alpha, x) in [
        (&[0.0, 0.0, 1e300, 1e300][..], 1e300, 1e300),
        (&[0.0, 0.0, 1e-308, 1e-308], -1.0, 1e-308),
        (&[0.0, 0.0, 2e-308, 2e-308], -1e-300, 2e-308),
        (&[-9e307, -9e307, 9e307, 9e307], 2.0, 9e307),
        (&[0.0, 0.0, 0.0, 1e-310, 2e-310, 2e-310, 2e-310], -1.0, 1.5e-310),
        (&[-1e308, -1e308, -1e308, 1e308, 1e308, 1e308], f64::INFINITY, 0.0),
    ] {
        let found = case(knots, knots.len() / 2 - 1 - usize::from(knots.len() == 7), alpha, x);
        for (of, seen) in alone(&found).iter().zip(&mut seen) {
            let not_finite = of.formula.values(&found).iter().filter(|value| !value.is_finite()).count();
            let (worst, record) = (&of.worst.as_ref().unwrap().error, MethodRecord::from(of));
            assert_eq!((of.not_finite, *worst == Ulps::NotFinite), (not_finite, not_finite > 0), "{of:?}");
            if not_finite > 0 {
                *seen += 1;
                assert_eq!(of.keeps_bound(), of.bound.is_none());
                assert!(of.median == Ulps::NotFinite && record.bound_ulp.is_none());
                assert_eq!(record.max_ulp.as_deref(), Some("inf"));
                for text in [record.p99_ulp, record.median_ulp, record.max_absolute, record.max_sum] {
                    assert_eq!(text, "inf");
                }
            }
        }
    }
    assert!(seen[..3].iter().all(|seen| *seen > 0) && seen[3..] == [0, 0], "{seen:?}");
    assert!(Ulps::NotFinite > Ulps::Number(exact_value(f64::MAX).unwrap()));
}

/// A value that has no ULP to count is held to its absolute error and its sign.
#[test]
fn what_is_next_to_underflow_is_counted_and_measured() {
    let found = case(&[0.0, 0.0, 1.0, 1.0], 1, -1.0, 5e-324);
    for of in alone(&found) {
        assert_eq!((of.left_out, of.keeps_bound()), (1, true), "{of:?}");
        assert_eq!(of.signs, usize::from(!of.formula.keeps_signs()), "2^-1075 rounds to 0 in plain floats");
    }
    let errors = Errors::of(Method::Accurate, &found);
    assert!(errors.left_out == 1 && errors.beside.is_positive());
    // The exact value at a knot is 0: there is nothing to leave out.
    assert_eq!(Errors::of(Method::Accurate, &case(&[0.0, 0.0, 1.0, 1.0], 1, -1.0, 0.0)).left_out, 0);
}

/// Knots, α and x over the whole range of the exponents.
fn extreme() -> impl Strategy<Value = Probe> {
    let scale =
        || (-1074_i32..1022).prop_map(|e| 2.0_f64.powi(e.max(-1022)) * 2.0_f64.powi((e + 1022).min(0)));
    let near = (-130_i32..130).prop_map(|e| 2.0_f64.powi(e));
    let gap = prop_oneof![2 => Just(0.0), 3 => scale(), 4 => near, 2 => 0.1..9.0_f64];
    let alpha = prop_oneof![
        Just(f64::INFINITY),
        scale().prop_map(|s| -s),
        scale().prop_map(|s| 1.0 + s.max(f64::EPSILON)),
        (0.01..100.0_f64).prop_map(|s| -s),
    ];
    let shape = (0_usize..=6).prop_flat_map(move |k| {
        (Just(k), proptest::collection::vec(gap.clone(), 2 * k + 1), any::<prop::sample::Index>())
    });
    (shape, alpha, 0.0..=1.0_f64, any::<bool>()).prop_filter_map(
        "a basis",
        |((degree, gaps, origin), alpha, part, tiny)| {
            let mut knots = vec![0.0];
            for gap in gaps {
                knots.push(knots.last()? + gap);
            }
            let shift = knots[origin.index(knots.len())];
            let knots: Vec<f64> = knots.into_iter().map(|t: f64| t - shift).collect();
            let basis = FloatBasis::new(knots.clone(), degree, alpha).ok()?;
            let start = (0..knots.len() - 1).filter(|&j| knots[j] < knots[j + 1]);
            let starts: Vec<usize> = start.collect();
            let j = starts[origin.index(starts.len())];
            let x =
                knots[j] + part * if tiny { f64::MIN_POSITIVE } else { (knots[j + 1] - knots[j]).min(1e300) };
            Probe::at(basis, x.min(knots[j + 1]), Side::Right)
        },
    )
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 1000, failure_persistence: None, ..ProptestConfig::default() })]

    /// Every bound that is printed holds, wherever it is printed; and nothing that is no number gets past.
    #[test]
    fn a_bound_holds_where_it_is_said_to_apply(found in extreme()) {
        for of in alone(&found) {
            let record = MethodRecord::from(&of);
            if of.not_finite > 0 {
                prop_assert!(of.keeps_bound() == of.bound.is_none() && record.bound_ulp.is_none(), "{of:?}");
            } else {
                prop_assert!(of.keeps_bound(), "{of:?}");
            }
            let worst = &of.worst.as_ref().expect("a case").error;
            if let Some(bound) = record.bound_ulp {
                prop_assert!(*worst <= Ulps::Number(exact_value(bound).expect("finite")), "{of:?}");
            }
            prop_assert!(of.formula.bound(1).is_none() || record.bound_ulp.is_some() != record.bound_range.is_some());
        }
    }
}

#[test]
fn floats_are_written_exactly() {
    for value in [1.0, -0.1, 1e300, 5e-324, f64::MAX, 2.2e-308, 0.0] {
        let read = parse_rational(&hexadecimal(value)).unwrap();
        assert_eq!(read, exact_value(value).unwrap(), "{}", hexadecimal(value));
    }
    assert_eq!((hexadecimal(f64::INFINITY), hexadecimal(f64::NEG_INFINITY)), ("inf".into(), "-inf".into()));
}
