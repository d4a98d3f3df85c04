//! Refutations of the abstract, the definitions, the end tangents and de Boor's range.

use crate::claims::formal::place::Place;
use crate::spline::Side;

use super::Refuted;
use super::found::Found;

pub(super) fn refutation(claim: &str, found: &Found<'_>) -> Refuted {
    let (k, knots) = (found.k(), found.knots());
    let number = |name| found.natural(name);
    Some(match claim {
        // The property that fails has a claim of its own.
        "abstract.classical" | "C6.classical" => {
            super::questions::refutation(found.text("property")?, found)?
        }
        "abstract.bezier.points" => {
            let span = knots.spans().next()?.index();
            let goals: String = (0..=found.basis.n())
                .map(|i| Place::inside(span).value("G", i, k))
                .map(|g| format!("(= {g} (at ((u (* r u)) (r 1)) {g}))"))
                .collect();
            (
                "Every function at u is the Bernstein polynomial at r·u, and u ↦ r·u maps (0, ∞) onto itself: whatever the control points, the two curves have the same points.",
                found.section(&goals),
            )
        }
        "D3.1.interval" => {
            let (i, last) = (number("i")?, knots.m() - k);
            let (low, high) = if i < k { (i, k) } else { (last, i) };
            (
                "The knot with the index i lies outside of [t_k, t_{m−k}]: the one of these two is less than the other.",
                found.section(&format!("(< (t A {low}) (t A {high}))")),
            )
        }
        "D3.2.examples" => (
            "t_k = t_{m−k}: a < b does not hold.",
            found.section(&format!("(= (t A {k}) (t A {}))", knots.m() - k)),
        ),
        "P4.2.tangent" => {
            let x = found.number("x")?;
            let slopes: Option<Vec<_>> =
                (2..=found.basis.n()).map(|i| found.slope(&x, Side::Right, i)).collect();
            (
                "With d_0 = d_1 = 0 and 1 for all other control points the derivative at t_0 is the sum of the derivatives of all functions but the first two: it is 0.",
                found.section(&format!("(= (+ {}) 0)", slopes?.join(" "))),
            )
        }
        "T4.1.range" => (
            "For this i the recursion takes d_{i−1}, whose index is negative: there is no such control point.",
            found.section(&format!("(< (integer (- {} 1)) 0)", number("i")?)),
        ),
        _ => return None,
    })
}
