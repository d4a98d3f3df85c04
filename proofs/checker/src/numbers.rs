//! Sections where knots are numbers, those of an example, or where there are none, of weights: x at all its places, reals in all
//! their orders, and so the ratios of indices.

use crate::case::{Bound, Case, Found, Numbers, Stop, read};
use crate::derive::Walk;
use crate::env::Env;
use crate::error::{Reason, Result};
use crate::obligation::{Point, Subject, is_variable};
use crate::place::Place;
use crate::section::Section;
use crate::sentence::Example;
use crate::token::Node;
use crate::value::Value;

/// All places of x against knots that are numbers.
fn around<'t>(knots: &[Node<'t>]) -> Vec<Node<'t>> {
    let outside = || Node::name_of("outside");
    let beyond =
        |head, knot: Option<&Node<'t>>| knot.map(|knot| Node::made(head, vec![knot.clone(), outside()]));
    let mut all: Vec<_> = beyond("-", knots.first()).into_iter().collect();
    for (left, right) in knots.iter().zip(knots.iter().skip(1)) {
        if left != right {
            all.extend([left.clone(), inside(left, right)]);
        }
    }
    all.into_iter().chain(knots.last().cloned()).chain(beyond("+", knots.last())).collect()
}

/// (a + u·b)/(1 + u): all numbers between a and b.
fn inside<'t>(a: &Node<'t>, b: &Node<'t>) -> Node<'t> {
    let u = || Node::name_of("u");
    let sum = |a: Node<'t>, b| Node::made("+", vec![a, b]);
    let above = sum(a.clone(), Node::made("*", vec![u(), b.clone()]));
    Node::made("/", vec![above, sum(Node::whole_of(1), u())])
}

/// All orders of so many numbers, the same ones next to each other: the ranks of each, from 0 without a gap.
fn orders(count: usize) -> Result<Vec<Vec<i64>>> {
    const MOST: usize = 5;
    if count > MOST {
        return Err(Reason::NoWindow("it has more reals than are put in order"));
    }
    let mut all = vec![Vec::new()];
    for _ in 0..count {
        let longer = |order: &Vec<i64>| {
            (0..).take(count).map(|rank| order.iter().copied().chain([rank]).collect()).collect::<Vec<_>>()
        };
        all = all.iter().flat_map(longer).collect();
    }
    all.retain(|order| order.iter().all(|rank| *rank == 0 || order.contains(&(rank - 1))));
    Ok(all)
}

/// A ratio so many ranks beside 1: 1 + (rho 0) + …, or 1/(1 + (rho -1) + …).
fn beside<'t>(one: i64, rank: i64) -> Node<'t> {
    let rho = |j| Node::made("rho", vec![Node::whole_of(j)]);
    let sum = |steps: Vec<i64>| {
        let first = [Node::whole_of(1)].into_iter();
        Node::made("+", first.chain(steps.into_iter().map(rho)).collect())
    };
    match rank - one {
        0 => Node::whole_of(1),
        above @ 1.. => sum((0..above).collect()),
        below => Node::made("/", vec![Node::whole_of(1), sum((1..=-below).map(|j| -j).collect())]),
    }
}

/// What is known of r, the rank of which is the second one, and of other ratios: all that occurs in them.
pub(crate) fn declared<'t>(order: &[i64]) -> Vec<Node<'t>> {
    let [one, r, ..] = order else { return Vec::new() };
    let most = order.iter().max().map_or(0, |most| most - one);
    let all: Vec<_> = (-one..most).map(|j| Node::made("rho", vec![Node::whole_of(j)])).collect();
    let positive = (!all.is_empty()).then(|| Node::made("positive", all));
    let r = Node::made("let", vec![Node::name_of("r"), beside(*one, *r)]);
    positive.into_iter().chain([r]).collect()
}

/// The number of a rank: o, and what each is more than the one before.
fn ranked<'t>(case: &mut Case<'_, 't>, rank: i64) -> Result<Value<'t>> {
    let mut value = case.parameter("real", Node::name_of("o"))?;
    for step in 0..rank {
        let name = Node::made("W", vec![Node::whole_of(step)]);
        value = value.plus(case.parameter("positive", name)?)?;
    }
    Ok(value)
}

impl<'t> Case<'_, 't> {
    /// The left end of an interval, any number inside, or the right end, by 0, 1, 2; nothing, if there is none.
    fn between(&mut self, interval: &Node<'t>, part: usize) -> Found<Option<Value<'t>>> {
        let [from, a, to, b] = interval.group("an interval")?;
        let (left, right) = (self.real(a)?, self.real(b)?);
        let both = from.is_word("closed") && to.is_word("closed");
        if self.compare(left.clone(), "<", right.clone())?.is_true() {
            return Ok(match part {
                0 => from.is_word("closed").then_some(left),
                1 => Some(self.leaf(inside(&left.term, &right.term))?),
                _ => to.is_word("closed").then_some(right),
            });
        }
        match self.compare(left.clone(), ">=", right.clone())? {
            truth if !truth.is_true() => Err(Stop::Undecided),
            // It is empty, or its ends are the same.
            _ if part > 0 || !both => Ok(None),
            _ if self.compare(left.clone(), "=", right)?.is_true() => Ok(Some(left)),
            _ => Ok(None),
        }
    }
}

