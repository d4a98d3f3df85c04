//! Whether what is derived, and proved, is true: against values that are computed from the definition, on all small knot
//! vectors; with sentences that are false at one place only, and with sentences made false at one token each.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use std::rc::Rc;

use crate::derive::sections;
use crate::family::Family;
use crate::obligation::{Subject, obligations};
use crate::point::Numbered;
use crate::token::{Node, tree};

/// The paper's weights.
const MOBIUS: &str = r#"(family "mobius" (parameter r () (> 0)) (rise (* (parameter r) (- (var x) (var a))))
    (fall (- (var b) (var x))))"#;

fn mobius() -> Rc<Family<'static>> {
    let node = Box::leak(Box::new(tree(MOBIUS).unwrap()));
    Rc::new(Family::read(node).unwrap())
}

/// A fraction of small numbers.
#[derive(Clone, Copy, PartialEq, Debug)]
struct Small(i128, i128);

impl Small {
    fn new(a: i128, b: i128) -> Self {
        let (mut x, mut y) = (a.abs(), b.abs());
        while y != 0 {
            (x, y) = (y, x % y);
        }
        Small(a / x * b.signum(), b / x * b.signum())
    }
    fn times(self, other: Self) -> Self {
        Small::new(self.0 * other.0, self.1 * other.1)
    }
    fn plus(self, other: Self) -> Self {
        Small::new(self.0 * other.1 + other.0 * self.1, self.1 * other.1)
    }
    fn text(self) -> String {
        if self.1 == 1 { self.0.to_string() } else { format!("{}/{}", self.0, self.1) }
    }
}

/// G_i^d at x/2, by D3.3: on the span that holds x, or for the limit from the left the one that ends there or holds it.
fn definition(knots: &[i128], (i, d): (usize, usize), x: i128, r: Small, left: bool) -> Small {
    let last = knots[knots.len() - 1];
    let holds = |a: i128, b: i128| {
        if left || x == 2 * last { 2 * a < x && x <= 2 * b } else { 2 * a <= x && x < 2 * b }
    };
    if d == 0 {
        return Small::new(i128::from(holds(knots[i], knots[i + 1])), 1);
    }
    let weight = |i: usize| {
        let (a, b) = (knots[i], knots[i + d]);
        let rise = r.times(Small::new(x - 2 * a, 2));
        let both = rise.plus(Small::new(2 * b - x, 2));
        if both.0 == 0 { Small::new(0, 1) } else { rise.times(Small::new(both.1, both.0)) }
    };
    let (a, b) = (definition(knots, (i, d - 1), x, r, left), definition(knots, (i + 1, d - 1), x, r, left));
    let rising = if a.0 == 0 { a } else { weight(i).times(a) };
    let falling =
        if b.0 == 0 { b } else { Small::new(1, 1).plus(weight(i + 1).times(Small::new(-1, 1))).times(b) };
    rising.plus(falling)
}

/// All knots with gaps 0 and 1.
fn vectors(k: usize, longest: usize) -> Vec<Vec<i128>> {
    let mut all = Vec::new();
    for m in k + 1..=longest {
        for pattern in 1..1_u32 << m {
            let mut knots = vec![0];
            for gap in 0..m {
                knots.push(knots[knots.len() - 1] + i128::from(pattern >> gap & 1));
            }
            all.push(knots);
        }
    }
    all
}

fn list<T: ToString>(all: impl IntoIterator<Item = T>) -> String {
    all.into_iter().map(|one| one.to_string()).collect::<Vec<_>>().join(" ")
}

