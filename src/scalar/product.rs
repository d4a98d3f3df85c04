//! The product of two sorted lists of terms: the one hot operation of [`Multivariate`](super::Multivariate).
//!
//! Monomials are packed into one integer each where they fit (mixed radix with the degrees of the product: a
//! Kronecker substitution), coefficients into `i128` where a bound on the sums proves that they fit; a product
//! that fills its box of exponents is added up in an array, any other one by sorting and merging.

use std::cmp::Ordering;
use std::ops::{AddAssign, Mul};

use num_bigint::BigInt;
use num_traits::Zero;

use super::monomial::Monomial;

/// Terms by falling monomial, none of them with coefficient 0.
pub(super) type Terms = Vec<(Monomial, BigInt)>;

/// The product of two polynomials.
///
/// Panics if an exponent of the product exceeds the bound of [`Monomial`]. The degrees of polynomials over the
/// integers add up, so the check of the degrees is the check of all terms.
pub(super) fn product(a: &[(Monomial, BigInt)], b: &[(Monomial, BigInt)]) -> Terms {
    let (a, b) = if a.len() <= b.len() { (a, b) } else { (b, a) };
    match a {
        [] => return Vec::new(),
        [(m, c)] => return b.iter().map(|(n, d)| (m.times(n), c * d)).collect(),
        _ => {}
    }
    let packing = Packing::new(&degrees(a).times(&degrees(b)));
    // A coefficient of the product is a sum of at most |a| products, so it has at most this many bits.
    let bits = bits(a) + bits(b) + u64::from(usize::BITS - a.len().leading_zeros());
    if bits < 127 {
        let terms = packed(&packing, &small(a), &small(b));
        return terms.into_iter().map(|(m, c)| (m, BigInt::from(c))).collect();
    }
    packed(&packing, a, b)
}

/// Of each variable the largest exponent.
pub(super) fn degrees(terms: &[(Monomial, BigInt)]) -> Monomial {
    terms.iter().fold(Monomial::ONE, |degrees, (m, _)| degrees.lcm(m))
}

fn bits(terms: &[(Monomial, BigInt)]) -> u64 {
    terms.iter().map(|(_, c)| c.bits()).max().unwrap_or(0)
}

/// Coefficients of at most 126 bits.
fn small(terms: &[(Monomial, BigInt)]) -> Vec<(Monomial, i128)> {
    let small = |c: &BigInt| match i128::try_from(c) {
        Ok(c) => c,
        Err(_) => unreachable!("{c} has less than 127 bits"),
    };
    terms.iter().map(|(m, c)| (*m, small(c))).collect()
}

/// What products and sums of coefficients are computed in: `BigInt`, or `i128` within a proved bound.
trait Coefficient: Clone + Zero + AddAssign {
    fn product(&self, rhs: &Self) -> Self;
}

impl<C: Clone + Zero + AddAssign> Coefficient for C
where
    for<'a> &'a C: Mul<&'a C, Output = C>,
{
    fn product(&self, rhs: &Self) -> Self {
        self * rhs
    }
}

/// What stands for a monomial: itself, or an integer with the same order and the same products.
trait Key: Copy + Ord {
    fn joined(self, rhs: Self) -> Self;
}

impl Key for Monomial {
    fn joined(self, rhs: Self) -> Self {
        self.times(&rhs)
    }
}

impl Key for usize {
    fn joined(self, rhs: Self) -> Self {
        self + rhs
    }
}

/// Monomials of bounded degrees as integers 0, …, size − 1, in the same order: mixed radix, x₀ first.
struct Packing {
    /// The variables that occur and the value of their digit.
    digits: Vec<(usize, usize)>,
    /// How many monomials there are; `None` if that is no `usize`.
    size: Option<usize>,
}

impl Packing {
    fn new(degrees: &Monomial) -> Self {
        let mut size = Some(1_usize);
        let mut digits = Vec::new();
        let variables: Vec<_> = degrees.exponents().collect();
        for (v, degree) in variables.into_iter().rev() {
            digits.push((v, size.unwrap_or(0)));
            size = size.and_then(|size| size.checked_mul(degree + 1));
        }
        digits.reverse();
        Self { digits, size }
    }

    fn pack(&self, m: &Monomial) -> usize {
        self.digits.iter().map(|(v, value)| m.exponent(*v) * value).sum()
    }

    fn unpack(&self, mut key: usize) -> Monomial {
        let mut m = Monomial::ONE;
        for (v, value) in &self.digits {
            m = m.with(*v, key / value);
            key %= value;
        }
        m
    }
}

/// An array is worth its zeros if there are at most this many of them for one product of two terms,
const SPARSITY: usize = 4;
/// and if it is not larger than this.
const LARGEST_ARRAY: usize = 1 << 22;

fn packed<C: Coefficient>(packing: &Packing, a: &[(Monomial, C)], b: &[(Monomial, C)]) -> Vec<(Monomial, C)> {
    let Some(size) = packing.size else {
        return by_sorting(a, b);
    };
    let pack = |terms: &[(Monomial, C)]| -> Vec<(usize, C)> {
        terms.iter().map(|(m, c)| (packing.pack(m), c.clone())).collect()
    };
    let (a, b) = (pack(a), pack(b));
    let dense = size <= LARGEST_ARRAY && size / SPARSITY <= a.len().saturating_mul(b.len());
    let terms = if dense { in_an_array(size, &a, &b) } else { by_sorting(&a, &b) };
    terms.into_iter().map(|(key, c)| (packing.unpack(key), c)).collect()
}

