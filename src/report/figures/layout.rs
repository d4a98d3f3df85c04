//! Where things stand on a figure: a title, cells in two columns, a note; and the axes of a cell.

use plotters::style::text_anchor::HPos;
use plotters::style::{BLACK, RGBColor};

use crate::scalar::BigRational;
use crate::spline::KnotVector;

use super::canvas::{
    Canvas, Cell, Dash, Drawn, Frame, GREY, LARGE, Lies, PALE, Panel, Pen, PictureError, SMALL,
};
use super::notation::number;
use super::sample::float;

/// The width of a figure in pixels: 210 mm, a page.
const WIDTH: u32 = 800;
const COLUMNS: usize = 2;
/// The heights of the title, and of a note below the panels.
const TITLE: u32 = 58;
const NOTE: u32 = 17;
/// What is left free around the panel of a cell: left, above, right, below.
const MARGINS: (u32, u32, u32, u32) = (40, 26, 14, 40);
/// The width of a panel.
pub(super) const PANEL: u32 = WIDTH / 2 - MARGINS.0 - MARGINS.2;

/// A figure that is to be laid out.
pub(super) struct Sheet<'a> {
    /// In large letters.
    pub(super) title: &'a str,
    /// In small ones below.
    pub(super) subtitle: &'a str,
    /// What the marks mean, and what else is to be said: a line each.
    pub(super) notes: &'a [&'a str],
    /// How many cells there are.
    pub(super) cells: usize,
    /// The height of a panel.
    pub(super) panel: u32,
}

impl Sheet<'_> {
    /// The SVG: `draw` puts something into each cell, by its number.
    ///
    /// # Errors
    /// [`PictureError`].
    pub(super) fn svg(
        &self,
        mut draw: impl FnMut(&Canvas<'_>, usize, Cell) -> Drawn,
    ) -> Result<String, PictureError> {
        let row = self.panel + MARGINS.1 + MARGINS.3;
        let rows = u32::try_from(self.cells.div_ceil(COLUMNS)).unwrap_or(1);
        let notes = u32::try_from(self.notes.len()).unwrap_or_default();
        let size = (WIDTH, TITLE + rows * row + notes * NOTE + 9);
        Canvas::svg(self.title, size, |canvas| {
            canvas.text(self.title, (14, 22), LARGE, HPos::Left, BLACK)?;
            canvas.text(self.subtitle, (14, 43), SMALL, HPos::Left, GREY)?;
            for (note, up) in self.notes.iter().rev().zip(0..) {
                canvas.text(note, (14, size.1 - 14 - up * NOTE), SMALL, HPos::Left, GREY)?;
            }
            let places = (0..rows).flat_map(|row| [(row, 0), (row, WIDTH / 2)]);
            for (number, (place, left)) in places.take(self.cells).enumerate() {
                let (left, top) = (left + MARGINS.0, TITLE + place * row + MARGINS.1);
                let cell = Cell { left, top, right: left + PANEL, bottom: top + self.panel };
                draw(canvas, number, cell)?;
            }
            Ok(())
        })
    }
}

/// What is written above a cell.
pub(super) fn heading(canvas: &Canvas<'_>, cell: Cell, text: &str) -> Drawn {
    canvas.text(text, (cell.left, cell.top - 14), 12, HPos::Left, BLACK)
}

/// The knots on the first axis: a tick and a line for each, its value, and how often it occurs unless once.
pub(super) fn knot_axis(panel: &Panel<'_>, knots: &KnotVector, from: f64) -> Drawn {
    let Frame { x: (left, right), y: (low, high) } = panel.frame;
    for (t, multiplicity) in knots.stop_knots() {
        let x = float(t);
        panel.line(&[(x, low), (x, high)], Pen::thin(PALE, Dash::Solid))?;
        // Ticks as many as there are knots at the place.
        for tick in (0_u32..).take(multiplicity) {
            let apart =
                (f64::from(tick) - 0.5 * (f64::from(u32::try_from(multiplicity).unwrap_or(1)) - 1.0)) * 24.0;
            let x = x + apart * panel.unit.0;
            panel.line(&[(x, from - 45.0 * panel.unit.1), (x, from)], Pen::thin(BLACK, Dash::Solid))?;
        }
        panel.text((x, low), &number(t), Lies::Below, BLACK)?;
        if multiplicity > 1 {
            let below = (x, low - 130.0 * panel.unit.1);
            panel.text(below, &format!("×{multiplicity}"), Lies::Below, GREY)?;
        }
    }
    panel.line(&[(left, from), (right, from)], Pen::thin(BLACK, Dash::Solid))
}

