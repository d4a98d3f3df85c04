//! Integrals and lengths of a curve, each between two rational numbers as close as one likes.
//!
//! On a piece both are ∫ P√W/Q over τ in [−1, 1], P, Q and W polynomials, Q > 0 and W ≥ 0: with W = 1 the integral of a coordinate P/Q,
//! with P = 1 and Q = q² the length of c = p/q, where W = Σ (p_c′q − p_c q′)². Two ways lead to bounds, and an interval
//! that neither settles is halved.
//!
//! **A series.** On a disc of radius R = 4 around 0, Σ_{i≥1} |q_i|Rⁱ ≤ q₀/2 and likewise for W. Then |Q| ≥ q₀/2 and |W| ≤ 3w₀/2 there, the
//! integrand is analytic with |f| ≤ M = Σ |p_i|Rⁱ · √(3w₀/2) · 2/q₀, and by Cauchy |f_i| ≤ M/Rⁱ for its coefficients. So the integral is
//! Σ_{i<n, even} 2f_i/(i + 1) with an error of at most 2M R⁻ⁿ/((1 − 1/R)(n + 1)). The f_i are computed in integers over 2^bits, with a
//! bound for every rounding.
//!
//! **Chord and polygon**, for lengths: a piece is not shorter than the distance of its ends, and, its weights being positive, not longer
//! than its control polygon, since de Casteljau's algorithm cuts corners. Close to a cusp, where W has a root, this settles it.
//!
//! In one dimension the length is the variation, from the values where the slope changes its sign.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed};

use crate::scalar::{Polynomial, Ring, integer, over_one_denominator, spend};
use crate::spline::Point;

use super::graph::Graph;
use super::homogeneous::Homogeneous;
use super::rational_bezier::RationalBezier;
use super::surd::root;

/// R.
const RADIUS: usize = 4;
/// Bits of square roots, beyond those that the width asks for.
const GUARD: u64 = 32;

/// The integrals ∫ c(x) dx of the coordinates of a curve, given as its pieces: for each coordinate two rational numbers, at most `width` > 0
/// apart, between which it lies. Where all weights of a piece are 1, it is a polynomial, and its part is exact: the mean of its
/// control points, times its length. So the bounds are equal where all pieces are.
///
/// ```
/// use knotproof::analysis::{RationalBezier, integrals};
/// use knotproof::scalar::{integer, rational};
/// use knotproof::spline::{Basis, Curve, Index, KnotVector};
///
/// // w = u/(2 + u), that is x/(2 − x), on [0, 1]: the integral is 2·ln 2 − 1.
/// let basis = Basis::new(KnotVector::bernstein(1, &integer(0), &integer(1))?, 1, "-1".parse::<Index>()?)?;
/// let curve = Curve::new(basis, vec![vec![integer(0)], vec![integer(1)]])?;
/// let pieces = RationalBezier::pieces(&curve).collect::<Result<Vec<_>, _>>()?;
/// let (lo, hi) = integrals(&pieces, &rational(1, 1 << 40)).remove(0);
/// assert!(lo < rational(38629436112, 100000000000) && rational(38629436111, 100000000000) < hi);
/// assert!(hi - lo <= rational(1, 1 << 40));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[must_use]
pub fn integrals(pieces: &[RationalBezier], width: &BigRational) -> Vec<(BigRational, BigRational)> {
    let dimension = pieces.first().map_or(0, |piece| piece.points()[0].len());
    let share = width / integer(2 * pieces.len().max(1));
    let coordinate = |c: usize| {
        let of_piece = |piece: &RationalBezier| {
            let (from, to) = piece.ends();
            let length = to - from;
            if piece.weights().iter().all(One::is_one) {
                let sum: BigRational = piece.points().iter().map(|point| &point[c]).sum();
                let exact = sum * length / integer(piece.points().len());
                return (exact.clone(), exact);
            }
            let (weight, coordinates) = piece.in_positive_coordinate();
            let (parts, _) =
                over_one_denominator(&[coordinates[c].coefficients(), weight.coefficients()].concat());
            let (p, q) = parts.split_at(coordinates[c].degree() + 1);
            let [numerator, denominator] = [p, q].map(|p| centred(p, piece.degree()));
            // x = (a + b)/2 + τ(b − a)/2.
            let factor = length / integer(2);
            enclosed(Integrand { numerator, denominator, radicand: None, factor }, None, &share)
        };
        rounded(pieces.iter().map(of_piece).fold((integer(0), integer(0)), add), width)
    };
    (0..dimension).map(coordinate).collect()
}

