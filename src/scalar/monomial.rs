//! Products of powers of variables, packed so that multiplying them is adding words.

use std::fmt;

/// x₀^e₀·x₁^e₁·…, every exponent from 0 to [`Monomial::BOUND`].
///
/// One byte a variable, x₀ in the highest byte of the first word: words in order are exponents in order, so
/// `Ord` is the lexicographic order with x₀ > x₁ > …, and it agrees with products. The highest bit of every
/// byte is a guard: it is 0 in every monomial, takes the carry of a sum, and so no exponent ever wraps.
///
/// ```
/// use knotproof::scalar::Monomial;
///
/// let m = Monomial::variable(0).times(&Monomial::variable(3)).times(&Monomial::variable(0));
/// assert_eq!(m.exponents().collect::<Vec<_>>(), [(0, 2), (3, 1)]);
/// assert_eq!(m.divided_by(&Monomial::variable(3)), Some(Monomial::variable(0).times(&Monomial::variable(0))));
/// assert!(m > Monomial::variable(0).times(&Monomial::variable(3)));
/// ```
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Monomial {
    words: [u64; WORDS],
}

const WORDS: usize = 16;
const BYTES: usize = 8;
const GUARDS: u64 = 0x8080_8080_8080_8080;

impl Monomial {
    /// The number of variables there are: x₀, …, x₁₂₇.
    pub const VARIABLES: usize = WORDS * BYTES;

    /// The largest exponent that a variable can have.
    pub const BOUND: usize = 127;

    /// 1, the product of no variables.
    pub const ONE: Self = Self { words: [0; WORDS] };

    /// x_v.
    ///
    /// # Panics
    /// If v ≥ [`Monomial::VARIABLES`]: this is a bug of the caller.
    #[must_use]
    pub fn variable(v: usize) -> Self {
        Self::ONE.with(v, 1)
    }

    /// The same monomial with exponent e ≤ [`Monomial::BOUND`] of x_v.
    pub(super) fn with(mut self, v: usize, e: usize) -> Self {
        let (word, shift) = place(v);
        assert!(e <= Self::BOUND, "exponent {e} of x{v}: {OVERFLOW}");
        self.words[word] = self.words[word] & !(0xff << shift) | (e as u64) << shift;
        self
    }

    /// The exponent of x_v.
    ///
    /// # Panics
    /// If v ≥ [`Monomial::VARIABLES`]: this is a bug of the caller.
    #[must_use]
    pub fn exponent(&self, v: usize) -> usize {
        let (word, shift) = place(v);
        usize::from((self.words[word] >> shift).to_be_bytes()[BYTES - 1])
    }

    /// Pairs (v, e) of the variables that occur and their exponents, by rising v.
    pub fn exponents(&self) -> impl Iterator<Item = (usize, usize)> + use<> {
        let used = self.words.into_iter().enumerate().filter(|(_, word)| *word != 0);
        let bytes = used.flat_map(|(i, word)| (8 * i..).zip(word.to_be_bytes()));
        bytes.filter(|(_, e)| *e != 0).map(|(v, e)| (v, usize::from(e)))
    }

    /// The product: the exponents add up.
    ///
    /// # Panics
    /// If an exponent exceeds [`Monomial::BOUND`]: this is a bug of the caller, who has to know the degrees.
    #[must_use]
    pub fn times(&self, rhs: &Self) -> Self {
        let words = std::array::from_fn(|i| self.words[i] + rhs.words[i]);
        let product = Self { words };
        assert!(product.words.iter().all(|word| word & GUARDS == 0), "{self} times {rhs}: {OVERFLOW}");
        product
    }

    /// The quotient, if `rhs` divides self.
    #[must_use]
    pub fn divided_by(&self, rhs: &Self) -> Option<Self> {
        let divides = |(a, b): (&u64, &u64)| not_less(*a, *b) == GUARDS;
        self.words
            .iter()
            .zip(&rhs.words)
            .all(divides)
            .then(|| Self { words: std::array::from_fn(|i| self.words[i] - rhs.words[i]) })
    }

    /// The greatest common divisor: of each variable the smaller exponent.
    #[must_use]
    pub fn gcd(&self, rhs: &Self) -> Self {
        self.select(rhs, |a, b, larger| b & larger | a & !larger)
    }

