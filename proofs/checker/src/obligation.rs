//! What a sentence is about, and what it asks for: one conclusion at a time, under hypotheses.

use std::collections::BTreeSet;
use std::rc::Rc;

use crate::case::{Case, read};
use crate::error::{Reason, Result};
use crate::place::{Form, Place};
use crate::sentence::{Example, adjective, examples};
use crate::token::{Node, tree};
use crate::work::spend;

/// What a sentence is about.
#[derive(Clone, PartialEq)]
pub(crate) enum Subject<'t> {
    /// All knots.
    Knots,
    /// One of its examples.
    Example(Node<'t>),
    /// No knots at all.
    Weights,
}

/// What a sentence is about in degree k.
pub(crate) fn subjects<'t>(
    definitions: &[Node<'t>],
    sentence: &Node<'t>,
    k: i64,
) -> Result<Vec<Subject<'t>>> {
    let [given, ..] = sentence.part::<3>("sentence")?;
    if let Some(rows) = examples(sentence)? {
        let of_degree = |row: &&Node<'t>| Example::new(row).is_ok_and(|example| example.degree == k);
        return match rows.iter().filter(of_degree).cloned().map(Subject::Example).collect::<Vec<_>>() {
            none if none.is_empty() => sentence.wrong("an example of this degree"),
            found => Ok(found),
        };
    }
    if given.fields("for")?.iter().any(|binder| binder.is("knots") || binder.is("gaps")) {
        return Ok(vec![Subject::Knots]);
    }
    check_weights(definitions, sentence, k)?;
    Ok(vec![Subject::Weights])
}

/// A sentence about weights names nothing that belongs to knots. It stands for degree 1.
pub(crate) fn check_weights<'t>(definitions: &[Node<'t>], sentence: &Node<'t>, k: i64) -> Result<()> {
    let of_knots = |node: &Node<'t>| {
        ["k", "n", "m"].iter().any(|name| node.is_word(name))
            || ["t", "G", "w", "coefficient", "mult", "degree", "knots"].iter().any(|head| node.is(head))
    };
    match definitions.iter().chain([sentence]).find(|node| node.any(&mut |node| of_knots(node))) {
        None if k == 1 => Ok(()),
        _ => sentence.wrong("knots, or degree 1 and nothing but weights"),
    }
}

/// How far a derivation of a sentence reaches.
pub(crate) fn reach(sentence: &Node<'_>) -> Result<&'static str> {
    Ok(if examples(sentence)?.is_some() { "alpha" } else { "knots" })
}

/// What a sentence asks for: one formula, under hypotheses, for all values of what is bound.
#[derive(Clone, Default)]
pub(crate) struct Obligation<'t> {
    /// NAME LO HI.
    pub(crate) integers: Vec<Vec<Node<'t>>>,
    /// Names, with a sign or an interval if they have one.
    pub(crate) reals: Vec<(&'t str, Option<Node<'t>>)>,
    hypotheses: Vec<Node<'t>>,
    /// Of the knots.
    adjectives: Vec<&'t str>,
    pub(crate) conclusion: Option<Node<'t>>,
    /// The knot that is looked at, where the conclusion names no x.
    pub(crate) at: Option<Node<'t>>,
    /// Other members of the family.
    pub(crate) indices: Vec<&'t str>,
    /// Adjectives say all that they mean: hypotheses have to be true, not only to be left out.
    refuting: bool,
    pub(crate) subject: Option<Subject<'t>>,
}

/// The obligations of a sentence for degree k, in order.
pub(crate) fn obligations<'t>(
    sentence: &Node<'t>,
    k: i64,
    subject: &Subject<'t>,
    refuting: bool,
) -> Result<Vec<Obligation<'t>>> {
    let mut found = Vec::new();
    let of = Obligation { refuting, subject: Some(subject.clone()), ..Obligation::default() };
    if !open(sentence, k, of, &mut found)? {
        return sentence.wrong("a sentence about this degree");
    }
    Ok(found)
}

