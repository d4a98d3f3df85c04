//! Formal statements, their proofs and the checker, without the engine: the statements are those of the recorded
//! verdicts.

#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests")]

use std::collections::{BTreeMap, BTreeSet, HashMap, HashSet};
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::{Arc, LazyLock};

use knotproof::certificate::{
    Certificate, Class, EvaluationError, Evaluator, Formula, GoalError, ProofError, Section, Sexp, Shown,
    Statement, StatementError, Unfolding, Weighted, derived, prove, statement,
};
use knotproof::judge::Scope;
use knotproof::language::{Form, claims, paper};
use knotproof::report::{Baseline, Finding};
use knotproof::scalar::{BigRational, Jet, integer, rational};
use knotproof::spline::{Basis, Curve, Index, KnotVector, Side, weight};
use knotproof_checker::{Checked, WORK, check, check_each, check_within};
use proptest::prelude::*;
use rayon::prelude::*;

/// A formal statement, with the name of its certificate in the recorded verdicts.
struct Recorded {
    name: String,
    statement: Statement,
}

/// A finding that was recorded, and what the program says about it in formal terms.
struct Stated {
    claim: String,
    form: Form,
    finding: Finding,
    statement: Option<Statement>,
}

static FINDINGS: LazyLock<Vec<Stated>> = LazyLock::new(|| {
    let mut findings = Vec::new();
    for entry in Baseline::recorded().expect("proofs/verdicts.json can be read").claims {
        let mut add = |form, finding| findings.push((entry.id.clone(), form, finding));
        add(Form::Printed, entry.as_printed);
        entry.amended.into_iter().for_each(|finding| add(Form::Amended, finding));
        entry.by_degree.into_iter().for_each(|of| add(Form::Degree(of.degree), of.finding));
    }
    let stated = |(claim, form, finding): (String, Form, Finding)| {
        let of = claims().into_iter().find(|other| other.id() == claim).expect("a claim of the paper");
        let statement = statement(of, form, finding.witness.as_ref()).expect("it is in the language");
        Stated { claim, form, finding, statement }
    };
    findings.into_par_iter().map(stated).collect()
});

static RECORDED: LazyLock<Vec<Recorded>> = LazyLock::new(|| {
    let certified = |Stated { finding, statement, .. }: &Stated| {
        let name = finding.certificate.clone()?;
        let statement = statement.clone().expect("a certificate has a formal statement");
        Some(Recorded { name, statement })
    };
    let all = FINDINGS.iter().filter_map(certified);
    // One can be of several degrees.
    let mut names = HashSet::new();
    all.filter(|Recorded { name, .. }| names.insert(name.clone())).collect()
});

/// The two files of a certificate.
struct Files {
    name: String,
    statement: String,
    proof: String,
}

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("proofs/certs")
}

static FILES: LazyLock<Vec<Files>> = LazyLock::new(|| {
    let read = |name: &str, extension: &str| {
        let path = folder().join(format!("{name}.{extension}"));
        fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
    };
    let files = |Recorded { name, .. }: &Recorded| Files {
        name: name.clone(),
        statement: read(name, "statement"),
        proof: read(name, "proof"),
    };
    RECORDED.iter().map(files).collect()
});

#[test]
fn every_settled_finding_has_a_certificate_if_it_is_stated_formally() {
    for Stated { claim, form, finding, statement } in &*FINDINGS {
        assert_eq!(finding.certificate.is_some(), statement.is_some(), "{claim} ({form})");
        let checked: &[&str] = match (finding.status.as_str(), &finding.certificate) {
            (_, Some(_)) => &["prover", "checker"],
            ("proved" | "refuted", None) => &["engine"],
            _ => &[],
        };
        let mut by: Vec<_> = finding.checked_by.iter().map(String::as_str).collect();
        // A theorem adds to it, and takes nothing from it.
        assert_eq!(by.pop_if(|by| *by == "coq").is_some(), !finding.theorems.is_empty(), "{claim} ({form})");
        assert!(by.ends_with(checked), "{claim} ({form}): {by:?}");
        assert!(by.iter().all(|by| ["engine", "prover", "checker"].contains(by)), "{claim} ({form}): {by:?}");
        let far = |scope: &str| finding.scope.as_deref() == Some(scope);
        let said = finding.certificate.is_some() || !finding.theorems.is_empty();
        assert!(said || !far("knots") && !far("alpha"), "{claim} ({form})");
    }
    assert!(RECORDED.len() > 130, "only {} certificates", RECORDED.len());
}

#[test]
fn the_folder_holds_the_recorded_certificates_and_nothing_else() {
    let entries =
        fs::read_dir(folder()).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap());
    let found: BTreeSet<String> = entries.collect();
    let pair = |Recorded { name, .. }: &Recorded| ["proof", "statement"].map(|of| format!("{name}.{of}"));
    let expected: BTreeSet<String> = RECORDED.iter().flat_map(pair).collect();
    assert_eq!(found, expected);
    assert_eq!(expected.len(), 2 * RECORDED.len(), "two certificates have one name");
}

/// The prover is a function of the statement: another machine writes the same files.
#[test]
fn proving_again_gives_the_same_files() {
    RECORDED.par_iter().zip(&*FILES).for_each(|(Recorded { name, statement }, files)| {
        let certificate = Certificate::of(statement.clone()).unwrap_or_else(|error| panic!("{error}"));
        assert_eq!(&certificate.name(), name);
        let same = certificate.statement_text() == files.statement && certificate.proof_text() == files.proof;
        assert!(same, "{name}: not as in proofs/certs; run `cargo run --release -- prove`");
    });
}

fn honest(files: &Files) -> Checked {
    // There is room for certificates that are several times as long.
    let checked = check_within(WORK / 9, &files.statement, &files.proof);
    checked.unwrap_or_else(|rejected| panic!("{}: {rejected}", files.name))
}

#[test]
fn the_checker_accepts_all_and_reads_the_same_headers() {
    RECORDED.par_iter().zip(&*FILES).for_each(|(Recorded { name, statement }, files)| {
        let checked = honest(files);
        let verdict = if statement.refuted { "refuted" } else { "proved" };
        assert_eq!(checked.claim, statement.claim, "{name}");
        assert_eq!(checked.form, statement.form.to_string(), "{name}");
        assert_eq!(
            (checked.verdict.as_str(), checked.scope.as_str()),
            (verdict, statement.scope.name()),
            "{name}"
        );
        assert_eq!(checked.degrees, statement.degrees, "{name}");
        // Both unroll a statement alike.
        let sections = statement.expand().unwrap();
        let goals: usize = sections.iter().map(|section| section.goals.len()).sum();
        assert_eq!((checked.sections, checked.goals), (sections.len(), goals), "{name}");
    });
}

