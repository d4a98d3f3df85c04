//! Suprema, which are compared as real numbers: they need not be rational.

use std::cmp::Ordering;

use num_traits::Signed;

use crate::analysis::{Enclosed, Greatest, compare};
use crate::language::{Real, Relation, Use, Word};

use super::super::instance::Instance;
use super::super::reading::{Found, Reading};
use super::super::truth::{Stop, Truth};
use super::super::value::{Plain, Value};
use super::{Expression, Of};

/// A chain of relations in which suprema occur, each with its neighbour; `None` for any other chain.
pub(in super::super) fn chain(
    own: &mut Reading<'_>,
    first: &Real,
    rest: &[(Relation, Real)],
) -> Option<Truth> {
    let terms = || std::iter::once(first).chain(rest.iter().map(|(_, term)| term));
    terms().find_map(supremum_in)?;
    let mut values = match terms().map(|term| number(own, term)).collect::<Result<Vec<_>, _>>() {
        Ok(values) => values,
        Err(stop) => return Some(stop.into()),
    };
    let mut all = Truth::True;
    for (at, (relation, _)) in rest.iter().enumerate() {
        let [a, b] = &mut values[at..=at + 1] else { continue };
        all = all.and(match compare(a, b) {
            Some(order) => admits(*relation, order).into(),
            None => Truth::Unknown("two suprema that agree to some 128 bits".into()),
        });
    }
    Some(all)
}

fn supremum_in(term: &Real) -> Option<&Use> {
    match term {
        Real::Word(of) if of.word == Word::Supremum => Some(of),
        _ => None,
    }
}

impl Reading<'_> {
    /// The supremum that a term is, rational or not; `None`, if it is another term or has no value.
    pub fn supremum(&mut self, term: &Real) -> Option<Greatest> {
        supremum_in(term)?;
        number(self, term).ok()
    }
}

fn number(own: &mut Reading<'_>, term: &Real) -> Result<Greatest, Stop> {
    let Some(of) = supremum_in(term) else {
        return match own.real(term)?.number() {
            Some(number) => Ok(number.clone().into()),
            None => Err(Stop::Unknown("a supremum beside what is no rational number".into())),
        };
    };
    // What depends on nothing but integers is found once, and told.
    let bound = &own.bound;
    let home = own.weights == own.on.weights
        && bound.reals.is_empty()
        && bound.indices.is_empty()
        && bound.points.is_empty();
    let integers = bound.integers.clone();
    let known = own.found.iter().find(|known| home && known.term == *term && known.integers == integers);
    if let Some(known) = known {
        return Ok(known.value.clone());
    }
    let value = greatest(own, Of(of).expression(0)?)?;
    if home {
        own.found.push(Found { term: term.clone(), integers, value: value.clone() });
    }
    Ok(value)
}

fn admits(relation: Relation, order: Ordering) -> bool {
    match relation {
        Relation::Equal => order.is_eq(),
        Relation::Unequal => order.is_ne(),
        Relation::Less => order.is_lt(),
        Relation::AtMost => order.is_le(),
        Relation::Greater => order.is_gt(),
        Relation::AtLeast => order.is_ge(),
    }
}

/// The supremum of an expression on its interval, where it is known to be a rational number.
pub(super) fn supremum(own: &mut Reading<'_>, of: Expression<'_>) -> Result<Value, Stop> {
    match greatest(own, of)?.bounds() {
        (lo, hi) if lo == hi => Ok(lo.into()),
        (lo, hi) => Err(Stop::Unknown(format!("a supremum between {lo} and {hi}"))),
    }
}

/// The supremum of |f| is the greater one of those of f and −f: so f is not cut at its zeros.
fn greatest(own: &mut Reading<'_>, (term, name, interval): Expression<'_>) -> Result<Greatest, Stop> {
    let interval = interval.ok_or_else(|| Stop::Unknown("a supremum without an interval".into()))?;
    let (term, absolute) = match term {
        Real::Absolute(inner) => (&**inner, true),
        term => (term, false),
    };
    let mut all: Option<Greatest> = None;
    for cell in own.cells(interval)? {
        let value = own.within(name, &cell, |own| own.real(term))?;
        let next = on_cell(own.on, &value, absolute)?;
        all = Some(match all {
            Some(all) => all.join(next),
            None => next,
        });
    }
    all.ok_or_else(|| Stop::Undefined("the supremum on no point".into()))
}

fn on_cell(on: &Instance, value: &Value, absolute: bool) -> Result<Greatest, Stop> {
    match value {
        Value { plain: Plain::Number(number), root: None } => {
            Ok(if absolute { number.abs() } else { number.clone() }.into())
        }
        Value { plain: Plain::Piece(f), root: None } => {
            on.greatest(f.piece(), absolute).ok_or_else(|| Stop::Undefined("a supremum beside a pole".into()))
        }
        Value { .. } => Err(Stop::Unknown("the supremum of a square root".into())),
    }
}

#[cfg(test)]
mod tests {
    use crate::language::one_line;
    use crate::meaning::{Instance, Names, decide};
    use crate::scalar::integer;
    use crate::spline::{Basis, KnotVector};

    /// Is the conclusion true of k = 1 on (0, 0, 1, 1)? `None`, if that is not found out.
    fn holds(alpha: &str, conclusion: &str) -> Option<bool> {
        let read = one_line(&format!("k = 1; U : {conclusion}")).unwrap();
        let knots = KnotVector::new([0, 0, 1, 1].map(integer).to_vec()).unwrap();
        let on = Instance::of(Basis::new(knots, 1, alpha.parse().unwrap()).unwrap());
        let decided = decide(&read, &on, Names::empty());
        decided.unknown.is_none().then(|| decided.failure.is_none())
    }

    #[test]
    fn suprema_are_compared_exactly() {
        const OFF: &str = "sup(abs(G[0](x) - G[0](x; alpha = infinity)), x in [0, 1])";
        let conjugate = OFF.replacen("G[0](x)", "G[0](x; alpha = 1-alpha)", 1);
        // (√r − 1)/(√r + 1): 1/3 for r = 1/4, and 3 − 2√2 = 0.17157… for r = 1/2.
        for (alpha, conclusion, expected) in [
            ("-1/3", format!("{OFF} = 1/3"), Some(true)),
            ("-1/3", format!("{OFF} < 1/3"), Some(false)),
            ("-1/3", format!("1/4 < {OFF} <= {conjugate} < 2/5"), Some(true)),
            ("-1", format!("17157/100000 < {OFF} < 17158/100000"), Some(true)),
            ("-1", format!("{OFF} = 17157/100000"), Some(false)),
            ("-1", format!("{OFF} = {conjugate}"), None),
            ("-1", "sup(G[1](x), x in [0, 1)) = 1".to_owned(), Some(true)),
            // There is none.
            ("-1", "sup(1/x, x in (0, 1]) > 0".to_owned(), Some(false)),
        ] {
            let found = holds(alpha, &conclusion);
            assert!(found == expected, "α = {alpha}, {conclusion}: {found:?}");
        }
    }
}
