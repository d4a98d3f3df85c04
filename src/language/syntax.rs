//! Typed trees of formulas and sentences. No place in a text is in them: two trees are equal if they mean the same text.

use std::sync::Arc;

use num_rational::BigRational;

use super::words::Word;

/// A name as written.
pub type Name = Arc<str>;

/// An integer: an index, a degree, a count.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub enum Int {
    /// A literal.
    Number(i64),
    /// Bound by `for`, `all`, `sum`: i, j.
    Bound(Name),
    /// k.
    Degree,
    /// n = m − k − 1.
    Last,
    /// m.
    M,
    /// a + b.
    Plus(Box<Int>, Box<Int>),
    /// a − b.
    Minus(Box<Int>, Box<Int>),
    /// a·b.
    Times(Box<Int>, Box<Int>),
    /// The smaller one.
    Least(Box<Int>, Box<Int>),
    /// The greater one.
    Greatest(Box<Int>, Box<Int>),
    /// The binomial coefficient, 0 outside 0 ≤ b ≤ a.
    Binomial(Box<Int>, Box<Int>),
    /// A word that counts: `mult(x)`, `maxima(G[i])`.
    Word(Box<Use>),
}

/// A real number, or a function of the x that is bound.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub enum Real {
    /// A literal; integers are [`Real::Whole`].
    Number(BigRational),
    /// An integer.
    Whole(Int),
    /// Bound by `for`, `all` or a definition: x, a, s.
    Bound(Name),
    /// α, or another index that is bound: β.
    Index(Name),
    /// r = α/(α − 1) of the running index.
    Ratio,
    /// α = ∞, only next to an index.
    Infinity,
    /// t_i.
    Knot(Int),
    /// d_i, or a coordinate P_{i,c}.
    Coefficient(Name, Vec<Int>),
    /// A parameter of the family: q, ω_i.
    Parameter(Name, Vec<Int>),
    /// a + b.
    Plus(Box<Real>, Box<Real>),
    /// a − b.
    Minus(Box<Real>, Box<Real>),
    /// a·b.
    Times(Box<Real>, Box<Real>),
    /// a/b.
    Over(Box<Real>, Box<Real>),
    /// −a.
    Negated(Box<Real>),
    /// a^e.
    Power(Box<Real>, Int),
    /// |a|.
    Absolute(Box<Real>),
    /// √a, of a number.
    Root(Box<Real>),
    /// The smaller one.
    Least(Box<Real>, Box<Real>),
    /// The greater one.
    Greatest(Box<Real>, Box<Real>),
    /// Over a range of integers.
    Fold(Fold, Range, Box<Real>),
    /// A definition of the file without a variable: `c`, `c[i]`.
    Defined(Name, Vec<Int>),
    /// A function at a point.
    Value(Box<Function>, Box<Argument>),
    /// A word that measures: `sup(…)`.
    Word(Box<Use>),
}

/// What is made of the terms of a range.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Fold {
    /// Their sum; 0 if there are none.
    Sum,
    /// Their product; 1 if there are none.
    Product,
    /// The least; undefined if there are none.
    Least,
    /// The greatest; undefined if there are none.
    Greatest,
}

/// from..to, both included.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct Range {
    /// The name that runs.
    pub name: Name,
    /// The first.
    pub from: Int,
    /// The last; below the first, the range is empty.
    pub to: Int,
}

/// A function of one real variable.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub enum Function {
    /// G_i^d; without d that of degree k.
    Basis {
        /// i.
        i: Int,
        /// d.
        degree: Option<Int>,
    },
    /// w_i^d.
    Weight {
        /// i.
        i: Int,
        /// d.
        degree: Int,
    },
    /// x ↦ φ(x, a, b), 0 outside of [a, b), or without `cut` the Möbius map f itself.
    Phi {
        /// Is it 0 outside of [a, b)?
        cut: bool,
        /// a.
        from: Real,
        /// b.
        to: Real,
    },
    /// A definition of the file with its indices: `C`, `b[i,q]`.
    Defined(Name, Vec<Int>),
    /// The derivative of an order.
    Derivative(Box<Function>, Int),
}

/// Where a function is taken, and for which index.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct Argument {
    /// The point.
    pub at: Real,
    /// A limit from this side; otherwise the value.
    pub side: Option<Side>,
    /// For another member of the family.
    pub member: Option<Member>,
}

/// Another member of the family.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub enum Member {
    /// `alpha = …`: a term, another index, or infinity.
    Index(Real),
    /// `r = …`.
    Ratio(Real),
    /// `q = …`: with this value of a parameter of the family.
    Parameter(Name, Real),
    /// `dual`: the one that reflection leads to.
    Dual,
}

