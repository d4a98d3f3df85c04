//! Partitions of a parameter by the number of local maxima, against the shape at single values.

#![allow(clippy::unwrap_used, reason = "helpers of tests: a failure is a failed test")]

use knotproof::analysis::{FreeKnotError, Partition, PartitionEvent, Pieces, Shape};
use knotproof::scalar::{integer, rational};
use knotproof::spline::{Basis, Index, KnotVector};
use num_rational::BigRational;
use proptest::prelude::*;

fn basis(degree: usize, gaps: &[usize], ratio: BigRational) -> Basis {
    let mut knots = vec![integer(0)];
    for &gap in gaps {
        knots.push(&knots[knots.len() - 1] + integer(gap));
    }
    // The first function does not change if the last knot is repeated, but a basis has 2k + 1 knots at least.
    while knots.len() < 2 * degree + 1 {
        knots.push(knots[knots.len() - 1].clone());
    }
    Basis::new(KnotVector::new(knots).unwrap(), degree, Index::from_ratio(ratio).unwrap()).unwrap()
}

fn uniform(degree: usize) -> Basis {
    basis(degree, &vec![1; degree + 1], integer(1))
}

fn count(basis: &Basis, i: usize) -> usize {
    Shape::of(&Pieces::of(basis), i).local_maxima().count()
}

/// What the partition says about a value of the parameter; `None` within the interval of an end.
fn said(partition: &Partition, x: &BigRational) -> Option<usize> {
    let inside =
        partition.cells().iter().find(|cell| cell.from < *x && cell.to.as_ref().is_none_or(|to| x < to));
    inside.map(|cell| cell.local_maxima.unwrap())
}

/// Cells and ends take turns, and neighbours differ.
fn is_consistent(partition: &Partition) {
    let (cells, ends) = (partition.cells(), partition.ends());
    assert!(partition.is_decided());
    assert_eq!(cells.len(), ends.len() + 1);
    for (pair, end) in cells.windows(2).zip(ends) {
        assert_eq!((pair[0].to.as_ref(), &pair[1].from), (Some(&end.interval.0), &end.interval.1));
        let counts = [pair[0].local_maxima, Some(end.local_maxima), pair[1].local_maxima];
        assert!(counts[0] != counts[1] || counts[1] != counts[2]);
        assert!(Some(end.local_maxima) <= pair[0].local_maxima.min(pair[1].local_maxima));
    }
}

/// Two ends closer than the width asked for: there is room for the cell between them all the same.
#[test]
fn ends_close_together_stay_apart() {
    for (gaps, width) in [
        (&[0, 2, 40, 40][..], rational(1, 1 << 20)),
        (&[0, 1, 60, 60], rational(1, 1 << 20)),
        (&[0, 1, 1, 2], rational(1, 10)),
        (&[0, 1, 1, 2], integer(1_000_000)),
        (&[1, 1, 1, 1, 1], integer(1)),
    ] {
        let basis = basis(gaps.len() - 1, gaps, integer(1));
        let partition = Partition::by_ratio(&basis, 0, &width);
        is_consistent(&partition);
        let fine = Partition::by_ratio(&basis, 0, &rational(1, 1 << 40));
        let counts = |partition: &Partition| -> Vec<_> {
            partition.cells().iter().map(|cell| cell.local_maxima).collect()
        };
        assert_eq!(counts(&partition), counts(&fine), "{gaps:?}");
        assert!(counts(&fine).contains(&Some(2)), "{gaps:?}");
    }
    let knots = KnotVector::new([0, 0, 0, 0, 1, 2, 4, 4].map(integer).to_vec()).unwrap();
    let basis = Basis::new(knots, 3, "5/2".parse().unwrap()).unwrap();
    let partition = Partition::by_knot(&basis, 2, 5, &rational(1, 10)).unwrap();
    is_consistent(&partition);
    assert!(partition.cells().iter().any(|cell| cell.local_maxima == Some(2)));
}

#[test]
fn uniform_knots() {
    for (degree, windows) in [(1, 0), (2, 0), (3, 0), (4, 1), (5, 1), (6, 2), (7, 2)] {
        let partition = Partition::by_ratio(&uniform(degree), 0, &rational(1, 1 << 30));
        is_consistent(&partition);
        let counts: Vec<_> = partition.cells().iter().map(|cell| cell.local_maxima.unwrap()).collect();
        let expected: Vec<usize> = (0..=4 * windows).map(|cell| 1 + cell % 2).collect();
        assert_eq!(counts, expected, "degree {degree}");
        // r ↦ 1/r reverses the function.
        for (end, mirrored) in partition.ends().iter().zip(partition.ends().iter().rev()) {
            let (lo, hi) = &mirrored.interval;
            assert!(end.interval.0 <= lo.recip() && hi.recip() <= end.interval.1);
            assert!(end.events.iter().all(|(_, event)| *event != PartitionEvent::Fold));
        }
    }
}

#[test]
fn the_polynomial_of_an_end_changes_its_sign_there() {
    let partition = Partition::by_ratio(&uniform(6), 0, &rational(1, 1 << 40));
    for end in partition.ends() {
        let [polynomial] = &end.polynomials[..] else { panic!("one") };
        let at = |x: &BigRational| {
            polynomial.iter().rev().fold(integer(0), |value, c| value * x + BigRational::from(c.clone()))
        };
        assert!(at(&end.interval.0) * at(&end.interval.1) < integer(0));
    }
}

