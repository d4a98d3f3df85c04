//! The conjecture on maxima where it fails, for every α ≠ ∞ at once; and where it holds, for α = ∞.

use std::fmt::Write as _;

use crate::claims::two_maxima::most_gaps;
use crate::claims::verdict::Scope;
use crate::scalar::integer;

use super::Formal;
use super::basis::CONTINUITY;
use super::maximum::{BECAUSE, MIDDLE, OUTER};
use super::place::Place;
use super::single_spans::{CUBIC, cubic};

/// On t_0 = … = t_{k−2} < t_{k−1} < t_k < t_{k+1}, for r = p/q ≠ 1, with x = t_{k−1}: only the gap after x differs from
/// window to window. It is that of A, falls to the middle of the way in B, from there in C, and is that of D at last.
const ON_THE_WAY: &str = "(section (each o 0 1) (positive s) (nonnegative y) \
    (let p (+ 1 (* (integer (- 1 o)) s))) (let q (+ 1 (* (integer o) s))) (let r (/ p q)) \
    (let d (^ s 2)) (let l (* 8 (^ (+ p q) 2))) \
    (let n (+ (* (integer (- (+ (* 2 k k) 7) (* 7 k))) p) (* (integer (- (* 5 k) 7)) q))) \
    (let e (* (integer (* 2 (- k 1))) (+ (* (integer (- (* 2 k) 3)) p) (* 3 q)))) \
    (window A 0 (each z 1 (- k 2) 0) (* q l) (* (integer (- k 2)) p l) (* p d)) \
    (window B 0 (each z 1 (- k 2) 0) (* q l e (+ 1 y)) (* p (- (* (integer (- k 2)) l e (+ 1 y)) (* n d))) (* e p d (+ 1 y))) \
    (window C 0 (each z 1 (- k 2) 0) (* q l e (+ 1 y)) (* p (- (* (integer (- k 2)) l e (+ 1 y)) (* (+ n (* e y)) d))) (* e p d (+ 1 y))) \
    (window D 0 (each z 1 (- k 2) 0) (* q l) (* p (- (* (integer (- k 2)) l) d)) (* p d)) \
    (goals \
    (> (DG 0 k (in A (- k 2))) 0) (> (DG 0 k (from A (- k 1))) 0) \
    (> (DG 0 k (from B (- k 1))) 0) \
    (< (DG 0 k (to C (- k 2))) 0) \
    (< (DG 0 k (to D (- k 2))) 0) (< (DG 0 k (in D (- k 1))) 0) (< (DG 0 k (in D k)) 0)))";

const EVERY_INDEX: &str = "The function G of the knots t_0 = … = t_{k−2} < x = t_{k−1} < t_k < t_{k+1}; repeated at both ends, they make an open knot vector. r is 1 + s or 1/(1 + s), so that every r ≠ 1 is meant. All knots but t_k and t_{k+1}, and the last gap, are in the same proportion in all windows: the gap after x is that of A, and as y rises from 0 to ∞ it goes from its value in the middle back to that of A in window B, and from the same value on to that of D in window C. In the middle, y = 0, the goals for B and C say D⁻G(x) < 0 < D⁺G(x): as G is continuous (last section), 0 at the ends of its support and positive inside, it has a local maximum on either side of x. Now let L be the largest value of G up to x and R that from x on. For A, G rises up to x and after it, so L = G(x) < R; for D it falls before x and from x to the end, so L > G(x) = R. L − R depends continuously on the gap, since G is a quotient of polynomials whose denominator is positive, so L = R for some gap on the way. There D⁻G(x) < 0 or D⁺G(x) > 0, so that one of L and R, and so the other, is greater than G(x): the largest value is taken on either side of x.";

/// The classical cubic on its two inner spans, each by itself, by the blossom of its derivative.
const CLASSICAL_CUBIC: &str = "(section (let r 1) (nonnegative f g v) (positive h) \
    (let c (/ 3 (+ f h g))) (let e (/ 3 (+ h g v))) (let b0 (* c (/ f (+ f h)))) (let b2 (/ (- (* c g) (* e h)) (+ h g))) \
    (window A 0 f h g v) \
    (goals (= (DG 0 3 (in A 1)) (/ (+ b0 (* 2 c u) (* b2 (^ u 2))) (^ (+ 1 u) 2))) (>= b0 0) (> c 0)))\
    (section (let r 1) (nonnegative f g v) (positive h) \
    (let c (/ 3 (+ f g h))) (let e (/ 3 (+ g h v))) (let b0 (/ (- (* c h) (* e g)) (+ g h))) (let b2 (* e (/ v (+ h v)))) \
    (window A 0 f g h v) \
    (goals (= (DG 0 3 (in A 2)) (/ (- b0 (+ (* 2 e u) (* b2 (^ u 2)))) (^ (+ 1 u) 2))) (>= b2 0) (> e 0)))\
    (section (let r 1) (window A 0 any some some any) (goals (= (DG 0 3 (to A 1)) (DG 0 3 (from A 2)))))";

