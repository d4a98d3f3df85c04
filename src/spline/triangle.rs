//! The recursion of D3.3 on one span, once for all scalars.

use crate::scalar::{Additive, Ring};

use super::knots::Span;
use super::weight::{Split, Weights};

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
        self.values.iter().enumerate().map(|(place, value)| (self.first + place, value))
    }

    /// The pairs without the list.
    pub(crate) fn into_pairs(self) -> impl Iterator<Item = (usize, S)> {
        (self.first..).zip(self.values)
    }

    /// The same functions under a map that takes them.
    pub fn into_map<T>(self, f: impl FnMut(S) -> T) -> Active<T> {
        Active { first: self.first, values: self.values.into_iter().map(f).collect() }
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
/// # Panics
/// Unless j < m and k < m: then there is no such span, or no function of the degree.
pub fn triangle<W: Split>(weights: &W, span: Span, degree: usize, m: usize) -> Active<W::Scalar> {
    let mut triangle = Triangle::new(weights.one());
    triangle.run(weights, span, degree, m);
    triangle.into_active()
}

/// The room in which the [`triangle()`] is computed: to be kept from one point to the next, so that scalars that
/// own memory need no new one.
#[derive(Debug, Clone)]
pub struct Triangle<S> {
    first: usize,
    /// The functions of the present degree, the first `count` of them; the others are spare.
    values: Vec<S>,
    count: usize,
    /// w_i^d G_i^{d−1} of the present function, and of the one before it.
    own: S,
    carry: S,
}

impl<S: Additive> Triangle<S> {
    /// Room for scalars of the ring that `one` is the 1 of.
    #[must_use]
    pub fn new(one: S) -> Self {
        Self { first: 0, own: one.clone(), carry: one.clone(), values: vec![one], count: 0 }
    }

    /// The functions of some degree, to go on from.
    #[must_use]
    pub fn starting_with(active: Active<S>, one: &S) -> Self {
        let Active { first, values } = active;
        Self { first, count: values.len(), values, own: one.clone(), carry: one.clone() }
    }

    /// The whole recursion, from degree 0; [`triangle()`] says what it computes.
    ///
    /// # Panics
    /// As [`triangle()`].
    pub fn run<W: Split<Scalar = S>>(&mut self, weights: &W, span: Span, degree: usize, m: usize) {
        assert!(
            span.index() < m && degree < m,
            "a span of index {} and degree {degree} for m = {m}",
            span.index()
        );
        weights.set_one(&mut self.values[0]);
        (self.first, self.count) = (span.index(), 1);
        for d in 1..=degree {
            self.raise(weights, span, d, m);
        }
    }

    /// The index of the first function.
    #[must_use]
    pub fn first(&self) -> usize {
        self.first
    }

    /// The functions, by rising index.
    #[must_use]
    pub fn values(&self) -> &[S] {
        &self.values[..self.count]
    }

    /// The functions, without the room.
    #[must_use]
    pub fn into_active(mut self) -> Active<S> {
        self.values.truncate(self.count);
        Active { first: self.first, values: self.values }
    }

    /// From the functions of degree d − 1 to those of degree d.
    ///
    /// Each G_i^{d−1} is split in two: the part w goes to G_i^d, which is the next place in the list as it begins one
    /// index lower, and the part 1 − w to G_{i−1}^d, which is the same place.
    ///
    /// # Panics
    /// Unless j < m and 0 < d < m.
    pub fn raise<W: Split<Scalar = S>>(&mut self, weights: &W, span: Span, d: usize, m: usize) {
        assert!(
            span.index() < m && 0 < d && d < m,
            "a span of index {} and degree {d} for m = {m}",
            span.index()
        );
        for place in 0..self.count {
            let (i, value) = (self.first + place, &mut self.values[place]);
            match (i + d < m, i > 0) {
                (true, true) => weights.split(i, d, value, &mut self.own),
                (true, false) => weights.own(i, d, value, &mut self.own),
                (false, true) => weights.rest(i, d, value),
                (false, false) => {}
            }
            if place > 0 {
                value.accumulate(&self.carry);
            }
            std::mem::swap(&mut self.own, &mut self.carry);
        }
        // G_{m−d}^d does not exist.
        if span.index() < m - d {
            if self.values.len() == self.count {
                self.values.push(self.carry.clone());
            } else {
                std::mem::swap(&mut self.values[self.count], &mut self.carry);
            }
            self.count += 1;
        }
        // Neither does G_{−1}^d: the first place holds nothing.
        if span.index() < d {
            self.values[..self.count].rotate_left(1);
            self.count -= 1;
        } else {
            self.first -= 1;
        }
    }
}

/// The points d_i^r of de Boor's algorithm (T4.1) on the span [t_j, t_{j+1}): entry r of the result holds
/// d_{j−k+r}^r, …, d_j^r, so the last entry is the one point of the curve.
///
/// `points` are the k + 1 control points d_{j−k}, …, d_j, each a list of as many coordinates:
///
/// d_i^{r+1} = w_i^{k−r} d_i^r + (1 − w_i^{k−r}) d_{i−1}^r.
///
/// `None` if there is no point, if there are more than j + 1, or if they differ in their number of coordinates.
pub fn de_boor<W: Weights>(
    weights: &W,
    span: Span,
    points: &[Vec<W::Scalar>],
) -> Option<Vec<Active<Vec<W::Scalar>>>> {
    let degree = points.len().checked_sub(1)?;
    if points.iter().any(|point| point.len() != points[0].len()) {
        return None;
    }
    let mut levels = vec![Active { first: span.index().checked_sub(degree)?, values: points.to_vec() }];
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
    Some(levels)
}
