//! Steps inside the paper's proofs that are wrong while what they prove is true: inductions that assume too much, and
//! equivalences of which one half is needed.

use crate::analysis::{Piece, coefficient_rows, rank};
use crate::scalar::{BigRational, RationalAlgebra, Ring, integer};
use crate::spline::{Basis, Curve, Side, weight};

use super::basis::{continuity, mirrored_span, name, symmetry};
use super::case::{BasisCase, Origin};
use super::cause::Cause;
use super::claim::{Claim, Form};
use super::drawn::show;
use super::hypothesis::Hypothesis::{
    BaseInterval, DegreeAtLeast, DegreeAtMost, InteriorMultiplicityAtMostDegree, Open, Symmetric,
};
use super::independence::independence;
use super::reflection::Reflection;
use super::statement::Statement;
use super::verdict::{Judgement, Ledger, Stop};

/// The same knots and index in degree k − 1.
fn one_degree_lower(case: &BasisCase) -> Option<BasisCase> {
    let basis = case.basis();
    let lower = Basis::new(basis.knots().clone(), case.k().checked_sub(1)?, basis.index().clone()).ok()?;
    Some(BasisCase::new(lower, Origin::Small))
}

/// For t_j < t_{j+1} and x in (t_j, t_{j+1}): G_i(x) ≠ 0 ⇔ j−k ≤ i ≤ j. At x = t_j the same, or, `as_amended`, only for
/// t_i < t_j and for i = j−k.
fn lives_exactly(as_amended: bool) -> impl Fn(&BasisCase, &mut Ledger) -> Judgement {
    move |case, ledger| {
        let (knots, k) = (case.knots(), case.k());
        for pieces in case.pieces().spans() {
            let j = pieces.span.index();
            let near = |i: usize| i <= j && j <= i + k;
            for (i, value) in case.values(knots.t(j), Side::Right).iter().enumerate() {
                let begins_here = as_amended && knots.t(i) == knots.t(j) && i + k != j;
                let wanted = near(i) && !begins_here;
                let holds =
                    if wanted { ledger.differ(value, &integer(0)) } else { ledger.equal(value, &integer(0)) };
                if !holds {
                    let at = [("i", i.to_string()), ("j", j.to_string()), ("x", knots.t(j).to_string())];
                    let g = format!("{}({})", name(k, i), knots.t(j));
                    let claimed = format!("{g} {} 0", if wanted { '≠' } else { '=' });
                    return Err(case.refuted(at, claimed, format!("{g} = {value}")));
                }
            }
            for i in 0..=case.n() {
                let g = case.definition_piece(pieces, i);
                let as_claimed =
                    if near(i) { ledger.positive(&g) } else { ledger.equal(&g, &case.pieces().zero()) };
                if !as_claimed {
                    return Err(Stop::Fault(format!("{} is wrong on the span {j}", name(k, i))));
                }
            }
        }
        Ok(())
    }
}

/// Every function of degree k − 1 is continuous at the knots inside (t_0, t_m).
fn lower_is_continuous(case: &BasisCase, ledger: &mut Ledger) -> Judgement {
    one_degree_lower(case).map_or(Ok(()), |lower| continuity(&lower, ledger))
}

/// At a knot of multiplicity k exactly two functions of degree k − 1 jump, the one that ends there from 1 to 0 and the
/// one that begins there from 0 to `height`, 1 in the claim; and no function of degree k jumps.
fn jumps_cancel(height: usize) -> impl Fn(&BasisCase, &mut Ledger) -> Judgement {
    move |case, ledger| {
        let Some(lower) = one_degree_lower(case) else { return Ok(()) };
        for (x, p) in case.knots().inner_stop_knots() {
            let first = case.knots().knots().iter().position(|t| t == x).unwrap_or(0);
            let (left, right) = (lower.values(x, Side::Left), lower.values(x, Side::Right));
            for (i, (left, right)) in left.iter().zip(&right).enumerate() {
                let jumps = p == case.k() && (i + 1 == first || i == first);
                let (before, after) = match (jumps, i == first) {
                    (false, _) => (left.clone(), left.clone()),
                    (true, false) => (integer(1), integer(0)),
                    (true, true) => (integer(0), integer(height)),
                };
                if !(ledger.equal(left, &before) && ledger.equal(right, &after)) {
                    let g = name(lower.k(), i);
                    let claimed = format!("{g} goes from {before} to {after} at {x}");
                    let found = format!("it goes from {left} to {right}");
                    return Err(lower.refuted_on_the_left(i, x, claimed, found));
                }
            }
            let (left, right) = (case.values(x, Side::Left), case.values(x, Side::Right));
            for (i, (left, right)) in left.iter().zip(&right).enumerate() {
                if !ledger.equal(left, right) {
                    let g = name(case.k(), i);
                    let found = format!("{g} → {left} from the left and {g}({x}) = {right}");
                    return Err(case.refuted_on_the_left(i, x, format!("{g} is continuous at {x}"), found));
                }
            }
        }
        Ok(())
    }
}

