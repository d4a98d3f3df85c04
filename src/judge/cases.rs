//! The cases that sentences are judged on, in order of size: small ones, then the paper's.

use std::collections::{BTreeMap, HashSet};
use std::ops::RangeInclusive;
use std::sync::Arc;

use crate::language::{Adjective, Binder, Family, Name, Paper, Parameter, Sentence};
use crate::meaning::{
    Example, Instance, MemberError, Values, Weighting, admits, concerns, examples_of, has, listed,
};
use crate::scalar::{BigRational, integer, rational};
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
    /// The family they are of; any with an index, if there is none.
    family: Option<Arc<Family>>,
}

impl Cases {
    /// The small cases, and the paper's instances.
    #[must_use]
    pub fn new(paper: impl IntoIterator<Item = Instance>) -> Self {
        let case = |origin| move |on| Arc::new(Case { on, origin });
        let small = small_instances().into_iter().map(case(Origin::Small)).collect();
        let mut paper: Vec<_> = paper.into_iter().collect();
        let of = |on: &Instance| (on.name.clone(), on.degree(), on.weights.clone());
        let all: Vec<_> = paper.iter().map(of).collect();
        for on in &mut paper {
            let same = all.iter().filter(|(name, degree, _)| *name == on.name && *degree == on.degree());
            on.shown = same.filter_map(|(_, _, weights)| weights.index().cloned()).collect();
        }
        let paper = paper.into_iter().map(case(Origin::Paper)).collect();
        let simple = INDICES[..4].iter().chain([&CLASSICAL]).map(|text| Instance::index(index(text)));
        let indices = simple.map(case(Origin::Small)).collect();
        Self { small, paper, indices, ..Self::none() }
    }

    fn none() -> Self {
        let (small, paper, indices) = (Vec::new(), Vec::new(), Vec::new());
        Self { small, paper, indices, further: BTreeMap::new(), family: None }
    }

    /// Those of a paper: of its family, with its instances, its indices and its further cases.
    ///
    /// # Errors
    /// [`MemberError`], if some member of its family gives no weights.
    pub fn of_paper(paper: &Paper) -> Result<Self, MemberError> {
        let family = &paper.about.family;
        let examples = examples_of(&paper.examples, family);
        let own = Self::new(examples.iter().flat_map(Example::instances));
        let Self { small, mut indices, .. } = Self::of_family(family, &[])?;
        let shown = paper.about.indices.iter().filter_map(|alpha| match alpha {
            Some(alpha) => Index::from_alpha(alpha.clone()).ok(),
            None => Some(Index::infinity()),
        });
        let shown = shown.map(|index| Arc::new(Case { on: Instance::index(index), origin: Origin::Paper }));
        indices.extend(shown.filter(|case| is_of(family, &case.on)));
        let further = paper.cases.iter().map(|(file, rows)| (file.clone(), examples_of(rows, family)));
        let (paper, further) = (own.paper, further.collect());
        Ok(Self { small, paper, indices, further, family: Some(Arc::clone(family)) })
    }

    /// One instance of the user's own, and its index for sentences about weights.
    #[must_use]
    pub fn only(on: Instance) -> Self {
        let alone = Instance::weights(on.weights.clone());
        let [on, index] = [on, alone].map(|on| Arc::new(Case { on, origin: Origin::User }));
        Self { paper: vec![on], indices: vec![index], ..Self::none() }
    }

    /// Only the cases up to this degree.
    #[must_use]
    pub fn up_to(self, degree: usize) -> Self {
        self.in_degrees(&(0..=degree))
    }

