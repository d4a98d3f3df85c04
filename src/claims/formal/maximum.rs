//! Conjecture 3.1 where it is true: degrees 1 and 2 on every knot vector; and Remark 5.1 on the paper's examples.

use std::fmt::Write as _;

use crate::analysis::{Pieces, Sign, sign_pattern};
use crate::claims::verdict::Scope;
use crate::scalar::{BigRational, Polynomial};
use crate::spline::{Basis, Index};

use super::Formal;
use super::basis::{AT_LAST_KNOT, CONTINUITY};
use super::example::{Example, all};
use super::place::Place;

/// The functions that rise on their only span, or their first one, and those that fall on it.
pub(super) const OUTER: &str = "(section (window A (- 0 k) (each s (- 0 k) -1 any) some (each s 1 k any)) (goals \
    (> (DG 0 k (in A 0)) 0) (< (DG (- 0 k) k (in A 0)) 0)))";

/// Degree 2: on its middle span, of length h, with the gaps p and q to both sides, G_{−1} has the derivative
/// E(s)·(a positive quotient) with s = r·u; the coefficients e of E and what follows from their signs.
pub(super) const MIDDLE: &str = "(section (each first 2 k) (each last k 2) (nonnegative p q) (positive h) (let s (* r u)) \
    (let a (+ 1 (* r (/ p h)))) (let b (+ 1 (/ p h))) (let c (+ 1 (/ q h))) (let d (+ 1 (/ q (* r h)))) \
    (let e0 (* (+ a b) (^ c 2))) \
    (let e1 (* 2 c (- (+ (* (+ a b) d) (* b c)) (^ a 2)))) \
    (let e2 (- (+ (* (+ a b) (^ d 2)) (* 4 b c d)) (+ (* (+ c d) (^ a 2)) (* 4 a b c)))) \
    (let e3 (* 2 b (- (^ d 2) (+ (* (+ c d) a) (* c b))))) \
    (let e4 (* -1 (+ c d) (^ b 2))) \
    (window A -2 any p h q any) (goals \
    (= (DG -1 2 (in A 0)) (/ (* (+ e0 (* e1 s) (* e2 (^ s 2)) (* e3 (^ s 3)) (* e4 (^ s 4))) r (^ (+ 1 u) 2)) \
    (* h (^ (+ 1 s) 2) (^ (+ a (* b s)) 2) (^ (+ c (* d s)) 2)))) \
    (> e0 0) (< e4 0) \
    (> (* (+ (* a (+ c d)) (* 2 b c)) e1) (* 2 a c e2)) \
    (> (* 2 b d e2) (* (+ (* d (+ a b)) (* 2 b c)) e3))))";

pub(super) const BECAUSE: &str = "A function lives on at most k + 1 spans. It rises on the span [t_i, t_{i+1}], and falls on [t_{i+k}, t_{i+k+1}], if these are not empty (first section). For k = 2 its derivative on [t_{i+1}, t_{i+2}] has the sign of a polynomial E of degree 4 in s = r·u, with e_0 > 0 > e_4. The last two goals say: if e_1 ≤ 0 then e_2 < 0, and if e_3 ≥ 0 then e_2 > 0. So the signs of the coefficients change exactly once, and by Descartes' rule E changes its sign exactly once, from + to −. At knots of multiplicity ≤ k the functions are continuous (last section). So a function rises and then falls, once; it may begin with a jump to 1, if t_i = t_{i+k}, and fall from there, or, if t_{i+1} = t_{i+k+1} = t_m, rise to the limit 1 that counts as its value. So it has one local maximum, and as it rises and falls strictly, that is its only largest value.";

/// What is added where functions that drop are spoken of.
const DROPS: &str = " If t_i < t_{i+1} = t_{i+k+1} < t_m, it rises on its only span to the limit 1, and is 0 from there on, where it does not live any more.";

