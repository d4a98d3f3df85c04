//! Questions that the paper does not ask and its users will, for finite α; judged degree by degree as well.

use crate::analysis::{
    Piece, Pieces, Sign, SpanPieces, coefficient_rows, common_numerators, in_span, is_combination,
    sign_pattern,
};
use crate::scalar::{BigRational, Polynomial, RationalAlgebra, Ring, integer, rational};
use crate::spline::{Basis, Side};

use super::basis::name;
use super::case::BasisCase;
use super::cause::Cause;
use super::claim::{Claim, Form};
use super::hypothesis::Hypothesis::{DegreeAtLeast, FiniteIndex, InnerMultiplicityAtMostDegree, Open};
use super::statement::Statement;
use super::verdict::{Judgement, Ledger, Stop};

/// At every simple interior knot the factors of the control points in the two one-sided derivatives are
/// proportional, by a positive number: then, and only then, have all curves a continuous tangent direction.
fn tangent_continuity(case: &BasisCase, ledger: &mut Ledger) -> Judgement {
    let simple = case.knots().interior(case.k()).iter().filter(|t| case.knots().multiplicity(t) == 1);
    for x in simple {
        let slopes = |side| -> Vec<BigRational> {
            case.basis().jets(x, side, 1).iter().map(|jet| jet.coefficients()[1].clone()).collect()
        };
        let (left, right) = (slopes(Side::Left), slopes(Side::Right));
        let Some(p) = left.iter().position(|slope| !slope.is_zero()) else { continue };
        for q in 0..left.len() {
            if !ledger.equal(&(&left[p] * &right[q]), &(&left[q] * &right[p])) {
                let at =
                    [("x", x.to_string()), ("d", format!("0 but for d_{p} = (1, 0) and d_{q} = (0, 1)"))];
                let found = format!(
                    "the one-sided derivatives there are ({}, {}) and ({}, {})",
                    left[p], left[q], right[p], right[q]
                );
                return Err(case.refuted(at, format!("every curve has one tangent direction at {x}"), found));
            }
        }
        if !ledger.less(&integer(0), &(&left[p] * &right[p])) {
            let at = [("x", x.to_string())];
            return Err(case.refuted(
                at,
                "the tangent does not turn back".into(),
                format!("it does, for d_{p}"),
            ));
        }
    }
    Ok(())
}

/// Three consecutive functions and three points with a negative minor.
struct NegativeMinor {
    /// The first function.
    first: usize,
    points: [BigRational; 3],
    rows: Vec<Vec<BigRational>>,
    minor: BigRational,
}

/// A negative minor of order 3 close to a knot, if there is one by this test: where the derivatives jump, the
/// minor of (G_i) at x − ε, x, x + ε is ε² det(G, D⁻G, D⁺G) + O(ε³).
fn negative_minor(case: &BasisCase) -> Option<NegativeMinor> {
    for (x, p) in case.knots().inner_stop_knots() {
        if p > case.k() || case.n() < 2 {
            continue;
        }
        let jets = |side| case.basis().jets(x, side, 1);
        let (left, right) = (jets(Side::Left), jets(Side::Right));
        for first in 0..=case.n() - 2 {
            let take = |of: &dyn Fn(usize) -> BigRational| (first..first + 3).map(of).collect::<Vec<_>>();
            let corner = [
                take(&|i| right[i].coefficients()[0].clone()),
                take(&|i| left[i].coefficients()[1].clone()),
                take(&|i| right[i].coefficients()[1].clone()),
            ];
            if determinant(&corner) < integer(0) {
                return near(case, x, first);
            }
        }
    }
    None
}

/// The points x − ε, x, x + ε with the largest ε = 2^(−e) at which the minor is negative.
fn near(case: &BasisCase, x: &BigRational, first: usize) -> Option<NegativeMinor> {
    /// A corner with a smaller ε than 2^−40 is passed over.
    const HALVINGS: usize = 40;
    let mut epsilon = rational(1, 2);
    for _ in 0..HALVINGS {
        let points = [x - &epsilon, x.clone(), x + &epsilon];
        let row = |x: &BigRational| case.values(x, Side::Right)[first..first + 3].to_vec();
        let rows: Vec<_> = points.iter().map(row).collect();
        let minor = determinant(&rows);
        if minor < integer(0) {
            return Some(NegativeMinor { first, points, rows, minor });
        }
        epsilon /= integer(2);
    }
    None
}

