//! The command `insert`: the same curve on more knots.

use std::fmt;

use schemars::JsonSchema;
use serde::Serialize;

use crate::analysis::{RefinementError, refined};
use crate::typed::{Provenance, numbers};

use super::error::CliError;
use super::exact::{Exact, as_given};
use super::exit::Exit;
use super::instance::{InstanceArgs, Resolved};
use super::notation::{Notation, NotationArgs};
use super::of_weights::OfWeights;
use super::on_curve::{curve_of, if_too_high};
use super::on_knots::{OnKnots, exact, tuple};
use super::output::Output;
use super::progress::Progress;
use super::table::{plain, right_aligned};

/// Inserts knots into a curve, exactly: its control points on the new knots; or that the curve is none on them.
///
/// For α = ∞ every knot can be inserted. For other α the functions of a new knot inside of a span have a corner there, so a
/// general curve is not among them: then the answer says so, with the ranks that prove it. A knot of k copies can have one more for every α:
/// there the curve is cut. Knots of a curve as NURBS can be inserted as usual: `knotproof bezier --as nurbs` has it.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLE)]
pub(super) struct Args {
    #[command(flatten)]
    instance: InstanceArgs,
    /// The new knots, separated by commas or spaces; each as often as it is to be inserted.
    #[arg(long, value_name = "LIST", allow_hyphen_values = true)]
    at: String,
    #[command(flatten)]
    notation: NotationArgs,
}

const EXAMPLE: &str = r#"Exit codes: 0 the curve is one on the new knots; 1 it is none.

Examples:
  knotproof insert --degree 2 --knots "0 0 0 1 2 2 2" --alpha inf --points "0,0 1,2 2,2 3,0" \
    --at "1/2 1"
  knotproof insert --degree 2 --knots "0 0 0 1 1 2 2 2" --alpha 5 \
    --points "0,0 1,2 2,2 3,0 4,0" --at 1 --format json > cut.json
  knotproof insert --instance C5 --alpha -4 --at 1/2  # exit code 1
The JSON is an instance file, with the new knots: knotproof eval --instance cut.json --x 1/3."#;

/// The result: its fields are the JSON.
#[derive(Debug, Serialize, JsonSchema)]
pub(super) struct Inserted {
    /// What this object is: `knotproof.insert/1`.
    #[schemars(extend("const" = "knotproof.insert/1"))]
    schema: &'static str,
    #[serde(flatten)]
    on: OnKnots,
    #[serde(flatten)]
    weights: OfWeights,
    /// What was inserted.
    #[serde(serialize_with = "as_given")]
    #[schemars(with = "Vec<String>")]
    at: Vec<Exact>,
    /// The control points on the new knots, which are `knots`; `null` if the curve is none on them.
    points: Option<Vec<Vec<Exact>>>,
    /// Why it is none.
    reason: Option<String>,
}

/// Inserts and prints.
pub(super) fn run(args: &Args, output: &Output) -> Result<Exit, CliError> {
    let output = output.in_notation(args.notation.notation()?);
    let resolved = args.instance.resolve_any()?;
    if let Resolved::Member(subject) = &resolved {
        return Err(CliError::OnlyIndices { option: "--at", family: subject.family() });
    }
    let case = resolved.only_case()?;
    let (Some(index), curve) = (case.weights.index(), curve_of(&case)?) else {
        unreachable!("other families are refused")
    };
    let curve = curve.with(index.clone());
    if_too_high(&case.basis)?;
    let new = numbers(&args.at, &Provenance::option("--at"))?;
    let progress = Progress::new(1);
    progress.step("the space of the functions on the new knots");
    let found = refined(&curve, &new);
    drop(progress);
    let (points, reason) = match &found {
        Ok(curve) => (Some(curve.points().iter().map(|point| exact(point)).collect()), None),
        Err(error @ RefinementError::NotInSpace { .. }) => (None, Some(error.to_string())),
        Err(error) => return Err(error.clone().into()),
    };
    let finer = new.iter().fold(curve.basis().knots().clone(), |knots, knot| knots.with_knot(knot));
    let mut on = OnKnots::of(curve.basis(), case.label);
    on.knots = exact(finer.knots());
    let weights = OfWeights::of(&case.weights);
    output.result(&Inserted {
        schema: "knotproof.insert/1",
        on,
        weights,
        at: exact(&new),
        points,
        reason,
    })?;
    Ok(if found.is_ok() { Exit::Holds } else { Exit::Refuted })
}

impl fmt::Display for Inserted {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{}, {}, with {} inserted", self.on, self.weights, tuple(&self.at))?;
        if let Some(reason) = &self.reason {
            return writeln!(f, "There are no control points for them: {reason}.");
        }
        let notation = Notation::in_force();
        let mut table = plain(["i", "d_i", "≈"]);
        for (i, point) in self.points.iter().flatten().enumerate() {
            let decimals: Vec<_> = point.iter().map(|c| notation.approximation(&c.0)).collect();
            table.add_row([i.to_string(), tuple(point), tuple(&decimals)]);
        }
        right_aligned(&mut table, 0);
        writeln!(f, "The curve is the same for every x (checked exactly).\n{}", table.trim_fmt())
    }
}
