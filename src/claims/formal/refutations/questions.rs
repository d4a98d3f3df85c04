//! What answers our questions in the negative.

use crate::analysis::{Pieces, Sign, is_combination, sign_pattern};
use crate::claims::formal::place::Place;
use crate::scalar::{BigRational, RationalAlgebra, Ring};
use crate::spline::{Basis, Side};

use super::Refuted;
use super::found::{Found, differ, living, numbers, outside};

pub(super) fn refutation(claim: &str, found: &Found<'_>) -> Refuted {
    let k = found.k();
    let x = || found.number("x");
    let i = || found.natural("i").or_else(|| found.natural("j"));
    Some(match claim {
        "X.G1" => {
            let (p, rest) = found.text("d")?.strip_prefix("0 but for d_")?.split_once(" = (1, 0) and d_")?;
            let q = rest.strip_suffix(" = (0, 1)")?;
            let slope = |side, i: &str| found.slope(&x()?, side, i.parse().ok()?);
            let rows = [Side::Left, Side::Right]
                .map(|side| Some(format!("({} {})", slope(side, p)?, slope(side, q)?)));
            let [left, right] = rows;
            (
                "The derivatives of the curve from the left and from the right are not parallel.",
                found.section(&differ(&format!("(det {} {})", left?, right?), "0")),
            )
        }
        "X.totalpositivity" => {
            let list = found.text("functions")?.trim_matches(['(', ')']);
            let functions: Option<Vec<usize>> = list
                .split(", ")
                .map(|name| name.strip_prefix("G_")?.split_once('^')?.0.parse().ok())
                .collect();
            let functions = functions?;
            let row = |x: &BigRational| {
                let row: Option<Vec<_>> = functions.iter().map(|i| found.value(x, Side::Right, *i)).collect();
                Some(format!("({})", row?.join(" ")))
            };
            let rows: Option<Vec<_>> = numbers(found.text("points")?)?.iter().map(row).collect();
            (
                "The minor of these functions at these points is negative.",
                found.section(&format!("(< (det {}) 0)", rows?.join(" "))),
            )
        }
        "X.variation" => too_many_crossings(found)?,
        "X.linear" => {
            let place = Place::inside(found.span()?);
            (
                "Already on this span x is no combination of the functions that live there.",
                found.section(&outside(found.knots(), place, &place.x(), k)),
            )
        }
        "X.derivative" => {
            let (place, i) = (Place::inside(found.span()?), i()?);
            (
                "On this span the derivative is no combination of the functions of degree k − 1 that live there.",
                found.section(&outside(found.knots(), place, &place.value("DG", i, k), k - 1)),
            )
        }
        "X.nested" => not_nested(found, i()?)?,
        _ => return None,
    })
}

/// The curve with these ordinates changes its sign more often than its control polygon.
fn too_many_crossings(found: &Found<'_>) -> Refuted {
    let ordinates = numbers(found.text("ordinates of the control points")?)?;
    let pieces = Pieces::of(&found.basis);
    let mut signs: Vec<(Sign, String)> = Vec::new();
    for span in pieces.spans() {
        let terms = span.functions.iter().map(|(i, g)| g.times(&g.embed(&ordinates[i])));
        let sum = terms.fold(pieces.zero(), |sum, term| sum.plus(&term));
        let (k, place) = (found.k(), Place::inside(span.span.index()));
        let term: String = living(found.knots(), place.span(), k)
            .map(|i| format!(" (* {} {})", ordinates[i], place.value("G", i, k)))
            .collect();
        for (u, sign) in sign_pattern(&sum.numerator().times(sum.denominator())).between() {
            if *sign != Sign::Zero && signs.last().is_none_or(|(last, _)| last != sign) {
                signs.push((*sign, format!("(at ((u {u})) (+{term}))")));
            }
        }
    }
    let goals: String = signs
        .iter()
        .map(|(sign, value)| format!("({} {value} 0)", if *sign == Sign::Positive { ">" } else { "<" }))
        .collect();
    Some((
        "The ordinate of the curve with these control points has these signs, alternating, at points from left to right; the ordinates of the control points themselves change their sign less often.",
        found.section(&goals),
    ))
}

/// G_i is no combination of the functions of the refined knots, on some span of these.
fn not_nested(found: &Found<'_>, i: usize) -> Refuted {
    let (k, knot) = (found.k(), found.number("new knot")?);
    let refined = found.knots().with_knot(&knot);
    let fine = Basis::new(refined.clone(), k, found.basis.index().clone()).ok()?;
    let pieces = Pieces::of(&fine);
    for span in pieces.spans() {
        let (start, _) = span.ends();
        let old = found.knots().span_at(start, Side::Right)?;
        let (a, b) = found.knots().ends(old).ok()?;
        // The old function at the points of the new span.
        let active = found.basis.active(old, &span.x).ok()?;
        let Some(value) = active.get(i) else { continue };
        if is_combination(span.functions.values(), value) {
            continue;
        }
        let place = Place::inside(span.span.index()).on('B');
        let first = found.knots().first();
        let (a, b) = (a - first, b - first);
        let (point, g) = (place.x(), Place::inside(old.index()).value("G", i, k));
        let term = format!("(at ((u (/ (- {point} {a}) (- {b} {point})))) {g})");
        let window: String = refined.knots().iter().map(|t| format!(" {t}")).collect();
        let goal = outside(&refined, place, &term, k);
        return Some((
            "B has the refined knots. On this span of B the function for A, at the point of A that has the same x, is no combination of the functions for B that live there.",
            found.section_with(&format!("(knots B 0{window})"), &goal),
        ));
    }
    None
}
