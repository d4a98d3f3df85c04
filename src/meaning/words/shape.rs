//! Words about knots, and about the graph of a basis function: multiplicity, maxima, minima, continuity.

use crate::analysis::{Attained, LocalKnots, Monotonicity, Piece, Shape, Tie};
use crate::language::{Function, Int, Real};
use crate::scalar::{BigRational, Ring};
use crate::spline::Side;

use super::super::functions::Where;
use super::super::reading::Reading;
use super::super::truth::Stop;
use super::OfMember;

/// How often the number occurs among the knots.
pub(super) fn multiplicity(own: &mut Reading<'_>, x: &Real) -> Result<usize, Stop> {
    let x = own.real(x)?;
    Ok(match own.place(&x)? {
        Where::Knot(t) => own.knots()?.multiplicity(&t),
        Where::Span(_) | Where::Outside => 0,
    })
}

/// The i-th of the different knots.
pub(super) fn stop(own: &mut Reading<'_>, i: &Int) -> Result<BigRational, Stop> {
    let (i, mut stops) = (own.int(i)?, own.knots()?.stop_knots());
    let missing = || Stop::Undefined(format!("there is no stop knot u_{i}"));
    let at = usize::try_from(i).map_err(|_| missing())?;
    stops.nth(at).map(|(t, _)| t.clone()).ok_or_else(missing)
}

/// Reads something of a basis function, with the index of a member.
fn of_basis<T>(
    own: &mut Reading<'_>,
    (f, member): OfMember<'_>,
    read: impl FnOnce(&Reading<'_>, (usize, usize)) -> Option<T>,
) -> Result<T, Stop> {
    let Function::Basis { i, degree } = f else {
        return Err(Stop::Unknown("the shape of what is no basis function".into()));
    };
    let id = own.existing(i, degree.as_ref())?;
    let weights = match member {
        None => own.weights.clone(),
        Some(member) => own.member(member)?,
    };
    let unknown = || Stop::Unknown("a degree that has too few knots".into());
    own.with_weights(weights, |own| read(own, id)).ok_or_else(unknown)
}

fn shape(own: &mut Reading<'_>, of: OfMember<'_>) -> Result<Shape, Stop> {
    nonnegative(own, of)?;
    of_basis(own, of, |own, (i, d)| Some(Shape::of(&*own.on.pieces(&own.weights, d)?, i)))
}

/// A shape is that of a function ≥ 0, which begins and ends at 0: of another one it can't be told.
fn nonnegative(own: &mut Reading<'_>, of: OfMember<'_>) -> Result<(), Stop> {
    if of_basis(own, of, |own, id| own.on.is_nonnegative(&own.weights, id))? {
        return Ok(());
    }
    Err(Stop::Unknown("the shape of a function that is negative somewhere".into()))
}

/// Local maxima; an interval of constancy counts once.
pub(super) fn maxima(own: &mut Reading<'_>, of: OfMember<'_>) -> Result<usize, Stop> {
    nonnegative(own, of)?;
    of_basis(own, of, |own, (i, d)| {
        let continuous = own.on.basis_of(&own.weights, d).and_then(|basis| LocalKnots::of(&basis, i));
        let fast = continuous.and_then(|knots| Monotonicity::of(&knots).local_maxima());
        fast.or_else(|| Some(Shape::of(&*own.on.pieces(&own.weights, d)?, i).local_maxima().count()))
    })
}

/// Local minima inside the support.
pub(super) fn minima(own: &mut Reading<'_>, (f, member): OfMember<'_>) -> Result<usize, Stop> {
    Ok(shape(own, (f, member))?.local_minima().count())
}

/// Points at which the largest value is taken; 0 where it is only a limit.
pub(super) fn maximisers(own: &mut Reading<'_>, of: OfMember<'_>) -> Result<usize, Stop> {
    // A continuous function with one local maximum takes it once, if it is constant on no span.
    if of_basis(own, of, |own, (i, d)| Some(one_peak(own, (i, d)).unwrap_or(false)))? {
        return Ok(1);
    }
    match shape(own, of)?.maximisers() {
        Some(Attained::Times(count)) => Ok(count),
        Some(Attained::Throughout) => Err(Stop::Undefined("the number of points of an interval".into())),
        None => Err(Stop::Unknown("two local maxima that lie too close to be told apart".into())),
    }
}

fn one_peak(own: &Reading<'_>, (i, d): (usize, usize)) -> Option<bool> {
    let one = Monotonicity::of(&LocalKnots::of(&own.on.basis_of(&own.weights, d)?, i)?).local_maxima()? == 1;
    let pieces = own.on.pieces(&own.weights, d)?;
    let constant = |g: &Piece| g.numerator().degree() == 0 && g.denominator().degree() == 0 && !g.is_zero();
    Some(one && !pieces.spans().iter().any(|on| on.functions.get(i).is_some_and(constant)))
}

/// For an index close by, the largest value taken at two points; not where there is one maximum at this index.
pub(super) fn tie(own: &mut Reading<'_>, of: OfMember<'_>) -> Result<Option<Tie>, Stop> {
    if maxima(own, of)? < 2 {
        return Ok(None);
    }
    let tie = of_basis(own, of, |own, id| Some(own.on.tie(&own.weights, id)))?;
    let unknown =
        || Stop::Unknown("two local maxima of which none overtakes the other for an index close by".into());
    tie.map(Some).ok_or_else(unknown)
}

/// Value and limit from the left agree at every knot inside (t_0, t_m).
pub(super) fn continuous(own: &mut Reading<'_>, (f, member): OfMember<'_>) -> Result<bool, Stop> {
    of_basis(own, (f, member), |own, id| {
        let at = |t: &BigRational, side| own.on.value(&own.weights, id, t, side, 0);
        Some(own.on.knots()?.inner_stop_knots().all(|(t, _)| at(t, Side::Left) == at(t, Side::Right)))
    })
}
