//! Curves as rational Bézier curves, span by span.

use num_rational::BigRational;
use num_traits::Signed;
use thiserror::Error;

use crate::scalar::{Polynomial, RationalAlgebra, RationalFunction, Ring, integer};
use crate::spline::{Curve, HasWeights, Point, Side, Span, WeightKind, binomial};

use super::curve_part::CurvePart;
use super::homogeneous::Homogeneous;
use super::linear::over_common_denominator;
use super::pieces::own_pieces;
use super::span_quotients::OneDenominator;

/// A curve on one span [t_j, t_{j+1}] as a rational Bézier curve: with s = (x − t_j)/(t_{j+1} − t_j),
///
/// G_α(x) = Σ ω_m b_m B_m^N(s) / Σ ω_m B_m^N(s), B_m^N(s) = C(N, m) s^m (1 − s)^{N−m},
///
/// with the first weight ω_0 = 1, as NURBS programs have it, and N the least degree that there is for this curve
/// and this parameter x.
///
/// **Derivation.** In u = s/(1 − s), the span's [positive coordinate](super::positive_coordinate), the coordinates
/// of the curve are quotients p_c(u)/q(u) over one denominator q = ∏ (u + c), c > 0. A polynomial Σ a_m u^m of
/// formal degree N is Σ (a_m/C(N, m)) B_m^N(s) up to the factor (1 − s)^N, which cancels: so ω_m is q_m/C(N, m)
/// and b_m is p_m/q_m, coefficient by coefficient, after all factors common to q and all p_c are divided out.
///
/// **All weights are positive**, for every knot vector, index and polygon, and no control point is at infinity:
/// what is left of q is still a product of factors u + c with c > 0, so that none of its N + 1 coefficients is 0
/// or less, and no p_c has a higher degree than q, since the curve is finite at u = ∞, that is, at t_{j+1}. For the forms of
/// another family q is some polynomial that is positive for all u ≥ 0, and its coefficients need not be: then q and all p_c
/// are multiplied by 1 + u until they are, which they are in the end (Pólya), and N is the least degree with positive
/// weights.
///
/// **The degree.** q starts with at most k(k + 1)/2 factors: one for each d = 1..k and each different c = A/B,
/// A = r(t_j − a) + (b − t_j), B = r(t_{j+1} − a) + (b − t_{j+1}), that an interval [a, b] = [t_i, t_{i+d}] over
/// the span gives. So N ≤ k(k + 1)/2, and N ≤ k for α = ∞, with all weights 1 (where c = 1 always), and also
/// where the only knots around are a and b (P3.3: then ω_m = r^m). Special polygons have less: N = 0 where the
/// curve stands still.
///
/// Spans outside of [t_k, t_{n+1}], which only vectors that are not open have, are no exception: there the curve
/// is Σ d_i G_i^k as everywhere, though the G_i^k add up to less than 1, so that it need not stay in the convex
/// hull of the d_i, and the b_m are not combinations of them with sum 1.
///
/// ```
/// use knotproof::analysis::RationalBezier;
/// use knotproof::scalar::{integer, rational};
/// use knotproof::spline::{Basis, Curve, Index, KnotVector};
///
/// // Bernstein, degree 2, α = −1, so r = 1/2: the weights are 1, r, r², and the control points stay.
/// let knots = KnotVector::bernstein(2, &integer(0), &integer(1))?;
/// let basis = Basis::new(knots, 2, "-1".parse::<Index>()?)?;
/// let points = [[0, 0], [1, 2], [2, 0]].map(|point| point.map(integer).to_vec()).to_vec();
/// let curve = Curve::new(basis, points.clone())?;
/// let pieces = RationalBezier::pieces(&curve).collect::<Result<Vec<_>, _>>()?;
/// assert_eq!(pieces[0].weights(), [integer(1), rational(1, 2), rational(1, 4)]);
/// assert_eq!(pieces[0].points(), points);
/// // It is the curve for every x.
/// assert_eq!(pieces[0].disagreement(&curve), None);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct RationalBezier {
    span: Span,
    from: BigRational,
    to: BigRational,
    weights: Vec<BigRational>,
    points: Vec<Point>,
}

