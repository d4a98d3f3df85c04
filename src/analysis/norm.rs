//! Polynomials that vanish at the values of a function at the roots of another polynomial.

use num_rational::BigRational;

use crate::scalar::{Polynomial, Ring, integer};

/// N(y) = ∏ (P(ξ) − y·Q(ξ)) over the complex roots ξ of m, each as often as it is one: 0 at y = P(ξ)/Q(ξ) for each of them. Of
/// degree deg m at most, by its values at y = 0, …, deg m.
///
/// It is not 0 as a whole where no root of m is one of both P and Q.
pub(super) fn norm(
    m: &Polynomial<BigRational>,
    numerator: &Polynomial<BigRational>,
    denominator: &Polynomial<BigRational>,
) -> Polynomial<BigRational> {
    let value = |y: usize| product_over_roots(m, &numerator.minus(&denominator.scaled(&integer(y))));
    interpolated((0..=m.degree()).map(value).collect())
}

/// ∏ g(ξ) over the roots ξ of m, by Euclid's algorithm: with g reduced modulo m, d = deg m and e = deg g it is
/// (−1)^(de) lc(g)^d lc(m)^(−e) ∏ m(η) over the roots η of g.
fn product_over_roots(m: &Polynomial<BigRational>, g: &Polynomial<BigRational>) -> BigRational {
    let (mut m, mut g, mut factor) = (m.clone(), g.clone(), integer(1));
    loop {
        let d = m.degree();
        let Some((_, rest)) = g.divide(&m) else { return integer(0) };
        g = rest;
        let e = g.degree();
        if d == 0 || g.is_zero() {
            return if d == 0 { factor } else { integer(0) };
        }
        factor = factor * g.leading().power(d) / m.leading().power(e);
        if d * e % 2 == 1 {
            factor = -factor;
        }
        std::mem::swap(&mut m, &mut g);
    }
}

/// The polynomial with these values at 0, 1, 2, …, by Newton's divided differences.
fn interpolated(mut values: Vec<BigRational>) -> Polynomial<BigRational> {
    let mut differences = Vec::with_capacity(values.len());
    for order in 1..=values.len() {
        differences.push(values[0].clone());
        values = values.windows(2).map(|pair| (&pair[1] - &pair[0]) / integer(order)).collect();
    }
    let zero = Polynomial::constant(integer(0));
    differences.iter().enumerate().rev().fold(zero, |sum, (place, difference)| {
        let factor = Polynomial::new(-integer(place), [integer(1)]);
        sum.times(&factor).plus(&Polynomial::constant(difference.clone()))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn polynomial(coefficients: &[usize]) -> Polynomial<BigRational> {
        Polynomial::new(integer(coefficients[0]), coefficients[1..].iter().map(|&c| integer(c)))
    }

    #[test]
    fn norms_vanish_at_values() {
        // u² + u − 6 has the roots 2 and −3, where (u + 1)/(u + 4) is 1/2 and −2.
        let m = Polynomial::new(integer(6).negate(), [1, 1].map(integer));
        let n = norm(&m, &polynomial(&[1, 1]), &polynomial(&[4, 1]));
        assert_eq!(n.degree(), 2);
        let half = BigRational::new(1.into(), 2.into());
        for (y, zero) in [(half, true), (integer(2).negate(), true), (integer(1), false)] {
            assert_eq!(n.evaluate(&y).is_zero(), zero, "{y}");
        }
        // u² − 2: the value of u² is 2, twice.
        let m = Polynomial::new(integer(2).negate(), [0, 1].map(integer));
        let n = norm(&m, &polynomial(&[0, 0, 1]), &polynomial(&[1]));
        assert_eq!(n.coefficients(), [4, -4, 1].map(|c| BigRational::from_integer(c.into())));
    }
}