/// The binders and hypotheses of a sentence, and then each of its conclusions; `false` if it is about other degrees.
fn open<'t>(
    node: &Node<'t>,
    k: i64,
    mut of: Obligation<'t>,
    found: &mut Vec<Obligation<'t>>,
) -> Result<bool> {
    let [given, assume, then] = node.part("sentence")?;
    let mut knots = of.subject == Some(Subject::Weights);
    for binder in given.fields("for")? {
        match binder.headed("a binder")? {
            ("degree", [low]) if k < low.whole()? => return Ok(false),
            ("degree", [low, high]) if k < low.whole()? || k > high.whole()? => return Ok(false),
            ("degree", _) => {}
            (kind @ ("index" | "points"), [name]) => {
                not_reserved(name)?;
                if kind == "index" {
                    of.indices.push(name.name()?);
                }
            }
            ("knots", adjectives) => {
                knots = true;
                for node in adjectives {
                    of.adjectives.push(node.name()?);
                    for said in adjective(node, of.refuting)? {
                        of.hypotheses.extend(parts(&said)?);
                    }
                }
            }
            ("integer" | "point" | "real", _) => of.bind(binder)?,
            ("instances", rows) => match &of.subject {
                Some(Subject::Example(row)) if rows.contains(row) => knots = true,
                _ => return Err(Reason::NoWindow("it is about other examples")),
            },
            // Without this more is shown.
            ("alphas", _) if !of.refuting => {}
            ("alphas", list) => {
                let is = |alpha: &Node<'t>| {
                    let own = Node::made("alpha", vec![Node::name_of("alpha")]);
                    Node::made("chain", vec![own, Node::made("=", vec![alpha.clone()])])
                };
                of.hypotheses.push(Node::made("or", list.iter().map(is).collect()));
            }
            _ => return Err(Reason::NoWindow("it is about gaps")),
        }
    }
    if !knots {
        return Err(Reason::NoWindow("it is not about all knots"));
    }
    of.hypotheses.extend_from_slice(assume.fields("if")?);
    then.fields("then")?.iter().try_for_each(|conclusion| split(conclusion, k, of.clone(), found))?;
    Ok(true)
}

fn split<'t>(node: &Node<'t>, k: i64, mut of: Obligation<'t>, found: &mut Vec<Obligation<'t>>) -> Result<()> {
    spend(1)?;
    match node.headed("a formula")? {
        ("all", [over, body]) => {
            of.bind(over)?;
            split(body, k, of, found)
        }
        ("=>", [a, b]) => implied(a, b, k, of, found),
        ("<=>", [a, b]) => implied(a, b, k, of.clone(), found).and_then(|()| implied(b, a, k, of, found)),
        ("claim", [_, sentence]) => open(sentence, k, of, found).map(|_| ()),
        ("and", parts) => parts.iter().try_for_each(|part| split(part, k, of.clone(), found)),
        (word @ ("smooth" | "rational"), [expression]) if !of.refuting => {
            let [body, name, interval] = expression.part("expression")?;
            if word == "rational" && !between_neighbours(interval)? {
                return Err(Reason::NoWindow("not from one knot to the next"));
            }
            of.bind(&Node::made("reals", vec![name.clone(), interval.clone()]))?;
            of.conclusion = Some(Node::made(word, vec![Node::made("real", vec![body.clone()])]));
            found.push(of);
            Ok(())
        }
        ("chain", [a, step]) if !of.refuting && a.any(&mut |node| node.is("rank")) => {
            rank(a, step, k, &of, found)
        }
        _ => {
            for conclusion in parts(node)? {
                found.push(Obligation { conclusion: Some(conclusion), ..of.clone() });
            }
            Ok(())
        }
    }
}

/// Whether an interval is from t_J to t_{J+1}.
fn between_neighbours(interval: &Node<'_>) -> Result<bool> {
    let [_, a, _, b] = interval.group("an interval")?;
    let ([i], [j]) = (a.part("t")?, b.part("t")?);
    Ok(matches!(j.headed(""), Ok(("+", [of, one])) if of == i && *one == Node::whole_of(1)))
}

