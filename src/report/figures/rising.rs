//! What does not fall inside of a span: the sums of the functions from one on, and of two neighbours the share of the second.

use crate::meaning::{Example, examples_named};
use crate::scalar::integer;
use crate::spline::{Basis, HasWeights, Index, Span};

use super::canvas::{Drawn, Frame, Panel, Pen, PictureError, failed};
use super::labels::{Label, Named};
use super::layout::{Sheet, heading, knot_axis, levels};
use super::notation::{alpha, indexed, knots};
use super::sample::{float, polygon};

/// Which quantities are drawn.
#[derive(Debug, Clone, Copy)]
pub(super) enum Rising {
    /// T_j = G_j + … + G_n, for j = 1, …, n.
    Sums,
    /// G_{i+1}/(G_i + G_{i+1}), for i = 0, …, n − 1: it rises where G_{i+1}/G_i does.
    Shares,
}

/// The indices that are drawn.
const INDICES: [&str; 3] = ["-1/3", "inf", "4/3"];

/// How far from the ends of a span, in parts of it, the first and the last point lie: there both functions may be 0.
const INSIDE: f64 = 1e-6;

impl Rising {
    fn note(self) -> &'static str {
        match self {
            Self::Sums => {
                "T_j is the sum of the functions from G_j on. Where it is neither 0 nor 1 it rises."
            }
            Self::Shares => {
                "S_i is G_{i+1}/(G_i + G_{i+1}), where one of both is not 0. It rises where G_{i+1}/G_i does."
            }
        }
    }

    /// The numbers of the lines, and how one is called.
    fn lines<W: HasWeights>(self, basis: &Basis<W>) -> std::ops::Range<usize> {
        match self {
            Self::Sums => 1..basis.n() + 1,
            Self::Shares => 0..basis.n(),
        }
    }

    fn called(self, line: usize) -> String {
        match self {
            Self::Sums => indexed("T", line),
            Self::Shares => indexed("S", line),
        }
    }

    /// Whether the line is drawn over the span: functions live on the spans of their support.
    fn lives<W: HasWeights>(self, basis: &Basis<W>, line: usize, span: Span) -> bool {
        match self {
            Self::Sums => true,
            Self::Shares => (line..=line + basis.degree() + 1).contains(&span.index()),
        }
    }

    fn at<W: HasWeights>(self, basis: &Basis<W>, line: usize, span: Span, x: f64) -> f64 {
        let Ok(active) = basis.active(span, &x) else { return f64::NAN };
        let value = |i: usize| active.get(i).copied().unwrap_or_default();
        match self {
            Self::Sums => (line..=basis.n()).map(value).sum(),
            Self::Shares => value(line + 1) / (value(line) + value(line + 1)),
        }
    }
}

/// The figure of an instance, a panel for each index.
///
/// # Errors
/// [`PictureError`].
pub(super) fn svg(title: &str, name: &str, rising: Rising) -> Result<String, PictureError> {
    let missing = || failed("there is no such instance");
    let instance: Example = examples_named(name).into_iter().next().ok_or_else(missing)?;
    let subtitle = format!("Degree {} on U = {}", instance.degree, knots(&instance.knots));
    let sheet =
        Sheet { title, subtitle: &subtitle, notes: &[rising.note()], cells: INDICES.len(), panel: 190 };
    sheet.svg(|canvas, number, cell| {
        let index: Index = INDICES[number].parse().map_err(failed)?;
        heading(canvas, cell, &format!("k = {}, α = {}", instance.degree, alpha(&index)))?;
        let basis = Basis::new(instance.knots.clone(), instance.degree, index).map_err(failed)?;
        let x = (float(basis.knots().first()), float(basis.knots().last()));
        let frame = Frame { x, y: (0.0, 1.0) }.padded(0.03, 0.0);
        lines(&canvas.panel(cell, Frame { y: (-0.06, 1.14), ..frame }), &basis, rising)
    })
}

fn lines<W: HasWeights>(panel: &Panel<'_>, basis: &Basis<W>, rising: Rising) -> Drawn {
    levels(panel, &[integer(0), integer(1)])?;
    knot_axis(panel, basis.knots(), 0.0)?;
    let mut labels = Vec::new();
    for line in rising.lines(basis) {
        let pen = Pen::nth(line);
        let over = |span: Span| {
            let [start, end] = [0, 1].map(|side| float(basis.knots().t(span.index() + side)));
            let inside = (end - start) * INSIDE;
            let at = |x| (x, rising.at(basis, line, span, x));
            polygon(at, (start + inside, end - inside), (panel.unit.0 / 2.0, panel.unit.1 / 2.0))
        };
        let spans = basis.knots().spans().filter(|span| rising.lives(basis, line, *span));
        let points: Vec<_> = spans.flat_map(over).collect();
        panel.line(&points, pen)?;
        labels.push(Label { text: rising.called(line), colour: pen.colour, named: Named::Line(points, pen) });
    }
    panel.labels(&labels)
}
