//! `knotproof formula` as a user meets it: what it prints is read again and evaluated.

#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests")]

use assert_cmd::Command;
use knotproof::scalar::{BigRational, RationalAlgebra, Ring, integer, parse_rational, rational};
use knotproof::spline::{Basis, KnotVector, Side};
use serde_json::{Value, json};

fn knotproof(arguments: &[&str]) -> Command {
    let mut command = crate::program();
    command.arg("formula").args(arguments);
    command
}

fn text(arguments: &[&str]) -> String {
    let output = knotproof(arguments).assert().success().stderr("").get_output().stdout.clone();
    String::from_utf8(output).unwrap()
}

fn formula(arguments: &[&str]) -> Value {
    serde_json::from_str(&text(&[arguments, &["--format", "json"]].concat())).unwrap()
}

/// Runs the request as text and as JSON, and checks that each message contains all of `parts`.
fn rejected(arguments: &[&str], argument: &str, parts: &[&str]) {
    let output = knotproof(arguments).assert().code(2).stdout("").get_output().stderr.clone();
    let message = String::from_utf8(output).unwrap();
    assert!(parts.iter().all(|part| message.contains(part)), "{parts:?} in {message}");
    let arguments = [arguments, &["--format", "json"]].concat();
    let output = knotproof(&arguments).assert().code(2).stdout("").get_output().stderr.clone();
    let report: Value = serde_json::from_slice(&output).unwrap();
    assert_eq!(report["error"]["argument"], json!(argument));
}

/// Reads sums, products, powers, numbers, `x` and `alpha`, and nothing else.
struct Reader<'a> {
    rest: &'a str,
    x: &'a BigRational,
    alpha: &'a BigRational,
}

impl Reader<'_> {
    fn takes(&mut self, token: &str) -> bool {
        let rest = self.rest.trim_start();
        rest.strip_prefix(token).map(|rest| self.rest = rest).is_some()
    }

    fn sum(&mut self) -> BigRational {
        let mut value = if self.takes("-") { self.product().negate() } else { self.product() };
        loop {
            if self.takes("+") {
                value += self.product();
            } else if self.takes("-") {
                value -= self.product();
            } else {
                return value;
            }
        }
    }

    fn product(&mut self) -> BigRational {
        let mut value = self.power();
        loop {
            if self.takes("*") {
                value *= self.power();
            } else if self.takes("/") {
                value = value.over(&self.power()).expect("a denominator other than 0");
            } else {
                return value;
            }
        }
    }

    fn power(&mut self) -> BigRational {
        let base = self.atom();
        if self.takes("^") { base.power(self.digits().parse().unwrap()) } else { base }
    }

    fn atom(&mut self) -> BigRational {
        if self.takes("alpha") {
            self.alpha.clone()
        } else if self.takes("x") {
            self.x.clone()
        } else if self.takes("(") {
            let value = self.sum();
            assert!(self.takes(")"), "{}", self.rest);
            value
        } else {
            parse_rational(&self.digits()).unwrap()
        }
    }

    fn digits(&mut self) -> String {
        let rest = self.rest.trim_start();
        let end = rest.find(|c: char| !c.is_ascii_digit()).unwrap_or(rest.len());
        self.rest = &rest[end..];
        rest[..end].to_owned()
    }
}

fn value(text: &str, x: &BigRational, alpha: &BigRational) -> BigRational {
    let mut reader = Reader { rest: text, x, alpha };
    let value = reader.sum();
    assert_eq!(reader.rest.trim(), "", "all of {text} is read");
    value
}

fn number(value: &Value) -> BigRational {
    parse_rational(value.as_str().unwrap()).unwrap()
}

const BASES: [(&str, usize); 4] = [
    ("0 0 0 1 2 3 3 3", 2),
    ("-1 -1/3 0 0 2/5 13/5 3 7/2", 3),
    ("0 0 0 3/4 3/4 3/4 3 3 3", 2),
    ("0 0 0 0 1 1 1 1", 1),
];

