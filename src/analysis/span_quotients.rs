//! All functions of one span in lowest terms, over denominators that are known as products of linear factors.

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::Signed;

use crate::scalar::{
    Bilinear, Bivariate, Fixed, LinearDivisor, LongPolynomial, Polynomial, Ring, ScaleBy, Width, Words, gcd,
    may_vanish, residue,
};
use crate::spline::{Active, Basis, Factors, FractionFree, Index, KnotVector, Span, SpanError, triangle};

use super::local_knots::{SpanQuotient, integer_gaps, make_coprime};

/// G_i^k = P/(c·∏ (a + bu)) on a span, in its [positive coordinate](super::positive_coordinate) u and in lowest terms:
/// with integers, gcd(a, b) = 1, and neither c nor a factor a + bu has anything in common with P.
#[derive(Debug, Clone, PartialEq)]
struct FactoredQuotient<R = BigInt> {
    /// P and c·∏ (a + bu).
    quotient: SpanQuotient<BigInt>,
    constant: BigInt,
    /// (a, b), a > 0, b > 0, each as often as it divides the denominator.
    factors: Vec<(R, R)>,
}

/// The functions that live on a span of a basis, as quotients of polynomials in its [positive
/// coordinate](super::positive_coordinate) u with integer coefficients ≥ 0: P and Q without a common factor, a number
/// included.
///
/// By the [recursion without a division](FractionFree), in integers of a fixed width, if ∏ (A + B), over all factors A + Bu
/// of a denominator, fits into them for each of the functions: all coefficients on the way are ≥ 0, and their
/// sum is the value at u = 1, where no function exceeds 1. Then P is divided by those factors of Q that divide it.
///
/// ```
/// use knotproof::analysis::span_quotients;
/// use knotproof::scalar::integer;
/// use knotproof::spline::{Basis, Index, KnotVector};
/// use num_bigint::BigInt;
///
/// // 1 − φ and φ of (0, 1) for r = 2: 1/(1 + 2u) and 2u/(1 + 2u).
/// let basis = Basis::new(KnotVector::bernstein(1, &integer(0), &integer(1))?, 1, "2".parse::<Index>()?)?;
/// let span = basis.knots().spans().next().unwrap();
/// let functions = span_quotients(&basis, span)?;
/// assert_eq!(functions.values()[1].numerator.coefficients(), [0, 2].map(BigInt::from));
/// assert_eq!(functions.values()[1].denominator.coefficients(), [1, 2].map(BigInt::from));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`SpanError::Foreign`] for a span of another knot vector.
pub fn span_quotients(basis: &Basis, span: Span) -> Result<Active<SpanQuotient<BigInt>>, SpanError> {
    basis.knots().ends(span)?;
    Ok(own_quotients(basis, vec![basis.index().slopes()], span))
}

/// [`span_quotients`] on a span of the basis, for linear weights with these [slopes](Basis::slopes).
pub(super) fn own_quotients<W>(
    basis: &Basis<W>,
    slopes: Vec<(BigInt, BigInt)>,
    span: Span,
) -> Active<SpanQuotient<BigInt>> {
    in_lowest_terms(&Neighbourhood::of_span(basis.knots(), basis.degree(), span, slopes))
}

/// G_i^k alone, on a span of its support, likewise.
pub(super) fn own_quotient<W>(
    basis: &Basis<W>,
    slopes: Vec<(BigInt, BigInt)>,
    (span, i): (Span, usize),
) -> Option<SpanQuotient<BigInt>> {
    let (knots, k) = (basis.knots(), basis.degree());
    let near = Neighbourhood::of(knots, k, span, (i, i + k + 1), slopes);
    in_lowest_terms(&near).into_pairs().next().map(|(_, quotient)| quotient)
}

fn in_lowest_terms(near: &Neighbourhood<BigInt>) -> Active<SpanQuotient<BigInt>> {
    match near.short_quotients() {
        Some(all) => all.into_map(|function| function.quotient),
        None => near.quotients().into_map(|function| function.quotient),
    }
}

