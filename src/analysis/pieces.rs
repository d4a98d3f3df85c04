//! The basis functions as exact rational functions, span by span: statements about every x.

use num_rational::BigRational;

use crate::scalar::{ExactField, Polynomial, RationalAlgebra, RationalFunction, Ring, spend};
use crate::spline::{Active, Basis, KnotVector, Span};

use super::local_knots::SpanQuotient;
use super::span_quotients::span_quotients;

/// A function on a span, in the span's positive coordinate u.
pub type Piece = RationalFunction<BigRational>;

/// x = (t_j + u·t_{j+1})/(1 + u) as a function of u: the **positive coordinate** of a span.
///
/// u runs over (0, ∞) as x runs over (t_j, t_{j+1}), rising, with u = 0 at t_j and u → ∞ at t_{j+1}. In it every
/// weight, and so every G_i^k, is a quotient of polynomials with coefficients ≥ 0.
#[must_use]
pub fn positive_coordinate(knots: &KnotVector, span: Span) -> Piece {
    let (start, end) = knots.ends(span);
    coordinate_between(start, end)
}

/// x = (a + u·b)/(1 + u), the positive coordinate of any interval [a, b].
#[must_use]
pub fn coordinate_between(a: &BigRational, b: &BigRational) -> Piece {
    let one = a.one();
    match RationalFunction::new(
        &Polynomial::new(a.clone(), [b.clone()]),
        &Polynomial::new(one.clone(), [one]),
    ) {
        Some(x) => x,
        None => unreachable!("1 + u is not 0"),
    }
}

/// The u of a point of the span: (x − t_j)/(t_{j+1} − x); `None` for x = t_{j+1}, which is u = ∞.
#[must_use]
pub fn coordinate_of(knots: &KnotVector, span: Span, x: &BigRational) -> Option<BigRational> {
    let (start, end) = knots.ends(span);
    x.minus(start).over(&end.minus(x))
}

/// The pieces of all functions that live on one span.
#[derive(Debug, Clone, PartialEq)]
pub struct SpanPieces {
    /// The span.
    pub span: Span,
    /// x as a function of u.
    pub x: Piece,
    /// G_i^k as functions of u.
    pub functions: Active<Piece>,
}

/// All pieces of a basis: [`span_quotients`] on every span.
///
/// They are what the triangle gives over rational functions of u, `basis.active(span, &positive_coordinate(…))`.
///
/// ```
/// use knotproof::analysis::Pieces;
/// use knotproof::scalar::{Ring, integer};
/// use knotproof::spline::{Basis, Index, KnotVector};
///
/// let knots = KnotVector::new([0, 1, 2, 3].map(integer).to_vec())?;
/// let pieces = Pieces::of(&Basis::new(knots, 1, Index::infinity())?);
/// // On [1, 2) the two hat functions that live there add up to 1, for every x.
/// let sum = pieces.spans()[1].functions.values().iter().fold(pieces.zero(), |sum, g| sum.plus(g));
/// assert_eq!(sum, pieces.one());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone)]
pub struct Pieces {
    spans: Vec<SpanPieces>,
    zero: Piece,
}

impl Pieces {
    /// The quotients of every span.
    #[must_use]
    pub fn of(basis: &Basis) -> Self {
        let on_span = |span| {
            spend();
            let x = positive_coordinate(basis.knots(), span);
            let functions = span_quotients(basis, span).map(SpanQuotient::piece);
            SpanPieces { span, x, functions }
        };
        let spans = basis.knots().spans().map(on_span).collect();
        Self { spans, zero: constant(basis.knots().first().zero()) }
    }

    /// The spans from left to right.
    #[must_use]
    pub fn spans(&self) -> &[SpanPieces] {
        &self.spans
    }

    /// The pieces on the given span.
    #[must_use]
    pub fn on(&self, span: Span) -> Option<&SpanPieces> {
        self.spans.binary_search_by_key(&span, |pieces| pieces.span).ok().map(|at| &self.spans[at])
    }

    /// The function 0.
    #[must_use]
    pub fn zero(&self) -> Piece {
        self.zero.clone()
    }

    /// The function 1.
    #[must_use]
    pub fn one(&self) -> Piece {
        self.zero.one()
    }
}

impl SpanPieces {
    /// G_i^k on this span, 0 where it does not live.
    #[must_use]
    pub fn function(&self, i: usize) -> Piece {
        self.functions.get(i).cloned().unwrap_or_else(|| self.x.zero())
    }

    /// df/dx of a function given in u: (df/du)/(dx/du).
    #[must_use]
    pub fn derivative(&self, function: &Piece) -> Piece {
        match function.derivative().over(&self.x.derivative()) {
            Some(derivative) => derivative,
            None => unreachable!("x rises with u on a span that is not empty"),
        }
    }
}

/// The constant function.
#[must_use]
pub fn constant<S: ExactField>(value: S) -> RationalFunction<S> {
    RationalFunction::constant(value)
}
