//! Illustrations 5.5 to 5.7, for every α at once: the curves C5 to C7. For traces that differ see `traces`.

use std::fmt::Write as _;

use super::Formal;
use super::example::{ALPHA, Example, all, of_degree, on_spans, sections};
use super::place::Place;

const HULL: [&str; 6] = ["C5", "C6a", "C6b", "C7a", "C7b", "C7c"];

/// r < 1, that is α < 0, and r > 1.
const BELOW: &str = "(positive s) (let r (/ s (+ 1 s)))";
const ABOVE: &str = "(positive s) (let r (/ (+ 1 s) s))";

/// 0 ≤ G with sum 1 on every span, at the knots too.
fn hull(on: &Example<'_>) -> String {
    let mut goals = String::new();
    for span in on.spans() {
        for place in Place::closed(span) {
            let functions: Vec<_> = on.living(span).map(|i| on.function(i, place)).collect();
            let _ = write!(goals, "(= (+ {}) 1)", functions.join(" "));
            goals.extend(functions.iter().map(|g| format!("(>= {g} 0)")));
        }
    }
    goals
}

/// On every span G_α(u) = G_∞(r·u).
pub(super) fn reparametrised(on: &Example<'_>, span: usize) -> String {
    let goal = |c: usize| {
        let coordinate = on.coordinate(c, Place::inside(span));
        format!("(= {coordinate} (at ((u (* r u)) (r 1)) {coordinate}))")
    };
    (0..2).map(goal).collect()
}

/// The derivative of the second coordinate at the first knot of the span is greater for r + s than for r.
fn rises_with_ratio(on: &Example<'_>, span: usize) -> String {
    let points = on.instance.points.as_deref().unwrap_or_default();
    let term = |i: usize| {
        let slope = Place::start(span).value("DG", i, on.k);
        points.get(i).and_then(|point| point.get(1)).map(|y| format!(" (* {y} {slope})")).unwrap_or_default()
    };
    let slope = format!("(+{})", on.living(span).map(term).collect::<String>());
    format!("(> (at ((r (+ r s))) {slope}) {slope})")
}

/// On the span j the curve of degree 1 is (1 − w)d_{j−1} + w·d_j.
fn along_the_leg(on: &Example<'_>, span: usize) -> String {
    let points = on.instance.points.as_deref().unwrap_or_default();
    let Some((from, to)) = span.checked_sub(1).and_then(|i| points.get(i)).zip(points.get(span)) else {
        return String::new();
    };
    let (w, v) = (Place::inside(span).value("w", span, 1), Place::inside(span).value("v", span, 1));
    let mut goals: String = (0..2)
        .map(|c| {
            let leg = format!("(+ (* {} {v}) (* {} {w}))", from[c], to[c]);
            format!("(= {} {leg})", on.coordinate(c, Place::inside(span)))
        })
        .collect();
    let _ = write!(
        goals,
        "(> {} 0) (= {} 0) (= {} 1)",
        Place::inside(span).value("Dw", span, 1),
        Place::start(span).value("w", span, 1),
        Place::end(span).value("w", span, 1)
    );
    goals
}

/// G_0 + … + G_j, for every j but the last, is greater (or less) than for α = ∞.
fn partial_sums(compare: &'static str) -> impl Fn(&Example<'_>, usize) -> String {
    move |on, span| {
        let living: Vec<_> = on.living(span).collect();
        let goal = |j: usize| {
            let terms: Vec<_> = living[..j].iter().map(|i| on.function(*i, Place::inside(span))).collect();
            let sum = format!("(+ {})", terms.join(" "));
            format!("({compare} {sum} (at ((r 1)) {sum}))")
        };
        (1..living.len()).map(goal).collect()
    }
}

/// The squared distance of two points whose coordinates have these differences.
pub(super) fn squared(differences: [String; 2]) -> String {
    format!("(+ (^ {} 2) (^ {} 2))", differences[0], differences[1])
}

/// The squared distance from the curve for ∞ at a place.
pub(super) fn from_classical(on: &Example<'_>, place: Place) -> String {
    squared([0, 1].map(|c| {
        let coordinate = on.coordinate(c, place);
        format!("(- {coordinate} (at ((r 1)) {coordinate}))")
    }))
}

/// It is less than 1/16 everywhere.
fn near_classical(on: &Example<'_>) -> String {
    let goal = |place| format!("(< {} 1/16)", from_classical(on, place));
    on.spans().into_iter().flat_map(Place::closed).map(goal).collect()
}

/// For α = −4 it is more than 61/1000 at x = 31/12 of C5, on the span 5 with u = 7/5.
fn nearly_as_far(on: &Example<'_>) -> String {
    format!("(> (at ((u 7/5)) {}) 61/1000)", from_classical(on, Place::inside(5)))
}

/// At x = 3 of C5 it is the same for r and 1/r, grows with r = 1 + s, and tends to 8.
fn separation(on: &Example<'_>) -> String {
    const KNOT: usize = 6;
    let square = from_classical(on, Place::start(KNOT));
    let with = |r: &str| format!("(at ((r {r})) {square})");
    let (near, far) = (with("(+ 1 s)"), with("(+ 1 s q)"));
    let rest = "(/ (* 4 (+ 1 s) (+ (* 60 (^ s 4)) (* 401 (^ s 3)) (* 1049 (^ s 2)) (* 1296 s) 648)) \
        (* (^ (+ s 2) 2) (^ (+ s 3) 2) (^ (+ (* 2 s) 3) 2)))";
    format!("(> {far} {near}) (= {} {near}) (= (- 8 {near}) {rest})", with("(/ 1 (+ 1 s))"))
}

