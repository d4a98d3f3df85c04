//! Curves as NURBS: the pieces of a curve on one knot vector, of one degree.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::Signed;
use thiserror::Error;

use crate::scalar::{Ring, integer, rationals_between};
use crate::spline::{Curve, Point, Span};

use super::curve_part::{CurvePart, CurvePartError};
use super::homogeneous::{Homogeneous, blend};
use super::rational_bezier::RationalBezier;

/// One connected run of a curve as one NURBS curve: with the B-splines N_i^D of the knots τ,
///
/// G_α(x) = Σ w_i c_i N_i^D(y) / Σ w_i N_i^D(y), and y = x but for the [standard form](Self::joined).
///
/// All weights w_i are positive and the first one is 1; the first and the last knot have D + 1 copies each.
///
/// ```
/// use knotproof::analysis::{Nurbs, NurbsRequest, RationalBezier};
/// use knotproof::scalar::integer;
/// use knotproof::spline::{Basis, Curve, Index, KnotVector};
///
/// // α = ∞: the polynomial B-spline that it is, with its own knots and control points.
/// let knots = KnotVector::new([0, 0, 0, 1, 2, 2, 2].map(integer).to_vec())?;
/// let basis = Basis::new(knots.clone(), 2, Index::infinity())?;
/// let points = [[0, 0], [1, 2], [2, 2], [3, 0]].map(|point| point.map(integer).to_vec()).to_vec();
/// let curve = Curve::new(basis, points.clone())?;
/// let pieces = RationalBezier::pieces(&curve).collect::<Result<Vec<_>, _>>()?;
/// let runs = Nurbs::joined(&curve, &pieces, &NurbsRequest::default())?;
/// assert_eq!((runs.len(), runs[0].knots(), runs[0].points()), (1, knots.knots(), points));
/// // It is the curve for every x.
/// assert!(runs[0].pieces().all(|piece| piece.disagreement(&curve).is_none()));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Nurbs {
    degree: usize,
    knots: Vec<BigRational>,
    /// (w_i, w_i c_i).
    controls: Vec<Point>,
    parameters: Vec<SpanParameter>,
}

/// The parameter y of a NURBS curve on one of its spans [a, b], against that of the curve, x:
///
/// (x − a)/(b − x) = λ (y − a)/(b − y), λ > 0.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SpanParameter {
    span: Span,
    /// a, b.
    pub ends: [BigRational; 2],
    /// λ; 1 where y = x.
    pub ratio: BigRational,
    /// The weight of the curve at b.
    pub weight: BigRational,
}

/// What a NURBS form is to be like. By default the whole curve, of the least degree, with its own parameter.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct NurbsRequest {
    /// A degree D in place of the least one.
    pub degree: Option<usize>,
    /// Where the curve begins, in place of t_0.
    pub from: Option<BigRational>,
    /// Where it ends, in place of t_m.
    pub to: Option<BigRational>,
    /// Weight 1 at both ends of each piece.
    pub standard_form: bool,
}

/// A NURBS form that there is not.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum NurbsError {
    /// D is too low or too high.
    #[error("degree {given} is not between {least}, the least that all pieces have, and {most}")]
    Degree {
        /// What was asked for.
        given: usize,
        /// The least common degree.
        least: usize,
        /// The highest degree that is written.
        most: usize,
    },
    /// The curve is not there.
    #[error(transparent)]
    Part(#[from] CurvePartError),
}