/// The length of a curve, given as its pieces: two rational numbers, at most `width` > 0 apart, between which it lies. Jumps add nothing.
///
/// The bounds are equal where the curve is a chain of straight lines that does not turn back on one of them, and all of their lengths are
/// rational.
///
/// ```
/// use knotproof::analysis::{RationalBezier, length};
/// use knotproof::scalar::{integer, rational};
/// use knotproof::spline::{Basis, Curve, Index, KnotVector};
///
/// // A polygon: 5 + 1.
/// let knots = KnotVector::new([0, 0, 1, 2, 2].map(integer).to_vec())?;
/// let points = [[0, 0], [3, 4], [3, 5]].map(|point| point.map(integer).to_vec()).to_vec();
/// let curve = Curve::new(Basis::new(knots, 1, "5".parse::<Index>()?)?, points)?;
/// let pieces = RationalBezier::pieces(&curve).collect::<Result<Vec<_>, _>>()?;
/// assert_eq!(length(&pieces, &rational(1, 1000)), (integer(6), integer(6)));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[must_use]
pub fn length(pieces: &[RationalBezier], width: &BigRational) -> (BigRational, BigRational) {
    if pieces.first().is_some_and(|piece| piece.points()[0].len() == 1) {
        return rounded(Graph::of(pieces, &[integer(1)]).variation(&(width / integer(2))), width);
    }
    let share = width / integer(2 * pieces.len().max(1));
    let of_piece = |piece: &RationalBezier| {
        let homogeneous = piece.homogeneous();
        // Of a straight line both are the length.
        let drawn = chord_and_polygon(&homogeneous, &share);
        if &drawn.1 - &drawn.0 <= share {
            return drawn;
        }
        let (weight, coordinates) = piece.in_positive_coordinate();
        let all: Vec<_> = coordinates.iter().chain([&weight]).collect();
        let (parts, _) =
            over_one_denominator(&all.iter().flat_map(|p| p.coefficients()).cloned().collect::<Vec<_>>());
        // A common factor of p and q changes nothing.
        let (mut parts, mut polynomials) = (&parts[..], Vec::with_capacity(all.len()));
        for p in &all {
            let (own, others) = parts.split_at(p.degree() + 1);
            polynomials.push(centred(own, piece.degree()));
            parts = others;
        }
        let Some(q) = polynomials.pop() else { unreachable!("the weight is one of them") };
        let square = |p: &Polynomial<BigInt>| {
            let slope = p.derivative().times(&q).minus(&p.times(&q.derivative()));
            slope.times(&slope)
        };
        let radicand = polynomials.iter().map(square).reduce(|sum, square| sum.plus(&square));
        let integrand =
            Integrand { numerator: Ring::one(&q), denominator: q.times(&q), radicand, factor: integer(1) };
        enclosed(integrand, Some(homogeneous), &share)
    };
    rounded(pieces.iter().map(of_piece).fold((integer(0), integer(0)), add), width)
}

fn add(a: (BigRational, BigRational), b: (BigRational, BigRational)) -> (BigRational, BigRational) {
    (a.0 + b.0, a.1 + b.1)
}

/// Bounds with few digits, a quarter of the width further out at most; what is exact stays.
fn rounded((lo, hi): (BigRational, BigRational), width: &BigRational) -> (BigRational, BigRational) {
    if lo == hi {
        return (lo, hi);
    }
    // 2^−bits ≤ width/4.
    let bits = (integer(4) / width).ceil().numer().bits();
    let unit = BigRational::from_integer(BigInt::from(1) << bits);
    ((lo * &unit).floor() / &unit, (hi * &unit).ceil() / unit)
}

/// Σ p_m s^m (1 − s)^(N−m) in τ = 2s − 1, up to the factor 2^N: the polynomial Σ p_m u^m, u = s/(1 − s), times (1 − s)^N.
fn centred(p: &[BigInt], degree: usize) -> Polynomial<BigInt> {
    let [rise, fall] = [1, -1].map(|slope| Polynomial::new(BigInt::from(1), [BigInt::from(slope)]));
    let zero = Polynomial::constant(BigInt::ZERO);
    p.iter()
        .enumerate()
        .fold(zero, |sum, (m, c)| sum.plus(&rise.power(m).times(&fall.power(degree - m)).scaled(c)))
}

/// factor·P√W/Q on [−1, 1].
struct Integrand {
    numerator: Polynomial<BigInt>,
    denominator: Polynomial<BigInt>,
    radicand: Option<Polynomial<BigInt>>,
    factor: BigRational,
}

/// A part of [−1, 1] that is still to be looked at.
struct Task {
    integrand: Integrand,
    /// The part of the piece, if it is its length.
    piece: Option<Homogeneous>,
    width: BigRational,
}

