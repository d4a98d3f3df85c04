//! `knotproof check` as a user meets it: verdicts on one instance, for every x.

#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests")]

use std::fs;
use std::process::Stdio;

use assert_cmd::Command;
use knotproof::judge::Witness;
use knotproof::language::{Form, paper};
use knotproof::scalar::{BigRational, integer, parse_rational};
use knotproof::spline::{Basis, Index, KnotVector, Side};
use serde_json::{Value, json};

fn knotproof(arguments: &[&str]) -> Command {
    let mut command = crate::program();
    command.args(arguments);
    command
}

/// The exit code and the result as JSON, in which everything has the shape that scripts rely on.
fn check(arguments: &[&str]) -> (i32, Value) {
    let output = knotproof(&[&["check", "--format", "json"], arguments].concat()).output().unwrap();
    assert_eq!(String::from_utf8_lossy(&output.stderr), "");
    let found: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(found["schema"], "knotproof.check/1");
    assert!(!properties(&found).is_empty());
    for property in properties(&found) {
        assert!(property["id"].is_string() && property["alpha"].is_string(), "{property}");
        has_shape_of_finding(property);
        if let Some(amended) = property.get("amended") {
            assert_eq!(property["status"], "refuted", "what holds is not amended");
            assert_ne!(amended["statement"], property["statement"]);
            has_shape_of_finding(amended);
        }
    }
    (output.status.code().unwrap(), found)
}

/// Who came to a verdict, but for a theorem.
fn without_coq(checked_by: &Value) -> Value {
    checked_by.as_array().unwrap().iter().filter(|by| **by != "coq").cloned().collect()
}

fn has_shape_of_finding(finding: &Value) {
    let has = |field: &str| finding.get(field).is_some();
    assert!(finding["statement"].is_string());
    match finding["status"].as_str().unwrap() {
        "proved" => {
            assert!(!has("witness") && !has("reason"), "{finding}");
            // The widest scope: with a formal proof for every knot vector, else for this one.
            if has("certificate") {
                // Of X.maxima.most it is one for the function of a formula, which is an instance for each α.
                let reached = ["degree", "knots", "instance"].map(Value::from).contains(&finding["scope"]);
                assert!(finding["certificate"].is_string() && reached, "{finding}");
                // What the engine leaves open here is settled by the proof alone.
                let by = [json!(["engine", "prover", "checker"]), json!(["prover", "checker"])];
                assert!(by.contains(&without_coq(&finding["checked_by"])), "{finding}");
            } else if finding["scope"] == "degree" {
                // Where numbers are only tried a theorem settles it alone.
                let by = [json!(["engine", "coq"]), json!(["coq"])];
                assert!(finding["theorems"].is_array() && by.contains(&finding["checked_by"]), "{finding}");
            } else {
                assert_eq!(
                    (&finding["scope"], &finding["checked_by"]),
                    (&json!("instance"), &json!(["engine"]))
                );
            }
        }
        "refuted" => {
            assert!(has("witness") && !has("scope") && !has("certificate"), "{finding}");
            assert_eq!(finding["checked_by"], json!(["engine"]));
        }
        "undecided" | "not-applicable" => {
            assert!(finding["reason"].is_string() && !has("scope") && !has("witness"), "{finding}");
            assert!(!has("certificate"), "{finding}");
        }
        other => panic!("no such status: {other}"),
    }
}

fn properties(found: &Value) -> &[Value] {
    found["properties"].as_array().unwrap()
}

fn statuses(found: &Value) -> Vec<(&str, &str)> {
    properties(found).iter().map(|p| (p["id"].as_str().unwrap(), p["status"].as_str().unwrap())).collect()
}

/// The witness of the first property.
fn witness(found: &Value) -> Witness {
    serde_json::from_value(found["properties"][0]["witness"].clone()).unwrap()
}

fn basis(degree: usize, knots: &str, alpha: &str) -> Basis {
    let knots = knots.split(' ').map(|t| parse_rational(t).unwrap()).collect();
    Basis::new(KnotVector::new(knots).unwrap(), degree, alpha.parse::<Index>().unwrap()).unwrap()
}

