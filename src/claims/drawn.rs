//! A curve of the paper in the pieces of its basis, and what is asked of it in more than one illustration.

use crate::analysis::{Piece, SpanPieces, common_positive_roots};
use crate::scalar::{BigRational, Polynomial, RationalAlgebra, Ring};
use crate::spline::{Curve, Index, Point, Side};

use super::case::BasisCase;
use super::illustrations::case_of;
use super::instances::Instance;
use super::verdict::Ledger;

/// A curve of the paper with the pieces of its basis.
pub(super) struct Drawn {
    pub(super) case: BasisCase,
    pub(super) curve: Curve,
}

impl Drawn {
    pub(super) fn new(instance: &Instance, index: &Index) -> Self {
        let case = case_of(instance, index);
        match Curve::new(case.basis().clone(), instance.points.clone().unwrap_or_default()) {
            Ok(curve) => Self { case, curve },
            Err(error) => unreachable!("a test builds every instance: {error}"),
        }
    }

    /// The coordinates on a span, as functions of u.
    pub(super) fn on(&self, pieces: &SpanPieces) -> Vec<Piece> {
        self.curve.combine_unchecked(&pieces.functions)
    }

    /// The coordinates on all spans.
    pub(super) fn everywhere(&self) -> Vec<Vec<Piece>> {
        self.case.pieces().spans().iter().map(|pieces| self.on(pieces)).collect()
    }

    /// Does the curve, which must be plane, pass through the point, for some x of [t_0, t_m]?
    pub(super) fn passes_through(&self, point: &Point, ledger: &mut Ledger) -> bool {
        let numerators = |pieces: &SpanPieces| -> Vec<Polynomial<BigRational>> {
            let coordinates = self.on(pieces);
            coordinates.iter().zip(point).map(|(c, p)| c.minus(&c.embed(p)).numerator().clone()).collect()
        };
        let spans = self.case.pieces().spans();
        let inside = spans.iter().any(|pieces| match numerators(pieces).as_slice() {
            [x, y] => common_positive_roots(x, y).exist(),
            _ => false,
        });
        // The limit from the left of t_0 is that of no curve.
        let knots = self.case.knots();
        let meets = |t: &BigRational, side| self.curve.point(t, side) == *point;
        let at_knots = knots
            .stop_knots()
            .any(|(t, _)| meets(t, Side::Right) || (t != knots.first() && meets(t, Side::Left)));
        // Both decisions are exact; the ledger counts that there are no such points.
        !ledger.count(usize::from(inside || at_knots), 0)
    }
}

/// The square of the length of a vector; `None` if it has no coordinates.
pub(super) fn squared_length(vector: &[Piece]) -> Option<Piece> {
    vector.iter().map(|c| c.times(c)).reduce(|sum, square| sum.plus(&square))
}

/// (x, y, …) in parentheses.
pub(super) fn show(point: &[BigRational]) -> String {
    let coordinates: Vec<_> = point.iter().map(ToString::to_string).collect();
    format!("({})", coordinates.join(", "))
}

/// The index of a witness, under its name.
pub(super) fn alpha(index: &Index) -> (&'static str, String) {
    ("α", index.to_string())
}
