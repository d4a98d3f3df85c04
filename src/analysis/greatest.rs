//! Suprema as real numbers: the greatest of the values at critical points and of the limits at ends.

use std::cmp::Ordering;

use num_rational::BigRational;

use crate::scalar::{Ring, integer};

use super::algebraic::{Algebraic, Enclosed};
use super::piece::Piece;
use super::roots::{count_positive_roots, positive_roots};

/// The greatest of several real numbers. Those that are found to be smaller are dropped.
#[derive(Debug, Clone, PartialEq)]
pub struct Greatest(Vec<Algebraic>);

impl Greatest {
    /// Of numbers; `None` if there are none.
    #[must_use]
    pub fn of(numbers: impl IntoIterator<Item = BigRational>) -> Option<Self> {
        let all: Vec<_> = numbers.into_iter().map(Algebraic::from).collect();
        (!all.is_empty()).then_some(Self(all))
    }

    /// sup f(u), 0 < u < ∞: a limit at an end, or a value where f′ = 0; `None` if f has a pole in [0, ∞].
    ///
    /// ```
    /// use knotproof::analysis::{Greatest, compare};
    /// use knotproof::scalar::{RationalAlgebra, RationalFunction, Ring, rational};
    ///
    /// // u/(1 + u²) is largest at u = 1.
    /// let u = RationalFunction::variable(&rational(1, 1));
    /// let mut largest = Greatest::of_function(&u.over(&u.times(&u).plus(&u.one())).unwrap()).unwrap();
    /// assert!(compare(&mut largest, &mut rational(1, 2).into()).is_some_and(|order| order.is_eq()));
    /// ```
    #[must_use]
    pub fn of_function(f: &Piece) -> Option<Self> {
        Self::of_signs(f, false)
    }

    /// sup |f(u)|, 0 < u < ∞, on the same terms.
    #[must_use]
    pub fn of_modulus(f: &Piece) -> Option<Self> {
        Self::of_signs(f, true)
    }

    /// Of f, and of −f, which turns at the same places.
    fn of_signs(f: &Piece, both: bool) -> Option<Self> {
        if count_positive_roots(f.denominator()) > 0 {
            return None;
        }
        let roots = positive_roots(f.derivative().numerator());
        let mut all = Vec::new();
        for f in std::iter::once(f.clone()).chain(both.then(|| f.negate())) {
            all.extend([f.evaluate(&integer(0))?, f.at_infinity()?].map(Algebraic::from));
            for mut root in roots.iter().cloned() {
                all.push(match root.rational() {
                    Some(u) => f.evaluate(&u)?.into(),
                    None => Algebraic::at(f.clone(), root),
                });
            }
        }
        let mut all = Self(all);
        // What is smaller is dropped before it is copied and narrowed again.
        all.bounds();
        Some(all)
    }

    /// Of both.
    #[must_use]
    pub fn join(mut self, other: Self) -> Self {
        self.0.extend(other.0);
        self
    }
}

impl From<BigRational> for Greatest {
    fn from(number: BigRational) -> Self {
        Self(vec![number.into()])
    }
}

impl Enclosed for Greatest {
    fn bounds(&mut self) -> (BigRational, BigRational) {
        let bounds: Vec<_> = self.0.iter_mut().map(Algebraic::bounds).collect();
        let greatest =
            |ends: &mut dyn Iterator<Item = &BigRational>| ends.max().cloned().unwrap_or_else(|| integer(0));
        let lo = greatest(&mut bounds.iter().map(|(lo, _)| lo));
        let mut keep = bounds.iter().map(|(_, hi)| *hi >= lo);
        self.0.retain(|_| keep.next().unwrap_or(true));
        (lo, greatest(&mut bounds.iter().map(|(_, hi)| hi)))
    }

    fn narrow(&mut self) -> bool {
        // Each of them: `any` would stop at the first.
        self.0.iter_mut().map(Enclosed::narrow).fold(false, std::ops::BitOr::bitor)
    }
}

/// Bounds are narrowed so often, some bits a time, before two numbers are held against each other otherwise.
const LOOKS: usize = 16;

/// Which is greater? A rational number is compared with any other exactly; two irrational ones that agree to some 128 bits
/// are left undecided.
#[must_use]
pub fn compare(a: &mut Greatest, b: &mut Greatest) -> Option<Ordering> {
    for _ in 0..LOOKS {
        let ((a_lo, a_hi), (b_lo, b_hi)) = (a.bounds(), b.bounds());
        if a_hi < b_lo {
            return Some(Ordering::Less);
        }
        if b_hi < a_lo {
            return Some(Ordering::Greater);
        }
        if a_lo == a_hi && b_lo == b_hi {
            return Some(Ordering::Equal);
        }
        a.narrow();
        b.narrow();
    }
    let equals = |all: &Greatest, number: &BigRational| all.0.iter().all(|one| one.is(number));
    let exact = |all: &Greatest| all.0.iter().find_map(|one| one.exact().cloned());
    let number = exact(a).or_else(|| exact(b))?;
    (equals(a, &number) && equals(b, &number)).then_some(Ordering::Equal)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::{RationalAlgebra, RationalFunction, Ring, rational};

    fn u() -> Piece {
        RationalFunction::variable(&rational(1, 1))
    }

    /// u/(c + u²), largest at √c, where it is 1/(2√c).
    fn hill(c: i64) -> Piece {
        u().over(&u().times(&u()).plus(&u().embed(&rational(c, 1)))).unwrap()
    }

    #[test]
    fn suprema_are_compared_exactly() {
        let order = |f: &Piece, g: &Piece| {
            compare(&mut Greatest::of_function(f).unwrap(), &mut Greatest::of_function(g).unwrap())
        };
        assert_eq!(order(&hill(2), &hill(3)), Some(Ordering::Greater));
        assert_eq!(order(&hill(4), &hill(1).times(&u().embed(&rational(1, 2)))), Some(Ordering::Equal));
        // (1/(2√2))² = 1/8, at an irrational point.
        let square = hill(2).times(&hill(2));
        assert_eq!(order(&square, &u().embed(&rational(1, 8))), Some(Ordering::Equal));
        assert_eq!(order(&hill(2), &hill(2)), None);
        // Limits at both ends.
        let rising = u().over(&u().plus(&u().one())).unwrap();
        let falling = rising.negate().plus(&u().one());
        assert_eq!(order(&rising, &falling), Some(Ordering::Equal));
        assert_eq!(Greatest::of_function(&u()), None);
    }

    #[test]
    fn the_greatest_of_several_is_kept() {
        let mut all = Greatest::of_function(&hill(2)).unwrap().join(rational(1, 3).into());
        assert_eq!(compare(&mut all, &mut rational(7, 20).into()), Some(Ordering::Greater));
        assert_eq!(all.0.len(), 1);
        assert_eq!(Greatest::of([]), None);
    }
}