/// Bounds of the integral over [−1, 1], at most `width` apart; with the piece of which it is the length, if it is one.
fn enclosed(
    integrand: Integrand,
    piece: Option<Homogeneous>,
    width: &BigRational,
) -> (BigRational, BigRational) {
    let mut sum = (integer(0), integer(0));
    let mut left = vec![Task { integrand, piece, width: width.clone() }];
    while let Some(Task { integrand, piece, width }) = left.pop() {
        spend();
        let settled = match series(&integrand, &width) {
            Series::Bounds(bounds) => Some(bounds),
            // A cusp is near, or the piece is straight.
            Series::RootNear => piece.as_ref().map(|piece| chord_and_polygon(piece, &width)),
            Series::PoleNear => None,
        };
        match settled.filter(|(lo, hi)| hi - lo <= width) {
            Some(bounds) => sum = add(sum, bounds),
            None => {
                let pieces = piece.map_or([None, None], |piece| piece.halves().map(Some));
                let half = width / integer(2);
                for (integrand, piece) in halves(&integrand).into_iter().zip(pieces) {
                    left.push(Task { integrand, piece, width: half.clone() });
                }
            }
        }
    }
    sum
}

/// The distance of the ends, and the length of the control polygon.
fn chord_and_polygon(piece: &Homogeneous, width: &BigRational) -> (BigRational, BigRational) {
    let bits = GUARD + (integer(piece.net.len()) / width).ceil().numer().bits();
    let points: Vec<Point> =
        piece.net.iter().map(|control| control[1..].iter().map(|c| c / &control[0]).collect()).collect();
    let distance = |a: &Point, b: &Point| {
        let square = a.iter().zip(b).map(|(a, b)| (a - b) * (a - b)).sum::<BigRational>();
        // Relative to a distance that may be large.
        root(&square, bits + square.ceil().numer().bits())
    };
    let chord = distance(&points[0], &points[points.len() - 1]).0;
    let sides = points.windows(2).map(|pair| distance(&pair[0], &pair[1]).1);
    (chord, sides.sum())
}

/// The left and the right half, each on [−1, 1] again: τ = (σ ∓ 1)/2.
fn halves(integrand: &Integrand) -> [Integrand; 2] {
    // 2^n p((σ + sign)/2): the shift by 1 of 2^n p(sign·σ/2), turned back.
    let part = |p: &Polynomial<BigInt>, n: usize, sign: i32| {
        let sign = BigInt::from(sign);
        let mut scaled = p.coefficients().iter().enumerate().map(|(i, c)| c << (n - i));
        let scaled = Polynomial::new(scaled.next().unwrap_or_default(), scaled);
        scaled.scaled_argument(&sign).shifted_by_one().scaled_argument(&sign)
    };
    let Integrand { numerator: p, denominator: q, radicand: w, factor } = integrand;
    // An even power of 2 for what stands under the root.
    let root = w.as_ref().map_or(0, |w| w.degree().div_ceil(2));
    let two = |n: usize| integer(2).power(n);
    let factor = factor * two(q.degree()) / (two(p.degree() + root + 1));
    [-1, 1].map(|sign| Integrand {
        numerator: part(p, p.degree(), sign),
        denominator: part(q, q.degree(), sign),
        radicand: w.as_ref().map(|w| part(w, 2 * root, sign)),
        factor: factor.clone(),
    })
}

/// What the series comes to.
enum Series {
    /// Bounds of the integral.
    Bounds((BigRational, BigRational)),
    /// The disc is too large for √W.
    RootNear,
    /// It is too large for 1/Q.
    PoleNear,
}

/// Bounds by the series, at most `width` apart, where the disc is not too large for it.
fn series(integrand: &Integrand, width: &BigRational) -> Series {
    let (p, q) = (integrand.numerator.coefficients(), integrand.denominator.coefficients());
    if Ring::is_zero(&integrand.numerator) {
        return Series::Bounds((integer(0), integer(0)));
    }
    let one = [BigInt::from(1)];
    let w = integrand.radicand.as_ref().map_or(&one[..], |w| w.coefficients());
    let on_disc = |c: &[BigInt]| c.iter().rev().fold(BigInt::ZERO, |sum, c| sum * RADIUS + c.abs());
    // Σ_{i≥1} |c_i|Rⁱ ≤ c₀/2.
    let is_steady = |c: &[BigInt]| c[0].is_positive() && on_disc(c) * 2 <= &c[0] * 3;
    if !is_steady(q) {
        return Series::PoleNear;
    }
    if !is_steady(w) {
        return Series::RootNear;
    }
    let [q_0, w_0] = [&q[0], &w[0]].map(|c| BigRational::from_integer(c.clone()));
    let unit = &integrand.factor / q_0;
    let most = root(&(&w_0 * integer(3) / integer(2)), GUARD).1;
    let largest = integer(on_disc(p)) * most * &unit * integer(2);
    // 8·2M·R⁻ⁿ/(1 − 1/R) ≤ width, with R = 2²; the error is this divided by 8, and by n + 1.
    let ratio = &largest * integer(16 * RADIUS) / (width * integer(RADIUS - 1));
    // More terms than a machine can count would not fit into its memory either.
    let terms = usize::try_from(ratio.ceil().numer().bits().div_ceil(2)).unwrap_or(usize::MAX).max(1);
    let error = width / integer(8);
    // The series of P/Σ|p_i|, √(W/w₀) and q₀/Q have coefficients of about 1 at most, and what is left is this factor.
    let scale: BigInt = p.iter().map(Signed::abs).sum();
    let unit = unit * integer(scale.clone());
    let mut bits = GUARD + (&largest / width).ceil().numer().bits();
    loop {
        let (least, most) = root(&w_0, bits);
        let sum = Balls { bits }.sum([p, q, w], &scale, terms);
        let (lo, hi) = sum.bounds(bits);
        // √w₀ is between two numbers ≥ 0: a bound below 0 is least for the larger one.
        let lo = if lo.is_negative() { lo * &most } else { lo * &least } * &unit - &error;
        let hi = if hi.is_negative() { hi * &least } else { hi * &most } * &unit + &error;
        if &hi - &lo <= *width {
            return Series::Bounds((lo, hi));
        }
        bits += GUARD;
    }
}