/// A scope in the verdicts is the one that the checker read.
#[test]
fn the_recorded_scope_is_that_of_the_certificate() {
    for Stated { claim, form, finding, .. } in &*FINDINGS {
        let Some(name) = &finding.certificate else { continue };
        let files = FILES.iter().find(|files| files.name == *name).unwrap();
        let statement = Sexp::parse_all(&files.statement).unwrap().remove(0).to_string();
        match &finding.scope {
            Some(scope) => {
                // No certificate is about every degree: that a theorem says.
                let far = if scope == "degree" { "knots" } else { scope };
                assert!(statement.contains(&format!("(verdict proved) (scope {far})")), "{name}");
            }
            None => {
                assert_eq!(finding.status, "refuted", "{claim} ({form})");
                assert!(statement.contains("(verdict refuted) (scope instance)"), "{name}");
            }
        }
    }
}

// Changed certificates.

fn tokens(text: &str) -> Vec<String> {
    let (mut tokens, mut rest) = (Vec::new(), text.trim_start());
    while let Some(first) = rest.chars().next() {
        let length = match first {
            '(' | ')' => 1,
            '"' => rest[1..].find('"').unwrap() + 2,
            _ => rest.find(|c: char| c.is_whitespace() || c == '(' || c == ')').unwrap_or(rest.len()),
        };
        tokens.push(rest[..length].to_owned());
        rest = rest[length..].trim_start();
    }
    tokens
}

/// One change at one token.
struct Change {
    kind: &'static str,
    at: usize,
    instead: Vec<String>,
}

/// The words of proofs, and some that are none.
const WORDS: [&str; 12] = [
    "proof",
    "section",
    "lemma",
    "goal",
    "by",
    "using",
    "split",
    "orders",
    "functional",
    "evaluate",
    "u",
    "defined",
];

/// What can be done to a token of a proof.
fn changes(tokens: &[String], at: usize) -> Vec<Change> {
    let token = &tokens[at];
    let mut changes = Vec::new();
    let mut add = |kind, instead: &[&str]| {
        changes.push(Change { kind, at, instead: instead.iter().map(ToString::to_string).collect() });
    };
    add("deleted", &[]);
    add("doubled", &[token, token]);
    let before = |n: usize| at.checked_sub(n).map(|at| tokens[at].as_str());
    if let Ok(number) = token.parse::<i64>() {
        let kind = match (before(1), before(2)) {
            (Some("goal"), _) => "goal number",
            (Some("section"), _) => "section number",
            (Some("proof"), _) => "version",
            _ => "number",
        };
        for other in [number + 1, number - 1] {
            add(kind, &[&other.to_string()]);
        }
    } else if token == "(" || token == ")" {
        add("bracket", &[if token == "(" { ")" } else { "(" }]);
    } else {
        // Every third word, another third at the next token.
        for word in WORDS.iter().skip(at % 3).step_by(3).filter(|word| *word != token) {
            add("name", &[word]);
        }
        match token.as_str() {
            "weights" => add("option", &["functions"]),
            "functions" => add("option", &["weights"]),
            _ => {}
        }
    }
    changes
}

fn changed(tokens: &[String], change: &Change) -> String {
    let mut changed: Vec<&str> = tokens.iter().map(String::as_str).collect();
    changed.splice(change.at..=change.at, change.instead.iter().map(String::as_str));
    changed.join(" ")
}

/// All places of a text with at most `limit` of them, or about `limit` at an even stride, both ends included.
fn places(count: usize, limit: usize) -> Vec<usize> {
    if count <= limit {
        return (0..count).collect();
    }
    let mut places: Vec<usize> = (0..limit).map(|n| n * (count - 1) / (limit - 1)).collect();
    places.dedup();
    places
}

/// Which tokens of a proof are changed: all, if statement and proof have at most 600 tokens; of longer ones some at an even
/// stride, the fewer the longer they are; and the least of those where a check takes long, or would with fewer unknowns.
fn proof_places(files: &Files, count: usize) -> Vec<usize> {
    const SLOW: [&str; 21] = [
        "X.maxima.printed",
        "X.maxima.spans.degrees",
        "X.maxima.bound.degrees",
        "X.maxima.uniform.degrees",
        "X.nested.amended",
        "Conj3.1.weak.continuous.printed",
        "T3.5.2.printed",
        "T3.5.3.amended",
        "abstract.approx.printed",
        "P4.1.3.printed",
        "P4.1.4.printed",
        "T4.1.printed",
        "T4.1.range.amended",
        "P4.2.tangent.amended",
        "abstract.classical.amended",
        "C6.classical.amended",
        "Ill5.8.remarkable.amended",
        "Ill5.8.symmetry.amended",
        "proof.T3.5.3.iff.amended",
        "proof.P4.1.2.iff.amended",
        "proof.P4.3.bisector.amended",
    ];
    let size = count + tokens(&files.statement).len();
    match (SLOW.contains(&files.name.as_str()), size) {
        (true, _) => places(count, 4),
        (false, 0..=600) => places(count, count),
        (false, _) => places(count, (100_000 / size).clamp(12, 100)),
    }
}

/// Of what is derived the degrees up to 2: the checker derives it again for every change.
fn in_few_degrees(own: &Recorded, files: &Files) -> Files {
    let (name, statement, proof) = (files.name.clone(), files.statement.clone(), files.proof.clone());
    let Shown::Derived(_) = own.statement.shown else { return Files { name, statement, proof } };
    let Statement { claim, form, degrees, .. } = &own.statement;
    let claim = claims().into_iter().find(|other| other.id() == *claim).expect("a claim of the paper");
    let least = degrees[0].max(2);
    let few: Vec<_> = degrees.iter().copied().filter(|k| *k <= least).collect();
    let sentence = claim.sentence(*form).expect("it is a sentence");
    let certificate = Certificate::of(derived(claim, *form, sentence, &few).unwrap()).unwrap();
    Files { name, statement: certificate.statement_text(), proof: certificate.proof_text() }
}

#[test]
fn a_changed_proof_proves_nothing_else() {
    type Tally = BTreeMap<&'static str, (usize, usize)>;
    let one = |(own, files): (&Recorded, &Files)| -> Tally {
        let files = &in_few_degrees(own, files);
        let (honest, tokens) = (honest(files), tokens(&files.proof));
        let changes: Vec<_> =
            proof_places(files, tokens.len()).into_iter().flat_map(|at| changes(&tokens, at)).collect();
        let outcomes: Vec<_> = changes
            .par_chunks(100)
            .flat_map_iter(|some| {
                let mutants: Vec<_> = some.iter().map(|change| changed(&tokens, change)).collect();
                let each = check_each(WORK, &files.statement, mutants.iter().map(String::as_str)).unwrap();
                let told = some.iter().zip(each).zip(&mutants).map(|((change, checked), mutant)| {
                    let accepted = checked.is_ok();
                    assert!(
                        checked.is_ok_and(|checked| checked == honest) == accepted,
                        "{}: {mutant}",
                        files.name
                    );
                    (change.kind, accepted)
                });
                told.collect::<Vec<_>>()
            })
            .collect();
        let mut tally = Tally::new();
        for (kind, accepted) in outcomes {
            let (tried, passed) = tally.entry(kind).or_default();
            *tried += 1;
            *passed += usize::from(accepted);
        }
        tally
    };
    let mut tally = Tally::new();
    for of_one in RECORDED.par_iter().zip(&*FILES).map(one).collect::<Vec<_>>() {
        for (kind, (tried, accepted)) in of_one {
            let sum = tally.entry(kind).or_default();
            *sum = (sum.0 + tried, sum.1 + accepted);
        }
    }
    for kind in ["deleted", "doubled", "bracket", "goal number", "section number", "version"] {
        let (tried, accepted) = tally[kind];
        assert!(tried > 100 && accepted == 0, "{kind}: {accepted} of {tried} accepted");
    }
    // Two unknowns or windows that are alike may do the same.
    let (tried, accepted) = tally["name"];
    assert!(tried > 100 && accepted * 1_000 < tried, "name: {accepted} of {tried} accepted");
    // Another degree of unknowns may do as well.
    for kind in ["number", "option"] {
        let (tried, accepted) = tally[kind];
        assert!(tried > 100 && accepted < tried, "{kind}: {accepted} of {tried} accepted");
    }
}

