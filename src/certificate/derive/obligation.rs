//! A sentence as obligations: each has one conclusion, the integers that it runs over, and one point x.

use std::cmp::Ordering;

use crate::language::{
    Adjective, Argument, Binder, Claim, Definition, Form, Formula, Function, Int, Interval, Item, Member,
    Name, Over, Range, Real, Relation, Row, Sentence, Use, Word,
};

use super::NoWindow;
use super::index::Index;
use super::place::Place;

/// What x stands for.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Point {
    /// A real of this name.
    Bound(Name),
    /// This knot.
    Knot(Int),
    /// There is none: functions are taken at whatever they say.
    Any,
}

/// What a sentence is about.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Subject<'a> {
    /// All knots.
    Knots,
    /// An example.
    Example(&'a Row),
    /// No knots at all.
    Weights,
}

/// What a sentence is about in degree k.
pub(super) fn subjects<'a>(
    sentence: &Sentence,
    claim: Claim<'a>,
    k: usize,
) -> Result<Vec<Subject<'a>>, NoWindow> {
    let instances = sentence.given.iter().find_map(|binder| match binder {
        Binder::Instances(names) => Some(names),
        _ => None,
    });
    if let Some(names) = instances {
        let rows = claim.paper.rows_of(names).filter(|row| row.degree == k);
        return match rows.map(Subject::Example).collect::<Vec<_>>() {
            none if none.is_empty() => Err(NoWindow::because(format!("no example has degree {k}"))),
            found => Ok(found),
        };
    }
    let about_knots =
        |binder: &Binder| matches!(binder, Binder::Knots(_) | Binder::Gaps(_) | Binder::Degree { .. });
    match sentence.given.iter().any(about_knots) {
        true => Ok(vec![Subject::Knots]),
        false if k == 1 => Ok(vec![Subject::Weights]),
        false => Err(NoWindow::because("a sentence about weights stands for degree 1")),
    }
}

/// One thing to show.
#[derive(Debug, Clone)]
pub(super) struct Obligation<'a> {
    pub(super) integers: Vec<Range>,
    /// Reals other than x, with their sign or interval.
    pub(super) reals: Vec<(Name, Option<Relation>, Option<Interval>)>,
    pub(super) assume: Vec<Formula>,
    /// Knots t_a = t_b.
    pub(super) coincide: Vec<(Int, Int)>,
    pub(super) claim: Formula,
    pub(super) point: Point,
    pub(super) symmetric: bool,
    /// Every knot occurs once.
    simple: bool,
    /// Every knot inside occurs k times at most.
    inner: bool,
    /// Knots inside are no k + 1 of k+1, …, n.
    interior: bool,
    /// What is assumed of α.
    pub(super) side: Option<Ordering>,
    /// Other indices.
    pub(super) indices: Vec<Name>,
    /// In the place of all this: the orders of functions of a degree where they begin.
    pub(super) orders: Option<i64>,
    pub(super) definitions: &'a [Definition],
}

/// What is known on the way down a sentence.
#[derive(Debug, Clone)]
struct Given<'a> {
    k: usize,
    subject: Subject<'a>,
    integers: Vec<Range>,
    reals: Vec<(Name, Option<Relation>, Option<Interval>)>,
    assume: Vec<Formula>,
    adjectives: Vec<Adjective>,
    indices: Vec<Name>,
    /// The knot that is looked at, where the conclusion names no x.
    at: Option<Int>,
}

/// The name of x where it stands for a knot: none that can be written.
pub(super) fn point_name() -> Name {
    "x of the point".into()
}

/// The obligations of a sentence, in its order.
pub(super) fn obligations<'a>(
    sentence: &Sentence,
    definitions: &'a [Definition],
    claim: Claim<'a>,
    k: usize,
    subject: Subject<'a>,
) -> Result<Vec<Obligation<'a>>, NoWindow> {
    let mut all = Vec::new();
    if !says_of(sentence, k) {
        return Err(NoWindow::because(format!("it says nothing of degree {k}")));
    }
    let (integers, reals, assume, adjectives, indices) = Default::default();
    let given = Given { k, subject, integers, reals, assume, adjectives, indices, at: None };
    below(sentence, &given, definitions, claim, &mut all)?;
    Ok(all)
}

/// Does it speak of a degree?
fn says_of(sentence: &Sentence, k: usize) -> bool {
    sentence.given.iter().all(|binder| match binder {
        Binder::Degree { least, most } => *least <= k && most.is_none_or(|most| k <= most),
        _ => true,
    })
}

