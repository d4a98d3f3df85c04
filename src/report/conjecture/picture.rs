//! Pictures of single basis functions, and of what happens along all indices, as SVG.
//!
//! What is drawn is sampled in `f64`; what is marked on it (maxima, knots, ends of cells) is exact and rounded
//! only to be drawn.

use plotters::style::text_anchor::HPos;
use plotters::style::{BLACK, RGBColor, WHITE};

use crate::analysis::{Extremum, ExtremumKind, Pieces, Shape};
use crate::report::figures::canvas::{
    BLUE, Canvas, Cell as Place, Dash, Dot, Drawn, Frame, GREEN, GREY, Lies, Panel, Pen, PictureError, SMALL,
    VERMILION,
};
use crate::report::figures::sample::float;
use crate::report::figures::{graph, grid, knot_lines};
use crate::scalar::{BigRational, rational};
use crate::spline::Basis;

const WIDTH: u32 = 800;
/// Of the titles.
const TITLE: u32 = 14;

/// G_i^k of a basis: the graph over its support, and beside it the part where its maxima are, enlarged.
///
/// # Errors
/// [`PictureError`].
pub(in crate::report) fn function(title: &str, basis: &Basis, i: usize) -> Result<String, PictureError> {
    let mut shape = Shape::of(&Pieces::of(basis), i);
    shape.refine_to(&rational(1, 1 << 40));
    let marks: Vec<Mark> = shape.extrema().iter().map(Mark::of).collect();
    let (low, high) = basis.support(i);
    let top = marks.iter().map(|mark| mark.at.1).fold(0.0, f64::max);
    let whole = Frame { x: (float(low), float(high)), y: (0.0, 1.08 * top) };
    Canvas::svg(title, (WIDTH, 320), |canvas| {
        canvas.text(title, (14, 20), TITLE, HPos::Left, BLACK)?;
        canvas.text("The whole function", (60, 42), SMALL, HPos::Left, GREY)?;
        let place = Place { left: 60, top: 54, right: 370, bottom: 284 };
        panel(&canvas.panel(place, whole), basis, i, &marks)?;
        canvas.text(
            "Where its maxima are, enlarged: ● maxima, ○ minima",
            (480, 42),
            SMALL,
            HPos::Left,
            GREY,
        )?;
        let place = Place { left: 480, right: 786, ..place };
        panel(&canvas.panel(place, around(&marks, whole)), basis, i, &marks)
    })
}

/// An extremum, to be drawn.
struct Mark {
    at: (f64, f64),
    kind: ExtremumKind,
}

impl Mark {
    fn of(extremum: &Extremum) -> Self {
        let middle = |lo: &BigRational, hi: &BigRational| f64::midpoint(float(lo), float(hi));
        let (lo, hi) = extremum.place.interval();
        Self { at: (middle(lo, hi), middle(&extremum.value.0, &extremum.value.1)), kind: extremum.kind }
    }
}

/// Around the extrema, with half their spread on every side; at least a millionth of the whole.
fn around(marks: &[Mark], whole: Frame) -> Frame {
    let near = Frame::of(marks.iter().map(|mark| mark.at));
    let spread = |(first, last): (f64, f64), (low, high): (f64, f64), share: f64| {
        let pad = ((last - first) * share).max((high - low) * 1e-6);
        (first - pad, last + pad)
    };
    let (left, right) = spread(near.x, whole.x, 0.5);
    Frame { x: (left.max(whole.x.0), right.min(whole.x.1)), y: spread(near.y, whole.y, 0.6) }
}

fn panel(panel: &Panel<'_>, basis: &Basis, i: usize, marks: &[Mark]) -> Drawn {
    grid(panel)?;
    knot_lines(panel, basis.knots())?;
    let _ = graph(panel, basis, i, Pen::thick(BLUE, Dash::Solid))?;
    for mark in marks {
        let dot = match mark.kind {
            ExtremumKind::Maximum => Dot::Filled,
            ExtremumKind::Minimum => Dot::Open,
        };
        panel.dot(mark.at, dot, VERMILION)?;
    }
    Ok(())
}

/// A cell of a partition of all ratios: from, to (none for ∞), and the number of local maxima.
pub(super) type Cell = (BigRational, Option<BigRational>, usize);

/// One row for each degree: how many local maxima a function has, for each ratio r from 2^−`octaves` to 2^`octaves`, on
/// a logarithmic scale.
///
/// # Errors
/// [`PictureError`].
pub(super) fn partition(
    title: &str,
    rows: &[(usize, Vec<Cell>)],
    octaves: i32,
) -> Result<String, PictureError> {
    let count = u32::try_from(rows.len()).unwrap_or(1);
    let size = (WIDTH, 40 * count + 110);
    let end = f64::from(octaves);
    Canvas::svg(title, size, |canvas| {
        canvas.text(title, (14, 20), TITLE, HPos::Left, BLACK)?;
        canvas.text("r = α/(α − 1)", (WIDTH / 2, size.1 - 14), SMALL, HPos::Center, BLACK)?;
        let place = Place { left: 80, top: 40, right: 780, bottom: size.1 - 56 };
        let panel = canvas.panel(place, Frame { x: (-end, end), y: (f64::from(count), 0.0) });
        for octave in -octaves..=octaves {
            let name =
                if octave < 0 { format!("1/{}", 1_u64 << -octave) } else { (1_u64 << octave).to_string() };
            panel.text((f64::from(octave), f64::from(count)), &name, Lies::Below, BLACK)?;
        }
        for ((degree, cells), y) in rows.iter().zip((0_u32..).map(f64::from)) {
            panel.text((-end, y + 0.5), &format!("k = {degree}"), Lies::Left, BLACK)?;
            // Those with several maxima last, with an outline: so no cell is too narrow to be seen.
            let (several, one): (Vec<_>, Vec<_>) = cells.iter().partition(|(_, _, maxima)| *maxima > 1);
            for (from, to, maxima) in one.into_iter().chain(several) {
                let from = float(from).log2().max(-end);
                let to = to.as_ref().map_or(end, |to| float(to).log2()).min(end);
                if from <= to {
                    row(&panel, (from, to), (y + 0.15, y + 0.85), *maxima)?;
                }
            }
        }
        Ok(())
    })
}

/// A cell of a row, in the colour of its number of maxima.
fn row(panel: &Panel<'_>, (from, to): (f64, f64), (low, high): (f64, f64), maxima: usize) -> Drawn {
    let colour = match maxima {
        0 | 1 => RGBColor(200, 215, 230),
        2 => VERMILION,
        3 => GREEN,
        _ => BLACK,
    };
    let corners = [(from, low), (to, low), (to, high), (from, high), (from, low)];
    panel.area(&corners, colour)?;
    panel.line(&corners, Pen::thin(if maxima > 1 { colour } else { WHITE }, Dash::Solid))
}
