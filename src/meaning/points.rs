//! Control values: all of them where a conclusion is linear in them, and some otherwise.

use crate::language::{
    Argument, Binder, Definition, Formula, Function, Int, Interval, Item, Name, Real, Relation, Sentence, Use,
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
    affine_in(&names, sentence, definitions)
}

/// Is it for one name of a number decided by 0 and 1? No interval may depend on that.
pub(super) fn decided_by_two(name: &Name, sentence: &Sentence, definitions: &[Definition]) -> bool {
    let names = std::slice::from_ref(name);
    let order = Order { names, definitions };
    let free = sentence.given.iter().all(|binder| match binder {
        Binder::Point(_, Interval { from, to, .. }) => order.free(from) && order.free(to),
        Binder::Gaps(_) => false,
        _ => true,
    });
    free && affine_in(names, sentence, definitions)
}

fn affine_in(names: &[Name], sentence: &Sentence, definitions: &[Definition]) -> bool {
    let order = Order { names, definitions };
    let bodies = || definitions.iter().filter(|definition| order.mentions(&definition.name));
    bodies().all(|definition| order.real(&definition.body) <= 1)
        && sentence.assume.iter().all(|f| order.formula(f, &|_, order| order == 0))
        && sentence.then.iter().all(|f| order.formula(f, &|equal, order| order == 0 || (equal && order == 1)))
}

/// The order of a term as a polynomial in the control values; [`Order::BEYOND`], if it is none.
struct Order<'a> {
    names: &'a [Name],
    definitions: &'a [Definition],
}

impl Order<'_> {
    const BEYOND: usize = 9;

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
            Real::Fold(crate::language::Fold::Sum, _, body) => self.real(body),
            // A derivative is as linear as its function, which may stand for control values.
            Real::Value(f, argument) if self.real(&argument.at) == 0 => usize::from(self.function(f)),
            _ => {
                if self.free(t) {
                    0
                } else {
                    Self::BEYOND
                }
            }
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
            let Argument { at, .. } = &**argument;
            walk(at, see);
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

/// 0 and the unit vectors.
pub(super) fn units(count: usize) -> impl Iterator<Item = Vec<BigRational>> {
    let unit = move |unit: usize| (0..count).map(|i| integer(usize::from(i == unit))).collect();
    std::iter::once(count).chain(0..count).map(unit)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::language::one_line;

    #[test]
    fn two_numbers_decide_what_is_affine_in_one() {
        for (text, expected) in [
            ("k; U; d points; c; x in [t[0], t[m]] : sum(i in 0..n: (d[i]+c)*G[i](x)) = c", true),
            ("k; U; c; x in [t[0], t[m]] : sum(i in 0..n: c^2*G[i](x)) = c", false),
            ("k; U; c; x in [t[0], t[m]] : c*G[0](x) >= 0", false),
            ("k; U; c; x in [t[0], c] : G[0](x) = c", false),
            ("k; U; c | c > 0 : G[0](t[0]) = c", false),
        ] {
            assert_eq!(decided_by_two(&"c".into(), &one_line(text).unwrap(), &[]), expected, "{text}");
        }
    }
}
