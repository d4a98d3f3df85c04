//! Polynomials in one variable.

use super::ring::{Field, Ring, ScaleBy};

/// c₀ + c₁u + … + c_n uⁿ with coefficients in a ring.
///
/// The list of coefficients is never empty and ends with a non-zero one, unless the polynomial is 0: so
/// equality of lists is equality of polynomials.
#[derive(Debug, PartialEq)]
pub struct Polynomial<S> {
    coefficients: Vec<S>,
}

impl<S: Clone> Clone for Polynomial<S> {
    fn clone(&self) -> Self {
        Self { coefficients: self.coefficients.clone() }
    }
    /// In the memory that is there already.
    fn clone_from(&mut self, source: &Self) {
        self.coefficients.clone_from(&source.coefficients);
    }
}

impl<S: Ring> Polynomial<S> {
    /// The constant polynomial.
    #[must_use]
    pub fn constant(value: S) -> Self {
        Self { coefficients: vec![value] }
    }

    /// c₀ + c₁u + …, constant term `first`; trailing zeros are dropped.
    #[must_use]
    pub fn new(first: S, rest: impl IntoIterator<Item = S>) -> Self {
        let rest = rest.into_iter();
        let mut coefficients = Vec::with_capacity(1 + rest.size_hint().0);
        coefficients.push(first);
        coefficients.extend(rest);
        Self::from_coefficients(coefficients)
    }

    /// The variable u, in the ring that `like` belongs to.
    #[must_use]
    pub fn variable(like: &S) -> Self {
        Self { coefficients: vec![like.zero(), like.one()] }
    }

    /// From coefficients of which there is at least one.
    fn from_coefficients(coefficients: Vec<S>) -> Self {
        let mut polynomial = Self { coefficients };
        polynomial.trim();
        polynomial
    }

    /// Drops leading zeros, so that the invariant holds.
    fn trim(&mut self) {
        while self.coefficients.len() > 1 && self.coefficients.last().is_some_and(S::is_zero) {
            self.coefficients.pop();
        }
    }

    /// c₀, …, c_n.
    #[must_use]
    pub fn coefficients(&self) -> &[S] {
        &self.coefficients
    }

    /// The degree; 0 for every constant, 0 included.
    #[must_use]
    pub fn degree(&self) -> usize {
        self.coefficients.len() - 1
    }

    /// c_n ≠ 0, except for the polynomial 0.
    #[must_use]
    pub fn leading(&self) -> &S {
        &self.coefficients[self.degree()]
    }

    /// The value at u, by Horner's rule.
    #[must_use]
    pub fn evaluate(&self, u: &S) -> S {
        S::value_of_polynomial(&self.coefficients, u)
    }

    /// d/du.
    #[must_use]
    pub fn derivative(&self) -> Self {
        let one = self.coefficients[0].one();
        let mut factor = one.zero();
        let mut derived = Vec::with_capacity(self.coefficients.len());
        for c in &self.coefficients[1..] {
            factor = factor.plus(&one);
            derived.push(c.times(&factor));
        }
        if derived.is_empty() {
            derived.push(one.zero());
        }
        Self::from_coefficients(derived)
    }

    /// u^n p(1/u) for n ≥ deg p: the coefficients in reverse, on n + 1 places.
    ///
    /// # Panics
    /// If n < deg p.
    #[must_use]
    pub fn reversed(&self, n: usize) -> Self {
        assert!(n >= self.degree(), "reversing a polynomial of degree {} on {n} places", self.degree());
        let zero = self.coefficients[0].zero();
        let padding = std::iter::repeat_n(zero, n - self.degree());
        Self::from_coefficients(padding.chain(self.coefficients.iter().rev().cloned()).collect())
    }

    /// p(factor·u).
    #[must_use]
    pub fn scaled_argument(&self, factor: &S) -> Self {
        let mut power = factor.one();
        let scale = |c: &S| {
            let scaled = c.times(&power);
            power = power.times(factor);
            scaled
        };
        Self::from_coefficients(self.coefficients.iter().map(scale).collect())
    }

    /// p(u + 1): Taylor shift by additions alone (Pascal's triangle on the coefficients).
    #[must_use]
    pub fn shifted_by_one(&self) -> Self {
        let mut c = self.coefficients.clone();
        for start in 0..c.len() {
            for i in (start..c.len() - 1).rev() {
                c[i] = c[i].plus(&c[i + 1]);
            }
        }
        Self::from_coefficients(c)
    }

    /// factor·p.
    #[must_use]
    pub fn scaled(&self, factor: &S) -> Self {
        Self::from_coefficients(self.coefficients.iter().map(|c| c.times(factor)).collect())
    }

    /// The coefficients in another ring; leading ones that become 0 there are dropped.
    #[must_use]
    pub fn map<T: Ring>(&self, image: impl Fn(&S) -> T) -> Polynomial<T> {
        Polynomial::from_coefficients(self.coefficients.iter().map(image).collect())
    }

