//! Where one function rises and where it falls, as signs: how often it turns, without the places.

use std::cmp::Ordering;

use num_bigint::BigInt;
use num_traits::ToPrimitive;

use crate::scalar::{BallPolynomial, ScaleBy};
use crate::spline::{Factors, FractionFree, Triangle};

use super::decision::sign_sequence;
use super::extremum::{ExtremumKind, turns};
use super::integer_polynomial::IntegerPolynomial;
use super::local_knots::{LocalKnots, is_continuous};
use super::sign::Sign;

/// The signs of the derivative of one G_i^k, span by span.
///
/// Exact and for every x. On each span between the first and the last the slope P′Q − PQ′ is computed in floats with a bound of their
/// error first; where the signs of its coefficients leave a choice, it is computed over integers, and its roots are isolated.
///
/// ```
/// use knotproof::analysis::{LocalKnots, Monotonicity, Sign};
/// use num_bigint::BigInt;
///
/// // G_2³ on (0, 0, 0, 0, 1, 2, 4, 4) for α = 5/2 has the local knots 0, 0, 1, 2, 4 and r = 5/3.
/// let gaps = [0, 1, 1, 2].map(BigInt::from).to_vec();
/// let monotonicity = Monotonicity::of(&LocalKnots::new(gaps, (5.into(), 3.into()))?);
/// assert_eq!(monotonicity.local_maxima(), Some(2));
/// // Its first span is empty; on the second and the third it rises, then falls.
/// assert_eq!(monotonicity.spans()[1].signs, [Sign::Positive, Sign::Negative]);
/// # Ok::<(), knotproof::analysis::LocalKnotsError>(())
/// ```
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Monotonicity {
    spans: Vec<SpanMonotonicity>,
    continuous: bool,
}

/// The signs of the derivative on one span.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SpanMonotonicity {
    /// The number s of the span [t_{i+s}, t_{i+s+1}).
    pub span: usize,
    /// The signs between the points of the open span where the derivative changes its sign, from left to right:
    /// two neighbours are never equal. A single [`Sign::Zero`] if the function is constant on the span.
    pub signs: Vec<Sign>,
    /// How they were found.
    pub route: Route,
}

/// How the signs on a span were decided. All ways are exact.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Route {
    /// Without computing: on [t_i, t_{i+1}], if that is not empty, G_i^k is the product of its weights w_i^d, d = 1..k,
    /// each of which rises, and on [t_{i+k}, t_{i+k+1}] the product of 1 − w_{i+k+1−d}^d, each of which
    /// falls.
    Product,
    /// By intervals around floats, which are given by a relative error: their signs sufficed.
    Intervals,
    /// By integers, since the intervals left a choice.
    Integers,
}

impl Monotonicity {
    /// That of the function with these local knots; gaps ≥ 0 and p, q > 0, as [`LocalKnots`] asks.
    #[must_use]
    pub fn of(knots: &LocalKnots<BigInt>) -> Self {
        let (mut by_floats, k) = (Floats::of(knots), knots.degree());
        let on_span = |span: usize| {
            if k > 0 && (span == 0 || span == k) {
                let sign = if span == 0 { Sign::Positive } else { Sign::Negative };
                return Some(SpanMonotonicity { span, signs: vec![sign], route: Route::Product });
            }
            match by_floats.slope_signs(span).and_then(certain_signs) {
                Some(signs) => Some(SpanMonotonicity { span, signs, route: Route::Intervals }),
                None => {
                    let signs =
                        sign_sequence(&IntegerPolynomial::from_integer(&knots.on_span(span)?.slope()));
                    Some(SpanMonotonicity { span, signs, route: Route::Integers })
                }
            }
        };
        Self { spans: knots.spans().filter_map(on_span).collect(), continuous: is_continuous(knots.gaps()) }
    }

    /// The spans that are not empty, from left to right.
    #[must_use]
    pub fn spans(&self) -> &[SpanMonotonicity] {
        &self.spans
    }

    /// Is the function continuous, 0 outside of its support? It jumps where a knot has multiplicity k + 1, that
    /// is if its first k gaps are empty, or its last k. Then it lives on one span.
    #[must_use]
    pub fn continuous(&self) -> bool {
        self.continuous
    }

    /// The number of local maxima of a continuous function; `None` if it is not continuous, since then it depends
    /// on what the function is taken for outside of its support ([`Shape`](super::Shape) says that).
    ///
    /// A plateau with smaller values on both sides counts once.
    #[must_use]
    pub fn local_maxima(&self) -> Option<usize> {
        self.turns(ExtremumKind::Maximum)
    }

    /// The number of local minima inside the support of a continuous function; `None` if it is not continuous.
    ///
    /// A plateau with larger values on both sides counts once.
    #[must_use]
    pub fn local_minima(&self) -> Option<usize> {
        self.turns(ExtremumKind::Minimum)
    }

    /// How often the function turns in this way.
    fn turns(&self, kind: ExtremumKind) -> Option<usize> {
        let signs = self.spans.iter().flat_map(|span| span.signs.iter().copied());
        self.continuous.then(|| turns(signs).filter(|turn| *turn == kind).count())
    }
}

/// The function in floats, and room for it, span after span.
struct Floats {
    gaps: Vec<f64>,
    ratio: (f64, f64),
    factors: Factors<(f64, f64)>,
    triangle: Triangle<BallPolynomial>,
    one: BallPolynomial,
    denominator: BallPolynomial,
    room: Vec<f64>,
}

