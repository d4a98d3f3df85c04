//! The ends of the knots and of the curve, and de Boor's range.

use super::Formal;
use super::basis::{LIVING, MIRRORED, SPAN, SUM_IS_ONE};

/// The orders of the functions at t_0 = … = t_k < t_{k+1}.
const ORDERS_AT_START: &str = "(section (window A 0 (each s 1 k 0) some (each s 1 k any)) (goals \
    (each i 0 k (order i k (in A k) i))))";

/// d_i^{q+1} from d_i^q and d_{i−1}^q, on the span j = 0.
fn recursion() -> String {
    let at = |place: &str| {
        format!(
            "(= (de-boor i (+ q 1) k ({place} A 0)) (+ (* (w i (- k q) ({place} A 0)) (de-boor i q k ({place} A 0))) \
             (* (v i (- k q) ({place} A 0)) (de-boor (- i 1) q k ({place} A 0)))))"
        )
    };
    format!(
        "(section (real (each i (- 0 k) 0 (d i))) {SPAN} (goals (each q 0 (- k 1) (each i (- (+ q 1) k) 0 {} {}))))",
        at("in"),
        at("from")
    )
}

pub(super) fn formal(claim: &str, amended: bool) -> Option<Formal> {
    match (claim, amended) {
        ("P3.1.extension", false) => Some(Formal::on_all_knots(
            0..=8,
            &format!(
                "{LIVING} On the last span, which ends at t_m, every function that lives there is a quotient whose denominator does not vanish at the end; all others are 0."
            ),
            &[&format!("(section {SPAN} (goals (each i (- 0 k) 0 (defined (G i k (to A 0))))))")],
        )),
        ("P4.2.tangent", true) => Some(Formal::on_all_knots(
            1..=8,
            "t_0 = … = t_k < t_{k+1}. On the first span, with u → 0 at t_0, G_i has the order i with a positive factor, and the sum of all is 1. So if d_0 = … = d_{i−1}, the curve is d_0 + (d_i − d_0)·c·u^i plus terms of higher order, with c > 0. At t_m the mirror image is looked at: the reflection takes the span to the mirrored one, the coordinate u to 1/u, and r to 1/r. For i = 1 the derivative is that of P4.2.2.",
            &[ORDERS_AT_START, SUM_IS_ONE, MIRRORED],
        )),
        ("T4.1.range", true) => Some(Formal::on_all_knots(
            1..=8,
            "On the span j = 0, for control points whose coordinates are unknowns. For i from j − k + q + 1 to j the point d_i^{q+1} is made of d_i^q and d_{i−1}^q, and both indices lie between j − k + q and j. That the sum over these i is the curve is T4.1.",
            &[&recursion()],
        )),
        _ => None,
    }
}
