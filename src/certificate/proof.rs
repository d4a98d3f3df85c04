//! Proofs: which rule shows what (`proofs/FORMAT.md`, "Proofs" and "Rules").

use crate::scalar::BigRational;

use super::sexp::Sexp;

/// Why a formula is true.
#[derive(Debug, Clone, PartialEq)]
pub enum Rule {
    /// By evaluation.
    By {
        /// Weights of this degree and above are unknowns.
        weights: Option<usize>,
        /// Functions up to this degree are unknowns.
        functions: Option<usize>,
        /// Lemmas with their factors.
        using: Vec<(usize, Sexp)>,
    },
    /// By two cases.
    Split {
        /// The parameter.
        parameter: String,
        /// Where it is split.
        at: BigRational,
        /// Below.
        below: Box<Rule>,
        /// There and above.
        above: Box<Rule>,
    },
    /// By the recursion of orders.
    Orders,
    /// By a functional that vanishes on all but one.
    Functional(Vec<(BigRational, BigRational)>),
    /// By evaluation at the pole.
    Evaluate,
}

impl Rule {
    pub(super) fn to_sexp(&self) -> Sexp {
        let number = |value: &BigRational| Sexp::Number(value.clone());
        match self {
            Self::By { weights, functions, using } => {
                let option = |name, value: &Option<usize>| value.map(|d| Sexp::form(name, [natural(d)]));
                let uses =
                    using.iter().map(|(label, factor)| Sexp::List(vec![natural(*label), factor.clone()]));
                let using = (!using.is_empty()).then(|| Sexp::form("using", uses));
                let options = [option("weights", weights), option("functions", functions), using];
                Sexp::form("by", options.into_iter().flatten())
            }
            Self::Split { parameter, at, below, above } => {
                Sexp::form("split", [Sexp::name(parameter), number(at), below.to_sexp(), above.to_sexp()])
            }
            Self::Orders => Sexp::form("orders", []),
            Self::Functional(terms) => {
                let terms = terms.iter().map(|(c, u)| Sexp::List(vec![number(c), number(u)]));
                Sexp::form("functional", terms)
            }
            Self::Evaluate => Sexp::form("evaluate", []),
        }
    }
}

/// A lemma: its formula, as text, and its rule.
#[derive(Debug, Clone, PartialEq)]
pub struct Lemma {
    /// The formula, with all integers worked out or known in the section.
    pub formula: Sexp,
    /// Its rule.
    pub rule: Rule,
}

/// The proof of one section.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct SectionProof {
    /// Lemmas, labelled 1, 2, ….
    pub lemmas: Vec<Lemma>,
    /// One rule for each goal.
    pub goals: Vec<Rule>,
}

/// The proof of a statement as an item of the language.
pub(super) fn to_sexp(sections: &[SectionProof]) -> Sexp {
    let section = |(number, proof): (usize, &SectionProof)| {
        let lemma = |(label, lemma): (usize, &Lemma)| {
            Sexp::form("lemma", [natural(label), lemma.formula.clone(), lemma.rule.to_sexp()])
        };
        let goal = |(number, rule): (usize, &Rule)| Sexp::form("goal", [natural(number), rule.to_sexp()]);
        let lemmas = (1..).zip(&proof.lemmas).map(lemma);
        let goals = (1..).zip(&proof.goals).map(goal);
        Sexp::form("section", std::iter::once(natural(number)).chain(lemmas).chain(goals))
    };
    Sexp::form("proof", std::iter::once(Sexp::int(1)).chain((1..).zip(sections).map(section)))
}

pub(super) fn natural(value: usize) -> Sexp {
    Sexp::Number(BigRational::from_integer(value.into()))
}
