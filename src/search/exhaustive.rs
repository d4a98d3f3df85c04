//! All normal forms of a degree, in order of size, with a rank for each.

use std::ops::Range;

use num_integer::Integer;

use crate::analysis::is_continuous;

use super::candidate::{Candidate, is_above_its_reverse};
use super::compositions::Compositions;
use super::space::{Limits, SpaceError};

/// The normal forms of one degree within limits, in the order of [`Candidate`].
///
/// They are found among **positions**: for each size, each height of α, each list of gaps with the sum that is left,
/// and each α < 0 of that height (and ∞, of height 1), one position. A position is a case if its gaps are coprime, the
/// function is continuous and, for α = ∞, the gaps are not above their reverse. How many cases there are is known
/// beforehand, by Möbius inversion over the common divisors of the gaps.
#[derive(Debug, Clone)]
pub struct Exhaustive {
    compositions: Compositions,
    /// Entry h − 1: the ratios (p, q) of height h, by rising p/q.
    ratios: Vec<Vec<(u64, u64)>>,
    blocks: Vec<Block>,
    positions: u64,
    cases: u64,
}

/// The positions of one size and one height.
#[derive(Debug, Clone, Copy)]
struct Block {
    /// Its first position.
    start: u64,
    /// The sum of the gaps.
    sum: u64,
    height: u64,
}

impl Exhaustive {
    /// Counts everything, and enumerates nothing yet.
    ///
    /// # Errors
    /// [`SpaceError`], if there is no case, or too many.
    pub(super) fn new(degree: usize, limits: &Limits) -> Result<Self, SpaceError> {
        let (largest, bound, tallest) = limits.greatest(true)?;
        let too_many = || SpaceError::TooMany(limits.size);
        let compositions = Compositions::new(degree + 1, bound, largest).ok_or_else(too_many)?;
        let mut space = Self {
            compositions,
            ratios: (1..=tallest).map(ratios_of_height).collect(),
            blocks: Vec::new(),
            positions: 0,
            cases: 0,
        };
        let normal = NormalGaps::new(degree + 1, bound, largest).ok_or_else(too_many)?;
        for size in 1..=limits.size {
            for (height, ratios) in (1..size).zip(&space.ratios) {
                let sum = size - height;
                let block = Block { start: space.positions, sum, height };
                let ratios = ratios.len() as u64;
                let add = |total: u64, lists: u64, ratios: u64| {
                    lists.checked_mul(ratios).and_then(|more| total.checked_add(more))
                };
                let positions = add(space.positions, space.compositions.count(sum), ratios);
                space.positions = positions.filter(|&all| all < 1 << 63).ok_or_else(too_many)?;
                if space.positions > block.start {
                    space.blocks.push(block);
                }
                // There are no more cases than positions.
                let infinite = u64::from(height == 1);
                space.cases += normal.all(sum) * (ratios - infinite) + normal.up_to_reversal(sum) * infinite;
            }
        }
        if space.cases == 0 { Err(SpaceError::Empty(limits.size)) } else { Ok(space) }
    }

    /// The number of positions.
    #[must_use]
    pub fn positions(&self) -> u64 {
        self.positions
    }

    /// The number of cases.
    #[must_use]
    pub fn cases(&self) -> u64 {
        self.cases
    }

    /// The cases at positions in a range, with their positions.
    pub fn between(&self, range: Range<u64>) -> impl Iterator<Item = (u64, Candidate)> + use<'_> {
        let end = range.end.min(self.positions);
        let mut position = range.start;
        let mut block = self.blocks.partition_point(|block| block.start <= position).saturating_sub(1);
        let mut row = None;
        std::iter::from_fn(move || {
            while position < end {
                if self.blocks.get(block + 1).is_some_and(|next| next.start <= position) {
                    (block, row) = (block + 1, None);
                }
                let Block { start, sum, height } = *self.blocks.get(block)?;
                let ratios = &self.ratios[usize::try_from(height).ok()? - 1];
                let width = ratios.len() as u64;
                let rank = (position - start) / width;
                let gaps = match row.take() {
                    None => Row::new(rank, self.compositions.at(sum, rank)?),
                    Some(Row { rank: before, gaps, .. }) if before != rank => {
                        let mut gaps: Vec<u64> = gaps;
                        self.compositions.advance(&mut gaps);
                        Row::new(rank, gaps)
                    }
                    Some(same) => same,
                };
                let gaps = row.insert(gaps);
                if !gaps.normal {
                    position = (start + (rank + 1) * width).min(end);
                    continue;
                }
                let ratio = ratios[usize::try_from((position - start) % width).ok()?];
                position += 1;
                if ratio != (1, 1) || !is_above_its_reverse(&gaps.gaps) {
                    return Some((position - 1, Candidate::assumed(gaps.gaps.clone(), ratio)));
                }
            }
            None
        })
    }
}

