//! The library in the hands of somebody who mixes things up: an error, never the answer to another question.

#![allow(clippy::unwrap_used, reason = "helpers of tests")]

use std::panic::catch_unwind;

use knotproof::analysis::{
    LocalKnots, LocalKnotsError, Pieces, RationalBezier, Shape, coordinate_of, knot_slopes,
    positive_coordinate, span_quotients, symbolic_quotients,
};
use knotproof::float::FloatBasis;
use knotproof::scalar::{
    BigInt, BigRational, Jet, RationalFunction, Ring, integer, parse_rational, rational,
};
use knotproof::spline::{
    Active, Basis, Curve, CurveError, Index, KnotError, KnotVector, PointWeights, Side, Span, SpanError,
    binomial, by_definition, de_boor, triangle,
};

fn knots(list: &[i64]) -> KnotVector {
    KnotVector::new(list.iter().map(|&t| integer(t)).collect()).unwrap()
}

fn basis(degree: usize, list: &[i64]) -> Basis {
    Basis::new(knots(list), degree, "-1".parse().unwrap()).unwrap()
}

/// Vectors of which some have a span of the same index, and one has none so far to the right.
fn strangers() -> Vec<Basis> {
    vec![
        basis(2, &[0, 0, 0, 1, 2, 3, 3, 3]),
        basis(2, &[0, 0, 0, 2, 4, 6, 6, 6]),
        basis(2, &[0, 0, 0, 1, 2, 3, 3, 4]),
        basis(1, &[0, 1, 2]),
        basis(2, &(0..40).collect::<Vec<_>>()),
        basis(2, &[0, 0, 0, 0, 0, 0, 1, 1]),
    ]
}

#[test]
fn a_span_belongs_to_its_knot_vector() {
    let all = strangers();
    let mut refused = 0;
    for own in &all {
        for other in &all {
            for span in other.knots().spans() {
                let foreign = own.knots() != other.knots();
                let error = foreign.then_some(SpanError::Foreign(span.index()));
                let x = other.knots().ends(span).unwrap().0.clone();
                let variable = RationalFunction::variable(&integer(1));
                assert_eq!(own.knots().ends(span).err(), error);
                assert_eq!(positive_coordinate(own.knots(), span).err(), error);
                assert_eq!(coordinate_of(own.knots(), span, &x).err(), error);
                assert_eq!(span_quotients(own, span).err(), error);
                assert_eq!(symbolic_quotients(own.knots(), own.degree(), span).err(), error);
                assert_eq!(own.active(span, &x).err(), error);
                assert_eq!(own.active(span, &variable).err(), error);
                assert_eq!(by_definition(own, span, &x).err(), error);
                assert_eq!(Pieces::of(own).on(span).is_none(), foreign);
                refused += usize::from(foreign);
            }
        }
    }
    assert!(refused > 100, "{refused}");
    // An equal vector is no other one.
    let (one, two) = (&all[0], basis(2, &[0, 0, 0, 1, 2, 3, 3, 3]));
    let span = two.knots().span_at(&integer(1), Side::Right).unwrap();
    assert_eq!(one.active(span, &integer(1)), two.active(span, &integer(1)));
    // Spans of floats are of another vector, and empty ones are none.
    let float = FloatBasis::<f64>::new(vec![0.0, 1.0, 2.0], 1, 2.0).unwrap();
    let span: Span = float.span_at(0.5, Side::Right).unwrap().unwrap();
    assert!(knots(&[0, 1, 2]).ends(span).is_err());
    assert_eq!((one.knots().span(0), one.knots().span(7), one.knots().span(usize::MAX)), (None, None, None));
}

#[test]
fn a_point_lies_on_its_span() {
    let basis = basis(2, &[0, 0, 0, 1, 2, 3, 3, 3]);
    for span in basis.knots().spans() {
        let (start, end) = basis.knots().ends(span).unwrap();
        let outside = Err(SpanError::Outside(span.index()));
        let hair = rational(1, i64::MAX);
        for x in [start - &hair, end + &hair, integer(-1), integer(10)] {
            assert_eq!(basis.active(span, &x), outside.map(|()| Active::new(0, vec![])));
            assert!(by_definition(&basis, span, &x).is_err());
            assert_eq!(coordinate_of(basis.knots(), span, &x), Err(SpanError::Outside(span.index())));
            assert!(basis.active(span, &Jet::variable(x.clone(), 2)).is_err());
            assert!(basis.active(span, &RationalFunction::constant(x)).is_err());
        }
        for x in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, -1e-300, 3.5] {
            assert!(basis.active(span, &x).is_err(), "{x}");
            assert!(by_definition(&basis, span, &Jet::variable(x, 1)).is_err(), "{x}");
        }
        for x in [start, end] {
            assert!(basis.active(span, x).is_ok() && by_definition(&basis, span, x).is_ok());
        }
    }
}

/// Pieces have their basis with them: there is nothing to mismatch.
#[test]
fn pieces_know_their_basis() {
    for basis in strangers() {
        let pieces = Pieces::of(&basis);
        assert_eq!(pieces.basis(), &basis.with(()));
        for i in 0..=basis.n() {
            let bounds = basis.support(i);
            for extremum in Shape::of(&pieces, i).extrema() {
                let (lo, hi) = extremum.place.interval();
                assert!(bounds.0 <= lo && hi <= bounds.1);
            }
        }
        for (span, pieces) in basis.knots().spans().zip(pieces.spans()) {
            assert_eq!(Ok(pieces.ends()), basis.knots().ends(span));
        }
    }
}

