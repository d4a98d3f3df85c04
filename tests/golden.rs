//! The library and the program against `tests/golden/eval.json`, which an implementation of its own wrote:
//! `tests/golden/generate.py` says how, and writes it again.

#![allow(clippy::unwrap_used, reason = "helpers of tests")]

use knotproof::scalar::{BigRational, parse_rational};
use knotproof::spline::{Basis, KnotVector, Side, by_definition};
use serde::Deserialize;
use serde_json::Value;

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
    x: String,
    side: String,
    values: Vec<String>,
    derivatives: Vec<Vec<String>>,
}

fn golden() -> Vec<Case> {
    let golden: Golden = serde_json::from_str(include_str!("golden/eval.json")).unwrap();
    assert_eq!(golden.source, "tests/golden/generate.py");
    assert!(golden.cases.len() >= 300);
    golden.cases
}

impl Case {
    fn basis(&self) -> Basis {
        let knots = KnotVector::new(self.knots.iter().map(|t| parse_rational(t).unwrap()).collect()).unwrap();
        Basis::new(knots, self.degree, self.alpha.parse().unwrap()).unwrap()
    }

    fn x(&self) -> BigRational {
        parse_rational(&self.x).unwrap()
    }

    fn side(&self) -> Side {
        if self.side == "left" { Side::Left } else { Side::Right }
    }

    fn label(&self) -> String {
        let knots = self.knots.join(" ");
        format!("degree {}, knots {knots}, α = {}, x = {}, {}", self.degree, self.alpha, self.x, self.side)
    }
}

#[test]
fn values_and_derivatives_agree_exactly() {
    for case in golden() {
        let jets = case.basis().jets(&case.x(), case.side(), 3);
        let found: Vec<Vec<String>> =
            jets.iter().map(|jet| jet.derivatives().iter().map(ToString::to_string).collect()).collect();
        for (order, expected) in std::iter::once(&case.values).chain(&case.derivatives).enumerate() {
            let found: Vec<_> = found.iter().map(|of_one| of_one[order].clone()).collect();
            assert_eq!(found, *expected, "order {order}: {}", case.label());
        }
    }
}

#[test]
fn the_recursion_word_for_word_agrees_too() {
    for case in golden() {
        let basis = case.basis();
        let Some(span) = basis.knots().span_at(&case.x(), case.side()) else { continue };
        let table = by_definition(&basis, span, &case.x()).expect("a span of these knots");
        let found: Vec<_> = table[case.degree].iter().map(ToString::to_string).collect();
        assert_eq!(found, case.values, "{}", case.label());
    }
}

/// One case in ten goes through the program: arguments in, JSON out.
#[test]
fn the_program_prints_the_same() {
    for (position, case) in golden().iter().enumerate().step_by(10) {
        let separator = if position % 20 == 0 { "," } else { " " };
        let degree = case.degree.to_string();
        let mut command = crate::program();
        command.args(["eval", "--format", "json", "--derivatives", "3", "--degree", &degree]);
        command.args(["--knots", &case.knots.join(separator), "--alpha", &case.alpha]);
        command.args(["--x", &case.x, "--side", &case.side]);
        let output = command.assert().success().stderr("").get_output().stdout.clone();
        let found: Value = serde_json::from_slice(&output).unwrap();
        assert_eq!(found["values"], serde_json::json!(case.values), "{}", case.label());
        assert_eq!(found["derivatives"], serde_json::json!(case.derivatives), "{}", case.label());
    }
}
