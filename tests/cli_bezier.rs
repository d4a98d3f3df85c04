//! `knotproof bezier` as a user meets it.

#![allow(clippy::unwrap_used, reason = "helpers of tests")]

use std::io::Write;

use assert_cmd::Command;
use knotproof::scalar::{BigRational, integer, parse_rational, rational};
use knotproof::spline::bernstein;
use serde::Deserialize;
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

fn bezier(arguments: &[&str]) -> Value {
    let arguments = [&["bezier", "--format", "json"], arguments].concat();
    serde_json::from_str(&text(&arguments)).unwrap()
}

/// Runs the request as text and as JSON, and checks that each message contains all of `parts`.
fn rejected(arguments: &[&str], argument: &str, parts: &[&str]) {
    let arguments = [&["bezier"], arguments].concat();
    let output = knotproof(&arguments).assert().code(2).stdout("").get_output().stderr.clone();
    let message = String::from_utf8(output).unwrap();
    assert!(parts.iter().all(|part| message.contains(part)), "{parts:?} in {message}");
    let arguments = [&arguments[..], &["--format", "json"]].concat();
    let output = knotproof(&arguments).assert().code(2).stdout("").get_output().stderr.clone();
    let report: Value = serde_json::from_slice(&output).unwrap();
    assert_eq!(
        (&report["schema"], &report["error"]["argument"]),
        (&json!("knotproof.error/1"), &json!(argument))
    );
    let message = report["error"]["message"].as_str().unwrap();
    assert!(parts.iter().all(|part| message.contains(part)), "{parts:?} in {message}");
}

/// A number of the JSON.
fn number(value: &Value) -> BigRational {
    parse_rational(value.as_str().unwrap()).unwrap()
}

/// Members of families that are not those of an index: what chooses them, the degree, and knots that they are for.
const MEMBERS: [(&[&str], &str, &str, &str); 6] = [
    (&["--family", "smoothstep"], "2", "0 0 0 1/2 2 3 3 3", "0,1 1,4 2,-1 3,2 5,0"),
    (&["--family", "square"], "3", "0 1 2 4 5 7 8 9", "1 -2 5 3"),
    (&["--family", "lupas", "--set", "q=1/2"], "2", "0 0 0 1 2 2 2", "0,0 1,2 2,2 3,0"),
    (&["--family", "phillips", "--set", "q=3"], "3", "0 0 0 0 1 1 1 1", "0 0 1 0"),
    (&["--family", "nurbs", "--set", "omega=1,2,1/2,3"], "2", "0 0 0 1 2 2 2", "0,0 1,2 2,2 3,0"),
    (&["--family", "knot-weights", "--set", "omega=1,2,1/2,3,1,1,2,5"], "2", "0 1 2 2 3 5 6 7", "1 2 -1 4 0"),
];

/// The curve that `eval` gives, by Bernstein's polynomials here: at both ends of each piece and inside.
#[test]
fn pieces_of_members_of_other_families_are_their_curves() {
    for (member, degree, knots, points) in MEMBERS {
        let on = [&["--degree", degree, "--knots", knots, "--points", points], member].concat();
        let found = bezier(&on);
        assert_eq!((&found["family"]["name"], found.get("alpha")), (&json!(member[1]), None));
        let pieces = found["pieces"].as_array().unwrap();
        assert!(!pieces.is_empty());
        for piece in pieces {
            let weights: Vec<_> = piece["weights"].as_array().unwrap().iter().map(number).collect();
            assert!(
                weights[0] == integer(1) && weights.iter().all(|weight| *weight > integer(0)),
                "{member:?}"
            );
            for (s, side) in [((0, 1), "right"), ((1, 3), "right"), ((4, 5), "left"), ((1, 1), "left")] {
                let s = rational(s.0, s.1);
                let x = number(&piece["from"]) + &s * (number(&piece["to"]) - number(&piece["from"]));
                let asked = x.to_string();
                let arguments =
                    [&["eval", "--format", "json", "--x", &asked, "--side", side], &on[..]].concat();
                let curve: Value = serde_json::from_str(&text(&arguments)).unwrap();
                let (last, rest) = (weights.len() - 1, integer(1) - &s);
                let sum = |of: &dyn Fn(usize) -> BigRational| -> BigRational {
                    (0..=last).map(|m| &weights[m] * bernstein(last, m, (&s, &rest)) * of(m)).sum()
                };
                for (c, expected) in curve["curve"].as_array().unwrap().iter().enumerate() {
                    let above = sum(&|m| number(&piece["points"][m][c]));
                    assert_eq!(above / sum(&|_| integer(1)), number(expected), "{member:?} at {x}, {side}");
                }
            }
        }
    }
}

