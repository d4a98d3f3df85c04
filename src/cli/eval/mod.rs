//! The command `eval`: exact values and derivatives at a point.

mod text;

use clap::ValueEnum;
use num_rational::BigRational;
use serde::Serialize;

use crate::scalar::{Jet, parse_rational};
use crate::spline::{Basis, Curve, Side};

use super::error::CliError;
use super::exact::Exact;
use super::exit::Exit;
use super::instance::{FunctionArgs, InstanceArgs, whole_number};
use super::output::Output;

/// Exact values and derivatives of the basis functions at a point, and of the curve by de Boor.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLE)]
pub(super) struct Args {
    #[command(flatten)]
    instance: InstanceArgs,
    #[command(flatten)]
    function: FunctionArgs,
    /// The point x.
    #[arg(long, value_name = "X", value_parser = parse_rational, allow_hyphen_values = true)]
    x: BigRational,
    /// The side from which limits are taken; at t_m it is the left one in any case.
    #[arg(long, value_enum, default_value_t)]
    side: OneSide,
    /// The highest derivative, at most 50.
    #[arg(long, value_name = "D", value_parser = whole_number, allow_hyphen_values = true, default_value = "0")]
    derivatives: usize,
}

const EXAMPLE: &str = r#"Examples:
  knotproof eval --instance U4 --alpha -1 --x 1 --side left --derivatives 2
  knotproof eval --degree 2 --knots "0 0 0 1 2 2 2" --alpha 5 --x 1/2 --points "0,0 1,2 2,2 3,0""#;

/// The highest derivative that is computed. The numbers grow with the order, and the time with more than its
/// cube: on knots of a few digits this one takes a second or two up to degree 5.
const DERIVATIVES_LIMIT: usize = 50;

#[derive(Debug, Clone, Copy, Default, ValueEnum, Serialize)]
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

/// The result: its fields are the JSON.
#[derive(Debug, Serialize)]
struct Evaluation {
    schema: &'static str,
    degree: usize,
    knots: Vec<Exact>,
    alpha: String,
    x: Exact,
    side: OneSide,
    #[serde(skip_serializing_if = "Option::is_none")]
    index: Option<usize>,
    values: Vec<Exact>,
    /// Entry d − 1 holds the d-th derivatives.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    derivatives: Vec<Vec<Exact>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    curve: Option<Vec<Exact>>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    curve_derivatives: Vec<Vec<Exact>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    de_boor: Option<Vec<Level>>,
    #[serde(skip)]
    label: Option<String>,
}

/// The points d_i^r of one level of de Boor's algorithm (T4.1), i from `first`.
#[derive(Debug, Serialize)]
struct Level {
    level: usize,
    first: usize,
    points: Vec<Vec<Exact>>,
}

/// Evaluates and prints.
pub(super) fn run(args: &Args, output: &Output) -> Result<Exit, CliError> {
    if args.derivatives > DERIVATIVES_LIMIT {
        return Err(CliError::Derivatives { order: args.derivatives, limit: DERIVATIVES_LIMIT });
    }
    let subject = args.instance.resolve()?;
    let label = subject.label.clone();
    let case = subject.only_case()?;
    let index = args.function.chosen(&case.basis)?;
    output.result(&evaluate(args, &case.basis, case.curve.as_ref(), index, label))?;
    Ok(Exit::Holds)
}

fn evaluate(
    args: &Args,
    basis: &Basis,
    curve: Option<&Curve>,
    index: Option<usize>,
    label: Option<String>,
) -> Evaluation {
    let (x, side, order) = (&args.x, args.side.into(), args.derivatives);
    let mut functions = basis.jets(x, side, order);
    if let Some(index) = index {
        functions = vec![functions.swap_remove(index)];
    }
    let mut derivatives = by_order(&functions, order);
    let values = derivatives.remove(0);
    let mut coordinates = curve.map(|curve| by_order(&curve.jets(x, side, order), order)).unwrap_or_default();
    let point = (!coordinates.is_empty()).then(|| coordinates.remove(0));
    Evaluation {
        schema: "knotproof.eval/1",
        degree: basis.degree(),
        knots: exact(basis.knots().knots()),
        alpha: basis.index().to_string(),
        x: Exact(x.clone()),
        side: args.side,
        index,
        values,
        derivatives,
        curve: point,
        curve_derivatives: coordinates,
        de_boor: curve.and_then(|curve| levels(curve, x, side)),
        label,
    }
}

/// Entry d holds the d-th derivatives of all the jets.
fn by_order(jets: &[Jet<BigRational>], order: usize) -> Vec<Vec<Exact>> {
    let derivatives: Vec<_> = jets.iter().map(Jet::derivatives).collect();
    (0..=order).map(|d| derivatives.iter().map(|of_one| Exact(of_one[d].clone())).collect()).collect()
}

fn levels(curve: &Curve, x: &BigRational, side: Side) -> Option<Vec<Level>> {
    let levels = curve.de_boor(x, side)?;
    let level = |(level, points): (usize, &crate::spline::Active<_>)| Level {
        level,
        first: points.first(),
        points: points.values().iter().map(|point: &Vec<_>| exact(point)).collect(),
    };
    Some(levels.iter().enumerate().map(level).collect())
}

fn exact(numbers: &[BigRational]) -> Vec<Exact> {
    numbers.iter().cloned().map(Exact).collect()
}
