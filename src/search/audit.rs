//! Blocks of a result computed again: a merge believes the shards, and an audit does not.

use std::ops::Range;

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};
use thiserror::Error;

use super::block::Block;
use super::finding::Findings;
use super::mismatch::Mismatch;
use super::portion::Portion;
use super::shard::Shard;

/// Which blocks are computed again.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Draw {
    /// So many, drawn from a seed; all, if there are no more.
    Blocks {
        /// How many.
        count: u64,
        /// By which whoever audits draws them: nobody who wrote a shard could know it.
        seed: u64,
    },
    /// All of them: the search as a whole, once more.
    All,
}

/// What an audit has found.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Audit {
    /// The number of blocks of the search.
    pub blocks: u64,
    /// The positions of the blocks that were computed again, in order.
    pub again: Vec<Range<u64>>,
    /// What came out differently.
    pub differences: Vec<Discrepancy>,
}

/// Something that came out differently.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Discrepancy {
    /// The positions of the block, or of all of them.
    pub positions: Range<u64>,
    /// What.
    pub fault: Mismatch,
}

/// Why nothing is audited.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
pub enum AuditError {
    /// No block.
    #[error("0 blocks computed again show nothing: ask for 1 at least, or for `all`")]
    NoBlock,
    /// A part of a search.
    #[error("only a search as a whole is audited")]
    Unfinished,
}

/// Computes blocks of a whole search again, looking in now and then with the positions that are done, and compares all that
/// is recorded of them. If all blocks are computed again, nothing that is not so is left.
///
/// # Errors
/// [`AuditError`], and what the look-in returns.
///
/// ```
/// use knotproof::search::{Draw, Goal, Limits, Portion, Search, Shard, Space, audit};
///
/// let space = Space::Exhaustive(Limits { size: 7, gap: None, height: None });
/// let mut part = Portion::new(Search { degree: 3, find: Goal::Several, space }, Shard::WHOLE)?;
/// part.run(|_| Ok::<(), knotproof::search::AuditError>(())).unwrap();
/// let audit = audit(&part, Draw::Blocks { count: 1, seed: 7 }, |_| Ok::<(), knotproof::search::AuditError>(())).unwrap();
/// assert_eq!((audit.again.len(), audit.differences.len()), (1, 0));
/// # Ok::<(), knotproof::search::PortionError>(())
/// ```
pub fn audit<E: From<AuditError>>(
    part: &Portion,
    draw: Draw,
    mut look_in: impl FnMut(u64) -> Result<(), E>,
) -> Result<Audit, E> {
    if !part.is_complete() || !part.shard.is_whole() {
        return Err(AuditError::Unfinished.into());
    }
    let recorded: Vec<(u64, Block)> = part.blocks.iter().collect();
    let blocks = recorded.len() as u64;
    let chosen = match draw {
        Draw::Blocks { count: 0, .. } => return Err(AuditError::NoBlock.into()),
        Draw::Blocks { count, seed } => drawn(recorded.len(), count, seed),
        Draw::All => (0..recorded.len()).collect(),
    };
    let all = chosen.len() == recorded.len();
    let mut audit = Audit { blocks, again: Vec::new(), differences: Vec::new() };
    let (mut whole, mut positions) = (Findings::default(), 0);
    for (number, recorded) in chosen.into_iter().map(|at| recorded[at]) {
        let range = part.blocks.positions(number, &part.range);
        let mut again =
            Portion::of_range(part.search.clone(), Shard::WHOLE, part.cases.clone(), range.clone());
        again.run(|again| look_in(positions + again.done()))?;
        positions += again.done();
        let found = again.blocks.iter().next().map(|(_, block)| block).unwrap_or_default();
        let mut faults = Vec::new();
        if found.decided != recorded.decided {
            faults.push(Mismatch::Counts { recorded: recorded.decided, again: found.decided });
        }
        if found.digest != recorded.digest {
            faults.push(Mismatch::Digest { recorded: recorded.digest, again: found.digest });
        }
        if !part.undecided.agrees(&again.undecided, &range) {
            faults.push(Mismatch::Undecided);
        }
        faults.extend(part.findings.faults(&again.findings, part.search.find, &range));
        let difference = |fault| Discrepancy { positions: range.clone(), fault };
        audit.differences.extend(faults.into_iter().map(difference));
        audit.again.push(range);
        whole.merge(again.findings);
    }
    if all && audit.differences.is_empty() {
        // Only now the numbers of cases that led to a finding can be compared as well.
        whole.keep(part.search.find);
        let difference = |fault| Discrepancy { positions: part.range(), fault };
        audit.differences.extend(part.findings.altered(&whole).map(difference));
    }
    Ok(audit)
}

/// So many different numbers below `of`, in order: Floyd's algorithm, on a stream of ChaCha8.
fn drawn(of: usize, count: u64, seed: u64) -> Vec<usize> {
    let count = usize::try_from(count).unwrap_or(of).min(of);
    let mut source = ChaCha8Rng::seed_from_u64(seed);
    let mut chosen = std::collections::BTreeSet::new();
    for last in of - count..of {
        let at = below(&mut source, last as u64 + 1);
        let at = usize::try_from(at).unwrap_or(last);
        if !chosen.insert(at) {
            chosen.insert(last);
        }
    }
    chosen.into_iter().collect()
}

/// A number below the bound, all equally likely.
fn below(source: &mut ChaCha8Rng, bound: u64) -> u64 {
    let even = u64::MAX - u64::MAX % bound;
    loop {
        let number = source.next_u64();
        if number < even {
            return number % bound;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::search::{Goal, Limits, Sample, Search, Space};

    fn part(find: Goal) -> Portion {
        let space = match find {
            Goal::Equal => Space::Exhaustive(Limits { size: 8, gap: None, height: None }),
            _ => Space::Random(Sample { count: 600, seed: 1, spread: 9 }),
        };
        let mut part = Portion::new(Search { degree: 3, find, space }, Shard::WHOLE).unwrap();
        part.run(|_| Ok::<(), AuditError>(())).unwrap();
        part
    }

    fn differences(part: &Portion, draw: Draw) -> Vec<Discrepancy> {
        audit(part, draw, |_| Ok::<(), AuditError>(())).unwrap().differences
    }

    #[test]
    fn what_is_so_is_found_again() {
        for find in [Goal::Several, Goal::Most, Goal::Equal, Goal::Deepest] {
            let part = part(find);
            assert!(!part.findings.is_empty());
            assert_eq!(differences(&part, Draw::All), [], "{find:?}");
            for seed in 0..2 {
                assert_eq!(differences(&part, Draw::Blocks { count: 1, seed }), [], "{find:?}");
            }
        }
    }

    #[test]
    fn blocks_are_drawn_without_repetition_and_all_are_possible() {
        let mut met = std::collections::BTreeSet::new();
        for seed in 0..200 {
            let blocks = drawn(10, 3, seed);
            assert!(blocks.len() == 3 && blocks.windows(2).all(|pair| pair[0] < pair[1]));
            assert_eq!(blocks, drawn(10, 3, seed));
            met.extend(blocks);
        }
        assert_eq!(met.len(), 10);
        assert_eq!((drawn(4, 4, 1), drawn(4, 9, 1)), (vec![0, 1, 2, 3], vec![0, 1, 2, 3]));
    }

    #[test]
    fn no_block_is_no_audit() {
        let none = Draw::Blocks { count: 0, seed: 1 };
        assert_eq!(audit(&part(Goal::Several), none, |_| Ok(())), Err(AuditError::NoBlock));
    }
}