/// Labelled lines across, at some values of the second coordinate.
pub(super) fn levels(panel: &Panel<'_>, values: &[BigRational]) -> Drawn {
    let Frame { x: (left, right), .. } = panel.frame;
    for value in values {
        let y = float(value);
        panel.line(&[(left, y), (right, y)], Pen::thin(PALE, Dash::Solid))?;
        panel.text((left, y), &number(value), Lies::Left, BLACK)?;
    }
    Ok(())
}

/// Lines at the knots that are in the frame.
pub(in crate::report) fn knot_lines(panel: &Panel<'_>, knots: &KnotVector) -> Drawn {
    let Frame { x: (left, right), y: (low, high) } = panel.frame;
    let inside = knots.stop_knots().map(|(t, _)| float(t)).filter(|t| left <= *t && *t <= right);
    inside.into_iter().try_for_each(|t| panel.line(&[(t, low), (t, high)], Pen::thin(GREY, Dash::Short)))
}

/// A grid at round numbers, with labels on both axes; where the scales of the axes are the same, so are the steps.
pub(in crate::report) fn grid(panel: &Panel<'_>) -> Drawn {
    let Frame { x, y } = panel.frame;
    let (mut across, mut up) = (Step::of(x, 5), Step::of(y, 5));
    if (panel.unit.0 / panel.unit.1 - 1.0).abs() < 1e-6 {
        let length = x.1.max(y.1 - y.0 + x.0);
        (across, up) = (Step::of((x.0, length), 10), Step::of((x.0, length), 10));
    }
    for at in across.multiples(x) {
        panel.line(&[(at, y.0), (at, y.1)], Pen::thin(PALE, Dash::Solid))?;
        panel.text((at, y.0), &across.label(at), Lies::Below, GREY)?;
    }
    for at in up.multiples(y) {
        panel.line(&[(x.0, at), (x.1, at)], Pen::thin(PALE, Dash::Solid))?;
        panel.text((x.0, at), &up.label(at), Lies::Left, GREY)?;
    }
    Ok(())
}

/// Round numbers a step apart: a digit and a power of ten.
#[derive(Debug, Clone, Copy)]
struct Step {
    length: f64,
    decimals: usize,
}

impl Step {
    /// The first of …, 0.1, 0.2, 0.5, 1, 2, … of which at most so many fit between low and high.
    fn of((low, high): (f64, f64), most: u32) -> Self {
        let ladder = (0_u32..30).flat_map(|power| {
            // 10^−15 to 10^14: one is divided by what is exact, so that the result is the nearest number.
            let power = 15 - i32::try_from(power).unwrap_or(15);
            let decimals = usize::try_from(power).unwrap_or(0);
            let ten = |power: i32| (0..power).fold(1.0, |ten, _| ten * 10.0);
            [1.0, 2.0, 5.0].map(|digit| Self { length: digit / ten(power) * ten(-power), decimals })
        });
        let fits = |step: &Self| (high - low) / step.length <= f64::from(most);
        ladder.into_iter().find(fits).unwrap_or(Self { length: high - low, decimals: 0 })
    }

    /// Those from low to high.
    fn multiples(self, (low, high): (f64, f64)) -> impl Iterator<Item = f64> {
        let first = (low / self.length).ceil();
        (0_u32..20).map(move |i| (first + f64::from(i)) * self.length).take_while(move |x| *x <= high)
    }

    fn label(self, at: f64) -> String {
        // Minus zero is written without its sign.
        format!("{:.*}", self.decimals, at + 0.0).replace('-', "−")
    }
}

/// The colour of lines that belong to no function.
pub(super) const BEHIND: RGBColor = GREY;
