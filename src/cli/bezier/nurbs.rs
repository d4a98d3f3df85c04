//! `bezier --as`: the pieces joined to NURBS curves.

use num_rational::BigRational;
use schemars::JsonSchema;
use serde::Serialize;

use crate::analysis::{Nurbs, NurbsRequest};
use crate::report::nurbs_file;
use crate::scalar::{decimal, integer};
use crate::spline::{AnyWeights, Curve, Point};

use super::super::error::CliError;
use super::super::exact::{Exact, as_given};
use super::super::of_weights::OfWeights;
use super::super::on_knots::{OnKnots, exact};
use super::super::output::Output;
use super::{Form, pieces, progress, verify};

/// The highest degree that Open CASCADE has (`Geom_BSplineCurve::MaxDegree`), and so many programs built on it.
const KERNEL_LIMIT: usize = 25;
/// How far apart weights may be before that is said: where the smaller one is lost in a sum of floats.
const SPREAD_LIMIT: u64 = 1 << 53;

/// The result: its fields are the JSON.
#[derive(Debug, Serialize, JsonSchema)]
pub(in super::super) struct Joined {
    /// What this object is: `knotproof.bezier.nurbs/1`.
    #[schemars(extend("const" = "knotproof.bezier.nurbs/1"))]
    schema: &'static str,
    #[serde(flatten)]
    pub(super) on: OnKnots,
    #[serde(flatten)]
    pub(super) weights: OfWeights,
    /// The control points d_0, …, d_n of the source, each a list of coordinates: exactly as given, whatever the notation. With
    /// degree, knots and weights they make the curve that the NURBS curves are.
    #[serde(serialize_with = "as_given")]
    #[schemars(with = "Vec<Vec<String>>")]
    points: Vec<Vec<Exact>>,
    /// The number of coordinates of a point.
    dimension: usize,
    /// Whom the result is for without --format json.
    #[serde(rename = "as")]
    form: Form,
    /// [t_k, t_{n+1}], where the basis functions add up to 1.
    pub(super) base: [Exact; 2],
    /// Do all pieces begin and end with weight 1? Then each curve has `parameter`.
    pub(super) standard_form: bool,
    /// Where the curve jumps, between one NURBS curve and the next.
    pub(super) jumps: Vec<Exact>,
    /// From left to right, one for each connected run of the curve.
    pub(super) curves: Vec<Run>,
    /// What other programs may not bear.
    pub(super) warnings: Vec<String>,
    /// With --as geomdl or step that file, as it is without --format json.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) source: Option<String>,
}

/// A connected run as one NURBS curve.
#[derive(Debug, Serialize, JsonSchema)]
pub(super) struct Run {
    /// Its degree D.
    pub(super) degree: usize,
    /// Its knots, D + 1 more than there are control points: D + 1 copies of the first one and of the last one.
    pub(super) knots: Vec<Exact>,
    /// Its weights, all positive; the first one is 1.
    pub(super) weights: Vec<Exact>,
    /// Its control points, each a list of coordinates, not multiplied by the weights.
    pub(super) points: Vec<Vec<Exact>>,
    /// In standard form, for each of its spans, what its parameter is against that of the source.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) parameter: Option<Vec<Change>>,
}

/// A change of parameter on a span [a, b]: at y the NURBS curve has the point that the source has at x, with
/// (x − a)/(b − x) = λ (y − a)/(b − y).
#[derive(Debug, Serialize, JsonSchema)]
pub(super) struct Change {
    /// a.
    pub(super) from: Exact,
    /// b.
    pub(super) to: Exact,
    /// λ > 0.
    pub(super) ratio: Exact,
    /// The weight at b: 1, or if no rational λ gives that, a number that differs from it by less than 1e-18.
    pub(super) weight: Exact,
}

/// Joins the pieces, turns the result back and compares it with the curve.
pub(super) fn join(
    curve: &Curve<AnyWeights>,
    (on, weights): (OnKnots, OfWeights),
    form: Form,
    request: NurbsRequest,
) -> Result<Joined, CliError> {
    let progress = progress(curve);
    let runs = Nurbs::joined(curve, &pieces(curve, &progress)?, &request)?;
    let mut compared = runs.iter().flat_map(Nurbs::pieces);
    compared.try_for_each(|piece| verify(&piece, curve, &progress))?;
    drop(progress);
    let (basis, knots) = (curve.basis(), curve.basis().knots());
    let ends = |run: &Nurbs| run.knots().last().cloned().map(Exact);
    Ok(Joined {
        schema: "knotproof.bezier.nurbs/1",
        on,
        weights,
        points: coordinates(curve.points()),
        dimension: curve.dimension(),
        form,
        base: [basis.degree(), basis.n() + 1].map(|i| Exact(knots.t(i).clone())),
        standard_form: request.standard_form,
        jumps: runs[..runs.len().saturating_sub(1)].iter().filter_map(ends).collect(),
        warnings: warnings(&runs, request.standard_form),
        source: form.file().map(|file| nurbs_file(&runs, file)).transpose()?,
        curves: runs.iter().map(|run| Run::new(run, request.standard_form)).collect(),
    })
}

fn coordinates(points: &[Point]) -> Vec<Vec<Exact>> {
    points.iter().map(|point| exact(point)).collect()
}

fn warnings(runs: &[Nurbs], standard_form: bool) -> Vec<String> {
    let mut warnings = Vec::new();
    if let Some(degree) = runs.first().map(Nurbs::degree).filter(|degree| *degree > KERNEL_LIMIT) {
        warnings.push(format!(
            "degree {degree} is above {KERNEL_LIMIT}, the highest that Open CASCADE and programs built on it read; curves of degree \
             k ≤ 6 stay below"
        ));
    }
    let spread = runs.iter().filter_map(spread).max().filter(|spread| *spread >= integer(SPREAD_LIMIT));
    if let Some(spread) = spread {
        let advice = if standard_form { "" } else { "; --standard-form brings them closer" };
        warnings.push(format!("the weights are up to {} times apart{advice}", decimal(&spread, 2)));
    }
    warnings
}

/// The largest weight over the smallest one.
fn spread(run: &Nurbs) -> Option<BigRational> {
    Some(run.weights().max()? / run.weights().min()?)
}

impl Joined {
    /// Says on standard error what a file can't say.
    pub(super) fn warn(&self, output: &Output) {
        if self.source.is_some() {
            self.notes().iter().chain(&self.warnings).for_each(|warning| output.warning(warning));
        }
    }
}

impl Run {
    fn new(run: &Nurbs, standard_form: bool) -> Self {
        let changes = || {
            run.parameters().iter().map(|parameter| Change {
                from: Exact(parameter.ends[0].clone()),
                to: Exact(parameter.ends[1].clone()),
                ratio: Exact(parameter.ratio.clone()),
                weight: Exact(parameter.weight.clone()),
            })
        };
        Self {
            degree: run.degree(),
            knots: exact(run.knots()),
            weights: run.weights().cloned().map(Exact).collect(),
            points: coordinates(&run.points()),
            parameter: standard_form.then(|| changes().collect()),
        }
    }
}
