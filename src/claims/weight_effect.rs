//! How far the weight is from the classical one: the last sentence of Illustration 2.1.

use crate::analysis::{Enclosure, Piece, coordinate_between, supremum};
use crate::scalar::{BigRational, RationalAlgebra, RationalFunction, Ring, integer, rational};
use crate::spline::weight;

use super::case::{Case, Origin, WeightCase};
use super::claim::{Claim, Form};
use super::hypothesis::WeightHypothesis::{FiniteIndex, Proper};
use super::statement::Statement;
use super::verdict::{Judgement, Ledger, Stop, Witness};

/// The largest difference as a function of s = √r or, for r < 1, of s = √(1/r).
type Bound = fn(s: &Piece) -> Option<Piece>;

/// (s − 1)/(s + 1).
fn of_the_claim(s: &Piece) -> Option<Piece> {
    s.minus(&s.one()).over(&s.plus(&s.one()))
}

/// The largest |φ_α − φ_∞| is bound(√r), taken at one x only; it rises strictly, from 0 for r = 1, to 1.
fn largest_difference(bound: Bound) -> impl Fn(&WeightCase, &mut Ledger) -> Judgement {
    move |case, ledger| {
        let failed = |claimed: &str, found: String| {
            let given = vec![
                ("α".to_owned(), case.index.to_string()),
                ("a".to_owned(), case.a.to_string()),
                ("b".to_owned(), case.b.to_string()),
            ];
            Stop::Refuted(Box::new(Witness { given, claimed: claimed.to_owned(), found, reproduce: None }))
        };
        let s = Piece::variable(&integer(1));
        let Some(bound) = bound(&s) else { return Err(Stop::Fault("the bound has no value".into())) };

        // In this case: an enclosure of the one meets an enclosure of the other.
        let Enclosure { lo, hi, .. } = enclosed_difference(case)?;
        let [least, most] = square_root(case.index.ratio()).map(|s| bound.evaluate(&s));
        let meets = least.zip(most).is_some_and(|(least, most)| least <= hi && lo <= most);
        if !ledger.count(usize::from(meets), 1) {
            let found =
                format!("the largest difference lies in [{lo}, {hi}], and the function of r does not");
            return Err(failed("the largest difference is the given function of r", found));
        }

        // For every s and every x at once: r = s², and v = s·u is a variable. For r < 1 the difference is the mirror
        // image of the one for 1/r.
        let v = RationalFunction::variable(&s);
        let (s_plus, one) = (RationalFunction::constant(s.clone()), v.one());
        let sv = s_plus.times(&v);
        let difference = sv
            .over(&one.plus(&sv))
            .zip(v.over(&s_plus.plus(&v)))
            .map(|(weight, classical)| weight.minus(&classical));
        let Some(difference) = difference else { return Err(Stop::Fault("a denominator is 0".into())) };
        let rest = RationalFunction::constant(bound.clone()).minus(&difference);
        // s(s − 1)(1 − v)²/((s + 1)(1 + sv)(s + v)): for s > 1 it is 0 for v = 1 and positive for every other v > 0.
        let square = one.minus(&v).power(2).times(&RationalFunction::constant(s.times(&s.minus(&s.one()))));
        let factors =
            RationalFunction::constant(s.plus(&s.one())).times(&one.plus(&sv)).times(&s_plus.plus(&v));
        if !square.over(&factors).is_some_and(|square| ledger.equal(&rest, &square)) {
            let claimed =
                "the bound less φ_α − φ_∞ is s(s − 1)(1 − v)²/((s + 1)(1 + sv)(s + v)), s² = r, v = su";
            return Err(failed(claimed, "it is not".into()));
        }
        let rises = ledger.positive(&bound.derivative())
            && bound.evaluate(&integer(1)).is_some_and(|start| ledger.equal(&start, &integer(0)))
            && bound.at_infinity().is_some_and(|limit| ledger.equal(&limit, &integer(1)));
        if !rises {
            return Err(failed("the bound rises strictly from 0 to 1", "it does not".into()));
        }
        if case.origin() == Origin::Paper {
            ledger.remark(format!(
                "[{}, {}], α = {}: the largest difference lies in [{lo}, {hi}].",
                case.a, case.b, case.index
            ));
        }
        Ok(())
    }
}

