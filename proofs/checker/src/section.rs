//! One section of a statement: its parameters as variables with signs, its abbreviations and knot vectors.

use std::rc::Rc;

use crate::env::{Env, Meaning, Window};
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
    /// The windows so far: names, first indices and gaps.
    windows: Vec<(&'t str, i64, Vec<Fraction>)>,
}

impl<'t> Section<'t> {
    /// Reads the declarations one after the other; `env` has the integers.
    pub(crate) fn new(declarations: &[Node<'t>], env: Env<'t>) -> Result<Self> {
        let mut section = Section { env, signs: Vec::new(), windows: Vec::new() };
        for name in ["u", "r"] {
            section.parameter(name, Vec::new(), Sign::Positive)?;
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
                self.windows.push((name, first, gaps));
                self.measure()
            }
            _ => part.wrong("a declaration or the goals"),
        }
    }

    /// A new variable.
    fn parameter(&mut self, name: &'t str, indices: Vec<i64>, sign: Sign) -> Result<Poly> {
        let index = self.signs.len();
        self.env.check_free(name, &indices)?;
        if index == PARAMETERS {
            return Err(Reason::Limits("the number of parameters"));
        }
        self.env.set(name, indices, Meaning::Variable(index))?;
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

    fn abbreviation(&mut self, name: &'t str, term: &Node<'t>) -> Result<()> {
        let value = self.term(term, &self.env)?;
        let value = match name {
            // It is known already, and means something else from here on: a constant, where x moves with u.
            "r" if !value.is_only_in(|variable| variable != U) => return Err(Reason::Moving),
            "r" => value.positive(name, &self.signs)?,
            _ => self.env.check_free(name, &[]).map(|()| value)?,
        };
        self.env.set(name, Vec::new(), Meaning::Value(value.into()))
    }

    /// A term with everything unfolded.
    pub(crate) fn term(&self, term: &Node<'t>, env: &Env<'t>) -> Result<Fraction> {
        Evaluator::new(&self.signs, Mode::default()).term(term, env)
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
        all.iter().flat_map(|(_, _, gaps)| gaps).for_each(|gap| gap.widen(&mut common));
        let scale = Fraction::integer(1).over_common(&common)?;
        for (name, first, gaps) in all {
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
                last = last.plus(&gap.over_common(&common)?);
                keep(last.size())?;
                knots.push(last.clone());
            }
            let window = Window { name: (*name).to_owned(), first: *first, knots, scale: scale.clone() };
            self.env.set(name, Vec::new(), Meaning::Window(Rc::new(window)))?;
        }
        Ok(())
    }
}
