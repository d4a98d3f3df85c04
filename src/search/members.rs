//! Functions of a family on their own knots: which of its numbers are free, and what shape the function has.

use std::cmp::Ordering;
use std::collections::BTreeMap;
use std::fmt;
use std::sync::Arc;

use crate::analysis::{Shape, Sign, function_quotients, is_continuous, sign_pattern};
use crate::judge::OfFamily;
use crate::language::{Family, Parameter};
use crate::meaning::{Instance, Values, Weighting};
use crate::scalar::{BigInt, BigRational, Ring, height, parse_rational};
use crate::spline::{Basis, FormTable, KnotVector, Obligation};

use super::candidate::FullKnots;
use super::decide::{Count, Means};
use super::numbers::{simpler, simplest, simplicity};
use super::space::{FamilySpace, SpaceError};

/// The members of a family, as far as a function G_i^k on its own knots t_i, …, t_{i+k+1} goes: which numbers are set, and which
/// ones are free.
///
/// Of a parameter by i the k + 2 numbers of these knots count, of one by d those for d = 1, …, k, and of one by i and d the
/// k + 2 − d numbers of the intervals [t_j, t_{j+d}] between these knots, for each d. On the full knot vector of the
/// function all others are the simplest number that the parameter may be; most weights do not depend on them.
#[derive(Debug)]
pub struct Members {
    family: Arc<Family>,
    degree: usize,
    /// For each parameter.
    own: Vec<OwnNumbers>,
    /// For each free number, which parameter it is of.
    free: Vec<usize>,
}

/// A parameter on a function's own knots.
#[derive(Debug)]
struct OwnNumbers {
    simplest: BigRational,
    /// As in [`Values`], with one row for one number, and for a list; `None` for what is free.
    rows: Vec<Vec<Option<BigRational>>>,
}

/// The function G_i^k of a member of a family, by the gaps between its own knots and the numbers that are free.
///
/// The **size** is the sum of the gaps and of max(|p|, q) − 1 over all free numbers p/q. Functions are ordered by size, then by gaps, then
/// by numbers, simpler ones first.
#[derive(Debug, Clone)]
pub struct MemberFunction {
    of: Arc<Members>,
    gaps: Vec<u64>,
    numbers: Vec<BigRational>,
}

impl Members {
    /// What is free, if some parameters are set.
    ///
    /// # Errors
    /// [`SpaceError`]: a file that can't be read; a family that has an index, or that is for special knots; settings that
    /// are none of the family, or not as many numbers as the functions have.
    pub(super) fn new(degree: usize, space: &FamilySpace) -> Result<Self, SpaceError> {
        let family = Family::read(&space.name, &space.text).map_err(|complaints| {
            let first = complaints.first().map(ToString::to_string);
            SpaceError::Family(first.unwrap_or_default())
        })?;
        if family.moebius().is_some() {
            return Err(SpaceError::OfIndex(family.name));
        }
        if let Some(adjective) = family.knots.first() {
            return Err(SpaceError::SpecialKnots { family: family.name, knots: adjective.name() });
        }
        let family = Arc::new(family);
        let given = given(&family, space)?;
        let read = |name: &str| {
            let read = family.reads.iter().find(|(other, _)| **other == *name);
            read.into_iter().flat_map(|(_, of)| of.iter().map(|(own, _)| &**own))
        };
        let set: Vec<&str> = given.iter().flat_map(|(name, _)| read(name).chain([name.as_str()])).collect();
        let simplest = |own: &Parameter| {
            let none = || SpaceError::NoNumber { head: own.head(), says: own.says.clone() };
            simplest(own).ok_or_else(none)
        };
        let simplest = family.parameters.iter().map(simplest).collect::<Result<Vec<_>, _>>()?;
        // What is set, read by the family itself; the others only have to be something.
        let others = family.parameters.iter().zip(&simplest).filter(|(own, _)| !set.contains(&&*own.name));
        let others = others.map(|(own, simplest)| {
            let rows = layout(own, degree).into_iter().map(|length| vec![simplest.clone(); length]);
            (own.name.to_string(), values(own, rows.collect()))
        });
        let all: Vec<_> = given.iter().cloned().chain(others).collect();
        let member = Weighting::of(&family, &all)?;
        let numbers: BTreeMap<_, _> = member.member().into_iter().flat_map(|member| member.named()).collect();
        let mut own = Vec::new();
        let mut free = Vec::new();
        for (place, (parameter, simplest)) in family.parameters.iter().zip(simplest).enumerate() {
            let lengths = layout(parameter, degree);
            if !set.contains(&&*parameter.name) {
                free.extend(std::iter::repeat_n(place, lengths.iter().sum()));
                let rows = lengths.iter().map(|&length| vec![None; length]).collect();
                own.push(OwnNumbers { simplest, rows });
                continue;
            }
            let rows = numbers.get(&parameter.name).map(|values| rows(values)).unwrap_or_default();
            if !rows.iter().map(Vec::len).eq(lengths.iter().copied()) {
                let needs = lengths.iter().map(ToString::to_string).collect::<Vec<_>>().join("; ");
                return Err(SpaceError::Numbers { head: parameter.head(), needs });
            }
            let rows = rows.into_iter().map(|row| row.into_iter().map(Some).collect()).collect();
            own.push(OwnNumbers { simplest, rows });
        }
        Ok(Self { family, degree, own, free })
    }

