//! The range of the index in the recursion of Theorem 4.1.

use crate::spline::{PointWeights, de_boor};

use super::case::BasisCase;
use super::cause::Cause;
use super::claim::{Claim, Form};
use super::curve::de_boor_algorithm;
use super::hypothesis::Hypothesis::{DegreeAtLeast, Open};
use super::statement::Statement;
use super::verdict::{Judgement, Ledger, Stop};

/// Every d_i^{r+1} with j−k+r+lag ≤ i ≤ j is made of two points that the level r has, and these are all points of the
/// level r + 1. The paper's lag is 0; 1 is right.
fn range(lag: usize) -> impl Fn(&BasisCase, &mut Ledger) -> Judgement {
    move |case, ledger| {
        let k = case.k();
        let ratio = crate::analysis::constant(case.basis().index().ratio().clone());
        for pieces in case.pieces().spans() {
            let j = pieces.span.index();
            if !(k..=case.n()).contains(&j) {
                continue;
            }
            // The points themselves don't matter here.
            let points = vec![vec![case.pieces().one()]; k + 1];
            let weights = PointWeights::new(case.knots(), ratio.clone(), pieces.x.clone());
            let fault = || Stop::Fault(format!("de Boor's algorithm does not run on the span {j}"));
            let levels = de_boor(&weights, pieces.span, &points).ok_or_else(fault)?;
            for (r, pair) in levels.windows(2).enumerate() {
                let [level, next] = pair else { continue };
                for i in j - k + r + lag..=j {
                    let there = i.checked_sub(1).is_some_and(|before| level.get(before).is_some());
                    if !ledger.count(usize::from(there && level.get(i).is_some()), 1) {
                        let at = [("j", j.to_string()), ("r", r.to_string()), ("i", i.to_string())];
                        let before =
                            i.checked_sub(1).map_or_else(|| "−1".to_owned(), |before| before.to_string());
                        let claimed = format!("d_{i}^{} is made of d_{i}^{r} and d_{before}^{r}", r + 1);
                        let first = j - k + r;
                        let found = format!("the points of level {r} are d_{first}^{r}, …, d_{j}^{r}");
                        return Err(case.refuted_at_large(at, claimed, found));
                    }
                }
                let known: Vec<_> = next.iter().map(|(i, _)| i).collect();
                if known != (j - k + r + lag..=j).collect::<Vec<_>>() {
                    let at = [("j", j.to_string()), ("r", r.to_string())];
                    let claimed = format!("the recursion gives all points of level {}", r + 1);
                    let found = format!("they begin with i = {}", known.first().copied().unwrap_or_default());
                    return Err(case.refuted_at_large(at, claimed, found));
                }
            }
        }
        Ok(())
    }
}

/// The range, and that with it the algorithm gives the curve.
fn range_that_suffices(case: &BasisCase, ledger: &mut Ledger) -> Judgement {
    range(1)(case, ledger)?;
    de_boor_algorithm(|pair| pair)(case, ledger)
}

/// The claim.
pub(super) fn claims() -> Vec<Claim> {
    vec![
        Claim::new(
            "T4.1.range",
            "Theorem 4.1",
            Form::Basis(
                Statement::new(
                    "In de Boor's algorithm d_i^{r+1} is made of d_i^r and d_{i−1}^r for r = 0, …, k−1 and i = j−k+r, …, j.",
                    range(0),
                )
                .given([Open, DegreeAtLeast(1)]),
            ),
        )
        .amended(Form::Basis(
            Statement::new(
                "The same for i = j−k+r+1, …, j: these points are all that the sum of the next level takes.",
                range_that_suffices,
            )
            .given([Open, DegreeAtLeast(1)]),
        ))
        .fails_by(Cause::IndexRange)
        .note("Off by one: for j = k, r = 0, i = 0 the printed range asks for d_{−1}, which does not exist."),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::claims::small_cases::refuted;

    #[test]
    fn false_variants_are_refuted() {
        assert!(refuted(range(2), [Open, DegreeAtLeast(2)]), "a point is left out");
        assert!(refuted(range(0), [Open, DegreeAtLeast(3)]), "as printed, in every degree");
        assert!(!refuted(range(1), [Open, DegreeAtLeast(1)]));
    }
}
