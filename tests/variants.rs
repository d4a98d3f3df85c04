//! What is true, made false at one place: every sentence that is taken for true is varied mechanically, and each variant is
//! refuted, or variants.toml says why it is not.
//!
//! Only what makes a sentence say more, or something else, is done: a range of `for` is made wider and never narrower, a
//! hypothesis is dropped or weakened and never turned. What says less is true by its form.

#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests")]

use std::collections::{BTreeMap, BTreeSet};
use std::sync::{Arc, LazyLock};

use knotproof::certificate::{Certificate, derived};
use knotproof::judge::{Case, Cases, Origin, Verdict, Witness, judge};
use knotproof::language::{
    Argument, Binder, Claim, Form, Formula, Function, Int, Interval, Item, Member, Over, Range, Real,
    Relation, Sentence, Use, claims, paper, source,
};
use knotproof::meaning::{Instance, concerns};
use knotproof::scalar::integer;
use knotproof::spline::{Basis, KnotVector};
use rayon::prelude::*;
use serde::Deserialize;

/// What is done to a sentence.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Change {
    /// < for >, ≤ for ≥, = for ≠; `not` before a word.
    Turned,
    /// An index or a bound, by one.
    Shifted,
    /// A hypothesis, an adjective, a premise, a part of one, an alternative.
    Dropped,
    /// α for 1 − α, 1/r for r.
    Exchanged,
    /// A closed end for an open one, ≤ for <.
    End,
}

/// Does the sentence say more if the formula does? If it is both or neither nobody knows.
type Positive = Option<bool>;
/// By which shift of a term the sentence says more.
type Way = Option<i64>;

/// Walks over a tree, counts the places that can be varied, and varies one of them.
struct Walk {
    left: usize,
    done: Option<Change>,
}

impl Walk {
    /// The variant at a place, if there are so many.
    fn vary(sentence: &Sentence, place: usize) -> Option<(Change, Sentence)> {
        let (mut walk, mut sentence) = (Self { left: place, done: None }, sentence.clone());
        walk.sentence(&mut sentence);
        walk.done.map(|change| (change, sentence))
    }

    fn here(&mut self, change: Change) -> bool {
        let here = self.left == 0 && self.done.is_none();
        self.left = self.left.saturating_sub(1);
        if here {
            self.done = Some(change);
        }
        here
    }

    fn sentence(&mut self, Sentence { given, assume, then }: &mut Sentence) {
        given.iter_mut().for_each(|binder| self.binder(binder));
        self.drop_one(assume);
        assume.iter_mut().for_each(|f| self.formula(f, Some(false)));
        then.iter_mut().for_each(|f| self.formula(f, Some(true)));
    }

    fn drop_one<T>(&mut self, all: &mut Vec<T>) {
        if let Some(at) = (0..all.len()).find(|_| self.here(Change::Dropped)) {
            all.remove(at);
        }
    }

    fn binder(&mut self, binder: &mut Binder) {
        match binder {
            Binder::Degree { least, most } => {
                if *least > 0 && self.here(Change::Shifted) {
                    *least -= 1;
                }
                if let Some(most) = most.as_mut().filter(|_| self.here(Change::Shifted)) {
                    *most += 1;
                }
            }
            Binder::Knots(adjectives) => self.drop_one(adjectives),
            Binder::Gaps(gaps) => {
                for gap in gaps {
                    gap.each.iter_mut().for_each(|each| self.range(each, None));
                    self.real(&mut gap.size, None);
                }
            }
            Binder::Integer(range) => self.range(range, Some(true)),
            Binder::Point(_, interval) => self.interval(interval, Some(true)),
            Binder::Real { sign: Some(sign), .. } if self.here(Change::Turned) => *sign = turned(*sign),
            Binder::Instances(_)
            | Binder::Indices(_)
            | Binder::Index(_)
            | Binder::Real { .. }
            | Binder::Points(_) => {}
        }
    }

    /// `wider`: does the sentence say more if the range is wider?
    fn range(&mut self, Range { from, to, .. }: &mut Range, wider: Positive) {
        self.ends([from, to], wider);
    }

    fn ends(&mut self, [from, to]: [&mut Int; 2], wider: Positive) {
        let way = way(wider);
        self.index(from, way.map(|way| -way));
        self.index(to, way);
    }

