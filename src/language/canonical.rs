//! One tree for one way of writing: what is made of integers is an integer, what is made of literals is a literal.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{ToPrimitive, Zero};

use super::syntax::{Int, Real};

impl Real {
    /// A literal.
    #[must_use]
    pub fn number(value: BigRational) -> Self {
        match value.is_integer().then(|| value.to_integer().to_i64()).flatten() {
            Some(whole) => Self::Whole(Int::Number(whole)),
            None => Self::Number(value),
        }
    }

    /// The number, if it is a literal.
    #[must_use]
    pub fn literal(&self) -> Option<BigRational> {
        match self {
            Self::Number(value) => Some(value.clone()),
            Self::Whole(Int::Number(whole)) => Some(BigRational::from_integer(BigInt::from(*whole))),
            _ => None,
        }
    }

    /// a + b.
    #[must_use]
    pub fn plus(self, other: Self) -> Self {
        self.joined(other, Int::Plus, Self::Plus)
    }

    /// a − b.
    #[must_use]
    pub fn minus(self, other: Self) -> Self {
        match (self, other) {
            (Self::Whole(Int::Number(0)), Self::Whole(int)) => Self::Whole(int.negated()),
            (a, b) => a.joined(b, Int::Minus, Self::Minus),
        }
    }

    /// a·b.
    #[must_use]
    pub fn times(self, other: Self) -> Self {
        self.joined(other, Int::Times, Self::Times)
    }

    /// a/b.
    #[must_use]
    pub fn over(self, other: Self) -> Self {
        match (self.literal(), other.literal()) {
            (Some(a), Some(b)) if !b.is_zero() => Self::number(a / b),
            _ => Self::Over(Box::new(self), Box::new(other)),
        }
    }

    /// The smaller one.
    #[must_use]
    pub fn least(self, other: Self) -> Self {
        self.joined(other, Int::Least, Self::Least)
    }

    /// The greater one.
    #[must_use]
    pub fn greatest(self, other: Self) -> Self {
        self.joined(other, Int::Greatest, Self::Greatest)
    }

    /// −a.
    #[must_use]
    pub fn negated(self) -> Self {
        match (self.literal(), self) {
            (Some(value), _) => Self::number(-value),
            (None, Self::Whole(int)) => Self::Whole(int.negated()),
            (None, other) => Self::Negated(Box::new(other)),
        }
    }

    fn joined(
        self,
        other: Self,
        whole: fn(Box<Int>, Box<Int>) -> Int,
        real: fn(Box<Self>, Box<Self>) -> Self,
    ) -> Self {
        match (self, other) {
            (Self::Whole(a), Self::Whole(b)) => Self::Whole(whole(Box::new(a), Box::new(b))),
            (a, b) => real(Box::new(a), Box::new(b)),
        }
    }
}

impl Int {
    /// −a, as 0 − a.
    #[must_use]
    pub fn negated(self) -> Self {
        match self {
            Self::Number(value) if value != i64::MIN => Self::Number(-value),
            other => Self::Minus(Box::new(Self::Number(0)), Box::new(other)),
        }
    }
}
