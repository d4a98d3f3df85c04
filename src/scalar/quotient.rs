//! Quotients of polynomials in many variables whose denominators stay factored.

use num_bigint::BigInt;
use num_rational::BigRational;

use super::factors::{Factors, as_variable, combined, expanded, factored};
use super::gcd::lcm;
use super::modular;
use super::monomial::Monomial;
use super::multivariate::Multivariate;
use super::ring::{ExactField, Field, RationalAlgebra, Ring};

/// N/(c·F₁^e₁·F₂^e₂·…), exactly: an element of the field of rational functions over ℚ in all variables of
/// [`Multivariate`], with an integer c > 0 and powers of known factors as denominator.
///
/// Each factor is primitive with a positive leading coefficient, and either a variable or divisible by none;
/// there is no factor 1, and the list is sorted. c has no divisor in common with the content of N, and no
/// factor that is a variable divides N. Nothing else is kept in lowest terms: no greatest common divisor of
/// polynomials is ever computed. A sum takes the least common multiple of the lists of factors, a product
/// adds the powers, a reciprocal makes the numerator one new factor; a numerator that *is* a factor, up to a
/// term, cancels. [`Quotient::reduced`] tries the rest by exact division.
///
/// So one function has many representations, and `==` is by hand: it crosses out the common factors and
/// compares N₁·D₂ with N₂·D₁. It is equality of functions. There is no order and no hash.
///
/// Exponents are bounded as in [`Multivariate`]: beyond 127 in one variable an operation panics.
///
/// ```
/// use knotproof::scalar::{Quotient, RationalAlgebra, Ring};
///
/// // φ = ru/(ru + 1), the weight on the interval [0, 1] at x = u/(1 + u), and its complement.
/// let (r, u) = (Quotient::variable(0), Quotient::variable(1));
/// let x = u.over(&u.plus(&u.one())).unwrap();
/// let (w, complement) = r.times(&x).shares(&x.one().minus(&x)).unwrap();
/// assert_eq!(w.numerator().to_string(), "x0·x1");
/// assert_eq!(w.denominator().to_string(), "x0·x1 + 1");
/// assert_eq!(w.plus(&complement), r.one());
/// ```
#[derive(Debug, Clone)]
pub struct Quotient {
    numerator: Multivariate,
    divisor: BigInt,
    factors: Factors,
}

impl Quotient {
    /// numerator/denominator; `None` if the denominator is 0.
    ///
    /// The denominator is taken as one factor: factors that are known apart are better divided by one by one.
    #[must_use]
    pub fn new(numerator: Multivariate, denominator: Multivariate) -> Option<Self> {
        Self::from_polynomial(numerator).over(&Self::from_polynomial(denominator))
    }

    /// The polynomial N as N/1.
    #[must_use]
    pub fn from_polynomial(numerator: Multivariate) -> Self {
        Self { numerator, divisor: BigInt::from(1), factors: Vec::new() }
    }

    /// The constant function.
    #[must_use]
    pub fn constant(value: &BigRational) -> Self {
        let numerator = Multivariate::constant(value.numer().clone());
        Self { numerator, divisor: value.denom().clone(), factors: Vec::new() }
    }

    /// x_v.
    ///
    /// # Panics
    /// If v ≥ [`Multivariate::VARIABLES`]: this is a bug of the caller.
    #[must_use]
    pub fn variable(v: usize) -> Self {
        Self::from_polynomial(Multivariate::variable(v))
    }

    /// N. It may have factors in common with the denominator.
    #[must_use]
    pub fn numerator(&self) -> &Multivariate {
        &self.numerator
    }

    /// c > 0.
    #[must_use]
    pub fn divisor(&self) -> &BigInt {
        &self.divisor
    }

