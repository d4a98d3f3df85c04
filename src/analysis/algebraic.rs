//! Real numbers that are known by bounds, and the decimals that the bounds settle.

use std::cmp::Ordering;

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::Signed;

use crate::scalar::{
    IntegerPolynomial, Polynomial, RationalAlgebra, Ring, decimal, decimal_neighbours, integer, lcm,
    rationals_between, settled_digits,
};

use super::norm::norm;
use super::piece::Piece;
use super::roots::{IsolatedRoot, count_roots_between};

/// A real number between two bounds that can be brought closer.
pub trait Enclosed {
    /// (lo, hi) with lo ≤ number ≤ hi, equal if it is known exactly.
    fn bounds(&mut self) -> (BigRational, BigRational);

    /// Brings the bounds closer by some bits; `false` if they stay what they are.
    fn narrow(&mut self) -> bool;
}

/// How often bounds are narrowed on both sides of 0: a number that is 0 has no first digit to be found.
const LOOKS: usize = 512;

/// The decimal of a number to so many significant digits, each of them right: the bounds are narrowed until they
/// settle all. A number halfway between two decimals gets one digit more.
///
/// Where the bounds can't be brought closer there are as many digits as they settle, and if that is none, `LO to HI`
/// with decimals below and above the number.
#[must_use]
pub fn settled(number: &mut (impl Enclosed + ?Sized), digits: usize) -> String {
    let mut around_zero = 0;
    loop {
        let (lo, hi) = number.bounds();
        if decimal(&lo, digits) == decimal(&hi, digits) {
            return decimal(&lo, digits);
        }
        if lo.is_positive() || hi.is_negative() {
            // Whatever is not in the middle of two decimals has left it behind by now, or is as good as there.
            let close = (&hi - &lo) * integer(10).power(digits + 20) < lo.abs();
            if close && decimal(&lo, digits + 1) == decimal(&hi, digits + 1) {
                return decimal(&lo, digits + 1);
            }
        } else {
            around_zero += 1;
        }
        if around_zero > LOOKS || !number.narrow() {
            return settled_digits(&lo, &hi, digits).unwrap_or_else(|| {
                let (below, above) = (decimal_neighbours(&lo, digits).0, decimal_neighbours(&hi, digits).1);
                format!("{} to {}", decimal(&below, digits), decimal(&above, digits))
            });
        }
    }
}

/// The decimals of numbers, [`settled`] to so many digits, and all of them to more where two neighbours would look
/// alike: for each `at` with `differ(at)`, the numbers `at` and `at + 1` of the list must not be equal.
#[must_use]
pub fn settled_apart(
    numbers: &mut [impl Enclosed],
    digits: usize,
    differ: impl Fn(usize) -> bool,
) -> Vec<String> {
    let mut digits = digits;
    loop {
        let texts: Vec<_> = numbers.iter_mut().map(|number| settled(number, digits)).collect();
        let alike = |(at, pair): (usize, &[String])| differ(at) && pair[0] == pair[1];
        if !texts.windows(2).enumerate().any(alike) {
            return texts;
        }
        digits += 1 + digits / 8;
    }
}

/// The decimals of so many significant digits next below and next above a number; twice the same one, if the number is
/// known to be that.
#[must_use]
pub fn decimals_around(number: &mut impl Enclosed, digits: usize) -> (BigRational, BigRational) {
    let (mut looks, beyond) = (0, integer(10).power(digits + 30));
    loop {
        let (lo, hi) = number.bounds();
        let (below, above) = (decimal_neighbours(&lo, digits), decimal_neighbours(&hi, digits));
        if below == above {
            return below;
        }
        // One of these decimals itself, which is not seen from outside, has the next one on either side.
        looks += 1;
        if looks > LOOKS || (&hi - &lo) * &beyond < lo.abs() || !number.narrow() {
            return (below.0, above.1);
        }
    }
}

/// A real number: a rational one, or the value of a rational function at an isolated root.
///
/// ```
/// use knotproof::analysis::{Algebraic, positive_roots, settled};
/// use knotproof::scalar::{Polynomial, RationalFunction, rational};
///
/// let p = Polynomial::new(rational(-2, 1), [0, 1].map(|c| rational(c, 1)));
/// let u = RationalFunction::variable(&rational(1, 1));
/// let mut root = Algebraic::at(u, positive_roots(&p).remove(0));
/// assert_eq!(settled(&mut root, 12), "1.41421356237");
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Algebraic(Known);

