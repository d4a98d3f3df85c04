//! Refutations of the conjectures on maxima.

use std::fmt::Write as _;

use crate::claims::formal::place::Place;
use crate::scalar::{BigRational, integer};
use crate::spline::Side;

use super::Refuted;
use super::found::Found;

pub(super) fn refutation(claim: &str, found: &Found<'_>) -> Refuted {
    Some(match claim {
        "Conj3.1.strong" | "Conj3.1.weak" | "Rem5.1.conj" => rises_and_drops(found, found.natural("i")?)?,
        "Conj3.1.strong.continuous" => two_maxima(found, found.natural("i")?)?,
        _ => return None,
    })
}

/// G_i rises on all of its support, to the limit 1 at the end, and is 0 from there on: it has no maximum.
fn rises_and_drops(found: &Found<'_>, i: usize) -> Refuted {
    let (k, knots) = (found.k(), found.knots());
    let (low, high) = found.basis.support(i);
    let mut goals = String::new();
    for span in knots.spans() {
        let (start, end) = knots.ends(span);
        if low <= start && end <= high {
            let _ = write!(goals, "(> {} 0)", Place::inside(span.index()).value("DG", i, k));
            if start != low {
                let before = found.value(start, Side::Left, i)?;
                let _ = write!(goals, "(= {before} {})", found.value(start, Side::Right, i)?);
            }
        }
    }
    let (limit, value) = (found.value(high, Side::Left, i)?, found.value(high, Side::Right, i)?);
    let _ = write!(goals, "(= {limit} 1) (= {value} 0)");
    Some((
        "The function is continuous and rises on all of its support, tends to 1 at the end of it, and is 0 there and beyond: its supremum is not attained, and it has no local maximum.",
        found.section(&goals),
    ))
}

/// A knot where the continuous function falls before and rises after.
fn two_maxima(found: &Found<'_>, i: usize) -> Refuted {
    let knots = found.knots();
    let slope = |x: &BigRational, side| found.basis.jets(x, side, 1)[i].coefficients()[1].clone();
    let valley = knots
        .inner_stop_knots()
        .map(|(x, _)| x)
        .find(|x| slope(x, Side::Left) < integer(0) && integer(0) < slope(x, Side::Right))?;
    let mut goals = format!(
        "(< {} 0) (> {} 0) (> {} 0)",
        found.slope(valley, Side::Left, i)?,
        found.slope(valley, Side::Right, i)?,
        found.value(valley, Side::Right, i)?
    );
    for (x, _) in knots.inner_stop_knots() {
        let value = |side| found.value(x, side, i);
        let _ = write!(goals, "(= {} {})", value(Side::Left)?, value(Side::Right)?);
    }
    Some((
        "The function is continuous, and positive at a knot where it falls from the left and rises to the right: on the part of its support on either side it is largest elsewhere than at that knot, which makes two local maxima.",
        found.section(&goals),
    ))
}
