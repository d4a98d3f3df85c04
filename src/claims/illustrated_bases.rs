//! Illustrations 5.1 to 5.4 and Remark 5.1: the bases of U0 to U13.

use crate::analysis::{Enclosure, Piece, Pieces, coefficient_rows, is_combination, rank};
use crate::scalar::{BigRational, Ring, rational};
use crate::spline::{Index, Side};

use super::basis::{name, regular, support_spans, symmetry};
use super::case::BasisCase;
use super::cause::Cause;
use super::claim::{Claim, Form};
use super::illustrations::{
    Illustration, case_of, each, every_basis, largest, named, of_degree, refuted, together, with_indices,
};
use super::instances::Instance;
use super::maximum::{Except, Reading, conjecture};
use super::verdict::{Judgement, Ledger, Stop};

const ALL: [&str; 14] =
    ["U0", "U1", "U2", "U3", "U4", "U5", "U6", "U7", "U8", "U9", "U10", "U11", "U12", "U13"];
const PERIODIC: [&str; 4] = ["U0", "U1", "U2", "U3"];

/// G_i(x) = G_0(t_0 − t_i + x): uniform knots have the same coordinate u on every span, moved by i spans.
fn translation(step: usize) -> impl Fn(&BasisCase, &mut Ledger) -> Judgement {
    move |case, ledger| {
        let spans = case.pieces().spans();
        for i in 0..=case.n() {
            for (s, pieces) in spans.iter().enumerate() {
                let source = s.checked_sub(step * i).and_then(|s| spans.get(s));
                let wanted = source.map_or_else(|| case.pieces().zero(), |pieces| pieces.function(0));
                if !ledger.equal(&pieces.function(i), &wanted) {
                    return Err(case.locate(pieces.span, |x| {
                        let moved = case.knots().first() - case.knots().t(step * i) + x;
                        let value = case.values(x, Side::Right)[i].clone();
                        let other = case.values(&moved, Side::Right)[0].clone();
                        (value != other).then(|| {
                            let at = [("i", i.to_string()), ("x", x.to_string())];
                            let (g, h) = (name(case.k(), i), name(case.k(), 0));
                            let claimed = format!("{g}({x}) = {h}({moved})");
                            case.witness(at, claimed, format!("they are {value} and {other}"))
                        })
                    }));
                }
            }
        }
        Ok(())
    }
}

/// Every function is the same for all the indices (`differ` = false), or different for any two.
fn influence(differ: bool) -> impl Fn(&Illustration, &mut Ledger) -> Judgement {
    move |illustration, ledger| {
        for instance in &illustration.instances {
            let cases: Vec<_> = instance.indices.iter().map(|index| case_of(instance, index)).collect();
            for (c, first) in cases.iter().enumerate() {
                for second in &cases[c + 1..] {
                    for i in 0..=first.n() {
                        same_or_not(first, second, i, differ, ledger)
                            .map_err(|stop| named(instance, stop))?;
                    }
                }
            }
        }
        Ok(())
    }
}

fn same_or_not(
    first: &BasisCase,
    second: &BasisCase,
    i: usize,
    differ: bool,
    ledger: &mut Ledger,
) -> Judgement {
    let mut spans = first.pieces().spans().iter().zip(second.pieces().spans());
    let g = name(first.k(), i);
    let other = second.basis().index();
    if differ {
        if spans.any(|(one, two)| ledger.differ(&one.function(i), &two.function(i))) {
            return Ok(());
        }
        let claimed = format!("{g} is another function for α = {other}");
        return Err(first.refuted([("i", i.to_string())], claimed, "it is the same".into()));
    }
    for (one, two) in spans {
        if !ledger.equal(&one.function(i), &two.function(i)) {
            return Err(first.locate(one.span, |x| {
                let value = |case: &BasisCase| case.values(x, Side::Right)[i].clone();
                let (value, other_value) = (value(first), value(second));
                (value != other_value).then(|| {
                    let at = [("i", i.to_string()), ("x", x.to_string())];
                    let claimed = format!("{g}({x}) is the same for α = {other}");
                    first.witness(at, claimed, format!("it is {value}, and {other_value} for α = {other}"))
                })
            }));
        }
    }
    Ok(())
}

