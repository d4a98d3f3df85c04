//! Numbers and files at every entry: what is read, what is refused, and in which words.

#![allow(clippy::unwrap_used, reason = "helpers of tests")]

use std::fs;
use std::process::Output;

use serde_json::Value;
use tempfile::TempDir;

fn run(arguments: &[&str]) -> Output {
    crate::process().args(arguments).output().unwrap()
}

fn json(arguments: &[&str]) -> Value {
    let output = run(&[arguments, &["--format", "json"]].concat());
    assert!(!output.stdout.is_empty(), "{arguments:?}: {output:?}");
    serde_json::from_slice(&output.stdout).unwrap()
}

fn file(folder: &TempDir, name: &str, content: &str) -> String {
    let path = folder.path().join(name);
    fs::write(&path, content).unwrap();
    path.to_str().unwrap().to_owned()
}

/// Words of the program that a user need not know.
const FOREIGN: [&str; 14] = [
    "usize",
    "u8",
    "u16",
    "u32",
    "u64",
    "i64",
    "f64,",
    "struct",
    "enum",
    "tuple",
    "variant",
    "sequence",
    "floating point",
    "serde",
];

/// Refused with exit code 2, in words of the user; the message.
fn refused(arguments: &[&str]) -> String {
    let output = run(arguments);
    let message = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(2), "{arguments:?}: {message}");
    for word in FOREIGN {
        assert!(!message.split([' ', '`']).any(|part| part == word), "{word} in {message}");
    }
    message
}

/// Every way in which a number gets into the program.
fn entries(folder: &TempDir, number: &str) -> Vec<Vec<String>> {
    let knots = "0 0 0 1 2 2 2";
    let mut all: Vec<Vec<String>> = Vec::new();
    let mut add = |words: &[&str]| all.push(words.iter().map(ToString::to_string).collect());
    let eval = ["eval", "--degree", "2", "--alpha", "-1"];
    let here = ["--knots", knots];
    add(&[&eval[..], &here, &["--x", number]].concat());
    add(&["eval", "--degree", "2", "--x", "1", "--knots", knots, "--alpha", number]);
    for list in [format!("0 0 0 {number} 2 2 2"), format!("0,0,0,{number},2,2,2")] {
        for command in ["shape", "check", "formula", "bezier", "float"] {
            add(&[command, "--degree", "2", "--alpha", "-1", "--knots", &list]);
        }
        add(&[&eval[..], &["--x", "1", "--knots", &list]].concat());
    }
    let json = format!("[[0],[{number}],[2],[3]]");
    for points in [
        format!("0 {number} 2 3"),
        format!("0,1 {number},1 2,2 3,3"),
        format!("(0),({number}),(2),(3)"),
        json,
    ] {
        for command in [&eval[..], &["bezier", "--degree", "2", "--alpha", "-1"]] {
            let x: &[&str] = if command[0] == "eval" { &["--x", "1"] } else { &[] };
            add(&[command, &here, x, &["--points", &points]].concat());
        }
    }
    add(&[&["shape", "--degree", "2", "--alpha", "-1", "--width", number][..], &here].concat());
    add(&[&["float", "--degree", "2", "--alpha", "-1", "--x", number][..], &here].concat());
    for (name, content) in [
        ("points.csv", number.to_owned()),
        ("points.txt", format!("{number},left")),
        ("points.jsonl", format!("{{\"x\":{number}}}")),
        ("points.ndjson", number.to_owned()),
        ("text.jsonl", format!("{{\"x\":\"{number}\"}}")),
    ] {
        let path = file(folder, &format!("{number}-{name}"), &content);
        add(&[&eval[..], &here, &["--points-file", &path]].concat());
    }
    for (at, quote) in
        [("degree", ""), ("knots", ""), ("knots", "\""), ("alpha", ""), ("alpha", "\""), ("points", "")]
    {
        let value = |field: &str, usual: &str| {
            if field == at { format!("{quote}{number}{quote}") } else { usual.to_owned() }
        };
        let content = format!(
            "{{\"degree\":{},\"knots\":[0,{},2],\"alpha\":[{}],\"points\":[[{}]]}}",
            value("degree", "1"),
            value("knots", "1"),
            value("alpha", "-1"),
            value("points", "3")
        );
        let path = file(folder, &format!("{number}-{at}{}.json", quote.len()), &content);
        add(&["eval", "--x", "1", "--instance", &path]);
    }
    for option in [
        "--degree",
        "--limit",
        "--limit-gap",
        "--limit-height",
        "--count",
        "--seed",
        "--spread",
        "--shard",
        "--threads",
    ] {
        let degree: &[&str] = if option == "--degree" { &[] } else { &["--degree", "3"] };
        add(&[&["search", option, number][..], degree].concat());
    }
    for option in ["--degree", "--index", "--derivatives"] {
        let degree: &[&str] = if option == "--degree" { &[] } else { &["--degree", "2"] };
        add(&[&["eval", "--alpha", "-1", "--x", "1", option, number][..], &here, degree].concat());
    }
    all
}

