//! Floor 4: basis functions written as formulas, for people, for LaTeX, and for other systems to compute with; and whether what
//! somebody wrote is one of them.

mod equality;
mod expression;
mod latex;
mod maxima;
mod script;
mod sympy;
mod text;
mod tree;

use crate::analysis::{FormalBasis, FormalFunction, Whose};

pub use equality::Counterexample;
pub use expression::expression;
pub use script::{Definition, Script, ScriptError};

/// Who is to read a formula.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Language {
    /// People: a table, with `*` and `^` so that every system reads its entries.
    Text,
    /// LaTeX with the package amsmath: one displayed equation a function.
    Latex,
    /// Maxima: one definition `G_i(x) := …`, or `G_i(x, alpha) := …`, a function.
    Maxima,
    /// Python with SymPy: a program that defines each function as `Piecewise`.
    Sympy,
}

/// How polynomials are written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Form {
    /// As products: numerators with all powers of x − t_a and t_b − x that divide them split off.
    Factored,
    /// As sums of terms.
    Expanded,
}

/// The functions of a basis, or the one with the given index, in the given language: lines that end with a newline.
///
/// ```
/// use knotproof::analysis::FormalBasis;
/// use knotproof::formula::{Form, Language, formula};
/// use knotproof::scalar::integer;
/// use knotproof::spline::{Basis, KnotVector};
///
/// let basis = Basis::new(KnotVector::bernstein(1, &integer(0), &integer(1))?, 1, "-1".parse()?)?;
/// let formal = FormalBasis::of(&basis).expect("a low degree");
/// let maxima = formula(&formal, Some(1), Language::Maxima, Form::Factored);
/// assert!(maxima.contains("G_1(x) :=\n  if 0 <= x and x <= 1 then x/(2 - x)\n  else 0$"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[must_use]
pub fn formula(formal: &FormalBasis, index: Option<usize>, language: Language, form: Form) -> String {
    let chosen = |function: &&FormalFunction| index.is_none_or(|i| i == function.index);
    let functions: Vec<_> = formal.functions().iter().filter(chosen).collect();
    match language {
        Language::Text => text::document(formal, &functions, form),
        Language::Latex => latex::document(formal, &functions, form),
        Language::Maxima => maxima::document(formal, &functions, form),
        Language::Sympy => sympy::document(formal, &functions, form),
    }
}

/// What a reader of any language has to know, line by line.
fn remarks(formal: &FormalBasis) -> Vec<String> {
    let basis = formal.basis();
    let whose = match basis.weights() {
        Whose::Index(index) => format!("alpha = {index}"),
        Whose::EveryIndex => "alpha a symbol".to_owned(),
        Whose::Member(member) => format!("family {member}"),
    };
    let mut lines = vec![
        format!("Knots {}, degree {}, {whose}.", basis.knots(), basis.degree()),
        format!(
            "Outside of its pieces a function is 0. At x = {}, the last knot, it has its limit from the left.",
            { basis.knots().last() }
        ),
    ];
    if formal.is_symbolic() {
        lines
            .push("For every alpha < 0 and every alpha > 1; alpha = inf has formulas of its own.".to_owned());
    }
    lines
}
