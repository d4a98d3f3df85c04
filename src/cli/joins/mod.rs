//! The command `joins`: how smooth a curve is at its knots.

mod text;

use std::borrow::Cow;
use std::ffi::OsString;

use schemars::JsonSchema;
use serde::Serialize;

use crate::analysis::{Angle, Branch, Join, Surd, joins};
use crate::language::paper;
use crate::meaning::{Example, Weighting, examples_of};
use crate::spline::{AnyWeights, Curve};

use super::error::CliError;
use super::exact::{Exact, as_given};
use super::exit::Exit;
use super::instance::{Case, InstanceArgs};
use super::notation::{Decimal, Notation, NotationArgs};
use super::of_weights::OfWeights;
use super::on_knots::{OnKnots, exact};
use super::output::Output;
use super::paper::paper_of;
use super::progress::Progress;

/// How smooth a curve is at its knots: how far the tangent turns, the speed changes and the curvature jumps, exactly.
///
/// At each knot inside the interval both sides are compared: G⁰, the points are equal; G¹, so are the directions; G², so are
/// the vectors of curvature. The end of a closed curve is compared with its beginning, too. Where c′ = 0 the direction is that
/// of the first derivative that is not 0.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLE)]
pub(super) struct Args {
    #[command(flatten)]
    instance: InstanceArgs,
    /// Every curve of the paper, for each α of its figures.
    #[arg(long, conflicts_with_all = ["instance", "degree", "knots", "alpha", "points", "family", "set"])]
    all: bool,
    /// The curves and the instances of this paper: a folder, or the name of one that comes with the program.
    #[arg(long, value_name = "FOLDER|NAME")]
    paper: Option<OsString>,
    #[command(flatten)]
    notation: NotationArgs,
}

const EXAMPLE: &str = r#"The exit code is 0 whatever is found: a corner is no failure.

Examples:
  knotproof joins --instance C5 --alpha -4
  knotproof joins --degree 2 --knots "0 0 0 1 2 2 2" --alpha 5 --points "0,0 1,2 2,2 3,0" \
    --format json
  knotproof joins --degree 2 --knots "0 0 0 1 2 2 2" --family lupas --set q=1/2 \
    --points "0,0 1,2 2,2 3,0"
  knotproof joins --all"#;

/// The joins of one curve, or of one for each index: the fields are the JSON.
#[derive(Debug, Serialize, JsonSchema)]
pub(super) struct Joins {
    /// What this object is: `knotproof.joins/1`.
    #[schemars(extend("const" = "knotproof.joins/1"))]
    schema: &'static str,
    #[serde(flatten)]
    on: OnKnots,
    /// The number of coordinates of a point.
    dimension: usize,
    /// One for each α and each knot inside the interval, from left to right; at last that of the ends of a closed curve.
    joins: Vec<JoinRecord>,
}

/// The joins of all curves of a paper: the fields are the JSON.
#[derive(Debug, Serialize, JsonSchema)]
pub(super) struct AllJoins {
    /// What this object is: `knotproof.joins/1`.
    #[schemars(extend("const" = "knotproof.joins/1"))]
    schema: &'static str,
    /// One for each curve and each knot inside its interval, in the order of the paper.
    joins: Vec<JoinRecord>,
}

/// A knot where two pieces of a curve meet. What is not defined is `null`, and `undefined` says why.
#[derive(Debug, Serialize, JsonSchema)]
struct JoinRecord {
    #[serde(flatten)]
    instance: Option<OfInstance>,
    #[serde(flatten)]
    weights: OfWeights,
    /// The knot; of a closed curve's ends the last one.
    #[serde(serialize_with = "as_given")]
    #[schemars(with = "String")]
    knot: Exact,
    /// How often it occurs: the classical curve of degree k has continuous derivatives up to the order k less that.
    multiplicity: usize,
    /// Is it where the end of a closed curve meets its beginning?
    closing: bool,
    /// Are the points on both sides equal?
    g0: bool,
    /// Are the directions equal as well?
    g1: Option<bool>,
    /// Are the vectors of curvature equal as well?
    g2: Option<bool>,
    /// The squared cosine of the angle between the directions.
    cos2: Option<Exact>,
    /// Is the angle more than a right one?
    turns_back: Option<bool>,
    /// The angle between the directions in degrees, from 0 to 180.
    angle_degrees: Option<Decimal>,
    /// The square of the speed after the knot over that before it.
    speed_ratio_squared: Option<Exact>,
    /// The speed after the knot over that before it.
    speed_ratio: Option<Decimal>,
    /// The curvature after the knot less that before it.
    curvature_jump: Option<Decimal>,
    /// The limits from the left.
    before: BranchRecord,
    /// The limits from the right.
    after: BranchRecord,
    /// What is not defined here, and why.
    undefined: Vec<String>,
    #[serde(skip)]
    angle: Option<Angle>,
}

/// Where a curve of a paper comes from.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
struct OfInstance {
    /// The instance, such as `S1`.
    instance: String,
    /// Where the paper shows it.
    figure: String,
    /// k.
    degree: usize,
}

