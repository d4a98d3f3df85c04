//! Section 5: the paper's examples, for every α at once.

use std::fmt::Write as _;

use crate::claims::instances::{Instance, instances_named};
use crate::claims::reflection::Reflection;
use crate::claims::verdict::Scope;
use crate::scalar::{BigRational, integer};
use crate::spline::Point;

use super::Formal;

const BASES: [&str; 4] = ["U0", "U1", "U2", "U3"];
const SYMMETRIC: [&str; 7] = ["S1", "S2", "S3", "S4", "S5", "S6", "S7"];
const HULL: [&str; 6] = ["C5", "C6a", "C6b", "C7a", "C7b", "C7c"];

/// r < 1, that is α < 0, and r > 1.
const BELOW: &str = "(positive s) (let r (/ s (+ 1 s)))";
const ABOVE: &str = "(positive s) (let r (/ (+ 1 s) s))";

/// The instances of these names.
pub(super) fn all(names: &[&str]) -> Vec<Instance> {
    names.iter().flat_map(|name| instances_named(name)).collect()
}

pub(super) fn of_degree(names: &[&str], degrees: &[usize]) -> Vec<Instance> {
    let mut instances = all(names);
    instances.retain(|instance| degrees.contains(&instance.degree));
    instances
}

/// An instance with what its goals are made of.
pub(super) struct On<'a> {
    pub(super) instance: &'a Instance,
    k: usize,
    n: usize,
}

impl<'a> On<'a> {
    pub(super) fn new(instance: &'a Instance) -> Self {
        Self { instance, k: instance.degree, n: instance.knots.m() - instance.degree - 1 }
    }

    /// The indices of the spans that are not empty.
    pub(super) fn spans(&self) -> Vec<usize> {
        self.instance.knots.spans().map(|span| span.index()).collect()
    }

    /// The functions that live on a span.
    pub(super) fn living(&self, span: usize) -> std::ops::RangeInclusive<usize> {
        span.saturating_sub(self.k)..=span.min(self.n)
    }

    /// `(G i k (in A s))`, or at another place of the span.
    pub(super) fn function(&self, i: usize, at: &str, span: usize) -> String {
        format!("(G {i} {} ({at} A {span}))", self.k)
    }

    /// One coordinate of the curve, or of its derivative.
    pub(super) fn coordinate(&self, c: usize, of: &str, at: &str, span: usize) -> String {
        let points = self.instance.points.as_deref().unwrap_or_default();
        let term = |i: usize| {
            let number = points.get(i).and_then(|point| point.get(c)).cloned().unwrap_or_default();
            format!("(* {number} ({of} {i} {} ({at} A {span})))", self.k)
        };
        let terms: Vec<_> = self.living(span).map(term).collect();
        format!("(+ {})", terms.join(" "))
    }

    /// A section with these goals on the knots of the instance, α unrestricted or as said.
    pub(super) fn section(&self, alpha: &str, goals: &str) -> String {
        if goals.is_empty() {
            return String::new();
        }
        let knots: Vec<_> = self.instance.knots.knots().iter().map(ToString::to_string).collect();
        // The section belongs to one degree of the statement: for any other it is not there.
        format!(
            "(section (each a {0} k) (each b k {0}) {alpha} (knots A 0 {1}) (goals {goals}))",
            self.k,
            knots.join(" ")
        )
    }
}

