//! Polynomials in two variables on a box, by their Bernstein coefficients.

use num_bigint::BigInt;
use num_integer::{Integer, binomial};
use num_traits::{One, Signed, Zero};

use crate::scalar::Polynomial;

/// A positive multiple of a polynomial N(y, t) on a box, in the tensor Bernstein basis: entry (i, j) belongs to
/// the i-th Bernstein polynomial in y and the j-th in t, both on the sides of the box.
///
/// The polynomial lies between its least and its largest coefficient, and equals them at the corners; the
/// coefficients of a derivative are, up to a positive factor, the differences of neighbours.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct BernsteinTable {
    rows: Vec<Vec<BigInt>>,
}

/// The signs that the entries of a list have.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Signs {
    /// All are 0.
    Zero,
    /// ≥ 0, and one is > 0.
    Positive,
    /// ≤ 0, and one is < 0.
    Negative,
    /// Both signs occur.
    Mixed,
}

impl Signs {
    pub(super) fn of(entries: impl Iterator<Item = impl std::borrow::Borrow<BigInt>>) -> Self {
        let mut signs = Self::Zero;
        for entry in entries {
            let entry = entry.borrow();
            signs = match signs {
                _ if entry.is_zero() => signs,
                Self::Negative | Self::Zero if entry.is_negative() => Self::Negative,
                Self::Positive | Self::Zero if entry.is_positive() => Self::Positive,
                _ => return Self::Mixed,
            };
        }
        signs
    }

    /// One sign, weakly, on the whole box.
    pub(super) fn is_constant(self) -> bool {
        self != Self::Mixed
    }
}

/// Where a side is divided: at LEFT_WEIGHTS/2^WEIGHT_BITS of its length, in the order of preference.
const LEFT_WEIGHTS: [u32; 3] = [4, 3, 5];
const WEIGHT_BITS: usize = 3;

impl BernsteinTable {
    /// From Σ c_i(t)·uⁱ of degree n in u: the function (1 − y)ⁿN(y/(1 − y), t) on the unit square, where
    /// y = u/(1 + u).
    pub(super) fn on_unit_square(polynomial: &Polynomial<Polynomial<BigInt>>) -> Self {
        let rows = polynomial.coefficients();
        let degree = rows.iter().map(Polynomial::degree).max().unwrap_or(0);
        let (n, scale) = (rows.len() - 1, common_binomial(rows.len() - 1));
        let (mut row_factor, mut factors) = (BigInt::one(), Vec::with_capacity(rows.len()));
        for i in 0..=n {
            factors.push(&scale / &row_factor);
            row_factor = row_factor * (n - i) / (i + 1);
        }
        let rows = rows
            .iter()
            .zip(factors)
            .map(|(row, factor)| unit_bernstein(row, degree).into_iter().map(|c| c * &factor).collect());
        Self { rows: rows.collect() }.without_powers_of_two()
    }

    /// The coefficients in t for the i-th Bernstein polynomial in y.
    pub(super) fn row(&self, i: usize) -> &[BigInt] {
        &self.rows[i]
    }

    pub(super) fn rows(&self) -> &[Vec<BigInt>] {
        &self.rows
    }

    /// The signs of N.
    pub(super) fn signs(&self) -> Signs {
        Signs::of(self.rows.iter().flatten())
    }

    /// The signs of ∂N/∂y.
    pub(super) fn signs_of_y_derivative(&self) -> Signs {
        let pairs = self.rows.windows(2).flat_map(|pair| pair[0].iter().zip(&pair[1]));
        Signs::of(pairs.map(|(a, b)| b - a))
    }

    /// The signs of ∂²N/∂y².
    pub(super) fn signs_of_second_y_derivative(&self) -> Signs {
        let triples = self.rows.windows(3).flat_map(|rows| {
            rows[0].iter().zip(&rows[1]).zip(&rows[2]).map(|((a, b), c)| a - (b << 1_u32) + c)
        });
        Signs::of(triples)
    }

    /// The signs of ∂N/∂t.
    pub(super) fn signs_of_t_derivative(&self) -> Signs {
        Signs::of(self.rows.iter().flat_map(|row| row.windows(2).map(|pair| &pair[1] - &pair[0])))
    }

    /// The two halves in t.
    pub(super) fn halved_in_t(&self) -> (Self, Self) {
        let halves = self.rows.iter().map(|row| {
            let (mut left, mut right) = (row.clone(), Vec::with_capacity(row.len()));
            divide(&mut left, &mut right, |a, b| a + b, 1);
            (left, right)
        });
        let (left, right) = halves.unzip();
        (Self { rows: left }.without_powers_of_two(), Self { rows: right }.without_powers_of_two())
    }

    /// Two parts in y, with a line between on which `wanted` holds, if one of a few does; `wanted` sees the
    /// coefficients on the line.
    pub(super) fn divided_in_y(&self, wanted: impl Fn(&[BigInt]) -> bool) -> Option<(Self, Self)> {
        LEFT_WEIGHTS.iter().find_map(|&weight| {
            let (left, right) = self.divided_at(weight);
            right
                .rows
                .first()
                .is_some_and(|line| wanted(line))
                .then(|| (left.without_powers_of_two(), right.without_powers_of_two()))
        })
    }

