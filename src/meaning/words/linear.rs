//! Words about linear relations between functions.

use crate::analysis::{Piece, coefficient_rows, in_span, rank};
use crate::language::Int;
use crate::scalar::BigRational;

use super::super::reading::{Reading, place};
use super::super::truth::Stop;
use super::Expression;
use super::trace::on_cells;

/// The pieces of all functions of a degree on the spans that are wanted.
fn functions(
    own: &mut Reading<'_>,
    d: &Int,
    wanted: impl Fn(usize) -> bool,
) -> Result<Vec<(usize, Vec<Piece>)>, Stop> {
    let (d, k, m) = (own.int(d)?, own.degree()?, own.knots()?.m());
    let d = place(d, k + 1, || format!("there are no functions of degree {d}"))?;
    let pieces = own.on.pieces(&own.weights, d).ok_or_else(|| Stop::Unknown("too few knots".into()))?;
    let spans = pieces.spans().iter().filter(|on| wanted(on.span.index()));
    Ok(spans.map(|on| (on.span.index(), (0..m - d).map(|i| on.function(i)).collect())).collect())
}

/// The dimension of the span of the functions of a degree on [t_0, t_m].
pub(super) fn rank_of(own: &mut Reading<'_>, d: &Int) -> Result<usize, Stop> {
    let spans = functions(own, d, |_| true)?;
    Ok(rank(&coefficient_rows(spans.into_iter().map(|(_, pieces)| pieces))))
}

/// Is the expression one combination of the functions of the degree on all spans of the interval?
pub(super) fn combination(own: &mut Reading<'_>, of: Expression<'_>, d: &Int) -> Result<bool, Stop> {
    let target = on_cells(own, of)?;
    let all = functions(own, d, |j| target.iter().any(|(other, _)| *other == Some(j)))?;
    let mut spans = Vec::new();
    for (j, piece) in target {
        let own = j.and_then(|j| all.iter().find(|(other, _)| *other == j));
        let (_, functions) =
            own.ok_or_else(|| Stop::Unknown("an interval that does not consist of spans".into()))?;
        spans.push([functions.as_slice(), &[piece]].concat());
    }
    let mut rows: Vec<Vec<BigRational>> = coefficient_rows(spans);
    Ok(rows.pop().is_none_or(|target| in_span(&rows, &target).is_some()))
}
