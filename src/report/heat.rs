//! Maps of the error over (x, α), as SVG.

use plotters::coord::Shift;
use plotters::prelude::*;

use super::PictureError;
use super::figures::canvas::failed;
use crate::float::FloatBasis;
use crate::spline::Side;
use crate::study::{Errors, Method, Probe, Ulps};

const SIZE: (u32, u32) = (760, 640);
/// The cells of a panel: x from t_0 to t_m, and s from 10^−SCALES to 10^SCALES, each power of ten in three steps, with
/// 10^(1/6), 10^(3/6) and 10^(5/6) in their middles.
const COLUMNS: u32 = 72;
const SCALES: i32 = 6;
const MIDDLES: [f64; 3] = [1.467_799, 3.162_278, 6.812_921];
/// The errors that the scale of colours tells apart: from 1 ULP to 10^DIGITS.
const DIGITS: i32 = 16;

type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;

/// The largest error of a formula in units in the last place at the middle of each cell, on given knots: above the
/// line for α = 1 + s, below it for α = −s, s over twelve powers of ten.
///
/// # Errors
/// [`PictureError`], if it cannot be drawn: a bug.
pub fn heat_map(formula: Method, knots: &[f64], degree: usize) -> Result<String, PictureError> {
    let mut svg = String::new();
    {
        let root = SVGBackend::with_string(&mut svg, SIZE).into_drawing_area();
        root.fill(&WHITE).map_err(failed)?;
        let shown: Vec<String> = knots.iter().map(ToString::to_string).collect();
        let title =
            format!("Error of \"{}\" mid-cell, degree {degree}, knots {}", formula.name(), shown.join(" "));
        let root = root.titled(&title, ("sans-serif", 15)).map_err(failed)?;
        let (maps, scale) = root.split_horizontally(660);
        let panels = maps.split_evenly((2, 1));
        panel(&panels[0], "α − 1", formula, knots, degree, |s| 1.0 + s)?;
        panel(&panels[1], "−α", formula, knots, degree, |s| -s)?;
        colours(&scale)?;
        root.present().map_err(failed)?;
    }
    Ok(svg)
}

/// One sign of α.
fn panel(
    area: &Area<'_>,
    label: &str,
    formula: Method,
    knots: &[f64],
    degree: usize,
    alpha: impl Fn(f64) -> f64,
) -> Result<(), PictureError> {
    let (Some(&first), Some(&last)) = (knots.first(), knots.last()) else { return Ok(()) };
    let scales = f64::from(SCALES);
    // The axis needs a finite length: a quarter of the widest range is one.
    let unit = if (last - first).is_finite() { 1.0 } else { 0.25 };
    let (start, end) = (first * unit, last * unit);
    let mut chart = ChartBuilder::on(area)
        .margin(10)
        .x_label_area_size(34)
        .y_label_area_size(64)
        .build_cartesian_2d(start..end, -scales..scales)
        .map_err(failed)?;
    let in_full = |x: &f64| format!("{:.2e}", x / unit);
    let mut mesh = chart.configure_mesh();
    mesh.disable_mesh().x_desc("x").y_desc(label).y_label_formatter(&|power| format!("1e{power:.0}"));
    if unit < 1.0 {
        mesh.x_label_formatter(&in_full);
    }
    mesh.draw().map_err(failed)?;
    let edge = |column: u32| start + (end - start) * (f64::from(column) / f64::from(COLUMNS));
    let mut cells = Vec::new();
    let rows = (-SCALES..SCALES).flat_map(|power| [0_u8, 1, 2].map(|third| (power, third)));
    for (power, third) in rows {
        let low = f64::from(power) + f64::from(third) / 3.0;
        let s = MIDDLES[usize::from(third)] * 10_f64.powi(power);
        let high = low + 1.0 / 3.0;
        let Ok(basis) = FloatBasis::new(knots.to_vec(), degree, alpha(s)) else { continue };
        for column in 0..COLUMNS {
            let (left, right) = (edge(column), edge(column + 1));
            let Some(case) = Probe::at(basis.clone(), f64::midpoint(left, right) / unit, Side::Right) else {
                continue;
            };
            cells.push(Rectangle::new(
                [(left, low), (right, high)],
                colour(digits_lost(formula, &case)).filled(),
            ));
        }
    }
    chart.draw_series(cells).map_err(failed)?;
    Ok(())
}

/// ⌈log₁₀⌉ of the largest error in ULP, from 0 for 1 ULP or less; `DIGITS` where a result is no number.
fn digits_lost(formula: Method, case: &Probe) -> i32 {
    let errors = Errors::of(formula, case);
    let error = match errors.worst() {
        Some((Ulps::Number(error), _)) => error,
        Some((Ulps::NotFinite, _)) => return DIGITS,
        None => return 0,
    };
    let mut power = crate::scalar::integer(1);
    (0..DIGITS)
        .find(|_| {
            let within = *error <= power;
            power *= crate::scalar::integer(10);
            within
        })
        .unwrap_or(DIGITS)
}

/// From white over yellow and red to black, darker all the way: it stays readable in grey.
fn colour(digits: i32) -> RGBColor {
    let stops = [
        (255.0, 255.0, 255.0),
        (250.0, 220.0, 90.0),
        (213.0, 94.0, 0.0),
        (110.0, 0.0, 60.0),
        (0.0, 0.0, 0.0),
    ];
    let place = f64::from(digits) / f64::from(DIGITS) * 4.0;
    let below = [0, 1, 2, 3].into_iter().rfind(|&stop| f64::from(stop) <= place).unwrap_or(0);
    let share = place - f64::from(below);
    let at = |stop: i32| stops[usize::try_from(stop).unwrap_or(0).min(4)];
    let (from, to) = (at(below), at(below + 1));
    let mix = |a: f64, b: f64| {
        let mixed = (a + (b - a) * share).round();
        (0..=u8::MAX).rfind(|&level| f64::from(level) <= mixed).unwrap_or(0)
    };
    RGBColor(mix(from.0, to.0), mix(from.1, to.1), mix(from.2, to.2))
}

/// The scale of colours.
fn colours(area: &Area<'_>) -> Result<(), PictureError> {
    let font = ("sans-serif", 13);
    area.draw(&Text::new("ULP", (10, 20), font)).map_err(failed)?;
    for digits in 0..=DIGITS {
        let top = 40 + 30 * (DIGITS - digits);
        area.draw(&Rectangle::new([(10, top), (34, top + 30)], colour(digits).filled())).map_err(failed)?;
        area.draw(&Rectangle::new([(10, top), (34, top + 30)], BLACK.stroke_width(1))).map_err(failed)?;
        let label = if digits == 0 { "≤ 1".to_owned() } else { format!("≤ 1e{digits}") };
        area.draw(&Text::new(label, (40, top + 9), font)).map_err(failed)?;
    }
    Ok(())
}
