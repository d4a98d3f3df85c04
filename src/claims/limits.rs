//! What becomes of a curve as α → 0⁻ or α → 1⁺, that is as r = α/(α − 1) tends to 0 or to ∞.

use std::ops::RangeInclusive;

use crate::analysis::{Piece, SpanPieces, always_positive, constant, coordinate_of};
use crate::scalar::{BigRational, RationalAlgebra, Ring, integer};
use crate::spline::{FormalWeights, Side, triangle};

use super::basis::name;
use super::case::BasisCase;
use super::claim::{Claim, Form};
use super::closeness::{base_spans, farthest};
use super::hypothesis::Hypothesis::{DegreeAtLeast, FirstSpan, LastSpan, Open};
use super::statement::Statement;
use super::verdict::{Judgement, Ledger, Stop};

/// To which end r tends.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Way {
    /// α → 0⁻.
    Zero,
    /// α → 1⁺.
    Infinity,
}

impl Way {
    const BOTH: [Self; 2] = [Self::Zero, Self::Infinity];

    /// r or 1/r, which tends to 0.
    fn small(self, case: &BasisCase) -> BigRational {
        let r = case.basis().index().ratio();
        if self == Self::Zero { r.clone() } else { r.recip() }
    }

    fn name(self) -> &'static str {
        if self == Self::Zero { "r" } else { "1/r" }
    }
}

/// numerator/denominator for functions on a span whose denominator has no zero inside of it.
fn quotient(numerator: &Piece, denominator: &Piece) -> Piece {
    match numerator.over(denominator) {
        Some(quotient) => quotient,
        None => unreachable!("the denominator is not the function 0"),
    }
}

/// x − t.
fn beyond(pieces: &SpanPieces, t: &BigRational) -> Piece {
    pieces.x.minus(&pieces.x.embed(t))
}

/// The functions of a range add up on a span to more than 1 − z·(r or 1/r), or to 1.
fn nearly_all(
    case: &BasisCase,
    pieces: &SpanPieces,
    way: Way,
    functions: RangeInclusive<usize>,
    z: &Piece,
    ledger: &mut Ledger,
) -> Judgement {
    let sum = functions.clone().fold(pieces.x.zero(), |sum, i| sum.plus(&pieces.function(i)));
    let rest = pieces.x.one().minus(&sum);
    let bound = z.times(&pieces.x.embed(&way.small(case)));
    let excess = bound.minus(&rest);
    let holds = if rest.is_zero() { ledger.equal(&rest, &rest.zero()) } else { ledger.positive(&excess) };
    if holds {
        return Ok(());
    }
    Err(case.locate_at(pieces.span, always_positive(&excess).failure(), |x| {
        let sum: BigRational = case.values(x, Side::Right)[functions.clone()].iter().sum();
        let bound = bound.evaluate(&coordinate_of(case.knots(), pieces.span, x).ok()??)?;
        (integer(1) - &sum > bound).then(|| {
            let names: Vec<_> = functions.clone().map(|i| name(case.k(), i)).collect();
            let claimed = format!("1 − ({})({x}) ≤ {bound}, a multiple of {}", names.join(" + "), way.name());
            case.witness([("x", x.to_string())], claimed, format!("the sum is {sum}"))
        })
    }))
}

/// Inside of the span [t_j, t_{j+1}] the function with index j − k (or j), less than 1 by no more than r (or 1/r) times a sum
/// over k knots that does not depend on α; of these `fewer` are left out.
fn one_point(fewer: usize) -> impl Fn(&BasisCase, &mut Ledger) -> Judgement {
    move |case, ledger| {
        let (knots, k) = (case.knots(), case.k());
        for pieces in base_spans(case) {
            let j = pieces.span.index();
            for way in Way::BOTH {
                let (i, knots_there, end) = match way {
                    Way::Zero => (j - k, j + 1 - k + fewer..=j, knots.t(j + 1)),
                    Way::Infinity => (j, j + 1..=j + k - fewer, knots.t(j)),
                };
                let from_end = beyond(pieces, end).negate();
                let terms = knots_there.map(|l| quotient(&beyond(pieces, knots.t(l)), &from_end));
                let z = terms.fold(pieces.x.zero(), |sum, term| sum.plus(&term));
                nearly_all(case, pieces, way, i..=i, &z, ledger)?;
            }
        }
        Ok(())
    }
}

