//! The engine that judges statements: what it promises, on statements small enough to know the answer of.

use std::fmt;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;
use std::time::Duration;

use knotproof::claims::{
    Case, Fault, Judgement, Ledger, Origin, Reach, Scope, Sharpness, Statement, Stop, Verdict, Witness,
    judge, judge_by_degree, sharpness,
};
use knotproof::scalar::{Polynomial, RationalFunction, integer, rational};

/// The number itself is the case; n stands for "of size n".
#[derive(Debug, Clone, Copy)]
struct Number {
    n: usize,
    degree: Option<usize>,
    origin: Origin,
}

impl Number {
    fn small(n: usize) -> Self {
        Self { n, degree: None, origin: Origin::Small }
    }

    fn of_degree(degree: usize, n: usize) -> Self {
        Self { degree: Some(degree), ..Self::small(n) }
    }
}

#[derive(Debug, PartialEq)]
enum Hypothesis {
    Even,
    AtMost(usize),
}

impl fmt::Display for Hypothesis {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Even => f.write_str("n is even"),
            Self::AtMost(most) => write!(f, "n ≤ {most}"),
        }
    }
}

impl Case for Number {
    type Hypothesis = Hypothesis;
    fn origin(&self) -> Origin {
        self.origin
    }
    fn meets(&self, hypothesis: &Hypothesis) -> bool {
        match hypothesis {
            Hypothesis::Even => self.n.is_multiple_of(2),
            Hypothesis::AtMost(most) => self.n <= *most,
        }
    }
    fn degree(&self) -> Option<usize> {
        self.degree
    }
    fn instances(&self) -> usize {
        self.n
    }
}

/// What the conclusion comes to in one case.
#[derive(Clone, Copy)]
enum Act {
    Holds,
    Nothing,
    Fails,
    Stuck,
    Breaks,
}
use Act::{Breaks, Fails, Holds, Nothing, Stuck};

fn witness(n: usize) -> Box<Witness> {
    let given = vec![("n".to_owned(), n.to_string())];
    Box::new(Witness { given, claimed: "it holds".into(), found: "it does not".into(), reproduce: None })
}

fn act(act: Act, n: usize, ledger: &mut Ledger) -> Judgement {
    match act {
        Holds => {
            assert!(ledger.count(n, n));
            Ok(())
        }
        Nothing => Ok(()),
        Fails => Err(Stop::Refuted(witness(n))),
        Stuck => Err(Stop::Undecided(format!("limit {n}"))),
        Breaks => Err(Stop::Fault(format!("{n} is not {n}"))),
    }
}

/// The statement that comes to `acts[n]` in case n.
fn statement(acts: &[Act]) -> Statement<Number> {
    let acts = acts.to_vec();
    Statement::new("", move |case: &Number, ledger| act(acts[case.n], case.n, ledger))
}

fn judged(acts: &[Act]) -> Result<Verdict, Fault> {
    let cases: Vec<_> = (0..acts.len()).map(Number::small).collect();
    judge(&statement(acts), &cases)
}

fn on_threads<T: Send>(threads: usize, run: impl FnOnce() -> T + Send) -> T {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
    pool.install(run)
}

/// The small cases are slow and the large ones fail at once: with several threads, a large one fails first.
#[test]
fn the_witness_is_the_first_failing_case_on_any_number_of_threads() {
    const FIRST: usize = 37;
    let cases: Vec<_> = (0..2000).map(Number::small).collect();
    let failing_from = |first: usize| {
        Statement::new("", move |case: &Number, ledger: &mut Ledger| {
            if [0, FIRST].contains(&case.n) {
                thread::sleep(Duration::from_millis(30));
            }
            act(if case.n >= first && case.n % 3 == FIRST % 3 { Fails } else { Holds }, case.n, ledger)
        })
    };
    for threads in [1, 2, 8] {
        let verdict = on_threads(threads, || judge(&failing_from(FIRST), &cases));
        assert_eq!(verdict, Ok(Verdict::Refuted(witness(FIRST))), "{threads} threads");
        let verdict = on_threads(threads, || judge(&failing_from(usize::MAX), &cases));
        let all = Reach { small_cases: 2000, facts: 2000, ..Reach::default() };
        assert_eq!(verdict, Ok(Verdict::Proved { scope: Scope::Instance, reach: all }), "{threads} threads");
    }
}

