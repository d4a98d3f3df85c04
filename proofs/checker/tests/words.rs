//! Words at a point: samples show that they are false, or how much a count is at least, and nothing that is not so.

use knotproof_checker::check;

const MOBIUS: &str = r#"(family "mobius" (parameter r () (> 0)) (rise (* (parameter r) (- (var x) (var a))))
    (fall (- (var b) (var x))))"#;

/// A refutation of a conclusion about functions of degree k on these knots.
fn point(k: usize, knots: &str, conclusion: &str, numbers: &str) -> String {
    let statement = format!(
        "(statement 2 (claim \"X\") (form printed) (verdict refuted) (scope instance) (degrees {k})
            {MOBIUS}
            (define pole () y (/ (int 1) (- (var y) (/ (int 1) (int 2)))))
            (define C () y (sum l 0 n (* (coefficient d l) (of (G l) (at (var y))))))
            (sentence (for (degree 0) (knots) (integer i 0 n) (real s) (points d)) (if) (then {conclusion}))
            (point (k {k}) (knots {knots}) (parameter r 1/2) (integer i 1) (real s 1/2) {numbers}))"
    );
    match check(&statement, "(proof 1)") {
        Ok(checked) => format!("accepted: {checked}"),
        Err(rejected) => rejected.to_string(),
    }
}

fn wrong(table: &[(usize, &str, &str, &str, bool)]) -> String {
    let found = table.iter().filter_map(|(k, knots, conclusion, numbers, refuted)| {
        let found = point(*k, knots, conclusion, numbers);
        let fits =
            if *refuted { found.starts_with("accepted") } else { found.contains("no conclusion fails") };
        (!fits).then(|| format!("{k}, {knots}, {conclusion}, {numbers}:\n  {found}\n"))
    });
    found.collect()
}

/// x on one span of degree 1 for r = 1/2: the functional is 0 on both functions.
const X: &str = "(combination (expression (var x) x (closed (t 0) closed (t m))) (integer k))";
/// The functional is 0 on the functions of degree 3 with each knot once more, and not on those of degree 2.
const RAISED: &str = "(samples 1/6 1/3 1/2 2/3 5/6) (factors 459195/129311 -26444000/2456909 144342/12103 -14039040/2456909 1)";
const ZERO: &str = "(samples 1/4 1/2 3/4) (factors 7/5 -12/5 1)";

