//! Formulas for people.

use std::fmt::Write;

use crate::analysis::{FormalBasis, FormalFunction, FormalPiece};

use super::expression::quotient;
use super::{Form, Language, remarks};

/// One block a function, one line a piece.
pub(super) fn document(formal: &FormalBasis, functions: &[&FormalFunction], form: Form) -> String {
    let mut text = remarks(formal).join("\n") + "\n";
    let domains = |function: &FormalFunction| function.pieces.iter().map(domain).collect::<Vec<_>>();
    let widest = functions.iter().flat_map(|function| domains(function)).map(|domain| domain.len()).max();
    let width = widest.unwrap_or(0);
    for function in functions {
        // Writing to a string cannot fail.
        let _ = writeln!(text, "\nG_{}", function.index);
        if function.pieces.is_empty() {
            let (from, to) = formal.basis().support(function.index);
            text.push_str("  0 for every x");
            text.push_str(if from == to { ": all its knots are the same\n" } else { "\n" });
        }
        for piece in &function.pieces {
            let quotient = quotient(piece, Language::Text, form);
            let _ = writeln!(text, "  {:width$}  {quotient}", domain(piece));
        }
    }
    text
}

fn domain(piece: &FormalPiece) -> String {
    format!("[{}, {}{}", piece.from, piece.to, if piece.closed { ']' } else { ')' })
}
