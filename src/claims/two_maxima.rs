//! For which α the conjecture on maxima fails: knots for every α ≠ ∞.

use num_bigint::BigInt;

use crate::analysis::{LocalKnots, Monotonicity, Shape, Sign};
use crate::scalar::{BigRational, Ring, integer, rational};
use crate::spline::{Basis, Index, KnotVector};

use super::basis::name;
use super::case::{BasisCase, Origin};
use super::claim::{Claim, Form};
use super::hypothesis::Hypothesis::{ClassicalIndex, DegreeAtLeast, DegreeAtMost, EqualGaps, FiniteIndex};
use super::maximum::{Except, Reading, conjecture, nowhere, searched};
use super::statement::Statement;
use super::verdict::{Judgement, Ledger};

/// How far the gap after x has come from the one end of its way to the other.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Way {
    Start,
    Middle,
    End,
}

/// The local knots 0 = … = 0 < x < y < z, k − 1 of them 0, of a function of degree k for the ratio r = p/q: the gap after x
/// is (k − 2)r − κc, in units of x, where c = r(r − 1)²/(8(r + 1)²) is the one after y, and κ is 0 at the start, 1 at
/// the end and in between, in the middle,
///
/// κ = ((2k² − 7k + 7)r + 5k − 7) / (2(k − 1)((2k − 3)r + 3)).
///
/// For c = 0 both one-sided derivatives at x would be 0 with κ = 0. For small c > 0, to first order, the one on
/// the left is 0 for κ = ((k − 2)²r + 3k − 4)/(2(k − 1)((k − 2)r + 2)), that on the right for a larger κ unless r = 1:
/// the κ of the middle is their mediant.
fn family(k: usize, (p, q): (&BigInt, &BigInt), way: Way) -> Vec<BigInt> {
    let [d, sum]: [BigInt; 2] = [p - q, p + q].map(|x| &x * &x);
    let l = sum * 8;
    let e: BigInt = (p * (2 * k - 3) + q * 3) * (2 * (k - 1));
    let kappa = match way {
        Way::Start => BigInt::ZERO,
        Way::Middle => p * (2 * k * k + 7 - 7 * k) + q * (5 * k - 7),
        Way::End => e.clone(),
    };
    let after = p * (&l * &e * (k - 2) - kappa * &d);
    let mut gaps = vec![BigInt::ZERO; k - 2];
    gaps.extend([q * l * &e, after, e * p * d]);
    gaps
}

/// On the knots of the family for the α and the degree of the case: two local maxima in the middle of the way, and one at
/// its ends, right of x at the start and left of it at the end.
fn two_maxima(wanted: usize) -> impl Fn(&BasisCase, &mut Ledger) -> Judgement {
    move |case, ledger| {
        let (k, ratio) = (case.k(), case.basis().index().ratio());
        let (p, q) = (ratio.numer(), ratio.denom());
        for (way, wanted) in [(Way::Start, 1), (Way::Middle, wanted), (Way::End, 1)] {
            let gaps = family(k, (p, q), way);
            let list: Vec<_> = gaps.iter().map(ToString::to_string).collect();
            let Ok(knots) = LocalKnots::new(gaps, (p.clone(), q.clone())) else {
                unreachable!("the first and the last gap are positive")
            };
            let function = Monotonicity::of(&knots);
            // The span before x is the first that is not empty.
            let before_x = function.spans().first().and_then(|span| span.signs.last());
            let falls_to_x = before_x == Some(&Sign::Negative);
            let maxima = function.local_maxima().unwrap_or(0);
            if !ledger.count(maxima, wanted) || falls_to_x != (way != Way::Start) {
                let claimed = format!("the function of these knots has {wanted} local maxima");
                let at = [("gaps between the knots of the function", format!("({})", list.join(", ")))];
                return Err(case.refuted(at, claimed, format!("it has {maxima}")));
            }
        }
        Ok(())
    }
}

/// On no span more than one change of direction, and that from rising to falling, `allowed` times at most.
fn rises_then_falls(allowed: usize) -> impl Fn(&BasisCase, &mut Ledger) -> Judgement {
    move |case, ledger| {
        for i in 0..=case.n() {
            let Some(knots) = LocalKnots::of(case.basis(), i) else { continue };
            for on_span in Monotonicity::of(&knots).spans() {
                let turns = on_span.signs.len() - 1;
                let rises_last = turns > 0 && on_span.signs.last() == Some(&Sign::Positive);
                if !ledger.count(turns.max(allowed), allowed) || rises_last {
                    let (start, end) =
                        (case.knots().t(i + on_span.span), case.knots().t(i + on_span.span + 1));
                    let at = [("i", i.to_string()), ("span", format!("[{start}, {end})"))];
                    let claimed = "the function rises, falls, or rises and then falls".to_owned();
                    return Err(case.refuted(at, claimed, format!("it changes its direction {turns} times")));
                }
            }
        }
        Ok(())
    }
}

