//! Knot vectors and their spans.

use std::fmt;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::sync::Arc;

use num_rational::BigRational;
use thiserror::Error;

use crate::scalar::RationalAlgebra;

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
///
/// It belongs to its knot vector, and to those that are equal: what takes a span refuses one of another vector.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Span {
    index: usize,
    /// That of the knot vector.
    fingerprint: u64,
}

/// Why a span, or a point on it, does not belong to a knot vector.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
pub enum SpanError {
    /// It was taken from another one.
    #[error("span {0} is one of another knot vector")]
    Foreign(usize),
    /// The point is outside of the closed span, or no number at all.
    #[error("the point does not lie on the closed span [t_{0}, t_{next}]", next = .0 + 1)]
    Outside(usize),
    /// A degree that the knots have no function of.
    #[error("there is no function of degree {degree} on {} knots", .m + 1)]
    Degree {
        /// k.
        degree: usize,
        /// m.
        m: usize,
    },
}

impl Span {
    /// The span of index j where the knots are not numbers, and its being non-empty is known otherwise. No
    /// [`KnotVector`] takes it for one of its own.
    pub(crate) fn assumed(index: usize) -> Self {
        Self { index, fingerprint: 0 }
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
#[derive(Debug, Clone)]
pub struct KnotVector {
    /// Shared: every basis on the same knots has them.
    knots: Arc<[BigRational]>,
    /// Tells its spans from those of other vectors; never 0.
    fingerprint: u64,
}

impl PartialEq for KnotVector {
    fn eq(&self, other: &Self) -> bool {
        self.knots == other.knots
    }
}

impl Eq for KnotVector {}

impl Hash for KnotVector {
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.knots.hash(state);
    }
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
    /// A degree that asks for more knots than there can be.
    #[error("degree {0} asks for more knots than a machine can hold")]
    Degree(usize),
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
        Ok(Self::of(knots))
    }

    /// Of numbers that do not decrease.
    fn of(knots: Vec<BigRational>) -> Self {
        let mut hasher = DefaultHasher::new();
        for t in &knots {
            (t.numer(), t.denom()).hash(&mut hasher);
        }
        Self { knots: knots.into(), fingerprint: hasher.finish().max(1) }
    }

    /// The knot vector of the Bernstein case of P3.3: a and b, k + 1 times each.
    ///
    /// # Errors
    /// [`KnotError`] unless a < b; [`KnotError::Degree`] if no machine can count the knots.
    pub fn bernstein(degree: usize, a: &BigRational, b: &BigRational) -> Result<Self, KnotError> {
        // So many that a vector of them could not even be asked for.
        let most = isize::MAX.unsigned_abs() / (2 * size_of::<BigRational>());
        let times = degree.checked_add(1).filter(|times| *times <= most).ok_or(KnotError::Degree(degree))?;
        let repeated = |value: &BigRational| std::iter::repeat_n(value.clone(), times);
        Self::new(repeated(a).chain(repeated(b)).collect())
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
        (0..self.m()).filter_map(|index| self.span(index))
    }

    /// The span [t_j, t_{j+1}); `None` if that is empty, or not there.
    #[must_use]
    pub fn span(&self, j: usize) -> Option<Span> {
        let (start, end) = (self.knots.get(j)?, self.knots.get(j.checked_add(1)?)?);
        (start < end).then_some(Span { index: j, fingerprint: self.fingerprint })
    }

    /// (t_j, t_{j+1}).
    ///
    /// # Errors
    /// [`SpanError::Foreign`] for a span of another knot vector.
    pub fn ends(&self, span: Span) -> Result<(&BigRational, &BigRational), SpanError> {
        let own = span.fingerprint == self.fingerprint;
        let ends = self.knots.get(span.index).zip(self.knots.get(span.index + 1));
        ends.filter(|_| own).ok_or(SpanError::Foreign(span.index))
    }

    /// The ends of a span on which x lies, as far as that can be told
    /// ([`lies_outside`](crate::scalar::RationalAlgebra::lies_outside)).
    pub(super) fn ends_around<S: RationalAlgebra>(
        &self,
        span: Span,
        x: &S,
    ) -> Result<(&BigRational, &BigRational), SpanError> {
        let (start, end) = self.ends(span)?;
        if x.lies_outside(start, end) { Err(SpanError::Outside(span.index)) } else { Ok((start, end)) }
    }

    /// The span in which the limit at x from the given side is taken; `None` where all functions are 0
    /// there. At t_m both sides give the last span.
    #[must_use]
    pub fn span_at(&self, x: &BigRational, side: Side) -> Option<Span> {
        let from_left = side == Side::Left || x == self.last();
        // The number of knots below the limit; j is the last of them.
        let below = self.knots.partition_point(|t| if from_left { t < x } else { t <= x });
        below.checked_sub(1).and_then(|j| self.span(j))
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
        let start = degree.saturating_add(1);
        self.knots.get(start..self.knots.len().saturating_sub(start)).unwrap_or(&[])
    }

    /// Open for degree k (D3.2): t_0 = … = t_k and t_{m−k} = … = t_m.
    #[must_use]
    pub fn is_open(&self, degree: usize) -> bool {
        degree <= self.m() / 2 && self.t(0) == self.t(degree) && self.t(self.m() - degree) == self.last()
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

    /// Taken for one period, from t_0 to t_m, with its continuation by k knots on either side, t_{i±m} = t_i ± (t_m − t_0): the knots of a
    /// closed curve, whose base spans are those of the period.
    ///
    /// ```
    /// use knotproof::scalar::integer;
    /// use knotproof::spline::KnotVector;
    ///
    /// let period = KnotVector::new([0, 1, 3].map(integer).to_vec())?;
    /// assert_eq!(period.periodic(3).knots(), [-5, -3, -2, 0, 1, 3, 4, 6, 7].map(integer));
    /// # Ok::<(), knotproof::spline::KnotError>(())
    /// ```
    #[must_use]
    pub fn periodic(&self, degree: usize) -> Self {
        let (m, length) = (self.m(), self.last() - self.first());
        let times = |count: usize| &length * BigRational::from_integer(count.into());
        // i places beyond t_m, and before t_0.
        let after = (1..=degree).map(|i| self.t((i - 1) % m + 1) + times((i - 1) / m + 1));
        let before = (1..=degree).rev().map(|i| self.t(m - 1 - (i - 1) % m) - times((i - 1) / m + 1));
        Self::of(before.chain(self.knots.iter().cloned()).chain(after).collect())
    }

    /// The vector with one more knot at x, in its place.
    #[must_use]
    pub fn with_knot(&self, x: &BigRational) -> Self {
        let mut knots = self.knots.to_vec();
        knots.insert(knots.partition_point(|t| t <= x), x.clone());
        Self::of(knots)
    }
}

/// (t_0, t_1, …, t_m).
impl fmt::Display for KnotVector {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let knots: Vec<_> = self.knots.iter().map(ToString::to_string).collect();
        write!(f, "({})", knots.join(", "))
    }
}
