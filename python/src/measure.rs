//! Where a curve takes a value, within which bounds it lies, and how long it is: all from its pieces.

use knotproof::analysis::{
    Algebraic, CurvePart, CurvePartError, Graph, Location, RangeEnd, RationalBezier, Sign, Solution,
    SolutionKind, integrals, length, settled,
};
use knotproof::cli::{CliError, if_too_high};
use knotproof::scalar::{BigRational, integer};
use knotproof::spline::{AnyWeights, Curve};

use crate::basis::DIGITS;
use crate::curve::Point;
use crate::error::Wrong;

/// A part of a curve, or all of it, and the longest interval for a number.
pub(crate) type Part = (Option<BigRational>, Option<BigRational>, BigRational);
/// A coordinate, or a of a·c(x).
pub(crate) type Function = (Option<usize>, Option<Point>);
/// A real number: exact bounds, and settled digits.
pub(crate) type Known = ((BigRational, BigRational), String);
/// An x; of an interval the first, then its end, and does that belong to it?
pub(crate) type Place = (Known, Option<BigRational>, Option<bool>);
/// How a value is met, where, the signs of a·c(x) − v before and after, and the point of the curve.
pub(crate) type Solved = (&'static str, Place, (Option<i8>, Option<i8>), Option<Vec<Known>>);
/// An infimum or a supremum, and where it is; is it taken there?
pub(crate) type Bounds = (Known, Vec<(Place, bool)>);

pub(crate) fn solutions(
    curve: &Curve<AnyWeights>,
    part: &Part,
    function: Function,
    value: &BigRational,
) -> Result<Vec<Solved>, Wrong> {
    let normal = normal(curve.dimension(), function)?;
    let pieces = pieces(curve, part)?;
    let coordinates: Vec<_> = units(curve.dimension()).map(|unit| Graph::of(&pieces, &unit)).collect();
    let width = &part.2;
    let solved = |solution: &Solution| {
        let kind = match solution.kind {
            SolutionKind::Taken => "taken",
            SolutionKind::LimitFromLeft => "limit-from-left",
            SolutionKind::Passed => "passed",
        };
        let point: Option<Vec<_>> = coordinates.iter().map(|graph| graph.at(solution)).collect();
        let point = point.map(|point| point.into_iter().map(|c| known(c, width)).collect());
        let signs = (solution.before.map(sign), solution.after.map(sign));
        (kind, place(&solution.place, width), signs, point)
    };
    Ok(Graph::of(&pieces, &normal).solutions(value).iter().map(solved).collect())
}

pub(crate) fn bounds(
    curve: &Curve<AnyWeights>,
    part: &Part,
    function: Option<Function>,
) -> Result<Vec<[Bounds; 2]>, Wrong> {
    let normals = match function {
        Some(function) => vec![normal(curve.dimension(), function)?],
        None => units(curve.dimension()).collect(),
    };
    let pieces = pieces(curve, part)?;
    let of = |end: RangeEnd| {
        let places = end.places.iter().map(|(at, taken)| (place(at, &part.2), *taken)).collect();
        (known(end.value, &part.2), places)
    };
    let ranges = normals.iter().map(|normal| Graph::of(&pieces, normal).range());
    Ok(ranges.map(|range| [of(range.lowest), of(range.highest)]).collect())
}

pub(crate) fn length_of(curve: &Curve<AnyWeights>, part: &Part) -> Result<Known, Wrong> {
    Ok(between(length(&pieces(curve, part)?, &part.2)))
}

pub(crate) fn integrals_of(curve: &Curve<AnyWeights>, part: &Part) -> Result<Vec<Known>, Wrong> {
    Ok(integrals(&pieces(curve, part)?, &part.2).into_iter().map(between).collect())
}

/// The vectors whose products with a point are its coordinates.
fn units(dimension: usize) -> impl Iterator<Item = Point> {
    (0..dimension).map(move |own| (0..dimension).map(|c| integer(i64::from(c == own))).collect())
}

/// a of a·c(x).
fn normal(dimension: usize, function: Function) -> Result<Point, Wrong> {
    match function {
        (Some(_), Some(_)) => {
            Err(Wrong::with("normal", "it takes the place of a coordinate; leave one of them away"))
        }
        (None, Some(normal)) if normal.len() == dimension => Ok(normal),
        (None, Some(normal)) => Err(CliError::Normal { count: normal.len(), dimension }.into()),
        (None, None) if dimension > 1 => Err(CliError::NoCoordinate { dimension }.into()),
        (coordinate, None) => {
            let coordinate = coordinate.unwrap_or(0);
            let unit = units(dimension).nth(coordinate);
            unit.ok_or_else(|| CliError::Coordinate { coordinate, dimension }.into())
        }
    }
}

fn pieces(curve: &Curve<AnyWeights>, (from, to, _): &Part) -> Result<Vec<RationalBezier>, Wrong> {
    if_too_high(curve.basis())?;
    let part = CurvePart::of(curve, from.as_ref(), to.as_ref()).map_err(|error| {
        let argument = match error {
            CurvePartError::From { .. } => "start",
            CurvePartError::To { .. } => "end",
        };
        Wrong::with(argument, error)
    })?;
    let pieces = RationalBezier::pieces_on(curve, &part).collect::<Result<_, _>>();
    Ok(pieces.map_err(CliError::from)?)
}

fn known(mut number: Algebraic, width: &BigRational) -> Known {
    let bounds = number.bounds_within(width);
    (bounds, settled(&mut number, DIGITS))
}

/// Of which no more is known than two bounds.
fn between((lo, hi): (BigRational, BigRational)) -> Known {
    let digits = settled(&mut Algebraic::between(lo.clone(), hi.clone()), DIGITS);
    ((lo, hi), digits)
}

fn place(place: &Location, width: &BigRational) -> Place {
    let (until, closed) = match place {
        Location::Plateau { to, closed, .. } => (Some(to.clone()), Some(*closed)),
        Location::Point(_) | Location::Irrational { .. } => (None, None),
    };
    (known(place.x(), width), until, closed)
}

fn sign(sign: Sign) -> i8 {
    match sign {
        Sign::Negative => -1,
        Sign::Zero => 0,
        Sign::Positive => 1,
    }
}
