//! Derivatives, tangents and curvature of curves in floats.

use super::basis::{Ratio, length};
use super::curve::FloatCurve;
use super::derivatives::{JetFrame, Jets, WeightJet, small};
use super::error::{FloatError, HIGHEST_DEGREE};
use super::machine::Kernel;
use super::pair::Pair;
use super::power::{exponent, shifted};
use super::real::Real;
use super::vectors::{Split, Vectors};
use crate::spline::{Side, Span};

/// The Taylor coefficients of orders 1 and 2, times 2^−e, and e.
type Scaled = ([Vec<Pair>; 2], i32);

impl<F: Real> FloatCurve<F> {
    /// The point of the curve at x and its derivatives up to an order of at most [`HIGHEST_DEGREE`]: row e of `rows` holds
    /// the coordinates of c^(e), as limits from the given side. `None`, and zeros, outside [t_0, t_m].
    ///
    /// The points are those of [`Self::point`]. With D the largest absolute value of the coordinate among the control points
    /// of the span, and M_e the sum of the absolute values of the terms that the derivatives of order e of the functions are
    /// sums of (`docs/float.md` says which), a derivative v comes out with an error of at most
    ///
    /// u|v| + k(e + 4)·2⁻⁹⁸·D·M_e,
    ///
    /// barring underflow: rounded once, unless more than 40 bits cancel. It is exactly 0 where all control points of the span
    /// are equal and the functions add up to 1. Only what is not finite is an error.
    ///
    /// ```
    /// use knotproof::float::{FloatBasis, FloatCurve};
    /// use knotproof::spline::Side;
    ///
    /// let basis = FloatBasis::new(vec![0.0, 0.0, 0.0, 1.0, 1.0, 1.0], 2, -1.0)?;
    /// let curve = FloatCurve::new(basis, 2, vec![0.0, 0.0, 1.0, 2.0, 2.0, 0.0])?;
    /// let mut rows = [0.0; 4];
    /// curve.derivatives(0.0, Side::Right, 1, &mut rows)?;
    /// assert_eq!(rows, [0.0, 0.0, 1.0, 2.0]);
    /// # Ok::<(), knotproof::float::FloatError>(())
    /// ```
    ///
    /// # Errors
    /// [`FloatError::Point`] if x is not finite; [`FloatError::Order`] above the highest order; [`FloatError::Length`]
    /// unless there are order + 1 rows with a place for each coordinate; [`FloatError::Derivative`] for a derivative beyond
    /// the range, or for any but the points where gaps and r are so far apart (2^400, for `f32` 2^100) that the terms may be.
    pub fn derivatives(
        &self,
        x: F,
        side: Side,
        order: usize,
        rows: &mut [F],
    ) -> Result<Option<Span>, FloatError> {
        if order > HIGHEST_DEGREE {
            return Err(FloatError::Order(order));
        }
        length("derivatives", (order + 1).saturating_mul(self.dimension), rows.len())?;
        let (point, rest) = rows.split_at_mut(self.dimension);
        let span = self.point(x, side, point)?;
        let (Some(at), true) = (span, order > 0) else {
            rest.fill(F::zero());
            return Ok(span);
        };
        let unit = self.basis.frame.as_ref().ok_or(FloatError::Derivative(1))?.unit.widen();
        for coordinate in 0..self.dimension {
            let jets = self.jets(at, x, coordinate, order).ok_or(FloatError::Derivative(1))?;
            let mut factor = Pair::ONE;
            for e in 1..=order {
                // e!·unit^e, and nothing is rounded up to 18!.
                factor = times(factor, Pair::of(small(e)));
                let scaled = times(jets[e][0], factor).hi;
                let value = F::nearest((0..e).fold(scaled, |scaled, _| scaled * unit) * self.unit.widen());
                if !value.is_finite() {
                    return Err(FloatError::Derivative(e));
                }
                rest[(e - 1) * self.dimension + coordinate] = value;
            }
        }
        Ok(span)
    }

    /// The unit vector c′/|c′| at x, as a limit from the given side, into `direction`; returns the speed |c′|. `None`, and
    /// zeros, where there is none: outside [t_0, t_m], and where c′ comes out as 0.
    ///
    /// The errors are those of [`Self::derivatives`], relative to |c′|, and 4u: only where nearly all of c′ cancels the direction
    /// is not one to all of its digits.
    ///
    /// # Errors
    /// Those of [`Self::derivatives`], with one row.
    pub fn tangent(&self, x: F, side: Side, direction: &mut [F]) -> Result<Option<F>, FloatError> {
        length("direction", self.dimension, direction.len())?;
        direction.fill(F::zero());
        let Some(([velocity, _], e)) = self.scaled_derivatives(x, side, 1)? else { return Ok(None) };
        let speed = norm(&velocity);
        for (place, v) in direction.iter_mut().zip(&velocity) {
            *place = F::nearest(v.hi / speed);
        }
        // In the unit of the frame, and of the points.
        let unit = self.basis.frame.as_ref().map_or(1.0, |frame| frame.unit.widen());
        let speed = F::nearest(shifted(speed, e) * unit * self.unit.widen());
        if speed.is_finite() { Ok(Some(speed)) } else { Err(FloatError::Derivative(1)) }
    }

