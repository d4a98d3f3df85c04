//! The kernels, one group for each job that `benches/peers.sh` compares with other systems, one for curves, one for growth, and one for
//! the ways to a point, whose costs the head of the library's documentation tells.

#[path = "peers/jobs.rs"]
mod jobs;

use std::error::Error;
use std::fmt::Display;
use std::hint::black_box;

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use jobs::CaseError;
use knotproof::float::FloatBasis;
use knotproof::scalar::{RationalAlgebra, integer};
use knotproof::spline::{Curve, CurveEvaluator, Evaluator, Sampler, Side, by_definition};

const POINTS: usize = 25;

/// A: exact values at points.
fn values(criterion: &mut Criterion) -> Result<(), CaseError> {
    let mut group = criterion.benchmark_group("A, values");
    group.throughput(Throughput::Elements(POINTS as u64));
    for degree in [3, 5, 10, 20] {
        let basis = jobs::basis(degree, jobs::inner(degree))?;
        let points = jobs::points(&basis, POINTS);
        let mut evaluator = Evaluator::new(&basis);
        group.bench_function(BenchmarkId::new("reduced", degree), |bencher| {
            bencher.iter(|| points.iter().map(|x| jobs::values(&mut evaluator, x)).collect::<Vec<_>>());
        });
        group.bench_function(BenchmarkId::new("unreduced", degree), |bencher| {
            let mut first = |x| Some(jobs::unreduced(&mut evaluator, x)?.first());
            bencher.iter(|| points.iter().filter_map(&mut first).sum::<usize>());
        });
    }
    group.finish();
    Ok(())
}

/// A curve in the plane on the knots of A, with small fractions for control points.
fn curve(degree: usize) -> Result<Curve, CaseError> {
    let basis = jobs::basis(degree, jobs::inner(degree))?;
    let point = |i: usize| vec![integer(i * 37 % 11) / integer(4), integer(i * 13 % 17) / integer(5)];
    let points = (0..=basis.n()).map(point).collect();
    Ok(Curve::new(basis, points)?)
}

/// Points of a curve in the plane, prepared once, with their functions alone for comparison, and one by one.
fn curves(criterion: &mut Criterion) -> Result<(), CaseError> {
    let mut group = criterion.benchmark_group("curves");
    group.throughput(Throughput::Elements(POINTS as u64));
    for degree in [2, 3, 5, 10] {
        let curve = curve(degree)?;
        let points = jobs::points(curve.basis(), POINTS);
        let mut functions = Evaluator::new(curve.basis());
        group.bench_function(BenchmarkId::new("functions", degree), |bencher| {
            bencher.iter(|| points.iter().map(|x| jobs::values(&mut functions, x)).collect::<Vec<_>>());
        });
        let mut evaluator = CurveEvaluator::new(&curve);
        group.bench_function(BenchmarkId::new("prepared", degree), |bencher| {
            bencher.iter(|| points.iter().map(|x| evaluator.point(x, Side::Right)).collect::<Vec<_>>());
        });
        group.bench_function(BenchmarkId::new("one by one", degree), |bencher| {
            bencher.iter(|| points.iter().map(|x| curve.point(x, Side::Right)).collect::<Vec<_>>());
        });
        group.bench_function(BenchmarkId::new("tangents", degree), |bencher| {
            bencher.iter(|| points.iter().map(|x| evaluator.tangent(x, Side::Right)).collect::<Vec<_>>());
        });
    }
    group.finish();
    Ok(())
}

/// B: the pieces of one span.
fn pieces(criterion: &mut Criterion) -> Result<(), CaseError> {
    let mut group = criterion.benchmark_group("B, pieces");
    for degree in (3..=10).chain([12, 14, 16]) {
        let basis = jobs::basis(degree, jobs::inner(degree))?;
        let Some(span) = jobs::middle(&basis) else { continue };
        group.bench_function(BenchmarkId::new("one span", degree), |bencher| {
            bencher.iter(|| jobs::pieces(&basis, span));
        });
    }
    group.finish();
    Ok(())
}

/// C: the critical points of one function. From polynomials only `benches/peers.sh` times it, on those of others.
fn critical_points(criterion: &mut Criterion) -> Result<(), CaseError> {
    let mut group = criterion.benchmark_group("C, critical points");
    for degree in 2..=8 {
        for (family, cases) in
            [("uniform", jobs::uniform(degree)), ("non-uniform", jobs::non_uniform(degree))]
        {
            let functions = cases.iter().map(jobs::local_knots).collect::<Result<Vec<_>, _>>()?;
            group.throughput(Throughput::Elements(functions.len() as u64));
            group.bench_function(BenchmarkId::new(family, degree), |bencher| {
                bencher.iter(|| functions.iter().map(jobs::turns).collect::<Vec<_>>());
            });
        }
    }
    group.finish();
    Ok(())
}

