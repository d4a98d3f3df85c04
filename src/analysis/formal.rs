//! The basis functions as formal expressions in x, and in α where that stays a symbol: the paper's missing appendix.

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;

use num_traits::{Signed, Zero};

use crate::scalar::{
    Monomial, Multivariate, Polynomial, RationalAlgebra, RationalFunction, Ring, integer,
    over_one_denominator,
};
use crate::spline::{Active, Basis, Factors, FormTable, Forms, FractionFree, Index, Span, triangle};

/// A polynomial in x and α with integer coefficients as content·∏ factor^power.
///
/// Each factor has coprime coefficients, and none occurs twice. The content is positive; none of the factors is a number,
/// unless all is a negative number: then one is −1.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Factored {
    content: BigInt,
    factors: Vec<(Multivariate, usize)>,
}

/// One function on one span: numerator/denominator without a common factor, a number included.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct FormalPiece {
    /// t_j.
    pub from: BigRational,
    /// t_{j+1}.
    pub to: BigRational,
    /// Does the piece hold at t_{j+1} too? Only at t_m, where every function has its limit from the left.
    pub closed: bool,
    /// The powers of α, α − 1, x − t_a and t_b − x that divide it, then the rest.
    pub numerator: Factored,
    /// For an index a product of linear polynomials in x; for another family of divisors of the denominators of weights.
    pub denominator: Factored,
}

/// G_i^k: 0 outside of its pieces.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct FormalFunction {
    /// i.
    pub index: usize,
    /// One for each span of its support that is not empty, from left to right, unless it is 0 there: none if the function
    /// is 0.
    pub pieces: Vec<FormalPiece>,
}

/// Whose functions they are.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Whose {
    /// Those of one index.
    Index(Index),
    /// Those of every index: α is a symbol.
    EveryIndex,
    /// Those of a member of another family, as people read it.
    Member(String),
}

/// All functions of a basis as formal expressions, for one index α, with α as a symbol, or for forms.
///
/// On the span \[t_j, t_{j+1}) the [recursion without a division](FractionFree) is run over polynomials in x and α, and
/// then reduced by the factors of the denominators, which are known and irreducible. With r = p/q these are
///
/// p(x − t_a) + q(t_b − x), t_a ≤ t_j < t_{j+1} ≤ t_b,
///
/// positive on the span. For a symbol α, p = α and q = α − 1, so a factor is x − t_b + α(t_b − t_a), as the paper writes it:
/// it has the sign of α. The expressions hold for α < 0 and for α > 1; α = ∞ is no value of the symbol.
///
/// For forms the triangle is run over rational functions of x, [`Basis::active`], and what it gives in lowest terms is split
/// into divisors of the `over` of the forms.
///
/// ```
/// use knotproof::analysis::FormalBasis;
/// use knotproof::scalar::{integer, rational};
/// use knotproof::spline::{Basis, Index, KnotVector};
///
/// // φ = αx/(x + α − 1) on (0, 1).
/// let basis = Basis::new(KnotVector::bernstein(1, &integer(0), &integer(1))?, 1, Index::infinity())?;
/// let formal = FormalBasis::for_every_index(&basis).expect("a low degree");
/// let phi = &formal.functions()[1].pieces[0];
/// assert_eq!(phi.value(&rational(1, 2), &rational(-1, 1)), Some(rational(1, 3)));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct FormalBasis {
    basis: Basis<Whose>,
    functions: Vec<FormalFunction>,
}

impl FormalBasis {
    /// The number of the variable x.
    pub const X: usize = 0;
    /// The number of the variable α.
    pub const ALPHA: usize = 1;
    /// The highest degree k: that of a numerator or a denominator in either variable is then at most 120, which
    /// [`Multivariate`] has room for.
    pub const DEGREE_LIMIT: usize = 20;
    /// The highest degree of a numerator or a denominator for forms: likewise.
    pub const QUOTIENT_LIMIT: usize = 120;

    /// For the index of the basis; `None` if its degree exceeds [`DEGREE_LIMIT`](Self::DEGREE_LIMIT).
    #[must_use]
    pub fn of(basis: &Basis) -> Option<Self> {
        let ratio = basis.index().ratio();
        let [p, q] = [ratio.numer(), ratio.denom()].map(|c| Multivariate::constant(c.clone()));
        Self::with_ratio(basis.with(Whose::Index(basis.index().clone())), &p, &q)
    }

