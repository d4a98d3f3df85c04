//! A function of one variable span by span: the stations where it turns or jumps, and the runs between them.

use std::cmp::Ordering;

use num_bigint::BigInt;
use num_rational::BigRational;

use crate::scalar::integer;

use super::algebraic::{Algebraic, Enclosed};
use super::contenders::{Contender, Role};
use super::decision::signs_of;
use super::extremum::{Extremum, ExtremumKind, Jump, Location, before_end};
use super::integer_polynomial::IntegerPolynomial;
use super::local_knots::SpanQuotient;
use super::roots::IsolatedRoot;
use super::sign::Sign;

/// What a profile shows.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Features {
    pub(super) extrema: Vec<Extremum>,
    pub(super) jumps: Vec<Jump>,
    pub(super) contenders: Vec<Contender>,
}

/// A function on one span.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Segment {
    pub(super) start: BigRational,
    pub(super) end: BigRational,
    pub(super) quotient: SpanQuotient<BigInt>,
}

/// A knot or a critical point, with the function close by compared with the value there: `Less` where it is
/// smaller, `Equal` where it is constant.
struct Station {
    place: Location,
    at_knot: bool,
    height: Algebraic,
    /// The limit from the left, where it is not the value.
    left_limit: Option<BigRational>,
    left: Ordering,
    right: Ordering,
}

/// Knots and critical points from left to right, and the runs between them: one fewer.
pub(super) struct Profile {
    stations: Vec<Station>,
    /// The signs of the slope.
    runs: Vec<Sign>,
}

impl Profile {
    /// `inside`: does the support end before t_m?
    pub(super) fn of(segments: impl Iterator<Item = Segment>, inside: bool) -> Self {
        let mut profile = Self { stations: Vec::new(), runs: Vec::new() };
        // Outside the function is 0.
        let mut limit = integer(0);
        let mut before = Sign::Zero;
        let mut end = None;
        for segment in segments {
            let pattern = signs_of(IntegerPolynomial::from_integer(&segment.quotient.slope()));
            let first = pattern.between().first().map_or(Sign::Zero, |(_, sign)| *sign);
            let (value, limit_at_end) = segment.quotient.at_ends();
            profile.knot(segment.start.clone(), (limit, before), (value, first));
            profile.runs.push(first);
            before = first;
            for (slope_before, root, slope_after) in pattern.changes() {
                profile.stations.push(segment.station(root.clone(), slope_before, slope_after));
                profile.runs.push(slope_after);
                before = slope_after;
            }
            limit = limit_at_end;
            end = Some(segment.end);
        }
        match end {
            None => {}
            Some(end) if inside => profile.knot(end, (limit, before), (integer(0), Sign::Zero)),
            // At t_m the value is the limit from the left, and 0 begins after it.
            Some(end) => profile.stations.push(Station {
                place: Location::Point(end),
                at_knot: true,
                left: before_end(before),
                right: integer(0).cmp(&limit),
                left_limit: None,
                height: limit.into(),
            }),
        }
        profile
    }

    /// Of a function that is nowhere else: at both ends only one side counts, and a plateau there is one if the function leaves it.
    pub(super) fn alone(segments: impl Iterator<Item = Segment>) -> Self {
        let mut profile = Self::of(segments, false);
        let Some(last) = profile.stations.len().checked_sub(1) else { return profile };
        profile.stations[0].left_limit = None;
        profile.stations[0].left = Ordering::Equal;
        profile.stations[last].right = Ordering::Equal;
        let first = match profile.runs.first() {
            Some(Sign::Zero) => profile.plateau_end(0).2,
            _ => profile.stations[0].right,
        };
        let mut start = last;
        while start > 0
            && profile.runs[start - 1] == Sign::Zero
            && profile.stations[start].left == Ordering::Equal
        {
            start -= 1;
        }
        profile.stations[last].right = profile.stations[start].left;
        profile.stations[0].left = first;
        profile
    }

