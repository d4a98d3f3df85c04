//! Claims on one basis, and what is reported of them.

use std::borrow::Cow;
use std::ffi::OsStr;

use knotproof::cli::{CliError, native, paper_of};
use knotproof::judge::Cases;
use knotproof::language::{Claim, File, Form, Paper, Said, Source, Stanza, classical, latex, mathml, paper};
use knotproof::meaning::Instance;
use knotproof::report::{Finding, Record, Stated};
use knotproof::scalar::BigRational;
use knotproof::settle::{Proving, settle_form};
use knotproof::typed::TypedError;
use rayon::prelude::*;
use serde::Serialize;

use crate::basis::Inner;
use crate::error::Wrong;

/// Which claims.
#[derive(Debug)]
pub(crate) struct Wanted {
    /// By their identifiers; none stands for all that there are.
    pub(crate) claims: Vec<String>,
    /// In the language of claims.
    pub(crate) sentence: Option<String>,
    /// Of this paper.
    pub(crate) paper: Option<String>,
    /// The classical properties of B-splines.
    pub(crate) classical: bool,
    /// Control points.
    pub(crate) points: Option<Vec<Vec<BigRational>>>,
}

/// Of a witness what it is about, what is so there, and the command that shows it.
type At = (Vec<(String, String)>, String, String);

/// A statement and what it came to, for Python.
#[derive(Debug, Serialize)]
pub(crate) struct Told<'a> {
    claim: &'a str,
    form: String,
    title: &'a str,
    locator: &'a str,
    statement: String,
    latex: String,
    /// Nothing for words.
    mathml: Option<String>,
    #[serde(flatten)]
    finding: &'a Finding,
    /// The status with the reach of a proof.
    words: String,
    at: Option<At>,
    severity: Option<&'static str>,
    amended: Option<Box<Told<'a>>>,
}

impl<'a> Told<'a> {
    fn of(claim: Claim<'a>, form: Form, finding: &'a Finding) -> Self {
        let sentence = claim.said(form);
        let (latex, mathml) = match sentence {
            Some(Said::Sentence(sentence)) => (latex(sentence), Some(mathml(sentence))),
            _ => (claim.text(form), None),
        };
        let at = finding
            .witness
            .as_ref()
            .map(|witness| (witness.given(), witness.found(), witness.again(claim.id(), form, claim.paper)));
        Self {
            claim: claim.id(),
            form: form.name(),
            title: &claim.stanza.title,
            locator: &claim.stanza.at,
            statement: claim.text(form),
            latex,
            mathml,
            finding,
            words: finding.words(),
            at,
            severity: None,
            amended: None,
        }
    }

    /// What a claim of a paper came to, with all its cases.
    pub(crate) fn of_record(claim: Claim<'a>, record: &'a Record) -> Self {
        let stated = |form, stated: &'a Stated| Box::new(Told::of(claim, form, &stated.finding));
        Self {
            severity: record.severity.map(knotproof::language::Severity::name),
            amended: record.amended.as_ref().map(|amended| stated(Form::Amended, amended)),
            ..Self::of(claim, Form::Printed, &record.as_printed.finding)
        }
    }

    pub(crate) fn json(&self) -> Result<String, Wrong> {
        serde_json::to_string(self).map_err(|error| Wrong::Bug(format!("internal error: {error}")))
    }
}

/// Judges on one basis, for every x: as printed and, where that is refuted, as amended.
pub(crate) fn judged(on: &Inner, wanted: Wanted) -> Result<Vec<String>, Wrong> {
    let paper = match &wanted.paper {
        Some(name) => paper_of("paper", OsStr::new(name))?,
        None => Cow::Borrowed(paper()),
    };
    native(&paper, wanted.paper.is_none(), &on.weights)?;
    let own = own(on, &wanted, &paper)?;
    let count = own.as_ref().map(|own| own.claims.len());
    let library = own.map_or_else(|| Cow::Borrowed(&*paper), |own| Cow::Owned(paper.with(own)));
    let all: Vec<_> = Claim::of(&library).take(count.unwrap_or(usize::MAX)).collect();
    let chosen = choose(all, &wanted, count.is_some())?;
    let k = on.basis.degree();
    let instance = Instance::on(on.basis.with(on.weights.clone()));
    let instance = instance.map_err(|error| TypedError::Member { argument: "family", error })?;
    let cases = Cases::only(instance.with_points(wanted.points));
    // What is proved for every knot vector, it is for the weights of an index.
    let proving = match on.weights.index() {
        Some(_) if count.is_none() => Proving::ForDegree(Some(k)),
        _ => Proving::Nothing,
    };
    let finding = |claim: Claim<'_>, form| -> Result<Option<Finding>, Wrong> {
        Ok(settle_form(claim, form, &cases, proving)?.map(|settled| Finding::of(claim, &settled)))
    };
    let told = chosen.par_iter().map(|claim| {
        let Some(printed) = finding(*claim, Form::Printed)? else {
            return Err(Wrong::Bug("internal error: a claim says nothing".to_owned()));
        };
        let amended = if printed.is_refuted() { finding(*claim, Form::Amended)? } else { None };
        let amended = amended.as_ref().map(|amended| Box::new(Told::of(*claim, Form::Amended, amended)));
        Told { amended, ..Told::of(*claim, Form::Printed, &printed) }.json()
    });
    told.collect::<Vec<_>>().into_iter().collect()
}

/// Claims that are not the paper's: a sentence, or the classical properties, which can be asked of any family.
fn own(on: &Inner, wanted: &Wanted, paper: &Paper) -> Result<Option<File>, Wrong> {
    if let Some(text) = &wanted.sentence {
        let known = match on.weights.member() {
            Some(member) => paper.known().about(member.family()),
            None => paper.known(),
        };
        let sentence = known.one_line_on_knots(text);
        let sentence = sentence
            .map_err(|complaint| CliError::Claim { argument: "sentence", complaints: vec![complaint] })?;
        let claims = vec![Stanza::own(Said::Sentence(sentence))];
        return Ok(Some(File { title: None, definitions: Vec::new(), claims }));
    }
    let is_own = wanted.classical || (wanted.paper.is_none() && on.weights.member().is_some());
    Ok(is_own.then(|| classical().clone()))
}

/// Those with the identifiers that are asked for; else all of one's own, and of a paper all that depend on the basis.
fn choose<'a>(all: Vec<Claim<'a>>, wanted: &Wanted, own: bool) -> Result<Vec<Claim<'a>>, Wrong> {
    let ids: Vec<_> = all.iter().map(Claim::id).collect();
    for name in &wanted.claims {
        match all.iter().find(|claim| claim.id() == name) {
            None => return Err(CliError::unknown_claim("claims", name, &ids).into()),
            Some(claim) if !own && !claim.is_general() => {
                return Err(
                    CliError::NotGeneral { claim: name.clone(), judges: claim.paper.judges(name) }.into()
                );
            }
            Some(_) => {}
        }
    }
    let is_wanted = |claim: &Claim<'_>| match wanted.claims.as_slice() {
        [] if own => true,
        [] => claim.source() == Source::Paper && claim.is_general() && claim.is_about_knots(),
        names => names.iter().any(|name| name == claim.id()),
    };
    Ok(all.into_iter().filter(is_wanted).collect())
}
