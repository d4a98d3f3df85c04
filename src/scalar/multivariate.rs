//! Polynomials in many variables over the integers.

use std::collections::BTreeMap;
use std::fmt;

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Signed};

use super::gcd::gcd;
use super::modular;
use super::monomial::Monomial;
use super::product::{Terms, degrees, merged, product};
use super::ring::{RationalAlgebra, Ring};

/// Σ c·x₀^e₀·x₁^e₁·… with integers c, exactly: r, the span coordinate u and the gaps between knots as variables.
///
/// The terms are sorted by falling [`Monomial`], each monomial once and no coefficient 0: so `==` is equality
/// of polynomials. `Ord` is a total order without meaning in mathematics, for sorted lists and maps.
///
/// Exponents go up to [`Monomial::BOUND`] = 127 in each variable. An operation whose result exceeds that
/// **panics** (a bug of the caller, who has to know the degrees); nothing ever wraps.
///
/// ```
/// use knotproof::scalar::{Multivariate, Ring};
///
/// let (r, u) = (Multivariate::variable(0), Multivariate::variable(1));
/// let square = r.times(&u).plus(&r.one()).power(2);
/// assert_eq!(square.to_string(), "x0^2·x1^2 + 2·x0·x1 + 1");
/// assert_eq!(square.minus(&square), r.zero());
/// ```
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Multivariate {
    terms: Terms,
}

impl Multivariate {
    /// The number of variables there are, as in [`Monomial::VARIABLES`].
    pub const VARIABLES: usize = Monomial::VARIABLES;

    /// The constant polynomial.
    #[must_use]
    pub fn constant(value: impl Into<BigInt>) -> Self {
        Self::from_terms([(Monomial::ONE, value.into())])
    }

    /// x_v.
    ///
    /// # Panics
    /// If v ≥ [`Multivariate::VARIABLES`]: this is a bug of the caller.
    #[must_use]
    pub fn variable(v: usize) -> Self {
        Self::from(Monomial::variable(v))
    }

    /// Σ c·m over terms in any order, in which monomials may repeat.
    ///
    /// ```
    /// use knotproof::scalar::{Monomial, Multivariate, Ring};
    ///
    /// let x = Monomial::variable(0);
    /// let p = Multivariate::from_terms([(Monomial::ONE, 5.into()), (x, 2.into()), (Monomial::ONE, (-5).into())]);
    /// assert_eq!(p, Multivariate::variable(0).scaled(&2.into()));
    /// ```
    #[must_use]
    pub fn from_terms(terms: impl IntoIterator<Item = (Monomial, BigInt)>) -> Self {
        let mut sums = BTreeMap::new();
        for (m, c) in terms {
            *sums.entry(m).or_insert(BigInt::ZERO) += c;
        }
        Self { terms: sums.into_iter().rev().filter(|(_, c)| *c != BigInt::ZERO).collect() }
    }

    /// The terms by falling monomial, coefficients other than 0; none for 0.
    pub fn terms(&self) -> impl DoubleEndedIterator<Item = (&Monomial, &BigInt)> + ExactSizeIterator {
        self.terms.iter().map(|(m, c)| (m, c))
    }

    /// The term with the largest monomial; `None` for 0.
    #[must_use]
    pub fn leading(&self) -> Option<(&Monomial, &BigInt)> {
        self.terms().next()
    }

    /// The value of a constant; `None` if a variable occurs.
    ///
    /// ```
    /// use knotproof::scalar::Multivariate;
    ///
    /// assert_eq!(Multivariate::constant(7).as_constant(), Some(7.into()));
    /// assert_eq!(Multivariate::constant(0).as_constant(), Some(0.into()));
    /// assert_eq!(Multivariate::variable(3).as_constant(), None);
    /// ```
    #[must_use]
    pub fn as_constant(&self) -> Option<BigInt> {
        match self.terms.as_slice() {
            [] => Some(BigInt::ZERO),
            [(Monomial::ONE, c)] => Some(c.clone()),
            _ => None,
        }
    }

    /// The degree in x_v; 0 where it does not occur, and for the polynomial 0.
    ///
    /// # Panics
    /// If v ≥ [`Multivariate::VARIABLES`]: this is a bug of the caller.
    #[must_use]
    pub fn degree_in(&self, v: usize) -> usize {
        self.terms.iter().map(|(m, _)| m.exponent(v)).max().unwrap_or(0)
    }

