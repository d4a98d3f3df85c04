//! How much α is felt in the curves of section 5: the sentences on its effect in Illustrations 5.5 to 5.8.

use num_bigint::BigInt;

use crate::analysis::{Enclosure, Piece, supremum};
use crate::scalar::{BigRational, RationalAlgebra, Ring, integer, rational, rationals_between};
use crate::spline::{Index, Point, Side};

use super::basis::mirrored_span;
use super::cause::Cause;
use super::claim::{Claim, Form};
use super::drawn::{Drawn, alpha, show, squared_length};
use super::illustrated_curves::{
    close_to_classical, squared_distance_at, squared_distances, trace_is_classical,
};
use super::illustrations::{Illustration, each, of_degree, refuted, with_indices};
use super::instances::{Instance, instances_named};
use super::verdict::{Judgement, Ledger, Stop};

/// The indices of Fig. 22 below 0.
const BELOW: [&str; 4] = ["-4", "-1/2", "-1/5", "-1/7"];
/// Those of Fig. 23 and 24.
const BY_DEGREE: [&str; 5] = ["-4", "-1", "-1/2", "-1/5", "-1/7"];

/// An enclosure of sup |G_α − G_∞|², narrow enough to tell the columns of Fig. 22 apart.
fn enclosed(instance: &Instance, index: &Index) -> Result<Enclosure, Stop> {
    let squares = squared_distances(instance, index);
    supremum(&squares, &rational(1, 1_000_000)).map_err(|error| Stop::Fault(error.to_string()))
}

/// The distance whose square is enclosed, with its ends rounded outwards to five places.
fn distance(square: &Enclosure) -> String {
    const PLACES: usize = 5;
    let scale = integer(10).power(PLACES);
    let scaled = |end: &BigRational| end * &scale * &scale;
    let (low, high) =
        (scaled(&square.lo).floor().to_integer().sqrt(), scaled(&square.hi).ceil().to_integer());
    let root = high.sqrt();
    let high = if &root * &root == high { root } else { root + 1 };
    let decimal = |n: BigInt| {
        let digits = format!("{:0>width$}", n.to_string(), width = PLACES + 1);
        let (whole, places) = digits.split_at(digits.len() - PLACES);
        format!("{whole}.{places}")
    };
    format!("[{}, {}]", decimal(low), decimal(high))
}

/// For each α of the list the largest |G_α − G_∞| is greater than for 1 − α.
fn felt_more_than_conjugate(
    indices: &'static [&'static str],
) -> impl Fn(&Illustration, &mut Ledger) -> Judgement {
    move |illustration, ledger| {
        for instance in &illustration.instances {
            for index in indices.iter().filter_map(|text| text.parse::<Index>().ok()) {
                let conjugate = index.conjugate();
                let (own, other) = (enclosed(instance, &index)?, enclosed(instance, &conjugate)?);
                let shown = format!(
                    "{}: the largest distance from G_∞ lies in {} for α = {index}, in {} for α = {conjugate}.",
                    instance.name,
                    distance(&own),
                    distance(&other)
                );
                if let Some(between) =
                    rationals_between(&own.hi, &other.lo).next().filter(|_| own.hi < other.lo)
                {
                    let points: Vec<_> = instance.points.iter().flatten().map(|p| show(p)).collect();
                    let at = [("d", points.join(", ")), alpha(&index)];
                    let claimed =
                        format!("α = {index} moves the curve farther from G_∞ than α = {conjugate}");
                    let found = format!(
                        "the squared distance is less than {between} everywhere for α = {index}, and greater somewhere for α = {conjugate}"
                    );
                    return Err(refuted(instance, &at, claimed, found));
                }
                if !ledger.less(&other.hi, &own.lo) {
                    return Err(Stop::Undecided(shown));
                }
                ledger.remark(shown);
            }
        }
        Ok(())
    }
}

/// The instance with its control points in the opposite order.
fn reversed(instance: &Instance) -> Instance {
    let points = instance.points.as_ref().map(|points| points.iter().rev().cloned().collect());
    Instance { points, ..instance.clone() }
}

