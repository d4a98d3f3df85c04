//! The captions of Fig. 27 to 33: what they say of the knots and of the control points.

use super::claim::{Claim, Form};
use super::drawn::show;
use super::illustrations::{Illustration, each, refuted};
use super::instances::Instance;
use super::reflection::Reflection;
use super::verdict::{Judgement, Ledger};

/// What a caption says.
#[derive(Debug, Clone, Copy)]
struct Caption {
    /// The instance that the figure shows.
    name: &'static str,
    /// "U uniform and open"; otherwise "U symmetric and open with double node".
    uniform: bool,
    /// "Π symmetric with double point"; otherwise "with no multiple point".
    double_point: bool,
}

const fn caption(name: &'static str, uniform: bool, double_point: bool) -> Caption {
    Caption { name, uniform, double_point }
}

/// Fig. 27 to 33.
const CAPTIONS: [Caption; 7] = [
    caption("S1", true, false),
    caption("S2", true, true),
    caption("S3", false, true),
    caption("S4", true, false),
    caption("S5", true, true),
    caption("S6", false, true),
    caption("S7", true, true),
];

/// The pairs of control points that are at the same place.
fn equal_points(instance: &Instance) -> Vec<(usize, usize)> {
    let points = instance.points.as_deref().unwrap_or_default();
    let pairs = (0..points.len()).flat_map(|i| (i + 1..points.len()).map(move |j| (i, j)));
    pairs.filter(|(i, j)| points[*i] == points[*j]).collect()
}

/// The reflection that exchanges two control points d_i ≠ d_{n−i}.
fn axis(instance: &Instance) -> Option<Reflection> {
    let points = instance.points.as_deref().unwrap_or_default();
    points.iter().zip(points.iter().rev()).find_map(|(p, q)| Reflection::between(p, q))
}

/// Each of the captions is true of its instance.
fn are_true(captions: &'static [Caption]) -> impl Fn(&Illustration, &mut Ledger) -> Judgement {
    move |illustration, ledger| {
        for instance in &illustration.instances {
            for caption in captions.iter().filter(|caption| caption.name == instance.name) {
                is_true(*caption, instance, ledger)?;
            }
        }
        Ok(())
    }
}

fn is_true(caption: Caption, instance: &Instance, ledger: &mut Ledger) -> Judgement {
    let (knots, k) = (&instance.knots, instance.degree);
    let mut expect = |holds: bool, claimed: &str, found: &dyn Fn() -> String| {
        if ledger.count(usize::from(holds), 1) {
            Ok(())
        } else {
            Err(refuted(instance, &[], claimed.to_owned(), found()))
        }
    };
    let of_knots = || format!("U = {knots}");
    expect(knots.is_open(k), "U is open", &of_knots)?;
    if caption.uniform {
        expect(knots.is_uniform(k), "U is uniform", &of_knots)?;
    } else {
        let double = knots.inner_stop_knots().filter(|(_, p)| *p == 2).count();
        expect(knots.is_symmetric(), "U is symmetric", &of_knots)?;
        expect(double == 1, "U has one double node inside", &of_knots)?;
    }
    let points = instance.points.as_deref().unwrap_or_default();
    let exchanged = axis(instance).is_some_and(|axis| {
        points.iter().zip(points.iter().rev()).all(|(point, partner)| axis.apply(point) == *partner)
    });
    let of_points = || points.iter().map(|point| show(point)).collect::<Vec<_>>().join(", ");
    expect(exchanged, "Π is symmetric: one reflection exchanges d_i and d_{n−i} for all i", &of_points)?;
    let (wanted, claimed) = if caption.double_point {
        (1, "Π has one double point and no other multiple one")
    } else {
        (0, "Π has no multiple point")
    };
    expect(equal_points(instance).len() == wanted, claimed, &of_points)
}

/// The claim about the captions.
pub(super) fn claims() -> Vec<Claim> {
    vec![
        Claim::new(
            "Fig27-33",
            "Fig. 27–33, captions",
            Form::illustrated(
                "U1, U2, U4, U5, U7 are uniform and open, U3 and U6 symmetric and open with a double node. Every Π_i is symmetric: Π1 and Π4 with no multiple point, Π2, Π3, Π5, Π6, Π7 with a double point.",
                each(&CAPTIONS.map(|caption| caption.name)),
                are_true(&CAPTIONS),
            ),
        )
        .note("Uniform as in D3.2 (3), t_k, …, t_{m−k} equidistant; symmetric as in P4.3, d_i and d_{n−i} exchanged by one reflection. The double point of Π7 is d_0 = d_12."),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::claims::illustrations::refutes;

    #[test]
    fn false_captions_are_refuted() {
        const FALSE: [[Caption; 1]; 5] = [
            [caption("S1", false, false)],
            [caption("S1", true, true)],
            [caption("S3", true, true)],
            [caption("S5", true, false)],
            [caption("C5", true, false)],
        ];
        for captions in &FALSE {
            assert!(refutes(each(&[captions[0].name]), are_true(captions)), "{captions:?}");
        }
    }
}
