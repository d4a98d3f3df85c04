//! The structures that the rest of the library asks for, weakest first.
//!
//! An algorithm states the weakest one that it needs: the triangle of the paper asks for a [`Ring`], the
//! weight at a point for a [`RationalAlgebra`], a verdict for an [`ExactField`].

use std::cmp::Ordering;
use std::fmt::Debug;

use num_rational::BigRational;

/// What can be added up in place.
pub trait Additive: Clone {
    /// self ← self + rhs, in its own memory where it has any.
    fn accumulate(&mut self, rhs: &Self);
}

impl<R: Ring> Additive for R {
    fn accumulate(&mut self, rhs: &Self) {
        self.increase(rhs);
    }
}

/// A commutative ring with 1, as a type of elements.
///
/// `zero` and `one` are taken from an element, since a ring may need more than its type to be known (a
/// [`Jet`](super::Jet) has an order). All operations are total. The laws are checked by
/// [`axioms::ring`](super::axioms::ring).
pub trait Ring: Clone + PartialEq + Debug {
    /// 0 of the ring that `self` belongs to.
    fn zero(&self) -> Self;
    /// 1 of the ring that `self` belongs to.
    fn one(&self) -> Self;
    /// self + rhs.
    fn plus(&self, rhs: &Self) -> Self;
    /// self − rhs.
    fn minus(&self, rhs: &Self) -> Self {
        self.plus(&rhs.negate())
    }
    /// self · rhs.
    fn times(&self, rhs: &Self) -> Self;
    /// −self.
    fn negate(&self) -> Self;

    /// self ← self + rhs; to be overridden by what has memory of its own to do it in.
    fn increase(&mut self, rhs: &Self) {
        *self = self.plus(rhs);
    }

    /// self ← self·a + other·b; to be overridden as [`increase`](Self::increase).
    fn combine(&mut self, a: &Self, other: &Self, b: &Self) {
        *self = self.times(a).plus(&other.times(b));
    }

    /// Is this the 0 of its ring?
    fn is_zero(&self) -> bool {
        *self == self.zero()
    }

    /// Is this a number that is certainly < 0? `false` also for what is no number, such as a variable.
    fn certainly_negative(&self) -> bool {
        false
    }

    /// self^exponent, by repeated squaring; self⁰ = 1, also for 0.
    fn power(&self, exponent: usize) -> Self {
        let (mut result, mut base, mut left) = (self.one(), self.clone(), exponent);
        while left > 0 {
            if left % 2 == 1 {
                result = result.times(&base);
            }
            left /= 2;
            if left > 0 {
                base = base.times(&base);
            }
        }
        result
    }

    /// The first `length` coefficients of the product of two polynomials, by rising powers as are those given, of which
    /// there is at least one each; at most as many as the product has. To be overridden where that costs less than
    /// products and sums one by one.
    fn product_of_polynomials(a: &[Self], b: &[Self], length: usize) -> Vec<Self> {
        let coefficient = |n: usize| {
            let (first, last) = (n.saturating_sub(b.len() - 1), n.min(a.len() - 1));
            let pairs = a[first..=last].iter().zip(b[n - last..=n - first].iter().rev());
            let mut terms = pairs.filter(|(a, b)| !a.is_zero() && !b.is_zero()).map(|(a, b)| a.times(b));
            match terms.next() {
                Some(term) => terms.fold(term, |sum, term| sum.plus(&term)),
                None => a[0].zero(),
            }
        };
        (0..length.min(a.len() + b.len() - 1)).map(coefficient).collect()
    }

    /// The value of a polynomial at u, by Horner's rule; to be overridden likewise.
    fn value_of_polynomial(coefficients: &[Self], u: &Self) -> Self {
        let mut coefficients = coefficients.iter().rev();
        let leading = coefficients.next().map_or_else(|| u.zero(), Self::clone);
        coefficients.fold(leading, |value, c| value.times(u).plus(c))
    }
}

