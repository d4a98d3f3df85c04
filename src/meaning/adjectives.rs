//! Properties of knots.

use crate::language::Adjective;
use crate::spline::KnotVector;

/// Does the knot vector have the property, for degree k?
#[must_use]
pub fn has(adjective: Adjective, knots: &KnotVector, k: usize) -> bool {
    let (t, m) = (knots.knots(), knots.m());
    let open = || knots.is_open(k) && t[k] < t[m - k];
    match adjective {
        Adjective::Open => open(),
        Adjective::Clamped => open() && t[k] < t[k + 1] && t[m - k - 1] < t[m - k],
        Adjective::Symmetric => knots.is_symmetric(),
        Adjective::Simple => t.windows(2).all(|pair| pair[0] < pair[1]),
        Adjective::Equidistant => t.windows(3).all(|three| &three[1] - &three[0] == &three[2] - &three[1]),
        Adjective::Bernstein => open() && m == 2 * k + 1,
        Adjective::Inner => knots.inner_stop_knots().all(|(_, p)| p <= k),
        Adjective::Interior => knots.interior(k).iter().all(|t| knots.multiplicity(t) <= k),
    }
}
