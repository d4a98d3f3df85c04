//! Section 4: curves. A claim about every control polygon is one about the functions that multiply the points,
//! so each is judged for all polygons at once.

use crate::analysis::{Piece, always_positive};
use crate::scalar::{BigRational, Ring, integer};
use crate::spline::{Index, PointWeights, Side, Weights, de_boor};

use super::basis::{interpolation, name, symmetry};
use super::case::BasisCase;
use super::cause::Cause;
use super::claim::{Claim, Form};
use super::hypothesis::Hypothesis::{DegreeAtLeast, FirstSpan, LastSpan, Open, Symmetric};
use super::hypothesis::STATED_IN_THE_PROOF;
use super::regularity::{at_first, at_last, end_derivatives};
use super::statement::Statement;
use super::verdict::{Judgement, Ledger, Stop};

/// G_j = 0 for x in [t_0, t_m] outside of [t_j, t_{j+k+1}); with `exceptions`, except at the end x = t_m of
/// [t_j, t_{j+k+1}] if t_j < t_{j+1}, where it is 1.
pub(super) fn local_control(exceptions: bool) -> impl Fn(&BasisCase, &mut Ledger) -> Judgement {
    move |case, ledger| {
        let knots = case.knots();
        for j in 0..=case.n() {
            let (low, high) = case.basis().support(j);
            for (x, _) in knots.stop_knots().filter(|(x, _)| *x < low || high <= *x) {
                let excepted = exceptions && x == knots.last() && low < x && x == knots.t(j + 1);
                let wanted = integer(usize::from(excepted));
                let value = case.values(x, Side::Right)[j].clone();
                if !ledger.equal(&value, &wanted) {
                    let at = [("j", j.to_string()), ("x", x.to_string())];
                    let claimed =
                        format!("at {x}, outside of [{low}, {high}), d_{j} is multiplied by {wanted}");
                    let found = format!("it is multiplied by {}({x}) = {value}", name(case.k(), j));
                    return Err(case.refuted(at, claimed, found));
                }
            }
            for pieces in case.pieces().spans() {
                let (start, end) = pieces.ends();
                let beyond = end <= low || start >= high;
                if beyond && !ledger.equal(&case.definition_piece(pieces, j), &case.pieces().zero()) {
                    return Err(Stop::Fault(format!("{} lives outside of its support", name(case.k(), j))));
                }
            }
        }
        Ok(())
    }
}

/// On every span k ≤ j ≤ n only G_{j−k+lag}, …, G_j are not 0; the claim has lag 0.
fn local_sum(lag: usize) -> impl Fn(&BasisCase, &mut Ledger) -> Judgement {
    move |case, ledger| {
        for pieces in case.pieces().spans() {
            let j = pieces.span.index();
            if !(case.k()..=case.n()).contains(&j) {
                continue;
            }
            for i in (0..=case.n()).filter(|i| !(j - case.k() + lag..=j).contains(i)) {
                if !ledger.equal(&case.definition_piece(pieces, i), &case.pieces().zero()) {
                    return Err(case.locate(pieces.span, |x| {
                        let value = case.values(x, Side::Right)[i].clone();
                        (!value.is_zero()).then(|| {
                            let at = [("i", i.to_string()), ("j", j.to_string()), ("x", x.to_string())];
                            let g = format!("{}({x})", name(case.k(), i));
                            case.witness(at, format!("d_{i} does not act at {x}"), format!("{g} = {value}"))
                        })
                    }));
                }
            }
        }
        Ok(())
    }
}

/// Σ G_i = total on every span and so, by continuity from one side, at every x of [t_0, t_m].
pub(super) fn affine_invariance(total: BigRational) -> impl Fn(&BasisCase, &mut Ledger) -> Judgement {
    move |case, ledger| {
        for pieces in case.pieces().spans() {
            let sum = pieces.functions.values().iter().fold(case.pieces().zero(), |sum, g| sum.plus(g));
            if !ledger.equal(&sum, &crate::analysis::constant(total.clone())) {
                return Err(case.locate(pieces.span, |x| {
                    let sum: BigRational = case.values(x, Side::Right).iter().sum();
                    (sum != total).then(|| {
                        let at = [("x", x.to_string())];
                        let claimed = "a translation of the control points by v translates the curve by v";
                        case.witness(at, claimed.to_owned(), format!("the curve moves by ({sum})·v"))
                    })
                }));
            }
        }
        Ok(())
    }
}