/// [`span_quotients`] for every slope ratio r at once: the coefficients are polynomials in r. Nothing is reduced.
///
/// In integers of fixed width under the same bound as there, with r = 1.
///
/// ```
/// use knotproof::analysis::symbolic_quotients;
/// use knotproof::scalar::integer;
/// use knotproof::spline::KnotVector;
/// use num_bigint::BigInt;
///
/// // φ = ru/(1 + ru) on (0, 1).
/// let knots = KnotVector::bernstein(1, &integer(0), &integer(1))?;
/// let functions = symbolic_quotients(&knots, 1, knots.spans().next().unwrap())?;
/// let [zero, one] = [0, 1].map(BigInt::from);
/// let phi = &functions.values()[1];
/// assert_eq!(phi.numerator.coefficients()[1].coefficients(), [zero.clone(), one.clone()]);
/// assert_eq!(phi.denominator.coefficients()[0].coefficients(), [one]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`SpanError::Foreign`] for a span of another knot vector, [`SpanError::Degree`] if that has no function of the
/// degree.
pub fn symbolic_quotients(
    knots: &KnotVector,
    degree: usize,
    span: Span,
) -> Result<Active<SpanQuotient<Polynomial<BigInt>>>, SpanError> {
    knots.ends(span)?;
    if degree >= knots.m() {
        return Err(SpanError::Degree { degree, m: knots.m() });
    }
    let near = Neighbourhood::of_span(knots, degree, span, vec![(1.into(), 1.into())]);
    Ok(if let Some(words) = near.in_words::<i64>() {
        words.symbolic()
    } else if let Some(words) = near.in_words::<i128>() {
        words.symbolic()
    } else {
        near.symbolic()
    })
}

/// [`span_quotients`] with the factors of the denominators.
fn factored_quotients<W>(basis: &Basis<W>, index: &Index, span: Span) -> Active<FactoredQuotient> {
    let near = Neighbourhood::of_span(basis.knots(), basis.degree(), span, vec![index.slopes()]);
    let long = |FactoredQuotient { quotient, constant, factors }: FactoredQuotient<u64>| {
        let factors = factors.into_iter().map(|(a, b)| (a.into(), b.into())).collect();
        FactoredQuotient { quotient, constant, factors }
    };
    near.short_quotients().map_or_else(|| near.quotients(), |all| all.into_map(long))
}

/// The gaps around a span, from the knot t_low on.
#[derive(Debug)]
struct Neighbourhood<R> {
    gaps: Vec<R>,
    /// (p, q) of all weights, or of each by its place.
    slopes: Vec<(R, R)>,
    low: usize,
    j: usize,
    k: usize,
}

impl Neighbourhood<BigInt> {
    /// With the knots t_{j−k}, …, t_{j+k+1}, as far as there are any.
    fn of_span(knots: &KnotVector, k: usize, span: Span, slopes: Vec<(BigInt, BigInt)>) -> Self {
        let j = span.index();
        Self::of(knots, k, span, (j.saturating_sub(k), (j + k + 1).min(knots.m())), slopes)
    }

    /// With the knots t_low, …, t_high.
    fn of(
        knots: &KnotVector,
        k: usize,
        span: Span,
        (low, high): (usize, usize),
        slopes: Vec<(BigInt, BigInt)>,
    ) -> Self {
        let j = span.index();
        // t_{j−k} and t_{j+k+1} do not matter on the span.
        let matters = |i: usize| i + k > j && i < j + k;
        let mut gaps = integer_gaps(&knots.knots()[low..=high]);
        for (gap, i) in gaps.iter_mut().zip(low..) {
            if !matters(i) && i != j {
                *gap = BigInt::ZERO;
            }
        }
        make_coprime(&mut gaps);
        Self { gaps, slopes, low, j, k }
    }

    /// The same in a fixed width, if all that is computed from it fits.
    fn in_words<W: Width>(&self) -> Option<Neighbourhood<Fixed<W>>> {
        self.with_factors_in().filter(Neighbourhood::fits)
    }

    /// The same in a fixed width, if factors and all that they are computed from fit.
    fn with_factors_in<W: Width>(&self) -> Option<Neighbourhood<Fixed<W>>> {
        let word = |number: &BigInt| W::try_from(i128::try_from(number).ok()?).ok().map(Fixed::new);
        let gaps = self.gaps.iter().map(word).collect::<Option<Vec<_>>>()?;
        let pair = |(p, q): &(BigInt, BigInt)| Some((word(p)?, word(q)?));
        let slopes = self.slopes.iter().map(pair).collect::<Option<Vec<_>>>()?;
        // Twice (p + q) times the length of the neighbourhood is more than a factor, and than all it is computed from.
        let length = gaps.iter().try_fold(W::zero(), |sum, gap| sum.checked_add(&gap.value()))?;
        let length = length.checked_add(&length)?;
        for (p, q) in &slopes {
            p.value().checked_add(&q.value())?.product(length)?;
        }
        Some(Neighbourhood { gaps, slopes, low: self.low, j: self.j, k: self.k })
    }

