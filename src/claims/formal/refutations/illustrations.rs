//! Refutations of section 5: the paper's examples.

use crate::claims::formal::example::{Example, of_degree};
use crate::claims::formal::illustrated_curves::squared;
use crate::claims::formal::place::Place;
use crate::claims::formal::symmetric_curves;
use crate::scalar::{BigRational, integer, rational};
use crate::spline::{Index, Point, Side};

use super::Refuted;
use super::found::{Found, differ};

/// The coordinates of the curve of the witness at its x.
fn coordinates(found: &Found<'_>) -> Option<[String; 2]> {
    let (x, instance) = (found.number("x")?, of_degree(&[found.text("instance")?], &[found.k()]).pop()?);
    let on = Example::new(&instance);
    let coordinate = |c| found.at(&x, Side::Right, |place| on.coordinate(c, place));
    Some([coordinate(0)?, coordinate(1)?])
}

pub(super) fn refutation(claim: &str, found: &Found<'_>) -> Refuted {
    let k = found.k();
    Some(match claim {
        "Ill5.1.fig7" => {
            let value = found.value(&found.number("x")?, Side::Right, found.natural("i")?)?;
            let other: Index = found.witness.claimed.rsplit_once("α = ")?.1.parse().ok()?;
            let other = format!("(at ((r {})) {value})", other.ratio());
            (
                "The function has another value at x for the other index.",
                found.section(&differ(&value, &other)),
            )
        }
        "Ill5.6.bezier.function" => {
            let other: Index = found.text("other α")?.parse().ok()?;
            let [x, y] = coordinates(found)?;
            let difference = |c: String| format!("(- {c} (at ((r {})) {c}))", other.ratio());
            (
                "At x the curves for the two indices are at different points: the sum of the squares of the differences of the coordinates is positive.",
                found.section(&format!("(> {} 0)", squared([difference(x), difference(y)]))),
            )
        }
        "Ill5.7.shift" => {
            let points = symmetric_curves::points(found.text("instance")?, k)?;
            let (i, [x, y]) = (found.natural("i")?, coordinates(found)?);
            let (first, second) = (points.get(i)?, points.get(i + 1)?);
            let end = if *found.basis.index().ratio() < integer(1) { first } else { second };
            let classical = |c: &str| format!("(at ((r 1)) {c})");
            let from = |point: &Point, x: &str, y: &str| {
                squared([format!("(- {x} {})", point[0]), format!("(- {y} {})", point[1])])
            };
            let along = [&second[0] - &first[0], &second[1] - &first[1]];
            let length: BigRational = along.iter().map(|a| a * a).sum();
            // The scalar product with the segment is between 2/5 and 3/5 of its square.
            let product = format!(
                "(+ (* {} (- {} {})) (* {} (- {} {})))",
                along[0],
                classical(&x),
                first[0],
                along[1],
                classical(&y),
                first[1]
            );
            let (low, high) = (&length * rational(2, 5), &length * rational(3, 5));
            let cross = format!(
                "(- (* {} (- {} {})) (* {} (- {} {})))",
                along[0],
                classical(&y),
                first[1],
                along[1],
                classical(&x),
                first[0]
            );
            let near = format!("(< (^ {cross} 2) {})", length / integer(16));
            (
                "For α = ∞ the curve at x is nearest to a point in the middle fifth of the segment [d_i, d_{i+1}], at a distance less than 1/4; for the index given it is farther from the end towards which it should move than for α = ∞.",
                found.section(&format!(
                    "(>= {product} {low}) (>= {high} {product}) {near} (> {} {})",
                    from(end, &x, &y),
                    from(end, &classical(&x), &classical(&y))
                )),
            )
        }
        "Ill5.7.local" => {
            let last = found.knots().spans().next_back()?.index();
            (
                "The moved control point is d_4: its factor is positive on the whole last span, so nothing unmoved follows.",
                found.section(&format!("(> {} 0)", Place::inside(last).value("G", 4, k))),
            )
        }
        "Ill5.8.symmetry" => {
            let points = symmetric_curves::points(found.text("instance")?, k)?;
            let goals: String =
                points.first()?.iter().zip(points.last()?).map(|(a, b)| format!("(= {a} {b})")).collect();
            (
                "The coordinates of the first and of the last control point are the same: they have no perpendicular bisector.",
                format!("(section (goals {goals}))"),
            )
        }
        "Ill5.8.double" => {
            let goals = symmetric_curves::off_double_point(found.text("instance")?, k)?;
            (
                "The squared distance of the curve from its double control point is positive everywhere.",
                found.section(&goals),
            )
        }
        _ => return None,
    })
}
