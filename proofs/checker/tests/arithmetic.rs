//! The arithmetic under the rules, through certificates: laws, exact values, signs, and what is too large.

use knotproof_checker::check;

/// Whether `(by)` or another rule proves the goal.
fn holds(declarations: &str, goal: &str, rule: &str) -> bool {
    let statement = format!(
        r#"(statement 2 (claim "test") (form printed) (verdict proved) (scope knots) (degrees 1)
    (family "mobius" (parameter r () (> 0)) (rise (* (parameter r) (- (var x) (var a)))) (fall (- (var b) (var x))))
            (sentence (for (degree 1) (knots)) (if) (then (chain (int 0) (= (int 0))))) (because "It says so.") (section {declarations} (goals {goal})))"#
    );
    let result = check(&statement, &format!("(proof 1 (section 1 (goal 1 {rule})))"));
    if let Err(rejected) = &result {
        assert!(rejected.place.starts_with("section 1, goal 1"), "{goal}: {rejected}");
    }
    result.is_ok()
}

/// Zero, constants, polynomials with both signs, fractions.
const SAMPLES: [&str; 9] =
    ["0", "1", "-3/7", "a", "(^ (+ a b) 2)", "(- (* a b) 2)", "(/ 1 (+ a b))", "(/ (- a b) (* 2 a))", "c"];
const SIGNS: &str = "(real c) (positive a b)";

#[test]
fn the_laws_of_a_field_hold() {
    for a in SAMPLES {
        for b in SAMPLES {
            for c in SAMPLES {
                for law in [
                    format!("(= (+ {a} (+ {b} {c})) (+ {c} {a} {b}))"),
                    format!("(= (* {a} (* {b} {c})) (* {c} {a} {b}))"),
                    format!("(= (* {a} (- {b} {c})) (- (* {a} {b}) (* {c} {a})))"),
                ] {
                    assert!(holds(SIGNS, &law, "(by)"), "{law}");
                }
            }
            assert_eq!(holds(SIGNS, &format!("(= {a} {b})"), "(by)"), a == b, "{a} {b}");
        }
    }
}

#[test]
fn values_are_exact() {
    for goal in [
        "(= (+ 1/2 1/3) 5/6)",
        "(= (/ 1/2 -1/3) -3/2)",
        "(= (^ (+ a b) 3) (+ (^ a 3) (* 3 (^ a 2) b) (* 3 a (^ b 2)) (^ b 3)))",
        "(= (* (+ a b) (- a b)) (- (^ a 2) (^ b 2)))",
        "(= (+ (/ a (+ a b)) (/ b (+ a b))) 1)",
        "(= (^ a 0) 1)",
        "(= (det (1 2) (3 4)) -2)",
        "(= (+ (each i 0 2 (each j i 2 (integer (+ (* 10 i) j))))) (+ 0 1 2 11 12 22))",
        "(= (+ 5 (each i 1 0 7)) 5)",
        "(= (* (each i 1 5 (integer i))) 120)",
        "(= (/ 123456789012345678901234567890 10) 12345678901234567890123456789)",
    ] {
        assert!(holds(SIGNS, goal, "(by)"), "{goal}");
    }
}

#[test]
fn binomials_are_pascals() {
    for n in 0..12 {
        for m in -1..=n {
            let (more, next) = (n + 1, m + 1);
            let sum = format!("(+ (binomial {n} {m}) (binomial {n} {next}))");
            assert!(holds("", &format!("(= (integer (binomial {more} {next})) (integer {sum}))"), "(by)"));
        }
    }
    assert!(holds("", "(= (integer (binomial 4 2)) 6)", "(by)"));
    assert!(holds("", "(= (integer (binomial 4 5)) 0)", "(by)"));
    assert!(!holds("", "(= (integer (binomial 1000000 500000)) 0)", "(by)"));
}

