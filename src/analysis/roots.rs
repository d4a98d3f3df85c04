//! The positive roots of a polynomial, isolated exactly.

use std::sync::Arc;

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

use crate::scalar::{Polynomial, spend};

use super::descartes;
use super::integer_polynomial::IntegerPolynomial;
use super::sign::{Sign, sign_changes};

/// A root u in (0, ∞) of a polynomial, known by an interval for y = u/(1 + u) in (0, 1).
///
/// Either `lo` = `hi`, and the root is that y exactly, or `lo` < `hi` are dyadic rationals with 0 < lo, hi < 1,
/// and the polynomial has exactly one root in the open interval (lo, hi) and none at its ends. On a span the
/// point is x = t_j + y·(t_{j+1} − t_j): y is the affine coordinate there, u the positive one.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct IsolatedRoot {
    lo: BigRational,
    hi: BigRational,
    /// The sign of the polynomial just below the root; it is the opposite one just above.
    below: Sign,
    /// A divisor with the same positive roots, all of them simple, and without a root at 0.
    polynomial: Arc<IntegerPolynomial>,
}

impl IsolatedRoot {
    /// The lower end of the interval for y.
    #[must_use]
    pub fn lo(&self) -> &BigRational {
        &self.lo
    }

    /// The upper end of the interval for y.
    #[must_use]
    pub fn hi(&self) -> &BigRational {
        &self.hi
    }

    /// (lo/(1 − lo), hi/(1 − hi)): the interval for u.
    #[must_use]
    pub fn interval(&self) -> (BigRational, BigRational) {
        (to_positive(&self.lo), to_positive(&self.hi))
    }

    /// Is it the same root of the same polynomial? Both intervals hold one root each; if that is one, it is where they meet.
    pub(super) fn is_same(&self, other: &Self) -> bool {
        if self.polynomial != other.polynomial {
            return false;
        }
        let (lo, hi) = ((&self.lo).max(&other.lo), (&self.hi).min(&other.hi));
        lo < hi && self.sign_at(lo) != self.sign_at(hi)
    }

    /// A polynomial in u with this root, a simple one, among its roots.
    pub(super) fn polynomial(&self) -> Polynomial<BigRational> {
        let mut coefficients = self.polynomial.coefficients().iter().cloned().map(BigRational::from_integer);
        Polynomial::new(coefficients.next().unwrap_or_default(), coefficients)
    }

    /// y, if it is known exactly.
    #[must_use]
    pub fn exact(&self) -> Option<&BigRational> {
        (self.lo == self.hi).then_some(&self.lo)
    }

    /// Halves the interval, by the sign of the polynomial in its middle; hits the root exactly if that
    /// is the middle.
    pub fn refine(&mut self) {
        if self.lo == self.hi {
            return;
        }
        let middle = middle(&self.lo, &self.hi);
        match self.sign_at(&middle) {
            Sign::Zero => (self.lo, self.hi) = (middle.clone(), middle),
            sign if sign == self.below => self.lo = middle,
            _ => self.hi = middle,
        }
    }

    /// Halves the interval for y until hi − lo ≤ `width`, for `width` > 0.
    pub fn refine_to(&mut self, width: &BigRational) {
        while width.is_positive() && &self.hi - &self.lo > *width {
            self.refine();
        }
    }

    /// The root u if it is rational, decided exactly; afterwards such a root is [`exact`](Self::exact).
    ///
    /// Most polynomials have no root modulo some small prime, and then no rational one. Otherwise the denominator of a
    /// rational root divides the leading coefficient c, so c·u is an integer: the interval is refined until it holds one
    /// candidate at most.
    pub fn rational(&mut self) -> Option<BigRational> {
        let polynomial = Arc::clone(&self.polynomial);
        let scale = polynomial.coefficients().last()?.abs();
        if self.lo < self.hi && !polynomial.may_have_rational_root() {
            return None;
        }
        let mut bits = FIRST_BITS;
        while self.lo < self.hi {
            let [(a, d), (b, e)] = [&self.lo, &self.hi].map(positive_parts);
            let candidate: BigInt = (a * &scale).div_floor(&d) + 1;
            let end = b * &scale;
            if &candidate * &e >= end {
                return None;
            }
            if (&candidate + 1_u32) * e < end {
                bits = self.interpolate(bits);
                continue;
            }
            let u = BigRational::new(candidate, scale.clone());
            if polynomial.sign_at(u.numer(), u.denom()) != Sign::Zero {
                return None;
            }
            let y = &u / (&u + BigRational::one());
            (self.lo, self.hi) = (y.clone(), y);
        }
        Some(to_positive(&self.lo))
    }

