//! Section 3, second half: derivatives at the ends and at the knots.

use crate::analysis::Piece;
use crate::scalar::{BigRational, Jet, RationalAlgebra, RationalFunction, Ring, integer};
use crate::spline::{Side, weight};

use super::basis::{name, regular};
use super::case::BasisCase;
use super::cause::Cause;
use super::claim::{Claim, Form};
use super::hypothesis::Hypothesis::{
    DegreeAtLeast, EnoughKnots, FiniteIndex, FirstSpan, LastMultiplicityNotDegreePlusTwo, LastSpan, Open,
    SimpleKnots,
};
use super::hypothesis::STATED_IN_THE_PROOF;
use super::statement::Statement;
use super::verdict::{Judgement, Ledger, Stop};

/// A one-sided derivative at the end of the knots: of a function G_i^d, or of a weight w_i^d.
#[derive(Clone, Copy)]
enum Slope {
    Function(usize, usize),
    Weight(usize, usize),
}

/// D G_i^d (of the first) = Σ ± D(…): a linear relation between one-sided derivatives.
struct Relation {
    left: Slope,
    right: Vec<(i64, Slope)>,
}

/// The slopes at t_0 from the right, or at t_m from the left, by the definition over jets.
struct EndSlopes<'a> {
    case: &'a BasisCase,
    x: BigRational,
    table: Vec<Vec<Jet<BigRational>>>,
}

impl<'a> EndSlopes<'a> {
    fn new(case: &'a BasisCase, side: Side) -> Option<Self> {
        let x = if side == Side::Right { case.knots().first() } else { case.knots().last() }.clone();
        let table = case.jet_table(&x, side, 1)?;
        Some(Self { case, x, table })
    }

    fn of(&self, slope: Slope) -> BigRational {
        let jet = match slope {
            Slope::Function(d, i) => self.table[d][i].clone(),
            Slope::Weight(d, i) => {
                let x = Jet::variable(self.x.clone(), 1);
                let knots = self.case.knots();
                weight(&x.embed(self.case.basis().index().ratio()), &x, knots.t(i), knots.t(i + d)).0
            }
        };
        jet.coefficients()[1].clone()
    }
}

impl std::fmt::Display for Slope {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Function(d, i) => write!(f, "D{}", name(*d, *i)),
            Self::Weight(d, i) => write!(f, "Dw_{i}^{d}"),
        }
    }
}

/// The relations of L3.8 or L3.9, for every r.
fn end_relations(
    side: Side,
    relations: fn(k: usize, n: usize, r: usize) -> Vec<Relation>,
) -> impl Fn(&BasisCase, &mut Ledger) -> Judgement {
    move |case, ledger| {
        let Some(slopes) = EndSlopes::new(case, side) else { return Ok(()) };
        for r in 0..case.k() {
            for Relation { left, right } in relations(case.k(), case.n(), r) {
                let found = slopes.of(left);
                let terms = right
                    .iter()
                    .map(|&(sign, slope)| slopes.of(slope) * BigRational::from_integer(sign.into()));
                let claimed: BigRational = terms.sum();
                if !ledger.equal(&found, &claimed) {
                    let sides: Vec<_> = right
                        .iter()
                        .map(|(sign, slope)| format!("{} {slope}", if *sign > 0 { '+' } else { '−' }))
                        .collect();
                    let right = sides.join(" ");
                    let right = right.strip_prefix("+ ").unwrap_or(&right);
                    let at = [("r", r.to_string()), ("x", slopes.x.to_string())];
                    let text = format!("{left} = {right} at {} ({side} limit)", slopes.x);
                    let found = format!("the left side is {found} and the right side {claimed}");
                    return Err(case.refuted_at_large(at, text, found));
                }
            }
        }
        Ok(())
    }
}

/// L3.8.
fn at_first_knot(k: usize, n: usize, r: usize) -> Vec<Relation> {
    use Slope::{Function, Weight};
    let (d, e) = (k - r, k - r - 1);
    let mut relations = vec![
        Relation { left: Function(d, r), right: vec![(1, Function(e, r + 1)), (-1, Weight(d, r + 1))] },
        Relation { left: Function(d, r + 1), right: vec![(1, Function(e, r + 2)), (1, Weight(d, r + 1))] },
    ];
    relations.extend(
        (2..=n).map(|i| Relation { left: Function(d, r + i), right: vec![(1, Function(e, r + i + 1))] }),
    );
    relations
}