/// Members of families that are not those of an index: what chooses them, the degree, and knots that they are for.
const MEMBERS: [(&[&str], &str, &str); 6] = [
    (&["--family", "smoothstep"], "2", "0 0 0 1/2 2 3 3 3"),
    (&["--family", "square"], "3", "0 1 2 4 5 7 8 9"),
    (&["--family", "lupas", "--set", "q=1/2"], "2", "0 0 0 1 2 2 2"),
    (&["--family", "phillips", "--set", "q=3"], "3", "0 0 0 0 1 1 1 1"),
    (&["--family", "nurbs", "--set", "omega=1,2,1/2,3"], "2", "0 0 0 1 2 2 2"),
    (&["--family", "knot-weights", "--set", "omega=1,2,1/2,3,1,1,2,5"], "2", "0 1 2 2 3 5 6 7"),
];

/// Also where a function is negative: that of Phillips for q > 1.
#[test]
fn members_of_other_families_have_the_values_of_eval() {
    let mut compared = 0;
    for (member, degree, knots) in MEMBERS {
        let on = [&["--degree", degree, "--knots", knots], member].concat();
        let forms = ["--factored", "--expanded"].map(|form| formula(&[&on[..], &[form]].concat()));
        for found in &forms {
            assert_eq!((&found["family"]["name"], found.get("alpha")), (&json!(member[1]), None));
        }
        for x in ["-1", "0", "1/3", "1/2", "9/10", "1", "7/4", "2", "5/2", "9"] {
            let mut eval = crate::program();
            let eval = eval.args(["eval", "--format", "json", "--x", x]).args(&on).assert().success();
            let values: Value = serde_json::from_slice(&eval.get_output().stdout).unwrap();
            let values: Vec<_> = values["values"].as_array().unwrap().iter().map(number).collect();
            let x = parse_rational(x).unwrap();
            for found in &forms {
                let mut own = vec![integer(0); values.len()];
                for piece in found["pieces"].as_array().unwrap() {
                    let (from, to) = (number(&piece["from"]), number(&piece["to"]));
                    if from <= x && (x < to || piece["closed"] == true && x == to) {
                        let [p, q] = ["numerator", "denominator"]
                            .map(|part| value(piece[part].as_str().unwrap(), &x, &integer(0)));
                        own[usize::try_from(piece["index"].as_u64().unwrap()).unwrap()] = p / q;
                    }
                }
                assert_eq!(own, values, "{member:?} at {x}");
                compared += values.len();
            }
        }
    }
    assert!(compared > 400, "{compared}");
}

/// What Maxima reads is what --equals reads, and linear forms with one ratio are an index.
#[test]
fn formulas_of_a_member_are_compared() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("functions.mac");
    let file = path.to_str().unwrap();
    let on = ["--degree", "2", "--knots", "0 0 0 1 3 3 3"];
    let free = ["--family", "free-ratios", "--set", "rho=2,2,2,2,2,2;2,2,2,2,2"];
    let maxima = text(&[&on[..], &free, &["--as", "maxima"]].concat());
    std::fs::write(&path, &maxima).unwrap();
    let compare = |member: &[&str]| {
        let arguments = [&on[..], member, &["--equals", file]].concat();
        let output = knotproof(&arguments).output().unwrap();
        (output.status.code().unwrap(), String::from_utf8(output.stdout).unwrap())
    };
    for member in [&free[..], &["--alpha", "2"]] {
        let (code, told) = compare(member);
        assert!(code == 0 && told.matches("equal for every x").count() == 4, "{told}");
    }
    let (code, told) = compare(&["--family", "lupas", "--set", "q=2"]);
    assert!(code == 1 && told.contains("not equal at x = "), "{told}");
    std::fs::write(&path, "G_0(x) := alpha*x$").unwrap();
    let arguments = [&on[..], &free, &["--equals", file]].concat();
    let output = knotproof(&arguments).assert().code(2).get_output().stderr.clone();
    let told = String::from_utf8(output).unwrap();
    assert!(told.contains("free-ratios, rho = 2") && told.contains("have no index"), "{told}");
}