/// C5, and C5 with its control points in the opposite order.
fn both_ways() -> Vec<Illustration> {
    let all = instances_named("C5").into_iter().flat_map(|instance| [instance.clone(), reversed(&instance)]);
    all.map(|instance| Illustration { instances: vec![instance] }).collect()
}

/// The curve of the reversed polygon for `other(α)`, which is 1 − α in the claim, at t_0 + t_m − x is the curve for α
/// at x.
fn exchanges_columns(other: fn(&Index) -> Index) -> impl Fn(&Illustration, &mut Ledger) -> Judgement {
    move |illustration, ledger| {
        for instance in &illustration.instances {
            for index in &instance.indices {
                let one = Drawn::new(instance, index);
                let two = Drawn::new(&reversed(instance), &other(index));
                for pieces in one.case.pieces().spans() {
                    let mirrored = mirrored_span(one.case.knots(), pieces.span);
                    let Some(partner) = mirrored.and_then(|span| two.case.pieces().on(span)) else {
                        return Err(Stop::Fault(format!("{} is not symmetric", instance.name)));
                    };
                    for (c, wanted) in two.on(partner).iter().zip(one.on(pieces)) {
                        if !ledger.equal(&c.reciprocal_argument(), &wanted) {
                            let claimed = "reversing the polygon exchanges α and 1 − α".into();
                            let found = format!("not on span {}", pieces.span.index());
                            return Err(refuted(instance, &[alpha(index)], claimed, found));
                        }
                    }
                }
            }
        }
        Ok(())
    }
}

/// A knot inside, in the middle of the knots or after it: there the distance is looked at for all α.
fn middle_knot(instance: &Instance) -> Option<BigRational> {
    let inner: Vec<_> = instance.knots.inner_stop_knots().map(|(t, _)| t.clone()).collect();
    inner.get(inner.len() / 2).cloned()
}

/// Along the indices |G_α − G_∞| grows strictly: the largest one, and the one at the middle knot.
fn grows(indices: &'static [&'static str]) -> impl Fn(&Illustration, &mut Ledger) -> Judgement {
    move |illustration, ledger| {
        for instance in &illustration.instances {
            let Some(x) = middle_knot(instance) else { continue };
            let mut before: Option<(Enclosure, BigRational)> = None;
            for index in indices.iter().filter_map(|text| text.parse().ok()) {
                let next = enclosed(instance, &index)?;
                let there = squared_distance_at(&x, instance, &index);
                if let Some((last, last_there)) = &before
                    && !(ledger.less(&last.hi, &next.lo) && ledger.less(last_there, &there))
                {
                    let claimed = "the curve is farther from G_∞ than for the index before".into();
                    let found = format!(
                        "the largest squared distances lie in [{}, {}] and [{}, {}], those at x = {x} are {last_there} and {there}",
                        last.lo, last.hi, next.lo, next.hi
                    );
                    return Err(refuted(instance, &[alpha(&index)], claimed, found));
                }
                ledger.remark(format!(
                    "{}, degree {}, α = {index}: the largest distance lies in {}.",
                    instance.name,
                    instance.degree,
                    distance(&next)
                ));
                before = Some((next, there));
            }
        }
        Ok(())
    }
}

/// Are all points of the curve farther from the point than the distance?
fn stays_off(curve: &Drawn, point: &Point, distance: &BigRational, ledger: &mut Ledger) -> bool {
    let excess = |coordinates: Vec<Piece>| {
        let difference: Vec<_> = coordinates.iter().zip(point).map(|(c, p)| c.minus(&c.embed(p))).collect();
        squared_length(&difference).map(|square| square.minus(&square.embed(&(distance * distance))))
    };
    curve.everywhere().into_iter().filter_map(excess).all(|excess| {
        let ends = [excess.evaluate(&integer(0)), excess.at_infinity()];
        ends.iter().flatten().all(|end| ledger.less(&integer(0), end)) && ledger.positive(&excess)
    })
}

