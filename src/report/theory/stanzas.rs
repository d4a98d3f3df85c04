//! `proofs/theory/Stanzas.v`: the sentences of the claims in Coq.

use crate::language::{Claim, Form, Said, coq, source};

const STANZAS: &str = "\
(* The sentences of the claims, printed from their stanzas by `knotproof report --record`, and not by hand; a test holds the two
   together. `X_defined` says that everything exists that `X` names, where the hypotheses do not say so themselves: indices are
   in their ranges, integers below 0 do not occur, nothing is divided by 0. Bridge.v has the proofs. *)
From mathcomp Require Import all_ssreflect all_algebra.
From Bsplines Require Import Definitions Pieces Derivatives Values RationalDerivative Terms.
Import Order.TTheory GRing.Theory Num.Theory.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Local Open Scope ring_scope.

Section Stanzas.
Variable R : realFieldType.
";

/// `Stanzas.v`: every sentence about bases and weights in general, or why the theory has no terms for it.
#[must_use]
pub fn stanzas_in_coq(claims: &[Claim<'_>]) -> String {
    let mut text = String::from(STANZAS);
    for claim in claims.iter().filter(|claim| claim.is_general()) {
        for form in [Form::Printed, Form::Amended, Form::Fails] {
            let Some(Said::Sentence(sentence)) = claim.said(form) else { continue };
            // A comment ends where its text seems to.
            let said = source(sentence).replace("(*", "( *").replace("*)", "* )");
            let name = in_coq(claim.id(), form);
            let id = claim.id();
            text += &match coq(sentence, claim.definitions) {
                Ok(of) => {
                    let defined = of
                        .defined
                        .map(|defined| format!("Definition {name}_defined : Prop :=\n  {defined}.\n"));
                    let defined = defined.unwrap_or_default();
                    format!(
                        "\n(* {id} {form}: {said} *)\nDefinition {name} : Prop :=\n  {}.\n{defined}",
                        of.says
                    )
                }
                Err(error) => format!("\n(* {id} {form}: {error} *)\n"),
            };
        }
    }
    text + "End Stanzas.\n"
}

/// The name of a sentence in Coq: `T3_5_2_printed`.
fn in_coq(id: &str, form: Form) -> String {
    format!("{}_{form}", id.replace('.', "_"))
}