fn below<'a>(
    sentence: &Sentence,
    given: &Given<'a>,
    definitions: &'a [Definition],
    claim: Claim<'a>,
    all: &mut Vec<Obligation<'a>>,
) -> Result<(), NoWindow> {
    let mut given = given.clone();
    let mut knots = given.subject == Subject::Weights;
    for binder in &sentence.given {
        match binder {
            Binder::Degree { .. } | Binder::Points(_) => {}
            Binder::Index(name) => given.indices.push(name.clone()),
            Binder::Knots(adjectives) => {
                knots = true;
                given.adjectives.extend(adjectives);
                given.assume.extend(adjectives.iter().flat_map(|adjective| formulas(*adjective)));
            }
            Binder::Integer(range) => given.integers.push(range.clone()),
            Binder::Point(name, interval) => given.reals.push((name.clone(), None, Some(interval.clone()))),
            Binder::Real { name, sign } => given.reals.push((name.clone(), *sign, None)),
            Binder::Instances(names) => match given.subject {
                Subject::Example(row) if row.name.as_ref().is_some_and(|name| names.contains(name)) => {
                    knots = true;
                }
                _ => return Err(NoWindow::because("it is about other examples")),
            },
            // Without these more is shown.
            Binder::Indices(_) => {}
            Binder::Gaps(_) => return Err(NoWindow::because("it is about gaps")),
        }
    }
    if !knots {
        return Err(NoWindow::because("it is not about all knots"));
    }
    given.assume.extend(sentence.assume.iter().cloned());
    sentence.then.iter().try_for_each(|f| conclusion(f, &given, definitions, claim, all))
}

fn conclusion<'a>(
    f: &Formula,
    given: &Given<'a>,
    definitions: &'a [Definition],
    claim: Claim<'a>,
    all: &mut Vec<Obligation<'a>>,
) -> Result<(), NoWindow> {
    let mut with = given.clone();
    match f {
        Formula::All(Over::Integers(range), body) => {
            with.integers.push(range.clone());
            conclusion(body, &with, definitions, claim, all)
        }
        Formula::All(Over::Reals(name, interval), body) => {
            with.reals.push((name.clone(), None, Some(interval.clone())));
            conclusion(body, &with, definitions, claim, all)
        }
        Formula::And(parts) => parts.iter().try_for_each(|f| conclusion(f, given, definitions, claim, all)),
        Formula::Implies(a, b) => implied(a, b, given, definitions, claim, all),
        Formula::Iff(a, b) => {
            implied(a, b, given, definitions, claim, all)?;
            implied(b, a, given, definitions, claim, all)
        }
        Formula::Word(said) if matches!(said.word, Word::Smooth | Word::Rational) => {
            let [Item::Expression(t, name, Some(interval))] = said.of.as_slice() else {
                return Err(NoWindow::because("an expression without an interval"));
            };
            if said.word == Word::Rational && !between_neighbours(interval) {
                return Err(NoWindow::because("an interval that is not from one knot to the next"));
            }
            with.reals.push((name.clone(), None, Some(interval.clone())));
            let said = Formula::Word(Box::new(Use { word: said.word, of: vec![Item::Real(t.clone())] }));
            all.push(obligation(said, &with, definitions)?);
            Ok(())
        }
        Formula::Chain(Real::Whole(Int::Word(counted)), rest) if counted.word == Word::Rank => {
            rank(&counted.of, rest, given, definitions, all)
        }
        Formula::Chain(first, rest) => {
            let mut left = first;
            for (relation, right) in rest {
                let atom = Formula::Chain(left.clone(), vec![(*relation, right.clone())]);
                all.push(obligation(atom, given, definitions)?);
                left = right;
            }
            Ok(())
        }
        Formula::Within(t, Interval { from, from_closed, to, to_closed }) => {
            let relation = |closed: bool| if closed { Relation::AtMost } else { Relation::Less };
            for (a, closed, b) in [(from, *from_closed, t), (t, *to_closed, to)] {
                let atom = Formula::Chain(a.clone(), vec![(relation(closed), b.clone())]);
                all.push(obligation(atom, given, definitions)?);
            }
            Ok(())
        }
        Formula::Claim { id, printed } => {
            let other = Claim::of(claim.paper).find(|other| other.id() == &**id);
            let Some(other) = other else { return Err(NoWindow::because(format!("there is no claim {id}"))) };
            let form = if *printed { Form::Printed } else { other.strongest() };
            match other.sentence(form) {
                Some(sentence) if !says_of(sentence, given.k) => Ok(()),
                Some(sentence) => below(sentence, given, other.definitions, other, all),
                None => Err(NoWindow::because(format!("{id} is said in words"))),
            }
        }
        _ => {
            all.push(obligation(f.clone(), given, definitions)?);
            Ok(())
        }
    }
}

