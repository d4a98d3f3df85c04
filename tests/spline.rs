//! Floor 2: the triangle against the recursion as the paper prints it, and the paper's identities as tests of
//! the code. All exact, on knots and indices that lean towards trouble.

use knotproof::analysis::{Pieces, positive_coordinate};
use knotproof::scalar::{BigRational, Jet, Polynomial, RationalAlgebra, Ring, integer, rational};
use knotproof::spline::{
    Active, Basis, Curve, FormalWeights, Index, IndexError, KnotVector, Point, Side, Span, bernstein,
    by_definition, triangle, weight,
};
use num_traits::{Pow, Signed, Zero};
use proptest::prelude::*;

/// Slope ratios: α near 0⁻ (r near 0), near 1⁺ (r huge), near ±∞ (r near 1), and ordinary ones.
fn index() -> impl Strategy<Value = Index> {
    let far = 1_000_000_007;
    let ratio = prop_oneof![
        Just(rational(1, 1)),
        Just(rational(1, far)),
        Just(rational(far, 1)),
        Just(rational(far + 1, far)),
        Just(rational(far, far + 1)),
        (1_i64..=9, 1_i64..=9).prop_map(|(p, q)| rational(p, q)),
    ];
    ratio.prop_map(|ratio| Index::from_ratio(ratio).expect("a positive ratio"))
}

/// Few values, so that equal gaps are common, and some that differ by 24 orders of magnitude.
fn gap() -> impl Strategy<Value = BigRational> {
    prop_oneof![
        3 => Just(integer(1)),
        1 => Just(rational(1, 2)),
        1 => Just(rational(7, 3)),
        1 => Just(rational(1, 1_000_000_000_000)),
        1 => Just(integer(1_000_000_000_000_i64)),
    ]
}

/// A degree up to `highest` and knots for it: stop knots of any multiplicity up to k + 3, open or not, and at
/// least as many as the degree needs.
fn knots(highest: usize) -> impl Strategy<Value = (usize, KnotVector)> {
    (0..=highest).prop_flat_map(|k| {
        let start = prop_oneof![Just(integer(0)), Just(rational(-3, 1)), Just(rational(1_000_000_007, 3))];
        let stops = prop::collection::vec((gap(), prop_oneof![3 => 1_usize..=2, 1 => 1..=k + 3]), 2..5);
        (Just(k), start, stops, any::<bool>()).prop_map(|(k, start, mut stops, open)| {
            if open {
                let last = stops.len() - 1;
                (stops[0].1, stops[last].1) = (k + 1, k + 1);
            }
            let count = |stops: &[(BigRational, usize)]| stops.iter().map(|stop| stop.1).sum::<usize>();
            while count(&stops) < 2 * k + 2 {
                stops.insert(1, (integer(1), 1));
            }
            let (mut position, mut knots) = (start, Vec::new());
            for (gap, multiplicity) in stops {
                position += gap;
                knots.extend(std::iter::repeat_n(position.clone(), multiplicity));
            }
            (k, KnotVector::new(knots).expect("rising knots"))
        })
    })
}

fn basis(highest: usize) -> impl Strategy<Value = Basis> {
    (knots(highest), index())
        .prop_map(|((degree, knots), index)| Basis::new(knots, degree, index).expect("knots enough"))
}

/// A place in a span, from its start (0) to its end (1).
fn place() -> impl Strategy<Value = BigRational> {
    prop_oneof![
        Just(integer(0)),
        Just(integer(1)),
        Just(rational(1, 2)),
        Just(rational(1, 1_000_000_007)),
        (1_i64..20).prop_map(|p| rational(p, 20)),
    ]
}

fn at(knots: &KnotVector, span: Span, place: &BigRational) -> BigRational {
    let (start, end) = knots.ends(span).expect("a span of these knots");
    start + (end - start) * place
}

/// All n + 1 functions on a span, with the zeros.
fn all<S: Ring>(basis: &Basis, active: &Active<S>, zero: &S) -> Vec<S> {
    (0..=basis.n()).map(|i| active.get(i).unwrap_or(zero).clone()).collect()
}

fn sum<S: Ring>(active: &Active<S>) -> S {
    let (first, rest) = active.values().split_first().expect("some function lives on every span");
    rest.iter().fold(first.clone(), |sum, g| sum.plus(g))
}