/// E: the pieces of one span for every r.
fn pieces_for_every_ratio(criterion: &mut Criterion) -> Result<(), CaseError> {
    let mut group = criterion.benchmark_group("E, pieces for every ratio");
    for degree in 3..=5 {
        let basis = jobs::basis(degree, jobs::inner(degree))?;
        let Some(span) = jobs::middle(&basis) else { continue };
        group.bench_function(BenchmarkId::new("one span", degree), |bencher| {
            bencher.iter(|| jobs::pieces_for_every_ratio(&basis, span));
        });
    }
    group.finish();
    Ok(())
}

/// Values at points as the degree grows, and as the number of knots does.
fn growth(criterion: &mut Criterion) -> Result<(), CaseError> {
    let mut group = criterion.benchmark_group("growth of A");
    group.throughput(Throughput::Elements(POINTS as u64)).sample_size(10);
    let by_degree = jobs::GROWTH_DEGREES.map(|degree| ("degree", degree, 100));
    let by_knots = jobs::GROWTH_KNOTS.map(|inner| ("inner knots", 3, inner));
    for (what, degree, inner) in by_degree.into_iter().chain(by_knots) {
        let basis = jobs::basis(degree, inner)?;
        let points = jobs::points(&basis, POINTS);
        let mut evaluator = Evaluator::new(&basis);
        let id =
            if what == "degree" { BenchmarkId::new(what, degree) } else { BenchmarkId::new(what, inner) };
        group.bench_function(id, |bencher| {
            bencher.iter(|| points.iter().map(|x| jobs::values(&mut evaluator, x)).collect::<Vec<_>>());
        });
    }
    group.finish();
    Ok(())
}

/// Values, derivatives and points of a plane curve in degree 3 on 28 knots, in each way that there is.
fn ways(criterion: &mut Criterion) -> Result<(), Box<dyn Error>> {
    let (basis, side) = (jobs::basis(3, 20)?, Side::Right);
    let control = (0..24).map(|i| [i, i * i % 7].map(integer).to_vec());
    let curve = Curve::new(basis.clone(), control.collect())?;
    let float = FloatBasis::<f64>::nearest(&basis)?;
    let points = jobs::points(&basis, POINTS);
    let near: Vec<f64> = points.iter().map(|x| 0.0.embed(x)).collect();
    let spans: Vec<_> = points.iter().filter_map(|x| basis.knots().span_at(x, side)).collect();
    let (mut evaluator, mut sampler, mut floats) = (Evaluator::new(&basis), Sampler::new(&basis), [0.0; 4]);
    let mut group = criterion.benchmark_group("ways to a point");
    group.throughput(Throughput::Elements(POINTS as u64));
    let mut time = |name: &str, way: &mut dyn FnMut(usize)| {
        group.bench_function(name, |bencher| bencher.iter(|| (0..POINTS).for_each(&mut *way)));
    };
    time("Evaluator::values", &mut |at| _ = black_box(evaluator.values(&points[at], side)));
    time("Sampler::values", &mut |at| _ = black_box(sampler.values(&points[at], side)));
    time("Basis::values", &mut |at| _ = black_box(basis.values(&points[at], side)));
    time("Basis::active", &mut |at| _ = black_box(basis.active(spans[at], &points[at])));
    time("by_definition", &mut |at| _ = black_box(by_definition(&basis, spans[at], &points[at])));
    time("Evaluator::jets", &mut |at| _ = black_box(evaluator.jets(&points[at], side, 1)));
    time("Basis::jets", &mut |at| _ = black_box(basis.jets(&points[at], side, 1)));
    time("Curve::combine, Evaluator::values", &mut |at| {
        _ = black_box(evaluator.values(&points[at], side).map(|functions| curve.combine(&functions)));
    });
    time("Curve::point", &mut |at| _ = black_box(curve.point(&points[at], side)));
    time("Curve::de_boor", &mut |at| _ = black_box(curve.de_boor(&points[at], side)));
    time("Curve::jets", &mut |at| _ = black_box(curve.jets(&points[at], side, 1)));
    time("FloatBasis::values", &mut |at| _ = black_box(float.values(near[at], side, &mut floats)));
    group.finish();
    Ok(())
}

fn kernels(criterion: &mut Criterion) {
    for group in [values, curves, pieces, critical_points, pieces_for_every_ratio, growth] {
        done(group(criterion));
    }
    done(ways(criterion));
}

fn done(group: Result<(), impl Display>) {
    if let Err(error) = group {
        eprintln!("a case of these benchmarks is wrong: {error}");
        std::process::exit(1);
    }
}

criterion_group!(benches, kernels);
criterion_main!(benches);
