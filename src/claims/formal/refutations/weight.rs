//! Refutations of section 2: the weight.

use crate::claims::verdict::Witness;
use crate::scalar::{BigRational, parse_rational};

use super::Refuted;
use super::found::text_of;

/// Both claims fail where neither x nor its image lies in its interval: both weights are 0 there by definition, and their
/// sum is not 1.
pub(super) fn refutation(claim: &str, witness: &Witness) -> Refuted {
    let number = |name: &str| parse_rational(text_of(witness, name)?).ok();
    let (a, b, x) = (number("a")?, number("b")?, number("x")?);
    let (image, left, right) = match claim {
        "P2.1.3" => {
            let (scale, shift) = text_of(witness, "T")?.strip_prefix("x ↦ ")?.split_once("·x + ")?;
            let (scale, shift) = (parse_rational(scale).ok()?, parse_rational(shift).ok()?);
            let map = |x: &BigRational| &scale * x + &shift;
            (map(&x), [map(&b), map(&a)], [a, b])
        }
        "C2.4" => {
            let (t1, t2) = (number("t1")?, number("t2")?);
            let mirror = |x: &BigRational| &a + &b - x;
            (mirror(&x), [t1.clone(), t2.clone()], [mirror(&t2), mirror(&t1)])
        }
        _ => return None,
    };
    let goals = outside(&image, &left)? + &outside(&x, &right)?;
    Some((
        "By definition φ is 0 outside of [a, b): neither the image of x lies in the interval of the weight on the left side, nor x in that of the weight on the right side, which are given in the goals. So the left side is 0 and the right side 1, for every index.",
        format!("(section (goals {goals}))"),
    ))
}

/// x < a or x ≥ b.
fn outside(x: &BigRational, [a, b]: &[BigRational; 2]) -> Option<String> {
    if x < a { Some(format!("(< {x} {a})")) } else { (x >= b).then(|| format!("(>= {x} {b})")) }
}
