//! Shapes against an oracle that shares no code with them: on each span the function as P/Q in the affine coordinate
//! y, where Q is the product of the denominators of all weights and P interpolates exact values times Q; then Sturm
//! chains, in arithmetic of its own.

#![allow(clippy::unwrap_used, reason = "helpers of tests: a failure is a failed test")]

use std::cmp::Ordering;

use knotproof::analysis::{Extremum, ExtremumKind, Location, Pieces, Shape};
use knotproof::spline::{Basis, Index, KnotVector, Side};
use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};
use proptest::prelude::*;

/// Coefficients, lowest first, no leading zero; none for 0.
type Rational = Vec<BigRational>;

fn number(n: i64, d: i64) -> BigRational {
    BigRational::new(n.into(), d.into())
}

fn trimmed<T: Zero>(mut p: Vec<T>) -> Vec<T> {
    while p.last().is_some_and(Zero::is_zero) {
        p.pop();
    }
    p
}

fn product(p: &Rational, q: &Rational) -> Rational {
    let mut product = vec![BigRational::zero(); (p.len() + q.len()).saturating_sub(1)];
    for (i, a) in p.iter().enumerate() {
        for (j, b) in q.iter().enumerate() {
            product[i + j] += a * b;
        }
    }
    trimmed(product)
}

fn sum(p: &Rational, q: &Rational, factor: i64) -> Rational {
    let zero = BigRational::zero();
    let entry = |p: &Rational, i: usize| p.get(i).unwrap_or(&zero).clone();
    let length = p.len().max(q.len());
    trimmed((0..length).map(|i| entry(p, i) + entry(q, i) * number(factor, 1)).collect())
}

fn derivative(p: &Rational) -> Rational {
    trimmed((0..).map(|i| number(i, 1)).zip(p).skip(1).map(|(i, c)| i * c).collect())
}

fn value(p: &Rational, y: &BigRational) -> BigRational {
    p.iter().rev().fold(BigRational::zero(), |value, c| value * y + c)
}

/// p/(y − root), for a root of p.
fn deflated(p: &Rational, root: &BigRational) -> Rational {
    let mut carry = BigRational::zero();
    let mut quotient: Rational = p
        .iter()
        .rev()
        .map(|c| {
            carry = &carry * root + c;
            carry.clone()
        })
        .collect();
    assert!(quotient.pop().unwrap().is_zero());
    quotient.reverse();
    quotient
}

/// Newton's interpolation.
fn interpolation(points: &[(BigRational, BigRational)]) -> Rational {
    let mut differences: Vec<BigRational> = points.iter().map(|(_, f)| f.clone()).collect();
    for level in 1..points.len() {
        for i in (level..points.len()).rev() {
            differences[i] = (&differences[i] - &differences[i - 1]) / (&points[i].0 - &points[i - level].0);
        }
    }
    let nodes = points.iter().map(|(y, _)| vec![-y.clone(), BigRational::one()]);
    let rows = differences.iter().zip(nodes).rev();
    rows.fold(Vec::new(), |p, (c, node)| sum(&product(&p, &node), &trimmed(vec![c.clone()]), 1))
}

/// A Sturm chain with integer coefficients.
struct Sturm(Vec<Vec<BigInt>>);

impl Sturm {
    fn new(p: &Rational) -> Self {
        let common = p.iter().fold(BigInt::one(), |common, c| common.lcm(c.denom()));
        let first = primitive(p.iter().map(|c| (c * &common).to_integer()).collect());
        let second = primitive((0..).map(BigInt::from).zip(&first).skip(1).map(|(i, c)| i * c).collect());
        let mut chain = vec![first, second];
        while let [.., a, b] = &chain[..] {
            if b.is_empty() {
                break;
            }
            let next = negative_remainder(a, b);
            chain.push(next);
        }
        chain.pop();
        Self(chain)
    }

    fn variations(&self, y: &BigRational) -> usize {
        let sign = |p: &Vec<BigInt>| {
            let (mut value, mut power) = (BigInt::zero(), BigInt::one());
            for c in p.iter().rev() {
                value = value * y.numer() + c * &power;
                power *= y.denom();
            }
            value.signum()
        };
        let signs: Vec<_> = self.0.iter().map(sign).filter(|sign| !sign.is_zero()).collect();
        signs.windows(2).filter(|pair| pair[0] != pair[1]).count()
    }

