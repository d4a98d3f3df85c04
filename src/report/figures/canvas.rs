//! The paper: an SVG of a given size, panels on it with their own coordinates, lines, dots and text.
//!
//! The library that draws rounds to whole units, so a unit is a tenth of a pixel here: curves stay smooth when they
//! are enlarged. A pixel is 0.75 pt in print; no line is thinner, and no text smaller than 8 pt.

use std::cell::RefCell;
use std::rc::Rc;

use plotters::coord::Shift;
use plotters::coord::types::RangedCoordf64;
use plotters::element::DashedPathElement;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use super::labels::{Area, Label, Named, Scene, Spot, area};
use super::pen::UNITS;

pub(in crate::report) use super::pen::{BLUE, Dash, Dot, GREEN, GREY, LARGE, PALE, Pen, SMALL, VERMILION};

/// The fonts, in the order in which they are tried. The first comes with the program, for PNG.
const FONTS: &str = "DejaVu Sans, Verdana, sans-serif";
/// Why there is no picture: a bug of this program, or of a library that draws.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("a picture could not be drawn: {0}")]
pub struct PictureError(String);

/// Any error as a [`PictureError`].
pub(in crate::report) fn failed(error: impl ToString) -> PictureError {
    PictureError(error.to_string())
}

/// The outcome of drawing something.
pub(in crate::report) type Drawn = Result<(), PictureError>;
type Sheet<'a> = DrawingArea<SVGBackend<'a>, Shift>;
type Plot<'a> = DrawingArea<SVGBackend<'a>, Cartesian2d<RangedCoordf64, RangedCoordf64>>;

/// Where a text lies from its point.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::report) enum Lies {
    Below,
    Left,
    Right,
}

/// A rectangle of the sheet, in pixels: left, top, right, bottom.
#[derive(Debug, Clone, Copy)]
pub(in crate::report) struct Cell {
    pub(in crate::report) left: u32,
    pub(in crate::report) top: u32,
    pub(in crate::report) right: u32,
    pub(in crate::report) bottom: u32,
}

/// The part of the plane that a panel shows.
#[derive(Debug, Clone, Copy)]
pub(in crate::report) struct Frame {
    pub(in crate::report) x: (f64, f64),
    pub(in crate::report) y: (f64, f64),
}

impl Frame {
    /// The smallest that contains the points.
    pub(in crate::report) fn of(points: impl IntoIterator<Item = (f64, f64)>) -> Self {
        let none = (f64::INFINITY, f64::NEG_INFINITY);
        points.into_iter().fold(Self { x: none, y: none }, |frame, (x, y)| Self {
            x: (frame.x.0.min(x), frame.x.1.max(x)),
            y: (frame.y.0.min(y), frame.y.1.max(y)),
        })
    }

    /// Larger by a share of its size on every side.
    pub(in crate::report) fn padded(self, x: f64, y: f64) -> Self {
        let pad = |(low, high): (f64, f64), share: f64| {
            let more = (high - low) * share;
            (low - more, high + more)
        };
        Self { x: pad(self.x, x), y: pad(self.y, y) }
    }

    /// As wide, or as high, as it has to be for both axes of a cell to have the same scale.
    pub(in crate::report) fn with_equal_scales(self, cell: Cell) -> Self {
        let (wide, high) = (f64::from(cell.right - cell.left), f64::from(cell.bottom - cell.top));
        let (width, height) = (self.x.1 - self.x.0, self.y.1 - self.y.0);
        let scale = (wide / width).min(high / height);
        self.padded((wide / scale / width - 1.0) / 2.0, (high / scale / height - 1.0) / 2.0)
    }
}

/// The sheet, and what can be put on it anywhere.
pub(in crate::report) struct Canvas<'a> {
    sheet: Sheet<'a>,
    scene: Rc<RefCell<Scene>>,
}

