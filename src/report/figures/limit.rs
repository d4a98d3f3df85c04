//! The trace of a curve as α → 0⁻ and as α → 1⁺, with what it tends to: a part of the control polygon, and an arc.

use crate::meaning::{Example, examples_named};
use crate::spline::{Basis, Curve, FormalWeights, Index, Span, triangle};

use super::canvas::{Dash, Frame, GREEN, Panel, Pen, PictureError, VERMILION, failed};
use super::curve::control_polygon;
use super::layout::{Sheet, grid, heading};
use super::notation::{alpha, knots};
use super::sample::{curve_point, float, planar, polygon};

/// The indices that are drawn, towards 0; beside them their conjugates, towards 1.
const INDICES: [&str; 3] = ["-1/7", "-1/30", "-1/1000"];

const NOTE: &str =
    "Dashed grey: control polygon. The curves come as near as one likes to the limit, which no α reaches.";

/// The figure of an instance with simple interior knots.
///
/// # Errors
/// [`PictureError`].
pub(super) fn svg(title: &str, name: &str) -> Result<String, PictureError> {
    let instance =
        examples_named(name).into_iter().next().ok_or_else(|| failed("there is no such instance"))?;
    let indices: Vec<Index> =
        INDICES.iter().map(|text| text.parse()).collect::<Result<_, _>>().map_err(failed)?;
    let conjugates = indices.iter().map(Index::conjugate).collect();
    let panels = [(Way::Zero, indices), (Way::Infinity, conjugates)];
    let frame = Frame::of(instance.points.iter().flatten().map(planar)).padded(0.07, 0.09);
    let subtitle = format!("A curve of degree {} on U = {}", instance.degree, knots(&instance.knots));
    Sheet { title, subtitle: &subtitle, notes: &[NOTE], cells: 4, panel: 150 }.svg(|canvas, number, cell| {
        let Some((way, indices)) = panels.get(number) else {
            let (_, indices) = &panels[number - 2];
            let curve = |(i, index)| (pen(i), format!("α = {}", alpha(index)));
            let mut entries: Vec<_> = indices.iter().enumerate().map(curve).collect();
            entries.push((LIMIT, "limit of the traces".to_owned()));
            return canvas.legend(cell, &entries);
        };
        heading(canvas, cell, if *way == Way::Zero { "α → 0, α < 0" } else { "α → 1, α > 1" })?;
        let panel = canvas.panel(cell, frame.with_equal_scales(cell));
        grid(&panel)?;
        if let Some(points) = &instance.points {
            control_polygon(&panel, points)?;
        }
        panel.line(&way.limit(&instance, &panel)?, LIMIT)?;
        for (i, index) in indices.iter().enumerate() {
            panel.line(&trace(&curve_of(&instance, index)?, &panel), pen(i))?;
        }
        Ok(())
    })
}

const LIMIT: Pen = Pen { colour: VERMILION, width: 36, dash: Dash::Solid };

/// The nearer to the limit, the thinner: all lie one upon the other in the end.
fn pen(i: usize) -> Pen {
    match i {
        0 => Pen { dash: Dash::Short, ..Pen::nth(0) },
        1 => Pen { dash: Dash::Long, colour: GREEN, ..Pen::nth(0) },
        _ => Pen::thin(super::canvas::BLUE, Dash::Solid),
    }
}

fn curve_of(instance: &Example, index: &Index) -> Result<Curve, PictureError> {
    let basis = Basis::new(instance.knots.clone(), instance.degree, index.clone()).map_err(failed)?;
    Curve::new(basis, instance.points.clone().unwrap_or_default()).map_err(failed)
}

/// All spans, each by s in [0, 1] with (x − t_j)/(t_{j+1} − x) = s/(1 − s)/r: where x moves by a part of r, the point
/// moves by much.
fn trace(curve: &Curve, panel: &Panel<'_>) -> Vec<(f64, f64)> {
    let (knots, r) = (curve.basis().knots(), float(curve.basis().index().ratio()));
    let on = |span: Span| {
        let (start, end) = (knots.t(span.index()), knots.t(span.index() + 1));
        let (start, end) = (float(start), float(end));
        let at = move |s: f64| curve_point(curve, span, start + (end - start) * s / (s + r * (1.0 - s)));
        polygon(at, (0.0, 1.0), (panel.unit.0 / 2.0, panel.unit.1 / 2.0))
    };
    knots.spans().flat_map(on).collect()
}