#[test]
fn values_at_numbers_are_those_of_the_definition() {
    let (mut seen, mut zeros) = (0, 0);
    for (k, knots) in (0..3).flat_map(|k| vectors(k, k + 4).into_iter().map(move |knots| (k, knots))) {
        let last = knots[knots.len() - 1];
        for x in -1..=2 * last + 1 {
            for (r, left) in [(Small::new(1, 2), false), (Small::new(3, 1), true)] {
                let degrees = (0..=k).flat_map(|d| (0..knots.len() - d - 1).map(move |i| (i, d)));
                for (i, d) in degrees {
                    let value = definition(&knots, (i, d), x, r, left && x > 0 && x <= 2 * last);
                    let outside = x < 0 || x > 2 * last || left && x == 0;
                    let value = if outside { Small::new(0, 1) } else { value };
                    let side = if left { "left" } else { "at" };
                    let sentence = format!(
                        "(sentence (for (degree 0) (knots) (real x)) (if)
                            (then (chain (of (G {i} {d}) ({side} (var x))) (/= {}))))",
                        value.text()
                    );
                    let point = format!(
                        "(point (k {k}) (knots {}) (parameter r {}) (real x {}))",
                        list(&knots),
                        r.text(),
                        Small::new(x, 2).text()
                    );
                    let (sentence, point) = (tree(&sentence).unwrap(), tree(&point).unwrap());
                    crate::work::begin(10_000_000);
                    let refuted = Numbered::new(&mobius(), &point)
                        .and_then(|numbers| numbers.refutes(&mobius(), &[], &sentence));
                    assert!(refuted.is_ok(), "{knots:?}, G_{i}^{d}, x = {x}/2, {side}, is not {value:?}");
                    seen += 1;
                    zeros += usize::from(value.0 == 0);
                }
            }
        }
    }
    assert!(seen > 5_000 && zeros > 1_000 && seen - zeros > 1_000, "{seen}, {zeros}");
}

/// A statement without a proof, and a proof of all its goals by unfolding the definition.
fn proved(definitions: &str, sentence: &str, k: i64) -> Result<usize, String> {
    let statement = format!(
        "(statement 2 (claim \"X\") (form printed) (verdict proved) (scope knots) (degrees {k}) {MOBIUS} {definitions} {sentence})"
    );
    crate::work::begin(1_000_000_000);
    let whole = format!("(all {definitions} {sentence})");
    let whole = tree(&whole).map_err(|e| e.to_string())?;
    let parts = whole.fields("all").unwrap();
    let (sentence, definitions) = parts.split_last().unwrap();
    crate::sentence::read(&mobius(), definitions, sentence).map_err(|e| e.to_string())?;
    let sections = sections(&mobius(), definitions, sentence, k).map_err(|e| e.to_string())?;
    let goals = |section: &Node<'_>| {
        section.fields("section").unwrap().last().unwrap().fields("goals").unwrap().len()
    };
    let by = |count| (1..=count).map(|goal| format!(" (goal {goal} (by))")).collect::<String>();
    let proofs =
        (1..).zip(&sections).map(|(label, section)| format!("(section {label}{})", by(goals(section))));
    let checked = crate::check(&statement, &format!("(proof 1 {})", list(proofs)));
    checked.map(|checked| checked.goals).map_err(|e| e.to_string())
}