impl<'w, 't> Walk<'w, 't> {
    /// The sections of numbers: if something is not decided for all r, for each order of 1, r, and the ratios of other indices.
    pub(crate) fn numbers(
        &mut self,
        subject: &Subject<'t>,
    ) -> Result<std::result::Result<Vec<Node<'t>>, String>> {
        let all = |own: &Self| match subject {
            Subject::Example(row) => own.example(row),
            _ => own.weights(),
        };
        self.free = true;
        let found = all(self)?;
        if found.is_ok() || !self.family.is_by_ratio() {
            return Ok(found);
        }
        self.free = false;
        let mut together = Vec::new();
        for order in orders(2 + self.obligation.indices.len())? {
            let [one, alpha, others @ ..] = order.as_slice() else { continue };
            if others.contains(alpha) {
                continue;
            }
            self.declared = declared(&order);
            let ratio = |(name, rank): (&&'t str, &i64)| (*name, beside(*one, *rank));
            self.ratios = self.obligation.indices.iter().zip(others).map(ratio).collect();
            match all(self)? {
                Ok(sections) => together.extend(sections),
                Err(_) => return Ok(found),
            }
        }
        Ok(Ok(together))
    }

    /// The sections of all places among the knots of an example, or the place where something is not decided.
    fn example(&self, row: &Node<'t>) -> Result<std::result::Result<Vec<Node<'t>>, String>> {
        let mut found = Vec::new();
        let Example { name: example, knots, .. } = Example::new(row)?;
        for x in if matches!(self.point, Point::Real(_)) { around(knots) } else { knots[..1].to_vec() } {
            let numbers = Numbers::of_knots(knots, &Subject::Example(row.clone()), None);
            let fixed = vec![numbers.window()];
            let mut case = self.case(numbers, &fixed)?;
            if x.any(&mut |node| node.is_word("outside")) {
                case.parameter("positive", Node::name_of("outside"))?;
            }
            let x = case.leaf(x)?;
            let located = read(case.locate(x))?.is_some();
            for (name, of) in &self.obligation.reals {
                let bound = self.real(&mut case, name, of.as_ref())?;
                case.reals.push((name, bound));
            }
            let place = case.place;
            if !located || !self.show(case, fixed, &mut found)? {
                return Ok(Err(format!("{place} of {example}")));
            }
        }
        Ok(Ok(found))
    }

    /// A case of numbers, with x nowhere yet, and r as far as it is known.
    fn case(&self, numbers: Numbers<'t>, fixed: &[Node<'t>]) -> Result<Case<'w, 't>> {
        let mut case = Case::new(self.family, self.definitions, self.k, Place::Inside)?;
        let declared: Vec<_> = self.declared.iter().chain(fixed).cloned().collect();
        case.section = Section::new(&declared, Env::new(self.family.clone()))?;
        (case.numbers, case.ratios) = (Some(numbers), self.ratios.clone());
        Ok(case)
    }

    /// The sections of all orders of the reals, each with all places of the one that has an interval.
    fn weights(&self) -> Result<std::result::Result<Vec<Node<'t>>, String>> {
        let mut found = Vec::new();
        let reals = &self.obligation.reals;
        let interval = |of: &Option<Node<'t>>| of.as_ref().filter(|of| of.list("").is_ok()).cloned();
        let located = reals.iter().rev().find_map(|(name, of)| Some((*name, interval(of)?)));
        let ordered: Vec<_> =
            reals.iter().filter(|(name, of)| of.is_none() && self.stands_alone(name)).collect();
        for order in orders(ordered.len())? {
            // The ends of the interval, x between them, or neither.
            for part in 0..if located.is_some() { 3 } else { 1 } {
                let mut case = self.case(Numbers::of_knots(&[], &Subject::Weights, None), &[])?;
                let mut ranks = order.iter();
                for (name, of) in reals {
                    if located.as_ref().is_some_and(|(x, _)| x == name) {
                        continue;
                    }
                    let bound = match ordered.iter().any(|(known, _)| known == name).then(|| ranks.next()) {
                        Some(Some(rank)) => Bound::Free(ranked(&mut case, *rank)?),
                        _ => self.real(&mut case, name, of.as_ref())?,
                    };
                    case.reals.push((name, bound));
                }
                if self.is_false(&mut case)? {
                    continue;
                }
                if let Some((name, interval)) = &located {
                    match read(case.between(interval, part))? {
                        Some(Some(x)) => case.reals.push((name, Bound::Free(x))),
                        Some(None) => continue,
                        None => {
                            return Ok(
                                Err("an interval of which it is not known whether it is empty".into()),
                            );
                        }
                    }
                }
                if !self.show(case, Vec::new(), &mut found)? {
                    return Ok(Err(format!("{}: {order:?}", "an order of the reals")));
                }
            }
        }
        Ok(Ok(found))
    }

    /// Whether a real is compared, an end, or what a function is taken at, and not only part of a term.
    fn stands_alone(&self, name: &str) -> bool {
        const ARITHMETIC: [&str; 9] = ["+", "-", "*", "/", "^", "neg", "abs", "min", "max"];
        let mut alone = |node: &Node<'t>| match node.headed("") {
            Ok((head, fields)) => {
                !ARITHMETIC.contains(&head) && fields.iter().any(|field| is_variable(field, name))
            }
            Err(_) => false,
        };
        self.hypotheses.iter().chain(&self.obligation.conclusion).any(|node| node.any(&mut alone))
    }
}
