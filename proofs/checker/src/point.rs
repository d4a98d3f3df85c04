//! A refutation: numbers for which all hypotheses of a sentence are true, and a conclusion is not.

use std::rc::Rc;

use crate::case::{At, Bound, Case, Numbers};
use crate::derive::{Obligation, Point, obligations};
use crate::env::Env;
use crate::error::{Reason, Result};
use crate::family::Family;
use crate::fraction::Fraction;
use crate::place::{Copies, Facts, Form, Place};
use crate::poly::Sign;
use crate::section::Section;
use crate::token::Node;
use crate::truth::Truth;

/// What stands in `point`.
pub(crate) struct Numbered<'n, 't> {
    k: i64,
    knots: &'n [Node<'t>],
    /// (parameter NAME value…), (integer NAME value), (real NAME value), (points NAME value…), (index NAME ratio).
    values: &'n [Node<'t>],
}

/// The sign of a − b.
fn sign<'t>(a: &Node<'t>, b: &Node<'t>) -> Result<i64> {
    Ok(sign_of(&Fraction::number(a)?.minus(&Fraction::number(b)?)?))
}

fn index(at: usize) -> Result<i64> {
    i64::try_from(at).map_err(|_| Reason::Limits("the knots"))
}

impl<'n, 't> Numbered<'n, 't> {
    pub(crate) fn new(family: &Family<'t>, node: &'n Node<'t>) -> Result<Self> {
        let [k, knots, values @ ..] = node.fields("point")? else { return node.wrong("k and knots") };
        let [degree] = k.part("k")?;
        let (k, knots) = (i64::from(degree.degree()?), knots.some("knots")?);
        for (a, b) in knots.iter().zip(knots.iter().skip(1)) {
            if sign(b, a)? < 0 {
                return b.wrong("knots that do not fall");
            }
        }
        for (at, value) in values.iter().enumerate() {
            let (kind, [name, list @ ..]) = value.headed("a value")? else { return value.wrong("a name") };
            name.name()?;
            list.iter().try_for_each(|number| number.ratio().map(|_| ()))?;
            let fits = match (kind, list) {
                ("integer", [number]) => number.whole().is_ok(),
                ("real", [_]) => true,
                ("points", _) => list.len() + usize::from(degree.degree()?) + 1 == knots.len(),
                // Another member of the family.
                ("index", [other]) => {
                    let ratio = values.iter().find_map(|value| match value.fields("parameter") {
                        Ok([name, ratio]) if name.is_word("r") => Some(ratio),
                        _ => None,
                    });
                    let differs =
                        ratio.map(|ratio| sign(other, ratio)).transpose()?.is_some_and(|sign| sign != 0);
                    sign(other, &Node::whole_of(0))? > 0 && differs
                }
                ("parameter", list) => match family.parameter(name.name()?) {
                    Some(own) => {
                        let mut admitted = own.all(index(knots.len())? - 1, k).len() == list.len();
                        for number in list {
                            admitted &= own.admits(number)?;
                        }
                        admitted
                    }
                    None => false,
                },
                _ => false,
            };
            let again = values
                .iter()
                .take(at)
                .any(|other| other.headed("").is_ok_and(|(_, of)| of.first() == Some(name)));
            if !fits || again {
                return value.wrong(
                    "parameter, integer, real, points or index with a name of its own and its numbers",
                );
            }
        }
        let given = values.iter().filter(|value| value.is("parameter")).count();
        if family.is_any() || given != family.parameters.len() {
            return node.wrong("numbers for all parameters of one family");
        }
        let long = knots.len() >= usize::from(degree.degree()?) + 2;
        match (knots.first(), knots.last()) {
            (Some(first), Some(last)) if long && sign(last, first)? > 0 => Ok(Numbered { k, knots, values }),
            _ => node.wrong("k + 2 knots at least, and two that differ"),
        }
    }

    /// The degree.
    pub(crate) fn degree(&self) -> i64 {
        self.k
    }

