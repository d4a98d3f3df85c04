//! Fractions in lowest terms, whose denominators are products of words.

use num_rational::BigRational;
use num_traits::Zero;

use crate::scalar::{Natural, OddWord, ScaleBy};

use super::factors::Factors;
use super::triangle::Active;

/// How many residues are computed at a time: their steps do not wait for one another.
const LANES: usize = 4;

/// The room for bringing the functions at a point to lowest terms.
///
/// Every common prime of a numerator and its denominator is one with a factor L of that. Powers of 2 are counted. For
/// the odd part of each L, the greatest common divisor with the product of all numerators over it is taken, once: it
/// is 1 for most, and small for the others, and has all that L can have in common with one of them. So the product of
/// these, over the L of a denominator, contains the whole of what can be cancelled: for a prime, either all that the
/// numerator has of it, or all that the denominator has.
#[derive(Debug, Clone, Default)]
pub(super) struct Reducer {
    numerators: Vec<Natural>,
    /// The odd parts of all L, in the order of [`Factors::places`].
    odd: Vec<OddWord>,
    /// The exponents of 2 in them.
    twos: Vec<u32>,
    /// ∏ of the numerators over L, modulo its odd part; then the greatest common divisor with it.
    shared: Vec<u64>,
    denominator: Natural,
    words: Vec<u64>,
    half_digits: Vec<u32>,
}

impl Reducer {
    /// Brings numerators over these denominators to lowest terms; `copy` writes them into numbers that are there.
    pub(super) fn reduce<N>(
        &mut self,
        first: usize,
        numerators: &[N],
        factors: &Factors<u64>,
        copy: impl Fn(&N, &mut Natural),
    ) -> Active<BigRational> {
        self.numerators.resize_with(self.numerators.len().max(numerators.len()), Natural::default);
        for (numerator, own) in numerators.iter().zip(&mut self.numerators) {
            copy(numerator, own);
        }
        self.find_shared(first, numerators.len(), factors);
        let values =
            (0..numerators.len()).map(|place| self.fraction(first + place, place, factors)).collect();
        Active::new(first, values)
    }

    fn find_shared(&mut self, first: usize, count: usize, factors: &Factors<u64>) {
        self.odd.clear();
        self.twos.clear();
        for factor in factors.places() {
            let twos = factor.trailing_zeros();
            self.twos.push(twos);
            self.odd.push(OddWord::new(if *factor == 0 { 1 } else { factor >> twos }));
        }
        self.shared.clear();
        self.shared.resize(self.odd.len(), 1);
        for (i, numerator) in (first..).zip(&self.numerators[..count]) {
            for row in factors.denominator_places(i) {
                let (odd, shared) = (&self.odd[row.clone()], &mut self.shared[row]);
                let (mut lanes, mut products) = (odd.chunks_exact(LANES), shared.chunks_exact_mut(LANES));
                for (odd, products) in lanes.by_ref().zip(products.by_ref()) {
                    let mut residues = [0; LANES];
                    for digit in numerator.digits() {
                        for (residue, odd) in residues.iter_mut().zip(odd) {
                            *residue = odd.step(*digit, *residue).1;
                        }
                    }
                    for ((product, residue), odd) in products.iter_mut().zip(residues).zip(odd) {
                        *product = odd.times(*product, residue);
                    }
                }
                for (product, odd) in products.into_remainder().iter_mut().zip(lanes.remainder()) {
                    *product = odd.times(*product, odd.residue(numerator.digits()));
                }
            }
        }
        for (shared, odd) in self.shared.iter_mut().zip(&self.odd) {
            *shared = odd.gcd(*shared);
        }
    }

    fn fraction(&mut self, i: usize, place: usize, factors: &Factors<u64>) -> BigRational {
        let numerator = &mut self.numerators[place];
        if numerator.digits().is_empty() {
            return BigRational::zero();
        }
        let mut twos = 0;
        self.words.clear();
        // What the places since the last division share, and how many of them have been gone through before that.
        let (mut pending, mut settled) = (1_u64, 0);
        for place in factors.denominator_places(i).flatten() {
            twos += self.twos[place] as usize;
            match pending.checked_mul(self.shared[place]) {
                Some(product) => pending = product,
                None => {
                    cancel(numerator, pending, &mut self.words[settled..]);
                    (pending, settled) = (self.shared[place], self.words.len());
                }
            }
            self.words.push(self.odd[place].value());
        }
        cancel(numerator, pending, &mut self.words[settled..]);
        let common = twos.min(numerator.trailing_zeros());
        numerator.shift_right(common);
        let mut twos = twos - common;
        while twos > 0 {
            let some = twos.min(63);
            self.words.push(1 << some);
            twos -= some;
        }
        self.denominator.set(1);
        self.denominator.scale_by(self.words.iter());
        let denominator = self.denominator.to_integer(&mut self.half_digits);
        BigRational::new_raw(numerator.to_integer(&mut self.half_digits), denominator)
    }
}

/// Divides a numerator, and the product of the words, by the greatest common divisor of the numerator and `shared`,
/// which divides that product.
fn cancel(numerator: &mut Natural, shared: u64, words: &mut [u64]) {
    if shared == 1 {
        return;
    }
    let shared = OddWord::new(shared);
    let mut common = OddWord::new(shared.gcd(shared.residue(numerator.digits())));
    numerator.divide_exactly(&common);
    for word in words {
        if common.value() == 1 {
            return;
        }
        let part = common.gcd(*word);
        *word /= part;
        common = OddWord::new(common.value() / part);
    }
}
