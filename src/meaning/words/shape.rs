//! Words about the graph of a basis function: maxima, minima, continuity.

use crate::analysis::{LocalKnots, Monotonicity, Shape};
use crate::language::{Function, Real};
use crate::scalar::BigRational;
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
    let index = match member {
        None => own.index.clone(),
        Some(member) => own.member(member)?,
    };
    let unknown = || Stop::Unknown("a degree that has too few knots".into());
    own.with_index(index, |own| read(own, id)).ok_or_else(unknown)
}

fn shape(own: &mut Reading<'_>, (f, member): OfMember<'_>) -> Result<Shape, Stop> {
    of_basis(own, (f, member), |own, (i, d)| Some(Shape::of(&*own.on.pieces(&own.index, d)?, i)))
}

/// Local maxima; an interval of constancy counts once.
pub(super) fn maxima(own: &mut Reading<'_>, (f, member): OfMember<'_>) -> Result<usize, Stop> {
    of_basis(own, (f, member), |own, (i, d)| {
        let continuous = LocalKnots::of(&own.on.basis_of(&own.index, d)?, i);
        let fast = continuous.and_then(|knots| Monotonicity::of(&knots).local_maxima());
        fast.or_else(|| Some(Shape::of(&*own.on.pieces(&own.index, d)?, i).local_maxima().count()))
    })
}

/// Local minima inside the support.
pub(super) fn minima(own: &mut Reading<'_>, (f, member): OfMember<'_>) -> Result<usize, Stop> {
    Ok(shape(own, (f, member))?.local_minima().count())
}

/// Points at which the largest value is taken: 1, or as many maxima as share it; 0 where it is only a limit.
pub(super) fn maximisers(own: &mut Reading<'_>, (f, member): OfMember<'_>) -> Result<usize, Stop> {
    let shape = shape(own, (f, member))?;
    match shape.weak() {
        Some(true) => Ok(1),
        Some(false) if shape.local_maxima().count() > 1 => Ok(2),
        Some(false) => Ok(0),
        None => Err(Stop::Unknown("two local maxima that lie too close to be told apart".into())),
    }
}

/// Value and limit from the left agree at every knot inside (t_0, t_m).
pub(super) fn continuous(own: &mut Reading<'_>, (f, member): OfMember<'_>) -> Result<bool, Stop> {
    of_basis(own, (f, member), |own, id| {
        let at = |t: &BigRational, side| own.on.value(&own.index, id, t, side, 0);
        Some(own.on.knots()?.inner_stop_knots().all(|(t, _)| at(t, Side::Left) == at(t, Side::Right)))
    })
}
