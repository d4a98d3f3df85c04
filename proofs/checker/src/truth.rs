//! What a formula says in a case: false, not decided, or goals to prove.

use crate::case::{Bound, Case, Found, Stop};
use crate::error::Result;
use crate::obligation::parts;
use crate::place::{Form, Place};
use crate::poly::Sign;
use crate::sentence::Example;
use crate::token::Node;
use crate::value::Value;

#[derive(PartialEq)]
pub(crate) enum Truth<'t> {
    False,
    Undecided,
    Undefined,
    /// True if all of these are.
    Goals(Vec<Node<'t>>),
}

impl<'t> Truth<'t> {
    pub(crate) fn of(truth: bool) -> Self {
        if truth { Truth::Goals(Vec::new()) } else { Truth::False }
    }

    pub(crate) fn known(truth: Option<bool>) -> Self {
        truth.map_or(Truth::Undecided, Truth::of)
    }

    pub(crate) fn is_true(&self) -> bool {
        matches!(self, Truth::Goals(goals) if goals.is_empty())
    }

    pub(crate) fn and(self, other: Self) -> Self {
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

    pub(crate) fn or(self, other: Self) -> Self {
        match (self, other) {
            (a, b) if a.is_true() || b.is_true() => Truth::of(true),
            (Truth::False, other) | (other, Truth::False) => other,
            (Truth::Undefined, _) | (_, Truth::Undefined) => Truth::Undefined,
            _ => Truth::Undecided,
        }
    }

    pub(crate) fn not(self) -> Self {
        match self {
            Truth::False => Truth::of(true),
            truth if truth.is_true() => Truth::False,
            Truth::Goals(_) => Truth::Undecided,
            other => other,
        }
    }
}

impl<'t> Case<'_, 't> {
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

    pub(crate) fn formula(&mut self, node: &Node<'t>) -> Found<Truth<'t>> {
        match node.headed("a formula")? {
            ("chain", [a, step]) => {
                let (relation, [b]) = step.headed("a relation")? else { return Err(Stop::Undecided) };
                if let Some(truth) = self.counted(a, relation, b)? {
                    return Ok(truth);
                }
                if let Some(forms) = self.integers(node)? {
                    let truth = self.all_nonnegative(&forms)?;
                    return Ok(if relation == "/=" { truth.not() } else { truth });
                }
                if let Ok(("alpha", [name])) = a.headed("")
                    && b.is_word("infinity")
                {
                    return match relation {
                        "=" | "/=" => Ok(Truth::of(self.alpha(name)?.is_none() == (relation == "="))),
                        _ => Err(Stop::Undecided),
                    };
                }
                match (self.real(a), self.real(b)) {
                    (Ok(a), Ok(b)) => self.compare(a, relation, b),
                    (Err(Stop::Undefined), _) | (_, Err(Stop::Undefined)) => Err(Stop::Undefined),
                    (Err(stop), _) | (_, Err(stop)) => Err(stop),
                }
            }
            ("among", _) => {
                let forms = self.integers(node)?.unwrap_or_default();
                Ok(self.all_nonnegative(&forms)?)
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
            ("some", [over, body]) if over.is("reals") => self.some_real(over, body),
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
            ("one", [over, body]) => {
                let ("integers", [name, low, high]) = over.headed("a range")? else {
                    return Err(Stop::Undecided);
                };
                let each = self.each([name, low, high], |own, sure| {
                    let truth = own.truth(body)?;
                    let known = sure && (truth == Truth::False || truth.is_true());
                    if known { Ok(truth.is_true()) } else { Err(Stop::Undecided) }
                })?;
                Ok(Truth::of(each.into_iter().filter(|is| *is).count() == 1))
            }
            ("instance", names) => {
                let example = self.numbers.as_ref().and_then(|numbers| numbers.example.as_ref());
                let name = Example::of(example.ok_or(Stop::Undecided)?)?.name;
                Ok(Truth::of(names.iter().any(|known| known.is_word(name))))
            }
            ("defined", [of]) => {
                let [real] = of.part("real")?;
                let value = self.real(real)?;
                Ok(match value.plain {
                    Some(_) => Truth::of(true),
                    None => Truth::Goals(vec![Node::made("defined", vec![value.term])]),
                })
            }
            (word @ ("smooth" | "rational"), [of]) if of.is("real") => {
                let [real] = of.part("real")?;
                let value = self.real(real)?;
                match self.place {
                    // On a span it is a quotient of polynomials in x.
                    Place::Inside
                        if !self.family.is_any() && !value.term.any(&mut |node| node.is_word("u")) =>
                    {
                        let ends = if word == "rational" { &["in", "from", "to"][..] } else { &["in"] };
                        let defined =
                            |end: &&'static str| Node::made("defined", vec![value.term.at_end(end)]);
                        Ok(Truth::Goals(if value.is_zero() {
                            Vec::new()
                        } else {
                            ends.iter().map(defined).collect()
                        }))
                    }
                    Place::Before | Place::After if value.is_zero() => Ok(Truth::of(true)),
                    _ => Err(Stop::Undecided),
                }
            }
            (head, of) => self.word(head, of),
        }
    }

    /// Whether something is true at a knot of an example, or in the middle between two.
    fn some_real(&mut self, over: &Node<'t>, body: &Node<'t>) -> Found<Truth<'t>> {
        let [name, interval] = over.part("reals")?;
        let knots = self.numbers.as_ref().map(|numbers| numbers.knots.clone()).ok_or(Stop::Undecided)?;
        let middle = |(a, b): (&Node<'t>, &Node<'t>)| {
            Node::made("/", vec![Node::made("+", vec![a.clone(), b.clone()]), Node::whole_of(2)])
        };
        let middles = knots.iter().zip(knots.iter().skip(1)).map(middle);
        for x in knots.iter().cloned().chain(middles) {
            let x = self.leaf(x)?;
            self.reals.push((name.name()?, Bound::Free(x)));
            let variable = Node::made("var", vec![name.clone()]);
            let within = self.truth(&Node::made("in", vec![variable, interval.clone()]));
            let holds = within?.and(self.exactly(|own| own.truth(body))?);
            self.reals.pop();
            if holds.is_true() {
                return Ok(holds);
            }
        }
        Err(Stop::Undecided)
    }

    fn all_nonnegative(&self, forms: &[Form]) -> Result<Truth<'t>> {
        let known = |form| self.facts.is_nonnegative(form).map(Truth::known);
        forms.iter().try_fold(Truth::of(true), |all, form| Ok(all.and(known(form)?)))
    }

    pub(crate) fn compare(&mut self, a: Value<'t>, relation: &str, b: Value<'t>) -> Found<Truth<'t>> {
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
}
