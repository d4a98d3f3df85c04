//! The command `float`: its figures, its commands, its errors.

#![allow(clippy::unwrap_used, reason = "helpers of tests")]

use serde_json::Value;

fn run(arguments: &[&str]) -> (i32, Value, String) {
    let mut command = crate::program();
    let output = command.arg("float").args(arguments).args(["--format", "json"]).output().unwrap();
    let json = serde_json::from_slice(if output.stdout.is_empty() { &output.stderr } else { &output.stdout });
    (output.status.code().unwrap(), json.unwrap(), String::from_utf8(output.stderr).unwrap())
}

#[test]
fn every_formula_has_its_figures_and_its_worst_case() {
    let (code, found, _) = run(&["--degree", "2", "--count", "20", "--steps", "100", "--seed", "5"]);
    assert_eq!((code, &found["schema"]), (0, &"knotproof.float/1".into()));
    let names: Vec<_> =
        found["formulas"].as_array().unwrap().iter().map(|of| of["name"].as_str().unwrap()).collect();
    assert_eq!(names, ["paper", "ratio", "triangle", "fast", "accurate"]);
    for of in found["formulas"].as_array().unwrap() {
        for field in ["max_ulp", "p99_ulp", "median_ulp", "max_absolute", "max_sum"] {
            assert!(of[field].as_str().unwrap().parse::<f64>().unwrap() >= 0.0, "{of}");
        }
        is_shown_again(of);
    }
}

/// The command that is printed finds the same error again.
fn is_shown_again(of: &Value) {
    let worst = &of["worst"];
    let command = worst["reproduce"].as_str().unwrap().strip_prefix("knotproof float ").unwrap();
    let quoted: Vec<&str> = command.split('"').collect();
    let mut arguments: Vec<&str> = quoted[0].split_whitespace().collect();
    arguments.push(quoted[1]);
    arguments.extend(quoted[2].split_whitespace());
    let (_, again, _) = run(&arguments);
    let again =
        again["formulas"].as_array().unwrap().iter().find(|other| other["name"] == of["name"]).unwrap();
    assert_eq!(again["max_ulp"], of["max_ulp"]);
    assert_eq!(again["worst"], *worst);
}

#[test]
fn an_instance_is_measured_for_all_its_indices() {
    let (code, found, _) = run(&["--instance", "U4", "--count", "20", "--steps", "50"]);
    assert_eq!((code, &found["degree"]), (0, &2.into()));
    let (_, same, _) = run(&["--instance", "U4", "--count", "20", "--steps", "50"]);
    assert_eq!(found, same);
}

/// One ratio for all intervals is an index: its formulas, in the same floats. A search would see the weights in other pairs.
#[test]
fn a_member_that_is_an_index_has_its_figures() {
    let on = ["--degree", "3", "--knots", "0 0 0 0 1 2 7/2 4 4 4 4", "--steps", "0"];
    let two = "rho=2,2,2,2,2,2,2,2,2,2,2;2,2,2,2,2,2,2,2,2,2;2,2,2,2,2,2,2,2,2";
    let (code, member, _) = run(&[&on[..], &["--family", "free-ratios", "--set", two]].concat());
    let (_, index, _) = run(&[&on[..], &["--alpha", "2"]].concat());
    assert_eq!((code, &member["family"]["name"]), (0, &serde_json::json!("free-ratios")));
    let names: Vec<_> = member["formulas"].as_array().unwrap().iter().map(|of| of["name"].clone()).collect();
    assert_eq!(names, ["ratio", "triangle"]);
    for name in ["ratio", "triangle"] {
        let (own, other) = (of(&member, name), of(&index, name));
        for field in ["tried", "max_ulp", "p99_ulp", "median_ulp", "max_absolute", "max_sum", "sign_errors"] {
            assert!(own[field] == other[field] && !own[field].is_null(), "{name}, {field}");
        }
        assert!(own.get("bound_ulp").is_none(), "nothing is proved");
    }
}

