//! Illustrations 5.5 to 5.7: the curves C5 to C7.

use crate::analysis::{Enclosure, Piece};
use crate::scalar::{BigRational, RationalAlgebra, Ring, integer, rational, rationals_between};
use crate::spline::{Index, Point, Side};

use super::cause::Cause;
use super::claim::{Claim, Form};
use super::curve::{convex_hull, shifts_weight};
use super::drawn::{Drawn, alpha, show, squared_length};
use super::illustrations::{
    Illustration, case_of, each, every_basis, largest, named, of_degree, refuted, together,
};
use super::instances::Instance;
use super::verdict::{Judgement, Ledger, Stop};

/// |G_α(x) − G_∞(x)|² on every span.
pub(super) fn squared_distances(instance: &Instance, index: &Index) -> Vec<Piece> {
    let (curve, classical) = (Drawn::new(instance, index), Drawn::new(instance, &Index::infinity()));
    let spans = curve.everywhere().into_iter().zip(classical.everywhere());
    let squares = spans.filter_map(|(one, two)| {
        let difference: Vec<_> = one.iter().zip(&two).map(|(one, two)| one.minus(two)).collect();
        squared_length(&difference)
    });
    squares.collect()
}

/// An enclosure of sup |G_α(x) − G_∞(x)|².
fn squared_distance(instance: &Instance, index: &Index) -> Result<Enclosure, Stop> {
    largest(&squared_distances(instance, index))
}

/// |G_α(x) − G_∞(x)|² at one x.
pub(super) fn squared_distance_at(x: &BigRational, instance: &Instance, index: &Index) -> BigRational {
    let at = |index: &Index| Drawn::new(instance, index).curve.point(x, Side::Right);
    at(index).iter().zip(at(&Index::infinity())).map(|(a, b)| (a - &b) * (a - &b)).sum()
}

/// |G_α(x) − G_∞(x)|² ≤ bound for all x and the given indices.
pub(super) fn close_to_classical(
    indices: &'static [&'static str],
    bound: BigRational,
) -> impl Fn(&Illustration, &mut Ledger) -> Judgement {
    move |illustration, ledger| {
        for instance in &illustration.instances {
            for index in indices.iter().filter_map(|text| text.parse().ok()) {
                let Enclosure { lo, hi, .. } = squared_distance(instance, &index)?;
                if ledger.less(&bound, &lo) {
                    let claimed = format!("the squared distance is at most {bound}");
                    return Err(refuted(
                        instance,
                        &[alpha(&index)],
                        claimed,
                        format!("somewhere it is {lo}"),
                    ));
                }
                if !ledger.less(&hi, &bound) {
                    return Err(Stop::Undecided(format!("the enclosure [{lo}, {hi}] contains {bound}")));
                }
                ledger.remark(format!("α = {index}: the largest squared distance lies in [{lo}, {hi}]."));
            }
        }
        Ok(())
    }
}

/// The distance from G_∞ at x = 3, and the largest one over all x, grow strictly along each chain of indices.
fn separates(chains: [&'static [&'static str]; 2]) -> impl Fn(&Illustration, &mut Ledger) -> Judgement {
    move |illustration, ledger| {
        for instance in &illustration.instances {
            for chain in chains {
                let mut last: Option<(Enclosure, BigRational)> = None;
                for index in chain.iter().filter_map(|text| text.parse().ok()) {
                    let next = squared_distance(instance, &index)?;
                    let there = squared_distance_at(&integer(3), instance, &index);
                    if let Some((_, before)) = &last
                        && !ledger.less(before, &there)
                    {
                        let claimed = "at x = 3 the curve is farther away than for the index before".into();
                        let found = format!("the squared distances are {before} and {there}");
                        return Err(refuted(instance, &[alpha(&index)], claimed, found));
                    }
                    if let Some((last, _)) = &last
                        && !ledger.less(&last.hi, &next.lo)
                    {
                        let claimed =
                            "the curve is farther from the classical one than for the index before".into();
                        let found = format!(
                            "the squared distances lie in [{}, {}] and then in [{}, {}]",
                            last.lo, last.hi, next.lo, next.hi
                        );
                        return Err(refuted(instance, &[alpha(&index)], claimed, found));
                    }
                    let Enclosure { lo, hi, .. } = &next;
                    ledger.remark(format!("α = {index}: the largest squared distance lies in [{lo}, {hi}]."));
                    last = Some((next, there));
                }
            }
        }
        Ok(())
    }
}

