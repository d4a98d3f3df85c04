//! Control values: all of them where a conclusion is linear in them, and some otherwise.

use std::cell::Cell;

use crate::language::{
    Argument, Binder, Definition, Fold, Formula, Function, Int, Interval, Item, Member, Name, Range, Real,
    Relation, Sentence, Use,
};
use crate::scalar::{BigRational, integer};

/// Is the sentence decided for all control values by 0 and the unit vectors: do its conclusions consist of equalities of
/// terms that are affine in them, and are its hypotheses free of them?
pub(super) fn decided_by_units(sentence: &Sentence, definitions: &[Definition]) -> bool {
    let names: Vec<_> = sentence
        .given
        .iter()
        .filter_map(|binder| if let Binder::Points(name) = binder { Some(name.clone()) } else { None })
        .collect();
    order_of(&Order { names: &names, definitions, size: None }, sentence).is_some_and(|order| order <= 1)
}

/// The degree of the sentence as polynomials in a number: so many different values, and one more, decide it. `None` where it is not
/// made of equalities of such, or where a hypothesis or an interval depends on the number. `size` is k and m.
pub(super) fn degree_in(
    name: &Name,
    sentence: &Sentence,
    definitions: &[Definition],
    size: Option<(i64, i64)>,
) -> Option<usize> {
    let order = Order { names: std::slice::from_ref(name), definitions, size };
    let free = sentence.given.iter().all(|binder| match binder {
        Binder::Point(_, Interval { from, to, .. }) => order.free(from) && order.free(to),
        Binder::Gaps(_) => false,
        _ => true,
    });
    order_of(&order, sentence).filter(|degree| free && *degree <= MOST)
}

/// More values would take long.
const MOST: usize = 24;

/// The greatest order of a conclusion, if all are fit to be decided by it.
fn order_of(order: &Order<'_>, sentence: &Sentence) -> Option<usize> {
    let bodies = || order.definitions.iter().filter(|definition| order.mentions(&definition.name));
    let greatest = Cell::new(0);
    let conclusion = |equal: bool, of: usize| {
        greatest.set(greatest.get().max(of));
        of == 0 || equal && of < Order::BEYOND
    };
    let fits = bodies().all(|definition| order.real(&definition.body) <= 1)
        && sentence.assume.iter().all(|f| order.formula(f, &|_, of| of == 0))
        && sentence.then.iter().all(|f| order.formula(f, &conclusion));
    fits.then(|| greatest.get())
}

/// The order of a term as a polynomial in numbers or control values; [`Order::BEYOND`], if it is none.
struct Order<'a> {
    names: &'a [Name],
    definitions: &'a [Definition],
    /// k and m, for exponents and ranges.
    size: Option<(i64, i64)>,
}

