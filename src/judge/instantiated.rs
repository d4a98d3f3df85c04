//! A formula with numbers in the place of names: what a sentence says at its witness.

use crate::language::{Argument, Formula, Function, Int, Interval, Item, Member, Over, Range, Real, Use};
use crate::meaning::Reading;
use crate::scalar::BigRational;

/// The number that a term comes to, if no variable of a sum or of `all` is in it.
fn number(own: &mut Reading<'_>, t: &Real) -> Option<BigRational> {
    own.real(t).ok()?.number().cloned()
}

fn int(own: &mut Reading<'_>, t: &Int) -> Int {
    if let (false, Ok(n)) = (matches!(t, Int::Word(_)), own.int(t)) {
        return Int::Number(n);
    }
    let mut two = |a: &Int, b: &Int| (Box::new(int(own, a)), Box::new(int(own, b)));
    match t {
        Int::Word(of) => Int::Word(Box::new(word(own, of))),
        Int::Plus(a, b) => pair(Int::Plus, two(a, b)),
        Int::Minus(a, b) => pair(Int::Minus, two(a, b)),
        Int::Times(a, b) => pair(Int::Times, two(a, b)),
        Int::Least(a, b) => pair(Int::Least, two(a, b)),
        Int::Greatest(a, b) => pair(Int::Greatest, two(a, b)),
        Int::Binomial(a, b) => pair(Int::Binomial, two(a, b)),
        Int::Number(_) | Int::Bound(_) | Int::Degree | Int::Last | Int::M => t.clone(),
    }
}

fn pair<T>(make: impl Fn(Box<T>, Box<T>) -> T, (a, b): (Box<T>, Box<T>)) -> T {
    make(a, b)
}

pub(super) fn real(own: &mut Reading<'_>, t: &Real) -> Real {
    let arithmetic = matches!(
        t,
        Real::Bound(_)
            | Real::Knot(_)
            | Real::Plus(..)
            | Real::Minus(..)
            | Real::Times(..)
            | Real::Over(..)
            | Real::Negated(_)
    );
    if arithmetic
        && !speaks(t)
        && let Some(q) = number(own, t)
    {
        return literal(q);
    }
    let mut two = |a: &Real, b: &Real| (Box::new(real(own, a)), Box::new(real(own, b)));
    match t {
        Real::Plus(a, b) => pair(Real::Plus, two(a, b)),
        Real::Minus(a, b) => pair(Real::Minus, two(a, b)),
        Real::Times(a, b) => pair(Real::Times, two(a, b)),
        Real::Over(a, b) => pair(Real::Over, two(a, b)),
        Real::Least(a, b) => pair(Real::Least, two(a, b)),
        Real::Greatest(a, b) => pair(Real::Greatest, two(a, b)),
        Real::Whole(i) => Real::Whole(int(own, i)),
        Real::Knot(i) => Real::Knot(int(own, i)),
        Real::Parameter(name, of) => Real::Parameter(name.clone(), of.iter().map(|i| int(own, i)).collect()),
        Real::Coefficient(name, of) => {
            Real::Coefficient(name.clone(), of.iter().map(|i| int(own, i)).collect())
        }
        Real::Defined(name, of) => Real::Defined(name.clone(), of.iter().map(|i| int(own, i)).collect()),
        Real::Negated(a) => Real::Negated(Box::new(real(own, a))),
        Real::Power(a, e) => Real::Power(Box::new(real(own, a)), int(own, e)),
        Real::Absolute(a) => Real::Absolute(Box::new(real(own, a))),
        Real::Root(a) => Real::Root(Box::new(real(own, a))),
        Real::Fold(fold, over, body) => Real::Fold(*fold, range(own, over), Box::new(real(own, body))),
        Real::Value(f, argument) => {
            let Argument { at, side, member: other } = &**argument;
            let member = other.as_ref().map(|other| member(own, other));
            let argument = Argument { at: real(own, at), side: *side, member };
            Real::Value(Box::new(function(own, f)), Box::new(argument))
        }
        Real::Word(of) => Real::Word(Box::new(word(own, of))),
        Real::Number(_) | Real::Bound(_) | Real::Index(_) | Real::Ratio | Real::Infinity => t.clone(),
    }
}

/// A side of a relation: a knot, a control value and a name that stand alone keep their names, and are shown with their values.
pub(super) fn side(own: &mut Reading<'_>, t: &Real) -> Real {
    match t {
        Real::Knot(i) => Real::Knot(int(own, i)),
        _ => real(own, t),
    }
}

fn literal(q: BigRational) -> Real {
    match (q.is_integer(), i64::try_from(q.numer())) {
        (true, Ok(n)) => Real::Whole(Int::Number(n)),
        _ => Real::Number(q),
    }
}

/// Does a term speak of functions, control values or α, which a reader wants to see by name?
fn speaks(t: &Real) -> bool {
    match t {
        Real::Plus(a, b) | Real::Minus(a, b) | Real::Times(a, b) | Real::Over(a, b) => speaks(a) || speaks(b),
        Real::Negated(a) => speaks(a),
        Real::Number(_) | Real::Whole(_) | Real::Bound(_) | Real::Knot(_) => false,
        _ => true,
    }
}