/// Of p² : q² the denominator is 1 + u², so the weights of degree 2 would be 1, 0, 1; times 1 + u all are positive.
#[test]
fn the_degree_is_raised_until_the_weights_are_positive() {
    let found = bezier(&["--degree", "1", "--knots", "0 0 1 1", "--family", "square", "--points", "0 1"]);
    let piece = &found["pieces"][0];
    assert_eq!((&piece["degree"], &piece["weights"]), (&json!(3), &json!(["1", "1/3", "1/3", "1"])));
    assert_eq!(piece["points"], json!([["0"], ["0"], ["1"], ["1"]]));
}

/// With 1 − cu + u² the degree grows with the nearness of its roots to the half line u > 0.
#[test]
fn weights_that_become_positive_too_late_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("near.toml");
    let file = path.to_str().unwrap();
    let write = |c: &str| {
        let weight = format!("rise = \"(x - a)^2\"\nfall = \"(b - x)^2 - {c}*(x - a)*(b - x)\"");
        let text = format!("name = \"near\"\ntitle = \"near\"\nsource = \"a test\"\n[weight]\n{weight}\n");
        std::fs::write(&path, text).unwrap();
    };
    let on = ["--degree", "1", "--knots", "0 0 1 1", "--family", file, "--points", "1 -1"];
    write("1");
    // (1 − u + u²)(1 + u)³ = 1 + 2u + u² + u³ + 2u⁴ + u⁵, and two factors 1 + u are not enough.
    assert_eq!(bezier(&on)["pieces"][0]["weights"], json!(["1", "2/5", "1/10", "1/10", "2/5", "1"]));
    write("199999/100000");
    rejected(
        &on,
        "--family",
        &["on [0, 1] no rational Bézier curve of degree up to 300", "positive weights"],
    );
    write("2");
    rejected(&on, "--family", &["w[1,1] of the family near on [t_1, t_2]", "its denominator is 0"]);
}

#[test]
fn what_has_too_high_a_degree_is_refused() {
    let knots = "0 0 0 0 0 0 0 0 0 0 1 1 1 1 1 1 1 1 1 1";
    let on = ["--degree", "9", "--knots", knots, "--family", "smoothstep", "--points", "0 1 2 3 4 5 6 7 8 9"];
    rejected(&on, "--degree", &["quotients of degree up to 135 in x", "at most 120"]);
}

const OPEN: [&str; 6] = ["--degree", "2", "--knots", "0 0 0 1 2 2 2", "--alpha", "5"];
const POINTS: [&str; 2] = ["--points", "0,0 1,2 2,2 3,0"];

#[test]
fn all_fields_are_there_and_exact() {
    let found =
        bezier(&["--degree", "1", "--knots", "0 0 1 3 3", "--alpha", "-1", "--points", "0,1 4,5 6,7"]);
    let expected = json!({
        "schema": "knotproof.bezier/1",
        "version": env!("CARGO_PKG_VERSION"),
        "degree": 1,
        "knots": ["0", "0", "1", "3", "3"],
        "points": [["0", "1"], ["4", "5"], ["6", "7"]],
        "alpha": "-1",
        "dimension": 2,
        "order": 0,
        "pieces": [
            {"span": 1, "from": "0", "to": "1", "base": true, "degree": 1,
             "weights": ["1", "1/2"], "points": [["0", "1"], ["4", "5"]]},
            {"span": 2, "from": "1", "to": "3", "base": true, "degree": 1,
             "weights": ["1", "1/2"], "points": [["4", "5"], ["6", "7"]]},
        ],
    });
    assert_eq!(found, expected);
}

