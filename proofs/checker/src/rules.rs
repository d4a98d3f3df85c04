//! The rules: does this one prove that formula?

use std::cell::RefCell;

use crate::env::{Env, Meaning};
use crate::error::{Reason, Result};
use crate::fraction::Fraction;
use crate::poly::{Poly, Sign};
use crate::recursion::Spot;
use crate::section::{Section, U};
use crate::terms::{Evaluator, Mode};
use crate::token::Node;

const FORMULAS: [(&str, usize); 8] =
    [("=", 2), (">", 2), (">=", 2), ("<", 2), ("defined", 1), ("order", 4), ("outside", 3), ("pole", 3)];
const RULES: [&str; 5] = ["by", "split", "orders", "functional", "evaluate"];

/// What was computed with so many parameters and unknowns is computed anew for each goal.
const KEPT: usize = 100;

/// What a formula or a rule of a section is about.
pub(crate) struct Context<'a, 't> {
    pub(crate) section: &'a Section<'t>,
    /// The formulas of the lemmas proved so far, the first one with the label 1.
    pub(crate) lemmas: Vec<&'a Node<'t>>,
    /// What has been computed in this section so far: what is known of a key stays.
    pub(crate) kept: RefCell<Vec<Evaluator>>,
}

/// What stands in `by`: how far the definition is unfolded, and lemmas with their factors.
fn options<'a, 't>(list: &'a [Node<'t>], equation: bool) -> Result<(Mode, &'a [Node<'t>])> {
    let (mut mode, mut lemmas): (_, &[_]) = (Mode { equation, ..Mode::default() }, &[]);
    for option in list {
        match option.headed("an option")? {
            ("weights", [d]) if mode.weights.is_none() => mode.weights = Some(d.degree()?.into()),
            ("functions", [d]) if mode.functions.is_none() => mode.functions = Some(d.degree()?.into()),
            ("using", list @ [_, ..]) if lemmas.is_empty() => lemmas = list,
            _ => return option.wrong("an option that is none of the others"),
        }
    }
    Ok((mode, lemmas))
}

