//! What rests on what in the paper: where its proofs use a statement that fails as it is printed.

/// A claim that the paper derives from another one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Use {
    /// The conclusion.
    pub claim: &'static str,
    /// What its proof uses.
    pub rests_on: &'static str,
    /// What survives where the premise fails as printed, and why; `None` if nothing does.
    pub survives: Option<&'static str>,
}

const fn survives(claim: &'static str, rests_on: &'static str, why: &'static str) -> Use {
    Use { claim, rests_on, survives: Some(why) }
}

const FACTOR: &str = "where the premise fails, the function that it multiplies is 0";
const ON_BASE: &str = "U is open and x in [t_k, t_{n+1}]: there the sum is 1";
const END_KNOTS: &str = "both hold if the end knots occur exactly k + 1 times";
const SAME_END: &str = "both are wrong at the same end points, and right elsewhere";

/// Every use of a claim that is refuted as printed, in the order of the paper.
///
/// That the conclusion stands all the same is not believed because it is written here: it has a verdict of its own. This
/// list says which of its proofs have to be looked at again, and what is seen there.
pub const USES: &[Use] = &[
    survives("C2.4", "P2.1.3", "it is the case T(x) = a + b − x; both hold for x inside of the interval"),
    survives("T3.5.4", "C2.4", FACTOR),
    survives("P4.3", "T3.5.4", "the curve inherits what is true of the basis: at knots of multiplicity ≤ k"),
    survives("T3.5.2", "proof.T3.5.2.cover", "at the point that the union misses, G_{i+1}^{k−1} is 1"),
    survives("P3.1.3", "T3.5.3", ON_BASE),
    survives("P4.1.3", "T3.5.3", ON_BASE),
    survives("P4.1.4", "T3.5.3", ON_BASE),
    survives("P4.1.1", "T3.5.1", SAME_END),
    survives("P4.1.1", "proof.P4.1.1.iff", "only ⇒ is needed"),
    survives("T3.11.3a", "L3.8", END_KNOTS),
    survives("T3.11.3b", "L3.9", END_KNOTS),
    survives("T3.11.3b", "L3.10", END_KNOTS),
    survives("P4.2.1", "P3.1.3", END_KNOTS),
    survives("P4.2.2", "T3.11.3a", END_KNOTS),
    survives("P4.2.2", "T3.11.3b", END_KNOTS),
    survives("P3.2", "proof.P3.2.induction", "orders at the first knot of a span take the place of the step"),
    survives(
        "Rem5.1.conj",
        "Conj3.1.strong",
        "a remark on pictures; Illustration 5.2 says no more than that its figures seem to confirm it",
    ),
];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::claims::claims;

    #[test]
    fn both_sides_are_claims_and_what_fails_is_never_used_in_a_circle() {
        let all = claims();
        let known = |id: &str| all.iter().position(|claim| claim.id == id);
        for one in USES {
            assert!(known(one.claim).is_some() && known(one.rests_on).is_some(), "{one:?}");
            assert!(
                all[known(one.rests_on).expect("a claim")].cause.is_some(),
                "{one:?}: the premise does not fail"
            );
        }
        // Every chain ends.
        for start in USES {
            let (mut reached, mut steps) = (vec![start.claim], 0);
            while let Some(claim) = reached.pop() {
                steps += 1;
                assert!(steps < 1000, "{} rests on itself", start.claim);
                reached.extend(USES.iter().filter(|one| one.claim == claim).map(|one| one.rests_on));
            }
        }
    }
}
