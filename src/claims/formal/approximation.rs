//! Approximation order, degree elevation, condition number; and what holds for free weights.

use std::fmt::Write as _;
use std::ops::RangeInclusive;

use crate::claims::approximation::chebyshev;
use crate::scalar::{BigRational, Polynomial, Ring, rational};

use super::Formal;
use super::place::Place;
use super::questions::LINEAR_FACTORS;

/// The denominator of a weight at u = −1, which is x = ∞.
const NO_POLE: &str = "(section (window A (- 0 k) (each s (- 0 k) -1 any) some (each s 1 k any)) (goals (each d 1 k (each i (- 1 d) 0 \
    (= (- (+ (* r (- (t A 0) (t A i))) (- (t A (+ i d)) (t A 0))) (+ (* r (- (t A 1) (t A i))) (- (t A (+ i d)) (t A 1)))) \
    (* (- 1 r) (A 0)))))))";

const ORDER_ONE: &str = "On the span j = 0, x = (t_0 + u·t_1)/(1 + u) has a pole at u = −1. Every weight is a quotient N/D of polynomials of degree 1 in u (first section), where D = D_0 + u·D_1, and D(−1) = D_0 − D_1 = (1 − r)(t_1 − t_0) (second section) is not 0 for α ≠ ∞. So no function of the span, a sum of products of weights, and no combination of them has a pole there, and x is none of them. These combinations are a space of finite dimension, from which a function outside of it has a positive distance c on the span. With all knots times h, the weights at h·x are those at x: so the distance of h·x is h times that of x, c·h.";

const ELEVATION: &str = "B has the knots of A once more, so far as they matter for the span j = 0. The two functions of degree 1 that live on the span have there the factors 1, 1/2, 0 and 0, 1/2, 1 of the three functions of degree 2. The function of degree 2 with the factor 1 is that which is 1 at the double knot between two spans; it has the factor 1 on both of them.";

const CONDITION: &str = "c_i is the value, or the limit from one side, of Σ c_i G_i at t_{i+1}: for t_i < t_{i+1} the limit from the left is that of G_i, the last function that lives on its span, and for t_{i+1} < t_{i+2} the limit from the right is that of the first one.";

/// 1 − T_k(y)² = (1 − y²)·U_{k−1}(y)² for y = 2w − 1, with the weight w of the only interval and Σ c_i·G_i = T_k(y), where c has
/// the k + 1 coefficients of Chebyshev's polynomial.
pub(super) fn chebyshev_identity(c: &[BigRational]) -> String {
    let k = c.len() - 1;
    let place = Place::inside(k);
    let (w, v) = (place.value("w", k, 1), place.value("v", k, 1));
    let f: String =
        c.iter().enumerate().map(|(i, c)| format!(" (* {c} {})", place.value("G", i, k))).collect();
    let terms = second_kind(k - 1).coefficients().to_vec();
    let other: String =
        terms.iter().enumerate().map(|(j, c)| format!(" (* {c} (^ (- {w} {v}) {j}))")).collect();
    format!("(= (- 1 (^ (+{f}) 2)) (* 4 {w} {v} (^ (+{other}) 2)))")
}

/// Chebyshev's polynomial of the second kind: U_0 = 1, U_1 = 2y, U_n = 2y·U_{n−1} − U_{n−2}.
fn second_kind(n: usize) -> Polynomial<BigRational> {
    let constant = |value| Polynomial::constant(rational(value, 1));
    let twice = Polynomial::variable(&rational(1, 1)).times(&constant(2));
    let (mut before, mut last) = (constant(0), constant(1));
    for _ in 0..n {
        let next = twice.times(&last).minus(&before);
        (before, last) = (last, next);
    }
    last
}

/// Without interior knots, for one degree.
fn bernstein(k: usize) -> String {
    let place = Place::inside(k);
    let (w, v) = (place.value("w", k, 1), place.value("v", k, 1));
    let mut goals = chebyshev_identity(&chebyshev(k));
    for i in 0..=k {
        let g = place.value("G", i, k);
        let _ = write!(goals, "(= {g} (* (integer (binomial k {i})) (^ {w} {i}) (^ {v} {})))", k - i);
    }
    format!(
        "(section (each a {k} k) (each b k {k}) (positive h) (window A 0 (each z 1 k 0) h (each z 1 k 0)) (goals {goals}))"
    )
}

