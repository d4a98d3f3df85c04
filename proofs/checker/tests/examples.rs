//! Sentences about examples and about weights: what is derived from them, and what refutes them.

use knotproof_checker::check;

/// The paper's weights.
const MOBIUS: &str = r#"(family "mobius" (parameter r () (> 0)) (rise (* (parameter r) (- (var x) (var a))))
    (fall (- (var b) (var x))))"#;

fn reason(statement: &str, proof: &str) -> String {
    match check(statement, proof) {
        Ok(checked) => format!("accepted: {checked}"),
        Err(rejected) => rejected.to_string(),
    }
}

/// What fails, and with what reason, that should not; `want` is part of the answer.
fn wrong(table: &[(&str, String, &str, &str)]) -> String {
    let found = table.iter().filter_map(|(what, statement, proof, want)| {
        let found = reason(statement, proof);
        (!found.contains(want)).then(|| format!("{what}:\n  found: {found}\n  wanted: {want}\n"))
    });
    found.collect()
}

/// A sentence about two examples of degree 1, (0, 0, 1, 3) and (0, 1, 2).
fn about(binders: &str, hypotheses: &str, conclusion: &str) -> String {
    format!(
        "(statement 2 (claim \"X\") (form printed) (verdict proved) (scope alpha) (degrees 1)
            {MOBIUS}
            (define C (c) y (sum i 0 n (* (coefficient P i c) (of (G i) (at (var y))))))
            (define v (j) none (- (coefficient P j 1) (coefficient P 0 1)))
            (sentence (for (instances (instance A 1 (knots 0 0 1 3) (points (1 2) (4 2)))
                    (instance A 2 (knots 0 1 2 3)) (instance B 1 (knots 0 1 2))) {binders})
                (if {hypotheses}) (then {conclusion})))"
    )
}

const NONE: &str = "(proof 1)";

#[test]
fn numbers_decide_what_is_said_of_them() {
    let said = |hypotheses: &str, conclusion: &str| about("", hypotheses, conclusion);
    let alone = "(instance A)";
    let table = [
        (
            "counts",
            said("", "(chain (int m) (>= (int (+ k 1))))"),
            NONE,
            "accepted: X (printed): proved, scope alpha",
        ),
        ("a count too large", said("", "(chain (int m) (>= (int 3)))"), NONE, "conclusion 1 is not decided"),
        ("of one example", said(alone, "(chain (int m) (>= (int 3)))"), NONE, "accepted"),
        ("of the other one", said("(instance B)", "(chain (int m) (>= (int 3)))"), NONE, "not decided"),
        ("of none", said("(instance C)", "(chain (int 0) (= (int 1)))"), NONE, "accepted"),
        ("knots", said(alone, "(chain (t 0) (= (t 1)) (< (t 2)))"), NONE, "accepted"),
        ("knots that differ", said(alone, "(chain (t 0) (= (t 2)))"), NONE, "not decided"),
        ("a knot too many", said(alone, "(chain (t 4) (= (t 4)))"), NONE, "not decided"),
        ("one", said("", "(one (integers j 0 n) (chain (int j) (= (int 0))))"), NONE, "accepted"),
        (
            "more than one",
            said(alone, "(one (integers j 0 n) (chain (int j) (>= (int 0))))"),
            NONE,
            "not decided",
        ),
        ("none of them", said("", "(one (integers j 0 n) (chain (int j) (> (int n))))"), NONE, "not decided"),
        ("points", said(alone, "(chain (coefficient P 1 1) (= (int 4)))"), NONE, "accepted"),
        ("other points", said(alone, "(chain (coefficient P 1 2) (= (int 4)))"), NONE, "not decided"),
        (
            "a point too many",
            said(alone, "(chain (coefficient P 2 1) (= (coefficient P 2 1)))"),
            NONE,
            "not decided",
        ),
        (
            "a coordinate too many",
            said(alone, "(chain (coefficient P 1 3) (= (int 0)))"),
            NONE,
            "not decided",
        ),
        (
            "points that are not there",
            said("(instance B)", "(chain (coefficient P 0 1) (= (int 0)))"),
            NONE,
            "not decided",
        ),
        ("a definition", said(alone, "(chain (defined v 1) (= (int 3)))"), NONE, "accepted"),
        (
            "|v|",
            said(alone, "(chain (abs (- (int 0) (defined v 1))) (= (max (int 2) (defined v 1))))"),
            NONE,
            "accepted",
        ),
        ("min", said(alone, "(chain (min (int 2) (defined v 1)) (= (int 3)))"), NONE, "not decided"),
        ("copies", said(alone, "(chain (int (mult (real (t 0)))) (= (int 2)))"), NONE, "accepted"),
        ("more copies", said(alone, "(chain (int (mult (real (t 2)))) (= (int 2)))"), NONE, "not decided"),
    ];
    assert_eq!(wrong(&table), "");
}

