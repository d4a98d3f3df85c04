//! The engine that judges sentences: what it promises, on sentences small enough to know the answer of.

#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests")]

use knotproof::judge::{Cases, Fault, Origin, Scope, Verdict, judge, judge_by_degree};
use knotproof::language::{Known, Sentence, one_line};
use knotproof::meaning::{Instance, Names, decide, examples_named};

fn sentence(text: &str) -> Sentence {
    one_line(text).unwrap_or_else(|complaint| panic!("{text}: {complaint:?}"))
}

/// On all small cases up to degree 2.
fn judged(text: &str) -> Verdict {
    let (sentence, cases) = (sentence(text), Cases::new([]).up_to(2));
    judge(&sentence, Names::empty(), &cases.of(&sentence, None)).unwrap()
}

fn on_threads<T: Send>(threads: usize, run: impl FnOnce() -> T + Send) -> T {
    rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap().install(run)
}

/// Larger cases fail as well: with several threads, one of them may fail first.
#[test]
fn the_witness_is_the_first_failing_case_on_any_number_of_threads() {
    let text = "k; U; j in 0..m-1; x in [t[j], t[j+1]) : sum(i in 0..n: G[i](x)) = 1";
    for threads in [1, 2, 8] {
        let Verdict::Refuted(witness) = on_threads(threads, || judged(text)) else { panic!("outside spans") };
        let knots = ["0", "0", "1", "2"].map(str::to_owned);
        assert_eq!(
            (witness.k, witness.knots.as_slice(), witness.alpha.as_str()),
            (Some(1), &knots[..], "-1")
        );
        assert_eq!(
            witness.given.iter().map(|bound| bound.value.to_string()).collect::<Vec<_>>(),
            ["2", "3/2"]
        );
    }
}

/// Sums of products with a factor that lives on k + 1 spans are read there alone; with 0 added to a factor, all of their terms are.
#[test]
fn a_sum_over_all_functions_is_the_sum_over_those_that_live_there() {
    for (given, factor, function) in [
        ("x in [t[0]-1, t[m]+1]", "1", "G[i](x)"),
        ("x in [t[0]-1, t[m]]", "1", "G[i](x-)"),
        ("x in [t[0], t[m]+1]", "1", "G[i](x+)"),
        ("j in 0..m-1; x in (t[j], t[j+1])", "-1", "G'[i](x)"),
        ("x in [t[0], t[m]]", "x", "G[i](x; alpha = 1-alpha)"),
        ("d points; x in [t[0], t[m]]", "d[i]", "G[i](x)"),
        ("j in 0..n; x in [t[0], t[m]]", "G[j](x)", "G[i](x)"),
        ("x in [t[0], t[m]]", "2", "G[i](t[0]+t[m]-x)"),
    ] {
        let sum = |factor: &str| format!("sum(i in 0..n: {factor}*{function})");
        let (local, whole) = (sum(factor), sum(&format!("({factor} + 0*i)")));
        let text = format!("k; U; {given} : {local} = {whole}");
        let verdict = judged(&text);
        assert!(matches!(verdict, Verdict::Proved { .. }), "{text}: {verdict:?}");
        let text = format!("k; U; {given} : {local} = 1/7 + {whole}");
        assert!(matches!(judged(&text), Verdict::Refuted(_)), "{text}");
    }
    // What has no value has none where the function that it is multiplied with is 0.
    for term in ["sum(i in 0..n+1: G[i](x))", "sum(i in -1..n: G[i](x))", "sum(i in 0..n: t[i+k+2]*G[i](x))"]
    {
        let text = format!("k; U; x in [t[0], t[m]] : {term} = {term}");
        assert!(matches!(judged(&text), Verdict::Refuted(_)), "{text}");
    }
}

/// With control values 0 but for one, only what looks at that one is read: all that is said comes out as if everything were.
#[test]
fn what_looks_at_no_other_control_value_is_what_it_was() {
    let known = Known::defining(&[
        ("C(x)", "sum(i in 0..n: d[i]*G[i](x))"),
        ("L[a,b](x)", "sum(i in a..b: d[i]*G[i](x))"),
        ("e[i]", "d[i] + d[i+1]"),
    ]);
    let known = known.unwrap();
    let sentences: [(&str, &[&str], &str); 14] = [
        ("d points; j in k..n; x in [t[j], t[j+1])", &[], "C(x) = L[j-k,j](x)"),
        // Some of the control values are needed, and missed in one span alone.
        ("d points; j in k..n; x in [t[j], t[j+1])", &[], "j < n or C(x) = L[j-k+1,j](x)"),
        ("d points; x in [t[0], t[m]]; j in 0..n", &[], "d[j]*G[j](x) <= C(x)"),
        // What is read depends on them: hypotheses, what follows from them, and in how many parts a cell is cut.
        ("d points; j in 0..n; i in 0..n", &["d[j] = 1"], "d[i] = 0 or i = j"),
        ("d points; j in 0..n; i in 0..n", &["d[j] = 0"], "d[i] = 0 or d[i] = 1"),
        ("d points; j in 0..n; i in 0..n", &["d[j] = 1"], "d[i] = 0"),
        // √2 + √3 is more than is computed with.
        ("d points; j in 0..n; i in 0..n", &["sqrt(1 + d[j]) + sqrt(3) > 0"], "d[i] >= 0"),
        (
            "j in 0..n; d points; i in 0..n; x in (t[0], t[m])",
            &[],
            "d[i]*G[i](x) <= 1/2 or d[j]*G[j](x) > 1/2",
        ),
        ("d points; i in 0..n; x in (t[0], t[m])", &[], "d[i]*G[i](x) <= 1/2 or d[i]*G[i](x) > 1/3"),
        ("d points; i in 0..n", &[], "polygon_changes(d) = 0 and d[i] >= 0"),
        ("d points; i in 0..n+1", &[], "d[i] = d[i]"),
        // What is remembered of j = 0 was looked at for j = 1 as well.
        ("d points; j in 0..1; i in 0..n-1", &[], "e[i] = 0 or j = 0"),
        // One list inside of another.
        ("d points; j in 0..n; c points; i in 0..n", &[], "d[i]*c[j] = c[j]*d[i]"),
        ("d points; j in 0..n; c points; i in 0..n", &[], "d[i]*c[j] = 0 or i <= j"),
    ];
    let names = Names { definitions: known.definitions(), library: &() };
    let cases = Cases::new([]).up_to(2);
    let mut facts = 0;
    for (given, assume, then) in sentences {
        let sentence =
            knotproof::language::sentence(&format!("k; U; {given}"), assume, &[then], &known).unwrap();
        for case in cases.of(&sentence, None).iter().step_by(31) {
            let found = decide(&sentence, &case.on, names);
            let expected = decide(&sentence, &case.on.by_definition(), names);
            assert_eq!(found, expected, "{given} : {then} on {:?}", case.on.basis);
            facts += found.facts;
        }
    }
    assert!(facts > 5_000, "{facts}");
}

