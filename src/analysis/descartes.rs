//! The roots of an integer polynomial in an interval by Descartes' rule of signs, in integers of a fixed width: without
//! asking for memory, and all that is needed unless roots are multiple or crowded, or numbers long.
//!
//! With x = (a + bu)/(1 + u) the interval (a, b) is u in (0, ∞), and the roots are the positive ones of
//!
//! Q(u) = Σ c_i (a + bu)^i (1 + u)^(n−i).
//!
//! The number of its sign changes bounds that of the roots, each as often as its multiplicity says, and is equal to it
//! where it is 0 or 1. Otherwise the interval is halved, as [`positive_roots`](super::positive_roots) does.
//!
//! **How wide.** All is computed modulo 2^(64·L): see [`Limbs`]. What is read are signs of coefficients, so these have to
//! fit with their signs, and nothing else has to.
//!
//! * No coefficient of Q is larger than the sum of the absolute values of all, and that is at most Q's value at u = 1 with
//!   |c_i|, |a|, |b| for c_i, a, b, since all signs are + there: |Q_j| ≤ Σ |c_i| (|a| + |b|)^i 2^(n−i).
//!   [`bits_of_moved`] bounds this by lengths of integers.
//! * In the same way the coefficients of a half, Σ c_i (1 + 2v)^i or Σ c_i v^i (v + 2)^(n−i), are at most
//!   Σ |c_i| 3^i or Σ |c_i| 3^(n−i), which is less than 2^B·(1 + 3 + … + 3^n) < 2^B·3^(n+1)/2 if all |c_i| < 2^B; and
//!   3^5 < 2^8. [`growth`] is that.

use std::cell::Cell;

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, ToPrimitive, Zero};

use crate::scalar::{Limbs, spend};

/// A place of one root, in the affine coordinate y = (x − a)/(b − a) of an interval (a, b): either the root itself or an
/// open interval with dyadic ends 0 ≤ lo < hi ≤ 1, which may be roots that are found by themselves, or a or b.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct RootInterval {
    place: u64,
    depth: u32,
    exact: bool,
}

impl RootInterval {
    /// The lower end for y, or the root.
    #[must_use]
    pub fn lo(&self) -> BigRational {
        self.dyadic(self.place)
    }

    /// The upper end for y, or the root.
    #[must_use]
    pub fn hi(&self) -> BigRational {
        self.dyadic(if self.exact { self.place } else { self.place + 1 })
    }

    /// Is y known exactly?
    #[must_use]
    pub fn is_exact(&self) -> bool {
        self.exact
    }

    /// place/2^depth.
    fn dyadic(&self, place: u64) -> BigRational {
        let common = place.trailing_zeros().min(self.depth);
        BigRational::new_raw((place >> common).into(), BigInt::one() << (self.depth - common))
    }
}

/// The distinct roots of Σ c_i x^i in the open interval (a, b), from left to right.
///
/// `None` if there is a multiple one, or if that can't be told: they are close together, or the numbers or the list are
/// too long. [`count_roots_between`](super::count_roots_between) always has an answer. The polynomial 0 has no isolated
/// root.
///
/// ```
/// use knotproof::analysis::isolate_between;
/// use num_bigint::BigInt;
///
/// // x³ − 2x, on (−2, 2): −√2, 0 and √2.
/// let [p, ends] = [vec![0, -2, 0, 1], vec![-2, 2]].map(|list| list.into_iter().map(BigInt::from).collect::<Vec<_>>());
/// let roots = isolate_between(&p, &ends[0], &ends[1]).unwrap();
/// let exact: Vec<bool> = roots.iter().map(|root| root.is_exact()).collect();
/// assert_eq!(exact, [false, true, false]);
/// assert!(roots[0].hi() <= roots[1].lo() && roots[1].hi() <= roots[2].lo());
/// ```
#[must_use]
pub fn isolate_between(coefficients: &[BigInt], a: &BigInt, b: &BigInt) -> Option<Vec<RootInterval>> {
    let span = Some((a.to_i64()?, b.to_i64()?));
    search(coefficients, span, HALVINGS, Vec::push)
}

/// How many roots [`isolate_between`] would find; `None` sooner where they are close together.
pub(super) fn count_between(coefficients: &[BigInt], a: &BigInt, b: &BigInt) -> Option<usize> {
    let span = Some((a.to_i64()?, b.to_i64()?));
    search(coefficients, span, FEW_HALVINGS, |count, _| *count += 1)
}

