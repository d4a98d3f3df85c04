//! From a claim's sentence to sections: for every place of x the window there, and what has to be shown on it.
//!
//! Whatever is not understood, or not decided, is no derivation. Hypotheses may be left out: what is shown is then stronger.

use std::collections::BTreeSet;
use std::rc::Rc;

use crate::case::{At, Bound, Case, Found, Numbers, Stop, read};
use crate::env::Env;
use crate::error::{Reason, Result};
use crate::family::Family;
use crate::place::{Place, fine};
use crate::section::Section;
use crate::sentence::{Example, adjective, examples};
use crate::token::{Node, tree};
use crate::truth::Truth;
use crate::value::Value;
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
fn subjects<'t>(definitions: &[Node<'t>], sentence: &Node<'t>, k: i64) -> Result<Vec<Subject<'t>>> {
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
    /// Adjectives say all that they mean: hypotheses have to be true, not only to be left out.
    refuting: bool,
    subject: Option<Subject<'t>>,
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
            ("index" | "points", [name]) => not_reserved(name)?,
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
        _ => {
            for conclusion in parts(node)? {
                found.push(Obligation { conclusion: Some(conclusion), ..of.clone() });
            }
            Ok(())
        }
    }
}

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

/// α = ∞, α < 0, α > 1: these are all.
#[derive(Clone, Copy, PartialEq)]
enum Member {
    Classical,
    Below,
    Above,
}

/// What r is for such an α.
fn ratio<'t>(member: Option<Member>) -> Vec<Node<'t>> {
    let (one, rho) = (|| Node::whole_of(1), || Node::made("rho", vec![Node::whole_of(0)]));
    let above = || Node::made("+", vec![one(), rho()]);
    let r = match member {
        None => return Vec::new(),
        Some(Member::Classical) => one(),
        Some(Member::Below) => Node::made("/", vec![one(), above()]),
        Some(Member::Above) => above(),
    };
    let declared = r.any(&mut |node| node.is("rho")).then(|| Node::made("positive", vec![rho()]));
    declared.into_iter().chain([Node::made("let", vec![Node::name_of("r"), r])]).collect()
}

/// Which members of the family a hypothesis leaves.
fn member(hypotheses: &[Node<'_>]) -> Option<Member> {
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
            ("=", _) if b.is_word("infinity") => Some(Member::Classical),
            ("<", Some(0)) => Some(Member::Below),
            (">", Some(1)) => Some(Member::Above),
            _ => None,
        }
    })
}

impl<'t> Obligation<'t> {
    fn is(&self, adjective: &str) -> bool {
        self.adjectives.contains(&adjective)
    }