/// At most so many local maxima, for every function that is not 0 everywhere and jumps nowhere inside (t_0, t_m).
fn at_most(most: fn(k: usize) -> usize) -> impl Fn(&BasisCase, &mut Ledger) -> Judgement {
    move |case, ledger| {
        let most = most(case.k());
        for i in 0..=case.n() {
            if nowhere(case, i, ledger) || Except::Jumps.leaves_out(case, i) {
                continue;
            }
            let maxima = Shape::of(case.pieces(), i).local_maxima().count();
            if !ledger.count(maxima.max(most), most) {
                let claimed = format!("{} has at most {most} local maxima", name(case.k(), i));
                let at = [("i", i.to_string())];
                return Err(case.refuted(at, claimed, format!("it has {maxima}")));
            }
        }
        Ok(())
    }
}

/// Gaps between the k + 2 knots of a function with k − 1 local maxima, and its ratio: in units of h,
///
/// B³, h_1, …, h_{k−2}, B⁴, B⁵ with r = B³, B = 2k², h_1 = 3/5, h_n = 4/(n(2n + 1)(2n + 3)) for n ≥ 2.
///
/// For B → ∞ the derivative on the short spans tends to a multiple of n − (n + 1)X, where X = Σ x_i for the distances
/// x_i from the knots t_1, …, t_n before the point: it is negative at the end of such a span and positive at the start of the
/// next one if n/(n + 1) < X < (n + 1)/(n + 2) there, and the h_n make X the mediant (2n + 1)/(2n + 3).
fn most_gaps(k: usize) -> (Vec<BigRational>, BigRational) {
    let b = integer(2 * k * k);
    let short = |n: usize| match n {
        1 => rational(3, 5),
        _ => integer(4) / integer(n * (2 * n + 1) * (2 * n + 3)),
    };
    let mut gaps = vec![b.power(3)];
    gaps.extend((1..=k.saturating_sub(2)).map(short));
    gaps.extend([b.power(4), b.power(5)]);
    (gaps, b.power(3))
}

/// The function of those gaps has k − 1 local maxima, and `more`.
fn most_maxima(more: usize) -> impl Fn(&BasisCase, &mut Ledger) -> Judgement {
    move |case, ledger| {
        let k = case.k();
        let (gaps, ratio) = most_gaps(k);
        let mut knots = vec![integer(0)];
        for gap in &gaps {
            knots.push(&knots[knots.len() - 1] + gap);
        }
        knots.extend(vec![knots[knots.len() - 1].clone(); k]);
        let basis = KnotVector::new(knots).ok().zip(Index::from_ratio(ratio).ok());
        let basis = basis.and_then(|(knots, index)| Basis::new(knots, k, index).ok());
        let Some(function) = basis.and_then(|basis| LocalKnots::of(&basis, 0)) else {
            unreachable!("the gaps are positive")
        };
        let maxima = Monotonicity::of(&function).local_maxima().unwrap_or(0);
        if ledger.count(maxima, k - 1 + more) {
            return Ok(());
        }
        let list: Vec<_> = gaps.iter().map(ToString::to_string).collect();
        let at = [("gaps between the knots of the function", format!("({})", list.join(", ")))];
        let claimed = format!("it has {} local maxima", k - 1 + more);
        Err(case.refuted(at, claimed, format!("it has {maxima}")))
    }
}

/// α and degrees to try the family with, for which the register has no cases.
fn higher_degrees() -> Vec<BasisCase> {
    let bases = (7..=8).flat_map(|k| {
        ["-1", "2", "-1/3", "4/3", "-3", "5/2"].into_iter().map(move |alpha| {
            let (knots, index) = (KnotVector::bernstein(k, &integer(0), &integer(1)), alpha.parse::<Index>());
            match (knots, index) {
                (Ok(knots), Ok(index)) => Basis::new(knots, k, index),
                _ => unreachable!("0 < 1, and the indices lie outside of [0, 1]"),
            }
        })
    });
    bases.flatten().map(|basis| BasisCase::new(basis, Origin::Small)).collect()
}

