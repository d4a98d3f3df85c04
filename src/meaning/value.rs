//! Values on a cell: numbers, rational functions of its coordinate, and A + B√c of these.

use std::sync::{Arc, OnceLock};

use num_traits::{One, Signed, Zero};

use crate::analysis::{Piece, constant};
use crate::language::Int;
use crate::scalar::{BigInt, BigRational, Polynomial, RationalAlgebra, RationalFunction, Ring, integer};

use super::truth::Stop;

/// A number, or a function of the coordinate u.
#[derive(Debug, Clone, PartialEq)]
pub enum Plain {
    /// The same everywhere.
    Number(BigRational),
    /// A function that is not constant.
    Piece(Arc<Fraction>),
}

/// P/Q in the coordinate u. Over one Q numerators are added, and only who asks for it gets lowest terms.
#[derive(Debug)]
pub struct Fraction {
    over: Option<(Polynomial<BigRational>, Arc<Polynomial<BigRational>>)>,
    lowest: OnceLock<Arc<Piece>>,
}

impl Fraction {
    /// A sum over a denominator without zeros, monic.
    pub(super) fn sum(
        numerator: Polynomial<BigRational>,
        denominator: &Arc<Polynomial<BigRational>>,
    ) -> Self {
        Self { over: Some((numerator, Arc::clone(denominator))), lowest: OnceLock::new() }
    }

    /// A function over a denominator that it shares with others.
    #[must_use]
    pub fn shared(
        piece: Piece,
        numerator: &Polynomial<BigRational>,
        denominator: &Arc<Polynomial<BigRational>>,
    ) -> Self {
        Self { lowest: Arc::new(piece).into(), ..Self::sum(numerator.clone(), denominator) }
    }

    /// P and Q.
    #[must_use]
    pub fn parts(&self) -> (&Polynomial<BigRational>, &Polynomial<BigRational>) {
        match &self.over {
            Some((p, q)) => (p, q),
            None => (self.piece().numerator(), self.piece().denominator()),
        }
    }

    /// In lowest terms.
    #[must_use]
    pub fn piece(&self) -> &Arc<Piece> {
        self.lowest.get_or_init(|| {
            let made = self.over.as_ref().and_then(|(p, q)| RationalFunction::new(p, q));
            Arc::new(made.unwrap_or_else(|| constant(integer(0))))
        })
    }

    /// c, if this is c·Q over a monic Q.
    fn constant(&self) -> Option<&BigRational> {
        let (p, q) = self.parts();
        let c = p.leading();
        let all = || p.coefficients().iter().zip(q.coefficients()).all(|(p, q)| *p == q * c);
        (p.is_zero() || (p.degree() == q.degree() && all())).then_some(c)
    }

    /// Another numerator over the same denominator.
    fn over_the_same(&self, p: Polynomial<BigRational>) -> Option<Plain> {
        let sum = Self::sum(p, &self.over.as_ref()?.1);
        Some(sum.constant().cloned().map_or_else(|| sum.into(), Plain::Number))
    }

    /// Are both over one denominator?
    fn beside(&self, other: &Self) -> bool {
        let both = self.over.as_ref().zip(other.over.as_ref());
        both.is_some_and(|((_, q), (_, t))| Arc::ptr_eq(q, t) || q == t)
    }
}

impl PartialEq for Fraction {
    fn eq(&self, other: &Self) -> bool {
        if self.beside(other) { self.parts().0 == other.parts().0 } else { self.piece() == other.piece() }
    }
}

impl From<Piece> for Fraction {
    fn from(piece: Piece) -> Self {
        Self { over: None, lowest: Arc::new(piece).into() }
    }
}

impl From<Fraction> for Plain {
    fn from(f: Fraction) -> Self {
        Self::Piece(Arc::new(f))
    }
}

impl Plain {
    /// A constant function becomes a number.
    #[must_use]
    pub fn of(piece: Piece) -> Self {
        let (p, q) = (piece.numerator(), piece.denominator());
        if p.degree() == 0 && q.degree() == 0 {
            Self::Number(p.leading().clone())
        } else {
            Fraction::from(piece).into()
        }
    }

    /// As a function.
    #[must_use]
    pub fn piece(&self) -> Arc<Piece> {
        match self {
            Self::Number(q) => Arc::new(constant(q.clone())),
            Self::Piece(piece) => Arc::clone(piece.piece()),
        }
    }

    fn is_zero(&self) -> bool {
        matches!(self, Self::Number(q) if Zero::is_zero(q))
    }

