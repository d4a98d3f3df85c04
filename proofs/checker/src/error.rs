//! Why a certificate is rejected, and where.

pub(crate) type Result<T> = std::result::Result<T, Reason>;

/// A certificate that is not accepted.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{place}: {reason}")]
pub struct Rejected {
    /// `statement`, `proof`, or the section by its number in the expansion, the goal or lemma in it, and the rule.
    pub place: String,
    /// What the checker found there.
    pub reason: Reason,
}

/// What is wrong.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
#[expect(missing_docs, reason = "the message of each variant says what it is")]
pub enum Reason {
    #[error("line {line}: expected {expected}")]
    Syntax { line: usize, expected: &'static str },
    #[error("{0} is beyond the limits")]
    Limits(&'static str),
    #[error("there is no goal for k = {0}")]
    NoGoal(usize),
    #[error("{0} {1} is missing in its place")]
    Missing(&'static str, usize),
    #[error("a proof of a {0} that the statement does not have")]
    NoStatement(&'static str),
    #[error("unknown name {0}")]
    Unknown(String),
    #[error("the name {0} is taken")]
    Taken(String),
    #[error("{0} is not positive")]
    NotPositive(String),
    #[error("{0} moves with u")]
    Moving(String),
    #[error("a divisor without a sign")]
    Divisor,
    #[error("gap {1} of window {0} is not a polynomial without minus in parameters that are not real or u")]
    Gap(String, i64),
    #[error("not determined by the window {0}: {1}")]
    NotDetermined(String, String),
    #[error("the rule is none for this formula")]
    WrongRule,
    #[error("no equation {0} so far among the lemmas")]
    NoLemma(i64),
    #[error("the order is {0}")]
    Order(i64),
    #[error("no window says it: {0}; give sections, and `because`")]
    NoWindow(&'static str),
    #[error("conclusion {0} is not decided at {1}: give sections, and `because`")]
    Undecided(usize, String),
    #[error("a share of the weights of degree {1} {0}")]
    Weight(&'static str, i64),
    #[error("{0}")]
    NotShown(&'static str),
}