/// The spans of [t_k, t_{n+1}].
fn base_spans(basis: &Basis) -> impl Iterator<Item = Span> {
    basis.knots().spans().filter(|span| (basis.degree()..=basis.n()).contains(&span.index()))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn the_triangle_is_the_definition_at_points(basis in basis(5), place in place()) {
        for span in basis.knots().spans() {
            let x = at(basis.knots(), span, &place);
            let table = by_definition(&basis, span, &x).expect("a span of these knots");
            prop_assert_eq!(&all(&basis, &basis.active(span, &x).expect("a span of these knots"), &x.zero()), &table[basis.degree()]);
        }
    }

    #[test]
    fn the_triangle_is_the_definition_at_jets(basis in basis(3), place in place()) {
        for span in basis.knots().spans() {
            let x = Jet::variable(at(basis.knots(), span, &place), 3);
            let table = by_definition(&basis, span, &x).expect("a span of these knots");
            prop_assert_eq!(&all(&basis, &basis.active(span, &x).expect("a span of these knots"), &x.zero()), &table[basis.degree()]);
        }
    }

    #[test]
    fn the_triangle_is_the_definition_for_every_x(basis in basis(3)) {
        for span in basis.knots().spans() {
            let x = positive_coordinate(basis.knots(), span).expect("a span of these knots");
            let table = by_definition(&basis, span, &x).expect("a span of these knots");
            prop_assert_eq!(&all(&basis, &basis.active(span, &x).expect("a span of these knots"), &x.zero()), &table[basis.degree()]);
        }
    }

    /// D2.3 as printed, α(x − a)/(x + (α − 1)b − αa), and (x − a)/(b − a) for α = ∞.
    #[test]
    fn the_weight_is_the_paper_s(index in index(), start in gap(), length in gap(), place in place()) {
        let (a, b) = (-&start, &length - &start);
        let x = &a + &length * place;
        let (w, complement) = weight(index.ratio(), &x, &a, &b);
        let printed = match index.alpha() {
            Some(alpha) => &alpha * (&x - &a) / (&x + (&alpha - integer(1)) * &b - &alpha * &a),
            None => (&x - &a) / (&b - &a),
        };
        prop_assert_eq!(&w, &printed);
        prop_assert_eq!(complement, integer(1) - printed);
        prop_assert_eq!(weight(index.ratio(), &x, &a, &a), (integer(0), integer(1)));
    }

    /// T3.5.3, with all derivatives of the sum.
    #[test]
    fn the_functions_add_up_to_one(basis in basis(4), place in place()) {
        for span in base_spans(&basis) {
            let x = Jet::variable(at(basis.knots(), span, &place), 2);
            prop_assert_eq!(sum(&basis.active(span, &x).expect("a span of these knots")), x.one());
        }
    }

    /// T3.5.4 on any knots: U mirrored has the mirrored functions of the conjugate index, in reverse order. At a
    /// knot the sides change places.
    #[test]
    fn the_mirror_image_has_the_conjugate_index(basis in basis(4), place in place()) {
        let knots = basis.knots();
        let mirrored = knots.knots().iter().rev().map(|t| knots.mirror(t)).collect();
        let mirrored = KnotVector::new(mirrored).expect("rising knots");
        prop_assert_eq!(knots.is_symmetric(), mirrored == *knots);
        let image = Basis::new(mirrored, basis.degree(), basis.index().conjugate()).expect("as many knots");
        for span in knots.spans() {
            let x = at(knots, span, &place);
            for (side, other) in [(Side::Left, Side::Right), (Side::Right, Side::Left)] {
                // At the two ends of the knot vector a limit from outside is asked for, and t_m is special.
                if x == *knots.first() || x == *knots.last() {
                    continue;
                }
                let mut values = image.values(&knots.mirror(&x), other);
                values.reverse();
                prop_assert_eq!(basis.values(&x, side), values);
            }
        }
    }

    /// T4.1: every level of de Boor's points gives the curve, the last one alone.
    #[test]
    fn de_boor_computes_the_curve(basis in basis(4), place in place(), seed in prop::collection::vec(-9_i64..=9, 2)) {
        let point = |i: usize| -> Point {
            let i = i64::try_from(i).expect("few points");
            vec![rational(i * seed[0] + 1, 2), rational(i * i + seed[1], 1)]
        };
        let curve = Curve::new(basis.clone(), (0..=basis.n()).map(point).collect()).expect("n + 1 points");
        let base: Vec<_> = base_spans(&basis).collect();
        for span in basis.knots().spans() {
            let x = at(basis.knots(), span, &place);
            let (_, end) = basis.knots().ends(span).expect("a span of these knots");
            let side = if x == *end { Side::Left } else { Side::Right };
            let Some(levels) = curve.de_boor(&x, side) else {
                prop_assert!(!base.contains(&span));
                continue;
            };
            let expected = curve.point(&x, side);
            let table = by_definition(&basis, span, &x).expect("a span of these knots");
            for (r, level) in levels.iter().enumerate() {
                let lower = &table[basis.degree() - r];
                let combined: Point = (0..2)
                    .map(|c| level.iter().map(|(i, d)| &d[c] * &lower[i]).sum())
                    .collect();
                prop_assert_eq!(&combined, &expected);
            }
            let last = levels.last().expect("level 0 at least");
            prop_assert_eq!((last.first(), last.values()), (span.index(), std::slice::from_ref(&expected)));
        }
    }

    /// P3.3.2, for every x.
    #[test]
    fn without_interior_knots_the_basis_is_bernstein_s(k in 0_usize..6, index in index(), b in gap()) {
        let a = rational(-1, 3);
        let knots = KnotVector::bernstein(k, &a, &b).expect("a < b");
        let span = knots.spans().next().expect("one span");
        let x = positive_coordinate(&knots, span).expect("a span of these knots");
        let (w, complement) = weight(&x.embed(index.ratio()), &x, &a, &b);
        let basis = Basis::new(knots, k, index).expect("knots enough");
        let expected: Vec<_> = (0..=k).map(|i| bernstein(k, i, (&w, &complement))).collect();
        prop_assert_eq!(basis.active(span, &x).expect("a span of these knots").values().to_vec(), expected);
    }

    /// Values and slopes at both ends of every span, against the whole pieces: u = 0 at the start, and u → ∞ at
    /// the end, t_m included, where the value is the limit from the left.
    #[test]
    fn one_sided_values_are_those_of_the_pieces(basis in basis(3)) {
        for span in Pieces::of(&basis).spans() {
            let (start, end) = span.ends();
            let after = basis.jets(start, Side::Right, 1);
            let before = basis.jets(end, Side::Left, 1);
            for i in 0..=basis.n() {
                let piece = span.function(i);
                let slope = span.derivative(&piece);
                let at_start = [&piece, &slope].map(|f| f.evaluate(&integer(0)).expect("no pole"));
                let at_end = [&piece, &slope].map(|f| f.at_infinity().expect("a finite limit"));
                prop_assert_eq!(after[i].derivatives(), at_start);
                prop_assert_eq!(before[i].derivatives(), at_end);
            }
        }
        let last = basis.knots().last();
        prop_assert_eq!(basis.values(last, Side::Right), basis.values(last, Side::Left));
        let outside = [basis.knots().first() - integer(1), last + integer(1)];
        for x in outside {
            prop_assert!(basis.values(&x, Side::Right).iter().all(Zero::is_zero));
        }
        prop_assert!(basis.values(basis.knots().first(), Side::Left).iter().all(Zero::is_zero));
    }

    /// Partition of unity for any weights whatever, here arbitrary polynomials in one variable.
    #[test]
    fn any_weights_add_up_to_one((k, knots) in knots(4), seed in 1_i64..1_000) {
        let w = |i: usize, d: usize| {
            let mixed = |by: i64| {
                let (i, d) = (i64::try_from(i).expect("small"), i64::try_from(d).expect("small"));
                rational((seed * (3 * i + 7 * d + by)) % 11 - 5, 1 + (seed + by) % 3)
            };
            Polynomial::new(mixed(1), [mixed(2), mixed(5)])
        };
        let weights = FormalWeights::new(&w(0, 1), w);
        for span in knots.spans().filter(|span| (k..knots.m() - k).contains(&span.index())) {
            let total = sum(&triangle(&weights, span, k, knots.m()));
            prop_assert_eq!(&total, &total.one());
        }
    }

    /// T3.5.1 and T3.5.2 between knots, by positivity of the exact value; a support that is a point gives 0.
    #[test]
    fn a_function_is_positive_on_its_support_alone(basis in basis(4), p in 1_i64..20) {
        for span in basis.knots().spans() {
            let x = at(basis.knots(), span, &rational(p, 20));
            for (i, value) in basis.values(&x, Side::Right).iter().enumerate() {
                let (start, end) = basis.support(i);
                prop_assert_eq!(value.is_positive(), *start < x && x < *end);
                prop_assert!(!value.is_negative());
            }
        }
    }

    #[test]
    fn conjugation_is_an_involution(index in index()) {
        let conjugate = index.conjugate();
        prop_assert_eq!(&conjugate.conjugate(), &index);
        prop_assert_eq!(conjugate.alpha(), index.alpha().map(|alpha| integer(1) - alpha));
        prop_assert_eq!(index.to_string().parse::<Index>(), Ok(index));
    }

    #[test]
    fn an_index_is_anything_but_zero_to_one(p in -200_i64..200, q in 1_i64..100) {
        let alpha = rational(p, q);
        let excluded = !alpha.is_negative() && alpha <= integer(1);
        match Index::from_alpha(alpha.clone()) {
            Ok(index) => {
                prop_assert!(!excluded && index.ratio().is_positive());
                prop_assert_eq!(index.ratio() > &integer(1), alpha.is_positive());
                prop_assert_eq!(index.alpha(), Some(alpha));
            }
            Err(error) => prop_assert!(excluded && error == IndexError::Excluded(alpha)),
        }
    }
}

