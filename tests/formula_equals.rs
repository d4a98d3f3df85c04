//! `knotproof formula --equals`: is what somebody wrote the function?

#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests")]

use std::fs;

use serde_json::{Value, json};

/// Runs the command on a text; exit code, standard output and standard error.
fn run(text: &str, arguments: &[&str]) -> (i32, String, String) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("formulas.mac");
    fs::write(&path, text).unwrap();
    let mut command = crate::program();
    let output = command.arg("formula").args(arguments).arg("--equals").arg(&path).output().unwrap();
    let [out, err] = [output.stdout, output.stderr].map(|bytes| String::from_utf8(bytes).unwrap());
    (output.status.code().unwrap(), out, err)
}

fn json(text: &str, arguments: &[&str]) -> (i32, Value) {
    let (code, out, err) = run(text, &[arguments, &["--format", "json"]].concat());
    (code, serde_json::from_str(if out.is_empty() { &err } else { &out }).unwrap())
}

const HAT: [&str; 6] = ["--degree", "1", "--knots", "0 1 3", "--alpha", "-1"];
const EVERY: [&str; 6] = ["--degree", "1", "--knots", "0 1 3", "--alpha", "symbolic"];
const STEPS: [&str; 6] = ["--degree", "0", "--knots", "0 1 2", "--alpha", "inf"];