/// Sections for every instance, with goals made for each.
fn sections(instances: &[Instance], alpha: &str, goals: impl Fn(&On<'_>) -> String) -> String {
    instances.iter().map(On::new).map(|on| on.section(alpha, &goals(&on))).collect()
}

/// A goal for every span.
fn on_spans(goal: impl Fn(&On<'_>, usize) -> String) -> impl Fn(&On<'_>) -> String {
    move |on| on.spans().into_iter().map(|span| goal(on, span)).collect()
}

/// 0 ≤ G with sum 1 on every span, at the knots too.
fn hull(on: &On<'_>) -> String {
    let mut goals = String::new();
    for span in on.spans() {
        for at in ["in", "from", "to"] {
            let functions: Vec<_> = on.living(span).map(|i| on.function(i, at, span)).collect();
            let _ = write!(goals, "(= (+ {}) 1)", functions.join(" "));
            goals.extend(functions.iter().map(|g| format!("(>= {g} 0)")));
        }
    }
    goals
}

/// The support of G_i is [t_i, t_{i+k+1}].
fn support(on: &On<'_>) -> String {
    let goal = |i: usize, span: usize| {
        let g = on.function(i, "in", span);
        if on.living(span).contains(&i) { format!("(> {g} 0)") } else { format!("(= {g} 0)") }
    };
    on.spans().into_iter().flat_map(|span| (0..=on.n).map(move |i| goal(i, span))).collect()
}

/// On every span G_α(u) = G_∞(r·u).
fn reparametrised(on: &On<'_>, span: usize) -> String {
    let goal = |c: usize| {
        let coordinate = on.coordinate(c, "G", "in", span);
        format!("(= {coordinate} (at ((u (* r u)) (r 1)) {coordinate}))")
    };
    (0..2).map(goal).collect()
}

/// On the span j the curve of degree 1 is (1 − w)d_{j−1} + w·d_j.
fn along_the_leg(on: &On<'_>, span: usize) -> String {
    let points = on.instance.points.as_deref().unwrap_or_default();
    let Some((from, to)) = span.checked_sub(1).and_then(|i| points.get(i)).zip(points.get(span)) else {
        return String::new();
    };
    let place = format!("(in A {span})");
    let mut goals: String = (0..2)
        .map(|c| {
            let leg = format!("(+ (* {} (v {span} 1 {place})) (* {} (w {span} 1 {place})))", from[c], to[c]);
            format!("(= {} {leg})", on.coordinate(c, "G", "in", span))
        })
        .collect();
    let _ = write!(
        goals,
        "(> (Dw {span} 1 {place}) 0) (= (w {span} 1 (from A {span})) 0) (= (w {span} 1 (to A {span})) 1)"
    );
    goals
}

/// G_0 + … + G_j, for every j but the last, is greater (or less) than for α = ∞.
fn partial_sums(compare: &'static str) -> impl Fn(&On<'_>, usize) -> String {
    move |on, span| {
        let living: Vec<_> = on.living(span).collect();
        let goal = |j: usize| {
            let terms: Vec<_> = living[..j].iter().map(|i| on.function(*i, "in", span)).collect();
            let sum = format!("(+ {})", terms.join(" "));
            format!("({compare} {sum} (at ((r 1)) {sum}))")
        };
        (1..living.len()).map(goal).collect()
    }
}

/// The limits of all functions agree at every knot inside, but for those in the list; these jump from the first value to the
/// second.
fn jumps(on: &On<'_>, jumping: &[(usize, [u8; 2])]) -> String {
    let spans = on.spans();
    let mut goals = String::new();
    for pair in spans.windows(2) {
        for i in 0..=on.n {
            let (left, right) = (on.function(i, "to", pair[0]), on.function(i, "from", pair[1]));
            match jumping.iter().find(|(jumping, _)| *jumping == i) {
                // A jump occurs at the one knot of multiplicity k + 1.
                Some((_, [low, high])) if pair[1] - pair[0] > on.k => {
                    let _ = write!(goals, "(= {left} {low}) (= {right} {high})");
                }
                _ => {
                    let _ = write!(goals, "(= {left} {right})");
                }
            }
        }
        for i in 0..=on.n {
            for (at, span) in [("to", pair[0]), ("from", pair[1])] {
                let _ = write!(goals, "(defined (DG {i} {} ({at} A {span})))", on.k);
            }
        }
    }
    goals
}

/// At the double knot, which lies under a double control point P: how the curve arrives there and how it leaves.
fn tangents_at_double_point(on: &On<'_>) -> String {
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
        |span: usize, [near, far]: [usize; 2], i: usize, [small, large]: [&str; 2], end: &str| -> String {
            let g = |i: usize| on.function(i, "in", span);
            let mut goals: String = (0..2)
                .map(|c| {
                    let (p, near_p, far_p) = (&points[left][c], &from_p(near)[c], &from_p(far)[c]);
                    let sum = format!("(+ (* {near_p} {}) (* {far_p} {}))", g(near), g(far));
                    format!("(= (- {} {p}) {sum})", on.coordinate(c, "G", "in", span))
                })
                .collect();
            let weight = |of: &str, at: &str| format!("({of} {i} {k} ({at} A {span}))");
            let (small_in, large_in) = (weight(small, "in"), weight(large, "in"));
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
    goals(left, [before, before - 1], before, ["v", "w"], "to")
        + &goals(right, [after, right], right, ["w", "v"], "from")
        + &cross
}

/// The reflection takes G_α(t_0+t_m−x) to G_{1−α}(x).
fn mirrored(on: &On<'_>) -> String {
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
                on.coordinate(0, "G", "in", *span),
                unit(1),
                on.coordinate(1, "G", "in", *span)
            );
            let other = on.coordinate(c, "G", "in", *partner);
            let _ = write!(goals, "(= (at ((u (/ 1 u))) {image}) (at ((r (/ 1 r))) {other}))");
        }
    }
    goals
}

