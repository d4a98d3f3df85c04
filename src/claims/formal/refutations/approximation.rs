//! What answers the questions about approximation in the negative.

use crate::analysis::{Pieces, is_combination};
use crate::claims::approximation::raised;
use crate::claims::formal::approximation::chebyshev_identity;
use crate::claims::formal::place::Place;
use crate::scalar::{BigRational, integer};
use crate::spline::Basis;

use super::Refuted;
use super::found::{Found, numbers, outside};

pub(super) fn refutation(claim: &str, found: &Found<'_>) -> Refuted {
    match claim {
        "X.condition" => {
            let c = numbers(found.text("c")?)?;
            let large = c.iter().map(|c| c * c).find(|square| *square > integer(1))?;
            Some((
                "Without interior knots, with w for the weight of the whole interval: f = Σ c_i·G_i is a polynomial in w for which 1 − f² is 4w(1 − w) times a square, so that |f| ≤ 1 everywhere; and a coefficient has a square greater than 1.",
                found.section(&format!("{} (> {large} 1)", chebyshev_identity(&c))),
            ))
        }
        "X.elevation" => not_elevated(found, found.natural("i")?),
        _ => None,
    }
}

/// G_i is no combination of the functions of degree k + 1 on the raised knots, already on some span.
fn not_elevated(found: &Found<'_>, i: usize) -> Refuted {
    let (k, knots) = (found.k(), raised(found.knots()));
    let higher = Basis::new(knots.clone(), k + 1, found.basis.index().clone()).ok()?;
    let (higher, own) = (Pieces::of(&higher), Pieces::of(&found.basis));
    for (fine, coarse) in higher.spans().iter().zip(own.spans()) {
        if is_combination(fine.functions.values(), &coarse.function(i)) {
            continue;
        }
        let list: String = knots.knots().iter().map(|t: &BigRational| format!(" {t}")).collect();
        let g = Place::inside(coarse.span.index()).value("G", i, k);
        let goal = outside(&knots, Place::inside(fine.span.index()).on('B'), &g, k + 1);
        return Some((
            "B has every knot of A once more. On this span, which is the same with the same u for both, the function for A is no combination of the functions of degree k + 1 for B that live there.",
            found.section_with(&format!("(knots B 0{list})"), &goal),
        ));
    }
    None
}
