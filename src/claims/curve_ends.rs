//! What the paper says of t_m after Proposition 3.1, and of tangents at the ends before the formulas of
//! Proposition 4.2 (2).

use crate::analysis::Piece;
use crate::scalar::{BigRational, Ring, integer};
use crate::spline::Side;

use super::basis::name;
use super::case::BasisCase;
use super::cause::Cause;
use super::claim::{Claim, Form};
use super::hypothesis::Hypothesis::{self, DegreeAtLeast, FirstSpan, LastSpan, Open};
use super::statement::Statement;
use super::verdict::{Judgement, Ledger, Stop};

/// Every function has a limit from the left at t_m; `by_definition`: and it is the value there, which is 0.
fn has_limit(by_definition: bool) -> impl Fn(&BasisCase, &mut Ledger) -> Judgement {
    move |case, ledger| {
        let Some(last) = case.pieces().spans().last() else { return Ok(()) };
        let end = case.knots().last();
        let values = case.values(end, Side::Left);
        for (i, value) in values.iter().enumerate() {
            let g = name(case.k(), i);
            let limit = last.function(i).at_infinity();
            if !ledger.count(usize::from(limit.is_some()), 1) {
                let found = "it has a pole there".into();
                return Err(case.refuted_on_the_left(i, end, format!("{g} has a limit at {end}"), found));
            }
            if limit.as_ref() != Some(value) {
                return Err(Stop::Fault(format!("two limits of {g} at {end}: {limit:?} and {value}")));
            }
            if by_definition && !ledger.equal(value, &integer(0)) {
                let claimed = format!("{g} → 0 at {end}, its value by D3.3");
                return Err(case.refuted_on_the_left(i, end, claimed, format!("the limit is {value}")));
            }
        }
        Ok(())
    }
}

/// The derivative at t_0 is not 0, for the polygon d_0 = d_1 ≠ d_2 = … = d_n, which is one segment.
fn moves_at_once(case: &BasisCase, ledger: &mut Ledger) -> Judgement {
    if case.n() < 2 {
        return Ok(());
    }
    let (start, n) = (case.knots().first(), case.n());
    let slopes = case.basis().jets(start, Side::Right, 1);
    let slope: BigRational = slopes.iter().skip(2).map(|jet| &jet.coefficients()[1]).sum();
    if ledger.differ(&slope, &integer(0)) {
        return Ok(());
    }
    let rest = if n == 2 { "d_2 = 1".to_owned() } else { format!("d_2 = … = d_{n} = 1") };
    let at = [("d", format!("d_0 = d_1 = 0, {rest}")), ("x", start.to_string())];
    let claimed = "the curve has a tangent along its polygon there: a derivative that is not 0".into();
    Err(case.refuted(at, claimed, "the derivative is 0".into()))
}

/// The order at u = 0 of a function with positive lowest coefficient; `None` if that is not positive, or there is none.
fn order(g: &Piece, ledger: &mut Ledger) -> Option<usize> {
    let lowest = |coefficients: &[BigRational]| coefficients.iter().position(|c| !c.is_zero());
    let (p, q) = (g.numerator().coefficients(), g.denominator().coefficients());
    let (top, bottom) = (lowest(p)?, lowest(q)?);
    let positive = ledger.less(&integer(0), &(&p[top] * &q[bottom]));
    positive.then(|| top.checked_sub(bottom)).flatten()
}

/// For i ≤ k the order of G_i at t_0 is order(i), which is i in the claim, and that of G_{n−i} at t_m likewise, all with
/// positive factors. So if d_0 = … = d_{i−1}, the curve leaves d_0 along d_i − d_0.
fn leaves_along_first_leg(expected: fn(usize) -> usize) -> impl Fn(&BasisCase, &mut Ledger) -> Judgement {
    move |case, ledger| {
        let spans = case.pieces().spans();
        let (Some(first), Some(last)) = (spans.first(), spans.last()) else { return Ok(()) };
        for i in 0..=case.k() {
            let functions =
                [(i, first.function(i)), (case.n() - i, last.function(case.n() - i).reciprocal_argument())];
            for (i_there, g) in functions {
                let found = order(&g, ledger);
                if !ledger.count(found.unwrap_or(usize::MAX), expected(i)) {
                    let claimed = format!(
                        "at its end of the knots {} has the order {}",
                        name(case.k(), i_there),
                        expected(i)
                    );
                    let found =
                        found.map_or_else(|| "it has none".to_owned(), |found| format!("it has {found}"));
                    return Err(case.refuted_at_large([("i", i_there.to_string())], claimed, found));
                }
            }
        }
        Ok(())
    }
}

/// The sentence after Proposition 3.1.
pub(super) fn limits() -> Vec<Claim> {
    vec![Claim::new(
        "P3.1.extension",
        "after Proposition 3.1",
        Form::Basis(Statement::new(
            "Every G_i^k admits a continuous extension at t_m: it has a limit from the left there.",
            has_limit(false),
        )),
    )]
}

/// The first sentence of Proposition 4.2 (2).
pub(super) fn tangents() -> Vec<Claim> {
    const ENDS: [Hypothesis; 4] = [Open, DegreeAtLeast(1), FirstSpan, LastSpan];
    vec![
        Claim::new(
            "P4.2.tangent",
            "Proposition 4.2 (2)",
            Form::Basis(
                Statement::new(
                    "The curve of every control polygon that is no single point is tangent to it at the ends: G_α′(t_0) is not 0 and along the polygon, and so is G_α′(t_m).",
                    moves_at_once,
                )
                .given(ENDS),
            ),
        )
        .amended(Form::Basis(
            Statement::new(
                "If d_1 ≠ d_0, G_α′(t_0) is a positive multiple of d_1 − d_0. More generally, if d_0 = … = d_{i−1} ≠ d_i with i ≤ k, the curve leaves d_0 along d_i − d_0, the first leg that is no point. The same at t_m, with d_n, d_{n−1}, ….",
                leaves_along_first_leg(|i| i),
            )
            .given(ENDS),
        ))
        .fails_by(Cause::VagueWords)
        .note("That an end knot occurs k + 1 times only is assumed here: see P4.2.2. The formulas of P4.2.2 are true for d_1 = d_0 as well, but then they give the vector 0, and no tangent; and if d_0 = … = d_k, the curve rests in d_0."),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::claims::small_cases::refuted;

    #[test]
    fn false_variants_are_refuted() {
        const ENDS: [Hypothesis; 4] = [Open, DegreeAtLeast(1), FirstSpan, LastSpan];
        assert!(refuted(has_limit(true), []), "the value 0 by D3.3 is the limit");
        assert!(refuted(moves_at_once, ENDS.into_iter().chain([DegreeAtLeast(2)])), "also for k ≥ 2");
        assert!(refuted(leaves_along_first_leg(|i| i.min(1)), ENDS), "all functions but G_0 with order 1");
        assert!(refuted(leaves_along_first_leg(|i| i), [Open]), "end knots k + 2 times");
    }
}