    /// All functions in integers of a fixed width; `None` if they are too long, or if a division can't be settled there.
    fn short_quotients(&self) -> Option<Active<FactoredQuotient<u64>>> {
        let words = self.with_factors_in::<i64>()?;
        let factors = words.factors()?;
        // A product is shorter than the lengths of its words together; one bit more, so that signs have a place.
        let length = |i: usize| {
            let values =
                factors.denominator(i).map(|(a, b)| a.value().unsigned_abs() + b.value().unsigned_abs());
            Words::of(values).map(|word| u64::from(64 - word.leading_zeros())).sum::<u64>()
        };
        match words.functions(&factors).map(length).max()? {
            0..64 => self.in_digits::<1>(&factors),
            64..128 => self.in_digits::<2>(&factors),
            128..192 => self.in_digits::<3>(&factors),
            192..256 => self.in_digits::<4>(&factors),
            256..320 => self.in_digits::<5>(&factors),
            320..384 => self.in_digits::<6>(&factors),
            384..512 => self.in_digits::<8>(&factors),
            512..768 => self.in_digits::<12>(&factors),
            _ => None,
        }
    }

    /// The same in L digits, which are enough.
    fn in_digits<const L: usize>(
        &self,
        factors: &Factors<(Fixed<i64>, Fixed<i64>)>,
    ) -> Option<Active<FactoredQuotient<u64>>> {
        // The largest denominator has (s + 1)(w + 1) − 1 factors, s + w = k.
        let one = LongPolynomial::<L>::one((self.k / 2 + 1) * (self.k.div_ceil(2) + 1));
        let numerators = triangle(&FractionFree::new(factors, &one), factors.span(), self.k, self.gaps.len());
        let divisors = Divisors::of(factors.places());
        let first = self.low + numerators.first();
        let reduced = |(i, numerator): (usize, LongPolynomial<L>)| {
            divisors.reduce(numerator, factors.denominator_places(i).flatten())
        };
        let values = numerators.into_pairs().map(reduced).collect::<Option<_>>()?;
        Some(Active::new(first, values))
    }

    /// All functions in integers of any length.
    fn quotients(&self) -> Active<FactoredQuotient> {
        let Some(factors) = self.factors() else { unreachable!("the span is within its neighbourhood") };
        let one = Polynomial::constant(BigInt::from(1));
        let weights = FractionFree::new(&factors, &one);
        let numerators = triangle(&weights, factors.span(), self.k, self.gaps.len());
        let primitive: Vec<_> = factors.places().iter().map(Primitive::of).collect();
        let reduced = |(i, numerator): (usize, &Polynomial<BigInt>)| {
            let places = factors.denominator_places(i).flatten().map(|place| &primitive[place]);
            reduce(numerator.clone(), places)
        };
        let values = numerators.iter().map(reduced).collect();
        Active::new(self.low + numerators.first(), values)
    }
}

impl<W: Width> Neighbourhood<Fixed<W>> {
    /// Does ∏ (A + B), over the factors A + Bu of any denominator, fit?
    fn fits(&self) -> bool {
        let Some(factors) = self.factors() else { return false };
        self.functions(&factors).all(|i| {
            let mut values = factors.denominator(i).map(|(a, b)| a.plus(b).value());
            values.try_fold(W::one(), |product, value| product.product(value)).is_some()
        })
    }
}

impl<R: Ring + Into<BigInt>> Neighbourhood<R> {
    fn factors(&self) -> Option<Factors<(R, R)>> {
        Factors::in_positive_coordinate(&self.gaps, self.j - self.low, self.k, &self.slopes)
    }

    /// The indices of the functions that live on the span, counted from `low`.
    fn functions<F: Clone>(&self, factors: &Factors<F>) -> impl Iterator<Item = usize> + use<R, F> {
        let j = factors.span().index();
        j.saturating_sub(self.k)..(j + 1).min(self.gaps.len() - self.k)
    }

