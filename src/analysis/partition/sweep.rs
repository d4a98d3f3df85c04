//! The interval (0, 1) of the parameter, divided until each part shows one event at most.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Zero};

use super::bernstein_table::BernsteinTable;
use super::boxes::{Closed, PartitionEvent, events};
use super::family::RatioFamily;

/// A closed interval of the parameter, without the ends at which the family stops.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Stretch {
    pub(super) from: BigRational,
    pub(super) to: BigRational,
    pub(super) content: Content,
}

/// What happens in a part.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Content {
    /// The number of local maxima is constant.
    Constant,
    /// It changes at one t at most, by these events, each on a span of its own, all at that t.
    Events(Vec<(usize, PartitionEvent)>),
    /// Not decided.
    Undecided,
}

/// Divisions in y for each division in t, and to begin with.
const FIRST_DEPTH: u32 = 3;

/// The parts of (0, 1], or of (0, 1) if the family is not defined at 1, from left to right; `depth` halvings in t
/// at most.
pub(super) fn sweep(family: &RatioFamily, closed_at_one: bool, depth: u32) -> Vec<Stretch> {
    let tables = family.slopes().iter().map(|(s, slope)| (*s, BernsteinTable::on_unit_square(slope)));
    let mut parts = Vec::new();
    if family.may_be_constant() {
        return vec![Stretch {
            from: BigRational::zero(),
            to: BigRational::one(),
            content: Content::Undecided,
        }];
    }
    let mut tasks = vec![(BigInt::zero(), 0_u32, tables.collect::<Vec<_>>())];
    while let Some((place, level, tables)) = tasks.pop() {
        let dyadic = |place: BigInt| BigRational::new(place, BigInt::one() << level);
        let next = &place + BigInt::one();
        let last = next == BigInt::one() << level;
        let closed = Closed { from: !place.is_zero(), to: closed_at_one || !last };
        let mut open = Vec::new();
        let mut found = Some(Vec::new());
        for (s, table) in tables {
            let events = events(&table, closed, FIRST_DEPTH + level);
            if events.as_ref().is_some_and(Vec::is_empty) {
                continue;
            }
            found = found.zip(events).map(|(mut found, events)| {
                found.extend(events.into_iter().map(|event| (s, event)));
                found
            });
            open.push((s, table));
        }
        let (from, to) = (dyadic(place.clone()), dyadic(next));
        let content = match found {
            Some(found) if found.is_empty() => Content::Constant,
            // An event needs a number on both sides of it.
            Some(found) if closed.from && closed.to && family.coincide(&found, &from, &to) => {
                Content::Events(found)
            }
            _ => Content::Undecided,
        };
        if content == Content::Undecided && level < depth {
            let (low, high): (Vec<_>, Vec<_>) = open
                .into_iter()
                .map(|(s, table)| {
                    let (low, high) = table.halved_in_t();
                    ((s, low), (s, high))
                })
                .unzip();
            let start = place * 2;
            tasks.push((&start + BigInt::one(), level + 1, high));
            tasks.push((start, level + 1, low));
        } else {
            parts.push(Stretch { from, to, content });
        }
    }
    parts
}
