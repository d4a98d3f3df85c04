//! The weight of any family on an interval, as forms; and all weights of a member on knots.

use std::collections::BTreeMap;
use std::sync::Arc;

use num_rational::BigRational;
use num_traits::{Signed, Zero};
use thiserror::Error;

use crate::scalar::{RationalAlgebra, Ring, integer};

use super::knots::{KnotVector, Span};
use super::weight::Weights;

/// A weight on an interval [a, b] by binary forms of one degree N in p = x − a and q = b − x:
///
/// w = rise/over, 1 − w = fall/over,  rise = Σ c_l p^l q^(N−l), fall = Σ e_l p^l q^(N−l), over = rise + fall.
///
/// Where the two shares do not add up to 1, `over` is a form of its own.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Forms<C = BigRational> {
    rise: Vec<C>,
    fall: Vec<C>,
    over: Vec<C>,
}

/// Which of the conditions fails that make the functions positive for free.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum Obligation {
    /// A coefficient below 0.
    #[error("the coefficient of p^{power} in {part} is negative")]
    Negative {
        /// `rise` or `fall`.
        part: &'static str,
        /// l.
        power: usize,
    },
    /// c_0 ≠ 0, or e_N ≠ 0.
    #[error("{part} is not 0 at its own end of the interval")]
    NotZero {
        /// `rise` or `fall`.
        part: &'static str,
    },
    /// c_N = 0, or e_0 = 0.
    #[error("{part} is 0 at the other end of the interval")]
    Zero {
        /// `rise` or `fall`.
        part: &'static str,
    },
    /// over ≠ rise + fall.
    #[error("the two shares do not add up to 1")]
    Shares,
}

impl Forms {
    /// Forms by their coefficients c_0, …, c_N; `over` is rise + fall, if it is not given. `None`, if they have not one degree.
    #[must_use]
    pub fn new(
        rise: Vec<BigRational>,
        fall: Vec<BigRational>,
        over: Option<Vec<BigRational>>,
    ) -> Option<Self> {
        let over = over.unwrap_or_else(|| rise.iter().zip(&fall).map(|(c, e)| c + e).collect());
        let one_degree = !rise.is_empty() && rise.len() == fall.len() && rise.len() == over.len();
        one_degree.then_some(Self { rise, fall, over })
    }

    /// Coefficients ≥ 0, c_0 = e_N = 0 < c_N, e_0, and shares that add up to 1: then every function is ≥ 0, positive inside of
    /// its support, and no denominator has a zero on the interval.
    ///
    /// # Errors
    /// The first of these that fails.
    pub fn obligations(&self) -> Result<(), Obligation> {
        let last = self.rise.len() - 1;
        for (part, form, own, other) in [("rise", &self.rise, 0, last), ("fall", &self.fall, last, 0)] {
            if let Some(power) = form.iter().position(Signed::is_negative) {
                return Err(Obligation::Negative { part, power });
            }
            if !Zero::is_zero(&form[own]) {
                return Err(Obligation::NotZero { part });
            }
            if Zero::is_zero(&form[other]) {
                return Err(Obligation::Zero { part });
            }
        }
        let sums = self.rise.iter().zip(&self.fall).zip(&self.over).all(|((c, e), o)| &(c + e) == o);
        if sums { Ok(()) } else { Err(Obligation::Shares) }
    }

    /// Is rise : fall the same ratio of functions?
    #[must_use]
    pub fn is_proportional(&self, other: &Self) -> bool {
        let product = |a: &[BigRational], b: &[BigRational]| {
            let mut all = vec![integer(0); a.len() + b.len() - 1];
            for (i, a) in a.iter().enumerate() {
                b.iter().enumerate().for_each(|(j, b)| all[i + j] += a * b);
            }
            all
        };
        product(&self.rise, &other.fall) == product(&self.fall, &other.rise)
    }

    /// w and 1 − w at x of [a, b]; `None` where over is 0.
    #[must_use]
    pub fn shares<S: RationalAlgebra>(&self, x: &S, a: &BigRational, b: &BigRational) -> Option<(S, S)> {
        let (p, q) = (x.minus(&x.embed(a)), x.embed(b).minus(x));
        let [rise, fall, over] = self.values(&p, &q, |c| x.embed(c));
        Some((rise.over(&over)?, fall.over(&over)?))
    }

    /// ρ/σ of a linear weight ρp : σq with both > 0.
    #[must_use]
    pub fn slope_ratio(&self) -> Option<BigRational> {
        (self.rise.len() == 2 && self.obligations().is_ok()).then(|| &self.rise[1] / &self.fall[0])
    }
}

impl<C> Forms<C> {
    /// N.
    #[must_use]
    pub fn degree(&self) -> usize {
        self.rise.len() - 1
    }

    /// With coefficients of another kind.
    #[must_use]
    pub fn map<D>(&self, image: impl Fn(&C) -> D) -> Forms<D> {
        let list = |form: &[C]| form.iter().map(&image).collect();
        Forms { rise: list(&self.rise), fall: list(&self.fall), over: list(&self.over) }
    }

