//! Section 3, first half: support, positivity, partition of unity, symmetry, values at the ends, continuity.

use crate::analysis::{Piece, SpanPieces, always_positive};
use crate::scalar::{BigRational, Ring, integer};
use crate::spline::{KnotVector, Side, Span};

use super::case::{BasisCase, definition_values};
use super::cause::Cause;
use super::claim::{Claim, Form};
use super::hypothesis::Hypothesis::{
    BaseInterval, FirstSpan, InteriorMultiplicityAtMostDegree, LastSpan, Open, Symmetric,
};
use super::hypothesis::STATED_IN_THE_PROOF;
use super::statement::Statement;
use super::verdict::{Judgement, Ledger, Stop};

/// The function `G_i^k` in words.
pub(super) fn name(k: usize, i: usize) -> String {
    format!("G_{i}^{k}")
}

/// Every x outside of the open interval (t_i, t_{i+k+1}) at which a knot or a region begins: t_i itself, the
/// other knots, and a point beyond either end.
fn outside(case: &BasisCase, i: usize) -> Vec<BigRational> {
    let (low, high) = case.basis().support(i);
    let mut places = vec![low.clone(), high.clone()];
    places.extend(case.knots().stop_knots().map(|(t, _)| t.clone()).filter(|t| t < low || t > high));
    places.extend([case.knots().first() - integer(1), case.knots().last() + integer(1)]);
    places
}

/// Is x an end of the support at which G_i^k is 1: t_i if t_i = t_{i+k} < t_{i+k+1}, and t_m if
/// t_i < t_{i+1} = t_m (the value there is the limit from the left)?
fn full_end(case: &BasisCase, i: usize, x: &BigRational) -> bool {
    let (knots, k) = (case.knots(), case.k());
    let (low, high) = case.basis().support(i);
    low < high
        && ((x == low && x == knots.t(i + k)) || (x == high && x == knots.last() && x == knots.t(i + 1)))
}

/// G_i^k = 0 at every x outside of (t_i, t_{i+k+1}); with `exceptions`, except at the full ends, where it is 1.
pub(super) fn local_support(exceptions: bool) -> impl Fn(&BasisCase, &mut Ledger) -> Judgement {
    move |case, ledger| {
        for i in 0..=case.n() {
            for x in outside(case, i) {
                let wanted = integer(usize::from(exceptions && full_end(case, i, &x)));
                let value = case.values(&x, Side::Right)[i].clone();
                if !ledger.equal(&value, &wanted) {
                    let g = format!("{}({x})", name(case.k(), i));
                    let at = [("i", i.to_string()), ("x", x.to_string())];
                    return Err(case.refuted(at, format!("{g} = {wanted}"), format!("{g} = {value}")));
                }
            }
            // Between the knots, for every x: the definition over the variable u.
            let (low, high) = case.basis().support(i);
            for pieces in case.pieces().spans() {
                let (start, end) = pieces.ends();
                let beyond = end <= low || start >= high;
                if beyond && !ledger.equal(&case.definition_piece(pieces, i), &case.pieces().zero()) {
                    return Err(Stop::Fault(format!("{} lives outside of its support", name(case.k(), i))));
                }
            }
        }
        Ok(())
    }
}

/// The spans inside the support of G_i^k.
pub(super) fn support_spans(case: &BasisCase, i: usize) -> impl Iterator<Item = &SpanPieces> {
    let (first, last) = (i, i + case.k());
    case.pieces().spans().iter().filter(move |pieces| (first..=last).contains(&pieces.span.index()))
}

/// G_i^k − threshold > 0 on the open support, knots included; the claim has threshold 0.
pub(super) fn positivity(threshold: BigRational) -> impl Fn(&BasisCase, &mut Ledger) -> Judgement {
    move |case, ledger| {
        for i in 0..=case.n() {
            let low = case.basis().support(i).0;
            for pieces in support_spans(case, i) {
                let g = pieces.function(i).minus(&crate::analysis::constant(threshold.clone()));
                let start = pieces.ends().0;
                let at_start = g.evaluate(&integer(0)).unwrap_or_else(|| integer(0));
                let start_holds = start == low || ledger.less(&integer(0), &at_start);
                if !(start_holds && ledger.positive(&g)) {
                    return Err(case.locate_at(pieces.span, always_positive(&g).failure(), |x| {
                        let value = case.values(x, Side::Right)[i].clone();
                        let g = format!("{}({x})", name(case.k(), i));
                        (x != low && value <= threshold).then(|| {
                            let at = [("i", i.to_string()), ("x", x.to_string())];
                            case.witness(at, format!("{g} > {threshold}"), format!("{g} = {value}"))
                        })
                    }));
                }
            }
        }
        Ok(())
    }
}

