//! Root isolation and shapes against an independent oracle: Sturm sequences over the rationals, written here,
//! and for the shapes the recursion of the definition in x itself, not in the positive coordinate.

#![allow(clippy::unwrap_used, reason = "helpers of tests: a failure is a failed test")]

use knotproof::analysis::{
    ExtremumKind, Location, Pieces, Shape, Sign, count_positive_roots, count_roots_between, positive_roots,
    sign_pattern,
};
use knotproof::scalar::{BigRational, Polynomial, RationalFunction, Ring, integer, rational};
use knotproof::spline::{Basis, Index, KnotVector, Side, by_definition};
use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::Signed;
use proptest::prelude::*;

type Poly = Polynomial<BigRational>;

fn polynomial(coefficients: &[i64]) -> Poly {
    let mut coefficients = coefficients.iter().map(|&c| rational(c, 1));
    Polynomial::new(coefficients.next().unwrap_or(integer(0)), coefficients)
}

/// A Sturm sequence of the square-free part of p ≠ 0, without the factors (x − a) for the given a.
struct Sturm {
    sequence: Vec<Poly>,
}

impl Sturm {
    fn new(p: &Poly, without: &[&BigRational]) -> Self {
        // Scaled by a positive factor, without which the coefficients explode.
        let remainder = |p: &Poly, q: &Poly| {
            let (_, remainder) = p.divide(q).unwrap();
            let size = remainder.leading().abs();
            if size == integer(0) { remainder } else { remainder.scaled(&size.recip()) }
        };
        let (mut a, mut b) = (p.clone(), p.derivative());
        while !b.is_zero() {
            (a, b) = (b.clone(), remainder(&a, &b));
        }
        let mut first = p.divide(&a).unwrap().0;
        for root in without {
            let factor = Polynomial::new(-(*root).clone(), [integer(1)]);
            if first.evaluate(root) == integer(0) {
                first = first.divide(&factor).unwrap().0;
            }
        }
        let mut sequence = vec![first.clone(), first.derivative()];
        while let [.., p, q] = &sequence[..] {
            if q.is_zero() {
                sequence.pop();
                break;
            }
            let next = remainder(p, q).negate();
            sequence.push(next);
        }
        Self { sequence }
    }

    fn variations(signs: impl Iterator<Item = BigRational>) -> usize {
        let signs: Vec<bool> = signs.filter(|v| *v != integer(0)).map(|v| v > integer(0)).collect();
        signs.windows(2).filter(|pair| pair[0] != pair[1]).count()
    }

    fn variations_at(&self, x: &BigRational) -> usize {
        Self::variations(self.sequence.iter().map(|p| p.evaluate(x)))
    }

    /// The number of roots in (a, b], or in (a, ∞).
    fn count(&self, a: &BigRational, b: Option<&BigRational>) -> usize {
        let above = match b {
            Some(b) => self.variations_at(b),
            None => Self::variations(self.sequence.iter().map(|p| p.leading().clone())),
        };
        self.variations_at(a) - above
    }

    fn is_root(&self, x: &BigRational) -> bool {
        self.sequence[0].evaluate(x) == integer(0)
    }
}

