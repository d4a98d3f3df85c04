//! Why a certificate is rejected, and where.

use std::fmt;

/// A certificate that is not accepted.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{place}: {reason}")]
pub struct Rejected {
    /// Where the checker stopped.
    pub place: Place,
    /// What it found there.
    pub reason: Reason,
}

/// Where in a certificate.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Place {
    /// The text of the statement.
    Statement,
    /// The text of the proof.
    Proof,
    /// A section by its number in the expansion; the goal or lemma in it, if it is one; the rule, if it is known.
    Section(usize, Option<Step>, Option<&'static str>),
}

/// What a rule proves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Step {
    /// The goal of the section with this number.
    Goal(usize),
    /// The lemma of the section with this label.
    Lemma(usize),
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Place::Statement => write!(f, "statement"),
            Place::Proof => write!(f, "proof"),
            Place::Section(section, step, rule) => {
                write!(f, "section {section}")?;
                match step {
                    Some(Step::Goal(goal)) => write!(f, ", goal {goal}")?,
                    Some(Step::Lemma(label)) => write!(f, ", lemma {label}")?,
                    None => {}
                }
                rule.map_or(Ok(()), |rule| write!(f, ", rule {rule}"))
            }
        }
    }
}

/// What is wrong.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
#[expect(missing_docs, reason = "the message of each variant says what it is")]
pub enum Reason {
    #[error("line {line}: expected {expected}")]
    Syntax { line: usize, expected: &'static str },
    #[error("{0} is beyond the limits of the checker")]
    TooLarge(&'static str),
    #[error("the form and the degrees differ")]
    Degrees,
    #[error("there is no goal for k = {0}")]
    NoGoal(usize),
    #[error("unknown name {0}")]
    Unknown(String),
    #[error("the name {0} is taken")]
    Taken(String),
    #[error("binomial of a negative number")]
    Binomial,
    #[error("{0} is negative")]
    Negative(&'static str),
    #[error("gap {1} of window {0} is not a polynomial without minus in parameters that are not real or u")]
    Gap(String, i64),
    #[error("the knots of {0} fall")]
    Falling(String),
    #[error("not determined by the window {0}: t_{1}")]
    NotDetermined(String, i64),
    #[error("span {1} of {0} is not positive")]
    Span(String, i64),
    #[error("not determined by the window {window}: w_{i}^{d} on span {span}")]
    Interval { window: String, i: i64, d: i64, span: i64 },
    #[error("a divisor without a sign")]
    Divisor,
    #[error("{0} is not positive")]
    NotPositive(String),
    #[error("{0} is not u or r")]
    Fixed(String),
    #[error("a matrix that is not square")]
    NotSquare,
    #[error("{what} {found} where {expected} has to be")]
    Number { what: &'static str, found: i64, expected: usize },
    #[error("{0} without a proof")]
    Missing(&'static str),
    #[error("a proof of a {0} that the statement does not have")]
    TooMany(&'static str),
    #[error("the rule is none for this formula")]
    WrongRule,
    #[error("no lemma {0} so far")]
    NoLemma(i64),
    #[error("lemma {0} is no equation")]
    NoEquation(i64),
    #[error("the two sides differ")]
    Differ,
    #[error("the signs do not show it: {0}")]
    Signs(&'static str),
    #[error("{0} is no parameter with a sign")]
    Split(String),
    #[error("the function is 0")]
    Zero,
    #[error("a lowest coefficient in u without a sign")]
    Lowest,
    #[error("the order is {0}")]
    Order(i64),
    #[error("the place is not the inside of a span")]
    Inside,
    #[error("a parameter besides u")]
    NotOnlyU,
    #[error("function {0} has no value at a point of the functional")]
    NoValue(usize),
    #[error("the functional is not 0 for function {0} of the list")]
    Functional(usize),
    #[error("the functional is 0 for the first function")]
    Vanishes,
    #[error("no pole there")]
    NoPole,
}
