//! Illustration 5.8, for every α at once: the symmetric curves S1 to S7.

use std::fmt::Write as _;

use crate::claims::instances::instances_named;
use crate::claims::reflection::Reflection;
use crate::claims::symmetric_curves::double_point;
use crate::scalar::{BigRational, integer};
use crate::spline::Point;

use super::Formal;
use super::example::{ALPHA, Example, all, on_spans, sections};
use super::illustrated_bases::jumps;
use super::illustrated_curves::{reparametrised, squared};
use super::place::Place;

const SYMMETRIC: [&str; 7] = ["S1", "S2", "S3", "S4", "S5", "S6", "S7"];

/// The reflection takes G_α(t_0+t_m−x) to G_{1−α}(x).
fn mirrored(on: &Example<'_>) -> String {
    let points = on.instance.points.clone().unwrap_or_default();
    let axis = points.iter().zip(points.iter().rev()).find_map(|(p, q)| Reflection::between(p, q));
    let (Some(axis), spans) = (axis, on.spans()) else { return String::new() };
    let mut goals = String::new();
    for (span, partner) in spans.iter().zip(spans.iter().rev()) {
        // The reflection is affine: its matrix and its constant, from the images of three points.
        let zero = vec![integer(0), integer(0)];
        let constant = axis.apply(&zero);
        for (c, constant) in constant.iter().enumerate() {
            let unit = |d: usize| -> BigRational {
                let mut point = zero.clone();
                point[d] = integer(1);
                &axis.apply(&point)[c] - constant
            };
            let image = format!(
                "(+ {} (* {} {}) (* {} {}))",
                constant,
                unit(0),
                on.coordinate(0, Place::inside(*span)),
                unit(1),
                on.coordinate(1, Place::inside(*span))
            );
            let other = on.coordinate(c, Place::inside(*partner));
            let _ = write!(goals, "(= (at ((u (/ 1 u))) {image}) (at ((r (/ 1 r))) {other}))");
        }
    }
    goals
}

/// At the double knot, which lies under a double control point P: how the curve arrives there and how it leaves.
fn tangents_at_double_point(on: &Example<'_>) -> String {
    let spans = on.spans();
    let Some(points) = &on.instance.points else { return String::new() };
    let Some(&[left, right]) = spans.windows(2).find(|pair| pair[1] - pair[0] == 2) else {
        return String::new();
    };
    let k = on.k;
    let from_p = |to: usize| -> Vec<BigRational> {
        points[to].iter().zip(&points[left]).map(|(to, p)| to - p).collect()
    };
    // On a span: the neighbour of P, the control point beyond it, the weight that makes the latter's function the smaller one.
    let goals =
        |span: usize, [near, far]: [usize; 2], i: usize, [small, large]: [&str; 2], end: Place| -> String {
            let g = |i: usize| on.function(i, Place::inside(span));
            let mut goals: String = (0..2)
                .map(|c| {
                    let (p, near_p, far_p) = (&points[left][c], &from_p(near)[c], &from_p(far)[c]);
                    let sum = format!("(+ (* {near_p} {}) (* {far_p} {}))", g(near), g(far));
                    format!("(= (- {} {p}) {sum})", on.coordinate(c, Place::inside(span)))
                })
                .collect();
            let weight = |name: &str, place: Place| place.value(name, i, k);
            let (small_in, large_in) =
                (weight(small, Place::inside(span)), weight(large, Place::inside(span)));
            let _ = write!(
                goals,
                "(> {} 0) (>= (* {small_in} {}) (* {large_in} {})) (= {} 0)",
                g(near),
                g(near),
                g(far),
                weight(small, end)
            );
            goals
        };
    let (before, after) = (left - k + 1, right - 1);
    let (arrives, leaves) = (from_p(before), from_p(after));
    let cross = format!("(> (det ({} {}) ({} {})) 0)", arrives[0], arrives[1], leaves[0], leaves[1]);
    goals(left, [before, before - 1], before, ["v", "w"], Place::end(left))
        + &goals(right, [after, right], right, ["w", "v"], Place::start(right))
        + &cross
}

const NEAR: &str = "At one point of the curves of S2 and S5, whose coordinate u depends on r, the squared distance from the double point is less than 1/16.";
const MEETS: &str =
    "The curves of S3 and S6 are at the double point at their double knot, that of S7 at t_0 and at t_m.";

/// The coordinate c of the double point is greater than that of the curve everywhere.
fn misses(on: &Example<'_>, c: usize) -> String {
    let Some(double) = double_point(on.instance) else { return String::new() };
    let goal = |place| format!("(> {} {})", double[c], on.coordinate(c, place));
    on.spans().into_iter().flat_map(Place::closed).map(goal).collect()
}

