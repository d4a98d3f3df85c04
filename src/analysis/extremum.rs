//! What there is to see on the graph of a function: extrema and jumps.

use num_rational::BigRational;

use super::roots::IsolatedRoot;

/// Maximum or minimum.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum ExtremumKind {
    /// Larger than everywhere close by on both sides.
    Maximum,
    /// Smaller than everywhere close by on both sides.
    Minimum,
}

/// Where something is.
#[derive(Debug, Clone, PartialEq)]
pub enum Place {
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

impl Place {
    /// (lo, hi) with lo ≤ x ≤ hi; lo = hi for an exact point, the ends of a plateau.
    #[must_use]
    pub fn interval(&self) -> (&BigRational, &BigRational) {
        match self {
            Self::Point(x) => (x, x),
            Self::Irrational { lo, hi, .. } => (lo, hi),
            Self::Plateau { from, to, .. } => (from, to),
        }
    }
}

/// A local maximum or minimum.
#[derive(Debug, Clone, PartialEq)]
pub struct Extremum {
    /// Which of the two.
    pub kind: ExtremumKind,
    /// Where.
    pub place: Place,
    /// Is it at a knot? A plateau is, since it begins and ends at knots.
    pub at_knot: bool,
    /// (lo, hi) with lo ≤ value ≤ hi, equal if the value is known exactly, as at every rational place.
    pub value: (BigRational, BigRational),
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