/// On the whole span the functions j − k, …, j − k + p, where p is the multiplicity of t_{j+1} (or j − p, …, j, of t_j), have a
/// sum less than 1 by no more than r (or 1/r) times a number that does not depend on α and x; of these functions
/// `fewer` are left out.
fn near_knot(fewer: usize) -> impl Fn(&BasisCase, &mut Ledger) -> Judgement {
    move |case, ledger| {
        let (knots, k) = (case.knots(), case.k());
        for pieces in base_spans(case) {
            let j = pieces.span.index();
            for way in Way::BOTH {
                let end = if way == Way::Zero { knots.t(j + 1) } else { knots.t(j) };
                let p = knots.multiplicity(end).min(k);
                let mut z = integer(0);
                for d in p + 1..=k {
                    let (i, next) = match way {
                        Way::Zero => (j + 1 + p - d, j + 1 + p),
                        Way::Infinity => (j - p + d, j - p),
                    };
                    z += (end - knots.t(i)) / (knots.t(next) - end);
                }
                let functions = match way {
                    Way::Zero => j - k..=j - k + p - fewer,
                    Way::Infinity => j - p + fewer..=j,
                };
                nearly_all(case, pieces, way, functions, &constant(z), ledger)?;
            }
        }
        Ok(())
    }
}

/// On the last span the curve is no farther than kr from a curve that does not depend on α but by its parameter
/// r/(t_m − x), if neighbouring control points have a distance of 1 at most; on the first span, than k/r. In the false
/// variant only a part of that distance.
fn arc(way: Way, part: BigRational) -> impl Fn(&BasisCase, &mut Ledger) -> Judgement {
    move |case, ledger| {
        let (knots, k) = (case.knots(), case.k());
        let place = if way == Way::Zero { case.n() } else { k };
        let end = if way == Way::Zero { knots.last() } else { knots.first() };
        let Some(pieces) = case.pieces().spans().iter().find(|pieces| pieces.span.index() == place) else {
            return Ok(());
        };
        let one = pieces.x.one();
        let small = way.small(case);
        let parameter = quotient(&pieces.x.embed(&small), &beyond(pieces, end).negate());
        let weight = |i: usize, d: usize| {
            let knot = if way == Way::Zero { knots.t(i) } else { knots.t(i + d) };
            let odds = parameter.times(&one.embed(&(end - knot)));
            let other = quotient(&one, &one.plus(&odds));
            if way == Way::Zero { one.minus(&other) } else { other }
        };
        let on_arc = triangle(&FormalWeights::new(&one, weight), pieces.span, k, knots.m());
        let living = || place - k..=place;
        let curve = living().map(|i| pieces.function(i));
        let on_arc = living().map(|i| on_arc.get(i).cloned().unwrap_or_else(|| one.zero()));
        let distance = match way {
            Way::Zero => farthest(on_arc, curve, k, ledger),
            Way::Infinity => farthest(on_arc.rev(), curve.rev(), k, ledger),
        };
        let Some(distance) = distance else {
            return Err(Stop::Undecided("no one polygon is the farthest from its arc".into()));
        };
        let bound = integer(k) * small * &part;
        if !ledger.positive(&one.embed(&bound).minus(&distance)) {
            let at = [("d_i", "i".to_owned())];
            let claimed = format!("the curve is at most {bound} from the arc on the span {place}");
            return Err(case.refuted_at_large(at, claimed, "somewhere it is farther".into()));
        }
        Ok(())
    }
}

/// Both arcs.
fn arcs(case: &BasisCase, ledger: &mut Ledger) -> Judgement {
    Way::BOTH.into_iter().try_for_each(|way| arc(way, integer(1))(case, ledger))
}