/// What a token of a statement could be mistaken for.
fn statement_changes(tokens: &[String], at: usize) -> Vec<Change> {
    const WORDS: [&str; 28] = [
        "k", "i", "s", "u", "r", "A", "any", "some", "in", "from", "to", "G", "DG", "w", "v", "Dw", "+", "-",
        "*", "/", "=", ">", ">=", "<", "printed", "amended", "proved", "refuted",
    ];
    let token = &tokens[at];
    let mut changes = Vec::new();
    let mut add = |kind, instead: &[&str]| {
        changes.push(Change { kind, at, instead: instead.iter().map(ToString::to_string).collect() });
    };
    add("deleted", &[]);
    add("doubled", &[token, token]);
    if let Ok(number) = token.parse::<i64>() {
        [number + 1, number - 1, -number - 7].iter().for_each(|other| add("number", &[&other.to_string()]));
    } else if let Some(text) = token.strip_prefix('"') {
        add("text", &[&format!("\"Not {text}")]);
    } else if token == "(" || token == ")" {
        add("bracket", &[if token == "(" { ")" } else { "(" }]);
    } else {
        for word in WORDS.iter().skip(at % 4).step_by(4).filter(|word| *word != token) {
            add("name", &[word]);
        }
    }
    changes
}

/// Which tokens of a statement are changed: all, if it has at most 200, else at an even stride, fewer the longer it is: each
/// change is read in a time that grows with the length.
fn statement_places(count: usize) -> Vec<usize> {
    if count <= 200 { places(count, count) } else { places(count, (100_000 / count).clamp(12, 200)) }
}

/// `verify` knows a statement by reading it.
#[test]
fn a_changed_statement_is_no_statement_of_the_program() {
    let read: HashSet<String> = RECORDED.iter().map(|own| own.statement.to_sexp().to_string()).collect();
    assert_eq!(read.len(), FILES.len());
    let counts = FILES.par_iter().map(|files| {
        let tokens = tokens(&files.statement);
        let (mut tried, mut statements) = (0, 0);
        for change in statement_places(tokens.len()).iter().flat_map(|at| statement_changes(&tokens, *at)) {
            let mutant = changed(&tokens, &change);
            tried += 1;
            let Ok(parsed) = Sexp::parse_all(&mutant) else { continue };
            statements += 1;
            let parsed: Vec<_> = parsed.iter().map(ToString::to_string).collect();
            assert!(!read.contains(&parsed.concat()), "{}: {mutant}", files.name);
        }
        (tried, statements)
    });
    let (tried, statements) = counts.reduce(|| (0, 0), |a, b| (a.0 + b.0, a.1 + b.1));
    assert!(statements > 10_000 && tried > statements, "{tried} tried, {statements} statements");
}

/// The goals of a statement with one token changed are false, or mean nothing, or are true as well: what the checker accepts
/// is nothing that the prover, which evaluates it in another way, knows to be false.
#[test]
fn checker_and_prover_agree_on_changed_statements() {
    let text = |own: &Recorded| {
        own.statement.sections().unwrap_or_default().iter().map(ToString::to_string).collect::<String>()
    };
    let quick = |(own, files): &(&Recorded, &Files)| {
        own.statement.sections().is_some()
            && files.proof.len() < 16_000
            && text(own).len() < 10_000
            && own.statement.degrees.iter().all(|k| *k <= 5)
    };
    let chosen: Vec<_> = RECORDED.iter().zip(&*FILES).filter(quick).collect();
    let counts = chosen.par_iter().map(|(own, files)| {
        let tokens = tokens(&text(own));
        let (mut accepted, mut rejected) = (0, 0);
        for change in places(tokens.len(), 60).iter().flat_map(|at| statement_changes(&tokens, *at)) {
            let mutant = changed(&tokens, &change);
            let Ok(sections) = Sexp::parse_all(&mutant) else { continue };
            let statement = own.statement.clone().with_sections(sections);
            if check(&statement.to_sexp().to_string(), &files.proof).is_err() {
                rejected += 1;
                continue;
            }
            accepted += 1;
            match prove(&statement) {
                // The prover asks for knots that a limit at the first knot of a span does not depend on; the checker knows.
                Ok(_)
                | Err(ProofError::Goal {
                    reason: GoalError::Evaluation(EvaluationError::OutsideWindow { .. }),
                    ..
                }) => {}
                Err(error) => {
                    panic!("{}: the checker accepts what the prover does not: {error}: {mutant}", own.name)
                }
            }
        }
        (accepted, rejected)
    });
    let (accepted, rejected) = counts.reduce(|| (0, 0), |a, b| (a.0 + b.0, a.1 + b.1));
    assert!(
        chosen.len() > 20 && accepted > 400 && rejected > 5 * accepted,
        "{}: {accepted} accepted, {rejected} rejected",
        chosen.len()
    );
}

// False statements.

const SPAN: &str = "(window A (- 0 k) (each s (- 0 k) -1 any) some (each s 1 k any))";
const FIRST: &str = "(window A 0 (each s 1 k 0) some (each s 1 k any))";
const LAST: &str = "(window A (- 0 k) (each s 1 k any) some (each s 1 k 0))";
/// A simple knot t_0 with free neighbours.
const SIMPLE: &str = "(window A (- -1 k) (each s 1 k any) some some (each s 1 k any))";

/// The weights of the paper.
fn of_paper() -> Weighted {
    Weighted::Family(Arc::clone(&paper().about.family))
}

/// A statement about every knot vector with one section that has these declarations and goals.
fn about(degrees: &[usize], declarations: &str, goals: &str) -> Statement {
    let sections = Sexp::parse_all(&format!("(section {declarations} (goals {goals}))")).unwrap();
    let weighted = of_paper();
    Statement {
        claim: "test".into(),
        family: weighted.to_sexp().unwrap(),
        weighted,
        form: Form::Printed,
        refuted: false,
        scope: Scope::Knots,
        degrees: degrees.to_vec(),
        sentence: Sexp::parse_all(
            "(sentence (for (degree 0) (knots)) (if) (then (chain (int 0) (= (int 0)))))",
        )
        .unwrap(),
        shown: Shown::Argued { because: "The goal says so.".into(), sections },
    }
}

