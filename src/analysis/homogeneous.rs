//! Pieces of curves in homogeneous coordinates.

use num_rational::BigRational;
use num_traits::One;

use crate::scalar::{Polynomial, Ring, integer};
use crate::spline::{Point, Span, binomial};

/// A rational Bézier curve of degree N over [a, b] by its control points (ω_m, ω_m b_m), which a common factor does not change:
/// the vector Σ (ω_m, ω_m b_m) B_m^N(s), s = (x − a)/(b − a), is a polynomial.
#[derive(Debug, Clone)]
pub(super) struct Homogeneous {
    /// The span of the curve that [a, b] lies in.
    pub(super) span: Span,
    /// a < b.
    pub(super) ends: [BigRational; 2],
    /// Its N + 1 control points.
    pub(super) net: Vec<Point>,
}

impl Homogeneous {
    /// N.
    pub(super) fn degree(&self) -> usize {
        self.net.len() - 1
    }

    /// (ω_0, ω_0 b_0).
    pub(super) fn first(&self) -> &[BigRational] {
        &self.net[0]
    }

    /// (ω_N, ω_N b_N).
    pub(super) fn last(&self) -> &[BigRational] {
        &self.net[self.degree()]
    }

    /// The blossom at N arguments x, which may lie outside of [a, b]: de Casteljau's algorithm with one of them a level.
    pub(super) fn blossom<'a>(&self, arguments: impl IntoIterator<Item = &'a BigRational>) -> Point {
        let [a, b] = &self.ends;
        let mut level = self.net.clone();
        for x in arguments {
            let s = (x - a) / (b - a);
            // At a and b a level is a part of the one before.
            if s.is_zero() {
                level.pop();
            } else if s.is_one() {
                level.remove(0);
            } else {
                level = level.windows(2).map(|pair| blend(&pair[0], &pair[1], &s)).collect();
            }
        }
        level.swap_remove(0)
    }

    /// The part in [from, to]; `None` if it has no length.
    pub(super) fn within(self, [from, to]: [&BigRational; 2]) -> Option<Self> {
        let [a, b] = &self.ends;
        let (from, to) = (from.max(a), to.min(b));
        if (from, to) == (a, b) {
            return Some(self);
        }
        let part = |m: usize| {
            let arguments = std::iter::repeat_n(from, self.degree() - m).chain(std::iter::repeat_n(to, m));
            self.blossom(arguments)
        };
        (from < to).then(|| Self {
            span: self.span,
            net: (0..self.net.len()).map(part).collect(),
            ends: [from.clone(), to.clone()],
        })
    }

    /// The parts before and after the middle of [a, b]: the two sides of de Casteljau's triangle.
    pub(super) fn halves(&self) -> [Self; 2] {
        let [a, b] = &self.ends;
        let (half, middle) = (BigRational::new(1.into(), 2.into()), (a + b) / integer(2));
        let (mut level, mut left, mut right) = (self.net.clone(), Vec::new(), Vec::new());
        while let (Some(first), Some(last)) = (level.first(), level.last()) {
            left.push(first.clone());
            right.push(last.clone());
            level = level.windows(2).map(|pair| blend(&pair[0], &pair[1], &half)).collect();
        }
        right.reverse();
        let part = |net, ends| Self { span: self.span, ends, net };
        [part(left, [a.clone(), middle.clone()]), part(right, [middle, b.clone()])]
    }

    /// The same of a degree D ≥ N: in u = s/(1 − s), where B_m^N is C(N, m) u^m/(1 + u)^N, times (1 + u)^(D − N) above and below.
    pub(super) fn elevated(mut self, degree: usize) -> Self {
        let own = self.degree();
        let polynomial = |n: usize, coefficient: &dyn Fn(usize) -> BigRational| {
            Polynomial::new(coefficient(0), (1..=n).map(coefficient))
        };
        let factor = polynomial(degree - own, &|m| binomial(degree - own, m));
        let coordinate = |c: usize| polynomial(own, &|m| binomial(own, m) * &self.net[m][c]).times(&factor);
        let coordinates: Vec<_> = (0..self.net[0].len()).map(coordinate).collect();
        let entry = |p: &Polynomial<_>, m: usize| {
            p.coefficients().get(m).map_or(integer(0), |c| c / binomial(degree, m))
        };
        self.net = (0..=degree).map(|m| coordinates.iter().map(|p| entry(p, m)).collect()).collect();
        self
    }

    /// ω_m → ω_m λ^m: the same points, at s/(s + λ(1 − s)) in place of s.
    pub(super) fn reparametrised(mut self, ratio: &BigRational) -> Self {
        for (m, control) in self.net.iter_mut().enumerate() {
            let factor = ratio.power(m);
            control.iter_mut().for_each(|coordinate| *coordinate *= &factor);
        }
        self
    }

    /// The same with this for ω_0.
    pub(super) fn beginning_with(mut self, weight: &BigRational) -> Self {
        let factor = weight / &self.net[0][0];
        self.net.iter_mut().flatten().for_each(|coordinate| *coordinate *= &factor);
        self
    }

    /// How many derivatives, up to `most` ≤ N, agree at the end of this piece with those of the next one, of the same degree,
    /// at its beginning: differences of control points over powers of the lengths.
    pub(super) fn contact(&self, next: &Self, most: usize) -> usize {
        let [mut before, mut after] =
            [&self.net[self.degree() - most..], &next.net[..=most]].map(<[Point]>::to_vec);
        let lengths = [self, next].map(|piece| &piece.ends[1] - &piece.ends[0]);
        let mut agrees = || {
            before = differences(&before, &lengths[0]);
            after = differences(&after, &lengths[1]);
            before.last() == after.first()
        };
        (0..most).take_while(|_| agrees()).count()
    }
}

/// The divided differences of neighbours.
fn differences(net: &[Point], length: &BigRational) -> Vec<Point> {
    let between = |pair: &[Point]| pair[1].iter().zip(&pair[0]).map(|(b, a)| (b - a) / length).collect();
    net.windows(2).map(between).collect()
}

/// (1 − s)·left + s·right.
pub(super) fn blend(left: &[BigRational], right: &[BigRational], s: &BigRational) -> Point {
    let complement = integer(1) - s;
    left.iter().zip(right).map(|(a, b)| &complement * a + s * b).collect()
}
