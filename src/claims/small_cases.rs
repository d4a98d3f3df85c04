//! The cases of a report: small ones in order of size, and the paper's.

use std::collections::HashSet;
use std::ops::RangeInclusive;

use crate::scalar::{BigRational, integer};
use crate::spline::{Basis, Index, KnotVector};

use super::case::{BasisCase, Origin, WeightCase};
use super::instances::instances;

/// All cases of a run.
#[derive(Debug)]
pub struct Cases {
    /// Bases: small ones by size, then the paper's.
    pub bases: Vec<BasisCase>,
    /// Intervals for the weight: small ones, then the paper's.
    pub weights: Vec<WeightCase>,
}

impl Cases {
    /// The small cases, and every basis of the paper's instances once.
    #[must_use]
    pub fn all() -> Self {
        let mut bases: Vec<_> =
            small_bases().into_iter().map(|basis| BasisCase::new(basis, Origin::Small)).collect();
        let mut seen = HashSet::new();
        for instance in instances() {
            for index in &instance.indices {
                let basis = Basis::new(instance.knots.clone(), instance.degree, index.clone());
                let Ok(basis) = basis else { unreachable!("a test builds every instance") };
                if seen.insert(basis.clone()) {
                    bases.push(BasisCase::new(basis, Origin::Paper));
                }
            }
        }
        Self { bases, weights: weight_cases() }
    }
}

/// Indices by height of the negative one, in conjugate pairs.
const INDICES: [&str; 14] =
    ["-1", "2", "-2", "3", "-1/2", "3/2", "-3", "4", "-1/3", "4/3", "-3/2", "5/2", "-2/3", "5/3"];
/// The classical index, which every knot vector is looked at with.
const CLASSICAL: &str = "inf";
/// Those of Fig. 1 to 3.
const SHOWN: [&str; 7] = ["-1/3", "-1", "-4", "inf", "4/3", "2", "5"];

fn index(text: &str) -> Index {
    match text.parse() {
        Ok(index) => index,
        Err(error) => unreachable!("the indices above lie outside of [0, 1]: {error}"),
    }
}

/// All knot vectors of some sizes with integer gaps.
struct Family {
    degree: usize,
    /// m.
    sizes: RangeInclusive<usize>,
    greatest_gap: usize,
    /// The greatest t_m.
    greatest_length: usize,
    /// How many of [`INDICES`] are taken, from the front; the classical index comes on top.
    indices: usize,
    /// Only vectors that are open: t_0 = … = t_k and t_{m−k} = … = t_m.
    open: bool,
}

/// What is enumerated: everything for the smallest sizes; open vectors, which most claims are about, further; and
/// short vectors of degree 3 with many indices, for the conjecture.
const FAMILIES: [Family; 10] = [
    Family { degree: 1, sizes: 3..=4, greatest_gap: 2, greatest_length: 8, indices: 4, open: false },
    Family { degree: 1, sizes: 5..=5, greatest_gap: 2, greatest_length: 10, indices: 2, open: false },
    Family { degree: 2, sizes: 5..=5, greatest_gap: 2, greatest_length: 10, indices: 4, open: false },
    Family { degree: 2, sizes: 6..=7, greatest_gap: 1, greatest_length: 7, indices: 2, open: false },
    Family { degree: 3, sizes: 7..=7, greatest_gap: 1, greatest_length: 7, indices: 2, open: false },
    Family { degree: 3, sizes: 7..=7, greatest_gap: 2, greatest_length: 4, indices: 14, open: false },
    Family { degree: 3, sizes: 8..=10, greatest_gap: 2, greatest_length: 8, indices: 1, open: true },
    Family { degree: 4, sizes: 9..=12, greatest_gap: 1, greatest_length: 4, indices: 1, open: true },
    Family { degree: 5, sizes: 11..=13, greatest_gap: 1, greatest_length: 3, indices: 1, open: true },
    Family { degree: 6, sizes: 13..=15, greatest_gap: 1, greatest_length: 3, indices: 1, open: true },
];

