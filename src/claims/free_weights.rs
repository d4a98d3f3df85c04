//! What does not depend on the weights at all: an index of its own for every knot, every interval, every weight.

use num_bigint::BigInt;

use crate::scalar::{Monomial, Multivariate, Ring};
use crate::spline::{Active, Span, Weights, triangle};

use super::basis::name;
use super::case::BasisCase;
use super::claim::{Claim, Form};
use super::hypothesis::Hypothesis::DegreeAtLeast;
use super::statement::Statement;
use super::verdict::{Judgement, Ledger, Stop};

/// Weights w_i^d on a span as variables; their complements are variables too, or 1 − w.
struct Free {
    span: Span,
    related: bool,
}

impl Weights for Free {
    type Scalar = Multivariate;

    fn one(&self) -> Multivariate {
        Multivariate::constant(1)
    }

    fn pair(&self, i: usize, d: usize) -> (Multivariate, Multivariate) {
        // Those of degree d belong to intervals that contain the span: i = j − d + 1, …, j.
        let number = d * (d - 1) / 2 + self.span.index() - i;
        let w = Multivariate::variable(2 * number);
        let complement =
            if self.related { self.one().minus(&w) } else { Multivariate::variable(2 * number + 1) };
        (w, complement)
    }
}

/// The functions that live on a span, as polynomials in free weights.
fn free(case: &BasisCase, span: Span, related: bool) -> Result<Active<Multivariate>, Stop> {
    let k = case.k();
    // Two variables for each of the k(k + 1)/2 weights of a span.
    if k * (k + 1) > Monomial::VARIABLES {
        return Err(Stop::Undecided(format!(
            "the polynomials have room for {} variables",
            Monomial::VARIABLES
        )));
    }
    Ok(triangle(&Free { span, related }, span, k, case.knots().m()))
}

/// As polynomials in the weights and their complements, or in the weights alone, which is the false variant, all functions of a
/// span have positive coefficients.
fn positive(related: bool) -> impl Fn(&BasisCase, &mut Ledger) -> Judgement {
    move |case, ledger| {
        for pieces in case.pieces().spans() {
            let functions = free(case, pieces.span, related)?;
            for (i, g) in functions.iter() {
                let positive = !g.is_zero() && g.terms().all(|(_, c)| *c > BigInt::ZERO);
                if !ledger.count(usize::from(positive), 1) {
                    let (start, end) = case.knots().ends(pieces.span);
                    let at = [("i", i.to_string()), ("span", format!("[{start}, {end})"))];
                    let claimed = format!("{} is a sum of products, without a minus", name(case.k(), i));
                    return Err(case.refuted_at_large(at, claimed, "a product has a minus".into()));
                }
            }
        }
        Ok(())
    }
}

/// The sum of all functions is 1 as a polynomial in the weights, on [t_k, t_{n+1}], or `everywhere`, which is the false variant.
fn sums_to_one(everywhere: bool) -> impl Fn(&BasisCase, &mut Ledger) -> Judgement {
    move |case, ledger| {
        let one = Multivariate::constant(1);
        let base = case.k()..=case.n();
        for pieces in case.pieces().spans() {
            if !everywhere && !base.contains(&pieces.span.index()) {
                continue;
            }
            let functions = free(case, pieces.span, true)?;
            let sum = functions.values().iter().fold(one.zero(), |sum, g| sum.plus(g));
            if !ledger.count(usize::from(sum == one), 1) {
                let (start, end) = case.knots().ends(pieces.span);
                let at = [("span", format!("[{start}, {end})"))];
                return Err(case.refuted_at_large(
                    at,
                    "the sum is 1".into(),
                    "it depends on the weights".into(),
                ));
            }
        }
        Ok(())
    }
}

/// The claim about free weights.
pub(super) fn claims() -> Vec<Claim> {
    vec![
        Claim::new(
            "X.weights",
            "not in the paper",
            Form::Basis(
                Statement::new(
                    "With an index α of its own for every weight w_i^d (so also for every knot, or every interval) the functions G_i^k are positive inside of their supports and 0 outside, and their sum on [t_k, t_{n+1}] is 1: curves keep to the convex hulls of their control points.",
                    |case, ledger| {
                        positive(false)(case, ledger)?;
                        sums_to_one(false)(case, ledger)
                    },
                )
                .given([DegreeAtLeast(1)]),
            ),
        )
        .note("The weights are taken as variables, and so are their complements: nothing else of φ is used but that both are positive inside of the interval, with sum 1."),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::claims::small_cases::refuted;

    #[test]
    fn false_variants_are_refuted() {
        assert!(refuted(positive(true), [DegreeAtLeast(1)]), "1 − w has a minus");
        assert!(refuted(sums_to_one(true), [DegreeAtLeast(1)]), "functions are missing outside");
    }
}
