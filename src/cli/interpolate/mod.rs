//! The command `interpolate`: the curve through given points, and when there is one.

mod text;

use num_rational::BigRational;
use num_traits::Zero;
use schemars::JsonSchema;
use serde::Serialize;

use crate::analysis::{Collocation, InterpolationError};
use crate::spline::Point;
use crate::typed::{Provenance, numbers};

use super::error::CliError;
use super::exact::{Exact, as_given};
use super::exit::Exit;
use super::instance::{Case, InstanceArgs};
use super::notation::NotationArgs;
use super::of_weights::OfWeights;
use super::on_knots::{OnKnots, exact};
use super::output::Output;
use super::progress::Progress;

/// The curve that goes through given points at given x, exactly: its control points; or why there is none.
///
/// With --points, those are the points to go through, one for each x of --at. Without, the matrix of all functions at these x, its rank and
/// its determinant. Interpolation at n + 1 places is possible if and only if the determinant is not 0. That G_i is not 0 at place i, for
/// every i (the condition of Schoenberg and Whitney), is necessary; for α = ∞ it suffices, for other α it does not always.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLE)]
pub(super) struct Args {
    #[command(flatten)]
    instance: InstanceArgs,
    /// The places x_0 < x_1 < …, separated by commas or spaces; a curve takes n + 1 of them.
    #[arg(long, value_name = "LIST", allow_hyphen_values = true)]
    at: String,
    #[command(flatten)]
    notation: NotationArgs,
}

const EXAMPLE: &str = r#"Exit codes: 0 there is one curve, or the matrix was asked for; 1 there is none, or more than one.

Examples:
  knotproof interpolate --degree 2 --knots "0 0 0 1 2 2 2" --alpha 5 --at "0 1/2 3/2 2" \
    --points "0,0 1,2 2,2 3,0"
  knotproof interpolate --degree 2 --knots "0 0 0 1 2 2 2" --alpha 5 --at "0 1/2 3/2 2"
  knotproof interpolate --degree 2 --knots "0 0 0 1 2 2 2" --alpha 5 --at "0 1/2 3/4 2" \
    --points "0 1 2 3" --format json > curve.json
The JSON is an instance file, with the control points: knotproof eval --instance curve.json --x 1."#;

/// The result: its fields are the JSON.
#[derive(Debug, Serialize, JsonSchema)]
pub(super) struct Interpolation {
    /// What this object is: `knotproof.interpolate/1`.
    #[schemars(extend("const" = "knotproof.interpolate/1"))]
    schema: &'static str,
    #[serde(flatten)]
    on: OnKnots,
    #[serde(flatten)]
    weights: OfWeights,
    /// x_0 < x_1 < …
    #[serde(serialize_with = "as_given")]
    #[schemars(with = "Vec<String>")]
    at: Vec<Exact>,
    /// G_0(x_j), …, G_n(x_j) for each place x_j, from the right; at t_m from the left.
    matrix: Vec<Vec<Exact>>,
    /// Its rank.
    rank: usize,
    /// Its determinant; `null` unless there are n + 1 places.
    determinant: Option<Exact>,
    /// Each i with G_i(x_i) = 0: none, if the condition of Schoenberg and Whitney holds.
    misplaced: Vec<usize>,
    /// c_0, …, c_n, not all 0, with Σ c_i G_i = 0 at every place; `null` if there are none.
    relation: Option<Vec<Exact>>,
    /// The points to go through; `null` if none were given.
    #[serde(serialize_with = "as_given")]
    #[schemars(with = "Option<Vec<Vec<String>>>")]
    through: Option<Vec<Vec<Exact>>>,
    /// The control points of the curve; `null` if there is none, or if none was asked for.
    points: Option<Vec<Vec<Exact>>>,
    /// Why there is not exactly one curve.
    reason: Option<String>,
}

/// Interpolates and prints.
pub(super) fn run(args: &Args, output: &Output) -> Result<Exit, CliError> {
    let output = output.in_notation(args.notation.notation()?);
    let Case { label, weights, basis, curve } = args.instance.resolve_any()?.only_case()?;
    let places = numbers(&args.at, &Provenance::option("--at"))?;
    let progress = Progress::new(2);
    progress.step("the matrix");
    let collocation = Collocation::new(&basis, places)?;
    let through = curve.as_ref().map(|curve| curve.points());
    progress.step("the curve");
    let solved = through.map(|through| collocation.interpolate(through));
    drop(progress);
    let (found, reason) = match solved {
        None => (None, None),
        Some(Ok(curve)) => (Some(curve), None),
        Some(Err(error @ InterpolationError::Singular { .. })) => (None, Some(error.to_string())),
        Some(Err(error)) => return Err(error.into()),
    };
    let exit = if reason.is_none() { Exit::Holds } else { Exit::Refuted };
    let points = |points: &[Point]| points.iter().map(|point| exact(point)).collect();
    output.result(&Interpolation {
        schema: "knotproof.interpolate/1",
        on: OnKnots::of(&basis, label),
        weights: OfWeights::of(&weights),
        at: exact(collocation.places()),
        matrix: points(collocation.rows()),
        rank: collocation.rank(),
        determinant: collocation.determinant().map(Exact),
        misplaced: collocation.misplaced(),
        relation: collocation.relation().map(|relation| exact(&whole(&relation))),
        through: through.map(points),
        points: found.as_ref().map(|curve| points(curve.points())),
        reason,
    })?;
    Ok(exit)
}

/// A multiple in which the first number that is not 0 is 1.
fn whole(numbers: &[BigRational]) -> Vec<BigRational> {
    match numbers.iter().find(|number| !number.is_zero()) {
        Some(first) => numbers.iter().map(|number| number / first).collect(),
        None => numbers.to_vec(),
    }
}
