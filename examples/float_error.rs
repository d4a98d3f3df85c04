//! How wrong `f64` is, by the way in which it is computed: against exact arithmetic on the same floats.

use knotproof::float::FloatBasis;
use knotproof::study::{Effort, Method, MethodRecord, Population, study};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    // One knot close to another, and an α close to 1.
    let knots = vec![0.0, 0.0, 0.0, 0.0, 1e-6, 1.0, 3.0, 3.0, 3.0, 3.0];
    let basis = FloatBasis::new(knots, 3, 1.000_001)?;
    let effort = Effort { seed: 0, count: 200, steps: 200 };
    println!("{:>9} {:>12} {:>12}  proved to be at most", "", "median, ULP", "worst, ULP");
    for figures in study(&Population::Bases(vec![basis]), &Method::ALL, effort) {
        let record = MethodRecord::from(&figures);
        let worst = record.max_ulp.as_deref().unwrap_or("none");
        println!("{:>9} {:>12} {worst:>12}  {}", record.name, record.median_ulp, record.proved());
        if !figures.keeps_bound() {
            return Err(format!("{} is worse than what is proved of it", record.name).into());
        }
    }
    Ok(())
}
