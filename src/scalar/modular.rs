//! Polynomials modulo one large prime: a quick look at what integer polynomials can have in common.

use num_bigint::BigInt;
use num_traits::Signed;

/// 2⁶¹ − 1, a prime below which products fit into `u128`.
const PRIME: u64 = (1 << 61) - 1;

/// The image of an integer polynomial that keeps its degree, by rising powers, with a last coefficient ≠ 0.
#[derive(Debug, Clone)]
pub(super) struct ModularPolynomial(Vec<u64>);

impl ModularPolynomial {
    /// `None` if the prime divides the leading coefficient, and for the polynomial 0.
    pub(super) fn of(coefficients: &[BigInt]) -> Option<Self> {
        residue(coefficients.last()?).ne(&0).then(|| Self(coefficients.iter().map(residue).collect()))
    }

    /// The degree of the greatest common divisor of the images.
    ///
    /// That over the integers keeps its degree and divides both images: so it has this degree at most.
    pub(super) fn degree_of_gcd(&self, rhs: &Self) -> usize {
        degree_of_gcd(self.0.clone(), rhs.0.clone())
    }

    /// Is there no repeated factor, which would divide the derivative too? Then there is none over the integers.
    pub(super) fn is_square_free(&self) -> bool {
        let derivative = (0..PRIME).zip(&self.0).skip(1).map(|(i, &c)| product(i, c)).collect();
        degree_of_gcd(self.0.clone(), derivative) == 0
    }
}

/// Could a polynomial with these coefficients, by rising powers, vanish at −a/b? All are given modulo the prime, a and b
/// not 0 there. If not, it does not.
pub(crate) fn may_vanish(coefficients: &[u64], (a, b): (u64, u64)) -> bool {
    // Σ c_i (−a)^i b^(n−i), by Horner's rule.
    let (mut value, mut power) = (0, 1);
    for c in coefficients.iter().rev() {
        value = reduced(u128::from(value) * u128::from(PRIME - a) + u128::from(*c) * u128::from(power));
        power = product(power, b);
    }
    value == 0
}

/// Modulo each of these an irreducible polynomial of a higher degree has no root more often than one time in three.
pub(super) const SMALL_PRIMES: [u64; 16] =
    [53, 59, 61, 67, 71, 73, 79, 83, 89, 97, 101, 103, 107, 109, 113, 127];

/// Does the polynomial keep its degree modulo this prime, and have no root there? A rational root a/d in lowest terms would
/// be one: d divides the leading coefficient, and so the prime does not divide d.
pub(super) fn has_no_root(coefficients: &[BigInt], prime: u64) -> bool {
    let image: Vec<u64> = coefficients
        .iter()
        .map(|c| {
            let digits = c.magnitude().iter_u32_digits().rev();
            let magnitude = digits.fold(0, |rest, digit| (rest << 32 | u64::from(digit)) % prime);
            if c.is_negative() { prime - magnitude } else { magnitude }
        })
        .collect();
    image.last().is_some_and(|leading| leading % prime != 0)
        && (0..prime).all(|u| image.iter().rev().fold(0, |value, c| (value * u + c) % prime) != 0)
}

/// By Euclid's algorithm, for a last coefficient of `a` ≠ 0.
fn degree_of_gcd(mut a: Vec<u64>, mut b: Vec<u64>) -> usize {
    while let Some(leading) = strip(&mut b) {
        let inverse = inverse(leading);
        while a.len() >= b.len() {
            let Some(&top) = a.last() else { break };
            let factor = PRIME - product(top, inverse);
            let shift = a.len() - b.len();
            for (a, &c) in a[shift..].iter_mut().zip(&b) {
                *a = reduced(u128::from(*a) + u128::from(factor) * u128::from(c));
            }
            a.pop();
        }
        std::mem::swap(&mut a, &mut b);
    }
    a.len() - 1
}

/// Drops leading zeros; the leading coefficient, if any is left.
fn strip(coefficients: &mut Vec<u64>) -> Option<u64> {
    while coefficients.last() == Some(&0) {
        coefficients.pop();
    }
    coefficients.last().copied()
}

/// The value modulo 2⁶¹ − 1.
pub(crate) fn residue(value: &BigInt) -> u64 {
    let digits = value.magnitude().iter_u64_digits().rev();
    let magnitude = digits.fold(0, |rest, digit| reduced(u128::from(rest) << 64 | u128::from(digit)));
    if value.is_negative() && magnitude != 0 { PRIME - magnitude } else { magnitude }
}