/// Does a formula take an index for a number that may be ∞? Then it may not exist.
fn may_be_infinite(assume: &[Formula]) -> bool {
    let mut found = Found::default();
    assume.iter().for_each(|f| found.formula(f));
    let finite = |name: &&Name| {
        assume.contains(&Formula::Chain(
            Real::Index((*name).clone()),
            vec![(Relation::Unequal, Real::Infinity)],
        ))
    };
    !found.numbers.iter().all(finite)
}

/// Does it speak of an index?
pub(super) fn names_an_index(f: &Formula) -> bool {
    let mut found = Found::default();
    found.formula(f);
    found.indices
}

/// From t_J to t_{J+1}?
fn between_neighbours(interval: &Interval) -> bool {
    match (&interval.from, &interval.to) {
        (Real::Knot(i), Real::Knot(Int::Plus(j, one))) => **j == *i && **one == Int::Number(1),
        _ => false,
    }
}

/// The rank of degree d is the number of i with t_i < t_{i+d+1}: the others are 0, and those that begin at one knot have different
/// orders there. So it is n + k − d + 1 if all are; and two less if all are but the first and the last one.
fn rank<'a>(
    of: &[Item],
    rest: &[(Relation, Real)],
    given: &Given<'a>,
    definitions: &'a [Definition],
    all: &mut Vec<Obligation<'a>>,
) -> Result<(), NoWindow> {
    let uncounted = || NoWindow::because("a rank that is not counted");
    let ([Item::Int(d)], [(Relation::Equal, Real::Whole(count))]) = (of, rest) else {
        return Err(uncounted());
    };
    let k = i64::try_from(given.k).map_err(|_| uncounted())?;
    let (d, count) = (plain(d, k).ok_or_else(uncounted)?, plain(count, k).ok_or_else(uncounted)?);
    let d = (0..=k).find(|known| Index::number(*known) == d).ok_or_else(uncounted)?;
    let left_out = |c: i64| count.minus(&Index::last(k - d + 1 - 2 * c)) == Index::number(0);
    let ends = [0, 1].into_iter().find(|c| left_out(*c)).ok_or_else(uncounted)?;
    let plus = |a: Int, b: i64| Int::Plus(Box::new(a), Box::new(Int::Number(b)));
    let mut push = |a: Int, relation, b: Int, with: Given<'a>| {
        let said = Formula::Chain(Real::Knot(a.clone()), vec![(relation, Real::Knot(b))]);
        all.push(obligation(said, &Given { at: Some(a), ..with }, definitions)?);
        Ok::<_, NoWindow>(())
    };
    let name: Name = "i of the rank".into();
    let range = Range { name: name.clone(), from: Int::Number(ends), to: plus(Int::Last, k - d - ends) };
    let mut with = given.clone();
    with.integers.push(range);
    push(Int::Bound(name.clone()), Relation::Less, plus(Int::Bound(name), d + 1), with)?;
    if ends > 0 {
        push(Int::Number(0), Relation::Equal, Int::Number(d + 1), given.clone())?;
        push(Int::M, Relation::Equal, plus(Int::Last, k - d), given.clone())?;
    }
    // The orders are shown by themselves, first.
    let at = all.len() - if ends > 0 { 3 } else { 1 };
    let orders = Obligation { orders: Some(d), ..all[at].clone() };
    all.insert(at, orders);
    Ok(())
}

/// An integer that names nothing bound.
fn plain(t: &Int, k: i64) -> Option<Index> {
    Some(match t {
        Int::Number(c) => Index::number(*c),
        Int::Degree => Index::number(k),
        Int::Last => Index::last(0),
        Int::M => Index::last(k + 1),
        Int::Plus(a, b) => plain(a, k)?.plus(&plain(b, k)?),
        Int::Minus(a, b) => plain(a, k)?.minus(&plain(b, k)?),
        _ => return None,
    })
}