/// Exponents at the edges of all integers: out of range wherever they are read, and never a failure of the program.
#[test]
fn exponents_at_the_edges_of_integers() {
    let folder = tempfile::tempdir().unwrap();
    let mut tried = 0;
    for exponent in
        ["-9223372036854775808", "9223372036854775807", "-9223372036854775809", "9223372036854775808"]
    {
        for call in entries(&folder, &format!("1e{exponent}")) {
            let words: Vec<&str> = call.iter().map(String::as_str).collect();
            let message = refused(&words);
            assert!(!message.contains("internal"), "{call:?}: {message}");
            tried += 1;
        }
    }
    assert!(tried > 150, "{tried}");
    for exponent in [
        "-2147483648",
        "-2147483649",
        "-4294967296",
        "-170141183460469231731687303715884105728",
        "-401",
        "401",
    ] {
        for number in [format!("1e{exponent}"), format!("-0x1.8p{exponent}000")] {
            let x = ["eval", "--degree", "1", "--knots", "0 1 2", "--alpha", "2", "--x", &number];
            assert!(refused(&x).contains("is out of range"), "{number}");
        }
    }
}

/// An object is no number, also where its only key is one by which libraries mark numbers.
#[test]
fn an_object_is_no_number() {
    let folder = tempfile::tempdir().unwrap();
    let search =
        String::from_utf8(run(&["search", "--degree", "3", "--limit", "7", "--format", "json"]).stdout)
            .unwrap();
    let recorded = fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/proofs/verdicts.json")).unwrap();
    for key in [
        "$serde_json::private::Number",
        "\\u0024serde_json::private::Number",
        "$serde_json::private::RawValue",
    ] {
        for value in ["\"1\"", "1", "\"-1\""] {
            let object = format!("{{\"{key}\":{value}}}");
            for field in ["degree", "knots", "alpha", "points"] {
                let value =
                    |name: &str, usual: &str| if name == field { object.clone() } else { usual.to_owned() };
                for alpha in [value("alpha", "-1"), format!("[{}]", value("alpha", "-1"))] {
                    let content = format!(
                        "{{\"degree\":{},\"knots\":[0,{},2],\"alpha\":{alpha},\"points\":[[{}]]}}",
                        value("degree", "1"),
                        value("knots", "1"),
                        value("points", "3")
                    );
                    let path = file(&folder, "instance.json", &content);
                    let message = refused(&["eval", "--x", "1", "--instance", &path]);
                    assert!(message.contains("found an object"), "{content}: {message}");
                }
            }
            let eval = ["eval", "--degree", "1", "--knots", "0 1 2", "--alpha", "2"];
            let message = refused(&[&eval[..], &["--x", "1", "--points", &format!("[[{object}]]")]].concat());
            assert!(message.contains("found an object"), "{message}");
            for line in [format!("{{\"x\":{object}}}"), object.clone()] {
                let path = file(&folder, "points.jsonl", &line);
                let message = refused(&[&eval[..], &["--points-file", &path]].concat());
                assert!(message.contains("object") || message.contains("unknown field"), "{line}: {message}");
            }
            for (from, to) in
                [("\"done\":", object.as_str()), ("\"several\":", &object), ("\"findings\":", &object)]
            {
                let (before, after) = search.rsplit_once(from).unwrap();
                let rest = after.trim_start_matches(|c: char| c.is_ascii_digit());
                let path = file(&folder, "search.jsonl", &format!("{before}{from}{to}{rest}"));
                refused(&["merge", &path]);
                refused(&["search", "--resume", &path]);
            }
            let (before, after) = recorded.split_once("\"degree\": ").unwrap();
            let rest = after.trim_start_matches(|c: char| c.is_ascii_digit());
            let path = file(&folder, "verdicts.json", &format!("{before}\"degree\": {object}{rest}"));
            let message = refused(&["report", "--claim", "P2.1.1", "--baseline", &path]);
            assert!(message.contains("found an object"), "{message}");
        }
    }
}

