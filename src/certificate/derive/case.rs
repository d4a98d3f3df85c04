//! What a formula says at a place: decided by the place, or goals on the window, or not to be said there.

use std::collections::BTreeMap;

use crate::certificate::evaluate::sign;
use crate::certificate::statement::{Gap, Window};
use crate::certificate::term::{self, OfWeight, Term, Where};
use crate::certificate::weights::{Class, Weighted};
use crate::language::{
    Argument, Definition, Fold, Formula, Function, Int, Interval, Item, Member, Name, Over, Pattern, Range,
    Real, Relation, Row, Side, Use, Word,
};
use crate::scalar::{BigRational, Multivariate, Quotient, RationalAlgebra, Ring, integer};

use super::index::{Contradiction, Facts, Index};
use super::place::{Copies, Place, Size};
use super::ratios::Ratios;

/// Why there is no value here.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Stop {
    /// The place does not tell.
    Undecided(String),
    /// It speaks of what may not exist.
    Undefined(String),
}

pub(super) type Known<T> = Result<T, Stop>;

pub(super) fn undecided<T>(why: impl Into<String>) -> Known<T> {
    Err(Stop::Undecided(why.into()))
}

/// What a formula is here.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Truth {
    False,
    /// All of these; none: true.
    Goals(Vec<term::Formula>),
    Not(Stop),
}

impl Truth {
    const TRUE: Self = Self::Goals(Vec::new());

    fn of(known: Option<bool>, what: &str) -> Self {
        match known {
            Some(true) => Self::TRUE,
            Some(false) => Self::False,
            None => Self::Not(Stop::Undecided(what.to_owned())),
        }
    }

    pub(super) fn is_true(&self) -> bool {
        *self == Self::TRUE
    }

    pub(super) fn and(self, other: Self) -> Self {
        use Truth::{False, Goals, Not};
        match (self, other) {
            (False, _) | (_, False) => False,
            (Not(Stop::Undefined(why)), _) | (_, Not(Stop::Undefined(why))) => Not(Stop::Undefined(why)),
            (Not(stop), _) | (_, Not(stop)) => Not(stop),
            (Goals(mut all), Goals(more)) => {
                all.extend(more);
                Goals(all)
            }
        }
    }

    fn or(self, other: Self) -> Self {
        use Truth::{False, Not};
        match (self, other) {
            (a, b) if a.is_true() || b.is_true() => Self::TRUE,
            (False, other) | (other, False) => other,
            (Not(Stop::Undefined(why)), _) | (_, Not(Stop::Undefined(why))) => Not(Stop::Undefined(why)),
            _ => Not(Stop::Undecided("one of several, and the place does not say which".into())),
        }
    }

    fn not(self) -> Self {
        match self {
            Self::False => Self::TRUE,
            truth if truth.is_true() => Self::False,
            Self::Not(stop) => Self::Not(stop),
            Self::Goals(_) => Self::Not(Stop::Undecided("the opposite of a goal".into())),
        }
    }
}

impl From<Stop> for Truth {
    fn from(stop: Stop) -> Self {
        Self::Not(stop)
    }
}

/// A value: its term, and, where no function is in it, what it is in the parameters.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Value {
    pub(super) term: Term,
    plain: Option<Quotient>,
    /// It is t_{s+e}.
    knot: Option<i64>,
}

impl Value {
    pub(super) fn number(value: BigRational) -> Self {
        Self { plain: Some(Quotient::constant(&value)), term: Term::Number(value), knot: None }
    }

    pub(super) fn plain(&self) -> Option<&Quotient> {
        self.plain.as_ref()
    }

    pub(super) fn whole(value: i64) -> Self {
        Self::number(integer(value))
    }

    pub(super) fn is_zero(&self) -> bool {
        self.plain.as_ref().is_some_and(Ring::is_zero)
    }

    fn is_one(&self) -> bool {
        self.plain.as_ref().is_some_and(|value| *value == value.one())
    }

    fn made(term: Term, of: [&Self; 2], plain: impl Fn(&Quotient, &Quotient) -> Quotient) -> Self {
        let plain = match of.map(|value| value.plain.as_ref()) {
            [Some(a), Some(b)] => Some(plain(a, b)),
            _ => None,
        };
        Self { term, plain, knot: None }
    }

    pub(super) fn plus(self, other: Self) -> Self {
        if self.is_zero() {
            return other;
        }
        if other.is_zero() {
            return self;
        }
        Self::made(Term::Sum(vec![self.term.clone(), other.term.clone()]), [&self, &other], Quotient::plus)
    }

    pub(super) fn minus(self, other: Self) -> Self {
        if other.is_zero() {
            return self;
        }
        let term = Term::Difference(Box::new(self.term.clone()), Box::new(other.term.clone()));
        Self::made(term, [&self, &other], Quotient::minus)
    }

    pub(super) fn times(self, other: Self) -> Self {
        if self.is_zero() || other.is_zero() {
            return Self::whole(0);
        }
        if self.is_one() {
            return other;
        }
        if other.is_one() {
            return self;
        }
        Self::made(
            Term::Product(vec![self.term.clone(), other.term.clone()]),
            [&self, &other],
            Quotient::times,
        )
    }
}

/// The parameters of a section, in the order in which they are met.
#[derive(Debug, Default)]
pub(super) struct Parameters {
    /// Those of the case at hand; first the free reals, which are those of all cases.
    all: Vec<(String, Class)>,
    free: usize,
    /// Those that goals speak of.
    pub(super) kept: Vec<(String, Class)>,
    /// As long as the names that are met stay: what the gaps before a knot of the window come to, that knot, and x.
    sums: BTreeMap<i64, Quotient>,
    knots: BTreeMap<i64, Value>,
    x: Option<Value>,
}

impl Parameters {
    /// All free reals are there.
    pub(super) fn begin(&mut self) {
        self.free = self.all.len();
        self.forget();
    }

    fn forget(&mut self) {
        self.sums.clear();
        self.knots.clear();
        self.x = None;
    }

    /// The end of a case: what its goals speak of is kept.
    pub(super) fn close(&mut self, goals: &[term::Formula]) {
        for (name, class) in &self.all {
            let known = self.kept.iter().any(|(kept, _)| kept == name);
            if !known && goals.iter().any(|goal| goal.names(name)) {
                self.kept.push((name.clone(), *class));
            }
        }
        self.all.truncate(self.free);
        self.forget();
    }

    pub(super) fn value(&mut self, name: String, class: Class) -> Known<Value> {
        let known = self.all.iter().position(|(known, _)| *known == name);
        let before =
            known.map_or_else(|| self.kept.iter().find(|kept| kept.0 == name), |at| self.all.get(at));
        if before.is_some_and(|before| before.1 != class) {
            return undecided(format!("{name} has two signs"));
        }
        let at = match known {
            Some(at) => at,
            None if self.all.len() == Multivariate::VARIABLES => {
                return undecided("more parameters than a section can have");
            }
            None => {
                self.all.push((name.clone(), class));
                self.all.len() - 1
            }
        };
        Ok(Value { term: Term::Named(name), plain: Some(Quotient::variable(at)), knot: None })
    }

    fn class(&self, value: &Quotient) -> Class {
        let classes: Vec<_> = self.all.iter().map(|(_, class)| *class).collect();
        sign(value.numerator(), &classes)
    }
}

/// Where a function is taken.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum At {
    /// At x, or by a limit there.
    Point(Option<Side>),
    /// At t_0 + t_m − x.
    Mirrored,
}

/// What a name of a real is.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Bound {
    Point(At),
    Free(Value),
}

/// The names that are known, innermost last.
#[derive(Debug, Clone, Default)]
pub(super) struct Scope {
    pub(super) integers: Vec<(Name, Index)>,
    pub(super) reals: Vec<(Name, Bound)>,
}

/// The knots, and where x is among them.
#[derive(Debug, Clone)]
pub(super) struct Numbers<'a> {
    pub(super) row: Option<&'a Row>,
    pub(super) x: Option<Value>,
    /// Where x is on its span, if that is not u.
    pub(super) u: Option<Term>,
}

