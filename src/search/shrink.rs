//! Smaller candidates near a candidate, and the descent to one that has none with the same property.

use std::cmp::Reverse;

use num_integer::Integer;

use crate::analysis::is_continuous;
use crate::scalar::{BigRational, height};

use super::candidate::Candidate;
use super::exhaustive::ratios_of_height;
use super::members::MemberFunction;
use super::numbers::stern_brocot_path;

/// All numbers of a function are rounded to those of this height at most.
const TALLEST_OF_ALL: u64 = 4;

/// Goes from a candidate to smaller ones for as long as one of its [`smaller`] neighbours has the property, to the first
/// of them in order each time; the result has no such neighbour. It depends on the candidate and the property only.
///
/// ```
/// use knotproof::search::{Candidate, local_maxima, shrink};
///
/// let found = Candidate::new(vec![7, 2, 2, 0], (1, 2))?.normal_form();
/// assert_eq!(local_maxima(&found).maxima, 2);
/// let smallest = shrink(found, |candidate| local_maxima(candidate).maxima > 1);
/// assert_eq!((smallest.gaps(), smallest.index().to_string()), (&[2, 1, 1, 0][..], "-3/2".to_owned()));
/// # Ok::<(), knotproof::search::CandidateError>(())
/// ```
pub fn shrink(candidate: Candidate, has_property: impl Fn(&Candidate) -> bool) -> Candidate {
    descend(candidate, smaller, has_property)
}

/// The same for a function of a member of another family, with its [`smaller_members`].
pub(super) fn shrink_member(
    function: MemberFunction,
    has_property: impl Fn(&MemberFunction) -> bool,
) -> MemberFunction {
    descend(function, |function| smaller_members(function).into_iter(), has_property)
}

fn descend<T, I: Iterator<Item = T>>(
    mut from: T,
    smaller: impl Fn(&T) -> I,
    has_property: impl Fn(&T) -> bool,
) -> T {
    while let Some(next) = smaller(&from).find(&has_property) {
        from = next;
    }
    from
}

/// The neighbours of a function that are smaller than it, in order: with [`smaller_gaps`], divided by their common divisor or not;
/// with a simpler number in the place of one that is free; or with all of these numbers rounded to simple ones.
fn smaller_members(function: &MemberFunction) -> Vec<MemberFunction> {
    let own = function.gaps().to_vec();
    let lists = smaller_gaps(&own).into_iter().chain([own]);
    let lists = lists.flat_map(|gaps| [coprime(gaps.clone()), Some(gaps)]).flatten();
    let mut all: Vec<_> = lists.filter_map(|gaps| function.with_gaps(gaps)).collect();
    let simpler = function.simpler_numbers();
    for (place, numbers) in simpler.iter().enumerate() {
        all.extend(numbers.iter().filter_map(|number| function.with_number(place, number.clone())));
    }
    for tallest in 1..=TALLEST_OF_ALL {
        let round = |rounded: MemberFunction, (place, numbers): (usize, &Vec<BigRational>)| {
            let near =
                numbers.iter().rev().find(|number| height(number) <= tallest.into()).or(numbers.first());
            near.and_then(|near| rounded.with_number(place, near.clone())).unwrap_or(rounded)
        };
        all.push(simpler.iter().enumerate().fold(function.clone(), round));
    }
    all.retain(|near| near < function);
    all.sort();
    all.dedup();
    all
}

/// The neighbours of a candidate in normal form that are smaller than it in the order of candidates, in that order, and in
/// normal form as well.
///
/// The gaps are the same, or all rounded to a coarser scale, or one of them is made 0, halved, one less, or equal to its
/// neighbour. The index is the same, or one on the Stern–Brocot path to it (its convergents, and some between), or, with other
/// gaps, one of height up to 5 that differs by a factor up to 2.
pub fn smaller(candidate: &Candidate) -> impl Iterator<Item = Candidate> + use<> {
    let simpler = simpler_ratios(candidate.ratio());
    let mut near = simple_ratios_near(candidate.ratio());
    near.extend(&simpler);
    near.push(candidate.ratio());
    near.sort_unstable();
    near.dedup();
    let mut lists: Vec<Vec<u64>> = smaller_gaps(candidate.gaps()).into_iter().filter_map(coprime).collect();
    lists.push(candidate.gaps().to_vec());
    lists.sort_unstable();
    lists.dedup();
    // Pairs are many, and few of them are tried: they are sorted by numbers, and made candidates one by one.
    let rank = |list: usize, (p, q): (u64, u64)| {
        let height = p.max(p.abs_diff(q));
        // Of one height, p/q rises with p, and for the same p as q falls.
        (lists[list].iter().sum::<u64>() + height, height, list, p, Reverse(q))
    };
    let with = |list: usize| if lists[list] == candidate.gaps() { &simpler } else { &near };
    let pairs = (0..lists.len()).flat_map(|list| with(list).iter().map(move |&ratio| (list, ratio)));
    let mut pairs: Vec<_> = pairs.map(|(list, ratio)| rank(list, ratio)).collect();
    pairs.retain(|&(size, height, ..)| (size, height) <= (candidate.size(), candidate.height()));
    pairs.sort_unstable();
    let candidate = candidate.clone();
    let built = pairs.into_iter().filter_map(move |(_, _, list, p, Reverse(q))| {
        // For α = ∞ the gaps may have to be reversed.
        Some(Candidate::new(lists.get(list)?.clone(), (p, q)).ok()?.normal_form())
    });
    built.filter(move |new| *new < candidate)
}