#[test]
fn all_fields_are_there() {
    let arguments = ["--degree", "1", "--knots", "0 0 1/2 1", "--alpha", "-1"];
    let (code, found) = check(&[&arguments[..], &["--property", "T3.5.3", "--property", "P3.1.1"]].concat());
    assert_eq!(code, 1);
    let unity = |j| {
        format!(
            "For every U, every {j} and every x in [t_j, t_{{j+1}}): Σ_{{i=0}}^n G_i^k(x) = Σ_{{i=j−k}}^j G_i^k(x) = 1."
        )
    };
    let looked = |i| json!({"i": i, "degree": 1, "order": 0, "x": "2/3", "left": false, "alpha": "-1"});
    // On [1/2, 1) only G_1 is left: 1 − φ_{−1}(2/3, 1/2, 1) = 1 − (1/6)/(1/6 + 2/3) = 4/5.
    let expected = json!({
        "schema": "knotproof.check/1",
        "version": env!("CARGO_PKG_VERSION"),
        "paper": {"arxiv": "1805.04433"},
        "degree": 1,
        "knots": ["0", "0", "1/2", "1"],
        "properties": [
            {
                "id": "T3.5.3",
                "alpha": "-1",
                "form": "printed",
                "statement": unity("0 ≤ j ≤ m − 1"),
                "status": "refuted",
                "witness": {
                    "k": 1,
                    "knots": ["0", "0", "1/2", "1"],
                    "alpha": "-1",
                    "given": [{"name": "j", "value": 2}, {"name": "x", "value": "2/3"}],
                    "conclusion": 0,
                    "claimed": "Σ_{i=0}^1 G_i^1(2/3) = Σ_{i=1}^2 G_i^1(2/3) = 1",
                    "shows": {
                        "values": [
                            {"term": "Σ_{i=0}^1 G_i^1(2/3)", "value": "4/5"},
                            // There is no G_2.
                            {"term": "Σ_{i=1}^2 G_i^1(2/3)"},
                            {"term": "1", "value": "1"},
                        ],
                    },
                    "looked": [looked(0), looked(1)],
                },
                "checked_by": ["engine"],
                "amended": {
                    "statement": unity("k ≤ j ≤ n"),
                    "status": "proved",
                    "scope": "degree",
                    "any_weights": true,
                    "degrees": [1],
                    "certificate": "T3.5.3.amended",
                    "checked_by": ["engine", "prover", "checker", "coq"],
                    "theorems": [
                        {
                            "name": "T3_5_3_amended", "file": "StatementsBasis.v", "status": "proved",
                            "degrees": "for every k", "all_degrees": true, "from_stanza": true,
                        },
                        {
                            "name": "T3_5_3", "file": "Basis.v", "status": "proved",
                            "degrees": "for every k", "all_degrees": true, "any_weights": true,
                        },
                    ],
                },
            },
            {
                "id": "P3.1.1",
                "alpha": "-1",
                "form": "printed",
                "statement": "For every U, every 0 ≤ i ≤ n and every 0 ≤ j ≤ m − 1: G_i^k(x) for x in (t_j, t_{j+1}) is a quotient of polynomials without a pole.",
                "status": "proved",
                "scope": "degree",
                "degrees": [1],
                "certificate": "P3.1.1.printed",
                "checked_by": ["engine", "prover", "checker", "coq"],
                "theorems": [{
                    "name": "P3_1_1_printed", "file": "StatementsDerivatives.v", "status": "proved",
                    "degrees": "for every k", "all_degrees": true, "from_stanza": true,
                }],
            },
        ],
    });
    assert_eq!(found, expected);
}

/// Degrees, indices and counts are whole numbers; every other number is a string.
#[test]
fn no_number_is_a_float() {
    fn walk(name: &str, value: &Value) {
        match value {
            Value::Number(number) => {
                let whole = ["degree", "degrees", "k", "value", "conclusion", "i", "order", "count"];
                assert!(number.is_i64() && whole.contains(&name), "{name}: {number}");
            }
            Value::Array(items) => items.iter().for_each(|item| walk(name, item)),
            Value::Object(fields) => fields.iter().for_each(|(name, item)| walk(name, item)),
            _ => {}
        }
    }
    walk("", &check(&["--degree", "2", "--knots", "0 0.25 1 1.5 2 2", "--alpha", "-1.5"]).1);
}

