//! `knotproof eval` and `knotproof schema` as a user meets them.

#![allow(clippy::unwrap_used, reason = "helpers of tests")]

use std::io::Write;
use std::process::Stdio;

use assert_cmd::Command;
use knotproof::scalar::BigRational;
use serde_json::{Value, json};

fn knotproof(arguments: &[&str]) -> Command {
    let mut command = crate::program();
    command.args(arguments);
    command
}

fn text(arguments: &[&str]) -> String {
    let output = knotproof(arguments).assert().success().stderr("").get_output().stdout.clone();
    String::from_utf8(output).unwrap()
}

fn eval(arguments: &[&str]) -> Value {
    let arguments = [&["eval", "--format", "json"], arguments].concat();
    serde_json::from_str(&text(&arguments)).unwrap()
}

const BERNSTEIN: [&str; 8] = ["--degree", "2", "--knots", "0 0 0 1 1 1", "--alpha", "-1", "--x", "1/2"];

#[test]
fn all_fields_are_there_and_exact() {
    // φ = x/(2 − x): φ(1/2) = 1/3, φ′(1/2) = 2/(2 − x)² = 8/9, φ″(1/2) = 4/(2 − x)³ = 32/27.
    let found = eval(&[&BERNSTEIN[..], &["--derivatives", "1", "--points", "0,0 1,2 2,0"]].concat());
    let expected = json!({
        "schema": "knotproof.eval/1",
        "version": env!("CARGO_PKG_VERSION"),
        "degree": 2,
        "knots": ["0", "0", "0", "1", "1", "1"],
        "points": [["0", "0"], ["1", "2"], ["2", "0"]],
        "alpha": "-1",
        "x": "1/2",
        "side": "right",
        "values": ["4/9", "4/9", "1/9"],
        "derivatives": [["-32/27", "16/27", "16/27"]],
        "curve": ["2/3", "8/9"],
        "curve_derivatives": [["16/9", "32/27"]],
        "de_boor": [
            {"level": 0, "first": 0, "points": [["0", "0"], ["1", "2"], ["2", "0"]]},
            {"level": 1, "first": 1, "points": [["1/3", "2/3"], ["4/3", "4/3"]]},
            {"level": 2, "first": 2, "points": [["2/3", "8/9"]]},
        ],
    });
    assert_eq!(found, expected);
}

#[test]
fn optional_fields_are_left_out() {
    let found = eval(&BERNSTEIN);
    let keys: Vec<_> = found.as_object().unwrap().keys().collect();
    assert_eq!(keys, ["schema", "degree", "knots", "alpha", "x", "side", "values", "version"]);
}

#[test]
fn one_function_can_be_picked() {
    let found = eval(&[&BERNSTEIN[..], &["--index", "2", "--derivatives", "2"]].concat());
    assert_eq!(found["index"], 2);
    assert_eq!(found["values"], json!(["1/9"]));
    // (φ²)″ = 2φ′² + 2φφ″ = 128/81 + 64/81.
    assert_eq!(found["derivatives"], json!([["16/27"], ["64/27"]]));
}

#[test]
fn both_sides_of_a_knot_differ_for_a_finite_index() {
    let at = |side| {
        let found =
            eval(&["--instance", "U4", "--alpha", "-1", "--x", "1", "--side", side, "--derivatives", "1"]);
        (found["values"].clone(), found["derivatives"][0].clone())
    };
    let (left, right) = (at("left"), at("right"));
    assert_eq!(left.0, json!(["0", "2/3", "1/3", "0", "0"]));
    assert_eq!(left.0, right.0, "the functions are continuous at a simple knot");
    assert_eq!(left.1, json!(["0", "-10/9", "10/9", "0", "0"]));
    assert_ne!(left.1, right.1, "and their derivatives are not (Rem3.1)");
}