/// The list divided by its greatest common divisor; `None` if the function would jump.
fn coprime(mut gaps: Vec<u64>) -> Option<Vec<u64>> {
    let common = gaps.iter().fold(0, |common: u64, gap| common.gcd(gap)).max(1);
    gaps.iter_mut().for_each(|gap| *gap /= common);
    is_continuous(&gaps).then_some(gaps)
}

/// Lists with smaller gaps.
pub(super) fn smaller_gaps(gaps: &[u64]) -> Vec<Vec<u64>> {
    let largest = gaps.iter().copied().max().unwrap_or(0);
    let mut lists = Vec::new();
    for scale in scales().take_while(|&scale| scale < largest) {
        let rounded = |gap: u64| {
            let product = 2 * u128::from(gap) * u128::from(scale) + u128::from(largest);
            u64::try_from(product / (2 * u128::from(largest))).unwrap_or(gap)
        };
        lists.push(gaps.iter().map(|&gap| rounded(gap)).collect());
        // The same without new empty spans.
        lists.push(gaps.iter().map(|&gap| rounded(gap).max(gap.min(1))).collect());
    }
    for (place, &gap) in gaps.iter().enumerate().filter(|(_, gap)| **gap > 0) {
        let neighbours = [place.checked_sub(1), Some(place + 1)].into_iter().flatten();
        let neighbours = neighbours.filter_map(|place| gaps.get(place).copied());
        for value in [0, gap / 2, gap - 1].into_iter().chain(neighbours).filter(|&value| value < gap) {
            let mut list = gaps.to_vec();
            list[place] = value;
            lists.push(list);
        }
    }
    lists
}

/// 1, 2, …, 12, 16, 24, 32, 48, …: few, and none far from the next.
fn scales() -> impl Iterator<Item = u64> {
    (1..=12).chain((4..62).flat_map(|bits| [1 << bits, 3 << (bits - 1)]))
}

/// Ratios p/q < 1 on the Stern–Brocot path from 0/1, 1/0 to a/b, where α = −a/b and p/q = a/(a + b).
fn simpler_ratios((p, q): (u64, u64)) -> Vec<(u64, u64)> {
    // For α = ∞ nothing is simpler.
    stern_brocot_path(p, q - p.min(q)).into_iter().map(|(c, d)| (c, c + d)).collect()
}

/// The ratios of all α < 0 of height up to 5 that differ from the given one by a factor up to 2.
fn simple_ratios_near((p, q): (u64, u64)) -> Vec<(u64, u64)> {
    let (a, b) = (u128::from(p), u128::from(q - p.min(q)));
    let near = |(c, sum): &(u64, u64)| {
        let (c, d) = (u128::from(*c), u128::from(sum - c));
        d > 0 && a * d <= 2 * b * c && b * c <= 2 * a * d
    };
    (1..=5).flat_map(ratios_of_height).filter(near).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::search::local_maxima;

    #[test]
    fn neighbours_are_smaller_and_normal() {
        for (gaps, ratio) in
            [(&[2003, 1000, 999, 0][..], (3001, 5000)), (&[2, 1, 1, 0], (3, 5)), (&[1, 1], (1, 1))]
        {
            let candidate = Candidate::new(gaps.to_vec(), ratio).unwrap();
            let list: Vec<_> = smaller(&candidate).collect();
            assert!(!list.is_empty() || candidate.size() < 4);
            assert!(list.iter().all(|c| c.is_normal() && *c < candidate && c.degree() == candidate.degree()));
            assert!(list.windows(2).all(|pair| pair[0] < pair[1]));
        }
    }

    #[test]
    fn the_path_to_a_ratio_holds_the_simplest_fractions_near_it() {
        // α = −22/7 (r = 22/29): 1/1, 2/1, 3/1, then 4/1 (the first step back), 7/2, 10/3, 16/5, 22/7, and r = c/(c + d).
        let path: Vec<_> = simpler_ratios((22, 29)).iter().map(|(c, sum)| (*c, sum - c)).collect();
        assert_eq!(path, [(1, 1), (2, 1), (3, 1), (4, 1), (7, 2), (10, 3), (19, 6), (22, 7)]);
        assert!(simpler_ratios((1, 1)).is_empty());
    }

    #[test]
    fn the_result_has_the_property_and_no_smaller_neighbour_has_it() {
        let several = |candidate: &Candidate| local_maxima(candidate).maxima > 1;
        let found = Candidate::new(vec![7, 2, 2, 0], (1, 2)).unwrap();
        assert!(several(&found));
        let smallest = shrink(found, several);
        assert!(several(&smallest) && !smaller(&smallest).any(|candidate| several(&candidate)));
        assert_eq!(shrink(smallest.clone(), several), smallest);
    }
}
