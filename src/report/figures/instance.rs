//! Pictures of an instance of any paper: its functions, and its curve.

use crate::meaning::Example;

use super::canvas::PictureError;
use super::curve::Panels;
use super::sample::{float, planar};
use super::{basis, curve};

/// A picture of an instance.
#[derive(Debug)]
pub struct Picture {
    /// The name of the SVG file: `U4-2.svg`, `U4-2-curve.svg`.
    pub file: String,
    /// What it shows.
    pub title: String,
    /// The picture.
    pub svg: String,
}

/// The functions of an instance, and the curve if it has control points, for each of its indices. None if its numbers are
/// too large for `f64`, or too close: nothing could be seen.
///
/// # Errors
/// [`PictureError`], a bug of this program.
pub fn pictures(of: &Example) -> Result<Vec<Picture>, PictureError> {
    if !can_be_seen(of) {
        return Ok(Vec::new());
    }
    let (name, k) = (&of.name, of.degree);
    let title = match of.figure.as_str() {
        "" => format!("{name}, degree {k}"),
        figure => format!("{name} ({figure}), degree {k}"),
    };
    let mut pictures =
        vec![Picture { file: format!("{name}-{k}.svg"), svg: basis::svg(&title, of)?, title: title.clone() }];
    // Curves have the weights of an index.
    if of.points.is_some() && of.indices().next().is_some() {
        let svg = curve::svg(&title, std::slice::from_ref(of), Panels::Own, true)?;
        pictures.push(Picture { file: format!("{name}-{k}-curve.svg"), svg, title });
    }
    Ok(pictures)
}

/// Are its numbers neither too large for `f64` nor too close?
pub(super) fn can_be_seen(of: &Example) -> bool {
    let knots: Vec<f64> = of.knots.stop_knots().map(|(t, _)| float(t)).collect();
    let apart = knots.windows(2).all(|pair| pair[0] < pair[1]) && knots.iter().all(|t| t.abs() < LARGEST);
    let near = |(x, y): (f64, f64)| x.abs() < LARGEST && y.abs() < LARGEST;
    apart && of.points.iter().flatten().all(|point| near(planar(point)))
}

/// Beyond, the square of a number is not one of `f64`.
const LARGEST: f64 = 1e150;
