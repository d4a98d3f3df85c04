//! `knotproof report` as a user meets it, on a few claims that are judged quickly; the whole report is judged in
//! `tests/verdicts.rs`.

#![allow(clippy::unwrap_used, reason = "helpers of tests")]

use std::fs;
use std::path::Path;

use assert_cmd::Command;
use knotproof::report::Baseline;
use serde_json::Value;

fn knotproof(arguments: &[&str]) -> Command {
    let mut command = crate::program();
    command.args(arguments);
    command
}

/// The exit code and the result as JSON.
fn report(arguments: &[&str]) -> (i32, Value) {
    let output = knotproof(&[&["report", "--format", "json"], arguments].concat()).output().unwrap();
    assert_eq!(String::from_utf8_lossy(&output.stderr), "");
    let found: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(found["schema"], "knotproof.report/1");
    (output.status.code().unwrap(), found)
}

/// The message of a request that is refused: at once, before anything is judged.
fn refused(command: &mut Command, argument: &str) -> String {
    let output = command.args(["--format", "json"]).assert().code(2).stdout("").get_output().stderr.clone();
    let report: Value = serde_json::from_slice(&output).unwrap();
    assert_eq!(report["schema"], "knotproof.error/1");
    assert_eq!(report["error"]["argument"], argument, "{report}");
    report["error"]["message"].as_str().unwrap().to_owned()
}

#[test]
fn the_claims_asked_for_and_the_study_of_floats() {
    let (code, found) = report(&["--claim", "P3.2", "--claim", "T3.5.1"]);
    assert_eq!((code, &found["differences"]), (0, &Value::Array(Vec::new())));
    let claims = found["claims"].as_array().unwrap();
    assert_eq!(claims.len(), 2);
    let (support, independence) = (&claims[0], &claims[1]);

    assert_eq!((&support["id"], &support["locator"]), (&"T3.5.1".into(), &"Theorem 3.5 (1)".into()));
    let text = "For every U, every 0 ≤ i ≤ n and every real x, if x not in (t_i, t_{i+k+1}): G_i^k(x) = 0.";
    assert_eq!(support["statement"], text);
    let printed = &support["as_printed"];
    assert_eq!((&printed["status"], &printed["statement"]), (&"refuted".into(), &support["statement"]));
    assert!(printed.get("scope").is_none());
    // The smallest: degree 1, the fewest knots, and their smallest sum.
    let expected = serde_json::json!({
        "k": 1,
        "knots": ["0", "0", "1", "1"],
        "alpha": "-1",
        "given": [{"name": "i", "value": 0}, {"name": "x", "value": "0"}],
        "conclusion": 0,
        "claimed": "G_0^1(0) = 0",
        "shows": {"values": [{"term": "G_0^1(0)", "value": "1"}, {"term": "0", "value": "0"}]},
        "looked": [{"i": 0, "degree": 1, "order": 0, "x": "0", "left": false, "alpha": "-1"}],
    });
    assert_eq!(printed["witness"], expected);
    let amended = &support["amended"];
    assert_eq!((&amended["status"], &amended["scope"]), (&"proved".into(), &"degree".into()));
    assert_eq!(amended["certificate"], "T3.5.1.amended");
    assert_eq!(amended["checked_by"], serde_json::json!(["engine", "prover", "checker", "coq"]));
    assert_eq!(amended["theorems"][0]["name"], "T3_5_1_amended");
    assert_eq!(amended["degrees"], serde_json::json!([0, 1, 2, 3, 4, 5, 6, 7, 8]));
    assert_ne!(amended["statement"], support["statement"]);
    for count in ["instances", "small_cases", "facts"] {
        assert!(amended["rests_on"][count].as_u64().unwrap() > 100, "{count}");
    }

    assert_eq!(independence["as_printed"]["status"], "proved");
    assert!(independence.get("amended").is_none() && independence["as_printed"].get("witness").is_none());
    assert!(independence["statement"].as_str().unwrap().contains("every open U"));

    let float = found["float"].as_array().unwrap();
    let of = |name: &str| float.iter().filter(|drift| drift["instance"] == name).count();
    assert_eq!((of("U0"), of("U4"), of("S7")), (4 * 4, 4, 7), "every degree and index");
    for drift in float {
        assert!(drift["degree"].is_u64() && drift["alpha"].is_string());
        let [paper, ours] = drift["formulas"].as_array().unwrap().as_slice() else { panic!("{drift}") };
        assert_eq!((&paper["name"], &ours["name"]), (&"paper".into(), &"accurate".into()));
        let error = ours["max_ulp"].as_str().unwrap().parse::<f64>().unwrap();
        assert!(
            error <= ours["bound_ulp"].as_f64().unwrap() && ours["worst"]["reproduce"].is_string(),
            "{ours}"
        );
        assert!(paper.get("bound_ulp").is_none() && ours["sign_errors"] == 0 && ours["not_finite"] == 0);
    }
}

