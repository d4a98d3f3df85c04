//! Formulas for LaTeX.

use std::fmt::Write;

use crate::analysis::{FormalBasis, FormalFunction, Whose};

use super::expression::quotient;
use super::{Form, Language, remarks};

/// One displayed equation a function.
pub(super) fn document(formal: &FormalBasis, functions: &[&FormalFunction], form: Form) -> String {
    let mut text = "% For a document with \\usepackage{amsmath}.\n".to_owned();
    // Writing to a string cannot fail.
    for line in remarks(formal) {
        let _ = writeln!(text, "% {line}");
    }
    for function in functions {
        let name = name(formal, function.index);
        if function.pieces.is_empty() {
            let _ = writeln!(text, "\\[\n{name} = 0\n\\]");
            continue;
        }
        let _ = writeln!(text, "\\[\n{name} = \\begin{{cases}}");
        for piece in &function.pieces {
            let [from, to] = [&piece.from, &piece.to].map(|x| Language::Latex.number(x));
            let less = if piece.closed { "\\le" } else { "<" };
            let quotient = quotient(piece, Language::Latex, form);
            let _ = writeln!(text, "  {quotient}, & {from} \\le x {less} {to}, \\\\[1ex]");
        }
        text.push_str("  0, & \\text{otherwise.}\n\\end{cases}\n\\]\n");
    }
    text
}

/// The paper's ^αG_i^k(x); without α for another family.
fn name(formal: &FormalBasis, i: usize) -> String {
    let before = match formal.basis().weights() {
        Whose::EveryIndex => "{}^{\\alpha}".to_owned(),
        Whose::Index(index) => match index.alpha() {
            None => "{}^{\\infty}".to_owned(),
            Some(alpha) => format!("{{}}^{{{}}}", Language::Latex.number(&alpha)),
        },
        Whose::Member(_) => String::new(),
    };
    format!("{before}G_{{{i}}}^{{{}}}(x)", formal.basis().degree())
}