/// 1.0 is an integer to JSON Schema, and `$schema` a field that editors write.
#[test]
fn what_the_schema_allows_is_read() {
    let folder = tempfile::tempdir().unwrap();
    let schema = json(&["schema"]);
    assert_eq!(schema["properties"]["degree"]["type"], "integer");
    assert_eq!(schema["properties"]["degree"].get("format"), None);
    let allowed = schema["else"]["propertyNames"]["enum"].as_array().unwrap();
    assert!(allowed.contains(&"$schema".into()) && !allowed.contains(&"schema".into()));
    for degree in ["1.0", "1", "1e0", "10e-1", "1.000"] {
        let content = format!(
            "{{\"$schema\":\"instance.schema.json\",\"degree\":{degree},\"knots\":[0,1,2],\"alpha\":-1}}"
        );
        let path = file(&folder, "instance.json", &content);
        assert_eq!(json(&["eval", "--x", "1", "--instance", &path])["degree"], 1);
    }
    for (content, part) in [
        ("{\"degree\":1.5,\"knots\":[0,1,2]}", "expected a whole number from 0 up, such as 2, and found 1.5"),
        ("{\"degree\":-1,\"knots\":[0,1,2]}", "expected a whole number"),
        ("{\"degree\":\"1\",\"knots\":[0,1,2]}", "found a string"),
        ("{\"degree\":true,\"knots\":[0,1,2]}", "found a truth value"),
        ("{\"degree\":1e30,\"knots\":[0,1,2]}", "too large"),
        ("{\"degree\":1,\"knots\":{}}", "expected a list, and found an object"),
        ("{\"degree\":1,\"knots\":3}", "expected a list, and found 3"),
        ("{\"degree\":1,\"knots\":[0,1],\"points\":[1.5]}", "expected a list, and found 1.5"),
        ("{\"$schema\":1,\"degree\":1,\"knots\":[0,1]}", "expected a string, and found 1"),
        ("{\"degree\":1,\"knots\":[0,1],\"schema\":\"other\"}", "a result begins with `knotproof.`"),
        ("{\"degree\":1,\"knots\":[0,1],\"pionts\":[]}", "unknown field `pionts`"),
        ("7", "expected an object with named fields, and found 7"),
        ("[1,[0,1]]", "expected an object with named fields, and found a list"),
        ("\"U4\"", "expected an object"),
    ] {
        let path = file(&folder, "instance.json", content);
        let message = refused(&["eval", "--x", "1", "--instance", &path]);
        assert!(message.contains(part), "{content}: {message}");
    }
}