/// Degrees, declarations, a goal that is true, and what makes it false: a part with another in its place.
type NearMiss = (&'static [usize], &'static str, &'static str, [&'static str; 2]);

const NEAR_MISSES: &[NearMiss] = &[
    // Sums.
    (&[0, 1, 2, 3], SPAN, "(= (+ (each i (- 0 k) 0 (G i k (in A 0)))) 1)", [" 1)", " 2)"]),
    (&[1, 2, 3], SPAN, "(= (+ (each i (- 0 k) 0 (G i k (from A 0)))) 1)", ["(- 0 k) 0", "(- 1 k) 0"]),
    (&[1, 2, 3], SPAN, "(= (+ (each i (- 0 k) 0 (DG i k (in A 0)))) 0)", ["))) 0)", "))) 1)"]),
    (&[1], "(window A 0 any some any)", "(> (+ (G 0 1 (in A 1)) (G 1 1 (in A 1))) 0)", ["(> ", "(< "]),
    // Positivity.
    (&[1, 2, 3], SPAN, "(>= (+ (each i (- 0 k) 0 (G i k (in A 0)))) 1)", ["(>= ", "(> "]),
    (&[1, 2], SPAN, "(>= (G 0 k (from A 0)) 0)", [">=", ">"]),
    (&[1, 2], SPAN, "(> (G 0 k (in A 0)) 0)", ["G 0", "G 1"]),
    (&[1, 2], SPAN, "(> (G (- 0 k) k (in A 0)) 0)", ["(- 0 k)", "(- -1 k)"]),
    (&[2], SPAN, "(> (G -2 k (from A 0)) 0)", ["-2", "0"]),
    // Weights.
    (&[1], "(window A 0 some)", "(> (w 0 1 (in A 0)) 0)", [")) 0)", ")) 1/2)"]),
    (&[1], "(window A 0 some)", "(> 1 (w 0 1 (in A 0)))", ["> 1", "> 1/2"]),
    (&[1], "(window A 0 some)", "(= (w 0 1 (from A 0)) 0)", ["from", "to"]),
    (&[1], "(window A 0 some)", "(= (+ (w 0 1 (in A 0)) (v 0 1 (in A 0))) 1)", ["(v 0", "(w 0"]),
    (&[1], "(window A 0 some)", "(> (Dw 0 1 (in A 0)) 0)", ["> ", "< "]),
    (
        &[1],
        "(window A 0 some)",
        "(= (at ((u (/ 1 u))) (w 0 1 (in A 0))) (at ((r (/ 1 r))) (v 0 1 (in A 0))))",
        ["(/ 1 r)", "r"],
    ),
    (
        &[1],
        "(window A 0 some)",
        "(= (at ((u (/ 1 u))) (w 0 1 (in A 0))) (at ((r (/ 1 r))) (v 0 1 (in A 0))))",
        ["(v 0", "(w 0"],
    ),
    (
        &[1],
        "(positive c) (window A 0 some) (window B 0 (* c (A 0)))",
        "(= (w 0 1 (in B 0)) (w 0 1 (in A 0)))",
        ["w 0 1 (in A", "Dw 0 1 (in A"],
    ),
    (
        &[1],
        "(positive c) (window A 0 some) (window B 0 (* c (A 0)))",
        "(= (* c (Dw 0 1 (in B 0))) (Dw 0 1 (in A 0)))",
        ["* c", "* 1"],
    ),
    (
        &[1],
        "(positive h s) (let alpha (- s)) (let r (/ alpha (- alpha 1))) (window A 0 h)",
        "(= (w 0 1 (in A 0)) (/ (* alpha (x (in A 0))) (+ (x (in A 0)) (* (- alpha 1) (t A 1)))))",
        ["- alpha 1) (t", "+ alpha 1) (t"],
    ),
    (
        &[1],
        "(positive s) (window A 0 some)",
        "(> (at ((u (+ u s))) (w 0 1 (in A 0))) (w 0 1 (in A 0)))",
        ["(+ u s)", "(/ u (+ 1 s))"],
    ),
    // Support, ends, the lemmas on them.
    (&[1, 2], SPAN, "(= (G (- (- 0 k) 1) k (in A 0)) 0)", ["(- (- 0 k) 1)", "(- 0 k)"]),
    (&[1, 2, 3], FIRST, "(= (G 0 k (from A k)) 1)", ["G 0", "G 1"]),
    (&[1, 2, 3], FIRST, "(= (G 0 k (from A k)) 1)", ["from", "in"]),
    (&[2, 3], FIRST, "(= (G 1 (- k 1) (from A k)) (G 0 k (from A k)))", ["G 1 (", "G 2 ("]),
    (&[1, 2, 3], LAST, "(= (G 0 k (to A 0)) 1)", ["to A", "from A"]),
    // Bernstein.
    (
        &[2, 3],
        "(positive h) (window A 0 (each s 1 k 0) h (each s 1 k 0))",
        "(= (G 1 k (in A k)) (* (integer k) (w k 1 (in A k)) (^ (v k 1 (in A k)) (- k 1))))",
        ["integer k", "integer 1"],
    ),
    (
        &[2, 3],
        "(positive h) (window A 0 (each s 1 k 0) h (each s 1 k 0))",
        "(= (G 0 k (in A k)) (^ (v k 1 (in A k)) k))",
        ["(v k", "(w k"],
    ),
    // Continuity at a knot with one copy more.
    (
        &[1, 2, 3],
        "(each q k k) (window A (- -1 k) (each s 1 k any) some (each s 1 (- q 1) 0) some (each s 1 k any))",
        "(= (G -1 k (to A -1)) (G -1 k (from A (- q 1))))",
        ["(each q k k)", "(each q (+ k 1) (+ k 1))"],
    ),
    (
        &[2, 3],
        "(each q 1 1) (window A (- -1 k) (each s 1 k any) some (each s 1 (- q 1) 0) some (each s 1 k any))",
        "(= (at ((r 1)) (DG -1 k (to A -1))) (at ((r 1)) (DG -1 k (from A (- q 1)))))",
        ["(each q 1 1)", "(each q k k)"],
    ),
    // Derivatives.
    (
        &[1, 2, 3],
        FIRST,
        "(= (DG 1 k (from A k)) (/ (* (integer k) r) (A k)))",
        ["integer k", "integer (+ k 1)"],
    ),
    (&[1, 2, 3], FIRST, "(= (DG 1 k (from A k)) (/ (* (integer k) r) (A k)))", [" r)", " (/ 1 r))"]),
    (
        &[1, 2, 3],
        FIRST,
        "(= (DG 0 k (from A k)) (- (/ (* (integer k) r) (A k))))",
        ["(- (/ (* (integer k) r) (A k)))", "(/ (* (integer k) r) (A k))"],
    ),
    (&[1, 2, 3], LAST, "(= (DG 0 k (to A 0)) (/ (integer k) (* r (A 0))))", ["(* r (A 0))", "(A 0)"]),
    (
        &[2, 3],
        SIMPLE,
        "(= (- (DG -1 k (from A 0)) (DG -1 k (to A -1))) (* (/ (- r 1) (+ (* r (A -1)) (A 0))) (each d 3 k (w -1 d (from A 0)))))",
        ["(- r 1)", "(- 1 r)"],
    ),
    (
        &[2, 3],
        SIMPLE,
        "(= (- (DG -1 k (from A 0)) (DG -1 k (to A -1))) (* (/ (- r 1) (+ (* r (A -1)) (A 0))) (each d 3 k (w -1 d (from A 0)))))",
        ["(* r (A -1)) (A 0)", "(A -1) (* r (A 0))"],
    ),
    (
        &[2],
        SIMPLE,
        "(= (* (DG -2 2 (to A -1)) (DG -1 2 (from A 0))) (* (DG -1 2 (to A -1)) (DG -2 2 (from A 0))))",
        ["DG -2 2 (from", "DG -3 2 (from"],
    ),
    (
        &[3],
        SIMPLE,
        "(= (G -2 k (to A -1)) (G -2 k (from A 0)))",
        ["(G -2 k (to A -1)) (G", "(DG -2 k (to A -1)) (DG"],
    ),
    (&[1, 2], SPAN, "(defined (DG 0 k (in A 0)))", ["(DG 0 k (in A 0))", "(/ (G 0 k (in A 0)) (- 1 u))"]),
    // Symmetry.
    (
        &[1, 2],
        "(window A (- 0 k) (each s (- 0 k) -1 any) some (each s 1 k any)) (window B (- 0 k) (each s (- 0 k) k (A (- 0 s))))",
        "(= (at ((u (/ 1 u))) (G 0 k (in A 0))) (at ((r (/ 1 r))) (G (- 0 k) k (in B 0))))",
        ["(r (/ 1 r))", "(r r)"],
    ),
    (
        &[1, 2],
        "(window A (- 0 k) (each s (- 0 k) -1 any) some (each s 1 k any)) (window B (- 0 k) (each s (- 0 k) k (A (- 0 s))))",
        "(= (at ((u (/ 1 u))) (G 0 k (in A 0))) (at ((r (/ 1 r))) (G (- 0 k) k (in B 0))))",
        ["(G (- 0 k) k (in B", "(G (- 0 k) k (in A"],
    ),
    // Curves.
    (
        &[1, 2],
        "(real (each i (- 0 k) 0 (d i))) (window A (- 0 k) (each s (- 0 k) -1 any) some (each s 1 k any))",
        "(= (de-boor 0 k k (in A 0)) (+ (each i (- 0 k) 0 (* (d i) (G i k (in A 0))))))",
        ["(* (d i)", "(* (d (- (- 0 k) i))"],
    ),
    (
        &[2],
        "(real (each i (- 0 k) 0 (d i))) (window A (- 0 k) (each s (- 0 k) -1 any) some (each s 1 k any))",
        "(= (+ (each i -1 0 (* (de-boor i 1 2 (in A 0)) (G i 1 (in A 0))))) (de-boor 0 2 2 (in A 0)))",
        ["(de-boor i 1 2", "(de-boor i 0 2"],
    ),
    // Orders, functionals, poles.
    (&[1, 2, 3], SPAN, "(order 0 k (in A 0) k)", ["0) k)", "0) (+ k 1))"]),
    (&[1, 2, 3], SPAN, "(order 0 k (in A 0) k)", ["0) k)", "0) (- k 1))"]),
    (
        &[2],
        "(let r 1/2) (knots A -1 0 1 2 3)",
        "(outside (in A 0) (x (in A 0)) ((G -1 1 (in A 0)) 1))",
        ["(x (in A 0))", "(integer 3)"],
    ),
    (
        &[2],
        "(let r 1/2) (knots A -1 0 1 2 3)",
        "(outside (in A 0) (x (in A 0)) ((G -2 2 (in A 0)) (G -1 2 (in A 0)) (G 0 2 (in A 0))))",
        ["(x (in A 0))", "(- (G -2 2 (in A 0)) (* 3 (G 0 2 (in A 0))))"],
    ),
    (&[1], "(let r 1) (knots A 0 0 1 2)", "(pole (in A 1) ((/ 1 (+ 2 u))) -2)", [" -2)", " -1)"]),
    (
        &[2],
        "(let r 1/2) (knots A -1 0 1 3 4)",
        "(pole (in A 0) ((G -2 2 (in A 0)) (G -1 2 (in A 0)) (G 0 2 (in A 0))) -5/3)",
        ["-5/3", "-3"],
    ),
    // Minors: total positivity stops at degree 2.
    (
        &[1],
        "(positive s) (window A -1 any some any)",
        "(> (det ((G -1 1 (in A 0)) (G 0 1 (in A 0))) ((at ((u (+ u s))) (G -1 1 (in A 0))) (at ((u (+ u s))) (G 0 1 (in A 0))))) 0)",
        ["(> (det", "(< (det"],
    ),
    // Distances: a bound is reached, or too great.
    (&[1], "(let r 1/3) (knots A 0 0 1)", "(>= (+ 1 (^ (- (x (in A 0)) 1/2) 2)) 1)", [">= (", "> ("]),
    (&[1], "(positive a)", "(>= (+ (^ a 2) 1) (* 2 a))", ["(* 2 a)", "(* 3 a)"]),
    (&[1], "(positive a)", "(>= (+ (^ a 2) 1) (* 2 a))", [">=", ">"]),
    (&[1], "(nonnegative a)", "(>= (* a (+ 1 a)) 0)", [">= (", "> ("]),
    (&[1], "(positive a)", "(> (+ (^ a 2) (- a) 1) 0)", [" 1) 0)", " 1/5) 0)"]),
    // Knots.
    (&[3], "(window A 0 any some any)", "(> (t A 2) (t A 1))", ["(t A 2) (t A 1)", "(t A 1) (t A 0)"]),
    (&[2], "(window A 0 any any)", "(>= (t A 2) (t A 0))", [">=", ">"]),
];