    /// The family.
    #[must_use]
    pub fn family(&self) -> &Arc<Family> {
        &self.family
    }

    /// k.
    #[must_use]
    pub fn degree(&self) -> usize {
        self.degree
    }

    /// Of each free number the parameter that it is of, in order: those of one parameter by rising d, then by rising i.
    pub fn free(&self) -> impl Iterator<Item = &Parameter> {
        self.free.iter().filter_map(|&place| self.family.parameters.get(place))
    }

    /// The function with these gaps and these free numbers; `None` if there are not as many, the function jumps for its knots,
    /// or a parameter may not be such a number.
    #[must_use]
    pub fn function(self: &Arc<Self>, gaps: Vec<u64>, numbers: Vec<BigRational>) -> Option<MemberFunction> {
        let sum = gaps.iter().try_fold(0_u64, |sum, &gap| sum.checked_add(gap));
        let fits = gaps.len() == self.degree + 1 && sum.is_some_and(|sum| sum < 1 << 63);
        let admitted = || self.free().zip(&numbers).all(|(own, number)| own.admits(number));
        let fits = fits && is_continuous(&gaps) && numbers.len() == self.free.len() && admitted();
        fits.then(|| MemberFunction { of: Arc::clone(self), gaps, numbers })
    }

    /// The same from the parameters on the full knots, as [`MemberFunction::of_family`] has them.
    pub(super) fn read(self: &Arc<Self>, gaps: Vec<u64>, given: &OfFamily) -> Option<MemberFunction> {
        if gaps.len() != self.degree + 1 {
            return None;
        }
        let index = FullKnots::of(&gaps).index;
        let mut numbers = Vec::new();
        for (parameter, own) in self.family.parameters.iter().zip(&self.own) {
            let text = given.parameters.get(&*parameter.name)?;
            let rows: Vec<Vec<&str>> = text.split(';').map(|row| row.split(',').collect()).collect();
            let shift = if by_knot(parameter) { index } else { 0 };
            for (row, own) in own.rows.iter().enumerate() {
                for (at, _) in own.iter().enumerate().filter(|(_, set)| set.is_none()) {
                    numbers.push(parse_rational(rows.get(row)?.get(at + shift)?).ok()?);
                }
            }
        }
        self.function(gaps, numbers)
    }

    /// All numbers on the full knots t_0, …, t_{2k+1} of the function with an index.
    fn values(&self, numbers: &[BigRational], index: usize) -> Vec<(String, Values)> {
        let mut free = numbers.iter();
        let mut all = Vec::new();
        for (parameter, own) in self.family.parameters.iter().zip(&self.own) {
            let mut rows = Vec::new();
            for row in &own.rows {
                let mut number = |set: &Option<BigRational>| {
                    set.as_ref().or_else(|| free.next()).unwrap_or(&own.simplest).clone()
                };
                let row: Vec<_> = row.iter().map(&mut number).collect();
                if by_knot(parameter) {
                    // Of k + 2 knots the vector has 2k + 2.
                    let (before, after) = (index, self.degree.saturating_sub(index));
                    let other = |n| std::iter::repeat_n(own.simplest.clone(), n);
                    rows.push(other(before).chain(row).chain(other(after)).collect());
                } else {
                    rows.push(row);
                }
            }
            all.push((parameter.name.to_string(), values(parameter, rows)));
        }
        all
    }
}