#[derive(Debug, Clone, PartialEq)]
enum Known {
    Exactly(BigRational),
    At(Box<(Piece, IsolatedRoot)>),
    Between(BigRational, BigRational),
}

/// Bits by which bounds come closer at a time.
pub(super) const STEP: usize = 8;

/// So often before two numbers are held against each other otherwise.
const COMPARISONS: usize = 16;

impl Algebraic {
    /// The value of a function at a root, neither of which is rational: where the function has no pole.
    #[must_use]
    pub fn at(function: Piece, root: IsolatedRoot) -> Self {
        Self(Known::At(Box::new((function, root))))
    }

    /// A number of which no more will be known than two bounds.
    #[must_use]
    pub fn between(lo: BigRational, hi: BigRational) -> Self {
        Self(if lo == hi { Known::Exactly(lo) } else { Known::Between(lo, hi) })
    }

    /// The number, if it is known exactly.
    #[must_use]
    pub fn exact(&self) -> Option<&BigRational> {
        match &self.0 {
            Known::Exactly(value) => Some(value),
            Known::At(_) | Known::Between(..) => None,
        }
    }

    /// [`bounds`](Enclosed::bounds) at most `width` > 0 apart, or as close as they can be.
    #[must_use]
    pub fn bounds_within(&mut self, width: &BigRational) -> (BigRational, BigRational) {
        loop {
            let (lo, hi) = self.bounds();
            if !width.is_positive() || &hi - &lo <= *width || !self.narrow() {
                return (lo, hi);
            }
        }
    }

    /// Which of the two is greater, decided exactly; `None` for mere bounds that don't tell.
    ///
    /// Bounds that still meet after some 128 bits are a matter of two polynomials, each of which vanishes at one of the numbers: once their
    /// common enclosure holds one root of either, the numbers are equal if and only if those have it in common.
    ///
    /// ```
    /// use knotproof::analysis::{Algebraic, positive_roots};
    /// use knotproof::scalar::{Polynomial, RationalFunction, Ring, rational};
    ///
    /// // √2·√2·√2 and 2·√2, as functions of √2, and √8 as a root of its own.
    /// let root_of = |square: i64| {
    ///     let p = Polynomial::new(rational(-square, 1), [0, 1].map(|c| rational(c, 1)));
    ///     positive_roots(&p).remove(0)
    /// };
    /// let u = RationalFunction::variable(&rational(1, 1));
    /// let mut cube = Algebraic::at(u.power(3), root_of(2));
    /// let mut root = Algebraic::at(u.clone(), root_of(8));
    /// assert_eq!(cube.compare(&mut root), Some(std::cmp::Ordering::Equal));
    /// ```
    pub fn compare(&mut self, other: &mut Self) -> Option<Ordering> {
        let (mut looks, mut vanishing) = (0, None);
        loop {
            let ((lo, hi), (other_lo, other_hi)) = (self.bounds(), other.bounds());
            if hi < other_lo {
                return Some(Ordering::Less);
            }
            if other_hi < lo {
                return Some(Ordering::Greater);
            }
            if lo == hi && other_lo == other_hi {
                return Some(Ordering::Equal);
            }
            let equal = match (self.exact(), other.exact()) {
                (Some(own), _) => other.is(own),
                (None, Some(other)) => self.is(other),
                (None, None) => self.is_same(other),
            };
            if equal {
                return Some(Ordering::Equal);
            }
            looks += 1;
            if looks > COMPARISONS {
                let [own, others, common] = match &vanishing {
                    Some(all) => all,
                    None => {
                        let (own, others) = (self.vanishing()?, other.vanishing()?);
                        let common = own.gcd(&others);
                        vanishing.insert([own, others, common])
                    }
                };
                // A little more, so that neither number is at an end.
                let (lo, hi) = (lo.min(other_lo), hi.max(other_hi));
                let more = &hi - &lo;
                let ends = (lo - &more, hi + more);
                let roots = |p: &IntegerPolynomial| roots_between(p, &ends);
                if roots(own) == 1 && roots(others) == 1 && roots(common) == 1 {
                    return Some(Ordering::Equal);
                }
            }
            if [self.narrow(), other.narrow()] == [false, false] {
                return None;
            }
        }
    }

    /// Is it the same function at the same root, as far as that can be seen?
    fn is_same(&self, other: &Self) -> bool {
        match (&self.0, &other.0) {
            (Known::At(own), Known::At(other)) => own.0 == other.0 && own.1.is_same(&other.1),
            _ => false,
        }
    }

