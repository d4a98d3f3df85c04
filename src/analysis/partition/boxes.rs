//! Where the sign changes of N(·, t) can appear or vanish as t moves: boxes that show it.

use num_bigint::BigInt;
use num_traits::Zero;

use super::bernstein_table::{BernsteinTable, Signs};
use crate::analysis::sign::sign_changes;

/// A change in the sign changes of N(·, t) on (0, ∞), at one t of an interval at most.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PartitionEvent {
    /// N(0, t) changes its sign: a critical point passes the left end of the span.
    Start,
    /// The leading coefficient of N(·, t) changes its sign: a critical point passes the right end.
    End,
    /// Two critical points meet.
    Fold,
}

impl PartitionEvent {
    /// The same for the function with reversed knots.
    pub(super) fn reversed(self) -> Self {
        match self {
            Self::Start => Self::End,
            Self::End => Self::Start,
            Self::Fold => Self::Fold,
        }
    }
}

/// Which ends an interval of t has: the first and the last one may be left out.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Closed {
    pub(super) from: bool,
    pub(super) to: bool,
}

/// Which sides of a box in y are those of the span.
#[derive(Debug, Clone, Copy)]
struct Sides {
    start: bool,
    end: bool,
}

/// How the sign of N(y, t) on a line y = const runs with t.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Line {
    /// It is this one for every t of the interval, and never 0.
    Strict(Signs),
    /// N is 0 at one t at most.
    Crossing,
    /// Nothing is known.
    Unknown,
}

/// The events on the whole span for t in an interval: `None` if no subdivision in y up to the depth shows that
/// there is at most one.
///
/// Each box of a subdivision in y, between lines on which N is never 0, is one of these, for every t:
///
/// - N has one sign there;
/// - N rises or falls with y, and so has at most one sign change, as the signs on the two lines tell;
/// - by Descartes' rule the same follows from the signs of the coefficients;
/// - N and ∂²N/∂y² have opposite signs on the lines and inside: no zero;
/// - or the same signs, and ∂N/∂t has one: then the least |N|, with its sign, is strictly monotonic in t, and there
///   is one t at most where a pair of zeros appears or vanishes.
pub(super) fn events(table: &BernsteinTable, closed: Closed, depth: u32) -> Option<Vec<PartitionEvent>> {
    let mut found = Vec::new();
    search(table, closed, Sides { start: true, end: true }, depth, &mut found).then_some(found)
}

fn search(
    table: &BernsteinTable,
    closed: Closed,
    sides: Sides,
    depth: u32,
    found: &mut Vec<PartitionEvent>,
) -> bool {
    match events_in_box(table, closed, sides) {
        Some(event) => {
            found.extend(event);
            found.len() <= 1
        }
        None if depth == 0 => false,
        None => {
            let strict = |line: &[BigInt]| matches!(line_of(line, closed), Line::Strict(_));
            let Some((left, right)) = table.divided_in_y(strict) else { return false };
            search(&left, closed, Sides { end: false, ..sides }, depth - 1, found)
                && search(&right, closed, Sides { start: false, ..sides }, depth - 1, found)
        }
    }
}

/// `Some(None)` if nothing changes, `None` if that cannot be told.
fn events_in_box(table: &BernsteinTable, closed: Closed, sides: Sides) -> Option<Option<PartitionEvent>> {
    if table.signs().is_constant() {
        return Some(None);
    }
    let rows = table.rows();
    let (start, end) = (line_of(table.row(0), closed), line_of(table.row(rows.len() - 1), closed));
    let one_change_at_most = table.signs_of_y_derivative().is_constant() || descartes(rows, start, end);
    match (start, end) {
        (Line::Strict(_), Line::Strict(_)) if one_change_at_most => Some(None),
        (Line::Crossing, Line::Strict(_)) if sides.start && one_change_at_most => {
            Some(Some(PartitionEvent::Start))
        }
        (Line::Strict(_), Line::Crossing) if sides.end && one_change_at_most => {
            Some(Some(PartitionEvent::End))
        }
        (Line::Strict(sign), Line::Strict(other)) if sign == other => {
            let bend = table.signs_of_second_y_derivative();
            match bend {
                Signs::Mixed | Signs::Zero => None,
                bend if bend != sign => Some(None),
                _ if table.signs_of_t_derivative().is_constant() => Some(Some(PartitionEvent::Fold)),
                _ => None,
            }
        }
        _ => None,
    }
}

/// Do the signs on the lines decide, by Descartes' rule, for every t?
///
/// With lines of opposite signs: no more than one variation. With lines of one sign: none. With a line where the
/// sign changes: none in the coefficients without it. A coefficient whose sign depends on t makes no variation
/// between two of opposite signs.
fn descartes(rows: &[Vec<BigInt>], start: Line, end: Line) -> bool {
    let skipped = |line| usize::from(line == Line::Crossing);
    let (from, to) = (skipped(start), rows.len() - skipped(end));
    let Some(inner) = rows.get(from..to) else { return false };
    let mut variations = 0;
    let mut last = None;
    let mut pending = false;
    for signs in inner.iter().map(|row| Signs::of(row.iter())) {
        match signs {
            Signs::Zero => {}
            Signs::Mixed => pending = true,
            definite => {
                if last.is_some_and(|last| last != definite) {
                    variations += 1;
                } else if pending {
                    return false;
                }
                (last, pending) = (Some(definite), false);
            }
        }
    }
    let allowed = match (start, end) {
        (Line::Strict(start), Line::Strict(end)) => usize::from(start != end),
        _ => 0,
    };
    !pending && variations <= allowed
}

fn line_of(coefficients: &[BigInt], closed: Closed) -> Line {
    let zero_at_end = |end: Option<&BigInt>, closed| closed && end.is_none_or(Zero::is_zero);
    let zeros = usize::from(zero_at_end(coefficients.first(), closed.from))
        + usize::from(zero_at_end(coefficients.last(), closed.to));
    match (zeros + sign_changes(coefficients), coefficients.iter().find(|c| !c.is_zero())) {
        (_, None) => Line::Unknown,
        (0, Some(c)) if *c > BigInt::zero() => Line::Strict(Signs::Positive),
        (0, Some(_)) => Line::Strict(Signs::Negative),
        (1, _) => Line::Crossing,
        _ => Line::Unknown,
    }
}
