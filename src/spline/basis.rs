//! The basis functions G_0^k, …, G_n^k of an index on a knot vector.

use num_rational::BigRational;
use thiserror::Error;

use super::index::Index;
use super::knots::KnotVector;
use super::triangle::Active;

/// The basis (^αG_i^k), i = 0..n, of degree k and index α on U = (t_0, …, t_m), n = m − k − 1 (D3.3).
///
/// ```
/// use knotproof::scalar::{integer, rational};
/// use knotproof::spline::{Basis, Index, KnotVector, Side};
///
/// let knots = KnotVector::new([0, 0, 0, 1, 1, 1].map(integer).to_vec())?;
/// let basis = Basis::new(knots, 2, "-1".parse::<Index>()?)?;
/// // φ = x/(2 − x), so φ(1/2) = 1/3 and the Bernstein values are 4/9, 4/9, 1/9.
/// let values = basis.values(&rational(1, 2), Side::Right);
/// assert_eq!(values, [rational(4, 9), rational(4, 9), rational(1, 9)]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// Other weights than those of an index are another `W`; only an index has the fast kernels.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct Basis<W = Index> {
    knots: KnotVector,
    degree: usize,
    weights: W,
}

/// Why a knot vector carries no basis of the degree.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[error("degree {degree} needs at least {needed} knots (m ≥ 2k and n ≥ 0, D3.2), and here are {count}")]
pub struct BasisError {
    degree: usize,
    needed: usize,
    count: usize,
}

impl Basis {
    /// Checks that there are knots enough: m ≥ 2k (D3.2), and at least one function.
    ///
    /// The paper's n ≥ k and t_k < t_{m−k} are not asked for: its own U0 has neither in degree 3, and the
    /// recursion needs neither. Claims that need them say so.
    ///
    /// # Errors
    /// [`BasisError`] with the number of knots that the degree needs.
    pub fn new(knots: KnotVector, degree: usize, index: Index) -> Result<Self, BasisError> {
        Self::over(knots, degree, index)
    }
}

impl<W> Basis<W> {
    /// The same check for any weights.
    ///
    /// # Errors
    /// [`BasisError`] with the number of knots that the degree needs.
    pub fn over(knots: KnotVector, degree: usize, weights: W) -> Result<Self, BasisError> {
        let count = knots.m() + 1;
        let needed = degree.saturating_mul(2).max(degree.saturating_add(1)).saturating_add(1);
        if count < needed {
            return Err(BasisError { degree, needed, count });
        }
        Ok(Self { knots, degree, weights })
    }

    /// What its weights are made from.
    #[must_use]
    pub fn weights(&self) -> &W {
        &self.weights
    }

    /// The same knots and degree with other weights.
    #[must_use]
    pub fn with<V>(&self, weights: V) -> Basis<V> {
        Basis { knots: self.knots.clone(), degree: self.degree, weights }
    }

    /// U.
    #[must_use]
    pub fn knots(&self) -> &KnotVector {
        &self.knots
    }

    /// k.
    #[must_use]
    pub fn degree(&self) -> usize {
        self.degree
    }

    /// n, the index of the last function: m − k − 1.
    #[must_use]
    pub fn n(&self) -> usize {
        self.knots.m() - self.degree - 1
    }

    /// [t_i, t_{i+k+1}], outside of which G_i^k is 0.
    ///
    /// # Panics
    /// If i > n.
    #[must_use]
    pub fn support(&self, i: usize) -> (&BigRational, &BigRational) {
        (self.knots.t(i), self.knots.t(i + self.degree + 1))
    }

    /// The list of all functions, from those that live at a point.
    pub(super) fn all<S: Clone>(&self, active: Option<Active<S>>, zero: &S) -> Vec<S> {
        let mut all = vec![zero.clone(); self.n() + 1];
        if let Some(active) = active {
            all[active.first()..active.first() + active.values().len()].clone_from_slice(active.values());
        }
        all
    }
}

impl Basis {
    /// α.
    #[must_use]
    pub fn index(&self) -> &Index {
        &self.weights
    }

    /// The same knots and degree with another index.
    #[must_use]
    pub fn with_index(&self, index: Index) -> Self {
        self.with(index)
    }
}
