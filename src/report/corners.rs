//! How far the curves of the paper are from smooth at their knots: the turn of the tangent and the jump of the speed.

use num_traits::{One, Signed, Zero};
use schemars::JsonSchema;
use serde::{Serialize, Serializer};

use crate::language::Paper;
use crate::meaning::examples_of;
use crate::scalar::{BigRational, decimal, integer, rational};
use crate::spline::{Basis, Curve, Index, Point, Side};

/// The two one-sided derivatives of a curve of the paper at a knot inside its interval.
///
/// Exact numbers are written as fractions, `"1672/225"`.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct Corner {
    /// The instance, such as `S1`.
    pub instance: String,
    /// Where the paper shows it.
    pub figure: String,
    /// k.
    pub degree: usize,
    /// α.
    #[serde(serialize_with = "text")]
    #[schemars(with = "String")]
    pub alpha: Index,
    /// The knot t.
    #[serde(serialize_with = "text")]
    #[schemars(with = "String")]
    pub knot: BigRational,
    /// How often it occurs: the classical curve has a continuous tangent there if that is less than k.
    pub multiplicity: usize,
    /// D⁻G_α(t).
    #[serde(serialize_with = "texts")]
    #[schemars(with = "Vec<String>")]
    pub left: Point,
    /// D⁺G_α(t).
    #[serde(serialize_with = "texts")]
    #[schemars(with = "Vec<String>")]
    pub right: Point,
    /// det(D⁻, D⁺): not 0 if there is a corner.
    #[serde(serialize_with = "text")]
    #[schemars(with = "String")]
    pub determinant: BigRational,
    /// The turn there; nothing where a one-sided derivative is 0: no direction and no ratio can be read off it.
    pub turn: Option<Turn>,
}

/// How the direction and the speed change at a knot.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct Turn {
    /// (D⁻·D⁺)²/(|D⁻|²·|D⁺|²), the squared cosine of the angle.
    #[serde(serialize_with = "text")]
    #[schemars(with = "String")]
    pub cos2: BigRational,
    /// D⁻·D⁺ < 0: the angle is more than a right one.
    pub turns_back: bool,
    /// The angle between the directions in degrees, from 0 to 180; every digit is settled.
    pub angle_degrees: String,
    /// |D⁺|²/|D⁻|².
    #[serde(serialize_with = "text")]
    #[schemars(with = "String")]
    pub speed_ratio_squared: BigRational,
    /// |D⁺|/|D⁻|; every digit is settled.
    pub speed_ratio: String,
}

fn text<S: Serializer>(value: &impl ToString, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_str(&value.to_string())
}

fn texts<S: Serializer>(values: &[BigRational], serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_seq(values.iter().map(ToString::to_string))
}

/// Every curve of the paper, for each α of its figures, at each knot inside its interval, in the order of the paper.
///
/// ```
/// use knotproof::language::paper;
/// use knotproof::report::corners;
///
/// let of = |corner: &knotproof::report::Corner| corner.turn.as_ref().map(|turn| turn.angle_degrees.clone());
/// let corners = corners(paper());
/// let first = corners.iter().find(|corner| corner.instance == "S1" && corner.alpha.to_string() == "-1");
/// assert_eq!(first.and_then(of).as_deref(), Some("0.0266630"));
/// ```
#[must_use]
pub fn corners(paper: &Paper) -> Vec<Corner> {
    let mut corners = Vec::new();
    for instance in examples_of(&paper.examples, &paper.about.family) {
        let Some(points) = &instance.points else { continue };
        for index in instance.indices() {
            let basis = Basis::new(instance.knots.clone(), instance.degree, index.clone());
            // A row that is no curve in the plane is complained of when it is read.
            let Some(curve) = basis.ok().and_then(|basis| Curve::new(basis, points.clone()).ok()) else {
                continue;
            };
            for (knot, multiplicity) in instance.knots.inner_stop_knots() {
                let derivative = |side| -> Point {
                    curve.jets(knot, side, 1).iter().map(|jet| jet.coefficients()[1].clone()).collect()
                };
                let (left, right) = (derivative(Side::Left), derivative(Side::Right));
                let determinant = determinant(&left, &right);
                corners.push(Corner {
                    instance: instance.name.to_string(),
                    figure: instance.figure.clone(),
                    degree: instance.degree,
                    alpha: index.clone(),
                    knot: knot.clone(),
                    multiplicity,
                    turn: Turn::between(&left, &right),
                    left,
                    right,
                    determinant,
                });
            }
        }
    }
    corners
}

