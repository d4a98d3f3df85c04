//! Formal statements, their proofs and the checker, without the engine: the statements are those of the recorded
//! verdicts.

#![allow(clippy::unwrap_used, reason = "helpers of tests")]

use std::collections::{BTreeMap, BTreeSet, HashSet};
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::LazyLock;

use knotproof::certificate::{Certificate, Form, Sexp, Statement, prove, statement};
use knotproof::claims::claims;
use knotproof::report::{Baseline, Finding};
use knotproof_checker::{Checked, canonical, check};
use rayon::prelude::*;

/// A formal statement, with the name of its certificate in the recorded verdicts.
struct Recorded {
    name: String,
    statement: Statement,
}

/// Every finding that was recorded, with the claim and the form that it is about.
fn recorded_findings() -> Vec<(String, Form, Finding)> {
    let mut findings = Vec::new();
    for entry in Baseline::recorded().expect("proofs/verdicts.json can be read").claims {
        let mut add = |form, finding| findings.push((entry.id.clone(), form, finding));
        add(Form::Printed, entry.as_printed);
        entry.amended.into_iter().for_each(|finding| add(Form::Amended, finding));
        entry.by_degree.into_iter().for_each(|of| add(Form::Degree(of.degree), of.finding));
    }
    findings
}

/// What the program says in formal terms about a finding.
fn stated(claim: &str, form: Form, finding: &Finding) -> Option<Statement> {
    let all = claims();
    let claim = all.iter().find(|other| other.id == claim).expect("a claim of the register");
    statement(claim, form, finding.witness.as_ref()).expect("it is in the language")
}

static RECORDED: LazyLock<Vec<Recorded>> = LazyLock::new(|| {
    let certified = |(claim, form, finding): (String, Form, Finding)| {
        let name = finding.certificate.clone()?;
        let statement = stated(&claim, form, &finding).expect("a certificate has a formal statement");
        Some(Recorded { name, statement })
    };
    recorded_findings().into_iter().filter_map(certified).collect()
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
    for (claim, form, finding) in recorded_findings() {
        let stated = stated(&claim, form, &finding).is_some();
        assert_eq!(finding.certificate.is_some(), stated, "{claim} ({form})");
        let checked: &[&str] = match (finding.status.as_str(), &finding.certificate) {
            (_, Some(_)) => &["prover", "checker"],
            ("proved" | "refuted", None) => &["engine"],
            _ => &[],
        };
        let by: Vec<_> = finding.checked_by.iter().map(String::as_str).collect();
        assert!(by.ends_with(checked), "{claim} ({form}): {by:?}");
        assert!(by.iter().all(|by| ["engine", "prover", "checker"].contains(by)), "{claim} ({form}): {by:?}");
        let far = |scope: &str| finding.scope.as_deref() == Some(scope);
        assert!(finding.certificate.is_some() || !far("knots") && !far("alpha"), "{claim} ({form})");
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
        let proof = prove(statement).unwrap_or_else(|error| panic!("{name}: {error}"));
        let certificate = Certificate { statement: statement.clone(), proof };
        assert_eq!(&certificate.name(), name);
        let same = certificate.statement_text() == files.statement && certificate.proof_text() == files.proof;
        assert!(same, "{name}: not as in proofs/certs; run `cargo run --release -- prove`");
    });
}

