//! The command `float`: its figures, its commands, its errors.

#![allow(clippy::unwrap_used, reason = "helpers of tests")]

use assert_cmd::Command;
use serde_json::Value;

fn run(arguments: &[&str]) -> (i32, Value, String) {
    let mut command = Command::cargo_bin("knotproof").unwrap();
    let output = command.arg("float").args(arguments).args(["--format", "json"]).output().unwrap();
    let json = serde_json::from_slice(if output.stdout.is_empty() { &output.stderr } else { &output.stdout });
    (output.status.code().unwrap(), json.unwrap(), String::from_utf8(output.stderr).unwrap())
}

#[test]
fn every_formula_has_its_figures_and_its_worst_case() {
    let (code, found, _) = run(&["--degree", "2", "--count", "20", "--steps", "100", "--seed", "5"]);
    assert_eq!((code, &found["schema"]), (0, &"knotproof.float/1".into()));
    let names: Vec<_> =
        found["formulas"].as_array().unwrap().iter().map(|of| of["name"].as_str().unwrap()).collect();
    assert_eq!(names, ["paper", "ratio", "triangle", "fast", "accurate"]);
    for of in found["formulas"].as_array().unwrap() {
        for field in ["max_ulp", "p99_ulp", "median_ulp", "max_absolute", "max_sum"] {
            assert!(of[field].as_str().unwrap().parse::<f64>().unwrap() >= 0.0, "{of}");
        }
        // The command that is printed finds the same error again.
        let worst = &of["worst"];
        let command = worst["reproduce"].as_str().unwrap().strip_prefix("knotproof float ").unwrap();
        let quoted: Vec<&str> = command.split('"').collect();
        let mut arguments: Vec<&str> = quoted[0].split_whitespace().collect();
        arguments.push(quoted[1]);
        arguments.extend(quoted[2].split_whitespace());
        let (_, again, _) = run(&arguments);
        let again =
            again["formulas"].as_array().unwrap().iter().find(|other| other["name"] == of["name"]).unwrap();
        assert_eq!(again["max_ulp"], of["max_ulp"]);
        assert_eq!(again["worst"], *worst);
    }
}

#[test]
fn an_instance_is_measured_for_all_its_indices() {
    let (code, found, _) = run(&["--instance", "U4", "--count", "20", "--steps", "50"]);
    assert_eq!((code, &found["degree"]), (0, &2.into()));
    let (_, same, _) = run(&["--instance", "U4", "--count", "20", "--steps", "50"]);
    assert_eq!(found, same);
}

#[test]
fn what_floats_cannot_hold_is_refused() {
    for (arguments, argument) in [
        (&["--degree", "1", "--knots", "0 1 2", "--alpha", "1.00000000000000000001"][..], "--alpha"),
        (&["--degree", "1", "--knots", "0 1 1e400", "--alpha", "2"], "--knots"),
        (&["--degree", "1", "--knots", "0 1 2", "--alpha", "1/2"], "--alpha"),
        (&["--degree", "1", "--knots", "0 1 2", "--alpha", "2", "--x", "1e400"], "--x"),
        (&["--degree", "40"], "--degree"),
        (&["--degree", "3", "--count", "0"], "--count"),
        (&["--degree", "3", "--x", "1"], "--knots"),
        (&[], "--degree"),
    ] {
        let (code, error, _) = run(arguments);
        assert_eq!(code, 2, "{arguments:?}");
        assert!(error["error"]["message"].as_str().unwrap().contains(argument), "{error}");
    }
}
