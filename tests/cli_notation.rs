//! `--digits` and `--float`: what a script gets of exact numbers is correctly rounded, and encloses nothing wrongly.

#![allow(clippy::unwrap_used, reason = "helpers of tests")]

use knotproof::scalar::{BigRational, parse_rational, rational};
use num_traits::{Signed, ToPrimitive};
use serde_json::Value;

const EVAL: [&str; 9] = ["eval", "--instance", "U4", "--alpha", "-1", "--x", "1/55", "--derivatives", "2"];
const SHAPE: [&str; 9] =
    ["shape", "--degree", "3", "--knots", "0 0 0 0 1 2 4 4", "--alpha", "5/2", "--index", "2"];

fn output(arguments: &[&str]) -> String {
    let output = crate::program().args(arguments).output().unwrap();
    assert!(output.status.code().unwrap() <= 1, "{}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).unwrap()
}

fn json(arguments: &[&str], more: &[&str]) -> Value {
    serde_json::from_str(&output(&[arguments, more, &["--format", "json"]].concat())).unwrap()
}

/// Every number of the result, with where it is.
fn numbers(value: &Value, at: &str, found: &mut Vec<(String, Value)>) {
    match value {
        Value::Array(items) => {
            for (i, item) in items.iter().enumerate() {
                numbers(item, &format!("{at}/{i}"), found);
            }
        }
        Value::Object(fields) => {
            fields.iter().for_each(|(name, item)| numbers(item, &format!("{at}/{name}"), found))
        }
        Value::String(_) | Value::Number(_) => found.push((at.to_owned(), value.clone())),
        _ => {}
    }
}

fn listed(value: &Value) -> Vec<(String, Value)> {
    let mut found = Vec::new();
    numbers(value, "", &mut found);
    found
}

fn exact(value: &Value) -> BigRational {
    parse_rational(value.as_str().unwrap()).unwrap()
}

#[test]
fn floats_are_the_nearest_ones() {
    let (fractions, floats) = (json(&EVAL, &[]), json(&EVAL, &["--float"]));
    let (fractions, floats) = (listed(&fractions), listed(&floats));
    assert_eq!(fractions.len(), floats.len());
    let mut count = 0;
    for ((at, fraction), (same, float)) in fractions.iter().zip(&floats) {
        assert_eq!(at, same);
        if ["/x", "/values", "/derivatives"].iter().any(|name| at.starts_with(name)) {
            assert_eq!(float.as_f64(), exact(fraction).to_f64(), "{at}");
            assert!(float.is_number());
            count += 1;
        } else {
            // What was given is printed as it was given: it can be read again.
            assert_eq!(fraction, float, "{at}");
        }
    }
    assert_eq!(count, 1 + 3 * 5);
}

#[test]
fn decimals_are_correctly_rounded() {
    for digits in ["1", "2", "7", "40"] {
        let (fractions, decimals) = (json(&EVAL, &[]), json(&EVAL, &["--digits", digits]));
        for (fraction, decimal) in
            fractions["values"].as_array().unwrap().iter().zip(decimals["values"].as_array().unwrap())
        {
            let (fraction, decimal) = (exact(fraction), exact(decimal));
            let error = (&fraction - &decimal).abs();
            // Half a unit in the last of so many digits.
            let mut half_unit = fraction.abs() / rational(2, 1);
            for _ in 1..digits.parse().unwrap() {
                half_unit /= rational(10, 1);
            }
            assert!(error <= half_unit, "{fraction} {decimal}");
        }
        assert_eq!(decimals["knots"], fractions["knots"]);
    }
}

#[test]
fn places_and_heights_lie_in_their_enclosures_which_stay_exact() {
    let plain = json(&SHAPE, &["--width", "1e-30"]);
    for (notation, slack) in [
        (["--float", "--width=1e-3"], rational(1, 1 << 50)),
        (["--digits=12", "--width=1"], rational(1, 1 << 30)),
    ] {
        let shape = json(&SHAPE, &notation);
        let pairs = shape["functions"][0]["extrema"]
            .as_array()
            .unwrap()
            .iter()
            .zip(plain["functions"][0]["extrema"].as_array().unwrap());
        let mut count = 0;
        for (rough, fine) in pairs {
            for (digits, enclosure) in [("x", "interval"), ("height", "value")] {
                let text = rough[digits].to_string();
                let number = parse_rational(text.trim_matches('"')).unwrap();
                let [lo, hi] = [0, 1].map(|end| exact(&fine[enclosure][end]));
                assert!(
                    &lo - &slack <= number && number <= &hi + &slack,
                    "{digits}: {number} and [{lo}, {hi}]"
                );
                let [wide_lo, wide_hi] = [0, 1].map(|end| exact(&rough[enclosure][end]));
                assert!(wide_lo <= hi && lo <= wide_hi, "an enclosure that was rounded encloses nothing");
                count += 1;
            }
        }
        assert_eq!(count, 6);
    }
}

/// A spreadsheet reads 1/55 as a date.
#[test]
fn tables_have_no_fractions() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("points.csv");
    std::fs::write(&file, "x,side\n1/55,right\n1,left\n").unwrap();
    let points = [
        "eval",
        "--instance",
        "C5",
        "--alpha",
        "-4",
        "--derivatives",
        "1",
        "--points-file",
        file.to_str().unwrap(),
    ];
    for notation in [&["--float"][..], &["--digits", "8"]] {
        let table = output(&[&points, notation].concat());
        assert_eq!(table.lines().count(), 3);
        for field in table.lines().skip(1).flat_map(|line| line.split(',')) {
            assert!(["left", "right"].contains(&field) || field.parse::<f64>().is_ok(), "{field}");
        }
    }
    assert!(output(&points).contains("1/55,right,"));
}

#[test]
fn too_many_digits_are_refused() {
    for digits in ["0", "10001", "-1", "x"] {
        let mut command = crate::program();
        command.args(EVAL).args(["--digits", digits]).assert().code(2).stdout("");
    }
    let mut command = crate::program();
    command.args(EVAL).args(["--digits", "3", "--float"]).assert().code(2);
}
