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

#[cfg(test)]
mod tests {
    use crate::language::one_line;
    use crate::meaning::{Instance, Names, Truth, decide};
    use crate::scalar::integer;
    use crate::spline::{Basis, Index, KnotVector};

    fn truth(text: &str) -> Truth {
        let sentence = one_line(&format!("k; U : {text}")).unwrap();
        let knots = KnotVector::new([0, 0, 1, 1, 2].map(integer).to_vec()).unwrap();
        let index = Index::from_alpha(integer(-1)).unwrap();
        decide(&sentence, &Instance::of(Basis::new(knots, 1, index).unwrap()), Names::empty()).into()
    }

    #[test]
    fn poles_at_the_ends_matter_to_quotients_only() {
        assert_eq!(truth("rational(G[1](x), x in (t[1], t[2]))"), Truth::True);
        assert_eq!(truth("rational(1/x, x in (t[1], t[2]))"), Truth::False);
        assert_eq!(truth("smooth(1/x, x in (t[1], t[2]))"), Truth::True);
        assert_eq!(truth("smooth(1/x, x in (t[0], t[1]))"), Truth::True, "of an empty interval");
        assert!(matches!(truth("smooth(G[1](x), x in (t[1], t[4]))"), Truth::Unknown(_)));
    }

    #[test]
    fn what_does_not_exist_is_told() {
        assert_eq!(truth("defined(G[1](t[m]-))"), Truth::True);
        assert_eq!(truth("not defined(1/(t[1] - t[0])) and not defined(t[m+1])"), Truth::True);
    }

    #[test]
    fn stop_knots_rise_and_have_multiplicities() {
        assert_eq!(truth("stops() = 3 and stop(0) = 0 and stop(1) = 1 and stop(2) = 2"), Truth::True);
        assert_eq!(truth("sum(i in 0..stops()-1: mult(stop(i))) = m + 2"), Truth::False);
        assert!(matches!(truth("stop(3) = 2"), Truth::Undefined(_)));
    }
}
