(* A function that rises to a knot of multiplicity k+1 and drops there has no maximum of either kind, for every degree k >= 1. *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import ring zify.
From Bsplines Require Import Definitions Weight Basis Curves Pieces Derivatives Values StatementsBasis MaximaBound.
Import Order.TTheory GRing.Theory Num.Theory.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Local Open Scope ring_scope.

Section Jump.
Variable R : realFieldType.
Variable r : R.
Hypothesis r_gt0 : 0 < r.
Variable t : nat -> R.
Hypothesis t_mono : forall i, t i <= t i.+1.
Variables n k i : nat.
Local Notation m := (n + k.+1)%N.
Hypothesis k0 : (0 < k)%N.
Hypothesis i_n : (i <= n)%N.
Hypothesis h1 : t i < t i.+1.
Hypothesis h2 : t i.+1 = t (i + k.+1)%N.
Hypothesis h3 : t (i + k.+1)%N < t m.
Local Notation f := (value r t m k i).
Let tle := t_le t_mono.
Let U : t 0%N < t m.
Proof. by apply: (le_lt_trans (tle (leq0n i))); apply: (lt_trans h1); rewrite h2. Qed.
Let zero x : ~~ (t i < x < t i.+1) -> f x = 0.
Proof.
move=> hx; apply: T3_5_1_amended => //; rewrite -?h2 //.
  by move=> [_ [e1 e2]]; move: h1; rewrite e1 ltNge; case/negP; apply: tle; rewrite -{1}[i]addn0 -addnS leq_add2l.
by move=> [_ [e1 e2]]; move: h3; rewrite -h2 e1 ltxx.
Qed.
Let above x : t i <= x < t i.+1 -> exists2 e, 0 < e & forall z, 0 < z < e -> x + z < t i.+1 /\ f x < f (x + z).
Proof.
move=> /andP[x0 x1]; exists (t i.+1 - x); first by rewrite subr_gt0.
move=> z /andP[z0 z1]; have xz : x + z < t i.+1 by rewrite addrC -ltr_subr_addr.
have tm : t i.+1 < t m by rewrite h2.
split=> //; rewrite !value_in ?(lt_trans xz) ?(lt_trans x1) //.
have xx : x < x + z by rewrite ltr_addl.
by have [_] := first_rises r_gt0 t_mono k x0 xx xz; apply.
Qed.
(* Conj3.1.weak fails: no largest value; the limit at the knot is 1, the value 0 *)
Theorem Conj3_1_weak_fails : [/\ forall x, exists y, f x < f y, limit_left r t m k i (t i.+1) = 1 & f (t i.+1) = 0].
Proof.
split.
- move=> x; case: (boolP (t i < x < t i.+1)) => [/andP[x0 x1]|hx].
    have [e e0 H] := @above x ltac:(by rewrite (ltW x0)); have [z [z0 z1 _]] := small2 e0 e0.
    by exists (x + z); have [] := H z ltac:(by rewrite z0).
  rewrite zero //; exists ((t i + t i.+1) / 2%:R); have [a b] := midf_lt h1.
  by apply: T3_5_2_printed => //; rewrite a -h2.
- rewrite /limit_left (left_span_uniq t_mono (s := i)) ?h1 ?lexx //; last by move: i_n; clear; lia.
  rewrite /P /piece (@N_left _ _ i k.+1) ?eqxx // => e j ji /andP[j1 j2].
  have E : t (j + e)%N = t i.+1 by apply/eqP; rewrite eq_le {1}h2 !tle.
  by rewrite /mw E mob_b // (le_lt_trans (tle ji)).
by rewrite zero // ltxx andbF.
Qed.
(* Conj3.1.strong fails: no local maximum *)
Theorem Conj3_1_strong_fails x : ~ local_max f (t i) (t (i + k.+1)%N) x.
Proof.
move=> [/andP[x0 xb] [e e0 H]]; rewrite -h2 in xb H; move: xb; rewrite le_eqVlt => /orP[/eqP ex|x1].
  have [z [z0 z1 z2]] := small2 e0 (b := t i.+1 - t i) ltac:(by rewrite subr_gt0).
  have a : t i < x - z by rewrite ex ltr_subr_addr addrC -ltr_subr_addr.
  have b : x - z < t i.+1 by rewrite ex ltr_subl_addr ltr_addl.
  have := H (x - z) ltac:(by rewrite !ltW) ltac:(by rewrite addrAC subrr add0r normrN gtr0_norm).
  by rewrite [f x]zero ?ex ?ltxx ?andbF // -ex leNgt T3_5_2_printed // a -h2.
have [d d0 Hd] := @above x ltac:(by rewrite x0); have [z [z0 z1 z2]] := small2 e0 d0.
have [xz lt] := Hd z ltac:(by rewrite z0); have xz' : x <= x + z by rewrite ler_addl ltW.
have := H (x + z) ltac:(by rewrite (le_trans x0) // ltW) ltac:(by rewrite addrAC subrr add0r gtr0_norm).
by rewrite leNgt lt.
Qed.
End Jump.
