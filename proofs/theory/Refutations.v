(* Sentences as printed, refuted for every degree and every index: knots on which the stanza's hypotheses hold and its
   conclusion does not. The knots take two or three values: 0, 1 and 0, 1, 2. *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import ring zify.
From Bsplines Require Import Definitions Weight Basis Curves Pieces Derivatives Values.
From Bsplines Require Import StatementsBasis StatementsDerivatives StatementsCurves.
Import Order.TTheory GRing.Theory Num.Theory.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Local Open Scope ring_scope.

Section Refutations.
Variable R : realFieldType.
Variable r : R.
Hypothesis r_gt0 : 0 < r.
Variable k : nat.

(* 0 for i < a, then 1 *)
Definition step (a i : nat) : R := if (a <= i)%N then 1 else 0.
Lemma step_mono a i : step a i <= step a i.+1.
Proof. by rewrite /step; case: (leqP a i) => h; case: (leqP a i.+1) => h'; rewrite ?lexx ?ler01 //; move: h h'; clear; lia. Qed.
Lemma step0 a i : (i < a)%N -> step a i = 0.
Proof. by move=> h; rewrite /step leqNgt h. Qed.
Lemma step1 a i : (a <= i)%N -> step a i = 1.
Proof. by move=> h; rewrite /step h. Qed.
Lemma step_open a : (k < a <= k.+2)%N -> Uopen (step a) k.+1 k.
Proof.
move=> h; split.
- by rewrite !step0 //; move: h; clear; lia.
- by rewrite !step1 //; move: h; clear; lia.
by rewrite [step a k]step0 ?[step a k.+2]step1 ?ltr01 //; move: h; clear; lia.
Qed.
Lemma step_U a : (k < a <= k.+2)%N -> step a 0 < step a (k.+1 + k.+1).
Proof. by move=> h; rewrite step0 ?step1 ?ltr01 //; move: h; clear; lia. Qed.

(* 0 and 1 and 2, each k+1 times *)
Definition steps i : R := if (k.+1 + k.+1 <= i)%N then 2%:R else step k.+1 i.
Local Notation n3 := (k + k.+1)%N.
Lemma steps0 i : (i < k.+1)%N -> steps i = 0.
Proof. by move=> h; rewrite /steps step0 //; case: (leqP (k.+1 + k.+1) i) => // e; move: h e; clear; lia. Qed.
Lemma steps1 i : (k < i < k.+1 + k.+1)%N -> steps i = 1.
Proof. by move=> /andP[h1 h2]; rewrite /steps leqNgt h2 /= step1. Qed.
Lemma steps2 i : (k.+1 + k.+1 <= i)%N -> steps i = 2%:R.
Proof. by move=> h; rewrite /steps h. Qed.
Lemma steps_mono i : steps i <= steps i.+1.
Proof.
rewrite /steps; case: (leqP (k.+1 + k.+1) i) => h; case: (leqP (k.+1 + k.+1) i.+1) => h'; rewrite ?lexx ?step_mono //.
  by move: h h'; clear; lia.
by rewrite /step; case: ifP => _; rewrite ?ler1n ?ler0n.
Qed.
Lemma steps_open : Uopen steps n3 k.
Proof.
split; first by rewrite !steps0.
  by rewrite !steps2 //; clear; lia.
by rewrite steps0 // steps2 ?ltr0n //; clear; lia.
Qed.
Lemma steps_U : steps 0 < steps (n3 + k.+1).
Proof. by rewrite steps0 // steps2 ?ltr0n //; clear; lia. Qed.
Lemma steps_symmetric : Usymmetric steps n3 k.
Proof.
move=> i im; rewrite [steps 0]steps0 // [steps (n3 + k.+1)]steps2; last by clear; lia.
rewrite add0r; case: (ltnP i k.+1) => h1.
  by rewrite [steps i]steps0 // [steps _]steps2 ?subr0 //; move: h1; clear; lia.
case: (ltnP i (k.+1 + k.+1)) => h2.
  rewrite [steps i]steps1 ?h1 // [steps _]steps1; last by move: h1 h2; clear; lia.
  by rewrite (_ : 2%:R = 1 + 1 :> R) ?addrK // -natrD.
by rewrite [steps i]steps2 // [steps _]steps0 ?subrr //; move: h2 im; clear; lia.
Qed.
Lemma steps_mult : (k < mult steps (n3 + k.+1) 1)%N.
Proof.
rewrite /mult; have -> : ((n3 + k.+1).+1 = k.+1 + (k.+1 + k.+1))%N by clear; lia.
rewrite !iotaD !count_cat (@eq_in_count _ _ predT (iota (0 + k.+1) k.+1)); last first.
  by move=> j; rewrite mem_iota => hj /=; rewrite steps1 ?eqxx //; move: hj; clear; lia.
by rewrite count_predT size_iota; apply: leq_trans (leq_addl _ _); exact: leq_addr.
Qed.
Lemma steps_in : steps 0 < 1 < steps (n3 + k.+1).
Proof. by rewrite steps0 // steps2 ?ltr01 ?ltr1n //; clear; lia. Qed.

(* T3.5.1: t_0 is not in the open support, and G_0 is 1 there *)
Theorem T3_5_1_printed_false : exists (t : nat -> R) n i x, [/\ forall j, t j <= t j.+1, t 0%N < t (n + k.+1)%N,
  (i <= n)%N, ~~ (t i < x < t (i + k.+1)%N) & value r t (n + k.+1) k i x != 0].
Proof.
have hk : (k < k.+1 <= k.+2)%N by clear; lia.
exists (step k.+1), k.+1, 0%N, 0; split; [exact: step_mono|exact: step_U|by []|by rewrite step0 // ltxx|].
rewrite (T3_5_1_fails r_gt0 (step_mono k.+1) (step_U hk)) ?oner_neq0 //; left.
rewrite !add0n; split; first by rewrite step0.
by split; [rewrite !step0|rewrite step0 // step1 // ltr01].
Qed.
(* T3.5.4: the double middle knot is one of multiplicity k+1 *)
Theorem T3_5_4_printed_false : exists (t : nat -> R) n i x, [/\ forall j, t j <= t j.+1, t 0%N < t (n + k.+1)%N,
  Usymmetric t n k, (i <= n)%N /\ t 0%N <= x <= t (n + k.+1)%N &
  value r t (n + k.+1) k i (t 0%N + t (n + k.+1)%N - x) != value r^-1 t (n + k.+1) k (n - i) x].
Proof.
have [i [im h]] := T3_5_4_fails r steps_mono steps_symmetric steps_in steps_mult.
exists steps, n3, i, 1; split => //; [exact: steps_mono|exact: steps_U|exact: steps_symmetric|].
by split => //; have /andP[/ltW -> /ltW ->] := steps_in.
Qed.
(* P3.1.3: a first knot that occurs k+2 times *)
Theorem P3_1_3_printed_false : exists (t : nat -> R) n, [/\ forall j, t j <= t j.+1, Uopen t n k &
  value r t (n + k.+1) k 0 (t 0%N) != 1].
Proof.
have hk : (k < k.+2 <= k.+2)%N by clear; lia.
have U := step_U hk; exists (step k.+2), k.+1; split; [exact: step_mono|exact: step_open|].
rewrite value_in // T3_5_1_outside; [by rewrite eq_sym oner_neq0|exact: step_mono|].
by rewrite negb_and -leNgt !step0 ?lexx ?orbT //; clear; lia.
Qed.
(* L3.8: the third line, a first knot that occurs k+2 times *)
Theorem L3_8_printed_false q : (q < k)%N -> exists (t : nat -> R) n i, [/\ forall j, t j <= t j.+1, Uopen t n k, (2 <= i <= n)%N &
  Dright r t (n + k.+1) (k - q) (q + i) (t 0%N) != Dright r t (n + k.+1) (k - q.+1) (q + i).+1 (t 0%N)].
Proof.
move=> qk; have hk : (k < k.+2 <= k.+2)%N by clear; lia.
have sm : (k.+1 < k.+1 + k.+1)%N by clear; lia.
have s0 : step k.+2 k.+1 = step k.+2 0 by rewrite !step0.
have s1 : step k.+2 0 < step k.+2 k.+2 by rewrite step0 // step1 // ltr01.
exists (step k.+2), k.+1, 2%N; split; [exact: step_mono|exact: step_open|by move: qk; clear; lia|].
have -> : (k - q = (k - q.+1).+1)%N by move: qk; clear; lia.
rewrite (Dright_t0_step r (step_mono k.+2) sm s0 s1).
have -> : (q + 2 + (k - q.+1) == k.+1)%N by apply/eqP; move: qk; clear; lia.
have -> : ((q + 2).+1 + (k - q.+1) == k.+1)%N = false by apply/eqP; move: qk; clear; lia.
rewrite mul1r mul0r subr0 -subr_eq0 addrC addKr gt_eqF // (dmw_t0 r_gt0 (step_mono k.+2) s0 s1) //.
by move: qk; clear; lia.
Qed.
(* L3.9, L3.10, T3.11.3b: a last knot that occurs k+2 times *)
Lemma step_last : last_span (step k.+1) (k.+1 + k.+1) = k.
Proof.
apply: last_span_uniq; [exact: step_mono|by apply: step_U; clear; lia|by clear; lia| |].
  by rewrite step0 // step1 // ltr01.
by rewrite !step1 //; clear; lia.
Qed.
(* L3.9: for every k and q on the knots 0 (k+1 times), 1 (k+2 times) *)
Theorem L3_9_printed_false q : (q < k)%N -> exists (t : nat -> R) n, [/\ forall j, t j <= t j.+1, Uopen t n k &
  Dleft r t (n + k.+1) (k - q) n.-1 (t (n + k.+1)%N) !=
  Dleft r t (n + k.+1) (k - q.+1) n.-1 (t (n + k.+1)%N) - wDleft r t (k - q) n (t (n + k.+1)%N)].
Proof.
move=> qk; have hk : (k < k.+1 <= k.+2)%N by clear; lia.
exists (step k.+1), k.+1; split; [exact: step_mono|exact: step_open|].
apply: (L3_9_fails r_gt0 (step_mono k.+1) (step_U hk) (step_open hk) qk).
by rewrite (mult_tm (step_mono k.+1) (step_U hk)) step_last; clear; lia.
Qed.
(* T3.11.3b: for every k on the knots 0 (k+1 times), 1 (k+2 times) *)
Theorem T3_11_3b_printed_false : (1 <= k)%N -> exists (t : nat -> R) n i, [/\ forall j, t j <= t j.+1, Uopen t n k, (i.+2 <= n)%N &
  Dleft r t (n + k.+1) k i (t (n + k.+1)%N) != 0].
Proof.
move=> k1; have hk : (k < k.+1 <= k.+2)%N by clear; lia.
have e : step k.+1 k.+1 = step k.+1 k.+2 by rewrite !step1.
have [i [im h]] := T3_11_3b_fails r_gt0 (step_mono k.+1) (step_U hk) k1 (step_open hk) e.
by exists (step k.+1), k.+1, i; split => //; [exact: step_mono|exact: step_open].
Qed.
(* L3.10: for every k on the same knots *)
Theorem L3_10_printed_false : (2 <= k)%N -> exists (t : nat -> R) n i, [/\ forall j, t j <= t j.+1, Uopen t n k, (i.+2 <= n)%N &
  Dleft r t (n + k.+1) k i (t (n + k.+1)%N) != 0].
Proof. by move=> k2; apply: T3_11_3b_printed_false; exact: ltnW. Qed.
(* T3.11.3a: for every k on the knots 0 (k+2 times), 1 (k+1 times) *)
Theorem T3_11_3a_printed_false : (1 <= k)%N -> exists (t : nat -> R) n i, [/\ forall j, t j <= t j.+1, Uopen t n k, (2 <= i <= n)%N &
  Dright r t (n + k.+1) k i (t 0%N) != 0].
Proof.
move=> k1; have hk : (k < k.+2 <= k.+2)%N by clear; lia.
have e : step k.+2 k = step k.+2 k.+1 by rewrite !step0.
have [i [im h]] := T3_11_3a_fails r_gt0 (step_mono k.+2) (step_U hk) k1 (step_open hk) e.
by exists (step k.+2), k.+1, i; split => //; [exact: step_mono|exact: step_open].
Qed.
(* T3.11.2: at a knot of multiplicity k+1 the limit from the left is not the value *)
Theorem T3_11_2_printed_false : exists (t : nat -> R) n i j, [/\ forall l, t l <= t l.+1, (i <= n)%N, (j <= n + k.+1)%N,
  t 0%N < t j & limit_left r t (n + k.+1) k i (t j) != value r t (n + k.+1) k i (t j)].
Proof.
have s1 : steps k.+1 = 1 by apply: steps1; clear; lia.
have hj : (k.+1 <= n3 + k.+1)%N by clear; lia.
have hs := steps_in; have hm := steps_mult; rewrite -s1 in hs hm.
have [i [im h]] := T3_11_2_fails r_gt0 steps_mono hj hs hm.
by exists steps, n3, i, k.+1; split => //; [exact: steps_mono|case/andP: hs].
Qed.
(* P4.1.1: at t_m the point d_n acts *)
Theorem P4_1_1_printed_false : exists (t : nat -> R) n (d : nat -> R) j x, [/\ forall l, t l <= t l.+1, Uopen t n k,
  (j <= n)%N /\ t 0%N <= x <= t (n + k.+1)%N, ~~ (t j <= x < t (j + k.+1)%N) &
  coordinate r t n k d x !=
  \sum_(0 <= i < j) d i * value r t (n + k.+1) k i x + \sum_(j.+1 <= i < n.+1) d i * value r t (n + k.+1) k i x].
Proof.
have hk : (k < k.+2 <= k.+2)%N by clear; lia.
have mono := step_mono k.+2; have U := step_U hk; have ho := step_open hk.
have tm : step k.+2 (k.+1 + k.+1) = 1 by rewrite step1 //; clear; lia.
exists (step k.+2), k.+1, (fun i => (i == k.+1)%:R), k.+1, 1; split => //.
- by rewrite tm lexx step0 // ler01.
- by rewrite tm ltxx andbF.
have := @P4_1_1_fails R r r_gt0 _ mono k.+1 k U (fun i => (i == k.+1)%:R) k.+1 ho (leqnn _).
rewrite tm step0 // step1 // ltr01 => /(_ isT erefl) ->; rewrite eqxx [X in _ + X]big_geq // addr0.
rewrite big_nat_cond big1 ?oner_neq0 // => i /andP[/andP[_ h] _].
by rewrite (ltn_eqF h) mul0r.
Qed.
(* P4.2.1, P4.2.2: a first knot that occurs k+2 times; the curve begins in d_1 and its derivative there is not that of d_0 and d_1 *)
Theorem P4_2_1_printed_false : exists (t : nat -> R) n (d : nat -> R), [/\ forall l, t l <= t l.+1, Uopen t n k &
  coordinate r t n k d (t 0%N) != d 0%N].
Proof.
have hk : (k < k.+2 <= k.+2)%N by clear; lia.
have mono := step_mono k.+2; have U := step_U hk; have ho := step_open hk.
exists (step k.+2), k.+1, (fun i => (i == 1%N)%:R); split => //.
have [H _] := @P4_2_1_fails R r r_gt0 _ mono k.+1 k U (fun i => (i == 1%N)%:R) 1 ho isT.
rewrite H ?oner_neq0 //; first by rewrite !step0 //; clear; lia.
by rewrite step0 ?step1 ?ltr01 //; clear; lia.
Qed.
(* P4.3: the functions of a symmetric open vector with a knot of multiplicity k+1 in the middle *)
Theorem P4_3_printed_false : exists (t : nat -> R) n (d : nat -> R) x, [/\ forall l, t l <= t l.+1, Uopen t n k, Usymmetric t n k,
  t 0%N <= x <= t (n + k.+1)%N &
  coordinate r t n k d (t 0%N + t (n + k.+1)%N - x) != \sum_(0 <= i < n.+1) d (n - i)%N * value r^-1 t (n + k.+1) k i x].
Proof.
have [i [im h]] := T3_5_4_fails r steps_mono steps_symmetric steps_in steps_mult.
exists steps, n3, (fun j => (j == i)%:R), 1; split; [exact: steps_mono|exact: steps_open|exact: steps_symmetric| |].
  by have /andP[/ltW -> /ltW ->] := steps_in.
have pick (F : nat -> R) : \sum_(0 <= j < n3.+1) (j == i)%:R * F j = F i.
  rewrite (bigD1_seq i) ?mem_index_iota ?iota_uniq //= eqxx mul1r big1 ?addr0 //.
  by move=> j /negbTE ->; rewrite mul0r.
rewrite /coordinate pick big_nat_rev /= (eq_big_nat _ _ (F2 := fun j => (j == i)%:R * value r^-1 steps (n3 + k.+1) k (n3 - j) 1)).
  by rewrite pick.
by move=> j /andP[_ hj]; rewrite add0n subSS subKn.
Qed.
End Refutations.
