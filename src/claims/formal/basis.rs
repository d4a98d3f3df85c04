//! Section 3: support, positivity, partition of unity, symmetry, continuity, independence; the Bernstein case.

use std::ops::RangeInclusive;

use super::Formal;

/// One span, 0, with k knots to each side at any distance ≥ 0: all knots on which the functions there depend.
pub(super) const SPAN: &str = "(window A (- 0 k) (each s (- 0 k) -1 any) some (each s 1 k any))";

/// On its span only G_{−k}, …, G_0 live.
pub(super) const OFF_SUPPORT: &str = "(section (window A (- 0 k) (each s (- 0 k) -1 any) some (each s 1 k any)) (goals \
    (each i (- (- 0 k) 3) (- (- 0 k) 1) (= (G i k (in A 0)) 0) (= (G i k (from A 0)) 0)) \
    (each i 1 3 (= (G i k (in A 0)) 0) (= (G i k (from A 0)) 0))))";

/// The value at the first knot of G_0, which occurs q times from t_0 on.
pub(super) const AT_FIRST_KNOT: &str = "(section (each q 1 k) (window A (- 0 k) (each s (- 0 k) -1 any) (each s 0 (- q 2) 0) some \
    (each s q (+ q k) any)) (goals (= (G 0 k (from A (- q 1))) 0)))\
    (section (window A (- 0 k) (each s (- 0 k) -1 any) (each s 1 k 0) some (each s 1 k any)) (goals \
    (= (G 0 k (from A k)) 1)))";

/// The limit at the last knot of G_0, which occurs q times up to t_{k+1}.
pub(super) const AT_LAST_KNOT: &str = "(section (each q 1 k) (window A (- 0 (+ k q)) (each s (- 0 (+ k q)) (- k q) any) some \
    (each s (- (+ k 2) q) k 0) (each s (+ k 1) (+ k k) any)) (goals (= (G 0 k (to A (- (+ k 1) q))) 0)))\
    (section (window A (- 0 k) (each s (- 0 k) -1 any) some (each s 1 k 0) (each s 1 k any)) (goals \
    (= (G 0 k (to A 0)) 1)))";

pub(super) const POSITIVE_INSIDE: &str = "(section (window A (- 0 k) (each s (- 0 k) -1 any) some (each s 1 k any)) (goals \
    (each i (- 0 k) 0 (> (G i k (in A 0)) 0))))";

/// At a knot t_0 of multiplicity q inside of the support.
pub(super) const POSITIVE_AT_KNOTS: &str = "(section (each q 1 k) (window A (- 0 k) (each s (- 0 k) (- -1 q) any) some (each s (- 1 q) -1 0) some \
    (each s 1 k any)) (goals (each i (- 0 k) (- 0 q) (> (G i k (from A 0)) 0))))";

pub(super) const SUM_IS_ONE: &str = "(section (window A (- 0 k) (each s (- 0 k) -1 any) some (each s 1 k any)) (goals \
    (= (+ (each i (- 0 k) 0 (G i k (in A 0)))) 1) (= (+ (each i (- 0 k) 0 (G i k (from A 0)))) 1) \
    (= (+ (each i (- 0 k) 0 (G i k (to A 0)))) 1)))";

/// The limits from both sides at t_0 = … = t_{p−1}, p ≤ k.
pub(super) const CONTINUITY: &str = "(section (each p 1 k) (window A (- -1 k) (each s 1 k any) some (each s 1 (- p 1) 0) some \
    (each s 1 k any)) (goals (each i (- -1 k) (- p 1) (= (G i k (to A -1)) (G i k (from A (- p 1)))))))";

pub(super) const MIRRORED: &str = "(section (window A (- 0 k) (each s (- 0 k) -1 any) some (each s 1 k any)) \
    (window B (- 0 k) (each s (- 0 k) k (A (- 0 s)))) (goals (each i (- 0 k) 0 \
    (= (at ((u (/ 1 u))) (G i k (in A 0))) (at ((r (/ 1 r))) (G (- (- 0 i) k) k (in B 0)))) \
    (= (G i k (from A 0)) (at ((r (/ 1 r))) (G (- (- 0 i) k) k (to B 0)))))))";

