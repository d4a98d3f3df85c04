//! Parts of the line on which x is looked at as a whole, and exact signs on them.

use std::sync::Arc;

use num_traits::Signed;

use crate::analysis::{Algebraic, Enclosed, IsolatedRoot, Piece, Sign, coordinate_between, sign_pattern};
use crate::language::Name;
use crate::scalar::{BigRational, Polynomial, RationalAlgebra, RationalFunction, Ring, integer};

use super::truth::Stop;
use super::value::{Fraction, Plain, Value};

/// A part of the line.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Cell {
    /// One number.
    Point(BigRational),
    /// An open interval; `None` is an end at infinity.
    Open(Option<BigRational>, Option<BigRational>),
}

impl Cell {
    /// x as a function of u in (0, ∞), rising, for an open one.
    #[must_use]
    pub fn coordinate(&self) -> Piece {
        let u = || RationalFunction::variable(&integer(1));
        let from = |a: &BigRational| u().embed(a);
        match self {
            Self::Point(x) => from(x),
            Self::Open(Some(a), Some(b)) => coordinate_between(a, b),
            Self::Open(Some(a), None) => from(a).plus(&u()),
            Self::Open(None, Some(b)) => match u().reciprocal() {
                Some(inverse) => from(b).minus(&inverse),
                None => unreachable!("u is not 0"),
            },
            Self::Open(None, None) => unreachable!("the line is cut at a number at least"),
        }
    }
}

/// Which part of an open cell is meant.
#[derive(Debug, Clone, PartialEq)]
pub enum Focus {
    /// All of it.
    Whole,
    /// All u between two neighbouring cuts, of which this is one.
    Between(BigRational),
    /// A cut at an irrational u.
    At(IsolatedRoot),
}

/// The open cell that the variable of the moment runs over.
#[derive(Debug, Clone)]
pub struct Frame {
    /// Tells it from other frames.
    pub id: usize,
    /// The variable.
    pub name: Name,
    /// Its cell.
    pub cell: Cell,
    /// x as a function of u.
    pub coordinate: Arc<Fraction>,
    /// The span that the cell is.
    pub span: Option<usize>,
    /// The part that is looked at.
    pub focus: Focus,
    /// Where the cell has to be cut: at the positive roots of these.
    pub cuts: Vec<Polynomial<BigRational>>,
    /// Whether a polynomial has one sign on the whole cell: no root is isolated twice.
    signs: Vec<(Polynomial<BigRational>, Signs)>,
}

/// The signs that a function takes on a part of the line.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[allow(missing_docs)] // the names say it
pub struct Signs {
    pub negative: bool,
    pub zero: bool,
    pub positive: bool,
}

impl Signs {
    fn only(sign: Sign) -> Self {
        let mut signs = Self::default();
        signs.add(sign);
        signs
    }

    fn add(&mut self, sign: Sign) {
        match sign {
            Sign::Negative => self.negative = true,
            Sign::Zero => self.zero = true,
            Sign::Positive => self.positive = true,
        }
    }

    /// The one sign, if there is only one.
    #[must_use]
    pub fn one(self) -> Option<Sign> {
        match (self.negative, self.zero, self.positive) {
            (true, false, false) => Some(Sign::Negative),
            (false, true, false) => Some(Sign::Zero),
            (false, false, true) => Some(Sign::Positive),
            _ => None,
        }
    }
}

impl Frame {
    /// A frame for an open cell, which may be a span.
    #[must_use]
    pub fn new(id: usize, name: Name, cell: Cell, span: Option<usize>) -> Self {
        let (cuts, signs, focus) = (Vec::new(), Vec::new(), Focus::Whole);
        Self { id, name, coordinate: Arc::new(cell.coordinate().into()), cell, span, focus, cuts, signs }
    }

    /// Asks for the cell to be cut where the function changes its sign.
    pub fn cut(&mut self, f: &Plain) {
        if let Plain::Piece(f) = f {
            let polynomial = signed(f.piece());
            if !self.cuts.contains(&polynomial) {
                self.cuts.push(polynomial);
            }
        }
    }

    /// The signs of a function on the part that is looked at. Of a part between cuts that the function does not respect, the
    /// signs on the whole cell.
    pub fn signs(&mut self, f: &Plain) -> Signs {
        let f = match f {
            Plain::Number(q) => return Signs::only(Sign::of(q)),
            Plain::Piece(f) => f,
        };
        let (p, q) = f.parts();
        if let (Some(p), Some(q)) = (coefficient_sign(p), coefficient_sign(q)) {
            return Signs::only(if q == Sign::Negative { p.opposite() } else { p });
        }
        let f = f.piece();
        if let Focus::At(root) = &self.focus {
            return Signs::only(sign_at(f, root));
        }
        let polynomial = signed(f);
        if let Focus::Between(u) = &self.focus
            && self.cuts.contains(&polynomial)
        {
            return Signs::only(Sign::of(&polynomial.evaluate(u)));
        }
        if let Some((_, signs)) = self.signs.iter().find(|(known, _)| *known == polynomial) {
            return *signs;
        }
        let pattern = sign_pattern(&polynomial);
        let mut signs = Signs { zero: !pattern.roots().is_empty(), ..Signs::default() };
        pattern.between().iter().for_each(|(_, sign)| signs.add(*sign));
        self.signs.push((polynomial, signs));
        signs
    }