    /// Of each variable that occurs the degree, as one monomial: the least that every monomial here divides.
    #[must_use]
    pub fn degrees(&self) -> Monomial {
        degrees(&self.terms)
    }

    /// The value modulo a prime at a place that is the same for all: where two values differ, so do the polynomials.
    pub(super) fn residue(&self) -> u64 {
        let power = |(v, e): (usize, usize)| modular::power(modular::coordinate(v), e as u64);
        let term = |(m, c): &(Monomial, BigInt)| {
            m.exponents().map(power).fold(modular::residue(c), modular::product)
        };
        self.terms.iter().map(term).fold(0, modular::sum)
    }

    /// The variables that occur, rising.
    ///
    /// ```
    /// use knotproof::scalar::{Multivariate, Ring};
    ///
    /// let p = Multivariate::variable(40).times(&Multivariate::variable(2)).plus(&Multivariate::constant(1));
    /// assert_eq!(p.variables().collect::<Vec<_>>(), [2, 40]);
    /// ```
    pub fn variables(&self) -> impl Iterator<Item = usize> + use<> {
        self.degrees().exponents().map(|(v, _)| v)
    }

    /// c₀, c₁, …, c_n with self = Σ c_e·x_v^e, n = [`Multivariate::degree_in`] v and no x_v in any c_e.
    ///
    /// ```
    /// use knotproof::scalar::{Multivariate, Ring};
    ///
    /// let (r, u) = (Multivariate::variable(0), Multivariate::variable(1));
    /// let p = r.plus(&u.times(&u).times(&r)).plus(&r.one());
    /// assert_eq!(p.coefficients_in(1), [r.plus(&r.one()), r.zero(), r]);
    /// ```
    ///
    /// # Panics
    /// If v ≥ [`Multivariate::VARIABLES`]: this is a bug of the caller.
    #[must_use]
    pub fn coefficients_in(&self, v: usize) -> Vec<Self> {
        let mut coefficients = vec![self.zero(); self.degree_in(v) + 1];
        for (m, c) in &self.terms {
            // The order of the rest is the order of the terms as long as the exponent of x_v is the same.
            coefficients[m.exponent(v)].terms.push((m.with(v, 0), c.clone()));
        }
        coefficients
    }

    /// factor·self.
    #[must_use]
    pub fn scaled(&self, factor: &BigInt) -> Self {
        if factor.is_one() {
            return self.clone();
        }
        self.times(&Self::constant(factor.clone()))
    }

    /// The greatest common divisor of the coefficients: positive, and 0 for 0 alone.
    #[must_use]
    pub fn content(&self) -> BigInt {
        self.common_divisor(BigInt::ZERO)
    }

    /// gcd of `with` ≥ 0 and all coefficients.
    pub(super) fn common_divisor(&self, with: BigInt) -> BigInt {
        let mut divisor = with;
        for (_, c) in &self.terms {
            if divisor.is_one() {
                break;
            }
            divisor = gcd(&divisor, c);
        }
        divisor
    }

    /// The greatest monomial that divides every term; 1 for 0.
    #[must_use]
    pub fn common_monomial(&self) -> Monomial {
        self.terms.iter().map(|(m, _)| *m).reduce(|a, b| a.gcd(&b)).unwrap_or(Monomial::ONE)
    }

    /// (c, m, P) with self = c·m·P, where P has content 1, a positive leading coefficient and no variable that
    /// divides it; `None` for 0. Two polynomials are multiples of each other by terms if and only if their P
    /// are equal.
    ///
    /// ```
    /// use knotproof::scalar::{Monomial, Multivariate, Ring};
    ///
    /// let (r, u) = (Multivariate::variable(0), Multivariate::variable(1));
    /// let p = r.plus(&r.times(&u)).scaled(&(-6).into());
    /// assert_eq!(p.split(), Some(((-6).into(), Monomial::variable(0), u.plus(&u.one()))));
    /// ```
    #[must_use]
    pub fn split(&self) -> Option<(BigInt, Monomial, Self)> {
        let (_, leading) = self.leading()?;
        let content = if leading.is_negative() { -self.content() } else { self.content() };
        let monomial = self.common_monomial();
        let rest = self.over_term(&content, &monomial);
        Some((content, monomial, rest))
    }

    /// self/(c·m) for a term that divides every one here.
    pub(super) fn over_term(&self, c: &BigInt, m: &Monomial) -> Self {
        if c.is_one() && *m == Monomial::ONE {
            return self.clone();
        }
        let divide = |(n, d): &(Monomial, BigInt)| match n.divided_by(m) {
            Some(n) => (n, d / c),
            None => unreachable!("{m} divides every monomial of {self}"),
        };
        Self { terms: self.terms.iter().map(divide).collect() }
    }