/// G_i of α at t_0 + t_m − x is G_{n−i} of 1 − α at x.
fn symmetric_functions(on: &On<'_>) -> String {
    let spans = on.spans();
    let goal = |(span, partner): (&usize, &usize)| -> String {
        let goal = |i: usize| {
            let (g, other) = (on.function(i, "in", *span), on.function(on.n - i, "in", *partner));
            format!("(= (at ((u (/ 1 u))) {g}) (at ((r (/ 1 r))) {other}))")
        };
        (0..=on.n).map(goal).collect()
    };
    spans.iter().zip(spans.iter().rev()).map(goal).collect()
}

/// The squared distance between two points given by terms.
fn squared(differences: [String; 2]) -> String {
    format!("(+ (^ {} 2) (^ {} 2))", differences[0], differences[1])
}

/// The squared distance from the curve for ∞ at a place.
fn from_classical(on: &On<'_>, at: &str, span: usize) -> String {
    squared([0, 1].map(|c| {
        let coordinate = on.coordinate(c, "G", at, span);
        format!("(- {coordinate} (at ((r 1)) {coordinate}))")
    }))
}

/// It is less than 1/16 everywhere.
fn near_classical(on: &On<'_>) -> String {
    let goal = |span: usize, at: &str| format!("(< {} 1/16)", from_classical(on, at, span));
    on.spans().into_iter().flat_map(|span| ["in", "from", "to"].map(|at| goal(span, at))).collect()
}

/// At x = 3 of C5 it is the same for r and 1/r, grows with r = 1 + s, and tends to 8.
fn separation(on: &On<'_>) -> String {
    const KNOT: usize = 6;
    let square = from_classical(on, "from", KNOT);
    let with = |r: &str| format!("(at ((r {r})) {square})");
    let (near, far) = (with("(+ 1 s)"), with("(+ 1 s q)"));
    let rest = "(/ (* 4 (+ 1 s) (+ (* 60 (^ s 4)) (* 401 (^ s 3)) (* 1049 (^ s 2)) (* 1296 s) 648)) \
        (* (^ (+ s 2) 2) (^ (+ s 3) 2) (^ (+ (* 2 s) 3) 2)))";
    format!("(> {far} {near}) (= {} {near}) (= (- 8 {near}) {rest})", with("(/ 1 (+ 1 s))"))
}

/// The coordinate c of the double point is greater than that of the curve everywhere; and on the span, at u, the squared
/// distance is less than 1/16.
fn misses(on: &On<'_>, c: usize, span: usize, u: &str) -> String {
    let Some(points) = &on.instance.points else { return String::new() };
    let Some(double) = points.windows(2).find(|pair| pair[0] == pair[1]).map(|pair| &pair[0]) else {
        return String::new();
    };
    let mut goals = String::new();
    for s in on.spans() {
        for at in ["in", "from", "to"] {
            let _ = write!(goals, "(> {} {})", double[c], on.coordinate(c, "G", at, s));
        }
    }
    let square = squared([0, 1].map(|c| format!("(- {} {})", on.coordinate(c, "G", "in", span), double[c])));
    let _ = write!(goals, "(< (at ((u {u})) {square}) 1/16)");
    goals
}

/// The control points of an instance of a degree.
pub(super) fn points(name: &str, degree: usize) -> Option<Vec<Point>> {
    instances_named(name).into_iter().find(|instance| instance.degree == degree)?.points
}

/// The squared distance of the curve from its double control point is positive on every closed span.
pub(super) fn off_double_point(name: &str, degree: usize) -> Option<String> {
    let instance = instances_named(name).into_iter().find(|instance| instance.degree == degree)?;
    let double = instance.points.as_ref()?.windows(2).find(|pair| pair[0] == pair[1])?[0].clone();
    let on = On::new(&instance);
    let goal = |span: usize, at: &str| {
        let square = |c: usize| format!("(^ (- {} {}) 2)", on.coordinate(c, "G", at, span), double[c]);
        format!("(> (+ {} {}) 0)", square(0), square(1))
    };
    Some(on.spans().into_iter().flat_map(|span| ["in", "from", "to"].map(|at| goal(span, at))).collect())
}

