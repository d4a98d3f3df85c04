//! How often a function turns, against its shape: the quick way and the slow one agree.

#![allow(clippy::unwrap_used, reason = "helpers of tests: a failure is a failed test")]

use knotproof::analysis::{LocalKnots, Monotonicity, Pieces, Route, Shape, Sign, sign_pattern};
use knotproof::scalar::{BigRational, Polynomial, Ring, integer};
use knotproof::spline::{Basis, Index, KnotVector};
use num_bigint::BigInt;
use proptest::prelude::*;

fn local_knots(gaps: &[u64], (p, q): (u64, u64)) -> LocalKnots<BigInt> {
    LocalKnots::new(gaps.iter().map(|&gap| gap.into()).collect(), (p.into(), q.into())).unwrap()
}

/// A basis whose first function has these gaps, and ends inside.
fn basis(gaps: &[u64], (p, q): (u64, u64)) -> Basis {
    let mut knots = vec![integer(0)];
    for &gap in gaps.iter().chain(&vec![1; gaps.len()]) {
        knots.push(&knots[knots.len() - 1] + BigRational::from(BigInt::from(gap)));
    }
    let ratio = BigRational::new(p.into(), q.into());
    Basis::new(KnotVector::new(knots).unwrap(), gaps.len() - 1, Index::from_ratio(ratio).unwrap()).unwrap()
}

/// The signs on each span by isolating the roots of the slope of the reduced piece, over the rationals.
fn signs_of_pieces(basis: &Basis) -> Vec<(usize, Vec<Sign>)> {
    let pieces = Pieces::of(basis);
    let of_span = |function: &knotproof::scalar::RationalFunction<BigRational>| {
        let (p, q) = (function.numerator(), function.denominator());
        let slope: Polynomial<BigRational> = p.derivative().times(q).minus(&p.times(&q.derivative()));
        let mut signs: Vec<Sign> = sign_pattern(&slope).between().iter().map(|(_, sign)| *sign).collect();
        signs.dedup();
        signs
    };
    let spans = pieces.spans().iter().filter(|span| span.span.index() <= basis.degree());
    spans.map(|span| (span.span.index(), of_span(&span.function(0)))).collect()
}

/// Gaps of every kind for degrees 1 to 6: none, small, equal, and log-spread; ratios with 1 among them.
fn function() -> impl Strategy<Value = (Vec<u64>, (u64, u64))> {
    let log_spread = || (0.0..9.0_f64).prop_map(|log| log.exp().round().to_string().parse().unwrap());
    let gap = prop_oneof![2 => Just(0), 2 => Just(1), 2 => 1_u64..=4, 5 => log_spread()];
    let part = prop_oneof![2 => 1_u64..=4, 2 => log_spread()];
    let ratio = prop_oneof![1 => Just((1, 1)), 4 => (part.clone(), part)];
    let degree = prop_oneof![12 => 1_usize..=4, 2 => Just(5), 1 => Just(6)];
    let gaps = degree.prop_flat_map(move |k| prop::collection::vec(gap.clone(), k + 1));
    (gaps.prop_filter("a span", |gaps| gaps.iter().any(|&gap| gap > 0)), ratio)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn monotonicity_agrees_with_the_shape((gaps, ratio) in function()) {
        let found = Monotonicity::of(&local_knots(&gaps, ratio));
        let basis = basis(&gaps, ratio);
        let signs: Vec<_> = found.spans().iter().map(|span| (span.span, span.signs.clone())).collect();
        prop_assert_eq!(signs, signs_of_pieces(&basis));
        let shape = Shape::of(&Pieces::of(&basis), 0);
        // The first knot may be one where the function jumps, and so may the last.
        let k = basis.degree();
        prop_assert_eq!(found.continuous(), gaps[..k].iter().any(|&g| g > 0) && gaps[1..].iter().any(|&g| g > 0));
        if found.continuous() {
            prop_assert_eq!(found.local_maxima(), Some(shape.local_maxima().count()));
            prop_assert_eq!(found.local_minima(), Some(shape.local_minima().count()));
            prop_assert!(shape.jumps().is_empty());
        } else {
            prop_assert_eq!((found.local_maxima(), found.local_minima()), (None, None));
            prop_assert_eq!(found.spans().len(), 1);
        }
    }

    /// x ↦ −x: gaps and signs in reverse, r and 1/r.
    #[test]
    fn reversal_reverses((gaps, (p, q)) in function()) {
        let signs = |gaps: &[u64], ratio| {
            let found = Monotonicity::of(&local_knots(gaps, ratio));
            found.spans().iter().flat_map(|span| span.signs.clone()).collect::<Vec<_>>()
        };
        let there = signs(&gaps, (p, q));
        let reversed: Vec<u64> = gaps.iter().rev().copied().collect();
        let back: Vec<Sign> = signs(&reversed, (q, p)).into_iter().rev().map(Sign::opposite).collect();
        prop_assert_eq!(there, back);
    }
}