/// On every span of the support: the sign of the derivative, or its quotient of polynomials.
fn unimodal(on: &Example<'_>, index: &Index) -> Option<String> {
    let basis = Basis::new(on.instance.knots.clone(), on.instance.degree, index.clone()).ok()?;
    let (pieces, k) = (Pieces::of(&basis), basis.degree());
    let mut goals = String::new();
    for i in 0..=basis.n() {
        let (low, high) = basis.support(i);
        // What rises to a knot of multiplicity k + 1 and drops there is excepted.
        if basis.knots().t(i + 1) == high && high != basis.knots().last() {
            continue;
        }
        let mut before = None;
        for span in pieces.spans() {
            let (start, end) = span.ends();
            if start < low || high < end {
                continue;
            }
            let s = span.span.index();
            let slope = span.derivative(&span.function(i));
            let signs: Vec<Sign> =
                sign_pattern(slope.numerator()).between().iter().map(|(_, sign)| *sign).collect();
            let term = Place::inside(s).value("DG", i, k);
            let _ = match signs.as_slice() {
                [Sign::Positive] => write!(goals, "(> {term} 0)"),
                [Sign::Negative] => write!(goals, "(< {term} 0)"),
                _ => {
                    let (p, q) = (polynomial(slope.numerator()), polynomial(slope.denominator()));
                    write!(goals, "(= {term} (/ {p} {q}))")
                }
            };
            if let Some(before) = before {
                let (left, right) = (on.function(i, Place::end(before)), on.function(i, Place::start(s)));
                let _ = write!(goals, "(= {left} {right})");
            }
            before = Some(s);
        }
    }
    Some(on.section(&format!("(let r {})", index.ratio()), &goals))
}

fn polynomial(p: &Polynomial<BigRational>) -> String {
    let terms: String =
        p.coefficients().iter().enumerate().map(|(e, c)| format!(" (* {c} (^ u {e}))")).collect();
    format!("(+{terms})")
}

pub(super) fn formal(claim: &str, amended: bool) -> Option<Formal> {
    const EXAMPLES: [&str; 14] =
        ["U0", "U1", "U2", "U3", "U4", "U5", "U6", "U7", "U8", "U9", "U10", "U11", "U12", "U13"];
    match (claim, amended) {
        ("Conj3.1.strong" | "Conj3.1.weak", true) => {
            let sections = [OUTER, MIDDLE, CONTINUITY, AT_LAST_KNOT];
            Some(Formal::on_all_knots(1..=2, &[BECAUSE, DROPS].concat(), &sections))
        }
        ("Conj3.1.strong.continuous" | "Conj3.1.weak.continuous", true) => {
            Some(Formal::on_all_knots(1..=2, BECAUSE, &[OUTER, MIDDLE, CONTINUITY]))
        }
        ("Rem5.1.conj", true) => {
            let mut instances = all(&EXAMPLES);
            instances.retain(|instance| instance.degree > 0);
            let section = |instance| {
                let on = Example::new(instance);
                instance.indices.iter().filter_map(|index| unimodal(&on, index)).collect::<String>()
            };
            Some(Formal {
                scope: Scope::Instance,
                degrees: vec![1, 2, 3],
                because: "On each of its spans a function rises, or falls, or has the derivative P/Q that is given, where the coefficients of P change their sign exactly once, from + to −, and those of Q are positive: by Descartes' rule it rises and then falls. From span to span it is continuous, and no span on which it rises comes after one on which it falls. So it has one local maximum, which is its only largest value.".to_owned(),
                sections: instances.iter().map(section).collect(),
            })
        }
        _ => None,
    }
}

/// What is proved for one degree.
pub(super) fn formal_for_degree(claim: &str, k: usize) -> Option<Formal> {
    match (claim, k) {
        ("Conj3.1.strong.continuous" | "Conj3.1.weak.continuous", 1 | 2) => {
            Some(Formal::on_all_knots(k..=k, BECAUSE, &[OUTER, MIDDLE, CONTINUITY]))
        }
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::claims::instances::instances_named;

    /// What the reason of Remark 5.1 says about the signs is so: one change where a quotient is given.
    #[test]
    fn derivatives_change_their_sign_once() {
        for name in ["U0", "U4", "U12"] {
            for instance in instances_named(name).iter().filter(|instance| instance.degree > 0) {
                for index in &instance.indices {
                    let basis = Basis::new(instance.knots.clone(), instance.degree, index.clone()).unwrap();
                    let pieces = Pieces::of(&basis);
                    for i in 0..=basis.n() {
                        let mut signs = Vec::new();
                        for span in pieces.spans().iter().filter(|span| span.functions.get(i).is_some()) {
                            let slope = span.derivative(&span.function(i));
                            let coefficients = slope.numerator().coefficients();
                            let nonzero =
                                coefficients.iter().map(Sign::of).filter(|sign| *sign != Sign::Zero);
                            let of_span: Vec<_> = nonzero.collect();
                            let changes = of_span.windows(2).filter(|pair| pair[0] != pair[1]).count();
                            assert!(changes <= 1, "{name}, {i}: {of_span:?}");
                            signs.extend([of_span[0], of_span[of_span.len() - 1]]);
                        }
                        signs.dedup();
                        assert!(
                            signs.len() <= 2 && signs.is_sorted_by(|a, b| a >= b),
                            "{name}, {i}: {signs:?}"
                        );
                    }
                }
            }
        }
    }
}
