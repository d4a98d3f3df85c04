//! The way through a certificate: every section for every degree, every goal with its rule, nothing left over.

use std::borrow::Cow;
use std::cell::RefCell;
use std::fmt;
use std::rc::Rc;

use crate::derive;
use crate::env::Env;
use crate::error::{Reason, Rejected, Result};
use crate::family::Family;
use crate::obligation::reach;
use crate::point::Numbered;
use crate::rules::Context;
use crate::section::Section;
use crate::sentence::read;
use crate::token::{Node, tree};
use crate::work;

/// So much work is done for one certificate, counted in products of two terms: about ten times what the longest of the
/// program's certificates needs.
pub const WORK: usize = 1_200_000_000;

/// What was proved, all of it.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Checked {
    /// The paper's number of the claim.
    pub claim: String,
    /// `printed`, `amended`, `fails`, `degrees` or `degree K`.
    pub form: String,
    /// `proved` or `refuted`.
    pub verdict: String,
    /// `points`, `instance`, `alpha` or `knots`.
    pub scope: String,
    /// The degrees, rising.
    pub degrees: Vec<usize>,
    /// Sections, derived or expanded.
    pub sections: usize,
    /// Goals proved: at least one for every degree of given sections. What is derived may be true by the order of knots
    /// alone, and what a point refutes has none.
    pub goals: usize,
    /// Lemmas proved.
    pub lemmas: usize,
    /// It holds for any weights whatever.
    pub any_weights: bool,
    /// How the goals come from the sentence: `derived`, none after a `point`, or `argued`, given with a reason.
    pub goals_are: &'static str,
}

impl fmt::Display for Checked {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Checked { claim, form, verdict, scope, degrees, sections, goals, lemmas, any_weights, goals_are } =
            self;
        write!(f, "{claim} ({form}): {verdict}, scope {scope}, degrees")?;
        degrees.iter().try_for_each(|degree| write!(f, " {degree}"))?;
        if *any_weights {
            write!(f, "; for any weights")?;
        }
        write!(f, "; {goals_are}; sections {sections}, goals {goals}, lemmas {lemmas}")
    }
}

/// Checks whether the proof proves the statement.
///
/// # Errors
/// If either text is not what the format describes, or if one goal or lemma is not proved: with the first place where
/// that is so.
pub fn check(statement: &str, proof: &str) -> std::result::Result<Checked, Rejected> {
    check_within(WORK, statement, proof)
}

/// The same with another limit than [`WORK`].
///
/// # Errors
/// As [`check`].
pub fn check_within(work: usize, statement: &str, proof: &str) -> std::result::Result<Checked, Rejected> {
    check_each(work, statement, [proof])?.swap_remove(0)
}

/// Several proofs of one statement, which is read once: each of them with as much work as is left after that.
///
/// # Errors
/// As [`check`], if it is the statement that is rejected.
pub fn check_each<'p>(
    work: usize,
    statement: &str,
    proofs: impl IntoIterator<Item = &'p str>,
) -> std::result::Result<Vec<std::result::Result<Checked, Rejected>>, Rejected> {
    work::begin(work);
    let stated = |reason| Rejected { place: "statement".to_owned(), reason };
    let node = tree(statement).map_err(stated)?;
    let (header, family, body) = header(&node).map_err(stated)?;
    let asked = body.sections(&header.degrees, &family).map_err(stated)?;
    let is_given = matches!(body, Body::Sections(_));
    let left = work::left();
    let check = |proof| {
        work::begin(left);
        let mut place = "proof".to_owned();
        run(header.clone(), &family, &asked, is_given, proof, &mut place)
            .map_err(|reason| Rejected { place, reason })
    };
    Ok(proofs.into_iter().map(check).collect())
}

