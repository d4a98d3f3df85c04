//! The triangle with one division a point: the denominators are put off to the end. In plain floats, for degrees 1
//! to [`FAST_DEGREE`] and vectors of points.

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
    knots: &[[F; N]],
    values: &mut [[F; N]],
) {
    for l in 0..N {
        let mut rises = [F::one(); K];
        let mut falls = [F::one(); K];
        for s in 0..K {
            rises[s] = ratio * (x[l] - knots[K - 1 - s][l]);
            falls[s] = knots[K + s][l] - x[l];
        }
        let mut numerators = [F::one(); FAST_DEGREE + 1];
        let mut denominator = F::one();
        for d in 1..=K {
            let mut sums = [F::one(); K];
            for c in 0..d {
                sums[c] = rises[d - 1 - c] + falls[c];
            }
            // after[c] = e_{c+1} ⋯ e_{d−1}; the product of those before c is built up on the way.
            let mut after = [F::one(); K];
            for c in (0..d - 1).rev() {
                after[c] = if c + 2 == d { sums[c + 1] } else { after[c + 1] * sums[c + 1] };
            }
            let mut before = F::one();
            let mut own = F::zero();
            for c in 0..d {
                let others = match (c == 0, c + 1 == d) {
                    (true, true) => F::one(),
                    (true, false) => after[c],
                    (false, true) => before,
                    (false, false) => before * after[c],
                };
                before = if c == 0 { sums[0] } else { before * sums[c] };
                let value = if d == 1 { F::one() } else { numerators[c] * others };
                let part = value * falls[c];
                numerators[c] = if c == 0 { part } else { own + part };
                own = value * rises[d - 1 - c];
            }
            numerators[d] = own;
            denominator = if d == 1 { before } else { denominator * before };
        }
        let inverse = denominator.recip();
        for c in 0..=K {
            values[c][l] = (numerators[c] * inverse).min(F::one());
        }
    }
}