    fn is_one(&self) -> bool {
        matches!(self, Self::Number(q) if One::is_one(q))
    }

    fn plus(&self, other: &Self) -> Self {
        let sum = match (self, other) {
            _ if self.is_zero() => return other.clone(),
            _ if other.is_zero() => return self.clone(),
            (Self::Number(a), Self::Number(b)) => return Self::Number(a + b),
            (Self::Piece(f), Self::Number(c)) | (Self::Number(c), Self::Piece(f)) if f.over.is_some() => {
                let (p, q) = f.parts();
                f.over_the_same(p.plus(&q.scaled(c)))
            }
            (Self::Piece(f), Self::Piece(g)) if f.beside(g) => f.over_the_same(f.parts().0.plus(g.parts().0)),
            _ => None,
        };
        sum.unwrap_or_else(|| Self::of(self.piece().plus(&other.piece())))
    }

    fn times(&self, other: &Self) -> Self {
        match (self, other) {
            _ if self.is_zero() || other.is_zero() => Self::Number(integer(0)),
            _ if self.is_one() => other.clone(),
            _ if other.is_one() => self.clone(),
            (Self::Number(a), Self::Number(b)) => Self::Number(a * b),
            (Self::Piece(f), Self::Number(c)) | (Self::Number(c), Self::Piece(f)) => match &f.over {
                Some((p, q)) => Fraction::sum(p.scaled(c), q).into(),
                None => Self::of(self.piece().times(&other.piece())),
            },
            _ => Self::of(self.piece().times(&other.piece())),
        }
    }

    fn negated(&self) -> Self {
        match self {
            Self::Number(q) => Self::Number(-q),
            Self::Piece(f) => match &f.over {
                Some((p, q)) => Fraction::sum(p.negate(), q).into(),
                None => Self::of(f.piece().negate()),
            },
        }
    }

    fn over(&self, other: &Self) -> Option<Self> {
        match (self, other) {
            (_, Self::Number(b)) if *b == integer(0) => None,
            (Self::Number(a), Self::Number(b)) => Some(Self::Number(a / b)),
            (_, Self::Number(b)) => Some(self.times(&Self::Number(b.recip()))),
            (_, Self::Piece(b)) if self.is_one() => b.piece().reciprocal().map(Self::of),
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

impl From<Arc<Fraction>> for Value {
    fn from(f: Arc<Fraction>) -> Self {
        match f.constant() {
            Some(q) => q.clone().into(),
            None => Plain::Piece(f).into(),
        }
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

/// What an operation makes of two integers; `None` if that does not fit, or if it is none of two.
pub(super) fn combined(of: &Int, a: i64, b: i64) -> Option<i64> {
    match of {
        Int::Plus(..) => a.checked_add(b),
        Int::Minus(..) => a.checked_sub(b),
        Int::Times(..) => a.checked_mul(b),
        Int::Least(..) => Some(a.min(b)),
        Int::Greatest(..) => Some(a.max(b)),
        Int::Binomial(..) if b < 0 || b > a => Some(0),
        Int::Binomial(..) => {
            (1..=b.min(a - b)).try_fold(1_i64, |all, s| Some(all.checked_mul(a - s + 1)? / s))
        }
        Int::Number(_) | Int::Bound(_) | Int::Degree | Int::Last | Int::M | Int::Word(_) => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// u/(1 + u) and 1/(1 + u)², over (1 + u)².
    #[test]
    fn sums_over_one_denominator_are_those_in_lowest_terms() {
        let polynomial = |c: &[i64]| Polynomial::new(integer(c[0]), c[1..].iter().map(|c| integer(*c)));
        let q = Arc::new(polynomial(&[1, 2, 1]));
        let over = |c: &[i64]| Value::from(Arc::new(Fraction::sum(polynomial(c), &q)));
        let lowest = |c: &[i64]| Value::from(RationalFunction::new(&polynomial(c), &q).unwrap());
        let (f, g) = (over(&[0, 1, 1]), over(&[1]));
        assert_eq!(f.plus(&g).unwrap(), lowest(&[1, 1, 1]));
        assert_eq!(f.minus(&1.into()).unwrap().times(&2.into()).unwrap(), lowest(&[-2, -2]));
        assert_eq!(f.minus(&lowest(&[0, 1, 1])).unwrap(), 0.into());
        let rest = over(&[0, 1]);
        assert_eq!(f.plus(&g).unwrap().plus(&rest).unwrap(), 1.into());
    }

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