/// Numbers that f64 does not have are rounded, and the worst case is shown again by its command.
#[test]
fn the_worst_case_of_a_member_is_shown_again() {
    let on = ["--degree", "2", "--knots", "0 0 0 1/3 2 2 2", "--steps", "200", "--count", "50"];
    let arguments = [&on[..], &["--family", "lupas", "--set", "q=1/3"]].concat();
    let (code, found, _) = run(&arguments);
    let rounded: Vec<_> = found["rounded"].as_array().unwrap().iter().map(|of| of["what"].clone()).collect();
    assert_eq!((code, rounded), (0, vec!["t_3".into(), "q".into()]));
    for name in ["ratio", "triangle"] {
        let worst = &of(&found, name)["worst"];
        assert_eq!(worst["float"]["family"]["parameters"]["q"], "0x1.5555555555555p-2");
        is_shown_again(of(&found, name));
    }
    let told = text(&arguments);
    assert!(
        told.contains("degree 2, family lupas, q = 1/3") && told.contains("No bound is proved"),
        "{told}"
    );
}

fn text(arguments: &[&str]) -> String {
    let mut command = crate::program();
    let output = command.arg("float").args(arguments).output().unwrap();
    String::from_utf8(output.stdout).unwrap()
}

fn of<'a>(found: &'a Value, name: &str) -> &'a Value {
    found["formulas"].as_array().unwrap().iter().find(|of| of["name"] == name).unwrap()
}

/// Out of the range of its bound the triangle returns NaN: that is its worst case, and no bound is printed.
#[test]
fn a_result_that_is_no_number_is_the_worst_case() {
    for (degree, knots, alpha, x, count, index) in [
        ("2", "0 0 0 1e-310 2e-310 2e-310 2e-310", "-1", "1.5e-310", 3, 1..=3),
        ("1", "0 0 1e-308 1e-308", "-1", "1e-308", 2, 0..=1),
        ("1", "0 0 2e-308 2e-308", "-1e-300", "2e-308", 2, 0..=1),
        ("1", "-9e307 -9e307 9e307 9e307", "2", "9e307", 1, 0..=1),
    ] {
        let arguments = ["--degree", degree, "--knots", knots, "--alpha", alpha, "--x", x];
        let (code, found, _) = run(&arguments);
        assert_eq!(code, 1, "{found}");
        let triangle = of(&found, "triangle");
        assert_eq!((&triangle["not_finite"], &triangle["max_ulp"]), (&count.into(), &"inf".into()));
        assert!(index.contains(&triangle["worst"]["index"].as_u64().unwrap()), "{triangle}");
        assert!(triangle.get("bound_ulp").is_none());
        let range = &triangle["bound_range"];
        assert_eq!((&range["outside"], &range["measured"]), (&1.into(), &1.into()));
        for name in ["fast", "accurate"] {
            let ours = of(&found, name);
            assert!(
                ours["not_finite"] == 0 && ours["bound_ulp"].is_f64() && ours.get("bound_range").is_none()
            );
        }
        let text = text(&arguments);
        assert!(text.contains("does not apply here") && text.contains("worse than any bound"), "{text}");
        assert!(text.contains("between 2^-100 and 2^100; not so in 1 of 1 cases"), "{text}");
    }
}

/// A formula without a bound breaks too: on knots that were given that counts.
#[test]
fn the_papers_formula_may_return_no_number() {
    let arguments = ["--degree", "1", "--knots", "0 0 1e300 1e300", "--alpha", "1e300", "--x", "1e300"];
    let (code, found, _) = run(&arguments);
    let broken: Vec<_> =
        found["formulas"].as_array().unwrap().iter().filter(|of| of["max_ulp"] == "inf").collect();
    assert_eq!((code, broken.is_empty(), &broken[0]["name"]), (1, false, &"paper".into()));
    assert!(of(&found, "paper").get("bound_range").is_none());
}

/// Where the range holds the bound is printed, rounded up, and named as what it is.
#[test]
fn what_was_found_and_what_is_proved_have_words_of_their_own() {
    let arguments = ["--degree", "2", "--count", "20", "--steps", "100"];
    let (code, found, _) = run(&arguments);
    assert_eq!((code, &of(&found, "triangle")["tried"]), (0, &120.into()));
    assert_eq!(of(&found, "triangle")["bound_ulp"], 18.0);
    assert!(
        of(&found, "paper").get("bound_ulp").is_none() && of(&found, "paper").get("bound_range").is_none()
    );
    let text = text(&arguments);
    for part in ["largest found (of 120 tried)", "proved to be at most", "0.5001"] {
        assert!(text.contains(part), "{text}");
    }
    assert!(!text.contains("rounded") && !text.contains("Left out"), "{text}");
}