    /// The quotients with a variable r in the place of the ratio 1: rises have it as a factor.
    fn symbolic(&self) -> Active<SpanQuotient<Polynomial<BigInt>>> {
        let Some(factors) = self.factors() else { unreachable!("the span is within its neighbourhood") };
        let zero = self.gaps[0].zero();
        let add = |a: &(R, R), b: &(R, R)| (a.0.plus(&b.0), a.1.plus(&b.1));
        let factors: Factors<Bilinear<R>> = factors.map(
            |(a, b)| [a, b].map(|c| (zero.clone(), c.clone())),
            |(a, b)| [a, b].map(|c| (c.clone(), zero.clone())),
            |[a, b], [c, d]| [add(a, c), add(b, d)],
        );
        // The largest denominator has (s + 1)(w + 1) − 1 factors, s + w = k.
        let one = Bivariate::one(&zero, (self.k / 2 + 1) * (self.k.div_ceil(2) + 1));
        let weights = FractionFree::new(&factors, &one);
        let numerators = triangle(&weights, factors.span(), self.k, self.gaps.len());
        let big = |p: &Bivariate<R>| p.to_polynomial(|c| c.clone().into());
        let quotient = |(i, numerator): (usize, &Bivariate<R>)| {
            let mut denominator = one.clone();
            denominator.scale_by(factors.denominator(i));
            SpanQuotient { numerator: big(numerator), denominator: big(&denominator) }
        };
        Active::new(self.low + numerators.first(), numerators.iter().map(quotient).collect())
    }
}

/// A linear factor content·(a + bu), gcd(a, b) = 1, with a and b modulo the prime.
struct Primitive {
    content: BigInt,
    factor: (BigInt, BigInt),
    residues: (u64, u64),
}

impl Primitive {
    fn of((a, b): &(BigInt, BigInt)) -> Self {
        let content = gcd(a, b).abs();
        let factor = (a / &content, b / &content);
        let residues = (residue(&factor.0), residue(&factor.1));
        Self { content, factor, residues }
    }

    /// Could it divide what has these residues, and has it not been tried in vain? Modulo the prime a and b may be 0, which
    /// says nothing.
    fn may_divide(&self, image: &[u64], left: &[(BigInt, BigInt)]) -> bool {
        let (a, b) = self.residues;
        (a == 0 || b == 0 || may_vanish(image, (a, b))) && !left.contains(&self.factor)
    }
}

/// numerator/∏ factors in lowest terms.
fn reduce<'a>(
    mut numerator: Polynomial<BigInt>,
    factors: impl Iterator<Item = &'a Primitive>,
) -> FactoredQuotient {
    let residues = |p: &Polynomial<BigInt>| p.coefficients().iter().map(residue).collect::<Vec<_>>();
    let (mut image, mut constant) = (residues(&numerator), BigInt::from(1));
    let mut left: Vec<(BigInt, BigInt)> = Vec::new();
    for factor in factors {
        constant *= &factor.content;
        let may_divide = factor.may_divide(&image, &left);
        match if may_divide { divided(&numerator, &factor.factor) } else { None } {
            Some(quotient) => {
                image = residues(&quotient);
                numerator = quotient;
            }
            None => left.push(factor.factor.clone()),
        }
    }
    let mut denominator = Polynomial::constant(BigInt::from(1));
    denominator.scale_by(left.iter());
    lowest_terms(numerator, constant, denominator, left)
}

/// numerator/(constant·denominator), without a common number.
fn lowest_terms(
    mut numerator: Polynomial<BigInt>,
    mut constant: BigInt,
    mut denominator: Polynomial<BigInt>,
    factors: Vec<(BigInt, BigInt)>,
) -> FactoredQuotient {
    if constant != BigInt::from(1) {
        let common = numerator.coefficients().iter().fold(constant.clone(), |common, c| {
            if common == BigInt::from(1) || c.is_zero() { common } else { gcd(&common, c).abs() }
        });
        if common != BigInt::from(1) {
            constant /= &common;
            numerator = numerator.map(|c| c / &common);
        }
    }
    if constant != BigInt::from(1) {
        denominator = denominator.scaled(&constant);
    }
    FactoredQuotient { quotient: SpanQuotient { numerator, denominator }, constant, factors }
}

