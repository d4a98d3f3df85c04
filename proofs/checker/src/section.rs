//! One section of a statement: its parameters as variables with signs, its abbreviations and knot vectors.

use std::rc::Rc;

use crate::env::{Env, Meaning, Own, Window};
use crate::error::{Reason, Result};
use crate::fraction::{Factors, Fraction};
use crate::poly::{Poly, Sign};
use crate::terms::{Evaluator, Mode};
use crate::token::{Kind, Node};
use crate::work::keep;

/// A section has so many parameters at most; the unknowns of a formula come on top.
const PARAMETERS: usize = 250;
/// The variable of `u`.
pub(crate) const U: usize = 0;

/// What is declared, once for all formulas of the section.
pub(crate) struct Section<'t> {
    pub(crate) env: Env<'t>,
    pub(crate) signs: Vec<Sign>,
    /// The windows so far.
    windows: Vec<Frame<'t>>,
}

/// A window that is not measured yet.
struct Frame<'t> {
    name: &'t str,
    first: i64,
    gaps: Vec<Fraction>,
    parameters: Rc<Own>,
}

impl<'t> Section<'t> {
    /// Reads the declarations one after the other; `env` has the integers.
    pub(crate) fn new(declarations: &[Node<'t>], env: Env<'t>) -> Result<Self> {
        let mut section = Section { env, signs: Vec::new(), windows: Vec::new() };
        section.parameter("u", Vec::new(), Sign::Positive)?;
        let family = section.env.family.clone();
        for own in family.parameters.iter().filter(|own| own.indices.is_empty()) {
            section.parameter(own.name, Vec::new(), own.sign)?;
        }
        declarations.iter().try_for_each(|part| section.declare(part))?;
        Ok(section)
    }

    /// Reads one declaration more.
    pub(crate) fn declare(&mut self, part: &Node<'t>) -> Result<()> {
        match part.headed("a declaration or the goals")? {
            ("real", list @ [_, ..]) => self.parameters(list, Sign::Real),
            ("nonnegative", list @ [_, ..]) => self.parameters(list, Sign::Nonnegative),
            ("positive", list @ [_, ..]) => self.parameters(list, Sign::Positive),
            ("let", [name, term]) => self.abbreviation(name.name()?, term),
            (head @ ("window" | "knots"), [name, first, list @ ..]) => {
                let (name, first) = (name.head()?, self.env.integer(first)?);
                self.env.check_free(name, &[])?;
                let gaps = match head {
                    "knots" => Self::differences(list)?,
                    _ => self.gaps(name, first, list)?,
                };
                let parameters = Rc::new(self.own(first, gaps.len())?);
                self.windows.push(Frame { name, first, gaps, parameters });
                self.measure()
            }
            ("values", [window, name, list @ ..]) => self.values(window.name()?, name, list),
            _ => part.wrong("a declaration or the goals"),
        }
    }

    /// A new variable.
    fn parameter(&mut self, name: &'t str, indices: Vec<i64>, sign: Sign) -> Result<Poly> {
        self.env.check_free(name, &indices)?;
        let index = self.signs.len();
        let variable = self.variable(sign)?;
        self.env.set(name, indices, Meaning::Variable(index))?;
        Ok(variable)
    }

    fn variable(&mut self, sign: Sign) -> Result<Poly> {
        let index = self.signs.len();
        if index == PARAMETERS {
            return Err(Reason::Limits("the number of parameters"));
        }
        self.signs.push(sign);
        Ok(Poly::variable(index))
    }

    fn parameters(&mut self, list: &[Node<'t>], sign: Sign) -> Result<()> {
        for (node, env) in self.env.expand(list)? {
            let (name, indices) = node.indexed()?;
            self.parameter(name, env.integers(indices)?, sign)?;
        }
        Ok(())
    }

    /// The parameters of the family on a window: new variables.
    fn own(&mut self, first: i64, gaps: usize) -> Result<Own> {
        let (family, mut own) = (self.env.family.clone(), Own::new());
        let gaps = i64::try_from(gaps).map_err(|_| Reason::Limits("the knots"))?;
        for parameter in family.parameters.iter().filter(|own| !own.indices.is_empty()) {
            let knots = if parameter.indices.contains(&"i") { first..=first + gaps } else { 0..=0 };
            let degrees = if parameter.indices.contains(&"d") { 1..=gaps } else { 0..=0 };
            for (i, d) in knots.flat_map(|i| degrees.clone().map(move |d| (i, d))) {
                let of = |index: &&str| if *index == "i" { i } else { d };
                let indices = parameter.indices.iter().map(of).collect();
                own.insert((parameter.name.to_owned(), indices), self.variable(parameter.sign)?.into());
            }
        }
        Ok(own)
    }

    /// ((INDEX… NUMBER)…): what the parameters of a window are.
    fn values(&mut self, window: &str, name: &Node<'t>, list: &[Node<'t>]) -> Result<()> {
        let frame = self.windows.iter_mut().find(|frame| frame.name == window);
        let frame = frame.ok_or_else(|| Reason::Unknown(window.to_owned()))?;
        for item in list {
            let Some((value, indices)) = item.list("indices and a number")?.split_last() else {
                return item.wrong("indices and a number");
            };
            let indices = indices.iter().map(|index| index.whole()).collect::<Result<_>>()?;
            let known = Rc::make_mut(&mut frame.parameters).get_mut(&(name.name()?.to_owned(), indices));
            let known = known.ok_or_else(|| Reason::Unknown(window.to_owned()))?;
            if !self.env.family.parameter(name.name()?).map_or(Ok(false), |own| own.admits(value))? {
                return value.wrong("a number within the bounds of the parameter");
            }
            *known = Fraction::number(value)?;
        }
        self.measure()
    }

    fn abbreviation(&mut self, name: &'t str, term: &Node<'t>) -> Result<()> {
        let value = self.term(term, &self.env)?;
        let value = match self.env.family.unindexed(name) {
            // It is known already, and means something else from here on: a constant, where x moves with u.
            Some(_) if !value.is_only_in(|variable| variable != U) => {
                return Err(Reason::Moving(name.to_owned()));
            }
            Some(own) => value.at_least(own.sign, name, &self.signs)?,
            None => self.env.check_free(name, &[]).map(|()| value)?,
        };
        self.env.set(name, Vec::new(), Meaning::Value(value.into()))
    }

    /// A term with everything unfolded.
    ///
    /// # Errors
    /// If something remains unknown: what stands for it here would stand for something else in another term.
    pub(crate) fn term(&self, term: &Node<'t>, env: &Env<'t>) -> Result<Fraction> {
        let value = Evaluator::new(&self.signs, Mode::default()).term(term, env)?;
        let known = value.is_only_in(|variable| variable < self.signs.len());
        if known { Ok(value) } else { Err(Reason::NotShown("a weight that is not known")) }
    }

    /// The gaps between knots that are numbers.
    fn differences(numbers: &[Node<'t>]) -> Result<Vec<Fraction>> {
        let pairs = numbers.iter().zip(numbers.iter().skip(1));
        pairs.map(|(left, right)| Fraction::number(right)?.minus(&Fraction::number(left)?)).collect()
    }

    /// The gaps of a window. Its own parameters are not known yet where their terms are read.
    fn gaps(&mut self, name: &'t str, first: i64, list: &[Node<'t>]) -> Result<Vec<Fraction>> {
        let mut gaps = Vec::new();
        for (index, (gap, env)) in (first..).zip(self.env.expand(list)?) {
            let value = match gap.kind {
                Kind::Name("any") => self.parameter(name, vec![index], Sign::Nonnegative)?.into(),
                Kind::Name("some") => self.parameter(name, vec![index], Sign::Positive)?.into(),
                _ => self.term(gap, &env)?,
            };
            gaps.push(value);
        }
        Ok(gaps)
    }

    /// Makes the gaps of all windows so far to knots over one common denominator.
    fn measure(&mut self) -> Result<()> {
        let all = &self.windows;
        let mut common = Factors::new();
        all.iter().flat_map(|frame| &frame.gaps).for_each(|gap| gap.widen(&mut common));
        let scale = Fraction::integer(1).over_common(&common)?.into_owned();
        for Frame { name, first, gaps, parameters } in all {
            if gaps.is_empty() {
                return Err(Reason::NotDetermined((*name).to_owned(), "a gap".to_owned()));
            }
            let (mut knots, mut last) = (vec![Poly::default()], Poly::default());
            for (index, gap) in (*first..).zip(gaps) {
                // u moves the place in a knot vector that stays.
                let whole = gap.denominator()?.is_only_in(|_| false);
                if !whole || gap.num.sign(&self.signs) == Sign::Real || !gap.num.is_only_in(|v| v != U) {
                    return Err(Reason::Gap((*name).to_owned(), index));
                }
                last = last.plus(&*gap.over_common(&common)?);
                keep(last.size())?;
                knots.push(last.clone());
            }
            let (name_of, parameters) = ((*name).to_owned(), parameters.clone());
            let window = Window { name: name_of, first: *first, knots, scale: scale.clone(), parameters };
            self.env.set(name, Vec::new(), Meaning::Window(Rc::new(window)))?;
        }
        Ok(())
    }
}
