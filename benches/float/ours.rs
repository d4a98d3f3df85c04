//! One side of a comparison: prints how many million points a second, degree 3, four values each.
//!
//! ours COUNT: x from a file of f64 (native order) if given, or evenly mixed.

use std::hint::black_box;
use std::time::Instant;

use knotproof::float::{FloatBasis, Precision};
use knotproof::spline::Side;

fn rate(name: &str, points: usize, mut run: impl FnMut()) -> f64 {
    let mut best = f64::INFINITY;
    for _ in 0..9 {
        let start = Instant::now();
        run();
        best = best.min(start.elapsed().as_secs_f64());
    }
    let rate = points as f64 / best / 1e6;
    println!("{name:<44} {rate:8.1}");
    rate
}

fn main() {
    let knots = vec![0.0, 0.0, 0.0, 0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 5.0, 5.0, 5.0];
    let basis = FloatBasis::new(knots, 3, -0.5).unwrap();
    let count = 100_000;
    let golden = 0.618_033_988_749_894_9_f64;
    let scattered: Vec<f64> = (0..count).map(|i| (i as f64 * golden).fract() * 5.0).collect();
    let one: Vec<f64> = scattered.iter().map(|x| 2.0 + x / 5.0).collect();
    let span = basis.span_at(2.5, Side::Right).unwrap().unwrap();
    let mut spans = vec![None; count];
    let mut values = vec![0.0; 4 * count];
    for (name, precision) in [("accurate", Precision::Accurate), ("fast", Precision::Fast)] {
        rate(&format!("{name}, scattered"), count, || {
            basis.values_at(black_box(&scattered), precision, &mut spans, &mut values).unwrap();
        });
        rate(&format!("{name}, one span"), count, || {
            basis.values_on(span, black_box(&one), precision, &mut values).unwrap();
        });
        let few = &one[..1024];
        rate(&format!("{name}, one span, 1024 points"), 1024 * 100, || {
            for _ in 0..100 {
                basis.values_on(span, black_box(few), precision, &mut values[..4096]).unwrap();
            }
        });
    }
    rate("accurate, one by one", count, || {
        let mut four = [0.0; 4];
        for x in black_box(&scattered) {
            basis.values(*x, Side::Right, &mut four).unwrap();
            black_box(&four);
        }
    });
    rate("plain triangle with divisions, one span", 1024 * 100, || {
        for _ in 0..100 {
            plain_triangle(
                1.0 / 3.0,
                &[0.0, 1.0, 2.0, 3.0, 4.0, 5.0],
                black_box(&one[..1024]),
                &mut values[..4096],
            );
        }
    });
}

/// What one would write: The NURBS Book's triangle with r, for points of one span, left to the compiler.
#[inline(never)]
fn plain_triangle(r: f64, knots: &[f64; 6], points: &[f64], values: &mut [f64]) {
    let n = points.len();
    let (a, rest) = values.split_at_mut(n);
    let (b, rest) = rest.split_at_mut(n);
    let (c, d) = rest.split_at_mut(n);
    let points = points.iter().zip(a).zip(b).zip(c).zip(d);
    for ((((x, a), b), c), d) in points {
        let left = [r * (x - knots[2]), r * (x - knots[1]), r * (x - knots[0])];
        let right = [knots[3] - x, knots[4] - x, knots[5] - x];
        let t = 1.0 / (left[0] + right[0]);
        let (v0, v1) = (right[0] * t, left[0] * t);
        let (s, t) = (v0 / (left[1] + right[0]), v1 / (left[0] + right[1]));
        let (v0, v1, v2) = (right[0] * s, left[1] * s + right[1] * t, left[0] * t);
        let (s, t, u) = (v0 / (left[2] + right[0]), v1 / (left[1] + right[1]), v2 / (left[0] + right[2]));
        (*a, *b) = (right[0] * s, left[2] * s + right[1] * t);
        (*c, *d) = (left[1] * t + right[2] * u, left[0] * u);
    }
}
