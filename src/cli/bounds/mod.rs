//! The command `bounds`: the bounding box of a curve.

mod text;

use num_rational::BigRational;
use schemars::JsonSchema;
use serde::Serialize;

use crate::analysis::{Graph, Location, RangeEnd};

use super::error::CliError;
use super::exact::{Exact, as_given};
use super::exit::Exit;
use super::notation::Notation;
use super::of_weights::OfWeights;
use super::on_curve::{CurveArgs, Known, OnCurve, Place};
use super::on_knots::exact;
use super::output::Output;
use super::solve::{FunctionOfCurve, unit};

/// The bounding box of a curve, exactly: of each coordinate the least and the greatest value, and every x that has it.
///
/// Where the coordinate is greatest at an irrational x, the value lies between exact bounds that are as close as asked for. Where the
/// curve jumps, a bound may be a limit from the left that is not taken.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLE)]
pub(super) struct Args {
    #[command(flatten)]
    curve: CurveArgs,
    #[command(flatten)]
    of: FunctionOfCurve,
}

const EXAMPLE: &str = r#"Examples, the second for the width of the curve across the direction (1, 1):
  knotproof bounds --instance C5 --alpha -4
  knotproof bounds --instance C5 --alpha -4 --normal "1 1" --digits 20
  knotproof bounds --degree 2 --knots "0 0 0 1 2 2 2" --family lupas --set q=1/2 \
    --points "0,0 1,2 2,2 3,0" --format json
Local maxima and minima as well: knotproof shape --curve."#;

/// The result: its fields are the JSON.
#[derive(Debug, Serialize, JsonSchema)]
pub(super) struct Bounds {
    /// What this object is: `knotproof.bounds/1`.
    #[schemars(extend("const" = "knotproof.bounds/1"))]
    schema: &'static str,
    #[serde(flatten)]
    on: OnCurve,
    /// One for each of its weights, and each coordinate or the function that is asked for.
    curves: Vec<OfFunction>,
}

/// The bounds of one function a·c(x).
#[derive(Debug, Serialize, JsonSchema)]
struct OfFunction {
    #[serde(flatten)]
    weights: OfWeights,
    /// a.
    #[serde(serialize_with = "as_given")]
    #[schemars(with = "Vec<String>")]
    normal: Vec<Exact>,
    /// The infimum.
    lowest: BoundRecord,
    /// The supremum.
    highest: BoundRecord,
}

/// The infimum or the supremum.
#[derive(Debug, Serialize, JsonSchema)]
struct BoundRecord {
    /// Its value.
    value: Known,
    /// Where the function has it, from left to right.
    places: Vec<BoundPlace>,
}

/// A place where a bound is.
#[derive(Debug, Serialize, JsonSchema)]
struct BoundPlace {
    #[serde(flatten)]
    place: Place,
    /// Is it the value there? Otherwise it is the limit from the left, at a jump.
    taken: bool,
}

/// Finds the bounds and prints them.
pub(super) fn run(args: &Args, output: &Output) -> Result<Exit, CliError> {
    let notation = args.curve.notation()?;
    let (on, all) = args.curve.pieces()?;
    let normals = match args.of.chosen(on.dimension)? {
        Some(normal) => vec![normal],
        None => (0..on.dimension).map(|c| unit(c, on.dimension)).collect(),
    };
    let mut curves = Vec::new();
    for curve in &all {
        for normal in &normals {
            let range = Graph::of(&curve.pieces, normal).range();
            curves.push(OfFunction {
                weights: OfWeights::of(&curve.case.weights),
                normal: exact(normal),
                lowest: BoundRecord::new(range.lowest, args.curve.width(), notation),
                highest: BoundRecord::new(range.highest, args.curve.width(), notation),
            });
        }
    }
    output.in_notation(notation).result(&Bounds { schema: "knotproof.bounds/1", on, curves })?;
    Ok(Exit::Holds)
}

impl BoundRecord {
    fn new(bound: RangeEnd, width: &BigRational, notation: Notation) -> Self {
        let place = |(place, taken): &(Location, bool)| BoundPlace {
            place: Place::of(place, width, notation),
            taken: *taken,
        };
        let places = bound.places.iter().map(place).collect();
        Self { value: Known::of(bound.value, width, notation), places }
    }
}
