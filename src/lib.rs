//! Exact computation with the rational B-splines of "A new class of rational B-splines" (arXiv 1805.04433),
//! and decisions about what that paper says of them.
//!
//! The basis functions G_i^k of the paper come from the Cox–de Boor recursion with a Möbius map of slope ratio r
//! in the place of the affine weight. This crate computes them over exact rational numbers: their values, their
//! one-sided derivatives of any order, and on every knot span the whole function as a quotient of two
//! polynomials. From those it decides statements for **every** x of an instance, not for samples, and says
//! `proved`, `refuted` with a witness, or `undecided`.
//!
//! ```
//! use knotproof::analysis::Pieces;
//! use knotproof::scalar::{Ring, integer, rational};
//! use knotproof::spline::{Basis, Index, KnotVector, Side};
//!
//! // Degree 2 and α = −1 on the knots (0, 0, 0, 1, 2, 3, 3, 3): the paper's instance U4.
//! let knots = KnotVector::new([0, 0, 0, 1, 2, 3, 3, 3].map(integer).to_vec())?;
//! let basis = Basis::new(knots, 2, "-1".parse::<Index>()?)?;
//!
//! // The values at x = 1/2 are exact.
//! let values = basis.values(&rational(1, 2), Side::Right);
//! assert_eq!(values, [rational(4, 9), rational(32, 63), rational(1, 21), integer(0), integer(0)]);
//!
//! // So are derivatives, from either side: G_1² has a corner at the simple knot 1.
//! let slope = |side| basis.jets(&integer(1), side, 1)[1].derivatives()[1].clone();
//! assert_eq!([slope(Side::Left), slope(Side::Right)], [rational(-10, 9), rational(-7, 9)]);
//!
//! // Each function is known on each span as a whole: here the five add up to 1 for every x.
//! for span in Pieces::of(&basis).spans() {
//!     let sum = (0..=basis.n()).map(|i| span.function(i)).reduce(|sum, g| sum.plus(&g));
//!     assert_eq!(sum, Some(span.x.one()));
//! }
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Notation
//!
//! | the paper | here |
//! |---|---|
//! | α, its conjugate 1 − α | [`Index`](spline::Index), [`Index::conjugate`](spline::Index::conjugate) |
//! | r = α/(α − 1), the slope ratio (ours) | [`Index::ratio`](spline::Index::ratio) |
//! | φ_α(x, a, b) and 1 − φ_α(x, a, b) | [`weight()`](spline::weight()) |
//! | U = (t_0, …, t_m), "node vector" | [`KnotVector`](spline::KnotVector) |
//! | t_i, m | [`KnotVector::t`](spline::KnotVector::t), [`KnotVector::m`](spline::KnotVector::m) |
//! | u_j with multiplicity p_j, stop knots | [`KnotVector::stop_knots`](spline::KnotVector::stop_knots) |
//! | \[t_j, t_{j+1}), not empty | [`Span`](spline::Span) |
//! | k, n = m − k − 1 | [`Basis::degree`](spline::Basis::degree), [`Basis::n`](spline::Basis::n) |
//! | G_i^k | [`Basis`](spline::Basis); those that live on a span: [`Active`](spline::Active) |
//! | w_i^d and 1 − w_i^d | [`Weights::pair`](spline::Weights::pair) |
//! | B_i^k | [`bernstein()`](spline::bernstein()) |
//! | G_α = Σ d_i G_i^k | [`Curve`](spline::Curve) |
//! | d_i, control points | [`Curve::points`](spline::Curve::points) |
//! | d_i^r, de Boor's points | [`Curve::de_boor`](spline::Curve::de_boor) |
//! | ω_m and b_m, weights and control points of a span's rational Bézier curve (ours) | [`RationalBezier`](analysis::RationalBezier) |
//! | τ, w_i and c_i, knots, weights and control points of a NURBS curve (ours) | [`Nurbs`](analysis::Nurbs) |
//! | D⁺, D⁻ | [`Basis::jets`](spline::Basis::jets) with a [`Side`](spline::Side) |
//! | every knot vector, every α: windows, sections, goals (ours) | [`Statement`](certificate::Statement) |
//! | u in (0, ∞), the span's own coordinate (ours) | [`positive_coordinate`](analysis::positive_coordinate) |
//!
//! # Floors
//!
//! A module uses those on its own floor and below, never one above; a test holds it to that.
//!
//! 1. [`scalar`]: what is computed with: exact rationals, `f64`, jets, polynomials, rational functions; [`json`]: how
//!    files are read.
//! 2. [`spline`]: indices, knots, the recursion, curves. It reads like sections 2 to 4 of the paper; [`language`]: formulas,
//!    sentences and claims as text and as trees.
//! 3. [`analysis`]: whole pieces, and decisions about every x.
//! 4. [`meaning`]: what a formula of the claim language says on an instance.
//! 5. [`judge`]: sentences on instances in order of size, and typed witnesses; [`certificate`]: proofs of formal statements,
//!    for every knot vector or every α, which an independent checker reads; [`search`]: counterexamples to the conjecture.
//! 6. [`settle`]: a claim judged, proved and checked; [`float`]: how far `f64` is from the exact values.
//! 7. [`report`]: what the reader gets to see.
//! 8. [`cli`]: the program `knotproof`.
//!
//! # Floats cannot prove
//!
//! The recursion is written once, for any [`Ring`](scalar::Ring) of scalars, and `f64` is among them: floor 6 asks
//! what a program in floating point would get. But what leads to a verdict asks for an
//! [`ExactField`](scalar::ExactField), which `f64` is not: no verdict can be computed with rounded numbers, not
//! even by mistake. The compiler refuses
//!
//! ```compile_fail,E0277
//! fn decide<S: knotproof::scalar::ExactField>(_: S) {}
//! decide(0.5_f64);
//! ```
//!
//! and also the pieces that decisions are made from, over floats:
//!
//! ```compile_fail,E0277
//! use knotproof::scalar::RationalFunction;
//!
//! let half = RationalFunction::constant(0.5_f64);
//! ```
//!
//! The same lines over exact numbers compile, which shows that it was the float that was refused:
//!
//! ```
//! use knotproof::scalar::{RationalFunction, rational};
//!
//! fn decide<S: knotproof::scalar::ExactField>(_: S) {}
//! decide(rational(1, 2));
//!
//! let half = RationalFunction::constant(rational(1, 2));
//! decide(half);
//! ```

#![forbid(unsafe_code)]

pub mod analysis;
pub mod certificate;
pub mod cli;
pub mod float;
pub mod json;
pub mod judge;
pub mod language;
pub mod meaning;
pub mod report;
pub mod scalar;
pub mod search;
pub mod settle;
pub mod spline;
