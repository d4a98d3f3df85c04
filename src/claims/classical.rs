//! What the abstract, section 4 and the conclusion say of the class as a whole.

use crate::analysis::Pieces;
use crate::scalar::{BigRational, Ring, integer};
use crate::spline::Index;

use super::basis::{local_support, partition_of_unity, positivity};
use super::case::BasisCase;
use super::cause::Cause;
use super::claim::{Claim, Form};
use super::curve::{affine_invariance, convex_hull, local_control, tangents};
use super::hypothesis::Hypothesis::{
    Bernstein, DegreeAtLeast, FiniteIndex, FirstSpan, InteriorMultiplicityAtMostDegree, LastSpan, Open,
};
use super::independence::independence;
use super::questions::{linear_precision, nested, total_positivity, variation};
use super::statement::Statement;
use super::verdict::{Judgement, Ledger, Stop};

/// A property by the claim that decides it.
type Property = (&'static str, fn(&BasisCase, &mut Ledger) -> Judgement);

/// What a curve of polynomial B-splines has.
const OF_CURVES: [Property; 7] = [
    ("P4.1.1", |case, ledger| local_control(true)(case, ledger)),
    ("P4.1.3", convex_hull),
    ("P4.1.4", |case, ledger| affine_invariance(integer(1))(case, ledger)),
    ("P4.2.2", tangents),
    ("X.linear", linear_precision),
    ("X.nested", nested),
    ("X.variation", variation),
];

/// What a basis of polynomial B-splines has.
const OF_BASES: [Property; 7] = [
    ("T3.5.1", |case, ledger| local_support(true)(case, ledger)),
    ("T3.5.2", |case, ledger| positivity(integer(0))(case, ledger)),
    ("T3.5.3", |case, ledger| partition_of_unity(true, integer(1))(case, ledger)),
    ("P3.2", independence),
    ("X.linear", linear_precision),
    ("X.nested", nested),
    ("X.totalpositivity", total_positivity),
];

/// How many of each list the class has: those that the paper proves.
const KEPT: usize = 4;

/// Every property of the list holds. One that fails is named in the witness by the claim that decides it.
fn all_hold(properties: &'static [Property]) -> impl Fn(&BasisCase, &mut Ledger) -> Judgement {
    move |case, ledger| {
        let mut open = Ok(());
        for (claim, property) in properties {
            match property(case, ledger) {
                Err(Stop::Refuted(mut witness)) => {
                    witness.given.insert(0, ("property".to_owned(), (*claim).to_owned()));
                    return Err(Stop::Refuted(witness));
                }
                Err(Stop::Undecided(limit)) if open.is_ok() => {
                    open = Err(Stop::Undecided(format!("{claim}: {limit}")));
                }
                Err(fault @ Stop::Fault(_)) => return Err(fault),
                _ => {}
            }
        }
        open
    }
}

/// On the one span of a Bernstein case: every B_i^k at u is the Bernstein polynomial at factor(r)·u.
fn is_reparametrised(
    factor: impl Fn(&BigRational) -> BigRational,
    case: &BasisCase,
    ledger: &mut Ledger,
) -> bool {
    let factor = factor(case.basis().index().ratio());
    let classical = Pieces::of(&case.basis().with_index(Index::infinity()));
    let both = case.pieces().spans().iter().zip(classical.spans());
    let mut functions = both.flat_map(|(pieces, classical)| {
        (0..=case.n()).map(|i| (pieces.function(i), classical.function(i).scaled_argument(&factor)))
    });
    functions.all(|(g, wanted)| ledger.equal(&g, &wanted))
}

/// Some polygon has another curve, as a set of points, than for α = ∞.
fn is_new_point_set(case: &BasisCase, ledger: &mut Ledger) -> Judgement {
    if is_reparametrised(Clone::clone, case, ledger) {
        let r = case.basis().index().ratio();
        let claimed = "for some control points the curve has other points than for α = ∞".into();
        let found = format!(
            "for every i, B_i^{} at u is the Bernstein polynomial at ({r})·u, with u = (x − a)/(b − x); u ↦ ({r})·u maps (0, ∞) onto itself, so for all control points both curves have the same points",
            case.k()
        );
        return Err(case.refuted_at_large([], claimed, found));
    }
    Err(Stop::Undecided("no reparametrisation of this form takes one to the other".into()))
}

/// B_i^k at u is the Bernstein polynomial at factor(r)·u, for every i; the claim's factor is r.
fn reparametrised(factor: fn(&BigRational) -> BigRational) -> impl Fn(&BasisCase, &mut Ledger) -> Judgement {
    move |case, ledger| {
        if is_reparametrised(factor, case, ledger) {
            return Ok(());
        }
        let claimed = format!("every B_i^{} at u is the Bernstein polynomial at r·u", case.k());
        Err(case.refuted_at_large([], claimed, "one is not".into()))
    }
}

/// B_0^k lies above the Bernstein polynomial for r < 1, and below it for r > 1, on all of (a, b); `reversed`: the
/// other way round.
fn another_function(reversed: bool) -> impl Fn(&BasisCase, &mut Ledger) -> Judgement {
    move |case, ledger| {
        let classical = Pieces::of(&case.basis().with_index(Index::infinity()));
        let above = (*case.basis().index().ratio() < integer(1)) != reversed;
        for (pieces, classical) in case.pieces().spans().iter().zip(classical.spans()) {
            let difference = pieces.function(0).minus(&classical.function(0));
            let oriented = if above { difference } else { difference.negate() };
            if !ledger.positive(&oriented) {
                let claimed = "B_0 falls as r rises";
                let found = "compared with α = ∞ it does not";
                return Err(case.refuted_at_large([], claimed.into(), found.into()));
            }
        }
        Ok(())
    }
}

/// The claims of the abstract.
pub(super) fn of_abstract() -> Vec<Claim> {
    const SIMPLE_ENDS: [super::hypothesis::Hypothesis; 4] = [Open, DegreeAtLeast(1), FirstSpan, LastSpan];
    vec![
        Claim::new(
            "abstract.classical",
            "Abstract, section 4.1",
            Form::Basis(
                Statement::new(
                    "The curves have the classical properties of B-spline curves: local control, convex hull, affine invariance, end points and end tangents, linear precision, knot insertion, variation diminution.",
                    all_hold(&OF_CURVES),
                )
                .given(SIMPLE_ENDS)
                .given([FiniteIndex]),
            ),
        )
        .amended(Form::Basis(
            Statement::new(
                "The curves have those that section 4 proves: local control, convex hull, affine invariance, end points and end tangents.",
                all_hold(OF_CURVES.split_at(KEPT).0),
            )
            .given(SIMPLE_ENDS),
        ))
        .fails_by(Cause::Conjecture)
        .note("The list is ours: the properties that textbooks give for polynomial B-spline curves. Every one is decided by the conclusion of the claim that the witness names. What the curves lack: linear precision and knot insertion for k ≥ 1, variation diminution for k ≥ 3, degree by degree in X.linear, X.nested, X.variation."),
        Claim::new(
            "abstract.bezier",
            "Abstract, section 3.2",
            Form::Basis(
                Statement::new(
                    "Without interior knots the functions are a new family: for k ≥ 1 the B_i^k for two values of α are not the same functions of x. B_0^k(x) falls strictly as r = α/(α−1) rises, at every x in (a,b).",
                    another_function(false),
                )
                .given([Bernstein, DegreeAtLeast(1), FiniteIndex]),
            ),
        )
        .note("The engine compares with α = ∞; the certificate, any two values. For the curves as sets of points see abstract.bezier.points. Whether a family is new to the literature is no mathematical statement and is not judged."),
        Claim::new(
            "abstract.bezier.points",
            "Abstract, section 3.2",
            Form::Basis(
                Statement::new(
                    "Without interior knots the curves are a new family of rational Bézier curves: for k ≥ 1 and some control points the curve, as a set of points, is not the polynomial Bézier curve.",
                    is_new_point_set,
                )
                .given([Bernstein, DegreeAtLeast(1), FiniteIndex]),
            ),
        )
        .amended(Form::Basis(
            Statement::new(
                "For every k, α and control points the curve is the polynomial Bézier curve of these points, reparametrised by the weight: with u = (x−a)/(b−x), B_i^k at u is the Bernstein polynomial at r·u.",
                reparametrised(Clone::clone),
            )
            .given([Bernstein]),
        ))
        .fails_by(Cause::VagueWords)
        .note("Written as a rational Bézier curve it has the weights r^i. Two readings: as functions of x they are new (abstract.bezier), as sets of points they are not."),
    ]
}

/// The claim of the conclusion.
pub(super) fn of_conclusion() -> Vec<Claim> {
    vec![
        Claim::new(
            "C6.classical",
            "Section 6",
            Form::Basis(
                Statement::new(
                    "The basis has all the classical fundamental properties of B-splines: local support, positivity, partition of unity, linear independence, linear precision, nested spaces, total positivity.",
                    all_hold(&OF_BASES),
                )
                .given([Open, DegreeAtLeast(1), InteriorMultiplicityAtMostDegree, FirstSpan, LastSpan, FiniteIndex]),
            ),
        )
        .amended(Form::Basis(
            Statement::new(
                "It has those that section 3 proves: local support, positivity, partition of unity, linear independence.",
                all_hold(OF_BASES.split_at(KEPT).0),
            )
            .given([Open, DegreeAtLeast(1), InteriorMultiplicityAtMostDegree, FirstSpan, LastSpan]),
        ))
        .fails_by(Cause::Conjecture)
        .note("The paper writes \"such as positivity, unit partition property and linear independence\"; the rest of the list is ours. Every property is decided by the conclusion of the claim that the witness names. What the basis lacks: linear precision and nested spaces for k ≥ 1, total positivity for k ≥ 3, degree by degree in X.linear, X.nested, X.totalpositivity."),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::claims::hypothesis::Hypothesis;
    use crate::claims::register::claims;
    use crate::claims::small_cases::{Cases, refuted};
    use crate::claims::statement::judge_by_degree;
    use crate::claims::verdict::Verdict;
    use crate::scalar::RationalAlgebra;

    #[test]
    fn false_variants_are_refuted() {
        let inverse = |r: &BigRational| r.reciprocal().unwrap_or_else(|| integer(0));
        assert!(refuted(reparametrised(inverse), [Bernstein, DegreeAtLeast(1)]), "1/r for r");
        assert!(refuted(another_function(true), [Bernstein, DegreeAtLeast(1), FiniteIndex]), "rises with r");
        assert!(refuted(all_hold(&OF_BASES[..KEPT]), [Open]), "independence with any multiplicities");
        assert!(refuted(all_hold(&OF_CURVES[..KEPT]), [Open, DegreeAtLeast(1)]), "end knots k + 2 times");
    }

    /// The witness names the claim that decides, for each of the properties that are lacking.
    #[test]
    fn each_missing_property_is_found_missing_by_its_own_claim() {
        let cases = Cases::all();
        let lacking = OF_CURVES[KEPT..].iter().chain(&OF_BASES[KEPT..]);
        for property in lacking {
            let alone: &'static [Property] = Box::leak(Box::new([*property]));
            let statement = Statement::new("", all_hold(alone)).given([
                Open,
                FiniteIndex,
                DegreeAtLeast(1),
                Hypothesis::InnerMultiplicityAtMostDegree,
            ]);
            // Some need larger cases, which their own claim brings along.
            let own =
                claims().into_iter().find(|claim| claim.id == property.0).and_then(|claim| claim.more_cases);
            let more = own.map(|cases| cases()).unwrap_or_default();
            let (verdict, _) = judge_by_degree(&statement, cases.bases.iter().chain(&more)).unwrap();
            let Verdict::Refuted(witness) = verdict else { unreachable!("{}: {verdict:?}", property.0) };
            assert_eq!(witness.given[0], ("property".to_owned(), property.0.to_owned()));
            let k: usize = witness.given[1].1.parse().unwrap();
            let least = if ["X.linear", "X.nested"].contains(&property.0) { 1 } else { 3 };
            assert_eq!(k, least, "{}", property.0);
        }
    }
}
