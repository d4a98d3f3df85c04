//! Two equal largest maxima: an interval of indices in which they exist, by the intermediate value theorem.

use std::cmp::Ordering;

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::ToPrimitive;

use crate::scalar::{Polynomial, RationalFunction, Ring, height, integer, rationals_between, spend};
use crate::spline::Basis;

use super::decision::always_positive;
use super::extremum::{Extremum, ExtremumKind};
use super::local_knots::{LocalKnots, is_continuous};
use super::monotonicity::Monotonicity;
use super::shape::Shape;

/// A proof that for some r in an open interval (r₀, r₁), 0 < r₀ < r₁ ≤ 1, a function takes its largest value at two points.
///
/// Let c be a point of its support, and let L(r) and R(r) be its largest values up to c and from c on; both are
/// continuous in r. At one end of the interval L > R and at the other L < R, so L(r) = R(r) for some r between. This is then
/// the largest value, and it is not taken at c: there is a point d with G(c) < G(d) for all r of the interval. So it is
/// taken on both sides of c. Everything is exact: L and R are compared at both ends by their maxima in isolating intervals,
/// and G(d) − G(c) is a polynomial in r over a positive one, whose sign on the interval is decided for all r.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Crossing {
    gaps: Vec<u64>,
    /// (p, q) for r₀ and r₁.
    ends: [(u64, u64); 2],
    /// c and d, with t_i = 0.
    points: [BigRational; 2],
    /// The side that is higher at r₀.
    higher: Flank,
    /// Values between L and R at r₀ and at r₁.
    between: [BigRational; 2],
}

/// Left or right of c.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Flank {
    /// x < c.
    Left,
    /// x > c.
    Right,
}

impl Flank {
    fn other(self) -> Self {
        match self {
            Self::Left => Self::Right,
            Self::Right => Self::Left,
        }
    }
}

/// The two highest maxima of a function.
struct Lead {
    higher: Flank,
    /// Where the left one ends and the right one begins.
    gap: (BigRational, BigRational),
    /// The place of the minimum between them.
    valley: BigRational,
    /// The place of the higher one.
    peak: BigRational,
}

/// How often intervals are narrowed by 8 bits to tell two values apart; values that agree further count as not told apart,
/// which may lose a finding and never makes one.
const LOOKS: usize = 12;
/// The most steps in search of the index at which the other maximum is higher.
const STEPS: usize = 48;
/// The finest step, as a power of 2 by which r changes.
const FINEST: u32 = 12;
/// The most steps that the ends may be further out for the sake of simpler numbers.
const ROOM: usize = 4;
/// The most bisections between two indices.
const BISECTIONS: usize = 16;

impl Crossing {
    /// Looks for one near a function with at least two local maxima, by its gaps and r = p/q: r moves to where the lower of its two highest
    /// maxima gains (mass goes left as r grows) for as long as there are two.
    #[must_use]
    pub fn near(gaps: &[u64], ratio: (u64, u64)) -> Option<Self> {
        let start = lead(gaps, ratio)?;
        let (mut near, mut bits) = (ratio, 2);
        let mut far = None;
        for _ in 0..STEPS {
            let next = stepped(near, start.higher, bits)?;
            match has_several_maxima(gaps, next).then(|| lead(gaps, next)).flatten() {
                Some(lead) if lead.higher == start.higher => near = next,
                Some(_) => {
                    far = Some(next);
                    break;
                }
                None if bits == FINEST => return None,
                None => bits += 1,
            }
        }
        let mut inner = [near, far?];
        // Further out on both sides, for as long as the leads stay: room for simpler indices.
        let other = start.higher.other();
        let outer = [
            further(gaps, ratio, (other, start.higher), bits),
            further(gaps, inner[1], (start.higher, other), bits),
        ];
        for round in 0..BISECTIONS {
            let middle = between(inner[0], inner[1])?;
            let lead = lead(gaps, middle)?;
            // Both ends have moved inwards, so there are simple indices outside of them.
            let room = (0..2).all(|end| inner[end] != outer[end]) || round >= BISECTIONS / 2;
            if let Some(found) = room.then(|| Self::with_points(gaps, sorted(inner), &lead)).flatten() {
                return Some(found.with_simple_ends(sorted(outer)));
            }
            let end = usize::from(lead.higher != start.higher);
            inner[end] = middle;
        }
        None
    }

