//! The theorems for every degree: the rows of `proofs/theory`, the page made of them, and what a row does to a verdict. That the
//! theorems are true is what `proofs/theory/check.sh` asks Coq.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use knotproof::judge::Cases;
use knotproof::language::{Claim, File, Form, Source, claims, paper, shipped};
use knotproof::report::{examples_in_coq, stanzas_in_coq, theory_tables, with_theory_tables};
use knotproof::settle::{
    Computed, Covers, Decides, DegreeRange, Outcome, Proving, StanzaPart, Theory, settle,
};

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("proofs/theory")
}

fn text(file: &str) -> String {
    fs::read_to_string(folder().join(file)).expect(file)
}

fn claim(id: &str) -> Claim<'static> {
    claims().into_iter().find(|claim| claim.id() == id).expect(id)
}

/// The names that rows may give in the place of a claim: of no stanza yet, with lemmas only.
fn is_a_lemma(form: StanzaPart) -> bool {
    form == StanzaPart::Lemma
}

#[test]
fn every_row_is_about_a_sentence_and_names_a_theorem() {
    let knot_weights = Claim::of(shipped("knot-weights").expect("it comes with the program"));
    let all: Vec<_> = claims().into_iter().chain(knot_weights).collect();
    for row in &Theory::shipped().theorems {
        let name = format!("{} {}", row.claim, row.name);
        let stated = ["Theorem", "Lemma", "Corollary"].iter().any(|kind| {
            let begins = |end: char| format!("{kind} {}{end}", row.name);
            text(&row.file).lines().any(|line| [' ', ':'].iter().any(|end| line.starts_with(&begins(*end))))
        });
        assert!(stated, "{name} is not in {}", row.file);
        assert_eq!(row.lacks.is_some(), row.covers == Covers::Part && !is_a_lemma(row.form), "{name}");
        if let Some(form) = row.form.form().filter(|_| row.claim != "D2.3") {
            let claim = all.iter().find(|claim| claim.id() == row.claim).expect(&name);
            let sentence = claim.sentence(form).unwrap_or_else(|| panic!("{name} has no {form}"));
            let about = DegreeRange::of(sentence);
            assert_eq!(row.degrees == DegreeRange::None, about == DegreeRange::None, "{name}: {about}");
        }
    }
}

/// The page says what the rows say, and every claim of the paper without a theorem is on it with its reason.
#[test]
fn the_page_of_the_theorems_is_that_of_the_rows() {
    let (page, theory) = (text("README.md"), Theory::shipped());
    let wanted = with_theory_tables(&page, theory, &claims()).expect("the page has a place for the table");
    let fresh = Path::new(env!("CARGO_TARGET_TMPDIR")).join("README.md");
    fs::write(&fresh, &wanted).expect("a temporary file");
    assert!(page == wanted, "proofs/theory/README.md is out of date: it is now in {}", fresh.display());
    assert!(!theory_tables(theory, &claims()).contains("no reason is given"), "proofs/theory/missing.toml");
    for claim in claims() {
        let missing = theory.missing_because(claim.id()).is_some();
        let wanted = claim.source() == Source::Paper && claim.is_general() && !theory.has_all_of(claim);
        assert_eq!(missing, wanted, "{} in proofs/theory/missing.toml", claim.id());
    }
}

/// What is proved of a stanza is what is printed from it, and what Coq computes are the numbers of this program.
#[test]
fn what_is_printed_for_coq_is_up_to_date() {
    let printed = [("Stanzas.v", stanzas_in_coq(&claims())), ("Examples.v", examples_in_coq(paper()))];
    let fresh = Path::new(env!("CARGO_TARGET_TMPDIR"));
    for (name, text) in &printed {
        fs::write(fresh.join(name), text).expect("a temporary file");
    }
    for (name, printed) in printed {
        let is_it = fs::read_to_string(folder().join(name)).is_ok_and(|text| text == printed);
        assert!(is_it, "proofs/theory/{name} is out of date: it is now in {}", fresh.display());
    }
}

