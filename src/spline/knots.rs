//! Knot vectors and their spans.

use std::fmt;

use num_rational::BigRational;
use thiserror::Error;

/// The side from which a limit is taken. Everything here is right-continuous (D3.3), so a value at x is the
/// limit from the right; at t_m it is the limit from the left on either side, as the paper has it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Side {
    /// The limit from below.
    Left,
    /// The limit from above, which is the value.
    Right,
}

impl fmt::Display for Side {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Left => "left",
            Self::Right => "right",
        })
    }
}

/// A non-empty interval [t_j, t_{j+1}) of a knot vector, by its index j.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Span {
    index: usize,
}

impl Span {
    /// The span of index j where the knots are not numbers, and its being non-empty is known otherwise.
    pub(crate) fn assumed(index: usize) -> Self {
        Self { index }
    }

    /// j.
    #[must_use]
    pub fn index(self) -> usize {
        self.index
    }
}

/// A knot vector U = (t_0 ≤ t_1 ≤ … ≤ t_m) with t_0 < t_m; any multiplicity (D3.1).
///
/// ```
/// use knotproof::scalar::integer;
/// use knotproof::spline::KnotVector;
///
/// let knots = KnotVector::new([0, 0, 0, 1, 2, 3, 3, 3].map(integer).to_vec())?;
/// assert!(knots.is_open(2) && knots.is_symmetric());
/// assert_eq!(knots.multiplicity(&integer(3)), 3);
/// assert_eq!(knots.spans().map(|span| span.index()).collect::<Vec<_>>(), [2, 3, 4]);
/// # Ok::<(), knotproof::spline::KnotError>(())
/// ```
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct KnotVector {
    knots: Vec<BigRational>,
}

/// Why a list of numbers is not a knot vector.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum KnotError {
    /// Fewer than two knots.
    #[error("a knot vector has at least two knots, and here {} (D3.1)", if *.0 == 0 { "is none" } else { "is one" })]
    TooShort(usize),
    /// t_{i−1} > t_i.
    #[error("knots must not decrease (D3.1), but knot {position} is {value}, after {previous}")]
    Decreasing {
        /// i, from 0.
        position: usize,
        /// t_{i−1}.
        previous: BigRational,
        /// t_i.
        value: BigRational,
    },
    /// t_0 = t_m.
    #[error(
        "all {count} knots are equal to {value}: there is no interval between them (D3.2 asks for a < b)"
    )]
    AllEqual {
        /// m + 1.
        count: usize,
        /// t_0.
        value: BigRational,
    },
}

impl KnotVector {
    /// Checks the order of the knots, and changes nothing.
    ///
    /// # Errors
    /// [`KnotError`], with the position of the first offence.
    pub fn new(knots: Vec<BigRational>) -> Result<Self, KnotError> {
        let (Some(first), Some(last)) = (knots.first(), knots.last()) else {
            return Err(KnotError::TooShort(0));
        };
        if knots.len() == 1 {
            return Err(KnotError::TooShort(1));
        }
        if let Some(i) = knots.windows(2).position(|pair| pair[0] > pair[1]) {
            let (previous, value) = (knots[i].clone(), knots[i + 1].clone());
            return Err(KnotError::Decreasing { position: i + 1, previous, value });
        }
        if first == last {
            return Err(KnotError::AllEqual { count: knots.len(), value: first.clone() });
        }
        Ok(Self { knots })
    }

    /// The knot vector of the Bernstein case of P3.3: a and b, k + 1 times each.
    ///
    /// # Errors
    /// [`KnotError`] unless a < b.
    pub fn bernstein(degree: usize, a: &BigRational, b: &BigRational) -> Result<Self, KnotError> {
        let times = |value: &BigRational| std::iter::repeat_n(value.clone(), degree + 1);
        Self::new(times(a).chain(times(b)).collect())
    }

    /// t_0, …, t_m.
    #[must_use]
    pub fn knots(&self) -> &[BigRational] {
        &self.knots
    }

    /// t_i.
    ///
    /// # Panics
    /// If i > m.
    #[must_use]
    pub fn t(&self, i: usize) -> &BigRational {
        &self.knots[i]
    }

    /// m, the index of the last knot.
    #[must_use]
    pub fn m(&self) -> usize {
        self.knots.len() - 1
    }