#[test]
fn signs_are_read_off_only_where_they_show() {
    let table = [
        ("0", ">="),
        ("1", ">"),
        ("-1", ""),
        ("p", ">"),
        ("n", ">="),
        ("c", ""),
        ("(+ n p)", ">"),
        ("(+ n (* 2 n))", ">="),
        ("(+ n 1)", ">"),
        // 1 + c vanishes at −1: a positive monomial is not enough.
        ("(+ c 1)", ""),
        ("(+ (^ c 2) p)", ""),
        ("(- p n)", ""),
        ("(* p n)", ">="),
        ("(/ n p)", ">="),
        ("(/ (- p) (- (+ n 1)))", ">"),
        ("(/ p (- p))", ""),
    ];
    for (term, shown) in table {
        let declared = "(real c) (nonnegative n) (positive p)";
        assert_eq!(holds(declared, &format!("(> {term} 0)"), "(by)"), shown == ">", "{term}");
        assert_eq!(holds(declared, &format!("(>= {term} 0)"), "(by)"), !shown.is_empty(), "{term}");
        assert_eq!(holds(declared, &format!("(< {term} 0)"), "(by)"), ["-1", "(/ p (- p))"].contains(&term));
    }
}

#[test]
fn splits_are_what_evaluation_says() {
    for (goal, rule, shown) in [
        ("(>= (* a (- a 3/2)) 0)", "(split a 3/2 (by) (by))", false),
        ("(> (+ 1 (* a (- a 1))) 0)", "(split a 1 (by) (by))", true),
        ("(> (+ 1/5 (* a (- a 1))) 0)", "(split a 1 (by) (by))", false),
        ("(> (+ 1/3 (* a (- a 1))) 0)", "(split a 1/2 (split a 1/4 (by) (by)) (by))", true),
        ("(> (+ 1/3 (* a (- a 1))) 0)", "(split a 1/2 (by) (by))", true),
        ("(>= (^ (- a 3/7) 2) 0)", "(split a 3/7 (by) (by))", true),
        ("(> (^ (- a 3/7) 2) 0)", "(split a 3/7 (by) (by))", false),
        ("(>= (^ (- a 3/7) 2) 0)", "(split a 3/8 (by) (by))", false),
    ] {
        assert_eq!(holds("(positive a)", goal, rule), shown, "{goal} {rule}");
    }
}

#[test]
fn a_number_can_be_written_in_one_way() {
    let statement = |word: &str| format!("(= {word} {word})");
    for good in ["0", "7", "-7", "1/2", "-3/4", "10/9", "123456789012345678901234567890"] {
        assert!(holds("", &statement(good), "(by)"), "{good}");
    }
    let long = "1".repeat(1_001);
    let bad = [
        "-", "-0", "00", "01", "+1", "1/1", "2/4", "0/3", "1/0", "1/-2", "1/02", "1/", "/2", "1.5", "1_0",
        "--1",
    ];
    for bad in bad.into_iter().chain([long.as_str()]) {
        let text = format!("(statement {bad})");
        assert!(check(&text, "").is_err_and(|e| e.place == "statement"), "{bad}");
    }
}

#[test]
fn what_is_no_tree_is_rejected() {
    let deep = "(".repeat(100_000);
    let bad = [
        "",
        "(",
        ")",
        "(a))",
        "(a) b",
        "(a",
        "a b",
        "(\"x)",
        "(\"x\\n\")",
        "(\"x\ny\")",
        "(a\"b\")",
        "(\"a\"b)",
        "(1a)",
        "(a_b)",
        "(é)",
        "(;)",
        "(==)",
        "(a\u{a0}b)",
        "\u{feff}(a)",
        "(\"\"\"\")",
        "\"",
        deep.as_str(),
    ];
    for text in bad {
        let error = check(text, "").expect_err("no statement").to_string();
        assert!(!error.contains("expected statement"), "{text}: {error}");
    }
    assert_eq!(check("(a\n(b\n01))", "").unwrap_err().to_string().find("line 3"), Some(11));
}

#[test]
fn what_grows_too_large_is_given_up_on() {
    let names: String = (0..40).map(|i| format!(" (a {i})")).collect();
    let all = format!("(real{names})");
    let sum: String = (0..40).map(|i| format!(" (a {i})")).collect();
    for goal in [
        format!("(= (^ (+{sum}) 9) 0)"),
        "(= (^ (^ u 1000) 66) 0)".to_owned(),
        "(= (^ (^ (^ 3 1000) 1000) 2) 0)".to_owned(),
        "(= (integer (* 1000000 1000000)) 0)".to_owned(),
        "(= (integer (- -1 1000000)) 0)".to_owned(),
    ] {
        assert!(!holds(&all, &goal, "(by)"), "{goal}");
    }
}