/// All m − k + 1 functions of degree k − 1 are linearly independent.
fn lower_is_independent(case: &BasisCase, ledger: &mut Ledger) -> Judgement {
    one_degree_lower(case).map_or(Ok(()), |lower| independence(&lower, ledger))
}

/// Of the functions of degree k − 1 those are 0 that have all their knots at one place, the first and the last among
/// them, and the others are linearly independent; `counted`: how many of the former are counted as independent, 0 in the
/// claim.
fn others_are_independent(counted: usize) -> impl Fn(&BasisCase, &mut Ledger) -> Judgement {
    move |case, ledger| {
        let Some(lower) = one_degree_lower(case) else { return Ok(()) };
        let (knots, n) = (case.knots(), lower.n());
        let empty: Vec<_> = (0..=n).filter(|i| knots.t(*i) == knots.t(i + case.k())).collect();
        let functions = lower.pieces().spans().iter().map(|span| (0..=n).map(|i| span.function(i)).collect());
        let rows = coefficient_rows(functions);
        let zero = |i: &usize| rows[*i].iter().all(Ring::is_zero);
        let vanish = empty.iter().filter(|i| zero(i)).count();
        let as_claimed = ledger.count(vanish, empty.len())
            && ledger.count(usize::from(empty.contains(&0) && empty.contains(&n)), 1)
            && ledger.count(rank(&rows), n + 1 - empty.len() + counted);
        if as_claimed {
            return Ok(());
        }
        let claimed =
            format!("{} functions of degree {} are independent", n + 1 - empty.len() + counted, lower.k());
        Err(case.refuted_at_large(
            [],
            claimed,
            format!("of {} functions {} are independent", n + 1, rank(&rows)),
        ))
    }
}

/// w_i^k at the points of a span, by D2.3: 0 where the span is not in [t_i, t_{i+k}).
fn weight_on(basis: &Basis, x: &Piece, ends: (&BigRational, &BigRational), i: usize) -> Piece {
    let (a, b) = (basis.knots().t(i), basis.knots().t(i + basis.degree()));
    if a <= ends.0 && ends.1 <= b { weight(&x.embed(basis.index().ratio()), x, a, b).0 } else { x.zero() }
}

/// φ_α(T(x), t_i, t_{i+k}) = 1 − φ_{1−α}(x, t_{m−i−k}, t_{m−i}) for every x between the knots; `with_factor`: after
/// multiplying with the functions of degree k − 1 that follow in the recursion, of which that on the right is
/// partner(m − k, i), m − k − i in the claim.
fn mirrored_weight(
    with_factor: bool,
    partner: fn(usize, usize) -> usize,
) -> impl Fn(&BasisCase, &mut Ledger) -> Judgement {
    move |case, ledger| {
        let (knots, k) = (case.knots(), case.k());
        let Some(lower) = one_degree_lower(case) else { return Ok(()) };
        let (basis, conjugate) = (case.basis(), case.conjugate_basis());
        for pieces in case.pieces().spans() {
            let mirrored = mirrored_span(knots, pieces.span).and_then(|span| lower.pieces().on(span));
            let (Some(mirrored), Some(lower)) = (mirrored, lower.conjugate_pieces().on(pieces.span)) else {
                return Err(Stop::Fault("a symmetric knot vector without a mirrored span".into()));
            };
            for i in 0..=knots.m() - k {
                let other = partner(knots.m() - k, i);
                // T(x) has the coordinate 1/u on the mirrored span.
                let ends = mirrored.ends();
                let mut left = weight_on(basis, &mirrored.x, ends, i).reciprocal_argument();
                let mut right = pieces.x.one();
                right = right.minus(&weight_on(&conjugate, &pieces.x, pieces.ends(), other));
                if with_factor {
                    left = left.times(&mirrored.function(i).reciprocal_argument());
                    right = right.times(&lower.function(other));
                }
                if !ledger.equal(&left, &right) {
                    let (start, end) = pieces.ends();
                    let x = (start + end) / integer(2);
                    let at = [("i", i.to_string()), ("x", x.to_string())];
                    let value = |f: &Piece| f.evaluate(&integer(1)).unwrap_or_else(|| integer(0));
                    let of = |i: usize, x: &BigRational| format!("({x}, {}, {})", knots.t(i), knots.t(i + k));
                    let (there, here) = (of(i, &knots.mirror(&x)), of(other, &x));
                    let claimed = format!("φ_α{there} = 1 − φ_(1−α){here}");
                    let found =
                        format!("the left side is {} and the right side {}", value(&left), value(&right));
                    return Err(case.refuted_at_large(at, claimed, found));
                }
            }
        }
        Ok(())
    }
}

