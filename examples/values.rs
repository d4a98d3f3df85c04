//! Values and derivatives of all functions at points: in `f64`, and exactly.

use knotproof::float::FloatBasis;
use knotproof::scalar::{exact_value, integer, rational, ulp};
use knotproof::spline::{Basis, Evaluator, Index, KnotVector, Side};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let knots = KnotVector::new([0, 0, 0, 1, 2, 3, 3, 3].map(integer).to_vec())?;
    let basis = Basis::new(knots, 2, "-1".parse::<Index>()?)?;
    let float = FloatBasis::<f64>::nearest(&basis)?;
    // Both prepare once what all points share.
    let mut exact = Evaluator::new(&basis);
    let (mut values, mut derivatives) = ([0.0; 3], [0.0; 6]);
    for (x, nearest) in [(rational(1, 4), 0.25), (rational(3, 2), 1.5), (rational(11, 4), 2.75)] {
        float.values(nearest, Side::Right, &mut values)?;
        float.derivatives(nearest, Side::Right, 1, &mut derivatives)?;
        let Some(jets) = exact.jets(&x, Side::Right, 1) else { continue };
        println!("x = {x}");
        for (c, (i, jet)) in jets.iter().enumerate() {
            let [value, slope] = [&jet.derivatives()[0], &jet.derivatives()[1]];
            println!("  G_{i} = {value}, {}; G_{i}' = {slope}, {}", values[c], derivatives[3 + c]);
            let error = exact_value(values[c]).ok_or("not finite")? - value;
            if error > ulp(value) || -error > ulp(value) {
                return Err(format!("G_{i}({x}) is further off than a unit in the last place").into());
            }
        }
    }
    Ok(())
}
