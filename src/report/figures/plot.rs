//! Plots of an instance of one's own: its basis, or its curve, as the paper's figures are drawn, a panel for each of its weights.

use crate::analysis::{Join, joins};
use crate::meaning::{Example, Weighting};
use crate::scalar::{BigRational, integer};
use crate::spline::{Curve, HasWeights, Point, Side};

use super::basis;
use super::canvas::{Dot, Drawn, Frame, PALE, Panel, Pen, PictureError, VERMILION};
use super::curve::{control_polygon, convex_hull, point_labels};
use super::instance::can_be_seen;
use super::layout::{PANEL, Sheet, grid, heading, knot_lines};
use super::notation::{alpha, knots};
use super::sample::{curve_point, float, planar, polygon};

/// What is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Plot {
    /// All basis functions, with the knots below.
    Basis,
    /// The curve with its control polygon: in the plane, of three coordinates the first two, and of one the graph over x.
    Curve,
}

/// A plot as SVG; `None` if nothing could be seen, since numbers are too large for `f64` or too close, or if there is no curve.
///
/// ```
/// use knotproof::meaning::examples_named;
/// use knotproof::report::figures::{Plot, plot};
///
/// let svg = plot("my curve", &examples_named("C5")[0], Plot::Curve)?.expect("it has control points");
/// assert!(svg.contains("<title>my curve</title>"));
/// # Ok::<(), knotproof::report::figures::PictureError>(())
/// ```
///
/// # Errors
/// [`PictureError`], a bug of this program.
pub fn plot(title: &str, of: &Example, what: Plot) -> Result<Option<String>, PictureError> {
    if !can_be_seen(of) {
        return Ok(None);
    }
    match what {
        Plot::Basis => basis::svg(title, of).map(Some),
        Plot::Curve => curves(title, of),
    }
}

fn curves(title: &str, of: &Example) -> Result<Option<String>, PictureError> {
    let all: Vec<_> = of.curves().collect();
    let Some((_, first)) = all.first() else { return Ok(None) };
    let frames = all.iter().map(|(_, curve)| frame(curve));
    let Some(frame) =
        frames.reduce(|a, b| Frame::of([(a.x.0, a.y.0), (a.x.1, a.y.1), (b.x.0, b.y.0), (b.x.1, b.y.1)]))
    else {
        return Ok(None);
    };
    let frame = roomy(frame).padded(0.07, 0.07);
    let is_graph = first.dimension() == 1;
    let panel = if is_graph {
        220
    } else {
        let height = f64::from(PANEL) * (frame.y.1 - frame.y.0) / (frame.x.1 - frame.x.0);
        (150..=300).find(|pixels| f64::from(*pixels) >= height).unwrap_or(300)
    };
    let subtitle = match first.dimension() {
        1 => format!("Spline of degree {} on U = {}, over x", of.degree, knots(&of.knots)),
        2 => format!("Curve of degree {} on U = {}", of.degree, knots(&of.knots)),
        _ => format!("Curve of degree {} on U = {}, its first two coordinates", of.degree, knots(&of.knots)),
    };
    let mut notes = vec![match is_graph {
        true => "Dashed grey: control points, each over the average of its k knots; vertical lines: knots.",
        false => "Dashed grey: control polygon; shaded: its convex hull; small dots: the knots on the curve.",
    }];
    notes.push(
        "Red rings: corners, where the direction jumps. ● value (from the right), ○ limit from the left.",
    );
    let sheet = Sheet { title, subtitle: &subtitle, notes: &notes, cells: all.len(), panel };
    let svg = sheet.svg(|canvas, number, cell| {
        let (weights, curve) = &all[number];
        let frame = if is_graph { frame } else { frame.with_equal_scales(cell) };
        heading(canvas, cell, &format!("k = {}, {}", of.degree, name(weights)))?;
        draw(&canvas.panel(cell, frame), curve)
    })?;
    Ok(Some(svg))
}

fn name(weights: &Weighting) -> String {
    weights.index().map_or_else(|| weights.to_string(), |own| format!("α = {}", alpha(own)))
}

/// Where a point of the curve is drawn: of one coordinate, over its x.
fn spot(x: &BigRational, point: &Point) -> (f64, f64) {
    if point.len() == 1 { (float(x), float(&point[0])) } else { planar(point) }
}