#[test]
fn both_infinities_are_the_classical_index() {
    for text in ["inf", "-inf", "+inf", "Infinity", "∞", "-∞"] {
        assert_eq!(text.parse(), Ok(Index::infinity()), "{text}");
    }
    assert_eq!(Index::infinity().conjugate(), Index::infinity());
    assert_eq!(Index::infinity().alpha(), None);
    assert_eq!(Index::from_ratio(integer(0)), Err(IndexError::Ratio(integer(0))));
    for text in ["0", "1", "1/2", "0.999", "1e-9"] {
        assert!(matches!(text.parse::<Index>(), Err(IndexError::Excluded(_))), "{text}");
    }
}

fn uniform(m: usize, degree: usize, alpha: &str) -> Basis {
    let knots = KnotVector::new((0..=m).map(integer).collect()).expect("rising knots");
    Basis::new(knots, degree, alpha.parse().expect("an index")).expect("knots enough")
}

/// The textbook's uniform B-splines, with their derivatives.
#[test]
fn the_classical_case_is_the_textbook_s() {
    let cubic = uniform(7, 3, "inf");
    let values = cubic.values(&integer(3), Side::Right);
    assert_eq!(values, [rational(1, 6), rational(2, 3), rational(1, 6), integer(0)]);
    let third = |side| cubic.jets(&integer(3), side, 3)[1].derivatives()[3].clone();
    assert_eq!((third(Side::Left), third(Side::Right)), (rational(-3, 1), rational(3, 1)));
    let quadratic = uniform(6, 2, "-inf").values(&rational(5, 2), Side::Right);
    assert_eq!(quadratic[..3], [rational(1, 8), rational(3, 4), rational(1, 8)]);
}

