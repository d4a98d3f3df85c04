//! The questions about closeness, order, limits and approximation: their certificates for low degrees, what is refused,
//! and numbers known by other means.

#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests")]

use knotproof::certificate::{Sexp, Statement, certify_for_degree, prove};
use knotproof::judge::{Cases, Verdict};
use knotproof::language::{Claim, Form, claims};
use knotproof::meaning::{Example, examples};
use knotproof::report::Finding;
use knotproof::scalar::{BigRational, integer, rational};
use knotproof::settle::{Outcome, Proving, settle};
use knotproof::spline::{Basis, Index, KnotVector, Side};

/// Those that are certified in every degree.
const IN_EVERY_DEGREE: [&str; 7] =
    ["X.close", "X.order", "X.limit", "X.limit.trace", "X.limit.arc", "X.approximation", "X.weights"];

fn claim(id: &str) -> Claim<'static> {
    claims().into_iter().find(|claim| claim.id() == id).unwrap()
}

/// The formal statement about a degree, proved and accepted by the checker.
fn certified(id: &str, k: usize) -> Statement {
    let certificate = certify_for_degree(claim(id), Form::Printed, Some(k)).unwrap().unwrap();
    let checked = certificate.check().unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(
        (checked.claim.as_str(), checked.degrees.as_slice(), checked.scope.as_str()),
        (id, &[k][..], "knots")
    );
    certificate.statement
}

#[test]
fn low_degrees_are_certified() {
    for k in 1..=3 {
        for id in IN_EVERY_DEGREE {
            // What is not argued is derived.
            let argued = certified(id, k);
            assert!(argued.argued().is_none_or(|(because, _)| !because.is_empty()), "{id}");
        }
    }
    for id in ["X.elevation", "X.condition"] {
        certified(id, 1);
        assert!(
            certify_for_degree(claim(id), Form::Printed, Some(2)).unwrap().is_none(),
            "{id} is false in degree 2"
        );
    }
}

/// Each false variant changes a place of the text of a true statement, which has to be there.
#[test]
fn false_statements_have_no_proof() {
    for (id, true_part, false_part) in [
        // δ less than it is.
        ("X.close", "(/ (- s 1) (+ s 1))", "(* 99/100 (/ (- s 1) (+ s 1)))"),
        // Differences would grow.
        (
            "X.close",
            "(>= (w (- i 1) (- k q) (in A 0)) (w i (- k q) (in A 0)))",
            "(>= (w i (- k q) (in A 0)) (w (- i 1) (- k q) (in A 0)))",
        ),
        // Without interior knots: not k times δ.
        ("X.close", "(* (integer k) (/", "(* (integer (- k 1)) (/"),
        // A smaller ratio in the place of a greater one.
        ("X.order", "(at ((r (+ r p))) (w 0 1 (in A 0)))", "(at ((r (/ r (+ 1 p)))) (w 0 1 (in A 0)))"),
        // The same weight for both ratios.
        ("X.order", "(* (at ((r (+ r p))) (w i d (in A 0)))", "(* (w i d (in A 0))"),
        // Half of the bounds.
        ("X.limit.trace", "(* r (/", "(* 1/2 r (/"),
        ("X.limit.arc", "(>= r (-", "(>= (* 1/2 r) (-"),
        ("X.limit.arc", "(>= (/ 1 r) (-", "(>= (/ 1/2 r) (-"),
        // A pole at infinity for r = 1 only.
        ("X.approximation", "(* (- 1 r) (A 0))", "(* (- 1 (* 2 r)) (A 0))"),
        // One function less.
        ("X.weights", "(+ (each i (- 1 d) 0 (g i)))", "(+ (each i (- 2 d) 0 (g i)) 0)"),
    ] {
        let statement = certified(id, 3);
        let (_, sections) = statement.argued().expect(id);
        let text: String = sections.iter().map(ToString::to_string).collect();
        let wrong = text.replace(true_part, false_part);
        let changed = wrong != text;
        let statement = statement.with_sections(Sexp::parse_all(&wrong).unwrap());
        assert!(changed, "{id}: {true_part} is not there");
        assert!(prove(&statement).is_err(), "{id}: {false_part} is proved");
    }
}

/// The claim on the cases of degrees up to 3.
fn settled(id: &str, proving: Proving) -> Outcome {
    let cases = Cases::new(examples().iter().flat_map(Example::instances)).up_to(3);
    settle(claim(id), &cases, proving).unwrap()
}