/// a ⇒ b; not b ⇒ not a, if only a is about functions.
fn implied<'a>(
    a: &Formula,
    b: &Formula,
    given: &Given<'a>,
    definitions: &'a [Definition],
    claim: Claim<'a>,
    all: &mut Vec<Obligation<'a>>,
) -> Result<(), NoWindow> {
    let mut with = given.clone();
    let about_functions = |f: &Formula| {
        let mut found = Found::default();
        found.formula(f);
        found.functions
    };
    if about_functions(a) && !about_functions(b) {
        with.assume.push(negated(b));
        conclusion(&negated(a), &with, definitions, claim, all)
    } else {
        with.assume.push(a.clone());
        conclusion(b, &with, definitions, claim, all)
    }
}

fn negated(f: &Formula) -> Formula {
    match f {
        Formula::Not(f) => (**f).clone(),
        Formula::Chain(a, rest) if rest.len() == 1 => {
            let opposite = |relation: &Relation| match relation {
                Relation::Equal => Relation::Unequal,
                Relation::Unequal => Relation::Equal,
                Relation::Less => Relation::AtLeast,
                Relation::AtLeast => Relation::Less,
                Relation::Greater => Relation::AtMost,
                Relation::AtMost => Relation::Greater,
            };
            let rest = rest.iter().map(|(relation, b)| (opposite(relation), b.clone()));
            Formula::Chain(a.clone(), rest.collect())
        }
        f => Formula::Not(Box::new(f.clone())),
    }
}

fn obligation<'a>(
    claim: Formula,
    given: &Given<'a>,
    definitions: &'a [Definition],
) -> Result<Obligation<'a>, NoWindow> {
    let mut found = Found::default();
    found.formula(&claim);
    let point =
        match (given.subject, given.at.clone().map_or_else(|| found.point(given), |i| Ok(Point::Knot(i)))) {
            (Subject::Knots, point) => point?,
            (Subject::Example(_), Ok(Point::Bound(name))) => Point::Bound(name),
            _ => Point::Any,
        };
    let mut assume = given.assume.clone();
    if let Point::Knot(i) = &point {
        let x = Real::Bound(point_name());
        assume.insert(0, Formula::Chain(x, vec![(Relation::Equal, Real::Knot(i.clone()))]));
    }
    let mut reals = Vec::new();
    for (name, sign, interval) in &given.reals {
        if let Some(interval) = interval {
            assume.push(Formula::Within(Real::Bound(name.clone()), interval.clone()));
        }
        if point != Point::Bound(name.clone()) {
            reals.push((name.clone(), *sign, interval.clone()));
        }
    }
    let coincide = assume.iter().filter_map(coinciding).collect();
    let side = match may_be_infinite(&assume) {
        false => assume.iter().find_map(side),
        true if given.subject == Subject::Knots => {
            return Err(NoWindow::because("a hypothesis takes an index for a number that may be infinite"));
        }
        true => None,
    };
    let integers = given.integers.clone();
    let is = |adjective| given.adjectives.contains(&adjective);
    let (symmetric, simple) = (is(Adjective::Symmetric), is(Adjective::Simple));
    // More than k of the indices 1, …, n+k in a row hold one of k+1, …, n, or both k and n+1.
    let interior = is(Adjective::Interior) && assume.contains(&apart());
    let inner = is(Adjective::Inner) || interior;
    Ok(Obligation {
        integers,
        reals,
        assume,
        coincide,
        claim,
        point,
        symmetric,
        simple,
        inner,
        interior,
        side,
        indices: given.indices.clone(),
        orders: None,
        definitions,
    })
}

fn side(f: &Formula) -> Option<Ordering> {
    let Formula::Chain(Real::Index(name), rest) = f else { return None };
    match rest.as_slice() {
        _ if &**name != "alpha" => None,
        [(Relation::Equal, Real::Infinity)] => Some(Ordering::Equal),
        [(Relation::Less, Real::Whole(Int::Number(0)))] => Some(Ordering::Less),
        [(Relation::Greater, Real::Whole(Int::Number(1)))] => Some(Ordering::Greater),
        _ => None,
    }
}