    /// The factors F of the denominator with their powers e ≥ 1, by rising factor.
    ///
    /// ```
    /// use knotproof::scalar::{Quotient, RationalAlgebra, Ring, rational};
    ///
    /// let (r, u) = (Quotient::variable(0), Quotient::variable(1));
    /// let q = r.over(&u.times(&u).times(&r.plus(&u)).times(&r.embed(&rational(-6, 1)))).unwrap();
    /// assert_eq!((q.numerator().to_string(), q.divisor().clone()), ("-x0".to_string(), 6.into()));
    /// let factors: Vec<_> = q.factors().map(|(f, e)| (f.to_string(), e)).collect();
    /// assert_eq!(factors, [("x1".to_string(), 2), ("x0 + x1".to_string(), 1)]);
    /// ```
    pub fn factors(&self) -> impl ExactSizeIterator<Item = (&Multivariate, usize)> {
        self.factors.iter().map(|(factor, power)| (factor.as_ref(), *power))
    }

    /// c·F₁^e₁·F₂^e₂·…, multiplied out.
    #[must_use]
    pub fn denominator(&self) -> Multivariate {
        expanded(&self.factors, &Multivariate::constant(self.divisor.clone()))
    }

    /// The same function with every factor of the denominator crossed out as often as it divides the numerator.
    ///
    /// A factor that is no prime may still have a divisor in common with it.
    ///
    /// ```
    /// use knotproof::scalar::{Quotient, RationalAlgebra, Ring};
    ///
    /// let (r, u) = (Quotient::variable(0), Quotient::variable(1));
    /// let q = r.times(&r).minus(&u.times(&u)).over(&r.plus(&u)).unwrap();
    /// assert_eq!(q.factors().len(), 1);
    /// assert_eq!(q.reduced().factors().len(), 0);
    /// assert_eq!(q.reduced().numerator().to_string(), "x0 - x1");
    /// ```
    #[must_use]
    pub fn reduced(&self) -> Self {
        let mut numerator = self.numerator.clone();
        let mut left = Vec::new();
        for (factor, power) in &self.factors {
            let mut power = *power;
            while power > 0 {
                let Some(quotient) = numerator.divided_by(factor) else { break };
                numerator = quotient;
                power -= 1;
            }
            if power > 0 {
                left.push((factor.clone(), power));
            }
        }
        Self::tidy(numerator, self.divisor.clone(), left)
    }

    /// The function with `value` in the place of x_v; `None` if the denominator becomes 0.
    ///
    /// ```
    /// use knotproof::scalar::{Multivariate, Quotient, RationalAlgebra, Ring, rational};
    ///
    /// let (r, u) = (Quotient::variable(0), Quotient::variable(1));
    /// let q = r.over(&r.minus(&u)).unwrap();
    /// assert_eq!(q.substitute(1, &Multivariate::variable(0)), None);
    /// let at_zero = q.substitute(1, &Multivariate::constant(0));
    /// assert_eq!(at_zero, Some(r.one()));
    /// ```
    ///
    /// # Panics
    /// As [`Multivariate::substitute`] does.
    #[must_use]
    pub fn substitute(&self, v: usize, value: &Multivariate) -> Option<Self> {
        let constant = BigRational::new(BigInt::from(1), self.divisor.clone());
        let mut result = Self::from_polynomial(self.numerator.substitute(v, value));
        for (factor, power) in &self.factors {
            let factor = Self::from_polynomial(factor.substitute(v, value));
            for _ in 0..*power {
                result = result.over(&factor)?;
            }
        }
        Some(result.times(&Self::constant(&constant)))
    }

    /// The value with `point(v)` in the place of every x_v that occurs, in the algebra that `like` belongs to;
    /// `None` if the denominator has no reciprocal there, even if it could be cancelled.
    ///
    /// ```
    /// use knotproof::scalar::{Quotient, RationalAlgebra, Ring, integer, rational};
    ///
    /// let (r, u) = (Quotient::variable(0), Quotient::variable(1));
    /// let q = r.over(&r.plus(&u)).unwrap();
    /// let at = |r: i64, u: i64| q.evaluate(&integer(0), |v| rational([r, u][v], 1));
    /// assert_eq!(at(2, 3), Some(rational(2, 5)));
    /// assert_eq!(at(2, -2), None);
    /// ```
    #[must_use]
    pub fn evaluate<S: RationalAlgebra>(&self, like: &S, point: impl Fn(usize) -> S) -> Option<S> {
        let divisor = like.embed(&BigRational::from_integer(self.divisor.clone()));
        let times = |product: S, (factor, power): (&Multivariate, usize)| {
            product.times(&factor.evaluate(like, &point).power(power))
        };
        self.numerator.evaluate(like, &point).over(&self.factors().fold(divisor, times))
    }

