//! `knotproof eval --points-file`: the same answers as one call a point, in the order of the lines, and errors that
//! name the line.

#![allow(clippy::unwrap_used, reason = "helpers of tests")]

use std::io::{BufRead, BufReader, Write};
use std::path::PathBuf;
use std::process::{Child, Stdio};

use assert_cmd::Command;
use serde_json::{Map, Value, json};
use tempfile::TempDir;

const U4: [&str; 4] = ["--instance", "U4", "--alpha", "-1"];
const CURVE: [&str; 2] = ["--points", "0,0 1,2 2,2 3,0 1,1"];

fn knotproof(arguments: &[&str]) -> Command {
    let mut command = crate::program();
    command.arg("eval").args(arguments);
    command
}

/// A file that lives as long as the folder.
struct TestFile {
    _folder: TempDir,
    path: PathBuf,
}

impl TestFile {
    fn new(name: &str, content: impl AsRef<[u8]>) -> Self {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join(name);
        std::fs::write(&path, content).unwrap();
        Self { _folder: folder, path }
    }

    fn path(&self) -> &str {
        self.path.to_str().unwrap()
    }
}

/// What the program answers to a file.
fn answer(name: &str, content: impl AsRef<[u8]>, options: &[&str]) -> String {
    let file = TestFile::new(name, content);
    let output = knotproof(&[&U4, options, &["--points-file", file.path()]].concat())
        .assert()
        .success()
        .stderr("")
        .get_output()
        .stdout
        .clone();
    String::from_utf8(output).unwrap()
}

/// What the program answers to standard input.
fn piped(content: &str, options: &[&str]) -> String {
    let output = knotproof(&[&U4, options, &["--points-file", "-"]].concat())
        .write_stdin(content)
        .assert()
        .success()
        .stderr("")
        .get_output()
        .stdout
        .clone();
    String::from_utf8(output).unwrap()
}

fn json_lines(text: &str) -> Vec<Value> {
    text.lines().map(|line| serde_json::from_str(line).unwrap()).collect()
}

/// The answer to a single point, as JSON.
fn single(x: &str, options: &[&str]) -> Map<String, Value> {
    let arguments = [&U4, options, &["--format", "json", "--x", x]].concat();
    let output = knotproof(&arguments).assert().success().get_output().stdout.clone();
    serde_json::from_slice::<Value>(&output).unwrap().as_object().unwrap().clone()
}

/// On knots, between knots, at both ends and outside.
const POINTS: [&str; 8] = ["0", "1/3", "1", "3/2", "2", "3", "-1", "7/2"];

#[test]
fn json_is_that_of_one_call_a_point() {
    for (options, removed) in [
        (vec![], 0),
        (vec!["--derivatives", "2"], 0),
        (vec!["--index", "1", "--side", "left", "--derivatives", "1"], 0),
        ([&CURVE[..], &["--derivatives", "1"]].concat(), 1),
    ] {
        let content = POINTS.join("\n");
        let lines =
            json_lines(&answer("points.csv", content, &[&options[..], &["--format", "json"]].concat()));
        assert_eq!(lines.len(), POINTS.len() + 1);
        for (x, line) in POINTS.iter().zip(&lines[1..]) {
            // Together the first line and the line of the point say what a single call says, but for de Boor's points.
            let mut joined = lines[0].as_object().unwrap().clone();
            joined.extend(line.as_object().unwrap().clone());
            let mut expected = single(x, &options);
            let inside = !["-1", "7/2"].contains(x);
            assert_eq!(expected.remove("de_boor").is_some(), removed == 1 && inside, "{x} {options:?}");
            assert_eq!(joined, expected, "{x} {options:?}");
        }
    }
}

