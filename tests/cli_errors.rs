//! Bad input: exit code 2, one message on standard error that names the argument, the position and the rule,
//! and nothing on standard output.

#![allow(clippy::unwrap_used, reason = "helpers of tests")]

use std::fs;
use std::path::Path;

use assert_cmd::Command;
use serde_json::Value;

fn knotproof(arguments: &[&str]) -> Command {
    let mut command = crate::program();
    command.args(arguments);
    command
}

/// Runs the request as text and as JSON, and checks that each message contains all of `parts`.
fn rejected(arguments: &[&str], argument: &str, parts: &[&str]) {
    let output = knotproof(arguments).assert().code(2).stdout("").get_output().stderr.clone();
    let text = String::from_utf8(output).unwrap();
    assert!(text.starts_with("error: "), "{text}");
    assert_eq!(text.matches("error:").count(), 1, "one message: {text}");
    assert!(!text.contains("panicked"), "{text}");

    for format in [&["--format", "json"][..], &["--format=json"]] {
        let arguments = [arguments, format].concat();
        let output = knotproof(&arguments).assert().code(2).stdout("").get_output().stderr.clone();
        let report: Value = serde_json::from_slice(&output).unwrap();
        assert_eq!(report["schema"], "knotproof.error/1");
        assert_eq!(report["error"]["argument"], argument, "{report}");
        let message = report["error"]["message"].as_str().unwrap();
        assert!(!message.contains('\n') && !message.contains("Usage:"), "{message}");
        for part in parts {
            assert!(text.contains(part), "{part:?} in {text}");
            assert!(message.contains(part), "{part:?} in {message}");
        }
    }
}

/// `eval` with a request that is right but for the options given, which come first.
fn rejected_eval(options: &[&str], argument: &str, parts: &[&str]) {
    let mut arguments = vec!["eval"];
    arguments.extend(options);
    for (option, value) in
        [("--degree", "2"), ("--knots", "0 0 0 1 2 2 2"), ("--alpha", "-1"), ("--x", "1/2")]
    {
        if !options.contains(&option) {
            arguments.extend([option, value]);
        }
    }
    rejected(&arguments, argument, &[&[argument], parts].concat());
}

#[test]
fn numbers() {
    for (options, argument, parts) in [
        (["--alpha", "0"], "--alpha", ["0 lies in [0, 1]", "negative, greater than 1, or inf"]),
        (["--alpha", "1"], "--alpha", ["1 lies in [0, 1]", "negative, greater than 1, or inf"]),
        (["--alpha", "0.5"], "--alpha", ["1/2 lies in [0, 1]", "pole"]),
        (["--alpha", "nan"], "--alpha", ["`nan` is not a finite number", ""]),
        (["--alpha", "x"], "--alpha", ["`x` is not a number", "write 3, -1/2"]),
        (["--x", "1/0"], "--x", ["`1/0` divides by zero", ""]),
        (["--x", "inf"], "--x", ["`inf` is not a finite number", ""]),
        (["--x", "1e999999999"], "--x", ["exponent in `1e999999999` is out of range", "out of range"]),
        (["--x", "--"], "--x", ["`--` is not a number", ""]),
        (["--side", "up"], "--side", ["'up'", "left, right"]),
        (["--degree", "-1"], "--degree", ["'-1'", "whole number from 0 up"]),
        (["--degree", "1.5"], "--degree", ["'1.5'", "whole number from 0 up"]),
        (["--degree", "99999999999999999999999"], "--degree", ["too large", ""]),
        (["--derivatives", "101"], "--derivatives", ["101 is too many", "at most 50"]),
        (["--derivatives", "1000000000000000000"], "--derivatives", ["is too many", "at most 50"]),
        (["--index", "4"], "--index", ["no function 4", "0 to 3"]),
        (["--index", "-1"], "--index", ["'-1'", "whole number from 0 up"]),
    ] {
        rejected_eval(&options, argument, &parts);
    }
}

#[test]
fn knots() {
    for (knots, parts) in [
        ("", &["at least two knots, and here is none"][..]),
        (" ", &["here is none"]),
        ("1", &["here is one"]),
        ("0 0 0 1 1/2 2 2", &["position 4", "must not decrease", "knot 4 is 1/2, after 1"]),
        ("0 0 0 1", &["degree 2 needs at least 5 knots", "here are 4"]),
        ("3 3 3 3 3 3", &["all 6 knots are equal to 3"]),
        ("0 0 x 1", &["position 2", "`x` is not a number", "write 3, -1/2"]),
        ("0,0,,1", &["position 2", "a number is missing"]),
        ("0,1,2,", &["position 3", "a number is missing"]),
        ("0 1 2 inf", &["position 3", "`inf` is not a finite number"]),
        ("0 1/0 2", &["position 1", "`1/0` divides by zero"]),
        ("\u{1b}é", &["position 0", "is not a number"]),
    ] {
        rejected_eval(&["--knots", knots], "--knots", parts);
    }
}

