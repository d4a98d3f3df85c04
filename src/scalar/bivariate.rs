//! Polynomials in two variables, in one list of coefficients.

use super::polynomial::Polynomial;
use super::ring::{Additive, Ring, ScaleBy};

/// Σ c_{a,b} u^a r^b with a below a bound that all polynomials of one computation have in common.
#[derive(Debug, Clone)]
pub(crate) struct Bivariate<R> {
    /// The bound for a: c_{a,b} is at b·stride + a.
    stride: usize,
    /// 1 + the degree in u, or more.
    columns: usize,
    /// As many rows, of `stride` each, as the degree in r asks for.
    coefficients: Vec<R>,
}

/// (a₀ + a₁r) + (b₀ + b₁r)u, as [(a₀, a₁), (b₀, b₁)].
pub(crate) type Bilinear<R> = [(R, R); 2];

impl<R: Ring> Bivariate<R> {
    /// 1, for degrees in u below the bound; `like` is of its ring.
    pub(crate) fn one(like: &R, bound: usize) -> Self {
        let mut coefficients = vec![like.zero(); bound];
        coefficients[0] = like.one();
        Self { stride: bound, columns: 1, coefficients }
    }

    /// As a polynomial in u with polynomials in r for coefficients, in another ring.
    pub(crate) fn to_polynomial<T: Ring>(&self, image: impl Fn(&R) -> T) -> Polynomial<Polynomial<T>> {
        let rows = self.coefficients.len() / self.stride;
        let in_r = |a: usize| {
            let mut column = (0..rows).map(|b| image(&self.coefficients[b * self.stride + a]));
            let first = column.next().unwrap_or_else(|| image(&self.coefficients[0]).zero());
            Polynomial::new(first, column)
        };
        Polynomial::new(in_r(0), (1..self.columns).map(in_r))
    }
}

impl<R: Ring> Additive for Bivariate<R> {
    fn accumulate(&mut self, rhs: &Self) {
        let zero = rhs.coefficients[0].zero();
        self.columns = self.columns.max(rhs.columns);
        self.coefficients.resize(self.coefficients.len().max(rhs.coefficients.len()), zero);
        for (own, other) in
            self.coefficients.chunks_mut(self.stride).zip(rhs.coefficients.chunks(self.stride))
        {
            for (own, other) in own.iter_mut().zip(&other[..rhs.columns]) {
                own.increase(other);
            }
        }
    }
}

impl<R: Ring> ScaleBy<Bilinear<R>> for Bivariate<R> {
    fn scale_by<'a>(&mut self, factors: impl Iterator<Item = &'a Bilinear<R>>)
    where
        R: 'a,
    {
        let zero = self.coefficients[0].zero();
        for [a, b] in factors {
            let with_r = !a.1.is_zero() || !b.1.is_zero();
            if with_r {
                self.coefficients.resize(self.coefficients.len() + self.stride, zero.clone());
            }
            self.columns += 1;
            let rows = self.coefficients.len() / self.stride;
            for row in (0..rows).rev() {
                let (before, from) = self.coefficients.split_at_mut(row * self.stride);
                let below =
                    before.len().checked_sub(self.stride).filter(|_| with_r).map(|start| &before[start..]);
                multiply_row(&mut from[..self.columns], below, a, b);
            }
        }
    }
}

/// The coefficients of one power of r, from those of it and of the power below.
fn multiply_row<R: Ring>(row: &mut [R], below: Option<&[R]>, a: &(R, R), b: &(R, R)) {
    for place in (0..row.len()).rev() {
        let mut value = row[place].times(&a.0);
        if place > 0 {
            value.increase(&row[place - 1].times(&b.0));
        }
        if let Some(below) = below {
            value.increase(&below[place].times(&a.1));
            if place > 0 {
                value.increase(&below[place - 1].times(&b.1));
            }
        }
        row[place] = value;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use num_bigint::BigInt;

    fn integers(list: [i64; 4]) -> Bilinear<BigInt> {
        let [a, b, c, d] = list.map(BigInt::from);
        [(a, b), (c, d)]
    }

    /// The same as by polynomials of polynomials.
    #[test]
    fn products_and_sums() {
        let factors = [[2, 0, 1, 0], [0, 3, 0, 4], [1, 2, 3, 4], [5, 0, 0, 0], [0, 1, 2, 0]].map(integers);
        let one = BigInt::from(1);
        let mut flat = Bivariate::one(&one, 9);
        let mut nested = Polynomial::constant(Polynomial::constant(one.clone()));
        for factor in &factors {
            let before = (flat.clone(), nested.clone());
            flat.scale_by(std::iter::once(factor));
            let [a, b] = factor.clone().map(|(constant, slope)| Polynomial::new(constant, [slope]));
            nested = nested.times(&Polynomial::new(a, [b]));
            assert_eq!(flat.to_polynomial(BigInt::clone), nested);
            let mut sum = before.0;
            sum.accumulate(&flat);
            assert_eq!(sum.to_polynomial(BigInt::clone), before.1.plus(&nested));
        }
    }
}
