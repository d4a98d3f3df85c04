//! The command `shape`: its JSON, its exit codes, and what it refuses.

#![allow(clippy::unwrap_used, reason = "helpers of tests: a failure is a failed test")]

use assert_cmd::Command;
use serde_json::{Value, json};

fn shape(arguments: &[&str]) -> (i32, Value) {
    let mut command = Command::cargo_bin("knotproof").unwrap();
    let output = command.args(["shape", "--format", "json"]).args(arguments).output().unwrap();
    let text = if output.stdout.is_empty() { output.stderr } else { output.stdout };
    (output.status.code().unwrap(), serde_json::from_slice(&text).unwrap())
}

const TWO: [&str; 6] = ["--degree", "3", "--knots", "0 0 0 0 1 2 4 4", "--index", "2"];

#[test]
fn one_function_with_two_maxima() {
    let (exit, result) = shape(&[&TWO[..], &["--alpha", "5/2", "--width", "1e-9"]].concat());
    assert_eq!((exit, &result["schema"]), (1, &json!("knotproof.shape/1")));
    let function = &result["functions"][0];
    assert_eq!(function["local_maxima"], 2);
    assert_eq!((&function["strong"], &function["weak"]), (&json!(false), &json!(true)));
    assert_eq!(function["extrema"][1]["interval"], json!(["1", "1"]));
    assert_eq!(function["slopes"][1], json!({"at": "1", "left": "-3/6272", "right": "25/6272"}));
}

#[test]
fn several_indices_and_all_functions() {
    let (exit, result) = shape(&["--degree", "1", "--knots", "0 1 2 3", "--alpha", "-1", "--alpha", "inf"]);
    assert_eq!((exit, result["functions"].as_array().unwrap().len()), (0, 4));
}

#[test]
fn every_ratio_and_every_place_of_a_knot() {
    let counts = |result: &Value| -> Vec<u64> {
        let cells = result["functions"][0]["cells"].as_array().unwrap().clone();
        cells.iter().map(|cell| cell["local_maxima"].as_u64().unwrap()).collect()
    };
    let uniform = ["--degree", "4", "--knots", "0 1 2 3 4 5 5 5 5", "--index", "0", "--alpha", "all"];
    let (exit, result) = shape(&uniform);
    assert_eq!((exit, counts(&result)), (1, vec![1, 2, 1, 2, 1]));
    let cells = &result["functions"][0]["cells"];
    assert_eq!((&cells[0]["ratio"][0], &cells[4]["ratio"][1]), (&json!("0"), &Value::Null));
    assert_eq!(result["functions"][0]["ends"][0]["events"], json!([{"span": 2, "at": "end"}]));
    let (exit, result) = shape(&[&TWO[..], &["--alpha", "5/2", "--free-knot", "5"]].concat());
    assert_eq!((exit, counts(&result)), (1, vec![1, 2, 1]));
    let (exit, _) = shape(&["--degree", "2", "--knots", "0 1 2 3 3", "--alpha", "all"]);
    assert_eq!(exit, 0);
}

#[test]
fn what_is_refused() {
    for (arguments, argument) in [
        (&["--alpha", "5/2", "--width", "0"][..], "--width"),
        (&["--alpha", "all", "--alpha", "2"], "--alpha"),
        (&["--alpha", "all", "--free-knot", "5"], "--free-knot"),
        (&["--alpha", "2", "--free-knot", "7"], "--free-knot"),
        (&["--alpha", "2", "--free-knot", "1"], "--free-knot"),
    ] {
        let (exit, result) = shape(&[&TWO[..], arguments].concat());
        assert_eq!((exit, &result["error"]["argument"]), (2, &json!(argument)), "{result}");
    }
}
