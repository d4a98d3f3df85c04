//! Questions of a curve that are about one real function of x: a coordinate, or a·c(x) for any vector a.
//!
//! A [`Graph`] is that function, piece by piece, made of the curve's rational Bézier pieces. On each piece it is a quotient P/Q in the
//! positive coordinate u, with Q > 0: `solutions` isolates the roots of P − vQ, `range` those of P′Q − PQ′. What happens at knots is
//! told from the limits on both sides. Nothing is sampled.

use std::cmp::Ordering;

use num_bigint::BigInt;
use num_rational::BigRational;

use crate::scalar::{Polynomial, RationalAlgebra, RationalFunction, Ring, integer};

use super::algebraic::Algebraic;
use super::decision::{SignPattern, signs_of};
use super::extremum::{Extremum, Jump, Location};
use super::integer_polynomial::IntegerPolynomial;
use super::local_knots::SpanQuotient;
use super::profile::{Profile, Segment};
use super::rational_bezier::RationalBezier;
use super::sign::Sign;

/// g(x) = a·c(x) of a curve c on an interval, right-continuous at jumps, and at its end with the limit from the left.
///
/// ```
/// use knotproof::analysis::{Graph, Location, CurvePart, RationalBezier, SolutionKind};
/// use knotproof::scalar::{integer, rational};
/// use knotproof::spline::{Basis, Curve, Index, KnotVector};
///
/// let knots = KnotVector::new([0, 0, 0, 1, 2, 2, 2].map(integer).to_vec())?;
/// let points = [[0, 0], [1, 2], [2, 2], [3, 0]].map(|point| point.map(integer).to_vec()).to_vec();
/// let curve = Curve::new(Basis::new(knots, 2, Index::infinity())?, points)?;
/// let pieces = RationalBezier::pieces_on(&curve, &CurvePart::of(&curve, None, None)?).collect::<Result<Vec<_>, _>>()?;
///
/// // The second coordinate, 4x − 2x² on [0, 1], is 3/2 at x = 1/2, and again at 3/2; it is largest, 2, at x = 1.
/// let height = Graph::of(&pieces, &[integer(0), integer(1)]);
/// let places: Vec<_> = height.solutions(&rational(3, 2)).into_iter().map(|solution| solution.place).collect();
/// assert_eq!(places, [rational(1, 2), rational(3, 2)].map(Location::Point));
/// let highest = height.range().highest;
/// assert_eq!(highest.value.exact(), Some(&integer(2)));
/// assert_eq!(highest.places[0].0, Location::Point(integer(1)));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Graph {
    segments: Vec<Segment>,
}

/// A place where a function takes a value, or has it as a limit, or passes it in a jump.
#[derive(Debug, Clone, PartialEq)]
pub struct Solution {
    /// Where: a point, or a whole interval on which the function is the value.
    pub place: Location,
    /// In which way.
    pub kind: SolutionKind,
    /// The sign of g − v just before; `None` where the interval begins.
    pub before: Option<Sign>,
    /// And just after; `None` where it ends.
    pub after: Option<Sign>,
    /// The piece that the place is a point of.
    piece: usize,
}

/// In which way a function meets a value.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SolutionKind {
    /// It takes it there.
    Taken,
    /// At a jump it is the limit from the left, and the function takes another value there.
    LimitFromLeft,
    /// At a jump it lies between the limit from the left and the value, and is neither.
    Passed,
}

/// The least or the greatest value of a function, and where it has it.
#[derive(Debug, Clone, PartialEq)]
pub struct RangeEnd {
    /// The infimum, or the supremum.
    pub value: Algebraic,
    /// Each place, from left to right; `false` where it is the limit from the left at a jump, and not taken.
    pub places: Vec<(Location, bool)>,
}

/// All values of a function lie between these, and come as close as one likes to both.
#[derive(Debug, Clone, PartialEq)]
pub struct GraphRange {
    /// The infimum.
    pub lowest: RangeEnd,
    /// The supremum.
    pub highest: RangeEnd,
}

