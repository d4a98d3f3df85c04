//! Statements as data, and the one engine that judges them.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::atomic::{AtomicUsize, Ordering};

use rayon::prelude::*;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::case::{Case, Origin};
use super::verdict::{Judgement, Ledger, Reach, Scope, Stop, Verdict};

/// What a statement concludes: a decision, complete for the case that it is given.
pub type Conclusion<C> = Box<dyn Fn(&C, &mut Ledger) -> Judgement + Send + Sync>;

/// For every case that meets the hypotheses: the conclusion.
pub struct Statement<C: Case> {
    /// The statement in words and formulas.
    pub text: &'static str,
    /// What is assumed.
    pub hypotheses: Vec<C::Hypothesis>,
    /// What follows.
    pub conclusion: Conclusion<C>,
}

impl<C: Case> Statement<C> {
    /// A statement without hypotheses.
    pub fn new(
        text: &'static str,
        conclusion: impl Fn(&C, &mut Ledger) -> Judgement + Send + Sync + 'static,
    ) -> Self {
        Self { text, hypotheses: Vec::new(), conclusion: Box::new(conclusion) }
    }

    /// The same under the hypotheses.
    #[must_use]
    pub fn given(mut self, hypotheses: impl IntoIterator<Item = C::Hypothesis>) -> Self {
        self.hypotheses.extend(hypotheses);
        self
    }

    /// The first hypothesis that the case does not meet.
    pub fn unmet(&self, case: &C) -> Option<&C::Hypothesis> {
        self.hypotheses.iter().find(|hypothesis| !case.meets(hypothesis))
    }

    /// Judges one case.
    pub(crate) fn decide(&self, case: &C) -> Outcome {
        if let Some(hypothesis) = self.unmet(case) {
            return Outcome::Nothing(format!("a hypothesis does not hold here: {hypothesis}"));
        }
        let mut ledger = Ledger::default();
        match (self.conclusion)(case, &mut ledger) {
            // A conclusion that found nothing to decide has proved nothing.
            Ok(()) if ledger.facts() == 0 => Outcome::Nothing("there is nothing to check here".into()),
            Ok(()) => Outcome::Holds(ledger),
            Err(stop) => Outcome::Stopped(stop),
        }
    }
}

/// What a statement comes to in one case.
pub(crate) enum Outcome {
    Holds(Ledger),
    Nothing(String),
    Stopped(Stop),
}

/// A bug of this program, found by computing the same thing in two ways. No verdict is given.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("two computations disagree, so this program has a bug: {0}")]
pub struct Fault(pub String);

/// Judges a statement on cases that are sorted by size.
///
/// The first case in which the conclusion fails refutes it, so that the witness is the smallest there is among
/// the cases. If it fails in none and holds in some, it is proved at scope `instance` on those: every decision
/// is about every x.
///
/// # Errors
/// [`Fault`], if two computations disagree.
pub fn judge<C: Case>(statement: &Statement<C>, cases: &[C]) -> Result<Verdict, Fault> {
    let cases: Vec<_> = cases.iter().collect();
    summarise(&outcomes(statement, &cases).into_iter().zip(cases).collect::<Vec<_>>())
}

/// The same, and also for the cases of each degree by themselves, by rising degree.
///
/// # Errors
/// [`Fault`], if two computations disagree.
pub fn judge_by_degree<'a, C: Case + 'a>(
    statement: &Statement<C>,
    cases: impl IntoIterator<Item = &'a C>,
) -> Result<(Verdict, Vec<(usize, Verdict)>), Fault> {
    let mut by_degree: BTreeMap<Option<usize>, Vec<&C>> = BTreeMap::new();
    for case in cases {
        by_degree.entry(case.degree()).or_default().push(case);
    }
    let mut decided = Vec::new();
    let mut verdicts = Vec::new();
    for (degree, cases) in by_degree {
        let outcomes: Vec<_> = outcomes(statement, &cases).into_iter().zip(cases).collect();
        if let Some(degree) = degree {
            verdicts.push((degree, summarise(&outcomes)?));
        }
        decided.extend(outcomes);
    }
    Ok((summarise(&decided)?, verdicts))
}

