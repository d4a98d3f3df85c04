//! Shards put together, with the proof that nothing is missing and nothing counted twice.

use std::ops::Range;

use thiserror::Error;

use super::block::Blocks;
use super::decide::Decided;
use super::finding::Findings;
use super::portion::Portion;
use super::shard::Shard;
use super::undecided::Undecided;

/// Why parts do not make up a search. Parts are called by the names that were given.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum MergeError {
    /// Nothing to merge.
    #[error("there is no shard to merge")]
    None,
    /// A part of another search.
    #[error("{part}: it is part of another search than {first}: degree, goal and space have to be the same")]
    Mixed {
        /// The one of another search.
        part: String,
        /// The first one.
        first: String,
    },
    /// A part that was interrupted.
    #[error(
        "{part}: it is not finished: {done} of {positions} positions are done; go on with `knotproof search --resume`"
    )]
    Unfinished {
        /// Which.
        part: String,
        /// Positions done.
        done: u64,
        /// Positions of the part.
        positions: u64,
    },
    /// Positions that two parts have.
    #[error("{part}: it overlaps with {before}: positions {from} to {to} are in both; give each shard once")]
    Overlap {
        /// The later one.
        part: String,
        /// The earlier one.
        before: String,
        /// The first of the common positions.
        from: u64,
        /// The position after the last one.
        to: u64,
    },
    /// Positions that no part has.
    #[error("positions {from} to {to} of {positions} are in none of the shards: one is missing")]
    Gap {
        /// The first of them.
        from: u64,
        /// The position after the last one.
        to: u64,
        /// All positions.
        positions: u64,
    },
    /// Cases that do not add up.
    #[error(
        "the shards have {found} cases, and the space has {expected}: one was not written by this program"
    )]
    Count {
        /// The sum over the parts.
        found: u64,
        /// The number that is known beforehand.
        expected: u64,
    },
}

/// The whole search, from its shards in any order: the same as if it had been searched at once.
///
/// The ranges of positions have to add up exactly to the space, and the numbers of cases to the number that is known
/// without searching.
///
/// # Errors
/// [`MergeError`], for the first thing that does not fit.
pub fn merge(parts: Vec<(String, Portion)>) -> Result<Portion, MergeError> {
    let (first_name, first) = parts.first().ok_or(MergeError::None)?;
    let (search, cases, whole) = (first.search.clone(), first.cases.clone(), first.cases.positions());
    for (name, part) in &parts {
        let range = &part.range;
        if part.search != search {
            return Err(MergeError::Mixed { part: name.clone(), first: first_name.clone() });
        }
        if !part.is_complete() {
            let positions = range.end - range.start;
            return Err(MergeError::Unfinished { part: name.clone(), done: part.done(), positions });
        }
    }
    let mut order: Vec<&(String, Portion)> = parts.iter().collect();
    order.sort_by_key(|(_, part)| (part.range.start, part.range.end));
    let (mut reached, mut before) = (0, first_name);
    for (name, part) in order {
        let Range { start, end } = part.range;
        if start < reached {
            let (part, before) = (name.clone(), before.clone());
            return Err(MergeError::Overlap { part, before, from: start, to: reached.min(end) });
        }
        if start > reached {
            return Err(MergeError::Gap { from: reached, to: start, positions: whole });
        }
        (reached, before) = (end, name);
    }
    if reached != whole {
        return Err(MergeError::Gap { from: reached, to: whole, positions: whole });
    }
    let (mut decided, mut blocks) = (Decided::default(), Blocks::new(whole));
    for (_, part) in &parts {
        decided.add(part.decided);
        blocks.merge(&part.blocks);
    }
    if decided.cases() != cases.count() {
        return Err(MergeError::Count { found: decided.cases(), expected: cases.count() });
    }
    let (mut findings, mut undecided) = (Findings::default(), Undecided::default());
    for (_, part) in parts {
        findings.merge(part.findings);
        undecided.merge(part.undecided);
    }
    findings.keep(search.find);
    Ok(Portion {
        search,
        shard: Shard::WHOLE,
        cases,
        range: 0..whole,
        done: whole,
        decided,
        blocks,
        findings,
        undecided,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::search::{Goal, Limits, Sample, Search, Space};

    fn shards(find: Goal, space: &Space, of: usize) -> Vec<(String, Portion)> {
        let search = Search { degree: 3, find, space: space.clone() };
        let shard = |i: usize| {
            let mut part = Portion::new(search.clone(), format!("{i}/{of}").parse().unwrap()).unwrap();
            part.run(|_| Ok::<(), ()>(())).unwrap();
            (i.to_string(), part)
        };
        (0..of).map(shard).collect()
    }

    #[test]
    fn merged_shards_are_the_whole_search() {
        for find in [Goal::Several, Goal::Most, Goal::Equal, Goal::Deepest] {
            for space in [
                Space::Exhaustive(Limits { size: 8, gap: None, height: None }),
                Space::Random(Sample { count: 330, seed: 3, spread: 9 }),
            ] {
                let whole = shards(find, &space, 1).remove(0).1.to_text().unwrap();
                for of in [2, 5] {
                    let mut parts = shards(find, &space, of);
                    parts.reverse();
                    assert_eq!(merge(parts).unwrap().to_text().unwrap(), whole);
                }
            }
        }
    }

    #[test]
    fn what_does_not_make_up_a_search_is_refused() {
        let space = Space::Exhaustive(Limits { size: 6, gap: None, height: None });
        let (parts, halves) = (shards(Goal::Several, &space, 3), shards(Goal::Several, &space, 2));
        let pick = |list: &[&(String, Portion)]| merge(list.iter().map(|part| (*part).clone()).collect());
        assert_eq!(pick(&[]).unwrap_err(), MergeError::None);
        assert!(matches!(pick(&[&parts[0], &parts[2]]), Err(MergeError::Gap { .. })));
        assert!(matches!(pick(&[&parts[1], &parts[2]]), Err(MergeError::Gap { from: 0, .. })));
        assert!(matches!(pick(&[&parts[0], &parts[1]]), Err(MergeError::Gap { .. })));
        let again = [&parts[0], &parts[1], &parts[2], &parts[1]];
        assert!(
            matches!(pick(&again), Err(MergeError::Overlap { part, before, .. }) if part == "1" && before == "1")
        );
        assert!(
            matches!(pick(&[&halves[0], &parts[1], &parts[2]]), Err(MergeError::Overlap { part, .. }) if part == "1")
        );
        let most = shards(Goal::Most, &space, 3);
        assert!(
            matches!(pick(&[&parts[0], &most[1], &parts[2]]), Err(MergeError::Mixed { part, .. }) if part == "1")
        );
        let mut part = parts[1].clone();
        part.1.done -= 1;
        assert!(
            matches!(pick(&[&parts[0], &part, &parts[2]]), Err(MergeError::Unfinished { part, .. }) if part == "1")
        );
        part.1.done += 1;
        part.1.decided.by_intervals -= 1;
        assert!(matches!(pick(&[&parts[0], &part, &parts[2]]), Err(MergeError::Count { .. })));
    }
}