    /// Whether adjectives forbid so many copies of a knot there.
    fn forbids(&self, place: Place, k: i64) -> Result<bool> {
        // q > k consecutive indices in 1, …, n + k have one in k + 1, …, n, or hold both k and n + 1.
        let proper = tree("(chain (t k) (< (t (- m k))))")?;
        Ok(match place {
            Place::First(copies) | Place::Last(copies) => self.is("simple") && copies.least() > 1,
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

fn is_variable(node: &Node<'_>, name: &str) -> bool {
    matches!(node.headed(""), Ok(("var", [of])) if of.is_word(name))
}

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

/// The sections of a sentence for degree k.
pub(crate) fn sections<'t>(
    family: &Rc<Family<'t>>,
    definitions: &[Node<'t>],
    sentence: &Node<'t>,
    k: i64,
) -> Result<Vec<Node<'t>>> {
    let mut all = Vec::new();
    for subject in subjects(definitions, sentence, k)? {
        for (number, obligation) in (1..).zip(obligations(sentence, k, &subject, false)?) {
            let mut walk = Walk::new(&obligation, family, definitions, k)?;
            let found = match subject {
                Subject::Example(_) | Subject::Weights => walk.numbers(&subject)?,
                Subject::Knots => match walk.all()? {
                    Err(_) if obligation.is("symmetric") => {
                        walk.mirrored = true;
                        walk.all()?
                    }
                    found => found,
                }
                .map_err(|place| place.to_string()),
            };
            all.extend(found.map_err(|place| Reason::Undecided(number, place))?);
        }
    }
    Ok(all)
}

/// One obligation for one degree.
struct Walk<'w, 't> {
    family: &'w Rc<Family<'t>>,
    obligation: &'w Obligation<'t>,
    /// Those of the obligation, and the intervals of its reals.
    hypotheses: Vec<Node<'t>>,
    point: Point<'t>,
    definitions: &'w [Node<'t>],
    k: i64,
    mirrored: bool,
    member: Option<Member>,
}

impl<'w, 't> Walk<'w, 't> {
    fn new(
        obligation: &'w Obligation<'t>,
        family: &'w Rc<Family<'t>>,
        definitions: &'w [Node<'t>],
        k: i64,
    ) -> Result<Self> {
        let hypotheses = obligation.all_hypotheses();
        let point = match (&obligation.subject, obligation.point()) {
            (Some(Subject::Knots), point) => point?,
            (Some(Subject::Example(_)), Ok(Point::Real(name))) => Point::Real(name),
            _ => Point::Any,
        };
        let member = member(&hypotheses);
        Ok(Walk { family, obligation, hypotheses, point, definitions, k, mirrored: false, member })
    }

    /// The sections of all places, or the place where something is not decided.
    fn all(&self) -> Result<std::result::Result<Vec<Node<'t>>, Place>> {
        let mut found = Vec::new();
        for coarse in [Place::Before, Place::Inside, Place::Start, Place::End, Place::After] {
            if self.at(coarse, &mut found)? {
                continue;
            }
            let finer: Vec<_> = match coarse {
                Place::Start => fine(Place::First, self.k).chain(fine(Place::Knot, self.k)).collect(),
                Place::End => fine(Place::Last, self.k).collect(),
                _ => return Ok(Err(coarse)),
            };
            for place in finer {
                if !self.at(place, &mut found)? {
                    return Ok(Err(place));
                }
            }
        }
        Ok(Ok(found))
    }

    /// The section of a place, if anything is to be shown there; `false` if something is not decided that has to be.
    fn at(&self, place: Place, found: &mut Vec<Node<'t>>) -> Result<bool> {
        if self.obligation.forbids(place, self.k)? {
            return Ok(true);
        }
        let mut case = Case::new(self.family, self.definitions, self.k, place)?;
        case.symmetric = self.obligation.is("symmetric");
        case.mirrored = self.mirrored;
        // Gaps are closed first: the window is one for all cases.
        case.open()?;
        if !case.learn(&self.hypotheses)?
            || !case.coincide(&self.hypotheses)?
            || !case.learn(&self.hypotheses)?
        {
            return Ok(true);
        }
        let fixed = case.open()?;
        for (name, of) in &self.obligation.reals {
            let bound = self.real(&mut case, name, of.as_ref())?;
            case.reals.push((name, bound));
        }
        self.show(case, fixed, found)
    }

