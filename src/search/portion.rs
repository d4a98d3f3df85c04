//! How far a search, or a shard of it, has come, and what it has found.

use std::ops::Range;
use std::time::{Duration, Instant};

use rayon::prelude::*;

use super::block::{Block, Blocks};
use super::decide::Decided;
use super::enumeration::Enumeration;
use super::finding::{Bar, Finding, Findings};
use super::shard::{Shard, ShardError};
use super::space::{Search, SpaceError};
use super::subject::Subject;
use super::undecided::{Undecided, UndecidedRecord};

/// A shard of a search, or the whole of it, up to some position.
///
/// It is worked off in units of positions, in parallel, and put together in their order. What comes out depends on
/// the search and the shard only: not on threads, nor on how often the work was interrupted.
#[derive(Debug, Clone)]
pub struct Portion {
    pub(super) search: Search,
    pub(super) shard: Shard,
    pub(super) cases: Enumeration,
    pub(super) range: Range<u64>,
    /// The positions from the start of the range up to this one are done.
    pub(super) done: u64,
    pub(super) decided: Decided,
    pub(super) blocks: Blocks,
    pub(super) findings: Findings,
    pub(super) undecided: Undecided,
}

/// The most positions between two looks at what has been done, and the units of work into which they are cut.
const BATCH: u64 = 4096;
const UNITS: u64 = 64;
/// How long a batch should take: where cases are slow it is made shorter, down to one case for each thread.
const PAUSE: Duration = Duration::from_millis(200);