    /// With the simplest points c and d that do, of a few.
    fn with_points(gaps: &[u64], ends: [(u64, u64); 2], lead: &Lead) -> Option<Self> {
        let simple = rationals_between(&lead.gap.0, &lead.gap.1).take(4);
        let valleys: Vec<_> = simple.chain([lead.valley.clone()]).collect();
        valleys.into_iter().find_map(|c| Self::new(gaps, ends, [c, lead.peak.clone()]))
    }

    /// Checks everything that the proof asks for.
    ///
    /// `None` if something does not hold, or values could not be told apart.
    #[must_use]
    pub fn new(gaps: &[u64], ends: [(u64, u64); 2], points: [BigRational; 2]) -> Option<Self> {
        let [low, high] = ends.map(|(p, q)| BigRational::new(p.into(), q.into()));
        if low >= high || high > integer(1) {
            return None;
        }
        let [(higher, first), (at_high, second)] =
            [sides(gaps, ends[0], &points[0])?, sides(gaps, ends[1], &points[0])?];
        let valid = higher != at_high && is_lower_throughout(gaps, [&low, &high], &points)?;
        valid.then(|| Self { gaps: gaps.to_vec(), ends, points, higher, between: [first, second] })
    }

    /// The same with simpler r₀ and r₁, at most as far out as the given ones: these themselves, or what is simplest between
    /// them and the ends that there are.
    fn with_simple_ends(mut self, outer: [(u64, u64); 2]) -> Self {
        for end in 0..2 {
            let mut limit = alpha(outer[end]);
            let inner = alpha(self.ends[end]);
            for _ in 0..6 {
                let (low, high) = if limit < inner { (&limit, &inner) } else { (&inner, &limit) };
                let Some(simple) = rationals_between(low, high).next() else { break };
                let mut choices = [limit, simple.clone()];
                choices.sort_by_key(height);
                let found = choices.iter().find_map(|choice| {
                    let mut ends = self.ends;
                    ends[end] = Self::ratio(choice)?;
                    Self::new(&self.gaps, ends, self.points.clone())
                });
                if let Some(found) = found {
                    self = found;
                    break;
                }
                limit = simple;
            }
        }
        self
    }

    /// The gaps between the knots of the function.
    #[must_use]
    pub fn gaps(&self) -> &[u64] {
        &self.gaps
    }

    /// (p, q) for r₀ < r₁.
    #[must_use]
    pub fn ends(&self) -> [(u64, u64); 2] {
        self.ends
    }

    /// A simple ratio between r₀ and r₁.
    #[must_use]
    pub fn middle(&self) -> (u64, u64) {
        between(self.ends[0], self.ends[1]).unwrap_or(self.ends[1])
    }

    /// α₁ < α₀ for r₁ > r₀: the interval of indices, from below.
    #[must_use]
    pub fn indices(&self) -> [BigRational; 2] {
        [alpha(self.ends[1]), alpha(self.ends[0])]
    }

    /// (p, q) for an α < 0; `None` if they are too large.
    pub(crate) fn ratio(alpha: &BigRational) -> Option<(u64, u64)> {
        let (a, b) = ((-alpha.numer()).to_u64()?, alpha.denom().to_u64()?);
        Some((a, a.checked_add(b)?))
    }

    /// c and d.
    #[must_use]
    pub fn points(&self) -> &[BigRational; 2] {
        &self.points
    }

    /// The side of c that is higher at the indices, and a value between the largest values on both sides.
    #[must_use]
    pub fn at_ends(&self) -> [(Flank, &BigRational); 2] {
        [(self.higher.other(), &self.between[1]), (self.higher, &self.between[0])]
    }
}

/// A [`Crossing`] of a basis function, on the function's own knots and for its own indices.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Tie {
    /// Two indices between which, for some index, the largest value is taken at two points.
    pub indices: [BigRational; 2],
    /// c: for every index between, the function is smaller there than at d.
    pub lower: BigRational,
    /// d.
    pub higher: BigRational,
    /// For each of the two indices the side of c on which the function is the larger, and a value that it exceeds there only.
    pub at_ends: [(Flank, BigRational); 2],
}

