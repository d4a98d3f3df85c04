//! The functions of a family in order of size, or at random.

use std::ops::Range;
use std::sync::Arc;

use crate::scalar::BigRational;

use super::members::{MemberFunction, Members};
use super::numbers::{Numbers, spread};
use super::random::Random;
use super::space::{FamilySpace, Limits, MemberSpace, SpaceError};
use super::sums::Sums;

/// The functions of a family that are searched, each at a position.
#[derive(Debug, Clone)]
pub struct MemberCases {
    members: Arc<Members>,
    way: Way,
}

#[derive(Debug, Clone)]
enum Way {
    BySize(BySize),
    Random(Random),
}

/// All functions within limits, in the order of [`MemberFunction`].
///
/// A position is a list of k + 1 gaps and of the free numbers; the sizes follow each other, and those of one size are in
/// lexicographic order. It is a case if the function does not jump for its knots. Nothing is left out for a symmetry: a family need
/// not have any.
#[derive(Debug, Clone)]
struct BySize {
    sums: Sums,
    /// For each free number.
    numbers: Vec<Arc<Numbers>>,
    /// Of each size from 1 the first position.
    starts: Vec<u64>,
    positions: u64,
    cases: u64,
}

impl MemberCases {
    /// Those of a space.
    ///
    /// # Errors
    /// [`SpaceError`]: as [`Members::new`], and if there is no case, or too many.
    pub(super) fn new(degree: usize, space: &FamilySpace) -> Result<Self, SpaceError> {
        let members = Arc::new(Members::new(degree, space)?);
        let way = match &space.cases {
            MemberSpace::Exhaustive(limits) => Way::BySize(BySize::new(&members, limits)?),
            MemberSpace::Random(sample) => Way::Random(Random::new(degree, sample)?),
        };
        Ok(Self { members, way })
    }

    /// What is set and what is free.
    #[must_use]
    pub fn members(&self) -> &Arc<Members> {
        &self.members
    }

    /// The number of positions.
    #[must_use]
    pub fn positions(&self) -> u64 {
        match &self.way {
            Way::BySize(cases) => cases.positions,
            Way::Random(cases) => cases.cases(),
        }
    }

    /// The number of cases.
    #[must_use]
    pub fn cases(&self) -> u64 {
        match &self.way {
            Way::BySize(cases) => cases.cases,
            Way::Random(cases) => cases.cases(),
        }
    }

    /// The cases at positions in a range, with their positions.
    pub fn between(&self, range: Range<u64>) -> impl Iterator<Item = (u64, MemberFunction)> + use<'_> {
        let range = range.start..range.end.min(self.positions());
        range.filter_map(|position| Some((position, self.at(position)?)))
    }

    fn at(&self, position: u64) -> Option<MemberFunction> {
        let (gaps, numbers) = match &self.way {
            Way::BySize(cases) => cases.at(position, self.members.degree() + 1)?,
            Way::Random(random) => self.drawn(random, position)?,
        };
        self.members.function(gaps, numbers)
    }

    /// Case c: from stream c of the seed the gaps, as for an index, and then for each free number a spread and a sign.
    fn drawn(&self, random: &Random, number: u64) -> Option<(Vec<u64>, Vec<BigRational>)> {
        let mut source = random.source(number);
        let gaps = random.gaps(&mut source);
        let numbers = self.members.free().map(|own| {
            let (z, negative) = random.ratio(&mut source);
            spread(own, &z, negative)
        });
        Some((gaps, numbers.collect::<Option<_>>()?))
    }
}

impl BySize {
    fn new(members: &Arc<Members>, limits: &Limits) -> Result<Self, SpaceError> {
        let free = members.free().count();
        // A continuous function has a gap, so its numbers have a smaller height than its size.
        let (largest, bound, tallest) = limits.greatest(free > 0)?;
        let too_many = || SpaceError::TooMany(limits.size);
        let mut numbers: Vec<Arc<Numbers>> = Vec::with_capacity(free);
        let mut before = None;
        for parameter in members.free() {
            let same = numbers.last().filter(|_| before == Some(parameter)).map(Arc::clone);
            numbers.push(same.unwrap_or_else(|| Arc::new(Numbers::new(parameter, tallest))));
            before = Some(parameter);
        }
        let gaps = members.degree() + 1;
        let gap_ways = vec![1; usize::try_from(bound).map_or(largest, |bound| bound.min(largest)) + 1];
        let ways = std::iter::repeat_n(gap_ways, gaps).chain(numbers.iter().map(|numbers| numbers.ways()));
        let sums = Sums::new(ways.collect(), largest).ok_or_else(too_many)?;
        let mut all = Self { sums, numbers, starts: Vec::new(), positions: 0, cases: 0 };
        for size in 1..=limits.size {
            all.starts.push(all.positions);
            let positions = all.positions.checked_add(all.sums.count(size));
            all.positions = positions.filter(|&all| all < 1 << 63).ok_or_else(too_many)?;
            // A function jumps if no gap is more than 0 but the first, or but the last; there are fewer than positions.
            let alone = |gap: u64| all.sums.count_from(gaps, size - gap);
            let jump = alone(0) + 2 * (1..=bound.min(size)).map(alone).sum::<u64>();
            all.cases += all.sums.count(size) - jump;
        }
        if all.cases == 0 { Err(SpaceError::NoMember(limits.size)) } else { Ok(all) }
    }

    fn at(&self, position: u64, gaps: usize) -> Option<(Vec<u64>, Vec<BigRational>)> {
        let size = self.starts.partition_point(|&start| start <= position);
        let start = self.starts.get(size.checked_sub(1)?)?;
        let list = self.sums.at(size as u64, position - start)?;
        let (gaps, costs) = list.split_at_checked(gaps)?;
        let numbers = self.numbers.iter().zip(costs).map(|(numbers, &(cost, way))| numbers.at(cost, way));
        Some((gaps.iter().map(|(gap, _)| *gap).collect(), numbers.collect::<Option<_>>()?))
    }
}