#[test]
fn two_windows_next_to_each_other_and_a_fold() {
    // Found by search: gaps with three local maxima for some r (T. of degree 5).
    let gaps = [798_629, 50_969, 15_552_000, 72_327, 2_424_870, 9_185_290];
    let partition = Partition::by_ratio(&basis(5, &gaps, integer(1)), 0, &rational(1, 1 << 30));
    is_consistent(&partition);
    assert_eq!(said(&partition, &rational(183_588, 1_000_000)), Some(3));
}

#[test]
fn functions_that_no_parameter_changes() {
    let one = rational(1, 1 << 20);
    // One span only: C(3, j)·w^j(1 − w)^(3−j). The last of two is cut off by the jump at its end.
    for (degree, gaps, i, maxima) in [
        (3, vec![0, 0, 0, 2, 0, 0, 0], 1, 1),
        (0, vec![3, 1], 0, 1),
        (1, vec![0, 1, 0, 1], 1, 0),
        (2, vec![0, 0, 1, 1], 0, 1),
    ] {
        let basis = basis(degree, &gaps, integer(1));
        let partition = Partition::by_ratio(&basis, i, &one);
        is_consistent(&partition);
        assert_eq!(partition.cells()[0].local_maxima, Some(maxima), "{gaps:?}");
        assert_eq!((partition.cells().len(), partition.ends()), (1, &[][..]));
    }
    // A function without any support.
    let empty = Partition::by_ratio(&basis(1, &[1, 0, 0, 1], integer(1)), 1, &one);
    assert_eq!(empty.cells()[0].local_maxima, Some(0));
}

#[test]
fn a_knot_that_cannot_move() {
    let basis = basis(2, &[0, 0, 1, 1, 1, 0, 0], integer(1));
    let refused = |knot| Partition::by_knot(&basis, 0, knot, &rational(1, 1024)).unwrap_err();
    assert_eq!(refused(0), FreeKnotError::NoNeighbours { knot: 0, last: 6 });
    assert_eq!(refused(7), FreeKnotError::NoNeighbours { knot: 7, last: 6 });
    assert_eq!(refused(1), FreeKnotError::Fixed { knot: 1, place: integer(0) });
}

#[test]
fn a_free_knot_near_a_known_case() {
    // (0, 0, 0, 0, 1, 2, 4, 4) with α = 5/2: G_2³ has two local maxima.
    let basis = basis(3, &[0, 0, 0, 1, 1, 2, 0], rational(5, 3));
    assert_eq!(count(&basis, 2), 2);
    for knot in [4, 5] {
        let partition = Partition::by_knot(&basis, 2, knot, &rational(1, 1 << 30)).unwrap();
        is_consistent(&partition);
        assert_eq!(said(&partition, basis.knots().t(knot)), Some(2));
        assert!(partition.cells().len() > 1);
    }
    let outside = Partition::by_knot(&basis, 0, 5, &rational(1, 1 << 30)).unwrap();
    assert_eq!(outside.cells().len(), 1);
}

/// Gaps that lean towards trouble: equal, empty, huge next to tiny.
fn gaps(degree: usize) -> impl Strategy<Value = Vec<usize>> {
    let gap = prop_oneof![4 => 1_usize..=9, 1 => Just(0), 1 => Just(100), 1 => Just(1000)];
    prop::collection::vec(gap, degree + 1)
        .prop_filter("not continuous", |gaps| gaps.iter().filter(|&&gap| gap > 0).count() > 1)
}

fn ratio() -> impl Strategy<Value = BigRational> {
    (1_i64..=40, 1_i64..=40).prop_map(|(p, q)| rational(p, q))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(30))]

    #[test]
    fn partitions_by_ratio_agree_with_shapes(
        gaps in (3_usize..=5).prop_flat_map(gaps),
        ratios in prop::collection::vec(ratio(), 6),
    ) {
        let degree = gaps.len() - 1;
        let partition = Partition::by_ratio(&basis(degree, &gaps, integer(1)), 0, &rational(1, 1 << 30));
        is_consistent(&partition);
        for r in ratios {
            if let Some(maxima) = said(&partition, &r) {
                prop_assert_eq!(maxima, count(&basis(degree, &gaps, r), 0));
            }
        }
    }

    #[test]
    fn partitions_by_knot_agree_with_shapes(
        gaps in (3_usize..=4).prop_flat_map(gaps),
        r in ratio(),
        knot in 1_usize..=4,
        places in prop::collection::vec(1_i64..64, 6),
    ) {
        let degree = gaps.len() - 1;
        let start = basis(degree, &gaps, r);
        let Ok(partition) = Partition::by_knot(&start, 0, knot, &rational(1, 1 << 30)) else { return Ok(()) };
        is_consistent(&partition);
        let mut knots = start.knots().knots().to_vec();
        let (from, to) = (knots[knot - 1].clone(), knots[knot + 1].clone());
        for place in places {
            knots[knot] = &from + (&to - &from) * rational(place, 64);
            let moved = KnotVector::new(knots.clone()).unwrap();
            let moved = Basis::new(moved, degree, start.index().clone()).unwrap();
            if let Some(maxima) = said(&partition, &knots[knot]) {
                prop_assert_eq!(maxima, count(&moved, 0));
            }
        }
    }
}
