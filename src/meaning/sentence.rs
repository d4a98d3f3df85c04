//! A sentence on an instance: everything that `for` leaves open, the innermost binder fastest.

use std::mem::take;
use std::rc::Rc;

use num_traits::{One, Signed, Zero};

use crate::analysis::IsolatedRoot;
use crate::language::{Binder, Formula, Gap, Int, Name, Range, Relation, Sentence};
use crate::scalar::{BigRational, integer, rational, rationals_between};
use crate::spline::{Basis, Index, KnotVector};

use super::adjectives::has;
use super::cell::{Cell, Focus};
use super::frame;
use super::instance::Instance;
use super::points;
use super::reading::{Found, Names, Reading};
use super::reals::Part;
use super::seen::{Branch, Course};
use super::tries;
use super::truth::{Stop, Truth};
use super::value::{Plain, Value};

/// What a name of `for` is bound to.
#[derive(Debug, Clone, PartialEq)]
pub enum Given {
    /// An integer.
    Integer(i64),
    /// A rational number.
    Real(BigRational),
    /// The irrational number of a cell at a root in its coordinate.
    Root(Box<(Cell, IsolatedRoot)>),
    /// An index besides α.
    Index(Index),
    /// Control values.
    Points(Vec<BigRational>),
}

/// Where a sentence fails on an instance.
#[derive(Debug, Clone, PartialEq)]
pub struct Failure {
    /// What is bound there, in the order of `for`.
    pub given: Vec<(Name, Given)>,
    /// The conclusion that fails; `None` is a hypothesis that is not defined.
    pub conclusion: Option<usize>,
    /// What does not exist; otherwise the conclusion is false.
    pub undefined: Option<String>,
    /// The knots that the sentence itself describes, in the place of the instance's.
    pub knots: Option<KnotVector>,
}

/// What a sentence comes to on an instance.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Decided {
    /// How many conclusions were found true.
    pub facts: usize,
    /// The first failure by values; if there is none, the first that speaks of what does not exist.
    pub failure: Option<Failure>,
    /// What could not be told.
    pub unknown: Option<String>,
    /// Were numbers or control values only tried, not decided for all?
    pub tried: bool,
    /// The suprema that were compared.
    pub found: Vec<Found>,
}

impl From<Decided> for Truth {
    fn from(decided: Decided) -> Self {
        match decided {
            Decided { failure: Some(Failure { undefined: Some(what), .. }), .. } => Self::Undefined(what),
            Decided { failure: Some(_), .. } => Self::False,
            Decided { unknown: Some(why), .. } => Self::Unknown(why),
            Decided { tried: true, .. } => Self::Unknown("numbers that were only tried".into()),
            Decided { .. } => Self::True,
        }
    }
}

/// What a sentence comes to on a part of a cell.
#[derive(Debug, Clone, PartialEq)]
enum Here {
    Nothing,
    Holds,
    Fails(usize),
    Undefined(Option<usize>, String),
    Unknown(String),
    Mixed,
}

impl Here {
    fn fails(&self) -> bool {
        matches!(self, Self::Fails(_))
    }
    fn undefined(&self) -> bool {
        matches!(self, Self::Undefined(..))
    }
}

/// On its way through what the names of a sentence stand for.
struct Walk<'s> {
    sentence: &'s Sentence,
    linear: bool,
    decided: Decided,
    course: Course,
}

impl Walk<'_> {
    fn done(&self) -> bool {
        self.decided.failure.as_ref().is_some_and(|failure| failure.undefined.is_none())
    }

    fn stopped(&mut self, stop: Stop, given: Vec<(Name, Given)>) {
        match stop {
            Stop::Undefined(what) if self.decided.failure.is_none() => {
                self.decided.failure =
                    Some(Failure { given, conclusion: None, undefined: Some(what), knots: None });
            }
            Stop::Undefined(_) => {}
            Stop::Cut => self.unknown("a range that changes inside a cell".into()),
            Stop::Unbound(name) => self.unknown(format!("{name} is not bound")),
            Stop::Unknown(why) => self.unknown(why),
        }
    }

    fn unknown(&mut self, why: String) {
        self.decided.unknown.get_or_insert(why);
    }
}

/// Decides a sentence on an instance: for every x of its intervals, every integer of its ranges, and the free reals, other
/// indices and control values of short lists.
#[must_use]
pub fn decide(sentence: &Sentence, on: &Instance, names: Names<'_>) -> Decided {
    Reading::new(on, names).decide(sentence)
}