    /// The polynomial q with self = q·divisor, if there is one over the integers; `None` for divisor 0.
    ///
    /// Leading term by leading term. A quotient has its degrees in each variable from the start, so the
    /// attempt ends as soon as one is exceeded.
    ///
    /// ```
    /// use knotproof::scalar::{Multivariate, Ring};
    ///
    /// let (r, u) = (Multivariate::variable(0), Multivariate::variable(1));
    /// let difference = r.times(&r).minus(&u.times(&u));
    /// assert_eq!(difference.divided_by(&r.minus(&u)), Some(r.plus(&u)));
    /// assert_eq!(difference.divided_by(&r.plus(&r)), None);
    /// ```
    #[must_use]
    pub fn divided_by(&self, divisor: &Self) -> Option<Self> {
        let (leading, c) = divisor.leading()?;
        if self.is_zero() {
            return Some(self.zero());
        }
        let bound = self.degrees().divided_by(&divisor.degrees())?;
        let mut remainder: BTreeMap<Monomial, BigInt> = self.terms.iter().cloned().collect();
        let mut quotient = Vec::new();
        while let Some((m, d)) = remainder.pop_last() {
            let m = m.divided_by(leading)?;
            bound.divided_by(&m)?;
            let (d, rest) = d.div_rem(c);
            if rest != BigInt::ZERO {
                return None;
            }
            for (n, e) in divisor.terms.iter().skip(1) {
                let at = m.times(n);
                let sum = remainder.entry(at).or_default();
                *sum -= &d * e;
                if *sum == BigInt::ZERO {
                    remainder.remove(&at);
                }
            }
            quotient.push((m, d));
        }
        Some(Self { terms: quotient })
    }

    /// self with `value` in the place of x_v, by Horner's rule.
    ///
    /// ```
    /// use knotproof::scalar::{Multivariate, Ring};
    ///
    /// let (r, u) = (Multivariate::variable(0), Multivariate::variable(1));
    /// let p = u.times(&u).plus(&r.times(&u));
    /// assert_eq!(p.substitute(1, &Multivariate::constant(3)).to_string(), "3·x0 + 9");
    /// ```
    ///
    /// # Panics
    /// If v ≥ [`Multivariate::VARIABLES`], or if an exponent of the result exceeds [`Monomial::BOUND`]: these
    /// are bugs of the caller.
    #[must_use]
    pub fn substitute(&self, v: usize, value: &Self) -> Self {
        let horner = |sum: Self, c: &Self| sum.times(value).plus(c);
        self.coefficients_in(v).iter().rev().fold(self.zero(), horner)
    }

    /// The value with `point(v)` in the place of every x_v that occurs, in the algebra that `like` belongs to:
    /// a number at a point, a rational function along a curve.
    ///
    /// ```
    /// use knotproof::scalar::{Multivariate, Ring, rational};
    ///
    /// let p = Multivariate::variable(0).times(&Multivariate::variable(1)).plus(&Multivariate::constant(1));
    /// let at = [rational(1, 2), rational(2, 3)];
    /// assert_eq!(p.evaluate(&at[0], |v| at[v].clone()), rational(4, 3));
    /// ```
    #[must_use]
    pub fn evaluate<S: RationalAlgebra>(&self, like: &S, point: impl Fn(usize) -> S) -> S {
        let powers_of = |(v, degree): (usize, usize)| {
            let (x, mut powers) = (point(v), vec![like.one()]);
            for e in 0..degree {
                powers.push(powers[e].times(&x));
            }
            (v, powers)
        };
        let powers: BTreeMap<usize, Vec<S>> = self.degrees().exponents().map(powers_of).collect();
        let term = |(m, c): &(Monomial, BigInt)| {
            let c = like.embed(&BigRational::from_integer(c.clone()));
            m.exponents().fold(c, |product, (v, e)| product.times(&powers[&v][e]))
        };
        self.terms.iter().fold(like.zero(), |sum, t| sum.plus(&term(t)))
    }
}

/// The monomial with coefficient 1.
impl From<Monomial> for Multivariate {
    fn from(m: Monomial) -> Self {
        Self { terms: vec![(m, BigInt::from(1))] }
    }
}

