//! The triangle with one division a point: the denominators are put off to the end. In plain floats, for degrees 1
//! to [`FAST_DEGREE`].

use super::real::Real;

/// The highest degree with a fast path of its own. Above it, the products that replace divisions cost more than they
/// save.
pub const FAST_DEGREE: usize = 5;

/// The k + 1 functions at a point, and min(rise_1, fall_1): in the unit of a frame, `knot`(i) is t_{j−k+1+i}, k = K.
///
/// With e_s,w = rise_s + fall_w, the weights of degree d are rise_{d−c}/e_{d−c,c+1}. The triangle is run on the numerators,
/// each multiplied by the other denominators of its degree, and the product of all denominators divides the end
/// result: all numbers are positive, so nothing cancels.
///
/// All loops have constant bounds, so that they are unrolled, and a loop over points becomes vectors.
#[inline(always)]
pub(super) fn values<F: Real, const K: usize>(
    ratio: F,
    x: F,
    knot: impl Fn(usize) -> F,
) -> ([F; FAST_DEGREE + 1], F) {
    let (mut rises, mut falls) = ([F::one(); K], [F::one(); K]);
    for s in 0..K {
        rises[s] = ratio * (x - knot(K - 1 - s));
        falls[s] = knot(K + s) - x;
    }
    let mut numerators = [F::one(); FAST_DEGREE + 1];
    let mut denominator = F::one();
    // From degree d to degree d + 1.
    for d in 0..K {
        // before[c] = e_0 ⋯ e_{c−1} and after[c] = e_{c+1} ⋯ e_d, with the sums e_c of this degree.
        let mut sums = [F::one(); K];
        let (mut before, mut after) = ([F::one(); FAST_DEGREE + 1], [F::one(); FAST_DEGREE + 1]);
        for c in 0..K {
            if c <= d {
                sums[c] = rises[d - c] + falls[c];
                before[c + 1] = before[c] * sums[c];
            }
        }
        for back in 0..K {
            if back < d {
                after[d - back - 1] = after[d - back] * sums[d - back];
            }
        }
        let mut own = F::zero();
        for c in 0..K {
            if c <= d {
                let value = numerators[c] * (before[c] * after[c]);
                let stays = value * falls[c];
                numerators[c] = if c == 0 { stays } else { own + stays };
                own = value * rises[d - c];
            }
        }
        numerators[d + 1] = own;
        denominator = denominator * before[d + 1];
    }
    let inverse = denominator.recip();
    let value = |numerator: F| {
        let value = numerator * inverse;
        if value > F::one() { F::one() } else { value }
    };
    (numerators.map(value), if rises[0] < falls[0] { rises[0] } else { falls[0] })
}

/// A value can come out as 0 only where min(rise_1, fall_1) is less than this: 2⁻⁶⁴ (`f32`: 2⁻⁸).
#[inline(always)]
pub(super) fn least_distance<F: Real>() -> F {
    F::min_positive_value().sqrt().sqrt().sqrt().sqrt()
}