/// The closure of {G_i ≠ 0} is [t_i, t_{i+k+1}], or [t_i, t_{i+width(k)}]: G_i is 0 on the spans outside and not 0
/// on those inside.
fn support(width: fn(k: usize) -> usize) -> impl Fn(&BasisCase, &mut Ledger) -> Judgement {
    move |case, ledger| support_of(width(case.k()), case, ledger)
}

fn support_of(width: usize, case: &BasisCase, ledger: &mut Ledger) -> Judgement {
    for i in 0..=case.n() {
        let (low, high) = (case.knots().t(i), case.knots().t(i + width));
        for pieces in case.pieces().spans() {
            let (start, end) = pieces.ends();
            let (inside, g) = (low <= start && end <= high, case.definition_piece(pieces, i));
            let as_claimed =
                if inside { ledger.positive(&g) } else { ledger.equal(&g, &case.pieces().zero()) };
            if !as_claimed {
                let at = [("i", i.to_string()), ("span", format!("[{start}, {end})"))];
                let claimed = format!("the support of {} is [{low}, {high}]", name(case.k(), i));
                return Err(case.refuted(at, claimed, "it is another".into()));
            }
        }
    }
    Ok(())
}

/// sup |^αG_i − ^∞G_i| over the whole line, enclosed.
fn deviation(case: &BasisCase, classical: &BasisCase, i: usize) -> Result<Enclosure, Stop> {
    let mut differences: Vec<Piece> = Vec::new();
    for (one, two) in support_spans(case, i).zip(support_spans(classical, i)) {
        let difference = one.function(i).minus(&two.function(i));
        differences.push(difference.negate());
        differences.push(difference);
    }
    largest(&differences)
}

/// The deviation from α = ∞ grows strictly along each of the chains of indices.
fn effect_grows(chains: [&'static [&'static str]; 2]) -> impl Fn(&Illustration, &mut Ledger) -> Judgement {
    move |illustration, ledger| {
        for instance in &illustration.instances {
            let classical = case_of(instance, &Index::infinity());
            for i in 0..=classical.n() {
                for chain in chains {
                    let mut last: Option<(Enclosure, &str)> = None;
                    for &alpha in chain {
                        let Ok(index) = alpha.parse() else { continue };
                        let next = deviation(&case_of(instance, &index), &classical, i)?;
                        if let Some((last, before)) = &last
                            && !ledger.less(&last.hi, &next.lo)
                        {
                            let at = [("i", i.to_string())];
                            let claimed = format!("the deviation grows from α = {before} to α = {alpha}");
                            let found = format!(
                                "it lies in [{}, {}] and then in [{}, {}]",
                                last.lo, last.hi, next.lo, next.hi
                            );
                            return Err(refuted(instance, &at, claimed, found));
                        }
                        last = Some((next, alpha));
                    }
                }
            }
        }
        Ok(())
    }
}

/// Exactly the functions of these indices jump inside (t_0, t_m); the others are continuous, and all are one-sided
/// differentiable where they are.
fn jumps(of: fn(&Instance) -> &'static [usize]) -> impl Fn(&Illustration, &mut Ledger) -> Judgement {
    move |illustration, ledger| {
        for instance in &illustration.instances {
            for index in &instance.indices {
                let case = case_of(instance, index);
                for pieces in case.pieces().spans() {
                    for (i, g) in pieces.functions.iter() {
                        regular(&case, pieces, i, g, ledger).map_err(|stop| named(instance, stop))?;
                    }
                }
                for i in 0..=case.n() {
                    let jump = case
                        .knots()
                        .inner_stop_knots()
                        .find(|(x, _)| case.values(x, Side::Left)[i] != case.values(x, Side::Right)[i]);
                    let claimed = of(instance).contains(&i);
                    if !ledger.count(usize::from(jump.is_some()), usize::from(claimed)) {
                        let at = [("α", index.to_string()), ("i", i.to_string())];
                        let g = name(case.k(), i);
                        let (yes, no) = (format!("{g} has a jump"), format!("{g} has no jump"));
                        let (claimed, found) = if claimed { (yes, no) } else { (no, yes) };
                        return Err(refuted(instance, &at, claimed, found));
                    }
                }
            }
        }
        Ok(())
    }
}