/// The simple rules, for one goal.
const RULES: [&str; 12] = [
    "(by)",
    "(by (weights 1))",
    "(by (weights 2))",
    "(by (functions 0))",
    "(by (functions 1))",
    "(by (functions 9))",
    "(by (weights 1) (functions 1))",
    "(split u 1 (by) (by))",
    "(split u 1/3 (split r 1 (by) (by)) (by))",
    "(orders)",
    "(functional (1 1) (-1 2))",
    "(evaluate)",
];

/// A proof that has this rule for every goal of the statement.
fn with_rule(statement: &Statement, rule: &str) -> String {
    let mut proof = String::from("(proof 1");
    for (section, number) in statement.expand().unwrap().iter().zip(1..) {
        let goals: String = (1..=section.goals.len()).map(|goal| format!(" (goal {goal} {rule})")).collect();
        proof += &format!(" (section {number}{goals})");
    }
    proof + ")"
}

#[test]
fn what_is_false_by_a_little_has_no_proof() {
    let one = |(degrees, declarations, goal, [part, instead]): &NearMiss| {
        let text = if goal.contains(part) { goal } else { declarations };
        assert_eq!(text.matches(part).count(), 1, "{goal}: `{part}`");
        let truth = about(degrees, declarations, goal);
        let proof = prove(&truth).unwrap_or_else(|error| panic!("{goal}: {error}"));
        let certificate = Certificate { statement: truth, proof };
        let checked = certificate.check().unwrap_or_else(|error| panic!("{goal}: {error}"));
        assert_eq!(checked.degrees, *degrees, "{goal}");

        let declarations =
            if text == declarations { declarations.replace(part, instead) } else { declarations.to_string() };
        let miss = goal.replace(part, instead);
        let lie = about(degrees, &declarations, &miss);
        let error = prove(&lie).expect_err(&miss);
        assert!(matches!(error, ProofError::Goal { .. }), "{miss}: {error}");
        let text = lie.to_sexp().to_string();
        for proof in RULES.iter().map(|rule| with_rule(&lie, rule)).chain([certificate.proof_text()]) {
            assert!(check(&text, &proof).is_err(), "{miss}: accepted with {proof}");
        }
    };
    NEAR_MISSES.par_iter().for_each(one);
}