impl Family {
    /// The vectors of m + 1 knots, from 0, with t_k < t_{m−k} as the paper's statements ask (D3.2).
    fn vectors(&self, m: usize) -> impl Iterator<Item = Vec<usize>> {
        let (k, base) = (self.degree, self.greatest_gap + 1);
        let (fixed, free) = if self.open { (k, m - 2 * k) } else { (0, m) };
        let codes = 0..base.pow(u32::try_from(free).unwrap_or(u32::MAX));
        let vector = move |mut code: usize| {
            let mut knots = vec![0; fixed + 1];
            for _ in 0..free {
                knots.push(knots[knots.len() - 1] + code % base);
                code /= base;
            }
            knots.resize(m + 1, knots[knots.len() - 1]);
            knots
        };
        let longest = self.greatest_length;
        codes.map(vector).filter(move |knots| knots[k] < knots[m - k] && knots[m] <= longest)
    }
}

/// Bases in order of size: by degree, by the number of knots, by length, by knots; then by index.
fn small_bases() -> Vec<Basis> {
    let mut keys = Vec::new();
    for family in &FAMILIES {
        for m in family.sizes.clone() {
            for knots in family.vectors(m) {
                for place in (0..family.indices).chain([INDICES.len()]) {
                    keys.push((family.degree, m, knots[m], knots.clone(), place));
                }
            }
        }
    }
    keys.sort_unstable();
    keys.dedup();
    let basis = |(degree, _, _, knots, place): (usize, usize, usize, Vec<usize>, usize)| {
        let knots = KnotVector::new(knots.into_iter().map(integer).collect());
        let index = index(INDICES.get(place).unwrap_or(&CLASSICAL));
        match knots.map(|knots| Basis::new(knots, degree, index)) {
            Ok(Ok(basis)) => basis,
            _ => unreachable!("the knots rise, and there are enough of them"),
        }
    };
    keys.into_iter().map(basis).collect()
}

/// Intervals of small integers, empty and reversed ones included, with small indices; then those of Fig. 1
/// to 3 with the indices shown there.
fn weight_cases() -> Vec<WeightCase> {
    let small = [(0, 1), (0, 0), (1, 0), (0, 2), (1, 2), (-1, 1), (1, 3)];
    let shown = [(0, 1), (1, 3)];
    let number = |n: i64| BigRational::from_integer(n.into());
    let case = |(a, b), text, origin| WeightCase::new(number(a), number(b), index(text), origin);
    let small = small.into_iter().flat_map(|interval| {
        INDICES[..4].iter().chain([&CLASSICAL]).map(move |text| case(interval, text, Origin::Small))
    });
    let shown = shown
        .into_iter()
        .flat_map(|interval| SHOWN.into_iter().map(move |text| case(interval, text, Origin::Paper)));
    small.chain(shown).collect()
}

/// Does the engine refute the conclusion, under the hypotheses, on the cases of a report? For tests of deliberately
/// false variants of claims.
#[cfg(test)]
pub(super) fn refuted(
    conclusion: impl Fn(&BasisCase, &mut super::verdict::Ledger) -> super::verdict::Judgement
    + Send
    + Sync
    + 'static,
    given: impl IntoIterator<Item = super::hypothesis::Hypothesis>,
) -> bool {
    let statement = super::statement::Statement::new("", conclusion).given(given);
    matches!(
        super::statement::judge(&statement, &Cases::all().bases),
        Ok(super::verdict::Verdict::Refuted(_))
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn small_bases_come_by_size_and_once() {
        let bases = small_bases();
        let distinct: HashSet<_> = bases.iter().collect();
        assert_eq!(distinct.len(), bases.len());
        let sizes: Vec<_> = bases.iter().map(|basis| (basis.degree(), basis.knots().m())).collect();
        assert!(sizes.is_sorted());
        assert!(bases.iter().all(|basis| basis.base_interval().is_some() && basis.n() >= basis.degree()));
        // Every multiplicity up to k + 3 somewhere, and vectors that are not open.
        for k in 1..=2 {
            let of_degree = || bases.iter().filter(|basis| basis.degree() == k).map(Basis::knots);
            for p in 1..=k + 3 {
                assert!(of_degree().any(|knots| knots.stop_knots().any(|(_, q)| q == p)), "k = {k}, p = {p}");
            }
            assert!(of_degree().any(|knots| !knots.is_open(k)));
        }
    }
}
