//! Refutations of the conjectures on maxima.

use std::fmt::Write as _;

use crate::analysis::{Pieces, Shape};
use crate::claims::formal::place::Place;
use crate::scalar::{BigRational, RationalAlgebra, integer, rationals_between};
use crate::spline::{Index, Side};

use super::Refuted;
use super::found::Found;

pub(super) fn refutation(claim: &str, found: &Found<'_>) -> Refuted {
    Some(match claim {
        "Conj3.1.strong" | "Conj3.1.weak" | "Rem5.1.conj" => rises_and_drops(found, found.natural("i")?)?,
        "Conj3.1.strong.continuous" => two_maxima(found, found.natural("i")?)?,
        "Conj3.1.weak.continuous" => equal_maxima(found, found.natural("i")?)?,
        _ => return None,
    })
}

/// G_i rises on all of its support, to the limit 1 at the end, and is 0 from there on: it has no maximum.
fn rises_and_drops(found: &Found<'_>, i: usize) -> Refuted {
    let (k, knots) = (found.k(), found.knots());
    let (low, high) = found.basis.support(i);
    let mut goals = String::new();
    for span in knots.spans() {
        let (start, end) = knots.ends(span).ok()?;
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

/// A simple point close to an extremum.
fn close_to(place: &crate::analysis::Location) -> BigRational {
    let (lo, hi) = place.interval();
    rationals_between(lo, hi).next().unwrap_or_else(|| lo.clone())
}

/// Between two indices the largest value changes from one side of the point c to the other.
fn equal_maxima(found: &Found<'_>, i: usize) -> Refuted {
    let k = found.k();
    let index = |name| found.text(name)?.parse::<Index>().ok();
    let (from, to) = (index("α from")?, index("α to")?);
    let (c, d) = (found.number("c")?, found.number("d")?);
    // A span is on one side of c as a whole: minima are at knots.
    found.knots().inner_stop_knots().find(|(x, _)| **x == c)?;
    let value = |x: &BigRational, side| found.value(x, side, i);
    let mut goals = format!("(> {} {})", value(&d, Side::Right)?, value(&c, Side::Right)?);
    for (x, _) in found.knots().inner_stop_knots() {
        let _ = write!(goals, "(= {} {})", value(x, Side::Left)?, value(x, Side::Right)?);
    }
    let between = format!("(nonnegative y) (let r (/ (+ {} (* {} y)) (+ 1 y)))", from.ratio(), to.ratio());
    let mut sections = found.section_over(&between, &goals);
    for (index, which) in [(from, "first"), (to, "second")] {
        let higher = found.text(&format!("side at the {which} α"))?;
        let height = found.number(&format!("value at the {which} α"))?;
        let basis = found.basis.with_index(index.clone());
        let shape = Shape::of(&Pieces::of(&basis), i);
        let on_left = |x: &BigRational| x < &c;
        // Points close to the maxima, high enough on the higher side: or the values could not have been told apart.
        let maxima: Vec<_> = shape.local_maxima().map(|maximum| close_to(&maximum.place)).collect();
        let peak = maxima
            .iter()
            .find(|x| on_left(x) == (higher == "left") && basis.values(x, Side::Right)[i] > height)?;
        let mut goals = format!("(> {} {height})", value(peak, Side::Right)?);
        let (low, high) = basis.support(i);
        for span in basis.knots().spans() {
            let (start, end) = basis.knots().ends(span).ok()?;
            let on_lower_side = if higher == "left" { &c <= start } else { end <= &c };
            if on_lower_side && low <= start && end <= high {
                let value = Place::inside(span.index()).value("G", i, k);
                // Every u > 0 is a multiple of the u of the maximum: with that as the unit the proof is short.
                let unit =
                    maxima.iter().find(|x| start < *x && *x < end).and_then(|x| (x - start).over(&(end - x)));
                let unit = unit.unwrap_or_else(|| integer(1));
                let _ = write!(goals, "(> {height} (at ((u (* {unit} u))) {value}))");
            }
        }
        sections += &found.section_over(&format!("(let r {})", index.ratio()), &goals);
    }
    Some((
        "The function is continuous in x, and for each x in r, for the ratios r of all indices from the first to the second (first section). For the first index it exceeds a value on one side of c and not on the other, where it is smaller in all points, and so at c at most equal to it; for the second index it is the other side. So for some index in between the largest value on the left of c, c included, is that on the right of it. It is not taken at c, since there is a point d with a larger value for each of these indices: so it is taken on either side.",
        sections,
    ))
}
