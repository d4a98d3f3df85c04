//! Lists of whole numbers with a given sum: how many, which one, and the next.

/// The lists of `parts` numbers from 0 to `bound`, by their sum, in lexicographic order.
///
/// ```
/// use knotproof::search::Compositions;
///
/// let pairs = Compositions::new(2, 3, 5).unwrap();
/// assert_eq!(pairs.count(4), 3);
/// let lists: Vec<_> = (0..3).map(|rank| pairs.at(4, rank).unwrap()).collect();
/// assert_eq!(lists, [[1, 3], [2, 2], [3, 1]]);
/// ```
#[derive(Debug, Clone)]
pub struct Compositions {
    bound: u64,
    /// Entry \[p\]\[s\]: the number of lists of p numbers with sum s.
    counts: Vec<Vec<u64>>,
}

impl Compositions {
    /// Lists of `parts` numbers up to `bound`, for sums up to `largest`. `None` if a number of lists is 2^64 or more.
    #[must_use]
    pub fn new(parts: usize, bound: u64, largest: usize) -> Option<Self> {
        let mut counts =
            vec![std::iter::once(1).chain(std::iter::repeat_n(0, largest)).collect::<Vec<u64>>()];
        let width = usize::try_from(bound).unwrap_or(usize::MAX).min(largest);
        for p in 0..parts {
            // count(p + 1, s) = Σ count(p, s − v) over 0 ≤ v ≤ bound: a sum over a window.
            let mut window: u64 = 0;
            let mut row = Vec::with_capacity(largest + 1);
            for s in 0..=largest {
                window = window.checked_add(counts[p][s])?;
                if let Some(gone) = s.checked_sub(width + 1) {
                    window -= counts[p][gone];
                }
                row.push(window);
            }
            counts.push(row);
        }
        Some(Self { bound, counts })
    }

    /// How many lists have the sum; none if it is above the largest one.
    #[must_use]
    pub fn count(&self, sum: u64) -> u64 {
        self.count_of(self.counts.len() - 1, sum)
    }

    fn count_of(&self, parts: usize, sum: u64) -> u64 {
        usize::try_from(sum).ok().and_then(|sum| self.counts[parts].get(sum)).copied().unwrap_or(0)
    }

    /// The list of the given rank, from 0, among those with the sum.
    #[must_use]
    pub fn at(&self, sum: u64, mut rank: u64) -> Option<Vec<u64>> {
        if rank >= self.count(sum) {
            return None;
        }
        let mut left = sum;
        let mut list = Vec::with_capacity(self.counts.len() - 1);
        for parts in (0..self.counts.len() - 1).rev() {
            let mut value = 0;
            loop {
                let count = self.count_of(parts, left - value);
                if rank < count {
                    break;
                }
                rank -= count;
                value += 1;
            }
            list.push(value);
            left -= value;
        }
        Some(list)
    }

    /// Goes on to the next list with the same sum; `false`, and no change, after the last one.
    pub fn advance(&self, list: &mut [u64]) -> bool {
        // The last place that can grow at the expense of those behind it.
        let mut behind = 0;
        for place in (0..list.len()).rev() {
            if behind > 0 && list[place] < self.bound {
                list[place] += 1;
                // The rest as small as it gets in lexicographic order: filled up from the right.
                let mut left = behind - 1;
                for value in list[place + 1..].iter_mut().rev() {
                    *value = left.min(self.bound);
                    left -= *value;
                }
                return true;
            }
            behind += list[place];
        }
        false
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// By brute force: all lists, sorted.
    fn all(parts: usize, bound: u64, sum: u64) -> Vec<Vec<u64>> {
        let mut lists = vec![vec![]];
        for _ in 0..parts {
            let longer = |list: &Vec<u64>| {
                let list = list.clone();
                (0..=bound).map(move |value| [list.clone(), vec![value]].concat())
            };
            lists = lists.iter().flat_map(longer).collect();
        }
        lists.retain(|list| list.iter().sum::<u64>() == sum);
        lists
    }

    #[test]
    fn counts_ranks_and_steps_agree_with_brute_force() {
        for parts in 1..=4 {
            for bound in [1, 2, 3, 9] {
                let compositions = Compositions::new(parts, bound, 7).unwrap();
                for sum in 0..=7 {
                    let expected = all(parts, bound, sum);
                    assert_eq!(compositions.count(sum), expected.len() as u64);
                    let mut stepped = compositions.at(sum, 0);
                    for (rank, list) in (0..).zip(&expected) {
                        assert_eq!(compositions.at(sum, rank).as_ref(), Some(list));
                        assert_eq!(stepped.as_ref(), Some(list));
                        stepped = stepped
                            .filter(|_| true)
                            .and_then(|mut list| compositions.advance(&mut list).then_some(list));
                    }
                    assert_eq!(stepped, None);
                    assert_eq!(compositions.at(sum, expected.len() as u64), None);
                }
                assert_eq!(compositions.count(8), 0);
            }
        }
    }

    #[test]
    fn what_does_not_fit_is_noticed() {
        assert!(Compositions::new(60, 1000, 1000).is_none());
    }
}