/// `asked` has the sections of each degree; `place` is where the run has come to.
fn run<'n>(
    mut checked: Checked,
    family: &Rc<Family<'n>>,
    asked: &[Cow<'n, [Node<'n>]>],
    is_given: bool,
    proof: &str,
    place: &mut String,
) -> Result<Checked> {
    let proof = tree(proof)?;
    let [version, proofs @ ..] = proof.fields("proof")? else { return proof.wrong("a version") };
    is_number(version, "format", 1)?;
    let mut proofs = proofs.iter();
    for (degree, sections) in checked.degrees.clone().into_iter().zip(asked) {
        let (before, k) = (checked.goals, as_integer(degree)?);
        for section in &**sections {
            *place = "statement".to_owned();
            let [ranges, declarations, goals] = parts(section)?;
            for env in expanded(ranges, Env::new(family.clone()).with("k", k)?)? {
                checked.sections += 1;
                *place = format!("section {}", checked.sections);
                let proof = proofs.next().ok_or(Reason::Missing("section", checked.sections))?;
                let section = Section::new(declarations, env)?;
                prove(&section, goals, proof, &mut checked, place)?;
            }
        }
        // A sentence may be true by the order of knots alone.
        if checked.goals == before && is_given {
            *place = "statement".to_owned();
            return Err(Reason::NoGoal(degree));
        }
    }
    *place = "proof".to_owned();
    if proofs.next().is_some() { Err(Reason::NoStatement("section")) } else { Ok(checked) }
}

/// What there is to prove.
#[derive(Clone, Copy)]
enum Body<'n> {
    /// Given, with the reason why they are the claim.
    Sections(&'n [Node<'n>]),
    /// Derived from definitions and a sentence.
    Derived(&'n [Node<'n>], &'n Node<'n>),
    /// A point that refutes the sentence: nothing.
    Refuted,
}

impl<'n> Body<'n> {
    /// The sections of each degree.
    fn sections(self, degrees: &[usize], family: &Rc<Family<'n>>) -> Result<Vec<Cow<'n, [Node<'n>]>>> {
        let of = |degree: &usize| match self {
            Body::Refuted => Ok(Cow::Owned(Vec::new())),
            Body::Sections(given) => Ok(Cow::Borrowed(given)),
            Body::Derived(definitions, sentence) => {
                derive::sections(family, definitions, sentence, as_integer(*degree)?).map(Cow::Owned)
            }
        };
        degrees.iter().map(of).collect()
    }
}

/// What a statement says of itself, and what there is to prove.
fn header<'n>(node: &'n Node<'n>) -> Result<(Checked, Rc<Family<'n>>, Body<'n>)> {
    let [version, claim, form, verdict, scope, degrees, family, rest @ ..] = node.fields("statement")? else {
        return node.wrong("the parts of a statement");
    };
    is_number(version, "format", 2)?;
    let (claim, form) = (claim.part::<1>("claim")?, form.part::<1>("form")?);
    let (verdict, scope) = (verdict.part::<1>("verdict")?, scope.part::<1>("scope")?);
    let ([claim], [form], [verdict], [scope]) = (claim, form, verdict, scope);
    let list = degrees.some("degrees")?.iter().map(Node::degree).collect::<Result<Vec<_>>>()?;
    if !list.is_sorted_by(|a, b| a < b) {
        return degrees.wrong("rising degrees");
    }
    let family = Family::read(family)?;
    (1..=list.iter().max().map_or(0, |most| i64::from(*most))).try_for_each(|d| family.check(d))?;
    let family = Rc::new(family);
    let (definitions, rest) = rest.split_at(rest.iter().take_while(|part| part.is("define")).count());
    let Some((sentence, rest)) = rest.split_first() else { return node.wrong("a sentence") };
    read(&family, definitions, sentence)?;
    let body = match rest {
        [] if verdict.is_word("proved") && scope.is_word(reach(sentence)?) => {
            Body::Derived(definitions, sentence)
        }
        [] => return node.wrong("proved, and the scope of the sentence: alpha of examples, otherwise knots"),
        points if points.iter().all(|point| point.is("point")) => {
            if !verdict.is_word("refuted") || !scope.is_word("instance") {
                return node.wrong("refuted, scope instance, for a point");
            }
            let numbers =
                points.iter().map(|point| Numbered::new(&family, point)).collect::<Result<Vec<_>>>()?;
            if list.iter().map(|degree| i64::from(*degree)).ne(numbers.iter().map(Numbered::degree)) {
                return degrees.wrong("the degree of the point");
            }
            numbers.iter().try_for_each(|point| point.refutes(&family, definitions, sentence))?;
            Body::Refuted
        }
        [because, sections @ ..] => {
            let [because] = because.part("because")?;
            because.text()?;
            // Those that no degree reads are looked at here.
            sections.iter().try_for_each(|section| parts(section).map(|_| ()))?;
            Body::Sections(sections)
        }
    };
    let form = match form.part("degree") {
        Ok([degree]) if list == [degree.degree()?] => format!("degree {}", degree.degree()?),
        Ok(_) => return form.wrong("the only degree of the statement"),
        Err(_) => {
            let known = ["printed", "amended", "fails", "degrees"];
            form.word(&known, "printed, amended, fails, degrees or (degree K)")?.to_owned()
        }
    };
    let checked = Checked {
        claim: claim.claim()?.to_owned(),
        form,
        verdict: verdict.word(&["proved", "refuted"], "proved or refuted")?.to_owned(),
        scope: scope.word(&["points", "instance", "alpha", "knots"], "a scope")?.to_owned(),
        degrees: list.iter().copied().map(usize::from).collect(),
        sections: 0,
        goals: 0,
        lemmas: 0,
        any_weights: family.is_any(),
        goals_are: match body {
            Body::Derived(..) => "derived",
            Body::Refuted => "point",
            Body::Sections(_) => "argued",
        },
    };
    Ok((checked, family, body))
}

