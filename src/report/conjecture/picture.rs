//! Pictures of single basis functions, and of what happens along all indices, as SVG.
//!
//! What is drawn is sampled in `f64`; what is marked on it (maxima, knots, ends of cells) is exact and rounded
//! only to be drawn.

use num_traits::ToPrimitive;
use plotters::coord::Shift;
use plotters::prelude::*;

use crate::analysis::{ExtremumKind, Pieces, Shape};
use crate::scalar::{BigRational, rational};
use crate::spline::{Basis, Span};

/// Colours that stay apart for the colour-blind (Okabe and Ito, 2008), and in print.
const BLUE: RGBColor = RGBColor(0, 114, 178);
const VERMILION: RGBColor = RGBColor(213, 94, 0);
const GREEN: RGBColor = RGBColor(0, 158, 115);
const GREY: RGBColor = RGBColor(110, 110, 110);

const PANEL: (u32, u32) = (420, 330);
const SAMPLES: usize = 300;

/// Why there is no picture: a bug of this program, or of the library that draws.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("a picture could not be drawn: {0}")]
pub struct PictureError(String);

pub(in crate::report) fn failed(error: impl ToString) -> PictureError {
    PictureError(error.to_string())
}

type Drawn = Result<(), PictureError>;
type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;

fn float(x: &BigRational) -> f64 {
    x.to_f64().unwrap_or(f64::NAN)
}

/// G_i^k of a basis: the graph over its support, and beside it the part where its maxima are, enlarged.
///
/// # Errors
/// [`PictureError`].
pub(super) fn function(title: &str, basis: &Basis, i: usize) -> Result<String, PictureError> {
    let mut svg = String::new();
    {
        let (width, height) = PANEL;
        let root = SVGBackend::with_string(&mut svg, (2 * width, height)).into_drawing_area();
        root.fill(&WHITE).map_err(failed)?;
        let root = root.titled(title, ("sans-serif", 18)).map_err(failed)?;
        let (left, right) = root.split_horizontally(width);
        let mut shape = Shape::of(basis, &Pieces::of(basis), i);
        shape.refine_to(&rational(1, 1 << 40));
        let marks: Vec<Mark> = shape.extrema().iter().map(Mark::of).collect();
        let graph = graph(basis, i, None);
        let (low, high) = basis.support(i);
        let top = graph.iter().map(|(_, y)| *y).fold(0.0, f64::max);
        let whole = Frame { x: (float(low), float(high)), y: (0.0, 1.05 * top) };
        panel(&left, basis, &graph, &marks, whole)?;
        let frame = Frame::around(&marks, whole);
        panel(&right, basis, &self::graph(basis, i, Some(frame.x)), &marks, frame)?;
        root.present().map_err(failed)?;
    }
    Ok(svg)
}

/// An extremum, to be drawn.
struct Mark {
    at: (f64, f64),
    kind: ExtremumKind,
}

impl Mark {
    fn of(extremum: &crate::analysis::Extremum) -> Self {
        let middle = |lo: &BigRational, hi: &BigRational| f64::midpoint(float(lo), float(hi));
        let (lo, hi) = extremum.place.interval();
        Self { at: (middle(lo, hi), middle(&extremum.value.0, &extremum.value.1)), kind: extremum.kind }
    }
}

/// The part of the plane that a panel shows.
#[derive(Debug, Clone, Copy)]
struct Frame {
    x: (f64, f64),
    y: (f64, f64),
}

impl Frame {
    /// Around the extrema, with half their spread on every side; at least a hundredth of the whole.
    fn around(marks: &[Mark], whole: Self) -> Self {
        let spread = |of: fn(&Mark) -> f64, (low, high): (f64, f64), share: f64| {
            let (first, last) = marks
                .iter()
                .map(of)
                .fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), x| (a.min(x), b.max(x)));
            let pad = ((last - first) * share).max((high - low) * 1e-6);
            (first - pad, last + pad)
        };
        let (left, right) = spread(|mark| mark.at.0, whole.x, 0.5);
        Self { x: (left.max(whole.x.0), right.min(whole.x.1)), y: spread(|mark| mark.at.1, whole.y, 0.6) }
    }
}

/// Points of the graph, from left to right, over the support or a part of it.
fn graph(basis: &Basis, i: usize, part: Option<(f64, f64)>) -> Vec<(f64, f64)> {
    let knots = basis.knots();
    let (low, high) = basis.support(i);
    let spans = knots.spans().filter(|span| {
        let (start, end) = knots.ends(*span);
        low <= start && end <= high
    });
    spans.flat_map(|span| on_span(basis, i, span, part)).collect()
}