impl Graph {
    /// Σ a_c·(coordinate c) of the pieces of a curve, one after the other; coordinates beyond the last a_c count as 0 times.
    #[must_use]
    pub fn of(pieces: &[RationalBezier], normal: &[BigRational]) -> Self {
        let segment = |piece: &RationalBezier| {
            let (weight, coordinates) = piece.in_positive_coordinate();
            let terms = coordinates.iter().zip(normal).map(|(p, a)| p.scaled(a));
            let sum = terms.fold(Polynomial::constant(integer(0)), |sum, term| sum.plus(&term));
            let quotient = RationalFunction::new(&sum, &weight);
            let quotient =
                quotient.map_or_else(|| unreachable!("weights are positive"), |q| SpanQuotient::of(&q));
            let (start, end) = piece.ends();
            Segment { start: start.clone(), end: end.clone(), quotient }
        };
        Self { segments: pieces.iter().map(segment).collect() }
    }

    /// All places where the function is `value`, from left to right, and with them the jumps that pass it. A whole interval on which
    /// it is the value is one place.
    #[must_use]
    pub fn solutions(&self, value: &BigRational) -> Vec<Solution> {
        let patterns: Vec<_> = self.segments.iter().map(|segment| segment.against(value)).collect();
        let mut found = Found { all: Vec::new(), before: None };
        // The limit at the end of the piece before, and its sign close to it.
        let mut left: Option<(Sign, Sign)> = None;
        for (piece, (segment, pattern)) in self.segments.iter().zip(&patterns).enumerate() {
            let (at_start, at_end) = segment.quotient.at_ends();
            let [at_start, at_end] = [at_start, at_end].map(|limit| Sign::of(&(limit - value)));
            let [first, last] = [pattern.between().first(), pattern.between().last()]
                .map(|between| between.map_or(Sign::Zero, |(_, sign)| *sign));
            found.knot(&segment.start, left, Some((at_start, first)), piece);
            if first == Sign::Zero {
                found.throughout(segment, piece);
            }
            for (root, signs) in pattern.roots().iter().zip(pattern.between().windows(2)) {
                let (place, _) = segment.at_root(root.clone());
                let [before, after] = [signs[0].1, signs[1].1].map(Some);
                found.all.push(Solution { place, kind: SolutionKind::Taken, before, after, piece });
            }
            left = Some((at_end, last));
        }
        if let Some(end) = self.segments.last() {
            found.knot(&end.end, left, None, self.segments.len() - 1);
        }
        found.all
    }

    /// The infimum and the supremum, each with all its places.
    ///
    /// Values at irrational places are compared [exactly](Algebraic::compare): a symmetric curve has both of its equal maxima.
    #[must_use]
    pub fn range(&self) -> GraphRange {
        let mut candidates = self.candidates();
        GraphRange {
            lowest: extreme(&mut candidates, Ordering::Less),
            highest: extreme(&mut candidates, Ordering::Greater),
        }
    }

    /// The local maxima and minima, from left to right: larger, or smaller, than everywhere close by; at the ends of the interval only
    /// one side counts. Where the function jumps, its value is the limit from the right. A function that is constant has none.
    #[must_use]
    pub fn extrema(&self) -> Vec<Extremum> {
        Profile::alone(self.segments.iter().cloned()).features().extrema
    }

    /// The discontinuities inside.
    #[must_use]
    pub fn jumps(&self) -> Vec<Jump> {
        let jump = |pair: &[Segment]| {
            let (left, right) = (pair[0].quotient.at_ends().1, pair[1].quotient.at_ends().0);
            (left != right).then(|| Jump { at: pair[1].start.clone(), left, right })
        };
        self.segments.windows(2).filter_map(jump).collect()
    }

