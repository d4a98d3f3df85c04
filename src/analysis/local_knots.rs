//! One basis function by its own knots, over any ring: numerators and denominators without a division.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::Zero;
use thiserror::Error;

use super::piece::Piece;
use crate::scalar::{Polynomial, RationalFunction, Ring, ScaleBy, gcd, over_one_denominator};
use crate::spline::{Basis, Factors, FractionFree, triangle};

/// The local knot vector t_i ≤ t_{i+1} ≤ … ≤ t_{i+k+1} of one function G_i^k, by its k + 1 gaps, and the slope
/// ratio r = p/q as the pair (p, q): all that the function depends on, besides the place of t_i (D3.3).
///
/// The gaps and the ratio may be numbers, intervals, or polynomials in a parameter: what is computed are sums and
/// products only. Every gap stands for a number ≥ 0, and p and q for numbers > 0; a gap is an empty span if and
/// only if it is the 0 of its ring.
///
/// ```
/// use knotproof::analysis::LocalKnots;
/// use num_bigint::BigInt;
///
/// // The hat function on (0, 1, 3): u/(1 + u) on its first span, 1/(1 + u) on its second.
/// let [one, two] = [1, 2].map(BigInt::from);
/// let hat = LocalKnots::new(vec![one.clone(), two], (one.clone(), one))?;
/// let quotients: Vec<_> = hat.spans().map(|s| hat.on_span(s).unwrap()).collect();
/// assert_eq!(quotients[0].numerator.coefficients(), [0, 1].map(BigInt::from));
/// // The sign of its derivative is that of P′Q − PQ′: it rises, then it falls.
/// let slopes: Vec<_> = quotients.iter().map(|quotient| quotient.slope()).collect();
/// assert_eq!(slopes[0].coefficients(), [BigInt::from(1)]);
/// assert!(slopes[1].coefficients().iter().all(|c| *c < BigInt::from(0)));
/// # Ok::<(), knotproof::analysis::LocalKnotsError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct LocalKnots<R> {
    gaps: Vec<R>,
    ratio: (R, R),
}

/// Why a list of gaps belongs to no function.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
pub enum LocalKnotsError {
    /// No gap at all: degree −1.
    #[error("a function of degree k has k + 1 gaps between its knots, and here is none")]
    NoGap,
    /// A gap < 0: the knots would decrease.
    #[error("gap {0} is negative: knots must not decrease (D3.1)")]
    NegativeGap(usize),
    /// p ≤ 0 or q ≤ 0.
    #[error("a slope ratio p/q is positive, given by p > 0 and q > 0")]
    Ratio,
    /// The function is 0.
    #[error("all knots of the function are the same, so it is 0 everywhere (D3.3)")]
    Empty,
}

/// G = P/Q on one span, in its [positive coordinate](super::positive_coordinate) u. Over numbers ≥ 0 all
/// coefficients of P and Q are ≥ 0.
#[derive(Debug, Clone, PartialEq)]
pub struct SpanQuotient<R> {
    /// P.
    pub numerator: Polynomial<R>,
    /// Q, a product of linear polynomials; deg P ≤ deg Q.
    pub denominator: Polynomial<R>,
}

impl SpanQuotient<BigInt> {
    /// A rational function as a quotient of integer polynomials.
    pub(super) fn of(piece: &Piece) -> Self {
        let (p, q) = (piece.numerator(), piece.denominator());
        let (_, common) = over_one_denominator(&[p.coefficients(), q.coefficients()].concat());
        let integral = |p: &Polynomial<BigRational>| p.map(|c| c.numer() * (&common / c.denom()));
        Self { numerator: integral(p), denominator: integral(q) }
    }

    /// P/Q as a rational function with Q monic; in lowest terms if P and Q have no common factor.
    pub(super) fn piece(&self) -> Piece {
        RationalFunction::in_lowest_terms(&self.numerator, &self.denominator)
    }

    /// The value at u = 0 and the limit for u → ∞, for Q(0) ≠ 0.
    pub(super) fn at_ends(&self) -> (BigRational, BigRational) {
        let (p, q) = (self.numerator.coefficients(), self.denominator.coefficients());
        let highest = p.get(q.len() - 1).cloned().unwrap_or_default();
        (BigRational::new(p[0].clone(), q[0].clone()), BigRational::new(highest, q[q.len() - 1].clone()))
    }
}