fn hat(index: &'static str) -> Vec<&'static str> {
    [&HAT[..], &["--index", index]].concat()
}

/// Worked out by hand: with α = −1, G_0 is x/(2 − x) on [0, 1) and, with w = (x − 1)/(5 − x), 1 − w = (6 − 2x)/(5 − x) on
/// [1, 3].
#[test]
fn equal_in_every_way_of_writing_it() {
    for text in [
        "if 0 <= x and x < 1 then x/(2 - x) elseif 1 <= x and x <= 3 then 2*(3 - x)/(5 - x) else 0",
        "G_0(x) := if x < 0 or x > 3 then 0 else if x <= 1 then -x/(x - 2) else (6 - 2*x)/(5 - x)$",
        "/* w and\n 1 - w */ if (x >= 0) and (not (x >= 1)) then 1/(2/x - 1) elseif x >= 1 and 3 >= x then 1 - (x-1)/(5-x) else 0;",
        "if 2*x < 0 then 0 elseif x - 1 < 0 then x*(2 - x)^-1 elseif x <= 6/2 then --2*(3.0 - x)**1/(5 - x) else 0*x^2",
        "(if 0 <= x and x < 1 then x^2 else 0)/(x*(2-x)) + (if x >= 1 and x <= 3 then (6 - 2*x)/(5 - x) else 0)",
        "if 0 <= x and x < 1 then r*x/(r*x + 1 - x) elseif x >= 1 and x <= 3 then (3-x)/(r*(x - 1) + 3 - x) else 0",
        "if 0 <= x and x < 1 then alpha*x/(x + alpha - 1) elseif x >= 1 and x <= 3 then 2*(x - 3)/(x - 5) else 0",
    ] {
        let (code, found) = json(text, &hat("0"));
        assert_eq!((code, &found["equal"]), (0, &json!(true)), "{text}: {found}");
        assert_eq!(found["functions"], json!([{ "index": 0, "equal": true }]), "{text}");
    }
    let every = "G_0(x, alpha) := if 0 <= x and x < 1 then alpha*x/(x + alpha - 1) \
                 elseif 1 <= x and x <= 3 then (3 - x)/(r*(x - 1) + 3 - x) else 0$";
    let (code, out, _) = run(every, &EVERY);
    assert_eq!((code, out.trim()), (0, "G_0: equal for every x and every alpha < 0 and alpha > 1"));
}

#[test]
fn one_expression_on_one_span() {
    let on = |span: &'static str| [&hat("0")[..], &["--span", span]].concat();
    assert_eq!(run("x/(2 - x)", &on("0")).1.trim(), "G_0: equal for every x between 0 and 1");
    assert_eq!(run("2*(3 - x)/(5 - x)", &on("1")).0, 0);
    let (code, found) = json("x/(2 - x)", &on("1"));
    let point = json!({ "x": "3", "expression": "-3", "function": "0" });
    assert_eq!((code, &found["functions"][0]["interval"]), (1, &json!(["1", "3"])));
    // The first knot of the span is no difference: there x/(2 − x) is 1, as G_0.
    assert_ne!(found["functions"][0]["point"]["x"], "1", "{found}, not {point}");
    let (code, _, error) = run("x", &on("2"));
    assert!(code == 2 && error.contains("--span") && error.contains("0, 1"), "{error}");
}

/// What is not equal is so at a point that can be checked by hand.
#[test]
fn not_equal_at_a_point() {
    for (text, index, point) in [
        // x/(2 − x) = 1/3 at 1/2; −x²… at 1/2; the second piece at its limit; the ends of intervals.
        (
            "if 0 <= x and x < 1 then x elseif x >= 1 and x <= 3 then 2*(3 - x)/(5 - x) else 0",
            0,
            json!({ "x": "1/2", "expression": "1/2", "function": "1/3" }),
        ),
        (
            "if 0 <= x and x < 1 then x/(2 - x) elseif x > 1 and x <= 3 then 2*(3 - x)/(5 - x) else 0",
            0,
            json!({ "x": "1", "expression": "0", "function": "1" }),
        ),
        (
            "if 0 <= x and x < 1 then x/(2 - x) elseif x >= 1 and x <= 4 then 2*(3 - x)/(5 - x) else 0",
            0,
            json!({ "x": "7/2", "expression": "-2/3", "function": "0" }),
        ),
        (
            "if 0 < x and x < 1 then x/(2 - x) elseif x >= 1 and x < 3 then 2*(3 - x)/(5 - x) else 1/x",
            0,
            json!({ "x": "-1", "expression": "-1", "function": "0" }),
        ),
    ] {
        let (code, found) = json(text, &hat("0"));
        assert_eq!((code, &found["equal"]), (1, &json!(false)), "{text}");
        assert_eq!(found["functions"][index]["point"], point, "{text}: {found}");
    }
    // A half-open end is a difference of one point.
    let (code, out, _) = run(
        "G_0(x) := if 0 <= x and x <= 1 then 1 else 0$ G_1(x) := if 1 <= x and x <= 2 then 1 else 0$",
        &STEPS,
    );
    let expected = "G_0: not equal at x = 1: the expression is 1, and G_0 is 0\nG_1: equal for every x\n";
    assert_eq!((code, out.as_str()), (1, expected));
    // A pole, on a knot and off it.
    let pole = "if 0 <= x and x < 1 then 1/(x - 0) elseif x >= 1 and x <= 2 then 0 else 0";
    let (code, found) = json(pole, &[&STEPS[..], &["--index", "0"]].concat());
    assert_eq!(
        (code, &found["functions"][0]["point"]),
        (1, &json!({ "x": "0", "expression": null, "function": "1" }))
    );
    // With a letter: the sign of alpha.
    let (code, found) = json(
        "G_0(x, alpha) := if 0 <= x and x < 1 then -alpha*x/(x + alpha - 1) elseif 1 <= x and x <= 3 then 0 else 0$",
        &EVERY,
    );
    let point = &found["functions"][0]["point"];
    assert_eq!((code, &point["x"], &point["alpha"]), (1, &json!("1/2"), &json!("-1")));
    assert_eq!((&point["expression"], &point["function"]), (&json!("-1/3"), &json!("1/3")));
}

#[test]
fn what_was_not_compared_is_said() {
    let basis = ["--instance", "U4", "--alpha", "-1"];
    let all = crate::program().arg("formula").args(basis).args(["--as", "maxima"]).output();
    let all = String::from_utf8(all.unwrap().stdout).unwrap();
    let (code, found) = json(&all, &basis);
    assert_eq!((code, &found["equal"], &found["not_compared"]), (0, &json!(true), &json!([])));
    assert_eq!(found["schema"], "knotproof.formula.equals/1");
    let (code, out, _) = run(&all, &[&basis[..], &["--index", "3"]].concat());
    assert_eq!((code, out.as_str()), (0, "G_3: equal for every x\nNot compared: G_0, G_1, G_2, G_4\n"));
    let (code, _, error) = run("G_1(x) := x$", &[&basis[..], &["--index", "3"]].concat());
    assert!(code == 2 && error.contains("no definition of G_3"), "{error}");
}

#[test]
fn what_cannot_be_read_says_where() {
    for (text, place, part) in [
        ("", "line 1, column 1", "an expression"),
        ("x +", "line 1, column 4", "found the end of the text"),
        ("x\n + y", "line 2, column 4", "found `y`"),
        ("(x", "line 1, column 3", "`)`"),
        ("x)", "line 1, column 2", "the end"),
        ("2 x", "line 1, column 3", "an operator"),
        ("x^(1/2)", "line 1, column 3", "a whole number"),
        ("x^alpha", "line 1, column 3", "a whole number"),
        ("x^101", "line 1, column 3", "too large"),
        ("x^99999999999999999999", "line 1, column 3", "too large"),
        ("if x < 1 then x", "line 1, column 16", "`else`"),
        ("if x then x else 0", "line 1, column 6", "one of <"),
        ("if x^2 < 1 then x else 0", "line 1, column 4", "first power"),
        ("if alpha < 1 then x else 0", "line 1, column 4", "numbers and x"),
        ("x /* no end", "line 1, column 3", "no end"),
        ("1/(x - x)", "line 1, column 3", "the divisor is 0"),
        ("0^-1", "line 1, column 1", "the divisor is 0"),
        ("1.2.3", "line 1, column 1", ""),
        ("sqrt(x)", "line 1, column 1", "found `sqrt`"),
        ("x; x", "line 1, column 4", "the end"),
        ("G_0(x) := x$ G_0(x) := x$", "line 1, column 14", "different i"),
        ("G_x(x) := x$", "line 1, column 1", "a number i"),
        ("G_0(y) := x$", "line 1, column 5", "`x`"),
        ("(x + 1)^61", "line 1, column 1", "degree is too high"),
        ("((9^100)^100)^100", "line 1, column 1", "too long"),
        ("\u{1b}[31m x", "line 1, column 1", "found"),
    ] {
        let (code, out, error) = run(text, &hat("0"));
        assert_eq!((code, out.as_str()), (2, ""), "{text}: {error}");
        assert!(
            error.contains(place) && error.contains(part) && error.contains("--equals"),
            "{text}: {error}"
        );
        assert!(!error.contains("\u{1b}[31m x") && error.trim_end().ends_with('^'), "{text}: {error}");
    }
    // The mark stands below the place.
    let (_, _, error) = run("x + 2 y", &hat("0"));
    let lines: Vec<_> = error.lines().collect();
    assert_eq!(lines[1].find('y'), lines[2].find('^'), "{error}");
    let (code, _, error) = run("G_0(x) := 0$ G_9(x) := x$", &HAT);
    assert!(code == 2 && error.contains("line 1, column 14: there is no function 9"), "{error}");
    let (code, _, error) = run("x", &HAT);
    assert!(code == 2 && error.contains("--index"), "{error}");
}

/// No text makes it overflow its stack, or work for minutes.
#[test]
fn nothing_is_too_deep_or_too_long() {
    let many = |part: &str| part.repeat(100_000);
    let texts = [
        many("(") + "x",
        many("-") + "x",
        many("+") + "x",
        "2".to_owned() + &many("^2"),
        many("if x<1 then "),
        many("if x<1 then 1 else "),
        "if ".to_owned() + &many("not ") + "x<1 then 1 else 0",
        "if ".to_owned() + &many("("),
        many("if (("),
        many("x+") + "x",
        many("x*") + "x",
        many("1/(x+1)+") + "x",
        "9".repeat(1_000_000),
        many("(x+1)*") + "1",
        "if ".to_owned() + &many("x<1 or ") + "x<2 then 1 else 0",
        "(1+x)^60*".to_owned() + &many("(1+x)^60/(1+x)^60*") + "1",
        "if x<1 then 1 else ".to_owned() + &"(if x<1 then 1 else ".repeat(99) + "1",
        many("/* */") + "x",
    ];
    for text in texts {
        let (code, _, _) = run(&text, &hat("0"));
        assert!(code == 1 || code == 2, "{}: {code}", &text[..20]);
    }
    // Another basis that is equal has the same formulas in a longer way: that is no reason to give up.
    let sum = "if 0 <= x and x < 1 then (".to_owned()
        + &"x/(2-x)+".repeat(500)
        + "0)/500 elseif x >= 1 and x <= 3 then 2*(3-x)/(5-x) else 0";
    assert_eq!(run(&sum, &hat("0")).0, 0);
}
