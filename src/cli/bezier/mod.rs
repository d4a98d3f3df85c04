//! The command `bezier`: a curve as rational Bézier curves or as NURBS, for other programs.

mod nurbs;
mod text;

use clap::ValueEnum;
use num_rational::BigRational;
use schemars::JsonSchema;
use serde::Serialize;

use crate::analysis::{NurbsRequest, RationalBezier};
use crate::report::NurbsFile;
use crate::scalar::parse_rational;
use crate::spline::{AnyWeights, Curve, Point};
use crate::typed::whole_number;

use super::error::CliError;
use super::exact::Exact;
use super::exit::Exit;
use super::instance::InstanceArgs;
use super::notation::NotationArgs;
use super::of_weights::OfWeights;
use super::on_curve::if_too_high;
use super::on_knots::{OnKnots, exact};
use super::output::Output;
use super::progress::Progress;

pub(super) use nurbs::Joined;

/// Converts a curve exactly: on every knot span a rational Bézier curve of the least degree with positive weights.
///
/// The first weight of each piece is 1. Before anything is printed, each piece is compared with the curve at so many
/// points that they are equal for every x of the span. Up to degree 10, where a piece has degree up to 55. Weights of
/// another family may have a degree N in x: a piece has degree up to Nk(k + 1)/2, at most 120, or a higher one where the
/// weights of the Bézier curve would not be positive, at most 300. A basis function is the curve of the points 0 … 0 1 0 … 0.
///
/// With --as they are joined to one NURBS curve: one knot vector and one degree, the highest of the pieces and at least k. Where the
/// curve jumps, which it may do at knots of more than k copies, another one begins. For α = ∞ the knots and the control points are
/// those of the curve; for other α its derivative jumps at knots, which get as many copies as the degree says. The result is
/// turned back into pieces, and these are compared with the curve, before anything is printed. As `nurbs` the numbers are exact; a
/// file for another program has floats, each the nearest one.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLE)]
pub(super) struct Args {
    #[command(flatten)]
    instance: InstanceArgs,
    /// The hodograph: the pieces of the derivative of the curve, of the least degree with positive weights. The derivative may jump
    /// from one piece to the next.
    #[arg(long, conflicts_with = "form")]
    derivative: bool,
    /// Joins the pieces to NURBS curves, and prints them, or a file of them.
    #[arg(long = "as", value_name = "FORM", value_enum)]
    form: Option<Form>,
    /// The degree of the NURBS curve, if not the least one; at most 300. Programs on Open CASCADE read degrees up to 25, which all
    /// curves of degree k ≤ 6 have.
    #[arg(long, value_name = "D", value_parser = whole_number, allow_hyphen_values = true, requires = "form")]
    degree_to: Option<usize>,
    /// Weight 1 at both ends of each piece: the same points in another parameter, which is printed. Without it weights grow, or
    /// fall, from piece to piece.
    #[arg(long, requires = "form")]
    standard_form: bool,
    /// Where the NURBS curve begins, in place of the first knot.
    #[arg(long, value_name = "X", value_parser = parse_rational, allow_hyphen_values = true, requires = "form")]
    from: Option<BigRational>,
    /// Where it ends, in place of the last knot.
    #[arg(long, value_name = "X", value_parser = parse_rational, allow_hyphen_values = true, requires = "form")]
    to: Option<BigRational>,
    #[command(flatten)]
    notation: NotationArgs,
}

/// A value of `--as`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum, Serialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
enum Form {
    /// For people, and with --format json for scripts: exact numbers.
    Nurbs,
    /// JSON for NURBS-Python (geomdl.exchange.import_json); of one coordinate the second one is 0.
    Geomdl,
    /// STEP (ISO 10303-21, AP214): curves in space, in millimetres; coordinates that are missing are 0.
    Step,
}

impl Form {
    fn file(self) -> Option<NurbsFile> {
        match self {
            Self::Nurbs => None,
            Self::Geomdl => Some(NurbsFile::Geomdl),
            Self::Step => Some(NurbsFile::Step),
        }
    }
}

const EXAMPLE: &str = r#"Examples:
  knotproof bezier --degree 2 --knots "0 0 0 1 2 2 2" --alpha 5 --points "0,0 1,2 2,2 3,0"
  knotproof bezier --instance C5 --alpha -4 --format json
  knotproof bezier --degree 2 --knots "0 0 0 1 2 2 2" --family lupas --set q=1/2 \
    --points "0 1 0 0"
  knotproof bezier --instance C5 --alpha -4 --derivative
  knotproof bezier --instance C5 --alpha -4 --as nurbs --standard-form
  knotproof bezier --instance C5 --alpha -4 --as nurbs --format json > curve.json
  knotproof bezier --instance C5 --alpha -4 --as step --standard-form > curve.step
What --as nurbs --format json writes has the degree, the knots, α and the control points of the source, and is an instance file
too: knotproof eval --instance curve.json --x 1/2."#;

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
    /// 0 for the curve, 1 for its derivative.
    order: usize,
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
    let case = args.instance.resolve_any()?.only_case()?;
    let curve = case.curve.as_ref().ok_or(CliError::NoPoints { needed: case.basis.n() + 1 })?;
    let head = (OnKnots::of(&case.basis, case.label), OfWeights::of(&case.weights));
    let Some(form) = args.form else {
        output.result(&convert(curve, head, args.derivative)?)?;
        return Ok(Exit::Holds);
    };
    let request = NurbsRequest {
        degree: args.degree_to,
        from: args.from.clone(),
        to: args.to.clone(),
        standard_form: args.standard_form,
    };
    let joined = nurbs::join(curve, head, form, request)?;
    joined.warn(&output);
    output.result(&joined)?;
    Ok(Exit::Holds)
}

fn convert(
    curve: &Curve<AnyWeights>,
    (on, weights): (OnKnots, OfWeights),
    derivative: bool,
) -> Result<Conversion, CliError> {
    let progress = progress(curve);
    let pieces = pieces(curve, &progress)?;
    pieces.iter().try_for_each(|piece| verify(piece, curve, &progress))?;
    let pieces = if derivative {
        pieces.iter().map(RationalBezier::derivative).collect::<Result<Vec<_>, _>>()?
    } else {
        pieces
    };
    Ok(Conversion {
        schema: "knotproof.bezier/1",
        on: on.with_points_of(curve),
        weights,
        dimension: curve.dimension(),
        order: usize::from(derivative),
        pieces: pieces.iter().map(|piece| Piece::new(piece, curve)).collect(),
    })
}

/// Two steps for each span: it is converted, and the result is compared.
fn progress(curve: &Curve<AnyWeights>) -> Progress {
    Progress::new(2 * curve.basis().knots().spans().count())
}

/// The pieces, not yet compared with the curve.
fn pieces(curve: &Curve<AnyWeights>, progress: &Progress) -> Result<Vec<RationalBezier>, CliError> {
    if_too_high(curve.basis())?;
    let converted = |piece: Result<RationalBezier, _>| {
        let piece = piece?;
        progress.step(&format!("[{}, {}]", piece.ends().0, piece.ends().1));
        Ok(piece)
    };
    RationalBezier::pieces(curve).map(converted).collect()
}

/// Compares a piece with the curve, for every x.
fn verify(piece: &RationalBezier, curve: &Curve<AnyWeights>, progress: &Progress) -> Result<(), CliError> {
    progress.step(&format!("comparing [{}, {}]", piece.ends().0, piece.ends().1));
    piece.disagreement(curve).map_or(Ok(()), |x| Err(CliError::Conversion { x }))
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
