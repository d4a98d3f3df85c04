//! Denominators as lists of factors that are never multiplied out unless asked for.

use std::cmp::Ordering;
use std::sync::Arc;

use num_bigint::BigInt;
use num_traits::{One, Signed};

use super::multivariate::Multivariate;
use super::ring::Ring;

/// Factors and their powers, which are not 0, by rising factor.
pub(super) type Factors = Vec<(Arc<Multivariate>, usize)>;

/// (s, d, list) with p = s·d·Π list, s = ±1 and d > 0; `None` for 0.
pub(super) fn factored(p: &Multivariate) -> Option<(BigInt, BigInt, Factors)> {
    let (c, m, rest) = p.split()?;
    let mut factors: Factors = m.exponents().map(|(v, e)| (Arc::new(Multivariate::variable(v)), e)).collect();
    if rest.as_constant().is_none() {
        factors.push((Arc::new(rest), 1));
    }
    factors.sort();
    Some((c.signum(), c.abs(), factors))
}

/// v, if p is x_v.
pub(super) fn as_variable(p: &Multivariate) -> Option<usize> {
    let mut terms = p.terms();
    let (m, _) = terms.next().filter(|(_, c)| c.is_one())?;
    let mut exponents = m.exponents();
    match (exponents.next(), exponents.next(), terms.next()) {
        (Some((v, 1)), None, None) => Some(v),
        _ => None,
    }
}

/// Each factor of either list with the power that `power` makes of its two powers; 0 leaves it out.
pub(super) fn combined(a: &Factors, b: &Factors, power: impl Fn(usize, usize) -> usize) -> Factors {
    let (mut a, mut b) = (a.iter().peekable(), b.iter().peekable());
    let mut result = Vec::with_capacity(a.len().max(b.len()));
    loop {
        let order = match (a.peek(), b.peek()) {
            (Some((f, _)), Some((g, _))) if Arc::ptr_eq(f, g) => Ordering::Equal,
            (Some((f, _)), Some((g, _))) => f.cmp(g),
            (Some(_), None) => Ordering::Less,
            (None, Some(_)) => Ordering::Greater,
            (None, None) => return result,
        };
        let left = if order.is_le() { a.next() } else { None };
        let right = if order.is_ge() { b.next() } else { None };
        let power = power(left.map_or(0, |(_, e)| *e), right.map_or(0, |(_, e)| *e));
        result.extend(left.or(right).filter(|_| power > 0).map(|(factor, _)| (factor.clone(), power)));
    }
}

/// start·F₁^e₁·F₂^e₂·…, one factor after the other: each of them is short.
pub(super) fn expanded(factors: &Factors, start: &Multivariate) -> Multivariate {
    let factors = factors.iter().flat_map(|(factor, power)| std::iter::repeat_n(factor, *power));
    factors.fold(start.clone(), |product, factor| product.times(factor))
}
