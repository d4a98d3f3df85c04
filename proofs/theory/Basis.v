(* Support, positivity, partition of unity: T3.5.1 to T3.5.3, for every degree and any weights. *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import ring zify.
From Bsplines Require Import Definitions Weight.
Import Order.TTheory GRing.Theory Num.Theory.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Local Open Scope ring_scope.

(* what a weight family must satisfy *)
Definition w_range (R : realFieldType) (w : nat -> nat -> R -> R) := forall d i x, 0 <= w d i x <= 1.
Definition w_inside (R : realFieldType) (w : nat -> nat -> R -> R) (t : nat -> R) :=
  forall d i x, t i < x < t (i + d)%N -> 0 < w d i x < 1.
Definition w_left (R : realFieldType) (w : nat -> nat -> R -> R) (t : nat -> R) :=
  forall d i, w d i (t i) = 0.

Section Basis.
Variable R : realFieldType.
Variable w : nat -> nat -> R -> R.
Variable t : nat -> R.
Hypothesis t_mono : forall i, t i <= t i.+1.
Local Notation G := (G w t).
Let tle := t_le t_mono.

(* ---- T3.5.1 (no hypothesis on the weights) ---- *)
Theorem T3_5_1_outside k i x : ~~ (t i <= x < t (i + k.+1)%N) -> G k i x = 0.
Proof.
elim: k i => [|k IH] i; first by rewrite G0 addn1 => /negbTE ->.
rewrite !negb_and -ltNge -leNgt => Hx; rewrite GS !IH ?mulr0 ?addr0 //.
  rewrite negb_and -ltNge -leNgt addSnnS.
  by case/orP: Hx => [H|->]; rewrite ?orbT // (lt_le_trans H (t_mono i)).
rewrite negb_and -ltNge -leNgt.
by case/orP: Hx => [->//|H]; rewrite (le_trans (tle _) H) ?orbT // leq_add2l.
Qed.

Section Left.
Hypothesis w0 : w_left w t.

(* the exception at t_i: k+1 equal knots *)
Theorem T3_5_1_exception k i : t i = t (i + k)%N -> t (i + k)%N < t (i + k.+1)%N -> G k i (t i) = 1.
Proof.
elim: k i => [|k IH] i e h.
  by rewrite G0 lexx /=; rewrite addn0 addn1 in h; rewrite h.
have e1 : t i = t i.+1.
  by apply/eqP; rewrite eq_le t_mono /= [X in _ <= X]e tle //; lia.
rewrite GS w0 mul0r add0r e1 w0 subr0 mul1r.
by apply: IH; rewrite !addSnnS // -e1.
Qed.

(* 0 at t_i unless k+1 knots coincide there *)
Theorem T3_5_1_left k i : ~ (t i = t (i + k)%N /\ t (i + k)%N < t (i + k.+1)%N) -> G k i (t i) = 0.
Proof.
elim: k i => [|k IH] i h.
  rewrite G0 lexx /=; case: ifP => // h1; case: h; split; first by rewrite addn0.
  by rewrite addn0 addn1.
rewrite GS w0 mul0r add0r.
case: (ltP (t i) (t i.+1)) => e.
  by rewrite [G k _ _]T3_5_1_outside ?mulr0 // negb_and -ltNge e.
have e1 : t i = t i.+1 by apply/eqP; rewrite eq_le t_mono e.
rewrite {2}e1 IH ?mulr0 //; rewrite !addSnnS -e1; exact: h.
Qed.

(* T3.5.1 as amended: zero for every x not in the open interval, except at t_i when k+1 knots coincide there *)
Theorem T3_5_1 k i x : ~~ (t i < x < t (i + k.+1)%N) ->
  ~ (x = t i /\ t i = t (i + k)%N /\ t (i + k)%N < t (i + k.+1)%N) -> G k i x = 0.
Proof.
move=> h1 h2; case: (boolP (t i <= x < t (i + k.+1)%N)) => h; last exact: T3_5_1_outside.
case/andP: h => h3 h4; move: h1; rewrite h4 andbT -leNgt => h5.
have e : x = t i by apply/eqP; rewrite eq_le h5 h3.
by rewrite e; apply: T3_5_1_left => h; apply: h2.
Qed.

(* ---- T3.5.2 ---- *)
Hypothesis w01 : w_range w.
(* no function is negative *)
Theorem T3_5_2_nonneg k i x : 0 <= G k i x.
Proof.
elim: k i => [|k IH] i; first by rewrite G0; case: ifP => _; rewrite ?lexx ?ler01.
rewrite GS; have /andP[a1 a2] := w01 k.+1 i x; have /andP[b1 b2] := w01 k.+1 i.+1 x.
by rewrite addr_ge0 // mulr_ge0 // subr_ge0.
Qed.

Hypothesis win : w_inside w t.
(* T3.5.2: the same for every weight with these three properties *)
Theorem T3_5_2 k i x : t i < x < t (i + k.+1)%N -> 0 < G k i x.
Proof.
elim: k i => [|k IH] i /andP[h1 h2].
  by rewrite addn1 in h2; rewrite G0 (ltW h1) h2 ltr01.
rewrite GS; have p1 := T3_5_2_nonneg k i x; have p2 := T3_5_2_nonneg k i.+1 x.
have /andP[a1 a2] := w01 k.+1 i x; have /andP[b1 b2] := w01 k.+1 i.+1 x.
have q1 : 0 <= w k.+1 i x * G k i x by rewrite mulr_ge0.
have q2 : 0 <= (1 - w k.+1 i.+1 x) * G k i.+1 x by rewrite mulr_ge0 ?subr_ge0.
case: (ltP x (t (i + k.+1)%N)) => h3.
  have /andP[c1 c2] : 0 < w k.+1 i x < 1 by apply: win; rewrite h1 h3.
  by rewrite ltr_paddr // mulr_gt0 // IH // h1 h3.
have h4 : t i.+1 <= x by apply: le_trans h3; apply: tle; rewrite addnS ltnS leq_addr.
have h5 : x < t (i.+1 + k.+1)%N by rewrite addSnnS.
move: h4; rewrite le_eqVlt => /orP[/eqP e|h4]; last first.
  have /andP[c1 c2] : 0 < w k.+1 i.+1 x < 1 by apply: win; rewrite h4 h5.
  by rewrite ltr_paddl // mulr_gt0 ?subr_gt0 // IH // h4 h5.
have e2 : t i.+1 = t (i.+1 + k)%N.
  by apply/eqP; rewrite eq_le tle ?leq_addr //= addSnnS e.
have e3 : G k i.+1 x = 1 by rewrite -e; apply: T3_5_1_exception => //; rewrite -e2 e.
have e4 : w k.+1 i.+1 x = 0 by rewrite -e w0.
by rewrite ltr_paddl // e3 e4 subr0 mul1r ltr01.
Qed.

(* proof.P4.1.1.iff as amended *)
Theorem G_neq0_iff k i x : (G k i x != 0) <->
  (t i < x < t (i + k.+1)%N) \/ (x = t i /\ t i = t (i + k)%N /\ t (i + k)%N < t (i + k.+1)%N).
Proof.
split; last first.
  case=> [h|[-> [h1 h2]]]; first by rewrite gt_eqF // T3_5_2.
  by rewrite T3_5_1_exception // oner_neq0.
case: (boolP (t i < x < t (i + k.+1)%N)) => h; first by left.
move=> g; right; move: g.
case: (eqVneq x (t i)) => [->|hx]; last by rewrite T3_5_1 ?eqxx // => -[e _]; rewrite e eqxx in hx.
case: (eqVneq (t i) (t (i + k)%N)) => [e|e]; last first.
  by rewrite T3_5_1_left ?eqxx // => -[e' _]; rewrite -e' eqxx in e.
case: (ltP (t (i + k)%N) (t (i + k.+1)%N)) => // h2.
by rewrite T3_5_1_left ?eqxx // => -[_ h3]; move: h2; rewrite leNgt h3.
Qed.
End Left.

(* ---- T3.5.3 as amended: on every span of [t_k, t_(n+1)), any weights ---- *)
Theorem T3_5_3_local k j x : (k <= j)%N -> t j <= x < t j.+1 -> \sum_(j - k <= i < j.+1) G k i x = 1.
Proof.
move=> kj h; rewrite -[RHS](N_sum1 (fun d i => w d i x) kj).
by apply: eq_bigr => i _; rewrite (G_N t_mono w _ _ h).
Qed.

(* a sum over 0..n is the sum over j-k..j *)
Lemma sum_local (V : lmodType R) k n j x (u : nat -> V) : (k <= j <= n)%N -> t j <= x < t j.+1 ->
  \sum_(0 <= i < n.+1) G k i x *: u i = \sum_(j - k <= i < j.+1) G k i x *: u i.
Proof.
move=> /andP[kj jn] h.
rewrite (big_cat_nat _ (n := (j - k)%N)) //=; last lia.
rewrite (big_cat_nat _ (n := j.+1) (m := (j - k)%N)) //=; last lia.
rewrite big_nat_cond [X in X + _]big1; last first.
  move=> i hi; rewrite (G_N t_mono w _ _ h) N_supp ?scale0r //; lia.
rewrite add0r [X in _ + X]big_nat_cond [X in _ + X]big1 ?addr0 // => i hi.
rewrite (G_N t_mono w _ _ h) N_supp ?scale0r //; lia.
Qed.

(* T3.5.3: the same for any numbers as weights *)
Theorem T3_5_3 k n j x : (k <= j <= n)%N -> t j <= x < t j.+1 ->
  \sum_(0 <= i < n.+1) G k i x = \sum_(j - k <= i < j.+1) G k i x /\ \sum_(0 <= i < n.+1) G k i x = 1.
Proof.
move=> hj h; have := sum_local (fun _ : nat => (1 : R^o)) hj h.
rewrite (eq_bigr (fun i => G k i x)); last by move=> i _; rewrite /GRing.scale /= mulr1.
rewrite [in RHS](eq_bigr (fun i => G k i x)); last by move=> i _; rewrite /GRing.scale /= mulr1.
move=> ->; split => //; apply: T3_5_3_local => //; by case/andP: hj.
Qed.

(* the same without naming the span *)
Theorem T3_5_3_interval k n x : t k <= x < t n.+1 -> \sum_(0 <= i < n.+1) G k i x = 1.
Proof.
move=> h; have [s [h1 h2]] := span_exists t_mono h.
by have [] := @T3_5_3 k n s x _ h2; first lia.
Qed.

(* ---- sharpness: elsewhere the sum is < 1 ---- *)
Hypothesis w0 : w_left w t.
Hypothesis w01 : w_range w.
Hypothesis win : w_inside w t.

Lemma sum_step k n x : \sum_(0 <= i < n.+1) G k.+1 i x =
  \sum_(0 <= i < n.+2) G k i x - (1 - w k.+1 0 x) * G k 0 x - w k.+1 n.+1 x * G k n.+1 x.
Proof.
rewrite (eq_bigr (fun i => (G k i.+1 x - (w k.+1 i.+1 x * G k i.+1 x - w k.+1 i x * G k i x)))); last first.
  by move=> i _; rewrite GS; ring.
rewrite sumrB telescope_sumr // [in RHS]big_ltn // [in RHS]big_add1 /=; ring.
Qed.

Lemma sum_le1 k n x : \sum_(0 <= i < n.+1) G k i x <= 1.
Proof.
elim: k n => [|k IH] n; last first.
  rewrite sum_step; apply: le_trans (IH n.+1).
  have /andP[a1 a2] := w01 k.+1 0%N x; have /andP[b1 b2] := w01 k.+1 n.+1 x.
  rewrite -addrA ger_addl -opprD oppr_le0 addr_ge0 // mulr_ge0 ?T3_5_2_nonneg // subr_ge0 //.
case: (boolP (t 0%N <= x < t n.+1)) => h; last first.
  rewrite big_nat_cond big1 ?ler01 // => i hi; rewrite T3_5_1_outside //.
  apply: contra h => /andP[h1 h2]; rewrite (le_trans _ h1) ?tle //= (lt_le_trans h2) // tle //; lia.
by rewrite T3_5_3_interval.
Qed.

(* the sum is less than 1 on (t_0,t_k) and on (t_(n+1),t_m) *)
Theorem T3_5_3_sharp k n x : (0 < k)%N ->
  (t 0%N < x < t k) \/ (t n.+1 < x < t (n + k.+1)%N) -> \sum_(0 <= i < n.+1) G k i x < 1.
Proof.
case: k => // k _ h; rewrite sum_step.
have le := sum_le1 k n.+1 x.
have /andP[a1 a2] := w01 k.+1 0%N x; have /andP[b1 b2] := w01 k.+1 n.+1 x.
have p1 : 0 <= (1 - w k.+1 0 x) * G k 0 x by rewrite mulr_ge0 ?T3_5_2_nonneg // subr_ge0.
have p2 : 0 <= w k.+1 n.+1 x * G k n.+1 x by rewrite mulr_ge0 ?T3_5_2_nonneg.
apply: lt_le_trans le; rewrite -addrA gtr_addl -opprD oppr_lt0.
case: h => h.
  apply: ltr_paddr => //; apply: mulr_gt0; last exact: T3_5_2.
  by rewrite subr_gt0; have /andP[] : 0 < w k.+1 0 x < 1 by apply: win; rewrite add0n.
apply: ltr_paddl => //.
rewrite -addSnnS in h.
apply: mulr_gt0; first by have /andP[] := win h.
by apply: T3_5_2.
Qed.

(* ---- P4.1.3: coefficients of a convex combination ---- *)
Theorem P4_1_3 k n x : t k <= x < t n.+1 ->
  (forall i, 0 <= G k i x) /\ \sum_(0 <= i < n.+1) G k i x = 1.
Proof. by move=> h; split; [move=> i; apply: T3_5_2_nonneg|apply: T3_5_3_interval]. Qed.
End Basis.

(* ---- the paper's weight satisfies the hypotheses ---- *)
Section Paper.
Variable R : realFieldType.
Variable r : R.
Hypothesis r_gt0 : 0 < r.
Variable t : nat -> R.
Lemma wt_range : w_range (wt r t).
Proof. by move=> d i x; rewrite /wt; have /andP[-> /ltW ->] := phi_range r_gt0 x (t i) (t (i + d)%N). Qed.
Lemma wt_inside : w_inside (wt r t) t.
Proof.
move=> d i x /andP[h1 h2]; rewrite /wt phi_in ?(ltW h1) //.
by rewrite mob_gt0 ?mob_lt1 // ltW.
Qed.
Lemma wt_left : w_left (wt r t) t.
Proof. by move=> d i; rewrite /wt phi_a. Qed.
End Paper.

(* T3.5.1-3 for the paper's weight, in the paper's index *)
Section Alpha.
Variable R : realFieldType.
Variable al : R.
Hypothesis al_ok : al < 0 \/ 1 < al.
Variable t : nat -> R.
Hypothesis t_mono : forall i, t i <= t i.+1.
Let r := al / (al - 1).
Let r0 : 0 < r := D2_3_r_gt0 al_ok.
Local Notation G := (G (wt_alpha al t) t).
Lemma G_alpha k i x : G k i x = Definitions.G (wt r t) t k i x.
Proof. by apply: eq_G => d j; rewrite /wt_alpha /wt D2_3. Qed.
(* T3.5.1 in the paper's index *)
Theorem T3_5_1_alpha k i x : ~~ (t i < x < t (i + k.+1)%N) ->
  ~ (x = t i /\ t i = t (i + k)%N /\ t (i + k)%N < t (i + k.+1)%N) -> G k i x = 0.
Proof. by rewrite G_alpha; apply: T3_5_1 => //; apply: wt_left. Qed.
(* T3.5.2 in the paper's index *)
Theorem T3_5_2_alpha k i x : t i < x < t (i + k.+1)%N -> 0 < G k i x.
Proof. by rewrite G_alpha; apply: T3_5_2 => //; [apply: wt_left|apply: wt_range|apply: wt_inside]. Qed.
(* T3.5.3 in the paper's index *)
Theorem T3_5_3_alpha k n j x : (k <= j <= n)%N -> t j <= x < t j.+1 ->
  \sum_(0 <= i < n.+1) G k i x = \sum_(j - k <= i < j.+1) G k i x /\ \sum_(0 <= i < n.+1) G k i x = 1.
Proof. exact: T3_5_3. Qed.
End Alpha.

(* T3.5.3 as printed (every j) is false for every degree k >= 1, every r > 0: knots 0,1,2,..., x = 1/2, n >= k *)
Theorem T3_5_3_printed_false (R : realFieldType) (r : R) k n : 0 < r -> (0 < k)%N -> (k <= n)%N ->
  exists t : nat -> R, (forall i, t i < t i.+1) /\ (exists x, t 0%N <= x < t 1%N /\
    \sum_(0 <= i < n.+1) G (wt r t) t k i x < 1).
Proof.
move=> r0 k0 kn; exists (fun i => i%:R); split; first by move=> i; rewrite ltr_nat.
have mono i : (i%:R : R) <= i.+1%:R by rewrite ler_nat.
exists (2%:R^-1); have h1 : 0 < (2%:R : R)^-1 by rewrite invr_gt0 ltr0n.
have h2 : (2%:R : R)^-1 < 1 by rewrite invf_lt1 ?ltr0n // ltr1n.
split; first by rewrite ltW.
apply: T3_5_3_sharp => //; first exact: wt_left.
- exact: wt_range.
- exact: wt_inside.
by left; rewrite h1 /= (lt_le_trans h2) // ler1n.
Qed.
