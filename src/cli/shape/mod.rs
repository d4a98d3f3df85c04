//! The command `shape`: local maxima and minima, plateaus, jumps and slopes of basis functions.

mod coordinates;
mod partition;
mod text;

use std::ops::RangeInclusive;

use num_rational::BigRational;
use num_traits::Signed;
use schemars::JsonSchema;
use serde::Serialize;

use crate::analysis::{
    Extremum, ExtremumKind, Jump, KnotSlopes, Location, Pieces, Shape as FunctionShape, knot_slopes,
    turns_back,
};
use crate::meaning::{Instance, Weighting};
use crate::scalar::parse_rational;
use crate::spline::{Basis, HasWeights};
use crate::typed::{TypedError, whole_number};

use super::error::CliError;
use super::exact::{Exact, as_given};
use super::exit::Exit;
use super::instance::{FunctionArgs, MemberSubject, Resolved};
use super::notation::{Decimal, Notation, NotationArgs};
use super::of_weights::OfWeights;
use super::on_knots::OnKnots;
use super::output::Output;
use super::progress::Progress;

pub(super) use coordinates::CurveShapes;
pub(super) use partition::Partitions;

/// Local maxima, minima, plateaus, jumps and slopes of basis functions, exactly.
///
/// A local maximum is a point, or a maximal interval of constancy, where the function is larger than everywhere
/// close by on both sides; outside of its support it is 0. `strong`: there is exactly one. `weak`: the supremum
/// is attained at exactly one point.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLE)]
pub(super) struct Args {
    #[command(flatten)]
    function: FunctionArgs,
    /// The longest interval for a place or a value that is not known exactly.
    #[arg(long, value_name = "W", value_parser = parse_rational, allow_hyphen_values = true, default_value = "0x1p-20")]
    width: BigRational,
    /// The knot t_J moves between its two neighbours: all its places, by the number of local maxima.
    #[arg(long, value_name = "J", value_parser = whole_number, allow_hyphen_values = true)]
    free_knot: Option<usize>,
    /// The coordinates of the curve in place of the basis functions; --points asks for them, too.
    #[arg(long, conflicts_with_all = ["index", "free_knot"])]
    curve: bool,
    #[command(flatten)]
    notation: NotationArgs,
}

const EXAMPLE: &str = r#"With --alpha all: every slope ratio r = α/(α − 1) in (0, ∞), by the number of local maxima; with --free-knot J, every
place of the knot t_J between its neighbours. Cells are open intervals, each with its number; between two of them
lies an end, the root of a polynomial.

With --curve or --points: the local maxima, minima and jumps of each coordinate of the curve; at its ends only one side counts.

Exit codes: 0 every function has exactly one local maximum, for every value of the parameter, or it is about a curve; 1 one has none or
several; 3 nothing but that is known, and some value of the parameter is undecided.

Examples:
  knotproof shape --instance U4 --alpha -1
  knotproof shape --degree 3 --knots "0 0 0 0 1 2 4 4" --alpha 5/2 --index 2 \
    --width 1e-12  # exit code 1
  knotproof shape --degree 4 --knots "0 1 2 3 4 5 5 5 5" --index 0 --alpha all  # exit code 1
  knotproof shape --degree 2 --knots "0 0 0 1 2 2 2" --family lupas --set q=1/2
  knotproof shape --degree 3 --knots "0 0 0 0 1 2 4 4" --alpha 5/2 --index 2 \
    --free-knot 5  # exit code 1
  knotproof shape --instance C5 --alpha -4 --curve"#;

/// The result: its fields are the JSON.
#[derive(Debug, Serialize, JsonSchema)]
pub(super) struct Shapes {
    /// What this object is: `knotproof.shape/1`.
    #[schemars(extend("const" = "knotproof.shape/1"))]
    schema: &'static str,
    #[serde(flatten)]
    on: OnKnots,
    /// One for each index i and α that was asked for.
    functions: Vec<FunctionRecord>,
}

/// One function with one index.
#[derive(Debug, Serialize, JsonSchema)]
struct FunctionRecord {
    /// i of G_i^k.
    index: usize,
    #[serde(flatten)]
    weights: OfWeights,
    /// The closed interval outside of which the function is 0.
    support: [Exact; 2],
    /// How many local maxima there are; a plateau is one.
    local_maxima: usize,
    /// How many local minima there are inside the support.
    local_minima: usize,
    /// Is there one local maximum only (Conjecture 3.1 in the strong reading)?
    strong: bool,
    /// Is the largest value taken at one place only (the weak reading)? `null` if that is not decided.
    weak: Option<bool>,
    /// The local maxima and minima, from left to right.
    extrema: Vec<Turn>,
    /// The knots at which the function jumps.
    jumps: Vec<Step>,
    /// The one-sided slopes at the knots.
    slopes: Vec<Slopes>,
}