/// Recorded statements, each made false at one place.
const RECORDED_MISSES: &[(&str, [&str; 2])] = &[
    ("Rem3.1.printed", ["(- r 1)", "(+ r 1)"]),
    ("abstract.regularity.printed", ["(- 1 r)", "(- r 1)"]),
    ("Ill5.8.double.printed", ["(> ", "(< "]),
    ("X.G1.degrees", ["(DG -1 k (from A 0)))", "(DG 0 k (from A 0)))"]),
    ("X.totalpositivity.degrees", ["(> (det", "(< (det"]),
    (
        "X.nurbs.printed",
        [
            "(pole (in A 0) ((G -1 1 (in A 0)) (G 0 1 (in A 0))) -2)",
            "(pole (in A 0) ((G -1 1 (in A 0)) (G 0 1 (in A 0))) -1)",
        ],
    ),
    ("Ill5.8.double.amended", ["1/16", "1/1000"]),
];

#[test]
fn a_recorded_statement_made_false_has_no_proof() {
    RECORDED_MISSES.par_iter().for_each(|(name, [part, instead])| {
        let at = RECORDED.iter().position(|own| own.name == *name).expect(name);
        let (_, sections) = RECORDED[at].statement.argued().expect(name);
        let sections: String = sections.iter().map(ToString::to_string).collect();
        assert!(sections.contains(part), "{name}: `{part}`");
        let sections = Sexp::parse_all(&sections.replacen(part, instead, 1)).unwrap();
        let lie = RECORDED[at].statement.clone().with_sections(sections);
        let error = prove(&lie).expect_err(name);
        assert!(matches!(error, ProofError::Goal { .. }), "{name}: {error}");
        let text = lie.to_sexp().to_string();
        assert!(check(&text, &FILES[at].proof).is_err(), "{name}");
    });
}

/// The minor that refutes total positivity in degree 3, on knots with a gap of any length: at length 1 it is negative.
#[test]
fn positive_minors_stop_at_degree_3() {
    let row = |point: &str| {
        format!("({})", ["1", "2", "3"].map(|i| point.replace("G", &format!("(G {i} 3"))).join(" "))
    };
    let rows =
        ["(at ((u 1023)) G (in A 3)))", "G (from A 4))", "(at ((u 1/1023)) G (in A 4)))"].map(row).join(" ");
    let goal = |compare: &str| format!("({compare} (det {rows}) 0)");
    let window = |gap: &str| format!("(positive h) (let r 1/2) (window A 0 0 0 0 1 {gap} 1 0)");
    let truth = about(&[3], &window("1"), &goal("<"));
    assert!(Certificate { proof: prove(&truth).unwrap(), statement: truth }.check().is_ok());
    for lie in [about(&[3], &window("1"), &goal(">")), about(&[3], &window("h"), &goal(">="))] {
        assert!(matches!(prove(&lie), Err(ProofError::Goal { reason: GoalError::False, .. })));
        let text = lie.to_sexp().to_string();
        assert!(RULES.iter().all(|rule| check(&text, &with_rule(&lie, rule)).is_err()));
    }
}

// The evaluator against the numeric path.

/// A degree, knots for it, an index and control points with one coordinate.
#[derive(Debug, Clone)]
struct Numbers {
    basis: Basis,
    points: Vec<i64>,
    /// Which of the gaps are parameters of the section.
    symbolic: Vec<bool>,
    u: BigRational,
}

fn numbers() -> impl Strategy<Value = Numbers> {
    let gaps = |k: usize| {
        prop::collection::vec(prop_oneof![2 => Just(0_i64), 3 => 1_i64..=3], 2 * k + 2..=2 * k + 4)
    };
    let positive = || (1_i64..=7, 1_i64..=7).prop_map(|(p, q)| rational(p, q));
    (0_usize..=4)
        .prop_flat_map(move |k| (Just(k), gaps(k), positive(), positive(), -3_i64..=3))
        .prop_flat_map(|(k, mut gaps, ratio, u, start)| {
            if gaps.iter().all(|gap| *gap == 0) {
                gaps[k] = 1;
            }
            let mut knots = vec![rational(start, 1)];
            gaps.iter().for_each(|gap| knots.push(knots.last().unwrap() + rational(*gap, 1)));
            let knots = KnotVector::new(knots).unwrap();
            let basis = Basis::new(knots, k, Index::from_ratio(ratio).unwrap()).unwrap();
            let points = prop::collection::vec(-5_i64..=5, basis.n() + 1);
            // Four parameters at most: more would take long.
            let symbolic =
                prop::sample::subsequence((0..gaps.len()).collect::<Vec<_>>(), 0..=4.min(gaps.len()))
                    .prop_map(move |chosen| (0..gaps.len()).map(|gap| chosen.contains(&gap)).collect());
            (Just(basis), points, symbolic, Just(u)).prop_map(|(basis, points, symbolic, u)| Numbers {
                basis,
                points,
                symbolic,
                u,
            })
        })
}

impl Numbers {
    fn gap(&self, i: usize) -> BigRational {
        let knots = self.basis.knots();
        knots.t(i + 1) - knots.t(i)
    }

    /// The section that has these terms on the left sides of its goals: u, r, the control points and some of the gaps are
    /// parameters.
    fn section(&self, terms: &[String]) -> Section {
        let gap = |i: usize| match (self.symbolic[i], self.gap(i)) {
            (true, gap) if gap == integer(0) => "any".to_owned(),
            (true, _) => "some".to_owned(),
            (false, gap) => gap.to_string(),
        };
        let gaps: Vec<_> = (0..self.basis.knots().m()).map(gap).collect();
        let (n, window) = (self.basis.n(), format!("(window A 0 {})", gaps.join(" ")));
        let goals: String = terms.iter().map(|term| format!("(= {term} 0)")).collect();
        let mut sections =
            about(&[self.basis.degree()], &format!("(real (each i 0 {n} (d i))) {window}"), &goals)
                .expand()
                .unwrap();
        assert_eq!(sections.len(), 1);
        sections.remove(0)
    }