#[test]
fn input_that_was_rounded_is_said() {
    let merged =
        ["--degree", "1", "--knots", "0 1 1.00000000000000000001 2", "--alpha", "1e400", "--x", "1/3"];
    let (_, found, _) = run(&merged);
    let rounded = found["rounded"].as_array().unwrap();
    let whats: Vec<_> = rounded.iter().map(|of| of["what"].as_str().unwrap()).collect();
    assert_eq!(whats, ["t_2", "alpha", "x"]);
    assert_eq!(rounded[0]["exact"], "100000000000000000001/100000000000000000000");
    assert_eq!((&rounded[0]["float"], &rounded[1]["float"]), (&"0x1p0".into(), &"inf".into()));
    assert_eq!(rounded[2]["float"], "0x1.5555555555555p-2");
    assert_eq!(found["merged"], serde_json::json!([[1, 2]]));
    let text = text(&merged);
    for part in [
        "t_2 became 0x1p0, which is 1.00000e-20 away",
        "alpha = 1.00000e400 became inf",
        "t_1 and t_2 were different, and are the same now",
    ] {
        assert!(text.contains(part), "{text}");
    }
    let (_, found, _) = run(&["--degree", "1", "--knots", "0 1e-400 1 2", "--alpha", "-1", "--x", "1/2"]);
    assert_eq!(found["merged"], serde_json::json!([[0, 1]]));
    let (_, found, _) = run(&["--degree", "1", "--knots", "0 1/2 1 2", "--alpha", "-1", "--x", "1/2"]);
    assert_eq!((&found["rounded"], &found["merged"]), (&serde_json::json!([]), &serde_json::json!([])));
}

#[test]
fn values_next_to_underflow_are_counted() {
    let arguments = ["--degree", "1", "--knots", "0 0 1 1", "--alpha", "-1", "--x", "5e-324"];
    let (code, found, _) = run(&arguments);
    assert_eq!(code, 0);
    for name in ["paper", "ratio", "triangle", "fast", "accurate"] {
        assert_eq!(of(&found, name)["left_out"], 1);
        assert_eq!(of(&found, name)["sign_errors"], usize::from(!["fast", "accurate"].contains(&name)));
    }
    assert!(text(&arguments).contains("Left out are exact values below 2^-900"));
    let help = crate::program().args(["float", "--help"]).output().unwrap().stdout;
    assert!(String::from_utf8(help).unwrap().contains("below 2^-900"));
}

#[test]
fn a_point_outside_has_nothing_to_measure() {
    let arguments = ["--degree", "1", "--knots", "0 0 1 1", "--alpha", "-1", "--x", "3"];
    assert_eq!(run(&arguments).1["formulas"], serde_json::json!([]));
    assert!(text(&arguments).contains("x is outside of [t_0, t_m]"));
}

/// A map over the widest range that there is: its length is no float.
#[test]
fn maps_of_extreme_knots_are_drawn() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().to_str().unwrap();
    let knots = "-9e307 -9e307 9e307 9e307";
    run(&["--degree", "1", "--knots", knots, "--alpha", "2", "--count", "1", "--steps", "0", "--out", out]);
    for name in ["paper", "triangle", "accurate"] {
        let svg = std::fs::read_to_string(folder.path().join(format!("error-{name}.svg"))).unwrap();
        assert!(svg.matches("<rect").count() > 2 * 72 * 36 && !svg.contains("NaN"), "{}", svg.len());
    }
}

#[test]
fn what_floats_cannot_hold_is_refused() {
    for (arguments, argument) in [
        (&["--degree", "1", "--knots", "0 1 2", "--alpha", "1.00000000000000000001"][..], "--alpha"),
        (&["--degree", "1", "--knots", "0 1 1e400", "--alpha", "2"], "--knots"),
        (&["--degree", "1", "--knots", "0 1 2", "--alpha", "1/2"], "--alpha"),
        (&["--degree", "1", "--knots", "0 1 2", "--alpha", "2", "--x", "1e400"], "--x"),
        (&["--degree", "40"], "--degree"),
        (&["--degree", "3", "--count", "0"], "--count"),
        (&["--degree", "3", "--x", "1"], "--knots"),
        (&["--degree", "3", "--alpha", "-1"], "--knots"),
        (&[], "--degree"),
    ] {
        let (code, error, _) = run(arguments);
        assert_eq!(code, 2, "{arguments:?}");
        assert!(error["error"]["message"].as_str().unwrap().contains(argument), "{error}");
    }
}
