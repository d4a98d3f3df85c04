//! How many functions a second the number of local maxima is decided for.

mod cases;

use criterion::{BatchSize, Criterion, Throughput, criterion_group, criterion_main};
use knotproof::analysis::Monotonicity;

const CASES: usize = 200;

fn unimodality(criterion: &mut Criterion) {
    for degree in 3..=5 {
        let mut group = criterion.benchmark_group(format!("unimodality, degree {degree}"));
        group.throughput(Throughput::Elements(CASES as u64));
        group.bench_function("local maxima", |bencher| {
            bencher.iter_batched(
                || cases::cases(degree, CASES),
                |cases| {
                    let functions = cases.iter().filter_map(|case| cases::function(case).ok());
                    functions.map(|knots| Monotonicity::of(&knots).local_maxima()).collect::<Vec<_>>()
                },
                BatchSize::SmallInput,
            );
        });
        group.finish();
    }
}

criterion_group!(benches, unimodality);
criterion_main!(benches);