/// To which end α tends.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Way {
    Zero,
    Infinity,
}

impl Way {
    /// The polygon d_0, …, d_{n−k} and the arc of the last span; or that of the first one and d_k, …, d_n.
    fn limit(self, instance: &Example, panel: &Panel<'_>) -> Result<Vec<(f64, f64)>, PictureError> {
        let curve = curve_of(instance, &Index::infinity())?;
        let corners: Vec<_> = curve.points().iter().map(planar).collect();
        let mut spans = curve.basis().knots().spans();
        let span = if self == Self::Zero { spans.next_back() } else { spans.next() };
        let span = span.ok_or_else(|| failed("there is no span"))?;
        let arc =
            polygon(|s| self.on_arc(&curve, span, s), (0.0, 1.0), (panel.unit.0 / 2.0, panel.unit.1 / 2.0));
        let (k, n) = (curve.basis().degree(), curve.basis().n());
        Ok(match self {
            Self::Zero => [&corners[..=n - k], &arc[..]].concat(),
            Self::Infinity => [&arc[..], &corners[k..]].concat(),
        })
    }

    /// The point of the arc for y = s/(1 − s) divided by the length of the span (X.limit.arc), from one end to the other.
    fn on_arc(self, curve: &Curve, span: Span, s: f64) -> (f64, f64) {
        let (basis, knots) = (curve.basis(), curve.basis().knots());
        let (start, end) = (knots.t(span.index()), knots.t(span.index() + 1));
        let length = float(&(end - start));
        let weight = |i: usize, d: usize| {
            // y·c/(1 + y·c) for the length c of the interval, times 1 − s above and below; for the first span its complement,
            // with s and 1 − s exchanged, as the arc is run through backwards.
            let c = float(&(knots.t(i + d) - knots.t(i))) / length;
            match self {
                Self::Zero => s * c / (1.0 - s + s * c),
                Self::Infinity => s / (s + (1.0 - s) * c),
            }
        };
        let active = triangle(&FormalWeights::new(&1.0, weight), span, basis.degree(), knots.m());
        active.iter().fold((0.0, 0.0), |(a, b), (i, g): (usize, &f64)| {
            let (x, y) = planar(&curve.points()[i]);
            (a + g * x, b + g * y)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::figures::canvas::{Canvas, Cell};

    /// No point of the trace is far from the limit, and for r → 0 all of it comes near.
    #[test]
    fn the_trace_comes_near_its_limit() {
        let instance = &examples_named("C5")[0];
        let distances = |way: Way, index: &str| {
            let mut farthest = 0.0_f64;
            let cell = Cell { left: 0, top: 0, right: 400, bottom: 200 };
            let frame = Frame { x: (0.0, 10.0), y: (0.0, 5.0) };
            Canvas::svg("", (400, 200), |canvas| {
                let panel = canvas.panel(cell, frame);
                let limit = way.limit(instance, &panel)?;
                let index: Index = index.parse().map_err(failed)?;
                for point in trace(&curve_of(instance, &index)?, &panel) {
                    let near = limit.windows(2).map(|pair| distance(point, pair[0], pair[1]));
                    farthest = farthest.max(near.fold(f64::INFINITY, f64::min));
                }
                Ok(())
            })
            .unwrap();
            farthest
        };
        for (way, indices) in
            [(Way::Zero, ["-1/7", "-1/30", "-1/1000"]), (Way::Infinity, ["8/7", "31/30", "1001/1000"])]
        {
            let [far, nearer, near] = indices.map(|index| distances(way, index));
            assert!(0.05 < far && nearer < far / 1.5 && near < 0.02, "{way:?}: {far}, {nearer}, {near}");
        }
    }

    /// From a point to a segment.
    fn distance(p: (f64, f64), a: (f64, f64), b: (f64, f64)) -> f64 {
        let (along, up) = (b.0 - a.0, b.1 - a.1);
        let square = along * along + up * up;
        let t = if square > 0.0 { ((p.0 - a.0) * along + (p.1 - a.1) * up) / square } else { 0.0 };
        let t = t.clamp(0.0, 1.0);
        (p.0 - a.0 - t * along).hypot(p.1 - a.1 - t * up)
    }
}
