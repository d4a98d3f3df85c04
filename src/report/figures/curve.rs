//! Figures 22 to 33: curves with their control polygons, convex hulls and axes of symmetry.

use std::collections::BTreeSet;

use plotters::style::{BLACK, RGBColor};

use super::reflection::Reflection;
use crate::meaning::Example;
use crate::scalar::{BigRational, integer};
use crate::spline::{Basis, Curve, Index, Point};

use super::canvas::{Dash, Dot, Drawn, Frame, GREY, PALE, Panel, Pen, PictureError, failed};
use super::labels::{Label, Named};
use super::layout::{BEHIND, PANEL, Sheet, grid, heading};
use super::notation::{alpha, indexed, knots};
use super::sample::{curve_point, float, planar, polygon};

/// What is shown in one panel, and in how many.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Panels {
    /// ∞, and beside each α < 0 its conjugate.
    Conjugates,
    /// ∞ and all α < 0.
    Negative,
    /// ∞ and all α > 1.
    Positive,
    /// ∞, then α < 0 together with its conjugate, and the axis of symmetry.
    Together,
    /// The instance's own.
    Own,
}

/// The figure of these instances; with `hull` the convex hull is drawn.
///
/// # Errors
/// [`PictureError`].
pub(super) fn svg(
    title: &str,
    instances: &[Example],
    panels: Panels,
    hull: bool,
) -> Result<String, PictureError> {
    let first = instances.first().ok_or_else(|| failed("there is no such instance"))?;
    let mut all = panels.of(&first.indices().cloned().collect::<Vec<_>>());
    if !matches!(panels, Panels::Together | Panels::Own) {
        // The free cell beside α = ∞, or at the end, says which line is which.
        let place = if panels == Panels::Conjugates { 1 } else { all.len() };
        all.insert(place, Vec::new());
    }
    let vectors: Vec<String> = instances.iter().map(|instance| knots(&instance.knots)).collect();
    let subtitle = match vectors.iter().all(|vector| *vector == vectors[0]) {
        true => format!("Curves of degree {} on U = {}", first.degree, vectors[0]),
        false => "Curves of several degrees with one control polygon".to_owned(),
    };
    let points = instances.iter().flat_map(|instance| instance.points.iter().flatten());
    let frame = Frame::of(points.map(planar)).padded(0.07, 0.07);
    let height = f64::from(PANEL) * (frame.y.1 - frame.y.0) / (frame.x.1 - frame.x.0);
    let panel = (150..=300).find(|height_in_pixels| f64::from(*height_in_pixels) >= height).unwrap_or(300);
    let note = match (panels, hull) {
        (Panels::Together, _) => {
            "Dashed grey: control polygon; long dashes: axis of symmetry; small dots: the knots on the curve."
        }
        (_, true) => {
            "Dashed grey: control polygon; shaded: its convex hull; small dots: the knots on the curve."
        }
        (_, false) => "Dashed grey: control polygon; small dots: the knots on the curve.",
    };
    let mut notes = vec![note];
    if panels == Panels::Conjugates && instances.len() > 1 {
        notes.push("Of the paper's α only ∞ and −1 can be read in the scan: those of the other nine panels are ours.");
    }
    Sheet { title, subtitle: &subtitle, notes: &notes, cells: all.len(), panel }.svg(
        |canvas, number, cell| {
            if all[number].is_empty() {
                return canvas.legend(cell, &legend(instances));
            }
            let panel = canvas.panel(cell, frame.with_equal_scales(cell));
            let names: Vec<String> = all[number].iter().map(alpha).collect();
            heading(
                canvas,
                cell,
                &match names.as_slice() {
                    [one, two] => format!("k = {}, α = {one} (solid) and α = {two} (dashed)", first.degree),
                    _ => format!("{}α = {}", degree(instances), names.join(", ")),
                },
            )?;
            draw(&panel, instances, &all[number], panels, hull)
        },
    )
}

/// The degree, if there is one for all.
fn degree(instances: &[Example]) -> String {
    match instances.iter().all(|instance| instance.degree == instances[0].degree) {
        true => format!("k = {}, ", instances[0].degree),
        false => String::new(),
    }
}

