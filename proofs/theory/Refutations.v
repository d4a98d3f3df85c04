(* Sentences as printed, refuted for every degree and every index. *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import ring zify.
From Bsplines Require Import Definitions Weight Basis Curves Pieces Bernstein.
Import Order.TTheory GRing.Theory Num.Theory.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Local Open Scope ring_scope.

Section Refute.
Variable R : realFieldType.
Variable r : R.
Hypothesis r_gt0 : 0 < r.

(* T3.5.1 printed: x = t_i is not in the open interval, yet G = 1 *)
Theorem T3_5_1_printed_false k : exists t : nat -> R, exists i x, [/\ forall j, t j <= t j.+1,
  ~~ (t i < x < t (i + k.+1)%N) & G (wt r t) t k i x = 1].
Proof.
have mono := bknots_mono (@ltr01 R) k.
exists (bknots 0 1 k), 0%N, (bknots 0 1 k 0); split => //; first by rewrite ltxx.
apply: (@T3_5_1_exception _ _ _ mono (wt_left r _)); first by rewrite /bknots /= leqnn.
by rewrite /bknots /= leqnn ltnn ltr01.
Qed.

(* T3.5.3 printed: T3_5_3_printed_false in T3_5.v *)

(* T3.5.4 printed: symmetric knots -1, 0^(k+1), 1, x = 0, i = 0 *)
Definition sknots (k i : nat) : R := if (i == 0)%N then -1 else if (i <= k.+1)%N then 0 else 1.
Theorem T3_5_4_printed_false k : let t := sknots k in let m := (1 + k.+1)%N in
  [/\ forall j, t j <= t j.+1, forall j, (j <= m)%N -> t (m - j)%N = t 0%N + t m - t j &
      G (wt r t) t k 0 (t 0%N + t m - 0) != G (wt r^-1 t) t k (1 - 0) 0].
Proof.
move=> t m; have mono j : t j <= t j.+1.
  rewrite /t /sknots /=; case: (posnP j) => [->|j0]; first by rewrite /= oppr_le0 ler01.
  case: (leqP j k.+1) => h; case: (leqP j.+1 k.+1) => h'; rewrite ?lexx ?ler01 //; lia.
have tm : t m = 1 by rewrite /t /sknots /m add1n /= ltnn.
have t0 : t 0%N = -1 by [].
split => //.
  move=> j jm; rewrite t0 tm addNr sub0r /t /sknots; case: (posnP j) => [->|j0].
    by rewrite subn0 /m add1n /= ltnn opprK.
  case: (leqP j k.+1) => h; last first.
    by have -> : (m - j == 0)%N by rewrite /m in jm *; lia.
  have -> : (m - j == 0)%N = false by apply/eqP; rewrite /m; lia.
  by have -> : (m - j <= k.+1)%N by [rewrite /m; lia]; rewrite oppr0.
have -> : t 0%N + t m - 0 = 0 by rewrite t0 tm; ring.
have t1 : t 1%N = 0 by [].
have ri : 0 < r^-1 by rewrite invr_gt0.
have -> : G (wt r t) t k 0 0 = 0.
  have ts : t k.+1 <= 0 < t k.+2 by rewrite /t /sknots /= leqnn ltnn lexx ltr01.
  by rewrite (G_N mono _ _ _ ts) N_supp //; lia.
rewrite subn0 -{1}t1 (@T3_5_1_exception _ _ _ mono (wt_left r^-1 _)).
- by rewrite eq_sym oner_neq0.
- by rewrite t1 /t /sknots add1n /= leqnn.
by rewrite /t /sknots !add1n /= leqnn ltnn ltr01.
Qed.

(* P3.1.3, P4.2.1 printed: open U whose first knot occurs k+2 times: a^(k+2), then b *)
Theorem P3_1_3_printed_false k : exists t : nat -> R, [/\ forall j, t j <= t j.+1,
   t 0%N = t k & t k < t (k + 2)%N] /\ G (wt r t) t k 0 (t 0%N) = 0.
Proof.
have mono := bknots_mono (@ltr01 R) k.+1.
exists (bknots 0 1 k.+1); split; first split => //.
- by rewrite /bknots leqnSn.
- by rewrite /bknots leqnSn; have -> : (k + 2 <= k.+1)%N = false by [apply/negP; lia]; rewrite ltr01.
apply: T3_5_1_outside => //.
by rewrite negb_and orbC -leNgt add0n /bknots leqnn lexx.
Qed.
(* P4.1.1 (left limit at t_m): only d_n acts there, but t_m is outside of [t_n, t_(n+k+1)) *)
Theorem P4_1_1_printed_false k n (t : nat -> R) : (forall j, t j <= t j.+1) -> t n < t n.+1 -> t n.+1 = t (n + k.+1)%N ->
  ~~ (t n <= t (n + k.+1)%N < t (n + k.+1)%N) /\ P r t n k n (t (n + k.+1)%N) = 1.
Proof.
move=> mono h e; split; first by rewrite ltxx andbF.
rewrite /P (@P3_1_3_right _ (mw r t) t mono) ?eqxx //; exact: mw_right.
Qed.
End Refute.

Print Assumptions T3_5_1_printed_false.
Print Assumptions T3_5_4_printed_false.
Print Assumptions P3_1_3_printed_false.
Print Assumptions P4_1_1_printed_false.