#[test]
fn nothing_checked_is_nothing_proved() {
    for acts in [&[][..], &[Nothing], &[Nothing, Nothing, Nothing]] {
        let verdict = judged(acts).expect("no fault");
        assert!(matches!(verdict, Verdict::NotApplicable(_)), "{verdict:?}");
        assert_eq!((verdict.status(), verdict.scope()), ("not-applicable", None));
    }
    // A remark is no fact.
    let remark = Statement::new("", |_: &Number, ledger: &mut Ledger| {
        ledger.remark("a figure".into());
        Ok(())
    });
    let verdict = judge(&remark, &[Number::small(1)]).expect("no fault");
    assert!(matches!(verdict, Verdict::NotApplicable(_)), "{verdict:?}");
}

#[test]
fn a_proof_rests_on_the_cases_in_which_something_was_decided() {
    let case = |n, degree, origin| Number { n, degree, origin };
    let cases = [
        case(0, Some(2), Origin::Small),
        case(1, Some(7), Origin::Small),
        case(2, Some(1), Origin::Small),
        case(3, Some(2), Origin::Paper),
        case(4, None, Origin::User),
    ];
    let statement = Statement::new("", |case: &Number, ledger: &mut Ledger| {
        if case.n != 1 {
            ledger.remark(format!("case {}", case.n));
            act(Holds, case.n, ledger)?;
            act(Holds, case.n, ledger)?;
        }
        Ok(())
    });
    let verdict = judge(&statement, &cases).expect("no fault");
    let expected = Reach {
        // A case of the paper or of the user may stand for several instances. Only of those are remarks kept.
        instances: 3 + 4,
        small_cases: 2,
        facts: 8,
        degrees: vec![1, 2],
        remarks: ["case 3", "case 4"].map(str::to_owned).to_vec(),
    };
    assert_eq!(verdict, Verdict::Proved { scope: Scope::Instance, reach: expected });
}

#[test]
fn an_undecided_case_hides_no_refutation_and_is_not_hidden_by_a_proof() {
    assert_eq!(judged(&[Stuck, Holds, Fails]), Ok(Verdict::Refuted(witness(2))));
    assert_eq!(judged(&[Holds, Fails, Stuck]), Ok(Verdict::Refuted(witness(1))));
    for acts in [&[Holds, Stuck, Holds, Stuck][..], &[Nothing, Stuck, Nothing], &[Nothing, Stuck]] {
        assert_eq!(judged(acts), Ok(Verdict::Undecided("limit 1".into())), "the first limit that was hit");
    }
}

#[test]
fn a_fault_is_an_error_and_no_verdict() {
    for acts in [&[Holds, Breaks][..], &[Stuck, Breaks, Holds], &[Nothing, Breaks, Fails]] {
        assert_eq!(judged(acts), Err(Fault("1 is not 1".into())));
    }
    let message = Fault("1 is not 1".into()).to_string();
    assert!(message.contains("bug") && message.contains("1 is not 1"), "{message}");
    let cases = [Number::of_degree(1, 0), Number::of_degree(2, 1)];
    assert!(judge_by_degree(&statement(&[Holds, Breaks]), &cases).is_err());
}

#[test]
fn a_case_that_does_not_meet_the_hypotheses_is_not_looked_at() {
    let seen = Arc::new(AtomicUsize::new(0));
    let count = Arc::clone(&seen);
    let statement = Statement::new("", move |case: &Number, ledger: &mut Ledger| {
        count.fetch_add(1, Ordering::Relaxed);
        act(if case.n.is_multiple_of(2) && case.n <= 6 { Holds } else { Fails }, case.n, ledger)
    })
    .given([Hypothesis::Even])
    .given([Hypothesis::AtMost(6)]);
    let cases: Vec<_> = (0..100).map(Number::small).collect();
    let verdict = judge(&statement, &cases).expect("no fault");
    assert!(matches!(&verdict, Verdict::Proved { reach, .. } if reach.small_cases == 4), "{verdict:?}");
    assert_eq!(seen.load(Ordering::Relaxed), 4);

    assert_eq!(statement.unmet(&cases[4]), None);
    assert_eq!(statement.unmet(&cases[8]), Some(&Hypothesis::AtMost(6)));
    assert_eq!(statement.unmet(&cases[9]), Some(&Hypothesis::Even), "the first of several");
    let verdict = judge(&statement, &cases[7..]).expect("no fault");
    assert!(matches!(&verdict, Verdict::NotApplicable(why) if why.contains("n is even")), "{verdict:?}");
}

