//! How far the curves of the paper are from smooth at their knots: the turn of the tangent and the jump of the speed.

use schemars::JsonSchema;
use serde::{Serialize, Serializer};

use crate::analysis::{Join, Surd, joins, settled};
use crate::language::Paper;
use crate::meaning::examples_of;
use crate::scalar::BigRational;
use crate::spline::{Index, Point};

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
        for (weights, curve) in instance.curves() {
            let Some(alpha) = weights.index() else { continue };
            for join in joins(&curve).into_iter().filter(|join| !join.closing) {
                let (left, right) = (join.before.velocity.clone(), join.after.velocity.clone());
                corners.push(Corner {
                    instance: instance.name.to_string(),
                    figure: instance.figure.clone(),
                    degree: instance.degree,
                    alpha: alpha.clone(),
                    turn: Turn::at(&join),
                    knot: join.knot,
                    multiplicity: join.multiplicity,
                    determinant: determinant(&left, &right),
                    left,
                    right,
                });
            }
        }
    }
    corners
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
    /// `None` if one of the derivatives is 0.
    fn at(join: &Join) -> Option<Self> {
        let (speed_ratio_squared, mut angle) = (join.speed_ratio_square()?, join.angle()?);
        Some(Self {
            cos2: angle.cosine_square().clone(),
            turns_back: angle.is_obtuse(),
            angle_degrees: settled(&mut angle, DIGITS),
            speed_ratio: settled(&mut Surd::root(&speed_ratio_squared), DIGITS),
            speed_ratio_squared,
        })
    }
}
