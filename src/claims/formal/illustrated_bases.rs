//! Illustrations 5.1 to 5.4 and the conclusion, for every α at once: the bases on U0 to U13.

use std::fmt::Write as _;

use super::Formal;
use super::example::{ALPHA, Example, all, of_degree, sections};
use super::place::Place;

const BASES: [&str; 4] = ["U0", "U1", "U2", "U3"];

/// The support of G_i is [t_i, t_{i+k+1}].
fn support(on: &Example<'_>) -> String {
    let goal = |i: usize, span: usize| {
        let g = on.function(i, Place::inside(span));
        if on.living(span).contains(&i) { format!("(> {g} 0)") } else { format!("(= {g} 0)") }
    };
    on.spans().into_iter().flat_map(|span| (0..=on.n).map(move |i| goal(i, span))).collect()
}

/// The limits of all functions agree at every knot inside, but for those in the list; these jump from the first value to the
/// second.
pub(super) fn jumps(on: &Example<'_>, jumping: &[(usize, [u8; 2])]) -> String {
    let spans = on.spans();
    let mut goals = String::new();
    for pair in spans.windows(2) {
        for i in 0..=on.n {
            let (left, right) = (on.function(i, Place::end(pair[0])), on.function(i, Place::start(pair[1])));
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
            for place in [Place::end(pair[0]), Place::start(pair[1])] {
                let _ = write!(goals, "(defined {})", place.value("DG", i, on.k));
            }
        }
    }
    goals
}

/// G_i of α at t_0 + t_m − x is G_{n−i} of 1 − α at x.
pub(super) fn symmetric_functions(on: &Example<'_>) -> String {
    let spans = on.spans();
    let goal = |(span, partner): (&usize, &usize)| -> String {
        let goal = |i: usize| {
            let (g, other) =
                (on.function(i, Place::inside(*span)), on.function(on.n - i, Place::inside(*partner)));
            format!("(= (at ((u (/ 1 u))) {g}) (at ((r (/ 1 r))) {other}))")
        };
        (0..=on.n).map(goal).collect()
    };
    spans.iter().zip(spans.iter().rev()).map(goal).collect()
}

pub(super) fn formal(claim: &str, amended: bool) -> Option<Formal> {
    let statement = |degrees: &[usize], because: &str, sections: String| {
        Some(Formal::on_all_indices(degrees, because, sections))
    };
    match (claim, amended) {
        ("Ill5.1.translate", false) => statement(
            &[0, 1, 2, 3],
            &format!(
                "{ALPHA} On the span s, the piece of G_i is the piece of G_0 on the span s − i, in the same coordinate; it is 0 where there is none. The spans of U0 all have length 1."
            ),
            sections(&all(&["U0"]), "", |on| {
                let goal = |i: usize, s: usize| match s.checked_sub(i) {
                    Some(moved) => format!(
                        "(= {} {})",
                        on.function(i, Place::inside(s)),
                        on.function(0, Place::inside(moved))
                    ),
                    None => format!("(= {} 0)", on.function(i, Place::inside(s))),
                };
                (0..=on.n).flat_map(|i| on.spans().into_iter().map(move |s| goal(i, s))).collect()
            }),
        ),
        ("Ill5.1.fig7", true) => statement(
            &[3],
            "At x = t_{i+1} the value of G_i rises strictly with r: no two indices have the same function.",
            sections(&of_degree(&["U0"], &[3]), "(positive s)", |on| {
                let goal = |i: usize| {
                    let g = on.function(i, Place::end(i));
                    format!("(> (at ((r (+ r s))) {g}) {g})")
                };
                (0..=on.n).map(goal).collect()
            }),
        ),
        ("Ill5.1.support", false) => statement(
            &[0, 1, 2, 3],
            &format!("{ALPHA} On the spans of [t_i, t_{{i+k+1}}] the function is positive, on all others 0."),
            sections(&all(&["U0"]), "", support),
        ),
        ("Ill5.2.support", false) => {
            let instances = of_degree(&BASES, &[2]);
            statement(
                &[2],
                &format!(
                    "{ALPHA} On the spans of [t_i, t_{{i+k+1}}] the function is positive, on all others 0."
                ),
                sections(&instances, "", support),
            )
        }
        ("Ill5.3.symmetry", false) => statement(
            &[2],
            &format!(
                "{ALPHA} The reflection takes the coordinate u of a span to 1/u of the mirrored one, and to pass from α to 1 − α is to pass from r to 1/r. All knots inside are simple, so that the functions are continuous."
            ),
            sections(&all(&["U4", "U5"]), "", |on| symmetric_functions(on) + &jumps(on, &[])),
        ),
        ("Ill5.4.regularity", false) => statement(
            &[2],
            &format!(
                "{ALPHA} At every knot inside the limits from both sides agree, but for G_2 and G_3 at the triple knot, where G_2 falls from 1 to 0 and G_3 rises from 0 to 1. All are quotients without a pole on closed spans, and so are their derivatives. G_2 lives on the spans of [t_2, t_5], and t_0 = t_2; G_3 on those of [t_3, t_6], and t_6 = t_8."
            ),
            sections(&all(&["U9", "U10", "U12"]), "", |on| jumps(on, &[]))
                + &sections(&all(&["U11", "U13"]), "", |on| {
                    jumps(on, &[(2, [1, 0]), (3, [0, 1])]) + &support(on)
                }),
        ),
        ("C6.larger", false) => Some(Formal::on_all_knots(
            1..=6,
            "For r = 1 every weight of every knot vector is (x − a)/(b − a): the recursion is that of the polynomial B-splines. On the first span of U4 with α = −1, so r = 1/2, the curve has the coordinates X = G_0 and Y = G_2. By the last goals none of 1, X, Y, X², XY, Y² is a combination of those before it: so the piece lies on no conic, and only finitely many of its points on one. A quadratic polynomial B-spline curve consists of finitely many arcs of parabolas and lines.",
            &[
                "(section (window A (- 0 k) (each s (- 0 k) -1 any) some (each s 1 k any)) (goals (each i (- 1 k) 0 \
             (= (at ((r 1)) (w i k (in A 0))) (/ (- (x (in A 0)) (t A i)) (- (t A (+ i k)) (t A i)))))))\
             (section (each a 2 k) (each b k 2) (let r 1/2) (knots A 0 0 0 0 1 2 3 3 3) (goals \
             (outside (in A 2) (G 0 2 (in A 2)) (1)) (outside (in A 2) (G 2 2 (in A 2)) (1 (G 0 2 (in A 2)))) (outside (in A 2) (^ (G 0 2 (in A 2)) 2) (1 (G 0 2 (in A 2)) (G 2 2 (in A 2)))) \
             (outside (in A 2) (* (G 0 2 (in A 2)) (G 2 2 (in A 2))) (1 (G 0 2 (in A 2)) (G 2 2 (in A 2)) (^ (G 0 2 (in A 2)) 2))) (outside (in A 2) (^ (G 2 2 (in A 2)) 2) (1 (G 0 2 (in A 2)) (G 2 2 (in A 2)) (^ (G 0 2 (in A 2)) 2) (* (G 0 2 (in A 2)) (G 2 2 (in A 2)))))))",
            ],
        )),
        _ => None,
    }
}
