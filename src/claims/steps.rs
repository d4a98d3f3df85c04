//! Steps inside the paper's proofs that can be checked on their own.

use crate::scalar::{Ring, integer};

use super::basis::{local_support, name, positivity};
use super::case::BasisCase;
use super::cause::Cause;
use super::claim::{Claim, Form};
use super::hypothesis::Hypothesis::{DegreeAtLeast, InteriorMultiplicityAtMostDegree, Open};
use super::independence::independence;
use super::statement::Statement;
use super::verdict::{Judgement, Ledger, Stop};

/// (t_i, t_{i+k}) ∪ (t_{i+1}, t_{i+k+1}) = (t_i, t_{i+k+1}) for every i; `all_i`: also where
/// t_i < t_{i+1} = t_{i+k} < t_{i+k+1}, and for k = 1 where t_i < t_{i+1} < t_{i+2}.
fn cover(all_i: bool) -> impl Fn(&BasisCase, &mut Ledger) -> Judgement {
    move |case, ledger| {
        let (knots, k) = (case.knots(), case.k());
        for i in 0..=case.n() {
            let (low, x, high) = (knots.t(i), knots.t(i + 1), knots.t(i + k + 1));
            // The union misses a point of the whole if and only if the first interval ends where, or before,
            // the second begins, and that is inside.
            let inside = low < x && x < high;
            let missed = inside && knots.t(i + k) <= x;
            if missed && !all_i {
                // The first interval ends at x, where the second begins: x is missed, and nothing else.
                if ledger.equal(knots.t(i + k), x) {
                    continue;
                }
                return Err(Stop::Fault("t_{i+1} > t_{i+k}".into()));
            }
            let at_end = ledger.equal(x, low) || ledger.equal(x, high);
            let covered = at_end || ledger.less(x, knots.t(i + k));
            if !covered {
                let at = [("i", i.to_string()), ("x", x.to_string())];
                let claimed = format!("{x}, a point of ({low}, {high}), lies in one of the two intervals");
                let found = format!("they are ({low}, {}) and ({x}, {high})", knots.t(i + k));
                return Err(case.refuted_at_large(at, claimed, found));
            }
        }
        Ok(())
    }
}

/// G_j^k(x) ≠ 0 ⇔ x in (t_j, t_{j+k+1}): positivity and local support together.
fn support_exactly(exceptions: bool) -> impl Fn(&BasisCase, &mut Ledger) -> Judgement {
    move |case, ledger| {
        local_support(exceptions)(case, ledger)?;
        positivity(integer(0))(case, ledger)
    }
}

/// From Σ c_i(x) G_i^q(x) = 0 with functions c_i, each c_i vanishes where G_i^q > 0. Where two neighbours live
/// on one span, c_i = G_{i+1} and c_{i+1} = −G_i refute it.
fn functions_as_coefficients(case: &BasisCase, ledger: &mut Ledger) -> Judgement {
    independence(case, ledger)?;
    for pieces in case.pieces().spans() {
        let mut living = pieces.functions.iter().filter(|(_, g)| !g.is_zero());
        if let (Some((i, g)), Some((j, h))) = (living.next(), living.next()) {
            let sum = h.times(g).plus(&g.negate().times(h));
            if ledger.equal(&sum, &case.pieces().zero()) {
                let (first, second) = (name(case.k(), i), name(case.k(), j));
                let (start, end) = pieces.ends();
                let at = [("i", i.to_string()), ("x", ((start + end) / integer(2)).to_string())];
                let claimed = format!("c_{i} vanishes where {first} > 0");
                let found = format!(
                    "c_{i} = {second}, c_{j} = −{first}, all others 0 are continuous and rational on each span, Σ c {} = 0, and c_{i} > 0 on ({start}, {end})",
                    name(case.k(), 0).replace("_0", "")
                );
                return Err(case.refuted_at_large(at, claimed, found));
            }
        }
    }
    Ok(())
}

/// At the first knot t_j of every span, a function that begins there, with q of its knots at t_j, has the order
/// k + 1 − q + more; the claim has 0 for `more`. So those that begin at one knot have different orders.
fn orders(more: usize) -> impl Fn(&BasisCase, &mut Ledger) -> Judgement {
    move |case, ledger| {
        let (knots, k) = (case.knots(), case.k());
        for pieces in case.pieces().spans() {
            let j = pieces.span.index();
            for (i, g) in pieces.functions.iter().filter(|(i, _)| knots.t(*i) == knots.t(j)) {
                let order = g.numerator().coefficients().iter().take_while(|c| c.is_zero()).count();
                // No pole at t_j: the order of the quotient is that of its numerator.
                let regular = g.evaluate(&integer(0)).is_some();
                let q = j - i + 1;
                if !(regular && ledger.count(order, k + 1 - q + more)) {
                    let at = [("i", i.to_string()), ("x", knots.t(j).to_string())];
                    let claimed = format!("{} has the order {} there", name(k, i), k + 1 - q + more);
                    return Err(case.refuted_at_large(at, claimed, format!("it has the order {order}")));
                }
            }
        }
        Ok(())
    }
}