impl<'a> Numbers<'a> {
    pub(super) fn of(row: Option<&'a Row>) -> Self {
        Self { row, x: None, u: None }
    }

    pub(super) fn knots(&self) -> &'a [BigRational] {
        self.row.map_or(&[], |row| &row.knots)
    }

    /// The whole knot vector as a window that counts as it does.
    pub(super) fn window(&self) -> Window {
        let gap = |pair: &[BigRational]| Gap::Term(Term::Number(&pair[1] - &pair[0]));
        Window { name: WINDOW.into(), first: 0, gaps: self.knots().windows(2).map(gap).collect() }
    }
}

/// Another member of the family.
#[derive(Debug, Clone)]
pub(super) enum Other {
    /// That of this r.
    Ratio(Value),
    /// The one that reflection leads to.
    Dual,
}

/// One case at a place: what is known of s and n there, and what the integers are.
pub(super) struct Case<'a> {
    pub(super) k: i64,
    pub(super) place: Place,
    pub(super) definitions: &'a [Definition],
    pub(super) parameters: &'a mut Parameters,
    /// Gaps that are 0 because the sentence says that knots coincide.
    pub(super) zero: Vec<i64>,
    pub(super) facts: Facts,
    pub(super) scope: Scope,
    /// The knots are symmetric.
    pub(super) symmetric: bool,
    /// Integers run around the span of x, or of its mirror image.
    pub(super) mirrored: bool,
    pub(super) weighted: &'a Weighted,
    /// Another member of the family.
    pub(super) other: Option<Other>,
    /// What is known of r and other ratios.
    pub(super) ratios: Ratios,
    /// Functions are values, where knots are numbers.
    pub(super) exact: bool,
    /// The knots, if they are numbers.
    pub(super) numbers: Option<Numbers<'a>>,
    /// Integers beyond what is shown.
    pub(super) beyond: usize,
    /// x is the knot of this index: all from there to t_s are x.
    pub(super) copies_from: Option<Index>,
}

/// The windows by their names.
pub(super) const WINDOW: &str = "W";
pub(super) const MIRROR: &str = "M";
/// The first knot.
const ORIGIN: &str = "o";
/// Higher derivatives are not looked at.
const HIGHEST: usize = 20;
/// A definition that leads on and on.
const DEEPEST: usize = 40;

/// What an integer runs over: what it is, and whether it is surely in the range.
pub(super) type Run = Vec<(Index, bool)>;

impl<'a> Case<'a> {
    pub(super) fn bind_point(&mut self, name: &Name) {
        self.scope.reals.push((name.clone(), Bound::Point(At::Point(None))));
    }

    /// A real that is free, with its sign.
    pub(super) fn free(&mut self, name: &Name, sign: Option<Relation>) -> Known<Value> {
        own_name(name)?;
        let positive = |own: &mut Self| own.parameters.value(name.to_string(), Class::Positive);
        match sign {
            None => self.parameters.value(name.to_string(), Class::Real),
            Some(Relation::Greater) => positive(self),
            Some(Relation::Less) => Ok(positive(self)?.times(Value::whole(-1))),
            Some(_) => undecided("a real of a sign that windows don't have"),
        }
    }

    /// What the comparisons of integers among hypotheses say of s and n.
    pub(super) fn tighten(&mut self, assume: &[Formula]) -> Result<(), Contradiction> {
        loop {
            let before = self.facts.clone();
            for f in assume {
                self.take(f)?;
            }
            if self.facts == before {
                return Ok(());
            }
        }
    }

    fn take(&mut self, f: &Formula) -> Result<(), Contradiction> {
        match f {
            Formula::And(all) => all.iter().try_for_each(|f| self.take(f)),
            Formula::Among(i, from, to) => match (self.int(i), self.int(from), self.int(to)) {
                (Ok(i), Ok(from), Ok(to)) => {
                    self.facts.assume(&i.minus(&from)).and_then(|()| self.facts.assume(&to.minus(&i)))
                }
                _ => Ok(()),
            },
            Formula::Chain(first, rest) => {
                let mut left = first;
                for (relation, right) in rest {
                    if let (Real::Whole(a), Real::Whole(b)) = (left, right)
                        && let (Ok(a), Ok(b)) = (self.int(a), self.int(b))
                    {
                        let (rise, one) = (b.minus(&a), Index::number(1));
                        match relation {
                            Relation::Equal => {
                                self.facts.assume(&rise).and_then(|()| self.facts.assume(&rise.times(-1)))?;
                            }
                            Relation::AtMost => self.facts.assume(&rise)?,
                            Relation::Less => self.facts.assume(&rise.minus(&one))?,
                            Relation::AtLeast => self.facts.assume(&rise.times(-1))?,
                            Relation::Greater => self.facts.assume(&rise.times(-1).minus(&one))?,
                            Relation::Unequal => {}
                        }
                    }
                    left = right;
                }
                Ok(())
            }
            _ => Ok(()),
        }
    }

    /// What t_a = t_b says: the span is none between them, and gaps between them are 0.
    pub(super) fn coincide(&mut self, all: &[(Int, Int)]) -> Result<(), Contradiction> {
        if self.place.on_span().is_none() {
            return Ok(());
        }
        let surely = |own: &Self, v: &Index| own.facts.at_least_zero(v) == Some(true);
        let one = Index::number(1);
        let mut pairs = Vec::new();
        for (a, b) in all {
            let (Ok(a), Ok(b)) = (self.int(a), self.int(b)) else { continue };
            if surely(self, &b.minus(&a)) {
                pairs.push((a, b));
            } else if surely(self, &a.minus(&b)) {
                pairs.push((b, a));
            }
        }
        loop {
            let before = self.facts.clone();
            for (a, b) in &pairs {
                let span = Index::span(0);
                if surely(self, &span.minus(a)) {
                    self.facts.assume(&span.minus(b))?;
                } else if surely(self, &b.minus(&span).minus(&one)) {
                    self.facts.assume(&a.minus(&span).minus(&one))?;
                }
            }
            if self.facts == before {
                break;
            }
        }
        // Before a knot inside, t_0 comes with all its copies.
        if let Place::Knot(Copies::Exactly(q) | Copies::AtLeast(q)) = self.place {
            for (a, b) in &pairs {
                if surely(self, &a.times(-1)) {
                    self.facts.assume(&Index::span(-q).minus(b))?;
                }
            }
        }
        let (from, to) = self.place.shown(self.k);
        for (a, b) in &pairs {
            for e in from..to {
                let between = [Index::span(e).minus(a), b.minus(&Index::span(e + 1))];
                if between.iter().all(|v| surely(self, v)) && !self.zero.contains(&e) {
                    self.zero.push(e);
                    self.parameters.forget();
                }
            }
        }
        let falls = self.zero.iter().any(|e| self.place.gap(*e) == Size::Some);
        if falls { Err(Contradiction) } else { Ok(()) }
    }

    pub(super) fn int(&mut self, t: &Int) -> Known<Index> {
        let mut two = |a: &Int, b: &Int| Ok::<_, Stop>((self.int(a)?, self.int(b)?));
        Ok(match t {
            Int::Number(c) => Index::number(*c),
            Int::Degree => Index::number(self.k),
            Int::Last => Index::last(0),
            Int::M => Index::last(self.k + 1),
            Int::Bound(name) => match self.scope.integers.iter().rev().find(|(known, _)| known == name) {
                Some((_, index)) => index.clone(),
                None => return undecided(format!("the integer {name} is not bound here")),
            },
            Int::Plus(a, b) => two(a, b).map(|(a, b)| a.plus(&b))?,
            Int::Minus(a, b) => two(a, b).map(|(a, b)| a.minus(&b))?,
            Int::Times(a, b) => {
                let (a, b) = two(a, b)?;
                match (self.facts.value(&a), self.facts.value(&b)) {
                    (Some(a), _) => b.times(a),
                    (_, Some(b)) => a.times(b),
                    _ => return undecided("a product of indices"),
                }
            }
            Int::Least(a, b) => self.one_of(a, b, true)?,
            Int::Greatest(a, b) => self.one_of(a, b, false)?,
            Int::Binomial(a, b) => {
                let (a, b) = two(a, b)?;
                match (self.facts.value(&a), self.facts.value(&b)) {
                    (Some(a), Some(b)) => Index::number(binomial(a, b)?),
                    _ => return undecided("a binomial coefficient of indices"),
                }
            }
            Int::Word(of) => self.count(of)?,
        })
    }