    /// The curvature at x, as a limit from the given side: in the plane det(c′, c″)/|c′|³, which is positive where the curve
    /// bends to the left; in other dimensions |c″ − (c′·c″)c′/|c′|²|/|c′|² ≥ 0. `None` where c′ comes out as 0, and outside
    /// [t_0, t_m].
    ///
    /// The errors are those of [`Self::derivatives`] in c′ and c″, and 9u.
    ///
    /// # Errors
    /// Those of [`Self::derivatives`], for the order 2; [`FloatError::Derivative`] for a curvature beyond the range.
    pub fn curvature(&self, x: F, side: Side) -> Result<Option<F>, FloatError> {
        let Some(([velocity, half], e)) = self.scaled_derivatives(x, side, 2)? else { return Ok(None) };
        let (square, speed) = (dot(&velocity, &velocity), norm(&velocity));
        let bend = match (&velocity[..], &half[..]) {
            ([a, b], [c, d]) => times(*a, *d).plus(Split, times(*b, *c).negate()).hi / square.hi,
            _ => {
                let along = dot(&velocity, &half).over(Split, square).normal(Split);
                let across = |(a, v): (&Pair, &Pair)| a.plus(Split, times(along, *v).negate());
                let across: Vec<_> = half.iter().zip(&velocity).map(across).collect();
                norm(&across) / speed
            }
        };
        // c″ is twice the coefficient; both are in units of 2^e.
        let curvature = F::nearest(shifted(2.0 * bend / speed, -e) / self.unit.widen());
        if curvature.is_finite() { Ok(Some(curvature)) } else { Err(FloatError::Derivative(2)) }
    }

    /// The Taylor coefficients of orders 1 and 2 in the unit of the frame, times 2^−e, which brings the first one close to 1;
    /// `None` if that is 0.
    fn scaled_derivatives(&self, x: F, side: Side, order: usize) -> Result<Option<Scaled>, FloatError> {
        let Some(span) = self.basis.span_at(x, side)? else { return Ok(None) };
        let (mut velocity, mut half) = (Vec::new(), Vec::new());
        for coordinate in 0..self.dimension {
            let jets = self.jets(span, x, coordinate, order).ok_or(FloatError::Derivative(1))?;
            velocity.push(jets[1][0]);
            half.push(jets[2][0]);
        }
        let largest = velocity.iter().fold(0.0_f64, |largest, v| largest.max(v.hi.abs()));
        if !largest.is_finite() {
            return Err(FloatError::Derivative(1));
        }
        if largest == 0.0 {
            return Ok(None);
        }
        let e = exponent(largest);
        for pair in velocity.iter_mut().chain(&mut half) {
            *pair = Pair { hi: shifted(pair.hi, -e), lo: shifted(pair.lo, -e) };
        }
        Ok(Some(([velocity, half], e)))
    }

    /// The Taylor coefficients of a coordinate at x of the closed span, in the unit of the frame and divided by that of the
    /// points: those of order e are entry (e, 0). `None` without a frame.
    fn jets(&self, span: Span, x: F, coordinate: usize, order: usize) -> Option<Jets> {
        let frame = self.basis.frame.as_ref()?;
        let degree = self.basis.degree();
        let mut jets = [[Pair::ZERO; HIGHEST_DEGREE + 1]; HIGHEST_DEGREE + 1];
        for c in self.basis.existing(span) {
            jets[0][c] = Pair::of(self.control(span, c, coordinate));
        }
        let knots = frame.local(span, degree);
        self.basis.machine.run(JetDeBoor {
            ratio: self.basis.ratio,
            x: x * frame.unit,
            knots,
            order,
            jets: &mut jets,
        });
        Some(jets)
    }
}

/// The product as a normal pair.
fn times(a: Pair, b: Pair) -> Pair {
    a.times(Split, b).normal(Split)
}

/// a·b, by pairs.
fn dot(a: &[Pair], b: &[Pair]) -> Pair {
    a.iter().zip(b).fold(Pair::ZERO, |sum, (a, b)| sum.plus(Split, times(*a, *b)))
}

/// |a|.
fn norm(a: &[Pair]) -> f64 {
    dot(a, a).hi.sqrt()
}

/// De Boor's algorithm over jets x + ε, in the unit of a frame, on one coordinate of d_{j−k}, …, d_j.
struct JetDeBoor<'a, F> {
    ratio: Ratio,
    x: F,
    knots: &'a [F],
    order: usize,
    jets: &'a mut Jets,
}

impl<F: Real> Kernel for JetDeBoor<'_, F> {
    type Output = ();

    /// As left + w(own − left): derivatives depend on differences only, and those of equal points are 0.
    #[inline(always)]
    fn run<M: Vectors>(self, machine: M) {
        let Self { ratio, x, knots, order, jets } = self;
        let (m, degree) = (machine.single(), knots.len() / 2);
        let terms = JetFrame::new(m, ratio, degree, x.widen(), |i| knots[i].widen());
        for d in (1..=degree).rev() {
            for c in 0..d {
                let weight = WeightJet::new(m, &terms, ratio, knots, d, c);
                let (mut previous, mut series) = (Pair::ZERO, Pair::ZERO);
                for row in jets.iter_mut().take(order + 1) {
                    let difference = row[c + 1].plus(m, row[c].negate());
                    series = weight.series(m, previous, series);
                    row[c] = row[c].plus(m, weight.w.times(m, difference).normal(m).plus(m, series));
                    previous = difference;
                }
            }
        }
    }
}
