//! Conjecture 3.1: every basis function has one and only one maximum.

use crate::analysis::{Crossing, Flank, Location, Shape};
use crate::scalar::{BigRational, integer};
use crate::search::{self, Candidate, Goal, Limits, Search, Space, local_maxima};
use crate::spline::{Basis, KnotVector, Side};

use super::basis::name;
use super::case::{BasisCase, Origin};
use super::cause::Cause;
use super::claim::{Claim, Form};
use super::hypothesis::Hypothesis::{DegreeAtLeast, DegreeAtMost};
use super::statement::Statement;
use super::verdict::{Judgement, Ledger, Stop};

/// The two readings of "one and only one maximum".
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Reading {
    /// Exactly one local maximum (an interval of constancy counts once).
    Strong,
    /// The largest value exists and is taken at exactly one x.
    Weak,
}

/// The conjecture for one function; `wanted` local maxima in the strong reading, 1 in the claim.
fn one_maximum(
    case: &BasisCase,
    i: usize,
    reading: Reading,
    wanted: usize,
    ledger: &mut Ledger,
) -> Judgement {
    let shape = Shape::of(case.pieces(), i);
    let g = name(case.k(), i);
    let at = [("i", i.to_string())];
    let places = || {
        let maxima: Vec<_> = shape.local_maxima().map(|maximum| place(&maximum.place)).collect();
        let mut found = vec![match maxima.as_slice() {
            [] => format!("{g} has no local maximum"),
            [one] => format!("its only local maximum is at {one}"),
            several => format!("it has {} local maxima: at {}", several.len(), several.join(" and at ")),
        }];
        found.extend(shape.local_minima().filter(|_| maxima.len() > 1).filter_map(|minimum| {
            // At a knot the slopes show the minimum, and so the maxima on either side, to whoever computes them.
            let Location::Point(x) = &minimum.place else { return None };
            let slope = |side| case.basis().jets(x, side, 1)[i].coefficients()[1].clone();
            let (left, right) = (slope(Side::Left), slope(Side::Right));
            Some(format!("between them it has a minimum at x = {x}, where its slope is {left} on the left and {right} on the right"))
        }));
        found.extend(
            shape.jumps().iter().map(|jump| {
                format!("at {} it jumps from the limit {} to {}", jump.at, jump.left, jump.right)
            }),
        );
        found.join("; ")
    };
    match reading {
        Reading::Strong if ledger.count(shape.local_maxima().count(), wanted) => Ok(()),
        Reading::Strong => Err(case.refuted(at, format!("{g} has exactly one local maximum"), places())),
        Reading::Weak => match shape.weak() {
            // Two maxima of different height may be equal for an index close by.
            Some(true) if shape.local_maxima().count() > 1 && ledger.count(1, wanted) => {
                equal_close_by(case, i).map_or(Ok(()), Err)
            }
            Some(once) if ledger.count(usize::from(once), wanted) => Ok(()),
            Some(_) => {
                let claimed = format!("{g} takes its largest value at exactly one x");
                Err(case.refuted(at, claimed, places()))
            }
            None => Err(Stop::Undecided(format!("two local maxima of {g} lie too close to be told apart"))),
        },
    }
}

/// The largest value taken twice, for some index of an interval that begins or ends close to that of the case: by the
/// intermediate value theorem, since the side on which it is taken changes from one end of it to the other.
fn equal_close_by(case: &BasisCase, i: usize) -> Option<Stop> {
    let crossing =
        Candidate::of(case.basis(), i).and_then(|found| Crossing::near(found.gaps(), found.ratio()))?;
    let g = name(case.k(), i);
    // The candidate has its own unit, and begins at 0.
    let (start, end) = case.basis().support(i);
    let length: u64 = crossing.gaps().iter().sum();
    let unit = (end - start) / BigRational::from_integer(length.into());
    let [c, d] = crossing.points().clone().map(|x| start + x * &unit);
    let [from, to] = crossing.indices();
    let [(first, low), (second, high)] = crossing.at_ends();
    let at = [
        ("i", i.to_string()),
        ("α from", from.to_string()),
        ("α to", to.to_string()),
        ("c", c.to_string()),
        ("d", d.to_string()),
        ("side at the first α", side(first).to_owned()),
        ("value at the first α", low.to_string()),
        ("side at the second α", side(second).to_owned()),
        ("value at the second α", high.to_string()),
    ];
    let claimed = format!("for every α between, {g} takes its largest value at exactly one x");
    let found = format!(
        "for some of them it takes it at two, one on either side of c: for α = {from} it exceeds {low} on the {} of c only, for α = {to} it exceeds {high} on the {} of c only, and for all of them it is larger at d than at c",
        side(first),
        side(second),
    );
    Some(Stop::Refuted(Box::new(case.bare_witness(at, claimed, found))))
}

fn side(side: Flank) -> &'static str {
    match side {
        Flank::Left => "left",
        Flank::Right => "right",
    }
}