const WITHOUT_KNOTS: &str = "Every function is C(k, i)·w^i·(1 − w)^(k−i) for the weight w of the whole interval, which takes every value between 0 and 1 and no other, for every α: so Σ c_i·G_i has the coefficients c and the same largest value for every α. The first equation: for the coefficients of Chebyshev's polynomial f² is at most 1, so that the condition number is at least as large as any of them.";

/// The degrees for which that is proved.
const BERNSTEIN: RangeInclusive<usize> = 1..=8;

/// From the functions of degree d − 1 on a span, (g i), to those of degree d, with a ratio (rho i) for each weight.
const FREE: &str = "(section (each d 1 k) (positive (each i (- 1 d) 0 (g i) (rho i))) \
    (window A (- 0 k) (each s (- 0 k) -1 any) some (each s 1 k any)) (goals \
    (= (+ (each i (- 1 d) 0 (* (at ((r (rho i))) (w i d (in A 0))) (g i)) (* (at ((r (rho i))) (v i d (in A 0))) (g i)))) \
    (+ (each i (- 1 d) 0 (g i)))) \
    (> (* (at ((r (rho 0))) (w 0 d (in A 0))) (g 0)) 0) \
    (> (* (at ((r (rho (- 1 d)))) (v (- 1 d) d (in A 0))) (g (- 1 d))) 0) \
    (each i (- 1 d) -1 (> (+ (* (at ((r (rho i))) (w i d (in A 0))) (g i)) (* (at ((r (rho (+ i 1)))) (v (+ i 1) d (in A 0))) (g (+ i 1)))) 0))))";

const FREE_BECAUSE: &str = "On the span j = 0. By the recursion a function of degree d is w_i·G_i + (1 − w_{i+1})·G_{i+1}, with functions of degree d − 1 that are unknowns here, (g i), and positive; each weight has a ratio (rho i) of its own, which is that of any index. The sum over i of these has every w_i·G_i and (1 − w_i)·G_i once, so that it is the sum of the functions of degree d − 1 (the first goal); they are positive (the others). By induction from G_0^0 = 1 the k + 1 functions of degree k are positive with sum 1. Outside of their supports all functions are 0 whatever the weights, and hulls follow.";

/// What is proved for all degrees at once.
pub(super) fn formal_for_all(question: &str, amended: bool) -> Option<Formal> {
    match (question, amended) {
        ("X.condition", true) => {
            let sections: String = BERNSTEIN.map(bernstein).collect();
            Some(Formal::on_all_knots(BERNSTEIN, WITHOUT_KNOTS, &[&sections]))
        }
        ("X.approximation", false) => {
            Some(Formal::on_all_knots(1..=8, ORDER_ONE, &[LINEAR_FACTORS, NO_POLE]))
        }
        ("X.weights", false) => Some(Formal::on_all_knots(1..=8, FREE_BECAUSE, &[FREE])),
        _ => None,
    }
}

/// What is proved for one degree.
pub(super) fn formal(question: &str, k: usize) -> Option<Formal> {
    match (question, k) {
        ("X.approximation", 1..=8) => {
            Some(Formal::on_all_knots(k..=k, ORDER_ONE, &[LINEAR_FACTORS, NO_POLE]))
        }
        ("X.weights", 1..=8) => Some(Formal::on_all_knots(k..=k, FREE_BECAUSE, &[FREE])),
        ("X.elevation", 1) => Some(Formal::on_all_knots(
            1..=1,
            ELEVATION,
            &["(section (window A -1 any some any) (window B -1 0 (A 0) 0) (goals \
               (= (G -1 1 (in A 0)) (+ (G -2 2 (in B 0)) (* 1/2 (G -1 2 (in B 0))))) \
               (= (G 0 1 (in A 0)) (+ (* 1/2 (G -1 2 (in B 0))) (G 0 2 (in B 0))))))"],
        )),
        ("X.condition", 1) => Some(Formal::on_all_knots(
            1..=1,
            CONDITION,
            &[
                "(section (window A -1 any some any) (goals (= (G -1 1 (from A 0)) 1) (= (G 0 1 (from A 0)) 0) \
               (= (G 0 1 (to A 0)) 1) (= (G -1 1 (to A 0)) 0)))",
            ],
        )),
        _ => None,
    }
}