/// A list of gaps, with its rank, and whether it is that of a normal form.
struct Row {
    rank: u64,
    gaps: Vec<u64>,
    normal: bool,
}

impl Row {
    fn new(rank: u64, gaps: Vec<u64>) -> Self {
        let normal = is_continuous(&gaps) && gaps.iter().fold(0, |common: u64, gap| common.gcd(gap)) == 1;
        Self { rank, gaps, normal }
    }
}

/// (p, q) with p/q < 1 for all α = −p/(q − p) of the height, by rising p/q; for height 1 also (1, 1), that is ∞.
pub(super) fn ratios_of_height(height: u64) -> Vec<(u64, u64)> {
    // α = −a/b with max(a, b) = h: r = a/(a + b), which rises with a/b.
    let below = (1..height).map(|a| (a, height));
    let above = (1..height).rev().map(|b| (height, b));
    let one = (height == 1).then_some((1, 1));
    let fractions = below.chain(above).chain(one).filter(|(a, b)| a.gcd(b) == 1);
    let mut ratios: Vec<_> = fractions.map(|(a, b)| (a, a + b)).collect();
    ratios.extend((height == 1).then_some((1, 1)));
    ratios
}

/// How many lists of gaps are those of normal forms.
struct NormalGaps {
    all: Vec<u64>,
    palindromes: Vec<u64>,
}

impl NormalGaps {
    /// For sums up to `largest`; `None` if the numbers do not fit.
    fn new(parts: usize, bound: u64, largest: usize) -> Option<Self> {
        let mut all = vec![0_i128; largest + 1];
        let mut palindromes = vec![0_i128; largest + 1];
        // Coprime lists of sum s: Σ_{d | s} μ(d)·(lists of sum s/d, up to bound/d).
        for d in (1..=largest).filter(|&d| moebius(d) != 0) {
            let bound = bound / d as u64;
            let lists = Compositions::new(parts, bound, largest / d)?;
            let halves = Compositions::new(parts / 2, bound, largest / d)?;
            for s in 1..=largest / d {
                let sum = s as u64;
                let mirrored = |middle: u64| halves.count((sum - middle) / 2);
                let symmetric = if parts.is_multiple_of(2) {
                    if sum.is_multiple_of(2) { mirrored(0) } else { 0 }
                } else {
                    (0..=sum.min(bound)).filter(|middle| (sum - middle).is_multiple_of(2)).map(mirrored).sum()
                };
                for (total, count) in [(&mut all, lists.count(sum)), (&mut palindromes, symmetric)] {
                    // Partial sums may be negative.
                    let count = i128::from(count) * i128::from(moebius(d));
                    total[s * d] += count;
                }
            }
        }
        // Those that jump: coprime and all in the first place, or all in the last. Only for the sum 1.
        if let Some(ones) = all.get_mut(1).filter(|ones| **ones > 0) {
            *ones -= 2;
        }
        let fit = |counts: Vec<i128>| -> Option<Vec<u64>> {
            counts.into_iter().map(|count| u64::try_from(count).ok()).collect()
        };
        Some(Self { all: fit(all)?, palindromes: fit(palindromes)? })
    }

    fn all(&self, sum: u64) -> u64 {
        usize::try_from(sum).ok().and_then(|sum| self.all.get(sum)).copied().unwrap_or(0)
    }