/// What is known of the conjecture for each α.
pub(super) fn claims() -> Vec<Claim> {
    vec![
        Claim::new(
            "X.maxima",
            "not in the paper",
            Form::Basis(
                Statement::new(
                    "For every k ≥ 3 and every α ≠ ∞ there are open knot vectors with two simple interior knots on which the basis function G_2^k has two local maxima, and such on which it takes its largest value at two points.",
                    two_maxima(2),
                )
                .given([FiniteIndex, DegreeAtLeast(3)]),
            ),
        )
        .by_degree_on(higher_degrees)
        .note("So Conjecture 3.1 fails in both readings for every α ≠ ∞ in the degrees from 3 on that are given. The knots are explicit: k + 1 times 0, then x, y and k + 1 times z, with gaps y − x = x((k − 2)r − κc) and z − y = xc, where c = r(r − 1)²/(8(r + 1)²); with κ = ((2k² − 7k + 7)r + 5k − 7)/(2(k − 1)((2k − 3)r + 3)) there are two local maxima, and between κ = 0 and κ = 1 there is one for which they are equally high. The engine counts the maxima for the α of its cases."),
        Claim::new(
            "X.maxima.spans",
            "not in the paper",
            Form::Basis(
                Statement::new(
                    "Inside every span of its support G_i^k rises, or falls, or rises and then falls: every local minimum inside the support is at a knot.",
                    rises_then_falls(1),
                )
                .given([DegreeAtLeast(1)]),
            ),
        )
        .by_degree_on(searched)
        .note("As a function rises on its first span and falls on its last one, a local minimum is at a knot between two of the k − 1 spans between: so where this is proved for every knot vector, a continuous function has at most k − 1 local maxima, for k ≥ 2."),
        Claim::new(
            "X.maxima.bound",
            "not in the paper",
            Form::Basis(
                Statement::new(
                    "For k ≥ 2 every G_i^k with t_i < t_{i+k+1} that is continuous on (t_0, t_m) has at most k − 1 local maxima.",
                    at_most(|k| k - 1),
                )
                .given([DegreeAtLeast(2)]),
            ),
        )
        .by_degree_on(searched)
        .note("It follows from X.maxima.spans; and by X.maxima.most there are no fewer."),
        Claim::new(
            "X.maxima.uniform",
            "not in the paper",
            Form::Basis(
                Statement::new(
                    "On simple uniform knots, for 1 ≤ k ≤ 3, every G_i^k has exactly one local maximum.",
                    conjecture(Reading::Strong, Except::Nothing, 1),
                )
                .given([DegreeAtLeast(1), DegreeAtMost(3), EqualGaps]),
            ),
        )
        .note("All functions are translates of one. For k = 3 its two derivatives at its middle knot have the same sign, that of 1 − r."),
        Claim::new(
            "X.maxima.most",
            "not in the paper",
            Form::Basis(
                Statement::new(
                    "For every k ≥ 2 some continuous basis function of degree k has k − 1 local maxima.",
                    most_maxima(0),
                )
                .given([DegreeAtLeast(2)]),
            ),
        )
        .by_degree_on(higher_degrees)
        .note("The gaps between its knots are B³, h_1, …, h_{k−2}, B⁴, B⁵ with r = B³, B = 2k², h_1 = 3/5 and h_n = 4/(n(2n + 1)(2n + 3)). More than k − 1 there are not where X.maxima.spans is proved for every knot vector."),
        Claim::new(
            "X.maxima.classical",
            "not in the paper",
            Form::Basis(
                Statement::new(
                    "For α = ∞ every G_i^k with t_i < t_{i+k+1} that is continuous on (t_0, t_m) has exactly one local maximum.",
                    conjecture(Reading::Strong, Except::Jumps, 1),
                )
                .given([ClassicalIndex, DegreeAtLeast(1)]),
            ),
        )
        .note("Known for all degrees: polynomial B-splines are logarithmically concave (Curry and Schoenberg, 1966). With X.maxima this settles for which α the conjecture can fail: for all but ∞."),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::claims::small_cases::refuted;

    #[test]
    fn other_numbers_of_maxima_are_refuted() {
        assert!(refuted(two_maxima(1), [FiniteIndex, DegreeAtLeast(3)]));
        assert!(refuted(two_maxima(3), [FiniteIndex, DegreeAtLeast(3)]));
    }

    #[test]
    fn more_maxima_are_refuted() {
        assert!(refuted(most_maxima(1), [DegreeAtLeast(2)]));
    }

    #[test]
    fn two_maxima_in_degree_3_are_too_many_for_one() {
        assert!(refuted(at_most(|k| k - 2), [DegreeAtLeast(3)]));
    }

    #[test]
    fn a_function_may_rise_and_then_fall() {
        assert!(refuted(rises_then_falls(0), [DegreeAtLeast(2)]));
    }

    /// At α = ∞ the family comes to nothing: its last gap is 0, and there is one maximum.
    #[test]
    fn the_classical_index_is_left_out() {
        assert!(refuted(two_maxima(2), [ClassicalIndex, DegreeAtLeast(3)]));
    }
}