/// A curve with a piece that has no rational Bézier form that is asked for.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[error(
    "on [{from}, {to}] no rational Bézier curve of degree up to {limit} has positive weights only",
    limit = RationalBezier::HIGHEST_DEGREE
)]
pub struct RationalBezierError {
    from: BigRational,
    to: BigRational,
}

impl RationalBezier {
    /// How far the degree is raised in search of positive weights.
    pub const HIGHEST_DEGREE: usize = 300;

    /// The pieces of a curve on all spans of [t_0, t_m] that are not empty, from left to right. Forms have no pole on a
    /// closed span.
    ///
    /// # Errors
    /// [`RationalBezierError`], never for the weights of an index.
    pub fn pieces<W: HasWeights>(
        curve: &Curve<W>,
    ) -> impl Iterator<Item = Result<Self, RationalBezierError>> {
        curve.basis().knots().spans().map(|span| Self::on(curve, span))
    }

    /// The same on a part of the curve: pieces that begin or end inside of a span are cut there, and keep their degree.
    ///
    /// # Errors
    /// Those of [`pieces`](Self::pieces).
    pub fn pieces_on<W: HasWeights>(
        curve: &Curve<W>,
        part: &CurvePart,
    ) -> impl Iterator<Item = Result<Self, RationalBezierError>> {
        let knots = curve.basis().knots();
        let meets = |span: &Span| {
            let [from, to] = part.ends();
            knots.t(span.index()) < to && knots.t(span.index() + 1) > from
        };
        let cut = |piece: Self| Some(Self::of(piece.homogeneous().within(part.ends())?));
        knots.spans().filter(meets).filter_map(move |span| Self::on(curve, span).map(cut).transpose())
    }

    fn on<W: HasWeights>(curve: &Curve<W>, span: Span) -> Result<Self, RationalBezierError> {
        let ends = [span.index(), span.index() + 1].map(|i| curve.basis().knots().t(i).clone());
        let (denominator, coordinates) = quotients(curve, span);
        Self::from_quotients(span, ends, denominator, coordinates)
    }

    /// The p_c/q in the positive coordinate of [a, b] as a Bézier curve: both are multiplied by 1 + u until all weights are positive.
    fn from_quotients(
        span: Span,
        [from, to]: [BigRational; 2],
        mut denominator: Polynomial<BigRational>,
        mut coordinates: Vec<Polynomial<BigRational>>,
    ) -> Result<Self, RationalBezierError> {
        let one = Polynomial::constant(integer(1));
        let more = one.plus(&Polynomial::variable(&integer(1)));
        while !denominator.coefficients().iter().all(Signed::is_positive) {
            if denominator.degree() >= Self::HIGHEST_DEGREE {
                return Err(RationalBezierError { from, to });
            }
            denominator = denominator.times(&more);
            coordinates.iter_mut().for_each(|p| *p = p.times(&more));
        }
        let (degree, q) = (denominator.degree(), denominator.coefficients());
        let weights = (0..=degree).map(|m| &q[m] / (&q[0] * binomial(degree, m))).collect();
        let entry = |p: &Polynomial<_>, m: usize| p.coefficients().get(m).map_or(integer(0), |p| p / &q[m]);
        let points = (0..=degree).map(|m| coordinates.iter().map(|p| entry(p, m)).collect()).collect();
        Ok(Self { span, from, to, weights, points })
    }

