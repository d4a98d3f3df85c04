//! Trees → text, by one walk in several alphabets. No two trees are printed alike, and the source form is read back.

mod alphabet;
mod canonical;
mod coq;
mod form;
mod said;
mod term;

use super::syntax::{Binder, Definition, Formula, Function, Real, Sentence};

pub use canonical::{Claimed, canonical, canonical_family};
pub use coq::{NotInCoq, Proposition, coq};

use alphabet::{html, latex_of, line_of};
use form::Form;
use term::Walk;

/// What can be printed: sentences, binders, formulas, terms, functions, definitions.
pub trait Print {
    #[doc(hidden)]
    fn form(&self, walk: Walk) -> Form;
}

impl Print for Sentence {
    fn form(&self, walk: Walk) -> Form {
        walk.sentence(self)
    }
}

impl Print for Binder {
    fn form(&self, walk: Walk) -> Form {
        walk.binder(self)
    }
}

impl Print for Formula {
    fn form(&self, walk: Walk) -> Form {
        walk.formula(self, super::raw::level::TOP)
    }
}

impl Print for Real {
    fn form(&self, walk: Walk) -> Form {
        walk.real(self, super::raw::level::TOP)
    }
}

impl Print for Function {
    fn form(&self, walk: Walk) -> Form {
        walk.function(self, None)
    }
}

impl Print for Definition {
    fn form(&self, walk: Walk) -> Form {
        walk.definition(self)
    }
}

/// In the language itself: `k; U; i in 0..n; x in (t[i], t[i+k+1]) : G[i](x) > 0`.
#[must_use]
pub fn source(tree: &impl Print) -> String {
    line_of(&tree.form(Walk { source: true }), true)
}

/// For people, in Unicode: "For every U, every 0 ≤ i ≤ n and t_i < x < t_{i+k+1}: G_i^k(x) > 0."
#[must_use]
pub fn text(tree: &impl Print) -> String {
    line_of(&tree.form(Walk { source: false }), false)
}

/// The same in LaTeX: words, and formulas between dollars.
#[must_use]
pub fn latex(tree: &impl Print) -> String {
    latex_of(&tree.form(Walk { source: false }))
}

/// The same in HTML: words, and formulas in MathML. The first formula carries the source of the whole as an annotation.
#[must_use]
pub fn mathml(tree: &impl Print) -> String {
    html(&tree.form(Walk { source: false }), &source(tree))
}
