//! The questions that are ours: what is true of them, degree by degree.

use std::fmt::Write as _;
use std::ops::RangeInclusive;

use crate::scalar::{BigRational, rational};

use super::Formal;
use super::basis::{ORDERS, SUM_IS_ONE};
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
    let statement = |degrees: RangeInclusive<usize>, because: &str, sections: &[&str]| {
        Some(Formal::on_all_knots(degrees, because, sections))
    };
    match (question, amended) {
        ("X.nurbs", false) => {
            let sections: String = (1..=GENERIC.len()).map(poles).collect();
            statement(1..=GENERIC.len(), NURBS, &[LINEAR_FACTORS, &sections])
        }
        ("X.G1", true) => statement(2..=8, EXACTLY_CONTINUOUS, &[COALESCED, NOT_PARALLEL, JUMP_AND_SLOPES]),
        ("X.linear", true) => statement(
            1..=8,
            "In the equation the factor of x on the left side is r − 1, which is not 0 for finite α: so each weight of a span, as a quotient of polynomials in x, tends to r/(r − 1) as x → ∞, and a function that lives on the span, which is a sum of products of weights and of 1 minus weights, has a finite limit as well. So has every combination of them; but x, x², …, x^k have none.",
            &[BOUNDED],
        ),
        ("X.nested", true) => statement(1..=8, EXACTLY_NESTED, &[NOT_NESTED, ORDERS, SPLIT_IN_TWO]),
        ("X.derivative", true) => statement(
            1..=8,
            "A has the knots of degree k, B those of degree k − 1, on the same interval; w is the weight of the whole interval, and functions that do not exist are 0.",
            &[
                "(section (positive h) (window A 0 (each s 1 k 0) h (each s 1 k 0)) (window B 0 (each s 2 k 0) h (each s 2 k 0)) (goals \
                 (each i 0 k (= (DG i k (in A k)) (* (integer k) (Dw k 1 (in A k)) (- (G (- i 1) (- k 1) (in B (- k 1))) (G i (- k 1) (in B (- k 1)))))))))",
            ],
        ),
        _ => None,
    }
}

/// Every weight of a span is r(x − a)/((r − 1)(x − a) + b − a).
const BOUNDED: &str = "(section (window A (- 0 k) (each s (- 0 k) -1 any) some (each s 1 k any)) (goals (each d 1 k (each i (- 1 d) 0 \
    (= (* (w i d (in A 0)) (+ (* (- r 1) (- (x (in A 0)) (t A i))) (- (t A (+ i d)) (t A i)))) \
    (* r (- (x (in A 0)) (t A i))))))))";

/// The k − 1 knots next to the simple knot t_0 are one on either side.
const COALESCED: &str = "(section (window A (- -1 k) any any (each s 3 k 0) some some (each s 3 k 0) any any) (goals \
    (each i (- -1 k) 0 (= (* (DG i k (to A -1)) (DG -1 k (from A 0))) (* (DG -1 k (to A -1)) (DG i k (from A 0))))) \
    (> (* (DG -1 k (to A -1)) (DG -1 k (from A 0))) 0)))";

/// With h and g for the gaps beside the knot, and h + z and g + y for the distances of further knots: the terms of the
/// sum, which are 0 for y = z = 0 only, and how they and the determinant come about.
const NOT_PARALLEL: &str = "(section (positive h g y) (nonnegative z) (goals (> (/ (+ g y) (+ (* r h) g y)) (/ g (+ (* r (+ h z)) g)))))\
    (section (positive h g z) (nonnegative y) (goals (> (/ (+ g y) (+ (* r h) g y)) (/ g (+ (* r (+ h z)) g)))))\
    (section (positive h g) (goals (= (/ g (+ (* r h) g)) (/ g (+ (* r h) g)))))\
    (section (positive h g) (nonnegative y z) (goals \
    (= (- (/ (* r (+ h g y)) (+ (* r h) g y)) (/ (* r (+ h z g)) (+ (* r (+ h z)) g))) \
    (* (- r 1) (- (/ (+ g y) (+ (* r h) g y)) (/ g (+ (* r (+ h z)) g)))))))\
    (section (real c p q e f) (goals (= (- (* p (- c f) q (+ c e)) (* q e (* -1 p f))) (* p q c (+ (- e f) c)))))";

/// At the simple knot t_0: what is right of it of the derivative of the function that has it as its last knot but one, and what is left of it
/// of that which has it as its second knot; and the jumps of both.
const JUMP_AND_SLOPES: &str = "(section (window A (- -1 k) (each s 1 k any) some some (each s 1 k any)) (goals \
    (= (DG -1 k (to A -1)) (* (each d 3 k (w -1 d (from A 0))) (/ r (+ (* r (A -1)) (A 0))) \
    (+ (each i 0 (- k 1) (/ (+ (A -1) (- (t A i) (t A 0))) (+ (* r (A -1)) (- (t A i) (t A 0)))))))) \
    (= (DG (- 0 k) k (from A 0)) (* -1 (each d 3 k (v (- 1 d) d (from A 0))) (/ r (+ (* r (A -1)) (A 0))) \
    (+ (each i 0 (- k 1) (/ (+ (A 0) (- (t A 0) (t A (- 0 i)))) (+ (* r (- (t A 0) (t A (- 0 i)))) (A 0))))))) \
    (= (- (DG -1 k (from A 0)) (DG -1 k (to A -1))) (* (/ (- r 1) (+ (* r (A -1)) (A 0))) (each d 3 k (w -1 d (from A 0))))) \
    (= (- (DG (- 0 k) k (from A 0)) (DG (- 0 k) k (to A -1))) (* (/ (- 1 r) (+ (* r (A -1)) (A 0))) (each d 3 k (v (- 1 d) d (from A 0))))) \
    (each d 3 k (> (w -1 d (from A 0)) 0) (> (v (- 1 d) d (from A 0)) 0))))";