/// The value modulo 2⁶¹ − 1, for a value below 2¹²⁵: the higher bits count as much as the lower ones.
fn reduced(value: u128) -> u64 {
    let prime = u128::from(PRIME);
    let once = (value & prime) + (value >> 61);
    match u64::try_from((once & prime) + (once >> 61)) {
        Ok(twice) if twice >= PRIME => twice - PRIME,
        Ok(twice) => twice,
        Err(_) => unreachable!("62 bits are left"),
    }
}

/// A number for each variable: a place for polynomials in many variables, the same in every run.
pub(super) fn coordinate(v: usize) -> u64 {
    // Multiples of the golden ratio, stirred: numbers that no relation between variables in use is made to fit.
    let mut word = (v as u64 + 1).wrapping_mul(0x9E37_79B9_7F4A_7C15);
    word = (word ^ word >> 30).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    reduced(u128::from(word ^ word >> 27))
}

pub(super) fn sum(a: u64, b: u64) -> u64 {
    reduced(u128::from(a) + u128::from(b))
}

pub(super) fn product(a: u64, b: u64) -> u64 {
    reduced(u128::from(a) * u128::from(b))
}

pub(super) fn power(mut base: u64, mut exponent: u64) -> u64 {
    let mut result = 1;
    while exponent > 0 {
        if exponent % 2 == 1 {
            result = product(result, base);
        }
        base = product(base, base);
        exponent /= 2;
    }
    result
}

/// 1/a for an a ≠ 0, by Fermat's little theorem.
fn inverse(a: u64) -> u64 {
    power(a, PRIME - 2)
}

#[cfg(test)]
mod tests {
    use num_integer::Integer;

    use super::*;

    fn image(coefficients: &[i64]) -> Option<ModularPolynomial> {
        ModularPolynomial::of(&coefficients.iter().map(|&c| c.into()).collect::<Vec<_>>())
    }

    #[test]
    fn residues() {
        let prime = BigInt::from(PRIME);
        for bits in [0_usize, 1, 60, 61, 62, 64, 122, 125, 128, 300] {
            for off in -3..=3 {
                let value: BigInt = (BigInt::from(1) << bits) + off;
                for value in [value.clone(), -&value, &value * PRIME, value * (PRIME - 1)] {
                    assert_eq!(BigInt::from(residue(&value)), value.mod_floor(&prime), "{value}");
                }
            }
        }
        assert_eq!(product(PRIME - 1, PRIME - 1), 1);
        assert_eq!(reduced((1 << 125) - 1), 7);
        assert_eq!(product(inverse(12_345), 12_345), 1);
        assert_eq!((sum(PRIME - 1, 1), sum(5, 7), power(3, 5), power(3, 0)), (0, 12, 243, 1));
    }

    #[test]
    fn roots_modulo_small_primes() {
        let none = |c: &[i64]| {
            let c: Vec<BigInt> = c.iter().map(|&c| c.into()).collect();
            SMALL_PRIMES.map(|prime| has_no_root(&c, prime))
        };
        // −1 is a square modulo the primes of the form 4n + 1.
        assert_eq!(none(&[1, 0, 1]), SMALL_PRIMES.map(|prime| prime % 4 == 3));
        assert_eq!(
            none(&[1 + (53 << 33), 0, 1]),
            SMALL_PRIMES.map(|prime| { (0..prime).all(|u| (u * u + 1 + (53 << 33)) % prime != 0) })
        );
        // 3/7; the root 1/53 is at infinity modulo 53.
        assert_eq!(none(&[-3, 7]), [false; 16]);
        assert_eq!(none(&[-1, 53]), [false; 16]);
        assert_eq!(none(&[-53, 0, 53]), [false; 16]);
        assert_eq!(none(&[5]), [true; 16]);
    }

    #[test]
    fn degrees_of_common_divisors() {
        // (u − 1)(u + 2)² and (u + 2)(u² + 1).
        let (p, q) = (image(&[-4, 0, 3, 1]).unwrap(), image(&[2, 1, 2, 1]).unwrap());
        assert_eq!((p.degree_of_gcd(&q), q.degree_of_gcd(&p), p.degree_of_gcd(&p)), (1, 1, 3));
        assert_eq!((p.is_square_free(), q.is_square_free()), (false, true));
        assert_eq!(p.degree_of_gcd(&image(&[7]).unwrap()), 0);
        assert!(image(&[]).is_none() && image(&[1, 0]).is_none());
        assert!(image(&[1, (1 << 61) - 1]).is_none(), "the degree would drop");
    }
}
