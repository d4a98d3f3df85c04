//! The sign of a number.

use num_traits::Signed;

/// The sign of a number.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Sign {
    /// < 0.
    Negative,
    /// = 0.
    Zero,
    /// > 0.
    Positive,
}

impl Sign {
    /// The sign of a number.
    pub fn of<T: Signed>(value: &T) -> Self {
        if value.is_zero() {
            Self::Zero
        } else if value.is_negative() {
            Self::Negative
        } else {
            Self::Positive
        }
    }

    /// That of the negated number.
    #[must_use]
    pub fn opposite(self) -> Self {
        match self {
            Self::Negative => Self::Positive,
            Self::Zero => Self::Zero,
            Self::Positive => Self::Negative,
        }
    }
}