    /// Distinct roots between two points that are none.
    fn count(&self, from: &BigRational, to: &BigRational) -> usize {
        self.variations(from) - self.variations(to)
    }
}

fn primitive(p: Vec<BigInt>) -> Vec<BigInt> {
    let p = trimmed(p);
    let content = p.iter().fold(BigInt::zero(), |content, c| content.gcd(c));
    p.into_iter().map(|c| c / &content).collect()
}

/// A positive multiple of −(a mod b).
fn negative_remainder(a: &[BigInt], b: &[BigInt]) -> Vec<BigInt> {
    let mut rest = a.to_vec();
    let leading = b.last().unwrap();
    while rest.len() >= b.len() {
        let top = rest.last().unwrap().clone() * leading.signum();
        for c in &mut rest {
            *c *= leading.abs();
        }
        let shift = rest.len() - b.len();
        for (i, c) in b.iter().enumerate() {
            rest[shift + i] -= &top * c;
        }
        rest.pop();
    }
    primitive(rest.into_iter().map(|c| -c).collect())
}

/// A function on a span [start, end], by the oracle.
struct OnSpan {
    start: BigRational,
    end: BigRational,
    /// Its limits at the ends.
    limits: [BigRational; 2],
    /// The sign of its slope, between places in y where that changes.
    signs: Vec<Ordering>,
    /// Isolating intervals of those places, in y.
    changes: Vec<(BigRational, BigRational)>,
    /// The numerator of the slope, without roots at the ends, and its chain.
    slope: Rational,
    sturm: Sturm,
}

impl OnSpan {
    fn new(basis: &Basis, i: usize, s: usize) -> Self {
        let (knots, k) = (basis.knots(), basis.degree());
        let (start, end) = (knots.t(s).clone(), knots.t(s + 1).clone());
        let length = &end - &start;
        let r = basis.index().ratio();
        // r(x − t_a) + (t_b − x) for every interval that contains the span.
        let mut q = vec![BigRational::one()];
        for a in i..=s {
            for b in s + 1..=i + k + 1 {
                if b - a <= k {
                    let constant = r * (&start - knots.t(a)) + (knots.t(b) - &start);
                    q = product(&q, &trimmed(vec![constant, (r - BigRational::one()) * &length]));
                }
            }
        }
        let at = |y: &BigRational| {
            let values = basis.values(&(&start + y * &length), Side::Right);
            (y.clone(), &values[i] * value(&q, y))
        };
        let count = i64::try_from((s + 1 - i) * (i + k + 1 - s) + 2).unwrap();
        let points: Vec<_> = (0..count).map(|y| at(&number(2 * y + 1, 2 * count + 2))).collect();
        let (extra, points) = points.split_at(2);
        let p = interpolation(points);
        // The form P/Q is right: P has the values at points that it does not interpolate.
        assert!(extra.iter().all(|(y, f)| value(&p, y) == *f));
        let zero_to_one = [BigRational::zero(), BigRational::one()];
        let limits = zero_to_one.clone().map(|y| value(&p, &y) / value(&q, &y));
        let mut slope = sum(&product(&derivative(&p), &q), &product(&p, &derivative(&q)), -1);
        for end in &zero_to_one {
            while !slope.is_empty() && value(&slope, end).is_zero() {
                // y > 0 is left out, and of (y − 1) < 0 the sign is kept.
                slope = deflated(&slope, end);
                if end.is_one() {
                    slope = slope.into_iter().map(|c| -c).collect();
                }
            }
        }
        assert!(!slope.is_empty(), "constant");
        let sturm = Sturm::new(&slope);
        let mut on_span = Self { start, end, limits, signs: Vec::new(), changes: Vec::new(), slope, sturm };
        on_span.signs.push(on_span.sign(&zero_to_one[0]));
        on_span.isolate(&zero_to_one[0], &zero_to_one[1]);
        on_span
    }

    fn sign(&self, y: &BigRational) -> Ordering {
        value(&self.slope, y).cmp(&BigRational::zero())
    }

