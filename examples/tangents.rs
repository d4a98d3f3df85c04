//! A curve with its tangents, as SVG on standard output. All numbers are exact until they are written down.

use knotproof::scalar::{decimal, integer, rational};
use knotproof::spline::{Basis, Curve, KnotVector, Side};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let knots = KnotVector::new([0, 0, 0, 0, 1, 2, 2, 2, 2].map(integer).to_vec())?;
    let points =
        [[10, 90], [60, 10], [110, 10], [150, 90], [190, 30]].map(|point| point.map(integer).to_vec());
    let curve = Curve::new(Basis::new(knots, 3, "-2".parse()?)?, points.to_vec())?;
    println!("<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 200 100' stroke='black'>");
    for step in 0..=64 {
        let jets = curve.jets(&rational(step, 32), Side::Right, 1);
        // As far as the next point the tangent is next to the curve; one in eight goes on.
        let length = rational(if step % 8 == 0 { 8 } else { 1 }, 32);
        let [x, y] = [0, 1].map(|c| decimal(&jets[c].derivatives()[0], 6));
        let [dx, dy] = [0, 1].map(|c| decimal(&(&jets[c].derivatives()[1] * &length), 6));
        println!("<path d='M {x} {y} l {dx} {dy}'/>");
    }
    println!("</svg>");
    Ok(())
}
