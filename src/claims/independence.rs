//! Linear independence, and the Bernstein case.

use crate::analysis::{Pieces, coefficient_rows, in_span, rank};
use crate::scalar::{BigRational, RationalAlgebra, Ring, integer};
use crate::spline::{Basis, KnotVector, Side, bernstein, binomial, weight};

use super::basis::name;
use super::case::{BasisCase, definition_values};
use super::cause::Cause;
use super::claim::{Claim, Form};
use super::hypothesis::Hypothesis::{Bernstein, DegreeAtLeast, InteriorMultiplicityAtMostDegree, Open};
use super::statement::Statement;
use super::verdict::{Judgement, Ledger, Stop};

/// Row i: the coefficients of G_i^k on all spans.
fn rows_of(pieces: &Pieces, n: usize) -> Vec<Vec<BigRational>> {
    coefficient_rows(pieces.spans().iter().map(|span| (0..=n).map(|i| span.function(i)).collect()))
}

/// The rank of the coefficient rows is n + 1.
pub(super) fn independence(case: &BasisCase, ledger: &mut Ledger) -> Judgement {
    let rows = rows_of(case.pieces(), case.n());
    if ledger.count(rank(&rows), rows.len()) {
        return Ok(());
    }
    let dependent = (0..rows.len()).find_map(|i| Some((i, in_span(&rows[..i], &rows[i])?)));
    let Some((i, coefficients)) = dependent else {
        return Err(Stop::Fault("rows of less than full rank, and none depends on the others".into()));
    };
    let terms: Vec<_> = coefficients
        .iter()
        .enumerate()
        .filter(|(_, c)| !c.is_zero())
        .map(|(j, c)| format!("({c})·{}", name(case.k(), j)))
        .collect();
    let sum = if terms.is_empty() { "0".to_owned() } else { terms.join(" + ") };
    let found = format!("{} = {sum} everywhere", name(case.k(), i));
    Err(case.refuted([("i", i.to_string())], "the functions are linearly independent".into(), found))
}

/// B_i^k = w B_{i−1}^{k−1} + (1 − w) B_i^{k−1} on [a, b), and if `closed` at b, with the functions of degree k − 1 on
/// their own knots; `shift` is how far the first index lags behind i, 1 in the claim.
fn bernstein_recurrence(shift: usize, closed: bool) -> impl Fn(&BasisCase, &mut Ledger) -> Judgement {
    move |case, ledger| {
        let (a, b, k) = (case.knots().first(), case.knots().last(), case.k());
        let lower = KnotVector::bernstein(k - 1, a, b)
            .ok()
            .and_then(|knots| Basis::new(knots, k - 1, case.basis().index().clone()).ok());
        let Some(lower) = lower else {
            return Err(Stop::Fault("no Bernstein basis of degree k − 1".into()));
        };
        let (basis_below, pieces, lower) = (&lower, case.pieces(), Pieces::of(&lower));
        let (Some(span), Some(lower)) = (pieces.spans().first(), lower.spans().first()) else {
            return Ok(());
        };
        let (w, complement) = weight(&span.x.embed(case.basis().index().ratio()), &span.x, a, b);
        for i in 0..=k {
            let previous = i.checked_sub(shift).map_or_else(|| pieces.zero(), |i| lower.function(i));
            let claimed = w.times(&previous).plus(&complement.times(&lower.function(i)));
            if !ledger.equal(&span.function(i), &claimed) {
                return Err(case.locate(span.span, |x| {
                    let value = case.values(x, Side::Right)[i].clone();
                    let u = crate::analysis::coordinate_of(case.knots(), span.span, x).ok()??;
                    let claimed = claimed.evaluate(&u)?;
                    (value != claimed).then(|| {
                        let at = [("i", i.to_string()), ("x", x.to_string())];
                        let b = format!("B_{i}^{k}({x})");
                        case.witness(at, format!("{b} = {claimed}"), format!("{b} = {value}"))
                    })
                }));
            }
        }
        if closed {
            // w(b) = 0, so that the right side is B_i^{k−1}(b).
            let mut below = definition_values(basis_below, b, Side::Left);
            below.push(integer(0));
            at_the_end(case, &below, ledger)?;
        }
        Ok(())
    }
}

