//! Floor 1: what the paper's recursion is run over.
//!
//! | scalar | structure | a run of the triangle then gives |
//! |---|---|---|
//! | [`BigRational`] | exact ordered field | the exact value at a point |
//! | `f64` | field up to rounding | the value that a CAD program would get |
//! | [`Jet`] over any scalar | algebra | one-sided derivatives of any order |
//! | [`BigInt`], [`Fixed`] | ring | numerators without a single division |
//! | [`Polynomial`] | ring | identities in weights that are polynomials |
//! | [`Multivariate`] | ring | identities over the integers in many variables, of [`Monomial`]s: ratio, gaps, weights |
//! | [`RationalFunction`] | exact field | the piece itself: a statement about every x of a span |
//! | [`Quotient`] | exact field | the same for every ratio, or all gaps, at once: denominators stay factored |

pub mod axioms;
mod ball;
mod big_integer;
mod big_rational;
mod bivariate;
mod decimal;
mod effort;
mod factors;
mod fixed;
mod float;
mod fraction;
mod gcd;
mod integer_polynomial;
mod jet;
mod limbs;
mod long;
mod modular;
mod monomial;
mod multivariate;
mod natural;
mod polynomial;
mod product;
mod quotient;
mod rational;
mod rational_function;
mod ring;
mod words;

pub(crate) use ball::BallPolynomial;
pub(crate) use bivariate::{Bilinear, Bivariate};
pub use decimal::{decimal, decimal_neighbours, settled_digits};
pub use effort::effort;
pub(crate) use effort::spend;
pub use fixed::{Fixed, Width};
pub use float::{exact_value, ulp};
pub(crate) use fraction::over_one_denominator;
pub(crate) use gcd::{gcd, lcm};
pub(crate) use integer_polynomial::IntegerPolynomial;
pub use jet::Jet;
pub(crate) use limbs::Limbs;
pub(crate) use long::{LinearDivisor, LongPolynomial};
pub(crate) use modular::{may_vanish, residue};
pub use monomial::Monomial;
pub use multivariate::Multivariate;
pub(crate) use natural::Natural;
pub use num_bigint::BigInt;
pub use num_rational::BigRational;
pub use polynomial::Polynomial;
pub use quotient::Quotient;
pub use rational::{NumberError, height, integer, parse_rational, rational, rationals_between};
pub use rational_function::RationalFunction;
pub use ring::{Additive, ExactField, Field, OrderedField, RationalAlgebra, Ring, ScaleBy};
pub(crate) use words::{OddWord, Words};
