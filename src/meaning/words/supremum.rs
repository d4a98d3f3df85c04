//! Suprema, which are compared as real numbers: they need not be rational.

use crate::analysis::{Greatest, compare};
use crate::language::{Item, Real, Relation, Use, Word};

use super::super::reading::Reading;
use super::super::truth::{Stop, Truth};
use super::super::value::{Plain, Value};

/// A chain of relations in which suprema occur, each with its neighbour; `None` for any other chain.
pub(in super::super) fn chain(
    own: &mut Reading<'_>,
    first: &Real,
    rest: &[(Relation, Real)],
) -> Option<Truth> {
    let terms = || std::iter::once(first).chain(rest.iter().map(|(_, term)| term));
    terms().any(|term| supremum_in(term).is_some()).then(|| {
        let values = terms().map(|term| number(own, term)).collect::<Result<Vec<_>, _>>();
        let mut values = values?;
        let mut all = Truth::True;
        for (at, (relation, _)) in rest.iter().enumerate() {
            let [a, b] = &mut values[at..=at + 1] else { continue };
            all = all.and(match compare(a, b) {
                Some(order) => relation.admits(order).into(),
                None => Truth::Unknown("two suprema that agree to some 128 bits".into()),
            });
        }
        Ok::<_, Stop>(all)
    }.into())
}

fn supremum_in(term: &Real) -> Option<&Use> {
    match term {
        Real::Word(of) if of.word == Word::Supremum => Some(of),
        _ => None,
    }
}

fn number(own: &mut Reading<'_>, term: &Real) -> Result<Greatest, Stop> {
    match supremum_in(term) {
        Some(of) => supremum(own, &of.of),
        None => match own.real(term)?.number() {
            Some(number) => Ok(number.clone().into()),
            None => Err(Stop::Unknown("a supremum beside what is no rational number".into())),
        },
    }
}

/// The supremum of a term on an interval. That of |f| is the greater one of those of f and −f.
pub(in super::super) fn supremum(own: &mut Reading<'_>, of: &[Item]) -> Result<Greatest, Stop> {
    let [Item::Expression(term, name, Some(interval))] = of else {
        return Err(Stop::Unknown("a supremum without an interval".into()));
    };
    let (term, absolute) = match term {
        Real::Absolute(inner) => (&**inner, true),
        term => (term, false),
    };
    let mut greatest: Option<Greatest> = None;
    for cell in own.cells(interval)? {
        let value = own.within(name, &cell, |own| own.real(term))?;
        for value in std::iter::once(value.clone()).chain(absolute.then(|| value.negated())) {
            let next = of_value(&value)?;
            greatest = Some(match greatest {
                Some(all) => all.join(next),
                None => next,
            });
        }
    }
    greatest.ok_or_else(|| Stop::Undefined("the supremum on no point".into()))
}

fn of_value(value: &Value) -> Result<Greatest, Stop> {
    match value {
        Value { plain: Plain::Number(number), root: None } => Ok(number.clone().into()),
        Value { plain: Plain::Piece(f), root: None } => {
            Greatest::of_function(f).ok_or_else(|| Stop::Undefined("a supremum beside a pole".into()))
        }
        _ => Err(Stop::Unknown("the supremum of a square root".into())),
    }
}