#[test]
fn examples_are_those_of_the_sentence() {
    let honest = about("", "", "(chain (int m) (>= (int 2)))");
    let forged = |from: &str, to: &str| {
        assert!(honest.contains(from), "{from}");
        honest.replace(from, to)
    };
    let table = [
        ("all", honest.clone(), NONE, "accepted"),
        ("a scope too large", forged("(scope alpha)", "(scope knots)"), NONE, "the scope of the sentence"),
        ("a scope too small", forged("(scope alpha)", "(scope instance)"), NONE, "the scope of the sentence"),
        ("a degree without example", forged("(degrees 1)", "(degrees 3)"), NONE, "an example of this degree"),
        ("another degree", forged("(degrees 1)", "(degrees 2)"), NONE, "accepted"),
        ("knots that fall", forged("0 0 1 3", "0 0 3 1"), NONE, "knots that do not fall"),
        ("too few knots", forged("(knots 0 1 2)", "(knots 0 1)"), NONE, "k + 2 knots at least"),
        ("knots that are all the same", forged("(knots 0 1 2)", "(knots 1 1 1)"), NONE, "two that differ"),
        ("no numbers", forged("(knots 0 1 2)", "(knots 0 a 2)"), NONE, "expected a number"),
        ("no points", forged("(points (1 2) (4 2))", "(points)"), NONE, "expected points"),
        ("points that are none", forged("(4 2)", "4"), NONE, "expected a point"),
        ("more", forged("(4 2))", "(4 2)) (trust me)"), NONE, "points behind the knots, and nothing else"),
        ("names alone", forged("(instance B 1 (knots 0 1 2))", "B"), NONE, "expected instance"),
        (
            "no example",
            forged("(instance B 1 (knots 0 1 2))", "(instance B 1)"),
            NONE,
            "a name, a degree and knots",
        ),
        (
            "another list inside",
            about(
                "",
                "",
                "(claim \"Y\" (sentence (for (instances (instance A 1 (knots 0 0 1 3)))) (if) (then (chain (int 0) (= (int 0))))))",
            ),
            NONE,
            "it is about other examples",
        ),
        ("a list of α", about("(alphas 2 3)", "", "(chain (int m) (>= (int 2)))"), NONE, "accepted"),
        (
            "that is all of them",
            about("(alphas 2)", "", "(chain (alpha alpha) (= (int 2)))"),
            NONE,
            "not decided",
        ),
    ];
    assert_eq!(wrong(&table), "");
}

/// The same proof rule for so many sections with one goal each.
fn by(sections: usize) -> String {
    let all: String = (1..=sections).map(|n| format!("(section {n} (goal 1 (by)))")).collect();
    format!("(proof 1 {all})")
}

#[test]
fn functions_are_taken_at_all_places_of_an_example() {
    let at = |hypotheses: &str, conclusion: &str| {
        about("(point x (closed (t 0) closed (t m)))", &format!("(instance A) {hypotheses}"), conclusion)
    };
    let sum = "(chain (sum i 0 n (of (G i) (at (var x)))) (= (int 1)))";
    let line = "(chain (of (defined C 2) (at (var x))) (= (int 2)))";
    // A on the second span is the line from G_0 = 1 to G_1 = 1.
    let y = "(at (+ (t 2) (* (- (t 3) (t 2)) (of (w 2 1) (at (var x))))))";
    // On the second span only G_1 is left, which falls from 1 as 1 − w_2 does.
    let moved = format!("(chain (of (G 1) {y}) (= (- (int 1) (of (w 2 1) {y}))))");
    let other = format!("(chain (of (G 1) {y}) (= (- (int 1) (of (w 2 1) (at (var x))))))");
    let beyond = "(chain (of (G 1) (at (- (var x) (int 3)))) (= (int 0)))";
    let on_second = "(chain (t 2) (< (var x)) (< (t 3)))";
    let (two, three) = (by(2), by(5));
    let table = [
        ("outside of [0, 1] the sum is less", at("", sum), three.as_str(), "the two sides differ"),
        ("on [0, 1]", at("(chain (var x) (<= (int 1)))", sum), &by(3), "accepted"),
        ("too few places", at("(chain (var x) (<= (int 1)))", sum), &two, "is missing in its place"),
        ("too many", at("(chain (var x) (<= (int 1)))", sum), &by(4), "that the statement does not have"),
        ("a curve", at("(chain (var x) (<= (int 1)))", line), &by(3), "accepted"),
        (
            "another curve",
            at("(chain (var x) (<= (int 1)))", &line.replace("(int 2)", "(int 3)")),
            &by(3),
            "the two sides differ",
        ),
        ("at another point", at(on_second, &moved), &by(1), "accepted"),
        ("at x", at(on_second, &other), &by(1), "the two sides differ"),
        ("before all knots", at("(chain (var x) (< (int 3)))", beyond), NONE, "accepted"),
        (
            "of which it is not known where it is",
            at("", "(chain (of (G 1) (at (* (int 2) (var x)))) (>= (int 0)))"),
            NONE,
            "not decided",
        ),
        (
            "beyond the last knot",
            about("(real x)", "(chain (var x) (> (t m)))", "(chain (of (G 0) (at (var x))) (= (int 0)))"),
            NONE,
            "accepted",
        ),
        (
            "but not at it",
            about(
                "(real x)",
                "(instance A) (chain (var x) (>= (t m)))",
                "(chain (of (G 1) (at (var x))) (= (int 1)))",
            ),
            NONE,
            "not decided",
        ),
        (
            "a weight",
            at(
                "(chain (var x) (< (int 1)))",
                "(chain (of (w 1 1) (at (var x))) (= (/ (* ratio (var x)) (+ (* ratio (var x)) (- (int 1) (var x))))))",
            ),
            NONE,
            "accepted",
        ),
        (
            "another weight",
            at("(chain (var x) (< (int 1)))", "(chain (of (w 1 1) (at (var x))) (= (var x)))"),
            NONE,
            "not decided",
        ),
        (
            "the classical weight",
            at(
                "(chain (var x) (< (int 1)))",
                "(chain (of (w 1 1) (at (var x) (alpha infinity))) (= (var x)))",
            ),
            NONE,
            "accepted",
        ),
    ];
    assert_eq!(wrong(&table), "");
}