/// The pieces of the JSON, and the lines of the text, have the values of the functions.
#[test]
fn what_is_printed_has_the_values_of_the_functions() {
    let mut compared = 0;
    for (list, degree) in BASES {
        let knots: Vec<_> = list.split(' ').map(|t| parse_rational(t).unwrap()).collect();
        let knots = KnotVector::new(knots).unwrap();
        let degree_text = degree.to_string();
        for (asked, alpha) in
            [("-1", "-1"), ("5", "5"), ("inf", "inf"), ("symbolic", "-1/7"), ("symbolic", "9/8")]
        {
            for form in ["--factored", "--expanded"] {
                let arguments = ["--degree", &degree_text, "--knots", list, "--alpha", asked, form];
                let found = formula(&arguments);
                assert_eq!((&found["alpha"], &found["form"]), (&json!(asked), &json!(&form[2..])));
                let pieces = found["pieces"].as_array().unwrap();
                let lines = text(&arguments);
                let lines: Vec<_> = lines.lines().filter_map(|line| line.strip_prefix("  [")).collect();
                assert_eq!(lines.len(), pieces.len());
                let basis = Basis::new(knots.clone(), degree, alpha.parse().unwrap()).unwrap();
                let alpha = basis.index().alpha().unwrap_or_else(|| integer(0));
                for x in (-30..=90).map(|n| rational(n, 20)) {
                    let mut values = vec![integer(0); basis.n() + 1];
                    for (piece, line) in pieces.iter().zip(&lines) {
                        let (from, to) = (number(&piece["from"]), number(&piece["to"]));
                        let closed = piece["closed"].as_bool().unwrap();
                        assert_eq!(closed, to == *knots.last());
                        if from <= x && (x < to || closed && x == to) {
                            let [p, q] = ["numerator", "denominator"]
                                .map(|part| value(piece[part].as_str().unwrap(), &x, &alpha));
                            let (_, quotient) = line.split_once([')', ']']).unwrap();
                            assert_eq!(value(quotient, &x, &alpha), &p / &q);
                            values[usize::try_from(piece["index"].as_u64().unwrap()).unwrap()] = p / q;
                        }
                    }
                    assert_eq!(values, basis.values(&x, Side::Right), "{list}, {asked}, {form}, {x}");
                    compared += values.len();
                }
            }
        }
    }
    assert!(compared > 10_000, "{compared}");
}

/// Worked out by hand from the definition: φ = x/(2 − x) on (0, 1), and 4·(2 − x)²/((3 − x)(4 − x)) = (1 − w_2)(1 − w_2²).
#[test]
fn the_first_functions_of_u4() {
    let expected = "\
Knots (0, 0, 0, 1, 2, 3, 3, 3), degree 2, alpha = -1.
Outside of its pieces a function is 0. At x = 3, the last knot, it has its limit from the left.

G_0
  [0, 1)  4*(1 - x)^2/(2 - x)^2
";
    assert_eq!(text(&["--instance", "U4", "--alpha", "-1", "--index", "0"]), expected);
    let piece = formula(&["--instance", "U4", "--alpha", "-1", "--index", "4"])["pieces"][0].clone();
    assert_eq!(
        piece,
        json!({"index": 4, "from": "2", "to": "3", "closed": true,
               "numerator": "(x - 2)^2", "denominator": "(4 - x)^2"})
    );
}