/// Degree 1: on the span j the curve is d_{j−1} + w(d_j − d_{j−1}), and w climbs from 0 to 1.
fn polygon_is_trace(illustration: &Illustration, ledger: &mut Ledger) -> Judgement {
    for instance in &illustration.instances {
        for index in &instance.indices {
            let drawn = Drawn::new(instance, index);
            for pieces in drawn.case.pieces().spans() {
                let j = pieces.span.index();
                let (w, points) = (pieces.function(j), drawn.curve.points());
                let Some(before) = j.checked_sub(1).and_then(|i| points.get(i)).zip(points.get(j)) else {
                    return Err(refuted(
                        instance,
                        &[alpha(index)],
                        "a leg for every span".into(),
                        "none".into(),
                    ));
                };
                let leg = before
                    .0
                    .iter()
                    .zip(before.1)
                    .map(|(from, to)| w.embed(from).plus(&w.times(&w.embed(&(to - from)))));
                let on_leg = drawn.on(pieces).iter().zip(leg).all(|(c, leg)| ledger.equal(c, &leg));
                let climbs = w.evaluate(&integer(0)).is_some_and(|w| ledger.equal(&w, &integer(0)))
                    && w.at_infinity().is_some_and(|w| ledger.equal(&w, &integer(1)))
                    && ledger.positive(&w.derivative());
                if !(on_leg && climbs) {
                    let claimed =
                        format!("on span {j} the curve runs along the leg from d_{} to d_{j}", j - 1);
                    return Err(refuted(instance, &[alpha(index)], claimed, "it does not".into()));
                }
            }
        }
    }
    Ok(())
}

/// G_α at u is G_∞ at r·u on every span: the same points in the same order, since u ↦ ru maps (0, ∞) onto itself.
pub(super) fn trace_is_classical(illustration: &Illustration, ledger: &mut Ledger) -> Judgement {
    for instance in &illustration.instances {
        let classical = Drawn::new(instance, &Index::infinity()).everywhere();
        for index in &instance.indices {
            for (span, (curve, classical)) in
                Drawn::new(instance, index).everywhere().iter().zip(&classical).enumerate()
            {
                for (c, wanted) in curve.iter().zip(classical) {
                    if !ledger.equal(c, &wanted.scaled_argument(index.ratio())) {
                        let at = [alpha(index), ("span", span.to_string())];
                        let claimed = "G_α(u) = G_∞(r·u) in the coordinate u of the span".into();
                        return Err(refuted(instance, &at, claimed, "the two differ".into()));
                    }
                }
            }
        }
        if !instance.indices.is_empty() {
            ledger.remark(format!(
                "{}, degree {}: on every span [a, b), G_α at x is G_∞ at the y with (y−a)/(b−y) = r·(x−a)/(b−x).",
                instance.name, instance.degree
            ));
        }
    }
    Ok(())
}

/// G_α is the same function of x for all the indices (`differ` = false), or another one for any two.
fn same_function(differ: bool) -> impl Fn(&Illustration, &mut Ledger) -> Judgement {
    move |illustration, ledger| {
        for instance in &illustration.instances {
            let curves: Vec<_> = instance.indices.iter().map(|index| Drawn::new(instance, index)).collect();
            for (c, first) in curves.iter().enumerate() {
                for second in &curves[c + 1..] {
                    let same = first.everywhere() == second.everywhere();
                    if ledger.count(usize::from(same), usize::from(!differ)) {
                        continue;
                    }
                    let (index, other) = (first.case.basis().index(), second.case.basis().index());
                    let at = [alpha(index), ("other α", other.to_string())];
                    if same {
                        let claimed = "they are different functions of x".into();
                        return Err(refuted(instance, &at, claimed, "they are the same".into()));
                    }
                    let knots = first.case.knots();
                    let point = |drawn: &Drawn, x: &BigRational| drawn.curve.point(x, Side::Right);
                    let place = rationals_between(knots.first(), knots.last())
                        .find(|x| point(first, x) != point(second, x));
                    let Some(x) = place else { continue };
                    let at = [alpha(index), ("other α", other.to_string()), ("x", x.to_string())];
                    let claimed = format!("G_α({x}) is the same point for both");
                    let found = format!("it is {} and {}", show(&point(first, &x)), show(&point(second, &x)));
                    return Err(refuted(instance, &at, claimed, found));
                }
            }
        }
        Ok(())
    }
}

