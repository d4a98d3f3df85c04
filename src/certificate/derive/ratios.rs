//! What is known of the slope ratios of indices: what is assumed of α, or the order of 1, r, and those of other indices.

use std::cmp::Ordering;

use crate::certificate::term::Term;
use crate::language::Name;
use crate::scalar::integer;

use super::obligation::Obligation;

/// All orders of so many numbers: the ranks of each, without a gap.
pub(super) fn orders(count: usize) -> Option<Vec<Vec<usize>>> {
    const MOST: usize = 5;
    if count > MOST {
        return None;
    }
    let digits = |code: usize| {
        (0..count).rev().map(move |at| code / count.pow(u32::try_from(at).unwrap_or(0)) % count)
    };
    let all = (0..count.pow(u32::try_from(count).unwrap_or(0))).map(|code| digits(code).collect::<Vec<_>>());
    Some(all.filter(|order| order.iter().all(|rank| *rank == 0 || order.contains(&(rank - 1)))).collect())
}

/// Ratios by parameters that are positive.
#[derive(Debug, Clone, Default)]
pub(super) struct Ratios {
    /// The parameters.
    pub(super) declared: Vec<String>,
    /// r.
    pub(super) own: Option<Term>,
    /// Those of other indices.
    pub(super) others: Vec<(Name, Term)>,
    /// Their order may still be asked for.
    pub(super) is_free: bool,
}

fn rho(j: i64) -> String {
    format!("(rho {j})")
}

fn one() -> Term {
    Term::Number(integer(1))
}

/// 1 + Σ (rho j).
fn above(steps: impl Iterator<Item = i64>) -> Term {
    Term::Sum(std::iter::once(one()).chain(steps.map(|j| Term::Named(rho(j)))).collect())
}

fn over_one(below: Term) -> Term {
    Term::Ratio(Box::new(one()), Box::new(below))
}

impl Ratios {
    /// What is assumed of α.
    pub(super) fn of(side: Option<Ordering>) -> Self {
        side.map_or_else(Self::default, |side| match side {
            Ordering::Less => Self::ranked(&[1, 0], &[]),
            Ordering::Equal => Self::ranked(&[0, 0], &[]),
            Ordering::Greater => Self::ranked(&[0, 1], &[]),
        })
    }

    /// All orders of 1, r, and the ratios of other indices, which differ from r.
    pub(super) fn in_order(obligation: &Obligation<'_>) -> Vec<Self> {
        let names = &obligation.indices;
        let all = orders(2 + names.len()).unwrap_or_default();
        let fits = all.iter().filter(|order| !order[2..].contains(&order[1]));
        fits.map(|order| Self::ranked(order, names)).collect()
    }

    /// By the ranks of 1, r, and the ratios of those that are named.
    fn ranked(order: &[usize], names: &[Name]) -> Self {
        let rank = |at: usize| i64::try_from(order[at]).unwrap_or(0) - i64::try_from(order[0]).unwrap_or(0);
        let beside = |at: usize| match rank(at) {
            0 => one(),
            steps @ 1.. => above(0..steps),
            steps => over_one(above((1..=-steps).map(|j| -j))),
        };
        let (least, most) = (0..order.len()).fold((0, 0), |(a, b), at| (rank(at).min(a), rank(at).max(b)));
        let others = names.iter().zip(2..).map(|(name, at)| (name.clone(), beside(at))).collect();
        Self { declared: (least..most).map(rho).collect(), own: Some(beside(1)), others, is_free: false }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_orders_are_tried() {
        let count = |n| orders(n).unwrap().len();
        assert_eq!([0, 1, 2, 3, 4].map(count), [1, 1, 3, 13, 75]);
        assert_eq!(orders(6), None);
    }
}
