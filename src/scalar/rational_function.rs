//! Quotients of polynomials in one variable: the field in which the triangle gives whole pieces.

use num_bigint::BigInt;
use num_rational::BigRational;

use super::fraction::fraction;
use super::polynomial::Polynomial;
use super::ring::{ExactField, Field, RationalAlgebra, Ring};

/// P(u)/Q(u) over an exact field, in lowest terms with Q monic: so `==` is equality of functions, and an
/// identity that holds here holds at every u where both sides are defined.
///
/// ```
/// use knotproof::scalar::{RationalAlgebra, RationalFunction, Ring, rational};
///
/// let u = RationalFunction::variable(&rational(1, 1));
/// let difference_of_squares = u.times(&u).minus(&u.one());
/// assert_eq!(difference_of_squares.over(&u.minus(&u.one())), Some(u.plus(&u.one())));
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct RationalFunction<S> {
    numerator: Polynomial<S>,
    denominator: Polynomial<S>,
}

impl RationalFunction<BigRational> {
    /// numerator/denominator for integer polynomials without a common factor, denominator ≠ 0.
    pub(crate) fn in_lowest_terms(numerator: &Polynomial<BigInt>, denominator: &Polynomial<BigInt>) -> Self {
        let leading = denominator.leading();
        let over_leading = |p: &Polynomial<BigInt>| p.map(|c| fraction(c.clone(), leading.clone()));
        Self { numerator: over_leading(numerator), denominator: over_leading(denominator) }
    }
}

impl<S: ExactField> RationalFunction<S> {
    /// numerator/denominator, reduced; `None` if the denominator is 0.
    #[must_use]
    pub fn new(numerator: &Polynomial<S>, denominator: &Polynomial<S>) -> Option<Self> {
        if denominator.is_zero() {
            return None;
        }
        let common = numerator.gcd(denominator);
        Self::coprime(quotient(numerator, &common), quotient(denominator, &common))
    }

    /// numerator/denominator for polynomials without a common factor; `None` if the denominator is 0.
    pub(crate) fn coprime(numerator: Polynomial<S>, denominator: Polynomial<S>) -> Option<Self> {
        let leading = denominator.leading();
        if *leading == leading.one() {
            return Some(Self { numerator, denominator });
        }
        let inverse = leading.reciprocal()?;
        Some(Self { numerator: numerator.scaled(&inverse), denominator: denominator.scaled(&inverse) })
    }

    /// The polynomial P as P/1.
    #[must_use]
    pub fn from_polynomial(numerator: Polynomial<S>) -> Self {
        let denominator = numerator.one();
        Self { numerator, denominator }
    }

    /// The constant function.
    #[must_use]
    pub fn constant(value: S) -> Self {
        Self::from_polynomial(Polynomial::constant(value))
    }

    /// The variable u, over the field that `like` belongs to.
    #[must_use]
    pub fn variable(like: &S) -> Self {
        Self::from_polynomial(Polynomial::variable(like))
    }

    /// P.
    #[must_use]
    pub fn numerator(&self) -> &Polynomial<S> {
        &self.numerator
    }

    /// Q: monic and without a common factor with P.
    #[must_use]
    pub fn denominator(&self) -> &Polynomial<S> {
        &self.denominator
    }

    /// The value at u; `None` at a pole.
    #[must_use]
    pub fn evaluate(&self, u: &S) -> Option<S> {
        self.numerator.evaluate(u).over(&self.denominator.evaluate(u))
    }

    /// The limit for u → ∞; `None` if it is not finite.
    #[must_use]
    pub fn at_infinity(&self) -> Option<S> {
        let (p, q) = (&self.numerator, &self.denominator);
        match p.degree().cmp(&q.degree()) {
            std::cmp::Ordering::Less => Some(p.leading().zero()),
            std::cmp::Ordering::Equal => p.leading().over(q.leading()),
            std::cmp::Ordering::Greater => None,
        }
    }

    /// u ↦ f(1/u).
    #[must_use]
    pub fn reciprocal_argument(&self) -> Self {
        let n = self.numerator.degree().max(self.denominator.degree());
        self.rebuilt(&self.numerator.reversed(n), &self.denominator.reversed(n))
    }

    /// u ↦ f(factor·u), for factor ≠ 0.
    #[must_use]
    pub fn scaled_argument(&self, factor: &S) -> Self {
        self.rebuilt(&self.numerator.scaled_argument(factor), &self.denominator.scaled_argument(factor))
    }

    /// df/du.
    #[must_use]
    pub fn derivative(&self) -> Self {
        let (p, q) = (&self.numerator, &self.denominator);
        let numerator = p.derivative().times(q).minus(&p.times(&q.derivative()));
        self.rebuilt(&numerator, &q.times(q))
    }