#[test]
fn csv_has_the_numbers_of_the_json() {
    let options = [&CURVE[..], &["--derivatives", "2"]].concat();
    let text = answer("points.csv", POINTS.join("\n"), &options);
    let rows: Vec<Vec<&str>> = text.lines().map(|line| line.split(',').collect()).collect();
    let column = |name: &str| rows[0].iter().position(|column| *column == name).unwrap();
    let whole = |name: String, numbers: &Value, row: &[&str]| {
        let start = column(&format!("{name}_0"));
        let found = row.iter().skip(start).take(numbers.as_array().unwrap().len());
        assert_eq!(json!(found.collect::<Vec<_>>()), *numbers, "{name}");
    };
    for (x, row) in POINTS.iter().zip(&rows[1..]) {
        let expected = single(x, &options);
        assert_eq!(row.len(), rows[0].len());
        assert_eq!((row[column("x")], row[column("side")]), (*x, "right"));
        whole("G".to_owned(), &expected["values"], row);
        whole("curve".to_owned(), &expected["curve"], row);
        for (name, field) in [("G_0", "derivatives"), ("curve_0", "curve_derivatives")] {
            for order in 1..=2 {
                let numbers = expected[field][order - 1].as_array().unwrap();
                let start = column(&format!("{name}^({order})"));
                assert_eq!(json!(row[start..start + numbers.len()]), json!(numbers), "{name} {order}");
            }
        }
    }
}

#[test]
fn the_answer_as_csv_word_for_word() {
    let options = ["--degree", "1", "--knots", "0 0 1 1", "--points", "3 5", "--derivatives", "1"];
    let expected = "\
x,side,G_0,G_1,G_0^(1),G_1^(1),curve_0,curve_0^(1)
1/2,right,2/3,1/3,-8/9,8/9,11/3,16/9
1,left,0,1,-2,2,5,4
";
    assert_eq!(answer("points.csv", "1/2\n1,left\n", &options), expected);
}

#[test]
fn the_answer_as_json_word_for_word() {
    let options = ["--degree", "1", "--knots", "0 0 1 1", "--index", "1", "--format", "json"];
    let expected = r#"{"schema":"knotproof.eval/1","degree":1,"knots":["0","0","1","1"],"alpha":"-1","index":1,"version":"VERSION"}
{"x":"1/2","side":"right","values":["1/3"]}
{"x":"1","side":"left","values":["1"]}
"#;
    assert_eq!(
        answer("points.jsonl", "0.5\n{\"side\": \"left\", \"x\": 1.0}\n", &options),
        expected.replace("VERSION", env!("CARGO_PKG_VERSION"))
    );
}

#[test]
fn one_function_is_one_column() {
    let text = answer("points.csv", "1\n2\n", &["--index", "3"]);
    assert_eq!(text, "x,side,G_3\n1,right,0\n2,right,1/3\n");
}

#[test]
fn csv_is_read_as_spreadsheets_write_it() {
    let plain = answer("points.csv", "1/3\n2\n5/2\n", &[]);
    for content in [
        "x\n1/3\n2\n5/2\n",
        "# exact\n\nx,side\n1/3,right\n\n  # more\n2,\n5/2",
        "\u{feff}\"x\",\"side\"\r\n\"1/3\",\"right\"\r\n\"2\",\"\"\r\n\"2.5\",\"\"\r\n",
        " 1/3 , right \n+2\n0x2.8\n",
    ] {
        assert_eq!(answer("points.csv", content, &[]), plain, "{content:?}");
        assert_eq!(answer("points.TXT", content, &[]), plain, "{content:?}");
        assert_eq!(answer("points", content, &[]), plain, "{content:?}");
        assert_eq!(piped(content, &[]), plain, "{content:?}");
    }
}

#[test]
fn json_lines_are_read_in_every_notation() {
    let plain = answer("points.csv", "1/3\n2\n5/2\n", &[]);
    let content = "{\"x\": \"1/3\", \"side\": \"right\"}\r\n\n \"2\"\n2.50\n";
    assert_eq!(answer("points.ndjson", content, &[]), plain);
    assert_eq!(answer("points", format!("\u{feff}{content}"), &[]), plain);
    assert_eq!(piped(content, &[]), plain);
    // Numbers and strings tell nothing of the form, and need not.
    for content in ["\"1/3\"\n2\n2.5\n", "{\"x\": \"1/3\", \"side\": null}\n{\"x\": 2}\n\"5/2\""] {
        assert_eq!(answer("points.jsonl", content, &[]), plain);
        assert_eq!(piped(content, &[]), plain);
    }
}

