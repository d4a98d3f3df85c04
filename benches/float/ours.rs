//! One side of a comparison: how many million points a second, degree 3.
//!
//! float-throughput FOLDER takes its points from FOLDER/points, `f64` in the order of the machine, and compares
//! with FOLDER/values, four values at each for α = ∞.

use std::error::Error;
use std::fs;
use std::hint::black_box;
use std::time::Instant;

use knotproof::float::{FloatBasis, FloatCurve, Precision};
use knotproof::spline::Side;

/// The points of one call where they are all in one span: as much as fits a fast cache.
const FEW: usize = 1024;

fn main() -> Result<(), Box<dyn Error>> {
    let folder = std::env::args().nth(1).ok_or("float-throughput FOLDER")?;
    let points = floats(&format!("{folder}/points"))?;
    let knots = vec![0.0, 0.0, 0.0, 0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 5.0, 5.0, 5.0];
    agree(
        &FloatBasis::new(knots.clone(), 3, f64::INFINITY)?,
        &points,
        &floats(&format!("{folder}/values"))?,
    )?;

    // r = 1/3.
    let basis = FloatBasis::new(knots, 3, -0.5)?;
    let controls = vec![1.0, -2.0, 3.0, -4.0, 5.0, -6.0, 7.0, -8.0];
    let few: Vec<f64> = points[..FEW].iter().map(|x| 2.0 + x / 5.0).collect();
    let span = basis.span_at(2.5, Side::Right)?.ok_or("2.5 lies inside")?;
    let (mut spans, mut values) = (vec![None; points.len()], vec![0.0; 4 * points.len()]);
    for (name, precision) in [("accurate", Precision::Accurate), ("fast", Precision::Fast)] {
        for (kind, basis) in [("", basis.clone()), (", portable", basis.clone().portable())] {
            rate(&format!("{name}, scattered{kind}"), points.len(), || {
                basis.values_at(black_box(&points), precision, &mut spans, &mut values)
            })?;
            rate(&format!("{name}, one span{kind}"), FEW, || {
                basis.values_on(span, black_box(&few), precision, &mut values[..4 * FEW])
            })?;
            let curve = FloatCurve::new(basis, 1, controls.clone())?;
            rate(&format!("{name} curve, scattered{kind}"), points.len(), || {
                curve.points_at(black_box(&points), precision, &mut values[..points.len()])
            })?;
        }
    }
    rate("accurate, one by one", points.len(), || {
        points.iter().try_for_each(|x| basis.values(*x, Side::Right, &mut values[..4]).map(drop))
    })?;
    rate("plain triangle, one span", FEW, || {
        plain_triangle(1.0 / 3.0, &[0.0, 1.0, 2.0, 3.0, 4.0, 5.0], black_box(&few), &mut values[..4 * FEW]);
        Ok::<_, Box<dyn Error>>(())
    })
}

/// The best of many runs, short ones: on a busy machine a long one is always interrupted.
fn rate<E>(name: &str, points: usize, mut run: impl FnMut() -> Result<(), E>) -> Result<(), E> {
    let repeat = (20_000 / points).max(1);
    let mut best = f64::INFINITY;
    for _ in 0..150 {
        let start = Instant::now();
        for _ in 0..repeat {
            run()?;
        }
        best = best.min(start.elapsed().as_secs_f64());
    }
    println!("{name:<40}  {:8.1}", (repeat * points) as f64 / best / 1e6);
    Ok(())
}

fn floats(path: &str) -> Result<Vec<f64>, Box<dyn Error>> {
    let bytes = fs::read(path)?;
    let (floats, _) = bytes.as_chunks::<8>();
    Ok(floats.iter().map(|bytes| f64::from_ne_bytes(*bytes)).collect())
}

/// Are all values the other side's, up to its rounding?
fn agree(basis: &FloatBasis<f64>, points: &[f64], others: &[f64]) -> Result<(), Box<dyn Error>> {
    let (mut spans, mut values) = (vec![None; points.len()], vec![0.0; 4 * points.len()]);
    for precision in [Precision::Accurate, Precision::Fast] {
        basis.values_at(points, precision, &mut spans, &mut values)?;
        if others.len() != values.len() || values.iter().zip(others).any(|(a, b)| (a - b).abs() > 1e-14) {
            return Err("the values differ".into());
        }
    }
    Ok(())
}

/// What one would write for points of one span: The NURBS Book's triangle with r, a quotient for each pair of products,
/// in such a form that the compiler makes vectors of it.
#[inline(never)]
fn plain_triangle(r: f64, knots: &[f64; 6], points: &[f64], values: &mut [f64]) {
    let (a, rest) = values.split_at_mut(points.len());
    let (b, rest) = rest.split_at_mut(points.len());
    let (c, d) = rest.split_at_mut(points.len());
    for ((((x, a), b), c), d) in points.iter().zip(a).zip(b).zip(c).zip(d) {
        let left = [r * (x - knots[2]), r * (x - knots[1]), r * (x - knots[0])];
        let right = [knots[3] - x, knots[4] - x, knots[5] - x];
        let s = 1.0 / (left[0] + right[0]);
        let (v0, v1) = (right[0] * s, left[0] * s);
        let (s, t) = (v0 / (left[1] + right[0]), v1 / (left[0] + right[1]));
        let (v0, v1, v2) = (right[0] * s, left[1] * s + right[1] * t, left[0] * t);
        let (s, t, u) = (v0 / (left[2] + right[0]), v1 / (left[1] + right[1]), v2 / (left[0] + right[2]));
        (*a, *b) = (right[0] * s, left[2] * s + right[1] * t);
        (*c, *d) = (left[1] * t + right[2] * u, left[0] * u);
    }
}