/// Decides the cases in parallel; once a refutation is found, larger cases are passed over.
fn outcomes<C: Case>(statement: &Statement<C>, cases: &[&C]) -> Vec<Outcome> {
    let first = AtomicUsize::new(usize::MAX);
    let decide = |(place, case): (usize, &&C)| {
        if place > first.load(Ordering::Relaxed) {
            return Outcome::Nothing("a smaller case refutes the statement".into());
        }
        let outcome = statement.decide(case);
        if matches!(outcome, Outcome::Stopped(Stop::Refuted(_))) {
            first.fetch_min(place, Ordering::Relaxed);
        }
        outcome
    };
    cases.par_iter().enumerate().map(decide).collect()
}

/// From the outcomes, in the order of the cases, to a verdict.
fn summarise<C: Case>(decided: &[(Outcome, &C)]) -> Result<Verdict, Fault> {
    let (mut reach, mut degrees) = (Reach::default(), BTreeSet::new());
    let (mut undecided, mut nothing) = (None, None);
    for (outcome, case) in decided {
        match outcome {
            Outcome::Holds(ledger) => {
                reach.facts += ledger.facts();
                match case.origin() {
                    Origin::Small => reach.small_cases += 1,
                    // Remarks are for who knows the case: of thousands of small ones nobody does.
                    Origin::Paper | Origin::User => {
                        reach.instances += case.instances();
                        reach.remarks.extend_from_slice(ledger.remarks());
                    }
                }
                degrees.extend(case.degree());
            }
            Outcome::Stopped(Stop::Refuted(witness)) => return Ok(Verdict::Refuted(witness.clone())),
            Outcome::Stopped(Stop::Fault(message)) => return Err(Fault(message.clone())),
            Outcome::Stopped(Stop::Undecided(limit)) => _ = undecided.get_or_insert(limit),
            Outcome::Nothing(reason) => _ = nothing.get_or_insert(reason),
        }
    }
    reach.degrees = degrees.into_iter().collect();
    Ok(match (undecided, nothing) {
        (Some(limit), _) => Verdict::Undecided(limit.clone()),
        (None, _) if reach.facts > 0 => Verdict::Proved { scope: Scope::Instance, reach },
        (None, Some(reason)) => Verdict::NotApplicable(reason.clone()),
        (None, None) => Verdict::NotApplicable("there are no cases".into()),
    })
}

/// How an amended statement compares with the cases that its extra hypotheses exclude.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct Sharpness {
    /// Cases that meet the printed hypotheses and not the amended ones.
    pub excluded: usize,
    /// Those of them in which the printed conclusion fails: all, if the extra hypotheses are the weakest.
    pub failing: usize,
}

/// Counts in how many of the excluded cases the printed conclusion fails; `None` if nothing is excluded, since
/// the amendment is then not a hypothesis on the case.
///
/// # Errors
/// [`Fault`], if two computations disagree.
pub fn sharpness<C: Case>(
    printed: &Statement<C>,
    amended: &Statement<C>,
    cases: &[C],
) -> Result<Option<Sharpness>, Fault> {
    let excluded = |case: &&C| printed.unmet(case).is_none() && amended.unmet(case).is_some();
    let outcomes: Vec<_> = cases.par_iter().filter(excluded).map(|case| printed.decide(case)).collect();
    let mut sharpness = Sharpness { excluded: 0, failing: 0 };
    for outcome in outcomes {
        match outcome {
            Outcome::Stopped(Stop::Fault(message)) => return Err(Fault(message)),
            Outcome::Stopped(Stop::Refuted(_)) => {
                sharpness.excluded += 1;
                sharpness.failing += 1;
            }
            Outcome::Holds(_) | Outcome::Stopped(Stop::Undecided(_)) => sharpness.excluded += 1,
            Outcome::Nothing(_) => {}
        }
    }
    Ok((sharpness.excluded > 0).then_some(sharpness))
}
