//! Values on a cell: numbers, rational functions of its coordinate, and A + B√c of these.

use num_traits::Signed;

use crate::analysis::{Piece, constant};
use crate::scalar::{BigInt, BigRational, RationalAlgebra, Ring, integer};

use super::truth::Stop;

/// A number, or a function of the coordinate u.
#[derive(Debug, Clone, PartialEq)]
pub enum Plain {
    /// The same everywhere.
    Number(BigRational),
    /// A function that is not constant.
    Piece(Piece),
}

impl Plain {
    /// A constant function becomes a number.
    #[must_use]
    pub fn of(piece: Piece) -> Self {
        let (p, q) = (piece.numerator(), piece.denominator());
        if p.degree() == 0 && q.degree() == 0 {
            Self::Number(p.leading().clone())
        } else {
            Self::Piece(piece)
        }
    }

    /// As a function.
    #[must_use]
    pub fn piece(&self) -> Piece {
        match self {
            Self::Number(q) => constant(q.clone()),
            Self::Piece(piece) => piece.clone(),
        }
    }

    fn is_zero(&self) -> bool {
        matches!(self, Self::Number(q) if *q == integer(0))
    }

    fn is_one(&self) -> bool {
        matches!(self, Self::Number(q) if *q == integer(1))
    }

    fn plus(&self, other: &Self) -> Self {
        match (self, other) {
            (Self::Number(a), Self::Number(b)) => Self::Number(a + b),
            _ if self.is_zero() => other.clone(),
            _ if other.is_zero() => self.clone(),
            _ => Self::of(self.piece().plus(&other.piece())),
        }
    }

    fn times(&self, other: &Self) -> Self {
        match (self, other) {
            (Self::Number(a), Self::Number(b)) => Self::Number(a * b),
            _ if self.is_zero() || other.is_zero() => Self::Number(integer(0)),
            _ if self.is_one() => other.clone(),
            _ if other.is_one() => self.clone(),
            _ => Self::of(self.piece().times(&other.piece())),
        }
    }

    fn negated(&self) -> Self {
        match self {
            Self::Number(q) => Self::Number(-q),
            Self::Piece(piece) => Self::Piece(piece.negate()),
        }
    }

    fn over(&self, other: &Self) -> Option<Self> {
        match (self, other) {
            (_, Self::Number(b)) if *b == integer(0) => None,
            (Self::Number(a), Self::Number(b)) => Some(Self::Number(a / b)),
            (_, Self::Number(b)) => Some(self.times(&Self::Number(b.recip()))),
            (_, Self::Piece(b)) if self.is_one() => b.reciprocal().map(Self::of),
            _ => self.piece().over(&other.piece()).map(Self::of),
        }
    }
}

/// A + B√c, with c > 0 no square.
#[derive(Debug, Clone, PartialEq)]
pub struct Value {
    /// A.
    pub plain: Plain,
    /// (B, c), for B ≠ 0.
    pub root: Option<(Plain, BigRational)>,
}

impl From<Plain> for Value {
    fn from(plain: Plain) -> Self {
        Self { plain, root: None }
    }
}

impl From<BigRational> for Value {
    fn from(value: BigRational) -> Self {
        Plain::Number(value).into()
    }
}

impl From<i64> for Value {
    fn from(value: i64) -> Self {
        BigRational::from_integer(value.into()).into()
    }
}

impl From<Piece> for Value {
    fn from(piece: Piece) -> Self {
        Plain::of(piece).into()
    }
}

/// Two different roots in one term are beyond this.
fn two_roots() -> Stop {
    Stop::Unknown("two different square roots in one term".into())
}

impl Value {
    /// The number, if it is a rational one.
    #[must_use]
    pub fn number(&self) -> Option<&BigRational> {
        match self {
            Self { plain: Plain::Number(q), root: None } => Some(q),
            _ => None,
        }
    }

    fn with(plain: Plain, factor: Plain, radicand: BigRational) -> Self {
        Self { plain, root: (!factor.is_zero()).then_some((factor, radicand)) }
    }

    /// a + b.
    ///
    /// # Errors
    /// [`Stop::Unknown`], if their roots are different ones.
    pub fn plus(&self, other: &Self) -> Result<Self, Stop> {
        let plain = self.plain.plus(&other.plain);
        match (&self.root, &other.root) {
            (None, None) => Ok(plain.into()),
            (root, None) | (None, root) => Ok(Self { plain, root: root.clone() }),
            (Some((b, c)), Some((d, e))) => {
                // √e = √(e/c)·√c.
                let ratio = square_root(&(e / c)).ok_or_else(two_roots)?;
                Ok(Self::with(plain, b.plus(&d.times(&Plain::Number(ratio))), c.clone()))
            }
        }
    }