/// L3.9.
fn at_last_knot(k: usize, n: usize, r: usize) -> Vec<Relation> {
    use Slope::{Function, Weight};
    let (d, e) = (k - r, k - r - 1);
    vec![
        Relation { left: Function(d, n), right: vec![(1, Function(e, n)), (1, Weight(d, n))] },
        Relation { left: Function(d, n - 1), right: vec![(1, Function(e, n - 1)), (-1, Weight(d, n))] },
    ]
}

/// All one-sided derivatives of the basis at an end against a formula: slope(k, r, h) for the two functions next
/// to the end (i the nearest one first), 0 for the others. h is the length of the span of the end.
pub(super) fn end_derivatives(
    side: Side,
    only_zeros: bool,
    slope: fn(k: &BigRational, r: &BigRational, h: &BigRational) -> BigRational,
) -> impl Fn(&BasisCase, &mut Ledger) -> Judgement {
    move |case, ledger| {
        let Some(slopes) = EndSlopes::new(case, side) else { return Ok(()) };
        let (knots, k, n) = (case.knots(), case.k(), case.n());
        let (h, nearest, next) = match side {
            Side::Right => (knots.t(k + 1) - knots.first(), 0, 1),
            Side::Left => (knots.last() - knots.t(n), n, n.saturating_sub(1)),
        };
        // Where h = 0 the formula divides by 0; the zeros are claimed all the same.
        let formula = (!h.is_zero()).then(|| slope(&integer(k), case.basis().index().ratio(), &h));
        for i in 0..=n {
            let claimed = match &formula {
                _ if i != nearest && i != next => integer(0),
                Some(formula) if !only_zeros && i == next => {
                    formula * BigRational::from_integer(direction(side).into())
                }
                Some(formula) if !only_zeros => -formula * BigRational::from_integer(direction(side).into()),
                _ => continue,
            };
            let found = slopes.of(Slope::Function(k, i));
            if !ledger.equal(&found, &claimed) {
                let at = [("i", i.to_string()), ("x", slopes.x.to_string())];
                let g = format!("D{}({}) ({side} limit)", name(k, i), slopes.x);
                return Err(case.refuted(at, format!("{g} = {claimed}"), format!("it is {found}")));
            }
        }
        if formula.is_none() && !only_zeros {
            let length = if side == Side::Right { "t_{k+1} − t_0" } else { "t_m − t_n" };
            let claimed = format!("the derivative at {} is a quotient by {length}", slopes.x);
            let found = format!("{length} = 0, while the functions have a derivative there");
            return Err(case.refuted([("x", slopes.x.to_string())], claimed, found));
        }
        Ok(())
    }
}

/// The function next to the nearest one rises away from t_0 and falls towards t_m.
fn direction(side: Side) -> i64 {
    match side {
        Side::Right => 1,
        Side::Left => -1,
    }
}

/// kα/((α − 1)h) = kr/h.
pub(super) fn at_first(k: &BigRational, r: &BigRational, h: &BigRational) -> BigRational {
    k * r / h
}

/// k(α − 1)/(αh) = k/(rh).
pub(super) fn at_last(k: &BigRational, r: &BigRational, h: &BigRational) -> BigRational {
    k / (r * h)
}

/// A rational function without a pole on the closed span has all derivatives inside.
fn smooth_on_spans(case: &BasisCase, ledger: &mut Ledger) -> Judgement {
    for pieces in case.pieces().spans() {
        for (i, g) in pieces.functions.iter() {
            regular(case, pieces, i, g, ledger)?;
        }
    }
    Ok(())
}

/// At every t_j: the difference quotients from the right converge (the value is the limit from the right, and
/// the piece there has a derivative), and those from the left do if and only if the function does not jump. Without
/// `at_jumps`: except at the knots inside (t_0, t_m) of multiplicity > k, where some function jumps.
fn one_sided_differentiable(at_jumps: bool) -> impl Fn(&BasisCase, &mut Ledger) -> Judgement {
    move |case, ledger| {
        smooth_on_spans(case, ledger)?;
        for (x, p) in case.knots().inner_stop_knots() {
            let (left, value) = (case.values(x, Side::Left), case.values(x, Side::Right));
            if !at_jumps && p > case.k() {
                if !left.iter().zip(&value).any(|(left, value)| ledger.differ(left, value)) {
                    let claimed = format!("some function jumps at {x}");
                    return Err(case.refuted([("x", x.to_string())], claimed, "none does".into()));
                }
                continue;
            }
            for (i, (left, value)) in left.iter().zip(&value).enumerate() {
                if !ledger.equal(left, value) {
                    let g = name(case.k(), i);
                    let found = format!(
                        "{g} → {left} from the left and {g}({x}) = {value}: the difference quotients diverge"
                    );
                    let claimed = format!("{g} is differentiable from the left at {x}");
                    return Err(case.refuted_on_the_left(i, x, claimed, found));
                }
            }
        }
        Ok(())
    }
}

