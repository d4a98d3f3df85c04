//! The way through a certificate: every section for every degree, every goal with its rule, nothing left over.

use std::fmt;

use crate::error::{Place, Reason, Rejected, Step};
use crate::grammar;
use crate::integer::{Int, Scope};
use crate::rules::Context;
use crate::section::Section;
use crate::syntax::{Formula, Rule, SectionProof, SectionText, Statement};
use crate::token;

/// More expanded sections, and more goals in one of them, are not checked.
const LARGEST: usize = 100_000;

/// What was proved, all of it.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Checked {
    /// The paper's number of the claim.
    pub claim: String,
    /// `printed`, `amended` or `degree K`.
    pub form: String,
    /// `proved` or `refuted`.
    pub verdict: String,
    /// `points`, `instance`, `alpha` or `knots`.
    pub scope: String,
    /// The degrees, rising.
    pub degrees: Vec<usize>,
    /// Expanded sections.
    pub sections: usize,
    /// Goals proved, at least one for every degree.
    pub goals: usize,
    /// Lemmas proved.
    pub lemmas: usize,
}

impl fmt::Display for Checked {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Checked { claim, form, verdict, scope, degrees, sections, goals, lemmas } = self;
        write!(f, "{claim} ({form}): {verdict}, scope {scope}, degrees")?;
        degrees.iter().try_for_each(|degree| write!(f, " {degree}"))?;
        write!(f, "; sections {sections}, goals {goals}, lemmas {lemmas}")
    }
}

/// The text of a statement with white space in one way only: two statements with the same canonical text are the
/// same statement. Nothing is expanded or proved.
///
/// # Errors
/// If the text is no statement.
pub fn canonical(statement: &str) -> Result<String, Rejected> {
    read_statement(statement)?;
    token::canonical(statement).map_err(|reason| Rejected { place: Place::Statement, reason })
}

/// Checks whether the proof proves the statement.
///
/// # Errors
/// If either text is not what the format describes, or if one goal or lemma is not proved: with the first place where
/// that is so.
pub fn check(statement: &str, proof: &str) -> Result<Checked, Rejected> {
    let statement = read_statement(statement)?;
    let sections = token::tree(proof)
        .and_then(|tree| grammar::proof(&tree))
        .map_err(|reason| Rejected { place: Place::Proof, reason })?;
    let mut run = Run { proofs: sections.iter(), sections: 0, goals: 0, lemmas: 0 };
    for &degree in &statement.degrees {
        let before = run.goals;
        let mut scope = Scope::default();
        scope.push_degree(degree).map_err(|reason| Rejected { place: Place::Statement, reason })?;
        for section in &statement.sections {
            run.ranges(section, &section.ranges, &mut scope)?;
        }
        if run.goals == before {
            return Err(Rejected { place: Place::Statement, reason: Reason::NoGoal(degree) });
        }
    }
    if run.proofs.next().is_some() {
        return Err(Rejected { place: Place::Proof, reason: Reason::TooMany("section") });
    }
    let Run { sections, goals, lemmas, .. } = run;
    let Statement { claim, form, verdict, scope, degrees, .. } = statement;
    Ok(Checked { claim, form, verdict, scope, degrees, sections, goals, lemmas })
}

fn read_statement(text: &str) -> Result<Statement, Rejected> {
    let read = token::tree(text).and_then(|tree| grammar::statement(&tree));
    read.map_err(|reason| Rejected { place: Place::Statement, reason })
}

/// What is left of the proof, and what has been done.
struct Run<'a> {
    proofs: std::slice::Iter<'a, SectionProof>,
    sections: usize,
    goals: usize,
    lemmas: usize,
}

impl Run<'_> {
    /// The section once for every value of its ranges, the last one fastest.
    fn ranges(
        &mut self,
        text: &SectionText,
        ranges: &[(String, Int, Int)],
        scope: &mut Scope,
    ) -> Result<(), Rejected> {
        let Some(((name, low, high), rest)) = ranges.split_first() else {
            return self.section(text, scope.clone());
        };
        let place = Place::Section(self.sections + 1, None, None);
        let at = |reason| Rejected { place: place.clone(), reason };
        let (low, high) = (scope.value(low).map_err(at)?, scope.value(high).map_err(at)?);
        for value in low..=high {
            scope.step().and_then(|()| scope.push(name, value)).map_err(at)?;
            self.ranges(text, rest, scope)?;
            scope.pop();
        }
        Ok(())
    }

    fn section(&mut self, text: &SectionText, scope: Scope) -> Result<(), Rejected> {
        self.sections += 1;
        let number = self.sections;
        let at = |step, rule| move |reason| Rejected { place: Place::Section(number, step, rule), reason };
        if number > LARGEST {
            return Err(at(None, None)(Reason::TooLarge("the number of sections")));
        }
        let proof = self.proofs.next().ok_or(Reason::Missing("a section")).map_err(at(None, None))?;
        expect("section", proof.number, number).map_err(at(None, None))?;
        let section = Section::new(text, scope).map_err(at(None, None))?;
        let values = section.values().map_err(at(None, None))?;
        let mut lemmas: Vec<(i64, &Formula)> = Vec::new();
        let prove = |lemmas: &[_], formula: &Formula, scope: &mut Scope, step, rule: &Rule| {
            let context = Context { section: &section, values: &values, lemmas };
            context.prove(formula, scope, rule).map_err(at(Some(step), Some(rule.name())))
        };
        for (position, (label, formula, rule)) in (1..).zip(&proof.lemmas) {
            expect("lemma", *label, position).map_err(at(None, None))?;
            prove(&lemmas, formula, &mut section.scope.clone(), Step::Lemma(position), rule)?;
            lemmas.push((*label, formula));
            self.lemmas += 1;
        }
        let mut goals = Vec::new();
        let collected = section.scope.clone().expand(&text.goals, &mut |formula, scope| {
            goals.push((formula, scope.clone()));
            if goals.len() > LARGEST { Err(Reason::TooLarge("the number of goals")) } else { Ok(()) }
        });
        collected.map_err(at(None, None))?;
        let mut proofs = proof.goals.iter();
        for (position, (formula, mut scope)) in (1..).zip(goals) {
            let step = Some(Step::Goal(position));
            let (label, rule) = proofs.next().ok_or(Reason::Missing("a goal")).map_err(at(step, None))?;
            expect("goal", *label, position).map_err(at(step, None))?;
            prove(&lemmas, formula, &mut scope, Step::Goal(position), rule)?;
            self.goals += 1;
        }
        if proofs.next().is_some() { Err(at(None, None)(Reason::TooMany("goal"))) } else { Ok(()) }
    }
}

fn expect(what: &'static str, found: i64, expected: usize) -> Result<(), Reason> {
    if usize::try_from(found) == Ok(expected) {
        Ok(())
    } else {
        Err(Reason::Number { what, found, expected })
    }
}