/// A local maximum or minimum.
#[derive(Debug, Serialize, JsonSchema)]
struct Turn {
    /// A local maximum, or a minimum.
    #[schemars(extend("enum" = ["maximum", "minimum"]))]
    kind: &'static str,
    /// Exact bounds of the place, equal if it is known exactly; or the two ends of a plateau.
    #[serde(serialize_with = "as_given")]
    #[schemars(with = "[String; 2]")]
    interval: [Exact; 2],
    /// Settled digits of the place.
    x: Decimal,
    /// Is the place a knot?
    at_knot: bool,
    /// Is the whole interval a maximal interval of constancy?
    plateau: bool,
    /// Exact bounds of the value there, equal if it is known exactly.
    #[serde(serialize_with = "as_given")]
    #[schemars(with = "[String; 2]")]
    value: [Exact; 2],
    /// Settled digits of the value there.
    height: Decimal,
}

/// A discontinuity.
#[derive(Debug, Serialize, JsonSchema)]
struct Step {
    /// The knot.
    at: Exact,
    /// The limit from below.
    left: Exact,
    /// The limit from above.
    right: Exact,
}

/// One-sided slopes at a knot; `null` where nothing lies on that side.
#[derive(Debug, Serialize, JsonSchema)]
struct Slopes {
    /// The knot.
    at: Exact,
    /// The derivative from below; `null` where there is no span to the left.
    left: Option<Exact>,
    /// The derivative from above; `null` where there is no span to the right.
    right: Option<Exact>,
}

/// Finds the shapes and prints them.
pub(super) fn run(args: &Args, output: &Output) -> Result<Exit, CliError> {
    if !args.width.is_positive() {
        return Err(CliError::Width(args.width.clone()));
    }
    let notation = args.notation.notation()?;
    let output = &output.in_notation(notation);
    if args.curve || args.function.instance.has_points() {
        return coordinates::run(args, notation, output);
    }
    if let Some(every_index) = args.function.instance.every_index() {
        return match args.free_knot {
            None => partition::by_ratio(args, every_index.resolve()?, notation, output),
            Some(_) => Err(CliError::TwoParameters),
        };
    }
    let subject = match args.function.instance.resolve_any()? {
        Resolved::Indices(subjects) => subjects,
        Resolved::Member(subject) if args.free_knot.is_some() => {
            let family = subject.family();
            return Err(CliError::OnlyIndices { option: "--free-knot", family });
        }
        Resolved::Member(subject) => return of_member(args, subject, notation, output),
    };
    if let Some(knot) = args.free_knot {
        return partition::by_knot(args, subject, knot, notation, output);
    }
    let bases: Vec<Basis> = subject.cases.into_iter().map(|case| case.basis).collect();
    let mut functions = Vec::new();
    let mut steps = 0;
    for basis in &bases {
        steps += args.function.range(basis)?.count();
    }
    let progress = Progress::new(steps);
    for basis in &bases {
        functions.extend(shapes(basis, args.function.range(basis)?, &args.width, notation, &progress));
    }
    drop(progress);
    let Some(first) = bases.first() else { unreachable!("an instance has an index") };
    told(OnKnots::of(first, subject.label), functions, output)
}

fn told(on: OnKnots, functions: Vec<FunctionRecord>, output: &Output) -> Result<Exit, CliError> {
    let all_strong = functions.iter().all(|function| function.strong);
    output.result(&Shapes { schema: "knotproof.shape/1", on, functions })?;
    Ok(if all_strong { Exit::Holds } else { Exit::Refuted })
}

