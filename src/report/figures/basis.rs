//! Figures 4 to 21: all functions of a basis, a panel for each α.

use std::cmp::Ordering;

use crate::analysis::{Pieces, Shape};
use crate::claims::Instance;
use crate::scalar::{BigRational, integer, rational};
use crate::spline::{Basis, Side};

use super::canvas::{Canvas, Cell, Dot, Drawn, Frame, Lies, Panel, Pen, PictureError};
use super::layout::{Sheet, heading, knot_axis, levels};
use super::notation::{alpha, indexed, knots};
use super::sample::{float, polygon, value};

const NOTE: &str = "Below the axis: knots, and how often they occur. ● value (from the right; at the last knot from the left), \
○ limit from the left.";

/// The figure of an instance.
///
/// # Errors
/// [`PictureError`].
pub(super) fn svg(title: &str, instance: &Instance) -> Result<String, PictureError> {
    let subtitle = format!("Basis functions of degree {} on U = {}", instance.degree, knots(&instance.knots));
    let sheet = Sheet { title, subtitle: &subtitle, note: NOTE, cells: instance.indices.len(), panel: 190 };
    sheet.svg(|canvas, number, cell| {
        let basis = Basis::new(instance.knots.clone(), instance.degree, instance.indices[number].clone())
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
    for (i, shape) in shapes.iter().enumerate() {
        let pen = Pen::nth(i);
        graph(&panel, basis, i, pen)?;
        limits(&panel, shape, pen)?;
        if let Some(top) = top(shape) {
            panel.text(top, &indexed("G", i), Lies::Above, pen.colour)?;
        }
    }
    // The value of one function in the limit of another: the dot goes into the ring.
    shapes.iter().enumerate().try_for_each(|(i, shape)| values(&panel, basis, i, shape, Pen::nth(i)))
}

/// The graph over the support, broken where the function jumps.
pub(in crate::report) fn graph(panel: &Panel<'_>, basis: &Basis, i: usize, pen: Pen) -> Drawn {
    let knots = basis.knots();
    let (low, high) = basis.support(i);
    let tolerance = (panel.unit.0 / 2.0, panel.unit.1 / 2.0);
    let Frame { x: (left, right), y: (bottom, top) } = panel.frame;
    let mut line: Vec<(f64, f64)> = Vec::new();
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
                line.push(point);
            } else if !line.is_empty() {
                panel.line(&std::mem::take(&mut line), pen)?;
            }
        }
    }
    if line.is_empty() { Ok(()) } else { panel.line(&line, pen) }
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

/// The middle of the highest maximum; where the supremum is a limit at a jump, that limit.
fn top(shape: &Shape) -> Option<(f64, f64)> {
    let maxima = shape.local_maxima().map(|maximum| {
        let (lo, hi) = maximum.place.interval();
        // Close enough to tell which of two is the higher.
        let (height, _) = maximum.height().bounds_within(&rational(1, 1 << 60));
        ((lo + hi) / integer(2), height)
    });
    let limits = shape.jumps().iter().map(|jump| (jump.at.clone(), jump.left.clone()));
    let higher = |a: &(BigRational, BigRational), b: &(BigRational, BigRational)| match a.1.cmp(&b.1) {
        // Of two that are equally high the first.
        Ordering::Equal => b.0.cmp(&a.0),
        order => order,
    };
    maxima.chain(limits).max_by(higher).map(|(x, y)| (float(&x), float(&y)))
}
