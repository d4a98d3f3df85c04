//! Floor 6: the one order of things: judge as printed, as amended, and what holds where that does not apply; prove; check;
//! ask which theorem for every degree says the same; say how bad a failure is. Reports and commands choose cases and how far to prove, and nothing of this order.

mod grade;
mod theory;

use std::sync::atomic::{AtomicUsize, Ordering};

use knotproof_checker::Checked;
use rayon::prelude::*;
use thiserror::Error;

use crate::certificate::{Certificate, CertificateError, certify, certify_for_degree, stated_form};
use crate::judge::{Cases, Fault, Verdict, Witness, judge, judge_by_degree};
use crate::language::{Claim, Form, Said, text};
use crate::meaning::MemberError;

pub use grade::{Grade, grade};
pub use theory::{
    Computed, Covers, Decides, DegreeRange, Disagreement, Missing, StanzaPart, Theorem, Theory, TheoryError,
};

/// How far to prove.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Proving {
    /// All that there are windows for.
    Everything,
    /// What is proved for this degree, and no refutations: those of a case of the user's own are none of the paper's.
    ForDegree(Option<usize>),
    /// Nothing.
    Nothing,
}

/// What one sentence of a claim came to.
#[derive(Debug, Clone)]
pub struct Settled {
    /// Which.
    pub form: Form,
    /// On the cases.
    pub verdict: Verdict,
    /// What proves it, or refutes it, for good; the checker has accepted it.
    pub certificate: Option<Certificate>,
    /// What the checker says of it.
    pub checked: Option<Checked>,
    /// What Coq has checked for every degree, or for some.
    pub theorems: Vec<&'static Theorem>,
}

/// What a claim came to.
#[derive(Debug, Clone)]
pub struct Outcome {
    /// As printed.
    pub printed: Settled,
    /// As amended; only where the printed sentence is refuted.
    pub amended: Option<Settled>,
    /// What holds where the amended sentence does not apply: proved, if the amendment is sharp.
    pub fails: Option<Settled>,
    /// Degree by degree, where that is asked for.
    pub by_degree: Vec<Settled>,
}