/// On every span: the number of spans decided by each route.
fn routes(functions: &[(Vec<u64>, (u64, u64))]) -> [usize; 2] {
    let found = functions.iter().map(|(gaps, ratio)| Monotonicity::of(&local_knots(gaps, *ratio)));
    let routes: Vec<Route> = found.flat_map(|f| f.spans().to_vec()).map(|span| span.route).collect();
    [Route::Intervals, Route::Integers].map(|wanted| routes.iter().filter(|route| **route == wanted).count())
}

#[test]
fn intervals_decide_most_spans() {
    // Without a common scale or symmetry.
    let spread = [31, 7, 1_000, 211, 3, 89, 17, 463, 5, 2_003];
    let functions: Vec<_> = (0..40)
        .map(|n| ((0..=3 + n % 3).map(|j| spread[(n + 3 * j) % 10]).collect(), (spread[(7 * n) % 10], 29)))
        .collect();
    let [intervals, integers] = routes(&functions);
    assert!(intervals > 20 * integers, "{intervals} by intervals, {integers} by integers");
}

/// On the first span and on the last nothing is computed; there all coefficients of the slope have one sign.
#[test]
fn the_ends_of_the_support_need_no_computation() {
    for gaps in [&[1, 2][..], &[3, 1, 2], &[1, 0, 0, 2], &[5, 1, 0, 3, 2], &[1, 1, 1, 1, 1, 1]] {
        for ratio in [(1, 1), (1, 7), (9, 2)] {
            let knots = local_knots(gaps, ratio);
            let found = Monotonicity::of(&knots);
            let last = found.spans().len() - 1;
            for (at, sign) in [(0, Sign::Positive), (last, Sign::Negative)] {
                let span = &found.spans()[at];
                assert_eq!((span.route, &span.signs[..]), (Route::Product, &[sign][..]));
                let slope = knots.on_span(span.span).unwrap().slope();
                let signs = slope.coefficients().iter().map(Sign::of).filter(|sign| *sign != Sign::Zero);
                assert!(signs.clone().count() > 0 && signs.clone().all(|found| found == sign));
            }
        }
    }
    let plateau = Monotonicity::of(&local_knots(&[2], (1, 1)));
    assert_eq!(plateau.spans()[0].signs, [Sign::Zero]);
}

#[test]
fn what_intervals_leave_open_goes_to_integers() {
    // Uniform knots, r = 1, odd degree: the maximum is at a knot, so the slope there is 0, which rounding hides.
    let [_, integers] = routes(&[(vec![1; 4], (1, 1))]);
    assert!(integers > 0);
    // Two maxima, which intervals see.
    let found = Monotonicity::of(&local_knots(&[0, 1, 1, 2], (5, 3)));
    assert!(found.spans().iter().all(|span| span.route != Route::Integers));
    assert_eq!((found.local_maxima(), found.local_minima()), (Some(2), Some(1)));
    // Beyond the range of floats nothing is left but integers, and they are exact.
    let huge = |gap: u64| BigInt::from(gap) << 2000_usize;
    let gaps = [0, 1, 1, 2].map(huge).to_vec();
    let scaled = Monotonicity::of(&LocalKnots::new(gaps, (5.into(), 3.into())).unwrap());
    assert_eq!(scaled.local_maxima(), Some(2));
    assert!(scaled.spans().iter().any(|span| span.route == Route::Integers));
    for (span, small) in scaled.spans().iter().zip(found.spans()) {
        assert_eq!((span.span, &span.signs), (small.span, &small.signs));
    }
}

#[test]
fn three_local_maxima() {
    // Degree 5, by decimals.
    let gaps = [798_629, 50_969, 15_552_000, 72_327, 2_424_870, 9_185_290];
    assert_eq!(Monotonicity::of(&local_knots(&gaps, (183_588, 1_000_000))).local_maxima(), Some(3));
}

#[test]
fn one_span_alone() {
    // Degree 0: constant, and no continuous function.
    let constant = Monotonicity::of(&local_knots(&[3], (2, 1)));
    assert_eq!(constant.spans()[0].signs, [Sign::Zero]);
    assert_eq!((constant.continuous(), constant.local_maxima()), (false, None));
    // A Bernstein polynomial, by its own knots: 0 at both ends, or not.
    let bernstein = |gaps: &[u64]| Monotonicity::of(&local_knots(gaps, (2, 1))).local_maxima();
    assert_eq!([bernstein(&[0, 1, 0]), bernstein(&[1, 0, 0]), bernstein(&[0, 0, 1])], [Some(1), None, None]);
}