    /// Small cases of a family, with parameters by size; those that are given are kept. For Möbius weights, the usual ones.
    ///
    /// # Errors
    /// [`MemberError`], if what is given is none of the family's, or some member gives no weights.
    pub fn of_family(family: &Arc<Family>, given: &[(String, Values)]) -> Result<Self, MemberError> {
        let of = Some(Arc::clone(family));
        if family.moebius().is_some() {
            let Self { mut small, mut indices, .. } = Self::new([]);
            if given.is_empty() {
                small.retain(|case| is_of(family, &case.on));
                indices.retain(|case| is_of(family, &case.on));
            } else if let Weighting::Index(index) = Weighting::of(family, given)? {
                let list = [index];
                (small, indices) = (with_indices(&small, &list), with_indices(&indices, &list));
            }
            return Ok(Self { small, indices, family: of, ..Self::none() });
        }
        let mut all = Vec::new();
        for (degree, knots) in family_knots() {
            if family.knots.iter().any(|adjective| !has(*adjective, &knots, degree)) {
                continue;
            }
            for values in members(family, given, knots.m(), degree) {
                let weights = Weighting::of(family, &values)?;
                let Ok(basis) = Basis::over(knots.clone(), degree, weights) else { continue };
                all.push(Instance::on(basis)?);
            }
        }
        let by_ends =
            || members(family, given, 1, 1).into_iter().map(|values| Weighting::of(family, &values));
        let alone: Vec<_> =
            if family.is_by_ends() { by_ends().collect::<Result<_, _>>()? } else { Vec::new() };
        let case = |on| Arc::new(Case { on, origin: Origin::Small });
        let indices = alone.into_iter().map(Instance::weights).map(case).collect();
        Ok(Self { small: all.into_iter().map(case).collect(), indices, family: of, ..Self::none() })
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
            cases.retain(|case| seen.insert((case.on.degree(), case.on.weights.clone())));
        }
        if let Some(mut list) = listed(sentence) {
            list.retain(|index| self.family.iter().all(|family| family.has_index(index.alpha().as_ref())));
            cases = with_indices(&cases, &list);
        }
        cases.retain(|case| concerns(sentence, &case.on));
        cases
    }
}

/// Is the instance one of a family that has an index?
fn is_of(family: &Family, on: &Instance) -> bool {
    on.weights.index().is_some_and(|index| family.has_index(index.alpha().as_ref()))
}

