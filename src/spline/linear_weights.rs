//! Weights by linear forms, which the triangle without a division is for.

use std::collections::BTreeMap;

use num_bigint::BigInt;

use super::basis::Basis;
use super::kind::{HasWeights, WeightKind};
use super::knots::Span;

/// The **slopes** of linear weights, (p, q) with rise : fall = p(x − t_i) : q(t_{i+d} − x), p > 0, q > 0.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum LinearWeights<R> {
    /// One pair for all weights: r = p/q of an index.
    Same([(R, R); 1]),
    /// One for each weight on each span, in the order in which [`Factors`](super::Factors) has the weights.
    Each(BTreeMap<usize, Vec<(R, R)>>),
}

impl LinearWeights<BigInt> {
    /// Those of a basis, if all of its weights are linear.
    pub(super) fn of<W: HasWeights>(basis: &Basis<W>) -> Option<Self> {
        if let WeightKind::Index(index) = basis.weights().kind() {
            return Some(Self::Same([index.slopes()]));
        }
        let on = |span: Span| Some((span.index(), basis.slopes(span)?));
        basis.knots().spans().map(on).collect::<Option<_>>().map(Self::Each)
    }
}

impl<R> LinearWeights<R> {
    /// The slopes on span j: one pair, or one for each place.
    pub(super) fn on(&self, j: usize) -> &[(R, R)] {
        match self {
            Self::Same(pair) => pair,
            Self::Each(by_span) => by_span.get(&j).map_or(&[], Vec::as_slice),
        }
    }

    /// In another type, if all of them exist in it.
    pub(super) fn map<T>(&self, image: impl Fn(&R) -> Option<T>) -> Option<LinearWeights<T>> {
        let pair = |(p, q): &(R, R)| Some((image(p)?, image(q)?));
        Some(match self {
            Self::Same([own]) => LinearWeights::Same([pair(own)?]),
            Self::Each(by_span) => {
                let on = |(j, pairs): (&usize, &Vec<_>)| {
                    Some((*j, pairs.iter().map(pair).collect::<Option<_>>()?))
                };
                LinearWeights::Each(by_span.iter().map(on).collect::<Option<_>>()?)
            }
        })
    }
}

impl<W: HasWeights> Basis<W> {
    /// The slopes (p, q) of the weights on a span, coprime integers > 0 with rise : fall = p(x − t_i) : q(t_{i+d} − x): one pair for
    /// an index, else one for each weight by its place, those of t_j first, then those of t_{j−1}, …, each row by rising
    /// t_{i+d}, and 1 : 1 beyond the last knot. `None` if a weight is not linear.
    pub(crate) fn slopes(&self, span: Span) -> Option<Vec<(BigInt, BigInt)>> {
        let (j, k) = (span.index(), self.degree());
        let table = match self.weights().kind() {
            WeightKind::Index(index) => return Some(vec![index.slopes()]),
            WeightKind::Forms(table) => table,
        };
        let mut slopes = Vec::with_capacity(k * (k + 1) / 2);
        for s in 0..k.min(j + 1) {
            for w in 0..k - s {
                slopes.push(match table.get(j, j - s, s + w + 1) {
                    Some(forms) => forms.slope_ratio()?.into_raw(),
                    None => (1.into(), 1.into()),
                });
            }
        }
        Some(slopes)
    }
}
