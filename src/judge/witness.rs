//! A counterexample as plain data: nothing reads its text again.

use std::collections::BTreeMap;
use std::fmt;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::analysis::{Algebraic, Enclosed, Flank, Tie, settled};
use crate::language::{Form, Formula, Int, Name, Over, Paper, Real, Sentence, classical, text};
use crate::meaning::{
    Failure, Focus, Given, Instance, Look, Names, Plain, Reading, Truth, Value, Weighting, tie,
};
use crate::scalar::{BigRational, parse_rational};
use crate::spline::{Basis, KnotVector, Side};

use super::Fault;
use super::instantiated::{formula, side, words};

/// An exact counterexample that a reader can check by hand.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct Witness {
    /// The paper's name of the instance.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub instance: Option<String>,
    /// k, where the sentence is about a basis.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub k: Option<usize>,
    /// U; none where the sentence is about weights.
    #[serde(skip_serializing_if = "Vec::is_empty", default)]
    pub knots: Vec<String>,
    /// α, or `inf`; of a member of another family, that with its parameters.
    pub alpha: String,
    /// The member of another family than that of an index.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub family: Option<OfFamily>,
    /// What is bound, in reading order: by `for`, then by `all` inside of the conclusion.
    pub given: Vec<Bound>,
    /// The conclusion that fails, by its place; without it a hypothesis is not defined.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub conclusion: Option<usize>,
    /// What the sentence says there, with numbers in the place of names.
    pub claimed: String,
    /// What is so.
    pub shows: Shows,
    /// The values of basis functions that this rests on.
    #[serde(skip_serializing_if = "Vec::is_empty", default)]
    pub looked: Vec<Looked>,
    /// The words of the part that fails.
    #[serde(skip_serializing_if = "Vec::is_empty", default)]
    pub words: Vec<String>,
}

/// A family with numbers for its parameters.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct OfFamily {
    /// Its name, or its file.
    pub name: String,
    /// Its parameters, each with its numbers as behind `--set`.
    pub parameters: BTreeMap<String, String>,
}

impl OfFamily {
    /// Of the weights of an instance; `None` for an index.
    #[must_use]
    pub fn of(weights: &Weighting) -> Option<Self> {
        let member = weights.member()?;
        let parameters =
            member.named().map(|(name, values)| (name.to_string(), values.to_string())).collect();
        Some(Self { name: member.family().given.clone(), parameters })
    }
}

/// The options that choose it.
impl fmt::Display for OfFamily {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let quoted = |word: String| match word
            .contains(|c: char| !c.is_ascii_alphanumeric() && !"._-/+,:@=".contains(c))
        {
            true => format!("'{}'", word.replace('\'', "'\\''")),
            false => word,
        };
        write!(f, "--family {}", quoted(self.name.clone()))?;
        let set =
            |(name, values): (&String, &String)| write!(f, " --set {}", quoted(format!("{name}={values}")));
        self.parameters.iter().try_for_each(set)
    }
}

/// A name and what it is.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct Bound {
    /// The name.
    pub name: String,
    /// Its value.
    pub value: Bind,
}

/// The value of a name.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum Bind {
    /// An integer.
    Integer(i64),
    /// An exact number.
    Number(String),
    /// An irrational number between two rational ones.
    Between {
        /// The lower one.
        lo: String,
        /// The higher one.
        hi: String,
    },
    /// An index.
    Index {
        /// α, or `inf`.
        alpha: String,
    },
    /// Control values.
    List(Vec<String>),
}

/// What is so at a witness.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Shows {
    /// The sides of the relation that fails.
    Values(Vec<Term>),
    /// Counts.
    Counts(Vec<Count>),
    /// What does not exist.
    Undefined(String),
    /// The largest value is taken at two points for an index close by.
    Tied(Tied),
    /// The formula is false, and has no sides.
    Fails,
}

/// For some index between two the largest value of the function is taken on both sides of a point.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct Tied {
    /// The point c.
    pub lower: String,
    /// A point at which the function is larger than at c for all of these indices.
    pub higher: String,
    /// Both indices.
    pub at: [Flanked; 2],
}

/// An index for which the largest value is on one side of c.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct Flanked {
    /// α.
    pub alpha: String,
    /// Is it on the left?
    pub left: bool,
    /// What is exceeded on that side only.
    pub exceeds: String,
}

impl From<Tie> for Tied {
    fn from(Tie { indices: [first, second], lower, higher, at_ends: [left, right] }: Tie) -> Self {
        let flanked = |alpha: BigRational, (side, value): (Flank, BigRational)| Flanked {
            alpha: alpha.to_string(),
            left: side == Flank::Left,
            exceeds: value.to_string(),
        };
        let at = [flanked(first, left), flanked(second, right)];
        Self { lower: lower.to_string(), higher: higher.to_string(), at }
    }
}