/// Of 0, …, 9 the amended hypotheses exclude the odd ones; of these 1 and 3 fail, 5 holds, 7 is undecided, and
/// in 9 there is nothing to check.
#[test]
fn sharpness_counts_the_excluded_cases_and_those_that_fail() {
    let acts = [Holds, Fails, Holds, Fails, Holds, Holds, Holds, Stuck, Holds, Nothing];
    let cases: Vec<_> = (0..acts.len()).map(Number::small).collect();
    let amended = || statement(&acts).given([Hypothesis::Even]);
    let found = |excluded, failing| Ok(Some(Sharpness { excluded, failing }));
    assert_eq!(sharpness(&statement(&acts), &amended(), &cases), found(4, 2));
    // What the printed hypotheses exclude does not count.
    let printed = statement(&acts).given([Hypothesis::AtMost(2)]);
    assert_eq!(sharpness(&printed, &amended(), &cases), found(1, 1));
    // An amendment that excludes no case is not a hypothesis on the case.
    assert_eq!(sharpness(&statement(&acts), &statement(&acts), &cases), Ok(None));
    assert_eq!(sharpness(&statement(&acts), &amended(), &cases[..1]), Ok(None));
    assert!(sharpness(&statement(&[Holds, Breaks]), &amended(), &cases[..2]).is_err());
}

#[test]
fn each_degree_is_judged_by_itself() {
    let acts = [Holds, Fails, Holds, Nothing, Stuck, Fails, Holds];
    let degrees = [3, 1, 3, 4, 2, 1, 2];
    let mut cases: Vec<_> = degrees.iter().enumerate().map(|(n, k)| Number::of_degree(*k, n)).collect();
    // A case without a degree belongs to none.
    cases.push(Number::small(1));
    for threads in [1, 4] {
        let judged = on_threads(threads, || judge_by_degree(&statement(&acts), &cases));
        let (whole, found) = judged.expect("no fault");
        assert_eq!(whole, Verdict::Refuted(witness(1)), "the first of the lowest degree");
        assert_eq!(found.iter().map(|(k, _)| *k).collect::<Vec<_>>(), [1, 2, 3, 4], "by rising degree");
        assert_eq!(found[0].1, Verdict::Refuted(witness(1)), "the first of its degree");
        assert_eq!(found[1].1, Verdict::Undecided("limit 4".into()));
        let proved = |verdict: &Verdict| match verdict {
            Verdict::Proved { reach, .. } => Some((reach.small_cases, reach.degrees.clone())),
            _ => None,
        };
        assert_eq!(proved(&found[2].1), Some((2, vec![3])), "a refutation in degree 1 says nothing about it");
        assert!(matches!(found[3].1, Verdict::NotApplicable(_)));
    }
    let nothing = judge_by_degree::<Number>(&statement(&acts), &[]);
    assert!(matches!(nothing, Ok((Verdict::NotApplicable(_), found)) if found.is_empty()));
}

/// Every decision is counted once, and says what is so.
#[test]
fn the_ledger_decides_and_counts() {
    let mut ledger = Ledger::default();
    let (one, two) = (integer(1), integer(2));
    // 1 − 2u + u² = (1 − u)² is 0 at u = 1, and 1 − u + u² is positive everywhere.
    let polynomial = |coefficients: [i64; 3]| {
        let [first, rest @ ..] = coefficients.map(|c| rational(c, 1));
        RationalFunction::from_polynomial(Polynomial::new(first, rest))
    };
    let decisions = [
        (ledger.equal(&one, &one), true),
        (ledger.equal(&one, &two), false),
        (ledger.differ(&one, &two), true),
        (ledger.differ(&two, &two), false),
        (ledger.less(&one, &two), true),
        (ledger.less(&two, &two), false),
        (ledger.positive(&polynomial([1, -1, 1])), true),
        (ledger.positive(&polynomial([1, -2, 1])), false),
        (ledger.count(3, 3), true),
        (ledger.count(3, 4), false),
    ];
    for (place, (found, expected)) in decisions.into_iter().enumerate() {
        assert_eq!(found, expected, "decision {place}");
    }
    assert_eq!(ledger.facts(), decisions.len());
}

#[test]
fn scopes_are_ordered_by_how_far_they_reach() {
    assert!(Scope::ALL.is_sorted() && Scope::Points < Scope::Instance);
    let names = Scope::ALL.map(Scope::name);
    assert_eq!(names, ["points", "instance", "alpha", "knots", "degree"]);
    assert_eq!(Scope::Alpha.to_string(), "alpha");
}
