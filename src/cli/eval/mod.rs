//! The command `eval`: exact values and derivatives at a point, or at many.

mod input;
mod line;
mod point;
mod stream;
mod text;

use std::fmt;
use std::path::PathBuf;

use clap::ValueEnum;
use num_rational::BigRational;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::scalar::parse_rational;
use crate::spline::{AnyWeights, CurveEvaluator, Side};
use crate::typed::whole_number;

use super::error::CliError;
use super::exact::Exact;
use super::exit::Exit;
use super::instance::{Case, FunctionArgs};
use super::notation::NotationArgs;
use super::on_knots::exact;
use super::output::Output;
use super::progress::Progress;

pub(super) use point::PointValues;
use point::{Prepared, Request};
pub(super) use stream::Head;

/// Exact values and derivatives of the basis functions at a point, and of the curve by de Boor; or at all points of a
/// file.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLE)]
pub(super) struct Args {
    #[command(flatten)]
    function: FunctionArgs,
    /// The point x.
    #[arg(
        long,
        value_name = "X",
        value_parser = parse_rational,
        allow_hyphen_values = true,
        required_unless_present = "points_file",
        conflicts_with = "points_file"
    )]
    x: Option<BigRational>,
    /// Many points x, one on each line of a CSV or JSON Lines file, or of standard input for `-`; see below.
    #[arg(long, value_name = "FILE")]
    points_file: Option<PathBuf>,
    /// The side from which limits are taken, unless a file of points says otherwise; at t_m it is the left one in any
    /// case.
    #[arg(long, value_enum, default_value_t)]
    side: OneSide,
    /// The highest derivative, at most 50.
    #[arg(long, value_name = "D", value_parser = whole_number, allow_hyphen_values = true, default_value = "0")]
    derivatives: usize,
    #[command(flatten)]
    notation: NotationArgs,
}

const EXAMPLE: &str = r#"Examples:
  knotproof eval --instance U4 --alpha -1 --x 1 --side left --derivatives 2
  knotproof eval --degree 2 --knots "0 0 0 1 2 2 2" --alpha 5 --x 1/2 --points "0,0 1,2 2,2 3,0"
  knotproof eval --degree 2 --knots "0 0 0 1 2 2 2" --family lupas --set q=1/2 --x 1/3
  knotproof eval --instance U4 --alpha -1 --points-file points.csv > values.csv
  seq 0 0.125 3 | knotproof eval --instance U4 --alpha -1 --points-file - --format json

Files of points are read and answered line by line, in constant memory:
  CSV (.csv, .txt)
      x, or x,side with the side left or right. A first line `x` or `x,side` is a header; blank
      lines and lines that begin with # are skipped.
  JSON lines (.jsonl, .ndjson)
      A number, a string with an exact number, or {"x": "1/3", "side": "left"}.
  What eval has answered to one file of points is another one, as CSV and as JSON lines.
  Under any other name, and on standard input, it is JSON lines if the first line begins with {.
The answer has a line for each point, in the same order:
  --format text
      CSV with a header: x, side, G_0, ..., G_n, and G_0^(d), ..., G_n^(d) for each derivative d;
      with control points then the coordinates of the curve, curve_0, ... and curve_0^(d), ...
  --format json
      JSON lines. The first has what all points share: schema, degree, knots, alpha (or family), index. Each
      other is a point: x, side, values, derivatives, curve, curve_derivatives.
A line that is no point ends the run with exit code 2; the answers before it are written."#;

/// The highest derivative that is computed. The numbers grow with the order, and the time with more than its
/// cube: on knots of a few digits this one takes a second or two up to degree 5.
const DERIVATIVES_LIMIT: usize = 50;

/// The schema of the JSON.
const SCHEMA: &str = "knotproof.eval/1";

#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, ValueEnum, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
enum OneSide {
    /// The limit from below.
    Left,
    /// The limit from above, which is the value.
    #[default]
    Right,
}

impl From<OneSide> for Side {
    fn from(side: OneSide) -> Self {
        match side {
            OneSide::Left => Self::Left,
            OneSide::Right => Self::Right,
        }
    }
}

impl fmt::Display for OneSide {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        Side::from(*self).fmt(f)
    }
}

/// The result at one point: its fields are the JSON.
#[derive(Debug, Serialize, JsonSchema)]
pub(super) struct Evaluation {
    #[serde(flatten)]
    head: Head,
    #[serde(flatten)]
    at: PointValues,
    /// With control points: the levels of de Boor's algorithm, r = 0, …, k; left out where x is in no span of it.
    #[serde(skip_serializing_if = "Option::is_none")]
    de_boor: Option<Vec<Level>>,
}

/// The points d_i^r of one level of de Boor's algorithm (T4.1), i from `first`.
#[derive(Debug, Serialize, JsonSchema)]
struct Level {
    /// r.
    level: usize,
    /// The i of the first point.
    first: usize,
    /// The points, each a list of coordinates.
    points: Vec<Vec<Exact>>,
}

/// Evaluates and prints.
pub(super) fn run(args: &Args, output: &Output) -> Result<Exit, CliError> {
    if args.derivatives > DERIVATIVES_LIMIT {
        return Err(CliError::TooMany {
            argument: "--derivatives",
            given: args.derivatives,
            limit: DERIVATIVES_LIMIT,
        });
    }
    let notation = args.notation.notation()?;
    let output = output.in_notation(notation);
    let Case { label, weights, basis, curve } = args.function.instance.resolve_any()?.only_case()?;
    let index = args.function.chosen(&basis)?;
    let (order, curve) = (args.derivatives, curve.as_ref());
    let request = Request { basis: &basis, weights: &weights, curve, index, order };
    let mut prepared = request.prepared();
    if let Some(x) = &args.x {
        let progress = Progress::new(1);
        progress.step(&format!("at {x}"));
        let evaluation = evaluate(&request, &mut prepared, x, args.side, label);
        drop(progress);
        output.result(&evaluation)?;
    }
    if let Some(path) = &args.points_file {
        stream::evaluate_file(path, &request, &mut prepared, args.side, notation, &output)?;
    }
    Ok(Exit::Holds)
}

fn evaluate(
    request: &Request<'_>,
    prepared: &mut Prepared<'_>,
    x: &BigRational,
    side: OneSide,
    label: Option<String>,
) -> Evaluation {
    Evaluation {
        head: Head::of(request, label),
        at: request.at(prepared, x.clone(), side),
        de_boor: prepared.curve.as_mut().and_then(|curve| levels(curve, x, side.into())),
    }
}

fn levels(curve: &mut CurveEvaluator<'_, AnyWeights>, x: &BigRational, side: Side) -> Option<Vec<Level>> {
    let levels = curve.de_boor(x, side)?;
    let level = |(level, points): (usize, &crate::spline::Active<_>)| Level {
        level,
        first: points.first(),
        points: points.values().iter().map(|point: &Vec<_>| exact(point)).collect(),
    };
    Some(levels.iter().enumerate().map(level).collect())
}
