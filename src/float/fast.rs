//! The triangle with one division a point: the denominators are put off to the end. In plain floats, for degrees 1
//! to [`FAST_DEGREE`] and vectors of points.

use super::error::HIGHEST_DEGREE;
use super::point::lifted;
use super::real::Real;

/// The highest degree with a fast path of its own. Above it, the products that replace divisions cost more than they
/// save.
pub const FAST_DEGREE: usize = 5;

/// The k + 1 functions at N points, each with its 2k local knots, in the unit of a frame. Entry c of `values` is
/// G_{j−k+c}.
///
/// With e_s,w = rise_s + fall_w, the weights of degree d are rise_{d−c}/e_{d−c,c+1}. The triangle is run on the numerators,
/// each multiplied by the other denominators of its degree, and the product of all denominators divides the end
/// result: all numbers are positive, so nothing cancels.
#[inline(always)]
pub(super) fn values<F: Real, const K: usize, const N: usize>(
    ratio: F,
    x: &[F; N],
    knots: &[[F; N]; 2 * HIGHEST_DEGREE],
    values: &mut [[F; N]; HIGHEST_DEGREE + 1],
) {
    // All loops but the outer one have constant bounds, so that they are unrolled and the outer one becomes vectors.
    let mut closest = [F::one(); N];
    for l in 0..N {
        let mut rises = [F::one(); K];
        let mut falls = [F::one(); K];
        for s in 0..K {
            rises[s] = ratio * (x[l] - knots[K - 1 - s][l]);
            falls[s] = knots[K + s][l] - x[l];
        }
        closest[l] = if rises[0] < falls[0] { rises[0] } else { falls[0] };
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
                    numerators[c] = own + value * falls[c];
                    own = value * rises[d - c];
                }
            }
            numerators[d + 1] = own;
            denominator = denominator * before[d + 1];
        }
        let inverse = denominator.recip();
        for c in 0..K + 1 {
            let value = numerators[c] * inverse;
            values[c][l] = if value > F::one() { F::one() } else { value };
        }
    }
    // Only next to a knot can a value come out as 0: within 2⁻⁶⁴ of the unit (`f32`: 2⁻⁸).
    let least = F::min_positive_value().sqrt().sqrt().sqrt().sqrt();
    if closest.iter().fold(false, |any, distance| any | (*distance < least)) {
        for c in 0..K + 1 {
            for l in 0..N {
                let above = c == 0 || knots[c.max(1) - 1][l] < x[l];
                let below = c == K || x[l] < knots[K + c][l];
                values[c][l] = lifted(values[c][l], above, below);
            }
        }
    }
}
