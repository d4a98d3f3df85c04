//! The command `length`: how long a curve is, and the integrals of its coordinates.

use std::fmt;

use schemars::JsonSchema;
use serde::Serialize;

use crate::analysis::{integrals, length};
use crate::scalar::{decimal, decimal_neighbours};

use super::error::CliError;
use super::exact::{Exact, as_given};
use super::exit::Exit;
use super::of_weights::OfWeights;
use super::on_curve::{CurveArgs, Known, OnCurve};
use super::output::Output;
use super::progress::Progress;
use super::table::{HEADING, plain};

/// The length of a curve, and the integrals of its coordinates: each between two exact bounds, as close as asked for.
///
/// Bounds are proved, in exact arithmetic: by the series of the integrand around the middle of an interval, with Cauchy's bound of what is
/// left out, and close to a cusp by the chord and the control polygon. They are equal where the number is known exactly: integrals for
/// α = ∞, and lengths of polygons with rational sides.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLE)]
pub(super) struct Args {
    #[command(flatten)]
    curve: CurveArgs,
}

const EXAMPLE: &str = r#"Examples:
  knotproof length --instance C5 --alpha -4
  knotproof length --instance C5 --alpha inf --from 1 --to 3 --width 1e-30
  knotproof length --degree 1 --knots "0 0 1 2 2" --alpha 5 --points "0,0 3,4 3,5" --format json"#;

/// The result: its fields are the JSON.
#[derive(Debug, Serialize, JsonSchema)]
pub(super) struct Lengths {
    /// What this object is: `knotproof.length/1`.
    #[schemars(extend("const" = "knotproof.length/1"))]
    schema: &'static str,
    #[serde(flatten)]
    on: OnCurve,
    /// The bounds of a number are not farther apart.
    #[serde(serialize_with = "as_given")]
    #[schemars(with = "String")]
    width: Exact,
    /// One for each of its weights.
    curves: Vec<OfCurve>,
}

/// The length and the integrals of one curve.
#[derive(Debug, Serialize, JsonSchema)]
struct OfCurve {
    #[serde(flatten)]
    weights: OfWeights,
    /// ∫ |c′(x)| dx; jumps add nothing.
    length: Known,
    /// ∫ c(x) dx, for each coordinate.
    integrals: Vec<Known>,
}

/// Measures and prints.
pub(super) fn run(args: &Args, output: &Output) -> Result<Exit, CliError> {
    let notation = args.curve.notation()?;
    let (on, all) = args.curve.pieces()?;
    let width = args.curve.width();
    let progress = Progress::new(2 * all.len());
    let mut curves = Vec::new();
    for curve in &all {
        progress.step(&format!("the length, {}", curve.case.weights));
        let length = Known::between(length(&curve.pieces, width), notation);
        progress.step(&format!("the integrals, {}", curve.case.weights));
        let integrals = integrals(&curve.pieces, width);
        curves.push(OfCurve {
            weights: OfWeights::of(&curve.case.weights),
            length,
            integrals: integrals.into_iter().map(|bounds| Known::between(bounds, notation)).collect(),
        });
    }
    drop(progress);
    let width = Exact(width.clone());
    output.in_notation(notation).result(&Lengths { schema: "knotproof.length/1", on, width, curves })?;
    Ok(Exit::Holds)
}

impl fmt::Display for Lengths {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{}", self.on.on)?;
        for OfCurve { weights, length, integrals } in &self.curves {
            writeln!(f, "\n{HEADING}{weights}, x in [{}, {}]{HEADING:#}", self.on.from, self.on.to)?;
            let mut table = plain(["", "exactly", "≈"]);
            let mut row = |name: String, number: &Known| {
                table.add_row([name, number.fraction(), number.decimal.0.clone()]);
            };
            row("length".to_owned(), length);
            for (c, integral) in integrals.iter().enumerate() {
                row(format!("∫ coordinate {c}"), integral);
            }
            writeln!(f, "{}", table.trim_fmt())?;
        }
        let width = decimal(&decimal_neighbours(&self.width.0, 2).1, 2);
        writeln!(
            f,
            "\nAll digits are settled, by exact bounds at most {width} apart: --format json has them."
        )
    }
}
