//! How α acts on a curve: in one direction only, and no farther than a distance that depends on k and α alone.

use crate::analysis::{
    Piece, Pieces, SpanPieces, always_nonnegative, always_positive, constant, sign_pattern,
};
use crate::scalar::{BigRational, Jet, Ring, integer};
use crate::spline::{Index, PointWeights, Side, triangle};

use super::case::{BasisCase, Case, definition_values};
use super::claim::{Claim, Form};
use super::hypothesis::Hypothesis::{Bernstein, DegreeAtLeast, FiniteIndex};
use super::statement::Statement;
use super::verdict::{Judgement, Ledger, Stop};

/// The spans [t_j, t_{j+1}) with k ≤ j ≤ n, on which all k + 1 functions exist.
pub(super) fn base_spans(case: &BasisCase) -> impl Iterator<Item = &SpanPieces> {
    let base = case.k()..=case.n();
    case.pieces().spans().iter().filter(move |pieces| base.contains(&pieces.span.index()))
}

/// Σ_i (T_i − T′_i) for sums T_i of one list of functions and T′_i of another, from its end up to each but the first,
/// if every one of these differences is positive; `None` otherwise.
///
/// By partial summation Σ d_i(G_i − G′_i) = Σ_i (d_i − d_{i−1})(T_i − T′_i), T_i = G_i + G_{i+1} + …, for functions with the
/// same sum: so this is how far the two curves can be from each other at most, if neighbouring control points have
/// a distance of 1 at most, and d_i = i attains it.
pub(super) fn farthest(
    above: impl DoubleEndedIterator<Item = Piece>,
    below: impl DoubleEndedIterator<Item = Piece>,
    steps: usize,
    ledger: &mut Ledger,
) -> Option<Piece> {
    let mut sums: Option<(Piece, Piece)> = None;
    for (above, below) in above.rev().zip(below.rev()).take(steps) {
        let difference = above.minus(&below);
        let (tail, total) = match sums {
            Some((tail, total)) => (tail.plus(&difference), total),
            None => (difference.clone(), difference.zero()),
        };
        if !ledger.positive(&tail) {
            return None;
        }
        sums = Some((tail.clone(), total.plus(&tail)));
    }
    sums.map(|(_, total)| total)
}

/// c·(r + 1) − |r − 1|·distance, which is ≥ 2c√r if the distance is at most cδ: |r − 1|·δ = r + 1 − 2√r.
fn room<S: Ring>(distance: &S, r: &BigRational, c: &BigRational, embed: impl Fn(BigRational) -> S) -> S {
    let apart = if *r < integer(1) { integer(1) - r } else { r - integer(1) };
    embed(c * (r + integer(1))).minus(&distance.times(&embed(apart)))
}

/// On every span |G_α − G_∞| ≤ c(k)·δ for every polygon with neighbours no farther than 1 from each other; and without
/// interior knots this is attained. In the claim, c(k) = k.
fn close(factor: impl Fn(usize) -> BigRational) -> impl Fn(&BasisCase, &mut Ledger) -> Judgement {
    move |case, ledger| {
        let infinity = case.basis().with_index(Index::infinity());
        let classical = Pieces::of(&infinity);
        let (r, c) = (case.basis().index().ratio(), factor(case.k()));
        let square = integer(4) * &c * &c * r;
        for pieces in base_spans(case) {
            let j = pieces.span.index();
            let living = || j - case.k()..=j;
            let here = living().map(|i| pieces.function(i));
            let Some(there) = classical.on(pieces.span) else {
                return Err(Stop::Fault("the spans depend on α".into()));
            };
            let there = living().map(|i| there.function(i));
            let distance = if *r > integer(1) {
                farthest(here, there, case.k(), ledger)
            } else {
                farthest(there, here, case.k(), ledger)
            };
            let Some(distance) = distance else {
                return Err(Stop::Undecided("no one polygon is the farthest from its curve".into()));
            };
            let room_at = |u| room(u, r, &c, constant);
            let left = room_at(&distance);
            let excess = left.times(&left).minus(&constant(square.clone()));
            let holds = always_nonnegative(&excess).holds();
            if !ledger.positive(&left) || !ledger.count(usize::from(holds), 1) {
                let known =
                    always_positive(&left).failure().or_else(|| always_nonnegative(&excess).failure());
                return Err(case.locate_at(pieces.span, known, |x| {
                    let ordinate = |basis| -> BigRational {
                        let values = definition_values(basis, x, Side::Right);
                        values.iter().enumerate().map(|(i, g)| integer(i) * g).sum()
                    };
                    let (one, other) = (ordinate(case.basis()), ordinate(&infinity));
                    let distance = if one > other { &one - &other } else { &other - &one };
                    let left = room(&distance, r, &c, |c| c);
                    (left < integer(0) || &left * &left < square).then(|| {
                        let at = [("d_i", "i".to_owned()), ("x", x.to_string())];
                        let claimed = format!("|G_α − G_∞| ≤ {c}·|√r − 1|/(√r + 1) with r = {r}");
                        case.witness(at, claimed, format!("the two points are {one} and {other}"))
                    })
                }));
            }
            if case.meets(&Bernstein) && !ledger.count(sign_pattern(excess.numerator()).roots().len(), 1) {
                let claimed = format!("for some x the distance is {c}·|√r − 1|/(√r + 1) with r = {r}");
                let at = [("d_i", "i".to_owned())];
                return Err(case.refuted_at_large(at, claimed, "it is less for every x".into()));
            }
        }
        Ok(())
    }
}