#[test]
fn text_is_a_table_for_each_piece() {
    let found = text(&[&["bezier"], &OPEN[..], &POINTS].concat());
    let expected = "\
Knots (0, 0, 0, 1, 2, 2, 2), degree 2, α = 5
2 rational Bézier curves of least degree. Each is equal to the curve for every x of its span (checked exactly).

[0, 1], degree 3
 m  weight   ≈            point           ≈
 0  1        1.000000000  (0, 0)          (0, 0)
 1  29/24    1.208333333  (20/29, 40/29)  (0.6896551724, 1.379310345)
 2  35/24    1.458333333  (33/28, 2)      (1.178571429, 2.000000000)
 3  225/128  1.757812500  (14/9, 2)       (1.555555556, 2.000000000)

[1, 2], degree 3
 m  weight   ≈            point           ≈
 0  1        1.000000000  (14/9, 2)       (1.555555556, 2.000000000)
 1  65/54    1.203703704  (24/13, 2)      (1.846153846, 2.000000000)
 2  625/432  1.446759259  (59/25, 32/25)  (2.360000000, 1.280000000)
 3  125/72   1.736111111  (3, 0)          (3.000000000, 0)
";
    assert_eq!(found, expected);
    let one = text(&["bezier", "--instance", "C6a", "--degree", "3", "--alpha", "-4"]);
    assert!(one.starts_with("Instance C6a (Fig. 23)\n"), "{one}");
    assert!(one.contains("1 rational Bézier curve of least degree. It is equal"), "{one}");
    assert!(!one.contains("Note"));
}

#[test]
fn the_classical_index_gives_polynomial_pieces() {
    let found = bezier(&["--instance", "C5", "--alpha", "inf"]);
    let pieces = found["pieces"].as_array().unwrap();
    assert_eq!(pieces.len(), 5);
    for piece in pieces {
        assert_eq!((&piece["degree"], &piece["weights"]), (&json!(3), &json!(["1", "1", "1", "1"])));
    }
}

#[test]
fn spans_outside_of_the_base_interval_are_marked() {
    let request = ["--degree", "1", "--knots", "0 1 2 3", "--alpha", "-1", "--points", "3 6"];
    let found = bezier(&request);
    let base: Vec<_> =
        found["pieces"].as_array().unwrap().iter().map(|piece| piece["base"].clone()).collect();
    assert_eq!(base, [false, true, false]);
    // d_0 φ(x, 0, 1): from 0 to d_0, and in the end from d_1 to 0.
    assert_eq!(found["pieces"][0]["points"], json!([["0"], ["3"]]));
    assert_eq!(found["pieces"][2]["points"], json!([["6"], ["0"]]));
    let text = text(&[&["bezier"], &request[..]].concat());
    assert!(text.contains("Note: spans marked * lie outside of [t_k, t_(n+1)]"), "{text}");
    assert!(text.contains("[0, 1] *, degree 1\n") && text.contains("[1, 2], degree 1\n"), "{text}");
}

#[test]
fn an_instance_file_is_converted() {
    let mut file = tempfile::NamedTempFile::new().unwrap();
    let content = r#"{"degree": 2, "knots": [0, 0, 0, 1, 1, 1], "alpha": 2, "points": [["0", 2, 1], [0.1, "3/2", 0], [1, 1, 1]]}"#;
    file.write_all(content.as_bytes()).unwrap();
    let found = bezier(&["--instance", file.path().to_str().unwrap()]);
    assert_eq!(found["dimension"], 3);
    assert_eq!(found["pieces"][0]["weights"], json!(["1", "2", "4"]));
    assert_eq!(found["pieces"][0]["points"][1], json!(["1/10", "3/2", "0"]));
}

#[test]
fn what_is_wrong_is_said() {
    rejected(
        &OPEN,
        "--points",
        &["--points is missing", "no curve without control points", "give 4, d_0 to d_3"],
    );
    rejected(&["--instance", "U4", "--alpha", "2"], "--points", &["give 5, d_0 to d_4"]);
    rejected(
        &[&OPEN[..], &["--points", "0 1"]].concat(),
        "--points",
        &["takes 4 control points", "here are 2"],
    );
    rejected(
        &["--instance", "C6a", "--alpha", "2"],
        "--instance",
        &["degrees 1, 2, 3", "choose one with --degree"],
    );
    rejected(&["--instance", "C5"], "--alpha", &["one index is wanted"]);
    rejected(&[&OPEN[..], &POINTS, &["--x", "1"]].concat(), "--x", &["unexpected argument"]);
    rejected(&[&OPEN[..4], &POINTS, &["--alpha", "1/2"]].concat(), "--alpha", &["lies in [0, 1]"]);
    let knots = (0..23).map(|t| t.to_string()).collect::<Vec<_>>().join(" ");
    let request = ["--degree", "11", "--knots", &knots, "--alpha", "2", "--points", "0 1 2 3 4 5 6 7 8 9 10"];
    rejected(&request, "--degree", &["11 is too high", "at most 10; a piece has degree"]);
}

#[test]
fn help_has_an_example() {
    let help = text(&["bezier", "--help"]);
    assert!(help.contains("Example") && help.contains("knotproof bezier --degree 2"), "{help}");
}

