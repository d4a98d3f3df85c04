//! The command `solve`: where a curve takes a value.

mod text;

use num_rational::BigRational;
use schemars::JsonSchema;
use serde::Serialize;

use crate::analysis::{Graph, Sign, Solution, SolutionKind};
use crate::scalar::{integer, parse_rational};
use crate::typed::{Provenance, numbers, whole_number};

use super::error::CliError;
use super::exact::{Exact, as_given};
use super::exit::Exit;
use super::notation::Notation;
use super::of_weights::OfWeights;
use super::on_curve::{CurveArgs, Known, OnCurve, Place};
use super::on_knots::exact;
use super::output::Output;

/// Where a coordinate of a curve, or the equation of a line or a plane, takes a value: every x, exactly.
///
/// Roots are isolated, never searched for: rational ones are found as such, others between bounds that are as close as asked
/// for. Where the curve is the value on a whole interval, that is one answer. Where it jumps, at knots of more than k copies, a limit
/// from the left that is the value and not taken is told, and so is a value that the jump passes.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLE)]
pub(super) struct Args {
    #[command(flatten)]
    curve: CurveArgs,
    #[command(flatten)]
    of: FunctionOfCurve,
    /// The value v; may be repeated. 0 if there is none.
    #[arg(long = "value", value_name = "V", value_parser = parse_rational, allow_hyphen_values = true)]
    values: Vec<BigRational>,
}

const EXAMPLE: &str = r#"The exit code is 0 whatever is found: no solution is an answer, too.

Examples, the second for the line x + 2y = 8 in the plane:
  knotproof solve --instance C5 --alpha -4 --coordinate 1 --value 4
  knotproof solve --instance C5 --alpha -4 --normal "1 2" --value 8 --from 1 --to 4
  knotproof solve --degree 2 --knots "0 0 0 1 2 2 2" --alpha 5 --points "0 3 -1 2" --format json"#;

/// The arguments that pick a function of a curve.
#[derive(Debug, clap::Args)]
pub(super) struct FunctionOfCurve {
    /// The coordinate C, counted from 0; may be left out in one dimension.
    #[arg(long, value_name = "C", value_parser = whole_number, allow_hyphen_values = true, conflicts_with = "normal")]
    coordinate: Option<usize>,
    /// a·c(x) in place of a coordinate: one number for each coordinate, "1 2" for x + 2y.
    #[arg(long, value_name = "LIST", allow_hyphen_values = true)]
    normal: Option<String>,
}

impl FunctionOfCurve {
    /// a; `None` if nothing is said.
    ///
    /// # Errors
    /// [`CliError::Coordinate`], [`CliError::Normal`] and those of a list.
    pub(super) fn chosen(&self, dimension: usize) -> Result<Option<Vec<BigRational>>, CliError> {
        if let Some(text) = &self.normal {
            let normal = numbers(text, &Provenance::option("--normal"))?;
            if normal.len() != dimension {
                return Err(CliError::Normal { count: normal.len(), dimension });
            }
            return Ok(Some(normal));
        }
        match self.coordinate {
            Some(coordinate) if coordinate >= dimension => {
                Err(CliError::Coordinate { coordinate, dimension })
            }
            Some(coordinate) => Ok(Some(unit(coordinate, dimension))),
            None => Ok(None),
        }
    }
}

/// The vector whose product with a point is the coordinate.
pub(super) fn unit(coordinate: usize, dimension: usize) -> Vec<BigRational> {
    (0..dimension).map(|c| integer(i64::from(c == coordinate))).collect()
}

/// The result: its fields are the JSON.
#[derive(Debug, Serialize, JsonSchema)]
pub(super) struct Solved {
    /// What this object is: `knotproof.solve/1`.
    #[schemars(extend("const" = "knotproof.solve/1"))]
    schema: &'static str,
    #[serde(flatten)]
    on: OnCurve,
    /// a: the function is a·c(x).
    #[serde(serialize_with = "as_given")]
    #[schemars(with = "Vec<String>")]
    normal: Vec<Exact>,
    /// One for each of its weights and each value.
    curves: Vec<OfValue>,
}

/// All solutions for one value.
#[derive(Debug, Serialize, JsonSchema)]
struct OfValue {
    #[serde(flatten)]
    weights: OfWeights,
    /// v.
    #[serde(serialize_with = "as_given")]
    #[schemars(with = "String")]
    value: Exact,
    /// From left to right.
    solutions: Vec<SolutionRecord>,
}

/// A place where a·c(x) meets the value.
#[derive(Debug, Serialize, JsonSchema)]
struct SolutionRecord {
    /// In which way: the curve takes the value; or has it as the limit from the left and takes another; or passes it in a jump.
    #[schemars(extend("enum" = ["taken", "limit_from_left", "passed"]))]
    kind: &'static str,
    #[serde(flatten)]
    place: Place,
    /// The sign of a·c(x) − v just before; `null` where the part begins.
    before: Option<i8>,
    /// And just after; `null` where the part ends.
    after: Option<i8>,
    /// The point of the curve there, a limit from the left where that is the solution; `null` on an interval and in a jump.
    point: Option<Vec<Known>>,
}

/// Solves and prints.
pub(super) fn run(args: &Args, output: &Output) -> Result<Exit, CliError> {
    let notation = args.curve.notation()?;
    let (on, all) = args.curve.pieces()?;
    let normal = match args.of.chosen(on.dimension)? {
        Some(normal) => normal,
        None if on.dimension == 1 => unit(0, 1),
        None => return Err(CliError::NoCoordinate { dimension: on.dimension }),
    };
    let values = if args.values.is_empty() { vec![integer(0)] } else { args.values.clone() };
    let mut curves = Vec::new();
    for curve in &all {
        let graph = Graph::of(&curve.pieces, &normal);
        let coordinates: Vec<_> =
            (0..on.dimension).map(|c| Graph::of(&curve.pieces, &unit(c, on.dimension))).collect();
        for value in &values {
            let record = |solution: &Solution| {
                SolutionRecord::new(solution, &coordinates, args.curve.width(), notation)
            };
            curves.push(OfValue {
                weights: OfWeights::of(&curve.case.weights),
                value: Exact(value.clone()),
                solutions: graph.solutions(value).iter().map(record).collect(),
            });
        }
    }
    let solved = Solved { schema: "knotproof.solve/1", on, normal: exact(&normal), curves };
    output.in_notation(notation).result(&solved)?;
    Ok(Exit::Holds)
}

impl SolutionRecord {
    fn new(solution: &Solution, coordinates: &[Graph], width: &BigRational, notation: Notation) -> Self {
        let sign = |sign: Sign| match sign {
            Sign::Negative => -1,
            Sign::Zero => 0,
            Sign::Positive => 1,
        };
        let point: Option<Vec<_>> = coordinates.iter().map(|graph| graph.at(solution)).collect();
        Self {
            kind: match solution.kind {
                SolutionKind::Taken => "taken",
                SolutionKind::LimitFromLeft => "limit_from_left",
                SolutionKind::Passed => "passed",
            },
            place: Place::of(&solution.place, width, notation),
            before: solution.before.map(sign),
            after: solution.after.map(sign),
            point: point.map(|point| point.into_iter().map(|c| Known::of(c, width, notation)).collect()),
        }
    }
}
