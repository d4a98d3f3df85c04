//! Words about an expression along an interval: its changes of sign.

use crate::analysis::{Piece, Sign, sign_pattern};
use crate::language::{Interval, Name};
use crate::scalar::Ring;

use super::super::cell::Cell;
use super::super::reading::{Reading, find};
use super::super::truth::Stop;
use super::super::value::Value;
use super::Expression;

/// The cells of an interval, or of (t_0, t_m).
fn cells(own: &mut Reading<'_>, interval: Option<&Interval>) -> Result<Vec<Cell>, Stop> {
    match interval {
        Some(interval) => own.cells(interval),
        None => {
            let knots = own.knots()?;
            Ok(own.line(Some(knots.first()), Some(knots.last())))
        }
    }
}

/// The expression on each open cell, with the span that the cell is.
pub(super) fn on_cells(
    own: &mut Reading<'_>,
    (t, name, interval): Expression<'_>,
) -> Result<Vec<(Option<usize>, Piece)>, Stop> {
    let cells = cells(own, interval)?;
    let open = cells.iter().filter(|cell| matches!(cell, Cell::Open(..)));
    let read = |cell: &Cell| {
        own.within(name, cell, |own| {
            let span = own.frame.as_ref().and_then(|frame| frame.span);
            match own.real(t)? {
                Value { plain, root: None } => Ok((span, (*plain.piece()).clone())),
                Value { .. } => Err(Stop::Unknown("an expression with a square root".into())),
            }
        })
    };
    open.map(read).collect()
}

fn changes_of(signs: impl IntoIterator<Item = Sign>) -> usize {
    let signs: Vec<_> = signs.into_iter().filter(|sign| *sign != Sign::Zero).collect();
    signs.windows(2).filter(|pair| pair[0] != pair[1]).count()
}

/// Sign changes of an expression from left to right, zeros left out.
pub(super) fn changes(own: &mut Reading<'_>, (t, name, interval): Expression<'_>) -> Result<usize, Stop> {
    let mut signs = Vec::new();
    for cell in cells(own, interval)? {
        let each = own.within(name, &cell, |own| {
            let mut sign = |own: &mut Reading<'_>| {
                let sign = own.real(t).and_then(|value| own.sign(&value));
                let mixed = sign == Err(Stop::Cut);
                (sign, mixed)
            };
            if matches!(cell, Cell::Point(_)) {
                vec![sign(own).0]
            } else {
                own.by_parts(&mut sign).into_iter().map(|(_, sign)| sign).collect()
            }
        });
        for sign in each {
            signs.push(sign?);
        }
    }
    Ok(changes_of(signs))
}

/// How often an expression falls inside a cell of its interval and then rises again.
pub(super) fn valleys(own: &mut Reading<'_>, of: Expression<'_>) -> Result<usize, Stop> {
    let cells = on_cells(own, of)?;
    let turns = |f: &Piece| {
        let slope = f.derivative();
        let pattern = sign_pattern(&slope.numerator().times(slope.denominator()));
        pattern.changes().filter(|(before, ..)| *before == Sign::Negative).count()
    };
    match cells.as_slice() {
        [(_, piece)] => Ok(turns(piece)),
        [] => Ok(0),
        _ => Err(Stop::Unknown("an interval with knots inside".into())),
    }
}

/// Sign changes of control values, zeros left out.
pub(super) fn polygon_changes(own: &mut Reading<'_>, name: &Name) -> Result<usize, Stop> {
    let points = find(&own.bound.points, name)?;
    own.seen.add(0..points.len());
    Ok(changes_of(points.iter().map(Sign::of)))
}
