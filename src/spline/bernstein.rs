//! The closed form of P3.3.

use num_bigint::BigInt;
use num_rational::BigRational;

use crate::scalar::RationalAlgebra;

/// C(k, i) = k!/(i!(k − i)!), 0 for i > k.
#[must_use]
pub fn binomial(k: usize, i: usize) -> BigRational {
    if i > k {
        return BigRational::from_integer(0.into());
    }
    let i = i.min(k - i);
    let product = |from: usize, count: usize| (from..=k).take(count).fold(BigInt::from(1), |p, f| p * f);
    BigRational::new(product((k - i).saturating_add(1), i), (1..=i).fold(BigInt::from(1), |p, f| p * f))
}

/// B_i^k = C(k, i) w^i (1 − w)^{k−i} (P3.3.2), from w and 1 − w; 0 for i > k.
pub fn bernstein<S: RationalAlgebra>(k: usize, i: usize, (w, complement): (&S, &S)) -> S {
    let coefficient = w.embed(&binomial(k, i));
    coefficient.times(&w.power(i)).times(&complement.power(k.saturating_sub(i)))
}
