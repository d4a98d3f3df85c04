//! Introduction and section 2: the weight, for every a, b, α, and every T.

use super::Formal;
use super::place::Place;

/// α as a negative number, and α as a number above 1; with r = α/(α − 1).
const BELOW: &str = "(positive h s) (let alpha (- s)) (let r (/ alpha (- alpha 1)))";
const ABOVE: &str = "(positive h s) (let alpha (+ 1 s)) (let r (/ alpha (- alpha 1)))";

/// The same section for α < 0 and for α > 1, on an interval [a, b] with b = a + h.
fn for_both(goals: &str) -> String {
    let section = |alpha: &str| format!("(section (real a) {alpha} (window A 0 h) (goals {goals}))");
    section(BELOW) + &section(ABOVE)
}

/// x + (α − 1)b − αa on [a, b], with a anywhere.
fn denominator(place: Place) -> String {
    format!("(+ a {} (* (- alpha 1) (+ a (t A 1))) (* -1 alpha a))", place.x())
}

/// The formula of D2.3 is the weight in terms of r.
pub(super) fn printed_formula() -> String {
    let place = Place::inside(0);
    let (w, x) = (place.value("w", 0, 1), place.x());
    for_both(&format!("(= {w} (/ (* alpha (- (+ a {x}) a)) {}))", denominator(place)))
}

const RANGE: &str = "(section (window A 0 some) (goals (> (w 0 1 (in A 0)) 0) (> (v 0 1 (in A 0)) 0) \
    (= (w 0 1 (from A 0)) 0) (= (w 0 1 (to A 0)) 1)))";
const CLIMBS: &str = "(section (positive s) (window A 0 some) (goals (defined (w 0 1 (in A 0))) \
    (> (at ((u (+ u s))) (w 0 1 (in A 0))) (w 0 1 (in A 0))) (> (Dw 0 1 (in A 0)) 0) \
    (= (w 0 1 (from A 0)) 0) (= (w 0 1 (to A 0)) 1)))";
const CONJUGATE: &str = "(= (/ (- 1 alpha) (- (- 1 alpha) 1)) (/ 1 r))";

pub(super) const FORMULA: &str =
    "The first two sections show that the weight of D2.3 is w with r = α/(α − 1), for α < 0 and for α > 1.";