    fn knot(&mut self, at: BigRational, left: (BigRational, Sign), right: (BigRational, Sign)) {
        let (limit, before) = left;
        let (value, after) = right;
        self.stations.push(Station {
            place: Location::Point(at),
            at_knot: true,
            left: limit.cmp(&value).then(before_end(before)),
            right: before_end(after).reverse(),
            left_limit: (limit != value).then_some(limit),
            height: value.into(),
        });
    }

    /// Its extrema and jumps, and what its supremum is to be found among.
    pub(super) fn features(self) -> Features {
        let mut features = Features { extrema: Vec::new(), jumps: Vec::new(), contenders: Vec::new() };
        for (position, station) in self.stations.iter().enumerate() {
            if let (Some(left), Some(right)) = (&station.left_limit, station.height.exact()) {
                let (left, right) = (left.clone(), right.clone());
                let (at, _) = station.place.interval();
                if left > right {
                    features.contenders.push(Contender { height: left.clone().into(), role: Role::Limit });
                }
                features.jumps.push(Jump { at: at.clone(), left, right });
            }
            if let Some(kind) = ExtremumKind::of(station.left, station.right) {
                features.extremum(kind, station.place.clone(), station, Role::Point);
            }
            // A plateau begins here, unless it has begun before.
            if self.runs.get(position) == Some(&Sign::Zero) && station.left != Ordering::Equal {
                let (end, closed, right) = self.plateau_end(position);
                let bounds = |station: &Station| station.place.interval().0.clone();
                let place = Location::Plateau { from: bounds(station), to: bounds(end), closed };
                if let Some(kind) = ExtremumKind::of(station.left, right) {
                    features.extremum(kind, place, station, Role::Plateau);
                }
            }
        }
        features
    }

    /// Where a plateau that begins at a station ends, whether that point belongs to it, and how the function
    /// compares with it on the right.
    fn plateau_end(&self, start: usize) -> (&Station, bool, Ordering) {
        let mut end = start;
        loop {
            let Some(station) = self.stations.get(end + 1) else {
                return (&self.stations[end], true, self.stations[end].right);
            };
            end += 1;
            if station.left != Ordering::Equal {
                // A jump: from there on the function is close to the value after it.
                return (station, false, station.left.reverse());
            }
            if self.runs.get(end) != Some(&Sign::Zero) {
                return (station, true, station.right);
            }
        }
    }
}

impl Features {
    fn extremum(&mut self, kind: ExtremumKind, place: Location, station: &Station, role: Role) {
        let mut height = station.height.clone();
        let value = height.bounds();
        if kind == ExtremumKind::Maximum {
            self.contenders.push(Contender { height: station.height.clone(), role });
        }
        self.extrema.push(Extremum { kind, place, at_knot: station.at_knot, value, height });
    }
}

impl Segment {
    fn station(&self, root: IsolatedRoot, before: Sign, after: Sign) -> Station {
        let (place, height) = self.at_root(root);
        let (left, right) = (before_end(before), before_end(after).reverse());
        Station { place, at_knot: false, height, left_limit: None, left, right }
    }

    /// Where a root in the positive coordinate is, rational if it can be, and the value there.
    pub(super) fn at_root(&self, mut root: IsolatedRoot) -> (Location, Algebraic) {
        // Narrow enough to be read; the search for a rational root may go further, on a copy.
        root.refine_to(&BigRational::new(1.into(), BigInt::from(1_u32 << 20)));
        let x = |y: &BigRational| &self.start + y * (&self.end - &self.start);
        let piece = self.quotient.piece();
        match root.clone().rational() {
            Some(u) => {
                let y = &u / (&u + integer(1));
                (Location::Point(x(&y)), Algebraic::from(finite(piece.evaluate(&u))))
            }
            None => (
                Location::Irrational { lo: x(root.lo()), hi: x(root.hi()), root: root.clone() },
                Algebraic::at(piece, root),
            ),
        }
    }
}

