//! The whole report, once, against the recorded verdicts; and what has to be true of the claims whatever the
//! verdicts are.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::sync::LazyLock;

use knotproof::judge::{Shows, Witness};
use knotproof::language::{Claim, Form, Source, claims, paper};
use knotproof::report::{Baseline, Entry, Finding, Record, Report, markdown, verdicts_page};

/// Judging everything takes most of a minute: the tests here share one run.
static REPORT: LazyLock<Report<'static>> = LazyLock::new(|| {
    let report = Report::of(paper(), &claims(), None, |_, _| ()).expect("no two computations disagree");
    report.with_float()
});

/// Every finding of a record, with a name for it.
fn findings(record: &Record) -> Vec<(String, &Finding)> {
    let name = |of: &str| format!("{}, {of}", record.id);
    let mut findings = vec![(name("as printed"), &record.as_printed.finding)];
    findings.extend(record.amended.as_ref().map(|stated| (name("as amended"), &stated.finding)));
    findings.extend(record.fails.as_ref().map(|stated| (name("where that fails"), &stated.finding)));
    let degrees = record.by_degree.iter();
    findings.extend(degrees.map(|of| (name(&format!("degree {}", of.degree)), &of.finding)));
    findings
}

fn all_findings() -> impl Iterator<Item = (String, &'static Finding)> {
    REPORT.claims.iter().flat_map(findings)
}

#[test]
fn every_claim_has_a_statement_and_a_place_in_the_paper() {
    for claim in claims() {
        let (id, at, printed) = (claim.id(), &claim.stanza.at, claim.text(Form::Printed));
        assert!(!at.is_empty() && !printed.is_empty(), "{id}");
        assert_eq!(claim.source() == Source::Question, at == "not in the paper", "{id}");
        assert_ne!(claim.text(Form::Amended), printed, "{id}");
    }
}

/// A change of any verdict shows here, with what was recorded and what is found now. If it is meant, record it:
/// `cargo run --release -- report --record`.
#[test]
fn every_verdict_is_as_recorded() {
    let recorded = Baseline::recorded().expect("proofs/verdicts.json can be read");
    let differences = recorded.differences(&Baseline::of(&REPORT.claims), false);
    let differences: Vec<_> = differences.iter().map(ToString::to_string).collect();
    assert!(differences.is_empty(), "not as recorded:\n{}", differences.join("\n"));
}

/// What is written is what is read again, numbers in all places included.
#[test]
fn verdicts_survive_being_written_and_read() {
    let found = Baseline::of(&REPORT.claims);
    let text = serde_json::to_string_pretty(&found).expect("plain data");
    assert_eq!(Baseline::parse(&text).expect("our own text"), found);
}

#[test]
fn the_report_covers_all_claims() {
    let claims = claims();
    let ids: Vec<_> = claims.iter().map(Claim::id).collect();
    assert!(ids.len() > 100 && ids.iter().eq(REPORT.claims.iter().map(|record| &record.id)));
    assert!(!REPORT.float.is_empty());
    let text = markdown(&REPORT, "proofs/certs");
    assert!(text.contains("arXiv 1805.04433") && text.contains("the appendix with the formal expressions"));
    for id in ids {
        assert!(text.contains(&format!("| `{id}` |")) && text.contains(&format!("### {id} (")), "{id}");
    }
}

/// `evidence` in particular is no status: points alone settle nothing.
#[test]
fn every_status_says_what_it_has_to() {
    for (name, finding) in all_findings() {
        let said = finding.reason.as_deref().is_some_and(|reason| !reason.trim().is_empty());
        match finding.status.as_str() {
            "proved" => assert!(finding.scope.is_some() && finding.witness.is_none(), "{name}"),
            "refuted" => assert!(finding.witness.is_some() && finding.scope.is_none(), "{name}"),
            "undecided" | "not-formal" => assert!(said && finding.scope.is_none(), "{name}: no reason"),
            other => panic!("{name} has the status {other}"),
        }
        assert_ne!(finding.scope.as_deref(), Some("points"), "{name}: points prove nothing");
    }
}

