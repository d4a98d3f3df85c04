(* Lemmas on which windows of knots rest: shift (some knots of U make the same functions), locality (only the knots t_i..t_(i+k+1), and on a
   span only the nearest), and the place of a point among the knots. Each of them holds for every weight that depends on its interval only. *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import ring zify.
From Bsplines Require Import Definitions Weight Basis Curves Pieces Derivatives Values.
Import Order.TTheory GRing.Theory Num.Theory.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Local Open Scope ring_scope.

Section Windows.
Variable R : realFieldType.
Variable om : R -> R -> R -> R.    (* om x a b: the weight of [a,b) at x *)
Definition weight (t : nat -> R) d i x : R := om x (t i) (t (i + d)%N).
Local Notation Gw t := (G (weight t) t).

(* shift: the knots from t_c on *)
Theorem shift t c d i x : Gw (fun j => t (j + c)%N) d i x = Gw t d (i + c) x.
Proof.
elim: d i => [|d IH] i; first by rewrite !G0 addSn.
rewrite !GS !IH /weight.
have -> : (i + d.+1 + c = i + c + d.+1)%N by clear; lia.
have -> : (i.+1 + d.+1 + c = (i + c).+1 + d.+1)%N by clear; lia.
by rewrite addSn.
Qed.
(* locality: G_i^d depends on t_i, .., t_(i+d+1) only *)
Theorem locality t t' d i x : (forall j, (i <= j <= i + d.+1)%N -> t j = t' j) -> Gw t d i x = Gw t' d i x.
Proof.
elim: d i => [|d IH] i h; first by rewrite !G0 !h //; clear; lia.
rewrite !GS (IH i) ?(IH i.+1); try (by move=> j hj; apply: h; move: hj; clear; lia).
by rewrite /weight !h //; clear; lia.
Qed.
(* and on the span [t_s,t_(s+1)) on t_(s-d+1), .., t_(s+d) only; it is 0 there unless s-d <= i <= s *)
Theorem span_locality t t' s d i x : (forall j, t j <= t j.+1) -> (forall j, t' j <= t' j.+1) -> t s <= x < t s.+1 -> t' s <= x < t' s.+1 ->
  (forall j, (s < j + d)%N -> (j <= s + d)%N -> t j = t' j) -> Gw t d i x = Gw t' d i x.
Proof.
move=> m m' hx hx' h; rewrite (G_N m _ _ _ hx) (G_N m' _ _ _ hx'); apply: N_ext => e j hj ed.
by rewrite /weight !h //; move: hj ed; clear; lia.
Qed.
(* windows: on a span G_i is 0 unless s−k ≤ i ≤ s *)
Theorem span_zero t s d i x : (forall j, t j <= t j.+1) -> t s <= x < t s.+1 -> ~~ (i <= s <= i + d)%N -> Gw t d i x = 0.
Proof. by move=> mt hx h; rewrite (G_N mt _ _ _ hx) N_supp. Qed.
End Windows.

(* place of x: outside, at t_0, inside a span, at an inner knot with its copies, or at t_m; and exactly one of these *)
Section Place.
Variable R : realFieldType.
Variable t : nat -> R.
Hypothesis t_mono : forall i, t i <= t i.+1.
Variable m : nat.
Hypothesis U : t 0%N < t m.
(* windows: every x is outside, t_0, inside a span, an inner knot with its copies, or t_m *)
Theorem place x : [\/ x < t 0%N, x = t 0%N, exists2 s, (s < m)%N & t s < x < t s.+1 \/
    exists q, [/\ (0 < q <= s)%N, t s <= x < t s.+1, t (s - q)%N < x & forall j, (s - q < j <= s)%N -> t j = x] |
    x = t m \/ t m < x].
Proof.
case: (ltgtP x (t 0%N)) => h0; [by constructor 1| |by constructor 2].
case: (ltgtP x (t m)) => hm; [|by constructor 4; right|by constructor 4; left].
constructor 3.
have hx : t 0%N <= x < t m by rewrite ltW.
have [sm /andP[s1 s2]] := right_spanP hx; set s := right_span t m x in sm s1 s2.
exists s => //; move: s1; rewrite le_eqVlt => /orP[/eqP e|lt]; last by left; rewrite lt.
right; have hy : t 0%N < x <= t m by rewrite h0 ltW.
have [pm /andP[p1 p2]] := left_spanP hy; set p := left_span t m x in pm p1 p2.
have ps : (p < s)%N by apply: (t_lt_ltn t_mono); rewrite e.
exists (s - p)%N; have -> : (s - (s - p) = p)%N by move: ps; clear; lia.
split; [by move: ps; clear; lia|by rewrite e eqxx s2|exact: p1|].
move=> j /andP[j1 j2]; apply/eqP; rewrite eq_le -{1}e (t_le t_mono j2) /=.
exact: le_trans p2 (t_le t_mono j1).
Qed.
(* the span of a point is one only *)
Theorem place_one s s' x : t s <= x < t s.+1 -> t s' <= x < t s'.+1 -> s = s'.
Proof. by move=> h h'; apply/eqP; rewrite -(span_eq t_mono s h') h. Qed.
End Place.