/// For every index shown, some point of the curve is farther from all points of G_∞ than the distance. A curve that has the points of G_∞ is a counterexample.
fn visible(far: BigRational) -> impl Fn(&Illustration, &mut Ledger) -> Judgement {
    move |illustration, ledger| {
        for instance in &illustration.instances {
            let classical = Drawn::new(instance, &Index::infinity());
            for index in &instance.indices {
                let only = Instance { indices: vec![index.clone()], ..instance.clone() };
                if trace_is_classical(&Illustration { instances: vec![only] }, &mut Ledger::default()).is_ok()
                {
                    let claimed = "the curve has a point off G_∞".into();
                    let found = "on every span G_α at u is G_∞ at r·u, and u ↦ r·u maps (0, ∞) onto itself: both have the same points".into();
                    return Err(refuted(instance, &[alpha(index)], claimed, found));
                }
                let curve = Drawn::new(instance, index);
                let off = near_ends(&curve).into_iter().find_map(|x| {
                    let point = curve.curve.point(&x, Side::Right);
                    stays_off(&classical, &point, &far, ledger).then_some((x, point))
                });
                let Some((x, point)) = off else {
                    return Err(Stop::Undecided(format!(
                        "{}, α = {index}: no point that was tried is far enough from G_∞",
                        instance.name
                    )));
                };
                ledger.remark(format!(
                    "{}, α = {index}: all points of G_∞ are farther than {far} from G_α({x}) = {}.",
                    instance.name,
                    show(&point)
                ));
            }
        }
        Ok(())
    }
}

/// On each span a point near either end.
fn near_ends(curve: &Drawn) -> Vec<BigRational> {
    let spans = curve.case.pieces().spans().iter().map(crate::analysis::SpanPieces::ends);
    let both = spans.flat_map(|(a, b)| [rational(7, 8), rational(1, 8)].map(|part| a + (b - a) * part));
    both.collect()
}

/// The claims about C5 to C7.
pub(super) fn claims() -> Vec<Claim> {
    vec![
        Claim::new(
            "Ill5.5.2.zero",
            "Illustration 5.5 (2)",
            Form::illustrated(
                "C5: the effect is more visible near 0 than near 1: for α = −4, −1/2, −1/5, −1/7 the largest |G_α − G_∞| is greater than for 1−α.",
                each(&["C5"]),
                felt_more_than_conjugate(&BELOW),
            ),
        )
        .note("\"The effect seems more viewed at the neighbourhood of 0\", on the example that shows it. See Ill5.5.2.general for what it is worth."),
        Claim::new(
            "Ill5.5.2.general",
            "Illustration 5.5 (2)",
            Form::illustrated(
                "On the knots of C5 the effect is more visible near 0 than near 1 for every control polygon: for α = −4, −1/2, −1/5, −1/7 the largest |G_α − G_∞| is greater than for 1−α.",
                both_ways(),
                felt_more_than_conjugate(&BELOW),
            ),
        )
        .amended(Form::illustrated(
            "On the symmetric knots of C5 neither side is preferred: reversing the control points exchanges α and 1−α exactly. The curve of the reversed polygon for 1−α at t_0+t_m−x is the curve for α at x, for every polygon.",
            each(&["C5"]),
            exchanges_columns(Index::conjugate),
        ))
        .fails_by(Cause::Picture)
        .note("The paper leaves the question open; this answers it: what is seen in Fig. 22 belongs to the order of its points. The engine takes the polygon of C5, the certificate every polygon."),
        Claim::new(
            "Ill5.6.increasing",
            "Illustration 5.6",
            Form::illustrated(
                "C6a degree 2, C6b degrees 2 to 4: the influence of α increases as α rises to 0: at the middle knot (3/2; 5/2, 10/3, 5/2) the distance |G_α − G_∞| grows strictly as α rises in (−∞, 0).",
                between(),
                grows(&BY_DEGREE),
            ),
        )
        .note("For the degrees below and above there is no influence: Ill5.6.k1, Ill5.6.bezier. The engine judges the indices of the figures, and finds that the largest distance over all x grows along them too; the certificate takes every α < 0."),
        Claim::new(
            "Ill5.7.small",
            "Illustration 5.7",
            Form::illustrated(
                "C7, α ≤ −4 or α ≥ 5: the influence of α is not so remarkable: |G_α(x) − G_∞(x)| < 3/4 for all x (the polygons are 12 wide and 8 high).",
                each(&["C7a", "C7b", "C7c"]),
                close_to_classical(&["-4", "5"], rational(9, 16)),
            ),
        )
        .note("\"Not so remarkable\" is our 3/4. The engine judges the two ends of the ranges of α, the certificate all of them."),
    ]
}

