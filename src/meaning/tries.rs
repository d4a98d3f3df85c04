//! What is tried where a sentence speaks of any numbers: control values, and numbers beside knots. It knows functions, and no
//! sentence; what is tried can refute, and proves nothing.

use crate::analysis::{
    ExtremumKind, LocalKnots, Monotonicity, NegativeMinor, Pieces, Shape, determinant, negative_minor,
};
use crate::scalar::{BigRational, integer};
use crate::spline::{Basis, KnotVector, binomial};

/// Control values for a basis: constant, rising, of alternating signs, a step; without interior knots the coefficients of
/// Chebyshev's polynomial; a function with two maxima, cut between them; and what a negative minor shows.
pub(super) fn control_values(pieces: &Pieces) -> Vec<Vec<BigRational>> {
    let basis = pieces.basis();
    let (k, n, knots) = (basis.degree(), basis.n(), basis.knots());
    let list = |value: &dyn Fn(usize) -> BigRational| (0..=n).map(value).collect();
    let mut all: Vec<Vec<_>> = vec![
        list(&|_| integer(1)),
        list(&|i| integer(i)),
        list(&|i| signed(i, integer(1))),
        list(&|i| integer(i * i)),
    ];
    all.extend((1..=n).map(|step| list(&|i| integer(usize::from(i >= step)))));
    all.extend((knots.is_open(k) && knots.m() == 2 * k + 1).then(|| chebyshev(k)));
    all.extend(two_maxima_cut(pieces));
    all.extend(from_negative_minor(basis));
    all
}

/// Numbers beside knots: the middles of the spans, and the knots.
pub(super) fn numbers(knots: &KnotVector) -> Vec<BigRational> {
    let middle = |pair: &[BigRational]| (&pair[0] + &pair[1]) / integer(2);
    let stops: Vec<_> = knots.stop_knots().map(|(t, _)| t.clone()).collect();
    stops.windows(2).map(middle).chain(stops.iter().cloned()).collect()
}

fn signed(i: usize, size: BigRational) -> BigRational {
    if i.is_multiple_of(2) { size } else { -size }
}

/// The coefficients of Chebyshev's polynomial T_k(2w − 1) in the Bernstein basis: (−1)^(k−i) C(2k, 2i)/C(k, i).
fn chebyshev(k: usize) -> Vec<BigRational> {
    (0..=k).map(|i| signed(k - i, binomial(2 * k, 2 * i) / binomial(k, i))).collect()
}

/// A function with two local maxima, cut by a line between the lower one and the minimum between them: e_i − c, with the
/// shortest decimal c, since the functions of an open vector have the sum 1.
fn two_maxima_cut(pieces: &Pieces) -> Option<Vec<BigRational>> {
    /// Maxima and minima that are closer than 10^−40 are passed over.
    const DIGITS: usize = 40;
    let basis = pieces.basis();
    let several = |i: &usize| {
        let maxima = LocalKnots::of(basis, *i).and_then(|knots| Monotonicity::of(&knots).local_maxima());
        maxima.is_some_and(|maxima| maxima > 1)
    };
    let i = (0..=basis.n()).find(several)?;
    let mut shape = Shape::of(pieces, i);
    let height = (1..=DIGITS).find_map(|digits| {
        shape.refine_to(&power_of_ten(digits).recip());
        shape.extrema().windows(3).find_map(|three| {
            let [first, minimum, second] = three else { return None };
            let between = (first.kind, second.kind) == (ExtremumKind::Maximum, ExtremumKind::Maximum);
            let low = &minimum.value.1;
            let high = (&first.value.0).min(&second.value.0);
            (between && low < high).then(|| shortest_decimal(low, high))
        })
    })?;
    Some((0..=basis.n()).map(|l| integer(usize::from(l == i)) - &height).collect())
}

fn power_of_ten(digits: usize) -> BigRational {
    num_traits::pow(integer(10), digits)
}

/// The number with the fewest decimals strictly between the two, and of these the one next to the middle.
fn shortest_decimal(low: &BigRational, high: &BigRational) -> BigRational {
    let middle = (low + high) / integer(2);
    let rounded = (0..).map(|digits| {
        let unit = power_of_ten(digits);
        (&middle * &unit).round() / unit
    });
    rounded.take_while(|_| low < high).find(|x| low < x && x < high).unwrap_or(middle)
}

/// From a negative minor: with f = Σ c_i G_i equal to 1, −1, 1 at its points, the c_i have the signs −, +, −, so f changes
/// its sign there twice, and twice more where the outer functions, alone near the ends of their supports, make it
/// negative. Whole numbers c_i change f by 1/2 at most.
fn from_negative_minor(basis: &Basis) -> Option<Vec<BigRational>> {
    let NegativeMinor { first, rows, value, .. } = negative_minor(basis)?;
    // All others −1: they add no change of sign to the polygon's, and no part of it lies in the line y = 0.
    let mut c = vec![-integer(1); basis.n() + 1];
    for column in 0..3 {
        // Cramer's rule.
        let mut replaced = rows.clone();
        replaced.iter_mut().enumerate().for_each(|(row, entries)| entries[column] = signed(row, integer(1)));
        c[first + column] = (determinant(&replaced, &integer(1)) / &value).round();
    }
    Some(c)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::{parse_rational, rational};

    fn pieces(degree: usize, knots: &[usize], alpha: &str) -> Pieces {
        let knots = KnotVector::new(knots.iter().map(|t| integer(*t)).collect()).unwrap();
        Pieces::of(&Basis::new(knots, degree, alpha.parse().unwrap()).unwrap())
    }

    /// The function of the conjecture, cut between its maxima: the line has eight decimals.
    #[test]
    fn a_function_with_two_maxima_is_cut_by_a_short_number() {
        let height = parse_rational("0.63616075").unwrap();
        let expected: Vec<_> = (0..6).map(|l| integer(usize::from(l == 2)) - &height).collect();
        assert!(control_values(&pieces(3, &[0, 0, 0, 0, 1, 2, 4, 4, 4, 4], "5/2")).contains(&expected));
    }

    #[test]
    fn chebyshev_in_bernstein_form() {
        assert_eq!(chebyshev(2), [1, -3, 1].map(|c| rational(c, 1)));
        assert_eq!(chebyshev(4)[2], rational(35, 3));
        assert!(control_values(&pieces(2, &[0, 0, 0, 1, 1, 1], "-1")).contains(&chebyshev(2)));
    }

    #[test]
    fn decimals() {
        let number = |text: &str| parse_rational(text).unwrap();
        assert_eq!(shortest_decimal(&number("0.3"), &number("1.2")), number("1"));
        assert_eq!(shortest_decimal(&number("0.31"), &number("0.39")), number("0.35"));
        assert_eq!(shortest_decimal(&number("-0.39"), &number("-0.31")), number("-0.35"));
    }

    #[test]
    fn numbers_are_middles_and_knots() {
        let knots = KnotVector::new([0, 0, 1, 3].map(integer).to_vec()).unwrap();
        assert_eq!(numbers(&knots), [rational(1, 2), rational(2, 1), integer(0), integer(1), integer(3)]);
    }
}
