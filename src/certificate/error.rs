//! What can be wrong with the text of a statement, and why a term has no value.

use thiserror::Error;

use crate::scalar::{Multivariate, Quotient};

use super::sexp::SyntaxError;

/// Why a text is no statement.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum StatementError {
    /// Not even the syntax is right.
    #[error("{0}")]
    Syntax(#[from] SyntaxError),
    /// A form that means nothing here.
    #[error("`{0}` means nothing here")]
    Form(String),
    /// No integer, or one that is too large or too small here.
    #[error("`{0}` is no integer that fits here")]
    Integer(String),
    /// A range that is too long.
    #[error("the range of `{0}` is too long")]
    Range(String),
    /// A degree without a goal.
    #[error("there is no goal for degree {0}")]
    NoGoal(usize),
}

/// Why a term has no value.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum EvaluationError {
    /// No such parameter, abbreviation or window.
    #[error("`{0}` is not declared")]
    Unknown(String),
    /// Something divides by what could be 0.
    #[error("a denominator could be 0: {0}")]
    Division(String),
    /// A knot that the window does not show.
    #[error("window {window} does not show the knot {index} that this depends on")]
    OutsideWindow {
        /// The window.
        window: String,
        /// The knot.
        index: i64,
    },
    /// An empty span, or one that could be.
    #[error("span {span} of window {window} could be empty")]
    EmptySpan {
        /// The window.
        window: String,
        /// The span.
        span: i64,
    },
    /// A derivative of order 2 and more of what is an unknown.
    #[error("a higher derivative of an unknown")]
    Order,
    /// Weights that a certificate can't say.
    #[error("a certificate does not say it of weights: {0}")]
    Weight(String),
    /// More unknowns than a polynomial can have.
    #[error("more than {} parameters and unknowns", Multivariate::VARIABLES)]
    TooMany,
}

/// A failed evaluation, or a value.
pub(super) type Evaluated<T = Quotient> = Result<T, EvaluationError>;