/// U11 and U13: supports [t_0, t_5] of G_2 and [t_3, t_8] of G_3, as point sets.
fn supports_at_triple_knot(case: &BasisCase, ledger: &mut Ledger) -> Judgement {
    let knots = case.knots();
    for (i, from, to) in [(2, 0, 5), (3, 3, 8)] {
        let (low, high) = case.basis().support(i);
        if !(ledger.equal(low, knots.t(from)) && ledger.equal(high, knots.t(to))) {
            let claimed = format!("the support of {} is [t_{from}, t_{to}]", name(case.k(), i));
            return Err(case.refuted([("i", i.to_string())], claimed, format!("it is [{low}, {high}]")));
        }
    }
    Ok(())
}

/// sup |^5G_i − ^∞G_i| ≤ bound over all the instances.
fn close_to_classical(bound: BigRational) -> impl Fn(&Illustration, &mut Ledger) -> Judgement {
    move |illustration, ledger| {
        let mut worst: Option<(Enclosure, &Instance, usize)> = None;
        for instance in &illustration.instances {
            let Some(index) = instance.indices.first() else { continue };
            let (case, classical) = (case_of(instance, index), case_of(instance, &Index::infinity()));
            for i in 0..=case.n() {
                let deviation = deviation(&case, &classical, i)?;
                if ledger.less(&bound, &deviation.lo) {
                    let at = [("α", index.to_string()), ("i", i.to_string())];
                    let claimed = format!("sup |^αG_{i} − ^∞G_{i}| ≤ {bound}");
                    return Err(refuted(instance, &at, claimed, format!("it is at least {}", deviation.lo)));
                }
                if !ledger.less(&deviation.hi, &bound) {
                    return Err(Stop::Undecided(format!("the enclosure of the supremum contains {bound}")));
                }
                if worst.as_ref().is_none_or(|(worst, ..)| worst.hi < deviation.hi) {
                    worst = Some((deviation, instance, i));
                }
            }
        }
        if let Some((enclosure, instance, i)) = worst {
            let Enclosure { lo, hi, .. } = enclosure;
            ledger.remark(format!(
                "The largest deviation lies in [{lo}, {hi}]; {}, i = {i} has it.",
                instance.name
            ));
        }
        Ok(())
    }
}

/// For α = ∞ every piece is a polynomial in x of degree ≤ k, and the curve with X = G_0 and Y = G_2 lies on a conic
/// on its first span, where it is a parabola. For every other index it lies on none there: 1, X, Y, X², XY and Y² are
/// independent. Quadratic polynomial curves consist of arcs of parabolas and of lines.
fn strictly_larger(case: &BasisCase, ledger: &mut Ledger) -> Judgement {
    let Some(span) = case.pieces().spans().first() else { return Ok(()) };
    let (x, y) = (span.function(0), span.function(2));
    let monomials = vec![x.one(), x.clone(), y.clone(), x.power(2), x.times(&y), y.power(2)];
    let independent = rank(&coefficient_rows([monomials])) == 6;
    if !ledger.count(usize::from(independent), usize::from(!case.basis().index().is_infinite())) {
        let (start, end) = span.ends();
        let words = |independent: bool| if independent { "on no conic" } else { "on a conic" };
        let claimed = format!("for {start} < x < {end} the curve lies {}", words(!independent));
        return Err(case.refuted([], claimed, format!("it lies {}", words(independent))));
    }
    let polynomial = |pieces: &crate::analysis::SpanPieces, g: &Piece| {
        let monomials: Vec<_> = (0..=case.k()).map(|d| pieces.x.power(d)).collect();
        is_combination(&monomials, g)
    };
    let count = |pieces: &Pieces| {
        let all =
            pieces.spans().iter().flat_map(|span| span.functions.values().iter().map(move |g| (span, g)));
        all.fold((0, 0), |(of, all), (span, g)| (of + usize::from(polynomial(span, g)), all + 1))
    };
    let (polynomials, all) = count(case.pieces());
    if !case.basis().index().is_infinite() || ledger.count(polynomials, all) {
        return Ok(());
    }
    let claimed = "the pieces are polynomials for α = ∞".into();
    Err(case.refuted([], claimed, format!("{polynomials} of {all} are polynomials")))
}