#[test]
fn at_the_ends_and_outside() {
    let values =
        |x, side| eval(&["--instance", "U4", "--alpha", "5", "--x", x, "--side", side])["values"].clone();
    assert_eq!(values("3", "right"), json!(["0", "0", "0", "0", "1"]));
    assert_eq!(values("3", "left"), values("3", "right"));
    assert_eq!(values("0", "right"), json!(["1", "0", "0", "0", "0"]));
    for (x, side) in [("0", "left"), ("-1", "right"), ("7/2", "left")] {
        assert_eq!(values(x, side), json!(["0", "0", "0", "0", "0"]), "{x} {side}");
    }
    let note = |x| text(&["eval", "--instance", "U4", "--alpha", "5", "--x", x]);
    assert!(note("-1").contains("x lies outside of [t_0, t_m] = [0, 3]"));
    assert!(note("3").contains("x is t_m = 3, where all limits are taken from the left"));
    assert!(!note("2").contains("Note"));
}

#[test]
fn numbers_with_a_leading_hyphen_and_all_notations_are_read() {
    let found = eval(&["--degree", "1", "--knots", "-1,0,1", "--alpha", "-1/2", "--x", "-1"]);
    assert_eq!(found["values"], json!(["0"]));
    for knots in ["-1 0 1", "-1, 0, 1", "-1.0 0x0 1e0"] {
        let found = eval(&["--degree=1", "--knots", knots, "--alpha", "-inf", "--x", "-0x1p-1"]);
        assert_eq!(
            (&found["values"], &found["alpha"], &found["x"]),
            (&json!(["1/2"]), &json!("inf"), &json!("-1/2"))
        );
    }
    let found = eval(&["--degree", "1", "--knots", "-1 0 1", "--alpha", "2", "--x", "0.4", "--points", "-3"]);
    assert_eq!(found["x"], "2/5");
    assert_eq!(found["curve"], json!(["-9/7"]));
}

#[test]
fn a_degree_chooses_among_those_of_an_instance() {
    for (degree, knots) in
        [("1", json!(["0", "0", "1", "2", "3", "3"])), ("2", json!(["0", "0", "0", "3/2", "3", "3", "3"]))]
    {
        let found = eval(&["--instance", "C6a", "--degree", degree, "--alpha", "-4", "--x", "3"]);
        assert_eq!(found["knots"], knots);
        assert_eq!(found["curve"], json!(["9", "6"]));
    }
}

#[test]
fn options_override_an_instance() {
    let found = eval(&["--instance", "U4", "--alpha", "-1", "--knots", "0 0 0 1 1 1", "--x", "1/2"]);
    assert_eq!(found["values"], json!(["4/9", "4/9", "1/9"]));
    let found = eval(&["--instance", "U4", "--alpha", "-1", "--degree", "1", "--x", "1/2"]);
    assert_eq!(found["degree"], 1);
}

#[test]
fn degree_0_works() {
    let found = eval(&["--degree", "0", "--knots", "0 1 2", "--alpha", "-1", "--x", "1", "--points", "5,6"]);
    assert_eq!(found["values"], json!(["0", "1"]));
    assert_eq!(found["curve"], json!(["6"]));
}

#[test]
fn an_instance_file_is_read_exactly() {
    let mut file = tempfile::NamedTempFile::new().unwrap();
    let content = r#"{"degree": 2, "knots": ["0", 0, 0.0, "0.4", 1e0, "1", 2E0], "alpha": [-1, "5"],
                      "points": [["0", 2], [0.1000000000000000000001, "3/2"], [1, 1], [-1, 0]]}"#;
    file.write_all(content.as_bytes()).unwrap();
    let path = file.path().to_str().unwrap();
    let found = eval(&["--instance", path, "--alpha", "inf", "--x", "0"]);
    assert_eq!(found["knots"], json!(["0", "0", "0", "2/5", "1", "1", "2"]));
    assert_eq!(found["curve"], json!(["0", "2"]));
    assert_eq!(found["de_boor"][0]["points"][1][0], "1000000000000000000001/10000000000000000000000");
    assert!(text(&["eval", "--instance", path, "--alpha", "2", "--x", "1/2"]).contains(path));
}