/// Each refutation has its cause and its severity; counts are of the paper and of our questions apart.
#[test]
fn the_summary_counts_the_paper_and_our_questions_apart() {
    let (_, found) =
        report(&["--claim", "P2.1.3", "--claim", "T3.5.1", "--claim", "R2.2.1", "--claim", "X.linear"]);
    let field = |id: &str, name: &str| {
        let claim = found["claims"].as_array().unwrap().iter().find(|claim| claim["id"] == id).unwrap();
        claim[name].as_str().map(str::to_owned)
    };
    for (id, source, severity, cause) in [
        ("P2.1.3", "paper", Some("hypothesis"), Some("outside-interval")),
        ("T3.5.1", "paper", Some("slip"), Some("end-points")),
        ("R2.2.1", "paper", None, None),
        ("X.linear", "question", Some("serious"), Some("conjecture")),
    ] {
        let expected = [Some(source), severity, cause].map(|word| word.map(str::to_owned));
        assert_eq!(["source", "severity", "cause"].map(|name| field(id, name)), expected, "{id}");
        assert_eq!(field(id, "severity_because").is_some(), severity.is_some());
    }
    let counts = |refuted: [usize; 4], causes: Value, statements: usize| {
        let [slip, hypothesis, reading, serious] = refuted;
        let all: usize = refuted.iter().sum();
        serde_json::json!({
            "statements": statements, "proved": statements - all, "refuted": all, "undecided": 0, "not-formal": 0,
            "in-every-degree": statements, "refutations": {
                "by_severity": {"hypothesis": hypothesis, "reading": reading, "serious": serious, "slip": slip},
                "by_cause": causes,
            },
        })
    };
    let expected = serde_json::json!({
        "paper": counts([1, 1, 0, 0], serde_json::json!({"end-points": 1, "outside-interval": 1}), 3),
        "questions": counts([0, 0, 0, 1], serde_json::json!({"conjecture": 1}), 1),
    });
    assert_eq!(found["summary"], expected);
    assert_eq!(found["paper"]["arxiv"], "1805.04433");
    assert!(found["dependence"].get("sentence").is_none(), "not all theorems were judged");
    let corner = &found["corners"][0];
    assert!(corner["turn"]["angle_degrees"].is_string() && corner["left"].is_array(), "{corner}");
}