/// The same on (0, ∞), where y = x/(1 + x).
pub(super) fn isolate_positive(coefficients: &[BigInt]) -> Option<Vec<RootInterval>> {
    search(coefficients, None, HALVINGS, Vec::push)
}

/// How many roots [`isolate_positive`] would find; `None` sooner where they are close together.
pub(super) fn count_positive(coefficients: &[BigInt]) -> Option<usize> {
    search(coefficients, None, FEW_HALVINGS, |count, _| *count += 1)
}

/// So many coefficients at most.
const MOST: usize = 64;
/// An interval is halved so often at most. What is closer together may be a multiple root, for which this would go on and on:
/// who only counts had better take such roots apart first.
const FEW_HALVINGS: u32 = 12;
/// The same where there is nothing better to do.
const HALVINGS: u32 = 60;

/// Why there is no answer.
enum Failure {
    /// The numbers have to be wider.
    Narrow,
    /// A multiple root, or several that are close together.
    Crowded,
}

/// Takes what is found, from left to right.
type Found<'a> = dyn FnMut(RootInterval) + 'a;

/// In how many digits a search can be: in these, or in the next of them where they do not do.
const WIDTHS: [(u64, Search); 9] = [
    (1, search_in::<1>),
    (2, search_in::<2>),
    (3, search_in::<3>),
    (4, search_in::<4>),
    (5, search_in::<5>),
    (6, search_in::<6>),
    (7, search_in::<7>),
    (9, search_in::<9>),
    (12, search_in::<12>),
];

