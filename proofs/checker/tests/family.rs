//! Families in statements: weights that are none, parameters, duals, and refutations with numbers for all of them.

use std::fs;
use std::path::Path;

use knotproof_checker::check;

fn text(path: &str) -> [String; 2] {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests");
    ["statement", "proof"].map(|kind| {
        let text = fs::read_to_string(folder.join(format!("{path}.{kind}"))).expect("the file is there");
        text.split_whitespace().collect::<Vec<_>>().join(" ")
    })
}

fn found([statement, proof]: &[String; 2]) -> String {
    match check(statement, proof) {
        Ok(checked) => format!("accepted: {checked}"),
        Err(rejected) => rejected.to_string(),
    }
}

/// Each change of the one text is refused, with these words in the message.
fn refused(path: &str, changes: &[(&str, &str, &str)]) {
    let [statement, proof] = text(path);
    assert!(found(&[statement.clone(), proof.clone()]).starts_with("accepted"), "{path}");
    let mut wrong = Vec::new();
    for (from, to, want) in changes {
        assert!(statement.contains(from), "{path} does not say {from}");
        let found = found(&[statement.replacen(from, to, 1), proof.clone()]);
        if !found.contains(want) || found.starts_with("accepted") {
            wrong.push(format!("{from} → {to}\n  found: {found}\n  wanted: {want}"));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

const RISE: &str = "(rise (* (parameter omega (+ i d)) (- (var x) (var a))))";
const FALL: &str = "(fall (* (parameter omega i) (- (var b) (var x))))";
const OMEGA: &str = "(parameter omega (i) (> 0))";
const DUAL: &str = "(dual (omega (parameter omega (- m i))))";
const SIGN: &str = "has a coefficient below 0";
const OWN: &str = "is not 0 at its own end";
const OTHER: &str = "may be 0 at the other end";
const BEYOND: &str = "a weight looks beyond its interval";

#[test]
fn what_is_no_weight() {
    refused(
        "families/KW2.4.printed",
        &[
            (FALL, "(fall (* (parameter omega i) (- (var x) (var b))))", SIGN),
            (FALL, "(fall (neg (* (parameter omega i) (- (var b) (var x)))))", SIGN),
            (FALL, "(fall (- (var b) (* 2 (var x))))", SIGN),
            (FALL, "(fall (- (var b) (var a)))", OWN),
            (FALL, "(fall 1)", OWN),
            (FALL, "(fall 0)", OTHER),
            (FALL, "(fall (- (var x) (var x)))", OTHER),
            (FALL, "(fall (* (- (var b) (var x)) (- (var x) (var a))))", OTHER),
            (FALL, "(fall (var b))", SIGN),
            (FALL, "(fall (var o))", "expected x, a or b"),
            (FALL, "(fall)", "expected"),
            (FALL, "", "expected fall"),
            (FALL, "(fall (/ (- (var b) (var x)) (- (var x) (var a))))", "a divisor without x, a and b"),
            (FALL, "(fall (/ (- (var b) (var x)) 0))", "a divisor without a sign"),
            (
                FALL,
                "(fall (/ (- (var b) (var x)) (- (parameter omega i) (parameter omega (+ i d)))))",
                "a divisor without a sign",
            ),
            (FALL, "(fall (^ (- (var b) (var x)) 101))", "an exponent"),
            (FALL, "(fall (^ (- (var b) (var x)) (- 0 1)))", "an exponent"),
            (FALL, "(fall (* (parameter omega (+ i 1)) (- (var b) (var x))))", BEYOND),
            (FALL, "(fall (* (parameter omega (- i 1)) (- (var b) (var x))))", BEYOND),
            (FALL, "(fall (* (parameter omega 0) (- (var b) (var x))))", BEYOND),
            (FALL, "(fall (* (parameter omega) (- (var b) (var x))))", "unknown name omega"),
            (FALL, "(fall (* (parameter omega i d) (- (var b) (var x))))", "unknown name omega"),
            (FALL, "(fall (* (parameter other i) (- (var b) (var x))))", "unknown name other"),
            (FALL, "(fall (* (int i) (- (var b) (var x))))", "expected"),
            (FALL, "(fall (* (int m) (- (var b) (var x))))", "expected"),
            (FALL, "(fall (t i))", "expected a term of a weight"),
            (RISE, "(rise (- (var a) (var x)))", SIGN),
            (RISE, "(rise (- (var b) (var x)))", OWN),
            (RISE, "(rise (+ (- (var x) (var a)) (- (var b) (var x))))", OWN),
            (RISE, "(rise (* (- (var x) (var a)) (- (var x) (var b))))", SIGN),
            (RISE, "(rise (* (- (parameter omega i) 1) (- (var x) (var a))))", SIGN),
            (OMEGA, "(parameter omega (i))", SIGN),
            (OMEGA, "(parameter omega (i) (> -1))", SIGN),
            (OMEGA, "(parameter omega (i) (< 1))", SIGN),
            (OMEGA, "(parameter omega (i) (>= 0))", OTHER),
            (OMEGA, "(parameter omega (i) (= 0))", OTHER),
            (OMEGA, "(parameter omega (j) (> 0))", "the indices i, d, or both"),
            (OMEGA, "(parameter omega (d i) (> 0))", "the indices i, d, or both"),
            (OMEGA, "(parameter omega i (> 0))", "expected indices"),
            (OMEGA, "(parameter omega (i) (above 0))", "a bound"),
            (OMEGA, "(parameter omega (i) (> zero))", "expected"),
            (OMEGA, "(parameter omega (i) (> 0)) (parameter omega (i) (> 0))", "the name omega is taken"),
            (OMEGA, "", "unknown name omega"),
            ("\"knot-weights\"", "knot-weights", "expected"),
            ("(family", "(families", "expected"),
        ],
    );
}

#[test]
fn other_weights_are_other_functions() {
    let any = |from: &str| text("families/KW2.7.printed")[0].contains(from);
    assert!(any(RISE) && any(FALL));
    refused(
        "families/KW2.7.printed",
        &[
            (RISE, "(rise (* (parameter omega i) (- (var x) (var a))))", "the two sides differ"),
            (RISE, "(rise (- (var x) (var a)))", "the two sides differ"),
            (RISE, "(rise (* (parameter omega (+ i d)) (^ (- (var x) (var a)) 2)))", "the two sides differ"),
            (RISE, "(rise (* 2 (* (parameter omega (+ i d)) (- (var x) (var a)))))", "the two sides differ"),
            (FALL, "(fall (- (var b) (var x)))", "the two sides differ"),
            (FALL, "(fall (* (int d) (* (parameter omega i) (- (var b) (var x)))))", "the two sides differ"),
        ],
    );
    refused(
        "families/KW2.4.printed",
        &[
            (DUAL, "", "the family has no dual"),
            (DUAL, "(dual)", "the two sides differ"),
            (DUAL, "(dual (omega (parameter omega i)))", "the two sides differ"),
            (DUAL, "(dual (omega (parameter omega (- (+ m 1) i))))", "the two sides differ"),
            (DUAL, "(dual (omega (parameter omega (- (- m 1) i))))", "the two sides differ"),
            (DUAL, "(dual (omega (/ 1 (parameter omega (- m i)))))", "the two sides differ"),
            (DUAL, "(dual (omega (parameter other (- m i))))", "other"),
            (DUAL, "(dual (omega (parameter omega (- n i))))", "expected"),
            (DUAL, "(dual (omega (var x)))", "expected a number, which no length is"),
            (DUAL, "(dual (omega (parameter omega (- (* 9 m) i))))", "not determined"),
            (DUAL, "(dual omega)", "expected"),
            ("(at (var x) (dual))", "(at (var x))", "the two sides differ"),
            ("(at (var x) (dual))", "(at (var x) (dual 1))", "expected another index"),
            ("(at (- (+ (t 0) (t m)) (var x)))", "(at (- (+ (t 0) (t m)) (var x)) (dual))", "not decided"),
            ("(knots symmetric)", "(knots)", "not decided"),
            ("(family", "(family any) (families", "expected"),
        ],
    );
    let [statement, proof] = text("families/KW2.7.printed");
    let start = statement.find("(family").expect("it has a family");
    let end = start
        + statement[start..].find("(sentence").or(statement[start..].find("(define")).expect("a sentence");
    let end = statement[start..].find("(define").map_or(end, |at| end.min(start + at));
    let any = format!("{}(family any) {}", &statement[..start], &statement[end..]);
    assert!(found(&[any, proof]).contains("unknown name omega"));
}

/// The product of two equal weights is not squared, and what holds for these weights does not hold for any.
#[test]
fn what_holds_for_one_family_only_is_not_proved_for_any() {
    let [statement, proof] = text("claims/P3.3.1.amended");
    let (start, end) =
        (statement.find("(family").expect("a family"), statement.find("(sentence").expect("a sentence"));
    let end = statement.find("(define").map_or(end, |at| end.min(at));
    let any = format!("{}(family any) {}", &statement[..start], &statement[end..]);
    assert!(found(&[any, proof]).contains("not decided"), "its weight is one of the ends alone");
    let [statement, proof] = text("claims/T3.5.2.printed");
    let (start, end) =
        (statement.find("(family").expect("a family"), statement.find("(sentence").expect("a sentence"));
    let any = format!("{}(family any) {}", &statement[..start], &statement[end..]);
    assert!(found(&[any.clone(), proof.clone()]).contains("for any weights"));
    // They may be 0 or 1 inside of no interval, but nothing says that they are less than 1/2.
    let less = any.replace("(> (int 0))", "(> 1/2)");
    assert!(any != less && found(&[less, proof]).contains("a coefficient below 0"));
}

/// What is unknown in one term is not what is unknown in another one.
#[test]
fn unknown_weights_have_no_name_outside_of_their_term() {
    let statement = "(statement 2 (claim \"X\") (form printed) (verdict proved) (scope knots) (degrees 2) (family any)
        (sentence (for (degree 2 2) (knots)) (if) (then (chain (int 0) (= (int 0)))))
        (because \"no\")
        (section (window A 0 some some some some) (let a (w 1 2 (in A 1))) (let b (w 0 2 (in A 1))) (goals (= a b))))";
    let proof = "(proof 1 (section 1 (goal 1 (by))))";
    assert!(found(&[statement.to_owned(), proof.to_owned()]).contains("a weight that is not known"));
    let one = statement.replace("(= a b)", "(= (w 1 2 (in A 1)) (w 0 2 (in A 1)))");
    let one = one.replace("(let a (w 1 2 (in A 1))) (let b (w 0 2 (in A 1)))", "");
    assert!(found(&[one, proof.to_owned()]).contains("the two sides differ"));
}

/// An argued section about these weights.
fn section(family: &str, section: &str) -> String {
    let statement = format!(
        "(statement 2 (claim \"X\") (form printed) (verdict proved) (scope instance) (degrees 2) {family}
            (sentence (for (degree 2 2) (knots)) (if) (then (chain (int 0) (= (int 0))))) (because \"numbers\") (section {section}))"
    );
    found(&[statement, "(proof 1 (section 1 (goal 1 (by))))".to_owned()])
}

/// With r = 2 the weight on [0, 1] is w = 2x/(1 + x), with the derivatives 2/(1 + x)², −4/(1 + x)³ and 12/(1 + x)⁴, and G_2^2 on
/// 0, 0, 0, 1, 1, 1 is w², the second derivative of which is 8(1 − 2x)/(1 + x)⁴.
#[test]
fn derivatives_of_every_order_are_exact() {
    let mobius = "(family \"mobius\" (parameter r () (> 0)) (rise (* (parameter r) (- (var x) (var a)))) (fall (- (var b) (var x))))";
    let square = "(family \"square\" (rise (^ (- (var x) (var a)) 2)) (fall (^ (- (var b) (var x)) 2)))";
    for (family, goal, value) in [
        (mobius, "(at ((u 1)) (DG 1 1 (in A 1) 2))", "-32/27"),
        (mobius, "(at ((u 1)) (DG 1 1 (in A 1) 3))", "64/27"),
        (mobius, "(at ((u 1)) (DG 0 1 (in A 1) 3))", "-64/27"),
        (mobius, "(DG 1 1 (from A 1) 1)", "2"),
        (mobius, "(DG 1 1 (to A 1) 2)", "-1/2"),
        (mobius, "(DG 1 1 (in A 1) 0)", "(w 1 1 (in A 1))"),
        (mobius, "(at ((u 2)) (DG 2 2 (in B 2) 2))", "-216/625"),
        (mobius, "(at ((u 1)) (DG 2 2 (in B 2) 2))", "0"),
        // x²/(x² + (1 − x)²): x² + … at 0, and at 1/2 a point of inflection with the slope 2.
        (square, "(DG 1 1 (from A 1) 2)", "2"),
        (square, "(at ((u 1)) (DG 1 1 (in A 1) 2))", "0"),
        (square, "(at ((u 1)) (DG 1 1 (in A 1) 1))", "2"),
    ] {
        let is = if family == mobius { "(let r 2)" } else { "" };
        let windows = "(knots A 0 0 0 1 1) (knots B 0 0 0 0 1 1 1)";
        let goals = |value: &str| format!("{is} {windows} (goals (= {goal} {value}))");
        let own = section(family, &goals(value));
        assert!(own.starts_with("accepted"), "{goal}: {own}");
        let other = section(family, &goals(&format!("(+ 1/1000 {value})")));
        assert!(other.contains("the two sides differ"), "{goal}: {other}");
    }
    let far = section(mobius, "(knots A 0 0 0 1 1) (goals (= (DG 1 1 (in A 1) 21) 0))");
    assert!(far.contains("the order of a derivative is beyond the limits"), "{far}");
}

/// Numbers for the parameters of a window are within their bounds, and are those of the knots.
#[test]
fn values_of_parameters_are_within_their_bounds() {
    let family = format!("(family \"k\" {OMEGA} {RISE} {FALL})");
    let goal = "(goals (= (at ((u 1)) (G 1 1 (in A 1))) 3/4))";
    let with =
        |values: &str| section(&family, &format!("(knots A 0 0 0 1 1) (values A omega {values}) {goal}"));
    assert!(with("(1 1) (2 3)").starts_with("accepted"), "{}", with("(1 1) (2 3)"));
    for (values, want) in [
        ("(1 1) (2 2)", "the two sides differ"),
        ("(1 -1) (2 -3)", "a number within the bounds"),
        ("(1 0) (2 3)", "a number within the bounds"),
        ("(1 1) (9 3)", "unknown name A"),
        ("(1 2 3)", "unknown name A"),
        ("()", "indices and a number"),
    ] {
        assert!(with(values).contains(want), "{values}: {}", with(values));
    }
}

/// Of class C^{k−p} at a knot of p copies, whatever the weights: true as it stands, not one order higher, and not of other weights.
#[test]
fn knot_weights_keep_the_order_of_continuity() {
    refused(
        "families/KW3.2.printed",
        &[
            ("(- k (mult", "(- (+ k 1) (mult", ""),
            // Without weights it would be true as well: they are polynomial B-splines.
            (RISE, "(rise (* 2 (* (parameter omega (+ i d)) (- (var x) (var a)))))", "the two sides differ"),
            (FALL, "(fall (* (^ (parameter omega i) 2) (- (var b) (var x))))", "the two sides differ"),
        ],
    );
}

/// φ and f of a sentence about weights alone are those of D2.3, which those of another family are not.
#[test]
fn weights_alone_are_those_of_the_family() {
    let of = |[rise, fall]: [&str; 2], conclusion: &str| {
        let statement = format!(
            "(statement 2 (claim \"X\") (form printed) (verdict proved) (scope knots) (degrees 1)
                (family \"own\" (parameter r () (> 0)) (rise {rise}) (fall {fall}))
                (sentence (for (real a) (real b) (point x (open (var a) open (var b)))) (if) (then {conclusion})))"
        );
        found(&[statement, "(proof 1)".to_owned()])
    };
    let [p, q] = ["(- (var x) (var a))", "(- (var b) (var x))"];
    let linear = [&*format!("(* (parameter r) {p})"), q];
    let square = [&*format!("(* (parameter r) (^ {p} 2))"), &*format!("(^ {q} 2)")];
    let at = |function: &str| format!("(of {function} (at (var x)))");
    let (f, slope, bend) =
        (at("(f (var a) (var b))"), at("(D (f (var a) (var b)) 1)"), at("(D (f (var a) (var b)) 2)"));
    let value =
        |rise: &str, fall: &str| format!("(chain {f} (= (/ (* ratio {rise}) (+ (* ratio {rise}) {fall}))))");
    let squared = [p, q].map(|part| format!("(* {part} {part})"));
    let (once, twice) = (value(p, q), value(&squared[0], &squared[1]));
    let turned = format!("(/ (* ratio (- (var b) (var a))) (* (+ (* ratio {p}) {q}) (+ (* ratio {p}) {q})))");
    let (exact, rises) = (format!("(chain {slope} (= {turned}))"), format!("(chain {slope} (> (int 0)))"));
    let bends = format!("(chain {bend} (> (int 0)))");
    for (family, conclusion, known) in [
        (linear, &once, true),
        (linear, &twice, false),
        (square, &once, false),
        (square, &twice, true),
        (linear, &exact, true),
        (square, &exact, false),
        (linear, &rises, true),
        (square, &rises, true),
        (linear, &bends, false),
        (square, &bends, false),
    ] {
        let found = of(family, conclusion);
        assert_eq!(found.starts_with("accepted"), known, "{family:?}: {conclusion}: {found}");
        assert!(known || found.contains("not decided"), "{found}");
    }
}

#[test]
fn numbers_that_refute() {
    let omega = "(parameter omega 2 2 20 1 1 20 2 2)";
    let numbers = "with a name of its own and its numbers";
    refused(
        "families/KW5.2.printed",
        &[
            (omega, "", "numbers for all parameters"),
            (omega, "(parameter omega 2 2 20 1 1 20 2)", numbers),
            (omega, "(parameter omega 2 2 20 1 1 20 2 2 2)", numbers),
            (omega, "(parameter omega 2 2 20 1 1 20 2 0)", numbers),
            (omega, "(parameter omega 2 2 20 -1 1 20 2 2)", numbers),
            (omega, "(parameter omega 2 2 20 1 1 20 2 (int 2))", "expected"),
            (omega, "(parameter other 2 2 20 1 1 20 2 2)", numbers),
            (omega, "(parameter omega 2 2 20 1 1 20 2 2) (parameter omega 2 2 20 1 1 20 2 2)", numbers),
            (omega, "(parameter omega 1 1 1 1 1 1 1 1)", "no conclusion fails"),
            (omega, "(parameter omega 2 2 2 1 1 20 2 2)", "no conclusion fails"),
            (omega, "(ratio 1)", "expected a name"),
            ("(integer i 1)", "(integer i 2)", "no conclusion fails"),
            ("(real x 1)", "(real x 3)", "no conclusion fails"),
            (FALL, "(fall (- (var b) (var x)))", "no conclusion fails"),
        ],
    );
}

/// A statement about weights of its own, in degree 1; with the rest of it.
fn of_weights(family: &str, verdict: &str, sentence: &str, rest: &str, proof: &str) -> String {
    found(&[
        format!(
            "(statement 2 (claim \"X\") (form printed) {verdict} (degrees 1) {family} (sentence {sentence}) {rest})"
        ),
        proof.to_owned(),
    ])
}

const MOBIUS: &str = r#"(family "mobius" (parameter r () (> 0)) (rise (* (parameter r) (- (var x) (var a))))
    (fall (- (var b) (var x))))"#;

/// What rests on quotients of polynomials, on their orders, and on an r that is positive, is said of those weights only.
#[test]
fn what_is_derived_of_known_weights_is_derived_of_them_alone() {
    let proved = "(verdict proved) (scope knots)";
    let smooth = |word: &str| {
        format!(
            "(for (degree 0) (knots) (integer i 0 n) (integer j 0 (- m 1))) (if)
                (then ({word} (expression (of (G i) (at (var x))) x (open (t j) open (t (+ j 1))))))"
        )
    };
    let rank =
        "(for (degree 0) (knots simple)) (if) (then (chain (int (rank (integer k))) (= (int (+ n 1)))))";
    let orders = "(proof 1 (section 1 (goal 1 (orders))) (section 2 (goal 1 (orders))))";
    let goals = |n: usize| {
        let goals: String = (1..=n).map(|goal| format!("(goal {goal} (by))")).collect();
        format!("(proof 1 (section 1 {goals}))")
    };
    let omega = format!("(family \"k\" {OMEGA} {RISE} {FALL})");
    for (family, known) in [(MOBIUS, true), (&*omega, true), ("(family any)", false)] {
        for (sentence, proof) in
            [(&*smooth("smooth"), &*goals(2)), (&smooth("rational"), &goals(6)), (rank, orders)]
        {
            let found = of_weights(family, proved, sentence, "", proof);
            assert_eq!(found.starts_with("accepted"), known, "{family}: {sentence}: {found}");
        }
    }
    // The ratio of an index is positive, and in order beside 1; what another family calls r need not be.
    let real = "(for (real x)) (if) (then (chain (abs (- ratio (int 1))) (>= (int 0))) (or (chain ratio (< (int 1))) (chain ratio (>= (int 1)))))";
    let positive = "(for (real x)) (if) (then (or (chain ratio (<= (int 1))) (chain ratio (> (int 1)))) (chain ratio (> (int 0))))";
    let own = "(family \"own\" (parameter r ()) (rise (- (var x) (var a))) (fall (- (var b) (var x))))";
    for sentence in [real, positive] {
        assert!(of_weights(MOBIUS, proved, sentence, "", "(proof 1)").starts_with("accepted"), "{sentence}");
        let found = of_weights(own, proved, sentence, "", "(proof 1)");
        assert!(found.contains("not decided"), "{found}");
    }
}

/// Weights of which it is not known whether they rise; and parameters of knots that are not known of others.
#[test]
fn words_look_at_the_weights_of_the_point() {
    let refuted = "(verdict refuted) (scope instance)";
    let point = |family: &str, conclusion: &str, point: &str| {
        let sentence = format!("(for (degree 0) (knots) (integer i 0 n) (real s)) (if) (then {conclusion})");
        of_weights(family, refuted, &sentence, &format!("(point {point})"), "(proof 1)")
    };
    let maxima = "(chain (int (maxima (function (G i)))) (= (int 1)))";
    let weights = |name: &str, p: &str, q: &str| {
        let [from, to] = ["(- (var x) (var a))", "(- (var b) (var x))"];
        let share =
            |own: &str, other: &str| format!("(* {own} (+ (* {p} (^ {own} 2)) (* {q} (^ {other} 2))))");
        format!("(family \"{name}\" (rise {}) (fall {}))", share(from, to), share(to, from))
    };
    let (rises, turns) = (&*weights("rises", "1", "1"), &*weights("turns", "1", "100"));
    let jump = "(k 1) (knots 0 1 1 2) (real s 1/2)";
    let found = point(MOBIUS, maxima, &format!("{jump} (parameter r 1/2) (integer i 0)"));
    assert!(found.starts_with("accepted"), "{found}");
    let found = point(rises, maxima, &format!("{jump} (integer i 0)"));
    assert!(found.starts_with("accepted"), "{found}");
    let found = point(turns, maxima, &format!("{jump} (integer i 0)"));
    assert!(found.contains("no conclusion fails"), "{found}");
    // One that rises and jumps has no maximum, whatever its weights.
    let none = maxima.replace("(= (int 1))", "(<= (int 0))");
    let found = point(turns, &none, &format!("{jump} (integer i 0) (samples 1/2)"));
    assert!(found.contains("no conclusion fails"), "{found}");
    let nested = "(nested (real (var s)))";
    let bezier = "(k 1) (knots 0 0 1 1) (integer i 0) (real s 1/2)";
    let lists = "(samples 1/8 1/4 3/8) (factors 7/5 -12/5 1)";
    let found = point(MOBIUS, nested, &format!("{bezier} (parameter r 1/2) {lists}"));
    assert!(found.starts_with("accepted"), "{found}");
    let knots = format!("(family \"k\" {OMEGA} {RISE} {FALL})");
    for omega in ["1 1 1 1", "1 2 1 2"] {
        let found = point(&knots, nested, &format!("{bezier} (parameter omega {omega}) {lists}"));
        assert!(found.contains("no conclusion fails"), "{omega}: {found}");
    }
    // Of the functions on the knots themselves all is known.
    let x = "(combination (expression (var x) x (closed (t 0) closed (t m))) (integer k))";
    let lists = "(samples 1/4 1/2 3/4) (factors 7/5 -12/5 1)";
    let found = point(&knots, x, &format!("{bezier} (parameter omega 2 2 1 2) {lists}"));
    assert!(found.starts_with("accepted"), "{found}");
}