/// The sentences that are called printed from the stanza are those of which Bridge.v has the proof, and that all is defined that
/// they name.
#[test]
fn what_is_called_printed_from_the_stanza_is_proved_in_the_bridge() {
    let theory = Theory::shipped();
    let names = |file: &str, kind: &str| -> BTreeSet<String> {
        let name = |line: &str| Some(line.strip_prefix(kind)?.split([' ', ':']).next()?.to_owned());
        text(file).lines().filter_map(name).collect()
    };
    let (proved, printed) = (names("Bridge.v", "Theorem stanza_"), names("Stanzas.v", "Definition "));
    let listed = theory.stanzas.iter().map(|one| one.replace(['.', ' '], "_"));
    let listed: BTreeSet<_> = listed.collect();
    assert_eq!(listed, proved.iter().filter(|name| !name.ends_with("_defined")).cloned().collect());
    assert!(listed.len() >= 60, "{}", listed.len());
    for name in &listed {
        let defined = format!("{name}_defined");
        assert_eq!(printed.contains(&defined), proved.contains(&defined), "{defined}");
        assert!(text("Bridge.v").contains(&format!("Theorem stanza_{name} : Stanzas.{name} R.\n")), "{name}");
    }
    for one in &theory.stanzas {
        let row = |theorem: &&knotproof::settle::Theorem| {
            theorem.verdict == Decides::Proved && *one == format!("{} {}", theorem.claim, theorem.form.name())
        };
        assert!(theory.theorems.iter().any(|theorem| row(&theorem)), "{one} has no row in theorems.toml");
    }
}

#[test]
fn rows_that_make_no_sense_are_refused_with_their_place() {
    let row = |key: &str, value: &str| {
        let keys = [
            ("claim", "T3.5.2"),
            ("form", "printed"),
            ("verdict", "proved"),
            ("name", "x"),
            ("file", "X.v"),
            ("degrees", "k >= 0"),
            ("weights", "paper"),
            ("covers", "all"),
            ("says", "it"),
        ];
        let lines =
            keys.map(|(name, own)| format!("{name} = \"{}\"\n", if name == key { value } else { own }));
        Theory::read(&format!("[[theorem]]\n{}", lines.concat()))
    };
    assert!(row("says", "it").is_ok());
    for (key, value) in [
        ("form", "amend"),
        ("verdict", "true"),
        ("covers", "most"),
        ("degrees", "k > 0"),
        ("degrees", "k >= "),
        ("degrees", "all"),
    ] {
        let error = row(key, value).expect_err(value).to_string();
        assert!(error.contains("rows of proofs/theory") && error.contains(value), "{error}");
    }
    assert!(Theory::read("[[theorem]]\nclaim = \"T3.5.2\"").is_err(), "a key is missing");
}

#[test]
fn degrees_are_compared() {
    let range = |text: &str| DegreeRange::try_from(text.to_owned()).expect(text);
    for (theorem, sentence, covers) in [
        ("k >= 0", "k >= 1", true),
        ("k >= 1", "k >= 0", false),
        ("k = 0", "k = 0", true),
        ("1 <= k <= 2", "k >= 1", false),
        ("k >= 3", "k = 3", true),
        ("none", "k >= 0", true),
        ("k >= 0", "none", false),
    ] {
        assert_eq!(range(theorem).covers(range(sentence)), covers, "{theorem} {sentence}");
        assert_eq!(range(theorem).to_string(), theorem);
    }
    let of = |id: &str, form| DegreeRange::of(claim(id).sentence(form).expect(id)).to_string();
    // Of k = 0 the range of q leaves nothing.
    assert_eq!(of("L3.6", Form::Printed), "k >= 1");
    assert_eq!(of("L3.10", Form::Amended), "k >= 2");
    assert_eq!(of("T3.5.3", Form::Amended), "k >= 0");
    assert_eq!(of("phi.range", Form::Printed), "none");
    assert_eq!(of("proof.T3.5.4.base", Form::Amended), "k = 0");
}

