//! The two ways to compute, at some vectors of points at once.

#![expect(
    clippy::needless_range_loop,
    reason = "loops whose ends the compiler knows, over several arrays at once"
)]

use std::array::from_fn;

use super::accurate::{InFrame, combination, triangle};
use super::basis::Ratio;
use super::error::HIGHEST_DEGREE;
use super::fast::{self, FAST_DEGREE};
use super::pair::Pair;
use super::point::lifted;
use super::real::Real;
use super::vectors::Vectors;

/// How many points are worked on at once.
pub(super) const LANES: usize = 16;

/// LANES points with what belongs to them.
#[derive(Clone)]
pub(super) struct Chunk<F> {
    /// How many there are: nobody looks at what comes of the other lanes.
    pub(super) count: usize,
    /// In the unit of the frame.
    pub(super) x: [F; LANES],
    /// Entry i holds t_{j−k+1+i} of each point, in the unit.
    pub(super) knots: [[F; LANES]; 2 * HIGHEST_DEGREE],
    /// j, if the point is in the span [t_j, t_{j+1}]; else any.
    pub(super) spans: [usize; LANES],
    /// Is the point in [t_0, t_m]?
    pub(super) inside: [bool; LANES],
    /// Entry c holds G_{j−k+c} of each point, once that is computed.
    pub(super) values: [[F; LANES]; HIGHEST_DEGREE + 1],
}

impl<F: Real> Chunk<F> {
    pub(super) fn new() -> Self {
        Self {
            count: LANES,
            x: [F::zero(); LANES],
            knots: [[F::zero(); LANES]; 2 * HIGHEST_DEGREE],
            spans: [0; LANES],
            inside: [true; LANES],
            values: [[F::zero(); LANES]; HIGHEST_DEGREE + 1],
        }
    }

    /// Makes positive what is not 0.
    #[inline(always)]
    fn lift(&mut self, degree: usize) {
        for (c, row) in self.values.iter_mut().enumerate().take(degree + 1) {
            for (l, value) in row.iter_mut().enumerate() {
                *value = lifted(*value, c, degree, self.x[l], |i| self.knots[i][l]);
            }
        }
    }
}

/// How the values of a chunk are computed.
pub(super) trait Lanewise<F: Real> {
    /// k: a constant where it is one.
    fn degree(&self) -> usize;

    /// The functions.
    fn values<M: Vectors>(&self, m: M, chunk: &mut Chunk<F>);

    /// Σ d_c G_c for each of some coordinates: `control`(lane, c, coordinate) is d_c, and `put`(lane, coordinate, sum) takes the
    /// result.
    fn combinations<M: Vectors>(
        &self,
        m: M,
        chunk: &mut Chunk<F>,
        dimension: usize,
        control: impl Fn(usize, usize, usize) -> F,
        put: impl FnMut(usize, usize, F),
    );

    /// The functions at the points of one span, row by row.
    fn on_span<M: Vectors>(&self, m: M, unit: F, local: &[F], points: &[F], inner: bool, values: &mut [F]);
}

/// With k + 1 = C, a constant; or for any k, with the C that is enough for all.
pub(super) struct Accurate<const C: usize> {
    pub(super) degree: usize,
    pub(super) ratio: Ratio,
}

impl<const C: usize> Accurate<C> {
    /// The functions at the points from lane `first` on, as many as a vector has lanes.
    #[inline(always)]
    fn pairs<F: Real, M: Vectors>(&self, m: M, chunk: &Chunk<F>, first: usize) -> [Pair<M::Vector>; C] {
        let lanes = |row: &[F; LANES]| m.load(|l| row[first + l].widen());
        let knot = |i: usize| lanes(&chunk.knots[i]);
        let degree = Lanewise::<F>::degree(self);
        triangle(m, degree, &InFrame::<_, C>::new(m, self.ratio, degree, lanes(&chunk.x), knot))
    }
}

