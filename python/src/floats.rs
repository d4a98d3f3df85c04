//! Values at arrays of floats, by SciPy's conventions: right limits, and at t_{n+1}, where the base interval ends, left ones.
//!
//! Of an index by [`FloatBasis`], on the floats nearest to its numbers; of another family exactly, and then rounded.

use knotproof::float::{FloatBasis, FloatCurve, Precision, hexadecimal};
use knotproof::scalar::{BigRational, RationalAlgebra, parse_rational};
use knotproof::spline::{AnyWeights, Basis, Curve, CurveEvaluator, Index, Sampler, Side, Span};

use crate::error::Wrong;

/// The floats of an array of NumPy.
pub(crate) fn read(bytes: &[u8]) -> Vec<f64> {
    bytes.as_chunks().0.iter().map(|bytes| f64::from_ne_bytes(*bytes)).collect()
}

/// The same the other way round.
pub(crate) fn written(floats: &[f64]) -> Vec<u8> {
    floats.iter().flat_map(|float| float.to_ne_bytes()).collect()
}

/// For points of [t_k, t_{n+1}]: the index of the first of the k + 1 functions that live there, and their values, one point after
/// the other.
pub(crate) fn design(basis: &Basis<AnyWeights>, xs: &[f64]) -> Result<(Vec<i64>, Vec<f64>), Wrong> {
    let k = basis.degree();
    let mut values = vec![0.0; xs.len() * (k + 1)];
    let mut spans = vec![None; xs.len()];
    match basis.weights() {
        AnyWeights::Index(index) => {
            let basis = nearest(basis, index)?;
            basis.values_at(xs, Precision::Accurate, &mut spans, &mut values).map_err(wrong)?;
            let end = basis.knots()[basis.n() + 1];
            for ((x, span), values) in xs.iter().zip(&mut spans).zip(values.chunks_exact_mut(k + 1)) {
                if is(*x, end) {
                    *span = basis.values(*x, Side::Left, values).map_err(wrong)?;
                }
            }
        }
        AnyWeights::Forms(_) => {
            let mut sampler = Sampler::new(basis);
            for ((x, span), values) in xs.iter().zip(&mut spans).zip(values.chunks_exact_mut(k + 1)) {
                let (x, side) = exact(*x, basis)?;
                *span = basis.knots().span_at(&x, side);
                let (Some(active), Some(span)) = (sampler.values(&x, side), *span) else { continue };
                for (i, value) in active.iter() {
                    let place = (i + k).checked_sub(span.index()).and_then(|place| values.get_mut(place));
                    place.into_iter().for_each(|place| *place = 0.0_f64.embed(value));
                }
            }
        }
    }
    let first = |(span, x): (&Option<Span>, &f64)| {
        // j − k is there, as the points are in the base interval.
        let first = span.and_then(|span| i64::try_from(span.index().checked_sub(k)?).ok());
        first.ok_or_else(|| Wrong::with("x", format!("{x} is not in [t_k, t_(n+1)]")))
    };
    let first = spans.iter().zip(xs).map(first).collect::<Result<_, _>>()?;
    Ok((first, values))
}

/// The points of a curve at points of the same interval, one after the other.
pub(crate) fn points(curve: &Curve<AnyWeights>, xs: &[f64]) -> Result<Vec<f64>, Wrong> {
    let dimension = curve.dimension();
    let mut points = vec![0.0; xs.len() * dimension];
    match curve.basis().weights() {
        AnyWeights::Index(index) => {
            let basis = nearest(curve.basis(), index)?;
            let end = basis.knots()[basis.n() + 1];
            let controls = curve.points().iter().flatten().map(|c| 0.0_f64.embed(c)).collect();
            let curve = FloatCurve::new(basis, dimension, controls);
            let curve = curve.map_err(|error| Wrong::with("points", error))?;
            curve.points_at(xs, Precision::Accurate, &mut points).map_err(wrong)?;
            for (x, point) in xs.iter().zip(points.chunks_exact_mut(dimension)) {
                if is(*x, end) {
                    curve.point(*x, Side::Left, point).map_err(wrong)?;
                }
            }
        }
        AnyWeights::Forms(_) => {
            let mut evaluator = CurveEvaluator::new(curve);
            for (x, point) in xs.iter().zip(points.chunks_exact_mut(dimension)) {
                let (x, side) = exact(*x, curve.basis())?;
                for (place, c) in point.iter_mut().zip(evaluator.point(&x, side)) {
                    *place = 0.0_f64.embed(&c);
                }
            }
        }
    }
    Ok(points)
}

fn nearest(basis: &Basis<AnyWeights>, index: &Index) -> Result<FloatBasis<f64>, Wrong> {
    FloatBasis::nearest(&basis.with(index.clone())).map_err(|error| Wrong::with("in f64", error))
}

fn wrong(error: impl std::fmt::Display) -> Wrong {
    Wrong::with("x", error)
}

/// Is x the knot itself, and no float close by?
#[expect(clippy::float_cmp, reason = "that is the question")]
fn is(x: f64, knot: f64) -> bool {
    x == knot
}

/// The number that a float is, and the side of its limit; the float of an end of the base interval is that end.
fn exact(x: f64, basis: &Basis<AnyWeights>) -> Result<(BigRational, Side), Wrong> {
    let [start, end] = [basis.degree(), basis.n() + 1].map(|i| basis.knots().t(i));
    Ok(if is(x, 0.0_f64.embed(end)) {
        (end.clone(), Side::Left)
    } else if is(x, 0.0_f64.embed(start)) {
        (start.clone(), Side::Right)
    } else {
        (parse_rational(&hexadecimal(x)).map_err(wrong)?, Side::Right)
    })
}