/// The derivative of every G_i^k jumps at some knot inside its support.
fn not_continuously_differentiable(case: &BasisCase, ledger: &mut Ledger) -> Judgement {
    for i in 0..=case.n() {
        let jumps = (i + 1..=i + case.k()).any(|j| {
            let slope = |side| case.basis().jets(case.knots().t(j), side, 1)[i].coefficients()[1].clone();
            ledger.differ(&slope(Side::Left), &slope(Side::Right))
        });
        if !jumps {
            let (g, x) = (name(case.k(), i), case.knots().t(i + 1));
            let at = [("i", i.to_string()), ("x", x.to_string())];
            let found = format!("D{g} is the same on both sides of every knot inside its support");
            return Err(case.refuted(at, format!("{g} is not C¹"), found));
        }
    }
    Ok(())
}

/// The jumps of the derivatives of order 0..=order at x, as functions of the slope ratio r.
fn jumps_in_ratio(
    case: &BasisCase,
    x: &BigRational,
    order: usize,
) -> Option<Vec<Vec<RationalFunction<BigRational>>>> {
    let knots = case.knots();
    let ratio = Piece::variable(&integer(1));
    let jets = |side| {
        let span = knots.span_at(x, side)?;
        let point = Jet::variable(ratio.embed(x), order);
        let weights =
            crate::spline::PointWeights::new(knots, Jet::constant(ratio.clone(), order), point.clone());
        let active = crate::spline::triangle(&weights, span, case.k(), knots.m());
        let of = |i: usize| active.get(i).cloned().unwrap_or_else(|| point.zero());
        Some((0..=case.n()).map(of).collect::<Vec<_>>())
    };
    let (left, right) = (jets(Side::Left)?, jets(Side::Right)?);
    Some(left.iter().zip(&right).map(|(l, r)| r.minus(l).derivatives()).collect())
}

/// At a knot inside (t_0, t_m) of multiplicity p ≤ k some derivative of order ≤ k − p jumps for this α if and only if
/// p < k, and all their jumps vanish for r → 1.
fn regularity_lost(case: &BasisCase, ledger: &mut Ledger) -> Judgement {
    for (x, p) in case.knots().inner_stop_knots() {
        let Some(order) = case.k().checked_sub(p) else { continue };
        let Some(jumps) = jumps_in_ratio(case, x, order) else { continue };
        for (i, jump) in jumps.iter().enumerate() {
            for (d, jump) in jump.iter().enumerate() {
                let limit = jump.evaluate(&integer(1));
                if !limit.as_ref().is_some_and(|limit| ledger.equal(limit, &integer(0))) {
                    let at = [("i", i.to_string()), ("x", x.to_string()), ("order", d.to_string())];
                    let claimed = "the jump tends to 0 as α → ∞".to_owned();
                    return Err(case.refuted(at, claimed, format!("it tends to {limit:?}")));
                }
            }
        }
        let ratio = case.basis().index().ratio();
        let some_jump = jumps
            .iter()
            .flatten()
            .any(|jump| jump.evaluate(ratio).is_some_and(|jump| ledger.differ(&jump, &integer(0))));
        if !ledger.count(usize::from(some_jump), usize::from(order > 0)) {
            let at = [("x", x.to_string()), ("p", p.to_string())];
            let words = |jumps: bool| if jumps { "some derivative" } else { "no derivative" };
            let claimed = format!("{} of order ≤ k − p = {order} jumps at {x}", words(order > 0));
            return Err(case.refuted(at, claimed, format!("{} does, for any i", words(some_jump))));
        }
    }
    Ok(())
}

/// |f − Σ f(ξ_i)G_i| ≤ ω(f; (k + 1)h) for every continuous f: since the G_i are ≥ 0 with sum 1, it is enough that
/// on every span each G_i that lives there has its whole support within (k + 1)h.
fn approximation(factor: fn(k: usize) -> usize) -> impl Fn(&BasisCase, &mut Ledger) -> Judgement {
    move |case, ledger| {
        let knots = case.knots();
        let gaps = knots.knots().windows(2).map(|pair| &pair[1] - &pair[0]);
        let widest = gaps.max().unwrap_or_else(|| integer(0));
        let reach = integer(factor(case.k())) * widest;
        for pieces in case.pieces().spans() {
            let sum = pieces.functions.values().iter().fold(case.pieces().zero(), |sum, g| sum.plus(g));
            let convex = pieces.functions.values().iter().all(|g| ledger.positive(g))
                && ledger.equal(&sum, &case.pieces().one());
            if !convex {
                return Err(Stop::Undecided("the functions are no convex combination".into()));
            }
            for (i, _) in pieces.functions.iter() {
                let (low, high) = case.basis().support(i);
                let width = high - low;
                if !(ledger.less(&width, &reach) || ledger.equal(&width, &reach)) {
                    let at = [("i", i.to_string()), ("x", low.to_string())];
                    let claimed =
                        format!("the error is at most ω(f; {reach}), with ξ_{i} anywhere in [{low}, {high}]");
                    let found = format!(
                        "x → {high} and ξ_{i} = {low} are {width} apart: f may change more than that"
                    );
                    return Err(case.refuted(at, claimed, found));
                }
            }
        }
        Ok(())
    }
}