/// The shapes for a member of another family than that of an index.
fn of_member(
    args: &Args,
    subject: MemberSubject,
    notation: Notation,
    output: &Output,
) -> Result<Exit, CliError> {
    let weights = subject.basis.weights().clone();
    let (chosen, k) = (args.function.range(&subject.basis)?, subject.basis.degree());
    let wrong = |error| TypedError::Member { argument: "--family", error };
    let on = Instance::on(subject.basis).map_err(wrong)?;
    let (Some(basis), Some(pieces)) = (on.any_basis_of(&weights, k), on.pieces(&weights, k)) else {
        unreachable!("an instance has its own weights")
    };
    let progress = Progress::new(chosen.clone().count());
    let mut functions = Vec::new();
    for i in chosen {
        progress.step(&format!("G_{i}"));
        if on.is_nonnegative(&weights, (i, k)) != Some(true) {
            let why = on
                .obligation(&weights)
                .map(|((j, i, d), why)| format!("w[{i},{d}] on [t_{j}, t_{}]: {why}", j + 1));
            let family = weights.to_string();
            return Err(CliError::Negative { index: i, family, why: why.unwrap_or_default() });
        }
        let mut shape = FunctionShape::of(&pieces, i);
        shape.refine_to(&args.width);
        functions.push(FunctionRecord::new((&basis, &weights), i, &shape, notation));
    }
    drop(progress);
    told(OnKnots::of(&basis, subject.label), functions, output)
}

/// The shapes of the functions asked for.
fn shapes(
    basis: &Basis,
    chosen: RangeInclusive<usize>,
    width: &BigRational,
    notation: Notation,
    progress: &Progress,
) -> Vec<FunctionRecord> {
    // One function alone, or what all of them share only once.
    let pieces = (chosen.start() != chosen.end()).then(|| Pieces::of(basis));
    chosen
        .map(|i| {
            progress.step(&format!("G_{i}, α = {}", basis.index()));
            let mut shape = match &pieces {
                Some(pieces) => FunctionShape::of(pieces, i),
                None => FunctionShape::of_function(basis, i),
            };
            shape.refine_to(width);
            let weights = Weighting::Index(basis.index().clone());
            FunctionRecord::new((basis, &weights), i, &shape, notation)
        })
        .collect()
}

impl FunctionRecord {
    fn new<W: HasWeights>(
        (basis, weights): (&Basis<W>, &Weighting),
        index: usize,
        shape: &FunctionShape,
        notation: Notation,
    ) -> Self {
        let (from, to) = basis.support(index);
        Self {
            index,
            weights: OfWeights::of(weights),
            support: [from, to].map(|end| Exact(end.clone())),
            local_maxima: shape.local_maxima().count(),
            local_minima: shape.local_minima().count(),
            strong: shape.strong(),
            weak: shape.weak(),
            extrema: Turn::all(shape.extrema(), shape.jumps(), notation),
            jumps: shape.jumps().iter().map(Step::from).collect(),
            slopes: knot_slopes(basis, index).into_iter().map(Slopes::from).collect(),
        }
    }
}

impl Turn {
    /// The extrema, with decimals that tell neighbours apart.
    fn all(extrema: &[Extremum], jumps: &[Jump], notation: Notation) -> Vec<Self> {
        let mut places: Vec<_> = extrema.iter().map(Extremum::x).collect();
        let mut values: Vec<_> = extrema.iter().map(Extremum::height).collect();
        let places = notation.settled_apart(&mut places, |_| true);
        let values = notation.settled_apart(&mut values, |at| turns_back(extrema, jumps, at));
        let decimals = places.into_iter().zip(values);
        extrema.iter().zip(decimals).map(|(extremum, decimals)| Self::new(extremum, decimals)).collect()
    }

    fn new(extremum: &Extremum, (x, height): (Decimal, Decimal)) -> Self {
        let (lo, hi) = extremum.place.interval();
        let (least, most) = &extremum.value;
        Self {
            kind: match extremum.kind {
                ExtremumKind::Maximum => "maximum",
                ExtremumKind::Minimum => "minimum",
            },
            interval: [lo, hi].map(|x| Exact(x.clone())),
            at_knot: extremum.at_knot,
            plateau: matches!(extremum.place, Location::Plateau { .. }),
            value: [least, most].map(|value| Exact(value.clone())),
            x,
            height,
        }
    }
}

impl From<&Jump> for Step {
    fn from(jump: &Jump) -> Self {
        let [at, left, right] = [&jump.at, &jump.left, &jump.right].map(|x| Exact(x.clone()));
        Self { at, left, right }
    }
}

impl From<KnotSlopes> for Slopes {
    fn from(slopes: KnotSlopes) -> Self {
        Self { at: Exact(slopes.at), left: slopes.left.map(Exact), right: slopes.right.map(Exact) }
    }
}