/// A point of a small knot vector that refutes the sentence.
fn refuted(definitions: &str, sentence: &str, k: usize, longest: usize) -> Option<String> {
    let whole = format!("(all {definitions} {sentence})");
    let whole = tree(&whole).unwrap();
    let (sentence, definitions) = whole.fields("all").unwrap().split_last().unwrap();
    crate::work::begin(usize::MAX);
    let obligations = obligations(sentence, i64::try_from(k).unwrap(), &Subject::Knots, true).unwrap();
    let mut names = BTreeSet::new();
    for obligation in &obligations {
        names.extend(obligation.integers.iter().map(|range| range[0].name().unwrap()));
    }
    let reals: BTreeSet<_> =
        obligations.iter().flat_map(|of| of.reals.iter().map(|(name, _)| *name)).collect();
    for knots in vectors(k, longest) {
        let last = knots[knots.len() - 1];
        let m = i128::try_from(knots.len()).unwrap() - 1;
        let mut choices = vec![String::new()];
        for name in &names {
            let with = |so_far: &String| {
                (0..=m + 1).map(|i| format!("{so_far} (integer {name} {i})")).collect::<Vec<_>>()
            };
            choices = choices.iter().flat_map(with).collect();
        }
        let controls = list((0..knots.len() - k - 1).map(|i| [2, -1, 3, 7, -5][i % 5]));
        for x in -1..=2 * last + 1 {
            for choice in &choices {
                let r = ["1/2", "1", "3"][choice.len() % 3];
                let reals =
                    list(reals.iter().map(|name| format!("(real {name} {})", Small::new(x, 2).text())));
                let point = format!(
                    "(point (k {k}) (knots {}) (parameter r {r}) {reals} {choice} (points d {controls}))",
                    list(&knots)
                );
                let node = tree(&point).unwrap();
                let numbers = Numbered::new(&mobius(), &node).unwrap();
                if numbers.refutes(&mobius(), definitions, sentence).is_ok() {
                    return Some(point);
                }
            }
        }
    }
    None
}

/// The claims of `tests/claims`, as definitions and sentence.
fn claims() -> Vec<(String, String, String)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/claims");
    let mut all = Vec::new();
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_some_and(|extension| extension == "statement") {
            let text = fs::read_to_string(&path).unwrap();
            let start = text.find("(define ").or(text.find("(sentence")).unwrap();
            let middle = text.find("(sentence").unwrap();
            let end = text.rfind(')').unwrap();
            let name = path.file_stem().unwrap().to_string_lossy().into_owned();
            all.push((name, text[start..middle].to_owned(), text[middle..end].to_owned()));
        }
    }
    all.sort();
    assert!(all.len() > 15);
    all
}

#[test]
fn what_is_proved_is_refuted_nowhere() {
    for (name, definitions, sentence) in claims() {
        if name.starts_with("T3.5.4") || name.starts_with("abstract") || name.starts_with("X.order") {
            // Points at t_0 + t_m − x, or of another index, and very many integers.
            continue;
        }
        let k = if sentence.contains("(degree 2)") { 2 } else { 1 };
        assert_eq!(refuted(&definitions, &sentence, k, k + 2), None, "{name}");
    }
}