/// α = 2, so r = 2, on the integers: φ(½, 0, 1) = 1/(1 + ½) = 2/3 and φ(½, 0, 2) = 1/(1 + 3/2) = 2/5, and on
/// [0, 1) G_0² is their product.
#[test]
fn a_value_by_hand() {
    let basis = uniform(4, 2, "2");
    assert_eq!(basis.values(&rational(1, 2), Side::Right)[0], rational(4, 15));
}

#[test]
fn degree_zero_is_the_indicator() {
    let basis = uniform(2, 0, "-3");
    let (zero, one) = (integer(0), integer(1));
    assert_eq!(basis.values(&one, Side::Right), [zero.clone(), one.clone()]);
    assert_eq!(basis.values(&one, Side::Left), [one.clone(), zero.clone()]);
    assert_eq!(basis.values(&integer(2), Side::Right), [zero, one]);
}

/// A knot of multiplicity k + 2 leaves a function with an empty support, which is 0, and the sum is still 1.
#[test]
fn a_knot_of_too_high_multiplicity_is_no_trouble() {
    let knots = KnotVector::new([0, 0, 0, 1, 1, 1, 1, 2, 2, 2].map(integer).to_vec()).expect("rising knots");
    let basis = Basis::new(knots, 2, "-1".parse().expect("an index")).expect("knots enough");
    let (zero, one) = (integer(0), integer(1));
    for (side, i) in [(Side::Left, 2), (Side::Right, 4)] {
        let values = basis.values(&one, side);
        let expected: Vec<_> = (0..=6).map(|j| if i == j { one.clone() } else { zero.clone() }).collect();
        assert_eq!(values, expected);
    }
    assert!(Pieces::of(&basis).spans().iter().all(|span| Ring::is_zero(&span.function(3))));
}

#[test]
fn degree_forty_on_a_hundred_knots_runs() {
    let basis = uniform(99, 40, "-1/7");
    let values = basis.values(&rational(201, 4), Side::Right);
    assert_eq!(values.len(), 59);
    assert_eq!(values.iter().sum::<BigRational>(), integer(1));
    assert!(values[10..=50].iter().all(Signed::is_positive));
    assert_eq!(values[..10].iter().chain(&values[51..]).sum::<BigRational>(), integer(0));
}

#[test]
fn the_bernstein_values_at_one_half_are_binomial() {
    let half = rational(1, 2);
    let total = integer(2).pow(7_i32);
    let values: Vec<_> = (0..=8).map(|i| bernstein(7, i, (&half, &half)) * &total).collect();
    assert_eq!(values, [1, 7, 21, 35, 35, 21, 7, 1, 0].map(integer));
}
