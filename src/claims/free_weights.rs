//! What does not depend on the weights at all: an index of its own for every knot, every interval, every weight.

use num_bigint::BigInt;

use crate::scalar::{Monomial, Multivariate, Ring};
use crate::spline::{Active, Span, Triangle, Weights};

use super::basis::name;
use super::case::BasisCase;
use super::claim::{Claim, Form};
use super::hypothesis::Hypothesis::DegreeAtLeast;
use super::statement::Statement;
use super::verdict::{Judgement, Ledger, Stop};

/// The weights w_i^d of one degree on a span as variables; their complements are variables too, or 1 − w.
struct Free {
    span: Span,
    related: bool,
}

/// Of the i-th function of a degree, its weight and the complement of that.
const FUNCTION: usize = 0;
const WEIGHT: usize = 1;
const COMPLEMENT: usize = 2;

/// i counts from the last function that lives on the span backwards.
fn variable(i: usize, of: usize) -> Multivariate {
    Multivariate::variable(3 * i + of)
}

impl Weights for Free {
    type Scalar = Multivariate;

    fn one(&self) -> Multivariate {
        Multivariate::constant(1)
    }

    fn pair(&self, i: usize, _: usize) -> (Multivariate, Multivariate) {
        let from_last = self.span.index() - i;
        let w = variable(from_last, WEIGHT);
        let complement = if self.related { self.one().minus(&w) } else { variable(from_last, COMPLEMENT) };
        (w, complement)
    }
}

/// The functions of two degrees that live on a span.
struct Level {
    /// Those of the lower one, as variables.
    before: Active<Multivariate>,
    /// Those of the next one, as polynomials in these and in free weights.
    after: Active<Multivariate>,
}

/// From degree 0 to 1, …, from k − 1 to k.
fn levels(case: &BasisCase, span: Span, related: bool) -> Result<Vec<Level>, Stop> {
    let (k, m) = (case.k(), case.knots().m());
    if 3 * (k + 1) > Monomial::VARIABLES {
        return Err(Stop::Undecided(format!(
            "the polynomials have room for {} variables",
            Monomial::VARIABLES
        )));
    }
    let one = Multivariate::constant(1);
    let mut first = span.index();
    let mut count = 1;
    let mut levels = Vec::with_capacity(k);
    for d in 1..=k {
        let unknowns = (first..first + count).map(|i| variable(span.index() - i, FUNCTION)).collect();
        let before = Active::new(first, unknowns);
        let mut triangle = Triangle::starting_with(before.clone(), &one);
        triangle.raise(&Free { span, related }, span, d, m);
        let after = triangle.into_active();
        (first, count) = (after.first(), after.values().len());
        levels.push(Level { before, after });
    }
    Ok(levels)
}

/// As polynomials in the functions of the degree before, the weights and their complements, or without complements, which is the
/// false variant, all functions of a span have positive coefficients: by induction they are positive.
fn positive(related: bool) -> impl Fn(&BasisCase, &mut Ledger) -> Judgement {
    move |case, ledger| {
        for pieces in case.pieces().spans() {
            for (d, Level { after, .. }) in (1..).zip(levels(case, pieces.span, related)?) {
                for (i, g) in after.iter() {
                    let positive = !g.is_zero() && g.terms().all(|(_, c)| *c > BigInt::ZERO);
                    if !ledger.count(usize::from(positive), 1) {
                        let (start, end) = pieces.ends();
                        let at = [("i", i.to_string()), ("span", format!("[{start}, {end})"))];
                        let claimed = format!("{} is a sum of products, without a minus", name(d, i));
                        return Err(case.refuted_at_large(at, claimed, "a product has a minus".into()));
                    }
                }
            }
        }
        Ok(())
    }
}

/// The sum of the functions is the same for every degree, and so 1, as for degree 0: on [t_k, t_{n+1}], or `everywhere`, which is
/// the false variant.
fn sums_to_one(everywhere: bool) -> impl Fn(&BasisCase, &mut Ledger) -> Judgement {
    move |case, ledger| {
        let base = case.k()..=case.n();
        let sum = |functions: &Active<Multivariate>| {
            functions.values().iter().fold(Multivariate::constant(0), |sum, g| sum.plus(g))
        };
        for pieces in case.pieces().spans() {
            if !everywhere && !base.contains(&pieces.span.index()) {
                continue;
            }
            for (d, Level { before, after }) in (1..=case.k()).zip(levels(case, pieces.span, true)?) {
                if !ledger.count(usize::from(sum(&before) == sum(&after)), 1) {
                    let (start, end) = pieces.ends();
                    let at = [("span", format!("[{start}, {end})"))];
                    let claimed =
                        format!("the functions of degree {d} have the same sum as those of degree {}", d - 1);
                    return Err(case.refuted_at_large(at, claimed, "it depends on the weights".into()));
                }
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
        .note("By induction over the degree, with the functions of one degree, the weights and their complements as variables: nothing else of φ is used but that both are positive inside of the interval, with sum 1."),
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