    /// The numbers of a name.
    fn values(&self, kind: &'static str, name: &str) -> Option<&'n [Node<'t>]> {
        let of = |value: &'n Node<'t>| match value.fields(kind) {
            Ok([own, list @ ..]) if own.is_word(name) => Some(list),
            _ => None,
        };
        self.values.iter().find_map(of)
    }

    /// Whether one of the conclusions is refuted.
    ///
    /// # Errors
    /// If none is, or a value is missing.
    pub(crate) fn refutes(
        &self,
        family: &Rc<Family<'t>>,
        definitions: &[Node<'t>],
        sentence: &Node<'t>,
    ) -> Result<()> {
        for obligation in obligations(sentence, self.k, true)? {
            if self.refuted(family, definitions, &obligation)? {
                return Ok(());
            }
        }
        Err(Reason::NotShown("no conclusion fails there while all its hypotheses are true"))
    }

    fn refuted(
        &self,
        family: &Rc<Family<'t>>,
        definitions: &[Node<'t>],
        obligation: &Obligation<'t>,
    ) -> Result<bool> {
        let point = obligation.point().ok();
        let x = match &point {
            Some(Point::Real(name)) => match self.values("real", name) {
                Some([x]) => Some(x),
                _ => return Ok(false),
            },
            _ => None,
        };
        // Without a point any number does.
        let Some(any) = self.knots.first() else { return Ok(false) };
        let mut case = Case::new(family, definitions, self.k, Place::Inside)?;
        let values = self.values.to_vec();
        case.numbers = Some(Numbers { x: None, u: None, knots: self.knots.to_vec(), values });
        case.locate(x.unwrap_or(any).clone())?;
        for range in &obligation.integers {
            let [name, ..] = range.as_slice() else { return Ok(false) };
            let Some([value]) = self.values("integer", name.name()?) else { return Ok(false) };
            case.ints.push((name.name()?, Form::number(value.whole()?)));
        }
        if let Some(Point::Knot(knot)) = &point {
            let at = case.index(knot)?.and_then(|form| case.facts.value(&form));
            let Some(x) = at.and_then(|at| usize::try_from(at).ok()).and_then(|at| self.knots.get(at)) else {
                return Ok(false);
            };
            case.locate(x.clone())?;
        }
        for (name, _) in &obligation.reals {
            let Some([value]) = self.values("real", name) else { return Ok(false) };
            let bound = match point {
                Some(Point::Real(point)) if point == *name => Bound::Point(At::X),
                _ => Bound::Free(case.leaf(value.clone())?),
            };
            case.reals.push((name, bound));
        }
        for hypothesis in obligation.all_hypotheses() {
            if !case.truth(&hypothesis)?.is_true() {
                return Ok(false);
            }
        }
        let Some(conclusion) = &obligation.conclusion else { return Ok(false) };
        case.undecided = false;
        Ok(match case.truth(conclusion)? {
            Truth::False => true,
            Truth::Undefined => !case.undecided,
            _ => false,
        })
    }
}

/// Where a case is at numbers.
pub(crate) struct Located<'t> {
    place: Place,
    facts: Facts,
    shown: (i64, i64),
    section: Section<'t>,
    numbers: Option<Numbers<'t>>,
}

impl<'t> Case<'_, 't> {
    /// Puts x in its place among the knots; what was before.
    pub(crate) fn locate(&mut self, x: Node<'t>) -> Result<Located<'t>> {
        let Some(mut numbers) = self.numbers.clone() else {
            return Err(Reason::NotShown("there are no numbers"));
        };
        // Nothing but numbers and r is in x.
        let value = |node: &Node<'t>| self.section.term(node, &self.section.env);
        let sign = |a: &Node<'t>, b: &Node<'t>| Ok::<_, Reason>(sign_of(&value(a)?.minus(&value(b)?)?));
        let (mut span, mut copies) = (None, 0);
        for (s, (left, right)) in numbers.knots.iter().zip(numbers.knots.iter().skip(1)).enumerate() {
            // The last span that begins before x or at it, or the first one.
            if sign(right, left)? > 0 && (span.is_none() || sign(&x, left)? >= 0) {
                span = Some((s, left, right));
            }
        }
        for knot in &numbers.knots {
            copies += i64::from(sign(&x, knot)? == 0);
        }
        let Some((s, left, right)) = span else { return Err(Reason::Limits("the knots")) };
        let (s, m, copies) = (index(s)?, index(numbers.knots.len())? - 1, Copies::Exactly(copies));
        let difference = |a: &Node<'t>, b: &Node<'t>| Node::made("-", vec![a.clone(), b.clone()]);
        let (place, u) = match (sign(&x, left)?, sign(&x, right)?) {
            (-1, _) => (Place::Before, None),
            (_, 1) => (Place::After, None),
            (0, _) if s + 1 == copies.least() => (Place::First(copies), None),
            (0, _) => (Place::Knot(copies), None),
            (_, 0) => (Place::Last(copies), None),
            _ => (Place::Inside, Some(Node::made("/", vec![difference(&x, left), difference(right, &x)]))),
        };
        let window =
            [Node::name_of("W"), Node::whole_of(-s)].into_iter().chain(numbers.knots.iter().cloned());
        let mut declared = vec![Node::made("knots", window.collect())];
        for own in &self.family.parameters {
            let mut items = Vec::new();
            for (at, indices) in own.all(m, self.k).into_iter().enumerate() {
                let value = numbers.of("parameter", own.name, at).ok_or(Reason::Limits("a parameter"))?;
                let shifted =
                    own.indices.iter().zip(indices).map(|(kind, i)| if *kind == "i" { i - s } else { i });
                let indices = shifted.map(Node::whole_of);
                items.push(Node::group_of(indices.chain([value]).collect()));
            }
            declared.push(match (own.indices.as_slice(), items.as_slice()) {
                ([], [one]) => {
                    Node::made("let", vec![Node::name_of(own.name), one.list("a number")?[0].clone()])
                }
                _ => {
                    let head = [Node::name_of("W"), Node::name_of(own.name)];
                    Node::made("values", head.into_iter().chain(items).collect())
                }
            });
        }
        let section = Section::new(&declared, Env::new(self.family.clone()))?;
        (numbers.x, numbers.u) = (Some(x), u);
        Ok(Located {
            place: std::mem::replace(&mut self.place, place),
            facts: std::mem::replace(&mut self.facts, Facts::known(s, m - self.k - 1)),
            shown: std::mem::replace(&mut self.shown, (-s, m - s)),
            section: std::mem::replace(&mut self.section, section),
            numbers: self.numbers.replace(numbers),
        })
    }

    pub(crate) fn restore(&mut self, before: Located<'t>) {
        let Located { place, facts, shown, section, numbers } = before;
        (self.place, self.facts, self.shown, self.section, self.numbers) =
            (place, facts, shown, section, numbers);
    }
}

fn sign_of(value: &Fraction) -> i64 {
    match value.num.sign(&[]) {
        Sign::Positive => 1,
        _ if value.is_zero() => 0,
        _ => -1,
    }
}