#[test]
fn a_side_in_the_file_goes_before_the_option() {
    let options = ["--derivatives", "1", "--side", "left", "--format", "json"];
    let lines = json_lines(&piped("1\n1,right\n1,left\n", &options));
    let expected = |side| {
        let mut point = single("1", &["--derivatives", "1", "--side", side]);
        point.retain(|key, _| ["x", "side", "values", "derivatives"].contains(&key.as_str()));
        Value::from(point)
    };
    let (left, right) = (expected("left"), expected("right"));
    assert_ne!(left, right);
    assert_eq!(lines[1..], [left.clone(), right, left]);
}

/// The error for a line, and that the `before` points before it are answered.
fn rejected(name: &str, content: impl AsRef<[u8]>, before: usize, parts: &[&str]) {
    let file = TestFile::new(name, content);
    for format in ["text", "json"] {
        let arguments = [&U4[..], &["--format", format, "--points-file", file.path()]].concat();
        let output = knotproof(&arguments).assert().code(2).get_output().clone();
        let lines = String::from_utf8(output.stdout).unwrap().lines().count();
        assert_eq!(lines, if before == 0 { 0 } else { 1 + before }, "{format}");
        let text = String::from_utf8(output.stderr).unwrap();
        let message = match format {
            "text" => text,
            _ => {
                let report: Value = serde_json::from_str(&text).unwrap();
                assert_eq!(report["schema"], "knotproof.error/1");
                assert_eq!(report["error"]["argument"], "--points-file");
                report["error"]["message"].as_str().unwrap().to_owned()
            }
        };
        assert_eq!(message.trim_end().lines().count(), 1, "{message}");
        for part in [parts, &[file.path(), "--points-file"]].concat() {
            assert!(message.contains(part), "{part:?} in {message}");
        }
    }
}

#[test]
fn a_bad_line_is_named_and_those_before_it_are_answered() {
    rejected("points.csv", "x\n1\n2\nthree\n4\n", 2, &["line 4:", "`three` is not a number: write 3, -1/2"]);
    rejected(
        "points.jsonl",
        "1\n{\"x\": }\n",
        1,
        &["line 2:", "at column 7", "{\"x\": \"1/3\", \"side\": \"left\"}"],
    );
    rejected("points.csv", "# first\n\nNaN\n", 0, &["line 3:", "`NaN` is not a finite number"]);
}

#[test]
fn bad_lines() {
    for (content, parts) in [
        (&b"1/0\n"[..], ["line 1:", "divides by zero"]),
        (b"1\n,left\n", ["line 2:", "a number is missing"]),
        (b"1\n0,5\n", ["line 2:", "the side is `5`: write left, right, or nothing"]),
        (b"1\n1,left,2\n", ["line 2:", "more than two columns"]),
        (b"1\n\"2\n3\n", ["line 2:", "quotation mark is not closed"]),
        (b"1\n2\r3\n", ["line 2:", "carriage return inside the line"]),
        (b"1\nx\n", ["line 2:", "`x` is not a number"]),
        (b"1\n1\0\n", ["line 2:", "byte 2 of the line is NUL"]),
        (b"1\n \xff\n", ["line 2:", "byte 2 of the line is not UTF-8"]),
        (b"1\n1e999\n", ["line 2:", "out of range"]),
        (b"1\n{\"x\": 1}\n", ["line 2:", "is not a number"]),
    ] {
        let before = usize::from(parts[0] == "line 2:");
        rejected("points.csv", content, before, &parts);
    }
    for (content, parts) in [
        (&b"1/3\n"[..], ["line 1:", "trailing characters"]),
        (b"1\n[2]\n", ["line 2:", "found a list"]),
        (b"1\nNaN\n", ["line 2:", "expected value"]),
        (b"1\n# no JSON\n", ["line 2:", "expected value"]),
        (b"1\n{\"x\": 1, \"t\": 2}\n", ["line 2:", "unknown field `t`"]),
        (b"1\n{\"x\": 1, \"side\": \"up\"}\n", ["line 2:", "unknown value `up`"]),
    ] {
        let before = usize::from(parts[0] == "line 2:");
        rejected("points.jsonl", content, before, &parts);
    }
}

#[test]
fn a_list_in_one_piece_is_no_file_of_points() {
    rejected(
        "points",
        "[1,\n2]\n",
        0,
        &["line 1:", "the text ends within", "write a number, a string with an exact number, or {"],
    );
}