#[test]
fn functionals_show_what_is_no_combination() {
    let one = "(combination (expression (+ (of (G 0) (at (var x))) (int 1)) x (closed (t 0) closed (t m))) (integer k))";
    let bezier = "0 0 1 1";
    // The limit from the left differs from a function at knots only.
    let left = |i: usize| X.replace("(var x)", &format!("(of (G {i}) (left (var x)))"));
    let table = [
        (1, bezier, X, ZERO, true),
        // The sum of both is 1: the functional is 0 there, too.
        (1, bezier, one, ZERO, false),
        // It is not 0 on the functions.
        (1, bezier, X, "(samples 1/4 1/2 3/4) (factors 7/5 -12/5 2)", false),
        (1, bezier, X, "(samples 1/4 1/2) (factors -1 1)", false),
        (1, "0 0 1/2 1 1", X, ZERO, false),
        // Samples that do not rise, at the ends, or of which there are more than factors.
        (1, bezier, X, "(samples 3/4 1/2 1/4) (factors 1 -12/5 7/5)", false),
        (1, bezier, X, "(samples 0 1) (factors 0 0)", false),
        // At a knot, or beyond them, a functional says nothing.
        (0, "0 1/2 1", &left(0), "(samples 1/4 1/2) (factors -1 1)", false),
        (0, "0 1/2 1", &left(0), "(samples 1/2 3/4) (factors -1 1)", false),
        (1, bezier, &X.replace("closed (t m)", "closed (int 2)"), "(samples 1/2 3/2) (factors 0 1)", false),
        (1, bezier, &X.replace("closed (t 0)", "open (/ (int 1) (int 4))"), ZERO, false),
        (1, bezier, "(nested (real (int 2)))", "(samples 5/4 3/2 7/4) (factors 7/5 -12/5 1)", false),
        (1, bezier, X, "(samples 1/4 1/2 3/4) (factors 7/5 -12/5)", false),
        (1, bezier, X, "(samples 1/4 1/2 3/4 7/8) (factors 7/5 -12/5 1)", false),
        (1, bezier, X, "(samples 1/4 1/2 3/4)", false),
        (1, bezier, X, "", false),
        (1, bezier, &X.replace("(integer k)", "(integer 0)"), "(samples 1/4 1/2) (factors -1 1)", true),
        (1, bezier, &X.replace("(integer k)", "(integer 2)"), ZERO, false),
        // Another knot, or each once more.
        (1, bezier, "(nested (real (var s)))", "(samples 1/8 1/4 3/8) (factors 7/5 -12/5 1)", true),
        (1, bezier, "(nested (real (var s)))", ZERO, false),
        // It is not 0 on the functions on the other knots.
        (1, bezier, "(nested (real (var s)))", "(samples 1/8 1/4 3/8) (factors 1 1 1)", false),
        (1, bezier, "(nested (real (var s)))", "(samples 1/8 1/2) (factors 0 0)", false),
        (1, bezier, "(nested (real (int 0)))", ZERO, false),
        (1, bezier, "(elevated (integer k))", ZERO, false),
        (1, bezier, "(elevated (integer 0))", ZERO, false),
        (2, "0 0 0 1 2 2 2", "(elevated (integer k))", RAISED, true),
        (2, "0 0 0 1 2 2 2", "(elevated (integer 1))", RAISED, false),
    ];
    assert_eq!(wrong(&table), "");
}

#[test]
fn minors_show_what_they_are() {
    let positive = "(totally-positive (integer k))";
    let rank =
        |relation: &str, value: &str| format!("(chain (int (rank (integer k))) ({relation} (int {value})))");
    let knots = "0 0 0 0 1 2 3 3";
    let negative = "(samples 1023/1024 1 1025/1024)";
    let table = [
        (3, knots, positive, &*format!("{negative} (columns 1 2 3)"), true),
        (3, knots, positive, &*format!("{negative} (columns 0 1 2)"), false),
        (3, knots, positive, &*format!("{negative} (columns 2 1 3)"), false),
        (3, knots, positive, &*format!("{negative} (columns 1 2)"), false),
        (3, knots, positive, &*format!("{negative} (columns 1 2 4)"), false),
        (3, knots, positive, "(samples 1 1023/1024 1025/1024) (columns 1 2 3)", false),
        (3, knots, positive, "(samples 1023/1024 1 4) (columns 1 2 3)", false),
        (1, "0 0 1 1", positive, "(samples 1/3 2/3) (columns 0 1)", false),
        (1, "0 0 1 1", positive, "(samples 1/3 2/3) (columns 1 0)", false),
        (1, "0 0 1 1", positive, "(samples 1/3 4/3) (columns 0 1)", false),
        (1, "0 0 1 1", &rank("=", "3"), "", true),
        (1, "0 0 1 1", &rank("=", "2"), "", false),
        (1, "0 0 1 1", &rank("=", "1"), "(samples 1/3 2/3) (columns 0 1)", true),
        (1, "0 0 1 1", &rank("<=", "1"), "(samples 1/3 2/3) (columns 0 1)", true),
        (1, "0 0 1 1", &rank("<=", "2"), "(samples 1/3 2/3) (columns 0 1)", false),
        (1, "0 0 1 1", &rank(">=", "2"), "(samples 1/3 2/3) (columns 0 1)", false),
        (1, "0 0 1 1", &rank(">=", "3"), "", true),
        (1, "0 0 1 1", &rank("=", "1"), "(samples 1/3 2/3) (columns 0 0)", false),
        // A function that is 0: t_0 = t_2.
        (1, "0 0 0 1 1", &rank("=", "3"), "", true),
        (1, "0 0 0 1 1", &rank("=", "2"), "", false),
    ];
    assert_eq!(wrong(&table), "");
}