#[test]
fn the_highest_degree_is_converted() {
    let knots = [vec!["0"; 11], vec!["1"], vec!["3"; 11]].concat().join(" ");
    let request = ["--degree", "10", "--knots", &knots, "--alpha", "-1/7"];
    let found = bezier(&[&request[..], &["--points", "0 1 4 2 8 5 7 1 3 9 6 2"]].concat());
    assert_eq!(found["pieces"].as_array().unwrap().len(), 2);
}

/// r = 5/4: pieces of degree 1, joined at 1 with the weight 5/4.
#[test]
fn the_pieces_are_joined_to_one_curve() {
    let request =
        ["--degree", "1", "--knots", "0 0 1 3 3", "--alpha", "5", "--points", "0,1 4,5 6,7", "--as", "nurbs"];
    let expected = json!({
        "schema": "knotproof.bezier.nurbs/1",
        "version": env!("CARGO_PKG_VERSION"),
        "degree": 1,
        "knots": ["0", "0", "1", "3", "3"],
        "alpha": "5",
        "points": [["0", "1"], ["4", "5"], ["6", "7"]],
        "dimension": 2,
        "as": "nurbs",
        "base": ["0", "3"],
        "standard_form": false,
        "jumps": [],
        "curves": [{
            "degree": 1, "knots": ["0", "0", "1", "3", "3"], "weights": ["1", "5/4", "25/16"],
            "points": [["0", "1"], ["4", "5"], ["6", "7"]],
        }],
        "warnings": [],
    });
    assert_eq!(bezier(&request), expected);
    // In standard form with λ = 4/5 on both spans the weights are all 1; elevated, and cut.
    let standard = bezier(
        &[&request[..], &["--standard-form", "--degree-to", "2", "--from", "1/2", "--to", "2"]].concat(),
    );
    let curve = &standard["curves"][0];
    assert_eq!(
        (&curve["degree"], &curve["knots"]),
        (&json!(2), &json!(["1/2", "1/2", "1/2", "1", "1", "2", "2", "2"]))
    );
    assert_eq!(curve["weights"], json!(["1", "1", "1", "1", "1"]));
    assert_eq!(
        curve["points"],
        json!([["20/9", "29/9"], ["28/9", "37/9"], ["4", "5"], ["41/9", "50/9"], ["46/9", "55/9"]])
    );
    let change = |from, to, ratio| json!({"from": from, "to": to, "ratio": ratio, "weight": "1"});
    assert_eq!(curve["parameter"], json!([change("1/2", "1", "9/10"), change("1", "2", "8/9")]));
}

/// What is written is an instance: the source can be evaluated again.
#[test]
fn a_nurbs_result_turns_back_into_its_source() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("curve.json");
    let file = path.to_str().unwrap();
    let on = [&OPEN[..], &POINTS].concat();
    let written = text(&[&["bezier", "--format", "json", "--as", "nurbs", "--float"], &on[..]].concat());
    std::fs::write(&path, written).unwrap();
    let value = |on: &[&str]| text(&[&["eval", "--format", "json", "--x", "1/3"], on].concat());
    assert_eq!(value(&["--instance", file]), value(&on));
}

#[test]
fn files_for_other_programs_have_the_nearest_floats() {
    let request =
        ["--degree", "1", "--knots", "0 0 1/3 1/3 2 2", "--alpha", "-2", "--points", "0,1 1/3,5 7,0 1e-7,3"];
    let geomdl: Value = serde_json::from_str(&text_with_warning(&request, "geomdl")).unwrap();
    let data = &geomdl["shape"]["data"];
    assert_eq!((&geomdl["shape"]["count"], data.as_array().map(Vec::len)), (&json!(2), Some(2)));
    assert_eq!(data[0]["knotvector"], json!([0.0, 0.0, 1.0 / 3.0, 1.0 / 3.0]));
    assert_eq!(
        data[1]["control_points"],
        json!({"points": [[7.0, 0.0], [1e-7, 3.0]], "weights": [1.0, 2.0 / 3.0]})
    );
    let step = text_with_warning(&request, "step");
    for part in [
        "ISO-10303-21;\nHEADER;\n",
        "B_SPLINE_CURVE(1,(#18,#19),.UNSPECIFIED.,.F.,.F.)B_SPLINE_CURVE_WITH_KNOTS((2,2),(0.0,0.3333333333333333),",
        "RATIONAL_B_SPLINE_CURVE((1.0,0.6666666666666666))",
        "#22=CARTESIAN_POINT('',(1.E-7,3.0,0.0));\n",
        "#16=GEOMETRIC_CURVE_SET('',(#17,#20));\n",
    ] {
        assert!(step.contains(part), "{part} in {step}");
    }
    assert!(step.ends_with("ENDSEC;\nEND-ISO-10303-21;\n"), "{step}");
    // As JSON the same text is one field of the result.
    let object = bezier(&[&request[..], &["--as", "step"]].concat());
    assert_eq!((object["source"].as_str(), &object["jumps"]), (Some(&*step), &json!(["1/3"])));
}

