//! Section 4: curves.

use std::ops::RangeInclusive;

use super::Formal;
use super::basis::{AT_LAST_KNOT, OFF_SUPPORT, SPAN, SUM_IS_ONE};

pub(super) fn formal(claim: &str, amended: bool) -> Option<Formal> {
    let statement = |degrees: RangeInclusive<usize>, because: &str, sections: &[&str]| {
        Some(Formal::on_all_knots(degrees, because, sections))
    };
    match (claim, amended) {
        ("P4.1.1", true) => statement(
            0..=8,
            "d_j acts through G_j only. That is 0 on every span outside of [t_j, t_{j+k+1}), and so at x = t_{j+k+1} < t_m as well; at x = t_m, as the limit from the left, it is 0 if t_m occurs at most k times among its knots, and 1, so that all others are 0, if k + 1 times.",
            &[OFF_SUPPORT, AT_LAST_KNOT, SUM_IS_ONE],
        ),
        ("P4.1.2", false) => statement(
            0..=8,
            "All other functions are 0 on the span: by D3.3 for all indices, shown for the next three on either side.",
            &[OFF_SUPPORT],
        ),
        ("P4.1.3", false) => statement(
            0..=8,
            "U is open, so that all k + 1 functions of a span exist. They are positive between the knots, and so ≥ 0 as limits at the knots; and their sum is 1.",
            &[
                SUM_IS_ONE,
                "(section (window A (- 0 k) (each s (- 0 k) -1 any) some (each s 1 k any)) (goals (each i (- 0 k) 0 (> (G i k (in A 0)) 0) \
                 (>= (G i k (from A 0)) 0) (>= (G i k (to A 0)) 0))))",
            ],
        ),
        ("P4.1.4", false) => statement(
            0..=8,
            "U is open, so that all k + 1 functions of a span exist, and their sum is 1. Coordinate by coordinate, an affine map adds up multiples c_j of the coordinates and a constant e; by linearity it is enough to look at one coordinate d with d ↦ c·d + e.",
            &[&format!(
                "(section (real c e (each i (- 0 k) 0 (d i))) {SPAN} (goals (each p 0 0 (= \
                 (+ (each i (- 0 k) 0 (* (+ (* c (d i)) e) (G i k (in A 0))))) \
                 (+ (* c (+ (each i (- 0 k) 0 (* (d i) (G i k (in A 0)))))) e)) (= \
                 (+ (each i (- 0 k) 0 (* (+ (* c (d i)) e) (G i k (from A 0))))) \
                 (+ (* c (+ (each i (- 0 k) 0 (* (d i) (G i k (from A 0)))))) e)))))"
            )],
        ),
        ("T4.1", false) => statement(
            0..=8,
            "Any span of any U, for no knot of the window is asked to be an end. On the span j = 0, for control points whose coordinates are unknowns, and for every level q; for q = k the left side is d_j^k.",
            &[&format!(
                "(section (real (each i (- 0 k) 0 (d i))) {SPAN} (goals (each q 0 k (= \
                 (+ (each i (- q k) 0 (* (de-boor i q k (in A 0)) (G i (- k q) (in A 0))))) \
                 (+ (each i (- 0 k) 0 (* (d i) (G i k (in A 0))))))) (= (de-boor 0 k k (in A 0)) \
                 (+ (each i (- 0 k) 0 (* (d i) (G i k (in A 0)))))) (= (de-boor 0 k k (from A 0)) \
                 (+ (each i (- 0 k) 0 (* (d i) (G i k (from A 0))))))))"
            )],
        ),
        _ => None,
    }
}
