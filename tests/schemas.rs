//! What the commands write is what the schemas say that they print, and nothing else.

#![allow(clippy::unwrap_used, reason = "helpers of tests")]

use std::fs;
use std::path::Path;

use jsonschema::Validator;
use serde_json::{Map, Value, json};

/// What a command writes, and where that is.
struct Run {
    stdout: String,
    stderr: String,
}

fn run(arguments: &[&str], folder: &Path) -> Run {
    let mut command = crate::process();
    let output = command.args(arguments).current_dir(folder).output().unwrap();
    let [stdout, stderr] = [output.stdout, output.stderr].map(|text| String::from_utf8(text).unwrap());
    Run { stdout, stderr }
}

fn here(arguments: &[&str]) -> Run {
    run(arguments, Path::new("."))
}

/// All names that `schema` knows, from its own message.
fn names() -> Vec<String> {
    let message = here(&["schema", "nothing"]).stderr;
    let listed = message.split_once("[possible values: ").unwrap().1.split_once(']').unwrap().0;
    listed.split(", ").map(str::to_owned).collect()
}

fn schema(name: &str) -> Value {
    serde_json::from_str(&here(&["schema", name]).stdout).unwrap()
}

/// The same, and no key is allowed that it does not describe.
fn strict(name: &str) -> Validator {
    let mut schema = schema(name);
    close(&mut schema, true);
    jsonschema::draft202012::options().build(&schema).unwrap()
}

/// Adds `unevaluatedProperties: false` wherever a schema describes a value as a whole; what only describes a part of
/// one, as the branches of `anyOf`, must allow the keys of the other parts.
fn close(schema: &mut Value, whole: bool) {
    let Some(fields) = schema.as_object_mut() else { return };
    if whole {
        fields.insert("unevaluatedProperties".to_owned(), false.into());
    }
    for part in ["anyOf", "oneOf", "allOf"] {
        fields
            .get_mut(part)
            .and_then(Value::as_array_mut)
            .into_iter()
            .flatten()
            .for_each(|of| close(of, false));
    }
    for (part, whole) in [("properties", true), ("$defs", false)] {
        let parts = fields.get_mut(part).and_then(Value::as_object_mut);
        parts.into_iter().flatten().for_each(|(_, of)| close(of, whole));
    }
    for part in ["items", "additionalProperties"] {
        if let Some(of) = fields.get_mut(part) {
            close(of, true);
        }
    }
    fields
        .get_mut("prefixItems")
        .and_then(Value::as_array_mut)
        .into_iter()
        .flatten()
        .for_each(|of| close(of, true));
}

fn errors(validator: &Validator, value: &Value) -> Vec<String> {
    validator.iter_errors(value).map(|error| format!("{}: {error}", error.instance_path())).collect()
}

/// The keys that have no description, in all parts of a schema. A variant of which a key is the only one describes it.
fn undescribed(schema: &Value, path: &str, found: &mut Vec<String>) {
    let said =
        |of: &Value| of.get("description").and_then(Value::as_str).is_some_and(|text| !text.is_empty());
    let Some(fields) = schema.as_object() else { return };
    for (part, of) in fields {
        let path = format!("{path}/{part}");
        match (part.as_str(), of) {
            ("properties" | "$defs", Value::Object(parts)) => {
                let variant = parts.len() == 1 && said(schema);
                for (name, of) in parts {
                    if part == "properties" && !variant && !said(of) {
                        found.push(format!("{path}/{name}"));
                    }
                    undescribed(of, &format!("{path}/{name}"), found);
                }
            }
            (_, Value::Array(items)) => items.iter().for_each(|of| undescribed(of, &path, found)),
            _ => undescribed(of, &path, found),
        }
    }
}

const VECTOR: [&str; 6] = ["--degree", "2", "--knots", "0 0 0 1 2 2 2", "--alpha", "5"];
const MEMBER: [&str; 8] =
    ["--degree", "2", "--knots", "0 0 0 1 2 2 2", "--family", "lupas", "--set", "q=1/2"];
/// A line that jumps at 1.
const JUMPS: [&str; 8] = ["--degree", "1", "--knots", "0 0 1 1 2 2", "--alpha", "5", "--points", "0 3 1 0"];
const POINTS: [&str; 2] = ["--points", "0,0 1,2 2,2 3,0"];

/// What says something of the paper carries its number.
const OF_PAPER: [&str; 8] = ["check", "judge", "report", "explain", "prove", "verify", "search", "merge"];

