//! The functions of a span over one denominator, which is known as a product of linear factors.

use num_rational::BigRational;

use crate::scalar::{Polynomial, Ring, integer};
use crate::spline::{Active, Basis, KnotVector, Span, Weights, triangle};

type Poly = Polynomial<BigRational>;

/// G_i^k = P_i/Q on a span [t_j, t_{j+1}], in its [positive coordinate](super::positive_coordinate) u, with
/// Q = ∏ (u + c) and every c > 0.
///
/// With a = t_i and b = t_{i+d}, a weight of the recursion (D3.3) is
///
/// w = r((t_j − a) + (t_{j+1} − a)u) / (A + Bu),
/// A = r(t_j − a) + (b − t_j), B = r(t_{j+1} − a) + (b − t_{j+1}).
///
/// From a ≤ t_j < t_{j+1} ≤ b and r > 0 follow A ≥ b − t_j > 0 and B ≥ r(t_{j+1} − a) > 0, so A + Bu = B(u + c)
/// with c = A/B > 0. Q takes, for each d = 1..k, each c that occurs there once: at most k(k + 1)/2 factors, and
/// just (u + 1)^k for α = ∞. The numerators of w and 1 − w have degree at most 1, so deg P_i ≤ deg Q.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct FactoredSpan {
    /// The c, each as often as u + c divides Q.
    pub(super) factors: Vec<BigRational>,
    /// The P_i of the functions that live on the span.
    pub(super) numerators: Active<Poly>,
}

impl FactoredSpan {
    /// Runs the triangle over the numerators: polynomials, without a single division.
    pub(super) fn of(basis: &Basis, span: Span) -> Self {
        let weights = NumeratorWeights::new(basis, span);
        let numerators = triangle(&weights, span, basis.degree(), basis.knots().m());
        Self { factors: weights.levels.into_iter().flatten().collect(), numerators }
    }
}

/// (w, 1 − w) times the factors of the denominator that belong to the same d: what is lacking to the homogeneous
/// form of the recursion, which needs sums and products only and never that the pair adds up to 1.
struct NumeratorWeights<'a> {
    knots: &'a KnotVector,
    ratio: &'a BigRational,
    span: Span,
    /// Entry d − 1 holds the different c of the weights w_i^d.
    levels: Vec<Vec<BigRational>>,
}

/// One weight as (rise, fall)/(u + c).
struct Weight {
    rise: Poly,
    fall: Poly,
    c: BigRational,
}

impl<'a> NumeratorWeights<'a> {
    fn new(basis: &'a Basis, span: Span) -> Self {
        let (knots, ratio) = (basis.knots(), basis.index().ratio());
        let mut weights = Self { knots, ratio, span, levels: Vec::new() };
        let j = span.index();
        for d in 1..=basis.degree() {
            // The intervals [t_i, t_{i+d}] that contain the span.
            let mut level: Vec<_> =
                ((j + 1).saturating_sub(d)..=j.min(knots.m() - d)).map(|i| weights.weight(i, d).c).collect();
            level.sort();
            level.dedup();
            weights.levels.push(level);
        }
        weights
    }

    fn weight(&self, i: usize, d: usize) -> Weight {
        let (a, b) = (self.knots.t(i), self.knots.t(i + d));
        let (start, end) = self.knots.ends(self.span);
        let rise = Polynomial::new(self.ratio * (start - a), [self.ratio * (end - a)]);
        let fall = Polynomial::new(b - start, [b - end]);
        let [constant, slope] = [(start, a, b), (end, a, b)].map(|(x, a, b)| self.ratio * (x - a) + (b - x));
        let inverse = slope.recip();
        Weight { rise: rise.scaled(&inverse), fall: fall.scaled(&inverse), c: constant * inverse }
    }
}

impl Weights for NumeratorWeights<'_> {
    type Scalar = Poly;

    fn one(&self) -> Poly {
        Polynomial::constant(integer(1))
    }

    fn pair(&self, i: usize, d: usize) -> (Poly, Poly) {
        let Weight { rise, fall, c } = self.weight(i, d);
        let others = product(self.levels[d - 1].iter().filter(|other| **other != c));
        (rise.times(&others), fall.times(&others))
    }
}

/// ∏ (u + c): monic, of degree the number of factors, and with positive coefficients if every c > 0.
pub(super) fn product<'a>(factors: impl IntoIterator<Item = &'a BigRational>) -> Poly {
    let one = Polynomial::constant(integer(1));
    factors.into_iter().fold(one, |product, c| product.times(&linear(c)))
}

/// u + c.
pub(super) fn linear(c: &BigRational) -> Poly {
    Polynomial::new(c.clone(), [integer(1)])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::Pieces;
    use crate::scalar::{RationalFunction, rational};
    use num_traits::Signed;

    /// The same functions as by the triangle over rational functions, on spans of every kind.
    #[test]
    fn numerators_over_the_product_are_the_pieces() {
        for knots in
            [&[0, 0, 0, 0, 1, 2, 2, 5, 5, 5, 5][..], &[0, 1, 2, 3, 4, 5, 6, 7], &[0, 0, 1, 1, 1, 1, 2, 4]]
        {
            let knots = KnotVector::new(knots.iter().map(|&t| rational(t, 1)).collect()).unwrap();
            for (degree, alpha) in [(0, "2"), (1, "-1"), (2, "5"), (3, "-1/7"), (3, "inf")] {
                let basis = Basis::new(knots.clone(), degree, alpha.parse().unwrap()).unwrap();
                for span in Pieces::of(&basis).spans() {
                    let factored = FactoredSpan::of(&basis, span.span);
                    assert!(factored.factors.iter().all(Signed::is_positive));
                    let q = product(&factored.factors);
                    let functions = factored.numerators.map(|p| RationalFunction::new(p, &q).unwrap());
                    assert_eq!(functions, span.functions);
                }
            }
        }
    }

    #[test]
    fn at_infinity_there_is_one_factor_for_each_degree() {
        let knots = KnotVector::new((0..8).map(integer).collect()).unwrap();
        let factors = |alpha: &str| {
            let basis = Basis::new(knots.clone(), 3, alpha.parse().unwrap()).unwrap();
            knots.spans().map(|span| FactoredSpan::of(&basis, span).factors.len()).collect::<Vec<_>>()
        };
        assert_eq!(factors("inf"), [3; 7]);
        assert_eq!(factors("-1"), [3, 5, 6, 6, 6, 5, 3]);
    }
}
