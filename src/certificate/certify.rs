//! From a judged claim to its certificates.

use std::borrow::Cow;
use std::sync::Arc;

use rayon::prelude::*;
use thiserror::Error;

use crate::judge::{Scope, Witness};
use crate::language::{Binder, Claim, Form, Sentence, canonical};

use super::derive::{NoWindow, derive};
use super::point::point;
use super::proof::{SectionProof, to_sexp};
use super::prove::{ProofError, prove};
use super::sexp::Sexp;
use super::statement::{Shown, Statement};
use super::weights::Weighted;
use super::windows::{Argued, Windows, WindowsError, listed, windows};

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
    /// No window follows from the sentence.
    #[error(transparent)]
    Underived(#[from] NoWindow),
    /// The sentence names what there is not.
    #[error("its sentence names {0}, which can't be written into a certificate")]
    Unprintable(String),
    /// The checker does not accept the proof.
    #[error("the checker rejects the proof: {0}")]
    Rejected(String),
}

impl Certificate {
    /// Proves a statement: where that can be, for any weights at all.
    ///
    /// # Errors
    /// [`CertificateError`], if no proof is found.
    pub fn of(statement: Statement) -> Result<Self, CertificateError> {
        let statement = match statement.for_any_weights() {
            // The least degree with something to show tells mostly whether that is in vain.
            Some(any) if any.least().is_none_or(|least| prove(&least).is_ok()) => match prove(&any) {
                Ok(proof) => return Ok(Self { statement: any, proof }),
                Err(_) => statement,
            },
            _ => statement,
        };
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
    stated(claim, form, witness, derived)
}

/// The text of [`statement`], without the windows that follow from it: they are no part of the text.
///
/// # Errors
/// As [`statement`].
pub fn statement_text(
    claim: Claim<'_>,
    form: Form,
    witness: Option<&Witness>,
) -> Result<Option<Sexp>, CertificateError> {
    Ok(stated(claim, form, witness, said)?.map(|statement| statement.to_sexp()))
}

fn stated(
    claim: Claim<'_>,
    mut form: Form,
    witness: Option<&Witness>,
    proved: impl Fn(Claim<'_>, Form, &Sentence, &[usize]) -> Result<Statement, CertificateError>,
) -> Result<Option<Statement>, CertificateError> {
    let id = claim.id();
    let failed = move |error: Uncertified| failed(id, form, error);
    let Some(sentence) = sentence_of(claim, form) else { return Ok(None) };
    let sentence = &*sentence;
    let found = windows(claim, form, witness).map_err(|error| failed(error.into()))?;
    let parse = |text: &str| {
        Sexp::parse_all(text).map_err(|error| failed(ProofError::Statement(error.into()).into()))
    };
    let (scope, degrees, shown) = match (found, witness) {
        (Some(Windows { form: of, scope, degrees, argued: Some(argued), refutes, own, .. }), _) => {
            let Argued { because, sections } = argued;
            let given = degrees.iter().zip(refutes.iter().flatten()).filter(|(k, _)| own.contains(k));
            let given: Vec<_> = given.map(|(_, given)| listed(given)).collect();
            let because = match given.as_slice() {
                [] => because,
                [one] => format!("By a counterexample of its own, {one}. {because}"),
                all => format!("By counterexamples of its own: {}. {because}", all.join("; ")),
            };
            form = of;
            (scope, degrees, Shown::Argued { because, sections: parse(&sections)? })
        }
        (Some(Windows { form: of, scope, degrees, points: Some(points), .. }), _) => {
            form = of;
            (scope, degrees, Shown::Points(parse(&points)?))
        }
        (Some(Windows { form: of, degrees, .. }), _) => {
            return proved(claim, of, sentence, &degrees).map(Some);
        }
        // What is about weights alone stands for degree 1.
        (None, Some(witness)) => match point(witness, &claim.paper.about.family) {
            Some(point) => (Scope::Instance, vec![witness.k.unwrap_or(1)], Shown::Points(vec![point])),
            None => return Ok(None),
        },
        (None, None) => return Ok(None),
    };
    let sentence = in_brackets(claim, form, sentence)?;
    let (weighted, family) = weights(claim, form)?;
    Ok(Some(Statement {
        claim: id.to_owned(),
        form,
        weighted,
        family,
        refuted: witness.is_some(),
        scope,
        degrees,
        sentence,
        shown,
    }))
}

/// That a sentence is true in these degrees, for all knots and every α: windows and goals follow from it.
///
/// # Errors
/// [`CertificateError`], if they don't.
pub fn derived(
    claim: Claim<'_>,
    form: Form,
    sentence: &Sentence,
    degrees: &[usize],
) -> Result<Statement, CertificateError> {
    let weighted = Weighted::Family(Arc::clone(&claim.paper.about.family));
    let sections = degrees.par_iter().map(|k| derive(sentence, claim.definitions, claim, *k, &weighted));
    let sections =
        sections.collect::<Result<_, _>>().map_err(|error: NoWindow| failed(claim.id(), form, error))?;
    Ok(Statement { shown: Shown::Derived(sections), ..said(claim, form, sentence, degrees)? })
}

/// The same, with nothing derived yet.
fn said(
    claim: Claim<'_>,
    form: Form,
    sentence: &Sentence,
    degrees: &[usize],
) -> Result<Statement, CertificateError> {
    let (weighted, family) = weights(claim, form)?;
    Ok(Statement {
        claim: claim.id().to_owned(),
        form,
        weighted,
        family,
        refuted: false,
        scope: reach(sentence),
        degrees: degrees.to_vec(),
        sentence: in_brackets(claim, form, sentence)?,
        shown: Shown::Derived(Vec::new()),
    })
}

/// The sentence of a form; where the family is for some knots only, its knots are of that kind.
fn sentence_of(claim: Claim<'_>, form: Form) -> Option<Cow<'_, Sentence>> {
    let (sentence, knots) = (claim.sentence(form)?, &claim.paper.about.family.knots);
    if knots.is_empty() {
        return Some(Cow::Borrowed(sentence));
    }
    let mut sentence = sentence.clone();
    for binder in &mut sentence.given {
        if let Binder::Knots(own) = binder {
            own.extend(
                knots.iter().filter(|adjective| !own.contains(adjective)).copied().collect::<Vec<_>>(),
            );
        }
    }
    Some(Cow::Owned(sentence))
}

/// The weights of the paper, and how a certificate says them.
fn weights(claim: Claim<'_>, form: Form) -> Result<(Weighted, Sexp), CertificateError> {
    let weighted = Weighted::Family(Arc::clone(&claim.paper.about.family));
    match weighted.to_sexp() {
        Ok(family) => Ok((weighted, family)),
        Err(what) => Err(failed(claim.id(), form, Uncertified::Unprintable(what.to_string()))),
    }
}

/// How far it reaches, if it follows from windows: these are for every α.
fn reach(sentence: &Sentence) -> Scope {
    let about_examples = sentence.given.iter().any(|binder| matches!(binder, Binder::Instances(_)));
    if about_examples { Scope::Alpha } else { Scope::Knots }
}

/// A sentence in canonical brackets, with the definitions and the other claims that it names.
fn in_brackets(claim: Claim<'_>, form: Form, sentence: &Sentence) -> Result<Vec<Sexp>, CertificateError> {
    let text = canonical(sentence, claim.definitions, &claim.paper.examples, &|id, printed| {
        let named = Claim::of(claim.paper).find(|other| other.id() == id)?;
        let form = if printed { Form::Printed } else { named.strongest() };
        Some((named.sentence(form)?, named.definitions))
    });
    let text = text.map_err(|name| failed(claim.id(), form, Uncertified::Unprintable(name.to_string())))?;
    Sexp::parse_all(&text).map_err(|error| failed(claim.id(), form, ProofError::Statement(error.into())))
}

/// Under which form the certificate of a sentence is found, that it is true, or, with a witness, that it is false; `None` where that
/// is not stated in the file of windows.
///
/// # Errors
/// [`CertificateError`], if the windows are no text of the language, or are about another witness.
pub fn stated_form(
    claim: Claim<'_>,
    form: Form,
    witness: Option<&Witness>,
) -> Result<Option<Form>, CertificateError> {
    let found = windows(claim, form, witness).map_err(|error| failed(claim.id(), form, error))?;
    Ok(found.map(|windows| windows.form))
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
    if !has_format(claim) {
        return Ok(None);
    }
    let Some(stated) = statement(claim, form, witness)? else {
        let open = witness.is_none() && claim.paper.windows.is_empty();
        return Ok(if open { unasked(claim, form) } else { None });
    };
    let is_point = matches!(stated.shown, Shown::Points(_));
    let certificate = Certificate::of(stated)?;
    // The checker has the last word on whether numbers are enough: of a sentence with a word they are not.
    Ok(Some(certificate).filter(|certificate| !is_point || certificate.check().is_ok()))
}

/// Can a certificate say the weights of the paper?
fn has_format(claim: Claim<'_>) -> bool {
    Weighted::Family(Arc::clone(&claim.paper.about.family)).to_sexp().is_ok()
}

/// A paper that says nothing of windows: what follows from the sentence in degrees up to this one is proved, where that is
/// possible.
const UNASKED: usize = 3;

/// The certificate in those degrees in which windows follow from the sentence and all goals have a proof that the checker
/// accepts.
fn unasked(claim: Claim<'_>, form: Form) -> Option<Certificate> {
    let sentence = &*sentence_of(claim, form)?;
    let proved = |degrees: &[usize]| {
        let certificate = Certificate::of(derived(claim, form, sentence, degrees).ok()?).ok()?;
        certificate.check().is_ok().then_some(certificate)
    };
    let alone = if let Form::Degree(k) = form { k..=k } else { 0..=UNASKED };
    let degrees: Vec<_> = alone.filter(|k| proved(&[*k]).is_some()).collect();
    // What holds of step functions only is no news.
    if degrees.iter().all(|k| *k == 0) { None } else { proved(&degrees) }
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
    if !has_format(claim) {
        return Ok(None);
    }
    let form = match (form, degree) {
        (Form::Printed, Some(k)) if claim.stanza.each_degree => Form::Degree(k),
        (form, _) => form,
    };
    let is_wanted = |k: &usize| !claim.is_about_knots() || degree == Some(*k);
    let in_degree = |claim: Claim<'_>, form, sentence: &Sentence, degrees: &[usize]| {
        derived(claim, form, sentence, &degrees.iter().copied().filter(is_wanted).collect::<Vec<_>>())
    };
    let Some(mut stated) = stated(claim, form, None, in_degree)? else { return Ok(None) };
    // What is argued is said of all its degrees.
    stated.degrees.retain(is_wanted);
    if stated.degrees.is_empty() { Ok(None) } else { Certificate::of(stated).map(Some) }
}
