//! Floor 6: each way to compute in `f64` against exact arithmetic on the same floats, at random cases and at the
//! worst that a search finds.

mod climb;
mod measure;
mod member;
mod method;
mod probe;
mod record;

use std::sync::Arc;

use num_traits::Zero;
use rayon::prelude::*;

use crate::float::FloatBasis;
use crate::scalar::BigRational;
use climb::climb;
use measure::Exact;
use probe::Source;

pub use measure::{Errors, Ulps};
pub use member::{FloatMember, FloatMemberError};
pub use method::Method;
pub use probe::Probe;
pub use record::{MethodRecord, ProbeRecord, RangeRecord, WorstRecord};

/// How much of a study is done. The result depends on nothing else.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Effort {
    /// The seed of all random numbers.
    pub seed: u64,
    /// How many random cases are measured.
    pub count: u64,
    /// How many steps the search for the worst case of each formula takes.
    pub steps: u64,
}

/// What is measured.
#[derive(Debug, Clone)]
pub enum Population {
    /// Random knots, α and x in one degree: 2k + 2 knots, x in the span in the middle. Gaps are 0 one time in eight (that of the
    /// span never) and otherwise m·2^e, with m even in [1, 2) and e in −10, …, 9; t_0 is the difference of two such
    /// numbers, and α is ∞ one time in eight and otherwise −s or 1 + s with s such a number; x is even in its span. The
    /// search may go beyond that.
    Degree(usize),
    /// A member of another family than that of an index: a span of it evenly, and x evenly in the span. The search changes
    /// only x.
    Member(Arc<FloatMember>),
    /// These bases: one of them evenly, a span of it evenly, and x evenly in the span. The search changes only x.
    Bases(Vec<FloatBasis<f64>>),
    /// These cases and nothing else.
    Cases(Vec<Probe>),
}

/// A largest value, and where.
#[derive(Debug, Clone)]
pub struct Extreme {
    /// The value.
    pub error: Ulps,
    /// The case.
    pub case: Probe,
    /// i of G_i^k.
    pub index: usize,
}

/// What one formula does wrong.
#[derive(Debug, Clone)]
pub struct Figures {
    /// Which one.
    pub formula: Method,
    /// How many cases were looked at: the random ones, and the steps of the search.
    pub tried: u64,
    /// The largest error in units in the last place that was found, over the random cases and the one that the search
    /// ended at.
    pub worst: Option<Extreme>,
    /// The same over the random cases alone: half, and 99 of 100, have at most this largest error.
    pub median: Ulps,
    /// See there.
    pub percentile_99: Ulps,
    /// The largest |float − exact| of what is finite, over the same cases as `worst`.
    pub absolute: BigRational,
    /// The largest |Σ floats − Σ exact values| where all are finite.
    pub sum: BigRational,
    /// The number of values that are not positive where they should be, or not 0 where they should be.
    pub signs: usize,
    /// The number of values that are infinite or NaN.
    pub not_finite: usize,
    /// The number of values below 2⁻⁹⁰⁰, next to underflow: they have no part in `worst`, `median` and `percentile_99`
    /// unless they are not finite.
    pub left_out: usize,
    /// How many cases were measured: those that `worst` is the largest of.
    pub measured: usize,
    /// To how many of them the proved bound does not apply ([`Method::bound_applies`]); 0 where there is none.
    pub outside: usize,
    /// The proved bound of `worst`, where there is one ([`Method::bound`]).
    pub bound: Option<f64>,
    kept: bool,
}

