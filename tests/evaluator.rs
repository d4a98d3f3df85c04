//! Values without a division on the way, against the recursion over rational numbers.

use knotproof::scalar::{BigRational, Jet, integer, rational};
use knotproof::spline::{Active, Basis, Evaluator, Index, KnotVector, Side};
use num_bigint::BigInt;
use proptest::prelude::*;

/// The recursion over rational numbers at x.
fn reference(basis: &Basis, x: &BigRational, side: Side) -> Option<Active<BigRational>> {
    basis.knots().span_at(x, side).map(|span| basis.active(span, x).expect("a span of these knots"))
}

/// Values, sums and parts at x against the reference.
fn agree(evaluator: &mut Evaluator, basis: &Basis, x: &BigRational) {
    for side in [Side::Left, Side::Right] {
        let expected = reference(basis, x, side);
        let Some(mut found) = evaluator.at(x, side) else {
            assert_eq!(expected, None, "at {x}");
            continue;
        };
        let expected = expected.expect("inside");
        assert_eq!(found.first(), expected.first());
        let parts: Vec<_> = found.numerators().into_iter().zip(found.denominators()).collect();
        let values: Vec<_> = parts.iter().map(|(n, d)| BigRational::new(n.clone(), d.clone())).collect();
        assert_eq!(values, expected.values(), "unreduced, at {x}");
        assert!(parts.iter().all(|(n, d)| *n >= BigInt::ZERO && *d > BigInt::ZERO));
        let sum: BigRational = expected.values().iter().sum();
        assert_eq!(found.sum_is_one(), sum == integer(1));
        let reduced = found.reduced();
        assert_eq!(reduced, expected, "reduced, at {x}");
        let values = evaluator.values(x, side).expect("inside");
        assert_eq!(values, expected, "values, at {x}");
        // `==` of fractions multiplies out; these are in lowest terms.
        for ((found, value), expected) in reduced.values().iter().zip(values.values()).zip(expected.values())
        {
            assert_eq!((found.numer(), found.denom()), (expected.numer(), expected.denom()));
            assert_eq!((value.numer(), value.denom()), (expected.numer(), expected.denom()));
        }
    }
}

/// Jets at x against the triangle over jets.
fn jets_agree(evaluator: &mut Evaluator, basis: &Basis, x: &BigRational, order: usize) {
    for side in [Side::Left, Side::Right] {
        let expected = basis
            .knots()
            .span_at(x, side)
            .map(|span| basis.active(span, &Jet::variable(x.clone(), order)).expect("a span of these knots"));
        assert_eq!(evaluator.jets(x, side, order), expected, "at {x}");
    }
}

/// In high degrees: nearly all factors are equal to others, some are, none is.
#[test]
fn many_factors_have_the_same_lowest_terms() {
    let equidistant = |t: i64| integer(t);
    let uneven = |t: i64| integer(t + i64::from(t % 7 == 3) * 5 * t);
    let all_apart = |t: i64| rational(t * t * t + 17 * t, 3);
    for knots in [
        (0..200).map(equidistant).collect::<Vec<_>>(),
        (0..200).map(uneven).collect(),
        (0..110).map(all_apart).collect(),
    ] {
        let mut knots = knots;
        knots.sort();
        // From degree 96 on it depends on how many factors are equal by which recursion the values are computed.
        let degree = knots.len() / 2 - 4;
        let x = (&knots[degree + 3] * integer(2) + &knots[degree + 4]) / integer(3);
        for alpha in ["inf", "-1"] {
            let (knots, index) = (KnotVector::new(knots.clone()).unwrap(), alpha.parse::<Index>().unwrap());
            let basis = Basis::new(knots, degree, index).unwrap();
            agree(&mut Evaluator::new(&basis), &basis, &x);
        }
    }
}

