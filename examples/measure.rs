//! What a designer asks of a curve: how large and how long it is, where it has a given height, and the same with other points. All of it
//! exactly, or between bounds that are as close as asked for.

use knotproof::analysis::{
    Algebraic, Collocation, CurvePart, Graph, RationalBezier, integrals, length, refined, settled,
};
use knotproof::scalar::{BigRational, integer, rational};
use knotproof::spline::{Basis, Curve, Index, KnotVector};

const DIGITS: usize = 15;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let knots = KnotVector::new([0, 0, 0, 0, 1, 2, 2, 2, 2].map(integer).to_vec())?;
    let basis = Basis::new(knots, 3, "5".parse::<Index>()?)?;
    let points = [[0, 0], [1, 3], [3, 4], [5, 1], [6, 2]].map(|point| point.map(integer).to_vec());
    let curve = Curve::new(basis.clone(), points.to_vec())?;
    let pieces: Vec<_> =
        RationalBezier::pieces_on(&curve, &CurvePart::of(&curve, None, None)?).collect::<Result<_, _>>()?;

    let height = Graph::of(&pieces, &[integer(0), integer(1)]);
    let range = height.range();
    let (lowest, highest) = (written(range.lowest.value), written(range.highest.value));
    println!(
        "Heights from {lowest} to {highest}, the greatest at x = {}.",
        written(range.highest.places[0].0.x())
    );
    for solution in height.solutions(&integer(2)) {
        println!("Height 2 at x = {}.", written(solution.place.x()));
    }

    let width = rational(1, 1 << 50);
    println!("Length {}.", between(length(&pieces, &width)));
    let parts: Vec<_> = integrals(&pieces, &width).into_iter().map(between).collect();
    println!("Integrals of the coordinates {}.", parts.join(", "));

    // The curve through the same points in order: it takes five places that meet the condition of Schoenberg and Whitney.
    let places = [rational(0, 1), rational(1, 2), rational(1, 1), rational(3, 2), rational(2, 1)];
    let through = Collocation::new(&basis, places.to_vec())?.interpolate(&points)?;
    for (i, point) in through.points().iter().enumerate() {
        println!("Control point {i} of the curve through the points: ({}, {}).", point[0], point[1]);
    }

    // One more knot: for α = ∞ always, for α = 5 only where the space has the curve.
    for index in [Index::infinity(), "5".parse()?] {
        match refined(&curve.with(index.clone()), &[rational(1, 2)]) {
            Ok(finer) => println!("α = {index}: {} control points on the new knots.", finer.points().len()),
            Err(reason) => println!("α = {index}: {reason}."),
        }
    }
    Ok(())
}

/// A rational number as it is, and of another one so many digits, each of them right.
fn written(mut number: Algebraic) -> String {
    number.exact().map(ToString::to_string).unwrap_or_else(|| settled(&mut number, DIGITS))
}

fn between((lo, hi): (BigRational, BigRational)) -> String {
    settled(&mut Algebraic::between(lo, hi), DIGITS)
}
