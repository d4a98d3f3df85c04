//! The one walk over the trees: what terms and formulas are on an instance.

use std::collections::HashMap;

use crate::analysis::{Greatest, Sign};
use crate::language::{
    Claim, Definition, File, Fold, Formula, Int, Member, Name, Over, Range, Real, Relation, Sentence,
};
use crate::scalar::BigRational;
use crate::spline::{Index, KnotVector, Side};

use super::cell::{Frame, sign_of_difference};
use super::family::Weighting;
use super::instance::Instance;
use super::seen::Seen;
use super::truth::{Stop, Truth};
use super::value::{Plain, Value, combined};
use super::words;

/// What the names in a file stand for.
#[derive(Clone, Copy)]
pub struct Names<'a> {
    /// Its definitions.
    pub definitions: &'a [Definition],
    /// All stanzas.
    pub library: &'a (dyn Library + Sync),
}

/// Where the sentences of stanzas are.
pub trait Library {
    /// The sentence of a stanza, as printed or, where that fails, as amended, with the definitions of its own file.
    fn claim(&self, id: &str, printed: bool) -> Option<(&Sentence, &[Definition])>;
}

/// No stanzas.
impl Library for () {
    fn claim(&self, _: &str, _: bool) -> Option<(&Sentence, &[Definition])> {
        None
    }
}

/// Of a stanza that has an amended sentence, the printed one fails.
impl Library for Vec<File> {
    fn claim(&self, id: &str, printed: bool) -> Option<(&Sentence, &[Definition])> {
        let (stanza, file) = self
            .iter()
            .find_map(|file| Some((file.claims.iter().find(|stanza| &*stanza.id == id)?, file)))?;
        let said = stanza.amended.as_ref().filter(|_| !printed).unwrap_or(&stanza.printed);
        Some((said.sentence()?, &file.definitions))
    }
}

impl<'a> From<Claim<'a>> for Names<'a> {
    fn from(claim: Claim<'a>) -> Self {
        Self { definitions: claim.definitions, library: &claim.paper.files }
    }
}

impl Names<'static> {
    /// Without definitions and other stanzas.
    #[must_use]
    pub fn empty() -> Self {
        Self { definitions: &[], library: &() }
    }
}

/// The names that are bound, innermost last.
#[derive(Debug, Clone, Default)]
pub struct Bound {
    /// Integers.
    pub integers: Vec<(Name, i64)>,
    /// Reals, each with the frame whose coordinate it is a function of.
    pub reals: Vec<(Name, Value, usize)>,
    /// Control values.
    pub points: Vec<(Name, Vec<BigRational>)>,
    /// Indices besides α.
    pub indices: Vec<(Name, Index)>,
}

/// A value of a basis function: of which one, where, from which side.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Look {
    /// i.
    pub i: usize,
    /// d.
    pub degree: usize,
    /// The order of the derivative.
    pub order: usize,
    /// x.
    pub x: BigRational,
    /// From which side the limit is taken.
    pub side: Side,
    /// α, or the parameters of another family.
    pub weights: Weighting,
}

/// A supremum on the way, with nothing bound but integers.
#[derive(Debug, Clone, PartialEq)]
pub struct Found {
    /// The term.
    pub term: Real,
    /// The integers that were bound.
    pub integers: Vec<(Name, i64)>,
    /// What it is.
    pub value: Greatest,
}

/// An instance with the names that are bound: terms have values on it, formulas truths.
pub struct Reading<'a> {
    /// What is read on.
    pub on: &'a Instance,
    /// Whose names are known.
    pub names: Names<'a>,
    /// The member of the moment: α, but in `(x; alpha = …)`.
    pub weights: Weighting,
    /// What is bound.
    pub bound: Bound,
    /// The cell that the variable of the moment runs over, if it is an open one.
    pub frame: Option<Frame>,
    /// The values of basis functions at numbers that were asked for, if that is recorded.
    pub looked: Option<Vec<Look>>,
    /// The suprema that were compared.
    pub(super) found: Vec<Found>,
    pub(super) frames: usize,
    pub(super) depth: usize,
    pub(super) memo: Memo,
    /// The control values that were looked at since it was taken.
    pub(super) seen: Seen,
}

/// A value of a function, with its argument and what was looked at for it.
pub(super) struct Known {
    pub(super) argument: Value,
    pub(super) value: Value,
    pub(super) seen: Seen,
}