    /// For α as a symbol: the weights of the basis stand for nothing; `None` as in [`of`](Self::of).
    #[must_use]
    pub fn for_every_index<W>(basis: &Basis<W>) -> Option<Self> {
        let alpha = Multivariate::variable(Self::ALPHA);
        Self::with_ratio(basis.with(Whose::EveryIndex), &alpha, &alpha.minus(&alpha.one()))
    }

    /// For forms without a pole on a closed span, those of a `member` of a family; `None` if a
    /// [`quotient_degree`](Basis::quotient_degree) exceeds [`QUOTIENT_LIMIT`](Self::QUOTIENT_LIMIT).
    #[must_use]
    pub fn of_forms(basis: &Basis<FormTable>, member: String) -> Option<Self> {
        if basis.knots().spans().any(|span| basis.quotient_degree(span) > Self::QUOTIENT_LIMIT) {
            return None;
        }
        Some(Self::by(basis.with(Whose::Member(member)), |span| of_forms(basis, span)))
    }

    fn with_ratio(basis: Basis<Whose>, p: &Multivariate, q: &Multivariate) -> Option<Self> {
        if basis.degree() > Self::DEGREE_LIMIT {
            return None;
        }
        let recursion = Recursion::new(&basis, p, q);
        let functions = |span| recursion.on(span).map(|quotient| Some(quotient.clone()));
        Some(Self::by(basis.clone(), functions))
    }

    /// From the functions that live on each span; `None` for one that is 0 there.
    fn by(basis: Basis<Whose>, on: impl Fn(Span) -> Active<Option<(Factored, Factored)>>) -> Self {
        let functions = (0..=basis.n()).map(|index| FormalFunction { index, pieces: Vec::new() });
        let mut functions: Vec<_> = functions.collect();
        for span in basis.knots().spans() {
            let [from, to] = [span.index(), span.index() + 1].map(|i| basis.knots().t(i));
            for (i, quotient) in on(span).iter() {
                let Some((numerator, denominator)) = quotient.clone() else { continue };
                functions[i].pieces.push(FormalPiece {
                    from: from.clone(),
                    to: to.clone(),
                    closed: to == basis.knots().last(),
                    numerator,
                    denominator,
                });
            }
        }
        Self { basis, functions }
    }

    /// Knots and degree, and whose functions they are.
    #[must_use]
    pub fn basis(&self) -> &Basis<Whose> {
        &self.basis
    }

    /// α, if they are those of one index.
    #[must_use]
    pub fn index(&self) -> Option<&Index> {
        match self.basis.weights() {
            Whose::Index(index) => Some(index),
            Whose::EveryIndex | Whose::Member(_) => None,
        }
    }

    /// Is α a symbol?
    #[must_use]
    pub fn is_symbolic(&self) -> bool {
        *self.basis.weights() == Whose::EveryIndex
    }

    /// G_0^k, …, G_n^k.
    #[must_use]
    pub fn functions(&self) -> &[FormalFunction] {
        &self.functions
    }
}

impl FormalFunction {
    /// The value at x, where α is read from `alpha` if it is a symbol; 0 outside of all pieces. `None` if a denominator is 0,
    /// which no index admits.
    #[must_use]
    pub fn value(&self, x: &BigRational, alpha: &BigRational) -> Option<BigRational> {
        self.pieces
            .iter()
            .find(|piece| piece.holds_at(x))
            .map_or_else(|| Some(integer(0)), |p| p.value(x, alpha))
    }
}

impl FormalPiece {
    /// Is x in \[from, to), or in \[from, to] if the piece is closed?
    #[must_use]
    pub fn holds_at(&self, x: &BigRational) -> bool {
        self.from <= *x && (*x < self.to || self.closed && *x == self.to)
    }

    /// numerator/denominator at any x; `None` where the denominator is 0.
    #[must_use]
    pub fn value(&self, x: &BigRational, alpha: &BigRational) -> Option<BigRational> {
        self.numerator.value(x, alpha).over(&self.denominator.value(x, alpha))
    }
}

impl Factored {
    /// The number in front, > 0.
    #[must_use]
    pub fn content(&self) -> &BigInt {
        &self.content
    }

    /// Pairs (factor, power), power ≥ 1.
    #[must_use]
    pub fn factors(&self) -> &[(Multivariate, usize)] {
        &self.factors
    }

