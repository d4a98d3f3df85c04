//! An independent checker of `knotproof`'s certificates: it reads a statement and its proof, derives every function
//! from the paper's definition by itself, and accepts only what the proof proves completely.
//!
//! `../FORMAT.md` is the specification. The checker multiplies, adds and compares; it shares no code with the program
//! that writes certificates, not even the big integers.
//!
//! ```
//! let statement = r#"(statement 1 (claim "example") (form printed) (verdict proved) (scope knots) (degrees 1 3)
//!     (text "The functions of degree k add up to 1 on every span.")
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
//! From the ground up, one concept a file: `number`, `token`, `integer`, `poly`, `fraction`, `syntax` (read by `fields` and `grammar`); what a section
//! declares is in `section`, what terms are worth in `terms` and `recursion`, what a proof shows in `rules`; `driver`
//! goes through a certificate. No recursion is deeper than the brackets of the text, which have a limit.

mod driver;
mod error;
mod fields;
mod fraction;
mod grammar;
mod integer;
mod number;
mod poly;
mod recursion;
mod rules;
mod section;
mod syntax;
mod terms;
mod token;

pub use driver::{Checked, canonical, check};
pub use error::{Place, Reason, Rejected, Step};