    /// Is this root one of p's as well? Decided exactly: the greatest common divisor of p and the polynomial
    /// has simple positive roots only, so it has one in (lo, hi) if and only if its sign changes there.
    #[must_use]
    pub fn is_root_of(&self, p: &Polynomial<BigRational>) -> bool {
        let p = IntegerPolynomial::from_rational(p);
        if p.is_zero() {
            return true;
        }
        if self.lo == self.hi {
            return sign_in_unit(&p, &self.lo) == Sign::Zero;
        }
        let common = p.gcd(&self.polynomial);
        sign_in_unit(&common, &self.lo) != sign_in_unit(&common, &self.hi)
    }

    /// Quadratic interval refinement (Abbott 2006): the interval is cut into 2^bits parts, the line through the values at its ends says
    /// which of them holds the root, and two signs prove it. Then the next step cuts into twice as many bits, and after a guess that was
    /// wrong into half as many; these are returned.
    fn interpolate(&mut self, bits: u64) -> u64 {
        if bits < 2 {
            self.refine();
            return FIRST_BITS;
        }
        let depth = |y: &BigRational| y.denom().trailing_zeros().unwrap_or(0);
        let common = depth(&self.lo).max(depth(&self.hi)) + bits;
        let [lo, hi] = [&self.lo, &self.hi].map(|y| y.numer() << (common - depth(y)));
        let one = BigInt::one() << common;
        // Σ c_i a^i (2^common − a)^(n−i): the value at y = a/2^common, up to one positive factor.
        let value = |a: &BigInt| {
            let rest = &one - a;
            let (mut value, mut power) = (BigInt::zero(), BigInt::one());
            for c in self.polynomial.coefficients().iter().rev() {
                value = value * a + c * &power;
                power *= &rest;
            }
            value
        };
        let (at_lo, at_hi) = (value(&lo), value(&hi));
        let part: BigInt = (&hi - &lo) >> bits;
        let last = (BigInt::one() << bits) - 1;
        let index = ((&at_lo << bits) / (&at_lo - &at_hi)).clamp(BigInt::zero(), last);
        let start = &lo + &part * index;
        let end = &start + &part;
        let sign = |a: &BigInt| match a {
            a if *a == lo => self.below,
            a if *a == hi => self.below.opposite(),
            a => Sign::of(&value(a)),
        };
        let signs = [sign(&start), sign(&end)];
        let hit = [&start, &end].into_iter().zip(signs).find(|(_, sign)| *sign == Sign::Zero);
        if let Some((place, _)) = hit {
            let y = dyadic(place.clone(), common);
            (self.lo, self.hi) = (y.clone(), y);
        } else if signs == [self.below, self.below.opposite()] {
            (self.lo, self.hi) = (dyadic(start, common), dyadic(end, common));
            return bits * 2;
        } else {
            self.refine();
            return bits / 2;
        }
        bits
    }

    fn sign_at(&self, y: &BigRational) -> Sign {
        sign_in_unit(&self.polynomial, y)
    }
}

/// Into how many parts, as a power of 2, an interval is cut at first.
const FIRST_BITS: u64 = 4;

/// The sign at u = y/(1 − y) for 0 ≤ y ≤ 1.
fn sign_in_unit(p: &IntegerPolynomial, y: &BigRational) -> Sign {
    let (a, d) = positive_parts(y);
    p.sign_at(a, &d)
}

/// (a, d) for a/d = u = y/(1 − y), in lowest terms as y is.
fn positive_parts(y: &BigRational) -> (&BigInt, BigInt) {
    (y.numer(), y.denom() - y.numer())
}

/// u = y/(1 − y), for y < 1.
fn to_positive(y: &BigRational) -> BigRational {
    let (a, d) = positive_parts(y);
    BigRational::new_raw(a.clone(), d)
}

/// place/2^depth.
fn dyadic(place: BigInt, depth: u64) -> BigRational {
    let common = place.trailing_zeros().unwrap_or(depth).min(depth);
    BigRational::new_raw(place >> common, BigInt::one() << (depth - common))
}