impl Tie {
    /// Looks for one near the index of a basis, as [`Crossing::near`] does, for G_i^k or, where r > 1, its mirror image.
    ///
    /// # Panics
    /// If i > n.
    #[must_use]
    pub fn near(basis: &Basis, i: usize) -> Option<Self> {
        let knots = LocalKnots::of(basis, i)?;
        let mut gaps: Vec<_> = knots.gaps().iter().map(ToPrimitive::to_u64).collect::<Option<_>>()?;
        let (p, q) = (knots.ratio().0.to_u64()?, knots.ratio().1.to_u64()?);
        let mirrored = p > q;
        if mirrored {
            gaps.reverse();
        }
        let crossing = Crossing::near(&gaps, (p.min(q), p.max(q)))?;
        let (start, end) = basis.support(i);
        let unit = (end - start) / BigRational::from_integer(gaps.iter().sum::<u64>().into());
        let place = |x: &BigRational| if mirrored { end - x * &unit } else { start + x * &unit };
        let [lower, higher] = crossing.points().each_ref().map(place);
        let at_ends = crossing.at_ends().map(|(side, value)| (side, value.clone()));
        let tie = Self { indices: crossing.indices(), lower, higher, at_ends };
        Some(if mirrored { tie.mirrored() } else { tie })
    }

    /// With 1 − α for α, which turns the interval round, and the sides exchanged.
    fn mirrored(self) -> Self {
        let ([from, to], [first, second]) = (self.indices, self.at_ends);
        let side = |(side, value): (Flank, BigRational)| (side.other(), value);
        Self {
            indices: [to, from].map(|alpha| integer(1) - alpha),
            at_ends: [side(second), side(first)],
            ..self
        }
    }
}

/// α = r/(r − 1) for r < 1.
fn alpha((p, q): (u64, u64)) -> BigRational {
    BigRational::new(p.into(), BigInt::from(p) - q)
}

fn sorted(ends: [(u64, u64); 2]) -> [(u64, u64); 2] {
    let [(a, b), (c, d)] = ends;
    if u128::from(a) * u128::from(d) <= u128::from(c) * u128::from(b) { ends } else { [ends[1], ends[0]] }
}

/// Some steps on, as if `towards` were higher, for as long as there are two maxima and `lead_of` leads.
fn further(gaps: &[u64], mut ratio: (u64, u64), (towards, lead_of): (Flank, Flank), bits: u32) -> (u64, u64) {
    for _ in 0..ROOM {
        match stepped(ratio, towards, bits) {
            Some(next) if lead(gaps, next).is_some_and(|lead| lead.higher == lead_of) => ratio = next,
            _ => break,
        }
    }
    ratio
}

/// r·(1 − 2^−bits) to give the right side more, r/(1 − 2^−bits) to give the left one more, to 20 bits; `None` at r ≥ 1.
fn stepped((p, q): (u64, u64), higher: Flank, bits: u32) -> Option<(u64, u64)> {
    let factor = ((1_u128 << bits) - 1, 1_u128 << bits);
    let (up, down) = if higher == Flank::Left { factor } else { (factor.1, factor.0) };
    // 2^36 is more than enough for any r that a search meets; r is kept above 2^-36.
    let scaled = ((u128::from(p) * up) << 36) / (u128::from(q) * down);
    let spare = (128 - scaled.leading_zeros()).saturating_sub(20);
    let rounded = u64::try_from((scaled >> spare) << spare).ok()?;
    reduced(rounded, 1 << 36)
}

/// A ratio between two: the simplest one of the middle third.
fn between(one: (u64, u64), other: (u64, u64)) -> Option<(u64, u64)> {
    let [low, high] = sorted([one, other]).map(|(p, q)| BigRational::new(p.into(), q.into()));
    let third = (&high - &low) / integer(3);
    let middle = rationals_between(&(&low + &third), &(&high - &third)).next()?;
    reduced(middle.numer().to_u64()?, middle.denom().to_u64()?)
}

/// In lowest terms, if it lies in (0, 1).
fn reduced(p: u64, q: u64) -> Option<(u64, u64)> {
    let common = p.gcd(&q);
    (0 < p && p < q).then(|| (p / common, q / common))
}