#[test]
fn counts_are_at_least_what_samples_show() {
    let maxima = |relation: &str, value: &str| {
        format!("(chain (int (maxima (function (G i)))) ({relation} (int {value})))")
    };
    let changes = "(chain (int (changes (expression (of (defined C) (at (var x))) x (closed (t 0) closed (t m))))) (<= (int (polygon-changes (coefficients d)))))";
    let changed = |d: &str, samples: &str| format!("(points d {d}) (samples {samples})");
    let two = "0 0 0 0 1 2 4 4";
    let turns = "(samples 4096/4097 1 1026/1025)";
    let of_two = |conclusion: &str| conclusion.replace("(G i)", "(G 2)");
    let highest = "(chain (int (maximisers (function (G i)))) (= (int 1)))";
    let below = |conclusion: &str, r: &str| -> String {
        let statement = format!(
            "(statement 2 (claim \"X\") (form printed) (verdict refuted) (scope instance) (degrees 3)
                {MOBIUS}
                (sentence (for (degree 0) (knots)) (if) (then {conclusion}))
                (point (k 3) (knots {two}) (parameter r {r}) {turns}))"
        );
        check(&statement, "(proof 1)").map_or_else(|e| e.to_string(), |_| "accepted".into())
    };
    for (relation, value, accepted) in
        [("=", "1", true), ("<=", "1", true), ("=", "2", false), (">=", "2", false), ("/=", "1", false)]
    {
        let found = below(&of_two(&maxima(relation, value)), "5/3");
        assert_eq!(found == "accepted", accepted, "{relation} {value}: {found}");
    }
    // For another r it does not turn there; and the samples say nothing of another function.
    assert!(below(&of_two(&maxima("=", "1")), "1").contains("no conclusion fails"));
    assert!(below(&maxima("=", "1").replace("(G i)", "(G 0)"), "5/3").contains("no conclusion fails"));
    let hat = "0 1 2 3";
    let table = [
        (1, hat, &*maxima("=", "2"), "(samples 3/2 2 5/2)", false),
        (1, hat, &*maxima("<=", "0"), "(samples 2)", true),
        (1, hat, &*maxima("<=", "0"), "(samples 7/2)", false),
        (1, hat, &*maxima("<=", "0"), "(samples 3/2 2)", false),
        // Samples begin and end with a higher one.
        (1, hat, &*maxima("<=", "0"), "(samples 2 5/2)", false),
        (1, hat, &*maxima("<=", "1"), "(samples 2 5/2)", false),
        // It rises to 1 and jumps: no largest value.
        (1, "0 0 1 1 2", &*maxima("=", "1"), "", true),
        (1, "0 0 1 1 2", &*maxima("=", "0"), "", false),
        (1, "0 0 1 1 2", highest, "", true),
        (1, "0 0 1 2", highest, "", false),
        // At t_m the value is the limit.
        (1, "0 0 1 1", highest, "", false),
        // It jumps: three samples say nothing.
        (1, "0 0 0 1 1 2", &*maxima("=", "1").replace("(G i)", "(G 1)"), "(samples 0 1/2 1)", false),
        (0, "0 1 2", highest, "", false),
        // It is 1 on all of its span.
        (0, "0 1 2 3", highest, "", false),
        (0, "0 1 2 3", &*maxima("=", "1"), "", false),
        // A polygon with two changes, and its curve.
        (2, "0 0 0 1 1 1", changes, &*changed("1 -1 1", "0 1/2 1"), false),
        (2, "0 0 0 1 1 1", changes, &*changed("1 1 1", "0 1/2 1"), false),
        (
            2,
            "0 0 0 1 1 1",
            &*changes.replace("(polygon-changes (coefficients d))", "0"),
            &*changed("1 -1 -1", "0 1"),
            true,
        ),
        (
            2,
            "0 0 0 1 1 1",
            &*changes.replace("(polygon-changes (coefficients d))", "0"),
            &*changed("1 0 1", "0 1"),
            false,
        ),
        (
            2,
            "0 0 0 1 1 1",
            &*changes.replace("(polygon-changes (coefficients d))", "0"),
            &*changed("1 -1 -1", "1 0"),
            false,
        ),
        (
            2,
            "0 0 0 1 1 1",
            &*changes.replace("(polygon-changes (coefficients d))", "0"),
            &*changed("1 -1 -1", "0 2"),
            false,
        ),
        (
            2,
            "0 0 0 1 1 1",
            &*changes.replace("(polygon-changes (coefficients d))", "0"),
            "(points d 1 -1 -1)",
            false,
        ),
        // An end that does not belong to the interval.
        (
            1,
            "0 0 1 1 2 2",
            "(chain (int (changes (expression (- (of (G 0) (at (var x))) (of (G 2) (at (var x)))) x (closed (t 0) open (int 1))))) (<= (int 0)))",
            "(samples 0 1)",
            false,
        ),
        // Where it is 0 there is no maximum to be seen.
        (1, "0 0 0 1 1", &*maxima("<=", "0").replace("(G i)", "(G 0)"), "(samples 0)", false),
        // Continuous.
        (1, hat, "(continuous (function (G i)))", "", false),
        (1, "0 0 1 1 2", "(continuous (function (G i)))", "", true),
        (1, "0 0 1 1 2", "(not (continuous (function (G i))))", "", false),
        (1, hat, "(not (continuous (function (G i))))", "", true),
        // A definition may have a pole where there is no knot.
        (1, hat, "(not (continuous (function (defined pole))))", "", false),
    ];
    assert_eq!(wrong(&table), "");
}