/// φ_α as the paper writes it, in every language.
#[test]
fn the_weight_with_a_symbol_in_every_language() {
    let hat = ["--degree", "1", "--knots", "0 1/2 3", "--alpha", "symbolic", "--as"];
    let printed = |language| text(&[&hat[..], &[language]].concat());
    let plain = printed("text");
    assert!(plain.contains("  [0, 1/2)  2*alpha*x/(2*x + alpha - 1)\n"), "{plain}");
    assert!(plain.contains("alpha = inf has formulas of its own"), "{plain}");
    let maxima = printed("maxima");
    assert!(maxima.contains("G_0(x, alpha) :=\n  if 0 <= x and x < 1/2 then 2*alpha*x/(2*x + alpha - 1)\n"));
    let sympy = printed("sympy");
    assert!(
        sympy.contains("(2*alpha*x/(2*x + alpha - 1), (x >= Integer(0)) & (x < Rational(1, 2))),"),
        "{sympy}"
    );
    let latex = printed("latex");
    assert!(latex.contains("{}^{\\alpha}G_{0}^{1}(x) = \\begin{cases}"), "{latex}");
    assert!(
        latex.contains("\\dfrac{2 \\alpha x}{2 x + \\alpha - 1}, & 0 \\le x < \\tfrac{1}{2}, \\\\[1ex]"),
        "{latex}"
    );
}

/// Braces, `\left` and `\right`, and environments are closed, in the right order.
#[test]
fn latex_is_balanced() {
    for alpha in ["symbolic", "-1/7", "inf"] {
        let latex =
            text(&["--degree", "3", "--knots", "0 0 0 0 1/3 2 2 2 2", "--alpha", alpha, "--as", "latex"]);
        let mut open = 0_i32;
        for c in latex.lines().filter(|line| !line.starts_with('%')).flat_map(str::chars) {
            open += i32::from(c == '{') - i32::from(c == '}');
            assert!(open >= 0);
        }
        assert_eq!(open, 0);
        let count = |part: &str| latex.matches(part).count();
        assert_eq!(count("\\left("), count("\\right)"));
        assert_eq!((count("\\begin{cases}"), count("\\end{cases}")), (5, 5));
        assert_eq!((count("\\[\n"), count("\\]\n")), (5, 5));
        assert!(latex.is_ascii());
    }
}

#[test]
fn a_function_that_is_zero_says_so() {
    let zero = ["--degree", "1", "--knots", "0 0 0 1 1", "--alpha", "2", "--index", "0"];
    assert!(text(&zero).contains("0 for every x"));
    assert_eq!(formula(&zero)["pieces"], json!([]));
    for (language, expected) in
        [("maxima", "G_0(x) := 0$"), ("sympy", "G_0 = Integer(0)"), ("latex", "G_{0}^{1}(x) = 0")]
    {
        assert!(text(&[&zero[..], &["--as", language]].concat()).contains(expected));
    }
}

#[test]
fn what_cannot_be_written_is_refused() {
    rejected(&["--instance", "U4"], "--alpha", &["one index is wanted"]);
    rejected(&["--instance", "U4", "--alpha", "all"], "--alpha", &["only `knotproof shape`"]);
    rejected(&["--instance", "U4", "--alpha", "2", "--alpha", "symbolic"], "--alpha", &["stands alone"]);
    rejected(&["--instance", "U4", "--alpha", "1/2"], "--alpha", &["pole"]);
    rejected(&["--instance", "U4", "--alpha", "2", "--index", "5"], "--index", &["0 to 4"]);
    let knots = (0..30).map(|t| t.to_string()).collect::<Vec<_>>().join(" ");
    rejected(&["--degree", "9", "--knots", &knots, "--alpha", "2"], "--degree", &["too high", "at most 8"]);
    knotproof(&["--instance", "U4", "--alpha", "2", "--factored", "--expanded"]).assert().code(2);
}

/// Other commands do not take a letter for a number.
#[test]
fn only_formula_takes_a_symbol() {
    let output = crate::program()
        .args(["eval", "--instance", "U4", "--alpha", "symbolic", "--x", "1"])
        .assert()
        .code(2)
        .get_output()
        .stderr
        .clone();
    assert!(String::from_utf8(output).unwrap().contains("only `knotproof formula` takes it"));
}
