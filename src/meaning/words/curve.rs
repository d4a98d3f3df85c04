//! Plane curves as sets of points.

use num_traits::Signed;

use crate::analysis::{Piece, always_positive, coefficient_rows, rank};
use crate::language::{Argument, Function, Int, Item, Member, Name, Real};
use crate::scalar::{BigRational, RationalAlgebra, Ring, integer, rational};
use crate::spline::Index;

use super::super::cell::Cell;
use super::super::reading::Reading;
use super::super::truth::{Stop, Truth};

type Plane = [Piece; 2];

/// Both coordinates on the span of an index, for the index of the moment.
fn on_span(own: &mut Reading<'_>, curve: [&Function; 2], j: usize) -> Result<Plane, Stop> {
    let name = Name::from("");
    let argument = Argument { at: Real::Bound(name.clone()), side: None, member: None };
    let knots = own.knots()?;
    let cell = Cell::Open(Some(knots.t(j).clone()), Some(knots.t(j + 1).clone()));
    let [x, y] = curve.map(|f| own.within(&name, &cell, |own| own.apply(f, &argument)));
    Ok([x?.piece()?, y?.piece()?])
}

fn everywhere(own: &mut Reading<'_>, curve: [&Function; 2]) -> Result<Vec<Plane>, Stop> {
    let spans: Vec<_> = own.knots()?.spans().map(|span| span.index()).collect();
    spans.into_iter().map(|j| on_span(own, curve, j)).collect()
}

fn plane_curve<'a>(of: &'a [Item]) -> Result<([&'a Function; 2], &'a Item), Stop> {
    match of {
        [Item::Function(x, None), Item::Function(y, None), last] => Ok(([x, y], last)),
        _ => Err(Stop::Unknown("a plane curve has two coordinates, for the index of the moment".into())),
    }
}

/// Is some point of the curve farther than a distance from all points of the curve for α = ∞?
///
/// No, if on every span G_α(u) = G_∞(r·u): then both have the same points. Yes, if so for one of the points that are tried,
/// in the middle of each span and near its ends. Otherwise it stays open.
pub(in super::super) fn strays(own: &mut Reading<'_>, of: &[Item]) -> Result<Truth, Stop> {
    let (coordinates, distance) = plane_curve(of)?;
    let Item::Real(distance) = distance else { return Err(Stop::Unknown("a distance is a number".into())) };
    let distance = own.real(distance)?;
    let Some(distance) = distance.number().filter(|distance| !distance.is_negative()) else {
        return Err(Stop::Unknown("a distance is a rational number ≥ 0".into()));
    };
    let curve = everywhere(own, coordinates)?;
    let classical = own.with_index(Index::infinity(), |own| everywhere(own, coordinates))?;
    let r = own.index.ratio();
    let same = |(one, other): (&Plane, &Plane)| (0..2).all(|c| one[c] == other[c].scaled_argument(r));
    if curve.iter().zip(&classical).all(same) {
        return Ok(Truth::False);
    }
    let square = distance * distance;
    let tried = [integer(1), rational(1, 7), integer(7)];
    let points = curve.iter().flat_map(|[x, y]| tried.iter().filter_map(|u| Some([x.evaluate(u)?, y.evaluate(u)?])));
    let mut points = points;
    let far = points.any(|point| classical.iter().all(|on| is_beyond(on, &point, &square)));
    Ok(if far { Truth::True } else { Truth::Unknown("no point that was tried is far enough".into()) })
}

/// Are all points of a closed piece of a curve farther from a point than the root of a number?
fn is_beyond(on: &Plane, point: &[BigRational; 2], square: &BigRational) -> bool {
    let [x, y] = [0, 1].map(|c| on[c].minus(&on[c].embed(&point[c])));
    let excess = x.times(&x).plus(&y.times(&y)).minus(&x.embed(square));
    let ends = [excess.evaluate(&integer(0)), excess.at_infinity()];
    ends.iter().flatten().all(Signed::is_positive) && always_positive(&excess).holds()
}

/// The least e with a polynomial of degree e that is 0 on the curve: its monomials are dependent.
pub(in super::super) fn implicit_degree(own: &mut Reading<'_>, of: &[Item]) -> Result<i64, Stop> {
    let (coordinates, span) = plane_curve(of)?;
    let Item::Int(span) = span else { return Err(Stop::Unknown("a span has an index".into())) };
    let j = own.int(span)?;
    let missing = || Stop::Undefined(format!("span {j} does not exist"));
    let span = usize::try_from(j).ok().and_then(|j| own.knots().ok()?.span(j)).ok_or_else(missing)?;
    let [x, y] = on_span(own, coordinates, span.index())?;
    let dependent = |e: usize| {
        let monomial = |(a, b): (usize, usize)| x.power(a).times(&y.power(b));
        let monomials: Vec<_> = (0..=e).flat_map(|sum| (0..=sum).map(move |b| (sum - b, b))).map(monomial).collect();
        let count = monomials.len();
        rank(&coefficient_rows([monomials])) < count
    };
    // Coordinates of degree N over one denominator satisfy an equation of degree N.
    let degree = (1..).find(|e| dependent(*e)).unwrap_or_default();
    Ok(i64::try_from(degree).unwrap_or(i64::MAX))
}