/// For every finite index some point of G_α is no point of G_∞.
fn trace_differs(illustration: &Illustration, ledger: &mut Ledger) -> Judgement {
    /// Points tried on each span.
    const TRIED: usize = 3;
    for instance in &illustration.instances {
        let classical = Drawn::new(instance, &Index::infinity());
        for index in instance.indices.iter().filter(|index| !index.is_infinite()) {
            let drawn = Drawn::new(instance, index);
            let places = drawn.case.pieces().spans().iter().flat_map(|pieces| {
                let (start, end) = pieces.ends();
                rationals_between(start, end).take(TRIED)
            });
            let off = places
                .map(|x| (drawn.curve.point(&x, Side::Right), x))
                .find(|(point, _)| !classical.passes_through(point, ledger));
            match off {
                Some((point, x)) => ledger.remark(format!(
                    "{}, degree {}, α = {index}: G_α({x}) = {} is no point of G_∞.",
                    instance.name,
                    instance.degree,
                    show(&point)
                )),
                None => {
                    let claimed = "G_α has a point that G_∞ does not have".into();
                    let found = format!("none of {TRIED} points on each span is one");
                    return Err(refuted(instance, &[alpha(index)], claimed, found));
                }
            }
        }
    }
    Ok(())
}

/// Any two of the three curves of C7 differ exactly for t_4 < x < t_8, and end in d_6; `three_segments`: and that is the
/// second of three segments, with something unmoved before it and after it.
fn moves_locally(three_segments: bool) -> impl Fn(&Illustration, &mut Ledger) -> Judgement {
    const MOVED: usize = 4;
    move |illustration, ledger| {
        let instances = &illustration.instances;
        let pairs = instances
            .iter()
            .enumerate()
            .flat_map(|(i, first)| instances[i + 1..].iter().map(move |second| (first, second)));
        for (first, other) in pairs {
            for index in &first.indices {
                let (one, two) = (Drawn::new(first, index), Drawn::new(other, index));
                let (low, high) = one.case.basis().support(MOVED);
                for (x, _) in one.case.knots().stop_knots() {
                    let [one, two] = [&one, &two].map(|drawn| drawn.curve.point(x, Side::Right));
                    let as_claimed = ledger.count(usize::from(one != two), usize::from(low < x && x < high));
                    if !as_claimed {
                        let claimed = format!("the curves differ exactly for {low} < x < {high}");
                        let found = format!("at {x} they are at {} and {}", show(&one), show(&two));
                        return Err(refuted(other, &[alpha(index)], claimed, found));
                    }
                }
                let both = one.everywhere().into_iter().zip(two.everywhere());
                for (pieces, (one_on, two_on)) in one.case.pieces().spans().iter().zip(both) {
                    let (start, end) = pieces.ends();
                    let acts = low <= start && end <= high;
                    let difference: Vec<_> = one_on.iter().zip(&two_on).map(|(a, b)| a.minus(b)).collect();
                    let square = squared_length(&difference).unwrap_or_else(|| pieces.x.zero());
                    let as_claimed =
                        if acts { ledger.positive(&square) } else { ledger.equal(&square, &pieces.x.zero()) };
                    if !as_claimed {
                        let claimed = format!("the curves differ exactly for {low} < x < {high}");
                        let found = format!("on ({start}, {end}) it is otherwise");
                        return Err(refuted(other, &[alpha(index)], claimed, found));
                    }
                }
                let knots = one.case.knots();
                let end = one.curve.point(knots.last(), Side::Left);
                let last = one.curve.points().last();
                if !ledger.count(usize::from(last == Some(&end)), 1) {
                    let claimed = "the curve ends in d_6".into();
                    return Err(refuted(
                        first,
                        &[alpha(index)],
                        claimed,
                        format!("it ends in {}", show(&end)),
                    ));
                }
                let inner = ledger.less(knots.first(), low) && ledger.less(high, knots.last());
                if three_segments && !inner {
                    let claimed = "an unmoved segment, one moved with d_4, and an unmoved one".into();
                    let found = format!(
                        "d_4 moves the curve on ({low}, {high}), up to its end t_m = {}: nothing unmoved follows",
                        knots.last()
                    );
                    return Err(refuted(first, &[alpha(index)], claimed, found));
                }
            }
        }
        Ok(())
    }
}

