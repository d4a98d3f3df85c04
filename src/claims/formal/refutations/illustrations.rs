//! Refutations of section 5: the paper's examples.

use crate::claims::formal::place::Place;
use crate::claims::formal::symmetric_curves;
use crate::spline::{Index, Side};

use super::Refuted;
use super::found::{Found, differ};

pub(super) fn refutation(claim: &str, found: &Found<'_>) -> Refuted {
    let k = found.k();
    Some(match claim {
        "Ill5.1.fig7" => {
            let value = found.value(&found.number("x")?, Side::Right, found.natural("i")?)?;
            let other: Index = found.witness.claimed.rsplit_once("α = ")?.1.parse().ok()?;
            let other = format!("(at ((r {})) {value})", other.ratio());
            (
                "The function has another value at x for the other index.",
                found.section(&differ(&value, &other)),
            )
        }
        "Ill5.7.local" => {
            let last = found.knots().spans().next_back()?.index();
            (
                "The moved control point is d_4: its factor is positive on the whole last span, so nothing unmoved follows.",
                found.section(&format!("(> {} 0)", Place::inside(last).value("G", 4, k))),
            )
        }
        "Ill5.8.symmetry" => {
            let points = symmetric_curves::points(found.text("instance")?, k)?;
            let goals: String =
                points.first()?.iter().zip(points.last()?).map(|(a, b)| format!("(= {a} {b})")).collect();
            (
                "The coordinates of the first and of the last control point are the same: they have no perpendicular bisector.",
                format!("(section (goals {goals}))"),
            )
        }
        "Ill5.8.double" => {
            let goals = symmetric_curves::off_double_point(found.text("instance")?, k)?;
            (
                "The squared distance of the curve from its double control point is positive everywhere.",
                found.section(&goals),
            )
        }
        _ => return None,
    })
}
