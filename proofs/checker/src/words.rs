//! Words at a point: what samples show of them. They show that something is false, or a bound of a number, and no more.

use std::rc::Rc;

use crate::case::{At, Bound, Case, Found, Numbers, Stop};
use crate::env::Env;
use crate::error::Result;
use crate::fraction::Fraction;
use crate::obligation::Subject;
use crate::place::{Form, Place};
use crate::poly::Sign;
use crate::section::Section;
use crate::token::{Node, tree};
use crate::truth::Truth;
use crate::value::Value;

/// Words that count.
const COUNTS: [&str; 5] = ["maxima", "maximisers", "changes", "polygon-changes", "rank"];

/// Least and greatest value, as far as samples show them.
type Bounds = (Option<i64>, Option<i64>);

impl<'t> Case<'_, 't> {
    /// The numbers of `(samples X…)`, `(factors C…)` or `(columns I…)` of the point.
    fn list(&self, head: &'static str) -> Found<Vec<Node<'t>>> {
        let values = self.numbers.as_ref().and_then(|numbers| numbers.values.as_ref());
        let found = values.and_then(|all| all.iter().find_map(|value| value.fields(head).ok()));
        found.map(<[Node<'t>]>::to_vec).ok_or(Stop::Undecided)
    }

    /// Samples, if they rise.
    fn samples(&self) -> Found<Vec<Node<'t>>> {
        let all = self.list("samples")?;
        for (a, b) in all.iter().zip(all.iter().skip(1)) {
            if self.sign(&Fraction::number(b)?.minus(&Fraction::number(a)?)?) != Sign::Positive {
                return Err(Stop::Undecided);
            }
        }
        Ok(all)
    }

    /// Whether samples are in an interval.
    fn all_in(&mut self, samples: &[Node<'t>], interval: &Node<'t>) -> Found<()> {
        for sample in samples {
            if !self.truth(&Node::made("in", vec![sample.clone(), interval.clone()]))?.is_true() {
                return Err(Stop::Undecided);
            }
        }
        Ok(())
    }

    /// A function at a number.
    fn value_at(&mut self, function: &Node<'t>, x: &Node<'t>, side: At) -> Found<Value<'t>> {
        let x = self.leaf(x.clone())?;
        let before = self.locate(x)?;
        let value = self.function(function, side, 0);
        self.restore(before);
        value
    }

    fn at(&mut self, function: &Node<'t>, x: &Node<'t>, side: At) -> Found<Rc<Fraction>> {
        self.value_at(function, x, side)?.plain.ok_or(Stop::Undecided)
    }

    /// The functions of a degree that exist.
    fn basis(&self, degree: i64) -> Found<Vec<Node<'t>>> {
        let last = self.facts.value(&Form::last(self.k - degree)).filter(|_| (0..=self.k).contains(&degree));
        let of = |i| Node::made("G", vec![Node::whole_of(i), Node::whole_of(degree)]);
        Ok((0..=last.ok_or(Stop::Undecided)?).map(of).collect())
    }

    /// Σ c·f(x) over the factors and samples, none of which is a knot, or beyond them.
    fn functional(
        &mut self,
        of: &mut dyn FnMut(&mut Self, &Node<'t>) -> Found<Rc<Fraction>>,
    ) -> Found<Fraction> {
        let (samples, factors) = (self.samples()?, self.list("factors")?);
        if samples.len() != factors.len() {
            return Err(Stop::Undecided);
        }
        let mut sum = Fraction::integer(0);
        for (x, c) in samples.iter().zip(&factors) {
            let there = self.leaf(x.clone())?;
            let before = self.locate(there)?;
            let inside = self.place == Place::Inside;
            self.restore(before);
            if !inside {
                return Err(Stop::Undecided);
            }
            let value = of(self, x)?;
            sum = sum.plus(&Fraction::number(c)?.times(&value)?)?;
        }
        Ok(sum)
    }

    /// Whether the functional is 0 on all functions of a degree.
    fn vanishes(&mut self, degree: i64) -> Found<bool> {
        for function in self.basis(degree)? {
            if !self.functional(&mut |own, x| own.at(&function, x, At::X))?.is_zero() {
                return Ok(false);
            }
        }
        Ok(true)
    }

    /// The same numbers on other knots in another degree.
    fn on_knots(&self, knots: &[Node<'t>], k: i64) -> Found<Self> {
        let numbers = self.numbers.as_ref().ok_or(Stop::Undecided)?;
        let mut case = Case::new(&self.family, self.definitions, k, Place::Inside)?;
        let other = Numbers::of_knots(knots, &Subject::Knots, numbers.values.clone());
        let mut fixed = vec![other.window()];
        // What belongs to knots is not known of others.
        for own in &self.family.parameters {
            let values = numbers.values.iter().flatten();
            let mut given = values.filter_map(|value| value.fields("parameter").ok());
            match given.find(|given| given.first().is_some_and(|name| name.is_word(own.name))) {
                Some(given) if own.indices.is_empty() => fixed.push(Node::made("let", given.to_vec())),
                _ => return Err(Stop::Undecided),
            }
        }
        case.section = Section::new(&fixed, Env::new(self.family.clone()))?;
        (case.numbers, case.exact) = (Some(other), true);
        // Without a point any number does.
        let any = case.leaf(knots.first().cloned().ok_or(Stop::Undecided)?)?;
        case.locate(any)?;
        Ok(case)
    }

    /// Whether a functional that is 0 on all functions of another basis, on knots among which there are all of these, is not on
    /// one of these.
    fn sticks_out(&mut self, knots: &[Node<'t>], k: i64) -> Found<Truth<'t>> {
        let mut other = self.on_knots(knots, k)?;
        if !other.vanishes(k)? || self.vanishes(self.k)? { Err(Stop::Undecided) } else { Ok(Truth::False) }
    }

    /// The minor of functions of a degree at the samples.
    fn minor(&mut self, degree: i64) -> Found<Rc<Fraction>> {
        let (samples, basis) = (self.samples()?, self.basis(degree)?);
        self.all_in(&samples, &tree("(closed (t 0) closed (t m))")?)?;
        let columns = self.list("columns")?.iter().map(Node::whole).collect::<Result<Vec<_>>>()?;
        if !columns.is_sorted_by(|a, b| a < b) || columns.len() != samples.len() {
            return Err(Stop::Undecided);
        }
        let mut rows = Vec::new();
        for x in &samples {
            let mut row = Vec::new();
            for i in &columns {
                let function = usize::try_from(*i).ok().and_then(|i| basis.get(i)).ok_or(Stop::Undecided)?;
                row.push(self.value_at(function, x, At::X)?.term);
            }
            rows.push(Node::group_of(row));
        }
        self.leaf(Node::made("det", rows))?.plain.ok_or(Stop::Undecided)
    }

    /// A formula that is a word.
    pub(crate) fn word(&mut self, head: &str, of: &[Node<'t>]) -> Found<Truth<'t>> {
        // Only a point has all knots, and values at them.
        let numbers = self.numbers.as_ref().filter(|numbers| numbers.values.is_some());
        let knots = numbers.map(|numbers| numbers.knots.clone()).ok_or(Stop::Undecided)?;
        match (head, of) {
            // At every knot between t_0 and t_m; a basis function has no pole beside them.
            ("continuous", [function]) => match function.part("function")? {
                [function] if function.is("G") => self.jumps(function, &knots).map(|jumps| Truth::of(!jumps)),
                _ => Err(Stop::Undecided),
            },
            ("combination", [expression, degree]) => {
                let [body, name, interval] = expression.part("expression")?;
                let [degree] = degree.part("integer")?;
                let (samples, degree) = (self.samples()?, self.fixed(degree)?);
                self.all_in(&samples, interval)?;
                if !self.vanishes(degree)?
                    || self.functional(&mut |own, x| own.expression(body, name, x))?.is_zero()
                {
                    return Err(Stop::Undecided);
                }
                Ok(Truth::False)
            }
            ("nested", [real]) => {
                let [real] = real.part("real")?;
                let s = self.real(real)?;
                let plain = s.plain.ok_or(Stop::Undecided)?;
                let mut refined = knots;
                let mut before = 0;
                for t in &refined {
                    before += usize::from(self.sign(&Fraction::number(t)?.minus(&plain)?) != Sign::Positive);
                }
                refined.insert(before, s.term);
                self.sticks_out(&refined, self.k)
            }
            ("elevated", [degree]) => {
                let [degree] = degree.part("integer")?;
                if self.fixed(degree)? != self.k {
                    return Err(Stop::Undecided);
                }
                let mut more = Vec::new();
                for t in knots {
                    if more.last() != Some(&t) {
                        more.push(t.clone());
                    }
                    more.push(t);
                }
                self.sticks_out(&more, self.k + 1)
            }
            ("totally-positive", [degree]) => {
                let [degree] = degree.part("integer")?;
                let degree = self.fixed(degree)?;
                let minor = self.minor(degree)?;
                if self.sign(&minor.negated()) == Sign::Positive {
                    Ok(Truth::False)
                } else {
                    Err(Stop::Undecided)
                }
            }
            _ => Err(Stop::Undecided),
        }
    }
}

impl<'t> Case<'_, 't> {
    /// A term with a number for its variable.
    fn expression(&mut self, body: &Node<'t>, name: &Node<'t>, x: &Node<'t>) -> Found<Rc<Fraction>> {
        let x = self.leaf(x.clone())?;
        self.reals.push((name.name()?, Bound::Free(x)));
        let value = self.real(body);
        self.reals.pop();
        value?.plain.ok_or(Stop::Undecided)
    }

    /// Whether a function jumps at one of these knots, if that is between t_0 and t_m.
    fn jumps(&mut self, function: &Node<'t>, at: &[Node<'t>]) -> Found<bool> {
        let ends = self
            .numbers
            .as_ref()
            .and_then(|numbers| Some([numbers.knots.first()?.clone(), numbers.knots.last()?.clone()]));
        for knot in at.iter().filter(|knot| ends.as_ref().is_some_and(|ends| !ends.contains(knot))) {
            let sides = [self.at(function, knot, At::Left)?, self.at(function, knot, At::X)?];
            if !sides[0].minus(&sides[1])?.is_zero() {
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// A comparison with a count, by what is known of it.
    pub(crate) fn counted(&mut self, a: &Node<'t>, relation: &str, b: &Node<'t>) -> Found<Option<Truth<'t>>> {
        let (Ok([a]), Ok([b])) = (a.part("int"), b.part("int")) else { return Ok(None) };
        let is_count = |node: &Node<'t>| COUNTS.iter().any(|word| node.is(word));
        if self.numbers.as_ref().is_none_or(|numbers| numbers.values.is_none())
            || !is_count(a) && !is_count(b)
        {
            return Ok(None);
        }
        let (a, b) = (self.bounds(a)?, self.bounds(b)?);
        let minus = |a: Option<i64>, b: Option<i64>| Some(a? - b?);
        let (least, most) = (minus(a.0, b.1), minus(a.1, b.0));
        let (above, below) = (least.is_some_and(|least| least > 0), most.is_some_and(|most| most < 0));
        let (reaches, stays) = (least.is_some_and(|least| least >= 0), most.is_some_and(|most| most <= 0));
        Ok(Some(Truth::known(match relation {
            "=" if above || below => Some(false),
            "=" if reaches && stays => Some(true),
            "<=" if above => Some(false),
            "<=" if stays => Some(true),
            ">=" if below => Some(false),
            ">=" if reaches => Some(true),
            _ => None,
        })))
    }

    /// What is known of a count.
    fn bounds(&mut self, node: &Node<'t>) -> Found<Bounds> {
        match node.headed("an integer") {
            Ok(("maxima" | "maximisers", [function])) if self.never_highest(function)? => {
                Ok((Some(0), Some(0)))
            }
            Ok(("maxima", [function])) => Ok((Some(self.peaks(function)?), None)),
            Ok(("changes", [expression])) => {
                let [body, name, interval] = expression.part("expression")?;
                let samples = self.samples()?;
                self.all_in(&samples, interval)?;
                let mut signs = Vec::new();
                for x in &samples {
                    let value = self.expression(body, name, x)?;
                    signs.push((self.sign(&value), self.sign(&value.negated())));
                }
                // A sign and the opposite one.
                let opposite = |pair: (&(Sign, Sign), &(Sign, Sign))| {
                    pair.0.0 == Sign::Positive && pair.1.1 == Sign::Positive
                        || pair.0.1 == Sign::Positive && pair.1.0 == Sign::Positive
                };
                let changes = signs.iter().zip(signs.iter().skip(1)).filter(|pair| opposite(*pair)).count();
                Ok((i64::try_from(changes).ok(), None))
            }
            Ok(("polygon-changes", [of])) => {
                let [name] = of.part("coefficients")?;
                let n = self.facts.value(&Form::last(0)).ok_or(Stop::Undecided)?;
                let (mut changes, mut last) = (0, None);
                for i in 0..=n {
                    let value = self.control(name.name()?, &Form::number(i))?.plain.ok_or(Stop::Undecided)?;
                    let positive = self.sign(&value) == Sign::Positive;
                    if !value.is_zero() {
                        changes += i64::from(last.is_some_and(|last| last != positive));
                        last = Some(positive);
                    }
                }
                Ok((Some(changes), Some(changes)))
            }
            Ok(("rank", [degree])) => {
                let [degree] = degree.part("integer")?;
                let degree = self.fixed(degree)?;
                // All others are 0 everywhere.
                let mut most = 0;
                for (i, _) in (0..).zip(self.basis(degree)?) {
                    let ends = [self.knot(&Form::number(i))?, self.knot(&Form::number(i + degree + 1))?];
                    let [a, b] = ends;
                    most += i64::from(self.compare(a, "<", b)?.is_true());
                }
                let least = match self.minor(degree) {
                    Ok(minor) if !minor.is_zero() => i64::try_from(self.samples()?.len()).ok(),
                    _ => None,
                };
                Ok((least, Some(most)))
            }
            _ => {
                let value = self.fixed(node)?;
                Ok((Some(value), Some(value)))
            }
        }
    }

    /// The index of a basis function of degree k of this member, and its knots.
    fn support(&mut self, function: &Node<'t>) -> Found<(Node<'t>, Vec<Node<'t>>)> {
        let [function] = function.part("function")?;
        let [i] = function.part("G")?;
        let at = usize::try_from(self.fixed(i)?).map_err(|_| Stop::Undecided)?;
        let numbers = self.numbers.as_ref().ok_or(Stop::Undecided)?;
        let knots: Vec<_> = numbers.knots.iter().skip(at).cloned().collect();
        let count = usize::try_from(self.k + 2).map_err(|_| Stop::Undecided)?;
        let knots = knots.get(..count).ok_or(Stop::Undecided)?.to_vec();
        Ok((function.clone(), knots))
    }

    /// Whether a function rises on all of its support and then jumps to 0: t_{i+1} = t_{i+k+1} < t_m. It is a product of weights of
    /// intervals that end there, which rise to 1; that is never reached.
    fn never_highest(&mut self, function: &Node<'t>) -> Found<bool> {
        let (_, knots) = self.support(function)?;
        let last = self.numbers.as_ref().and_then(|numbers| numbers.knots.last().cloned());
        let end = knots.last().cloned();
        let mut rises = true;
        for d in 1..=self.k {
            rises = rises && self.family.rises(d)?;
        }
        Ok(rises
            && self.k > 0
            && knots.first() != knots.get(1)
            && knots.get(1) == end.as_ref()
            && end != last)
    }

    /// So many local maxima a continuous function has at least that is higher at every other sample than at those beside it:
    /// between two of the lower ones there is a highest point, which is none of them.
    fn peaks(&mut self, function: &Node<'t>) -> Found<i64> {
        let (function, knots) = self.support(function)?;
        let (Some(first), Some(last)) = (knots.first(), knots.last()) else { return Err(Stop::Undecided) };
        let (samples, open) = (self.samples()?, || Node::name_of("open"));
        self.all_in(&samples, &Node::group_of(vec![open(), first.clone(), open(), last.clone()]))?;
        // From the right it is continuous at the first knot.
        let after: Vec<_> = knots.iter().filter(|knot| *knot != first).cloned().collect();
        if samples.len() % 2 == 0 || self.jumps(&function, &after)? {
            return Err(Stop::Undecided);
        }
        let mut values = Vec::new();
        for x in &samples {
            values.push(self.at(&function, x, At::X)?);
        }
        for (at, (a, b)) in values.iter().zip(values.iter().skip(1)).enumerate() {
            let fall = if at % 2 == 0 { a.minus(b)? } else { b.minus(a)? };
            if self.sign(&fall) != Sign::Positive {
                return Err(Stop::Undecided);
            }
        }
        i64::try_from(samples.len().div_ceil(2)).map_err(|_| Stop::Undecided)
    }
}
