//! What `eval` says at one point.

use knotproof::judge::OfFamily;
use knotproof::scalar::{BigRational, Jet, decimal, integer};
use knotproof::spline::{Sampler, Side};
use knotproof::typed::{Asked, Case, point};
use serde_json::json;

use crate::{Answer, exact};

/// Significant digits of an approximation beside the exact number.
const DIGITS: usize = 10;

/// The fields of `eval --derivatives 1`, with decimals of the values beside them.
pub(crate) fn at(asked: &Asked, x: &str) -> Answer {
    let Case { weights, basis, curve } = asked.case()?;
    let x = point(x)?;
    let active = Sampler::new(&basis).jets(&x, Side::Right, 1);
    let zero = Jet::constant(integer(0), 1);
    let jets: Vec<_> = (0..=basis.n())
        .map(|i| active.as_ref().and_then(|active| active.get(i)).unwrap_or(&zero).derivatives())
        .collect();
    let of_order = |order: usize| exact(jets.iter().map(|jet| &jet[order]));
    let point: Option<Vec<BigRational>> = curve.map(|curve| curve.point(&x, Side::Right));
    let sum = jets.iter().fold(integer(0), |sum, jet| sum + &jet[0]);
    let supports: Vec<_> =
        (0..=basis.n()).map(|i| <[_; 2]>::from(basis.support(i)).map(ToString::to_string)).collect();
    let mut told = json!({
        "degree": basis.degree(),
        "knots": exact(basis.knots().knots()),
        "x": x.to_string(),
        "side": "right",
        "values": of_order(0),
        "derivatives": [of_order(1)],
        "decimals": jets.iter().map(|jet| jet.iter().map(|value| decimal(value, DIGITS)).collect()).collect::<Vec<Vec<_>>>(),
        "supports": supports,
        "sum": sum.to_string(),
    });
    if let Some(point) = point {
        told["curve"] = json!(exact(&point));
        told["curve_decimals"] = json!(point.iter().map(|c| decimal(c, DIGITS)).collect::<Vec<_>>());
    }
    match (weights.index(), OfFamily::of(&weights)) {
        (Some(index), _) => {
            told["alpha"] = json!(index.to_string());
            told["ratio"] = json!(decimal(index.ratio(), DIGITS));
            told["conjugate"] = json!(index.conjugate().to_string());
        }
        (None, family) => told["family"] = json!(family),
    }
    Ok(told)
}