fn dot(a: &[BigRational], b: &[BigRational]) -> BigRational {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// Of two vectors in the plane.
fn determinant(a: &[BigRational], b: &[BigRational]) -> BigRational {
    match (a, b) {
        ([a, c], [b, d]) => a * d - b * c,
        _ => unreachable!("the curves of the paper lie in the plane"),
    }
}

/// The digits that are shown.
const DIGITS: usize = 6;

impl Turn {
    /// From one vector to another; `None` if one of them is 0.
    fn between(left: &[BigRational], right: &[BigRational]) -> Option<Self> {
        let (before, after) = (dot(left, left), dot(right, right));
        if before.is_zero() || after.is_zero() {
            return None;
        }
        let (along, across) = (dot(left, right), determinant(left, right).abs());
        let speed_ratio_squared = &after / &before;
        Some(Self {
            cos2: &along * &along / (before * after),
            turns_back: along.is_negative(),
            angle_degrees: settled(|precision| angle(&along, &across, precision)),
            speed_ratio: settled(|precision| square_root(&speed_ratio_squared, precision)),
            speed_ratio_squared,
        })
    }
}

/// A number between two others.
type Bounds = (BigRational, BigRational);

/// Narrows the bounds until both ends are rounded to the same digits, as every number between them is then.
///
/// It ends, as no number is asked for that is irrational and halfway between two rounded ones.
fn settled(bounds: impl Fn(u32) -> Bounds) -> String {
    let mut precision = 30;
    loop {
        let (low, high) = bounds(precision);
        let digits = decimal(&low, DIGITS);
        if digits == decimal(&high, DIGITS) {
            return digits;
        }
        precision *= 2;
    }
}

/// √q for q > 0, to 10^(−precision): from the integer part of √(numerator·denominator·10^(2·precision)).
fn square_root(q: &BigRational, precision: u32) -> Bounds {
    let scale = num_bigint::BigInt::from(10).pow(precision);
    let square = q.numer() * q.denom() * &scale * &scale;
    let (root, below) = (square.sqrt(), q.denom() * scale);
    let exact = &root * &root == square;
    let low = BigRational::new(root, below.clone());
    let high = if exact { low.clone() } else { &low + BigRational::new(1.into(), below) };
    (low, high)
}

/// The angle of the vector (along, across), across ≥ 0, in degrees; exact for multiples of 45°.
fn angle(along: &BigRational, across: &BigRational, precision: u32) -> Bounds {
    let less_than = |degrees, (low, high): Bounds| (integer(degrees) - high, integer(degrees) - low);
    if along.is_negative() {
        return less_than(180, angle(&-along, across, precision));
    }
    if across > along {
        return less_than(90, angle(across, along, precision));
    }
    // The tangent is in [0, 1]; from 45° it is reduced once more, to at most 1/3.
    let tangent = across / along;
    if tangent > rational(1, 3) {
        let rest = (integer(1) - &tangent) / (integer(1) + tangent);
        return less_than(45, in_degrees(&rest, precision));
    }
    in_degrees(&tangent, precision)
}

/// arctan(t)·180/π for 0 ≤ t ≤ 1/2.
fn in_degrees(t: &BigRational, precision: u32) -> Bounds {
    if t.is_zero() {
        return (integer(0), integer(0));
    }
    let (low, high) = arctangent(t, precision);
    // Machin: π/4 = 4 arctan(1/5) − arctan(1/239).
    let [fifth, machin] = [5, 239].map(|n| arctangent(&rational(1, n), precision));
    let four = integer(4);
    let (least, most) = (&four * &fifth.0 - &machin.1, &four * &fifth.1 - &machin.0);
    let half_right = integer(45);
    (low * &half_right / most, high * half_right / least)
}

/// arctan(t) for 0 < t ≤ 1/2: its series alternates and its terms fall, so it lies between two sums that follow each
/// other; the last term is at most 10^(−precision)·t.
fn arctangent(t: &BigRational, precision: u32) -> Bounds {
    let square = t * t;
    let least = t / BigRational::from_integer(num_bigint::BigInt::from(10).pow(precision));
    let (mut power, mut odd, mut sum) = (t.clone(), BigRational::one(), BigRational::zero());
    loop {
        let below = &sum + &power / &odd - &power * &square / (&odd + integer(2));
        let above = sum + &power / &odd;
        if power < least {
            return (below, above);
        }
        sum = below;
        power *= &square * &square;
        odd += integer(4);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn degrees(along: i64, across: i64) -> String {
        settled(|precision| angle(&rational(along, 1), &rational(across, 1), precision))
    }

    #[test]
    fn angles_are_right_in_every_octant() {
        let found = [(1, 0), (2, 1), (1, 1), (1, 2), (0, 1), (-1, 2), (-1, 1), (-2, 1), (-1, 0), (1000, 1)];
        let expected = [
            "0",
            "26.5651",
            "45.0000",
            "63.4349",
            "90.0000",
            "116.565",
            "135.000",
            "153.435",
            "180.000",
            "0.0572958",
        ];
        assert_eq!(found.map(|(along, across)| degrees(along, across)), expected);
    }

    #[test]
    fn roots_are_exact_where_they_can_be() {
        let root = |q: &BigRational| settled(|precision| square_root(q, precision));
        assert_eq!(root(&rational(2, 1)), "1.41421");
        // Halfway between two rounded numbers: settled, because it is exact.
        let half = rational(1_000_005, 1_000_000);
        assert_eq!(square_root(&(&half * &half), 1).0, half);
        assert_eq!(root(&(&half * &half)), decimal(&half, DIGITS));
    }
}