/// Is a number of the parameter one of a knot?
fn by_knot(parameter: &Parameter) -> bool {
    parameter.indices.iter().any(|of| **of == *"i")
}

/// How many numbers of a parameter there are on the k + 2 knots of a function, row by row.
fn layout(parameter: &Parameter, k: usize) -> Vec<usize> {
    match parameter.indices.as_slice() {
        [] => vec![1],
        [of] if **of == *"d" => vec![k],
        [_] => vec![k + 2],
        _ => (1..=k).map(|d| k + 2 - d).collect(),
    }
}

/// Rows of numbers as the parameter has them.
fn values(parameter: &Parameter, mut rows: Vec<Vec<BigRational>>) -> Values {
    match (parameter.indices.len(), rows.pop()) {
        (0, Some(mut row)) if row.len() == 1 => Values::One(row.swap_remove(0)),
        (0 | 1, Some(row)) => Values::List(row),
        (_, last) => {
            rows.extend(last);
            Values::Rows(rows)
        }
    }
}

/// And back.
fn rows(values: &Values) -> Vec<Vec<BigRational>> {
    match values {
        Values::One(value) => vec![vec![value.clone()]],
        Values::List(list) => vec![list.clone()],
        Values::Rows(rows) => rows.clone(),
    }
}

/// What is set, as numbers.
fn given(family: &Family, space: &FamilySpace) -> Result<Vec<(String, Values)>, SpaceError> {
    let read = |(name, text): (&String, &String)| {
        let row = |row: &str| row.split(',').map(parse_rational).collect::<Result<Vec<_>, _>>();
        let rows = text.split(';').map(row).collect::<Result<Vec<_>, _>>();
        let rows =
            rows.map_err(|error| SpaceError::Setting { name: name.clone(), why: error.to_string() })?;
        Ok((name.clone(), Values::shaped(rows, family, name)))
    };
    space.set.iter().map(read).collect()
}

impl MemberFunction {
    /// The gaps between the own knots of the function.
    #[must_use]
    pub fn gaps(&self) -> &[u64] {
        &self.gaps
    }

    /// The numbers that are free, in the order of [`Members::free`].
    #[must_use]
    pub fn numbers(&self) -> &[BigRational] {
        &self.numbers
    }

    /// The sum of the gaps and of max(|p|, q) − 1 over all free numbers p/q.
    #[must_use]
    pub fn size(&self) -> BigInt {
        let gaps: BigInt = self.gaps.iter().map(|&gap| BigInt::from(gap)).sum();
        let heights: BigInt = self.numbers.iter().map(|number| height(number) - 1).sum();
        gaps + heights
    }

    /// The full knot vector on which it is G_i^k.
    #[must_use]
    pub fn full_knots(&self) -> FullKnots {
        FullKnots::of(&self.gaps)
    }

    /// The family, and its parameters on the full knot vector.
    #[must_use]
    pub fn of_family(&self) -> OfFamily {
        let values = self.of.values(&self.numbers, self.full_knots().index);
        let parameters = values.into_iter().map(|(name, values)| (name, values.to_string())).collect();
        OfFamily { name: self.of.family.given.clone(), parameters }
    }

    /// With other gaps; `None` if the function would jump.
    pub(super) fn with_gaps(&self, gaps: Vec<u64>) -> Option<Self> {
        self.of.function(gaps, self.numbers.clone())
    }

    /// With another number for one that is free.
    pub(super) fn with_number(&self, place: usize, number: BigRational) -> Option<Self> {
        let mut numbers = self.numbers.clone();
        *numbers.get_mut(place)? = number;
        self.of.function(self.gaps.clone(), numbers)
    }