/// The continuous function with these gaps.
fn function(gaps: &[u64], (p, q): (u64, u64)) -> Option<LocalKnots<BigInt>> {
    let integral = gaps.iter().map(|&gap| gap.into()).collect();
    LocalKnots::new(integral, (p.into(), q.into())).ok().filter(|_| is_continuous(gaps))
}

fn has_several_maxima(gaps: &[u64], ratio: (u64, u64)) -> bool {
    spend();
    let maxima = function(gaps, ratio).and_then(|function| Monotonicity::of(&function).local_maxima());
    maxima.is_some_and(|maxima| maxima > 1)
}

/// The two highest maxima and what lies between; `None` if there are no two, or two could not be told apart.
fn lead(gaps: &[u64], ratio: (u64, u64)) -> Option<Lead> {
    let mut turns = Shape::of_local(&function(gaps, ratio)?).into_extrema();
    let maxima: Vec<usize> = (0..turns.len()).filter(|&at| turns[at].kind == ExtremumKind::Maximum).collect();
    let (mut first, mut second) = (*maxima.first()?, None);
    for &next in &maxima[1..] {
        if compare(&mut turns, next, first)? == Ordering::Greater {
            (first, second) = (next, Some(first));
        } else {
            second = match second {
                Some(second) if compare(&mut turns, next, second)? == Ordering::Less => Some(second),
                _ => Some(next),
            };
        }
    }
    let second = second?;
    let (left, right) = (first.min(second), first.max(second));
    let middle = |turn: &Extremum| {
        let (lo, hi) = turn.place.interval();
        if lo == hi { Some(lo.clone()) } else { rationals_between(lo, hi).next() }
    };
    Some(Lead {
        higher: if first == left { Flank::Left } else { Flank::Right },
        gap: (turns[left].place.interval().1.clone(), turns[right].place.interval().0.clone()),
        valley: middle(&turns[left + 1])?,
        peak: middle(&turns[first])?,
    })
}

/// Compares the values of two turns; `None` if they could not be told apart.
fn compare(turns: &mut [Extremum], one: usize, other: usize) -> Option<Ordering> {
    for _ in 0..LOOKS {
        let ((lo, hi), (low, high)) = (&turns[one].value, &turns[other].value);
        if hi < low {
            return Some(Ordering::Less);
        }
        if high < lo {
            return Some(Ordering::Greater);
        }
        turns[one].narrow();
        turns[other].narrow();
    }
    None
}

/// Which of L and R is the larger, for the point c, and a simple value between them.
///
/// Both sides must have a maximum, and none may be at c: if then the highest one on a side is higher than all of the other
/// side, it is the largest value of its side, and larger than the value at c and so than all values of the other side.
fn sides(gaps: &[u64], ratio: (u64, u64), c: &BigRational) -> Option<(Flank, BigRational)> {
    let mut turns = Shape::of_local(&function(gaps, ratio)?).into_extrema();
    turns.retain(|turn| turn.kind == ExtremumKind::Maximum);
    let mut on_left = 0;
    for turn in &mut turns {
        let mut looks = 0;
        on_left += loop {
            let (lo, hi) = turn.place.interval();
            if hi < c {
                break 1;
            }
            if c < lo {
                break 0;
            }
            if looks == LOOKS || !turn.narrow() {
                return None;
            }
            looks += 1;
        };
    }
    if on_left == 0 || on_left == turns.len() {
        return None;
    }
    for _ in 0..LOOKS {
        let (left, right) = turns.split_at(on_left);
        let largest = |side: &[Extremum]| {
            let lo = side.iter().map(|turn| &turn.value.0).max()?;
            Some((lo.clone(), side.iter().map(|turn| &turn.value.1).max()?.clone()))
        };
        let ((l_lo, l_hi), (r_lo, r_hi)) = (largest(left)?, largest(right)?);
        if l_lo > r_hi {
            return Some((Flank::Left, rationals_between(&r_hi, &l_lo).next()?));
        }
        if r_lo > l_hi {
            return Some((Flank::Right, rationals_between(&l_hi, &r_lo).next()?));
        }
        for turn in &mut turns {
            turn.narrow();
        }
    }
    None
}