/// Σ_{i=0}^n G_i^k = Σ_{i=j−k}^j G_i^k = total on every span j; with `only_base`, exactly on those with k ≤ j ≤ n.
pub(super) fn partition_of_unity(
    only_base: bool,
    total: BigRational,
) -> impl Fn(&BasisCase, &mut Ledger) -> Judgement {
    move |case, ledger| {
        let wanted = crate::analysis::constant(total.clone());
        for pieces in case.pieces().spans() {
            let j = pieces.span.index();
            // Only G_{j−k}, …, G_j live on the span, so both sums are the same one; the definition of all
            // n + 1 functions confirms it.
            let local = pieces.functions.values().iter().fold(case.pieces().zero(), |sum, g| sum.plus(g));
            let defined = (0..=case.n()).map(|i| case.definition_piece(pieces, i));
            let all = defined.fold(case.pieces().zero(), |sum, g| sum.plus(&g));
            let should_equal = !only_base || (case.k()..=case.n()).contains(&j);
            let as_claimed = if should_equal {
                ledger.equal(&all, &wanted) && ledger.equal(&local, &wanted)
            } else {
                ledger.differ(&all, &wanted)
            };
            if !as_claimed {
                return Err(case.locate(pieces.span, |x| {
                    let sum: BigRational = case.values(x, Side::Right).iter().sum();
                    ((sum == total) != should_equal).then(|| {
                        let at = [("j", j.to_string()), ("x", x.to_string())];
                        let relation = if should_equal { "=" } else { "≠" };
                        let claimed = format!("Σ G_i^{}({x}) {relation} {total}", case.k());
                        case.witness(at, claimed, format!("the sum is {sum}"))
                    })
                }));
            }
        }
        Ok(())
    }
}

/// ^αG_i(t_0 + t_m − x) = ^{1−α}G_{partner(n, i)}(x): between the knots as functions, and at the knots; the
/// claim's partner is n − i. Without `at_jumps`: except at the knots inside (t_0, t_m) of multiplicity > k, where it
/// fails for some i.
pub(super) fn symmetry(
    at_jumps: bool,
    partner: fn(usize, usize) -> usize,
) -> impl Fn(&BasisCase, &mut Ledger) -> Judgement {
    move |case, ledger| {
        let (knots, n) = (case.knots(), case.n());
        let conjugate = case.conjugate_basis();
        let values_at = |x: &BigRational, i: usize| {
            let left = case.values(&knots.mirror(x), Side::Right)[i].clone();
            (left, definition_values(&conjugate, x, Side::Right)[partner(n, i)].clone())
        };
        let witness = |x: &BigRational, i: usize, left: &BigRational, right: &BigRational| {
            let at = [("i", i.to_string()), ("x", x.to_string())];
            let (k, mirrored, other) = (case.k(), knots.mirror(x), partner(n, i));
            let claimed = format!("^αG_{i}^{k}({mirrored}) = ^(1−α)G_{other}^{k}({x})");
            case.bare_witness(at, claimed, format!("the left side is {left} and the right side {right}"))
        };
        for (x, p) in knots.stop_knots() {
            let inner = x != knots.first() && x != knots.last();
            if !at_jumps && inner && p > case.k() {
                let fails = (0..=n).any(|i| {
                    let (left, right) = values_at(x, i);
                    ledger.differ(&left, &right)
                });
                if fails {
                    continue;
                }
                let claimed = format!("symmetry fails at {x} for some i");
                return Err(case.refuted([("x", x.to_string())], claimed, "it holds for all".into()));
            }
            for i in 0..=n {
                let (left, right) = values_at(x, i);
                if !ledger.equal(&left, &right) {
                    return Err(Stop::Refuted(Box::new(witness(x, i, &left, &right))));
                }
            }
        }
        for pieces in case.conjugate_pieces().spans() {
            let Some(mirrored) = mirrored_span(knots, pieces.span) else {
                return Err(Stop::Fault("a symmetric knot vector without a mirrored span".into()));
            };
            let Some(other) = case.pieces().on(mirrored) else { continue };
            for i in 0..=n {
                // t_0 + t_m − x turns the coordinate u of one span into 1/u of the other.
                let left = other.function(i).reciprocal_argument();
                if !ledger.equal(&left, &pieces.function(partner(n, i))) {
                    return Err(case.locate(pieces.span, |x| {
                        let (left, right) = values_at(x, i);
                        (left != right && knots.multiplicity(x) == 0).then(|| witness(x, i, &left, &right))
                    }));
                }
            }
        }
        Ok(())
    }
}