impl<'a> Canvas<'a> {
    /// An SVG of so many pixels that is called `title`, drawn by `draw`.
    ///
    /// # Errors
    /// [`PictureError`].
    pub(in crate::report) fn svg(
        title: &str,
        (width, height): (u32, u32),
        draw: impl FnOnce(&Canvas<'_>) -> Drawn,
    ) -> Result<String, PictureError> {
        let mut svg = String::new();
        {
            let size = (width * UNITS.unsigned_abs(), height * UNITS.unsigned_abs());
            let sheet = SVGBackend::with_string(&mut svg, size).into_drawing_area();
            sheet.fill(&WHITE).map_err(failed)?;
            draw(&Canvas { sheet: sheet.clone(), scene: Rc::default() })?;
            sheet.present().map_err(failed)?;
        }
        // The size on the page is in pixels, the drawing in units.
        let (_, body) = svg.split_once(" viewBox").ok_or_else(|| failed("the SVG has no viewBox"))?;
        let (head, body) = body.split_once('>').ok_or_else(|| failed("the SVG has no body"))?;
        let title = escaped(title);
        Ok(format!(
            "<svg role=\"img\" width=\"{width}\" height=\"{height}\" viewBox{head}>\n<title>{title}</title>{}",
            joined(body)
        ))
    }

    /// Text at a point of the sheet, in pixels.
    pub(in crate::report) fn text(
        &self,
        text: &str,
        (x, y): (u32, u32),
        size: u32,
        h: HPos,
        colour: RGBColor,
    ) -> Drawn {
        let at = (units(x), units(y));
        let anchor = (h, VPos::Center);
        self.scene.borrow_mut().text(area(text, size, anchor, (f64::from(x), f64::from(y))));
        self.sheet.draw(&Text::new(text.to_owned(), at, style(size, h, VPos::Center, colour))).map_err(failed)
    }

    /// A list of what the pens stand for, from the top of the cell.
    pub(in crate::report) fn legend(&self, cell: Cell, entries: &[(Pen, String)]) -> Drawn {
        let frame = Frame {
            x: (0.0, f64::from(cell.right - cell.left)),
            y: (f64::from(cell.bottom - cell.top), 0.0),
        };
        let panel = self.panel(cell, frame);
        for ((pen, text), y) in entries.iter().zip((1_u32..).map(|line| f64::from(20 * line))) {
            panel.line(&[(0.0, y), (44.0, y)], *pen)?;
            panel.text((44.0, y), text, Lies::Right, BLACK)?;
        }
        Ok(())
    }

    /// A panel in a cell: what is drawn on it is in the coordinates of the frame.
    pub(in crate::report) fn panel(&self, cell: Cell, frame: Frame) -> Panel<'a> {
        let coordinates = Cartesian2d::<RangedCoordf64, RangedCoordf64>::new(
            frame.x.0..frame.x.1,
            frame.y.0..frame.y.1,
            (units(cell.left)..units(cell.right), units(cell.bottom)..units(cell.top)),
        );
        let unit = (
            (frame.x.1 - frame.x.0) / f64::from(units(cell.right - cell.left)),
            (frame.y.1 - frame.y.0) / f64::from(units(cell.bottom - cell.top)),
        );
        Panel {
            plot: self.sheet.apply_coord_spec(coordinates),
            sheet: self.sheet.clone(),
            scene: self.scene.clone(),
            cell,
            frame,
            unit,
        }
    }
}

/// A part of the sheet with coordinates of its own.
pub(in crate::report) struct Panel<'a> {
    plot: Plot<'a>,
    sheet: Sheet<'a>,
    scene: Rc<RefCell<Scene>>,
    cell: Cell,
    /// What it shows.
    pub(in crate::report) frame: Frame,
    /// How much of either coordinate is one unit of the sheet.
    pub(in crate::report) unit: (f64, f64),
}

impl Panel<'_> {
    /// A line through the points.
    pub(in crate::report) fn line(&self, points: &[(f64, f64)], pen: Pen) -> Drawn {
        self.scene.borrow_mut().stroke(pen, points.iter().map(|point| self.spot(*point)).collect());
        let style = pen.colour.stroke_width(pen.width);
        let (dash, gap) = match pen.dash {
            Dash::Solid => {
                return self.plot.draw(&PathElement::new(points.to_vec(), style)).map_err(failed);
            }
            Dash::Long => (90, 40),
            Dash::Short => (45, 30),
            Dash::Dots => (18, 27),
        };
        let element = DashedPathElement::new(points.iter().copied(), dash, gap, style);
        self.plot.draw(&element).map_err(failed)
    }

    /// An area.
    pub(in crate::report) fn area(&self, corners: &[(f64, f64)], colour: RGBColor) -> Drawn {
        self.plot.draw(&Polygon::new(corners.to_vec(), colour.filled())).map_err(failed)
    }

    /// A marked point.
    pub(in crate::report) fn dot(&self, at: (f64, f64), dot: Dot, colour: RGBColor) -> Drawn {
        self.scene.borrow_mut().dot(self.spot(at), dot);
        let (size, inside) = (u32::from(dot.size()), if dot == Dot::Open { WHITE } else { colour });
        self.plot.draw(&Circle::new(at, size, inside.filled())).map_err(failed)?;
        if dot == Dot::Open {
            self.plot.draw(&Circle::new(at, size - 7, colour.stroke_width(14))).map_err(failed)?;
        }
        Ok(())
    }

    /// Small text beside a point, wherever that may be: for what stands at the edges of the panel.
    pub(in crate::report) fn text(&self, at: (f64, f64), text: &str, lies: Lies, colour: RGBColor) -> Drawn {
        let (offset, h, v) = match lies {
            Lies::Below => ((0, 50), HPos::Center, VPos::Top),
            Lies::Left => ((-60, 0), HPos::Right, VPos::Center),
            Lies::Right => ((60, 0), HPos::Left, VPos::Center),
        };
        let (x, y) = self.spot(at);
        let pixels = |units: i32| f64::from(units) / f64::from(UNITS);
        let anchor = (x + pixels(offset.0), y + pixels(offset.1));
        self.scene.borrow_mut().text(area(text, SMALL, (h, v), anchor));
        let text = Text::new(text.to_owned(), offset, style(SMALL, h, v, colour));
        self.plot.draw(&(EmptyElement::at(at) + text)).map_err(failed)
    }

    /// Small texts beside the points and lines that they name, and on nothing that has been drawn: they come last.
    pub(super) fn labels(&self, labels: &[Label]) -> Drawn {
        for label in labels {
            let named = match &label.named {
                Named::Point(at, best) => Named::Point(self.spot(*at), *best),
                Named::Line(points, pen) => {
                    Named::Line(points.iter().map(|point| self.spot(*point)).collect(), *pen)
                }
            };
            let (x, y) = self.scene.borrow_mut().place(&Label { named, ..label.clone() }, self.bounds());
            let at = (whole(x * f64::from(UNITS)), whole(y * f64::from(UNITS)));
            let style = style(SMALL, HPos::Center, VPos::Center, label.colour);
            self.sheet.draw(&Text::new(label.text.clone(), at, style)).map_err(failed)?;
        }
        Ok(())
    }

    /// Where labels may stand: in the cell, and in the margin above and beside it.
    fn bounds(&self) -> Area {
        const MARGIN: f64 = 12.0;
        let Cell { left, top, right, bottom } = self.cell;
        Area {
            left: f64::from(left) - MARGIN,
            top: f64::from(top) - MARGIN,
            right: f64::from(right) + MARGIN,
            bottom: f64::from(bottom),
        }
    }

    /// A point of the frame on the sheet.
    fn spot(&self, (x, y): (f64, f64)) -> Spot {
        let Frame { x: (left, right), y: (low, high) } = self.frame;
        let share = |at: f64, (from, to): (f64, f64), (first, last): (u32, u32)| {
            f64::from(first) + (at - from) / (to - from) * (f64::from(last) - f64::from(first))
        };
        (
            share(x, (left, right), (self.cell.left, self.cell.right)),
            share(y, (low, high), (self.cell.bottom, self.cell.top)),
        )
    }
}