    fn interval(&mut self, interval: &mut Interval, wider: Positive) {
        for closed in [&mut interval.from_closed, &mut interval.to_closed] {
            if wider != Some(*closed) && self.here(Change::End) {
                *closed = !*closed;
            }
        }
        let way = way(wider);
        self.real(&mut interval.from, way.map(|way| -way));
        self.real(&mut interval.to, way);
    }

    fn formula(&mut self, f: &mut Formula, positive: Positive) {
        let word =
            matches!(f, Formula::Within(..) | Formula::Among(..) | Formula::Word(_) | Formula::Claim { .. });
        // A hypothesis that is turned says something else, and neither more nor less: it is dropped instead.
        if word && positive != Some(false) && self.here(Change::Turned) {
            *f = Formula::Not(Box::new(f.clone()));
        } else {
            self.inside(f, positive);
        }
    }

    fn inside(&mut self, f: &mut Formula, positive: Positive) {
        let negative = positive.map(|positive| !positive);
        match f {
            Formula::Chain(first, rest) => self.chain(first, rest, positive),
            Formula::Within(x, interval) => {
                if positive != Some(false) {
                    self.real(x, None);
                }
                self.interval(interval, negative);
            }
            Formula::Among(j, from, to) => {
                if positive != Some(false) {
                    self.index(j, None);
                }
                self.ends([from, to], negative);
            }
            Formula::Not(inner) => {
                if positive != Some(false) && self.here(Change::Turned) {
                    *f = (**inner).clone();
                } else {
                    self.inside(inner, negative);
                }
            }
            Formula::And(all) => self.list(all, positive, positive == Some(false)),
            Formula::Or(all) => self.list(all, positive, positive == Some(true)),
            Formula::Implies(premise, then) => {
                if positive != Some(false) && self.here(Change::Dropped) {
                    *f = (**then).clone();
                } else {
                    self.formula(premise, negative);
                    self.formula(then, positive);
                }
            }
            Formula::Iff(a, b) => [a, b].into_iter().for_each(|f| self.formula(f, None)),
            Formula::All(over, body) => {
                self.over(over, positive);
                self.formula(body, positive);
            }
            Formula::Some(over, body) => {
                self.over(over, negative);
                self.formula(body, positive);
            }
            Formula::One(over, body) => {
                self.over(over, None);
                self.formula(body, None);
            }
            Formula::Word(of) => {
                if positive != Some(false) {
                    self.word(of);
                }
            }
            Formula::Instance(_) | Formula::Claim { .. } => {}
        }
    }

    fn list(&mut self, all: &mut Vec<Formula>, positive: Positive, without: bool) {
        if without {
            self.drop_one(all);
        }
        all.iter_mut().for_each(|f| self.formula(f, positive));
    }

    fn chain(&mut self, first: &mut Real, rest: &mut [(Relation, Real)], positive: Positive) {
        for (relation, _) in rest.iter_mut() {
            if positive != Some(false) && self.here(Change::Turned) {
                *relation = turned(*relation);
            }
            let other = other_end(*relation, positive);
            if let Some(other) = other.filter(|_| self.here(Change::End)) {
                *relation = other;
            }
        }
        // ∞ stands next to an index only.
        if rest.iter().any(|(_, t)| *t == Real::Infinity) {
            return;
        }
        let up = |relation: Relation| match relation {
            Relation::Less | Relation::AtMost => way(positive),
            Relation::Greater | Relation::AtLeast => way(positive).map(|way| -way),
            Relation::Equal | Relation::Unequal => None,
        };
        let ways: Vec<Way> = rest.iter().map(|(relation, _)| up(*relation)).collect();
        let terms = std::iter::once(first).chain(rest.iter_mut().map(|(_, t)| t));
        for (at, t) in terms.enumerate() {
            let before = at.checked_sub(1).and_then(|at| ways[at]).map(|way| -way);
            let way = match (before, ways.get(at).copied().flatten()) {
                (Some(a), Some(b)) if a != b => None,
                (a, b) => a.or(b),
            };
            if way.is_some() || positive != Some(false) {
                self.real(t, way);
            }
        }
    }

    fn over(&mut self, over: &mut Over, wider: Positive) {
        match over {
            Over::Integers(range) => self.range(range, wider),
            Over::Reals(_, interval) => self.interval(interval, wider),
        }
    }