#[test]
fn nothing_checked_is_nothing_proved() {
    let none = sentence("k; U : 0 = 0");
    assert!(matches!(judge(&none, Names::empty(), &[]), Ok(Verdict::NotApplicable(_))));
    for text in ["k; U; i in 0..n | k > 5 : G[i](t[0]) = 2", "k; U; i in n+1..n : 0 = 1"] {
        let verdict = judged(text);
        assert!(matches!(verdict, Verdict::NotApplicable(_)), "{text}: {verdict:?}");
        assert_eq!((verdict.status(), verdict.scope()), ("not-applicable", None));
    }
}

#[test]
fn a_proof_rests_on_the_cases_in_which_something_was_decided() {
    let named = examples_named("U0").into_iter().flat_map(|example| example.instances().collect::<Vec<_>>());
    let cases = Cases::new(named).up_to(2);
    let sentence = sentence("k; U; i in 0..n | k = 1; alpha != infinity : G[i](t[i+1]) >= 0");
    let all = cases.of(&sentence, None);
    let Ok(Verdict::Proved { scope: Scope::Instance, reach }) = judge(&sentence, Names::empty(), &all) else {
        panic!("it is true")
    };
    let meant = all.iter().filter(|case| {
        case.on.degree() == Some(1) && case.on.weights.index().is_some_and(|index| !index.is_infinite())
    });
    let (small, paper): (Vec<_>, Vec<_>) = meant.partition(|case| case.origin == Origin::Small);
    assert_eq!((reach.small_cases, reach.instances), (small.len(), paper.len()));
    assert!(!small.is_empty() && !paper.is_empty() && reach.facts >= small.len() + paper.len());
    assert_eq!(reach.degrees, [1]);
}

#[test]
fn an_undecided_case_hides_no_refutation_and_is_not_hidden_by_a_proof() {
    let tried = "sum(i in 0..n: d[i]*G[i](x)) <= max(i in 0..n: d[i])";
    let given = "k; U bernstein; d points; x in [t[0], t[m]]";
    let verdict = judged(&format!("{given} : k = 1 => {tried}"));
    assert!(matches!(&verdict, Verdict::Undecided(why) if why.contains("tries")), "{verdict:?}");
    let verdict = judged(&format!("{given} : k = 1 and {tried}"));
    assert!(matches!(&verdict, Verdict::Refuted(witness) if witness.k == Some(2)), "{verdict:?}");
}

#[test]
fn a_fault_says_that_it_is_a_bug() {
    let message = Fault("1 is not 1".into()).to_string();
    assert!(message.contains("bug") && message.contains("1 is not 1"), "{message}");
}

#[test]
fn each_degree_is_judged_by_itself() {
    let bases = ["U0", "U4"].iter().flat_map(|name| examples_named(name));
    let bases: Vec<_> = bases.flat_map(|example| example.instances().collect::<Vec<_>>()).collect();
    let degrees: std::collections::BTreeSet<_> = bases.iter().filter_map(Instance::degree).collect();
    let sentence = sentence("k; U; i in 0..n | k != 1 : G[i](t[m]) <= 1; k != 2");
    let cases = Cases::new(bases);
    let cases: Vec<_> =
        cases.of(&sentence, None).into_iter().filter(|case| case.origin == Origin::Paper).collect();
    for threads in [1, 4] {
        let (whole, found) =
            on_threads(threads, || judge_by_degree(&sentence, Names::empty(), &cases)).unwrap();
        assert!(matches!(&whole, Verdict::Refuted(witness) if witness.k == Some(2)), "{whole:?}");
        assert!(found.iter().map(|(k, _)| k).eq(&degrees), "by rising degree");
        for (k, verdict) in found {
            let expected = match k {
                1 => "not-applicable",
                2 => "refuted",
                // A refutation in degree 2 says nothing about it.
                _ => "proved",
            };
            assert_eq!(verdict.status(), expected, "{k}");
        }
    }
    let nothing = judge_by_degree(&sentence, Names::empty(), &[]);
    assert!(matches!(nothing, Ok((Verdict::NotApplicable(_), found)) if found.is_empty()));
}

#[test]
fn scopes_are_ordered_by_how_far_they_reach() {
    assert!(Scope::ALL.is_sorted() && Scope::Points < Scope::Instance);
    assert_eq!(Scope::ALL.map(Scope::name), ["points", "instance", "alpha", "knots", "degree"]);
    assert_eq!(Scope::Alpha.to_string(), "alpha");
}