    fn one_of(&mut self, a: &Int, b: &Int, least: bool) -> Known<Index> {
        let (a, b) = (self.int(a)?, self.int(b)?);
        match self.facts.at_least_zero(&b.minus(&a)) {
            Some(rises) => Ok(if rises == least { a } else { b }),
            None => match self.facts.at_least_zero(&a.minus(&b)) {
                Some(falls) => Ok(if falls == least { b } else { a }),
                None => undecided("the smaller of two indices"),
            },
        }
    }

    /// How often x occurs among the knots.
    fn count(&mut self, of: &Use) -> Known<Index> {
        let (Word::Multiplicity, [Item::Real(t)]) = (of.word, of.of.as_slice()) else {
            return undecided(format!("the word {}", of.word.name()));
        };
        if let Some(numbers) = &self.numbers {
            let knots = numbers.knots();
            let Some(plain) = self.real(t)?.plain else { return undecided("how often that occurs") };
            let same = |t: &&BigRational| Quotient::constant(t) == plain;
            return Ok(Index::number(i64::try_from(knots.iter().filter(same).count()).unwrap_or(i64::MAX)));
        }
        if !self.is_point(t)? {
            return undecided("the multiplicity of another knot than x");
        }
        match self.place {
            Place::Inside | Place::Before | Place::After => Ok(Index::number(0)),
            Place::First(Copies::Exactly(q))
            | Place::Knot(Copies::Exactly(q))
            | Place::Last(Copies::Exactly(q)) => Ok(Index::number(q)),
            Place::First(Copies::AtLeast(q))
            | Place::Knot(Copies::AtLeast(q))
            | Place::Last(Copies::AtLeast(q)) => {
                // One integer for all of them: the multiplicity is the same wherever it is named.
                Ok(Index::number(q).plus(&Index::beyond(0)))
            }
            Place::Start | Place::End => undecided("how often x occurs"),
        }
    }

    /// Is a term surely x?
    fn is_point(&mut self, t: &Real) -> Known<bool> {
        if let Real::Knot(i) = t
            && self.copies_from.is_some()
            && Some(self.int(i)?) == self.copies_from
        {
            return Ok(true);
        }
        let (value, x) = (self.real(t)?, self.x()?);
        match (value.plain, x.plain) {
            (Some(a), Some(b)) => Ok(a == b),
            _ => Ok(false),
        }
    }

    /// The e of s + e.
    fn relative(&self, i: &Index) -> Option<i64> {
        self.facts.value(&i.minus(&Index::span(0)))
    }

    /// The span of the mirror image of x: n + k − s, and one more for each further copy of a knot.
    fn mirror(&self) -> Known<Index> {
        let span = Index::last(self.k).minus(&Index::span(0));
        match self.place {
            Place::Inside | Place::First(_) | Place::Last(_) => Ok(span),
            Place::Knot(Copies::Exactly(q)) => Ok(span.plus(&Index::number(q))),
            _ => undecided("where the mirror image of x is"),
        }
    }

    /// What an integer runs over: one by one around the span, and far to both sides.
    pub(super) fn run(&mut self, range: &Range) -> Known<Run> {
        let (from, to) = (self.int(&range.from)?, self.int(&range.to)?);
        if let Some(length) = self.facts.value(&to.minus(&from)) {
            return match length {
                ..200 => Ok((0..=length).map(|i| (from.plus(&Index::number(i)), true)).collect()),
                _ => undecided("a range that is too long"),
            };
        }
        let reach = 2 * self.k + 3;
        let mut all = Vec::new();
        if self.place.on_span().is_some() {
            let centre = if self.mirrored { self.mirror()? } else { Index::span(0) };
            all.extend((-reach..=reach).map(|e| centre.plus(&Index::number(e))));
            for (sign, start) in [(-1, -reach - 1), (1, reach + 1)] {
                self.beyond += 1;
                all.push(centre.plus(&Index::number(start)).plus(&Index::beyond(self.beyond).times(sign)));
            }
        } else {
            self.beyond += 1;
            all.push(from.plus(&Index::beyond(self.beyond)));
        }
        let within = |i: &Index| {
            let ends = [i.minus(&from), to.minus(i)].map(|v| self.facts.at_least_zero(&v));
            if ends.contains(&Some(false)) { None } else { Some(ends == [Some(true); 2]) }
        };
        Ok(all.into_iter().filter_map(|i| within(&i).map(|surely| (i, surely))).collect())
    }

    /// Something said with an integer bound, which is in the range from there on.
    pub(super) fn with<T>(
        &mut self,
        range: &Range,
        i: &Index,
        say: impl FnOnce(&mut Self) -> T,
    ) -> Known<Result<T, Contradiction>> {
        let (from, to) = (self.int(&range.from)?, self.int(&range.to)?);
        let facts = self.facts.clone();
        let assumed = self.facts.assume(&i.minus(&from)).and_then(|()| self.facts.assume(&to.minus(i)));
        let said = assumed.map(|()| {
            self.scope.integers.push((range.name.clone(), i.clone()));
            let said = say(self);
            self.scope.integers.pop();
            said
        });
        self.facts = facts;
        Ok(said)
    }

    /// x.
    pub(super) fn x(&mut self) -> Known<Value> {
        if let Some(numbers) = &self.numbers {
            return numbers.x.clone().map_or_else(|| undecided("there is no x"), Ok);
        }
        let Some(at) = self.place.on_span() else {
            return self.parameters.value("outside".into(), Class::Real);
        };
        if let Some(x) = &self.parameters.x {
            return Ok(x.clone());
        }
        let origin = self.parameters.value(ORIGIN.into(), Class::Real)?;
        let u = self.parameters.value("u".into(), Class::Positive)?;
        let (start, end) = (self.gaps(0)?, self.gaps(1)?);
        let plain = match (at, start, end, u.plain) {
            (Where::From, start, ..) => start,
            (Where::To, _, end, _) => end,
            (Where::In, start, end, Some(u)) => match start.plus(&u.times(&end)).over(&u.plus(&u.one())) {
                Some(x) => x,
                None => return undecided("1 + u"),
            },
            (Where::In, ..) => return undecided("u"),
        };
        let point = Value { term: Term::Point(self.on(0)), plain: Some(plain), knot: None };
        let x = origin.plus(point);
        self.parameters.x = Some(x.clone());
        Ok(x)
    }

    /// x's place on the span s + e.
    fn on(&self, e: i64) -> term::Place {
        let at = if e == 0 { self.place.on_span().unwrap_or(Where::In) } else { Where::To };
        term::Place { at, window: WINDOW.into(), span: e }
    }

    /// t_{s+e} − (first knot shown), as the window has it.
    fn gaps(&mut self, e: i64) -> Known<Quotient> {
        let (from, _) = self.place.shown(self.k);
        if e <= from {
            return Ok(Quotient::constant(&integer(0)));
        }
        if let Some(known) = self.parameters.sums.get(&e) {
            return Ok(known.clone());
        }
        let before = self.gaps(e - 1)?;
        let sum = match self.gap(e - 1) {
            None => before,
            Some(class) => match self.parameters.value(gap_name(e - 1), class)?.plain {
                Some(gap) => before.plus(&gap),
                None => return undecided("a gap"),
            },
        };
        self.parameters.sums.insert(e, sum.clone());
        Ok(sum)
    }

    /// The sign of a gap; `None` if it is 0.
    pub(super) fn gap(&self, e: i64) -> Option<Class> {
        match self.place.gap(e) {
            Size::Zero => None,
            Size::Some => Some(Class::Positive),
            Size::Any if self.zero.contains(&e) => None,
            Size::Any => Some(Class::Nonnegative),
        }
    }