    /// Where a factor or a denominator has a sign it is taken for positive: that is true of all that are in the paper's folder.
    fn real(&mut self, t: &mut Real, way: Way) {
        match t {
            Real::Whole(i) => self.index(i, way),
            // Beyond the ends there is nothing.
            Real::Knot(i) if way == Some(-1) && *i == Int::Number(0) || way == Some(1) && *i == Int::M => {}
            Real::Knot(i) => self.index(i, way),
            Real::Index(name) => {
                if &**name == "alpha" && self.here(Change::Exchanged) {
                    *t = conjugate();
                }
            }
            Real::Ratio => {
                if self.here(Change::Exchanged) {
                    *t = Real::Over(Box::new(one()), Box::new(Real::Ratio));
                }
            }
            Real::Coefficient(_, of) | Real::Parameter(_, of) | Real::Defined(_, of) => {
                of.iter_mut().for_each(|i| self.index(i, None))
            }
            Real::Plus(a, b) | Real::Times(a, b) | Real::Least(a, b) | Real::Greatest(a, b) => {
                self.real(a, way);
                self.real(b, way);
            }
            Real::Minus(a, b) | Real::Over(a, b) => {
                self.real(a, way);
                self.real(b, way.map(|way| -way));
            }
            Real::Negated(a) => self.real(a, way.map(|way| -way)),
            Real::Root(a) => self.real(a, way),
            Real::Absolute(a) => self.real(a, None),
            Real::Power(a, e) => {
                self.real(a, way);
                self.index(e, None);
            }
            Real::Fold(_, range, body) => {
                self.range(range, None);
                self.real(body, way);
            }
            Real::Value(function, argument) => {
                let Argument { at, member, .. } = &mut **argument;
                self.function(function);
                self.real(at, None);
                self.member(member);
            }
            Real::Word(of) => self.word(of),
            Real::Number(_) | Real::Bound(_) | Real::Infinity => {}
        }
    }

    #[allow(
        clippy::collapsible_match,
        reason = "to ask is to count, and nothing else is done with the conjugate"
    )]
    fn member(&mut self, member: &mut Option<Member>) {
        match member {
            Some(Member::Index(t)) if *t == conjugate() => {
                if self.here(Change::Exchanged) {
                    *member = None;
                }
            }
            Some(Member::Index(t) | Member::Ratio(t) | Member::Parameter(_, t)) => self.real(t, None),
            Some(Member::Dual) | None => {}
        }
    }

    /// As a whole; a word that counts is left as it is.
    fn index(&mut self, i: &mut Int, way: Way) {
        if !matches!(i, Int::Word(_)) && self.here(Change::Shifted) {
            shift(i, way.unwrap_or(1));
        } else {
            self.int(i);
        }
    }

    fn int(&mut self, i: &mut Int) {
        match i {
            Int::Word(of) => self.word(of),
            Int::Plus(a, b)
            | Int::Minus(a, b)
            | Int::Times(a, b)
            | Int::Least(a, b)
            | Int::Greatest(a, b)
            | Int::Binomial(a, b) => {
                self.int(a);
                self.int(b);
            }
            Int::Number(_) | Int::Bound(_) | Int::Degree | Int::Last | Int::M => {}
        }
    }

    fn function(&mut self, f: &mut Function) {
        match f {
            Function::Basis { i, degree } => {
                self.index(i, None);
                degree.iter_mut().for_each(|degree| self.index(degree, None));
            }
            Function::Weight { i, degree } => [i, degree].into_iter().for_each(|i| self.index(i, None)),
            Function::Phi { from, to, .. } => [from, to].into_iter().for_each(|t| self.real(t, None)),
            Function::Defined(_, of) => of.iter_mut().for_each(|i| self.index(i, None)),
            Function::Derivative(of, order) => {
                self.function(of);
                self.index(order, None);
            }
        }
    }

    fn word(&mut self, of: &mut Use) {
        for item in &mut of.of {
            match item {
                Item::Function(f, member) => {
                    self.function(f);
                    self.member(member);
                }
                Item::Expression(t, _, interval) => {
                    self.real(t, None);
                    interval.iter_mut().for_each(|interval| self.interval(interval, None));
                }
                Item::Real(t) => self.real(t, None),
                Item::Int(i) => self.index(i, None),
                Item::Coefficients(_) => {}
            }
        }
    }
}

fn way(more: Positive) -> Way {
    more.map(|more| if more { 1 } else { -1 })
}

/// With or without equality: the one with which the sentence says more.
fn other_end(relation: Relation, positive: Positive) -> Option<Relation> {
    match relation {
        Relation::AtMost if positive != Some(false) => Some(Relation::Less),
        Relation::AtLeast if positive != Some(false) => Some(Relation::Greater),
        Relation::Less if positive != Some(true) => Some(Relation::AtMost),
        Relation::Greater if positive != Some(true) => Some(Relation::AtLeast),
        _ => None,
    }
}

