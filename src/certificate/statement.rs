//! Statements: what a certificate proves (`proofs/FORMAT.md`, "Statements").

use num_traits::Signed;

use crate::judge::Scope;
use crate::language::Form;
use crate::scalar::BigRational;

use super::error::StatementError;
use super::expansion::{Integers, Range};
use super::sexp::Sexp;
use super::term::{self, Formula, Term};
use super::weights::{Class, Weighted};

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
    /// The weights that it is about.
    pub weighted: Weighted,
    /// The same, as the certificate says it.
    pub family: Sexp,
    /// The sentence, with its definitions, in canonical brackets.
    pub sentence: Vec<Sexp>,
    /// What there is to show.
    pub shown: Shown,
}

/// What there is to show of a sentence.
#[derive(Debug, Clone, PartialEq)]
pub enum Shown {
    /// Windows and goals that follow from it: those of each degree.
    Derived(Vec<Vec<Section>>),
    /// Numbers at which it fails, for each degree: nothing is left to be proved.
    Points(Vec<Sexp>),
    /// Sections, not yet unrolled, and why they are the sentence, or refute it.
    Argued {
        /// Why.
        because: String,
        /// What is to be shown.
        sections: Vec<Sexp>,
    },
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
    /// The parameters with their signs, but for u, those of the family and those of gaps.
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
            Form::Degree(k) => Sexp::form("degree", [degree(k)]),
            form => Sexp::name(&form.name()),
        };
        let parts = [
            Sexp::form("claim", [Sexp::Text(self.claim.clone())]),
            Sexp::form("form", [form]),
            Sexp::form("verdict", [Sexp::name(if self.refuted { "refuted" } else { "proved" })]),
            Sexp::form("scope", [Sexp::name(self.scope.name())]),
            Sexp::form("degrees", self.degrees.iter().map(|k| degree(*k))),
        ];
        let mut all = vec![Sexp::int(2)];
        all.extend(parts.into_iter().chain([self.family.clone()]).chain(self.sentence.iter().cloned()));
        match &self.shown {
            Shown::Derived(_) => {}
            Shown::Points(points) => all.extend(points.iter().cloned()),
            Shown::Argued { because, sections } => {
                all.push(Sexp::form("because", [Sexp::Text(because.clone())]));
                all.extend(sections.iter().map(without_hints));
            }
        }
        Sexp::form("statement", all)
    }

    /// The same for any weights at all, if it is derived and says nothing of those of its family.
    pub(super) fn for_any_weights(&self) -> Option<Self> {
        // Of examples and of weights alone more is decided by the weights than that.
        let derived = matches!(self.shown, Shown::Derived(_)) && !self.refuted;
        let derived = derived && self.scope == Scope::Knots && self.has_degree();
        let family = Weighted::Any.to_sexp().ok()?;
        let own = OF_WEIGHTS.iter().any(|name| self.sentence.iter().any(|part| part.mentions(name)));
        (derived && !own).then(|| Self { weighted: Weighted::Any, family, ..self.clone() })
    }

    /// Of what is derived only the least degree that has anything to show.
    pub(super) fn least(&self) -> Option<Self> {
        let Shown::Derived(all) = &self.shown else { return None };
        let least = |sections: &Vec<Section>| sections.iter().any(|section| !section.goals.is_empty());
        // Of degree 0 there are no weights.
        let (k, sections) = self.degrees.iter().zip(all).find(|(k, sections)| **k > 0 && least(sections))?;
        Some(Self { degrees: vec![*k], shown: Shown::Derived(vec![sections.clone()]), ..self.clone() })
    }

    /// Is this what is written? What is written for any weights says more.
    #[must_use]
    pub fn is_said_by(own: &Sexp, written: &Sexp) -> bool {
        let Ok(any) = Weighted::Any.to_sexp() else { return false };
        let with = |own: &Sexp| match own {
            Sexp::List(parts) => {
                let is_family = |part: &Sexp| part.as_form().is_some_and(|(head, _)| head == "family");
                let other = |part: &Sexp| if is_family(part) { any.clone() } else { part.clone() };
                Sexp::List(parts.iter().map(other).collect())
            }
            other => other.clone(),
        };
        own == written || with(own) == *written
    }

    /// Does its sentence speak of a degree, and not of weights alone?
    #[must_use]
    pub fn has_degree(&self) -> bool {
        let binders = self.sentence.iter().filter_map(Sexp::as_form).find(|(head, _)| *head == "sentence");
        let given =
            binders.and_then(|(_, parts)| parts.first()?.as_form()).map_or(&[][..], |(_, given)| given);
        let about = |binder: &Sexp| binder.as_form().is_some_and(|(head, _)| OF_KNOTS.contains(&head));
        given.iter().any(about)
    }

    /// The sections that are given, and why they are the sentence; `None` if nothing is argued.
    #[must_use]
    pub fn argued(&self) -> Option<(&str, &[Sexp])> {
        match &self.shown {
            Shown::Argued { because, sections } => Some((because, sections)),
            Shown::Derived(_) | Shown::Points(_) => None,
        }
    }

    /// The sections of a statement about one degree, given or derived; `None` if it has none.
    #[must_use]
    pub fn sections(&self) -> Option<Vec<Sexp>> {
        let (_, sections) = self.in_brackets();
        let all = match &self.shown {
            Shown::Points(_) => false,
            Shown::Derived(_) => self.degrees.len() == 1,
            Shown::Argued { .. } => true,
        };
        (all && !sections.is_empty()).then_some(sections)
    }

    /// With other sections in the place of those that are given or derived.
    #[must_use]
    pub fn with_sections(self, sections: Vec<Sexp>) -> Self {
        let (because, _) = self.in_brackets();
        Self { shown: Shown::Argued { because, sections }, ..self }
    }

    /// Why what there is to show is the sentence, and what that is: of what is derived that of the least degree that has any.
    #[must_use]
    pub fn in_brackets(&self) -> (String, Vec<Sexp>) {
        match &self.shown {
            Shown::Derived(sections) => {
                let least = sections.iter().find(|sections| !sections.is_empty());
                let why = match least {
                    Some(_) => {
                        "Windows and goals follow from the sentence, place by place of x (proofs/FORMAT.md, Derivation)."
                    }
                    None => {
                        "It follows from the order of the knots, or of the numbers, at every place of x (proofs/FORMAT.md, Derivation)."
                    }
                };
                (why.to_owned(), least.into_iter().flatten().map(Section::to_sexp).collect())
            }
            Shown::Points(points) => {
                let why = "At these numbers all hypotheses are true and a conclusion is not.";
                (why.to_owned(), points.clone())
            }
            Shown::Argued { because, sections } => (because.clone(), sections.clone()),
        }
    }

    /// All sections, in the order in which a proof numbers them.
    ///
    /// # Errors
    /// [`StatementError`], if the text of a section makes no sense.
    pub fn expand(&self) -> Result<Vec<Section>, StatementError> {
        let sections = match &self.shown {
            Shown::Derived(sections) => return Ok(sections.concat()),
            Shown::Points(_) => return Ok(Vec::new()),
            Shown::Argued { sections, .. } => sections,
        };
        let mut all = Vec::new();
        for &k in &self.degrees {
            let before = all.len();
            let degree = i64::try_from(k).map_err(|_| StatementError::Integer(k.to_string()))?;
            for section in sections {
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

/// What a sentence says of the weights of its family; that they are rational, and of some order, among it.
const OF_WEIGHTS: [&str; 10] =
    ["ratio", "alpha", "parameter", "dual", "phi", "f", "infinity", "smooth", "rational", "rank"];

/// What begins the binders of a sentence on knots.
const OF_KNOTS: [&str; 4] = ["degree", "knots", "instances", "gaps"];

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
    let (parameters, lets) = (Vec::new(), Vec::new());
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
    /// As the language writes it.
    pub(super) fn to_sexp(&self) -> Sexp {
        let of = |class: Class| self.parameters.iter().filter(move |(_, own)| *own == class);
        let mut parts = Vec::new();
        for (head, class) in
            [("real", Class::Real), ("nonnegative", Class::Nonnegative), ("positive", Class::Positive)]
        {
            let names: Vec<_> = of(class).map(|(name, _)| term::declared(name)).collect();
            if !names.is_empty() {
                parts.push(Sexp::form(head, names));
            }
        }
        parts.extend(
            self.lets.iter().map(|(name, value)| Sexp::form("let", [Sexp::name(name), value.to_sexp()])),
        );
        for Window { name, first, gaps } in &self.windows {
            let gap = |gap: &Gap| match gap {
                Gap::Parameter(Class::Positive) => Sexp::name("some"),
                Gap::Parameter(_) => Sexp::name("any"),
                Gap::Term(term) => term.to_sexp(),
            };
            let items = [Sexp::name(name), Sexp::int(*first)].into_iter().chain(gaps.iter().map(gap));
            parts.push(Sexp::form("window", items));
        }
        parts.push(Sexp::form("goals", self.goals.iter().map(Formula::to_sexp)));
        Sexp::form("section", parts)
    }

    fn declare(&mut self, class: Class, items: &[Sexp], ints: &Integers) -> Result<(), StatementError> {
        let names = ints.items(items, &term::parameter)?;
        self.parameters.extend(names.into_iter().map(|name| (name, class)));
        Ok(())
    }
}
