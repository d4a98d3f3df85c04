//! What a claim says, and how it is judged.

use super::case::{BasisCase, WeightCase};
use super::cause::{Cause, Source};
use super::illustrations::Illustration;
use super::small_cases::Cases;
use super::statement::{Fault, Sharpness, Statement, judge, judge_by_degree, sharpness};
use super::verdict::{Judgement, Ledger, Verdict};

/// A statement with the kind of cases that it speaks of.
pub enum Form {
    /// About the weight on an interval.
    Weight(Statement<WeightCase>),
    /// About the basis of a knot vector, and so about all curves on it.
    Basis(Statement<BasisCase>),
    /// About examples of the paper, given with it.
    Illustration(Statement<Illustration>, Vec<Illustration>),
    /// Not a mathematical statement: what the paper says, and why nothing can be decided of it.
    Vague {
        /// The sentence.
        text: &'static str,
        /// Why it can't be judged.
        reason: &'static str,
    },
}

impl Form {
    /// A statement about examples of the paper.
    pub(super) fn illustrated(
        text: &'static str,
        examples: Vec<Illustration>,
        conclusion: impl Fn(&Illustration, &mut Ledger) -> Judgement + Send + Sync + 'static,
    ) -> Self {
        Self::Illustration(Statement::new(text, conclusion), examples)
    }

    /// The statement in words and formulas.
    #[must_use]
    pub fn text(&self) -> &'static str {
        match self {
            Self::Weight(statement) => statement.text,
            Self::Basis(statement) => statement.text,
            Self::Illustration(statement, _) => statement.text,
            Self::Vague { text, .. } => text,
        }
    }

    /// Does it speak of every knot vector or every weight, so that it can be judged on any one?
    #[must_use]
    pub fn is_general(&self) -> bool {
        matches!(self, Self::Weight(_) | Self::Basis(_))
    }

    /// The hypotheses in words.
    #[must_use]
    pub fn hypotheses(&self) -> Vec<String> {
        fn words(list: &[impl ToString]) -> Vec<String> {
            list.iter().map(ToString::to_string).collect()
        }
        match self {
            Self::Weight(statement) => words(&statement.hypotheses),
            Self::Basis(statement) => words(&statement.hypotheses),
            Self::Illustration(statement, _) => words(&statement.hypotheses),
            Self::Vague { .. } => Vec::new(),
        }
    }

    /// Judged on the cases it speaks of.
    ///
    /// # Errors
    /// [`Fault`], if two computations disagree.
    pub fn judge(&self, cases: &Cases) -> Result<Verdict, Fault> {
        match self {
            Self::Weight(statement) => judge(statement, &cases.weights),
            Self::Basis(statement) => judge(statement, &cases.bases),
            Self::Illustration(statement, examples) => judge(statement, examples),
            Self::Vague { reason, .. } => Ok(Verdict::NotFormal((*reason).to_owned())),
        }
    }

    fn sharpness(&self, amended: &Self, cases: &Cases) -> Result<Option<Sharpness>, Fault> {
        match (self, amended) {
            (Self::Weight(printed), Self::Weight(amended)) => sharpness(printed, amended, &cases.weights),
            (Self::Basis(printed), Self::Basis(amended)) => sharpness(printed, amended, &cases.bases),
            _ => Ok(None),
        }
    }
}

/// A claim of the paper, or a question that its users will ask (identifiers `X.…`).
pub struct Claim {
    /// The identifier, such as `T3.5.2`.
    pub id: &'static str,
    /// Where the paper makes it.
    pub locator: &'static str,
    /// The statement as printed.
    pub printed: Form,
    /// The strongest true statement known instead, where the printed one fails.
    pub amended: Option<Form>,
    /// Why the printed statement fails, where it does.
    pub cause: Option<Cause>,
    /// How words were made into mathematics, where the paper leaves room.
    pub note: Option<&'static str>,
    /// Larger cases, for the verdicts by degree of this claim alone.
    pub(super) more_cases: Option<fn() -> Vec<BasisCase>>,
}

impl Claim {
    /// A claim as printed.
    #[must_use]
    pub fn new(id: &'static str, locator: &'static str, printed: Form) -> Self {
        Self { id, locator, printed, amended: None, cause: None, note: None, more_cases: None }
    }

    /// With an amended statement.
    #[must_use]
    pub fn amended(mut self, form: Form) -> Self {
        self.amended = Some(form);
        self
    }

    /// With the cause of its failure.
    #[must_use]
    pub fn fails_by(mut self, cause: Cause) -> Self {
        self.cause = Some(cause);
        self
    }

    /// With a note on the reading.
    #[must_use]
    pub fn note(mut self, note: &'static str) -> Self {
        self.note = Some(note);
        self
    }

    /// Judged degree by degree, on more cases than the others.
    #[must_use]
    pub(super) fn by_degree_on(mut self, more_cases: fn() -> Vec<BasisCase>) -> Self {
        self.more_cases = Some(more_cases);
        self
    }

    /// Judges the claim as printed and, where that is refuted, as amended.
    ///
    /// # Errors
    /// [`Fault`], if two computations disagree.
    pub fn judge(&self, cases: &Cases) -> Result<Judged, Fault> {
        let (printed, by_degree) = match &self.printed {
            Form::Basis(statement) if self.is_settled_by_degree() => {
                let more = self.more_cases.map(|cases| cases()).unwrap_or_default();
                judge_by_degree(statement, cases.bases.iter().chain(&more))?
            }
            form => (form.judge(cases)?, Vec::new()),
        };
        let mut judged = Judged { printed, amended: None, sharpness: None, by_degree };
        if let (Verdict::Refuted(_), Some(amended)) = (&judged.printed, &self.amended) {
            judged.amended = Some(amended.judge(cases)?);
            judged.sharpness = self.printed.sharpness(amended, cases)?;
        }
        Ok(judged)
    }

    /// Are there verdicts for single degrees?
    #[must_use]
    pub fn is_settled_by_degree(&self) -> bool {
        self.source() == Source::Question || self.more_cases.is_some()
    }

    /// Who says it.
    #[must_use]
    pub fn source(&self) -> Source {
        if self.id.starts_with("X.") { Source::Question } else { Source::Paper }
    }
}

/// What came of judging a claim.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Judged {
    /// As printed.
    pub printed: Verdict,
    /// As amended; only where the printed statement is refuted and an amended one is given.
    pub amended: Option<Verdict>,
    /// Are the extra hypotheses of the amended statement the weakest?
    pub sharpness: Option<Sharpness>,
    /// For the questions `X.…`: the verdict for each degree.
    pub by_degree: Vec<(usize, Verdict)>,
}