fn member(own: &mut Reading<'_>, other: &Member) -> Member {
    match other {
        Member::Index(t) => Member::Index(real(own, t)),
        Member::Ratio(t) => Member::Ratio(real(own, t)),
        Member::Parameter(name, t) => Member::Parameter(name.clone(), real(own, t)),
        Member::Dual => Member::Dual,
    }
}

fn function(own: &mut Reading<'_>, f: &Function) -> Function {
    match f {
        Function::Basis { i, degree } => {
            let degree = int(own, degree.as_ref().unwrap_or(&Int::Degree));
            Function::Basis { i: int(own, i), degree: Some(degree) }
        }
        Function::Weight { i, degree } => Function::Weight { i: int(own, i), degree: int(own, degree) },
        Function::Phi { cut, from, to } => {
            Function::Phi { cut: *cut, from: real(own, from), to: real(own, to) }
        }
        Function::Defined(name, of) => {
            Function::Defined(name.clone(), of.iter().map(|i| int(own, i)).collect())
        }
        Function::Derivative(f, q) => Function::Derivative(Box::new(function(own, f)), int(own, q)),
    }
}

fn range(own: &mut Reading<'_>, Range { name, from, to }: &Range) -> Range {
    Range { name: name.clone(), from: int(own, from), to: int(own, to) }
}

fn interval(own: &mut Reading<'_>, of: &Interval) -> Interval {
    Interval { from: real(own, &of.from), to: real(own, &of.to), ..of.clone() }
}

fn word(own: &mut Reading<'_>, of: &Use) -> Use {
    let item = |item: &Item| match item {
        Item::Function(f, other) => {
            Item::Function(function(own, f), other.as_ref().map(|other| member(own, other)))
        }
        Item::Expression(t, name, on) => {
            Item::Expression(real(own, t), name.clone(), on.as_ref().map(|on| interval(own, on)))
        }
        Item::Real(t) => Item::Real(real(own, t)),
        Item::Int(i) => Item::Int(int(own, i)),
        Item::Coefficients(name) => Item::Coefficients(name.clone()),
    };
    Use { word: of.word, of: of.of.iter().map(item).collect() }
}

/// The formula with every name that is bound replaced by its number.
pub(super) fn formula(own: &mut Reading<'_>, f: &Formula) -> Formula {
    let mut all = |list: &[Formula]| list.iter().map(|f| formula(own, f)).collect();
    match f {
        Formula::And(list) => Formula::And(all(list)),
        Formula::Or(list) => Formula::Or(all(list)),
        Formula::Chain(first, rest) => {
            let first = side(own, first);
            Formula::Chain(first, rest.iter().map(|(relation, t)| (*relation, side(own, t))).collect())
        }
        Formula::Within(t, on) => Formula::Within(real(own, t), interval(own, on)),
        Formula::Among(j, from, to) => Formula::Among(int(own, j), int(own, from), int(own, to)),
        Formula::Not(f) => Formula::Not(Box::new(formula(own, f))),
        Formula::Implies(a, b) => {
            pair(Formula::Implies, (Box::new(formula(own, a)), Box::new(formula(own, b))))
        }
        Formula::Iff(a, b) => pair(Formula::Iff, (Box::new(formula(own, a)), Box::new(formula(own, b)))),
        Formula::All(over, body) => Formula::All(domain(own, over), Box::new(formula(own, body))),
        Formula::Some(over, body) => Formula::Some(domain(own, over), Box::new(formula(own, body))),
        Formula::One(over, body) => Formula::One(domain(own, over), Box::new(formula(own, body))),
        Formula::Word(of) => Formula::Word(Box::new(word(own, of))),
        Formula::Instance(_) | Formula::Claim { .. } => f.clone(),
    }
}

fn domain(own: &mut Reading<'_>, over: &Over) -> Over {
    match over {
        Over::Integers(integers) => Over::Integers(range(own, integers)),
        Over::Reals(name, on) => Over::Reals(name.clone(), interval(own, on)),
    }
}

/// The words in a part of a sentence, each once.
pub(super) fn words(f: &Formula) -> Vec<String> {
    fn add(all: &mut Vec<String>, of: &Use) {
        let name = of.word.name().to_owned();
        if !all.contains(&name) {
            all.push(name);
        }
    }
    fn of_real(all: &mut Vec<String>, t: &Real) {
        match t {
            Real::Whole(Int::Word(of)) | Real::Word(of) => add(all, of),
            Real::Plus(a, b) | Real::Minus(a, b) | Real::Times(a, b) | Real::Over(a, b) => {
                of_real(all, a);
                of_real(all, b);
            }
            _ => {}
        }
    }
    fn of(all: &mut Vec<String>, f: &Formula) {
        match f {
            Formula::Chain(first, rest) => {
                std::iter::once(first).chain(rest.iter().map(|(_, t)| t)).for_each(|t| of_real(all, t));
            }
            Formula::And(list) | Formula::Or(list) => list.iter().for_each(|f| of(all, f)),
            Formula::Not(f) | Formula::All(_, f) | Formula::Some(_, f) | Formula::One(_, f) => of(all, f),
            Formula::Implies(a, b) | Formula::Iff(a, b) => {
                of(all, a);
                of(all, b);
            }
            Formula::Word(word) => add(all, word),
            Formula::Within(..) | Formula::Among(..) | Formula::Instance(_) | Formula::Claim { .. } => {}
        }
    }
    let mut all = Vec::new();
    of(&mut all, f);
    all
}
