//! Refutations of sections 3 and 4 and of their proofs: bases and curves.

use crate::claims::formal::place::Place;
use crate::spline::Side;

use super::Refuted;
use super::found::{Found, differ, living};

pub(super) fn refutation(claim: &str, found: &Found<'_>) -> Refuted {
    let (k, knots, n) = (found.k(), found.knots(), found.basis.n());
    let t_0 = knots.first();
    let x = || found.number("x");
    let i = || found.natural("i").or_else(|| found.natural("j"));
    Some(match claim {
        "T3.5.1" | "proof.P4.1.1.iff" | "P4.1.1" => {
            let value = found.value(&x()?, Side::Right, i()?)?;
            (
                "x is not in the interval of the claim, and the function is positive there.",
                found.section(&format!("(> {value} 0)")),
            )
        }
        "T3.5.3" => {
            let span = knots.span_at(&x()?, Side::Right)?.index();
            let sum = found.at(&x()?, Side::Right, |place| {
                let functions: Vec<_> = living(knots, span, k).map(|i| place.value("G", i, k)).collect();
                format!("(+ {})", functions.join(" "))
            })?;
            (
                "All functions that exist and live on the span of x have a sum less than 1.",
                found.section(&format!("(< {sum} 1)")),
            )
        }
        "T3.5.4" | "P4.3" => {
            let (x, i) = (x()?, i()?);
            let difference = |i: usize| {
                let left = found.value(&knots.mirror(&x), Side::Right, i)?;
                let right = found.value(&x, Side::Right, n - i)?;
                Some(format!("(- {left} (at ((r (/ 1 r))) {right}))"))
            };
            match claim {
                "T3.5.4" => (
                    "Left and right side of the claim for i at x, with 1/r for the index 1 − α, differ.",
                    found.section(&differ(&difference(i)?, "0")),
                ),
                _ => (
                    "The differences of the left and the right side of T3.5.4, for i and for n − i, are not the same. Take a polygon on a line, with d_{n−i} = −d_i = 1 and all other d = 0: it is symmetric, and the curve for 1 − α at x and the mirror image of the curve for α differ by the difference of these.",
                    found.section(&differ(&difference(i)?, &difference(n - i)?)),
                ),
            }
        }
        "P3.1.3" | "P4.2.1" => {
            let (x, i) = (x()?, i()?);
            let wanted = usize::from(if x == *t_0 { i == 0 } else { i == n });
            let value = found.value(&x, Side::Right, i)?;
            (
                "The value of the function at the end of the knots is not the one of the claim.",
                found.section(&differ(&value, &wanted.to_string())),
            )
        }
        "P3.3.1" | "P3.3.2" => {
            let (x, i) = (x()?, i()?);
            let value = found.value(&x, Side::Left, i)?;
            if x != *knots.last() {
                return None;
            }
            match (claim, i) {
                // The functions of degree k − 1 on their own knots, B.
                ("P3.3.1", i) if i + 1 == k => {
                    let below: String = knots.knots()[1..knots.m()].iter().map(|t| format!(" {t}")).collect();
                    let limit = Place::end(i).on('B').value("G", i, i);
                    (
                        "At b, the limit of B_{k−1}^k is 0; on the right side w is 0 by definition (a ≤ x < b does not hold), and what remains is B_{k−1}^{k−1}, on the knots B, with the limit 1.",
                        found.section_with(
                            &format!("(knots B 0{below})"),
                            &format!("(= {value} 0) (= {limit} 1)"),
                        ),
                    )
                }
                ("P3.3.2", 0) => (
                    "At b, the function is 0, as a limit and by definition; on the right side w is 0 by definition (a ≤ x < b does not hold), so that for i = 0 it is 1.",
                    found.section(&format!("(= {value} 0)")),
                ),
                _ => return None,
            }
        }
        "L3.8" | "L3.9" => end_relations(claim, found)?,
        "L3.10" | "T3.11.3a" | "T3.11.3b" => {
            let side = if x()? == *t_0 { Side::Right } else { Side::Left };
            let value = found.slope(&x()?, side, i()?)?;
            ("The claim says that this derivative is 0.", found.section(&differ(&value, "0")))
        }
        "T3.11.2" => {
            let value = |side| found.value(&x()?, side, i()?);
            (
                "The limit from the left is not the value: the difference quotients from the left diverge.",
                found.section(&differ(&value(Side::Left)?, &value(Side::Right)?)),
            )
        }
        "P4.2.2" => {
            let (low, high) = if x()? == *t_0 { (0, k + 1) } else { (n, knots.m()) };
            (
                "The formula of the claim divides by the difference of these two knots, which is 0.",
                found.section(&format!("(= (t A {low}) (t A {high}))")),
            )
        }
        "proof.T3.5.2.cover" => {
            let (i, x) = (i()?, x()?);
            let moved = &x - t_0;
            (
                "x is the end of the one interval and the beginning of the other, and lies between t_i and t_{i+k+1}.",
                found.section(&format!(
                    "(= (t A {}) {moved}) (= (t A {}) {moved}) (< (t A {i}) {moved}) (> (t A {}) {moved})",
                    i + k,
                    i + 1,
                    i + k + 1
                )),
            )
        }
        "proof.P3.2.induction" => {
            let span = knots.spans().next()?.index();
            let place = Place::inside(span);
            let (g, h) = (place.value("G", 0, k), place.value("G", 1, k));
            let orders: String =
                living(knots, span, k).map(|i| format!("(order {i} {k} {place} {i})")).collect();
            (
                "On the only span the functions have the orders 0, 1, … at its first knot, and so are independent; with c_0 = G_1 and c_1 = −G_0 the sum is 0, and c_0 is positive where G_0 is.",
                found.section(&format!("{orders} (= (+ (* {h} {g}) (* (- {g}) {h})) 0) (> {h} 0) (> {g} 0)")),
            )
        }
        _ => return None,
    })
}

/// One of the equations of L3.8 or L3.9 fails: the sum of the squares of the differences is positive.
fn end_relations(claim: &str, found: &Found<'_>) -> Refuted {
    let (k, n, q, x) = (found.k(), found.basis.n(), found.natural("r")?, found.number("x")?);
    let side = if claim == "L3.8" { Side::Right } else { Side::Left };
    let slope = |i: usize, d: usize| found.at(&x, side, |place| place.value("DG", i, d));
    let weight = |i: usize, d: usize| {
        // The weight of an empty interval is 0 by D2.3, and so is its derivative.
        let empty = found.knots().t(i) == found.knots().t(i + d);
        if empty { Some("0".to_owned()) } else { found.at(&x, side, |place| place.value("Dw", i, d)) }
    };
    let (d, e) = (k - q, k - q - 1);
    let square = |left: String, lower: String, sign: &str, weight: String| {
        format!("(^ (- {left} ({sign} {lower} {weight})) 2)")
    };
    let squares = if claim == "L3.8" {
        let w = weight(q + 1, d)?;
        [
            square(slope(q, d)?, slope(q + 1, e)?, "-", w.clone()),
            square(slope(q + 1, d)?, slope(q + 2, e)?, "+", w),
        ]
    } else {
        let w = weight(n, d)?;
        [
            square(slope(n, d)?, slope(n, e)?, "+", w.clone()),
            square(slope(n - 1, d)?, slope(n - 1, e)?, "-", w),
        ]
    };
    Some((
        "The two equations of the claim for this r do not both hold: the sum of the squares of their differences is positive. The weight of an empty interval is 0, and so is its derivative.",
        found.section(&format!("(> (+ {}) 0)", squares.join(" "))),
    ))
}