    /// The hodograph, dc/dx on [a, b], as a rational Bézier curve of the least degree with positive weights: in the positive
    /// coordinate u of [a, b], with c = p/q,
    ///
    /// dc/dx = (p′q − pq′)(1 + u)²/((b − a)q²),
    ///
    /// brought to lowest terms. So it has a degree of at most 2N, and N − 1 where the piece is a polynomial.
    ///
    /// ```
    /// use knotproof::analysis::RationalBezier;
    /// use knotproof::scalar::{integer, rational};
    /// use knotproof::spline::{Basis, Curve, Index, KnotVector, Side};
    ///
    /// let basis = Basis::new(KnotVector::bernstein(2, &integer(0), &integer(1))?, 2, "-1".parse::<Index>()?)?;
    /// let curve = Curve::new(basis, [[0, 0], [1, 2], [2, 0]].map(|point| point.map(integer).to_vec()).to_vec())?;
    /// let piece = RationalBezier::pieces(&curve).next().expect("one span")?;
    /// let x = rational(1, 3);
    /// let by_jets: Vec<_> = curve.jets(&x, Side::Right, 1).iter().map(|jet| jet.derivatives()[1].clone()).collect();
    /// assert_eq!(piece.derivative()?.point(&x), Some(by_jets));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`RationalBezierError`], where more than [`HIGHEST_DEGREE`](Self::HIGHEST_DEGREE) would be needed; never for the weights of an
    /// index of a degree k ≤ 10.
    pub fn derivative(&self) -> Result<Self, RationalBezierError> {
        let (weight, coordinates) = self.in_positive_coordinate();
        let more = Polynomial::new(integer(1), [integer(1)]);
        let length = &self.to - &self.from;
        let below = weight.times(&weight).scaled(&length);
        let slope = |p: &Polynomial<BigRational>| {
            let above = p.derivative().times(&weight).minus(&p.times(&weight.derivative()));
            RationalFunction::new(&above.times(&more).times(&more), &below)
        };
        let slopes: Vec<_> = coordinates.iter().filter_map(slope).collect();
        match over_common_denominator(&slopes) {
            Some((denominator, numerators)) => {
                let ends = [self.from.clone(), self.to.clone()];
                Self::from_quotients(self.span, ends, denominator, numerators)
            }
            None => unreachable!("a point has coordinates, and weights are not 0"),
        }
    }

    /// A piece, or a part of one, of any degree, from its control points in homogeneous coordinates, all weights positive.
    pub(super) fn of(piece: Homogeneous) -> Self {
        let Homogeneous { span, ends: [from, to], net } = piece;
        let points = net.iter().map(|control| control[1..].iter().map(|c| c / &control[0]).collect());
        let weights = net.iter().map(|control| &control[0] / &net[0][0]);
        Self { span, from, to, weights: weights.collect(), points: points.collect() }
    }

    /// The same in homogeneous coordinates.
    pub(super) fn homogeneous(&self) -> Homogeneous {
        let control = |(weight, point): (&BigRational, &Point)| {
            std::iter::once(weight.clone()).chain(point.iter().map(|c| weight * c)).collect()
        };
        let net = self.weights.iter().zip(&self.points).map(control).collect();
        Homogeneous { span: self.span, ends: [self.from.clone(), self.to.clone()], net }
    }

    /// The span [t_j, t_{j+1}).
    #[must_use]
    pub fn span(&self) -> Span {
        self.span
    }

    /// (t_j, t_{j+1}).
    #[must_use]
    pub fn ends(&self) -> (&BigRational, &BigRational) {
        (&self.from, &self.to)
    }

    /// N, the least degree of this curve in this parameter; of what a [`Nurbs`](super::Nurbs) is turned back into, that of the NURBS
    /// curve.
    #[must_use]
    pub fn degree(&self) -> usize {
        self.weights.len() - 1
    }

    /// ω_0 = 1, ω_1, …, ω_N: all positive.
    #[must_use]
    pub fn weights(&self) -> &[BigRational] {
        &self.weights
    }

    /// b_0, …, b_N.
    #[must_use]
    pub fn points(&self) -> &[Point] {
        &self.points
    }

