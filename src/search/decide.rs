//! The number of local maxima of a candidate: the one question that a search asks for every case.

use num_bigint::{BigInt, Sign as IntegerSign};
use num_rational::BigRational;

use crate::analysis::{Sign, sign_pattern};
use crate::scalar::Polynomial;

use super::candidate::Candidate;

/// How many local maxima there are, and how that was decided.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Count {
    /// The number of local maxima; a plateau counts once.
    pub maxima: usize,
    /// What decided it.
    pub by: Means,
}

/// What decided a case. Either is a proof.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Means {
    /// Intervals with outward rounding.
    Intervals,
    /// Exact arithmetic.
    Exact,
}

/// The number of local maxima: a continuous function that is 0 at both ends has one wherever it stops rising and
/// falls next.
///
/// ```
/// use knotproof::search::{Candidate, local_maxima};
///
/// let candidate = Candidate::new(vec![0, 1, 1, 2], (5, 3))?;
/// assert_eq!(local_maxima(&candidate).maxima, 2);
/// # Ok::<(), knotproof::search::CandidateError>(())
/// ```
#[must_use]
pub fn local_maxima(candidate: &Candidate) -> Count {
    let knots = candidate.local_knots();
    let mut runs = Runs { maxima: 0, last: Sign::Zero };
    for slope in knots.spans().filter_map(|s| knots.on_span(s)).map(|quotient| quotient.slope()) {
        let mut signs = slope.coefficients().iter().map(BigInt::sign).filter(|s| *s != IntegerSign::NoSign);
        let first = signs.next();
        let (mut last, mut variations) = (first, 0);
        for sign in signs {
            variations += usize::from(Some(sign) != last);
            last = Some(sign);
        }
        // Descartes' rule is exact for 0 and for 1 variation; then the signs at the ends of the span say it all.
        if variations <= 1 {
            for sign in [first, last].into_iter().flatten() {
                runs.follow(if sign == IntegerSign::Minus { Sign::Negative } else { Sign::Positive });
            }
        } else {
            sign_pattern(&over_rationals(&slope)).between().iter().for_each(|(_, sign)| runs.follow(*sign));
        }
    }
    Count { maxima: runs.maxima, by: Means::Exact }
}

/// The signs of the slope from left to right.
struct Runs {
    maxima: usize,
    /// The last one that is not 0.
    last: Sign,
}

impl Runs {
    fn follow(&mut self, sign: Sign) {
        if sign != Sign::Zero {
            self.maxima += usize::from(self.last == Sign::Positive && sign == Sign::Negative);
            self.last = sign;
        }
    }
}

/// The same polynomial with rational coefficients.
pub(super) fn over_rationals(p: &Polynomial<BigInt>) -> Polynomial<BigRational> {
    let mut coefficients = p.coefficients().iter().map(|c| BigRational::from_integer(c.clone()));
    match coefficients.next() {
        Some(first) => Polynomial::new(first, coefficients),
        None => unreachable!("a polynomial has at least one coefficient"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::{Pieces, Shape};
    use crate::search::{Cases, Goal, Limits, Sample, Search, Space};
    use crate::spline::{Basis, KnotVector};

    /// The shape of the function in the basis on its full knots, from the pieces of the general path.
    fn by_shape(candidate: &Candidate) -> usize {
        let full = candidate.full_knots();
        let knots = KnotVector::new(full.rational()).unwrap();
        let basis = Basis::new(knots, candidate.degree(), candidate.index()).unwrap();
        Shape::of(&basis, &Pieces::of(&basis), full.index).local_maxima().count()
    }

    #[test]
    fn the_counts_are_those_of_shapes_on_full_knot_vectors() {
        let mut several = 0;
        for (degree, size, count) in [(1, 6, 20), (2, 6, 20), (3, 7, 60), (4, 6, 40)] {
            let exhaustive = Space::Exhaustive(Limits { size, gap: None, height: None });
            let random = Space::Random(Sample { count, seed: 1, spread: 9 });
            for space in [exhaustive, random] {
                let cases = Cases::of(&Search { degree, find: Goal::Several, space }).unwrap();
                for (_, candidate) in cases.between(0..cases.positions()) {
                    let maxima = local_maxima(&candidate).maxima;
                    assert_eq!(maxima, by_shape(&candidate), "{candidate:?}");
                    several += usize::from(maxima > 1);
                }
            }
        }
        assert!(several > 0);
        let three = Candidate::new(
            vec![798_629, 50_969, 15_552_000, 72_327, 2_424_870, 9_185_290],
            (183_588, 1_000_000),
        );
        assert_eq!(local_maxima(&three.unwrap()).maxima, 3);
    }
}