/// The rank of degree d is the number of i with t_i < t_{i+d+1}: the others are 0, and those that begin at one knot have different
/// orders there. So it is n + k − d + 1 if all are; and two less if all are but the first and the last one.
fn rank<'t>(
    a: &Node<'t>,
    step: &Node<'t>,
    k: i64,
    of: &Obligation<'t>,
    found: &mut Vec<Obligation<'t>>,
) -> Result<()> {
    let no_window = Reason::NoWindow("a rank that is not counted");
    let mut case = Case::new(&Rc::default(), &[], k, Place::Inside)?;
    let count = match (a.part("int"), step.part::<1>("=")) {
        (Ok([rank]), Ok([b])) => {
            rank.part::<1>("rank").and_then(|[d]| d.part::<1>("integer")).ok().zip(b.part::<1>("int").ok())
        }
        _ => None,
    };
    let Some(([degree], [count])) = count else { return Err(no_window) };
    let (Some(d), Some(count)) = (read(case.fixed(degree))?, read(case.int(count))?) else {
        return Err(no_window);
    };
    let ends = match count.plus(-1, &Form::last(k - d + 1))? {
        _ if d > k || d < 0 => return Err(no_window),
        same if same == Form::number(0) => 0,
        less if less == Form::number(-2) => 1,
        _ => return Err(no_window),
    };
    let number = Node::whole_of;
    let plus = |a: Node<'t>, b: i64| Node::made("+", vec![a, Node::whole_of(b)]);
    let knot = |i: Node<'t>| Node::made("t", vec![i]);
    let of_two = |a: Node<'t>, relation, b| {
        let conclusion = Node::made("chain", vec![a.clone(), Node::made(relation, vec![b])]);
        Obligation { at: Some(a), conclusion: Some(conclusion), ..of.clone() }
    };
    // The orders are shown by themselves.
    found
        .push(Obligation { conclusion: Some(Node::made("order", vec![number(d)])), ..Obligation::default() });
    let (i, last) = (Node::name_of(OF_RANK), plus(Node::name_of("n"), k - d));
    let mut all = of_two(knot(i.clone()), "<", knot(plus(i.clone(), d + 1)));
    all.integers.push(vec![i, number(ends), plus(last.clone(), -ends)]);
    found.push(all);
    if ends > 0 {
        found.push(of_two(knot(number(0)), "=", knot(number(d + 1))));
        found.push(of_two(knot(Node::name_of("m")), "=", knot(last)));
    }
    Ok(())
}

/// No name of a sentence.
const OF_RANK: &str = "rank";

/// a ⇒ b; not b ⇒ not a, if only a is about functions.
fn implied<'t>(
    a: &Node<'t>,
    b: &Node<'t>,
    k: i64,
    mut of: Obligation<'t>,
    found: &mut Vec<Obligation<'t>>,
) -> Result<()> {
    let functions = |node: &Node<'t>| node.any(&mut |node| node.is("of"));
    if functions(a) && !functions(b) {
        of.hypotheses.push(negated(b));
        split(&negated(a), k, of, found)
    } else {
        of.hypotheses.push(a.clone());
        split(b, k, of, found)
    }
}

fn negated<'t>(node: &Node<'t>) -> Node<'t> {
    const OPPOSITES: [(&str, &str); 6] =
        [("=", "/="), ("/=", "="), ("<", ">="), (">=", "<"), ("<=", ">"), (">", "<=")];
    match node.headed("") {
        Ok(("not", [of])) => of.clone(),
        Ok(("chain", [a, step])) => {
            let opposite = OPPOSITES.iter().find(|(relation, _)| step.is(relation));
            match (opposite, step.headed("")) {
                (Some((_, other)), Ok((_, [b]))) => {
                    Node::made("chain", vec![a.clone(), Node::made(other, vec![b.clone()])])
                }
                _ => Node::made("not", vec![node.clone()]),
            }
        }
        _ => Node::made("not", vec![node.clone()]),
    }
}

