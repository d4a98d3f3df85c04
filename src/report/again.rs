//! The shortest command that shows what a witness says.

use crate::claims::Witness;

/// The words of a witness that is about where a function is largest.
const MAXIMA: [&str; 2] = ["local maxim", "largest value"];
/// Those of one that is about derivatives.
const DERIVATIVES: [&str; 5] = ["DG", "derivative", "differentiable", "slope", "tangent"];

/// The shortest command that shows what the witness of a claim says: `shape` where it is about maxima, `eval` where it is
/// about values; elsewhere the claim is judged on the witness's knots, or with all its cases.
#[must_use]
pub fn again(claim: &str, witness: &Witness) -> String {
    let given =
        |name: &str| witness.given.iter().find(|(known, _)| known == name).map(|(_, value)| value.as_str());
    let says = |words: &[&str]| {
        words.iter().any(|word| witness.claimed.contains(word) || witness.found.contains(word))
    };
    let basis = || {
        let knots = given("U")?.strip_prefix('(')?.strip_suffix(')')?.replace(", ", ",");
        Some(format!("--degree {} --knots {knots} --alpha {}", given("k")?, given("α")?))
    };
    match (basis(), given("i"), &witness.reproduce) {
        (Some(basis), Some(i), _) if says(&MAXIMA) => format!("knotproof shape {basis} --index {i}"),
        (_, _, Some(command)) if says(&DERIVATIVES) => command.clone(),
        (_, _, Some(command)) => command.replace(" --derivatives 1", ""),
        (Some(basis), _, None) if given("instance").is_none() => {
            format!("knotproof check {basis} --property {claim}")
        }
        _ => format!("knotproof report --claim {claim}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn witness(given: &[(&str, &str)], claimed: &str, reproduce: Option<&str>) -> Witness {
        let given = given.iter().map(|(name, value)| ((*name).to_owned(), (*value).to_owned())).collect();
        Witness {
            given,
            claimed: claimed.into(),
            found: String::new(),
            reproduce: reproduce.map(str::to_owned),
        }
    }

    #[test]
    fn the_command_is_about_what_the_witness_says() {
        let basis = [("k", "3"), ("U", "(0, 1, 2, 4, 4)"), ("α", "5/2"), ("i", "2")];
        let numbers = "--degree 3 --knots 0,1,2,4,4 --alpha 5/2";
        let maxima = witness(&basis, "exactly one local maximum", None);
        assert_eq!(again("C", &maxima), format!("knotproof shape {numbers} --index 2"));
        let command = "knotproof eval --x 0 --derivatives 1";
        assert_eq!(again("C", &witness(&basis, "G_2(0) = 0", Some(command))), "knotproof eval --x 0");
        assert_eq!(again("C", &witness(&basis, "DG_2(0) = 0", Some(command))), command);
        assert_eq!(
            again("C", &witness(&basis, "left = right", None)),
            format!("knotproof check {numbers} --property C")
        );
        let example = [&[("instance", "S7")], &basis[..]].concat();
        for given in [&example[..], &[("a", "0")]] {
            assert_eq!(again("C", &witness(given, "left = right", None)), "knotproof report --claim C");
        }
    }
}
