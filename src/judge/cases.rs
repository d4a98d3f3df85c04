//! The cases that sentences are judged on, in order of size: small ones, then the paper's.

use std::collections::{BTreeMap, HashSet};
use std::ops::RangeInclusive;
use std::sync::Arc;

use crate::language::{Binder, Family, Name, Paper, Sentence};
use crate::meaning::{Example, Instance, admits, concerns, examples_of, listed};
use crate::scalar::integer;
use crate::spline::{Basis, Index, KnotVector};

use super::verdict::Origin;

/// An instance, and where it comes from.
#[derive(Debug)]
pub struct Case {
    /// What is read on.
    pub on: Instance,
    /// Where it comes from.
    pub origin: Origin,
}

/// All cases of a run. What is computed for a case is kept for all sentences.
#[derive(Debug)]
pub struct Cases {
    /// Small bases by size.
    small: Vec<Arc<Case>>,
    /// The paper's instances, one for each index.
    paper: Vec<Arc<Case>>,
    /// Indices alone: small ones, then the paper's.
    indices: Vec<Arc<Case>>,
    /// Further cases of the paper, by the file that claims name.
    further: BTreeMap<String, Vec<Example>>,
    /// What indices there are.
    family: Family,
}

impl Cases {
    /// The small cases, and the paper's instances.
    #[must_use]
    pub fn new(paper: impl IntoIterator<Item = Instance>) -> Self {
        let case = |origin| move |on| Arc::new(Case { on, origin });
        let small = small_instances().into_iter().map(case(Origin::Small)).collect();
        let mut paper: Vec<_> = paper.into_iter().collect();
        let of = |on: &Instance| (on.name.clone(), on.degree(), on.index.clone());
        let all: Vec<_> = paper.iter().map(of).collect();
        for on in &mut paper {
            let same = all.iter().filter(|(name, degree, _)| *name == on.name && *degree == on.degree());
            on.shown = same.map(|(_, _, index)| index.clone()).collect();
        }
        let paper = paper.into_iter().map(case(Origin::Paper)).collect();
        let simple = INDICES[..4].iter().chain([&CLASSICAL]).map(|text| Instance::index(index(text)));
        let indices = simple.map(case(Origin::Small)).collect();
        Self { small, paper, indices, further: BTreeMap::new(), family: Family::default() }
    }

    /// Those of a paper: of its family, with its instances, its indices and its further cases.
    #[must_use]
    pub fn of_paper(paper: &Paper) -> Self {
        let examples = examples_of(&paper.examples);
        let mut cases = Self::new(examples.iter().flat_map(Example::instances));
        let shown = paper.about.indices.iter().filter_map(|alpha| match alpha {
            Some(alpha) => Index::from_alpha(alpha.clone()).ok(),
            None => Some(Index::infinity()),
        });
        let shown = shown.map(|index| Arc::new(Case { on: Instance::index(index), origin: Origin::Paper }));
        cases.indices.extend(shown);
        cases.further = paper.cases.iter().map(|(file, rows)| (file.clone(), examples_of(rows))).collect();
        cases.family = paper.about.family;
        let family = cases.family;
        let of_family = |case: &Arc<Case>| family.has(case.on.index.alpha().as_ref());
        for list in [&mut cases.small, &mut cases.paper, &mut cases.indices] {
            list.retain(of_family);
        }
        cases
    }

    /// One instance of the user's own, and its index for sentences about weights.
    #[must_use]
    pub fn only(on: Instance) -> Self {
        let index = on.index.clone();
        let [on, index] = [on, Instance::index(index)].map(|on| Arc::new(Case { on, origin: Origin::User }));
        let (small, further) = (Vec::new(), BTreeMap::new());
        Self { small, paper: vec![on], indices: vec![index], further, family: Family::default() }
    }

    /// Only the cases up to this degree.
    #[must_use]
    pub fn up_to(self, degree: usize) -> Self {
        self.in_degrees(&(0..=degree))
    }

    /// Only the cases of these degrees.
    #[must_use]
    pub fn in_degrees(mut self, degrees: &RangeInclusive<usize>) -> Self {
        let wanted = |case: &Arc<Case>| case.on.degree().is_none_or(|k| degrees.contains(&k));
        self.small.retain(wanted);
        self.paper.retain(wanted);
        self.further.values_mut().for_each(|rows| rows.retain(|row| degrees.contains(&row.degree)));
        self
    }

    /// Those that the binders of a sentence speak of, and then the further cases of a file of the paper.
    #[must_use]
    pub fn of(&self, sentence: &Sentence, further: Option<&str>) -> Vec<Arc<Case>> {
        let mut cases = self.usual(sentence);
        if let Some(rows) = further.and_then(|file| self.further.get(file)) {
            let more = rows.iter().flat_map(Example::instances);
            let more = more.map(|on| Arc::new(Case { on, origin: Origin::Small }));
            cases.extend(more.filter(|case| concerns(sentence, &case.on)));
        }
        cases
    }

