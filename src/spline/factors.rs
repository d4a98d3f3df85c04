//! The linear factors that the denominators on one span consist of.

use std::ops::Range;

use crate::scalar::Ring;

use super::knots::Span;

/// What all functions on a span [t_j, t_{j+1}) are computed from, without any division.
///
/// Up to one common factor of all of them,
///
/// rise_a = r(x − t_a) for the knots t_a ≤ t_j, fall_b = t_b − x for t_b ≥ t_{j+1}, L_{a,b} = rise_a + fall_b,
///
/// at a point x, in the jet of one, or as polynomials in a coordinate of the span. The weight of [t_a, t_b] is
/// rise_a/L_{a,b} (D2.3), and all three are positive inside the span. The denominator of G_i^d is the product of L_{a,b}
/// over all i ≤ a ≤ j < b ≤ i + d + 1 but (a, b) = (i, i + d + 1).
///
/// Weights may each have a ratio of their own, as those of any family with linear forms: then rise and fall are those of
/// the weight, rise_{a,b} = p_{a,b}(x − t_a) and fall_{a,b} = q_{a,b}(t_b − x), and all else is the same.
#[derive(Debug, Clone, PartialEq)]
pub struct Factors<F> {
    span: Span,
    degree: usize,
    /// How many knots t_j, t_{j−1}, … and t_{j+1}, t_{j+2}, … there are.
    sides: (usize, usize),
    /// Does each weight have a rise and a fall of its own? Then they stand like `sums`.
    of_weights: bool,
    /// Else place s is that of the knot t_{j−s}.
    rises: Vec<F>,
    /// And place w that of the knot t_{j+1+w}.
    falls: Vec<F>,
    /// L of the knots at the places s and w, s + w < k, row after row of rising w: that is all up to degree k.
    sums: Vec<F>,
}

impl<F: Clone> Factors<F> {
    /// From rise_j, rise_{j−1}, … and fall_{j+1}, fall_{j+2}, …, at least one of each: k of them, or as many as
    /// there are knots. `sum` adds two factors.
    #[must_use]
    pub fn new(span: Span, degree: usize, rises: Vec<F>, falls: Vec<F>, sum: impl Fn(&F, &F) -> F) -> Self {
        let sides = (rises.len(), falls.len());
        let mut factors = Self { span, degree, sides, of_weights: false, rises, falls, sums: Vec::new() };
        let added = factors.add_up(|rise, fall| Some(sum(rise, fall)));
        debug_assert!(added.is_some());
        factors
    }

    /// Room for the factors up to degree k.
    pub(crate) fn empty(degree: usize) -> Self {
        Self {
            span: Span::assumed(0),
            degree,
            sides: (0, 0),
            of_weights: false,
            rises: Vec::new(),
            falls: Vec::new(),
            sums: Vec::new(),
        }
    }

    /// From the distances x − t_j, x − t_{j−1}, … and t_{j+1} − x, t_{j+2} − x, …, at least one of each, in the room that is
    /// there: `times` a slope they are rises and falls. The [slopes](super::LinearWeights) are (p, q) of all weights, if there
    /// is one pair, or else one for each weight. `None` if a factor does not exist in its type.
    pub(super) fn fill<R, D>(
        &mut self,
        span: Span,
        slopes: &[(R, R)],
        before: impl Iterator<Item = Option<D>>,
        after: impl Iterator<Item = Option<D>>,
        times: impl Fn(&R, &D) -> Option<F>,
        sum: impl Fn(&F, &F) -> Option<F>,
    ) -> Option<()> {
        self.span = span;
        self.of_weights = slopes.len() > 1;
        self.rises.clear();
        self.falls.clear();
        if let [(p, q)] = slopes {
            self.rises.reserve(before.size_hint().0);
            self.falls.reserve(after.size_hint().0);
            for distance in before {
                self.rises.push(times(p, &distance?)?);
            }
            for distance in after {
                self.falls.push(times(q, &distance?)?);
            }
            self.sides = (self.rises.len(), self.falls.len());
        } else {
            let after = after.collect::<Option<Vec<_>>>()?;
            self.sides = (0, after.len());
            for (s, distance) in before.enumerate() {
                let distance = distance?;
                self.sides.0 += 1;
                let row = row_start(self.degree, s)..row_start(self.degree, s + 1);
                // Beyond the last knot nothing is ever asked for: what stands there is without meaning.
                let after = after.iter().chain(std::iter::repeat_with(|| &after[after.len() - 1]));
                for ((p, q), other) in slopes[row].iter().zip(after) {
                    self.rises.push(times(p, &distance)?);
                    self.falls.push(times(q, other)?);
                }
            }
        }
        self.add_up(sum)
    }