    fn shown(&mut self, e: i64) -> Known<Value> {
        if let Some(known) = self.parameters.knots.get(&e) {
            return Ok(known.clone());
        }
        let origin = self.parameters.value(ORIGIN.into(), Class::Real)?;
        let plain = Some(self.gaps(e)?);
        let knot = Value { term: Term::Knot(WINDOW.into(), e), plain, knot: None };
        let value = Value { knot: Some(e), ..origin.plus(knot) };
        self.parameters.knots.insert(e, value.clone());
        Ok(value)
    }

    pub(super) fn knot(&mut self, i: &Index) -> Known<Value> {
        let m = Index::last(self.k + 1);
        self.exists(&[i.clone(), m.minus(i)], || "a knot".into())?;
        if let Some(numbers) = &self.numbers {
            let at = self.facts.value(i).and_then(|i| usize::try_from(i).ok());
            let knot = at.and_then(|at| numbers.knots().get(at));
            return knot.map_or_else(|| undecided("a knot"), |knot| Ok(Value::number(knot.clone())));
        }
        let far = |own: &mut Self, side: &str, class| own.parameters.value(named(side, i), class);
        if self.place.on_span().is_none() {
            let x = self.x()?;
            let left = self.place == Place::After;
            let far = far(self, if left { "left" } else { "right" }, Class::Positive)?;
            return Ok(if left { x.minus(far) } else { x.plus(far) });
        }
        let surely = |own: &Self, v: &Index| own.facts.at_least_zero(v) == Some(true);
        // All copies of x are x.
        let copies = match self.place {
            Place::First(_) => surely(self, &i.times(-1).plus(&Index::span(0))).then_some(0),
            Place::Knot(Copies::AtLeast(q)) => {
                let copies = [i.minus(&Index::span(1 - q)), Index::span(0).minus(i)];
                copies.iter().all(|v| surely(self, v)).then_some(0)
            }
            Place::End | Place::Last(_) => surely(self, &i.minus(&Index::span(1))).then_some(1),
            _ => None,
        };
        let copies = copies.or_else(|| {
            let from = self.copies_from.as_ref()?;
            let copies = [i.minus(from), Index::span(0).minus(i)];
            copies.iter().all(|v| surely(self, v)).then_some(0)
        });
        if let Some(e) = copies {
            return self.shown(e);
        }
        let (from, to) = self.place.shown(self.k);
        let (low, high) = self.facts.of(&i.minus(&Index::span(0)));
        match (low, high) {
            (Some(low), Some(high)) if low == high && (from..=to).contains(&low) => self.shown(low),
            (_, Some(high)) if high <= to => {
                let e = high.max(from);
                // Before a knot inside there are others.
                let before = match self.place {
                    Place::Knot(Copies::Exactly(q)) => high <= -q || surely(self, &i.times(-1)),
                    Place::Knot(Copies::AtLeast(_)) => surely(self, &i.times(-1)),
                    _ => false,
                };
                let copy =
                    matches!(self.place, Place::Knot(Copies::Exactly(q) | Copies::AtLeast(q)) if e > -q);
                let class = if before && copy { Class::Positive } else { Class::Nonnegative };
                let far = far(self, "left", class)?;
                Ok(self.shown(e)?.minus(far))
            }
            (Some(low), _) if low >= from => {
                let far = far(self, "right", Class::Nonnegative)?;
                Ok(self.shown(low.min(to))?.plus(far))
            }
            _ => undecided("a knot of which the place does not say where it is"),
        }
    }

    /// That all of these are ≥ 0.
    fn exists(&self, all: &[Index], what: impl Fn() -> String) -> Known<()> {
        if all.iter().all(|v| self.facts.at_least_zero(v) == Some(true)) {
            Ok(())
        } else {
            Err(Stop::Undefined(format!("{} may not exist", what())))
        }
    }

    pub(super) fn real(&mut self, t: &Real) -> Known<Value> {
        Ok(match t {
            Real::Number(q) => Value::number(q.clone()),
            Real::Whole(i) => {
                let i = self.int(i)?;
                match self.facts.value(&i) {
                    Some(value) => Value::whole(value),
                    None => return undecided("an index as a number"),
                }
            }
            Real::Bound(name) => match self.bound(name)? {
                Bound::Free(value) => value,
                Bound::Point(At::Point(_)) => self.x()?,
                Bound::Point(At::Mirrored) => return undecided("t_0 + t_m − x as a number"),
            },
            Real::Ratio => self.own_ratio()?,
            Real::Index(name) => self.index_of(name)?,
            Real::Infinity => return undecided("∞ as a number"),
            Real::Parameter(..) if self.other.is_some() => return undecided("a parameter of another member"),
            Real::Parameter(name, of) => self.family_parameter(name, of)?,
            Real::Knot(i) => {
                let i = self.int(i)?;
                self.knot(&i)?
            }
            Real::Coefficient(name, of) => {
                own_name(name)?;
                let example = self.numbers.as_ref().and_then(|numbers| numbers.row);
                match (&**name, of.as_slice()) {
                    ("P", [i, coordinate]) => return self.coordinate(i, coordinate),
                    ("P", _) if example.is_some() => return undecided("a control point as a number"),
                    (_, [_]) => {}
                    _ => return undecided("control points of an example"),
                }
                let mut key = format!("({name}");
                for i in of {
                    let i = self.int(i)?;
                    let m = Index::last(0);
                    self.exists(&[i.clone(), m.minus(&i)], || format!("{name}[…]"))?;
                    let relative =
                        if self.numbers.is_some() { self.facts.value(&i) } else { self.relative(&i) };
                    match relative {
                        Some(e) => key += &format!(" {e}"),
                        None if self.place.is_coarse() => {
                            return undecided("where a control value is");
                        }
                        None => key = i.key().fold(key, |key, part| format!("{key} {part}")),
                    }
                }
                self.parameters.value(key + ")", Class::Real)?
            }
            Real::Plus(a, b) => self.real(a)?.plus(self.real(b)?),
            Real::Minus(a, b) => self.real(a)?.minus(self.real(b)?),
            Real::Times(a, b) => self.real(a)?.times(self.real(b)?),
            Real::Negated(a) => self.real(a)?.times(Value::whole(-1)),
            Real::Over(a, b) => {
                let (a, b) = (self.real(a)?, self.real(b)?);
                self.over(a, b)?
            }
            Real::Power(a, e) => {
                let (a, e) = (self.real(a)?, self.int(e)?);
                match self.facts.value(&e) {
                    Some(e @ 0..=100) => (0..e).fold(Value::whole(1), |power, _| power.times(a.clone())),
                    _ => return undecided("an exponent"),
                }
            }
            Real::Fold(fold, range, body) => self.fold(*fold, range, &|own| own.real(body))?,
            Real::Value(f, argument) => {
                let (at, moved, other) = self.argument(argument)?;
                let place = moved.map(|x| self.locate(x)).transpose()?;
                let before = std::mem::replace(&mut self.other, other);
                let value = self.function(f, at, 0, 0);
                self.other = before;
                if let Some(place) = place {
                    self.restore(place);
                }
                value?
            }
            Real::Defined(name, of) => self.defined(name, of, At::Point(None), 0, 0)?,
            Real::Absolute(a) => {
                let a = self.real(a)?;
                let negative = a.clone().times(Value::whole(-1));
                self.greatest(a, negative, true)?
            }
            Real::Least(a, b) | Real::Greatest(a, b) => {
                let (a, b) = (self.real(a)?, self.real(b)?);
                self.greatest(a, b, matches!(t, Real::Greatest(..)))?
            }
            Real::Root(_) | Real::Word(_) => {
                return undecided("a term that windows don't have");
            }
        })
    }

    /// The greater one of two, or the smaller one.
    fn greatest(&mut self, a: Value, b: Value, greatest: bool) -> Known<Value> {
        if self.compare(Relation::AtLeast, &a, &b).is_true() {
            Ok(if greatest { a } else { b })
        } else if self.compare(Relation::AtMost, &a, &b).is_true() {
            Ok(if greatest { b } else { a })
        } else {
            undecided("the greater one of two numbers")
        }
    }

