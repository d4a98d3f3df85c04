//! What there is to see on the graph of a function: extrema and jumps.

use std::cmp::Ordering;

use num_rational::BigRational;

use crate::scalar::{RationalAlgebra, RationalFunction, Ring, integer};

use super::algebraic::{Algebraic, Enclosed, STEP};
use super::piece::constant;
use super::roots::IsolatedRoot;
use super::sign::Sign;

/// Maximum or minimum.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum ExtremumKind {
    /// Larger than everywhere close by on both sides.
    Maximum,
    /// Smaller than everywhere close by on both sides.
    Minimum,
}

impl ExtremumKind {
    /// What is at a point, by the function close to it on the left and on the right compared with the value there.
    pub(super) fn of(left: Ordering, right: Ordering) -> Option<Self> {
        match (left, right) {
            (Ordering::Less, Ordering::Less) => Some(Self::Maximum),
            (Ordering::Greater, Ordering::Greater) => Some(Self::Minimum),
            _ => None,
        }
    }
}

/// A function with this sign of its slope, close to the right end of the interval, compared with the limit there.
pub(super) fn before_end(slope: Sign) -> Ordering {
    match slope {
        Sign::Positive => Ordering::Less,
        Sign::Zero => Ordering::Equal,
        Sign::Negative => Ordering::Greater,
    }
}

/// Where a continuous function turns, by the signs of its slope from left to right; a plateau between a rise and a fall is
/// one turn.
pub(super) fn turns(signs: impl IntoIterator<Item = Sign>) -> impl Iterator<Item = ExtremumKind> {
    let mut last = Sign::Zero;
    signs.into_iter().filter(|sign| *sign != Sign::Zero).filter_map(move |sign| {
        ExtremumKind::of(before_end(std::mem::replace(&mut last, sign)), before_end(sign).reverse())
    })
}

/// Where something is.
#[derive(Debug, Clone, PartialEq)]
pub enum Location {
    /// At x exactly: every rational place is found as such.
    Point(BigRational),
    /// At an irrational x between lo and hi, an isolated root in the affine coordinate of its span.
    Irrational {
        /// A lower bound of x.
        lo: BigRational,
        /// An upper bound of x.
        hi: BigRational,
        /// x = t_j + y(t_{j+1} − t_j) for the y of this root.
        root: IsolatedRoot,
    },
    /// On a maximal interval of constancy, [from, to] or [from, to).
    Plateau {
        /// Its first point.
        from: BigRational,
        /// Its upper end.
        to: BigRational,
        /// Does `to` belong to it? Not if the function jumps there.
        closed: bool,
    },
}

impl Location {
    /// (lo, hi) with lo ≤ x ≤ hi; lo = hi for an exact point, the ends of a plateau.
    #[must_use]
    pub fn interval(&self) -> (&BigRational, &BigRational) {
        match self {
            Self::Point(x) => (x, x),
            Self::Irrational { lo, hi, .. } => (lo, hi),
            Self::Plateau { from, to, .. } => (from, to),
        }
    }

    /// The place as a number; of a plateau its first point.
    #[must_use]
    pub fn x(&self) -> Algebraic {
        match self {
            Self::Point(x) | Self::Plateau { from: x, .. } => x.clone().into(),
            Self::Irrational { lo, hi, root } => {
                // x = start + y·length with y = u/(1 + u).
                let (start, length) = span(lo, hi, root);
                let u = RationalFunction::variable(&integer(1));
                let share = u.over(&u.plus(&u.one()));
                let x = share.map(|share| constant(start).plus(&share.times(&constant(length))));
                x.map_or_else(|| unreachable!("1 + u is not 0"), |x| Algebraic::at(x, root.clone()))
            }
        }
    }

    /// Narrows the interval of an irrational place until it is at most `width` > 0 long.
    pub fn refine_to(&mut self, width: &BigRational) {
        let Self::Irrational { lo, hi, root } = self else { return };
        let (start, length) = span(lo, hi, root);
        root.refine_to(&(width / &length));
        (*lo, *hi) = (&start + root.lo() * &length, start + root.hi() * length);
    }
}

/// A local maximum or minimum.
#[derive(Debug, Clone, PartialEq)]
pub struct Extremum {
    /// Which of the two.
    pub kind: ExtremumKind,
    /// Where.
    pub place: Location,
    /// Is it at a knot? A plateau is, since it begins and ends at knots.
    pub at_knot: bool,
    /// (lo, hi) with lo ≤ value ≤ hi, equal if the value is known exactly, as at every rational place.
    pub value: (BigRational, BigRational),
    /// What the value is computed from.
    pub(super) height: Algebraic,
}

impl Extremum {
    /// Narrows the place and the value until both intervals are at most `width` > 0 long. What is exact, and the
    /// ends of a plateau, stay as they are.
    ///
    /// ```
    /// use knotproof::analysis::{Pieces, Shape};
    /// use knotproof::scalar::{integer, rational};
    /// use knotproof::spline::{Basis, KnotVector};
    ///
    /// let knots = KnotVector::new([0, 0, 0, 1, 2, 2, 2].map(integer).to_vec())?;
    /// let basis = Basis::new(knots, 2, "5".parse()?)?;
    /// let mut maximum = Shape::of(&Pieces::of(&basis), 1).extrema()[0].clone();
    /// let width = rational(1, 1 << 50);
    /// maximum.refine_to(&width);
    /// let (lo, hi) = maximum.place.interval();
    /// assert!(hi - lo <= width && &maximum.value.1 - &maximum.value.0 <= width);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn refine_to(&mut self, width: &BigRational) {
        if !matches!(self.place, Location::Irrational { .. }) {
            return;
        }
        self.place.refine_to(width);
        self.value = self.height.bounds_within(width);
    }

    /// Narrows the place and the value by some bits; `false` if they are exact.
    pub fn narrow(&mut self) -> bool {
        let Location::Irrational { lo, hi, .. } = &self.place else { return false };
        let width = (hi - lo) / integer(1 << STEP);
        self.place.refine_to(&width);
        self.height.narrow();
        self.value = self.height.bounds();
        true
    }

    /// The place as a number; of a plateau its first point.
    #[must_use]
    pub fn x(&self) -> Algebraic {
        self.place.x()
    }

    /// The value as a number.
    #[must_use]
    pub fn height(&self) -> Algebraic {
        self.height.clone()
    }
}

/// (start, length) of the span with x = start + y·length in [lo, hi] for the y of a root.
fn span(lo: &BigRational, hi: &BigRational, root: &IsolatedRoot) -> (BigRational, BigRational) {
    let length = (hi - lo) / (root.hi() - root.lo());
    (lo - root.lo() * &length, length)
}

/// Does a function with these extrema and jumps rise or fall all the way from extremum `at` to the next one? So it does between a
/// maximum and a minimum, unless it jumps: their values differ.
///
/// # Panics
/// If there is no next one.
#[must_use]
pub fn turns_back(extrema: &[Extremum], jumps: &[Jump], at: usize) -> bool {
    let [(_, from), (to, _)] = [at, at + 1].map(|at| extrema[at].place.interval());
    let jumps = jumps.iter().any(|jump| from <= &jump.at && &jump.at <= to);
    extrema[at].kind != extrema[at + 1].kind && !jumps
}

/// A discontinuity.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Jump {
    /// The knot.
    pub at: BigRational,
    /// The limit from the left.
    pub left: BigRational,
    /// The limit from the right, which is the value.
    pub right: BigRational,
}