    /// The least common multiple: of each variable the larger exponent.
    #[must_use]
    pub fn lcm(&self, rhs: &Self) -> Self {
        self.select(rhs, |a, b, larger| a & larger | b & !larger)
    }

    /// Word by word, with all bits set in the bytes where the exponent of self is not the smaller one.
    fn select(&self, rhs: &Self, choose: impl Fn(u64, u64, u64) -> u64) -> Self {
        let word = |i: usize| {
            let (a, b) = (self.words[i], rhs.words[i]);
            choose(a, b, (not_less(a, b) >> 7) * 0xff)
        };
        Self { words: std::array::from_fn(word) }
    }
}

const OVERFLOW: &str = "exponents go up to 127, to exceed that is a bug of the caller";

/// The guards of the bytes in which a ≥ b: with the guard set a byte has nothing to borrow.
fn not_less(a: u64, b: u64) -> u64 {
    ((a | GUARDS) - b) & GUARDS
}

/// The word of a variable and the place of its byte there.
fn place(v: usize) -> (usize, usize) {
    assert!(v < Monomial::VARIABLES, "x{v}: there are {} variables", Monomial::VARIABLES);
    (v / BYTES, BYTES * (BYTES - 1 - v % BYTES))
}

/// As in `x0^2·x3`; the empty product is `1`.
impl fmt::Display for Monomial {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if *self == Self::ONE {
            return f.write_str("1");
        }
        for (at, (v, e)) in self.exponents().enumerate() {
            let dot = if at > 0 { "·" } else { "" };
            write!(f, "{dot}x{v}")?;
            if e > 1 {
                write!(f, "^{e}")?;
            }
        }
        Ok(())
    }
}

impl fmt::Debug for Monomial {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const LAST: usize = Monomial::VARIABLES - 1;

    /// Exponents at both ends of a byte, in neighbouring bytes and words.
    fn nasty() -> Vec<Monomial> {
        let places = [0, 1, 6, 7, 8, 15, 16, 46, 47, LAST - 1, LAST];
        let mut all = vec![Monomial::ONE];
        for e in [1, 2, 63, 64, 126, 127] {
            all.extend(places.map(|v| Monomial::ONE.with(v, e)));
            all.push(places.iter().fold(Monomial::ONE, |m, v| m.with(*v, e)));
        }
        all
    }

    fn list(m: &Monomial) -> Vec<usize> {
        (0..Monomial::VARIABLES).map(|v| m.exponent(v)).collect()
    }

    #[test]
    fn packed_operations_are_those_on_lists_of_exponents() {
        for a in nasty() {
            for b in nasty() {
                let pairs = || list(&a).into_iter().zip(list(&b));
                assert_eq!(a.cmp(&b), list(&a).cmp(&list(&b)));
                assert_eq!(list(&a.gcd(&b)), pairs().map(|(x, y)| x.min(y)).collect::<Vec<_>>());
                assert_eq!(list(&a.lcm(&b)), pairs().map(|(x, y)| x.max(y)).collect::<Vec<_>>());
                let quotient: Option<Vec<_>> = pairs().map(|(x, y)| x.checked_sub(y)).collect();
                assert_eq!(a.divided_by(&b).map(|m| list(&m)), quotient);
                if pairs().all(|(x, y)| x + y <= Monomial::BOUND) {
                    assert_eq!(list(&a.times(&b)), pairs().map(|(x, y)| x + y).collect::<Vec<_>>());
                }
            }
        }
    }

    #[test]
    fn an_exponent_never_wraps() {
        for (v, e, f) in [(0, 127, 1), (7, 64, 64), (8, 127, 127), (LAST, 1, 127)] {
            let product = || Monomial::ONE.with(v, e).times(&Monomial::ONE.with(v, f));
            assert!(std::panic::catch_unwind(product).is_err(), "x{v}^{e}·x{v}^{f}");
        }
        assert!(std::panic::catch_unwind(|| Monomial::variable(LAST + 1)).is_err());
    }

    #[test]
    fn a_monomial_is_shown_by_its_variables() {
        assert_eq!(Monomial::ONE.to_string(), "1");
        assert_eq!(Monomial::ONE.with(0, 2).with(9, 1).to_string(), "x0^2·x9");
    }
}
