//! From a judged claim to its certificates.

use thiserror::Error;

use crate::claims::{Claim, Form as ClaimForm, Judged, Verdict, Witness};

use super::proof::{SectionProof, to_sexp};
use super::prove::{ProofError, prove};
use super::sexp::Sexp;
use super::statement::{Form, Statement};
use super::windows::{Windows, WindowsError, windows};

/// A statement with its proof.
#[derive(Debug, Clone, PartialEq)]
pub struct Certificate {
    /// What is proved.
    pub statement: Statement,
    /// Why.
    pub proof: Vec<SectionProof>,
}

/// Why a claim that is stated formally has no certificate: the engine, the prover and the checker do not agree, or the
/// formal statement makes no sense. A bug of this program.
#[derive(Debug, Clone, PartialEq, Error)]
#[error("{claim} ({form}): {error}")]
pub struct CertificateError {
    /// The claim.
    pub claim: String,
    /// Which of its statements.
    pub form: Form,
    /// What went wrong.
    pub error: Uncertified,
}

/// What can go wrong on the way to a certificate.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum Uncertified {
    /// The windows of the claim.
    #[error(transparent)]
    Windows(#[from] WindowsError),
    /// The statement or the search for its proof.
    #[error(transparent)]
    Proof(#[from] ProofError),
    /// The checker does not accept the proof.
    #[error("the checker rejects the proof: {0}")]
    Rejected(String),
}

impl Certificate {
    fn of(statement: Statement) -> Result<Self, CertificateError> {
        match prove(&statement) {
            Ok(proof) => Ok(Self { statement, proof }),
            Err(error) => Err(failed(&statement.claim, statement.form, error)),
        }
    }

    /// The name of its two files, without their extension: `T3.5.3.amended`.
    #[must_use]
    pub fn name(&self) -> String {
        format!("{}.{}", self.statement.claim, self.statement.form.name())
    }

    /// The text of the statement.
    #[must_use]
    pub fn statement_text(&self) -> String {
        self.statement.to_sexp().pretty()
    }

    /// The text of the proof.
    #[must_use]
    pub fn proof_text(&self) -> String {
        to_sexp(&self.proof).pretty()
    }

    /// Has the independent checker read both texts.
    ///
    /// # Errors
    /// [`CertificateError`], if it rejects them.
    pub fn check(&self) -> Result<knotproof_checker::Checked, CertificateError> {
        knotproof_checker::check(&self.statement_text(), &self.proof_text()).map_err(|rejected| {
            let Statement { claim, form, .. } = &self.statement;
            failed(claim, *form, Uncertified::Rejected(rejected.to_string()))
        })
    }
}

fn failed(claim: &str, form: Form, error: impl Into<Uncertified>) -> CertificateError {
    CertificateError { claim: claim.to_owned(), form, error: error.into() }
}

/// The formal statement of a claim: that it is true, or, with a witness, that it is false. `None` if it is not stated
/// formally.
///
/// # Errors
/// [`CertificateError`], if the windows are no text of the language, or are about another witness.
pub fn statement(
    claim: &Claim,
    form: Form,
    witness: Option<&Witness>,
) -> Result<Option<Statement>, CertificateError> {
    let found = windows(claim.id, form, witness).map_err(|error| failed(claim.id, form, error))?;
    let stated = |Windows { claim: id, scope, degrees, because, sections, refutes, .. }| {
        let sections = Sexp::parse_all(&sections)
            .map_err(|error| failed(&id, form, ProofError::Statement(error.into())))?;
        let (text, refuted) = (in_words(claim, form), refutes.is_some());
        Ok(Statement { claim: id, form, refuted, scope, degrees, text, because, sections })
    };
    found.cloned().map(stated).transpose()
}

/// The statement in words, with everything that has to be known to read it.
fn in_words(claim: &Claim, form: Form) -> String {
    let assuming = |form: &ClaimForm| match form.hypotheses() {
        hypotheses if hypotheses.is_empty() => String::new(),
        hypotheses => format!(" Assuming: {}.", hypotheses.join("; ")),
    };
    let printed = &claim.printed;
    match (form, &claim.amended) {
        (Form::Amended, Some(amended)) => {
            format!("Printed: {} Amended: {}{}", printed.text(), amended.text(), assuming(amended))
        }
        _ => format!("{}{}", printed.text(), assuming(printed)),
    }
}

/// Proves all formal statements about a claim that was judged: what is true of it, and what is false, by the witness that
/// was found.
///
/// # Errors
/// [`CertificateError`]: the first statement that resists.
pub fn certify(claim: &Claim, judged: &Judged) -> Result<Vec<Certificate>, CertificateError> {
    let mut verdicts = vec![(Form::Printed, &judged.printed)];
    verdicts.extend(judged.amended.iter().map(|verdict| (Form::Amended, verdict)));
    verdicts.extend(judged.by_degree.iter().map(|(degree, verdict)| (Form::Degree(*degree), verdict)));
    let mut certificates = Vec::new();
    for (form, verdict) in verdicts {
        let witness = match (verdict, form) {
            (Verdict::Refuted(witness), _) => Some(&**witness),
            // What no finite number of cases decides may have a proof all the same.
            (Verdict::Proved { .. }, _) | (Verdict::Undecided(_), Form::Degree(_)) => None,
            _ => continue,
        };
        if let Some(statement) = statement(claim, form, witness)? {
            certificates.push(Certificate::of(statement)?);
        }
    }
    Ok(certificates)
}

/// The certificate of a claim for one degree: for a weight, which has no degree, the whole of it. `None` if there is no
/// formal statement for that degree.
///
/// # Errors
/// [`CertificateError`], if the statement resists.
pub fn certify_for_degree(
    claim: &Claim,
    form: Form,
    k: usize,
) -> Result<Option<Certificate>, CertificateError> {
    let of_degree = form == Form::Printed && claim.is_settled_by_degree();
    let form = if of_degree { Form::Degree(k) } else { form };
    let Some(mut statement) = statement(claim, form, None)? else { return Ok(None) };
    if matches!(claim.printed, ClaimForm::Basis(_)) {
        statement.degrees.retain(|degree| *degree == k);
    }
    if statement.degrees.is_empty() {
        return Ok(None);
    }
    Certificate::of(statement).map(Some)
}