    /// All L from rises and falls.
    fn add_up(&mut self, sum: impl Fn(&F, &F) -> Option<F>) -> Option<()> {
        self.sums.clear();
        let rows = self.sides.0.min(self.degree);
        self.sums.reserve(row_start(self.degree, rows));
        for s in 0..rows {
            for w in 0..self.degree - s {
                let rise = self.rise(s, w);
                // Beyond the last knot nothing is ever asked for.
                let added = self.fall(s, w).map_or_else(|| Some(rise.clone()), |fall| sum(rise, fall));
                self.sums.push(added?);
            }
        }
        Some(())
    }

    /// The rise of the weight of the knots at the places s and w.
    #[inline]
    fn rise(&self, s: usize, w: usize) -> &F {
        &self.rises[if self.of_weights { row_start(self.degree, s) + w } else { s }]
    }

    /// Its fall.
    #[inline]
    fn fall(&self, s: usize, w: usize) -> Option<&F> {
        self.falls.get(if self.of_weights { row_start(self.degree, s) + w } else { w })
    }

    /// The same in another form, of which `sum` adds two.
    pub(crate) fn map<T: Clone>(
        &self,
        rise: impl Fn(&F) -> T,
        fall: impl Fn(&F) -> T,
        sum: impl Fn(&T, &T) -> T,
    ) -> Factors<T> {
        let (rises, falls) = (self.rises.iter().map(rise).collect(), self.falls.iter().map(fall).collect());
        let mut factors = Factors { rises, falls, ..Factors::empty(self.degree) };
        (factors.span, factors.sides, factors.of_weights) = (self.span, self.sides, self.of_weights);
        let added = factors.add_up(|rise, fall| Some(sum(rise, fall)));
        debug_assert!(added.is_some());
        factors
    }

    /// The span.
    #[must_use]
    pub fn span(&self) -> Span {
        self.span
    }

    /// k, the highest degree that they are for.
    #[must_use]
    pub fn degree(&self) -> usize {
        self.degree
    }

    /// The L_{a,b} of the denominator of G_i^k.
    ///
    /// # Panics
    /// Unless G_i^k lives on the span: j − k ≤ i ≤ j.
    pub fn denominator(&self, i: usize) -> impl Iterator<Item = &F> {
        self.denominator_places(i).flat_map(|row| &self.sums[row])
    }

    /// Their places in [`places`](Self::places), row by row.
    pub(crate) fn denominator_places(&self, i: usize) -> impl Iterator<Item = Range<usize>> + Clone + use<F> {
        let (degree, (last_row, last_column)) = (self.degree, self.last_places(i));
        (0..=last_row).filter(move |s| *s < degree).map(move |s| {
            let start = row_start(degree, s);
            start..start + last_column + usize::from(s < last_row)
        })
    }

    /// The places of t_i and of t_{i+k+1}.
    fn last_places(&self, i: usize) -> (usize, usize) {
        let (j, degree) = (self.span.index(), self.degree);
        assert!(i <= j && j - i <= degree, "G_{i} does not live on the span {j}");
        (j - i, i + degree - j)
    }

    /// All L, by places; what is on places that belong to no L is without meaning.
    pub(crate) fn places(&self) -> &[F] {
        &self.sums
    }

    /// The L_{a,b} with b − a ≤ k that the denominator of G_i^k lacks: with those all functions have the same.
    ///
    /// # Panics
    /// Unless G_i^k lives on the span: j − k ≤ i ≤ j.
    pub fn cofactor(&self, i: usize) -> impl Iterator<Item = &F> {
        let (last_row, last_column) = self.last_places(i);
        (0..self.sides.0.min(self.degree)).flat_map(move |s| {
            let known = if s <= last_row { last_column + usize::from(s < last_row) } else { 0 };
            let end = self.row(s, self.degree - s).len();
            &self.row(s, end)[known.min(end)..]
        })
    }

    /// All L_{a,b} with b − a ≤ k.
    pub fn all(&self) -> impl Iterator<Item = &F> {
        (0..self.sides.0.min(self.degree)).flat_map(|s| self.row(s, self.degree - s))
    }

    /// rise_a and fall_b of the weight of [t_i, t_{i+d}], which contains the span.
    pub(super) fn shares(&self, i: usize, d: usize) -> (&F, &F) {
        let (s, w) = (self.span.index() - i, i + d - self.span.index() - 1);
        match self.fall(s, w) {
            Some(fall) => (self.rise(s, w), fall),
            None => unreachable!("t_{} is a knot", i + d),
        }
    }