/// At a knot of multiplicity > k: G_{−k} begins there with the value 1.
pub(super) const STARTS_WITH_A_JUMP: &str = "(section (window A (- 0 k) (each s 1 k 0) some (each s 1 k any)) (goals \
    (= (G (- 0 k) k (from A 0)) 1)))";

/// Its mirror image, G_0 of B, ends at t_1 = … = t_{k+1} and is 0 from there on.
pub(super) const IS_OVER: &str =
    "(section (window B 0 some (each s 1 k 0) some (each s 1 k any)) (goals (= (G 0 k (from B (+ k 1))) 0)))";

/// The order at t_0 of G_0, whose first knot occurs q times from t_0 on.
pub(super) const ORDERS: &str = "(section (each q 1 (+ k 1)) (window A (- 0 k) (each s (- 0 k) -1 any) (each s 0 (- q 2) 0) some \
    (each s q (+ q k) any)) (goals (order 0 k (in A (- q 1)) (- (+ k 1) q))))";

const DEFINED: &str = "(section (window A (- 0 k) (each s (- 0 k) -1 any) some (each s 1 k any)) (goals (each i (- 0 k) 0 \
    (defined (G i k (in A 0))) (defined (G i k (from A 0))) (defined (G i k (to A 0))))))";

/// t_0 = … = t_k < t_{k+1}, and the mirror image.
pub(super) const ENDS: &str = "(section (window A 0 (each s 1 k 0) some (each s 1 k any)) (goals (= (G 0 k (from A k)) 1) \
    (each i 1 k (= (G i k (from A k)) 0))))\
    (section (window A (- 0 k) (each s 1 k any) some (each s 1 k 0)) (goals (= (G 0 k (to A 0)) 1) \
    (each i (- 0 k) -1 (= (G i k (to A 0)) 0))))";

pub(super) const LIVING: &str = "By D3.3 a function is 0 on a span [t_j, t_{j+1}) unless j−k ≤ i ≤ j, and there it depends on t_{j−k+1}, …, t_{j+k} only; so one span with all the knots around it, at any distance ≥ 0, stands for every span of every knot vector. Near the ends of a vector, think of it as continued by any knots: a function that exists does not depend on them.";

