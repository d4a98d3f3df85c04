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
//! # What to use
//!
//! How long a point takes is told as a multiple of the first row, in which all k + 1 functions of degree 3 on 28 knots take 0.6 µs on
//! the author's machine; `cargo bench --bench kernels -- ways` measures it again. What prepares anything does so for all points that
//! follow: of the same job, the first row is for many points, the others for one.
//!
//! | I want | use | takes |
//! |---|---|---|
//! | values at many points, exactly | [`Evaluator::values`](spline::Evaluator::values) | 1 |
//! | signs and sums only, not in lowest terms | [`Evaluator::at`](spline::Evaluator::at) | 0.2 |
//! | values at one point | [`Basis::values`](spline::Basis::values), which prepares an evaluator each time: the more knots, the longer | 5 |
//! | values for any weights | [`Sampler::values`](spline::Sampler::values) | 1, also where each weight has a ratio of its own; forms that are not linear 8 and more |
//! | one-sided derivatives at many points | [`Evaluator::jets`](spline::Evaluator::jets) | 14 |
//! | the same at one point | [`Basis::jets`](spline::Basis::jets) | 19 |
//! | points of a curve, many | [`Evaluator::values`](spline::Evaluator::values) and [`Curve::combine`](spline::Curve::combine) | 4 |
//! | a point of a curve, one | [`Curve::point`](spline::Curve::point) | 8 |
//! | de Boor's points as well | [`Curve::de_boor`](spline::Curve::de_boor) | 12 |
//! | a curve with its tangents | [`Curve::jets`](spline::Curve::jets) | 51 |
//! | values over any ring: floats, intervals, polynomials | [`Basis::active`](spline::Basis::active) | 8 exactly |
//! | to check all of that against D3.3, word for word | [`by_definition`](spline::by_definition) | 21 |
//! | values in `f64`, one point or many | [`FloatBasis::values`](float::FloatBasis::values), [`values_at`](float::FloatBasis::values_at) | 0.3, 0.04 |
//! | curves in `f64`, one point or many | [`FloatCurve::point`](float::FloatCurve::point), [`points_at`](float::FloatCurve::points_at) | 0.4, 0.07 |
//! | the functions for every x | [`Pieces::of`](analysis::Pieces::of), all spans | 400 |
//! | maxima and minima of one function, exactly | [`Shape::of`](analysis::Shape::of) its pieces | 120 |
//! | where a curve takes a value, its extrema and its bounding box | [`Graph`](analysis::Graph) of its pieces | |
//! | its length and integrals, between exact bounds | [`length`](analysis::length()), [`integrals`](analysis::integrals) | |
//! | the curve through points, or the same on more knots | [`Collocation`](analysis::Collocation), [`refined`](analysis::refined) | |
//! | a curve for a program that knows NURBS | [`RationalBezier::pieces`](analysis::RationalBezier::pieces), all spans | 2500 |
//! | a function written as a formula, or a formula compared with it | [`formula`] | |
//! | how wrong a formula in `f64` is | [`study`](study::study) | |
//! | a sentence judged | [`one_line`](language::one_line), [`judge`](judge::judge) | |
//! | a proof for every knot vector | [`certify`](certificate::certify) | |
//!
//! `examples/` has a program for each feature, and what `tangents.rs` there does takes ten lines.
//!
//! # Features
//!
//! Without any, the crate has numbers, splines, decisions and formulas ([`scalar`], [`spline`], [`analysis`], [`formula`]), and takes 11
//! crates. The default is `cli`: everything.
//!
//! | feature | opens | crates in all |
//! |---|---|---|
//! | `float` | [`float`] | 22 |
//! | `claims` | [`json`], [`language`], [`meaning`], [`judge`], [`typed`] | 45 |
//! | `prove`, with `claims` | [`certificate`], [`settle`] | 52 |
//! | `search`, with `claims` | [`search`] | 52 |
//! | `study`, with `claims` and `float` | [`study`] | 60 |
//! | `report`, with `prove` and `study` | [`report`] | 117 |
//! | `cli`, with `report` and `search` | [`cli`], the program | 158 |
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
//! | how smooth a curve is at its knots (ours) | [`Join`](analysis::Join) |
//! | a·c(x), one real function of a curve c (ours) | [`Graph`](analysis::Graph) |
//! | (G_i^k(x_j)), the collocation matrix (ours) | [`Collocation`](analysis::Collocation) |
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
//! 4. [`formula`]: basis functions as text, and whether what somebody wrote is one; [`meaning`]: what a formula of the claim
//!    language says on an instance.
//! 5. [`judge`]: sentences on instances in order of size, and typed witnesses; [`certificate`]: proofs of formal statements,
//!    for every knot vector or every α, which an independent checker reads; [`search`]: counterexamples to the conjecture;
//!    [`typed`]: what people type.
//! 6. [`settle`]: a claim judged, proved and checked; [`float`]: values and curves in `f64` and `f32`; [`study`]: how far they
//!    are from the exact ones.
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
#[cfg(feature = "prove")]
pub mod certificate;
#[cfg(feature = "cli")]
pub mod cli;
#[cfg(feature = "float")]
pub mod float;
pub mod formula;
#[cfg(feature = "claims")]
pub mod json;
#[cfg(feature = "claims")]
pub mod judge;
#[cfg(feature = "claims")]
pub mod language;
#[cfg(feature = "claims")]
pub mod meaning;
#[cfg(feature = "report")]
pub mod report;
pub mod scalar;
#[cfg(feature = "search")]
pub mod search;
#[cfg(feature = "prove")]
pub mod settle;
pub mod spline;
#[cfg(feature = "study")]
pub mod study;
#[cfg(feature = "claims")]
pub mod typed;