/// A sentence about weights.
fn weights(binders: &str, hypotheses: &str, conclusion: &str) -> String {
    format!(
        "(statement 2 (claim \"X\") (form printed) (verdict proved) (scope knots) (degrees 1)
            {MOBIUS}
            (sentence (for {binders}) (if {hypotheses}) (then {conclusion})))"
    )
}

#[test]
fn weights_are_looked_at_in_all_orders() {
    let all = |conclusion: &str| weights("(real a) (real b) (real x)", "", conclusion);
    let apart =
        |conclusion: &str| weights("(real a) (real b) (real x)", "(chain (var a) (< (var b)))", conclusion);
    let inside = |conclusion: &str| {
        weights(
            "(real a) (real b) (point x (open (var a) open (var b)))",
            "(chain (var a) (< (var b)))",
            conclusion,
        )
    };
    let phi = "(of (phi (var a) (var b)) (at (var x)))";
    let f = "(of (f (var a) (var b)) (at (var x)))";
    let chain = |a: &str, relation: &str, b: &str| format!("(chain {a} ({relation} {b}))");
    let table = [
        ("in [0, 1)", all(&format!("(chain (int 0) (<= {phi}) (< (int 1)))")), NONE, "accepted"),
        ("positive", all(&chain("(int 0)", "<", phi)), NONE, "not decided"),
        ("positive inside", inside(&chain("(int 0)", "<", phi)), NONE, "accepted"),
        ("φ is f inside", inside(&chain(phi, "=", f)), NONE, "accepted"),
        ("but not everywhere", apart(&chain(phi, "=", f)), NONE, "not decided"),
        ("f is less than 1", inside(&chain(f, "<", "(int 1)")), NONE, "accepted"),
        (
            "f is what it is for 1 − α",
            inside(&chain(f, "=", "(of (f (var a) (var b)) (at (var x) (alpha (- (int 1) (alpha alpha)))))")),
            NONE,
            "not decided",
        ),
        (
            "f is reflected",
            inside(&chain(
                f,
                "=",
                "(- (int 1) (of (f (var a) (var b)) (at (- (+ (var a) (var b)) (var x)) (alpha (- (int 1) (alpha alpha))))))",
            )),
            NONE,
            "accepted",
        ),
        (
            "f rises",
            inside(&chain("(of (D (f (var a) (var b)) 1) (at (var x)))", ">", "(int 0)")),
            NONE,
            "accepted",
        ),
        (
            "f falls",
            inside(&chain("(of (D (f (var a) (var b)) 1) (at (var x)))", "<", "(int 0)")),
            NONE,
            "not decided",
        ),
        (
            "f is bent",
            inside(&chain("(of (D (f (var a) (var b)) 2) (at (var x) (ratio 1/2)))", ">", "(int 0)")),
            NONE,
            "accepted",
        ),
        (
            "f is bent in one way",
            inside(&chain("(of (D (f (var a) (var b)) 2) (at (var x)))", ">", "(int 0)")),
            NONE,
            "not decided",
        ),
        (
            "a third derivative",
            inside(&chain("(of (D (f (var a) (var b)) 3) (at (var x)))", ">", "(int 0)")),
            NONE,
            "not decided",
        ),
        (
            "φ from the left of b",
            apart("(chain (of (phi (var a) (var b)) (left (var b))) (= (int 1)))"),
            NONE,
            "accepted",
        ),
        ("φ at b", apart("(chain (of (phi (var a) (var b)) (at (var b))) (= (int 1)))"), NONE, "not decided"),
        (
            "φ from the right of b",
            apart("(chain (of (phi (var a) (var b)) (right (var b))) (= (int 0)))"),
            NONE,
            "accepted",
        ),
        (
            "an interval without a sign",
            weights(
                "(real a) (real b) (point x (open (var a) open (+ (var b) (var b))))",
                "",
                &chain(phi, ">=", "(int 0)"),
            ),
            NONE,
            "not decided",
        ),
        (
            "one that is empty",
            weights(
                "(real a) (point x (open (var a) open (var a)))",
                "",
                "(chain (var x) (= (+ (var x) (int 1))))",
            ),
            NONE,
            "accepted",
        ),
        (
            "an end that is closed",
            weights(
                "(real a) (real b) (point x (closed (var a) open (var b)))",
                "(chain (var a) (< (var b)))",
                "(chain (var x) (> (var a)))",
            ),
            NONE,
            "not decided",
        ),
        (
            "six reals",
            weights(
                "(real a) (real b) (real c) (real d) (real e) (real x)",
                "(chain (var a) (< (var b)) (< (var c)) (< (var d)) (< (var e)) (< (var x)))",
                "(chain (var a) (< (var x)))",
            ),
            NONE,
            "more reals than are put in order",
        ),
        ("a sign", weights("(real s <)", "", "(chain (var s) (< (int 0)))"), NONE, "accepted"),
        ("the other sign", weights("(real s >)", "", "(chain (var s) (< (int 0)))"), NONE, "not decided"),
        ("no sign", weights("(real s)", "", "(chain (+ (var s) (int 1)) (> (int 0)))"), NONE, "not decided"),
        (
            "a basis function",
            inside(&chain("(of (G 0) (at (var x)))", ">=", "(int 0)")),
            NONE,
            "degree 1 and nothing but weights",
        ),
        ("a degree", inside(&chain("(int n)", "=", "(int n)")), NONE, "degree 1 and nothing but weights"),
        (
            "copies of a knot",
            inside(&chain("(int (mult (real (var x))))", "=", "(int 0)")),
            NONE,
            "degree 1 and nothing but weights",
        ),
        (
            "in degree 2",
            all("(chain (int 0) (= (int 0)))").replace("(degrees 1)", "(degrees 2)"),
            NONE,
            "degree 1 and nothing but weights",
        ),
    ];
    assert_eq!(wrong(&table), "");
}

