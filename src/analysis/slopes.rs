//! The slopes of a function at its knots, from either side.

use num_rational::BigRational;

use crate::spline::{Basis, HasWeights, Side};

/// The one-sided derivatives of a function at a knot of its support.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct KnotSlopes {
    /// The knot.
    pub at: BigRational,
    /// D⁻; `None` at t_0, where nothing lies to the left.
    pub left: Option<BigRational>,
    /// D⁺; `None` at t_m, where nothing lies to the right.
    pub right: Option<BigRational>,
}

/// D⁻G_i^k and D⁺G_i^k at each of the knots t_i, …, t_{i+k+1}, once each, from left to right.
///
/// Exact, by [jets](Basis::jets). Outside of its support the function is 0, and so is its slope; at a jump each
/// slope is that of the function on its side.
///
/// ```
/// use knotproof::analysis::knot_slopes;
/// use knotproof::scalar::integer;
/// use knotproof::spline::{Basis, Index, KnotVector};
///
/// let knots = KnotVector::new([0, 1, 2, 3].map(integer).to_vec())?;
/// let slopes = knot_slopes(&Basis::new(knots, 1, Index::infinity())?, 0);
/// let pairs: Vec<_> = slopes.into_iter().map(|slopes| (slopes.left, slopes.right)).collect();
/// let [zero, one] = [0, 1].map(|slope| Some(integer(slope)));
/// assert_eq!(pairs, [(None, one.clone()), (one, Some(-integer(1))), (Some(-integer(1)), zero)]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Panics
/// If i > n.
#[must_use]
pub fn knot_slopes<W: HasWeights>(basis: &Basis<W>, i: usize) -> Vec<KnotSlopes> {
    assert!(i <= basis.n(), "there is no function {i}: the basis has the functions 0 to {}", basis.n());
    let (first, last) = (basis.knots().first(), basis.knots().last());
    let mut knots = basis.knots().knots()[i..=i + basis.degree() + 1].to_vec();
    knots.dedup();
    let slope = |at: &BigRational, side| basis.jets(at, side, 1)[i].derivatives()[1].clone();
    knots
        .into_iter()
        .map(|at| KnotSlopes {
            left: (at != *first).then(|| slope(&at, Side::Left)),
            right: (at != *last).then(|| slope(&at, Side::Right)),
            at,
        })
        .collect()
}