/// (lo + hi)/2, for dyadic rationals.
fn middle(lo: &BigRational, hi: &BigRational) -> BigRational {
    let depth = |y: &BigRational| y.denom().trailing_zeros().unwrap_or(0);
    let common = depth(lo).max(depth(hi));
    let at = |y: &BigRational| y.numer() << (common - depth(y));
    dyadic(at(lo) + at(hi), common + 1)
}

/// The roots of p in (0, ∞), each once, from left to right in disjoint intervals (ends may be shared). A root
/// at 0 is not among them. The polynomial 0 has no isolated root.
///
/// Descartes' rule of signs with subdivision (Collins & Akritas 1976; Rouillier & Zimmermann 2004), on the
/// square-free part and in integers. The coefficients of p in u are, up to binomial factors, the Bernstein
/// coefficients in y = u/(1 + u): so their sign changes bound the number of roots with y in (0, 1), exactly if
/// there are 0 or 1. Otherwise (0, 1) is halved: with v the positive coordinate of a half,
///
/// left: p_L(v) = Σ c_i v^i (v + 2)^(n−i),  right: p_R(v) = p(1 + 2v),
///
/// and the middle u = 1 is a root if and only if p(1) = 0. The roots being simple, it ends by the two-circle
/// theorem.
///
/// ```
/// use knotproof::analysis::positive_roots;
/// use knotproof::scalar::{Polynomial, rational};
///
/// // (u − 1)(u² − 2): u = 1 is y = 1/2 and is found exactly, √2 lies in (1, ∞).
/// let p = Polynomial::new(rational(2, 1), [-2, -1, 1].map(|c| rational(c, 1)));
/// let roots = positive_roots(&p);
/// assert_eq!(roots.len(), 2);
/// assert_eq!(roots[0].exact(), Some(&rational(1, 2)));
/// let (lo, hi) = roots[1].interval();
/// assert!(&lo * &lo < rational(2, 1) && rational(2, 1) < &hi * &hi);
/// ```
#[must_use]
pub fn positive_roots(p: &Polynomial<BigRational>) -> Vec<IsolatedRoot> {
    roots_of(IntegerPolynomial::from_rational(p))
}

/// The number of distinct roots of p in (0, ∞); 0 for the polynomial 0, which has no isolated one.
#[must_use]
pub fn count_positive_roots(p: &Polynomial<BigRational>) -> usize {
    count_of(IntegerPolynomial::from_rational(p))
}

/// The number of distinct roots of Σ c_i x^i in the open interval (a, b), whatever their multiplicities; 0 for the
/// polynomial 0, which has no isolated one.
///
/// With fractions, multiply: x = X/d makes integers of the ends, and c_i·d^(n−i) of the coefficients.
///
/// ```
/// use knotproof::analysis::count_roots_between;
/// use num_bigint::BigInt;
///
/// // (x − 1)²(x − 3): the ends do not count.
/// let p = [-3, 7, -5, 1].map(BigInt::from);
/// let count = |a: i64, b: i64| count_roots_between(&p, &a.into(), &b.into());
/// assert_eq!([count(0, 4), count(0, 3), count(1, 3)], [2, 1, 0]);
/// ```
#[must_use]
pub fn count_roots_between(coefficients: &[BigInt], a: &BigInt, b: &BigInt) -> usize {
    descartes::count_between(coefficients, a, b)
        .unwrap_or_else(|| if a < b { count_of(moved_to_positive(coefficients, a, b)) } else { 0 })
}

/// Σ c_i (a + bu)^i (1 + u)^(n−i) up to a positive factor: the roots in (a, b) become positive ones, by
/// x = (a + bu)/(1 + u).
fn moved_to_positive(coefficients: &[BigInt], a: &BigInt, b: &BigInt) -> IntegerPolynomial {
    let mut c = coefficients.to_vec();
    shift(&mut c, |lower, upper| *lower += upper * a);
    let (width, mut power) = (b - a, BigInt::one());
    for c in &mut c {
        *c *= &power;
        power *= &width;
    }
    c.reverse();
    shift(&mut c, |lower, upper| *lower += upper);
    c.reverse();
    IntegerPolynomial::primitive(c)
}