/// What can be multiplied in place by factors of another, simpler kind: integers of any size by machine words,
/// polynomials by linear ones.
pub trait ScaleBy<F>: Additive {
    /// self ← self·∏ factors.
    fn scale_by<'a>(&mut self, factors: impl Iterator<Item = &'a F>)
    where
        F: 'a;
}

/// A commutative ring that contains an image of the rational numbers and knows its units.
pub trait RationalAlgebra: Ring {
    /// The image of `value` in the ring that `self` belongs to; rounded to nearest where the ring is inexact.
    fn embed(&self, value: &BigRational) -> Self;

    /// The inverse, if there is one.
    fn reciprocal(&self) -> Option<Self>;

    /// Is this a point that is not in [low, high]? Of a jet its point counts, NaN is in no interval, and what is no
    /// point, such as a variable, is `false`.
    fn lies_outside(&self, _low: &BigRational, _high: &BigRational) -> bool {
        false
    }

    /// self / rhs, if `rhs` is a unit.
    fn over(&self, rhs: &Self) -> Option<Self> {
        Some(self.times(&rhs.reciprocal()?))
    }

    /// self/(self + rhs) and rhs/(self + rhs), if the sum is a unit.
    fn shares(&self, rhs: &Self) -> Option<(Self, Self)> {
        let inverse = self.plus(rhs).reciprocal()?;
        Some((self.times(&inverse), rhs.times(&inverse)))
    }
}

/// A [`RationalAlgebra`] in which every element except 0 is a unit.
pub trait Field: RationalAlgebra {
    /// Quotient and remainder of two polynomials, given by their coefficients as for
    /// [`product_of_polynomials`](Ring::product_of_polynomials): the remainder is shorter than the divisor, and a list
    /// may be empty for 0. `None` if the leading coefficient of the divisor is 0. To be overridden likewise.
    fn quotient_of_polynomials(dividend: &[Self], divisor: &[Self]) -> Option<(Vec<Self>, Vec<Self>)> {
        let inverse = divisor.last()?.reciprocal()?;
        let mut remainder = dividend.to_vec();
        let mut quotient = Vec::new();
        while remainder.len() >= divisor.len() {
            let factor = match remainder.last() {
                Some(leading) => leading.times(&inverse),
                None => break,
            };
            let shift = remainder.len() - divisor.len();
            for (i, c) in divisor.iter().enumerate() {
                remainder[shift + i] = remainder[shift + i].minus(&factor.times(c));
            }
            remainder.pop();
            quotient.push(factor);
        }
        quotient.reverse();
        Some((quotient, remainder))
    }

    /// The monic greatest common divisor of two polynomials, by Euclid's algorithm; 0 only for two zeros. To be
    /// overridden likewise.
    fn gcd_of_polynomials(a: &[Self], b: &[Self]) -> Vec<Self> {
        let monic = |list: &[Self]| -> Vec<Self> {
            let degree = list.iter().rposition(|c| !c.is_zero()).unwrap_or(0);
            match list[degree].reciprocal() {
                Some(inverse) => list[..=degree].iter().map(|c| c.times(&inverse)).collect(),
                None => list[..=degree].to_vec(),
            }
        };
        let (mut a, mut b) = (monic(a), monic(b));
        while let Some((_, remainder)) = Self::quotient_of_polynomials(&a, &b) {
            let remainder = if remainder.is_empty() { vec![a[0].zero()] } else { remainder };
            (a, b) = (b, monic(&remainder));
        }
        a
    }
}

/// A [`Field`] in which `==` and every operation are those of mathematics: no rounding.
///
/// Only such scalars can lead to a verdict. `f64` is a [`Field`] here and never an `ExactField`; the
/// [crate documentation](crate#floats-cannot-prove) shows that the compiler holds to it.
pub trait ExactField: Field {}

/// A [`Field`] with an order that agrees with its operations.
pub trait OrderedField: Field + PartialOrd {
    /// The sign of self as its comparison with 0; `None` where there is none (a float's NaN).
    fn sign(&self) -> Option<Ordering> {
        self.partial_cmp(&self.zero())
    }
}