fn turned(relation: Relation) -> Relation {
    match relation {
        Relation::Equal => Relation::Unequal,
        Relation::Unequal => Relation::Equal,
        Relation::Less => Relation::Greater,
        Relation::AtMost => Relation::AtLeast,
        Relation::Greater => Relation::Less,
        Relation::AtLeast => Relation::AtMost,
    }
}

fn shift(i: &mut Int, by: i64) {
    let (old, one) = (std::mem::replace(i, Int::Degree), Box::new(Int::Number(1)));
    *i = match old {
        Int::Number(n) => Int::Number(n + by),
        Int::Plus(a, b) if by < 0 && *b == *one => *a,
        Int::Minus(a, b) if by > 0 && *b == *one => *a,
        old if by < 0 => Int::Minus(Box::new(old), one),
        old => Int::Plus(Box::new(old), one),
    };
}

fn one() -> Real {
    Real::Whole(Int::Number(1))
}

/// 1 − α.
fn conjugate() -> Real {
    Real::Minus(Box::new(one()), Box::new(Real::Index("alpha".into())))
}

/// A sentence that differs from a true one at one place.
struct Variant {
    claim: Claim<'static>,
    change: Change,
    sentence: Sentence,
    /// Which claim, which word of its sentence, and what stands there instead.
    name: String,
}

/// The first word that differs, by its place, and the words up to the last one.
fn difference(truth: &str, varied: &str) -> String {
    let [old, new] = [truth, varied].map(|text| text.split(' ').collect::<Vec<_>>());
    let start = old.iter().zip(&new).take_while(|(a, b)| a == b).count();
    let (old, new) = (&old[start..], &new[start..]);
    let end = old.iter().rev().zip(new.iter().rev()).take_while(|(a, b)| a == b).count();
    let [old, new] = [old, new].map(|words| words[..words.len() - end].join(" "));
    format!("word {}: {old} → {new}", start + 1)
}

/// What is taken for true: the printed sentence, or if it has a cause the amended one; and what holds where it fails.
fn truths() -> impl Iterator<Item = (Claim<'static>, Form, &'static Sentence)> {
    claims().into_iter().flat_map(|claim| {
        let first = if claim.stanza.cause.is_some() { Form::Amended } else { Form::Printed };
        let said = [first, Form::Fails].map(|form| Some((claim, form, claim.sentence(form)?)));
        said.into_iter().flatten()
    })
}

static VARIANTS: LazyLock<Vec<Variant>> = LazyLock::new(|| {
    let (mut all, mut seen) = (Vec::new(), BTreeSet::new());
    for (claim, form, truth) in truths() {
        let own = source(truth);
        for (change, sentence) in (0..).map_while(|place| Walk::vary(truth, place)) {
            let name = format!("{} {form}, {}", claim.id(), difference(&own, &source(&sentence)));
            if seen.insert(name.clone()) {
                all.push(Variant { claim, change, sentence, name });
            }
        }
    }
    all
});

/// variants.toml.
#[derive(Deserialize)]
struct Exceptions {
    kept: Vec<Kept>,
}

/// Variants that are not refuted.
#[derive(Deserialize)]
struct Kept {
    /// Why: they are true; or what is not decided.
    why: String,
    variants: Vec<String>,
}

static KEPT: LazyLock<BTreeMap<String, String>> = LazyLock::new(|| {
    let Exceptions { kept } = toml::from_str(include_str!("variants.toml")).unwrap();
    let each =
        |Kept { why, variants }| variants.into_iter().map(move |variant| (variant, String::clone(&why)));
    kept.into_iter().flat_map(each).collect()
});

/// Bases of degree 0, which are not among the cases of a run.
static CONSTANTS: LazyLock<Vec<Arc<Case>>> = LazyLock::new(|| {
    let of = |(knots, index): (&[i64], &str)| {
        let knots = KnotVector::new(knots.iter().copied().map(integer).collect()).unwrap();
        let on = Instance::of(Basis::new(knots, 0, index.parse().unwrap()).unwrap());
        Arc::new(Case { on, origin: Origin::Small })
    };
    let knots: [&[i64]; 5] = [&[0, 1], &[0, 0, 1], &[0, 1, 1], &[0, 1, 2], &[0, 1, 1, 2]];
    knots.into_iter().flat_map(|knots| ["-1", "inf"].map(|index| of((knots, index)))).collect()
});

