//! Interpolation: the matrix of the basis functions at given places, and the curve through given points.

use num_rational::BigRational;
use num_traits::Zero;
use thiserror::Error;

use crate::spline::{Basis, Curve, CurveError, HasWeights, Index, Point, Sampler, Side};

use super::linear::{combinations, determinant_by_elimination, rank, relation};

/// The collocation matrix (G_i(x_j)), a row for each place x_0 < x_1 < … and a column for each function, exactly. At jumps the values
/// are those from the right, at t_m those from the left.
///
/// **When is interpolation possible?** Where n + 1 places are given, a curve takes any points at them if and only if the determinant is
/// not 0. The *condition of Schoenberg and Whitney* is G_i(x_i) ≠ 0 for every i; where G_i is continuous that is t_i < x_i < t_{i+k+1}, and
/// at a knot of k + 1 copies or more, and at t_0 and t_m, the one-sided value says it.
///
/// It is **necessary** wherever the functions are 0 outside of their supports only: G_i(x_i) = 0 with x_i on the left of all of G_i makes
/// the rows 0, …, i lie in the i columns 0, …, i − 1, and on the right it is the same from the other end. For α = ∞ it is sufficient, too
/// (Schoenberg and Whitney 1953). **For other α it is not**: on the knots (0, 0, 0, 0, 1, 2, 2, 2, 2), k = 3, α = 100/99, there are
/// places that meet it with a positive determinant and others with a negative one, and on the line between them, where all meet it, some
/// with 0 (`tests/collocation.rs`). So the determinant decides.
///
/// ```
/// use knotproof::analysis::Collocation;
/// use knotproof::scalar::{integer, rational};
/// use knotproof::spline::{Basis, Index, KnotVector, Side};
///
/// let knots = KnotVector::new([0, 0, 0, 1, 2, 2, 2].map(integer).to_vec())?;
/// let basis = Basis::new(knots, 2, "5".parse::<Index>()?)?;
/// let places = [integer(0), rational(1, 2), rational(3, 2), integer(2)];
/// let collocation = Collocation::new(&basis, places.to_vec())?;
/// assert!(collocation.misplaced().is_empty());
/// let points = [[0, 0], [1, 2], [2, 2], [3, 0]].map(|point| point.map(integer).to_vec());
/// let curve = collocation.interpolate(&points)?;
/// assert_eq!(curve.point(&places[1], Side::Right), points[1]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone)]
pub struct Collocation<W = Index> {
    basis: Basis<W>,
    places: Vec<BigRational>,
    rows: Vec<Vec<BigRational>>,
}

/// Numbers that are no places for a collocation matrix.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum SiteError {
    /// None at all.
    #[error("there is no place: give each x at which the functions are wanted")]
    None,
    /// x_{j−1} ≥ x_j.
    #[error("places must rise from one to the next, but place {position} is {value}, after {previous}")]
    Order {
        /// j, from 0.
        position: usize,
        /// x_{j−1}.
        previous: BigRational,
        /// x_j.
        value: BigRational,
    },
    /// Not in [t_0, t_m].
    #[error("place {position} is {value}, outside of [{first}, {last}], where the functions are")]
    Outside {
        /// j, from 0.
        position: usize,
        /// x_j.
        value: BigRational,
        /// t_0.
        first: BigRational,
        /// t_m.
        last: BigRational,
    },
}

/// Why no curve interpolates.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum InterpolationError {
    /// Not n + 1 places.
    #[error(
        "{places} places, and there are {functions} functions: interpolation takes as many places as functions"
    )]
    Places {
        /// How many there are.
        places: usize,
        /// n + 1.
        functions: usize,
    },
    /// Not a point for each place.
    #[error("{points} points for {places} places: give one for each")]
    Points {
        /// How many there are.
        points: usize,
        /// How many places.
        places: usize,
    },
    /// The determinant is 0.
    #[error("{}", singular(*.degree, *.rank, *.functions, .misplaced))]
    Singular {
        /// The rank of the matrix.
        rank: usize,
        /// n + 1.
        functions: usize,
        /// k.
        degree: usize,
        /// Each i with G_i(x_i) = 0.
        misplaced: Vec<usize>,
    },
    /// The points are none of one R^d.
    #[error(transparent)]
    Curve(#[from] CurveError),
}

fn singular(degree: usize, rank: usize, functions: usize, misplaced: &[usize]) -> String {
    let why = match misplaced {
        [] => "though no G_i is 0 at place i (the condition of Schoenberg and Whitney does not suffice here)"
            .to_owned(),
        [i, ..] => format!(
            "as G_{i} is 0 at place {i}, which has to lie between t_{i} and t_{}: places count from 0",
            i + degree + 1
        ),
    };
    format!("the matrix of the functions at these places has the rank {rank}, less than {functions}, {why}")
}

