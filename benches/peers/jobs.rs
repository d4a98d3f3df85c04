//! The jobs that are timed, one small function each, and the cases for them.

use knotproof::analysis::{
    LocalKnots, LocalKnotsError, Monotonicity, SpanQuotient, span_quotients, symbolic_quotients,
};
use knotproof::scalar::{Polynomial, integer, rational};
use knotproof::spline::{
    Active, Basis, BasisError, CurveError, Evaluator, Index, IndexError, KnotError, KnotVector, Side, Span,
    Unreduced,
};
use num_bigint::BigInt;
use num_rational::BigRational;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};
use thiserror::Error;

/// The seed of every run, so that runs are comparable.
const SEED: u64 = 5;

/// A case that cannot be built: a mistake in this file.
#[derive(Debug, Error)]
pub(crate) enum CaseError {
    #[error(transparent)]
    Knots(#[from] KnotError),
    #[error(transparent)]
    Basis(#[from] BasisError),
    #[error(transparent)]
    Index(#[from] IndexError),
    #[error(transparent)]
    LocalKnots(#[from] LocalKnotsError),
    #[error(transparent)]
    Curve(#[from] CurveError),
}

/// The basis on open uniform knots 0, …, 0, 1, …, `inner`, inner + 1, … with r = 1/3.
pub(crate) fn basis(degree: usize, inner: usize) -> Result<Basis, CaseError> {
    let ends = |t| std::iter::repeat_n(t, degree + 1);
    let knots = ends(0).chain(1..=inner).chain(ends(inner + 1)).map(integer).collect();
    Ok(Basis::new(KnotVector::new(knots)?, degree, Index::from_ratio(rational(1, 3))?)?)
}

/// The inner knots of the cases of a degree: four for degree 3, eight for the others.
pub(crate) fn inner(degree: usize) -> usize {
    if degree == 3 { 4 } else { 8 }
}

/// The span in the middle.
pub(crate) fn middle(basis: &Basis) -> Option<Span> {
    let (first, last) = (basis.knots().first(), basis.knots().last());
    basis.knots().span_at(&((first + last) / integer(2)), Side::Right)
}

/// Random points x = p/q inside the knots, 7/8·2²⁰ ≤ q < 2²⁰.
pub(crate) fn points(basis: &Basis, count: usize) -> Vec<BigRational> {
    let mut random = ChaCha8Rng::seed_from_u64(SEED);
    let mut point = || {
        let q = (1 << 20) - 1 - i64::from(random.next_u32() >> 15);
        let position = rational(i64::from(random.next_u32() >> 1), 1 << 31);
        let width = basis.knots().last() - basis.knots().first();
        let p = (width * position * rational(q, 1)).floor();
        basis.knots().first() + p / rational(q, 1)
    };
    (0..count).map(|_| point()).collect()
}

/// Functions by their gaps and their slope ratio p/q.
pub(crate) type Gaps = (Vec<u32>, (u32, u32));

/// One function of a degree on uniform knots with r = 1/3.
pub(crate) fn uniform(degree: usize) -> Vec<Gaps> {
    vec![(vec![1; degree + 1], (1, 3))]
}

/// Eight functions of a degree with random gaps from 1 to 9 and r = 3.
pub(crate) fn non_uniform(degree: usize) -> Vec<Gaps> {
    let mut random = ChaCha8Rng::seed_from_u64(SEED);
    let mut gaps = || (0..=degree).map(|_| 1 + random.next_u32() % 9).collect();
    (0..8).map(|_| (gaps(), (3, 1))).collect()
}

/// The local knots of such a function.
pub(crate) fn local_knots((gaps, (p, q)): &Gaps) -> Result<LocalKnots<BigInt>, CaseError> {
    Ok(LocalKnots::new(gaps.iter().map(|&gap| gap.into()).collect(), ((*p).into(), (*q).into()))?)
}

/// A: the k + 1 functions at a point, in lowest terms.
pub(crate) fn values(evaluator: &mut Evaluator, x: &BigRational) -> Option<Active<BigRational>> {
    evaluator.values(x, Side::Right)
}

/// A: the same as numerators over known factors.
pub(crate) fn unreduced<'a>(evaluator: &'a mut Evaluator, x: &BigRational) -> Option<Unreduced<'a>> {
    evaluator.at(x, Side::Right)
}

/// B: the k + 1 functions on a span, as P/Q in lowest terms in its positive coordinate u.
pub(crate) fn pieces(basis: &Basis, span: Span) -> Active<SpanQuotient<BigInt>> {
    span_quotients(basis, span).expect("a span of these knots")
}

/// C, from the knots: how often the slope changes its sign on each span.
pub(crate) fn turns(knots: &LocalKnots<BigInt>) -> Vec<usize> {
    Monotonicity::of(knots).spans().iter().map(|span| span.signs.len() - 1).collect()
}

/// E: the k + 1 functions on a span as P/Q in the span's positive coordinate u, with r as a variable: neither P nor
/// Q has a fraction in it, and nothing is reduced.
pub(crate) fn pieces_for_every_ratio(basis: &Basis, span: Span) -> Active<SpanQuotient<Polynomial<BigInt>>> {
    symbolic_quotients(basis.knots(), basis.degree(), span).expect("a span of these knots")
}

/// The degrees on 100 inner knots, and the numbers of inner knots in degree 3, for which growth is shown.
pub(crate) const GROWTH_DEGREES: [usize; 6] = [3, 5, 10, 15, 20, 40];
/// See [`GROWTH_DEGREES`].
pub(crate) const GROWTH_KNOTS: [usize; 4] = [10, 100, 1000, 10_000];