#[test]
fn the_engine_agrees() {
    for id in IN_EVERY_DEGREE {
        let verdict = settled(id, Proving::Nothing).printed.verdict;
        // For r + s, with any s > 0: numbers that are tried refute, and prove nothing.
        if id == "X.order" {
            assert!(
                matches!(&verdict, Verdict::Undecided(why) if why.contains("tries of numbers")),
                "{verdict:?}"
            );
            continue;
        }
        let Verdict::Proved { reach, .. } = &verdict else { panic!("{id}: {verdict:?}") };
        assert!(reach.degrees.ends_with(&[1, 2, 3]), "{id}: {:?}", reach.degrees);
    }
}

/// True for degree 1, and false from degree 2 on; with the smallest witness.
#[test]
fn what_fails_is_refuted_and_amended() {
    for (id, knots, amended) in [
        ("X.elevation", "(0, 0, 0, 1, 2, 2, 2)", vec![]),
        ("X.condition", "(0, 0, 0, 1, 1, 1)", vec!["X.condition.amended"]),
    ] {
        let outcome = settled(id, Proving::Everything);
        let Verdict::Refuted(witness) = &outcome.printed.verdict else { panic!("{id}") };
        assert!(witness.given().contains(&("U".into(), knots.into())), "{id}: {witness}");
        let of_amended = outcome.amended.as_ref().map(|amended| amended.verdict.status());
        assert_eq!(of_amended, Some("proved"), "{id}");
        let by_degree = outcome.by_degree.iter().map(|of| (of.form, Finding::of(claim(id), of).status));
        let expected = [(1, "proved"), (2, "refuted"), (3, "refuted")];
        let expected = expected.map(|(k, status)| (Form::Degree(k), status.to_owned()));
        assert_eq!(by_degree.collect::<Vec<_>>(), expected, "{id}");
        // Each of them has been checked.
        let names: Vec<_> = outcome.all().filter_map(|one| Some(one.certificate.as_ref()?.name())).collect();
        let degrees = ["degrees", "printed", "printed"].map(|form| format!("{id}.{form}"));
        let expected = std::iter::once(format!("{id}.printed"));
        let expected = expected.chain(amended.into_iter().map(str::to_owned)).chain(degrees);
        assert_eq!(names, expected.collect::<Vec<_>>());
    }
}

fn basis(knots: &[usize], k: usize, index: &Index) -> Basis {
    let knots = knots.iter().copied().map(integer).collect();
    Basis::new(KnotVector::new(knots).unwrap(), k, index.clone()).unwrap()
}

/// By the definition at points: the distance between the curves is at most kδ, and more than that times 999/1000 somewhere
/// without interior knots. With r = s² all is rational.
#[test]
fn the_bound_holds_at_points_and_is_nearly_attained() {
    let open = [0, 0, 0, 0, 1, 3, 4, 4, 4, 4];
    let single = [0, 0, 0, 0, 4, 4, 4, 4];
    for s in [rational(1, 7), rational(2, 3), rational(3, 2), rational(9, 1)] {
        let index = Index::from_ratio(&s * &s).unwrap();
        let one = integer(1);
        let delta = if s > one { (&s - &one) / (&s + &one) } else { (&one - &s) / (&s + &one) };
        let bound = integer(3) * &delta;
        let farthest = |knots: &[usize]| {
            let (here, there) = (basis(knots, 3, &index), basis(knots, 3, &Index::infinity()));
            let distance = |x: &BigRational| {
                let values = here.values(x, Side::Right).into_iter().zip(there.values(x, Side::Right));
                let sum: BigRational = values.enumerate().map(|(i, (a, b))| integer(i) * (a - b)).sum();
                if sum < integer(0) { -sum } else { sum }
            };
            (0..400).map(|step| distance(&rational(step, 100))).max().unwrap()
        };
        assert!(farthest(&open) < bound);
        let nearly = farthest(&single);
        assert!(nearly <= bound && nearly > bound * rational(999, 1000), "{s}");
    }
}

/// As α → 0⁻ the values of C5's knots at points inside of spans: the first function of each tends to 1.
#[test]
fn the_limit_is_a_step_function() {
    let knots = [0, 0, 0, 0, 1, 2, 3, 4, 5, 5, 5, 5];
    for (ratio, last) in [(rational(1, 1_000_000), false), (rational(1_000_000, 1), true)] {
        let basis = basis(&knots, 3, &Index::from_ratio(ratio).unwrap());
        for j in 3..=7 {
            let x = rational(2 * (i64::try_from(j).unwrap() - 3) + 1, 2);
            let i = if last { j } else { j - 3 };
            assert!(basis.values(&x, Side::Right)[i] > rational(99_998, 100_000), "{j}");
        }
    }
}