impl Obligation<'_> {
    /// So often x occurs at most.
    pub(super) fn most_inside(&self, k: i64, place: Place) -> i64 {
        match place {
            _ if self.simple => 1,
            Place::Knot(_) if self.inner => k,
            // k + 2 copies of t_0 have t_{k+1} among them, which is among t_{k+1}, …, t_n; so for t_m.
            Place::First(_) | Place::Last(_) if self.interior => k + 1,
            _ => i64::MAX,
        }
    }

    /// Is a real compared, an end, or what a function is taken at, and not only part of a term?
    pub(super) fn stands_alone(&self, name: &Name) -> bool {
        let mut found = Found::default();
        self.assume.iter().chain([&self.claim]).for_each(|f| found.formula(f));
        found.alone.contains(&name)
    }

    /// Does a hypothesis speak of x?
    pub(super) fn names_the_point(&self, f: &Formula) -> bool {
        let mut found = Found::default();
        found.formula(f);
        let named = |name: &Name| found.names.contains(&name);
        match &self.point {
            Point::Any => false,
            Point::Bound(name) => named(name),
            Point::Knot(i) => named(&point_name()) || found.knots.contains(&i),
        }
    }
}

/// a and b of t_a = t_b.
fn coinciding(f: &Formula) -> Option<(Int, Int)> {
    match f {
        Formula::Chain(Real::Knot(a), rest) => match rest.as_slice() {
            [(Relation::Equal, Real::Knot(b))] => Some((a.clone(), b.clone())),
            _ => None,
        },
        _ => None,
    }
}

/// What an adjective of U says, as far as places need it: the others are left out, and more is shown.
fn formulas(adjective: Adjective) -> Vec<Formula> {
    let minus = |a: Int, b: Int| Int::Minus(Box::new(a), Box::new(b));
    let plus_one = |a: Int| Int::Plus(Box::new(a), Box::new(Int::Number(1)));
    let twice = || Int::Times(Box::new(Int::Number(2)), Box::new(Int::Degree));
    let chain = |a: Real, relation, b: Real| Formula::Chain(a, vec![(relation, b)]);
    let knots = |a: Int, relation, b: Int| chain(Real::Knot(a), relation, Real::Knot(b));
    let mut all = match adjective {
        Adjective::Open | Adjective::Clamped | Adjective::Bernstein => vec![
            knots(Int::Number(0), Relation::Equal, Int::Degree),
            knots(minus(Int::M, Int::Degree), Relation::Equal, Int::M),
            chain(Real::Whole(Int::M), Relation::AtLeast, Real::Whole(twice())),
            apart(),
        ],
        _ => Vec::new(),
    };
    match adjective {
        Adjective::Clamped => all.extend([
            knots(Int::Degree, Relation::Less, plus_one(Int::Degree)),
            knots(Int::Last, Relation::Less, plus_one(Int::Last)),
        ]),
        Adjective::Bernstein => {
            all.push(chain(Real::Whole(Int::M), Relation::Equal, Real::Whole(plus_one(twice()))));
        }
        _ => {}
    }
    all
}

/// t_k < t_{m−k}.
fn apart() -> Formula {
    let right = Real::Knot(Int::Minus(Box::new(Int::M), Box::new(Int::Degree)));
    Formula::Chain(Real::Knot(Int::Degree), vec![(Relation::Less, right)])
}

/// The arguments of functions in a formula.
#[derive(Default)]
struct Found<'f> {
    arguments: Vec<&'f Real>,
    names: Vec<&'f Name>,
    knots: Vec<&'f Int>,
    /// Names that are no part of a term.
    alone: Vec<&'f Name>,
    functions: bool,
    /// An index, or another member by one.
    indices: bool,
    /// Indices that are numbers.
    numbers: Vec<&'f Name>,
}

impl<'f> Found<'f> {
    fn point(&self, given: &Given<'_>) -> Result<Point, NoWindow> {
        let bound = |name: &Name| given.reals.iter().any(|(known, ..)| known == name);
        let mut inside = Found::default();
        self.arguments.iter().for_each(|argument| inside.real(argument));
        let mut names = inside.names.into_iter().filter(|name| bound(name));
        let knot = |argument: &Real| if let Real::Knot(i) = argument { Some(i.clone()) } else { None };
        let only = |mut all: Vec<Name>| {
            all.dedup();
            if all.len() == 1 { all.pop() } else { None }
        };
        if let Some(name) = names.next() {
            let others = names.any(|other| other != name);
            return if others {
                Err(NoWindow::because("functions at several points"))
            } else {
                Ok(Point::Bound(name.clone()))
            };
        }
        match self.arguments.split_first() {
            Some((first, rest)) => match knot(first) {
                Some(i) if rest.iter().all(|other| knot(other).as_ref() == Some(&i)) => Ok(Point::Knot(i)),
                _ => Err(NoWindow::because("functions at several points")),
            },
            // Nothing but knots and x is compared.
            None => {
                let named =
                    self.names.iter().filter(|name| bound(name)).map(|name| (*name).clone()).collect();
                let in_intervals = given.reals.iter().filter(|(_, _, interval)| interval.is_some());
                match only(named).or_else(|| only(in_intervals.map(|(name, ..)| name.clone()).collect())) {
                    Some(name) => Ok(Point::Bound(name)),
                    None => Err(NoWindow::because("there is no point x")),
                }
            }
        }
    }