/// For every place a sentence that is false there only: nothing is derived, or not proved.
#[test]
fn no_place_is_left_out() {
    let sentence = |binders: &str, hypotheses: &str, conclusion: &str| {
        format!("(sentence (for (degree 0) (knots) {binders}) (if {hypotheses}) (then {conclusion}))")
    };
    let x = "(of (G i) (at (var x)))";
    let positive = format!("(chain {x} (> (int 0)))");
    let zero = format!("(chain {x} (= (int 0)))");
    let (first, last) = ("(chain (var x) (= (t 0)))", "(chain (var x) (= (t m)))");
    let inside = "(chain (t 0) (< (var x)) (< (t m)))";
    let knot = |relation: &str| format!("(chain (int (mult (real (var x)))) ({relation} (int 0)))");
    let i = "(integer i 0 n) (real x)";
    for k in 0..3_i64 {
        let mut table = vec![
            (sentence(i, "(chain (var x) (< (t 0)))", &positive), "before"),
            (sentence(i, "(chain (var x) (> (t m)))", &positive), "after"),
            (
                sentence(i, inside, &format!("(or (chain (int (mult (real (var x)))) (> (int 0))) {zero})")),
                "inside",
            ),
            (sentence(i, &format!("{inside} {}", knot("=")), &zero), "inside, by hypothesis"),
        ];
        for q in 1..k + 5 {
            let exactly = format!("(chain (int (mult (real (var x)))) (= (int {q})))");
            for (at, name) in [(first, "first"), (inside, "knot"), (last, "last")] {
                // The conclusion is false on every vector with such a knot.
                let false_there = format!("(=> {exactly} (chain (int 0) (= (int 1))))");
                let on = "(integer i 0 n) (point x (closed (t 0) closed (t m)))";
                let found = proved("", &sentence(on, at, &false_there), k);
                let undecided = found.as_ref().is_err_and(|why| why.contains("conclusion 1 is not decided"));
                assert!(undecided, "{name}, {q} copies, k = {k}: {found:?}");
            }
        }
        // What is a goal, or not decided, is neither true nor false.
        let on = "(integer i 0 n) (point x (open (t 0) open (t m)))";
        table.push((sentence(on, &format!("(not {zero})"), &zero), "not 0, by hypothesis"));
        table.push((sentence(on, "", &format!("(or {zero} (chain {x} (> (int 1))))")), "one of two"));
        table.push((sentence(on, "", &format!("(not (and {zero} (chain {x} (<= (int 1)))))")), "not both"));
        table.push((sentence(on, "", &format!("(and (chain {x} (>= (int 0))) {positive})")), "both"));
        let both = format!("(and (chain {x} (>= (int 0))) (chain {x} (<= (int 0))))");
        table.push((sentence(on, "", &format!("(or (chain (int 0) (= (int 1))) {both})")), "both, in an or"));
        table.push((sentence(on, "", &format!("(<=> {zero} (chain {x} (> (int 1))))")), "if and only if"));
        let closed = "(integer i 0 n) (point x (closed (t 0) closed (t m)))";
        for (relation, knot) in [("<", "(t (+ (+ i k) 1))"), (">", "(t i)")] {
            let ends = format!("(=> (chain {x} (/= (int 0))) (chain (var x) ({relation} {knot})))");
            table.push((sentence(closed, "", &ends), "an end of the support"));
        }
        // Far from the span, on either side.
        let near = "(integer i 0 n) (integer j 0 n) (point x (open (t j) open (t (+ j 1))))";
        for (away, range) in [("(>= (int (+ j 40)))", "(+ j 40) n"), ("(<= (int (- j 40)))", "0 (- j 40)")] {
            table.push((sentence(near, &format!("(chain (int i) {away})"), &positive), "far"));
            let sum = format!("(chain (sum l {range} (* (int 1) (of (G l 0) (at (var x))))) (= (int 0)))");
            let ones = format!("(chain (sum l {range} (int 1)) (= (int 0)))");
            let none = format!(
                "(or (all (integers l {range}) (chain (int 0) (= (int 1)))) (chain {x} (> (int 1))))"
            );
            let good = proved("", &sentence(near, "", &sum), k);
            assert!(good.is_ok(), "{good:?}");
            table.push((
                sentence(near, "", &format!("(and (chain {x} (>= (int 0))) {ones})")),
                "far, in a sum",
            ));
            table.push((sentence(near, "", &none), "far, in all"));
        }
        for (sentence, name) in table {
            let found = proved("", &sentence, k);
            assert!(found.is_err(), "{name}, k = {k}: {found:?}\n{sentence}");
        }
        // Without its fault the sentence is proved.
        let good = sentence(
            "(integer i 0 n) (point x (closed (t 0) closed (t m)))",
            "",
            &format!("(chain {x} (>= (int 0)))"),
        );
        assert!(proved("", &good, k).is_ok(), "{:?}", proved("", &good, k));
        let good = sentence(i, "(chain (var x) (< (t 0)))", &zero);
        assert!(proved("", &good, k).is_ok(), "{:?}", proved("", &good, k));
    }
}