pub(super) fn formal(claim: &str, amended: bool) -> Option<Formal> {
    let statement = |because: &str, sections: &[&str]| {
        Some(Formal::on_all_knots(1..=1, &because.replace("FORMULA", FORMULA), sections))
    };
    let formula = printed_formula();
    match (claim, amended) {
        ("phi.range", false) | ("P2.1.1", false) => statement(
            "FORMULA Between a and b, w > 0 and 1 − w > 0; at a, w = 0; everywhere else, and for a ≥ b, φ is 0 by definition.",
            &[&formula, RANGE],
        ),
        ("phi.shape", false) => statement(
            "FORMULA w is a quotient without a pole on [a, b], greater at the greater one of two points (u and u + s), 0 at a, with limit 1 at b. Outside of [a, b) φ is 0 by definition.",
            &[&formula, CLIMBS],
        ),
        ("R2.2.2a", false) => statement(
            "FORMULA w is a quotient without a pole on [a, b], greater at the greater one of two points, 0 at a and 1 at b; so it takes every value in between.",
            &[&formula, CLIMBS],
        ),
        ("L2.1", false) => statement(
            "A homographic f that is not affine, with f(a) = 0, f(b) = 1 and increasing on [a, b], has a pole c outside of [a, b] and is (b−c)(x−a)/((b−a)(x−c)). With c = a − s it is f_α for α = (h+s)/h > 1, with c = b + s for α = −s/h < 0; the pole of f_α is b − α(b−a), so that no other α does. That every f_α is such a function is R2.2.2a.",
            &[
                &formula,
                CLIMBS,
                "(section (positive h s) (let alpha (/ (+ h s) h)) (let r (/ alpha (- alpha 1))) (window A 0 h) (goals \
                 (> alpha 1) (= (w 0 1 (in A 0)) (/ (* (+ h s) (x (in A 0))) (* h (+ (x (in A 0)) s)))) \
                 (= (- h (* alpha h)) (- s))))",
                "(section (positive h s) (let alpha (- (/ s h))) (let r (/ alpha (- alpha 1))) (window A 0 h) (goals \
                 (< alpha 0) (= (w 0 1 (in A 0)) (/ (* (- s) (x (in A 0))) (* h (- (x (in A 0)) (+ h s))))) \
                 (= (- h (* alpha h)) (+ h s))))",
            ],
        ),
        ("R2.2.1", false) => {
            let goal = |compare: &str| {
                Place::closed(0).map(|place| format!("({compare} {} 0)", denominator(place))).concat()
            };
            let section = |alpha: &str, compare: &str| {
                format!("(section (real a) {alpha} (window A 0 h) (goals {}))", goal(compare))
            };
            statement(
                "With α = −s the expression is negative on [a, b], with α = 1 + s positive.",
                &[&section(BELOW, "<"), &section(ABOVE, ">")],
            )
        }
        ("R2.2.2b", false) => statement(
            "FORMULA r − 1 = 1/(α − 1) tends to 0 as |α| → ∞; w is a quotient in r whose denominator does not vanish for r > 0, so it tends to its value at r = 1, which is (x−a)/(b−a).",
            &[
                &formula,
                &for_both("(= (- r 1) (/ 1 (- alpha 1)))"),
                "(section (window A 0 some) (goals (defined (w 0 1 (in A 0))) \
                 (= (at ((r 1)) (w 0 1 (in A 0))) (/ (x (in A 0)) (t A 1))) \
                 (= (at ((r 1)) (w 0 1 (from A 0))) 0) (= (at ((r 1)) (w 0 1 (to A 0))) 1)))",
            ],
        ),
        ("R2.2.2c", false) => statement(
            "FORMULA To pass from α to 1 − α is to pass from r to 1/r, and a + b − x has the coordinate 1/u if x has u.",
            &[
                &formula,
                &for_both(CONJUGATE),
                "(section (window A 0 some) (goals (= (at ((u (/ 1 u))) (x (in A 0))) (- (t A 1) (x (in A 0)))) \
                 (= (at ((u (/ 1 u))) (w 0 1 (in A 0))) (at ((r (/ 1 r))) (v 0 1 (in A 0)))) \
                 (= (w 0 1 (in A 0)) (at ((u (/ 1 u)) (r (/ 1 r))) (v 0 1 (in A 0)))) \
                 (= (w 0 1 (from A 0)) (at ((r (/ 1 r))) (v 0 1 (to A 0)))) \
                 (= (w 0 1 (to A 0)) (at ((r (/ 1 r))) (v 0 1 (from A 0))))))",
            ],
        ),
        ("P2.1.2", false) => statement(
            "T(x) = c·x + e with c > 0. T takes [a, b] to an interval c times as long, and the point with coordinate u to the point with coordinate u, where w is the same; x = a goes to T(a). Outside of [a, b), and for a ≥ b, both sides are 0.",
            &["(section (positive c) (window A 0 some) (window B 0 (* c (A 0))) (goals \
               (= (x (in B 0)) (* c (x (in A 0)))) (= (w 0 1 (in B 0)) (w 0 1 (in A 0))) \
               (= (w 0 1 (from B 0)) (w 0 1 (from A 0)))))"],
        ),
        ("P2.1.3", true) => statement(
            "FORMULA T(x) = −c·x + e with c > 0. T takes [a, b] to the interval [T(b), T(a)], c times as long, and the point with coordinate u to the one with coordinate 1/u. To pass from α to 1 − α is to pass from r to 1/r. At x = a, T(x) = T(a) is not in [T(b), T(a)), and the other weight is 0; at x = b it is the other way round. For other x, and for a ≥ b, both are 0 by definition.",
            &[
                &formula,
                &for_both(CONJUGATE),
                "(section (positive c) (window A 0 some) (window B 0 (* c (A 0))) (goals \
                 (= (at ((u (/ 1 u))) (x (in B 0))) (* c (- (t A 1) (x (in A 0))))) \
                 (= (at ((u (/ 1 u))) (w 0 1 (in B 0))) (at ((r (/ 1 r))) (v 0 1 (in A 0)))) \
                 (= (w 0 1 (from A 0)) 0) (= (w 0 1 (from B 0)) 0)))",
            ],
        ),
        ("C2.4", true) => statement(
            "FORMULA The knots of A are a, t1, t2, b, those of B are a, a+b−t2, a+b−t1, b. If x has the coordinate u in the middle span of B, then a + b − x has 1/u in that of A. To pass from α to 1 − α is to pass from r to 1/r. At the first knot of its interval a weight is 0, and at every other point outside of it by definition: so both are 0 where x is not inside.",
            &[
                &formula,
                &for_both(CONJUGATE),
                "(section (window A 0 any some any) (window B 0 (A 2) (A 1) (A 0)) (goals \
                 (= (at ((u (/ 1 u))) (x (in A 1))) (- (t A 3) (x (in B 1)))) \
                 (= (at ((u (/ 1 u))) (w 1 1 (in A 1))) (at ((r (/ 1 r))) (v 1 1 (in B 1)))) \
                 (= (w 1 1 (from A 1)) 0) (= (w 1 1 (from B 1)) 0)))",
            ],
        ),
        ("Ill2.1", false) => {
            let at = |point: &str, what: &str| format!("(at ((u {point})) ({what} (in A 0)))");
            let (f, g, h) = (at("u", "w 0 1"), at("(+ u p)", "w 0 1"), at("(+ u p q)", "w 0 1"));
            let (x, y, z) = (at("u", "x"), at("(+ u p)", "x"), at("(+ u p q)", "x"));
            let (later, earlier) =
                (format!("(* (- {h} {g}) (- {y} {x}))"), format!("(* (- {g} {f}) (- {z} {y}))"));
            let section = |alpha: &str, goal: String| {
                let alpha = alpha.replace("h s", "h s p q");
                format!("(section {alpha} (window A 0 h) (goals {goal}))")
            };
            statement(
                "FORMULA At any three points, with coordinates u, u + p, u + p + q, the slope of the second chord is greater than that of the first for α < 0, and less for α > 1.",
                &[
                    &formula,
                    &section(BELOW, format!("(> {later} {earlier})")),
                    &section(ABOVE, format!("(< {later} {earlier})")),
                ],
            )
        }
        _ => None,
    }
}