/// The factors content·(a + bu), gcd(a, b) = 1, of the denominators on a span, in words.
struct Divisors {
    /// Each a + bu once.
    distinct: Vec<LinearDivisor>,
    /// For each place of a factor its content, and which of them it is.
    places: Vec<(u64, usize)>,
}

impl Divisors {
    fn of(places: &[(Fixed<i64>, Fixed<i64>)]) -> Self {
        let mut divisors =
            Self { distinct: Vec::with_capacity(places.len()), places: Vec::with_capacity(places.len()) };
        for (a, b) in places {
            let (a, b) = (a.value().unsigned_abs(), b.value().unsigned_abs());
            let content = a.gcd(&b);
            let factor = (a / content, b / content);
            let known = divisors.distinct.iter().position(|divisor| divisor.factor() == factor);
            let which = known.unwrap_or_else(|| {
                divisors.distinct.push(LinearDivisor::new(factor));
                divisors.distinct.len() - 1
            });
            divisors.places.push((content, which));
        }
        divisors
    }

    /// numerator over the factors on these places in lowest terms; `None` if a division can't be settled in L digits.
    fn reduce<const L: usize>(
        &self,
        mut numerator: LongPolynomial<L>,
        places: impl Iterator<Item = usize> + Clone,
    ) -> Option<FactoredQuotient<u64>> {
        let mut in_vain = vec![false; self.distinct.len()];
        let mut factors = Vec::with_capacity(self.places.len());
        for place in places.clone() {
            let (_, which) = self.places[place];
            let divisor = &self.distinct[which];
            let may_divide = !in_vain[which] && numerator.may_be_divided(divisor);
            match if may_divide { numerator.divided(divisor)? } else { None } {
                Some(quotient) => numerator = quotient,
                None => {
                    in_vain[which] = true;
                    factors.push(divisor.factor());
                }
            }
        }
        let mut denominator = LongPolynomial::<L>::one(factors.len() + 1);
        denominator.multiply(factors.iter().copied());
        let mut constant = BigInt::from(1);
        // Word by word nothing common is left: after each, what the numerator still has is coprime to what is left of the word.
        for word in Words::of(places.map(|place| self.places[place].0)) {
            let common = numerator.common_divisor(word);
            numerator.divide(common);
            denominator.multiply(std::iter::once((word / common, 0)));
            constant *= word / common;
        }
        let quotient =
            SpanQuotient { numerator: numerator.to_polynomial(), denominator: denominator.to_polynomial() };
        Some(FactoredQuotient { quotient, constant, factors })
    }
}

/// The quotient by a + bu, written (a, b), a and b coprime and not 0, if that divides. Then its coefficients are
/// integers, by Gauss's lemma.
fn divided(p: &Polynomial<BigInt>, (a, b): &(BigInt, BigInt)) -> Option<Polynomial<BigInt>> {
    let (leading, lower) = p.coefficients().split_last()?;
    let mut quotient: Vec<BigInt> = Vec::with_capacity(lower.len());
    for c in lower {
        let rest = quotient.last().map_or_else(|| c.clone(), |last| c - b * last);
        let (next, over) = rest.div_rem(a);
        if !over.is_zero() {
            return None;
        }
        quotient.push(next);
    }
    let exact = b * quotient.last()? == *leading;
    let mut quotient = quotient.into_iter();
    Some(Polynomial::new(quotient.next()?, quotient)).filter(|_| exact)
}

/// All functions of a span over one denominator: the least common multiple Q of theirs, a product of a + bu.
#[derive(Debug, Clone, PartialEq)]
pub struct OneDenominator {
    /// a/b for each factor of Q.
    pub factors: Vec<BigRational>,
    /// The numerators over ∏ (u + a/b).
    pub numerators: Active<Polynomial<BigRational>>,
}

impl OneDenominator {
    /// ∏ (u + a/b).
    #[must_use]
    pub fn denominator(&self) -> Polynomial<BigRational> {
        let one = Polynomial::constant(BigRational::from_integer(1.into()));
        let linear = |c: &BigRational| Polynomial::new(c.clone(), [c.one()]);
        self.factors.iter().fold(one, |product, c| product.times(&linear(c)))
    }