/// The claims on steps.
pub(super) fn claims() -> Vec<Claim> {
    vec![
        Claim::new(
            "proof.T3.5.2.cover",
            "Proof of Theorem 3.5 (2)",
            Form::Basis(
                Statement::new(
                    "(t_i, t_{i+k}) ∪ (t_{i+1}, t_{i+k+1}) = (t_i, t_{i+k+1}) for k ≥ 1.",
                    cover(true),
                )
                .given([DegreeAtLeast(1)]),
            ),
        )
        .fails_by(Cause::ProofStep)
        .amended(Form::Basis(
            Statement::new(
                "The same unless t_i < t_{i+1} = t_{i+k} < t_{i+k+1}; then the union misses exactly the point t_{i+1}.",
                cover(false),
            )
            .given([DegreeAtLeast(1)]),
        ))
        .note("The theorem survives: at a missed point G_{i+1}^{k−1} is 1."),
        Claim::new(
            "proof.P4.1.1.iff",
            "Proof of Proposition 4.1 (1)",
            Form::Basis(Statement::new("G_j^k(x) ≠ 0 ⇔ x in (t_j, t_{j+k+1}).", support_exactly(false))),
        )
        .fails_by(Cause::EndPoints)
        .amended(Form::Basis(Statement::new(
            "G_j^k(x) ≠ 0 for x in (t_j, t_{j+k+1}), and only for x in [t_j, t_{j+k+1}]. At the ends of that it is 0, with two exceptions, where it is 1: x = t_j if t_j = t_{j+k} < t_{j+k+1}, and x = t_m if t_j < t_{j+1} = t_m.",
            support_exactly(true),
        )))
        .note("The proof needs the first sentence only."),
        Claim::new(
            "proof.P3.2.induction",
            "Proof of Proposition 3.2",
            Form::Basis(
                Statement::new(
                    "If the G_i^q (q = k−1) are linearly independent and Σ c_i(x) G_i^q(x) = 0 for all x, with functions c_i (rational on each span, continuous), then each c_i vanishes wherever G_i^q > 0.",
                    functions_as_coefficients,
                )
                .given([Open, InteriorMultiplicityAtMostDegree]),
            ),
        )
        .fails_by(Cause::ProofStep)
        .amended(Form::Basis(
            Statement::new(
                "Repaired, with constants c_i and the functions of one degree k only: at the first knot of a span the functions that begin there have different orders, k + 1 − q for the one that has q of its knots there, 1 ≤ q ≤ k + 1. So if Σ c_i G_i^k = 0 and the functions that began earlier have c_i = 0, those that begin there have c_i = 0 as well: from span to span.",
                orders(0),
            )
            .given([Open, InteriorMultiplicityAtMostDegree]),
        ))
        .note("The case's degree is the q of the step. Proposition 3.2 is true all the same; only this way of proving it is not. With the repaired step it needs no induction over the degree."),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::claims::case::{BasisCase, Origin};
    use crate::claims::small_cases::refuted;
    use crate::claims::statement::judge;
    use crate::claims::verdict::Verdict;
    use crate::spline::{Basis, Index, KnotVector};

    #[test]
    fn the_cover_and_the_support_are_refuted_without_their_exceptions() {
        assert!(refuted(cover(true), [DegreeAtLeast(2)]), "also for k ≥ 2");
        assert!(refuted(support_exactly(false), [Open]));
        assert!(!refuted(support_exactly(true), [Open]));
    }

    #[test]
    fn another_order_is_refuted() {
        assert!(refuted(orders(1), [Open]));
    }

    #[test]
    fn the_inference_holds_in_degree_0_and_fails_in_degree_1() {
        let case = |degree, knots: &[usize]| {
            let knots = KnotVector::new(knots.iter().copied().map(integer).collect()).unwrap();
            BasisCase::new(Basis::new(knots, degree, Index::infinity()).unwrap(), Origin::User)
        };
        let statement =
            Statement::new("", functions_as_coefficients).given([crate::claims::Hypothesis::DegreeAtMost(1)]);
        let holds = judge(&statement, &[case(0, &[0, 1, 2])]).unwrap();
        assert!(matches!(holds, Verdict::Proved { .. }), "{holds:?}");
        let fails = judge(&statement, &[case(1, &[0, 0, 1, 1])]).unwrap();
        assert!(matches!(fails, Verdict::Refuted(_)), "{fails:?}");
    }
}