    /// How far the function goes up and down in all, ∫ |g′(x)| dx without the jumps: two rational numbers, at most `width` > 0 apart,
    /// between which it lies; equal where all values at which it turns are rational.
    #[must_use]
    pub fn variation(&self, width: &BigRational) -> (BigRational, BigRational) {
        let mut moves: Vec<[Algebraic; 2]> = Vec::new();
        for segment in &self.segments {
            let (value, limit) = segment.quotient.at_ends();
            let pattern = signs_of(IntegerPolynomial::from_integer(&segment.quotient.slope()));
            let mut last = Algebraic::from(value);
            let turns = pattern.changes().map(|(_, root, _)| segment.at_root(root.clone()).1.simplified());
            for next in turns.chain([limit.into()]) {
                moves.push([std::mem::replace(&mut last, next.clone()), next]);
            }
        }
        // Each of so many distances is known to two numbers.
        let share = width / integer(2 * moves.len().max(1));
        moves.into_iter().fold((integer(0), integer(0)), |(lo, hi), [mut a, mut b]| {
            let ((a_lo, a_hi), (b_lo, b_hi)) = (a.bounds_within(&share), b.bounds_within(&share));
            let (up, down) = (&b_lo - &a_hi, &a_lo - &b_hi);
            let least = up.max(down).max(integer(0));
            let most = (b_hi - a_lo).max(a_hi - b_lo);
            (lo + least, hi + most)
        })
    }

    /// The value of this function at a solution for another one on the same pieces; `None` on an interval, and in a jump that
    /// passes the value.
    #[must_use]
    pub fn at(&self, solution: &Solution) -> Option<Algebraic> {
        let segment = self.segments.get(solution.piece)?;
        match (&solution.place, solution.kind) {
            (Location::Plateau { .. }, _) | (_, SolutionKind::Passed) => None,
            (Location::Point(x), _) => Some(segment.value(x).into()),
            (Location::Irrational { root, .. }, _) => {
                Some(Algebraic::at(segment.quotient.piece(), root.clone()).simplified())
            }
        }
    }

    /// Whatever can be the least or the greatest value: limits at the ends of pieces and values where the slope changes its sign.
    fn candidates(&self) -> Vec<Candidate> {
        let mut all: Vec<Candidate> = Vec::new();
        // Is what the piece before ends with a place already?
        let mut plateau: Option<BigRational> = None;
        for (at, segment) in self.segments.iter().enumerate() {
            let (value, limit) = segment.quotient.at_ends();
            let pattern = signs_of(IntegerPolynomial::from_integer(&segment.quotient.slope()));
            let next = self.segments.get(at + 1).map(|next| next.quotient.at_ends().0);
            let closed = next.as_ref().is_none_or(|next| *next == limit);
            if pattern.between().first().is_none_or(|(_, sign)| *sign == Sign::Zero) {
                let to = segment.end.clone();
                match all.last_mut() {
                    // It goes on.
                    Some((_, (Location::Plateau { to: end, closed: own, .. }, _)))
                        if plateau.as_ref() == Some(&value) =>
                    {
                        (*end, *own) = (to, closed);
                    }
                    _ => {
                        let place = Location::Plateau { from: segment.start.clone(), to, closed };
                        all.push((value.into(), (place, true)));
                    }
                }
                plateau = closed.then_some(limit);
                continue;
            }
            if plateau.take().is_none_or(|before| before != value) {
                all.push((value.into(), (Location::Point(segment.start.clone()), true)));
            }
            for (_, root, _) in pattern.changes() {
                let (place, height) = segment.at_root(root.clone());
                all.push((height.simplified(), (place, true)));
            }
            if next.is_none() || !closed {
                all.push((limit.into(), (Location::Point(segment.end.clone()), closed)));
            }
        }
        all
    }
}

/// A value with its place, and whether it is taken there.
type Candidate = (Algebraic, (Location, bool));

/// The least or the greatest of the candidates, and of all that are equal to it the places.
fn extreme(candidates: &mut [Candidate], side: Ordering) -> RangeEnd {
    let mut best: Option<RangeEnd> = None;
    for (value, place) in candidates.iter_mut() {
        let order = best.as_mut().and_then(|best| value.compare(&mut best.value));
        match &mut best {
            Some(best) if order == Some(Ordering::Equal) => {
                best.places.push(place.clone());
                // Of equal numbers the one that is known exactly is better to have.
                if value.exact().is_some() {
                    best.value = value.clone();
                }
            }
            Some(_) if order != Some(side) => {}
            best => *best = Some(RangeEnd { value: value.clone(), places: vec![place.clone()] }),
        }
    }
    best.unwrap_or_else(|| RangeEnd { value: integer(0).into(), places: Vec::new() })
}

