//! The prover: finds a rule for every goal of a statement.
//!
//! It decides by its own arithmetic (the triangle over [`Quotient`]) and leaves the last word to the checker.

use std::cell::RefCell;
use std::rc::Rc;

use num_traits::Signed;
use rayon::prelude::*;
use thiserror::Error;

use crate::analysis::in_span;
use crate::scalar::{BigRational, Multivariate, Quotient, Ring, integer};

use super::error::EvaluationError;
use super::error::StatementError;
use super::evaluate::{Evaluator, Unfolding, sign};
use super::proof::{Lemma, Rule, SectionProof};
use super::statement::{Gap, Hint, Section, Statement};
use super::term::{Formula, OfWeight, Place, Term};
use super::weights::{Class, Weighted};

/// Why a statement could not be proved.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum ProofError {
    /// It makes no sense.
    #[error(transparent)]
    Statement(#[from] StatementError),
    /// A goal for which no rule was found: it may be false. Number 0 stands for the lemmas.
    #[error("section {section}, goal {goal}: {reason}")]
    Goal {
        /// Which section, as numbered after unrolling.
        section: usize,
        /// Which goal in it.
        goal: usize,
        /// What went wrong.
        reason: GoalError,
    },
}

/// Why one goal could not be proved.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum GoalError {
    /// It has no value.
    #[error(transparent)]
    Evaluation(#[from] EvaluationError),
    /// It is false at a point of the range of its parameters.
    #[error("it is false")]
    False,
    /// No rule shows it.
    #[error("no rule was found for it within the limits")]
    NoRule,
}

/// Finds a proof.
///
/// # Errors
/// [`ProofError`]: the first goal that resists.
pub fn prove(statement: &Statement) -> Result<Vec<SectionProof>, ProofError> {
    prove_sections(&statement.expand()?, &statement.weighted)
}

/// The same for sections.
pub(super) fn prove_sections(
    sections: &[Section],
    weighted: &Weighted,
) -> Result<Vec<SectionProof>, ProofError> {
    let numbered: Vec<_> = (1..).zip(sections).collect();
    let proofs: Vec<_> =
        numbered.par_iter().map(|(number, section)| of_section(*number, section, weighted)).collect();
    proofs.into_iter().collect()
}

/// A section, and the weights in it.
struct Subject<'a> {
    section: &'a Section,
    weighted: &'a Weighted,
    /// Goals of a section name the same functions.
    evaluators: RefCell<Vec<(Unfolding, Rc<Evaluator<'a>>)>>,
}

/// An evaluator with more variables than this is left alone: the next goal's own have to fit too.
const SHARED: usize = 32;

impl<'a> Subject<'a> {
    fn evaluator(&self, unfolding: Unfolding) -> Result<Rc<Evaluator<'a>>, EvaluationError> {
        let mut evaluators = self.evaluators.borrow_mut();
        if let Some((_, known)) =
            evaluators.iter().find(|(known, own)| *known == unfolding && own.size() <= SHARED)
        {
            return Ok(Rc::clone(known));
        }
        let evaluator = Rc::new(Evaluator::new(self.section, self.weighted, unfolding)?);
        evaluators.retain(|(known, _)| *known != unfolding);
        evaluators.push((unfolding, Rc::clone(&evaluator)));
        Ok(evaluator)
    }
}

fn of_section(number: usize, section: &Section, weighted: &Weighted) -> Result<SectionProof, ProofError> {
    let failed = |goal, reason| ProofError::Goal { section: number, goal, reason };
    let subject = &Subject { section, weighted, evaluators: RefCell::default() };
    let lemmas = lemmas(subject).map_err(|reason| failed(0, reason))?;
    let rule = |(goal, formula): (usize, &Formula)| {
        let hinted = section.hints.iter().find(|hint| hint.formula == *formula);
        let rule = match hinted {
            Some(hint) => by_hint(subject, hint, &lemmas),
            None => rule_for(subject, formula),
        };
        rule.map_err(|reason| failed(goal, reason))
    };
    let goals: Result<Vec<_>, _> = (1..).zip(&section.goals).map(rule).collect();
    let lemmas = lemmas.into_iter().map(|(_, lemma)| lemma).collect();
    Ok(SectionProof { lemmas, goals: goals? })
}