/// Factors that make trouble: multiple, nearly multiple and rational roots, roots at 0 and 1, no real root.
fn factor() -> impl Strategy<Value = Poly> {
    let linear = (-3_i64..=9, 1_i64..=6, 1_usize..=3)
        .prop_map(|(p, q, multiplicity)| polynomial(&[-p, q]).power(multiplicity));
    // (q²(u − p/q)² · 2^e ± 1): two roots or none very close to p/q.
    let nearly_double = (1_i64..=9, 1_i64..=6, 2_u32..=40, prop::bool::ANY).prop_map(|(p, q, e, real)| {
        let square = polynomial(&[-p, q]).power(2).scaled(&rational(1_i64 << e, 1));
        square.plus(&polynomial(&[if real { -1 } else { 1 }]))
    });
    let close = (0_i64..=5, 1_u32..=60).prop_map(|(p, e)| {
        let gap = rational(1, 1_i64 << e);
        let linear = |root: BigRational| Polynomial::new(-root, [integer(1)]);
        linear(rational(p, 2)).times(&linear(rational(p, 2) + gap))
    });
    let special = prop::sample::select(vec![
        polynomial(&[0, 1]),
        polynomial(&[0, 0, 1]),
        polynomial(&[-1, 1]),
        polynomial(&[1, -2, 1]),
        polynomial(&[-2, 0, 1]),
        polynomial(&[1, -1, 1]),
        polynomial(&[52, 0, 0, -304, 0, 0, 0, 0, -23]),
        // Mignotte: x⁷ − 2(5x − 1)², two roots near 1/5.
        polynomial(&[-2, 20, -50, 0, 0, 0, 0, 1]),
        polynomial(&[0]),
        polynomial(&[-7]),
    ]);
    let random = prop::collection::vec(-20_i64..=20, 1..=9).prop_map(|list| polynomial(&list));
    prop_oneof![3 => linear, 2 => nearly_double, 2 => close, 2 => special, 2 => random]
}

fn trouble() -> impl Strategy<Value = Poly> {
    let product = prop::collection::vec(factor(), 1..=4)
        .prop_map(|factors| factors.iter().fold(polynomial(&[1]), |product, f| product.times(f)));
    let high = prop::collection::vec(-20_i64..=20, 15..=28).prop_map(|list| polynomial(&list));
    prop_oneof![5 => product, 1 => high]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn isolation_agrees_with_sturm(p in trouble()) {
        let zero = integer(0);
        let roots = positive_roots(&p);
        prop_assert_eq!(count_positive_roots(&p), roots.len());
        if p.is_zero() {
            prop_assert!(roots.is_empty());
            return Ok(());
        }
        let sturm = Sturm::new(&p, &[&zero]);
        prop_assert_eq!(sturm.count(&zero, None), roots.len());
        for mut root in roots.clone() {
            for _ in 0..4 {
                let (lo, hi) = root.interval();
                prop_assert!(zero < lo && lo <= hi);
                if root.exact().is_some() {
                    prop_assert!(sturm.is_root(&lo));
                } else {
                    prop_assert!(!sturm.is_root(&lo) && !sturm.is_root(&hi));
                    prop_assert_eq!(sturm.count(&lo, Some(&hi)), 1);
                }
                root.refine();
            }
            if let Some(u) = root.rational() {
                prop_assert!(sturm.is_root(&u));
            }
        }
        for pair in roots.windows(2) {
            prop_assert!(pair[0].hi() <= pair[1].lo());
        }
        let pattern = sign_pattern(&p);
        let mut below = zero.clone();
        for ((u, sign), root) in pattern.between().iter().zip(pattern.roots()) {
            prop_assert!(below < *u || below == *u && below != zero);
            prop_assert_eq!(*sign, Sign::of(&p.evaluate(u)));
            prop_assert!(*u <= root.interval().0 && *sign != Sign::Zero);
            below = root.interval().1;
        }
    }

    #[test]
    fn roots_between_agree_with_sturm(p in trouble(), a in -3_i64..=9, width in 1_i64..=9, d in 1_i64..=4) {
        prop_assume!(!p.is_zero());
        let ends = [rational(a, d), rational(a + width, d)];
        let sturm = Sturm::new(&p, &ends.each_ref());
        // In X = d·x, and with integer coefficients.
        let scaled = p.scaled_argument(&rational(1, d));
        let common = scaled.coefficients().iter().fold(BigInt::from(1), |common, c| common.lcm(c.denom()));
        let integers: Vec<BigInt> = scaled.coefficients().iter().map(|c| c.numer() * (&common / c.denom())).collect();
        let count = count_roots_between(&integers, &a.into(), &(a + width).into());
        prop_assert_eq!(count, sturm.count(&ends[0], Some(&ends[1])));
    }

    #[test]
    fn planted_rational_roots_are_found(planted in prop::collection::btree_set((1_i64..=30, 1_i64..=30), 1..=5)) {
        let mut roots: Vec<_> = planted.iter().map(|&(p, q)| rational(p, q)).collect();
        let p = planted.iter().fold(polynomial(&[3, 0, 1]), |p, &(a, b)| p.times(&polynomial(&[-a, b])));
        roots.sort();
        roots.dedup();
        let found: Option<Vec<_>> = positive_roots(&p).iter_mut().map(|root| root.rational()).collect();
        prop_assert_eq!(found, Some(roots));
    }
}