impl Ring for Multivariate {
    fn zero(&self) -> Self {
        Self { terms: Vec::new() }
    }
    fn one(&self) -> Self {
        Self::from(Monomial::ONE)
    }
    fn plus(&self, rhs: &Self) -> Self {
        Self { terms: merged(self.terms.iter().cloned(), rhs.terms.iter().cloned()) }
    }
    fn minus(&self, rhs: &Self) -> Self {
        let negated = rhs.terms.iter().map(|(m, c)| (*m, -c));
        Self { terms: merged(self.terms.iter().cloned(), negated) }
    }
    fn times(&self, rhs: &Self) -> Self {
        super::spend();
        Self { terms: product(&self.terms, &rhs.terms) }
    }
    fn negate(&self) -> Self {
        Self { terms: self.terms.iter().map(|(m, c)| (*m, -c)).collect() }
    }
    fn is_zero(&self) -> bool {
        self.terms.is_empty()
    }
}

/// As in `2·x0^2·x1 - x3 + 5`.
impl fmt::Display for Multivariate {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.is_zero() {
            return f.write_str("0");
        }
        for (at, (m, c)) in self.terms().enumerate() {
            f.write_str(match (at, c.is_negative()) {
                (0, false) => "",
                (0, true) => "-",
                (_, false) => " + ",
                (_, true) => " - ",
            })?;
            match (*m == Monomial::ONE, c.magnitude().is_one()) {
                (true, _) => write!(f, "{}", c.magnitude())?,
                (false, true) => write!(f, "{m}")?,
                (false, false) => write!(f, "{}·{m}", c.magnitude())?,
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn x(v: usize) -> Multivariate {
        Multivariate::variable(v)
    }

    #[test]
    fn terms_are_sorted_and_none_is_zero() {
        let p = x(1).plus(&x(0)).plus(&x(47)).times(&x(0).minus(&x(1)));
        assert_eq!(p.to_string(), "x0^2 + x0·x47 - x1^2 - x1·x47");
        assert!(p.terms().is_sorted_by(|a, b| a.0 > b.0));
        assert_eq!(p.minus(&p).terms().len(), 0);
        assert_eq!(Multivariate::constant(0), p.zero());
        assert_eq!(p.negate().negate(), p);
    }

    #[test]
    fn content_and_sign_are_split_off() {
        let p = x(0).times(&x(2)).scaled(&4.into()).minus(&x(2).power(3).scaled(&6.into())).negate();
        assert_eq!(p.content(), 2.into());
        let (c, m, rest) = p.split().expect("not 0");
        assert_eq!((c, m), ((-2).into(), Monomial::variable(2)));
        assert_eq!(rest.to_string(), "2·x0 - 3·x2^2");
        assert_eq!(p.zero().split(), None);
        assert_eq!(p.zero().content(), 0.into());
    }

    /// At the bound a product is right, above it there is none: in every way that a product is computed.
    #[test]
    fn degree_127_is_the_last() {
        let binomial = |v| x(v).plus(&x(5));
        for v in [0, 7, 8, 47] {
            let largest = x(v).power(127);
            assert_eq!(largest.degree_in(v), 127);
            assert_eq!(binomial(v).power(127).terms().len(), 128);
            for factor in [x(v), binomial(v)] {
                for product in [largest.clone(), binomial(v).power(127)] {
                    assert!(std::panic::catch_unwind(|| product.times(&factor)).is_err());
                }
            }
            assert!(std::panic::catch_unwind(|| largest.substitute(v, &x(0).power(2))).is_err());
        }
    }

    #[test]
    fn there_is_no_quotient_but_the_exact_one() {
        let (p, q) = (x(0).plus(&x(1)), x(0).minus(&x(1)).scaled(&2.into()));
        assert_eq!(p.times(&q).divided_by(&q), Some(p.clone()));
        assert_eq!(p.times(&q).divided_by(&p.power(2)), None);
        assert_eq!(p.divided_by(&q), None);
        assert_eq!(p.scaled(&3.into()).divided_by(&Multivariate::constant(2)), None);
        assert_eq!(p.divided_by(&p.zero()), None);
        assert_eq!(p.zero().divided_by(&p), Some(p.zero()));
        // x0^2 + 1 has the right leading term for x0 + 1 and for x0 − x1, and fails in the remainder.
        let p = x(0).power(2).plus(&p.one());
        assert_eq!(p.divided_by(&x(0).plus(&p.one())), None);
        assert_eq!(p.divided_by(&x(0).minus(&x(1))), None);
    }
}