/// A refutation by numbers.
fn refuted(statement: &str, point: &str) -> String {
    let end = statement.rfind(')').expect("it ends");
    let of = statement.replace("(verdict proved)", "(verdict refuted)");
    let of = of.replace("(scope alpha)", "(scope instance)").replace("(scope knots)", "(scope instance)");
    assert_eq!(of.rfind(')').map(|at| of.len() - at), Some(statement.len() - end));
    format!("{} {point})", &of[..of.len() - 1])
}

#[test]
fn points_refute_examples_and_weights() {
    let one = about(
        "(alphas 2 infinity) (index beta) (point x (closed (t 0) closed (t m)))",
        "",
        "(chain (of (G 0) (at (var x))) (= (of (G 0) (at (var x) (alpha (alpha beta))))))",
    );
    let a = |point: &str| refuted(&one, &format!("(point (k 1) (knots 0 0 1 3) (parameter r 2) {point})"));
    let curve = about(
        "(point x (closed (t 0) closed (t m)))",
        "",
        "(chain (of (defined C 1) (at (var x))) (= (int 2)))",
    );
    let phi = weights(
        "(real a) (real b) (real x)",
        "",
        "(chain (of (phi (var a) (var b)) (at (var x))) (= (int 0)))",
    );
    let on = |point: &str| refuted(&phi, &format!("(point (parameter r 2) {point})"));
    let table = [
        ("an index", a("(instance A) (index beta 1) (real x 1/2)"), NONE, "accepted"),
        (
            "at an end both are the same",
            a("(instance A) (index beta 1) (real x 0)"),
            NONE,
            "no conclusion fails there",
        ),
        ("a point outside", a("(instance A) (index beta 1) (real x 4)"), NONE, "no conclusion fails there"),
        ("no name", a("(index beta 1) (real x 1/2)"), NONE, "not those of an example"),
        ("another name", a("(instance B) (index beta 1) (real x 1/2)"), NONE, "not those of an example"),
        (
            "a name that there is not",
            a("(instance C) (index beta 1) (real x 1/2)"),
            NONE,
            "not those of an example",
        ),
        (
            "other knots",
            a("(instance A) (index beta 1) (real x 1/2)")
                .replace("0 0 1 3) (parameter", "0 0 1 2) (parameter"),
            NONE,
            "not those of an example",
        ),
        (
            "another degree",
            a("(instance A) (index beta 1) (real x 1/2)")
                .replace("(k 1)", "(k 2)")
                .replace("(degrees 1)", "(degrees 2)"),
            NONE,
            "not those of an example",
        ),
        (
            "α that is not in the list",
            a("(instance A) (index beta 1) (real x 1/2)").replace("(parameter r 2)", "(parameter r 3)"),
            NONE,
            "no conclusion fails there",
        ),
        (
            "∞",
            a("(instance A) (index beta 2) (real x 1/2)").replace("(parameter r 2)", "(parameter r 1)"),
            NONE,
            "accepted",
        ),
        (
            "a negative ratio",
            a("(instance A) (index beta 1) (real x 1/2)").replace("(parameter r 2)", "(parameter r -2)"),
            NONE,
            "with a name of its own and its numbers",
        ),
        (
            "a curve",
            refuted(&curve, "(point (k 1) (knots 0 0 1 3) (parameter r 1) (instance A) (real x 1/2))"),
            NONE,
            "accepted",
        ),
        (
            "where it is 2",
            refuted(&curve, "(point (k 1) (knots 0 0 1 3) (parameter r 1) (instance A) (real x 1/3))"),
            NONE,
            "no conclusion fails there",
        ),
        (
            "points of its own",
            refuted(
                &curve.replace("P i c", "P i"),
                "(point (k 1) (knots 0 0 1 3) (parameter r 1) (instance A) (real x 1/2) (points P 0 0))",
            ),
            NONE,
            "no conclusion fails there",
        ),
        ("a weight", on("(real a 0) (real b 1) (real x 1/2)"), NONE, "accepted"),
        ("at b", on("(real a 0) (real b 1) (real x 1)"), NONE, "no conclusion fails there"),
        ("a weight of nothing", on("(real a 1) (real b 0) (real x 1/2)"), NONE, "no conclusion fails there"),
        ("no x", on("(real a 0) (real b 1)"), NONE, "no conclusion fails there"),
        (
            "knots besides",
            refuted(&phi, "(point (k 1) (knots 0 1 2) (parameter r 2) (real a 0) (real b 1) (real x 1/2))"),
            NONE,
            "it is not about all knots",
        ),
        (
            "no knots",
            refuted(&curve, "(point (parameter r 2) (real x 1/2))"),
            NONE,
            "not those of an example",
        ),
        (
            "no knots",
            refuted(
                &weights("(knots) (real x)", "", "(chain (of (G 0) (at (var x))) (= (int 0)))"),
                "(point (parameter r 2) (real x 1/2))",
            ),
            NONE,
            "nothing but weights",
        ),
    ];
    assert_eq!(wrong(&table), "");
}