#[test]
fn without_a_choice_every_claim_that_depends_on_the_instance_is_judged() {
    let (code, found) = check(&["--instance", "U4", "--alpha", "-1"]);
    assert_eq!(code, 1, "T3.5.1 fails on every open vector");
    let ids: Vec<_> = statuses(&found).into_iter().map(|(id, _)| id).collect();
    for id in ["T3.5.1", "T3.5.2", "Conj3.1.strong.continuous", "P3.2", "T4.1", "proof.P3.2.induction"] {
        assert_eq!(ids.iter().filter(|other| **other == id).count(), 1, "{id}");
    }
    let others = ["X.", "Ill5.", "phi.", "P2.1"];
    assert!(!ids.iter().any(|id| others.iter().any(|other| id.starts_with(other))), "{ids:?}");
    assert_eq!(statuses(&found).iter().find(|(id, _)| *id == "T3.5.2"), Some(&("T3.5.2", "proved")));
}

#[test]
fn all_that_can_be_judged_amended_and_against_the_records() {
    let instance = ["--instance", "U4", "--alpha", "-1"];
    let with = |more: &[&str]| check(&[&instance[..], more].concat());
    let (_, all) = with(&["--all"]);
    let ids: Vec<_> = statuses(&all).into_iter().map(|(id, _)| id).collect();
    assert!(["phi.range", "T3.5.1", "X.G1"].iter().all(|id| ids.contains(id)), "{ids:?}");
    // What is known to be true holds here too.
    let (code, amended) = with(&["--amended"]);
    assert_eq!(code, 0, "{:?}", statuses(&amended));
    assert!(properties(&amended).iter().any(|p| p["id"] == "T3.5.1" && p["form"] == "amended"));
    let (code, recorded) = with(&["--all", "--baseline"]);
    assert_eq!(code, 0, "{:?}", statuses(&recorded));
    assert!(properties(&recorded).iter().all(|p| p["as_recorded"] == true));
    assert!(statuses(&recorded).contains(&("T3.5.1", "refuted")));
}

#[test]
fn exit_codes() {
    // In degree 3 nothing is known of X.variation without interior knots.
    let instance = ["--degree", "3", "--knots", "0 0 0 0 1 1 1 1", "--alpha", "-1"];
    let on = |options: &[&str]| check(&[&instance, options].concat()).0;
    assert_eq!(on(&["--property", "T3.5.3"]), 0);
    assert_eq!(on(&["--property", "T3.5.1"]), 1);
    assert_eq!(on(&["--property", "X.variation"]), 3);
    assert_eq!(on(&["--property", "X.variation", "--property", "T3.5.3"]), 3);
    assert_eq!(on(&["--property", "X.variation", "--property", "T3.5.1"]), 1, "refuted counts more");
    knotproof(&["check", "--instance", "U4", "--property", "T3.5"]).assert().code(2).stdout("");
}

#[test]
fn one_property_or_several_in_the_order_of_the_paper() {
    let on = |options: &[&str]| {
        let (_, found) = check(&[&["--instance", "U4", "--alpha", "5"], options].concat());
        statuses(&found).into_iter().map(|(id, _)| id.to_owned()).collect::<Vec<_>>()
    };
    assert_eq!(on(&["--property", "P3.2"]), ["P3.2"]);
    assert_eq!(on(&["--property=X.G1", "--property", "T3.5.3", "--property", "X.G1"]), ["T3.5.3", "X.G1"]);
}

/// The message of a request that is refused, without its frame.
fn refused(arguments: &[&str], argument: &str) -> String {
    let arguments = [&["check", "--format", "json", "--instance", "U4"], arguments].concat();
    let output = knotproof(&arguments).assert().code(2).stdout("").get_output().stderr.clone();
    let report: Value = serde_json::from_slice(&output).unwrap();
    assert_eq!(report["schema"], "knotproof.error/1");
    assert_eq!(report["error"]["argument"], argument, "{report}");
    report["error"]["message"].as_str().unwrap().to_owned()
}

#[test]
fn an_unknown_property_is_refused_with_those_that_are_near() {
    for (name, near) in [
        ("T3.5", "T3.5.1, T3.5.2, T3.5.3, T3.5.4"),
        ("T3.5.9", "T3.5.1, T3.5.2, T3.5.3, T3.5.4"),
        ("Conj3.1.weak.", "Conj3.1.weak.continuous"),
        ("X.nurb", "X.nurbs"),
    ] {
        let message = refused(&["--property", "P3.2", "--property", name], "--property");
        assert_eq!(message, format!("--property: there is no claim `{name}`; there are {near}"));
    }
    for name in ["", "é", "\u{1b}[31m"] {
        assert!(refused(&["--property", name], "--property").contains("P3.2"), "all of them are shown");
    }
}

