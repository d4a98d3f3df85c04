//! What the span of a basis can approximate, what it contains, and how well its coefficients are determined.

use crate::analysis::{Pieces, always_nonnegative, coefficient_rows, in_span, is_combination};
use crate::scalar::{BigRational, RationalAlgebra, Ring, integer, rational};
use crate::spline::{Basis, KnotVector, Side, bernstein, binomial, weight};

use super::basis::name;
use super::case::{BasisCase, Case};
use super::cause::Cause;
use super::claim::{Claim, Form};
use super::closeness::base_spans;
use super::hypothesis::Hypothesis::{
    Bernstein, DegreeAtLeast, FiniteIndex, FirstSpan, InnerMultiplicityAtMostDegree, LastSpan, Open,
};
use super::statement::Statement;
use super::verdict::{Judgement, Ledger, Stop};

/// On every span of [t_k, t_{n+1}] the function x is no combination of the basis; and the functions for the knots
/// `scale`·t_i are the same functions of the span's own coordinate, as they have to be for the distance of x to be a
/// multiple of the scale.
fn order_one(case: &BasisCase, ledger: &mut Ledger) -> Judgement {
    let scale = rational(1, 3);
    let scaled = KnotVector::new(case.knots().knots().iter().map(|t| t * &scale).collect()).ok();
    let basis = |knots| Basis::new(knots, case.k(), case.basis().index().clone()).ok();
    let Some(scaled) = scaled.and_then(basis) else {
        return Err(Stop::Fault("scaled knots are no knots".into()));
    };
    let scaled = Pieces::of(&scaled);
    for pieces in base_spans(case) {
        let (start, end) = pieces.ends();
        let found = usize::from(is_combination(pieces.functions.values(), &pieces.x));
        if !ledger.count(found, 0) {
            let claimed = "x is no combination of the functions that live there".to_owned();
            return Err(case.refuted([("span", format!("[{start}, {end})"))], claimed, "it is one".into()));
        }
        for (i, g) in pieces.functions.iter() {
            let same = scaled.spans().iter().find(|scaled| scaled.span.index() == pieces.span.index());
            let same = same.map(|scaled| scaled.function(i));
            if !same.is_some_and(|same| ledger.equal(g, &same)) {
                return Err(Stop::Fault(format!("{} depends on the scale", name(case.k(), i))));
            }
        }
    }
    Ok(())
}

/// Every knot once more.
fn raised(knots: &KnotVector) -> KnotVector {
    knots.stop_knots().fold(knots.clone(), |raised, (t, _)| raised.with_knot(t))
}

/// The first function that is no combination of those of degree k + 1 on the raised knots.
fn not_elevated(case: &BasisCase, ledger: &mut Ledger) -> Result<Option<usize>, Stop> {
    let higher = Basis::new(raised(case.knots()), case.k() + 1, case.basis().index().clone());
    let Ok(higher) = higher else { return Err(Stop::Fault("too few raised knots".into())) };
    let (pieces, count) = (Pieces::of(&higher), higher.n() + 1);
    // Both have the same spans that are not empty, with the same coordinate.
    let both = pieces.spans().iter().zip(case.pieces().spans());
    let rows = coefficient_rows(both.map(|(fine, coarse)| {
        let own = (0..=case.n()).map(|i| coarse.function(i));
        (0..count).map(|i| fine.function(i)).chain(own).collect()
    }));
    let (basis, functions) = rows.split_at(count);
    for (i, function) in functions.iter().enumerate() {
        if in_span(basis, function).is_none() {
            return Ok(Some(i));
        }
        _ = ledger.count(1, 1);
    }
    Ok(None)
}

/// Degree elevation.
fn elevates(case: &BasisCase, ledger: &mut Ledger) -> Judgement {
    match not_elevated(case, ledger)? {
        None => Ok(()),
        Some(i) => {
            let claimed = format!(
                "{} is a combination of the functions of degree {} on {}",
                name(case.k(), i),
                case.k() + 1,
                raised(case.knots())
            );
            Err(case.refuted_at_large([("i", i.to_string())], claimed, "it is none".into()))
        }
    }
}