impl<F: Real, const C: usize> Lanewise<F> for Accurate<C> {
    #[inline(always)]
    fn degree(&self) -> usize {
        if C > HIGHEST_DEGREE { self.degree } else { C - 1 }
    }

    #[inline(always)]
    fn values<M: Vectors>(&self, m: M, chunk: &mut Chunk<F>) {
        let degree = Lanewise::<F>::degree(self);
        for first in (0..LANES).step_by(M::LANES) {
            let pairs = self.pairs(m, chunk, first);
            for c in 0..=degree {
                m.store(pairs[c].hi, |l, value| chunk.values[c][first + l] = F::nearest(value));
            }
        }
        let mut any_zero = false;
        for row in &chunk.values[..=degree] {
            for value in row {
                any_zero |= *value <= F::zero();
            }
        }
        if any_zero {
            chunk.lift(degree);
        }
    }

    #[inline(always)]
    fn combinations<M: Vectors>(
        &self,
        m: M,
        chunk: &mut Chunk<F>,
        dimension: usize,
        control: impl Fn(usize, usize, usize) -> F,
        mut put: impl FnMut(usize, usize, F),
    ) {
        for first in (0..LANES).step_by(M::LANES) {
            let pairs = self.pairs(m, chunk, first);
            for coordinate in 0..dimension {
                let control = |c| m.load(|l| control(first + l, c, coordinate).widen());
                let sum = combination(m, Lanewise::<F>::degree(self), &pairs, control);
                m.store(m.add(sum.hi, sum.lo), |l, value| put(first + l, coordinate, F::nearest(value)));
            }
        }
    }

    #[inline(always)]
    fn on_span<M: Vectors>(&self, m: M, unit: F, local: &[F], points: &[F], _: bool, values: &mut [F]) {
        let mut chunk = Chunk::new();
        for (place, t) in chunk.knots.iter_mut().zip(local) {
            *place = [*t; LANES];
        }
        for (at, part) in points.chunks(LANES).enumerate() {
            for (place, x) in chunk.x.iter_mut().zip(part) {
                *place = *x * unit;
            }
            self.values(m, &mut chunk);
            for (row, lanes) in values.chunks_exact_mut(points.len()).zip(&chunk.values) {
                row[at * LANES..][..part.len()].copy_from_slice(&lanes[..part.len()]);
            }
        }
    }
}

/// In degree K.
pub(super) struct Fast<F, const K: usize> {
    /// r, rounded.
    pub(super) ratio: F,
}

impl<F: Real, const K: usize> Lanewise<F> for Fast<F, K> {
    #[inline(always)]
    fn degree(&self) -> usize {
        K
    }

    #[inline(always)]
    fn values<M: Vectors>(&self, _: M, chunk: &mut Chunk<F>) {
        let mut closest = [F::one(); LANES];
        for l in 0..LANES {
            let (found, least) = fast::values::<F, K>(self.ratio, chunk.x[l], |i| chunk.knots[i][l]);
            closest[l] = least;
            for c in 0..K + 1 {
                chunk.values[c][l] = found[c];
            }
        }
        if closest.iter().fold(false, |any, closest| any | (*closest < fast::least_distance())) {
            chunk.lift(K);
        }
    }

    #[inline(always)]
    fn combinations<M: Vectors>(
        &self,
        m: M,
        chunk: &mut Chunk<F>,
        dimension: usize,
        control: impl Fn(usize, usize, usize) -> F,
        mut put: impl FnMut(usize, usize, F),
    ) {
        self.values(m, chunk);
        for l in 0..LANES {
            for coordinate in 0..dimension {
                let terms = (0..K + 1).map(|c| chunk.values[c][l] * control(l, c, coordinate));
                put(l, coordinate, terms.fold(F::zero(), |sum, term| sum + term));
            }
        }
    }