/// The number of distinct roots in (0, ∞).
fn count_of(p: IntegerPolynomial) -> usize {
    // Without variations, or with one, Descartes' rule is exact, and multiplicities do not matter.
    match sign_changes(p.coefficients()) {
        few @ (0 | 1) => few,
        _ => descartes::count_positive(p.coefficients())
            .unwrap_or_else(|| isolate(&p.without_root_at_zero().square_free()).len()),
    }
}

/// [`positive_roots`] of a polynomial that is in integers already.
pub(super) fn roots_of(p: IntegerPolynomial) -> Vec<IsolatedRoot> {
    let p = p.without_root_at_zero();
    let polynomial = Arc::new(match sign_changes(p.coefficients()) {
        0 => return Vec::new(),
        // By Descartes' rule there is one positive root, and it is simple.
        1 => p,
        _ => p.square_free(),
    });
    // All positive roots are simple: the sign alternates from one to the next, beginning with that at 0.
    let mut below = polynomial.coefficients().first().map_or(Sign::Zero, Sign::of);
    let intervals = isolate(&polynomial);
    let exact: Vec<BigRational> =
        intervals.iter().filter(|(lo, hi)| lo == hi).map(|(lo, _)| lo.clone()).collect();
    let mut roots = Vec::with_capacity(intervals.len());
    for (lo, hi) in intervals {
        let mut root = IsolatedRoot { lo, hi, below, polynomial: Arc::clone(&polynomial) };
        below = below.opposite();
        // An interval next to a root that was found exactly has it as its end, and the first and the last
        // may end at y = 0 and y = 1: they shrink until they do not.
        let forbidden = |end: &BigRational| end.is_zero() || end.is_one() || exact.contains(end);
        while root.lo < root.hi && (forbidden(&root.lo) || forbidden(&root.hi)) {
            root.refine();
        }
        roots.push(root);
    }
    roots
}

/// An interval [place/2^depth, (place + 1)/2^depth] for y, or the root place/2^depth itself.
enum Task {
    /// The polynomial in the positive coordinate of the interval, with no root at its ends.
    Search { coefficients: Vec<BigInt>, place: BigInt, depth: u64 },
    /// A root between two halves.
    Exact { place: BigInt, depth: u64 },
}

/// Intervals for y with one root each, lo = hi where it is exact; for a square-free polynomial without a root
/// at 0. An interval may end at a root that another entry holds exactly.
fn isolate(polynomial: &IntegerPolynomial) -> Vec<(BigRational, BigRational)> {
    if let [constant, leading] = polynomial.coefficients() {
        // u = −c₀/c₁, that is y = c₀/(c₀ − c₁).
        let y = BigRational::new(constant.clone(), constant - leading);
        return if constant.is_negative() == leading.is_negative() {
            Vec::new()
        } else {
            vec![(y.clone(), y)]
        };
    }
    match descartes::isolate_positive(polynomial.coefficients()) {
        Some(found) => found.iter().map(|root| (root.lo(), root.hi())).collect(),
        None => bisect(polynomial.coefficients().to_vec()),
    }
}

/// [`isolate`] in integers of any length.
fn bisect(coefficients: Vec<BigInt>) -> Vec<(BigRational, BigRational)> {
    let mut tasks = vec![Task::Search { coefficients, place: BigInt::zero(), depth: 0 }];
    let mut found = Vec::new();
    while let Some(task) = tasks.pop() {
        spend();
        match task {
            Task::Exact { place, depth } => {
                let y = dyadic(place, depth);
                found.push((y.clone(), y));
            }
            Task::Search { coefficients, place, depth } => match sign_changes(&coefficients) {
                0 => {}
                1 => found.push((dyadic(place.clone(), depth), dyadic(place + 1, depth))),
                _ => {
                    let (left, right, middle) = halves(coefficients);
                    let (start, depth) = (place * 2, depth + 1);
                    let after: BigInt = &start + 1;
                    tasks.push(Task::Search { coefficients: right, place: after.clone(), depth });
                    if middle {
                        tasks.push(Task::Exact { place: after, depth });
                    }
                    tasks.push(Task::Search { coefficients: left, place: start, depth });
                }
            },
        }
    }
    found
}

