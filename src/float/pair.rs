//! Pairs of floats that stand for their unevaluated sum: about 106 bits, from additions and multiplications alone.
//!
//! The algorithms and their bounds: Joldes, Muller and Popescu, "Tight and rigorous error bounds for basic building
//! blocks of double-word arithmetic" (2017). With u = 2⁻⁵³, each operation here has a relative error of at most 10u²,
//! [`Pair::shares`] of at most 40u², barring underflow.

/// How the exact product of two floats is found. Both ways give the same two floats, so the results of this
/// module do not depend on the machine.
pub(crate) trait Products {
    /// (p, e) with p the rounded product and p + e the product itself.
    fn two_product(a: f64, b: f64) -> (f64, f64);
}

/// By fused multiply–add, where the machine has one.
pub(crate) struct Fused;

/// By Dekker's splitting (1971), on any machine; for |a|, |b| < 2^996.
pub(crate) struct Split;

impl Products for Fused {
    #[inline(always)]
    fn two_product(a: f64, b: f64) -> (f64, f64) {
        let p = a * b;
        (p, a.mul_add(b, -p))
    }
}

impl Products for Split {
    #[inline(always)]
    fn two_product(a: f64, b: f64) -> (f64, f64) {
        let split = |x: f64| {
            let high = 134_217_729.0 * x;
            let high = high - (high - x);
            (high, x - high)
        };
        let ((a1, a2), (b1, b2)) = (split(a), split(b));
        let p = a * b;
        (p, ((a1 * b1 - p) + a1 * b2 + a2 * b1) + a2 * b2)
    }
}

/// hi + lo with hi the float nearest to the sum.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Pair {
    pub(crate) hi: f64,
    pub(crate) lo: f64,
}

impl Pair {
    pub(crate) const ZERO: Self = Self::of(0.0);
    pub(crate) const ONE: Self = Self::of(1.0);

    /// A float as a pair.
    pub(crate) const fn of(value: f64) -> Self {
        Self { hi: value, lo: 0.0 }
    }

    /// a + b, exactly (Knuth's two-sum).
    #[inline(always)]
    pub(crate) fn sum(a: f64, b: f64) -> Self {
        let hi = a + b;
        let b_part = hi - a;
        Self { hi, lo: (a - (hi - b_part)) + (b - b_part) }
    }

    /// a − b, exactly.
    #[inline(always)]
    pub(crate) fn difference(a: f64, b: f64) -> Self {
        Self::sum(a, -b)
    }

    /// a + b, exactly, where b is not larger than a.
    #[inline(always)]
    fn ordered_sum(a: f64, b: f64) -> Self {
        let hi = a + b;
        Self { hi, lo: b - (hi - a) }
    }

    /// The sum of two pairs of one sign: at most 3u² off.
    #[inline(always)]
    pub(crate) fn plus_like(self, rhs: Self) -> Self {
        let high = Self::sum(self.hi, rhs.hi);
        Self::ordered_sum(high.hi, high.lo + (self.lo + rhs.lo))
    }

    /// The sum of two pairs of any signs: at most 4u² off, relative to the sum, however much cancels.
    #[inline(always)]
    pub(crate) fn plus(self, rhs: Self) -> Self {
        let (high, low) = (Self::sum(self.hi, rhs.hi), Self::sum(self.lo, rhs.lo));
        let once = Self::ordered_sum(high.hi, high.lo + low.hi);
        Self::ordered_sum(once.hi, low.lo + once.lo)
    }

    /// −self.
    #[inline(always)]
    pub(crate) fn negate(self) -> Self {
        Self { hi: -self.hi, lo: -self.lo }
    }

    /// The product of two pairs: at most 7u² off.
    #[inline(always)]
    pub(crate) fn times<M: Products>(self, rhs: Self) -> Self {
        let (p, e) = M::two_product(self.hi, rhs.hi);
        Self::ordered_sum(p, e + (self.hi * rhs.lo + self.lo * rhs.hi))
    }

    /// rise/(rise + fall) and fall/(rise + fall), for two numbers ≥ 0 that are not both 0: at most 40u² off. The share
    /// of 0 is 0.
    #[inline(always)]
    pub(crate) fn shares<M: Products>(rise: Self, fall: Self) -> (Self, Self) {
        let sum = rise.plus_like(fall);
        let inverse = 1.0 / sum.hi;
        (rise.over::<M>(sum, inverse), fall.over::<M>(sum, inverse))
    }

    /// self/rhs, by one step of Newton's method from 1/rhs as a float.
    #[inline(always)]
    pub(crate) fn over<M: Products>(self, rhs: Self, inverse: f64) -> Self {
        let quotient = self.hi * inverse;
        let (p, e) = M::two_product(quotient, rhs.hi);
        let rest = ((self.hi - p) - e) + (self.lo - quotient * rhs.lo);
        Self::ordered_sum(quotient, rest * inverse)
    }
}
