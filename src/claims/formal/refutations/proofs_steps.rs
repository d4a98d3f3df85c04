//! Refutations of steps in proofs.

use crate::claims::formal::place::Place;
use crate::claims::proofs_steps::segment;
use crate::spline::Side;

use super::Refuted;
use super::found::{Found, differ};

pub(super) fn refutation(claim: &str, found: &Found<'_>) -> Refuted {
    let (k, knots, n) = (found.k(), found.knots(), found.basis.n());
    let i = || found.natural("i");
    let x = || found.number("x");
    Some(match claim {
        "proof.T3.5.3.iff" | "proof.P4.1.2.iff" => {
            let value = found.value(&x()?, Side::Right, i()?)?;
            (
                "j−k ≤ i ≤ j, and the function is 0 at x, the first knot of the span j, where it begins.",
                found.section(&format!("(= {value} 0)")),
            )
        }
        "proof.P3.1.2.induction" => {
            let value = |side| found.value(&x()?, side, i()?);
            (
                "The knots of the claim in degree k − 1: the limits of this function from the two sides differ.",
                found.section(&differ(&value(Side::Left)?, &value(Side::Right)?)),
            )
        }
        "proof.P3.2.hypothesis" => {
            let i = i()?;
            let zero =
                |span: crate::spline::Span| format!("(= {} 0)", Place::inside(span.index()).value("G", i, k));
            (
                "The knots of the claim in degree k − 1: this function is 0 on every span, so that the functions are not independent.",
                found.section(&knots.spans().map(zero).collect::<String>()),
            )
        }
        "proof.T3.5.4.base" => super::basis::refutation("T3.5.4", found)?,
        "proof.T3.5.4.corollary" => {
            let (i, x, t_0) = (i()?, x()?, knots.first());
            let other = knots.m() - k - i;
            // Where the point lies, if it is not in [t_i, t_{i+k}).
            let outside = |x: crate::scalar::BigRational, i: usize| {
                let moved = &x - t_0;
                if x < *knots.t(i) {
                    format!("(< {moved} (t A {i}))")
                } else {
                    format!("(>= {moved} (t A {}))", i + k)
                }
            };
            let goals = outside(knots.mirror(&x), i) + &outside(x, other);
            (
                "t_0 + t_m − x lies outside of [t_i, t_{i+k}), and x outside of [t_{m−i−k}, t_{m−i}): both weights are 0 by definition, and the claim says 0 = 1 − 0.",
                found.section(&goals),
            )
        }
        "proof.P4.3.bisector" => {
            let (i, points) = (i()?, segment(n));
            let sum = |i: usize| format!("(+ {} {})", points[i], points[n - i]);
            let between: String =
                points.iter().map(|p| format!("(>= {p} {}) (>= {} {p})", points[0], points[n])).collect();
            (
                "The points lie on a line. The bisector of the first and the last one is at 0, all others lie between them, so that the polygon is the segment, which is symmetric; but d_i and d_{n−i} are not at the same distance from 0.",
                found.section(&format!("(= {} 0) {between} {}", sum(0), differ(&sum(i), "0"))),
            )
        }
        _ => return None,
    })
}
