//! Illustration 2.1: the largest distance of the weight from the classical one, for every r, with √r as a parameter.

use super::Formal;
use super::place::Place;
use super::weight::{FORMULA, printed_formula};

/// The bound less the difference φ − φ_∞ for r = (1+p)², or φ_∞ − φ for r = 1/(1+p)²: at u/(1+p), or at u·(1+p).
fn section(ratio: &str, point: &str, sign: &str) -> String {
    let w = Place::inside(0).value("w", 0, 1);
    let difference = format!("(* {sign} (- {w} (at ((r 1)) {w})))");
    let at = |u: &str| format!("(at ((u {u})) {difference})");
    let bound = "(/ p (+ p 2))";
    let rest = "(/ (* p (+ 1 p) (^ (- 1 u) 2)) (* (+ p 2) (+ 1 (* (+ 1 p) u)) (+ 1 p u)))";
    let highest = at(&point.replace('u', "1"));
    format!(
        "(section (positive p) (let r {ratio}) (window A 0 some) (goals (= (- {bound} {}) {rest}) \
         (>= {bound} {}) (= {highest} {bound}) (> {difference} 0)))",
        at(point),
        at(point)
    )
}

pub(super) fn formal(claim: &str, amended: bool) -> Option<Formal> {
    if claim != "Ill2.1.crucial" || amended {
        return None;
    }
    let because = "FORMULA Let √r = 1 + p, or 1/(1 + p): every r but 1. The claim's function of r is p/(p+2) for both. At the point with the coordinate u/(1+p), or u(1+p), it exceeds the difference of the weight and the classical one, which has the sign of r − 1 everywhere, by p(1−u)² times a positive factor: so the difference is largest for u = 1, and there only. p/(p+2) rises strictly with p, and 1 less it is 2/(p+2), which tends to 0. At a and b the difference is 0.";
    let rises = "(section (positive p q) (goals (> (/ (+ p q) (+ p q 2)) (/ p (+ p 2))) (= (- 1 (/ p (+ p 2))) (/ 2 (+ p 2)))))";
    let above = section("(^ (+ 1 p) 2)", "(/ u (+ 1 p))", "1");
    let below = section("(/ 1 (^ (+ 1 p) 2))", "(* u (+ 1 p))", "-1");
    let because = because.replace("FORMULA", FORMULA);
    Some(Formal::on_all_knots(1..=1, &because, &[&printed_formula(), &above, &below, rises]))
}