/// A name of a schema, and commands that write what it describes.
fn examples() -> Vec<(&'static str, Vec<Vec<&'static str>>)> {
    let on = |command: &'static str, more: &[&'static str]| [&[command], &VECTOR[..], more].concat();
    let of_member = |command: &'static str, more: &[&'static str]| [&[command], &MEMBER[..], more].concat();
    let two_maxima = ["--degree", "3", "--knots", "0 0 0 0 1 2 4 4", "--alpha", "5/2", "--index", "2"];
    vec![
        (
            "eval",
            vec![
                on("eval", &["--x", "1/2"]),
                on("eval", &["--x", "1", "--side", "left", "--derivatives", "2", POINTS[0], POINTS[1]]),
                on("eval", &["--x", "1/2", "--index", "1", "--float"]),
                on("eval", &["--x", "1/2", "--digits", "5", "--derivatives", "1"]),
                on("eval", &["--points-file", "points.csv", "--derivatives", "1", POINTS[0], POINTS[1]]),
                on("eval", &["--points-file", "points.csv", "--index", "1", "--float"]),
                of_member("eval", &["--x", "1/2", POINTS[0], POINTS[1]]),
            ],
        ),
        (
            "formula",
            vec![
                on("formula", &[]),
                of_member("formula", &[]),
                vec![
                    "formula",
                    "--degree",
                    "1",
                    "--knots",
                    "0 0 1 1",
                    "--alpha",
                    "symbolic",
                    "--expanded",
                    "--as",
                    "latex",
                ],
                vec![
                    "formula",
                    "--degree",
                    "1",
                    "--knots",
                    "0 0 1 1",
                    "--alpha",
                    "-1",
                    "--equals",
                    "formulas.txt",
                ],
            ],
        ),
        (
            "families",
            vec![
                vec!["families"],
                vec!["families", "phillips"],
                vec!["families", "--like", "q*(x-a) : b-x"],
                vec!["families", "polya", "--table"],
            ],
        ),
        (
            "bezier",
            vec![
                on("bezier", &POINTS),
                on("bezier", &[POINTS[0], POINTS[1], "--float"]),
                on("bezier", &[POINTS[0], POINTS[1], "--derivative"]),
                on("bezier", &[POINTS[0], POINTS[1], "--as", "nurbs"]),
                on("bezier", &[POINTS[0], POINTS[1], "--as", "nurbs", "--standard-form", "--float"]),
                on("bezier", &[POINTS[0], POINTS[1], "--as", "step", "--digits", "5"]),
                of_member("bezier", &POINTS),
            ],
        ),
        (
            "joins",
            vec![
                on("joins", &POINTS),
                on("joins", &[POINTS[0], POINTS[1], "--float"]),
                of_member("joins", &POINTS),
                vec!["joins", "--all"],
            ],
        ),
        (
            "solve",
            vec![
                on("solve", &[POINTS[0], POINTS[1], "--coordinate", "1", "--value", "1", "--value", "3/2"]),
                on("solve", &[POINTS[0], POINTS[1], "--normal", "1 -1", "--float"]),
                of_member(
                    "solve",
                    &["--points", "0 2 2 0", "--value", "0.1", "--digits", "5", "--from", "0.1"],
                ),
                [&["solve"], &JUMPS[..], &["--value", "3", "--value", "2"]].concat(),
            ],
        ),
        (
            "bounds",
            vec![
                on("bounds", &POINTS),
                on("bounds", &[POINTS[0], POINTS[1], "--normal", "1 1", "--to", "3/2", "--float"]),
                of_member("bounds", &POINTS),
                [&["bounds"], &JUMPS[..]].concat(),
            ],
        ),
        (
            "length",
            vec![
                on("length", &POINTS),
                on("length", &[POINTS[0], POINTS[1], "--width", "1e-4", "--float"]),
                of_member("length", &[POINTS[0], POINTS[1], "--digits", "4"]),
            ],
        ),
        (
            "interpolate",
            vec![
                on("interpolate", &["--at", "0 1/2 3/2 2", POINTS[0], POINTS[1]]),
                on("interpolate", &["--at", "0 1/4 1/2 3/4", POINTS[0], POINTS[1], "--float"]),
                on("interpolate", &["--at", "0 1/2", "--digits", "3"]),
                of_member("interpolate", &["--at", "0 1/2 3/2 2", POINTS[0], POINTS[1]]),
            ],
        ),
        (
            "insert",
            vec![
                on("insert", &["--at", "1/2", POINTS[0], POINTS[1]]),
                on("insert", &["--at", "0 2", POINTS[0], POINTS[1], "--float"]),
            ],
        ),
        (
            "plot",
            vec![
                on("plot", &[]),
                on("plot", &[POINTS[0], POINTS[1], "--out", "curve.svg"]),
                of_member("plot", &["--title", "Lupaş"]),
            ],
        ),
        (
            "check",
            vec![
                on("check", &["--property", "T3.5.3", "--property", "P3.1.1"]),
                on("check", &["--property", "T3.5.1", "--baseline"]),
                on("check", &["--property", "T3.5.1", "--amended"]),
                vec!["check", "--claim", "k = 1; U : n >= 1"],
                [
                    "check",
                    "--degree",
                    "1",
                    "--knots",
                    "0 0 1 1",
                    "--family",
                    "lupas",
                    "--set",
                    "q=2",
                    "--classical",
                ]
                .to_vec(),
            ],
        ),
        (
            "shape",
            vec![
                [&["shape"], &two_maxima[..]].concat(),
                [&["shape"], &two_maxima[..], &["--float"]].concat(),
                vec!["shape", "--degree", "2", "--knots", "0 0 0 1 2 2 2", "--alpha", "all", "--index", "1"],
                vec![
                    "shape",
                    "--degree",
                    "3",
                    "--knots",
                    "0 0 0 0 1 2 4 4",
                    "--alpha",
                    "all",
                    "--index",
                    "2",
                ],
                on("shape", &["--index", "1", "--free-knot", "3"]),
                on("shape", &[POINTS[0], POINTS[1]]),
                of_member("shape", &[]),
            ],
        ),
        (
            "float",
            vec![
                vec!["float", "--degree", "1", "--count", "10", "--steps", "0"],
                of_member("float", &["--count", "10", "--steps", "0"]),
                vec!["float", "--degree", "1", "--knots", "0 0.1 1/3 2", "--alpha", "-1", "--x", "0.2"],
            ],
        ),
        ("figures", vec![vec!["figures", "7", "--out", "pictures"]]),
        ("vectors", vec![vec!["vectors", "--degree", "1", "--out", "vectors.json"]]),
        (
            "judge",
            vec![
                vec!["judge", "rational-bsplines", "--claim", "P2.1.1", "--claim", "P2.1.3"],
                vec!["judge", "rational-bsplines", "--claim", "T3.5.3", "--degrees", "1..2"],
            ],
        ),
        ("new", vec![vec!["new", "my-paper"]]),
        (
            "report",
            vec![
                vec!["report", "--claim", "phi.range", "--claim", "P2.1.3"],
                vec!["report", "--claim", "P2.1.1", "--baseline", "verdicts.json"],
                vec!["report", "--errata"],
            ],
        ),
        (
            "explain",
            vec![
                vec!["explain", "T3.5.3"],
                vec!["explain", "X.totalpositivity", "--goals"],
                vec!["explain", "P2.1.1"],
            ],
        ),
        ("prove", vec![vec!["prove", "--claim", "P2.1.1", "--out", "certificates"]]),
        // After `prove`: one that is accepted, one that is not, and all the others missing.
        (
            "verify",
            vec![
                vec!["verify", "certificates", "damaged"],
                vec!["verify", "certificates", "--claim", "P2.1.1"],
            ],
        ),
        (
            "search",
            vec![
                vec!["search", "--degree", "3", "--limit", "9"],
                vec![
                    "search",
                    "--degree",
                    "3",
                    "--limit",
                    "9",
                    "--limit-gap",
                    "4",
                    "--limit-height",
                    "5",
                    "--shard",
                    "0/2",
                ],
                vec!["search", "--degree", "3", "--find", "equal", "--limit", "9"],
                vec!["search", "--degree", "2", "--count", "20", "--find", "most"],
                vec!["search", "--degree", "3", "--family", "lupas", "--set", "q=1/3", "--limit", "8"],
                vec!["search", "--degree", "2", "--family", "knot-weights", "--count", "20"],
                vec!["search", "--degree", "3", "--count", "200", "--find", "deepest", "--alpha", "-4"],
            ],
        ),
        (
            "merge",
            vec![vec!["merge", "all.jsonl"], vec!["merge", "all.jsonl", "--audit", "1", "--seed", "7"]],
        ),
        ("completions", vec![vec!["completions", "bash"]]),
        ("man", vec![vec!["man", "--out", "pages"]]),
        ("help", vec![vec!["help"], vec!["help", "eval"]]),
        (
            "error",
            vec![
                vec!["eval"],
                on("eval", &["--x", "1/0"]),
                vec!["explain", "T9"],
                vec!["schema", "nothing"],
                vec!["check", "--claim", "x : y = 1"],
            ],
        ),
    ]
}

