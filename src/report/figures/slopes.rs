//! The jumps of the first derivatives at simple knots, along all α: lost regularity, and how it comes back.

use crate::analysis::knot_slopes;
use crate::meaning::{Example, examples_named};
use crate::scalar::{BigRational, integer, rational};
use crate::spline::{Basis, Index};

use super::canvas::{Dash, Drawn, Frame, GREY, Lies, PALE, Panel, Pen, PictureError, failed};
use super::layout::{Sheet, heading};
use super::notation::{alpha, indexed, knots, number};
use super::sample::float;

const NOTE: &str = "r = α/(α − 1) from 1/8 to 8 on a logarithmic scale. At α = ∞, r = 1, no derivative jumps. Jumps are computed \
exactly.";

/// Ratios from 1/8 to 8, so many from one to twice as much.
const STEPS: i64 = 8;
const OCTAVES: i64 = 3;
/// The indices that are named on the axis.
const NAMED: [&str; 7] = ["-1/7", "-1/3", "-1", "inf", "2", "4/3", "8/7"];

/// D⁺G_i^k − D⁻G_i^k at every interior knot of an instance, against r.
///
/// # Errors
/// [`PictureError`].
pub(super) fn svg(title: &str, name: &str) -> Result<String, PictureError> {
    let instance =
        examples_named(name).into_iter().next().ok_or_else(|| failed("there is no such instance"))?;
    let places: Vec<BigRational> = instance.knots.inner_stop_knots().map(|(t, _)| t.clone()).collect();
    let lines: Vec<Vec<Line>> = places.iter().map(|at| lines(&instance, at)).collect::<Result<_, _>>()?;
    let frame = Frame::of(lines.iter().flatten().flat_map(|line| line.points.iter().copied()));
    let subtitle =
        format!("D⁺G − D⁻G at the inner knots of U = {}, degree {}", knots(&instance.knots), instance.degree);
    let cells = places.len() + 1;
    Sheet { title, subtitle: &subtitle, notes: &[NOTE], cells, panel: 230 }.svg(|canvas, number_of, cell| {
        let Some(at) = places.get(number_of) else {
            let mut pens: Vec<_> = lines.iter().flatten().map(|line| (line.i, Pen::nth(line.i))).collect();
            pens.sort_by_key(|(i, _)| *i);
            pens.dedup_by_key(|(i, _)| *i);
            let entries: Vec<_> = pens.into_iter().map(|(i, pen)| (pen, indexed("G", i))).collect();
            return canvas.legend(cell, &entries);
        };
        heading(canvas, cell, &format!("k = {}, at the knot {}", instance.degree, number(at)))?;
        let panel = canvas.panel(cell, frame.padded(0.04, 0.06));
        axes(&panel)?;
        lines[number_of].iter().try_for_each(|line| panel.line(&line.points, Pen::nth(line.i)))
    })
}

/// The jump of one function at one knot.
struct Line {
    /// Of which function.
    i: usize,
    /// log₂ r, and the jump.
    points: Vec<(f64, f64)>,
}

/// All functions whose derivative jumps at the knot for some α.
fn lines(instance: &Example, at: &BigRational) -> Result<Vec<Line>, PictureError> {
    let mut jumps: Vec<Vec<(f64, f64)>> = Vec::new();
    for step in -STEPS * OCTAVES..=STEPS * OCTAVES {
        let index = Index::from_ratio(ratio(step)).map_err(failed)?;
        let basis = Basis::new(instance.knots.clone(), instance.degree, index).map_err(failed)?;
        jumps.resize(basis.n() + 1, Vec::new());
        for (i, line) in jumps.iter_mut().enumerate() {
            let slopes = knot_slopes(&basis, i).into_iter().find(|slopes| slopes.at == *at);
            if let Some((left, right)) = slopes.and_then(|slopes| Some((slopes.left?, slopes.right?))) {
                line.push((float(basis.index().ratio()).log2(), float(&(right - left))));
            }
        }
    }
    let lines =
        jumps.into_iter().enumerate().filter(|(_, points)| points.iter().any(|(_, jump)| *jump != 0.0));
    Ok(lines.map(|(i, points)| Line { i, points }).collect())
}

/// 2^(n/8) for n = `step`, straight between the powers of 2: a fraction.
fn ratio(step: i64) -> BigRational {
    let (octave, part) = (step.div_euclid(STEPS), step.rem_euclid(STEPS));
    let power = |n: i64| (0..n.abs()).fold(integer(1), |power, _| power * integer(2));
    let base = if octave < 0 { power(octave).recip() } else { power(octave) };
    base * rational(STEPS + part, STEPS)
}

fn axes(panel: &Panel<'_>) -> Drawn {
    let Frame { x: (left, right), y: (low, high) } = panel.frame;
    for text in NAMED {
        let index: Index = text.parse().map_err(failed)?;
        let x = float(index.ratio()).log2();
        panel.line(&[(x, low), (x, high)], Pen::thin(PALE, Dash::Solid))?;
        panel.text((x, low), &alpha(&index), Lies::Below, GREY)?;
    }
    for level in (-20_i32..=20).map(f64::from).filter(|level| low <= *level && *level <= high) {
        panel.line(&[(left, level), (right, level)], Pen::thin(PALE, Dash::Solid))?;
        panel.text((left, level), &format!("{level:.0}").replace('-', "−"), Lies::Left, GREY)?;
    }
    panel.text((left, low), "α =", Lies::Left, GREY)?;
    panel.line(&[(left, 0.0), (right, 0.0)], Pen::thin(GREY, Dash::Solid))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ratios_are_between_powers_of_two() {
        assert_eq!(
            [0, 8, -8, 4, -4].map(ratio),
            [rational(1, 1), rational(2, 1), rational(1, 2), rational(3, 2), rational(3, 4)]
        );
    }
}