impl<R: Ring> SpanQuotient<R> {
    /// P′Q − PQ′, which has the sign of dG/du, and so of dG/dx, at every u > 0.
    ///
    /// dG/dx = (P′Q − PQ′)(1 + u)²/(Q²·(t_{s+1} − t_s)). The coefficient of u^(m−1) is summed as
    ///
    /// Σ_{i > j, i + j = m} (i − j)(p_i q_j − p_j q_i),
    ///
    /// in which nothing is left that cancels for all P and Q: an interval for it is as narrow as it can be, and
    /// the degree is at most 2 deg Q − 2.
    #[must_use]
    pub fn slope(&self) -> Polynomial<R> {
        let degree = self.numerator.degree().max(self.denominator.degree());
        let zero = self.denominator.leading().zero();
        if degree == 0 {
            return Polynomial::constant(zero);
        }
        let one = zero.one();
        let p = |i: usize| self.numerator.coefficients().get(i).unwrap_or(&zero);
        let q = |i: usize| self.denominator.coefficients().get(i).unwrap_or(&zero);
        let naturals: Vec<R> =
            std::iter::successors(Some(zero.clone()), |n| Some(n.plus(&one))).take(degree + 1).collect();
        let coefficient = |m: usize| {
            let term = |i: usize| {
                let j = m - i;
                naturals[i - j].times(&p(i).times(q(j)).minus(&p(j).times(q(i))))
            };
            let highest = m.min(degree);
            (m / 2 + 1..highest).fold(term(highest), |sum, i| sum.plus(&term(i)))
        };
        Polynomial::new(coefficient(1), (2..2 * degree).map(coefficient))
    }
}

impl<R: Ring> LocalKnots<R> {
    /// From t_{i+1} − t_i, …, t_{i+k+1} − t_{i+k}, and (p, q) for r = p/q.
    ///
    /// # Errors
    /// [`LocalKnotsError`], if there is no gap, or only empty ones; if a gap is
    /// [certainly negative](Ring::certainly_negative), or p or q is that or 0.
    pub fn new(gaps: Vec<R>, ratio: (R, R)) -> Result<Self, LocalKnotsError> {
        if let Some(negative) = gaps.iter().position(R::certainly_negative) {
            return Err(LocalKnotsError::NegativeGap(negative));
        }
        if [&ratio.0, &ratio.1].iter().any(|part| part.is_zero() || part.certainly_negative()) {
            return Err(LocalKnotsError::Ratio);
        }
        match gaps.iter().find(|gap| !gap.is_zero()) {
            Some(_) => Ok(Self { gaps, ratio }),
            None if gaps.is_empty() => Err(LocalKnotsError::NoGap),
            None => Err(LocalKnotsError::Empty),
        }
    }

    /// k.
    #[must_use]
    pub fn degree(&self) -> usize {
        self.gaps.len() - 1
    }

    /// The gaps.
    #[must_use]
    pub fn gaps(&self) -> &[R] {
        &self.gaps
    }

    /// (p, q) for r = p/q.
    #[must_use]
    pub fn ratio(&self) -> (&R, &R) {
        (&self.ratio.0, &self.ratio.1)
    }

    /// The numbers s, from 0 to k, of the spans [t_{i+s}, t_{i+s+1}) that are not empty.
    pub fn spans(&self) -> impl Iterator<Item = usize> {
        (0..self.gaps.len()).filter(|&s| !self.gaps[s].is_zero())
    }

    /// The function on span s; `None` if that is empty, or there is none.
    ///
    /// By the [recursion without a division](FractionFree), on polynomials in u.
    #[must_use]
    pub fn on_span(&self, s: usize) -> Option<SpanQuotient<R>> {
        self.gaps.get(s).filter(|gap| !gap.is_zero())?;
        let factors =
            Factors::in_positive_coordinate(&self.gaps, s, self.degree(), std::slice::from_ref(&self.ratio))?;
        let one = Polynomial::constant(self.ratio.0.one());
        let weights = FractionFree::new(&factors, &one);
        let function = triangle(&weights, factors.span(), self.degree(), self.gaps.len());
        let mut denominator = one.clone();
        denominator.scale_by(factors.denominator(0));
        Some(SpanQuotient { numerator: function.get(0)?.clone(), denominator })
    }
}

