//! The shape of a basis function: where it rises, falls, stays and jumps, exactly.

use num_bigint::BigInt;
use num_rational::BigRational;

use crate::scalar::integer;
use crate::spline::{Basis, HasWeights, Span};

use super::contenders::{Attained, attained, attained_once};
use super::extremum::{Extremum, ExtremumKind, Jump};
use super::local_knots::{LocalKnots, SpanQuotient};
use super::pieces::{Pieces, function_quotients};
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
/// use knotproof::analysis::{Pieces, Location, Shape};
/// use knotproof::scalar::integer;
/// use knotproof::spline::{Basis, Index, KnotVector};
///
/// let basis = Basis::new(KnotVector::new([0, 1, 2].map(integer).to_vec())?, 1, Index::infinity())?;
/// let hat = Shape::of(&Pieces::of(&basis), 0);
/// assert_eq!(hat.extrema().len(), 1);
/// assert_eq!(hat.extrema()[0].place, Location::Point(integer(1)));
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
                quotient: SpanQuotient::of(&on_span.function(i)),
            })
        });
        Self::in_basis(basis, i, segments)
    }

    /// The shape of G_i^k alone, without the pieces of the others.
    ///
    /// # Panics
    /// If i > n.
    #[must_use]
    pub fn of_function<W: HasWeights>(basis: &Basis<W>, i: usize) -> Self {
        let segment = |(span, quotient): (Span, SpanQuotient<BigInt>)| {
            let [start, end] = [span.index(), span.index() + 1].map(|j| basis.knots().t(j).clone());
            Segment { start, end, quotient }
        };
        Self::in_basis(basis, i, function_quotients(basis, i).into_iter().map(segment))
    }

    fn in_basis<W>(basis: &Basis<W>, i: usize, segments: impl Iterator<Item = Segment>) -> Self {
        let to = basis.support(i).1;
        let inside = to < basis.knots().last();
        let mut features = Profile::of(segments, inside).features();
        // At the ends of [t_0, t_m] there is nothing to be continuous with.
        features.jumps.retain(|jump| jump.at != *basis.knots().first() && jump.at != *basis.knots().last());
        Self { features }
    }

    /// The shape of a function alone: t_i = 0 and its gaps as they are, and 0 outside of its support.
    #[must_use]
    pub fn of_local(knots: &LocalKnots<BigInt>) -> Self {
        let mut end = integer(0);
        let segments = knots.gaps().iter().enumerate().filter_map(|(s, gap)| {
            let start = end.clone();
            end += gap;
            Some(Segment { start, end: end.clone(), quotient: knots.on_span(s)? })
        });
        Self { features: Profile::of(segments, true).features() }
    }

    /// The local maxima and minima, from left to right.
    #[must_use]
    pub fn extrema(&self) -> &[Extremum] {
        &self.features.extrema
    }

    /// The same without the jumps.
    #[must_use]
    pub fn into_extrema(self) -> Vec<Extremum> {
        self.features.extrema
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
    use crate::analysis::Location;
    use crate::scalar::{integer, rational};
    use crate::spline::{Index, KnotVector};

    fn shapes(degree: usize, knots: &[usize], index: &str) -> Vec<Shape> {
        let knots = KnotVector::new(knots.iter().map(|&t| integer(t)).collect()).unwrap();
        let basis = Basis::new(knots, degree, index.parse().unwrap()).unwrap();
        let pieces = Pieces::of(&basis);
        let shapes: Vec<_> = (0..=basis.n()).map(|i| Shape::of(&pieces, i)).collect();
        let alone: Vec<_> = (0..=basis.n()).map(|i| Shape::of_function(&basis, i)).collect();
        assert_eq!(shapes, alone);
        shapes
    }

    fn maxima(shape: &Shape) -> Vec<Location> {
        shape.local_maxima().map(|extremum| extremum.place.clone()).collect()
    }

    #[test]
    fn ends_of_an_open_vector() {
        // x ↦ 1 − φ falls from 1 at 0, φ rises to 1 at 1: maxima at t_0 and t_m, and no jump.
        for index in ["inf", "-1", "2"] {
            let both = shapes(1, &[0, 0, 1, 1], index);
            for (shape, x) in both.iter().zip([0, 1]) {
                assert_eq!(maxima(shape), [Location::Point(integer(x))]);
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
        assert_eq!(maxima(&all[2]), [Location::Point(integer(1))]);
        assert_eq!(all[2].weak(), Some(true));
    }

    #[test]
    fn plateaus() {
        // Degree 0: half-open intervals, and a closed one at t_m.
        let all = shapes(0, &[0, 1, 2], "2");
        let plateau = |from, to, closed| Location::Plateau { from: integer(from), to: integer(to), closed };
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
        assert_eq!(maxima(shape), [Location::Point(rational(3, 2))]);
        assert_eq!(shape.extrema()[0].value, (rational(3, 4), rational(3, 4)));
        assert!(!shape.extrema()[0].at_knot);
        // Bernstein: B_1² = 2w(1 − w) is largest where w = 1/2, that is u = 1/r.
        let bernstein = &shapes(2, &[0, 0, 0, 1, 1, 1], "-1")[1];
        assert_eq!(maxima(bernstein), [Location::Point(rational(2, 3))]);
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
                let middle = Location::Point(rational(i64::try_from(2 * i + k + 1).unwrap(), 2));
                let shape = Shape::of(&pieces, i);
                assert_eq!(maxima(&shape), [middle]);
                assert!(shape.strong() && shape.weak() == Some(true));
            }
        }
    }

    /// The function alone, by quotients that are not reduced, and in a basis, by those in lowest terms.
    #[test]
    fn a_function_alone_has_the_shape_that_it_has_in_a_basis() {
        for (gaps, (p, q)) in [
            (&[2, 1, 1, 0][..], (3, 5)),
            (&[0, 1, 1, 2], (5, 3)),
            (&[0, 5, 2, 1], (53, 100)),
            (&[1, 1, 1], (1, 1)),
            (&[1, 2], (1, 3)),
            (&[3], (1, 1)),
            (&[0, 1, 0], (2, 1)),
            (&[799, 51, 15552, 72, 2425, 9185], (46, 251)),
        ] {
            let k = gaps.len() - 1;
            let local = LocalKnots::new(gaps.iter().map(|&gap| gap.into()).collect(), (p.into(), q.into()));
            let mut alone = Shape::of_local(&local.unwrap());
            let mut knots = vec![integer(0); k + 1];
            knots.extend(gaps.iter().scan(0, |end, gap| {
                *end += gap;
                Some(integer(*end))
            }));
            // One knot more, so that the function ends inside.
            let last = &knots[knots.len() - 1] + integer(1);
            knots.extend(vec![last; k.max(1)]);
            let index = Index::from_ratio(rational(p, q.into())).unwrap();
            let basis = Basis::new(KnotVector::new(knots).unwrap(), k, index).unwrap();
            let whole = Shape::of(&Pieces::of(&basis), k);
            assert_eq!(alone.extrema().len(), whole.extrema().len());
            for (own, extremum) in alone.features.extrema.iter_mut().zip(whole.extrema()) {
                assert_eq!((own.kind, &own.place), (extremum.kind, &extremum.place), "{gaps:?}");
                assert_eq!(own.at_knot, extremum.at_knot);
                // Two enclosures of one number meet, and come closer.
                assert!(own.value.0 <= extremum.value.1 && extremum.value.0 <= own.value.1);
                while own.narrow() && own.value.1 != own.value.0 {
                    if &own.value.1 - &own.value.0 < rational(1, 1000) {
                        break;
                    }
                }
                assert!(&own.value.1 - &own.value.0 < rational(1, 1000));
                let (lo, hi) = own.place.interval();
                let (low, high) = extremum.place.interval();
                assert!(low <= lo && hi <= high);
            }
        }
    }
}