#[test]
fn utf_16_is_noticed() {
    let wide: Vec<u8> = "\u{feff}1\n".encode_utf16().flat_map(u16::to_le_bytes).collect();
    rejected("points.csv", wide, 0, &["line 1:", "UTF-8 text"]);
}

#[test]
fn a_line_may_be_long_and_not_endless() {
    let digits = "3".repeat(40_000);
    let text = answer("points.csv", format!("1\n{digits}\n"), &["--index", "0"]);
    assert_eq!(text.lines().count(), 3);
    let content = format!("1\n{}\n", "3".repeat(70_000));
    rejected("points.csv", content, 1, &["line 2:", "longer than 65536 bytes"]);
}

#[cfg(target_os = "linux")]
#[test]
fn a_device_does_no_harm() {
    let output = knotproof(&[&U4[..], &["--points-file", "/dev/zero"]].concat()).assert().code(2).stdout("");
    assert!(String::from_utf8_lossy(&output.get_output().stderr).contains("line 1: the line is longer than"));
}

#[test]
fn a_file_without_points_is_an_error() {
    for content in ["", "\n\n", "x\n", "# nothing\nx,side\n\n"] {
        rejected("points.csv", content, 0, &["there is no point in it: write one x on each line"]);
    }
    let output = knotproof(&[&U4[..], &["--points-file", "-"]].concat()).write_stdin("").assert().code(2);
    assert!(
        String::from_utf8_lossy(&output.get_output().stderr).contains("standard input: there is no point")
    );
}

#[test]
fn a_file_that_cannot_be_read_is_named() {
    let folder = tempfile::tempdir().unwrap();
    for path in [folder.path().join("none.csv"), folder.path().to_owned()] {
        let path = path.to_str().unwrap();
        let output = knotproof(&[&U4[..], &["--points-file", path]].concat()).assert().code(2).stdout("");
        let message = String::from_utf8_lossy(&output.get_output().stderr).into_owned();
        assert!(message.contains(&format!("--points-file: cannot read {path}")), "{message}");
    }
}

#[test]
fn one_point_or_a_file() {
    for (options, parts) in [
        (&["--x", "1", "--points-file", "-"][..], ["'--points-file <FILE>'", "cannot be used with"]),
        (&[], ["--x <X>", "not provided"]),
    ] {
        let output = knotproof(&[&U4[..], options].concat()).assert().code(2).stdout("");
        let message = String::from_utf8_lossy(&output.get_output().stderr).into_owned();
        assert!(parts.iter().all(|part| message.contains(part)), "{message}");
    }
}

fn spawned(options: &[&str]) -> Child {
    crate::process()
        .arg("eval")
        .args(U4)
        .args(options)
        .args(["--points-file", "-"])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap()
}

#[test]
fn a_reader_who_leaves_ends_the_work() {
    for format in ["text", "json"] {
        let mut child = spawned(&["--format", format]);
        drop(child.stdout.take());
        let mut to = child.stdin.take().unwrap();
        // More than any pipe holds: the program has to stop reading, or this has to end by itself.
        let written = (0..1_000_000).try_for_each(|_| to.write_all(b"1/3\n"));
        assert_eq!(written.unwrap_err().kind(), std::io::ErrorKind::BrokenPipe);
        drop(to);
        let output = child.wait_with_output().unwrap();
        assert_eq!((output.status.code(), output.stderr.as_slice()), (Some(0), &b""[..]), "{format}");
    }
}

#[test]
fn an_answer_does_not_wait_for_the_next_point() {
    let mut child = spawned(&["--index", "0"]);
    let mut to = child.stdin.take().unwrap();
    let mut from = BufReader::new(child.stdout.take().unwrap()).lines();
    writeln!(to, "1/2").unwrap();
    assert_eq!(from.next().unwrap().unwrap(), "x,side,G_0");
    assert_eq!(from.next().unwrap().unwrap(), "1/2,right,4/9");
    writeln!(to, "0").unwrap();
    assert_eq!(from.next().unwrap().unwrap(), "0,right,1");
    drop(to);
    assert_eq!(child.wait().unwrap().code(), Some(0));
}