    /// N/(c·F…) with what cancels cheaply crossed out: integers, variables, and a factor that N is a multiple of
    /// by a term.
    fn tidy(numerator: Multivariate, divisor: BigInt, mut factors: Factors) -> Self {
        if numerator.is_zero() {
            return Self::from_polynomial(numerator);
        }
        let common = numerator.common_divisor(divisor.clone());
        let mut cancelled = Monomial::ONE;
        if factors.iter().any(|(factor, _)| as_variable(factor).is_some()) {
            let monomial = numerator.common_monomial();
            for (factor, power) in &mut factors {
                if let Some(v) = as_variable(factor) {
                    let e = monomial.exponent(v).min(*power);
                    cancelled = cancelled.with(v, e);
                    *power -= e;
                }
            }
        }
        let mut numerator = numerator.over_term(&common, &cancelled);
        let length = numerator.terms().len();
        let alike = |factor: &Multivariate| length > 1 && factor.terms().len() == length;
        if factors.iter().any(|(factor, _)| alike(factor))
            && let Some((c, m, rest)) = numerator.split()
            && let Some((_, power)) = factors.iter_mut().find(|(factor, _)| **factor == rest)
        {
            numerator = Multivariate::from_terms([(m, c)]);
            *power -= 1;
        }
        factors.retain(|(_, power)| *power > 0);
        Self { numerator, divisor: divisor / common, factors }
    }

    /// The product of quotients of which neither numerator has anything to cancel with a denominator.
    fn joined(&self, rhs: &Self) -> Self {
        Self {
            numerator: self.numerator.times(&rhs.numerator),
            divisor: &self.divisor * &rhs.divisor,
            factors: combined(&self.factors, &rhs.factors, |e, f| e + f),
        }
    }

    /// The numerators of both over their least common denominator, and that one.
    fn on_one_denominator(&self, rhs: &Self) -> (Multivariate, Multivariate, BigInt, Factors) {
        let divisor = lcm(&self.divisor, &rhs.divisor);
        let factors = combined(&self.factors, &rhs.factors, usize::max);
        let raised = |q: &Self| {
            let missing = combined(&factors, &q.factors, usize::saturating_sub);
            expanded(&missing, &q.numerator.scaled(&(&divisor / &q.divisor)))
        };
        (raised(self), raised(rhs), divisor, factors)
    }
}

/// Equality of functions, by cross multiplication.
impl PartialEq for Quotient {
    fn eq(&self, rhs: &Self) -> bool {
        if self.is_zero() || rhs.is_zero() {
            return self.is_zero() && rhs.is_zero();
        }
        // At one place modulo a prime most that differ do so, and nothing has to be multiplied out.
        let down = |q: &Self| {
            let power = |(factor, e): (&Multivariate, usize)| modular::power(factor.residue(), e as u64);
            q.factors().map(power).fold(modular::residue(&q.divisor), modular::product)
        };
        let across = |p: &Self, q: &Self| modular::product(p.numerator.residue(), down(q));
        if across(self, rhs) != across(rhs, self) {
            return false;
        }
        let (left, right, _, _) = self.on_one_denominator(rhs);
        left == right
    }
}

impl Eq for Quotient {}

impl Ring for Quotient {
    fn zero(&self) -> Self {
        Self::from_polynomial(self.numerator.zero())
    }
    fn one(&self) -> Self {
        Self::from_polynomial(self.numerator.one())
    }
    fn plus(&self, rhs: &Self) -> Self {
        if self.is_zero() {
            return rhs.clone();
        }
        if rhs.is_zero() {
            return self.clone();
        }
        let (left, right, divisor, factors) = self.on_one_denominator(rhs);
        Self::tidy(left.plus(&right), divisor, factors)
    }
    /// Numerators cancel only against the denominator of the other factor.
    fn times(&self, rhs: &Self) -> Self {
        let across =
            |p: &Self, q: &Self| Self::tidy(p.numerator.clone(), q.divisor.clone(), q.factors.clone());
        if self.is_zero() || rhs.is_zero() {
            return self.zero();
        }
        across(self, rhs).joined(&across(rhs, self))
    }
    fn negate(&self) -> Self {
        Self { numerator: self.numerator.negate(), ..self.clone() }
    }
    fn is_zero(&self) -> bool {
        self.numerator.is_zero()
    }
}