    /// A polynomial with this number among its roots; `None` for mere bounds.
    fn vanishing(&self) -> Option<IntegerPolynomial> {
        match &self.0 {
            Known::Exactly(value) => {
                Some(IntegerPolynomial::from_rational(&Polynomial::new(-value, [integer(1)])))
            }
            Known::At(at) => {
                let (piece, root) = &**at;
                let norm = norm(&root.polynomial(), piece.numerator(), piece.denominator());
                Some(IntegerPolynomial::from_rational(&norm).square_free())
            }
            Known::Between(..) => None,
        }
    }

    /// The same number, exactly where it is the simplest rational number between its bounds, or 0.
    pub(super) fn simplified(mut self) -> Self {
        if self.exact().is_some() {
            return self;
        }
        let (lo, hi) = self.bounds_within(&BigRational::new(1.into(), BigInt::from(1_u64 << 40)));
        let zero = (!lo.is_positive() && !hi.is_negative()).then(|| integer(0));
        match zero.or_else(|| rationals_between(&lo, &hi).next()) {
            Some(value) if self.is(&value) => value.into(),
            _ => self,
        }
    }

    /// Is it this rational number? P(ξ) = value·Q(ξ), decided exactly; of mere bounds it is not known.
    pub(super) fn is(&self, value: &BigRational) -> bool {
        match &self.0 {
            Known::Exactly(own) => own == value,
            Known::At(at) => {
                let (piece, root) = &**at;
                root.is_root_of(&piece.numerator().minus(&piece.denominator().scaled(value)))
            }
            Known::Between(..) => false,
        }
    }
}

impl From<BigRational> for Algebraic {
    fn from(value: BigRational) -> Self {
        Self(Known::Exactly(value))
    }
}

impl Enclosed for Algebraic {
    /// Refines the root until the denominator has a sign on its interval: it has one, since there is no pole.
    fn bounds(&mut self) -> (BigRational, BigRational) {
        match &mut self.0 {
            Known::Exactly(value) => (value.clone(), value.clone()),
            Known::Between(lo, hi) => (lo.clone(), hi.clone()),
            Known::At(at) => loop {
                if let Some(bounds) = enclose(&at.0, &at.1.interval()) {
                    break bounds;
                }
                at.1.refine();
            },
        }
    }

    fn narrow(&mut self) -> bool {
        let Known::At(at) = &mut self.0 else { return false };
        let width = (at.1.hi() - at.1.lo()) / BigInt::from(1_u32 << STEP);
        at.1.refine_to(&width);
        true
    }
}

/// The number of distinct roots in (a, b).
fn roots_between(p: &IntegerPolynomial, (a, b): &(BigRational, BigRational)) -> usize {
    // x = X/d makes integers of the ends, and c_i·d^(n−i) of the coefficients.
    let d = lcm(a.denom(), b.denom());
    let whole = |end: &BigRational| end.numer() * (&d / end.denom());
    let mut power = BigInt::from(1);
    let mut scaled = p.coefficients().to_vec();
    for c in scaled.iter_mut().rev() {
        *c *= &power;
        power *= &d;
    }
    count_roots_between(&scaled, &whole(a), &whole(b))
}

/// Bounds of P/Q on [lo, hi], 0 ≤ lo: P = P₊ − P₋ with coefficients ≥ 0 in both, which rise with u.
fn enclose(f: &Piece, (lo, hi): &(BigRational, BigRational)) -> Option<(BigRational, BigRational)> {
    let (p_lo, p_hi) = enclose_polynomial(f.numerator(), lo, hi);
    let (q_lo, q_hi) = enclose_polynomial(f.denominator(), lo, hi);
    if !q_lo.is_positive() {
        return None;
    }
    let lower = p_lo.over(if p_lo.is_negative() { &q_lo } else { &q_hi })?;
    let upper = p_hi.over(if p_hi.is_negative() { &q_hi } else { &q_lo })?;
    Some((lower, upper))
}