/// What the program writes it reads.
#[test]
fn results_are_instances() {
    let folder = tempfile::tempdir().unwrap();
    let input = ["--degree", "2", "--knots", "0 0 0 1/3 2 2 2", "--alpha", "-1/2"];
    let wanted = json(&[&["eval", "--x", "1"], &input[..]].concat());
    let points = ["--points", "0,0 1,2 2,2 3,0"];
    for call in [
        [&["eval", "--x", "1/5", "--derivatives", "2"], &input[..], &points].concat(),
        [&["bezier"], &input[..], &points].concat(),
        [&["shape"], &input[..]].concat(),
        [&["shape", "--index", "1"], &input[..]].concat(),
        [&["check", "--property", "T3.5.2", "--property", "T3.5.3"], &input[..]].concat(),
        [&["formula"], &input[..]].concat(),
        [&["solve", "--coordinate", "0"], &input[..], &points].concat(),
        [&["bounds"], &input[..], &points].concat(),
        [&["length"], &input[..], &points].concat(),
        [&["shape"], &input[..], &points].concat(),
        [&["interpolate", "--at", "0 1/4 1 2"], &input[..], &points].concat(),
        [&["plot"], &input[..], &points].concat(),
    ] {
        let result = String::from_utf8(run(&[&call[..], &["--format", "json"]].concat()).stdout).unwrap();
        let path = file(&folder, "result.json", &result);
        let read = json(&["eval", "--x", "1", "--instance", &path]);
        for field in ["degree", "knots", "alpha", "values"] {
            assert_eq!(read[field], wanted[field], "{call:?}");
        }
    }
    // For every index there is none: it has to be given.
    for call in [["shape", "--alpha", "all"], ["formula", "--alpha", "symbolic"]] {
        let result = run(&[&call[..], &input[..4], &["--format", "json"]].concat()).stdout;
        let path = file(&folder, "result.json", &String::from_utf8(result).unwrap());
        assert!(refused(&["eval", "--x", "1", "--instance", &path]).contains("--alpha is missing"));
        assert_eq!(json(&["eval", "--x", "1", "--alpha", "-1/2", "--instance", &path]), wanted, "{call:?}");
    }
    // A line of a search.
    let search =
        String::from_utf8(run(&["search", "--degree", "3", "--limit", "7", "--format", "json"]).stdout)
            .unwrap();
    let finding = search.lines().next().unwrap();
    let path = file(&folder, "finding.json", finding);
    let (finding, read) =
        (serde_json::from_str::<Value>(finding).unwrap(), json(&["eval", "--x", "1", "--instance", &path]));
    for field in ["degree", "knots", "alpha"] {
        assert_eq!(read[field], finding[field]);
    }
}

/// What is written about a curve has the curve: a question of the answer is the question itself, and what was found can be asked.
#[test]
fn results_have_their_curves() {
    let folder = tempfile::tempdir().unwrap();
    let input = ["--degree", "2", "--knots", "0 0 0 1/3 2 2 2", "--alpha", "-1/2"];
    let points = ["--points", "0,0 1,2 2,2 3,0"];
    let wanted = json(&[&["bounds"], &input[..], &points].concat());
    for call in [
        "eval --x 1/5",
        "bezier",
        "joins",
        "solve --coordinate 1",
        "bounds --normal 1,1",
        "length --width 1e-3",
        "shape --curve",
        "plot",
    ] {
        let words: Vec<_> = call.split(' ').chain(["--format", "json"]).collect();
        let result = String::from_utf8(run(&[&words[..], &input, &points].concat()).stdout).unwrap();
        let path = file(&folder, "result.json", &result);
        assert_eq!(json(&["bounds", "--instance", &path]), wanted, "{call}");
    }
    let through = [&["interpolate", "--at", "0 1/4 1 2", "--format", "json"], &input[..], &points].concat();
    let path = file(&folder, "curve.json", &String::from_utf8(run(&through).stdout).unwrap());
    for (x, point) in [("0", ["0", "0"]), ("1/4", ["1", "2"]), ("1", ["2", "2"]), ("2", ["3", "0"])] {
        assert_eq!(json(&["eval", "--x", x, "--instance", &path])["curve"], serde_json::json!(point));
    }
    let inserted = ["insert", "--at", "1/3", "--alpha", "inf", "--format", "json", "--instance", &path];
    let path = file(&folder, "finer.json", &String::from_utf8(run(&inserted).stdout).unwrap());
    let finer = json(&["eval", "--x", "1", "--instance", &path]);
    assert_eq!(finer["knots"], serde_json::json!(["0", "0", "0", "1/3", "1/3", "2", "2", "2"]));
}

