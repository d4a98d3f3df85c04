//! The questions that are ours: what is true of them, degree by degree.

use std::fmt::Write as _;

use crate::scalar::{BigRational, rational};

use super::Formal;
use super::basis::SUM_IS_ONE;
use super::place::Place;

const TANGENTS: &str = "(section (window A (- -1 k) (each s 1 k any) some some (each s 1 k any)) (goals \
    (each i (- -1 k) 0 (= (* (DG i k (to A -1)) (DG -1 k (from A 0))) (* (DG -1 k (to A -1)) (DG i k (from A 0))))) \
    (> (* (DG -1 k (to A -1)) (DG -1 k (from A 0))) 0)))";

/// Degree 1: the two functions of a span at two points.
const MINORS_1: &str = "(section (positive s) (window A -1 any some any) (goals \
    (> (det ((G -1 1 (in A 0)) (G 0 1 (in A 0))) ((at ((u (+ u s))) (G -1 1 (in A 0))) (at ((u (+ u s))) (G 0 1 (in A 0))))) 0) \
    (= (G -1 1 (from A 0)) 1) (= (G 0 1 (to A 0)) 1)))";

/// The functions β of degree 2 at the point u, u + s or u + s + p.
fn beta(j: usize, point: usize) -> String {
    let scaled =
        |i: i64, end: Place| format!("(/ {} {})", Place::inside(0).value("G", i, 2), end.value("G", i, 2));
    let (first, last) = (scaled(-2, Place::start(0)), scaled(0, Place::end(0)));
    let function = match j {
        0 => first,
        2 => last,
        _ => format!("(- 1 (+ {first} {last}))"),
    };
    match point {
        0 => function,
        1 => format!("(at ((u (+ u s))) {function})"),
        _ => format!("(at ((u (+ u s p))) {function})"),
    }
}

/// Degree 2: the minors of β_0, β_1, β_2 on a span, and how β comes from G.
fn minors_2() -> String {
    let row = |columns: &[usize], point: usize| {
        let entries: Vec<_> = columns.iter().map(|j| beta(*j, point)).collect();
        format!("({})", entries.join(" "))
    };
    let pairs =
        [[0, 1], [0, 2], [1, 2]].map(|pair| format!("(> (det {} {}) 0)", row(&pair, 0), row(&pair, 1)));
    let all = [0, 1, 2];
    let triple = format!("(> (det {} {} {}) 0)", row(&all, 0), row(&all, 1), row(&all, 2));
    let at_ends = "(> (G -2 2 (from A 0)) 0) (>= (G -1 2 (from A 0)) 0) (= (+ (G -2 2 (from A 0)) (G -1 2 (from A 0))) 1) \
        (> (G 0 2 (to A 0)) 0) (>= (G -1 2 (to A 0)) 0) (= (+ (G -1 2 (to A 0)) (G 0 2 (to A 0))) 1) (= (G 0 2 (from A 0)) 0) (= (G -2 2 (to A 0)) 0)";
    format!(
        "(section (positive s p) (window A -2 any any some any any) (goals (> {} 0) (> {} 0) (> {} 0) {} {triple} {at_ends}))",
        beta(0, 0),
        beta(1, 0),
        beta(2, 0),
        pairs.concat()
    )
}

/// On one span every weight is a quotient of polynomials of degree 1 in u, the denominator with positive coefficients.
pub(super) const LINEAR_FACTORS: &str = "(section (window A (- 0 k) (each s (- 0 k) -1 any) some (each s 1 k any)) (goals (each d 1 k (each i (- 1 d) 0 \
    (= (* (w i d (in A 0)) (+ (* r (- (t A 0) (t A i))) (- (t A (+ i d)) (t A 0)) (* u (+ (* r (- (t A 1) (t A i))) (- (t A (+ i d)) (t A 1)))))) \
    (* r (+ (- (t A 0) (t A i)) (* u (- (t A 1) (t A i)))))) \
    (> (+ (* r (- (t A 0) (t A i))) (- (t A (+ i d)) (t A 0))) 0) (> (+ (* r (- (t A 1) (t A i))) (- (t A (+ i d)) (t A 1))) 0)))))";

/// Knots around one span for which all factors of the denominator are different and none cancels.
const GENERIC: [&[i64]; 6] = [
    &[0, 1],
    &[0, 1, 2, 3],
    &[0, 1, 2, 3, 5, 6],
    &[0, 1, 2, 3, 4, 6, 8, 9],
    &[0, 1, 2, 3, 4, 5, 8, 10, 12, 13],
    &[0, 1, 2, 3, 4, 5, 6, 9, 12, 14, 16, 17],
];

