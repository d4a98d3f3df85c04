//! Functions and curves as polygons that an eye cannot tell from them, in `f64`.

use num_traits::ToPrimitive;

use crate::scalar::BigRational;
use crate::spline::{Basis, Curve, HasWeights, Point, Span, WeightKind};

/// The nearest `f64`, or one beside it.
pub(in crate::report) fn float(x: &BigRational) -> f64 {
    x.to_f64().unwrap_or(f64::NAN)
}

/// A point of the plane, rounded. What has one coordinate lies on the first axis.
pub(super) fn planar(point: &Point) -> (f64, f64) {
    let coordinate = |c: usize| point.get(c).map_or(0.0, float);
    (coordinate(0), coordinate(1))
}

/// Halvings that are made in any case, and at most.
const HALVINGS: std::ops::RangeInclusive<u32> = 3..=10;

/// Points of t ↦ `at`(t) from `from` to `to`, so close that what is between them is off the straight line by less
/// than `tolerance` in either coordinate.
pub(in crate::report) fn polygon(
    at: impl Fn(f64) -> (f64, f64),
    (from, to): (f64, f64),
    tolerance: (f64, f64),
) -> Vec<(f64, f64)> {
    let mut points = vec![at(from)];
    halve(&at, (from, at(from)), (to, at(to)), tolerance, 0, &mut points);
    points
}

/// The points after the first, up to the second.
fn halve(
    at: &impl Fn(f64) -> (f64, f64),
    (t, start): (f64, (f64, f64)),
    (s, end): (f64, (f64, f64)),
    tolerance: (f64, f64),
    depth: u32,
    points: &mut Vec<(f64, f64)>,
) {
    let half = f64::midpoint(t, s);
    let middle = at(half);
    let off = |a: f64, m: f64, b: f64| (m - f64::midpoint(a, b)).abs();
    let flat = off(start.0, middle.0, end.0) < tolerance.0 && off(start.1, middle.1, end.1) < tolerance.1;
    if depth >= *HALVINGS.end() || (flat && depth >= *HALVINGS.start()) {
        points.push(end);
        return;
    }
    halve(at, (t, start), (half, middle), tolerance, depth + 1, points);
    halve(at, (half, middle), (s, end), tolerance, depth + 1, points);
}

/// G_i^k on a span, at an x of its closure.
pub(in crate::report) fn value<W: HasWeights>(basis: &Basis<W>, i: usize, span: Span, x: f64) -> f64 {
    basis.active(span, &x).map_or(f64::NAN, |active| active.get(i).copied().unwrap_or_default())
}

/// A point of a curve on a span, at an x of its closure. Forms are summed exactly: their terms may cancel in floats.
pub(super) fn curve_point<W: HasWeights>(curve: &Curve<W>, span: Span, x: f64) -> (f64, f64) {
    let basis = curve.basis();
    let none = (f64::NAN, f64::NAN);
    if let WeightKind::Forms(_) = basis.weights().kind() {
        let at = BigRational::from_float(x).and_then(|x| basis.active(span, &x).ok());
        return at.and_then(|active| curve.combine(&active).ok()).map_or(none, |point| planar(&point));
    }
    let Ok(active) = basis.active(span, &x) else { return none };
    active.iter().fold((0.0, 0.0), |(a, b), (i, g)| {
        let (x, y) = planar(&curve.points()[i]);
        (a + g * x, b + g * y)
    })
}
