//! Illustration 5.8: the symmetric curves S1 to S7.

use crate::analysis::{Enclosure, supremum};
use crate::scalar::{BigRational, RationalAlgebra, Ring, integer, rational};
use crate::spline::{Curve, Point, Side};

use super::basis::mirrored_span;
use super::cause::Cause;
use super::claim::{Claim, Form};
use super::drawn::{Drawn, alpha, show, squared_length};
use super::illustrated_curves::trace_is_classical;
use super::illustrations::{Illustration, each, refuted};
use super::instances::Instance;
use super::reflection::Reflection;
use super::verdict::{Judgement, Ledger, Stop};

/// G_α and G_{1−α} are mirror images, x against t_0 + t_m − x; `by_ends`: at the bisector of d_0 and d_n, which must
/// exist; otherwise at the axis that exchanges d_i and d_{n−i} for all i.
fn mirror_images(by_ends: bool) -> impl Fn(&Illustration, &mut Ledger) -> Judgement {
    move |illustration, ledger| {
        for instance in &illustration.instances {
            let points = instance.points.clone().unwrap_or_default();
            let mut pairs = points.iter().zip(points.iter().rev());
            let axis = if by_ends {
                pairs.next().and_then(|(from, to)| Reflection::between(from, to))
            } else {
                pairs.find_map(|(from, to)| Reflection::between(from, to))
            };
            let Some(axis) = axis else {
                let claimed = "d_0 and d_n have a perpendicular bisector".into();
                let found = format!("d_0 = d_n = {}", points.first().map_or_else(String::new, |p| show(p)));
                return Err(refuted(instance, &[], claimed, found));
            };
            for (i, (point, partner)) in points.iter().zip(points.iter().rev()).enumerate() {
                let image = axis.apply(point);
                if !image.iter().zip(partner).all(|(a, b)| ledger.equal(a, b)) {
                    let claimed = "the control polygon is symmetric".into();
                    let found = format!("d_{i} is mapped to {}", show(&image));
                    return Err(refuted(instance, &[], claimed, found));
                }
            }
            for index in &instance.indices {
                let (one, two) = (Drawn::new(instance, index), Drawn::new(instance, &index.conjugate()));
                for pieces in two.case.pieces().spans() {
                    let mirrored = mirrored_span(two.case.knots(), pieces.span);
                    let Some(partner) = mirrored.and_then(|span| one.case.pieces().on(span)) else {
                        return Err(Stop::Fault(format!("{} is not symmetric", instance.name)));
                    };
                    let image = axis.apply(&one.on(partner));
                    for (c, wanted) in image.iter().zip(two.on(pieces)) {
                        if !ledger.equal(&c.reciprocal_argument(), &wanted) {
                            let claimed = "the reflection takes G_α(t_0+t_m−x) to G_{1−α}(x)".into();
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

/// The first control point that equals its successor; or the first one, if it equals the last.
fn double_point(instance: &Instance) -> Option<&Point> {
    let points = instance.points.as_deref()?;
    let successive = points.windows(2).find(|pair| pair[0] == pair[1]).map(|pair| &pair[0]);
    successive.or_else(|| points.first().filter(|first| points.last() == Some(first)))
}

/// An enclosure of the least squared distance from the curve to a point off it: −sup(−|G − P|²), narrowed until
/// its lower end is positive: the point must be off the curve.
fn least_squared_distance(drawn: &Drawn, point: &Point) -> Result<(BigRational, BigRational), Stop> {
    let negated = drawn.everywhere().into_iter().filter_map(|curve| {
        let difference: Vec<_> = curve.iter().zip(point).map(|(c, p)| c.minus(&c.embed(p))).collect();
        squared_length(&difference).map(|square| square.negate())
    });
    let negated: Vec<_> = negated.collect();
    let mut tolerance = rational(1, 1000);
    loop {
        let Enclosure { lo, hi, .. } =
            supremum(&negated, &tolerance).map_err(|e| Stop::Fault(e.to_string()))?;
        if hi < integer(0) {
            return Ok((-hi, -lo));
        }
        tolerance /= integer(1000);
    }
}

/// The curve passes through its double control point.
fn adheres(illustration: &Illustration, ledger: &mut Ledger) -> Judgement {
    for instance in &illustration.instances {
        let Some(point) = double_point(instance) else { continue };
        for index in &instance.indices {
            let drawn = Drawn::new(instance, index);
            if !drawn.passes_through(point, ledger) {
                let (low, high) = least_squared_distance(&drawn, point)?;
                let claimed = format!("the curve passes through the double control point {}", show(point));
                let found = format!("its least squared distance from there lies in [{low}, {high}]");
                return Err(refuted(instance, &[alpha(index)], claimed, found));
            }
        }
    }
    Ok(())
}

/// The curves of these names miss their double control point, the others pass through it.
fn adheres_but_for(missing: [&'static str; 2]) -> impl Fn(&Illustration, &mut Ledger) -> Judgement {
    move |illustration, ledger| {
        for instance in &illustration.instances {
            let Some(point) = double_point(instance) else { continue };
            for index in &instance.indices {
                let through = Drawn::new(instance, index).passes_through(point, ledger);
                let claimed = !missing.contains(&instance.name);
                if !ledger.count(usize::from(through), usize::from(claimed)) {
                    let words = |through: bool| if through { "passes through" } else { "misses" };
                    let claimed = format!("the curve {} {}", words(claimed), show(point));
                    let found = format!("it {} it", words(through));
                    return Err(refuted(instance, &[alpha(index)], claimed, found));
                }
            }
        }
        Ok(())
    }
}

/// Some point of the curve is at a squared distance less than the bound from its double control point.
fn nearly_adheres(bound: BigRational) -> impl Fn(&Illustration, &mut Ledger) -> Judgement {
    move |illustration, ledger| {
        for instance in &illustration.instances {
            let Some(point) = double_point(instance) else { continue };
            for index in &instance.indices {
                let drawn = Drawn::new(instance, index);
                if drawn.passes_through(point, ledger) {
                    ledger.remark(format!("{}, α = {index}: the curve passes through.", instance.name));
                    continue;
                }
                let claimed = format!("the least squared distance is less than {bound}");
                let (low, high) = least_squared_distance(&drawn, point)?;
                if !ledger.less(&high, &bound) {
                    let found = format!("it lies in [{low}, {high}]");
                    return Err(refuted(instance, &[alpha(index)], claimed, found));
                }
                ledger.remark(format!(
                    "{}, α = {index}: the least squared distance lies in [{low}, {high}].",
                    instance.name
                ));
            }
        }
        Ok(())
    }
}

/// The direction in which the curve moves just before or after x: the first derivative that is not 0, with its
/// sign turned for even orders on the left.
fn direction(curve: &Curve, x: &BigRational, side: Side) -> Option<Point> {
    let order = curve.basis().degree() + 1;
    let jets = curve.jets(x, side, order);
    (1..=order).find_map(|d| {
        let vector: Point = jets.iter().map(|jet| jet.coefficients()[d].clone()).collect();
        let turned = side == Side::Left && d % 2 == 0;
        vector
            .iter()
            .any(|c| !c.is_zero())
            .then(|| if turned { vector.iter().map(|c| -c).collect() } else { vector })
    })
}

/// At every knot inside of the given multiplicity the directions from the two sides are not the same.
fn corner(multiplicity: usize) -> impl Fn(&Illustration, &mut Ledger) -> Judgement {
    move |illustration, ledger| {
        for instance in &illustration.instances {
            for index in &instance.indices {
                let drawn = Drawn::new(instance, index);
                for (x, _) in drawn.case.knots().inner_stop_knots().filter(|(_, p)| *p == multiplicity) {
                    let of = |side| direction(&drawn.curve, x, side);
                    let (Some(left), Some(right)) = (of(Side::Left), of(Side::Right)) else { continue };
                    let [a, b, c, d] = [&left[0], &left[1], &right[0], &right[1]];
                    let parallel = a * d == b * c;
                    let ahead = a * c + b * d;
                    let same = parallel && !ledger.less(&ahead, &integer(0));
                    if same || (!parallel && !ledger.differ(&(a * d), &(b * c))) {
                        let at = [alpha(index), ("x", x.to_string())];
                        let claimed = "the tangent directions from the two sides differ".into();
                        return Err(refuted(
                            instance,
                            &at,
                            claimed,
                            format!("both are along {}", show(&left)),
                        ));
                    }
                    ledger.remark(format!(
                        "{}, α = {index}: at x = {x} the curve arrives along {} and leaves along {}.",
                        instance.name,
                        show(&left),
                        show(&right)
                    ));
                }
            }
        }
        Ok(())
    }
}

/// The claims about S1 to S7.
pub(super) fn claims() -> Vec<Claim> {
    const SYMMETRIC: [&str; 7] = ["S1", "S2", "S3", "S4", "S5", "S6", "S7"];
    const DOUBLE: [&str; 5] = ["S2", "S3", "S5", "S6", "S7"];
    vec![
        Claim::new(
            "Ill5.8.symmetry",
            "Illustration 5.8",
            Form::illustrated(
                "S1 to S7, α in {∞, −1, −1/2, −1/5}: G_α and G_{1−α} are symmetric with respect to the perpendicular bisector of (d_0, d_n).",
                each(&SYMMETRIC),
                mirror_images(true),
            ),
        )
        .fails_by(Cause::Picture)
        .amended(Form::illustrated(
            "The same, for every α, with respect to the axis that exchanges d_i and d_{n−i}; in S7, where d_0 = d_n, that is y = 2.",
            each(&SYMMETRIC),
            mirror_images(false),
        )),
        Claim::new(
            "Ill5.8.double",
            "Illustration 5.8",
            Form::illustrated(
                "S2, S3, S5, S6, S7: the curves G_α and G_{1−α} pass through the double control point; in S7 that is d_0 = d_n.",
                each(&DOUBLE),
                adheres,
            ),
        )
        .fails_by(Cause::VagueWords)
        .amended(Form::illustrated(
            "Whatever α, the curves of S3, S6 and S7 pass through the double control point, those of S2 and S5 miss it, by a distance less than 1/4.",
            each(&DOUBLE),
            |illustration, ledger| {
                adheres_but_for(["S2", "S5"])(illustration, ledger)?;
                nearly_adheres(rational(1, 16))(illustration, ledger)
            },
        ))
        .note("\"Adhere\" is read as passing through here, and as staying close in Ill5.8.double.near. The paper names S2 and S5; S3, S6 and S7 have a double control point too, over the double knot or at both ends, and there it holds."),
        Claim::new(
            "Ill5.8.double.near",
            "Illustration 5.8",
            Form::illustrated(
                "S2, S3, S5, S6, S7: the curves G_α and G_{1−α} come closer than 1/4 to the double control point; in S7 that is d_0 = d_n.",
                each(&DOUBLE),
                nearly_adheres(rational(1, 16)),
            ),
        )
        .note("\"Adhere\" is read as staying close; 1/4 is ours. The engine judges the indices shown, the certificate all of them."),
        Claim::new(
            "Ill5.8.fig29",
            "Illustration 5.8, Fig. 29",
            Form::illustrated(
                "S3: the trace of the curve does not depend on α.",
                each(&["S3"]),
                trace_is_classical,
            ),
        )
        .note("On either span only the weight on [0, 4] differs from the Bernstein weights, and it acts only between the two equal control points: G_α is a Bézier curve in w."),
        Claim::new(
            "Ill5.8.multiplicity",
            "Illustration 5.8",
            Form::illustrated(
                "S3, S6: at the double knot the tangent directions of G_α and of G_{1−α} from the left and from the right differ.",
                each(&["S3", "S6"]),
                corner(2),
            ),
        )
        .note("The corner is there for α = ∞ too, since the double control point lies over the double knot."),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::claims::illustrations::refutes;

    #[test]
    fn false_variants_are_refuted() {
        assert!(refutes(each(&["S7"]), mirror_images(true)), "a bisector of one point");
        assert!(refutes(each(&["C5"]), mirror_images(false)), "a polygon without symmetry");
        assert!(refutes(each(&["S2"]), adheres), "adheres");
        assert!(refutes(each(&["S3"]), adheres_but_for(["S2", "S3"])), "misses a point that it meets");
        assert!(refutes(each(&["S5"]), adheres_but_for(["S2", "S3"])), "meets a point that it misses");
        assert!(refutes(each(&["S5"]), nearly_adheres(rational(1, 1000))), "closer than it is");
        assert!(refutes(each(&["S1"]), corner(1)), "corners at simple knots, for α = ∞ too");
    }
}