/// What an author gets: at once, as text, JSON and Markdown, from the same data.
#[test]
fn errata_are_printed_without_judging() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("errata");
    let output =
        knotproof(&["report", "--errata", "--format", "json", "--out", out.to_str().unwrap()]).assert();
    let output = output.success().stderr("").get_output().stdout.clone();
    let found: Value = serde_json::from_slice(&output).unwrap();
    assert_eq!(found["schema"], "knotproof.errata/1");
    let file: Value = serde_json::from_str(&fs::read_to_string(out.join("errata.json")).unwrap()).unwrap();
    assert_eq!(file, found);
    let page = fs::read_to_string(out.join("errata.md")).unwrap();
    let text = knotproof(&["report", "--errata"]).assert().success().get_output().stdout.clone();
    let text = String::from_utf8(text).unwrap();
    let errata = found["errata"].as_array().unwrap();
    assert!(errata.len() >= 9, "{} causes", errata.len());
    for (number, one) in (1..).zip(errata) {
        for name in ["cause", "severity"] {
            assert!(one[name].is_string(), "{one}");
        }
        let line = text.lines().find(|line| line.starts_with(&format!("{number}. "))).unwrap();
        for locator in one["locators"].as_array().unwrap() {
            assert!(line.contains(locator.as_str().unwrap()), "{locator} in {line}");
        }
        assert!(!one["claims"].as_array().unwrap().is_empty() && one["amended"].is_array(), "{one}");
        assert!(text.contains(one["witness"]["text"].as_str().unwrap()));
        assert!(page.contains(&format!("## {number}. ")));
    }
    let files: Vec<_> = fs::read_dir(&out).unwrap().map(|entry| entry.unwrap().file_name()).collect();
    assert_eq!(files.len(), 2, "{files:?}");
    // Of one claim.
    let one = knotproof(&["report", "--errata", "--claim", "T3.5.1", "--format", "json"]).output().unwrap();
    let one: Value = serde_json::from_slice(&one.stdout).unwrap();
    assert_eq!(one["errata"][0]["claims"], serde_json::json!(["T3.5.1"]));
    let both = knotproof(&["report", "--errata", "--record"]).assert().code(2);
    assert!(String::from_utf8_lossy(&both.get_output().stderr).contains("cannot be used with"));
}

#[test]
fn a_question_is_reported_degree_by_degree() {
    let (code, found) = report(&["--claim", "X.linear"]);
    assert_eq!(code, 0, "a refuted claim that is recorded as refuted is no difference");
    let degrees = found["claims"][0]["by_degree"].as_array().unwrap();
    assert!(degrees.len() > 1);
    assert!(degrees.iter().all(|of| of["degree"].is_u64() && of["status"].is_string()));
}

#[test]
fn the_files_are_written_where_asked_for() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("not yet").join("there");
    let (code, found) = report(&["--claim", "P2.1.3", "--claim", "R2.2.1", "--out", out.to_str().unwrap()]);
    assert_eq!(code, 0);
    let json: Value = serde_json::from_str(&fs::read_to_string(out.join("report.json")).unwrap()).unwrap();
    assert_eq!(json, found, "the file is what is printed");
    let text = fs::read_to_string(out.join("report.md")).unwrap();
    assert!(text.starts_with("# "), "{text}");
    for part in
        ["| `P2.1.3` |", "### R2.2.1 (", "witness: ", "**As amended: proved (degree).**", "| U13 | 2 |"]
    {
        assert!(text.contains(part), "{part}");
    }
    assert!(!text.contains("T3.5.1"), "only what was asked for");
    let errata = fs::read_to_string(out.join("errata.md")).unwrap();
    assert!(errata.starts_with("# Errata") && errata.contains("Proposition 2.1 (3)"), "{errata}");
    // All that the page leads to is there.
    let page = fs::read_to_string(out.join("index.html")).unwrap();
    let links = page.split("href=\"").skip(1).map(|rest| rest.split('"').next().unwrap());
    let files: Vec<_> = links.filter(|link| !link.starts_with('#') && !link.contains(':')).collect();
    assert!(files.contains(&"errata.md") && files.contains(&"instance.schema.json"), "{files:?}");
    for file in files {
        assert!(out.join(file).exists(), "the page leads to {file}");
    }
    // Nothing here rests on anything else: there is nothing to draw.
    assert!(!out.join("dependence.svg").exists() && !page.contains("id=\"dependence\""));
}