pub(super) fn formal(claim: &str, amended: bool) -> Option<Formal> {
    let statement = |degrees: &[usize], because: &str, sections: String| {
        Some(Formal::on_all_indices(degrees, because, sections))
    };
    match (claim, amended) {
        ("Ill5.5.1", false) => statement(
            &[3],
            "α ≤ −4 and α ≥ 5 are 4/5 ≤ r < 1 and 1 < r ≤ 5/4, that is r = (4/5 + 5/4·v)/(1 + v) with v ≥ 0, or v → ∞, where the distance is a limit; the second section is r = 5/4. On every span the squared distance from the curve for ∞ is less than 1/16; at the knots the curves are continuous, and there it is less than 1/16 too. The bound is nearly the least one: the last section has α = −4 and x = 31/12, where the squared distance is more than 61/1000.",
            sections(&all(&["C5"]), "(nonnegative v) (let r (/ (+ 4/5 (* 5/4 v)) (+ 1 v)))", near_classical)
                + &sections(&all(&["C5"]), "(let r 5/4)", near_classical)
                + &sections(&all(&["C5"]), "(let r 4/5)", nearly_as_far),
        ),
        ("Ill5.5.2", false) => statement(
            &[3],
            "At x = 3 the squared distance from the curve for ∞ is the same for r = 1 + s and for r = 1/(1 + s). It grows strictly with s and tends to 8: with α → 0 from below, r → 0, and with α → 1 from above, r → ∞, the curves separate by more than any number below the square root of 8.",
            sections(&all(&["C5"]), "(positive s q)", separation),
        ),
        ("Ill5.6.k1", false) => statement(
            &[1],
            &format!("{ALPHA} On its span the curve is (1 − w)·d_{{j−1}} + w·d_j, and w climbs from 0 to 1."),
            sections(&of_degree(&["C6a", "C6b"], &[1]), "", on_spans(along_the_leg)),
        ),
        ("Ill5.6.bezier", false) => statement(
            &[3, 5],
            &format!(
                "{ALPHA} On the only span the curve for α at u is the curve for ∞ at r·u, and u ↦ r·u maps (0, ∞) onto itself."
            ),
            sections(&of_degree(&["C6a"], &[3]), "", on_spans(reparametrised))
                + &sections(&of_degree(&["C6b"], &[5]), "", on_spans(reparametrised)),
        ),
        ("Ill5.7.local", true) => statement(
            &[3],
            &format!(
                "{ALPHA} The curves differ by a multiple of G_4, which is 0 on (0, 1] and positive on the three spans after it and at the knots between them; at t_8 = t_m its limit is 0, and that of G_6 is 1. The knots are the same for the three curves."
            ),
            sections(&all(&["C7a"]), "", |on| {
                let mut goals: String = on
                    .spans()
                    .into_iter()
                    .map(|s| {
                        format!("({} {} 0)", if s < 4 { "=" } else { ">" }, on.function(4, Place::inside(s)))
                    })
                    .collect();
                if let Some(last) = on.spans().last() {
                    let (moved, end) = (on.function(4, Place::end(*last)), on.function(6, Place::end(*last)));
                    let _ = write!(goals, "(= {moved} 0) (= {end} 1)");
                }
                for (compare, span) in [('=', 4), ('>', 5), ('>', 6)] {
                    let _ = write!(goals, "({compare} {} 0)", on.function(4, Place::start(span)));
                }
                goals
            }),
        ),
        ("Ill5.7.hull", false) | ("Rem5.2", false) => statement(
            &[1, 2, 3, 4, 5],
            &format!("{ALPHA} At every x the factors of the control points are ≥ 0 with sum 1."),
            sections(&all(&HULL), "", hull),
        ),
        ("Ill5.6.bezier.function", true) => {
            let instances = [of_degree(&["C6a"], &[3]), of_degree(&["C6b"], &[5])].concat();
            let goals = |on: &Example<'_>| {
                on_spans(reparametrised)(on)
                    + &on.spans().into_iter().map(|span| rises_with_ratio(on, span)).collect::<String>()
            };
            statement(
                &[3, 5],
                &format!(
                    "{ALPHA} On the only span the curve for α at u is the curve for ∞ at r·u, and u ↦ r·u maps (0, ∞) onto itself: so the trace is the same. The derivative of the second coordinate with respect to x at the first knot rises strictly with r: so the functions are different for any two indices."
                ),
                sections(&instances, "(positive s)", goals),
            )
        }
        ("Ill5.7.shift", true) | ("Ill5.7.shift.order", false) => {
            let instances = all(&["C7a"]);
            statement(
                &[3],
                "For α < 0, r = s/(1+s), all partial sums are greater than for α = ∞; for α > 1, r = (1+s)/s, less. At the knots the same holds, with ≥, by continuity. The knots are the same for the three curves.",
                sections(&instances, BELOW, on_spans(partial_sums(">")))
                    + &sections(&instances, ABOVE, on_spans(partial_sums("<"))),
            )
        }
        _ => None,
    }
}