/// Does the instance satisfy what `for` says of degree, knots, name and index? Sentences say nothing of others.
#[must_use]
pub fn concerns(sentence: &Sentence, on: &Instance) -> bool {
    sentence.given.iter().all(|binder| admits(binder, on))
}

/// What one binder says of them.
#[must_use]
pub fn admits(binder: &Binder, on: &Instance) -> bool {
    match binder {
        Binder::Degree { least, most } => {
            on.degree().is_some_and(|k| k >= *least && most.is_none_or(|most| k <= most))
        }
        Binder::Knots(adjectives) => on.basis.as_ref().is_some_and(|basis| {
            adjectives.iter().all(|adjective| has(*adjective, basis.knots(), basis.degree()))
        }),
        Binder::Instances(names) => on.name.as_ref().is_some_and(|name| names.contains(name)),
        Binder::Indices(list) => {
            on.weights.index().is_some_and(|index| list.iter().any(|alpha| index.alpha() == *alpha))
        }
        _ => true,
    }
}

impl<'a> Reading<'a> {
    /// With the names bound as at a failure.
    #[must_use]
    pub fn with(on: &'a Instance, names: Names<'a>, given: &[(Name, Given)]) -> Self {
        let mut reading = Self::new(on, names);
        for (name, given) in given {
            match given {
                Given::Integer(i) => reading.bound.integers.push((name.clone(), *i)),
                Given::Real(x) => reading.bound.reals.push((name.clone(), x.clone().into(), 0)),
                Given::Index(index) => reading.bound.indices.push((name.clone(), index.clone())),
                Given::Points(points) => reading.bound.points.push((name.clone(), points.clone())),
                Given::Root(place) => {
                    reading.enter(name, &place.0);
                    reading.focus(Focus::At(place.1.clone()));
                }
            }
        }
        reading
    }

    pub(super) fn sentence(&mut self, sentence: &Sentence, names: Names<'a>) -> Truth {
        if !concerns(sentence, self.on) {
            return Truth::True;
        }
        let mut own = Reading { depth: self.depth + 1, ..Reading::new(self.on, names) };
        if own.depth > 8 {
            return Truth::Unknown("claims that name each other".into());
        }
        own.weights = self.weights.clone();
        own.decide(sentence).into()
    }

    fn decide(&mut self, sentence: &Sentence) -> Decided {
        let linear = points::decided_by_units(sentence, self.names.definitions);
        let mut walk = Walk { sentence, linear, decided: Decided::default(), course: Course::Alone };
        if concerns(sentence, self.on) {
            self.binders(&sentence.given, &sentence.assume.iter().collect::<Vec<_>>(), &mut walk);
        }
        walk.decided.found = take(&mut self.found);
        walk.decided
    }

    /// Goes on with one value of a name. Where the control value that is not 0 was not looked at while it was, all goes as it went then:
    /// nothing is read a second time.
    fn branch<'s>(&mut self, walk: &mut Walk<'s>, read: impl FnOnce(&mut Self, &mut Walk<'s>)) {
        if walk.done() {
            return;
        }
        // What is read on a frame leaves cuts behind, for the branches after it.
        if self.frame.is_some() {
            return read(self, walk);
        }
        match take(&mut walk.course) {
            Course::Alone => read(self, walk),
            Course::Written(mut above) => {
                let (outside, facts) = (take(&mut self.seen), walk.decided.facts);
                walk.course = Course::Written(Branch::default());
                read(self, walk);
                if let Course::Written(mut branch) = take(&mut walk.course) {
                    branch.own = take(&mut self.seen);
                    branch.all.join(&branch.own);
                    branch.facts = walk.decided.facts - facts;
                    above.all.join(&branch.all);
                    above.branches.push(Rc::new(branch));
                }
                self.seen = outside;
                walk.course = Course::Written(above);
            }
            Course::Beside { unit, zero, next } => {
                match zero.branches.get(next) {
                    Some(branch) if !branch.all.has(unit) => walk.decided.facts += branch.facts,
                    Some(branch) if !branch.own.has(unit) => {
                        walk.course = Course::Beside { unit, zero: Rc::clone(branch), next: 0 };
                        read(self, walk);
                    }
                    _ => read(self, walk),
                }
                walk.course = Course::Beside { unit, zero, next: next + 1 };
            }
        }
    }