/// The lemmas that hints tell of, each proved from those before it.
fn lemmas(subject: &Subject<'_>) -> Result<Vec<(Formula, Lemma)>, GoalError> {
    let mut proved = Vec::new();
    let Subject { section, .. } = subject;
    for hint in section.hints.iter().filter(|hint| !section.goals.contains(&hint.formula)) {
        let rule = by_hint(subject, hint, &proved)?;
        proved.push((hint.formula.clone(), Lemma { formula: hint.text.clone(), rule }));
    }
    Ok(proved)
}

/// An equation by other equations: left − right is the sum of theirs, each with its factor.
fn by_hint(subject: &Subject<'_>, hint: &Hint, lemmas: &[(Formula, Lemma)]) -> Result<Rule, GoalError> {
    if hint.using.is_empty() {
        return rule_for(subject, &hint.formula);
    }
    let unfolding = Unfolding { weights_from: Some(1), functions_to: Some(hint.functions), related: true };
    let evaluator = subject.evaluator(unfolding)?;
    let difference = |formula: &Formula| match formula {
        Formula::Equal(left, right) => Ok(evaluator.term(left)?.minus(&evaluator.term(right)?)),
        _ => Err(GoalError::NoRule),
    };
    let mut rest = difference(&hint.formula)?;
    let mut using = Vec::new();
    for (lemma, text, factor) in &hint.using {
        let at = lemmas.iter().position(|(known, _)| known == lemma).ok_or(GoalError::NoRule)?;
        rest = rest.minus(&evaluator.term(factor)?.times(&difference(lemma)?));
        using.push((at + 1, text.clone()));
    }
    if rest.is_zero() {
        Ok(Rule::By { weights: Some(1), functions: Some(hint.functions), using })
    } else {
        Err(GoalError::False)
    }
}

/// The degrees from which on weights are left alone, the cheapest way first; at last none. Where u is something else on knots
/// that are numbers, p and q of a weight have factors in common that the checker keeps: all is unfolded.
fn ways(section: &Section, sides: [&Term; 2]) -> impl Iterator<Item = Option<usize>> {
    const HIGHEST: usize = 8;
    let is_number = |gap: &Gap| matches!(gap, Gap::Term(Term::Number(_)));
    let numbers = section.windows.iter().all(|window| window.gaps.iter().all(is_number));
    let highest = if numbers && sides.iter().any(|side| side.moves_u()) { 0 } else { HIGHEST };
    (1..=highest).map(Some).chain([None])
}

fn rule_for(subject: &Subject<'_>, formula: &Formula) -> Result<Rule, GoalError> {
    match formula {
        Formula::Equal(left, right) => {
            for weights in ways(subject.section, [left, right]) {
                let unfolding = Unfolding { weights_from: weights, functions_to: None, related: true };
                let evaluator = subject.evaluator(unfolding)?;
                if sides(&evaluator, left, right)?.is_some_and(|[left, right]| left == right) {
                    return Ok(by(weights));
                }
            }
            Err(GoalError::False)
        }
        Formula::Greater(large, small) => compare(subject, large, small, Class::Positive),
        Formula::AtLeast(large, small) => compare(subject, large, small, Class::Nonnegative),
        Formula::Defined(term) => {
            let unfolding = Unfolding { weights_from: Some(1), ..Unfolding::default() };
            subject.evaluator(unfolding)?.term(term)?;
            Ok(by(Some(1)))
        }
        Formula::Order { i, degree, place, order } => {
            let evaluator = subject.evaluator(Unfolding::default())?;
            let found = evaluator.order(*i, *degree, place)?;
            if found == Some(*order) { Ok(Rule::Orders) } else { Err(GoalError::False) }
        }
        Formula::Outside(_, term, others) => functional(subject, term, others),
        Formula::Pole(_, functions, u) => pole(subject, functions, u),
    }
}