    /// All multiplied out.
    #[must_use]
    pub fn expanded(&self) -> Multivariate {
        let content = Multivariate::constant(self.content.clone());
        self.factors.iter().fold(content, |product, (factor, power)| product.times(&factor.power(*power)))
    }

    fn value(&self, x: &BigRational, alpha: &BigRational) -> BigRational {
        let at = |v: usize| if v == FormalBasis::X { x.clone() } else { alpha.clone() };
        let value = |(factor, power): &(Multivariate, usize)| factor.evaluate(x, at).power(*power);
        let content = BigRational::from_integer(self.content.clone());
        self.factors.iter().map(value).fold(content, |product, value| product.times(&value))
    }

    /// From a product of polynomials other than 0, of which those that are numbers go into the content.
    fn product(content: BigInt, polynomials: impl IntoIterator<Item = Multivariate>) -> Self {
        let mut product = Self { content, factors: Vec::new() };
        for polynomial in polynomials {
            product.multiply(&polynomial);
        }
        product
    }

    /// The opposite: of one factor, if there is one with an odd power.
    fn negate(&mut self) {
        match self.factors.iter_mut().rev().find(|(_, power)| power % 2 == 1) {
            Some((factor, _)) => *factor = factor.negate(),
            None => self.factors.push((Multivariate::constant(-1), 1)),
        }
    }

    fn multiply(&mut self, polynomial: &Multivariate) {
        let (content, factor) = primitive(polynomial);
        self.content *= content;
        if factor.as_constant().is_some() {
            return;
        }
        match self.factors.iter_mut().find(|(known, _)| *known == factor) {
            Some((_, power)) => *power += 1,
            None => self.factors.push((factor, 1)),
        }
    }
}

/// (c, p/c) for the positive content c of p ≠ 0.
fn primitive(p: &Multivariate) -> (BigInt, Multivariate) {
    let content = p.content();
    if content == BigInt::from(1) {
        return (content, p.clone());
    }
    match p.divided_by(&Multivariate::constant(content.clone())) {
        Some(quotient) => (content, quotient),
        None => unreachable!("the content divides every coefficient"),
    }
}

/// The knots as integers T_i/D, and r = p/q in any ring of polynomials.
struct Recursion<'a> {
    basis: &'a Basis<Whose>,
    knots: Vec<BigInt>,
    scale: BigInt,
    p: &'a Multivariate,
    q: &'a Multivariate,
}

impl<'a> Recursion<'a> {
    fn new(basis: &'a Basis<Whose>, p: &'a Multivariate, q: &'a Multivariate) -> Self {
        let (knots, scale) = over_one_denominator(basis.knots().knots());
        Self { basis, knots, scale, p, q }
    }

    /// The functions that live on a span, as numerators and denominators.
    fn on(&self, span: Span) -> Active<(Factored, Factored)> {
        let (k, m) = (self.basis.degree(), self.basis.knots().m());
        let (j, steps) = (span.index(), k.max(1));
        // Dx − T_a for the knots up to t_j, and T_b − Dx for those from t_{j+1} on, as (constant, slope).
        let before: Vec<_> =
            (0..steps.min(j + 1)).map(|s| (-&self.knots[j - s], self.scale.clone())).collect();
        let after: Vec<_> =
            (0..steps.min(m - j)).map(|w| (self.knots[j + 1 + w].clone(), -&self.scale)).collect();
        let times = |ratio: &Multivariate, (constant, slope): &(BigInt, BigInt)| {
            (ratio.scaled(constant), ratio.scaled(slope))
        };
        let rises = before.iter().map(|line| times(self.p, line)).collect();
        let falls = after.iter().map(|line| times(self.q, line)).collect();
        type Line = (Multivariate, Multivariate);
        let sum = |a: &Line, b: &Line| (a.0.plus(&b.0), a.1.plus(&b.1));
        let factors = Factors::new(span, k, rises, falls, sum);
        let one = Polynomial::constant(self.p.one());
        let numerators = triangle(&FractionFree::new(&factors, &one), span, k, m);
        let lines = before.iter().chain(&after).map(|(constant, slope)| {
            line(&Multivariate::constant(constant.clone()), &Multivariate::constant(slope.clone()))
        });
        // What a numerator is likely to be divisible by: for a number these are constants, and pass.
        let ratio = [self.p.clone(), self.q.clone()];
        let likely: Vec<_> = ratio.into_iter().chain(lines).map(|p| primitive(&p).1).collect();
        let reduced = |(i, numerator): (usize, &Polynomial<Multivariate>)| {
            let denominator = factors.denominator(i).map(|(constant, slope)| line(constant, slope));
            reduced(in_x(numerator), denominator, &likely)
        };
        Active::new(numerators.first(), numerators.iter().map(reduced).collect())
    }
}