#[test]
fn the_text_has_a_row_for_each_claim_and_the_counts() {
    let output = knotproof(&["report", "--claim", "P2.1.3", "--claim", "R2.2.1"]).assert().success();
    let output = output.stderr("").get_output().stdout.clone();
    let text = String::from_utf8(output).unwrap();
    assert!(!text.contains('\u{1b}'), "no escape sequences in a pipe");
    let row = |id: &str| {
        let row = text.lines().find(|line| line.trim_start().starts_with(id)).unwrap();
        row.split_whitespace().collect::<Vec<_>>().join(" ")
    };
    assert_eq!(row("claim"), "claim where as printed as amended statement");
    assert!(
        row("P2.1.3").starts_with(
            "P2.1.3 Proposition 2.1 (3) refuted (hypothesis) proved (degree) For all real a, b, "
        ),
        "{text}"
    );
    assert!(row("R2.2.1").starts_with("R2.2.1 Remark 2.2 (1) proved (degree) "), "{text}");
    assert!(text.find("P2.1.3 ").unwrap() < text.find("R2.2.1 ").unwrap(), "what is refuted stands first");
    for part in [
        "The paper, 2 statements: 1 proved, 1 refuted (1 hypothesis)",
        "As amended, where refuted: 1 proved.",
        "f64 against exact, ours: 0.",
        "Curves of the paper have corners",
    ] {
        assert!(text.contains(part), "{part} in {text}");
    }
    for part in ["Our questions", "No theorem"] {
        assert!(!text.contains(part), "nothing was judged of {part}");
    }
    assert!(text.ends_with("Every verdict is as recorded.\n"), "{text}");
    let text = knotproof(&["report", "--claim", "R2.2.1"]).assert().success().get_output().stdout.clone();
    assert!(!String::from_utf8(text).unwrap().contains("As amended"), "nothing is refuted");
}

fn written(path: &Path, baseline: &Baseline) {
    fs::write(path, serde_json::to_string(baseline).unwrap()).unwrap();
}

#[test]
fn a_verdict_that_is_not_as_recorded_is_exit_code_1() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("verdicts.json");
    let arguments = ["--claim", "P2.1.3", "--claim", "R2.2.1", "--baseline", path.to_str().unwrap()];
    let recorded = Baseline::recorded().unwrap();
    written(&path, &recorded);
    assert_eq!(report(&arguments).0, 0, "what the run leaves out is no difference");

    let mut altered = recorded.clone();
    let entry = altered.claims.iter_mut().find(|entry| entry.id == "P2.1.3").unwrap();
    entry.as_printed.witness = None;
    entry.as_printed.theorems.clear();
    (entry.as_printed.status, entry.as_printed.scope) = ("proved".to_owned(), Some("instance".to_owned()));
    altered.claims.retain(|entry| entry.id != "R2.2.1");
    written(&path, &altered);
    let (code, found) = report(&arguments);
    assert_eq!(code, 1);
    let differences = found["differences"].as_array().unwrap();
    assert_eq!(differences.len(), 2);
    assert_eq!((&differences[0]["id"], &differences[0]["of"]), (&"P2.1.3".into(), &"as printed".into()));
    assert_eq!(differences[0]["recorded"], "proved (instance)");
    let refuted = differences[0]["found"].as_str().unwrap();
    assert!(refuted.starts_with("refuted: α = -1, a = 0, b = 0, s = -1, c = 0, x = -1: "), "{refuted}");
    assert_eq!(
        (&differences[1]["id"], &differences[1]["recorded"]),
        (&"R2.2.1".into(), &"not recorded".into())
    );

    let output = knotproof(&[&["report"], &arguments[..]].concat()).assert().code(1).stderr("");
    let text = String::from_utf8(output.get_output().stdout.clone()).unwrap();
    let expected = format!(
        "Not as recorded: 2\n  P2.1.3, as printed:\n    recorded: proved (instance)\n    found:    {refuted}\n\
         \x20 R2.2.1, the claim:\n    recorded: not recorded\n    found:    judged\n"
    );
    assert!(text.ends_with(&expected), "{text}");
}