    /// A quotient whose denominator comes from a non-zero one by an operation that keeps it so.
    fn rebuilt(&self, numerator: &Polynomial<S>, denominator: &Polynomial<S>) -> Self {
        match Self::new(numerator, denominator) {
            Some(result) => result,
            None => unreachable!("a product of non-zero polynomials over a field is not zero"),
        }
    }
}

/// p / divisor, for a monic divisor of p: so quotients of monic polynomials stay monic.
fn quotient<S: ExactField>(p: &Polynomial<S>, divisor: &Polynomial<S>) -> Polynomial<S> {
    if divisor.degree() == 0 {
        return p.clone();
    }
    match p.divide(divisor) {
        Some((quotient, _)) => quotient,
        None => unreachable!("a monic polynomial is not 0"),
    }
}

impl<S: ExactField> Ring for RationalFunction<S> {
    fn zero(&self) -> Self {
        Self::from_polynomial(self.numerator.zero())
    }
    fn one(&self) -> Self {
        Self::from_polynomial(self.numerator.one())
    }
    /// With g = gcd(Q₁, Q₂) only g can still cancel against the numerator (Henrici 1956; Knuth, TAOCP 2, 4.5.1).
    fn plus(&self, rhs: &Self) -> Self {
        if self.is_zero() {
            return rhs.clone();
        }
        if rhs.is_zero() {
            return self.clone();
        }
        if self.denominator == rhs.denominator {
            return self.rebuilt(&self.numerator.plus(&rhs.numerator), &self.denominator);
        }
        // P/Q + R has no other denominator than P/Q.
        for (f, polynomial) in [(self, rhs), (rhs, self)] {
            if polynomial.denominator.degree() == 0 {
                let numerator = f.numerator.plus(&polynomial.numerator.times(&f.denominator));
                return Self { numerator, denominator: f.denominator.clone() };
            }
        }
        let common = self.denominator.gcd(&rhs.denominator);
        let (own, other) = (quotient(&self.denominator, &common), quotient(&rhs.denominator, &common));
        let numerator = self.numerator.times(&other).plus(&rhs.numerator.times(&own));
        let cancelled = numerator.gcd(&common);
        Self {
            numerator: quotient(&numerator, &cancelled),
            denominator: own.times(&other).times(&quotient(&common, &cancelled)),
        }
    }
    /// Numerators cancel only against the denominator of the other factor.
    fn times(&self, rhs: &Self) -> Self {
        if self.is_zero() || rhs.is_zero() {
            return self.zero();
        }
        let (left, right) = (self.numerator.gcd(&rhs.denominator), rhs.numerator.gcd(&self.denominator));
        Self {
            numerator: quotient(&self.numerator, &left).times(&quotient(&rhs.numerator, &right)),
            denominator: quotient(&self.denominator, &right).times(&quotient(&rhs.denominator, &left)),
        }
    }
    fn negate(&self) -> Self {
        Self { numerator: self.numerator.negate(), denominator: self.denominator.clone() }
    }
    fn is_zero(&self) -> bool {
        self.numerator.is_zero()
    }
}

impl<S: ExactField> RationalAlgebra for RationalFunction<S> {
    /// Of a constant; any other one is no point.
    fn lies_outside(&self, low: &BigRational, high: &BigRational) -> bool {
        let constant = self.numerator.degree() == 0 && self.denominator.degree() == 0;
        constant
            && self
                .numerator
                .leading()
                .over(self.denominator.leading())
                .is_some_and(|x| x.lies_outside(low, high))
    }
    fn embed(&self, value: &BigRational) -> Self {
        Self::constant(self.denominator.leading().embed(value))
    }
    fn reciprocal(&self) -> Option<Self> {
        Self::coprime(self.denominator.clone(), self.numerator.clone())
    }
    /// P/(P + R) and R/(P + R) from the numerators over one denominator: what divides two of P, R and P + R divides all three.
    fn shares(&self, rhs: &Self) -> Option<(Self, Self)> {
        let (p, r) = if self.denominator == rhs.denominator {
            (self.numerator.clone(), rhs.numerator.clone())
        } else {
            (self.numerator.times(&rhs.denominator), rhs.numerator.times(&self.denominator))
        };
        let common = p.gcd(&r);
        if common.is_zero() {
            return None;
        }
        let (p, r) = (quotient(&p, &common), quotient(&r, &common));
        let whole = p.plus(&r);
        Some((Self::coprime(p, whole.clone())?, Self::coprime(r, whole)?))
    }
}

impl<S: ExactField> Field for RationalFunction<S> {}
impl<S: ExactField> ExactField for RationalFunction<S> {}
