//! Definitions 3.1 and 3.2: which knot vectors there are. A definition states that what it defines is there.

use super::case::{BasisCase, Case};
use super::cause::Cause;
use super::claim::{Claim, Form};
use super::hypothesis::Hypothesis::{self, BaseInterval, DegreeAtLeast};
use super::illustrations::{Illustration, refuted};
use super::instances::instances;
use super::statement::Statement;
use super::verdict::{Judgement, Ledger};

/// The first knot outside of [t_k, t_{m−k}], by its index.
fn knot_outside(case: &BasisCase) -> Option<usize> {
    let (knots, k) = (case.knots(), case.k());
    let (a, b) = (knots.t(k), knots.t(knots.m() - k));
    knots.knots().iter().position(|t| t < a || t > b)
}

/// Every knot lies in [a, b] with a = t_k, b = t_{m−k}.
fn lies_between(case: &BasisCase, ledger: &mut Ledger) -> Judgement {
    let outside = knot_outside(case);
    if ledger.count(usize::from(outside.is_some()), 0) {
        return Ok(());
    }
    let (knots, k) = (case.knots(), case.k());
    let i = outside.unwrap_or(0);
    let claimed = format!("all knots lie in [a, b] = [t_{k}, t_{}]", knots.m() - k);
    let found =
        format!("t_{i} = {} does not lie in [{}, {}]", knots.t(i), knots.t(k), knots.t(knots.m() - k));
    Err(case.refuted_at_large([("i", i.to_string())], claimed, found))
}

/// They do exactly if the condition holds; in the claim, that U is open.
fn lies_between_exactly_if(condition: Hypothesis) -> impl Fn(&BasisCase, &mut Ledger) -> Judgement {
    move |case, ledger| {
        let (inside, holds) = (knot_outside(case).is_none(), case.meets(&condition));
        if ledger.count(usize::from(inside), usize::from(holds)) {
            return Ok(());
        }
        let word = |holds| if holds { "holds" } else { "does not hold" };
        let claimed = format!("all knots lie in [t_k, t_{{m−k}}] exactly if {condition}");
        let found = format!("the first {}, the second {}", word(inside), word(holds));
        Err(case.refuted_at_large([], claimed, found))
    }
}

/// m ≥ factor·k and t_k < t_{m−k}; the paper's factor is 2.
fn is_node_vector(factor: usize) -> impl Fn(&Illustration, &mut Ledger) -> Judgement {
    move |illustration, ledger| {
        for instance in &illustration.instances {
            let (knots, k) = (&instance.knots, instance.degree);
            let (last, least) = (knots.m() - k, factor * k);
            let enough = ledger.count(knots.m().min(least), least);
            let (a, b) = (knots.t(k), knots.t(last));
            if !(enough && ledger.less(a, b)) {
                let claimed = format!("m ≥ {least} and t_{k} < t_{last}");
                let found = format!("m = {}, t_{k} = {a} and t_{last} = {b}", knots.m());
                return Err(refuted(instance, &[], claimed, found));
            }
        }
        Ok(())
    }
}

/// The examples of the paper, each by itself; without those that are no node vectors by D3.2 if `meeting`.
fn examples(meeting: bool) -> Vec<Illustration> {
    let is_exception = |name: &str, degree: usize| name == "U0" && degree == 3;
    let all = instances().into_iter().filter(|of| !(meeting && is_exception(of.name, of.degree)));
    all.map(|instance| Illustration { instances: vec![instance] }).collect()
}

/// The stop knots rise, each has its multiplicity, and Σ p_i = m + 1 + excess; the claim's excess is 0.
fn multiplicities_add_up(excess: usize) -> impl Fn(&BasisCase, &mut Ledger) -> Judgement {
    move |case, ledger| {
        let knots = case.knots();
        let stops: Vec<_> = knots.stop_knots().collect();
        let rise = stops.windows(2).all(|pair| ledger.less(pair[0].0, pair[1].0));
        let counted = stops.iter().all(|(u, p)| ledger.count(*p, knots.multiplicity(u)));
        let sum = stops.iter().map(|(_, p)| p).sum();
        if rise && counted && ledger.count(sum, knots.m() + 1 + excess) {
            return Ok(());
        }
        let list: Vec<_> = stops.iter().map(|(u, p)| format!("{u} ({p} times)")).collect();
        let claimed = format!("the multiplicities of the stop knots have the sum {}", knots.m() + 1 + excess);
        Err(case.refuted_at_large([], claimed, format!("they are {}", list.join(", "))))
    }
}

/// The claims that the definitions make.
pub(super) fn claims() -> Vec<Claim> {
    vec![
        Claim::new(
            "D3.1.interval",
            "Definitions 3.1 and 3.2 (2)",
            Form::Basis(
                Statement::new(
                    "A node vector U lies in [a,b], with a = t_k and b = t_{m−k} for the degree k, whether it is open or periodic.",
                    lies_between,
                )
                .given([BaseInterval, DegreeAtLeast(1)]),
            ),
        )
        .amended(Form::Basis(
            Statement::new(
                "U lies in [t_k, t_{m−k}] exactly if it is open. A periodic U has knots outside of [a,b], so that Definition 3.1 has to let it leave [a,b].",
                lies_between_exactly_if(Hypothesis::Open),
            )
            .given([BaseInterval, DegreeAtLeast(1)]),
        ))
        .fails_by(Cause::EndPoints)
        .note("D3.1 puts all of U into [a,b], D3.2 sets a = t_k and b = t_{m−k}: together they force t_0 = … = t_k and t_{m−k} = … = t_m, and nothing is left of D3.2's \"otherwise U is said to be periodic\"."),
        Claim::new(
            "D3.2.examples",
            "Definition 3.2; Fig. 7",
            Form::illustrated(
                "The knot vectors of the illustrations are node vectors for their degrees: m ≥ 2k and a = t_k < t_{m−k} = b.",
                examples(false),
                is_node_vector(2),
            ),
        )
        .amended(Form::illustrated(
            "All of them are, but for U0 with k = 3 (Fig. 7).",
            examples(true),
            is_node_vector(2),
        ))
        .fails_by(Cause::EndPoints)
        .note("U0 with k = 3 has m = 2k and a = b = 3: no interior nodes, and an empty parametrization space. The recursion of D3.3 makes sense there all the same."),
        Claim::new(
            "D3.2.stop",
            "Definition 3.2 (5)",
            Form::Basis(Statement::new(
                "The stop knots u_0 < … < u_r of U have multiplicities with Σ p_i = m+1.",
                multiplicities_add_up(0),
            )),
        )
        .note("The multiplicity of a knot is read as how often it occurs in U."),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::claims::illustrations::refutes;
    use crate::claims::small_cases::refuted;

    #[test]
    fn false_variants_are_refuted() {
        assert!(refuted(multiplicities_add_up(1), []), "Σ p = m + 2");
        assert!(refuted(lies_between, [DegreeAtLeast(2)]), "also for k ≥ 2");
        assert!(!refuted(lies_between, [Hypothesis::Open]), "an open one does");
        assert!(
            refuted(lies_between_exactly_if(Hypothesis::Symmetric), [BaseInterval]),
            "if it is symmetric"
        );
        assert!(refutes(examples(false), is_node_vector(2)), "U0 in degree 3");
        assert!(refutes(examples(true), is_node_vector(3)), "m ≥ 3k");
        assert!(examples(false).len() == examples(true).len() + 1, "only U0 in degree 3 is left out");
    }
}
