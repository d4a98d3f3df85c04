//! Truth with five values, and why a term has none.

/// Why a term has no value here.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Stop {
    /// It speaks of what does not exist: G[−1], t[m+1], 1/0.
    Undefined(String),
    /// It differs inside the cell, which has to be cut; the frame knows where.
    Cut,
    /// A name that is not bound yet.
    Unbound(String),
    /// It can't be told, with the limit that was hit.
    Unknown(String),
}

/// Truth on a part of the line. `and` takes the first value in this order, `or` is its dual: symmetric, so that the order
/// of conjuncts means nothing, and a false one hides an undefined one.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Truth {
    /// Everywhere on it.
    False,
    /// Not the same on all of it: cut it.
    Mixed,
    /// It can't be told.
    Unknown(String),
    /// It speaks of what does not exist.
    Undefined(String),
    /// Everywhere on it.
    True,
}

impl Truth {
    fn rank(&self) -> u8 {
        match self {
            Self::False => 0,
            Self::Mixed => 1,
            Self::Unknown(_) => 2,
            Self::Undefined(_) => 3,
            Self::True => 4,
        }
    }

    /// The first of the two.
    #[must_use]
    pub fn and(self, other: Self) -> Self {
        if self.rank() <= other.rank() { self } else { other }
    }

    /// The dual of [`and`](Self::and).
    #[must_use]
    pub fn or(self, other: Self) -> Self {
        self.negated().and(other.negated()).negated()
    }

    /// True and false exchanged.
    #[must_use]
    pub fn negated(self) -> Self {
        match self {
            Self::False => Self::True,
            Self::True => Self::False,
            other => other,
        }
    }
}

impl From<bool> for Truth {
    fn from(truth: bool) -> Self {
        if truth { Self::True } else { Self::False }
    }
}

impl From<Stop> for Truth {
    fn from(stop: Stop) -> Self {
        match stop {
            Stop::Undefined(what) => Self::Undefined(what),
            Stop::Cut => Self::Mixed,
            Stop::Unbound(name) => Self::Unknown(format!("{name} is not bound")),
            Stop::Unknown(why) => Self::Unknown(why),
        }
    }
}

impl<T: Into<Truth>> From<Result<T, Stop>> for Truth {
    fn from(result: Result<T, Stop>) -> Self {
        result.map_or_else(Self::from, Into::into)
    }
}

#[cfg(test)]
mod tests {
    use super::Truth::{self, False, Mixed, True, Undefined, Unknown};

    #[test]
    fn a_false_conjunct_hides_an_undefined_one_and_a_true_disjunct_too() {
        let undefined = || Undefined("G[-1]".into());
        assert_eq!(undefined().and(False), False);
        assert_eq!(undefined().or(True), True);
        assert_eq!(undefined().and(True), undefined());
        assert_eq!(undefined().or(False), undefined());
        assert_eq!(Mixed.and(undefined()), Mixed);
        assert_eq!(Mixed.or(Unknown("?".into())), Mixed);
        assert_eq!(Truth::from(false).negated(), True);
    }
}