/// Where an argument is looked for among those that are known: few are at the same place.
#[derive(Debug, PartialEq, Eq, Hash)]
pub(super) enum Spot {
    Number(BigRational),
    Span(usize),
    Elsewhere,
}

/// The values of definitions that depend on their indices, their argument, the index of the moment, and on what changes
/// seldom, control values and other indices: found out while they are computed, by how far out the names lie that they look at.
#[derive(Default)]
pub(super) struct Memo {
    pub(super) known: HashMap<(Name, Vec<i64>, Weighting, Spot), Vec<Known>>,
    /// The outermost integer and real looked at since it was set.
    pub(super) outermost: (usize, usize),
}

pub(super) fn find<'b, T>(list: &'b [(Name, T)], name: &Name) -> Result<&'b T, Stop> {
    let found = list.iter().rev().find(|(known, _)| known == name);
    found.map(|(_, value)| value).ok_or_else(|| Stop::Unbound(name.to_string()))
}

/// A place in a list for an index, or that it does not exist.
pub(super) fn place(i: i64, count: usize, what: impl FnOnce() -> String) -> Result<usize, Stop> {
    usize::try_from(i).ok().filter(|i| *i < count).ok_or_else(|| Stop::Undefined(what()))
}

fn too_large() -> Stop {
    Stop::Unknown("an integer that is too large".into())
}

impl<'a> Reading<'a> {
    /// With nothing bound.
    #[must_use]
    pub fn new(on: &'a Instance, names: Names<'a>) -> Self {
        let (weights, bound) = (on.weights.clone(), Bound::default());
        Self {
            on,
            names,
            weights,
            bound,
            frame: None,
            looked: None,
            found: Vec::new(),
            frames: 0,
            depth: 0,
            memo: Memo::default(),
            seen: Seen::default(),
        }
    }