#[test]
fn functions_without_a_control_point() {
    let [small, large] = [basis(1, &[0, 0, 1, 1]), basis(2, &(0..40).collect::<Vec<_>>())];
    let curve = Curve::new(small.clone(), vec![vec![integer(1)], vec![integer(2)]]).unwrap();
    let span = large.knots().span(20).unwrap();
    let functions = large.active(span, &integer(20)).unwrap();
    assert_eq!(curve.combine(&functions), Err(CurveError::Function { index: 18, n: 1 }));
    assert_eq!(curve.combine(&Active::<BigRational>::new(usize::MAX, vec![integer(1)])).ok(), None);
    let other = Curve::new(small, vec![vec![integer(1), integer(0)], vec![integer(2), integer(1)]]).unwrap();
    let piece = RationalBezier::pieces(&curve).next().unwrap().unwrap();
    assert!(piece.disagreement(&other).is_some());
}

#[test]
fn local_knots_are_knots() {
    let big = |list: &[i64]| list.iter().map(|&gap| BigInt::from(gap)).collect::<Vec<_>>();
    let new = |gaps: &[i64], p: i64, q: i64| LocalKnots::new(big(gaps), (p.into(), q.into()));
    assert_eq!(new(&[1, -1, 1], 1, 1), Err(LocalKnotsError::NegativeGap(1)));
    for (p, q) in [(0, 1), (-1, 1), (1, 0), (1, -1), (-1, -1)] {
        assert_eq!(new(&[1, 1], p, q), Err(LocalKnotsError::Ratio), "{p}/{q}");
    }
    assert!(new(&[1, 0, 1], 5, 3).is_ok());
    let rationals = |gap: BigRational| LocalKnots::new(vec![integer(1), gap], (integer(1), integer(2)));
    assert_eq!(rationals(rational(-1, 3)), Err(LocalKnotsError::NegativeGap(1)));
    let floats = LocalKnots::new(vec![1.0, -0.5], (1.0, 1.0));
    assert_eq!(floats, Err(LocalKnotsError::NegativeGap(1)));
}

/// Bounds that no machine has: refused or false, whether or not the caller's build checks for overflow.
#[test]
fn numbers_at_the_end_of_all_numbers() {
    let u4 = knots(&[0, 0, 0, 1, 2, 3, 3, 3]);
    for huge in [usize::MAX, usize::MAX / 2, usize::MAX / 2 + 1, usize::MAX - 1] {
        assert!(!u4.is_open(huge));
        assert!(u4.is_uniform(huge) && u4.interior(huge).is_empty());
        let made = KnotVector::bernstein(huge, &integer(0), &integer(1));
        assert_eq!(made, Err(KnotError::Degree(huge)));
        assert!(Basis::new(u4.clone(), huge, Index::infinity()).is_err());
        assert_eq!(symbolic_quotients(&u4, huge, u4.span(2).unwrap()).ok(), None);
        assert_eq!(binomial(huge, 1), integer(huge));
        assert_eq!(binomial(huge, huge), integer(1));
        assert_eq!(binomial(3, huge), integer(0));
    }
}

/// What still panics says so in its documentation, and does so at once.
#[test]
fn documented_panics() {
    let basis = basis(2, &[0, 0, 0, 1, 2, 3, 3, 3]);
    let pieces = Pieces::of(&basis);
    for i in [5, usize::MAX, usize::MAX - 1, usize::MAX - 3] {
        assert!(catch_unwind(|| LocalKnots::of(&basis, i).is_some()).is_err(), "{i}");
        assert!(catch_unwind(|| knot_slopes(&basis, i).len()).is_err(), "{i}");
        assert!(catch_unwind(|| Shape::of(&pieces, i).strong()).is_err(), "{i}");
        assert!(catch_unwind(|| basis.support(i).0.clone()).is_err(), "{i}");
    }
    let weights = PointWeights::new(basis.knots(), rational(1, 2), integer(1));
    let span = basis.knots().span(3).unwrap();
    for (degree, m) in [(7, 7), (usize::MAX, 7), (2, 3)] {
        assert!(catch_unwind(|| triangle(&weights, span, degree, m).first()).is_err(), "{degree}, {m}");
    }
    let point = || vec![integer(1)];
    assert_eq!(de_boor(&weights, span, &[]), None);
    assert_eq!(de_boor(&weights, span, &vec![point(); 5]), None);
    assert_eq!(de_boor(&weights, span, &[point(), vec![]]), None);
    assert!(de_boor(&weights, span, &vec![point(); 3]).is_some());
}

#[test]
fn numbers_and_indices_as_texts() {
    for text in [
        "++inf", "--inf", "+-inf", "-+inf", "+-+-inf", "- inf", "+", "-", "", "++1", "--1", "+-2", "inf inf",
        "-∞∞",
    ] {
        assert!(text.parse::<Index>().is_err(), "{text}");
        assert!(parse_rational(text).is_err(), "{text}");
    }
    for text in ["inf", "+inf", "-inf", "INF", "Infinity", "-∞", " inf "] {
        assert_eq!(text.parse::<Index>(), Ok(Index::infinity()), "{text}");
    }
    assert!(parse_rational("1e-9223372036854775808").is_err());
}

#[test]
fn integers_of_every_type() {
    let minus_one = rational(-1, 1);
    assert_eq!(
        [integer(-1), integer(-1_i8), integer(-1_i64), integer(-1_i128), integer(BigInt::from(-1))],
        [minus_one.clone(), minus_one.clone(), minus_one.clone(), minus_one.clone(), minus_one]
    );
    assert_eq!(integer(u128::MAX).numer(), &BigInt::from(u128::MAX));
    assert!(integer(0_u8).is_zero());
}