    fn zip_with(&self, rhs: &Self, operation: impl Fn(&S, &S) -> S) -> Self {
        let zero = self.coefficients[0].zero();
        let length = self.coefficients.len().max(rhs.coefficients.len());
        let at = |i: usize| [self, rhs].map(|p| p.coefficients.get(i).unwrap_or(&zero));
        let apply = |[a, b]: [&S; 2]| operation(a, b);
        Self::from_coefficients((0..length).map(at).map(apply).collect())
    }
}

impl<S: Ring> Ring for Polynomial<S> {
    fn certainly_negative(&self) -> bool {
        self.degree() == 0 && self.leading().certainly_negative()
    }
    fn zero(&self) -> Self {
        Self::constant(self.coefficients[0].zero())
    }
    fn one(&self) -> Self {
        Self::constant(self.coefficients[0].one())
    }
    fn plus(&self, rhs: &Self) -> Self {
        self.zip_with(rhs, S::plus)
    }
    fn increase(&mut self, rhs: &Self) {
        let shared = self.coefficients.len();
        for (c, d) in self.coefficients.iter_mut().zip(&rhs.coefficients) {
            c.increase(d);
        }
        self.coefficients.extend(rhs.coefficients.iter().skip(shared).cloned());
        self.trim();
    }
    fn minus(&self, rhs: &Self) -> Self {
        self.zip_with(rhs, S::minus)
    }
    fn times(&self, rhs: &Self) -> Self {
        if self.is_zero() || rhs.is_zero() {
            return self.zero();
        }
        if rhs.degree() == 0 {
            return self.scaled(rhs.leading());
        }
        if self.degree() == 0 {
            return rhs.scaled(self.leading());
        }
        let length = self.degree() + rhs.degree() + 1;
        Self::from_coefficients(S::product_of_polynomials(&self.coefficients, &rhs.coefficients, length))
    }
    fn negate(&self) -> Self {
        Self { coefficients: self.coefficients.iter().map(S::negate).collect() }
    }
    fn is_zero(&self) -> bool {
        self.coefficients.len() == 1 && self.coefficients[0].is_zero()
    }
}

/// By a + bu, written (a, b).
///
/// ```
/// use knotproof::scalar::{Polynomial, ScaleBy, rational};
///
/// // 2(1 + u)(3 − u).
/// let factors = [(1, 1), (3, -1)].map(|(a, b)| (rational(a, 1), rational(b, 1)));
/// let mut product = Polynomial::constant(rational(2, 1));
/// product.scale_by(factors.iter());
/// assert_eq!(product.coefficients(), [6, 4, -2].map(|c| rational(c, 1)));
/// ```
impl<S: Ring> ScaleBy<(S, S)> for Polynomial<S> {
    fn scale_by<'a>(&mut self, factors: impl Iterator<Item = &'a (S, S)>)
    where
        S: 'a,
    {
        let c = &mut self.coefficients;
        for (constant, slope) in factors {
            let degree = c.len() - 1;
            if !slope.is_zero() {
                c.push(c[degree].times(slope));
            }
            for i in (1..=degree).rev() {
                let (lower, upper) = c.split_at_mut(i);
                upper[0].combine(constant, &lower[i - 1], slope);
            }
            c[0] = c[0].times(constant);
        }
        self.trim();
    }
}

impl<S: Field> Polynomial<S> {
    /// Quotient and remainder: self = q·divisor + r with r = 0 or deg r < deg divisor. `None` for divisor 0.
    #[must_use]
    pub fn divide(&self, divisor: &Self) -> Option<(Self, Self)> {
        let (quotient, remainder) = S::quotient_of_polynomials(&self.coefficients, &divisor.coefficients)?;
        let or_zero = |list: Vec<S>| {
            if list.is_empty() { self.zero() } else { Self::from_coefficients(list) }
        };
        Some((or_zero(quotient), or_zero(remainder)))
    }

    /// The monic greatest common divisor; 0 only for two zeros.
    #[must_use]
    pub fn gcd(&self, rhs: &Self) -> Self {
        // A constant other than 0 divides everything: most gcds here are with one.
        if [self, rhs].iter().any(|p| p.degree() == 0 && !p.is_zero()) {
            return self.one();
        }
        Self::from_coefficients(S::gcd_of_polynomials(&self.coefficients, &rhs.coefficients))
    }

    /// Divided by the leading coefficient; 0 stays 0.
    #[must_use]
    pub fn monic(&self) -> Self {
        self.leading().reciprocal().map_or_else(|| self.clone(), |inverse| self.scaled(&inverse))
    }

    /// The product of the distinct irreducible factors, p/gcd(p, p′): the same roots, each simple.
    #[must_use]
    pub fn square_free(&self) -> Self {
        let repeated = self.gcd(&self.derivative());
        match self.divide(&repeated) {
            Some((quotient, _)) => quotient,
            None => self.clone(),
        }
    }
}
