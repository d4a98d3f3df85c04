//! From a sentence to windows and goals, by the place of x, the copies of a knot, and the order of indices
//! (`proofs/FORMAT.md`, "Derivation"). The checker derives the same again, in code of its own.

mod case;
mod index;
mod numbers;
mod obligation;
mod place;
mod ratios;

use thiserror::Error;

use crate::language::{Claim, Definition, Row, Sentence};

use crate::scalar::integer;

use super::statement::{Gap, Section, Window};
use super::term::{self, Formula, Term};
use super::weights::{Class, Weighted};
use case::{Bound, Case, MIRROR, Numbers, Parameters, Scope, Stop, Truth, WINDOW, gap_name};
use index::Contradiction;
use obligation::{Obligation, Point, Subject, names_an_index, obligations, subjects};
use place::Place;
use ratios::Ratios;

/// Why a sentence has no windows.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[error("no window: {why}{}", .place.as_ref().map(|place| format!(", at {place}")).unwrap_or_default())]
pub struct NoWindow {
    /// What is not decided, or not said by windows.
    pub why: String,
    /// Where x is.
    pub place: Option<String>,
}

impl NoWindow {
    fn because(why: impl Into<String>) -> Self {
        Self { why: why.into(), place: None }
    }
}

/// The windows and goals of a sentence for one degree: if all goals hold, it is true on every knot vector, for every α.
///
/// # Errors
/// [`NoWindow`], if it says something that is not decided by the place of x, or false there.
pub fn derive(
    sentence: &Sentence,
    definitions: &[Definition],
    claim: Claim<'_>,
    k: usize,
    weighted: &Weighted,
) -> Result<Vec<Section>, NoWindow> {
    let degree = i64::try_from(k).map_err(|_| NoWindow::because("a degree that is too large"))?;
    let mut sections = Vec::new();
    for subject in subjects(sentence, claim, k)? {
        for obligation in obligations(sentence, definitions, claim, k, subject)? {
            if let Some(d) = obligation.orders {
                sections.extend(orders_at_knots(weighted, d)?);
                continue;
            }
            let found = match subject {
                Subject::Example(row) => for_ratios(&obligation, weighted, |ratios| {
                    of_example(&obligation, weighted, degree, row, ratios)
                }),
                Subject::Weights => {
                    for_ratios(&obligation, weighted, |ratios| of_weights(&obligation, weighted, ratios))
                }
                Subject::Knots => match of_obligation(&obligation, weighted, degree, false) {
                    Err(straight) if obligation.symmetric => {
                        // Of two reasons the first one, in the order of what is tried first.
                        of_obligation(&obligation, weighted, degree, true).map_err(|_| straight)
                    }
                    other => other,
                },
            };
            sections.extend(found?);
        }
    }
    Ok(sections)
}

fn of_obligation(
    obligation: &Obligation<'_>,
    weighted: &Weighted,
    k: i64,
    mirrored: bool,
) -> Result<Vec<Section>, NoWindow> {
    let at = |place| at(obligation, weighted, k, place, mirrored);
    let mut sections = Vec::new();
    for coarse in Place::COARSE {
        let finer = coarse.finer(k + 3);
        match at(coarse) {
            Ok(section) => sections.extend(section),
            Err(stop) if finer.is_empty() => return Err(no_window(&stop, coarse)),
            Err(_) => {
                for place in finer {
                    let section = at(place).map_err(|stop| no_window(&stop, place))?;
                    sections.extend(section);
                }
            }
        }
    }
    Ok(sections)
}

fn no_window(stop: &Stop, place: Place) -> NoWindow {
    let (Stop::Undecided(why) | Stop::Undefined(why)) = stop;
    NoWindow { why: why.clone(), place: Some(place.to_string()) }
}

/// G_0 of degree d begins at the first of q knots, for q = 1, …, d + 1: its orders there.
fn orders_at_knots(weighted: &Weighted, d: i64) -> Result<Vec<Section>, NoWindow> {
    let natural = |n: i64| usize::try_from(n).map_err(|_| NoWindow::because("a degree"));
    let section = |q: i64| {
        let gap = |e: i64| match e {
            _ if e == q - 1 => Gap::Parameter(Class::Positive),
            _ if (0..q).contains(&e) => Gap::Term(Term::Number(integer(0))),
            _ => Gap::Parameter(Class::Nonnegative),
        };
        let window = Window { name: WINDOW.into(), first: -d, gaps: (-d..=q + d).map(gap).collect() };
        let place = term::Place { at: term::Where::In, window: WINDOW.into(), span: q - 1 };
        let goal = Formula::Order { i: 0, degree: natural(d)?, place, order: natural(d + 1 - q)? };
        Ok(self::section(Parameters::default(), weighted, &Ratios::default(), vec![window], vec![goal]))
    };
    (1..=d + 1).map(section).collect()
}