/// The factors of the control points are ≥ 0 with sum 1 at every x of [t_0, t_m].
pub(super) fn convex_hull(case: &BasisCase, ledger: &mut Ledger) -> Judgement {
    affine_invariance(integer(1))(case, ledger)?;
    for pieces in case.pieces().spans() {
        for (i, g) in pieces.functions.iter() {
            // Positive between the knots; at the knots the one-sided limits are then ≥ 0.
            if !ledger.positive(g) {
                return Err(case.locate_at(pieces.span, always_positive(g).failure(), |x| {
                    let value = case.values(x, Side::Right)[i].clone();
                    (value < integer(0)).then(|| {
                        let at = [("i", i.to_string()), ("x", x.to_string())];
                        let g = format!("{}({x})", name(case.k(), i));
                        case.witness(at, format!("{g} ≥ 0"), format!("{g} = {value}"))
                    })
                }));
            }
        }
    }
    Ok(())
}

/// Weights after a map; the identity in the claim.
struct Mapped<'a> {
    weights: PointWeights<'a, Piece>,
    map: fn((Piece, Piece)) -> (Piece, Piece),
}

impl Weights for Mapped<'_> {
    type Scalar = Piece;
    fn one(&self) -> Piece {
        self.weights.one()
    }
    fn pair(&self, i: usize, d: usize) -> (Piece, Piece) {
        (self.map)(self.weights.pair(i, d))
    }
}

/// On every span k ≤ j ≤ n, for every r: Σ_i d_i^r G_i^{k−r} = Σ_i d_i G_i^k, with the unit vectors as control
/// points, so for all control points at once. For r = k this is d_j^k.
pub(super) fn de_boor_algorithm(
    map: fn((Piece, Piece)) -> (Piece, Piece),
) -> impl Fn(&BasisCase, &mut Ledger) -> Judgement {
    move |case, ledger| {
        let k = case.k();
        for pieces in case.pieces().spans() {
            let j = pieces.span.index();
            if !(k..=case.n()).contains(&j) {
                continue;
            }
            let (zero, one) = (case.pieces().zero(), case.pieces().one());
            let unit = |c: usize| (0..=k).map(|i| if i == c { one.clone() } else { zero.clone() }).collect();
            let points: Vec<Vec<Piece>> = (0..=k).map(unit).collect();
            let ratio = crate::analysis::constant(case.basis().index().ratio().clone());
            let weights = PointWeights::new(case.knots(), ratio, pieces.x.clone());
            let fault = || Stop::Fault(format!("de Boor's algorithm does not run on the span {j}"));
            let levels = de_boor(&Mapped { weights, map }, pieces.span, &points).ok_or_else(fault)?;
            let table =
                crate::spline::by_definition(case.basis(), pieces.span, &pieces.x).map_err(|_| fault())?;
            for (r, level) in levels.iter().enumerate() {
                for c in 0..=k {
                    let terms = level.iter().map(|(i, point)| point[c].times(&table[k - r][i]));
                    let factor = terms.fold(zero.clone(), |sum, term| sum.plus(&term));
                    let wanted = pieces.function(j - k + c);
                    if !ledger.equal(&factor, &wanted) {
                        let (start, end) = pieces.ends();
                        let x = (start + end) / integer(2);
                        let at = [("j", j.to_string()), ("r", r.to_string()), ("x", x.to_string())];
                        let at_middle = |f: &Piece| f.evaluate(&integer(1)).unwrap_or_else(|| integer(0));
                        let i = j - k + c;
                        let claimed =
                            format!("the factor of d_{i} is {}({x}) = {}", name(k, i), at_middle(&wanted));
                        return Err(case.refuted(at, claimed, format!("it is {}", at_middle(&factor))));
                    }
                }
            }
        }
        Ok(())
    }
}

