(* Orders of vanishing at the first knot of a span, for P3.2. *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import ring zify.
From Bsplines Require Import Definitions.
Import Order.TTheory GRing.Theory Num.Theory.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Local Open Scope ring_scope.

(* orders: weights of size h at the knot y = t_i = .. = t_s *)
Section Orders.
Variable R : realFieldType.
Variables (w : nat -> nat -> R) (i s k : nat) (a b h : R).
Hypothesis a0 : 0 <= a. Hypothesis b0 : 0 <= b. Hypothesis h0 : 0 <= h.
Hypothesis wa : forall e j, (i <= j)%N -> (j <= s < j + e)%N -> (e <= k)%N -> a * h <= w e j.
Hypothesis wb : forall e j, (i <= j)%N -> (j <= s < j + e)%N -> (e <= k)%N -> w e j <= b * h.
Hypothesis wq : forall e j, (i <= j)%N -> (j <= s < j + e)%N -> (e <= k)%N -> a <= 1 - w e j.
Hypothesis wp : forall e j, (i <= j)%N -> (j <= s < j + e)%N -> (e <= k)%N -> 0 <= w e j <= 1.

Lemma N_ge0 d j : (d <= k)%N -> (i <= j)%N -> 0 <= N w s d j.
Proof.
elim: d j => [|d IH] j dk ij; first by rewrite /= ler0n.
rewrite NS addr_ge0 //.
  case: (boolP (j <= s <= j + d)%N) => e; last by rewrite N_supp ?mulr0.
  by have /andP[p1 p2] := @wp d.+1 j ij ltac:(lia) dk; rewrite mulr_ge0 // IH // ltnW.
case: (boolP (j.+1 <= s <= j.+1 + d)%N) => e; last by rewrite N_supp ?mulr0.
have /andP[p1 p2] := @wp d.+1 j.+1 ltac:(lia) ltac:(lia) dk.
by rewrite mulr_ge0 ?subr_ge0 // IH //; lia.
Qed.
Lemma N_lower d j : (d <= k)%N -> (i <= j)%N -> (j <= s <= j + d)%N -> a ^+ d * h ^+ (d - (s - j)) <= N w s d j.
Proof.
elim: d j => [|d IH] j dk ij hj.
  have -> : j = s by lia.
  by rewrite /= eqxx subnn !expr0 mulr1.
rewrite NS; case: (boolP (s <= j + d)%N) => e.
  apply: (@le_trans _ _ (w d.+1 j * N w s d j)); last first.
    rewrite ler_addl; case: (boolP (j.+1 <= s <= j.+1 + d)%N) => e'; last by rewrite N_supp ?mulr0.
    have /andP[p1 p2] := @wp d.+1 j.+1 ltac:(lia) ltac:(lia) dk.
    by rewrite mulr_ge0 ?subr_ge0 // N_ge0 //; lia.
  have -> : (d.+1 - (s - j) = (d - (s - j)).+1)%N by lia.
  rewrite !exprS mulrACA ler_pmul ?mulr_ge0 ?exprn_ge0 ?wa ?IH //; move: dk hj e; clear; lia.
rewrite [N w s d j]N_supp ?mulr0 ?add0r; last lia.
have -> : (d.+1 - (s - j) = d - (s - j.+1))%N by lia.
rewrite exprS -mulrA ler_pmul ?mulr_ge0 ?exprn_ge0 ?wq ?IH //; move: dk ij hj e; clear; lia.
Qed.
Lemma N_upper d j : (d <= k)%N -> (i <= j)%N -> (j <= s <= j + d)%N -> N w s d j <= (b + 1) ^+ d * h ^+ (d - (s - j)).
Proof.
have b1 : 0 <= b + 1 by rewrite addr_ge0 ?ler01.
elim: d j => [|d IH] j dk ij hj.
  have -> : j = s by lia.
  by rewrite /= eqxx subnn !expr0 mulr1.
have E (u : R) : (b + 1) ^+ d.+1 * u = b * ((b + 1) ^+ d * u) + (b + 1) ^+ d * u by rewrite exprS; ring.
rewrite NS E; apply: ler_add.
  case: (boolP (s <= j + d)%N) => e; last first.
    by rewrite N_supp ?mulr0 ?mulr_ge0 ?exprn_ge0 //; move: dk ij hj e; clear; lia.
  have -> : (d.+1 - (s - j) = (d - (s - j)).+1)%N by lia.
  have /andP[p1 _] := @wp d.+1 j ij ltac:(lia) dk.
  have -> : b * ((b + 1) ^+ d * h ^+ (d - (s - j)).+1) = (b * h) * ((b + 1) ^+ d * h ^+ (d - (s - j))) by rewrite exprS; ring.
  by rewrite ler_pmul ?N_ge0 ?wb ?IH //; move: dk ij hj e; clear; lia.
case: (boolP (j.+1 <= s)%N) => e; last by rewrite N_supp ?mulr0 ?mulr_ge0 ?exprn_ge0 //; move: dk ij hj e; clear; lia.
have -> : (d.+1 - (s - j) = d - (s - j.+1))%N by lia.
have /andP[p1 p2] := @wp d.+1 j.+1 ltac:(lia) ltac:(lia) dk.
rewrite -[X in _ <= X]mul1r ler_pmul ?subr_ge0 ?N_ge0 ?IH ?ger_addl ?oppr_le0 //; move: dk ij hj e; clear; lia.
Qed.
End Orders.