/// What hypotheses say of s and n is as sharp as it can be, and no sharper.
#[test]
fn hypotheses_exclude_what_they_exclude() {
    let first = "(chain (t 0) (= (t k)))";
    let last = "(chain (t (- m k)) (= (t m)))";
    let in_span = "(in (var x) (open (t j) open (t (+ j 1))))";
    let at_knot = "(chain (t j) (= (var x)) (< (t (+ j 1))))";
    let copies = |q: &str| format!("(chain (int (mult (real (var x)))) {q})");
    let table = [
        // Hypotheses, and what is true of j in each case and false if one is added or taken away.
        (format!("{first} {in_span}"), ">=", "k", "(+ k 1)"),
        (format!("{last} {in_span}"), "<=", "n", "(- n 1)"),
        (format!("{first} {at_knot} {}", copies("(= (int 1))")), ">=", "(+ k 1)", "(+ k 2)"),
        (format!("{first} {at_knot} {}", copies("(= (int 2))")), ">=", "(+ k 2)", "(+ k 3)"),
        (
            format!("{first} {at_knot} {}", copies("(>= (int (+ k 3)))")),
            ">=",
            "(+ (* 2 k) 3)",
            "(+ (* 2 k) 4)",
        ),
        (format!("{at_knot} {}", copies("(= (int 2))")), ">=", "2", "3"),
        (format!("{in_span} (chain (int j) (< (int (- n 1))))"), "<=", "(- n 2)", "(- n 3)"),
        (format!("{in_span} (chain (int j) (> (int 2)))"), ">=", "3", "4"),
        (format!("{in_span} (among j 2 (- n 1))"), "<=", "(- n 1)", "(- n 2)"),
        (format!("{in_span} (among j 2 (- n 1))"), ">=", "2", "3"),
        (in_span.to_owned(), "<=", "(+ n k)", "(- (+ n k) 1)"),
    ];
    for (hypotheses, relation, holds, fails) in table {
        for k in 0..3 {
            let sentence = |bound: &str| {
                format!(
                    "(sentence (for (degree 0) (knots) (integer j 0 (- m 1)) (point x (open (t 0) open (t m))))
                        (if {hypotheses}) (then (chain (int j) ({relation} (int {bound})))))"
                )
            };
            let found = proved("", &sentence(holds), k);
            assert!(found.is_ok(), "{}, k = {k}: {found:?}", sentence(holds));
            let found = proved("", &sentence(fails), k);
            assert!(found.is_err(), "{}, k = {k}: {found:?}", sentence(fails));
        }
    }
}

/// The order of knots, and of x among them, is read off where it is so, and only there.
#[test]
fn orders_are_what_the_window_shows() {
    let table = [
        // At x in (t_j, t_{j+1}), two knots at least behind it and one before.
        ("(t (+ j 2))", ">=", "(t (+ j 1))", true),
        ("(t (+ j 2))", ">", "(t (+ j 1))", false),
        ("(t (+ j 2))", "=", "(t (+ j 1))", false),
        ("(t (+ j 2))", "/=", "(t (+ j 1))", false),
        ("(t (+ j 2))", ">", "(var x)", true),
        ("(t (+ j 2))", "/=", "(t j)", true),
        ("(t (- j 1))", "<=", "(t j)", true),
        ("(t (- j 1))", "<", "(t j)", false),
        ("(t (- j 1))", "<", "(var x)", true),
        ("(t 0)", "<=", "(t j)", true),
        ("(t 0)", "<", "(t j)", false),
        ("(t 0)", "<", "(t (+ j 1))", true),
        ("(t m)", ">=", "(t (+ j 1))", true),
        ("(t m)", ">", "(t (+ j 1))", false),
        ("(t m)", "=", "(t (+ j 2))", false),
        ("(t (+ j 3))", ">=", "(t j)", false),
        ("(- (t (+ j 2)) (t j))", ">", "(- (t (+ j 1)) (var x))", true),
        ("(- (t (+ j 2)) (t j))", ">", "(- (t (+ j 1)) (t (- j 1)))", false),
        ("(/ (int 1) (- (t (+ j 1)) (t j)))", ">", "(int 0)", true),
        ("(/ (int 1) (- (t (+ j 2)) (t (+ j 1))))", ">=", "(int 0)", false),
    ];
    for (a, relation, b, holds) in table {
        for k in 0..3 {
            let sentence = format!(
                "(sentence (for (degree 0) (knots) (integer j 1 (- m 2)) (point x (open (t j) open (t (+ j 1)))))
                    (if) (then (and (chain {a} ({relation} {b})) (in (var x) (closed (t 0) closed (t m))))))"
            );
            let found = proved("", &sentence, k);
            assert_eq!(found.is_ok(), holds, "{a} {relation} {b}, k = {k}: {found:?}");
        }
    }
}