    /// Binds the first of the binders to all it can be, and goes on with the rest.
    fn binders(&mut self, rest: &[Binder], assume: &[&Formula], walk: &mut Walk<'_>) {
        if walk.done() {
            return;
        }
        // A hypothesis is read as soon as all its names are bound: a false one ends this branch.
        let mut pending = Vec::new();
        for formula in assume {
            match self.truth(formula) {
                Truth::False => return,
                Truth::True => {}
                _ => pending.push(*formula),
            }
        }
        let Some((first, others)) = rest.split_first() else { return self.leaf(&pending, walk) };
        match first {
            Binder::Degree { .. } | Binder::Knots(_) | Binder::Instances(_) | Binder::Indices(_) => {
                self.binders(others, &pending, walk);
            }
            Binder::Gaps(gaps) => match self.on_gaps(gaps) {
                Ok(on) => {
                    let known = walk.decided.failure.is_some();
                    let mut own = Reading { bound: self.bound.clone(), ..Reading::new(&on, self.names) };
                    own.binders(others, &pending, walk);
                    self.seen.join(&own.seen);
                    if let (false, Some(failure)) = (known, &mut walk.decided.failure) {
                        failure.knots = on.knots().cloned();
                    }
                    self.on.share_fault(&on);
                }
                Err(stop) => walk.stopped(stop, self.given(&walk.sentence.given, None)),
            },
            Binder::Index(name) => {
                for index in self.other_indices(walk.sentence) {
                    self.bound.indices.push((name.clone(), index));
                    self.branch(walk, |own, walk| own.binders(others, &pending, walk));
                    self.bound.indices.pop();
                    self.memo.known.clear();
                }
            }
            Binder::Integer(range) => match self.range(range) {
                Ok(values) => {
                    for i in values {
                        self.branch(walk, |own, walk| {
                            own.with_integer(&range.name, i, |own| own.binders(others, &pending, walk));
                        });
                    }
                }
                Err(stop) => walk.stopped(stop, self.given(&walk.sentence.given, None)),
            },
            Binder::Point(name, interval) => match self.cells(interval) {
                Ok(cells) => self.each_cell(name, &cells, others, &pending, walk),
                Err(stop) => walk.stopped(stop, self.given(&walk.sentence.given, None)),
            },
            Binder::Real { name, sign: None } if runs_over_all(name) => {
                let cells = self.line(None, None);
                self.each_cell(name, &cells, others, &pending, walk);
            }
            Binder::Real { .. } => {
                let free: Vec<_> = rest.iter().map_while(free).collect();
                let others = &rest[free.len()..];
                let decisive = self.decisive(&free, walk.sentence);
                walk.decided.tried |= decisive.is_none();
                // One number beside knots: first those that have to do with them.
                let beside = match (free.as_slice(), self.on.knots()) {
                    ([(_, None)], Some(knots)) => {
                        tries::numbers(knots).into_iter().map(|x| vec![x]).collect()
                    }
                    _ => Vec::new(),
                };
                let tries = || beside.into_iter().chain(by_size(&free, self.on.basis.is_some())).collect();
                for values in decisive.unwrap_or_else(tries) {
                    let before = self.bound.reals.len();
                    let named =
                        free.iter().zip(values).map(|((name, _), value)| ((*name).clone(), value.into(), 0));
                    self.bound.reals.extend(named);
                    self.branch(walk, |own, walk| own.binders(others, &pending, walk));
                    self.bound.reals.truncate(before);
                }
            }
            Binder::Points(name) => {
                let Some(basis) = &self.on.basis else {
                    return walk.unknown("control values without a basis".into());
                };
                walk.decided.tried |= !walk.linear;
                let more = if walk.linear {
                    Vec::new()
                } else {
                    tries::control_values(self.on, &self.weights, basis)
                };
                let count = basis.n() + 1;
                // Of a list of control values inside of another one nothing is written down, and the reference skips nothing.
                let outer = take(&mut walk.course);
                let written = matches!(outer, Course::Alone) && !self.on.is_reference();
                let mut with = |values, walk: &mut Walk<'_>| {
                    self.bound.points.push((name.clone(), values));
                    self.branch(walk, |own, walk| own.binders(others, &pending, walk));
                    self.bound.points.pop();
                    // Definitions may speak of them.
                    self.memo.known.clear();
                };
                for unit in std::iter::once(None).chain((0..count).map(Some)) {
                    if written {
                        walk.course = take(&mut walk.course).with_unit(unit);
                    }
                    with(points::unit(count, unit), walk);
                }
                walk.course = outer;
                more.into_iter().for_each(|values| with(values, walk));
            }
        }
    }

    /// Values of free numbers that decide the sentence for all of them, where a reason for that is known.
    fn decisive(
        &self,
        free: &[(&Name, Option<Relation>)],
        sentence: &Sentence,
    ) -> Option<Vec<Vec<BigRational>>> {
        let size = self.on.knots().zip(self.on.degree());
        let size = size.and_then(|(knots, k)| Some((i64::try_from(k).ok()?, i64::try_from(knots.m()).ok()?)));
        match free {
            [(name, sign)] => {
                let degree = points::degree_in(name, sentence, self.names.definitions, size)?;
                let signs = match sign {
                    None | Some(Relation::AtLeast) => 0..=degree,
                    Some(Relation::Greater | Relation::Unequal) => 1..=degree + 1,
                    Some(_) => return None,
                };
                Some(signs.map(|value| vec![integer(value)]).collect())
            }
            [(_, None), (_, None)] if self.on.basis.is_none() && frame::is_decided_by_order(sentence) => {
                Some([[0, 0], [0, 1], [1, 0]].map(|ends| ends.map(|end: i64| integer(end)).to_vec()).to_vec())
            }
            _ => None,
        }
    }

    /// The degree and the index on the knots with t_0 = 0 and these gaps.
    fn on_gaps(&mut self, gaps: &[Gap]) -> Result<Instance, Stop> {
        let mut knots = vec![integer(0)];
        for Gap { each, size } in gaps {
            let once = Range { name: "".into(), from: Int::Number(0), to: Int::Number(0) };
            let each = each.as_ref().unwrap_or(&once);
            for i in self.range(each)? {
                let size = self.with_integer(&each.name, i, |own| own.real(size))?;
                let size = size.number().filter(|size| !size.is_negative());
                let size =
                    size.ok_or_else(|| Stop::Undefined("a gap that is no rational number ≥ 0".into()))?;
                knots.push(&knots[knots.len() - 1] + size);
            }
        }
        let knots = KnotVector::new(knots).map_err(|error| Stop::Undefined(error.to_string()))?;
        let basis = Basis::over(knots, self.degree()?, self.weights.clone());
        let basis = basis.map_err(|error| Stop::Undefined(error.to_string()))?;
        Instance::on(basis).map_err(|error| Stop::Undefined(error.to_string()))
    }

    /// What an index besides α runs over: the list of the sentence, or what the instance is shown for, or some indices.
    fn other_indices(&self, sentence: &Sentence) -> Vec<Index> {
        let some = || [-1, 2, -2, 3].into_iter().filter_map(|alpha| Index::from_alpha(integer(alpha)).ok());
        let shown = Some(self.on.shown.clone()).filter(|shown| !shown.is_empty());
        let all = listed(sentence).or(shown);
        let mut all = all.unwrap_or_else(|| some().chain([Index::infinity()]).collect());
        all.retain(|index| Some(index) != self.weights.index());
        all
    }

    fn each_cell(
        &mut self,
        name: &Name,
        cells: &[Cell],
        others: &[Binder],
        pending: &[&Formula],
        walk: &mut Walk<'_>,
    ) {
        for cell in cells {
            self.branch(walk, |own, walk| own.within(name, cell, |own| own.binders(others, pending, walk)));
        }
    }

    /// The sentence with everything bound.
    fn here(&mut self, assume: &[&Formula], then: &[Formula]) -> Here {
        match assume.iter().fold(Truth::True, |all, f| all.and(self.truth(f))) {
            Truth::True => {}
            Truth::False => return Here::Nothing,
            Truth::Mixed => return Here::Mixed,
            Truth::Unknown(why) => return Here::Unknown(why),
            // A hypothesis that speaks of what does not exist is a fault of the sentence, not a way out of it.
            Truth::Undefined(what) => return Here::Undefined(None, what),
        }
        let mut all = Here::Holds;
        for (at, f) in then.iter().enumerate() {
            match (self.truth(f), &all) {
                (Truth::False, _) => return Here::Fails(at),
                (Truth::Mixed, _) => all = Here::Mixed,
                (Truth::Unknown(why), Here::Holds | Here::Undefined(..)) => all = Here::Unknown(why),
                (Truth::Undefined(what), Here::Holds) => all = Here::Undefined(Some(at), what),
                _ => {}
            }
        }
        all
    }

    fn leaf(&mut self, pending: &[&Formula], walk: &mut Walk<'_>) {
        let then = &walk.sentence.then;
        let mut here = |own: &mut Self| own.here(pending, then);
        let parts = if self.frame.is_some() {
            self.by_parts(&mut |own| {
                let here = here(own);
                (here.clone(), here == Here::Mixed)
            })
        } else {
            vec![(Part::Whole, here(self))]
        };
        for (_, here) in &parts {
            match here {
                Here::Holds => walk.decided.facts += then.len(),
                Here::Unknown(why) => walk.unknown(why.clone()),
                Here::Mixed => walk.unknown("a cell that is not one after all cuts".into()),
                Here::Nothing | Here::Fails(_) | Here::Undefined(..) => {}
            }
        }
        let failure = self.locate(&parts, Here::fails, &mut here, walk.sentence);
        if failure.is_some() {
            walk.decided.failure = failure;
        } else if walk.decided.failure.is_none() {
            walk.decided.failure = self.locate(&parts, Here::undefined, &mut here, walk.sentence);
        }
    }

    /// A place where the sentence fails in a way: at a simple rational of the cell, if it does at one.
    fn locate(
        &mut self,
        parts: &[(Part, Here)],
        fails: fn(&Here) -> bool,
        here: &mut dyn FnMut(&mut Self) -> Here,
        sentence: &Sentence,
    ) -> Option<Failure> {
        /// Few of the simple rationals are zeros.
        const PLACES: usize = 100;
        let failing: Vec<_> = parts.iter().filter(|(_, here)| fails(here)).collect();
        let (first, known) = failing.first()?;
        let Some(frame) = &self.frame else { return Some(self.failure(known, sentence, None)) };
        let cell = frame.cell.clone();
        let open = failing.iter().find_map(|(part, _)| match part {
            Part::Whole => Some(BigRational::one()),
            Part::Between(u) => Some(u.clone()),
            Part::Point(_) | Part::Root(_) => None,
        });
        let points = failing
            .iter()
            .find_map(|(part, _)| if let Part::Point(x) = part { Some(x.clone()) } else { None });
        let candidates = match open {
            Some(u) => {
                let sample = frame.x(&u);
                simple(&cell).take(PLACES).chain(sample).collect()
            }
            None => Vec::from_iter(points),
        };
        for x in candidates {
            let found = self.at_point(&x, here);
            if fails(&found) {
                let given = Given::Real(x);
                return Some(self.failure(&found, sentence, Some(given)));
            }
        }
        let Part::Root(root) = first else { return Some(self.failure(known, sentence, None)) };
        Some(self.failure(known, sentence, Some(Given::Root(Box::new((cell, root.clone()))))))
    }

    fn failure(&self, here: &Here, sentence: &Sentence, at: Option<Given>) -> Failure {
        let (conclusion, undefined) = match here {
            Here::Fails(at) => (Some(*at), None),
            Here::Undefined(at, what) => (*at, Some(what.clone())),
            Here::Nothing | Here::Holds | Here::Unknown(_) | Here::Mixed => (None, None),
        };
        Failure { given: self.given(&sentence.given, at), conclusion, undefined, knots: None }
    }

    /// What the names of `for` are bound to; the variable of the frame to what is given for it.
    fn given(&self, binders: &[Binder], at: Option<Given>) -> Vec<(Name, Given)> {
        let own = |name: &Name| {
            let bound = &self.bound;
            let integer =
                || bound.integers.iter().find(|(known, _)| known == name).map(|(_, i)| Given::Integer(*i));
            let index = || {
                bound.indices.iter().find(|(known, _)| known == name).map(|(_, i)| Given::Index(i.clone()))
            };
            let points = || {
                bound.points.iter().find(|(known, _)| known == name).map(|(_, d)| Given::Points(d.clone()))
            };
            let real = || {
                let (_, value, id) = bound.reals.iter().find(|(known, ..)| known == name)?;
                match (&at, &self.frame) {
                    (Some(at), Some(frame)) if frame.id == *id => return Some(at.clone()),
                    _ => {}
                }
                match value {
                    Value { plain: Plain::Number(q), root: None } => Some(Given::Real(q.clone())),
                    // Of another variable nothing was asked: any place of its cell will do.
                    Value { plain, .. } => plain.piece().evaluate(&BigRational::one()).map(Given::Real),
                }
            };
            integer().or_else(real).or_else(index).or_else(points)
        };
        binders.iter().filter_map(name_of).filter_map(|name| Some((name.clone(), own(name)?))).collect()
    }
}

