//! What a formula says at one place of x and for one choice of its integers: false, not decided, or goals to prove.

use crate::derive::parts;
use crate::env::{Env, binomial};
use crate::error::{Reason, Result};
use crate::fraction::Fraction;
use crate::place::{Copies, Facts, Form, Gap, Place};
use crate::poly::Sign;
use crate::section::Section;
use crate::token::{Kind, Node, tree};
use crate::work::spend;

/// Definitions are opened so deep.
const DEPTH: usize = 40;
/// A range of known length has so many numbers at most, an exponent is at most half of that.
const RANGE: i64 = 200;

/// Why there is no value.
pub(crate) enum Stop {
    /// It is not known, or not understood.
    Undecided,
    /// Something may not exist.
    Undefined,
    Rejected(Reason),
}

impl From<Reason> for Stop {
    fn from(reason: Reason) -> Self {
        Stop::Rejected(reason)
    }
}

type Found<T> = std::result::Result<T, Stop>;

#[derive(PartialEq)]
pub(crate) enum Truth<'t> {
    False,
    Undecided,
    Undefined,
    /// True if all of these are.
    Goals(Vec<Node<'t>>),
}

impl<'t> Truth<'t> {
    fn of(truth: bool) -> Self {
        if truth { Truth::Goals(Vec::new()) } else { Truth::False }
    }

    fn known(truth: Option<bool>) -> Self {
        truth.map_or(Truth::Undecided, Truth::of)
    }

    pub(crate) fn is_true(&self) -> bool {
        matches!(self, Truth::Goals(goals) if goals.is_empty())
    }

    fn and(self, other: Self) -> Self {
        match (self, other) {
            (Truth::False, _) | (_, Truth::False) => Truth::False,
            (Truth::Undefined, _) | (_, Truth::Undefined) => Truth::Undefined,
            (Truth::Undecided, _) | (_, Truth::Undecided) => Truth::Undecided,
            (Truth::Goals(mut goals), Truth::Goals(more)) => {
                goals.extend(more);
                Truth::Goals(goals)
            }
        }
    }

    fn or(self, other: Self) -> Self {
        match (self, other) {
            (a, b) if a.is_true() || b.is_true() => Truth::of(true),
            (Truth::False, other) | (other, Truth::False) => other,
            (Truth::Undefined, _) | (_, Truth::Undefined) => Truth::Undefined,
            _ => Truth::Undecided,
        }
    }

    fn not(self) -> Self {
        match self {
            Truth::False => Truth::of(true),
            truth if truth.is_true() => Truth::False,
            Truth::Goals(_) => Truth::Undecided,
            other => other,
        }
    }
}

/// Where a function is taken.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum At {
    /// At x.
    X,
    /// By the limits there.
    Left,
    Right,
    /// At t_0 + t_m − x.
    Mirrored,
}

/// What the name of a real stands for.
#[derive(Clone)]
pub(crate) enum Bound<'t> {
    Point(At),
    Free(Value<'t>),
}

/// A real number: its term, and its value where the knots and parameters tell that without a rule.
#[derive(Clone)]
pub(crate) struct Value<'t> {
    term: Node<'t>,
    plain: Option<Fraction>,
    /// It is this knot of the window.
    knot: Option<i64>,
}

impl<'t> Value<'t> {
    pub(crate) fn whole(value: i64) -> Self {
        Value { term: Node::whole_of(value), plain: Some(Fraction::integer(value)), knot: None }
    }

    fn is_zero(&self) -> bool {
        self.plain.as_ref().is_some_and(Fraction::is_zero)
    }

    fn is_one(&self) -> Result<bool> {
        self.plain.as_ref().map_or(Ok(false), |plain| Ok(plain.denominator()? == plain.num))
    }

    fn made(
        head: &'static str,
        [a, b]: [Self; 2],
        plain: impl Fn(&Fraction, &Fraction) -> Result<Fraction>,
    ) -> Result<Self> {
        let plain = a.plain.as_ref().zip(b.plain.as_ref()).map(|(a, b)| plain(a, b)).transpose()?;
        Ok(Value { term: Node::made(head, vec![a.term, b.term]), plain, knot: None })
    }

    fn plus(self, other: Self) -> Result<Self> {
        match () {
            () if self.is_zero() => Ok(other),
            () if other.is_zero() => Ok(self),
            () => Value::made("+", [self, other], Fraction::plus),
        }
    }

    fn minus(self, other: Self) -> Result<Self> {
        if other.is_zero() { Ok(self) } else { Value::made("-", [self, other], Fraction::minus) }
    }

    pub(crate) fn times(self, other: Self) -> Result<Self> {
        match () {
            () if self.is_zero() || other.is_zero() => Ok(Value::whole(0)),
            () if self.is_one()? => Ok(other),
            () if other.is_one()? => Ok(self),
            () => Value::made("*", [self, other], Fraction::times),
        }
    }
}

/// Numbers for everything, where a sentence is refuted.
#[derive(Clone)]
pub(crate) struct Numbers<'t> {
    pub(crate) x: Option<Node<'t>>,
    /// Where x is on its span.
    pub(crate) u: Option<Node<'t>>,
    pub(crate) knots: Vec<Node<'t>>,
    pub(crate) ratio: Node<'t>,
    /// (points NAME value…) and (index NAME ratio), among others.
    pub(crate) values: Vec<Node<'t>>,
}

impl<'t> Numbers<'t> {
    fn of(&self, kind: &'static str, name: &str, at: usize) -> Option<Node<'t>> {
        let list = |value: &Node<'t>| match value.fields(kind) {
            Ok([own, list @ ..]) if own.is_word(name) => list.get(at).cloned(),
            _ => None,
        };
        self.values.iter().find_map(list)
    }
}

