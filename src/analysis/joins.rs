//! How the pieces of a curve meet: continuity of place, direction and curvature at knots, exactly.

use num_rational::BigRational;
use num_traits::{Signed, Zero};

use crate::scalar::integer;
use crate::spline::{Curve, CurveEvaluator, HasWeights, Point, Side, Tangent};

use super::angle::Angle;
use super::surd::Surd;

/// One side of a knot: the limits there.
#[derive(Debug, Clone, PartialEq)]
pub struct Branch {
    /// The point.
    pub point: Point,
    /// c′.
    pub velocity: Point,
    /// The tangent; `None` where the curve stands still on that side: it is one point on the whole span.
    pub tangent: Option<Tangent>,
}

/// Two branches of a curve that meet at a knot.
///
/// The curve is *G⁰* there if the points are equal, *G¹* if the directions are, too, and *G²* if the vectors of curvature are, too.
/// This is about the curve as it is seen, not about the speed at which it is run through: where c′ = 0, the direction is that of
/// the first derivative that is not 0.
///
/// ```
/// use knotproof::analysis::{joins, settled};
/// use knotproof::scalar::{integer, rational};
/// use knotproof::spline::{Basis, Curve, Index, KnotVector};
///
/// let knots = KnotVector::new([0, 0, 0, 1, 2, 2, 2].map(integer).to_vec())?;
/// let points = [[0, 0], [1, 2], [2, 2], [3, 0]].map(|point| point.map(integer).to_vec()).to_vec();
/// let classical = Curve::new(Basis::new(knots, 2, Index::infinity())?, points)?;
/// let join = &joins(&classical)[0];
/// assert_eq!((join.g0(), join.g1(), join.g2()), (true, Some(true), Some(true)));
///
/// let rational_one = classical.with("5".parse::<Index>()?);
/// let join = &joins(&rational_one)[0];
/// assert_eq!((join.g0(), join.g1()), (true, Some(true)));
/// assert_eq!(join.speed_ratio_square(), Some(rational(7225, 5776)));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Join {
    /// The knot.
    pub knot: BigRational,
    /// How often it occurs.
    pub multiplicity: usize,
    /// Do the two ends of the curve meet here? Then `before` is the end, at t_{n+1}, and `after` the beginning, at t_k.
    pub closing: bool,
    /// The side that is run through first.
    pub before: Branch,
    /// The other one.
    pub after: Branch,
}

/// The joins at all knots inside (t_0, t_m), from left to right; at last, if the curve on [t_k, t_{n+1}] is closed, the one of its
/// ends.
#[must_use]
pub fn joins<W: HasWeights>(curve: &Curve<W>) -> Vec<Join> {
    let (basis, mut evaluator) = (curve.basis(), CurveEvaluator::new(curve));
    let knots = basis.knots();
    let mut joins: Vec<_> = knots
        .inner_stop_knots()
        .map(|(knot, multiplicity)| Join {
            knot: knot.clone(),
            multiplicity,
            closing: false,
            before: branch(&mut evaluator, knot, Side::Left),
            after: branch(&mut evaluator, knot, Side::Right),
        })
        .collect();
    let (start, end) = (knots.t(basis.degree()), knots.t(basis.n() + 1));
    if start < end {
        let closing = Join {
            knot: end.clone(),
            multiplicity: knots.multiplicity(end),
            closing: true,
            before: branch(&mut evaluator, end, Side::Left),
            after: branch(&mut evaluator, start, Side::Right),
        };
        joins.extend(closing.g0().then_some(closing));
    }
    joins
}

fn branch<W: HasWeights>(evaluator: &mut CurveEvaluator<'_, W>, knot: &BigRational, side: Side) -> Branch {
    let mut derivatives = evaluator.derivatives(knot, side, 1).into_iter();
    let (point, velocity) = (derivatives.next().unwrap_or_default(), derivatives.next().unwrap_or_default());
    Branch { point, velocity, tangent: evaluator.tangent(knot, side) }
}

impl Branch {
    /// κ|κ|, the square of the curvature: with its sign in the plane, where it is positive to the left of the direction; in other
    /// dimensions |κ|². `None` without a tangent, and where the curvature is infinite.
    #[must_use]
    pub fn curvature_square(&self) -> Option<BigRational> {
        let Tangent { direction, curvature, .. } = self.tangent.as_ref()?;
        let curvature = curvature.as_ref()?;
        let square = dot(curvature, curvature);
        let right = matches!((&direction[..], &curvature[..]), ([a, b], [c, d]) if a * d < b * c);
        Some(if right { -square } else { square })
    }
}

impl Join {
    /// Are the points equal?
    #[must_use]
    pub fn g0(&self) -> bool {
        self.before.point == self.after.point
    }

    /// The angle between the directions; `None` where one side has none.
    #[must_use]
    pub fn angle(&self) -> Option<Angle> {
        let (a, b) = self.directions()?;
        let along = dot(a, b);
        Some(Angle::new(&along * &along / (dot(a, a) * dot(b, b)), along.is_negative()))
    }

    /// Are the points equal and the directions? `None` where the points are and one side has no direction.
    #[must_use]
    pub fn g1(&self) -> Option<bool> {
        if !self.g0() {
            return Some(false);
        }
        self.angle().map(|angle| angle.is_zero())
    }

    /// Are the points equal, the directions and the vectors of curvature? `None` where all else is and both curvatures are
    /// infinite, and where [`g1`](Self::g1) is.
    #[must_use]
    pub fn g2(&self) -> Option<bool> {
        if !self.g1()? {
            return Some(false);
        }
        let curvature =
            |branch: &Branch| branch.tangent.as_ref().and_then(|tangent| tangent.curvature.clone());
        match (curvature(&self.before), curvature(&self.after)) {
            (None, None) => None,
            (before, after) => Some(before == after),
        }
    }

    /// |c′(t+)|²/|c′(t−)|²; `None` where one of them is 0.
    #[must_use]
    pub fn speed_ratio_square(&self) -> Option<BigRational> {
        let [before, after] =
            [&self.before, &self.after].map(|branch| dot(&branch.velocity, &branch.velocity));
        (!before.is_zero() && !after.is_zero()).then(|| after / before)
    }

    /// κ(t+) − κ(t−), by [`Branch::curvature_square`]; `None` where one of them is.
    #[must_use]
    pub fn curvature_jump(&self) -> Option<Surd> {
        Some(Surd::difference(&self.after.curvature_square()?, &self.before.curvature_square()?))
    }

    fn directions(&self) -> Option<(&Point, &Point)> {
        Some((&self.before.tangent.as_ref()?.direction, &self.after.tangent.as_ref()?.direction))
    }
}

/// a·b.
fn dot(a: &[BigRational], b: &[BigRational]) -> BigRational {
    a.iter().zip(b).fold(integer(0), |sum, (a, b)| sum + a * b)
}
