//! `knotproof check --claim` and `--claims` as a user meets them: sentences of their own, on an instance and on all small
//! cases.

#![allow(clippy::unwrap_used, reason = "helpers of tests")]

use std::fs;
use std::path::Path;

use knotproof::judge::Witness;
use serde_json::{Value, json};

/// What comes of it in a folder: the exit code and both streams.
fn check_in(folder: &Path, arguments: &[&str]) -> (i32, String, String) {
    let mut command = crate::program();
    command.arg("check").args(arguments).current_dir(folder);
    let output = command.output().unwrap();
    let [stdout, stderr] = [output.stdout, output.stderr].map(|text| String::from_utf8(text).unwrap());
    (output.status.code().unwrap(), stdout, stderr)
}

fn check(arguments: &[&str]) -> (i32, String, String) {
    check_in(Path::new("."), arguments)
}

/// The exit code and the properties.
fn judged(arguments: &[&str]) -> (i32, Vec<Value>) {
    let (code, stdout, stderr) = check(&[&["--format", "json"], arguments].concat());
    assert_eq!(stderr, "");
    let found: Value = serde_json::from_str(&stdout).unwrap();
    assert_eq!(found["schema"], "knotproof.check/1");
    (code, found["properties"].as_array().unwrap().clone())
}

const INSTANCE: [&str; 6] = ["--degree", "2", "--knots", "0 0 0 1 2 2 2", "--alpha", "-1"];

/// One sentence on the instance.
fn on_instance(sentence: &str) -> (i32, Value) {
    let (code, mut properties) = judged(&[&INSTANCE[..], &["--claim", sentence]].concat());
    assert_eq!(properties.len(), 1);
    (code, properties.remove(0))
}

#[test]
fn on_an_instance_the_knots_are_understood() {
    let sentence = "i in 0..n; x in [t[0], t[m]] : G[i](x) <= 1";
    let expected = json!({
        "id": "claim",
        "alpha": "-1",
        "form": "printed",
        "statement": "For every U, every 0 ≤ i ≤ n and every x in [t_0, t_m]: G_i^k(x) ≤ 1.",
        "status": "proved",
        "scope": "instance",
        "degrees": [2],
        "checked_by": ["engine"],
    });
    assert_eq!(on_instance(sentence), (0, expected.clone()));
    assert_eq!(on_instance(&format!("k; U; {sentence}")), (0, expected));
    // What the instance is not gets no verdict.
    let (code, open) = on_instance(&format!("k >= 3; U; {sentence}"));
    assert_eq!(
        (code, &open["status"], &open["reason"]),
        (0, &json!("not-applicable"), &json!("said only of k ≥ 3"))
    );
    // A sentence about the weight says nothing of knots.
    let (code, weight) = on_instance("x in [0, 1) : phi(x, 0, 1) < 1");
    assert_eq!((code, &weight["statement"]), (0, &json!("For every x in [0, 1): φ_α(x, 0, 1) < 1.")));
}

#[test]
fn a_refuted_one_has_a_witness() {
    // G_0(1/2) = (1 − φ_{−1}(1/2, 0, 1))² and φ_{−1}(1/2, 0, 1) = (1/2)/(1/2 + 2·1/2) = 1/3.
    let (code, found) = on_instance("| alpha = -1 : G[0](1/2) = 1/4");
    assert_eq!((code, &found["status"]), (1, &json!("refuted")));
    let witness: Witness = serde_json::from_value(found["witness"].clone()).unwrap();
    assert_eq!((&*witness.claimed, &*witness.found()), ("G_0^2(1/2) = 1/4", "G_0^2(1/2) = 4/9"));
}

#[test]
fn undecided_is_an_exit_code_of_its_own() {
    let (code, found) = on_instance("d points; x in [t[0], t[m]] : sum(i in 0..n: d[i]^2*G[i](x)) >= 0");
    assert_eq!((code, &found["status"]), (3, &json!("undecided")));
    assert!(found["reason"].as_str().unwrap().contains("no counterexample among"), "{found}");
    // Of two the worse counts.
    let folder = tempfile::tempdir().unwrap();
    let claim = |id: &str, then: &str| {
        format!(
            "[[claim]]\nid = \"{id}\"\nat = \"\"\ntitle = \"\"\nfor = \"k; U; d points\"\nthen = [\"{then}\"]\n"
        )
    };
    let text = claim("open", "d[0]^2 >= 0") + &claim("wrong", "d[0] = 0");
    fs::write(folder.path().join("two.toml"), text).unwrap();
    let (code, text, _) = check_in(folder.path(), &[&INSTANCE[..], &["--claims", "two.toml"]].concat());
    assert_eq!(code, 1, "{text}");
    assert!(text.ends_with("\n1 undecided, 1 refuted\n"), "{text}");
}