    #[inline(always)]
    fn on_span<M: Vectors>(&self, _: M, unit: F, local: &[F], points: &[F], inner: bool, values: &mut [F]) {
        let count = points.len();
        let mut rest = values.chunks_exact_mut(count.max(1));
        let mut rows: [&mut [F]; FAST_DEGREE + 1] = from_fn(|_| rest.next().unwrap_or_default());
        for row in rows.iter_mut().take(K + 1) {
            *row = &mut std::mem::take(row)[..count];
        }
        let local = &local[..2 * K];
        for (p, x) in points.iter().enumerate() {
            let (found, _) = fast::values::<F, K>(self.ratio, *x * unit, |i| local[i]);
            for c in 0..K + 1 {
                rows[c][p] = found[c];
            }
        }
        if inner {
            return;
        }
        for (p, x) in points.iter().enumerate() {
            let x = *x * unit;
            for (c, row) in rows.iter_mut().enumerate().take(K + 1) {
                row[p] = lifted(row[p], c, K, x, |i| local[i]);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::FloatBasis;
    use super::super::machine::{Kernel, Machine};
    use super::*;

    /// Both floats of every pair, before anything is rounded.
    struct Unrounded<const C: usize> {
        method: Accurate<C>,
        chunk: Chunk<f64>,
    }

    impl<const C: usize> Kernel for Unrounded<C> {
        type Output = Vec<[u64; LANES]>;

        #[inline(always)]
        fn run<M: Vectors>(self, m: M) -> Self::Output {
            let mut bits = vec![[0; LANES]; 2 * C];
            for first in (0..LANES).step_by(M::LANES) {
                for (c, pair) in self.method.pairs(m, &self.chunk, first).into_iter().enumerate() {
                    m.store(pair.hi, |l, hi| bits[2 * c][first + l] = hi.to_bits());
                    m.store(pair.lo, |l, lo| bits[2 * c + 1][first + l] = lo.to_bits());
                }
            }
            bits
        }
    }

    fn same_pairs<const C: usize>(degree: usize, alpha: f64) {
        let gaps = [0.7, 0.1, 1.9, 1e-3, 0.0, 2.0 / 3.0].into_iter().cycle().take(2 * degree + 2);
        let knots: Vec<f64> = gaps
            .scan(-1.0, |t, gap| {
                *t += gap;
                Some(*t)
            })
            .collect();
        let (start, end) = (knots[degree], knots[degree + 1]);
        if start < end {
            let basis = FloatBasis::new(knots.clone(), degree, alpha).expect("a basis");
            let frame = basis.frame.expect("gaps that are not far apart");
            let part = |l: usize| f64::from(u32::try_from(l).expect("a lane")) / 15.3;
            let mut chunk = Chunk::new();
            chunk.x = from_fn(|l| (start + (end - start) * part(l)) * frame.unit);
            for (place, t) in chunk.knots.iter_mut().zip(&knots[1..2 * degree + 1]) {
                *place = [*t * frame.unit; LANES];
            }
            let mut results = Machine::all().into_iter().map(|machine| {
                let method = Accurate::<C> { degree, ratio: basis.ratio };
                machine.run(Unrounded { method, chunk: chunk.clone() })
            });
            let first = results.next();
            assert!(results.all(|other| first.as_ref() == Some(&other)), "k = {degree}, α = {alpha:e}");
        }
    }

    /// With vectors of any width, with products by fused multiply–add or by halves: not one bit of a pair differs.
    #[test]
    fn pairs_are_the_same_on_every_machine() {
        for alpha in [-0.3, 1.7, f64::INFINITY, -1e-9, 1e16] {
            same_pairs::<2>(1, alpha);
            same_pairs::<4>(3, alpha);
            same_pairs::<6>(5, alpha);
            for degree in 6..=HIGHEST_DEGREE {
                same_pairs::<{ HIGHEST_DEGREE + 1 }>(degree, alpha);
            }
        }
    }
}
