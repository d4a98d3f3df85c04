//! What came of a block of positions, in a few numbers that a second run of it has to reproduce.

use std::collections::BTreeMap;
use std::hash::Hasher;
use std::ops::Range;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use siphasher::sip::SipHasher24;

use super::decide::{Count, Decided, Means};
use super::subject::Subject;

/// The fewest positions of a block, and the most blocks of a space.
const SMALLEST: u64 = 256;
const MOST: u64 = 1024;

/// The blocks of a space: positions 0 to `size`, `size` to 2·`size`, and so on. Of those at the ends of a shard it has
/// a part.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Blocks {
    size: u64,
    /// By their numbers, those that a shard has begun.
    blocks: BTreeMap<u64, Block>,
}

/// What came of a block, or of a part of it: sums over its cases, so parts add up.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Block {
    /// The numbers of cases.
    pub decided: Decided,
    /// The sum mod 2^64, over all cases, of a SipHash-2-4 of the position, the function, its number of local maxima and
    /// the means by which that was decided.
    pub digest: u64,
}

/// A [`Block`] as it stands in a result.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BlockRecord {
    /// Its first position in this part.
    pub from: u64,
    /// The position after the last one that is done.
    pub to: u64,
    /// Cases that were decided by intervals.
    pub by_intervals: u64,
    /// Cases that were decided in exact arithmetic.
    pub exactly: u64,
    /// Cases with more than one local maximum.
    pub several: u64,
    /// Cases that are not decided; left out, if all are.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub undecided: u64,
    /// The digest, in 16 hexadecimal digits.
    pub digest: String,
}

/// A number that is left out.
#[expect(clippy::trivially_copy_pass_by_ref, reason = "what serde asks for")]
pub(super) fn is_zero(number: &u64) -> bool {
    *number == 0
}

impl Block {
    /// Adds a case; `None`, if it is not decided.
    pub(super) fn count(&mut self, position: u64, subject: &Subject, count: Option<Count>) {
        match count.map(|count| count.by) {
            Some(Means::Intervals) => self.decided.by_intervals += 1,
            Some(Means::Exact) => self.decided.exactly += 1,
            None => self.decided.undecided += 1,
        }
        self.decided.several += u64::from(count.is_some_and(|count| count.maxima > 1));
        let mut hasher = SipHasher24::new();
        // No function that is decided has so many maxima.
        let maxima = count.map_or(u64::MAX, |count| count.maxima as u64);
        let exactly = count.is_some_and(|count| count.by == Means::Exact);
        subject.digest(position, maxima, exactly, &mut hasher);
        self.digest = self.digest.wrapping_add(hasher.finish());
    }

    pub(super) fn add(&mut self, other: Self) {
        self.decided.add(other.decided);
        self.digest = self.digest.wrapping_add(other.digest);
    }
}

impl Blocks {
    /// Those of a space with so many positions: none begun yet.
    pub(super) fn new(positions: u64) -> Self {
        Self { size: positions.div_ceil(MOST).next_power_of_two().max(SMALLEST), blocks: BTreeMap::new() }
    }

    /// The number of the block with this position.
    pub(super) fn number(&self, position: u64) -> u64 {
        position / self.size
    }

    /// The positions of a block that lie in a range.
    pub(super) fn positions(&self, number: u64, within: &Range<u64>) -> Range<u64> {
        let start = number.saturating_mul(self.size);
        start.max(within.start)..start.saturating_add(self.size).min(within.end)
    }

    /// The positions of a range in pieces of at most so many, each within one block.
    pub(super) fn pieces(&self, range: Range<u64>, longest: u64) -> Vec<Range<u64>> {
        let mut pieces = Vec::new();
        let mut start = range.start;
        while start < range.end {
            let block_end = self.positions(self.number(start), &range).end;
            let end = block_end.min(start.saturating_add(longest.max(1)));
            pieces.push(start..end);
            start = end;
        }
        pieces
    }

    /// Adds what came of some positions of a block.
    pub(super) fn add(&mut self, number: u64, block: Block) {
        self.blocks.entry(number).or_default().add(block);
    }

