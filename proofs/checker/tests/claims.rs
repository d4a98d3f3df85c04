//! Certificates that carry the claim's sentence: what is derived from it is proved, and forgeries are not accepted.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use knotproof_checker::{check, check_within};

/// The paper's weights.
const MOBIUS: &str = r#"(family "mobius" (parameter r () (> 0)) (rise (* (parameter r) (- (var x) (var a))))
    (fall (- (var b) (var x))))"#;

/// Statements and proofs of `tests/claims`, by name.
fn certificates() -> BTreeMap<String, [String; 2]> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/claims");
    let mut all = BTreeMap::new();
    for entry in fs::read_dir(folder).expect("the folder is there") {
        let path = entry.expect("its entries can be read").path();
        if path.extension().is_some_and(|extension| extension == "statement") {
            let name = path.file_stem().expect("a file has a name").to_string_lossy().into_owned();
            let text =
                |extension| fs::read_to_string(path.with_extension(extension)).expect("both files are there");
            let flat = |text: String| text.split_whitespace().collect::<Vec<_>>().join(" ");
            all.insert(name, ["statement", "proof"].map(|extension| flat(text(extension))));
        }
    }
    assert!(all.len() > 15, "certificates are missing");
    all
}

fn reason(statement: &str, proof: &str) -> String {
    match check(statement, proof) {
        Ok(checked) => format!("accepted: {checked}"),
        Err(rejected) => rejected.to_string(),
    }
}

#[test]
fn all_hold() {
    for (name, [statement, proof]) in certificates() {
        let checked = check(&statement, &proof).unwrap_or_else(|e| panic!("{name}: {e}"));
        assert_eq!(checked.goals, proof.matches("(goal ").count(), "{name}");
        assert_eq!(checked.sections, proof.matches("(section ").count(), "{name}");
    }
}

/// Where a section, or the last goal, of a proof begins and ends.
fn bracket(text: &str, head: &str) -> Option<std::ops::Range<usize>> {
    let start = text.rfind(head)?;
    let mut depth = 0;
    for (at, c) in text[start..].char_indices() {
        depth += i32::from(c == '(') - i32::from(c == ')');
        if depth == 0 {
            return Some(start..start + at + 1);
        }
    }
    None
}

