//! Steps of proofs, repaired.

use std::ops::RangeInclusive;

use super::Formal;
use super::basis::{
    AT_FIRST_KNOT, CONTINUITY, IS_OVER, LIVING, MIRRORED, OFF_SUPPORT, ORDERS, POSITIVE_AT_KNOTS,
    POSITIVE_INSIDE, STARTS_WITH_A_JUMP, SUM_IS_ONE,
};

/// Degree k − 1 at a knot t_0 = … = t_{p−1} of multiplicity p < k: no jump.
const LOWER_CONTINUITY: &str = "(section (each p 1 (- k 1)) (window A (- 0 k) (each s 1 (- k 1) any) some (each s 1 (- p 1) 0) some \
    (each s 1 (- k 1) any)) (goals (each i (- 0 k) (- p 1) (= (G i (- k 1) (to A -1)) (G i (- k 1) (from A (- p 1)))))))";

/// Degree k − 1 at a knot t_0 = … = t_{k−1} of multiplicity k: G_{−1} falls from 1 to 0, G_0 rises from 0 to 1.
const LOWER_JUMPS: &str = "(section (window A (- 0 k) (each s 1 (- k 1) any) some (each s 1 (- k 1) 0) some \
    (each s 1 (- k 1) any)) (goals (= (G -1 (- k 1) (to A -1)) 1) (= (G -1 (- k 1) (from A (- k 1))) 0) \
    (= (G 0 (- k 1) (to A -1)) 0) (= (G 0 (- k 1) (from A (- k 1))) 1) \
    (each i (- 0 k) -2 (= (G i (- k 1) (to A -1)) 0) (= (G i (- k 1) (from A (- k 1))) 0)) \
    (each i 1 (- k 1) (= (G i (- k 1) (to A -1)) 0) (= (G i (- k 1) (from A (- k 1))) 0))))";

/// Degree k − 1: the order at t_0 of G_0, whose first knot occurs q times from t_0 on.
const LOWER_ORDERS: &str = "(section (each q 1 k) (window A (- 1 k) (each s (- 1 k) -1 any) (each s 0 (- q 2) 0) some \
    (each s q (- (+ q k) 1) any)) (goals (order 0 (- k 1) (in A (- q 1)) (- k q))))";

/// The products of the recursion on a span and on the mirrored one.
const MIRRORED_PRODUCTS: &str = "(section (window A (- 0 k) (each s (- 0 k) -1 any) some (each s 1 k any)) \
    (window B (- 0 k) (each s (- 0 k) k (A (- 0 s)))) (goals (each i (- 1 k) 0 \
    (= (at ((u (/ 1 u))) (* (w i k (in A 0)) (G i (- k 1) (in A 0)))) \
    (at ((r (/ 1 r))) (* (v (- (- 1 i) k) k (in B 0)) (G (- (- 1 i) k) (- k 1) (in B 0))))))))";

/// Degree k − 1: on its span only G_{1−k}, …, G_0 live.
const LOWER_OFF_SUPPORT: &str = "(section (window A (- 0 k) (each s (- 0 k) -1 any) some (each s 1 k any)) (goals \
    (= (G (- 0 k) (- k 1) (in A 0)) 0) (= (G 1 (- k 1) (in A 0)) 0)))";

pub(super) fn formal(claim: &str, amended: bool) -> Option<Formal> {
    let statement = |degrees: RangeInclusive<usize>, because: &str, sections: &[&str]| {
        Some(Formal::on_all_knots(degrees, &because.replace("LIVING", LIVING), sections))
    };
    match (claim, amended) {
        ("proof.T3.5.3.iff" | "proof.P4.1.2.iff", true) => statement(
            0..=8,
            "LIVING So ⇒ holds on [t_j, t_{j+1}), and between the knots ⇔. At x = t_j a function with t_i < t_j and j−k ≤ i is positive: x lies inside of its support. One that begins at x with q ≤ k of its knots is 0 there, and one that begins with k + 1 of them, which is i = j − k, is 1.",
            &[POSITIVE_INSIDE, OFF_SUPPORT, POSITIVE_AT_KNOTS, AT_FIRST_KNOT],
        ),
        ("proof.P3.1.2.induction", true) => statement(
            2..=8,
            "LIVING At a knot of multiplicity p < k the limits of all functions of degree k − 1 from both sides agree. At one of multiplicity k, t_0 = … = t_{k−1}, G_{−1} falls from 1 to 0 and G_0 rises from 0 to 1, while all others are 0 on both sides. In degree k no limits differ for multiplicities up to k.",
            &[LOWER_CONTINUITY, LOWER_JUMPS, CONTINUITY],
        ),
        ("proof.P3.2.hypothesis", true) => statement(
            2..=8,
            "A function whose knots are all at one place lives on no span. For the others the proof of P3.2 serves in degree k − 1: let Σ c_i G_i = 0 and go through the spans from left to right. The functions that begin at the first knot of a span, with q ≤ k copies from t_i on, have there the orders k − q for the different q; these differ, so that the c of the lowest order is 0, then the next one. At t_0 the k + 1 copies leave the function with q = k + 1 out: it is 0.",
            &[LOWER_ORDERS],
        ),
        ("proof.T3.5.4.base", true) => statement(
            0..=0,
            "B is A in reverse; the function of the span is 1 on it, and so is its mirror image. At t_0 and t_m the limits count. At a knot inside the function that begins there is 1, while the mirror image of the one that ends there is 0.",
            &[MIRRORED, STARTS_WITH_A_JUMP, IS_OVER],
        ),
        ("proof.T3.5.4.corollary", true) => statement(
            1..=8,
            "B is A in reverse. The reflection takes the coordinate u of the span to 1/u of the mirrored one, and to pass from α to 1 − α is to pass from r to 1/r. For the functions of degree k − 1 that live on the span the products are the same; all others are 0, and so are the products.",
            &[MIRRORED_PRODUCTS, LOWER_OFF_SUPPORT],
        ),
        ("proof.P4.3.bisector", true) => statement(
            1..=8,
            "LIVING B is A in reverse: ^αG_i(t_0+t_m−x) is ^{1−α}G_{n−i}(x), at the knots by continuity. The sum is 1, so that the reflection D, an affine map, takes Σ d_i ^αG_i(t_0+t_m−x) to Σ D(d_i) ^{1−α}G_{n−i}(x). It is the curve Σ d_{n−i} ^{1−α}G_{n−i}(x) for all x exactly if D(d_i) = d_{n−i} for all i, for the functions are linearly independent: those that begin at a knot have different orders there (see P3.2).",
            &[MIRRORED, CONTINUITY, SUM_IS_ONE, ORDERS],
        ),
        _ => None,
    }
}