/// (p_L, p_R, p(1) = 0): the halves of an interval, with a root in the middle divided out of both.
fn halves(coefficients: Vec<BigInt>) -> (Vec<BigInt>, Vec<BigInt>, bool) {
    let mut right = coefficients.clone();
    shift_and_double(&mut right);
    // Σ c_i v^i (v + 2)^(n−i): in reverse, p(1 + 2w) of the reversed polynomial.
    let mut left = coefficients;
    left.reverse();
    shift_and_double(&mut left);
    let middle = left.first().is_some_and(Zero::is_zero);
    if middle {
        left.remove(0);
        right.remove(0);
    }
    left.reverse();
    remove_powers_of_two(&mut left);
    remove_powers_of_two(&mut right);
    (left, right, middle)
}

/// p(1 + 2v): the Taylor shift by 1, then c_i·2^i.
fn shift_and_double(c: &mut [BigInt]) {
    shift(c, |lower, upper| *lower += upper);
    for (i, c) in c.iter_mut().enumerate() {
        *c <<= i;
    }
}

/// Horner's rule: with `add` c_i += m·c_{i+1}, the Taylor shift by m.
fn shift(c: &mut [BigInt], add: impl Fn(&mut BigInt, &BigInt)) {
    for start in 0..c.len() {
        for i in (start..c.len() - 1).rev() {
            let (low, high) = c.split_at_mut(i + 1);
            add(&mut low[i], &high[0]);
        }
    }
}

