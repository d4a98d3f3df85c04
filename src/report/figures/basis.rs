//! Figures 4 to 21: all functions of a basis, a panel for each α.

use crate::analysis::{Pieces, Shape};
use crate::meaning::Example;
use crate::scalar::{integer, rational};
use crate::spline::{Basis, Side};

use super::canvas::{Canvas, Cell, Dot, Drawn, Frame, Panel, Pen, PictureError};
use super::labels::{Label, Named};
use super::layout::{Sheet, heading, knot_axis, levels};
use super::notation::{alpha, indexed, knots};
use super::sample::{float, polygon, value};

const NOTE: &str = "Below the axis: knots, and how often they occur. ● value (from the right; at the last knot from the left), \
○ limit from the left.";

/// The figure of an instance.
///
/// # Errors
/// [`PictureError`].
pub(super) fn svg(title: &str, instance: &Example) -> Result<String, PictureError> {
    let subtitle = format!("Basis functions of degree {} on U = {}", instance.degree, knots(&instance.knots));
    let indices: Vec<_> = instance.indices().collect();
    let sheet = Sheet { title, subtitle: &subtitle, notes: &[NOTE], cells: indices.len(), panel: 190 };
    sheet.svg(|canvas, number, cell| {
        let basis = Basis::new(instance.knots.clone(), instance.degree, indices[number].clone())
            .map_err(super::canvas::failed)?;
        panel(canvas, cell, &basis)
    })
}

fn panel(canvas: &Canvas<'_>, cell: Cell, basis: &Basis) -> Drawn {
    heading(canvas, cell, &format!("k = {}, α = {}", basis.degree(), alpha(basis.index())))?;
    let x = (float(basis.knots().first()), float(basis.knots().last()));
    let frame = Frame { x, y: (0.0, 1.0) }.padded(0.03, 0.0);
    let panel = canvas.panel(cell, Frame { y: (-0.06, 1.14), ..frame });
    levels(&panel, &[integer(0), rational(1, 2), integer(1)])?;
    knot_axis(&panel, basis.knots(), 0.0)?;
    let pieces = Pieces::of(basis);
    let shapes: Vec<Shape> = (0..=basis.n()).map(|i| Shape::of(&pieces, i)).collect();
    let mut labels = Vec::new();
    for (i, shape) in shapes.iter().enumerate() {
        let pen = Pen::nth(i);
        let line = graph(&panel, basis, i, pen)?;
        limits(&panel, shape, pen)?;
        if !line.is_empty() {
            labels.push(Label { text: indexed("G", i), colour: pen.colour, named: Named::Line(line, pen) });
        }
    }
    // The value of one function in the limit of another: the dot goes into the ring.
    for (i, shape) in shapes.iter().enumerate() {
        values(&panel, basis, i, shape, Pen::nth(i))?;
    }
    panel.labels(&labels)
}

/// Draws the graph over the support, broken where the function jumps, and gives its points.
pub(in crate::report) fn graph(
    panel: &Panel<'_>,
    basis: &Basis,
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

/// The limits from the left at jumps.
fn limits(panel: &Panel<'_>, shape: &Shape, pen: Pen) -> Drawn {
    let mut jumps = shape.jumps().iter();
    jumps.try_for_each(|jump| panel.dot((float(&jump.at), float(&jump.left)), Dot::Open, pen.colour))
}

/// The values at jumps, and at the ends of [t_0, t_m] where the function is not 0.
fn values(panel: &Panel<'_>, basis: &Basis, i: usize, shape: &Shape, pen: Pen) -> Drawn {
    for jump in shape.jumps() {
        panel.dot((float(&jump.at), float(&jump.right)), Dot::Filled, pen.colour)?;
    }
    for (end, side) in [(basis.knots().first(), Side::Right), (basis.knots().last(), Side::Left)] {
        let value = &basis.values(end, side)[i];
        if *value != integer(0) {
            panel.dot((float(end), float(value)), Dot::Filled, pen.colour)?;
        }
    }
    Ok(())
}