#[test]
fn a_claim_about_examples_is_referred_to_report() {
    for claim in ["Ill5.8.fig29", "Rem5.1.conj"] {
        let message = refused(&["--property", claim], "--property");
        assert!(message.contains("about examples of the paper"), "{message}");
        assert!(message.contains(&format!("`knotproof report --claim {claim}`")), "{message}");
    }
}

#[test]
fn an_unknown_scope_is_refused() {
    let message = refused(&["--scope", "all"], "--scope");
    assert!(
        message.contains("'all'") && message.contains("points, instance, alpha, knots, degree"),
        "{message}"
    );
}

/// What is refuted in general and holds here is proved for one α: whoever asks for every α is not told "proved".
#[test]
fn a_proof_that_reaches_less_far_than_asked_for_is_undecided() {
    let on = |scope| check(&["--instance", "U4", "--alpha", "-1", "--property", "T3.5.3", "--scope", scope]);
    for scope in ["points", "instance"] {
        let (code, found) = on(scope);
        assert_eq!((code, statuses(&found)), (0, vec![("T3.5.3", "proved")]), "{scope}");
    }
    for scope in ["alpha", "knots", "degree"] {
        let (code, found) = on(scope);
        assert_eq!((code, statuses(&found)), (3, vec![("T3.5.3", "undecided")]));
        let reason = found["properties"][0]["reason"].as_str().unwrap();
        assert_eq!(reason, format!("proved at scope instance only, and {scope} was asked for"));
    }
    // One instance is enough to refute; a theorem about every degree reaches this one.
    let options = ["--instance", "U4", "--alpha", "-1", "--property", "T3.5.1", "--scope", "degree"];
    let (code, found) = check(&options);
    assert_eq!((code, statuses(&found)), (1, vec![("T3.5.1", "refuted")]));
    assert_eq!(found["properties"][0]["amended"]["scope"], "degree");
    let options = ["--instance", "U4", "--alpha", "-1", "--property", "X.weights", "--scope", "degree"];
    let (_, found) = check(&options);
    assert_eq!(found["properties"][0]["reason"], "proved at scope knots only, and degree was asked for");
}

/// `--scope knots` is met by the claims that are proved formally, as printed or as amended, and by no others.
#[test]
fn a_formal_proof_reaches_every_knot_vector() {
    let claims = ["T3.5.1", "T3.5.2", "T3.5.3", "Conj3.1.weak.continuous"];
    let mut arguments = vec!["--instance", "U4", "--alpha", "-1", "--scope", "knots"];
    arguments.extend(claims.iter().flat_map(|claim| ["--property", claim]));
    let (code, found) = check(&arguments);
    let expected = [
        ("T3.5.1", "refuted"),
        ("T3.5.2", "proved"),
        // Refuted in general; true on an open vector.
        ("T3.5.3", "undecided"),
        // True in this degree, and refuted in general.
        ("Conj3.1.weak.continuous", "proved"),
    ];
    assert_eq!((code, statuses(&found)), (1, expected.to_vec()));
    let [support, positive, unity, weak] = properties(&found) else { panic!("four claims: {found}") };
    let certified = [
        (&support["amended"], "degree", "T3.5.1.amended"),
        (positive, "degree", "T3.5.2.printed"),
        (weak, "knots", "Conj3.1.weak.continuous.degrees"),
    ];
    for (finding, scope, certificate) in certified {
        assert_eq!((&finding["status"], &finding["scope"]), (&json!("proved"), &json!(scope)));
        assert_eq!((&finding["degrees"], &finding["certificate"]), (&json!([2]), &json!(certificate)));
        assert_eq!(without_coq(&finding["checked_by"]), json!(["engine", "prover", "checker"]));
    }
    assert_eq!(unity["reason"], "proved at scope instance only, and knots was asked for");
    assert_eq!(
        check(&["--instance", "U4", "--alpha", "-1", "--scope", "knots", "--property", "T3.5.2"]).0,
        0
    );
}