/// G(c) < G(d) for all r in (r₀, r₁)? With r = (r₀ + r₁v)/(1 + v), v in (0, ∞), a sign of polynomials in v. `None` if a
/// point is outside of the support.
fn is_lower_throughout(
    gaps: &[u64],
    [low, high]: [&BigRational; 2],
    [c, d]: &[BigRational; 2],
) -> Option<bool> {
    let one = integer(1);
    let constant = |value: BigRational| Polynomial::constant(value);
    let ratio = (Polynomial::new(low.clone(), [high.clone()]), Polynomial::new(one.clone(), [one]));
    let symbolic = gaps.iter().map(|&gap| constant(BigRational::from_integer(gap.into()))).collect();
    let knots = LocalKnots::new(symbolic, ratio).ok()?;
    let at = |x: &BigRational| {
        let mut start = integer(0);
        for (s, &gap) in gaps.iter().enumerate() {
            let end = &start + BigRational::from_integer(gap.into());
            if start <= *x && *x < end {
                let u = constant((x - &start) / (end - x));
                let quotient = knots.on_span(s)?;
                return Some((quotient.numerator.evaluate(&u), quotient.denominator.evaluate(&u)));
            }
            start = end;
        }
        None
    };
    let ((p_c, q_c), (p_d, q_d)) = (at(c)?, at(d)?);
    let difference = p_d.times(&q_c).minus(&p_c.times(&q_d));
    Some(always_positive(&RationalFunction::from_polynomial(difference)).holds())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::rational;
    use crate::spline::KnotVector;

    /// The two maxima of gaps 0, 5, 2, 1 are equal for some α between −53/47 and −12/13.
    #[test]
    fn a_crossing_is_found_and_checked() {
        let crossing = Crossing::near(&[0, 5, 2, 1], (1, 2)).unwrap();
        let [low, high] = crossing.indices();
        assert!(rational(-2, 1) < low && low < high && high < rational(-1, 2), "{low} {high}");
        let new = |ends, points: [BigRational; 2]| Crossing::new(&[0, 5, 2, 1], ends, points);
        let (ends, [c, d]) = (crossing.ends(), crossing.points().clone());
        assert_eq!(new(ends, [c.clone(), d.clone()]).as_ref(), Some(&crossing));
        // Each of these would prove nothing.
        assert_eq!(new([ends[1], ends[0]], [c.clone(), d.clone()]), None);
        assert_eq!(new([ends[0], ends[0]], [c.clone(), d.clone()]), None);
        assert_eq!(new(ends, [d.clone(), c.clone()]), None);
        assert_eq!(new(ends, [c.clone(), rational(1, 1000)]), None);
        assert_eq!(new(ends, [rational(1, 1000), d.clone()]), None);
        assert_eq!(new(ends, [c, rational(8, 1)]), None);
        let sides = crossing.at_ends().map(|(side, _)| side);
        assert_ne!(sides[0], sides[1]);
    }

    /// The same function and its mirror image, on knots of another length that begin elsewhere.
    #[test]
    fn a_tie_is_a_crossing_on_the_functions_own_knots() {
        let tie = |knots: [usize; 7], alpha: &str, i| {
            let knots =
                KnotVector::new(knots.map(|t| integer(t) / integer(4) + integer(1)).to_vec()).unwrap();
            Tie::near(&Basis::new(knots, 3, alpha.parse().unwrap()).unwrap(), i).unwrap()
        };
        let (one, other) = (tie([0, 0, 5, 7, 8, 8, 8], "-1", 0), tie([0, 0, 0, 1, 3, 8, 8], "2", 2));
        assert_eq!(
            other.indices.each_ref().map(|alpha| integer(1) - alpha),
            [&one.indices[1], &one.indices[0]].map(Clone::clone)
        );
        assert_eq!(
            (integer(4) - &other.lower, integer(4) - &other.higher),
            (one.lower.clone(), one.higher.clone())
        );
        assert_eq!(other.at_ends[0], (one.at_ends[1].0.other(), one.at_ends[1].1.clone()));
        assert_eq!(other.mirrored().indices, one.indices);
    }

    #[test]
    fn one_maximum_has_no_crossing() {
        assert_eq!(Crossing::near(&[1, 1, 1, 1], (1, 2)), None);
    }
}
