//! Truncated Taylor series: one-sided derivatives of any order by the same lines that give values.

use num_rational::BigRational;

use super::rational::integer;
use super::ring::{ExactField, RationalAlgebra, Ring, ScaleBy};

/// c₀ + c₁ε + … + c_Dε^D modulo ε^(D+1), over any scalar: the jet of order D of a function at a point, with
/// c_d = f^(d)/d!.
///
/// Combining jets of different orders gives the lower order: truncation is a homomorphism. A jet is a unit
/// if and only if c₀ is one.
///
/// ```
/// use knotproof::scalar::{Jet, RationalAlgebra, Ring, rational};
///
/// // 1/x at x = 2: the derivatives are 1/2, −1/4, 1/4.
/// let x = Jet::variable(rational(2, 1), 2);
/// let derivatives = x.reciprocal().unwrap().derivatives();
/// assert_eq!(derivatives, [rational(1, 2), rational(-1, 4), rational(1, 4)]);
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Jet<S> {
    /// c₀, c₁, …, c_D: never empty.
    coefficients: Vec<S>,
}

impl<S: Ring> Jet<S> {
    /// The jet of a constant function: value + 0ε + … of the given order.
    #[must_use]
    pub fn constant(value: S, order: usize) -> Self {
        let mut coefficients = vec![value.zero(); order + 1];
        coefficients[0] = value;
        Self { coefficients }
    }

    /// The jet of x ↦ x at `point`: point + ε.
    #[must_use]
    pub fn variable(point: S, order: usize) -> Self {
        let one = point.one();
        let mut jet = Self::constant(point, order);
        if order >= 1 {
            jet.coefficients[1] = one;
        }
        jet
    }

    /// From c₀, …, c_D, of which there is at least one.
    pub(crate) fn from_coefficients(coefficients: Vec<S>) -> Self {
        debug_assert!(!coefficients.is_empty());
        Self { coefficients }
    }

    /// D, the highest power of ε that is kept.
    #[must_use]
    pub fn order(&self) -> usize {
        self.coefficients.len() - 1
    }

    /// c₀, …, c_D.
    #[must_use]
    pub fn coefficients(&self) -> &[S] {
        &self.coefficients
    }

    fn zip_with(&self, rhs: &Self, operation: impl Fn(&S, &S) -> S) -> Self {
        let coefficients =
            self.coefficients.iter().zip(&rhs.coefficients).map(|(a, b)| operation(a, b)).collect();
        Self { coefficients }
    }
}

/// By a + bε, written (a, b).
impl<S: Ring> ScaleBy<(S, S)> for Jet<S> {
    fn scale_by<'a>(&mut self, factors: impl Iterator<Item = &'a (S, S)>)
    where
        S: 'a,
    {
        let c = &mut self.coefficients;
        for (constant, slope) in factors {
            for d in (1..c.len()).rev() {
                let (lower, upper) = c.split_at_mut(d);
                upper[0].combine(constant, &lower[d - 1], slope);
            }
            c[0] = c[0].times(constant);
        }
    }
}

impl<S: RationalAlgebra> Jet<S> {
    /// f, f′, …, f^(D) at the point: d!·c_d.
    #[must_use]
    pub fn derivatives(&self) -> Vec<S> {
        let mut factorial = integer(1);
        self.coefficients
            .iter()
            .enumerate()
            .map(|(d, c)| {
                if d > 0 {
                    factorial *= integer(d);
                }
                c.times(&c.embed(&factorial))
            })
            .collect()
    }
}

/// Σ a·b over pairs of which there is at least one, passing over zeros: jets of linear functions have many.
fn sum_of_products<'a, S: Ring + 'a>(mut pairs: impl Iterator<Item = (&'a S, &'a S)>) -> S {
    let product = |(a, b): (&S, &S)| if a.is_zero() || b.is_zero() { a.zero() } else { a.times(b) };
    let first = match pairs.next() {
        Some(pair) => product(pair),
        None => unreachable!("every coefficient of a product has a term"),
    };
    pairs.filter(|(a, b)| !a.is_zero() && !b.is_zero()).fold(first, |sum, (a, b)| sum.plus(&a.times(b)))
}

impl<S: Ring> Ring for Jet<S> {
    fn certainly_negative(&self) -> bool {
        self.coefficients[0].certainly_negative()
    }
    fn zero(&self) -> Self {
        Self::constant(self.coefficients[0].zero(), self.order())
    }
    fn one(&self) -> Self {
        Self::constant(self.coefficients[0].one(), self.order())
    }
    fn plus(&self, rhs: &Self) -> Self {
        self.zip_with(rhs, S::plus)
    }
    fn minus(&self, rhs: &Self) -> Self {
        self.zip_with(rhs, S::minus)
    }
    fn times(&self, rhs: &Self) -> Self {
        let order = self.order().min(rhs.order());
        let coefficients = S::product_of_polynomials(&self.coefficients, &rhs.coefficients, order + 1);
        Self { coefficients }
    }
    fn negate(&self) -> Self {
        Self { coefficients: self.coefficients.iter().map(S::negate).collect() }
    }
}

impl<S: RationalAlgebra> RationalAlgebra for Jet<S> {
    fn lies_outside(&self, low: &BigRational, high: &BigRational) -> bool {
        self.coefficients[0].lies_outside(low, high)
    }
    fn embed(&self, value: &BigRational) -> Self {
        Self::constant(self.coefficients[0].embed(value), self.order())
    }

    /// From a·b = 1, one coefficient after the other: b_d = −(a₁b_{d−1} + … + a_d b₀)/a₀.
    fn reciprocal(&self) -> Option<Self> {
        let inverse = self.coefficients[0].reciprocal()?;
        let mut coefficients = vec![inverse.clone()];
        for d in 1..=self.order() {
            let sum = sum_of_products((1..=d).map(|a| (&self.coefficients[a], &coefficients[d - a])));
            coefficients.push(sum.times(&inverse).negate());
        }
        Some(Self { coefficients })
    }
}

/// A jet over an exact field is as exact as its coefficients, though not a field.
impl<S: ExactField> Jet<S> {
    /// The order of vanishing: the least d with c_d ≠ 0; `None` if all kept coefficients are 0.
    #[must_use]
    pub fn valuation(&self) -> Option<usize> {
        self.coefficients.iter().position(|c| !c.is_zero())
    }
}
