//! The recursion of D3.3 word for word, all functions of all degrees, zeros included.
//!
//! Slow and simple: the test of the [`triangle`](super::triangle()), and what every witness is computed with
//! once more before it is believed.

use crate::scalar::RationalAlgebra;

use super::basis::Basis;
use super::kind::{HasWeights, WeightKind};
use super::knots::{Span, SpanError};
use super::weight::{Weights, weight};

/// Entry d, i is G_i^d at x, for 0 ≤ d ≤ k and 0 ≤ i ≤ m − d − 1, where x is a scalar of the closed span (a
/// point, a jet, or the span coordinate as a variable) and the limit is taken in the span.
///
/// G_i^0 is 1 on its own interval and 0 elsewhere; w_i^d is 0 where [t_i, t_{i+d}) does not contain the span.
///
/// # Errors
/// [`SpanError`] as for [`Basis::active`].
pub fn by_definition<W: HasWeights, S: RationalAlgebra>(
    basis: &Basis<W>,
    span: Span,
    x: &S,
) -> Result<Vec<Vec<S>>, SpanError> {
    let knots = basis.knots();
    match basis.weights().kind() {
        WeightKind::Index(index) => {
            let ratio = x.embed(index.ratio());
            by_weights(basis, span, x, |i, d| {
                let w = weight(&ratio, x, knots.t(i), knots.t(i + d)).0;
                let complement = x.one().minus(&w);
                (w, complement)
            })
        }
        WeightKind::Forms(table) => {
            let weights = table.at(knots, span, x);
            by_weights(basis, span, x, |i, d| weights.pair(i, d))
        }
    }
}

/// The same with any weights: `shares` gives w_i^d and what stands for 1 − w_i^d where [t_i, t_{i+d}) contains the span.
///
/// # Errors
/// [`SpanError`] as for [`Basis::active`].
pub fn by_weights<W, S: RationalAlgebra>(
    basis: &Basis<W>,
    span: Span,
    x: &S,
    shares: impl Fn(usize, usize) -> (S, S),
) -> Result<Vec<Vec<S>>, SpanError> {
    let (knots, j) = (basis.knots(), span.index());
    knots.ends_around(span, x)?;
    let pair = |i: usize, d: usize| {
        let inside = i <= j && j < i + d;
        if inside { shares(i, d) } else { (x.zero(), x.one()) }
    };
    let mut table = vec![(0..knots.m()).map(|i| if i == j { x.one() } else { x.zero() }).collect::<Vec<_>>()];
    for d in 1..=basis.degree() {
        let lower = &table[d - 1];
        let function = |i: usize| pair(i, d).0.times(&lower[i]).plus(&pair(i + 1, d).1.times(&lower[i + 1]));
        table.push((0..knots.m() - d).map(function).collect());
    }
    Ok(table)
}