/// Measures the formulas. A field without cases has no figures.
#[must_use]
pub fn study(field: &Population, formulas: &[Method], effort: Effort) -> Vec<Figures> {
    let draw = |stream: u64| {
        let mut source = Source::new(effort.seed, stream);
        match field {
            Population::Degree(degree) => Some(source.case(*degree)),
            Population::Bases(bases) => source.point(bases),
            Population::Member(member) => source.point_of(member),
            Population::Cases(_) => None,
        }
    };
    let cases: Vec<Probe> = match field {
        Population::Cases(cases) => cases.clone(),
        _ => (0..effort.count.max(1)).filter_map(draw).collect(),
    };
    let measured: Vec<Vec<Errors>> = cases
        .par_iter()
        .map(|case| {
            let exact = Exact::of(case);
            formulas.iter().map(|formula| exact.errors(&formula.values(case))).collect()
        })
        .collect();
    let figures = formulas.par_iter().enumerate().filter_map(|(f, &formula)| {
        let errors: Vec<(&Probe, &Errors)> = cases.iter().zip(measured.iter().map(|of| &of[f])).collect();
        let mut figures = Figures::of(formula, &errors)?;
        let (start, _) = errors.iter().max_by(|a, b| a.1.worst().cmp(&b.1.worst()))?;
        if !matches!(field, Population::Cases(_)) && effort.steps > 0 {
            figures.tried += effort.steps;
            // Streams from the end: no case is drawn from them.
            let mut source = Source::new(effort.seed, u64::MAX - u64::try_from(f).unwrap_or(0));
            let fixed = !matches!(field, Population::Degree(_));
            let case = climb(formula, (*start).clone(), &mut source, effort.steps, fixed);
            figures.count(&case, &Errors::of(formula, &case));
        }
        Some(figures)
    });
    figures.collect()
}

impl Figures {
    /// The figures of some cases; `None` if there are none.
    fn of(formula: Method, cases: &[(&Probe, &Errors)]) -> Option<Self> {
        let first = cases.first()?.0;
        let none = || Ulps::Number(BigRational::zero());
        let largest = |errors: &Errors| errors.worst().map_or_else(none, |(error, _)| error.clone());
        let mut sorted: Vec<Ulps> = cases.iter().map(|(_, errors)| largest(errors)).collect();
        sorted.sort();
        let quantile = |per_cent: usize| sorted[(sorted.len() * per_cent).div_ceil(100) - 1].clone();
        let mut figures = Self {
            formula,
            tried: u64::try_from(cases.len()).unwrap_or(u64::MAX),
            worst: None,
            median: quantile(50),
            percentile_99: quantile(99),
            absolute: BigRational::zero(),
            sum: BigRational::zero(),
            signs: 0,
            not_finite: 0,
            left_out: 0,
            measured: 0,
            outside: 0,
            // Of other families nothing is proved.
            bound: formula.bound(first.basis.degree()).filter(|_| first.member.is_none()),
            kept: true,
        };
        cases.iter().for_each(|(case, errors)| figures.count(case, errors));
        Some(figures)
    }

    /// One more case.
    fn count(&mut self, case: &Probe, errors: &Errors) {
        self.signs += errors.signs;
        self.not_finite += errors.not_finite();
        self.left_out += errors.left_out;
        self.measured += 1;
        if self.bound.is_some() {
            let applies = self.formula.bound_applies(case);
            self.outside += usize::from(!applies);
            // Out of the range of its bound a number may be as wrong as it likes. What is no number is worse than any bound.
            self.kept &= if applies {
                errors.keep(self.formula, case.basis.degree())
            } else {
                errors.not_finite() == 0
            };
        }
        if errors.absolute > self.absolute {
            self.absolute = errors.absolute.clone();
        }
        if let Some(sum) = errors.sum.as_ref().filter(|sum| **sum > self.sum) {
            self.sum = sum.clone();
        }
        let Some((error, index)) = errors.worst() else { return };
        if self.worst.as_ref().is_none_or(|worst| *error > worst.error) {
            self.worst = Some(Extreme { error: error.clone(), case: case.clone(), index });
        }
    }

    /// Is every error that was measured within what is proved, if something is? A result that is no number never is, in
    /// the range of the bound or not.
    #[must_use]
    pub fn keeps_bound(&self) -> bool {
        self.kept
    }
}