/// A folder with the files that the examples read.
fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let write = |name: &str, text: &str| fs::write(folder.path().join(name), text).unwrap();
    write("points.csv", "1/2\n1,left\n");
    write("formulas.txt", "G_0(x) := x$\n");
    let recorded = fs::read_to_string(root.join("proofs/verdicts.json")).unwrap();
    let mut verdicts: Value = serde_json::from_str(&recorded).unwrap();
    for entry in verdicts["claims"].as_array_mut().unwrap() {
        entry["as_printed"]["status"] = "undecided".into();
    }
    write("verdicts.json", &verdicts.to_string());
    fs::create_dir(folder.path().join("damaged")).unwrap();
    write("damaged/P2.1.1.printed.statement", "(");
    write("damaged/P2.1.1.printed.proof", "(");
    run(&["search", "--degree", "3", "--limit", "9", "--checkpoint", "all.jsonl"], folder.path());
    folder
}

/// The objects that a command writes: one, or one a line.
fn objects(name: &str, arguments: &[&str], folder: &Path) -> Vec<Value> {
    let written = run(&[arguments, &["--format", "json"]].concat(), folder);
    let text = if name == "error" { written.stderr } else { written.stdout };
    let stream = serde_json::Deserializer::from_str(&text).into_iter();
    let objects: Vec<Value> = stream.map(|value| value.unwrap()).collect();
    assert!(!objects.is_empty(), "{arguments:?} wrote nothing to look at");
    objects
}

