//! NURBS curves as files of other programs, which compute in `f64`.

mod geomdl;
mod step;

use num_rational::BigRational;
use num_traits::ToPrimitive;
use thiserror::Error;

use crate::analysis::Nurbs;

/// Whose file it is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum NurbsFile {
    /// JSON that `geomdl.exchange.import_json` of NURBS-Python reads; of one coordinate the second one is 0.
    Geomdl,
    /// STEP (ISO 10303-21, AP214): curves in space, in millimetres; coordinates that are missing are 0.
    Step,
}

/// Numbers that no file of `f64` can hold.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum NurbsFileError {
    /// Two knots that round to one.
    #[error("the knots {0} and {1} are one number as f64")]
    Knots(BigRational, BigRational),
    /// A number beyond the largest f64, or a weight below the least one.
    #[error("{what} does not fit into an f64")]
    Range {
        /// Which number.
        what: &'static str,
    },
}

/// The curves as a file: every number is the `f64` that is nearest to the exact one, in the shortest decimal that reads back
/// as it.
///
/// # Errors
/// [`NurbsFileError`], if that would be another curve.
///
/// ```
/// use knotproof::analysis::{Nurbs, NurbsRequest, RationalBezier};
/// use knotproof::report::{NurbsFile, nurbs_file};
/// use knotproof::scalar::integer;
/// use knotproof::spline::{Basis, Curve, KnotVector};
///
/// let basis = Basis::new(KnotVector::bernstein(1, &integer(0), &integer(1))?, 1, "-1".parse()?)?;
/// let curve = Curve::new(basis, vec![vec![integer(0), integer(3)], vec![integer(4), integer(0)]])?;
/// let pieces = RationalBezier::pieces(&curve).collect::<Result<Vec<_>, _>>()?;
/// let file = nurbs_file(&Nurbs::joined(&curve, &pieces, &NurbsRequest::default())?, NurbsFile::Step)?;
/// assert!(file.contains("B_SPLINE_CURVE_WITH_KNOTS((2,2),(0.0,1.0),.UNSPECIFIED.)"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn nurbs_file(curves: &[Nurbs], file: NurbsFile) -> Result<String, NurbsFileError> {
    let curves: Vec<_> = curves.iter().map(Rounded::new).collect::<Result<_, _>>()?;
    Ok(match file {
        NurbsFile::Geomdl => geomdl::file(&curves),
        NurbsFile::Step => step::file(&curves),
    })
}

/// A NURBS curve in `f64`.
struct Rounded {
    degree: usize,
    knots: Vec<f64>,
    weights: Vec<f64>,
    points: Vec<Vec<f64>>,
}

impl Rounded {
    fn new(curve: &Nurbs) -> Result<Self, NurbsFileError> {
        let list = |numbers: &[BigRational], what| numbers.iter().map(|x| nearest(x, what)).collect();
        let knots: Vec<_> = list(curve.knots(), "a knot")?;
        let lost = |j: &usize| curve.knots()[*j] < curve.knots()[j + 1] && knots[*j] >= knots[j + 1];
        if let Some(j) = (0..knots.len() - 1).find(lost) {
            return Err(NurbsFileError::Knots(curve.knots()[j].clone(), curve.knots()[j + 1].clone()));
        }
        let weight = |w: &BigRational| {
            let rounded = nearest(w, "a weight")?;
            if rounded.is_normal() { Ok(rounded) } else { Err(NurbsFileError::Range { what: "a weight" }) }
        };
        let points = curve.points();
        Ok(Self {
            degree: curve.degree(),
            knots,
            weights: curve.weights().map(weight).collect::<Result<_, _>>()?,
            points: points.iter().map(|point| list(point, "a coordinate")).collect::<Result<_, _>>()?,
        })
    }

    fn dimension(&self) -> usize {
        self.points[0].len()
    }

    /// The points in a space of this dimension, 3 at most: coordinates that are missing are 0.
    fn points_in(&self, dimension: usize) -> Vec<Vec<f64>> {
        let padded = |point: &Vec<f64>| point.iter().copied().chain([0.0; 2]).take(dimension).collect();
        self.points.iter().map(padded).collect()
    }
}

fn nearest(x: &BigRational, what: &'static str) -> Result<f64, NurbsFileError> {
    x.to_f64().filter(|rounded| rounded.is_finite()).ok_or(NurbsFileError::Range { what })
}
