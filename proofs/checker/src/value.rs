//! The terms of a sentence in a case: what they are on the window.

use std::rc::Rc;

use crate::case::{At, Bound, Case, Found, Stop};
use crate::error::Result;
use crate::fraction::Fraction;
use crate::integers::RANGE;
use crate::place::{Copies, Form, Place};
use crate::poly::Sign;
use crate::token::{Kind, Node};

/// A real number: its term, and its value where the knots and parameters tell that without a rule.
#[derive(Clone)]
pub(crate) struct Value<'t> {
    pub(crate) term: Node<'t>,
    pub(crate) plain: Option<Rc<Fraction>>,
    /// It is this knot of the window.
    pub(crate) knot: Option<i64>,
}

impl<'t> Value<'t> {
    pub(crate) fn whole(value: i64) -> Self {
        Value { term: Node::whole_of(value), plain: Some(Fraction::integer(value).into()), knot: None }
    }

    pub(crate) fn is_zero(&self) -> bool {
        self.plain.as_ref().is_some_and(|plain| plain.is_zero())
    }

    fn is_one(&self) -> Result<bool> {
        self.plain.as_ref().map_or(Ok(false), |plain| Ok(plain.denominator()? == plain.num))
    }

    pub(crate) fn made(
        head: &'static str,
        [a, b]: [Self; 2],
        plain: impl Fn(&Fraction, &Fraction) -> Result<Fraction>,
    ) -> Result<Self> {
        let plain =
            a.plain.as_ref().zip(b.plain.as_ref()).map(|(a, b)| plain(a, b)).transpose()?.map(Rc::new);
        Ok(Value { term: Node::made(head, vec![a.term, b.term]), plain, knot: None })
    }

    pub(crate) fn plus(self, other: Self) -> Result<Self> {
        match () {
            () if self.is_zero() => Ok(other),
            () if other.is_zero() => Ok(self),
            () => Value::made("+", [self, other], Fraction::plus),
        }
    }