    /// The sign of A + B√c on the part that is looked at.
    ///
    /// # Errors
    /// [`Stop::Cut`], if there are several.
    pub fn sign(&mut self, value: &Value) -> Result<Sign, Stop> {
        let mut one = |f: &Plain| match self.signs(f).one() {
            Some(sign) => Ok(sign),
            None => {
                self.cut(f);
                Err(Stop::Cut)
            }
        };
        let a = one(&value.plain)?;
        let Some((b, _)) = &value.root else { return Ok(a) };
        let b = one(b)?;
        Ok(match (a, b) {
            (a, b) if a == b || b == Sign::Zero => a,
            (Sign::Zero, b) => b,
            (a, b) => match one(&value.norm())? {
                Sign::Positive => a,
                Sign::Zero => Sign::Zero,
                Sign::Negative => b,
            },
        })
    }

    /// Is the value the variable of the cell itself?
    #[must_use]
    pub fn is_variable(&self, x: &Value) -> bool {
        x.root.is_none()
            && matches!(&x.plain, Plain::Piece(f) if Arc::ptr_eq(f, &self.coordinate) || *f == self.coordinate)
    }

    /// The x of a u.
    #[must_use]
    pub fn x(&self, u: &BigRational) -> Option<BigRational> {
        self.coordinate.piece().evaluate(u)
    }
}

/// A polynomial with the signs of the function.
fn signed(f: &Piece) -> Polynomial<BigRational> {
    let nonnegative = f.denominator().coefficients().iter().all(|c| !c.is_negative());
    if nonnegative { f.numerator().clone() } else { f.numerator().times(f.denominator()) }
}

/// The sign of all coefficients that are not 0, if there is one.
fn coefficient_sign(p: &Polynomial<BigRational>) -> Option<Sign> {
    let mut signs = p.coefficients().iter().filter(|c| !c.is_zero()).map(Sign::of);
    let first = signs.next()?;
    signs.all(|sign| sign == first).then_some(first)
}

/// The sign of P/Q − S/T that the coefficients of PT − SQ show: most need no common denominator in lowest terms.
pub(super) fn sign_of_difference(a: &Value, b: &Value) -> Option<Sign> {
    if a.root.is_some() || b.root.is_some() {
        return None;
    }
    let numerator = match (&a.plain, &b.plain) {
        (Plain::Number(a), Plain::Number(b)) => return Some(Sign::of(&(a - b))),
        (Plain::Number(_), Plain::Piece(_)) => return sign_of_difference(b, a).map(Sign::opposite),
        (Plain::Piece(f), Plain::Number(c)) => {
            let (p, q) = f.parts();
            is_positive(q).then(|| p.minus(&q.scaled(c)))
        }
        (Plain::Piece(f), Plain::Piece(g)) => {
            let ((p, q), (s, t)) = (f.parts(), g.parts());
            let over_one = || if q == t { p.minus(s) } else { p.times(t).minus(&s.times(q)) };
            (is_positive(q) && is_positive(t)).then(over_one)
        }
    };
    coefficient_sign(&numerator?)
}

/// Has it no negative coefficient, and one that is not 0?
fn is_positive(p: &Polynomial<BigRational>) -> bool {
    coefficient_sign(p) == Some(Sign::Positive)
}

/// The sign at an isolated root, decided exactly. At a pole, which nobody asks for, that of the numerator.
fn sign_at(f: &Piece, root: &IsolatedRoot) -> Sign {
    if root.is_root_of(f.numerator()) {
        return Sign::Zero;
    }
    let pole = root.is_root_of(f.denominator());
    let f = if pole { RationalFunction::from_polynomial(f.numerator().clone()) } else { f.clone() };
    let mut value = Algebraic::at(f, root.clone());
    loop {
        let (lo, hi) = value.bounds();
        match (Sign::of(&lo), Sign::of(&hi)) {
            (Sign::Positive, _) => return Sign::Positive,
            (_, Sign::Negative) => return Sign::Negative,
            _ => _ = value.narrow(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::rational;

    fn frame() -> Frame {
        Frame::new(0, "x".into(), Cell::Open(Some(integer(0)), Some(integer(4))), None)
    }

    #[test]
    fn signs_of_even_order_and_at_roots_are_seen() {
        let mut frame = frame();
        let x = Value::from(frame.coordinate.clone());
        // (x² − 2)² is 0 at √2 and positive elsewhere.
        let square = x.times(&x).unwrap().minus(&2.into()).unwrap();
        let twice = square.times(&square).unwrap();
        assert_eq!(frame.signs(&twice.plain), Signs { negative: false, zero: true, positive: true });
        assert_eq!(frame.sign(&square), Err(Stop::Cut));
        assert_eq!(frame.cuts.len(), 1);
        let root = sign_pattern(&frame.cuts[0]).roots()[0].clone();
        frame.focus = Focus::At(root);
        assert_eq!(frame.sign(&square), Ok(Sign::Zero));
        assert_eq!(frame.sign(&x.minus(&rational(3, 2).into()).unwrap()), Ok(Sign::Negative));
        // x − √2, and x − √3.
        let minus_root = |c: i64| x.minus(&Value::from(c).square_root().unwrap()).unwrap();
        assert_eq!(frame.sign(&minus_root(2)), Ok(Sign::Zero));
        assert_eq!(frame.sign(&minus_root(3)), Ok(Sign::Negative));
    }

    #[test]
    fn unbounded_cells_have_coordinates_too() {
        let one = Some(integer(1));
        for (cell, x) in [(Cell::Open(one.clone(), None), 3), (Cell::Open(None, one), -1)] {
            let half = rational(1, 2);
            let u = if x > 0 { integer(2) } else { half };
            assert_eq!(cell.coordinate().evaluate(&u), Some(integer(x)));
        }
    }
}
