//! One side of the comparison with PARI/GP, which `compare.sh` runs: writes cases, and decides them.

mod cases;

use std::error::Error;
use std::fs;
use std::time::Instant;

use knotproof::analysis::{LocalKnotsError, Monotonicity, Route};

/// How often the cases are decided while the clock runs.
const PASSES: u32 = 20;

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let (degree, count, folder) = match &arguments[..] {
        [degree, count, folder] => (degree.parse()?, count.parse()?, folder),
        _ => return Err("usage: throughput DEGREE COUNT FOLDER".into()),
    };
    let cases = cases::cases(degree, count);
    // A vector of PARI/GP on each line: gaps, p, q.
    let lines: String = cases.iter().map(|(gaps, (p, q))| format!("[{gaps:?}, {p}, {q}]\n")).collect();
    fs::write(format!("{folder}/cases"), lines)?;

    let decide = || -> Result<Vec<Monotonicity>, LocalKnotsError> {
        cases.iter().map(|case| Ok(Monotonicity::of(&cases::function(case)?))).collect()
    };
    let decided = decide()?;
    // As many passes as make this side run about as long as the other.
    let start = Instant::now();
    for _ in 0..PASSES {
        std::hint::black_box(decide()?);
    }
    let seconds = start.elapsed().as_secs_f64() / f64::from(PASSES);

    let counts = decided.iter().map(|function| function.local_maxima().ok_or("every case is continuous"));
    let counts: Result<Vec<usize>, _> = counts.collect();
    let lines: String = counts?.iter().map(|count| format!("{count}\n")).collect();
    fs::write(format!("{folder}/knotproof"), lines)?;
    let spans: Vec<Route> = decided.iter().flat_map(|f| f.spans()).map(|span| span.route).collect();
    let by_intervals = spans.iter().filter(|&&route| route != Route::Integers).count();
    println!("{seconds} {:.2}", 100.0 * by_intervals as f64 / spans.len() as f64);
    Ok(())
}
