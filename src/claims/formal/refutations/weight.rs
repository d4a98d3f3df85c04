//! Refutations of section 2: the weight.

use crate::claims::formal::place::Place;
use crate::claims::verdict::Witness;
use crate::scalar::parse_rational;

use super::Refuted;
use super::found::text_of;

/// Both claims fail where x is the first knot of an interval and its image the last: φ is 0 there by definition, while
/// 1 − φ is 1 at the first one.
pub(super) fn refutation(claim: &str, witness: &Witness) -> Refuted {
    if !["P2.1.3", "C2.4"].contains(&claim) {
        return None;
    }
    let number = |name: &str| parse_rational(text_of(witness, name)?).ok();
    let (a, b, x) = (number("a")?, number("b")?, number("x")?);
    let (first, last) = match claim {
        "C2.4" => (&a + &b - number("t2")?, &a + &b - number("t1")?),
        _ => (a, b),
    };
    if x != first {
        return None;
    }
    let value = Place::start(0).value("v", 0, 1);
    let goals = format!("(section (knots A 0 {first} {last}) (goals (= {value} 1)))");
    Some((
        "x is the first knot of the interval on the right side, where φ = 0 and 1 − φ = 1, for every index. Its image is the last knot of the interval on the left side, where φ is 0 by definition (a ≤ x < b does not hold).",
        goals,
    ))
}