#[test]
fn several_indices_are_judged_one_after_the_other() {
    let options = ["--property", "T3.5.3", "--property", "X.linear"];
    let alphas = ["--alpha", "inf", "--alpha", "-1/2", "--alpha", "3"];
    let (code, found) = check(&[&["--instance", "U4"], &alphas[..], &options].concat());
    let of = |p: &Value| [&p["alpha"], &p["id"], &p["status"]].map(|text| text.as_str().unwrap().to_owned());
    let expected = [
        ["inf", "T3.5.3", "proved"],
        // The question is about finite α.
        ["inf", "X.linear", "not-applicable"],
        ["-1/2", "T3.5.3", "proved"],
        ["-1/2", "X.linear", "refuted"],
        ["3", "T3.5.3", "proved"],
        ["3", "X.linear", "refuted"],
    ];
    assert_eq!(
        (code, properties(&found).iter().map(of).collect::<Vec<_>>()),
        (1, expected.map(|p| p.map(str::to_owned)).to_vec())
    );
    // Without --alpha: those that the paper shows.
    let (_, found) = check(&["--instance", "U4", "--property", "T3.5.3"]);
    let alphas: Vec<_> = properties(&found).iter().map(|p| p["alpha"].as_str().unwrap()).collect();
    assert_eq!(alphas, ["-1", "2", "5", "inf"]);
}

#[test]
fn an_instance_by_name_by_file_and_by_options_is_the_same() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("u9.json");
    let content = r#"{"degree": 2, "knots": [0, 0, 0, 0.75, "6/4", "9/4", 3, 3, 3], "alpha": [-1, 5]}"#;
    fs::write(&path, content).unwrap();
    // Claims of every kind; with all claims this would be three quarters of a minute of the same.
    let claims =
        ["--property", "T3.5.1", "--property", "T3.5.3", "--property", "T3.11.2", "--property", "X.close"];
    let on = |instance: &[&str]| check(&[instance, &claims].concat());
    let by_name = on(&["--instance", "U9", "--alpha", "-1", "--alpha", "5"]);
    assert_eq!(properties(&by_name.1).len(), 8);
    assert_eq!(on(&["--instance", path.to_str().unwrap()]), by_name);
    let knots = "0 0 0 3/4 3/2 9/4 3 3 3";
    assert_eq!(on(&["--degree", "2", "--knots", knots, "--alpha", "-1", "--alpha", "5"]), by_name);
}

/// Any knots at all: degree 0, ends and inner knots of multiplicity k + 1 and k + 2, not open, negative, fewer
/// functions than k + 1, huge and tiny gaps, α next to 0 and 1. What is refuted as printed holds as amended, or the
/// amended statement says nothing about it.
#[test]
fn every_instance_gets_a_verdict() {
    for (degree, knots, alphas) in [
        ("0", "0 1", &["-1"][..]),
        ("0", "0 0 1 1 1 2", &["-1", "inf"]),
        ("1", "0 0 1/2 1/2 1 1", &["-1"]),
        ("1", "0 0 0 1 1 1", &["2"]),
        ("1", "0 1 1 1 1 2", &["-1"]),
        ("2", "0 1 2 3 4", &["-1"]),
        ("2", "0 0 0 0 1 1 1 1", &["-1"]),
        ("2", "0 0 0 1 1 1 1 2 2 2", &["5"]),
        ("2", "0 1 2 2 2 2 3 4 4", &["-1/2"]),
        ("2", "-1 0 1e-9 1e9 2e9 2e9", &["-1/1000000", "1000001/1000000"]),
        ("3", "-3 -2 -2 0 1/3 1/2 7 9", &["-1"]),
        ("3", "0 0 0 0 1 1 1 1 1 2 2 2 2", &["3/2"]),
    ] {
        let mut arguments = vec!["--degree", degree, "--knots", knots];
        arguments.extend(alphas.iter().flat_map(|alpha| ["--alpha", alpha]));
        let (code, found) = check(&arguments);
        assert_eq!(code, 1, "P2.1.3 fails at the ends of every interval");
        for property in properties(&found) {
            let amended = property.get("amended").map_or("not-applicable", |a| a["status"].as_str().unwrap());
            assert!(["proved", "not-applicable"].contains(&amended), "{knots}: {property}");
        }
    }
}