/// Knots of a few sizes, often repeated, some of them fractions or huge.
fn bases() -> impl Strategy<Value = Basis> {
    let gap = prop_oneof![
        3 => Just((0_i64, 1_i64)),
        4 => (1_i64..5, Just(1_i64)),
        2 => (1_i64..40, 1_i64..12),
        1 => (1_i64 << 40..1_i64 << 50, 1_i64..1000),
    ];
    let ratio = prop_oneof![3 => (1_i64..9, 1_i64..9), 1 => (1_i64..1 << 40, 1_i64..1 << 40)];
    (0_usize..7, prop::collection::vec(gap, 2..22), ratio, -3_i64..3).prop_filter_map(
        "no basis",
        |(degree, gaps, (p, q), start)| {
            let mut knots = vec![rational(start, 7)];
            for (numerator, denominator) in gaps {
                knots.push(&knots[knots.len() - 1] + rational(numerator, denominator));
            }
            let index = Index::from_ratio(rational(p, q)).ok()?;
            Basis::new(KnotVector::new(knots).ok()?, degree, index).ok()
        },
    )
}

/// Knots, points between them with denominators of all sizes, and outside.
fn points(basis: &Basis, parts: (i64, i64)) -> Vec<BigRational> {
    let knots = basis.knots();
    let mut points: Vec<_> = knots.knots().to_vec();
    let part = rational(parts.0, parts.1);
    for span in knots.spans() {
        let (start, end) = knots.ends(span).expect("a span of these knots");
        points.push(start + (end - start) * &part);
    }
    points.extend([knots.first() - integer(1), knots.last() + integer(1)]);
    points
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(96))]
    #[test]
    fn the_same_as_by_the_recursion_over_rationals(
        basis in bases(),
        denominator in prop_oneof![1_i64..20, 1_i64 << 20..1 << 21, 1_i64 << 55..1 << 60],
        numerator in 0_i64..i64::MAX,
    ) {
        let mut evaluator = Evaluator::new(&basis);
        for x in points(&basis, (numerator % (denominator + 1), denominator)) {
            agree(&mut evaluator, &basis, &x);
        }
    }

    #[test]
    fn jets_are_those_of_the_recursion(basis in bases(), numerator in 0_i64..=12, order in 0_usize..6) {
        let mut evaluator = Evaluator::new(&basis);
        for x in points(&basis, (numerator, 12)).iter().step_by(3) {
            jets_agree(&mut evaluator, &basis, x, order);
        }
    }
}

/// Degree 2, Bernstein on (0, 1) with r = 1: the largest factor L is the denominator of x, and three of them fit into
/// 127 bits as long as it has 42.
#[test]
fn the_widths_of_integers_change_at_their_bounds() {
    let knots = KnotVector::bernstein(2, &integer(0), &integer(1)).unwrap();
    let basis = Basis::new(knots, 2, Index::infinity()).unwrap();
    let mut evaluator = Evaluator::new(&basis);
    for bits in [41, 42, 43, 62, 63, 64, 65, 127, 128, 129] {
        for off in -2..=2 {
            let denominator: BigInt = (BigInt::from(1) << bits) + off;
            for numerator in [BigInt::from(1), &denominator / 2, &denominator / 3, &denominator - 1] {
                agree(&mut evaluator, &basis, &BigRational::new(numerator, denominator.clone()));
            }
        }
    }
}

/// What one point leaves behind does not show at the next.
#[test]
fn points_of_all_sizes_in_any_order() {
    let knots = KnotVector::new([0, 0, 1, 2, 2, 2, 5, 6, 6].map(integer).to_vec()).unwrap();
    let basis = Basis::new(knots, 3, "-1/3".parse().unwrap()).unwrap();
    let mut evaluator = Evaluator::new(&basis);
    let power: BigInt = BigInt::from(1) << 200;
    let huge = BigRational::new(&power * 3 + 1, power);
    for x in
        [integer(0), huge.clone(), rational(1, 3), rational(7, 2), huge, integer(6), rational(1, 1 << 50)]
    {
        agree(&mut evaluator, &basis, &x);
    }
}

/// The largest degree with knots of every multiplicity.
#[test]
fn degree_forty() {
    let knots = KnotVector::new((0..=100).map(|i| integer(i / 2)).collect()).unwrap();
    let basis = Basis::new(knots, 40, "5/2".parse().unwrap()).unwrap();
    let mut evaluator = Evaluator::new(&basis);
    for x in [rational(77, 3), integer(25), rational(1, 7)] {
        agree(&mut evaluator, &basis, &x);
    }
}
