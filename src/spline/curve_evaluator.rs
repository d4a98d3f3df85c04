//! Exact points, de Boor's points, derivatives and tangents of one curve at many points.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::Zero;

use crate::scalar::{Jet, gcd, integer, lcm};

use super::curve::{Curve, Point};
use super::index::Index;
use super::kind::HasWeights;
use super::knots::{Side, Span};
use super::sampler::Sampler;
use super::triangle::Active;

/// Exact values of one curve at any number of points: what [`Curve`] computes anew for each of them is prepared once.
///
/// Knots and control points are brought to common denominators. With an index, d_i = D_i/Δ and the functions as numerators
/// N_i over the product P of all [factors](super::Factors) on the span, a point is Σ D_i N_i/(ΔP), which is brought to
/// lowest terms once for each coordinate. Weights of any other family go by the recursion over rational numbers.
///
/// ```
/// use knotproof::scalar::{integer, rational};
/// use knotproof::spline::{Basis, Curve, CurveEvaluator, Index, KnotVector, Side};
///
/// let knots = KnotVector::bernstein(2, &integer(0), &integer(1))?;
/// let basis = Basis::new(knots, 2, "-1".parse::<Index>()?)?;
/// let curve = Curve::new(basis, [[0, 0], [1, 2], [2, 0]].map(|point| point.map(integer).to_vec()).to_vec())?;
/// let mut evaluator = CurveEvaluator::new(&curve);
/// assert_eq!(evaluator.point(&rational(1, 2), Side::Right), [rational(2, 3), rational(8, 9)]);
/// assert_eq!(evaluator.derivatives(&integer(0), Side::Right, 1)[1], [integer(1), integer(2)]);
/// let tangent = evaluator.tangent(&integer(0), Side::Right).expect("the curve moves");
/// assert_eq!((tangent.order, tangent.direction), (1, vec![integer(1), integer(2)]));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone)]
pub struct CurveEvaluator<'a, W = Index> {
    curve: &'a Curve<W>,
    sampler: Sampler<'a, W>,
    /// Δ.
    scale: BigInt,
    /// D_0, …, D_n.
    points: Vec<Vec<BigInt>>,
}

/// The direction of a curve at a point, as a limit from one side, and how it bends there.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Tangent {
    /// The least d ≥ 1 with c^(d) ≠ 0. The speed is 0 if that is more than 1.
    pub order: usize,
    /// A vector ≠ 0 in the direction in which the curve is run through for rising x, the limit of c′/|c′|: c^(d)/d!, or, from the
    /// left, (−1)^(d−1) times that.
    pub direction: Point,
    /// The vector of curvature, the limit of (|c′|²c″ − (c′·c″)c′)/|c′|⁴; `None` if it is infinite.
    pub curvature: Option<Point>,
}

impl<'a, W: HasWeights> CurveEvaluator<'a, W> {
    /// Prepares knots and control points.
    #[must_use]
    pub fn new(curve: &'a Curve<W>) -> Self {
        let (coordinates, scale) = over_common_denominator(&curve.points().concat());
        let points = coordinates.chunks(curve.dimension()).map(<[_]>::to_vec).collect();
        Self { curve, sampler: Sampler::new(curve.basis()), scale, points }
    }