#[test]
fn a_witness_can_be_computed_again() {
    // U is not open: left of t_k = 2 a function G_{−1} is missing, so the sum is less than 1 there.
    for (degree, knots, alpha) in [
        (2, "0 1 2 3 4 5", "-1"),
        (1, "0 1/2 2 3", "5"),
        (3, "0 0 0 1 1 2 3 4 4", "inf"),
        (2, "0 0 0 1 2 3", "3/2"),
    ] {
        let options = ["--degree", &degree.to_string(), "--knots", knots, "--alpha", alpha];
        let (code, found) = check(&[&options[..], &["--property", "T3.5.3"]].concat());
        assert_eq!(code, 1, "{knots}");
        let basis = basis(degree, knots, alpha);
        let witness = witness(&found);
        assert_eq!(witness.basis().as_ref(), Some(&basis));

        let x = witness.number("x").unwrap();
        let j: usize = witness.number("j").unwrap().to_string().parse().unwrap();
        assert!(basis.knots().t(j) <= &x && &x < basis.knots().t(j + 1), "x lies in the span j");
        let sum: BigRational = basis.values(&x, Side::Right).iter().sum();
        assert_ne!(sum, integer(1));
        let n = basis.n();
        assert!(witness.found().starts_with(&format!("Σ_{{i=0}}^{n} G_i^{degree}({x}) = {sum}, ")));

        // The command that goes with it gives the same.
        let command = witness.again("T3.5.3", Form::Printed, paper());
        let arguments: Vec<_> = command.strip_prefix("knotproof ").unwrap().split(' ').collect();
        let output =
            knotproof(&arguments).args(["--format", "json"]).assert().success().get_output().stdout.clone();
        let eval: Value = serde_json::from_slice(&output).unwrap();
        let values = eval["values"].as_array().unwrap().iter().map(|value| value.as_str().unwrap());
        assert_eq!(values.map(|value| parse_rational(value).unwrap()).sum::<BigRational>(), sum);
    }
    // At the double knot 0 of degree 1, G_0 is 1 and not 0.
    let (_, found) =
        check(&["--degree", "1", "--knots", "0 0 1 2 2", "--alpha", "2", "--property", "T3.5.1"]);
    let witness = witness(&found);
    let (i, x) = (witness.number("i").unwrap(), witness.number("x").unwrap());
    let i: usize = i.to_string().parse().unwrap();
    let basis = basis(1, "0 0 1 2 2", "2");
    let value = &basis.values(&x, Side::Right)[i];
    let (low, high) = basis.support(i);
    assert!((x <= *low || x >= *high) && *value != integer(0));
    assert_eq!(witness.found(), format!("G_{i}^1({x}) = {value}"));
}

/// The same claim on the same knots holds or fails as the knots and not the program's own cases decide.
#[test]
fn the_verdict_is_about_this_instance() {
    let verdict = |knots: &str, property: &str| {
        let options = ["--degree", "2", "--knots", knots, "--alpha", "-1", "--property", property];
        check(&options).1["properties"][0]["status"].as_str().unwrap().to_owned()
    };
    assert_eq!(verdict("0 0 0 1 2 2 2", "T3.5.3"), "proved");
    assert_eq!(verdict("0 0 1 2 3 3 3", "T3.5.3"), "refuted");
    assert_eq!(verdict("0 1 2 3 4 5", "T3.5.1"), "proved");
    assert_eq!(verdict("0 0 0 1 2 2 2", "T3.5.1"), "refuted");
    assert_eq!(verdict("0 0 0 1 2 2 2", "Conj3.1.strong"), "proved");
    assert_eq!(verdict("0 0 0 1 1 1 2 2 2", "Conj3.1.strong"), "refuted");
    assert_eq!(verdict("0 0 0 1 1 1 2 2 2", "Conj3.1.strong.continuous"), "proved");
    assert_eq!(verdict("0 0 0 1 2 2 2", "P3.3.2"), "not-applicable", "there is an interior knot");
    assert_eq!(verdict("0 0 0 2 2 2", "P3.3.2"), "refuted", "at the last knot");
    assert_eq!(verdict("0 0 0 2 2 2", "X.derivative"), "refuted");
    assert_eq!(verdict("0 0 0 1 2 2 2", "X.G1"), "proved");
}

/// It is told what the claim is about, and nothing is claimed to be proved.
#[test]
fn a_claim_about_open_knots_does_not_apply_to_others() {
    let options = ["--degree", "2", "--knots", "0 1 2 3 4 5", "--alpha", "-1", "--property", "P3.2"];
    let (code, found) = check(&options);
    assert_eq!(statuses(&found), [("P3.2", "not-applicable")]);
    assert_eq!(
        found["properties"][0]["reason"],
        "said only of open U with interior knots of multiplicity at most k"
    );
    assert_eq!(code, 0, "nothing is refuted and nothing undecided");
}

