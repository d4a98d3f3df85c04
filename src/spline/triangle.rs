//! The recursion of D3.3 on one span, once for all scalars.

use crate::scalar::Ring;

use super::knots::Span;
use super::weight::Weights;

/// The functions of one degree that are not identically zero on a span: G_first, G_{first+1}, …
#[derive(Debug, Clone, PartialEq)]
pub struct Active<S> {
    first: usize,
    values: Vec<S>,
}

impl<S> Active<S> {
    /// G_first, G_{first+1}, … with the given values.
    #[must_use]
    pub fn new(first: usize, values: Vec<S>) -> Self {
        Self { first, values }
    }

    /// The index of the first one.
    #[must_use]
    pub fn first(&self) -> usize {
        self.first
    }

    /// The functions, by rising index.
    #[must_use]
    pub fn values(&self) -> &[S] {
        &self.values
    }

    /// G_i, or `None` where it is identically 0.
    #[must_use]
    pub fn get(&self, i: usize) -> Option<&S> {
        self.values.get(i.checked_sub(self.first)?)
    }

    /// Pairs (i, G_i).
    pub fn iter(&self) -> impl Iterator<Item = (usize, &S)> {
        (self.first..).zip(&self.values)
    }

    /// The same functions under a map.
    pub fn map<T>(&self, f: impl FnMut(&S) -> T) -> Active<T> {
        Active { first: self.first, values: self.values.iter().map(f).collect() }
    }
}

/// All G_i^k that do not vanish on the span [t_j, t_{j+1}) of a knot vector (t_0, …, t_m), by
///
/// G_i^d = w_i^d G_i^{d−1} + (1 − w_{i+1}^d) G_{i+1}^{d−1},  G_j^0 = 1.
///
/// On the span only G_{j−d}^d, …, G_j^d live, as far as they exist (0 ≤ i ≤ m − d − 1); every weight between
/// them belongs to an interval that contains the span, so none is empty and nothing is compared here.
///
/// The degree must be less than m.
pub fn triangle<W: Weights>(weights: &W, span: Span, degree: usize, m: usize) -> Active<W::Scalar> {
    let lowest = Active { first: span.index(), values: vec![weights.one()] };
    (1..=degree).fold(lowest, |lower, d| raise(weights, span, &lower, d, m))
}

/// One step of the [`triangle`]: the functions of degree d from those of degree d − 1 on the span.
pub fn raise<W: Weights>(
    weights: &W,
    span: Span,
    lower: &Active<W::Scalar>,
    d: usize,
    m: usize,
) -> Active<W::Scalar> {
    let pairs = lower.map_indexed(|i, value| weights.split(i, d, value));
    // Each G_i^{d−1} is split in two: the part w goes to G_i^d, the part 1 − w to G_{i−1}^d.
    let (first, last) = (span.index().saturating_sub(d), span.index().min(m - d - 1));
    let values = (first..=last).filter_map(|i| match (pairs.get(i), pairs.get(i + 1)) {
        (Some((own, _)), Some((_, next))) => Some(own.plus(next)),
        (Some((own, _)), None) => Some(own.clone()),
        (None, Some((_, next))) => Some(next.clone()),
        (None, None) => None,
    });
    Active { first, values: values.collect() }
}

impl<S> Active<S> {
    fn map_indexed<T>(&self, mut f: impl FnMut(usize, &S) -> T) -> Active<T> {
        Active { first: self.first, values: self.iter().map(|(i, value)| f(i, value)).collect() }
    }
}

/// The points d_i^r of de Boor's algorithm (T4.1) on the span [t_j, t_{j+1}): entry r of the result holds
/// d_{j−k+r}^r, …, d_j^r, so the last entry is the one point of the curve.
///
/// `points` are the k + 1 control points d_{j−k}, …, d_j, each a list of coordinates:
///
/// d_i^{r+1} = w_i^{k−r} d_i^r + (1 − w_i^{k−r}) d_{i−1}^r.
pub fn de_boor<W: Weights>(
    weights: &W,
    span: Span,
    points: &[Vec<W::Scalar>],
) -> Vec<Active<Vec<W::Scalar>>> {
    let degree = points.len() - 1;
    let mut levels = vec![Active { first: span.index() - degree, values: points.to_vec() }];
    for r in 0..degree {
        let level = &levels[r];
        let first = level.first + 1;
        let blend = |(i, pair): (usize, &[Vec<W::Scalar>])| {
            let (w, complement) = weights.pair(i, degree - r);
            pair[1]
                .iter()
                .zip(&pair[0])
                .map(|(own, left)| w.times(own).plus(&complement.times(left)))
                .collect()
        };
        let values = (first..).zip(level.values.windows(2)).map(blend).collect();
        levels.push(Active { first, values });
    }
    levels
}
