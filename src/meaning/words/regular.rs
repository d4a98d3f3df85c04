//! Words about what exists: values, quotients without poles, derivatives.

use crate::analysis::{Piece, sign_pattern};
use crate::language::Real;
use crate::scalar::integer;

use super::super::reading::Reading;
use super::super::truth::Stop;
use super::Expression;
use super::trace::on_cells;

/// Has the term a value?
pub(super) fn defined(own: &mut Reading<'_>, t: &Real) -> Result<bool, Stop> {
    match own.real(t) {
        Ok(_) => Ok(true),
        Err(Stop::Undefined(_)) => Ok(false),
        Err(stop) => Err(stop),
    }
}

/// Is the expression a quotient of polynomials without a pole between the ends of its interval, and finite at them?
pub(super) fn rational(own: &mut Reading<'_>, of: Expression<'_>) -> Result<bool, Stop> {
    let finite = |f: &Piece| f.evaluate(&integer(0)).is_some() && f.at_infinity().is_some();
    Ok(piece(own, of)?.is_none_or(|f| finite(&f) && !has_pole(&f)))
}

/// Has the expression derivatives of all orders between the ends of its interval? A quotient without a pole has.
pub(super) fn smooth(own: &mut Reading<'_>, of: Expression<'_>) -> Result<bool, Stop> {
    Ok(piece(own, of)?.is_none_or(|f| !has_pole(&f)))
}

/// The quotient that the expression is on an interval without knots inside; `None` if it is empty.
fn piece(own: &mut Reading<'_>, of: Expression<'_>) -> Result<Option<Piece>, Stop> {
    let mut pieces = on_cells(own, of)?;
    let last = pieces.pop();
    if pieces.is_empty() {
        Ok(last.map(|(_, f)| f))
    } else {
        Err(Stop::Unknown("an interval with knots inside".into()))
    }
}

fn has_pole(f: &Piece) -> bool {
    !sign_pattern(f.denominator()).roots().is_empty()
}