/// P4.2.2: the derivatives at both ends. Where an end knot is repeated too often the formula divides by 0.
pub(super) fn tangents(case: &BasisCase, ledger: &mut Ledger) -> Judgement {
    let (knots, k, n) = (case.knots(), case.k(), case.n());
    let ends = [(knots.first(), knots.t(k + 1), "t_{k+1} − t_0"), (knots.t(n), knots.last(), "t_m − t_n")];
    for (low, high, length) in ends {
        if !ledger.less(low, high) {
            let claimed = format!("the derivative at {low} is a quotient by {length}");
            let found = format!("{length} = 0, while the curve has a derivative there");
            return Err(case.refuted([("x", low.to_string())], claimed, found));
        }
    }
    end_derivatives(Side::Right, false, at_first)(case, ledger)?;
    end_derivatives(Side::Left, false, at_last)(case, ledger)
}

/// Moving α towards 0 moves weight to control points of lower index: for r < 1 (α < 0) every partial sum
/// G_0 + … + G_j is at least the classical one, for r > 1 at most.
pub(super) fn shifts_weight(case: &BasisCase, reversed: bool, ledger: &mut Ledger) -> Judgement {
    let classical = crate::analysis::Pieces::of(&case.basis().with_index(Index::infinity()));
    let ratio_below_one = *case.basis().index().ratio() < integer(1);
    for (pieces, classical) in case.pieces().spans().iter().zip(classical.spans()) {
        let mut difference = case.pieces().zero();
        let living = pieces.functions.values().len();
        for (i, g) in pieces.functions.iter().take(living.saturating_sub(1)) {
            difference = difference.plus(g).minus(&classical.function(i));
            let oriented = if ratio_below_one != reversed { difference.clone() } else { difference.negate() };
            if !oriented.is_zero() && !ledger.positive(&oriented) {
                let (start, end) = pieces.ends();
                let x = (start + end) / integer(2);
                let at = [("j", i.to_string()), ("x", x.to_string())];
                let found = difference.evaluate(&integer(1)).unwrap_or_else(|| integer(0));
                let claimed =
                    "α < 0 moves weight to control points of lower index, α > 1 to higher ones".into();
                return Err(case.refuted(
                    at,
                    claimed,
                    format!("G_0 + … + G_{i} differs by {found} from α = ∞"),
                ));
            }
        }
    }
    Ok(())
}

