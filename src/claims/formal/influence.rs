//! How much α is felt in the curves of section 5.

use std::fmt::Write as _;

use crate::claims::influence::{BELOW, middle_knot};
use crate::claims::instances::Instance;
use crate::claims::verdict::Scope;
use crate::spline::{Index, Side};

use super::Formal;
use super::example::{Example, all, of_degree, sections};
use super::illustrated_bases::{jumps, symmetric_functions};
use super::illustrated_curves::{from_classical, squared};
use super::place::Place;

/// For each index of [`BELOW`] on C5: a number between the largest squared distances for 1 − α and for α, and a point, by
/// its span and u, at which the curve for α is farther.
const BETWEEN: [(&str, usize, &str); 4] =
    [("613/10000", 5, "7/5"), ("139/100", 7, "5/3"), ("17/5", 7, "5/2"), ("22/5", 7, "3")];

/// The squared distance from G_∞ is less than the bound everywhere.
fn nearer(bound: &str) -> impl Fn(&Example<'_>) -> String {
    move |on| {
        let goal = |place| format!("(< {} {bound})", from_classical(on, place));
        on.spans().into_iter().flat_map(Place::closed).map(goal).collect()
    }
}

/// At one point it is more.
fn farther(bound: &str, span: usize, u: &str) -> impl Fn(&Example<'_>) -> String {
    move |on| format!("(> (at ((u {u})) {}) {bound})", from_classical(on, Place::inside(span)))
}

/// For the place-th index of [`BELOW`]: nearer for the conjugate, farther for the index itself; `mirrored`, for the
/// reversed polygon: the other way round, at the mirrored point.
pub(super) fn told_apart(instance: &Instance, place: usize, mirrored: bool) -> Option<String> {
    let index: Index = BELOW.get(place)?.parse().ok()?;
    let (bound, span, u) = BETWEEN.get(place)?;
    let on = Example::new(instance);
    let (near, far) =
        if mirrored { (index.clone(), index.conjugate()) } else { (index.conjugate(), index.clone()) };
    let spans = on.spans();
    let at = spans.iter().position(|s| s == span)?;
    let (span, u) = if mirrored {
        (*spans.iter().rev().nth(at)?, format!("(/ 1 {u})"))
    } else {
        (*span, (*u).to_owned())
    };
    let section = |index: &Index, goals: String| on.section(&format!("(let r {})", index.ratio()), &goals);
    Some(section(&near, nearer(bound)(&on)) + &section(&far, farther(bound, span, &u)(&on)))
}

/// At the middle knot the squared distance is positive and grows with s, for r = 1/(1 + s).
fn grows(on: &Example<'_>) -> String {
    let knots = &on.instance.knots;
    let span = middle_knot(on.instance).and_then(|x| knots.span_at(&x, Side::Right));
    let Some(span) = span else { return String::new() };
    let square = from_classical(on, Place::start(span.index()));
    let with = |r: &str| format!("(at ((r (/ 1 {r}))) {square})");
    let (near, far) = (with("(+ 1 s)"), with("(+ 1 s q)"));
    format!("(> {near} 0) (> {far} {near})")
}

/// The point x = 7/8, on the first span, is farther than 1/20 from all points of G_∞.
fn off_classical(on: &Example<'_>) -> String {
    let spans = on.spans();
    let Some(first) = spans.first() else { return String::new() };
    let point = [0, 1].map(|c| format!("(at ((u 7)) {})", on.coordinate(c, Place::inside(*first))));
    let mut goals = String::new();
    for place in spans.into_iter().flat_map(Place::closed) {
        let differences =
            [0, 1].map(|c| format!("(- (at ((r 1)) {}) {})", on.coordinate(c, place), point[c]));
        let _ = write!(goals, "(> {} 1/400)", squared(differences));
    }
    goals
}

pub(super) fn formal(claim: &str, amended: bool) -> Option<Formal> {
    match (claim, amended) {
        ("Ill5.5.2.zero", false) => {
            let instances = all(&["C5"]);
            let apart = (0..BELOW.len()).map(|place| told_apart(instances.first()?, place, false));
            Some(Formal::new(
                Scope::Instance,
                vec![3],
                "For each α two sections: on every span the squared distance from G_∞ for 1 − α is less than a number, at the knots as limits; and for α it is greater than that number at one point.",
                apart.collect::<Option<String>>()?,
            ))
        }
        ("Ill5.5.2.general", true) => Some(Formal::on_all_indices(
            &[3],
            "The reflection takes the coordinate u of a span to 1/u of the mirrored one, and to pass from α to 1 − α is to pass from r to 1/r: ^αG_i at t_0+t_m−x is ^{1−α}G_{n−i} at x. So the curve of the reversed polygon, Σ d_{n−i} G_i, for 1 − α at t_0+t_m−x is Σ d_i G_i for α at x. All knots inside are simple, so that the functions are continuous. The same for G_∞, and so for the distances.",
            sections(&all(&["C5"]), "", |on| symmetric_functions(on) + &jumps(on, &[])),
        )),
        ("Ill5.6.increasing", false) => Some(Formal::on_all_indices(
            &[2, 3, 4],
            "α < 0 is r = 1/(1 + s) with s > 0, and s grows as α rises to 0. At the middle knot the squared distance from G_∞ is positive, and greater for the greater one of two s.",
            sections(&of_degree(&["C6a"], &[2]), "(positive s q)", grows)
                + &sections(&of_degree(&["C6b"], &[2, 3, 4]), "(positive s q)", grows),
        )),
        ("Ill5.7.small", false) => {
            let instances = all(&["C7a", "C7b", "C7c"]);
            let range = "(nonnegative v) (let r (/ (+ 4/5 (* 5/4 v)) (+ 1 v)))";
            Some(Formal::on_all_indices(
                &[3],
                "α ≤ −4 and α ≥ 5 are 4/5 ≤ r < 1 and 1 < r ≤ 5/4, that is r = (4/5 + 5/4·v)/(1 + v) with v ≥ 0, or v → ∞, where the distance is a limit; the second section of each curve is r = 5/4. On every span the squared distance from G_∞ is less than 9/16; at the knots the curves are continuous, and there it is less than 9/16 too.",
                sections(&instances, range, nearer("9/16"))
                    + &sections(&instances, "(let r 5/4)", nearer("9/16")),
            ))
        }
        ("Ill5.8.remarkable", true) => {
            let instances = all(&["S1", "S2", "S4", "S5", "S6", "S7"]);
            let far = ["1/3", "1/6"].map(|r| sections(&instances, &format!("(let r {r})"), off_classical));
            Some(Formal::new(
                Scope::Instance,
                vec![3],
                "α = −1/2 and −1/5 are r = 1/3 and 1/6. On every span, and at the knots, the squared distance of G_∞ from the point of G_α with x = 7/8 (u = 7 on the first span) is more than 1/400. The curve for 1 − α is the mirror image of that for α, and that for ∞ its own (Ill5.8.symmetry).",
                far.concat(),
            ))
        }
        _ => None,
    }
}
