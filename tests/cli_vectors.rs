//! The command `vectors`: what is in its file, computed here once more.

#![allow(clippy::unwrap_used, reason = "helpers of tests: a failure is a failed test")]

use std::collections::{BTreeMap, BTreeSet};

use knotproof::scalar::{BigRational, RationalAlgebra, Ring, integer, parse_rational, rational};
use serde_json::{Value, json};

fn written(arguments: &[&str]) -> Value {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("vectors.json");
    let mut command = crate::program();
    let output = command.arg("vectors").args(arguments).arg("--out").arg(&file).output().unwrap();
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    serde_json::from_str(&std::fs::read_to_string(file).unwrap()).unwrap()
}

fn numbers(list: &Value) -> Vec<BigRational> {
    list.as_array().unwrap().iter().map(|text| parse_rational(text.as_str().unwrap()).unwrap()).collect()
}

/// G_i^d on the span [t_j, t_{j+1}) by the recursion as it is printed, with weights r(x − a) : b − x.
fn value(t: &[BigRational], j: usize, i: usize, d: usize, r: &BigRational, x: &BigRational) -> BigRational {
    if d == 0 {
        return integer(i64::from(i == j));
    }
    let weight = |i: usize| {
        let (rise, fall) = (r * (x - &t[i]), &t[i + d] - x);
        (&rise / (&rise + &fall), &fall / (&rise + &fall))
    };
    let share = |i: usize, rising: bool| {
        let below = value(t, j, i, d - 1, r, x);
        if below == integer(0) {
            return below;
        }
        let (w, rest) = weight(i);
        below * if rising { w } else { rest }
    };
    share(i, true) + share(i + 1, false)
}

/// Values of every case, of an index and of the classical functions, are those of the recursion; both sides of a knot by their own
/// spans; derivatives add up to 0.
#[test]
fn the_numbers_are_those_of_the_recursion() {
    for (arguments, ratio) in
        [(&["--degree", "3"][..], rational(1, 1)), (&["--alpha", "-4", "--degree", "2"], rational(4, 5))]
    {
        let file = written(arguments);
        assert_eq!(file["schema"], "knotproof.vectors/1");
        let mut names: BTreeMap<u64, BTreeSet<&str>> = BTreeMap::new();
        for case in file["cases"].as_array().unwrap() {
            let (k, t) = (case["degree"].as_u64().unwrap(), numbers(&case["knots"]));
            assert!(names.entry(k).or_default().insert(case["name"].as_str().unwrap()), "{case:#}");
            let k = usize::try_from(k).unwrap();
            let count = t.len() - k - 1;
            assert_eq!(case["functions"], json!(count));
            for point in case["points"].as_array().unwrap() {
                let x = parse_rational(point["x"].as_str().unwrap()).unwrap();
                assert_eq!(BigRational::from_float(0.0.embed(&x)).as_ref(), Some(&x), "a float has it");
                for (side, left) in [("right", false), ("left", true)] {
                    let Some(found) = point.get(side) else { continue };
                    let last = &x == t.last().unwrap();
                    let span = (0..t.len() - 1).find(|&j| {
                        if left || last { t[j] < x && x <= t[j + 1] } else { t[j] <= x && x < t[j + 1] }
                    });
                    let Some(j) = span else {
                        assert_eq!(found["derivatives"], json!([]));
                        continue;
                    };
                    let orders = found["derivatives"].as_array().unwrap();
                    assert_eq!(orders.len(), 3);
                    let first = usize::try_from(found["first"].as_u64().unwrap()).unwrap();
                    let own = numbers(&orders[0]);
                    for i in 0..count {
                        let expected = value(&t, j, i, k, &ratio, &x);
                        let known = i.checked_sub(first).and_then(|place| own.get(place));
                        assert_eq!(known.unwrap_or(&integer(0)), &expected, "{} {x} {side}", case["name"]);
                    }
                    if t[k] <= x && x <= t[count] && j >= k && j < count {
                        assert_eq!(own.iter().fold(integer(0), |sum, g| sum.plus(g)), integer(1));
                        for order in &orders[1..] {
                            let sum = numbers(order).iter().fold(integer(0), |sum, g| sum.plus(g));
                            assert_eq!(sum, integer(0));
                        }
                    }
                }
            }
        }
        assert!(names.values().all(|of_degree| of_degree.len() > 12), "{names:?}");
    }
}

/// A family with numbers of its own gets some, and those that are set stay.
#[test]
fn members_of_a_family_say_which() {
    let file = written(&["--family", "knot-weights", "--degree", "1", "--derivatives", "0"]);
    let case = &file["cases"][0];
    assert_eq!(case["family"]["name"], "knot-weights");
    assert!(case["family"]["parameters"]["omega"].as_str().unwrap().contains(','));
    assert_eq!(case["points"][1]["right"]["derivatives"].as_array().unwrap().len(), 1);
    let file = written(&["--family", "lupas", "--set", "q=1/3", "--degree", "1"]);
    assert!(file["cases"].as_array().unwrap().iter().all(|case| case["family"]["parameters"]["q"] == "1/3"));
}

#[test]
fn too_much_is_refused() {
    for (argument, text) in [
        ("--degree", "--degree: 11 is too many: at most 10"),
        ("--derivatives", "--derivatives: 11 is too many: at most 10"),
    ] {
        let mut command = crate::program();
        let output = command.args(["vectors", argument, "11", "--out", "vectors.json"]).output().unwrap();
        assert_eq!(output.status.code(), Some(2));
        assert!(String::from_utf8_lossy(&output.stderr).contains(text), "{output:?}");
    }
}