#[test]
fn answers_are_files_of_points() {
    let folder = tempfile::tempdir().unwrap();
    let asked = file(&folder, "asked.csv", "x,side\n1/3,left\n1,left\n1,right\n3/2\n");
    let u4 = ["eval", "--instance", "U4", "--alpha", "-1", "--derivatives", "1", "--points-file"];
    let answer = |path: &str, format: &str| {
        String::from_utf8(run(&[&u4[..], &[path, "--format", format]].concat()).stdout).unwrap()
    };
    for (format, name) in
        [("text", "answer.csv"), ("json", "answer.jsonl"), ("text", "answer"), ("json", "answer2")]
    {
        let first = answer(&asked, format);
        assert_eq!(first.lines().count(), 5);
        let path = file(&folder, name, &first);
        assert_eq!(answer(&path, format), first);
        // A line that was cut is noticed.
        let cut = file(&folder, name, first.trim_end().rsplit_once(',').unwrap().0);
        refused(&[&u4[..], &[&cut]].concat());
    }
}

#[test]
fn a_decimal_comma_is_refused_with_a_hint() {
    for knots in ["0 0 0 1,5 6 6 6", "0, 0, 0, 1,5, 6, 6, 6"] {
        let message = refused(&["shape", "--degree", "2", "--alpha", "-1", "--knots", knots]);
        assert!(message.contains("--knots, position 3") && message.contains("decimal point"), "{message}");
    }
    for knots in ["0,0,0,1,2,2,2", "0, 0, 0, 1, 2, 2, 2", "0 0 0 1 2 2 2"] {
        let x = [
            "eval",
            "--degree",
            "2",
            "--alpha",
            "-1",
            "--x",
            "1",
            "--points",
            "0,0 1,2 2,2 3,0",
            "--knots",
            knots,
        ];
        assert_eq!(json(&x)["curve"].as_array().unwrap().len(), 2);
    }
}

/// Other knots, another degree or other points are another thing than the instance of that name.
#[test]
fn a_changed_instance_says_what_was_changed() {
    let folder = tempfile::tempdir().unwrap();
    let own = file(&folder, "own.json", "{\"degree\":2,\"knots\":[0,0,0,1,2,2,2],\"alpha\":2}");
    for (options, suffix) in [
        (&["--instance", "U4"][..], "Instance U4 (Fig. 12)\n"),
        (&["--instance", "U4", "--degree", "2"], "Instance U4 (Fig. 12)\n"),
        (&["--instance", "C6b", "--degree", "3"], "(Fig. 24)\n"),
        (&["--instance", "U4", "--degree", "1"], "Instance U4 (Fig. 12), with other degree\n"),
        (&["--instance", "U4", "--knots", "0 0 0 1 2 2 2"], ", with other knots\n"),
        (&["--instance", "U4", "--knots", "0 0 1 2 2", "--degree", "1"], ", with other degree and knots\n"),
        (&["--instance", "C5", "--points", "0 1 2 3 4 5 6 7"], ", with other points\n"),
        (&["--instance", &own], "own.json\n"),
        (&["--instance", &own, "--degree", "1"], "own.json, with other degree\n"),
    ] {
        let text = run(&[&["eval", "--x", "1", "--alpha", "2"], options].concat()).stdout;
        let text = String::from_utf8(text).unwrap();
        let first = text.split_inclusive('\n').next().unwrap_or_default();
        assert!(first.ends_with(suffix), "{options:?}: {first}");
    }
}