/// The cases with these indices in place of theirs.
fn with_indices(cases: &[Arc<Case>], list: &[Index]) -> Vec<Arc<Case>> {
    let mut seen: HashSet<(Option<Name>, Option<Basis<()>>)> = HashSet::new();
    let on_knots = |on: &Instance| on.basis.as_ref().map(|basis| basis.with(()));
    let classical = |case: &&Arc<Case>| seen.insert((case.on.name.clone(), on_knots(&case.on)));
    let distinct: Vec<_> = cases.iter().filter(classical).collect();
    let each = |case: &Arc<Case>| {
        let own = list.iter().map(|index| {
            let known = cases.iter().find(|other| {
                let same = || on_knots(&other.on) == on_knots(&case.on);
                other.on.weights.index() == Some(index) && other.on.name == case.on.name && same()
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
struct Sizes {
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
const SIZES: [Sizes; 10] = [
    Sizes { degree: 1, sizes: 3..=4, greatest_gap: 2, greatest_length: 8, indices: 4, open: false },
    Sizes { degree: 1, sizes: 5..=5, greatest_gap: 2, greatest_length: 10, indices: 2, open: false },
    Sizes { degree: 2, sizes: 5..=5, greatest_gap: 2, greatest_length: 10, indices: 4, open: false },
    Sizes { degree: 2, sizes: 6..=7, greatest_gap: 1, greatest_length: 7, indices: 2, open: false },
    Sizes { degree: 3, sizes: 7..=7, greatest_gap: 1, greatest_length: 7, indices: 2, open: false },
    Sizes { degree: 3, sizes: 7..=7, greatest_gap: 2, greatest_length: 4, indices: 14, open: false },
    Sizes { degree: 3, sizes: 8..=10, greatest_gap: 2, greatest_length: 8, indices: 1, open: true },
    Sizes { degree: 4, sizes: 9..=12, greatest_gap: 1, greatest_length: 4, indices: 1, open: true },
    Sizes { degree: 5, sizes: 11..=13, greatest_gap: 1, greatest_length: 3, indices: 1, open: true },
    Sizes { degree: 6, sizes: 13..=15, greatest_gap: 1, greatest_length: 3, indices: 1, open: true },
];

impl Sizes {
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

/// Bases in order of size: by degree, by the number of knots, by length, by knots; then by index. All of them begin at 0, which
/// is no knot of the last few: these are of the same shapes as smaller ones.
fn small_bases() -> Vec<Basis> {
    let mut all = bases_from_zero();
    let moved = |basis: &Basis, origin: BigRational| {
        let knots = basis.knots().knots().iter().map(|t| t + &origin).collect();
        Basis::new(KnotVector::new(knots).ok()?, basis.degree(), basis.index().clone()).ok()
    };
    for degree in 1..=HIGHEST_MOVED {
        let clamped =
            |basis: &&Basis| has(Adjective::Clamped, basis.knots(), degree) && basis.degree() == degree;
        let some: Vec<_> = all.iter().filter(clamped).take(8).cloned().collect();
        for origin in [integer(1), rational(-5, 2)] {
            all.extend(some.iter().filter_map(|basis| moved(basis, origin.clone())));
        }
    }
    all
}

/// The highest degree in which bases are moved away from 0.
const HIGHEST_MOVED: usize = 3;

fn bases_from_zero() -> Vec<Basis> {
    let mut keys = Vec::new();
    for sizes in &SIZES {
        for m in sizes.sizes.clone() {
            for knots in sizes.vectors(m) {
                for place in (0..sizes.indices).chain([INDICES.len()]) {
                    keys.push((sizes.degree, m, knots[m], knots.clone(), place));
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

/// The knots that members of other families are looked at on: fewer, as there are no fast kernels for them.
const FAMILY_SIZES: [Sizes; 6] = [
    Sizes { degree: 1, sizes: 3..=4, greatest_gap: 2, greatest_length: 5, indices: 0, open: false },
    Sizes { degree: 2, sizes: 5..=6, greatest_gap: 1, greatest_length: 6, indices: 0, open: false },
    Sizes { degree: 2, sizes: 5..=7, greatest_gap: 3, greatest_length: 5, indices: 0, open: true },
    Sizes { degree: 3, sizes: 7..=7, greatest_gap: 1, greatest_length: 7, indices: 0, open: false },
    Sizes { degree: 3, sizes: 7..=9, greatest_gap: 3, greatest_length: 6, indices: 0, open: true },
    Sizes { degree: 4, sizes: 9..=11, greatest_gap: 1, greatest_length: 3, indices: 0, open: true },
];

/// Degrees and knots in order of size.
fn family_knots() -> Vec<(usize, KnotVector)> {
    let mut keys = Vec::new();
    for sizes in &FAMILY_SIZES {
        for m in sizes.sizes.clone() {
            keys.extend(sizes.vectors(m).map(|knots| (sizes.degree, m, knots[m], knots)));
        }
    }
    keys.sort_unstable();
    keys.dedup();
    // Again the last few begin elsewhere.
    let open = |(degree, _, _, knots): &&(usize, usize, usize, Vec<usize>)| {
        *degree <= HIGHEST_MOVED
            && knots[0] == knots[*degree]
            && knots[knots.len() - 1 - degree] == knots[knots.len() - 1]
    };
    let moved: Vec<_> = (1..=HIGHEST_MOVED)
        .flat_map(|degree| keys.iter().filter(open).filter(move |key| key.0 == degree).take(2).cloned())
        .collect();
    let knots = |key: (usize, usize, usize, Vec<usize>), origin: BigRational| {
        let knots = KnotVector::new(key.3.into_iter().map(|t| integer(t) + &origin).collect());
        Some((key.0, knots.ok()?))
    };
    let moved = moved.into_iter().filter_map(|key| knots(key, rational(-5, 2)));
    keys.into_iter().filter_map(|key| knots(key, integer(0))).chain(moved).collect()
}

/// Numbers for parameters, simplest first.
const NUMBERS: [(i64, i64); 9] = [(0, 1), (1, 1), (2, 1), (1, 2), (3, 1), (1, 3), (-1, 1), (3, 2), (-2, 1)];

/// The simplest parameters of a family that are not all the same, on knots of these m and k; those that are given are kept.
#[must_use]
pub fn simplest_member(
    family: &Family,
    given: &[(String, Values)],
    m: usize,
    k: usize,
) -> Vec<(String, Values)> {
    let mut all = members(family, given, m, k);
    all.truncate(2);
    all.pop().unwrap_or_default()
}

/// Parameters of a family by size, on knots of these m and k: of each one number after the other, or lists that are constant
/// but for one entry, then lists that are not. What is given is kept.
fn members(family: &Family, given: &[(String, Values)], m: usize, k: usize) -> Vec<Vec<(String, Values)>> {
    /// As many for each.
    const EACH: usize = 4;
    let fixed = |name: &str| given.iter().any(|(other, _)| other == name);
    let read: Vec<&str> = family
        .reads
        .iter()
        .filter(|(other, _)| fixed(other))
        .flat_map(|(_, of)| of.iter().map(|(name, _)| &**name))
        .collect();
    let mut all = vec![(0, given.to_vec())];
    for parameter in &family.parameters {
        if fixed(&parameter.name) || read.contains(&&*parameter.name) {
            continue;
        }
        let numbers: Vec<BigRational> = NUMBERS
            .iter()
            .map(|(p, q)| rational(*p, *q))
            .filter(|q| parameter.admits(q))
            .take(EACH)
            .collect();
        let name = parameter.name.to_string();
        let choices = choices(parameter, &numbers, m, k);
        let longer = |(size, values): &(usize, Vec<(String, Values)>)| {
            let next = |(place, value): (usize, &Values)| {
                (size + place, [values.as_slice(), &[(name.clone(), value.clone())]].concat())
            };
            choices.iter().enumerate().map(next).collect::<Vec<_>>()
        };
        all = all.iter().flat_map(longer).collect();
    }
    all.sort_by_key(|(size, _)| *size);
    all.into_iter().map(|(_, values)| values).collect()
}

fn choices(parameter: &Parameter, numbers: &[BigRational], m: usize, k: usize) -> Vec<Values> {
    let [first, rest @ ..] = numbers else { return Vec::new() };
    let second = rest.first().unwrap_or(first);
    // Longer lists than those of quadratic splines have too many entries to change one by one.
    let one_by_one = k <= 2;
    let rows = |lengths: &[usize]| {
        let made = |number: &dyn Fn(usize, usize) -> BigRational| -> Vec<Vec<BigRational>> {
            lengths.iter().enumerate().map(|(row, n)| (0..*n).map(|i| number(row, i)).collect()).collect()
        };
        let mut all = vec![made(&|_, _| first.clone())];
        for (row, length) in lengths.iter().enumerate().filter(|_| one_by_one) {
            all.extend(
                (0..*length)
                    .map(|at| made(&|r, i| if (r, i) == (row, at) { second.clone() } else { first.clone() })),
            );
        }
        all.push(made(&|row, i| if (row + i) % 2 == 0 { first.clone() } else { second.clone() }));
        // Triangular numbers, 0, 1, 3, 6, …, leave every remainder that there is for 4, and no period below 8.
        all.extend((0..2).map(|step| {
            made(&|row, i| numbers[((2 * row + i) * (2 * row + i + 1) / 2 + step) % numbers.len()].clone())
        }));
        all
    };
    match parameter.indices.as_slice() {
        [] => numbers.iter().cloned().map(Values::One).collect(),
        [of] => {
            let length = if **of == *"d" { k } else { m + 1 };
            rows(&[length]).into_iter().map(|mut rows| Values::List(rows.swap_remove(0))).collect()
        }
        _ => rows(&(1..=k).map(|d| m + 1 - d).collect::<Vec<_>>()).into_iter().map(Values::Rows).collect(),
    }
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
    use num_traits::Signed;

    use super::*;

    #[test]
    fn small_bases_come_by_size_and_once() {
        let bases = small_bases();
        assert!(bases.iter().any(|basis| basis.knots().first().is_negative()));
        let bases = bases_from_zero();
        let distinct: HashSet<_> = bases.iter().collect();
        assert_eq!(distinct.len(), bases.len());
        assert!(bases.iter().map(|basis| (basis.degree(), basis.knots().m())).is_sorted());
    }
}