impl fmt::Display for Tied {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { lower, higher, at } = self;
        let [first, second] = at.each_ref().map(|Flanked { alpha, left, exceeds }| {
            let side = if *left { "left" } else { "right" };
            format!("for α = {alpha} it exceeds {exceeds} on the {side} of {lower} only")
        });
        write!(
            f,
            "for an index between it takes it on both sides of {lower}: {first}, {second}, and for all between it is larger at {higher} than at {lower}"
        )
    }
}

/// A side of a relation.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct Term {
    /// The term, with numbers in the place of names.
    pub term: String,
    /// Its exact value, or its first digits; none, if it does not exist.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub value: Option<String>,
    /// Are these its first digits only?
    #[serde(skip_serializing_if = "std::ops::Not::not", default)]
    pub rounded: bool,
}

/// What is counted.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct Count {
    /// Of what.
    pub what: String,
    /// How many.
    pub count: i64,
}

/// A value of a basis function that was looked at.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct Looked {
    /// i.
    pub i: usize,
    /// d.
    pub degree: usize,
    /// The order of the derivative.
    pub order: usize,
    /// x.
    pub x: String,
    /// Was the limit from the left taken?
    pub left: bool,
    /// α, or `inf`; or the member of another family.
    pub alpha: String,
}

impl From<Look> for Looked {
    fn from(Look { i, degree, order, x, side, weights }: Look) -> Self {
        Self { i, degree, order, x: x.to_string(), left: side == Side::Left, alpha: weights.to_string() }
    }
}

impl Witness {
    /// From a failure, replayed by the definition.
    ///
    /// # Errors
    /// [`Fault`], if the definition does not show it.
    pub(super) fn of(
        sentence: &Sentence,
        names: Names<'_>,
        on: &Instance,
        failure: Failure,
    ) -> Result<Self, Fault> {
        let own_knots = failure.knots.as_ref().zip(on.degree());
        let basis = own_knots.and_then(|(knots, k)| Basis::over(knots.clone(), k, on.weights.clone()).ok());
        let own = basis.and_then(|basis| Instance::on(basis).ok());
        let on = own.as_ref().unwrap_or(on);
        let reference = on.by_definition();
        let mut reading = Reading::with(&reference, names, &failure.given);
        let mut given = failure.given;
        let (mut claimed, mut kinds) = ("what is assumed is defined".to_owned(), Vec::new());
        let mut shows = failure.undefined.map_or(Shows::Fails, Shows::Undefined);
        if let Some(at) = failure.conclusion {
            let conclusion = &sentence.then[at];
            if shows == Shows::Fails {
                if reading.truth(conclusion) != Truth::False {
                    let (knots, weights) = (on.knots(), &on.weights);
                    return Err(Fault(format!(
                        "{} fails on {knots:?}, α = {weights}, {given:?}, but not by the definition",
                        text(conclusion)
                    )));
                }
                let part = failing(&mut reading, conclusion, &mut given);
                reading.looked = Some(Vec::new());
                _ = reading.truth(&part);
                shows = sides(&mut reading, &part);
                claimed = text(&formula(&mut reading, &part));
                kinds = words(&part);
            } else {
                claimed = text(&formula(&mut reading, conclusion));
            }
        }
        let bound = |(name, given): (Name, Given)| Bound { name: name.to_string(), value: given.into() };
        Ok(Self {
            instance: on.name.as_ref().map(ToString::to_string),
            k: on.degree(),
            knots: on.knots().into_iter().flat_map(|knots| knots.knots()).map(ToString::to_string).collect(),
            alpha: on.weights.to_string(),
            family: OfFamily::of(&on.weights),
            given: given.into_iter().map(bound).collect(),
            conclusion: failure.conclusion,
            claimed,
            shows,
            looked: reading.looked.take().unwrap_or_default().into_iter().map(Looked::from).collect(),
            words: kinds,
        })
    }

    /// Names and exact values in reading order: `k`, `U`, `α`, `i`, `x`.
    #[must_use]
    pub fn given(&self) -> Vec<(String, String)> {
        let named = |name: &str, value: String| (name.to_owned(), value);
        let mut all: Vec<_> = self.instance.iter().map(|name| named("instance", name.clone())).collect();
        all.extend(self.k.map(|k| named("k", k.to_string())));
        if !self.knots.is_empty() {
            all.push(named("U", format!("({})", self.knots.join(", "))));
        }
        match &self.family {
            None => all.push(named("α", self.alpha.clone())),
            Some(OfFamily { name, parameters }) => {
                all.push(named("family", name.clone()));
                all.extend(parameters.iter().map(|(name, values)| named(name, values.clone())));
            }
        }
        let greek = |name: &str| if name == "beta" { "β".to_owned() } else { name.to_owned() };
        all.extend(self.given.iter().map(|bound| (greek(&bound.name), bound.value.to_string())));
        all
    }