pub(crate) struct Case<'c, 't> {
    definitions: &'c [Node<'t>],
    pub(crate) k: i64,
    pub(crate) place: Place,
    pub(crate) facts: Facts,
    /// The window and the parameters.
    pub(crate) section: Section<'t>,
    /// The parameters of the derivation, with what declares them.
    pub(crate) parameters: Vec<(&'static str, Node<'t>)>,
    /// The first and the last knot of the window, counted from s.
    pub(crate) shown: (i64, i64),
    /// Gaps that hypotheses close.
    closed: Vec<i64>,
    pub(crate) ints: Vec<(&'t str, Form)>,
    pub(crate) reals: Vec<(&'t str, Bound<'t>)>,
    /// The index of the knot that the point is.
    pub(crate) knot: Option<Form>,
    /// It is known that x is this knot.
    pub(crate) on_knot: bool,
    pub(crate) symmetric: bool,
    /// Integers run around the mirror image of the span.
    pub(crate) mirrored: bool,
    /// r of another member of the family.
    ratio: Option<Node<'t>>,
    pub(crate) numbers: Option<Numbers<'t>>,
    /// Something was not decided.
    pub(crate) undecided: bool,
    /// Names of far numbers so far.
    far: usize,
    depth: usize,
}

impl<'c, 't> Case<'c, 't> {
    /// A place, where knots coincide as hypotheses say that depend on no integer: t_a = t_b for these pairs. Nothing, if
    /// there is no such case.
    pub(crate) fn new(definitions: &'c [Node<'t>], k: i64, place: Place) -> Result<Self> {
        Ok(Case {
            definitions,
            k,
            place,
            facts: Facts::at(place, k),
            section: Section::new(&[], Env::default())?,
            parameters: Vec::new(),
            shown: place.shown(k),
            closed: Vec::new(),
            ints: Vec::new(),
            reals: Vec::new(),
            knot: None,
            on_knot: false,
            symmetric: false,
            mirrored: false,
            ratio: None,
            numbers: None,
            undecided: false,
            far: 0,
            depth: 0,
        })
    }

    /// Declares the origin and the windows, and nothing else.
    pub(crate) fn open(&mut self) -> Result<Vec<Node<'t>>> {
        let origin = Node::made("real", vec![Node::name_of("o")]);
        let fixed: Vec<_> = [origin].into_iter().chain(self.windows()).collect();
        self.section = Section::new(&fixed, Env::default())?;
        self.parameters.clear();
        Ok(fixed)
    }

    /// (window W FIRST GAP…), and if the knots are symmetric the reflected one.
    fn windows(&self) -> Vec<Node<'t>> {
        let (first, last) = self.shown;
        let gap = |e| match self.place.gap(e) {
            Gap::Some => Node::name_of("some"),
            Gap::Any if !self.closed.contains(&e) => Node::name_of("any"),
            _ => Node::whole_of(0),
        };
        let turn = match self.place {
            Place::Knot(Copies::Exactly(q)) => -q,
            _ => 0,
        };
        let reflected = |e: i64| match turn - e {
            of if !(first..last).contains(&of) => Node::name_of("any"),
            of if gap(of) == Node::whole_of(0) => gap(of),
            of => Node::made("W", vec![Node::whole_of(of)]),
        };
        let window = |name, first: i64, gaps: Vec<Node<'t>>| {
            let head = [Node::name_of(name), Node::whole_of(first)];
            Node::made("window", head.into_iter().chain(gaps).collect())
        };
        let mirror =
            self.symmetric.then(|| window("M", -self.k, (-self.k..=self.k).map(reflected).collect()));
        [window("W", first, (first..last).map(gap).collect())].into_iter().chain(mirror).collect()
    }

    /// A parameter, declared once.
    pub(crate) fn parameter(&mut self, sign: &'static str, name: Node<'t>) -> Result<Value<'t>> {
        if !self.parameters.iter().any(|(_, known)| *known == name) {
            self.section.declare(&Node::made(sign, vec![name.clone()]))?;
            self.parameters.push((sign, name.clone()));
        }
        self.leaf(name)
    }

    /// A term that the knots and parameters give a value.
    pub(crate) fn leaf(&self, term: Node<'t>) -> Result<Value<'t>> {
        let plain = Some(self.section.term(&term, &self.section.env)?);
        Ok(Value { term, plain, knot: None })
    }

    fn sign(&self, value: &Fraction) -> Sign {
        value.num.sign(&self.section.signs)
    }

    // Integers.

    fn int(&mut self, node: &Node<'t>) -> Found<Form> {
        spend(1 + self.ints.len())?;
        match &node.kind {
            Kind::Number(..) => return Ok(Form::number(0).plus(node.whole()?, &Form::number(1))?),
            Kind::Name("k") => return Ok(Form::number(self.k)),
            Kind::Name("n") => return Ok(Form::last(0)),
            Kind::Name("m") => return Ok(Form::last(self.k + 1)),
            Kind::Name(name) => {
                let known = self.ints.iter().rev().find(|(known, _)| known == name);
                return known.map(|(_, form)| form.clone()).ok_or(Stop::Undecided);
            }
            _ => {}
        }
        let (head, parts) = node.headed("an integer")?;
        if let ("mult", [of]) = (head, parts) {
            let [real] = of.part("real")?;
            return if self.is_point(real)? { self.multiplicity() } else { Err(Stop::Undecided) };
        }
        let [a, b] = parts else { return Err(Stop::Undecided) };
        let (a, b) = (self.int(a)?, self.int(b)?);
        let values = (self.facts.value(&a), self.facts.value(&b));
        match (head, values) {
            ("+", _) => Ok(a.plus(1, &b)?),
            ("-", _) => Ok(a.plus(-1, &b)?),
            ("*", (Some(factor), _)) => Ok(Form::number(0).plus(factor, &b)?),
            ("*", (_, Some(factor))) => Ok(Form::number(0).plus(factor, &a)?),
            ("min" | "max", _) => {
                let rises = match self.facts.is_nonnegative(&b.plus(-1, &a)?)? {
                    None => self.facts.is_nonnegative(&a.plus(-1, &b)?)?.map(|falls| !falls),
                    rises => rises,
                };
                rises.map(|rises| if rises == (head == "min") { a } else { b }).ok_or(Stop::Undecided)
            }
            ("binomial", (Some(n), Some(m))) if n >= 0 => Ok(Form::number(binomial(n, m)?)),
            _ => Err(Stop::Undecided),
        }
    }

    /// How often x is a knot.
    fn multiplicity(&self) -> Found<Form> {
        match self.place {
            Place::Inside | Place::Before | Place::After => Ok(Form::number(0)),
            Place::First(copies) | Place::Knot(copies) | Place::Last(copies) => {
                let far = matches!(copies, Copies::AtLeast(_)).then_some((0, 1)).into_iter().collect();
                Ok(Form { c: copies.least(), far, ..Form::default() })
            }
            Place::Start | Place::End => Err(Stop::Undecided),
        }
    }

    /// The value of an integer, which has to be one number.
    fn fixed(&mut self, node: &Node<'t>) -> Found<i64> {
        let form = self.int(node)?;
        self.facts.value(&form).ok_or(Stop::Undecided)
    }

    /// The index of (t I), if it can be read.
    pub(crate) fn index(&mut self, knot: &Node<'t>) -> Result<Option<Form>> {
        let [i] = knot.part("t")?;
        read(self.int(i))
    }

    fn surely(&self, form: &Form) -> Result<bool> {
        Ok(self.facts.is_nonnegative(form)? == Some(true))
    }

    /// Whether least ≤ i ≤ most for sure; otherwise something may not exist.
    fn exists(&self, i: &Form, most: &Form) -> Found<()> {
        let exists = self.surely(i)? && self.surely(&most.plus(-1, i)?)?;
        if exists { Ok(()) } else { Err(Stop::Undefined) }
    }

    /// The span of t_0 + t_m − x, with its value from the right but at t_m.
    fn mirror(&self) -> Found<Form> {
        let span = Form::last(self.k).plus(-1, &Form::near(0))?;
        match self.place {
            Place::Inside | Place::First(_) | Place::Last(_) => Ok(span),
            Place::Knot(Copies::Exactly(q)) => Ok(span.plus(q, &Form::number(1))?),
            _ => Err(Stop::Undecided),
        }
    }

    /// What an integer can be, with whether it is in the range for sure: all numbers of a range of known length, or else
    /// those around the span one by one, and the farther ones on each side.
    fn run(&mut self, low: &Node<'t>, high: &Node<'t>) -> Found<Vec<(Form, bool)>> {
        let (low, high) = (self.int(low)?, self.int(high)?);
        let one = Form::number(1);
        match self.facts.value(&high.plus(-1, &low)?) {
            Some(RANGE..) => return Err(Stop::Undecided),
            Some(length) => return (0..=length).map(|i| Ok((low.plus(i, &one)?, true))).collect(),
            None => {}
        }
        let reach = 2 * self.k + 3;
        let mut far = |from: &Form, c: i64, sign: i64| {
            self.far += 1;
            from.plus(1, &Form { c, far: [(self.far, sign)].into(), ..Form::default() })
        };
        let mut all = Vec::new();
        if self.place.on_span().is_some() {
            let ends = |centre: &Form, far: &mut dyn FnMut(&Form, i64, i64) -> Result<Form>| {
                Ok::<_, Reason>([far(centre, -reach - 1, -1)?, far(centre, reach + 1, 1)?])
            };
            let centre = Form::near(0);
            let ends = ends(&centre, &mut far)?;
            let centre = if self.mirrored { self.mirror()? } else { centre };
            let shift = centre.plus(-1, &Form::near(0))?;
            for e in -reach..=reach {
                all.push(centre.plus(e, &one)?);
            }
            for end in ends {
                all.push(end.plus(1, &shift)?);
            }
        } else {
            all.push(far(&low, 0, 1)?);
        }
        let mut found = Vec::new();
        for i in all {
            let ends = [i.plus(-1, &low)?, high.plus(-1, &i)?];
            let [a, b] = [self.facts.is_nonnegative(&ends[0])?, self.facts.is_nonnegative(&ends[1])?];
            if a != Some(false) && b != Some(false) {
                found.push((i, a == Some(true) && b == Some(true)));
            }
        }
        Ok(found)
    }

    /// Something for all that an integer can be, each in its range inside.
    pub(crate) fn each<T>(
        &mut self,
        [name, low, high]: [&Node<'t>; 3],
        mut of: impl FnMut(&mut Self, bool) -> Found<T>,
    ) -> Found<Vec<T>> {
        let (name, mut found) = (name.name()?, Vec::new());
        for (form, sure) in self.run(low, high)? {
            let ends = [form.plus(-1, &self.int(low)?)?, self.int(high)?.plus(-1, &form)?];
            let facts = self.facts.clone();
            if self.facts.assume(&ends[0])? && self.facts.assume(&ends[1])? {
                self.ints.push((name, form));
                let value = of(self, sure);
                self.ints.pop();
                self.facts = facts;
                found.push(value?);
            } else {
                self.facts = facts;
            }
        }
        Ok(found)
    }

    // Hypotheses.

    /// What comparisons of integers among hypotheses say of s and n; `false` if they can't all be true.
    pub(crate) fn learn(&mut self, hypotheses: &[Node<'t>]) -> Result<bool> {
        loop {
            let before = self.facts.clone();
            for hypothesis in hypotheses {
                if !self.learn_one(hypothesis)? {
                    return Ok(false);
                }
            }
            if before == self.facts {
                return Ok(true);
            }
        }
    }

    fn learn_one(&mut self, node: &Node<'t>) -> Result<bool> {
        let parts = match node.headed("a formula")? {
            ("chain", [a, step]) => {
                let (relation, [b]) = step.headed("a relation")? else { return step.wrong("a relation") };
                let (Ok(("int", [a])), Ok(("int", [b]))) = (a.headed(""), b.headed("")) else {
                    return Ok(true);
                };
                let (Some(a), Some(b)) = (read(self.int(a))?, read(self.int(b))?) else { return Ok(true) };
                let (up, down) = (b.plus(-1, &a)?, a.plus(-1, &b)?);
                let more = |form: Form| form.plus(-1, &Form::number(1));
                return match relation {
                    "=" => Ok(self.facts.assume(&up)? && self.facts.assume(&down)?),
                    "<=" => self.facts.assume(&up),
                    "<" => self.facts.assume(&more(up)?),
                    ">=" => self.facts.assume(&down),
                    ">" => self.facts.assume(&more(down)?),
                    _ => Ok(true),
                };
            }
            ("among", [i, low, high]) => {
                let all = (read(self.int(i))?, read(self.int(low))?, read(self.int(high))?);
                let (Some(i), Some(low), Some(high)) = all else { return Ok(true) };
                return Ok(self.facts.assume(&i.plus(-1, &low)?)? && self.facts.assume(&high.plus(-1, &i)?)?);
            }
            ("and" | "chain", _) => parts(node)?,
            _ => return Ok(true),
        };
        for part in parts {
            if !self.learn_one(&part)? {
                return Ok(false);
            }
        }
        Ok(true)
    }

    /// What t_a = t_b says, for hypotheses on no bound integer: the span is not between them, and the gaps are 0.
    pub(crate) fn coincide(&mut self, hypotheses: &[Node<'t>]) -> Result<bool> {
        let mut pairs = Vec::new();
        for hypothesis in hypotheses {
            let Ok(("chain", [a, step])) = hypothesis.headed("") else { continue };
            let Ok([b]) = step.part::<1>("=") else { continue };
            if self.place.on_span().is_some()
                && a.is("t")
                && b.is("t")
                && let (Some(a), Some(b)) = (self.index(a)?, self.index(b)?)
            {
                let rises = self.surely(&b.plus(-1, &a)?)?;
                if rises || self.surely(&a.plus(-1, &b)?)? {
                    pairs.push(if rises { (a, b) } else { (b, a) });
                }
            }
        }
        let (s, one) = (Form::near(0), Form::number(1));
        loop {
            let before = self.facts.clone();
            for (a, b) in &pairs {
                let at_first = *a == Form::number(0);
                let possible = match self.place {
                    // t_b = t_0 < x.
                    Place::Knot(copies) if at_first => {
                        self.facts.assume(&Form::near(-copies.least()).plus(-1, b)?)?
                    }
                    _ if self.surely(&s.plus(-1, a)?)? => self.facts.assume(&s.plus(-1, b)?)?,
                    _ if self.surely(&b.plus(-1, &s)?.plus(-1, &one)?)? => {
                        self.facts.assume(&a.plus(-1, &s)?.plus(-1, &one)?)?
                    }
                    _ => true,
                };
                if !possible {
                    return Ok(false);
                }
            }
            if before == self.facts {
                break;
            }
        }
        for (a, b) in &pairs {
            for e in self.shown.0..self.shown.1 {
                if self.surely(&Form::near(e).plus(-1, a)?)?
                    && self.surely(&b.plus(-1, &Form::near(e + 1))?)?
                {
                    self.closed.push(e);
                }
            }
        }
        Ok(self.closed.iter().all(|e| self.place.gap(*e) != Gap::Some))
    }

    // Formulas.

    pub(crate) fn truth(&mut self, node: &Node<'t>) -> Result<Truth<'t>> {
        match self.formula(node) {
            Ok(truth) => Ok(truth),
            Err(Stop::Undecided) => {
                self.undecided = true;
                Ok(Truth::Undecided)
            }
            Err(Stop::Undefined) => Ok(Truth::Undefined),
            Err(Stop::Rejected(reason)) => Err(reason),
        }
    }

    fn formula(&mut self, node: &Node<'t>) -> Found<Truth<'t>> {
        match node.headed("a formula")? {
            ("chain", [a, step]) => {
                let (relation, [b]) = step.headed("a relation")? else { return Err(Stop::Undecided) };
                match (a.headed(""), b.headed("")) {
                    (Ok(("int", [a])), Ok(("int", [b]))) => self.order(a, relation, b),
                    (Ok(("alpha", [name])), _) if b.is_word("infinity") && matches!(relation, "=" | "/=") => {
                        Ok(Truth::of(self.alpha(name)?.is_none() == (relation == "=")))
                    }
                    _ => {
                        let (a, b) = match (self.real(a), self.real(b)) {
                            (Ok(a), Ok(b)) => (a, b),
                            (Err(Stop::Undefined), _) | (_, Err(Stop::Undefined)) => {
                                return Err(Stop::Undefined);
                            }
                            (Err(stop), _) | (_, Err(stop)) => return Err(stop),
                        };
                        self.compare(a, relation, b)
                    }
                }
            }
            ("and" | "chain" | "in", _) => {
                parts(node)?.iter().try_fold(Truth::of(true), |all, part| Ok(all.and(self.truth(part)?)))
            }
            ("or", all) => all.iter().try_fold(Truth::False, |some, part| Ok(some.or(self.truth(part)?))),
            ("not", [of]) => Ok(self.truth(of)?.not()),
            ("=>", [a, b]) => Ok(self.truth(a)?.not().or(self.truth(b)?)),
            ("<=>", [a, b]) => {
                let there = self.truth(a)?.not().or(self.truth(b)?);
                Ok(there.and(self.truth(b)?.not().or(self.truth(a)?)))
            }
            ("among", [i, low, high]) => {
                let (i, low, high) = (self.int(i)?, self.int(low)?, self.int(high)?);
                let below = self.facts.is_nonnegative(&i.plus(-1, &low)?)?;
                Ok(Truth::known(below).and(Truth::known(self.facts.is_nonnegative(&high.plus(-1, &i)?)?)))
            }
            (head @ ("all" | "some"), [over, body]) => {
                let ("integers", [name, low, high]) = over.headed("a range")? else {
                    return Err(Stop::Undecided);
                };
                let all = head == "all";
                let each = self.each([name, low, high], |own, sure| {
                    let truth = own.truth(body)?;
                    // What may not be there must not matter.
                    Ok(if sure || truth == Truth::of(all) { truth } else { Truth::Undecided })
                })?;
                let together =
                    |so_far: Truth<'t>, truth| if all { so_far.and(truth) } else { so_far.or(truth) };
                Ok(each.into_iter().fold(Truth::of(all), together))
            }
            ("defined", [of]) => {
                let [real] = of.part("real")?;
                let value = self.real(real)?;
                Ok(match value.plain {
                    Some(_) => Truth::of(true),
                    None => Truth::Goals(vec![Node::made("defined", vec![value.term])]),
                })
            }
            _ => Err(Stop::Undecided),
        }
    }

    fn order(&mut self, a: &Node<'t>, relation: &str, b: &Node<'t>) -> Found<Truth<'t>> {
        let (a, b, one) = (self.int(a)?, self.int(b)?, Form::number(1));
        let (up, down) = (b.plus(-1, &a)?, a.plus(-1, &b)?);
        let known = |form: &Form| self.facts.is_nonnegative(form).map(Truth::known);
        Ok(match relation {
            "<=" => known(&up)?,
            ">=" => known(&down)?,
            "<" => known(&up.plus(-1, &one)?)?,
            ">" => known(&down.plus(-1, &one)?)?,
            "=" => known(&up)?.and(known(&down)?),
            _ => known(&up)?.and(known(&down)?).not(),
        })
    }

    fn compare(&mut self, a: Value<'t>, relation: &str, b: Value<'t>) -> Found<Truth<'t>> {
        let (Some(left), Some(right)) = (&a.plain, &b.plain) else {
            let (head, sides) = match relation {
                "=" => ("=", [a.term, b.term]),
                // What differs is shown to be greater, where that is so.
                ">" | "/=" => (">", [a.term, b.term]),
                ">=" => (">=", [a.term, b.term]),
                "<" => (">", [b.term, a.term]),
                _ => (">=", [b.term, a.term]),
            };
            return Ok(Truth::Goals(vec![Node::made(head, sides.into())]));
        };
        let down = left.minus(right)?;
        let [more, less] = [self.sign(&down), self.sign(&down.negated())];
        Ok(Truth::known(match (relation, more, less) {
            _ if down.is_zero() => Some(matches!(relation, "=" | "<=" | ">=")),
            (_, Sign::Positive, _) => Some(matches!(relation, ">" | ">=" | "/=")),
            (_, _, Sign::Positive) => Some(matches!(relation, "<" | "<=" | "/=")),
            (">=", Sign::Nonnegative, _) | ("<=", _, Sign::Nonnegative) => Some(true),
            ("<", Sign::Nonnegative, _) | (">", _, Sign::Nonnegative) => Some(false),
            _ => None,
        }))
    }

    // Terms.

    fn real(&mut self, node: &Node<'t>) -> Found<Value<'t>> {
        spend(1)?;
        match &node.kind {
            Kind::Number(..) => return Ok(self.leaf(node.clone())?),
            Kind::Name("ratio") if self.ratio.is_none() => return Ok(self.leaf(Node::name_of("r"))?),
            Kind::Name(_) => return Err(Stop::Undecided),
            _ => {}
        }
        match node.headed("a real")? {
            ("int", [i]) => Ok(Value::whole(self.fixed(i)?)),
            ("alpha", [name]) => self.alpha(name)?.ok_or(Stop::Undefined),
            ("x", []) => self.x(),
            ("var", [name]) => match self.bound(name)? {
                Bound::Point(At::Mirrored) => Err(Stop::Undecided),
                Bound::Point(_) => self.x(),
                Bound::Free(value) => Ok(value),
            },
            ("t", [i]) => {
                let i = self.int(i)?;
                self.knot(&i)
            }
            ("coefficient", [name, i]) => {
                let i = self.int(i)?;
                self.exists(&i, &Form::last(0))?;
                self.control(name.name()?, &i)
            }
            ("+", [a, b]) => Ok(self.real(a)?.plus(self.real(b)?)?),
            ("-", [a, b]) => Ok(self.real(a)?.minus(self.real(b)?)?),
            ("*", [a, b]) => Ok(self.real(a)?.times(self.real(b)?)?),
            ("neg", [a]) => Ok(self.real(a)?.times(Value::whole(-1))?),
            ("/", [a, b]) => {
                let (a, b) = (self.real(a)?, self.real(b)?);
                self.over(a, b)
            }
            ("^", [a, e]) => {
                let (a, e) = (self.real(a)?, self.fixed(e)?);
                if !(0..=RANGE / 2).contains(&e) {
                    return Err(Stop::Undecided);
                }
                Ok((0..e).try_fold(Value::whole(1), |power, _| power.times(a.clone()))?)
            }
            (head @ ("sum" | "product"), [name, low, high, body]) => {
                self.fold(head == "sum", [name, low, high], &|own| own.real(body))
            }
            ("of", [function, argument]) => self.of(function, argument),
            _ => Err(Stop::Undecided),
        }
    }

    fn bound(&self, name: &Node<'t>) -> Found<Bound<'t>> {
        let found = self.reals.iter().rev().find(|(known, _)| name.is_word(known));
        found.map(|(_, bound)| bound.clone()).ok_or(Stop::Undecided)
    }

    /// a/b, for a b that is never 0.
    fn over(&self, a: Value<'t>, b: Value<'t>) -> Found<Value<'t>> {
        let Some(below) = &b.plain else { return Err(Stop::Undecided) };
        match (below.is_zero(), self.sign(below), self.sign(&below.negated())) {
            (true, ..) => Err(Stop::Undefined),
            (_, Sign::Positive, _) | (_, _, Sign::Positive) if a.is_zero() => Ok(a),
            (_, Sign::Positive, _) | (_, _, Sign::Positive) => {
                Ok(Value::made("/", [a, b], |a, b| a.over(b, &self.section.signs))?)
            }
            _ => Err(Stop::Undecided),
        }
    }

    /// The numbers of an index, by which its parameter is told from others.
    fn labels(form: &Form) -> impl Iterator<Item = Node<'t>> {
        let last = form.far.keys().max().map_or(0, |last| last + 1);
        let far: Vec<_> = (0..last).map(|z| form.far.get(&z).copied().unwrap_or(0)).collect();
        [form.c, form.s, form.n].into_iter().chain(far).map(Node::whole_of)
    }

    /// A control value: a number of the point, or a parameter.
    fn control(&mut self, name: &'t str, i: &Form) -> Found<Value<'t>> {
        if let Some(numbers) = &self.numbers {
            let at = self.facts.value(i).and_then(|i| usize::try_from(i).ok());
            let value = at.and_then(|at| numbers.of("points", name, at)).ok_or(Stop::Undecided)?;
            return Ok(self.leaf(value)?);
        }
        let index = match self.facts.value(&i.plus(-1, &Form::near(0))?) {
            Some(e) => vec![Node::whole_of(e)],
            None if matches!(self.place, Place::Start | Place::End) => return Err(Stop::Undecided),
            None => Self::labels(i).collect(),
        };
        Ok(self.parameter("real", Node::made(name, index))?)
    }

    fn fold(
        &mut self,
        sum: bool,
        range: [&Node<'t>; 3],
        body: &dyn Fn(&mut Self) -> Found<Value<'t>>,
    ) -> Found<Value<'t>> {
        let here = self.folded(sum, range, body);
        match here {
            Err(Stop::Undecided | Stop::Undefined)
                if self.symmetric && !self.mirrored && self.mirror().is_ok() =>
            {
                self.mirrored = true;
                let there = self.folded(sum, range, body);
                self.mirrored = false;
                there
            }
            _ => here,
        }
    }

    fn folded(
        &mut self,
        sum: bool,
        range: [&Node<'t>; 3],
        body: &dyn Fn(&mut Self) -> Found<Value<'t>>,
    ) -> Found<Value<'t>> {
        let each = self.each(range, |own, sure| {
            let value = body(own)?;
            let neutral = if sum { value.is_zero() } else { value.is_one()? };
            // What may not be there must not matter.
            if sure || neutral { Ok(value) } else { Err(Stop::Undecided) }
        })?;
        let neutral = Value::whole(i64::from(!sum));
        Ok(each
            .into_iter()
            .try_fold(neutral, |all, value| if sum { all.plus(value) } else { all.times(value) })?)
    }

    /// x, if it is on the window.
    fn x(&mut self) -> Found<Value<'t>> {
        if let Some(numbers) = &self.numbers {
            return Ok(self.leaf(numbers.x.clone().ok_or(Stop::Undecided)?)?);
        }
        let Some(place) = self.place.on_span() else {
            return Ok(self.parameter("real", Node::name_of("outside"))?);
        };
        let x = Node::made("x", vec![Node::made(place, vec![Node::name_of("W"), Node::whole_of(0)])]);
        let x = self.leaf(x)?;
        Ok(self.leaf(Node::name_of("o"))?.plus(x)?)
    }

    /// With u as a number, where it is one.
    fn at_numbers(&self, term: Node<'t>) -> Node<'t> {
        match self.numbers.as_ref().and_then(|numbers| numbers.u.clone()) {
            None => term,
            Some(u) => Node::made("at", vec![Node::group_of(vec![Node::made("u", vec![u])]), term]),
        }
    }

    fn shown_knot(&self, e: i64) -> Found<Value<'t>> {
        let knot = self.leaf(Node::made("t", vec![Node::name_of("W"), Node::whole_of(e)]))?;
        Ok(Value { knot: Some(e), ..self.leaf(Node::name_of("o"))?.plus(knot)? })
    }

    /// t_i: a knot of the window, or one that is some way beyond one.
    fn knot(&mut self, i: &Form) -> Found<Value<'t>> {
        self.exists(i, &Form::last(self.k + 1))?;
        if let Some(numbers) = &self.numbers {
            let at = self.facts.value(i).and_then(|i| usize::try_from(i).ok());
            let value = at.and_then(|at| numbers.knots.get(at)).ok_or(Stop::Undecided)?;
            let knot = self.facts.value(&i.plus(-1, &Form::near(0))?);
            return Ok(Value { knot, ..self.leaf(value.clone())? });
        }
        let beyond =
            |own: &mut Self, side, sign| own.parameter(sign, Node::made(side, Self::labels(i).collect()));
        match self.place {
            Place::Before => return Ok(self.x()?.plus(beyond(self, "right", "positive")?)?),
            Place::After => return Ok(self.x()?.minus(beyond(self, "left", "positive")?)?),
            _ => {}
        }
        let (s, one) = (Form::near(0), Form::number(1));
        let at_most_s = |own: &Self| own.surely(&s.plus(-1, i)?);
        // All copies of x are x.
        let copy = match self.place {
            Place::First(_) => at_most_s(self)?.then_some(0),
            Place::Knot(Copies::AtLeast(q)) => {
                let one_of = self.surely(&i.plus(-1, &Form::near(1 - q))?)? && at_most_s(self)?;
                one_of.then_some(0)
            }
            Place::End | Place::Last(_) => self.surely(&i.plus(-1, &s)?.plus(-1, &one)?)?.then_some(1),
            _ => None,
        };
        let copy = match &self.knot {
            // From t_I = x to t_s = x.
            Some(knot) if self.on_knot && self.place.on_span() == Some("from") => {
                let between = self.surely(&i.plus(-1, knot)?)? && at_most_s(self)?;
                if between { Some(0) } else { copy }
            }
            _ => copy,
        };
        if let Some(e) = copy {
            return self.shown_knot(e);
        }
        let (first, last) = self.shown;
        match self.facts.bounds(&i.plus(-1, &s)?) {
            (Some(least), Some(most)) if least == most && (first..=last).contains(&least) => {
                self.shown_knot(least)
            }
            (_, Some(most)) if most <= last => {
                let base = most.max(first);
                let from_first = self.surely(&Form::number(0).plus(-1, i)?)?;
                // Knots before all copies of x are less, the first one of all is.
                let less = match self.place {
                    Place::Knot(Copies::Exactly(q)) => base > -q && (most <= -q || from_first),
                    Place::Knot(Copies::AtLeast(q)) => base > -q && from_first,
                    _ => false,
                };
                let by = beyond(self, "left", if less { "positive" } else { "nonnegative" })?;
                Ok(self.shown_knot(base)?.minus(by)?)
            }
            (Some(least), _) if least >= first => {
                let by = beyond(self, "right", "nonnegative")?;
                Ok(self.shown_knot(least.min(last))?.plus(by)?)
            }
            _ => Err(Stop::Undecided),
        }
    }

    // Functions.

    /// Whether a term is x.
    fn is_point(&mut self, node: &Node<'t>) -> Found<bool> {
        if let (Some(knot), true) = (self.knot.clone(), node.is("t"))
            && self.index(node)? == Some(knot)
        {
            return Ok(true);
        }
        let (value, x) = (self.real(node)?, self.x()?);
        match (value.plain, x.plain) {
            (Some(a), Some(b)) => Ok(a.minus(&b)?.is_zero()),
            _ => Ok(false),
        }
    }

    /// A function at an argument; of numbers, whatever the number is.
    fn of(&mut self, function: &Node<'t>, argument: &Node<'t>) -> Found<Value<'t>> {
        let (side, [x, member @ ..]) = argument.headed("an argument")? else { return Err(Stop::Undecided) };
        let ratio = match (member.first(), &self.ratio) {
            (None, ratio) => ratio.clone(),
            (Some(_), Some(_)) => return Err(Stop::Undecided),
            (Some(member), None) => Some(self.member(member)?),
        };
        let (at, moved) = match self.place_of(x) {
            Err(Stop::Undecided) if self.numbers.is_some() => {
                let plain = self.real(x)?.plain.ok_or(Stop::Undecided)?;
                (At::X, Node::number_of(&plain.num, &plain.denominator()?))
            }
            at => (at?, None),
        };
        let at = match (at, side) {
            (at, "at") => at,
            (At::X, "left") => At::Left,
            (At::X, "right") => At::Right,
            _ => return Err(Stop::Undecided),
        };
        let before = (std::mem::replace(&mut self.ratio, ratio), moved.map(|x| self.locate(x)).transpose()?);
        let value = self.function(function, at, 0);
        self.ratio = before.0;
        if let Some(before) = before.1 {
            self.restore(before);
        }
        value
    }

    fn member(&mut self, member: &Node<'t>) -> Found<Node<'t>> {
        let inverse = || Node::made("/", vec![Node::whole_of(1), Node::name_of("r")]);
        match member.headed("another index")? {
            ("alpha", [alpha]) if alpha.is_word("infinity") => Ok(Node::whole_of(1)),
            ("alpha", [alpha]) if *alpha == tree("(- (int 1) (alpha alpha))")? => Ok(inverse()),
            ("alpha", [alpha]) => match alpha.headed("an index")? {
                ("alpha", [name]) if !name.is_word("alpha") => self.other(name.name()?),
                _ => Err(Stop::Undecided),
            },
            ("ratio", [ratio]) => {
                let value = self.real(ratio)?;
                let positive = value.plain.as_ref().is_some_and(|plain| self.sign(plain) == Sign::Positive);
                if positive { Ok(value.term) } else { Err(Stop::Undecided) }
            }
            _ => Err(Stop::Undecided),
        }
    }

    /// r of another index that is bound.
    fn other(&mut self, name: &'t str) -> Found<Node<'t>> {
        match &self.numbers {
            Some(numbers) => numbers.of("index", name, 0).ok_or(Stop::Undecided),
            None => Ok(self.parameter("positive", Node::made(name, vec![Node::whole_of(0)]))?.term),
        }
    }

    /// An index α = r/(r − 1), as a number; nothing for ∞.
    fn alpha(&mut self, name: &Node<'t>) -> Found<Option<Value<'t>>> {
        if self.numbers.is_none() || self.ratio.is_some() {
            return Err(Stop::Undecided);
        }
        let name = name.name()?;
        let ratio = if name == "alpha" { Node::name_of("r") } else { self.other(name)? };
        let ratio = self.leaf(ratio)?;
        let less = ratio.clone().minus(Value::whole(1))?;
        if less.is_zero() { Ok(None) } else { self.over(ratio, less).map(Some) }
    }

    /// x, t_0 + t_m − x, or what the variable of a definition stands for.
    fn place_of(&mut self, node: &Node<'t>) -> Found<At> {
        if let Ok(("var", [name])) = node.headed("")
            && let Bound::Point(at) = self.bound(name)?
        {
            return Ok(at);
        }
        if let Ok(("-", [sum, x])) = node.headed("")
            && self.symmetric
            && *sum == tree("(+ (t 0) (t m))")?
            && self.place_of(x)? == At::X
        {
            return Ok(At::Mirrored);
        }
        if self.is_point(node)? { Ok(At::X) } else { Err(Stop::Undecided) }
    }

    /// A function, or its derivative of order 1.
    fn function(&mut self, node: &Node<'t>, at: At, order: i64) -> Found<Value<'t>> {
        match node.headed("a function")? {
            ("D", [of, by]) => match order + self.fixed(by)? {
                order @ 0..=1 => self.function(of, at, order),
                _ => Err(Stop::Undecided),
            },
            ("G", [i, degree @ ..]) => {
                let i = self.int(i)?;
                let degree = degree.first().map_or(Ok(self.k), |degree| self.fixed(degree))?;
                if !(0..=self.k).contains(&degree) {
                    return Err(Stop::Undefined);
                }
                self.exists(&i, &Form::last(self.k - degree))?;
                self.on_window(if order == 0 { "G" } else { "DG" }, &i, degree, at)
            }
            ("w", [i, degree]) => {
                let (i, degree) = (self.int(i)?, self.fixed(degree)?);
                if degree < 1 {
                    return Err(Stop::Undecided);
                }
                self.exists(&i, &Form::last(self.k + 1 - degree))?;
                self.on_window(if order == 0 { "w" } else { "Dw" }, &i, degree, at)
            }
            (head @ ("phi" | "f"), [a, b]) if at == At::X => {
                let (a, b) = (self.real(a)?, self.real(b)?);
                self.phi(head == "phi", a, b, order)
            }
            ("defined", [name, indices @ ..]) => self.defined(name, indices, at, order),
            _ => Err(Stop::Undecided),
        }
    }

    /// The weight of an interval between two knots of the window; φ is 0 outside of it.
    fn phi(&mut self, cut: bool, a: Value<'t>, b: Value<'t>, order: i64) -> Found<Value<'t>> {
        if cut {
            if order == 1 && self.place != Place::Inside {
                return Err(Stop::Undecided);
            }
            let x = self.x()?;
            let inside = self.compare(a.clone(), "<=", x.clone())?.and(self.compare(x, "<", b.clone())?);
            match inside {
                Truth::False => return Ok(Value::whole(0)),
                inside if inside.is_true() => {}
                _ => return Err(Stop::Undecided),
            }
        }
        let (Some(a @ ..=0), Some(b @ 1..)) = (a.knot, b.knot) else { return Err(Stop::Undecided) };
        self.term(if order == 0 { "w" } else { "Dw" }, a, b - a, 0, At::X)
    }

    /// A function at the place of span e.
    fn term(&self, head: &'static str, i: i64, degree: i64, e: i64, at: At) -> Found<Value<'t>> {
        let mirrored = at == At::Mirrored;
        let on = match (self.place, self.place.on_span()) {
            (_, None) => return Err(Stop::Undecided),
            (Place::First(_), _) if mirrored => "to",
            (_, Some("in")) => "in",
            _ if mirrored => "from",
            _ if e != 0 => "to",
            (_, Some(on)) => on,
        };
        let window = Node::name_of(if mirrored { "M" } else { "W" });
        let place = Node::made(on, vec![window, Node::whole_of(e)]);
        let mut term = Node::made(head, vec![Node::whole_of(i), Node::whole_of(degree), place]);
        let mut moved = Vec::new();
        if mirrored && self.place == Place::Inside {
            let inverse = Node::made("/", vec![Node::whole_of(1), Node::name_of("u")]);
            moved.push(Node::made("u", vec![inverse]));
        }
        moved.extend(self.ratio.iter().map(|ratio| Node::made("r", vec![ratio.clone()])));
        if !moved.is_empty() {
            term = Node::made("at", vec![Node::group_of(moved), term]);
        }
        match &self.numbers {
            None => Ok(Value { term, plain: None, knot: None }),
            Some(_) => Ok(self.leaf(self.at_numbers(term))?),
        }
    }

    /// A function that exists, at the place: 0 if it does not live on the span.
    fn on_window(&mut self, head: &'static str, i: &Form, degree: i64, at: At) -> Found<Value<'t>> {
        let basis = head.ends_with('G');
        let (span, e) = match (self.place, at) {
            (Place::Before | Place::After, _) | (Place::First(_), At::Left) => return Ok(Value::whole(0)),
            (Place::End | Place::Last(_), At::Right) => return Ok(Value::whole(0)),
            (_, At::Mirrored) if head == "G" => (self.mirror()?, 0),
            (_, At::Mirrored) | (Place::Start, At::Left) => return Err(Stop::Undecided),
            (Place::Knot(Copies::Exactly(q)), At::Left) => (Form::near(-q), -q),
            (Place::Knot(Copies::AtLeast(q)), At::Left) => {
                // The span on the left is s − Q, or before that.
                let zero = basis && self.surely(&i.plus(-1, &Form::near(1 - q))?)?;
                return if zero { Ok(Value::whole(0)) } else { Err(Stop::Undecided) };
            }
            _ => (Form::near(0), 0),
        };
        let from = i.plus(-1, &span)?;
        let until = Form::number(-degree - i64::from(basis)).plus(-1, &from)?;
        if self.surely(&from.plus(-1, &Form::number(1))?)? || self.surely(&until)? {
            return Ok(Value::whole(0));
        }
        let i = e + self.facts.value(&from).ok_or(Stop::Undecided)?;
        let (first, last) = self.shown;
        if !basis && (i < first || i + degree > last) {
            return Err(Stop::Undecided);
        }
        self.term(head, i, degree, e, at)
    }

    /// A definition for some indices, its variable at a place; or its derivative.
    fn defined(&mut self, name: &Node<'t>, indices: &[Node<'t>], at: At, order: i64) -> Found<Value<'t>> {
        if self.depth == DEPTH {
            return Err(Stop::Undecided);
        }
        let forms = indices.iter().map(|index| self.int(index)).collect::<Found<Vec<_>>>()?;
        for definition in self.definitions {
            let [own, patterns, variable, body] = definition.part("define")?;
            let Kind::List(patterns) = &patterns.kind else { continue };
            if own != name || patterns.len() != forms.len() {
                continue;
            }
            let (mut fits, mut ints) = (true, Vec::new());
            for (pattern, form) in patterns.iter().zip(&forms) {
                match pattern.whole() {
                    Ok(wanted) => fits &= self.facts.value(form).ok_or(Stop::Undecided)? == wanted,
                    Err(_) => ints.push((pattern.name()?, form.clone())),
                }
            }
            if fits {
                let reals = vec![(variable.name()?, Bound::Point(at))];
                let outer =
                    (std::mem::replace(&mut self.ints, ints), std::mem::replace(&mut self.reals, reals));
                self.depth += 1;
                let value = if order == 0 { self.real(body) } else { self.slope(body) };
                self.depth -= 1;
                (self.ints, self.reals) = outer;
                return value;
            }
        }
        Err(Stop::Undecided)
    }

    /// The derivative of the body of a definition.
    fn slope(&mut self, node: &Node<'t>) -> Found<Value<'t>> {
        if let Kind::Number(..) | Kind::Name("ratio") = node.kind {
            return Ok(Value::whole(0));
        }
        match node.headed("a real")? {
            // The only name of a real in a definition is that of its variable.
            ("var", _) => Ok(Value::whole(1)),
            ("int" | "t" | "coefficient", _) => self.real(node).map(|_| Value::whole(0)),
            ("+", [a, b]) => Ok(self.slope(a)?.plus(self.slope(b)?)?),
            ("-", [a, b]) => Ok(self.slope(a)?.minus(self.slope(b)?)?),
            ("neg", [a]) => Ok(self.slope(a)?.times(Value::whole(-1))?),
            ("*", [a, b]) => {
                let (f, g) = (self.real(a)?, self.real(b)?);
                Ok(self.slope(a)?.times(g)?.plus(f.times(self.slope(b)?)?)?)
            }
            ("sum", [name, low, high, body]) => self.fold(true, [name, low, high], &|own| own.slope(body)),
            ("of", [function, argument]) => match argument.headed("an argument")? {
                ("at", [x]) if x.is("var") => {
                    let at = self.place_of(x)?;
                    self.function(function, at, 1)
                }
                _ => Err(Stop::Undecided),
            },
            _ => Err(Stop::Undecided),
        }
    }
}

/// What is known, if anything is.
pub(crate) fn read<T>(found: Found<T>) -> Result<Option<T>> {
    match found {
        Ok(value) => Ok(Some(value)),
        Err(Stop::Rejected(reason)) => Err(reason),
        Err(_) => Ok(None),
    }
}
