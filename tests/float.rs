//! The floating-point study: what it measures, on the paper's instances and where it is known beforehand.

use knotproof::claims::instances_named;
use knotproof::float::{INTERIOR_POINTS, discrepancy};
use knotproof::scalar::{RationalAlgebra, exact_value, integer, parse_rational, rational, ulp};
use knotproof::spline::{Basis, KnotVector, Side};
use num_traits::{Signed, Zero};

fn basis(degree: usize, knots: &str, alpha: &str) -> Basis {
    let knots = knots.split(' ').map(|t| parse_rational(t).expect("a number")).collect();
    let knots = KnotVector::new(knots).expect("rising knots");
    Basis::new(knots, degree, alpha.parse().expect("an index")).expect("knots enough")
}

/// Where no operation rounds, no error is found: one span of 65 units, so that the points are integers.
#[test]
fn without_rounding_there_is_no_error() {
    let constant = discrepancy(&basis(0, "0 65", "5"));
    assert!(constant.max_absolute.error.is_zero() && constant.max_ulp.error.is_zero());
    assert_eq!((constant.points, constant.not_finite), (INTERIOR_POINTS + 2, 0));
}

/// One function of degree 1 with α = ∞ on [0, 65]: G_0 = (65 − x)/65 and G_1 = x/65, each rounded once, so
/// the errors are those of 64 divisions, and none is above half a unit.
#[test]
fn one_division_is_at_most_half_a_unit_off() {
    let found = discrepancy(&basis(1, "0 0 65 65", "inf"));
    let error = |x: u32| (exact_value(f64::from(x) / 65.0).expect("finite") - rational(x.into(), 65)).abs();
    let errors = || (0..=65).map(error);
    let in_units = (1..=65).map(|x| error(x) / ulp(&rational(x.into(), 65)));
    assert_eq!(Some(found.max_absolute.error), errors().max());
    assert_eq!(Some(&found.max_ulp.error), in_units.max().as_ref());
    assert!(found.max_ulp.error <= rational(1, 2));
}

/// The worst place is what it says: the same lines once more, at that place alone.
#[test]
fn the_worst_place_can_be_looked_up() {
    for name in ["U0", "U3", "U5", "U11", "C5"] {
        for instance in instances_named(name) {
            for index in instance.indices {
                let basis = Basis::new(instance.knots.clone(), instance.degree, index).expect("valid");
                let found = discrepancy(&basis);
                for (worst, in_units) in [(&found.max_absolute, false), (&found.max_ulp, true)] {
                    let span = basis.knots().span_at(&worst.x, worst.side).expect("inside");
                    let exact = &basis.values(&worst.x, worst.side)[worst.index];
                    let active = basis.active(span, &0.0_f64.embed(&worst.x));
                    let float = *active.get(worst.index).expect("a function that lives there");
                    let error = (exact_value(float).expect("finite") - exact).abs();
                    let expected = if in_units { error / ulp(exact) } else { error };
                    assert_eq!(worst.error, expected, "{name}");
                }
                assert_eq!(found.points, basis.knots().spans().count() * (INTERIOR_POINTS + 2));
                // A few roundings of values up to 1 in degree 3 at most, on knots that are floats or nearly.
                assert!(found.max_absolute.error < rational(1, 1 << 48), "{name}");
                assert_eq!(found, discrepancy(&basis), "{name}");
            }
        }
    }
}

/// Two knots that round to one float: the span between them has no width in f64. That does no harm at the
/// start, and is fatal where the function has to fall from 1 to 0 in that span.
#[test]
fn knots_that_no_float_can_tell_apart_are_seen() {
    let found = discrepancy(&basis(1, "0 0 1e-30 1 1", "inf"));
    assert!(found.max_absolute.error < rational(1, 1 << 50));
    let found = discrepancy(&basis(1, "0 1 1.0000000000000000001 2", "inf"));
    assert_eq!(found.max_absolute.error, integer(1));
    assert_eq!(found.max_absolute.side, Side::Left);
    // G_0 falls to 0 there, exactly. In units of the last place of 0, its error would be 2^1074.
    assert!(found.max_ulp.error < rational(1 << 60, 1));
}

/// Beyond the range of f64 a value has no error, and is counted.
#[test]
fn what_is_not_finite_is_counted() {
    let found = discrepancy(&basis(1, "0 0 1e400 1e400", "inf"));
    assert!(found.not_finite > 0);
}

#[test]
fn the_figures_serialise_as_text() {
    let found = discrepancy(&basis(2, "0 0 0 2/5 13/5 3 3 3", "-1"));
    let json = serde_json::to_value(&found).expect("plain data");
    assert_eq!(json["max_ulp"]["x"], found.max_ulp.x.to_string());
    assert_eq!(json["max_ulp"]["side"], "right");
    assert_eq!(json["points"], 3 * (INTERIOR_POINTS + 2));
    let shown = json["max_absolute"]["error"].as_str().expect("a text");
    let shown = parse_rational(shown).expect("that is a number");
    let error = &found.max_absolute.error;
    assert!((shown - error).abs() <= error * rational(1, 100_000));
}