/// One side of a knot.
#[derive(Debug, Serialize, JsonSchema)]
struct BranchRecord {
    /// The point, as a list of coordinates.
    point: Vec<Exact>,
    /// The first derivative.
    derivative: Vec<Exact>,
    /// The order of the first derivative that is not 0.
    order: Option<usize>,
    /// A vector in the direction in which the curve is run through.
    direction: Option<Vec<Exact>>,
    /// The vector of curvature, of the length |κ|.
    curvature_vector: Option<Vec<Exact>>,
    /// κ|κ|, for the curvature κ: with its sign in the plane, positive to the left; elsewhere κ ≥ 0.
    curvature_squared: Option<Exact>,
    /// κ.
    curvature: Option<Decimal>,
}

/// Finds the joins and prints them.
pub(super) fn run(args: &Args, output: &Output) -> Result<Exit, CliError> {
    let notation = args.notation.notation()?;
    let output = output.in_notation(notation);
    let paper = match &args.paper {
        Some(name) => paper_of("--paper", name)?,
        None => Cow::Borrowed(paper()),
    };
    let examples = examples_of(&paper.examples, &paper.about.family);
    if args.all {
        output.result_of(&paper, &of_all(&examples, notation))?;
        return Ok(Exit::Holds);
    }
    let own_family = args.paper.is_some().then_some(&paper.about.family);
    let cases = args.instance.resolve_among(&examples, own_family)?.cases()?;
    let progress = Progress::new(cases.len());
    let (mut on, mut records) = (None, Vec::new());
    for Case { label, weights, basis, curve } in cases {
        let curve = curve.ok_or(CliError::NoPoints { needed: basis.n() + 1 })?;
        progress.step(&weights.to_string());
        records.extend(of_curve(None, &weights, &curve, notation));
        on = Some((OnKnots::of(&basis, label).with_points_of(&curve), curve.dimension()));
    }
    drop(progress);
    let Some((on, dimension)) = on else { unreachable!("an instance has a case") };
    output.result(&Joins { schema: "knotproof.joins/1", on, dimension, joins: records })?;
    Ok(Exit::Holds)
}

fn of_all(examples: &[Example], notation: Notation) -> AllJoins {
    let progress = Progress::new(examples.len());
    let mut records = Vec::new();
    for example in examples {
        progress.step(&example.name);
        let Example { name, figure, degree, .. } = example;
        let of = OfInstance { instance: name.to_string(), figure: figure.clone(), degree: *degree };
        for (weights, curve) in example.curves() {
            records.extend(of_curve(Some(&of), weights, &curve, notation));
        }
    }
    AllJoins { schema: "knotproof.joins/1", joins: records }
}

fn of_curve(
    of: Option<&OfInstance>,
    weights: &Weighting,
    curve: &Curve<AnyWeights>,
    notation: Notation,
) -> impl Iterator<Item = JoinRecord> {
    let all = joins(curve).into_iter();
    all.map(move |join| JoinRecord::new(of.cloned(), OfWeights::of(weights), &join, notation))
}

impl JoinRecord {
    fn new(instance: Option<OfInstance>, weights: OfWeights, join: &Join, notation: Notation) -> Self {
        let settled = |mut number: Surd| notation.settled(&mut number);
        let (angle, speed_ratio_squared) = (join.angle(), join.speed_ratio_square());
        Self {
            instance,
            weights,
            knot: Exact(join.knot.clone()),
            multiplicity: join.multiplicity,
            closing: join.closing,
            g0: join.g0(),
            g1: join.g1(),
            g2: join.g2(),
            cos2: angle.as_ref().map(|angle| Exact(angle.cosine_square().clone())),
            turns_back: angle.as_ref().map(Angle::is_obtuse),
            angle_degrees: angle.clone().map(|mut angle| notation.settled(&mut angle)),
            speed_ratio: speed_ratio_squared.as_ref().map(|square| settled(Surd::root(square))),
            speed_ratio_squared: speed_ratio_squared.map(Exact),
            curvature_jump: join.curvature_jump().map(settled),
            before: BranchRecord::new(&join.before, notation),
            after: BranchRecord::new(&join.after, notation),
            undefined: undefined(join),
            angle,
        }
    }
}

impl BranchRecord {
    fn new(branch: &Branch, notation: Notation) -> Self {
        let (tangent, square) = (branch.tangent.as_ref(), branch.curvature_square());
        Self {
            point: exact(&branch.point),
            derivative: exact(&branch.velocity),
            order: tangent.map(|tangent| tangent.order),
            direction: tangent.map(|tangent| exact(&tangent.direction)),
            curvature_vector: tangent.and_then(|tangent| tangent.curvature.as_deref()).map(exact),
            curvature: square.as_ref().map(|square| notation.settled(&mut Surd::root(square))),
            curvature_squared: square.map(Exact),
        }
    }
}

/// What is not defined, and why.
fn undefined(join: &Join) -> Vec<String> {
    let mut all = Vec::new();
    for (side, branch) in [("before", &join.before), ("after", &join.after)] {
        let why = match &branch.tangent {
            None => "the curve stands still on the span, so it has no tangent",
            Some(tangent) if tangent.curvature.is_none() => {
                "its first derivative is 0 and its curvature infinite"
            }
            Some(tangent) if tangent.order > 1 => "its first derivative is 0, so it has no speed to compare",
            Some(_) => continue,
        };
        all.push(format!("{side} the knot {why}"));
    }
    all
}