impl Nurbs {
    /// The pieces of a curve joined: a NURBS curve for each connected run, from left to right.
    ///
    /// **Degree.** All runs have one degree D: the highest of the pieces, at least k and at least 1, or a higher one.
    ///
    /// **Joints.** A piece in homogeneous coordinates (ω_m, ω_m b_m) is defined up to a factor; it is scaled to begin with the
    /// weight that the one before ends with, which makes the homogeneous curve continuous where the curve is. Where the curve
    /// jumps, which it may do at knots of more than k copies, a run ends. A joint with p copies in the curve's own knots
    /// has D − min(k − p, c) in τ, if the homogeneous curve has c continuous derivatives there. So the knots of α = ∞ and of
    /// NURBS as a family are kept, and for another α, where the derivative of the curve jumps, a joint has D copies.
    ///
    /// **Standard form.** ω_m → ω_m λ^m is the same set of points in another parameter, see [`SpanParameter`]. With λ^N = 1/ω_N for a
    /// piece of least degree N both of its ends have weight 1, and so have all joints. If that λ is irrational, it is the
    /// simplest rational number for which the weight at the end differs from 1 by less than 10⁻¹⁸: still the same set
    /// of points, exactly, and weights that are 1 as floats.
    ///
    /// **Control points.** (w_i, w_i c_i) is the blossom of a piece over the support of N_i^D, at τ_{i+1}, …, τ_{i+D}.
    ///
    /// # Errors
    /// [`NurbsError`], if the request can't be met. That the pieces are those of the curve is not looked at: see
    /// [`pieces`](Self::pieces).
    pub fn joined<W>(
        curve: &Curve<W>,
        pieces: &[RationalBezier],
        request: &NurbsRequest,
    ) -> Result<Vec<Self>, NurbsError> {
        let (knots, k) = (curve.basis().knots(), curve.basis().degree());
        let part = CurvePart::of(curve, request.from.as_ref(), request.to.as_ref())?;
        let pieces: Vec<_> =
            pieces.iter().filter_map(|piece| piece.homogeneous().within(part.ends())).collect();
        let least = pieces.iter().map(Homogeneous::degree).fold(k.max(1), usize::max);
        let (degree, most) = (request.degree.unwrap_or(least), RationalBezier::HIGHEST_DEGREE.max(least));
        if !(least..=most).contains(&degree) {
            return Err(NurbsError::Degree { given: degree, least, most });
        }
        let mut runs: Vec<Vec<Joint>> = Vec::new();
        for piece in pieces {
            let before = runs.last().and_then(|run| run.last()).map(|joint| &joint.piece);
            let before = before.filter(|before| {
                before.ends[1] == piece.ends[0] && point(before.last()) == point(piece.first())
            });
            let weight = before.map_or(integer(1), |before| before.last()[0].clone());
            let ratio = if request.standard_form { standard_ratio(&piece, &weight) } else { integer(1) };
            let copies = knots.multiplicity(&piece.ends[0]);
            let continued = before.is_some();
            let piece = piece.reparametrised(&ratio).elevated(degree).beginning_with(&weight);
            let joint = Joint { smooth: k.saturating_sub(copies), ratio, piece };
            match runs.last_mut() {
                Some(run) if continued => run.push(joint),
                _ => runs.push(vec![joint]),
            }
        }
        Ok(runs.into_iter().map(|run| Self::of_run(degree, run)).collect())
    }

    fn of_run(degree: usize, run: Vec<Joint>) -> Self {
        let smooth = |pair: &[Joint]| pair[0].piece.contact(&pair[1].piece, pair[1].smooth);
        let inner: Vec<_> =
            run.windows(2).map(|pair| (&pair[1].piece.ends[0], degree - smooth(pair))).collect();
        let (knots, controls) = with_positive_weights(degree, &run, &inner);
        let parameters = run.into_iter().map(|Joint { ratio, piece, .. }| SpanParameter {
            span: piece.span,
            weight: piece.last()[0].clone(),
            ends: piece.ends,
            ratio,
        });
        Self { degree, parameters: parameters.collect(), knots, controls }
    }

    /// D.
    #[must_use]
    pub fn degree(&self) -> usize {
        self.degree
    }

    /// τ_0 ≤ τ_1 ≤ …, D + 1 more than there are control points.
    #[must_use]
    pub fn knots(&self) -> &[BigRational] {
        &self.knots
    }

    /// w_0 = 1, w_1, …: all positive.
    pub fn weights(&self) -> impl Iterator<Item = &BigRational> {
        self.controls.iter().map(|control| &control[0])
    }

    /// c_0, c_1, …
    #[must_use]
    pub fn points(&self) -> Vec<Point> {
        self.controls.iter().map(|control| point(control)).collect()
    }