impl Order<'_> {
    const BEYOND: usize = 1000;

    /// Does a definition speak of control values, itself or by others?
    fn mentions(&self, name: &Name) -> bool {
        let mut known: Vec<&Name> = vec![name];
        let mut at = 0;
        while let Some(name) = known.get(at).copied() {
            for definition in self.definitions.iter().filter(|definition| definition.name == *name) {
                let mut found = false;
                walk(&definition.body, &mut |name| {
                    found |= self.names.contains(name);
                    if let Some(other) = self.definitions.iter().find(|other| other.name == *name)
                        && !known.contains(&&other.name)
                    {
                        known.push(&other.name);
                    }
                });
                if found {
                    return true;
                }
            }
            at += 1;
        }
        false
    }

    fn real(&self, t: &Real) -> usize {
        match t {
            Real::Coefficient(name, _) | Real::Bound(name) => usize::from(self.names.contains(name)),
            Real::Defined(name, _) => usize::from(self.mentions(name)),
            Real::Plus(a, b) | Real::Minus(a, b) => self.real(a).max(self.real(b)),
            Real::Times(a, b) => (self.real(a) + self.real(b)).min(Self::BEYOND),
            Real::Over(a, b) if self.real(b) == 0 => self.real(a),
            Real::Negated(a) => self.real(a),
            Real::Fold(Fold::Sum, _, body) => self.real(body),
            // A derivative is as linear as its function, which may stand for control values.
            Real::Value(f, argument) if self.real(&argument.at) == 0 && self.free_of_member(argument) => {
                usize::from(self.function(f))
            }
            Real::Power(base, exponent) if !self.free(base) => {
                let exponent = self.linear(exponent).filter(|of| of.names.is_empty()).map(|of| of.constant);
                self.times(base, exponent)
            }
            Real::Fold(Fold::Product, range, body) if !self.free(body) => {
                self.times(body, self.length(range))
            }
            _ => {
                if self.free(t) {
                    0
                } else {
                    Self::BEYOND
                }
            }
        }
    }

    fn times(&self, body: &Real, count: Option<i64>) -> usize {
        let count = count.and_then(|count| usize::try_from(count).ok());
        count.map_or(Self::BEYOND, |count| (self.real(body) * count).min(Self::BEYOND))
    }

    /// How many steps a range has, if that is the same for all of what else is bound.
    fn length(&self, range: &Range) -> Option<i64> {
        let length = self.linear(&range.to)?.minus(self.linear(&range.from)?);
        length.names.is_empty().then(|| (length.constant + 1).max(0))
    }

    /// An integer as a sum of names and a number.
    fn linear<'t>(&self, i: &'t Int) -> Option<Linear<'t>> {
        let of = |a, b| Some((self.linear(a)?, self.linear(b)?));
        Some(match i {
            Int::Number(value) => Linear::number(*value),
            Int::Degree => Linear::number(self.size?.0),
            Int::M => Linear::number(self.size?.1),
            Int::Last => Linear::number(self.size?.1 - self.size?.0 - 1),
            Int::Bound(name) => Linear { names: vec![(name, 1)], constant: 0 },
            Int::Plus(a, b) => of(a, b).map(|(a, b)| a.minus(Linear::number(0).minus(b)))?,
            Int::Minus(a, b) => of(a, b).map(|(a, b)| a.minus(b))?,
            _ => return None,
        })
    }

    fn free_of_member(&self, argument: &Argument) -> bool {
        match &argument.member {
            None | Some(Member::Dual) => true,
            Some(Member::Index(t) | Member::Ratio(t) | Member::Parameter(_, t)) => self.free(t),
        }
    }

    fn is_defined(&self, name: &Name) -> bool {
        self.definitions.iter().any(|definition| definition.name == *name)
    }

    fn function(&self, f: &Function) -> bool {
        match f {
            Function::Defined(name, _) => self.mentions(name),
            Function::Derivative(f, _) => self.function(f),
            Function::Basis { .. } | Function::Weight { .. } => false,
            Function::Phi { from, to, .. } => !(self.free(from) && self.free(to)),
        }
    }

    /// Is a term free of control values?
    fn free(&self, t: &Real) -> bool {
        let mut free = true;
        walk(t, &mut |name| {
            free &= !(self.names.contains(name) || self.is_defined(name) && self.mentions(name))
        });
        free
    }

    fn formula(&self, f: &Formula, fits: &dyn Fn(bool, usize) -> bool) -> bool {
        match f {
            Formula::Chain(first, rest) => {
                let equal = rest.iter().all(|(relation, _)| *relation == Relation::Equal);
                std::iter::once(first).chain(rest.iter().map(|(_, t)| t)).all(|t| fits(equal, self.real(t)))
            }
            Formula::And(all) => all.iter().all(|f| self.formula(f, fits)),
            Formula::All(_, body) => self.formula(body, fits),
            // p => q with a p that is free of them is q on some cases.
            Formula::Implies(a, b) => self.formula(a, &|_, order| order == 0) && self.formula(b, fits),
            Formula::Within(x, Interval { from, to, .. }) => {
                [x, from, to].into_iter().all(|t| self.real(t) == 0)
            }
            Formula::Among(..) | Formula::Instance(_) => true,
            Formula::Not(f) | Formula::Some(_, f) | Formula::One(_, f) => {
                self.formula(f, &|_, order| order == 0)
            }
            Formula::Or(all) => all.iter().all(|f| self.formula(f, &|_, order| order == 0)),
            Formula::Iff(a, b) => [a, b].into_iter().all(|f| self.formula(f, &|_, order| order == 0)),
            Formula::Word(of) => of.of.iter().all(|item| match item {
                Item::Function(f, _) => !self.function(f),
                Item::Expression(t, _, _) | Item::Real(t) => self.free(t),
                Item::Coefficients(_) => false,
                Item::Int(_) => true,
            }),
            Formula::Claim { .. } => false,
        }
    }
}

/// A sum of names, each with how often, and a number.
struct Linear<'t> {
    names: Vec<(&'t Name, i64)>,
    constant: i64,
}

impl<'t> Linear<'t> {
    fn number(constant: i64) -> Self {
        Self { names: Vec::new(), constant }
    }