#[test]
fn a_baseline_that_is_none_is_refused_with_file_line_and_column() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("verdicts.json");
    let name = path.to_str().unwrap();
    let refusal = || refused(&mut knotproof(&["report", "--baseline", name]), "--baseline");
    assert!(refusal().contains("No such file"), "not there");
    let start = r#"{"schema": "knotproof.verdicts/2","#;
    for (content, parts) in [
        ("", &["line 1 column 0"][..]),
        ("{\n  \"schema\": oh,", &["line 2 column"]),
        ("{}", &["missing field `schema`", "line 1 column 2"]),
        (start, &["line 1 column 34"]),
        (&format!("{start}\n\"claims\": 7}}"), &["expected a list", "line 2 column"]),
        (&format!("{start}\n\"claims\": [],\n\"more\": 1}}"), &["unknown field `more`", "line 3 column"]),
        (
            &format!("{start}\n\"claims\": [{{\"id\": \"P3.2\"}}]}}"),
            &["missing field `locator`", "line 2 column"],
        ),
        (
            r#"{"schema": "knotproof.verdicts/0", "claims": []}"#,
            &["`knotproof.verdicts/0`", "reads `knotproof.verdicts/2`"],
        ),
        (
            r#"{"schema": "knotproof.report/1", "claims": [{"id": "P3.2"}], "float": []}"#,
            &["`knotproof.report/1`"],
        ),
    ] {
        fs::write(&path, content).unwrap();
        let message = refusal();
        assert!(message.starts_with(&format!("--baseline: {name}: ")), "{message}");
        for part in parts {
            assert!(message.contains(part), "{part} in {message}");
        }
    }
    fs::write(&path, b"\xff\xfe").unwrap();
    assert!(refusal().contains(name));
    refused(&mut knotproof(&["report", "--baseline", folder.path().to_str().unwrap()]), "--baseline");
}

/// An empty list of verdicts is not a list of no differences.
#[test]
fn an_empty_baseline_agrees_with_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("verdicts.json");
    written(&path, &Baseline::of(&[]));
    let (code, found) = report(&["--claim", "R2.2.1", "--baseline", path.to_str().unwrap()]);
    assert_eq!((code, &found["differences"][0]["recorded"]), (1, &"not recorded".into()));
}

#[test]
fn an_unknown_claim_is_refused() {
    let message = refused(&mut knotproof(&["report", "--claim", "P3.2", "--claim", "P3.3"]), "--claim");
    assert_eq!(message, "--claim: there is no claim `P3.3`; there are P3.3.1, P3.3.2");
}

#[test]
fn a_folder_that_cannot_be_made_is_refused_before_the_work() {
    let file = tempfile::NamedTempFile::new().unwrap();
    let path = file.path().to_str().unwrap();
    let message = refused(&mut knotproof(&["report", "--out", path]), "--out");
    assert!(message.starts_with(&format!("--out: cannot write {path}: ")), "{message}");
}

/// What `--record` needs is looked for first: nothing is judged, and nothing written.
#[test]
fn recording_needs_the_folders() {
    let folder = tempfile::tempdir().unwrap();
    let refusal = || refused(knotproof(&["report", "--record"]).current_dir(folder.path()), "--record");
    assert!(refusal().starts_with("--record: cannot write proofs: "), "no folder proofs");
    fs::create_dir(folder.path().join("proofs")).unwrap();
    assert!(refusal().starts_with("--record: cannot write docs: "), "no folder docs");
    assert_eq!(fs::read_dir(folder.path().join("proofs")).unwrap().count(), 0);
    fs::create_dir(folder.path().join("docs")).unwrap();
    assert!(refusal().starts_with("--record: cannot write proofs/theory: "), "no folder of theorems");
}

/// Verdicts on a part are no baseline.
#[test]
fn recording_a_part_is_refused() {
    for other in [["--claim", "P3.2"], ["--baseline", "verdicts.json"]] {
        let arguments = [&["report", "--record"], &other[..]].concat();
        let message = refused(&mut knotproof(&arguments), "--record");
        assert!(message.contains("cannot be used with"), "{message}");
    }
}

#[test]
fn help_has_an_example() {
    for command in ["check", "report"] {
        let output =
            knotproof(&[command, "--help"]).assert().success().stderr("").get_output().stdout.clone();
        let help = String::from_utf8(output).unwrap();
        assert!(help.contains("Example") && help.contains(&format!("knotproof {command} ")), "{help}");
    }
}