fn name_of(binder: &Binder) -> Option<&Name> {
    match binder {
        Binder::Degree { .. }
        | Binder::Knots(_)
        | Binder::Gaps(_)
        | Binder::Instances(_)
        | Binder::Indices(_) => None,
        Binder::Integer(range) => Some(&range.name),
        Binder::Index(name) | Binder::Point(name, _) | Binder::Real { name, .. } | Binder::Points(name) => {
            Some(name)
        }
    }
}

/// `x` and `y` without an interval are every real; other free names are numbers of the case.
fn runs_over_all(name: &Name) -> bool {
    matches!(&**name, "x" | "y")
}

fn free(binder: &Binder) -> Option<(&Name, Option<Relation>)> {
    match binder {
        Binder::Real { name, sign } if sign.is_some() || !runs_over_all(name) => Some((name, *sign)),
        _ => None,
    }
}

/// Simple rationals of an open cell, simplest first.
fn simple(cell: &Cell) -> Box<dyn Iterator<Item = BigRational>> {
    match cell {
        Cell::Point(x) => Box::new(std::iter::once(x.clone())),
        Cell::Open(Some(a), Some(b)) => Box::new(rationals_between(a, b)),
        Cell::Open(Some(a), None) => {
            let first = a.floor();
            Box::new((1..).map(move |n: i64| &first + integer(n)))
        }
        Cell::Open(None, b) => {
            let last = b.as_ref().map_or_else(|| integer(0), BigRational::ceil);
            Box::new((1..).map(move |n: i64| &last - integer(n)))
        }
    }
}