    /// A side of a comparison, an end, an argument.
    fn whole(&mut self, t: &'f Real) {
        if let Real::Bound(name) = t {
            self.alone.push(name);
        }
        self.real(t);
    }

    fn formula(&mut self, f: &'f Formula) {
        match f {
            Formula::Chain(Real::Index(_), rest) if rest.iter().all(|(_, t)| *t == Real::Infinity) => {
                self.indices = true;
            }
            Formula::Chain(first, rest) => {
                self.whole(first);
                rest.iter().for_each(|(_, t)| self.whole(t));
            }
            Formula::Within(t, interval) => {
                self.whole(t);
                self.whole(&interval.from);
                self.whole(&interval.to);
            }
            Formula::Among(a, b, c) => [a, b, c].into_iter().for_each(|i| self.int(i)),
            Formula::Instance(_) | Formula::Claim { .. } => {}
            Formula::Not(f) => self.formula(f),
            Formula::And(all) | Formula::Or(all) => all.iter().for_each(|f| self.formula(f)),
            Formula::Implies(a, b) | Formula::Iff(a, b) => {
                self.formula(a);
                self.formula(b);
            }
            Formula::All(_, body) | Formula::Some(_, body) | Formula::One(_, body) => self.formula(body),
            Formula::Word(of) => self.word(of),
        }
    }

    fn word(&mut self, of: &'f Use) {
        for item in &of.of {
            match item {
                Item::Real(t) | Item::Expression(t, ..) => self.real(t),
                Item::Int(i) => self.int(i),
                Item::Function(..) | Item::Coefficients(_) => {}
            }
        }
        if let ([Item::Real(t)], false) =
            (of.of.as_slice(), matches!(of.word, Word::Defined | Word::Smooth | Word::Rational))
        {
            self.arguments.push(t);
        }
    }

    fn int(&mut self, t: &'f Int) {
        match t {
            Int::Word(of) => self.word(of),
            Int::Plus(a, b)
            | Int::Minus(a, b)
            | Int::Times(a, b)
            | Int::Least(a, b)
            | Int::Greatest(a, b)
            | Int::Binomial(a, b) => {
                self.int(a);
                self.int(b);
            }
            Int::Number(_) | Int::Bound(_) | Int::Degree | Int::Last | Int::M => {}
        }
    }

    fn real(&mut self, t: &'f Real) {
        match t {
            Real::Bound(name) => self.names.push(name),
            Real::Whole(i) => self.int(i),
            Real::Knot(i) => {
                self.knots.push(i);
                self.int(i);
            }
            Real::Index(name) => {
                self.indices = true;
                self.numbers.push(name);
            }
            Real::Number(_) | Real::Ratio | Real::Infinity => {}
            Real::Coefficient(_, of) | Real::Parameter(_, of) | Real::Defined(_, of) => {
                of.iter().for_each(|i| self.int(i))
            }
            Real::Plus(a, b)
            | Real::Minus(a, b)
            | Real::Times(a, b)
            | Real::Over(a, b)
            | Real::Least(a, b)
            | Real::Greatest(a, b) => {
                self.real(a);
                self.real(b);
            }
            Real::Negated(a)
            | Real::Absolute(a)
            | Real::Root(a)
            | Real::Power(a, _)
            | Real::Fold(_, _, a) => {
                self.real(a);
            }
            Real::Value(f, argument) => {
                let Argument { at, member, .. } = &**argument;
                self.indices |= matches!(member, Some(Member::Index(_)));
                self.whole(at);
                self.arguments.push(at);
                self.functions = true;
                self.function(f);
            }
            Real::Word(of) => self.word(of),
        }
    }

    fn function(&mut self, f: &'f Function) {
        match f {
            Function::Derivative(f, _) => self.function(f),
            Function::Phi { from, to, .. } => {
                self.whole(from);
                self.whole(to);
            }
            Function::Basis { .. } | Function::Weight { .. } | Function::Defined(..) => {}
        }
    }
}