/// It is possible exactly if every interior knot has a multiplicity ≥ least(k), which is k in the claim.
fn elevates_exactly(least: fn(k: usize) -> usize) -> impl Fn(&BasisCase, &mut Ledger) -> Judgement {
    move |case, ledger| {
        let (knots, k) = (case.knots(), case.k());
        let expected = knots.interior(k).iter().all(|t| knots.multiplicity(t) >= least(k));
        let found = not_elevated(case, ledger)?;
        if ledger.count(usize::from(found.is_none()), usize::from(expected)) {
            return Ok(());
        }
        let words = |possible| if possible { "it is possible" } else { "it is not possible" }.to_owned();
        Err(case.refuted_at_large([], words(expected), words(found.is_none())))
    }
}

/// The coefficients of Chebyshev's polynomial T_k(2w − 1) in the Bernstein basis: (−1)^(k−i) C(2k, 2i)/C(k, i).
fn chebyshev(k: usize) -> Vec<BigRational> {
    let coefficient = |i: usize| {
        let size = binomial(2 * k, 2 * i) / binomial(k, i);
        if (k - i).is_multiple_of(2) { size } else { -size }
    };
    (0..=k).map(coefficient).collect()
}

/// |Σ c_i G_i| ≤ 1 everywhere.
fn stays_within_one(case: &BasisCase, c: &[BigRational], ledger: &mut Ledger) -> bool {
    case.pieces().spans().iter().all(|pieces| {
        let terms = pieces.functions.iter().map(|(i, g)| g.times(&g.embed(&c[i])));
        let f = terms.fold(case.pieces().zero(), |sum, term| sum.plus(&term));
        [case.pieces().one().minus(&f), case.pieces().one().plus(&f)]
            .iter()
            .all(|f| ledger.count(usize::from(always_nonnegative(f).holds()), 1))
    })
}

/// |c_i| ≤ max |Σ c_i G_i| for all coefficients. Where the values at the knots are the coefficients, it is so; on an interval
/// without knots inside, Chebyshev's polynomial shows that it is not.
fn well_conditioned(case: &BasisCase, ledger: &mut Ledger) -> Judgement {
    if case.k() == 1 {
        for i in 0..=case.n() {
            let (before, knot) = (case.knots().t(i), case.knots().t(i + 1));
            let side = if before < knot { Side::Left } else { Side::Right };
            let value = case.values(knot, side)[i].clone();
            if !ledger.equal(&value, &integer(1)) {
                let claimed = format!("{}({knot}) = 1", name(1, i));
                return Err(case.refuted([("x", knot.to_string())], claimed, format!("it is {value}")));
            }
        }
        return Ok(());
    }
    if !case.meets(&Bernstein) {
        return Err(Stop::Undecided("no function is known here whose coefficients are large".into()));
    }
    let c = chebyshev(case.k());
    if !stays_within_one(case, &c, ledger) {
        return Err(Stop::Fault("a Chebyshev polynomial is greater than 1".into()));
    }
    let list: Vec<_> = c.iter().map(ToString::to_string).collect();
    let at = [("c", format!("({})", list.join(", ")))];
    let found = "|Σ c_i G_i(x)| ≤ 1 for all x".to_owned();
    Err(case.refuted_at_large(at, "|c_i| ≤ max |Σ c_i G_i| for all i".into(), found))
}

/// Without interior knots G_i = C(k, i)·w^i·(1 − w)^(k − i) for the w of the whole interval, which takes all values from 0 to
/// 1; and Σ c_i G_i with Chebyshev's c_i is 1 at most, or less than that with c_i of which one is greater.
fn condition_of_bernstein(greater: BigRational) -> impl Fn(&BasisCase, &mut Ledger) -> Judgement {
    move |case, ledger| {
        if !case.meets(&Bernstein) {
            return Ok(());
        }
        let (k, [a, b]) = (case.k(), [case.knots().first(), case.knots().last()]);
        for pieces in case.pieces().spans() {
            let (w, v) = weight(&pieces.x.embed(case.basis().index().ratio()), &pieces.x, a, b);
            for i in 0..=k {
                if !ledger.equal(&pieces.function(i), &bernstein(k, i, (&w, &v))) {
                    return Err(Stop::Fault(format!("{} is no Bernstein polynomial of w", name(k, i))));
                }
            }
        }
        let c: Vec<_> = chebyshev(k).iter().map(|c| c * &greater).collect();
        if stays_within_one(case, &c, ledger) {
            return Ok(());
        }
        let list: Vec<_> = c.iter().map(ToString::to_string).collect();
        let at = [("c", format!("({})", list.join(", ")))];
        Err(case.refuted_at_large(at, "|Σ c_i G_i| ≤ 1".into(), "somewhere it is greater".into()))
    }
}

