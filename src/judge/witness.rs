//! A typed counterexample. Sentence, JSON and command are printed from it; nothing reads its text again.

use crate::analysis::{Algebraic, settled};
use crate::language::{Formula, Int, Name, Over, Real, Sentence};
use crate::meaning::{Failure, Focus, Given, Instance, Names, Plain, Reading, Truth, Value};
use crate::spline::Basis;

use super::Fault;

/// An exact counterexample that a reader can check by hand.
#[derive(Debug, Clone)]
pub struct Witness {
    /// The name of the instance, if it has one.
    pub name: Option<Name>,
    /// The basis, where the sentence is about one.
    pub basis: Option<Basis>,
    /// α.
    pub index: crate::spline::Index,
    /// What is bound, in reading order: by `for`, then by `all` inside of the conclusion.
    pub given: Vec<(Name, Given)>,
    /// The conclusion that fails by its place; `None` is a hypothesis that is not defined.
    pub conclusion: Option<usize>,
    /// The part of it that fails.
    pub part: Option<Formula>,
    /// What is so.
    pub shows: Shows,
}

/// What is so at a witness.
#[derive(Debug, Clone, PartialEq)]
pub enum Shows {
    /// The sides of the chain that fails.
    Values(Vec<Side>),
    /// Counts, by what is counted.
    Counts(Vec<(Int, i64)>),
    /// What does not exist.
    Undefined(String),
    /// The formula is false, and has no sides.
    Fails,
}

/// A side of a relation.
#[derive(Debug, Clone, PartialEq)]
pub struct Side {
    /// The term.
    pub term: Real,
    /// Its value in exact terms, or its first digits; `None`, if it has none.
    pub value: Option<String>,
    /// Are these only its first digits?
    pub rounded: bool,
}

impl Witness {
    /// From a failure, replayed by the definition.
    ///
    /// # Errors
    /// [`Fault`], if the definition does not show it.
    pub(super) fn of(
        sentence: &Sentence,
        names: Names<'_>,
        on: &Instance,
        failure: Failure,
    ) -> Result<Self, Fault> {
        let own_knots = failure.knots.as_ref().zip(on.degree());
        let basis = own_knots.and_then(|(knots, k)| Basis::new(knots.clone(), k, on.index.clone()).ok());
        let own = basis.map(Instance::of);
        let on = own.as_ref().unwrap_or(on);
        let reference = on.by_definition();
        let mut reading = Reading::with(&reference, names, &failure.given);
        let (mut given, mut part) = (failure.given, None);
        let shows = match (&failure.undefined, failure.conclusion) {
            (Some(what), _) => Shows::Undefined(what.clone()),
            (None, Some(at)) => {
                let conclusion = &sentence.then[at];
                if reading.truth(conclusion) != Truth::False {
                    let (basis, index) = (&on.basis, &on.index);
                    return Err(Fault(format!(
                        "{conclusion:?} fails on {basis:?}, α = {index}, {given:?}, but not by the definition"
                    )));
                }
                let failing = failing(&mut reading, conclusion, &mut given);
                let shows = sides(&mut reading, &failing);
                part = Some(failing);
                shows
            }
            (None, None) => Shows::Fails,
        };
        Ok(Self {
            name: on.name.clone(),
            basis: on.basis.clone(),
            index: on.index.clone(),
            given,
            conclusion: failure.conclusion,
            part,
            shows,
        })
    }

    /// Names and exact values in reading order: `k`, `U`, `α`, `i`, `x`.
    #[must_use]
    pub fn given(&self) -> Vec<(String, String)> {
        let mut all = Vec::new();
        let mut add = |name: &str, value: String| all.push((name.to_owned(), value));
        if let Some(name) = &self.name {
            add("instance", name.to_string());
        }
        if let Some(basis) = &self.basis {
            add("k", basis.degree().to_string());
            add("U", basis.knots().to_string());
        }
        add("α", self.index.to_string());
        for (name, given) in &self.given {
            let name = if &**name == "beta" { "β" } else { name };
            add(name, shown(given));
        }
        all
    }

    /// What the sentence says there.
    #[must_use]
    pub fn claimed(&self) -> String {
        self.part.as_ref().map_or_else(|| "that it is defined".to_owned(), text)
    }

