//! Where a candidate turns: its local maxima and minima, exactly, with values.

use std::rc::Rc;

use num_bigint::BigInt;
use num_rational::BigRational;

use crate::analysis::{ExtremumKind, IsolatedRoot, Sign, SpanQuotient, sign_pattern};
use crate::scalar::{Polynomial, Ring, integer};

use super::candidate::Candidate;
use super::decide::over_rationals;

/// A local maximum or minimum of a candidate, on its own knots with t_i = 0.
#[derive(Debug, Clone)]
pub(super) struct Turn {
    pub(super) kind: ExtremumKind,
    at: At,
}

#[derive(Debug, Clone)]
enum At {
    /// At a knot, or on a plateau from one knot to another.
    Knots { from: BigRational, to: BigRational, value: BigRational },
    /// Inside a span, at a root of the slope.
    Inside { start: BigRational, gap: BigRational, quotient: Rc<SpanQuotient<BigInt>>, root: IsolatedRoot },
}

/// Wide enough to be read, narrow enough to tell places apart: in units of the span.
const WIDTH: u32 = 1 << 20;

/// The turns from left to right; each place is exact where it is rational.
pub(super) fn turns(candidate: &Candidate) -> Vec<Turn> {
    let knots = candidate.local_knots();
    let own = candidate.own_knots();
    let number = |x: u64| BigRational::from_integer(x.into());
    let mut turns = Vec::new();
    // The last run that is not constant, and where it ended.
    let mut last = Sign::Zero;
    let mut since = integer(0);
    for (s, quotient) in knots.spans().filter_map(|s| Some((s, knots.on_span(s)?))) {
        let (start, end) = (number(own[s]), number(own[s + 1]));
        let pattern = sign_pattern(&over_rationals(&quotient.slope()));
        let quotient = Rc::new(quotient);
        let mut runs = pattern.between().iter().map(|(_, sign)| *sign);
        let first = runs.next().unwrap_or(Sign::Zero);
        if let Some(kind) = turn(last, first) {
            let value = at(&quotient, &integer(0));
            turns.push(Turn { kind, at: At::Knots { from: since.clone(), to: start.clone(), value } });
        }
        last = if first == Sign::Zero { last } else { first };
        for (before, root, after) in pattern.changes() {
            if let Some(kind) = turn(before, after) {
                let mut root = root.clone();
                root.refine_to(&BigRational::new(1.into(), WIDTH.into()));
                // The search for a rational root may narrow the interval much further, on a copy.
                let mut exact = root.clone();
                if exact.rational().is_some() {
                    root = exact;
                }
                let (start, gap) = (start.clone(), &end - &start);
                turns
                    .push(Turn { kind, at: At::Inside { start, gap, quotient: Rc::clone(&quotient), root } });
            }
            last = after;
        }
        if first != Sign::Zero {
            since = end;
        }
    }
    turns
}

fn turn(before: Sign, after: Sign) -> Option<ExtremumKind> {
    match (before, after) {
        (Sign::Positive, Sign::Negative) => Some(ExtremumKind::Maximum),
        (Sign::Negative, Sign::Positive) => Some(ExtremumKind::Minimum),
        _ => None,
    }
}

/// P(u)/Q(u).
fn at(quotient: &SpanQuotient<BigInt>, u: &BigRational) -> BigRational {
    value(&quotient.numerator, u) / value(&quotient.denominator, u)
}

/// p(u), with one reduction at the end.
fn value(p: &Polynomial<BigInt>, u: &BigRational) -> BigRational {
    let (mut sum, mut power) = (BigInt::from(0), BigInt::from(1));
    for c in p.coefficients().iter().rev() {
        sum = sum * u.numer() + c * &power;
        power *= u.denom();
    }
    BigRational::new(sum, u.denom().power(p.degree()))
}

impl Turn {
    /// (lo, hi) with lo ≤ x ≤ hi, equal if the place is known exactly.
    pub(super) fn interval(&self) -> (BigRational, BigRational) {
        match &self.at {
            At::Knots { from, to, .. } => (from.clone(), to.clone()),
            At::Inside { start, gap, root, .. } => (start + root.lo() * gap, start + root.hi() * gap),
        }
    }

    /// Is it at a knot?
    pub(super) fn at_knot(&self) -> bool {
        matches!(self.at, At::Knots { .. })
    }

    /// Is it known exactly, with its value?
    pub(super) fn is_exact(&self) -> bool {
        match &self.at {
            At::Knots { .. } => true,
            At::Inside { root, .. } => root.exact().is_some(),
        }
    }

    /// (lo, hi) with lo ≤ value ≤ hi, equal at an exact place: numerator and denominator rise with u, since no
    /// coefficient of either is negative.
    pub(super) fn value(&self) -> (BigRational, BigRational) {
        match &self.at {
            At::Knots { value, .. } => (value.clone(), value.clone()),
            At::Inside { quotient, root, .. } => {
                let (lo, hi) = root.interval();
                let (p, q) = (&quotient.numerator, &quotient.denominator);
                (value(p, &lo) / value(q, &hi), value(p, &hi) / value(q, &lo))
            }
        }
    }

    /// Narrows the interval of x, and so that of the value, by 8 bits.
    pub(super) fn refine(&mut self) {
        if let At::Inside { root, .. } = &mut self.at {
            let width = (root.hi() - root.lo()) / BigInt::from(256);
            root.refine_to(&width);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::{Pieces, Shape};
    use crate::spline::{Basis, KnotVector};

    /// Kinds, places and values as by [`Shape`], whose arithmetic is another one.
    #[test]
    fn the_turns_are_the_extrema_of_the_shape() {
        for (gaps, ratio) in [
            (&[2, 1, 1, 0][..], (3, 5)),
            (&[0, 1, 1, 2], (5, 3)),
            (&[0, 5, 2, 1], (53, 100)),
            (&[1, 1, 1], (1, 1)),
            (&[1, 2], (1, 3)),
            (&[799, 51, 15552, 72, 2425, 9185], (46, 251)),
        ] {
            let candidate = Candidate::new(gaps.to_vec(), ratio).unwrap();
            let full = candidate.full_knots();
            let knots = KnotVector::new(full.rational()).unwrap();
            let basis = Basis::new(knots, candidate.degree(), candidate.index()).unwrap();
            let shape = Shape::of(&Pieces::of(&basis), full.index);
            let turns = turns(&candidate);
            assert_eq!(turns.len(), shape.extrema().len());
            for (turn, extremum) in turns.iter().zip(shape.extrema()) {
                let (lo, hi) = turn.interval();
                assert_eq!((turn.kind, (&lo, &hi)), (extremum.kind, extremum.place.interval()));
                assert_eq!(turn.at_knot(), extremum.at_knot);
                // Two enclosures of one number meet.
                let (low, high) = turn.value();
                assert!(low <= extremum.value.1 && extremum.value.0 <= high);
                let mut turn = turn.clone();
                (0..3).for_each(|_| turn.refine());
                let (low, high) = turn.value();
                assert!(high - low < BigRational::new(1.into(), 1000.into()));
            }
        }
    }
}