/// For each degree from 3 to 8 the first functions with two local maxima, in the order of the search, on full knot vectors.
pub(super) fn searched() -> Vec<BasisCase> {
    (3..=8).flat_map(|degree| first_with_two_maxima(degree, full)).collect()
}

/// The same on open knot vectors, mirrored with the conjugate index where that puts the smaller knots first.
pub(super) fn searched_on_open_knots() -> Vec<BasisCase> {
    (3..=8).flat_map(|degree| first_with_two_maxima(degree, open)).collect()
}

fn full(candidate: &Candidate) -> Option<Basis> {
    let knots = KnotVector::new(candidate.full_knots().rational()).ok()?;
    Basis::new(knots, candidate.degree(), candidate.index()).ok()
}

/// The first and the last knot of the function are repeated up to multiplicity k + 1.
fn open(candidate: &Candidate) -> Option<Basis> {
    let (own, copies) = (candidate.own_knots(), candidate.degree() + 1);
    let (first, last) = (own[0], own[own.len() - 1]);
    let inside: Vec<_> = own.into_iter().filter(|t| *t != first && *t != last).collect();
    let mirrored: Vec<_> = inside.iter().rev().map(|t| first + last - t).collect();
    let (inside, index) = if mirrored < inside {
        (mirrored, candidate.index().conjugate())
    } else {
        (inside, candidate.index())
    };
    let knots = std::iter::repeat_n(first, copies).chain(inside).chain(std::iter::repeat_n(last, copies));
    let knots = KnotVector::new(knots.map(|t| BigRational::from_integer(t.into())).collect()).ok()?;
    Basis::new(knots, candidate.degree(), index).ok()
}

fn first_with_two_maxima(degree: usize, basis: fn(&Candidate) -> Option<Basis>) -> Vec<BasisCase> {
    /// Sum of the gaps and height of α: enough for every degree from 3 to 8.
    const SIZE: u64 = 9;
    /// For one of so many the maxima are equal for an index close by.
    const TRIES: usize = 3;
    let space = Space::Exhaustive(Limits { size: SIZE, gap: None, height: None });
    let Ok(cases) = search::Enumeration::of(&Search { degree, find: Goal::Several, space }) else {
        return Vec::new();
    };
    let candidates = cases.between(0..cases.positions()).map(|(_, candidate)| candidate);
    let several = candidates.filter(|candidate| local_maxima(candidate).maxima > 1).take(TRIES);
    several
        .filter_map(|candidate| basis(&candidate))
        .map(|basis| BasisCase::new(basis, Origin::Small))
        .collect()
}

fn place(place: &Location) -> String {
    match place {
        Location::Point(x) => format!("x = {x}"),
        Location::Irrational { lo, hi, .. } => format!("an irrational x in ({lo}, {hi})"),
        Location::Plateau { from, to, closed } => format!("[{from}, {to}{}", if *closed { "]" } else { ")" }),
    }
}

/// Which functions are left out, besides those that are 0 everywhere.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Except {
    /// None.
    Nothing,
    /// Those that drop at a knot inside (t_0, t_m): t_{i+1} = t_{i+k+1} < t_m.
    Drops,
    /// Those that jump, up or down, at a knot inside (t_0, t_m): also t_0 < t_i = t_{i+k}.
    Jumps,
}

impl Except {
    pub(super) fn leaves_out(self, case: &BasisCase, i: usize) -> bool {
        let (knots, k) = (case.knots(), case.k());
        let drops = knots.t(i + 1) == knots.t(i + k + 1) && knots.t(i + 1) < knots.last();
        let starts = knots.first() < knots.t(i) && knots.t(i) == knots.t(i + k);
        match self {
            Self::Nothing => false,
            Self::Drops => drops,
            Self::Jumps => drops || starts,
        }
    }
}

/// Is G_i^k 0 everywhere, t_i = t_{i+k+1}? Then it is not meant, and a remark says so.
pub(super) fn nowhere(case: &BasisCase, i: usize, ledger: &mut Ledger) -> bool {
    let (low, high) = case.basis().support(i);
    if low == high {
        let (g, end) = (name(case.k(), i), i + case.k() + 1);
        ledger.remark(format!("{g} is not meant: it is 0 everywhere, since t_{i} = t_{end} = {low}."));
    }
    low == high
}

/// G_i^k, which ends with a drop inside (t_0, t_m), rises to the limit 1 there and has no local maximum.
fn rises_and_drops(case: &BasisCase, i: usize, ledger: &mut Ledger) -> Judgement {
    let high = case.basis().support(i).1;
    let value = |side| case.values(high, side)[i].clone();
    let (limit, value) = (value(Side::Left), value(Side::Right));
    let maxima = Shape::of(case.pieces(), i).local_maxima().count();
    if ledger.equal(&limit, &integer(1)) && ledger.equal(&value, &integer(0)) && ledger.count(maxima, 0) {
        return Ok(());
    }
    let (g, at) = (name(case.k(), i), [("i", i.to_string()), ("x", high.to_string())]);
    let claimed = format!("{g} rises to the limit 1 at {high} and drops to 0 there");
    let found = format!("it has the limit {limit}, the value {value} and {maxima} local maxima");
    Err(case.refuted(at, claimed, found))
}