/// The ranges of a section, its declarations, and its goals.
fn parts<'n, 't>(section: &'n Node<'t>) -> Result<[&'n [Node<'t>]; 3]> {
    let all = section.fields("section")?;
    let (ranges, rest) = all.split_at(all.iter().take_while(|part| part.is("each")).count());
    let Some((goals, declarations)) = rest.split_last() else { return section.wrong("goals") };
    Ok([ranges, declarations, goals.some("goals")?])
}

/// The integers of a section, once for every choice that its ranges leave, the last one fastest.
fn expanded<'t>(ranges: &[Node<'t>], env: Env<'t>) -> Result<Vec<Env<'t>>> {
    let mut all = vec![env];
    for range in ranges {
        let [name, low, high] = range.part("each")?;
        all = all.iter().map(|env| env.each(name, low, high)).collect::<Result<Vec<_>>>()?.concat();
    }
    Ok(all)
}

/// Everything about one expanded section.
fn prove<'t>(
    section: &Section<'t>,
    goals: &[Node<'t>],
    proof: &Node<'t>,
    checked: &mut Checked,
    place: &mut String,
) -> Result<()> {
    let here = place.clone();
    let [label, steps @ ..] = proof.fields("section")? else { return proof.wrong("a number") };
    is_number(label, "section", checked.sections)?;
    let (lemmas, proofs) = steps.split_at(steps.iter().take_while(|step| step.is("lemma")).count());
    let mut context = Context { section, lemmas: Vec::new(), kept: RefCell::default() };
    let mut step = |what, number, label, rule: &Node<'t>| {
        *place = format!("{here}, {what} {number}, rule {}", rule.headed("a rule")?.0);
        is_number(label, what, number)
    };
    for (number, lemma) in (1..).zip(lemmas) {
        let [label, formula, rule] = lemma.part("lemma")?;
        step("lemma", number, label, rule)?;
        context.prove(formula, &section.env, rule)?;
        context.lemmas.push(formula);
        checked.lemmas += 1;
    }
    let goals = section.env.expand(goals)?;
    for (number, (formula, env)) in (1..).zip(&goals) {
        let [label, rule] = proofs.get(number - 1).ok_or(Reason::Missing("goal", number))?.part("goal")?;
        step("goal", number, label, rule)?;
        context.prove(formula, env, rule)?;
        checked.goals += 1;
    }
    *place = here;
    match proofs.get(goals.len()) {
        None => Ok(()),
        Some(proof) => proof.fields("goal").and(Err(Reason::NoStatement("goal"))),
    }
}

fn as_integer(degree: usize) -> Result<i64> {
    i64::try_from(degree).map_err(|_| Reason::Limits("a degree"))
}

/// Whether something has the number that it must have.
fn is_number(label: &Node<'_>, what: &'static str, number: usize) -> Result<()> {
    let found = usize::try_from(label.whole()?);
    if found == Ok(number) { Ok(()) } else { Err(Reason::Missing(what, number)) }
}
