//! The shapes of the coordinates of a curve.

use schemars::JsonSchema;
use serde::Serialize;

use crate::analysis::{CurvePart, ExtremumKind, Graph, RationalBezier};

use super::super::error::CliError;
use super::super::exit::Exit;
use super::super::notation::Notation;
use super::super::of_weights::OfWeights;
use super::super::on_curve::{curve_of, if_too_high};
use super::super::on_knots::OnKnots;
use super::super::output::Output;
use super::super::progress::Progress;
use super::super::solve::unit;
use super::{Args, Step, Turn};

/// The local maxima and minima of the coordinates of a curve: the fields are the JSON.
#[derive(Debug, Serialize, JsonSchema)]
pub(in crate::cli) struct CurveShapes {
    /// What this object is: `knotproof.shape/1`.
    #[schemars(extend("const" = "knotproof.shape/1"))]
    schema: &'static str,
    #[serde(flatten)]
    pub(super) on: OnKnots,
    /// One for each α and each coordinate.
    pub(super) curves: Vec<CoordinateRecord>,
}

/// One coordinate of a curve.
#[derive(Debug, Serialize, JsonSchema)]
pub(super) struct CoordinateRecord {
    /// Which one, from 0.
    pub(super) coordinate: usize,
    #[serde(flatten)]
    pub(super) weights: OfWeights,
    /// How many local maxima there are; a plateau is one.
    pub(super) local_maxima: usize,
    /// How many local minima there are.
    pub(super) local_minima: usize,
    /// The local maxima and minima, from left to right; at the ends of the curve only one side counts.
    pub(super) extrema: Vec<Turn>,
    /// The knots at which the coordinate jumps.
    pub(super) jumps: Vec<Step>,
}

/// Finds the shapes and prints them.
pub(super) fn run(args: &Args, notation: Notation, output: &Output) -> Result<Exit, CliError> {
    let cases = args.function.instance.resolve_any()?.cases()?;
    let progress = Progress::new(cases.len());
    let (mut on, mut curves) = (None, Vec::new());
    for case in cases {
        progress.step(&case.weights.to_string());
        let curve = curve_of(&case)?;
        if_too_high(&case.basis)?;
        let pieces = RationalBezier::pieces_on(curve, &CurvePart::of(curve, None, None)?)
            .collect::<Result<Vec<_>, _>>()?;
        for coordinate in 0..curve.dimension() {
            let graph = Graph::of(&pieces, &unit(coordinate, curve.dimension()));
            let (mut extrema, jumps) = (graph.extrema(), graph.jumps());
            extrema.iter_mut().for_each(|extremum| extremum.refine_to(&args.width));
            let count = |kind| extrema.iter().filter(|extremum| extremum.kind == kind).count();
            curves.push(CoordinateRecord {
                coordinate,
                weights: OfWeights::of(&case.weights),
                local_maxima: count(ExtremumKind::Maximum),
                local_minima: count(ExtremumKind::Minimum),
                extrema: Turn::all(&extrema, &jumps, notation),
                jumps: jumps.iter().map(Step::from).collect(),
            });
        }
        if on.is_none() {
            on = Some(OnKnots::of(&case.basis, case.label.clone()).with_points_of(curve));
        }
    }
    drop(progress);
    let Some(on) = on else { unreachable!("an instance has a case") };
    output.result(&CurveShapes { schema: "knotproof.shape/1", on, curves })?;
    Ok(Exit::Holds)
}