const CLASSICAL: &str = "The function rises on its first span and falls on its last one, if these are not empty. On the span [t_1, t_2] the derivative of G_0 is a positive multiple of b_0 + 2cu + b_2u² with b_0 ≥ 0 < c, and on [t_2, t_3] of b_0 − 2eu − b_2u² with b_2 ≥ 0 < e: on each of them it changes its sign once at most, from + to −, by Descartes' rule. At t_2 it is continuous, if neither of these spans is empty, so that there is one change on both together: if it is negative or 0 there, it is negative from there on. At a knot of multiplicity ≤ 3 the function is continuous.";

const MOST: &str = "The function is positive inside its support and 0 at its ends, and continuous (last section). At k − 2 of its inner knots it falls from the left and rises to the right: so it is largest elsewhere than at these knots on each of the k − 1 parts of its support that they separate, and has a local maximum there.";

/// The function with k − 1 local maxima: at the inner knots that do not end its first or its last span it falls before and
/// rises after.
fn most(k: usize) -> String {
    let (gaps, ratio) = most_gaps(k);
    let mut knot = integer(0);
    let mut knots = format!("{knot}");
    for gap in gaps {
        knot += gap;
        let _ = write!(knots, " {knot}");
    }
    let mut goals = "(> (DG 0 k (in A 0)) 0)".to_owned();
    for s in 1..k - 1 {
        let slope = |place: Place| place.value("DG", 0, k);
        let _ = write!(goals, "(< {} 0) (> {} 0)", slope(Place::end(s)), slope(Place::start(s + 1)));
    }
    format!("(section (let r {ratio}) (knots A 0 {knots}) (goals {goals}))")
}

const TWO_AT_MOST: &str = " So after it has fallen it can rise again only from the one knot between these two spans on, and then falls on to its end: it has two local maxima at most. At a knot of multiplicity ≤ 3 it is continuous (last section); if it begins with a jump to 1, it lives on one span and falls, and if it ends at t_m with the limit 1, it rises.";

/// The uniform cubic function at its middle knot and, for α = ∞, on its inner spans: r > 1, r < 1 and r = 1.
const UNIFORM: &str = "(section (positive s) (let r (+ 1 s)) (knots A 0 0 1 2 3 4) (goals (< (DG 0 3 (to A 1)) 0) (< (DG 0 3 (from A 2)) 0)))\
    (section (positive s) (let r (/ 1 (+ 1 s))) (knots A 0 0 1 2 3 4) (goals (> (DG 0 3 (to A 1)) 0) (> (DG 0 3 (from A 2)) 0)))\
    (section (let r 1) (knots A 0 0 1 2 3 4) (goals (> (DG 0 3 (in A 1)) 0) (< (DG 0 3 (in A 2)) 0)))";

const ONE_IF_UNIFORM: &str = " So after it has fallen it can rise again only from the one knot between these two spans on. There, on the knots 0, 1, 2, 3, 4, it falls on both sides for r > 1, so that it falls from there on; for r < 1 it rises on both sides, and so it does before; and for r = 1 it rises before and falls after. It is continuous (last section). Its proportions are the same on any simple uniform knots.";

/// What is proved for all degrees at once.
pub(super) fn formal_for_all(question: &str, amended: bool) -> Option<Formal> {
    let sections = [ON_THE_WAY, CONTINUITY].concat();
    (question == "X.maxima" && !amended)
        .then(|| Formal::new(Scope::Alpha, (3..=8).collect(), EVERY_INDEX, sections))
}

/// What is proved for one degree.
pub(super) fn formal(question: &str, k: usize) -> Option<Formal> {
    match (question, k) {
        ("X.maxima", 3..=8) => {
            Some(Formal::new(Scope::Alpha, vec![k], EVERY_INDEX, [ON_THE_WAY, CONTINUITY].concat()))
        }
        ("X.maxima.classical" | "X.maxima.spans" | "X.maxima.uniform", 1 | 2) | ("X.maxima.bound", 2) => {
            Some(Formal::on_all_knots(k..=k, BECAUSE, &[OUTER, MIDDLE, CONTINUITY]))
        }
        ("X.maxima.bound", 3) => {
            Some(Formal::on_all_knots(3..=3, &[CUBIC, TWO_AT_MOST].concat(), &[OUTER, &cubic(), CONTINUITY]))
        }
        ("X.maxima.uniform", 3) => {
            let sections = [OUTER, &cubic(), UNIFORM, CONTINUITY];
            Some(Formal::on_all_knots(3..=3, &[CUBIC, ONE_IF_UNIFORM].concat(), &sections))
        }
        ("X.maxima.classical", 3) => {
            Some(Formal::new(Scope::Knots, vec![3], CLASSICAL, [OUTER, CLASSICAL_CUBIC, CONTINUITY].concat()))
        }
        ("X.maxima.most", 2..=8) => Some(Formal::new(Scope::Instance, vec![k], MOST, most(k) + CONTINUITY)),
        ("X.maxima.spans", 3) => Some(Formal::on_all_knots(3..=3, CUBIC, &[OUTER, &cubic(), CONTINUITY])),
        _ => None,
    }
}
