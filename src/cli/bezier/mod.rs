//! The command `bezier`: a curve as rational Bézier curves, for programs that know NURBS.

mod text;

use schemars::JsonSchema;
use serde::Serialize;

use crate::analysis::RationalBezier;
use crate::spline::{AnyWeights, Curve, Point};

use super::error::CliError;
use super::exact::Exact;
use super::exit::Exit;
use super::instance::{Case, InstanceArgs};
use super::notation::NotationArgs;
use super::of_weights::OfWeights;
use super::on_knots::{OnKnots, exact};
use super::output::Output;
use super::progress::Progress;

/// Converts a curve exactly: on every knot span a rational Bézier curve of the least degree with positive weights.
///
/// The first weight of each piece is 1. Before anything is printed, each piece is compared with the curve at so many
/// points that they are equal for every x of the span. Up to degree 10, where a piece has degree up to 55. Weights of
/// another family may have a degree N in x: a piece has degree up to Nk(k + 1)/2, at most 120, or a higher one where the
/// weights of the Bézier curve would not be positive, at most 300. A basis function is the curve of the points 0 … 0 1 0 … 0.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLE)]
pub(super) struct Args {
    #[command(flatten)]
    instance: InstanceArgs,
    #[command(flatten)]
    notation: NotationArgs,
}

const EXAMPLE: &str = r#"Examples:
  knotproof bezier --degree 2 --knots "0 0 0 1 2 2 2" --alpha 5 --points "0,0 1,2 2,2 3,0"
  knotproof bezier --instance C5 --alpha -4 --format json
  knotproof bezier --degree 2 --knots "0 0 0 1 2 2 2" --family lupas --set q=1/2 --points "0 1 0 0""#;

/// The highest degree k that is converted. A piece has degree k(k + 1)/2 in general, and the time grows with about
/// the sixth power of k: on knots of a few digits this one takes two seconds a span.
const DEGREE_LIMIT: usize = 10;

/// The highest degree of the functions as quotients, for weights of a higher degree in x than those of an index.
const QUOTIENT_LIMIT: usize = 120;

/// The result: its fields are the JSON.
#[derive(Debug, Serialize, JsonSchema)]
pub(super) struct Conversion {
    /// What this object is: `knotproof.bezier/1`.
    #[schemars(extend("const" = "knotproof.bezier/1"))]
    schema: &'static str,
    #[serde(flatten)]
    on: OnKnots,
    #[serde(flatten)]
    weights: OfWeights,
    /// The number of coordinates of a point.
    dimension: usize,
    /// From left to right, one for each span that is not empty.
    pieces: Vec<Piece>,
}

/// The piece on [t_j, t_{j+1}].
#[derive(Debug, Serialize, JsonSchema)]
struct Piece {
    /// j of the span [t_j, t_{j+1}).
    span: usize,
    /// t_j, where the parameter of the piece is 0.
    from: Exact,
    /// t_{j+1}, where it is 1.
    to: Exact,
    /// Does the span lie in [t_k, t_{n+1}], where the basis functions add up to 1?
    base: bool,
    /// The degree d of the piece.
    degree: usize,
    /// w_0, …, w_d of the rational Bézier form.
    weights: Vec<Exact>,
    /// Its control points p_0, …, p_d, each a list of coordinates.
    points: Vec<Vec<Exact>>,
}

/// Converts, checks and prints.
pub(super) fn run(args: &Args, output: &Output) -> Result<Exit, CliError> {
    let output = output.in_notation(args.notation.notation()?);
    let Case { label, weights, basis, curve } = args.instance.resolve_any()?.only_case()?;
    let curve = curve.ok_or(CliError::NoPoints { needed: basis.n() + 1 })?;
    output.result(&convert(&curve, OfWeights::of(&weights), label)?)?;
    Ok(Exit::Holds)
}

fn convert(
    curve: &Curve<AnyWeights>,
    weights: OfWeights,
    label: Option<String>,
) -> Result<Conversion, CliError> {
    let (basis, knots) = (curve.basis(), curve.basis().knots());
    if basis.degree() > DEGREE_LIMIT {
        let reason = "a piece has degree k(k + 1)/2, and the time grows with the sixth power of k";
        return Err(CliError::TooHigh { degree: basis.degree(), limit: DEGREE_LIMIT, reason });
    }
    CliError::if_quotients_exceed(QUOTIENT_LIMIT, basis)?;
    let progress = Progress::new(knots.spans().count());
    let checked = |piece: Result<RationalBezier, _>| {
        let piece = piece?;
        progress.step(&format!("[{}, {}]", piece.ends().0, piece.ends().1));
        match piece.disagreement(curve) {
            None => Ok(Piece::new(&piece, curve)),
            Some(x) => Err(CliError::Conversion { x }),
        }
    };
    let pieces = RationalBezier::pieces(curve).map(checked).collect::<Result<_, _>>()?;
    Ok(Conversion {
        schema: "knotproof.bezier/1",
        on: OnKnots::of(basis, label),
        weights,
        dimension: curve.dimension(),
        pieces,
    })
}

impl Piece {
    fn new(piece: &RationalBezier, curve: &Curve<AnyWeights>) -> Self {
        let (from, to) = piece.ends();
        let basis = curve.basis();
        Self {
            span: piece.span().index(),
            from: Exact(from.clone()),
            to: Exact(to.clone()),
            base: (basis.degree()..=basis.n()).contains(&piece.span().index()),
            degree: piece.degree(),
            weights: exact(piece.weights()),
            points: piece.points().iter().map(|point: &Point| exact(point)).collect(),
        }
    }
}
