//! Statements: what a certificate proves (`proofs/FORMAT.md`, "Statements").

use std::fmt;

use num_traits::Signed;

use crate::claims::Scope;
use crate::scalar::BigRational;

use super::error::StatementError;
use super::expansion::{Integers, Range};
use super::sexp::Sexp;
use super::term::{self, Formula, Term};

/// Which statement of a claim.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Form {
    /// As the paper prints it.
    Printed,
    /// As amended.
    Amended,
    /// For one degree only.
    Degree(usize),
}

impl Form {
    /// The name in those of certificates and windows: `printed`, `amended`, `degree-3`.
    #[must_use]
    pub fn name(self) -> String {
        self.to_string().replace(' ', "-")
    }
}

impl fmt::Display for Form {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Printed => f.write_str("printed"),
            Self::Amended => f.write_str("amended"),
            Self::Degree(k) => write!(f, "degree {k}"),
        }
    }
}

/// A statement about a claim.
#[derive(Debug, Clone, PartialEq)]
pub struct Statement {
    /// The claim.
    pub claim: String,
    /// Which of its statements.
    pub form: Form,
    /// That it is false, rather than true.
    pub refuted: bool,
    /// How far it reaches.
    pub scope: Scope,
    /// The degrees, rising.
    pub degrees: Vec<usize>,
    /// The claim in words.
    pub text: String,
    /// Why the goals are the claim, or refute it.
    pub because: String,
    /// The sections, not yet unrolled.
    pub sections: Vec<Sexp>,
}

/// The sign of a parameter.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Class {
    /// Any real number.
    Real,
    /// ≥ 0.
    Nonnegative,
    /// > 0.
    Positive,
}

/// A gap between two knots.
#[derive(Debug, Clone, PartialEq)]
pub enum Gap {
    /// A parameter of its own.
    Parameter(Class),
    /// Given by a term.
    Term(Term),
}

/// A window on a knot vector.
#[derive(Debug, Clone, PartialEq)]
pub struct Window {
    /// Its name.
    pub name: String,
    /// The index of its first knot.
    pub first: i64,
    /// The gaps between its knots.
    pub gaps: Vec<Gap>,
}

/// A way to prove an equation: some functions stay unknowns, and equations proved before are used.
#[derive(Debug, Clone, PartialEq)]
pub struct Hint {
    /// What to prove: a lemma, or one of the goals.
    pub formula: Formula,
    /// The same as text.
    pub text: Sexp,
    /// Functions up to this degree are unknowns.
    pub functions: usize,
    /// Lemmas of the section with their factors, as text and as terms.
    pub using: Vec<(Formula, Sexp, Term)>,
}

/// One section for certain values of its integers.
#[derive(Debug, Clone, PartialEq)]
pub struct Section {
    /// The parameters with their signs, but for those of gaps.
    pub parameters: Vec<(String, Class)>,
    /// The abbreviations.
    pub lets: Vec<(String, Term)>,
    /// The windows.
    pub windows: Vec<Window>,
    /// The goals.
    pub goals: Vec<Formula>,
    /// Lemmas that the prover is told of: these are no part of the statement.
    pub hints: Vec<Hint>,
}

impl Statement {
    /// As an item of the language.
    #[must_use]
    pub fn to_sexp(&self) -> Sexp {
        let degree = |k: usize| Sexp::Number(BigRational::from_integer(k.into()));
        let form = match self.form {
            Form::Printed => Sexp::name("printed"),
            Form::Amended => Sexp::name("amended"),
            Form::Degree(k) => Sexp::form("degree", [degree(k)]),
        };
        let parts = [
            Sexp::form("claim", [Sexp::Text(self.claim.clone())]),
            Sexp::form("form", [form]),
            Sexp::form("verdict", [Sexp::name(if self.refuted { "refuted" } else { "proved" })]),
            Sexp::form("scope", [Sexp::name(self.scope.name())]),
            Sexp::form("degrees", self.degrees.iter().map(|k| degree(*k))),
            Sexp::form("text", [Sexp::Text(self.text.clone())]),
            Sexp::form("because", [Sexp::Text(self.because.clone())]),
        ];
        let parts = parts.into_iter().chain(self.sections.iter().map(without_hints));
        Sexp::form("statement", std::iter::once(Sexp::int(1)).chain(parts))
    }

    /// All sections, in the order in which a proof numbers them.
    ///
    /// # Errors
    /// [`StatementError`], if the text of a section makes no sense.
    pub fn expand(&self) -> Result<Vec<Section>, StatementError> {
        let mut all = Vec::new();
        for &k in &self.degrees {
            let before = all.len();
            let degree = i64::try_from(k).map_err(|_| StatementError::Integer(k.to_string()))?;
            for section in &self.sections {
                let Some(("section", parts)) = section.as_form() else {
                    return Err(StatementError::Form(section.to_string()));
                };
                expand(parts, &Integers::default().with("k", degree), &mut all)?;
            }
            if all[before..].iter().all(|section| section.goals.is_empty()) {
                return Err(StatementError::NoGoal(k));
            }
        }
        Ok(all)
    }
}