/// The points −1, 1/2, 0, …, 0, 1 of a line: as a set of points their polygon is the segment from −1 to 1.
fn segment(n: usize) -> Vec<BigRational> {
    let inner = std::iter::once(integer(1) / integer(2)).chain(std::iter::repeat(integer(0)));
    let inner = inner.take(n.saturating_sub(1));
    std::iter::once(-integer(1)).chain(inner).chain([integer(1)]).collect()
}

/// A polygon that is symmetric as a set of points has d_i and d_{n−i} at the same distance from the bisector D of d_0 and
/// d_n, for every i. The polygon is [`segment`], D the line through 0 across it.
fn bisects_all(case: &BasisCase, ledger: &mut Ledger) -> Judgement {
    let n = case.n();
    // A single point has no bisector.
    if n == 0 {
        return Ok(());
    }
    let points: Vec<_> = segment(n).into_iter().map(|x| vec![x, integer(0)]).collect();
    let Some(axis) = Reflection::between(&points[0], &points[n]) else {
        return Err(Stop::Fault("the ends of a segment are the same point".into()));
    };
    // All points of the line between the ends: the legs cover the segment, and nothing else.
    let covered = points.iter().all(|p| points[0][0] <= p[0] && p[0] <= points[n][0]);
    if !ledger.count(usize::from(covered), 1) {
        return Err(Stop::Fault("the polygon leaves the segment".into()));
    }
    for i in 0..=n {
        let image = axis.apply(&points[i]);
        if !image.iter().zip(&points[n - i]).all(|(a, b)| ledger.equal(a, b)) {
            let list: Vec<_> = points.iter().map(|p| show(p)).collect();
            let at = [("i", i.to_string()), ("d", format!("({})", list.join(", ")))];
            let claimed = format!("D, the line x = 0, bisects d_{i} and d_{}", n - i);
            let found = format!(
                "it takes d_{i} = {} to {}, and d_{} = {}; as a set of points the polygon is the segment from (-1, 0) to (1, 0), which is symmetric",
                show(&points[i]),
                show(&image),
                n - i,
                show(&points[n - i])
            );
            return Err(case.refuted_at_large(at, claimed, found));
        }
    }
    Ok(())
}

/// If D exchanges d_i and d_{n−i} for all i, the curves are mirror images by P4.3; and only then, for the functions are
/// independent: Σ (D(d_i) − d_{n−i}) G_{n−i} is 0 for no other points.
fn exactly_if_exchanged(case: &BasisCase, ledger: &mut Ledger) -> Judgement {
    symmetry(false, |n, i| n - i)(case, ledger)?;
    independence(case, ledger)?;
    if case.n() < 2 {
        return Ok(());
    }
    // The example once more: its two curves are no mirror images, at some middle of a span.
    let points: Vec<_> = segment(case.n()).into_iter().map(|x| vec![x]).collect();
    let curve = |basis: &Basis| Curve::new(basis.clone(), points.clone());
    let (Ok(one), Ok(two)) = (curve(case.basis()), curve(&case.conjugate_basis())) else {
        return Err(Stop::Fault("a curve with n + 1 points".into()));
    };
    let differ = case.pieces().spans().iter().any(|pieces| {
        let (start, end) = pieces.ends();
        let x = (start + end) / integer(2);
        let (left, right) = (one.point(&case.knots().mirror(&x), Side::Right), two.point(&x, Side::Right));
        -&left[0] != right[0]
    });
    if ledger.count(usize::from(differ), 1) {
        return Ok(());
    }
    let claimed = "the curves of the points −1, 1/2, 0, …, 1 are no mirror images".into();
    Err(case.refuted_at_large([], claimed, "they are, at the middle of every span".into()))
}