    fn isolate(&mut self, from: &BigRational, to: &BigRational) {
        match self.sturm.count(from, to) {
            0 => {}
            1 => {
                if self.sign(from) != self.sign(to) {
                    self.changes.push((from.clone(), to.clone()));
                    self.signs.push(self.sign(to));
                }
            }
            _ => {
                let inner = (1..).map(|part| from + (to - from) * number(part, part + 1));
                let middle = inner.into_iter().find(|y| self.sign(y) != Ordering::Equal).unwrap();
                self.isolate(from, &middle);
                self.isolate(&middle, to);
            }
        }
    }

    /// (kind, does the slope have exactly one zero where the place says?) for each change inside.
    fn is_place(&self, change: usize, place: &Location) -> bool {
        let y = |x: &BigRational| (x - &self.start) / (&self.end - &self.start);
        let (from, to) = &self.changes[change];
        match place {
            Location::Point(x) => {
                let y = y(x);
                value(&self.slope, &y).is_zero() && *from < y && y < *to
            }
            Location::Irrational { lo, hi, .. } => {
                let (lo, hi) = (y(lo), y(hi));
                lo < hi && self.sturm.count(&lo, &hi) == 1 && lo < *to && *from < hi
            }
            Location::Plateau { .. } => false,
        }
    }
}

fn kind(left: Ordering, right: Ordering) -> Option<ExtremumKind> {
    match (left, right) {
        (Ordering::Less, Ordering::Less) => Some(ExtremumKind::Maximum),
        (Ordering::Greater, Ordering::Greater) => Some(ExtremumKind::Minimum),
        _ => None,
    }
}

/// Compares the shape of G_i^k, extremum by extremum and jump by jump; how many extrema there are.
fn compare(basis: &Basis, pieces: &Pieces, i: usize) -> usize {
    let shape = Shape::of(pieces, i);
    let (knots, k) = (basis.knots(), basis.degree());
    let spans: Vec<_> =
        (i..=i + k).filter(|&s| knots.t(s) < knots.t(s + 1)).map(|s| OnSpan::new(basis, i, s)).collect();
    let mut extrema = shape.extrema().iter();
    let mut jumps = shape.jumps().iter();
    let mut knot = |x: &BigRational, left: Option<&OnSpan>, right: Option<&OnSpan>| {
        let zero = BigRational::zero();
        let before = left.map_or(&zero, |span| &span.limits[1]);
        let after = right.map_or(&zero, |span| &span.limits[0]);
        let at_end = x == knots.last();
        let height = if at_end { before } else { after };
        if before != after && x != knots.first() && !at_end {
            let jump = jumps.next().unwrap();
            assert_eq!((&jump.at, &jump.left, &jump.right), (x, before, after));
        }
        let rising = left.map_or(Ordering::Equal, |span| span.signs.last().unwrap().reverse());
        let falling = right.map_or(Ordering::Equal, |span| span.signs[0]);
        let found = kind(before.cmp(height).then(rising), after.cmp(height).then(falling));
        found.map(|kind| (kind, height.clone()))
    };
    let expected = |found: &Extremum, kind| assert_eq!(found.kind, kind);
    let mut total = 0;
    for (position, span) in spans.iter().enumerate() {
        let before = position.checked_sub(1).map(|before| &spans[before]);
        if let Some((kind, height)) = knot(&span.start, before, Some(span)) {
            let found = extrema.next().unwrap();
            expected(found, kind);
            assert_eq!((&found.place, found.at_knot), (&Location::Point(span.start.clone()), true));
            assert_eq!(found.value, (height.clone(), height));
            total += 1;
        }
        for (change, signs) in span.signs.windows(2).enumerate() {
            let found = extrema.next().unwrap();
            expected(found, kind(signs[0].reverse(), signs[1]).unwrap());
            assert!(!found.at_knot && span.is_place(change, &found.place), "{:?}", found.place);
            total += 1;
        }
    }
    if let Some(last) = spans.last()
        && let Some((kind, height)) = knot(&last.end, Some(last), None)
    {
        let found = extrema.next().unwrap();
        expected(found, kind);
        assert_eq!((&found.place, found.value.0.clone()), (&Location::Point(last.end.clone()), height));
        total += 1;
    }
    assert_eq!((extrema.next(), jumps.next()), (None, None));
    total
}

