//! From a judged claim to its certificates.

use crate::claims::{Claim, Formal, Judged, Verdict, formal, formal_for_degree, refutation};

use thiserror::Error;

use super::proof::{SectionProof, to_sexp};
use super::prove::{ProofError, prove};
use super::sexp::Sexp;
use super::statement::{Form, Statement, StatementError};

/// A statement with its proof.
#[derive(Debug, Clone, PartialEq)]
pub struct Certificate {
    /// What is proved.
    pub statement: Statement,
    /// Why.
    pub proof: Vec<SectionProof>,
}

/// Why a claim has no certificate although it is stated formally: the engine and the prover do not agree, or a
/// formal statement makes no sense. A bug of this program.
#[derive(Debug, Clone, PartialEq, Error)]
#[error("{claim}, {form}: {error}")]
pub struct CertificateError {
    /// The claim.
    pub claim: String,
    /// Which of its statements.
    pub form: Form,
    /// What went wrong.
    pub error: ProofError,
}

impl Certificate {
    /// The name of its two files, without their extension: `T3.5.3.amended`.
    #[must_use]
    pub fn name(&self) -> String {
        let Statement { claim, form, .. } = &self.statement;
        match form {
            Form::Printed | Form::Amended => format!("{claim}.{form}"),
            Form::Degree(k) => format!("{claim}.degree-{k}"),
        }
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
}

/// The formal statements of a claim that was judged: what is true of it as far as that is stated, and what is false,
/// by the witness that was found.
///
/// # Errors
/// [`StatementError`], if a statement is no text of the language: a bug of this program.
pub fn statements(claim: &Claim, judged: &Judged) -> Result<Vec<Statement>, StatementError> {
    let mut all = Vec::new();
    let printed = claim.printed.text();
    let mut add = |form: Form, text: &str, verdict: &Verdict| -> Result<(), StatementError> {
        let (formal, refuted) = match (verdict, form) {
            (Verdict::Refuted(witness), _) => (refutation(claim.id, witness), true),
            // What no finite number of cases decides may have a proof all the same.
            (Verdict::Proved { .. } | Verdict::Undecided(_), Form::Degree(k)) => {
                (formal_for_degree(claim.id, k), false)
            }
            (Verdict::Proved { .. }, form) => (formal(claim.id, form == Form::Amended), false),
            _ => (None, false),
        };
        if let Some(Formal { scope, degrees, because, sections }) = formal {
            let (claim, text) = (claim.id.to_owned(), text.to_owned());
            let sections = Sexp::parse_all(&sections)?;
            all.push(Statement { claim, form, refuted, scope, degrees, text, because, sections });
        }
        Ok(())
    };
    add(Form::Printed, printed, &judged.printed)?;
    if let (Some(amended), Some(verdict)) = (&claim.amended, &judged.amended) {
        add(Form::Amended, amended.text(), verdict)?;
    }
    for (degree, verdict) in &judged.by_degree {
        add(Form::Degree(*degree), printed, verdict)?;
    }
    Ok(all)
}

/// Proves all formal statements of a claim.
///
/// # Errors
/// [`CertificateError`]: the first statement that resists.
pub fn certify(claim: &Claim, judged: &Judged) -> Result<Vec<Certificate>, CertificateError> {
    let failed = |form, error| CertificateError { claim: claim.id.to_owned(), form, error };
    let statements = statements(claim, judged).map_err(|error| failed(Form::Printed, error.into()))?;
    let certificate = |statement: Statement| match prove(&statement) {
        Ok(proof) => Ok(Certificate { statement, proof }),
        Err(error) => Err(failed(statement.form, error)),
    };
    statements.into_iter().map(certificate).collect()
}