    /// What a real is: x, or any number of its sign.
    fn real(&self, case: &mut Case<'w, 't>, name: &'t str, of: Option<&Node<'t>>) -> Result<Bound<'t>> {
        let own = Node::name_of(name);
        Ok(match of {
            _ if self.point == Point::Real(name) => Bound::Point(At::X),
            Some(sign) if sign.is_word(">") => Bound::Free(case.parameter("positive", own)?),
            Some(sign) if sign.is_word("<") => {
                Bound::Free(case.parameter("positive", own)?.times(Value::whole(-1))?)
            }
            _ => Bound::Free(case.parameter("real", own)?),
        })
    }

    /// The sections of numbers: if something is not decided for all r, for each kind of α.
    fn numbers(&mut self, subject: &Subject<'t>) -> Result<std::result::Result<Vec<Node<'t>>, String>> {
        let all = |own: &Self| match subject {
            Subject::Example(row) => own.example(row),
            _ => own.weights(),
        };
        let found = all(self)?;
        if found.is_ok() || self.member.is_some() {
            return Ok(found);
        }
        let mut together = Vec::new();
        for member in [Member::Classical, Member::Below, Member::Above] {
            self.member = Some(member);
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
        let declared: Vec<_> = ratio(self.member).into_iter().chain(fixed.iter().cloned()).collect();
        case.section = Section::new(&declared, Env::new(self.family.clone()))?;
        case.numbers = Some(numbers);
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

    /// The section of a case, if anything is to be shown there; `false` if something is not decided that has to be.
    fn show(&self, mut case: Case<'w, 't>, fixed: Vec<Node<'t>>, found: &mut Vec<Node<'t>>) -> Result<bool> {
        if self.is_false(&mut case)? {
            return Ok(true);
        }
        let mut goals = Vec::new();
        if !self.cases(&self.obligation.integers, &mut case, &mut goals)? {
            return Ok(false);
        }
        if goals.is_empty() {
            return Ok(true);
        }
        let named = |name: &Node<'t>| goals.iter().any(|goal: &Node<'t>| goal.any(&mut |node| node == name));
        let declared = case.parameters.iter().filter(|(_, name)| named(name));
        let mut fields: Vec<_> = declared.map(|(sign, name)| Node::made(sign, vec![name.clone()])).collect();
        fields.extend(ratio(self.member));
        fields.extend(fixed);
        fields.push(Node::made("goals", goals));
        found.push(Node::made("section", fields));
        Ok(true)
    }

    /// Every choice of the integers, the last one fastest; `false` if one of them is not decided.
    fn cases(
        &self,
        integers: &[Vec<Node<'t>>],
        case: &mut Case<'w, 't>,
        goals: &mut Vec<Node<'t>>,
    ) -> Result<bool> {
        let Some((first, rest)) = integers.split_first() else { return self.one(case, goals) };
        let [name, low, high] = first.as_slice() else { return Ok(false) };
        let each = case.each([name, low, high], |case, _| {
            // What is false already is so whatever the others are.
            (case.knot, case.on_knot) = (None, false);
            if !case.learn(&self.hypotheses)? || self.is_false(case)? || self.cases(rest, case, goals)? {
                Ok(())
            } else {
                Err(Stop::Undecided)
            }
        });
        Ok(read(each)?.is_some())
    }

    /// Whether a hypothesis is false with the integers so far.
    fn is_false(&self, case: &mut Case<'w, 't>) -> Result<bool> {
        for hypothesis in &self.hypotheses {
            if case.truth(hypothesis)? == Truth::False {
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// All integers are chosen.
    fn one(&self, case: &mut Case<'w, 't>, goals: &mut Vec<Node<'t>>) -> Result<bool> {
        let facts = case.facts.clone();
        let decided = if case.learn(&self.hypotheses)? { self.decided(case, goals)? } else { true };
        case.facts = facts;
        Ok(decided)
    }

    fn decided(&self, case: &mut Case<'w, 't>, goals: &mut Vec<Node<'t>>) -> Result<bool> {
        let (mut open, mut undefined) = (false, false);
        if let Point::Knot(knot) = &self.point {
            case.knot = case.index(knot)?;
            case.on_knot = false;
            let x = Node::made("x", Vec::new());
            let at_knot = Node::made("chain", vec![x, Node::made("=", vec![knot.clone()])]);
            match case.truth(&at_knot)? {
                Truth::False => return Ok(true),
                truth => {
                    open |= !truth.is_true();
                    undefined |= truth == Truth::Undefined;
                }
            }
            case.on_knot = true;
        }
        for hypothesis in &self.hypotheses {
            match case.truth(hypothesis)? {
                Truth::False => return Ok(true),
                Truth::Undefined => undefined = true,
                truth => open |= !truth.is_true() && self.names_point(hypothesis),
            }
        }
        if undefined {
            return Ok(false);
        }
        let Some(conclusion) = &self.obligation.conclusion else { return Ok(false) };
        let truth = case.truth(conclusion)?;
        let coarse = matches!(case.place, Place::Start | Place::End);
        match truth {
            truth if truth.is_true() => Ok(true),
            Truth::Goals(new) if !(coarse && open) => {
                spend(goals.len())?;
                for goal in new {
                    if !goals.contains(&goal) {
                        goals.push(goal);
                    }
                }
                Ok(true)
            }
            _ => Ok(false),
        }
    }

    fn names_point(&self, hypothesis: &Node<'t>) -> bool {
        hypothesis.any(&mut |node| match &self.point {
            Point::Any => false,
            Point::Real(name) => is_variable(node, name),
            Point::Knot(knot) => node == knot,
        })
    }
}