/// The solutions so far.
struct Found {
    all: Vec<Solution>,
    /// The sign just before an interval on which the function is the value, which is not over yet.
    before: Option<Option<Sign>>,
}

impl Found {
    /// At a knot, or an end: the sign of the limit from each side, and that close to it.
    fn knot(
        &mut self,
        at: &BigRational,
        left: Option<(Sign, Sign)>,
        right: Option<(Sign, Sign)>,
        piece: usize,
    ) {
        let (close_before, close_after) = (left.map(|(_, sign)| sign), right.map(|(_, sign)| sign));
        // An interval goes on, or ends: what is at its end is a part of it.
        let ends = self.before.is_some();
        let goes_on = close_after == Some(Sign::Zero);
        if ends {
            let closed = right.is_none_or(|(limit, _)| limit == Sign::Zero);
            if let (Some(Solution { place: Location::Plateau { closed: own, .. }, after, .. }), false) =
                (self.all.last_mut(), goes_on)
            {
                *own = closed;
                *after = if closed { close_after } else { right.map(|(limit, _)| limit) };
            }
            if !goes_on {
                self.before = None;
            }
            return;
        }
        if goes_on {
            let limit = left.map(|(limit, close)| if limit == Sign::Zero { close } else { limit });
            self.before = Some(limit);
            return;
        }
        let place = Location::Point(at.clone());
        let [at_left, at_right] = [left, right].map(|side| side.map(|(limit, _)| limit));
        // At a jump it is the other limit that the function is close to.
        let from = |limit: Option<Sign>, close| if limit == Some(Sign::Zero) { close } else { limit };
        let (kind, piece) = match (at_left, at_right) {
            (_, Some(Sign::Zero)) => (SolutionKind::Taken, piece),
            (Some(Sign::Zero), None) => (SolutionKind::Taken, piece),
            (Some(Sign::Zero), Some(_)) => (SolutionKind::LimitFromLeft, piece.saturating_sub(1)),
            (Some(before), Some(after)) if before != after => (SolutionKind::Passed, piece),
            _ => return,
        };
        let (before, after) = (from(at_left, close_before), from(at_right, close_after));
        self.all.push(Solution { place, kind, before, after, piece });
    }

    /// On the whole piece it is the value.
    fn throughout(&mut self, segment: &Segment, piece: usize) {
        if let Some(Solution { place: Location::Plateau { to, .. }, .. }) = self.all.last_mut()
            && *to == segment.start
        {
            to.clone_from(&segment.end);
            return;
        }
        let place = Location::Plateau { from: segment.start.clone(), to: segment.end.clone(), closed: true };
        let before = self.before.flatten();
        self.all.push(Solution { place, kind: SolutionKind::Taken, before, after: None, piece });
    }
}

impl Segment {
    /// The signs of P − vQ, which are those of the function less v.
    fn against(&self, value: &BigRational) -> SignPattern {
        let (p, q) = (&self.quotient.numerator, &self.quotient.denominator);
        let scaled = |p: &Polynomial<BigInt>, factor: &BigInt| p.scaled(factor);
        signs_of(IntegerPolynomial::from_integer(&scaled(p, value.denom()).minus(&scaled(q, value.numer()))))
    }

    /// The value at x of the closed span: at its end the limit.
    fn value(&self, x: &BigRational) -> BigRational {
        let (at_start, at_end) = self.quotient.at_ends();
        let (p, q) = (&self.quotient.numerator, &self.quotient.denominator);
        match (x - &self.start).over(&(&self.end - x)) {
            None => at_end,
            Some(u) if u.is_zero() => at_start,
            Some(u) => {
                let at =
                    |p: &Polynomial<BigInt>| p.map(|c| BigRational::from_integer(c.clone())).evaluate(&u);
                at(p).over(&at(q)).unwrap_or(at_end)
            }
        }
    }
}