/// The same change to every certificate that it concerns.
#[test]
fn forgeries_of_all_certificates() {
    let (mut seen, mut wrong) = (BTreeMap::new(), Vec::new());
    for (name, [statement, proof]) in certificates() {
        let mut forgeries: Vec<(&str, String, String, &str)> = Vec::new();
        let mut of_statement = |what, from: &str, to: &str, want| {
            // In the sentence and its definitions, if it is there: weights have an x of their own.
            let body =
                ["(define", "(sentence"].iter().filter_map(|head| statement.find(head)).min().unwrap_or(0);
            let of_sentence = from.starts_with("(var") || statement[body..].contains(from);
            let (before, after) = statement.split_at(if of_sentence { body } else { 0 });
            if after.contains(from) {
                forgeries.push((
                    what,
                    format!("{before}{}", after.replacen(from, to, 1)),
                    proof.clone(),
                    want,
                ));
            }
        };
        of_statement(
            "a degree without a proof",
            "(degrees 1 2 3)",
            "(degrees 1 2 3 4)",
            "is missing in its place",
        );
        of_statement(
            "a degree without a proof",
            "(degrees 0 1 2 3)",
            "(degrees 0 1 2 3 4)",
            "is missing in its place",
        );
        of_statement("a degree left out", "(degrees 0 1 2 3)", "(degrees 0 1 3)", "");
        of_statement(
            "another verdict",
            "(verdict proved)",
            "(verdict refuted)",
            "expected proved, and the scope of the sentence",
        );
        of_statement(
            "a smaller scope",
            "(scope knots)",
            "(scope alpha)",
            "expected proved, and the scope of the sentence",
        );
        of_statement("a format of old", "(statement 2", "(statement 1", "format 2 is missing");
        of_statement("no such format", "(statement 2", "(statement 3", "format 2 is missing");
        of_statement("a sentence that is none", "(sentence", "(sentences", "expected");
        of_statement("a range one longer", "(integer i 0 n)", "(integer i 0 (+ n 1))", "");
        of_statement("a range one earlier", "(integer i 0 n)", "(integer i (- 0 1) n)", "");
        of_statement("a range one longer", "(integer j k n)", "(integer j k (+ n 1))", "");
        of_statement("a range one earlier", "(integer j k n)", "(integer j (- k 1) n)", "");
        of_statement("knots of another kind", "(knots clamped)", "(knots open)", "");
        of_statement("knots without a hypothesis", "(knots open)", "(knots)", "");
        of_statement("knots without a hypothesis", "(knots symmetric)", "(knots)", "");
        of_statement("knots without a hypothesis", "(knots interior)", "(knots)", "");
        of_statement(
            "knots of a kind that is not known",
            "(knots",
            "(knots nice",
            "expected an adjective of knots",
        );
        of_statement("a closed end", "open (t (+ j 1)))", "closed (t (+ j 1)))", "");
        of_statement("a closed end", "(open (t i)", "(closed (t i)", "");
        of_statement("a name that is not bound", "(var x)", "(var y)", "unknown name y");
        of_statement(
            "a name bound twice",
            "(for (degree",
            "(for (real x) (real x) (degree",
            "the name x is taken",
        );
        of_statement("a word that is not known", "(then ", "(then (lucky) ", "expected a formula");
        of_statement("one conclusion more", "(then ", "(then (chain (int 0) (= (int 1))) ", "");
        of_statement("one conclusion more", "(then ", "(then (chain (of (G 0) (at (t 0))) (> (int 0))) ", "");
        of_statement(
            "one conclusion more",
            "(then ",
            "(then (chain (of (G 0) (left (t m))) (= (int 0))) ",
            "",
        );
        of_statement("sections besides", "(if", "(section) (if", "expected");
        if let (Some(goal), Some(section)) = (bracket(&proof, "(goal "), bracket(&proof, "(section ")) {
            let without =
                |range: std::ops::Range<usize>| format!("{}{}", &proof[..range.start], &proof[range.end..]);
            let twice =
                |range: std::ops::Range<usize>| format!("{} {}", &proof[..range.end], &proof[range.start..]);
            forgeries.push((
                "a goal left out",
                statement.clone(),
                without(goal.clone()),
                "missing in its place",
            ));
            forgeries.push((
                "a section left out",
                statement.clone(),
                without(section.clone()),
                "missing in its place",
            ));
            forgeries.push((
                "a section twice",
                statement.clone(),
                twice(section),
                "that the statement does not have",
            ));
            forgeries.push((
                "a goal twice",
                statement.clone(),
                twice(goal),
                "that the statement does not have",
            ));
        }
        for (what, statement, proof, want) in forgeries {
            let found = reason(&statement, &proof);
            // True all the same: at a last knot without copies there are others; the claim outside says `clamped` too; what
            // is true by the order of knots has nothing to prove.
            let true_too = [
                ("L3.10.amended", "knots without a hypothesis"),
                ("abstract.classical.amended", "knots without a hypothesis"),
                ("proof.T3.5.2.cover.amended", "a degree without a proof"),
            ];
            let expected = true_too.contains(&(name.as_str(), what));
            if found.starts_with("accepted") != expected || !expected && !found.contains(want) {
                wrong.push(format!("{name}, {what}:\n  found: {found}\n  wanted: {want}"));
            }
            *seen.entry(what).or_insert(0) += 1;
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    let all: i32 = seen.values().sum();
    assert!(all > 200 && seen.len() > 20, "{all}: {seen:?}");
}

#[test]
fn forgeries_of_one_certificate() {
    let all = certificates();
    let table = [
        // A wrong place of x: the functions there are others.
        ("T3.5.2.printed", "(at (var x))", "(at (t i))", "conclusion 1 is not decided"),
        ("T3.5.2.printed", "(at (var x))", "(at (t 0))", "conclusion 1 is not decided"),
        ("T3.5.2.printed", "(open (t i) open (t (+ (+ i k) 1)))", "(open (t i) open (t (+ (+ i k) 2)))", ""),
        ("T3.5.2.printed", "(> (int 0))", "(> (int 1))", "no monomial in positive"),
        ("T3.5.2.printed", "(G i)", "(G (+ i 1))", ""),
        ("T3.5.2.printed", "(G i)", "(G i (+ k 1))", "conclusion 1 is not decided"),
        ("T3.5.2.printed", "(G i)", "(D (G i) 1)", ""),
        ("T3.5.2.printed", "(if)", "(if (chain (int i) (> (int n))))", "that the statement does not have"),
        ("T3.5.2.printed", "(if)", "(if (chain (t k) (= (t m))))", ""),
        ("T3.5.2.printed", "(knots)", "", "nothing but weights"),
        ("T3.5.2.printed", "(knots)", "(instances U0)", "expected instance"),
        ("T3.5.2.printed", "(knots)", "(gaps (gap 1))", "it is about gaps"),
        ("T3.5.2.printed", "(degree 0)", "(degree 1)", "a sentence about this degree"),
        ("T3.5.2.printed", "(degree 0)", "(degree 0 2)", "a sentence about this degree"),
        // One summand less, or a span beside.
        ("T3.5.3.amended", "(sum i (- j k) j", "(sum i (- j k) (- j 1)", ""),
        ("T3.5.3.amended", "(sum i (- j k) j", "(sum i (+ (- j k) 1) j", ""),
        ("T3.5.3.amended", "(sum i 0 n", "(sum i 1 n", "conclusion 1 is not decided"),
        ("T3.5.3.amended", "(sum i 0 n", "(sum i 0 (+ n 1)", "conclusion 1 is not decided"),
        ("T3.5.3.amended", "(= (int 1))", "(= (int 2))", "the two sides differ"),
        ("T3.5.3.amended", "open (t (+ j 1))", "closed (t (+ j 1))", ""),
        ("T3.5.3.amended", "(integer j k n)", "(integer j 0 (- m 1))", "conclusion 1 is not decided"),
        // A copy of a knot left out.
        ("T3.5.1.amended", "(= (t (+ i k)))", "(= (t (+ (+ i k) 1)))", "the two sides differ"),
        ("T3.5.1.amended", "(= (t (+ i k)))", "(= (t (- i 1)))", ""),
        ("T3.5.1.amended", "(= (t m)) (= (var x))", "(= (t m)) (= (t i))", "the two sides differ"),
        ("T3.5.1.amended", "(not (chain (var x)", "(not (chain (t 0)", ""),
        ("T3.5.1.amended", "(open (t i)", "(closed (t i)", "is missing in its place"),
        ("T3.5.1.amended", "(= (int 0))", "(>= (int 1))", ""),
        ("P3.1.3.amended", "(integers i 1 n)", "(integers i 0 n)", "the two sides differ"),
        ("P3.1.3.amended", "(left (t m))", "(at (t k))", ""),
        ("P3.1.3.amended", "(left (t m))", "(right (t m))", "conclusion 3"),
        ("L3.6.printed", "(integer q 0 (- k 1))", "(integer q 0 k)", "conclusion"),
        ("L3.9.amended", "(/= (int (+ k 2)))", "(/= (int (+ k 3)))", "the two sides differ"),
        ("L3.10.amended", "(chain (t n) (< (t (+ n 1))))", "", "is missing in its place"),
        ("P3.1.2.printed", "(chain (t k) (< (t (- m k))))", "", ""),
        ("P3.1.2.printed", "(knots interior)", "(knots symmetric)", ""),
        ("T3.5.4.amended", "(<= (int k))", "(<= (int (+ k 1)))", ""),
        ("T3.5.4.amended", "(alpha (- (int 1) (alpha alpha)))", "(alpha infinity)", "the two sides differ"),
        ("T3.5.4.amended", "(G (- n i))", "(G i)", ""),
        ("T4.1.printed", "(- (int 1) (of (w i (+ (- k q) 1)) (at (var x))))", "(int 1)", ""),
        ("X.order.printed", "(real s >)", "(real s)", "conclusion 1 is not decided"),
        ("X.order.printed", "(real s >)", "(real s <)", ""),
    ];
    let mut wrong = Vec::new();
    for (name, from, to, want) in table {
        let [statement, proof] = &all[name];
        if !statement.contains(from) {
            wrong.push(format!("{name}: {from} in {statement}"));
        }
        let found = reason(&statement.replace(from, to), proof);
        if found.starts_with("accepted") || !found.contains(want) {
            wrong.push(format!("{name}, {from} → {to}:\n  found: {found}\n  wanted: {want}"));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// A refutation of a sentence about functions of degree 1 on (0, 0, 1, 2), by a point.
fn point(hypotheses: &str, conclusion: &str, point: &str) -> String {
    let statement = format!(
        "(statement 2 (claim \"X\") (form printed) (verdict refuted) (scope instance) (degrees 1)
            {MOBIUS}
            (define C () y (sum i 0 n (* (coefficient d i) (of (G i) (at (var y))))))
            (sentence (for (degree 0) (knots) (integer i 0 n) (point x (closed (t 0) closed (t m))) (points d))
                (if {hypotheses}) (then {conclusion}))
            (point (k 1) (knots 0 0 1 2) (parameter r 2) {point}))"
    );
    reason(&statement, "(proof 1)")
}

#[test]
fn points_refute_what_is_false_there_and_nothing_else() {
    let whole = "(integer i 1) (real x 3/2) (points d 1 -1)";
    let sum = "(chain (sum i 0 n (of (G i) (at (var x)))) (= (int 1)))"
        .replace(" i ", " j ")
        .replace("(G i)", "(G j)");
    let value = "(chain (of (G i) (at (var x))) (= 1/3))";
    let table = [
        ("", sum.as_str(), whole, "accepted"),
        // r(x − a) : (b − x) = 2·(1/2) : (1/2), and on the falling side 1/3 of it is left.
        ("", "(chain (of (G i) (at (var x))) (/= 1/3))", whole, "accepted"),
        ("", value, whole, "no conclusion fails there"),
        ("", "(chain (of (G i) (at (var x))) (/= 1/4))", whole, "no conclusion fails there"),
        ("", "(chain (of (defined C) (at (var x))) (/= -1/3))", whole, "accepted"),
        ("", "(chain (of (defined C) (at (var x))) (/= 1/3))", whole, "no conclusion fails there"),
        ("", "(chain (of (G (+ i 1)) (at (var x))) (= (int 0)))", whole, "accepted"),
        ("(chain (var x) (> (int 1)))", &sum, whole, "accepted"),
        ("(chain (var x) (< (int 1)))", &sum, whole, "no conclusion fails there"),
        ("(chain (alpha alpha) (/= infinity))", &sum, whole, "accepted"),
        ("(chain (alpha alpha) (= (int 2)))", &sum, whole, "accepted"),
        ("(chain (alpha alpha) (= infinity))", &sum, whole, "no conclusion fails there"),
        ("(chain (alpha alpha) (< (int 0)))", &sum, whole, "no conclusion fails there"),
        ("(chain (int (mult (real (var x)))) (= (int 0)))", &sum, whole, "accepted"),
        ("(chain (int (mult (real (var x)))) (> (int 0)))", &sum, whole, "no conclusion fails there"),
        ("(chain (int (mult (real (t 0)))) (= (int 2)))", &sum, whole, "accepted"),
        ("(chain (int (mult (real (- (var x) 1/2)))) (= (int 1)))", &sum, whole, "accepted"),
        ("(chain (int (mult (real (t 2)))) (= (int 2)))", &sum, whole, "no conclusion fails there"),
        ("", "(chain (of (D (D (G 1) -1) 1) (at (var x))) (/= 1/3))", whole, "no conclusion fails there"),
        ("(continuous (function (G i)))", &sum, whole, "accepted"),
        ("(not (continuous (function (G i))))", &sum, whole, "no conclusion fails there"),
        ("(free-weights (integer k))", &sum, whole, "no conclusion fails there"),
        ("", "(tied (function (G i)))", whole, "no conclusion fails there"),
        (
            "",
            "(or (tied (function (G i))) (chain (of (G 7) (at (var x))) (= (int 0))))",
            whole,
            "no conclusion fails",
        ),
        // At 0 + 2 − 3/2 and at the value of a function there.
        ("", "(chain (of (G 0) (at (- (+ (t 0) (t m)) (var x)))) (/= 1/3))", whole, "accepted"),
        (
            "",
            "(chain (of (G 0) (at (- (+ (t 0) (t m)) (var x)))) (/= 2/3))",
            whole,
            "no conclusion fails there",
        ),
        ("", "(chain (of (G 0) (at (of (G 1) (at (var x))))) (/= 1/2))", whole, "accepted"),
        ("", "(chain (of (G 0) (at (of (G 1) (at (var x))))) (/= 1/3))", whole, "no conclusion fails there"),
        ("", "(chain (of (G 0) (left (- (var x) 1/2))) (/= (int 0)))", whole, "accepted"),
        ("", "(chain (of (G 9) (at (- (var x) 1/2))) (= (int 0)))", whole, "accepted"),
        ("", &sum, "(integer i 2) (real x 3/2)", "no conclusion fails there"),
        ("", &sum, "(integer i 1) (real x 5/2)", "no conclusion fails there"),
        ("", &sum, "(integer i 1)", "no conclusion fails there"),
        ("", &sum, "(real x 3/2)", "no conclusion fails there"),
        ("", &sum, "(integer i 1/2) (real x 3/2)", "with a name of its own and its numbers"),
        ("", &sum, "(integer i 1) (real x 3/2) (real x 1)", "with a name of its own and its numbers"),
        ("", &sum, "(integer i 1) (real x 3/2 1)", "with a name of its own and its numbers"),
        ("", &sum, "(integer i 1) (real x 3/2) (points d 1)", "with a name of its own and its numbers"),
        ("", &sum, "(integer i 1) (real x 3/2) (index beta 2)", "with a name of its own and its numbers"),
        ("", &sum, "(integer i 1) (real x 3/2) (index beta -1)", "with a name of its own and its numbers"),
        ("", &sum, "(integer i 1) (real x 3/2) (trust me)", "with a name of its own"),
    ];
    let mut wrong = Vec::new();
    for (hypotheses, conclusion, numbers, want) in table {
        let found = point(hypotheses, conclusion, numbers);
        if !found.contains(want) {
            wrong.push(format!("{hypotheses} {conclusion} {numbers}\n  found: {found}\n  wanted: {want}"));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// Claims of the paper as printed, each refuted by its smallest case; as amended, the same case refutes none.
#[test]
fn points_refute_claims_as_printed_only() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/points");
    let (all, mut amended) = (certificates(), 0);
    for entry in fs::read_dir(folder).expect("the folder is there") {
        let path = entry.expect("its entries can be read").path();
        let name = path.file_stem().expect("a file has a name").to_string_lossy().into_owned();
        let text = fs::read_to_string(&path).expect("it can be read");
        let found = reason(&text, "(proof 1)");
        assert!(
            found.ends_with("refuted, scope instance, degrees 1; point; sections 0, goals 0, lemmas 0"),
            "{name}: {found}"
        );
        assert!(
            reason(&text, "(proof 1 (section 1))").contains("that the statement does not have"),
            "{name}"
        );
        if let Some([other, _]) = all.get(&format!("{name}.amended")) {
            let of = |text: &str| bracket(text, "(sentence ").expect("there is a sentence");
            let mut forged = text.clone();
            forged.replace_range(of(&text), &other[of(other)]);
            let found = reason(&forged, "(proof 1)");
            assert!(found.contains("no conclusion fails there"), "{name}: {found}");
            amended += 1;
        }
    }
    assert!(amended > 6, "{amended}");
}

#[test]
fn adjectives_have_to_be_true_where_a_point_refutes() {
    // False whatever the knots are: so the point is a refutation exactly if the knots have the property.
    let check_of = |adjective: &str, k: usize, knots: &str| {
        let statement = format!(
            "(statement 2 (claim \"X\") (form printed) (verdict refuted) (scope instance) (degrees {k})
            {MOBIUS}
                (sentence (for (degree 0) (knots {adjective}) (real x)) (if) (then (chain (of (G 0) (at (var x))) (< (int 0)))))
                (point (k {k}) (knots {knots}) (parameter r 1) (real x 0)))"
        );
        reason(&statement, "(proof 1)")
    };
    let table = [
        ("open", 1, "0 0 1 1", true),
        ("open", 1, "0 0 1 2", false),
        ("open", 2, "0 0 0 0", false),
        ("clamped", 1, "0 0 0 1 1", false),
        ("clamped", 1, "0 0 1 1", true),
        ("symmetric", 1, "0 1 3 4", true),
        ("symmetric", 1, "0 1 2 4", false),
        ("simple", 1, "0 1 3 4", true),
        ("simple", 1, "0 1 1 4", false),
        ("equidistant", 1, "0 1 2 3", true),
        ("equidistant", 1, "0 1 2 4", false),
        ("bernstein", 1, "0 0 1 1", true),
        ("bernstein", 1, "0 0 1 2 2", false),
        ("inner", 1, "0 0 0 1 2 2 2", true),
        ("inner", 1, "0 0 1 1 2 2", false),
        ("interior", 1, "0 0 1 2 2", true),
        ("interior", 1, "0 0 0 1 2 2", false),
        // No knot has an index in k + 1, …, n.
        ("interior", 1, "0 1 1 2", true),
        ("inner", 1, "0 1 1 2", false),
    ];
    for (adjective, k, knots, holds) in table {
        let found = check_of(adjective, k, knots);
        assert_eq!(found.starts_with("accepted"), holds, "{adjective}, {knots}: {found}");
    }
    for (knots, want) in
        [("0 1", "k + 2 knots at least"), ("1 0 2", "knots that do not fall"), ("1 1 1", "two that differ")]
    {
        let found = check_of("", 1, knots);
        assert!(found.contains(want), "{knots}: {found}");
    }
}

#[test]
fn definitions_without_an_end_are_given_up_on() {
    let deep = |inside: &str| format!("{}{inside}{}", "(neg ".repeat(60), ")".repeat(60));
    let statement = |body: &str, order: &str| {
        format!(
            "(statement 2 (claim \"X\") (form printed) (verdict proved) (scope knots) (degrees 2)
            {MOBIUS}
                (define E (i) y {body})
                (sentence (for (degree 0) (knots) (point x (open (t 0) open (t m)))) (if)
                    (then (chain (of {order} (at (var x))) (= (int 0))))))"
        )
    };
    let again = "(of (defined E (+ i 1)) (at (var y)))";
    let sum = format!("(sum j 0 n (* (int j) {again}))");
    for body in [again.to_owned(), deep(again), sum, format!("(* (var y) {})", deep(again))] {
        for order in ["(defined E 0)", "(D (defined E 0) 1)"] {
            let found = reason(&statement(&body, order), "(proof 1)");
            assert!(found.contains("conclusion 1 is not decided"), "{body}: {found}");
        }
    }
}

/// Whatever a sentence or a point is changed to, there is an answer.
#[test]
fn no_sentence_stops_the_checker() {
    let points = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/points");
    let point = |name: &str| fs::read_to_string(points.join(name)).expect("it can be read");
    let mut texts: Vec<_> =
        ["T3.5.1", "P4.1.1", "T3.5.4"].map(|name| point(&format!("{name}.statement"))).into();
    let all = certificates();
    texts.extend(
        ["T3.5.2.printed", "L3.9.amended", "T4.1.printed", "X.order.printed"]
            .map(|name| all[name][0].clone()),
    );
    let others = "( ) 0 1 -1 1000000 k n m i x t G w D at left var int chain = /= <= and all integers ratio alpha infinity";
    let (mut tried, mut accepted) = (0, 0);
    for text in texts {
        let text = text.replace('(', " ( ").replace(')', " ) ").replace("0 1 2 3", "1").replace("1 2 3", "1");
        let tokens: Vec<_> = text.split_whitespace().collect();
        for at in 0..tokens.len() {
            for other in [""].into_iter().chain(others.split(' ').skip(at % 3).step_by(3)) {
                let mut mutant = tokens.clone();
                mutant[at] = other;
                tried += 1;
                accepted += usize::from(check_within(3_000_000, &mutant.join(" "), "(proof 1)").is_ok());
            }
        }
    }
    assert!(tried > 5_000 && accepted > 20, "{tried}, {accepted}");
}
