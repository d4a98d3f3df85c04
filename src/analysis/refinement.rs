//! Knot insertion: the same curve on more knots, where there is one.

use num_rational::BigRational;
use thiserror::Error;

use crate::scalar::RationalFunction;
use crate::spline::{Basis, Curve, Index, Point};

use super::curve_part::{CurvePart, CurvePartError};
use super::linear::{coefficient_rows, combinations, rank};
use super::pieces::Pieces;
use super::rational_bezier::{RationalBezier, RationalBezierError};

/// Why a curve is none on more knots.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum RefinementError {
    /// A knot outside of [t_0, t_m].
    #[error("the new knot {knot} is not in [{first}, {last}], where the curve is")]
    Outside {
        /// The knot.
        knot: BigRational,
        /// t_0.
        first: BigRational,
        /// t_m.
        last: BigRational,
    },
    /// The space of the functions on the new knots does not contain the curve.
    #[error(
        "the functions on these knots have the rank {rank}, and with coordinate {coordinate} of the curve it is {}: the curve is not \
         in their space",
        .rank + 1
    )]
    NotInSpace {
        /// The first coordinate that is no combination, from 0.
        coordinate: usize,
        /// The dimension of the space.
        rank: usize,
    },
    /// A piece that has no form to compare.
    #[error(transparent)]
    Piece(#[from] RationalBezierError),
}

/// The same curve, for every x, on its knots and some more, each as often as it is given.
///
/// The functions on the new knots and the coordinates of the curve are quotients of polynomials on each span; so whether a coordinate is a
/// combination of the functions is a question of linear algebra over the rational numbers, and is decided exactly. For α = ∞ it always
/// is one (Boehm 1980). For other α the functions on a new knot inside of a span have a corner there, which the curve has not: it is one
/// for special curves only, or where the knot has k copies already, so that the pieces on both sides have only the point there in common.
///
/// ```
/// use knotproof::analysis::refined;
/// use knotproof::scalar::{integer, rational};
/// use knotproof::spline::{Basis, Curve, Index, KnotVector};
///
/// let knots = KnotVector::new([0, 0, 0, 2, 2, 2].map(integer).to_vec())?;
/// let points = [[0, 0], [1, 2], [2, 0]].map(|point| point.map(integer).to_vec()).to_vec();
/// let curve = Curve::new(Basis::new(knots, 2, Index::infinity())?, points)?;
/// let finer = refined(&curve, &[integer(1)])?;
/// assert_eq!(finer.points()[1], [rational(1, 2), integer(1)]);
/// assert!(refined(&curve.with("5".parse()?), &[integer(1)]).is_err());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`RefinementError`], if there is no such curve.
pub fn refined(curve: &Curve, new: &[BigRational]) -> Result<Curve, RefinementError> {
    let (basis, dimension) = (curve.basis(), curve.dimension());
    let (first, last) = (basis.knots().first(), basis.knots().last());
    if let Some(knot) = new.iter().find(|knot| *knot < first || *knot > last) {
        let (knot, first, last) = (knot.clone(), first.clone(), last.clone());
        return Err(RefinementError::Outside { knot, first, last });
    }
    let knots = new.iter().fold(basis.knots().clone(), |knots, knot| knots.with_knot(knot));
    let fine = match Basis::new(knots, basis.degree(), Index::clone(Basis::index(basis))) {
        Ok(fine) => fine,
        Err(error) => unreachable!("more knots are not too few: {error}"),
    };
    let mut spans = Vec::new();
    for on in Pieces::of(&fine).spans() {
        let (from, to) = on.ends();
        let part = CurvePart::of(curve, Some(from), Some(to)).map_err(within)?;
        let mut functions: Vec<_> = (0..=fine.n()).map(|i| on.function(i)).collect();
        for piece in RationalBezier::pieces_on(curve, &part) {
            let (weight, coordinates) = piece?.in_positive_coordinate();
            functions.extend(coordinates.iter().filter_map(|p| RationalFunction::new(p, &weight)));
        }
        spans.push(functions);
    }
    let rows = coefficient_rows(spans);
    let (functions, coordinates) = rows.split_at(fine.n() + 1);
    let mut solutions = Vec::with_capacity(dimension);
    for (coordinate, solution) in combinations(functions, coordinates).into_iter().enumerate() {
        let not_in_space = || RefinementError::NotInSpace { coordinate, rank: rank(functions) };
        solutions.push(solution.ok_or_else(not_in_space)?);
    }
    let control = |i: usize| -> Point { solutions.iter().map(|solution| solution[i].clone()).collect() };
    let points = (0..=fine.n()).map(control).collect();
    match Curve::new(fine, points) {
        Ok(curve) => Ok(curve),
        Err(error) => unreachable!("a point for each function: {error}"),
    }
}

/// A span of the new knots lies where the curve is.
fn within(error: CurvePartError) -> RefinementError {
    unreachable!("the new knots are within the old ones: {error}")
}