fn compare_all(degree: usize, knots: Vec<BigRational>, ratio: BigRational) -> usize {
    let knots = KnotVector::new(knots).unwrap();
    let basis = Basis::new(knots, degree, Index::from_ratio(ratio).unwrap()).unwrap();
    let pieces = Pieces::of(&basis);
    (0..=basis.n()).map(|i| compare(&basis, &pieces, i)).max().unwrap()
}

/// Knots with every multiplicity up to k + 1, gaps huge next to tiny, ends open or not.
fn instance() -> impl Strategy<Value = (usize, Vec<BigRational>, BigRational)> {
    let gap = prop_oneof![
        4 => (1_i64..=5).prop_map(|n| number(n, 1)),
        2 => (1_i64..=4).prop_map(|n| number(1, 7 * n)),
        1 => Just(number(60, 1)),
    ];
    let ratio = (1_i64..=12, 1_i64..=12).prop_map(|(p, q)| number(p, q));
    let ratio =
        prop_oneof![4 => ratio, 1 => Just(number(1, 1)), 1 => Just(number(1, 90)), 1 => Just(number(70, 1))];
    (1_usize..=6, ratio).prop_flat_map(move |(degree, ratio)| {
        let multiplicity = prop_oneof![3 => Just(1), 1 => 1..=degree + 1];
        let groups = prop::collection::vec((gap.clone(), multiplicity), 3..=6);
        let knots = groups.prop_map(move |groups| {
            let mut knots: Vec<BigRational> = Vec::new();
            let mut x = BigRational::zero();
            for (gap, multiplicity) in groups {
                knots.extend(vec![x.clone(); multiplicity]);
                x += gap;
            }
            while knots.len() < 2 * degree + 1 {
                knots.push(x.clone());
                x += number(1, 2);
            }
            knots
        });
        (Just(degree), knots, Just(ratio))
    })
}

proptest! {
    // Several functions each: several hundred of them.
    #![proptest_config(ProptestConfig::with_cases(60))]

    #[test]
    fn shapes_are_those_of_the_oracle((degree, knots, ratio) in instance()) {
        compare_all(degree, knots, ratio);
    }
}

fn integers(knots: &[i64]) -> Vec<BigRational> {
    knots.iter().map(|&t| number(t, 1)).collect()
}

#[test]
fn functions_with_several_maxima() {
    assert_eq!(compare_all(3, integers(&[0, 0, 0, 0, 1, 2, 4, 4]), number(5, 3)), 3);
    assert_eq!(compare_all(4, integers(&[0, 1, 2, 3, 4, 5, 5, 5, 5]), number(2, 5)), 3);
    let gaps = [798_629, 50_969, 15_552_000, 72_327, 2_424_870, 9_185_290];
    let mut knots = vec![0; 7];
    for (i, gap) in gaps.iter().enumerate() {
        knots[i + 1] = knots[i] + gap;
    }
    knots.extend([knots[6]; 4]);
    assert_eq!(compare_all(5, integers(&knots), number(183_588, 1_000_000)), 5);
}

/// The window of r with two maxima on uniform knots of degree 4 closes at an end near 0.39569: on both sides of it, and
/// very close to it, the oracle sees the same.
#[test]
fn nearly_a_change() {
    let knots = || integers(&[0, 1, 2, 3, 4, 5, 5, 5, 5]);
    let partition = {
        let basis = Basis::new(KnotVector::new(knots()).unwrap(), 4, Index::infinity()).unwrap();
        knotproof::analysis::Partition::by_ratio(&basis, 0, &BigRational::new(1.into(), BigInt::one() << 100))
    };
    let (lo, hi) = partition.ends()[0].interval.clone();
    assert_eq!([compare_all(4, knots(), lo), compare_all(4, knots(), hi)], [1, 3]);
}

/// 52 − 304x³ − 23x⁸ has one root in (0, 1], which another root counter got wrong.
#[test]
fn the_oracle_counts_roots() {
    let p: Rational = [52, 0, 0, -304, 0, 0, 0, 0, -23].map(|c| number(c, 1)).to_vec();
    assert_eq!(Sturm::new(&p).count(&number(0, 1), &number(1, 1)), 1);
}