/// The derivative of every G_0 + … + G_i with respect to r is negative inside every span on which that sum is neither 0
/// nor 1; or positive, in the false variant.
fn falls(rising: bool) -> impl Fn(&BasisCase, &mut Ledger) -> Judgement {
    move |case, ledger| {
        let (knots, k) = (case.knots(), case.k());
        for pieces in base_spans(case) {
            let ratio = Jet::variable(constant(case.basis().index().ratio().clone()), 1);
            let weights = PointWeights::new(knots, ratio, Jet::constant(pieces.x.clone(), 1));
            let functions = triangle(&weights, pieces.span, k, knots.m());
            let mut slope = case.pieces().zero();
            for (i, g) in functions.iter() {
                slope = slope.plus(&g.coefficients()[1]);
                if i == pieces.span.index() {
                    if !ledger.equal(&slope, &case.pieces().zero()) {
                        return Err(Stop::Fault("the sum of all functions depends on α".into()));
                    }
                } else if !ledger.positive(&if rising { slope.clone() } else { slope.negate() }) {
                    let (start, end) = pieces.ends();
                    let at = [("j", i.to_string()), ("x", ((start + end) / integer(2)).to_string())];
                    let found = slope.evaluate(&integer(1)).unwrap_or_else(|| integer(0));
                    let way = if rising { "rises" } else { "falls" };
                    let claimed = format!("G_0 + … + G_{i} {way} as r rises");
                    return Err(case.refuted(at, claimed, format!("its derivative by r is {found}")));
                }
            }
        }
        Ok(())
    }
}

/// How α acts.
pub(super) fn claims() -> Vec<Claim> {
    vec![
        Claim::new(
            "X.close",
            "not in the paper",
            Form::Basis(
                Statement::new(
                    "For every x in [t_k, t_{n+1}] and every control polygon |G_α(x) − G_∞(x)| ≤ kδ·max |d_i − d_{i−1}|, where δ = |√r − 1|/(√r + 1) and r = α/(α − 1); without interior knots some x and polygon attain it.",
                    close(integer),
                )
                .given([FiniteIndex, DegreeAtLeast(1)]),
            ),
        )
        .note("δ is the largest distance of φ_α from φ_∞, and about 1/(4|α|) for large |α|. The proof for every degree is in docs/theorems.md. With √(r/s) in the place of √r the same bounds the distance between the curves for two indices of ratios r and s."),
        Claim::new(
            "X.order",
            "not in the paper",
            Form::Basis(
                Statement::new(
                    "For every x in [t_k, t_{n+1}] and every j the sum G_0(x) + … + G_j(x) falls as r = α/(α − 1) rises, or does not depend on r; inside a span [t_l, t_{l+1}] it falls strictly for l − k ≤ j < l.",
                    falls(false),
                )
                .given([DegreeAtLeast(1)]),
            ),
        )
        .note("As α rises from −∞ to 0, r falls from 1 to 0, and as α falls from ∞ to 1, r rises from 1 to ∞: α < 0 moves weight to control points of lower index, α > 1 to higher ones, more and more towards 0 and 1. The engine decides the sign of the derivative for the α of its cases; the certificate is about any two. Outside of [t_k, t_{n+1}] functions are missing, and it need not be so."),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::claims::small_cases::refuted;
    use crate::scalar::rational;

    #[test]
    fn false_variants_are_refuted() {
        let given = [FiniteIndex, DegreeAtLeast(1)];
        assert!(refuted(close(|k| integer(k) - rational(1, 1000)), given), "a smaller distance");
        assert!(refuted(close(|k| integer(k) + rational(1, 1000)), given), "a larger one is not attained");
        assert!(refuted(falls(true), [DegreeAtLeast(1)]), "the sums rise");
    }
}