/// The indices of the list that α runs over, if there is one.
#[must_use]
pub fn listed(sentence: &Sentence) -> Option<Vec<Index>> {
    let index = |alpha: &Option<BigRational>| match alpha {
        Some(alpha) => Index::from_alpha(alpha.clone()).ok(),
        None => Some(Index::infinity()),
    };
    sentence.given.iter().find_map(|binder| match binder {
        Binder::Indices(list) => Some(list.iter().filter_map(index).collect()),
        _ => None,
    })
}

/// Values of free reals, all together in order of size: by the sum of their places in a list of simple numbers.
fn by_size(free: &[(&Name, Option<Relation>)], on_knots: bool) -> Vec<Vec<BigRational>> {
    const SIMPLE: [(i64, i64); 12] =
        [(0, 1), (1, 1), (-1, 1), (2, 1), (1, 2), (-2, 1), (3, 1), (-1, 2), (1, 3), (3, 2), (-3, 1), (4, 1)];
    /// How many of these, for one, two, … names.
    const EACH: [usize; 5] = [12, 7, 6, 4, 3];
    let each = EACH[free.len().clamp(1, EACH.len()) - 1];
    let each = if on_knots { each.div_ceil(4).max(2) } else { each };
    let fits = |sign: Option<Relation>, q: &BigRational| match sign {
        Some(Relation::Greater) => q.is_positive(),
        Some(Relation::Less) => q.is_negative(),
        Some(Relation::AtLeast) => !q.is_negative(),
        Some(Relation::AtMost) => !q.is_positive(),
        Some(Relation::Unequal) => !q.is_zero(),
        Some(Relation::Equal) => q.is_zero(),
        None => true,
    };
    let mut all = vec![(0, Vec::new())];
    for (_, sign) in free {
        let list: Vec<_> =
            SIMPLE.iter().map(|(p, q)| rational(*p, *q)).filter(|q| fits(*sign, q)).take(each).collect();
        let longer = |(size, values): &(usize, Vec<BigRational>)| {
            let next = |(place, q): (usize, &BigRational)| {
                (size + place, [values.as_slice(), std::slice::from_ref(q)].concat())
            };
            list.iter().enumerate().map(next).collect::<Vec<_>>()
        };
        all = all.iter().flat_map(longer).collect();
    }
    all.sort_by_key(|(size, _)| *size);
    all.into_iter().map(|(_, values)| values).collect()
}