const EXACTLY_CONTINUOUS: &str = "The knot is t_0, with the gaps h before and g after it. First section: if the k − 1 knots next to it are one on either side, the two one-sided derivatives of every function are proportional to those of G_{−1}, whose product is positive; so the derivatives of every curve from the two sides are positive multiples of each other. Otherwise take the functions G_{−1}, whose second knot is t_0, and G_{−k}, whose last knot but one it is. By the last section, with the positive products P and Q of weights, c = (r − 1)/(rh + g) and sums E and F times r/(rh + g): the derivatives of G_{−1} are QE from the left and Q(E + c) from the right, those of G_{−k} P(c − F) and −PF. Their determinant is PQc(E − F + c) (section before). The terms of E − F for i = 0 are r(1/r − 1)/(rh + g) = −c; those for i = 1, …, k − 1 are, with y and z for the distances of t_i from t_1 and of t_{−i} from t_{−1}, by the section before that, (r − 1)/(rh + g) times a difference that is 0 for y = z = 0 and else positive. So the determinant is PQc² times a positive number: not 0 for finite α, and the derivatives of a curve for which the two control points are (1, 0) and (0, 1) and all others 0 are not parallel.";

/// On its first span, of which t_1 is the end and where the new knot goes: p copies of the latter are there already, which
/// makes it t_1 if p > 0.
const NOT_NESTED: &str = "(section (each p 1 (- k 1)) (window A 0 some (each s 2 p 0) some (each s (+ p 1) k any)) \
    (window B 0 (A 0) (each s 1 p 0) (A p) (each s (+ p 1) k (A s))) (goals \
    (= (* (G 0 k (in A 0)) (w 0 1 (in B 0))) (* (G 0 k (in B 0)) (w 0 k (in A 0)))) (= (t B 1) (t A 1)) (> (t A k) (t B 1)) \
    (= (x (in A 0)) (x (in B 0)))))\
    (section (positive h g) (window A 0 (+ h g) (each s 1 k any)) (window B 0 h g (each s 1 k (A s))) (goals \
    (= (* (at ((u (/ (* u h) (+ h g (* g u))))) (G 0 k (in A 0))) (w 0 1 (in B 0))) \
    (* (G 0 k (in B 0)) (at ((u (/ (* u h) (+ h g (* g u))))) (w 0 k (in A 0))))) (> (t A k) (t B 1)) \
    (= (at ((u (/ (* u h) (+ h g (* g u))))) (x (in A 0))) (x (in B 0)))))";

/// The function with k inner knots that are one, for A, and the two that it becomes with one more copy, for B.
const SPLIT_IN_TWO: &str = "(section (window A 0 some (each s 2 k 0) some) (window B 0 (A 0) (each s 1 k 0) (A k)) (goals \
    (= (G 0 k (in A 0)) (G 0 k (in B 0))) (= (G 0 k (from A 0)) (G 0 k (from B 0))) \
    (= (G 0 k (in A k)) (G 1 k (in B (+ k 1)))) (= (G 0 k (from A k)) (G 1 k (from B (+ k 1)))) (= (G 0 k (to A k)) (G 1 k (to B (+ k 1))))))";

const EXACTLY_NESTED: &str = "U is open, and the new knot t, of multiplicity p in U. If p < k, it lies inside (t_0, t_m). Index 0 stands for that of the last knot of U before t, so that t lies in [t_0, t_1], and G_0 exists for U. A has the knots of U, B those with t. On the part of the first span up to t the two functions G_0 are products of the weights of the intervals from t_0 to the next k knots; the goals of the first two sections say that for A it is that for B times w_0^k of A over the weight of [t_0, t]. The two have their poles at different places, since t_k > t and r ≠ 1; so the functions are no multiples of each other. Now let G_0 of A be a combination Σ c_i G_i of functions of B. It is 0 before t_0: go through the spans from left to right; the functions that begin at one knot have different orders there (third kind of section: k + 1 − q, with q copies of the knot from the first of the function on), so that all that begin before t_0 have c_i = 0, or are 0. G_0 of A has the order k at t_0, and of the functions that begin there only G_0 of B has it, the others lower ones: so their c_i are 0 too, and G_0 of A is a multiple of G_0 of B up to t, which it is not. If p > k, every function has its knots one after the other in the refined vector too. If p = k, one function has not: that with the k copies inside; it is the sum of the two into which it falls (last section), each of which is 0 on the other's span.";

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