#[test]
fn without_an_instance_all_small_cases_are_judged() {
    let (code, found) = judged(&["--claim", "k in 1..1; U; i in 0..n; x in [t[0], t[m]] : G[i](x) <= 1"]);
    assert_eq!((code, &found[0]["status"], &found[0]["degrees"]), (0, &json!("proved"), &json!([1])));
    assert_eq!(found[0].get("alpha"), None, "many of them");
    let wrong = "k in 1..1; U; i in 0..n; x in [t[0], t[m]] : G[i](x) < 1";
    let (code, found) = judged(&["--claim", wrong]);
    assert_eq!((code, &found[0]["status"]), (1, &json!("refuted")));
    // The smallest case comes first.
    let witness: Witness = serde_json::from_value(found[0]["witness"].clone()).unwrap();
    assert_eq!((witness.k, witness.knots.len(), witness.alpha.as_str()), (Some(1), 4, "-1"));
    let (code, text, _) = check(&["--claim", wrong]);
    let expected = "\
On all small cases and the paper's examples, for every x:
  claim                      refuted
      For k = 1, every U, every 0 ≤ i ≤ n and every x in [t_0, t_m]: G_i^k(x) < 1.
      at k = 1, U = (0, 0, 1, 1), α = -1, i = 0, x = 0: it says G_0^1(0) < 1; but G_0^1(0) = 1

1 refuted
";
    assert_eq!((code, &*text), (1, expected));
}

const FILE: &str = r#"
title = "Two claims"
[define]
"C(x)" = "sum(i in 0..n: d[i]*G[i](x))"
[[claim]]
id = "unity"
at = "mine"
title = "Partition of unity"
for = "k; U; x in [t[0], t[m]]"
then = ["sum(i in 0..n: G[i](x)) = 1"]
cause = "end-points"
[claim.amended]
for = "k; U; x in [t[k], t[n+1])"
[[claim]]
id = "positive"
at = "mine"
title = "Where T3.5.2 holds, the curve of positive values is positive"
for = "k; U open; d points; x in [t[0], t[m]]"
if = ["claim(T3.5.2)", "claim(unity)", "all(i in 0..n: d[i] = 1)"]
then = ["C(x) = 1"]
"#;

#[test]
fn a_file_has_several_claims_that_name_each_other_and_the_papers() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("mine.toml"), FILE).unwrap();
    let run = |knots: &str, more: &[&str]| {
        let on =
            ["--degree", "1", "--knots", knots, "--alpha", "2", "--claims", "mine.toml", "--format", "json"];
        let (code, stdout, stderr) = check_in(folder.path(), &[&on[..], more].concat());
        assert_eq!(stderr, "");
        let found: Value = serde_json::from_str(&stdout).unwrap();
        (code, found["properties"].clone())
    };
    // Not open: a function is missing at both ends.
    let (code, found) = run("0 1 2 3", &[]);
    assert_eq!((code, &found[0]["id"], &found[0]["status"]), (1, &json!("unity"), &json!("refuted")));
    assert_eq!(found[0]["amended"]["status"], "proved");
    assert_eq!(
        (&found[1]["status"], &found[1]["reason"]),
        (&json!("not-applicable"), &json!("said only of open U"))
    );
    let (code, amended) = run("0 1 2 3", &["--amended"]);
    assert_eq!((code, &amended[0]["form"], &amended[0]["status"]), (0, &json!("amended"), &json!("proved")));
    let (_, open) = run("0 0 1 1", &[]);
    assert_eq!(open[0]["status"], "proved");
    assert!(["proved", "undecided"].map(Value::from).contains(&open[1]["status"]), "{open}");
}