    pub(super) fn knots(&self) -> Result<&'a KnotVector, Stop> {
        self.on.knots().ok_or_else(|| Stop::Unbound("U".into()))
    }

    pub(super) fn degree(&self) -> Result<usize, Stop> {
        self.on.degree().ok_or_else(|| Stop::Unbound("k".into()))
    }

    /// The value of an integer.
    ///
    /// # Errors
    /// [`Stop`], if it has none.
    pub fn int(&mut self, t: &Int) -> Result<i64, Stop> {
        let signed = |n: usize| i64::try_from(n).map_err(|_| too_large());
        let mut two = |a: &Int, b: &Int| Ok::<_, Stop>((self.int(a)?, self.int(b)?));
        match t {
            Int::Number(n) => Ok(*n),
            Int::Bound(name) => {
                let at = self.bound.integers.iter().rposition(|(known, _)| known == name);
                let at = at.ok_or_else(|| Stop::Unbound(name.to_string()))?;
                self.memo.outermost.0 = self.memo.outermost.0.min(at);
                Ok(self.bound.integers[at].1)
            }
            Int::Degree => signed(self.degree()?),
            Int::M => signed(self.knots()?.m()),
            Int::Last => Ok(signed(self.knots()?.m())? - signed(self.degree()?)? - 1),
            Int::Plus(a, b)
            | Int::Minus(a, b)
            | Int::Times(a, b)
            | Int::Least(a, b)
            | Int::Greatest(a, b)
            | Int::Binomial(a, b) => {
                let (a, b) = two(a, b)?;
                combined(t, a, b).ok_or_else(too_large)
            }
            Int::Word(of) => words::count(self, of),
        }
    }

    /// The integers of a range.
    pub(super) fn range(&mut self, range: &Range) -> Result<std::ops::RangeInclusive<i64>, Stop> {
        Ok(self.int(&range.from)?..=self.int(&range.to)?)
    }

    /// With an integer bound for a while.
    pub(super) fn with_integer<T>(&mut self, name: &Name, i: i64, read: impl FnOnce(&mut Self) -> T) -> T {
        self.bound.integers.push((name.clone(), i));
        let result = read(self);
        self.bound.integers.pop();
        result
    }

    /// The value of a term.
    ///
    /// # Errors
    /// [`Stop`], if it has none.
    pub fn real(&mut self, t: &Real) -> Result<Value, Stop> {
        match t {
            Real::Number(q) => Ok(q.clone().into()),
            Real::Whole(i) => Ok(self.int(i)?.into()),
            Real::Bound(name) => self.bound_real(name),
            Real::Index(name) => {
                let alpha = self.index_named(name)?.alpha();
                alpha.map(Value::from).ok_or_else(|| Stop::Undefined(format!("{name} is infinite")))
            }
            Real::Ratio => Ok(self.own_index()?.ratio().clone().into()),
            Real::Infinity => Err(Stop::Undefined("infinity is no number".into())),
            Real::Knot(i) => {
                let (i, knots) = (self.int(i)?, self.knots()?);
                let at = place(i, knots.m() + 1, || format!("t[{i}] does not exist"))?;
                Ok(knots.t(at).clone().into())
            }
            Real::Coefficient(name, of) => self.coefficient(name, of),
            Real::Parameter(name, of) => {
                let of = of.iter().map(|i| self.int(i)).collect::<Result<Vec<_>, _>>()?;
                let member = self.weights.member().ok_or_else(|| Stop::Unbound(name.to_string()))?;
                member.parameter(name, &of).map(|value| value.clone().into()).map_err(Stop::Undefined)
            }
            Real::Plus(a, b) => self.real(a)?.plus(&self.real(b)?),
            Real::Minus(a, b) => self.real(a)?.minus(&self.real(b)?),
            Real::Times(a, b) => self.real(a)?.times(&self.real(b)?),
            Real::Over(a, b) => {
                let (a, b) = (self.real(a)?, self.real(b)?);
                self.quotient(&a, &b)
            }
            Real::Negated(a) => Ok(self.real(a)?.negated()),
            Real::Power(a, e) => {
                let (base, e) = (self.real(a)?, self.int(e)?);
                let power = (0..e.unsigned_abs()).try_fold(Value::from(1), |all, _| all.times(&base))?;
                if e < 0 { self.quotient(&1.into(), &power) } else { Ok(power) }
            }
            Real::Absolute(a) => {
                let a = self.real(a)?;
                Ok(if self.sign(&a)? == Sign::Negative { a.negated() } else { a })
            }
            Real::Root(a) => self.real(a)?.square_root(),
            Real::Least(a, b) | Real::Greatest(a, b) => {
                let fold = if matches!(t, Real::Least(..)) { Fold::Least } else { Fold::Greatest };
                let (a, b) = (self.real(a)?, self.real(b)?);
                self.combine(fold, a, b)
            }
            Real::Fold(fold, range, body) => {
                let mut range_of = self.range(range)?;
                if *fold == Fold::Sum {
                    range_of = self.local(range, body, range_of);
                }
                let mut all = None;
                for i in range_of {
                    let next = self.with_integer(&range.name, i, |own| own.real(body))?;
                    all = Some(match all {
                        None => next,
                        Some(all) => self.combine(*fold, all, next)?,
                    });
                }
                match (all, fold) {
                    (Some(all), _) => Ok(all),
                    (None, Fold::Sum) => Ok(0.into()),
                    (None, Fold::Product) => Ok(1.into()),
                    (None, _) => Err(Stop::Undefined("the extremum of nothing".into())),
                }
            }
            Real::Defined(name, of) => self.defined(name, of, None),
            Real::Value(f, argument) => self.apply(f, argument),
            Real::Word(of) => words::measure(self, of),
        }
    }

    fn bound_real(&mut self, name: &Name) -> Result<Value, Stop> {
        let at = self.bound.reals.iter().rposition(|(known, ..)| known == name);
        let at = at.ok_or_else(|| Stop::Unbound(name.to_string()))?;
        self.memo.outermost.1 = self.memo.outermost.1.min(at);
        let (_, value, id) = &self.bound.reals[at];
        if value.is_constant() || self.frame.as_ref().is_some_and(|frame| frame.id == *id) {
            return Ok(value.clone());
        }
        Err(Stop::Unknown(format!("{name} and another variable at once")))
    }

    pub(super) fn index_named(&mut self, name: &Name) -> Result<Index, Stop> {
        if &**name == "alpha" {
            return self.own_index().cloned();
        }
        find(&self.bound.indices, name).cloned()
    }

    /// The index of the moment.
    pub(super) fn own_index(&self) -> Result<&Index, Stop> {
        let none = || Stop::Unknown(format!("the family {} has no index", self.weights));
        self.weights.index().ok_or_else(none)
    }

    fn coefficient(&mut self, name: &Name, of: &[Int]) -> Result<Value, Stop> {
        let of = of.iter().map(|i| self.int(i)).collect::<Result<Vec<_>, _>>()?;
        let missing = || {
            let of: Vec<_> = of.iter().map(ToString::to_string).collect();
            format!("{name}[{}] does not exist", of.join(","))
        };
        let value = match (of.as_slice(), find(&self.bound.points, name), &self.on.points) {
            ([i], Ok(list), _) => {
                let at = place(*i, list.len(), missing)?;
                self.seen.add([at]);
                list.get(at)
            }
            ([i, c], _, Some(points)) => {
                let point = &points[place(*i, points.len(), missing)?];
                point.get(place(c - 1, point.len(), missing)?)
            }
            _ => return Err(Stop::Unbound(name.to_string())),
        };
        value.cloned().map(Value::from).ok_or_else(|| Stop::Undefined(missing()))
    }

    /// The sign of a value on the part that is looked at.
    ///
    /// # Errors
    /// [`Stop::Cut`], if there are several.
    pub fn sign(&mut self, value: &Value) -> Result<Sign, Stop> {
        match (value.number(), &mut self.frame) {
            (Some(q), _) => Ok(Sign::of(q)),
            (None, Some(frame)) => frame.sign(value),
            // A number with a root is a function on any frame.
            (None, None) => Frame::anywhere().sign(value),
        }
    }

    /// The sign of a − b on the part that is looked at.
    pub(super) fn sign_between(&mut self, a: &Value, b: &Value) -> Result<Sign, Stop> {
        match sign_of_difference(a, b) {
            Some(sign) => Ok(sign),
            None => self.sign(&a.minus(b)?),
        }
    }

    /// a/b: every division asks that b has no zero.
    pub(super) fn quotient(&mut self, a: &Value, b: &Value) -> Result<Value, Stop> {
        let zero = || Stop::Undefined("a denominator is 0".into());
        if self.sign(b)? == Sign::Zero {
            return Err(zero());
        }
        a.over(b)?.ok_or_else(zero)
    }

    fn combine(&mut self, fold: Fold, a: Value, b: Value) -> Result<Value, Stop> {
        let first = match fold {
            Fold::Sum => return a.plus(&b),
            Fold::Product => return a.times(&b),
            Fold::Least => Sign::Positive,
            Fold::Greatest => Sign::Negative,
        };
        Ok(if self.sign_between(&a, &b)? == first { b } else { a })
    }

    /// Another member of the family.
    pub(super) fn member(&mut self, member: &Member) -> Result<Weighting, Stop> {
        let weights = match member {
            Member::Dual => match &self.weights {
                Weighting::Index(index) => Weighting::Index(index.conjugate()),
                Weighting::Family(member) => member.dual(self.knots()?.m(), self.degree()?)?,
            },
            Member::Parameter(name, term) => match self.real(term)?.number() {
                Some(value) => self.weights.with(name, value.clone())?,
                None => return Err(Stop::Unknown(format!("a {name} that is no rational number"))),
            },
            Member::Index(_) | Member::Ratio(_) => Weighting::Index(self.other_index(member)?),
        };
        self.on.table(&weights).map_err(|error| Stop::Undefined(error.to_string()))?;
        Ok(weights)
    }

    fn other_index(&mut self, member: &Member) -> Result<Index, Stop> {
        let number = |value: Value| match value.number() {
            Some(q) => Ok(q.clone()),
            None => Err(Stop::Unknown("an index that is no rational number".into())),
        };
        let index = match member {
            Member::Index(Real::Infinity) => return Ok(Index::infinity()),
            Member::Index(Real::Index(name)) => return self.index_named(name),
            Member::Index(Real::Minus(from, alpha)) => match (&**from, &**alpha) {
                (Real::Whole(Int::Number(1)), Real::Index(name)) => {
                    return Ok(self.index_named(name)?.conjugate());
                }
                // ∞ is c − ∞.
                (from, Real::Index(name)) if self.index_named(name)?.is_infinite() => {
                    self.real(from)?;
                    return Ok(Index::infinity());
                }
                (from, alpha) => Index::from_alpha(number(self.real(from)?.minus(&self.real(alpha)?)?)?),
            },
            Member::Index(term) => Index::from_alpha(number(self.real(term)?)?),
            Member::Ratio(term) => Index::from_ratio(number(self.real(term)?)?),
            Member::Parameter(..) | Member::Dual => return self.own_index().cloned(),
        };
        index.map_err(|error| Stop::Undefined(error.to_string()))
    }

    /// With another member for a while.
    pub(super) fn with_weights<T>(&mut self, weights: Weighting, read: impl FnOnce(&mut Self) -> T) -> T {
        let before = std::mem::replace(&mut self.weights, weights);
        let result = read(self);
        self.weights = before;
        result
    }

    /// The truth of a formula on the part that is looked at.
    pub fn truth(&mut self, f: &Formula) -> Truth {
        match f {
            Formula::Chain(first, rest) => self.chain(first, rest),
            Formula::Within(t, interval) => {
                let low = if interval.from_closed { Relation::AtMost } else { Relation::Less };
                let high = if interval.to_closed { Relation::AtMost } else { Relation::Less };
                let x = self.real(t);
                let (from, to) = (self.real(&interval.from), self.real(&interval.to));
                self.atom(low, &from, &x).and(self.atom(high, &x, &to))
            }
            Formula::Among(j, from, to) => {
                let ends = self.int(j).and_then(|j| Ok((j, self.int(from)?, self.int(to)?)));
                ends.map(|(j, from, to)| (from..=to).contains(&j)).into()
            }
            Formula::Instance(names) => self.on.name.as_ref().is_some_and(|name| names.contains(name)).into(),
            Formula::Not(f) => self.truth(f).negated(),
            Formula::And(all) => self.fold(true, all.iter(), |own, f| own.truth(f)),
            Formula::Or(all) => self.fold(false, all.iter(), |own, f| own.truth(f)),
            Formula::Implies(a, b) => match self.truth(a) {
                Truth::False => Truth::True,
                a => a.negated().or(self.truth(b)),
            },
            Formula::Iff(a, b) => {
                let (a, b) = (self.truth(a), self.truth(b));
                a.clone().negated().or(b.clone()).and(b.negated().or(a))
            }
            Formula::All(Over::Integers(range), body) => self.over_integers(true, range, body),
            Formula::Some(Over::Integers(range), body) => self.over_integers(false, range, body),
            Formula::One(Over::Integers(range), body) => match self.range(range) {
                Ok(values) => {
                    let each =
                        values.map(|i| (self.with_integer(&range.name, i, |own| own.truth(body)), true));
                    exactly_one(each.collect())
                }
                Err(stop) => stop.into(),
            },
            Formula::All(Over::Reals(name, interval), body) => {
                let each = self.over_reals(name, interval, |own| own.truth(body), &Truth::False);
                each.map_or_else(Truth::from, |each| {
                    each.into_iter().fold(Truth::True, |all, (t, _)| all.and(t))
                })
            }
            Formula::Some(Over::Reals(name, interval), body) => {
                let each = self.over_reals(name, interval, |own| own.truth(body), &Truth::True);
                each.map_or_else(Truth::from, |each| {
                    each.into_iter().fold(Truth::False, |all, (t, _)| all.or(t))
                })
            }
            Formula::One(Over::Reals(name, interval), body) => {
                let each = self.over_reals(name, interval, |own| own.truth(body), &Truth::Mixed);
                each.map_or_else(Truth::from, exactly_one)
            }
            Formula::Word(of) => words::holds(self, of),
            Formula::Claim { id, printed } => match self.names.library.claim(id, *printed) {
                Some((sentence, definitions)) => self.sentence(sentence, Names { definitions, ..self.names }),
                None => Truth::Unknown(format!("there is no claim {id}")),
            },
        }
    }

    fn over_integers(&mut self, every: bool, range: &Range, body: &Formula) -> Truth {
        match self.range(range) {
            Ok(values) => {
                self.fold(every, values, |own, i| own.with_integer(&range.name, i, |own| own.truth(body)))
            }
            Err(stop) => stop.into(),
        }
    }

    /// `and` or `or` of a list, as far as it matters.
    fn fold<T>(
        &mut self,
        every: bool,
        list: impl Iterator<Item = T>,
        read: impl Fn(&mut Self, T) -> Truth,
    ) -> Truth {
        let mut all = Truth::from(every);
        for item in list {
            let next = read(self, item);
            all = if every { all.and(next) } else { all.or(next) };
            if all == Truth::from(!every) {
                break;
            }
        }
        all
    }

    /// Of equalities every pair, so that a = c counts where b does not exist; otherwise neighbours.
    fn chain(&mut self, first: &Real, rest: &[(Relation, Real)]) -> Truth {
        let special =
            self.chain_of_indices(first, rest).or_else(|| words::chain_of_suprema(self, first, rest));
        if let Some(truth) = special {
            return truth;
        }
        let terms = std::iter::once(first).chain(rest.iter().map(|(_, t)| t));
        let values: Vec<_> = terms.map(|t| self.real(t)).collect();
        let equalities = rest.iter().all(|(relation, _)| *relation == Relation::Equal);
        let mut all = Truth::True;
        for (b, (relation, _)) in rest.iter().enumerate() {
            for a in if equalities { 0..=b } else { b..=b } {
                all = all.and(self.atom(*relation, &values[a], &values[b + 1]));
            }
        }
        all
    }

    /// α = ∞, α = β, and their negations: ∞ is no number.
    fn chain_of_indices(&mut self, first: &Real, rest: &[(Relation, Real)]) -> Option<Truth> {
        let [(relation @ (Relation::Equal | Relation::Unequal), second)] = rest else { return None };
        let mut of = |t: &Real| match t {
            Real::Index(name) => self.index_named(name).ok(),
            Real::Infinity => Some(Index::infinity()),
            _ => None,
        };
        let equal = of(first)? == of(second)?;
        Some((equal == (*relation == Relation::Equal)).into())
    }

    fn atom(&mut self, relation: Relation, a: &Result<Value, Stop>, b: &Result<Value, Stop>) -> Truth {
        match (a, b) {
            (Ok(a), Ok(b)) => self.compare(relation, a, b).unwrap_or_else(Truth::from),
            (Err(Stop::Undefined(_)), Err(stop)) | (Err(stop), _) | (_, Err(stop)) => stop.clone().into(),
        }
    }

    fn compare(&mut self, relation: Relation, a: &Value, b: &Value) -> Result<Truth, Stop> {
        use Relation::{AtLeast, AtMost, Equal, Greater, Less, Unequal};
        let wanted = |sign: Sign| match sign {
            Sign::Negative => matches!(relation, Less | AtMost | Unequal),
            Sign::Zero => matches!(relation, Equal | AtMost | AtLeast),
            Sign::Positive => matches!(relation, Greater | AtLeast | Unequal),
        };
        // Pieces are in lowest terms: equal ones are the same.
        if a == b {
            return Ok(wanted(Sign::Zero).into());
        }
        if let Some(sign) = sign_of_difference(a, b) {
            return Ok(wanted(sign).into());
        }
        let difference = a.minus(b)?;
        let (Plain::Piece(_), None, Some(frame)) = (&difference.plain, &difference.root, &mut self.frame)
        else {
            return Ok(wanted(self.sign(&difference)?).into());
        };
        let signs = frame.signs(&difference.plain);
        let there =
            [(signs.negative, Sign::Negative), (signs.zero, Sign::Zero), (signs.positive, Sign::Positive)];
        let mut met = there.into_iter().filter(|(there, _)| *there).map(|(_, sign)| wanted(sign));
        let first = met.next().unwrap_or(true);
        Ok(if met.all(|next| next == first) {
            first.into()
        } else {
            frame.cut(&difference.plain);
            Truth::Mixed
        })
    }
}

/// Exactly one of the parts of which some are points; a true one that is no point holds many.
fn exactly_one(parts: Vec<(Truth, bool)>) -> Truth {
    let holding = parts.iter().filter(|(truth, _)| *truth == Truth::True);
    let (count, many) = holding.fold((0, false), |(n, many), (_, point)| (n + 1, many || !point));
    if many || count > 1 {
        return Truth::False;
    }
    let open =
        parts.into_iter().map(|(truth, _)| truth).find(|truth| !matches!(truth, Truth::True | Truth::False));
    open.unwrap_or_else(|| (count == 1).into())
}

impl Value {
    /// Is it the same on every cell?
    pub(super) fn is_constant(&self) -> bool {
        let number = |plain: &Plain| matches!(plain, Plain::Number(_));
        number(&self.plain) && self.root.as_ref().is_none_or(|(b, _)| number(b))
    }
}
