//! The weights of the recursion: D2.3 at a point, and free ones.

use num_rational::BigRational;

use crate::scalar::{Additive, RationalAlgebra, Ring};

use super::knots::KnotVector;

/// Where the triangle gets its weights from, on one span.
pub trait Weights {
    /// What the triangle is run over.
    type Scalar: Ring;

    /// 1 of the scalars.
    fn one(&self) -> Self::Scalar;

    /// (w_i^d, 1 − w_i^d), for an interval [t_i, t_{i+d}] that contains the span.
    fn pair(&self, i: usize, d: usize) -> (Self::Scalar, Self::Scalar);
}

/// How a function of degree d − 1 goes over to those of degree d: all that the triangle asks for.
///
/// By [`Weights`], if there are any; or without weights as a whole, where that is faster
/// ([`FractionFree`](super::FractionFree)).
pub trait Split {
    /// What the triangle is run over.
    type Scalar: Additive;

    /// 1 of the scalars.
    fn one(&self) -> Self::Scalar;

    /// Splits G_i^{d−1}: sets `own` to its part of G_i^d, w_i^d·value, then `value` to its part of G_{i−1}^d,
    /// (1 − w_i^d)·value.
    fn split(&self, i: usize, d: usize, value: &mut Self::Scalar, own: &mut Self::Scalar);

    /// Sets `own` to the part of G_i^d alone.
    fn own(&self, i: usize, d: usize, value: &Self::Scalar, own: &mut Self::Scalar);

    /// Sets `value` to its part of G_{i−1}^d alone.
    fn rest(&self, i: usize, d: usize, value: &mut Self::Scalar);

    /// Sets `value` to the 1 of the scalars.
    fn set_one(&self, value: &mut Self::Scalar) {
        *value = self.one();
    }
}

impl<W: Weights> Split for W {
    type Scalar = W::Scalar;

    fn one(&self) -> Self::Scalar {
        Weights::one(self)
    }

    fn split(&self, i: usize, d: usize, value: &mut Self::Scalar, own: &mut Self::Scalar) {
        let (w, complement) = self.pair(i, d);
        *own = w.times(value);
        *value = complement.times(value);
    }

    fn own(&self, i: usize, d: usize, value: &Self::Scalar, own: &mut Self::Scalar) {
        *own = self.pair(i, d).0.times(value);
    }

    fn rest(&self, i: usize, d: usize, value: &mut Self::Scalar) {
        *value = self.pair(i, d).1.times(value);
    }
}

/// The kernel of linear weights, which is φ_α(x, a, b) and 1 − φ_α(x, a, b) for x in [a, b], in the form in which nothing cancels:
///
/// φ = r(x − a) / (r(x − a) + (b − x)),  1 − φ = (b − x) / (r(x − a) + (b − x)).
///
/// Which weights there are is said by the files of families; this is for those whose rise and fall are a number times x − a and
/// b − x, of ratio r, and a test holds it to what
/// `families/mobius.toml` says.
///
/// x may be any scalar: a point, the jet of one, or the span coordinate as a variable. An interval that is
/// empty gives φ = 0, by D2.3; so does one whose ends the scalar cannot tell apart.
pub fn weight<S: RationalAlgebra>(ratio: &S, x: &S, a: &BigRational, b: &BigRational) -> (S, S) {
    if a < b {
        let rise = ratio.times(&x.minus(&x.embed(a)));
        let fall = x.embed(b).minus(x);
        if let Some(shares) = rise.shares(&fall) {
            return shares;
        }
    }
    (x.zero(), x.one())
}

/// The weights w_i^d(x) = φ_α(x, t_i, t_{i+d}) of D3.3 at an x of the closed span.
#[derive(Debug, Clone)]
pub struct PointWeights<'a, S> {
    knots: &'a KnotVector,
    ratio: S,
    x: S,
}

impl<'a, S: RationalAlgebra> PointWeights<'a, S> {
    /// The weights at x for the slope ratio `ratio` = α/(α − 1).
    #[must_use]
    pub fn new(knots: &'a KnotVector, ratio: S, x: S) -> Self {
        Self { knots, ratio, x }
    }
}

impl<S: RationalAlgebra> Weights for PointWeights<'_, S> {
    type Scalar = S;

    fn one(&self) -> S {
        self.x.one()
    }

    fn pair(&self, i: usize, d: usize) -> (S, S) {
        weight(&self.ratio, &self.x, self.knots.t(i), self.knots.t(i + d))
    }
}

/// Weights given by a formula in i and d, over any ring: what holds for them as indeterminates holds for
/// every weight function whatever.
#[derive(Debug, Clone)]
pub struct FormalWeights<S, F> {
    one: S,
    weight: F,
}

impl<S: Ring, F: Fn(usize, usize) -> S> FormalWeights<S, F> {
    /// w_i^d = `weight(i, d)`, in the ring that `like` belongs to.
    #[must_use]
    pub fn new(like: &S, weight: F) -> Self {
        Self { one: like.one(), weight }
    }
}

impl<S: Ring, F: Fn(usize, usize) -> S> Weights for FormalWeights<S, F> {
    type Scalar = S;

    fn one(&self) -> S {
        self.one.clone()
    }

    fn pair(&self, i: usize, d: usize) -> (S, S) {
        let weight = (self.weight)(i, d);
        let complement = self.one.minus(&weight);
        (weight, complement)
    }
}
