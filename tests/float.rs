//! The floating-point study: what it measures, where that is known beforehand, and that it can be done again.

#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests")]
#![allow(clippy::float_cmp, reason = "exact floats are expected")]

use knotproof::float::{Case, Effort, Errors, Field, FloatBasis, Formula, FormulaRecord, hexadecimal, study};
use knotproof::scalar::{RationalAlgebra, exact_value, integer, parse_rational, rational, ulp};
use knotproof::spline::Side;
use num_traits::{Signed, Zero};

const EFFORT: Effort = Effort { seed: 3, count: 60, steps: 300 };

fn case(knots: &[f64], degree: usize, alpha: f64, x: f64) -> Case {
    let basis = FloatBasis::new(knots.to_vec(), degree, alpha).expect("a basis");
    Case::at(basis, x, Side::Right).expect("a point of it")
}

/// Where no operation rounds, no error is found, by any formula.
#[test]
fn without_rounding_there_is_no_error() {
    for formula in Formula::ALL {
        let errors = Errors::of(formula, &case(&[0.0, 0.0, 0.0, 4.0, 4.0, 4.0], 2, f64::INFINITY, 1.0));
        assert!(errors.ulps.iter().all(|ulp| *ulp == Some(integer(0))), "{formula:?}");
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
        let errors = Errors::of(Formula::Paper, &case(&[0.0, 0.0, 65.0, 65.0], 1, f64::INFINITY, x.into()));
        assert_eq!(errors.ulps[1], Some(expected / ulp(&exact)));
    }
}

/// With α = 6/5 on knots about 10⁸ the paper's formula has lost half of its 16 digits at half of the points.
#[test]
fn the_papers_formula_loses_half_of_its_digits() {
    let knots: Vec<f64> = (0..6).map(|i| f64::from(100_000_000 + i)).collect();
    let basis = FloatBasis::new(knots, 2, 1.2).unwrap();
    let figures = study(&Field::Bases(vec![basis]), &Formula::ALL, EFFORT);
    let half = integer(1 << 26);
    for of in figures {
        match of.formula {
            Formula::Paper => assert!(of.median > half),
            Formula::Ratio => assert!(of.median < half),
            _ => assert!(of.keeps_bound() && of.signs == 0 && of.not_finite == 0),
        }
    }
}

/// The search finds more than chance does, and every proved bound holds where it ends.
#[test]
fn the_worst_case_is_within_the_bound_and_can_be_measured_again() {
    for degree in 0..=6 {
        let figures = study(&Field::Degree(degree), &Formula::ALL, EFFORT);
        assert_eq!(figures.iter().map(|of| of.formula).collect::<Vec<_>>(), Formula::ALL);
        for of in &figures {
            assert!(of.keeps_bound(), "{of:?}");
            assert!(of.formula.bound(degree).is_none() || of.signs == 0 && of.not_finite == 0);
            let worst = of.worst.as_ref().unwrap();
            assert!(worst.error >= of.percentile_99 && of.percentile_99 >= of.median);
            let again = Errors::of(of.formula, &worst.case);
            assert_eq!(again.worst().unwrap(), (&worst.error, worst.index));
            // What is printed says all there is.
            let record = FormulaRecord::from(of).worst.unwrap();
            let float = |text: &String| match text.as_str() {
                "inf" => f64::INFINITY,
                text => 0.0_f64.embed(&parse_rational(text).unwrap()),
            };
            for texts in [&record.float, &record.exact] {
                let knots: Vec<f64> = texts.knots.iter().map(float).collect();
                let case = case(&knots, degree, float(&texts.alpha), float(&texts.x));
                assert_eq!(Errors::of(of.formula, &case), again);
            }
        }
        let ours = figures.last().unwrap();
        // The bound is as good as reached.
        assert!(degree == 0 || ours.worst.as_ref().unwrap().error > rational(49, 100));
        let other = study(&Field::Degree(degree), &Formula::ALL, EFFORT);
        assert_eq!(format!("{other:?}"), format!("{figures:?}"), "the result depends on the seed only");
    }
}

/// A wrong value, a wrong sign and a NaN are seen as such: the paper's formula has 0/0 where α(b − a) is rounded away.
#[test]
fn what_is_not_finite_is_no_error_and_is_counted() {
    let found = case(&[0.0, 0.0, 1e300, 1e300], 1, 1e300, 1e300);
    let errors = Errors::of(Formula::Paper, &found);
    assert!(errors.ulps.contains(&None) && errors.sum.is_none(), "{errors:?}");
    assert_eq!(Errors::of(Formula::Accurate, &found).signs, 0);
}

#[test]
fn floats_are_written_exactly() {
    for value in [1.0, -0.1, 1e300, 5e-324, f64::MAX, 2.2e-308, 0.0] {
        let read = parse_rational(&hexadecimal(value)).unwrap();
        assert_eq!(read, exact_value(value).unwrap(), "{}", hexadecimal(value));
    }
    assert_eq!((hexadecimal(f64::INFINITY), hexadecimal(f64::NEG_INFINITY)), ("inf".into(), "-inf".into()));
}
