//! A curve for a program that knows NURBS only: as rational Bézier curves, one a span, exactly.

use knotproof::analysis::RationalBezier;
use knotproof::scalar::{BigRational, integer};
use knotproof::spline::{Basis, Curve, Index, KnotVector};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let knots = KnotVector::new([0, 0, 0, 1, 3, 3, 3].map(integer).to_vec())?;
    let basis = Basis::new(knots, 2, "-1".parse::<Index>()?)?;
    let points = [[0, 0], [1, 2], [3, 2], [4, 0]].map(|point| point.map(integer).to_vec());
    let curve = Curve::new(basis, points.to_vec())?;
    for piece in RationalBezier::pieces(&curve) {
        let piece = piece?;
        let (from, to) = piece.ends();
        println!("[{from}, {to}], degree {}:", piece.degree());
        for (weight, point) in piece.weights().iter().zip(piece.points()) {
            let coordinates: Vec<_> = point.iter().map(BigRational::to_string).collect();
            println!("  weight {weight}, point ({})", coordinates.join(", "));
        }
        // For every x of the span, not at samples.
        if let Some(x) = piece.disagreement(&curve) {
            return Err(format!("it is another curve at x = {x}").into());
        }
    }
    Ok(())
}