#[test]
fn text_is_a_table_with_exact_and_decimal_columns() {
    let found = text(&[&["eval"], &BERNSTEIN[..], &["--points", "0,0 1,2 2,0"]].concat());
    let expected = "\
Knots (0, 0, 0, 1, 1, 1), degree 2, α = -1
x = 1/2, values (limits from the right)

Values
 i  support  G_i(x)  ≈
 0  [0, 1]   4/9     0.4444444444
 1  [0, 1]   4/9     0.4444444444
 2  [0, 1]   1/9     0.1111111111

Curve
       exact       ≈
 G(x)  (2/3, 8/9)  (0.6666666667, 0.8888888889)

De Boor's points d_i^r
 i  r = 0   r = 1       r = 2
 0  (0, 0)
 1  (1, 2)  (1/3, 2/3)
 2  (2, 0)  (4/3, 4/3)  (2/3, 8/9)
";
    assert_eq!(found, expected);
}

#[test]
fn degree_40_with_100_knots() {
    let knots = (0..100).map(|t| t.to_string()).collect::<Vec<_>>().join(" ");
    let found = eval(&["--degree", "40", "--knots", &knots, "--alpha", "-1/7", "--x", "101/2"]);
    let values: Vec<BigRational> =
        found["values"].as_array().unwrap().iter().map(|v| v.as_str().unwrap().parse().unwrap()).collect();
    assert_eq!(values.len(), 59);
    // x lies in [50, 51), so G_10 to G_50 live there, and add up to 1.
    let zero = BigRational::from_integer(0.into());
    assert!(values.iter().enumerate().all(|(i, v)| (*v > zero) == (10..=50).contains(&i)));
    assert_eq!(values.into_iter().sum::<BigRational>(), BigRational::from_integer(1.into()));
}

#[test]
fn a_closed_pipe_is_no_error() {
    let knots = (0..100).map(|t| t.to_string()).collect::<Vec<_>>().join(" ");
    for format in ["text", "json"] {
        let mut child = crate::process()
            .args(["eval", "--format", format, "--degree", "40", "--alpha", "-1/7", "--x", "101/2"])
            .args(["--derivatives", "3", "--knots", &knots])
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        // The reader leaves before anything is written.
        drop(child.stdout.take());
        let output = child.wait_with_output().unwrap();
        assert_eq!((output.status.code(), output.stderr.as_slice()), (Some(0), &b""[..]), "{format}");
    }
}

#[test]
fn help_has_an_example_and_no_colour_when_piped() {
    for arguments in [&["--help"][..], &["eval", "--help"], &["schema", "--help"]] {
        let help = text(arguments);
        assert!(help.contains("Example") && help.contains("knotproof "), "{help}");
        assert!(!help.contains('\u{1b}'));
    }
}

#[test]
fn no_color_is_honoured() {
    let arguments = [&["eval"], &BERNSTEIN[..]].concat();
    let coloured = |variables: &[(&str, &str)]| {
        let mut command = knotproof(&arguments);
        command.env_remove("NO_COLOR").envs(variables.iter().copied());
        command.assert().success().get_output().stdout.contains(&0x1b)
    };
    assert!(coloured(&[("CLICOLOR_FORCE", "1")]));
    assert!(!coloured(&[("CLICOLOR_FORCE", "1"), ("NO_COLOR", "1")]));
}

/// A result that cannot be written is not a verdict, and no fault of the request.
#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_exit_code_4() {
    let full = std::fs::OpenOptions::new().write(true).open("/dev/full").unwrap();
    let mut child = crate::process();
    let output = child.arg("schema").stdout(full).output().unwrap();
    assert_eq!(output.status.code(), Some(4));
    assert!(output.stderr.starts_with(b"error: cannot write the result"));
}

#[test]
fn the_schema_describes_instance_files() {
    for format in ["text", "json"] {
        let schema: Value = serde_json::from_str(&text(&["schema", "--format", format])).unwrap();
        assert_eq!(schema["required"], json!(["degree", "knots"]));
        assert_eq!(schema["else"]["propertyNames"]["enum"][1], "degree");
        let fields: Vec<_> = schema["properties"].as_object().unwrap().keys().collect();
        assert_eq!(fields, ["degree", "knots", "alpha", "points"]);
    }
}