/// A curve that a line meets more often than its polygon. From a negative minor: with f = Σ c_i G_i equal to
/// 1, −1, 1 at its points, the c_i have the signs −, +, −, so f changes its sign there twice, and twice more where
/// the outer functions, alone near the ends of their supports, make it negative.
pub(super) fn variation(case: &BasisCase, _: &mut Ledger) -> Judgement {
    let Some(NegativeMinor { first, rows, minor, .. }) = negative_minor(case) else {
        return Err(Stop::Undecided("no curve was found that a line meets too often, near any knot".into()));
    };
    let heights = [integer(1), integer(0) - integer(1), integer(1)];
    // All others −1: they add no change of sign to the polygon's, and no part of it lies in the line y = 0.
    let mut c = vec![-integer(1); case.n() + 1];
    for column in 0..3 {
        // Cramer's rule.
        let mut replaced = rows.clone();
        for (row, height) in replaced.iter_mut().zip(&heights) {
            row[column] = height.clone();
        }
        c[first + column] = determinant(&replaced) / &minor;
    }
    let signs: Vec<_> = c.iter().filter(|c| !c.is_zero()).map(|c| *c < integer(0)).collect();
    let polygon = signs.windows(2).filter(|pair| pair[0] != pair[1]).count();
    let curve = sign_changes(case.pieces(), &c);
    if curve <= polygon {
        return Err(Stop::Undecided(format!("the line y = 0 meets the curve found {curve} times only")));
    }
    let list: Vec<_> = c.iter().map(ToString::to_string).collect();
    let at = [("ordinates of the control points", format!("({})", list.join(", ")))];
    let claimed = format!("y = 0 is crossed at most {polygon} times, as by the polygon");
    Err(case.refuted_at_large(at, claimed, format!("the curve crosses it {curve} times")))
}

/// How often Σ c_i G_i changes its sign on [t_0, t_m].
fn sign_changes(pieces: &Pieces, c: &[BigRational]) -> usize {
    let signs = pieces.spans().iter().flat_map(|span| {
        let terms = span.functions.iter().map(|(i, g)| g.times(&g.embed(&c[i])));
        let sum: Piece = terms.fold(pieces.zero(), |sum, term| sum.plus(&term));
        let pattern = sign_pattern(&sum.numerator().times(sum.denominator()));
        pattern.between().iter().map(|(_, sign)| *sign).collect::<Vec<_>>()
    });
    let signs: Vec<_> = signs.filter(|sign| *sign != Sign::Zero).collect();
    signs.windows(2).filter(|pair| pair[0] != pair[1]).count()
}

/// Minors of order 3 near the knots.
pub(super) fn total_positivity(case: &BasisCase, _: &mut Ledger) -> Judgement {
    let Some(NegativeMinor { first, points, rows, minor }) = negative_minor(case) else {
        return Err(Stop::Undecided("no negative minor of order 3 was found near any knot".into()));
    };
    let list = |items: Vec<String>| format!("({})", items.join(", "));
    let at = [
        ("functions", list((first..first + 3).map(|i| name(case.k(), i)).collect())),
        ("points", list(points.iter().map(ToString::to_string).collect())),
    ];
    let rows: Vec<_> = rows.iter().map(|row| list(row.iter().map(ToString::to_string).collect())).collect();
    let found = format!("it is {minor}, of the rows {}", rows.join(", "));
    Err(case.refuted_at_large(at, "the minor is ≥ 0".into(), found))
}

/// Laplace expansion: for order 3.
fn determinant(rows: &[Vec<BigRational>]) -> BigRational {
    let Some((first, rest)) = rows.split_first() else { return integer(1) };
    let mut sum = integer(0);
    for (column, entry) in first.iter().enumerate() {
        let minor: Vec<Vec<_>> = rest
            .iter()
            .map(|row| row.iter().enumerate().filter(|(c, _)| *c != column).map(|(_, x)| x.clone()).collect())
            .collect();
        let term = entry * determinant(&minor);
        if column % 2 == 0 { sum += term } else { sum -= term }
    }
    sum
}

/// x ↦ x is a combination of the basis on [t_k, t_{n+1}].
pub(super) fn linear_precision(case: &BasisCase, ledger: &mut Ledger) -> Judgement {
    // On one span first: what fails there fails on the whole interval.
    for pieces in case.pieces().spans() {
        if (case.k()..=case.n()).contains(&pieces.span.index())
            && !ledger.count(usize::from(is_combination(pieces.functions.values(), &pieces.x)), 1)
        {
            let (start, end) = pieces.ends();
            let claimed = "x is a combination of the basis functions".to_owned();
            let found = format!("on [{start}, {end}) it is none of those that live there");
            return Err(case.refuted([("span", format!("[{start}, {end})"))], claimed, found));
        }
    }
    Ok(())
}

