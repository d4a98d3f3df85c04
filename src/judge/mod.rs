//! Floor 5: a sentence on instances in order of size. The first failure is the smallest witness; a sentence that fails nowhere
//! and holds somewhere is proved at scope `instance` on those, every decision being about every x.

mod cases;
mod instantiated;
mod verdict;
mod witness;

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

use rayon::prelude::*;

use crate::analysis::decimals_around;
use crate::language::{Sentence, text};
use crate::meaning::{Decided, Found, Instance, Names, Reading, decide};
use crate::scalar::{BigRational, decimal};

pub use cases::{Case, Cases, simplest_member};
pub use verdict::{Origin, Reach, Scope, Supremum, Verdict};
pub use witness::{Bind, Bound, Count, Flanked, Looked, OfFamily, Shows, Term, Tied, Witness};

/// A bug of this program, found by computing the same thing in two ways. No verdict is given.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("two computations disagree, so this program has a bug: {0}")]
pub struct Fault(pub String);

/// What a sentence comes to on one case.
enum Outcome {
    /// It is true, by so many decisions, with suprema that were compared.
    Holds(usize, Vec<Supremum>),
    /// It says nothing there.
    Nothing,
    /// It is false.
    Refuted(Box<Witness>),
    /// A limit was hit.
    Undecided(String),
}

fn decided(sentence: &Sentence, names: Names<'_>, case: &Case) -> Result<Decided, Fault> {
    let decided = decide(sentence, &case.on, names);
    match case.on.fault() {
        Some(fault) => Err(Fault(fault.to_owned())),
        None => Ok(decided),
    }
}

fn outcome(sentence: &Sentence, names: Names<'_>, case: &Case, decided: Decided) -> Result<Outcome, Fault> {
    Ok(match decided {
        Decided { failure: Some(failure), .. } => {
            Outcome::Refuted(Box::new(Witness::of(sentence, names, &case.on, failure)?))
        }
        Decided { unknown: Some(why), .. } => Outcome::Undecided(why),
        Decided { facts: 0, .. } => Outcome::Nothing,
        // What was tried is not proved.
        Decided { tried: true, facts, .. } => {
            Outcome::Undecided(format!("no counterexample among {facts} tries of numbers or control values"))
        }
        Decided { facts, found, .. } => Outcome::Holds(facts, suprema(found, names, &case.on)),
    })
}

/// Of each term the greatest supremum that it was on an instance with a name.
fn suprema(found: Vec<Found>, names: Names<'_>, on: &Instance) -> Vec<Supremum> {
    /// As many digits as a reader can look at.
    const DIGITS: usize = 6;
    let Some((instance, k)) = on.name.as_ref().zip(on.degree()) else { return Vec::new() };
    // By the digits that are told: many are equal, and irrational.
    let mut greatest: Vec<(Found, [BigRational; 2])> = Vec::new();
    for mut next in found {
        let (lo, hi) = decimals_around(&mut next.value, DIGITS);
        match greatest.iter_mut().find(|(known, _)| known.term == next.term) {
            Some(known) if known.1[0] < lo => *known = (next, [lo, hi]),
            Some(_) => {}
            None => greatest.push((next, [lo, hi])),
        }
    }
    let told = |(Found { term, integers, .. }, ends): (Found, [BigRational; 2])| {
        let mut reading = Reading::new(on, names);
        reading.bound.integers = integers;
        let term = text(&instantiated::real(&mut reading, &term));
        let [lo, hi] = ends.map(|end| decimal(&end, DIGITS));
        Supremum { instance: instance.to_string(), k, alpha: on.weights.to_string(), term, lo, hi }
    };
    greatest.into_iter().map(told).collect()
}

/// Judges a sentence on cases that are sorted by size: see the head of this module.
///
/// # Errors
/// [`Fault`], if two computations disagree.
pub fn judge(sentence: &Sentence, names: Names<'_>, cases: &[Arc<Case>]) -> Result<Verdict, Fault> {
    let cases: Vec<_> = cases.iter().collect();
    Ok(summarise(&outcomes(sentence, names, &cases)?, &cases))
}