    /// A coordinate of a control point of the example.
    fn coordinate(&mut self, i: &Int, coordinate: &Int) -> Known<Value> {
        let (i, coordinate) = (self.int(i)?, self.int(coordinate)?);
        let at = |own: &Self, i: &Index| own.facts.value(i).and_then(|i| usize::try_from(i).ok());
        let (i, coordinate) = (at(self, &i), at(self, &coordinate));
        let points = self.numbers.as_ref().and_then(|numbers| numbers.row?.points.as_ref());
        let value = points.and_then(|points| points.get(i?)?.get(coordinate?.checked_sub(1)?));
        value.map_or_else(|| undecided("a control point"), |value| Ok(Value::number(value.clone())))
    }

    /// A parameter of the family: a number, or one of a knot of the window.
    pub(super) fn family_parameter(&mut self, name: &Name, of: &[Int]) -> Known<Value> {
        let Weighted::Family(family) = self.weighted else { return undecided("a parameter of any weights") };
        let own = family.parameters.iter().find(|own| own.name == *name);
        let (Some(own), Some(class)) = (own, self.weighted.class(name)) else {
            return undecided(format!("no parameter {name}"));
        };
        if own.indices.is_empty() {
            return self.parameters.value(name.to_string(), class);
        }
        let forms: Vec<_> = of.iter().map(|i| self.int(i)).collect::<Known<_>>()?;
        let degree = own.indices.iter().zip(&forms).find(|(index, _)| ***index == *"d");
        let degree = match degree.map(|(_, form)| self.facts.value(form)) {
            None => 0,
            Some(Some(degree)) if (0..=self.k).contains(&degree) => degree,
            Some(Some(_)) => return Err(Stop::Undefined(format!("{name} of such a degree"))),
            Some(None) => return undecided("a degree that is not known"),
        };
        if self.place.on_span().is_none() {
            return undecided("a parameter of a knot");
        }
        let (from, to) = self.place.shown(self.k);
        let mut indices = Vec::new();
        for (index, form) in own.indices.iter().zip(&forms) {
            if **index == *"d" {
                indices.push(degree);
                continue;
            }
            let last = Index::last(self.k + 1 - degree);
            self.exists(&[form.clone(), last.minus(form)], || format!("{name}[…]"))?;
            match (&self.numbers, self.relative(form), self.facts.value(form)) {
                // Numbers are counted as they are, the knots of other windows from t_s.
                (Some(_), _, Some(i)) => indices.push(i),
                (None, Some(e), _) if (from..=to).contains(&e) => indices.push(e),
                _ => return undecided("where the knot of a parameter is"),
            }
        }
        let numbers: Vec<_> = indices.iter().map(ToString::to_string).collect();
        let key = format!("(parameter {WINDOW} {name} {})", numbers.join(" "));
        let value = self.parameters.value(key, class)?;
        Ok(Value { term: Term::Parameter(WINDOW.into(), name.to_string(), indices), ..value })
    }

    /// Knot s' + e of the reflected window is s + 1 + turn − e.
    pub(super) fn turn(&self) -> i64 {
        match self.place {
            Place::Knot(Copies::Exactly(q)) => -q,
            _ => 0,
        }
    }

    fn bound(&self, name: &Name) -> Known<Bound> {
        match self.scope.reals.iter().rev().find(|(known, _)| known == name) {
            Some((_, bound)) => Ok(bound.clone()),
            None => undecided(format!("{name} is not bound here")),
        }
    }

    /// r, in numbers with what is known of it.
    pub(super) fn r(&mut self) -> Known<Value> {
        let r = self.parameters.value("r".into(), Class::Positive)?;
        match self.ratios.own.clone() {
            Some(known) if self.numbers.is_some() => Ok(Value { plain: self.of_ratio(&known)?.plain, ..r }),
            _ => Ok(r),
        }
    }

    /// The ratio of another index.
    fn other_ratio(&mut self, name: &Name) -> Known<Value> {
        own_name(name)?;
        match self.ratios.others.iter().find(|(known, _)| known == name) {
            Some((_, known)) => self.of_ratio(&known.clone()),
            None => self.parameters.value(format!("({name} 0)"), Class::Positive),
        }
    }

    /// A ratio by its parameters.
    fn of_ratio(&mut self, ratio: &Term) -> Known<Value> {
        match ratio {
            Term::Number(number) => Ok(Value::number(number.clone())),
            Term::Named(name) => self.parameters.value(name.clone(), Class::Positive),
            Term::Sum(all) => {
                all.iter().try_fold(Value::whole(0), |sum, part| Ok(sum.plus(self.of_ratio(part)?)))
            }
            Term::Ratio(a, b) => {
                let (a, b) = (self.of_ratio(a)?, self.of_ratio(b)?);
                self.over(a, b)
            }
            _ => undecided("a ratio"),
        }
    }

    /// An index as a number, r/(r − 1).
    fn index_of(&mut self, name: &Name) -> Known<Value> {
        if self.numbers.is_none() || self.other.is_some() {
            return undecided("an index α as a number");
        }
        let r = if &**name == "alpha" { self.r()? } else { self.other_ratio(name)? };
        let below = r.clone().minus(Value::whole(1));
        self.over(r, below)
    }

    fn own_ratio(&mut self) -> Known<Value> {
        let r = self.r()?;
        match &self.other {
            None => Ok(r),
            Some(_) => undecided("r of another member"),
        }
    }

    pub(super) fn over(&mut self, a: Value, b: Value) -> Known<Value> {
        let Some(below) = &b.plain else { return undecided("a function as a denominator") };
        if below.is_zero() {
            return Err(Stop::Undefined("1/0".into()));
        }
        let definite =
            [below.clone(), below.negate()].iter().any(|b| self.parameters.class(b) == Class::Positive);
        if !definite {
            return undecided("a denominator that may be 0");
        }
        let plain = a.plain.as_ref().and_then(|a| a.over(below));
        if a.is_zero() {
            return Ok(a);
        }
        Ok(Value { term: Term::Ratio(Box::new(a.term), Box::new(b.term)), plain, knot: None })
    }

    fn fold(&mut self, fold: Fold, range: &Range, body: &dyn Fn(&mut Self) -> Known<Value>) -> Known<Value> {
        let sum = match fold {
            Fold::Sum => true,
            Fold::Product => false,
            Fold::Least | Fold::Greatest => return undecided("a least or greatest one"),
        };
        let here = self.folded(sum, range, body);
        match here {
            Err(_) if self.symmetric && !self.mirrored && self.mirror().is_ok() => {
                self.mirrored = true;
                let there = self.folded(sum, range, body);
                self.mirrored = false;
                there
            }
            _ => here,
        }
    }

    fn folded(&mut self, sum: bool, range: &Range, body: &dyn Fn(&mut Self) -> Known<Value>) -> Known<Value> {
        let neutral = Value::whole(i64::from(!sum));
        let mut all = neutral.clone();
        for (i, surely) in self.run(range)? {
            let Ok(value) = self.with(range, &i, body)? else { continue };
            let value = value?;
            if !surely && value != neutral && !(sum && value.is_zero()) {
                return undecided("a summand that may not be there");
            }
            all = if sum { all.plus(value) } else { all.times(value) };
        }
        Ok(all)
    }