/// A number x with |x·2^bits − middle| ≤ error.
#[derive(Clone)]
struct Ball {
    middle: BigInt,
    error: BigInt,
}

impl Ball {
    fn bounds(&self, bits: u64) -> (BigRational, BigRational) {
        let unit = BigInt::from(1) << bits;
        let end = |number: BigInt| BigRational::new(number, unit.clone());
        (end(&self.middle - &self.error), end(&self.middle + &self.error))
    }
}

/// Arithmetic with balls of one precision: every shift rounds down, by less than 1.
struct Balls {
    bits: u64,
}

impl Balls {
    fn of(&self, numerator: &BigInt, denominator: &BigInt) -> Ball {
        Ball { middle: (numerator << self.bits) / denominator, error: BigInt::from(1) }
    }

    /// Σ a_i b_{n−i} over these i.
    fn convolution(&self, a: &[Ball], b: &[Ball], n: usize, from: usize, to: usize) -> Ball {
        let (mut middle, mut error) = (BigInt::ZERO, BigInt::ZERO);
        for i in from.max((n + 1).saturating_sub(b.len()))..to.min(a.len()) {
            let (x, y) = (&a[i], &b[n - i]);
            middle += &x.middle * &y.middle;
            error += x.middle.abs() * &y.error + (y.middle.abs() + &y.error) * &x.error;
        }
        Ball { middle: middle >> self.bits, error: (error >> self.bits) + 2 }
    }

    /// Σ 2f_i/(i + 1) over even i < n, f = (P/scale)·√(W/w₀)·(q₀/Q).
    fn sum(&self, [p, q, w]: [&[BigInt]; 3], scale: &BigInt, n: usize) -> Ball {
        let over = |c: &[BigInt], divisor: &BigInt| {
            c.iter().take(n).map(|c| self.of(c, divisor)).collect::<Vec<_>>()
        };
        let (p, q, w) = (over(p, scale), over(q, &q[0]), over(w, &w[0]));
        let one = || Ball { middle: BigInt::from(1) << self.bits, error: BigInt::ZERO };
        let coefficient = |of: &[Ball], i: usize| {
            of.get(i).cloned().unwrap_or(Ball { middle: BigInt::ZERO, error: BigInt::ZERO })
        };
        // g² = w: 2g_i = w_i − Σ_{0<j<i} g_j g_{i−j}.
        let mut g = vec![one()];
        // qh = 1: h_i = −Σ_{0<j≤i} q_j h_{i−j}.
        let mut h = vec![one()];
        for i in 1..n {
            let (square, target) = (self.convolution(&g, &g, i, 1, i), coefficient(&w, i));
            let middle: BigInt = target.middle - square.middle;
            g.push(Ball { middle: middle >> 1, error: ((target.error + square.error) >> 1) + 2 });
            let known = self.convolution(&q, &h, i, 1, i + 1);
            h.push(Ball { middle: -known.middle, error: known.error });
        }
        let product =
            |a: &[Ball], b: &[Ball]| (0..n).map(|i| self.convolution(a, b, i, 0, i + 1)).collect::<Vec<_>>();
        let f = product(&p, &product(&g, &h));
        let (mut middle, mut error) = (BigInt::ZERO, BigInt::ZERO);
        for (i, f) in f.into_iter().enumerate().step_by(2) {
            middle += f.middle * 2 / (i + 1);
            error += f.error * 2 / (i + 1) + 2;
        }
        Ball { middle, error }
    }
}
