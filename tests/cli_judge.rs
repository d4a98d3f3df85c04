//! `new` and `judge`: a folder works at once, what is wrong with one is said in its place, and the textbook's verdicts are these.

#![allow(clippy::unwrap_used, reason = "helpers of tests")]

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use serde_json::Value;

/// What a command comes to: exit code, standard output, standard error.
fn run(folder: &Path, arguments: &[&str]) -> (i32, String, String) {
    let mut command = crate::program();
    command.args(arguments).current_dir(folder);
    let output = command.output().unwrap();
    let [stdout, stderr] = [output.stdout, output.stderr].map(|text| String::from_utf8(text).unwrap());
    (output.status.code().unwrap(), stdout, stderr)
}

fn json(folder: &Path, arguments: &[&str]) -> (i32, Value) {
    let (code, stdout, stderr) = run(folder, &[arguments, &["--format", "json"]].concat());
    (code, serde_json::from_str(if code == 2 { &stderr } else { &stdout }).unwrap())
}

/// A folder with the one that `new` writes in it.
fn started() -> tempfile::TempDir {
    let place = tempfile::tempdir().unwrap();
    assert_eq!(run(place.path(), &["new", "mine", "--title", "On \"splines\""]).0, 0);
    place
}

/// Of each claim the verdict as printed and as amended.
fn verdicts(report: &Value) -> BTreeMap<String, (String, Option<String>)> {
    let verdict = |claim: &Value| {
        let text = |value: &Value| value.as_str().unwrap().to_owned();
        let amended = claim.get("amended").map(|amended| text(&amended["status"]));
        (text(&claim["id"]), (text(&claim["as_printed"]["status"]), amended))
    };
    report["claims"].as_array().unwrap().iter().map(verdict).collect()
}

/// Every way from one folder to another: names of files with their texts.
fn files(folder: &Path) -> BTreeMap<String, String> {
    let mut found = BTreeMap::new();
    for entry in fs::read_dir(folder).unwrap().map(Result::unwrap) {
        let name = entry.file_name().into_string().unwrap();
        if entry.file_type().unwrap().is_dir() {
            found.extend(
                files(&entry.path()).into_iter().map(|(below, text)| (format!("{name}/{below}"), text)),
            );
        } else {
            found.insert(name, fs::read_to_string(entry.path()).unwrap());
        }
    }
    found
}

#[test]
fn a_new_folder_is_judged() {
    let place = started();
    let (code, text, _) = run(place.path(), &["judge", "mine", "--out", "report"]);
    assert_eq!(code, 1, "P2 is false as printed: {text}");
    for part in [
        "“On \"splines\"”.",
        "The paper, 4 statements: 3 proved, 1 refuted (1 hypothesis)",
        "P2: k = 1, U = (0, 0, 1, 2), α = -1, x = 3/2: the claim says",
        "again: knotproof eval --degree 1 --knots 0,0,1,2 --alpha -1 --x 3/2",
        "Written: report/index.html",
    ] {
        assert!(text.contains(part), "{part} in {text}");
    }
    let (_, report) = json(place.path(), &["judge", "mine"]);
    let proved = |amended: Option<&str>| ("proved".to_owned(), amended.map(str::to_owned));
    let refuted = ("refuted".to_owned(), Some("proved".to_owned()));
    let expected = [("C4", proved(None)), ("P1", proved(None)), ("P2", refuted), ("P3", proved(None))];
    assert_eq!(verdicts(&report), expected.map(|(id, verdict)| (id.to_owned(), verdict)).into());
    let p2 = report["claims"].as_array().unwrap().iter().find(|claim| claim["id"] == "P2").unwrap();
    assert_eq!(p2["fails"]["status"], "proved", "the amendment is sharp");
    assert_eq!(
        (&report["paper"]["title"], &report["paper"]["family"]),
        (&"On \"splines\"".into(), &"mobius".into())
    );
    // What is written is what is printed, and every file of the report is there.
    let written = files(&place.path().join("report"));
    assert_eq!(serde_json::from_str::<Value>(&written["report.json"]).unwrap(), report);
    let names: Vec<_> = written.keys().map(String::as_str).collect();
    let expected = [
        "E1-2-curve.svg",
        "E1-2.svg",
        // What follows from the sentences alone is certified, and so is what their witnesses refute.
        "certs/C4.printed.proof",
        "certs/C4.printed.statement",
        "certs/P1.printed.proof",
        "certs/P1.printed.statement",
        "certs/P2.printed.proof",
        "certs/P2.printed.statement",
        "dependence.svg",
        "errata.md",
        "index.html",
        "instance.schema.json",
        "report.json",
        "report.md",
    ];
    assert_eq!(names, expected);
    let (page, text) = (&written["index.html"], &written["report.md"]);
    assert!(page.contains("<title>Verdicts on “On &#34;splines&#34;”</title>"), "the title");
    assert!(page.contains("E1 (Fig. 1), degree 2") && page.matches("<svg").count() >= 5, "pictures of E1");
    for absent in ["arxiv", "Conjecture 3.1", "src=\"http", "Related:"] {
        assert!(!page.contains(absent), "{absent}");
    }
    assert!(text.contains("- again: `knotproof eval --degree 1") && !text.contains("f64 against exact"));
    assert!(written["errata.md"].contains("“On \"splines\"”. 1 statement fails as printed, by 1 cause."));
}