fn on_span(basis: &Basis, i: usize, span: Span, part: Option<(f64, f64)>) -> Vec<(f64, f64)> {
    let (start, end) = basis.knots().ends(span);
    let (mut start, mut end) = (float(start), float(end));
    if let Some((left, right)) = part {
        (start, end) = (start.max(left), end.min(right));
    }
    if start > end {
        return Vec::new();
    }
    let at = |step: usize| {
        let share = step.to_f64().unwrap_or_default() / SAMPLES.to_f64().unwrap_or(1.0);
        let x = start + share * (end - start);
        (x, basis.active(span, &x).get(i).copied().unwrap_or_default())
    };
    (0..=SAMPLES).map(at).collect()
}

fn panel(area: &Area<'_>, basis: &Basis, graph: &[(f64, f64)], marks: &[Mark], frame: Frame) -> Drawn {
    let mut chart = ChartBuilder::on(area)
        .margin(12)
        .x_label_area_size(28)
        .y_label_area_size(64)
        .build_cartesian_2d(frame.x.0..frame.x.1, frame.y.0..frame.y.1)
        .map_err(failed)?;
    chart
        .configure_mesh()
        .light_line_style(WHITE)
        .x_labels(5)
        .y_labels(5)
        .x_label_formatter(&label(frame.x))
        .y_label_formatter(&label(frame.y))
        .draw()
        .map_err(failed)?;
    let stops =
        basis.knots().stop_knots().map(|(t, _)| float(t)).filter(|t| frame.x.0 <= *t && *t <= frame.x.1);
    for t in stops {
        let line = PathElement::new([(t, frame.y.0), (t, frame.y.1)], GREY.stroke_width(1));
        chart.draw_series([line]).map_err(failed)?;
    }
    chart.draw_series(LineSeries::new(graph.iter().copied(), BLUE.stroke_width(2))).map_err(failed)?;
    for mark in marks {
        let style = match mark.kind {
            ExtremumKind::Maximum => VERMILION.filled(),
            ExtremumKind::Minimum => VERMILION.stroke_width(2),
        };
        chart.draw_series([Circle::new(mark.at, 5, style)]).map_err(failed)?;
    }
    Ok(())
}

/// Decimals enough to tell the labels of an axis apart.
fn label((low, high): (f64, f64)) -> impl Fn(&f64) -> String {
    let mut decimals = 0;
    let mut step = (high - low) / 5.0;
    while step < 1.0 && decimals < 15 {
        step *= 10.0;
        decimals += 1;
    }
    move |x| format!("{x:.decimals$}")
}

/// A cell of a partition of all ratios: from, to (none for ∞), and the number of local maxima.
pub(super) type Cell = (BigRational, Option<BigRational>, usize);

/// One row for each degree: how many local maxima a function has, for each ratio r from 1/`range` to `range`, on a
/// logarithmic scale.
///
/// # Errors
/// [`PictureError`].
pub(super) fn partition(
    title: &str,
    rows: &[(usize, Vec<Cell>)],
    range: f64,
) -> Result<String, PictureError> {
    let mut svg = String::new();
    {
        let height = 40 * u32::try_from(rows.len()).unwrap_or(1) + 130;
        let root = SVGBackend::with_string(&mut svg, (2 * PANEL.0, height)).into_drawing_area();
        root.fill(&WHITE).map_err(failed)?;
        let lowest = rows.first().map_or(0, |(degree, _)| *degree).to_f64().unwrap_or_default();
        let highest = lowest + rows.len().to_f64().unwrap_or_default();
        let mut chart = ChartBuilder::on(&root)
            .caption(title, ("sans-serif", 18))
            .margin(12)
            .x_label_area_size(40)
            .y_label_area_size(64)
            .build_cartesian_2d((1.0 / range..range).log_scale(), lowest - 0.5..highest - 0.5)
            .map_err(failed)?;
        chart
            .configure_mesh()
            .disable_mesh()
            .x_desc("r = α/(α − 1)")
            .y_desc("degree k")
            .y_labels(rows.len())
            .y_label_formatter(&|k| format!("{k:.0}"))
            .draw()
            .map_err(failed)?;
        for (degree, cells) in rows {
            let k = degree.to_f64().unwrap_or_default();
            // Those with several maxima last, with an outline: so no cell is too narrow to be seen.
            let (several, one): (Vec<_>, Vec<_>) = cells.iter().partition(|(_, _, maxima)| *maxima > 1);
            for (from, to, maxima) in one.into_iter().chain(several) {
                let (from, to) = (float(from).max(1.0 / range), to.as_ref().map_or(range, float).min(range));
                let colour = match maxima {
                    0 | 1 => RGBColor(200, 215, 230),
                    2 => VERMILION,
                    3 => GREEN,
                    _ => BLACK,
                };
                if from <= to {
                    let corners = [(from, k - 0.32), (to, k + 0.32)];
                    chart.draw_series([Rectangle::new(corners, colour.filled())]).map_err(failed)?;
                    chart.draw_series([Rectangle::new(corners, colour)]).map_err(failed)?;
                }
            }
        }
        root.present().map_err(failed)?;
    }
    Ok(svg)
}