/// The same, and also for the cases of each degree by themselves, by rising degree.
///
/// # Errors
/// [`Fault`], if two computations disagree.
pub fn judge_by_degree(
    sentence: &Sentence,
    names: Names<'_>,
    cases: &[Arc<Case>],
) -> Result<(Verdict, Vec<(usize, Verdict)>), Fault> {
    let mut by_degree: BTreeMap<Option<usize>, Vec<&Arc<Case>>> = BTreeMap::new();
    for case in cases {
        by_degree.entry(case.on.degree()).or_default().push(case);
    }
    let (mut decided, mut of, mut verdicts) = (Vec::new(), Vec::new(), Vec::new());
    for (degree, cases) in by_degree {
        let outcomes = outcomes(sentence, names, &cases)?;
        verdicts.extend(degree.map(|degree| (degree, summarise(&outcomes, &cases))));
        decided.extend(outcomes);
        of.extend(cases);
    }
    Ok((summarise(&decided, &of), verdicts))
}

/// Decides the cases in parallel and in order; once a refutation is found, larger cases are passed over. Only the first one
/// gets a witness, which costs more than the decision.
fn outcomes(sentence: &Sentence, names: Names<'_>, cases: &[&Arc<Case>]) -> Result<Vec<Outcome>, Fault> {
    let first = AtomicUsize::new(usize::MAX);
    let decide = |(place, case): (usize, &&Arc<Case>)| {
        if place > first.load(Ordering::Relaxed) {
            return Ok((place, Ok(Outcome::Nothing)));
        }
        let decided = decided(sentence, names, case)?;
        if decided.failure.is_some() {
            first.fetch_min(place, Ordering::Relaxed);
            return Ok((place, Err(decided)));
        }
        Ok((place, Ok(outcome(sentence, names, case, decided)?)))
    };
    // Halves of a list would begin in its middle, with large cases.
    let all = cases.iter().enumerate().par_bridge().map(decide);
    let mut all = all.collect::<Result<Vec<_>, Fault>>()?;
    all.sort_unstable_by_key(|(place, _)| *place);
    let first = first.into_inner();
    let each = all.into_iter().map(|(place, decided)| match decided {
        Ok(outcome) => Ok(outcome),
        Err(decided) if place == first => outcome(sentence, names, cases[place], decided),
        Err(_) => Ok(Outcome::Nothing),
    });
    each.collect()
}

