//! The family of knots behind X.maxima with numbers put in: one example that can be followed by hand.

use num_traits::One;

use crate::analysis::{Location, Pieces, Shape};
use crate::scalar::{BigRational, decimal, integer, rational};
use crate::spline::{Basis, Index, KnotVector, Side};

use super::formula;
use super::working::{Working, working};

/// The claim that it belongs to.
pub(super) const CLAIM: &str = "X.maxima";

/// k and α of the example.
const DEGREE: usize = 3;
const ALPHA: &str = "5/2";
/// The digits of decimals, at most.
const DIGITS: usize = 10;

/// The digits on which both ends of an enclosure agree.
fn settled(low: &BigRational, high: &BigRational) -> String {
    let agreed = (1..=DIGITS).rev().map(|digits| (decimal(low, digits), decimal(high, digits)));
    agreed.into_iter().find(|(low, high)| low == high).map_or_else(|| format!("{low}"), |(low, _)| low)
}

/// The example in lines of HTML, and the recursion at the knot between its maxima, from both sides.
pub(super) struct Example {
    /// From α to the maxima.
    pub(super) lines: Vec<String>,
    /// The slopes at the minimum.
    pub(super) workings: Vec<Working>,
}

/// The example; `None` if the function had not the two maxima that it is to show.
pub(super) fn example() -> Option<Example> {
    let k = integer(DEGREE);
    let (one, two) = (BigRational::one(), integer(2));
    let index: Index = ALPHA.parse().ok()?;
    let r = index.ratio().clone();
    let (below, above) = (&r - &one, &r + &one);
    let c = &r * &below * &below / (integer(8) * &above * &above);
    let over = (&two * &k * &k - integer(7) * &k + integer(7)) * &r + integer(5) * &k - integer(7);
    let under = &two * (&k - &one) * ((&two * &k - integer(3)) * &r + integer(3));
    let kappa = over / under;
    let x = one;
    let y = &x + &x * ((&k - &two) * &r - &kappa * &c);
    let z = &y + &x * &c;
    let mut knots = vec![integer(0); DEGREE + 1];
    knots.extend([x.clone(), y.clone()]);
    knots.extend(vec![z.clone(); DEGREE + 1]);
    let basis = Basis::new(KnotVector::new(knots).ok()?, DEGREE, index.clone()).ok()?;
    let mut shape = Shape::of(&Pieces::of(&basis), 2);
    shape.refine_to(&rational(1, 1 << 60));
    let maxima: Vec<_> = shape.local_maxima().collect();
    let minimum = shape.local_minima().find_map(|minimum| match &minimum.place {
        Location::Point(at) => Some((at.clone(), minimum.value.0.clone())),
        _ => None,
    })?;
    let [left, right] = maxima.as_slice() else { return None };
    let near = |extremum: &crate::analysis::Extremum| {
        let ((from, to), (low, high)) = (extremum.place.interval(), &extremum.value);
        format!("{} at x ≈ {}", settled(low, high), settled(from, to))
    };
    let lines = [
        format!("k = {DEGREE}, α = {index}, so r = {r}, c = r(r − 1)^2/(8(r + 1)^2) = {c} and κ = {kappa}."),
        format!(
            "With x = {x}: y − x = x((k − 2)r − κc) = {} and z − y = xc = {c}, so y = {y} and z = {z}.",
            &y - &x
        ),
        format!(
            "On U = (0, 0, 0, 0, {x}, {y}, {z}, {z}, {z}, {z}) the function G_2^3 rises to {}, falls, and rises again to {}.",
            near(left),
            near(right)
        ),
        format!(
            "Between them it has a minimum at the knot {}, where it is {} ≈ {}: less than both. Its slopes there are worked out below.",
            minimum.0,
            minimum.1,
            decimal(&minimum.1, DIGITS)
        ),
    ];
    let lines = lines.iter().map(|line| formula::html(line)).collect();
    let sides = [Side::Left, Side::Right];
    let workings = sides.into_iter().filter_map(|side| working(&basis, &minimum.0, side, true)).collect();
    Some(Example { lines, workings })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_numbers_are_those_of_the_formulas() {
        let Example { lines, workings } = example().expect("two maxima");
        let text = lines.join("\n");
        // r = 5/3, c = (5/3)(4/9)/(8·64/9) = 5/384, κ = (4r + 8)/(12(r + 1)) = 11/24.
        for number in ["<mn>384</mn>", "<mn>24</mn>"] {
            assert!(text.contains(number), "{number} in {text}");
        }
        assert_eq!((lines.len(), workings.len()), (4, 2));
    }
}