    fn divided_at(&self, weight: u32) -> (Self, Self) {
        let other = (1_u32 << WEIGHT_BITS) - weight;
        let (mut left, mut right) = (self.rows.clone(), Vec::with_capacity(self.rows.len()));
        let mean = |a: &Vec<BigInt>, b: &Vec<BigInt>| -> Vec<BigInt> {
            a.iter().zip(b).map(|(a, b)| a * other + b * weight).collect()
        };
        divide(&mut left, &mut right, mean, WEIGHT_BITS);
        (Self { rows: left }, Self { rows: right })
    }

    fn without_powers_of_two(mut self) -> Self {
        let powers = self.rows.iter().flatten().filter_map(BigInt::trailing_zeros).min().unwrap_or(0);
        if powers > 0 {
            for c in self.rows.iter_mut().flatten() {
                *c >>= powers;
            }
        }
        self
    }
}

/// Multiplication by a power of two.
trait Scale {
    fn scale(&mut self, bits: usize);
}

impl Scale for BigInt {
    fn scale(&mut self, bits: usize) {
        *self <<= bits;
    }
}

impl Scale for Vec<BigInt> {
    fn scale(&mut self, bits: usize) {
        for c in self {
            *c <<= bits;
        }
    }
}

/// De Casteljau's algorithm: `left` holds the coefficients, and then those of the left part; `right` those of the
/// right one. `mean` is 2^bits times a weighted mean.
fn divide<T: Scale + Clone>(left: &mut [T], right: &mut Vec<T>, mean: impl Fn(&T, &T) -> T, bits: usize) {
    let n = left.len().saturating_sub(1);
    right.extend(left.last().cloned());
    for level in 1..=n {
        for i in (level..=n).rev() {
            left[i] = mean(&left[i - 1], &left[i]);
        }
        right.extend(left.last().cloned());
    }
    right.reverse();
    // Entry i of the left part has been through i means, and that of the right one through n − i.
    for (i, c) in left.iter_mut().enumerate() {
        c.scale((n - i) * bits);
    }
    for (i, c) in right.iter_mut().enumerate() {
        c.scale(i * bits);
    }
}

/// lcm of C(n, 0), …, C(n, n), which is lcm(1, …, n + 1)/(n + 1).
fn common_binomial(n: usize) -> BigInt {
    (0..=n).fold(BigInt::one(), |common, i| common.lcm(&binomial(BigInt::from(n), BigInt::from(i))))
}

/// A fixed multiple of the Bernstein coefficients on [0, 1] for a degree ≥ that of p: with p = Σ a_l t^l they are
/// Σ_l C(j, l)/C(degree, l)·a_l.
fn unit_bernstein(p: &Polynomial<BigInt>, degree: usize) -> Vec<BigInt> {
    let scale = common_binomial(degree);
    let choose = |n: usize, l: usize| binomial(BigInt::from(n), BigInt::from(l));
    let zero = BigInt::zero();
    let mut c: Vec<BigInt> = (0..=degree)
        .map(|l| p.coefficients().get(l).unwrap_or(&zero) * (&scale / choose(degree, l)))
        .collect();
    // Σ_l C(j, l)·c_l for every j, by Pascal's rule: the inverse of taking differences.
    for start in 0..degree {
        for j in (start + 1..=degree).rev() {
            let (low, high) = c.split_at_mut(j);
            high[0] += &low[j - 1];
        }
    }
    c
}

#[cfg(test)]
mod tests {
    use super::*;

    fn polynomial(rows: &[&[i64]]) -> Polynomial<Polynomial<BigInt>> {
        let row = |row: &&[i64]| Polynomial::new(row[0].into(), row[1..].iter().map(|&c| c.into()));
        Polynomial::new(row(&rows[0]), rows[1..].iter().map(row))
    }

    fn integers(list: &[i64]) -> Vec<BigInt> {
        list.iter().map(|&c| c.into()).collect()
    }

    #[test]
    fn coefficients_on_the_unit_interval() {
        // t² is 0, 0, 1, and 1 + 2t is 1, 2, 3, both times lcm(1, 2, 1).
        let p = |c: &[i64]| Polynomial::new(c[0].into(), c[1..].iter().map(|&c| BigInt::from(c)));
        assert_eq!(unit_bernstein(&p(&[0, 0, 1]), 2), integers(&[0, 0, 2]));
        assert_eq!(unit_bernstein(&p(&[1, 2]), 2), integers(&[2, 4, 6]));
        // t³ is 0, 0, 0, 1 and t is 0, 1/3, 2/3, 1.
        assert_eq!(unit_bernstein(&p(&[0, 1, 0, 3]), 3), integers(&[0, 1, 2, 12]));
    }

    #[test]
    fn parts_are_the_same_polynomial() {
        // u² − 2tu + t is y² − 2ty(1 − y) + t(1 − y)².
        let table = BernsteinTable::on_unit_square(&polynomial(&[&[0, 1], &[0, -2], &[1]]));
        assert_eq!(table.rows, [integers(&[0, 1]), integers(&[0, -1]), integers(&[1, 1])]);
        let (low, high) = table.halved_in_t();
        assert_eq!(low.rows, [integers(&[0, 1]), integers(&[0, -1]), integers(&[2, 2])]);
        assert_eq!(high.rows, [integers(&[1, 2]), integers(&[-1, -2]), integers(&[2, 2])]);
        // At y = 1/2: (1 − t)/4.
        let (left, right) = table.divided_at(4);
        let line: Vec<_> = left.rows[2].clone();
        assert_eq!(line, right.rows[0]);
        assert!(line[1].is_zero());
        assert!(line[0].is_positive());
    }
}