    /// rise_a and what else G_i^{d−1} is multiplied by on its way to G_i^d, a = i at place s, t_{i+d} at place w:
    /// L of the next knot and all from t_{i+1} to t_j.
    pub(super) fn for_own(&self, s: usize, w: usize) -> impl Iterator<Item = &F> {
        // From one row to the next a column moves by the length of the row.
        let next =
            |place: &mut usize, s: usize| self.sums.get(std::mem::replace(place, *place + self.degree - s));
        std::iter::once(self.rise(s, w)).chain((0..s).scan(w + 1, next))
    }

    /// fall_b and what else G_i^{d−1} is multiplied by on its way to G_{i−1}^d, b = i + d at place w, t_i at place s:
    /// L of the knot before and all from t_{j+1} to t_{b−1}.
    pub(super) fn for_rest(&self, s: usize, w: usize) -> impl Iterator<Item = &F> {
        self.fall(s, w).into_iter().chain(self.row(s + 1, w))
    }

    /// The first `count` of L of the knot at place s.
    fn row(&self, s: usize, count: usize) -> &[F] {
        let start = row_start(self.degree, s);
        self.sums.get(start..start + count.min(self.sides.1)).unwrap_or(&[])
    }
}

/// Where the row of place s begins, after those of k, k − 1, … entries.
fn row_start(degree: usize, s: usize) -> usize {
    s * (2 * degree + 1 - s) / 2
}

impl<R: Ring> Factors<(R, R)> {
    /// The factors as polynomials A + Bu, written (A, B), in the span's positive coordinate u, times (1 + u): from
    /// the gaps t_1 − t_0, …, t_m − t_{m−1}, the number j of the span's own, and r = p/q as (p, q), of all weights or of each
    /// by its place. Here
    ///
    /// rise_a = p((t_j − t_a) + (t_{j+1} − t_a)u),  fall_b = q((t_b − t_j) + (t_b − t_{j+1})u).
    ///
    /// `None` if there is no such gap.
    pub fn in_positive_coordinate(gaps: &[R], j: usize, degree: usize, slopes: &[(R, R)]) -> Option<Self> {
        let mut factors = Self::empty(degree);
        factors.fill_in_positive_coordinate(gaps, j, slopes)?;
        Some(factors)
    }

    /// The same in the room that is there.
    pub(crate) fn fill_in_positive_coordinate(
        &mut self,
        gaps: &[R],
        j: usize,
        slopes: &[(R, R)],
    ) -> Option<()> {
        let gap = gaps.get(j)?;
        let steps = self.degree.max(1);
        let mut sum = gap.zero();
        let before = (0..steps.min(j + 1)).map(|s| {
            if s > 0 {
                sum.increase(&gaps[j - s]);
            }
            Some((sum.clone(), sum.plus(gap)))
        });
        let mut sum = gap.zero();
        let after = (0..steps.min(gaps.len() - j)).map(|w| {
            if w > 0 {
                sum.increase(&gaps[j + w]);
            }
            Some((sum.plus(gap), sum.clone()))
        });
        let times =
            |slope: &R, (at_start, at_end): &(R, R)| Some((slope.times(at_start), slope.times(at_end)));
        let span = Span::assumed(j);
        self.fill(span, slopes, before, after, times, |a, b| Some((a.0.plus(&b.0), a.1.plus(&b.1))))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use num_bigint::BigInt;

    /// Seven knots, the span in the middle, all functions of degree 3 that are there.
    #[test]
    fn denominators_and_cofactors_are_all_factors() {
        let gaps: Vec<BigInt> = [1, 2, 3, 4, 5, 6].map(BigInt::from).to_vec();
        let one = BigInt::from(1);
        for j in 0..6 {
            let factors =
                Factors::in_positive_coordinate(&gaps, j, 3, &[(one.clone(), one.clone())]).unwrap();
            let functions = j.saturating_sub(3)..=j.min(2);
            for i in functions {
                let mut both: Vec<_> = factors.denominator(i).chain(factors.cofactor(i)).collect();
                let mut all: Vec<_> = factors.all().collect();
                both.sort();
                all.sort();
                assert_eq!(both, all, "span {j}, function {i}");
                assert_eq!(factors.denominator(i).count(), (j - i + 1) * (i + 4 - j) - 1);
            }
        }
    }
}
