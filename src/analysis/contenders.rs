//! Which of several values is the largest, when some are taken at irrational points.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::Signed;

use crate::scalar::{Polynomial, RationalAlgebra, Ring, integer};

use super::pieces::Piece;
use super::roots::IsolatedRoot;

/// A value of a piece.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Height {
    /// Known exactly.
    Exact(BigRational),
    /// The value of a piece at an irrational root.
    At(Box<(Piece, IsolatedRoot)>),
}

/// How a value takes part in the question of whether the supremum is attained exactly once.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Role {
    /// Attained at one point.
    Point,
    /// Attained on an interval.
    Plateau,
    /// A limit that is not attained there.
    Limit,
}

/// A value that could be the supremum.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Contender {
    pub(super) height: Height,
    pub(super) role: Role,
}

/// Bisections between two looks at the enclosures, and the number of looks: values that agree to about this
/// many bits and are not found equal otherwise are left undecided.
const STEP: u32 = 8;
const LOOKS: u32 = 16;

impl Height {
    /// Lower and upper bounds, equal if the value is exact. Refines the root until the denominator has a sign
    /// on its interval: it has one, since a piece has no pole inside its span.
    pub(super) fn enclosure(&mut self) -> (BigRational, BigRational) {
        match self {
            Self::Exact(value) => (value.clone(), value.clone()),
            Self::At(at) => loop {
                if let Some(bounds) = enclose(&at.0, &at.1.interval()) {
                    break bounds;
                }
                at.1.refine();
            },
        }
    }

    /// [`enclosure`](Self::enclosure), at most `width` > 0 apart.
    pub(super) fn enclosure_within(&mut self, width: &BigRational) -> (BigRational, BigRational) {
        loop {
            let (lo, hi) = self.enclosure();
            if !width.is_positive() || &hi - &lo <= *width {
                return (lo, hi);
            }
            self.refine();
        }
    }

    fn refine(&mut self) {
        if let Self::At(at) = self {
            let width = (at.1.hi() - at.1.lo()) / BigInt::from(1_u32 << STEP);
            at.1.refine_to(&width);
        }
    }

    /// Is the value this rational number? P(ξ) = value·Q(ξ), decided exactly.
    fn is(&self, value: &BigRational) -> bool {
        match self {
            Self::Exact(own) => own == value,
            Self::At(at) => {
                let (piece, root) = &**at;
                root.is_root_of(&piece.numerator().minus(&piece.denominator().scaled(value)))
            }
        }
    }
}

/// Bounds of P/Q on [lo, hi], 0 ≤ lo: P = P₊ − P₋ with coefficients ≥ 0 in both, which rise with u.
fn enclose(f: &Piece, (lo, hi): &(BigRational, BigRational)) -> Option<(BigRational, BigRational)> {
    let (p_lo, p_hi) = enclose_polynomial(f.numerator(), lo, hi);
    let (q_lo, q_hi) = enclose_polynomial(f.denominator(), lo, hi);
    if !q_lo.is_positive() {
        return None;
    }
    let lower = p_lo.over(if p_lo.is_negative() { &q_lo } else { &q_hi })?;
    let upper = p_hi.over(if p_hi.is_negative() { &q_hi } else { &q_lo })?;
    Some((lower, upper))
}

fn enclose_polynomial(
    p: &Polynomial<BigRational>,
    lo: &BigRational,
    hi: &BigRational,
) -> (BigRational, BigRational) {
    let part = |negative: bool| {
        let coefficients = p.coefficients().iter();
        let kept = coefficients.map(|c| if c.is_negative() == negative { c.clone() } else { integer(0) });
        kept.collect::<Vec<_>>()
    };
    let (positive, negative) = (part(false), part(true));
    let value = BigRational::value_of_polynomial;
    let lower = value(&positive, lo).plus(&value(&negative, hi));
    let upper = value(&positive, hi).plus(&value(&negative, lo));
    (lower, upper)
}