pub(super) fn formal(claim: &str, amended: bool) -> Option<Formal> {
    let statement = |degrees: RangeInclusive<usize>, because: &str, sections: &[&str]| {
        Some(Formal::on_all_knots(degrees, &because.replace("LIVING", LIVING), sections))
    };
    match (claim, amended) {
        ("T3.5.1", true) => statement(
            0..=8,
            "LIVING So it is 0 left of t_i, from t_{i+k+1} on, and, outside of [t_0, t_m), by definition. At x = t_i, if that knot occurs q ≤ k times from t_i on, it is 0, and if k + 1 times, 1. At x = t_m the limit from the left counts: it is 0 if t_m occurs q ≤ k times among the knots of the function, and 1 if k + 1 times.",
            &[OFF_SUPPORT, AT_FIRST_KNOT, AT_LAST_KNOT],
        ),
        ("T3.5.2", false) => statement(
            0..=8,
            "LIVING Between the knots all of them are positive. A knot x inside of the support, t_i < x < t_{i+k+1}, has a multiplicity q ≤ k, for only k knots of the function can lie there; with x = t_0 the last of its copies, t_i < x says i ≤ −q, and x < t_{i+k+1} says i ≥ −k.",
            &[POSITIVE_INSIDE, POSITIVE_AT_KNOTS],
        ),
        ("T3.5.3", true) => statement(
            0..=8,
            "LIVING The sum of all k + 1 of them is 1. On a span k ≤ j ≤ n all exist. On any other span some i < 0 or i > n is among them: that function, which does not exist, would be positive, so that the sum of the others is less than 1.",
            &[SUM_IS_ONE, POSITIVE_INSIDE],
        ),
        ("T3.5.4", true) => statement(
            0..=8,
            "LIVING B is A in reverse. The reflection takes the span to the mirrored one, the coordinate u to 1/u, G_i to G_{n−i}, and to pass from α to 1 − α is to pass from r to 1/r. At a knot of multiplicity ≤ k the functions are continuous, at t_0 and t_m the limits count, so the equality holds at the knots too. At a knot inside of multiplicity > k some function is 1 from there on, while its mirror image is 0 there and beyond.",
            &[MIRRORED, CONTINUITY, STARTS_WITH_A_JUMP, IS_OVER],
        ),
        ("P4.3", true) => statement(
            0..=8,
            "LIVING B is A in reverse. The reflection takes the span to the mirrored one, the coordinate u to 1/u, G_i to G_{n−i}, and to pass from α to 1 − α is to pass from r to 1/r. At a knot of multiplicity ≤ k the functions are continuous, at t_0 and t_m the limits count, so the equality holds at the knots too. At a knot inside of multiplicity > k some function is 1 from there on, while its mirror image is 0 there and beyond. For curves on an open U: the sum of the functions is 1 on [t_0, t_m], so that the reflection, an affine map, takes Σ d_i G_i to Σ d_{n−i} G_i. Where a function differs from its mirror image, so do the curves for some symmetric polygon on a line.",
            &[MIRRORED, CONTINUITY, STARTS_WITH_A_JUMP, IS_OVER, SUM_IS_ONE],
        ),
        ("L3.6", false) => statement(
            1..=8,
            "The first knot occurs k + 1 + e times. For e = 0, 1, 2 the equations are shown; for e ≥ 3 all functions in them are 0 on the first span, which is [t_{k+e}, t_{k+e+1}).",
            &[
                "(section (each e 0 2) (each q 0 (- k 1)) (window A 0 (each s 1 (+ k e) 0) some (each s 1 k any)) (goals \
               (= (G q (- k q) (from A (+ k e))) (G (+ q 1) (- (- k q) 1) (from A (+ k e)))) \
               (= (G (+ q 1) (- k q) (from A (+ k e))) (G (+ q 2) (- (- k q) 1) (from A (+ k e))))))",
            ],
        ),
        ("L3.7", false) => statement(
            1..=8,
            "Index 0 stands for n. The last knot occurs k + 1 + e times. For e = 0, 1, 2 the equations are shown; for e ≥ 3 all functions in them are 0 on the last span, which is [t_{n−e}, t_{n−e+1}).",
            &[
                "(section (each e 0 2) (each q 0 (- k 1)) (window A (- 0 (+ k e)) (each s 1 k any) some (each s 1 (+ k e) 0)) (goals \
               (= (G 0 (- k q) (to A (- 0 e))) (G 0 (- (- k q) 1) (to A (- 0 e)))) \
               (= (G -1 (- k q) (to A (- 0 e))) (G -1 (- (- k q) 1) (to A (- 0 e))))))",
            ],
        ),
        ("P3.1.1", false) => statement(
            0..=8,
            "LIVING There every function is a sum of products of weights, each of which is a quotient of polynomials whose denominator does not vanish on the closed span.",
            &[DEFINED],
        ),
        ("P3.1.2", false) => statement(
            1..=8,
            "LIVING At a knot of multiplicity p ≤ k inside (t_0, t_m) both limits are the same for all functions. A knot of multiplicity > k inside (t_0, t_m) would have a copy among the interior ones, since 1 ≤ i ≤ k and m−k ≤ i ≤ m−1 are only k indices each and t_k < t_{m−k}. At t_0 the limit from the right is the value.",
            &[CONTINUITY],
        ),
        ("P3.1.3", true) | ("P4.2.1", true) => statement(
            0..=8,
            "t_0 = … = t_k < t_{k+1}, and in the second section, with index 0 for n, t_n < t_{n+1} = … = t_m. Functions that do not live on the first (last) span are 0 there.",
            &[ENDS],
        ),
        ("P3.2", false) => statement(
            0..=8,
            "Let Σ c_i G_i = 0. Go through the spans from left to right, and let t_i be the first knot of a span, with q copies from t_i on: 1 ≤ q ≤ k, or up to k + 1 at t_0, by the hypotheses. The functions that live on the span and began earlier have c = 0 already. Those that begin at this knot have, as functions of u at its first knot, the orders k + 1 − q for the different q: these differ, so that the c of the lowest order is 0, then the next one.",
            &[ORDERS],
        ),
        ("proof.P3.2.induction", true) => statement(
            0..=8,
            "Index 0 stands for i, and t_0 = … = t_{q−1} < t_q: G_0 begins at t_0, with q of its knots there, and its order at that place is k + 1 − q. For the different functions that begin at one knot q is different, 1 ≤ q ≤ k + 1, and so are the orders. Let Σ c_i G_i be 0 up to the end of the span, with c_i = 0 for those that began earlier: of those that begin here, the c of the lowest order is 0, then that of the next one.",
            &[ORDERS],
        ),
        ("P3.3.1", true) => statement(
            1..=8,
            "A has the knots of degree k, B those of degree k − 1, on the same interval; w is the weight of the whole interval, and functions that do not exist are 0.",
            &[
                "(section (positive h) (window A 0 (each s 1 k 0) h (each s 1 k 0)) (window B 0 (each s 2 k 0) h (each s 2 k 0)) (goals \
               (each i 0 k (= (G i k (in A k)) (+ (* (w k 1 (in A k)) (G (- i 1) (- k 1) (in B (- k 1)))) \
               (* (v k 1 (in A k)) (G i (- k 1) (in B (- k 1)))))) (= (G i k (from A k)) (+ (* (w k 1 (from A k)) \
               (G (- i 1) (- k 1) (from B (- k 1)))) (* (v k 1 (from A k)) (G i (- k 1) (from B (- k 1)))))))))",
            ],
        ),
        ("P3.3.2", true) => statement(
            0..=8,
            "All weights are that of the whole interval.",
            &["(section (positive h) (window A 0 (each s 1 k 0) h (each s 1 k 0)) (goals (each i 0 k \
               (= (G i k (in A k)) (* (integer (binomial k i)) (^ (w k 1 (in A k)) i) (^ (v k 1 (in A k)) (- k i)))) \
               (= (G i k (from A k)) (* (integer (binomial k i)) (^ (w k 1 (from A k)) i) (^ (v k 1 (from A k)) (- k i)))))))"],
        ),
        ("abstract.approx", false) => statement(
            0..=8,
            "LIVING On [t_0, t_m] of an open U all k + 1 of them exist; they are positive with sum 1, at the knots as limits. So |f(x) − Σ f(ξ_i) G_i(x)| ≤ Σ |f(x) − f(ξ_i)| G_i(x), where x and ξ_i lie in [t_i, t_{i+k+1}], which is the union of k + 1 gaps.",
            &[SUM_IS_ONE, POSITIVE_INSIDE],
        ),
        ("proof.P4.1.1.iff", true) => statement(
            0..=8,
            "This is T3.5.1 (as amended) and T3.5.2 together.",
            &[OFF_SUPPORT, AT_FIRST_KNOT, AT_LAST_KNOT, POSITIVE_INSIDE, POSITIVE_AT_KNOTS],
        ),
        ("proof.T3.5.2.cover", true) => statement(
            1..=8,
            "Index 0 stands for i. If t_1 < t_k, every x of (t_0, t_{k+1}) is less than t_k or greater than t_1. If t_1 = t_k, the two intervals are (t_0, t_1) and (t_1, t_{k+1}); these are all of (t_0, t_{k+1}) but t_1, unless one of them is empty, and then the other is all of it.",
            &[
                "(section (each j 1 (- k 1)) (window A 0 any (each s 2 j any) some (each s (+ j 1) (- k 1) any) any) (goals (> (t A k) (t A 1))))\
               (section (window A 0 any (each s 2 k 0) any) (goals (= (t A k) (t A 1))))",
            ],
        ),
        _ => None,
    }
}