    fn minus(mut self, other: Self) -> Self {
        self.constant -= other.constant;
        for (name, count) in other.names {
            match self.names.iter_mut().find(|(own, _)| *own == name) {
                Some((_, own)) => *own -= count,
                None => self.names.push((name, -count)),
            }
        }
        self.names.retain(|(_, count)| *count != 0);
        self
    }
}

/// Every name of a coefficient, a real or a definition in a term.
fn walk<'t>(t: &'t Real, see: &mut dyn FnMut(&'t Name)) {
    match t {
        Real::Coefficient(name, _) | Real::Bound(name) | Real::Defined(name, _) => see(name),
        Real::Whole(i) => walk_int(i, see),
        Real::Number(_)
        | Real::Index(_)
        | Real::Ratio
        | Real::Infinity
        | Real::Knot(_)
        | Real::Parameter(..) => {}
        Real::Plus(a, b)
        | Real::Minus(a, b)
        | Real::Times(a, b)
        | Real::Over(a, b)
        | Real::Least(a, b)
        | Real::Greatest(a, b) => {
            walk(a, see);
            walk(b, see);
        }
        Real::Negated(a) | Real::Power(a, _) | Real::Absolute(a) | Real::Root(a) | Real::Fold(_, _, a) => {
            walk(a, see)
        }
        Real::Value(f, argument) => {
            let Argument { at, member, .. } = &**argument;
            walk(at, see);
            if let Some(Member::Index(t) | Member::Ratio(t) | Member::Parameter(_, t)) = member {
                walk(t, see);
            }
            walk_function(f, see);
        }
        Real::Word(of) => walk_word(of, see),
    }
}

/// In integers names of this kind occur inside of words only.
fn walk_int<'t>(t: &'t Int, see: &mut dyn FnMut(&'t Name)) {
    match t {
        Int::Word(of) => walk_word(of, see),
        Int::Plus(a, b)
        | Int::Minus(a, b)
        | Int::Times(a, b)
        | Int::Least(a, b)
        | Int::Greatest(a, b)
        | Int::Binomial(a, b) => {
            walk_int(a, see);
            walk_int(b, see);
        }
        Int::Number(_) | Int::Bound(_) | Int::Degree | Int::Last | Int::M => {}
    }
}

fn walk_word<'t>(of: &'t Use, see: &mut dyn FnMut(&'t Name)) {
    for item in &of.of {
        match item {
            Item::Function(f, _) => walk_function(f, see),
            Item::Expression(t, _, _) | Item::Real(t) => walk(t, see),
            Item::Coefficients(name) => see(name),
            Item::Int(i) => walk_int(i, see),
        }
    }
}

fn walk_function<'t>(f: &'t Function, see: &mut dyn FnMut(&'t Name)) {
    match f {
        Function::Defined(name, _) => see(name),
        Function::Derivative(f, _) => walk_function(f, see),
        Function::Phi { from, to, .. } => {
            walk(from, see);
            walk(to, see);
        }
        Function::Basis { .. } | Function::Weight { .. } => {}
    }
}

/// 0, or a unit vector.
pub(super) fn unit(count: usize, unit: Option<usize>) -> Vec<BigRational> {
    (0..count).map(|i| integer(usize::from(Some(i) == unit))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::language::one_line;

    #[test]
    fn so_many_numbers_decide_a_polynomial() {
        for (text, expected) in [
            ("k; U; d points; c; x in [t[0], t[m]] : sum(i in 0..n: (d[i]+c)*G[i](x)) = c", Some(1)),
            ("k; U; c; x in [t[0], t[m]] : sum(i in 0..n: c^2*G[i](x)) = c", Some(2)),
            (
                "k; U; c; x in [t[0], t[m]] : (c - x)^k = sum(i in 0..n: prod(l in i+1..i+k: c - t[l])*G[i](x))",
                Some(3),
            ),
            ("k; U; c; x in [t[0], t[m]] : sum(i in 0..n: prod(l in 1..i: c - t[l])*G[i](x)) = 0", None),
            ("k; U; c; x in [t[0], t[m]] : c*G[0](x) >= 0", None),
            ("k; U; c; x in [t[0], c] : G[0](x) = c", None),
            ("k; U; c | c > 0 : G[0](t[0]) = c", None),
            ("k; U; s > 0; x in [t[0], t[m]] : G[0](x; r = s) = G[0](x)", None),
        ] {
            let name = if text.contains("; c") { "c" } else { "s" };
            let found = degree_in(&name.into(), &one_line(text).unwrap(), &[], Some((3, 9)));
            assert_eq!(found, expected, "{text}");
        }
    }
}