    /// What is so.
    #[must_use]
    pub fn found(&self) -> String {
        let list = |all: Vec<String>| all.join(", ");
        match &self.shows {
            Shows::Undefined(what) => what.clone(),
            Shows::Fails => "it is not so".into(),
            Shows::Counts(counts) => {
                let count = |(what, n): &(Int, i64)| format!("{} = {n}", text(what));
                list(counts.iter().filter(|(what, _)| !matches!(what, Int::Number(_))).map(count).collect())
            }
            Shows::Values(sides) => {
                let side = |side: &Side| {
                    let (term, relation) = (text(&side.term), if side.rounded { "≈" } else { "=" });
                    match &side.value {
                        Some(value) => format!("{term} {relation} {value}"),
                        None => format!("{term} does not exist"),
                    }
                };
                let told = sides
                    .iter()
                    .filter(|side| !matches!(side.term, Real::Number(_) | Real::Whole(Int::Number(_))));
                list(told.map(side).collect())
            }
        }
    }

    /// The shortest command that shows it, where one does.
    #[must_use]
    pub fn again(&self) -> Option<String> {
        let basis = self.basis.as_ref()?;
        let x = self.given.iter().find_map(|(name, given)| match given {
            Given::Real(x) if &**name == "x" => Some(x),
            _ => None,
        })?;
        let knots: Vec<_> = basis.knots().knots().iter().map(ToString::to_string).collect();
        let (degree, knots, alpha) = (basis.degree(), knots.join(","), basis.index());
        Some(format!(
            "knotproof eval --degree {degree} --knots {knots} --alpha {alpha} --x {x} --derivatives 1"
        ))
    }
}

fn shown(given: &Given) -> String {
    match given {
        Given::Integer(i) => i.to_string(),
        Given::Real(x) => x.to_string(),
        Given::Index(index) => index.to_string(),
        Given::Points(points) => {
            let points: Vec<_> = points.iter().map(ToString::to_string).collect();
            format!("({})", points.join(", "))
        }
        Given::Root(cell, root) => {
            let (lo, hi) = root.interval();
            let x = |u| cell.coordinate().evaluate(&u).map_or_else(String::new, |x| x.to_string());
            format!("an irrational number in ({}, {})", x(lo), x(hi))
        }
    }
}

/// The smallest part of a false formula that is false: of a conjunction the first, of `all` the first integer, which is bound.
fn failing(own: &mut Reading<'_>, f: &Formula, given: &mut Vec<(Name, Given)>) -> Formula {
    match f {
        Formula::And(all) => match all.iter().find(|f| own.truth(f) == Truth::False) {
            Some(part) => failing(own, part, given),
            None => f.clone(),
        },
        Formula::Implies(_, then) => failing(own, then, given),
        Formula::All(Over::Integers(range), body) => {
            let ends = own.int(&range.from).and_then(|from| Ok((from, own.int(&range.to)?)));
            for i in ends.map_or(1..=0, |(from, to)| from..=to) {
                own.bound.integers.push((range.name.clone(), i));
                if own.truth(body) == Truth::False {
                    given.push((range.name.clone(), Given::Integer(i)));
                    return failing(own, body, given);
                }
                own.bound.integers.pop();
            }
            f.clone()
        }
        _ => f.clone(),
    }
}

fn sides(own: &mut Reading<'_>, f: &Formula) -> Shows {
    let terms: Vec<&Real> = match f {
        Formula::Chain(first, rest) => std::iter::once(first).chain(rest.iter().map(|(_, t)| t)).collect(),
        Formula::Within(x, _) => vec![x],
        _ => return Shows::Fails,
    };
    let words = terms.iter().any(|t| matches!(t, Real::Whole(Int::Word(_))));
    if words {
        let count =
            |t: &Real| if let Real::Whole(i) = t { own.int(i).ok().map(|n| (i.clone(), n)) } else { None };
        return Shows::Counts(terms.into_iter().filter_map(count).collect());
    }
    let side = |term: &Real| {
        let value = own.real(term).ok().and_then(|value| digits(own, value));
        let (value, rounded) = value.map_or((None, false), |(value, rounded)| (Some(value), rounded));
        Side { term: term.clone(), value, rounded }
    };
    Shows::Values(terms.into_iter().map(side).collect())
}

/// A value in exact terms, or its first digits at an irrational place.
fn digits(own: &Reading<'_>, value: Value) -> Option<(String, bool)> {
    /// As many as a reader can look at.
    const DIGITS: usize = 12;
    match (&value, own.frame.as_ref().map(|frame| &frame.focus)) {
        (Value { plain: Plain::Piece(piece), root: None }, Some(Focus::At(root))) => {
            Some((settled(&mut Algebraic::at(piece.clone(), root.clone()), DIGITS), true))
        }
        (Value { plain: Plain::Piece(_), .. }, _) => None,
        _ => Some((value.to_string(), false)),
    }
}

// The printer of the language takes this place.
fn text(of: &impl std::fmt::Debug) -> String {
    format!("{of:?}")
}