    /// The point at x, by de Casteljau's algorithm on the points (ω_m, ω_m b_m), for any scalar: a point of the
    /// span, the jet of one, or x as a rational function, which gives the whole piece.
    ///
    /// Beyond the span it is the same rational function; `None` at a pole, of which there is none on the span.
    pub fn point<S: RationalAlgebra>(&self, x: &S) -> Option<Vec<S>> {
        let length = &self.to - &self.from;
        let s = x.minus(&x.embed(&self.from)).times(&x.embed(&length.recip()));
        let complement = s.one().minus(&s);
        let homogeneous = |(weight, point): (&BigRational, &Point)| -> Vec<S> {
            let coordinates = point.iter().map(|coordinate| x.embed(&(weight * coordinate)));
            std::iter::once(x.embed(weight)).chain(coordinates).collect()
        };
        let mut level: Vec<Vec<S>> = self.weights.iter().zip(&self.points).map(homogeneous).collect();
        while level.len() > 1 {
            let blend = |pair: &[Vec<S>]| {
                let entries = pair[0].iter().zip(&pair[1]);
                entries.map(|(left, right)| complement.times(left).plus(&s.times(right))).collect()
            };
            level = level.windows(2).map(blend).collect();
        }
        let (weight, coordinates) = level.first()?.split_first()?;
        let inverse = weight.reciprocal()?;
        Some(coordinates.iter().map(|coordinate| coordinate.times(&inverse)).collect())
    }

    /// An x of the closed span at which the piece is not the curve; `None` **proves** that they are equal for
    /// every x of the span.
    ///
    /// At five points, both ends among them, the piece is evaluated by de Casteljau, and the curve by the recursion
    /// and, on [t_k, t_{n+1}], by de Boor (T4.1). Then both are compared at the N + K + 1 points u = 0, 1, …, N + K,
    /// with K = k(k + 1)/2 for an index, and for forms the sum of the degrees of those over the span. In u both are quotients
    /// of polynomials, of degree N and of degree at most K, with denominators that are not 0: so each coordinate of their
    /// difference has a numerator of degree at most N + K, and one with more roots is 0.
    #[must_use]
    pub fn disagreement<W: HasWeights>(&self, curve: &Curve<W>) -> Option<BigRational> {
        let length = &self.to - &self.from;
        let last = self.degree() + curve.basis().quotient_degree(self.span);
        let (weight, coordinates) = self.in_positive_coordinate();
        let by_casteljau = |quarter: usize| {
            let x = &self.from + &length * integer(quarter) / integer(4);
            let side = if quarter == 0 { Side::Right } else { Side::Left };
            let by_de_boor = curve.de_boor(&x, side);
            let by_de_boor = by_de_boor.as_ref().map(|levels| levels.last()?.values().first());
            let point = Some(curve.point(&x, side));
            let agrees = self.point(&x) == point && by_de_boor.is_none_or(|other| other == point.as_ref());
            (!agrees).then_some(x)
        };
        let as_quotients = |u: usize| {
            let u = integer(u);
            let x = &self.from + &length * &u / (&u + integer(1));
            // Cross-multiplied; the weight is not 0.
            let weight = weight.evaluate(&u);
            let point = curve.point(&x, Side::Right);
            let agrees = coordinates.len() == point.len()
                && coordinates.iter().zip(&point).all(|(p, value)| p.evaluate(&u) == value * &weight);
            (!agrees).then_some(x)
        };
        (0..=4).find_map(by_casteljau).or_else(|| (0..=last).find_map(as_quotients))
    }

    /// Σ C(N, m) ω_m u^m, then for each coordinate the same with ω_m b_m: quotients of these are the curve.
    pub(super) fn in_positive_coordinate(&self) -> (Polynomial<BigRational>, Vec<Polynomial<BigRational>>) {
        let degree = self.degree();
        let scaled = |m: usize| &self.weights[m] * binomial(degree, m);
        let polynomial =
            |entry: &dyn Fn(usize) -> BigRational| Polynomial::new(entry(0), (1..=degree).map(entry));
        let coordinate = |c: usize| polynomial(&|m| scaled(m) * &self.points[m][c]);
        (polynomial(&scaled), (0..self.points[0].len()).map(coordinate).collect())
    }
}

