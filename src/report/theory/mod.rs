//! What is generated in `proofs/theory`: tables of its page, and what ties its definitions to the claims and to the numbers of
//! this program.

mod examples;
mod stanzas;
mod tables;

pub use examples::examples_in_coq;
pub use stanzas::stanzas_in_coq;
pub use tables::{theory_tables, with_theory_tables};