/// The conjecture for every function of the case that is not 0 everywhere and not left out.
pub(super) fn conjecture(
    reading: Reading,
    except: Except,
    wanted: usize,
) -> impl Fn(&BasisCase, &mut Ledger) -> Judgement {
    move |case, ledger| {
        for i in 0..=case.n() {
            if nowhere(case, i, ledger) {
                continue;
            }
            match (except, except.leaves_out(case, i)) {
                (_, false) => one_maximum(case, i, reading, wanted, ledger)?,
                (Except::Drops, true) => rises_and_drops(case, i, ledger)?,
                (_, true) => {}
            }
        }
        Ok(())
    }
}

/// The four readings of the conjecture.
pub(super) fn claims() -> Vec<Claim> {
    let statement = |text, reading, except| {
        Form::Basis(Statement::new(text, conjecture(reading, except, 1)).given([DegreeAtLeast(1)]))
    };
    let low_degree = |text, reading, except| {
        let conclusion = conjecture(reading, except, 1);
        Form::Basis(Statement::new(text, conclusion).given([DegreeAtLeast(1), DegreeAtMost(2)]))
    };
    const LOW_DROPS: &str = "The same for k = 1 and k = 2, unless t_i < t_{i+1} = t_{i+k+1} < t_m: then G_i^k rises to the limit 1 and drops to 0 there.";
    const WEAK: &str = "See Conj3.1.strong.continuous for what is true from k = 3 on. A case has one α, and two maxima of the same height may ask for an irrational one. So where a function has two local maxima, the engine looks for an interval of indices, beginning or ending near that of the case, at whose ends different ones are the higher.";

    const LOW: &str = "The same for k = 1 and k = 2.";
    const WHERE: &str =
        "Functions with t_i = t_{i+k+1} are 0 everywhere and not meant: they have no maximum of either kind.";
    const CONTINUOUS: &str = "What is true from k = 3 on: at most k − 1 maxima (X.maxima.bound), never more than one inside a span (X.maxima.spans), and one only on simple uniform knots for k = 3 (X.maxima.uniform). Continuous is meant on (t_0, t_m). On the open support alone every function is continuous, those included that rise to a knot of multiplicity k + 1 and drop there.";
    vec![
        Claim::new(
            "Conj3.1.strong",
            "Conjecture 3.1",
            statement(
                "For k ≥ 1 every G_i^k with t_i < t_{i+k+1} has exactly one local maximum (an interval of constancy counts once).",
                Reading::Strong,
                Except::Nothing,
            ),
        )
        .fails_by(Cause::Conjecture)
        .amended(low_degree(LOW_DROPS, Reading::Strong, Except::Drops))
        .note(WHERE),
        Claim::new(
            "Conj3.1.weak",
            "Conjecture 3.1",
            statement(
                "For k ≥ 1 every G_i^k with t_i < t_{i+k+1} has a largest value and takes it at exactly one x.",
                Reading::Weak,
                Except::Nothing,
            ),
        )
        .fails_by(Cause::Conjecture)
        .amended(low_degree(LOW_DROPS, Reading::Weak, Except::Drops))
        .note(WHERE),
        Claim::new(
            "Conj3.1.strong.continuous",
            "Conjecture 3.1",
            statement(
                "For k ≥ 1 every G_i^k with t_i < t_{i+k+1} that is continuous on (t_0, t_m) has exactly one local maximum.",
                Reading::Strong,
                Except::Jumps,
            ),
        )
        .fails_by(Cause::Conjecture)
        .amended(low_degree(LOW, Reading::Strong, Except::Jumps))
        .by_degree_on(searched)
        .note(CONTINUOUS),
        Claim::new(
            "Conj3.1.weak.continuous",
            "Conjecture 3.1",
            statement(
                "For k ≥ 1 every G_i^k with t_i < t_{i+k+1} that is continuous on (t_0, t_m) has a largest value and takes it at exactly one x.",
                Reading::Weak,
                Except::Jumps,
            ),
        )
        .fails_by(Cause::Conjecture)
        .amended(low_degree(LOW, Reading::Weak, Except::Jumps))
        .by_degree_on(searched)
        .note(WEAK),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::claims::small_cases::Cases;
    use crate::claims::statement::judge;
    use crate::claims::verdict::Verdict;

    #[test]
    fn false_variants_are_refuted() {
        let bases = Cases::all().bases;
        for reading in [Reading::Strong, Reading::Weak] {
            let two_maxima = Statement::new("", conjecture(reading, Except::Jumps, 2));
            assert!(matches!(judge(&two_maxima, &bases).unwrap(), Verdict::Refuted(_)));
            let jumps_too = Statement::new("", conjecture(reading, Except::Nothing, 1));
            assert!(matches!(judge(&jumps_too, &bases).unwrap(), Verdict::Refuted(_)));
        }
    }
}