/// Is the supremum of the contenders attained, and at exactly one point? `None` where values at irrational
/// points could not be told apart.
///
/// Enclosures are refined until a single contender is left, or only exact ones. A value at an irrational point
/// is compared with a rational one exactly, by a greatest common divisor; two values at irrational points that
/// agree to some 128 bits stay undecided, unless neither way matters.
pub(super) fn attained_once(mut contenders: Vec<Contender>) -> Option<bool> {
    for _ in 0..LOOKS {
        keep_largest(&mut contenders);
        if let Some(verdict) = verdict(&contenders) {
            return Some(verdict);
        }
        for contender in &mut contenders {
            contender.height.refine();
        }
    }
    let exact = contenders.iter().find_map(|contender| match &contender.height {
        Height::Exact(value) => Some(value.clone()),
        Height::At(_) => None,
    })?;
    for contender in &mut contenders {
        if contender.height.is(&exact) {
            contender.height = Height::Exact(exact.clone());
        }
    }
    verdict(&contenders)
}

/// Drops what is certainly smaller than another one.
fn keep_largest(contenders: &mut Vec<Contender>) {
    let bounds: Vec<_> = contenders.iter_mut().map(|contender| contender.height.enclosure()).collect();
    let largest = bounds.iter().map(|(lo, _)| lo).max();
    let mut keep = bounds.iter().map(|(_, hi)| largest.is_none_or(|largest| hi >= largest));
    contenders.retain(|_| keep.next().unwrap_or(true));
}

/// The answer, if it is clear from those that are left, none of which is known to be smaller than another.
fn verdict(contenders: &[Contender]) -> Option<bool> {
    let points = contenders.iter().filter(|contender| contender.role == Role::Point).count();
    if points == 0 {
        return Some(false);
    }
    let all_exact = contenders.iter().all(|contender| matches!(contender.height, Height::Exact(_)));
    if contenders.len() > 1 && !all_exact {
        return None;
    }
    // All of these are equal: a limit of the same height does not matter, a second place does.
    let attained = contenders.iter().filter(|contender| contender.role != Role::Limit).count();
    Some(attained == 1)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::positive_roots;
    use crate::scalar::{RationalFunction, rational};

    fn exact(value: i64, role: Role) -> Contender {
        Contender { height: Height::Exact(rational(value, 1)), role }
    }

    /// u^power at √2.
    fn at_root(power: usize) -> Contender {
        let two = Polynomial::new(rational(-2, 1), [0, 1].map(|c| rational(c, 1)));
        let piece = RationalFunction::variable(&rational(1, 1)).power(power);
        Contender { height: Height::At(Box::new((piece, positive_roots(&two).remove(0)))), role: Role::Point }
    }

    #[test]
    fn every_combination_of_roles() {
        let (point, plateau, limit) = (Role::Point, Role::Plateau, Role::Limit);
        for (contenders, expected) in [
            (vec![], Some(false)),
            (vec![exact(1, point)], Some(true)),
            (vec![exact(1, plateau)], Some(false)),
            (vec![exact(1, limit)], Some(false)),
            (vec![exact(1, point), exact(1, point)], Some(false)),
            (vec![exact(1, point), exact(2, point)], Some(true)),
            (vec![exact(1, point), exact(1, limit)], Some(true)),
            (vec![exact(1, point), exact(2, limit)], Some(false)),
            (vec![exact(1, point), exact(1, plateau)], Some(false)),
            (vec![at_root(1), exact(1, point), exact(1, point)], Some(true)),
            (vec![at_root(1), exact(2, limit)], Some(false)),
            // √2² = 2, found by the exact test.
            (vec![at_root(2), exact(2, limit)], Some(true)),
            (vec![at_root(2), exact(2, point)], Some(false)),
            (vec![at_root(1), at_root(3)], Some(true)),
            // Equal, but only up to the limit of refinement.
            (vec![at_root(3), at_root(3)], None),
        ] {
            assert_eq!(attained_once(contenders.clone()), expected, "{contenders:?}");
        }
    }
}