impl<W: HasWeights> Collocation<W> {
    /// The functions of a basis at places that rise.
    ///
    /// # Errors
    /// [`SiteError`], for the first place that is none.
    pub fn new(basis: &Basis<W>, places: Vec<BigRational>) -> Result<Self, SiteError>
    where
        W: Clone,
    {
        let (first, last) = (basis.knots().first(), basis.knots().last());
        if places.is_empty() {
            return Err(SiteError::None);
        }
        for (position, value) in places.iter().enumerate() {
            if value < first || value > last {
                let (value, first, last) = (value.clone(), first.clone(), last.clone());
                return Err(SiteError::Outside { position, value, first, last });
            }
            match position.checked_sub(1).map(|before| &places[before]) {
                Some(previous) if previous >= value => {
                    let (previous, value) = (previous.clone(), value.clone());
                    return Err(SiteError::Order { position, previous, value });
                }
                _ => {}
            }
        }
        let mut sampler = Sampler::new(basis);
        let mut row = |x: &BigRational| {
            let mut row = vec![BigRational::zero(); basis.n() + 1];
            for (i, value) in sampler.values(x, Side::Right).iter().flat_map(|active| active.iter()) {
                row[i].clone_from(value);
            }
            row
        };
        let rows = places.iter().map(&mut row).collect();
        Ok(Self { basis: basis.clone(), places, rows })
    }

    /// x_0, x_1, ….
    #[must_use]
    pub fn places(&self) -> &[BigRational] {
        &self.places
    }

    /// G_0(x_j), …, G_n(x_j) for each place.
    #[must_use]
    pub fn rows(&self) -> &[Vec<BigRational>] {
        &self.rows
    }

    /// The rank of the matrix.
    #[must_use]
    pub fn rank(&self) -> usize {
        rank(&self.rows)
    }

    /// The determinant; `None` unless there are n + 1 places.
    #[must_use]
    pub fn determinant(&self) -> Option<BigRational> {
        determinant_by_elimination(&self.rows)
    }

    /// Each i with G_i(x_i) = 0: none, if the condition of Schoenberg and Whitney holds. Of fewer places than functions, or more, the
    /// first ones are looked at.
    #[must_use]
    pub fn misplaced(&self) -> Vec<usize> {
        let on_diagonal = self.rows.iter().enumerate().filter_map(|(i, row)| Some((i, row.get(i)?)));
        on_diagonal.filter(|(_, value)| value.is_zero()).map(|(i, _)| i).collect()
    }

    /// c_i, not all 0, with Σ c_i G_i(x_j) = 0 at every place: a curve that is 0 at all of them; `None` if there is none.
    #[must_use]
    pub fn relation(&self) -> Option<Vec<BigRational>> {
        relation(&self.columns())
    }

    /// The curve with these points at the places: its control points are the only ones.
    ///
    /// # Errors
    /// [`InterpolationError`], if it is not that there is exactly one.
    pub fn interpolate(&self, points: &[Point]) -> Result<Curve<W>, InterpolationError>
    where
        W: Clone,
    {
        let (places, functions) = (self.places.len(), self.basis.n() + 1);
        if places != functions {
            return Err(InterpolationError::Places { places, functions });
        }
        if points.len() != places {
            return Err(InterpolationError::Points { points: points.len(), places });
        }
        // It is no curve yet, but its points are as those of one.
        let sample = Curve::new(self.basis.clone(), points.to_vec())?;
        let rank = self.rank();
        if rank < functions {
            let (degree, misplaced) = (self.basis.degree(), self.misplaced());
            return Err(InterpolationError::Singular { rank, functions, degree, misplaced });
        }
        let target = |c: usize| points.iter().map(|point| point[c].clone()).collect();
        let targets: Vec<_> = (0..sample.dimension()).map(target).collect();
        let solutions: Vec<_> = combinations(&self.columns(), &targets).into_iter().flatten().collect();
        let control = |i: usize| solutions.iter().map(|solution| solution[i].clone()).collect();
        Ok(Curve::new(self.basis.clone(), (0..functions).map(control).collect())?)
    }

    fn columns(&self) -> Vec<Vec<BigRational>> {
        let column = |i: usize| self.rows.iter().map(|row| row[i].clone()).collect();
        (0..=self.basis.n()).map(column).collect()
    }
}
