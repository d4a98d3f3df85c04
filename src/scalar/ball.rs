//! Polynomials as floats with one bound of their relative error: what decides signs quickly, and knows when it does not.

use std::cmp::Ordering;

use super::ring::{Additive, ScaleBy};

/// Σ c_i u^i with whole c_i ≥ 0, each known as a float of which a number of roundings is known.
///
/// As nothing is subtracted, a sum is as good as the worse of its parts and one rounding more, and a product has the roundings of
/// both and one of its own. So a float c after n roundings, u = 2^−53, is C(1 + θ), |θ| ≤ γ_n = nu/(1 − nu), for the exact C (Higham,
/// Accuracy and Stability of Numerical Algorithms, lemma 3.1): where C is not 0 all numbers on the way are 1 or more, and none
/// underflows. What overflows is ∞, or not a number, from there on.
#[derive(Debug)]
pub(crate) struct BallPolynomial {
    coefficients: Vec<f64>,
    roundings: u32,
    /// Those of the factors that it is multiplied by.
    of_factor: u32,
}

impl Clone for BallPolynomial {
    /// With as much room to grow.
    fn clone(&self) -> Self {
        let mut coefficients = Vec::with_capacity(self.coefficients.capacity());
        coefficients.extend_from_slice(&self.coefficients);
        Self { coefficients, ..*self }
    }
    /// In the memory that is there already.
    fn clone_from(&mut self, source: &Self) {
        self.coefficients.clone_from(&source.coefficients);
        (self.roundings, self.of_factor) = (source.roundings, source.of_factor);
    }
}

impl BallPolynomial {
    /// The polynomial 1, to be multiplied by factors after so many roundings, and room for so many coefficients, in its clones too.
    pub(crate) fn one(of_factor: u32, room: usize) -> Self {
        let mut coefficients = Vec::with_capacity(room.max(1));
        coefficients.push(1.0);
        Self { coefficients, roundings: 0, of_factor }
    }

    /// The signs of the coefficients of P′Q − PQ′ by rising powers, as far as they are certain; `Equal` is exact. None for a constant.
    ///
    /// The coefficient of u^(m−1) is Σ_{i > j, i + j = m} (i − j)(p_i q_j − p_j q_i): what is added and what is subtracted are both
    /// summed as they are, and then compared; `room` is for them.
    pub(crate) fn slope_signs<'a>(
        p: &Self,
        q: &Self,
        room: &'a mut Vec<f64>,
    ) -> impl Iterator<Item = Option<Ordering>> + use<'a> {
        let (a, b) = (&p.coefficients[..], &q.coefficients[..]);
        let degree = a.len().max(b.len()) - 1;
        room.clear();
        room.resize(5 * degree, 0.0);
        let (differences, sums) = room.split_at_mut(degree);
        let (added, subtracted) = sums.split_at_mut(2 * degree);
        // degree, …, 2, 1: i − j for j < i are the last i of them.
        for (place, difference) in differences.iter_mut().zip((1..=degree).rev()) {
            *place = difference as f64;
        }
        for i in 1..=degree {
            let add = |sums: &mut [f64], c: Option<&f64>, others: &[f64]| {
                let terms = differences[degree - i..].iter().zip(others);
                for (sum, (difference, other)) in sums[i..2 * i].iter_mut().zip(terms) {
                    *sum += difference * c.unwrap_or(&0.0) * other;
                }
            };
            add(added, a.get(i), b);
            add(subtracted, b.get(i), a);
        }
        // Two of a product of three, and one for each that is added.
        let roundings = f64::from(p.roundings) + f64::from(q.roundings) + (degree + 2) as f64;
        // S₊ − S₋ > 0 if s₊ − s₋ > γ(s₊ + s₋); with 2u in the place of u and a few more there is room for the roundings here.
        let margin = (roundings + 8.0) * f64::EPSILON;
        let sign = move |(added, subtracted): (&f64, &f64)| {
            let (sum, difference) = (added + subtracted, added - subtracted);
            if sum == 0.0 {
                Some(Ordering::Equal)
            } else if sum < f64::INFINITY && difference.abs() > margin * sum {
                difference.partial_cmp(&0.0)
            } else {
                None
            }
        };
        added.iter().zip(&*subtracted).skip(1).map(sign)
    }
}