#[test]
fn a_hypothesis_on_an_index_has_to_exist() {
    let bent = |hypotheses: &str| {
        weights(
            "(real a) (real b) (point x (open (var a) open (var b)))",
            &format!("(chain (var a) (< (var b))) {hypotheses}"),
            "(=> (chain (alpha alpha) (< (int 0))) (chain (of (D (phi (var a) (var b)) 2) (at (var x))) (> (int 0))))",
        )
    };
    let knots = |hypotheses: &str| {
        on_knots(
            "(knots) (real x)",
            &format!("(chain (var x) (< (t 0))) {hypotheses}"),
            "(chain (of (G 0) (at (var x))) (= (int 0)))",
        )
    };
    let finite = "(chain (alpha alpha) (/= infinity))";
    let table = [
        ("of weights", bent(finite), NONE, "accepted"),
        // For ∞ it makes no sense to ask whether α < 0.
        ("where it may be infinite", bent(""), NONE, "not decided"),
        ("where it is", bent("(chain (alpha alpha) (= infinity))"), NONE, "not decided"),
        ("of knots", knots(&format!("{finite} (chain (alpha alpha) (< (int 0)))")), NONE, "accepted"),
        (
            "where it may be infinite",
            knots("(chain (alpha alpha) (< (int 0)))"),
            NONE,
            "that may be infinite",
        ),
        ("between 0 and 1", knots("(chain (int 0) (< (alpha alpha)))"), NONE, "that may be infinite"),
        ("in a term", knots("(chain (+ (alpha alpha) (int 1)) (< (int 0)))"), NONE, "that may be infinite"),
        (
            "in a disjunction",
            knots("(or (chain (alpha alpha) (< (int 0))) (chain (alpha alpha) (= infinity)))"),
            NONE,
            "that may be infinite",
        ),
        (
            "another one that is finite",
            knots(&format!("{finite} (chain (alpha beta) (< (int 0)))"))
                .replace("(real x)", "(real x) (index beta)"),
            NONE,
            "that may be infinite",
        ),
        ("next to infinity", knots("(chain (alpha alpha) (= infinity))"), NONE, "accepted"),
    ];
    assert_eq!(wrong(&table), "");
}