/// The segment of the polygon that is nearest to a point, and where on it the nearest point lies: 0 is d_i, 1 is d_{i+1}.
fn nearest_segment(point: &Point, polygon: &[Point]) -> Option<(usize, BigRational)> {
    let dot =
        |p: &[BigRational], q: &[BigRational]| -> BigRational { p.iter().zip(q).map(|(a, b)| a * b).sum() };
    let difference = |p: &Point, q: &Point| -> Point { p.iter().zip(q).map(|(a, b)| a - b).collect() };
    let segments = polygon.windows(2).enumerate().filter_map(|(i, ends)| {
        let (along, to) = (difference(&ends[1], &ends[0]), difference(point, &ends[0]));
        let length = dot(&along, &along);
        let place = (!length.is_zero()).then(|| dot(&along, &to) / length)?.max(integer(0)).min(integer(1));
        let off: Point = to.iter().zip(&along).map(|(t, a)| t - &place * a).collect();
        Some((dot(&off, &off), i, place))
    });
    segments.min().map(|(_, i, place)| (i, place))
}

/// Where G_∞(x) is near the middle of a segment, does the curve move towards its first end for −1 < α < 0, and towards its
/// second one for 1 < α < 2? Only a counterexample is looked for.
fn moves_along_segments(illustration: &Illustration, _: &mut Ledger) -> Judgement {
    for instance in &illustration.instances {
        let Some(polygon) = &instance.points else { continue };
        let classical = Drawn::new(instance, &Index::infinity());
        let to_first = |index: &Index| index.alpha().map(|alpha| (alpha < integer(0), alpha));
        let strong = |alpha: &BigRational| -integer(1) < *alpha && *alpha < integer(2);
        let moving: Vec<_> = instance
            .indices
            .iter()
            .filter_map(|index| {
                to_first(index).filter(|(_, alpha)| strong(alpha)).map(|(first, _)| (index, first))
            })
            .map(|(index, first)| (Drawn::new(instance, index), first))
            .collect();
        let knots = classical.case.knots();
        let tenths = (1..).map(|x| knots.first() + rational(x, 10)).take_while(|x| x < knots.last());
        for x in tenths {
            let before = classical.curve.point(&x, Side::Right);
            let Some((i, place)) = nearest_segment(&before, polygon) else { continue };
            if place < rational(2, 5) || rational(3, 5) < place {
                continue;
            }
            for (drawn, first) in &moving {
                let end = if *first { i } else { i + 1 };
                let after = drawn.curve.point(&x, Side::Right);
                let distance = |p: &Point| -> BigRational {
                    p.iter().zip(&polygon[end]).map(|(a, b)| (a - b) * (a - b)).sum()
                };
                let (far, near) = (distance(&before), distance(&after));
                if near >= far {
                    let at = [alpha(drawn.case.basis().index()), ("i", i.to_string()), ("x", x.to_string())];
                    let claimed = format!("the curve moves towards d_{end}");
                    let found = format!(
                        "from G_∞({x}) = {} to G_α({x}) = {} its squared distance from there rises from {far} to {near}",
                        show(&before),
                        show(&after)
                    );
                    return Err(refuted(instance, &at, claimed, found));
                }
            }
        }
    }
    Err(Stop::Undecided("no counterexample was found among the x that are tenths".into()))
}

/// `shifts_weight` for every finite index.
fn weight_shifts(instance: &Instance, ledger: &mut Ledger) -> Judgement {
    for index in instance.indices.iter().filter(|index| !index.is_infinite()) {
        shifts_weight(&case_of(instance, index), false, ledger).map_err(|stop| named(instance, stop))?;
    }
    Ok(())
}

