//! Pairs of floats that stand for their unevaluated sum: about 106 bits, from additions and multiplications alone.
//!
//! The algorithms: Joldes, Muller and Popescu, "Tight and rigorous error bounds for basic building blocks of double-word
//! arithmetic" (2017), without the last step of each, which [`Pair::normal`] is. So sums, products and quotients can be
//! chained and made normal once. `docs/float.md` has the bounds.

use super::vectors::Vectors;

/// hi + lo. It is *normal* where hi is the float nearest to the sum; else |lo| is at most a few units in the last place of hi.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Pair<V = f64> {
    pub(crate) hi: V,
    pub(crate) lo: V,
}

impl Pair {
    pub(crate) const ZERO: Self = Self::of(0.0);
    pub(crate) const ONE: Self = Self::of(1.0);

    /// A float as a pair.
    pub(crate) const fn of(value: f64) -> Self {
        Self { hi: value, lo: 0.0 }
    }

    /// −self.
    #[inline(always)]
    pub(crate) fn negate(self) -> Self {
        Self { hi: -self.hi, lo: -self.lo }
    }
}

impl<V: Copy> Pair<V> {
    /// The same pair in every lane.
    #[inline(always)]
    pub(super) fn splat(m: impl Vectors<Vector = V>, value: Pair) -> Self {
        Self { hi: m.splat(value.hi), lo: m.splat(value.lo) }
    }

    /// a + b, exactly and normal (Knuth's two-sum).
    #[inline(always)]
    fn sum(m: impl Vectors<Vector = V>, a: V, b: V) -> Self {
        let hi = m.add(a, b);
        let b_part = m.sub(hi, a);
        Self { hi, lo: m.add(m.sub(a, m.sub(hi, b_part)), m.sub(b, b_part)) }
    }

    /// a − b, exactly and normal.
    #[inline(always)]
    pub(crate) fn difference(m: impl Vectors<Vector = V>, a: V, b: V) -> Self {
        let hi = m.sub(a, b);
        let b_part = m.sub(hi, a);
        Self { hi, lo: m.sub(m.sub(a, m.sub(hi, b_part)), m.add(b, b_part)) }
    }

    /// The same number as a normal pair, for |lo| ≤ |hi|: exact.
    #[inline(always)]
    pub(crate) fn normal(self, m: impl Vectors<Vector = V>) -> Self {
        let hi = m.add(self.hi, self.lo);
        Self { hi, lo: m.sub(self.lo, m.sub(hi, self.hi)) }
    }

    /// The sum; its error is relative to the sum of the absolute values.
    #[inline(always)]
    pub(crate) fn plus_like(self, m: impl Vectors<Vector = V>, rhs: Self) -> Self {
        let high = Self::sum(m, self.hi, rhs.hi);
        Self { hi: high.hi, lo: m.add(high.lo, m.add(self.lo, rhs.lo)) }
    }

    /// The sum of two normal pairs of any signs, normal: at most 4u² off, relative to the sum, however much cancels.
    #[inline(always)]
    pub(crate) fn plus(self, m: impl Vectors<Vector = V>, rhs: Self) -> Self {
        let (high, low) = (Self::sum(m, self.hi, rhs.hi), Self::sum(m, self.lo, rhs.lo));
        let once = Self { hi: high.hi, lo: m.add(high.lo, low.hi) }.normal(m);
        Self { hi: once.hi, lo: m.add(low.lo, once.lo) }.normal(m)
    }

    /// The product.
    #[inline(always)]
    pub(crate) fn times(self, m: impl Vectors<Vector = V>, rhs: Self) -> Self {
        let (hi, e) = m.two_product(self.hi, rhs.hi);
        Self { hi, lo: m.add(e, m.add(m.mul(self.hi, rhs.lo), m.mul(self.lo, rhs.hi))) }
    }

    /// The product with a float.
    #[inline(always)]
    pub(crate) fn by(self, m: impl Vectors<Vector = V>, rhs: V) -> Self {
        let (hi, e) = m.two_product(self.hi, rhs);
        Self { hi, lo: m.add(e, m.mul(self.lo, rhs)) }
    }

    /// The quotient, by one step of Newton's method from 1/rhs as a float. 0 over anything is 0.
    #[inline(always)]
    pub(crate) fn over(self, m: impl Vectors<Vector = V>, rhs: Self) -> Self {
        let inverse = m.div(m.splat(1.0), rhs.hi);
        let quotient = m.mul(self.hi, inverse);
        let (p, e) = m.two_product(quotient, rhs.hi);
        let rest = m.sub(self.lo, m.mul(quotient, rhs.lo));
        let rest = m.add(m.sub(m.sub(self.hi, p), e), rest);
        Self { hi: quotient, lo: m.mul(rest, inverse) }
    }
}