/// The claims on derivatives.
pub(super) fn claims() -> Vec<Claim> {
    let relations = |text, side, relations| Statement::new(text, end_relations(side, relations));
    let first = |text: &'static str| Statement::new(text, end_derivatives(Side::Right, false, at_first));
    let last = |text: &'static str| Statement::new(text, end_derivatives(Side::Left, false, at_last));
    let zeros = |text: &'static str| Statement::new(text, end_derivatives(Side::Left, true, at_last));
    const ONLY_FIRST: &str = "The same if t_k < t_{k+1}: the first knot occurs k + 1 times and no more.";
    const NOT_NEXT: &str = "The same unless the last knot occurs exactly k + 2 times. (If it occurs more often, all terms are 0.)";
    const ONLY_LAST: &str = "The same if t_n < t_{n+1}: the last knot occurs k + 1 times and no more.";
    vec![
        Claim::new(
            "abstract.regularity",
            "Abstract",
            Form::Basis(
                Statement::new(
                    "The classical regularity C^{k−p} at a knot inside (t_0, t_m) of multiplicity p ≤ k−1 is lost: for finite α some derivative of order ≤ k−p of some G_i^k jumps there; as α → ∞ all these jumps tend to 0. (At p = k it is C⁰, and that is kept: nothing jumps.)",
                    regularity_lost,
                )
                .given([FiniteIndex, EnoughKnots]),
            ),
        )
        .note("The abstract says no more than that regularity is lost and comes back; orders and knots are ours. The limit is taken with r as a variable."),
        Claim::new(
            "abstract.approx",
            "Abstract",
            Form::Basis(
                Statement::new(
                    "For f continuous on [t_0,t_m], U open and ξ_i in [t_i,t_{i+k+1}]: |f − Σ f(ξ_i) G_i^k| ≤ ω(f; (k+1)·max(t_{j+1}−t_j)).",
                    approximation(|k| k + 1),
                )
                .given([Open]),
            ),
        )
        .note("Our formalisation. For every f at once: positivity and partition of unity reduce it to the width of the supports."),
        Claim::new(
            "L3.8",
            "Lemma 3.8",
            Form::Basis(
                relations(
                    "Open U, 0 ≤ r ≤ k−1, i ≥ 2, from the right at t_0: DG_r^{k−r} = DG_{r+1}^{k−r−1} − Dw_{r+1}^{k−r}; DG_{r+1}^{k−r} = DG_{r+2}^{k−r−1} + Dw_{r+1}^{k−r}; DG_{r+i}^{k−r} = DG_{r+i+1}^{k−r−1}.",
                    Side::Right,
                    at_first_knot,
                )
                .given([Open]),
            ),
        )
        .fails_by(Cause::EndKnots)
        .amended(Form::Basis(relations(ONLY_FIRST, Side::Right, at_first_knot).given([Open, FirstSpan])))
        .note(STATED_IN_THE_PROOF),
        Claim::new(
            "L3.9",
            "Lemma 3.9",
            Form::Basis(
                relations(
                    "Open U, 0 ≤ r ≤ k−1, from the left at t_m: DG_n^{k−r} = DG_n^{k−r−1} + Dw_n^{k−r}; DG_{n−1}^{k−r} = DG_{n−1}^{k−r−1} − Dw_n^{k−r}.",
                    Side::Left,
                    at_last_knot,
                )
                .given([Open]),
            ),
        )
        .fails_by(Cause::EndKnots)
        .amended(Form::Basis(relations(NOT_NEXT, Side::Left, at_last_knot).given([Open, LastMultiplicityNotDegreePlusTwo])))
        .note(STATED_IN_THE_PROOF),
        Claim::new(
            "L3.10",
            "Lemma 3.10",
            Form::Basis(
                zeros("Open U, k ≥ 2, i ≤ n−2: DG_i^k(t_m) = 0 from the left.").given([Open, DegreeAtLeast(2)]),
            ),
        )
        .fails_by(Cause::EndKnots)
        .amended(Form::Basis(zeros(ONLY_LAST).given([Open, DegreeAtLeast(2), LastSpan])))
        .note(STATED_IN_THE_PROOF),
        Claim::new(
            "T3.11.1",
            "Theorem 3.11 (1)",
            Form::Basis(Statement::new("G_i^k is C^∞ on every (t_j, t_{j+1}) with t_j < t_{j+1}.", smooth_on_spans)),
        ),
        Claim::new(
            "T3.11.2",
            "Theorem 3.11 (2)",
            Form::Basis(Statement::new(
                "For any U, every G_i^k is left and right differentiable at every t_j.",
                one_sided_differentiable(true),
            )),
        )
        .fails_by(Cause::InnerMultiplicity)
        .amended(Form::Basis(Statement::new(
            "For any U, the derivative of every G_i^k has limits from both sides at every t_j, from the right at t_0 and from the left at t_m. These are its one-sided derivatives at t_0, at t_m, and at the knots inside (t_0, t_m) of multiplicity ≤ k; at every knot inside of multiplicity > k some function jumps.",
            one_sided_differentiable(false),
        )))
        .note("Differentiable from the left at x: the difference quotients with the value at x converge. At t_0 only the right side is meant, at t_m only the left one. The proof shows what is meant: the derivative has limits from both sides."),
        Claim::new(
            "T3.11.3a",
            "Theorem 3.11 (3a)",
            Form::Basis(
                first("Open U, from the right at t_0: DG_1^k = −DG_0^k = kα/((α−1)(t_{k+1}−t_0)), and DG_i^k = 0 for 2 ≤ i ≤ n.")
                    .given([Open]),
            ),
        )
        .fails_by(Cause::EndKnots)
        .amended(Form::Basis(first(ONLY_FIRST).given([Open, FirstSpan])))
        .note(STATED_IN_THE_PROOF),
        Claim::new(
            "T3.11.3b",
            "Theorem 3.11 (3b)",
            Form::Basis(
                last("Open U, from the left at t_m: DG_n^k = −DG_{n−1}^k = (α−1)k/(α(t_m−t_n)), and DG_i^k = 0 for i ≤ n−2.")
                    .given([Open]),
            ),
        )
        .fails_by(Cause::EndKnots)
        .amended(Form::Basis(last(ONLY_LAST).given([Open, LastSpan])))
        .note(STATED_IN_THE_PROOF),
        Claim::new(
            "Rem3.1",
            "Remark 3.1",
            Form::Basis(
                Statement::new(
                    "For k > 1 and finite α, on knots that are all simple, no G_i^k is C¹.",
                    not_continuously_differentiable,
                )
                .given([FiniteIndex, DegreeAtLeast(2), SimpleKnots]),
            ),
        )
        .note("Printed as \"not C¹, even when every knot has multiplicity 1\". Judged in the strong sense, for every i: the derivative jumps at a knot inside the support. Without simple knots it can be false: a Bernstein basis has no knot inside."),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::claims::small_cases::refuted;

    #[test]
    fn false_variants_are_refuted() {
        let ends = [Open, FirstSpan, LastSpan];
        let wrong: fn(&_, &_, &_) -> _ = |k, r, h| (k + integer(1)) * r / h;
        assert!(refuted(end_derivatives(Side::Right, false, wrong), ends), "k + 1 for k in T3.11.3a");
        assert!(refuted(end_derivatives(Side::Left, false, at_first), ends), "r for 1/r in T3.11.3b");
        assert!(
            refuted(
                end_relations(Side::Right, |k, n, r| at_first_knot(k, n, r)
                    .split_off(1)
                    .into_iter()
                    .map(|mut relation| {
                        relation.right[0].0 = -1;
                        relation
                    })
                    .collect()),
                ends
            ),
            "a sign in L3.8"
        );
        assert!(
            refuted(
                end_relations(Side::Left, |k, n, r| at_last_knot(k, n, r)
                    .into_iter()
                    .map(|mut relation| {
                        relation.right[1].0 *= -1;
                        relation
                    })
                    .collect()),
                ends
            ),
            "a sign in L3.9"
        );
        assert!(
            refuted(not_continuously_differentiable, [DegreeAtLeast(2), SimpleKnots]),
            "Rem3.1 with α = ∞"
        );
        assert!(refuted(approximation(|k| k), [Open]), "ω(f; k·h)");
        assert!(refuted(one_sided_differentiable(true), []), "differentiable at jumps");
        assert!(refuted(regularity_lost, []), "regularity lost for α = ∞ too");
    }
}
