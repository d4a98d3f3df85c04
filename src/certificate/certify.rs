//! From a judged claim to its certificates.

use thiserror::Error;

use crate::judge::Witness;
use crate::language::{Claim, Form};

use super::proof::{SectionProof, to_sexp};
use super::prove::{ProofError, prove};
use super::sexp::Sexp;
use super::statement::Statement;
use super::windows::{Windows, WindowsError, listed, windows};

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
    claim: Claim<'_>,
    form: Form,
    witness: Option<&Witness>,
) -> Result<Option<Statement>, CertificateError> {
    let found = windows(claim, form, witness).map_err(|error| failed(claim.id(), form, error))?;
    let stated = |Windows { claim: id, scope, degrees, because, sections, refutes, own, .. }| {
        let sections = Sexp::parse_all(&sections)
            .map_err(|error| failed(&id, form, ProofError::Statement(error.into())))?;
        let (text, refuted) = (in_words(claim, form), refutes.is_some());
        let because = match refutes.filter(|_| own) {
            Some(given) => format!("By a counterexample of its own, {}. {because}", listed(&given)),
            None => because,
        };
        Ok(Statement { claim: id, form, refuted, scope, degrees, text, because, sections })
    };
    found.map(stated).transpose()
}

/// The sentence for people, an amended one with the printed one before it.
fn in_words(claim: Claim<'_>, form: Form) -> String {
    match form {
        Form::Amended => format!("Printed: {} Amended: {}", claim.text(Form::Printed), claim.text(form)),
        _ => claim.text(form),
    }
}

/// The certificate of a sentence: that it is true, or, with a witness, that it is false. `None` if it is not stated formally.
///
/// # Errors
/// [`CertificateError`], if the statement resists.
pub fn certify(
    claim: Claim<'_>,
    form: Form,
    witness: Option<&Witness>,
) -> Result<Option<Certificate>, CertificateError> {
    statement(claim, form, witness)?.map(Certificate::of).transpose()
}

/// What is proved of a sentence in one degree: for a weight, which has no degree, the whole of it. `None` if there is no formal
/// statement for that degree.
///
/// # Errors
/// [`CertificateError`], if the statement resists.
pub fn certify_for_degree(
    claim: Claim<'_>,
    form: Form,
    degree: Option<usize>,
) -> Result<Option<Certificate>, CertificateError> {
    let form = match (form, degree) {
        (Form::Printed, Some(k)) if claim.stanza.each_degree => Form::Degree(k),
        (form, _) => form,
    };
    let Some(mut stated) = statement(claim, form, None)? else { return Ok(None) };
    if claim.is_about_knots() {
        stated.degrees.retain(|k| degree == Some(*k));
    }
    if stated.degrees.is_empty() { Ok(None) } else { Certificate::of(stated).map(Some) }
}