    /// Of each free number those that are simpler, simplest first.
    pub(super) fn simpler_numbers(&self) -> Vec<Vec<BigRational>> {
        self.of.free().zip(&self.numbers).map(|(own, number)| simpler(own, number)).collect()
    }

    fn basis(&self, weights: &Weighting) -> Result<Basis<FormTable>, String> {
        let knots = KnotVector::new(self.full_knots().rational()).map_err(|error| error.to_string())?;
        let table = weights.table(&knots, self.of.degree).map_err(|error| error.to_string())?;
        Basis::over(knots, self.of.degree, table).map_err(|error| error.to_string())
    }

    fn weights(&self) -> Result<Weighting, String> {
        let values = self.of.values(&self.numbers, self.full_knots().index);
        Weighting::of(&self.of.family, &values).map_err(|error| error.to_string())
    }

    /// How many local maxima the function has, exactly.
    ///
    /// # Errors
    /// Why that is not decided: there are no weights, the function is negative somewhere, or it jumps.
    pub fn local_maxima(&self) -> Result<Count, String> {
        let maxima = self.shape()?.local_maxima().count();
        if maxima > 1 {
            self.by_definition()?;
        }
        Ok(Count { maxima, by: Means::Exact })
    }

    /// Its shape, from the pieces that its weights give.
    pub(super) fn shape(&self) -> Result<Shape, String> {
        let (basis, i) = (self.basis(&self.weights()?)?, self.full_knots().index);
        if let Some(((_, j, d), fault)) = own_fault(&basis, i) {
            let negative = function_quotients(&basis, i).iter().any(|(_, g)| {
                // The sign of P/Q is that of PQ.
                let product = g.numerator.times(&g.denominator).map(|c| c.clone().into());
                !product.is_zero()
                    && sign_pattern(&product).between().iter().any(|(_, sign)| *sign == Sign::Negative)
            });
            if negative {
                return Err(format!("the function is negative somewhere: of w[{j},{d}] {fault}"));
            }
        }
        let shape = Shape::of_function(&basis, i);
        match shape.jumps().first() {
            Some(jump) => Err(format!("the function jumps at {}", jump.at)),
            None => Ok(shape),
        }
    }

    /// What is to be shown is computed once more, word for word from the terms of the family.
    fn by_definition(&self) -> Result<(), String> {
        let weights = self.weights()?;
        let basis = self.basis(&weights)?.with(weights.clone());
        let on = Instance::on(basis).map_err(|error| error.to_string())?;
        _ = on.pieces(&weights, self.of.degree);
        match on.fault() {
            Some(fault) => Err(format!("two computations disagree, which is a bug of this program: {fault}")),
            None => Ok(()),
        }
    }
}

/// The first condition that fails of those that make G_i^k ≥ 0: of a weight on an interval between its own knots.
fn own_fault(basis: &Basis<FormTable>, i: usize) -> Option<((usize, usize, usize), Obligation)> {
    let last = i + basis.degree() + 1;
    let own = basis.weights().iter().filter(|((_, from, d), _)| i <= *from && from + d <= last);
    own.filter_map(|(place, forms)| Some((place, forms.obligations().err()?))).next()
}

impl PartialEq for MemberFunction {
    fn eq(&self, other: &Self) -> bool {
        self.gaps == other.gaps && self.numbers == other.numbers
    }
}

impl Eq for MemberFunction {}

impl Ord for MemberFunction {
    fn cmp(&self, other: &Self) -> Ordering {
        let numbers = |of: &Self| of.numbers.iter().map(simplicity).collect::<Vec<_>>();
        let first = self.size().cmp(&other.size()).then_with(|| self.gaps.cmp(&other.gaps));
        first.then_with(|| numbers(self).cmp(&numbers(other)))
    }
}

impl PartialOrd for MemberFunction {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

/// `lupas, q = 1/2`.
impl fmt::Display for MemberFunction {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let OfFamily { name, parameters } = self.of_family();
        f.write_str(&name)?;
        parameters.iter().try_for_each(|(name, values)| write!(f, ", {name} = {values}"))
    }
}
