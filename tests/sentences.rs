//! Sentences of the paper besides its theorems: definitions, captions, steps of proofs, what the text says on pictures and
//! on the class as a whole. Their verdicts, and that each formal statement about them, made false at one place, has no
//! proof.

use std::sync::LazyLock;

use knotproof::certificate::{Certificate, Sexp, Statement, prove, statement};
use knotproof::judge::{Cases, Verdict};
use knotproof::language::{Cause, Claim, Form, claims, paper};
use knotproof::scalar::{parse_rational, rational};
use knotproof::settle::{Outcome, Proving, settle};
use knotproof_checker::check;
use rayon::prelude::*;

fn claim(id: &str) -> Claim<'static> {
    claims().into_iter().find(|claim| claim.id() == id).expect(id)
}

/// Those that speak of numbers which are only tried: cases prove nothing, and a certificate does.
const TRIED: [&str; 2] = ["abstract.bezier", "Ill2.1.crucial"];

/// The sentences that are true as printed.
const TRUE: [&str; 8] = [
    "abstract.bezier",
    "Ill2.1.crucial",
    "D3.2.stop",
    "P3.1.extension",
    "Ill5.5.2.zero",
    "Ill5.6.increasing",
    "Ill5.7.small",
    "Fig27-33",
];

/// A claim, names and values of its witness, and why it fails.
type Refuted = (&'static str, &'static [(&'static str, &'static str)], Cause);

/// Those that are false as printed, with what is given for each witness, in part, and why it fails.
#[rustfmt::skip]
const FALSE: [Refuted; 16] = [
    ("abstract.classical", &[("k", "1"), ("U", "(0, 0, 1, 1)"), ("α", "-1")], Cause::Conjecture),
    ("abstract.bezier.points", &[("k", "1"), ("U", "(0, 0, 1, 1)")], Cause::VagueWords),
    ("D3.1.interval", &[("k", "1"), ("U", "(0, 0, 1, 2)"), ("i", "3")], Cause::EndPoints),
    ("D3.2.examples", &[("instance", "U0"), ("k", "3")], Cause::EndPoints),
    ("P4.2.tangent", &[("k", "1"), ("d", "(1, 0, 0)")], Cause::VagueWords),
    ("T4.1.range", &[("k", "1"), ("j", "1"), ("q", "0"), ("i", "0")], Cause::IndexRange),
    ("Ill5.5.2.general", &[("instance", "C5"), ("α", "-4")], Cause::Picture),
    ("Ill5.8.remarkable", &[("instance", "S3"), ("α", "-1/2")], Cause::Picture),
    ("C6.classical", &[("k", "1"), ("U", "(0, 0, 1, 1)"), ("α", "-1")], Cause::Conjecture),
    ("proof.T3.5.3.iff", &[("k", "1"), ("U", "(0, 0, 1, 1)"), ("i", "1"), ("j", "1"), ("x", "0")], Cause::ProofStep),
    ("proof.P4.1.2.iff", &[("k", "1"), ("U", "(0, 0, 1, 1)"), ("i", "1"), ("j", "1"), ("x", "0")], Cause::ProofStep),
    ("proof.P3.1.2.induction", &[("k", "2"), ("i", "2"), ("x", "1")], Cause::ProofStep),
    ("proof.P3.2.hypothesis", &[("k", "2"), ("U", "(0, 0, 0, 1, 1, 1)")], Cause::ProofStep),
    ("proof.T3.5.4.base", &[("k", "0")], Cause::ProofStep),
    ("proof.T3.5.4.corollary", &[("k", "1")], Cause::OutsideInterval),
    ("proof.P4.3.bisector", &[("k", "1"), ("i", "1")], Cause::ProofStep),
];

/// Judging all of them takes a few seconds: the tests share it.
static JUDGED: LazyLock<Vec<(&str, Outcome)>> = LazyLock::new(|| {
    let cases = Cases::of_paper(paper()).expect("every index gives weights");
    let ids = TRUE.into_iter().chain(FALSE.map(|(id, ..)| id));
    ids.map(|id| (id, settle(claim(id), &cases, Proving::Nothing).expect("no two computations disagree")))
        .collect()
});

fn judged(id: &str) -> &'static Outcome {
    &JUDGED.iter().find(|(of, _)| *of == id).expect(id).1
}

#[test]
fn what_is_true_as_printed_is_proved() {
    for id in TRUE {
        let verdict = &judged(id).printed.verdict;
        let is_tried = matches!(verdict, Verdict::Undecided(why) if why.contains("tries of numbers"));
        assert_eq!(is_tried, TRIED.contains(&id), "{id}: {verdict:?}");
        assert!(is_tried || matches!(verdict, Verdict::Proved { .. }), "{id}: {verdict:?}");
        let stanza = claim(id).stanza;
        assert!(stanza.amended.is_none() && stanza.cause.is_none(), "{id}");
    }
}

#[test]
fn what_is_false_has_the_smallest_witness_a_cause_and_an_amendment_that_is_proved() {
    for (id, given, cause) in FALSE {
        let Outcome { printed, amended, .. } = judged(id);
        let Verdict::Refuted(witness) = &printed.verdict else { unreachable!("{id}: {printed:?}") };
        let found = witness.given();
        for (name, value) in given {
            let value = (name.to_string(), value.to_string());
            assert!(found.contains(&value), "{id}: {value:?} in {witness}");
        }
        let amended = amended.as_ref().map(|amended| &amended.verdict);
        assert!(matches!(amended, Some(Verdict::Proved { .. })), "{id}: {amended:?}");
        assert_eq!(claim(id).stanza.cause, Some(cause), "{id}");
    }
}

