//! Questions that the paper does not ask and its users will, for finite α; judged degree by degree as well.

use std::ops::RangeInclusive;

use crate::analysis::{
    ExtremumKind, LocalKnots, Monotonicity, Piece, Pieces, Shape, Sign, SpanPieces, coefficient_rows,
    common_numerators, determinant, in_span, is_combination, sign_changes, sign_pattern,
};
use crate::scalar::{BigRational, Polynomial, RationalAlgebra, Ring, integer, rational};
use crate::spline::{Basis, KnotVector, Side, weight};

use super::basis::name;
use super::case::{BasisCase, Case, Origin};
use super::cause::Cause;
use super::claim::{Claim, Form};
use super::hypothesis::Hypothesis::{
    Bernstein, DegreeAtLeast, FiniteIndex, InnerMultiplicityAtMostDegree, Open,
};
use super::maximum::searched_on_open_knots;
use super::statement::Statement;
use super::verdict::{Judgement, Ledger, Stop};

/// At every simple interior knot the factors of the control points in the two one-sided derivatives are
/// proportional, by a positive number: then, and only then, have all curves a continuous tangent direction.
fn tangent_continuity(case: &BasisCase, ledger: &mut Ledger) -> Judgement {
    for x in simple_interior_knots(case) {
        let (left, right) = (slopes(case, x, Side::Left), slopes(case, x, Side::Right));
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

fn simple_interior_knots(case: &BasisCase) -> impl Iterator<Item = &BigRational> {
    case.knots().interior(case.k()).iter().filter(|t| case.knots().multiplicity(t) == 1)
}

/// The derivatives of all functions at x from a side.
fn slopes(case: &BasisCase, x: &BigRational, side: Side) -> Vec<BigRational> {
    case.basis().jets(x, side, 1).iter().map(|jet| jet.coefficients()[1].clone()).collect()
}

/// `tangent_continuity` at a simple interior knot t_j exactly if the k − 1 knots next to it on the left are one, and
/// likewise those on the right; without `both`, if those on one side are.
fn tangent_continuity_exactly(both: bool) -> impl Fn(&BasisCase, &mut Ledger) -> Judgement {
    move |case, ledger| {
        let (knots, k) = (case.knots(), case.k());
        for x in simple_interior_knots(case) {
            let Some(j) = knots.knots().iter().position(|t| t == x) else { continue };
            let (left, right) = (slopes(case, x, Side::Left), slopes(case, x, Side::Right));
            let Some(p) = left.iter().position(|slope| !slope.is_zero()) else { continue };
            let parallel = (0..left.len()).all(|q| &left[p] * &right[q] == &left[q] * &right[p]);
            let continuous = parallel && integer(0) < &left[p] * &right[p];
            let one = [knots.t(j + 1 - k) == knots.t(j - 1), knots.t(j + 1) == knots.t(j + k - 1)];
            let claimed = if both { one[0] && one[1] } else { one[0] || one[1] };
            if !ledger.count(usize::from(continuous), usize::from(claimed)) {
                let words = |yes: bool| if yes { "continuous" } else { "not continuous, for some curve" };
                let claimed = format!("the tangent direction at {x} is {}", words(claimed));
                return Err(case.refuted(
                    [("x", x.to_string())],
                    claimed,
                    format!("it is {}", words(continuous)),
                ));
            }
        }
        Ok(())
    }
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
            if determinant(&corner, &integer(1)) < integer(0) {
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
        let minor = determinant(&rows, &integer(1));
        if minor < integer(0) {
            return Some(NegativeMinor { first, points, rows, minor });
        }
        epsilon /= integer(2);
    }
    None
}

/// A curve that a line meets more often than its polygon: the control points have the ordinates c_i over any abscissae, and
/// the line is y = 0.
pub(super) fn variation(case: &BasisCase, _: &mut Ledger) -> Judgement {
    let found = two_maxima_cut(case).or_else(|| match case.origin() {
        // For our own witness a line with short numbers is wanted, and other cases have one.
        Origin::Small | Origin::Paper => None,
        Origin::User => negative_minor(case).map(|minor| changes_at_minor(case, &minor)),
    });
    let Some(c) = found else {
        return Err(Stop::Undecided("no curve was found that a line meets too often, near any knot".into()));
    };
    // No c is 0, so that every change of sign is one crossing of the polygon, and there are no others.
    let polygon = sign_changes(&c);
    let crossings = alternations(case, &c);
    let curve = crossings.len().saturating_sub(1);
    if curve <= polygon || c.iter().any(Ring::is_zero) {
        return Err(Stop::Undecided(format!("the line y = 0 meets the curve found {curve} times only")));
    }
    let list = |items: Vec<String>| format!("({})", items.join(", "));
    let at = [("ordinates of the control points", list(c.iter().map(ToString::to_string).collect()))];
    let (points, signs): (Vec<_>, Vec<_>) = crossings.into_iter().unzip();
    let signs = signs.iter().map(|negative| if *negative { "−" } else { "+" }.to_owned()).collect();
    let found = format!(
        "the curve crosses it {curve} times: at x in {} its ordinate has the signs {}",
        list(points.iter().map(ToString::to_string).collect()),
        list(signs),
    );
    Err(case.refuted_at_large(
        at,
        format!("y = 0 is crossed at most {polygon} times, as by the polygon"),
        found,
    ))
}

/// A function with two local maxima, cut by a line between the lower one and the minimum between them: e_i − c, with the
/// shortest decimal c, since the functions of an open vector have the sum 1.
fn two_maxima_cut(case: &BasisCase) -> Option<Vec<BigRational>> {
    /// Maxima and minima that are closer than 10^−40 are passed over.
    const DIGITS: usize = 40;
    let several = |i: &usize| {
        let knots = LocalKnots::of(case.basis(), *i);
        knots.and_then(|knots| Monotonicity::of(&knots).local_maxima()).is_some_and(|maxima| maxima > 1)
    };
    let i = (0..=case.n()).find(several)?;
    let mut shape = Shape::of(case.pieces(), i);
    let height = (1..=DIGITS).find_map(|digits| {
        shape.refine_to(&power_of_ten(digits).recip());
        shape.extrema().windows(3).find_map(|three| {
            let [first, minimum, second] = three else { return None };
            let between = (first.kind, second.kind) == (ExtremumKind::Maximum, ExtremumKind::Maximum);
            let low = &minimum.value.1;
            let high = (&first.value.0).min(&second.value.0);
            (between && low < high).then(|| shortest_decimal(low, high))
        })
    })?;
    let ordinate = |l: usize| if l == i { integer(1) - &height } else { -height.clone() };
    Some((0..=case.n()).map(ordinate).collect())
}

fn power_of_ten(digits: usize) -> BigRational {
    integer(10).power(digits)
}

/// The number with the fewest decimals strictly between the two, and of these the one next to the middle.
fn shortest_decimal(low: &BigRational, high: &BigRational) -> BigRational {
    let middle = (low + high) / integer(2);
    let rounded = (0..).map(|digits| rounded(&middle, digits));
    rounded.take_while(|_| low < high).find(|x| low < x && x < high).unwrap_or(middle)
}

fn rounded(x: &BigRational, digits: usize) -> BigRational {
    let unit = power_of_ten(digits);
    (x * &unit).round() / unit
}

/// From a negative minor: with f = Σ c_i G_i equal to 1, −1, 1 at its points, the c_i have the signs −, +, −, so f changes
/// its sign there twice, and twice more where the outer functions, alone near the ends of their supports, make it
/// negative.
fn changes_at_minor(case: &BasisCase, minor: &NegativeMinor) -> Vec<BigRational> {
    let heights = [integer(1), -integer(1), integer(1)];
    // All others −1: they add no change of sign to the polygon's, and no part of it lies in the line y = 0.
    let mut c = vec![-integer(1); case.n() + 1];
    for column in 0..3 {
        // Cramer's rule.
        let mut replaced = minor.rows.clone();
        for (row, height) in replaced.iter_mut().zip(&heights) {
            row[column] = height.clone();
        }
        c[minor.first + column] = determinant(&replaced, &integer(1)) / &minor.minor;
    }
    c
}

/// Points from left to right, as short as they can be, at which f = Σ c_i G_i has alternating signs, one for each
/// interval on which it keeps its sign; and whether f is negative there.
fn alternations(case: &BasisCase, c: &[BigRational]) -> Vec<(BigRational, bool)> {
    /// A point that more decimals would distinguish from its neighbours stays as it was found.
    const DIGITS: usize = 20;
    let pieces = case.pieces();
    let mut found: Vec<(BigRational, bool)> = Vec::new();
    for span in pieces.spans() {
        let terms = span.functions.iter().map(|(i, g)| g.times(&g.embed(&c[i])));
        let sum: Piece = terms.fold(pieces.zero(), |sum, term| sum.plus(&term));
        for (u, sign) in sign_pattern(&sum.numerator().times(sum.denominator())).between() {
            let negative = *sign == Sign::Negative;
            let changes = *sign != Sign::Zero && found.last().is_none_or(|(_, last)| *last != negative);
            if let Some(x) = span.x.evaluate(u).filter(|_| changes) {
                found.push((x, negative));
            }
        }
    }
    let negative_at = |x: &BigRational| {
        let value: BigRational = case.values(x, Side::Right).iter().zip(c).map(|(g, c)| g * c).sum();
        (!value.is_zero()).then(|| value < integer(0))
    };
    for at in 0..found.len() {
        let before = if at == 0 { case.knots().first() } else { &found[at - 1].0 };
        let after = found.get(at + 1).map_or(case.knots().last(), |(x, _)| x);
        let (x, negative) = &found[at];
        let short = (0..=DIGITS)
            .map(|digits| rounded(x, digits))
            .find(|short| before < short && short < after && negative_at(short) == Some(*negative));
        if let Some(short) = short {
            found[at].0 = short;
        }
    }
    found
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

/// On no span a power of x with one of the exponents, which are 1, …, k in the claim, is a combination of the functions
/// that live there.
fn no_power(
    exponents: fn(k: usize) -> RangeInclusive<usize>,
) -> impl Fn(&BasisCase, &mut Ledger) -> Judgement {
    move |case, ledger| {
        for pieces in case.pieces().spans() {
            for exponent in exponents(case.k()) {
                let power = pieces.x.power(exponent);
                if !ledger.count(usize::from(is_combination(pieces.functions.values(), &power)), 0) {
                    let (start, end) = pieces.ends();
                    let at = [("span", format!("[{start}, {end})"))];
                    let claimed = format!("x^{exponent} is no combination of the functions that live there");
                    return Err(case.refuted(at, claimed, "it is one".into()));
                }
            }
        }
        Ok(())
    }
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

/// Knots to insert: the middle of every span, and those that are there already.
fn new_knots(case: &BasisCase) -> impl Iterator<Item = BigRational> {
    let spans = case.pieces().spans().iter().map(SpanPieces::ends);
    let middles = spans.map(|(start, end)| (start + end) / integer(2));
    middles.chain(case.knots().stop_knots().map(|(t, _)| t.clone()))
}

/// The first function for U that is no combination of those for U with one more knot.
fn outside_of_refined(case: &BasisCase, knot: &BigRational) -> Option<usize> {
    let refined = Basis::new(case.knots().with_knot(knot), case.k(), case.basis().index().clone()).ok()?;
    let fine = Pieces::of(&refined);
    let rows = coefficient_rows(fine.spans().iter().map(|span| fine_and_coarse(span, refined.n(), case)));
    let (basis, functions) = rows.split_at(refined.n() + 1);
    functions.iter().position(|function| in_span(basis, function).is_none())
}

/// Every function for U is a combination of those for U with one more knot.
pub(super) fn nested(case: &BasisCase, ledger: &mut Ledger) -> Judgement {
    for knot in new_knots(case) {
        let outside = outside_of_refined(case, &knot);
        if !ledger.count(usize::from(outside.is_some()), 0) {
            let i = outside.unwrap_or_default();
            let at = [("i", i.to_string()), ("new knot", knot.to_string())];
            let g = name(case.k(), i);
            let claimed = format!("{g} is a combination of the functions for the refined knots");
            return Err(case.refuted(at, claimed, "it is none".into()));
        }
    }
    Ok(())
}

/// That, if and only if the new knot is there already with a multiplicity of at least k, or of `least(k)`.
fn nested_exactly(least: fn(k: usize) -> usize) -> impl Fn(&BasisCase, &mut Ledger) -> Judgement {
    move |case, ledger| {
        for knot in new_knots(case) {
            let claimed = case.knots().multiplicity(&knot) >= least(case.k());
            let outside = outside_of_refined(case, &knot);
            if !ledger.count(usize::from(outside.is_none()), usize::from(claimed)) {
                let words = |nested: bool| if nested { "they are" } else { "some function is none" };
                let words = words(claimed);
                let claimed =
                    format!("as to being combinations of the functions for the refined knots, {words}");
                let at = [("new knot", knot.to_string())];
                return Err(case.refuted(at, claimed, "it is the other way".into()));
            }
        }
        Ok(())
    }
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

/// Without interior knots: DB_i^k = k w′ (B_{i−1}^{k−1} − B_i^{k−1}), with the functions of degree k − 1 on their own knots;
/// `factor` is k in the claim.
fn derivative_up_to_a_factor(factor: fn(k: usize) -> usize) -> impl Fn(&BasisCase, &mut Ledger) -> Judgement {
    move |case, ledger| {
        let (a, b, k) = (case.knots().first(), case.knots().last(), case.k());
        let below = KnotVector::bernstein(k - 1, a, b).ok();
        let below = below.and_then(|knots| Basis::new(knots, k - 1, case.basis().index().clone()).ok());
        let Some(below) = below.as_ref().map(Pieces::of) else {
            return Err(Stop::Fault("no Bernstein basis of degree k − 1".into()));
        };
        for (pieces, below) in case.pieces().spans().iter().zip(below.spans()) {
            let (w, _) = weight(&pieces.x.embed(case.basis().index().ratio()), &pieces.x, a, b);
            let scale = pieces.derivative(&w).times(&w.embed(&integer(factor(k))));
            for (i, g) in pieces.functions.iter() {
                let before = i.checked_sub(1).map_or_else(|| w.zero(), |i| below.function(i));
                let claimed = scale.times(&before.minus(&below.function(i)));
                if !ledger.equal(&pieces.derivative(g), &claimed) {
                    let claimed = format!("DB_{i}^{k} is {}·w′ times a difference", factor(k));
                    return Err(case.refuted([("i", i.to_string())], claimed, "it is not".into()));
                }
            }
        }
        Ok(())
    }
}

/// On every span, with Q the least common denominator: deg Q ≤ bound(k), which is k(k + 1)/2 in the claim, no numerator has a higher degree, and
/// the coefficients of Q in u, which are positive multiples of its Bézier weights, are positive.
fn rational_bezier(bound: fn(k: usize) -> usize) -> impl Fn(&BasisCase, &mut Ledger) -> Judgement {
    move |case, ledger| rational_bezier_of(bound(case.k()), case, ledger)
}

fn rational_bezier_of(most: usize, case: &BasisCase, ledger: &mut Ledger) -> Judgement {
    for pieces in case.pieces().spans() {
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
                    "Open U: at every simple interior knot every curve of degree k ≥ 2 has a continuous tangent direction (the one-sided derivatives are positive multiples of each other).",
                    tangent_continuity,
                )
                .given([Open, FiniteIndex, DegreeAtLeast(2)]),
            ),
        )
        .fails_by(Cause::Conjecture)
        .amended(Form::Basis(
            Statement::new(
                "Open U: at a simple interior knot t_j every curve of degree k ≥ 2 has a continuous tangent direction exactly when t_{j−k+1} = … = t_{j−1} and t_{j+1} = … = t_{j+k−1}.",
                tangent_continuity_exactly(true),
            )
            .given([Open, FiniteIndex, DegreeAtLeast(2)]),
        ))
        .note("So always for k = 2, and where no other knot is inside; and if all interior knots are simple, at all of them only then. With multiple knots beside it there are more such vectors: k = 3, U = (0, 0, 0, 0, 1, 1, 2, 3, 3, 3, 3), t_j = 2."),
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
        .by_degree_on(searched_on_open_knots)
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
        .fails_by(Cause::Conjecture)
        .amended(Form::Basis(
            Statement::new(
                "Never: for finite α and k ≥ 1, on no span of any U is x ↦ x a combination of the functions that live there, nor is x², …, x^k.",
                no_power(|k| 1..=k),
            )
            .given([FiniteIndex, DegreeAtLeast(1)]),
        ))
        .note("For r ≠ 1 every weight has a finite limit as x → ∞, and so has every combination of the functions."),
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
        .fails_by(Cause::Conjecture)
        .amended(Form::Basis(
            Statement::new(
                "Open U, k ≥ 1, a new knot t in [t_0, t_m]: the span for U lies in the span for U with the new knot exactly when t is a knot of U of multiplicity ≥ k already.",
                nested_exactly(|k| k),
            )
            .given([Open, FiniteIndex, DegreeAtLeast(1)]),
        ))
        .note("The engine inserts every knot of U once more, and the middle of every span; the certificate is about any new knot."),
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
        .fails_by(Cause::Conjecture)
        .amended(Form::Basis(
            Statement::new(
                "Open U without interior knots, k ≥ 1: up to the factor w′ it is one, DB_i^k = k w′ (B_{i−1}^{k−1} − B_i^{k−1}).",
                derivative_up_to_a_factor(|k| k),
            )
            .given([Bernstein, DegreeAtLeast(1)]),
        )),
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
    fn false_variants_are_refuted() {
        let given = [Open, FiniteIndex, DegreeAtLeast(1)];
        assert!(
            refuted(tangent_continuity_exactly(false), [Open, FiniteIndex, DegreeAtLeast(2)]),
            "one side"
        );
        assert!(refuted(no_power(|_| 0..=0), given), "constants are combinations");
        assert!(refuted(nested_exactly(|k| k + 1), given), "multiplicity k is enough");
        assert!(
            refuted(nested_exactly(|k| k.max(2) - 1), [Open, FiniteIndex, DegreeAtLeast(2)]),
            "k − 1 is not"
        );
        assert!(refuted(derivative_up_to_a_factor(|k| k + 1), [Bernstein, DegreeAtLeast(1)]), "k + 1");
    }

    /// The function of the conjecture on (0, 0, 0, 0, 1, 2, 4, 4, 4, 4), cut between its maxima: the line has eight decimals.
    #[test]
    fn the_line_that_meets_a_curve_too_often_is_short() {
        let knots = KnotVector::new([0, 0, 0, 0, 1, 2, 4, 4, 4, 4].map(integer).to_vec()).unwrap();
        let basis = Basis::new(knots, 3, "5/2".parse().unwrap()).unwrap();
        let case = BasisCase::new(basis, Origin::Small);
        let c = two_maxima_cut(&case).unwrap();
        let height = crate::scalar::parse_rational("0.63616075").unwrap();
        let expected: Vec<_> = (0..6).map(|l| integer(usize::from(l == 2)) - &height).collect();
        assert_eq!(c, expected);
        let points = alternations(&case, &c);
        assert_eq!(
            points.iter().map(|(_, negative)| *negative).collect::<Vec<_>>(),
            [true, false, true, false, true]
        );
        assert!(points.is_sorted_by(|(x, _), (y, _)| x < y));
        for (x, negative) in points {
            let value: BigRational = case.values(&x, Side::Right).iter().zip(&c).map(|(g, c)| g * c).sum();
            assert_eq!(value < integer(0), negative, "{x}");
            assert!(x.denom() <= integer(10_000).numer(), "{x} is short");
        }
    }

    #[test]
    fn decimals() {
        let number = |text: &str| crate::scalar::parse_rational(text).unwrap();
        assert_eq!(shortest_decimal(&number("0.3"), &number("1.2")), number("1"));
        assert_eq!(shortest_decimal(&number("0.31"), &number("0.39")), number("0.35"));
        assert_eq!(shortest_decimal(&number("-0.39"), &number("-0.31")), number("-0.35"));
    }

    #[test]
    fn a_bezier_degree_too_low_is_refuted() {
        assert!(refuted(rational_bezier(|k| k * (k + 1) / 2 - 1), [Open, DegreeAtLeast(1)]));
    }

    /// Two interior knots, and all curves have tangents: beside the simple one the knots are one on either side.
    #[test]
    fn a_knot_of_multiplicity_k_minus_1_is_as_good_as_an_end() {
        for (knots, continuous) in
            [([0, 0, 0, 0, 1, 1, 2, 3, 3, 3, 3], true), ([0, 0, 0, 0, 1, 2, 3, 4, 4, 4, 4], false)]
        {
            let knots = KnotVector::new(knots.map(integer).to_vec()).unwrap();
            let case = BasisCase::new(Basis::new(knots, 3, "-1".parse().unwrap()).unwrap(), Origin::User);
            let judged = tangent_continuity(&case, &mut Ledger::default());
            assert_eq!(judged.is_ok(), continuous, "{judged:?}");
        }
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
