//! Formulas for Maxima.

use std::fmt::Write;

use crate::analysis::{FormalBasis, FormalFunction};

use super::expression::quotient;
use super::{Form, Language, remarks};

/// One definition a function.
pub(super) fn document(formal: &FormalBasis, functions: &[&FormalFunction], form: Form) -> String {
    let arguments = if formal.is_symbolic() { "x, alpha" } else { "x" };
    let mut text = format!("/* {} */\n", remarks(formal).join("\n   "));
    for function in functions {
        // Writing to a string cannot fail.
        let _ = write!(text, "\nG_{}({arguments}) :=", function.index);
        for (at, piece) in function.pieces.iter().enumerate() {
            let word = if at == 0 { "if" } else { "elseif" };
            let [from, to] = [&piece.from, &piece.to].map(|x| Language::Maxima.number(x));
            let less = if piece.closed { "<=" } else { "<" };
            let quotient = quotient(piece, Language::Maxima, form);
            let _ = write!(text, "\n  {word} {from} <= x and x {less} {to} then {quotient}");
        }
        text.push_str(if function.pieces.is_empty() { " 0$\n" } else { "\n  else 0$\n" });
    }
    text
}