/// A verdict about all α or all knots rests on a certificate; one about every degree on a theorem; one about the cases that were
/// tried, on the engine.
#[test]
fn every_verdict_says_who_came_to_it() {
    let (mut certified, mut of_every_degree) = (0, 0);
    for (name, finding) in all_findings() {
        let mut by: Vec<_> = finding.checked_by.iter().map(String::as_str).collect();
        let same = finding.theorems.iter().filter(|theorem| theorem.status == finding.status);
        let whole = same.clone().any(|theorem| theorem.all_degrees) && finding.status == "proved";
        assert_eq!(by.last() == Some(&"coq"), same.count() > 0, "{name}: {by:?}");
        by.retain(|by| *by != "coq");
        of_every_degree += usize::from(finding.scope.as_deref() == Some("degree"));
        if whole {
            let expected: &[&[&str]] =
                &[&["engine", "prover", "checker"], &["prover", "checker"], &["engine"], &[]];
            let one = name.contains(", degree ") || finding.degrees.len() == 1;
            assert!(finding.scope.as_deref() == Some("degree") || one, "{name}: {:?}", finding.scope);
            assert!(expected.contains(&by.as_slice()), "{name}: {by:?}");
            certified += usize::from(finding.certificate.is_some());
            continue;
        }
        let expected: &[&[&str]] =
            match (finding.status.as_str(), &finding.certificate, finding.scope.as_deref()) {
                ("proved", None, Some("instance")) | ("refuted", None, None) => &[&["engine"]],
                ("refuted", Some(_), None) => &[&["engine", "prover", "checker"]],
                // What no finite number of cases settles may have a proof all the same.
                ("proved", Some(_), Some("knots" | "alpha" | "instance")) => {
                    &[&["engine", "prover", "checker"], &["prover", "checker"]]
                }
                ("undecided" | "not-formal", None, None) => &[&[]],
                other => panic!("{name}: {other:?}"),
            };
        assert!(expected.contains(&by.as_slice()), "{name}: {by:?}");
        certified += usize::from(finding.certificate.is_some());
    }
    assert!(certified > 130, "only {certified} certificates");
    assert!(of_every_degree > 60, "only {of_every_degree} verdicts about every degree");
}

/// The certificates of a report are those in proofs/certs, and each is about the finding that names it.
#[test]
fn every_certificate_of_the_report_is_there() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("proofs/certs");
    let mut named = BTreeMap::new();
    for record in &REPORT.claims {
        for (name, finding) in findings(record) {
            let Some(certificate) = &finding.certificate else { continue };
            // Of one degree it may be the one of several.
            let of_degree = name.contains(", degree ");
            assert!(!named.contains_key(certificate) || of_degree, "{certificate} is named twice");
            assert!(certificate.starts_with(&format!("{}.", record.id)), "{name}: {certificate}");
            let read = |extension: &str| {
                fs::read_to_string(folder.join(format!("{certificate}.{extension}"))).expect("it is there")
            };
            let check =
                || knotproof_checker::check(&read("statement"), &read("proof")).expect("it is accepted");
            let checked = named.entry(certificate.clone()).or_insert_with(check);
            assert_eq!((&checked.claim, &checked.verdict), (&record.id, &finding.status), "{name}");
            if finding.status == "proved" {
                let further = finding.theorems.iter().any(|theorem| theorem.all_degrees);
                assert!(further || Some(&checked.scope) == finding.scope.as_ref(), "{name}");
                let about_weight = finding.degrees.is_empty();
                let within = finding.degrees.iter().all(|k| checked.degrees.contains(k));
                assert!(about_weight || checked.degrees == finding.degrees || of_degree && within, "{name}");
            }
        }
    }
    assert_eq!(fs::read_dir(folder).expect("it is a folder").count(), 2 * named.len());
}

#[test]
fn every_proof_says_on_how_much_it_rests() {
    for record in &REPORT.claims {
        for stated in std::iter::once(&record.as_printed).chain(&record.amended).chain(&record.fails) {
            match (&stated.rests_on, stated.finding.status.as_str()) {
                (Some(grounds), "proved") => {
                    assert!(
                        grounds.facts > 0 && grounds.instances + grounds.small_cases > 0,
                        "{}",
                        record.id
                    );
                }
                // Where numbers are only tried the proof is a certificate or a theorem alone.
                (None, "proved") => {
                    let finding = &stated.finding;
                    assert!(finding.certificate.is_some() || !finding.theorems.is_empty(), "{}", record.id);
                }
                (None, _) => {}
                (Some(_), status) => panic!("{} rests on something and is {status}", record.id),
            }
        }
    }
}

#[test]
fn a_refuted_claim_has_an_amended_statement_that_is_proved() {
    for record in REPORT.claims.iter().filter(|record| !record.id.starts_with("X.")) {
        let amended = record.amended.as_ref().map(|stated| stated.finding.status.as_str());
        match record.as_printed.finding.status.as_str() {
            "refuted" => assert_eq!(amended, Some("proved"), "{}", record.id),
            _ => assert_eq!(amended, None, "{} needs no amendment", record.id),
        }
    }
}

#[test]
fn a_claim_has_a_cause_of_its_failure_if_and_only_if_it_is_refuted() {
    for (claim, record) in claims().iter().zip(&REPORT.claims) {
        let refuted = record.as_printed.finding.status == "refuted";
        assert_eq!(claim.stanza.cause.is_some(), refuted, "{}: {:?}", claim.id(), claim.stanza.cause);
    }
}

/// An amendment that excludes cases excludes no case in which the printed statement holds.
#[test]
fn what_holds_where_the_amendment_does_not_apply_is_proved() {
    let stated = REPORT.claims.iter().filter_map(|record| Some((record, record.fails.as_ref()?)));
    let stated: Vec<_> = stated.map(|(record, fails)| (&record.id, fails.finding.status.as_str())).collect();
    // One speaks of any four numbers: these are only tried.
    let open: Vec<_> = stated.iter().filter(|(_, status)| *status != "proved").collect();
    let tried = open.iter().all(|(id, status)| *id == "C2.4" && *status == "undecided");
    assert!(stated.len() > 5 && tried, "{open:?}");
}