/// The sections of numbers: if something is not decided for all r, for each order of 1, r, and the ratios of other indices.
fn for_ratios(
    obligation: &Obligation<'_>,
    weighted: &Weighted,
    of: impl Fn(&Ratios) -> Result<Vec<Section>, NoWindow>,
) -> Result<Vec<Section>, NoWindow> {
    of(&Ratios { is_free: true, ..Ratios::of(obligation.side) }).or_else(|error| {
        let orders = if weighted.is_mobius() { Ratios::in_order(obligation) } else { Vec::new() };
        let each = orders.iter().map(of).collect::<Result<Vec<_>, _>>();
        each.ok().filter(|all| !all.is_empty()).map(|all| all.concat()).ok_or(error)
    })
}

/// The sections of an example, at each place of x among its knots.
fn of_example(
    obligation: &Obligation<'_>,
    weighted: &Weighted,
    k: i64,
    row: &Row,
    ratios: &Ratios,
) -> Result<Vec<Section>, NoWindow> {
    let mut sections = Vec::new();
    let count = if matches!(obligation.point, Point::Bound(_)) { numbers::places(&row.knots) } else { 1 };
    for place in 0..count {
        let mut parameters = Parameters::default();
        let mut case = known(obligation, weighted, k, &mut parameters, Some(row), ratios)?;
        // Without an x any does.
        let at = if count == 1 { 1 } else { place };
        let found = case.x_at(at, &row.knots).and_then(|x| case.locate(x)).and_then(|_| {
            if let Point::Bound(name) = &obligation.point {
                case.bind_point(name);
            }
            for (name, sign, _) in &obligation.reals {
                let value = case.free(name, *sign)?;
                case.scope.reals.push((name.clone(), Bound::Free(value)));
            }
            let window = case.numbers.iter().map(Numbers::window).collect();
            shown(case, obligation, Some(window))
        });
        sections.extend(
            found
                .map_err(|stop| NoWindow {
                    place: row.name.as_ref().map(ToString::to_string),
                    ..no_window(&stop, Place::Inside)
                })?
                .map(|(windows, goals)| section(parameters, weighted, ratios, windows, goals)),
        );
    }
    Ok(sections)
}

/// The sections of all orders of the reals, each with all places of the one that has an interval.
fn of_weights(
    obligation: &Obligation<'_>,
    weighted: &Weighted,
    ratios: &Ratios,
) -> Result<Vec<Section>, NoWindow> {
    let mut sections = Vec::new();
    let located =
        obligation.reals.iter().rev().find_map(|(name, _, interval)| Some((name, interval.as_ref()?)));
    let ordered: Vec<_> = obligation
        .reals
        .iter()
        .filter(|(name, sign, interval)| {
            sign.is_none() && interval.is_none() && obligation.stands_alone(name)
        })
        .map(|(name, ..)| name)
        .collect();
    let Some(orders) = ratios::orders(ordered.len()) else {
        return Err(NoWindow::because("more reals than are put in order"));
    };
    for (order, part) in orders
        .iter()
        .flat_map(|order| (0..if located.is_some() { 3 } else { 1 }).map(move |part| (order, part)))
    {
        let mut parameters = Parameters::default();
        let mut case = known(obligation, weighted, 1, &mut parameters, None, ratios)?;
        let bind = || -> Result<_, Stop> {
            for (name, sign, _) in &obligation.reals {
                if located.is_some_and(|(x, _)| x == name) {
                    continue;
                }
                let value = match ordered.iter().position(|known| *known == name) {
                    Some(at) => case.ranked(order[at])?,
                    None => case.free(name, *sign)?,
                };
                case.scope.reals.push((name.clone(), Bound::Free(value)));
            }
            case.parameters.begin();
            if excluded(&mut case, obligation) {
                return Ok(None);
            }
            if let Some((name, interval)) = located {
                let Some(x) = case.between(interval, part)? else { return Ok(None) };
                case.scope.reals.push((name.clone(), Bound::Free(x)));
            }
            shown(case, obligation, Some(Vec::new()))
        };
        let found = bind().map_err(|stop| NoWindow {
            place: Some(format!("the order {order:?} of its reals")),
            ..no_window(&stop, Place::Inside)
        })?;
        sections.extend(found.map(|(windows, goals)| section(parameters, weighted, ratios, windows, goals)));
    }
    Ok(sections)
}