#[test]
fn the_text_has_a_line_for_each_claim() {
    let on = ["--instance", "U1", "--alpha", "-1", "--alpha", "inf"];
    let output =
        knotproof(&[&["check"], &on[..]].concat()).assert().code(1).stderr("").get_output().stdout.clone();
    let text = String::from_utf8(output).unwrap();
    assert!(text.starts_with("U1 (Fig. 9)\nk = 2, U = (0, 1, 2, 3, 3, 5, 6)\n"), "{text}");
    assert!(!text.contains('\u{1b}'), "no escape sequences in a pipe");
    let (_, found) = check(&on);
    let lines: Vec<Vec<&str>> = text.lines().map(|line| line.split_whitespace().collect()).collect();
    for (id, status) in statuses(&found) {
        let is = |word: &&str| word.trim_end_matches(':') == status;
        let line = |line: &&Vec<&str>| line.first() == Some(&id) && line.get(1).is_some_and(is);
        assert!(lines.iter().any(|words| line(&words)), "{id} {status} in {text}");
    }
    assert_eq!(text.matches("for every x:").count(), 2, "one part for each index");
    let widths = text.lines().filter(|line| line.contains(" proved (") && !line.contains("amended"));
    let widths: Vec<_> = widths.map(|line| line.find("proved").unwrap()).collect();
    assert!(widths.windows(2).all(|pair| pair[0] == pair[1]), "the verdicts stand below each other: {text}");
    let counts = text.lines().last().unwrap();
    let count = |status| statuses(&found).iter().filter(|(_, other)| *other == status).count();
    for status in ["proved", "refuted", "not-applicable"] {
        assert!(counts.contains(&format!("{} {status}", count(status))), "{counts}");
    }
}

#[test]
fn the_text_shows_the_witness_and_the_limit() {
    let options = ["check", "--degree", "1", "--knots", "0 0 1 2", "--alpha", "-1", "--property"];
    let text = |property| {
        let output = knotproof(&[&options[..], &[property]].concat()).output().unwrap();
        String::from_utf8(output.stdout).unwrap()
    };
    let refuted = text("T3.5.3");
    for part in [
        "at j = 2, x = 3/2: it says Σ_{i=0}^1 G_i^1(3/2) = Σ_{i=1}^2 G_i^1(3/2) = 1; but Σ_{i=0}^1 G_i^1(3/2) = 2/3, Σ_{i=1}^2 G_i^1(3/2) does not exist",
        "amended: proved (degree, for every k, any weights) ",
    ] {
        assert!(refuted.contains(part), "{part} in {refuted}");
    }
    assert!(text("X.totalpositivity").contains("X.totalpositivity          proved (knots, for k = 1)\n"));
    // From degree 3 on it is refuted in general, and open on these knots.
    let options = ["check", "--degree", "3", "--knots", "0 0 0 0 1 1 1 1", "--alpha", "-1", "--property"];
    let output = knotproof(&[&options[..], &["X.totalpositivity"]].concat()).output().unwrap();
    let limited = String::from_utf8(output.stdout).unwrap();
    assert!(limited.contains("undecided: no negative minor"), "the limit is named: {limited}");
}

#[test]
fn colour_only_where_it_is_asked_for() {
    let coloured = |variables: &[(&str, &str)]| {
        let mut command = knotproof(&["check", "--instance", "U4", "--alpha", "2", "--property", "T3.5.1"]);
        for name in ["NO_COLOR", "CLICOLOR_FORCE", "CLICOLOR"] {
            command.env_remove(name);
        }
        command.envs(variables.iter().copied());
        command.assert().code(1).get_output().stdout.contains(&0x1b)
    };
    assert!(!coloured(&[]));
    assert!(coloured(&[("CLICOLOR_FORCE", "1")]));
    assert!(!coloured(&[("CLICOLOR_FORCE", "1"), ("NO_COLOR", "1")]));
}

#[test]
fn a_closed_pipe_is_no_error() {
    for format in ["text", "json"] {
        let mut child = crate::process()
            .args(["check", "--format", format, "--instance", "U4", "--alpha", "-1"])
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        drop(child.stdout.take());
        let output = child.wait_with_output().unwrap();
        // The verdict stands, whoever reads it.
        assert_eq!((output.status.code(), output.stderr.as_slice()), (Some(1), &b""[..]), "{format}");
    }
}