/// Why a search cannot begin.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum PortionError {
    /// There is nothing to search, or too much.
    #[error(transparent)]
    Space(#[from] SpaceError),
    /// The shard does not fit to it.
    #[error(transparent)]
    Shard(#[from] ShardError),
}

impl Portion {
    /// A shard of the search, with nothing done.
    ///
    /// # Errors
    /// [`PortionError`], if the search is empty or too large, or the shard is empty.
    pub fn new(search: Search, shard: Shard) -> Result<Self, PortionError> {
        let cases = Enumeration::of(&search)?;
        let range = shard.range(cases.positions())?;
        Ok(Self::of_range(search, shard, cases, range))
    }

    /// Any positions of a search, with nothing done.
    pub(super) fn of_range(search: Search, shard: Shard, cases: Enumeration, range: Range<u64>) -> Self {
        let (done, blocks) = (range.start, Blocks::new(cases.positions()));
        Self {
            search,
            shard,
            cases,
            range,
            done,
            decided: Decided::default(),
            blocks,
            findings: Findings::default(),
            undecided: Undecided::default(),
        }
    }

    /// What is searched.
    #[must_use]
    pub fn search(&self) -> &Search {
        &self.search
    }

    /// Which part of it.
    #[must_use]
    pub fn shard(&self) -> Shard {
        self.shard
    }

    /// All cases of the search.
    #[must_use]
    pub fn cases(&self) -> &Enumeration {
        &self.cases
    }

    /// The positions of the part.
    #[must_use]
    pub fn range(&self) -> Range<u64> {
        self.range.clone()
    }

    /// How many positions of the part are done.
    #[must_use]
    pub fn done(&self) -> u64 {
        self.done - self.range.start
    }

    /// Is there nothing left to do?
    #[must_use]
    pub fn is_complete(&self) -> bool {
        self.done == self.range.end
    }

    /// The numbers of cases so far.
    #[must_use]
    pub fn decided(&self) -> Decided {
        self.decided
    }

    /// The findings so far.
    #[must_use]
    pub fn findings(&self) -> &Findings {
        &self.findings
    }

    /// The first cases that are not decided, with the reasons.
    pub fn undecided(&self) -> impl Iterator<Item = &UndecidedRecord> {
        self.undecided.records()
    }

    /// Works on from where it is, and looks in after every few thousand positions, or sooner where they are slow.
    ///
    /// # Errors
    /// What the look-in returns, which stops the work; the part can be continued.
    ///
    /// ```
    /// use knotproof::search::{Goal, Limits, Portion, Search, Shard, Space};
    ///
    /// let space = Space::Exhaustive(Limits { size: 7, gap: None, height: None });
    /// let search = Search { degree: 3, find: Goal::Several, space };
    /// let mut part = Portion::new(search, Shard::WHOLE)?;
    /// part.run(|_| Ok::<(), knotproof::search::PortionError>(()))?;
    /// assert!(part.is_complete());
    /// assert_eq!(part.decided().cases(), part.cases().count());
    /// # Ok::<(), knotproof::search::PortionError>(())
    /// ```
    pub fn run<E>(&mut self, mut look_in: impl FnMut(&Self) -> Result<(), E>) -> Result<(), E> {
        let threads = rayon::current_num_threads() as u64;
        let mut batch = threads;
        while !self.is_complete() {
            let begun = Instant::now();
            let end = self.range.end.min(self.done.saturating_add(batch));
            let bar = self.findings.bar(self.search.find);
            let pieces = self.blocks.pieces(self.done..end, batch / UNITS);
            let units: Vec<Unit> = pieces.into_par_iter().map(|range| self.unit(range, &bar)).collect();
            for unit in units {
                self.decided.add(unit.block.decided);
                self.blocks.add(unit.number, unit.block);
                for (position, finding) in &unit.findings {
                    self.findings.add(finding, *position);
                }
                self.undecided.merge(unit.undecided);
            }
            self.findings.keep(self.search.find);
            self.done = end;
            look_in(self)?;
            // How far a batch goes has no influence on what comes out.
            batch = match begun.elapsed() {
                short if short < PAUSE / 2 => (batch * 2).min(BATCH.max(threads)),
                long if long > PAUSE * 2 => (batch / 2).max(threads),
                _ => batch,
            };
        }
        Ok(())
    }

    fn unit(&self, range: Range<u64>, bar: &Bar) -> Unit {
        let mut unit = Unit {
            number: self.blocks.number(range.start),
            block: Block::default(),
            findings: Vec::new(),
            undecided: Undecided::default(),
        };
        for (position, subject) in self.cases.subjects(range) {
            let count = subject.local_maxima();
            unit.block.count(position, &subject, count.as_ref().ok().copied());
            match (count, &subject) {
                (Ok(count), _) if count.maxima > 1 => {
                    let finding = Finding::from_case(self.search.find, &subject, count.maxima, bar);
                    unit.findings.extend(finding.map(|finding| (position, finding)));
                }
                (Err(why), Subject::Member(function)) => {
                    unit.undecided.add(UndecidedRecord::new(position, function, why));
                }
                _ => {}
            }
        }
        unit
    }
}

/// What came of some positions of a block.
#[derive(Debug)]
struct Unit {
    number: u64,
    block: Block,
    findings: Vec<(u64, Finding)>,
    undecided: Undecided,
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::search::{DEEPEST_KEPT, Dip, Goal, Sample, Space};

    #[test]
    fn the_last_position_of_all_is_searched() {
        let space = Space::Random(Sample { count: u64::MAX, seed: 0, spread: 9 });
        let shard: Shard = format!("{}/{}", u64::MAX - 1, u64::MAX).parse().unwrap();
        let mut part = Portion::new(Search { degree: 1, find: Goal::Several, space }, shard).unwrap();
        part.run(|_| Ok::<(), ()>(())).unwrap();
        assert_eq!((part.range(), part.decided().cases()), (u64::MAX - 1..u64::MAX, 1));
    }

    /// Against all dips of all cases, in order.
    #[test]
    fn the_deepest_are_the_deepest_of_all() {
        let space = Space::Random(Sample { count: 4000, seed: 1, spread: 9 });
        let search = Search { degree: 3, find: Goal::Deepest, space };
        let mut part = Portion::new(search, Shard::WHOLE).unwrap();
        part.run(|_| Ok::<(), ()>(())).unwrap();
        let cases = part.cases.between(0..part.cases.positions());
        let mut dips: Vec<_> = cases.filter_map(|(_, case)| Some((Dip::of(&case)?, case))).collect();
        dips.sort_by(|(one, first), (other, second)| other.lo.cmp(&one.lo).then_with(|| first.cmp(second)));
        assert!(dips.len() > DEEPEST_KEPT);
        let expected = dips.iter().take(DEEPEST_KEPT).map(|(_, case)| case);
        assert!(part.findings.iter().filter_map(|finding| finding.subject().candidate()).eq(expected));
    }
}