    pub(crate) fn minus(self, other: Self) -> Result<Self> {
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

impl<'t> Case<'_, 't> {
    pub(crate) fn real(&mut self, node: &Node<'t>) -> Found<Value<'t>> {
        self.deeper(|own| own.real_part(node))
    }

    fn real_part(&mut self, node: &Node<'t>) -> Found<Value<'t>> {
        match &node.kind {
            Kind::Number(..) => return Ok(self.leaf(node.clone())?),
            Kind::Name("ratio") if self.member.is_none() => return Ok(self.leaf(Node::name_of("r"))?),
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
            ("parameter", [name, indices @ ..]) if self.member.is_none() => {
                self.family_parameter(name, indices)
            }
            ("coefficient", [name, i]) => {
                let i = self.int(i)?;
                self.exists(&i, &Form::last(0))?;
                self.control(name.name()?, &i)
            }
            ("coefficient", [name, i, coordinate]) if name.is_word("P") => {
                let (i, coordinate) = (self.fixed(i)?, self.fixed(coordinate)?);
                let numbers = self.numbers.as_ref().ok_or(Stop::Undecided)?;
                Ok(self.leaf(numbers.coordinate(i, coordinate).ok_or(Stop::Undecided)?)?)
            }
            ("defined", [name, indices @ ..]) => self.defined(name, indices, At::X, 0),
            ("abs", [a]) => {
                let a = self.real(a)?;
                let negative = a.clone().times(Value::whole(-1))?;
                self.greatest(a, negative, true)
            }
            (head @ ("min" | "max"), [a, b]) => {
                let (a, b) = (self.real(a)?, self.real(b)?);
                self.greatest(a, b, head == "max")
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

    /// A parameter of the family: a number, or one of a knot of the window.
    fn family_parameter(&mut self, name: &Node<'t>, indices: &[Node<'t>]) -> Found<Value<'t>> {
        let family = self.family.clone();
        let own = family.parameter(name.name()?).ok_or(Stop::Undecided)?;
        if own.indices.is_empty() {
            return Ok(self.leaf(Node::name_of(own.name))?);
        }
        let mut fields = vec![Node::name_of("W"), name.clone()];
        let degree = own.indices.iter().zip(indices).find(|(index, _)| **index == "d");
        let degree = degree.map_or(Ok(0), |(_, degree)| self.fixed(degree))?;
        for (index, node) in own.indices.iter().zip(indices) {
            let i = self.int(node)?;
            fields.push(Node::whole_of(if *index == "d" {
                degree
            } else {
                self.exists(&i, &Form::last(self.k + 1 - degree))?;
                let e = self.facts.value(&i.plus(-1, &Form::near(0))?).ok_or(Stop::Undecided)?;
                // Numbers are counted as they are, the knots of other windows from t_s.
                let from = if self.numbers.is_some() { self.shown.0 } else { 0 };
                let shown = self.shown.0..=self.shown.1;
                if shown.contains(&e) { e - from } else { return Err(Stop::Undecided) }
            }));
        }
        match self.place.on_span() {
            Some(_) if (0..=self.k).contains(&degree) => Ok(self.leaf(Node::made("parameter", fields))?),
            Some(_) => Err(Stop::Undefined),
            None => Err(Stop::Undecided),
        }
    }

    pub(crate) fn bound(&self, name: &Node<'t>) -> Found<Bound<'t>> {
        let found = self.reals.iter().rev().find(|(known, _)| name.is_word(known));
        found.map(|(_, bound)| bound.clone()).ok_or(Stop::Undecided)
    }

    /// The greater one of two, or the smaller one.
    fn greatest(&mut self, a: Value<'t>, b: Value<'t>, greatest: bool) -> Found<Value<'t>> {
        match (self.compare(a.clone(), ">=", b.clone())?, self.compare(a.clone(), "<=", b.clone())?) {
            (above, _) if above.is_true() => Ok(if greatest { a } else { b }),
            (_, below) if below.is_true() => Ok(if greatest { b } else { a }),
            _ => Err(Stop::Undecided),
        }
    }

    /// a/b, for a b that is never 0.
    pub(crate) fn over(&self, a: Value<'t>, b: Value<'t>) -> Found<Value<'t>> {
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

    /// A control value: a number, or a parameter.
    pub(crate) fn control(&mut self, name: &'t str, i: &Form) -> Found<Value<'t>> {
        if let Some(numbers) = &self.numbers {
            let at = self.facts.value(i).ok_or(Stop::Undecided)?;
            if numbers.example.is_some() && name == "P" {
                return Err(Stop::Undecided);
            }
            if numbers.values.is_none() {
                return Ok(self.parameter("real", Node::made(name, vec![Node::whole_of(at)]))?);
            }
            let value = usize::try_from(at).ok().and_then(|at| numbers.of("points", name, at));
            return Ok(self.leaf(value.ok_or(Stop::Undecided)?)?);
        }
        let index = match self.facts.value(&i.plus(-1, &Form::near(0))?) {
            Some(e) => vec![Node::whole_of(e)],
            None if matches!(self.place, Place::Start | Place::End) => return Err(Stop::Undecided),
            None => Self::labels(i).collect(),
        };
        Ok(self.parameter("real", Node::made(name, index))?)
    }

    pub(crate) fn fold(
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
    pub(crate) fn x(&mut self) -> Found<Value<'t>> {
        if let Some(numbers) = &self.numbers {
            return Ok(self.leaf(numbers.x.clone().ok_or(Stop::Undecided)?)?);
        }
        let Some(place) = self.place.on_span() else {
            return Ok(self.parameter("real", Node::name_of("outside"))?);
        };
        let x = Node::made("x", vec![Node::made(place, vec![Node::name_of("W"), Node::whole_of(0)])]);
        self.measured(None, x)
    }

    fn shown_knot(&mut self, e: i64) -> Found<Value<'t>> {
        self.measured(Some(e), Node::made("t", vec![Node::name_of("W"), Node::whole_of(e)]))
    }

    /// x or a knot of the window, from the origin.
    fn measured(&mut self, knot: Option<i64>, term: Node<'t>) -> Found<Value<'t>> {
        if let Some(known) = self.shown_knots.get(&knot) {
            return Ok(known.clone());
        }
        let value = Value { knot, ..self.leaf(Node::name_of("o"))?.plus(self.leaf(term)?)? };
        self.shown_knots.insert(knot, value.clone());
        Ok(value)
    }

    /// t_i: a knot of the window, or one that is some way beyond one.
    pub(crate) fn knot(&mut self, i: &Form) -> Found<Value<'t>> {
        self.exists(i, &Form::last(self.k + 1))?;
        if let Some(numbers) = &self.numbers {
            let at = self.facts.value(i).and_then(|i| usize::try_from(i).ok());
            let value = at.and_then(|at| numbers.knots.get(at)).ok_or(Stop::Undecided)?;
            return Ok(self.leaf(value.clone())?);
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
}
