//! The abstract and the conclusion: what the class keeps of the classical properties, and the Bernstein case.

use super::Formal;
use super::basis::{
    AT_FIRST_KNOT, AT_LAST_KNOT, ENDS, LIVING, OFF_SUPPORT, ORDERS, POSITIVE_AT_KNOTS, POSITIVE_INSIDE,
    SUM_IS_ONE,
};

/// B_0^k for two indices.
const FALLS: &str = "(section (positive h q) (window A 0 (each s 1 k 0) h (each s 1 k 0)) (goals \
    (> (G 0 k (in A k)) (at ((r (+ r q))) (G 0 k (in A k))))))";

/// B_i^k at u is the Bernstein polynomial at r·u.
const REPARAMETRISED: &str = "(section (positive h) (window A 0 (each s 1 k 0) h (each s 1 k 0)) (goals (each i 0 k \
    (= (G i k (in A k)) (at ((u (* r u)) (r 1)) (G i k (in A k)))))))";

pub(super) fn formal(claim: &str, amended: bool) -> Option<Formal> {
    let statement = |because: &str, sections: &[&str]| {
        Some(Formal::on_all_knots(1..=8, &because.replace("LIVING", LIVING), sections))
    };
    match (claim, amended) {
        ("abstract.classical", true) => {
            let tangents = super::formal("P4.2.2", true)?.sections;
            statement(
                "LIVING Local control is P4.1.1 as amended: d_j acts through G_j, which is 0 outside of its support but for t_m. Convex hull and affine invariance: the functions that live on a span are positive there, and have the sum 1, at the knots as limits. End points: at t_0 and t_m one function is 1 and all others 0. End tangents are P4.2.2 as amended.",
                &[OFF_SUPPORT, AT_LAST_KNOT, SUM_IS_ONE, POSITIVE_INSIDE, ENDS, &tangents],
            )
        }
        ("C6.classical", true) => statement(
            "LIVING Local support is T3.5.1 as amended; positivity T3.5.2; the sum 1 on every span of an open U T3.5.3 as amended; linear independence P3.2: the functions that begin at a knot have different orders there.",
            &[
                OFF_SUPPORT,
                AT_FIRST_KNOT,
                AT_LAST_KNOT,
                POSITIVE_INSIDE,
                POSITIVE_AT_KNOTS,
                SUM_IS_ONE,
                ORDERS,
            ],
        ),
        ("abstract.bezier", false) => statement(
            "All weights are that of the whole interval. For the larger one of two values of r, B_0 is the smaller one, at every x between a and b.",
            &[FALLS],
        ),
        ("abstract.bezier.points", true) => statement(
            "All weights are that of the whole interval. With r = 1 the functions are the Bernstein polynomials; u ↦ r·u maps (0, ∞) onto itself, and x = a, x = b are u = 0 and the limit u → ∞. Curves are sums of these functions with the control points as factors. For k = 0 the only function is 1.",
            &[REPARAMETRISED],
        ),
        _ => None,
    }
}
