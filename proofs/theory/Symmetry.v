(* T3.5.4 and P4.3, and what affine maps of the knots do. *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import ring zify.
From Bsplines Require Import Definitions Weight Basis Curves Pieces.
Import Order.TTheory GRing.Theory Num.Theory.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Local Open Scope ring_scope.

(* ---- T3.5.4 ---- *)
Section Symmetry.
Variable R : realFieldType.
Variable r : R.
Hypothesis r_gt0 : 0 < r.
Variable t : nat -> R.
Hypothesis t_mono : forall i, t i <= t i.+1.
Variables n k : nat.
Let m := (n + k.+1)%N.
Hypothesis t_sym : forall i, (i <= m)%N -> t (m - i)%N = t 0%N + t m - t i.
Let tle := t_le t_mono.

(* from each side, at every x of the closed span, without any condition on multiplicities *)
Theorem T3_5_4_sided s i x : (s < m)%N -> (i <= n)%N -> t s < t s.+1 -> t s <= x <= t s.+1 ->
  P r t (m - 1 - s) k i (t 0%N + t m - x) = P r^-1 t s k (n - i) x.
Proof.
move=> sm im ss /andP[x1 x2]; rewrite /P /piece (@N_reflect _ _ m); try (rewrite /m; lia).
have -> : (m - 1 - (m - 1 - s) = s)%N by lia.
have -> : (m - 1 - k - i = n - i)%N by rewrite /m; lia.
apply: N_ext2 => d j h1 h2 h3 h4; rewrite /mw.
have jm : (j + d <= m)%N by rewrite /m; lia.
have -> : (m - d - j + d = m - j)%N by lia.
have -> : (m - d - j = m - (j + d))%N by lia.
rewrite !t_sym; try lia.
have E u : t 0%N + t m - u = 1 * (- u) + (t 0%N + t m) by rewrite mul1r addrC.
rewrite !E mob_affine ?oner_neq0 // mob_mirror ?invrK //.
- by rewrite opprB addrC subrK.
- by apply: le_trans x1; apply: tle; lia.
- by apply: (le_trans x2); apply: tle; lia.
- by apply: (le_lt_trans _ (lt_le_trans ss _)); apply: tle; lia.
Qed.

Let mirror x := t 0%N + t m - x.
Lemma mirror_in x : t 0%N < x < t m -> t 0%N < mirror x < t m.
Proof. by rewrite /mirror => /andP[h1 h2]; rewrite ltr_subr_addr ltr_add2l h2 ltr_subl_addr addrC ltr_add2l h1. Qed.

(* T3.5.4 as amended *)
Theorem T3_5_4 i x : (i <= n)%N -> t 0%N < x < t m -> (mult t m x <= k)%N ->
  G (wt r t) t k i (t 0%N + t m - x) = G (wt r^-1 t) t k (n - i) x.
Proof.
move=> im hx hk; have ri : 0 < r^-1 by rewrite invr_gt0.
have [p [p1 p2 pm ->]] := P3_1_2_paper ri t_mono (n - i) hx hk.
rewrite -T3_5_4_sided ?(ltW p1) ?p2 ?(lt_le_trans p1 p2) //.
apply: G_P => //.
have -> : (m - 1 - p = m - p.+1)%N by lia.
rewrite t_sym; last lia.
have -> : ((m - p.+1).+1 = m - p)%N by lia.
rewrite t_sym; last exact: ltnW.
by rewrite ler_add2l ler_opp2 p2 ltr_add2l ltr_opp2.
Qed.

(* P4.3 as amended: sg any affine map that takes d_i to d_(n-i), e.g. the reflection in the bisector of (d_0,d_n) *)
Variable V : lmodType R.
(* P4.3: every affine map that takes d_i to d_{n−i} takes one curve to the other *)
Theorem P4_3 (L : {linear V -> V}) (c : V) (d : nat -> V) x : (k <= n)%N ->
  (forall i, (i <= n)%N -> L (d i) + c = d (n - i)%N) -> t k <= x < t n.+1 -> t 0%N < x -> (mult t m x <= k)%N ->
  L (curve (wt r^-1 t) t k n d x) + c = curve (wt r t) t k n d (t 0%N + t m - x).
Proof.
move=> kn hd hx x0 hk; rewrite (P4_1_4 _ t_mono) //.
have hx' : t 0%N < x < t m.
  by rewrite x0 /=; case/andP: hx => _ h; apply: (lt_le_trans h); apply: tle; rewrite /m; lia.
rewrite /curve [RHS]big_nat_rev /=; apply: eq_big_nat => i /andP[_ hi].
rewrite add0n subSS hd // T3_5_4 //; last exact: leq_subr.
by rewrite subKn.
Qed.
End Symmetry.

(* T x = c x + e, c > 0: knots and x moved together *)
Theorem G_affine (R : realFieldType) (r : R) (t : nat -> R) (c e x : R) k i : 0 < c ->
  let t' := fun i => c * t i + e in
  G (wt r t') t' k i (c * x + e) = G (wt r t) t k i x.
Proof.
move=> c0 t'; elim: k i => [|k IH] i.
  by rewrite !G0 /t' ler_add2r ltr_add2r ler_pmul2l // ltr_pmul2l.
by rewrite !GS !IH /wt /t' !P2_1_2.
Qed.
(* T x = e - c x, c > 0: knots mirrored, index 1 - alpha (ratio 1/r); x not a knot, or of multiplicity <= k *)
Theorem G_mirror (R : realFieldType) (r : R) (t t' : nat -> R) (c e x : R) n k i :
  0 < r -> 0 < c -> (forall i, t i <= t i.+1) -> (forall i, t' i <= t' i.+1) ->
  let m := (n + k.+1)%N in (forall j, (j <= m)%N -> t' (m - j)%N = e - c * t j) ->
  (i <= n)%N -> t 0%N < x < t m -> (mult t m x <= k)%N ->
  G (wt r t') t' k i (e - c * x) = G (wt r^-1 t) t k (n - i) x.
Proof.
move=> r0 c0 mono mono' m sym im hx hk; have ri : 0 < r^-1 by rewrite invr_gt0.
have [p [p1 p2 pm ->]] := P3_1_2_paper ri mono (n - i) hx hk.
have -> : G (wt r t') t' k i (e - c * x) = P r t' (m - 1 - p) k i (e - c * x).
  apply: G_P => //.
  have -> : (m - 1 - p = m - p.+1)%N by rewrite -subnDA.
  rewrite sym //.
  have -> : ((m - p.+1).+1 = m - p)%N by rewrite subnSK.
  rewrite sym; last exact: ltnW.
  by rewrite ler_add2l ler_opp2 ler_pmul2l // p2 ltr_add2l ltr_opp2 ltr_pmul2l.
rewrite /P /piece (@N_reflect _ _ m); [|by move: pm; clear; lia|by rewrite /m addnS ltnS leq_add2r].
have -> : (m - 1 - (m - 1 - p) = p)%N by move: pm; clear; lia.
have -> : (m - 1 - k - i = n - i)%N by rewrite /m; clear; lia.
apply: N_ext2 => d j h1 h2 h3 h4; rewrite /mw.
have jm : (j + d <= m)%N by move: h2 h3 im; rewrite /m; clear; lia.
have -> : (m - d - j + d = m - j)%N by move: jm; clear; lia.
have -> : (m - d - j = m - (j + d))%N by clear; lia.
rewrite (sym j) ?(sym (j + d)%N) //; last exact: leq_trans (leq_addr _ _) jm.
have E u : e - c * u = c * (- u) + e by rewrite mulrN addrC.
have tj : t j <= t p by apply: t_le => //; case/andP: h1.
have tjd : t p.+1 <= t (j + d)%N by apply: t_le => //; case/andP: h1.
rewrite !E mob_affine ?gt_eqF // mob_mirror ?invrK //.
- by rewrite opprB addrC subrK.
- exact: le_trans tj (ltW p1).
- exact: le_trans p2 tjd.
- exact: (le_lt_trans tj (lt_le_trans p1 (le_trans p2 tjd))).
Qed.