impl Panels {
    /// The indices of each panel.
    fn of(self, indices: &[Index]) -> Vec<Vec<Index>> {
        let infinity = Index::infinity();
        let negative = indices.iter().filter(|index| *index.ratio() < integer(1)).cloned();
        let above = indices.iter().filter(|index| *index.ratio() > integer(1)).cloned();
        let first = std::iter::once(vec![infinity]);
        let one = |index| vec![index];
        match self {
            Self::Conjugates => first
                .chain(negative.flat_map(|index| [vec![index.clone()], vec![index.conjugate()]]))
                .collect(),
            Self::Negative => first.chain(negative.map(one)).collect(),
            Self::Positive => first.chain(above.map(one)).collect(),
            Self::Own => indices.iter().cloned().map(one).collect(),
            Self::Together => {
                first.chain(negative.map(|index| vec![index.clone(), index.conjugate()])).collect()
            }
        }
    }
}

fn legend(instances: &[Example]) -> Vec<(Pen, String)> {
    let name = |(i, instance): (usize, &Example)| (Pen::nth(i), label(instances, instance));
    let mut entries: Vec<_> = instances.iter().enumerate().map(name).collect();
    entries.push((Pen::thin(BEHIND, Dash::Short), "control polygon".to_owned()));
    entries
}

/// What tells an instance from the others: its degree, its moved control point, or nothing.
fn label(instances: &[Example], instance: &Example) -> String {
    let moved = (0..).zip(instance.points.iter().flatten()).find(|(i, point)| {
        instances.iter().any(|other| other.points.as_ref().and_then(|points| points.get(*i)) != Some(point))
    });
    match moved {
        Some((i, point)) if instances.len() > 1 => {
            let coordinates: Vec<_> = point.iter().map(ToString::to_string).collect();
            format!("{} = ({})", indexed("d", i), coordinates.join(", "))
        }
        _ if instances.len() > 1 => format!("k = {}, U = {}", instance.degree, knots(&instance.knots)),
        _ => format!("curve, k = {}", instance.degree),
    }
}

fn draw(panel: &Panel<'_>, instances: &[Example], indices: &[Index], panels: Panels, hull: bool) -> Drawn {
    let polygons: Vec<&Vec<Point>> =
        instances.iter().filter_map(|instance| instance.points.as_ref()).collect();
    if hull {
        for points in &polygons {
            let corners: Vec<_> = convex_hull(points).iter().map(planar).collect();
            panel.area(&corners, PALE)?;
        }
    }
    grid(panel)?;
    for (i, points) in polygons.iter().enumerate() {
        if !polygons[..i].contains(points) {
            control_polygon(panel, points)?;
        }
    }
    if let (Panels::Together, Some(points)) = (panels, polygons.first()) {
        axis(panel, points)?;
    }
    for (i, instance) in instances.iter().enumerate() {
        for (j, index) in indices.iter().enumerate() {
            let pen = if panels == Panels::Together { conjugate_pen(j) } else { Pen::nth(i) };
            let basis = Basis::new(instance.knots.clone(), instance.degree, index.clone()).map_err(failed)?;
            let points = instance.points.clone().unwrap_or_default();
            curve(panel, &Curve::new(basis, points).map_err(failed)?, pen)?;
        }
    }
    // Of polygons that differ in one point the ends are the same.
    let mut labels: Vec<Label> = polygons.iter().flat_map(|points| point_labels(points)).collect();
    let mut names = BTreeSet::new();
    labels.retain(|label| names.insert(label.text.clone()));
    panel.labels(&labels)
}

/// The pen of α, and that of 1 − α.
fn conjugate_pen(j: usize) -> Pen {
    Pen { dash: if j == 0 { Dash::Solid } else { Dash::Long }, ..Pen::nth(j) }
}

pub(super) fn control_polygon(panel: &Panel<'_>, points: &[Point]) -> Drawn {
    let corners: Vec<_> = points.iter().map(planar).collect();
    panel.line(&corners, Pen::thin(BEHIND, Dash::Short))?;
    for corner in &corners {
        panel.dot(*corner, Dot::Small, BEHIND)?;
    }
    Ok(())
}

/// The names of the ends, and of what is there twice; best away from the middle of the polygon.
pub(super) fn point_labels(points: &[Point]) -> Vec<Label> {
    let corners: Vec<_> = points.iter().map(planar).collect();
    let Frame { x, y } = Frame::of(corners.iter().copied());
    let middle = (f64::midpoint(x.0, x.1), f64::midpoint(y.0, y.1));
    let closed = points.first() == points.last();
    let mut labels = Vec::new();
    for (i, &at) in corners.iter().enumerate() {
        let same = match (i, points.get(i + 1) == Some(&points[i])) {
            (_, true) => Some(i + 1),
            (0, false) if closed => Some(points.len() - 1),
            _ => None,
        };
        let text = match same {
            Some(other) => format!("{} = {}", indexed("d", i), indexed("d", other)),
            None if !closed && (i == 0 || i + 1 == points.len()) => indexed("d", i),
            None => continue,
        };
        // The second coordinate of the sheet goes down.
        let away = (at.0 - middle.0, middle.1 - at.1);
        let length = away.0.hypot(away.1).max(f64::MIN_POSITIVE);
        let named = Named::Point(at, (away.0 / length, away.1 / length));
        labels.push(Label { text, colour: GREY, named });
    }
    labels
}