impl LocalKnots<BigInt> {
    /// The local knots of G_i^k of a basis, in the unit that makes all gaps coprime integers; `None` if all are the same,
    /// where the function is 0.
    ///
    /// # Panics
    /// If i > n.
    #[must_use]
    pub fn of(basis: &Basis, i: usize) -> Option<Self> {
        let knots = basis.knots();
        assert!(i <= basis.n(), "there is no function {i}: the basis has the functions 0 to {}", basis.n());
        let mut gaps = integer_gaps(&knots.knots()[i..=i + basis.degree() + 1]);
        make_coprime(&mut gaps);
        if gaps.iter().all(Ring::is_zero) {
            return None;
        }
        Some(Self { gaps, ratio: basis.index().slopes() })
    }
}

/// Is a function with these gaps continuous? It has no knot of multiplicity k + 1, which would take k gaps, at one end or
/// the other.
pub fn is_continuous<T: Zero>(gaps: &[T]) -> bool {
    let filled = |gaps: &[T]| !gaps.iter().all(T::is_zero);
    gaps.split_first().is_some_and(|(_, rest)| filled(rest)) && filled(&gaps[..gaps.len() - 1])
}

/// The gaps between knots in a unit that makes all knots integers.
pub(super) fn integer_gaps(knots: &[BigRational]) -> Vec<BigInt> {
    let (knots, _) = over_one_denominator(knots);
    knots.windows(2).map(|ends| &ends[1] - &ends[0]).collect()
}

/// In the unit that makes all of them coprime integers, if not all are 0.
pub(super) fn make_coprime(gaps: &mut [BigInt]) {
    let divisor = gaps.iter().fold(BigInt::ZERO, |divisor, gap| gcd(&divisor, gap));
    if divisor > BigInt::from(1) {
        for gap in gaps {
            *gap /= &divisor;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::Pieces;
    use crate::scalar::integer;
    use crate::spline::{Index, KnotVector};

    /// The same functions as by the triangle over rational functions, on spans of every kind.
    #[test]
    fn the_quotients_are_the_pieces() {
        for gaps in
            [&[2][..], &[1, 0], &[1, 2, 1], &[0, 0, 3], &[1, 2, 0, 3], &[2, 0, 1, 1, 5], &[1, 0, 0, 2, 0, 1]]
        {
            for (p, q) in [(1, 1), (1, 2), (7, 3)] {
                let big = gaps.iter().map(|&gap| BigInt::from(gap)).collect();
                let local = LocalKnots::new(big, (p.into(), q.into())).unwrap();
                let k = local.degree();
                let mut knots = vec![integer(0); k + 1];
                for &gap in gaps {
                    knots.push(&knots[knots.len() - 1] + integer(gap));
                }
                knots.extend(vec![knots[knots.len() - 1].clone(); k]);
                let ratio = BigRational::new(p.into(), q.into());
                let basis = Basis::new(KnotVector::new(knots).unwrap(), k, Index::from_ratio(ratio).unwrap())
                    .unwrap();
                if gaps.contains(&1) {
                    assert_eq!(LocalKnots::of(&basis, k).as_ref(), Some(&local), "coprime as they are");
                }
                for span in Pieces::of(&basis).spans() {
                    let quotient = local.on_span(span.span.index() - k).unwrap();
                    let over_rationals = |p: &Polynomial<BigInt>| {
                        let mut c = p.coefficients().iter().map(|c| BigRational::from_integer(c.clone()));
                        Polynomial::new(c.next().unwrap(), c)
                    };
                    let [p, q] = [&quotient.numerator, &quotient.denominator].map(over_rationals);
                    assert_eq!(RationalFunction::new(&p, &q), Some(span.function(k)), "{gaps:?}");
                    assert_eq!(
                        quotient.denominator.degree(),
                        (span.span.index() - k + 1) * (2 * k + 1 - span.span.index()) - 1
                    );
                }
                let empty = gaps.iter().position(|gap| *gap == 0);
                assert!(empty.is_none_or(|s| local.on_span(s).is_none()));
            }
        }
    }

    #[test]
    fn what_is_no_function_is_refused() {
        let [zero, one] = [0, 1].map(BigInt::from);
        let new = |gaps| LocalKnots::new(gaps, (one.clone(), one.clone()));
        assert_eq!(new(vec![]), Err(LocalKnotsError::NoGap));
        assert_eq!(new(vec![zero.clone(), zero.clone()]), Err(LocalKnotsError::Empty));
        assert_eq!(new(vec![one.clone(), -one.clone()]), Err(LocalKnotsError::NegativeGap(1)));
        for wrong in [zero, -one.clone()] {
            for ratio in [(wrong.clone(), one.clone()), (one.clone(), wrong.clone())] {
                assert_eq!(LocalKnots::new(vec![one.clone()], ratio), Err(LocalKnotsError::Ratio));
            }
        }
    }
}
