//! Floor 2: text ↔ typed trees of formulas, sentences and stanzas; printing is injective.
//!
//! It knows rationals and no spline: what a formula means is said in `meaning`. The language for its users is described in
//! `docs/language.md`.

mod syntax;
mod words;

pub use syntax::{
    Adjective, Argument, Binder, Definition, Fold, Formula, Function, Gap, Int, Interval, Item, Member, Name,
    Over, Range, Real, Relation, Sentence, Side, Use,
};
pub use words::{Sort, Word};