/// The option to blame is the one that the user wrote; nothing of that size is ever allocated.
#[test]
fn a_huge_degree() {
    let huge = "1000000000000000000";
    let parts = ["needs at least 2000000000000000001 knots"];
    rejected_eval(&["--degree", huge, "--knots", "0 1 2"], "--knots", &parts);
    rejected(&["eval", "--instance", "U9", "--degree", huge, "--alpha", "2", "--x", "1"], "--degree", &parts);
}

#[test]
fn points() {
    for (points, parts) in [
        ("", &["takes 4 control points", "here are 0"][..]),
        ("0,0 1,1 2,0", &["takes 4 control points", "here are 3"]),
        ("0,0 1,1 2,0 3", &["position 3", "1 coordinates and point 0 has 2"]),
        ("0,0,0,0 1,1,1,1 2,2,2,2 3,3,3,3", &["position 0", "dimension 1, 2 or 3"]),
        ("0,0 1,x 2,0 3,0", &["position 1, coordinate 1", "`x` is not a number"]),
        ("(0,0) 1,1", &["position 1", "expected `(…)`"]),
        ("(0,0),(1,1", &["position 1", "found `(1,1`"]),
        ("();();();()", &["position 0", "0 coordinates"]),
        ("[[0,0],[1,\"a\"]]", &["`a` is not a number", "line 1 column"]),
        ("[[0,0],", &["line 1 column 7"]),
        ("[1,2,3,4]", &["line 1 column 2", "[[\"0\",\"2\"]"]),
    ] {
        rejected_eval(&["--points", points], "--points", parts);
    }
}

#[test]
fn what_is_missing_or_ambiguous() {
    rejected(&["eval", "--x", "1"], "--degree", &["--degree is missing"]);
    rejected(&["eval", "--x", "1", "--degree", "2"], "--knots", &["--knots is missing"]);
    rejected(
        &["eval", "--x", "1", "--degree", "0", "--knots", "0 1"],
        "--alpha",
        &["--alpha is missing", "--alpha inf"],
    );
    rejected(&["eval", "--instance", "U4", "--alpha", "2"], "--x", &["--x <X>", "not provided"]);
    rejected(
        &["eval", "--x", "1", "--instance", "U4"],
        "--alpha",
        &["one index is wanted, and here are -1, 2, 5, inf", "choose one with --alpha"],
    );
    rejected(
        &["eval", "--x", "1", "--instance", "U0"],
        "--instance",
        &["degrees 0, 1, 2, 3", "choose one with --degree"],
    );
    rejected(
        &["eval", "--x", "1", "--instance", "C6b", "--degree", "6"],
        "--degree",
        &["degrees 1, 2, 3, 4, 5"],
    );
    rejected(&["eval", "--x", "1", "--x", "2"], "--x", &["multiple times"]);
    rejected(&["eval", "--nonsense"], "--nonsense", &["unexpected argument"]);
    rejected(
        &["eval", "--x", "1", "--instance", "S1", "--degree", "2", "--alpha", "2"],
        "--instance",
        &["--instance S1, its points", "takes 7 control points", "here are 6"],
    );
}

#[test]
fn an_unknown_command_or_none() {
    for arguments in [&["--format", "json"][..], &["--format", "json", "evil"]] {
        let output = knotproof(arguments).assert().code(2).stdout("").get_output().stderr.clone();
        let report: Value = serde_json::from_slice(&output).unwrap();
        assert!(report["error"]["message"].as_str().unwrap().contains("subcommand"), "{report}");
    }
    knotproof(&[]).assert().code(2).stdout("");
    knotproof(&["eval", "--format", "xml"]).assert().code(2).stdout("");
}

fn rejected_instance(path: &Path, parts: &[&str]) {
    let path = path.to_str().unwrap();
    rejected(&["eval", "--instance", path, "--x", "1"], "--instance", &[&[path], parts].concat());
}

