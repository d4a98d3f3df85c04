//! Floor 7: all claims judged, as data, as Markdown and against recorded verdicts; basis functions as formulas.

mod baseline;
mod conjecture;
mod corners;
mod dependence;
mod errata;
pub mod figures;
mod formula;
mod heat;
mod markdown;
mod opening;
mod page;
mod paper;
mod picture;
mod record;
mod summary;

use std::collections::{BTreeMap, HashMap, HashSet};

use rayon::prelude::*;
use schemars::JsonSchema;
use serde::Serialize;

use crate::float::{Effort, FloatBasis, Method, MethodRecord, Population, study};
use crate::language::{About, Claim, paper as read};
use crate::meaning::examples;
use crate::settle::{SettleError, settle_all};
use crate::spline::Basis;

pub use baseline::{Baseline, BaselineError, Difference, Entry};
pub use conjecture::conjecture_page;
pub use corners::{Corner, Turn, corners};
pub use dependence::{Dependence, Dependency, State};
pub use errata::{Amendment, Errata, Erratum, ErratumWitness, errata_page};
pub use figures::PictureError;
pub use formula::{Counterexample, Definition, Form, Language, Script, ScriptError, expression, formula};
pub use heat::heat_map;
pub use markdown::{markdown, verdicts_page};
pub use opening::opening;
pub use page::{PageError, PageSource, page};
pub use picture::dependence_picture;
pub use record::{DegreeFinding, Finding, Grounds, Record, Stated, by_severity};
pub use summary::{Counts, Refutations, Summary};

/// All that one run found: the data of `report.json`.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct Report {
    /// `knotproof.report/1`.
    #[schemars(extend("const" = "knotproof.report/1"))]
    pub schema: &'static str,
    /// What is judged.
    pub paper: &'static About,
    /// How many statements there are, and what became of them.
    pub summary: Summary,
    /// What rests on what, and whether a theorem falls.
    pub dependence: Dependence,
    /// One record a claim, in the order of the paper.
    pub claims: Vec<Record>,
    /// How far the curves of the paper are from smooth at their knots.
    pub corners: Vec<Corner>,
    /// `f64` against exact, on every instance of the paper.
    pub float: Vec<Drift>,
    /// Goals and lemmas of every certificate that the checker has accepted, by its name.
    #[serde(skip)]
    pub steps: BTreeMap<String, usize>,
}

/// How far `f64` is from exact on one instance and index, its numbers rounded to `f64` and then taken as exact.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct Drift {
    /// The instance.
    pub instance: &'static str,
    /// k.
    pub degree: usize,
    /// α.
    pub alpha: String,
    /// The paper's formula and what is proved best, with its bound.
    pub formulas: Vec<MethodRecord>,
}

/// The random points of each instance, and the steps of the search for its worst one.
const EFFORT: Effort = Effort { seed: 0, count: 60, steps: 200 };

impl Report {
    /// Settles the claims one after the other; `progress` hears the name of what comes next.
    ///
    /// # Errors
    /// [`SettleError`], if two computations of the same thing disagree: then there is no report.
    pub fn of(claims: &[Claim<'_>], mut progress: impl FnMut(&str)) -> Result<Self, SettleError> {
        let settled = settle_all(claims, &mut progress)?;
        let all = settled.iter().flat_map(|(_, outcome)| outcome.all());
        let steps = all.filter_map(|one| {
            let checked = one.checked.as_ref()?;
            Some((one.certificate.as_ref()?.name(), checked.goals + checked.lemmas))
        });
        let steps = steps.collect();
        progress("f64 against exact");
        let records = settled.iter().map(|(claim, outcome)| Record::new(*claim, outcome)).collect();
        Ok(Self { float: drifts(), steps, ..Self::on(records) })
    }

    /// The report on verdicts that were recorded: nothing is judged, and floats are not studied.
    #[must_use]
    pub fn recorded(claims: &[Claim<'_>], verdicts: &Baseline) -> Self {
        let entry = |claim: Claim<'_>| verdicts.claims.iter().find(|entry| entry.id == claim.id());
        Self::on(claims.iter().filter_map(|claim| Some(entry(*claim)?.record(*claim))).collect())
    }

    fn on(claims: Vec<Record>) -> Self {
        Self {
            schema: "knotproof.report/1",
            paper: &read().about,
            summary: Summary::of(&claims),
            dependence: Dependence::of(&claims),
            claims,
            corners: corners(),
            float: Vec::new(),
            steps: BTreeMap::new(),
        }
    }
}

/// One drift for each instance and index; a basis that occurs twice is run once.
fn drifts() -> Vec<Drift> {
    let mut runs = Vec::new();
    for example in examples() {
        for index in &example.indices {
            if let Some(basis) = example.basis(index) {
                runs.push((&*example.name, basis));
            }
        }
    }
    let distinct: HashSet<&Basis> = runs.iter().map(|(_, basis)| basis).collect();
    let measured: HashMap<_, _> = distinct.into_par_iter().map(|basis| (basis, errors(basis))).collect();
    let drift = |(instance, basis): &(&'static str, Basis)| {
        let formulas = measured.get(basis)?.clone();
        Some(Drift { instance, degree: basis.degree(), alpha: basis.index().to_string(), formulas })
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
