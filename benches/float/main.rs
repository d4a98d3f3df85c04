//! The paths in floats, degree 3: scattered points, points of one span, and curves. `compare.sh` times them beside SciPy.

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use knotproof::float::{FloatBasis, FloatCurve, FloatError, Precision};
use knotproof::spline::Side;

const POINTS: u16 = 1024;

fn degree_three(criterion: &mut Criterion) -> Result<(), FloatError> {
    let knots = vec![0.0, 0.0, 0.0, 0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 5.0, 5.0, 5.0];
    // r = 1/3.
    let basis = FloatBasis::new(knots, 3, -0.5)?;
    let curve = FloatCurve::new(basis.clone(), 1, vec![1.0, -2.0, 3.0, -4.0, 5.0, -6.0, 7.0, -8.0])?;
    let count = usize::from(POINTS);
    let step = f64::from(POINTS);
    // 389 and 1024 have no common divisor, so the points are those of a grid, in no order.
    let scattered: Vec<f64> =
        (0..POINTS).map(|n| 5.0 * f64::from(n.wrapping_mul(389) % POINTS) / step).collect();
    let of_one_span: Vec<f64> = (0..POINTS).map(|n| 2.0 + f64::from(n) / step).collect();
    let Some(span) = basis.span_at(2.5, Side::Right)? else { return Ok(()) };
    let (mut spans, mut values) = (vec![None; count], vec![0.0; 4 * count]);

    let mut group = criterion.benchmark_group("D, values in floats");
    group.throughput(Throughput::Elements(u64::from(POINTS)));
    for (name, precision) in [("accurate", Precision::Accurate), ("fast", Precision::Fast)] {
        group.bench_function(BenchmarkId::new(name, "scattered"), |bencher| {
            bencher.iter(|| basis.values_at(&scattered, precision, &mut spans, &mut values));
        });
        group.bench_function(BenchmarkId::new(name, "one span"), |bencher| {
            bencher.iter(|| basis.values_on(span, &of_one_span, precision, &mut values));
        });
        group.bench_function(BenchmarkId::new(name, "curve"), |bencher| {
            bencher.iter(|| curve.points_at(&scattered, precision, &mut values[..count]));
        });
    }
    group.finish();
    Ok(())
}

fn floats(criterion: &mut Criterion) {
    if let Err(error) = degree_three(criterion) {
        eprintln!("the case of benches/float/main.rs is wrong: {error}");
        std::process::exit(1);
    }
}

criterion_group!(benches, floats);
criterion_main!(benches);
