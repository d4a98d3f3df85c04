//! Knots that are numbers: where something is among them, and points, for which all hypotheses of a sentence are true and
//! a conclusion is not.

use std::cmp::Ordering;
use std::rc::Rc;

use crate::case::{Bound, Case, Found, Numbers, Stop, read};
use crate::env::Env;
use crate::error::{Reason, Result};
use crate::family::Family;
use crate::fraction::Fraction;
use crate::obligation::{Obligation, Subject, check_weights, obligations};
use crate::place::{Copies, Facts, Form, Place};
use crate::poly::Sign;
use crate::section::Section;
use crate::sentence::{Example, examples};
use crate::token::Node;
use crate::truth::Truth;
use crate::value::Value;

/// What stands in `point`.
pub(crate) struct Numbered<'n, 't> {
    /// Of a sentence about weights there are none.
    k: Option<i64>,
    knots: &'n [Node<'t>],
    /// (instance NAME), (parameter NAME value…), (integer NAME value), (real NAME value), (points NAME value…), (index NAME ratio).
    values: &'n [Node<'t>],
}

/// The sign of a − b.
fn sign<'t>(a: &Node<'t>, b: &Node<'t>) -> Result<i64> {
    let difference = Fraction::number(a)?.minus(&Fraction::number(b)?)?;
    Ok(match difference.num.sign(&[]) {
        Sign::Positive => 1,
        _ if difference.is_zero() => 0,
        _ => -1,
    })
}

fn index(at: usize) -> Result<i64> {
    i64::try_from(at).map_err(|_| Reason::Limits("the knots"))
}

/// k + 2 knots at least that do not fall, two of which differ.
pub(crate) fn check_knots<'t>(node: &Node<'t>, knots: &[Node<'t>], k: i64) -> Result<()> {
    for (a, b) in knots.iter().zip(knots.iter().skip(1)) {
        if sign(b, a)? < 0 {
            return b.wrong("knots that do not fall");
        }
    }
    match (knots.first(), knots.last()) {
        (Some(first), Some(last)) if index(knots.len())? >= k + 2 && sign(last, first)? > 0 => Ok(()),
        _ => node.wrong("k + 2 knots at least, and two that differ"),
    }
}