    /// The basis that it is about, if it is about one.
    #[must_use]
    pub fn basis(&self) -> Option<Basis> {
        if self.family.is_some() {
            return None;
        }
        let knots = self.knots.iter().map(|t| parse_rational(t).ok()).collect::<Option<_>>()?;
        Basis::new(KnotVector::new(knots).ok()?, self.k?, self.alpha.parse().ok()?).ok()
    }

    /// The number under a name, if it is a rational one.
    #[must_use]
    pub fn number(&self, name: &str) -> Option<BigRational> {
        match &self.given.iter().find(|bound| bound.name == name)?.value {
            Bind::Integer(i) => Some(BigRational::from_integer((*i).into())),
            Bind::Number(number) => parse_rational(number).ok(),
            _ => None,
        }
    }

    /// Is its x one of its knots, or an end of its interval [a, b]?
    #[must_use]
    pub fn is_at_an_end(&self) -> bool {
        let knots = self.knots.iter().filter_map(|t| parse_rational(t).ok());
        let ends = ["a", "b"].into_iter().filter_map(|name| self.number(name));
        self.number("x").is_some_and(|x| knots.chain(ends).any(|end| end == x))
    }

    /// What is so, in words.
    #[must_use]
    pub fn found(&self) -> String {
        let list = |all: Vec<String>| all.join(", ");
        match &self.shows {
            Shows::Undefined(what) => what.clone(),
            Shows::Tied(tied) => tied.to_string(),
            Shows::Fails => "it is not so".into(),
            Shows::Counts(counts) => {
                list(counts.iter().map(|Count { what, count }| format!("{what} is {count}")).collect())
            }
            Shows::Values(terms) => {
                let told = terms.iter().filter(|term| term.value.as_ref() != Some(&term.term));
                let told = list(told.map(ToString::to_string).collect());
                if told.is_empty() { "it is not so".into() } else { told }
            }
        }
    }

    /// The shortest command that shows it: `shape` where it is about maxima, `eval` where it is about values at one place;
    /// elsewhere that form of the claim is judged on the witness's knots, or with all its cases. The claim is one of `paper`.
    #[must_use]
    pub fn again(&self, claim: &str, form: Form, paper: &Paper) -> String {
        const SHAPES: [&str; 4] = ["maxima", "minima", "maximisers", "tied"];
        let of = self.family.as_ref().map_or_else(|| format!("--alpha {}", self.alpha), ToString::to_string);
        let basis = self.k.map(|k| format!("--degree {k} --knots {} {of}", self.knots.join(",")));
        let i = self.given.iter().find(|bound| bound.name == "i").map(|bound| &bound.value);
        let one = |read: fn(&Looked) -> &str| {
            let (first, rest) = self.looked.split_first()?;
            rest.iter().all(|look| read(look) == read(first)).then(|| read(first))
        };
        let place = one(|look| &look.x).filter(|_| one(|look| &look.alpha) == Some(&self.alpha));
        match (basis, i, place) {
            (Some(basis), Some(Bind::Integer(i)), _)
                if self.words.iter().any(|word| SHAPES.contains(&&**word)) =>
            {
                format!("knotproof shape {basis} --index {i}")
            }
            (Some(basis), _, Some(x)) => {
                let order = self.looked.iter().map(|look| look.order).max().unwrap_or(0);
                let derivatives = if order > 0 { format!(" --derivatives {order}") } else { String::new() };
                let side = if self.looked.iter().all(|look| look.left) { " --side left" } else { "" };
                format!("knotproof eval {basis} --x {x}{derivatives}{side}")
            }
            // There is no way to ask for what holds where the amended sentence does not apply, but with the whole claim.
            (Some(basis), ..) if self.instance.is_none() && form != Form::Fails => {
                // The classical properties are a set of their own.
                let set = if classical().claims.iter().any(|own| &*own.id == claim) {
                    " --classical".to_owned()
                } else {
                    paper.called.as_ref().map(|paper| format!(" --paper {paper}")).unwrap_or_default()
                };
                let amended = if form == Form::Amended { " --amended" } else { "" };
                format!("knotproof check {basis}{set} --property {claim}{amended}")
            }
            _ => paper.judges(claim),
        }
    }
}