/// The section as it stands in a certificate.
fn without_hints(section: &Sexp) -> Sexp {
    match section {
        Sexp::List(parts) => {
            let is_hint = |part: &&Sexp| part.as_form().is_some_and(|(head, _)| head == HINTS);
            Sexp::List(parts.iter().filter(|part| !is_hint(part)).cloned().collect())
        }
        other => other.clone(),
    }
}

/// The part of a section that is for the prover only:
/// `(hints (prove FORMULA (functions INT) (using (FORMULA TERM)…))…)`, with `each` as in goals.
const HINTS: &str = "hints";

fn expand(parts: &[Sexp], ints: &Integers, all: &mut Vec<Section>) -> Result<(), StatementError> {
    if let Some((first, rest)) = parts.split_first()
        && let Some(("each", range)) = first.as_form()
    {
        let unknown = || StatementError::Form(first.to_string());
        let Range { name, mut values, items: [] } = ints.range(range)?.ok_or_else(unknown)? else {
            return Err(unknown());
        };
        return values.try_for_each(|value| expand(rest, &ints.with(name, value), all));
    }
    let (parameters, lets) = (vec![("u".into(), Class::Positive), ("r".into(), Class::Positive)], Vec::new());
    let (windows, goals, hints) = (Vec::new(), Vec::new(), Vec::new());
    let mut section = Section { parameters, lets, windows, goals, hints };
    for part in parts {
        let unknown = || StatementError::Form(part.to_string());
        let (head, items) = part.as_form().ok_or_else(unknown)?;
        match (head, items) {
            ("real", items) => section.declare(Class::Real, items, ints)?,
            ("nonnegative", items) => section.declare(Class::Nonnegative, items, ints)?,
            ("positive", items) => section.declare(Class::Positive, items, ints)?,
            ("let", [Sexp::Name(name), value]) => {
                section.lets.push((name.clone(), term::term(value, ints)?));
            }
            ("window", [Sexp::Name(name), first, gaps @ ..]) => {
                let gaps = ints.items(gaps, &gap)?;
                section.windows.push(Window { name: name.clone(), first: ints.value(first)?, gaps });
            }
            ("knots", [Sexp::Name(name), first, knots @ ..]) => {
                let number = |sexp: &Sexp, _: &Integers| match sexp {
                    Sexp::Number(value) => Ok(value.clone()),
                    _ => Err(StatementError::Form(sexp.to_string())),
                };
                let knots = ints.items(knots, &number)?;
                let gaps: Vec<_> = knots.windows(2).map(|pair| &pair[1] - &pair[0]).collect();
                if gaps.iter().any(Signed::is_negative) {
                    return Err(unknown());
                }
                let gaps = gaps.into_iter().map(|gap| Gap::Term(Term::Number(gap))).collect();
                section.windows.push(Window { name: name.clone(), first: ints.value(first)?, gaps });
            }
            ("goals", goals) => section.goals = ints.items(goals, &term::formula)?,
            (HINTS, hints) => section.hints = ints.items(hints, &hint)?,
            _ => return Err(unknown()),
        }
    }
    all.push(section);
    Ok(())
}

fn hint(sexp: &Sexp, ints: &Integers) -> Result<Hint, StatementError> {
    let unknown = || StatementError::Form(sexp.to_string());
    let Some(("prove", [formula, functions, uses])) = sexp.as_form() else { return Err(unknown()) };
    let (Some(("functions", [degree])), Some(("using", uses))) = (functions.as_form(), uses.as_form()) else {
        return Err(unknown());
    };
    let used = |item: &Sexp, ints: &Integers| match item {
        Sexp::List(pair) => match pair.as_slice() {
            [lemma, factor] => {
                Ok((term::formula(lemma, ints)?, ints.worked_out(factor)?, term::term(factor, ints)?))
            }
            _ => Err(unknown()),
        },
        _ => Err(unknown()),
    };
    Ok(Hint {
        formula: term::formula(formula, ints)?,
        text: ints.worked_out(formula)?,
        functions: ints.natural(degree)?,
        using: ints.items(uses, &used)?,
    })
}

fn gap(sexp: &Sexp, ints: &Integers) -> Result<Gap, StatementError> {
    Ok(match sexp {
        Sexp::Name(name) if name == "any" => Gap::Parameter(Class::Nonnegative),
        Sexp::Name(name) if name == "some" => Gap::Parameter(Class::Positive),
        _ => Gap::Term(term::term(sexp, ints)?),
    })
}

impl Section {
    fn declare(&mut self, class: Class, items: &[Sexp], ints: &Integers) -> Result<(), StatementError> {
        let names = ints.items(items, &term::parameter)?;
        self.parameters.extend(names.into_iter().map(|name| (name, class)));
        Ok(())
    }
}
