//! Sentences about an interval [a, b] that say the same on every interval: they can be moved and stretched.

use crate::language::{Argument, Binder, Formula, Function, Int, Interval, Member, Over, Real, Sentence};
use crate::scalar::BigRational;

/// How a term follows t ↦ s·t + c, s > 0: it becomes s^degree times what it was, plus weight·c if its degree is 1.
#[derive(Debug, Clone, PartialEq, Eq)]
struct Moves {
    degree: i64,
    weight: BigRational,
    /// Is it the number 0, which follows in any way?
    zero: bool,
}

impl Moves {
    fn with(degree: i64, weight: i64) -> Self {
        Self { degree, weight: BigRational::from_integer(weight.into()), zero: false }
    }

    /// Does it follow by a factor only?
    fn is_scaled(&self) -> bool {
        self.weight == BigRational::from_integer(0.into())
    }

    fn agrees(&self, other: &Self) -> bool {
        let zero = |one: &Self, other: &Self| one.zero && other.is_scaled();
        self == other || zero(self, other) || zero(other, self)
    }
}

/// Is a sentence whose only numbers are two, a and b, and points, decided by one interval for each order of a and b: does it say
/// the same after every motion t ↦ s·t + c, s > 0, of all of them?
pub(super) fn is_decided_by_order(sentence: &Sentence) -> bool {
    let binders = sentence.given.iter().all(|binder| match binder {
        Binder::Real { sign, .. } => sign.is_none(),
        Binder::Point(_, interval) => interval_moves(interval),
        Binder::Indices(_) | Binder::Index(_) => true,
        _ => false,
    });
    binders && sentence.assume.iter().chain(&sentence.then).all(formula)
}

fn interval_moves(interval: &Interval) -> bool {
    let point = Moves::with(1, 1);
    [&interval.from, &interval.to].into_iter().all(|end| real(end).as_ref() == Some(&point))
}

fn formula(f: &Formula) -> bool {
    match f {
        Formula::Chain(first, rest) => {
            let terms: Option<Vec<_>> =
                std::iter::once(first).chain(rest.iter().map(|(_, t)| t)).map(real).collect();
            terms.is_some_and(|terms| terms.windows(2).all(|pair| pair[0].agrees(&pair[1])))
        }
        Formula::Within(x, interval) => {
            let ends: Option<Vec<_>> = [x, &interval.from, &interval.to].into_iter().map(real).collect();
            ends.is_some_and(|all| all.iter().all(|one| all.iter().all(|other| one.agrees(other))))
        }
        Formula::Not(f) => formula(f),
        Formula::And(all) | Formula::Or(all) => all.iter().all(formula),
        Formula::Implies(a, b) | Formula::Iff(a, b) => formula(a) && formula(b),
        Formula::All(over, f) | Formula::Some(over, f) | Formula::One(over, f) => match over {
            Over::Reals(_, interval) => interval_moves(interval) && formula(f),
            _ => false,
        },
        Formula::Among(..) | Formula::Instance(_) | Formula::Word(_) | Formula::Claim { .. } => false,
    }
}

fn real(t: &Real) -> Option<Moves> {
    let scaled = |a: &Real| real(a).filter(Moves::is_scaled);
    Some(match t {
        Real::Number(_) | Real::Ratio | Real::Index(_) | Real::Infinity => Moves::with(0, 0),
        Real::Whole(Int::Number(0)) => Moves { zero: true, ..Moves::with(0, 0) },
        Real::Whole(Int::Number(_)) => Moves::with(0, 0),
        // The numbers are the ends and the points between them.
        Real::Bound(_) => Moves::with(1, 1),
        Real::Plus(a, b) => sum(&real(a)?, &real(b)?, 1)?,
        Real::Minus(a, b) => sum(&real(a)?, &real(b)?, -1)?,
        Real::Negated(a) => sum(&Moves { zero: true, ..Moves::with(0, 0) }, &real(a)?, -1)?,
        Real::Times(a, b) => {
            let (a, b) = (scaled(a)?, scaled(b)?);
            Moves::with(a.degree + b.degree, 0)
        }
        Real::Over(a, b) => {
            let (a, b) = (scaled(a)?, scaled(b)?);
            Moves::with(a.degree - b.degree, 0)
        }
        Real::Absolute(a) => Moves { zero: false, ..scaled(a)? },
        Real::Root(a) => scaled(a).filter(|a| a.degree == 0)?,
        Real::Power(a, Int::Number(e)) => Moves::with(scaled(a)?.degree * e, 0),
        Real::Least(a, b) | Real::Greatest(a, b) => {
            let (a, b) = (real(a)?, real(b)?);
            (a == b).then_some(a)?
        }
        Real::Value(f, argument) => value(f, argument)?,
        _ => return None,
    })
}

/// a + factor·b.
fn sum(a: &Moves, b: &Moves, factor: i64) -> Option<Moves> {
    let degree = if a.zero { b.degree } else { a.degree };
    let fits = a.zero || b.zero || a.degree == b.degree;
    let weight = &a.weight + &b.weight * BigRational::from_integer(factor.into());
    fits.then_some(Moves { degree, weight, zero: a.zero && b.zero })
}

/// φ and its derivatives: numbers that depend on the place in the interval.
fn value(f: &Function, argument: &Argument) -> Option<Moves> {
    let fixed = match &argument.member {
        None | Some(Member::Dual) => true,
        Some(Member::Index(t) | Member::Ratio(t) | Member::Parameter(_, t)) => {
            real(t).is_some_and(|t| t.degree == 0 && t.is_scaled())
        }
    };
    let point = Moves::with(1, 1);
    let (mut f, mut order) = (f, 0);
    while let Function::Derivative(of, Int::Number(more)) = f {
        (f, order) = (of, order + more);
    }
    let Function::Phi { from, to, .. } = f else { return None };
    let at_points = [from, to, &argument.at].into_iter().all(|end| real(end).as_ref() == Some(&point));
    (fixed && at_points).then(|| Moves::with(-order, 0))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::language::one_line;

    #[test]
    fn what_says_the_same_on_every_interval() {
        for (text, expected) in [
            ("a; b; x : 0 <= phi(x, a, b) < 1", true),
            ("a; b; x in [a, b] | a < b : abs(f(x, a, b) - (x-a)/(b-a)) <= abs(r - 1)", true),
            ("a; b; x in [a, b] | a < b : f(a+b-x, a, b) = 1 - f(x, a, b; alpha = 1-alpha)", true),
            ("a; b; x in (a, b) | a < b : phi''(x, a, b) > 0", true),
            ("a; b; x in (a, b) | a < b : x = (a*sqrt(r) + b)/(sqrt(r) + 1)", false),
            ("a; b; x in [a, b] : phi(x, a, b) <= 1/(b-a)", false),
            ("a; b; x in [a, b] | a < 1 : phi(x, a, b) <= 1", false),
            ("a; b; x in [a, b] : phi'(x, a, b) <= 1", false),
            ("a; b; x in [a, b] : x <= 0", false),
            ("a; b; x : phi(2*x, a, b) <= 1", false),
        ] {
            assert_eq!(is_decided_by_order(&one_line(text).unwrap()), expected, "{text}");
        }
    }
}