/// The claims about bases.
pub(super) fn claims() -> Vec<Claim> {
    const RISING: &[&str] = &["-8", "-4", "-2", "-1", "-1/2", "-1/4", "-1/8"];
    const FALLING: &[&str] = &["9", "5", "3", "2", "3/2", "5/4", "9/8"];
    let bases = || of_degree(each(&ALL), &[1, 2, 3]);
    vec![
        Claim::new(
            "Ill5.1.translate",
            "Illustration 5.1",
            Form::illustrated(
                "U0, degrees 0 to 3, x in [t_0, t_m): G_i^k(x) = G_0^k(t_0 − t_i + x).",
                each(&["U0"]),
                every_basis(translation(1)),
            ),
        ),
        Claim::new(
            "Ill5.1.fig7",
            "Illustration 5.1, Fig. 7",
            Form::illustrated(
                "U0, degree 3: α has no influence on the basis.",
                of_degree(each(&["U0"]), &[3]),
                influence(false),
            ),
        )
        .fails_by(Cause::Picture)
        .amended(Form::illustrated(
            "U0, degree 3: for any two different indices every G_i^3 is another function.",
            of_degree(each(&["U0"]), &[3]),
            influence(true),
        ))
        .note("The figure misleads: U0 has no interior knot in degree 3, but it is not open, so this is not the Bernstein case."),
        Claim::new(
            "Ill5.1.support",
            "Illustration 5.1",
            Form::illustrated(
                "U0: the support (closure of where G_i^k ≠ 0) is [t_i, t_{i+k+1}].",
                each(&["U0"]),
                every_basis(support(|k| k + 1)),
            ),
        ),
        Claim::new(
            "Ill5.2.support",
            "Illustration 5.2",
            Form::illustrated(
                "U0 to U3, degree 2: the support of G_i^k is [t_i, t_{i+k+1}].",
                of_degree(each(&PERIODIC), &[2]),
                every_basis(support(|k| k + 1)),
            ),
        ),
        Claim::new(
            "Ill5.1.effect",
            "Illustrations 5.1 and 5.2",
            Form::illustrated(
                "U0 with k = 1, 2, 3 and U1 to U3 with k = 2: for every i, sup |^αG_i^k − ^∞G_i^k| grows strictly as α rises in (−∞, 0), and as it falls in (1, ∞).",
                of_degree(each(&PERIODIC), &[1, 2, 3]),
                effect_grows([RISING, FALLING]),
            ),
        )
        .note("The engine judges α = −8, −4, −2, −1, −1/2, −1/4, −1/8 and α = 9, 5, 3, 2, 3/2, 5/4, 9/8, by enclosures of the suprema over all x; the certificate is about all α. Degree 0 does not depend on α."),
        Claim::new(
            "Ill5.3.symmetry",
            "Illustration 5.3",
            Form::illustrated(
                "U4, U5, degree 2, for α = −1, 2, ∞, and any other α as well: ^αG_i²(t_0+t_7−x) = ^{1−α}G_{4−i}²(x) for all x in [t_0, t_7].",
                with_indices(each(&["U4", "U5"]), &["-1", "2", "inf"]),
                every_basis(symmetry(true, |n, i| n - i)),
            ),
        ),
        Claim::new(
            "Ill5.4.regularity",
            "Illustration 5.4",
            Form::illustrated(
                "U9, U10, U12: every G_i² is C⁰ and one-sided differentiable at interior knots. U11, U13: G_2² and G_3² have a jump (supports [t_0,t_5] and [t_3,t_8]), all others are C⁰ and one-sided differentiable.",
                each(&["U9", "U10", "U11", "U12", "U13"]),
                |illustration, ledger| {
                    jumps(jumping)(illustration, ledger)?;
                    let triple = illustration.instances.iter().any(|instance| !jumping(instance).is_empty());
                    if triple { every_basis(supports_at_triple_knot)(illustration, ledger) } else { Ok(()) }
                },
            ),
        ),
        Claim::new(
            "Rem5.1.approx",
            "Remark 5.1",
            Form::illustrated(
                "U0 to U13, degree 2: |^5G_i²(x) − ^∞G_i²(x)| ≤ 1/10 for all x and i.",
                with_indices(of_degree(together(&ALL), &[2]), &["5"]),
                close_to_classical(rational(1, 10)),
            ),
        )
        .note("\"Close\" is our 1/10 of the largest possible value. The certificate shows that the largest deviation lies between 33/500 and 1/15."),
        Claim::new(
            "Rem5.1.conj",
            "Remark 5.1",
            Form::illustrated(
                "U0 with k = 1, 2, 3 and U1 to U13 with k = 2, α in {−1, 2, 5, ∞}: Conjecture 3.1 holds, in both readings.",
                bases(),
                every_basis(|case, ledger| {
                    conjecture(Reading::Strong, Except::Nothing, 1)(case, ledger)?;
                    conjecture(Reading::Weak, Except::Nothing, 1)(case, ledger)
                }),
            ),
        )
        .fails_by(Cause::InnerMultiplicity)
        .amended(Form::illustrated(
            "The same but for G_2² of U11 and of U13, which rises to the triple knot and drops there.",
            bases(),
            every_basis(|case, ledger| {
                conjecture(Reading::Strong, Except::Drops, 1)(case, ledger)?;
                conjecture(Reading::Weak, Except::Drops, 1)(case, ledger)
            }),
        )),
        Claim::new(
            "C6.larger",
            "Conclusion",
            Form::illustrated(
                "The family of curves contains the polynomial B-spline curves, of every knot vector, for α = ∞; and it is strictly larger: the curve on U4, k = 2, for α = −1 and the control points (1,0), (0,0), (0,1), (0,0), (0,0) lies on no conic for 0 < x < 1, so that no polygon and no knots give it as a quadratic polynomial B-spline curve, not even as a set of points.",
                each(&["U4"]),
                every_basis(strictly_larger),
            ),
        )
        .note("That some functions are no polynomials is not enough: without interior knots the curves are Bézier curves in w, and as sets of points not new. A quadratic polynomial curve consists of arcs of parabolas and of lines; if it contained the curve, one of them would contain an arc, and so all of the piece. The engine judges the other indices of the figure as well."),
    ]
}