impl<'t> Context<'_, 't> {
    /// The formula is read with the integers of `env`, the rule with those of the section.
    pub(crate) fn prove(&self, formula: &Node<'t>, env: &Env<'t>, rule: &Node<'t>) -> Result<()> {
        let evaluator = |mode: Mode| {
            let mut kept = self.kept.borrow_mut();
            let known = kept.iter().position(|known| known.mode == mode);
            known.map_or_else(|| Evaluator::new(&self.section.signs, mode), |at| kept.swap_remove(at))
        };
        match (formula.headed("a formula")?, rule.headed("a rule")?) {
            (("=", [a, b]), ("by", list)) => {
                let (mode, using) = options(list, true)?;
                let mut evaluator = evaluator(mode);
                let rest = evaluator.difference(a, b, env)?;
                self.equal(rest, using, &mut evaluator)?;
                self.keep(evaluator);
                Ok(())
            }
            ((head @ (">" | ">="), [a, b]) | (head @ "<", [b, a]), ("by" | "split", _)) => {
                let list = rule.fields("by").unwrap_or_default();
                let (mode, []) = options(list, false)? else { return Err(Reason::WrongRule) };
                let mut evaluator = evaluator(mode);
                let num = evaluator.difference(a, b, env)?.num;
                let want = if head == ">=" { Sign::Nonnegative } else { Sign::Positive };
                match rule.is("by") {
                    true => show(&num, &evaluator.signs, want)?,
                    false => self.split(&num, &evaluator.signs, want, rule)?,
                }
                self.keep(evaluator);
                Ok(())
            }
            (("defined", [term]), ("by", list)) => match options(list, true)? {
                // A denominator without a sign would end the evaluation.
                (mode @ Mode { functions: None, .. }, []) => evaluator(mode).term(term, env).map(|_| ()),
                _ => Err(Reason::WrongRule),
            },
            (("order", [i, d, place, claimed]), ("orders", [])) => {
                let (mut evaluator, spot) = self.inside(place, env)?;
                let order = evaluator.order(env.integer(i)?, env.integer(d)?, &spot)?;
                if order == env.integer(claimed)? { Ok(()) } else { Err(Reason::Order(order)) }
            }
            (("outside", [place, term, list]), ("functional", pairs @ [_, ..])) => {
                self.inside(place, env)?;
                let vanishes = |term| functional(&self.function(term, env)?, pairs);
                if vanishes(term)? {
                    return Err(Reason::NotShown("the functional is 0 for the first function"));
                }
                for term in list.list("a list of terms")? {
                    if !vanishes(term)? {
                        return Err(Reason::NotShown("the functional is not 0 on the list"));
                    }
                }
                Ok(())
            }
            (("pole", [place, list, point]), ("evaluate", [])) => {
                self.inside(place, env)?;
                let mut found = false;
                for term in list.list("a list of terms")? {
                    let (num, den) = value(&self.function(term, env)?, point)?;
                    found |= den.is_zero() && !num.is_zero();
                }
                if found { Ok(()) } else { Err(Reason::NotShown("no pole there")) }
            }
            ((head, fields), _) if !FORMULAS.contains(&(head, fields.len())) => formula.wrong("a formula"),
            (_, (head, _)) if !RULES.contains(&head) => rule.wrong("a rule"),
            _ => Err(Reason::WrongRule),
        }
    }

    /// For the next goal, unless there would be many unknowns besides its own.
    fn keep(&self, evaluator: Evaluator) {
        if evaluator.signs.len() < KEPT {
            self.kept.borrow_mut().push(evaluator);
        }
    }

    /// A place in a span, with u free on it.
    fn inside(&self, place: &Node<'t>, env: &Env<'t>) -> Result<(Evaluator, Spot<'t>)> {
        let evaluator = Evaluator::new(&self.section.signs, Mode::default());
        let spot = place.fields("in").and_then(|_| evaluator.spot(place, env))?;
        Ok((evaluator, spot))
    }

    /// What is left of a difference without its lemmas is 0.
    fn equal(&self, mut rest: Fraction, using: &[Node<'t>], evaluator: &mut Evaluator) -> Result<()> {
        let env = &self.section.env;
        for node in using {
            let [label, factor] = node.group("a lemma and its factor")?;
            let label = label.whole()?;
            let lemma = self.lemmas.iter().zip(1..).find(|(_, number)| *number == label);
            let Some(("=", [left, right])) = lemma.and_then(|(lemma, _)| lemma.headed("").ok()) else {
                return Err(Reason::NoLemma(label));
            };
            let difference = evaluator.difference(left, right, env)?;
            rest = rest.minus(&evaluator.term(factor, env)?.times(&difference)?)?;
        }
        if rest.is_zero() { Ok(()) } else { Err(Reason::NotShown("the two sides differ")) }
    }

    /// Both halves of the range of a parameter y: y < c, where y = c·z/(1 + z), and y ≥ c, where y = c + z. The new z
    /// has the place of y; denominators are cleared.
    fn split(&self, num: &Poly, signs: &[Sign], want: Sign, rule: &Node<'t>) -> Result<()> {
        let [name, bound, first, second] = match rule.headed("a rule")? {
            ("by", []) => return show(num, signs, want),
            ("split", _) => rule.part("split")?,
            _ => return Err(Reason::WrongRule),
        };
        let (of, indices) = name.indexed()?;
        let env = &self.section.env;
        let y = match env.meaning(of, env.integers(indices)?)? {
            Meaning::Variable(y) if signs[*y] != Sign::Real => *y,
            _ => return name.wrong("a parameter with a sign"),
        };
        let (up, down) = bound.ratio()?;
        if up.sign(&[]) != Sign::Positive {
            return bound.wrong("a positive number");
        }
        let (up_z, down_z) = (Poly::variable(y).times(&up)?, Poly::variable(y).times(&down)?);
        let below = num.substitute(y, (&up_z, &down_z.clone().plus(&down)), 0)?;
        self.split(&below, signs, want, first)?;
        // What is left of the parameter beyond the bound may be 0.
        let mut signs = signs.to_vec();
        signs[y] = Sign::Nonnegative;
        self.split(&num.substitute(y, (&down_z.plus(&up), &down), 0)?, &signs, want, second)
    }

    /// A function of u alone.
    fn function(&self, term: &Node<'t>, env: &Env<'t>) -> Result<[Poly; 2]> {
        let value = self.section.term(term, env)?;
        let function = [value.denominator()?, value.num];
        let alone = function.iter().all(|poly| poly.is_only_in(|variable| variable == U));
        if alone { Ok(function) } else { Err(Reason::NotShown("a parameter besides u")) }
    }
}

/// Numerator and denominator of a function at a number, with a common positive factor.
fn value([den, num]: &[Poly; 2], point: &Node<'_>) -> Result<(Poly, Poly)> {
    let (up, down) = point.ratio()?;
    let at = |poly: &Poly, other: &Poly| poly.substitute(U, (&up, &down), other.degree(U));
    Ok((at(num, den)?, at(den, num)?))
}

/// Whether Σ C·f(U) over the pairs is 0.
fn functional(function: &[Poly; 2], pairs: &[Node<'_>]) -> Result<bool> {
    let mut sum = Fraction::integer(0);
    for pair in pairs {
        let [factor, point] = pair.group("a number and a point")?;
        if point.ratio()?.0.sign(&[]) == Sign::Real {
            return point.wrong("a point u ≥ 0");
        }
        let ((num, den), (up, down)) = (value(function, point)?, factor.ratio()?);
        sum = sum.plus(&Fraction::new(num.times(&up)?, den.times(&down)?, &[])?)?;
    }
    Ok(sum.is_zero())
}

fn show(num: &Poly, signs: &[Sign], want: Sign) -> Result<()> {
    match num.sign(signs) {
        sign if sign >= want => Ok(()),
        Sign::Nonnegative => Err(Reason::NotShown("no monomial in positive parameters only")),
        Sign::Real | Sign::Positive => Err(Reason::NotShown("a coefficient below 0, or a real parameter")),
    }
}
