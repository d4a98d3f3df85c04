//! Where `f64` is wrong: the errors of the paper's formula over x and α, as SVG on standard output.

use knotproof::report::heat_map;
use knotproof::study::Method;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let knots = [0.0, 0.0, 0.0, 1.0, 2.0, 3.0, 3.0, 3.0];
    println!("{}", heat_map(Method::Paper, &knots, 2)?);
    Ok(())
}