/// A case of numbers, with x nowhere yet.
fn known<'a>(
    obligation: &Obligation<'a>,
    weighted: &'a Weighted,
    k: i64,
    parameters: &'a mut Parameters,
    row: Option<&'a Row>,
    ratios: &Ratios,
) -> Result<Case<'a>, NoWindow> {
    let place = Place::Inside;
    let facts = place.facts(k).map_err(|Contradiction| NoWindow::because("a degree"))?;
    Ok(Case {
        k,
        place,
        weighted,
        definitions: obligation.definitions,
        parameters,
        zero: Vec::new(),
        facts,
        scope: Scope::default(),
        symmetric: false,
        mirrored: false,
        other: None,
        ratios: ratios.clone(),
        exact: false,
        numbers: Some(Numbers::of(row)),
        beyond: 0,
        copies_from: None,
    })
}

/// Windows and goals.
type Shown = (Vec<Window>, Vec<Formula>);

/// Windows and goals of a case, if anything is to be shown in it.
fn shown(
    mut case: Case<'_>,
    obligation: &Obligation<'_>,
    windows: Option<Vec<Window>>,
) -> Result<Option<Shown>, Stop> {
    case.parameters.begin();
    let mut goals = Vec::new();
    if !excluded(&mut case, obligation) {
        cases(&mut case, obligation, 0, &mut goals)?;
    }
    if goals.is_empty() {
        return Ok(None);
    }
    let windows = windows.map_or_else(|| case.windows(&goals), Ok)?;
    Ok(Some((windows, goals)))
}

/// The section of a place; `None` if nothing is to be shown there.
fn at(
    obligation: &Obligation<'_>,
    weighted: &Weighted,
    k: i64,
    place: Place,
    mirrored: bool,
) -> Result<Option<Section>, Stop> {
    let mut parameters = Parameters::default();
    let Ok(facts) = place.facts(k) else { return Ok(None) };
    if place.copies().is_some_and(|least| least > obligation.most_inside(k, place)) {
        return Ok(None);
    }
    let mut case = Case {
        k,
        place,
        weighted,
        definitions: obligation.definitions,
        parameters: &mut parameters,
        zero: Vec::new(),
        facts,
        scope: Scope::default(),
        symmetric: obligation.symmetric,
        mirrored,
        other: None,
        ratios: Ratios::default(),
        exact: false,
        numbers: None,
        beyond: 0,
        copies_from: None,
    };
    match &obligation.point {
        Point::Any => {}
        Point::Bound(name) => case.bind_point(name),
        Point::Knot(_) => case.bind_point(&obligation::point_name()),
    }
    for (name, sign, _) in &obligation.reals {
        let value = case.free(name, *sign)?;
        case.scope.reals.push((name.clone(), Bound::Free(value)));
    }
    // What is said without any bound integer is said in all cases.
    let tightened = case.tighten(&obligation.assume).and_then(|()| case.coincide(&obligation.coincide));
    if tightened.and_then(|()| case.tighten(&obligation.assume)).is_err() {
        return Ok(None);
    }
    let found = shown(case, obligation, None)?;
    let ratios = Ratios::of(obligation.side);
    Ok(found.map(|(windows, goals)| section(parameters, weighted, &ratios, windows, goals)))
}

/// All cases of the integers from one binder on.
fn cases(
    case: &mut Case<'_>,
    obligation: &Obligation<'_>,
    from: usize,
    goals: &mut Vec<Formula>,
) -> Result<(), Stop> {
    if let Some(range) = obligation.integers.get(from) {
        let beyond = case.beyond;
        for (i, _) in case.run(range)? {
            let below = |case: &mut Case<'_>| match excluded(case, obligation) {
                true => Ok(()),
                false => cases(case, obligation, from + 1, goals),
            };
            if let Ok(done) = case.with(range, &i, below)? {
                done?;
            }
        }
        case.beyond = beyond;
        return Ok(());
    }
    let facts = case.facts.clone();
    let found =
        if case.tighten(&obligation.assume).is_ok() { one_case(case, obligation) } else { Ok(Vec::new()) };
    (case.facts, case.copies_from) = (facts, None);
    let found = found?;
    case.parameters.close(&found);
    for goal in found {
        if !goals.contains(&goal) {
            goals.push(goal);
        }
    }
    Ok(())
}

