//! Formulas for SymPy.

use std::fmt::Write;

use crate::analysis::{FormalBasis, FormalFunction};

use super::expression::quotient;
use super::{Form, Language, remarks};

/// A Python program that defines each function, and the list of them.
pub(super) fn document(formal: &FormalBasis, functions: &[&FormalFunction], form: Form) -> String {
    let mut text = String::new();
    // Writing to a string cannot fail.
    for line in remarks(formal) {
        let _ = writeln!(text, "# {line}");
    }
    text.push_str("from sympy import *\n\nx = Symbol(\"x\", real=True)\n");
    if formal.is_symbolic() {
        text.push_str("alpha = Symbol(\"alpha\", real=True)\n");
    }
    for function in functions {
        if function.pieces.is_empty() {
            let _ = writeln!(text, "\nG_{} = Integer(0)", function.index);
            continue;
        }
        let _ = writeln!(text, "\nG_{} = Piecewise(", function.index);
        for piece in &function.pieces {
            let [from, to] = [&piece.from, &piece.to].map(|x| Language::Sympy.number(x));
            let less = if piece.closed { "<=" } else { "<" };
            let quotient = quotient(piece, Language::Sympy, form);
            let _ = writeln!(text, "    ({quotient}, (x >= {from}) & (x {less} {to})),");
        }
        text.push_str("    (0, True),\n)\n");
    }
    let names: Vec<_> = functions.iter().map(|function| format!("{}: G_{0}", function.index)).collect();
    let _ = writeln!(text, "\nG = {{{}}}", names.join(", "));
    text
}