    /// t_0.
    #[must_use]
    pub fn first(&self) -> &BigRational {
        self.t(0)
    }

    /// t_m.
    #[must_use]
    pub fn last(&self) -> &BigRational {
        self.t(self.m())
    }

    /// The non-empty spans [t_j, t_{j+1}), from left to right: there is at least one.
    pub fn spans(&self) -> impl DoubleEndedIterator<Item = Span> + '_ {
        (0..self.m()).filter(|&j| self.knots[j] < self.knots[j + 1]).map(|index| Span { index })
    }

    /// (t_j, t_{j+1}).
    #[must_use]
    pub fn ends(&self, span: Span) -> (&BigRational, &BigRational) {
        (self.t(span.index), self.t(span.index + 1))
    }

    /// The span in which the limit at x from the given side is taken; `None` where all functions are 0
    /// there. At t_m both sides give the last span.
    #[must_use]
    pub fn span_at(&self, x: &BigRational, side: Side) -> Option<Span> {
        let from_left = side == Side::Left || x == self.last();
        // The number of knots below the limit; j is the last of them.
        let below = self.knots.partition_point(|t| if from_left { t < x } else { t <= x });
        (1..=self.m()).contains(&below).then(|| Span { index: below - 1 })
    }

    /// How often the value x occurs among the knots (D3.2).
    #[must_use]
    pub fn multiplicity(&self, x: &BigRational) -> usize {
        self.knots.partition_point(|t| t <= x) - self.knots.partition_point(|t| t < x)
    }

    /// The stop knots u_0 < … < u_r with their multiplicities, which add up to m + 1 (D3.2).
    pub fn stop_knots(&self) -> impl Iterator<Item = (&BigRational, usize)> {
        self.knots.chunk_by(|s, t| s == t).map(|run| (&run[0], run.len()))
    }

    /// The stop knots inside (t_0, t_m), with their multiplicities.
    pub fn inner_stop_knots(&self) -> impl Iterator<Item = (&BigRational, usize)> {
        self.stop_knots().filter(|(t, _)| *t != self.first() && *t != self.last())
    }

    /// The interior knots t_{k+1}, …, t_{m−k−1} of D3.2, by index: none if m ≤ 2k + 1.
    #[must_use]
    pub fn interior(&self, degree: usize) -> &[BigRational] {
        let end = self.knots.len().saturating_sub(degree + 1);
        self.knots.get(degree + 1..end).unwrap_or(&[])
    }

    /// Open for degree k (D3.2): t_0 = … = t_k and t_{m−k} = … = t_m.
    #[must_use]
    pub fn is_open(&self, degree: usize) -> bool {
        self.m() >= 2 * degree && self.t(0) == self.t(degree) && self.t(self.m() - degree) == self.last()
    }

    /// Uniform for degree k (D3.2): t_{i+1} − t_i is the same for k ≤ i ≤ m − k − 1.
    #[must_use]
    pub fn is_uniform(&self, degree: usize) -> bool {
        let base = self.knots.get(degree..self.knots.len().saturating_sub(degree)).unwrap_or(&[]);
        let mut gaps = base.windows(2).map(|pair| &pair[1] - &pair[0]);
        gaps.next().is_none_or(|first| gaps.all(|gap| gap == first))
    }

    /// Symmetric (D3.2): t_{m−i} = t_0 + t_m − t_i for all i.
    #[must_use]
    pub fn is_symmetric(&self) -> bool {
        self.knots.iter().zip(self.knots.iter().rev()).all(|(t, mirrored)| *mirrored == self.mirror(t))
    }

    /// t_0 + t_m − x.
    #[must_use]
    pub fn mirror(&self, x: &BigRational) -> BigRational {
        self.first() + self.last() - x
    }

    /// The vector with one more knot at x, in its place.
    #[must_use]
    pub fn with_knot(&self, x: &BigRational) -> Self {
        let mut knots = self.knots.clone();
        knots.insert(knots.partition_point(|t| t <= x), x.clone());
        Self { knots }
    }
}

/// (t_0, t_1, …, t_m).
impl fmt::Display for KnotVector {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let knots: Vec<_> = self.knots.iter().map(ToString::to_string).collect();
        write!(f, "({})", knots.join(", "))
    }
}
