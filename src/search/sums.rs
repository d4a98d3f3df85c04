//! Lists of values with a given sum, where a value may be had in several ways: how many, and which one.

/// Lists of one value for each part, by their sum; value v of part p can be had in `ways[p][v]` ways. Those with one sum are in
/// lexicographic order of the pairs (value, way).
#[derive(Debug, Clone)]
pub(super) struct Sums {
    ways: Vec<Vec<u64>>,
    /// Entry \[p\]\[s\]: the number of lists of the parts from p on with sum s.
    counts: Vec<Vec<u64>>,
}

impl Sums {
    /// For sums up to `largest`. `None` if a number of lists is 2^63 or more.
    pub(super) fn new(ways: Vec<Vec<u64>>, largest: usize) -> Option<Self> {
        let mut counts =
            vec![std::iter::once(1).chain(std::iter::repeat_n(0, largest)).collect::<Vec<u64>>()];
        for ways in ways.iter().rev() {
            let Some(rest) = counts.last() else { break };
            let with = |s: usize| {
                let pairs = ways.iter().zip(rest[..=s].iter().rev());
                let sum = pairs.map(|(ways, rest)| u128::from(*ways) * u128::from(*rest));
                let sum = sum.fold(0, u128::saturating_add);
                u64::try_from(sum).ok().filter(|&sum| sum < 1 << 63)
            };
            let row = (0..=largest).map(with).collect::<Option<_>>()?;
            counts.push(row);
        }
        counts.reverse();
        Some(Self { ways, counts })
    }

    /// How many lists of the parts from one on have the sum.
    pub(super) fn count_from(&self, part: usize, sum: u64) -> u64 {
        let row = self.counts.get(part);
        let count = row.and_then(|row| row.get(usize::try_from(sum).ok()?));
        count.copied().unwrap_or(0)
    }

    /// How many lists have the sum.
    pub(super) fn count(&self, sum: u64) -> u64 {
        self.count_from(0, sum)
    }

    /// The list of the given rank, from 0, among those with the sum: of each part the value, and the way, from 0.
    pub(super) fn at(&self, sum: u64, mut rank: u64) -> Option<Vec<(u64, u64)>> {
        if rank >= self.count(sum) {
            return None;
        }
        let mut left = sum;
        let mut list = Vec::with_capacity(self.ways.len());
        for (part, ways) in self.ways.iter().enumerate() {
            let mut found = None;
            for (value, &ways) in (0..=left).zip(ways) {
                let rest = self.count_from(part + 1, left - value);
                // It is no larger than a number that fits.
                let lists = ways * rest;
                if rank < lists {
                    found = Some((value, rank / rest));
                    rank %= rest;
                    break;
                }
                rank -= lists;
            }
            let (value, way) = found?;
            list.push((value, way));
            left -= value;
        }
        Some(list)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn counts_and_ranks_agree_with_brute_force() {
        let ways = vec![vec![1, 1, 1], vec![2, 0, 3, 1], vec![0, 1, 4, 2, 2]];
        let mut all: Vec<Vec<(u64, u64)>> = vec![vec![]];
        for ways in &ways {
            let longer = |list: &Vec<(u64, u64)>| {
                let list = list.clone();
                let own = (0..).zip(ways).flat_map(|(value, &ways)| (0..ways).map(move |way| (value, way)));
                own.map(move |next| [list.clone(), vec![next]].concat()).collect::<Vec<_>>()
            };
            all = all.iter().flat_map(longer).collect();
        }
        let sums = Sums::new(ways, 9).unwrap();
        for sum in 0..=9 {
            let of = |list: &&Vec<(u64, u64)>| list.iter().map(|(value, _)| value).sum::<u64>() == sum;
            let expected: Vec<_> = all.iter().filter(of).cloned().collect();
            assert_eq!(sums.count(sum), expected.len() as u64, "{sum}");
            let found: Vec<_> = (0..sums.count(sum)).map(|rank| sums.at(sum, rank).unwrap()).collect();
            assert_eq!(found, expected);
            assert_eq!(sums.at(sum, sums.count(sum)), None);
        }
        assert_eq!(sums.count(10), 0);
    }

    #[test]
    fn what_does_not_fit_is_noticed() {
        assert!(Sums::new(vec![vec![1 << 40; 20]; 4], 19).is_none());
        assert!(Sums::new(vec![vec![1; 1001]; 40], 1000).is_none());
    }
}