/// A sentence about all knots in degree 1.
fn on_knots(binders: &str, hypotheses: &str, conclusion: &str) -> String {
    format!(
        "(statement 2 (claim \"X\") (form printed) (verdict proved) (scope knots) (degrees 1)
            {MOBIUS}
            (sentence (for (degree 0) {binders}) (if {hypotheses}) (then {conclusion})))"
    )
}

#[test]
fn a_span_has_one_quotient_of_polynomials() {
    let of = |word: &str, term: &str, interval: &str| {
        on_knots(
            "(knots) (integer i 0 n) (integer j 0 (- m 1))",
            "",
            &format!("({word} (expression {term} x ({interval})))"),
        )
    };
    let (function, span) = ("(of (G i) (at (var x)))", "open (t j) open (t (+ j 1))");
    let three = "(proof 1 (section 1 (goal 1 (by)) (goal 2 (by)) (goal 3 (by)) (goal 4 (by)) (goal 5 (by)) (goal 6 (by))))";
    let two = "(proof 1 (section 1 (goal 1 (by)) (goal 2 (by))))";
    let table = [
        ("rational", of("rational", function, span), three, "accepted"),
        ("smooth", of("smooth", function, span), two, "accepted"),
        ("goals left out", of("rational", function, span), two, "is missing in its place"),
        ("on two spans", of("smooth", function, "open (t j) open (t (+ j 2))"), two, "not decided"),
        (
            "on two spans",
            of("rational", function, "open (t j) open (t (+ j 2))"),
            three,
            "not from one knot to the next",
        ),
        ("a closed span", of("smooth", function, "closed (t j) open (t (+ j 1))"), two, "not decided"),
        (
            "between others",
            of("rational", function, "open (t i) open (t (+ j 1))"),
            three,
            "not from one knot to the next",
        ),
        (
            "without an interval",
            of("smooth", function, "").replace("x ())", "x)"),
            two,
            "another number of fields",
        ),
        (
            "a function that there is not",
            of("smooth", "(of (G (+ i 1)) (at (var x)))", span),
            two,
            "not decided",
        ),
        ("a quotient", of("smooth", "(/ (int 1) (of (G i) (at (var x))))", span), two, "not decided"),
        (
            "a pole",
            of("smooth", "(/ (int 1) (- (var x) (t j)))", "open (t j) open (t (+ j 1))"),
            NONE,
            "is missing in its place",
        ),
        (
            "the opposite",
            of("smooth", function, span)
                .replace("(smooth", "(not (smooth")
                .replace("(t (+ j 1)))))", "(t (+ j 1))))))"),
            two,
            "",
        ),
    ];
    assert_eq!(wrong(&table), "");
    let opposite = check(&table[11].1, two).map_or_else(|e| e.to_string(), |_| "accepted".into());
    assert!(opposite != "accepted", "{opposite}");
}

