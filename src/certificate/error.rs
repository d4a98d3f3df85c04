//! What can be wrong with the text of a statement.

use thiserror::Error;

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