/// Both sides; `None` if they have higher derivatives of what is an unknown: those are for expanded weights.
fn sides(
    evaluator: &Evaluator<'_>,
    left: &Term,
    right: &Term,
) -> Result<Option<[Quotient; 2]>, EvaluationError> {
    match (evaluator.term(left), evaluator.term(right)) {
        (Err(EvaluationError::Order), _) | (_, Err(EvaluationError::Order)) => Ok(None),
        (left, right) => Ok(Some([left?, right?])),
    }
}

fn by(weights: Option<usize>) -> Rule {
    Rule::By { weights, functions: None, using: Vec::new() }
}

fn enough(found: Class, wanted: Class) -> bool {
    found >= wanted
}

/// large > small, or ≥.
fn compare(subject: &Subject<'_>, large: &Term, small: &Term, wanted: Class) -> Result<Rule, GoalError> {
    for weights in ways(subject.section, [large, small]) {
        let unfolding = Unfolding { weights_from: weights, ..Unfolding::default() };
        let evaluator = subject.evaluator(unfolding)?;
        let Some([large, small]) = sides(&evaluator, large, small)? else { continue };
        let difference = large.minus(&small);
        if enough(evaluator.class_of(&difference), wanted) {
            return Ok(by(weights));
        }
        if weights.is_none() {
            let classes = evaluator.classes();
            let parameters = evaluator.parameters();
            let names: Vec<_> = parameters
                .iter()
                .filter_map(|(name, _)| Some((name.as_str(), evaluator.variable_of(name)?)))
                .filter(|(_, at)| difference.numerator().degree_in(*at) > 0)
                .collect();
            return Splitting { names, wanted }.rule(difference.numerator(), &classes, 0);
        }
    }
    Err(GoalError::NoRule)
}

/// The search for splits.
struct Splitting<'a> {
    /// The parameters that occur, with the numbers of their variables.
    names: Vec<(&'a str, usize)>,
    wanted: Class,
}

/// How often a range is halved.
const DEPTH: usize = 24;

impl Splitting<'_> {
    fn rule(&self, p: &Multivariate, classes: &[Class], depth: usize) -> Result<Rule, GoalError> {
        if enough(sign(p, classes), self.wanted) {
            return Ok(by(None));
        }
        // All parameters 1: a point of every range.
        let sample: num_bigint::BigInt = p.terms().map(|(_, coefficient)| coefficient).sum();
        let falsified =
            if self.wanted == Class::Positive { !sample.is_positive() } else { sample.is_negative() };
        if falsified {
            return Err(GoalError::False);
        }
        let usable: Vec<_> = self.names.iter().filter(|(_, at)| classes[*at] != Class::Real).collect();
        if depth == DEPTH || usable.is_empty() {
            return Err(GoalError::NoRule);
        }
        let (name, at) = *usable[depth % usable.len()];
        let below = self.rule(&halved(p, at), classes, depth + 1)?;
        let mut closed = classes.to_vec();
        closed[at] = Class::Nonnegative;
        let above = self.rule(&shifted(p, at), &closed, depth + 1)?;
        let (below, above) = (Box::new(below), Box::new(above));
        Ok(Rule::Split { parameter: name.to_owned(), at: integer(1), below, above })
    }
}

/// p with the variable v replaced by v/(1 + v), times the power of 1 + v that clears it.
fn halved(p: &Multivariate, variable: usize) -> Multivariate {
    let (v, one) = (Multivariate::variable(variable), Multivariate::constant(1));
    let below = v.plus(&one);
    let coefficients = p.coefficients_in(variable);
    let degree = coefficients.len().saturating_sub(1);
    let summand = |(e, c): (usize, &Multivariate)| c.times(&v.power(e)).times(&below.power(degree - e));
    let summands = coefficients.iter().enumerate().map(summand);
    summands.fold(p.zero(), |sum, summand| sum.plus(&summand))
}