/// For α = −1 and those knots: a pole of one of the functions at the zero of every factor.
fn poles(k: usize) -> String {
    let (knots, ratio) = (GENERIC[k - 1], rational(1, 2));
    let (start, end) = (integer_of(knots[k - 1]), integer_of(knots[k]));
    let place = Place::inside(0);
    let functions: Vec<_> = (0..=k).map(|i| place.value("G", to_i64(i) - to_i64(k), k)).collect();
    let mut goals = String::new();
    for d in 1..=k {
        for a in k - d..k {
            let (a, b) = (integer_of(knots[a]), integer_of(knots[a + d]));
            // The factor is r(start − a) + (b − start) + u·(r(end − a) + (b − end)).
            let constant = &ratio * (&start - &a) + (&b - &start);
            let slope = &ratio * (&end - &a) + (&b - &end);
            let _ = write!(goals, "(pole {place} ({}) {})", functions.join(" "), -constant / slope);
        }
    }
    let list: String = knots.iter().map(|t| format!(" {t}")).collect();
    format!(
        "(section (each a {k} k) (each b k {k}) (let r {ratio}) (knots A {}{list}) (goals {goals}))",
        1 - to_i64(k)
    )
}

fn integer_of(value: i64) -> BigRational {
    rational(value, 1)
}

fn to_i64(value: usize) -> i64 {
    i64::try_from(value).unwrap_or(i64::MAX)
}

const NURBS: &str = "On a span every weight of degree d is a quotient of polynomials of degree 1 in u with coefficients ≥ 0, and that of the denominator has positive coefficients. There are d such weights for each d ≤ k, so that all functions have numerators and a common denominator of degree at most 1 + 2 + … + k, the latter with positive coefficients, which are positive multiples of the Bézier weights. On the knots of the second section, with α = −1, the functions have poles at that many different points, so that in general no lower degree does.";

/// What is proved of a question for all degrees at once.
pub(super) fn formal_for_all(question: &str, amended: bool) -> Option<Formal> {
    let sections: String = (1..=GENERIC.len()).map(poles).collect();
    (question == "X.nurbs" && !amended)
        .then(|| Formal::on_all_knots(1..=GENERIC.len(), NURBS, &[LINEAR_FACTORS, &sections]))
}

/// For a degree: what is proved of the question for every knot vector and every α.
pub(super) fn formal(question: &str, k: usize) -> Option<Formal> {
    let statement = |because: &str, sections: &[&str]| Some(Formal::on_all_knots(k..=k, because, sections));
    const BLOCKS_1: &str = "On a span, the two functions that live there have positive minors of order 2 at any two points, and at its ends one of them is 1. So a collocation matrix is a chain of blocks with two columns, of which two that follow each other have one column in common or none; by Laplace expansion along the rows of a block a minor is a product of minors of blocks, or 0.";
    const BLOCKS_2: &str = "On a span let b_j and b_{j+1} be the points of the curve at its ends: b_j = G_{j−2}(t_j)·d_{j−2} + G_{j−1}(t_j)·d_{j−1} and b_{j+1} likewise, convex combinations of neighbours; in terms of b_j, d_{j−1}, b_{j+1} the curve has the factors β_0 = G_{j−2}/G_{j−2}(t_j), β_2 = G_j/G_j(t_{j+1}) and β_1 = 1 − β_0 − β_2. These are positive, and all their minors of order 2 and 3 at increasing points are. At the ends only one of them is not 0. So the collocation matrix is a product: a chain of blocks with three columns, of which two that follow each other share the column of a b (by Laplace expansion its minors are products of minors of blocks, or 0), times the matrix that makes the b and d from the d, in which a row b_j has two neighbouring entries ≥ 0, a row d_i the entry 1, and two rows b that follow each other are one column apart at a simple knot, while at a double knot b is one of the d (so its minors are ≥ 0 likewise). By the formula of Cauchy and Binet all minors of the product are ≥ 0. At a knot of multiplicity ≥ 3 the matrix falls apart in two.";
    const VARIATION: &str = "A totally non-negative matrix does not increase the number of sign changes (Schoenberg, 1930), and the functions have the sum 1, so that this holds for the c_i less a small ε, and plus one, as well: the crossings of the line and, twice each, the points where the curve touches it from one side are no more than those of the polygon. If two consecutive control points lie on the line, the polygon meets it infinitely often. A function that is 0 everywhere is left out with its control point. Total positivity: ";
    match (question, k) {
        ("X.G1", 2) => statement(
            "The index −1 stands for the function with its second knot at the simple knot t_0. The two one-sided derivatives of every function are proportional to those of G_{−1}, whose product is positive: so the derivatives of every curve from the two sides are positive multiples of each other.",
            &[TANGENTS],
        ),
        ("X.totalpositivity", 1) => statement(BLOCKS_1, &[MINORS_1]),
        ("X.totalpositivity", 2) => statement(BLOCKS_2, &[&minors_2(), SUM_IS_ONE]),
        ("X.variation", 1) => statement(&(VARIATION.to_owned() + BLOCKS_1), &[MINORS_1, SUM_IS_ONE]),
        ("X.variation", 2) => statement(&(VARIATION.to_owned() + BLOCKS_2), &[&minors_2(), SUM_IS_ONE]),
        ("X.nurbs", 1..=6) => statement(NURBS, &[LINEAR_FACTORS, &poles(k)]),
        _ => None,
    }
}