/// How a function runs on (a, b), as a word of U (rising), D (falling) and F (constant), from the numerator of
/// its derivative in x.
fn runs(slope: &Poly, a: &BigRational, b: &BigRational) -> String {
    if slope.is_zero() {
        return "F".into();
    }
    let sturm = Sturm::new(slope, &[a, b]);
    let mut samples = Vec::new();
    let mut cells = vec![(a.clone(), b.clone())];
    while let Some((lo, hi)) = cells.pop() {
        let roots = sturm.count(&lo, Some(&hi));
        if roots == 0 {
            samples.push((lo + hi) / integer(2));
        } else if roots == 1 && lo != *a && hi != *b {
            samples.extend([lo, hi]);
        } else {
            let cut = (1..).map(|n| &lo + (&hi - &lo) * rational(n, n + 2)).find(|cut| !sturm.is_root(cut));
            let cut = cut.unwrap();
            cells.extend([(cut.clone(), hi), (lo, cut)]);
        }
    }
    samples.iter().map(|x| if slope.evaluate(x) > integer(0) { 'U' } else { 'D' }).collect()
}

/// The whole course of G_i^k as a word: runs, jumps up (/) and down (\), and E at t_m.
fn course(basis: &Basis, i: usize) -> (String, Vec<BigRational>) {
    let knots = basis.knots();
    let (from, to) = basis.support(i);
    let mut word = String::new();
    let mut jumps = Vec::new();
    let x = RationalFunction::variable(&integer(1));
    let mut jump = |word: &mut String, at: &BigRational| {
        let left = &basis.values(at, Side::Left)[i];
        let right = &basis.values(at, Side::Right)[i];
        if left != right {
            word.push(if left < right { '/' } else { '\\' });
            jumps.push(at.clone());
        }
    };
    for span in knots.spans() {
        let (a, b) = knots.ends(span).expect("a span of these knots");
        if from <= a && b <= to {
            jump(&mut word, a);
            let piece = &by_definition(basis, span, &x).expect("a span of these knots")[basis.degree()][i];
            let (p, q) = (piece.numerator(), piece.denominator());
            let slope = p.derivative().times(q).minus(&p.times(&q.derivative()));
            word.push_str(&runs(&slope, a, b));
        }
    }
    if to == knots.last() {
        word.push('E')
    } else {
        jump(&mut word, to)
    }
    jumps.retain(|at| at != knots.first());
    (word, jumps)
}

/// Local maxima in a course: up, constant or not, then down; a jump down ends one only if it was constant.
fn maxima(word: &str) -> usize {
    let symbols: Vec<char> = word.chars().collect();
    let ends_maximum = |at: usize| {
        let constant = symbols[at + 1..].iter().take_while(|&&c| c == 'F').count();
        match symbols.get(at + 1 + constant) {
            Some('D' | 'E') => true,
            Some('\\') => constant > 0,
            _ => false,
        }
    };
    (0..symbols.len()).filter(|&at| matches!(symbols[at], 'U' | '/') && ends_maximum(at)).count()
}