    /// What a sentence is said of, where that is not the user's own case.
    #[must_use]
    pub fn foreign<'a>(&self, sentence: &'a Sentence) -> Option<&'a Binder> {
        let on = &self.paper.first().filter(|case| case.origin == Origin::User)?.on;
        let own = |binder: &&Binder| matches!(binder, Binder::Indices(_)) || admits(binder, on);
        sentence.given.iter().find(|binder| !own(binder))
    }

    fn usual(&self, sentence: &Sentence) -> Vec<Arc<Case>> {
        let binders = &sentence.given;
        let named = binders.iter().any(|binder| matches!(binder, Binder::Instances(_)));
        let knots = binders.iter().any(|binder| matches!(binder, Binder::Degree { .. } | Binder::Knots(_)));
        let own_knots = binders.iter().any(|binder| matches!(binder, Binder::Gaps(_)));
        let mut cases: Vec<_> = if named {
            self.paper.clone()
        } else if knots {
            // An instance with two names is one basis.
            let mut seen = HashSet::new();
            self.small
                .iter()
                .chain(&self.paper)
                .filter(|case| seen.insert(case.on.basis.clone()))
                .cloned()
                .collect()
        } else {
            self.indices.clone()
        };
        if own_knots {
            // Of a case that brings no knots a degree and an index are left.
            let mut seen = HashSet::new();
            cases.retain(|case| seen.insert((case.on.degree(), case.on.index.clone())));
        }
        if let Some(mut list) = listed(sentence) {
            list.retain(|index| self.family.has(index.alpha().as_ref()));
            cases = with_indices(&cases, &list);
        }
        cases.retain(|case| concerns(sentence, &case.on));
        cases
    }
}

/// The cases with these indices in place of theirs.
fn with_indices(cases: &[Arc<Case>], list: &[Index]) -> Vec<Arc<Case>> {
    let mut seen: HashSet<(Option<Name>, Option<Basis>)> = HashSet::new();
    let classical = |case: &&Arc<Case>| {
        seen.insert((
            case.on.name.clone(),
            case.on.basis.as_ref().map(|basis| basis.with_index(Index::infinity())),
        ))
    };
    let distinct: Vec<_> = cases.iter().filter(classical).collect();
    let each = |case: &Arc<Case>| {
        let own = list.iter().map(|index| {
            let known = cases.iter().find(|other| {
                let same =
                    || other.on.basis == case.on.basis.as_ref().map(|basis| basis.with_index(index.clone()));
                other.on.index == *index && other.on.name == case.on.name && same()
            });
            let made = || Arc::new(Case { on: case.on.with_index(index.clone()), origin: case.origin });
            known.cloned().unwrap_or_else(made)
        });
        own.collect::<Vec<_>>()
    };
    distinct.into_iter().flat_map(each).collect()
}

/// Indices by height of the negative one, in conjugate pairs.
const INDICES: [&str; 14] =
    ["-1", "2", "-2", "3", "-1/2", "3/2", "-3", "4", "-1/3", "4/3", "-3/2", "5/2", "-2/3", "5/3"];
/// The classical index, which every knot vector is looked at with.
const CLASSICAL: &str = "inf";

fn index(text: &str) -> Index {
    match text.parse() {
        Ok(index) => index,
        Err(error) => unreachable!("the indices above lie outside of [0, 1]: {error}"),
    }
}

/// All knot vectors of some sizes with integer gaps.
struct Enumerated {
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
const FAMILIES: [Enumerated; 10] = [
    Enumerated { degree: 1, sizes: 3..=4, greatest_gap: 2, greatest_length: 8, indices: 4, open: false },
    Enumerated { degree: 1, sizes: 5..=5, greatest_gap: 2, greatest_length: 10, indices: 2, open: false },
    Enumerated { degree: 2, sizes: 5..=5, greatest_gap: 2, greatest_length: 10, indices: 4, open: false },
    Enumerated { degree: 2, sizes: 6..=7, greatest_gap: 1, greatest_length: 7, indices: 2, open: false },
    Enumerated { degree: 3, sizes: 7..=7, greatest_gap: 1, greatest_length: 7, indices: 2, open: false },
    Enumerated { degree: 3, sizes: 7..=7, greatest_gap: 2, greatest_length: 4, indices: 14, open: false },
    Enumerated { degree: 3, sizes: 8..=10, greatest_gap: 2, greatest_length: 8, indices: 1, open: true },
    Enumerated { degree: 4, sizes: 9..=12, greatest_gap: 1, greatest_length: 4, indices: 1, open: true },
    Enumerated { degree: 5, sizes: 11..=13, greatest_gap: 1, greatest_length: 3, indices: 1, open: true },
    Enumerated { degree: 6, sizes: 13..=15, greatest_gap: 1, greatest_length: 3, indices: 1, open: true },
];

impl Enumerated {
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

/// With what is computed on knots shared by their indices.
fn small_instances() -> Vec<Instance> {
    let mut all: Vec<Instance> = Vec::new();
    for basis in small_bases() {
        let same = all
            .last()
            .filter(|last| last.knots() == Some(basis.knots()) && last.degree() == Some(basis.degree()));
        let on = same.map(|last| last.with_index(basis.index().clone()));
        all.push(on.unwrap_or_else(|| Instance::of(basis)));
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn small_bases_come_by_size_and_once() {
        let bases = small_bases();
        let distinct: HashSet<_> = bases.iter().collect();
        assert_eq!(distinct.len(), bases.len());
        assert!(bases.iter().map(|basis| (basis.degree(), basis.knots().m())).is_sorted());
    }
}