fn honest(files: &Files) -> Checked {
    let checked = check(&files.statement, &files.proof);
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
    for (claim, form, finding) in recorded_findings() {
        let Some(name) = &finding.certificate else { continue };
        let files = FILES.iter().find(|files| files.name == *name).unwrap();
        let statement = Sexp::parse_all(&files.statement).unwrap().remove(0).to_string();
        match finding.scope {
            Some(scope) => {
                assert!(statement.contains(&format!("(verdict proved) (scope {scope})")), "{name}")
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
    const SLOW: [&str; 6] = [
        "T3.5.2.printed",
        "T3.5.3.amended",
        "abstract.approx.printed",
        "P4.1.3.printed",
        "P4.1.4.printed",
        "T4.1.printed",
    ];
    let size = count + tokens(&files.statement).len();
    match (SLOW.contains(&files.name.as_str()), size) {
        (true, _) => places(count, 4),
        (false, 0..=600) => places(count, count),
        (false, _) => places(count, (100_000 / size).clamp(12, 100)),
    }
}

#[test]
fn a_changed_proof_proves_nothing_else() {
    type Tally = BTreeMap<&'static str, (usize, usize)>;
    let one = |files: &Files| -> Tally {
        let (honest, tokens) = (honest(files), tokens(&files.proof));
        let changes: Vec<_> =
            proof_places(files, tokens.len()).into_iter().flat_map(|at| changes(&tokens, at)).collect();
        let outcomes: Vec<_> = changes
            .par_iter()
            .map(|change| {
                let mutant = changed(&tokens, change);
                let checked = check(&files.statement, &mutant).ok();
                let accepted = checked.is_some();
                assert!(checked.is_none_or(|checked| checked == honest), "{}: {mutant}", files.name);
                (change.kind, accepted)
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
    for of_one in FILES.par_iter().map(one).collect::<Vec<_>>() {
        for (kind, (tried, accepted)) in of_one {
            let sum = tally.entry(kind).or_default();
            *sum = (sum.0 + tried, sum.1 + accepted);
        }
    }
    for kind in ["deleted", "doubled", "bracket", "goal number", "section number", "version", "name"] {
        let (tried, accepted) = tally[kind];
        assert!(tried > 100 && accepted == 0, "{kind}: {accepted} of {tried} accepted");
    }
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

/// Which tokens of a statement are changed: all of the first 600 tokens, fewer the longer the statement is.
fn statement_places(count: usize) -> Vec<usize> {
    if count <= 600 { places(count, count) } else { places(count, (400_000 / count).clamp(12, 200)) }
}

/// `verify` knows a statement by reading it; so does `canonical`.
#[test]
fn a_changed_statement_is_no_statement_of_the_program() {
    let own: HashSet<String> = FILES.iter().map(|files| canonical(&files.statement).unwrap()).collect();
    let read: HashSet<String> = RECORDED.iter().map(|own| own.statement.to_sexp().to_string()).collect();
    assert_eq!(own.len(), FILES.len());
    let counts = FILES.par_iter().map(|files| {
        let tokens = tokens(&files.statement);
        let (mut tried, mut statements) = (0, 0);
        for change in statement_places(tokens.len()).iter().flat_map(|at| statement_changes(&tokens, *at)) {
            let mutant = changed(&tokens, &change);
            tried += 1;
            let Ok(text) = canonical(&mutant) else { continue };
            statements += 1;
            let parsed = Sexp::parse_all(&mutant).expect("what the checker reads can be read");
            let parsed: Vec<_> = parsed.iter().map(ToString::to_string).collect();
            assert!(!own.contains(&text) && !read.contains(&parsed.concat()), "{}: {mutant}", files.name);
        }
        (tried, statements)
    });
    let (tried, statements) = counts.reduce(|| (0, 0), |a, b| (a.0 + b.0, a.1 + b.1));
    assert!(statements > 10_000 && tried > 2 * statements, "{tried} tried, {statements} statements");
}

/// The goals of a statement with one token changed are false, or mean nothing, or are true as well: what the checker accepts
/// is nothing that the prover, which evaluates it in another way, knows to be false.
#[test]
fn checker_and_prover_agree_on_changed_statements() {
    let text = |own: &Recorded| own.statement.sections.iter().map(ToString::to_string).collect::<String>();
    let quick = |(own, files): &(&Recorded, &Files)| {
        files.proof.len() < 3_000 && text(own).len() < 2_500 && own.statement.degrees.iter().all(|k| *k <= 5)
    };
    let chosen: Vec<_> = RECORDED.iter().zip(&*FILES).filter(quick).collect();
    let counts = chosen.par_iter().map(|(own, files)| {
        let tokens = tokens(&text(own));
        let (mut accepted, mut rejected) = (0, 0);
        for change in places(tokens.len(), 60).iter().flat_map(|at| statement_changes(&tokens, *at)) {
            let mutant = changed(&tokens, &change);
            let Ok(sections) = Sexp::parse_all(&mutant) else { continue };
            let statement = Statement { sections, ..own.statement.clone() };
            if check(&statement.to_sexp().to_string(), &files.proof).is_err() {
                rejected += 1;
                continue;
            }
            accepted += 1;
            if let Err(error) = prove(&statement) {
                panic!("{}: the checker accepts what the prover does not: {error}: {mutant}", own.name);
            }
        }
        (accepted, rejected)
    });
    let (accepted, rejected) = counts.reduce(|| (0, 0), |a, b| (a.0 + b.0, a.1 + b.1));
    assert!(
        chosen.len() > 50 && accepted > 100 && rejected > 10 * accepted,
        "{accepted} accepted, {rejected} rejected"
    );
}