impl RationalAlgebra for Quotient {
    fn embed(&self, value: &BigRational) -> Self {
        Self::constant(value)
    }
    /// The numerator becomes a factor; the factors are multiplied out.
    fn reciprocal(&self) -> Option<Self> {
        self.one().over(self)
    }
    /// Factors that both denominators have are crossed out unseen.
    fn over(&self, rhs: &Self) -> Option<Self> {
        let (sign, divisor, factors) = factored(&rhs.numerator)?;
        if self.is_zero() {
            return Some(self.zero());
        }
        let left = Self::tidy(self.numerator.scaled(&sign), divisor, factors);
        let up = combined(&rhs.factors, &self.factors, usize::saturating_sub);
        let down = combined(&self.factors, &rhs.factors, usize::saturating_sub);
        let up = expanded(&up, &Multivariate::constant(rhs.divisor.clone()));
        Some(left.joined(&Self::tidy(up, self.divisor.clone(), down)))
    }
    /// A/(A + B) and B/(A + B) from the numerators over one denominator, which plays no part.
    fn shares(&self, rhs: &Self) -> Option<(Self, Self)> {
        let (left, right, _, _) = self.on_one_denominator(rhs);
        let (sign, divisor, factors) = factored(&left.plus(&right))?;
        let share = |part: &Multivariate| Self::tidy(part.scaled(&sign), divisor.clone(), factors.clone());
        Some((share(&left), share(&right)))
    }
}

impl Field for Quotient {}
impl ExactField for Quotient {}

#[cfg(test)]
mod tests {
    use num_traits::One;

    use super::*;
    use num_traits::Signed;

    use crate::scalar::{Jet, rational};

    fn x(v: usize) -> Quotient {
        Quotient::variable(v)
    }

    /// What the type promises of its parts.
    fn is_tidy(q: &Quotient) -> bool {
        let good = |f: &Multivariate| {
            f.split().is_some_and(|(c, m, rest)| {
                c.is_one() && rest == *f && f.as_constant().is_none() && m == Monomial::ONE
                    || as_variable(f).is_some()
            })
        };
        q.factors.is_sorted_by(|a, b| a.0 < b.0)
            && q.factors.iter().all(|(f, e)| *e > 0 && good(f))
            && q.divisor.is_positive()
            && (q.is_zero() || q.numerator.common_divisor(q.divisor.clone()).is_one())
            && (!q.is_zero() || q.divisor.is_one() && q.factors.is_empty())
            && q.factors
                .iter()
                .filter_map(|(f, _)| as_variable(f))
                .all(|v| q.numerator.common_monomial().exponent(v) == 0)
    }

    fn elements() -> Vec<Quotient> {
        let (r, u, one) = (x(0), x(1), x(0).one());
        let sum = r.plus(&u).times(&r.embed(&rational(-6, 5)));
        let list = [
            r.zero(),
            one.clone(),
            u.embed(&rational(-2, 3)),
            u.clone(),
            sum.clone(),
            r.over(&sum).unwrap(),
            sum.over(&u.power(3).times(&r)).unwrap(),
            sum.times(&r.minus(&u)).over(&sum.power(2)).unwrap(),
            one.over(&r.times(&u).plus(&one)).unwrap().over(&sum).unwrap(),
        ];
        list.to_vec()
    }

    #[test]
    fn every_operation_keeps_its_parts_tidy() {
        for a in elements() {
            assert!(is_tidy(&a.negate()) && is_tidy(&a.reduced()), "{a:?}");
            for b in elements() {
                let mut results = vec![a.plus(&b), a.minus(&b), a.times(&b)];
                results.extend(a.over(&b));
                results.extend(a.shares(&b).map(|(share, _)| share));
                results.extend(a.shares(&b).map(|(_, share)| share));
                for result in results {
                    assert!(is_tidy(&result), "{a:?} with {b:?}: {result:?}");
                }
            }
        }
    }