/// The claims.
pub(super) fn claims() -> Vec<Claim> {
    const LIVES: &str = "For t_j < t_{j+1} and x in [t_j, t_{j+1}): G_i^k(x) ≠ 0 ⇔ j−k ≤ i ≤ j.";
    const LIVES_AMENDED: &str = "⇒ holds for every x in [t_j, t_{j+1}), and is all that is needed. ⇔ holds for x in (t_j, t_{j+1}); at x = t_j, G_i^k(x) ≠ 0 ⇔ j−k ≤ i ≤ j and (t_i < t_j or i = j−k).";
    vec![
        Claim::new(
            "proof.T3.5.3.iff",
            "Proof of Theorem 3.5 (3)",
            Form::Basis(Statement::new(LIVES, lives_exactly(false))),
        )
        .amended(Form::Basis(Statement::new(LIVES_AMENDED, lives_exactly(true))))
        .fails_by(Cause::ProofStep)
        .note("A function that begins at t_j with fewer than k + 1 of its knots is 0 there. The theorem's sum may have a summand that is 0."),
        Claim::new(
            "proof.P4.1.2.iff",
            "Proof of Proposition 4.1 (2)",
            Form::Basis(Statement::new(LIVES, lives_exactly(false)).given([Open])),
        )
        .amended(Form::Basis(Statement::new(LIVES_AMENDED, lives_exactly(true)).given([Open])))
        .fails_by(Cause::ProofStep)
        .note("The step of proof.T3.5.3.iff once more, for open U."),
        Claim::new(
            "proof.P3.1.2.induction",
            "Proof of Proposition 3.1 (2)",
            Form::Basis(
                Statement::new(
                    "For k ≥ 2 and interior multiplicities ≤ k: the G_i^{k−1} are of class C⁰ (what the induction assumes).",
                    lower_is_continuous,
                )
                .given([BaseInterval, DegreeAtLeast(2), InteriorMultiplicityAtMostDegree]),
            ),
        )
        .amended(Form::Basis(
            Statement::new(
                "The G_i^{k−1} are continuous at knots of multiplicity < k. At a knot of multiplicity k exactly two of them jump, one from 1 to 0 and the next one from 0 to 1; their factors in the recursion make the G_i^k continuous all the same.",
                jumps_cancel(1),
            )
            .given([BaseInterval, DegreeAtLeast(2), InteriorMultiplicityAtMostDegree]),
        ))
        .fails_by(Cause::ProofStep)
        .note("The proposition is true; only the induction has to allow for the two jumps."),
        Claim::new(
            "proof.P3.2.hypothesis",
            "Proof of Proposition 3.2",
            Form::Basis(
                Statement::new(
                    "For k ≥ 2, U open with interior multiplicities ≤ k: the G_i^{k−1}, i = 0, …, m−k, are linearly independent (what the induction assumes).",
                    lower_is_independent,
                )
                .given([Open, DegreeAtLeast(2), InteriorMultiplicityAtMostDegree]),
            ),
        )
        .amended(Form::Basis(
            Statement::new(
                "G_0^{k−1} and G_{m−k}^{k−1} have all their knots at one place and are 0. Those of the G_i^{k−1} that are not 0 are linearly independent.",
                others_are_independent(0),
            )
            .given([Open, DegreeAtLeast(2), InteriorMultiplicityAtMostDegree]),
        ))
        .fails_by(Cause::ProofStep)
        .note("A second gap besides proof.P3.2.induction: for degree k − 1 the proposition asks for interior multiplicities ≤ k − 1, and t_k, …, t_{m−k} are its interior knots. The proposition is true all the same."),
        Claim::new(
            "proof.T3.5.4.base",
            "Proof of Theorem 3.5 (4)",
            Form::Basis(
                Statement::new(
                    "The base of the induction, k = 0: if U is symmetric, then ^αG_i^0(t_0+t_m−x) = ^{1−α}G_{n−i}^0(x) for all x in [t_0, t_m].",
                    symmetry(true, |n, i| n - i),
                )
                .given([Symmetric, DegreeAtMost(0)]),
            ),
        )
        .amended(Form::Basis(
            Statement::new(
                "The same for every x that is no knot inside (t_0, t_m); at every such knot it fails for some i.",
                symmetry(false, |n, i| n - i),
            )
            .given([Symmetric, DegreeAtMost(0)]),
        ))
        .fails_by(Cause::ProofStep)
        .note("x ↦ t_0+t_m−x takes [t_i, t_{i+1}) to an interval that is open on the left. For k ≥ 1 continuity repairs it at knots of multiplicity ≤ k: see T3.5.4."),
        Claim::new(
            "proof.T3.5.4.corollary",
            "Proof of Theorem 3.5 (4)",
            Form::Basis(
                Statement::new(
                    "By Corollary 2.4, for symmetric U and every i: φ_α(t_0+t_m−x, t_i, t_{i+k}) = 1 − φ_{1−α}(x, t_{m−i−k}, t_{m−i}), for all x in [t_0, t_m].",
                    mirrored_weight(false, |last, i| last - i),
                )
                .given([Symmetric, DegreeAtLeast(1)]),
            ),
        )
        .amended(Form::Basis(
            Statement::new(
                "After multiplication with the functions that follow in the recursion, ^αG_i^{k−1}(t_0+t_m−x) on the left and ^{1−α}G_{m−k−i}^{k−1}(x) on the right, it holds for every x in [t_0, t_m] that is no knot: where the weights differ, these are 0.",
                mirrored_weight(true, |last, i| last - i),
            )
            .given([Symmetric, DegreeAtLeast(1)]),
        ))
        .fails_by(Cause::OutsideInterval)
        .note("Corollary 2.4 fails outside of (t_{m−i−k}, t_{m−i}): there both weights are 0. Harmless, for the factor is 0 there as well."),
        Claim::new(
            "proof.P4.3.bisector",
            "Proof of Proposition 4.3",
            Form::Basis(
                Statement::new(
                    "If the control polygon is symmetric, as a set of points, with respect to the perpendicular bisector D of (d_0, d_n), then D is the perpendicular bisector of (d_i, d_{n−i}) for every i.",
                    bisects_all,
                )
                .given([Open, Symmetric]),
            ),
        )
        .amended(Form::Basis(
            Statement::new(
                "That is an extra hypothesis, and the one that P4.3 needs: for interior multiplicities ≤ k, G_α and G_{1−α} are mirror images, x against t_0+t_m−x, exactly if D exchanges d_i and d_{n−i} for every i.",
                exactly_if_exchanged,
            )
            .given([Open, Symmetric, InteriorMultiplicityAtMostDegree]),
        ))
        .fails_by(Cause::ProofStep)
        .note("The engine decides the symmetry and the independence of the functions, and that the curves of the counterexample are no mirror images. The hypothesis on interior knots excludes end knots that occur more than k + 1 times."),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::claims::hypothesis::Hypothesis::{self, FirstSpan};
    use crate::claims::small_cases::refuted;

    #[test]
    fn false_variants_are_refuted() {
        let up_to_k: [Hypothesis; 2] = [BaseInterval, InteriorMultiplicityAtMostDegree];
        assert!(refuted(lives_exactly(false), [Open, FirstSpan]), "at t_j, end knots k + 1 times");
        assert!(!refuted(lives_exactly(false), [DegreeAtMost(0)]), "in degree 0 it holds");
        assert!(refuted(jumps_cancel(2), up_to_k), "a jump of height 2");
        assert!(refuted(jumps_cancel(1), [DegreeAtLeast(1)]), "with knots of multiplicity k + 1");
        assert!(
            refuted(others_are_independent(1), [Open, InteriorMultiplicityAtMostDegree]),
            "one more is independent"
        );
        assert!(
            refuted(mirrored_weight(true, |_, i| i), [Symmetric, DegreeAtLeast(1)]),
            "m − k − i replaced by i"
        );
        assert!(refuted(symmetry(false, |_, i| i), [Symmetric, DegreeAtMost(0)]), "n − i replaced by i");
        assert!(refuted(exactly_if_exchanged, [Open, Symmetric]), "with any multiplicities");
    }

    /// The smallest knots on which the induction of Proposition 3.1 (2) assumes too much.
    #[test]
    fn a_double_knot_in_degree_2_breaks_the_induction() {
        use crate::claims::statement::judge;
        use crate::claims::verdict::Verdict;
        let knots = crate::spline::KnotVector::new([0, 0, 0, 1, 1, 2, 2, 2].map(integer).to_vec()).unwrap();
        let basis = Basis::new(knots, 2, crate::spline::Index::infinity()).unwrap();
        let case = [BasisCase::new(basis, Origin::User)];
        let printed = judge(&Statement::new("", lower_is_continuous), &case).unwrap();
        assert!(matches!(&printed, Verdict::Refuted(witness) if witness.given[0].1 == "1"), "{printed:?}");
        let amended = judge(&Statement::new("", jumps_cancel(1)), &case).unwrap();
        assert!(matches!(amended, Verdict::Proved { .. }), "{amended:?}");
    }
}