type Search = fn(&[BigInt], Option<(i64, i64)>, u32, &mut Found<'_>) -> Result<(), Failure>;

/// What is found in (a, b), or in (0, ∞) without such ends.
fn search<R: Default>(
    coefficients: &[BigInt],
    span: Option<(i64, i64)>,
    halvings: u32,
    push: fn(&mut R, RootInterval),
) -> Option<R> {
    let length = coefficients.iter().rposition(|c| !c.is_zero()).map_or(0, |degree| degree + 1);
    let coefficients = &coefficients[..length];
    // A constant has no root, or no isolated one.
    if length < 2 || span.is_some_and(|(a, b)| a >= b) {
        return Some(R::default());
    }
    if length > MOST {
        return None;
    }
    let bits = match span {
        Some((a, b)) => bits_of_moved(coefficients, a, b),
        None => coefficients.iter().map(BigInt::bits).max().unwrap_or(0) + 1,
    };
    for (_, search_in) in WIDTHS.iter().skip_while(|(digits, _)| bits > 64 * digits) {
        let mut found = R::default();
        match search_in(coefficients, span, halvings, &mut |root| push(&mut found, root)) {
            Ok(()) => return Some(found),
            Err(Failure::Crowded) => return None,
            Err(Failure::Narrow) => {}
        }
    }
    None
}

/// The search in L digits, which are enough for the coefficients on (0, ∞).
fn search_in<const L: usize>(
    coefficients: &[BigInt],
    span: Option<(i64, i64)>,
    halvings: u32,
    found: &mut Found<'_>,
) -> Result<(), Failure> {
    let mut store = [Limbs::<L>::ZERO; MOST];
    let c = &mut store[..coefficients.len()];
    for (c, integer) in c.iter_mut().zip(coefficients) {
        *c = Limbs::of(integer);
    }
    if let Some((a, b)) = span {
        move_to_positive(c, a, b);
    }
    // Without the roots at the ends.
    let is_there = |c: &Limbs<L>| !c.is_zero();
    match (c.iter().position(is_there), c.iter().rposition(is_there)) {
        (Some(first), Some(last)) => bisect(&mut c[first..=last], (0, 0), halvings, found),
        _ => Ok(()),
    }
}

/// How many bits hold each coefficient of Q with its sign.
fn bits_of_moved(coefficients: &[BigInt], a: i64, b: i64) -> u64 {
    let n = coefficients.len() as u64 - 1;
    // |a| + |b| < 2^64, since a < b; it is ≤ top·2^low with top ≤ 2^15, and so (|a| + |b|)^8 ≤ 2^eight.
    let sum = a.unsigned_abs() + b.unsigned_abs();
    let low = length(sum.into()).saturating_sub(15);
    let top = (sum >> low) + u64::from(low > 0);
    let fourth = u128::from(top * top * top * top);
    let eight = 8 * low + length(fourth * fourth - 1);
    // |c_i| (|a| + |b|)^i 2^(n−i) < 2^(length of c_i + i·eight/8 + n − i), where an eighth is the unit.
    let terms = coefficients.iter().zip(0..).map(|(c, i)| 8 * (c.bits() + n - i) + i * eight);
    let most = terms.fold(0, u64::max).div_ceil(8);
    // There are n + 1 of them, and n + 1 ≤ 2^(length of n); one bit is the sign's.
    most + length(n.into()) + 1
}

/// The least b ≥ 0 with number < 2^b.
fn length(number: u128) -> u64 {
    u64::from(128 - number.leading_zeros())
}

/// By how many bits, its sign's among them, the coefficients of a half may be longer than those of a polynomial of degree n.
fn growth(n: usize) -> u64 {
    // 2^B·3^(n+1)/2 < 2^(B + 8(n+1)/5 − 1), and the sign.
    (8 * (n as u64 + 1)).div_ceil(5)
}

/// p becomes Q.
fn move_to_positive<const L: usize>(c: &mut [Limbs<L>], a: i64, b: i64) {
    // p(a + x); with a < 0 it is p(−(|a| − x)).
    if a < 0 {
        mirror(c);
    }
    shift(c, a.unsigned_abs());
    if a < 0 {
        mirror(c);
    }
    // p(a + hx), with h's powers in words: h^i is full^count·rest.
    let h = b.abs_diff(a);
    if h > 1 {
        let (mut full, mut count, mut rest) = (1, 0, 1_u64);
        for c in c.iter_mut() {
            for _ in 0..count {
                *c = c.times(full);
            }
            *c = c.times(rest);
            rest = rest.checked_mul(h).unwrap_or_else(|| {
                (full, count) = (rest, count + 1);
                h
            });
        }
    }
    // x = u/(1 + u): in reverse, the polynomial in 1 + u.
    c.reverse();
    shift_by_one(c);
    c.reverse();
}

/// p(−x).
fn mirror<const L: usize>(c: &mut [Limbs<L>]) {
    for c in c.iter_mut().skip(1).step_by(2) {
        *c = c.negate();
    }
}

/// p(x + by), by Horner's rule.
fn shift<const L: usize>(c: &mut [Limbs<L>], by: u64) {
    match by {
        0 => {}
        1 => shift_by_one(c),
        _ => horner(c, |sum, above| sum.plus_times(above, by)),
    }
}

/// p(x + 1): nothing but additions.
fn shift_by_one<const L: usize>(c: &mut [Limbs<L>]) {
    horner(c, Limbs::plus);
}

/// Horner's rule on polynomials: from the top coefficient on, what has been read is multiplied by x + m and the next one is
/// added. That is c_i ← step(c_i, c_{i+1}) for i from k to n − 1, for each k from n − 1 down.
///
/// In this order no step waits for the one before it. Several k are done in one pass, so that each number is fetched and put
/// back less often: as many as there are registers for.
#[inline(always)]
fn horner<const L: usize>(c: &mut [Limbs<L>], step: impl Fn(Limbs<L>, Limbs<L>) -> Limbs<L>) {
    let mut k = c.len() - 1;
    let at_once = if L <= 2 { 4 } else { 2 };
    while !k.is_multiple_of(at_once) {
        k -= 1;
        pass(&mut c[k..], &step);
    }
    while k > 0 {
        k -= at_once;
        if L <= 2 { four_passes(&mut c[k..], &step) } else { two_passes(&mut c[k..], &step) }
    }
}

/// [`horner`]'s pass for k = 0.
#[inline(always)]
fn pass<T: Copy>(c: &mut [T], step: &impl Fn(T, T) -> T) {
    for pair in Cell::from_mut(c).as_slice_of_cells().windows(2) {
        pair[0].set(step(pair[0].get(), pair[1].get()));
    }
}

/// [`horner`]'s passes for k = 1 and k = 0.
#[inline(always)]
fn two_passes<T: Copy>(c: &mut [T], step: &impl Fn(T, T) -> T) {
    let last = c.len() - 1;
    // What the first pass has made of the number in the middle.
    let mut first = c[0];
    for window in Cell::from_mut(&mut *c).as_slice_of_cells().windows(3) {
        let next = step(window[1].get(), window[2].get());
        window[0].set(step(first, next));
        first = next;
    }
    c[last - 1] = step(first, c[last]);
}

/// [`horner`]'s passes for k = 3, 2, 1 and 0.
#[inline(always)]
fn four_passes<T: Copy>(c: &mut [T], step: &impl Fn(T, T) -> T) {
    let last = c.len() - 1;
    // What a pass has made of a number, each one place before that of the pass before it.
    let (mut first, mut second, mut third) = (c[2], c[1], c[0]);
    for window in Cell::from_mut(&mut *c).as_slice_of_cells().windows(5) {
        let next = step(window[3].get(), window[4].get());
        let next_second = step(first, next);
        let next_third = step(second, next_second);
        window[0].set(step(third, next_third));
        (first, second, third) = (next, next_second, next_third);
    }
    // No pass changes the last number, so there is less and less to do for the earlier ones.
    let end = c[last];
    let at_second = step(first, end);
    let (before, at) = (step(second, at_second), step(at_second, end));
    c[last - 3] = step(third, before);
    c[last - 2] = step(before, at);
    c[last - 1] = step(at, end);
}

/// How often the sign changes, up to 2.
#[inline(always)]
fn few_changes<const L: usize>(c: &[Limbs<L>]) -> usize {
    let mut negative = c.iter().filter(|c| !c.is_zero()).map(Limbs::is_negative);
    let Some(mut last) = negative.next() else { return 0 };
    negative.filter(|next| std::mem::replace(&mut last, *next) != *next).take(2).count()
}

/// The roots in the interval [place/2^depth, (place + 1)/2^depth] without its ends, where c has none.
fn bisect<const L: usize>(
    c: &mut [Limbs<L>],
    (place, depth): (u64, u32),
    halvings: u32,
    found: &mut Found<'_>,
) -> Result<(), Failure> {
    match few_changes(c) {
        0 => return Ok(()),
        1 => {
            found(RootInterval { place, depth, exact: false });
            return Ok(());
        }
        _ => {}
    }
    let n = c.len() - 1;
    let longest = c.iter().map(|c| c.bits()).max().unwrap_or(0);
    if depth == halvings {
        return Err(Failure::Crowded);
    }
    if longest + growth(n) > 64 * L as u64 {
        return Err(Failure::Narrow);
    }
    spend();
    let mut store = [Limbs::ZERO; MOST];
    let left = &mut store[..=n];
    left.copy_from_slice(c);
    // Σ c_i v^i (v + 2)^(n−i) is in reverse what the other one, p(1 + 2v), is for the polynomial in reverse.
    left.reverse();
    shift_and_double(left);
    let right = c;
    shift_and_double(right);
    let middle = right[0].is_zero();
    if middle && right[1].is_zero() {
        return Err(Failure::Crowded);
    }
    // A root in the middle is divided out.
    let [left, right] = [left, right].map(|half| &mut half[usize::from(middle)..]);
    left.reverse();
    let (place, depth) = (2 * place, depth + 1);
    bisect(without_powers_of_two(left), (place, depth), halvings, found)?;
    if middle {
        found(RootInterval { place: place + 1, depth, exact: true });
    }
    bisect(without_powers_of_two(right), (place + 1, depth), halvings, found)
}

/// p(1 + 2x).
fn shift_and_double<const L: usize>(c: &mut [Limbs<L>]) {
    shift_by_one(c);
    for (c, bits) in c.iter_mut().zip(0..) {
        *c = c.doubled(bits);
    }
}

/// Divided by a common power of 2, so that they stay short: the positive multiple has the same roots and signs.
fn without_powers_of_two<const L: usize>(c: &mut [Limbs<L>]) -> &mut [Limbs<L>] {
    // Of 0, and of what is divisible by 2^64, there are 64 zeros at the end: no digit less is enough for them.
    let bits = c.iter().fold(0, |all, c| all | c.lowest()).trailing_zeros();
    if (1..64).contains(&bits) {
        for c in c.iter_mut() {
            *c = c.halved(bits);
        }
    }
    c
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::{Polynomial, Ring};
    use proptest::prelude::*;

    fn integers(list: &[i64]) -> Vec<BigInt> {
        list.iter().map(|&c| c.into()).collect()
    }

    fn linear(constant: impl Into<BigInt>, slope: impl Into<BigInt>) -> Polynomial<BigInt> {
        Polynomial::new(constant.into(), [slope.into()])
    }

    /// Σ c_i f^i g^(n−i), the coefficients up to that of u^n.
    fn homogeneous(c: &[BigInt], f: &Polynomial<BigInt>, g: &Polynomial<BigInt>) -> Vec<BigInt> {
        let n = c.len() - 1;
        let term = |(i, c): (usize, &BigInt)| f.power(i).times(&g.power(n - i)).scaled(c);
        let sum = c.iter().enumerate().map(term).reduce(|sum, term| sum.plus(&term)).unwrap();
        let mut list = sum.coefficients().to_vec();
        list.resize(n + 1, BigInt::ZERO);
        list
    }

    fn coefficients() -> impl Strategy<Value = Vec<BigInt>> {
        let small = (-9_i64..=9).prop_map(BigInt::from);
        let powers = (0_u32..200, -1_i64..=1, prop::bool::ANY).prop_map(|(e, off, negative)| {
            let c = (BigInt::from(1) << e) + off;
            if negative { -c } else { c }
        });
        prop::collection::vec(prop_oneof![small, powers], 1..=12)
    }

    fn ends() -> impl Strategy<Value = (i64, i64)> {
        let end = prop_oneof![
            -9_i64..=9,
            (0_u32..63).prop_map(|e| 1 << e),
            any::<i64>(),
            prop::sample::select(vec![i64::MIN, i64::MAX, 1 << 15, (1 << 15) - 1, -(1 << 15)])
        ];
        (end.clone(), end).prop_filter_map("no interval", |(a, b)| (a != b).then(|| (a.min(b), a.max(b))))
    }

    proptest! {
        #[test]
        fn the_polynomial_is_moved_and_its_length_known(c in coefficients(), (a, b) in ends()) {
            let moved = homogeneous(&c, &linear(a, b), &linear(1, 1));
            let bits = bits_of_moved(&c, a, b);
            for q in &moved {
                prop_assert!(q.bits() < bits, "{q} in {bits} bits");
            }
            // Also in too few digits: then these are residues.
            let mut own: Vec<Limbs<3>> = c.iter().map(Limbs::of).collect();
            move_to_positive(&mut own, a, b);
            prop_assert_eq!(own, moved.iter().map(Limbs::of).collect::<Vec<_>>());
        }

        #[test]
        fn halves_are_as_long_as_they_may_be(c in coefficients()) {
            let most = c.iter().map(BigInt::bits).max().unwrap_or(0) + growth(c.len() - 1);
            let left = homogeneous(&c, &linear(0, 1), &linear(2, 1));
            let right = homogeneous(&c, &linear(1, 2), &linear(1, 0));
            for half in left.iter().chain(&right) {
                prop_assert!(half.bits() < most, "{half} in {most} bits");
            }
            let mut own: Vec<Limbs<3>> = c.iter().map(Limbs::of).collect();
            shift_and_double(&mut own);
            prop_assert_eq!(own, right.iter().map(Limbs::of).collect::<Vec<_>>());
        }
    }

    /// The bounds are no further off than they are meant to be: all signs equal, and powers of 2.
    #[test]
    fn the_lengths_are_nearly_reached() {
        let ones = integers(&[1; 40]);
        let longest = |list: Vec<BigInt>| list.iter().map(BigInt::bits).max().unwrap();
        // Σ 3^i for i < 40 has 63 bits; the middle coefficients have nearly as many.
        let right = longest(homogeneous(&ones, &linear(1, 2), &linear(1, 0)));
        assert!(right + 4 >= growth(39), "{right}");
        let moved = longest(homogeneous(&ones, &linear(7, 9), &linear(1, 1)));
        assert!(moved + 12 >= bits_of_moved(&ones, 7, 9), "{moved}");
        // All terms are equal at u = 1, and meet in the last coefficient.
        let moved = longest(homogeneous(&integers(&[255; 40]), &linear(0, 2), &linear(1, 1)));
        assert!(moved < bits_of_moved(&integers(&[255; 40]), 0, 2), "{moved}");
    }

    #[test]
    fn powers_of_two_are_taken_out() {
        let stripped = |list: &[i64]| {
            let mut c: Vec<Limbs<2>> = integers(list).iter().map(Limbs::of).collect();
            without_powers_of_two(&mut c).to_vec()
        };
        let of = |list: &[i64]| integers(list).iter().map(Limbs::of).collect::<Vec<Limbs<2>>>();
        assert_eq!(stripped(&[0, -8, 12]), of(&[0, -2, 3]));
        assert_eq!(stripped(&[3, 4]), of(&[3, 4]));
        assert_eq!(stripped(&[0, 0]), of(&[0, 0]));
        assert_eq!(stripped(&[i64::MIN, 0]), of(&[-1, 0]));
    }

    #[test]
    fn sign_changes_are_counted_up_to_two() {
        let count =
            |list: &[i64]| few_changes(&integers(list).iter().map(Limbs::of).collect::<Vec<Limbs<2>>>());
        assert_eq!([count(&[]), count(&[0, 0]), count(&[1, 0, 2]), count(&[-1, -1])], [0; 4]);
        assert_eq!([count(&[1, 0, -2]), count(&[0, -1, 0, 3, 0])], [1; 2]);
        assert_eq!([count(&[1, -1, 1]), count(&[1, -1, 0, 1, -1])], [2; 2]);
    }

    #[test]
    fn what_is_multiple_crowded_or_long_is_left_to_others() {
        let found = |c: &[BigInt], a: i64, b: i64| count_between(c, &a.into(), &b.into());
        // (x − 1)², in the middle of the interval, at its end, outside; (x² − 2)².
        let double = integers(&[1, -2, 1]);
        assert_eq!(
            (found(&double, 0, 2), found(&double, 1, 2), found(&double, 2, 3)),
            (None, Some(0), Some(0))
        );
        assert_eq!(found(&integers(&[4, 0, -4, 0, 1]), 0, 2), None);
        // 2^e·(2x − 1)² − 1 has two roots, 2^(−e/2) apart.
        let two = |e: u32| {
            let scale = BigInt::from(1) << e;
            let p = [&scale - 1, -4 * &scale, 4 * scale];
            (found(&p, 0, 3), isolate_between(&p, &0.into(), &3.into()).map(|roots| roots.len()))
        };
        assert_eq!([two(10), two(60), two(130)], [(Some(2), Some(2)), (None, Some(2)), (None, None)]);
        // Coefficients of up to 12 digits to base 2^64, and 64 of them.
        let long =
            |bits: u32| found(&[-(BigInt::from(1) << bits), BigInt::from(1) << (bits - 1)], 0, 1 << 40);
        assert_eq!((long(600), long(760)), (Some(1), None));
        let many = |degree: usize| {
            let mut c = integers(&vec![0; degree]);
            c.push(2.into());
            c[0] = (-1).into();
            found(&c, 0, 1)
        };
        assert_eq!((many(63), many(64)), (Some(1), None));
        // Ends of 64 bits with their signs.
        let ends = [i64::MIN, i64::MAX].map(BigInt::from);
        let line = integers(&[5, 1]);
        assert_eq!(count_between(&line, &ends[0], &ends[1]), Some(1));
        assert_eq!(count_between(&line, &(&ends[0] - 1), &ends[1]), None);
    }

    #[test]
    fn narrow_numbers_are_tried_in_more_digits() {
        // (x − 1)(x − 2)…(x − 13) fits into one digit on (0, ∞), its halves do not.
        let factors = (1..=13).map(|root| linear(-root, 1));
        let product = factors.reduce(|product, factor| product.times(&factor)).unwrap();
        assert!(product.coefficients().iter().all(|c| c.bits() < 64));
        let failed = search_in::<1>(product.coefficients(), None, HALVINGS, &mut |_| {});
        assert!(matches!(failed, Err(Failure::Narrow)));
        assert_eq!(count_positive(product.coefficients()), Some(13));
    }

    #[test]
    fn without_an_interval_or_a_variable_nothing_is_found() {
        let zero_to_two = |list: &[i64]| isolate_between(&integers(list), &0.into(), &2.into()).unwrap();
        for list in [&[][..], &[0], &[7], &[0, 0, 0], &[7, 0, 0]] {
            assert!(zero_to_two(list).is_empty());
        }
        let line = integers(&[-1, 1]);
        for (a, b) in [(1, 1), (2, 0), (0, 0), (5, -5)] {
            assert_eq!(isolate_between(&line, &a.into(), &b.into()), Some(Vec::new()));
        }
        assert_eq!(zero_to_two(&[-1, 1]).len(), 1);
        assert_eq!(zero_to_two(&[-1, 1, 0, 0]).len(), 1);
    }
}