    /// Where an argument is, what it is if it is not x, and its member.
    fn argument(&mut self, argument: &Argument) -> Known<(At, Option<Value>, Option<Other>)> {
        let other = match &argument.member {
            None => self.other.clone(),
            // Inside of another member only what names its own index means the same.
            Some(member)
                if self.other.is_some()
                    && !matches!(member, Member::Index(Real::Infinity | Real::Index(_))) =>
            {
                return undecided("a member of a member");
            }
            Some(Member::Ratio(t)) => {
                let value = self.real(t)?;
                match &value.plain {
                    Some(plain) if self.parameters.class(plain) == Class::Positive => {
                        Some(Other::Ratio(value))
                    }
                    _ => return undecided("a ratio that may not be positive"),
                }
            }
            Some(Member::Dual) => Some(Other::Dual),
            Some(Member::Index(Real::Infinity)) => Some(Other::Ratio(Value::whole(1))),
            Some(Member::Index(Real::Index(name))) if &**name != "alpha" => {
                Some(Other::Ratio(self.other_ratio(name)?))
            }
            Some(Member::Index(Real::Minus(a, b)))
                if matches!(&**a, Real::Whole(Int::Number(1)))
                    && matches!(&**b, Real::Index(name) if &**name == "alpha") =>
            {
                let r = self.r()?;
                Some(Other::Ratio(self.over(Value::whole(1), r)?))
            }
            Some(_) => return undecided("another member of the family"),
        };
        let (at, moved) = match self.place_of(&argument.at) {
            Err(Stop::Undecided(_)) if self.numbers.is_some() => {
                (At::Point(None), Some(self.real(&argument.at)?))
            }
            at => (at?, None),
        };
        let at = match at {
            At::Point(None) => At::Point(argument.side),
            at if argument.side.is_none() => at,
            _ => return undecided("a side of a side"),
        };
        match (at, &other) {
            (At::Mirrored, Some(Other::Dual)) => undecided("the dual at a mirror image"),
            (_, Some(Other::Dual)) if !self.symmetric && self.numbers.is_none() => {
                undecided("the dual of knots that are not symmetric")
            }
            _ => Ok((at, moved, other)),
        }
    }

    /// x itself, t_0 + t_m − x, or what a definition was applied to.
    fn place_of(&mut self, t: &Real) -> Known<At> {
        if let Real::Bound(name) = t
            && let Bound::Point(at) = self.bound(name)?
        {
            return Ok(at);
        }
        if let Real::Minus(sum, x) = t
            && let Real::Plus(a, b) = &**sum
            && matches!((&**a, &**b), (Real::Knot(Int::Number(0)), Real::Knot(Int::M)))
            && self.symmetric
            && self.place_of(x)? == At::Point(None)
        {
            return Ok(At::Mirrored);
        }
        if self.is_point(t)? { Ok(At::Point(None)) } else { undecided("a function at another point than x") }
    }

    /// The derivative of an order of a function.
    fn function(&mut self, f: &Function, at: At, order: usize, depth: usize) -> Known<Value> {
        match f {
            Function::Derivative(f, more) => {
                let more = self.int(more)?;
                match self.facts.value(&more).map(usize::try_from) {
                    Some(Ok(more)) if order + more <= HIGHEST => self.function(f, at, order + more, depth),
                    _ => undecided("a derivative of higher order"),
                }
            }
            Function::Phi { .. } if !self.is_by_ends() => {
                undecided("a weight that is not one of the ends alone")
            }
            Function::Phi { cut, from, to } if self.numbers.is_some() && order <= 2 => {
                let (from, to) = (self.real(from)?, self.real(to)?);
                self.weight_on(*cut, [&from, &to], at, order)
            }
            Function::Basis { i, degree } => {
                let i = self.int(i)?;
                let d = match degree {
                    None => self.k,
                    Some(d) => {
                        let d = self.int(d)?;
                        match self.facts.value(&d) {
                            Some(d) => d,
                            None => return undecided("a degree that is not known"),
                        }
                    }
                };
                self.basis(&i, d, at, order)
            }
            Function::Weight { .. } | Function::Phi { .. } if order > 1 => {
                undecided("a higher derivative of a weight")
            }
            Function::Weight { i, degree } => {
                let (i, d) = (self.int(i)?, self.int(degree)?);
                match self.facts.value(&d) {
                    Some(d) => self.weight(&i, d, at, order == 1),
                    None => undecided("a degree that is not known"),
                }
            }
            Function::Phi { cut, from, to } => {
                let (from, to) = (self.real(from)?, self.real(to)?);
                self.phi(*cut, &from, &to, at, order == 1)
            }
            Function::Defined(name, of) => self.defined(name, of, at, order, depth),
        }
    }

    fn defined(&mut self, name: &Name, of: &[Int], at: At, order: usize, depth: usize) -> Known<Value> {
        if depth == DEEPEST {
            return undecided("a definition that leads on and on");
        }
        let of: Vec<_> = of.iter().map(|i| self.int(i)).collect::<Known<_>>()?;
        let definitions = self.definitions;
        for definition in definitions.iter().filter(|one| one.name == *name) {
            let mut scope = Scope::default();
            let mut fits = definition.indices.len() == of.len();
            for (pattern, i) in definition.indices.iter().zip(&of) {
                match pattern {
                    Pattern::Any(name) => scope.integers.push((name.clone(), i.clone())),
                    Pattern::Number(number) => match self.facts.value(i) {
                        Some(value) => fits &= value == *number,
                        None => return undecided(format!("which definition of {name} is meant")),
                    },
                }
            }
            if !fits {
                continue;
            }
            if let Some(variable) = &definition.variable {
                scope.reals.push((variable.clone(), Bound::Point(at)));
            }
            let outer = std::mem::replace(&mut self.scope, scope);
            let value = match (order, &definition.variable) {
                (0, _) => self.real_at(&definition.body, depth + 1),
                (2.., _) => undecided("a higher derivative of a definition"),
                (_, Some(variable)) => self.slope(&definition.body, variable, depth + 1),
                (_, None) => undecided("the derivative of a number"),
            };
            self.scope = outer;
            return value;
        }
        undecided(format!("{name} is not defined here"))
    }

    /// Are weights given by the ends of the interval?
    fn is_by_ends(&self) -> bool {
        matches!(self.weighted, Weighted::Family(family) if family.is_by_ends())
    }

    /// A body, at a depth of definitions.
    fn real_at(&mut self, body: &Real, depth: usize) -> Known<Value> {
        if depth > DEEPEST { undecided("a definition that leads on and on") } else { self.real(body) }
    }

    /// The derivative of a term with respect to the variable of its definition.
    fn slope(&mut self, t: &Real, variable: &Name, depth: usize) -> Known<Value> {
        Ok(match t {
            Real::Bound(name) => Value::whole(i64::from(name == variable)),
            Real::Number(_)
            | Real::Whole(_)
            | Real::Knot(_)
            | Real::Coefficient(..)
            | Real::Ratio
            | Real::Parameter(..) => Value::whole(0),
            Real::Plus(a, b) => self.slope(a, variable, depth)?.plus(self.slope(b, variable, depth)?),
            Real::Minus(a, b) => self.slope(a, variable, depth)?.minus(self.slope(b, variable, depth)?),
            Real::Negated(a) => self.slope(a, variable, depth)?.times(Value::whole(-1)),
            Real::Times(a, b) => {
                let left = self.slope(a, variable, depth)?;
                let left = if left.is_zero() { left } else { left.times(self.real(b)?) };
                let right = self.slope(b, variable, depth)?;
                let right = if right.is_zero() { right } else { self.real(a)?.times(right) };
                left.plus(right)
            }
            Real::Fold(Fold::Sum, range, body) => {
                self.fold(Fold::Sum, range, &|own| own.slope(body, variable, depth))?
            }
            Real::Value(f, argument) if argument.member.is_none() && argument.side.is_none() => {
                match &argument.at {
                    Real::Bound(name) if name == variable => {
                        let at = self.place_of(&argument.at)?;
                        self.function(f, at, 1, depth)?
                    }
                    _ => return undecided("a derivative of a function of another point"),
                }
            }
            _ => return undecided("a derivative that windows don't have"),
        })
    }

    /// A term at the mirror image, or for another member.
    fn moved(&self, term: Term, mirrored: bool) -> Term {
        let mut replaced = Vec::new();
        if mirrored && self.place == Place::Inside {
            let (one, u) = (Term::Number(integer(1)), Term::Named("u".into()));
            replaced.push(("u".to_owned(), Term::Ratio(Box::new(one), Box::new(u))));
        }
        if let Some(u) = self.numbers.as_ref().and_then(|numbers| numbers.u.clone()) {
            replaced.push(("u".to_owned(), u));
        }
        let mut term = term;
        match &self.other {
            Some(Other::Ratio(ratio)) => replaced.push(("r".to_owned(), ratio.term.clone())),
            Some(Other::Dual) => {
                let (window, m) = match &self.numbers {
                    // One window has all knots, which count as they are counted.
                    Some(numbers) => (WINDOW, i64::try_from(numbers.knots().len()).unwrap_or(0) - 1),
                    // t_{s+e} is reflected to t_{s'+1+turn−e}.
                    None => (MIRROR, 1 + self.turn()),
                };
                term = Term::Dual(window.into(), m, Box::new(term));
            }
            None => {}
        }
        if replaced.is_empty() { term } else { Term::At(replaced, Box::new(term)) }
    }