fn enclose_polynomial(
    p: &Polynomial<BigRational>,
    lo: &BigRational,
    hi: &BigRational,
) -> (BigRational, BigRational) {
    let part = |negative: bool| {
        let coefficients = p.coefficients().iter();
        let kept = coefficients.map(|c| if c.is_negative() == negative { c.clone() } else { integer(0) });
        kept.collect::<Vec<_>>()
    };
    let (positive, negative) = (part(false), part(true));
    let value = BigRational::value_of_polynomial;
    let lower = value(&positive, lo).plus(&value(&negative, hi));
    let upper = value(&positive, hi).plus(&value(&negative, lo));
    (lower, upper)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::positive_roots;
    use crate::scalar::{RationalFunction, parse_rational, rational};

    /// f(√2), for a polynomial f.
    fn at_root_of_two(f: &[BigRational]) -> Algebraic {
        let two = Polynomial::new(rational(-2, 1), [0, 1].map(|c| rational(c, 1)));
        let f = RationalFunction::from_polynomial(Polynomial::new(f[0].clone(), f[1..].iter().cloned()));
        Algebraic::at(f, positive_roots(&two).remove(0))
    }

    #[test]
    fn digits_are_settled_before_they_are_printed() {
        let number = |scale: &str, shift: &str| {
            at_root_of_two(&[parse_rational(shift).unwrap(), parse_rational(scale).unwrap()])
        };
        for (scale, shift, digits, expected) in [
            ("1", "0", 1, "1"),
            ("1", "0", 30, "1.41421356237309504880168872421"),
            ("-1e-9", "0", 3, "-1.41e-9"),
            // 10^-15·√2 above and below a number that the first digits can't tell it from, halfway between two decimals.
            ("1e-15", "5/2", 1, "3"),
            ("-1e-15", "5/2", 1, "2"),
            ("1e-30", "1", 10, "1.000000000"),
            ("-1e-30", "1", 10, "1.000000000"),
            ("-1e-30", "1", 34, "0.9999999999999999999999999999985858"),
        ] {
            assert_eq!(settled(&mut number(scale, shift), digits), expected);
        }
    }

    #[test]
    fn a_number_halfway_between_two_decimals_gets_one_digit_more() {
        // (√2)²/16 = 0.125.
        let mut eighth = at_root_of_two(&[0, 0, 1].map(|c| rational(c, 16)));
        assert_eq!(settled(&mut eighth, 2), "0.125");
        assert_eq!(settled(&mut eighth, 5), "0.12500");
        assert_eq!(settled(&mut Algebraic::from(rational(1, 8)), 2), "0.12");
    }

    #[test]
    fn bounds_that_stay_settle_what_they_can() {
        let text = |lo: &str, hi: &str| {
            let [lo, hi] = [lo, hi].map(|x| parse_rational(x).unwrap());
            settled(&mut Algebraic::between(lo, hi), 4)
        };
        assert_eq!(text("3.1412", "3.1431"), "3.14");
        assert_eq!(text("0.12345", "0.98765"), "0.1234 to 0.9877");
        assert_eq!(text("-1/3", "1/3"), "-0.3334 to 0.3334");
        assert_eq!(text("1/3", "1/3"), "0.3333");
    }

    #[test]
    fn a_number_that_is_0_ends_the_search_for_its_first_digit() {
        // (√2)² − 2.
        let text = settled(&mut at_root_of_two(&[-2, 0, 1].map(|c| rational(c, 1))), 3);
        let (below, above) = text.split_once(" to ").unwrap();
        assert!(below.starts_with('-') && !above.starts_with('-'), "{text}");
    }

    #[test]
    fn neighbours_that_differ_look_different() {
        let close = |shift: &str| at_root_of_two(&[parse_rational(shift).unwrap(), rational(1, 1)]);
        let mut numbers = [close("0"), close("1e-25"), close("1e-25"), close("0")];
        let texts = settled_apart(&mut numbers, 10, |at| at != 1);
        assert!(texts[0] < texts[1] && texts[1] == texts[2] && texts[2] > texts[3], "{texts:?}");
        let texts = settled_apart(&mut numbers, 10, |_| false);
        assert!(texts.iter().all(|text| text == "1.414213562"), "{texts:?}");
    }

    #[test]
    fn decimals_on_both_sides_of_a_number() {
        let around = |number: &mut Algebraic| decimals_around(number, 3);
        let decimals = |lo: i64, hi: i64| (rational(lo, 100), rational(hi, 100));
        assert_eq!(around(&mut at_root_of_two(&[0, 1].map(|c| rational(c, 1)))), decimals(141, 142));
        assert_eq!(around(&mut rational(5, 4).into()), decimals(125, 125));
        assert_eq!(around(&mut rational(4, 3).into()), decimals(133, 134));
        // (√2)²: 2, but that is not seen.
        assert_eq!(around(&mut at_root_of_two(&[0, 0, 1].map(|c| rational(c, 1)))).1, rational(201, 100));
    }
}