/// The claim on small cases, and what a certificate says beyond them.
fn settled(id: &str) -> Outcome {
    settle(claim(id), &Cases::new([]).up_to(2), Proving::Everything).expect("no two computations disagree")
}

/// A row that says something false of a claim, and what becomes of a verdict by it.
fn planted(id: &str, form: Form, verdict: &str, degrees: &str) -> Option<String> {
    let rows = format!(
        "[[theorem]]\nclaim = \"{id}\"\nform = \"{form}\"\nverdict = \"{verdict}\"\nname = \"planted\"\n\
         file = \"X.v\"\ndegrees = \"{degrees}\"\nweights = \"paper\"\ncovers = \"all\"\nsays = \"\"\n"
    );
    let theory = Theory::read(&rows).expect("rows");
    let outcome = settled(id);
    let one = outcome.all().find(|one| one.form == form).expect("the sentence is settled");
    let computed = Computed { verdict: &one.verdict, certificate: one.certificate.as_ref() };
    let theorems = theory.about(claim(id), form);
    assert_eq!(theorems.len(), 1, "{id}: the row is about the sentence");
    theorems[0].agrees(form, computed).err().map(|disagreement| disagreement.to_string())
}

/// Two that can't both be stop the report.
#[test]
fn a_false_theorem_is_a_disagreement() {
    let printed = planted("T3.5.3", Form::Printed, "proved", "k >= 0").expect("it is refuted");
    assert!(printed.starts_with("disagreement on T3.5.3 (printed): by the theorem planted"), "{printed}");
    assert!(printed.contains("U = (0, 0, 1, 2)"), "with the counterexample: {printed}");
    let amended = planted("T3.5.3", Form::Amended, "refuted", "k >= 1").expect("it is proved");
    assert!(amended.contains("for k = 1 it is true"), "{amended}");
    assert!(planted("P2.1.1", Form::Printed, "refuted", "none").is_some());
    // What is said of other degrees is no contradiction.
    assert_eq!(planted("T3.5.3", Form::Printed, "proved", "k = 0"), None);
    assert_eq!(planted("T3.5.3", Form::Amended, "refuted", "k = 99"), None);
    assert_eq!(planted("T3.5.3", Form::Amended, "proved", "k >= 0"), None);
}

/// A theorem is about a sentence, not about whatever has its name.
#[test]
fn a_theorem_answers_for_no_other_sentence_of_that_name() {
    let theory = Theory::shipped();
    assert!(!theory.about(claim("T3.5.2"), Form::Printed).is_empty());
    let own = "[[claim]]\nid = \"T3.5.2\"\nat = \"x\"\ntitle = \"x\"\nfor = \"k; U; i in 0..n; x\"\nthen = [\"G[i](x) >= 0\"]\n";
    let file: File = paper().stanzas("own.toml", own).expect("a file of claims");
    let library = paper().with(file);
    let other = Claim::of(&library).next().expect("the own claim");
    assert_eq!(other.id(), "T3.5.2");
    assert!(theory.about(other, Form::Printed).is_empty());
    let classical = shipped("classical").expect("it comes with the program");
    for claim in Claim::of(classical) {
        assert!(theory.about(claim, Form::Printed).is_empty(), "{}", claim.id());
    }
}

/// A theorem that is refuted in some degrees says nothing of a case of the user's own.
#[test]
fn refuted_in_every_degree_is_not_refuted_on_every_case() {
    let rows = || Theory::shipped().about(claim("T3.5.1"), Form::Printed);
    assert!(rows().iter().all(|row| row.verdict == Decides::Refuted) && !rows().is_empty());
    let cases = Cases::new([]).up_to(1);
    let amended = settle(claim("T3.5.1"), &cases, Proving::ForDegree(Some(1))).expect("a verdict");
    let theorems = |one: Option<&knotproof::settle::Settled>| one.map(|one| one.theorems.len());
    assert_eq!(theorems(Some(&amended.printed)), Some(0));
    assert_eq!(theorems(amended.amended.as_ref()), Some(1));
}