/// From which side a limit is taken.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Side {
    /// x−.
    Left,
    /// x+.
    Right,
}

/// =, ≠, <, ≤, >, ≥.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[allow(missing_docs)] // the names say it
pub enum Relation {
    Equal,
    Unequal,
    Less,
    AtMost,
    Greater,
    AtLeast,
}

/// An interval of the line.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct Interval {
    /// The left end.
    pub from: Real,
    /// Does it belong to it?
    pub from_closed: bool,
    /// The right end.
    pub to: Real,
    /// Does it belong to it?
    pub to_closed: bool,
}

/// What a quantifier runs over.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub enum Over {
    /// Integers.
    Integers(Range),
    /// Reals of an interval.
    Reals(Name, Interval),
}

/// True or false on a case.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub enum Formula {
    /// a = b < c: of equalities every pair, so that a = c is meant even where b does not exist; otherwise neighbours.
    Chain(Real, Vec<(Relation, Real)>),
    /// x in an interval.
    Within(Real, Interval),
    /// j in a range of integers.
    Among(Int, Int, Int),
    /// U in {…}: the case is one of these instances.
    Instance(Vec<Name>),
    /// not.
    Not(Box<Formula>),
    /// and.
    And(Vec<Formula>),
    /// or.
    Or(Vec<Formula>),
    /// =>.
    Implies(Box<Formula>, Box<Formula>),
    /// <=>.
    Iff(Box<Formula>, Box<Formula>),
    /// all(…: …).
    All(Over, Box<Formula>),
    /// some(…: …).
    Some(Over, Box<Formula>),
    /// one(…: …): exactly one.
    One(Over, Box<Formula>),
    /// A word that is true or false: `continuous(G[i])`.
    Word(Box<Use>),
    /// The sentence of another stanza, on the same case.
    Claim {
        /// Its identifier.
        id: Name,
        /// As printed, even if an amended one is given.
        printed: bool,
    },
}

/// A word with what it is said of.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct Use {
    /// The word.
    pub word: Word,
    /// What it is said of.
    pub of: Vec<Item>,
}

/// What a word is said of.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub enum Item {
    /// A function.
    Function(Function, Option<Member>),
    /// A term as a function of the variable, on an interval: `abs(C(x)), x in [t[0], t[m]]`.
    Expression(Real, Name, Option<Interval>),
    /// Control values by their name.
    Coefficients(Name),
    /// A number.
    Real(Real),
    /// An integer.
    Int(Int),
}

/// A property of knots.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[allow(missing_docs)] // docs/language.md has the formulas
pub enum Adjective {
    Open,
    Clamped,
    Symmetric,
    Simple,
    Equidistant,
    Bernstein,
    Inner,
    Interior,
}

/// Gaps of knots: one, or for `each(i in a..b: …)` one for every integer of a range.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct Gap {
    /// For every one of these.
    pub each: Option<Range>,
    /// t_{i+1} − t_i.
    pub size: Real,
}

/// One name of `for`.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub enum Binder {
    /// k.
    Degree {
        /// The least.
        least: usize,
        /// The greatest.
        most: Option<usize>,
    },
    /// U.
    Knots(Vec<Adjective>),
    /// U with t_0 = 0 and these gaps between its knots, in order.
    Gaps(Vec<Gap>),
    /// U of an instance of the paper.
    Instances(Vec<Name>),
    /// α in a list; `None` is ∞.
    Indices(Vec<Option<BigRational>>),
    /// Another index.
    Index(Name),
    /// An integer.
    Integer(Range),
    /// A real of an interval: every one of them.
    Point(Name, Interval),
    /// A free real.
    Real {
        /// Its name.
        name: Name,
        /// Its sign, if it has to have one.
        sign: Option<Relation>,
    },
    /// Control values.
    Points(Name),
}

/// for … if … then.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct Sentence {
    /// The binders, in order.
    pub given: Vec<Binder>,
    /// The hypotheses.
    pub assume: Vec<Formula>,
    /// The conclusions.
    pub then: Vec<Formula>,
}

/// A name for a term of a file: `b[i,q](x) = …`. Several of one name differ in literals among their indices; the first that
/// fits is meant.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct Definition {
    /// Its name.
    pub name: Name,
    /// Its indices.
    pub indices: Vec<Pattern>,
    /// Its variable; without one it is a number.
    pub variable: Option<Name>,
    /// What it stands for.
    pub body: Real,
}

/// An index of a definition.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub enum Pattern {
    /// This number only.
    Number(i64),
    /// Any number, under this name.
    Any(Name),
}
