(* X.limit: on a span the first active function tends to 1 as r -> 0, the last one as r -> oo, with bounds. *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import ring zify.
From Bsplines Require Import Definitions Weight Basis Curves Pieces Derivatives Values Cumulative.
Import Order.TTheory GRing.Theory Num.Theory.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Local Open Scope ring_scope.

Section Products.
Variable R : realFieldType.
Variables (w : nat -> nat -> R) (s : nat).
(* the first active function is the product of the falling weights, the last one that of the rising ones *)
Lemma N_first d : (d <= s)%N -> N w s d (s - d) = \prod_(0 <= e < d) (1 - w e.+1 (s - e)%N).
Proof.
elim: d => [|d IH] ds; first by rewrite big_geq // subn0 /= eqxx.
rewrite NS N_supp ?mulr0 ?add0r; last by move: ds; clear; lia.
have -> : ((s - d.+1).+1 = s - d)%N by move: ds; clear; lia.
by rewrite IH ?(ltnW ds) // [in RHS]big_nat_recr //= mulrC.
Qed.
Lemma N_last d : N w s d s = \prod_(0 <= e < d) w e.+1 s.
Proof.
elim: d => [|d IH]; first by rewrite big_geq // /= eqxx.
rewrite NS [N w s d s.+1]N_supp ?mulr0 ?addr0; last by clear; lia.
by rewrite IH [in RHS]big_nat_recr //= mulrC.
Qed.
Lemma prod_bound (f : nat -> R) d : (forall e, (e < d)%N -> 0 <= f e <= 1) ->
  0 <= \prod_(0 <= e < d) (1 - f e) <= 1 /\ 1 - \prod_(0 <= e < d) (1 - f e) <= \sum_(0 <= e < d) f e.
Proof.
elim: d => [|d IH] h; first by rewrite !big_geq // ler01 lexx subrr lexx.
have [/andP[p0 p1] q] := IH (fun e he => h e (leqW he)); have /andP[f0 f1] := h d (ltnSn d).
rewrite !big_nat_recr //=; move: (\prod_(0 <= e < d) _) (\sum_(0 <= e < d) _) p0 p1 q => P S p0 p1 q.
split.
  have g0 : 0 <= 1 - f d by rewrite subr_ge0.
  by rewrite mulr_ge0 //= -[X in _ <= X]mul1r ler_pmul // ler_subl_addl ler_addr.
have -> : 1 - P * (1 - f d) = (1 - P) + P * f d by ring.
by apply: ler_add => //; rewrite -[X in _ <= X]mul1r ler_wpmul2r.
Qed.
End Products.

Section Paper.
Variable R : realFieldType.
Variable r : R.
Hypothesis r_gt0 : 0 < r.
Variable t : nat -> R.
Hypothesis t_mono : forall i, t i <= t i.+1.
Let tle := t_le t_mono.
Variables n k : nat.
Local Notation m := (n + k.+1)%N.
(* X.limit: both bounds *)
Theorem X_limit_printed j x : (1 <= k)%N -> (k <= j <= n)%N -> t j < x < t j.+1 ->
  1 - value r t m k (j - k) x <= r * (\sum_((j - k).+1 <= i < j.+1) ((x - t i) / (t j.+1 - x))) /\
  1 - value r t m k j x <= r^-1 * (\sum_(j.+1 <= i < (j + k).+1) ((t i - x) / (x - t j))).
Proof.
move=> k1 /andP[kj jn] hx; have /andP[x1 x2] := hx.
have xm : x < t m by apply: (lt_le_trans x2); apply: tle; move: jn; clear; lia.
have hs : t j <= x < t j.+1 by rewrite ltW.
rewrite !value_in // !(G_P r t_mono _ _ hs) /P /piece N_first // N_last.
have w01 e i : (i <= j < i + e)%N -> 0 <= mw r t e i x <= 1.
  by move=> h; have /andP[a b] := span_in t_mono r_gt0 hx h; rewrite !ltW.
split.
  have [_ h] := @prod_bound R (fun e => mw r t e.+1 (j - e) x) k ltac:(move=> e he; apply: w01; move: he kj; clear; lia).
  apply: (le_trans h); rewrite mulr_sumr -{1}[j.+1]add0n -[(j - k).+1]add0n.
  have -> : \sum_(0 + (j - k).+1 <= i < 0 + j.+1) r * ((x - t i) / (t j.+1 - x)) = \sum_(0 <= e < k) r * ((x - t (j - e)%N) / (t j.+1 - x)).
    rewrite !add0n big_nat_rev /= -{1}[(j - k).+1]add0n big_addn.
    have -> : (j.+1 - (j - k).+1 = k)%N by move: kj; clear; lia.
    apply: eq_big_nat => e he; congr (_ * ((_ - t _) / _)); move: he kj; clear; lia.
  rewrite big_nat_cond [X in _ <= X]big_nat_cond; apply: ler_sum => e /andP[/andP[_ he] _].
  have E : (j - e + e.+1 = j.+1)%N by move: he kj; clear; lia.
  have a0 : 0 <= x - t (j - e)%N by rewrite subr_ge0 (le_trans (tle (leq_subr _ _))) // ltW.
  have b0 : 0 < t j.+1 - x by rewrite subr_gt0.
  have r00 := ltW r_gt0; have ra : 0 <= r * (x - t (j - e)%N) by rewrite mulr_ge0.
  have d0 : 0 < r * (x - t (j - e)%N) + (t j.+1 - x) by rewrite ltr_paddl.
  have -> : r * ((x - t (j - e)%N) / (t j.+1 - x)) = r * (x - t (j - e)%N) / (t j.+1 - x) by rewrite mulrA.
  by rewrite /mw /mob E; apply: ler_wpmul2l => //; rewrite lef_pinv ?posrE // ler_addr.
have v01 l : (l < k)%N -> 0 <= 1 - mw r t l.+1 j x <= 1.
  move=> _; have hl : (j <= j < j + l.+1)%N by clear; lia.
  by have /andP[a b] := w01 _ _ hl; rewrite subr_ge0 b ler_subl_addl ler_addr.
have [_ h] := @prod_bound R (fun l => 1 - mw r t l.+1 j x) k v01.
have -> : \prod_(0 <= e < k) mw r t e.+1 j x = \prod_(0 <= e < k) (1 - (1 - mw r t e.+1 j x)).
  by apply: eq_bigr => e _; rewrite opprB addrC subrK.
apply: (le_trans h); rewrite mulr_sumr -[j.+1]add0n big_addn.
have -> : ((j + k).+1 - j.+1 = k)%N by clear; lia.
rewrite big_nat_cond [X in _ <= X]big_nat_cond; apply: ler_sum => e /andP[/andP[_ he] _].
have a0 : 0 < x - t j by rewrite subr_gt0.
have xe : x <= t (j + e.+1)%N by apply: (le_trans (ltW x2)); apply: tle; clear; lia.
have b0 : 0 <= t (j + e.+1)%N - x by rewrite subr_ge0.
have lt : t j < t (j + e.+1)%N by apply: lt_le_trans xe.
rewrite mob_compl ?(ltW x1) //; have -> : (e + j.+1 = j + e.+1)%N by clear; lia.
have -> : r^-1 * ((t (j + e.+1)%N - x) / (x - t j)) = (t (j + e.+1)%N - x) / (r * (x - t j)) by rewrite invfM mulrCA.
have ra : 0 < r * (x - t j) by rewrite mulr_gt0.
have d0 : 0 < r * (x - t j) + (t (j + e.+1)%N - x) by rewrite ltr_paddr.
by apply: ler_wpmul2l => //; rewrite lef_pinv ?posrE // ler_addl.
Qed.
End Paper.