fn remove_powers_of_two(coefficients: &mut [BigInt]) {
    let powers = coefficients.iter().filter_map(BigInt::trailing_zeros).min().unwrap_or(0);
    if powers > 0 {
        for c in coefficients {
            *c >>= powers;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::descartes::isolate_between;
    use super::*;
    use crate::scalar::{Ring, integer, rational};
    use proptest::prelude::*;

    fn polynomial(coefficients: &[i64]) -> Polynomial<BigRational> {
        let mut coefficients = coefficients.iter().map(|&c| rational(c, 1));
        Polynomial::new(coefficients.next().unwrap(), coefficients)
    }

    #[test]
    fn halves_are_the_formulas_of_the_documentation() {
        // p = 1 − 3u + 5u²: p_L = (v+2)² − 3v(v+2) + 5v² = 4 − 2v + 3v², p_R = p(1+2v) = 3 + 14v + 20v².
        let integers = |list: [i64; 3]| list.map(BigInt::from).to_vec();
        let (left, right, middle) = halves(integers([1, -3, 5]));
        assert_eq!((left, right, middle), (integers([4, -2, 3]), integers([3, 14, 20]), false));
    }

    #[test]
    fn a_trinomial_that_another_root_counter_got_wrong() {
        let p = polynomial(&[52, 0, 0, -304, 0, 0, 0, 0, -23]);
        assert_eq!(count_positive_roots(&p), 1);
        let (_, hi) = positive_roots(&p)[0].interval();
        assert!(hi <= integer(1));
        // The same on (0, 1) itself: x = v/(1 + v), times (1 + v)⁸.
        let one_plus = polynomial(&[1, 1]);
        let term = |c: i64, i: usize| {
            polynomial(&[0, 1]).power(i).times(&one_plus.power(8 - i)).scaled(&rational(c, 1))
        };
        let on_unit = term(52, 0).plus(&term(-304, 3)).plus(&term(-23, 8));
        assert_eq!(count_positive_roots(&on_unit), 1);
        assert_eq!(positive_roots(&on_unit).len(), 1);
    }

    #[test]
    fn exact_roots_and_their_neighbours_do_not_touch() {
        // u = 1 (y = 1/2) and u = 1/3 (y = 1/4), next to √(9/10) and to 0.
        let p = polynomial(&[-1, 1]).times(&polynomial(&[-1, 3])).times(&polynomial(&[-9, 0, 10]));
        let p = p.times(&polynomial(&[0, 0, 1]));
        let roots = positive_roots(&p);
        assert_eq!(roots.len(), 3);
        assert_eq!(roots[0].exact(), Some(&rational(1, 4)));
        assert_eq!(roots[2].exact(), Some(&rational(1, 2)));
        let (lo, hi) = (roots[1].lo(), roots[1].hi());
        assert!(rational(1, 4) < *lo && lo < hi && *hi < rational(1, 2));
    }

    #[test]
    fn refining_keeps_the_root() {
        let mut root = positive_roots(&polynomial(&[-2, 0, 1])).remove(0);
        root.refine_to(&rational(1, 1 << 40));
        assert!(root.hi() - root.lo() <= rational(1, 1 << 40));
        let (lo, hi) = root.interval();
        assert!(&lo * &lo < integer(2) && integer(2) < &hi * &hi);
        assert_eq!(root.rational(), None);
        assert!(root.is_root_of(&polynomial(&[4, 2, -2, -1])));
        assert!(!root.is_root_of(&polynomial(&[-3, 0, 1])));
    }

    #[test]
    fn rational_roots_are_recognised() {
        // (7u − 3)(5u − 11)(u² − 5).
        let p = polynomial(&[-3, 7]).times(&polynomial(&[-11, 5])).times(&polynomial(&[-5, 0, 1]));
        let found: Vec<_> = positive_roots(&p).iter_mut().map(IsolatedRoot::rational).collect();
        assert_eq!(found, [Some(rational(3, 7)), Some(rational(11, 5)), None]);
    }

    /// A rational root between irrational ones that are close, with a denominator that takes many steps.
    #[test]
    fn a_rational_root_with_a_long_denominator_is_recognised() {
        let long = BigRational::new(BigInt::from(3).pow(70), BigInt::from(7).pow(50));
        let linear = Polynomial::new(-long.clone(), [integer(1)]);
        let p = linear.times(&polynomial(&[-2, 0, 1])).times(&polynomial(&[-200_000_001, 0, 100_000_000]));
        let mut found: Vec<_> = positive_roots(&p).iter_mut().map(IsolatedRoot::rational).collect();
        found.retain(Option::is_some);
        assert_eq!(found, [Some(long)]);
    }

    #[test]
    fn constants_and_zero_have_no_isolated_root() {
        for p in [polynomial(&[0]), polynomial(&[3]), polynomial(&[0, 5]), polynomial(&[0, 0, -1])] {
            assert!(positive_roots(&p).is_empty());
            assert_eq!(count_positive_roots(&p), 0);
        }
    }

    /// The number of roots in (a, b), all in integers of any length.
    fn slowly(coefficients: &[BigInt], a: &BigInt, b: &BigInt) -> usize {
        let p = moved_to_positive(coefficients, a, b).without_root_at_zero();
        if p.is_zero() { 0 } else { bisect(p.square_free().into_coefficients()).len() }
    }

    /// (a, b) and a polynomial with roots in it, at its ends, in dyadic places, close together, or multiple.
    fn troubled() -> impl Strategy<Value = (BigInt, BigInt, Vec<BigInt>)> {
        let far = prop::sample::select(vec![0_i64, 0, -4, -20, 1 << 15, -(1 << 33), 1 << 61]);
        let long = prop::sample::select(vec![1_u32, 1, 1, 30, 400]);
        let factors = prop::collection::vec((0_u8..8, any::<u32>(), any::<u32>(), 1_usize..=2), 1..=9);
        (far, 1_i64..=12, long, factors).prop_map(|(a, width, long, factors)| {
            // Factors in x − a.
            let factor = |&(kind, m, e, power): &(u8, u32, u32, usize)| {
                let (m, e) = (i64::from(m), i64::from(e));
                let (p, power) = match kind {
                    0 => (vec![0, 1], power),
                    1 => (vec![-width, 1], power),
                    2 => (vec![-(m % (8 * width + 1)), 8], 1),
                    3 => (vec![m % 2001 - 1000, e % 99 + 1], power),
                    4 => (vec![m % 201 - 100, e % 41 - 20, m % 20 + 1], 1),
                    5 => (vec![m % 9 - 4], 1),
                    // Two roots about 2^(−12)·√e apart, or one double root, around m/4096.
                    6 => {
                        let (m, e) = (m % (4096 * width), e % 7);
                        (vec![m * m - e, -2 * 4096 * m, 4096 * 4096], 1)
                    }
                    // Around a dyadic place, as close as there are roots of 2^e·(x − m/8)² − 1.
                    _ => {
                        let (m, e) = (m % (8 * width + 1), 1_i64 << (e % 24));
                        (vec![m * m * e - 1, -16 * m * e, 64 * e], 1)
                    }
                };
                let mut p = p.into_iter().map(BigInt::from);
                Polynomial::new(p.next().unwrap(), p).power(power)
            };
            let product =
                factors.iter().map(factor).reduce(|product, factor| product.times(&factor)).unwrap();
            let a = BigInt::from(a);
            let mut c = product.scaled(&BigInt::from(10).pow(long)).coefficients().to_vec();
            shift(&mut c, |lower, upper| *lower -= upper * &a);
            (a.clone(), a + width, c)
        })
    }

    #[test]
    fn long_numbers_long_polynomials_and_far_ends_are_counted_too() {
        let linear = |root: BigInt, slope: BigInt| Polynomial::new(-root, [slope]);
        let one = BigInt::from(1);
        let count = |p: &Polynomial<BigInt>, a: &BigInt, b: &BigInt| {
            assert!(isolate_between(p.coefficients(), a, b).is_none());
            count_roots_between(p.coefficients(), a, b)
        };
        // Roots at 1 + 10^(−10,000) and 2, and a double one at 3.
        let long = BigInt::from(10).pow(10_000);
        let p = linear(&long + 1, long).times(&linear(2.into(), one.clone()));
        let p = p.times(&linear(3.into(), one.clone()).power(2));
        assert_eq!(count(&p, &1.into(), &3.into()), 2);
        assert_eq!(count(&p, &1.into(), &4.into()), 3);
        let all = (1..=70).map(|root| linear(root.into(), one.clone()));
        let p = all.reduce(|product, factor| product.times(&factor)).unwrap();
        assert_eq!(count(&p, &1.into(), &70.into()), 68);
        let far: BigInt = BigInt::from(1) << 70;
        let p = linear(&far + 1, one.clone())
            .times(&linear(&far + 2, one.clone()))
            .times(&linear(far.clone(), one));
        assert_eq!(count(&p, &far, &(&far + 3)), 2);
        assert_eq!(count(&p, &-&far, &(&far + 2)), 2);
        assert_eq!(count(&p, &(&far + 3), &far), 0);
        assert_eq!(count_roots_between(&[BigInt::from(0)], &-&far, &far), 0);
        assert_eq!(count_roots_between(&[], &-&far, &far), 0);
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(600))]

        #[test]
        fn roots_between_are_those_of_the_slow_path((a, b, c) in troubled()) {
            let expected = slowly(&c, &a, &b);
            prop_assert_eq!(count_roots_between(&c, &a, &b), expected);
            let Some(roots) = isolate_between(&c, &a, &b) else { return Ok(()) };
            prop_assert_eq!(roots.len(), expected);
            for pair in roots.windows(2) {
                prop_assert!(pair[0].hi() <= pair[1].lo());
            }
            for root in roots {
                let (width, start) = (BigRational::from(&b - &a), BigRational::from(a.clone()));
                let [lo, hi] = [root.lo(), root.hi()].map(|y| y * &width + &start);
                prop_assert!(start <= lo && lo <= hi && hi <= BigRational::from(b.clone()));
                prop_assert_eq!(root.is_exact(), lo == hi);
                // In X = 2^60·x the ends are integers.
                let scale: BigInt = BigInt::from(1) << 60;
                let n = c.len() - 1;
                let scaled: Vec<BigInt> = c.iter().enumerate().map(|(i, c)| c << (60 * (n - i))).collect();
                let [lo, hi] = [lo, hi].map(|x| (x * &scale).to_integer());
                if root.is_exact() {
                    let value = scaled.iter().rev().fold(BigInt::ZERO, |value, c| value * &lo + c);
                    prop_assert_eq!(value, BigInt::ZERO);
                } else {
                    prop_assert_eq!(slowly(&scaled, &lo, &hi), 1);
                }
            }
        }

        #[test]
        fn both_ways_end_with_the_same_intervals((_, _, c) in troubled()) {
            let p = IntegerPolynomial::primitive(c).without_root_at_zero();
            if p.is_zero() {
                return Ok(());
            }
            prop_assert_eq!(count_of(p.clone()), bisect(p.clone().square_free().into_coefficients()).len());
            let p = p.square_free();
            // A linear polynomial has its root exactly, without a search.
            if p.coefficients().len() != 2 {
                prop_assert_eq!(isolate(&p), bisect(p.coefficients().to_vec()));
            }
        }
    }
}