    /// −a.
    #[must_use]
    pub fn negated(&self) -> Self {
        let root = self.root.as_ref().map(|(b, c)| (b.negated(), c.clone()));
        Self { plain: self.plain.negated(), root }
    }

    /// a − b.
    ///
    /// # Errors
    /// [`Stop::Unknown`], if their roots are different ones.
    pub fn minus(&self, other: &Self) -> Result<Self, Stop> {
        self.plus(&other.negated())
    }

    /// a·b.
    ///
    /// # Errors
    /// [`Stop::Unknown`], if their roots are different ones.
    pub fn times(&self, other: &Self) -> Result<Self, Stop> {
        let plain = self.plain.times(&other.plain);
        match (&self.root, &other.root) {
            (None, None) => Ok(plain.into()),
            (Some((b, c)), None) => Ok(Self::with(plain, b.times(&other.plain), c.clone())),
            (None, Some((b, c))) => Ok(Self::with(plain, b.times(&self.plain), c.clone())),
            (Some((b, c)), Some((d, e))) => {
                let ratio = square_root(&(e / c)).ok_or_else(two_roots)?;
                let d = d.times(&Plain::Number(ratio));
                let plain = plain.plus(&b.times(&d).times(&Plain::Number(c.clone())));
                Ok(Self::with(plain, self.plain.times(&d).plus(&b.times(&other.plain)), c.clone()))
            }
        }
    }

    /// a/b, `None` if b is 0 everywhere: A/(D + E√c) = A(D − E√c)/(D² − cE²).
    ///
    /// # Errors
    /// [`Stop::Unknown`], if their roots are different ones.
    pub fn over(&self, other: &Self) -> Result<Option<Self>, Stop> {
        let Some((e, c)) = &other.root else {
            let part = |plain: &Plain| plain.over(&other.plain);
            let Some(plain) = part(&self.plain) else { return Ok(None) };
            let root = self.root.as_ref().and_then(|(b, c)| Some((part(b)?, c.clone())));
            return Ok(Some(Self { plain, root }));
        };
        let conjugate = Self { plain: other.plain.clone(), root: Some((e.negated(), c.clone())) };
        self.times(&conjugate)?.over(&other.norm().into())
    }

    /// A² − cB²: it has the sign of A where A and B√c differ in sign and |A| is the larger one.
    #[must_use]
    pub fn norm(&self) -> Plain {
        let square = self.plain.times(&self.plain);
        match &self.root {
            None => square,
            Some((b, c)) => square.plus(&b.times(b).times(&Plain::Number(-c))),
        }
    }

    /// √a of a rational number ≥ 0.
    ///
    /// # Errors
    /// [`Stop`] of any other value.
    pub fn square_root(&self) -> Result<Self, Stop> {
        let radicand =
            self.number().ok_or_else(|| Stop::Unknown("the root of what is no rational number".into()))?;
        if radicand.is_negative() {
            return Err(Stop::Undefined(format!("the root of {radicand}")));
        }
        Ok(match square_root(radicand) {
            Some(root) => root.into(),
            None => Self::with(Plain::Number(integer(0)), Plain::Number(integer(1)), radicand.clone()),
        })
    }
}

/// √(p/q), if it is rational.
fn square_root(value: &BigRational) -> Option<BigRational> {
    let exact = |n: &BigInt| (!n.is_negative()).then(|| n.sqrt()).filter(|root| root * root == *n);
    Some(BigRational::new(exact(value.numer())?, exact(value.denom())?))
}

/// `1/2`, `1/2 + 3·√2`; a function in its coordinate is not shown.
impl std::fmt::Display for Value {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let show = |plain: &Plain| match plain {
            Plain::Number(q) => q.to_string(),
            Plain::Piece(_) => "a function".to_owned(),
        };
        match &self.root {
            None => f.write_str(&show(&self.plain)),
            Some((b, c)) if self.plain.is_zero() => write!(f, "{}·√{c}", show(b)),
            Some((b, c)) => write!(f, "{} + {}·√{c}", show(&self.plain), show(b)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn roots_are_computed_with() {
        let two = Value::from(2).square_root().unwrap();
        let sum = two.plus(&1.into()).unwrap();
        assert_eq!(sum.times(&sum).unwrap(), Value::from(3).plus(&two.times(&2.into()).unwrap()).unwrap());
        assert_eq!(sum.over(&sum).unwrap(), Some(1.into()));
        let eight = Value::from(8).square_root().unwrap();
        assert_eq!(eight.minus(&two.times(&2.into()).unwrap()).unwrap(), 0.into());
        assert_eq!(Value::from(9).square_root().unwrap(), 3.into());
        assert!(Value::from(-1).square_root().is_err());
        assert!(two.plus(&Value::from(3).square_root().unwrap()).is_err());
        assert_eq!(sum.over(&0.into()).unwrap(), None);
    }
}