    /// The parameter on each span that is not empty, from left to right.
    #[must_use]
    pub fn parameters(&self) -> &[SpanParameter] {
        &self.parameters
    }

    /// Turned back: the pieces on the spans of τ, in the parameter of the curve, by de Boor's algorithm on knots and control
    /// points. Their degree is D. That none [disagrees](RationalBezier::disagreement) with the curve **proves** that the
    /// NURBS curve is the curve, for every x.
    pub fn pieces(&self) -> impl Iterator<Item = RationalBezier> {
        let spans = (0..self.knots.len() - 1).filter(|&j| self.knots[j] < self.knots[j + 1]);
        spans.zip(&self.parameters).map(|(j, parameter)| {
            let (first, ends) = (j - self.degree, [self.knots[j].clone(), self.knots[j + 1].clone()]);
            let control = |m: usize| {
                let [a, b] = &ends;
                let arguments = std::iter::repeat_n(a, self.degree - m).chain(std::iter::repeat_n(b, m));
                self.blossom(j, arguments)
            };
            // Between knots of D copies the control points are those of the piece.
            let bezier = self.knots[first + 1] == ends[0] && self.knots[j + self.degree] == ends[1];
            let net = if bezier {
                self.controls[first..=j].to_vec()
            } else {
                (0..=self.degree).map(control).collect()
            };
            let piece = Homogeneous { span: parameter.span, net, ends };
            RationalBezier::of(piece.reparametrised(&parameter.ratio.recip()))
        })
    }

    /// The blossom of the piece on [τ_j, τ_{j+1}].
    fn blossom<'a>(&self, j: usize, arguments: impl Iterator<Item = &'a BigRational>) -> Point {
        let first = j - self.degree;
        let mut level = self.controls[first..=j].to_vec();
        for (r, x) in (1..).zip(arguments) {
            for i in 0..level.len() - 1 {
                let (low, high) = (&self.knots[first + r + i], &self.knots[j + 1 + i]);
                level[i] = blend(&level[i], &level[i + 1], &((x - low) / (high - low)));
            }
            level.pop();
        }
        level.swap_remove(0)
    }
}

/// A piece of a run.
struct Joint {
    piece: Homogeneous,
    /// λ.
    ratio: BigRational,
    /// max(k − p, 0), the continuous derivatives that any curve has at its beginning, a knot with p copies.
    smooth: usize,
}

/// τ and (w_i, w_i c_i), with so many copies of the inner knots. A blossom of positive weights need not be positive; those at the
/// ends of a piece are its own weights: then all inner knots have D copies.
fn with_positive_weights(
    degree: usize,
    run: &[Joint],
    inner: &[(&BigRational, usize)],
) -> (Vec<BigRational>, Vec<Point>) {
    let ends = [&run[0].piece.ends[0], &run[run.len() - 1].piece.ends[1]];
    let inside = inner.iter().flat_map(|(t, copies)| std::iter::repeat_n(*t, *copies));
    let [first, last] = ends.map(|t| std::iter::repeat_n(t, degree + 1));
    let knots: Vec<_> = first.chain(inside).chain(last).cloned().collect();
    let control = |i: usize| {
        let at = run.partition_point(|joint| joint.piece.ends[0] < knots[i]);
        run[at].piece.blossom(&knots[i + 1..=i + degree])
    };
    let controls: Vec<_> = (0..knots.len() - degree - 1).map(control).collect();
    if controls.iter().all(|control| control[0].is_positive()) {
        return (knots, controls);
    }
    let full: Vec<_> = inner.iter().map(|(t, _)| (*t, degree)).collect();
    with_positive_weights(degree, run, &full)
}

/// (w, wc) → c.
fn point(control: &[BigRational]) -> Point {
    control[1..].iter().map(|coordinate| coordinate / &control[0]).collect()
}

/// How close to 1 the weights at the ends of pieces are in standard form: 1 as floats.
fn closeness() -> BigRational {
    integer(BigInt::from(10).pow(18)).recip()
}