/// An object with one change at a time, somewhere in it: a key more, a key less, a value of another type. The flag says
/// whether it is a key less: one that may be left out is no fault then.
fn changed(object: &Value) -> Vec<(String, Value, bool)> {
    let mut changes = Vec::new();
    let Value::Object(fields) = object else { return changes };
    let with = |change: &dyn Fn(&mut Map<String, Value>)| {
        let mut fields = fields.clone();
        change(&mut fields);
        Value::Object(fields)
    };
    changes.push((
        "a key more".to_owned(),
        with(&|fields| drop(fields.insert("more".to_owned(), 1.into()))),
        false,
    ));
    for (name, value) in fields {
        changes.push((format!("without {name}"), with(&|fields| drop(fields.shift_remove(name))), true));
        // No value is a list in a list in a list of truth values.
        let wrong = json!([[[true]]]);
        changes.push((
            format!("{name} of another type"),
            with(&|fields| drop(fields.insert(name.clone(), wrong.clone()))),
            false,
        ));
        let inner = match value {
            Value::Array(items) => items.first(),
            _ => Some(value),
        };
        for (what, inner, less) in inner.map(changed).unwrap_or_default() {
            let put = |fields: &mut Map<String, Value>| match &mut fields[name] {
                Value::Array(items) => items[0] = inner.clone(),
                value => *value = inner.clone(),
            };
            changes.push((format!("{name}: {what}"), with(&put), less));
        }
    }
    changes
}

#[test]
fn every_output_is_as_its_schema_says() {
    let folder = folder();
    let mut described: Vec<_> = Vec::new();
    for (name, commands) in examples() {
        described.push(name.to_owned());
        let (strict, mut missed) = (strict(name), 0);
        for arguments in commands {
            let objects = objects(name, &arguments, folder.path());
            // Of several lines one tells what made them, the first or the last.
            let telling = objects.iter().find(|object| object.get("version").is_some()).unwrap();
            assert_eq!(telling["version"], env!("CARGO_PKG_VERSION"), "{arguments:?}");
            let paper = telling.pointer("/paper/arxiv").and_then(Value::as_str);
            let of_paper = OF_PAPER.contains(&name) || arguments[..] == ["joins", "--all"];
            assert_eq!(paper, of_paper.then_some("1805.04433"), "{arguments:?}");
            for (at, object) in objects.iter().enumerate() {
                let found = errors(&strict, object);
                assert!(found.is_empty(), "{arguments:?}: {found:#?}\n{object:#}");
                // It is held against the schema in earnest: it fails once it is changed. Many lines are much alike.
                let changes = if at == 0 || at + 1 == objects.len() { changed(object) } else { Vec::new() };
                for (what, object, less) in changes {
                    let holds = strict.is_valid(&object);
                    assert!(!holds || less, "{arguments:?}: nobody notices {what}");
                    missed += usize::from(less && !holds);
                }
            }
        }
        assert!(missed >= 2, "{name}: hardly any key has to be there");
    }
    let mut all = names();
    all.sort();
    // Of files that are read: tests/language.rs and tests/families.rs.
    described.extend(["claims", "family"].map(str::to_owned));
    described.sort();
    assert_eq!(described, all, "each has an example");
}

