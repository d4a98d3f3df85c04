//! Words on the spaces that functions span: which one lies in which, of which kind they are.

use num_traits::Signed;

use crate::analysis::{NegativeMinor, Pieces, SpanPieces, coefficient_rows, common_numerators, spans};
use crate::language::{Int, Real};
use crate::scalar::{Polynomial, Ring, integer};
use crate::spline::{Basis, KnotVector, Side};

use super::super::reading::{Reading, place};
use super::super::tries::minor;
use super::super::truth::Stop;

/// The basis of a degree.
fn basis(own: &mut Reading<'_>, degree: &Int) -> Result<Basis, Stop> {
    let (d, k) = (own.int(degree)?, own.degree()?);
    let d = place(d, k + 1, || format!("there are no functions of degree {d}"))?;
    if own.weights.index().is_none() {
        return Err(Stop::Unknown("the parameters of a family on other knots are not known".into()));
    }
    own.on.basis_of(&own.weights, d).ok_or_else(|| Stop::Unknown("too few knots".into()))
}

/// Is no minor negative? Looked for close to the knots: where none is found there, it can't be told.
pub(super) fn totally_positive(own: &mut Reading<'_>, degree: &Int) -> Result<bool, Stop> {
    let (d, k) = (own.int(degree)?, own.degree()?);
    let d = place(d, k + 1, || format!("there are no functions of degree {d}"))?;
    let unknown = || Stop::Unknown("no negative minor of order 3 was found near any knot".into());
    let NegativeMinor { first, points, .. } = minor(own.on, &own.weights, d).ok_or_else(unknown)?;
    for (x, i) in points.iter().flat_map(|x| (first..first + 3).map(move |i| (x, i))) {
        own.look((i, d), x, Side::Right, 0);
    }
    Ok(false)
}

/// Is every function of a basis a combination of those of a finer one, whose knots are its own and perhaps more?
fn contains(fine: &Basis, coarse: &Basis) -> bool {
    let rows = coefficient_rows(Pieces::of(fine).spans().iter().map(|on| {
        let span = coarse.knots().span_at(on.ends().0, Side::Right);
        let active = span.and_then(|span| coarse.active(span, &on.x).ok());
        let other =
            |i| active.as_ref().and_then(|active| active.get(i)).cloned().unwrap_or_else(|| on.x.zero());
        (0..=fine.n()).map(|i| on.function(i)).chain((0..=coarse.n()).map(other)).collect()
    }));
    let (finer, coarser) = rows.split_at(fine.n() + 1);
    spans(finer, coarser)
}

fn on_knots(basis: &Basis, knots: KnotVector, degree: usize) -> Option<Basis> {
    Basis::new(knots, degree, basis.index().clone()).ok()
}

/// Is every function a combination of those for the knots with one more?
pub(super) fn nested(own: &mut Reading<'_>, knot: &Real) -> Result<bool, Stop> {
    let (basis, knot) = (basis(own, &Int::Degree)?, own.real(knot)?);
    let knot = knot.number().ok_or_else(|| Stop::Unknown("a new knot that is no rational number".into()))?;
    let refined = on_knots(&basis, basis.knots().with_knot(knot), basis.degree());
    Ok(refined.is_some_and(|refined| contains(&refined, &basis)))
}

/// Is every function of a degree a combination of those of the next one on the knots of which each occurs once more?
pub(super) fn elevated(own: &mut Reading<'_>, degree: &Int) -> Result<bool, Stop> {
    let basis = basis(own, degree)?;
    let knots = basis.knots();
    let raised = knots.stop_knots().fold(knots.clone(), |raised, (t, _)| raised.with_knot(t));
    Ok(on_knots(&basis, raised, basis.degree() + 1).is_some_and(|raised| contains(&raised, &basis)))
}

/// The least degree in which the functions on the span of an index are rational Bézier curves with positive weights.
pub(super) fn nurbs_degree(own: &mut Reading<'_>, j: &Int) -> Result<usize, Stop> {
    let (j, knots, k) = (own.int(j)?, own.knots()?, own.degree()?);
    let empty = || Stop::Undefined(format!("[t[{j}], t[{}]] is no span", j + 1));
    let span = usize::try_from(j).ok().and_then(|j| knots.span(j)).ok_or_else(empty)?;
    let pieces = own.on.pieces(&own.weights, k).ok_or_else(|| Stop::Unknown("too few knots".into()))?;
    let degree = pieces.on(span).and_then(bezier_degree);
    degree.ok_or_else(|| Stop::Unknown("a degree far above that of the denominator".into()))
}

/// `None` if it is higher by more than a few than the degree of the common denominator.
fn bezier_degree(on: &SpanPieces) -> Option<usize> {
    /// Each of them makes more weights positive.
    const ELEVATIONS: usize = 50;
    let functions = [on.functions.values(), &[on.x.one()]].concat();
    let numerators = common_numerators(&functions);
    let least = numerators.iter().map(Polynomial::degree).max()?;
    // The numerator of 1 over the common denominator is that denominator.
    let mut denominator = numerators.last()?.clone();
    let linear = Polynomial::new(integer(1), [integer(1)]);
    // In degree N the coefficients in u are the weights times binomial coefficients; one degree more is a factor 1 + u.
    (least..least + ELEVATIONS).find(|degree| {
        let positive =
            denominator.degree() == *degree && denominator.coefficients().iter().all(Signed::is_positive);
        denominator = denominator.times(&linear);
        positive
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::meaning::{Instance, Names};

    fn on<T>(degree: usize, knots: &[usize], alpha: &str, read: impl FnOnce(&mut Reading<'_>) -> T) -> T {
        let knots = KnotVector::new(knots.iter().map(|t| integer(*t)).collect()).unwrap();
        let instance = Instance::of(Basis::new(knots, degree, alpha.parse().unwrap()).unwrap());
        read(&mut Reading::new(&instance, Names::empty()))
    }

    #[test]
    fn polynomial_splines_are_nested_and_others_at_full_knots_only() {
        let cubic = [0, 0, 0, 0, 1, 2, 2, 2, 3, 3, 3, 3];
        for (t, finite) in [(1, false), (2, true)] {
            for (alpha, expected) in [("inf", true), ("-1", finite)] {
                let t = Real::Whole(Int::Number(t));
                assert_eq!(on(3, &cubic, alpha, |own| nested(own, &t)), Ok(expected));
            }
        }
        for (degree, knots, alpha, expected) in
            [(3, &cubic[..], "inf", true), (3, &cubic, "-1", false), (1, &[0, 0, 1, 1], "-1", true)]
        {
            assert_eq!(on(degree, knots, alpha, |own| elevated(own, &Int::Degree)), Ok(expected));
        }
    }

    #[test]
    fn bezier_degrees() {
        for (knots, alpha, j, expected) in [
            (&[0, 1, 2, 3, 5, 6][..], "inf", 2, Ok(2)),
            (&[0, 0, 0, 1, 1, 1], "-1", 2, Ok(2)),
            (&[0, 1, 2, 3, 5, 6], "-1", 2, Ok(3)),
            (&[0, 0, 0, 1, 1, 1], "-1", 0, Err(Stop::Undefined("[t[0], t[1]] is no span".into()))),
        ] {
            assert_eq!(on(2, knots, alpha, |own| nurbs_degree(own, &Int::Number(j))), expected, "{knots:?}");
        }
    }
}