fn curve(panel: &Panel<'_>, curve: &Curve, pen: Pen) -> Drawn {
    let knots = curve.basis().knots();
    let tolerance = (panel.unit.0 / 2.0, panel.unit.1 / 2.0);
    let (mut line, mut joints) = (Vec::new(), Vec::new());
    for span in knots.spans() {
        let (start, end) = (knots.t(span.index()), knots.t(span.index() + 1));
        line.extend(polygon(|x| curve_point(curve, span, x), (float(start), float(end)), tolerance));
        joints.extend(line.last().copied());
    }
    panel.line(&line, pen)?;
    joints.pop();
    joints.into_iter().try_for_each(|joint| panel.dot(joint, Dot::Small, pen.colour))
}

/// The axis that exchanges d_i and d_{n−i} for all i, if there is one.
fn axis(panel: &Panel<'_>, points: &[Point]) -> Drawn {
    let mut pairs = points.iter().zip(points.iter().rev());
    let Some(reflection) = pairs.find_map(|(from, to)| Reflection::between(from, to)) else { return Ok(()) };
    if points.iter().zip(points.iter().rev()).any(|(from, to)| reflection.apply(from) != *to) {
        return Ok(());
    }
    let (middle, normal) = reflection.axis();
    let ((x, y), (across, up)) = (planar(middle), planar(normal));
    // Along the axis as far as the frame goes.
    let Frame { x: (left, right), y: (low, high) } = panel.frame;
    let length = ((right - left) + (high - low)) / across.hypot(up);
    let inside = |t: f64| (left..=right).contains(&(x - t * up)) && (low..=high).contains(&(y + t * across));
    let steps = (-500_i32..=500).map(|step| length * f64::from(step) / 500.0).filter(|t| inside(*t));
    let ends: Vec<f64> = steps.collect();
    let at = |t: &f64| (x - t * up, y + t * across);
    match (ends.first(), ends.last()) {
        (Some(first), Some(last)) => panel.line(&[at(first), at(last)], Pen::thin(AXIS, Dash::Long)),
        _ => Ok(()),
    }
}

const AXIS: RGBColor = BLACK;

/// The corners of the convex hull, in order (Andrew's monotone chain): exact.
pub(super) fn convex_hull(points: &[Point]) -> Vec<Point> {
    let mut sorted = points.to_vec();
    sorted.sort();
    sorted.dedup();
    let mut hull = half(sorted.iter());
    hull.pop();
    let mut back = half(sorted.iter().rev());
    back.pop();
    hull.append(&mut back);
    hull
}

/// The part of the hull from the first to the last of the points, which are sorted.
fn half<'a>(points: impl Iterator<Item = &'a Point>) -> Vec<Point> {
    let mut chain: Vec<Point> = Vec::new();
    for point in points {
        while let [.., one, two] = chain.as_slice() {
            if turn(one, two, point) > integer(0) {
                break;
            }
            chain.pop();
        }
        chain.push(point.clone());
    }
    chain
}

/// Positive if the way from a over b to c turns left.
fn turn(a: &Point, b: &Point, c: &Point) -> BigRational {
    (&b[0] - &a[0]) * (&c[1] - &a[1]) - (&b[1] - &a[1]) * (&c[0] - &a[0])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::meaning::examples_named;

    fn points(list: &[[usize; 2]]) -> Vec<Point> {
        list.iter().map(|point| point.map(integer).to_vec()).collect()
    }

    #[test]
    fn the_hull_leaves_out_what_is_inside_or_on_an_edge() {
        let hull = convex_hull(&points(&[[0, 0], [1, 1], [2, 0], [1, 0], [2, 2], [0, 2], [0, 1], [0, 0]]));
        assert_eq!(hull, points(&[[0, 0], [2, 0], [2, 2], [0, 2]]));
    }

    #[test]
    fn conjugates_stand_side_by_side() {
        let indices = &examples_named("C5")[0].indices().cloned().collect::<Vec<_>>();
        let panels = Panels::Conjugates.of(indices);
        assert_eq!(panels.len(), 9);
        assert!(panels[1..].chunks(2).all(|pair| pair[0][0].conjugate() == pair[1][0]));
        assert_eq!(Panels::Negative.of(indices).len() + Panels::Positive.of(indices).len(), 10);
    }
}