    /// The value of each term at these numbers.
    fn values(&self, section: &Section) -> Vec<BigRational> {
        let weighted = of_paper();
        let evaluator = Evaluator::new(section, &weighted, Unfolding::default()).unwrap();
        let mut at = HashMap::new();
        let mut set = |name: String, value| at.insert(evaluator.variable_of(&name).unwrap(), value);
        set("u".into(), self.u.clone());
        set("r".into(), self.basis.index().ratio().clone());
        for (i, point) in self.points.iter().enumerate() {
            set(format!("(d {i})"), rational(*point, 1));
        }
        for i in (0..self.symbolic.len()).filter(|i| self.symbolic[*i]) {
            set(format!("(A {i})"), self.gap(i));
        }
        let value = |goal: &Formula| {
            let Formula::Equal(term, _) = goal else { panic!("an equation") };
            let value = evaluator.term(term).unwrap();
            value.evaluate(&self.u, |variable| at[&variable].clone()).expect("no denominator is 0 there")
        };
        section.goals.iter().map(value).collect()
    }
}

/// A term, and what it is worth by the numeric path.
fn worth(numbers: &Numbers) -> Vec<(String, BigRational)> {
    let Numbers { basis, u, .. } = numbers;
    let (knots, k) = (basis.knots(), basis.degree());
    let mut all = Vec::new();
    let points = numbers.points.iter().map(|point| vec![rational(*point, 1)]).collect();
    let curve = Curve::new(basis.clone(), points).unwrap();
    for span in knots.spans() {
        let (s, (start, end)) = (span.index(), knots.ends(span).expect("a span of these knots"));
        let inside = (start + u * end) / (integer(1) + u);
        for (place, x, side) in
            [("in", &inside, Side::Right), ("from", start, Side::Right), ("to", end, Side::Left)]
        {
            let place = format!("({place} A {s})");
            all.push((format!("(x {place})"), x - knots.first()));
            for d in 0..=k {
                let basis = Basis::new(knots.clone(), d, basis.index().clone()).unwrap();
                for (i, jet) in basis.jets(x, side, 1).iter().enumerate() {
                    all.push((format!("(G {i} {d} {place})"), jet.coefficients()[0].clone()));
                    all.push((format!("(DG {i} {d} {place})"), jet.coefficients()[1].clone()));
                }
                for i in (s + 1).saturating_sub(d)..=s.min(knots.m() - d) {
                    let variable = Jet::variable(x.clone(), 1);
                    let ratio = Jet::constant(basis.index().ratio().clone(), 1);
                    let (w, v) = weight(&ratio, &variable, knots.t(i), knots.t(i + d));
                    all.push((format!("(w {i} {d} {place})"), w.coefficients()[0].clone()));
                    all.push((format!("(v {i} {d} {place})"), v.coefficients()[0].clone()));
                    all.push((format!("(Dw {i} {d} {place})"), w.coefficients()[1].clone()));
                }
            }
            for (q, level) in curve.de_boor(x, side).unwrap_or_default().iter().enumerate() {
                for (i, point) in level.iter() {
                    all.push((format!("(de-boor {i} {q} {k} {place})"), point[0].clone()));
                }
            }
        }
    }
    all
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    #[test]
    fn terms_have_the_values_of_the_numeric_path(numbers in numbers()) {
        let worth = worth(&numbers);
        let terms: Vec<_> = worth.iter().map(|(term, _)| term.clone()).collect();
        for ((term, expected), value) in worth.iter().zip(numbers.values(&numbers.section(&terms))) {
            prop_assert_eq!(&value, expected, "{}", term);
        }
        // And with numbers put in by the language itself.
        let (u, r) = (&numbers.u, numbers.basis.index().ratio());
        let at: Vec<_> = terms.iter().step_by(7).map(|term| format!("(at ((u {u}) (r {r})) {term})")).collect();
        for ((term, expected), value) in worth.iter().step_by(7).zip(numbers.values(&numbers.section(&at))) {
            prop_assert_eq!(&value, expected, "at: {}", term);
        }
    }
}

/// Every kind of term without a place, by hand; a is 5, b 2/3.
#[test]
fn arithmetic_terms_have_their_values() {
    for (term, value) in [
        ("(+ a b 1)", rational(20, 3)),
        ("(+ (each i 1 4 (integer i)))", integer(10)),
        ("(+ (each i 1 0 a) 0)", integer(0)),
        ("(- a b)", rational(13, 3)),
        ("(- b)", rational(-2, 3)),
        ("(* a b (each i 2 3 (integer (* i i))))", integer(120)),
        ("(/ a b)", rational(15, 2)),
        ("(^ b 3)", rational(8, 27)),
        ("(^ b 0)", integer(1)),
        ("(integer (binomial 6 2))", integer(15)),
        ("(integer (binomial 2 6))", integer(0)),
        ("(integer (- 2 6))", rational(-4, 1)),
        ("(det (a b) (1 2))", rational(28, 3)),
        ("(det (1 2 3) (0 a 1) (b 0 0))", rational(2, 3) * rational(-13, 1)),
        ("(at ((u b) (r u)) (- u r))", rational(2, 3) - integer(7)),
        ("(at ((u 2)) (at ((u (+ u 1))) (^ u 2)))", integer(9)),
        ("c", integer(25)),
        ("(t A 2)", rational(17, 3)),
    ] {
        let statement =
            about(&[1], "(positive a b) (let c (* a a)) (window A 0 a b)", &format!("(= {term} 0)"));
        let sections = statement.expand().unwrap();
        let weighted = of_paper();
        let evaluator = Evaluator::new(&sections[0], &weighted, Unfolding::default()).unwrap();
        let Formula::Equal(left, _) = &sections[0].goals[0] else { panic!("an equation") };
        let at = |name: &str| evaluator.variable_of(name).unwrap();
        let (a, b, u) = (at("a"), at("b"), at("u"));
        let numbers =
            HashMap::from([(a, integer(5)), (b, rational(2, 3)), (u, integer(7)), (at("r"), integer(3))]);
        let found = evaluator.term(left).unwrap_or_else(|error| panic!("{term}: {error}"));
        assert_eq!(found.evaluate(&value, |v| numbers[&v].clone()), Some(value), "{term}");
    }
}

/// What the coefficients and the signs of the parameters show, and no more.
#[test]
fn signs_are_read_from_the_coefficients() {
    use Class::{Nonnegative, Positive, Real};
    for (term, sign) in [
        ("a", Positive),
        ("b", Nonnegative),
        ("c", Real),
        ("0", Nonnegative),
        ("3", Positive),
        ("-3", Real),
        ("(+ a b)", Positive),
        ("(* a b)", Nonnegative),
        ("(+ b (* a b))", Nonnegative),
        ("(+ 1 b)", Positive),
        ("(+ a c)", Real),
        ("(^ c 2)", Real),
        ("(- a b)", Real),
        ("(/ b (+ 1 a))", Nonnegative),
        ("(/ (- a) (- (- 1) a))", Positive),
        ("(* u r)", Positive),
        ("(t A 1)", Positive),
        ("(t A 2)", Positive),
        ("(- (t A 2) (t A 1))", Nonnegative),
    ] {
        let declarations = "(real c) (nonnegative b) (positive a) (window A 0 some any)";
        let sections = about(&[1], declarations, &format!("(= {term} 0)")).expand().unwrap();
        let weighted = of_paper();
        let evaluator = Evaluator::new(&sections[0], &weighted, Unfolding::default()).unwrap();
        let Formula::Equal(left, _) = &sections[0].goals[0] else { panic!("an equation") };
        assert_eq!(evaluator.class_of(&evaluator.term(left).unwrap()), sign, "{term}");
    }
}

