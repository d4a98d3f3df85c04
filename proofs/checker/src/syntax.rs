//! The syntax of statements and proofs as data: what may stand where, not yet what it means.

use crate::integer::{Int, Item};
use crate::number::Ratio;

pub(crate) struct Statement {
    pub(crate) claim: String,
    pub(crate) form: String,
    pub(crate) verdict: String,
    pub(crate) scope: String,
    pub(crate) degrees: Vec<usize>,
    pub(crate) sections: Vec<SectionText>,
}

pub(crate) struct SectionText {
    pub(crate) ranges: Vec<(String, Int, Int)>,
    pub(crate) real: Vec<Item<Parameter>>,
    pub(crate) nonnegative: Vec<Item<Parameter>>,
    pub(crate) positive: Vec<Item<Parameter>>,
    pub(crate) lets: Vec<(String, Term)>,
    pub(crate) windows: Vec<WindowText>,
    pub(crate) goals: Vec<Item<Formula>>,
}

/// A name, with the indices that it has.
pub(crate) struct Parameter(pub(crate) String, pub(crate) Vec<Int>);

pub(crate) struct WindowText {
    pub(crate) name: String,
    pub(crate) first: Int,
    pub(crate) knots: Knots,
}

pub(crate) enum Knots {
    Gaps(Vec<Item<GapText>>),
    Numbers(Vec<Ratio>),
}

pub(crate) enum GapText {
    Any,
    Some,
    Term(Term),
}

pub(crate) struct Place {
    pub(crate) kind: PlaceKind,
    pub(crate) window: String,
    pub(crate) span: Int,
}

#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum PlaceKind {
    In,
    From,
    To,
}

/// What is asked about an index and a degree at a place.
#[derive(Clone, Copy)]
pub(crate) enum Of {
    Rise,
    Fall,
    Slope,
    Value,
    Derivative,
}

pub(crate) enum Term {
    Number(Ratio),
    Parameter(Parameter),
    Integer(Int),
    Sum(Vec<Item<Term>>),
    Product(Vec<Item<Term>>),
    Difference(Box<Term>, Box<Term>),
    Negative(Box<Term>),
    Quotient(Box<Term>, Box<Term>),
    Power(Box<Term>, Int),
    Knot(String, Int),
    Point(Place),
    Function(Of, Int, Int, Place),
    /// Index, level, degree.
    DeBoor(Int, Int, Int, Place),
    At(Vec<(String, Term)>, Box<Term>),
    Determinant(Vec<Vec<Term>>),
}

pub(crate) enum Formula {
    Equal(Term, Term),
    /// The first is greater.
    Greater(Term, Term),
    AtLeast(Term, Term),
    Defined(Term),
    Order(Int, Int, Place, Int),
    Outside(Place, Term, Vec<Term>),
    Pole(Place, Vec<Term>, Ratio),
}

pub(crate) struct SectionProof {
    pub(crate) number: i64,
    pub(crate) lemmas: Vec<(i64, Formula, Rule)>,
    pub(crate) goals: Vec<(i64, Rule)>,
}

pub(crate) enum Rule {
    By(Options),
    Split(Parameter, Ratio, Box<Rule>, Box<Rule>),
    Orders,
    Functional(Vec<(Ratio, Ratio)>),
    Evaluate,
}

#[derive(Default)]
pub(crate) struct Options {
    pub(crate) weights: Option<i64>,
    pub(crate) functions: Option<i64>,
    pub(crate) using: Vec<(i64, Term)>,
}