/// p with the variable v replaced by 1 + v.
fn shifted(p: &Multivariate, variable: usize) -> Multivariate {
    p.substitute(variable, &Multivariate::variable(variable).plus(&Multivariate::constant(1)))
}

/// A functional Σ c·f(u) that is 0 on the others and not on the term.
fn functional(subject: &Subject<'_>, term: &Term, others: &[Term]) -> Result<Rule, GoalError> {
    let evaluator = subject.evaluator(Unfolding::default())?;
    let u = evaluator.variable_of("u").ok_or(GoalError::NoRule)?;
    let at = |f: &Quotient, point: &BigRational| {
        f.evaluate(point, |v| if v == u { point.clone() } else { integer(1) }).ok_or(GoalError::NoRule)
    };
    let f = evaluator.term(term)?;
    let others: Vec<Quotient> = others.iter().map(|other| evaluator.term(other)).collect::<Result<_, _>>()?;
    let points: Vec<BigRational> = (1..=others.len() + 1).map(integer).collect();
    let column = |f: &Quotient| -> Result<Vec<BigRational>, GoalError> {
        points.iter().map(|point| at(f, point)).collect()
    };
    let rows: Vec<_> = others.iter().map(column).collect::<Result<_, _>>()?;
    let columns: Vec<Vec<BigRational>> =
        (0..points.len()).map(|j| rows.iter().map(|row| row[j].clone()).collect()).collect();
    let values = column(&f)?;
    // A column that depends on those before it gives a functional that vanishes on all rows.
    for j in 0..points.len() {
        let Some(mut c) = in_span(&columns[..j], &columns[j]) else { continue };
        c.push(-integer(1));
        let value: BigRational = c.iter().zip(&values).map(|(c, value)| c * value).sum();
        if value != integer(0) {
            let terms = c.into_iter().zip(points).filter(|(c, _)| *c != integer(0)).collect();
            return Ok(Rule::Functional(terms));
        }
    }
    Err(GoalError::False)
}

/// Does one of the functions have a pole at u?
fn pole(subject: &Subject<'_>, functions: &[Term], at: &BigRational) -> Result<Rule, GoalError> {
    let evaluator = subject.evaluator(Unfolding::default())?;
    let u = evaluator.variable_of("u").ok_or(GoalError::NoRule)?;
    for function in functions {
        let function = evaluator.term(function)?;
        let value = |p: &Multivariate| p.evaluate(at, |v| if v == u { at.clone() } else { integer(1) });
        if value(&function.denominator()) == integer(0) && value(function.numerator()) != integer(0) {
            return Ok(Rule::Evaluate);
        }
    }
    Err(GoalError::False)
}

impl Evaluator<'_> {
    /// The order of G_i^d for u → 0, `None` if it is 0 or cannot be told; by the recursion with min and +.
    fn order(&self, i: i64, d: usize, place: &Place) -> Result<Option<usize>, EvaluationError> {
        let below = i64::try_from(d).unwrap_or(i64::MAX);
        if i > place.span || i + below < place.span {
            return Ok(None);
        }
        if d == 0 {
            return Ok(Some(0));
        }
        let u = self.variable_of("u").unwrap_or_default();
        let lowest = |value: &Quotient| {
            let coefficients = value.numerator().coefficients_in(u);
            let at = coefficients.iter().position(|c| !c.is_zero())?;
            (sign(&coefficients[at], &self.classes()) == Class::Positive).then_some(at)
        };
        let mut orders = Vec::new();
        for (of, i) in [(OfWeight::Weight, i), (OfWeight::Complement, i + 1)] {
            if let Some(function) = self.order(i, d - 1, place)? {
                let weight = self.term(&Term::Weight(of, i, d, place.clone()))?;
                let Some(order) = lowest(&weight) else { return Ok(None) };
                orders.push(function + order);
            }
        }
        Ok(orders.into_iter().min())
    }
}