#[test]
fn every_key_is_described() {
    for name in names() {
        let schema = schema(&name);
        assert_eq!(schema["$schema"], "https://json-schema.org/draft/2020-12/schema");
        assert!(jsonschema::meta::is_valid(&schema), "{name}");
        let mut found = Vec::new();
        undescribed(&schema, &name, &mut found);
        assert!(found.is_empty(), "{found:#?}");
        // Links of the documentation of the sources lead nowhere in a schema.
        assert!(!schema.to_string().contains("]("), "{name}");
    }
    let silent = json!({"properties": {"a": {"type": "string"}, "b": {"description": "b"}}});
    let mut found = Vec::new();
    undescribed(&silent, "", &mut found);
    assert_eq!(found, ["/properties/a"]);
}

#[test]
fn instance_files_are_as_their_schema_says() {
    let folder = tempfile::tempdir().unwrap();
    let schema: Value = serde_json::from_str(&here(&["schema"]).stdout).unwrap();
    let validator = jsonschema::draft202012::options().build(&schema).unwrap();
    let path = folder.path().join("instance.json");
    let knots = json!(["0", 0, 0, "1/2", 1, 1.0, 1]);
    for (instance, good) in [
        (json!({"degree": 2, "knots": knots}), true),
        (json!({"degree": 2.0, "knots": knots, "alpha": "-1", "$schema": "instance.schema.json"}), true),
        (json!({"degree": 2, "knots": knots, "alpha": ["inf"], "points": [["0"], [1], [2], [3]]}), true),
        (
            json!({"degree": 2, "knots": knots, "schema": "knotproof.eval/1", "version": env!("CARGO_PKG_VERSION"), "values": []}),
            true,
        ),
        (json!({"degree": 2, "knots": knots, "values": []}), false),
        (json!({"degree": 2, "knots": knots, "schema": "other/1"}), false),
        (json!({"degree": 2.5, "knots": knots}), false),
        (json!({"degree": -1, "knots": knots}), false),
        (json!({"degree": 2}), false),
        (json!({"degree": 2, "knots": "0 0 0 1 1 1"}), false),
        (json!({"degree": 2, "knots": knots, "alpha": []}), false),
    ] {
        fs::write(&path, instance.to_string()).unwrap();
        let arguments = ["eval", "--x", "1/4", "--instance", path.to_str().unwrap()];
        // What lacks an α gets one; `--alpha` would hide one that is wrong.
        let given = instance.get("alpha").is_some();
        let read = here(&[&arguments[..], if given { &[] } else { &["--alpha", "-1"] }].concat());
        assert_eq!(validator.is_valid(&instance), good, "the schema on {instance}");
        assert_eq!(!read.stdout.is_empty(), good, "the program on {instance}: {}", read.stderr);
    }
}

/// The file that is written beside the answer.
#[test]
fn a_file_of_vectors_is_as_its_schema_says() {
    let folder = tempfile::tempdir().unwrap();
    for of in [&["--degree", "2"][..], &["--family", "knot-weights", "--degree", "1"]] {
        let mut command = crate::program();
        command.current_dir(folder.path()).arg("vectors").args(of).args(["--out", "vectors.json"]);
        command.assert().success();
        let file: Value =
            serde_json::from_str(&fs::read_to_string(folder.path().join("vectors.json")).unwrap()).unwrap();
        let strict = strict("vectors");
        assert!(errors(&strict, &file).is_empty(), "{:#?}", errors(&strict, &file));
        for (what, object, less) in changed(&file) {
            assert!(!strict.is_valid(&object) || less, "nobody notices {what}");
        }
    }
}
