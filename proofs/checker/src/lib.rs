//! An independent checker of `knotproof`'s certificates: it reads a statement and its proof, derives every function
//! from the recursion and the weights of the statement's family by itself, and accepts only what the proof proves completely.
//!
//! `../FORMAT.md` is the specification. The checker multiplies, adds and compares; it shares no code with the program
//! that writes certificates, not even the big integers.
//!
//! ```
//! let statement = r#"(statement 2 (claim "example") (form printed) (verdict proved) (scope knots) (degrees 1 3)
//!     (family "mobius" (parameter r () (> 0)) (rise (* (parameter r) (- (var x) (var a)))) (fall (- (var b) (var x))))
//!     (sentence (for (degree 1) (knots) (integer j k n) (real x)) (if (chain (t j) (<= (var x)) (< (t (+ j 1)))))
//!         (then (chain (sum i 0 n (of (G i) (at (var x)))) (= (int 1)))))
//!     (because "The goal says so, on every knot vector.")
//!     (section
//!         (window W (- 1 k) (each i (- 1 k) -1 any) some (each i 1 (- k 1) any))
//!         (goals (= (+ (each i (- 0 k) 0 (G i k (in W 0)))) 1))))"#;
//! let proof = "(proof 1 (section 1 (goal 1 (by))) (section 2 (goal 1 (by (weights 1)))))";
//! let checked = knotproof_checker::check(statement, proof)?;
//! assert_eq!((checked.degrees, checked.goals), (vec![1, 3], 2));
//! assert!(knotproof_checker::check(&statement.replace(" 1))))", " 2))))"), proof).is_err());
//! # Ok::<(), knotproof_checker::Rejected>(())
//! ```
//!
//! To be read in this order, from the ground up: `token` (text to a tree of brackets), `poly`, `fraction`, `family` (which weights), `env`
//! (names, integers, `each`), `terms` with `recursion` (what a term is worth, by the paper's definition), `section`
//! (what is declared), `rules` (what a rule shows); then how a claim becomes sections: `sentence` (what may stand
//! where), `place` (of x among the knots), `case` (what is known there) with `integers`, `value`, `function` and
//! `truth` (what the parts of a sentence are there), `obligation` (what it asks for), `derive` (places, goals), `numbers` (the same for
//! examples and weights), `point` (numbers that refute) with `words`; `driver` (every section, every goal), `error`; beside them `file`, and `work`, which is counted everywhere.
//! Terms, rules and sentences are read from the tree as they are needed. No recursion is deeper than the brackets of
//! the text, the degree of a function or the definitions that may be opened, which have limits.

#![forbid(unsafe_code)]

mod case;
mod derive;
mod driver;
mod env;
mod error;
mod family;
mod file;
mod fraction;
mod function;
mod integers;
mod numbers;
mod obligation;
mod place;
mod point;
mod poly;
mod recursion;
mod rules;
mod section;
mod sentence;
#[cfg(test)]
mod sound;
mod terms;
mod token;
mod truth;
mod value;
mod words;
mod work;

pub use driver::{Checked, WORK, check, check_each, check_within};
pub use error::{Reason, Rejected};
pub use file::read;