/// constant + slope·x.
fn line(constant: &Multivariate, slope: &Multivariate) -> Multivariate {
    constant.plus(&slope.times(&Multivariate::variable(FormalBasis::X)))
}

/// A polynomial in x with coefficients in α as one in both.
fn in_x(p: &Polynomial<Multivariate>) -> Multivariate {
    let x = Monomial::variable(FormalBasis::X);
    let mut power = Monomial::ONE;
    let mut terms = Vec::new();
    for c in p.coefficients() {
        terms.extend(c.terms().map(|(m, c)| (m.times(&power), c.clone())));
        power = power.times(&x);
    }
    Multivariate::from_terms(terms)
}

/// numerator/∏ denominator in lowest terms; of what is left of the numerator the `likely` factors are split off.
///
/// The factors of the denominator are linear in x with a content that is a number, or free of x: so what they have in
/// common with the numerator are they themselves, and numbers.
fn reduced(
    numerator: Multivariate,
    denominator: impl Iterator<Item = Multivariate>,
    likely: &[Multivariate],
) -> (Factored, Factored) {
    let (mut content, mut rest) = primitive(&numerator);
    let mut below = Factored::product(BigInt::from(1), []);
    // A repeated factor that did not divide is not tried again.
    for factor in denominator {
        let (number, factor) = primitive(&factor);
        below.content *= number;
        let fresh = below.factors.iter().all(|(known, _)| *known != factor);
        match fresh.then(|| rest.divided_by(&factor)).flatten() {
            Some(quotient) => rest = quotient,
            None => below.multiply(&factor),
        }
    }
    let common = content.gcd(&below.content);
    content /= &common;
    below.content /= &common;
    let mut above = Factored::product(content, []);
    for factor in likely.iter().filter(|factor| factor.as_constant().is_none()) {
        while let Some(quotient) = rest.divided_by(factor) {
            above.multiply(factor);
            rest = quotient;
        }
    }
    above.multiply(&rest);
    (above, below)
}

/// The functions on a span, as numerators and denominators in lowest terms; `None` for one that is 0.
fn of_forms(basis: &Basis<FormTable>, span: Span) -> Active<Option<(Factored, Factored)>> {
    let (knots, j) = (basis.knots(), span.index());
    let x = RationalFunction::variable(&integer(1));
    let Ok(functions) = basis.active(span, &x) else { unreachable!("the span is one of the knots") };
    let line = |constant: &BigRational, slope: i64| Polynomial::new(constant.clone(), [integer(slope)]);
    let inside = (knots.t(j) + knots.t(j + 1)) / integer(2);
    let ends = knots.stop_knots().map(|(t, _)| line(&-t, 1)).collect::<Vec<_>>();
    let over = |((_, i, d), forms): ((usize, usize, usize), &Forms)| {
        let (p, q) = (line(&-knots.t(i), 1), line(knots.t(i + d), -1));
        let [_, _, over] = forms.values(&p, &q, |c| Polynomial::constant(c.clone()));
        over
    };
    let here = basis.weights().iter().filter(|((at, ..), _)| *at == j);
    let poles: Vec<_> = here.map(over).collect();
    functions.map(|f| {
        if f.is_zero() {
            return None;
        }
        let (above, mut numerator) = split(f.numerator(), &ends, &inside);
        let (below, mut denominator) = split(f.denominator(), &poles, &inside);
        let content = above / below;
        numerator.content = content.numer().abs();
        denominator.content = content.denom().clone();
        if content.is_negative() {
            numerator.negate();
        }
        Some((numerator, denominator))
    })
}