/// A point between two digits: a decimal, which may be rounded.
fn has_decimal(text: &str) -> bool {
    let characters: Vec<_> = text.chars().collect();
    characters.windows(3).any(|w| w[0].is_ascii_digit() && w[1] == '.' && w[2].is_ascii_digit())
}

/// All texts of a witness but the first digits of what is irrational, which say so.
fn texts(witness: &Witness) -> Vec<String> {
    let mut witness = witness.clone();
    if let Shows::Values(terms) = &mut witness.shows {
        terms.retain(|term| !term.rounded);
    }
    let given = witness.given().into_iter().flat_map(|(name, value)| [name, value]);
    // The claim's number would be taken for a decimal.
    given
        .chain([witness.claimed.clone(), witness.found(), witness.again("CLAIM", Form::Printed, paper())])
        .collect()
}

#[test]
fn every_witness_is_exact_and_complete() {
    let mut seen = 0;
    for (name, finding) in all_findings() {
        let Some(witness) = &finding.witness else { continue };
        seen += 1;
        assert!(
            !witness.given().is_empty() && !witness.claimed.is_empty() && !witness.found().is_empty(),
            "{name}"
        );
        assert_ne!(witness.claimed, witness.found(), "{name}");
        // Of an irrational number the first digits are shown, which are settled, and it says so.
        let digits = matches!(&witness.shows, Shows::Values(terms) if terms.iter().any(|term| term.rounded));
        for text in texts(witness).into_iter().filter(|text| !digits || *text != witness.found()) {
            assert!(!has_decimal(&text) && !text.contains('≈') && !text.contains("NaN"), "{name}: {text}");
        }
    }
    assert!(seen > 20, "only {seen} witnesses: the test does not see them");
    assert!(has_decimal("x = 0.5") && !has_decimal("(1, 2). 3"));
}

/// Degree by degree, and never one degree for all: a question is not settled by the degree that fails first.
#[test]
fn every_question_is_settled_degree_by_degree() {
    for record in &REPORT.claims {
        let degrees: Vec<_> = record.by_degree.iter().map(|of| of.degree).collect();
        let conjecture = record.id.starts_with("Conj3.1.") && record.id.ends_with(".continuous");
        if conjecture {
            assert_eq!(degrees, (1..=8).collect::<Vec<_>>(), "{}", record.id);
            let statuses: Vec<_> = record.by_degree.iter().map(|of| of.finding.status.as_str()).collect();
            assert_eq!(
                (&statuses[..2], &statuses[2..]),
                (&["proved"; 2][..], &["refuted"; 6][..]),
                "{}",
                record.id
            );
        }
        if conjecture || record.id.starts_with("X.") {
            assert!(degrees.len() > 1 && degrees.is_sorted(), "{}: {degrees:?}", record.id);
            let refuted = |finding: &Finding| finding.status == "refuted";
            // The claim falls with the lowest degree in which it does, by the same witness.
            let first = record.by_degree.iter().find(|of| refuted(&of.finding));
            let whole = &record.as_printed.finding;
            let witness = first.map(|of| &of.finding.witness);
            assert_eq!(witness, refuted(whole).then_some(&whole.witness), "{}", record.id);
        } else {
            assert!(degrees.is_empty(), "{}", record.id);
        }
    }
}

#[test]
fn the_page_of_verdicts_is_the_recorded_one() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/verdicts.md");
    let page = fs::read_to_string(path).expect("there is a docs/verdicts.md");
    let recorded = Baseline::recorded().expect("proofs/verdicts.json can be read");
    assert!(
        page == verdicts_page(&recorded),
        "the table is out of date: run `cargo run --release -- report --record`"
    );
    for Entry { id, .. } in &recorded.claims {
        assert_eq!(page.matches(&format!("| `{id}` |")).count(), 1, "{id}");
    }
    // What the table says of a claim is its verdict with its reach, and where the certificates are.
    for (row, entry) in page.lines().filter(|line| line.starts_with("| `")).zip(&recorded.claims) {
        let said = |finding: &Finding| match finding.reach() {
            Some(reach) => format!("{} ({reach})", finding.status),
            None => finding.status.clone(),
        };
        let amended = entry.amended.as_ref().map(said).unwrap_or_default();
        assert!(row.contains(&format!(" {} | {amended} |", said(&entry.as_printed))), "{row}");
        let degrees = entry.by_degree.iter().map(|of| &of.finding);
        let all = std::iter::once(&entry.as_printed).chain(&entry.amended).chain(degrees);
        for certificate in all.filter_map(|finding| finding.certificate.as_ref()) {
            let link = format!("(../proofs/certs/{certificate}.statement)");
            assert!(row.contains(&link), "{row}: {link}");
        }
        for theorem in entry.theorems() {
            assert!(row.contains(&format!("](../proofs/theory/{})", theorem.file)), "{row}: {theorem:?}");
        }
    }
}