    /// An index and a place as the window counts them: numbers are counted as they are, other knots from t_s.
    fn counted(&self, i: i64, place: term::Place) -> Known<(i64, term::Place)> {
        let from = match (&self.numbers, self.facts.value(&Index::span(0))) {
            (None, _) => 0,
            (Some(_), Some(s)) => s,
            _ => return undecided("the span of x"),
        };
        Ok((i + from, term::Place { span: place.span + from, ..place }))
    }

    /// The span that a function is looked at on, as an index, and x there; `None` where all functions are 0.
    fn span_of(&self, at: At) -> Known<Option<(Index, term::Place)>> {
        let Some(on) = self.place.on_span() else { return Ok(None) };
        let here = Some((Index::span(0), self.on(0)));
        match (at, self.place) {
            (At::Mirrored, place) => {
                let at = match on {
                    Where::In => Where::In,
                    Where::From if matches!(place, Place::First(_)) => Where::To,
                    _ => Where::From,
                };
                Ok(Some((self.mirror()?, term::Place { at, window: MIRROR.into(), span: 0 })))
            }
            (At::Point(None), _) => Ok(here),
            (At::Point(Some(Side::Right)), Place::End | Place::Last(_)) => Ok(None),
            (At::Point(Some(Side::Right)), _) => Ok(here),
            (At::Point(Some(Side::Left)), Place::Inside | Place::End | Place::Last(_)) => Ok(here),
            (At::Point(Some(Side::Left)), Place::First(_)) => Ok(None),
            (At::Point(Some(Side::Left)), Place::Knot(Copies::Exactly(q))) => {
                Ok(Some((Index::span(-q), self.on(-q))))
            }
            (At::Point(Some(Side::Left)), _) => undecided("a limit from the left"),
        }
    }

    fn basis(&mut self, i: &Index, d: i64, at: At, order: usize) -> Known<Value> {
        let last = Index::last(self.k - d);
        let degree = usize::try_from(d).ok().filter(|_| d <= self.k);
        let Some(degree) = degree else { return Err(Stop::Undefined(format!("a function of degree {d}"))) };
        self.exists(&[i.clone(), last.minus(i)], || format!("G[…,{d}]"))?;
        // With Q copies and more the span on the left is not known, but s − Q is not before it.
        if let (At::Point(Some(Side::Left)), Place::Knot(Copies::AtLeast(q))) = (at, self.place)
            && self.facts.at_least_zero(&i.minus(&Index::span(1 - q))) == Some(true)
        {
            return Ok(Value::whole(0));
        }
        let Some((span, place)) = self.span_of(at)? else { return Ok(Value::whole(0)) };
        let e = i.minus(&span);
        let beside = [e.times(-1).plus(&Index::number(-d - 1)), e.plus(&Index::number(-1))];
        if beside.iter().any(|v| self.facts.at_least_zero(v) == Some(true)) {
            return Ok(Value::whole(0));
        }
        let Some(e) = self.facts.value(&e) else { return undecided("whether a function lives on the span") };
        let mirrored = at == At::Mirrored;
        let (i, place) = self.counted(e + place.span, place)?;
        let term = self.moved(Term::Function { order, i, degree, place }, mirrored);
        if mirrored && order > 0 {
            return undecided("a derivative at the mirror image");
        }
        let plain = match self.exact {
            true if order > 0 => return undecided("a derivative as a value"),
            true => self.basis_value(i, d)?.plain,
            false => None,
        };
        Ok(Value { term, plain, knot: None })
    }

    fn weight(&mut self, i: &Index, d: i64, at: At, derivative: bool) -> Known<Value> {
        let degree = usize::try_from(d).ok().filter(|d| *d > 0);
        let Some(degree) = degree else { return Err(Stop::Undefined(format!("a weight of degree {d}"))) };
        let last = Index::last(self.k + 1 - d);
        self.exists(&[i.clone(), last.minus(i)], || format!("w[…,{d}]"))?;
        if at == At::Mirrored {
            return undecided("a weight at the mirror image");
        }
        let Some((span, place)) = self.span_of(at)? else { return Ok(Value::whole(0)) };
        let e = i.minus(&span);
        let beside = [e.times(-1).plus(&Index::number(-d)), e.plus(&Index::number(-1))];
        if beside.iter().any(|v| self.facts.at_least_zero(v) == Some(true)) {
            return Ok(Value::whole(0));
        }
        let Some(e) = self.facts.value(&e) else { return undecided("whether a weight acts on the span") };
        let of = if derivative { OfWeight::Derivative } else { OfWeight::Weight };
        let i = e + place.span;
        if self.numbers.is_some() {
            let (index, place) = self.counted(i, place)?;
            let ends = [index, index + d].map(|i| self.knot(&Index::number(i)));
            let [Ok(from), Ok(to)] = &ends else { return undecided("a weight on knots that are not there") };
            let plain = match self.is_by_ends() {
                true => self.weight_on(false, [from, to], at, usize::from(derivative))?.plain,
                false => None,
            };
            let term = self.moved(Term::Weight(of, index, degree, place), false);
            return Ok(Value { term, plain, knot: None });
        }
        let (from, to) = self.place.shown(self.k);
        if i < from || i + d > to {
            return undecided("a weight on knots that are not shown");
        }
        Ok(Value { term: self.moved(Term::Weight(of, i, degree, place), false), plain: None, knot: None })
    }

    /// φ on the interval between two knots that are shown.
    fn phi(&mut self, cut: bool, from: &Value, to: &Value, at: At, derivative: bool) -> Known<Value> {
        if at != At::Point(None) || (derivative && cut && self.place != Place::Inside) {
            return undecided("φ at a side of x");
        }
        if cut {
            let x = self.x()?;
            let inside = self.compare(Relation::AtMost, from, &x).and(self.compare(Relation::Less, &x, to));
            if inside == Truth::False {
                return Ok(Value::whole(0));
            }
            if !inside.is_true() {
                return undecided("whether x is in the interval of φ");
            }
        }
        let (Some(a @ ..=0), Some(b @ 1..)) = (from.knot, to.knot) else {
            return undecided("φ on an interval beside the span");
        };
        let degree = usize::try_from(b - a).unwrap_or_default();
        let of = if derivative { OfWeight::Derivative } else { OfWeight::Weight };
        let term = self.moved(Term::Weight(of, a, degree, self.on(0)), false);
        Ok(Value { term, plain: None, knot: None })
    }

    pub(super) fn compare(&mut self, relation: Relation, a: &Value, b: &Value) -> Truth {
        let (left, right) = (a.term.clone(), b.term.clone());
        let (Some(first), Some(second)) = (&a.plain, &b.plain) else {
            return match relation {
                Relation::Equal => Truth::Goals(vec![term::Formula::Equal(left, right)]),
                // What differs is shown to be greater, where that is so.
                Relation::Greater | Relation::Unequal => {
                    Truth::Goals(vec![term::Formula::Greater(left, right)])
                }
                Relation::AtLeast => Truth::Goals(vec![term::Formula::AtLeast(left, right)]),
                Relation::Less => Truth::Goals(vec![term::Formula::Greater(right, left)]),
                Relation::AtMost => Truth::Goals(vec![term::Formula::AtLeast(right, left)]),
            };
        };
        let difference = first.minus(second);
        let signs = [&difference, &difference.negate()].map(|value| self.parameters.class(value));
        let known = match (difference.is_zero(), signs, relation) {
            (true, _, Relation::Equal | Relation::AtMost | Relation::AtLeast) => Some(true),
            (true, ..) => Some(false),
            (_, [Class::Positive, _], relation) => {
                Some(matches!(relation, Relation::Greater | Relation::AtLeast | Relation::Unequal))
            }
            (_, [_, Class::Positive], relation) => {
                Some(matches!(relation, Relation::Less | Relation::AtMost | Relation::Unequal))
            }
            (_, [Class::Nonnegative, _], Relation::AtLeast)
            | (_, [_, Class::Nonnegative], Relation::AtMost) => Some(true),
            (_, [Class::Nonnegative, _], Relation::Less)
            | (_, [_, Class::Nonnegative], Relation::Greater) => Some(false),
            _ => None,
        };
        Truth::of(known, "the order of two knots")
    }

