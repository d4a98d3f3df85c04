//! Figures 1 to 3: the weights φ_α, those that are to be compared in one panel.

use plotters::style::BLACK;

use crate::scalar::{integer, rational};
use crate::spline::{Index, KnotVector, weight};

use super::canvas::{Dash, Dot, Drawn, Frame, Panel, Pen, PictureError, failed};
use super::layout::{Sheet, heading, knot_axis, levels};
use super::notation::alpha;
use super::sample::{float, polygon};

const NOTES: &[&str] = &[
    "φ is 0 outside of [a, b). At b ○ is the limit from the left, ● the value.",
    "Which α the paper draws cannot be read in the scan: these are ours.",
];

/// φ_α(x, a, b) for x from `from` to `to`.
#[derive(Debug)]
pub(super) struct Weights {
    pub(super) interval: (i64, i64),
    pub(super) from: i64,
    pub(super) to: i64,
    /// The values of α, panel by panel.
    pub(super) panels: &'static [&'static [&'static str]],
}

/// The figure.
///
/// # Errors
/// [`PictureError`].
pub(super) fn svg(title: &str, weights: &Weights) -> Result<String, PictureError> {
    let (a, b) = weights.interval;
    let knots = KnotVector::new([a, b].map(|end| rational(end, 1)).to_vec()).map_err(failed)?;
    let subtitle = format!("φ(x, {a}, {b}) for x from {} to {}", weights.from, weights.to).replace('-', "−");
    let all: Vec<Vec<Index>> = weights
        .panels
        .iter()
        .map(|panel| panel.iter().map(|text| text.parse()).collect::<Result<_, _>>())
        .collect::<Result<_, _>>()
        .map_err(failed)?;
    // Beside each panel, a cell says which of its lines is which.
    let sheet = Sheet { title, subtitle: &subtitle, notes: NOTES, cells: 2 * all.len(), panel: 210 };
    sheet.svg(|canvas, number, cell| {
        let pens: Vec<(Pen, &Index)> =
            all[number / 2].iter().enumerate().map(|(i, index)| (Pen::nth(i), index)).collect();
        if number % 2 == 1 {
            let entries: Vec<_> =
                pens.iter().map(|(pen, index)| (*pen, format!("α = {}", alpha(index)))).collect();
            return canvas.legend(cell, &entries);
        }
        let names: Vec<_> = all[number / 2].iter().map(alpha).collect();
        heading(canvas, cell, &format!("α = {}", names.join(", ")))?;
        let frame = Frame {
            x: (float(&rational(weights.from, 1)), float(&rational(weights.to, 1))),
            y: (-0.06, 1.1),
        };
        let panel = canvas.panel(cell, frame);
        levels(&panel, &[integer(0), rational(1, 2), integer(1)])?;
        knot_axis(&panel, &knots, 0.0)?;
        for (pen, index) in pens {
            graph(&panel, &knots, index, pen)?;
        }
        ends(&panel, &knots)
    })
}

fn graph(panel: &Panel<'_>, knots: &KnotVector, index: &Index, pen: Pen) -> Drawn {
    let (a, b) = (knots.first(), knots.last());
    let ratio = float(index.ratio());
    let tolerance = (panel.unit.0 / 2.0, panel.unit.1 / 2.0);
    let at = |x: f64| (x, weight(&ratio, &x, a, b).0);
    panel.line(&polygon(at, (float(a), float(b)), tolerance), pen)
}

/// Outside of the interval all are 0, and at b they jump from 1 to 0.
fn ends(panel: &Panel<'_>, knots: &KnotVector) -> Drawn {
    let (a, b) = (float(knots.first()), float(knots.last()));
    for (from, to) in [(panel.frame.x.0, a), (b, panel.frame.x.1)] {
        panel.line(&[(from, 0.0), (to, 0.0)], Pen::thick(BLACK, Dash::Solid))?;
    }
    panel.dot((b, 1.0), Dot::Open, BLACK)?;
    panel.dot((b, 0.0), Dot::Filled, BLACK)
}
