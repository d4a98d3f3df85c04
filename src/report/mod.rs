//! Floor 7: all claims judged, as data, as Markdown and against recorded verdicts; curves as files.

mod baseline;
mod conjecture;
mod corners;
mod dependence;
mod errata;
pub mod figures;
mod heat;
mod markdown;
mod nurbs;
mod opening;
mod page;
mod paper;
mod picture;
mod record;
mod summary;
mod theory;
mod vectors;

use std::collections::{BTreeMap, HashMap, HashSet};
use std::ops::RangeInclusive;

use rayon::prelude::*;
use schemars::JsonSchema;
use serde::{Serialize, Serializer};

use crate::certificate::Certificate;
use crate::float::FloatBasis;
use crate::judge::Cases;
use crate::language::{About, Claim, Paper};
use crate::meaning::examples_of;
use crate::settle::{Outcome, Proving, SettleError, settle_all};
use crate::spline::Basis;
use crate::study::{Effort, Method, MethodRecord, Population, study};

pub use baseline::{Baseline, BaselineError, Difference, Entry};
pub use conjecture::conjecture_page;
pub use corners::{Corner, Turn, corners};
pub use dependence::{Dependence, Dependency, State};
pub use errata::{Amendment, Errata, Erratum, ErratumWitness, errata_page};
pub use figures::PictureError;
pub use heat::heat_map;
pub use markdown::{markdown, verdicts_page};
pub use nurbs::{NurbsFile, NurbsFileError, nurbs_file};
pub use opening::opening;
pub use page::{PageError, PageSource, page};
pub use picture::dependence_picture;
pub use record::{DegreeFinding, Finding, Grounds, Record, Stated, THEORY, TheoremRecord, by_severity};
pub use summary::{Counts, Refutations, Summary};
pub use theory::{examples_in_coq, stanzas_in_coq, theory_tables, with_theory_tables};
pub use vectors::{OneSided, VectorCase, VectorPoint, vectors};

/// All that one run found: the data of `report.json`.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct Report<'a> {
    /// What is judged.
    #[serde(rename = "paper", serialize_with = "about")]
    #[schemars(with = "About")]
    pub of: &'a Paper,
    /// How many statements there are, and what became of them.
    pub summary: Summary,
    /// What rests on what, and whether a theorem falls.
    pub dependence: Dependence,
    /// One record a claim, in the order of the paper.
    pub claims: Vec<Record>,
    /// How far the curves of the paper are from smooth at their knots.
    pub corners: Vec<Corner>,
    /// `f64` against exact, on every instance of the paper; nothing where that was not studied.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub float: Vec<Drift>,
    /// The certificates that the checker has accepted, by their names.
    #[serde(skip)]
    pub certificates: BTreeMap<String, Certified>,
}

/// A certificate that the checker has accepted.
#[derive(Debug, Clone)]
pub struct Certified {
    /// The statement with its proof.
    pub certificate: Certificate,
    /// Its goals and lemmas.
    pub steps: usize,
}

fn about<S: Serializer>(paper: &&Paper, serializer: S) -> Result<S::Ok, S::Error> {
    paper.about.serialize(serializer)
}

/// How far `f64` is from exact on one instance and index, its numbers rounded to `f64` and then taken as exact.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct Drift {
    /// The instance.
    pub instance: String,
    /// k.
    pub degree: usize,
    /// α.
    pub alpha: String,
    /// The paper's formula and what is proved best, with its bound.
    pub formulas: Vec<MethodRecord>,
}

/// The random points of each instance, and the steps of the search for its worst one.
const EFFORT: Effort = Effort { seed: 0, count: 60, steps: 200 };

impl<'a> Report<'a> {
    /// Settles claims of a paper; `progress` hears how many are done, and the name of the one that begins. Only in these `degrees`,
    /// if some are given: then nothing is proved beyond the cases, as certificates are about others, too.
    ///
    /// # Errors
    /// [`SettleError`], if two computations of the same thing disagree: then there is no report.
    pub fn of(
        paper: &'a Paper,
        claims: &[Claim<'a>],
        degrees: Option<&RangeInclusive<usize>>,
        progress: impl Fn(usize, &str) + Sync,
    ) -> Result<Self, SettleError> {
        let cases = Cases::of_paper(paper)?;
        let (cases, proving) = match degrees {
            Some(degrees) => (cases.in_degrees(degrees), Proving::Nothing),
            None => (cases, Proving::Everything),
        };
        let settled = settle_all(claims, &cases, proving, progress)?;
        let all = settled.iter().flat_map(|(_, outcome)| outcome.all());
        let certified = all.filter_map(|one| {
            let (checked, certificate) = (one.checked.as_ref()?, one.certificate.clone()?);
            Some((certificate.name(), Certified { certificate, steps: checked.goals + checked.lemmas }))
        });
        let certificates = certified.collect();
        let record = |(claim, outcome): &(Claim<'_>, Outcome)| Record::new(*claim, outcome);
        Ok(Self { certificates, ..Self::on(paper, settled.iter().map(record).collect()) })
    }

    /// With `f64` against exact, on every instance.
    #[must_use]
    pub fn with_float(self) -> Self {
        Self { float: drifts(self.of), ..self }
    }

    /// The report on verdicts that were recorded: nothing is judged.
    #[must_use]
    pub fn recorded(paper: &'a Paper, claims: &[Claim<'_>], verdicts: &Baseline) -> Self {
        let entry = |claim: Claim<'_>| verdicts.claims.iter().find(|entry| entry.id == claim.id());
        Self::on(paper, claims.iter().filter_map(|claim| Some(entry(*claim)?.record(*claim))).collect())
    }

    fn on(paper: &'a Paper, claims: Vec<Record>) -> Self {
        Self {
            of: paper,
            summary: Summary::of(&claims),
            dependence: Dependence::of(paper, &claims),
            claims,
            corners: corners(paper),
            float: Vec::new(),
            certificates: BTreeMap::new(),
        }
    }
}

/// One drift for each instance and index; a basis that occurs twice is run once.
fn drifts(paper: &Paper) -> Vec<Drift> {
    let mut runs = Vec::new();
    for example in examples_of(&paper.examples, &paper.about.family) {
        for index in example.indices() {
            if let Some(basis) = example.basis(index) {
                runs.push((example.name.to_string(), basis));
            }
        }
    }
    let distinct: HashSet<&Basis> = runs.iter().map(|(_, basis)| basis).collect();
    let measured: HashMap<_, _> = distinct.into_par_iter().map(|basis| (basis, errors(basis))).collect();
    let drift = |(instance, basis): &(String, Basis)| {
        let formulas = measured.get(basis)?.clone();
        let (instance, alpha) = (instance.clone(), basis.index().to_string());
        Some(Drift { instance, degree: basis.degree(), alpha, formulas })
    };
    runs.iter().filter_map(drift).collect()
}

/// The paper's formula and ours on one basis. The paper's numbers are bases in `f64` as well.
fn errors(basis: &Basis) -> Vec<MethodRecord> {
    let bases = FloatBasis::nearest(basis).into_iter().collect();
    study(&Population::Bases(bases), &SHOWN, EFFORT).iter().map(MethodRecord::from).collect()
}

/// What the report shows.
const SHOWN: [Method; 2] = [Method::Paper, Method::Accurate];