/// The eight greatest distances tell the two columns of Fig. 22 apart; they are known by other means, in units of 10⁻⁵.
#[test]
fn the_columns_of_figure_22_are_told_apart() {
    let Verdict::Proved { reach, .. } = &judged("Ill5.5.2.zero").printed.verdict else {
        unreachable!("it is proved")
    };
    let expected = [
        ("-4", [24798, 24718]),
        ("-1/2", [119_646, 116_154]),
        ("-1/5", [189_055, 178_777]),
        ("-1/7", [215_128, 204_915]),
    ];
    assert_eq!(reach.found.len(), 2 * expected.len());
    for (found, (alpha, distances)) in reach.found.chunks(2).zip(expected) {
        for (square, distance) in found.iter().zip(distances) {
            let end = |text: &str| parse_rational(text).expect("a decimal");
            let at = |distance: i64| rational(distance * distance, 10_000_000_000);
            assert_eq!((&*square.instance, &*square.alpha), ("C5", alpha));
            assert!(at(distance) <= end(&square.hi) && end(&square.lo) <= at(distance + 2), "{square:?}");
        }
    }
}

/// Formal statements, each made false at one place.
#[rustfmt::skip]
const MISSES: &[(&str, Form, [&str; 2])] = &[
    ("abstract.bezier", Form::Printed, ["(> ", "(< "]),
    ("Ill2.1.crucial", Form::Printed, ["(^ (- 1 u) 2)", "(^ (- 2 u) 2)"]),
    ("D3.1.interval", Form::Amended, ["(< (t A 0)", "(> (t A 0)"]),
    ("P4.2.tangent", Form::Amended, ["(order i k (in A k) i)", "(order i k (in A k) 1)"]),
    ("Ill5.5.2.general", Form::Amended, ["(* (d 0)", "(* (d 1)"]),
    ("Ill5.5.2.zero", Form::Printed, ["(let r 4/5)", "(let r 9/10)"]),
    ("Ill5.7.small", Form::Printed, ["9/16", "1/100"]),
    ("Ill5.8.remarkable", Form::Amended, ["1/400", "4"]),
    ("proof.T3.5.4.corollary", Form::Amended, ["(/ 1 r)", "r"]),
];

fn text_of(statement: &Statement) -> Option<String> {
    Some(statement.sections()?.iter().map(ToString::to_string).collect())
}

/// The statement has a proof that the checker accepts; with other sections it has none, and that one is rejected.
fn only_the_truth_is_proved(truth: Statement, sections: &str) {
    let id = truth.claim.clone();
    let sections = Sexp::parse_all(sections).expect("still in the language");
    let lie = truth.clone().with_sections(sections);
    let proof = prove(&truth).unwrap_or_else(|error| unreachable!("{id}: {error}"));
    let certificate = Certificate { statement: truth, proof };
    certificate.check().unwrap_or_else(|error| unreachable!("{error}"));
    assert!(prove(&lie).is_err(), "{id}");
    assert!(check(&lie.to_sexp().to_string(), &certificate.proof_text()).is_err(), "{id}");
}

#[test]
fn a_statement_made_false_at_one_place_has_no_proof() {
    MISSES.par_iter().for_each(|(id, form, [part, instead])| {
        let stated = statement(claim(id), *form, None).expect("it is in the language");
        let mut truth = stated.unwrap_or_else(|| unreachable!("{id} is not stated formally"));
        // The least degrees do.
        let fewest = truth.degrees.first().copied().unwrap_or(0).max(3);
        truth.degrees.retain(|k| *k <= fewest);
        let sections = text_of(&truth).expect(id);
        assert!(sections.contains(part), "{id}: `{part}`");
        only_the_truth_is_proved(truth, &sections.replacen(part, instead, 1));
    });
}

#[test]
fn a_refutation_made_false_at_one_place_has_no_proof() {
    FALSE.par_iter().for_each(|(id, ..)| {
        let Verdict::Refuted(witness) = &judged(id).printed.verdict else { unreachable!("{id} is refuted") };
        let stated = statement(claim(id), Form::Printed, Some(witness)).expect("it is in the language");
        let truth = stated.unwrap_or_else(|| unreachable!("{id} is not stated formally"));
        assert!(truth.refuted, "{id}");
        // The first goal, turned round.
        let Some(sections) = text_of(&truth) else {
            // A point: the other way round the sentence is true there.
            let proof = prove(&truth).unwrap_or_else(|error| unreachable!("{id}: {error}"));
            let certificate = Certificate { statement: truth, proof };
            certificate.check().unwrap_or_else(|error| unreachable!("{error}"));
            return;
        };
        let (before, goal) = sections.split_once("(goals (").expect("there are goals");
        let turned = match goal.split_once(' ').expect("a comparison") {
            ("=" | "<", rest) => format!("(goals (> {rest}"),
            (">" | ">=", rest) => format!("(goals (< {rest}"),
            // Unlike x, 1 is a combination of the functions.
            ("outside", rest) => format!("(goals (outside {}", rest.replacen("(x (in A 1))", "1", 1)),
            (other, _) => unreachable!("{id}: a goal with {other}"),
        };
        only_the_truth_is_proved(truth, &format!("{before}{turned}"));
    });
}
