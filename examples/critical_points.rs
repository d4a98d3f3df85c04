//! Where the functions of a basis have their maxima and minima: counted exactly, and to as many digits as are asked for.

use knotproof::analysis::{Algebraic, ExtremumKind, Pieces, Shape, settled};
use knotproof::scalar::integer;
use knotproof::spline::{Basis, Index, KnotVector};

const DIGITS: usize = 20;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    // With these knots and this α one function has two maxima, where the paper conjectures one.
    let knots = KnotVector::new([0, 0, 0, 0, 1, 2, 4, 4].map(integer).to_vec())?;
    let basis = Basis::new(knots, 3, "5/2".parse::<Index>()?)?;
    let pieces = Pieces::of(&basis);
    for i in 0..=basis.n() {
        let shape = Shape::of(&pieces, i);
        println!("G_{i}^{}: local maxima: {}", basis.degree(), shape.local_maxima().count());
        for extremum in shape.extrema() {
            let kind = match extremum.kind {
                ExtremumKind::Maximum => "maximum",
                ExtremumKind::Minimum => "minimum",
            };
            let [x, value] = [extremum.x(), extremum.height()].map(written);
            println!("  {kind} at x = {x}: {value}");
        }
    }
    Ok(())
}

/// A rational number as it is, and of an irrational one so many digits, each of them right.
fn written(mut number: Algebraic) -> String {
    number.exact().map(ToString::to_string).unwrap_or_else(|| settled(&mut number, DIGITS))
}
