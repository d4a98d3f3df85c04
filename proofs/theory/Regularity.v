(* abstract.regularity as its stanza says it: lost for finite alpha, there for alpha = infinity, which is the case of equal weights of
   KnotWeights.v. *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import ring zify.
From Bsplines Require Import Definitions Weight Basis Curves Pieces Derivatives Values RationalDerivative HigherDerivatives KnotWeights StatementsDerivatives.
Import Order.TTheory GRing.Theory Num.Theory.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Local Open Scope ring_scope.

Section Sides.
Variable R : realFieldType.
Variable r : R.
Hypothesis r_gt0 : 0 < r.
Variable t : nat -> R.
Hypothesis t_mono : forall i, t i <= t i.+1.
Let tle := t_le t_mono.
(* the paper's weights are quotients without a pole on the closed span *)
Lemma mw_quotient s d j y : t s < t s.+1 -> t s <= y <= t s.+1 -> (j <= s < j + d)%N -> quotient_at y (mw r t d j).
Proof.
move=> ss /andP[y1 y2] /andP[h1 h2].
exists (r%:P * ('X - (t j)%:P)), (r%:P * ('X - (t j)%:P) + ((t (j + d)%N)%:P - 'X)); split=> [|x _]; last by rewrite /mw /mob !hE.
rewrite !hE; apply: mob_den_neq0 => //; [exact: le_trans (tle h1) y1|exact: le_trans y2 (tle h2)|].
exact: (le_lt_trans (tle h1) (lt_le_trans ss (tle h2))).
Qed.
Lemma P_quotient s k i y : t s < t s.+1 -> t s <= y <= t s.+1 -> quotient_at y (P r t s k i).
Proof. by move=> ss hy; apply: N_quotient => d j; apply: mw_quotient. Qed.

Variables n k : nat.
Local Notation m := (n + k.+1)%N.
Local Notation value := (value r t m).
(* near y, on each side, a function is a quotient of polynomials without a pole at y *)
Lemma near_left i y : t 0%N < y <= t m -> exists P Q d, [/\ Q.[y] != 0, 0 < d & forall x, y - d < x < y -> value k i x = P.[x] / Q.[x]].
Proof.
move=> hy; have [sm /andP[s1 s2]] := left_spanP hy; set s := left_span t m y in sm s1 s2.
have ss := lt_le_trans s1 s2; have [P [Q [nQ e]]] := @P_quotient s k i y ss ltac:(by rewrite (ltW s1)).
have [d d0 hd] := poly_near0 nQ; exists P, Q, (Num.min d (y - t s)); split; rewrite ?lt_minr ?d0 ?subr_gt0 // => x /andP[x1 x2].
move: x1; rewrite ltr_subl_addr -ltr_subl_addl lt_minr => /andP[a1 a2].
rewrite value_in; last by apply: lt_le_trans x2 _; case/andP: hy.
rewrite (G_P r t_mono _ _ (s := s)); last by rewrite (lt_le_trans x2 s2) andbT ltW //; move: a2; rewrite ltr_add2l ltr_opp2.
by apply: e; apply: hd; rewrite (lt_trans x2) ?ltr_addl // andbT ltr_subl_addr -ltr_subl_addl.
Qed.
Lemma near_right i y : t 0%N <= y < t m -> exists P Q d, [/\ Q.[y] != 0, 0 < d & forall x, y <= x < y + d -> value k i x = P.[x] / Q.[x]].
Proof.
move=> hy; have [sm /andP[s1 s2]] := right_spanP hy; set s := right_span t m y in sm s1 s2.
have ss := le_lt_trans s1 s2; have [P [Q [nQ e]]] := @P_quotient s k i y ss ltac:(by rewrite s1 ltW).
have [d d0 hd] := poly_near0 nQ; exists P, Q, (Num.min d (t s.+1 - y)); split; rewrite ?lt_minr ?d0 ?subr_gt0 // => x /andP[x1 x2].
move: x2; rewrite -ltr_subl_addl lt_minr => /andP[a1 a2]; move: a2; rewrite ltr_add2r => a2.
rewrite value_in; last by apply: (lt_le_trans a2); apply: tle.
rewrite (G_P r t_mono _ _ (s := s)); last by rewrite a2 andbT (le_trans s1).
by apply: e; apply: hd; rewrite -ltr_subl_addl a1 andbT (lt_le_trans _ x1) // ltr_subl_addr ltr_addl.
Qed.
(* the derivatives of order 1 are Dleft and Dright, and those of order 0 limit_left and the value *)
Theorem left_first i y : t 0%N < y <= t m -> derivative_left 0 (value k i) y (limit_left r t m k i y) /\
  derivative_left 1 (value k i) y (Dleft r t m k i y).
Proof.
move=> hy; have [P [Q [d [nQ d0 e]]]] := near_left i hy; have ym : y <= t m by case/andP: hy.
suff [-> ->] : limit_left r t m k i y = Dq P Q 0 y /\ Dleft r t m k i y = Dq P Q 1 y.
  by split; apply: (quotient_left d0 nQ).
apply: (left_taylor_unique (f := value k i) (x := y)).
  have [g [c [bg c0 hg]]] := DleftP r_gt0 t_mono k i hy; exists g, c; split => // z hz.
  by rewrite value_in ?hg // (lt_le_trans _ ym) // ltr_subl_addr ltr_addl; case/andP: hz.
have [h [c [bh c0 hh]]] := Dq_taylor P 0 nQ; exists (fun z => h (- z)), (Num.min c d); split; last 1 first.
- move=> z /andP[z0]; rewrite lt_minr => /andP[z1 z2]; rewrite e; last by rewrite ltr_add2l ltr_opp2 z2 ltr_subl_addr ltr_addl.
  by have := hh (- z); rewrite normrN gtr0_norm // z1 => /(_ isT); rewrite /Dq /= sqrrN mulrN => ->.
- by case: bh => K [D [K0 D0 H]]; exists K, D; split => // z hz; apply: H; rewrite normrN.
by rewrite lt_minr c0.
Qed.
Theorem right_first i y : t 0%N <= y < t m -> derivative_right 0 (value k i) y (value k i y) /\
  derivative_right 1 (value k i) y (Dright r t m k i y).
Proof.
move=> hy; have [P [Q [d [nQ d0 e]]]] := near_right i hy; have ym : y < t m by case/andP: hy.
suff [E1 ->] : value k i y = Dq P Q 0 y /\ Dright r t m k i y = Dq P Q 1 y.
  rewrite E1; split; apply: (quotient_right d0 nQ) => x /andP[x1 x2]; apply: e; by rewrite ltW.
apply: (right_taylor_unique (f := value k i) (x := y)).
  have [g [c [bg c0 hg]]] := DrightP r_gt0 t_mono k i hy; exists g, (Num.min c (t m - y)); split => //; first by rewrite lt_minr c0 subr_gt0.
  by move=> z /andP[z0]; rewrite lt_minr => /andP[z1 z2]; rewrite value_in; [rewrite hg ?z0|rewrite -ltr_subr_addl].
have [h [c [bh c0 hh]]] := Dq_taylor P 0 nQ; exists h, (Num.min c d); split => //; first by rewrite lt_minr c0.
move=> z /andP[z0]; rewrite lt_minr => /andP[z1 z2]; rewrite e; last by rewrite ler_addl z0 ltr_add2l.
by have := hh z; rewrite ger0_norm // z1 => /(_ isT).
Qed.
End Sides.

Section Statement.
Variable R : realFieldType.
Variable r : R.
Hypothesis r_gt0 : 0 < r.
Variable t : nat -> R.
Hypothesis t_mono : forall i, t i <= t i.+1.
Variables n k : nat.
Local Notation m := (n + k.+1)%N.
(* equal weights: alpha = infinity *)
Lemma owt_classical d i x : owt t (fun _ => 1) d i x = wt 1 t d i x.
Proof. by rewrite /owt /wt /phi /ow /L /mob !mul1r. Qed.
(* abstract.regularity, both formulas: for finite alpha some derivative of order at most k - multiplicity jumps exactly if the
   multiplicity is below k, and for alpha = infinity none does *)
Theorem abstract_regularity_printed j : r != 1 -> (2 * k <= m)%N -> t 0%N < t j < t m -> (mult t m (t j) <= k)%N ->
  ((exists i q v v', [/\ (i <= n)%N, (q + mult t m (t j) <= k)%N, derivative_left q (value r t m k i) (t j) v,
      derivative_right q (value r t m k i) (t j) v' & v != v']) <-> (mult t m (t j) < k)%N) /\
  (forall i q, (i <= n)%N -> (q + mult t m (t j) <= k)%N -> exists v,
      derivative_left q (value 1 t m k i) (t j) v /\ derivative_right q (value 1 t m k i) (t j) v).
Proof.
move=> r1 km hj hk; have [y0 ym] := andP hj; have U := lt_trans y0 ym.
have [h1 h2] := abstract_regularity r_gt0 t_mono km hj hk.
have hl : t 0%N < t j <= t m by rewrite y0 ltW. have hr : t 0%N <= t j < t m by rewrite ym ltW.
have one_gt0 : forall i : nat, 0 < (1 : R) by move=> _; exact: ltr01.
split.
  split=> [[i [q [v [v' [im hq d1 d2 ne]]]]]|lt].
    rewrite ltn_neqAle hk andbT; apply/eqP => e; move: hq; rewrite e -{2}[k]add0n leq_add2r leqn0 => /eqP q0.
    move: d1 d2 ne; rewrite q0 => d1 d2; have [l1 _] := left_first r_gt0 t_mono i hl; have [l2 _] := right_first r_gt0 t_mono i hr.
    by rewrite (derivative_left_unique d1 l1) (derivative_right_unique d2 l2) h2 eqxx.
  have [i [im ne]] := h1 lt r1; have [_ l1] := left_first r_gt0 t_mono i hl; have [_ l2] := right_first r_gt0 t_mono i hr.
  by exists i, 1%N, (Dleft r t m k i (t j)), (Dright r t m k i (t j)); split.
move=> i q im hq; case: (posnP k) => k0.
  by move: hq (mult_gt0 t_mono hj); move: (mult _ _ _) => mu; rewrite k0; clear; lia.
have [v [d1 d2]] := KW3_2_printed t_mono one_gt0 k0 im hj hq.
have e x : x < t m -> G (owt t (fun _ => 1)) t k i x = value 1 t m k i x.
  by move=> hx; rewrite value_in //; apply: eq_G => d l; exact: owt_classical.
exists v; split.
  by apply: (derivative_left_ext y0) d1 => x /andP[_ hx]; apply: e; exact: lt_trans ym.
by apply: (derivative_right_ext ym) d2 => x /andP[_ hx]; exact: e.
Qed.
End Statement.