    /// Adds the blocks of another part of the same space.
    pub(super) fn merge(&mut self, other: &Self) {
        other.blocks.iter().for_each(|(number, block)| self.add(*number, *block));
    }

    /// Those that are begun, with their numbers.
    pub(super) fn iter(&self) -> impl Iterator<Item = (u64, Block)> {
        self.blocks.iter().map(|(number, block)| (*number, *block))
    }

    /// As lines of a result, for the positions that are done.
    pub(super) fn records(&self, done: &Range<u64>) -> Vec<BlockRecord> {
        let record = |(number, Block { decided, digest }): (u64, Block)| {
            let Range { start, end } = self.positions(number, done);
            BlockRecord {
                from: start,
                to: end,
                by_intervals: decided.by_intervals,
                exactly: decided.exactly,
                several: decided.several,
                undecided: decided.undecided,
                digest: format!("{digest:016x}"),
            }
        };
        self.iter().map(record).collect()
    }

    /// Reads the blocks of a result, which have to be those of the positions that are done and have to add up to the
    /// cases of it.
    pub(super) fn read(
        &mut self,
        records: &[BlockRecord],
        done: &Range<u64>,
        whole: Decided,
    ) -> Result<(), &'static str> {
        let expected = self.pieces(done.clone(), u64::MAX);
        if !records.iter().map(|record| record.from..record.to).eq(expected) {
            return Err("its blocks are not those of the positions that are done");
        }
        let mut sum = Decided::default();
        for record in records {
            let &BlockRecord { from, to, by_intervals, exactly, several, undecided, ref digest } = record;
            let decided = Decided { by_intervals, exactly, several, undecided };
            let cases = decided.checked_cases().filter(|&cases| cases <= to - from);
            if cases.is_none_or(|cases| several > cases) {
                return Err("a block has more cases than positions, or more with several maxima than cases");
            }
            let digest = u64::from_str_radix(digest, 16).map_err(|_| "the digest of a block is no number")?;
            sum.add(decided);
            self.add(self.number(from), Block { decided, digest });
        }
        if sum == whole { Ok(()) } else { Err("the cases of its blocks do not add up to its cases") }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::search::Candidate;

    #[test]
    fn blocks_are_few_and_pieces_stay_within_them() {
        for positions in [1, 255, 256, 257, 262_144, 262_145, 1 << 40, u64::MAX] {
            let blocks = Blocks::new(positions);
            assert!(blocks.number(positions - 1) < MOST && blocks.size >= SMALLEST, "{positions}");
            let all = 0..positions.min(5000);
            let pieces = blocks.pieces(all.clone(), 100);
            assert_eq!((pieces[0].start, pieces[pieces.len() - 1].end), (0, all.end));
            assert!(pieces.windows(2).all(|pair| pair[0].end == pair[1].start));
            assert!(pieces.iter().all(|piece| blocks.number(piece.start) == blocks.number(piece.end - 1)));
        }
    }

    #[test]
    fn a_digest_is_of_all_that_was_decided() {
        let candidate = |gaps: &[u64], ratio| Subject::Index(Candidate::new(gaps.to_vec(), ratio).unwrap());
        let digest = |position, subject: &Subject, maxima, by| {
            let mut block = Block::default();
            block.count(position, subject, Some(Count { maxima, by }));
            block.digest
        };
        let function = candidate(&[2, 1, 1, 0], (3, 5));
        let digests = [
            digest(7, &function, 2, Means::Exact),
            digest(8, &function, 2, Means::Exact),
            digest(7, &function, 1, Means::Exact),
            digest(7, &function, 2, Means::Intervals),
            digest(7, &candidate(&[2, 1, 1, 1], (3, 5)), 2, Means::Exact),
            digest(7, &candidate(&[2, 1, 1, 0], (3, 4)), 2, Means::Exact),
        ];
        let different: std::collections::BTreeSet<_> = digests.iter().collect();
        assert_eq!(different.len(), digests.len());
        // Fixed for good: shards that were written on another machine have the same.
        assert_eq!(digests[0], FIRST);
    }

    /// By an implementation of SipHash-2-4 in another language.
    const FIRST: u64 = 0xa478_f64f_2c30_78f8;
}
