//! What does not depend on the weights at all: an index of its own for every knot, every interval, every weight.

use num_bigint::BigInt;

use crate::language::Int;
use crate::scalar::{Monomial, Multivariate, Ring};
use crate::spline::{Active, KnotVector, Span, Triangle, Weights};

use super::super::reading::{Reading, place};
use super::super::truth::Stop;

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

/// Are the functions of a degree positive inside of their supports, with the sum 1 on [t_k, t_{n+1}], whatever the weights?
pub(super) fn holds(own: &mut Reading<'_>, degree: &Int) -> Result<bool, Stop> {
    let (d, k) = (own.int(degree)?, own.degree()?);
    let d = place(d, k + 1, || format!("there are no functions of degree {d}"))?;
    let room = || Stop::Unknown(format!("the polynomials have room for {} variables", Monomial::VARIABLES));
    for_all_weights(own.knots()?, d).ok_or_else(room)
}

/// `None` if the polynomials have no room for so many variables.
///
/// Step by step from degree 0, where it is so: as polynomials in the functions of the degree before, the weights and their
/// complements, those of the next degree have positive coefficients, and with complements 1 − w they have the same sum.
fn for_all_weights(knots: &KnotVector, degree: usize) -> Option<bool> {
    if 3 * (degree + 1) > Monomial::VARIABLES {
        return None;
    }
    let m = knots.m();
    let all_functions_exist = degree..m.saturating_sub(degree);
    let mut spans = knots.spans();
    Some(spans.all(|span| {
        let (mut first, mut count) = (span.index(), 1);
        (1..=degree).all(|d| {
            let unknowns = (first..first + count).map(|i| variable(span.index() - i, FUNCTION)).collect();
            let before = Active::new(first, unknowns);
            let [free, related] = [false, true].map(|related| raised(&before, &Free { span, related }, d, m));
            (first, count) = (free.first(), free.values().len());
            let positive = |g: &Multivariate| !g.is_zero() && g.terms().all(|(_, c)| *c > BigInt::ZERO);
            free.values().iter().all(positive)
                && (!all_functions_exist.contains(&span.index()) || sum(&before) == sum(&related))
        })
    }))
}

fn raised(before: &Active<Multivariate>, weights: &Free, d: usize, m: usize) -> Active<Multivariate> {
    let mut triangle = Triangle::starting_with(before.clone(), &weights.one());
    triangle.raise(weights, weights.span, d, m);
    triangle.into_active()
}

fn sum(functions: &Active<Multivariate>) -> Multivariate {
    functions.values().iter().fold(Multivariate::constant(0), |sum, g| sum.plus(g))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::integer;

    #[test]
    fn positive_with_sum_one_for_all_weights() {
        let knots = KnotVector::new([0, 0, 1, 2, 2, 4, 5].map(integer).to_vec()).unwrap();
        for degree in 0..=3 {
            assert_eq!(for_all_weights(&knots, degree), Some(true), "{degree}");
        }
        assert_eq!(for_all_weights(&knots, Monomial::VARIABLES), None);
    }
}