impl Additive for BallPolynomial {
    fn accumulate(&mut self, rhs: &Self) {
        if self.coefficients.len() < rhs.coefficients.len() {
            self.coefficients.resize(rhs.coefficients.len(), 0.0);
        }
        for (sum, c) in self.coefficients.iter_mut().zip(&rhs.coefficients) {
            *sum += c;
        }
        self.roundings = self.roundings.max(rhs.roundings).saturating_add(1);
    }
}

/// By a + bu, written (a, b), a and b ≥ 0.
impl ScaleBy<(f64, f64)> for BallPolynomial {
    fn scale_by<'a>(&mut self, factors: impl Iterator<Item = &'a (f64, f64)>) {
        for (a, b) in factors {
            let mut below = 0.0;
            for c in &mut self.coefficients {
                let raised = below * b;
                below = *c;
                *c = *c * a + raised;
            }
            if *b != 0.0 {
                self.coefficients.push(below * b);
            }
            self.roundings = self.roundings.saturating_add(self.of_factor).saturating_add(2);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::polynomial::Polynomial;
    use super::super::ring::Ring;
    use super::*;
    use num_bigint::BigInt;
    use proptest::prelude::*;

    /// ∏ (a + bu), in floats and in integers.
    fn product(factors: &[(u64, u64)]) -> (BallPolynomial, Polynomial<BigInt>) {
        let exact = factors.iter().all(|(a, b)| a + b < 1 << 53);
        let (mut ball, mut whole) =
            (BallPolynomial::one(u32::from(!exact), 1), Polynomial::constant(BigInt::from(1)));
        ball.scale_by(factors.iter().map(|(a, b)| (*a as f64, *b as f64)).collect::<Vec<_>>().iter());
        whole.scale_by(factors.iter().map(|(a, b)| ((*a).into(), (*b).into())).collect::<Vec<_>>().iter());
        (ball, whole)
    }

    fn factors(most: usize) -> impl Strategy<Value = Vec<(u64, u64)>> {
        let end = || {
            prop_oneof![
                Just(0),
                Just(1),
                1_u64..4,
                1_u64..1000,
                (0_u32..62).prop_map(|e| 1 << e),
                1..u64::MAX / 4
            ]
        };
        let factor = (end(), end()).prop_filter("not 0", |(a, b)| *a > 0 || *b > 0);
        prop::collection::vec(factor, 0..most)
    }

    proptest! {
        /// A sign that is certain is the right one: of products that have much in common, so that much cancels, of sums, and of what is
        /// too long for a float.
        #[test]
        fn certain_signs_are_right(common in factors(6), p in factors(6), other in factors(6), q in factors(40)) {
            let of = |own: &[(u64, u64)]| product(&[&common, own].concat());
            let ((mut p, mut by_integers), (other, more), (q, denominator)) = (of(&p), of(&other), of(&q));
            p.accumulate(&other);
            by_integers = by_integers.plus(&more);
            let slope = by_integers.derivative().times(&denominator).minus(&by_integers.times(&denominator.derivative()));
            for (i, sign) in BallPolynomial::slope_signs(&p, &q, &mut Vec::new()).enumerate() {
                let exact = slope.coefficients().get(i).map_or(Ordering::Equal, |c| c.cmp(&BigInt::ZERO));
                prop_assert!(sign.is_none_or(|sign| sign == exact), "{i}: {sign:?}, not {exact:?}");
            }
        }
    }

    #[test]
    fn signs_are_certain_where_nothing_is_close() {
        let mut room = Vec::new();
        let mut signs = |p: &[(u64, u64)], q: &[(u64, u64)]| {
            BallPolynomial::slope_signs(&product(p).0, &product(q).0, &mut room).collect::<Vec<_>>()
        };
        let [less, equal, greater] = [Ordering::Less, Ordering::Equal, Ordering::Greater].map(Some);
        // u/(1 + u) rises; 1/(1 + u) falls; u/(1 + u²) is left out, but u/(1 + u)² has 1 − u².
        assert_eq!(signs(&[(0, 1)], &[(1, 1)]), [greater]);
        assert_eq!(signs(&[], &[(1, 1)]), [less]);
        assert_eq!(signs(&[(0, 1)], &[(1, 1), (1, 1)]), [greater, equal, less]);
        assert_eq!(signs(&[], &[]), []);
        // What is the same cancels, and that can't be told: (1 + u)/(1 + u).
        assert_eq!(signs(&[(1, 1)], &[(1, 1)]), [None]);
        // Neither can what is longer than any float.
        assert_eq!(signs(&[(1 << 61, 0); 20], &[(1, 1)]), [None]);
    }
}