/// The file, with the jump said on standard error.
fn text_with_warning(request: &[&str], form: &str) -> String {
    let output =
        knotproof(&[&["bezier", "--as", form], request].concat()).assert().success().get_output().clone();
    let warning = "warning: the curve jumps at 1/3: 2 NURBS curves, one for each connected run\n";
    assert_eq!(String::from_utf8(output.stderr).unwrap(), warning);
    String::from_utf8(output.stdout).unwrap()
}

#[test]
fn what_a_nurbs_curve_can_t_be_is_refused() {
    let on = [&OPEN[..], &POINTS, &["--as", "nurbs"]].concat();
    let also = |more: &[&'static str]| [&on[..], more].concat();
    rejected(
        &also(&["--degree-to", "2"]),
        "--degree-to",
        &["degree 2 is not between 3, the least", "and 300"],
    );
    rejected(&also(&["--from", "2"]), "--from", &["2 is not in [0, 2)"]);
    rejected(&also(&["--from", "1", "--to", "1"]), "--to", &["1 is not in (1, 2]"]);
    rejected(&also(&["--to", "x"]), "--to", &["x"]);
    for option in ["--standard-form", "--from=1", "--to=1", "--degree-to=4"] {
        rejected(&[&OPEN[..], &POINTS, &[option]].concat(), "--as", &["--as"]);
    }
    // Two knots that are one as floats; weights beyond the largest float.
    let near =
        ["--degree", "1", "--knots", "1 1 1.00000000000000000001 2 2", "--alpha", "2", "--points", "0 1 2"];
    rejected(
        &[&near[..], &["--as", "step"]].concat(),
        "--as",
        &["the knots 1 and 100000000000000000001/100000000000000000000 are one"],
    );
    let far = ["--degree", "1", "--knots", "0 0 1 2 2", "--alpha", "-1e-300", "--points", "0 1 2"];
    rejected(
        &[&far[..], &["--as", "geomdl"]].concat(),
        "--as",
        &["a weight does not fit", "--standard-form"],
    );
    assert!(
        text(&[&["bezier"], &far[..], &["--as", "geomdl", "--standard-form"]].concat())
            .contains("\"weights\"")
    );
}

/// Degree 28 is more than a widespread kernel takes; and weights can be too far apart.
#[test]
fn what_other_programs_may_not_bear_is_said() {
    let knots = "0 0 0 0 0 0 0 0 1 3 4 8 9 11 13 13 13 13 13 13 13 13";
    let points = "0 1 2 3 4 5 6 7 8 9 0 1 2 3";
    let on = ["--degree", "7", "--knots", knots, "--alpha", "100/99", "--points", points, "--as", "nurbs"];
    let found = bezier(&on);
    let warnings: Vec<_> =
        found["warnings"].as_array().unwrap().iter().map(|text| text.as_str().unwrap()).collect();
    assert!(warnings[0].starts_with("degree 28 is above 25, the highest that Open CASCADE"), "{warnings:?}");
    assert!(warnings[1].contains("times apart; --standard-form brings them closer"), "{warnings:?}");
}

#[derive(Deserialize)]
struct Golden {
    source: String,
    cases: Vec<Case>,
}

#[derive(Deserialize)]
struct Case {
    degree: usize,
    knots: Vec<String>,
    alpha: String,
    points: Value,
    pieces: Value,
}

/// Against `tests/golden/bezier.json`, which an implementation of its own wrote: see `generate_bezier.py` there.
#[test]
fn another_implementation_finds_the_same_pieces() {
    let golden: Golden = serde_json::from_str(include_str!("golden/bezier.json")).unwrap();
    assert_eq!(golden.source, "tests/golden/generate_bezier.py");
    assert!(golden.cases.len() >= 60);
    for case in golden.cases {
        let (degree, knots, points) =
            (case.degree.to_string(), case.knots.join(" "), case.points.to_string());
        let request = ["--degree", &degree, "--knots", &knots, "--alpha", &case.alpha, "--points", &points];
        assert_eq!(bezier(&request)["pieces"], case.pieces, "{request:?}");
    }
}