/// Every function for U is a combination of those for U with one more knot, in the middle of any span.
pub(super) fn nested(case: &BasisCase, ledger: &mut Ledger) -> Judgement {
    for coarse in case.pieces().spans() {
        let (start, end) = coarse.ends();
        let knot = (start + end) / integer(2);
        let refined = case.knots().with_knot(&knot);
        let Ok(refined) = Basis::new(refined, case.k(), case.basis().index().clone()) else { continue };
        let fine = Pieces::of(&refined);
        let rows = coefficient_rows(fine.spans().iter().map(|span| fine_and_coarse(span, refined.n(), case)));
        let (basis, functions) = rows.split_at(refined.n() + 1);
        for (i, function) in functions.iter().enumerate() {
            if !ledger.count(usize::from(in_span(basis, function).is_some()), 1) {
                let at = [("i", i.to_string()), ("new knot", knot.to_string())];
                let g = name(case.k(), i);
                let claimed = format!("{g} is a combination of the functions for the refined knots");
                return Err(case.refuted(at, claimed, "it is none".into()));
            }
        }
    }
    Ok(())
}

/// On a span of the refined knots: the refined functions, then those of the case.
fn fine_and_coarse(fine: &SpanPieces, n: usize, case: &BasisCase) -> Vec<Piece> {
    let start = fine.x.evaluate(&integer(0));
    let coarse = start.and_then(|start| case.knots().span_at(&start, Side::Right));
    let coarse = coarse.and_then(|span| case.basis().active(span, &fine.x).ok());
    let of_case =
        |i| coarse.as_ref().and_then(|active| active.get(i)).cloned().unwrap_or_else(|| fine.x.zero());
    (0..=n).map(|i| fine.function(i)).chain((0..=case.n()).map(of_case)).collect()
}

/// On every span the derivative of every function is a combination of the functions of degree k − 1 on the same
/// knots.
fn derivative_in_class(case: &BasisCase, ledger: &mut Ledger) -> Judgement {
    let Ok(lower) = Basis::new(case.knots().clone(), case.k() - 1, case.basis().index().clone()) else {
        return Ok(());
    };
    let lower = Pieces::of(&lower);
    for (pieces, lower) in case.pieces().spans().iter().zip(lower.spans()) {
        for (i, g) in pieces.functions.iter() {
            let slope = pieces.derivative(g);
            if !ledger.count(usize::from(is_combination(lower.functions.values(), &slope)), 1) {
                let (start, end) = pieces.ends();
                let at = [("i", i.to_string()), ("span", format!("[{start}, {end})"))];
                let claimed = format!(
                    "D{} is a combination of the functions of degree {}",
                    name(case.k(), i),
                    case.k() - 1
                );
                return Err(case.refuted(at, claimed, "it is none".into()));
            }
        }
    }
    Ok(())
}

/// On every span, with Q the least common denominator: deg Q ≤ bound(k), which is k(k + 1)/2 in the claim, no numerator has a higher degree, and
/// the coefficients of Q in u, which are positive multiples of its Bézier weights, are positive.
fn rational_bezier(bound: fn(k: usize) -> usize) -> impl Fn(&BasisCase, &mut Ledger) -> Judgement {
    move |case, ledger| rational_bezier_of(bound(case.k()), case, ledger)
}

fn rational_bezier_of(most: usize, case: &BasisCase, ledger: &mut Ledger) -> Judgement {
    for pieces in case.pieces().spans() {
        if !(case.k()..=case.n()).contains(&pieces.span.index()) {
            continue;
        }
        let mut functions = pieces.functions.values().to_vec();
        functions.push(case.pieces().one());
        // The numerator of 1 over the common denominator is that denominator.
        let mut numerators = common_numerators(&functions);
        let Some(denominator) = numerators.pop() else { continue };
        let degree = denominator.degree().max(numerators.iter().map(Polynomial::degree).max().unwrap_or(0));
        let (start, end) = pieces.ends();
        let at = [("span", format!("[{start}, {end})"))];
        if !ledger.count(degree.max(most), most) {
            let claimed = format!("the curve is a rational Bézier curve of degree at most {most}");
            return Err(case.refuted(at, claimed, format!("its least degree is {degree}")));
        }
        let padded = denominator.degree() == degree;
        let positive = denominator.coefficients().iter().all(|c| ledger.less(&integer(0), c));
        if !(padded && positive) {
            return Err(case.refuted(at, "all Bézier weights are positive".into(), "one is not".into()));
        }
    }
    Ok(())
}