    fn up_to_reversal(&self, sum: u64) -> u64 {
        let palindromes = usize::try_from(sum).ok().and_then(|sum| self.palindromes.get(sum));
        (self.all(sum) + palindromes.copied().unwrap_or(0)) / 2
    }
}

/// μ(n): 0 if a square divides n, else (−1) to the number of its prime factors.
fn moebius(mut n: usize) -> i8 {
    let mut sign = 1;
    let mut prime = 2;
    while prime * prime <= n {
        if n.is_multiple_of(prime) {
            n /= prime;
            if n.is_multiple_of(prime) {
                return 0;
            }
            sign = -sign;
        }
        prime += 1;
    }
    if n > 1 { -sign } else { sign }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// By the definition: all candidates with such gaps and heights that are their own normal form.
    fn normal_forms(degree: usize, limits: &Limits) -> Vec<Candidate> {
        let bound = limits.gap.unwrap_or(limits.size);
        let mut lists = vec![vec![]];
        for _ in 0..=degree {
            let longer = |list: &Vec<u64>| {
                let list = list.clone();
                (0..=bound).map(move |gap| [list.clone(), vec![gap]].concat())
            };
            lists =
                lists.iter().flat_map(longer).filter(|list| list.iter().sum::<u64>() < limits.size).collect();
        }
        let mut found = Vec::new();
        for q in 1..=2 * limits.size {
            for p in (1..=q).filter(|p| p.gcd(&q) == 1) {
                found.extend(lists.iter().filter_map(|gaps| Candidate::new(gaps.clone(), (p, q)).ok()));
            }
        }
        let tallest = limits.height.unwrap_or(limits.size);
        found.retain(|c| c.is_normal() && c.size() <= limits.size && c.height() <= tallest);
        found.sort();
        found
    }

    #[test]
    fn counts_order_and_ranks_are_those_of_the_definition() {
        for degree in 1..=4 {
            for limits in [
                Limits { size: 7, gap: None, height: None },
                Limits { size: 8, gap: Some(2), height: None },
                Limits { size: 8, gap: Some(3), height: Some(2) },
                Limits { size: 6, gap: None, height: Some(1) },
            ] {
                let expected = normal_forms(degree, &limits);
                let space = Exhaustive::new(degree, &limits).unwrap();
                let listed: Vec<_> = space.between(0..u64::MAX).collect();
                assert_eq!(space.cases(), expected.len() as u64, "{degree} {limits:?}");
                assert!(listed.iter().map(|(_, candidate)| candidate).eq(&expected), "{degree} {limits:?}");
                // From any position on, the same ones with the same positions.
                for cut in (0..=space.positions()).step_by(7) {
                    let parts = space.between(0..cut).chain(space.between(cut..space.positions()));
                    assert!(parts.eq(listed.iter().cloned()));
                }
            }
        }
    }

    #[test]
    fn limits_that_leave_nothing_or_too_much() {
        let new = |degree, size, gap, height| Exhaustive::new(degree, &Limits { size, gap, height });
        assert_eq!(new(1, 2, None, None).unwrap_err(), SpaceError::Empty(2));
        assert_eq!(new(1, 3, None, None).unwrap().cases(), 2);
        assert_eq!(new(2, 1, None, None).unwrap_err(), SpaceError::Empty(1));
        assert_eq!(new(2, 2, None, None).unwrap().cases(), 2);
        assert_eq!(new(3, 9, Some(0), None).unwrap_err(), SpaceError::NoGap);
        assert_eq!(new(3, 9, None, Some(0)).unwrap_err(), SpaceError::NoHeight);
        assert_eq!(new(3, 0, None, None).unwrap_err(), SpaceError::Empty(0));
        assert_eq!(new(3, 1001, None, None).unwrap_err(), SpaceError::TooLarge(1001));
        assert_eq!(new(16, 1000, None, None).unwrap_err(), SpaceError::TooMany(1000));
    }

    #[test]
    fn the_first_values_of_moebius() {
        assert_eq!((1..=12).map(moebius).collect::<Vec<_>>(), [1, -1, -1, 0, -1, 1, -1, 0, 0, 1, -1, 0]);
    }
}