/// q with q(u) > 0 for u ≥ 0, and the p_c: the coordinates of the curve on a span are p_c/q in lowest terms.
fn quotients<W: HasWeights>(
    curve: &Curve<W>,
    span: Span,
) -> (Polynomial<BigRational>, Vec<Polynomial<BigRational>>) {
    let (basis, zero) = (curve.basis(), Polynomial::constant(integer(0)));
    let WeightKind::Index(index) = basis.weights().kind() else {
        let coordinates = curve.combine_unchecked(&own_pieces(basis, span));
        let over = over_common_denominator(&coordinates);
        // Without a function on the span the curve is 0 there.
        return over.unwrap_or_else(|| (zero.one(), vec![zero; curve.dimension()]));
    };
    let OneDenominator { mut factors, numerators } = OneDenominator::of(basis, index, span);
    let coordinate = |c: usize| {
        let terms = numerators.iter().map(|(i, p)| p.scaled(&curve.points()[i][c]));
        terms.fold(zero.clone(), |sum, term| sum.plus(&term))
    };
    let linear = |c: &BigRational| Polynomial::new(c.clone(), [integer(1)]);
    let mut coordinates: Vec<_> = (0..curve.dimension()).map(coordinate).collect();
    factors.retain(|c| match divided(&coordinates, &linear(c)) {
        Some(quotients) => {
            coordinates = quotients;
            false
        }
        None => true,
    });
    (factors.iter().fold(zero.one(), |product, c| product.times(&linear(c))), coordinates)
}

/// All the quotients, if the divisor divides all.
fn divided(
    polynomials: &[Polynomial<BigRational>],
    divisor: &Polynomial<BigRational>,
) -> Option<Vec<Polynomial<BigRational>>> {
    let quotient = |p: &Polynomial<BigRational>| {
        let (quotient, remainder) = p.divide(divisor)?;
        remainder.is_zero().then_some(quotient)
    };
    polynomials.iter().map(quotient).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::rational;
    use crate::spline::{Basis, Index, KnotVector};

    fn curve(degree: usize, index: Index) -> Curve {
        let knots = KnotVector::bernstein(degree, &integer(0), &integer(1)).unwrap();
        let basis = Basis::new(knots, degree, index).unwrap();
        Curve::new(basis, (0..=degree).map(|i| vec![integer(i * i), integer(0)]).collect()).unwrap()
    }

    #[test]
    fn a_wrong_piece_is_noticed() {
        let curve = curve(2, "-1".parse().unwrap());
        let right = RationalBezier::pieces(&curve).next().unwrap().unwrap();
        assert_eq!(right.disagreement(&curve), None);
        for m in 0..=2 {
            let mut weights = right.clone();
            weights.weights[m] += rational(1, 1000);
            assert!(weights.disagreement(&curve).is_some(), "weight {m}");
            for c in 0..2 {
                let mut points = right.clone();
                points.points[m][c] -= rational(1, 1000);
                assert!(points.disagreement(&curve).is_some(), "point {m}, coordinate {c}");
            }
        }
        let mut elsewhere = right.clone();
        elsewhere.to = rational(1, 2);
        assert!(elsewhere.disagreement(&curve).is_some());
        let mut flat = right;
        flat.points.iter_mut().for_each(|point| point.truncate(1));
        assert!(flat.disagreement(&curve).is_some());
    }

    /// Equal at the five points of de Casteljau and nowhere else: the comparison of whole functions finds it.
    #[test]
    fn agreement_at_a_few_points_is_not_enough() {
        let knots = KnotVector::bernstein(5, &integer(0), &integer(1)).unwrap();
        let basis = Basis::new(knots, 5, Index::infinity()).unwrap();
        let zero = Curve::new(basis, vec![vec![integer(0)]; 6]).unwrap();
        let mut piece = RationalBezier::pieces(&zero).next().unwrap().unwrap();
        assert_eq!(piece.degree(), 0);
        // s(s − 1/4)(s − 1/2)(s − 3/4)(s − 1) in powers of s, then in Bernstein polynomials.
        let powers = [0, 3, -25, 70, -80, 32].map(|c| rational(c, 32));
        let quintic = |m| (0..=m).map(|l| binomial(m, l) / binomial(5, l) * &powers[l]).sum();
        piece.weights = vec![integer(1); 6];
        piece.points = (0..=5).map(|m| vec![quintic(m)]).collect();
        for quarter in 0..=4 {
            assert_eq!(piece.point(&rational(quarter, 4)), Some(vec![integer(0)]));
        }
        assert!(piece.disagreement(&zero).is_some());
    }
}
