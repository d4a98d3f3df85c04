//! The triangle in pairs of floats, at as many points at once as a vector has lanes.

#![expect(
    clippy::needless_range_loop,
    reason = "loops whose ends the compiler knows, over several arrays at once"
)]

use super::basis::Ratio;
use super::fast::FAST_DEGREE;
use super::pair::Pair;
use super::vectors::Vectors;

/// A loop, written out for small degrees: C, which is above every degree that can be, says so. Then the places of arrays become registers. The
/// compiler does not write out loops of such a length.
macro_rules! written_out {
    ($bound:ident, $i:ident in 0..$end:expr, $body:block) => {
        if $bound <= FAST_DEGREE + 1 {
            written_out!(@ $i in 0..$end, $body, 0 1 2 3 4);
        } else {
            for $i in 0..$end $body
        }
    };
    (@ $i:ident in 0..$end:expr, $body:block, $($value:literal)*) => {
        {
            $({
                let $i = $value;
                if $i < $end $body
            })*
        }
    };
}

/// What the weights at a point are made of.
pub(super) trait Terms<V> {
    /// rise, fall and over for i = j − d + 1 + c: w_i^d = rise/over and 1 − w_i^d = fall/over.
    fn terms(&self, m: impl Vectors<Vector = V>, d: usize, c: usize) -> [Pair<V>; 3];
}

/// All differences in the unit of a frame, for degrees below C.
pub(super) struct InFrame<V, const C: usize> {
    /// p(x − t_{j+1−s}) at s − 1.
    rises: [Pair<V>; C],
    /// q(t_{j+w} − x) at w − 1.
    falls: [Pair<V>; C],
}

impl<V: Copy, const C: usize> InFrame<V, C> {
    /// `knot`(i) is t_{j−k+1+i}; knots and x are in the unit.
    #[inline(always)]
    pub(super) fn new(
        m: impl Vectors<Vector = V>,
        ratio: Ratio,
        degree: usize,
        x: V,
        knot: impl Fn(usize) -> V,
    ) -> Self {
        let (p, q, zero) = (m.splat(ratio.p), Pair::splat(m, ratio.q), Pair::splat(m, Pair::ZERO));
        let (mut rises, mut falls) = ([zero; C], [zero; C]);
        written_out!(C, s in 0..degree, {
            rises[s] = Pair::difference(m, x, knot(degree - 1 - s)).by(m, p);
            falls[s] = Pair::difference(m, knot(degree + s), x).times(m, q);
        });
        Self { rises, falls }
    }

    /// rise and fall.
    #[inline(always)]
    pub(super) fn parts(&self, d: usize, c: usize) -> (Pair<V>, Pair<V>) {
        (self.rises[d - 1 - c], self.falls[c])
    }
}

impl<V: Copy, const C: usize> Terms<V> for InFrame<V, C> {
    #[inline(always)]
    fn terms(&self, m: impl Vectors<Vector = V>, d: usize, c: usize) -> [Pair<V>; 3] {
        let (rise, fall) = self.parts(d, c);
        [rise, fall, rise.plus_like(m, fall)]
    }
}

/// What the triangle begins with in place of 1: so far from underflow that none of its quotients by a large sum gets there.
/// It is 2⁹⁰⁰.
const HEIGHT: f64 = f64::from_bits((1023 + 900) << 52);

/// G_{j−k}^k, …, G_j^k as normal pairs, k < C.
#[inline(always)]
pub(super) fn triangle<M: Vectors, const C: usize>(
    m: M,
    degree: usize,
    terms: &impl Terms<M::Vector>,
) -> [Pair<M::Vector>; C] {
    let mut values = [Pair::splat(m, Pair::ZERO); C];
    values[0].hi = m.splat(HEIGHT);
    // Each G_i^{d−1} is divided once and split in two: the part w goes to G_i^d, the part 1 − w to G_{i−1}^d.
    let mut own = values[0];
    written_out!(C, below in 0..degree, {
        let d = below + 1;
        written_out!(C, c in 0..d, {
            let [rise, fall, over] = terms.terms(m, d, c);
            let share = values[c].over(m, over);
            let stays = share.times(m, fall);
            values[c] = if c == 0 { stays } else { own.plus_like(m, stays) }.normal(m);
            own = share.times(m, rise);
        });
        values[d] = own.normal(m);
    });
    let height = m.splat(1.0 / HEIGHT);
    for value in &mut values {
        *value = Pair { hi: m.mul(value.hi, height), lo: m.mul(value.lo, height) };
    }
    values
}

/// Σ d_c G_c as a pair that is not normal: hi and lo can cancel. `control`(c) is d_c.
#[inline(always)]
pub(super) fn combination<M: Vectors, const C: usize>(
    m: M,
    degree: usize,
    values: &[Pair<M::Vector>; C],
    control: impl Fn(usize) -> M::Vector,
) -> Pair<M::Vector> {
    let mut sum = values[0].by(m, control(0));
    for c in 1..=degree {
        sum = sum.plus_like(m, values[c].by(m, control(c)));
    }
    sum
}