/// A conclusion about an instance, for each.
fn every_instance(
    conclusion: fn(&Instance, &mut Ledger) -> Judgement,
) -> impl Fn(&Illustration, &mut Ledger) -> Judgement {
    move |illustration, ledger| {
        illustration.instances.iter().try_for_each(|instance| conclusion(instance, ledger))
    }
}

/// The claims about C5 to C7.
pub(super) fn claims() -> Vec<Claim> {
    const HULL: [&str; 6] = ["C5", "C6a", "C6b", "C7a", "C7b", "C7c"];
    const TO_ZERO: &[&str] = &["-4", "-1/2", "-1/5", "-1/7"];
    const TO_ONE: &[&str] = &["5", "3/2", "6/5", "8/7"];
    const ORDER: &str = "C7: for every x and j, G_0 + … + G_j is at least its classical value for α < 0 and at most that for α > 1: weight moves from d_{i+1} to d_i, or back.";
    let hull = |text| Form::illustrated(text, each(&HULL), every_basis(convex_hull));
    vec![
        Claim::new(
            "Ill5.5.1",
            "Illustration 5.5 (1)",
            Form::illustrated(
                "C5, α ≤ −4 or α ≥ 5: |G_α(x) − G_∞(x)| < 1/4 for all x (the polygon is 10 wide and 4 high).",
                each(&["C5"]),
                close_to_classical(&["-4", "5"], rational(1, 16)),
            ),
        )
        .note("\"Good approximation\" is our 1/4. The engine judges the two ends of the ranges of α, the certificate all of them."),
        Claim::new(
            "Ill5.5.2",
            "Illustration 5.5 (2)",
            Form::illustrated(
                "C5: the curve separates from the standard one as α → 0⁻ or α → 1⁺: at the parameter x = 3 the distance |G_α(x) − G_∞(x)| grows strictly as α rises in (−∞, 0) and as it falls in (1, ∞), and tends to √8.",
                each(&["C5"]),
                separates([TO_ZERO, TO_ONE]),
            ),
        )
        .note("The engine judges the indices of the figure, and finds that the largest distance over all x grows along them too; the certificate is about all of them."),
        Claim::new(
            "Ill5.6.k1",
            "Illustration 5.6",
            Form::illustrated(
                "C6a, C6b, degree 1: the curve's trace is the control polygon, whatever α.",
                of_degree(each(&["C6a", "C6b"]), &[1]),
                polygon_is_trace,
            ),
        ),
        Claim::new(
            "Ill5.6.bezier",
            "Illustration 5.6",
            Form::illustrated(
                "C6a with degree 3, C6b with degree 5 (no interior knot): the curve's trace does not depend on α.",
                [of_degree(each(&["C6a"]), &[3]), of_degree(each(&["C6b"]), &[5])].into_iter().flatten().collect(),
                trace_is_classical,
            ),
        )
        .note("Read so, \"G_α is independent of α\" is true; as functions of x the curves differ: Ill5.6.bezier.function."),
        Claim::new(
            "Ill5.6.bezier.function",
            "Illustration 5.6",
            Form::illustrated(
                "C6a with degree 3, C6b with degree 5 (no interior knot): G_α, as a function of x, does not depend on α.",
                [of_degree(each(&["C6a"]), &[3]), of_degree(each(&["C6b"]), &[5])].into_iter().flatten().collect(),
                same_function(false),
            ),
        )
        .fails_by(Cause::VagueWords)
        .amended(Form::illustrated(
            "For any two different indices G_α is another function of x; only its trace is the same.",
            [of_degree(each(&["C6a"]), &[3]), of_degree(each(&["C6b"]), &[5])].into_iter().flatten().collect(),
            |illustration, ledger| {
                same_function(true)(illustration, ledger)?;
                trace_is_classical(illustration, ledger)
            },
        ))
        .note("The other reading of \"G_α is independent of α\": see Ill5.6.bezier. The engine judges the indices shown, the certificate all of them."),
        Claim::new(
            "Ill5.6.between",
            "Illustration 5.6",
            Form::illustrated(
                "C6a degree 2, C6b degrees 2 to 4: α does influence the trace.",
                [of_degree(each(&["C6a"]), &[2]), of_degree(each(&["C6b"]), &[2, 3, 4])]
                    .into_iter()
                    .flatten()
                    .collect(),
                trace_differs,
            ),
        )
        .note("That is, for every finite index some point of G_α is not on G_∞. The engine judges the indices shown, the certificate all of them."),
        Claim::new(
            "Ill5.7.local",
            "Illustration 5.7",
            Form::illustrated(
                "C7: the curves differ only where the moved d_4 acts, and each is made up of three segments of which the second moves with it.",
                together(&["C7a", "C7b", "C7c"]),
                moves_locally(true),
            ),
        )
        .fails_by(Cause::Picture)
        .amended(Form::illustrated(
            "C7: the curves differ exactly for x in (t_4, t_8) = (1, 4), the second of two segments; it ends at the fixed point d_6.",
            together(&["C7a", "C7b", "C7c"]),
            moves_locally(false),
        )),
        Claim::new(
            "Ill5.7.hull",
            "Illustration 5.7",
            hull("In Illustrations 5.5 to 5.7 every curve lies in the convex hull of its control polygon."),
        ),
        Claim::new(
            "Ill5.7.shift",
            "Illustration 5.7",
            Form::illustrated(
                "C7 with P = (6,2): near a segment [d_i, d_{i+1}] the curve moves towards d_i for α in (−1,0) and towards d_{i+1} for α in (1,2). That is, if the point of the polygon that is nearest to G_∞(x) lies in the middle fifth of the segment, then G_α(x) is nearer to d_i, or to d_{i+1}, than G_∞(x).",
                each(&["C7a"]),
                moves_along_segments,
            ),
        )
        .fails_by(Cause::VagueWords)
        .amended(Form::illustrated(ORDER, each(&["C7a"]), every_instance(weight_shifts)))
        .note("The sentence is read literally here, with the least that \"near\" may mean; Ill5.7.shift.order reads it as one about the order of the control points."),
        Claim::new(
            "Ill5.7.shift.order",
            "Illustration 5.7",
            Form::illustrated(ORDER, each(&["C7a"]), every_instance(weight_shifts)),
        )
        .note("A reading of \"near a segment [d_i, d_{i+1}] the curve moves towards d_i for α in (−1,0) and towards d_{i+1} for α in (1,2)\" that says nothing about distances; for those see Ill5.7.shift."),
        Claim::new(
            "Rem5.2",
            "Remark 5.2",
            hull("In Illustrations 5.5 to 5.7 the convex hull property holds."),
        ),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::claims::illustrations::{refutes, with_indices};

    #[test]
    fn false_variants_are_refuted() {
        assert!(refutes(each(&["C5"]), close_to_classical(&["-4", "5"], rational(1, 1000))), "too close");
        assert!(refutes(each(&["C5"]), separates([&["-1/2", "-4"], &["5", "6/5"]])), "approaches");
        assert!(refutes(of_degree(each(&["C6a"]), &[2]), polygon_is_trace), "degree 2 along the polygon");
        assert!(refutes(of_degree(each(&["C6a"]), &[2]), trace_is_classical), "degree 2 independent of α");
        assert!(refutes(of_degree(each(&["C6a"]), &[3]), trace_differs), "the Bézier case depends on α");
        assert!(refutes(together(&["C7a", "C7b"]), moves_locally(true)), "three segments");
        assert!(refutes(of_degree(each(&["C6a"]), &[3]), same_function(false)), "the same function");
        assert!(
            refutes(with_indices(of_degree(each(&["C6a"]), &[3]), &["2", "2"]), same_function(true)),
            "the same index twice"
        );
    }

    /// Squared distances from (2, 1): 1 from the first segment, 5 from its ends; and the place is cut off at the ends.
    #[test]
    fn the_nearest_segment() {
        let point = |x: usize, y: usize| vec![integer(x), integer(y)];
        let polygon = [point(0, 0), point(4, 0), point(4, 0), point(4, 8)];
        assert_eq!(nearest_segment(&point(2, 1), &polygon), Some((0, rational(1, 2))));
        assert_eq!(nearest_segment(&point(5, 6), &polygon), Some((2, rational(3, 4))));
        assert_eq!(nearest_segment(&point(5, 9), &polygon), Some((2, integer(1))));
        assert_eq!(nearest_segment(&point(1, 1), &[]), None);
    }
}
