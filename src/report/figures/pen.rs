//! The pens: colours, widths, dashes and dots, and the sizes of text.

use plotters::style::{BLACK, RGBColor};

/// Colours that stay apart for the colour-blind (Okabe and Ito, 2008), and in print.
pub(in crate::report) const BLUE: RGBColor = RGBColor(0, 114, 178);
pub(in crate::report) const VERMILION: RGBColor = RGBColor(213, 94, 0);
pub(in crate::report) const GREEN: RGBColor = RGBColor(0, 158, 115);
const PURPLE: RGBColor = RGBColor(170, 75, 130);
const ORANGE: RGBColor = RGBColor(200, 130, 0);
const SKY: RGBColor = RGBColor(40, 140, 200);
/// Of what stands behind the curves: knots, control polygons, axes.
pub(in crate::report) const GREY: RGBColor = RGBColor(110, 110, 110);
/// Of areas, and of lines that only guide the eye.
pub(in crate::report) const PALE: RGBColor = RGBColor(236, 238, 241);

/// Units in a pixel.
pub(super) const UNITS: i32 = 10;
/// Sizes of text in pixels: 8.25 pt and 11.25 pt.
pub(in crate::report) const SMALL: u32 = 11;
pub(in crate::report) const LARGE: u32 = 15;

/// How a line is interrupted.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::report) enum Dash {
    Solid,
    Long,
    Short,
    Dots,
}

/// Colour, width in tenths of a pixel, and dashes of a line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::report) struct Pen {
    pub(in crate::report) colour: RGBColor,
    pub(in crate::report) width: u32,
    pub(in crate::report) dash: Dash,
}

impl Pen {
    /// A line of 1 pixel, 0.75 pt.
    pub(in crate::report) fn thin(colour: RGBColor, dash: Dash) -> Self {
        Self { colour, width: 10, dash }
    }

    /// A line of 1.8 pixels, 1.35 pt.
    pub(in crate::report) fn thick(colour: RGBColor, dash: Dash) -> Self {
        Self { colour, width: 18, dash }
    }

    /// Does it draw what text may stand on: grids, areas and guides?
    pub(super) fn is_pale(self) -> bool {
        self.colour == PALE
    }

    /// The pen of the i-th curve of several: they differ in colour and, for those who see none, in their dashes.
    pub(in crate::report) fn nth(i: usize) -> Self {
        const COLOURS: [RGBColor; 7] = [BLUE, VERMILION, GREEN, PURPLE, ORANGE, SKY, BLACK];
        const DASHES: [Dash; 4] = [Dash::Solid, Dash::Long, Dash::Short, Dash::Dots];
        Self::thick(COLOURS[i % COLOURS.len()], DASHES[i % DASHES.len()])
    }
}

/// How a point is marked.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::report) enum Dot {
    /// The value is taken.
    Filled,
    /// It is a limit, and not taken.
    Open,
    /// A small one: a control point, or a knot on a curve.
    Small,
}

impl Dot {
    /// In units of the sheet.
    pub(super) fn size(self) -> u16 {
        match self {
            Self::Filled => 30,
            Self::Open => 52,
            Self::Small => 22,
        }
    }

    /// In pixels.
    pub(super) fn radius(self) -> f64 {
        f64::from(self.size()) / f64::from(UNITS)
    }
}
