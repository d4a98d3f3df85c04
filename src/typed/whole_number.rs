//! Whole numbers.

use thiserror::Error;

/// Why a text is no whole number.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum WholeNumberError {
    /// Not a string of digits.
    #[error("write a whole number from 0 up, such as 2")]
    Malformed,
    /// More than the machine counts to.
    #[error("the number is too large")]
    TooLarge,
}

/// Reads a whole number ≥ 0.
///
/// # Errors
/// [`WholeNumberError`].
pub fn whole_number(text: &str) -> Result<usize, WholeNumberError> {
    if text.is_empty() || !text.bytes().all(|byte| byte.is_ascii_digit()) {
        return Err(WholeNumberError::Malformed);
    }
    text.parse().map_err(|_| WholeNumberError::TooLarge)
}