/// The control points as they are drawn: of one coordinate each over the average of t_{i+1}, …, t_{i+k}; of degree 0 in the
/// middle of its interval.
fn control_points<W>(curve: &Curve<W>) -> Vec<Point> {
    let (knots, k) = (curve.basis().knots(), curve.basis().degree());
    let own = |(i, point): (usize, &Point)| match point.as_slice() {
        [value] => {
            let near = if k == 0 { i..=i + 1 } else { i + 1..=i + k };
            let count = integer(near.clone().count());
            vec![near.map(|j| knots.t(j)).sum::<BigRational>() / count, value.clone()]
        }
        _ => point[..2].to_vec(),
    };
    curve.points().iter().enumerate().map(own).collect()
}

/// What contains the control points and the curve, which without open knots may leave their hull.
fn frame<W: HasWeights>(curve: &Curve<W>) -> Frame {
    /// On each span.
    const SAMPLES: usize = 16;
    let knots = curve.basis().knots();
    let mut all: Vec<_> = control_points(curve).iter().map(planar).collect();
    for span in knots.spans() {
        let (start, end) = (knots.t(span.index()), knots.t(span.index() + 1));
        for s in 0..=SAMPLES {
            let x = start + (end - start) * integer(s) / integer(SAMPLES);
            let side = if s == SAMPLES { Side::Left } else { Side::Right };
            all.push(spot(&x, &curve.point(&x, side)));
        }
    }
    Frame::of(all)
}

/// The same with some room, where all points are on a line across or up.
fn roomy(frame: Frame) -> Frame {
    let (width, height) = (frame.x.1 - frame.x.0, frame.y.1 - frame.y.0);
    // A share of the other side, so that nothing is lost in rounding.
    let least = if width.max(height) > 0.0 { width.max(height) / 4.0 } else { 1.0 };
    let wide =
        |(low, high): (f64, f64)| if high - low < least { (low - least, high + least) } else { (low, high) };
    Frame { x: wide(frame.x), y: wide(frame.y) }
}

fn draw<W: HasWeights>(panel: &Panel<'_>, curve: &Curve<W>) -> Drawn {
    let (knots, pen) = (curve.basis().knots(), Pen::nth(0));
    let points = control_points(curve);
    let is_graph = curve.dimension() == 1;
    if !is_graph {
        let corners: Vec<_> = convex_hull(&points).iter().map(planar).collect();
        panel.area(&corners, PALE)?;
    }
    grid(panel)?;
    if is_graph {
        knot_lines(panel, knots)?;
    }
    control_polygon(panel, &points)?;
    let tolerance = (panel.unit.0 / 2.0, panel.unit.1 / 2.0);
    let joins = joins(curve);
    let at_knot = |t: &BigRational| joins.iter().find(|join| join.knot == *t && !join.closing);
    let mut line = Vec::new();
    for span in knots.spans() {
        let (start, end) = (knots.t(span.index()), knots.t(span.index() + 1));
        if at_knot(start).is_some_and(|join| !join.g0()) {
            panel.line(&std::mem::take(&mut line), pen)?;
        }
        let at = |x: f64| {
            let (first, second) = curve_point(curve, span, x);
            if is_graph { (x, first) } else { (first, second) }
        };
        line.extend(polygon(at, (float(start), float(end)), tolerance));
    }
    panel.line(&line, pen)?;
    for join in joins.iter().filter(|join| !join.closing) {
        let [before, after] = [&join.before, &join.after].map(|branch| spot(&join.knot, &branch.point));
        if !join.g0() {
            panel.dot(before, Dot::Open, pen.colour)?;
            panel.dot(after, Dot::Filled, pen.colour)?;
        } else if is_corner(curve, join) {
            panel.dot(after, Dot::Open, VERMILION)?;
        } else {
            panel.dot(after, Dot::Small, pen.colour)?;
        }
    }
    panel.labels(&point_labels(&points))
}

/// Does the direction jump? Of a graph that is the slope.
fn is_corner<W>(curve: &Curve<W>, join: &Join) -> bool {
    if curve.dimension() == 1 {
        join.before.velocity != join.after.velocity
    } else {
        join.g1() == Some(false)
    }
}