/// Every so many-th of the cases up to a degree.
static CHOICES: LazyLock<[(Cases, usize); 3]> = LazyLock::new(|| {
    [(1, 3), (2, 5), (4, 17)].map(|(degree, every)| (Cases::of_paper(paper()).unwrap().up_to(degree), every))
});
static ALL: LazyLock<Cases> = LazyLock::new(|| Cases::of_paper(paper()).unwrap());

/// On the paper's instances where they are named; else on few cases, and if these do not refute it on more.
fn judged(claim: Claim<'_>, sentence: &Sentence) -> Verdict {
    let on = |cases: &[Arc<Case>]| judge(sentence, claim.into(), cases).unwrap();
    if sentence.given.iter().any(|binder| matches!(binder, Binder::Instances(_))) {
        return on(&ALL.of(sentence, None));
    }
    let knots = sentence.given.iter().any(|binder| matches!(binder, Binder::Knots(_)));
    let constants = CONSTANTS.iter().filter(|case| knots && concerns(sentence, &case.on)).cloned();
    let mut verdict = on(&constants.collect::<Vec<_>>());
    for (cases, every) in CHOICES.iter() {
        if matches!(verdict, Verdict::Refuted(_)) {
            break;
        }
        let cases = cases.of(sentence, None);
        let every = if cases.len() < 10 * every { 1 } else { *every };
        verdict = on(&cases.into_iter().step_by(every).collect::<Vec<_>>());
    }
    verdict
}

#[test]
fn every_variant_that_is_kept_is_one() {
    let names: BTreeSet<_> = VARIANTS.iter().map(|variant| variant.name.as_str()).collect();
    let unknown: Vec<_> = KEPT.keys().filter(|name| !names.contains(name.as_str())).collect();
    assert!(unknown.is_empty(), "{unknown:#?}");
    let prefix = |why: &String| why.starts_with("true") || why.starts_with("open");
    assert!(KEPT.values().all(prefix), "a reason says whether the variant is true or open");
}

/// What became of a variant for the prover, in the degree of its witness.
#[derive(Debug, PartialEq, Eq)]
enum Windows {
    /// It is not refuted, or in a degree beyond those tried here.
    NotTried,
    /// None follow from the sentence.
    None,
    /// There are goals, and one of them has no proof, or the checker rejects it.
    NotProved,
    /// The checker accepts what the engine refutes.
    Proved,
}

/// From what is refuted nothing follows that the checker accepts.
fn proved(claim: Claim<'_>, sentence: &Sentence, witness: &Witness) -> Windows {
    // What is about weights alone stands for degree 1.
    let k @ 0..=3 = witness.k.unwrap_or(1) else { return Windows::NotTried };
    let Ok(statement) = derived(claim, Form::Printed, sentence, &[k]) else { return Windows::None };
    match Certificate::of(statement) {
        Ok(certificate) if certificate.check().is_ok() => Windows::Proved,
        _ => Windows::NotProved,
    }
}

/// None is refuted though it is kept, none is kept without a reason, and what is refuted is not certified: a window that is
/// left out, a case that is not looked at, would show here.
#[test]
fn all_variants_are_refuted_or_kept_with_a_reason() {
    let of = |variant: &Variant| {
        let Variant { claim, sentence, name, change } = variant;
        let verdict = judged(*claim, sentence);
        let windows = match &verdict {
            Verdict::Refuted(witness) => proved(*claim, sentence, witness),
            _ => Windows::NotTried,
        };
        let refuted = matches!(verdict, Verdict::Refuted(_));
        let surprising = refuted == KEPT.contains_key(name) || windows == Windows::Proved;
        (windows, surprising.then(|| format!("{name} ({change:?}): {verdict:?}")))
    };
    let all: Vec<_> = VARIANTS.par_iter().map(of).collect();
    let surprises: Vec<_> = all.iter().filter_map(|(_, surprise)| surprise.as_ref()).collect();
    assert!(surprises.is_empty(), "{surprises:#?}");
    let count = |windows: &Windows| all.iter().filter(|(own, _)| own == windows).count();
    let (none, open) = (count(&Windows::None), count(&Windows::NotProved));
    println!("{none} without windows, {open} with goals that have no proof, of {}", all.len());
    assert!(none > 100 && open > 100, "{none} without windows, {open} with goals that have no proof");
}