/// (c, F) with p = cF ≠ 0: divisors of the likely factors, as often as they divide p, then what is left. Each is positive
/// at `inside`, or rising if it is 0 there.
fn split(
    p: &Polynomial<BigRational>,
    likely: &[Polynomial<BigRational>],
    inside: &BigRational,
) -> (BigRational, Factored) {
    let (mut content, mut rest) = (p.leading().clone(), p.monic());
    let mut product = Factored::product(BigInt::from(1), []);
    let mut multiply = |factor: &Polynomial<BigRational>| {
        let (_, scale) = over_one_denominator(factor.coefficients());
        let integral = factor.scaled(&BigRational::from_integer(scale.clone()));
        let integral = integral.map(|c| Multivariate::constant(c.to_integer()));
        let (common, mut primitive) = primitive(&in_x(&integral));
        let value = factor.evaluate(inside);
        let negative =
            if Zero::is_zero(&value) { factor.leading().is_negative() } else { value.is_negative() };
        if negative {
            primitive = primitive.negate();
        }
        let unit = BigRational::new(common, scale);
        content *= if negative { -unit } else { unit };
        product.multiply(&primitive);
    };
    for factor in likely {
        loop {
            let common = rest.gcd(factor);
            let Some((quotient, _)) = rest.divide(&common).filter(|_| common.degree() > 0) else { break };
            multiply(&common);
            rest = quotient;
        }
    }
    if rest.degree() > 0 {
        multiply(&rest);
    }
    (content, product)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::rational;
    use crate::spline::{Evaluator, KnotVector, Side};

    fn knots(sixths: &[i64]) -> KnotVector {
        KnotVector::new(sixths.iter().map(|&t| rational(t, 6)).collect()).unwrap()
    }

    /// Values on both sides of knots, on them, inside and outside, for numbers and for the symbol.
    #[test]
    fn the_pieces_have_the_values_of_the_functions() {
        let mut compared = 0;
        for (sixths, k) in [
            (&[0, 0, 0, 6, 12, 18, 18, 18][..], 2),
            (&[0, 0, 1, 1, 1, 1, 2, 4], 2),
            (&[-6, -1, 3, 3, 5, 9, 12, 13], 3),
            (&[0, 6], 0),
            (&[0, 0, 0, 0, 0, 15, 30, 30, 30, 30, 30], 4),
        ] {
            let knots = knots(sixths);
            for alpha in ["-1", "2", "5", "-1/7", "inf", "1000001/1000000"] {
                let index: Index = alpha.parse().unwrap();
                let basis = Basis::new(knots.clone(), k, index.clone()).unwrap();
                let mut evaluator = Evaluator::new(&basis);
                let mut formal = vec![FormalBasis::of(&basis).unwrap()];
                formal.extend(index.alpha().and_then(|_| FormalBasis::for_every_index(&basis)));
                let alpha = index.alpha().unwrap_or_else(|| integer(0));
                for x in (-16..=64).map(|twelfths| rational(twelfths, 12)) {
                    let values = evaluator.values(&x, Side::Right);
                    for function in formal.iter().flat_map(|formal| formal.functions()) {
                        let value = values.as_ref().and_then(|active| active.get(function.index));
                        let value = value.cloned().unwrap_or_else(|| integer(0));
                        assert_eq!(function.value(&x, &alpha), Some(value), "{knots}, {index}, {x}");
                        compared += 1;
                    }
                }
            }
        }
        assert!(compared > 10_000, "{compared}");
    }

    /// Every factor of a denominator is linear in x, and divides the numerator no more.
    #[test]
    fn the_quotients_are_in_lowest_terms() {
        let basis =
            Basis::new(knots(&[0, 0, 0, 0, 1, 2, 2, 5, 5, 5, 5]), 3, "-1/2".parse().unwrap()).unwrap();
        for formal in [FormalBasis::of(&basis), FormalBasis::for_every_index(&basis)] {
            for piece in formal.unwrap().functions().iter().flat_map(|function| &function.pieces) {
                let numerator = piece.numerator.expanded();
                assert_eq!(numerator.content(), *piece.numerator.content());
                assert_eq!(piece.numerator.content().gcd(piece.denominator.content()), 1.into());
                for (factor, _) in piece.denominator.factors() {
                    assert_eq!(factor.degree_in(FormalBasis::X), 1);
                    assert_eq!(numerator.divided_by(factor), None);
                }
            }
        }
    }

    #[test]
    fn a_degree_that_is_too_high_is_none() {
        let knots = KnotVector::new((0..50).map(integer).collect()).unwrap();
        let basis = |k| Basis::new(knots.clone(), k, Index::infinity()).unwrap();
        assert!(FormalBasis::of(&basis(21)).is_none());
    }
}