/// α < 0 is r < 1, and α > 1 is r > 1, if α is a number.
#[test]
fn a_hypothesis_on_the_index_is_one_on_the_ratio() {
    let finite = "(chain (alpha alpha) (/= infinity))";
    for (hypothesis, finite, relation, holds) in [
        ("(< (int 0))", finite, "<", true),
        ("(< (int 0))", finite, ">", false),
        ("(< (int 0))", "", "<", false),
        ("(> (int 1))", finite, ">", true),
        ("(> (int 1))", finite, "<", false),
        ("(> (int 1))", "", ">", false),
    ] {
        let sentence = format!(
            "(sentence (for (degree 1) (knots) (integer j 0 (- m 1)) (point x (open (t j) open (t (+ j 1)))))
                (if {finite} (chain (alpha alpha) {hypothesis}))
                (then (chain (of (w j 1) (at (var x))) ({relation} (of (w j 1) (at (var x) (alpha infinity)))))))"
        );
        let found = proved("", &sentence, 1);
        assert_eq!(found.is_ok(), holds, "{hypothesis} {relation}: {found:?}");
    }
}

/// Sentences with one token changed.
fn mutants(sentence: &str) -> Vec<String> {
    let spaced = sentence.replace('(', " ( ").replace(')', " ) ");
    let tokens: Vec<_> = spaced.split_whitespace().collect();
    let mut all = Vec::new();
    let groups =
        ["0 1 k n m i j", "= < <= > >=", "closed open", "at left right", "+ -", "and or", "k 2", "knots"];
    for (at, token) in tokens.iter().enumerate() {
        for other in groups
            .iter()
            .map(|group| group.split(' ').collect::<Vec<_>>())
            .filter(|group| group.contains(token))
        {
            for other in other.into_iter().filter(|other| other != token) {
                let mut mutant = tokens.clone();
                mutant[at] = other;
                all.push(mutant.join(" "));
            }
        }
        // An adjective or a hypothesis less.
        if matches!(*token, "open" | "clamped" | "bernstein") && at > 1 && tokens[at - 1] == "knots" {
            let mut mutant = tokens.clone();
            mutant.remove(at);
            all.push(mutant.join(" "));
        }
    }
    all
}

#[test]
fn no_false_sentence_is_proved() {
    let short = ["L3.6", "L3.7", "P3.1.3", "T3.5.1", "T3.5.2", "T3.5.3", "P4.1.3", "T3.11", "proof.T3.5.3"];
    let own = claims().into_iter().filter(|(name, ..)| short.iter().any(|own| name.starts_with(own)));
    let all: Vec<_> = own
        .flat_map(|(name, definitions, sentence)| {
            mutants(&sentence).into_iter().map(move |mutant| (name.clone(), definitions.clone(), mutant))
        })
        .collect();
    let accepted = |(name, definitions, mutant): &(String, String, String)| {
        let accepted = proved(definitions, mutant, 1).is_ok();
        if accepted {
            assert_eq!(refuted(definitions, mutant, 1, 4), None, "{name}: {mutant}");
        }
        accepted
    };
    // They take a minute: as many at once as there is room for.
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    let accepted: usize = std::thread::scope(|scope| {
        let part = |first| all.iter().skip(first).step_by(threads).filter(|one| accepted(one)).count();
        let parts: Vec<_> = (0..threads).map(|first| scope.spawn(move || part(first))).collect();
        parts.into_iter().map(|part| part.join().expect("no false sentence is proved")).sum()
    });
    let tried = all.len();
    assert!(tried > 500 && accepted > 20, "{tried}, {accepted}");
}
