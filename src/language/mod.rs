//! Floor 2: text ↔ typed trees of formulas, sentences and stanzas; printing is injective.
//!
//! It knows rationals and no spline: what a formula means is said in `meaning`. The language for its users is described in
//! `docs/language.md`.

mod apply;
mod canonical;
mod cause;
mod claim;
mod complaint;
mod definitions;
mod family;
mod file;
mod known;
mod paper;
mod print;
mod raw;
mod resolve;
mod rows;
mod sentence;
mod syntax;
mod token;
mod words;

pub use cause::{Cause, Severity, Source};
pub use claim::{Claim, Form, claims};
pub use complaint::Complaint;
pub use family::{Family, Parameter, classical, families, family_schema};
pub use file::{File, RestsOn, Said, Stanza, schema, stanzas};
pub use known::Known;
pub use paper::{About, Headline, Paper, PaperNumber, paper, shipped, shipped_names};
pub use print::{
    Claimed, NotInCoq, Print, Proposition, canonical, canonical_family, coq, latex, mathml, source, text,
};
pub use rows::{Row, RowPart};
pub use sentence::{one_line, sentence};
pub use syntax::{
    Adjective, Argument, Binder, Definition, Fold, Formula, Function, Gap, Int, Interval, Item, Member, Name,
    Over, Pattern, Range, Real, Relation, Sentence, Side, Use,
};
pub use words::{Sort, Word};
