//! The command `joins`: its JSON, and what it refuses.

#![allow(clippy::unwrap_used, reason = "helpers of tests: a failure is a failed test")]

use serde_json::{Value, json};

fn joins(arguments: &[&str]) -> (i32, Value) {
    let mut command = crate::program();
    let output = command.args(["joins", "--format", "json"]).args(arguments).output().unwrap();
    let text = if output.stdout.is_empty() { output.stderr } else { output.stdout };
    (output.status.code().unwrap(), serde_json::from_slice(&text).unwrap())
}

const CURVE: [&str; 6] = ["--degree", "2", "--knots", "0 0 0 1 2 2 2", "--points", "0,0 1,2 2,2 3,0"];

/// S1 with α = −1 at the knot 1, as the report has it.
#[test]
fn one_curve() {
    let (exit, result) = joins(&["--instance", "S1", "--alpha", "-1"]);
    assert_eq!((exit, &result["schema"], &result["dimension"]), (0, &json!("knotproof.joins/1"), &json!(2)));
    let first = &result["joins"][0];
    assert_eq!(
        (&first["knot"], &first["alpha"], &first["multiplicity"]),
        (&json!("1"), &json!("-1"), &json!(1))
    );
    assert_eq!((&first["g0"], &first["g1"], &first["g2"]), (&json!(true), &json!(false), &json!(false)));
    assert_eq!(first["before"]["derivative"], json!(["1672/225", "28/9"]));
    assert_eq!(first["after"]["direction"], json!(["1312/225", "22/9"]));
    assert_eq!(first["angle_degrees"], "0.02666300474");
    assert_eq!(first["speed_ratio"], "0.7848419883");
    assert_eq!(first["turns_back"], false);
    assert_eq!(first["undefined"], json!([]));
    assert!(result["joins"].as_array().unwrap().len() == 2 && result.get("paper").is_none());
}

#[test]
fn several_indices_and_other_notations() {
    let (exit, result) = joins(&[&CURVE[..], &["--alpha", "inf", "--alpha", "5", "--float"]].concat());
    assert_eq!((exit, result["joins"].as_array().unwrap().len()), (0, 2));
    let [classical, other] = [&result["joins"][0], &result["joins"][1]];
    assert_eq!((&classical["alpha"], &other["alpha"]), (&json!("inf"), &json!("5")));
    assert_eq!((&classical["speed_ratio"], &classical["g1"]), (&json!(1.0), &json!(true)));
    assert_eq!((&other["knot"], &other["speed_ratio"]), (&json!("1"), &json!(85.0 / 76.0)));
    let (_, result) = joins(&[&CURVE[..], &["--alpha", "5", "--digits", "3"]].concat());
    assert_eq!(result["joins"][0]["speed_ratio_squared"], "1.25");
}

#[test]
fn what_is_not_defined() {
    let (exit, result) = joins(&[
        "--degree",
        "2",
        "--knots",
        "0 0 0 1 1 2 2 2",
        "--alpha",
        "-1",
        "--points",
        "0,0 4,0 4,2 4,2 4,2",
    ]);
    let join = &result["joins"][0];
    assert_eq!((exit, &join["g1"], &join["angle_degrees"]), (0, &Value::Null, &Value::Null));
    assert_eq!((&join["after"]["order"], &join["after"]["curvature"]), (&Value::Null, &Value::Null));
    assert_eq!(
        join["undefined"],
        json!(["after the knot the curve stands still on the span, so it has no tangent"])
    );
}

#[test]
fn another_family_and_a_closed_curve() {
    let member = ["--family", "lupas", "--set", "q=1/2"];
    let (exit, result) = joins(&[&CURVE[..4], &["--points", "0,0 1,2 2,2 0,0"], &member].concat());
    assert_eq!((exit, &result["joins"][0]["family"]["name"]), (0, &json!("lupas")));
    let closing = result["joins"].as_array().unwrap().last().unwrap();
    assert_eq!((&closing["closing"], &closing["knot"]), (&json!(true), &json!("2")));
}

#[test]
fn all_curves_of_a_paper() {
    let (exit, result) = joins(&["--all"]);
    let all = result["joins"].as_array().unwrap();
    assert_eq!((exit, &result["paper"]["arxiv"]), (0, &json!("1805.04433")));
    let inner = || all.iter().filter(|join| join["closing"] == false);
    assert_eq!(inner().count(), 561);
    // Where the classical curve is smooth: the paper's loss of regularity.
    let lost = |join: &&Value| {
        join["multiplicity"].as_u64() < join["degree"].as_u64() && !join["speed_ratio"].is_null()
    };
    let number = |value: &Value| value.as_str().and_then(|text| text.parse::<f64>().ok()).unwrap_or_default();
    let largest = |joins: &mut dyn Iterator<Item = &Value>| {
        format!("{:.2}", joins.map(|join| number(&join["angle_degrees"])).fold(0.0, f64::max))
    };
    let of = |name: &'static str, alpha: &'static str| {
        inner().filter(move |join| join["instance"] == name && join["alpha"] == alpha)
    };
    assert_eq!(largest(&mut of("C5", "-4")), "0.13");
    assert_eq!(largest(&mut of("S4", "-1/5")), "1.00");
    assert_eq!(largest(&mut inner().filter(lost)), "1.00");
    let least = inner().filter(lost).map(|join| number(&join["speed_ratio"])).fold(1.0, f64::min);
    assert_eq!(format!("{least:.2}"), "0.28");
    let (exit, classical) = joins(&["--all", "--paper", "classical"]);
    assert_eq!(exit, 0);
    let smooth = |join: &Value| join["g0"].as_bool().is_some();
    assert!(classical["joins"].as_array().unwrap().iter().all(smooth));
}

#[test]
fn what_is_refused() {
    for (arguments, argument, part) in [
        (&CURVE[..4], "--alpha", "--alpha is missing"),
        (&["--instance", "U4", "--alpha", "2"], "--points", "give 5, d_0 to d_4"),
        (&["--all", "--instance", "C5"], "--all", "cannot be used with"),
        (&["--all", "--alpha", "2"], "--all", "cannot be used with"),
        (&["--instance", "C5", "--alpha", "all"], "--alpha", "only `knotproof shape` takes it"),
        (&["--instance", "C6a"], "--instance", "choose one with --degree"),
        (&["--all", "--paper", "none-such"], "--paper", "there is no folder `none-such`"),
        (&["--all", "--digits", "0"], "--digits", "1"),
    ] {
        let (exit, result) = joins(arguments);
        assert_eq!((exit, &result["schema"]), (2, &json!("knotproof.error/1")), "{arguments:?}");
        assert_eq!(result["error"]["argument"], argument, "{arguments:?}: {result:#}");
        let message = result["error"]["message"].as_str().unwrap();
        assert!(message.contains(part), "{message}");
    }
}
