//! The largest rounding errors of one basis, and where they occur.

use num_rational::BigRational;
use num_traits::{Signed, Zero};
use serde::{Serialize, Serializer};

use crate::scalar::{RationalAlgebra, decimal, exact_value, integer, ulp};
use crate::spline::{Basis, Side};

/// How many points are sampled inside every span, between its two ends.
pub const INTERIOR_POINTS: usize = 64;

/// The digits of an error in serialised form.
const DIGITS: usize = 6;

/// A largest error and the first place where it occurs.
///
/// Serialised, the error is a decimal of six significant digits (exactly it is a fraction of hundreds of
/// digits), and x is exact.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Worst {
    /// |float − exact|, as it is or in units in the last place.
    #[serde(serialize_with = "as_decimal")]
    pub error: BigRational,
    /// x, before it was rounded.
    #[serde(serialize_with = "as_text")]
    pub x: BigRational,
    /// i of G_i^k.
    pub index: usize,
    /// The side of the limit at x: it differs from the value at a knot only.
    #[serde(serialize_with = "as_text")]
    pub side: Side,
}

/// What [`discrepancy`] finds on one basis.
///
/// Every maximum is over all functions that live on a span, at all its points; where nothing is wrong at
/// all, it is 0 at the first point.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Discrepancy {
    /// The largest |float − exact|.
    pub max_absolute: Worst,
    /// The largest |float − exact| / `ulp(exact)`, a fraction, over the values with exact ≠ 0. For an exact 0
    /// there is no such unit, and an error counts as an absolute one only.
    pub max_ulp: Worst,
    /// The number of one-sided points x.
    pub points: usize,
    /// The number of values that came out infinite or NaN (knots beyond the range of `f64`): they have no
    /// error, and count nowhere else.
    pub not_finite: usize,
}

/// The errors of the triangle in `f64`, measured against the exact values.
///
/// On every non-empty span [t_j, t_{j+1}) it takes both ends, as limits in that span, and
/// [`INTERIOR_POINTS`] points evenly spaced between them; all are exact rationals. The float path is
/// [`Basis::active`] over `f64`, the same lines as the exact one, and gets x, the knots and r rounded to nearest:
/// so the figure is that of a program which is handed the instance in `f64`, the rounding of its input
/// included. The error is measured against the exact value at the exact x, without rounding.
///
/// The points depend on nothing but the basis, and neither does the result.
///
/// ```
/// use knotproof::float::discrepancy;
/// use knotproof::scalar::{decimal, integer};
/// use knotproof::spline::{Basis, Index, KnotVector};
///
/// // In degree 0 nothing is computed, and nothing rounds.
/// let knots = KnotVector::new([0, 1, 2].map(integer).to_vec())?;
/// let constant = discrepancy(&Basis::new(knots.clone(), 0, Index::infinity())?);
/// assert_eq!(decimal(&constant.max_absolute.error, 3), "0");
///
/// let linear = discrepancy(&Basis::new(knots, 1, "-1".parse::<Index>()?)?);
/// assert!(linear.max_absolute.error > integer(0));
/// assert_eq!(linear.points, 2 * 66);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[must_use]
pub fn discrepancy(basis: &Basis) -> Discrepancy {
    let nowhere = || Worst {
        error: BigRational::zero(),
        x: basis.knots().first().clone(),
        index: 0,
        side: Side::Right,
    };
    let (max_absolute, max_ulp) = (nowhere(), nowhere());
    let mut found = Discrepancy { max_absolute, max_ulp, points: 0, not_finite: 0 };
    for span in basis.knots().spans() {
        let (start, end) = basis.knots().ends(span);
        let step = (end - start) / integer(INTERIOR_POINTS + 1);
        for s in 0..=INTERIOR_POINTS + 1 {
            let x = start + &step * integer(s);
            let side = if s <= INTERIOR_POINTS { Side::Right } else { Side::Left };
            let exact = basis.active(span, &x);
            let float = basis.active(span, &0.0_f64.embed(&x));
            found.points += 1;
            for ((index, exact), float) in exact.iter().zip(float.values()) {
                found.record(exact, *float, (&x, index, side));
            }
        }
    }
    found
}

impl Discrepancy {
    fn record(&mut self, exact: &BigRational, float: f64, place: (&BigRational, usize, Side)) {
        let Some(float) = exact_value(float) else {
            self.not_finite += 1;
            return;
        };
        let error = (float - exact).abs();
        if error.is_zero() {
            return;
        }
        if !exact.is_zero() {
            self.max_ulp.raise(&error / ulp(exact), place);
        }
        self.max_absolute.raise(error, place);
    }
}

impl Worst {
    fn raise(&mut self, error: BigRational, (x, index, side): (&BigRational, usize, Side)) {
        if error > self.error {
            *self = Self { error, x: x.clone(), index, side };
        }
    }
}

fn as_decimal<S: Serializer>(value: &BigRational, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_str(&decimal(value, DIGITS))
}

fn as_text<T: std::fmt::Display, S: Serializer>(value: &T, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_str(value)
}
