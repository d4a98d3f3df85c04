//! Floor 5: all claims judged, as data, as Markdown and against recorded verdicts.

mod baseline;
mod conjecture;
pub mod figures;
mod markdown;
mod record;

use std::collections::{HashMap, HashSet};

use rayon::prelude::*;
use serde::Serialize;
use thiserror::Error;

use crate::certificate::{CertificateError, certify};
use crate::claims::{Cases, Claim, Fault, instances};
use crate::float::{Discrepancy, discrepancy};
use crate::spline::Basis;

pub use baseline::{Baseline, BaselineError, Difference, Entry};
pub use conjecture::conjecture_page;
pub use figures::PictureError;
pub use markdown::{END, START, markdown, with_verdict_table};
pub use record::{DegreeFinding, Finding, Grounds, Record, Stated};

/// All that one run found: the data of `report.json`.
#[derive(Debug, Clone, Serialize)]
pub struct Report {
    /// `knotproof.report/1`.
    pub schema: &'static str,
    /// One record a claim, in the order of the paper.
    pub claims: Vec<Record>,
    /// `f64` against exact, on every instance of the paper.
    pub float: Vec<Drift>,
}

/// How far `f64` is from exact on one instance and index.
#[derive(Debug, Clone, Serialize)]
pub struct Drift {
    /// The instance.
    pub instance: &'static str,
    /// k.
    pub degree: usize,
    /// α.
    pub alpha: String,
    /// The largest errors and where they occur.
    #[serde(flatten)]
    pub discrepancy: Discrepancy,
}

/// Why there is no report: a bug of this program.
#[derive(Debug, Error)]
pub enum ReportError {
    /// The engine found two computations that disagree.
    #[error(transparent)]
    Fault(#[from] Fault),
    /// The engine, the prover and the checker disagree.
    #[error(transparent)]
    Certificate(#[from] CertificateError),
}

impl Report {
    /// Judges the claims one after the other; `progress` hears the name of what comes next.
    ///
    /// # Errors
    /// [`ReportError`], if two computations of the same thing disagree: then there is no report.
    pub fn of(claims: &[Claim], mut progress: impl FnMut(&str)) -> Result<Self, ReportError> {
        let cases = Cases::all();
        let mut records = Vec::with_capacity(claims.len());
        for claim in claims {
            progress(claim.id);
            let judged = claim.judge(&cases)?;
            let certificates = certify(claim, &judged)?;
            certificates.par_iter().try_for_each(|certificate| certificate.check().map(drop))?;
            records.push(Record::new(claim, &judged, &certificates));
        }
        progress("f64 against exact");
        Ok(Self { schema: "knotproof.report/1", claims: records, float: drifts() })
    }
}

/// One drift for each instance and index; a basis that occurs twice is run once.
fn drifts() -> Vec<Drift> {
    let mut runs = Vec::new();
    for instance in instances() {
        for index in &instance.indices {
            if let Ok(basis) = Basis::new(instance.knots.clone(), instance.degree, index.clone()) {
                runs.push((instance.name, basis));
            }
        }
    }
    let distinct: HashSet<&Basis> = runs.iter().map(|(_, basis)| basis).collect();
    let measured: HashMap<_, _> = distinct.into_par_iter().map(|basis| (basis, discrepancy(basis))).collect();
    let drift = |(instance, basis): &(&'static str, Basis)| {
        let discrepancy = measured.get(basis)?.clone();
        Some(Drift { instance, degree: basis.degree(), alpha: basis.index().to_string(), discrepancy })
    };
    runs.iter().filter_map(drift).collect()
}