#[test]
fn instance_files() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("instance.json");
    for (content, parts) in [
        ("", &["line 1 column 0"][..]),
        ("{\"degree\": 2,\n \"knots\": [0, 1, }", &["line 2 column 18"]),
        ("{\"degree\": 2}", &["missing field `knots`", "line 1 column 13"]),
        ("{\"degree\": 2,\n\"knot\": [0]}", &["unknown field `knot`", "line 2 column 6"]),
        ("{\"degree\": 2, \"degree\": 3}", &["duplicate field `degree`"]),
        ("{\"degree\": -2, \"knots\": []}", &["line 1 column 13"]),
        ("{\"degree\": 1e30, \"knots\": []}", &["line 1 column"]),
        ("{\"degree\": 1, \"knots\": [0,\n1,\n\"2/0\"]}", &["`2/0` divides by zero", "line 3 column 6"]),
        ("{\"degree\": 1, \"knots\": [0, 1e400000]}", &["exponent", "line 1 column"]),
        ("{\"degree\": 1, \"knots\": [0, null]}", &["expected a number", "found null", "line 1 column 32"]),
        ("{\"degree\": 1, \"knots\": [0, 2, 1]}", &["`knots[2]`", "must not decrease"]),
        ("{\"degree\": 1, \"knots\": [0, 0, 0]}", &["`knots`", "all 3 knots are equal"]),
        ("{\"degree\": 3, \"knots\": [0, 1, 2]}", &["--alpha is missing"]),
        ("{\"degree\": 3, \"knots\": [0, 1, 2], \"alpha\": 2}", &["`knots`", "needs at least 7 knots"]),
        (
            "{\"degree\": 1000000000000000000, \"knots\": [0, 1], \"alpha\": 2}",
            &["`knots`", "needs at least"],
        ),
        (
            "{\"degree\": 1, \"knots\": [0, 1, 2], \"alpha\": 0.5}",
            &["`alpha`", "1/2 lies in [0, 1]", "line 1"],
        ),
        ("{\"degree\": 1, \"knots\": [0, 1, 2], \"alpha\": [2, \"nan\"]}", &["`alpha[1]`", "not a finite"]),
        ("{\"degree\": 1, \"knots\": [0, 1, 2], \"alpha\": []}", &["`alpha`", "the list is empty"]),
        (
            "{\"degree\": 1, \"knots\": [0, 1, 2, 3], \"alpha\": 2, \"points\": [[1], [1, 2]]}",
            &["`points[1]`", "2 coordinates and point 0 has 1"],
        ),
        (
            "{\"degree\": 1, \"knots\": [0, 1, 2], \"alpha\": 2, \"points\": [[1], [2]]}",
            &["`points`", "takes 1 control points"],
        ),
        ("{\"degree\": 1, \"knots\": [0, 1, 2], \"alpha\": [2, 5]}", &["here are 2, 5"]),
    ] {
        fs::write(&path, content).unwrap();
        if parts[0].starts_with("--alpha") || parts[0].starts_with("here are") {
            let path = path.to_str().unwrap();
            rejected(&["eval", "--instance", path, "--x", "1"], "--alpha", parts);
        } else {
            rejected_instance(&path, parts);
        }
    }
    fs::write(&path, b"{\"degree\": 1, \xff\xfe}").unwrap();
    rejected_instance(&path, &["cannot read", "byte 14 is not UTF-8"]);
    fs::write(&path, "[".repeat(100_000)).unwrap();
    rejected_instance(&path, &["line 1 column"]);
    fs::write(&path, " ".repeat(17 * 1024 * 1024)).unwrap();
    rejected_instance(&path, &["longer than 16777216 bytes"]);
}

#[test]
fn what_is_no_instance_file_at_all() {
    let folder = tempfile::tempdir().unwrap();
    rejected_instance(folder.path(), &["cannot read", "directory"]);
    rejected_instance(&folder.path().join("none.json"), &["no instance of the paper (U0, U1,", "no file"]);
    rejected(&["eval", "--instance", "U99", "--x", "1"], "--instance", &["`U99`", "S7", "C7a, C7b, C7c"]);
    rejected(&["eval", "--instance", "", "--x", "1"], "--instance", &["--instance"]);
}

#[cfg(unix)]
#[test]
fn arguments_that_are_not_utf_8() {
    use std::ffi::OsStr;
    use std::os::unix::ffi::OsStrExt;
    let bad = OsStr::from_bytes(b"\xff\xfe");
    for option in ["--knots", "--x", "--alpha", "--instance"] {
        let mut command = knotproof(&["eval", "--format", "json"]);
        let output =
            command.args([OsStr::new(option), bad]).assert().code(2).stdout("").get_output().stderr.clone();
        let report: Value = serde_json::from_slice(&output).unwrap();
        assert_eq!(report["schema"], "knotproof.error/1");
    }
}