fn in_an_array<C: Coefficient>(size: usize, a: &[(usize, C)], b: &[(usize, C)]) -> Vec<(usize, C)> {
    let mut sums = vec![C::zero(); size];
    for (key, c) in a {
        for (other, d) in b {
            sums[key + other] += c.product(d);
        }
    }
    sums.into_iter().enumerate().rev().filter(|(_, c)| !c.is_zero()).collect()
}

/// So many products are sorted at once; more are split, so that equal monomials meet early.
const SORTED_AT_ONCE: usize = 1 << 12;

fn by_sorting<K: Key, C: Coefficient>(a: &[(K, C)], b: &[(K, C)]) -> Vec<(K, C)> {
    let (short, long) = if a.len() <= b.len() { (a, b) } else { (b, a) };
    if short.len() * long.len() > SORTED_AT_ONCE && long.len() > 1 {
        let (high, low) = long.split_at(long.len() / 2);
        return merged(by_sorting(short, high).into_iter(), by_sorting(short, low).into_iter());
    }
    let row = |(key, c): &(K, C)| -> Vec<(K, C)> {
        long.iter().map(|(other, d)| (key.joined(*other), c.product(d))).collect()
    };
    let mut products: Vec<_> = short.iter().flat_map(row).collect();
    // Stable: the sort of the standard library that merges the rows, which are in order already.
    products.sort_by_key(|(key, _)| std::cmp::Reverse(*key));
    let mut sums: Vec<(K, C)> = Vec::with_capacity(products.len());
    for (key, c) in products {
        match sums.last_mut() {
            Some((last, sum)) if *last == key => *sum += c,
            _ => sums.push((key, c)),
        }
    }
    sums.retain(|(_, c)| !c.is_zero());
    sums
}

/// The sum of two polynomials.
pub(super) fn merged<K: Ord, C: Zero + AddAssign>(
    left: impl Iterator<Item = (K, C)>,
    right: impl Iterator<Item = (K, C)>,
) -> Vec<(K, C)> {
    let (mut left, mut right) = (left.peekable(), right.peekable());
    let mut sum = Vec::with_capacity(left.size_hint().0.max(right.size_hint().0));
    while let (Some((a, _)), Some((b, _))) = (left.peek(), right.peek()) {
        match a.cmp(b) {
            Ordering::Greater => sum.extend(left.next()),
            Ordering::Less => sum.extend(right.next()),
            Ordering::Equal => {
                let both = left.next().zip(right.next());
                sum.extend(both.and_then(|((key, mut c), (_, d))| {
                    c += d;
                    (!c.is_zero()).then_some((key, c))
                }));
            }
        }
    }
    sum.extend(left);
    sum.extend(right);
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    /// `length` terms spread over `variables` variables with exponents up to 3, coefficients of `bits` bits.
    fn sample(length: usize, variables: usize, bits: u32, seed: u64) -> Terms {
        let mut state = seed;
        let mut next = |n: usize| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            usize::try_from(state >> 33).expect("31 bits") % n
        };
        let mut terms = std::collections::BTreeMap::new();
        for _ in 0..length {
            let m = (0..variables).fold(Monomial::ONE, |m, v| m.with(v * 47 / variables, next(4)));
            let c = (BigInt::from(1) << bits) - BigInt::from(next(2)) * (BigInt::from(2) << bits) + next(7);
            terms.insert(m, c);
        }
        terms.into_iter().rev().collect()
    }

    fn term_by_term(a: &Terms, b: &Terms) -> Terms {
        let mut sums = std::collections::BTreeMap::new();
        for (m, c) in a {
            for (n, d) in b {
                *sums.entry(m.times(n)).or_insert_with(BigInt::zero) += c * d;
            }
        }
        sums.into_iter().rev().filter(|(_, c)| !c.is_zero()).collect()
    }

    /// Arrays and sorting, packed or not, small coefficients and large ones: the same product.
    #[test]
    fn all_ways_agree_with_the_definition() {
        for (length, variables) in [(1, 3), (2, 1), (12, 2), (90, 3), (70, 20), (90, 40)] {
            for bits in [2, 58, 60, 61, 62, 63, 64, 200] {
                let (a, b) = (sample(length, variables, bits, 1), sample(length + 3, variables, bits, 2));
                assert_eq!(product(&a, &b), term_by_term(&a, &b), "{length} {variables} {bits}");
            }
        }
    }

    /// Each way on the same terms, whichever would have been chosen.
    #[test]
    fn an_array_is_as_good_as_sorting() {
        let (a, b) = (sample(150, 4, 20, 3), sample(140, 4, 20, 4));
        let packing = Packing::new(&degrees(&a).times(&degrees(&b)));
        let size = packing.size.expect("7⁴ monomials");
        let pack =
            |terms: &Terms| -> Vec<_> { terms.iter().map(|(m, c)| (packing.pack(m), c.clone())).collect() };
        let (p, q) = (pack(&a), pack(&b));
        assert_eq!(in_an_array(size, &p, &q), by_sorting(&p, &q));
        assert_eq!(pack(&by_sorting(&a, &b)), by_sorting(&p, &q));
        assert_eq!(by_sorting(&a, &b), term_by_term(&a, &b));
    }
}
