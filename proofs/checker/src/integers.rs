//! The integers of a sentence at a place: what they can be, and what hypotheses say of s and n.

use crate::case::{Case, Found, Stop, read};
use crate::env::binomial;
use crate::error::Result;
use crate::obligation::parts;
use crate::place::{Copies, Form, Gap, Place};
use crate::token::{Kind, Node};
use crate::work::spend;

/// A range of known length has so many numbers at most.
pub(crate) const RANGE: i64 = 200;

impl<'t> Case<'_, 't> {
    pub(crate) fn int(&mut self, node: &Node<'t>) -> Found<Form> {
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
            if let Some(knots) = self.numbers.as_ref().map(|numbers| numbers.knots.clone()) {
                let plain = self.real(real)?.plain.ok_or(Stop::Undecided)?;
                let mut count = 0;
                for knot in &knots {
                    let other = self.section.term(knot, &self.section.env)?;
                    count += i64::from(plain.minus(&other)?.is_zero());
                }
                return Ok(Form::number(count));
            }
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
    pub(crate) fn fixed(&mut self, node: &Node<'t>) -> Found<i64> {
        let form = self.int(node)?;
        self.facts.value(&form).ok_or(Stop::Undecided)
    }

    /// The index of (t I), if it can be read.
    pub(crate) fn index(&mut self, knot: &Node<'t>) -> Result<Option<Form>> {
        let [i] = knot.part("t")?;
        read(self.int(i))
    }

    pub(crate) fn surely(&self, form: &Form) -> Result<bool> {
        Ok(self.facts.is_nonnegative(form)? == Some(true))
    }

    /// Whether least ≤ i ≤ most for sure; otherwise something may not exist.
    pub(crate) fn exists(&self, i: &Form, most: &Form) -> Found<()> {
        let exists = self.surely(i)? && self.surely(&most.plus(-1, i)?)?;
        if exists { Ok(()) } else { Err(Stop::Undefined) }
    }

    /// The span of t_0 + t_m − x, with its value from the right but at t_m.
    pub(crate) fn mirror(&self) -> Found<Form> {
        let span = Form::last(self.k).plus(-1, &Form::near(0))?;
        match self.place {
            Place::Inside | Place::First(_) | Place::Last(_) => Ok(span),
            Place::Knot(Copies::Exactly(q)) => Ok(span.plus(q, &Form::number(1))?),
            _ => Err(Stop::Undecided),
        }
    }

    /// What an integer can be, with whether it is in the range for sure: all numbers of a range of known length, or else
    /// those around the span one by one, and the farther ones on each side.
    pub(crate) fn run(&mut self, low: &Node<'t>, high: &Node<'t>) -> Found<Vec<(Form, bool)>> {
        let (low, high) = (self.int(low)?, self.int(high)?);
        let one = Form::number(1);
        match self.facts.value(&high.plus(-1, &low)?) {
            Some(RANGE..) => return Err(Stop::Undecided),
            Some(length) => return (0..=length).map(|i| Ok((low.plus(i, &one)?, true))).collect(),
            None => {}
        }
        let reach = 2 * self.k + 3;
        let centre = match self.place.on_span() {
            None => None,
            Some(_) if self.mirrored => Some(self.mirror()?),
            Some(_) => Some(Form::near(0)),
        };
        let mut far = |from: &Form, c: i64, sign: i64| {
            self.far += 1;
            from.plus(1, &Form { c, far: [(self.far, sign)].into(), ..Form::default() })
        };
        let all = match centre {
            None => vec![far(&low, 0, 1)?],
            Some(centre) => {
                let mut all = (-reach..=reach).map(|e| centre.plus(e, &one)).collect::<Result<Vec<_>>>()?;
                all.extend([far(&centre, -reach - 1, -1)?, far(&centre, reach + 1, 1)?]);
                all
            }
        };
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
        let forms = match node.headed("a formula")? {
            ("chain", [_, step]) if step.is("/=") => return Ok(true),
            ("chain", [_, _]) | ("among", _) => read(self.integers(node))?.flatten(),
            ("and" | "chain", _) => {
                for part in parts(node)? {
                    if !self.learn_one(&part)? {
                        return Ok(false);
                    }
                }
                None
            }
            _ => None,
        };
        for form in forms.into_iter().flatten() {
            if !self.facts.assume(&form)? {
                return Ok(false);
            }
        }
        Ok(true)
    }

    /// A comparison of integers, as forms that are ≥ 0 (T /= S as T = S); nothing, if it is of reals.
    pub(crate) fn integers(&mut self, node: &Node<'t>) -> Found<Option<Vec<Form>>> {
        if let ("among", [i, low, high]) = node.headed("a formula")? {
            let (i, low, high) = (self.int(i)?, self.int(low)?, self.int(high)?);
            return Ok(Some(vec![i.plus(-1, &low)?, high.plus(-1, &i)?]));
        }
        let ("chain", [a, step]) = node.headed("a formula")? else { return Ok(None) };
        let (relation, [b]) = step.headed("a relation")? else { return Ok(None) };
        let (Ok(("int", [a])), Ok(("int", [b]))) = (a.headed(""), b.headed("")) else { return Ok(None) };
        let (a, b, one) = (self.int(a)?, self.int(b)?, Form::number(1));
        let (up, down) = (b.plus(-1, &a)?, a.plus(-1, &b)?);
        Ok(Some(match relation {
            "<=" => vec![up],
            ">=" => vec![down],
            "<" => vec![up.plus(-1, &one)?],
            ">" => vec![down.plus(-1, &one)?],
            _ => vec![up, down],
        }))
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
}
