//! Minors of the matrices (G_i(x_j)), x_1 < x_2 < …: a total positivity that fails, fails close to a knot.

use crate::scalar::{BigRational, integer, rational};
use crate::spline::{Basis, HasWeights, Side};

use super::linear::determinant;

/// Three consecutive functions and three points with a negative minor.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct NegativeMinor {
    /// The index of the first function.
    pub first: usize,
    /// The points, from left to right.
    pub points: [BigRational; 3],
    /// The values of the functions at each of them.
    pub rows: Vec<Vec<BigRational>>,
    /// The minor.
    pub value: BigRational,
}

/// A negative minor of order 3 close to a knot, if there is one by this test: where the derivatives jump, the
/// minor of (G_i) at x − ε, x, x + ε is ε² det(G, D⁻G, D⁺G) + O(ε³).
#[must_use]
pub fn negative_minor<W: HasWeights>(basis: &Basis<W>) -> Option<NegativeMinor> {
    let close = basis.knots().inner_stop_knots().filter(|(_, p)| *p <= basis.degree());
    close.map(|(x, _)| x).find_map(|x| {
        let (left, right) = (basis.jets(x, Side::Left, 1), basis.jets(x, Side::Right, 1));
        let column =
            |i: usize| [&right[i].coefficients()[0], &left[i].coefficients()[1], &right[i].coefficients()[1]];
        let negative = |first: &usize| {
            let corner: Vec<Vec<_>> =
                (*first..first + 3).map(|i| column(i).map(Clone::clone).to_vec()).collect();
            determinant(&corner, &integer(1)) < integer(0)
        };
        (0..basis.n().saturating_sub(1)).find(negative).and_then(|first| near(basis, x, first))
    })
}

/// The points x − ε, x, x + ε with the largest ε = 2^(−e) at which the minor is negative.
fn near<W: HasWeights>(basis: &Basis<W>, x: &BigRational, first: usize) -> Option<NegativeMinor> {
    /// A corner with a smaller ε than 2^−40 is passed over.
    const HALVINGS: i32 = 40;
    (1..=HALVINGS).find_map(|e| {
        let epsilon = rational(1, 2).pow(e);
        let points = [x - &epsilon, x.clone(), x + &epsilon];
        let row = |x: &BigRational| basis.values(x, Side::Right)[first..first + 3].to_vec();
        let rows: Vec<_> = points.iter().map(row).collect();
        let value = determinant(&rows, &integer(1));
        (value < integer(0)).then_some(NegativeMinor { first, points, rows, value })
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::spline::KnotVector;

    #[test]
    fn polynomial_b_splines_are_totally_positive_and_others_are_not() {
        let knots = KnotVector::new([0, 0, 0, 0, 1, 2, 3, 3].map(integer).to_vec()).unwrap();
        let basis = |alpha: &str| Basis::new(knots.clone(), 3, alpha.parse().unwrap()).unwrap();
        assert_eq!(negative_minor(&basis("inf")), None);
        let minor = negative_minor(&basis("-1")).unwrap();
        assert_eq!((minor.first, minor.points[0].clone()), (1, rational(1023, 1024)));
    }
}