/// `k = 1, U = (0, 0, 1, 1), …: the claim says …, but …`
impl fmt::Display for Witness {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let given: Vec<_> = self.given().iter().map(|(name, value)| format!("{name} = {value}")).collect();
        write!(f, "{}: the claim says {}, but {}", given.join(", "), self.claimed, self.found())
    }
}

impl fmt::Display for Term {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { term, value, rounded } = self;
        match value {
            Some(value) => write!(f, "{term} {} {value}", if *rounded { "≈" } else { "=" }),
            None => write!(f, "{term} does not exist"),
        }
    }
}

impl fmt::Display for Bind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Integer(i) => write!(f, "{i}"),
            Self::Number(text) | Self::Index { alpha: text } => f.write_str(text),
            Self::Between { lo, hi } => write!(f, "an irrational number in ({lo}, {hi})"),
            Self::List(all) => write!(f, "({})", all.join(", ")),
        }
    }
}

impl From<Given> for Bind {
    fn from(given: Given) -> Self {
        match given {
            Given::Integer(i) => Self::Integer(i),
            Given::Real(x) => Self::Number(x.to_string()),
            Given::Index(index) => Self::Index { alpha: index.to_string() },
            Given::Points(points) => Self::List(points.iter().map(ToString::to_string).collect()),
            Given::Root(place) => {
                let (cell, (lo, hi)) = (&place.0, place.1.interval());
                let x = |u: BigRational| {
                    cell.coordinate().evaluate(&u).map_or_else(String::new, |x| x.to_string())
                };
                Self::Between { lo: x(lo), hi: x(hi) }
            }
        }
    }
}

/// The smallest part of a false formula that is false: of a conjunction the first, of `all` the first integer, which is bound.
fn failing(own: &mut Reading<'_>, f: &Formula, given: &mut Vec<(Name, Given)>) -> Formula {
    match f {
        Formula::And(all) => match all.iter().find(|f| own.truth(f) == Truth::False) {
            Some(part) => failing(own, part, given),
            None => f.clone(),
        },
        Formula::Implies(_, then) => failing(own, then, given),
        Formula::All(Over::Integers(range), body) => {
            let ends = own.int(&range.from).and_then(|from| Ok((from, own.int(&range.to)?)));
            for i in ends.into_iter().flat_map(|(from, to)| from..=to) {
                own.bound.integers.push((range.name.clone(), i));
                if own.truth(body) == Truth::False {
                    given.push((range.name.clone(), Given::Integer(i)));
                    return failing(own, body, given);
                }
                own.bound.integers.pop();
            }
            f.clone()
        }
        _ => f.clone(),
    }
}

/// As many as a reader can look at.
const DIGITS: usize = 12;

fn sides(own: &mut Reading<'_>, f: &Formula) -> Shows {
    if let Formula::Not(f) = f
        && let Formula::Word(of) = &**f
    {
        return tie(own, of).map_or(Shows::Fails, |tie| Shows::Tied(tie.into()));
    }
    let terms: Vec<&Real> = match f {
        Formula::Chain(first, rest) => std::iter::once(first).chain(rest.iter().map(|(_, t)| t)).collect(),
        Formula::Within(x, _) => vec![x],
        _ => return Shows::Fails,
    };
    if terms.iter().any(|t| matches!(t, Real::Whole(Int::Word(_)))) {
        let words = terms.into_iter().filter_map(|t| match t {
            Real::Whole(i @ Int::Word(_)) => {
                own.int(i).ok().map(|count| Count { what: text(&side(own, t)), count })
            }
            _ => None,
        });
        return Shows::Counts(words.collect());
    }
    let side = |term: &Real| {
        let value = match own.supremum(term) {
            Some(mut supremum) => Some(match supremum.bounds() {
                (lo, hi) if lo == hi => (lo.to_string(), false),
                _ => (settled(&mut supremum, DIGITS), true),
            }),
            None => own.real(term).ok().and_then(|value| digits(own, &value)),
        };
        let (value, rounded) = value.map_or((None, false), |(value, rounded)| (Some(value), rounded));
        Term { term: text(&side(own, term)), value, rounded }
    };
    Shows::Values(terms.into_iter().map(side).collect())
}

/// A value in exact terms, or its first digits at an irrational place.
fn digits(own: &Reading<'_>, value: &Value) -> Option<(String, bool)> {
    match (value, own.frame.as_ref().map(|frame| &frame.focus)) {
        (Value { plain: Plain::Piece(piece), root: None }, Some(Focus::At(root))) => {
            Some((settled(&mut Algebraic::at((**piece.piece()).clone(), root.clone()), DIGITS), true))
        }
        (Value { plain: Plain::Piece(_), .. }, _) => None,
        _ => Some((value.to_string(), false)),
    }
}