    /// The curve.
    #[must_use]
    pub fn curve(&self) -> &'a Curve<W> {
        self.curve
    }

    /// The point of the curve at x, as a limit from the side: that of [`Curve::point`], 0 outside of [t_0, t_m].
    pub fn point(&mut self, x: &BigRational, side: Side) -> Point {
        let outside = || vec![integer(0); self.points[0].len()];
        let Some(kernel) = self.sampler.kernel() else {
            let active = self.sampler.values(x, side);
            return active.map_or_else(outside, |active| self.curve.combine_unchecked(&active));
        };
        let Some(unreduced) = kernel.at(x, side) else { return outside() };
        let (numerators, denominator) = unreduced.over_common_denominator();
        let (points, denominator) = (&self.points[unreduced.first()..], denominator * &self.scale);
        let coordinate = |c: usize| {
            let sum: BigInt = numerators.iter().zip(points).map(|(g, d)| g * &d[c]).sum();
            in_lowest_terms(sum, &denominator)
        };
        (0..self.points[0].len()).map(coordinate).collect()
    }

    /// The coordinates at x as jets of the given order, limits from the side: those of [`Curve::jets`].
    pub fn jets(&mut self, x: &BigRational, side: Side, order: usize) -> Vec<Jet<BigRational>> {
        if order == 0 {
            return self.point(x, side).into_iter().map(|value| Jet::constant(value, 0)).collect();
        }
        let jets = match self.sampler.kernel() {
            Some(kernel) => {
                let unreduced = kernel.jets_at(x, side, order);
                unreduced.map(|unreduced| unreduced.combine(&self.points, &self.scale))
            }
            None => {
                let active = self.sampler.jets(x, side, order);
                active.map(|active| self.curve.combine_unchecked(&active))
            }
        };
        jets.unwrap_or_else(|| vec![Jet::constant(integer(0), order); self.points[0].len()])
    }

    /// c, c′, …, c^(D) at x, limits from the side; all 0 outside of [t_0, t_m].
    pub fn derivatives(&mut self, x: &BigRational, side: Side, order: usize) -> Vec<Point> {
        let by_coordinate: Vec<_> = self.jets(x, side, order).iter().map(Jet::derivatives).collect();
        (0..=order).map(|d| by_coordinate.iter().map(|of_one| of_one[d].clone()).collect()).collect()
    }

    /// All points of de Boor's algorithm at x, level by level: those of [`Curve::de_boor`], `None` outside of [t_k, t_{n+1}].
    ///
    /// With linear weights, w = rise/L and 1 − w = fall/L in integers, and each coordinate is brought to lowest terms once.
    pub fn de_boor(&mut self, x: &BigRational, side: Side) -> Option<Vec<Active<Point>>> {
        let Some(kernel) = self.sampler.kernel() else { return self.curve.de_boor(x, side) };
        let span = self.curve.basis().knots().span_at(x, side)?;
        let points = self.curve.points_on(span)?;
        let factors = kernel.factors_at(span, x);
        let degree = points.len() - 1;
        let mut levels = vec![Active::new(span.index() - degree, points.to_vec())];
        for r in 0..degree {
            let level = &levels[r];
            let first = level.first() + 1;
            let blend = |(i, pair): (usize, &[Point])| -> Point {
                let (rise, fall) = factors.shares(i, degree - r);
                let sum = rise + fall;
                let blend = |(own, left): (&BigRational, &BigRational)| {
                    let parts = rise * own.numer() * left.denom() + fall * left.numer() * own.denom();
                    in_lowest_terms(parts, &(&sum * own.denom() * left.denom()))
                };
                pair[1].iter().zip(&pair[0]).map(blend).collect()
            };
            levels.push(Active::new(first, (first..).zip(level.values().windows(2)).map(blend).collect()));
        }
        Some(levels)
    }

    /// The tangent at x, as a limit from the side, at t_m from the left; `None` where there is none: outside of [t_0, t_m], and
    /// where the curve stands still, that is, is one point on the span.
    ///
    /// With c(x ± s) = c + s^d(v + w_1 s + w_2 s² + …), v ≠ 0, and w⊥ the part of w across v, the vector of curvature is
    /// 2w_d⊥/|v|² if w_1⊥ = … = w_{d−1}⊥ = 0, and infinite if not: across v the curve moves like s^(d+e), along it like s^d.
    pub fn tangent(&mut self, x: &BigRational, side: Side) -> Option<Tangent> {
        let knots = self.curve.basis().knots();
        let span = knots.span_at(x, side)?;
        let from_left = side == Side::Left || x == knots.last();
        let mut order = 2;
        let (d, jets) = loop {
            let jets = self.jets(x, side, order);
            let moves = |d: &usize| jets.iter().any(|jet| !jet.coefficients()[*d].is_zero());
            match (1..=order).find(moves) {
                Some(d) if 2 * d <= order => break (d, jets),
                Some(d) => order = 2 * d,
                None if self.stands_still(span) => return None,
                None => order *= 2,
            }
        };
        let coefficient = |e: usize| jets.iter().map(|jet| jet.coefficients()[e].clone()).collect::<Point>();
        let v = coefficient(d);
        let straight = |e: usize| across(&v, &coefficient(d + e)).0.iter().all(Zero::is_zero);
        let curvature = (1..d).all(straight).then(|| {
            let (parts, denominator) = across(&v, &coefficient(2 * d));
            parts.into_iter().map(|part| in_lowest_terms(part * 2, &denominator)).collect()
        });
        let backwards = from_left && d % 2 == 0;
        let direction = if backwards { v.into_iter().map(|v| -v).collect() } else { v };
        Some(Tangent { order: d, direction, curvature })
    }

    /// Is the curve one point on the span? A difference of its points is a quotient whose numerator has a degree of at most K
    /// ([`Basis::quotient_degree`](super::Basis::quotient_degree)): it is 0 if it has K + 1 zeros.
    fn stands_still(&mut self, span: Span) -> bool {
        let basis = self.curve.basis();
        let Ok((start, end)) = basis.knots().ends(span) else { return false };
        let count = basis.quotient_degree(span) + 1;
        let place = |l: usize| start + (end - start) * BigRational::new(l.into(), (count + 1).into());
        let first = self.point(&place(1), Side::Right);
        (2..=count).all(|l| self.point(&place(l), Side::Right) == first)
    }
}

/// w⊥/|v|² = (|v|²w − (v·w)v)/|v|⁴ over one denominator > 0: for v = V/p and w = W/q it is
/// p²(|V|²W − (V·W)V)/(q|V|⁴).
fn across(v: &[BigRational], w: &[BigRational]) -> (Vec<BigInt>, BigInt) {
    let [(v, p), (w, q)] = [v, w].map(over_common_denominator);
    let dot = |a: &[BigInt], b: &[BigInt]| a.iter().zip(b).map(|(a, b)| a * b).sum::<BigInt>();
    let (square, along, scale) = (dot(&v, &v), dot(&v, &w), &p * &p);
    let parts = v.iter().zip(&w).map(|(v, w)| (&square * w - &along * v) * &scale).collect();
    (parts, q * &square * &square)
}

/// Numbers as integers over one denominator.
fn over_common_denominator(numbers: &[BigRational]) -> (Vec<BigInt>, BigInt) {
    let common = numbers.iter().fold(BigInt::from(1), |common, c| lcm(&common, c.denom()));
    (numbers.iter().map(|c| c.numer() * (&common / c.denom())).collect(), common)
}

/// The quotient by a number > 0.
fn in_lowest_terms(numerator: BigInt, denominator: &BigInt) -> BigRational {
    let common = gcd(&numerator, denominator);
    if common == BigInt::from(1) {
        return BigRational::new_raw(numerator, denominator.clone());
    }
    BigRational::new_raw(numerator / &common, denominator / common)
}