/// At one point of S2 or S5 the squared distance from the double point is less than 1/16.
fn comes_near(on: &Example<'_>) -> String {
    let (span, u) = match on.instance.name {
        "S2" => (4, "(/ (+ r 2) (* r (+ (* 2 r) 1)))"),
        _ => (8, "(/ 1 r)"),
    };
    let Some(double) = double_point(on.instance) else { return String::new() };
    let square =
        squared([0, 1].map(|c| format!("(- {} {})", on.coordinate(c, Place::inside(span)), double[c])));
    format!("(< (at ((u {u})) {square}) 1/16)")
}

/// The curve is at its double point at its double knot, or else at both ends.
fn meets(on: &Example<'_>) -> String {
    let (Some(double), spans) = (double_point(on.instance), on.spans()) else { return String::new() };
    let places = match spans.windows(2).find(|pair| pair[1] - pair[0] == 2) {
        Some(pair) => vec![Place::start(pair[1])],
        None => spans
            .first()
            .map(|first| Place::start(*first))
            .into_iter()
            .chain(spans.last().map(|last| Place::end(*last)))
            .collect(),
    };
    let goal = |place: &Place| -> String {
        (0..2).map(|c| format!("(= {} {})", on.coordinate(c, *place), double[c])).collect()
    };
    places.iter().map(goal).collect()
}

/// The control points of an instance of a degree.
pub(super) fn points(name: &str, degree: usize) -> Option<Vec<Point>> {
    instances_named(name).into_iter().find(|instance| instance.degree == degree)?.points
}

/// The squared distance of the curve from its double control point is positive on every closed span.
pub(super) fn off_double_point(name: &str, degree: usize) -> Option<String> {
    let instance = instances_named(name).into_iter().find(|instance| instance.degree == degree)?;
    let double = double_point(&instance)?;
    let on = Example::new(&instance);
    let goal = |place| {
        let differences = [0, 1].map(|c| format!("(- {} {})", on.coordinate(c, place), double[c]));
        format!("(> {} 0)", squared(differences))
    };
    Some(on.spans().into_iter().flat_map(Place::closed).map(goal).collect())
}

pub(super) fn formal(claim: &str, amended: bool) -> Option<Formal> {
    let statement = |degrees: &[usize], because: &str, sections: String| {
        Some(Formal::on_all_indices(degrees, because, sections))
    };
    match (claim, amended) {
        ("Ill5.8.symmetry", true) => statement(
            &[3],
            &format!(
                "{ALPHA} The reflection at the axis is an affine map; it takes the curve for α at t_0 + t_m − x, the coordinate 1/u on the mirrored span, to the curve for 1 − α, which is 1/r for r, at x. All knots inside have multiplicity ≤ 3, so that the curves are continuous."
            ),
            sections(&all(&SYMMETRIC), "", |on| mirrored(on) + &jumps(on, &[])),
        ),
        ("Ill5.8.double", true) => statement(
            &[3],
            &format!(
                "{ALPHA} S2: the double point has the ordinate 14, and the curve a smaller one everywhere. S5: it has the abscissa 5, and the curve a smaller one everywhere. {NEAR} {MEETS}"
            ),
            sections(&all(&["S2"]), "", |on| misses(on, 1) + &comes_near(on))
                + &sections(&all(&["S5"]), "", |on| misses(on, 0) + &comes_near(on))
                + &sections(&all(&["S3", "S6", "S7"]), "", meets),
        ),
        ("Ill5.8.double.near", false) => statement(
            &[3],
            &format!("{ALPHA} {NEAR} {MEETS}"),
            sections(&all(&["S2", "S5"]), "", comes_near) + &sections(&all(&["S3", "S6", "S7"]), "", meets),
        ),
        ("Ill5.8.fig29", false) => statement(
            &[3],
            &format!(
                "{ALPHA} On both spans the curve for α at u is the curve for ∞ at r·u, and u ↦ r·u maps (0, ∞) onto itself."
            ),
            sections(&all(&["S3"]), "", on_spans(reparametrised)),
        ),
        ("Ill5.8.multiplicity", false) => statement(
            &[3],
            &format!(
                "{ALPHA} The double knot lies under a double control point P. On the span before it the curve is P + (d−P)·G + (d′−P)·G′ with the control points d, d′ before P. There w·G′ ≤ v·G with a weight w that tends to 1, so that G′/G → 0: the curve arrives along P − d. Likewise it leaves along e − P, with the control point e after P. The determinant of d − P and e − P is not 0: the two directions differ, whatever α."
            ),
            sections(&all(&["S3", "S6"]), "", tangents_at_double_point),
        ),
        _ => None,
    }
}