    /// Not only equal to 0 and 1: nothing is left over in the representation.
    #[test]
    fn what_is_0_or_1_looks_it() {
        for a in elements() {
            for zero in [a.minus(&a), a.times(&a.zero()), a.zero().times(&a)] {
                assert!(zero.numerator.is_zero() && zero.divisor.is_one() && zero.factors.is_empty());
            }
            if let Some(one) = a.over(&a) {
                assert!(one.numerator == Multivariate::constant(1) && one.divisor.is_one(), "{one:?}");
                assert!(one.factors.is_empty(), "{one:?}");
            }
            let sum = a.zero().plus(&a);
            assert_eq!((sum.numerator, sum.factors.len()), (a.numerator.clone(), a.factors.len()));
        }
        assert_eq!(x(0).zero().reciprocal(), None);
        assert_eq!(x(0).shares(&x(0).negate()), None);
    }

    /// A sum has the least common denominator of the lists, not their product.
    #[test]
    fn a_sum_repeats_no_factor() {
        let (one, f, g) = (x(0).one(), x(0).plus(&x(1)), x(0).minus(&x(1)));
        let a = one.over(&f).unwrap().over(&f).unwrap().over(&g).unwrap();
        let b = x(0).over(&f).unwrap().over(&g).unwrap().times(&one.embed(&rational(1, 6)));
        let sum = a.times(&one.embed(&rational(1, 4))).plus(&b);
        assert_eq!(sum.divisor, 12.into());
        assert_eq!(sum.factors().map(|(_, e)| e).sum::<usize>(), 3);
        assert_eq!(a.plus(&a.times(&x(1))).denominator(), a.denominator());
        assert_eq!(sum.plus(&sum).plus(&a).denominator().degree_in(0), sum.denominator().degree_in(0));
    }

    #[test]
    fn shares_are_the_quotients_by_the_sum() {
        for a in elements() {
            for b in elements() {
                let sum = a.plus(&b);
                let by_hand = a.over(&sum).zip(b.over(&sum));
                assert_eq!(a.shares(&b), by_hand, "{a:?} and {b:?}");
            }
        }
    }

    /// Different factors, same function; nearly the same, and not.
    #[test]
    fn equality_is_that_of_functions() {
        let (r, u) = (x(0), x(1));
        let difference = r.times(&r).minus(&u.times(&u));
        let as_one = r.one().over(&difference).unwrap();
        let as_two = r.one().over(&r.plus(&u)).unwrap().over(&r.minus(&u)).unwrap();
        assert_ne!(as_one.factors.len(), as_two.factors.len());
        assert_eq!(as_one, as_two);
        assert_ne!(as_one, as_two.negate());
        assert_ne!(as_one, as_two.times(&r.embed(&rational(1, 2))));
        assert_ne!(as_one, as_two.reciprocal().unwrap());
        assert_eq!(as_one.reciprocal().unwrap().numerator, difference.numerator);
        // 2⁶¹ − 1 is the prime that they are looked at with first.
        let prime = Quotient::constant(&rational((1 << 61) - 1, 1));
        assert_ne!(as_one, as_two.plus(&prime.times(&r)));
        assert_ne!(as_one.over(&prime), as_two.over(&prime.times(&u)));
        assert_eq!(as_one.over(&prime), as_two.over(&prime));
    }

    /// 1/(r + x) at x = u: the derivatives are ±d!/(r + u)^(d + 1).
    #[test]
    fn a_jet_has_a_reciprocal() {
        let point = Jet::variable(x(1), 3);
        let derivatives = point.plus(&Jet::constant(x(0), 3)).reciprocal().unwrap().derivatives();
        let inverse = x(0).plus(&x(1)).reciprocal().unwrap();
        let expected = [1, -1, 2, -6].map(|c| inverse.embed(&rational(c, 1)));
        for (d, (derivative, c)) in derivatives.iter().zip(expected).enumerate() {
            assert_eq!(*derivative, c.times(&inverse.power(d + 1)));
            assert_eq!(derivative.factors.len(), 1);
        }
        assert_eq!(Jet::variable(x(0).zero(), 3).reciprocal(), None);
    }
}