// Statements that make no sense.

fn error(declarations: &str, goals: &str) -> ProofError {
    prove(&about(&[2], declarations, goals)).expect_err(goals)
}

#[test]
fn a_statement_that_makes_no_sense_says_what_is_wrong_with_it() {
    let window = "(window A -1 any some any)";
    // Found while it is read.
    for (declarations, goal, expected, culprit) in [
        (window, "(= (G i k (in A 0)) 1)", StatementError::Integer("i".into()), "`i`"),
        (window, "(= (G 0 1/2 (in A 0)) 1)", StatementError::Integer("1/2".into()), "`1/2`"),
        (window, "(= (G 0 (- 1 k) (in A 0)) 1)", StatementError::Integer("(- 1 k)".into()), "`(- 1 k)`"),
        (
            "",
            "(= (integer (* 9999999999 9999999999)) 1)",
            StatementError::Integer("(* 9999999999 9999999999)".into()),
            "9999999999",
        ),
        (
            "",
            "(= (integer (binomial -1 2)) 1)",
            StatementError::Integer("(binomial -1 2)".into()),
            "binomial -1 2",
        ),
        ("", "(= (^ u -1) 1)", StatementError::Integer("-1".into()), "`-1`"),
        (window, "(= (G 0 k (near A 0)) 1)", StatementError::Form("(near A 0)".into()), "`(near A 0)`"),
        ("", "(true 0 1)", StatementError::Form("(true 0 1)".into()), "(true 0 1)"),
        ("", "(= 0 1 2)", StatementError::Form("(= 0 1 2)".into()), "`(= 0 1 2)`"),
        ("", "(= (det (1 2) (3)) 0)", StatementError::Form("(det (1 2) (3))".into()), "(det (1 2) (3))"),
        ("", "(= (+ (each i 1 0 1)) 0)", StatementError::Form("(+ (each i 1 0 1))".into()), "each i 1 0 1"),
        ("", "(= (+ (each i 0 1000000000 1)) 0)", StatementError::Range("i".into()), "`i`"),
        ("(complex a)", "(= 0 0)", StatementError::Form("(complex a)".into()), "`(complex a)`"),
        ("(knots A 0 1 0)", "(= 0 0)", StatementError::Form("(knots A 0 1 0)".into()), "(knots A 0 1 0)"),
        ("(knots A 0 0 k)", "(= 0 0)", StatementError::Form("k".into()), "`k`"),
        ("(each i 1 2 3)", "(= 0 0)", StatementError::Form("(each i 1 2 3)".into()), "(each i 1 2 3)"),
        ("", "(each i 1 0 (= 0 0))", StatementError::NoGoal(2), "degree 2"),
        ("(each i 3 k)", "(= 0 0)", StatementError::NoGoal(2), "degree 2"),
    ] {
        let found = error(declarations, goal);
        assert_eq!(found, ProofError::Statement(expected), "{declarations} {goal}");
        assert!(found.to_string().contains(culprit), "{declarations} {goal}: {found}");
    }
    // Found while a goal is evaluated.
    let outside = |window: &str, index| EvaluationError::OutsideWindow { window: window.into(), index };
    let empty = |window: &str, span| EvaluationError::EmptySpan { window: window.into(), span };
    let unknown = |name: &str| EvaluationError::Unknown(name.into());
    for (declarations, goal, expected, culprit) in [
        (window, "(= (G 0 1 (in B 0)) 1)", unknown("B"), "`B`"),
        ("", "(= a 1)", unknown("a"), "`a`"),
        ("(real (d 0))", "(= (d 1) 1)", unknown("(d 1)"), "`(d 1)`"),
        ("(let a b)", "(= 0 0)", unknown("b"), "`b`"),
        (window, "(= (de-boor 0 1 1 (in A 0)) 1)", unknown("(d -1)"), "`(d -1)`"),
        (window, "(= (at ((y 1)) u) 1)", unknown("y"), "`y`"),
        (window, "(= (t A 3) 1)", outside("A", 3), "window A does not show the knot 3"),
        (window, "(= (G -1 3 (in A 0)) 1)", outside("A", 3), "knot 3"),
        (window, "(= (w -3 4 (in A 0)) 1)", outside("A", -3), "knot -3"),
        (window, "(= (x (in A 2)) 1)", outside("A", 3), "knot 3"),
        (window, "(= (x (in A -1)) 1)", empty("A", -1), "span -1 of window A"),
        ("(knots A 0 1 1 2)", "(= (G 0 1 (from A 0)) 1)", empty("A", 0), "span 0 of window A"),
        ("(nonnegative h) (window A 0 h)", "(> (w 0 1 (in A 0)) 0)", empty("A", 0), "span 0 of window A"),
    ] {
        let found = error(declarations, goal);
        let ProofError::Goal { section: 1, goal: 1, reason: GoalError::Evaluation(reason) } = &found else {
            panic!("{goal}: {found}");
        };
        assert_eq!(reason, &expected, "{declarations} {goal}");
        assert!(found.to_string().contains(culprit), "{declarations} {goal}: {found}");
        assert!(found.to_string().starts_with("section 1, goal 1: "), "{found}");
    }
    // Division by what could be 0.
    for (declarations, goal, culprit) in [
        ("(real a)", "(= (/ a a) 1)", "x2, where x2 = a"),
        ("(nonnegative a)", "(= (/ 1 a) 1)", "x2, where x2 = a"),
        ("", "(= (/ 1 (- u r)) 1)", "x0 - x1, where x0 = u, x1 = r"),
        ("", "(> (/ 1 0) 0)", "0"),
        ("(positive a)", "(defined (/ 1 (- a 1)))", "x2 - 1, where x2 = a"),
    ] {
        let found = error(declarations, goal);
        let reason = GoalError::Evaluation(EvaluationError::Division(culprit.into()));
        assert_eq!(found, ProofError::Goal { section: 1, goal: 1, reason }, "{goal}: {found}");
    }
    let many = error("(real (each i 1 200 (a i)))", "(= (a 1) 0)");
    let reason = GoalError::Evaluation(EvaluationError::TooMany);
    assert_eq!(many, ProofError::Goal { section: 1, goal: 1, reason });
    // The second goal of the section for the second value of e.
    let second = error("(each e 0 1)", "(= 0 0) (= (integer e) 0)");
    assert_eq!(second, ProofError::Goal { section: 2, goal: 2, reason: GoalError::False });
    assert_eq!(second.to_string(), "section 2, goal 2: it is false");
}