#[test]
fn lists_stand_once_and_each_degree_has_its_point() {
    let found = |numbers: &str| point(1, "0 0 1 1", X, numbers);
    assert!(found(&format!("{ZERO} (samples 1/2)")).contains("stands once"));
    assert!(found("(samples x)").contains("expected a number"));
    assert!(found("(sample 1/2)").contains("a name"));
    let statement = |degrees: &str, points: &str| {
        format!(
            "(statement 2 (claim \"X\") (form printed) (verdict refuted) (scope instance) (degrees {degrees})
                {MOBIUS}
                (sentence (for (degree 0) (knots)) (if) (then {X})) {points})"
        )
    };
    let one = format!("(point (k 1) (knots 0 0 1 1) (parameter r 1/2) {ZERO})");
    let two =
        "(point (k 2) (knots 0 0 0 1 1 1) (parameter r 1/2) (samples 1/5 2/5 3/5 4/5) (factors FACTORS))";
    let good = two.replace("FACTORS", &"-1 3 -3 1".replace("-1 3 -3 1", "0 0 0 0"));
    let reason = |degrees: &str, points: &str| match check(&statement(degrees, points), "(proof 1)") {
        Ok(checked) => checked.to_string(),
        Err(rejected) => rejected.to_string(),
    };
    assert!(reason("1", &one).contains("refuted, scope instance, degrees 1; point"));
    // Each point has to refute.
    assert!(reason("1 2", &format!("{one} {good}")).contains("no conclusion fails"));
    assert!(reason("1 2", &one).contains("the degree of the point"));
    assert!(reason("1", &format!("{one} {one}")).contains("the degree of the point"));
    assert!(reason("2", &one).contains("the degree of the point"));
    assert!(reason("1", &format!("{one} (because \"so\")")).contains("expected because"));
}