pub(super) fn formal(claim: &str, amended: bool) -> Option<Formal> {
    let statement = |degrees: &[usize], because: &str, sections: String| {
        let because = because.split_whitespace().collect::<Vec<_>>().join(" ");
        Some(Formal { scope: Scope::Alpha, degrees: degrees.to_vec(), because, sections })
    };
    let alpha = "r stands for every α of the paper; r = 1 is α = ∞.";
    match (claim, amended) {
        ("Ill5.1.translate", false) => statement(
            &[0, 1, 2, 3],
            &format!("{alpha} On the span s, the piece of G_i is the piece of G_0 on the span s − i, in the same coordinate; it is 0 where there is none. The spans of U0 all have length 1."),
            sections(&all(&["U0"]), "", |on| {
                let goal = |i: usize, s: usize| match s.checked_sub(i) {
                    Some(moved) => format!("(= {} {})", on.function(i, "in", s), on.function(0, "in", moved)),
                    None => format!("(= {} 0)", on.function(i, "in", s)),
                };
                (0..=on.n).flat_map(|i| on.spans().into_iter().map(move |s| goal(i, s))).collect()
            }),
        ),
        ("Ill5.1.fig7", true) => statement(
            &[3],
            "At x = t_{i+1} the value of G_i rises strictly with r: no two indices have the same function.",
            sections(&of_degree(&["U0"], &[3]), "(positive s)", |on| {
                let goal = |i: usize| {
                    let g = on.function(i, "to", i);
                    format!("(> (at ((r (+ r s))) {g}) {g})")
                };
                (0..=on.n).map(goal).collect()
            }),
        ),
        ("Ill5.1.support", false) => {
            statement(&[0, 1, 2, 3], &format!("{alpha} On the spans of [t_i, t_{{i+k+1}}] the function is positive, on all others 0."), sections(&all(&["U0"]), "", support))
        }
        ("Ill5.2.support", false) => {
            let instances = of_degree(&BASES, &[2]);
            statement(&[2], &format!("{alpha} On the spans of [t_i, t_{{i+k+1}}] the function is positive, on all others 0."), sections(&instances, "", support))
        }
        ("Ill5.3.symmetry", false) => statement(
            &[2],
            &format!("{alpha} The reflection takes the coordinate u of a span to 1/u of the mirrored one, and to pass from α to 1 − α is to pass from r to 1/r. All knots inside are simple, so that the functions are continuous."),
            sections(&all(&["U4", "U5"]), "", |on| symmetric_functions(on) + &jumps(on, &[])),
        ),
        ("Ill5.4.regularity", false) => statement(
            &[2],
            &format!("{alpha} At every knot inside the limits from both sides agree, but for G_2 and G_3 at the triple knot, where G_2 falls from 1 to 0 and G_3 rises from 0 to 1. All are quotients without a pole on closed spans, and so are their derivatives. G_2 lives on the spans of [t_2, t_5], and t_0 = t_2; G_3 on those of [t_3, t_6], and t_6 = t_8."),
            sections(&all(&["U9", "U10", "U12"]), "", |on| jumps(on, &[]))
                + &sections(&all(&["U11", "U13"]), "", |on| jumps(on, &[(2, [1, 0]), (3, [0, 1])]) + &support(on)),
        ),
        ("Ill5.6.k1", false) => statement(
            &[1],
            &format!("{alpha} On its span the curve is (1 − w)·d_{{j−1}} + w·d_j, and w climbs from 0 to 1."),
            sections(&of_degree(&["C6a", "C6b"], &[1]), "", on_spans(along_the_leg)),
        ),
        ("Ill5.6.bezier", false) => statement(
            &[3, 5],
            &format!("{alpha} On the only span the curve for α at u is the curve for ∞ at r·u, and u ↦ r·u maps (0, ∞) onto itself."),
            sections(&of_degree(&["C6a"], &[3]), "", on_spans(reparametrised))
                + &sections(&of_degree(&["C6b"], &[5]), "", on_spans(reparametrised)),
        ),
        ("Ill5.5.1", false) => statement(
            &[3],
            "α ≤ −4 and α ≥ 5 are 4/5 ≤ r < 1 and 1 < r ≤ 5/4, that is r = (4/5 + 5/4·v)/(1 + v) with v ≥ 0, or v → ∞, where the distance is a limit; the last section is r = 5/4. On every span the squared distance from the curve for ∞ is less than 1/16; at the knots the curves are continuous, and there it is less than 1/16 too.",
            sections(&all(&["C5"]), "(nonnegative v) (let r (/ (+ 4/5 (* 5/4 v)) (+ 1 v)))", near_classical)
                + &sections(&all(&["C5"]), "(let r 5/4)", near_classical),
        ),
        ("Ill5.5.2", false) => statement(
            &[3],
            "At x = 3 the squared distance from the curve for ∞ is the same for r = 1 + s and for r = 1/(1 + s). It grows strictly with s and tends to 8: with α → 0 from below, r → 0, and with α → 1 from above, r → ∞, the curves separate by more than any number below the square root of 8.",
            sections(&all(&["C5"]), "(positive s q)", separation),
        ),
        ("Ill5.8.double", true) => statement(
            &[3],
            &format!("{alpha} S2: the double point has the ordinate 14, and the curve a smaller one everywhere. S5: it has the abscissa 5, and the curve a smaller one everywhere. At one point of every curve, whose coordinate u depends on r, the squared distance is less than 1/16."),
            sections(&all(&["S2"]), "", |on| misses(on, 1, 4, "(/ (+ r 2) (* r (+ (* 2 r) 1)))"))
                + &sections(&all(&["S5"]), "", |on| misses(on, 0, 8, "(/ 1 r)")),
        ),
        ("Ill5.7.local", true) => statement(
            &[3],
            &format!("{alpha} The curves differ by a multiple of G_4, which is 0 on (0, 1) and positive on the three spans after it; at t_8 = t_m its limit is 0, and that of G_6 is 1. The knots are the same for the three curves."),
            sections(&all(&["C7a"]), "", |on| {
                let mut goals: String = on
                    .spans()
                    .into_iter()
                    .map(|s| format!("({} {} 0)", if s < 4 { "=" } else { ">" }, on.function(4, "in", s)))
                    .collect();
                if let Some(last) = on.spans().last() {
                    let (moved, end) = (on.function(4, "to", *last), on.function(6, "to", *last));
                    let _ = write!(goals, "(= {moved} 0) (= {end} 1)");
                }
                goals
            }),
        ),
        ("Ill5.7.hull", false) | ("Rem5.2", false) => statement(
            &[1, 2, 3, 4, 5],
            &format!("{alpha} At every x the factors of the control points are ≥ 0 with sum 1."),
            sections(&all(&HULL), "", hull),
        ),
        ("Ill5.7.shift", false) => {
            let instances = all(&["C7a"]);
            statement(
                &[3],
                "For α < 0, r = s/(1+s), all partial sums are greater than for α = ∞; for α > 1, r = (1+s)/s, less. At the knots the same holds, with ≥, by continuity. The knots are the same for the three curves.",
                sections(&instances, BELOW, on_spans(partial_sums(">")))
                    + &sections(&instances, ABOVE, on_spans(partial_sums("<"))),
            )
        }
        ("Ill5.8.symmetry", true) => statement(
            &[3],
            &format!("{alpha} The reflection at the axis is an affine map; it takes the curve for α at t_0 + t_m − x, the coordinate 1/u on the mirrored span, to the curve for 1 − α, which is 1/r for r, at x. All knots inside have multiplicity ≤ 3, so that the curves are continuous."),
            sections(&all(&SYMMETRIC), "", |on| mirrored(on) + &jumps(on, &[])),
        ),
        ("Ill5.8.fig29", false) => statement(
            &[3],
            &format!("{alpha} On both spans the curve for α at u is the curve for ∞ at r·u, and u ↦ r·u maps (0, ∞) onto itself."),
            sections(&all(&["S3"]), "", on_spans(reparametrised)),
        ),
        ("Ill5.8.multiplicity", false) => statement(
            &[3],
            &format!("{alpha} The double knot lies under a double control point P. On the span before it the curve is P + (d−P)·G + (d′−P)·G′ with the control points d, d′ before P. There w·G′ ≤ v·G with a weight w that tends to 1, so that G′/G → 0: the curve arrives along P − d. Likewise it leaves along e − P, with the control point e after P. The determinant of d − P and e − P is not 0: the two directions differ, whatever α."),
            sections(&all(&["S3", "S6"]), "", tangents_at_double_point),
        ),
        ("C6.larger", false) => statement(
            &[1, 2, 3, 4, 5, 6],
            "For r = 1 every weight of every knot vector is (x − a)/(b − a): the recursion is that of the polynomial B-splines. On U4 with α = −1, so r = 1/2, G_0 has a pole at u = −2, that is x = 2, and so is no polynomial on its first span.",
            "(section (window A (- 0 k) (each s (- 0 k) -1 any) some (each s 1 k any)) (goals (each i (- 1 k) 0 \
             (= (at ((r 1)) (w i k (in A 0))) (/ (- (x (in A 0)) (t A i)) (- (t A (+ i k)) (t A i)))))))\
             (section (each a 2 k) (each b k 2) (let r 1/2) (knots A 0 0 0 0 1 2 3 3 3) (goals (pole (in A 2) ((G 0 2 (in A 2))) -2)))"
                .to_owned(),
        )
        .map(|formal| Formal { scope: Scope::Knots, ..formal }),
        _ => None,
    }
}