/// The nearest whole number of units: a place on a sheet is far within the range.
fn whole(x: f64) -> i32 {
    format!("{x:.0}").parse().unwrap_or_default()
}

fn style(size: u32, h: HPos, v: VPos, colour: RGBColor) -> TextStyle<'static> {
    // The library writes a font size 1.24 times smaller than it is told.
    let size = f64::from(units(size)) * 1.24;
    (FONTS, size).into_font().color(&colour).pos(Pos::new(h, v))
}

/// Pixels in units of the sheet.
fn units(pixels: u32) -> i32 {
    i32::try_from(pixels).unwrap_or(i32::MAX / UNITS).saturating_mul(UNITS)
}

/// Lines of the same pen that follow each other, such as dashes, as one path: a third of the length.
fn joined(body: &str) -> String {
    let mut text = String::with_capacity(body.len());
    let mut pen = None;
    for line in body.lines() {
        let polyline = line.strip_prefix("<polyline ").and_then(|rest| rest.split_once(" points=\""));
        let next = polyline.map(|(attributes, _)| attributes);
        if next != pen {
            text += if pen.is_some() { "\"/>\n" } else { "" };
            text += &next.map_or_else(String::new, |attributes| format!("<path {attributes} d=\""));
            pen = next;
        }
        match polyline {
            Some((_, points)) => {
                text.push('M');
                text += points.trim_end_matches("\"/>").trim_end();
            }
            None => {
                text += line;
                text.push('\n');
            }
        }
    }
    text
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_svg_has_its_size_in_pixels_and_a_title() {
        let svg = Canvas::svg("a < b", (20, 10), |_| Ok(())).unwrap();
        assert!(
            svg.starts_with("<svg role=\"img\" width=\"20\" height=\"10\" viewBox=\"0 0 200 100\""),
            "{svg}"
        );
        assert!(svg.contains("<title>a &lt; b</title>"), "{svg}");
    }

    #[test]
    fn lines_of_one_pen_become_one_path() {
        let line = |pen: &str, points: &str| format!("<polyline {pen} points=\"{points} \"/>\n");
        let body = line("a", "0,0 1,1") + &line("a", "2,2 3,3") + &line("b", "4,4") + "<circle/>\n</svg>\n";
        let expected = "<path a d=\"M0,0 1,1M2,2 3,3\"/>\n<path b d=\"M4,4\"/>\n<circle/>\n</svg>\n";
        assert_eq!(joined(&body), expected);
    }

    #[test]
    fn equal_scales_keep_the_middle() {
        let cell = Cell { left: 0, top: 0, right: 200, bottom: 100 };
        let frame = Frame { x: (0.0, 1.0), y: (0.0, 1.0) }.with_equal_scales(cell);
        assert!((frame.x.0 + 0.5).abs() < 1e-12 && (frame.x.1 - 1.5).abs() < 1e-12, "{frame:?}");
        assert!(frame.y.0.abs() < 1e-12 && (frame.y.1 - 1.0).abs() < 1e-12, "{frame:?}");
    }
}