impl Floats {
    fn of(knots: &LocalKnots<BigInt>) -> Self {
        // What is longer than any float is ∞.
        let float = |number: &BigInt| number.to_f64().unwrap_or(f64::INFINITY);
        let gaps: Vec<f64> = knots.gaps().iter().map(float).collect();
        let (p, q) = knots.ratio();
        let ratio = (float(p), float(q));
        // No factor, and nothing that it is computed from, is larger than this; up to 2^53 whole numbers are floats. Else two roundings
        // at most of a gap and of p or q each, one for each gap that is added, and one each for a product and the sum of two.
        let largest = (ratio.0 + ratio.1) * gaps.iter().sum::<f64>();
        let roundings = if largest < EXACT { 0 } else { knots.gaps().len() + 7 };
        // The largest denominator has (s + 1)(w + 1) − 1 factors, s + w = k.
        let k = knots.degree();
        let one = BallPolynomial::one(
            u32::try_from(roundings).unwrap_or(u32::MAX),
            (k / 2 + 1) * (k.div_ceil(2) + 1),
        );
        Self {
            gaps,
            ratio,
            factors: Factors::empty(k),
            triangle: Triangle::new(one.clone()),
            denominator: one.clone(),
            one,
            room: Vec::new(),
        }
    }

    /// The signs of the coefficients of the slope on a span, as far as they are certain.
    fn slope_signs(&mut self, span: usize) -> Option<impl Iterator<Item = Option<Ordering>>> {
        let Self { gaps, ratio, factors, triangle, one, denominator, room } = self;
        factors.fill_in_positive_coordinate(gaps, span, std::slice::from_ref(ratio))?;
        triangle.run(&FractionFree::new(factors, one), factors.span(), factors.degree(), gaps.len());
        denominator.clone_from(one);
        denominator.scale_by(factors.denominator(0));
        Some(BallPolynomial::slope_signs(triangle.values().first()?, denominator, room))
    }
}

/// Half of what is exact, so that the roundings of a sum of floats do not matter.
const EXACT: f64 = (1_u64 << 52) as f64;

/// The signs on (0, ∞) of every polynomial with coefficients of these signs, `None` where it may have any, if Descartes' rule
/// shows them.
///
/// Let c_a and c_b be the first and the last coefficient that may be other than 0, and both of certain sign: so they are
/// the lowest and the highest term of every such polynomial, and its signs close to 0 and to ∞. Let v be the
/// largest number of sign variations that any choice of signs for the coefficients has, 0 included where one is not certain.
/// By Descartes' rule there are at most v positive roots, with multiplicity, and as many as
/// v up to an even number. If v ≤ 1, there is one simple root if the signs of c_a and c_b differ, and none if they
/// agree.
///
/// v is found in one pass: the largest number among the choices so far whose last sign is +, and that for −.
/// A 0 adds nothing.
fn certain_signs(slope: impl Iterator<Item = Option<Ordering>>) -> Option<Vec<Sign>> {
    let (mut lowest, mut highest) = (None, None);
    let (mut ending_in_plus, mut ending_in_minus) = (None, None);
    for sign in slope.filter(|sign| *sign != Some(Ordering::Equal)) {
        highest = Some(sign);
        lowest = lowest.or(highest);
        let grown = |same: Option<usize>, other: Option<usize>| same.max(other.map(|v| v + 1)).or(Some(0));
        (ending_in_plus, ending_in_minus) = match sign {
            Some(Ordering::Less) => (None, grown(ending_in_minus, ending_in_plus)),
            Some(_) => (grown(ending_in_plus, ending_in_minus), None),
            None => (grown(ending_in_plus, ending_in_minus), grown(ending_in_minus, ending_in_plus)),
        };
    }
    let Some((lowest, highest)) = lowest.zip(highest) else { return Some(vec![Sign::Zero]) };
    let strict = |sign: Ordering| if sign.is_lt() { Sign::Negative } else { Sign::Positive };
    let (at_zero, at_infinity) = (strict(lowest?), strict(highest?));
    let most_variations = ending_in_plus.max(ending_in_minus)?;
    (most_variations <= 1)
        .then(|| if at_zero == at_infinity { vec![at_zero] } else { vec![at_zero, at_infinity] })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A slope by a word: certain signs, exact zeros, and `?` for what may be either.
    fn signs(word: &str) -> Option<Vec<Sign>> {
        let sign = |c: char| match c {
            '+' => Some(Ordering::Greater),
            '-' => Some(Ordering::Less),
            '0' => Some(Ordering::Equal),
            _ => None,
        };
        certain_signs(word.chars().map(sign))
    }

    #[test]
    fn signs_that_every_choice_has() {
        let (plus, minus) = (Sign::Positive, Sign::Negative);
        for word in ["+", "0+", "++0+", "00+00+", "+0"] {
            assert_eq!(signs(word), Some(vec![plus]), "{word}");
        }
        for word in ["+-", "+?-", "0+?0-", "++-", "+0-0", "+++?---"] {
            assert_eq!(signs(word), Some(vec![plus, minus]), "{word}");
        }
        assert_eq!((signs("-"), signs("--?+")), (Some(vec![minus]), Some(vec![minus, plus])));
        assert_eq!((signs("0"), signs("000")), (Some(vec![Sign::Zero]), Some(vec![Sign::Zero])));
        assert_eq!(signs(""), Some(vec![Sign::Zero]));
    }

    #[test]
    fn signs_that_are_left_open() {
        // Two unknown coefficients between + and − may add two variations; a lowest or highest one that may be 0
        // leaves the sign at an end open; two variations allow no root or two.
        for word in ["+??-", "+?+", "?+", "+?", "?", "+-+", "+?-?-", "-?+-", "?0"] {
            assert_eq!(signs(word), None, "{word}");
        }
    }
}
