//! Figures 4 to 21: all functions of a basis, a panel for each α.

use crate::meaning::Example;
use crate::scalar::{BigRational, integer, rational};
use crate::spline::{Basis, HasWeights, Side, Span, WeightKind};

use super::canvas::{Canvas, Cell, Dot, Drawn, Frame, Panel, Pen, PictureError};
use super::labels::{Label, Named};
use super::layout::{Sheet, heading, knot_axis, levels};
use super::notation::{alpha, indexed, knots};
use super::sample::{float, polygon};

const NOTE: &str = "Below the axis: knots, and how often they occur. ● value (from the right; at the last knot from the left), \
○ limit from the left.";

/// G_i on a span, at an x of its closure. Forms are summed exactly: their terms may cancel in floats.
fn value<W: HasWeights>(basis: &Basis<W>, i: usize, span: Span, x: f64) -> f64 {
    match basis.weights().kind() {
        WeightKind::Index(_) => super::sample::value(basis, i, span, x),
        WeightKind::Forms(_) => {
            let at = BigRational::from_float(x).and_then(|x| basis.active(span, &x).ok());
            at.map_or(f64::NAN, |active| active.get(i).map(float).unwrap_or_default())
        }
    }
}

/// The figure of an instance.
///
/// # Errors
/// [`PictureError`].
pub(super) fn svg(title: &str, instance: &Example) -> Result<String, PictureError> {
    let subtitle = format!("Basis functions of degree {} on U = {}", instance.degree, knots(&instance.knots));
    let on: Vec<_> = instance.instances().collect();
    let sheet = Sheet { title, subtitle: &subtitle, notes: &[NOTE], cells: on.len(), panel: 190 };
    sheet.svg(|canvas, number, cell| {
        let (on, k) = (&on[number], instance.degree);
        let missing = || super::canvas::failed("an instance has a basis");
        let basis = on.any_basis_of(&on.weights, k).ok_or_else(missing)?;
        let weights =
            on.weights.index().map_or_else(|| on.weights.to_string(), |own| format!("α = {}", alpha(own)));
        panel(canvas, cell, &format!("k = {k}, {weights}"), &basis)
    })
}

fn panel<W: HasWeights>(canvas: &Canvas<'_>, cell: Cell, head: &str, basis: &Basis<W>) -> Drawn {
    heading(canvas, cell, head)?;
    let x = (float(basis.knots().first()), float(basis.knots().last()));
    let frame = Frame { x, y: (0.0, 1.0) }.padded(0.03, 0.0);
    let panel = canvas.panel(cell, Frame { y: (-0.06, 1.14), ..frame });
    levels(&panel, &[integer(0), rational(1, 2), integer(1)])?;
    knot_axis(&panel, basis.knots(), 0.0)?;
    let mut labels = Vec::new();
    for i in 0..=basis.n() {
        let pen = Pen::nth(i);
        let line = graph(&panel, basis, i, pen)?;
        for (at, left, _) in jumps(basis, i) {
            panel.dot((float(&at), float(&left)), Dot::Open, pen.colour)?;
        }
        if !line.is_empty() {
            labels.push(Label { text: indexed("G", i), colour: pen.colour, named: Named::Line(line, pen) });
        }
    }
    // The value of one function in the limit of another: the dot goes into the ring.
    for i in 0..=basis.n() {
        values(&panel, basis, i, Pen::nth(i))?;
    }
    panel.labels(&labels)
}

/// The inner knots at which a function jumps, with its limits.
fn jumps<W: HasWeights>(basis: &Basis<W>, i: usize) -> Vec<(BigRational, BigRational, BigRational)> {
    let limits = |(t, _): (&BigRational, usize)| {
        let [left, right] = [Side::Left, Side::Right].map(|side| basis.values(t, side)[i].clone());
        (left != right).then(|| (t.clone(), left, right))
    };
    basis.knots().inner_stop_knots().filter_map(limits).collect()
}

/// Draws the graph over the support, broken where the function jumps, and gives its points.
pub(in crate::report) fn graph<W: HasWeights>(
    panel: &Panel<'_>,
    basis: &Basis<W>,
    i: usize,
    pen: Pen,
) -> Result<Vec<(f64, f64)>, PictureError> {
    let knots = basis.knots();
    let (low, high) = basis.support(i);
    let tolerance = (panel.unit.0 / 2.0, panel.unit.1 / 2.0);
    let Frame { x: (left, right), y: (bottom, top) } = panel.frame;
    let (mut drawn, mut line) = (Vec::new(), Vec::new());
    for span in knots.spans() {
        let (start, end) = (knots.t(span.index()), knots.t(span.index() + 1));
        if start < low || high < end {
            continue;
        }
        let (from, to) = (float(start).max(left), float(end).min(right));
        if from >= to {
            continue;
        }
        let limit = |side| basis.values(start, side)[i].clone();
        if *start != *knots.first() && !line.is_empty() && limit(Side::Left) != limit(Side::Right) {
            panel.line(&std::mem::take(&mut line), pen)?;
        }
        // What is outside of the frame is left out.
        for point in polygon(|x| (x, value(basis, i, span, x)), (from, to), tolerance) {
            if (bottom..=top).contains(&point.1) {
                drawn.push(point);
                line.push(point);
            } else if !line.is_empty() {
                panel.line(&std::mem::take(&mut line), pen)?;
            }
        }
    }
    if !line.is_empty() {
        panel.line(&line, pen)?;
    }
    Ok(drawn)
}

/// The values at jumps, and at the ends of [t_0, t_m] where the function is not 0.
fn values<W: HasWeights>(panel: &Panel<'_>, basis: &Basis<W>, i: usize, pen: Pen) -> Drawn {
    for (at, _, right) in jumps(basis, i) {
        panel.dot((float(&at), float(&right)), Dot::Filled, pen.colour)?;
    }
    for (end, side) in [(basis.knots().first(), Side::Right), (basis.knots().last(), Side::Left)] {
        let value = &basis.values(end, side)[i];
        if *value != integer(0) {
            panel.dot((float(end), float(value)), Dot::Filled, pen.colour)?;
        }
    }
    Ok(())
}