/// What the curves tend to.
pub(super) fn claims() -> Vec<Claim> {
    vec![
        Claim::new(
            "X.limit",
            "not in the paper",
            Form::Basis(
                Statement::new(
                    "For k ≤ j ≤ n and t_j < x < t_{j+1}: G_α(x) tends to d_{j−k} as α → 0⁻ and to d_j as α → 1⁺. More exactly, 1 − G_{j−k}(x) ≤ r·Σ_{i=j−k+1}^{j} (x − t_i)/(t_{j+1} − x) and 1 − G_j(x) ≤ (1/r)·Σ_{i=j+1}^{j+k} (t_i − x)/(x − t_j), with r = α/(α − 1).",
                    one_point(0),
                )
                .given([DegreeAtLeast(1)]),
            ),
        )
        .note("So the curve, as a function of x, tends to a step function, and is farther and farther from the classical one. The engine decides the bounds for the α of its cases, for every x."),
        Claim::new(
            "X.limit.trace",
            "not in the paper",
            Form::Basis(
                Statement::new(
                    "For k ≤ j ≤ n let p be the multiplicity of t_{j+1}, but k at most. For every x in [t_j, t_{j+1}]: 1 − (G_{j−k} + … + G_{j−k+p})(x) ≤ rK, where K = Σ_{d=p+1}^{k} (t_{j+1} − t_{j+1+p−d})/(t_{j+1+p} − t_{j+1}) depends on the knots alone. For 1/r, and with p the multiplicity of t_j, the same of 1 − (G_{j−p} + … + G_j)(x) and Σ_{d=p+1}^{k} (t_{j−p+d} − t_j)/(t_j − t_{j−p}).",
                    near_knot(0),
                )
                .given([DegreeAtLeast(1)]),
            ),
        )
        .note("With simple interior knots, p = 1 on all spans but the last (for 1/r: the first): there the curve keeps to a segment [d_{j−k}, d_{j−k+1}], and comes uniformly close to it at the rate r. So as α → 0⁻ its trace tends to the polygon d_0, …, d_{n−k} and an arc on d_{n−k}, …, d_n, and as α → 1⁺ to an arc on d_0, …, d_k and the polygon d_k, …, d_n. The arcs are those of X.limit.arc; figure trace-limit shows them."),
        Claim::new(
            "X.limit.arc",
            "not in the paper",
            Form::Basis(
                Statement::new(
                    "Let A(y) be the point that de Boor's algorithm makes of d_{n−k}, …, d_n with the weights w_i = y(t_m − t_i)/(1 + y(t_m − t_i)) on all levels: an arc from d_{n−k}, for y = 0, to d_n, for y → ∞. For x in [t_n, t_m] and y = r/(t_m − x) the points G_α(x) and A(y) are at most kr·max |d_i − d_{i−1}| apart; with 1 − w_i = y(t_{i+d} − t_0)/(1 + y(t_{i+d} − t_0)) and y = (1/r)/(x − t_0) the same on [t_0, t_{k+1}] for 1/r.",
                    arcs,
                )
                .given([Open, FirstSpan, LastSpan, DegreeAtLeast(1)]),
            ),
        )
        .note("As α → 0⁻ the parameter y takes all values from r/(t_m − t_n) on, so that the last piece of the trace tends to the arc, which does not depend on α."),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::claims::hypothesis::Hypothesis::FiniteIndex;
    use crate::claims::small_cases::refuted;
    use crate::scalar::rational;

    #[test]
    fn false_variants_are_refuted() {
        let finite = [FiniteIndex, DegreeAtLeast(1)];
        assert!(refuted(one_point(1), finite), "a knot fewer");
        assert!(refuted(near_knot(1), finite), "a control point fewer");
        for way in Way::BOTH {
            let given = [Open, FirstSpan, LastSpan, DegreeAtLeast(1)];
            assert!(refuted(arc(way, rational(1, 4)), given), "{way:?}, nearer");
        }
    }
}