/// The functions that the paper says jump at the triple knot.
fn jumping(instance: &Instance) -> &'static [usize] {
    if ["U11", "U13"].contains(&instance.name) { &[2, 3] } else { &[] }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::claims::illustrations::refutes;

    #[test]
    fn false_variants_are_refuted() {
        assert!(refutes(each(&["U0"]), every_basis(translation(2))), "translation by two spans");
        assert!(refutes(each(&["U1"]), every_basis(support(|k| k))), "a support too short");
        assert!(refutes(each(&["U9"]), influence(false)), "no influence");
        assert!(refutes(with_indices(each(&["U9"]), &["2", "2"]), influence(true)), "influence of nothing");
        assert!(refutes(each(&["U11"]), jumps(|_| &[])), "no jump at a triple knot");
        assert!(refutes(each(&["U9"]), jumps(|_| &[1])), "a jump at a simple knot");
        let close = close_to_classical(rational(1, 100));
        assert!(refutes(with_indices(each(&["U4"]), &["5"]), close), "within 1/100");
        let shrinks: [&[&str]; 2] = [&["-1", "-2"], &["2", "3"]];
        assert!(refutes(of_degree(each(&["U1"]), &[2]), effect_grows(shrinks)), "the effect shrinks");
        let mirrored = every_basis(symmetry(true, |_, i| i));
        assert!(refutes(with_indices(each(&["U4"]), &["-1"]), mirrored), "symmetry with i for n − i");
    }
}