/// A chain as its neighbours (where all terms exist, equal neighbours make every pair equal), an interval as two
/// comparisons, a conjunction as what is in it.
pub(crate) fn parts<'t>(node: &Node<'t>) -> Result<Vec<Node<'t>>> {
    let pair = |a: &Node<'t>, relation, b: &Node<'t>| {
        Node::made("chain", vec![a.clone(), Node::made(relation, vec![b.clone()])])
    };
    match node.headed("a formula")? {
        ("and", all) => Ok(all.to_vec()),
        ("chain", [first, steps @ ..]) => {
            let (mut found, mut left) = (Vec::new(), first);
            for step in steps {
                let (relation, [right]) = step.headed("a relation")? else { return step.wrong("a relation") };
                found.push(pair(left, relation, right));
                left = right;
            }
            Ok(found)
        }
        ("in", [x, interval]) => {
            let [from, a, to, b] = interval.group("an interval")?;
            let relation = |end: &Node<'t>| if end.is_word("closed") { "<=" } else { "<" };
            Ok(vec![pair(a, relation(from), x), pair(x, relation(to), b)])
        }
        _ => Ok(vec![node.clone()]),
    }
}

/// What an obligation's functions are taken at.
#[derive(PartialEq)]
pub(crate) enum Point<'t> {
    /// A bound real.
    Real(&'t str),
    /// A knot.
    Knot(Node<'t>),
    /// At whatever they say.
    Any,
}

/// Whether a formula takes an index for a number that may be ∞: then it may not exist.
pub(crate) fn may_be_infinite(hypotheses: &[Node<'_>]) -> bool {
    fn indices<'t>(node: &Node<'t>, found: &mut Vec<&'t str>) {
        match node.headed("") {
            Ok(("alpha", [name])) => found.extend(name.name().ok()),
            // In another member it is no number, and next to ∞ none is asked for.
            Ok(("of", _)) => {}
            Ok(("chain", [_, step]))
                if step.headed("").is_ok_and(|(_, of)| of.iter().all(|b| b.is_word("infinity"))) => {}
            Ok((_, parts)) => parts.iter().for_each(|part| indices(part, found)),
            _ => {}
        }
    }
    let mut all = Vec::new();
    hypotheses.iter().for_each(|hypothesis| indices(hypothesis, &mut all));
    all.into_iter().any(|name| {
        let index = Node::made("alpha", vec![Node::name_of(name)]);
        let infinity = Node::made("/=", vec![Node::name_of("infinity")]);
        !hypotheses.contains(&Node::made("chain", vec![index, infinity]))
    })
}

/// Where a hypothesis leaves r beside 1: there for α = ∞, below for α < 0, above for α > 1.
pub(crate) fn side(hypotheses: &[Node<'_>]) -> Option<i64> {
    let is_alpha =
        |node: &Node<'_>| matches!(node.headed(""), Ok(("alpha", [name])) if name.is_word("alpha"));
    hypotheses.iter().find_map(|hypothesis| {
        let Ok(("chain", [a, step])) = hypothesis.headed("") else { return None };
        let (relation, [b]) = step.headed("").ok()? else { return None };
        let number = match b.headed("") {
            Ok(("int", [number])) => number.whole().ok(),
            _ => None,
        };
        match (relation, number) {
            _ if !is_alpha(a) => None,
            ("=", _) if b.is_word("infinity") => Some(0),
            ("<", Some(0)) => Some(-1),
            (">", Some(1)) => Some(1),
            _ => None,
        }
    })
}

impl<'t> Obligation<'t> {
    pub(crate) fn is(&self, adjective: &str) -> bool {
        self.adjectives.contains(&adjective)
    }

    /// Whether adjectives forbid so many copies of a knot there.
    pub(crate) fn forbids(&self, place: Place, k: i64) -> Result<bool> {
        // q > k consecutive indices in 1, …, n + k have one in k + 1, …, n, or hold both k and n + 1.
        let proper = tree("(chain (t k) (< (t (- m k))))")?;
        Ok(match place {
            // k + 2 copies of t_0 have t_{k+1} among them, which is t_{k+1}, …, t_n as t_k < t_{n+1}; so for t_m.
            Place::First(copies) | Place::Last(copies) => {
                let few = self.is("interior") && self.hypotheses.contains(&proper);
                self.is("simple") && copies.least() > 1 || few && copies.least() > k + 1
            }
            Place::Knot(copies) => {
                let few = self.is("inner") || self.is("interior") && self.hypotheses.contains(&proper);
                self.is("simple") && copies.least() > 1 || few && copies.least() > k
            }
            _ => false,
        })
    }

    /// A binder, and what it says of its name.
    fn bind(&mut self, binder: &Node<'t>) -> Result<()> {
        if let ("point" | "real" | "reals", [name, ..]) = binder.headed("a binder")? {
            not_reserved(name)?;
        }
        match binder.headed("a binder")? {
            ("integer" | "integers", range @ [_, _, _]) => self.integers.push(range.to_vec()),
            (_, [name]) => self.reals.push((name.name()?, None)),
            (_, [name, of]) => self.reals.push((name.name()?, Some(of.clone()))),
            _ => return binder.wrong("a binder"),
        }
        Ok(())
    }

    /// The hypotheses, and the intervals and signs of the reals.
    pub(crate) fn all_hypotheses(&self) -> Vec<Node<'t>> {
        let mut all = self.hypotheses.clone();
        for (name, of) in &self.reals {
            let x = Node::made("var", vec![Node::name_of(name)]);
            match of {
                Some(interval) if interval.list("").is_ok() => {
                    all.push(Node::made("in", vec![x, interval.clone()]));
                }
                Some(sign) if self.refuting => {
                    let zero = Node::made("int", vec![Node::whole_of(0)]);
                    let sign = if sign.is_word("<") { "<" } else { ">" };
                    all.push(Node::made("chain", vec![x, Node::made(sign, vec![zero])]));
                }
                _ => {}
            }
        }
        if self.refuting {
            let range = |range: &Vec<Node<'t>>| Node::made("among", range.clone());
            all.extend(self.integers.iter().map(range));
        }
        all
    }

    /// What the functions of the conclusion are taken at: one bound real, or one knot. Without functions, the one bound
    /// real in it, or the one with an interval.
    pub(crate) fn point(&self) -> Result<Point<'t>> {
        if let Some(at) = &self.at {
            return Ok(Point::Knot(at.clone()));
        }
        let many = Err(Reason::NoWindow("the functions are taken at more than one point"));
        let (conclusion, mut arguments) = (self.conclusion.iter().collect::<Vec<_>>(), Vec::new());
        for node in &conclusion {
            node.any(&mut |node| {
                if let Ok(("of", [_, of]) | ("mult", [of])) = node.headed("")
                    && let Ok((_, [argument, ..])) = of.headed("")
                {
                    arguments.push(argument.clone());
                }
                false
            });
        }
        let bound = |nodes: &[&Node<'t>]| {
            let named =
                |name: &&'t str| nodes.iter().any(|node| node.any(&mut |node| is_variable(node, name)));
            self.reals.iter().map(|(name, _)| *name).filter(named).collect::<BTreeSet<_>>()
        };
        let only = |names: BTreeSet<&'t str>| (names.len() == 1).then(|| names.first().copied()).flatten();
        let named = bound(&arguments.iter().collect::<Vec<_>>());
        match (named.is_empty(), arguments.first()) {
            (false, _) => only(named).map_or(many, |name| Ok(Point::Real(name))),
            (true, Some(knot)) if knot.is("t") && arguments.iter().all(|other| other == knot) => {
                Ok(Point::Knot(knot.clone()))
            }
            (true, Some(_)) => many,
            (true, None) => {
                let intervals =
                    self.reals.iter().filter(|(_, of)| of.as_ref().is_some_and(|of| of.list("").is_ok()));
                let name =
                    only(bound(&conclusion)).or_else(|| only(intervals.map(|(name, _)| *name).collect()));
                name.map(Point::Real).ok_or(Reason::NoWindow("there is no point"))
            }
        }
    }
}

/// These are names of something else in a derived section.
fn not_reserved(name: &Node<'_>) -> Result<()> {
    const RESERVED: [&str; 9] = ["u", "r", "o", "W", "M", "left", "right", "rho", "outside"];
    let reserved = RESERVED.iter().find(|reserved| name.is_word(reserved));
    reserved.map_or(Ok(()), |reserved| Err(Reason::Taken((*reserved).to_owned())))
}

pub(crate) fn names_index(node: &Node<'_>) -> bool {
    node.any(&mut |node| node.is("alpha"))
}

pub(crate) fn is_variable(node: &Node<'_>, name: &str) -> bool {
    matches!(node.headed(""), Ok(("var", [of])) if of.is_word(name))
}