/// Every weight lies in [0, 1], and so does every basis function (P2.1.1, T3.5.2, T3.5.3); a curve is a sum of those.
fn finite(value: Option<BigRational>) -> BigRational {
    match value {
        Some(value) => value,
        None => unreachable!("neither basis functions nor curves have a pole on a closed span"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::Piece;
    use crate::analysis::contenders::attained_once;
    use crate::scalar::{RationalAlgebra, Ring, rational};

    /// Functions that no basis has, to reach every rule.
    #[test]
    fn profiles_by_hand() {
        let u: Piece = Piece::variable(&rational(1, 1));
        let y = u.over(&u.plus(&u.one())).unwrap();
        let segment = |start: usize, piece: &Piece| Segment {
            start: integer(start),
            end: integer(start + 1),
            quotient: SpanQuotient::of(piece),
        };
        let (up, down, flat) = (y.clone(), y.one().minus(&y), y.one());
        let bump = y.times(&down).scaled(4);
        let shape = |pieces: &[&Piece], inside| {
            let segments = pieces.iter().enumerate().map(|(start, piece)| segment(start, piece));
            Profile::of(segments, inside).features()
        };
        let summary = |features: &Features| {
            let kinds = features.extrema.iter().map(|e| (e.kind == ExtremumKind::Maximum, e.place.clone()));
            (kinds.collect::<Vec<_>>(), attained_once(features.contenders.clone()))
        };
        let point = |x| Location::Point(integer(x));
        let half = |x: i64| Location::Point(rational(2 * x + 1, 2));
        let plateau = |from, to, closed| Location::Plateau { from: integer(from), to: integer(to), closed };
        // Two hats: two maxima of the same height, a minimum between.
        let hats = shape(&[&up, &down, &up, &down], true);
        assert_eq!(
            summary(&hats),
            (vec![(true, point(1)), (false, point(2)), (true, point(3))], Some(false))
        );
        // A rise, a plateau over two spans, a fall.
        let table = shape(&[&up, &flat, &flat, &down], true);
        assert_eq!(summary(&table), (vec![(true, plateau(1, 3, true))], Some(false)));
        // A plateau from which the function jumps down, falls on: attained, on a half-open interval.
        let step = shape(&[&up, &flat, &down.scaled_by(1, 2)], true);
        assert_eq!(summary(&step), (vec![(true, plateau(1, 2, false))], Some(false)));
        // A plateau in a valley, and one on a slope.
        let valley = shape(&[&flat.plus(&down), &flat, &flat.plus(&up)], false);
        assert_eq!(
            summary(&valley),
            (vec![(true, point(0)), (false, plateau(1, 2, true)), (true, point(3))], Some(false))
        );
        let slope = shape(&[&up, &flat, &flat.plus(&up)], false);
        assert_eq!(summary(&slope), (vec![(true, point(3))], Some(true)));
        // A bump below a limit that is not attained; a bump of the same height as it.
        let below = shape(&[&bump.scaled_by(1, 2), &up], true);
        assert_eq!(summary(&below), (vec![(true, half(0)), (false, point(1))], Some(false)));
        let level = shape(&[&bump, &up], true);
        assert_eq!(summary(&level), (vec![(true, half(0)), (false, point(1))], Some(true)));
        // Jumps up: into a fall, into a rise, onto a plateau.
        assert_eq!(summary(&shape(&[&down], true)), (vec![(true, point(0))], Some(true)));
        assert_eq!(summary(&shape(&[&up.plus(&flat)], true)), (vec![], Some(false)));
        assert_eq!(summary(&shape(&[&flat, &down], true)), (vec![(true, plateau(0, 1, true))], Some(false)));
    }

    trait Scaled {
        fn scaled_by(&self, numerator: i64, denominator: i64) -> Self;
        fn scaled(&self, factor: i64) -> Self;
    }

    impl Scaled for Piece {
        fn scaled_by(&self, numerator: i64, denominator: i64) -> Self {
            self.times(&self.embed(&rational(numerator, denominator)))
        }
        fn scaled(&self, factor: i64) -> Self {
            self.scaled_by(factor, 1)
        }
    }
}
