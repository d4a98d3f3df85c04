//! `proofs/theory/Examples.v`: numbers that this program computes, as equations that Coq computes again.

use std::fmt::Write as _;

use crate::language::Paper;
use crate::meaning::{Example, examples_of};
use crate::scalar::{BigRational, rational};
use crate::spline::{Basis, Side, weight};

const HEAD: &str = "\
(* Values, weights and one-sided derivatives on instances of the paper, printed by `knotproof report --record` as this program
   computes them, and not by hand; a test holds the two together. Coq computes each from the definitions. *)
From Coq Require Import ZArith QArith.
From mathcomp Require Import all_ssreflect all_algebra.
From Bsplines Require Import Definitions Derivatives Values Terms Numbers.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.

Section Examples.
Variable R : realFieldType.
Local Notation q := (frac R).
";

/// The instances: knots far from uniform, an open vector, and one with a triple knot inside.
const INSTANCES: [&str; 3] = ["U3", "U4", "U13"];

/// `Examples.v`: on each of the instances, for every function, at knots and between them.
#[must_use]
pub fn examples_in_coq(paper: &Paper) -> String {
    let mut text = String::from(HEAD);
    for example in examples_of(&paper.examples, &paper.about.family) {
        let basis =
            example.indices().find(|index| !index.is_infinite()).and_then(|index| example.basis(index));
        if let Some(basis) = basis.filter(|_| INSTANCES.contains(&&*example.name)) {
            instance(&mut text, &example, &basis);
        }
    }
    text + "End Examples.\n"
}

/// A fraction in Coq: `4#9`.
fn fraction(value: &BigRational) -> String {
    format!("{}#{}", value.numer(), value.denom())
}

/// The equations of one instance.
fn instance(text: &mut String, example: &Example, basis: &Basis) {
    let (knots, k, ratio) = (basis.knots(), basis.degree(), basis.index().ratio());
    let (m, name) = (knots.m(), format!("{}_{}", example.name, example.degree));
    let listed: Vec<_> = knots.knots().iter().map(fraction).collect();
    // Writing to a string cannot fail.
    let _ = writeln!(
        text,
        "\n(* {}, k = {k}, α = {} *)\nDefinition {name} := nth ({})%Q [:: {}]%Q.\nLocal Notation t_{name} := (fun i => q ({name} i)).",
        example.name,
        basis.index(),
        fraction(knots.last()),
        listed.join("; ")
    );
    let r = format!("(q ({}))", fraction(ratio));
    let mut number = 0;
    let mut equation = |what: &str, rest: String, x: &BigRational, value: &BigRational| {
        number += 1;
        let _ = writeln!(
            text,
            "Example {name}_{number} : {what} {r} t_{name} {rest} (q ({})) = q ({}). Proof. computed {}E. Qed.",
            fraction(x),
            fraction(value),
            if what == "wt" { "wtq".to_owned() } else { format!("{what}q") }
        );
    };
    for span in knots.spans() {
        let Ok((a, b)) = knots.ends(span) else { continue };
        let x = a + (b - a) * rational(1, 3);
        // At its first knot from the right, inside, and at its last knot from the left.
        for (x, side) in [(a, Side::Right), (&x, Side::Right), (b, Side::Left)] {
            let (value, slope) = match side {
                Side::Right => ("value", "DGright"),
                Side::Left => ("Gleft", "DGleft"),
            };
            for (i, jet) in basis.jets(x, side, 1).iter().enumerate() {
                let place = format!("{m} {k} {i}");
                equation(value, place.clone(), x, &jet.coefficients()[0]);
                equation(slope, place, x, &jet.coefficients()[1]);
            }
        }
        for i in 0..=m - k {
            let (from, to) = (knots.t(i), knots.t(i + k));
            let inside = from <= &x && &x < to;
            let (rise, _) = weight(ratio, &x, from, to);
            equation("wt", format!("{k} {i}"), &x, &if inside { rise } else { rational(0, 1) });
        }
    }
}