#[test]
fn a_folder_is_written_once_and_in_a_family_that_is_known() {
    let place = started();
    let before = files(&place.path().join("mine"));
    let (code, stdout, stderr) = run(place.path(), &["new", "mine"]);
    assert_eq!((code, &*stdout), (2, ""));
    assert!(stderr.contains("FOLDER") && stderr.contains("not empty; name a folder"), "{stderr}");
    assert_eq!(files(&place.path().join("mine")), before);
    let (code, _, stderr) = run(place.path(), &["new", "other", "--family", "mobus"]);
    assert!(code == 2 && stderr.contains("there are classical, free-ratios, "), "{stderr}");
    assert!(!place.path().join("other").exists());
    fs::create_dir(place.path().join("empty")).unwrap();
    assert_eq!(run(place.path(), &["new", "empty", "--family", "classical"]).0, 0);
    let (code, report) = json(place.path(), &["judge", "empty"]);
    assert_eq!((code, &report["paper"]["family"]), (1, &"classical".into()));
    assert_eq!(verdicts(&report).values().filter(|(printed, _)| printed == "proved").count(), 3);
    let witness = &report["claims"][1]["as_printed"]["witness"];
    assert_eq!((&witness["alpha"], &report["claims"][1]["id"]), (&"inf".into(), &"P2".into()));
    // A title can be anything.
    for title in ["", "\\ \u{7f}\t'''", "{family}"] {
        let folder = format!("title-{}", title.len());
        assert_eq!(run(place.path(), &["new", &folder, "--title", title]).0, 0);
        let (code, report) = json(place.path(), &["judge", &folder, "--claim", "P1"]);
        assert_eq!((code, report["paper"]["title"].as_str()), (0, Some(title)));
    }
}