/// Two parts of this program disagree: a bug, and no verdict.
#[derive(Debug, Error)]
pub enum SettleError {
    /// Two computations of the engine.
    #[error(transparent)]
    Fault(#[from] Fault),
    /// The engine, the prover and the checker.
    #[error(transparent)]
    Certificate(#[from] CertificateError),
    /// A computation and a theorem for every degree.
    #[error(transparent)]
    Theory(#[from] Disagreement),
    /// The family of the paper.
    #[error(transparent)]
    Member(#[from] MemberError),
}

/// Settles a claim: as printed; where that is refuted, as amended and where that does not apply; degree by degree, if the
/// stanza asks for that.
///
/// # Errors
/// [`SettleError`]: there is no verdict.
pub fn settle(claim: Claim<'_>, cases: &Cases, proving: Proving) -> Result<Outcome, SettleError> {
    let (printed, by_degree) = match claim.sentence(Form::Printed) {
        Some(sentence) if claim.stanza.each_degree => {
            judge_by_degree(sentence, claim.into(), &cases.of(sentence, claim.stanza.cases.as_deref()))?
        }
        _ => (verdict(claim, Form::Printed, cases)?, Vec::new()),
    };
    let mut proofs = Proofs { claim, proving, known: Vec::new() };
    let printed = proofs.settled(Form::Printed, printed)?;
    let mut other = |form| match claim.said(form) {
        Some(_) if matches!(printed.verdict, Verdict::Refuted(_)) => {
            proofs.settled(form, verdict(claim, form, cases)?).map(Some)
        }
        _ => Ok::<_, SettleError>(None),
    };
    let (amended, fails) = (other(Form::Amended)?, other(Form::Fails)?);
    // A degree in which there is nothing to judge is left out.
    let said = by_degree.into_iter().filter(|(_, verdict)| !matches!(verdict, Verdict::NotApplicable(_)));
    let by_degree =
        said.map(|(k, verdict)| proofs.settled(Form::Degree(k), verdict)).collect::<Result<_, _>>()?;
    Ok(Outcome { printed, amended, fails, by_degree })
}

/// Settles one sentence of a claim; `None` if there is none.
///
/// # Errors
/// [`SettleError`]: there is no verdict.
pub fn settle_form(
    claim: Claim<'_>,
    form: Form,
    cases: &Cases,
    proving: Proving,
) -> Result<Option<Settled>, SettleError> {
    match claim.said(form) {
        Some(_) => {
            let mut proofs = Proofs { claim, proving, known: Vec::new() };
            proofs.settled(form, verdict(claim, form, cases)?).map(Some)
        }
        None => Ok(None),
    }
}

/// On the cases.
fn verdict(claim: Claim<'_>, form: Form, cases: &Cases) -> Result<Verdict, Fault> {
    match claim.said(form) {
        Some(Said::Words { reason, core: None, .. }) => Ok(Verdict::NotFormal(reason.clone())),
        said => match said.and_then(Said::sentence) {
            Some(sentence) => match cases.foreign(sentence) {
                Some(binder) => {
                    let what = text(binder);
                    let what = what.strip_prefix("every ").unwrap_or(&what);
                    Ok(Verdict::NotApplicable(format!("said only of {what}")))
                }
                None => judge(sentence, claim.into(), &cases.of(sentence, claim.stanza.cases.as_deref())),
            },
            None => Ok(Verdict::NotApplicable("there is nothing to judge".into())),
        },
    }
}

/// The certificates of one claim.
struct Proofs<'a> {
    claim: Claim<'a>,
    proving: Proving,
    /// What was proved and checked: of several degrees it is said once.
    known: Vec<(Certificate, Checked)>,
}

impl Proofs<'_> {
    /// A verdict with its certificate, if there is one that the checker has accepted.
    fn settled(&mut self, form: Form, verdict: Verdict) -> Result<Settled, SettleError> {
        let witness = if let Verdict::Refuted(witness) = &verdict { Some(&**witness) } else { None };
        // What no finite number of cases decides may have a proof all the same.
        let open = matches!(verdict, Verdict::Proved { .. } | Verdict::Refuted(_) | Verdict::Undecided(_));
        let certified = match self.proving {
            Proving::Everything if open => self.certified(form, witness)?,
            Proving::ForDegree(k) if open && witness.is_none() => {
                checked(certify_for_degree(self.claim, form, k)?)?
            }
            _ => None,
        };
        let (certificate, checked) = certified.unzip();
        let computed = Computed { verdict: &verdict, certificate: certificate.as_ref() };
        // Of what says nothing here a theorem says nothing either.
        let theorems = if open { self.theorems(form, computed)? } else { Vec::new() };
        Ok(Settled { form, verdict, certificate, checked, theorems })
    }

    /// The theorems about the sentence, each held against what was computed; of a case of the user's own those alone that say
    /// that it is true.
    fn theorems(&self, form: Form, computed: Computed<'_>) -> Result<Vec<&'static Theorem>, Disagreement> {
        let is_wanted = |theorem: &&Theorem| match self.proving {
            Proving::Nothing => false,
            Proving::Everything => true,
            Proving::ForDegree(k) => {
                theorem.verdict == Decides::Proved && k.is_none_or(|k| theorem.degrees.contains(k))
            }
        };
        let theorems = Theory::shipped().about(self.claim, form).into_iter().filter(is_wanted);
        theorems.map(|theorem| theorem.agrees(form, computed).map(|()| theorem)).collect()
    }

    fn certified(
        &mut self,
        form: Form,
        witness: Option<&Witness>,
    ) -> Result<Option<(Certificate, Checked)>, SettleError> {
        let stated = stated_form(self.claim, form, witness)?;
        let is_it = |(certificate, _): &&(Certificate, Checked)| {
            (Some(certificate.statement.form), certificate.statement.refuted) == (stated, witness.is_some())
        };
        if let Some(known) = self.known.iter().find(is_it) {
            return Ok(Some(known.clone()));
        }
        let certified = checked(certify(self.claim, form, witness)?)?;
        self.known.extend(certified.clone());
        Ok(certified)
    }
}

fn checked(certificate: Option<Certificate>) -> Result<Option<(Certificate, Checked)>, SettleError> {
    let Some(certificate) = certificate else { return Ok(None) };
    let checked = certificate.check()?;
    Ok(Some((certificate, checked)))
}

impl Outcome {
    /// All that was settled.
    pub fn all(&self) -> impl Iterator<Item = &Settled> {
        std::iter::once(&self.printed).chain(&self.amended).chain(&self.fails).chain(&self.by_degree)
    }
}

/// Settles claims in parallel, and each with its own work in parallel; `progress` hears how many are done, and the name of the one
/// that begins.
///
/// # Errors
/// [`SettleError`]: there is no verdict; of the first claim in their order that has none.
pub fn settle_all<'a>(
    claims: &[Claim<'a>],
    cases: &Cases,
    proving: Proving,
    progress: impl Fn(usize, &str) + Sync,
) -> Result<Vec<(Claim<'a>, Outcome)>, SettleError> {
    let done = AtomicUsize::new(0);
    let settled = claims.par_iter().map(|claim| {
        progress(done.load(Ordering::Relaxed), claim.id());
        let outcome = settle(*claim, cases, proving);
        done.fetch_add(1, Ordering::Relaxed);
        Ok((*claim, outcome?))
    });
    settled.collect::<Vec<_>>().into_iter().collect()
}