/// The questions.
pub(super) fn claims() -> Vec<Claim> {
    vec![
        Claim::new(
            "X.G1",
            "not in the paper",
            Form::Basis(
                Statement::new(
                    "Open U: at every simple interior knot every curve of degree k ≥ 2 has a continuous tangent direction (the one-sided derivatives are non-negative multiples of one vector).",
                    tangent_continuity,
                )
                .given([Open, FiniteIndex, DegreeAtLeast(2)]),
            ),
        )
        .fails_by(Cause::Conjecture),
        Claim::new(
            "X.variation",
            "not in the paper",
            Form::Basis(
                Statement::new(
                    "Open U, no knot inside of multiplicity > k. Variation diminishing: no line in R² meets the curve more often, counted by the parameter, than the control polygon.",
                    variation,
                )
                .given([Open, FiniteIndex, DegreeAtLeast(1), InnerMultiplicityAtMostDegree]),
            ),
        )
        .fails_by(Cause::Conjecture)
        .note("A function with two local maxima crosses some horizontal line four times, and its control values, one 1 and else 0, twice: so for k ≥ 3 and every α ≠ ∞ the knots of X.maxima are counterexamples too."),
        Claim::new(
            "X.totalpositivity",
            "not in the paper",
            Form::Basis(
                Statement::new(
                    "Every collocation matrix (G_i^k(x_j)), x_1 < … < x_p, has only non-negative minors.",
                    total_positivity,
                )
                .given([FiniteIndex, DegreeAtLeast(1)]),
            ),
        )
        .fails_by(Cause::Conjecture)
        .note("It would imply X.variation: so for k ≥ 3 and every α ≠ ∞ it fails on the knots of X.maxima too."),
        Claim::new(
            "X.linear",
            "not in the paper",
            Form::Basis(
                Statement::new(
                    "The span of the basis contains x ↦ x on [t_k, t_{n+1}].",
                    linear_precision,
                )
                .given([FiniteIndex, DegreeAtLeast(1)]),
            ),
        )
        .fails_by(Cause::Conjecture),
        Claim::new(
            "X.nested",
            "not in the paper",
            Form::Basis(
                Statement::new(
                    "Knot insertion: the span for U lies in the span for U with one more knot.",
                    nested,
                )
                .given([FiniteIndex, DegreeAtLeast(1)]),
            ),
        )
        .fails_by(Cause::Conjecture),
        Claim::new(
            "X.derivative",
            "not in the paper",
            Form::Basis(
                Statement::new(
                    "The derivative of a curve is, on each span, a curve of the same class of degree k−1 on the same knots.",
                    derivative_in_class,
                )
                .given([FiniteIndex, DegreeAtLeast(1)]),
            ),
        )
        .fails_by(Cause::Conjecture),
        Claim::new(
            "X.nurbs",
            "not in the paper",
            Form::Basis(
                Statement::new(
                    "On every span the curve is a rational Bézier curve of degree at most k(k+1)/2 with positive weights, and in general of no lower degree.",
                    rational_bezier(|k| k * (k + 1) / 2),
                )
                .given([FiniteIndex, DegreeAtLeast(1)]),
            ),
        )
        .note("The engine decides the bound and the weights in each case; the certificate also gives, for each degree, knots on which no lower degree does."),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::claims::case::Origin;
    use crate::claims::small_cases::refuted;
    use crate::claims::statement::judge;
    use crate::claims::verdict::Verdict;
    use crate::spline::{Index, KnotVector};

    #[test]
    fn determinants() {
        let matrix = [[1, 2, 3], [0, 1, 4], [5, 6, 0]].map(|row| row.map(integer).to_vec());
        assert_eq!(determinant(&matrix), integer(1));
    }

    #[test]
    fn a_bezier_degree_too_low_is_refuted() {
        assert!(refuted(rational_bezier(|k| k * (k + 1) / 2 - 1), [Open, DegreeAtLeast(1)]));
    }

    /// For polynomial splines the answers are known, and all are yes.
    #[test]
    fn what_fails_for_finite_indices_holds_for_the_classical_one() {
        let knots = KnotVector::new([0, 0, 0, 0, 1, 2, 3, 3, 3, 3].map(integer).to_vec()).unwrap();
        let basis = Basis::new(knots, 3, Index::infinity()).unwrap();
        let case = [BasisCase::new(basis, Origin::User)];
        let conclusions = [tangent_continuity, linear_precision, nested, derivative_in_class];
        for (place, conclusion) in conclusions.into_iter().enumerate() {
            let verdict = judge(&Statement::new("", conclusion), &case).unwrap();
            assert!(matches!(verdict, Verdict::Proved { .. }), "{place}: {verdict:?}");
        }
        assert!(negative_minor(&case[0]).is_none(), "polynomial B-splines are totally positive");
    }
}