#[test]
fn ranks_are_counted() {
    let rank = |adjectives: &str, degree: &str, relation: &str, count: &str| {
        let said = format!("(chain (int (rank (integer {degree}))) ({relation} (int {count})))");
        on_knots(&format!("(knots {adjectives})"), "", &said)
    };
    let orders = "(proof 1 (section 1 (goal 1 (orders))) (section 2 (goal 1 (orders))))";
    let one = "(proof 1 (section 1 (goal 1 (orders))))";
    let table = [
        ("full", rank("open interior", "k", "=", "(+ n 1)"), orders, "accepted"),
        ("simple", rank("simple", "k", "=", "(+ n 1)"), orders, "accepted"),
        ("one of the orders", rank("open interior", "k", "=", "(+ n 1)"), one, "is missing in its place"),
        (
            "by another rule",
            rank("open interior", "k", "=", "(+ n 1)"),
            "(proof 1 (section 1 (goal 1 (by))) (section 2 (goal 1 (by))))",
            "none for this formula",
        ),
        ("of any knots", rank("", "k", "=", "(+ n 1)"), orders, "not decided"),
        ("open", rank("open", "k", "=", "(+ n 1)"), orders, "not decided"),
        ("interior alone", rank("interior", "k", "=", "(+ n 1)"), orders, "not decided"),
        ("symmetric", rank("symmetric", "k", "=", "(+ n 1)"), orders, "not decided"),
        ("one more", rank("open interior", "k", "=", "(+ n 2)"), orders, "a rank that is not counted"),
        ("one less", rank("open interior", "k", "=", "n"), orders, "a rank that is not counted"),
        ("two less", rank("open interior", "k", "=", "(- n 1)"), orders, "not decided"),
        ("less", rank("open interior", "k", "<", "(+ n 2)"), orders, "a rank that is not counted"),
        ("of degree 0", rank("open interior", "0", "=", "n"), one, "accepted"),
        ("all of degree 0", rank("open interior", "0", "=", "(+ n 2)"), one, "not decided"),
        ("all of degree 0 of simple knots", rank("simple", "0", "=", "(+ n 2)"), one, "accepted"),
        (
            "of a degree that there is not",
            rank("open interior", "2", "=", "n"),
            orders,
            "a rank that is not counted",
        ),
        (
            "a name of its own",
            rank("open interior", "k", "=", "(+ n 1)").replace("(degree 0)", "(degree 0) (integer rank 0 1)"),
            orders,
            "the name rank is taken",
        ),
    ];
    assert_eq!(wrong(&table), "");
}

#[test]
fn indices_are_put_in_order() {
    let said = |hypotheses: &str, conclusion: &str| {
        about("(index beta)", &format!("(instance B) {hypotheses}"), conclusion)
    };
    let value = |member: &str| format!("(of (G 0) (at 1/2{member}))").replace("1/2", "(/ (int 1) (int 2))");
    let (own, other) = (value(""), value(" (alpha (alpha beta))"));
    let finite = "(chain (alpha alpha) (/= infinity)) (chain (alpha beta) (/= infinity))";
    let below = &*format!("{finite} (chain (alpha alpha) (< (alpha beta)) (< (int 0)))");
    let above = &*format!("{finite} (chain (int 1) (< (alpha beta)) (< (alpha alpha)))");
    let by = |n: usize| by(n);
    let some = |body: &str| format!("(some (reals x (closed (t 0) closed (t m))) {body})");
    let differs = "(chain (of (G 0) (at (var x))) (/= (of (G 0) (at (var x) (alpha (alpha beta))))))";
    let table = [
        // The larger r, the larger is the weight: α < β < 0 are the ratios 1 > r > that of β.
        ("below 0", said(below, &format!("(chain {own} (> {other}))")), &*by(1), "accepted"),
        ("the other way", said(below, &format!("(chain {own} (< {other}))")), &*by(1), "rule by"),
        ("above 1", said(above, &format!("(chain {own} (< {other}))")), &*by(1), "accepted"),
        ("above 1, the other way", said(above, &format!("(chain {own} (> {other}))")), &*by(1), "rule by"),
        ("in no order", said("", &format!("(chain {own} (> {other}))")), &*by(1), "rule by"),
        (
            "on two sides",
            said(
                &format!("{finite} (chain (alpha alpha) (< (int 0)) (< (alpha beta)))"),
                &format!("(chain {own} (> {other}))"),
            ),
            NONE,
            "is missing in its place",
        ),
        (
            "∞ is none of them",
            said(
                "(chain (alpha alpha) (= infinity)) (chain (alpha alpha) (/= infinity))",
                &format!("(chain {own} (> {other}))"),
            ),
            NONE,
            "accepted",
        ),
        (
            "both are not the same",
            said(
                "(chain (alpha alpha) (= infinity)) (chain (alpha beta) (= infinity))",
                "(chain (int 0) (= (int 1)))",
            ),
            NONE,
            "accepted",
        ),
        (
            "but may be on one side",
            said(
                &format!("{finite} (chain (alpha alpha) (< (int 0))) (chain (alpha beta) (< (int 0)))"),
                "(chain (int 0) (= (int 1)))",
            ),
            NONE,
            "not decided",
        ),
        (
            "α is a number",
            said(below, "(chain (* (alpha alpha) (- ratio (int 1))) (= ratio))"),
            NONE,
            "accepted",
        ),
        ("and not another", said(below, "(chain (alpha alpha) (> (alpha beta)))"), NONE, "not decided"),
        ("somewhere", said("", &some(differs)), NONE, "accepted"),
        (
            "somewhere beyond",
            said("", &some(differs).replace("(closed (t 0) closed (t m))", "(closed (t 2) closed (t m))")),
            NONE,
            "not decided",
        ),
        ("less at some place of each side", said("", &some(&differs.replace("/=", ">"))), NONE, "accepted"),
        (
            "less on one side",
            said(
                "",
                &some(&differs.replace("/=", ">"))
                    .replace("(closed (t 0) closed (t m))", "(closed (t 0) closed (t 1))"),
            ),
            NONE,
            "not decided",
        ),
        (
            "everywhere",
            said("", &format!("(all (reals x (closed (t 0) closed (t m))) {differs})")),
            NONE,
            "is missing in its place",
        ),
    ];
    assert_eq!(wrong(&table), "");
}