/// λ with λ^N = ω_0/ω_N where that is rational; else the simplest one for which the weight at the end, of a piece that begins
/// with `weight`, is close to 1.
fn standard_ratio(piece: &Homogeneous, weight: &BigRational) -> BigRational {
    let Ok(degree @ 1..) = u32::try_from(piece.degree()) else { return integer(1) };
    let end = &piece.last()[0] / &piece.first()[0];
    let exact = BigRational::new(end.denom().nth_root(degree), end.numer().nth_root(degree));
    if exact.power(piece.degree()) == end.recip() {
        return exact;
    }
    let target = (weight * end).recip();
    // λ > 2^(−bits/N − 1), so that these are 127 significant bits or more: many more than the interval asks for.
    let bits = 128 + target.denom().bits() / u64::from(degree);
    let root =
        |power: BigRational| ((power.numer() << (bits * u64::from(degree))) / power.denom()).nth_root(degree);
    let unit = BigRational::new(BigInt::from(1), BigInt::from(1) << bits);
    let low = integer(root(&target * (integer(1) - closeness())) + 1) * &unit;
    let high = integer(root(&target * (integer(1) + closeness()))) * &unit;
    rationals_between(&low, &high).next().unwrap_or(low)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::rational;
    use crate::spline::{Basis, KnotVector};

    /// Whatever is changed in it, what it is turned back into is no longer the curve.
    #[test]
    fn a_wrong_curve_is_noticed() {
        let knots = KnotVector::new([0, 0, 0, 1, 2, 2, 2].map(integer).to_vec()).unwrap();
        let basis = Basis::new(knots, 2, "5".parse().unwrap()).unwrap();
        let points = [[0, 0], [1, 2], [2, 2], [3, 0]].map(|point| point.map(integer).to_vec()).to_vec();
        let curve = Curve::new(basis, points).unwrap();
        let pieces: Vec<_> = RationalBezier::pieces(&curve).collect::<Result<_, _>>().unwrap();
        let request = NurbsRequest { standard_form: true, ..NurbsRequest::default() };
        let right = Nurbs::joined(&curve, &pieces, &request).unwrap().remove(0);
        let agrees = |run: &Nurbs| run.pieces().all(|piece| piece.disagreement(&curve).is_none());
        assert!(agrees(&right));
        let little = rational(1, 1000);
        for i in 0..right.controls.len() {
            for c in 0..3 {
                let mut wrong = right.clone();
                wrong.controls[i][c] += &little;
                assert!(!agrees(&wrong), "control point {i}, coordinate {c}");
            }
        }
        let mut moved = right.clone();
        moved.knots.iter_mut().filter(|t| **t == integer(1)).for_each(|t| *t += &little);
        assert!(!agrees(&moved));
        for span in 0..2 {
            let mut wrong = right.clone();
            wrong.parameters[span].ratio += &little;
            assert!(!agrees(&wrong), "λ of span {span}");
        }
    }

    /// With roots on either side of 1, and one that is known.
    #[test]
    fn ratios_bring_the_end_to_one() {
        let knots = KnotVector::new([0, 1].map(integer).to_vec()).unwrap();
        let span = knots.spans().next().unwrap();
        for (degree, end) in [(2, 2), (3, 1_000_000_007), (21, 3), (5, 1)] {
            for end in [integer(end), rational(1, end)] {
                let control = |m: usize| vec![if m == degree { end.clone() } else { integer(1) }];
                let net = (0..=degree).map(control).collect();
                let piece = Homogeneous { span, ends: [integer(0), integer(1)], net };
                let ratio = standard_ratio(&piece, &integer(1));
                let difference = ratio.power(degree) * &end - integer(1);
                assert!(difference.abs() < closeness(), "{degree}, {end}: {ratio}");
                assert_eq!(difference == integer(0), end == integer(1));
                assert!(ratio.numer().bits().max(ratio.denom().bits()) < 48, "{ratio} is not simple");
            }
        }
        let square = Homogeneous {
            span,
            ends: [integer(0), integer(1)],
            net: [1, 5, 4].map(|w| vec![rational(w, 9)]).to_vec(),
        };
        assert_eq!(standard_ratio(&square, &integer(7)), rational(1, 2));
    }
}
