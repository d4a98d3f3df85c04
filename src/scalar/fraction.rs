//! Arithmetic of fractions in lowest terms.
//!
//! A sum or a product needs no common divisor of large numbers: what can cancel is known beforehand (Henrici 1956;
//! Knuth, The Art of Computer Programming 2, 4.5.1).

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed};

use super::gcd::{gcd, lcm};

/// numerator/denominator in lowest terms, for denominator ≠ 0.
pub(crate) fn fraction(numerator: BigInt, denominator: BigInt) -> BigRational {
    let common = gcd(&numerator, &denominator);
    let common = if denominator.is_negative() { -common } else { common };
    if common.is_one() {
        return BigRational::new_raw(numerator, denominator);
    }
    BigRational::new_raw(numerator / &common, denominator / common)
}

/// value/divisor, for a divisor of it.
pub(super) fn exact(value: &BigInt, divisor: &BigInt) -> BigInt {
    if divisor.is_one() { value.clone() } else { value / divisor }
}

/// a ± b, where `combine` is what + or − does to integers.
pub(super) fn sum(
    a: &BigRational,
    b: &BigRational,
    combine: impl Fn(BigInt, BigInt) -> BigInt,
) -> BigRational {
    let ((p, q), (s, t)) = ((a.numer(), a.denom()), (b.numer(), b.denom()));
    if q == t {
        let numerator = combine(p.clone(), s.clone());
        let common = if q.is_one() { BigInt::one() } else { gcd(&numerator, q) };
        return BigRational::new_raw(exact(&numerator, &common), exact(q, &common));
    }
    // A factor of 1 is no work, and with an integer nothing can cancel.
    let product = |a: &BigInt, b: &BigInt| if b.is_one() { a.clone() } else { a * b };
    let common = if q.is_one() || t.is_one() { BigInt::one() } else { gcd(q, t) };
    if common.is_one() {
        return BigRational::new_raw(combine(product(p, t), product(s, q)), product(q, t));
    }
    let (own, other) = (q / &common, t / &common);
    let numerator = combine(product(p, &other), product(s, &own));
    let cancelled = gcd(&numerator, &common);
    BigRational::new_raw(exact(&numerator, &cancelled), product(&own, &exact(t, &cancelled)))
}

/// (p/q)·(s/t), for both in lowest terms and q, t > 0.
pub(super) fn product((p, q): (&BigInt, &BigInt), (s, t): (&BigInt, &BigInt)) -> BigRational {
    if q.is_one() && t.is_one() {
        return BigRational::new_raw(p * s, BigInt::one());
    }
    let (left, right) = (gcd(p, t), gcd(s, q));
    BigRational::new_raw(exact(p, &left) * exact(s, &right), exact(q, &right) * exact(t, &left))
}

/// Integers c_i·d for the least d > 0, and d.
pub(crate) fn over_one_denominator(list: &[BigRational]) -> (Vec<BigInt>, BigInt) {
    let denominator = list.iter().fold(BigInt::one(), |common, c| lcm(&common, c.denom()));
    let numerator = |c: &BigRational| {
        if *c.denom() == denominator { c.numer().clone() } else { c.numer() * exact(&denominator, c.denom()) }
    };
    (list.iter().map(numerator).collect(), denominator)
}