/// The largest |φ_α − φ_∞| on the interval of the case.
fn enclosed_difference(case: &WeightCase) -> Result<Enclosure, Stop> {
    let x = coordinate_between(&case.a, &case.b);
    let [weight, classical] = [case.index.ratio().clone(), integer(1)]
        .map(|ratio| weight(&x.embed(&ratio), &x, &case.a, &case.b).0);
    let difference = weight.minus(&classical);
    let both = [difference.clone(), difference.negate()];
    supremum(&both, &rational(1, 1_000_000)).map_err(|error| Stop::Fault(error.to_string()))
}

/// low ≤ √r ≤ high, or the same for √(1/r) if r < 1.
fn square_root(ratio: &BigRational) -> [BigRational; 2] {
    /// Each step halves the distance of the two.
    const STEPS: usize = 24;
    let one = integer(1);
    let square = ratio.reciprocal().filter(|inverse| *inverse > one).unwrap_or_else(|| ratio.clone());
    let (mut low, mut high) = (one.clone(), square.clone());
    for _ in 0..STEPS {
        let middle = (&low + &high) / integer(2);
        if &middle * &middle < square { low = middle } else { high = middle }
    }
    [low, high]
}

/// The claim on the effect of α.
pub(super) fn claims() -> Vec<Claim> {
    vec![
        Claim::new(
            "Ill2.1.crucial",
            "Illustration 2.1",
            Form::Weight(
                Statement::new(
                    "The effect of α on φ_α is crucial in the neighbourhood of 0 and of 1: for a < b the largest |φ_α(x,a,b) − φ_∞(x,a,b)| is |√r − 1|/(√r + 1), r = α/(α−1), taken at one x only; it rises strictly to 1 as α rises to 0 and as α falls to 1.",
                    largest_difference(of_the_claim),
                )
                .given([Proper, FiniteIndex]),
            ),
        )
        .note("Our reading of \"crucial\". Judged for every r and every x at once, with √r as a variable, and by enclosures for the indices of the cases. As α rises in (−∞, 0), r falls from 1 to 0; as α falls in (1, ∞), r rises from 1 to ∞."),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::claims::small_cases::Cases;
    use crate::claims::statement::judge;
    use crate::claims::verdict::Verdict;

    fn verdict(bound: Bound) -> Verdict {
        let statement = Statement::new("", largest_difference(bound)).given([Proper, FiniteIndex]);
        judge(&statement, &Cases::all().weights).unwrap()
    }

    #[test]
    fn another_bound_is_refuted() {
        assert!(matches!(verdict(of_the_claim), Verdict::Proved { .. }));
        // (r − 1)/(r + 1), without the roots; and one that is off by 1/1000.
        let without_roots: Bound = |s| of_the_claim(&s.times(s));
        let nearly: Bound = |s| of_the_claim(s).map(|bound| bound.plus(&s.embed(&rational(1, 1000))));
        for bound in [without_roots, nearly] {
            let verdict = verdict(bound);
            assert!(
                matches!(&verdict, Verdict::Refuted(witness) if witness.found.contains("lies in")),
                "{verdict:?}"
            );
        }
        // Never taken at another place: the identity alone refutes a bound that enclosures don't tell apart.
        let too_close: Bound =
            |s| of_the_claim(s).map(|bound| bound.plus(&s.embed(&rational(1, 1_000_000_000))));
        let verdict = verdict(too_close);
        assert!(
            matches!(&verdict, Verdict::Refuted(witness) if witness.claimed.contains("v = su")),
            "{verdict:?}"
        );
    }
}
