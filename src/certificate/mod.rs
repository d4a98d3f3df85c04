//! Floor 5: certificates, written (`proofs/FORMAT.md`).
//!
//! A claim's formal statement, which the paper's file of windows gives, is unrolled into sections, every goal is decided by the library's own triangle over
//! quotients of polynomials in all parameters, and the rule that shows it is written down. The checker, which shares no code
//! with this, then reads both.

mod certify;
mod derive;
mod error;
mod evaluate;
mod expansion;
mod interval;
mod point;
mod proof;
mod prove;
mod sexp;
mod statement;
mod term;
mod weights;
mod windows;

pub use certify::{
    Certificate, CertificateError, Uncertified, certify, certify_for_degree, derived, stated_form, statement,
    statement_text,
};
pub use derive::{NoWindow, derive};
pub use error::{EvaluationError, StatementError};
pub use evaluate::{Evaluator, Unfolding};
pub use proof::{Lemma, Rule, SectionProof};
pub use prove::{GoalError, ProofError, prove};
pub use sexp::{Sexp, SyntaxError};
pub use statement::{Gap, Hint, Section, Shown, Statement, Window};
pub use term::{Formula, OfWeight, Place, Term, Where};
pub use weights::{Class, Weighted};
pub use windows::{Numbers, Windows, WindowsError, window_fault, windows};