/// From the outcomes, in the order of the cases, to a verdict.
fn summarise(outcomes: &[Outcome], cases: &[&Arc<Case>]) -> Verdict {
    let (mut reach, mut degrees, mut undecided) = (Reach::default(), BTreeSet::new(), None);
    for (outcome, case) in outcomes.iter().zip(cases) {
        match outcome {
            Outcome::Refuted(witness) => return Verdict::Refuted(witness.clone()),
            Outcome::Undecided(limit) => _ = undecided.get_or_insert(limit),
            Outcome::Nothing => {}
            Outcome::Holds(facts, found) => {
                reach.facts += facts;
                reach.found.extend_from_slice(found);
                match case.origin {
                    Origin::Small => reach.small_cases += 1,
                    Origin::Paper | Origin::User => reach.instances += 1,
                }
                degrees.extend(case.on.degree());
            }
        }
    }
    reach.degrees = degrees.into_iter().collect();
    match undecided {
        Some(limit) => Verdict::Undecided(limit.clone()),
        None if reach.facts > 0 => Verdict::Proved { scope: Scope::Instance, reach },
        None => Verdict::NotApplicable("the hypotheses hold in no case, or there is nothing to check".into()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::language::Form;
    use crate::language::{one_line, paper};

    fn judged(text: &str) -> Verdict {
        let sentence = one_line(text).unwrap_or_else(|complaint| panic!("{text}: {complaint:?}"));
        let cases = Cases::new([]).up_to(1);
        judge(&sentence, Names::empty(), &cases.of(&sentence, None)).unwrap()
    }

    fn given(text: &str) -> String {
        let Verdict::Refuted(witness) = judged(text) else { panic!("{text} is {:?}", judged(text)) };
        let given: Vec<_> =
            witness.given().into_iter().map(|(name, value)| format!("{name} = {value}")).collect();
        given.join(", ")
    }

    #[test]
    fn true_sentences_are_proved_for_every_x() {
        for text in [
            "k; U; i in 0..n; x in (t[i], t[i+k+1]) : G[i](x) > 0",
            "k; U; j in k..n; x in [t[j], t[j+1]) : sum(i in 0..n: G[i](x)) = sum(i in j-k..j: G[i](x)) = 1",
            "k; U symmetric; i in 0..n; x in [t[0], t[m]] | mult(x) = 0 or x = t[0] or x = t[m] : G[i](t[0]+t[m]-x) = G[n-i](x; alpha = 1-alpha)",
            "a; b; x : 0 <= phi(x, a, b) < 1",
            "k; U; s; x in [t[0], t[m]] : s*(s - x)*sum(i in 0..n: G[i](x)) = sum(i in 0..n: s^2*G[i](x)) - s*x*sum(i in 0..n: G[i](x))",
            "a; b; x in [a, b] | a < b : abs(f(x, a, b) - (x-a)/(b-a)) <= abs(r - 1)",
            "a; b; x in (a, b) | a < b : abs(phi(x, a, b) - phi(x, a, b; alpha = infinity)) <= abs(sqrt(r) - 1)/(sqrt(r) + 1)",
            "a; b | a < b; alpha != infinity : one(x in (a, b): abs(phi(x, a, b) - phi(x, a, b; alpha = infinity)) = abs(sqrt(r) - 1)/(sqrt(r) + 1))",
            "k; U open; d points; x in [t[0], t[m]] : sum(i in 0..n: d[i]*G[i](x)) = sum(i in 0..n: d[n-i]*G[n-i](x))",
            "k = 1; U clamped : G'[0](t[0]) = -r/(t[2]-t[0])",
            "k; U; i in 0..n : G[i](t[0]-) = G[i](t[m]+) = G'[i](t[m]+) = w[0,1](t[m]+) = 0",
        ] {
            assert!(matches!(judged(text), Verdict::Proved { .. }), "{text} is {:?}", judged(text));
        }
    }

    #[test]
    fn false_sentences_have_the_smallest_witness() {
        for (text, witness) in [
            (
                "k; U; j in 0..m-1; x in [t[j], t[j+1]) : sum(i in 0..n: G[i](x)) = sum(i in j-k..j: G[i](x)) = 1",
                "k = 1, U = (0, 0, 1, 2), α = -1, j = 2, x = 3/2",
            ),
            (
                "k; U; i in 0..n; x | not x in (t[i], t[i+k+1]) : G[i](x) = 0",
                "k = 1, U = (0, 0, 1, 1), α = -1, i = 0, x = 0",
            ),
            (
                "k; U symmetric; i in 0..n; x in [t[0], t[m]] : G[i](t[0]+t[m]-x) = G[n-i](x; alpha = 1-alpha)",
                "k = 1, U = (0, 0, 1, 1, 2, 2), α = -1, i = 1, x = 1",
            ),
            (
                "k; U; i in 0..n | continuous(G[i]) : maxima(G[i]) = 1",
                "k = 1, U = (0, 0, 0, 1, 1), α = -1, i = 0",
            ),
            // False at √2/2 only.
            ("k; U; x in (0, 1) : 2*x^2 != 1", ""),
            ("k; U open; d points; x in [t[0], t[m]] : sum(i in 0..n: d[i]*G[i](x)) >= 0", ""),
        ] {
            let found = given(text);
            assert!(found == witness || witness.is_empty(), "{text}: {found}");
        }
    }

    /// `k = 1, U = …: the claim says …, but …`, and the command.
    #[test]
    fn witnesses_say_what_is_so() {
        for (text, says, command) in [
            (
                "k; U; j in 0..m-1; x in [t[j], t[j+1]) : sum(i in 0..n: G[i](x)) = 1",
                "k = 1, U = (0, 0, 1, 2), α = -1, j = 2, x = 3/2: the claim says Σ_{i=0}^1 G_i^1(3/2) = 1, but Σ_{i=0}^1 G_i^1(3/2) = 2/3",
                "knotproof eval --degree 1 --knots 0,0,1,2 --alpha -1 --x 3/2",
            ),
            (
                "k; U; i in 0..n : G'[i](t[m]-) >= 0",
                "k = 1, U = (0, 0, 1, 1), α = -1, i = 0: the claim says …",
                "knotproof eval --degree 1 --knots 0,0,1,1 --alpha -1 --x 1 --derivatives 1 --side left",
            ),
            (
                "k; U : all(i in 0..n: maxima(G[i]) = 1)",
                "k = 1, U = (0, 0, 0, 1, 1), α = -1, i = 0: the claim says …",
                "knotproof shape --degree 1 --knots 0,0,0,1,1 --alpha -1 --index 0",
            ),
        ] {
            let Verdict::Refuted(witness) = judged(text) else { panic!("{text}") };
            println!("{witness}");
            let told = witness.to_string();
            assert!(says.ends_with('…') || told == says, "{told}");
            assert_eq!(witness.again("X", Form::Printed, paper()), command);
            let json = serde_json::to_string(&witness).unwrap();
            assert_eq!(serde_json::from_str::<Witness>(&json).unwrap(), *witness, "{json}");
        }
    }

    #[test]
    fn what_does_not_exist_refutes_if_no_value_does() {
        let Verdict::Refuted(witness) = judged("k; U; i in 0..n : t[i+k+2] >= t[i]") else {
            panic!("t[m+1]")
        };
        assert!(matches!(witness.shows, Shows::Undefined(_)));
        let vacuous = judged("k; U; i in 0..n | k > 5 : G[i](t[0]) = 2");
        assert!(matches!(vacuous, Verdict::NotApplicable(_)), "{vacuous:?}");
    }

    #[test]
    fn what_is_only_tried_proves_nothing() {
        for text in [
            "k; U open; d points; x in [t[0], t[m]] | mult(t[0]) = k+1; mult(t[m]) = k+1 : sum(i in 0..n: d[i]*G[i](x)) <= max(i in 0..n: d[i])",
            "a; b; s > 0; c; x : phi(s*x+c, s*a+c, s*b+c) = phi(x, a, b)",
            // False, but not for the numbers that are tried.
            "k = 1; U; s > 0 : s <= 100",
            "a; b : b <= 100",
        ] {
            assert!(matches!(judged(text), Verdict::Undecided(_)), "{text} is {:?}", judged(text));
        }
    }

    #[test]
    fn suprema_of_named_instances_are_told() {
        let sentence = one_line(
            "U in {E}; i in 0..n : sup(abs(G[i](x) - G[i](x; alpha = infinity)), x in [t[0], t[m]]) < 1/5",
        );
        let knots = crate::spline::KnotVector::new([0, 0, 1, 1, 2].map(crate::scalar::integer).to_vec());
        let basis = crate::spline::Basis::new(knots.unwrap(), 1, "-1".parse().unwrap()).unwrap();
        let sentence = sentence.unwrap();
        let cases = Cases::new([Instance::of(basis).named("E", None)]);
        let Ok(Verdict::Proved { reach, .. }) = judge(&sentence, Names::empty(), &cases.of(&sentence, None))
        else {
            panic!("3 − 2√2 < 1/5");
        };
        let [found] = reach.found.as_slice() else { panic!("one for all i: {:?}", reach.found) };
        assert_eq!((found.lo.as_str(), found.hi.as_str(), found.k), ("0.171572", "0.171573", 1));
        assert!(found.term.contains("G_0"), "{found:?}");
    }
}