/// Places are said, in a file as in a line.
#[test]
fn what_cannot_be_read_is_refused_with_its_place() {
    let run = |sentence: &str| check(&[&INSTANCE[..], &["--claim", sentence]].concat());
    let (code, stdout, stderr) = run("i in 0..n; x in [t[0], t[m] : G[i](x) <= 1");
    let expected = "\
error: --claim: sentence, line 1, column 29: expected `)`, found `:`; close the bracket that is opened at character 17
  |
1 | i in 0..n; x in [t[0], t[m] : G[i](x) <= 1
  |                             ^
";
    assert_eq!((code, &*stdout, &*stderr), (2, "", expected));
    for (sentence, rule, advice) in [
        ("i in 0..n : G[i](x) = 0", "nothing is called `x`", "bind it"),
        ("k; U; i in 0..n : t[j] = 0", "nothing is called `j`", "bind it"),
        ("x : claim(T3.5.9)", "no claim is called `T3.5.9`", "did you mean"),
        ("U in {U77} : k = 2", "no instance", ""),
        ("i in 0..n : G[i](1) ≤ 1", "`≤`", "write `<=`"),
        ("", "expected", ""),
        ("\u{1b}[31m", "", ""),
    ] {
        let (code, stdout, stderr) = run(sentence);
        assert_eq!((code, &*stdout), (2, ""), "{sentence}: {stderr}");
        assert!(stderr.contains(rule) && stderr.contains(advice), "{sentence}: {stderr}");
        assert!(!stderr.contains('\u{1b}'), "nothing that a terminal obeys");
        assert!(stderr.lines().any(|line| line.trim_start_matches([' ', '|']).starts_with('^')), "{stderr}");
    }
    // Without an instance there are no knots to speak of.
    let (code, _, stderr) = check(&["--claim", "i in 0..n : t[i] = 0"]);
    assert_eq!(code, 2);
    assert!(stderr.contains("`n` needs knots; bind them in `for`: `k; U`"), "{stderr}");
}

#[test]
fn as_json_all_that_is_wrong_has_its_place() {
    let folder = tempfile::tempdir().unwrap();
    let text = FILE.replace("= 1\"]", "= uno\"]").replace("d points", "d pionts");
    fs::write(folder.path().join("wrong.toml"), &text).unwrap();
    let run =
        |more: &[&str]| check_in(folder.path(), &[&INSTANCE[..], &["--claims", "wrong.toml"], more].concat());
    let (code, stdout, stderr) = run(&["--format", "json"]);
    assert_eq!((code, &*stdout, stderr.lines().count()), (2, "", 1));
    let report: Value = serde_json::from_str(&stderr).unwrap();
    assert_eq!(
        (&report["schema"], &report["error"]["argument"]),
        (&json!("knotproof.error/1"), &json!("--claims"))
    );
    let message = report["error"]["message"].as_str().unwrap();
    assert!(
        message.starts_with("--claims: wrong.toml, line 10, column 36: nothing is called `uno` here; "),
        "{message}"
    );
    assert!(message.ends_with(" (the first of 2)"), "{message}");
    let complaints = report["error"]["complaints"].as_array().unwrap();
    assert_eq!(complaints.len(), 2);
    for complaint in complaints {
        assert_eq!(complaint["source"], "wrong.toml");
        let place = |name: &str| usize::try_from(complaint[name].as_u64().unwrap()).unwrap();
        let line = text.lines().nth(place("line") - 1).unwrap();
        let rest: String = line.chars().skip(place("column") - 1).collect();
        assert!(rest.starts_with("uno") || rest.starts_with("pionts"), "{complaint}");
    }
    // For people: each with its line.
    let (_, _, stderr) = run(&[]);
    assert_eq!(stderr.matches("wrong.toml, line ").count(), 2, "{stderr}");
    assert!(stderr.contains("\n   |\n10 | then = [\"sum(i in 0..n: G[i](x)) = uno\"]\n   |"), "{stderr}");
    assert!(stderr.contains("did you mean") || stderr.contains("write `points`"), "{stderr}");
}

#[test]
fn files_that_are_none_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let write = |name: &str, text: &str| fs::write(folder.path().join(name), text).unwrap();
    write("broken.toml", "[[claim]\n");
    write("key.toml", "[[claim]]\nid = \"a\"\nat = \"\"\ntitel = \"\"\n");
    write("empty.toml", "[[claim]]\nid = \"a\"\nat = \"\"\ntitle = \"\"\n");
    for (file, part) in [
        ("broken.toml", "line 1"),
        ("key.toml", "did you mean `title`?"),
        ("empty.toml", "nothing is said; add `then`"),
        ("missing.toml", "cannot read missing.toml"),
    ] {
        let (code, stdout, stderr) = check_in(folder.path(), &["--claims", file]);
        assert_eq!((code, &*stdout), (2, ""), "{file}");
        assert!(stderr.starts_with("error: --claims: ") && stderr.contains(part), "{stderr}");
    }
}

#[test]
fn deep_brackets_are_refused_and_nothing_crashes() {
    for (open, close) in [("(", ")"), ("abs(", ")"), ("not (", ")"), ("-", "")] {
        let sentence = format!("x : {}x{} = 1", open.repeat(1000), close.repeat(1000));
        let (code, stdout, stderr) = check(&["--claim", &sentence]);
        assert_eq!((code, &*stdout), (2, ""), "{open}: {stderr}");
        assert!(stderr.contains("nested"), "{open}: {stderr}");
        assert!(
            stderr.lines().all(|line| line.chars().count() < 400),
            "a long line is shown in part: {stderr}"
        );
    }
}

#[test]
fn one_thing_is_asked_for() {
    for more in [
        &["--property", "T3.5.2"][..],
        &["--claims", "mine.toml"],
        &["--all"],
        &["--baseline"],
        &["--amended"],
    ] {
        let arguments = [&INSTANCE[..], &["--claim", "x : x = x", "--format", "json"], more].concat();
        let (code, stdout, stderr) = check(&arguments);
        assert_eq!((code, &*stdout), (2, ""), "{more:?}");
        let report: Value = serde_json::from_str(&stderr).unwrap();
        assert!(report["error"]["message"].as_str().unwrap().contains("cannot be used with"), "{report}");
    }
}