    pub(super) fn formula(&mut self, f: &Formula) -> Truth {
        self.said(f).unwrap_or_else(Truth::from)
    }

    fn said(&mut self, f: &Formula) -> Known<Truth> {
        Ok(match f {
            Formula::Chain(first, rest) => {
                let mut all = Truth::TRUE;
                let mut left = first;
                for (relation, right) in rest {
                    all = all.and(self.relation(*relation, left, right));
                    left = right;
                }
                all
            }
            Formula::Within(t, Interval { from, from_closed, to, to_closed }) => {
                let low = if *from_closed { Relation::AtMost } else { Relation::Less };
                let high = if *to_closed { Relation::AtMost } else { Relation::Less };
                self.relation(low, from, t).and(self.relation(high, t, to))
            }
            Formula::Among(i, from, to) => {
                let (i, from, to) = (self.int(i)?, self.int(from)?, self.int(to)?);
                let holds =
                    |v: Index| Truth::of(self.facts.at_least_zero(&v), "whether an index is in a range");
                holds(i.minus(&from)).and(holds(to.minus(&i)))
            }
            Formula::Not(f) => self.formula(f).not(),
            Formula::And(all) => all.iter().fold(Truth::TRUE, |truth, f| truth.and(self.formula(f))),
            Formula::Or(all) => all.iter().fold(Truth::False, |truth, f| truth.or(self.formula(f))),
            Formula::Implies(a, b) => self.formula(a).not().or(self.formula(b)),
            Formula::Iff(a, b) => {
                let (a, b) = (self.formula(a), self.formula(b));
                a.clone().not().or(b.clone()).and(b.not().or(a))
            }
            Formula::All(Over::Integers(range), body) => self.every(range, body, true)?,
            Formula::Some(Over::Integers(range), body) => self.every(range, body, false)?,
            Formula::Word(of) => match (of.word, of.of.as_slice()) {
                (word @ (Word::Smooth | Word::Rational), [Item::Real(t)]) => {
                    let value = self.real(t)?;
                    match self.place {
                        // On a span it is a quotient of polynomials in x.
                        Place::Inside if !value.term.names("u") => {
                            let ends = match word {
                                Word::Rational => &[Where::In, Where::From, Where::To][..],
                                _ => &[Where::In],
                            };
                            let defined = |at: &Where| term::Formula::Defined(value.term.at_end(*at));
                            let goals = ends.iter().map(defined).collect();
                            Truth::Goals(if value.is_zero() { Vec::new() } else { goals })
                        }
                        Place::Before | Place::After if value.is_zero() => Truth::TRUE,
                        _ => return undecided("what an expression is on several spans"),
                    }
                }
                (Word::Defined, [Item::Real(t)]) => {
                    let value = self.real(t)?;
                    match value.plain {
                        Some(_) => Truth::TRUE,
                        None => Truth::Goals(vec![term::Formula::Defined(value.term)]),
                    }
                }
                _ => return undecided(format!("the word {}", of.word.name())),
            },
            Formula::Some(Over::Reals(name, interval), body) => self.some_real(name, interval, body)?,
            Formula::Instance(names) => {
                let row = self.numbers.as_ref().and_then(|numbers| numbers.row);
                let Some(row) = row else { return undecided("an instance") };
                Truth::of(Some(row.name.as_ref().is_some_and(|name| names.contains(name))), "")
            }
            Formula::One(Over::Integers(range), body) => {
                let mut count = 0;
                for (i, surely) in self.run(range)? {
                    let Ok(here) = self.with(range, &i, |own| own.formula(body))? else { continue };
                    match here {
                        Truth::False if surely => {}
                        here if surely && here.is_true() => count += 1,
                        _ => return undecided("how many there are"),
                    }
                }
                Truth::of(Some(count == 1), "")
            }
            Formula::All(..) | Formula::One(..) => {
                return undecided("a quantifier inside of a formula");
            }
            Formula::Claim { .. } => return undecided("another claim"),
        })
    }

    fn every(&mut self, range: &Range, body: &Formula, every: bool) -> Known<Truth> {
        let mut truth = if every { Truth::TRUE } else { Truth::False };
        for (i, surely) in self.run(range)? {
            let Ok(here) = self.with(range, &i, |own| own.formula(body))? else { continue };
            let neutral = if every { Truth::TRUE } else { Truth::False };
            let here = if surely || here == neutral {
                here
            } else {
                Truth::of(None, "something that may not be there")
            };
            truth = if every { truth.and(here) } else { truth.or(here) };
        }
        Ok(truth)
    }

    fn relation(&mut self, relation: Relation, a: &Real, b: &Real) -> Truth {
        if let (Real::Whole(a), Real::Whole(b)) = (a, b) {
            return match (self.int(a), self.int(b)) {
                (Ok(a), Ok(b)) => self.order(relation, &a, &b),
                (Err(stop), _) | (_, Err(stop)) => stop.into(),
            };
        }
        if let (Real::Index(_), Real::Infinity, true) = (a, b, self.numbers.is_some()) {
            // 1/0 is ∞, and nothing else is.
            let known = match (self.real(a), relation) {
                (Ok(_), Relation::Unequal) | (Err(Stop::Undefined(_)), Relation::Equal) => Some(true),
                (Ok(_), Relation::Equal) | (Err(Stop::Undefined(_)), Relation::Unequal) => Some(false),
                _ => None,
            };
            return Truth::of(known, "whether α is ∞");
        }
        match (self.real(a), self.real(b)) {
            (Ok(a), Ok(b)) => self.compare(relation, &a, &b),
            (Err(stop @ Stop::Undefined(_)), _) | (_, Err(stop)) | (Err(stop), _) => stop.into(),
        }
    }

    fn order(&self, relation: Relation, a: &Index, b: &Index) -> Truth {
        let holds = |v: &Index| self.facts.at_least_zero(v);
        let (rise, one) = (b.minus(a), Index::number(1));
        let (below, above) = (rise.minus(&one), rise.times(-1).minus(&one));
        let equal = match (holds(&rise), holds(&rise.times(-1))) {
            (Some(true), Some(true)) => Some(true),
            (Some(false), _) | (_, Some(false)) => Some(false),
            _ => None,
        };
        let known = match relation {
            Relation::Equal => equal,
            Relation::Unequal => equal.map(|equal| !equal),
            Relation::AtMost => holds(&rise),
            Relation::AtLeast => holds(&rise.times(-1)),
            Relation::Less => holds(&below),
            Relation::Greater => holds(&above),
        };
        Truth::of(known, "the order of two indices")
    }
}

pub(super) fn gap_name(e: i64) -> String {
    format!("({WINDOW} {e})")
}

/// What windows call something else is no name of a sentence's own.
fn own_name(name: &Name) -> Known<()> {
    match &**name {
        "u" | "r" | "o" | "W" | "M" | "left" | "right" | "rho" | "outside" => {
            undecided(format!("{name} is the name of something else in windows"))
        }
        _ => Ok(()),
    }
}

/// A parameter of an integer.
fn named(head: &str, i: &Index) -> String {
    i.key().fold(format!("({head}"), |name, part| format!("{name} {part}")) + ")"
}

fn binomial(n: i64, m: i64) -> Known<i64> {
    if n < 0 {
        return Err(Stop::Undefined("a binomial coefficient".into()));
    }
    let step = |value: i64, i: i64| value.checked_mul(n - i + 1).map(|value| value / i);
    let value = if m < 0 || m > n { Some(0) } else { (1..=m.min(n - m)).try_fold(1, step) };
    value.map_or_else(|| undecided("a binomial coefficient"), Ok)
}