/// The claims about approximation.
pub(super) fn claims() -> Vec<Claim> {
    vec![
        Claim::new(
            "X.approximation",
            "not in the paper",
            Form::Basis(
                Statement::new(
                    "The approximation order is exactly 1, whatever k: for the knots h·t_0, …, h·t_m the distance of x ↦ x from all combinations of the basis, in the largest absolute value on any one span of [h·t_k, h·t_{n+1}], is c·h with a c > 0 that does not depend on h.",
                    order_one,
                )
                .given([FiniteIndex, DegreeAtLeast(1)]),
            ),
        )
        .note("That the order is at least 1 is abstract.approx. For α = ∞ it is k + 1. The engine decides that x is no combination on any span, and that the scale does not matter; a function that is none has a positive distance from the finitely many dimensions of those that are."),
        Claim::new(
            "X.elevation",
            "not in the paper",
            Form::Basis(
                Statement::new(
                    "Open U, interior knots of multiplicity ≤ k. Degree elevation: every G_i^k is a combination of the functions of degree k + 1 on the knots of which each occurs once more.",
                    elevates,
                )
                .given([Open, FiniteIndex, DegreeAtLeast(1), InnerMultiplicityAtMostDegree]),
            ),
        )
        .amended(Form::Basis(
            Statement::new(
                "Open U. That is so exactly if every interior knot has a multiplicity ≥ k: always for k = 1, and where there is none.",
                elevates_exactly(|k| k),
            )
            .given([Open, FiniteIndex, DegreeAtLeast(1)]),
        ))
        .fails_by(Cause::Conjecture),
        Claim::new(
            "X.condition",
            "not in the paper",
            Form::Basis(
                Statement::new(
                    "Open U, interior knots of multiplicity ≤ k. The condition number of the basis in the largest absolute value is 1: |c_i| ≤ sup |Σ c_i G_i^k| for all coefficients c.",
                    well_conditioned,
                )
                .given([Open, FirstSpan, LastSpan, DegreeAtLeast(1), InnerMultiplicityAtMostDegree]),
            ),
        )
        .amended(Form::Basis(
            Statement::new(
                "Without interior knots the condition number is that of the Bernstein basis of degree k, whatever α: its functions are the Bernstein polynomials in w, which maps [a, b] onto [0, 1]. So it is at least max C(2k, 2i)/C(k, i), 3 for k = 2, as T_k(2w − 1) shows.",
                condition_of_bernstein(integer(1)),
            )
            .given([Open, FirstSpan, LastSpan, DegreeAtLeast(1), InnerMultiplicityAtMostDegree]),
        ))
        .fails_by(Cause::NeverSo)
        .note("For k ≥ 2 and knots inside, no value and no bound is known here."),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::claims::hypothesis::Hypothesis::ClassicalIndex;
    use crate::claims::small_cases::refuted;

    #[test]
    fn false_variants_are_refuted() {
        assert!(refuted(order_one, [ClassicalIndex, DegreeAtLeast(1)]), "x is a combination for α = ∞");
        let given = [Open, FiniteIndex, DegreeAtLeast(1)];
        assert!(refuted(elevates_exactly(|k| k - 1), given) && refuted(elevates_exactly(|k| k + 1), given));
        assert!(refuted(condition_of_bernstein(rational(101, 100)), [Bernstein, DegreeAtLeast(1)]));
    }

    /// For polynomial splines degree elevation is always possible.
    #[test]
    fn the_classical_degree_can_be_elevated() {
        let knots = KnotVector::new([0, 0, 0, 0, 1, 2, 2, 3, 3, 3, 3].map(integer).to_vec()).unwrap();
        let basis = Basis::new(knots, 3, "inf".parse().unwrap()).unwrap();
        let case = BasisCase::new(basis, crate::claims::Origin::User);
        assert_eq!(elevates(&case, &mut Ledger::default()), Ok(()));
    }

    #[test]
    fn chebyshev_in_bernstein_form() {
        assert_eq!(chebyshev(2), [1, -3, 1].map(|c| rational(c, 1)));
        assert_eq!(chebyshev(4)[2], rational(35, 3));
    }
}