    /// On a span of the basis, for the weights of an index.
    #[must_use]
    pub fn of<W>(basis: &Basis<W>, index: &Index, span: Span) -> Self {
        let functions = factored_quotients(basis, index, span);
        let mut common: Vec<(BigInt, BigInt)> = Vec::new();
        for function in functions.values() {
            for factor in lacking(&common, &function.factors) {
                common.push(factor);
            }
        }
        let leading: BigInt = common.iter().map(|(_, b)| b).product();
        let numerator = |function: &FactoredQuotient| {
            let mut numerator = function.quotient.numerator.clone();
            numerator.scale_by(lacking(&function.factors, &common).iter());
            let denominator = &function.constant * &leading;
            numerator.map(|c| BigRational::new(c.clone(), denominator.clone()))
        };
        let numerators = functions.map(numerator);
        Self { factors: common.into_iter().map(|(a, b)| BigRational::new(a, b)).collect(), numerators }
    }
}

/// What a list lacks to contain another, with multiplicities.
fn lacking(list: &[(BigInt, BigInt)], other: &[(BigInt, BigInt)]) -> Vec<(BigInt, BigInt)> {
    let mut there = list.to_vec();
    let mut missing = Vec::new();
    for factor in other {
        match there.iter().position(|own| own == factor) {
            Some(at) => drop(there.swap_remove(at)),
            None => missing.push(factor.clone()),
        }
    }
    missing
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::positive_coordinate;
    use crate::scalar::{RationalFunction, integer, rational};
    use crate::spline::{FormTable, Forms, Index};
    use proptest::prelude::*;

    fn over_rationals(p: &Polynomial<BigInt>) -> Polynomial<BigRational> {
        p.map(|c| BigRational::from_integer(c.clone()))
    }

    /// The same functions as by the triangle over rational functions, on spans of every kind, in lowest terms.
    #[test]
    fn the_quotients_are_the_pieces() {
        for knots in [
            &[0, 0, 0, 0, 1, 2, 2, 5, 5, 5, 5][..],
            &[0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10],
            &[0, 0, 1, 1, 1, 1, 2, 4],
            &[0, 1_000_000, 1_000_003, 4_000_000, 9_000_000, 9_000_001, 9_900_000],
        ] {
            let knots = KnotVector::new(knots.iter().map(|&t| rational(t, 6)).collect()).unwrap();
            for (degree, alpha) in
                [(0, "2"), (1, "-1"), (2, "5"), (3, "-1/7"), (3, "inf"), (5, "-1/2"), (5, "-1e30")]
            {
                let Ok(basis) = Basis::new(knots.clone(), degree, alpha.parse().unwrap()) else { continue };
                for span in knots.spans() {
                    let reference = basis.active(span, &positive_coordinate(&knots, span).unwrap()).unwrap();
                    let quotients = span_quotients(&basis, span).unwrap();
                    let pieces = quotients.map(|quotient| {
                        let [p, q] = [&quotient.numerator, &quotient.denominator].map(over_rationals);
                        assert_eq!(p.gcd(&q).degree(), 0, "in lowest terms");
                        let content = p.coefficients().iter().chain(q.coefficients());
                        let content = content.fold(BigInt::ZERO, |gcd, c| gcd.gcd(c.numer()));
                        assert_eq!(content, 1.into(), "no common number");
                        RationalFunction::new(&p, &q).unwrap()
                    });
                    assert_eq!(pieces, reference);

                    let one = OneDenominator::of(&basis, basis.index(), span);
                    assert!(one.factors.iter().all(Signed::is_positive));
                    let factors: Vec<_> = one.factors.iter().map(|c| (c.clone(), integer(1))).collect();
                    let mut q = Polynomial::constant(integer(1));
                    q.scale_by(factors.iter());
                    assert_eq!(one.numerators.map(|p| RationalFunction::new(p, &q).unwrap()), reference);
                }
            }
        }
    }

    /// So are those of linear weights with a ratio each.
    #[test]
    fn linear_forms_have_such_quotients() {
        let knots = KnotVector::new([0, 0, 0, 0, 1, 2, 2, 5, 5, 6, 9].map(integer).to_vec()).unwrap();
        for degree in 1..=4 {
            let slope = |a: usize, b: usize| rational(i64::try_from(a * 7 % 5 + b).unwrap_or(1), 3);
            let forms = |j: usize, i: usize, d: usize| {
                Forms::new(vec![integer(0), slope(i, d)], vec![slope(d, j + 1), integer(0)], None).ok_or(())
            };
            let basis =
                Basis::over(knots.clone(), degree, FormTable::new(&knots, degree, forms).unwrap()).unwrap();
            for span in knots.spans() {
                let reference = basis.active(span, &positive_coordinate(&knots, span).unwrap()).unwrap();
                let slopes = basis.slopes(span).unwrap();
                assert!(degree == 1 || slopes.len() > 1);
                for (i, g) in reference.iter() {
                    let alone = own_quotient(&basis, slopes.clone(), (span, i)).unwrap();
                    assert_eq!(&alone.piece(), g, "{degree}, {}, {i}", span.index());
                }
                let quotients = own_quotients(&basis, slopes, span);
                assert_eq!(quotients.map(SpanQuotient::piece), reference, "{degree}, {}", span.index());
            }
        }
    }

    /// At a ratio they are the quotients there.
    #[test]
    fn symbolic_quotients_have_values() {
        for knots in
            [&[0, 0, 0, 0, 1, 2, 2, 5, 5, 5, 5][..], &[0, 1, 2, 3, 4, 5, 7, 8, 1 << 30, 1 << 40, 1 << 62]]
        {
            let knots = KnotVector::new(knots.iter().map(|&t| rational(t, 1)).collect()).unwrap();
            for (degree, ratio) in [(0, 2), (2, 3), (3, 1), (4, 5)] {
                let index = Index::from_ratio(integer(ratio)).unwrap();
                let basis = Basis::new(knots.clone(), degree, index).unwrap();
                for span in knots.spans() {
                    let at = BigInt::from(ratio);
                    let value =
                        |p: &Polynomial<Polynomial<BigInt>>| over_rationals(&p.map(|c| c.evaluate(&at)));
                    let symbolic = symbolic_quotients(&knots, degree, span).unwrap();
                    let pieces = symbolic.map(|g| {
                        RationalFunction::new(&value(&g.numerator), &value(&g.denominator)).unwrap()
                    });
                    assert_eq!(
                        pieces,
                        basis.active(span, &positive_coordinate(&knots, span).unwrap()).unwrap()
                    );
                }
            }
        }
    }

    #[test]
    fn at_infinity_there_is_one_factor_for_each_degree() {
        let knots = KnotVector::new((0..8).map(integer).collect()).unwrap();
        let factors = |alpha: &str| {
            let basis = Basis::new(knots.clone(), 3, alpha.parse().unwrap()).unwrap();
            knots
                .spans()
                .map(|span| OneDenominator::of(&basis, basis.index(), span).factors.len())
                .collect::<Vec<_>>()
        };
        assert_eq!(factors("inf"), [3; 7]);
        assert_eq!(factors("-1"), [3, 5, 5, 5, 5, 4, 3]);
    }

    /// Degree 1 on (0, 1) with r = p/q: the factor is q + pu, and 64 bits hold it up to 2(p + q) = 2^63 − 1.
    #[test]
    fn words_are_left_at_the_very_bound() {
        let near = |p: BigInt| Neighbourhood {
            gaps: vec![BigInt::ZERO, 1.into(), BigInt::ZERO],
            slopes: vec![(p, 1.into())],
            low: 0,
            j: 1,
            k: 1,
        };
        let edge: BigInt = (BigInt::from(1) << 62) - 2;
        let at_edge = near(edge.clone());
        assert_eq!(at_edge.short_quotients().map(long), Some(at_edge.quotients()));
        assert!(near(edge + 1).short_quotients().is_none());
        let edge = (BigInt::from(1) << 126) - 1;
        assert!(near(&edge / 2).in_words::<i128>().is_some());
        // Twice the largest factor no longer fits, which is asked for so that sums of two rises and falls do.
        assert!(near(&edge * 2).in_words::<i128>().is_none());
        // Degree 2, Bernstein: the middle function has the denominator (q + pu)^3, for the largest p with (p + 1)^3 < 2^127.
        let near = |p: i64| Neighbourhood {
            gaps: [0, 0, 1, 0, 0].map(BigInt::from).to_vec(),
            slopes: vec![(p.into(), 1.into())],
            low: 0,
            j: 2,
            k: 2,
        };
        let largest = 5_541_191_377_755_i64;
        let cube = |number: i64| BigInt::from(number).pow(3);
        let bound: BigInt = BigInt::from(1) << 127;
        assert!(cube(largest + 1) < bound && cube(largest + 2) >= bound);
        assert!(near(largest).in_words::<i128>().is_some());
        assert!(near(largest + 1).in_words::<i128>().is_none());
    }

    /// On open uniform knots for r = 1/3, in every width that there is: identical, and so many factors cancel as FLINT's gcd has found.
    #[test]
    fn factors_cancel_in_every_width() {
        let cancelled: [(i64, &[usize]); 5] = [
            (3, &[0, 0, 0, 0]),
            (5, &[0, 2, 2, 0, 0, 0]),
            (8, &[0, 2, 4, 6, 8, 4, 0, 0, 0]),
            (12, &[0, 2, 4, 6, 8, 12, 14, 12, 8, 4, 0, 0, 0]),
            (16, &[0, 2, 4, 6, 8, 16, 22, 26, 28, 26, 22, 16, 8, 4, 0, 0, 0]),
        ];
        for (k, expected) in cancelled {
            let inner = if k == 3 { 4 } else { 8 };
            let knots = (-k..=inner + k + 1).map(|t| integer(t.clamp(0, inner + 1))).collect();
            let knots = KnotVector::new(knots).unwrap();
            let span = knots.spans().nth(usize::try_from(inner / 2).unwrap()).unwrap();
            let k = usize::try_from(k).unwrap();
            let near = Neighbourhood::of_span(&knots, k, span, vec![(1.into(), 3.into())]);
            let short = near.short_quotients().map(long).unwrap();
            let count = |(c, function): (usize, &FactoredQuotient)| {
                (k + 1 - c) * (c + 1) - 1 - function.factors.len()
            };
            assert_eq!(short.values().iter().enumerate().map(count).collect::<Vec<_>>(), expected);
            assert_eq!(short, near.quotients());
        }
    }

    fn long(all: Active<FactoredQuotient<u64>>) -> Active<FactoredQuotient> {
        all.into_map(|FactoredQuotient { quotient, constant, factors }| {
            let factors = factors.into_iter().map(|(a, b)| (a.into(), b.into())).collect();
            FactoredQuotient { quotient, constant, factors }
        })
    }

    proptest! {
        /// In every width the functions are those in integers of any length: with gaps of 0, equal ones, such that factors have much in
        /// common, and such that nothing has.
        #[test]
        fn functions_in_digits_are_those_in_integers(
            k in 0_usize..9,
            gaps in prop::collection::vec(prop_oneof![
                Just(0_u64), Just(1), 1_u64..4, Just(6), 1_u64..100, (0_u32..55).prop_map(|e| 1 << e), 1_u64..(1 << 40)
            ], 1..20),
            slopes in prop::collection::vec(
                (prop_oneof![1_u64..5, 1_u64..1000, Just(1 << 20)], prop_oneof![1_u64..5, 1_u64..1000]),
                36,
            ),
            same in any::<bool>(),
            j in 0_usize..20,
        ) {
            let (j, k) = (j % gaps.len(), k.min(gaps.len() - 1));
            let mut gaps: Vec<BigInt> = gaps.into_iter().map(BigInt::from).collect();
            if gaps[j].is_zero() {
                gaps[j] = BigInt::from(1);
            }
            let count = if same { 1 } else { k * (k + 1) / 2 };
            let slopes = slopes.into_iter().take(count).map(|(p, q)| (p.into(), q.into())).collect();
            let near = Neighbourhood { gaps, slopes, low: 3, j: j + 3, k };
            let long_way = near.quotients();
            if let Some(short) = near.short_quotients() {
                prop_assert_eq!(long(short), long_way);
            } else {
                // Only long factors, or long products of them, are left to the other way.
                let length: BigInt = near.gaps.iter().sum();
                let steepest = near.slopes.iter().map(|(p, q)| p + q).max().unwrap_or_default();
                let all: BigInt = steepest * length * 2;
                prop_assert!(all.bits() * (k as u64 + 1) * (k as u64 + 1) > 63, "{near:?}");
            }
        }
    }
}