    /// rise, fall and over at p and q of any ring, in which `embed` has the coefficients.
    pub fn values<S: Ring>(&self, p: &S, q: &S, embed: impl Fn(&C) -> S) -> [S; 3] {
        let powers = |of: &S| {
            let mut powers = vec![of.one()];
            (1..self.rise.len()).for_each(|l| powers.push(powers[l - 1].times(of)));
            powers
        };
        let (p, q) = (powers(p), powers(q));
        let value = |form: &[C]| {
            let terms = form.iter().map(&embed).enumerate().filter(|(_, c)| !c.is_zero());
            let term = |(l, c): (usize, S)| c.times(&p[l]).times(&q[form.len() - 1 - l]);
            terms.map(term).fold(p[0].zero(), |sum, term| sum.plus(&term))
        };
        [value(&self.rise), value(&self.fall), value(&self.over)]
    }
}

/// The weights of a member of any family on knots, for the degrees up to k: one for each interval [t_i, t_{i+d}] and each
/// span in it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct FormTable {
    forms: Arc<BTreeMap<(usize, usize, usize), Forms>>,
}

impl FormTable {
    /// From the forms of w_i^d on span j; `make` is given (j, i, d).
    ///
    /// # Errors
    /// The first of `make`.
    pub fn new<E>(
        knots: &KnotVector,
        degree: usize,
        mut make: impl FnMut(usize, usize, usize) -> Result<Forms, E>,
    ) -> Result<Self, E> {
        let mut forms = BTreeMap::new();
        for j in knots.spans().map(Span::index) {
            for d in 1..=degree {
                for i in (j + 1).saturating_sub(d)..=j.min(knots.m().saturating_sub(d)) {
                    if i + d <= knots.m() && i + d > j {
                        forms.insert((j, i, d), make(j, i, d)?);
                    }
                }
            }
        }
        Ok(Self { forms: Arc::new(forms) })
    }

    /// Those of w_i^d on span j.
    #[must_use]
    pub fn get(&self, j: usize, i: usize, d: usize) -> Option<&Forms> {
        self.forms.get(&(j, i, d))
    }

    /// w_i^d and 1 − w_i^d at any scalar x of the closed span.
    pub fn at<'a, S: RationalAlgebra>(
        &'a self,
        knots: &'a KnotVector,
        span: Span,
        x: &'a S,
    ) -> impl Weights<Scalar = S> + 'a {
        Pairs::new(x, move |i, d| {
            let forms = self.get(span.index(), i, d);
            // Where over is 0 there is no value, and nobody asks for one.
            forms
                .and_then(|forms| forms.shares(x, knots.t(i), knots.t(i + d)))
                .unwrap_or_else(|| (x.zero(), x.one()))
        })
    }

    /// All of them, by (j, i, d).
    pub fn iter(&self) -> impl Iterator<Item = ((usize, usize, usize), &Forms)> {
        self.forms.iter().map(|(place, forms)| (*place, forms))
    }
}

/// Weights by a rule for pairs (w_i^d, 1 − w_i^d), over any ring.
pub struct Pairs<S, F> {
    one: S,
    pair: F,
}

impl<S: Ring, F: Fn(usize, usize) -> (S, S)> Pairs<S, F> {
    /// The pairs of a rule, in the ring that `like` belongs to.
    pub fn new(like: &S, pair: F) -> Self {
        Self { one: like.one(), pair }
    }
}

impl<S: Ring, F: Fn(usize, usize) -> (S, S)> Weights for Pairs<S, F> {
    type Scalar = S;

    fn one(&self) -> S {
        self.one.clone()
    }

    fn pair(&self, i: usize, d: usize) -> (S, S) {
        (self.pair)(i, d)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn forms(rise: &[i64], fall: &[i64]) -> Forms {
        let all = |c: &[i64]| c.iter().map(|c| integer(*c)).collect();
        Forms::new(all(rise), all(fall), None).unwrap()
    }

    #[test]
    fn each_obligation_is_told() {
        let told = |rise: &[i64], fall: &[i64]| forms(rise, fall).obligations();
        assert_eq!(told(&[0, 2], &[1, 0]), Ok(()));
        assert_eq!(told(&[0, -1], &[1, 0]), Err(Obligation::Negative { part: "rise", power: 1 }));
        assert_eq!(told(&[0, 1], &[1, -1]), Err(Obligation::Negative { part: "fall", power: 1 }));
        assert_eq!(told(&[1, 1], &[1, 0]), Err(Obligation::NotZero { part: "rise" }));
        assert_eq!(told(&[0, 1], &[1, 1]), Err(Obligation::NotZero { part: "fall" }));
        assert_eq!(told(&[0, 1, 0], &[1, 0, 0]), Err(Obligation::Zero { part: "rise" }));
        assert_eq!(told(&[0, 0, 1], &[0, 1, 0]), Err(Obligation::Zero { part: "fall" }));
        let over =
            Forms::new(vec![integer(0), integer(1)], vec![integer(1), integer(0)], Some(vec![integer(2); 2]));
        assert_eq!(over.unwrap().obligations(), Err(Obligation::Shares));
        assert!(Forms::new(vec![integer(0)], vec![integer(1), integer(0)], None).is_none());
    }
}