/// The span onto which x ↦ t_0 + t_m − x takes a span of a symmetric knot vector.
pub(super) fn mirrored_span(knots: &KnotVector, span: Span) -> Option<Span> {
    let start = knots.mirror(knots.ends(span).ok()?.1);
    knots.span_at(&start, Side::Right)
}

/// An equality G_i^d = G_j^e of values at one end of the knots.
struct EndEquality {
    d: usize,
    i: usize,
    e: usize,
    j: usize,
}

/// The equalities of L3.6 and L3.7 at t_0 or, from the left, at t_m.
fn end_values(
    side: Side,
    equalities: fn(k: usize, n: usize, r: usize) -> Vec<EndEquality>,
) -> impl Fn(&BasisCase, &mut Ledger) -> Judgement {
    move |case, ledger| {
        let x = if side == Side::Right { case.knots().first() } else { case.knots().last() };
        let Some(table) = case.jet_table(x, side, 0) else { return Ok(()) };
        for r in 0..case.k() {
            for EndEquality { d, i, e, j } in equalities(case.k(), case.n(), r) {
                let value = |d: usize, i: usize| table[d][i].coefficients()[0].clone();
                let (left, right) = (value(d, i), value(e, j));
                if !ledger.equal(&left, &right) {
                    let at = [("r", r.to_string()), ("x", x.to_string())];
                    let claimed = format!("{} = {} at {x} ({side} limit)", name(d, i), name(e, j));
                    let found = format!("the left side is {left} and the right side {right}");
                    return Err(case.refuted_at_large(at, claimed, found));
                }
            }
        }
        Ok(())
    }
}

/// L3.6: G_r^{k−r}(t_0) = G_{r+1}^{k−r−1}(t_0) and G_{r+1}^{k−r}(t_0) = G_{r+2}^{k−r−1}(t_0).
fn at_first_knot(k: usize, _: usize, r: usize) -> Vec<EndEquality> {
    let (d, e) = (k - r, k - r - 1);
    vec![EndEquality { d, i: r, e, j: r + 1 }, EndEquality { d, i: r + 1, e, j: r + 2 }]
}

/// L3.7: G_n^{k−r} → the limit of G_n^{k−r−1}, and for k ≥ 2 the same with n − 1.
fn at_last_knot(k: usize, n: usize, r: usize) -> Vec<EndEquality> {
    let (d, e) = (k - r, k - r - 1);
    let mut equalities = vec![EndEquality { d, i: n, e, j: n }];
    if k >= 2 {
        equalities.push(EndEquality { d, i: n - 1, e, j: n - 1 });
    }
    equalities
}

/// Every piece is a quotient of polynomials without a pole on the closed span; it agrees with the definition
/// over the variable u.
fn piecewise_rational(case: &BasisCase, ledger: &mut Ledger) -> Judgement {
    for pieces in case.pieces().spans() {
        for (i, g) in pieces.functions.iter() {
            if !ledger.equal(g, &case.definition_piece(pieces, i)) {
                return Err(Stop::Fault(format!("two pieces of {} differ", name(case.k(), i))));
            }
            regular(case, pieces, i, g, ledger)?;
        }
    }
    Ok(())
}

/// No pole on the closed span: the denominator is positive between the knots, and the limits at them finite.
pub(super) fn regular(
    case: &BasisCase,
    pieces: &SpanPieces,
    i: usize,
    g: &Piece,
    ledger: &mut Ledger,
) -> Judgement {
    let denominator = Piece::from_polynomial(g.denominator().clone());
    let finite_ends = g.evaluate(&integer(0)).is_some() && g.at_infinity().is_some();
    if finite_ends && ledger.positive(&denominator) {
        return Ok(());
    }
    let (start, end) = pieces.ends();
    let at = [("i", i.to_string()), ("span", format!("[{start}, {end}]"))];
    Err(case.refuted(at, format!("{} has no pole", name(case.k(), i)), "its denominator vanishes".into()))
}