/// The claims about curves.
pub(super) fn claims() -> Vec<Claim> {
    vec![
        Claim::new(
            "P4.1.1",
            "Proposition 4.1 (1)",
            Form::Basis(
                Statement::new(
                    "Local control: changing d_j changes the curve only for x in [t_j, t_{j+k+1}).",
                    local_control(false),
                )
                .given([Open]),
            ),
        )
        .fails_by(Cause::EndPoints)
        .amended(Form::Basis(
            Statement::new(
                "Changing d_j changes the curve only for x in the closed interval [t_j, t_{j+k+1}]; and at its right end, x = t_{j+k+1}, only if that is t_m and t_j < t_{j+1} = t_m: there d_j acts, and alone.",
                local_control(true),
            )
            .given([Open]),
        ))
        .note("As printed, this and P4.2.1 contradict each other at t_m: by P4.2.1 the curve is d_n there, so d_n acts, and t_m is not in [t_n, t_m). The value at t_m is the limit from the left."),
        Claim::new(
            "P4.1.2",
            "Proposition 4.1 (2)",
            Form::Basis(
                Statement::new(
                    "For k ≤ j ≤ n, t_j < t_{j+1}, x in [t_j, t_{j+1}): G_α(x) = Σ_{i=j−k}^j d_i G_i^k(x).",
                    local_sum(0),
                )
                .given([Open]),
            ),
        ),
        Claim::new(
            "P4.1.3",
            "Proposition 4.1 (3)",
            Form::Basis(
                Statement::new(
                    "Convex hull: G_α(x) is a convex combination of the control points, for every x in [t_0, t_m].",
                    convex_hull,
                )
                .given([Open]),
            ),
        ),
        Claim::new(
            "P4.1.4",
            "Proposition 4.1 (4)",
            Form::Basis(
                Statement::new(
                    "Affine invariance: T(G_α(x)) = Σ T(d_i) G_i^k(x) for every affine T.",
                    affine_invariance(integer(1)),
                )
                .given([Open]),
            ),
        ),
        Claim::new(
            "P4.2.1",
            "Proposition 4.2 (1)",
            Form::Basis(
                Statement::new(
                    "G_α(t_0) = d_0 and G_α(t_m) = d_n (limit from the left).",
                    interpolation(|n| (0, n)),
                )
                .given([Open]),
            ),
        )
        .fails_by(Cause::EndKnots)
        .amended(Form::Basis(
            Statement::new("The same if t_k < t_{k+1} and t_n < t_{n+1}.", interpolation(|n| (0, n)))
                .given([Open, FirstSpan, LastSpan]),
        ))
        .note(STATED_IN_THE_PROOF),
        Claim::new(
            "P4.2.2",
            "Proposition 4.2 (2)",
            Form::Basis(
                Statement::new(
                    "G_α′(t_0) = kα/((α−1)(t_{k+1}−t_0)) (d_1−d_0) and G_α′(t_m) = k(α−1)/(α(t_m−t_n)) (d_n−d_{n−1}).",
                    tangents,
                )
                .given([Open, DegreeAtLeast(1)]),
            ),
        )
        .fails_by(Cause::EndKnots)
        .amended(Form::Basis(
            Statement::new("The same if t_k < t_{k+1} and t_n < t_{n+1}.", tangents).given([
                Open,
                DegreeAtLeast(1),
                FirstSpan,
                LastSpan,
            ]),
        ))
        .note(STATED_IN_THE_PROOF),
        Claim::new(
            "P4.3",
            "Proposition 4.3",
            Form::Basis(
                Statement::new(
                    "U symmetric, the control polygon symmetric with respect to the perpendicular bisector D of (d_0, d_n): G_α and G_{1−α} are symmetric to each other with respect to D, x against t_0+t_m−x.",
                    symmetry(true, |n, i| n - i),
                )
                .given([Open, Symmetric]),
            ),
        )
        .fails_by(Cause::InnerMultiplicity)
        .amended(Form::Basis(
            Statement::new(
                "The same for every x in [t_0, t_m] that is not a knot inside (t_0, t_m) of multiplicity greater than k; at every such knot it fails for some polygon.",
                symmetry(false, |n, i| n - i),
            )
            .given([Open, Symmetric]),
        ))
        .note("For every such polygon at once: the reflection exchanges d_i and d_{n−i}, so the claim is that G_i(t_0+t_m−x) for α is G_{n−i}(x) for 1−α."),
        Claim::new(
            "T4.1",
            "Theorem 4.1",
            Form::Basis(Statement::new(
                "de Boor, for any U: for k ≤ j ≤ m−k−1, t_j < t_{j+1}, x in [t_j, t_{j+1}): G_α(x) = Σ_{i=j−k+r}^j d_i^r(x) G_i^{k−r}(x) for every r ≤ k, and G_α(x) = d_j^k(x).",
                de_boor_algorithm(|pair| pair),
            )),
        ),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::claims::hypothesis::Hypothesis;
    use crate::claims::small_cases::refuted;

    #[test]
    fn false_variants_are_refuted() {
        assert!(refuted(local_sum(1), [Open]), "one control point fewer");
        assert!(refuted(affine_invariance(integer(2)), [Open]), "Σ G = 2");
        assert!(refuted(convex_hull, []), "convex hull where U is not open");
        let swapped = de_boor_algorithm(|(w, complement)| (complement, w));
        assert!(refuted(swapped, [Open]), "w and 1 − w exchanged in de Boor's algorithm");
        assert!(
            refuted(|case, ledger| shifts_weight(case, true, ledger), [Open, Hypothesis::FiniteIndex]),
            "shift"
        );
    }
}
