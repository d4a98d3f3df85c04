//! Which of several values is the largest, when some are taken at irrational points.

use super::algebraic::{Algebraic, Enclosed};

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
    pub(super) height: Algebraic,
    pub(super) role: Role,
}

/// Looks at the bounds, each a few bits narrower than the one before: values that agree to about 128 bits and are not
/// found equal otherwise are left undecided.
const LOOKS: u32 = 16;

/// How often a supremum is attained.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Attained {
    /// At so many points; 0 if it is a limit only.
    Times(usize),
    /// On an interval.
    Throughout,
}

/// Is the supremum of the contenders attained, and at exactly one point? `None` as for [`attained`].
pub(super) fn attained_once(contenders: Vec<Contender>) -> Option<bool> {
    attained(contenders).map(|attained| attained == Attained::Times(1))
}

/// How often the supremum of the contenders is attained; `None` where values at irrational points could not be told apart.
///
/// Enclosures are refined until a single contender is left, or only exact ones. A value at an irrational point
/// is compared with a rational one exactly, by a greatest common divisor; two values at irrational points that
/// agree to some 128 bits stay undecided, unless neither way matters.
pub(super) fn attained(mut contenders: Vec<Contender>) -> Option<Attained> {
    for _ in 0..LOOKS {
        keep_largest(&mut contenders);
        if let Some(verdict) = verdict(&contenders) {
            return Some(verdict);
        }
        for contender in &mut contenders {
            contender.height.narrow();
        }
    }
    let exact = contenders.iter().find_map(|contender| contender.height.exact())?.clone();
    for contender in &mut contenders {
        if contender.height.is(&exact) {
            contender.height = exact.clone().into();
        }
    }
    verdict(&contenders)
}

/// Drops what is certainly smaller than another one.
fn keep_largest(contenders: &mut Vec<Contender>) {
    let bounds: Vec<_> = contenders.iter_mut().map(|contender| contender.height.bounds()).collect();
    let largest = bounds.iter().map(|(lo, _)| lo).max();
    let mut keep = bounds.iter().map(|(_, hi)| largest.is_none_or(|largest| hi >= largest));
    contenders.retain(|_| keep.next().unwrap_or(true));
}

/// The answer, if it is clear from those that are left, none of which is known to be smaller than another.
fn verdict(contenders: &[Contender]) -> Option<Attained> {
    let of = |role| contenders.iter().filter(move |contender| contender.role == role).count();
    // Plateaus and limits are exact: what is left of them is equal.
    match (of(Role::Point), of(Role::Plateau)) {
        (0, 0) => return Some(Attained::Times(0)),
        (0, _) => return Some(Attained::Throughout),
        _ => {}
    }
    let all_exact = contenders.iter().all(|contender| contender.height.exact().is_some());
    if contenders.len() > 1 && !all_exact {
        return None;
    }
    // All of these are equal: a limit of the same height does not matter, a second place does.
    Some(if of(Role::Plateau) > 0 { Attained::Throughout } else { Attained::Times(of(Role::Point)) })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::positive_roots;
    use crate::scalar::{Polynomial, RationalFunction, Ring, rational};

    fn exact(value: i64, role: Role) -> Contender {
        Contender { height: rational(value, 1).into(), role }
    }

    /// u^power at √2.
    fn at_root(power: usize) -> Contender {
        let two = Polynomial::new(rational(-2, 1), [0, 1].map(|c| rational(c, 1)));
        let piece = RationalFunction::variable(&rational(1, 1)).power(power);
        Contender { height: Algebraic::at(piece, positive_roots(&two).remove(0)), role: Role::Point }
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