/// Small knot vectors with every kind of multiplicity, all signs of α, α near 0 and 1.
fn basis() -> impl Strategy<Value = Basis> {
    let gap = prop_oneof![3 => Just(0_usize), 3 => Just(1), 1 => Just(2), 1 => Just(9)];
    let index = prop::sample::select(vec!["inf", "-1", "2", "5", "-1/7", "8/7", "-1/100", "101/100"]);
    let degree = prop_oneof![5 => 1_usize..=3, 1 => Just(4)];
    (degree, 0_usize..=3).prop_flat_map(move |(k, more)| {
        (prop::collection::vec(gap.clone(), (2 * k).max(k + 1) + more), index.clone()).prop_filter_map(
            "at least one span",
            move |(gaps, index)| {
                let sums = gaps.iter().scan(0, |t, gap| {
                    *t += gap;
                    Some(integer(*t))
                });
                let knots = KnotVector::new(std::iter::once(integer(0)).chain(sums).collect()).ok()?;
                Basis::new(knots, k, index.parse::<Index>().ok()?).ok()
            },
        )
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    #[test]
    fn shapes_agree_with_the_definition_in_x(basis in basis()) {
        let pieces = Pieces::of(&basis);
        for i in 0..=basis.n() {
            let shape = Shape::of(&pieces, i);
            let (word, jumps) = course(&basis, i);
            prop_assert_eq!(shape.local_maxima().count(), maxima(&word), "G_{} of {:?}: {}", i, basis, word);
            let found: Vec<_> = shape.jumps().iter().map(|jump| jump.at.clone()).collect();
            prop_assert_eq!(&found, &jumps);
            for extremum in shape.extrema() {
                check_place(&basis, i, extremum)?;
            }
            let only = shape.local_maxima().next().map(|extremum| &extremum.place);
            if shape.strong() && jumps.is_empty() && !matches!(only, Some(Location::Plateau { .. })) {
                // A continuous function on a closed interval attains its supremum.
                prop_assert_eq!(shape.weak(), Some(true));
            }
            if shape.local_maxima().count() == 0 {
                prop_assert_eq!(shape.weak(), Some(false));
            }
        }
    }
}

/// The value at an extremum is right, and larger (smaller) than at points close by.
fn check_place(
    basis: &Basis,
    i: usize,
    extremum: &knotproof::analysis::Extremum,
) -> Result<(), TestCaseError> {
    let value = |x: &BigRational| basis.values(x, Side::Right)[i].clone();
    let better = |a: &BigRational, b: &BigRational| match extremum.kind {
        ExtremumKind::Maximum => a > b,
        ExtremumKind::Minimum => a < b,
    };
    let (lo, hi) = &extremum.value;
    prop_assert!(lo <= hi);
    match &extremum.place {
        Location::Point(x) => {
            prop_assert_eq!(lo, hi);
            prop_assert_eq!(&value(x), lo);
            let step = rational(1, 1 << 40);
            for near in [x - &step, x + &step] {
                // On t_0 and t_m the function is 0 on the outer side.
                prop_assert!(better(lo, &value(&near)));
            }
        }
        Location::Irrational { lo: left, hi: right, .. } => {
            prop_assert!(left < right && !extremum.at_knot);
            prop_assert!(better(hi, &value(left)) || better(lo, &value(left)));
            let inside = value(&((left + right) / integer(2)));
            match extremum.kind {
                ExtremumKind::Maximum => prop_assert!(inside <= *hi),
                ExtremumKind::Minimum => prop_assert!(inside >= *lo),
            }
        }
        Location::Plateau { from, to, .. } => {
            prop_assert_eq!(lo, hi);
            prop_assert_eq!(&value(from), lo);
            prop_assert_eq!(&value(&((from + to) / integer(2))), lo);
        }
    }
    Ok(())
}

#[test]
fn the_oracle_counts() {
    let count = |coefficients: &[i64]| Sturm::new(&polynomial(coefficients), &[]).count(&integer(0), None);
    assert_eq!(count(&[52, 0, 0, -304, 0, 0, 0, 0, -23]), 1);
    assert_eq!(count(&[2, -3, 1]), 2);
    assert_eq!(count(&[1, 0, 1]), 0);
    assert_eq!(
        ["UD", "/DU\\", "/FE", "UF\\", "UDUD", "UUFFD", "U/D", "/U\\"].map(maxima),
        [1, 1, 1, 1, 2, 1, 1, 0]
    );
}
