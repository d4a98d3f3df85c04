//! The shape of a basis function: where it rises, falls, stays and jumps, exactly.

use num_rational::BigRational;

use super::contenders::{Attained, attained, attained_once};
use super::extremum::{Extremum, ExtremumKind, Jump};
use super::pieces::Pieces;
use super::profile::{Features, Profile, Segment};

/// The local extrema and jumps of one G_i^k.
///
/// The function is taken on the closure of its support, right-continuous at jumps, with the limit from the
/// left at t_m, and as 0 outside (also outside of [t_0, t_m]). A **local maximum** is a point, or a maximal
/// interval of constancy, where it is larger than everywhere close by on both sides. So a function that begins
/// at t_0 with a positive value and falls has a local maximum there, and one that rises to t_m has one at t_m;
/// one that rises to an inner knot and jumps down has none there, since the value before the jump is not
/// attained, but one that is constant before the jump has. A **local minimum** is the same upside down, inside
/// the support only: as nothing there is negative, that is between two maxima, attained or not.
///
/// Exact: critical points are the sign changes of the numerator of dG/du, isolated on each span; at knots the
/// one-sided limits are compared.
///
/// ```
/// use knotproof::analysis::{Pieces, Place, Shape};
/// use knotproof::scalar::integer;
/// use knotproof::spline::{Basis, Index, KnotVector};
///
/// let basis = Basis::new(KnotVector::new([0, 1, 2].map(integer).to_vec())?, 1, Index::infinity())?;
/// let hat = Shape::of(&Pieces::of(&basis), 0);
/// assert_eq!(hat.extrema().len(), 1);
/// assert_eq!(hat.extrema()[0].place, Place::Point(integer(1)));
/// assert!(hat.strong() && hat.weak() == Some(true));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Shape {
    features: Features,
}

impl Shape {
    /// The shape of G_i^k, from the pieces of its basis.
    ///
    /// # Panics
    /// If i > n.
    #[must_use]
    pub fn of(pieces: &Pieces, i: usize) -> Self {
        let basis = pieces.basis();
        let (from, to) = basis.support(i);
        let segments = pieces.spans().iter().filter_map(|on_span| {
            let (start, end) = on_span.ends();
            (from <= start && end <= to).then(|| Segment {
                start: start.clone(),
                end: end.clone(),
                piece: on_span.function(i),
            })
        });
        let inside = to < basis.knots().last();
        let mut features = Profile::of(segments, inside).features();
        // At the ends of [t_0, t_m] there is nothing to be continuous with.
        features.jumps.retain(|jump| jump.at != *basis.knots().first() && jump.at != *basis.knots().last());
        Self { features }
    }

    /// The local maxima and minima, from left to right.
    #[must_use]
    pub fn extrema(&self) -> &[Extremum] {
        &self.features.extrema
    }

    /// Narrows every extremum, as [`Extremum::refine_to`] does.
    pub fn refine_to(&mut self, width: &BigRational) {
        for extremum in &mut self.features.extrema {
            extremum.refine_to(width);
        }
    }

    /// The local maxima, from left to right.
    pub fn local_maxima(&self) -> impl Iterator<Item = &Extremum> {
        self.features.extrema.iter().filter(|extremum| extremum.kind == ExtremumKind::Maximum)
    }

    /// The local minima, from left to right.
    pub fn local_minima(&self) -> impl Iterator<Item = &Extremum> {
        self.features.extrema.iter().filter(|extremum| extremum.kind == ExtremumKind::Minimum)
    }

    /// The discontinuities inside (t_0, t_m), the ends of the support included.
    #[must_use]
    pub fn jumps(&self) -> &[Jump] {
        &self.features.jumps
    }

    /// Exactly one local maximum (`Conj3.1.strong`).
    #[must_use]
    pub fn strong(&self) -> bool {
        self.local_maxima().count() == 1
    }

    /// How often the supremum is attained; `None` as for [`weak`](Self::weak).
    #[must_use]
    pub fn maximisers(&self) -> Option<Attained> {
        attained(self.features.contenders.clone())
    }