impl<'n, 't> Numbered<'n, 't> {
    pub(crate) fn new(family: &Family<'t>, node: &'n Node<'t>) -> Result<Self> {
        let (k, knots, values) = match node.fields("point")? {
            [k, knots, values @ ..] if k.is("k") => {
                let [degree] = k.part("k")?;
                let (k, knots) = (i64::from(degree.degree()?), knots.some("knots")?);
                check_knots(node, knots, k)?;
                (Some(k), knots, values)
            }
            values => (None, &[][..], values),
        };
        for (at, value) in values.iter().enumerate() {
            if let (list @ ("samples" | "factors" | "columns"), numbers) = value.headed("a value")? {
                if values.iter().take(at).any(|other| other.headed("").is_ok_and(|(head, _)| head == list)) {
                    return value.wrong("a list that stands once");
                }
                numbers.iter().try_for_each(|number| number.ratio().map(|_| ()))?;
                continue;
            }
            let (kind, [name, list @ ..]) = value.headed("a value")? else { return value.wrong("a name") };
            name.name()?;
            list.iter().try_for_each(|number| number.ratio().map(|_| ()))?;
            let fits = match (kind, list) {
                ("instance", []) => true,
                ("integer", [number]) => number.whole().is_ok(),
                ("real", [_]) => true,
                ("points", _) => {
                    k.is_some_and(|k| index(list.len()) == index(knots.len()).map(|m| m - k - 1))
                }
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
                        let (m, k) = (index(knots.len())? - 1, k.unwrap_or(1));
                        let mut admitted = own.all(m, k).len() == list.len();
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
                    "parameter, integer, real, points, instance or index with a name of its own and its numbers",
                );
            }
        }
        let given = values.iter().filter(|value| value.is("parameter")).count();
        if family.is_any() || given != family.parameters.len() {
            return node.wrong("numbers for all parameters of one family");
        }
        Ok(Numbered { k, knots, values })
    }

    /// The degree; 1 for weights.
    pub(crate) fn degree(&self) -> i64 {
        self.k.unwrap_or(1)
    }

    /// The number of a name.
    fn value(&self, kind: &'static str, name: &str) -> Option<&'n Node<'t>> {
        let of = |value: &'n Node<'t>| match value.fields(kind) {
            Ok([own, value]) if own.is_word(name) => Some(value),
            _ => None,
        };
        self.values.iter().find_map(of)
    }

    /// (let NAME NUMBER), and (values W NAME (INDEX… NUMBER)…) for those that belong to knots.
    fn parameters(&self, family: &Family<'t>) -> Result<Vec<Node<'t>>> {
        let m = index(self.knots.len())? - 1;
        let mut declared = Vec::new();
        for own in &family.parameters {
            let is_it = |value: &&'n Node<'t>| matches!(value.fields("parameter"), Ok([name, ..]) if name.is_word(own.name));
            let numbers =
                self.values.iter().find(is_it).map_or(Ok(&[][..]), |value| value.fields("parameter"))?;
            let numbers = numbers.iter().skip(1).cloned();
            let name = Node::name_of(own.name);
            if own.indices.is_empty() {
                declared.push(Node::made("let", [name].into_iter().chain(numbers).collect()));
                continue;
            }
            let indices =
                own.all(m, self.degree()).into_iter().map(|all| all.into_iter().map(Node::whole_of));
            let items =
                indices.zip(numbers).map(|(all, number)| Node::group_of(all.chain([number]).collect()));
            declared
                .push(Node::made("values", [Node::name_of("W"), name].into_iter().chain(items).collect()));
        }
        Ok(declared)
    }

    /// What these numbers are about: the example that is named, with its knots, if the sentence is about examples.
    fn subject(&self, definitions: &[Node<'t>], sentence: &Node<'t>) -> Result<Subject<'t>> {
        let Some(rows) = examples(sentence)? else {
            return match self.k {
                Some(_) => Ok(Subject::Knots),
                None => check_weights(definitions, sentence, 1).map(|()| Subject::Weights),
            };
        };
        let named = self.values.iter().find_map(|value| value.part::<1>("instance").ok());
        for row in rows {
            let example = Example::new(row)?;
            let is_it = named.is_some_and(|[name]| name.is_word(example.name));
            if is_it && Some(example.degree) == self.k && example.knots == self.knots {
                return Ok(Subject::Example(row.clone()));
            }
        }
        Err(Reason::NotShown("the numbers are not those of an example of the sentence"))
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
        let subject = self.subject(definitions, sentence)?;
        for obligation in obligations(sentence, self.degree(), &subject, true)? {
            if self.refuted(family, definitions, &subject, &obligation)? {
                return Ok(());
            }
        }
        Err(Reason::NotShown("no conclusion fails there while all its hypotheses are true"))
    }

    fn refuted(
        &self,
        family: &Rc<Family<'t>>,
        definitions: &[Node<'t>],
        subject: &Subject<'t>,
        obligation: &Obligation<'t>,
    ) -> Result<bool> {
        let mut case = Case::new(family, definitions, self.degree(), Place::Inside)?;
        let numbers = Numbers::of_knots(self.knots, subject, Some(self.values.to_vec()));
        let window = (!self.knots.is_empty()).then(|| numbers.window());
        let fixed: Vec<_> = window.into_iter().chain(self.parameters(family)?).collect();
        case.section = Section::new(&fixed, Env::new(family.clone()))?;
        (case.numbers, case.exact) = (Some(numbers), true);
        // Without a point any number does.
        if let Some(any) = self.knots.first() {
            let any = case.leaf(any.clone())?;
            read(case.locate(any))?;
        }
        for range in &obligation.integers {
            let [name, ..] = range.as_slice() else { return Ok(false) };
            let Some(value) = self.value("integer", name.name()?) else { return Ok(false) };
            case.ints.push((name.name()?, Form::number(value.whole()?)));
        }
        for (name, _) in &obligation.reals {
            let Some(value) = self.value("real", name) else { return Ok(false) };
            case.reals.push((name, Bound::Free(case.leaf(value.clone())?)));
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

/// Where a case is among numbers.
pub(crate) struct Located<'t> {
    place: Place,
    facts: Facts,
    shown: (i64, i64),
    numbers: Option<Numbers<'t>>,
}

impl<'t> Case<'_, 't> {
    /// Puts x in its place among the knots, if its distances from them have signs; what was before.
    pub(crate) fn locate(&mut self, x: Value<'t>) -> Found<Located<'t>> {
        let (Some(mut numbers), Some(plain)) = (self.numbers.clone(), x.plain) else {
            return Err(Stop::Undecided);
        };
        let mut beside = Vec::new();
        for knot in &numbers.knots {
            let beyond = plain.minus(&Fraction::number(knot)?)?;
            beside.push(match (self.sign(&beyond), self.sign(&beyond.negated())) {
                _ if beyond.is_zero() => Some(Ordering::Equal),
                (Sign::Positive, _) => Some(Ordering::Greater),
                (_, Sign::Positive) => Some(Ordering::Less),
                _ => None,
            });
        }
        let copies = beside.iter().filter(|order| **order == Some(Ordering::Equal)).count();
        let (copies, m) = (index(copies)?, index(beside.len())? - 1);
        let spans = beside.iter().zip(beside.iter().skip(1));
        let span = spans.enumerate().find_map(|(s, (left, right))| match (left.as_ref()?, right.as_ref()?) {
            (Ordering::Greater, Ordering::Less) => Some((s, Place::Inside)),
            (Ordering::Equal, Ordering::Less) if index(s) == Ok(copies - 1) => {
                Some((s, Place::First(Copies::Exactly(copies))))
            }
            (Ordering::Equal, Ordering::Less) => Some((s, Place::Knot(Copies::Exactly(copies)))),
            (Ordering::Greater, Ordering::Equal) if index(s).map(|s| s + copies) == Ok(m) => {
                Some((s, Place::Last(Copies::Exactly(copies))))
            }
            _ => None,
        });
        let (s, place) = match (span, beside.first(), beside.last()) {
            (Some(found), ..) => found,
            (None, Some(Some(Ordering::Less)), _) => (0, Place::Before),
            (None, _, Some(Some(Ordering::Greater))) => (0, Place::After),
            // There are no knots.
            (None, None, _) => (0, self.place),
            _ => return Err(Stop::Undecided),
        };
        numbers.u = match (place, numbers.knots.get(s), numbers.knots.get(s + 1)) {
            (Place::Inside, Some(left), Some(right)) => {
                let [from, to] = [(&x.term, left), (right, &x.term)]
                    .map(|(a, b)| Node::made("-", vec![a.clone(), b.clone()]));
                let u = self.leaf(Node::made("/", vec![from, to]))?;
                let own = self.leaf(Node::name_of("u"))?;
                let same = match (&u.plain, own.plain) {
                    (Some(u), Some(own)) => u.minus(&own)?.is_zero(),
                    _ => false,
                };
                if same { None } else { Some(u.term) }
            }
            _ => None,
        };
        numbers.x = Some(x.term);
        let s = index(s)?;
        Ok(Located {
            place: std::mem::replace(&mut self.place, place),
            facts: std::mem::replace(&mut self.facts, Facts::known(s, m - self.k - 1)),
            shown: std::mem::replace(&mut self.shown, (-s, m - s)),
            numbers: self.numbers.replace(numbers),
        })
    }

    pub(crate) fn restore(&mut self, before: Located<'t>) {
        let Located { place, facts, shown, numbers } = before;
        (self.place, self.facts, self.shown, self.numbers) = (place, facts, shown, numbers);
    }
}