/// At b, where the weight of D2.3 is 0 and the value of B_i^k is the limit from the left: B_i^k(b) against the right side.
fn at_the_end(case: &BasisCase, right: &[BigRational], ledger: &mut Ledger) -> Judgement {
    let (b, k) = (case.knots().last(), case.k());
    for (i, (value, claimed)) in case.values(b, Side::Left).iter().zip(right).enumerate() {
        if !ledger.equal(value, claimed) {
            let at = [("i", i.to_string()), ("x", b.to_string())];
            let name = format!("B_{i}^{k}({b})");
            let claimed = format!("{name} = {claimed}, since w({b}) = 0");
            return Err(case.refuted(at, claimed, format!("{name} = {value}")));
        }
    }
    Ok(())
}

/// B_i^k = coefficient(k, i) w^i (1 − w)^{k−i} on [a, b), and if `closed` at b.
fn closed_form(
    coefficient: fn(usize, usize) -> BigRational,
    closed: bool,
) -> impl Fn(&BasisCase, &mut Ledger) -> Judgement {
    move |case, ledger| {
        let (a, b, k) = (case.knots().first(), case.knots().last(), case.k());
        let Some(span) = case.pieces().spans().first() else { return Ok(()) };
        let (w, complement) = weight(&span.x.embed(case.basis().index().ratio()), &span.x, a, b);
        for i in 0..=k {
            let factor = coefficient(k, i) / binomial(k, i);
            let claimed =
                bernstein(k, i, (&w, &complement)).times(&crate::analysis::constant(factor.clone()));
            if !ledger.equal(&span.function(i), &claimed) {
                return Err(case.locate(span.span, |x| {
                    let value = case.values(x, Side::Right)[i].clone();
                    let (w, complement) = weight(case.basis().index().ratio(), x, a, b);
                    let claimed = bernstein(k, i, (&w, &complement)) * &factor;
                    (value != claimed).then(|| {
                        let at = [("i", i.to_string()), ("x", x.to_string())];
                        let b = format!("B_{i}^{k}({x})");
                        case.witness(at, format!("{b} = {claimed}"), format!("{b} = {value}"))
                    })
                }));
            }
        }
        if closed {
            let (w, complement) = (integer(0), integer(1));
            let right: Vec<_> = (0..=k)
                .map(|i| bernstein(k, i, (&w, &complement)) * coefficient(k, i) / binomial(k, i))
                .collect();
            at_the_end(case, &right, ledger)?;
        }
        Ok(())
    }
}

/// The claims of P3.2 and P3.3.
pub(super) fn claims() -> Vec<Claim> {
    vec![
        Claim::new(
            "P3.2",
            "Proposition 3.2",
            Form::Basis(
                Statement::new(
                    "Open U, interior multiplicities ≤ k: the G_i^k are linearly independent on [t_0, t_m].",
                    independence,
                )
                .given([Open, InteriorMultiplicityAtMostDegree]),
            ),
        ),
        Claim::new(
            "P3.3.1",
            "Proposition 3.3 (1)",
            Form::Basis(
                Statement::new(
                    "Open U without interior knots, on [a,b]: B_i^k = w B_{i−1}^{k−1} + (1−w) B_i^{k−1}.",
                    bernstein_recurrence(1, true),
                )
                .given([Bernstein, DegreeAtLeast(1)]),
            ),
        )
        .fails_by(Cause::EndPoints)
        .amended(Form::Basis(
            Statement::new("The same on [a,b).", bernstein_recurrence(1, false))
                .given([Bernstein, DegreeAtLeast(1)]),
        ))
        .note("At b the functions have their limits from the left, as everywhere, and w is 0 by D2.3. With the limit 1 for w as well it would be true there; and with D3.3 to the letter, by which all functions are 0 at b, it says 0 = 0."),
        Claim::new(
            "P3.3.2",
            "Proposition 3.3 (2)",
            Form::Basis(
                Statement::new(
                    "Open U without interior knots, on [a,b]: B_i^k = C(k,i) w^i (1−w)^{k−i}.",
                    closed_form(binomial, true),
                )
                .given([Bernstein]),
            ),
        )
        .fails_by(Cause::EndPoints)
        .amended(Form::Basis(
            Statement::new("The same on [a,b).", closed_form(binomial, false)).given([Bernstein]),
        ))
        .note("At b, where w is 0 by D2.3, B_0^k is 0 for k ≥ 1, by D3.3 to the letter and as a limit from the left, and the right side is 1. With the limit 1 for w it would be true there."),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::claims::small_cases::refuted;

    #[test]
    fn false_variants_are_refuted() {
        let given = [Bernstein, DegreeAtLeast(1)];
        assert!(refuted(closed_form(|k, i| binomial(k, i + 1), false), given), "C(k, i + 1)");
        assert!(refuted(bernstein_recurrence(0, false), given), "B_i for B_{{i−1}}");
        assert!(refuted(independence, [Open]), "independence for any multiplicity");
    }
}