    /// Is the supremum attained at exactly one x (`Conj3.1.weak`)? `None` if values at irrational points agree
    /// so closely that the limited refinement does not separate them, and neither is rational.
    #[must_use]
    pub fn weak(&self) -> Option<bool> {
        attained_once(self.features.contenders.clone())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::Place;
    use crate::scalar::{integer, rational};
    use crate::spline::{Basis, Index, KnotVector};

    fn shapes(degree: usize, knots: &[usize], index: &str) -> Vec<Shape> {
        let knots = KnotVector::new(knots.iter().map(|&t| integer(t)).collect()).unwrap();
        let basis = Basis::new(knots, degree, index.parse().unwrap()).unwrap();
        let pieces = Pieces::of(&basis);
        (0..=basis.n()).map(|i| Shape::of(&pieces, i)).collect()
    }

    fn maxima(shape: &Shape) -> Vec<Place> {
        shape.local_maxima().map(|extremum| extremum.place.clone()).collect()
    }

    #[test]
    fn ends_of_an_open_vector() {
        // x ↦ 1 − φ falls from 1 at 0, φ rises to 1 at 1: maxima at t_0 and t_m, and no jump.
        for index in ["inf", "-1", "2"] {
            let both = shapes(1, &[0, 0, 1, 1], index);
            for (shape, x) in both.iter().zip([0, 1]) {
                assert_eq!(maxima(shape), [Place::Point(integer(x))]);
                assert_eq!(shape.extrema()[0].value, (integer(1), integer(1)));
                assert!(shape.extrema()[0].at_knot);
                assert!(shape.jumps().is_empty());
                assert!(shape.strong() && shape.weak() == Some(true));
            }
        }
    }

    #[test]
    fn a_rise_before_a_jump_has_no_maximum() {
        let all = shapes(1, &[0, 0, 1, 1, 2], "2");
        let jumps = [Jump { at: integer(1), left: integer(1), right: integer(0) }];
        assert_eq!((maxima(&all[1]), all[1].jumps()), (vec![], &jumps[..]));
        assert!(!all[1].strong());
        assert_eq!(all[1].weak(), Some(false));
        // The next one jumps up and falls: its maximum is attained.
        assert_eq!(maxima(&all[2]), [Place::Point(integer(1))]);
        assert_eq!(all[2].weak(), Some(true));
    }

    #[test]
    fn plateaus() {
        // Degree 0: half-open intervals, and a closed one at t_m.
        let all = shapes(0, &[0, 1, 2], "2");
        let plateau = |from, to, closed| Place::Plateau { from: integer(from), to: integer(to), closed };
        assert_eq!(maxima(&all[0]), [plateau(0, 1, false)]);
        assert_eq!(maxima(&all[1]), [plateau(1, 2, true)]);
        for shape in &all {
            assert!(shape.strong());
            assert_eq!(shape.weak(), Some(false));
        }
        // A function without any support.
        let empty = &shapes(0, &[0, 1, 1, 2], "2")[1];
        assert!(empty.extrema().is_empty() && !empty.strong());
        assert_eq!(empty.weak(), Some(false));
    }

    #[test]
    fn the_quadratic_b_spline_and_its_rational_relatives() {
        let [shape] = &shapes(2, &[0, 1, 2, 3, 3], "inf")[..1] else { panic!("one") };
        assert_eq!(maxima(shape), [Place::Point(rational(3, 2))]);
        assert_eq!(shape.extrema()[0].value, (rational(3, 4), rational(3, 4)));
        assert!(!shape.extrema()[0].at_knot);
        // Bernstein: B_1² = 2w(1 − w) is largest where w = 1/2, that is u = 1/r.
        let bernstein = &shapes(2, &[0, 0, 0, 1, 1, 1], "-1")[1];
        assert_eq!(maxima(bernstein), [Place::Point(rational(2, 3))]);
        assert_eq!(bernstein.extrema()[0].value, (rational(1, 2), rational(1, 2)));
        assert!(bernstein.strong() && bernstein.weak() == Some(true));
    }

    #[test]
    fn uniform_b_splines_are_largest_in_the_middle() {
        let basis = |k: usize| {
            let knots = KnotVector::new((0..=2 * k + 2).map(integer).collect()).unwrap();
            Basis::new(knots, k, Index::infinity()).unwrap()
        };
        for k in 1..=5 {
            let basis = basis(k);
            let pieces = Pieces::of(&basis);
            for i in 0..=basis.n() {
                // The uniform B-spline is largest in the middle of its support.
                let middle = Place::Point(rational(i64::try_from(2 * i + k + 1).unwrap(), 2));
                let shape = Shape::of(&pieces, i);
                assert_eq!(maxima(&shape), [middle]);
                assert!(shape.strong() && shape.weak() == Some(true));
            }
        }
    }
}