/// The value and the limit from the left of every function agree at every knot inside (t_0, t_m).
pub(super) fn continuity(case: &BasisCase, ledger: &mut Ledger) -> Judgement {
    for (x, _) in case.knots().inner_stop_knots() {
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

/// P3.1.3: at t_0 exactly G_0 is 1, at t_m from the left exactly G_n; all others are 0.
pub(super) fn interpolation(
    one_at: fn(n: usize) -> (usize, usize),
) -> impl Fn(&BasisCase, &mut Ledger) -> Judgement {
    move |case, ledger| {
        let (first, last) = one_at(case.n());
        let ends = [(case.knots().first(), Side::Right, first), (case.knots().last(), Side::Left, last)];
        for (x, side, one_at) in ends {
            for (i, value) in case.values(x, side).iter().enumerate() {
                let wanted = integer(usize::from(i == one_at));
                if !ledger.equal(value, &wanted) {
                    let at = [("i", i.to_string()), ("x", x.to_string())];
                    let g = format!("{}({x})", name(case.k(), i));
                    return Err(case.refuted(at, format!("{g} = {wanted}"), format!("{g} = {value}")));
                }
            }
        }
        Ok(())
    }
}

/// The claims on support, values and continuity.
pub(super) fn claims() -> Vec<Claim> {
    vec![
        Claim::new(
            "T3.5.1",
            "Theorem 3.5 (1)",
            Form::Basis(Statement::new(
                "Local support: G_i^k(x) = 0 for every x not in the open interval (t_i, t_{i+k+1}).",
                local_support(false),
            )),
        )
        .fails_by(Cause::EndPoints)
        .amended(Form::Basis(Statement::new(
            "G_i^k(x) = 0 for every x not in the closed interval [t_i, t_{i+k+1}]. It is 0 at the ends of that as well, with two exceptions, where it is 1: x = t_i if t_i = t_{i+k} < t_{i+k+1}, and x = t_m if t_i < t_{i+1} = t_m.",
            local_support(true),
        )))
        .note("At the exceptions k + 1 knots of the function coincide, and it begins or ends with a jump. The value at t_m is the limit from the left, here and everywhere."),
        Claim::new(
            "T3.5.2",
            "Theorem 3.5 (2)",
            Form::Basis(Statement::new(
                "Positivity: G_i^k(x) > 0 for x in (t_i, t_{i+k+1}).",
                positivity(integer(0)),
            )),
        ),
        Claim::new(
            "T3.5.3",
            "Theorem 3.5 (3)",
            Form::Basis(Statement::new(
                "Partition of unity: for every j with t_j < t_{j+1} and all x in [t_j, t_{j+1}): Σ_{i=0}^n G_i^k(x) = Σ_{i=j−k}^j G_i^k(x) = 1.",
                partition_of_unity(false, integer(1)),
            )),
        )
        .fails_by(Cause::IndexRange)
        .amended(Form::Basis(Statement::new(
            "For t_j < t_{j+1}: Σ_{i=0}^n G_i^k = 1 on [t_j, t_{j+1}) if and only if k ≤ j ≤ n, that is on [t_k, t_{n+1}); and there it is Σ_{i=j−k}^j G_i^k.",
            partition_of_unity(true, integer(1)),
        )))
        .note("On any other span a function that does not exist (i < 0 or i > n) would be positive, so the sum is less than 1 there."),
        Claim::new(
            "T3.5.4",
            "Theorem 3.5 (4)",
            Form::Basis(
                Statement::new(
                    "Symmetry: if U is symmetric then for all x in [t_0, t_m] and all i: ^αG_i^k(t_0+t_m−x) = ^{1−α}G_{n−i}^k(x).",
                    symmetry(true, |n, i| n - i),
                )
                .given([Symmetric]),
            ),
        )
        .fails_by(Cause::InnerMultiplicity)
        .amended(Form::Basis(
            Statement::new(
                "The same for every x in [t_0, t_m] that is not a knot inside (t_0, t_m) of multiplicity greater than k; at every such knot it fails for some i.",
                symmetry(false, |n, i| n - i),
            )
            .given([Symmetric]),
        ))
        .note("At such a knot some function jumps, and reflection turns the value from the right into one from the left."),
        Claim::new(
            "L3.6",
            "Lemma 3.6",
            Form::Basis(
                Statement::new(
                    "Open U, 0 ≤ r ≤ k−1: G_r^{k−r}(t_0) = G_{r+1}^{k−r−1}(t_0) and G_{r+1}^{k−r}(t_0) = G_{r+2}^{k−r−1}(t_0).",
                    end_values(Side::Right, at_first_knot),
                )
                .given([Open]),
            ),
        ),
        Claim::new(
            "L3.7",
            "Lemma 3.7",
            Form::Basis(
                Statement::new(
                    "Open U, 0 ≤ r ≤ k−1, limits from the left at t_m: G_n^{k−r} has the limit of G_n^{k−r−1}; for k ≥ 2, G_{n−1}^{k−r} has that of G_{n−1}^{k−r−1}.",
                    end_values(Side::Left, at_last_knot),
                )
                .given([Open]),
            ),
        ),
        Claim::new(
            "P3.1.1",
            "Proposition 3.1 (1)",
            Form::Basis(Statement::new("Every G_i^k is piecewise rational.", piecewise_rational)),
        ),
        Claim::new(
            "P3.1.2",
            "Proposition 3.1 (2)",
            Form::Basis(
                Statement::new(
                    "Every G_i^k is C⁰ on [t_0, t_m) if no interior knot has multiplicity greater than k.",
                    continuity,
                )
                .given([BaseInterval, InteriorMultiplicityAtMostDegree]),
            ),
        ),
        Claim::new(
            "P3.1.3",
            "Proposition 3.1 (3)",
            Form::Basis(
                Statement::new(
                    "Open U: G_0^k(t_0) = 1 and G_i^k(t_0) = 0 for 0 < i ≤ n; at t_m from the left G_n^k → 1 and G_i^k → 0 for i < n.",
                    interpolation(|n| (0, n)),
                )
                .given([Open]),
            ),
        )
        .fails_by(Cause::EndKnots)
        .amended(Form::Basis(
            Statement::new(
                "The same if t_k < t_{k+1} and t_n < t_{n+1}: the end knots have multiplicity k + 1 and no more.",
                interpolation(|n| (0, n)),
            )
            .given([Open, FirstSpan, LastSpan]),
        ))
        .note(STATED_IN_THE_PROOF),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::claims::hypothesis::Hypothesis;
    use crate::claims::small_cases::refuted;

    #[test]
    fn false_variants_are_refuted() {
        assert!(refuted(positivity(BigRational::new(1.into(), 100.into())), []), "G > 1/100");
        assert!(refuted(partition_of_unity(true, integer(2)), []), "Σ = 2");
        assert!(refuted(symmetry(false, |_, i| i), [Symmetric]), "n − i replaced by i");
        assert!(refuted(interpolation(|n| (1, n)), [Open, FirstSpan, LastSpan]), "G_1(t_0) = 1");
        assert!(refuted(continuity, []), "continuity with no hypothesis on multiplicities");
        let shifted = |k, n, r| {
            let mut equalities = at_first_knot(k, n, r);
            equalities[0].j += 1;
            equalities
        };
        assert!(refuted(end_values(Side::Right, shifted), [Open]), "L3.6 with a shifted index");
        let shifted = |k, n, r| {
            let mut equalities = at_last_knot(k, n, r);
            equalities[0].j -= 1;
            equalities
        };
        assert!(refuted(end_values(Side::Left, shifted), [Open]), "L3.7 with a shifted index");
        assert!(
            refuted(local_support(false), [Hypothesis::InnerMultiplicityAtMostDegree]),
            "support without exceptions"
        );
    }

    #[test]
    fn a_pole_is_noticed() {
        use crate::claims::case::Origin;
        use crate::scalar::RationalAlgebra;
        use crate::spline::{Basis, Index};

        let knots = KnotVector::bernstein(1, &integer(0), &integer(1)).unwrap();
        let case = BasisCase::new(Basis::new(knots, 1, Index::infinity()).unwrap(), Origin::User);
        let span = &case.pieces().spans()[0];
        let u = Piece::variable(&integer(1));
        let judged = |g: Option<Piece>| regular(&case, span, 0, &g.unwrap(), &mut Ledger::default());
        assert!(judged(u.plus(&u.one()).reciprocal()).is_ok());
        assert!(judged(u.minus(&u.one()).reciprocal()).is_err(), "between the knots");
        assert!(judged(u.reciprocal()).is_err(), "at the first knot");
        assert!(judged(Some(u)).is_err(), "at the second knot");
    }
}