/// The examples of Ill5.6 with degrees between 1 and the highest.
fn between() -> Vec<Illustration> {
    let mut all = of_degree(each(&["C6a"]), &[2]);
    all.extend(of_degree(each(&["C6b"]), &[2, 3, 4]));
    all
}

/// The indices of Fig. 27 to 33 in (−1,0) ∪ (1,2).
const INSIDE: [&str; 4] = ["-1/2", "-1/5", "3/2", "6/5"];

/// The claim about S1 to S7.
pub(super) fn in_symmetric_curves() -> Vec<Claim> {
    let far = || rational(1, 20);
    vec![
        Claim::new(
            "Ill5.8.remarkable",
            "Illustration 5.8",
            Form::illustrated(
                "S1 to S7: the effect of α is very remarkable for α in (−1,0) ∪ (1,2): for α = −1/2, −1/5 and their conjugates some point of G_α is farther than 1/20 from all points of G_∞.",
                with_indices(each(&["S1", "S2", "S3", "S4", "S5", "S6", "S7"]), &INSIDE),
                visible(far()),
            ),
        )
        .amended(Form::illustrated(
            "The same for S1, S2 and S4 to S7.",
            with_indices(each(&["S1", "S2", "S4", "S5", "S6", "S7"]), &INSIDE),
            visible(far()),
        ))
        .fails_by(Cause::Picture)
        .note("\"Very remarkable\" is our 1/20; the polygons are 5 to 16 wide. In S3 α has no effect on the points of the curve at all (Ill5.8.fig29); as motions along the curve all seven are affected. The certificate takes α < 0; G_{1−α} is the mirror image (Ill5.8.symmetry)."),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::claims::illustrations::refutes;

    #[test]
    fn false_variants_are_refuted() {
        assert!(refutes(each(&["C5"]), felt_more_than_conjugate(&["5", "3/2"])), "more near 1");
        let backwards: Vec<_> = both_ways().split_off(1);
        assert!(refutes(backwards, felt_more_than_conjugate(&["-4"])), "the reversed polygon");
        assert!(refutes(each(&["C5"]), exchanges_columns(Clone::clone)), "α exchanged with itself");
        assert!(refutes(between(), grows(&["-1/2", "-1"])), "the influence decreases");
        assert!(refutes(each(&["C7c"]), close_to_classical(&["-4"], rational(1, 4))), "within 1/2");
        assert!(refutes(with_indices(each(&["S3"]), &["-1/2"]), visible(rational(1, 20))), "S3");
    }

    #[test]
    fn distances_are_rounded_outwards() {
        let of = |lo, hi| {
            let at = (0, crate::analysis::ClosedCoordinate::Infinity);
            distance(&Enclosure { lo, hi, at })
        };
        assert_eq!(of(rational(1, 16), rational(1, 16)), "[0.25000, 0.25000]");
        assert_eq!(of(integer(2), integer(2)), "[1.41421, 1.41422]");
        assert_eq!(of(integer(0), rational(101, 1)), "[0.00000, 10.04988]");
    }

    /// With a bound that is too large, no point is far enough: that is no refutation, and no proof.
    #[test]
    fn a_distance_that_is_not_reached_is_not_proved() {
        use crate::claims::statement::{Statement, judge};
        use crate::claims::verdict::Verdict;
        let far = Statement::new("", visible(integer(10)));
        let verdict = judge(&far, &with_indices(each(&["S1"]), &["-1/2"]));
        assert!(matches!(verdict, Ok(Verdict::Undecided(_))), "{verdict:?}");
    }
}
