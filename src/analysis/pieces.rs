//! The basis functions as exact rational functions, span by span: statements about every x.

use num_bigint::BigInt;
use num_rational::BigRational;

use crate::scalar::{Polynomial, RationalAlgebra, RationalFunction, Ring, spend};
use crate::spline::{Active, Basis, HasWeights, KnotVector, Pairs, Span, SpanError, WeightKind, triangle};

use super::decision::sign_pattern;
use super::local_knots::SpanQuotient;
use super::piece::{Piece, constant};
use super::sign::Sign;
use super::span_quotients::{own_quotient, own_quotients};

/// x = (t_j + u·t_{j+1})/(1 + u) as a function of u: the **positive coordinate** of a span.
///
/// u runs over (0, ∞) as x runs over (t_j, t_{j+1}), rising, with u = 0 at t_j and u → ∞ at t_{j+1}. In it every
/// weight, and so every G_i^k, is a quotient of polynomials with coefficients ≥ 0.
///
/// # Errors
/// [`SpanError::Foreign`] for a span of another knot vector.
pub fn positive_coordinate(knots: &KnotVector, span: Span) -> Result<Piece, SpanError> {
    let (start, end) = knots.ends(span)?;
    Ok(coordinate_between(start, end))
}

/// x = (a + u·b)/(1 + u), the positive coordinate of any interval [a, b].
#[must_use]
pub fn coordinate_between(a: &BigRational, b: &BigRational) -> Piece {
    if a == b {
        return constant(a.clone());
    }
    let one = a.one();
    // 1 + u divides no other a + bu.
    match RationalFunction::coprime(
        Polynomial::new(a.clone(), [b.clone()]),
        Polynomial::new(one.clone(), [one]),
    ) {
        Some(x) => x,
        None => unreachable!("1 + u is not 0"),
    }
}

/// The u of a point of the span: (x − t_j)/(t_{j+1} − x); `None` for x = t_{j+1}, which is u = ∞.
///
/// # Errors
/// [`SpanError`] for a span of another knot vector, and for an x outside of the closed span.
pub fn coordinate_of(
    knots: &KnotVector,
    span: Span,
    x: &BigRational,
) -> Result<Option<BigRational>, SpanError> {
    let (start, end) = knots.ends(span)?;
    if x < start || x > end {
        return Err(SpanError::Outside(span.index()));
    }
    Ok(x.minus(start).over(&end.minus(x)))
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
    ends: (BigRational, BigRational),
}

/// All pieces of a basis, which they know: for linear weights as [`span_quotients`](super::span_quotients()) on every span.
///
/// They are what the triangle gives over rational functions of u, `basis.active(span, &positive_coordinate(…)?)`.
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
    basis: Basis<()>,
    spans: Vec<SpanPieces>,
    zero: Piece,
}

impl Pieces {
    /// The functions on every span; forms have no pole on a closed span.
    #[must_use]
    pub fn of<W: HasWeights>(basis: &Basis<W>) -> Self {
        let knots = basis.knots();
        let on_span = |span: Span| {
            spend();
            let ends = (knots.t(span.index()).clone(), knots.t(span.index() + 1).clone());
            let functions = own_pieces(basis, span);
            SpanPieces { span, x: coordinate_between(&ends.0, &ends.1), functions, ends }
        };
        let spans = knots.spans().map(on_span).collect();
        Self { basis: basis.with(()), spans, zero: constant(knots.first().zero()) }
    }

    /// Degree and knots.
    #[must_use]
    pub fn basis(&self) -> &Basis<()> {
        &self.basis
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

    /// Is G_i^k nowhere negative?
    #[must_use]
    pub fn is_nonnegative(&self, i: usize) -> bool {
        let below = |g: &Piece| {
            let pattern = sign_pattern(&g.numerator().times(g.denominator()));
            pattern.between().iter().any(|(_, sign)| *sign == Sign::Negative)
        };
        let mut own = self.spans.iter().filter_map(|on| on.functions.get(i));
        !own.any(|g| !g.is_zero() && below(g))
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

/// The pieces of the functions on a span of the basis: of weights that are not linear by the recursion over functions of u.
pub(super) fn own_pieces<W: HasWeights>(basis: &Basis<W>, span: Span) -> Active<Piece> {
    let (knots, j) = (basis.knots(), span.index());
    if let Some(slopes) = basis.slopes(span) {
        return own_quotients(basis, slopes, span).map(SpanQuotient::piece);
    }
    let WeightKind::Forms(table) = basis.weights().kind() else { unreachable!("an index is linear") };
    let (start, end, zero) = (knots.t(j), knots.t(j + 1), constant(knots.first().zero()));
    // p and q times 1 + u, which cancels: forms are homogeneous.
    let linear = |at_start: BigRational, at_end: BigRational| Polynomial::new(at_start, [at_end]);
    let share = |i: usize, d: usize| {
        let (a, b) = (knots.t(i), knots.t(i + d));
        let (p, q) = (linear(start - a, end - a), linear(b - start, b - end));
        let [rise, fall, over] = table.get(j, i, d)?.values(&p, &q, |c| Polynomial::constant(c.clone()));
        Some((RationalFunction::new(&rise, &over)?, RationalFunction::new(&fall, &over)?))
    };
    let weights = Pairs::new(&zero, |i, d| share(i, d).unwrap_or_else(|| (zero.clone(), zero.one())));
    triangle(&weights, span, basis.degree(), knots.m())
}

/// G_i^k alone, on each span of its support that is not empty, in lowest terms: what [`Pieces`] have of it, for less.
///
/// # Panics
/// If i > n.
pub fn function_quotients<W: HasWeights>(basis: &Basis<W>, i: usize) -> Vec<(Span, SpanQuotient<BigInt>)> {
    assert!(i <= basis.n(), "there is no function {i}: the basis has the functions 0 to {}", basis.n());
    let support = i..=i + basis.degree();
    let quotient = |span: Span| {
        let own = match basis.slopes(span) {
            Some(slopes) => own_quotient(basis, slopes, (span, i)),
            None => own_pieces(basis, span).get(i).map(SpanQuotient::of),
        };
        Some((span, own?))
    };
    basis.knots().spans().filter(|span| support.contains(&span.index())).filter_map(quotient).collect()
}

impl SpanPieces {
    /// (t_j, t_{j+1}).
    #[must_use]
    pub fn ends(&self) -> (&BigRational, &BigRational) {
        (&self.ends.0, &self.ends.1)
    }

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