/// What is changed in a folder.
enum Change {
    /// In this file, this, to that.
    Text(&'static str, &'static str, &'static str),
    /// This file, with this text.
    File(&'static str, &'static str),
    /// This file is gone.
    Gone(&'static str),
    /// A folder of this name.
    Folder(&'static str),
}

use Change::{File, Folder, Gone, Text};

const PAPER: &str = "paper.toml";
const CLAIMS: &str = "claims/01-basis.toml";
const INSTANCES: &str = "instances.toml";

/// What is wrong: the change, the file that is to blame, its line, what is underlined, the rule, and what to do.
type Fault = (Change, &'static str, usize, &'static str, &'static str, &'static str);

const FAULTS: &[Fault] = &[
    (Gone(PAPER), PAPER, 1, "", "there is no paper.toml", "knotproof new"),
    (File(PAPER, "title = \"x\"\nclaims = [\n"), PAPER, 2, "", "array", "toml.io"),
    (
        Text(PAPER, "family = ", "famly = "),
        PAPER,
        13,
        "famly",
        "unknown field `famly`",
        "did you mean `family`?",
    ),
    (Text(PAPER, "title = ", "# "), PAPER, 1, "", "missing field `title`", "add `title"),
    (
        Text(PAPER, "\"mobius\"\n", "\"mobus\"\n"),
        PAPER,
        13,
        "\"mobus\"",
        "no family is called `mobus`",
        "did you mean `mobius`?",
    ),
    (
        Text(PAPER, "\"mobius\"\n", "\"bezier\"\n"),
        PAPER,
        13,
        "\"bezier\"",
        "no family is called `bezier`",
        "write one of classical, free-ratios",
    ),
    (
        Text(PAPER, "\"mobius\"\n", "\"classical\"\n"),
        INSTANCES,
        11,
        "\"-1 2 inf\"",
        "has no index but ∞",
        "write `inf`",
    ),
    (
        Text(PAPER, "[\"01-basis\"]", "[\"01-basis\", \"01-bases\"]"),
        PAPER,
        16,
        "\"01-bases\"",
        "there is no claims/01-bases.toml",
        "did you mean `01-basis`?",
    ),
    (
        Text(PAPER, "[\"01-basis\"]", "[\"01-basis\", \"01-basis\"]"),
        PAPER,
        16,
        "\"01-basis\"",
        "listed twice",
        "once",
    ),
    (Text(PAPER, "[\"01-basis\"]", "[]"), PAPER, 16, "[]", "no file of claims is listed", "list one"),
    (
        File("claims/02-more.toml", ""),
        PAPER,
        16,
        "[\"01-basis\"]",
        "nothing names claims/02-more.toml",
        "name it under `claims`",
    ),
    (File("cases.toml", ""), PAPER, 16, "[\"01-basis\"]", "nothing names cases.toml", "move it away"),
    (Gone(CLAIMS), PAPER, 16, "\"01-basis\"", "there is no claims/01-basis.toml", "write it"),
    (File(CLAIMS, "[[claim]\n"), CLAIMS, 1, "", "", "toml.io"),
    (Folder("claims/02.toml"), "claims/02.toml", 1, "", "this is no file", "move it away"),
    (
        Text(CLAIMS, "id = \"P2\"", "id = \"P1\""),
        CLAIMS,
        17,
        "\"P1\"",
        "two claims have this identifier",
        "another",
    ),
    (Text(CLAIMS, "id = \"P2\"", "id = \"P 2\""), CLAIMS, 17, "\"P 2\"", "letters, digits", "T3.5.3"),
    (
        Text(CLAIMS, "[[claim.uses]]\nid = \"P3\"", "[[claim.uses]]\nid = \"P33\""),
        CLAIMS,
        53,
        "\"P33\"",
        "no claim is called `P33`",
        "did you mean `P3`?",
    ),
    (
        Text(CLAIMS, "[[claim.uses]]\nid = \"P3\"", "[[claim.uses]]\nid = \"C4\""),
        CLAIMS,
        53,
        "\"C4\"",
        "a circle",
        "drop one",
    ),
    (Text(CLAIMS, "G[i](x) > 0", "G[i](y) > 0"), CLAIMS, 13, "y", "nothing is called `y`", "bind it"),
    (Text(CLAIMS, "for = \"k; U; i", "for = \"k; V; i"), CLAIMS, 12, "", "", ""),
    (
        Text(CLAIMS, "\"end-points\"", "\"endpoints\""),
        CLAIMS,
        23,
        "\"endpoints\"",
        "no cause is called `endpoints`",
        "did you mean `end-points`?",
    ),
    (Text(CLAIMS, "then = [\"G[i](x) > 0\"]", ""), CLAIMS, 6, "[[claim]]", "nothing is said", "add `then`"),
    (
        Text(CLAIMS, "then = [\"G[i](x) > 0\"]", "then = []"),
        CLAIMS,
        13,
        "[]",
        "nothing follows",
        "give a conclusion",
    ),
    (
        Text(CLAIMS, "title = \"Positivity\"", "titel = \"Positivity\""),
        CLAIMS,
        11,
        "titel",
        "unknown field `titel`",
        "did you mean `title`?",
    ),
    (
        Text(CLAIMS, "cause = \"end-points\"", "cases = \"found.toml\""),
        CLAIMS,
        23,
        "\"found.toml\"",
        "there is no file found.toml",
        "write it",
    ),
    (
        Text(CLAIMS, "k; U clamped\"", "k; U in {E2}\""),
        CLAIMS,
        41,
        "E2",
        "no instance is called `E2`",
        "did you mean `E1`?",
    ),
    (
        Text(INSTANCES, "degree = 2", "degree = 20"),
        INSTANCES,
        9,
        "\"0 0 0 1 2 2 2\"",
        "at least 41 knots",
        "a lower degree",
    ),
    (Text(INSTANCES, "degree = 2", "degree = -2"), INSTANCES, 8, "-2", "invalid value", ""),
    (
        Text(INSTANCES, "0 0 0 1 2 2 2", "0 0 0 2 1 2 2"),
        INSTANCES,
        9,
        "\"0 0 0 2 1 2 2\"",
        "must not decrease",
        "t_0 ≤ … ≤ t_m",
    ),
    (
        Text(INSTANCES, "0 0 0 1 2 2 2", "0 0 0 one 2 2 2"),
        INSTANCES,
        9,
        "\"0 0 0 one 2 2 2\"",
        "`one` is not a number",
        "exact numbers",
    ),
    (
        Text(INSTANCES, "-1 2 inf", "-1 1/2 inf"),
        INSTANCES,
        11,
        "\"-1 1/2 inf\"",
        "less than 0 or greater than 1",
        "another",
    ),
    (Text(INSTANCES, "-1 2 inf", ""), INSTANCES, 11, "\"\"", "there is no index", "-1 2 inf"),
    (Text(INSTANCES, " 4,0", ""), INSTANCES, 13, "\"0,0 1,2 3,2\"", "takes 4 control points", "d_n"),
    (
        Text(INSTANCES, "4,0", "4,0,0"),
        INSTANCES,
        13,
        "\"0,0 1,2 3,2 4,0,0\"",
        "curves lie in the plane",
        "comma",
    ),
    (
        Text(INSTANCES, "\"E1\"", "\"../E1\""),
        INSTANCES,
        5,
        "\"../E1\"",
        "no name of an instance",
        "letters, digits",
    ),
    (Text(INSTANCES, "name = \"E1\"\n", ""), INSTANCES, 8, "\"0 0 0 1 2 2 2\"", "has no name", "add `name"),
    (File("windows.toml", "[[window]]\nclaim = 1\n"), "windows.toml", 2, "1", "invalid type", "[[window]]"),
];

/// Each fault is found where it is, with what to do, and nothing is judged.
#[test]
fn what_is_wrong_with_a_folder_is_said_in_its_place() {
    assert!(FAULTS.len() >= 20);
    let mut missed = Vec::new();
    for (change, file, line, underlined, rule, advice) in FAULTS {
        let place = started();
        let folder = place.path().join("mine");
        match change {
            Text(file, part, instead) => {
                let text = fs::read_to_string(folder.join(file)).unwrap();
                assert!(text.contains(part), "{part} in {file}");
                fs::write(folder.join(file), text.replacen(part, instead, 1)).unwrap();
            }
            File(file, text) => fs::write(folder.join(file), text).unwrap(),
            Gone(file) => fs::remove_file(folder.join(file)).unwrap(),
            Folder(name) => fs::create_dir(folder.join(name)).unwrap(),
        }
        let (code, stdout, stderr) = run(place.path(), &["judge", "mine", "--format", "json"]);
        assert_eq!((code, &*stdout), (2, ""), "{rule}");
        let error: Value = serde_json::from_str(&stderr).unwrap();
        assert_eq!(error["error"]["argument"], "FOLDER");
        let complaints = error["error"]["complaints"].as_array().unwrap();
        let told = complaints.iter().any(|complaint| {
            let text = |name: &str| complaint[name].as_str().unwrap();
            complaint["source"] == format!("mine/{file}")
                && complaint["line"] == *line
                && text("rule").contains(rule)
                && text("advice").contains(advice)
                && !text("advice").is_empty()
        });
        if !told {
            missed.push(format!("{file}, line {line}: {rule}; {advice}\n{error:#}"));
        }
        // For people: the place is underlined.
        let (code, _, text) = run(place.path(), &["judge", "mine"]);
        assert_eq!(code, 2);
        let marks = "^".repeat(underlined.chars().count().max(1));
        assert!(text.contains(&marks) && text.contains(underlined), "{underlined}: {text}");
    }
    assert!(missed.is_empty(), "{}", missed.join("\n"));
}

/// Of several faults every one is told at once.
#[test]
fn all_that_is_wrong_is_said_at_once() {
    let place = started();
    let folder = place.path().join("mine");
    let change = |file: &str, part: &str, instead: &str| {
        let text = fs::read_to_string(folder.join(file)).unwrap();
        fs::write(folder.join(file), text.replacen(part, instead, 1)).unwrap();
    };
    change(PAPER, "\"mobius\"\n", "\"mobus\"\n");
    change(CLAIMS, "G[i](x) > 0", "G[i](y) > 0");
    change(CLAIMS, "G[n](t[m]) = 1", "G[n](t[m]) = uno");
    change(INSTANCES, "4,0", "4,0,0");
    fs::write(folder.join("claims/02-more.toml"), [0xff]).unwrap();
    let (code, error) = json(place.path(), &["judge", "mine"]);
    let complaints = error["error"]["complaints"].as_array().unwrap();
    let rules: Vec<_> = complaints.iter().map(|complaint| complaint["rule"].as_str().unwrap()).collect();
    assert_eq!(code, 2);
    for part in ["`mobus`", "`y`", "`uno`", "in the plane", "not UTF-8"] {
        assert_eq!(rules.iter().filter(|rule| rule.contains(part)).count(), 1, "{part} in {rules:#?}");
    }
}

#[test]
fn folders_and_names_that_are_none_are_refused() {
    let place = started();
    for (arguments, part) in [
        (&["judge", "nowhere"][..], "there are classical, knot-weights, pq, rational-bsplines"),
        (&["judge", "mine/paper.toml"], "it is a file; name the folder"),
        (&["judge", "mine", "--claim", "P9"], "there is no claim `P9`; there are P1, P2, P3"),
        (&["judge", "mine", "--degrees", "3..1"], "`3..1` is no range of degrees"),
        (&["judge", "mine", "--degrees", "x"], "`x` is no range of degrees"),
        (&["judge", "mine", "--out", "mine/paper.toml"], "it is a file; name a folder"),
        (&["check", "--paper", "nowhere", "--instance", "E1"], "there is no folder `nowhere`"),
        (&["check", "--paper", "mine", "--instance", "U4"], "`U4` is no instance of the paper (E1)"),
        (&["check", "--paper", "classical", "--instance", "Cubic", "--alpha", "-1"], "has no index -1"),
        (&["prove", "--paper", "mine", "--claim", "T3.5.2", "--out", "x"], "there is no claim `T3.5.2`"),
    ] {
        let (code, stdout, stderr) = run(place.path(), arguments);
        assert_eq!((code, &*stdout), (2, ""), "{arguments:?}");
        assert!(stderr.contains(part), "{arguments:?}: {stderr}");
    }
}

/// The folder of the clone, its name, and `report` come to the same; degrees and claims are chosen.
#[test]
fn a_name_is_the_paper_that_comes_with_the_program() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let chosen = ["--claim", "P2.1.1", "--claim", "T3.5.3"];
    let claims = |arguments: &[&str]| {
        let (code, report) = json(root, &[arguments, &chosen].concat());
        (code, report["claims"].clone(), report["paper"].clone())
    };
    let (code, named, about) = claims(&["judge", "rational-bsplines"]);
    assert_eq!(code, 1, "T3.5.3 is refuted as printed");
    assert_eq!(claims(&["judge", "papers/rational-bsplines"]), (1, named.clone(), about));
    let recorded = fs::read_to_string(root.join("proofs/verdicts.json")).unwrap();
    let recorded: Value = serde_json::from_str(&recorded).unwrap();
    for claim in named.as_array().unwrap() {
        let entry =
            recorded["claims"].as_array().unwrap().iter().find(|entry| entry["id"] == claim["id"]).unwrap();
        for key in ["status", "scope", "degrees", "witness", "certificate"] {
            assert_eq!(
                claim["as_printed"][key], entry["as_printed"][key],
                "{}, {key}: as recorded",
                claim["id"]
            );
        }
    }
    assert_eq!(named[0]["as_printed"]["certificate"], "P2.1.1.printed");
    let (code, cut, _) = claims(&["judge", "rational-bsplines", "--degrees", "2..3"]);
    assert_eq!((code, &cut[1]["as_printed"]["witness"]["k"]), (1, &2.into()));
    let amended = &cut[1]["amended"];
    assert_eq!((&amended["scope"], &amended["degrees"]), (&"instance".into(), &serde_json::json!([2, 3])));
    assert_eq!(json(root, &["judge", "rational-bsplines", "--claim", "P2.1.1"]).0, 0);
}

/// Windows beside the claims make certificates; others' claims of the same name have nothing of them.
#[test]
fn windows_of_a_folder_are_proved_and_written() {
    let place = started();
    let folder = place.path().join("mine");
    // In how many degrees the paper's own claim of this name is proved is said for that one, and not for this.
    let text = fs::read_to_string(folder.join(CLAIMS)).unwrap();
    fs::write(folder.join(CLAIMS), text.replacen("id = \"P1\"", "id = \"T3.5.2\"", 1)).unwrap();
    let (code, report) = json(place.path(), &["judge", "mine", "--claim", "T3.5.2", "--out", "report"]);
    let printed = &report["claims"][0]["as_printed"];
    // It is the same sentence about the same weights, so that the theorem about it is one about this.
    assert_eq!((code, &printed["scope"]), (0, &"degree".into()));
    assert!(printed["degrees"].as_array().unwrap().len() <= 4, "{printed}");
    // With them it is proved in as many, and the checker accepts what is written.
    let shipped = Path::new(env!("CARGO_MANIFEST_DIR")).join("papers/rational-bsplines/windows.toml");
    let all = fs::read_to_string(shipped).unwrap();
    let own = all.split("[[window]]").filter(|entry| entry.contains("\nclaim = \"T3.5.2\"\n"));
    let own: String = own.map(|entry| format!("[[window]]{entry}")).collect();
    assert!(own.contains("form = \"printed\""), "{own}");
    fs::write(folder.join("windows.toml"), own).unwrap();
    let (code, report) = json(place.path(), &["judge", "mine", "--claim", "T3.5.2", "--out", "report"]);
    let printed = &report["claims"][0]["as_printed"];
    assert_eq!(
        (code, &printed["scope"], &printed["certificate"]),
        (0, &"degree".into(), &"T3.5.2.printed".into())
    );
    assert_eq!(printed["degrees"].as_array().unwrap().last(), Some(&8.into()));
    assert!(place.path().join("report/certs/T3.5.2.printed.proof").is_file());
    assert_eq!(run(place.path(), &["verify", "--foreign", "report/certs"]).0, 0);
    let (code, proved) =
        json(place.path(), &["prove", "--paper", "mine", "--claim", "T3.5.2", "--out", "certs"]);
    assert_eq!(
        (code, &proved["checked"][0]["claim"], &proved["paper"]["title"]),
        (0, &"T3.5.2".into(), &"On \"splines\"".into())
    );
}

/// Numbers beyond `f64` are judged like all others; only a picture of them there can't be.
/// Weights between any ends are those of the family, in the prover and in the checker; what is false of them is refuted.
#[test]
fn weights_of_another_family_are_certified_between_any_ends() {
    let place = tempfile::tempdir().unwrap();
    assert_eq!(run(place.path(), &["new", "mine", "--family", "smoothstep"]).0, 0);
    let claim = |id: &str, then: &str| {
        format!(
            "\n[[claim]]\nid = \"{id}\"\nat = \"here\"\ntitle = \"{id}\"\nfor = \"a; b; x\"\nif = [\"a < b\"]\nthen = [{then}]\n"
        )
    };
    let path = place.path().join("mine/claims/01-basis.toml");
    let mut text = fs::read_to_string(&path).unwrap();
    text += &claim(
        "Rises",
        r#""a < x < b => phi'(x, a, b) > 0", "phi(b-, a, b) = 1", "not x in [a, b) => phi(x, a, b) = 0""#,
    );
    text += &claim("Bends", r#""a < x < b => phi''(x, a, b) > 0""#);
    text += &claim("Flat", r#""f'(a, a, b) = 0", "f'(b, a, b) = 0""#);
    fs::write(&path, text).unwrap();
    let (_, report) = json(place.path(), &["judge", "mine"]);
    let of = |id: &str| {
        report["claims"].as_array().unwrap().iter().find(|claim| claim["id"] == id).unwrap()["as_printed"]
            .clone()
    };
    for (id, verdict) in [("Rises", "proved"), ("Bends", "refuted"), ("Flat", "proved")] {
        assert_eq!(of(id)["status"], verdict, "{id}");
    }
    assert_eq!(of("Rises")["scope"], "knots");
}

#[test]
fn what_can_not_be_drawn_is_said() {
    let place = started();
    let instance =
        "[[instance]]\nname = \"Big\"\ndegree = 1\nknots = \"0 1e-300 1 1e300\"\nalpha = \"-1e200 inf\"\n";
    fs::write(place.path().join("mine").join(INSTANCES), instance).unwrap();
    let (code, text, _) = run(place.path(), &["judge", "mine", "--claim", "P1", "--out", "report"]);
    assert_eq!(code, 0);
    assert!(text.contains("Not drawn: Big, degree 1: its numbers are too large"), "{text}");
    assert!(!place.path().join("report/Big-1.svg").exists());
}

/// One claim on one's own knots, and what a witness says about seeing it again is a command that works.
#[test]
fn claims_of_a_folder_are_checked_on_knots() {
    let place = started();
    let (code, check) = json(place.path(), &["check", "--paper", "mine", "--instance", "E1", "--alpha", "2"]);
    let statuses: Vec<_> = check["properties"]
        .as_array()
        .unwrap()
        .iter()
        .map(|one| one["status"].as_str().unwrap().to_owned())
        .collect();
    assert_eq!((code, statuses), (0, vec!["proved".to_owned(); 4]), "E1 is clamped");
    let knots = ["--degree", "1", "--knots", "0 1 2 3", "--alpha", "2"];
    let (code, check) =
        json(place.path(), &[&["check", "--paper", "mine", "--property", "P2"], &knots[..]].concat());
    assert_eq!((code, &check["properties"][0]["status"]), (1, &"refuted".into()));
    let (code, check) = json(
        place.path(),
        &[&["check", "--paper", "mine", "--claim", "x in [t[0], t[m]] : claim(P2)"], &knots[..]].concat(),
    );
    assert_eq!(
        (code, &check["properties"][0]["status"]),
        (0, &"proved".into()),
        "the amended one of the folder"
    );
    // A claim about one instance is judged again by the folder, whatever it is called.
    fs::rename(place.path().join("mine"), place.path().join("my paper")).unwrap();
    let file = place.path().join("my paper/claims/01-basis.toml");
    let text = fs::read_to_string(&file).unwrap().replacen("k; U clamped\"", "U in {E1}\"", 1);
    fs::write(&file, text.replacen("\"G[0](t[0]) = 1\", ", "\"mult(t[3]) = 2\", ", 1)).unwrap();
    let (code, text, _) = run(place.path(), &["judge", "my paper", "--claim", "P3"]);
    assert_eq!(code, 1, "{text}");
    let again = text.lines().find_map(|line| line.trim().strip_prefix("again: knotproof ")).unwrap();
    assert_eq!(again, "judge 'my paper' --claim P3");
}

/// The textbook's verdicts: what is false as printed has an amendment that is proved.
#[test]
fn the_verdicts_on_the_textbook() {
    let (code, report) = json(Path::new("."), &["judge", "classical"]);
    let mut found = verdicts(&report);
    let refuted = ("refuted".to_owned(), Some("proved".to_owned()));
    for id in ["Unity", "Maximum", "Support.half"] {
        assert_eq!(found.remove(id), Some(refuted.clone()), "{id}");
    }
    // Known to be true, and not decided by finitely many tries.
    for id in ["Variation", "TotallyPositive", "Insertion"] {
        assert_eq!(found.remove(id), Some(("undecided".to_owned(), None)), "{id}");
    }
    let names: Vec<_> = found.keys().map(String::as_str).collect();
    let proved = [
        "Bernstein",
        "Continuity",
        "Continuity.sharp",
        "Curve.affine",
        "Curve.derivative",
        "Curve.ends",
        "Curve.hull",
        "Curve.local",
        "Curve.tangents",
        "DeBoor",
        "Derivative",
        "Derivative.ends",
        "Derivative.sum",
        "Elevation",
        "Ends",
        "Few",
        "Greville",
        "Independent",
        "Marsden",
        "Nonnegative",
        "Polynomials",
        "Positive",
        "Recursion",
        "Smooth",
        "Support",
        "Symmetry",
        "Unimodal",
    ];
    assert_eq!(names, proved);
    assert!(found.values().all(|verdict| *verdict == ("proved".to_owned(), None)), "{found:#?}");
    assert_eq!(code, 1);
    let claims = report["claims"].as_array().unwrap();
    let sharp = claims.iter().filter(|claim| claim.get("fails").is_some());
    assert!(sharp.clone().count() >= 2 && sharp.clone().all(|claim| claim["fails"]["status"] == "proved"));
    // Only α = ∞ was looked at, in several degrees.
    for claim in claims {
        let printed = &claim["as_printed"];
        assert!(printed.get("witness").is_none_or(|witness| witness["alpha"] == "inf"), "{claim}");
        assert!(
            printed["status"] != "proved"
                || printed["scope"] == "knots"
                || printed["degrees"].as_array().unwrap().len() >= 5,
            "{claim}"
        );
    }
}