/// Is a hypothesis false with the integers that are bound so far?
fn excluded(case: &mut Case<'_>, obligation: &Obligation<'_>) -> bool {
    let excluded = obligation.assume.iter().any(|f| case.formula(f) == Truth::False);
    case.parameters.close(&[]);
    excluded
}

fn one_case(case: &mut Case<'_>, obligation: &Obligation<'_>) -> Result<Vec<Formula>, Stop> {
    let mut undefined = None;
    let mut open = None;
    if let (Point::Knot(i), Some(is_x)) = (&obligation.point, obligation.assume.first()) {
        match case.formula(is_x) {
            Truth::False => return Ok(Vec::new()),
            truth if truth.is_true() => {}
            _ if case.place.is_coarse() => return Err(Stop::Undecided("which knot x is".into())),
            _ => {}
        }
        case.copies_from = Some(case.int(i)?);
    }
    for hypothesis in &obligation.assume {
        match case.formula(hypothesis) {
            Truth::False => return Ok(Vec::new()),
            Truth::Not(stop @ Stop::Undefined(_)) => undefined = Some(stop),
            truth if truth.is_true() => {}
            // What is not decided is left out: without it more is shown. A finer place may decide it.
            _ if case.place.is_coarse() && obligation.names_the_point(hypothesis) => {
                open = Some(Stop::Undecided("a hypothesis on x".into()));
            }
            // So may an order of ratios.
            _ if case.ratios.is_free && names_an_index(hypothesis) => {
                open = Some(Stop::Undecided("a hypothesis on an index".into()));
            }
            _ => {}
        }
    }
    if let Some(stop) = undefined {
        return Err(stop);
    }
    let claim = case.formula(&obligation.claim);
    match claim {
        claim if claim.is_true() => Ok(Vec::new()),
        Truth::Goals(_) if open.is_some() => Err(open.unwrap_or(Stop::Undecided(String::new()))),
        Truth::Goals(goals) => Ok(goals),
        Truth::False => Err(Stop::Undecided("it is false".into())),
        Truth::Not(stop) => Err(stop),
    }
}

impl Case<'_> {
    /// The windows that goals look at.
    fn windows(&mut self, goals: &[Formula]) -> Result<Vec<Window>, Stop> {
        let names = |window: &str| goals.iter().any(|goal| goal.names(window));
        let mut all = Vec::new();
        let (first, last) = self.place.shown(self.k);
        if names(WINDOW) || names(MIRROR) {
            let gap = |e: i64| match self.gap(e) {
                Some(class) => Gap::Parameter(class),
                None => Gap::Term(Term::Number(integer(0))),
            };
            all.push(Window { name: WINDOW.into(), first, gaps: (first..last).map(gap).collect() });
        }
        if names(MIRROR) {
            // t_{s'+e+1} − t_{s'+e} is the gap −e, or with q copies inside −q−e, of the window.
            let turn = self.turn();
            let gap = |e: i64| match turn - e {
                of if !(first..last).contains(&of) => Gap::Parameter(Class::Nonnegative),
                of => match self.gap(of) {
                    Some(_) => Gap::Term(Term::Named(gap_name(of))),
                    None => Gap::Term(Term::Number(integer(0))),
                },
            };
            all.push(Window {
                name: MIRROR.into(),
                first: -self.k,
                gaps: (-self.k..=self.k).map(gap).collect(),
            });
        }
        Ok(all)
    }
}

/// With those parameters that occur.
fn section(
    parameters: Parameters,
    weighted: &Weighted,
    ratios: &Ratios,
    windows: Vec<Window>,
    goals: Vec<Formula>,
) -> Section {
    let is_gap = |name: &str| windows.iter().any(|window| name.starts_with(&format!("({} ", window.name)));
    let single: Vec<_> = weighted.single().into_iter().map(|(name, _)| name.to_string()).collect();
    let always = |name: &String| name == "u" || single.contains(name) || ratios.declared.contains(name);
    let declared = parameters.kept.into_iter().filter(|(name, _)| !always(name) && !is_gap(name));
    let rho = ratios.declared.iter().map(|name| (name.clone(), Class::Positive));
    let parameters = rho.chain(declared).collect();
    let lets = ratios.own.iter().map(|ratio| ("r".to_owned(), ratio.clone())).collect();
    Section { parameters, lets, windows, goals, hints: Vec::new() }
}
