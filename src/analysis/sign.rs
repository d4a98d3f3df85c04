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

/// How often the sign changes in a list of numbers, zeros left out.
pub(crate) fn sign_changes<'a, T: Signed + 'a>(numbers: impl IntoIterator<Item = &'a T>) -> usize {
    let mut negative = numbers.into_iter().filter(|number| !number.is_zero()).map(T::is_negative);
    let Some(mut last) = negative.next() else { return 0 };
    negative.filter(|next| std::mem::replace(&mut last, *next) != *next).count()
}