/// In a number of an example, and not in a place, an end of the span can't be looked at.
#[test]
fn what_is_no_place_has_no_ends() {
    let said = |word: &str| {
        let quotient = "(/ (int 1) (- (var y) (t 0)))";
        about(
            "",
            "(instance B)",
            &format!("({word} (expression {quotient} y (open (t 0) open (t (+ 0 1)))))"),
        )
    };
    let proofs = [by(1), "(proof 1 (section 1 (goal 1 (by)) (goal 2 (by)) (goal 3 (by))))".to_owned()];
    for (word, proof) in
        ["smooth", "rational"].iter().flat_map(|word| proofs.iter().map(move |proof| (word, proof)))
    {
        let found = reason(&said(word), proof);
        assert!(found.contains("not decided"), "{word}: {found}");
    }
}

/// What an index is inside of another member is not known, but for those that have names of their own.
#[test]
fn a_member_of_a_member_has_a_name() {
    let said = |inner: &str, other: &str| {
        let define = format!("(define g () y (of (G 0) (at (var y) {inner}))) (define v");
        let at = |member: &str| format!("(at (/ (int 1) (int 2)) {member})");
        let both =
            format!("(chain (of (defined g) {}) (= (of (G 0) {})))", at("(alpha (alpha beta))"), at(other));
        about("(index beta) (index gamma)", "(instance B)", &both).replace("(define v", &define)
    };
    let [dual, beta, gamma, infinity] = [
        "(alpha (- (int 1) (alpha alpha)))",
        "(alpha (alpha beta))",
        "(alpha (alpha gamma))",
        "(alpha infinity)",
    ];
    let table = [
        // Indices that a sentence binds are none of a definition's names.
        ("of gamma", said(gamma, gamma), &*by(1), "unknown name gamma"),
        ("of infinity", said(infinity, infinity), &*by(1), "accepted"),
        ("of the first one", said(infinity, beta), &*by(1), "rule by"),
        ("of 1 - α", said(dual, dual), &*by(1), "not decided"),
        ("of r", said("(ratio ratio)", "(ratio ratio)"), &*by(1), "not decided"),
        ("of a number", said("(ratio 2)", "(ratio 2)"), &*by(1), "not decided"),
    ];
    assert_eq!(wrong(&table), "");
}

/// Copies of t_0 are few only where t_k and t_{m−k} differ: otherwise no knot is between them.
#[test]
fn knots_between_none_are_not_few() {
    let said = |adjectives: &str| {
        on_knots(
            &format!("(knots {adjectives}) (point x (closed (t 0) closed (t m)))"),
            "(chain (var x) (= (t 0)))",
            "(chain (t 0) (< (t (+ k 1))))",
        )
    };
    let proper = said("interior").replace("(if ", "(if (chain (t k) (< (t (- m k)))) ");
    let table = [
        ("with knots between", proper, NONE, "accepted"),
        ("without", said("interior"), NONE, "not decided"),
        ("inner", said("inner"), NONE, "not decided"),
    ];
    assert_eq!(wrong(&table), "");
}

/// What samples and limits show of a word is shown on the knots of a point, and not on all knots.
#[test]
fn words_are_not_derived() {
    let said =
        |word: &str| on_knots("(knots) (integer i 0 n) (point x (closed (t 0) closed (t m)))", "", word);
    let of_weights = |word: &str| weights("(real x)", "", word);
    let table = [
        ("continuous", said("(continuous (function (G i)))"), NONE, "not decided"),
        ("and not", said("(not (continuous (function (G i))))"), NONE, "not decided"),
        ("of weights", of_weights("(continuous (function (phi (int 0) (int 1))))"), NONE, "not decided"),
        ("of an example", about("", "(instance B)", "(continuous (function (G 0)))"), NONE, "not decided"),
        (
            "combination",
            said("(combination (expression (var y) y (closed (t 0) closed (t m))) (integer k))"),
            NONE,
            "not decided",
        ),
        ("nested", said("(nested (real (var x)))"), NONE, "not decided"),
        ("a count", said("(chain (int (maxima (function (G i)))) (= (int 1)))"), NONE, "not decided"),
    ];
    assert_eq!(wrong(&table), "");
}
